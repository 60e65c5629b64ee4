"""Outlines of solids as chains of circle arcs and straight lines. Declarations only."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, pairwise
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.declare.mechanism.curve import ALIKE, SolidCurve, angle_between, crossing
from hertzwerk.derive.expressions.algebra.planar_curve import ChainPoints, PlanarChain
from hertzwerk.derive.expressions.parameter import Parameter, Scalar, Slot, default_value, is_number, parameters_of

STEP = math.radians(5)  # of an arc, between points at which a chain is checked
BACK = math.radians(179.99)  # corners that turn by more are cusps
SMOOTH = 1e-6  # rad: corners that turn by less are none

Place = tuple[Scalar, Scalar]
Numbers = tuple[float, float]


@dataclass(frozen=True)
class Line:
    """Straight line to `end`, (x, y) [m]."""

    end: Place

    @property
    def places(self) -> tuple[tuple[str, Any], ...]:
        """Its points with their names."""
        return (("end", self.end),)


@dataclass(frozen=True)
class Arc:
    """Circle arc to `end` about `centre`, (x, y) [m] each: counterclockwise, or `clockwise`.

    Start and end are as far from the centre for all values of the parameters. An arc that ends where it starts is a whole circle.
    """

    end: Place
    centre: Place
    clockwise: bool = False

    @property
    def places(self) -> tuple[tuple[str, Any], ...]:
        """Its points with their names."""
        return ("end", self.end), ("centre", self.centre)

    @property
    def turn(self) -> int:
        """1 to the left, -1 to the right."""
        return -1 if self.clockwise else 1


Piece = Line | Arc


@dataclass(frozen=True)
class Outline(SolidCurve):
    """Chain of `pieces`, each a `Line` or an `Arc`, from `start`, (x, y) [m].

    As of a `Curve`, the solid is to its left, of a `hole` to the right, and a closed chain runs counterclockwise. Its last
    piece ends at the start. Pieces may meet in corners, which touch as points. Its parameter is the number of pieces
    passed, and the part of the present one.
    """

    name: str
    start: Place
    pieces: Sequence[Piece]
    closed: bool = True
    hole: bool = False

    def __post_init__(self) -> None:
        if isinstance(self.pieces, list):
            object.__setattr__(self, "pieces", tuple(self.pieces))

    def _places(self) -> Iterator[tuple[str, Any]]:
        """Yield points with where they are declared."""
        yield "start", self.start
        for number, piece in enumerate(self.pieces if isinstance(self.pieces, tuple) else (), 1):
            if isinstance(piece, Piece):
                yield from ((f"piece {number}, {label}", place) for label, place in piece.places)

    def slots(self) -> Iterator[Slot]:
        """Yield the coordinates of the points."""
        for label, place in self._places():
            if _is_place(place):
                yield from (Slot(f"{self.where}, {label}, {k}", v, "m") for k, v in zip("xy", place, strict=True))

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of its records, or else of its shape at the defaults."""
        faults = list(self._declared_faults())
        yield from faults
        if not faults and _is_sound(self):
            yield from self._shape_faults()

    def _declared_faults(self) -> Iterator[Fault]:
        yield from name_faults(self.where, self.name)
        yield from self.flag_faults()
        if not isinstance(self.pieces, tuple) or not self.pieces:
            yield Fault(f"{self.where}, pieces", f"{self.pieces!r:.80}", "a sequence of at least one Line or Arc")
            return
        for number, piece in enumerate(self.pieces, 1):
            if not isinstance(piece, Piece):
                yield Fault(f"{self.where}, piece {number}", f"{piece!r:.80}", "a Line(end) or an Arc(end, centre)")
            elif isinstance(piece, Arc) and not isinstance(piece.clockwise, bool):
                yield Fault(f"{self.where}, piece {number}, clockwise", repr(piece.clockwise), "True or False")
        for label, place in self._places():
            if not _is_place(place):
                yield Fault(f"{self.where}, {label}", f"{place!r:.80}", "a point of the plane, (x, y)")

    def _shape_faults(self) -> Iterator[Fault]:
        rows = self._numbers()
        if not all(map(math.isfinite, (value for row in rows for place in row for value in place))):
            return  # which the audit of the quantities reports
        points = [row[0] for row in rows] + [rows[-1][1]]
        size = max(math.dist(a, b) for row in rows for a in row for b in row)
        wrong = [fault for k, row in enumerate(rows) for fault in self._piece_faults(k, row, size)]
        apart = math.dist(points[-1], points[0])
        if self.closed and apart > ALIKE * size:
            wrong.append(Fault(self.where, f"ends {apart:.3g} m apart", "a closed chain, whose last piece ends at its start",
                               f"End with Line({self.start!r}), or closed=False."))  # fmt: skip
        yield from wrong
        if wrong:
            return
        for k, bend in self._corners():
            if abs(bend) > BACK:
                yield Fault(f"{self.where}, piece {k + 1}", "it turns back at its end", "a piece that goes on beside the next, not into it",
                            "An angle between them, or one arc round the tip.")  # fmt: skip
        drawn, number = self._drawn()
        if self.closed and sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise(drawn)) < 0:
            yield Fault(self.where, "a closed chain that runs clockwise", "one that runs counterclockwise",
                        "List its pieces in the other order; for a solid outside it use hole=True.")  # fmt: skip
        crossed = crossing(drawn, self.closed)
        if crossed is not None:
            first, second = (number[k] for k in crossed)
            yield Fault(self.where, f"it crosses or touches itself, in its pieces {first} and {second}",
                        "a chain that does not: one side of it is solid")  # fmt: skip

    def _piece_faults(self, k: int, row: Sequence[Numbers], size: float) -> Iterator[Fault]:
        """Faults of a piece's length and radius."""
        where, (start, end, centre) = f"{self.where}, piece {k + 1}", row
        round_whole = isinstance(self.pieces[k], Arc) and self.closed and len(self.pieces) == 1
        if math.dist(start, end) <= ALIKE * size and not round_whole:
            yield Fault(where, "a piece of no length", "an end that is not its start")
        if isinstance(self.pieces[k], Arc):
            radii = math.dist(start, centre), math.dist(end, centre)
            if min(radii) <= ALIKE * size:
                yield Fault(where, "an arc whose centre is at its end", "a centre beside the arc")
            elif abs(radii[0] - radii[1]) > ALIKE * size:
                yield Fault(where, f"a start {radii[0]:.6g} m and an end {radii[1]:.6g} m from the centre", "both as far: the radius",
                            "The start of a piece is the end of the one before.")  # fmt: skip

    @cached_property
    def _rows(self) -> tuple[tuple[Any, ...], ...]:
        """Start, end and centre of each piece; a closed chain ends exactly where it starts."""
        ends = [piece.end for piece in self.pieces]
        if self.closed and _alike(ends[-1], self.start):
            ends[-1] = self.start
        starts = [self.start, *ends[:-1]]
        return tuple(
            (start, end, piece.centre if isinstance(piece, Arc) else start)
            for start, end, piece in zip(starts, ends, self.pieces, strict=True)
        )

    def _numbers(self) -> list[tuple[Numbers, Numbers, Numbers]]:
        return [tuple((default_value(x), default_value(y)) for x, y in row) for row in self._rows]  # type: ignore[misc]

    def _corners(self) -> Iterator[tuple[int, float]]:
        """Yield pieces and the angles [rad] by which the chain turns at their ends."""
        ways = [_ways(row, piece) for row, piece in zip(self._numbers(), self.pieces, strict=True)]
        for k, (one, other) in enumerate(pairwise([*ways, ways[0]] if self.closed else ways)):
            yield k, angle_between(one[1], other[0])

    @cached_property
    def sound(self) -> bool:
        """Whether it has no faults, and values for all coordinates."""
        return not any(self.faults()) and _is_sound(self)

    def corner(self) -> int | None:
        """Number of the first piece that ends in a corner; None of a smooth chain, and of one with faults."""
        if not self.sound:
            return None
        return next((k + 1 for k, bend in self._corners() if abs(bend) > SMOOTH), None)

    def _drawn(self) -> tuple[list[Numbers], list[int]]:
        """Points along the chain, and of each the number of its piece."""
        points: list[Numbers] = []
        numbers: list[int] = []
        for number, (piece, (start, end, centre)) in enumerate(zip(self.pieces, self._numbers(), strict=True), 1):
            turn = piece.turn if isinstance(piece, Arc) else 0
            swept = _swept(start, end, centre, turn) if turn else 0.0
            steps = max(math.ceil(abs(swept) / STEP), 1)
            u = start[0] - centre[0], start[1] - centre[1]
            for angle in accumulate([swept / steps] * (steps - 1), initial=0.0):
                c, s = math.cos(angle), math.sin(angle)
                points.append((centre[0] + u[0] * c - u[1] * s, centre[1] + u[0] * s + u[1] * c))
                numbers.append(number)
        return [*points, points[0] if self.closed else self._numbers()[-1][1]], numbers

    @cached_property
    def tips(self) -> tuple[tuple[tuple[int, ...], tuple[int, ...]], ...]:
        """Convex corners and rounded ones, which touch another outline first: corners and arcs, by number.

        A corner has the number of the piece that begins there. Arcs that follow each other are one tip, with their ends.
        """
        count, side = len(self.pieces), -1 if self.hole else 1
        bends = {(k + 1) % count if self.closed else k + 1: side * bend for k, bend in self._corners()}
        round_ = [isinstance(piece, Arc) and piece.turn == side for piece in self.pieces]
        tips: list[tuple[list[int], list[int]]] = [([], [])]
        for k in range(count if self.closed else count + 1):
            bend = bends.get(k, 1.0)  # the ends of an open chain have none
            beside = round_[k - 1] or round_[k % count]
            if bend > SMOOTH or (beside and bend > -SMOOTH):
                tips[-1][0].append(k)
            else:
                tips.append(([], []))
            if k < count and round_[k]:
                tips[-1][1].append(k)
            else:
                tips.append(([], []))
        if self.closed and len(tips) > 1:  # from the last piece to the first
            last = tips.pop()
            tips[0] = (last[0] + tips[0][0], last[1] + tips[0][1])
        return tuple((tuple(corners), tuple(arcs)) for corners, arcs in tips if corners or arcs)

    @cached_property
    def thickness(self) -> float:
        """Half of its solid's least thickness, relative to the sum of its pieces' lengths and radii."""
        points, _ = self._drawn()
        edges, least, side = list(pairwise(points)), math.inf, -1 if self.hole else 1
        for k, (a, b) in enumerate(edges):
            size = math.dist(a, b)
            n = side * (a[1] - b[1]) / size, side * (b[0] - a[0]) / size
            for share in (0.25, 0.5, 0.75):
                p = a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
                hits = (_way_to(p, n, c, d) for j, (c, d) in enumerate(edges) if j != k)
                least = min([least, *(way for way in hits if way > 0)])
        sizes = (math.dist(end if isinstance(piece, Line) else centre, start) for piece, (start, end, centre) in
                 zip(self.pieces, self._numbers(), strict=True))  # fmt: skip
        return float(f"{min(least / 2 / sum(sizes), 1.0):.6g}")

    def points(self, tips: Sequence[tuple[tuple[int, ...], tuple[int, ...]]]) -> ChainPoints:
        """Corners and arcs of some tips, for equations."""
        corners, arcs = (tuple(k for tip in tips for k in tip[i]) for i in (0, 1))
        return ChainPoints(name=self.name, corners=corners, arcs=arcs, thick=self.thickness)

    @cached_property
    def planar(self) -> PlanarChain:
        """The chain, for equations."""
        rows = tuple(tuple(sp.sympify(value) for place in row for value in place) for row in self._rows)
        return PlanarChain(
            name=self.name,
            pieces=rows,
            turns=tuple(piece.turn if isinstance(piece, Arc) else 0 for piece in self.pieces),
            parameters=tuple(dict.fromkeys(p for row in rows for value in row for p in parameters_of(value))),
            closed=self.closed,
            hole=self.hole,
        )


