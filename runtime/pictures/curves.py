"""Curves of a solution for pictures: dense histories beside the ideal mechanism's, in readable units."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.host.lazy import cached_property
from hertzwerk.runtime.solution.history import acceleration_of
from hertzwerk.runtime.start.ideal import IdealMotion, has_clearance, ideal_motion, unknown_because

if TYPE_CHECKING:
    from hertzwerk.runtime.solution.history import History
    from hertzwerk.runtime.solution.impacts import Impact
    from hertzwerk.runtime.solution.solution import Solution

Array = NDArray[np.float64]

SAMPLES = 2000  # of the whole run, beside the accepted steps
IMPACT_SAMPLES = 400
IMPACTS = 200  # most that are sampled; with more a picture of the whole run shows none by itself

_PREFIXES = {"m": (("m", 1.0), ("mm", 1e-3), ("µm", 1e-6)), "s": (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)),
             "N": (("MN", 1e6), ("kN", 1e3), ("N", 1.0), ("mN", 1e-3)), "J": (("kJ", 1e3), ("J", 1.0), ("mJ", 1e-3), ("µJ", 1e-6)),
             "m/s": (("m/s", 1.0), ("mm/s", 1e-3)), "m/s^2": (("km/s²", 1e3), ("m/s²", 1.0))}  # fmt: skip


@dataclass(frozen=True)
class Scale:
    """Unit to show a quantity in: its text and its size in SI."""

    unit: str
    factor: float

    def __call__(self, values: Any) -> Any:
        """Convert SI values to this unit."""
        return np.asarray(values) / self.factor


def scale_of(unit: str, values: Any) -> Scale:
    """Return the largest prefix that keeps the largest of the values above 0.2."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    steps = _PREFIXES.get(unit, ((unit, 1.0),))
    return Scale(*next((step for step in steps if largest >= 0.2 * step[1]), steps[-1] if largest else steps[0]))


@dataclass(frozen=True)
class Motion:
    """Curve of a joint: names of its coordinate, speed and acceleration, and their units."""

    joint: str
    names: tuple[str, str, str]
    units: tuple[str, str, str]


@dataclass(frozen=True)
class Curves:
    """Densely sampled histories of a run: `curves[name]`, SI, over `t` [s]; `time` is the unit of t."""

    run: Solution
    t: Array
    sampled: History
    time: Scale

    @classmethod
    def of(cls, run: Solution) -> Curves:
        """Sample a run between its accepted steps and through its impacts.

        A saved run, or one that kept a grid, has only its rows.
        """
        if not len(run.t):
            raise ValueError(
                f"found no rows to draw: the run stopped at t = {run.t_end:g} s, before the first time asked for"
            )
        time = scale_of("s", run.t[-1])
        if not run.history.steps:
            return cls(run, run.t, run.history, time)
        rows = run.t[:: 1 + len(run.t) // (5 * SAMPLES)]
        whole = np.linspace(run.t[0], run.t[-1], SAMPLES)
        through = [i.t + i.duration * np.linspace(0, 1, 25) for i in run.impacts[:IMPACTS] if i.duration is not None]
        t = np.unique(np.clip(np.concatenate([rows, whole, *through]), run.t[0], run.t[-1]))
        return cls(run, t, run.at(t), time)

    def __getitem__(self, name: str) -> Array:
        return self.sampled[name]

    @cached_property
    def ideal(self) -> IdealMotion | None:
        """The ideal mechanism at the same times; None where there is none, and for a saved run."""
        run = self.run
        if run.history.integrator is None:
            return None
        start = np.array([run[name][0] for name in run.model.coordinates])
        return ideal_motion(run.model, self.t, start, run.history.controls[: run.model.nc])

    @property
    def no_ideal(self) -> str:
        """Explain why a run with clearance is not compared with the ideal mechanism; empty where it is."""
        if self.ideal is not None or self.run.history.integrator is None or not has_clearance(self.run.model):
            return ""
        why = unknown_because(self.run.model) or "it cannot be assembled, or locks on the way"
        return f"No ideal mechanism to compare with: {why}."

    @property
    def motions(self) -> list[Motion]:
        """Joints to show: those that travel, else those that turn, else the quaternions' vector parts.

        The last beside the angular speeds.
        """
        model, units = self.run.model, self.run.history.units
        scalar_parts = (name for i, name in enumerate(model.coordinates) if i not in model.quaternions)
        motions = []
        for coordinate, speed in zip(scalar_parts, model.speeds, strict=False):  # then, what drives integrate
            joint, _, name = coordinate.rpartition(".")
            names = (coordinate, speed, acceleration_of(speed))
            label = joint if speed == f"{joint}.speed" else f"{joint} {name}"
            motions.append(Motion(label, names, (units[names[0]], units[names[1]], units[names[2]])))
        shown = next(unit for unit in ("m", "rad", "1") if any(motion.units[0] == unit for motion in motions))
        return [motion for motion in motions if motion.units[0] == shown]


def impact_curves(run: Solution, impact: Impact) -> tuple[Array, Array, Array]:
    """Return time since the onset [s], normal force [N] and penetration [m] of one impact."""
    end = run.t[-1] if impact.duration is None else min(impact.t + impact.duration, run.t[-1])
    if not run.history.steps:
        chosen = np.flatnonzero((run.t >= impact.t) & (run.t <= end))
        t, sampled = run.t[chosen], run.history
    else:
        t = np.linspace(impact.t, end, IMPACT_SAMPLES)
        sampled, chosen = run.at(t), np.arange(IMPACT_SAMPLES)
    force, penetration = (sampled[f"{impact.contact}.{name}"][chosen] for name in ("normal_force", "penetration"))
    return t - impact.t, force, penetration
