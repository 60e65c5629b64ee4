"""Contact pairs: gap, gap rates, penetration, normal, contact point; and the forces their laws give.

A pair pushes its first place along the unit vector `normal`. The gap is a smooth event function (no square root where the distance may vanish);
it equals minus the penetration to first order at contact, so its rate at the onset is minus the approach speed. Penetration and normal proper
appear in the contact's own function alone, which is evaluated in contact only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.dimension import Dimension
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.functions import Where
from hertzwerk.derive.kinematics import Kinematics
from hertzwerk.derive.laws.law import BRISTLE, GEOMETRY, BoundLaw, F, N, Quantity, d, k_t, s, v, v0
from hertzwerk.derive.mechanism import Pair, ParallelCylinders, PinInBush, SphereOnPlane
from hertzwerk.derive.scene import Contact, Friction
from hertzwerk.derive.units import parse_unit
from hertzwerk.derive.vectors import Vector, add, apply, cross, dot, scale, sub, transpose

NEWTON = Dimension.from_unit(parse_unit("N"), {})
JOULE = Dimension.from_unit(parse_unit("J"), {})
STIFFNESS = Dimension.from_unit(parse_unit("N/m"), {})
DRAG = Dimension.from_unit(parse_unit("N s/m"), {})
PACE = Dimension.from_unit(parse_unit("m/s"), {})
METRE = Dimension.from_unit(parse_unit("m"), {})
PURE = Dimension.from_unit(parse_unit("1"), {})


@dataclass(frozen=True)
class Grip:
    """Friction whose force depends on slip and stick: generalised force by joint per newton on the first body along the tangent, along which the
    sliding velocity counts; and the forces [N] while sliding and that are held at rest.
    """

    along: dict[str, Any]
    sliding: Any
    holding: Any


@dataclass(frozen=True)
class Forces:
    """What a contact does: generalised forces by joint, dissipated powers [W], normal force [N], sliding velocity [m/s] or None, range.

    bristle_rate [m/s]: of friction with a bristle, else None. grip: of friction with modes, which `generalised` and `friction_power` then lack.
    """

    generalised: dict[str, Any]
    normal_power: Any
    friction_power: Any
    normal_force: Any
    sliding_velocity: Any
    in_range: Any
    bristle_rate: Any = None
    grip: Grip | None = None


class PairKinematics:
    """One pair of a scene on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, pair: Pair, geometry: dict[str, Any]) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.pair = pair
        self._geometry = {quantity: geometry[quantity.name] for quantity in GEOMETRY if quantity.name in geometry}
        self.first, self.second = pair.places
        name = pair.name
        one, one_rate, one_second = kinematics.point(
            self.first, f"{name}_{'pin' if isinstance(pair, PinInBush) else 'first'}"
        )
        two, two_rate, two_second = kinematics.point(
            self.second, f"{name}_{'bush' if isinstance(pair, PinInBush) else 'second'}"
        )
        self.position = one
        self.apart = self._named(sub(one, two), "apart")
        self.apart_rate = self._named(sub(one_rate, two_rate), "apart_rate")
        second = self._named(sub(one_second, two_second), "apart_acceleration")
        for a, b, c in zip(self.apart, self.apart_rate, second, strict=True):
            self.tape.set_rate(a, b)
            self.tape.set_rate(b, c)

    def _named(self, vector: Vector, what: str) -> Vector:
        return self.tape.vector(vector, f"{self.pair.name}_{what}")

    def let(self, expression: Any, what: str, dimension: Dimension | None = None) -> Any:
        """Name a result of this pair on the tape."""
        return self.tape.let(expression, f"{self.pair.name}_{what}", dimension)

    # -- geometry --------------------------------------------------------------------------------------------------

    @cached_property
    def _direction(self) -> Vector:
        """Of a plane's normal or a bush's axis, ground axes."""
        local = self.pair.normal if isinstance(self.pair, SphereOnPlane) else self.pair.axis  # type: ignore[union-attr]
        return self._named(self.kin.direction(self.second, local), "direction")

    @cached_property
    def eccentricity(self) -> Vector:
        """Of a pin: centre to centre, across the bush's axis; of spheres: centre to centre [m]."""
        if not isinstance(self.pair, PinInBush | ParallelCylinders):
            return self.apart
        along = self.let(dot(self.apart, self._direction), "along")
        return self._named(sub(self.apart, scale(along, self._direction)), "e")

    @cached_property
    def gap(self) -> Any:
        """Event function, positive while open [m]."""
        if isinstance(self.pair, SphereOnPlane):
            return self.let(dot(self._direction, self.apart) - self.pair.radius, "gap")
        reach = self._reach
        squared = self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (reach**2 - squared) / (2 * reach), "gap")

    @cached_property
    def _reach(self) -> Any:
        """Centre distance at which contact begins [m]."""
        if isinstance(self.pair, PinInBush):
            return sp.sympify(self.pair.clearance)
        return self.let(self.pair.radius_first + self.pair.radius_second, "reach")  # type: ignore[union-attr]

    @cached_property
    def gap_rate(self) -> Any:
        """[m/s]."""
        return self.tape.rate(self.gap, f"{self.pair.name}_gap_rate")

    @cached_property
    def gap_acceleration(self) -> Any:
        """[m/s^2]."""
        return self.tape.rate(self.gap_rate, f"{self.pair.name}_gap_acceleration")

    @cached_property
    def _distance(self) -> Any:
        return self.let(sp.sqrt(self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")), "distance")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector along which the first place is pushed."""
        if isinstance(self.pair, SphereOnPlane):
            return self._direction
        sign = -1 if self.pair.inside else 1
        return self._named(scale(sign / self._distance, self.eccentricity), "normal")

    @cached_property
    def penetration(self) -> Any:
        """[m], positive in contact."""
        if isinstance(self.pair, SphereOnPlane):
            return self.let(-self.gap, "penetration")
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (self._distance - self._reach), "penetration")

    @cached_property
    def penetration_rate(self) -> Any:
        """[m/s]: the material points of both bodies at the first place approach along the normal, which turns with the second."""
        return self.let(-dot(self.normal, self.relative_rate), "penetration_rate")

    @cached_property
    def relative_rate(self) -> Vector:
        """Velocity of the first place against the second body's material point there [m/s]."""
        return self._named(self._rate_at(self.position), "relative_rate")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Named quantities of the pair: (name, unit, expression)."""
        name = self.pair.name
        if not isinstance(self.pair, PinInBush):
            return [(f"{name}.gap", "m", -self.penetration)]
        local = apply(transpose(self.kin.axes_of(self.second)), self.eccentricity)
        across = [k for k in range(3) if self.pair.axis.components[k] == 0]
        return [
            (f"{name}.eccentricity_{'xyz'[k]}", "m", self.let(local[k], f"eccentricity_{'xyz'[k]}")) for k in across
        ]

    # -- forces ----------------------------------------------------------------------------------------------------

    def _law(self, bound: BoundLaw, known: dict[sp.Symbol, Any], unchecked: bool = False) -> dict[sp.Symbol, Any]:
        """Law symbol -> tape: what the contact knows, bound parameters, geometry, definitions. Unchecked ones have the unit they claim."""
        values: dict[sp.Symbol, Any] = {**known, **bound.binding}
        for quantity in bound.law.geometry():
            values[quantity] = self.let(self._geometry[quantity], quantity.name)
        for symbol, expression in bound.law.definitions:
            stated = self._stated(symbol, values) if unchecked else None
            values[symbol] = self.let(expression.xreplace(values), symbol.name, stated)
        return values

    def _stated(self, symbol: Quantity, values: dict[sp.Symbol, Any]) -> Dimension:
        return Dimension.from_unit(parse_unit(symbol.unit), {s.name: value for s, value in values.items()})

    def elastic(self, contact: Contact) -> tuple[Any, Any]:
        """Elastic force [N] and stored energy [J], zero while open."""
        law = contact.stiffness.law
        values = self._law(contact.stiffness, {d: self.penetration}, contact.unchecked)
        stated = (NEWTON, JOULE) if contact.unchecked else (None, None)
        force = self.let(self._closed(law.force.xreplace(values)), "elastic_force", stated[0])
        return force, self.let(self._closed(law.work.xreplace(values)), "stored_energy", stated[1])

    def _closed(self, expression: Any) -> Any:
        """The expression while the pair penetrates, else 0."""
        return Where(self.penetration > 0, expression, 0)

    def _resistance(self, contact: Contact, damping: BoundLaw, elastic: Any, approach_speed: Any) -> Any:
        law, stated = damping.law, NEWTON if contact.unchecked else None
        known = {F: elastic, v: self.penetration_rate, d: self.penetration}
        if approach_speed is not None:
            known[v0] = approach_speed
        if k_t in law.quantities():
            stiffness = self._law(contact.stiffness, {d: self.penetration}, contact.unchecked)
            tangent = sp.diff(contact.stiffness.law.force, d).xreplace(stiffness)
            known[k_t] = self.let(self._closed(tangent), "tangent_stiffness", STIFFNESS if contact.unchecked else None)
        values = self._law(damping, known, contact.unchecked)
        if law.factor is not None:
            factor = self.let(law.factor.xreplace(values), "hysteresis_factor", PURE if contact.unchecked else None)
            return self.let(elastic * factor * self.penetration_rate / approach_speed, "resistance")
        return self.let(self._closed(law.resistance.xreplace(values)), "resistance", stated)

    def forces(self, contact: Contact, friction: Friction | None, approach_speed: Any, bristle: Any = None) -> Forces:
        """Everything the pair's effects do, from the latched approach speed [m/s] and the bristle's deflection [m] where there are such."""
        elastic, _ = self.elastic(contact)
        normal_force, normal_power = elastic, sp.S.Zero
        if contact.damping is not None:
            resistance = self._resistance(contact, contact.damping, elastic, approach_speed)
            normal_force = self.let(elastic + resistance, "normal_force")
            normal_power = self.let(resistance * self.penetration_rate, "normal_power")
        # The line of action passes through the first place's centre: the shorter arm does.
        push = self._named(scale(normal_force, self.normal), "push")
        generalised = self._on_joints(push, self.position, "push")
        if friction is None:
            return Forces(generalised, normal_power, sp.S.Zero, normal_force, None, self._in_range(contact))
        modes = bool(friction.law.law.modes)
        pulls = contact.damping is not None and contact.damping.law.release == "gap"
        pressing = normal_force
        if pulls or modes:
            pressing = self.let(Where(normal_force > 0, normal_force, 0), "pressing_force")
        if modes:
            grip, sliding = self._grip(friction, pressing)
            in_range = self._in_range(contact)
            return Forces(generalised, normal_power, sp.S.Zero, normal_force, sliding, in_range, grip=grip)
        drag, sliding, friction_power, bristle_rate = self._drag(friction, pressing, bristle)
        drag = self._named(drag, "drag")
        for joint, force in self._on_joints(drag, self.contact_point, "drag").items():
            generalised[joint] = generalised.get(joint, sp.S.Zero) + force
        in_range = self._in_range(contact)
        return Forces(generalised, normal_power, friction_power, normal_force, sliding, in_range, bristle_rate)

    def _on_joints(self, force: Vector, position: Vector, name: str) -> dict[str, Any]:
        return self.kin.generalised(force, position, self.first.body, self.second.body, f"{self.pair.name}_{name}")

    def _in_range(self, contact: Contact) -> Any:
        reach = contact.stiffness.law.reach
        if reach is None:
            return sp.S.One
        values = self._law(contact.stiffness, {}, contact.unchecked)
        limit = self.let(reach.xreplace(values), "penetration_limit", METRE if contact.unchecked else None)
        return self.let(Where(self.penetration <= limit, 1, 0), "in_range")

    @cached_property
    def contact_point(self) -> Vector:
        """The point both bodies touch at, on the first body's surface [m]."""
        return add(self.position, scale(-sp.sympify(self.pair.first_radius), self.normal))

    def friction_faults(self, friction: Friction) -> Iterator[Fault]:
        """A law with modes or memory needs a direction of sliding that is known: one along a line, as in plane motion."""
        law = friction.law.law
        if (law.modes or law.memory) and self._plane_of_motion() is None:
            found = f"law {law.name} at {self.pair.name}, whose bodies may slide in more than one direction"
            yield Fault(f"effect {friction.name}", found, "a contact in plane motion: one direction of sliding",
                        "smooth_coulomb, stribeck and brown_mcphee take sliding in any direction.")  # fmt: skip

    def _drag(self, friction: Friction, normal_force: Any, bristle: Any) -> tuple[Vector, Any, Any, Any]:
        """Friction force on the first body, sliding velocity, dissipated power, rate of the bristle or None."""
        law = friction.law.law
        plane = self._plane_of_motion()
        if plane is None:
            rate = self._named(self._rate_at(self.contact_point), "sliding_rate")
            slip = self._named(sub(rate, scale(self.let(dot(rate, self.normal), "along_rate"), self.normal)), "slip")
            sliding = self.let(sp.sqrt(self.let(dot(slip, slip), "slip_squared")), "sliding_velocity")
        else:
            tangent, sliding = self._sliding(plane)
        known = {N: normal_force, s: sliding} | ({} if bristle is None else {BRISTLE: bristle})
        values = self._law(friction.law, known, friction.unchecked)
        stated = (NEWTON, DRAG, PACE) if friction.unchecked else (None, None, None)
        force = self.let(law.force.xreplace(values), "friction_force", stated[0])
        power = self.let(force * sliding, "friction_power")
        if plane is None:
            slope = self.let(law.slope.xreplace(values), "friction_slope", stated[1])
            per_speed = self.let(Where(sliding > 0, force / sliding, slope), "friction_per_speed")
            return scale(-per_speed, slip), sliding, power, None
        rates = [self.let(rate.xreplace(values), "bristle_rate", stated[2]) for _, rate, _ in law.memory]
        return scale(-force, tangent), sliding, power, rates[0] if rates else None

    def bristle_size(self, friction: Friction) -> Any:
        """What the accuracy of the bristle is measured by [m]."""
        ((_, _, size),) = friction.law.law.memory
        return self.let(size.xreplace(friction.law.binding), "bristle_size", METRE if friction.unchecked else None)

    def _sliding(self, plane: Vector) -> tuple[Vector, Any]:
        """Tangent and sliding velocity along it: in the plane the surface speed of each body is its radius times its rate of turn."""
        tangent = self._named(cross(plane, self.normal), "tangent")
        spins = [self.kin.motion(place.body).angular_velocity for place in (self.first, self.second)]
        turn = dot(plane, sub(spins[0], spins[1]))
        sliding = dot(self.relative_rate, tangent) - sp.sympify(self.pair.first_radius) * turn
        return tangent, self.let(sliding, "sliding_velocity")

    def _grip(self, friction: Friction, pressing: Any) -> tuple[Grip, Any]:
        """What a law with modes needs, and the sliding velocity."""
        plane = self._plane_of_motion()
        if plane is None:
            raise ValueError(f"{self.pair.name}: no line of sliding, see friction_faults")
        tangent, sliding = self._sliding(plane)
        values = self._law(friction.law, {N: pressing}, friction.unchecked)
        law, stated = friction.law.law, NEWTON if friction.unchecked else None
        forces = [
            self.let(law.sliding.xreplace(values), "sliding_force", stated),
            self.let(law.holding.xreplace(values), "holding_force", stated),
        ]
        return Grip(self._on_joints(tangent, self.contact_point, "grip"), *forces), sliding

    def _rate_at(self, position: Vector) -> Vector:
        """Velocity of the first body's point at `position` against the second body's [m/s]."""
        one, two = (self.kin.velocity_at(place.body, position) for place in (self.first, self.second))
        return sub(one, two)

    def _plane_of_motion(self) -> Vector | None:
        """The coordinate axis across a plane contact, if normal and velocities show it structurally."""
        rate = self._rate_at(self.contact_point)
        for k in (2, 1, 0):
            if self.normal[k] == 0 and rate[k] == 0:
                x, y, z = (sp.Integer(int(i == k)) for i in range(3))
                return (x, y, z)
        return None
