"""Poses, velocities, accelerations and partial velocities of the bodies of a tree, in ground axes.

Everything of a body refers to its joint point O, which is fixed in the body: the vector from O to any other point of the body is short, so
nothing large cancels. Consecutive rotations about parallel axes merge into one angle; structural zeros make plane mechanisms plane.
Kane, Levinson, Dynamics: Theory and Applications (1985), chapter 2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import sympy as sp

from hertzwerk.derive.dimension import Dimension
from hertzwerk.derive.effects.drives import AnyDrive
from hertzwerk.derive.effects.expression import COORDINATE, TIME, StateSymbol, T, as_choice, states_in
from hertzwerk.derive.mechanism import GROUND, Body, Frame, Joint, Mechanism, Point, Revolute
from hertzwerk.derive.program import Tape
from hertzwerk.derive.scene import Scene
from hertzwerk.derive.units import parse_unit
from hertzwerk.derive.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    cross,
    dot,
    multiply,
    rotation,
    scale,
    sub,
)


@dataclass(frozen=True)
class Orientation:
    """Rotation `base * Rot(axis, angle)` of a body frame against the ground; the last rotation stays open for a parallel one."""

    base: Matrix
    axis: tuple[int, int, int]
    angle: Any
    matrix: Matrix


@dataclass(frozen=True)
class Motion:
    """Of one body: joint point O, angular velocity, velocity of O; `bias` accelerations are those at zero generalised accelerations."""

    orientation: Orientation
    origin: Vector
    angular_velocity: Vector
    velocity: Vector
    angular_bias: Vector
    bias: Vector
    angular_acceleration: Vector
    acceleration: Vector


@dataclass(frozen=True)
class JointMotion:
    """Of one joint: its axis in ground axes, its coordinate, speed and acceleration, and the vector from the parent's O to the child's."""

    joint: Joint
    axis: Vector
    coordinate: Any
    speed: Any
    acceleration: Any
    free: bool
    offset: Vector
    offset_in_parent: Vector
    """The same vector in the parent's frame: its length is constant there, which ground axes would hide."""

    @property
    def body(self) -> Body:
        """The joint's child."""
        body = self.joint.child.body
        if not isinstance(body, Body):
            raise TypeError(f"joint {self.joint.name} moves the ground")
        return body

    @property
    def revolute(self) -> bool:
        """Rotation or translation."""
        return isinstance(self.joint, Revolute)


@dataclass(frozen=True)
class DriveState:
    """What a drive integrates, an entry of q without a speed in u: its port and unit, symbol, rate, and value at t = 0."""

    port: str
    unit: str
    symbol: sp.Symbol
    rate: Any
    start: Any


_STILL = Orientation(IDENTITY, (0, 0, 1), sp.S.Zero, IDENTITY)
_GROUND = Motion(_STILL, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO)


