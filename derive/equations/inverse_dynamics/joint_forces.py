"""Forces on the bodies of a scene, in its joints and of its drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.mechanism.bodies import Body, Direction, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.equations.inverse_dynamics.wrenches import AXES, sides, wrench_keys
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.labelled_results import MULTIPLIER_UNITS
from hertzwerk.derive.equations.motion.equations_of_motion import gravity_vector
from hertzwerk.derive.equations.motion.loop_closure import Closure
from hertzwerk.derive.expressions.algebra.vectors import (
    ZERO,
    Vector,
    add,
    apply,
    cross,
    dot,
    is_zero,
    scale,
    sub,
    transpose,
)
from hertzwerk.derive.expressions.dimension.dimension import Dimension

_UNITS = {"force": "N", "point": "m", "moment": "N m"}  # of what contacts give


class Forces:
    """Forces that follow by Newton and Euler from a motion; `tree` are the joints that carry bodies.

    touching: names of the forces, points and moments of contacts, which are inputs here.
    """

    def __init__(self, system: System, tree: Sequence[Joint], touching: list[str]) -> None:
        self.system, self.tree, self.touching = system, tree, touching
        self.tape, self.equations = system.tape, system.equations
        self.kin: Any = system.kin

    @cached_property
    def gravity(self) -> Vector:
        """Acceleration of gravity, along the ground's axes."""
        return gravity_vector(self.kin, self.system.scene.all(Gravity))

    @cached_property
    def _of_contacts(self) -> list[dict[str, Any]]:
        """Generalised forces of the contacts, of forces and points that are inputs."""
        forces = []
        inputs = {
            name: self.tape.input(
                name.replace(".", "_"), "touching", Dimension.from_unit(_UNITS[name.split(".")[1][:-2]])
            )
            for name in self.touching
        }

        def vector(whose: str, quantity: str) -> Vector:
            return tuple(inputs.get(f"{whose}.{quantity}_{axis}", sp.S.Zero) for axis in AXES)

        for pair, contact, _ in self.system.contacts:
            force, point = vector(contact.name, "force"), vector(contact.name, "point")
            bodies = pair.touch.first.body, pair.touch.second.body
            forces.append(self.kin.generalised(force, point, *bodies, f"{contact.name}_touch"))
            for effect in self.system.scene.resistances(contact.name):
                moment = vector(effect.name, "moment")
                forces.append(self.kin.generalised_moment(moment, *bodies, f"{effect.name}_touch"))
        return forces

    @cached_property
    def _multipliers(self) -> list[Any]:
        return [
            self.tape.input(
                f"{row.name.replace('.', '_')}_held", "multipliers", Dimension.from_unit(MULTIPLIER_UNITS[row.unit])
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
        inner = [joint.name for joint in self.tree]
        pairs = zip(self.equations.constraints, self._multipliers, strict=True)
        return [(row, force) for row, force in pairs if row.name.split(".")[0] not in inner]

    def inertia(self, body: Body, vector: Vector) -> Vector:
        """Inertia about the mass centre times a vector, along the ground's axes."""
        place = self.kin.tree.places[body]
        turned = self.kin.rotation_of(place.link.orientation, place.link.name)
        about = self.equations.recursion.about_centre(body)
        return self.tape.vector(apply(turned, apply(about, apply(transpose(turned), vector))), f"{body.name}_spin")

    def _wrench(self, body: Body, quantity: str) -> Vector:
        """Force on a body, or moment about its mass centre, but for gravity and the joints that carry bodies."""
        pulls = [{key: value * force for key, value in row.column.items()} for row, force in self._held]
        acting = [*self._acting, *pulls]
        return tuple(
            sp.Add(*(sp.sympify(forces.get(key, 0)) for forces in acting)) for key in wrench_keys(body, quantity)
        )

    @cached_property
    def _transmitted(self) -> dict[Joint, tuple[Vector, Vector]]:
        """Force and moment on the child of each joint that carries it, about its point, with drives."""
        transmitted: dict[Joint, tuple[Vector, Vector]] = {}
        kin, tree = self.kin, self.tree
        for joint in reversed(tree):
            body, name = joint.child.body, joint.name
            if not isinstance(body, Body):
                continue
            place, _, _ = kin.point(joint.child, f"{name}_child")
            centre, _, acceleration = kin.point(Point(body, body.centre), f"{body.name}_centre")
            motion = kin.motion(body)
            w, alpha = motion.angular_velocity, motion.angular_acceleration
            weight = scale(sp.sympify(body.mass), sub(acceleration, self.gravity))
            force = self.tape.vector(sub(weight, self._wrench(body, "force")), f"{name}_needs")
            turning = add(self.inertia(body, alpha), cross(w, self.inertia(body, w)))
            moment = add(sub(turning, self._wrench(body, "moment")), cross(sub(centre, place), force))
            for end in (link for link in kin.tree.links if link.kind == "bend" and link.joint.parent.body == body):
                bent, twisted = self._of_bending(end)
                force, moment = add(force, bent), add(moment, twisted, cross(sub(kin.frame_origin(body), place), bent))
            for beyond in (other for other in tree if other.parent.body == body):
                further, twist = transmitted[beyond]
                there, _, _ = kin.point(beyond.child, f"{beyond.name}_child")
                force, moment = add(force, further), add(moment, twist, cross(sub(there, place), further))
            transmitted[joint] = self.tape.vector(force, f"{name}_passes"), self.tape.vector(moment, f"{name}_twists")
        return transmitted

    def _of_bending(self, end: Any) -> tuple[Vector, Vector]:
        """Force, and moment about its start, that a rod needs beyond those that it needs while straight."""
        kin, start = self.kin, end.joint.parent
        motion, back = kin.motion(start.body), transpose(kin.rotation(start.body))
        _, _, acceleration = kin.point(start, f"{end.joint.name}_start")
        w, alpha, falling = (
            self.tape.vector(apply(back, vector), f"{end.joint.name}_own_{label}")
            for vector, label in (
                (motion.angular_velocity, "spin"),
                (motion.angular_acceleration, "angular_acceleration"),
                (sub(acceleration, self.gravity), "falling"),
            )
        )
        needed = end.rod.needed(w, alpha, falling, [row.acceleration for row in end.rows])
        force, moment = (
            kin.of_rod(end, vector, label) for vector, label in zip(needed, ("needs", "needs_moment"), strict=True)
        )
        return force, moment

    def reaction(self, joint: Joint) -> tuple[Vector, Vector]:
        """Force and moment on the child of a joint, about the child's point: without those along its freedoms."""
        if joint.bends:
            return self._transmitted[joint]
        if joint in self._transmitted:
            return self._without_freedoms(joint, *self._transmitted[joint])
        return self._of_closure(joint)

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
        (on, sign), *_ = sides(joint.child.body, joint.parent.body)
        rows = [(row, force) for row, force in self._held if row.name.split(".")[0] == joint.name and not row.drives]

        def total(quantity: str) -> Vector:
            keys = wrench_keys(on, quantity)
            return tuple(sign * sp.Add(*(value * row.column.get(key, 0) for row, value in rows)) for key in keys)

        force, (place, _, _) = total("force"), self.kin.point(joint.child, f"{joint.name}_child")
        return force, add(total("moment"), cross(sub(self.kin.centre(on), place), force))

    def driving(self) -> Iterator[tuple[Any, Any]]:
        """Each driven row with its reaction."""
        forces = {
            row.key: sp.Add(self.equations.gravity(row), *(sp.sympify(f.get(row.key, 0)) for f in self._acting))
            for row in self.equations.driven
        }
        rows = [*self.equations.driven, *self.equations.prescribed]
        free = [row.acceleration for row in self.equations.free]
        return zip(rows, self.equations.reactions(forces, free, self._multipliers), strict=True)


def _across(vector: Vector, wanted: list[tuple[Vector, Any]]) -> Vector:
    """Vector with wanted components along one or two axes in place of its own; zero for three."""
    if not wanted or (is_zero(vector) and all(value == 0 for _, value in wanted)):
        return vector
    if len(wanted) == 1:
        ((axis, value),) = wanted
        return sub(vector, scale(dot(vector, axis) - value, axis))
    if len(wanted) > 2:
        return ZERO
    (one, first), (two, second) = wanted
    normal, cosine = cross(one, two), dot(one, two)
    size = dot(normal, normal)
    combination = add(scale(first - cosine * second, one), scale(second - cosine * first, two))
    return scale(1 / size, add(scale(dot(vector, normal), normal), combination))
