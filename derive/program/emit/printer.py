"""Text of a program's functions: one builder over CasADi each, with its docstring."""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import visible
from hertzwerk.derive.program.expression_text import curve_names, expression_text
from hertzwerk.derive.program.naming import names_in_words
from hertzwerk.derive.program.program import Function, Program, Result, eliminate_common_subexpressions
from hertzwerk.derive.program.repetition import Block, Shared, Step, step_of

WIDTH = 140  # columns of the text, but for assignments, of which each is a line
_RUN = 4  # equal entries, or groups of them, after one another that are written out
_GROUP = 16  # most entries of such a group
_NAME = re.compile(r"[^\W\d]\w*")
_CASADI = re.compile(r"\bca\.")

_TABLES = ("COORDINATES", "SPEEDS", "MEMORY", "PAIRS", "OUTPUTS", "CONSTRAINTS")
"""Tables whose rows are entries of a vector, a name and its unit first."""
_ARGUMENTS = {
    "t": "t [s]",
    "p": "p: PARAMETERS, in SI",
    "q": "q: COORDINATES",
    "u": "u: SPEEDS",
    "a": "a: rates of the speeds",
    "z": "z: MEMORY",
    "m": "m: LATCHES",
    "c": "c: CONSTANTS",
    "f": "f: generalised forces",
    "reactions": "reactions of the drives",
    "wanted": "wanted: rates of CONSTRAINTS",
    "multipliers": "multipliers: forces that hold CONSTRAINTS",
    "friction": "friction: force of each pair of SLIPS along its tangent",
    "touching": "touching: forces and points of the contacts",
    "joints": "joints: JOINT_COORDINATES",
    "joint_speeds": "joint_speeds: JOINT_SPEEDS",
}

_OF_PARTS = {
    "q": "q: own entries of COORDINATES",
    "u": "u: own entries of SPEEDS",
    "a": "a: rates of these",
    "z": "z: own entries of MEMORY",
    "m": "m: own entries of LATCHES",
    "f": "f: own generalised forces",
}
"""Arguments of a function of one tree or pair."""


@dataclass(frozen=True)
class Draft:
    """A builder about to be printed: its function with shared subexpressions, its code, its columns."""

    function: Function
    block: Block
    columns: tuple[str, ...]


def draft(program: Program, function: Function, *, whole: bool = False) -> Draft:
    """Code of one builder, every name as printed; the results of a `whole` one belong together."""
    inputs = _places(program, function)
    function = eliminate_common_subexpressions(function)
    names = _names(program, function)
    made = [(names.get(symbol.name, symbol.name), _renamed(expression_text(e), names)) for symbol, e in function.body]
    known = {*inputs, program.tape.own("t"), *(name for name, _ in made)}
    texts = [[_renamed(expression_text(e), names) for e in result.expressions] for result in function.results]
    entries = [
        (function.name if whole else _owner(program, result, label), [name for name in _NAME.findall(text) if name in known])
        for result, column in zip(function.results, texts, strict=True)
        for label, text in zip(result.labels, column, strict=True)
    ]  # fmt: skip
    arguments = tuple(map(program.tape.own, function.arguments))
    block = Block(function.name, arguments, [step_of(name, text, known) for name, text in made], entries, inputs)
    return Draft(function, block, tuple(map(_column, texts)))


def _owner(program: Program, result: Result, label: str) -> str:
    """The part of the scene that an entry of a result belongs to."""
    owners = [name.partition(".")[0] for name in (label, result.name)]
    return next((owner for owner in owners if owner in program.parts), owners[0])


def function_text(program: Program, function: Function) -> str:
    """Text of one builder by itself."""
    return builder_text(program, draft(program, function))


def builder_text(program: Program, drafted: Draft, like: Function | None = None) -> str:
    """Text of a builder; `like` is one before it with the same arguments and returns."""
    function, block, own = drafted.function, drafted.block, program.tape.own
    read = Counter(name for step in block.steps for name in step.operands if step.callee)
    read.update(2 * [name for step in block.steps if step.callee is None for name in step.operands])
    read.update(2 * [name for _, names in block.results for name in names])
    unread = {name: "_" for step in block.steps if len(step.targets) > 1 for name in step.targets if not read[name]}
    names = {name: place for name, place in block.inputs.items() if read[name] == 1} | _short_names(block) | unread
    unpacked = [(name, place) for name, place in block.inputs.items() if read[name] > 1]
    lines = [f"def {function.name}({', '.join(map(own, function.arguments))}):", *_docstring(program, function, like)]
    lines += [*_unpacking(unpacked), *_step_lines(block.steps, names)]
    lines += _return([_renamed(column, names) for column in drafted.columns])
    return _with_own_casadi(program, lines)


def _short_names(block: Block) -> dict[str, str]:
    """Names of what calls return, of their functions' own, where these are one for each."""
    calls = [(step, step.callee) for step in block.steps if step.callee]
    short = [name for _, shared in calls for name in shared.returns]
    long = [name for step, _ in calls for name in step.targets]
    taken = {*block.place, *block.inputs, *block.arguments, *(shared.name for _, shared in calls)} - {*long}
    return dict(zip(long, short, strict=True)) if len({*short}) == len(short) and taken.isdisjoint(short) else {}


