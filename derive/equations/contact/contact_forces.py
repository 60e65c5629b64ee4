"""Contact forces of the pairs, by the laws in use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.effects.contacts import DEEPEST, DENT, STAGE, Contact, Friction
from hertzwerk.derive.declare.effects.effect import together
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import Grip, Moment, PairResistance
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, cross, dot, scale, sub
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.laws.law import BRISTLE, BoundLaw, F, N, PlasticLaw, Quantity, d, k_t, s, v, v0
from hertzwerk.derive.laws.smoothing import begun, energy_begun

NEWTON, JOULE, METRE, PURE = (Dimension.from_unit(unit) for unit in ("N", "J", "m", "1"))
STIFFNESS, DRAG, DECAY, PACE = (Dimension.from_unit(unit) for unit in ("N/m", "N s/m", "1/s", "m/s"))


@dataclass(frozen=True)
class Forces:
    """Result of a contact: generalised forces by joint, powers [W], normal force [N], sliding velocity.

    `sliding_velocity` [m/s] is None without friction; `in_range` is 1 within the range of the law, else 0.
    `bristle_rates` [m/s] are given for friction with a bristle. `grip` is given for friction with modes, which
    `generalised` and `friction_power` then do not include, and has its sliding velocities. `rubbing` is the part of `generalised` due to friction,
    `friction_force` [N] its force on the first body along the direction of `sliding_velocity`, and `drag` [N] that as a
    vector, else None. `resistances` are the moments against rolling and drilling by effect, which `generalised` includes, and
    `turning` the grips of those with modes, which it does not. `wear` are the rates of its states by name, and its power the
    stored energy that is lost with what is worn off.
    """

    generalised: dict[str, Any]
    normal_power: Any
    normal_force: Any
    in_range: Any
    friction_power: Any = sp.S.Zero
    sliding_velocity: Any = None
    bristle_rates: tuple[Any, ...] = ()
    grip: Grip | None = None
    rubbing: Mapping[str, Any] = field(default_factory=dict)
    friction_force: Any = None
    drag: Vector | None = None
    resistances: Mapping[PairResistance, Moment] = field(default_factory=dict)
    turning: Mapping[PairResistance, Grip] = field(default_factory=dict)
    wear: Mapping[str, Any] = field(default_factory=dict)
    wear_power: Any = sp.S.Zero

    @property
    def grips(self) -> list[Grip]:
        """Grips of friction and of resistances with modes, in the order of their slips."""
        return [*([] if self.grip is None else [self.grip]), *self.turning.values()]


def _staged(number: Any, expressions: Sequence[Any], values: Mapping[sp.Symbol, Any]) -> Any:
    """Return the expression of a stage, numbered from 0, at some values."""
    chosen = expressions[-1].xreplace(values)
    for k, expression in reversed(list(enumerate(expressions[:-1]))):
        chosen = Where(number < k + 1, expression.xreplace(values), chosen)
    return chosen


class PairKinematics:
    """Contact forces of one pair on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, pair: Pair, geometry: dict[str, Any]) -> None:
        self.kin = kinematics
        self.pair = pair
        self.touch: Touch = pair.touch(kinematics)
        self._geometry = geometry

    def _named(self, vector: Vector, label: str) -> Vector:
        return self.touch.named(vector, label)

    def let(self, expression: Any, label: str, dimension: Dimension | None = None) -> Any:
        """Name a result of this pair on the tape."""
        return self.touch.let(expression, label, dimension)

    def _law(self, bound: BoundLaw, known: dict[sp.Symbol, Any], unchecked: bool = False) -> dict[sp.Symbol, Any]:
        """Values of a law's symbols on the tape: state, bound parameters, geometry, definitions.

        Definitions of unchecked laws have the dimension the law declares.
        """
        return bound.resolved(self._geometry, self.let, known, self._stated if unchecked else lambda *_: None)

    def _stated(self, symbol: Quantity, values: dict[sp.Symbol, Any]) -> Dimension:
        return Dimension.from_unit(parse_unit(symbol.unit), {s.name: value for s, value in values.items()})

    def gap(self, contact: Contact) -> tuple[Any, Any, Any]:
        """Gap, to the ground of a dent that an elastic-plastic contact has left; its rate, acceleration."""
        touch = self.touch
        if contact.plastic is None:
            return touch.gap, touch.gap_rate, touch.gap_acceleration
        rate = self.kin.tape.rate(touch.penetration, f"{contact.name}_indentation_rate")
        second = self.kin.tape.rate(rate, f"{contact.name}_indentation_acceleration")
        return self.let(self.kin.state(f"{contact.name}.{DENT}") - touch.penetration, "gap_to_dent"), -rate, -second

    def plastic(self, contact: Contact, law: PlasticLaw) -> tuple[Any, Any, Any]:
        """Force [N], energy that unloading returns [J], force that the dent takes [N], of a plastic law.

        By the stage, not by the depth, so that a step may look beyond the event that ends it. A branch that does not hold is
        evaluated at the depth of first yield, and remains finite.
        """
        stage, deepest, dent = (self.kin.state(f"{contact.name}.{name}") for name in (STAGE, DEEPEST, DENT))
        depth, values = self.touch.penetration, self._law(contact.stiffness, {}, contact.unchecked)
        onset, stated = law.onset.xreplace(values), ((NEWTON, JOULE, METRE, PURE) if contact.unchecked else (None,) * 4)
        unloads = stage < 0
        number = self.let(Where(unloads, -stage, stage), "stage_number")
        loaded = {**values, d: self.let(Where(depth > 0, depth, onset), "loaded_depth")}
        turned = {**values, d: self.let(Where(unloads, deepest, onset), "turned_depth")}
        forces = (law.elastic, *law.stages)
        loading = self.let(_staged(number, forces, loaded), "loading_force", stated[0])
        peak = self.let(_staged(number, forces, turned), "peak_force", stated[0])
        steepness = self.let(law.steepness.xreplace(turned), "steepness", stated[3])
        lift = self.let(Where(unloads, deepest - dent, onset), "lift")
        share = self.let(Where(unloads, Where(depth > dent, depth - dent, 0), onset) / lift, "share")
        unloading = self.let(peak * share**steepness, "unloading_force", stated[0])
        force = self.let(self._pressed(Where(unloads, unloading, loading), dent), "elastic_force", stated[0])
        recovered = _staged(number, law.returned, loaded)
        left = unloading * lift * share / (steepness + 1)
        stored = self.let(self._pressed(Where(unloads, left, recovered), dent), "stored_energy", stated[1])
        spent = (force - sp.diff(energy, d) for force, energy in zip(law.stages, law.returned[1:], strict=True))
        taken = _staged(number, (sp.S.Zero, *spent), loaded)
        return force, stored, self.let(Where(unloads, 0, taken), "plastic_force", stated[0])

    def _pressed(self, expression: Any, dent: Any = 0) -> Any:
        """The expression where the surfaces press on each other, deeper than a dent, else 0."""
        return Where(self.touch.penetration > dent, expression, 0)

    def elastic(self, contact: Contact) -> tuple[Any, Any, Any]:
        """Elastic force [N], stored energy [J], and the force that a dent takes [N], zero while open."""
        law = contact.stiffness.law
        if contact.plastic is not None:
            return self.plastic(contact, contact.plastic)
        values = self._law(contact.stiffness, {d: self._depth(contact)}, contact.unchecked)
        stated = (NEWTON, JOULE) if contact.unchecked else (None, None)
        force = self.let(self._pressed(law.force.xreplace(values)), "elastic_force", stated[0])
        stored = law.work.xreplace(values) if contact.length is None else self._smooth_work(contact, values)
        return force, self.let(self._pressed(stored), "stored_energy", stated[1]), sp.S.Zero

    def _depth(self, contact: Contact) -> Any:
        """Penetration of the laws [m]: that of the surfaces, or the smoothed one."""
        depth, length = self.touch.penetration, contact.length
        if length is None:
            return depth
        begin = begun(self._share(contact), length)
        return self.let(Where(depth < 2 * length, begin, depth - length), "smooth_penetration")

    def _share(self, contact: Contact) -> Any:
        """Penetration over twice the smoothing length, at most 1."""
        depth, length = self.touch.penetration, contact.length
        return self.let(Where(depth < 2 * length, depth / (2 * length), 1), "smooth_share")

    def _smooth_work(self, contact: Contact, values: dict[sp.Symbol, Any]) -> Any:
        """Energy stored by a smoothed law [J]: on the way to twice the length, and beyond."""
        law, length = contact.stiffness.law, contact.length
        begin = energy_begun(law, values, self._share(contact), length)
        beyond = law.work.xreplace(values) - law.work.xreplace({**values, d: length})
        return begin + Where(self.touch.penetration > 2 * length, beyond, 0)

    def _resistance(self, contact: Contact, damping: BoundLaw, elastic: Any, approach_speed: Any) -> Any:
        law, stated = damping.law, NEWTON if contact.unchecked else None
        known = {F: elastic, v: self.touch.penetration_rate, d: self._depth(contact)}
        if approach_speed is not None:
            known[v0] = approach_speed
        if k_t in law.quantities:
            stiffness = self._law(contact.stiffness, {d: self._depth(contact)}, contact.unchecked)
            tangent = sp.diff(contact.stiffness.law.force, d).xreplace(stiffness)
            known[k_t] = self.let(self._pressed(tangent), "tangent_stiffness", STIFFNESS if contact.unchecked else None)
        values = self._law(damping, known, contact.unchecked)
        if law.factor is not None:
            factor = self.let(law.factor.xreplace(values), "hysteresis_factor", PURE if contact.unchecked else None)
            return self.let(elastic * factor * self.touch.penetration_rate / approach_speed, "resistance")
        return self.let(self._pressed(law.resistance.xreplace(values)), "resistance", stated)

    def forces(
        self, contact: Contact, friction: Friction | None, approach_speed: Any, bristle: Sequence[Any] = ()
    ) -> Forces:
        """Forces of the pair, from latched approach speed [m/s] and bristle deflections [m] where it has them."""
        elastic, _, taken = self.elastic(contact)
        worn, stretch = self.touch.worn, self.touch.stretch
        normal_force, normal_power = elastic, sp.S.Zero
        if contact.plastic is not None:
            normal_power = self.let(-taken * self.gap(contact)[1], "plastic_power")
        if contact.damping is not None:
            resistance = self._resistance(contact, contact.damping, elastic, approach_speed)
            normal_force = self.let(elastic + resistance, "normal_force" if stretch is None else "gradient_force")
            normal_power = self.let(normal_power + resistance * self.touch.penetration_rate, "normal_power")
        along_gradient = normal_force
        if stretch is not None:
            normal_force = self.let(stretch * along_gradient, "normal_force")
        # The line of action passes through the first place: its shorter arm suffices.
        push = self._named(scale(normal_force, self.touch.normal), "push")
        generalised = self._on_joints(push, self.touch.position, "push")
        if stretch is not None:
            bodies = self.touch.first.body, self.touch.second.body
            couple = self.kin.generalised_moment(worn.couple(along_gradient), *bodies, f"{self.pair.name}_couple")
            generalised = together(generalised, couple)
        resistances = self.kin.scene.resistances(self.pair.name)
        modes = friction is not None and bool(friction.law.law.modes)
        pulls = contact.damping is not None and contact.damping.law.release == "gap"
        pressing = normal_force
        if (
            (pulls and (friction is not None or resistances or worn))
            or modes
            or any(effect.has_modes for effect in resistances)
        ):
            pressing = self.let(Where(normal_force > 0, normal_force, 0), "pressing_force")
        acting = self.kin, self.touch, pressing
        moments = {effect: effect.moment(*acting) for effect in resistances if not effect.has_modes}
        turning = {effect: effect.grip(*acting) for effect in resistances if effect.has_modes}
        rubs = {} if friction is None else self._rubbing(friction, pressing, bristle)
        shares = (moment.generalised for moment in moments.values())
        generalised = together(generalised, *shares, rubs.get("rubbing", {}))
        in_range = self._in_range(contact)
        if worn is not None:
            plane = self.touch.plane_of_motion
            speed = self._size(self._slip())[0] if plane is None else sp.Abs(self._sliding(plane)[1])
            rates, recession = worn.progress(pressing, speed)
            rubs |= {"wear": rates, "wear_power": self.let(elastic * recession, "wear_power")}
        return Forces(generalised, normal_power, normal_force, in_range, resistances=moments, turning=turning, **rubs)

    def _rubbing(self, friction: Friction, pressing: Any, bristle: Sequence[Any]) -> dict[str, Any]:
        """Part of `Forces` that friction adds: with modes its grip."""
        if friction.law.law.modes:
            return {"grip": self._grip(friction, pressing)}
        drag, sliding, opposing, power, rates = self._drag(friction, pressing, bristle)
        drag = self._named(drag, "drag")
        return {
            "drag": drag,
            "rubbing": self._on_joints(drag, self.touch.contact_point, "drag"),
            "sliding_velocity": sliding,
            "friction_force": -opposing,
            "friction_power": power,
            "bristle_rates": rates,
        }

    def _on_joints(self, force: Vector, position: Vector, name: str) -> dict[str, Any]:
        return self.kin.generalised(
            force, position, self.touch.first.body, self.touch.second.body, f"{self.pair.name}_{name}"
        )

    def _in_range(self, contact: Contact) -> Any:
        reach, within = contact.stiffness.law.reach, sp.S.One
        if reach is not None:
            values = self._law(contact.stiffness, {}, contact.unchecked)
            limit = self.let(reach.xreplace(values), "penetration_limit", METRE if contact.unchecked else None)
            within = self.let(Where(self.touch.penetration <= limit, 1, 0), "in_range")
        if self.touch.limit is not None:
            within = self.let(Where(self.touch.penetration <= self.touch.limit, within, 0), "in_range")
        return within

    def faults(self, friction: Friction | None, length: float) -> Iterator[Fault]:
        """Yield faults of the pair and its friction.

        A gap that is constantly zero, as of a cylinder guided at its radius above the plane; a friction law whose
        memory has no meaning in two directions of sliding.
        """
        yield from self.touch.faults(length)
        if self.touch.gap == 0:
            yield Fault(f"pair {self.pair.name}, gap", "0 m in every position: it never changes",
                        "surfaces that the joints let come nearer or part, or press into each other",
                        "Add a joint along the normal, guide the body nearer, or leave the pair out.")  # fmt: skip
        law = None if friction is None else friction.law.law
        if friction and law and law.memory and self.slides_along > 1 and law.in_two_directions is None:
            actual = f"law {law.name} at {self.pair.name}, whose bodies may slide in more than one direction"
            yield Fault(f"effect {friction.name}", actual, "a law that is linear in its deflection, or one direction of sliding",
                        "lugre, coulomb, smooth_coulomb, stribeck and brown_mcphee take sliding in any direction.")  # fmt: skip

    def _drag(
        self, friction: Friction, normal_force: Any, bristle: Sequence[Any]
    ) -> tuple[Vector, Any, Any, Any, tuple[Any, ...]]:
        """Friction on the first body; sliding velocity, force against it, power; rates of the bristle."""
        law = friction.law.law
        plane = self.touch.plane_of_motion
        if plane is None and law.memory:
            return self._bent(friction, normal_force, bristle)
        if plane is None:
            slip = self._slip()
            sliding, size = self._size(slip)
        else:
            tangent, sliding = self._sliding(plane)
        known = {N: normal_force, s: sliding, **dict(zip((BRISTLE,), bristle, strict=False))}
        values = self._law(friction.law, known, friction.unchecked)
        stated = (NEWTON, DRAG, PACE) if friction.unchecked else (None, None, None)
        force = self.let(law.force.xreplace(values), "friction_force", stated[0])
        power = self.let(force * sliding, "friction_power")
        if plane is None:
            slope = self.let(law.slope.xreplace(values), "friction_slope", stated[1])
            per_speed = self.let(Where(sliding > 0, force / size, slope), "friction_per_speed")
            return scale(-per_speed, slip), sliding, force, power, ()
        rates = tuple(self.let(rate.xreplace(values), "bristle_rate", stated[2]) for _, rate, _ in law.memory)
        return scale(-force, tangent), sliding, force, power, rates

    def _slip(self) -> Vector:
        """Sliding velocity in the tangent plane [m/s]."""
        rate = self._named(self.touch.rate_at(self.touch.contact_point), "sliding_rate")
        along = self.let(dot(rate, self.touch.normal), "along_rate")
        return self._named(sub(rate, scale(along, self.touch.normal)), "slip")

    def _size(self, slip: Vector) -> tuple[Any, Any]:
        """Size of the sliding velocity, and one in its place at rest, where the root has no slope [m/s]."""
        square, pace = self.let(dot(slip, slip), "slip_squared"), sp.sympify(self.kin.scene.scales.speed)
        size = self.let(sp.sqrt(Where(square > 0, square, pace**2)), "slip_size")
        return self.let(Where(square > 0, size, 0), "sliding_velocity"), size

    def _bent(
        self, friction: Friction, normal_force: Any, bristle: Sequence[Any]
    ) -> tuple[Vector, Any, Any, Any, tuple[Any, ...]]:
        """Return what `_drag` does, of a bristle that bends in any direction of the tangent plane.

        It is a vector in the ground's axes, and tilts and twirls with the contact, about the normal with the mean of
        both bodies: its rate is the law's for an observer who does, and the same for every other. Kuhn, Bagi,
        Mechanics Research Communications 32 (2005) 463.
        """
        law = friction.law.law.in_two_directions
        if law is None:
            raise ValueError(f"{friction.name} has no meaning in two directions")
        normal, tape = self.touch.normal, self.touch.tape
        slip, place = self._slip(), dict(zip(self.bristle_axes, bristle, strict=True))
        bent: Vector = (place.get("x", ZERO[0]), place.get("y", ZERO[0]), place.get("z", ZERO[0]))
        sliding, _ = self._size(slip)
        values = self._law(friction.law, {N: normal_force, s: sliding}, friction.unchecked)
        stated = (STIFFNESS, DRAG, DECAY, PURE) if friction.unchecked else (None,) * 4
        names = ("friction_stiffness", "friction_per_speed", "bristle_decay", "bristle_gain")
        parts = (part.xreplace(values) for pair in law for part in pair)
        stiffness, damping, decay, gain = (self.let(*row) for row in zip(parts, names, stated, strict=True))
        opposing = self._named(add(scale(stiffness, bent), scale(damping, slip)), "opposing")
        tilt = tuple(tape.rate(part, f"{self.pair.name}_normal_rate") for part in normal)
        spins = [dot(self.kin.angular_velocity(place.body), normal) for place in (self.touch.first, self.touch.second)]
        twirl = self.let(sp.Add(*spins) / 2, "twirl")
        turning = self._named(add(cross(normal, tilt), scale(twirl, normal)), "turning")
        rates = add(scale(decay, bent), scale(gain, slip), cross(turning, bent))
        named = self._named(rates, "bristle_rate")
        size = sp.sqrt(dot(opposing, opposing))
        power = self.let(dot(opposing, slip), "friction_power")
        return scale(-1, opposing), sliding, size, power, tuple(named["xyz".index(axis)] for axis in self.bristle_axes)

    @property
    def bristle_axes(self) -> tuple[str, ...]:
        """Axes of the ground along which a bristle may bend; one without a name in plane motion."""
        if self.touch.plane_of_motion is not None:
            return ("",)
        return tuple(axis for axis, part in zip("xyz", self.touch.normal, strict=True) if part**2 != 1)

    def bristle_size(self, friction: Friction) -> Any:
        """Scale of the bristle's error tolerance [m]."""
        ((_, _, size),) = friction.law.law.memory
        return self.let(size.xreplace(friction.law.binding), "bristle_size", METRE if friction.unchecked else None)

    def _sliding(self, plane: Vector) -> tuple[Vector, Any]:
        """Tangent and sliding velocity along it, in plane motion.

        The surface speed of each body is its radius times its angular velocity.
        """
        (tangent,) = self.touch.tangents
        spins = [self.kin.motion(place.body).angular_velocity for place in (self.touch.first, self.touch.second)]
        turn = dot(plane, sub(spins[0], spins[1]))
        sliding = dot(self.touch.relative_rate, tangent) - sp.sympify(self.pair.first_radius) * turn
        return tangent, self.let(sliding, "sliding_velocity")

    @property
    def slides_along(self) -> int:
        """Number of directions in which its surfaces may slide on each other: one in plane motion, else two."""
        return 2 if self.touch.plane_of_motion is None else 1

    def _grip(self, friction: Friction, pressing: Any) -> Grip:
        """Grip of a friction law with modes."""
        plane = self.touch.plane_of_motion
        if plane is None:
            tangents = self.touch.tangents
            rate = self._named(self.touch.rate_at(self.touch.contact_point), "sliding_rate")
            velocity = tuple(self.let(dot(rate, tangent), "sliding_velocity") for tangent in tangents)
        else:
            tangent, sliding = self._sliding(plane)
            tangents, velocity = (tangent,), (sliding,)
        values = self._law(friction.law, {N: pressing}, friction.unchecked)
        law, stated = friction.law.law, NEWTON if friction.unchecked else None
        forces = [
            self.let(law.sliding.xreplace(values), "sliding_force", stated),
            self.let(law.holding.xreplace(values), "holding_force", stated),
        ]
        along = tuple(self._on_joints(tangent, self.touch.contact_point, "grip") for tangent in tangents)
        return Grip(tangents, along, velocity, *forces)
