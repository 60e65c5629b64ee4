"""Measurement of a scene's outputs with errors, from several runs at different tolerances.

Within the horizon of a run the error is the change by finer tolerances. Beyond it single runs part whatever the
tolerance: the runs are then samples, and an output is their mean, its error half the 95 % interval of that mean. The
mean of so many short runs needs no period and no steady state; an average over one long run has the interval of its
own blocks (`averages`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.runtime.analysis.effect_study.compared_outputs import Output
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.signal import WIDTH
from hertzwerk.runtime.engine.run.run_request import TOLERANCES, Compiled, Settings, check, is_real
from hertzwerk.runtime.engine.solution import error_scales
from hertzwerk.runtime.engine.solution.dense_output import Samples
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.simulation import simulate

FINER = 30.0  # ratio of the first tolerance to the last
ROUNDED = 1e-12  # least tolerance: finer ones only show rounding
FINEST = ROUNDED * FINER  # least first tolerance
EIGHTHS = range(9)  # of the way to the last tolerance: runs past the horizon
LADDER = (0, 1), (4, 3), (8, 7)  # runs of every scene, each with the substitute if it does not finish
SAFETY = 2.0  # on the largest difference between the runs of a ladder
STUDENT = {7: 2.447, 8: 2.365, 9: 2.306}  # quantile of 97.5 % by the number of samples; fewer are too few
ROUNDING = 1e-13  # relative, of any output
SAME = 1e-11  # relative: largest difference of accelerations of the same motion


@dataclass(frozen=True)
class Number:
    """Value of an output and its error, half the width of an interval, both in SI."""

    value: float
    error: float


@dataclass(frozen=True)
class Measurement:
    """Outputs of one scene, none if the run did not finish; `lacking`: reasons for missing ones.

    past_horizon    the runs part: the numbers are means of several
    failed    outcomes of runs that did not finish, and were replaced or left out
    """

    outcome: Outcome
    numbers: Mapping[str, Number] = field(default_factory=dict)
    lacking: Mapping[str, str] = field(default_factory=dict)
    past_horizon: bool = False
    failed: tuple[str, ...] = ()


@dataclass(frozen=True)
class Case:
    """Scene to be run; start: coordinates and speeds in place of its own."""

    model: EngineModel
    start: Mapping[str, tuple[float, str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Bench:
    """Settings of every run of a study.

    values: parameters and initial states, applied to those scenes that have them.
    """

    duration: str | float | None
    tolerance: float
    method: str
    values: Mapping[str, Value]

    def __post_init__(self) -> None:
        low, high = FINEST, TOLERANCES[1]
        if not (is_real(self.tolerance) and low <= self.tolerance <= high):
            expected = f"a number in {low:g}..{high:g}"
            remedy = f"runs at tolerances down to a {FINER:g}th of it show the error"
            raise InputError("effects", [Fault("tolerance", shown(self.tolerance), expected, remedy)])

    @property
    def finest(self) -> float:
        """The finest of the tolerances."""
        return self.tolerance_of(EIGHTHS[-1])

    def tolerance_of(self, eighths: int) -> float:
        """Return the tolerance of a run, so many eighths of the way to the finest one."""
        return max(self.tolerance * math.pow(FINER, -eighths / 8), ROUNDED)

    def check(self, case: Case, compiled: Compiled, before: Sequence[Fault] = ()) -> None:
        """Check the input of a case without a run; raises InputError with `before` and every fault found."""
        settings = Settings(self.duration, None, self.tolerance, self.method, compiled)
        check(case.model, settings, *self._known(case.model), before)

    def simulate(self, case: Case, eighths: int = 0, **options: Any) -> EngineSolution:
        """Run a case once; raises InputError, and KeyboardInterrupt where it was stopped."""
        settings = {
            **options,
            "duration": self.duration,
            "method": self.method,
            "tolerance": self.tolerance_of(eighths),
        }
        parameters, initial = self._known(case.model)
        run = simulate(case.model, parameters=parameters, initial={**case.start, **initial}, **settings)
        if run.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return run

    def parameters(self, model: EngineModel) -> dict[str, Value]:
        """Return the values of parameters that a scene has."""
        return self._known(model)[0]

    def _known(self, model: EngineModel) -> tuple[dict[str, Value], dict[str, Value]]:
        """Return the values that a scene has: parameters, initial states."""
        others, initial = split_values(model, self.values)
        return {name: value for name, value in others.items() if name in model.parameters}, initial

    def unknown_of(self, model: EngineModel) -> list[str]:
        """Return the names of values that a scene does not have."""
        parameters, initial = self._known(model)
        return [name for name in self.values if name not in parameters and name not in initial]

    def measure(self, case: Case, outputs: Sequence[Output]) -> Measurement:
        """Measure the outputs of a case, from as many runs as needed; raises InputError."""
        used: set[int] = set()
        failed: list[Outcome] = []

        def finished(*tries: int) -> EngineSolution | None:
            for eighths in tries:
                used.add(eighths)
                run = self.simulate(case, eighths, compiled=False)
                if run.outcome.finished:
                    return run
                failed.append(run.outcome)
            return None

        ladder = [run for tries in LADDER if (run := finished(*tries)) is not None]
        if len(ladder) < len(LADDER):
            return Measurement(failed[-1])
        past = self._diverges(ladder)
        lacking = {
            output.name: f"there is no {missing}" for output in outputs if (missing := output.missing(ladder[-1]))
        }
        further = (finished(eighths) for eighths in EIGHTHS if eighths not in used) if past else ()
        values = []
        for run in chain(ladder, filter(None, further)):
            samples = Samples(run)
            values.append({output.name: output.of(samples) for output in outputs if output.name not in lacking})
        if past and len(values) not in STUDENT:
            return Measurement(failed[-1])
        numbers: dict[str, Number] = {}
        for output in outputs:
            if output.name not in lacking:
                number = _number(output, [of[output.name] for of in values], ladder[-1], past=past)
                if isinstance(number, str):
                    lacking[output.name] = number
                else:
                    numbers[output.name] = number
        ends = tuple(outcome.message for outcome in failed)
        return Measurement(ladder[-1].outcome, numbers, lacking, past, ends)

    def measure_once(self, case: Case, outputs: Sequence[Output]) -> dict[str, float] | None:
        """Return the outputs of a single run; None where it lacks one or does not finish."""
        run = self.simulate(case, compiled=False)
        if not run.outcome.finished or any(output.missing(run) for output in outputs):
            return None
        samples = Samples(run)
        numbers = {output.name: output.of(samples) for output in outputs}
        values = {name: value for name, value in numbers.items() if value is not None}
        return values if len(values) == len(numbers) else None

    def _diverges(self, runs: Sequence[EngineSolution]) -> bool:
        """Return whether runs at the coarsest and at the finest tolerance end in different states."""
        first, last = runs[0], runs[-1]
        ends = (run.engine.history.part("y")[-1] for run in (first, last))
        return float(error_scales.error(first.engine.model, last.engine.scales, *ends)) > VALID

    def same_motion(self, run: EngineSolution, model: EngineModel) -> bool:
        """Return whether another scene has the accelerations of a run, to rounding, in every state of it.

        Then both move alike, whatever the runs say.
        """
        whole = run.engine.model
        if (whole.coordinates, whole.speeds, whole.pairs) != (model.coordinates, model.speeds, model.pairs):
            return False
        if (whole.latches, whole.slips) != (model.latches, model.slips):
            return False
        y, speeds = run.engine.history.part("y"), slice(whole.nq, whole.nq + whole.nu)
        shared = [name for name in model.memory if name in whole.memory]
        if len(shared) < model.nz:
            return False
        memory = [whole.nq + whole.nu + whole.memory.index(name) for name in model.memory]
        states = np.hstack([y[:, : whole.nq + whole.nu], y[:, memory]])
        parts = [run.engine.history.part(name) for name in ("mode", "m")]
        if model.inputs:
            columns = [WIDTH * list(whole.inputs).index(name) + k for name in model.inputs for k in range(WIDTH)]
            parts.append(run.engine.history.part("pieces")[:, columns])
        (rates,) = _rates(model)(model.bind(self.parameters(model)).c, run.engine.history.part("t"), states, *parts)
        here = run.engine.history.part("dy")[:, speeds]
        size = np.max(np.abs(here), axis=0, initial=0.0)
        return bool(np.all(np.abs(rates[:, speeds] - here) <= SAME * size))


@per_model
def _rates(model: EngineModel) -> Rowwise:
    return Rowwise(model.with_pieces(flow(model).rates, 4), constant=4)


def _number(output: Output, values: Sequence[float | None], finest: EngineSolution, *, past: bool) -> Number | str:
    """Return an output from its values in the runs, those of the ladder first; or why there is none."""
    if any(value is None for value in values):
        return "there is nothing to measure"
    if output.half_width is None:
        return _mean(values) if past else _converged(values)
    half_width = output.half_width(finest)
    if half_width is None:
        return "the run is too short, or changes too slowly, for an interval"
    last = _converged(values[: len(LADDER)])
    return Number(last.value, half_width + (0.0 if past else last.error))


def _converged(values: Sequence[Any]) -> Number:
    """Return the last of values from ever finer runs; its error by the differences to the others."""
    finest = values[-1]
    error = SAFETY * max(abs(value - finest) for value in values)
    return Number(finest, error + ROUNDING * abs(finest))


def _mean(values: Sequence[Any]) -> Number:
    """Return the mean of samples, as many as STUDENT has, with half its 95 % interval."""
    mean = float(np.mean(values))
    return Number(
        mean, STUDENT[len(values)] * float(np.std(values, ddof=1)) / math.sqrt(len(values)) + ROUNDING * abs(mean)
    )
