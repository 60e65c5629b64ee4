"""Where two surfaces touch: gap, gap rates, penetration, normal and contact point of every kind of pair.

A pair pushes its first place along the unit vector `normal`. The gap is a smooth event function (no square root where the distance may vanish);
it equals minus the penetration to first order at contact, so its rate at the onset is minus the approach speed. Penetration and normal proper
appear in the contact's own function alone, which is evaluated in contact only.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.vectors import Vector, add, apply, dot, multiply, scale, sub, transpose
from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.effects.expression import as_choice
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.pairs import (
    APART,
    TURN,
    BallInSocket,
    CornerOnFace,
    CustomPair,
    CylinderOnPlane,
    Pair,
    ParallelCylinders,
    PinInBush,
    RimOnPlane,
    SphereOnPlane,
)
from hertzwerk.derive.motion.kinematics import Kinematics
from hertzwerk.derive.motion.probe import Probe

DEPTH = 1e-4
"""Penetration at which a user's pair is tried, in lengths of the mechanism."""
ROUNDING = 1e-7
"""Relative, of numbers from double precision."""
PLACES = {"pin_in_bush": ("pin", "bush"), "ball_in_socket": ("ball", "socket")}
"""What the places of a pair are called; else first and second."""


def touch(kinematics: Kinematics, pair: Pair) -> Touch:
    """The geometry of a pair on its kinematics' tape."""
    kinds: dict[type, type[Touch]] = {
        SphereOnPlane: Face,
        CylinderOnPlane: LyingCylinder,
        CornerOnFace: BoundedFace,
        RimOnPlane: Rim,
        CustomPair: Custom,
    }
    return kinds.get(type(pair), Round)(kinematics, pair)


class Touch:
    """What every pair has: `first` and `second` place, the vector `apart` from the second to the first, and `position`, the point on the line of
    action that material velocities are taken at [m]."""

    def __init__(self, kinematics: Kinematics, pair: Pair) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.pair: Any = pair
        self.first, self.second = pair.places
        names = PLACES.get(pair.kind, ("first", "second"))
        one, one_rate, one_second = kinematics.point(self.first, f"{pair.name}_{names[0]}")
        two, two_rate, two_second = kinematics.point(self.second, f"{pair.name}_{names[1]}")
        self.centre, self.base = one, two
        self.apart = self.named(sub(one, two), "apart")
        apart_rate = self.named(sub(one_rate, two_rate), "apart_rate")
        second = self.named(sub(one_second, two_second), "apart_acceleration")
        for a, b, c in zip(self.apart, apart_rate, second, strict=True):
            self.tape.set_rate(a, b)
            self.tape.set_rate(b, c)

    def let(self, expression: Any, what: str, dimension: Dimension | None = None) -> Any:
        """Name a result of this pair on the tape."""
        return self.tape.let(expression, f"{self.pair.name}_{what}", dimension)

    def named(self, vector: Vector, what: str) -> Vector:
        """Name a vector of this pair on the tape."""
        return self.tape.vector(vector, f"{self.pair.name}_{what}")

    @property
    def gap(self) -> Any:
        """Event function, positive while open [m]."""
        raise NotImplementedError

    @property
    def penetration(self) -> Any:
        """[m], positive in contact."""
        return self.let(-self.gap, "penetration")

    @property
    def normal(self) -> Vector:
        """Unit vector along which the first place is pushed."""
        raise NotImplementedError

    @property
    def position(self) -> Vector:
        """The first place: the line of action passes through it [m]."""
        return self.centre

    @cached_property
    def gap_rate(self) -> Any:
        """[m/s]."""
        return self.tape.rate(self.gap, f"{self.pair.name}_gap_rate")

    @cached_property
    def gap_acceleration(self) -> Any:
        """[m/s^2]."""
        return self.tape.rate(self.gap_rate, f"{self.pair.name}_gap_acceleration")

    @cached_property
    def contact_point(self) -> Vector:
        """The point both bodies touch at, on the first body's surface [m]."""
        return add(self.position, scale(-sp.sympify(self.pair.first_radius), self.normal))

    @cached_property
    def penetration_rate(self) -> Any:
        """[m/s]: the material points of both bodies at the first place approach along the normal, which turns with the second."""
        return self.let(-dot(self.normal, self.relative_rate), "penetration_rate")

    @cached_property
    def relative_rate(self) -> Vector:
        """Velocity of the first body's material point at `position` against the second's there [m/s]."""
        return self.named(self.rate_at(self.position), "relative_rate")

    def rate_at(self, position: Vector) -> Vector:
        """Velocity of the first body's point at `position` against the second body's [m/s]."""
        one, two = (self.kin.velocity_at(place.body, position) for place in (self.first, self.second))
        return sub(one, two)

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Named quantities of the pair: (name, unit, expression)."""
        return [(f"{self.pair.name}.gap", "m", -self.penetration)]

    def faults(self, length: float) -> Iterator[Fault]:
        """What only the derived motion shows to be wrong; `length` [m] is the size of the mechanism."""
        yield from ()


class Round(Touch):
    """Spheres or parallel cylinders, one on or in the other."""

    @cached_property
    def eccentricity(self) -> Vector:
        """From centre to centre, of cylinders across the axis [m]."""
        if not isinstance(self.pair, PinInBush | ParallelCylinders):
            return self.apart
        axis = self.named(self.kin.direction(self.second, self.pair.axis), "direction")
        along = self.let(dot(self.apart, axis), "along")
        return self.named(sub(self.apart, scale(along, axis)), "e")

    @cached_property
    def _reach(self) -> Any:
        """Centre distance at which contact begins [m]."""
        if self.pair.inside:
            return sp.sympify(self.pair.clearance)
        return self.let(self.pair.radius_first + self.pair.radius_second, "reach")

    @cached_property
    def gap(self) -> Any:
        """(reach^2 - e.e)/(2 reach) inside, its opposite outside: smooth through the centre."""
        reach = self._reach
        squared = self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (reach**2 - squared) / (2 * reach), "gap")

    @cached_property
    def _distance(self) -> Any:
        return self.let(sp.sqrt(self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")), "distance")

    @cached_property
    def normal(self) -> Vector:
        """From the other centre, or inside towards it."""
        sign = -1 if self.pair.inside else 1
        return self.named(scale(sign / self._distance, self.eccentricity), "normal")

    @cached_property
    def penetration(self) -> Any:
        """Of the true distance [m]."""
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (self._distance - self._reach), "penetration")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Inside: the eccentricity in the axes of the second; what is zero by structure is left out."""
        if not self.pair.inside:
            return super().outputs()
        local = apply(transpose(self.kin.axes_of(self.second)), self.eccentricity)
        ball = isinstance(self.pair, BallInSocket)
        across = [k for k in range(3) if (local[k] != 0 if ball else self.pair.axis.components[k] == 0)]
        return [
            (f"{self.pair.name}.eccentricity_{'xyz'[k]}", "m", self.let(local[k], f"eccentricity_{'xyz'[k]}"))
            for k in across
        ]


