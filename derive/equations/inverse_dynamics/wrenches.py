"""Kinematics that resolves every force for the bodies as well, beside the equations of motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from hertzwerk.derive.declare.mechanism.bodies import Body, Frame
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.module.effect_kinematics import Surroundings
from hertzwerk.derive.expressions.algebra.vectors import Vector, cross, scale, sub
from hertzwerk.derive.program.program import Tape

AXES = "xyz"


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
        forces = super().generalised(force, position, on, against, name)
        for body, sign in sides(on, against):
            moment = cross(sub(position, self.centre(body)), force)
            forces |= self._rows(body, "force", scale(sign, force), name)
            forces |= self._rows(body, "moment", scale(sign, moment), name)
        return forces

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a moment on one body and its reaction on another."""
        forces = super().generalised_moment(moment, on, against, name)
        for body, sign in sides(on, against):
            forces |= self._rows(body, "moment", scale(sign, moment), name)
        return forces

    def _rows(self, body: Body, quantity: str, vector: Vector, name: str) -> dict[str, Any]:
        named = self.tape.vector(vector, f"{name}_{quantity}_on_{body.name}")
        return dict(zip(wrench_keys(body, quantity), named, strict=True))


def wrench_keys(body: Body, quantity: str) -> list[str]:
    """Rows of the force on a body, or of the moment about its mass centre, along the ground's axes."""
    return [f"{body.name}.wrench_{quantity}_{axis}" for axis in AXES]


def sides(on: Frame, against: Frame) -> Iterator[tuple[Body, int]]:
    """Bodies of a force and its reaction, each with its sign."""
    return ((body, sign) for body, sign in ((on, 1), (against, -1)) if isinstance(body, Body))
