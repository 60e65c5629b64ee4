"""Study of a scene's effects by leaving out each in turn, and all that may go together.

Without its drive a scene starts as the driven one, to compare the effect of the drive alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown, unknown
from hertzwerk.runtime.analysis.effect_study.compared_outputs import (
    PAST_HORIZON,
    Output,
    automatic,
    chosen,
    unknown_outputs,
)
from hertzwerk.runtime.analysis.effect_study.effect_study import BELOW_ERROR, GONE, NEW, Change, Row, Study
from hertzwerk.runtime.analysis.effect_study.output_errors import EIGHTHS, LADDER, Bench, Case, Measurement
from hertzwerk.runtime.analysis.effect_study.scene_cost import cost_of, shares
from hertzwerk.runtime.analysis.effect_study.smallest_scene import smallest
from hertzwerk.runtime.engine.inputs.input_values import Input, with_input_values
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.run.run_request import METHOD, Compiled, is_real, progress_faults
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.start.start_values import stated_values
from hertzwerk.runtime.loading import Target, engine_model

CORRECTIONS = 20  # Gauss-Newton iterations of the positions
AGREE = 1e-9  # relative: largest difference of equal poses and their rates

HOPELESS = 6.0
_SMALLEST = ""  # no effect has this name


def driven_start(
    run: EngineSolution, model: EngineModel, parameters: Mapping[str, Value]
) -> dict[str, tuple[float, str]]:
    """Return the additional coordinates and speeds of a scene so that every body starts as in a run.

    The others start as in the run. Empty where there are none, and where bodies cannot start so.
    """
    whole, joints = run.engine.model, model.joints
    q_free = [i for i, name in enumerate(joints.coordinates) if name not in whole.joints.coordinates]
    u_free = [i for i, name in enumerate(joints.speeds) if name not in whole.joints.speeds]
    if whole.module.BODIES != model.module.BODIES or not (q_free or u_free):
        return {}
    known = run.engine.initial
    start = (np.array([known[name] for name in names]) for names in (whole.coordinates, whole.speeds))
    there = _flat(_motion(whole)(0.0, *start, run.engine.history.controls[: whole.nc]))
    bound = model.bind(parameters)
    q, u = _flat(joints.function("start")(bound.p))
    for values, names in ((q, joints.coordinates), (u, joints.speeds)):
        values[:] = [known.get(name, value) for name, value in zip(names, values, strict=True)]
    motion = _motion_of_joints(model)
    for _ in range(CORRECTIONS):
        poses, _, by_q, _ = motion(0.0, q, u, bound.c)
        q[q_free] += _least_squares(by_q, q_free, there[0] - np.array(poses).ravel())
    _, rates, _, by_u = motion(0.0, q, u, bound.c)
    u[u_free] += _least_squares(by_u, u_free, there[1] - np.array(rates).ravel())
    here = _flat(motion(0.0, q, u, bound.c)[:2])
    if any(
        np.max(np.abs(x - y)) > AGREE * max(1.0, float(np.max(np.abs(y)))) for x, y in zip(here, there, strict=True)
    ):
        return {}
    added = [(joints.coordinates[i], q[i]) for i in q_free] + [(joints.speeds[i], u[i]) for i in u_free]
    return {name: (float(value), joints.units[name]) for name, value in added}


def _flat(results: Sequence[Any]) -> list[np.ndarray]:
    return [np.array(result).ravel() for result in results]


@per_model
def _motion(model: EngineModel) -> Any:
    """Build the CasADi function (t, q, u, c) -> poses of all bodies, and their rates."""
    t, q, u, c = symbols = model.symbols("t q u c")
    poses = ca.vertcat(*model.function("poses")(t, q, c))
    moves = ca.vertcat(1, model.function("coordinate_rates")(t, q, u, c))
    return ca.Function("motion", symbols, [poses, ca.jtimes(poses, ca.vertcat(t, q), moves)])


@per_model
def _motion_of_joints(model: EngineModel) -> Any:
    """Build the function (t, q, u, c), q and u of joints -> poses, their rates, derivatives by q and u."""
    t, q, u, c = symbols = model.symbols("t joints joint_speeds c")
    placed = (q, u) if model.joints is model else model.function("placed")(t, q, u, c)
    poses, rates = _motion(model)(t, *placed, c)
    return ca.Function("motion_of_joints", symbols, [poses, rates, ca.jacobian(poses, q), ca.jacobian(rates, u)])


def _least_squares(columns: Any, free: Sequence[int], wanted: np.ndarray) -> np.ndarray:
    """Return the changes of the free variables that come closest to the wanted ones."""
    changes: np.ndarray = np.linalg.lstsq(np.array(columns)[:, free], wanted, rcond=None)[0]
    return changes


def study_effects(
    target: Target,
    *,
    duration: str | float | None = None,
    tolerance: float = 1e-6,
    method: str = METHOD,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    outputs: Sequence[str] = (),
    within: float | None = None,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    compiled: Compiled = False,
    progress: Callable[[float], object] | None = None,
) -> Study:
    """Omit each effect of a scene in turn and measure its cost and influence; raises InputError.

    tolerance    of the coarsest runs and of those that are timed; finer ones show the error
    target    a scene or a Model, as `simulate` takes it
    parameters, initial    values in place of the scene's, as `simulate` takes them
    inputs    values of the scene's inputs, as `simulate` takes them
    outputs    names, `max.NAME`, `min.NAME`, `mean.NAME`, `amplitude.NAME`; by default those that suit the scene
    within    search the smallest scene whose outputs change by no more, relative
    without, laws    of the whole scene, as `load` takes them
    compiled    whether the timed runs are compiled: "auto" where `simulate` compiles the whole scene
    """
    if within is not None and not (is_real(within) and 0 < within < 1):
        raise InputError("effects", [Fault("within", shown(within), "a change above 0 and below 100 %, such as 0.02")])
    if not isinstance(outputs, list | tuple) or not all(isinstance(name, str) for name in outputs):
        raise InputError("effects", [Fault("outputs", shown(outputs), 'a list of names, such as ["peak_force"]')])
    whole, faults = engine_model(target, without=without, laws=laws), progress_faults(progress)
    whole.declared_for("effects")
    own, states = stated_values(whole, parameters, initial, faults)
    bench, report = (
        Bench(duration, tolerance, method, {**own, **states}),
        progress if callable(progress) else lambda _: None,
    )
    whole, wrong = with_input_values(whole, inputs, duration, bench.parameters(whole))
    wanted, first = _outputs(whole, bench, outputs, [*faults, *wrong], compiled)
    study = Study(
        scene=whole.name,
        outcome=first.outcome,
        duration=first.settings.duration,
        method=method,
        tolerances=(bench.tolerance, bench.finest),
        compiled=first.settings.compiled,
        effects=tuple(name for name, *_ in whole.module.EFFECTS),
        cost=cost_of(whole),
        within=within,
    )
    measured = bench.measure(Case(whole), wanted) if first.outcome.finished else None
    if measured is None or not measured.outcome.finished:
        return study if measured is None else replace(study, outcome=measured.outcome)
    hidden = () if measured.past_horizon or outputs else PAST_HORIZON
    wanted = tuple(output for output in wanted if output.name in measured.numbers and output.name not in hidden)
    trials = _Trials(bench, first, wanted, measured)
    rows = []
    for i, effect in enumerate(study.effects):
        rows.append(trials.row(effect))
        report(0.4 * (i + 1) / len(study.effects))
    going = {row.effect: frozenset((row.effect, *row.along_with)) for row in rows if not row.fault}
    least = None
    if within is not None:
        least = smallest(study.effects, within, going, lambda gone: trials.change(gone, within))
    report(0.7)
    cases = {effect: trials.cases[gone] for effect, gone in going.items()}
    if least is not None and least.left_out:
        cases[_SMALLEST] = trials.cases[frozenset(least.left_out)]
    timed = shares(
        Case(whole),
        cases,
        bench,
        compiled=first.settings.compiled,
        eighths=EIGHTHS if measured.past_horizon else LADDER[0],
        progress=lambda part: report(0.7 + 0.3 * part),
    )
    return replace(
        study,
        outcome=measured.outcome,
        past_horizon=measured.past_horizon,
        outputs=wanted,
        numbers=measured.numbers,
        rows=tuple(replace(row, share=timed.get(row.effect)) for row in rows),
        smallest=least,
        smallest_share=timed.get(_SMALLEST),
        warnings=(
            *first.warnings,
            *(f"{name}: {why}" for name, why in measured.lacking.items() if name in outputs),
        ),
    )


def _outputs(
    whole: EngineModel, bench: Bench, names: Sequence[str], before: Sequence[Fault], compiled: Compiled
) -> tuple[tuple[Output, ...], EngineSolution]:
    """Return the outputs to be compared and the run they were found in.

    Raises InputError with `before` and all faults of names and values.
    """
    known = (*whole.parameters, *whole.joints.coordinates, *whole.joints.speeds)
    faults = [unknown("parameter or state", name, known) for name in bench.unknown_of(whole)]
    bench.check(Case(whole), compiled, [*before, *faults, *unknown_outputs(whole, names)])
    run = bench.simulate(Case(whole), compiled=compiled)
    outputs, wrong = chosen(run, names) if names else (automatic(run), [])
    refuse(whole.name, wrong)
    return outputs, run


def leave_out(whole: EngineModel, effects: Sequence[str], names: Iterable[str]) -> tuple[frozenset[str], EngineModel]:
    """Return a scene without some of its effects and those that depend on them.

    Such as friction without its contact. Raises InputError where the fault is of no effect.
    """
    gone = frozenset(names)
    while True:
        try:
            return gone, engine_model(whole, without=[name for name in effects if name in gone])
        except InputError as error:
            at_fault = {fault.where for fault in error.faults}
            following = {name for name in effects if f"effect {name}" in at_fault} - gone
            if not following:
                raise
            gone |= following


@dataclass(frozen=True)
class _Trials:
    """Scenes without some effects, measured against the whole one."""

    bench: Bench
    run: EngineSolution  # of the whole scene
    outputs: tuple[Output, ...]
    measured: Measurement
    cases: dict[frozenset[str], Case] = field(default_factory=dict)

    @property
    def whole(self) -> EngineModel:
        """The whole scene."""
        return self.run.engine.model

    def row(self, effect: str) -> Row:
        """Measure the scene without an effect."""
        try:
            gone, case = self._case(frozenset((effect,)))
            along_with = tuple(name for name in self._effects if name in gone and name != effect)
            measured, changes = self._measured(case)
        except InputError as error:
            return Row(effect, fault=f"cannot be omitted: {'; '.join(map(str, error.faults))}")
        cost = cost_of(self.whole) - cost_of(case.model)
        if not measured.outcome.finished:
            return Row(
                effect, along_with, cost, fault=f"without it {measured.outcome.name}: {measured.outcome.message}"
            )
        return Row(effect, along_with, cost, None, changes, notes=tuple(self._notes(case, measured)))

    def change(self, gone: frozenset[str], within: float) -> float:
        """Return the largest change of an output without some effects, its error added.

        Infinite where that is no scene, does not run or lacks an output. A change HOPELESS times too large in a
        single run is not refined: it would stay too large.
        """
        try:
            _, case = self._case(gone)
            numbers = self.bench.measure_once(case, self.outputs)
            if numbers is None:
                return math.inf
            known = {output.name: self.measured.numbers[output.name].value for output in self.outputs}
            largest = max(
                (abs(numbers[name] - value) / (abs(value) or math.inf) for name, value in known.items()), default=0.0
            )
            if largest > HOPELESS * within:
                return largest
            _, changes = self._measured(case)
        except InputError:
            return math.inf
        return max((change.bound for change in changes.values()), default=math.inf)

    @property
    def _effects(self) -> tuple[str, ...]:
        return tuple(name for name, *_ in self.whole.module.EFFECTS)

    def _case(self, names: frozenset[str]) -> tuple[frozenset[str], Case]:
        """Return the scene without some effects, and the set of all effects it lacks."""
        if names in self.cases:
            return names, self.cases[names]
        gone, model = leave_out(self.whole, self._effects, names)
        if gone not in self.cases:
            self.cases[gone] = Case(model, driven_start(self.run, model, self.bench.parameters(model)))
        return gone, self.cases[gone]

    def _measured(self, case: Case) -> tuple[Measurement, dict[str, Change]]:
        model, measured = case.model, self.bench.measure(case, self.outputs)
        if not measured.outcome.finished:
            return measured, {}
        if self.bench.same_motion(self.run, model):
            same = Change(None, BELOW_ERROR, noise=0.0)
            return measured, {
                o.name: same if o.name in measured.numbers else _missing_change(measured, o) for o in self.outputs
            }
        return measured, {output.name: self._change(measured, output) for output in self.outputs}

    def _change(self, measured: Measurement, output: Output) -> Change:
        if output.name not in measured.numbers:
            return _missing_change(measured, output)
        here, there = self.measured.numbers[output.name], measured.numbers[output.name]
        difference, noise = there.value - here.value, there.error + here.error
        size = abs(here.value)
        if abs(difference) <= noise:
            return Change(None, BELOW_ERROR, noise=noise / size if size else math.inf if noise else 0.0)
        if size <= here.error:
            return Change(None, NEW, f"it is {there.value:.3g} {output.unit} without it")
        return Change(difference / size, noise=noise / size)

    def _notes(self, case: Case, measured: Measurement) -> Iterator[str]:
        model, joints, of_whole = case.model, case.model.joints, self.whole.joints
        freed = [
            name
            for name in (*joints.coordinates, *joints.speeds)
            if name not in (*of_whole.coordinates, *of_whole.speeds)
        ]
        if case.start:
            starts = ", ".join(f"{name} = {value:.4g} {unit}" for name, (value, unit) in case.start.items())
            yield f"without it free to move, from {starts} as before"
        elif freed:
            yield f"without it {', '.join(freed)} are free, from the scene's own start: it may be another one than before"
        if self.bench.same_motion(self.run, model):
            yield "the equations of motion give the same accelerations without it, in every state of the run"
        if measured.past_horizon and not self.measured.past_horizon:
            yield "without it runs at different tolerances separate: its outputs are means of several runs"
        if measured.failed:
            yield f"without it {len(measured.failed)} of its runs did not finish and do not count: {'; '.join(measured.failed)}"


def _missing_change(measured: Measurement, output: Output) -> Change:
    return Change(None, GONE, f"without it {measured.lacking[output.name]}")