class Face(Touch):
    """A plane, and a sphere, a cylinder or a corner on it."""

    @cached_property
    def normal(self) -> Vector:
        """The plane's."""
        return self.named(self.kin.direction(self.second, self.pair.normal), "direction")

    @cached_property
    def gap(self) -> Any:
        """Height over the plane, less the radius."""
        return self.let(dot(self.normal, self.apart) - sp.sympify(self.pair.first_radius), "gap")


class LyingCylinder(Face):
    """A cylinder whose axis stays parallel to the plane."""

    def faults(self, length: float) -> Iterator[Fault]:
        """An axis that may tilt."""
        axis = self.kin.direction(self.first, self.pair.axis)
        if dot(axis, self.normal) != 0:
            yield Fault(f"pair {self.pair.name}", f"a cylinder on {self.first.body.name} that may tilt against the plane",
                        "an axis that the joints keep parallel to it: a line contact would become a point at a jump",
                        "Give it a RimOnPlane for each end.")  # fmt: skip


class BoundedFace(Touch):
    """A plane face that ends, with the solid below it: the gap is the greater of the height over the face and the way beyond its ends."""

    @cached_property
    def _directions(self) -> tuple[Vector, Vector | None]:
        along = self.pair.along
        return (
            self.named(self.kin.direction(self.second, self.pair.normal), "direction"),
            None if along is None else self.named(self.kin.direction(self.second, along), "line"),
        )

    @cached_property
    def _height(self) -> Any:
        return self.let(dot(self._directions[0], self.apart), "height")

    @cached_property
    def _ends(self) -> tuple[Any, Any] | None:
        """Which end is nearer, a condition, and the way beyond it [m]; None where there is none."""
        if self._directions[1] is None:
            return None
        way = self.let(dot(self._directions[1], self.apart), "way")
        beyond = Where(way > 0, way, -way) - sp.sympify(self.pair.length) / 2
        return way > 0, self.let(beyond, "beyond")

    def _nearest(self, face: Any, end: Any, what: str) -> Any:
        """What holds for the face while the corner is nearer to it than to the end, else what holds for the end."""
        if self._ends is None:
            return face
        return self.let(Where(self._height > self._ends[1], face, end), what)

    def _outwards(self, value: Any, what: str) -> Any:
        """Along the face, towards the nearer end."""
        return 0 if self._ends is None else self.let(Where(self._ends[0], value, -value), what)

    @cached_property
    def gap(self) -> Any:
        """Of the corner to the solid [m]; beside an edge of it, outside, the greater of both ways, so that it has the right sign everywhere."""
        return self._nearest(self._height, None if self._ends is None else self._ends[1], "gap")

    @cached_property
    def _rates(self) -> tuple[Any, Any]:
        """Of the height and of the way [m/s]."""
        name, line = self.pair.name, self._directions[1]
        height = self.tape.rate(self._height, f"{name}_height_rate")
        return height, 0 if line is None else self.tape.rate(self.let(dot(line, self.apart), "way"), f"{name}_way_rate")

    @cached_property
    def gap_rate(self) -> Any:
        """[m/s]."""
        height, way = self._rates
        return self._nearest(height, self._outwards(way, "beyond_rate"), "gap_rate")

    @cached_property
    def gap_acceleration(self) -> Any:
        """[m/s^2]."""
        height, way = (self.tape.rate(rate, f"{self.pair.name}_second") for rate in self._rates)
        return self._nearest(height, self._outwards(way, "beyond_acceleration"), "gap_acceleration")

    @cached_property
    def normal(self) -> Vector:
        """The face's; beyond an end outwards there."""
        normal, along = self._directions
        if self._ends is None or along is None:
            return normal
        far, beyond = self._ends
        ex, ey, ez = (_choice(far, component, -component) for component in along)
        end = self.named((ex, ey, ez), "end")
        on_face = self._height > beyond
        x, y, z = (_choice(on_face, face, side) for face, side in zip(normal, end, strict=True))
        return self.named((x, y, z), "normal")


