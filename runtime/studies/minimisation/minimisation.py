"""Best parameters for a number of a run: SciPy's SLSQP with exact gradients, where outputs have them.

1. objective    a formula of outputs and parameters, its unit proven        studies/minimisation/formula
2. ranges       of what is varied, and places in them: halves or logarithms   engine/model/ranges
3. runs         one for each point, with the derivatives of its outputs     engine/sensitivity/output_derivatives
4. minimum      checked: the derivatives beside a difference of runs        studies/minimisation/minimum
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.runtime.engine.inputs.input_values import Input
from hertzwerk.runtime.engine.model import model as plain
from hertzwerk.runtime.engine.model.binding import Value, named_values, read_state, whole_faults
from hertzwerk.runtime.engine.model.free_quantities import Free, Freed, read_free, read_quantity
from hertzwerk.runtime.engine.model.ranges import starts_in
from hertzwerk.runtime.engine.model.si_values import si_of, si_units, unit_at
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.engine.run.run_request import (
    METHOD,
    Accuracy,
    Compiled,
    duration_follows,
    progress_faults,
    progress_of,
)
from hertzwerk.runtime.engine.sensitivity.output_derivatives import NoDerivativeError, OutputDerivatives
from hertzwerk.runtime.engine.solution.outcome import REACHED_END, Outcome
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.minimisation.formula import Formula, names_in, read_formula
from hertzwerk.runtime.studies.minimisation.minimum import Held, Minimum, Trial, best_of
from hertzwerk.runtime.studies.sweeps.parameter_sweep import refused_by_sweep
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Measured, Output, chosen
from hertzwerk.runtime.system.lazy import cached_property

STEP = 1e-4  # of a range: differences, and the check of derivatives
DOUBT = 0.01  # relative difference of derivatives from differences that is said
NEAR = 1e-3  # of a constraint's size: nearer to its limit it is active
FEASIBLE = 1e-6  # of a constraint's size: how far it may be missed
LARGEST = re.compile(r"\.(max|min|peak_to_peak|peak_force|max_penetration)$|^peak_force$")
_BOUND = re.compile(r"\s*(<=|>=|=)\s*(.+)")


def minimise(
    target: Target,
    objective: str,
    over: Mapping[str, Freed] | Sequence[str],
    constraints: Mapping[str, str] | None = None,
    *,
    start: Mapping[str, Value] | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    precision: float = 1e-6,
    max_runs: int = 200,
    starts: int = 0,
    seed: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Minimum:
    """Minimise an output of a run over ranges of parameters; return the best values.

    target       a scene or a Model, as `simulate` takes it
    objective    an output as of `sweep`, or a formula of outputs and parameters, whose unit is proven:
                 "main_bearing.reaction_x.rms**2 + main_bearing.reaction_y.rms**2"
    over         ranges of parameters and initial states: {"counterweight": "0..0.5 kg", "stiffness": "1e6..1e9 N/m log"}
    constraints  bounds of outputs or formulas: {"slider_pin.peak_force": "<= 5 kN", "final.guide.travel": "= 0.1 m"}
    start        start values, by default the model's where they are within the range, else its middle
    starts, seed    further starts, points of a Latin hypercube: the best result is returned, with the number of starts that ended there
    precision    stopping tolerance, relative to the objective and the constraints; max_runs    limit of runs from each start
    progress    a function that is called now and then with the fraction of the most runs that are done

    Gradients are exact where every output has derivatives, else differences of runs. The largest value of a history may switch
    from one peak to another; `.norm8` and `.norm32` are smooth substitutes. The result is the best local minimum of its starts;
    a lower one may exist. The other arguments are those of `simulate`. Raises InputError with every fault.
    """
    model = engine_model(target)
    settings: dict[str, Any] = {
        **{"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method},
        **{"max_steps": max_steps, "max_events": max_events, "wall_time": wall_time, "compiled": compiled},
    }
    values = {"parameters": parameters, "initial": initial, "inputs": inputs}
    faults = refused_by_sweep({"target": model, **values, **settings}) + progress_faults(progress)
    ranges = _ranges(model, over, start, faults)
    texts = [objective, *(constraints if isinstance(constraints, Mapping) else ())]
    names = list(dict.fromkeys(name for text in texts for name in names_in(text)))
    outputs = {one.name: one for one in chosen(model, [n for n in names if n not in model.parameters], faults)}
    units = si_units(model)
    named = {**units, **{name: output.columns[name] for name, output in outputs.items()}}
    goal = read_formula("objective", objective, named, faults)
    bounds = _bounds(constraints, named, faults)
    for where, number, least in (("precision", precision, 0.0), ("max_runs", max_runs, 1)):
        if isinstance(number, bool) or not isinstance(number, int | float) or not least < number < math.inf:
            faults.append(Fault(where, shown(number), f"a finite number above {least:g}"))
    faults += whole_faults(starts=starts, seed=seed)
    fixed = {name for values in (parameters, initial) if isinstance(values, Mapping) for name in values}
    faults += [Fault(x.name, "among parameters and over", "one of the two") for x in ranges if x.name in fixed]
    if faults or goal is None:
        raise InputError(f"minimum of {model.name}", faults)
    problem = _Problem(model, goal, tuple(bounds), ranges, outputs, {**values, **settings})
    begins = starts_in(ranges, [one.value for one in ranges], starts, seed)
    minima: list[Minimum] = []
    failed: list[InputError] = []
    for i, begin in enumerate(begins):
        report = progress_of(progress, i, len(begins))
        try:
            minima.append(_Search(problem, begin, int(max_runs), report).minimum(float(precision)))
        except InputError as error:
            failed.append(error)
        report(1.0)
    if not minima:
        raise failed[0]
    return best_of(minima, ranges, len(failed))


@dataclass(frozen=True)
class _Bound:
    """Constraint lower <= formula <= upper in SI; size    what misses of it are measured by."""

    text: str
    formula: Formula
    lower: float
    upper: float

    @property
    def size(self) -> float:
        """Largest of its finite limits, or 1."""
        return max((abs(x) for x in (self.lower, self.upper) if math.isfinite(x)), default=1.0) or 1.0

    def missed(self, value: float) -> float:
        """Return by how much of its size a value misses it."""
        return max(self.lower - value, value - self.upper, 0.0) / self.size


def _ranges(
    model: plain.EngineModel, over: object, start: Mapping[str, Value] | None, faults: list[Fault]
) -> tuple[Free, ...]:
    """Return the ranges, with values to begin with; bad input is appended to `faults`."""
    ranges = read_free(model, over, faults, argument="over", decades=math.inf)
    begins = named_values("start", {} if start is None else start, faults)
    varied = over if isinstance(over, Mapping | list | tuple) else ()
    freed = []
    faults += [
        Fault(f"start[{name!r}]", "a name that is not varied", "one of over") for name in begins if name not in varied
    ]
    for one in ranges:
        if one.name in begins:
            where = f"start[{one.name!r}]"
            one = replace(one, value=read_quantity(model, one.name, begins[one.name], where, faults))
            if math.isfinite(one.value) and not one.low <= one.value <= one.high:
                faults.append(Fault(where, shown(begins[one.name]), "a value within its range"))
        freed.append(one)
    return tuple(freed)


def _bounds(constraints: object, named: Mapping[str, str], faults: list[Fault]) -> list[_Bound]:
    """Return the constraints; bad input is appended to `faults`."""
    if constraints is None:
        return []
    if not isinstance(constraints, Mapping):
        faults.append(Fault("constraints", shown(constraints), 'bounds by output, such as {"peak_force": "<= 5 kN"}'))
        return []
    bounds = []
    for text, bound in constraints.items():
        where = f"constraints[{text!r}]"
        formula = read_formula(where, text, named, faults)
        written = _BOUND.fullmatch(bound) if isinstance(bound, str) else None
        if written is None:
            faults.append(Fault(where, shown(bound), 'a bound, such as "<= 5 kN", ">= 2 mm" or "= 0.1 m"'))
        elif formula is not None:
            si, fault = read_state(where, formula.unit or "1", written[2])
            if fault is not None:
                faults.append(fault)
            else:
                lower, upper = {"<=": (-math.inf, si), ">=": (si, math.inf), "=": (si, si)}[written[1]]
                bounds.append(_Bound(f"{text} {bound.strip()}", formula, lower, upper))
    return bounds


@dataclass(frozen=True)
class _Problem:
    """Everything a minimisation computes."""

    model: plain.EngineModel
    goal: Formula
    bounds: tuple[_Bound, ...]
    ranges: tuple[Free, ...]
    outputs: Mapping[str, Output]
    settings: Mapping[str, Any]

    def values_at(self, x: np.ndarray) -> dict[str, float]:
        """Return the values at a point, SI."""
        return {free.name: free.outer(place) for free, place in zip(self.ranges, x.tolist(), strict=True)}

    def slopes(self, x: np.ndarray) -> np.ndarray:
        """Return the changes of the values with their places, SI."""
        return np.array(
            [free.slope(value) for free, value in zip(self.ranges, self.values_at(x).values(), strict=True)]
        )

    def run(self, x: np.ndarray) -> Solution:
        """Run the model at a point; raises InputError, _RunFailedError."""
        units = si_units(self.model)
        varied = {name: (value, units[name] or "1") for name, value in self.values_at(x).items()}
        run = simulate(self.model, **{**self.settings, "parameters": {**(self.settings["parameters"] or {}), **varied}})
        if run.outcome.name not in REACHED_END:
            raise _StoppedError(run.outcome.name, f"a run ended early: {run.outcome.message}", run.outcome.remedy)
        return run

    def numbers(self, run: Solution) -> dict[str, float]:
        """Return what the formulas name of a run, SI."""
        measured = Measured(run)
        outputs = {name: output.of(measured)[0] for name, output in self.outputs.items()}
        return {**{name: si_of(self.model, name, value) for name, value in run.settings.parameters.items()}, **outputs}

    def gradient(self, run: Solution, x: np.ndarray) -> np.ndarray:
        """Return the exact gradients (formulas, names) with the places; raises NoDerivativeError, InputError."""
        names = [free.name for free in self.ranges]
        duration = self.settings["duration"]
        if duration_follows(self.model, names, duration):
            raise NoDerivativeError(f"the duration {duration} changes with what is varied: state it as a time")
        derivatives, numbers = OutputDerivatives(with_steps(run), run.sensitivities(*names)), self.numbers(run)
        of = {name: derivatives[name] for name in self.outputs}
        of |= {name: np.eye(len(names))[i] for i, name in enumerate(names) if name not in of}
        still = np.zeros(len(names))
        rows = [
            formula.gradient(numbers) @ [of.get(name, still) for name in formula.names] for formula in self.formulas
        ]
        gradient: np.ndarray = np.array(rows) * self.slopes(x)
        return gradient

    @cached_property
    def box(self) -> np.ndarray:
        """Ends of the ranges, places (names, 2)."""
        return np.array([free.bounds for free in self.ranges])

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """Objective, then constraints."""
        return (self.goal, *(bound.formula for bound in self.bounds))


class _StoppedError(Exception):
    """End of a search before its minimum: name, message, remedy of its outcome."""


@dataclass(frozen=True)
class _Point:
    """Run at a point, with objective and constraints.

    value    of both (formulas,); gradient    of both (formulas, names), with the places in the ranges
    """

    run: Solution
    value: np.ndarray
    gradient: np.ndarray


@dataclass
class _Search:
    """Search for a minimum; every point is run once."""

    problem: _Problem
    begin: np.ndarray
    max_runs: int
    report: Callable[[float], object]
    exact: bool = True
    why: str = ""
    runs: int = 0
    trials: list[Trial] = field(default_factory=list)
    known: dict[bytes, _Point] = field(default_factory=dict)

    def at(self, x: np.ndarray) -> _Point:
        """Return the run at a point, and objective and constraints with their gradients."""
        key = np.asarray(x, dtype=float).tobytes()
        if key not in self.known:
            run, value = self._run(x)
            self.known[key] = _Point(run, value, self._gradient(x, run, value))
        return self.known[key]

    def _run(self, x: np.ndarray) -> tuple[Solution, np.ndarray]:
        """Return the run at a point, with the values of objective and constraints."""
        if self.runs >= self.max_runs:
            raise _StoppedError("too_many_runs", f"stopped after {self.runs} runs", "allow more: max_runs=500")
        self.report(self.runs / self.max_runs)
        self.runs += 1
        problem = self.problem
        run = problem.run(x)
        numbers = problem.numbers(run)
        value = np.array([formula(numbers) for formula in problem.formulas])
        if not np.isfinite(value).all():
            raise _StoppedError(
                "no_value", "a run has no value of the objective or of a constraint", "look at its outputs"
            )
        feasible = all(bound.missed(v) <= FEASIBLE for bound, v in zip(problem.bounds, value[1:], strict=True))
        self.trials.append(Trial(problem.values_at(x), float(value[0]), feasible))
        return run, value

    def _gradient(self, x: np.ndarray, run: Solution, value: np.ndarray) -> np.ndarray:
        """Return the gradients (formulas, names) with respect to the places: exact, or by differences."""
        if self.exact:
            try:
                return self.problem.gradient(run, x)
            except (NoDerivativeError, InputError) as error:
                self.exact, self.why = False, str(error)
        step = STEP * np.ptp(self.problem.box, axis=1)
        steps = np.where(x + step <= self.problem.box[:, 1], step, -step)
        moved = [self._run(x + by)[1] for by in np.diag(steps)]
        gradient: np.ndarray = (np.array(moved) - value).T / steps
        return gradient

    def checked(self) -> float:
        """Return the relative difference of the objective's derivative from a difference of runs, along it."""
        step = STEP * np.ptp(self.problem.box, axis=1)
        x = np.clip(self.begin, self.problem.box[:, 0] + step, self.problem.box[:, 1] - step)
        gradient = self.at(x).gradient[0]
        size = float(np.abs(gradient).max())
        if not self.exact or not size > 0:
            return math.nan
        way = step * gradient / size
        ahead, behind = (self._run(x + sign * way)[1][0] for sign in (1, -1))
        return float(abs((ahead - behind) / 2 / (gradient @ way) - 1))

    def minimum(self, precision: float) -> Minimum:
        """Return the minimum."""
        from scipy.optimize import minimize

        problem = self.problem
        checked, outcome = math.nan, Outcome("finished", "the objective no longer changes", "")
        try:
            size = abs(self.at(self.begin).value[0]) or 1.0
            checked = self.checked()
            result = minimize(
                lambda x: self.at(x).value[0] / size,
                self.begin,
                jac=lambda x: self.at(x).gradient[0] / size,
                method="SLSQP",
                bounds=problem.box,
                constraints=[self._constraint(k, bound) for k, bound in enumerate(problem.bounds, start=1)],
                options={"ftol": precision, "maxiter": self.max_runs},
            )
        except _StoppedError as stopped:
            name, message, remedy = stopped.args
            if not self.known:
                fault = Fault("start", message, "values at which a run reaches its end", remedy)
                raise InputError(f"minimum of {problem.model.name}", [fault]) from None
            outcome = Outcome(name, message, remedy)
        else:
            if not result.success:
                outcome = Outcome(
                    "no_progress",
                    f"SciPy's SLSQP: {result.message}",
                    "change the start (start), or request more accurate runs (tolerance)",
                )
        return self._result(checked, outcome)

    def _constraint(self, k: int, bound: _Bound) -> dict[str, Any]:
        """Return a constraint as SciPy takes it: 0 or above, or equal to 0."""
        end, sign = (bound.upper, -1) if math.isfinite(bound.upper) and bound.lower != bound.upper else (bound.lower, 1)
        return {
            "type": "eq" if bound.lower == bound.upper else "ineq",
            "fun": lambda x: sign * (self.at(x).value[k] - end) / bound.size,
            "jac": lambda x: sign * self.at(x).gradient[k] / bound.size,
        }

    def _result(self, checked: float, outcome: Outcome) -> Minimum:
        """Return the best point that was run, the least that keeps the constraints."""
        problem = self.problem

        def order(item: tuple[bytes, _Point]) -> tuple[float, float]:
            missed = max((b.missed(v) for b, v in zip(problem.bounds, item[1].value[1:], strict=True)), default=0.0)
            return (0.0 if missed <= FEASIBLE else missed, item[1].value[0])

        key, best = min(self.known.items(), key=order)
        if order((key, best))[0] > 0:
            outcome = Outcome(
                "infeasible", "no run satisfies the constraints", "widen ranges or bounds, or change the start (start)"
            )
        x, units = np.frombuffer(key), si_units(problem.model)
        values = problem.values_at(x)
        gradient = dict(zip(values, (best.gradient[0] / problem.slopes(x)).tolist(), strict=True))
        held = [
            Held(bound.text, float(v), bound.formula.unit, bound.lower, bound.upper,
                 active=bool(min(abs(v - bound.lower), abs(v - bound.upper)) <= NEAR * bound.size), satisfied=bool(bound.missed(v) <= FEASIBLE))
            for bound, v in zip(problem.bounds, best.value[1:], strict=True)
        ]  # fmt: skip
        return Minimum(
            scene=problem.model.name,
            objective_text=problem.goal.text,
            values={
                name: (value, unit_at(units[name], best.run.settings.parameters)) for name, value in values.items()
            },
            objective=float(best.value[0]),
            begun=self.trials[0].objective,
            unit=problem.goal.unit,
            gradient=gradient,
            exact=self.exact,
            checked=checked,
            at_end=tuple(free.name for free in problem.ranges if free.at_end(values[free.name])),
            constraints=tuple(held),
            run=best.run,
            trials=tuple(self.trials),
            outcome=outcome,
            notes=tuple(self._notes(best.run, checked)),
        )

    def _notes(self, run: Solution, checked: float) -> Iterator[str]:
        """Yield what is to be known of the result."""
        if self.why:
            yield f"by differences of runs, as there are no derivatives: {self.why}"
        if checked > DOUBT:
            yield f"derivatives and differences of runs differ by {checked:.2g} at the start: in chaos, or across a switch, neither is useful"
        names = [name for formula in self.problem.formulas for name in formula.names if LARGEST.search(name)]
        if names or any(formula.switches for formula in self.problem.formulas):
            subject = ", ".join(dict.fromkeys(names)) or "the formula"
            yield f"{subject}: a maximum switches from one peak to another, where its derivative jumps; HISTORY.norm32 is smooth"
        if not run.outcome.finished:
            yield f"the run at the minimum: {run.outcome.name}: {run.outcome.message}"
