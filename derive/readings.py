"""Readings of a run beyond its states: a module of their own, derived when first asked for.

Motions of bodies and named points, momenta, energies, contact forces as vectors, drives, and joint reactions. These
follow by Newton and Euler from the motion that a run has: a joint carries what its subtree needs beyond the forces on
it; along the joint's freedoms it carries nothing, what acts there is a drive or another effect. Forces on the bodies
are those of the equations of motion, resolved for each body by the same partial velocities. (Featherstone, Rigid Body
Dynamics Algorithms (2008), chapter 5.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.vectors import (
    ZERO,
    Vector,
    add,
    apply,
    cross,
    dot,
    is_zero,
    scale,
    sub,
    total,
    transpose,
)
from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.effects.effect import DISSIPATED, Effect, Element
from hertzwerk.derive.effects.gravity import Gravity
from hertzwerk.derive.mechanism.bodies import GROUND, Body, Direction, Frame, Point
from hertzwerk.derive.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.module.contents import with_constants
from hertzwerk.derive.module.results import MULTIPLIER_UNITS, dimension_of
from hertzwerk.derive.module.surroundings import Surroundings
from hertzwerk.derive.module.system import System
from hertzwerk.derive.motion.absolute import Absolute, quaternion_of
from hertzwerk.derive.motion.equations import gravity_vector
from hertzwerk.derive.motion.kinematics import acceleration_of
from hertzwerk.derive.motion.loops import Closure, measured
from hertzwerk.derive.program.program import Program, Result, Tape

AXES = "xyz"
CONTACTS, MOTION = "contact_readings", "readings"
"""Functions of the module: of the contacts while they touch, and of everything else."""


@dataclass(frozen=True)
class Reading:
    """One history: its name, unit and meaning, and its expression on the tape."""

    name: str
    unit: str
    value: Any
    meaning: str


class WithWrenches(Surroundings):
    """Kinematics that resolves every force for the bodies as well.

    They have rows of their own, moments about their mass centres.
    It notes forces by the name that they are given: on joints (key, force), and between bodies (force, body).
    """

    def __init__(self, tape: Tape, scene: Scene) -> None:
        super().__init__(tape, scene)
        self.on_joints: dict[str, dict[str, Any]] = {}
        self.on_bodies: dict[str, tuple[Vector, Frame]] = {}

    def on_joint(self, key: str, force: Any, name: str) -> dict[str, Any]:
        """Generalised forces of a force along a slide or a torque about a turn."""
        self.on_joints.setdefault(name, {})[key] = force
        return super().on_joint(key, force, name)

    def generalised(self, force: Vector, position: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a force on one body and its reaction on another at the same point."""
        self.on_bodies.setdefault(name, (force, on))
        found = super().generalised(force, position, on, against, name)
        for body, sign in _sides(on, against):
            moment = cross(sub(position, self.centre(body)), force)
            found |= self._rows(body, "force", scale(sign, force), name)
            found |= self._rows(body, "moment", scale(sign, moment), name)
        return found

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a moment on one body and its reaction on another."""
        found = super().generalised_moment(moment, on, against, name)
        for body, sign in _sides(on, against):
            found |= self._rows(body, "moment", scale(sign, moment), name)
        return found

    def _rows(self, body: Body, what: str, vector: Vector, name: str) -> dict[str, Any]:
        named = self.tape.vector(vector, f"{name}_{what}_on_{body.name}")
        return dict(zip(wrench_keys(body, what), named, strict=True))


def wrench_keys(body: Body, what: str) -> list[str]:
    """Rows of the force on a body, or of the moment about its mass centre, along the ground's axes."""
    return [f"{body.name}.wrench_{what}_{axis}" for axis in AXES]


def _sides(on: Frame, against: Frame) -> Iterator[tuple[Body, int]]:
    return ((body, sign) for body, sign in ((on, 1), (against, -1)) if isinstance(body, Body))


def readings_of(scene: Scene) -> Program:
    """Program of the readings of a scene; not audited."""
    return _Readings(scene).program()