class Kinematics:
    """Motions of all bodies of a scene, recorded on a tape. `q`, `u`, `a` are the free coordinates, speeds, accelerations; `t` is time."""

    def __init__(self, tape: Tape, scene: Scene) -> None:
        self.tape = tape
        self.mechanism: Mechanism = scene.mechanism
        self.t = tape.input("t", "t", Dimension.from_unit(parse_unit("s"), {}))
        tape.set_rate(self.t, sp.S.One)
        free = scene.free_joints
        self.q = [self._input(joint, joint.motion, "q", joint.coordinate_unit) for joint in free]
        self.u = [self._input(joint, "speed", "u", joint.speed_unit) for joint in free]
        self.a = [self._input(joint, "acceleration", "a", f"{joint.speed_unit}^2") for joint in free]
        for q, u, a in zip(self.q, self.u, self.a, strict=True):
            tape.set_rate(q, u)
            tape.set_rate(u, a)
        self.motions: dict[Frame, Motion] = {GROUND: _GROUND}
        self.joints: dict[str, JointMotion] = {}
        self.drive_states: list[DriveState] = []
        states = {joint.name: (q, u, a) for joint, q, u, a in zip(free, self.q, self.u, self.a, strict=True)}
        for joint in self.mechanism.joints:
            if joint.name in states:
                self._move(joint, *states[joint.name], free=True)
            else:
                self._move(joint, *self._driven(joint, scene.driven[joint.name]), free=False)

    def _input(self, joint: Joint, what: str, group: str, unit: str) -> sp.Symbol:
        return self.tape.input(f"{joint.name}_{what}", group, Dimension.from_unit(parse_unit(unit), {}))

    def _driven(self, joint: Joint, drive: AnyDrive) -> tuple[Any, Any, Any]:
        """Coordinate, speed and acceleration of a driven joint: the drive's law and its derivatives, and below it the states that integrate it."""
        motion = drive.motion
        ports = ((joint.motion, joint.coordinate_unit), ("speed", joint.speed_unit))
        names = [f"{joint.name}_{what}" for what in (joint.motion, "speed", "acceleration")]
        chain: list[Any] = [self._input(joint, ports[order][0], "q", ports[order][1]) for order in range(motion.order)]
        law = motion.law.xreplace({T: self.t})
        uniform = motion.order == 0 and sp.diff(law, self.t, 2) == 0  # one product, named where it is used
        chain.append(law if uniform else self.tape.let(law, names[motion.order]))
        while len(chain) < 3:
            law = sp.diff(law, self.t)
            chain.append(self.tape.let(law, names[len(chain)]))
        for low, high in pairwise(chain):
            self.tape.set_rate(low, high)
        for order, start in enumerate(motion.start):
            (what, unit), symbol, rate = ports[order], chain[order], chain[order + 1]
            self.drive_states.append(DriveState(f"{joint.name}.{what}", unit, symbol, rate, sp.sympify(start)))
        return chain[0], chain[1], chain[2]

    def expression(self, value: Any) -> Any:
        """An expression of a scene over the tape: time, and the coordinates and speeds of free and driven joints."""
        value = as_choice(value)
        return value.xreplace({symbol: self._state(symbol) for symbol in states_in(value)})

    def _state(self, symbol: StateSymbol) -> Any:
        if symbol.what == TIME:
            return self.t
        joint = self.joints[symbol.joint]
        return joint.coordinate if symbol.what == COORDINATE else joint.speed

    def _move(self, joint: Joint, q: Any, u: Any, a: Any, free: bool) -> None:
        tape, name = self.tape, joint.child.body.name
        parent = self.motions[joint.parent.body]
        on_parent = sub(_sympify(joint.parent.position), self._anchor(joint.parent.body))
        axis = tape.vector(apply(parent.orientation.matrix, _sympify(joint.axis.components)), f"{joint.name}_axis")
        turning = isinstance(joint, Revolute)
        offset_in_parent = on_parent if turning else add(on_parent, scale(q, _sympify(joint.axis.components)))
        offset = tape.vector(apply(parent.orientation.matrix, offset_in_parent), f"{name}_arm")
        w, alpha, alpha_bias = parent.angular_velocity, parent.angular_acceleration, parent.angular_bias
        orientation = parent.orientation
        spin = tape.vector(cross(w, offset), f"{name}_arm_rate")
        centripetal = cross(w, spin)
        velocity = add(parent.velocity, spin)
        bias = add(parent.bias, cross(alpha_bias, offset), centripetal)
        acceleration = add(parent.acceleration, cross(alpha, offset), centripetal)
        if turning:
            orientation = self._turn(parent.orientation, joint, q, name)
            gyro = cross(w, scale(u, axis))
            w = tape.vector(add(w, scale(u, axis)), f"{name}_rate")
            alpha_bias = tape.vector(add(alpha_bias, gyro, ZERO if free else scale(a, axis)), f"{name}_angular_bias")
            alpha = tape.vector(add(alpha, gyro, scale(a, axis)), f"{name}_angular_acceleration")
        else:
            coriolis = scale(2 * u, cross(w, axis))
            velocity = add(velocity, scale(u, axis))
            bias = add(bias, coriolis, ZERO if free else scale(a, axis))
            acceleration = add(acceleration, coriolis, scale(a, axis))
        origin = tape.vector(add(parent.origin, offset), name)
        velocity = tape.vector(velocity, f"{name}_velocity")
        acceleration = tape.vector(acceleration, f"{name}_acceleration")
        for position, rate, second in zip(origin, velocity, acceleration, strict=True):
            tape.set_rate(position, rate)
            tape.set_rate(rate, second)
        self.motions[joint.child.body] = Motion(
            orientation, origin, w, velocity, alpha_bias, tape.vector(bias, f"{name}_bias"), alpha, acceleration
        )
        self.joints[joint.name] = JointMotion(joint, axis, q, u, a, free, offset, offset_in_parent)

    def _turn(self, parent: Orientation, joint: Joint, angle: Any, name: str) -> Orientation:
        """Rotate on; about a parallel axis the angles add."""
        axis = joint.axis.components
        base, total = parent.matrix, angle
        if parent.angle == 0 or axis in (parent.axis, tuple(-k for k in parent.axis)):
            sign = 1 if axis == parent.axis or parent.angle == 0 else -1
            base, total = parent.base, parent.angle * sign + angle
        total = self.tape.let(total, f"{name}_angle")
        cosine, sine = self.tape.let(sp.cos(total), f"cos_{name}"), self.tape.let(sp.sin(total), f"sin_{name}")
        matrix = self.tape.matrix(multiply(base, rotation(axis, cosine, sine)), f"{name}_R")
        return Orientation(base, axis, total, matrix)

    def _anchor(self, body: Frame) -> Vector:
        """Of a body: its joint point in its own frame."""
        joint = self.mechanism.joint_of(body)
        return ZERO if joint is None else _sympify(joint.child.position)

    # -- points and paths ------------------------------------------------------------------------------------------

    def arm(self, point: Point, name: str) -> Vector:
        """From its body's O to the point, ground axes [m]."""
        local = sub(_sympify(point.position), self._anchor(point.body))
        return self.tape.vector(apply(self.motions[point.body].orientation.matrix, local), f"{name}_arm")

    def frame_origin(self, body: Body) -> Vector:
        """Origin of the body's frame [m]."""
        return add(self.motions[body].origin, self.arm(Point(body), f"{body.name}_frame"))

    def centre_arm(self, body: Body) -> Vector:
        """From O to the mass centre, ground axes [m]."""
        return self.arm(Point(body, body.centre), f"{body.name}_centre")

    def point(self, point: Point, name: str) -> tuple[Vector, Vector, Vector]:
        """Position, velocity, acceleration (with the generalised accelerations) of a point [m, m/s, m/s^2]."""
        motion, arm = self.motions[point.body], self.arm(point, name)
        spin = self.tape.vector(cross(motion.angular_velocity, arm), f"{name}_arm_rate")
        return (
            add(motion.origin, arm),
            add(motion.velocity, spin),
            add(motion.acceleration, cross(motion.angular_acceleration, arm), cross(motion.angular_velocity, spin)),
        )

    def velocity_at(self, body: Frame, position: Vector) -> Vector:
        """Velocity of the point of `body` that is at `position` [m/s]."""
        motion = self.motions[body]
        return add(motion.velocity, cross(motion.angular_velocity, sub(position, motion.origin)))

    def path(self, body: Frame) -> list[JointMotion]:
        """The joints between the ground and `body`, from the ground outwards."""
        joint = self.mechanism.joint_of(body)
        return [] if joint is None else [*self.path(joint.parent.body), self.joints[joint.name]]

    def partial(self, joint: JointMotion, position: Vector) -> Vector:
        """Partial velocity, by the joint's speed, of a point at `position` beyond the joint [1 or m]."""
        if not joint.revolute:
            return joint.axis
        return cross(joint.axis, sub(position, self.motions[joint.joint.child.body].origin))

    def generalised(self, force: Vector, position: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by joint, of a force on one body and its reaction on another at the same point; common joints cancel."""
        return self._between(on, against, lambda joint: dot(force, self.partial(joint, position)), name)

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """The same of a moment on one body and its reaction on another."""
        return self._between(on, against, lambda joint: dot(moment, joint.axis) if joint.revolute else sp.S.Zero, name)

    def _between(self, on: Frame, against: Frame, effect: Callable[[JointMotion], Any], name: str) -> dict[str, Any]:
        first, second = self.path(on), self.path(against)
        common = {joint.joint.name for joint in first} & {joint.joint.name for joint in second}
        return {
            joint.joint.name: self.tape.let(sign * effect(joint), f"{name}_on_{joint.joint.name}")
            for sign, path in ((1, first), (-1, second))
            for joint in path
            if joint.joint.name not in common
        }


def _sympify(vector: Sequence[Any]) -> Vector:
    x, y, z = (sp.sympify(component) for component in vector)
    return (x, y, z)
