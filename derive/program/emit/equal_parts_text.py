"""Text for parts that are alike: tables by comprehensions, and functions that call those of one part."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any

from hertzwerk.derive.program.emit.printer import repeats
from hertzwerk.derive.program.program import Program, Repeated

_NUMBER = re.compile(r"(\d+)")
_LEAST = 4  # rows that a comprehension stands for
_PERIOD = 24  # most rows of a table for one member
_EXCEPTED = 12  # members that a comprehension leaves out by name
_WIDTH = 130  # columns of the rows of one member

Literal = Callable[[Any], str]


_FAMILIES = """tuple(
    (family, tuple((name, _rows(0, trees), _rows(1, trees), _of_member(k, of_z), _of_member(k, of_m))
                   for k, (name, *trees) in enumerate(members)))
    for family, members, of_z, of_m in (
        {families},
    )
)"""


def kind_tables(program: Program, literal: Literal) -> Iterator[tuple[str, str]]:
    """Yield names and texts of the tables of kinds: their members, and rows in the whole vectors."""
    for kind, name in _named_kinds(program):
        yield name, _members(kind, literal)
    yield "TREES", f"({', '.join(map(_tree_rows, program.trees))},)"
    families = (
        f"({literal(kind.name)}, {name}, {_row_text(kind.rows['z'])}, {_row_text(kind.rows['m'])})"
        for kind, name in _named_kinds(program)
        if kind in program.pairs
    )
    yield "FAMILIES", _FAMILIES.format(families=",\n        ".join(families))


def _named_kinds(program: Program) -> list[tuple[Repeated, str]]:
    """Kinds of trees, then of pairs, each with the name of its table of members."""
    both = ((program.trees, "TREES"), (program.pairs, "PAIRS"))
    return [(kind, f"{kind.name.upper()}_{of}") for kinds, of in both for kind in kinds]


def _tree_rows(kind: Repeated) -> str:
    """Comprehension of the rows of a kind's trees in q and in u."""
    parts = []
    for part in "qu":
        size = len(kind.rows[part])
        first = kind.rows[part][0][0] if size else 0
        parts.append(f"[*range({_sum(f'{size}*k', first)}, {_sum(f'{size}*k', first + size)})]")
    return f"*(({', '.join(parts)}) for k in range({len(kind.members)}))"


def _row_text(entries: Sequence[Sequence[int]]) -> str:
    """Tuple of the rows of each entry, which are ranges where they count."""
    texts = []
    for rows in entries:
        parts: list[str] = []
        done = 0
        while done < len(rows):
            text, count = _counted(rows[done:]) or (str(rows[done]), 1)
            parts.append(text)
            done += count
        alone = len(parts) == 1 and parts[0].startswith("*")
        texts.append(parts[0][1:] if alone else f"({', '.join(parts)},)")
    return f"({', '.join(texts)}{',' * (len(texts) == 1)})"


def _members(kind: Repeated, literal: Literal) -> str:
    """Names and trees of the members of a kind, by a comprehension where their names count."""
    names, trees = [member[0] for member in kind.members], [member[1:] for member in kind.members]
    first, last = min(tree for of in trees for tree in of), max(tree for of in trees for tree in of) + 1
    here, within = set(trees), range(first, last)
    loops = (
        ("i", f"for i in range({first}, {last})", [(i,) for i in within]),
        ("i, i + 1", f"for i in range({first}, {last - 1})", [(i, i + 1) for i in within[:-1]]),
        ("i, j", f"for i in range({first}, {last}) for j in range(i + 1, {last})", [*combinations(within, 2)]),
    )
    for variables, loop, indices in loops:
        left = [of for of in indices if of not in here]
        if len(left) <= _EXCEPTED and [of for of in indices if of in here] == trees and len(names) >= _LEAST:
            values = {"i": [of[0] for of in trees], **({"j": [of[-1] for of in trees]} if "j" in variables else {})}
            name = _text(names, values, literal)
            if name is not None:
                but = f" if ({variables}) not in {literal(tuple(left))}" if left else ""
                return f"tuple(({name}, {variables}) {loop}{but})".replace("range(0, ", "range(")
    return "(\n" + "".join(f"    {literal(member)},\n" for member in kind.members) + ")"