class _Readings:
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

    def program(self) -> Program:
        """Both functions and their tables."""
        contacts = [
            (pair.pair.name, list(self._contact(*entry))) for entry in self.system.contacts for pair in entry[:1]
        ]
        groups = [*contacts, *self._groups()]
        inputs = ("t q u z m friction c", "t q u a touching multipliers reactions c")
        parts = (contacts, groups[len(contacts) :])
        titles = "Readings of contacts, which hold while they touch.", "Readings of motion, energy and forces."
        functions = [
            self.system.function(name, title, given, *(_result(whose, rows) for whose, rows in part))
            for name, title, given, part in zip((CONTACTS, MOTION), titles, inputs, parts, strict=True)
        ]
        rows = [(*_row(reading), CONTACTS if i < len(contacts) else MOTION, i - (0 if i < len(contacts) else len(contacts)))
                for i, (_, part) in enumerate(groups) for reading in part]  # fmt: skip
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
        found: list[tuple[str, Iterable[Reading]]] = [
            *((freedom.key, self._freedom(freedom)) for freedom in self.mechanism.freedoms if freedom.key in self.scene.driven),
            *((joint.name, self._measured(joint)) for joint in self.mechanism.closures),
            *((body.name, self._body(body)) for body in self.mechanism.bodies),
            *((f"{mark.part}.{mark.place}", self._point(f"{mark.part}.{mark.place}", mark.point)) for mark in self._marks()),
            *((joint.name, self._reaction(joint)) for joint in self.declared.joints),
            *((row.key, self._drive(row, force)) for row, force in self._driving()),
            *((effect.name, self._effect(effect, element)) for effect, element in self.system.elements.items()),
        ]  # fmt: skip
        lists = ((whose, list(rows)) for whose, rows in found)
        return ((whose, rows) for whose, rows in lists if rows)

    def _vector(self, whose: str, what: str, unit: str, vector: Vector, meaning: str) -> Iterator[Reading]:
        """Components in the plane of motion, and those that are not zero by structure."""
        return self._components(whose, what, unit, vector, meaning, self.within)

    def _moment(self, whose: str, what: str, unit: str, vector: Vector, meaning: str) -> Iterator[Reading]:
        return self._components(whose, what, unit, vector, meaning, self.about)

    @staticmethod
    def _components(
        whose: str, what: str, unit: str, vector: Vector, meaning: str, asked: list[int]
    ) -> Iterator[Reading]:
        for k, value in enumerate(vector):
            if k in asked or value != 0:
                yield Reading(f"{whose}.{what.format(AXES[k])}", unit, value, f"{meaning}, {AXES[k]}")

    # -- motion --------------------------------------------------------------------------------------------------------

    def _freedom(self, freedom: Freedom) -> Iterator[Reading]:
        """Coordinate, speed and acceleration of a driven freedom, where they are no states."""
        ports = (*freedom.coordinates, *freedom.speeds, *map(acceleration_of, freedom.speeds))
        row = self.kin.row(freedom.key)
        for port, value in zip(ports, (self.kin.coordinate(freedom.key), row.speed, row.acceleration), strict=True):
            yield Reading(port.name, port.unit, value, f"driven {_of(port.name)}")

    def _measured(self, joint: Joint) -> Iterator[Reading]:
        """Coordinates, speeds and accelerations of a closing joint, where its bodies tell them."""
        for freedom in joint.freedoms:
            if not joint.measures(freedom):
                continue
            found = measured(self.kin, freedom.key)
            second = [
                found.column[row.key] * row.acceleration for row in self.equations.free if row.key in found.column
            ]
            values = found.value, found.rate, found.bias + sp.Add(*second)
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
        return (mark for mark in self.system.landmarks if mark.point.body != GROUND and mark.part not in bodies)

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
        mass, spin = sp.sympify(body.mass), self._inertia(body, w)
        text = f"angular momentum of {name} about its mass centre"
        yield from self._vector(name, "momentum_{}", "kg m/s", scale(mass, velocity), f"momentum of {name}")
        yield from self._moment(name, "angular_momentum_{}", "kg m^2/s", spin, text)
        kinetic = (mass * dot(velocity, velocity) + dot(w, spin)) / 2
        yield Reading(f"{name}.kinetic_energy", "J", kinetic, f"kinetic energy of {name}")
        lasting = [effect for effect in self.scene.all(Gravity) if not effect.varies]
        if lasting:
            fallen = -mass * dot(kin.centre(body), gravity_vector(kin, lasting))
            yield Reading(f"{name}.potential_energy", "J", fallen, f"potential energy of {name} in gravity")

    def _inertia(self, body: Body, vector: Vector) -> Vector:
        """Inertia about the mass centre times a vector, along the ground's axes."""
        place = self.kin.tree.places[body]
        turned = self.kin.rotation_of(place.link.orientation, place.link.name)
        about = self.equations.recursion.about_centre(body)
        return self.tape.vector(apply(turned, apply(about, apply(transpose(turned), vector))), f"{body.name}_spin")

    @cached_property
    def _gravity(self) -> Vector:
        return gravity_vector(self.kin, self.scene.all(Gravity))

    # -- contacts ------------------------------------------------------------------------------------------------------

    def _contact(self, pair: Any, contact: Any, friction: Any) -> Iterator[Reading]:
        """Force on the first body and its point; friction, power and stored energy."""
        name, touch = contact.name, pair.touch
        bristle = None if friction is None else self.system.bristles.get(friction.name)
        forces = pair.forces(contact, friction, self.system.latches.get(name), bristle)
        rubbing, power, drag = forces.friction_force, forces.friction_power, forces.drag
        (on, sign), *_ = _sides(touch.first.body, touch.second.body)
        force = tuple(sign * forces.generalised[key] for key in wrench_keys(on, "force"))
        if forces.grip is not None:
            given = [
                self.tape.input(f"{name}_friction_in", "friction", dimension_of("N")) for _ in forces.grip.tangents
            ]
            drag = add(*(scale(part, way) for part, way in zip(given, forces.grip.tangents, strict=True)))
            power = total(*(-velocity * part for part, velocity in zip(given, forces.grip.velocity, strict=True)))
            rubbing = given[0] if len(given) == 1 else -sp.sqrt(total(*(part**2 for part in given)))
            for part, along in zip(given, forces.grip.along, strict=True):
                force = add(force, tuple(sign * part * along[key] for key in wrench_keys(on, "force")))
        what = f"{touch.first.body.name} by {touch.second.body.name}"
        here = [
            *self._vector(name, "force_{}", "N", force, f"contact force on {what}"),
            *self._vector(name, "point_{}", "m", touch.contact_point, "point of contact while surfaces touch"),
        ]
        self.touching += [reading.name for reading in here]
        yield from here
        yield Reading(f"{name}.stored_energy", "J", pair.elastic(contact)[1], f"energy stored in the contact {name}")
        yield Reading(f"{name}.power", "W", forces.normal_power, f"power dissipated by {name}")
        if friction is not None:
            text = "along its sliding velocity: negative where it brakes"
            yield Reading(f"{name}.friction_force", "N", rubbing, f"friction force on {what}, {text}")
            yield Reading(f"{friction.name}.power", "W", power, f"power dissipated by {friction.name}")
            if drag is not None and pair.slides_along > 1:
                yield from self._vector(name, "friction_force_{}", "N", drag, f"friction force on {what}")

    @cached_property
    def _of_contacts(self) -> list[dict[str, Any]]:
        """Generalised forces of the contacts, of forces and points that are inputs."""
        found = []
        given = {
            name: self.tape.input(name.replace(".", "_"), "touching", dimension_of("N" if ".force_" in name else "m"))
            for name in self.touching
        }
        for pair, contact, _ in self.system.contacts:
            force, point = (
                tuple(given.get(f"{contact.name}.{what}_{axis}", sp.S.Zero) for axis in AXES)
                for what in ("force", "point")
            )
            bodies = pair.touch.first.body, pair.touch.second.body
            found.append(self.kin.generalised(force, point, *bodies, f"{contact.name}_touch"))
        return found

    # -- forces --------------------------------------------------------------------------------------------------------

    @cached_property
    def _multipliers(self) -> list[Any]:
        return [
            self.tape.input(
                f"{row.name.replace('.', '_')}_held", "multipliers", dimension_of(MULTIPLIER_UNITS[row.unit])
            )
            for row in self.equations.constraints
        ]

    @cached_property
    def _acting(self) -> list[Mapping[str, Any]]:
        """Generalised forces of effects and contacts, by row and by body."""
        return [*(element.forces for element in self.system.elements.values()), *self._of_contacts]

    @cached_property
    def _held(self) -> list[tuple[Any, Any]]:
        """Constraints with their forces, but for those of joints that carry a body, which follow here."""
        inner = [joint.name for joint in self.declared.tree]
        pairs = zip(self.equations.constraints, self._multipliers, strict=True)
        return [(row, force) for row, force in pairs if row.name.split(".")[0] not in inner]

    def _wrench(self, body: Body, what: str) -> Vector:
        """Force on a body, or moment about its mass centre, but for gravity and the joints that carry bodies."""
        pulls = [{key: value * force for key, value in row.column.items()} for row, force in self._held]
        acting = [*self._acting, *pulls]
        return tuple(sp.Add(*(sp.sympify(forces.get(key, 0)) for forces in acting)) for key in wrench_keys(body, what))

    @cached_property
    def _transmitted(self) -> dict[Joint, tuple[Vector, Vector]]:
        """Force and moment on the child of each joint that carries it, about its point, with drives."""
        found: dict[Joint, tuple[Vector, Vector]] = {}
        kin, tree = self.kin, self.declared.tree
        for joint in reversed(tree):
            body, name = joint.child.body, joint.name
            if not isinstance(body, Body):
                continue
            place, _, _ = kin.point(joint.child, f"{name}_child")
            centre, _, acceleration = kin.point(Point(body, body.centre), f"{body.name}_centre")
            motion = kin.motion(body)
            w, alpha = motion.angular_velocity, motion.angular_acceleration
            weight = scale(sp.sympify(body.mass), sub(acceleration, self._gravity))
            force = self.tape.vector(sub(weight, self._wrench(body, "force")), f"{name}_needs")
            turning = add(self._inertia(body, alpha), cross(w, self._inertia(body, w)))
            moment = add(sub(turning, self._wrench(body, "moment")), cross(sub(centre, place), force))
            for beyond in (other for other in tree if other.parent.body == body):
                further, twist = found[beyond]
                there, _, _ = kin.point(beyond.child, f"{beyond.name}_child")
                force, moment = add(force, further), add(moment, twist, cross(sub(there, place), further))
            found[joint] = self.tape.vector(force, f"{name}_passes"), self.tape.vector(moment, f"{name}_twists")
        return found

    def _reaction(self, joint: Joint) -> Iterator[Reading]:
        """Force and moment on the child of a joint, about the child's point: without those along its freedoms."""
        if joint in self._transmitted:
            force, moment = self._without_freedoms(joint, *self._transmitted[joint])
        else:
            force, moment = self._of_closure(joint)
        text = f"that joint {joint.name} holds {joint.child.body.name} with"
        yield from self._vector(joint.name, "reaction_{}", "N", force, f"force {text}")
        about = f"moment {text}, about its point"
        yield from self._moment(joint.name, "reaction_moment_{}", "N m", moment, about)

    def _without_freedoms(self, joint: Joint, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
        """Wrench without what acts along the freedoms, so that it does no work in them."""
        shown, turns = Closure(self.kin, joint), len(joint.turning)

        def axis(direction: Direction, before: int, label: str) -> Vector:
            return joint.carried(direction, before).moving(shown, f"along_{label}")[0]

        slides = [(axis(way, before, f"slide_{i}"), before) for i, (way, before) in enumerate(joint.sliding)]
        force = _across(force, [(way, sp.S.Zero) for way, _ in slides])
        if turns > 2 or None in joint.turning:
            return force, ZERO
        wanted = []
        for i, direction in enumerate(way for way in joint.turning if way is not None):
            about = axis(
                direction, 0 if i == 0 else turns, f"turn_{i}"
            )  # the first is fixed in the parent, the last in the child
            later = [way for way, before in slides if before > i]
            arm = (
                shown.apart
                if len(later) == len(slides)
                else add(ZERO, *(scale(dot(shown.apart, way), way) for way in later))
            )
            wanted.append((about, -dot(about, cross(arm, force)) if later else sp.S.Zero))
        return force, _across(moment, wanted)

    def _of_closure(self, joint: Joint) -> tuple[Vector, Vector]:
        """Wrench of the constraints of a joint that closes a loop, about the child's point."""
        (on, sign), *_ = _sides(joint.child.body, joint.parent.body)
        rows = [(row, force) for row, force in self._held if row.name.split(".")[0] == joint.name and not row.drives]

        def total(what: str) -> Vector:
            keys = wrench_keys(on, what)
            return tuple(sign * sp.Add(*(value * row.column.get(key, 0) for row, value in rows)) for key in keys)

        force, (place, _, _) = total("force"), self.kin.point(joint.child, f"{joint.name}_child")
        return force, add(total("moment"), cross(sub(self.kin.centre(on), place), force))

    # -- drives and effects --------------------------------------------------------------------------------------------

    def _driving(self) -> Iterator[tuple[Any, Any]]:
        """Each driven row with its reaction."""
        forces = {
            row.key: sp.Add(self.equations.gravity(row), *(sp.sympify(f.get(row.key, 0)) for f in self._acting))
            for row in self.equations.driven
        }
        rows = [*self.equations.driven, *self.equations.prescribed]
        free = [row.acceleration for row in self.equations.free]
        return zip(rows, self.equations.reactions(forces, free, self._multipliers), strict=True)

    def _drive(self, row: Any, force: Any) -> Iterator[Reading]:
        drives = self.scene.driven
        name = drives[row.key].name if row.key in drives else row.key.split(".")[0]
        what = "force" if row.unit == "N" else "torque"
        if row.key in drives:
            yield Reading(f"{name}.{what}", row.unit, force, f"{what} of the drive {name} along {row.key}")
        yield Reading(f"{name}.power", "W", force * row.speed, f"power put in by {name}")

    def _effect(self, effect: Effect, element: Element) -> Iterator[Reading]:
        """Forces of an effect on joints and bodies, its power and stored energy."""
        name = effect.name
        joints = self.kin.on_joints.get(name, {})
        for key, force in joints.items():
            what = "force" if self.scene.scalars[key].kind == "slide" else "torque"
            label = what if len(joints) == 1 else f"{key.replace('.', '_')}_{what}"
            yield Reading(f"{name}.{label}", "N" if what == "force" else "N m", force, f"{what} of {name} along {key}")
        if name in self.kin.on_bodies:
            force, body = self.kin.on_bodies[name]
            yield from self._vector(name, "force_{}", "N", force, f"force of {name} on {body.name}")
        for booked, power in element.powers.items():
            word = "dissipated" if booked == DISSIPATED else "put in"
            label = "power" if len(element.powers) == 1 else f"{booked}_power"
            yield Reading(f"{name}.{label}", "W", power, f"power {word} by {name}")
        if element.stored != 0:
            yield Reading(f"{name}.stored_energy", "J", element.stored, f"energy stored by {name}")


def _across(vector: Vector, wanted: list[tuple[Vector, Any]]) -> Vector:
    """Vector with wanted components along one or two axes in place of its own; zero for three."""
    if not wanted or is_zero(vector):
        return vector
    if len(wanted) == 1:
        ((axis, value),) = wanted
        return sub(vector, scale(dot(vector, axis) - value, axis))
    if len(wanted) > 2:
        return ZERO
    (one, first), (two, second) = wanted
    normal, cosine = cross(one, two), dot(one, two)
    size = dot(normal, normal)
    given = add(scale(first - cosine * second, one), scale(second - cosine * first, two))
    return scale(1 / size, add(scale(dot(vector, normal), normal), given))


def _result(whose: str, rows: list[Reading]) -> Result:
    labels, units, values = zip(*((row.name, row.unit, row.value) for row in rows), strict=True)
    return Result(whose, labels, units, tuple(map(sp.sympify, values)))


def _row(reading: Reading) -> tuple[str, str, str]:
    return reading.name, reading.unit, reading.meaning


def _of(name: str) -> str:
    """Words for a coordinate, speed or acceleration: `pin.angle` -> "angle of pin"."""
    joint, _, what = name.rpartition(".")
    return f"{what.replace('_', ' ')} of {joint}"
