"""Tables: values at increasing arguments, interpolated by a quintic spline as a SymPy function.

The spline can be differentiated twice. It is the curve through all points with the least integral of its squared
third derivative among those without curvature at both ends (Schoenberg, Proc. Nat. Acad. Sci. 52 (1964) 947): within
the table four derivatives are continuous. Beyond the ends it continues along its tangent, with two continuous
derivatives. Between the points of a smooth curve the error is of 6th order in their distance if the second and fourth
derivatives of that curve vanish at the ends (a sine over half periods), of 2nd order near an end that is curved.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.identifiers import name_faults, unit_faults
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.algebra.functions import NoText

Pair = tuple[float, float]
REACH = 48
"""Points beyond which the end of a spline changes nothing: 0.43^48 is below the rounding of a double."""


class Table(sp.AtomicExpr):  # type: ignore[misc]  # SymPy is untyped
    """Arguments and values with their units; `table(x)` is the spline at x, a SymPy expression.

    `slopes` are those at both ends, in the unit of a value over that of an argument; None leaves them to the spline.
    Of a `periodic` one all derivatives at the last argument are those at the first; within the table alone.
    """

    __slots__ = ("arguments", "name", "periodic", "slopes", "units", "values")

    def __new__(
        cls,
        name: str,
        arguments: Sequence[float],
        values: Sequence[float],
        units: tuple[str, str],
        slopes: Pair | None = None,
        periodic: bool = False,
    ) -> Table:
        """Make a table without checking it: see `faults`."""
        self = super().__new__(cls)
        self.name = name
        self.arguments = _as_tuple(arguments)
        self.values = _as_tuple(values)
        self.units = _as_tuple(units)
        self.slopes = None if slopes is None else _as_tuple(slopes)
        self.periodic = periodic
        return self  # type: ignore[no-any-return]

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, repr(self.arguments), repr(self.values), self.units, repr(self.slopes), self.periodic)

    def __getnewargs__(self) -> tuple[Any, ...]:
        return (self.name, self.arguments, self.values, self.units, self.slopes, self.periodic)

    def _sympystr(self, _: Any) -> str:
        return str(self.name)

    def __call__(self, argument: Any) -> Spline:
        """The spline at an argument; raises TypeError for text."""
        spline: Spline = Spline(self, argument, 0)
        return spline

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of the declaration."""
        faults = tuple(self._declared_faults())
        yield from faults
        if not faults and not self._finite():
            yield Fault(f"table {self.name}", "points whose spline leaves the range of a double",
                        "arguments, values and slopes less far apart in size")  # fmt: skip

    def _declared_faults(self) -> Iterator[Fault]:
        where = f"table {self.name}"
        yield from name_faults("table", self.name)
        if len(self.units) != 2:
            yield Fault(where, f"units {self.units!r}", "two, of an argument and of a value")
        for unit in self.units:
            yield from unit_faults(where, unit, constant=True)
        if len(self.arguments) != len(self.values) or len(self.arguments) < 2:
            actual = f"{len(self.arguments)} arguments and {len(self.values)} values"
            yield Fault(where, actual, "as many values as arguments, at least two")
        for kind, numbers in (("argument", self.arguments), ("value", self.values), ("slope", self.slopes or ())):
            for k, number in enumerate(numbers):
                real = isinstance(number, int | float) and not isinstance(number, bool)
                if not (real and abs(number) <= sys.float_info.max):
                    yield Fault(where, f"{kind} {shown(number)} in place {k + 1}", "a finite number")
                    return
        if self.slopes is not None and len(self.slopes) != 2:
            yield Fault(where, f"{len(self.slopes)} slopes", "two, at the first and at the last argument, or None")
        if self.periodic and self.slopes is not None:
            yield Fault(where, "slopes at the ends of a period", "none: they follow")
        if self.periodic and len(self.values) > 1 and self.values[0] != self.values[-1]:
            yield Fault(
                where,
                f"{shown(self.values[-1])} after a period that begins with {shown(self.values[0])}",
                "the first value again, at the end",
            )
        for k, (a, b) in enumerate(pairwise(self.arguments)):
            if not a < b:
                yield Fault(where, f"argument {b!r} after {a!r} in place {k + 2}", "arguments that increase",
                            "Sort the rows by argument; of two rows with one argument leave one out.")  # fmt: skip
                return

    def _finite(self) -> bool:
        try:
            return all(math.isfinite(number) for row in self.pieces() for number in row)
        except ArithmeticError:
            return False

    def pieces(self) -> tuple[tuple[float, ...], ...]:
        """Rows (x, c0, ..., c5), SI: the piece from x to the next point is sum c_k (s - x)^k.

        Only x of the last row is used.
        """
        argument, value = (parse_unit(unit) for unit in self.units)
        x, y = [argument.to_si(a) for a in self.arguments], [value.to_si(v) for v in self.values]
        per = value.to_si(1.0) / argument.to_si(1.0)
        slopes = None if self.slopes is None else (self.slopes[0] * per, self.slopes[1] * per)
        nodes = _periodic_nodes(x, y) if self.periodic else _nodes(x, y, slopes)
        rows = []
        for k in range(len(x) - 1):
            (v0, a0), (v1, a1), h = nodes[k], nodes[k + 1], x[k + 1] - x[k]
            rise = (y[k + 1] - y[k] - h * (v0 + h * a0 / 2)) / h**3
            turn = (v1 - v0 - h * a0) / h**2
            bend = (a1 - a0) / h
            higher = (10 * rise - 4 * turn + bend / 2, -15 * rise + 7 * turn - bend, 6 * rise - 3 * turn + bend / 2)
            rows.append((x[k], y[k], v0, a0 / 2, *(c / h**power for power, c in enumerate(higher))))
        return (*rows, (x[-1], y[-1], nodes[-1][0], 0.0, 0.0, 0.0, 0.0))


