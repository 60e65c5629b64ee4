"""Planar curves fixed to bodies: by expressions of a parameter, or through points. Declarations only."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import accumulate, pairwise
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.declare.mechanism.pose import Posed, PoseSymbol
from hertzwerk.derive.expressions.algebra.planar_curve import Drawn, PlanarCurve
from hertzwerk.derive.expressions.algebra.splines import Spline, Table
from hertzwerk.derive.expressions.parameter import CURVE, Parameter, Scalar, Slot, is_number, parameters_of

S = PoseSymbol("s", "1")
"""Parameter of a curve [1 or rad]."""

FINE = 240  # points at which a curve is checked
TURN, PARTS = math.radians(15), 16  # between samples it turns by no more, and is no longer than one part in so many
LARGEST = 400  # samples
ALIKE = 1e-9  # of the curve's size, in which ends that meet may differ


@dataclass(frozen=True)
class AlongCurve(Posed):
    """Quantity that may vary along a curve, with its parameter `S`."""

    symbols: ClassVar[tuple[Any, ...]] = (S,)
    words: ClassVar[str] = "S"
    tables: ClassVar[bool] = True


class SolidCurve:
    """Planar curve or chain with solid on one side: common part of `Curve` and `Outline`."""

    name: str
    closed: bool
    hole: bool

    @property
    def where(self) -> str:
        """Its name in messages."""
        return f"curve {self.name}"

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities."""
        raise NotImplementedError

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of its shape at the defaults."""
        raise NotImplementedError

    def flag_faults(self) -> Iterator[Fault]:
        """Yield faults of `closed` and `hole`."""
        for name, flag in (("closed", self.closed), ("hole", self.hole)):
            if not isinstance(flag, bool):
                yield Fault(f"{self.where}, {name}", repr(flag), "True or False")
        if self.hole is True and self.closed is False:
            yield Fault(self.where, "an open curve as a hole", "a closed one",
                        "The solid of an open curve is to its left: let it run the other way.")  # fmt: skip

    @property
    def planar(self) -> Any:
        """The curve for equations, a `PlanarCurve` or `PlanarChain`."""
        raise NotImplementedError

    @property
    def drawn(self) -> Drawn:
        """Its points for a picture."""
        planar = self.planar
        return Drawn(planar, *planar.parameters)  # type: ignore[no-any-return]  # SymPy is untyped


@dataclass(frozen=True)
class Curve(SolidCurve):
    """Curve x, y [m] by expressions of the parameter `S` from start to end.

    It lies in the plane of X and Y of the place that it is fixed to.
    The solid lies to the left of its direction: a closed curve runs counterclockwise round it. Of a `hole` it is a
    closed curve's outside, and the curve still runs counterclockwise. A closed curve is smooth where it closes; the
    expressions are twice differentiable, and may contain tables of `S`.

    It may stand for `repeats` copies of itself, turned about its place by equal parts of a turn, as the teeth of a wheel:
    in a `CurveOnCurve`. Its parameter then counts on from copy to copy.
    """

    name: str
    x: Scalar
    y: Scalar
    start: float = 0.0
    end: float = 2 * math.pi
    closed: bool = True
    hole: bool = False
    repeats: int = 1

    def slots(self) -> Iterator[Slot]:
        """Yield the coordinates."""
        yield AlongCurve(f"{self.where}, x", self.x, "m")
        yield AlongCurve(f"{self.where}, y", self.y, "m")

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of its shape at the defaults, where its expressions are sound."""
        faults = list(self._declared_faults())
        yield from faults
        if not faults:
            yield from _shape_faults(self)

    def _declared_faults(self) -> Iterator[Fault]:
        yield from name_faults(self.where, self.name)
        for which, value in (("start", self.start), ("end", self.end)):
            if not _is_finite(value):
                yield Fault(f"{self.where}, {which}", repr(value), "a finite number, the parameter there",
                            "An end that depends on parameters: let S run from 0 to 1, and write S*end in x and y.")  # fmt: skip
        yield from self.flag_faults()
        if not isinstance(self.repeats, int) or isinstance(self.repeats, bool) or self.repeats < 1:
            yield Fault(f"{self.where}, repeats", repr(self.repeats), "a whole number, 1 or more")
        elif self.repeats > 1 and self.closed is True:
            yield Fault(f"{self.where}, repeats", f"{self.repeats} copies of a closed curve", "an open one, as the flank of a tooth",
                        "closed=False; one closed curve may run round all of its lobes by itself.")  # fmt: skip
        if _is_finite(self.start) and _is_finite(self.end) and not self.start < self.end:
            yield Fault(
                self.where, f"parameters from {float(self.start):g} to {float(self.end):g}", "a start before the end"
            )

    @cached_property
    def planar(self) -> PlanarCurve:
        """The curve with its samples, for equations."""
        at, convex = _samples(self)
        return PlanarCurve(
            name=self.name,
            x=sp.sympify(self.x),
            y=sp.sympify(self.y),
            s=S,
            parameters=tuple(dict.fromkeys((*parameters_of(self.x), *parameters_of(self.y)))),
            start=float(self.start),
            end=float(self.end),
            closed=self.closed,
            hole=self.hole,
            tries=1 if convex and self.closed else 2,
            repeats=self.repeats,
            at=at,
        )


