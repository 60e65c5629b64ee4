"""Readings of a run beyond its states: a module of their own, derived when first needed.

Motions of bodies and named points, momenta, energies, contact forces as vectors, drives, and joint reactions. These
follow by Newton and Euler from the motion that a run has: a joint carries what its subtree needs beyond the forces on
it; along the joint's freedoms it carries nothing, what acts there is a drive or another effect. Forces on the bodies
are those of the equations of motion, resolved for each body by the same partial velocities. (Featherstone, Rigid Body
Dynamics Algorithms (2008), chapter 5.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.effect import DISSIPATED, Effect, Element
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import Moment
from hertzwerk.derive.declare.mechanism.bodies import Body, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.inverse_dynamics.joint_forces import Forces
from hertzwerk.derive.equations.inverse_dynamics.wrenches import AXES, WithWrenches, sides, wrench_keys
from hertzwerk.derive.equations.module.contents import with_constants
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.motion.absolute_coordinates import Absolute, quaternion_of
from hertzwerk.derive.equations.motion.equations_of_motion import gravity_vector
from hertzwerk.derive.equations.motion.kinematics import acceleration_of
from hertzwerk.derive.equations.motion.loop_closure import measured
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, apply, dot, scale, total, transpose
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.program.program import Program, Result

CONTACTS, MOTION = "contact_readings", "readings"
"""Functions of the module: of the contacts while they touch, and of everything else."""


@dataclass(frozen=True)
class Reading:
    """One history: its name, unit and meaning, and its expression on the tape."""

    name: str
    unit: str
    value: Any
    meaning: str


class Readings:
    """Readings of one scene, by what they are of: the results of the module's two functions."""

    def __init__(self, scene: Scene) -> None:
        self.system = System(scene, WithWrenches)
        self.scene, self.tape, self.equations = scene, self.system.tape, self.system.equations
        self.kin: Any = self.system.kin
        self.mechanism = scene.mechanism
        plane = self.mechanism.plane
        self.within = [k for k in range(3) if k != plane]
        self.about = [k for k in range(3) if plane in (None, k)]
        self.declared = scene.declared.mechanism if isinstance(scene, Absolute) else self.mechanism
        taken = [joint.name for joint in self.declared.joints]
        self.names = {body: f"{body.name}_body" if body.name in taken else body.name for body in self.mechanism.bodies}
        self.touching: list[str] = []
        self.forces = Forces(self.system, self.declared.tree, self.touching)

    def program(self) -> Program:
        """Program of both functions and their tables, not audited."""
        parts = {
            CONTACTS: [(pair.pair.name, list(self._contact(pair, *laws))) for pair, *laws in self.system.contacts],
            MOTION: list(self._groups()),
        }
        functions = [
            self.system.function(name, title, arguments, *(_result(whose, rows) for whose, rows in parts[name]))
            for name, title, arguments in (
                (CONTACTS, "Readings of contacts, which hold while they touch.", "t q u z m friction c"),
                (MOTION, "Readings of motion, energy and forces.", "t q u a touching multipliers reactions c"),
            )
        ]
        rows = [
            (reading.name, reading.unit, reading.meaning, name, i)
            for name, part in parts.items()
            for i, (_, readings) in enumerate(part)
            for reading in readings
        ]
        system = self.system
        states = [port.name for port in (*system.coordinates, *system.speeds)] + [name for name, _ in system.memory]
        tables = {
            "EFFECTS": tuple((effect.name, effect.kind, effect.text) for effect in self.scene.effects),
            "UNCHECKED": tuple((effect.name, effect.text) for effect in self.scene.effects if effect.unchecked),
            "PARAMETERS": tuple((p.name, p.unit) for p in self.scene.parameters.values()),
            "STATES": tuple(states),
            "TOUCHING": tuple(self.touching),
            "READINGS": tuple(rows),
        }
        return with_constants(system, functions, tables, "readings")

    def _groups(self) -> Iterator[tuple[str, list[Reading]]]:
        """Readings by what they are of, in the order of the declaration; those that are empty left out."""
        groups: list[tuple[str, Iterable[Reading]]] = [
            *((freedom.key, self._freedom(freedom)) for freedom in self.mechanism.freedoms if freedom.key in self.scene.driven),
            *((joint.name, self._measured(joint)) for joint in self.mechanism.closures),
            *((body.name, self._body(body)) for body in self.mechanism.bodies),
            *((f"{mark.part}.{mark.place}", self._point(f"{mark.part}.{mark.place}", mark.point)) for mark in self._marks()),
            *((joint.name, self._reaction(joint)) for joint in self.declared.joints),
            *((row.key, self._drive(row, force)) for row, force in self.forces.driving()),
            *((effect.name, self._effect(effect, element)) for effect, element in self.system.elements.items()),
        ]  # fmt: skip
        lists = ((whose, list(rows)) for whose, rows in groups)
        return ((whose, rows) for whose, rows in lists if rows)

    def _vector(self, whose: str, label: str, unit: str, vector: Vector, meaning: str) -> Iterator[Reading]:
        """Components in the plane of motion, and those that are not zero by structure."""
        return self._components(whose, label, unit, vector, meaning, self.within)

    def _moment(self, whose: str, label: str, unit: str, vector: Vector, meaning: str) -> Iterator[Reading]:
        return self._components(whose, label, unit, vector, meaning, self.about)

    @staticmethod
    def _components(
        whose: str, label: str, unit: str, vector: Vector, meaning: str, axes: list[int]
    ) -> Iterator[Reading]:
        for k, value in enumerate(vector):
            if k in axes or value != 0:
                yield Reading(f"{whose}.{label.format(AXES[k])}", unit, value, f"{meaning}, {AXES[k]}")

    # -- motion --------------------------------------------------------------------------------------------------------

    def _freedom(self, freedom: Freedom) -> Iterator[Reading]:
        """Coordinate, speed and acceleration of a driven freedom, where they are no states."""
        ports = (*freedom.coordinates, *freedom.speeds, *map(acceleration_of, freedom.speeds))
        row = self.kin.row(freedom.key)
        for port, value in zip(ports, (self.kin.coordinate(freedom.key), row.speed, row.acceleration), strict=True):
            yield Reading(port.name, port.unit, value, f"driven {_of(port.name)}")

    def _measured(self, joint: Joint) -> Iterator[Reading]:
        """Coordinates, speeds and accelerations of a closing joint, where its bodies determine them."""
        for freedom in joint.freedoms:
            if not joint.measures(freedom):
                continue
            measurement = measured(self.kin, freedom.key)
            second = [
                measurement.column[row.key] * row.acceleration
                for row in self.equations.free
                if row.key in measurement.column
            ]
            values = measurement.value, measurement.rate, measurement.bias + sp.Add(*second)
            ports = (*freedom.coordinates, *freedom.speeds, *map(acceleration_of, freedom.speeds))
            for port, value in zip(ports, values, strict=True):
                if value is not None:
                    yield Reading(port.name, port.unit, value, _of(port.name))

    def _point(self, whose: str, point: Point) -> Iterator[Reading]:
        """Position, velocity and acceleration of a point."""
        place, velocity, acceleration = self.kin.point(point, whose.replace(".", "_"))
        yield from self._vector(whose, "{}", "m", place, f"position of {whose}")
        yield from self._vector(whose, "{}_speed", "m/s", velocity, f"velocity of {whose}")
        yield from self._vector(whose, "{}_acceleration", "m/s^2", acceleration, f"acceleration of {whose}")

    def _marks(self) -> Iterator[Any]:
        """Landmarks on moving bodies, but for those of the bodies themselves."""
        bodies = [body.name for body in self.mechanism.bodies]
        return (mark for mark in self.system.landmarks if mark.point.body.name in bodies and mark.part not in bodies)

    def _body(self, body: Body) -> Iterator[Reading]:
        """Motion of the mass centre, orientation, momentum and energy of a body."""
        kin, name, k = self.kin, self.names[body], self.mechanism.plane
        yield from self._point(name, Point(body, body.centre))
        _, velocity, _ = kin.point(Point(body, body.centre), name)
        yield Reading(f"{name}.speed", "m/s", sp.sqrt(dot(velocity, velocity)), f"magnitude of the velocity of {name}")
        w, alpha = kin.motion(body).angular_velocity, kin.motion(body).angular_acceleration
        if k is not None:
            yield Reading(f"{name}.angle", "rad", kin.turned(body, k), f"angle of {name} against the ground")
            yield Reading(f"{name}.angle_speed", "rad/s", w[k], f"angular velocity of {name}")
            yield Reading(f"{name}.angle_acceleration", "rad/s^2", alpha[k], f"angular acceleration of {name}")
        else:
            for i, part in enumerate(quaternion_of(kin, body)):
                yield Reading(f"{name}.q{i}", "1", part, f"orientation of {name}, a quaternion")
            back, text = transpose(kin.rotation(body)), f"of {name}, in its own axes"
            yield from self._moment(name, "angular_speed_{}", "rad/s", apply(back, w), f"angular velocity {text}")
            yield from self._moment(
                name, "angular_acceleration_{}", "rad/s^2", apply(back, alpha), f"angular acceleration {text}"
            )
        if any(joint.bends and joint.parent.body == body for joint in self.mechanism.joints):
            return  # the start of a rod, whose momentum and energy are not those of the straight one
        mass, spin = sp.sympify(body.mass), self.forces.inertia(body, w)
        text = f"angular momentum of {name} about its mass centre"
        yield from self._vector(name, "momentum_{}", "kg m/s", scale(mass, velocity), f"momentum of {name}")
        yield from self._moment(name, "angular_momentum_{}", "kg m^2/s", spin, text)
        kinetic = (mass * dot(velocity, velocity) + dot(w, spin)) / 2
        yield Reading(f"{name}.kinetic_energy", "J", kinetic, f"kinetic energy of {name}")
        lasting = [effect for effect in self.scene.all(Gravity) if not effect.varies]
        if lasting:
            fallen = -mass * dot(kin.centre(body), gravity_vector(kin, lasting))
            yield Reading(f"{name}.potential_energy", "J", fallen, f"potential energy of {name} in gravity")

    # -- contacts ------------------------------------------------------------------------------------------------------

    def _contact(self, pair: Any, contact: Any, friction: Any) -> Iterator[Reading]:
        """Force on the first body and its point; friction, power and stored energy."""
        name, touch = contact.name, pair.touch
        bristles = {} if friction is None else self.system.bristles.get(friction.name, {})
        forces = pair.forces(contact, friction, self.system.latches.get(name), tuple(bristles.values()))
        rubbing, power, drag = forces.friction_force, forces.friction_power, forces.drag
        (on, sign), *_ = sides(touch.first.body, touch.second.body)
        force = tuple(sign * forces.generalised[key] for key in wrench_keys(on, "force"))
        if forces.grip is not None:
            components = [
                self.tape.input(f"{name}_friction_in", "friction", Dimension.from_unit("N"))
                for _ in forces.grip.tangents
            ]
            drag = add(*(scale(part, way) for part, way in zip(components, forces.grip.tangents, strict=True)))
            power = total(*(-velocity * part for part, velocity in zip(components, forces.grip.velocity, strict=True)))
            rubbing = components[0] if len(components) == 1 else -sp.sqrt(total(*(part**2 for part in components)))
            for part, along in zip(components, forces.grip.along, strict=True):
                force = add(force, tuple(sign * part * along[key] for key in wrench_keys(on, "force")))
        moments, drags = dict(forces.resistances), {}
        for effect, grip in forces.turning.items():
            unit = Dimension.from_unit(effect.holds)
            components = [self.tape.input(f"{effect.name}_friction_in", "friction", unit) for _ in grip.tangents]
            pull, vector = effect.held(grip, components)
            if effect.holds == "N":
                drags[effect] = pull
            for part, along in zip(components, grip.along, strict=True):
                force = add(force, tuple(sign * part * along.get(key, 0) for key in wrench_keys(on, "force")))
            spent = total(*(-velocity * part for part, velocity in zip(components, grip.velocity, strict=True)))
            moments[effect] = Moment(vector, {}, spent)
        direction = f"{touch.first.body.name} by {touch.second.body.name}"
        here = [
            *self._vector(name, "force_{}", "N", force, f"contact force on {direction}"),
            *self._vector(name, "point_{}", "m", touch.contact_point, "point of contact while surfaces touch"),
        ]
        self.touching += [reading.name for reading in here]
        yield from here
        yield Reading(f"{name}.stored_energy", "J", pair.elastic(contact)[1], f"energy stored in the contact {name}")
        yield Reading(f"{name}.power", "W", forces.normal_power, f"power dissipated by {name}")
        if friction is not None:
            text = "along its sliding velocity: negative where it brakes"
            yield Reading(f"{name}.friction_force", "N", rubbing, f"friction force on {direction}, {text}")
            yield Reading(f"{friction.name}.power", "W", power, f"power dissipated by {friction.name}")
            if drag is not None and pair.slides_along > 1:
                yield from self._vector(name, "friction_force_{}", "N", drag, f"friction force on {direction}")
        for effect, moment in moments.items():
            turning = list(
                self._moment(effect.name, "moment_{}", "N m", moment.vector, f"{effect.text}: moment on {direction}")
            )
            self.touching += [reading.name for reading in turning]
            yield from turning
            if effect in drags:
                text = f"friction force on {direction}"
                yield from self._vector(effect.name, "friction_force_{}", "N", drags[effect], text)
            yield Reading(f"{effect.name}.power", "W", moment.power, f"power dissipated by {effect.name}")

    def _reaction(self, joint: Joint) -> Iterator[Reading]:
        """Force and moment on the child of a joint, about the child's point: without those along its freedoms."""
        force, moment = self.forces.reaction(joint)
        text = f"that joint {joint.name} holds {joint.child.body.name} with"
        yield from self._vector(joint.name, "reaction_{}", "N", force, f"force {text}")
        about = f"moment {text}, about its point"
        yield from self._moment(joint.name, "reaction_moment_{}", "N m", moment, about)

    # -- drives and effects --------------------------------------------------------------------------------------------

    def _drive(self, row: Any, force: Any) -> Iterator[Reading]:
        drives = self.scene.driven
        name = drives[row.key].name if row.key in drives else row.key.split(".")[0]
        quantity = "force" if row.unit == "N" else "torque"
        if row.key in drives:
            yield Reading(f"{name}.{quantity}", row.unit, force, f"{quantity} of the drive {name} along {row.key}")
        yield Reading(f"{name}.power", "W", force * row.speed, f"power put in by {name}")

    def _effect(self, effect: Effect, element: Element) -> Iterator[Reading]:
        """Forces of an effect on joints and bodies, its power and stored energy."""
        name = effect.name
        joints = self.kin.on_joints.get(name, {})
        for key, force in joints.items():
            quantity = "force" if self.scene.scalars[key].kind == "slide" else "torque"
            label = quantity if len(joints) == 1 else f"{key.replace('.', '_')}_{quantity}"
            yield Reading(
                f"{name}.{label}", "N" if quantity == "force" else "N m", force, f"{quantity} of {name} along {key}"
            )
        if name in self.kin.on_bodies:
            force, body = self.kin.on_bodies[name]
            yield from self._vector(name, "force_{}", "N", force, f"force of {name} on {body.name}")
        for booked, power in element.powers.items():
            word = "dissipated" if booked == DISSIPATED else "put in"
            label = "power" if len(element.powers) == 1 else f"{booked}_power"
            yield Reading(f"{name}.{label}", "W", power, f"power {word} by {name}")
        if element.stored != 0:
            yield Reading(f"{name}.stored_energy", "J", element.stored, f"energy stored by {name}")


def _result(whose: str, rows: list[Reading]) -> Result:
    labels, units, values = zip(*((row.name, row.unit, row.value) for row in rows), strict=True)
    return Result(whose, labels, units, tuple(map(sp.sympify, values)))


def _of(name: str) -> str:
    """Words for a coordinate, speed or acceleration: `pin.angle` -> "angle of pin"."""
    joint, _, quantity = name.rpartition(".")
    return f"{quantity.replace('_', ' ')} of {joint}"
