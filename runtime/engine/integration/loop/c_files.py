"""Division of the C text of CasADi functions into files, functions and loops that compile fast.

A compiler takes a time, and a memory, that grow with the square of a function's length, every condition costs it a
branch, and a loop as much as 130 characters. What is compiled gives the same bits.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from hertzwerk.runtime.engine.integration.loop.attempt import FINISH

# Characters of a function beyond which it is made of parts, and of a part. At 90,000 an implicit step in two parts takes a sixth longer and compiles
# no faster; one of 470,000 takes 4 % longer and compiles in half the time.
LONG, PART = 180_000, 60_000
FILE = 300_000  # characters of a file: its compiler takes up to 250 MB
BESIDE = (
    6_000  # characters of a function up to which it stays in the file of those that call it, where it may be inlined
)
# Level by how often a function runs. Steps with events run no faster by -O3, nor do loops around functions of scalars: with those at -O1, whatever
# their length, ball_bearing compiles in 0.78 of the time, spheres_in_box in 0.64, and runs take 0.96 to 1.01 of theirs. Loops that functions of
# scalars call stay at -O3: gears_with_backlash takes 1.04 times as long without.
OFTEN, SELDOM = "-O3", "-O1"
# characters of what an exported function needs, up to which -O3 is worth its compilation; 10 pairs: 660,000, 1.5 times as fast as with -O1
LARGE = 900_000
# conditions of a function beyond which each is a mask of bits, not a branch: ball_bearing's `decide`, of 819, compiles in half the time
CHOICES = 60
NESTED = 200  # characters of a value up to which it is written where it is read; compilers limit the depth of brackets
EXPORTED = ""  # stands for the functions that a library shows, which call the others

_ARGUMENTS = "(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem)"
_HEAD = r"^(?:/\* (?P<said>\w+):.* \*/\n)?"
_STATEMENT = r"  a\d+=.*;\n|  if \(res\[\d+\]!=0\) res\[\d+\]\[\d+\]=.*;\n"
_PLAIN = re.compile(
    rf"^static int (casadi_f\d+){re.escape(_ARGUMENTS)} \{{\n(?:  casadi_real a.*;\n)+((?:{_STATEMENT})+)  return 0;\n\}}\n",
    re.MULTILINE,
)
_FUNCTION = re.compile(
    _HEAD + r"static (?P<head>.*\b(?P<name>casadi_f\d\w*)\(.*\)) \{\n(?P<body>(?:.*\n)*?)\}\n", re.MULTILINE
)
_HELPER = re.compile(r"^((?:casadi_real|casadi_int|void) casadi_\w+\()", re.MULTILINE)
_EXPORTED = re.compile(r"^CASADI_SYMBOL_EXPORT .*\{(?:.*\}|\n(?:.*\n)*?\})\n", re.MULTILINE)
_CHOICE = re.compile(r"\((a\d+)\?(a\d+):0\)")
_CHOSEN = """typedef double casadi_two __attribute__((vector_size(16)));
typedef long long casadi_mask __attribute__((vector_size(16)));
static inline double casadi_chosen(double condition, double x) {
  casadi_mask holds = (casadi_two){condition, 0} != 0;
  return ((casadi_two)(holds & (casadi_mask)(casadi_two){x, 0}))[0];
}
"""
_LOOP = """{head} {{
  const casadi_real *state = arg[0], *tally = arg[2], *before[2] = {{arg[0], arg[2]}};
  casadi_real *states = res[0], *counted = res[1], *after[2] = {{res[0], res[1]}}, kept[2][{counted} + 1];
  int i, j, failed = 0;
  for (i = 0; i < {columns} && !failed && state[{status}] == 0; ++i, states += {rows}) {{
    arg[0] = state, arg[2] = tally, res[0] = states, res[1] = kept[i % 2];
    failed = {attempt}(arg, res, iw, w, mem);
    state = states, tally = kept[i % 2];
  }}
  res[0] = after[0], res[0][({columns} - 1) * {rows} + {status}] = state[{status}];
  for (j = 0; j < {counted}; ++j) counted[j] = tally[j];
  arg[0] = before[0], arg[2] = before[1], res[1] = after[1];
  return failed;
}}"""
_ARGUMENT = re.compile(r"arg\[(\d+)\]\? arg\[\1\]\[(\d+)\] : 0")
_RESULT = re.compile(r"if \(res\[(\d+)\]!=0\) res\[\1\]\[(\d+)\]=")
_VARIABLE = re.compile(r"\ba\d+\b")
_REPEATED = re.compile(r"\b(?:EACH|for) \(")
_CALLED = re.compile(r"\bcasadi_f\d\w*\b")

_VECTORS = re.compile(r"(?<= \{\n)  casadi_int i.*;\n(?:.+\n)*?(?=\}\n)")
_DECLARED = re.compile(r"(  (?:const )?casadi_(?:real|int)\*?) (.*);\n")
_EACH = re.compile(
    r"  for \(i=0, rr=(w\d+)(?:, cr=([\w+]+))?(?:, cs=([\w+]+))?; i<(\d+); \+\+i\) \(?\*rr\+\+\)? +([-+*/]?)= ?(.*);\n"
)
_COPY = re.compile(r"  casadi_copy\((\w+), (\d+), (w\d+)\);\n")
_VALUE = re.compile(r"  (wr?\d+) +([-+*/]?)= (.*);\n")
_RETURNED = re.compile(r"  res\d*\[\d+\]=(w\d+);\n")
_NAMED = re.compile(r"\bwr?\d+\b")
_NUMBER = re.compile(r"-?\d[\d.e+-]*")


@dataclass(frozen=True)
class CFile:
    """C text of one file, and the level of optimisation that it is worth."""

    text: str
    level: str


def c_files(text: str) -> list[CFile]:
    """Return what CasADi generated as files, the first with what is exported."""
    text = _CHOSEN + _PLAIN.sub(_straight, text)
    functions = {match["name"]: match for match in _FUNCTION.finditer(text)}
    calls = {name: set(_CALLED.findall(match["body"])) & functions.keys() for name, match in functions.items()}
    finishing = {name for name, match in functions.items() if match["said"] == FINISH}
    if not functions:
        return [CFile(text, OFTEN)]
    exported = [set(_CALLED.findall(match[0])) & functions.keys() for match in _EXPORTED.finditer(text)]
    calls[EXPORTED] = set().union(*exported)
    often: set[str] = set()
    for entry in exported:
        if sum(len(functions[name][0]) for name in _reached(entry, calls, set())) <= LARGE:
            often |= _reached(entry, calls, finishing)
    of_scalars = (calls[name] for name in often if _VARIABLE.search(functions[name]["body"]))
    loops = {name for name, match in functions.items() if _REPEATED.search(match["body"])}
    loops -= _reached(set().union(*of_scalars), calls, set())
    often -= loops
    large = [name for name, match in functions.items() if name in loops or len(match[0]) > BESIDE]
    moved = [
        *((OFTEN, names) for names in _shares([name for name in large if name in often], functions)[1:]),
        *((SELDOM, names) for names in _shares([name for name in large if name not in often], functions)),
    ]
    return _apart(text, functions, calls, OFTEN if often else SELDOM, moved)


def looped(text: str, chunk: Any) -> str:
    """Return the text of `chunk.one`, an attempt, with a loop that gives what the chunk gives.

    It ends with the run, whose status its last column has. What each returns is its column; nothing is copied but what is counted.
    """
    name, (rows, columns), counted = chunk.name(), chunk.size_out(0), chunk.numel_out(1)
    call = rf"(int {name}{re.escape(_ARGUMENTS)})\{{\n  return (\w+)\(.*\n}}"
    numbers = {"rows": rows, "columns": columns, "counted": counted, "status": chunk.status}
    text = re.sub(call, lambda match: _LOOP.format(head=match[1], attempt=match[2], **numbers), text)
    pattern = f"{{ static const casadi_int states[3] = {{{rows}, {columns}, 1}}; return states; }}"
    return re.sub(rf"({name}_sparsity_out\(.*\n.*\n    case 0: )return \w+;", rf"\1{pattern}", text)


def _reached(names: set[str], calls: dict[str, set[str]], last: set[str]) -> set[str]:
    """Return the functions called by some, and by those in turn; of the last ones nothing further."""
    reached, new = set(names), names
    while new:
        new = {other for name in new - last for other in calls[name]} - reached
        reached |= new
    return reached


def _shares(names: list[str], functions: dict[str, re.Match[str]]) -> list[list[str]]:
    """Return functions as shares of one file each, of about the same length, in their order."""
    lengths = [len(functions[name][0]) for name in names]
    count = math.ceil(sum(lengths) / FILE)
    shares: list[list[str]] = [[] for _ in range(count)]
    before = 0
    for name, length in zip(names, lengths, strict=True):
        shares[min(count - 1, int((before + length / 2) * count / sum(lengths)))].append(name)
        before += length
    return shares


def _apart(
    text: str,
    functions: dict[str, re.Match[str]],
    calls: dict[str, set[str]],
    first_level: str,
    moved: list[tuple[str, list[str]]],
) -> list[CFile]:
    """Return a text and, in files of their own, the functions moved out of it."""
    if not moved:
        return [CFile(text, first_level)]
    home = {name: i for i, (_, names) in enumerate(moved, 1) for name in names}
    shared = {other for name in calls for other in calls[name] if home.get(other, 0) != home.get(name, 0)}
    heads = "".join(f"{functions[name]['head']};\n" for name in functions if name in shared)
    first = next(iter(functions.values())).start()
    common = _HELPER.sub(r"static inline \1", text[:first])

    def own(match: re.Match[str]) -> str:
        return match[0].replace("static ", "", 1) if match["name"] in shared else match[0]

    first_file = _FUNCTION.sub(lambda match: "" if match["name"] in home else own(match), text[first:])
    others = ("\n".join(own(functions[name]) for name in names) for _, names in moved)
    levels = first_level, *(level for level, _ in moved)
    bodies = (first_file, *others)
    alone = _EXPORTED.sub("", common)
    before = (common, *[alone] * len(moved))
    return [CFile(head + heads + body, level) for head, body, level in zip(before, bodies, levels, strict=True)]


# -- functions of scalars ----------------------------------------------------------------------------------------------


def _straight(function: re.Match[str]) -> str:
    """Return a function with few branches, which calls parts if it is long."""
    name, body = function.groups()
    if len(_CHOICE.findall(body)) > CHOICES:
        body = _CHOICE.sub(r"casadi_chosen(\1, \2)", body)
    body = _nested(_RESULT.sub(r"y\1[\2]=", _ARGUMENT.sub(r"x\1[\2]", body)))
    head = f"static int {name}{_ARGUMENTS} {{\n"
    if len(body) <= LONG:
        return f"{head}{_declared(body)}{body}  return 0;\n}}\n"
    parts, size = _parts(body)
    parameters = "const casadi_real** arg, casadi_real** res, casadi_real* v"
    made = "".join(
        f"static __attribute__((noinline)) void {name}_{i}({parameters}) {{\n{_declared(part)}{part}}}\n\n"
        for i, part in enumerate(parts)
    )
    calls = "".join(f"  {name}_{i}(arg, res, v);\n" for i in range(len(parts)))
    return f"{made}{head}  casadi_real v[{size}];\n{calls}  return 0;\n}}\n"


def _nested(body: str) -> str:
    """Return statements with each value that one other reads written there.

    Not written there is a value that a condition may leave out, as a branch costs more.
    CasADi writes a statement for each operation, in twice the characters.
    """
    rows = _named([line[2:-1].split("=", 1) for line in body.splitlines()], again=False)
    reads = Counter(name for _, value in rows for name in _VARIABLE.findall(value) + re.findall(r"\?(a\d+)", value))
    values, statements = dict[str, str](), []
    for target, value in rows:
        value = _VARIABLE.sub(lambda match: values.get(match[0], match[0]), value)
        if reads[target] == 1 and len(value) < NESTED:
            values[target] = value if value[-1] == ")" else f"({value})"
        else:
            statements.append([target, value])
    return "".join(f"  {target}={value};\n" for target, value in _named(statements, again=True))


def _named(rows: list[list[str]], *, again: bool) -> list[list[str]]:
    """Return statements, each a target and its value, with a name for each value.

    again: whether a name is used again after the last reader of its value
    """
    free, made = [f"a{i}" for i in reversed(range(len(rows)))], []
    names: dict[str, str] = defaultdict(free.pop)
    for target, value in reversed(rows):
        name = names.pop(target, target)  # results keep theirs
        free += [name] * (again and name[0] == "a")
        made.append([name, _VARIABLE.sub(lambda match: names[match[0]], value)])
    return made[::-1]


def _declared(body: str) -> str:
    """Return the declarations of a body; absent arguments read as 0, absent results are discarded."""
    sizes: dict[str, int] = {}
    for vector, place in re.findall(r"\b([xy]\d+)\[(\d+)\]", body):
        sizes[vector] = max(sizes.get(vector, 0), int(place) + 1)
    lines = [f"  casadi_real {', '.join(_variables(_VARIABLE.findall(body)))};\n"]
    for vector, size in sizes.items():
        constant, initial, array = ("const ", " = {0}", "arg") if vector[0] == "x" else ("", "", "res")
        where = f"{array}[{vector[1:]}]"
        lines.append(f"  {'static ' if constant else ''}{constant}casadi_real none_{vector}[{size}]{initial};\n")
        lines.append(f"  {constant}casadi_real* {vector} = {where} ? {where} : none_{vector};\n")
    return "".join(lines)


def _parts(body: str) -> tuple[list[str], int]:
    """Return the statements in parts of equal length, which hand variables on in an array v, and its size."""
    lines = body.splitlines(keepends=True)
    each = math.ceil(len(lines) / math.ceil(len(body) / PART))
    needed: set[str] = set()  # by what follows
    parts, size = [], 0
    for begin in reversed(range(0, len(lines), each)):
        piece = lines[begin : begin + each]
        read: set[str] = set()
        written: set[str] = set()
        for line in piece:
            names = _VARIABLE.findall(line)
            target = names[:1] if line.startswith("  a") else []
            read.update(name for name in names[len(target) :] if name not in written)
            written.update(target)
        taken = "".join(f"  {name}=v[{int(name[1:])}];\n" for name in _variables(read))
        saved = "".join(f"  v[{int(name[1:])}]={name};\n" for name in _variables(written & needed))
        size = max([size, *(int(name[1:]) + 1 for name in read)])
        needed = read | (needed - written)
        parts.append(taken + "".join(piece) + saved)
    return parts[::-1], size


def _variables(names: Iterable[str]) -> list[str]:
    return sorted(set(names), key=lambda name: int(name[1:]))


# -- functions of vectors ----------------------------------------------------------------------------------------------


@dataclass(eq=False)
class _Line:
    """Line of a function of vectors; the target that it gives a value, and that value or its entry i."""

    text: str
    target: str = ""
    value: str = ""  # "" where a call returns it
    entries: int = 0  # 0 of a scalar
    names: list[str] = field(init=False)
    """Names of variables that it reads; without a target all of the line."""

    def __post_init__(self) -> None:
        self.names = _NAMED.findall(self.value if self.target else self.text)

    def changes(self, names: Iterable[str]) -> bool:
        """Return whether it may change the value of one of these variables; the end of a block may."""
        return self.target in names if self.target else not {"{", "}", *names}.isdisjoint([*self.text, *self.names])

    def give(self, value: str) -> None:
        """Give the target this value."""
        self.value, (loop, place) = value, (f"EACH (i=0; i<{self.entries}; ++i) ", "[i]") if self.entries else ("", "")
        self.text, self.names = f"  {loop}{self.target}{place}={value};\n", _NAMED.findall(value)


def fused(text: str) -> str:
    """Return C text with one loop for each chain of operations on vectors.

    CasADi writes a loop for each operation. One that computes a vector for one other loop is written there, and numbers where they are used.
    """
    return _VECTORS.sub(_fused, text)


def _fused(body: re.Match[str]) -> str:
    lines = [_line(text) for text in body[0].splitlines(keepends=True)]
    for i, line in enumerate(lines):
        after = lines[i + 1 :] if line.value else []
        end = next((k for k, other in enumerate(after, 1) if other.target == line.target), len(after))
        readers = [other for other in after[:end] if line.target in other.names]
        entry, names = line.target, {*line.names}
        fuses = not line.entries and all(reader.value for reader in readers) and bool(_NUMBER.fullmatch(line.value))
        if line.entries and len(readers) == 1:
            entry, (reader,) = f"{line.target}[i]", readers
            fuses = (
                reader.entries == line.entries
                and reader.names.count(line.target) == reader.value.count(entry) == 1
                and not any(other.changes(names) for other in after[: after.index(reader)])
            )
        if fuses:
            value = f"({line.value})" if line.value[0] == "-" else line.value
            for reader in readers:
                reader.give(re.sub(rf"\b{re.escape(entry)}(?!\w)", value, reader.value))
            lines[i] = _Line("")
    text = "".join(line.text for line in lines)
    count = Counter(re.findall(r"\w+", text))

    def declared(line: re.Match[str]) -> str:
        variables = [each for each in line[2].split(", ") if count[re.split(r"\W+", each.lstrip("*"))[0]] > 1]
        return f"{line[1]} {', '.join(variables)};\n" if variables else ""

    return _DECLARED.sub(declared, text)


def _line(text: str) -> _Line:
    """Return a line of C, as CasADi writes it."""
    if match := _EACH.fullmatch(text):
        target, *operands, entries, operation, value = match.groups()
        for pointer, operand in zip(("cr", "cs"), operands, strict=True):
            name, plus, offset = (operand or "").partition("+")
            value = re.sub(
                rf"\(\*{pointer}\+\+\)| ?\*{pointer}\+\+ ?|{pointer}\[i\]", f"{name}[i{plus}{offset}]", value
            )
        line = _Line(text, target, entries=int(entries))
        line.give(f"({target}[i]{operation}{value})" if operation else value)
        return line
    if match := _COPY.fullmatch(text):
        return _Line(text, match[3], f"{match[1]}[i]", int(match[2]))
    if match := _VALUE.fullmatch(text):
        target, operation, value = match.groups()
        return _Line(text, target, f"({target}{operation}{value})" if operation else value)
    match = _RETURNED.fullmatch(text)
    return _Line(text, match[1] if match else "")