class Spline(NoText):
    """`Spline(table, x, k)`: k-th derivative, k = 0, 1, 2, of a table's spline at x. Never evaluated."""

    nargs = 3

    @classmethod
    def eval(cls, table: Any, argument: Any, order: Any) -> None:
        """Check the order of the derivative; never evaluate. Raises ValueError."""
        if order not in (0, 1, 2):
            raise ValueError(f"the spline of {table} has two derivatives everywhere; the {order}th was requested")

    def fdiff(self, argindex: int = 2) -> Any:
        """Next derivative."""
        if argindex != 2:
            raise sp.ArgumentIndexError(self, argindex)
        table, argument, order = self.args
        return Spline(table, argument, order + 1)

    def _eval_is_real(self) -> bool:
        return True

    def _sympystr(self, printer: Any) -> str:
        table, argument, order = self.args
        primes = "'" * int(order)
        return f"{table.name}{primes}({printer.doprint(argument)})"

    def _latex(self, printer: Any) -> str:
        table, argument, order = self.args
        name = str(table.name).replace("_", r"\_")
        primes = "'" * int(order)
        return rf"\mathrm{{{name}}}{primes}\left({printer.doprint(argument)}\right)"


def _as_tuple(values: Any) -> tuple[Any, ...]:
    """Entries of a sequence; a single value is wrapped, for `faults` to report."""
    return tuple(values) if isinstance(values, Iterable) else (values,)


def _periodic_nodes(x: list[float], y: list[float]) -> list[Pair]:
    """First and second derivative at every point of one period.

    Of the natural spline over so many periods that its ends do not reach the middle one: their influence falls by 0.43
    from point to point.
    """
    count, period = len(x) - 1, x[-1] - x[0]
    around = REACH // count + 1
    turns = range(-around, around + 1)
    longer = [k * period + at for k in turns for at in x[:-1]] + [around * period + x[-1]]
    nodes = _nodes(longer, [value for _ in turns for value in y[:-1]] + [y[-1]], None)
    return [*nodes[around * count : (around + 1) * count], nodes[around * count]]


def _nodes(x: list[float], y: list[float], slopes: Pair | None) -> list[Pair]:
    """First and second derivative of the spline at every point.

    Adjacent pieces agree in their third and fourth derivatives; at both ends the second derivative vanishes, and the
    slope is given or the fourth vanishes too. Block tridiagonal elimination, two unknowns per point.
    """
    count = len(x)
    rows: list[list[list[float]]] = []  # per point: before, here, after (2 x 2, row by row), right-hand side
    for k in range(count):
        before, here, after, right = [0.0] * 4, [0.0] * 4, [0.0] * 4, [0.0] * 2
        if 0 < k < count - 1 or slopes is None:  # fourth derivative, then third
            if k > 0:
                h, rise = x[k] - x[k - 1], y[k] - y[k - 1]
                before = [168 / h**3, 24 / h**2, 24 / h**2, 3 / h]
                here = [192 / h**3, -36 / h**2, 36 / h**2, -9 / h]
                right = [360 * rise / h**4, 60 * rise / h**3]
            if k < count - 1:
                h, rise = x[k + 1] - x[k], y[k + 1] - y[k]
                after = [168 / h**3, -24 / h**2, -24 / h**2, 3 / h]
                here = [a + b for a, b in zip(here, [192 / h**3, 36 / h**2, -36 / h**2, -9 / h], strict=True)]
                right = [right[0] + 360 * rise / h**4, right[1] - 60 * rise / h**3]
        else:
            here[:2], right[0] = [1.0, 0.0], slopes[0 if k == 0 else 1]
        if k in (0, count - 1):
            before[2:], here[2:], after[2:], right[1] = [0.0, 0.0], [0.0, 1.0], [0.0, 0.0], 0.0
        rows.append([before, here, after, right])
    for k in range(1, count):
        (before, here, _, right), (_, pivot, after, known) = rows[k], rows[k - 1]
        factor = _times(before, _inverse(pivot))
        rows[k][1] = [a - b for a, b in zip(here, _times(factor, after), strict=True)]
        rows[k][3] = [a - b for a, b in zip(right, _applied(factor, known), strict=True)]
    derivatives: list[list[float]] = [[0.0, 0.0]] * count
    for k in reversed(range(count)):
        _, here, after, right = rows[k]
        ahead = _applied(after, derivatives[k + 1]) if k < count - 1 else [0.0, 0.0]
        derivatives[k] = _applied(_inverse(here), [a - b for a, b in zip(right, ahead, strict=True)])
    return [(v, a) for v, a in derivatives]


def _inverse(m: list[float]) -> list[float]:
    a, b, c, d = m
    determinant = a * d - b * c
    return [d / determinant, -b / determinant, -c / determinant, a / determinant]


def _times(m: list[float], n: list[float]) -> list[float]:
    return [m[0] * n[0] + m[1] * n[2], m[0] * n[1] + m[1] * n[3], m[2] * n[0] + m[3] * n[2], m[2] * n[1] + m[3] * n[3]]


def _applied(m: list[float], x: list[float]) -> list[float]:
    return [m[0] * x[0] + m[1] * x[1], m[2] * x[0] + m[3] * x[1]]