def shared_text(program: Program, shared: Shared, units: Mapping[str, str]) -> str:
    """Text of a function that several builders call; `units` by name, with moments and energies in N m."""
    stated = ("N m" if unit == "J" else unit for unit in shared.units(units))
    returns = [f"{name} [{unit}]" if unit else name for name, unit in zip(shared.returns, stated, strict=True)]
    lines = [
        *_wrapped_lines(f"{shared.name}({', '.join(shared.parameters)}):", "def ", " " * 8),
        *prose_lines(f"Return {', '.join(returns)}.", '    """', " " * 4),
    ]
    lines[-1] += '"""'
    *steps, last = shared.steps
    if shared.returns == last.targets:
        lines += [*_step_lines(steps, {}), f"    return {last.text({})}"]
    else:
        lines += [*_step_lines(shared.steps, {}), f"    return {', '.join(shared.returns)}"]
    return _with_own_casadi(program, lines)


def _step_lines(steps: Iterable[Step], names: Mapping[str, str]) -> list[str]:
    return [f"    {', '.join(names.get(name, name) for name in step.targets)} = {step.text(names)}" for step in steps]


def _unpacking(inputs: Iterable[tuple[str, str]]) -> list[str]:
    """Assignments of inputs to names, as many of one vector on a line as it holds."""
    lines: list[tuple[str, str]] = []
    for name, place in inputs:
        names, places = lines[-1] if lines else ("", "")
        one_vector = places.startswith(place.partition("[")[0] + "[")
        if one_vector and len(f"    {names}, {name} = {places}, {place}") <= WIDTH:
            lines[-1] = f"{names}, {name}", f"{places}, {place}"
        else:
            lines.append((name, place))
    return [f"    {names} = {places}" for names, places in lines]


def _with_own_casadi(program: Program, lines: Iterable[str]) -> str:
    own = program.tape.own("ca")
    return "\n".join(lines if own == "ca" else (_CASADI.sub(f"{own}.", line) for line in lines))


def curve_text(curve: Any) -> str:
    """Text of the function of a curve, also of a vector of its parameter, or of the pieces of a chain."""
    (name, _), arguments = curve_names(curve), curve.parameters
    if curve.searched:
        values = tuple(value for piece in curve.pieces for value in piece)
        summary = f"Pieces of the chain {curve.name}: start x, y, end x, y, centre x, y of each."
    else:
        taken = {symbol.name for symbol in arguments}
        s = sp.Symbol(next(letter for letter in ("s", "along", "s_") if letter not in taken), real=True)
        x, y = curve.x.xreplace({curve.s: s}), curve.y.xreplace({curve.s: s})
        values = tuple(expression.diff(s, order) for order in (0, 1, 2) for expression in (x, y))
        arguments = (s, *arguments)
        summary = f"Point of the curve {curve.name} at its parameter, and derivatives by it: x, y, x', y', x'', y''."
    result = Result(name, ("",) * len(values), ("",) * len(values), values)
    function = eliminate_common_subexpressions(Function(name, "", (), (), (result,)))
    words = names_in_words(function.body, {}, {symbol.name for symbol in arguments})
    lines = [
        *(f"    {symbol.name} = {expression_text(expression)}" for symbol, expression in function.body),
        f"    return {', '.join(map(expression_text, function.results[0].expressions))}",
    ]
    head = f"def {name}({', '.join(symbol.name for symbol in arguments)}):"
    return "\n".join([head, f'    """{summary}"""', *(_renamed(line, words) for line in lines)])


def _names(program: Program, function: Function) -> dict[str, str]:
    """Names that stand for numbered ones in the text: of the assignment that is equal, else in words."""
    named = {
        x.name: program.names.get(symbol.name, symbol.name)
        for x, symbol in function.shared.items()
        if symbol is not None
    }
    unnamed = [(symbol, e) for symbol, e in function.body if symbol in function.shared and symbol.name not in named]
    return names_in_words(unnamed, {**program.names, **named}, program.tape.names)


def _renamed(code: str, names: Mapping[str, str]) -> str:
    return _NAME.sub(lambda name: names.get(name[0], name[0]), code)


def _return(columns: Sequence[str]) -> list[str]:
    """Return statement; if long, as many results on a line as it holds, and a long one on several lines."""
    columns = _runs(columns)
    line = f"    return {', '.join(columns)}"
    if len(columns) == 1 and columns[0].startswith("*"):
        return [f"    return ({columns[0]},)"]  # many equal results
    if len(line) <= WIDTH:
        return [line]
    if len(columns) == 1:
        return _wrapped_lines(columns[0], "    return ", " " * 8)
    rows: list[str] = []
    for column in columns:
        if rows and len(f"        {rows[-1]} {column},") <= WIDTH:
            rows[-1] += f" {column},"
        else:
            rows.append(f"{column},")
    first, *rest = rows
    lines = _wrapped_lines(first, "    return (", " " * 12)
    lines += [line for row in rest for line in _wrapped_lines(row, " " * 8, " " * 12)]
    return [*lines[:-1], f"{lines[-1].removesuffix(',')})"]