def curve_through(
    name: str, x: Sequence[float], y: Sequence[float], unit: str, closed: bool = True, hole: bool = False
) -> Curve:
    """Smooth curve through points, by quintic splines over the length of the chords.

    They are periodic, or open with straight ends.
    A closed one does not repeat its first point. `S` runs from 0 to 1.
    """
    x, y = list(x), list(y)
    points = [*zip(x, y, strict=False)]
    ends = [*points, points[0]] if closed and points else points
    chords = [math.hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(ends)] if _all_finite(ends) else []
    lengths = [0.0, *accumulate(chords)]
    whole = lengths[-1] or 1.0
    at = [length / whole for length in lengths] if len(lengths) == len(ends) else [0.0]
    values = [[*row, row[0]] if closed and row else row for row in (x, y)]
    tables = [
        Table(f"{name}_{axis}", at, row, ("1", unit), periodic=closed) for axis, row in zip("xy", values, strict=True)
    ]
    return Curve(name, tables[0](S), tables[1](S), 0.0, 1.0, closed, hole)


def curve_faults(curves: Iterable[tuple[str, Any]], taken: Collection[str]) -> Iterator[Fault]:
    """Yield faults of curves, each with where it is declared; `taken` are names of parameters.

    A module has a function and a table of each, named after it.
    """
    known: dict[str, SolidCurve] = {}
    for where, curve in curves:
        if not isinstance(curve, SolidCurve):
            yield Fault(
                f"{where}, curve",
                f"{curve!r:.80}",
                "a Curve(name, x, y), what curve_through(...) gives, or an Outline(name, start, pieces)",
            )
            continue
        yield from curve.faults()
        if not isinstance(curve.name, str):
            continue
        if known.setdefault(curve.name.upper(), curve) != curve:
            yield Fault(curve.where, "two different curves of this name", "names that are unique, in capitals too",
                        "Share one Curve object, or rename one.")  # fmt: skip
        function = f"{curve.name}{CURVE}"
        if any(name.upper() == function.upper() for name in taken):
            yield Fault(
                curve.where, f"a parameter named {function}", "another name: that of the curve's function in a module"
            )


def single_faults(where: str, curve: Any) -> Iterator[Fault]:
    """Yield the fault of a curve with copies where one is required."""
    if getattr(curve, "repeats", 1) != 1:
        yield Fault(f"{where}, curve {curve.name}", f"{curve.repeats!r} copies", "one curve, repeats=1",
                    "A curve that repeats is touched by another, CurveOnCurve; one that runs all round needs no copies.")  # fmt: skip


# -- numbers at the defaults ---------------------------------------------------------------------------------------------


