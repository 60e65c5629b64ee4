"""Outputs of a row by name: numbers of a run, with their units and what each needs of it.

`known` lists the names that a model has. A row computes only what is requested: `Output.needs` says what that is.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown, unknown
from hertzwerk.runtime.engine.model.free_quantities import quantities
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import ratio
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.engine.sensitivity.output_derivatives import (
    NoDerivativeError,
    OutputDerivatives,
    without_derivative,
)
from hertzwerk.runtime.engine.solution.averages import OF_IMPACTS, POWERS, Average, Run, averages_by_name
from hertzwerk.runtime.engine.solution.dense_output import REDUCERS, Samples
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.engine.solution.impacts import Impact
from hertzwerk.runtime.engine.solution.step_observers import Needs
from hertzwerk.runtime.simulation import Solution
from hertzwerk.runtime.system.lazy import cached_property


class Measured:
    """A run, and what several outputs of it share."""

    def __init__(self, run: Solution) -> None:
        self.run = run

    @cached_property
    def samples(self) -> Samples:
        """Histories between the steps."""
        return Samples(self.run)

    @cached_property
    def averages(self) -> Mapping[str, Callable[[], Average]]:
        """Averages after the transient, by name; each is computed when it is called."""
        run = self.run
        return averages_by_name(
            Run(
                run.engine.model,
                run.engine.findings,
                run.engine.scales,
                run.settings.tolerance,
                run.engine.t_start,
                run.engine.t_end,
            )
        )

    @cached_property
    def derivatives(self) -> OutputDerivatives:
        """Derivatives of outputs; raises NoDerivativeError where the run has none."""
        run = with_steps(self.run)
        if self.run.engine.derivatives is None:
            raise NoDerivativeError("the run has none: its steps were not kept")
        return OutputDerivatives(run, self.run.engine.derivatives)

    def impacts(self, pair: str | None) -> list[Impact]:
        """Contacts of one pair, or of all."""
        return [impact for impact in self.run.impacts if pair in (None, impact.contact)]


@dataclass(frozen=True)
class Output:
    """Numbers of a run under one name: a column each, with its unit.

    of    the numbers in the order of the columns; nan where a run has none
    function    the user's own that it is made of
    derived    the output that it is the derivative of, and by what
    """

    columns: Mapping[str, str]
    needs: Needs
    of: Callable[[Measured], tuple[float, ...]]
    function: Callable[[Solution], float] | None = None
    derived: tuple[str, str] | None = None

    @property
    def name(self) -> str:
        """Name that users give: that of the first column."""
        return next(iter(self.columns))


class NotANumberError(TypeError):
    """An output that is not one number."""


_OTHERWISE = "a history with .max, .min, .mean, .rms, .peak_to_peak, .norm8 or .norm32"
DERIVATIVE = re.compile(r"d\((.+)\)/d\(([^()]+)\)")  # of an output by a parameter or initial state


def own(name: str, function: Callable[[Solution], float]) -> Output:
    """Return the output of a user's function of the Solution."""

    def of(measured: Measured) -> tuple[float, ...]:
        number = function(measured.run)
        if np.ndim(number):
            raise NotANumberError(f"output {name} returned an array of shape {np.shape(number)}")
        return (float(number),)

    return Output({name: ""}, Needs.STEPS, of, function)


def named(model: EngineModel, outputs: Sequence[tuple[str, Callable[[Solution], float] | None]]) -> list[Output]:
    """Return outputs by their names and, of the user's own, functions."""
    there = {output.name: output for output in (*of_every_run(model), *_known(model))}
    return [_output_of(model, there, name) if function is None else own(name, function) for name, function in outputs]


def _output_of(model: EngineModel, there: Mapping[str, Output], name: str) -> Any:
    """Return the output of a name, of a reading too, which is derived then; None where there is none."""
    if DERIVATIVE.fullmatch(name):
        return _derivative(model, there, name)
    history, _, kind = name.rpartition(".")
    if name in there or kind not in REDUCERS or history not in units_of(model, None):
        return there.get(name)
    return _reduced(history, units_of(model, None)[history], kind)