def _wrapped_lines(code: str, first: str, then: str) -> list[str]:
    """Break code inside CasADi's brackets at blanks where it is too long."""
    return textwrap.wrap(
        code,
        WIDTH,
        initial_indent=first,
        subsequent_indent=then,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _docstring(program: Program, function: Function, like: Function | None) -> list[str]:
    own = program.tape.own
    if like is not None:
        summary = function.summary.partition(". ")[0].removesuffix(".")
        lines = prose_lines(f"{summary}; arguments and returns as of {like.name}.", '    """', " " * 4)
        return [*lines[:-1], f'{lines[-1]}"""']
    table = _ARGUMENTS if function.places is None else _ARGUMENTS | _OF_PARTS
    arguments = "; ".join(own(name) + table[name].removeprefix(name) for name in function.arguments)
    lines = prose_lines(function.summary, '    """', " " * 4)
    lines += ["", f"    Arguments: {arguments}.", "    Returns, each a column vector:"]
    if program.pairs and function.name == "landmarks":  # more than a reader reads
        return [
            *lines[:-1],
            "    Returns a column vector for each row: the point, then its directions and sizes.",
            '    """',
        ]
    for (labels, units), results in groupby(function.results, lambda result: (result.labels, result.units)):
        names = [result.name for result in results]
        named = ", ".join(names) if len(names) <= _RUN else f"{names[0]} to {names[-1]}"
        entries = f"{named} ({len(labels)},): {_entries(program, labels, units)}"
        lines += prose_lines(entries, " " * 8, " " * 12)
    return [*lines, '    """']


def _entries(program: Program, labels: Sequence[str], units: Sequence[str]) -> str:
    """List the labels and units of a vector's entries, or name the table that has them."""
    for name in _TABLES:
        rows = program.tables.get(name, ())
        if rows and labels == tuple(row[0] for row in rows):
            if units == tuple(row[1] for row in rows):
                return name
            if len(set(units)) == 1:
                return f"{name} [{units[0]}]"
    return (
        ", ".join(f"{label} [{unit}]" if unit else label for label, unit in zip(labels, units, strict=True)) or "empty"
    )


def prose_lines(text: str, first: str, then: str) -> list[str]:
    """Wrap text for a docstring, then escape it: an escape must not be broken."""
    lines = textwrap.wrap(text, WIDTH, initial_indent=" " * len(first), subsequent_indent=then)
    return [indent + prose(line) for indent, line in zip((first, *[then] * len(lines)), lines, strict=False)]


def _places(program: Program, function: Function) -> dict[str, str]:
    """Place of each entry that the function reads, by its name."""
    positions: dict[Any, str] = {}
    own = program.tape.own
    if "c" in function.arguments:
        end = 0
        for symbol in program.constants:
            begin, end = end, end + program.tape.widths.get(symbol, 1)
            place = f"{begin}:{end}" if symbol in program.tape.widths else f"{begin}"
            positions[symbol] = f"{own('c')}[{place}]"
    else:
        parameters = [symbol for symbol, group in program.tape.inputs.items() if group == "p"]
        positions.update((symbol, f"{own('p')}[{k}]") for k, symbol in enumerate(parameters))
    count: dict[str, int] = {}
    for symbol, group in program.tape.inputs.items():
        if group not in ("p", "t", "c"):
            positions[symbol] = f"{own(group)}[{count.get(group, 0)}]"
            count[group] = count.get(group, 0) + 1
    positions.update(function.places or {})
    wanted = set(function.reads)
    return {
        program.names.get(symbol.name, symbol.name): place for symbol, place in positions.items() if symbol in wanted
    }


def _column(texts: Sequence[str]) -> str:
    """Column vector of texts."""
    return f"ca.vertcat({', '.join(_runs(texts))})"


def _runs(texts: Sequence[str]) -> list[str]:
    """Texts, of which a long run of equal ones, or of equal groups, is written once, with its number."""
    parts: list[str] = []
    begin = 0
    while begin < len(texts):
        size, count = next(
            ((size, count) for size in range(1, _GROUP + 1) if (count := repeats(texts, begin, size)) > _RUN), (1, 1)
        )
        group = ", ".join(texts[begin : begin + size])
        plain = count == 1 or "[" in group
        parts += texts[begin : begin + size * count] if plain else [f"*[{group}]*{count}"]
        begin += size * count
    return parts


def repeats(texts: Sequence[Any], begin: int, size: int) -> int:
    """Number of times that a group of entries stands in a row."""
    end = begin + size
    while end < len(texts) and texts[end] == texts[end - size]:
        end += 1
    return (end - begin) // size


def prose(text: str) -> str:
    """Text of a scene on one line, escaped for a docstring."""
    return visible(" ".join(text.split())).replace("\\", "\\\\").replace('"', "'")
