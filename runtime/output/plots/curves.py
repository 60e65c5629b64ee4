"""Curves of a solution for pictures: dense histories beside the ideal mechanism's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.engine.run.continuation import parameters_of, with_steps
from hertzwerk.runtime.engine.solution.history import History, acceleration_of
from hertzwerk.runtime.engine.solution.impacts import Impact
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.start.ideal_mechanism import IdealMotion, has_clearance, ideal_motion, unknown_because
from hertzwerk.runtime.output.plots.between_steps import BetweenSteps
from hertzwerk.runtime.output.plots.picture_samples import RESOLVED, Rows, between, dense, end_of, has_steps
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

IMPACT_SAMPLES = 400
KNOTS = (
    500,
    2000,
)  # times at which the ideal mechanism is assembled, more where the first are too few; between them cubics
FROM_ROWS = (
    "Drawn from the rows that were kept, with straight lines between them: of each contact its onset, peak and end."
)


@dataclass(frozen=True)
class Motion:
    """Curve of a joint: names of its coordinate, speed and acceleration, and their units.

    Of a coordinate that a drive integrates there is the first alone.
    """

    joint: str
    names: tuple[str, ...]
    units: tuple[str, ...]


@dataclass(frozen=True)
class Curves:
    """Densely sampled histories of a run: `curves[name]`, SI, over `t` [s]; `time` is the unit of t.

    run: with its steps, where they were kept or the run could be made again.
    """

    run: EngineSolution
    t: Array
    sampled: History | BetweenSteps | Rows
    time: Scale

    @classmethod
    def of(cls, run: EngineSolution) -> Curves:
        """Sample a run between its accepted steps and through its impacts, once for all of its pictures.

        A run that kept a grid is made again for them; a saved one, or a very long one, has only its rows.
        """
        curves = run.engine.shared_results.get(cls)
        if not isinstance(curves, Curves):
            curves = run.engine.shared_results[cls] = cls._sampled(run)
        return curves

    @classmethod
    def _sampled(cls, run: EngineSolution) -> Curves:
        run = with_steps(run)
        if not len(run.t):
            raise ValueError(
                f"found no rows to draw: the run stopped at t = {run.engine.t_end:g} s, before the first requested time"
            )
        sampled = dense(run) if has_steps(run) else Rows(run)
        return cls(run, sampled.t, sampled, scale_of("s", run.t[-1]))

    def __getitem__(self, name: str) -> Array:
        return self.sampled[name]

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks on how the curves were found, and why there is no ideal mechanism beside them."""
        from_rows = () if has_steps(self.run) else (FROM_ROWS,)
        return (*from_rows, *([self.no_ideal] if self.no_ideal else []))

    @cached_property
    def ideal(self) -> IdealMotion | None:
        """The ideal mechanism at the same times; None where there is none, and for a model without functions."""
        run = self.run
        if not self._evaluates:
            return None
        start = np.array([run[name][0] for name in run.engine.model.coordinates])
        live = run.engine.history.integrator is not None
        c = run.engine.history.controls if live else run.engine.model.bind(parameters_of(run, run.engine.model)).c
        for count in KNOTS:
            if len(self.t) <= count:
                return ideal_motion(run.engine.model, self.t, start, c[: run.engine.model.nc])
            knots = np.linspace(self.t[0], self.t[-1], count)
            ideal = ideal_motion(run.engine.model, knots, start, c[: run.engine.model.nc])
            if ideal is None or _resolves(ideal):
                break
        return ideal and _between(ideal, self.t)

    @property
    def _evaluates(self) -> bool:
        """Whether the functions of the run's model, and its inputs, are known."""
        model = self.run.engine.model
        return model.has_function("outputs") and (self.run.engine.history.integrator is not None or not model.inputs)

    @property
    def no_ideal(self) -> str:
        """Explain why a run with clearance is not compared with the ideal mechanism; empty where it is."""
        if self.ideal is not None or not self._evaluates or not has_clearance(self.run.engine.model):
            return ""
        why = unknown_because(self.run.engine.model) or "it cannot be assembled, or locks on the way"
        return f"No ideal mechanism to compare with: {why}."

    @property
    def motions(self) -> list[Motion]:
        """Motions of all joints; of quaternions the vector parts, beside the angular speeds.

        States of effects are no motions.
        """
        model, units = self.run.engine.model, self.run.engine.history.units
        effects = [row[0] for row in model.module.EFFECTS]
        scalar_parts = [name for i, name in enumerate(model.coordinates) if i not in model.quaternions]
        motions = []
        for i, coordinate in enumerate(scalar_parts):
            joint, _, name = coordinate.rpartition(".")
            speed = model.speeds[i] if i < len(model.speeds) else None  # then, what drives integrate
            if speed is None and joint in effects:
                continue
            names = (coordinate,) if speed is None else (coordinate, speed, acceleration_of(speed))
            label = joint if speed in (f"{joint}.speed", None) else f"{joint} {name}"
            motions.append(Motion(label, names, tuple(units[name] for name in names)))
        return motions

    @property
    def kinds(self) -> dict[str, list[Motion]]:
        """Motions by the unit of their coordinate: lengths, angles, parts of quaternions."""
        by_unit: dict[str, list[Motion]] = {unit: [] for unit in ("m", "rad", "1")}
        for motion in self.motions:
            by_unit.setdefault(motion.units[0], []).append(motion)
        return {unit: motions for unit, motions in by_unit.items() if motions}

    def size(self, names: tuple[str, ...]) -> float:
        """Return the scale of some states [SI]; 0 where none is known."""
        states, scales = self.run.engine.states, self.run.engine.scales.state
        known = [float(scales[states.index(name)]) for name in names if name in states and len(scales) == len(states)]
        return max(known, default=0.0)