def _derivative(model: EngineModel, there: Mapping[str, Output], name: str) -> Output | None:
    """Return the output of a derivative, "d(OUTPUT)/d(NAME)"; None where there is none."""
    above, to = DERIVATIVE.fullmatch(name).groups()  # type: ignore[union-attr]
    of, units = _output_of(model, there, above), quantities(model)
    if of is None or of.derived or to not in units:
        return None

    def one(measured: Measured) -> tuple[float, ...]:
        derivatives = measured.derivatives
        return (float(derivatives[above][derivatives.of.names.index(to)]),)

    return Output({name: ratio(of.columns[above], units[to])}, Needs.STEPS, one, derived=(above, to))


def _derivative_faults(model: EngineModel, there: Mapping[str, Output], name: str) -> list[Fault]:
    """Return the faults of the name of a derivative."""
    above, to = DERIVATIVE.fullmatch(name).groups()  # type: ignore[union-attr]
    units = quantities(model)
    faults = [] if to in units else [unknown("parameter or initial state", to, units)]
    if _output_of(model, there, above) is None:
        faults.append(unknown("sweep output", above, there, _OTHERWISE))
    elif DERIVATIVE.fullmatch(above):
        faults.append(Fault(name, "a derivative of a derivative", "a first derivative: higher ones are not available"))
    elif reason := without_derivative(above):
        faults.append(Fault(name, f"{above}: {reason}", "an output with a derivative"))
    return faults


def known(model: EngineModel) -> dict[str, Output]:
    """Return every output that a model has, by name."""
    return {output.name: output for output in _known(model)}


def chosen(model: EngineModel, names: object, faults: list[Fault]) -> list[Output]:
    """Return the outputs of these names; bad input is appended to `faults`."""
    if isinstance(names, str) or not isinstance(names, Sequence):
        faults.append(
            Fault("outputs", shown(names), 'a list of names, such as ["energy_residual", "final.guide.travel"]')
        )
        return []
    there = known(model)
    faults += [unknown("sweep output", name, there, _OTHERWISE) for name in names if not isinstance(name, str)]
    texts = list(dict.fromkeys(name for name in names if isinstance(name, str)))
    outputs = {name: _output_of(model, there, name) for name in texts}
    derivatives = [name for name in texts if DERIVATIVE.fullmatch(name)]
    for name in derivatives:
        faults += _derivative_faults(model, there, name)
    faults += [
        unknown("sweep output", name, there, _OTHERWISE)
        for name in texts
        if outputs[name] is None and name not in derivatives
    ]
    faults += [Fault("outputs", f"{name} twice", "each once") for name in texts if names.count(name) > 1]
    return [output for output in outputs.values() if output is not None]


def derived_by(outputs: Sequence[Output]) -> tuple[str, ...]:
    """Return the names by which derivatives of outputs are taken."""
    return tuple(dict.fromkeys(output.derived[1] for output in outputs if output.derived))


def text_behind(model: EngineModel, outputs: Sequence[Output], histories: Sequence[str]) -> str:
    """Return the text beside the model's own that outputs, or other histories, may be computed by."""
    units = units_of(model, None)
    split = (
        (output.derived[0] if output.derived else output.name).rpartition(".")
        for output in outputs
        if output.function is None
    )
    names = [*histories, *(history for history, _, kind in split if kind in REDUCERS)]
    own = any(output.function is not None for output in outputs)  # may ask for anything
    return units.text_behind(units.everything if own else names)


def of_every_run(model: EngineModel) -> list[Output]:
    """Return contacts, peak force, energy residual, error and cost, which every run has a column for."""
    return [*_of_contacts(None), _ENERGY_RESIDUAL, *_OF_RUN]


def finals(model: EngineModel) -> list[Output]:
    """Return every state at the end."""
    return [_final(f"final.{name}", name, unit) for name, unit in model.units.items()]