def table(program: Program, rows: Sequence[Any], literal: Literal) -> list[str]:
    """Texts of a table's rows, of which a comprehension stands for those of a kind."""
    texts: list[str] = []
    i = 0
    while i < len(rows):
        run = repeats(rows, i, 1)
        if run > _LEAST:
            best = f"*[{literal(rows[i])}]*{run}", run
        else:
            runs = (_comprehension(kind, name, rows[i:], literal) for kind, name in _named_kinds(program))
            known = [each for each in (_counted(rows[i:]), *runs) if each is not None]
            best = max(known, key=lambda each: (each[1], -len(each[0])), default=(literal(rows[i]), 1))
        texts.append(best[0])
        i += best[1]
    return texts


def _counted(rows: Sequence[Any]) -> tuple[str, int] | None:
    """Range of the numbers that begin a table, and how many they are."""
    if len(rows) <= _LEAST or not all(isinstance(row, int) for row in rows) or rows[1] == rows[0]:
        return None
    step = rows[1] - rows[0]
    count = next((k for k, row in enumerate(rows) if row != rows[0] + k * step), len(rows))
    end = f"{rows[0]}, {rows[0] + count * step}" + (f", {step}" if step != 1 else "")
    return (f"*range({end.removeprefix('0, ') if step == 1 else end})", count) if count > _LEAST else None


