"""Positions of the landmarks of a mechanism, over time or at its start alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.run.continuation import parameters_of, with_steps
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

GROUND = "ground"
SOLIDS = ("solid_", "hole_")
"""Beginnings of the kinds of shapes that a body is made of, or that are taken out of it."""
OUTLINES = ("outline", "track")
"""Names of the points of a curve beside its place, round a solid or not: first all x, then all y, `along` and `across`."""
LARGEST = 1e100  # m: the squares of lengths are numbers
SAMPLES = 1200  # samples between the steps of a run, and most of the steps


@dataclass(frozen=True)
class Landmark:
    """A row of LANDMARKS with its numbers, along the axes of its body.

    point (3,) [m]; beside: directions (3,) and sizes.
    """

    part: str
    kind: str
    place: str
    body: str
    point: Array
    beside: Mapping[str, Array]

    def size(self, name: str) -> float:
        """Return a radius or length [m]."""
        return float(self.beside[name][0])

    @property
    def curve(self) -> Array | None:
        """Points (n, 3) of the curve that is fixed here, along the axes of its body [m]; None without one."""
        outline = next((self.beside[name] for name in OUTLINES if name in self.beside), None)
        if outline is None:
            return None
        return np.asarray(
            self.point + outline.reshape(2, -1).T @ np.array([self.beside["along"], self.beside["across"]])
        )


@dataclass(frozen=True)
class Places:
    """Poses of the bodies and landmarks at the times t (n,) [s]; the ground is the first body.

    origins (n, bodies, 3) [m], rotations (n, bodies, 3, 3); enlarged: whether the sag of flexible rods is.
    """

    model: EngineModel
    t: Array
    bodies: tuple[str, ...]
    landmarks: tuple[Landmark, ...]
    origins: Array
    rotations: Array
    enlarged: bool = True

    @classmethod
    def at_start(
        cls, model: EngineModel, parameters: Mapping[str, Value] | None, initial: Mapping[str, Value] | None
    ) -> Places:
        """Return the places at t = 0, loops closed; raises InputError."""
        from hertzwerk.runtime.engine.start.start_values import start_of

        if not hasattr(model.module, "landmarks"):
            raise _without_functions(model)
        bound, q, _ = start_of(model, {} if parameters is None else parameters, {} if initial is None else initial)
        return cls.at(model, bound, 0.0, q[None])

    @classmethod
    def at(cls, model: EngineModel, bound: BoundParameters, t: float, positions: Array) -> Places:
        """Return the places at coordinates (n, nq) and the time t [s] of drives; their own times count them."""
        poses = [model.evaluate("poses", t, q, bound.c) for q in positions]
        origins, rotations = (np.array(part) for part in zip(*poses, strict=True))
        return cls._of(model, bound.p, np.arange(float(len(poses))), origins, rotations)

    @classmethod
    def over(cls, run: EngineSolution, also: Array | None = None) -> Places:
        """Return the places over a run, between its accepted steps.

        Of a run too long to be made again, at its rows. `also`: further times [s] of a run with steps. Raises
        InputError for a saved run.
        """
        run = with_steps(run)
        if run.engine.history.integrator is None:
            raise _without_functions(run.engine.model)
        if run.engine.history.steps and len(run.t) > 1:
            rows = run.t[:: 1 + len(run.t) // SAMPLES]
            further = np.zeros(0) if also is None else also
            times = np.unique(np.concatenate([rows, np.linspace(run.t[0], run.t[-1], SAMPLES), run.t[-1:], further]))
        else:
            times = run.t[np.unique(np.linspace(0, len(run.t) - 1, min(len(run.t), SAMPLES)).astype(int))]
        positions, rotations = run.at(times).map("poses", "t q")
        good = np.isfinite(positions).all(axis=1) & np.isfinite(rotations).all(
            axis=1
        )  # to where a run came to no good end
        return cls._of(
            run.engine.model,
            run.engine.model.bind(parameters_of(run, run.engine.model)).p,
            times[good],
            positions[good],
            rotations[good],
        )

    @classmethod
    def _of(cls, model: EngineModel, p: Array, t: Array, positions: Array, rotations: Array) -> Places:
        """Return the places; raises InputError where the mechanism is too large to be drawn."""
        n, bodies = len(t), model.module.BODIES
        ground = np.zeros((n, 1, 3)), np.broadcast_to(np.eye(3), (n, 1, 3, 3))
        places = cls(
            model,
            np.asarray(t, dtype=float),
            (GROUND, *bodies),
            landmarks_of(model, p),
            np.concatenate([ground[0], positions.reshape(n, -1, 3)], axis=1),
            np.concatenate([ground[1], rotations.reshape(n, -1, 3, 3)], axis=1),
        )
        if not places.reach <= LARGEST:
            far, most = f"parts {places.reach:.3g} m large or far from the origin", f"at most {LARGEST:g} m"
            raise InputError(model.name, [Fault("drawing", far, most, "check the units of lengths")])
        return places

    @property
    def reach(self) -> float:
        """Largest distance of a landmark from the origin, or size of one [m]; nan where one is not known."""
        with np.errstate(over="ignore", invalid="ignore"):
            parts = [self.point(mark) for mark in self.landmarks]
        parts += [value for mark in self.landmarks for value in mark.beside.values()]
        return float(np.max([np.max(np.abs(part), initial=0.0) for part in parts], initial=0.0))

    def turned(self, body: str, vector: Array) -> Array:
        """Rotate a vector (3,) from a body's axes to the ground's: (n, 3)."""
        return self.rotations[:, self.bodies.index(body)] @ vector

    def point(self, mark: Landmark) -> Array:
        """Return the position of a landmark [m]: (n, 3)."""
        return self.origins[:, self.bodies.index(mark.body)] + self.turned(mark.body, mark.point)

    def direction(self, mark: Landmark, name: str) -> Array:
        """Return a named direction of a landmark: (n, 3)."""
        key = id(mark), name
        if key not in self._directions:
            self._directions[key] = self.turned(mark.body, mark.beside[name])
        return self._directions[key]

    @cached_property
    def _directions(self) -> dict[tuple[int, str], Array]:
        return {}

    def parts(self) -> dict[tuple[str, str], list[Landmark]]:
        """Return the landmarks by part and kind."""
        return grouped(((mark.part, mark.kind), mark) for mark in self.landmarks)

    def of_body(self, body: str) -> list[Landmark]:
        """Return the landmarks fixed in a body."""
        return [mark for mark in self.landmarks if mark.body == body]


def landmarks_of(model: EngineModel, p: Array) -> tuple[Landmark, ...]:
    """Return the landmarks of a model with its parameters p (np,), SI."""
    return tuple(map(_landmark, model.module.LANDMARKS, model.landmarks(p)))


def _without_functions(model: EngineModel) -> InputError:
    actual, remedy = "a saved run, which holds no functions", f"simulate again, or load({model.name!r}).draw()"
    return InputError(
        model.name, [Fault("draw", actual, "a model that `load` returned, a run that `simulate` did", remedy)]
    )


def _landmark(row: tuple[Any, ...], numbers: Array) -> Landmark:
    part, kind, place, body, beside = row
    sizes = [3, *(1 if name in ("radius", "length", "hole_radius") else 3 for name in beside)]
    for name in OUTLINES:
        if name in beside:
            sizes[1 + beside.index(name)] += len(numbers) - sum(sizes)
    point, *values = np.split(numbers, np.cumsum(sizes)[:-1])
    return Landmark(part, kind, place, body, point, dict(zip(beside, values, strict=True)))