def _known(model: EngineModel) -> Iterator[Output]:
    yield from finals(model)
    for name in model.memory:
        for end, title in POWERS.items():
            if name.endswith(end):
                yield _final(name, name, model.units[name])
                yield _average(name.removesuffix(end) + title, "W")
    if model.k:
        yield from _of_contacts(None)
    for j, pair in enumerate(model.pairs):
        yield from _of_contacts(pair)
        yield _penetration(pair)
        yield _impulse(pair, j)
        yield from (_average(f"{pair}.{name}", unit, f"{pair}.{of}") for name, (unit, of) in _AVERAGES.items())
    if model.has_ledger:
        yield _ENERGY_RESIDUAL
    yield from _OF_RUN
    for name, unit in units_of(model, None).items():
        if name != "t":
            yield from (_reduced(name, unit, kind) for kind in REDUCERS)


# -- what they are -----------------------------------------------------------------------------------------------------


def _number(name: str, unit: str, needs: Needs, of: Callable[[Measured], float | None]) -> Output:
    def one(measured: Measured) -> tuple[float, ...]:
        value = of(measured)
        return (math.nan if value is None else float(value),)

    return Output({name: unit}, needs, one)


def _final(name: str, state: str, unit: str) -> Output:
    return _number(name, unit, Needs.ENDS, lambda measured: measured.run.engine.ends[state][-1])


_ENERGY_RESIDUAL = _number("energy_residual", "", Needs.ENDS, lambda measured: measured.run.energy_residual)
_OF_RUN = (
    _number("error", "", Needs.ENDS, lambda m: None if m.run.error is None else m.run.error.judged),
    _number("steps", "", Needs.ENDS, lambda m: m.run.statistics.steps),
    _number("rhs_evaluations", "", Needs.ENDS, lambda m: m.run.statistics.rhs_evaluations),
)


def _of_contacts(pair: str | None) -> Iterator[Output]:
    """Yield number and largest force of the contacts of a pair, or of all."""
    before = "" if pair is None else f"{pair}."
    yield _number(f"{before}impacts", "", Needs.IMPACTS, lambda measured: len(measured.impacts(pair)))
    yield _number(
        f"{before}peak_force",
        "N",
        Needs.IMPACTS,
        lambda measured: max((impact.peak_force for impact in measured.impacts(pair)), default=0.0),
    )


def _penetration(pair: str) -> Output:
    return _number(
        f"{pair}.max_penetration",
        "m",
        Needs.IMPACTS,
        lambda measured: max((impact.peak_penetration for impact in measured.impacts(pair)), default=0.0),
    )


def _impulse(pair: str, j: int) -> Output:
    def of(measured: Measured) -> float:
        run = measured.run
        return float(run.engine.findings.sums(run.engine.t_end - run.engine.t_start).impulse[:, j].sum())

    return _number(f"{pair}.impulse", "N s", Needs.STEPS, of)


_AVERAGES = {  # of a pair: names, units, and the names of `run.averages()`
    "impact_rate": ("1/s", "impact_rate"),
    "mean_force": ("N", "normal_force"),
    "mean_peak_force": ("N", "peak_force"),
    "mean_largest_force": ("N", "largest_force"),
}


def _average(name: str, unit: str, average: str | None = None) -> Output:
    """Return a mean after the transient, and half the width of its 95 % confidence interval."""
    average = average or name

    def of(measured: Measured) -> tuple[float, ...]:
        compute = measured.averages.get(average)
        averaged = None if compute is None else compute()
        values = (None, None) if averaged is None else (averaged.mean, averaged.half_width)
        return tuple(math.nan if value is None else value for value in values)

    needs = Needs.IMPACTS if average.endswith(OF_IMPACTS) else Needs.SUMS
    return Output({name: unit, f"{name}.half_width": unit}, needs, of)


def _reduced(name: str, unit: str, kind: str) -> Output:
    reducer = REDUCERS[kind]
    return _number(f"{name}.{kind}", unit, Needs.STEPS, lambda measured: reducer(measured.samples, name))