def _comprehension(kind: Repeated, name: str, rows: Sequence[Any], literal: Literal) -> tuple[str, int] | None:
    """Text for the rows of a kind that begin a table, and their number."""
    count = len(kind.members)
    if count < _LEAST or isinstance(rows[0], int):
        return None
    values: dict[str, list[Any]] = {"name": [member[0] for member in kind.members]}
    values |= {
        letter: [member[1 + k] for member in kind.members] for k, letter in enumerate("ij"[: len(kind.members[0]) - 1])
    }
    values["k"] = [*range(count)]
    few = {letter: [of[0], of[1], of[-1]] for letter, of in values.items()}
    for period in range(1, min(_PERIOD, len(rows) // count) + 1):
        columns = [rows[k : count * period : period] for k in range(period)]
        if any(_template([column[0], column[1], column[-1]], few, literal) is None for column in columns):
            continue
        templates = [_template(column, values, literal) for column in columns]
        texts = [text for text in templates if text is not None]
        if len(texts) < period:
            continue
        variables = ", ".join(letter for letter in values if letter != "k")
        counted = any(re.search(r"\bk\b", text) for text in texts)
        loop = f"k, ({variables}) in enumerate({name})" if counted else f"{variables} in {name}"
        if period == 1:
            return f"*({texts[0]} for {loop})", count
        lines = [""]
        for text in texts:
            if len(lines[-1]) + len(text) > _WIDTH:
                lines.append("")
            lines[-1] += f"{text}, "
        packed = "\n        ".join(line.rstrip() for line in ("", *lines))
        return f"*(row for {loop} for row in ({packed}\n    ))", count * period
    return None


def _template(column: Sequence[Any], values: Mapping[str, Sequence[Any]], literal: Literal) -> str | None:
    """Text of an expression of a loop's variables whose values are a column; None where there is none."""
    first = column[0]
    if any(type(row) is not type(first) for row in column):
        return None
    if isinstance(first, tuple):
        if any(len(row) != len(first) for row in column):
            return None
        parts = [_template([row[k] for row in column], values, literal) for k in range(len(first))]
        texts = [part for part in parts if part is not None]
        return f"({', '.join(texts)}{',' * (len(first) == 1)})" if len(texts) == len(parts) else None
    if all(value == first for value in column):
        return literal(first)
    if isinstance(first, str):
        return _text(column, values, literal)
    if isinstance(first, int):
        return _count(column, values)
    return None


def _text(column: Sequence[str], values: Mapping[str, Sequence[Any]], literal: Literal) -> str | None:
    """Format string of a column of texts: a name in it, or numbers that count."""
    first = column[0]
    names = values.get("name")
    if names is not None and names[0] in first:
        before, _, after = first.partition(names[0])
        if all(text == f"{before}{name}{after}" for text, name in zip(column, names, strict=True)):
            return "name" if first == names[0] else "f" + literal(_braced(before) + "{name}" + _braced(after))
    split = [_NUMBER.split(text) for text in column]
    if any(len(parts) != len(split[0]) for parts in split):
        return None
    whole = ""
    for k, part in enumerate(split[0]):
        texts = [parts[k] for parts in split]
        if all(text == part for text in texts):
            whole += _braced(part)
            continue
        if k % 2 == 0 or any(str(int(text)) != text for text in texts):
            return None
        count = _count([int(text) for text in texts], {letter: of for letter, of in values.items() if letter != "name"})
        if count is None:
            return None
        whole += f"{{{count}}}"
    return "f" + literal(whole)


def _count(column: Sequence[int], values: Mapping[str, Sequence[Any]]) -> str | None:
    """Expression of a loop's variable whose values are a column of numbers."""
    for letter, of in values.items():
        if letter != "name" and all(
            value - start == column[0] - of[0] for value, start in zip(column, of, strict=True)
        ):
            return _sum(letter, column[0] - of[0])
    step = column[1] - column[0]
    if "k" in values and all(value == column[0] + k * step for k, value in enumerate(column)):
        return _sum(f"{step}*k", column[0])
    return None


def _sum(text: str, number: int) -> str:
    return text if number == 0 else f"{text} + {number}" if number > 0 else f"{text} - {-number}"


def _braced(text: str) -> str:
    return text.replace("{", "{{").replace("}", "}}")


_PIECES = '''def _rows(part, trees):
    """Rows of trees in q (part 0) or in u (part 1)."""
    return [row for tree in trees for row in TREES[tree][part]]


def _of_member(k, rows):
    """Rows of the member at place k in z or in m."""
    return [row[k] for row in rows]'''

_LOOPS = '''def _of_trees(name, t, q, c, *of_speeds):
    """What a function of one tree returns for each; `of_speeds` are arguments with an entry for each speed."""
    kinds = {kinds}
    return [globals()[f"{{name}}_of_{{kind}}"](t, q[of_q], *(x[of_u] for x in of_speeds), c)
            for (of_q, of_u), kind in zip(TREES, (kind for kind, members in kinds for _ in members), strict=True)]


def _of_pairs(name, t, q, c, *of_speeds):
    """What a function of one pair returns for each; `of_speeds` are arguments with an entry for each speed."""
    return [globals()[f"{{name}}_of_{{family}}"](t, q[of_q], *(x[of_u] for x in of_speeds), c)
            for family, members in FAMILIES for _, of_q, of_u, *_ in members]


def _spread(x, rows, count, times=1):
    """Vector of zeros but for some rows, a number of times."""
    whole = type(x)(times*count, 1)
    whole[[k*count + row for k in range(times) for row in rows]] = x
    return whole


def _contact(family, of_q, of_u, of_z, of_m):
    """Function of the forces of one pair, of the whole vectors."""
    def contact(t, q, u, z, m, c):
        found = [*globals()[f"contact_of_{{family}}"](t, q[of_q], u[of_u], z[of_z], m[of_m], c)]
        found[:2] = _spread(found[0], of_u, u.numel()), _spread(found[1], of_z, z.numel())
        if len(found) > 5:  # along and dz_along of friction with modes
            times = found[5].numel()//len(of_u)
            found[5:7] = _spread(found[5], of_u, u.numel(), times), _spread(found[6], of_z, z.numel(), times)
        return tuple(found)
    return contact


globals().update({{f"contact_{{name}}": _contact(family, *rows) for family, members in FAMILIES for name, *rows in members}})


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("coordinate_rates", t, q, c, u))


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    G, dG = zip(*_of_pairs("gaps", t, q, c, u), strict=True)
    return ca.vertcat(*G), ca.vertcat(*dG)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    """
    return ca.vertcat(*_of_pairs("gap_accelerations", t, q, c, u, a))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("applied", t, q, c, u))


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives, of which there are none.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("accelerations", t, q, c, u, f)), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    """
    positions, rotations = zip(*_of_trees("poses", t, q, c), strict=True)
    return ca.vertcat(*positions), ca.vertcat(*rotations)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_pairs("outputs", t, q, c, u))'''

_ENERGY = '''def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    kinetic, potential = zip(*_of_trees("energy", t, q, c, u), strict=True)
    return sum(kinetic), sum(potential), ca.vertcat(*_of_pairs("stored_energy", t, q, c, u))'''


def loops(program: Program) -> tuple[str, str]:
    """Text that stands before the tables of kinds, and that of the functions of whole vectors."""
    kinds = ", ".join(f'("{kind.name}", {name})' for kind, name in _named_kinds(program) if kind in program.trees)
    text = _LOOPS.format(kinds=f"({kinds},)")
    return _PIECES, text + (f"\n\n\n{_ENERGY}" if program.scene.ledger else "")