def _is_finite(value: Any) -> bool:
    number = isinstance(value, int | float) or (is_number(value) and value.is_number and value.is_real)
    return bool(number) and not isinstance(value, bool) and math.isfinite(float(value))


def _all_finite(points: Sequence[tuple[Any, Any]]) -> bool:
    return all(_is_finite(value) for point in points for value in point)


def _functions(curve: Curve) -> Callable[[float], tuple[float, ...]]:
    """Function of s: position, first and second derivative at the parameters' defaults."""
    x, y = sp.sympify(curve.x), sp.sympify(curve.y)
    whole = sp.Tuple(x, y, x.diff(S), y.diff(S), x.diff(S, 2), y.diff(S, 2))
    splines: dict[Any, Any] = {}
    names: dict[str, Any] = {"Where": lambda condition, a, b: a if condition else b}
    for node in sp.preorder_traversal(whole):
        if isinstance(node, Spline) and node not in splines:
            name = f"spline_{len(splines)}"
            splines[node] = sp.Function(name)(node.args[1])
            names[name] = _spline(node.args[0], int(node.args[2]))
    values = {p: sp.Float(p.si, 17) for p in parameters_of(whole)}
    made: Callable[[float], tuple[float, ...]] = sp.lambdify(
        S, tuple(whole.xreplace(splines).xreplace(values)), [names, "math"]
    )
    return made


def _spline(table: Table, order: int) -> Callable[[float], float]:
    """Derivative of a table's spline."""
    rows = table.pieces()
    knots = [row[0] for row in rows]

    def value(at: float) -> float:
        inside = min(max(at, knots[0]), knots[-1])
        row = rows[min(max(bisect_right(knots, inside) - 1, 0), len(rows) - 2)]
        s, (c0, c1, c2, c3, c4, c5) = inside - row[0], row[1:]
        slope = c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))
        if order == 2:
            return 2 * c2 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))
        return slope if order else c0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5)))) + slope * (at - inside)

    return value


@lru_cache(maxsize=64)
def _fine(curve: Curve) -> tuple[tuple[float, ...], ...]:
    """Rows (s, x, y, x', y', x'', y'') at many parameters, both ends included.

    Raises what the expressions raise.
    """
    function = _functions(curve)
    start, end = float(curve.start), float(curve.end)
    at = [start + (end - start) * k / FINE for k in range(FINE + 1)]
    return tuple((s, *map(float, function(s))) for s in at)


@lru_cache(maxsize=64)
def _samples(curve: Curve) -> tuple[tuple[float, ...], bool]:
    """Parameters of samples, denser where the curve turns, and whether it is convex towards the outside."""
    rows = _fine(curve)
    *_, length = accumulate(math.hypot(b[1] - a[1], b[2] - a[2]) for a, b in pairwise(rows))  # as `sum` before 3.12
    turns = [angle_between(a[3:5], b[3:5]) for a, b in pairwise(rows)]
    work = [
        max(abs(turn) / TURN, 1e-6) + math.hypot(b[1] - a[1], b[2] - a[2]) / length * PARTS
        for turn, (a, b) in zip(turns, pairwise(rows), strict=True)
    ]
    reached = [0.0, *accumulate(work)]
    count = min(math.ceil(reached[-1]), LARGEST)
    at, k = [], 0
    for j in range(count if curve.closed else count + 1):
        wanted = reached[-1] * j / count
        while k < len(work) - 1 and reached[k + 1] < wanted:
            k += 1
        share = min((wanted - reached[k]) / work[k], 1.0)
        at.append(rows[k][0] + share * (rows[k + 1][0] - rows[k][0]))
    sign = -1 if curve.hole else 1
    return tuple(at), all(sign * turn > -1e-9 for turn in turns)


def angle_between(a: Sequence[float], b: Sequence[float]) -> float:
    """Angle from one direction to another, to the left [rad]."""
    return math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])