def _resolves(ideal: IdealMotion) -> bool:
    """Return whether half of its times would give the accelerations of an ideal motion."""
    parts = ideal.t[::2], ideal.q[::2], ideal.u[::2], ideal.acceleration[::2]
    half = _between(IdealMotion(*parts, ideal.coordinates, ideal.speeds), ideal.t).acceleration
    missed, shown = np.max(np.abs(half - ideal.acceleration), axis=0), np.ptp(ideal.acceleration, axis=0)
    return bool(np.all(missed <= RESOLVED * shown))


def _between(ideal: IdealMotion, t: Array) -> IdealMotion:
    """Interpolate the ideal motion by cubics, of positions and speeds with their known slopes."""
    slopes = np.gradient(ideal.q, ideal.t, axis=0, edge_order=2)
    for i, coordinate in enumerate(ideal.coordinates):
        joint, _, name = coordinate.rpartition(".")
        speed = f"{joint}.speed" if f"{joint}.speed" in ideal.speeds else f"{joint}.{name}_speed"
        if speed in ideal.speeds:
            slopes[:, i] = ideal.u[:, ideal.speeds.index(speed)]
    rates = np.gradient(ideal.acceleration, ideal.t, axis=0, edge_order=2)
    q, u, acceleration = (
        _cubic(ideal.t, values, slope, t)
        for values, slope in ((ideal.q, slopes), (ideal.u, ideal.acceleration), (ideal.acceleration, rates))
    )
    return IdealMotion(t, q, u, acceleration, ideal.coordinates, ideal.speeds)


def _cubic(knots: Array, values: Array, slopes: Array, t: Array) -> Array:
    """Interpolate columns at times by cubics with given slopes: scipy.interpolate takes .3 s to import."""
    row = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, len(knots) - 2)
    h = (knots[row + 1] - knots[row])[:, None]
    s = (t - knots[row])[:, None] / h
    (x0, x1), (r0, r1) = (values[row], values[row + 1]), (slopes[row] * h, slopes[row + 1] * h)
    return x0 + s * (r0 + s * (3 * (x1 - x0) - 2 * r0 - r1 + s * (r0 + r1 - 2 * (x1 - x0))))


def impact_curves(run: EngineSolution, impact: Impact) -> tuple[Array, Array, Array]:
    """Return time since the onset [s], normal force [N] and penetration [m] of one impact."""
    end = end_of(impact, run)
    if has_steps(run):
        t = np.linspace(impact.t, end, IMPACT_SAMPLES)
        sampled, chosen = between(run, t), np.full(IMPACT_SAMPLES, fill_value=True)
    else:
        chosen = (run.t >= impact.t) & (run.t <= end)
        t, sampled = run.t[chosen], run.engine.history
    force, penetration = (sampled[f"{impact.contact}.{name}"][chosen] for name in ("normal_force", "penetration"))
    return t - impact.t, force, penetration