def _is_place(place: Any) -> bool:
    return isinstance(place, tuple) and len(place) == 2


def _is_sound(chain: Outline) -> bool:
    """Whether all coordinates have values; else the audit of the quantities reports them."""
    values = [slot.value for slot in chain.slots()]
    symbols = [node for value in values if is_number(value) for node in sp.sympify(value).free_symbols]
    return all(map(is_number, values)) and all(isinstance(p, Parameter) and not any(p.faults()) for p in symbols)


def _alike(one: Place, other: Place) -> bool:
    """Whether two points are the same at the defaults."""
    (ax, ay), (bx, by) = ((default_value(x), default_value(y)) for x, y in (one, other))
    return math.hypot(bx - ax, by - ay) <= ALIKE * max(map(abs, (ax, ay, bx, by)), default=0.0)


def _swept(start: Numbers, end: Numbers, centre: Numbers, turn: int) -> float:
    """Angle of an arc [rad], negative to the right."""
    angle = turn * angle_between(*((x - centre[0], y - centre[1]) for x, y in (start, end)))
    return turn * (angle if angle > 0 else angle + 2 * math.pi)


def _way_to(p: Numbers, n: Numbers, a: Numbers, b: Numbers) -> float:
    """Way from a point along a direction to a straight edge; infinite where it misses it."""
    way = b[0] - a[0], b[1] - a[1]
    across = n[0] * way[1] - n[1] * way[0]
    if abs(across) <= ALIKE * math.hypot(*way):
        return math.inf
    w = a[0] - p[0], a[1] - p[1]
    share = (w[0] * n[1] - w[1] * n[0]) / across
    return (w[0] * way[1] - w[1] * way[0]) / across if 0 <= share <= 1 else math.inf


def _ways(row: tuple[Numbers, Numbers, Numbers], piece: Piece) -> tuple[Numbers, Numbers]:
    """Directions of a piece at its start and end."""
    start, end, centre = row
    if isinstance(piece, Line):
        way = end[0] - start[0], end[1] - start[1]
        return way, way
    one, other = ((piece.turn * (centre[1] - y), piece.turn * (x - centre[0])) for x, y in (start, end))
    return one, other
