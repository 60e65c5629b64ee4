"""Kinematics as effects need it, with coordinates of closing joints and geometry of journals."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import Any

from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.absolute_coordinates import Quaternion, between, quaternion_of, turned
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.loop_closure import Closure, Measured, measured
from hertzwerk.derive.program.program import Tape


class Surroundings(Kinematics):
    """Kinematics of a scene on whose joints and pairs effects act."""

    def __init__(self, tape: Tape, scene: Scene) -> None:
        super().__init__(tape, scene)
        self._measured: Callable[[str], Measured] = cache(partial(measured, self))

    def coordinate(self, key: str) -> Any:
        """Coordinate of a scalar freedom, free, driven or measured on a closing joint [rad or m]."""
        return super().coordinate(key) if key in self.states else self._measured(key).value

    def speed(self, key: str) -> Any:
        """Rate of the coordinate [rad/s or m/s]."""
        return super().speed(key) if key in self.states else self._measured(key).rate

    def on_joint(self, key: str, force: Any, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a force along a slide or a torque about a turn.

        It acts on the child, its reaction on the parent.
        """
        if key in self.states:
            return {key: force}
        return {
            row: self.tape.let(force * share, f"{name}_on_{row.replace('.', '_')}")
            for row, share in self._measured(key).column.items()
        }

    def turn_between(self, first: Point, second: Point, name: str) -> Quaternion:
        """Quaternion from the axes of one point to those of another."""
        one, two = (turned(quaternion_of(self, point.body), point) for point in (first, second))
        return between(two, one, self.tape, name)

    def along_track(self, joint: str) -> Any:
        """Parameter of a track's curve where its point is."""
        track = next(other for other in self.mechanism.closures if other.name == joint)
        return Closure(self, track).on_curve(track.curves[0])[1].parameter

    def journal(self, pair: str) -> Any:
        """Pin and bush of this name, on the tape; raises TypeError for a pair that holds no film."""
        touch = self.touch(pair)
        if not touch.pair.holds_film:
            raise TypeError(f"{pair} is no pin in a bush")
        return touch
