"""Equations of motion of a tree: mass matrix, bias, gravity, accelerations, drive reactions, energy.

Kane's equations by composite bodies: what hangs on a joint moves as one rigid body with it, so one column of the mass matrix is the momentum of that
composite under the joint's unit speed, seen by the joints below (Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 6, with every
quantity in ground axes about its joint point).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.kinematics import JointMotion, Kinematics
from hertzwerk.derive.mechanism import Body
from hertzwerk.derive.scene import Scene
from hertzwerk.derive.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    combine,
    cross,
    diagonal,
    dot,
    multiply,
    outer,
    scale,
    transpose,
)


@dataclass(frozen=True)
class Composite:
    """A body with all that hangs on it: mass, first moment and inertia about its O, and the force and moment its bias accelerations take."""

    mass: Any
    moment: Vector
    inertia: Matrix
    force: Vector
    torque: Vector


def _scaled(factor: Any, matrix: Matrix) -> Matrix:
    return (scale(factor, matrix[0]), scale(factor, matrix[1]), scale(factor, matrix[2]))


class Equations:
    """Equations of one scene on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, scene: Scene) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.scene = scene
        self.joints = list(kinematics.joints.values())
        self.free = [joint for joint in self.joints if joint.free]
        self.driven = [joint for joint in self.joints if not joint.free]
        self.inertias = {body: self._inertia(body) for body in scene.mechanism.bodies}
        self.composites: dict[Body, Composite] = {}
        for joint in reversed(self.joints):
            self._compose(joint.body)

    # -- mass matrix and bias --------------------------------------------------------------------------------------

    def _inertia(self, body: Body) -> Matrix:
        """About O, ground axes; the parallel-axis shift is done in the body's frame, where it is constant [kg m^2]."""
        mechanism = self.scene.mechanism
        joint, turning = mechanism.joint_of(body), mechanism.turning_axis(body)
        axis = (0, 0, 0) if turning is None else turning.components
        about_axis = tuple(body.inertia * abs(component) for component in axis)
        own = diagonal(*(body.inertia if isinstance(body.inertia, tuple) else about_axis))
        centre = tuple(sp.sympify(c) - sp.sympify(p) for c, p in zip(body.centre, joint.child.position, strict=True))  # type: ignore[union-attr]
        local = combine(own, _scaled(body.mass, _steiner(centre, dot(centre, centre))))
        local = self.tape.matrix(local, f"{body.name}_I")
        rotation = self.kin.motions[body].orientation.matrix
        return self.tape.matrix(multiply(multiply(rotation, local), transpose(rotation)), f"{body.name}_J")

    def _compose(self, body: Body) -> None:
        tape, name, motion = self.tape, body.name, self.kin.motions[body]
        arm, w, mass = self.kin.centre_arm(body), motion.angular_velocity, sp.sympify(body.mass)
        first = tape.vector(scale(mass, arm), f"{name}_moment")
        inertia = self.inertias[body]
        force = add(
            scale(mass, motion.bias),
            cross(motion.angular_bias, first),
            cross(w, tape.vector(cross(w, first), f"{name}_moment_rate")),
        )
        momentum = tape.vector(apply(inertia, w), f"{name}_spin")
        torque = add(apply(inertia, motion.angular_bias), cross(w, momentum), cross(first, motion.bias))
        for joint in self.joints:
            if joint.joint.parent.body != body:
                continue
            child, shift = self.composites[joint.body], joint.offset
            mass = mass + child.mass
            first = add(first, child.moment, scale(child.mass, shift))
            inertia = combine(inertia, child.inertia, self._shifted(child, joint))
            force = add(force, child.force)
            torque = add(torque, child.torque, cross(shift, child.force))
        self.composites[body] = Composite(
            tape.let(mass, f"{name}_total_mass"),
            tape.vector(first, f"{name}_total_moment"),
            tape.matrix(inertia, f"{name}_total_J"),
            tape.vector(force, f"{name}_bias_force"),
            tape.vector(torque, f"{name}_bias_torque"),
        )

    def _shifted(self, child: Composite, joint: JointMotion) -> Matrix:
        """What moving a composite's inertia to its parent's O adds."""
        shift, moment = joint.offset, child.moment
        squared = dot(joint.offset_in_parent, joint.offset_in_parent)
        both = combine(outer(moment, shift), outer(shift, moment))
        return combine(
            _scaled(child.mass, _steiner(shift, squared)),
            _scaled(2 * dot(moment, shift), IDENTITY),
            _scaled(sp.S.NegativeOne, both),
        )

    def _column(self, joint: JointMotion) -> dict[str, Any]:
        """Mass matrix entries of one joint with itself and the joints below it, by joint name."""
        composite = self.composites[joint.body]
        name = joint.joint.name
        if joint.revolute:
            force, torque = cross(joint.axis, composite.moment), apply(composite.inertia, joint.axis)
        else:
            force, torque = scale(composite.mass, joint.axis), cross(composite.moment, joint.axis)
        column: dict[str, Any] = {}
        for below in reversed(self.kin.path(joint.body)):
            seen = dot(below.axis, torque if below.revolute else force)
            column[below.joint.name] = self.tape.let(seen, f"M_{name}_{below.joint.name}")
            torque = self.tape.vector(add(torque, cross(below.offset, force)), f"{name}_torque")
        return column

    def mass_matrix(self) -> dict[tuple[str, str], Any]:
        """Entries by pair of joint names, free and driven, structural zeros left out."""
        entries: dict[tuple[str, str], Any] = {}
        for joint in self.joints:
            for other, value in self._column(joint).items():
                if value != 0:
                    entries[joint.joint.name, other] = entries[other, joint.joint.name] = value
        return entries

    def bias(self, joint: JointMotion) -> Any:
        """Generalised inertia force at zero generalised accelerations [N m or N]."""
        composite = self.composites[joint.body]
        return dot(joint.axis, composite.torque if joint.revolute else composite.force)

    # -- forces and accelerations ----------------------------------------------------------------------------------

    def gravity(self, joint: JointMotion) -> Any:
        """Generalised force of gravity; 0 where the scene has none [N m or N]."""
        composite = self.composites[joint.body]
        pull = self._gravity_vector()
        return dot(joint.axis, cross(composite.moment, pull) if joint.revolute else scale(composite.mass, pull))

    def _gravity_vector(self) -> Vector:
        effects = self.scene.of_kind("gravity")
        if not effects:
            return ZERO
        x, y, z = effects[0].direction.components
        return scale(sp.sympify(effects[0].acceleration), (sp.sympify(x), sp.sympify(y), sp.sympify(z)))

    def accelerations(self, forces: dict[str, Any]) -> list[Any]:
        """Of the free joints, from M a = f - bias by an unrolled L D L^T without pivoting (M is positive definite)."""
        tape = self.tape
        names = [joint.joint.name for joint in self.free]
        mass = self.mass_matrix()
        right = {
            joint.joint.name: tape.let(forces[joint.joint.name] - self.bias(joint), f"{joint.joint.name}_net")
            for joint in self.free
        }
        lower: dict[tuple[str, str], Any] = {}
        diagonal: dict[str, Any] = {}
        work: dict[tuple[str, str], Any] = {}
        # Leaves first: eliminating a chain from its end keeps the branches' zeros.
        order = names[::-1]
        for i, row in enumerate(order):
            for k in order[:i]:
                terms = [
                    lower[k, j] * work[row, j] for j in order[: order.index(k)] if (k, j) in lower and (row, j) in work
                ]
                value = tape.let(mass.get((row, k), sp.S.Zero) - sp.Add(*terms), f"L_{row}_{k}")
                if value != 0:
                    work[row, k] = value
                    lower[row, k] = tape.let(value / diagonal[k], f"l_{row}_{k}")
            terms = [lower[row, j] * work[row, j] for j in order[:i] if (row, j) in lower]
            diagonal[row] = tape.let(mass[row, row] - sp.Add(*terms), f"D_{row}")
        solved: dict[str, Any] = {}
        for i, row in enumerate(order):
            terms = [lower[row, k] * solved[k] for k in order[:i] if (row, k) in lower]
            solved[row] = tape.let(right[row] - sp.Add(*terms), f"y_{row}") if terms else right[row]
        result: dict[str, Any] = {}
        for i in reversed(range(len(order))):
            row = order[i]
            terms = [lower[k, row] * result[k] for k in order[i + 1 :] if (k, row) in lower]
            result[row] = tape.let(solved[row] / diagonal[row] - sp.Add(*terms), f"{row}_acc")
        return [result[name] for name in names]

    def reactions(self, forces: dict[str, Any], accelerations: list[Any]) -> list[Any]:
        """What each drive must supply: its row of M a + bias - f [N m or N]."""
        mass = self.mass_matrix()
        out = []
        for joint in self.driven:
            name = joint.joint.name
            terms = [
                mass[name, f.joint.name] * a
                for f, a in zip(self.free, accelerations, strict=True)
                if (name, f.joint.name) in mass
            ]
            out.append(self.tape.let(sp.Add(*terms) + self.bias(joint) - forces[name], f"{name}_reaction"))
        return out

    # -- energy ----------------------------------------------------------------------------------------------------

    def kinetic(self) -> Any:
        """[J]."""
        half = sp.Rational(1, 2)
        total = []
        for body, inertia in self.inertias.items():
            motion = self.kin.motions[body]
            v, w = motion.velocity, motion.angular_velocity
            first = self.tape.vector(scale(sp.sympify(body.mass), self.kin.centre_arm(body)), f"{body.name}_moment")
            total.append(
                half * sp.sympify(body.mass) * dot(v, v) + dot(v, cross(w, first)) + half * dot(w, apply(inertia, w))
            )
        return self.tape.let(sp.Add(*total), "kinetic")

    def potential(self) -> Any:
        """Of gravity, zero at the ground's origin [J]."""
        pull = self._gravity_vector()
        total = []
        for body in self.inertias:
            centre = add(self.kin.motions[body].origin, self.kin.centre_arm(body))
            total.append(-sp.sympify(body.mass) * dot(centre, pull))
        return self.tape.let(sp.Add(*total), "potential")


def _steiner(shift: Vector, squared: Any) -> Matrix:
    """|r|^2 1 - r r^T, with |r|^2 given."""
    return combine(_scaled(squared, IDENTITY), _scaled(sp.S.NegativeOne, outer(shift, shift)))
