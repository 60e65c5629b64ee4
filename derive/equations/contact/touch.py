"""Contact geometry of a pair: gap and its rates, penetration, normal, contact point.

A pair pushes its first place along the unit vector `normal`. The gap is a smooth event function (no square root where
the distance may vanish); it equals minus the penetration to first order at contact, so its rate at the onset is minus
the approach speed. Exact penetration and normal appear in the contact's own function alone, which is evaluated in
contact only.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.equations.contact.worn_surfaces import worn_at
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.probe import Probe
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, cross, dot, scale, sub
from hertzwerk.derive.expressions.dimension.dimension import Dimension

DEPTH = 1e-4
"""Penetration at which a user's pair is tested, relative to the mechanism's size."""
ROUNDING = 1e-7
"""Relative tolerance for rounding in double precision."""


class Touch:
    """Common part of all pairs: `first` and `second` place, and `apart`, from the second to the first.

    `position` is the point on the line of action at which material velocities are taken [m].
    """

    proved: ClassVar[bool] = False
    """Whether gap and normal are known to be consistent; else they are tested at random states."""
    limit: Any = None
    """Penetration up to which the geometry holds [m]; None without a limit."""

    def __init__(self, pair: Pair, kinematics: Kinematics) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.pair: Any = pair
        self.first, self.second = pair.places
        one, one_rate, one_second = kinematics.point(self.first, f"{pair.name}_{pair.labels[0]}")
        two, two_rate, two_second = kinematics.point(self.second, f"{pair.name}_{pair.labels[1]}")
        self.centre, self.base = one, two
        self.apart = self.named(sub(one, two), "apart")
        apart_rate = self.named(sub(one_rate, two_rate), "apart_rate")
        second = self.named(sub(one_second, two_second), "apart_acceleration")
        for a, b, c in zip(self.apart, apart_rate, second, strict=True):
            self.tape.set_rate(a, b)
            self.tape.set_rate(b, c)

    def let(self, expression: Any, label: str, dimension: Dimension | None = None) -> Any:
        """Name a result of this pair on the tape."""
        return self.tape.let(expression, f"{self.pair.name}_{label}", dimension)

    def named(self, vector: Vector, label: str) -> Vector:
        """Name a vector of this pair on the tape."""
        return self.tape.vector(vector, f"{self.pair.name}_{label}")

    @cached_property
    def worn(self) -> Any:
        """Worn surfaces, a `Worn`; None without wear."""
        return worn_at(self)

    @property
    def stretch(self) -> Any:
        """Normal force over that along the penetration: the length of its gradient [1]; None where it is 1."""
        return self.worn and self.worn.stretch

    @property
    def gap(self) -> Any:
        """Event function, positive while open [m]."""
        raise NotImplementedError

    @property
    def penetration(self) -> Any:
        """Penetration, positive in contact [m]."""
        return self.let(-self.gap, "penetration")

    @property
    def normal(self) -> Vector:
        """Unit vector along which the first place is pushed."""
        raise NotImplementedError

    @property
    def position(self) -> Vector:
        """First place, through which the line of action passes [m]."""
        return self.centre

    @cached_property
    def gap_rate(self) -> Any:
        """Rate of the gap [m/s]."""
        return self.tape.rate(self.gap, f"{self.pair.name}_gap_rate")

    @cached_property
    def gap_acceleration(self) -> Any:
        """Second derivative of the gap [m/s^2]."""
        return self.tape.rate(self.gap_rate, f"{self.pair.name}_gap_acceleration")

    @cached_property
    def contact_point(self) -> Vector:
        """Contact point, on the first body's surface [m]."""
        return add(self.position, scale(-sp.sympify(self.pair.first_radius), self.normal))

    @cached_property
    def penetration_rate(self) -> Any:
        """Approach speed of both bodies' material points at the first place along the normal [m/s].

        The normal turns with the second body. On a worn contour it is that along the gradient of the penetration.
        """
        along = dot(self.normal, self.relative_rate)
        return self.let(
            -along if self.stretch is None else self.worn.spin_rate - self.stretch * along, "penetration_rate"
        )

    @cached_property
    def relative_rate(self) -> Vector:
        """Velocity of the first body's material point at `position` against the second's there [m/s]."""
        return self.named(self.rate_at(self.position), "relative_rate")

    def rate_at(self, position: Vector) -> Vector:
        """Velocity of the first body's point at `position` against the second body's [m/s]."""
        one, two = (self.kin.velocity_at(place.body, position) for place in (self.first, self.second))
        return sub(one, two)

    @cached_property
    def plane_of_motion(self) -> Vector | None:
        """Coordinate axis normal to the plane of motion; None where that is not structurally plane."""
        rate = self.rate_at(self.contact_point)
        for k in (2, 1, 0):
            if self.normal[k] == 0 and rate[k] == 0:
                x, y, z = (sp.Integer(int(i == k)) for i in range(3))
                return (x, y, z)
        return None

    @cached_property
    def tangents(self) -> tuple[Vector, ...]:
        """Unit vectors along which the first body may slide on the second: one in plane motion, else two."""
        plane = self.plane_of_motion
        along = tangents_of(self.normal) if plane is None else (cross(plane, self.normal),)
        return tuple(self.named(tangent, "tangent") for tangent in along)

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Named quantities of the pair: (name, unit, expression)."""
        return [(f"{self.pair.name}.gap", "m", -self.penetration)]

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield faults that only the derived motion shows; `length` [m] is the size of the mechanism."""
        if self.proved:
            return
        where = f"pair {self.pair.name}"
        if self.pair.journal and not any(".eccentricity_" in name for name, *_ in self.outputs()):
            yield Fault(where, "a journal without an eccentricity", "outputs of its Touch, PAIR.eccentricity_x, _y, _z, that "
                        "vanish where it is centred")  # fmt: skip
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


def tangents_of(normal: Vector) -> tuple[Vector, Vector]:
    """Two unit vectors that are normal to a unit vector and to each other, with its structural zeros.

    In general there is no such pair that depends on the normal smoothly: it then jumps where the third component changes
    sign. Duff et al., Building an orthonormal basis, revisited, J. Comput. Graphics Techniques 6 (2017) 1.
    """
    for k in (2, 1, 0):
        if normal[k] == 0:
            x, y, z = (sp.Integer(int(i == k)) for i in range(3))
            return (x, y, z), cross((x, y, z), normal)
    x, y, z = normal
    sign = Where(z >= 0, 1, -1)
    share = -1 / (sign + z)
    return (1 + sign * x**2 * share, sign * x * y * share, -sign * x), (x * y * share, sign + y**2 * share, -y)