class Rim(Touch):
    """The lowest point of a disc's rim over a plane."""

    @cached_property
    def normal(self) -> Vector:
        """The plane's."""
        return self.named(self.kin.direction(self.second, self.pair.normal), "direction")

    @cached_property
    def _up(self) -> tuple[Vector, Any]:
        """Of the normal what lies in the disc, and its length [1]."""
        axis = self.named(self.kin.direction(self.first, self.pair.axis), "axis")
        tilt = self.let(dot(self.normal, axis), "tilt")
        up = self.named(sub(self.normal, scale(tilt, axis)), "up")
        return up, self.let(sp.sqrt(1 - tilt**2), "rise")

    @cached_property
    def gap(self) -> Any:
        """Height of the lowest point."""
        return self.let(dot(self.normal, self.apart) - self.pair.radius * self._up[1], "gap")

    @cached_property
    def position(self) -> Vector:
        """The lowest point."""
        up, rise = self._up
        return add(self.centre, self.named(scale(-self.pair.radius / rise, up), "rim"))


class Custom(Touch):
    """Surfaces of the user's."""

    @cached_property
    def _pose(self) -> dict[Any, Any]:
        """The user's symbols on the tape."""
        back = transpose(self.kin.axes_of(self.second))
        apart = self.named(apply(back, self.apart), "local_apart")
        turn = self.tape.matrix(multiply(back, self.kin.axes_of(self.first)), f"{self.pair.name}_turn")
        rows = zip(TURN, turn, strict=True)
        return dict(zip(APART, apart, strict=True)) | {s: v for row in rows for s, v in zip(*row, strict=True)}

    def _stated(self, value: Any) -> Any:
        return as_choice(value).xreplace(self._pose)

    def _in_ground(self, components: Any, what: str) -> Vector:
        x, y, z = (self._stated(value) for value in components)
        local = self.named((x, y, z), f"local_{what}")
        return self.named(apply(self.kin.axes_of(self.second), local), what)

    @cached_property
    def gap(self) -> Any:
        """As stated."""
        return self.let(self._stated(self.pair.gap), "gap")

    @cached_property
    def normal(self) -> Vector:
        """As stated."""
        return self._in_ground(self.pair.normal, "normal")

    @cached_property
    def position(self) -> Vector:
        """The contact point."""
        return add(self.base, self._in_ground(self.pair.contact_point, "contact_arm"))

    def faults(self, length: float) -> Iterator[Fault]:
        """A normal that is no unit vector, a gap that is no distance: seen at random states of contact."""
        where = f"pair {self.pair.name}"
        probe = Probe(self.kin, length)
        states = probe.states_where(self.gap, self.gap_rate, -DEPTH * length)
        if not states:
            yield Fault(f"{where}, gap", "no position where it is negative", "surfaces that can touch",
                        "It was followed downhill from random positions: are its signs and units right?")  # fmt: skip
        for state in states:
            try:
                x, y, z, rate, approach = probe.values([*self.normal, self.gap_rate, self.penetration_rate], state)
            except (ValueError, TypeError, ZeroDivisionError, KeyError):
                yield Fault(f"{where}, normal", "no number at a position of contact", "a unit vector and a point there")
                return
            size = (x * x + y * y + z * z) ** 0.5
            if abs(size - 1) > ROUNDING:
                yield Fault(f"{where}, normal", f"a length of {size:.6g} where the gap is closed", "a unit vector",
                            "Divide it by its length.")  # fmt: skip
                return
            if abs(rate + approach) > ROUNDING * (abs(rate) + abs(approach)):
                yield Fault(f"{where}, gap", f"a rate of {rate:.6g} m/s where the bodies approach at {approach:.6g} m/s",
                            "the distance of the surfaces, which shrinks as they approach along the normal at the contact point",
                            "Are normal and contact point along the axes of the second place, and on the side of the first body?")  # fmt: skip
                return


def _choice(condition: Any, a: Any, b: Any) -> Any:
    return a if a == b else Where(condition, a, b)
