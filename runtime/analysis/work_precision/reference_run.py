"""Reference of a study: two independent methods, tightened until they agree, and their difference."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.accuracy.horizon import crossing
from hertzwerk.runtime.engine.integration.tableaux.methods import EXPLICIT, IMPLICIT
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_request import Settings, read
from hertzwerk.runtime.engine.run.single_run import set_up
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

_highest, *_others = reversed(EXPLICIT)
METHODS = (_highest, *IMPLICIT, *_others)  # in order of preference; unlike each other
TOLERANCES = (1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)
AGREED = 1e-12  # at the end: agreement that suffices
LIMITS = {"max_steps": 300_000, "wall_time": 20.0}  # of each run
SAMPLES = 400  # equally spaced, and at most so many of the reference's own steps, which lie close where much happens
MEASURABLE = 3.0  # times the uncertainty of the reference
KNOWN = 1e-6  # error of the reference up to which shortened runs are made


@dataclass(frozen=True)
class Problem:
    """Problem of a study: model, duration and numbers; called with the other arguments of `simulate`."""

    model: EngineModel
    duration: str | float | None
    parameters: Mapping[str, Value] = field(default_factory=dict)
    initial: Mapping[str, Value] = field(default_factory=dict)
    solve: Callable[..., Solution] = simulate

    def build(self, method: str, *, compiled: bool) -> None:
        """Build what runs by a method take once; raises InputError."""
        settings = Settings(self.duration, None, None, method, compiled)
        set_up(self.model, settings, read(self.model, settings, self.parameters, self.initial)[0])

    def __call__(self, **options: Any) -> Solution:
        """Run once; raises InputError, and KeyboardInterrupt where the user stopped the run."""
        arguments = {"duration": self.duration, "parameters": self.parameters, "initial": self.initial}
        run = self.solve(self.model, **{**arguments, **options})
        if run.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return run


class NoReferenceError(Exception):
    """Fewer than two methods reach the end; `runs` are those that did not, by method."""

    def __init__(self, runs: Mapping[str, Solution]) -> None:
        super().__init__("; ".join(f"{method}: {run.outcome.message}" for method, run in runs.items()))
        self.runs = runs


@dataclass(frozen=True)
class Reference:
    """Run taken as the true one, and its partner, at times t (n,) [s] from start to end.

    y, other       their states and rates, shape (n, 2 ny)
    levels         tolerance and difference at the end, as the two were tightened
    """

    run: Solution
    partner: Solution
    t: Array
    y: Array
    other: Array
    levels: tuple[tuple[float, float], ...]

    def error(self, run: Solution) -> Array:
        """Return the error of a run at the times of the reference, shape (n,); nan after its end."""
        return self._along(run, difference)

    def departure(self, run: Solution) -> Array:
        """Return the error of the coordinates alone."""
        return self._along(run, scaling.departure)

    def _along(self, run: Solution, measure: Callable[..., Array]) -> Array:
        reached = self.t <= run.engine.t_end
        errors = np.full(len(self.t), np.nan)
        errors[reached] = measure(
            run.engine.model, self.run.engine.scales, states(run, self.t[reached]), self.y[reached]
        )
        return errors

    @cached_property
    def floor(self) -> Array:
        """Difference of the two runs, shape (n,), below which no error can be measured."""
        return difference(self.run.engine.model, self.run.engine.scales, self.other, self.y)

    @cached_property
    def floor_of_departure(self) -> Array:
        """Difference of the coordinates alone."""
        return scaling.departure(self.run.engine.model, self.run.engine.scales, self.other, self.y)

    @property
    def uncertainty(self) -> float:
        """Uncertainty of the motion as far as it is known, no less than rounding."""
        return max(float(np.max(self.floor[self.t <= self.known])), float(np.finfo(float).eps))

    @property
    def least(self) -> float:
        """The least error that can be measured."""
        return MEASURABLE * self.uncertainty

    @property
    def horizon(self) -> float:
        """Time [s] up to which the reference itself is known to 1 %; infinite if to the end."""
        return crossing(self.t, self.floor_of_departure)

    @property
    def known(self) -> float:
        """Time [s] up to which the reference is accurate enough to measure errors."""
        if self.horizon == np.inf:
            return float(self.t[-1])
        over = np.flatnonzero(self.floor > KNOWN)
        return float(self.t[over[0] - 1]) if over[0] > 1 else min(self.horizon, float(self.t[-1]))


def at_end(difference: Array) -> float:
    """Return the size of a difference (n,) of two runs at the end.

    No less than is typical just before, so that no crossing is taken for agreement.
    """
    return max(float(difference[-1]), float(np.median(difference[-max(1, len(difference) // 10) :])))


def states(run: Solution, t: Array) -> Array:
    """Return states and their rates (n, 2 ny) at times [s] (n,) within a run."""
    history = run.at(t)
    return np.hstack([history.part("y"), history.part("dy")])


def difference(model: EngineModel, scales: Scales, y: Array, reference: Array) -> Array:
    """Return the error (n,) of states with rates (n, 2 ny), see `error_scales.error`."""
    (a, da), (b, db) = (np.split(part, 2, axis=-1) for part in (y, reference))
    return scaling.error(model, scales, a, b, da, db)


def reference(problem: Problem, progress: Callable[[float], object] = lambda _: None) -> Reference:
    """Make the reference of a problem from two methods at the tolerance where they agree best.

    Of the two the run that changed less when tightened. Raises NoReferenceError where no two methods reach the end,
    InputError.
    """
    able, failed = list(METHODS), dict[str, "Solution"]()
    t: Array | None = None
    best: Reference | None = None
    before: dict[str, Array] = {}
    levels: list[tuple[float, float]] = []
    for i, tolerance in enumerate(TOLERANCES):
        progress(i / len(TOLERANCES))
        runs: dict[str, Solution] = {}
        for method in tuple(able):
            run = problem(tolerance=tolerance, method=method, **LIMITS)
            if run.outcome.finished:
                runs[method] = run
            else:
                failed[method] = run
                able.remove(method)
            if len(runs) == 2:
                break
        if len(runs) < 2:
            break
        t = _times(next(iter(runs.values()))) if t is None else t
        by_method = {method: states(run, t) for method, run in runs.items()}
        (one, a), (two, b) = by_method.items()
        change = {
            method: at_end(difference(problem.model, runs[one].engine.scales, y, before[method]))
            if method in before
            else 0.0
            for method, y in by_method.items()
        }
        if change[one] > change[two]:
            (one, a), (two, b) = (two, b), (one, a)
        apart = at_end(difference(problem.model, runs[one].engine.scales, b, a))
        levels.append((tolerance, apart))
        if best is None or apart <= at_end(best.floor):
            best = Reference(runs[one], runs[two], t, a, b, tuple(levels))
        if apart <= AGREED:
            break
        before = by_method
    if best is None:
        raise NoReferenceError(failed)
    return Reference(best.run, best.partner, best.t, best.y, best.other, tuple(levels))


def _times(run: Solution) -> Array:
    """Return the times [s] at which runs are compared."""
    steps = run.t[:: 1 + len(run.t) // SAMPLES]
    return np.unique(np.concatenate([np.linspace(0.0, run.engine.t_end, SAMPLES + 1), steps]))
