"""Changes each numeric constant of each law by 1 % and runs what is known of that law: `python mutate_laws.py [LAW]...` prints a table.

`wear` among the names stands for Archard's law by sectors, whose numbers are in its source: see `worn.py`.

A constant is every number in a law's expressions where it stands (factors, exponents, the 1 of 1 - nu^2, the -1 of a difference or quotient, pi),
the ranges it states, and the values it gives itself. The branch of Lambert's function is none: it is a choice between two functions.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Container, Iterator
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

if __name__ == "__main__":  # as pytest has it
    sys.path[:0] = [str(Path(__file__).parent), *(str(Path(__file__).parents[k]) for k in (2, 3))]

import sympy as sp
from bench import DIGITS
from evidence import EVIDENCE
from known import INDEPENDENT, TYPED
from mpmath import mp
from worn import survivors as survivors_of_wear

from hertzwerk.derive.expressions.parameter import Interval, Parameter
from hertzwerk.derive.laws import LAWS

BY = sp.Rational(101, 100)
KINDS = (*INDEPENDENT, TYPED)


@dataclass(frozen=True)
class Mutant:
    """A law with one constant changed: where it stands, what it was, and the record."""

    where: str
    constant: str
    law: Any


def constants(law: Any) -> Iterator[Mutant]:
    """Every mutant of a law."""
    for field in fields(law):
        if field.init:
            yield from _of_field(law, field.name, getattr(law, field.name))


def survivors(name: str, kinds: Container[str] = KINDS) -> Iterator[Mutant]:
    """Mutants of a law that nothing known of it, of these kinds, notices."""
    with mp.workdps(DIGITS):
        yield from (mutant for mutant in constants(LAWS[name]) if not noticed(name, mutant.law, kinds))


def noticed(name: str, law: Any, kinds: Container[str] = KINDS) -> str:
    """The first thing known of a law that a record contradicts, or cannot be asked of; "" where there is none."""
    for known in EVIDENCE[name]:
        if known.kind not in kinds:
            continue
        try:
            known.check(law)
        except (AssertionError, TypeError, ValueError, ZeroDivisionError, KeyError):
            return f"{known.kind}: {known.what}"
    return ""


def _of_field(law: Any, name: str, value: Any) -> Iterator[Mutant]:
    if isinstance(value, sp.Basic):
        for constant, changed in _changed(value):
            yield Mutant(name, constant, replace(law, **{name: changed}))
    elif isinstance(value, Interval):
        for end, changed in _moved(value):
            yield Mutant(name, end, replace(law, **{name: changed}))
    elif name == "stages":
        for i, stage in enumerate(value):
            for constant, changed in _changed(stage):
                yield Mutant(name, constant, replace(law, stages=(*value[:i], changed, *value[i + 1 :])))
    elif name in ("definitions", "memory", "ranges", "defaults"):
        for i, row in enumerate(value):
            for where, constant, other in _rows(name, row):
                rows = (*value[:i], other, *value[i + 1 :])
                yield Mutant(where, constant, replace(law, **{name: rows}))


def _rows(name: str, row: Any) -> Iterator[tuple[str, str, Any]]:
    """Where, constant and changed row of a definition, a memory, a range, a default."""
    if name == "ranges":
        yield from (
            (f"range of {row.quantity.name}", end, replace(row, interval=moved)) for end, moved in _moved(row.interval)
        )
        return
    if isinstance(row, sp.Symbol):  # what a damping law latches
        return
    symbol, *expressions = row
    for k, expression in enumerate(expressions):
        if isinstance(expression, Parameter):
            p = expression
            yield (
                f"default of {symbol.name}", str(p.default), (symbol, Parameter(p.name, p.unit, p.default * float(BY), p.meaning)),
            )  # fmt: skip
            continue
        for constant, changed in _changed(expression):
            yield f"{name[:-1]} {symbol.name}", constant, (symbol, *expressions[:k], changed, *expressions[k + 1 :])


def _moved(interval: Interval) -> Iterator[tuple[str, Interval]]:
    for end in ("lower", "upper"):
        bound = getattr(interval, end)
        if bound:
            yield f"{end} {bound:g}", replace(interval, **{end: bound * float(BY)})


def _changed(expression: Any) -> Iterator[tuple[str, Any]]:
    """Each number of an expression where it stands, and the expression with that one changed."""
    for path, number, around in _numbers(expression, (), None):
        text = str(around if around is not None else expression)
        yield f"{number} of {text if len(text) < 60 else text[:57] + '...'}", _put(expression, path, number * BY)


def _numbers(node: Any, path: tuple[int, ...], around: Any) -> Iterator[tuple[tuple[int, ...], Any, Any]]:
    if isinstance(node, (sp.Number, sp.NumberSymbol)):
        if node.is_finite and node != 0:
            yield path, node, around
        return
    for i, argument in enumerate(node.args):
        if not (isinstance(node, sp.LambertW) and i == 1):
            yield from _numbers(argument, (*path, i), node)


def _put(node: Any, path: tuple[int, ...], number: Any) -> Any:
    if not path:
        return number
    arguments = list(node.args)
    arguments[path[0]] = _put(arguments[path[0]], path[1:], number)
    return node.func(*arguments)


def main(names: list[str]) -> int:
    """The table: constants changed, noticed, by what most; survivors by name. Exit code 1 where there is one."""
    left: list[tuple[str, Mutant]] = []
    print(f"{'law':<30} grade constants noticed     s  noticed first by")
    total = 0
    laws = [name for name in names or LAWS if name != "wear"]
    for name in laws:
        began, by = time.perf_counter(), {}
        count = 0
        with mp.workdps(DIGITS):
            for mutant in constants(LAWS[name]):
                count += 1
                what = noticed(name, mutant.law)
                by[what] = by.get(what, 0) + 1
                if not what:
                    left.append((name, mutant))
        total += count
        seen = ", ".join(f"{what} ({n})" for what, n in sorted(by.items(), key=lambda item: -item[1]) if what)
        print(
            f"{name:<30} {LAWS[name].grade:^5} {count:9} {count - by.get('', 0):7} {time.perf_counter() - began:5.1f}  {seen}",
            flush=True,
        )
    for name, mutant in left:
        print(f"SURVIVED {name}: {mutant.where}, {mutant.constant}")
    print(f"{total} constants of {len(laws)} laws, {len(left)} changes not noticed")
    worn = list(survivors_of_wear()) if laws != names else []
    for where in worn:
        print(f"SURVIVED wear: {where}")
    return bool(left or worn)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