def _shape_faults(curve: Curve) -> Iterator[Fault]:
    """Faults of the shape at the defaults; none where its expressions have faults of their own."""
    coordinates = [curve.x, curve.y]
    symbols = [node for value in coordinates if is_number(value) for node in sp.sympify(value).free_symbols]
    sound = all(map(is_number, coordinates)) and all(isinstance(node, Parameter) or node == S for node in symbols)
    splines = [node for value in coordinates if is_number(value) for node in sp.sympify(value).atoms(Table)]
    if (
        not sound
        or any(any(table.faults()) for table in splines)
        or any(any(p.faults()) for p in parameters_of(sp.Tuple(*coordinates)))
    ):
        return  # which the audit of the quantities reports
    where = curve.where
    try:
        rows = _fine(curve)
        bad = next((row[0] for row in rows if not all(map(math.isfinite, row))), None)
    except (ArithmeticError, ValueError, TypeError, NameError) as error:
        yield Fault(where, f"no numbers along it: {error}", "real numbers, twice differentiable, from start to end")
        return
    if bad is not None:
        yield Fault(where, f"no finite numbers at S = {bad:g}", "a point with two derivatives from start to end")
        return
    size = max(max(row[k] for row in rows) - min(row[k] for row in rows) for k in (1, 2))
    if size == 0:
        yield Fault(where, "a curve of no length", "a curve whose x and y change with S")
        return
    slowest = min(rows, key=lambda row: math.hypot(row[3], row[4]))
    if math.hypot(slowest[3], slowest[4]) * (rows[-1][0] - rows[0][0]) < 1e-6 * size:
        yield Fault(where, f"it stands still at S = {slowest[0]:.6g}", "a direction everywhere: x' and y' not both zero",
                    "A cusp or a corner is the end of a curve: let it start or stop beside it.")  # fmt: skip
        return
    (_, x0, y0, *first), (_, x1, y1, *last) = rows[0], rows[-1]
    apart = math.hypot(x1 - x0, y1 - y0)
    if curve.closed:
        kink = abs(angle_between(first[:2], last[:2]))
        if apart > ALIKE * size:
            yield Fault(where, f"ends {apart:.3g} m apart", "a closed curve, which ends where it starts",
                        "closed=False, or S from start to end once round.")  # fmt: skip
            return
        if kink > 1e-6:
            yield Fault(
                where,
                f"a corner of {math.degrees(kink):.3g} degrees where it closes",
                "a closed curve that is smooth there",
            )
        area = sum(a[1] * b[2] - a[2] * b[1] for a, b in pairwise(rows)) / 2
        if area < 0:
            yield Fault(where, "a closed curve that runs clockwise", "one that runs counterclockwise",
                        "Replace S by -S in x and y; for a solid outside it use hole=True.")  # fmt: skip
    # between the rows, for curves love to cross at round values of their parameter
    middles = [((a[1] + b[1]) / 2, (a[2] + b[2]) / 2) for a, b in pairwise(rows)]
    crossed = crossing([*middles, middles[0]] if curve.closed else middles, curve.closed)
    if crossed is not None:
        s = [rows[k][0] for k in crossed]
        yield Fault(where, f"it crosses itself, at S = {s[0]:.3g} and {s[1]:.3g}", "a curve that does not: one side of it is solid")  # fmt: skip


def crossing(points: Sequence[Sequence[float]], closed: bool) -> tuple[int, int] | None:
    """Two pieces of a chain of points that cross or touch, not adjacent."""
    pieces = list(pairwise(points))
    boxes = [(min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])) for a, b in pieces]
    for i, (a, b) in enumerate(pieces):
        left, right, low, high = boxes[i]
        for j in range(i + 2, len(pieces)):
            box = boxes[j]
            if (
                box[0] > right
                or box[1] < left
                or box[2] > high
                or box[3] < low
                or (closed and i == 0 and j == len(pieces) - 1)
            ):
                continue
            c, d = pieces[j]
            if _side(a, b, c) * _side(a, b, d) <= 0 and _side(c, d, a) * _side(c, d, b) <= 0:
                return i, j
    return None


def _side(a: Sequence[float], b: Sequence[float], p: Sequence[float]) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
