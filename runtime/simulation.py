"""From a model and numbers to a solution: reads the input completely, builds the attempt, runs it in chunks."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Literal

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime import scales as scaling
from hertzwerk.runtime.accuracy import (
    LEAST,
    LOOSEST,
    POINTS,
    Climbed,
    End,
    Ladder,
    Rung,
    Verdict,
    beyond_horizon,
    first_tolerance,
)
from hertzwerk.runtime.binding import Value, read_state, read_time, unknown
from hertzwerk.runtime.caller import Callers
from hertzwerk.runtime.findings import Findings, Observer
from hertzwerk.runtime.history import History, holding_force
from hertzwerk.runtime.impacts import ApproachSpeeds, Track
from hertzwerk.runtime.integrate.attempt import Integrator, integrator
from hertzwerk.runtime.integrate.automatic import Code, Gear
from hertzwerk.runtime.integrate.chunk import INTERRUPTED, WALL_TIME_LIMIT, Ending, chunk, march
from hertzwerk.runtime.integrate.layout import FINISHED, OUTSIDE_LAW_RANGE, TOO_MANY_STEPS
from hertzwerk.runtime.integrate.methods import METHODS, SUNDIALS
from hertzwerk.runtime.model import Bound, Dependent, Model
from hertzwerk.runtime.outcome import Outcome, outcome, unreachable
from hertzwerk.runtime.output import Output, times_of
from hertzwerk.runtime.recorder import BLOCK, Grid, Recorder, Steps
from hertzwerk.runtime.scales import Scales
from hertzwerk.runtime.solution import Solution, Statistics

ACCURACIES, TOLERANCES = (1e-12, 1e-1), (LEAST, 1e-1)
ACCURACY = 1e-6  # where none is asked for
APPROACH_FLOOR = 1e-3  # m/s, where a model has latches but no parameter of this name
LEAST_STEPS = 10  # of a run in contact: where all is at rest, steps grow until a short push would go unnoticed
REMEMBERED = 64  # inputs of a model that need not be read again
COUNTERS = ("steps", "rejected", "retaken", "evaluations", "events", "floored")  # parts of a state
MAX_STEPS, MAX_EVENTS = 1_000_000, 100_000
ROUGH = LOOSEST  # tolerance of a run that only looks for scales
STOPS = (INTERRUPTED, WALL_TIME_LIMIT, TOO_MANY_STEPS)  # what ends all runs


def simulate(
    model: Model,
    *,
    duration: str | float | None = None,
    accuracy: float | None = None,
    tolerance: float | None = None,
    method: str = "dop853",
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    output: Output = "steps",
    compiled: bool | Literal["auto"] = "auto",
    max_steps: int = MAX_STEPS,
    max_events: int = MAX_EVENTS,
    wall_time: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> Solution:
    """Run a model from its start for a duration (seconds, or text such as "24 ms").

    accuracy    the error asked for at the end, in the scene's scales, 1e-12..1e-1, by default 1e-6: runs at falling tolerance are made until the
                error of one, by comparison with a tighter one, is known to be so small. `Solution.error` says what it is; where it is more
                than was asked for, the outcome is "accuracy_unreachable", or a warning says that the run is longer than its horizon
    tolerance   in place of an accuracy the local tolerance, 1e-13..1e-1, of one run without an estimate
    method      explicit "dop853", "dopri5"; for what is stiff "esdirk", "rodas"; "auto" chooses between dop853 and esdirk as it goes;
                "cvodes", "idas": SUNDIALS, slow, as an independent reference
    parameters, initial    values in place of the model's, each with its unit: {"clearance": "0.2 mm"}, {"guide.travel": "0.17 m"}
    output      what is kept: "steps", all that were accepted; or the states at a number of points, start and end included (1000), at a
                spacing ("0.1 ms"), at times [s] of your own, by dense output of the method's order; memory then does not grow with the run
    compiled    run the same functions as C; the result is bitwise the same; "auto" does so from where the time to go exceeds the compilation
    max_steps, wall_time [s]    of all runs together, max_events (contacts begun) of each: where to stop, with an outcome that says so
    progress    called now and then with the fraction done

    Raises InputError, with every fault, for bad input and for nothing else: how the run ended is `Solution.outcome`.
    """
    began = time.perf_counter()
    limits = _Limits(max_steps, max_events, math.inf if wall_time is None else wall_time)
    given, times = _read(
        model, duration, accuracy, tolerance, method, compiled, limits, parameters or {}, initial or {}, output
    )
    engine = _engine_for(model.without_redundancy(given.dependent), method, compiled)
    gear = Gear(engine.code, compiled=compiled is True, changes=compiled == "auto") if engine.code else None
    run = _Run(model, method, engine, given, limits, gear)
    scales = given.scales
    if not scales.sound:
        rough = max(tolerance or 0.0, ROUGH)  # of no run for an accuracy is the tolerance larger
        scales = scaling.of_run(model, scales, lambda s, seen: run(rough, s, [seen], block=BLOCK))
    build_s = time.perf_counter() - began
    if tolerance is not None:
        return _solution(run, run.made(tolerance, scales, times, progress=progress), scales, build_s)
    return _as_accurate(run, scales, times, accuracy or ACCURACY, build_s, progress)


def _as_accurate(
    run: _Run,
    scales: Scales,
    times: np.ndarray | None,
    asked: float,
    build_s: float,
    progress: Callable[[float], object] | None,
) -> Solution:
    """Runs at falling tolerance; limits of steps and time are of all of them, the limit of events is of the motion, and so of each."""
    model, seconds, limits = run.model, run.given.seconds, run.limits
    grid = np.linspace(0.0, seconds, POINTS)
    made: list[tuple[float, int]] = []  # times [s] and steps spent

    def one(tolerance: float, keep: bool) -> Rung[_Made]:
        spent_s, steps = (sum(each) for each in zip(*made, strict=True)) if made else (0.0, 0)
        left = _Limits(max(limits.max_steps - int(steps), 1), limits.max_events, max(limits.wall_time - spent_s, 0.0))
        beside = None if progress is None else _part(progress, len(made))
        here = replace(run, limits=left).made(tolerance, scales, times, progress=beside, beside=grid, alone=not keep)
        made.append((here.ending.wall_s, here.counted["steps"]))
        status = here.ending.status
        end = End.REACHED if status == FINISHED else End.STOPPED if status in STOPS else End.FAILED
        states = here.beside.history.part("y")
        return Rung(tolerance, end, states, here.counted["evaluations"], here.ending.wall_s, here)

    ladder = Ladder(one, lambda y, reference: scaling.error(model, scales, y, reference), grid, asked)
    climbed = ladder.climb(first_tolerance(asked, seconds, *scales.scene[:2]))
    return _solution(run, climbed.run.kept, scales, build_s, asked, climbed)


def _part(progress: Callable[[float], object], before: int) -> Callable[[float], object]:
    """Progress of the next run after so many: every run that is kept has one that checks it."""
    return lambda done: progress((before + done) / (2 * (before // 2) + 2))


def _solution(
    run: _Run,
    made: _Made,
    scales: Scales,
    build_s: float,
    asked: float | None = None,
    climbed: Climbed[_Made] | None = None,
) -> Solution:
    model, bound, counted = run.model, run.given.bound, made.counted
    found: tuple[str, ...] = ()
    result = run.outcome(made)
    if climbed is not None and asked is not None:
        result, found = _verdict(run, climbed, asked, result)
    return Solution(
        history=made.kept.history,
        ends=made.kept.ends,
        findings=made.findings,
        outcome=result,
        duration=run.given.seconds,
        accuracy=asked,
        tolerance=made.tolerance,
        method=run.method,
        compiled=made.compiled,
        parameters=dict(bound.values),
        statistics=Statistics(
            steps=counted["steps"],
            rejected=counted["rejected"],
            retaken=counted["retaken"],
            rhs_evaluations=counted["evaluations"],
            events=counted["events"],
            wall_s=made.ending.wall_s - made.compile_s,
            build_s=build_s,
            compile_s=made.compile_s,
        ),
        warnings=(
            *unchecked(model),
            *_open_forces(model, run.given),
            *bound.warnings,
            *_floored(counted["floored"], run.floor),
            *_too_fast(model, made.speeds),
            *found,
        ),
        scales=scales,
        error=None if climbed is None else climbed.error,
    )


def _verdict(run: _Run, climbed: Climbed[_Made], asked: float, result: Outcome) -> tuple[Outcome, tuple[str, ...]]:
    """Outcome and warnings of a run for an accuracy."""
    error, broken = climbed.error, climbed.broken
    warnings: list[str] = []
    if error is not None and error.horizon is not None:
        warnings.append(beyond_horizon(error, asked))
    if broken is not None:
        other = run.outcome(broken.kept)
        if climbed.verdict is Verdict.STOPPED and result.finished:
            message = (
                f"the run is complete, a run with a smaller tolerance to know its error by is not: {other.message}"
            )
            result = Outcome(other.name, message, other.remedy)
        elif result.finished:
            warnings.append(f"the error is {error}: runs with a smaller tolerance end otherwise, {other.message}")
    if error is not None and error.floor is not None:
        result = unreachable(asked, error.floor)
    return result, tuple(warnings)


@dataclass(frozen=True)
class _Engine:
    """The functions of one model and method: a chunk, or a loop of its own."""

    integrator: Integrator
    begin: Callers
    counters: Mapping[str, int]  # rows of the state
    code: Code | None  # of the chunk
    march: Callable[
        ..., Ending
    ]  # ([gear, integrator where there is code,] state, controls, keep, *, wall_time, progress)


@dataclass(frozen=True)
class _Limits:
    max_steps: int
    max_events: int
    wall_time: float


@dataclass(frozen=True)
class _Given:
    """What a run is asked for, read: numbers of the parameters, the start, the duration, and the scales that the scene states."""

    bound: Bound
    q: np.ndarray
    u: np.ndarray
    seconds: float
    scales: Scales
    dependent: tuple[Dependent, ...]


@dataclass(frozen=True)
class _Run:
    """Everything of a run but its tolerance and scales."""

    model: Model
    method: str
    engine: _Engine
    given: _Given
    limits: _Limits
    gear: Gear | None

    @property
    def floor(self) -> float:
        """Least approach speed [m/s] that is latched."""
        return self.given.bound["approach_floor"] if "approach_floor" in self.model.parameters else APPROACH_FLOOR

    def __call__(
        self,
        tolerance: float,
        scales: Scales,
        observers: Sequence[Observer],
        block: int | None,
        progress: Callable[[float], object] | None = None,
    ) -> Ending:
        """Run, and show the accepted steps to observers, in blocks (see `Recorder`)."""
        integrator = self.engine.integrator
        layout = integrator.layouts.controls
        controls = np.zeros(layout.size)
        numbers: dict[str, Any] = {
            "c": self.given.bound.c,
            "scale": scales.state,
            "scales": scales.scene,
            "tolerance": tolerance,
        }
        numbers |= {"t_end": self.given.seconds, "h_max": self.given.seconds / LEAST_STEPS, "floor": self.floor}
        numbers |= {"max_events": self.limits.max_events, "max_steps": self.limits.max_steps}
        for name, value in numbers.items():
            controls[layout[name]] = value
        begin = self.engine.begin.take()
        for place, values in zip(begin.inputs, (0.0, self.given.q, self.given.u, controls), strict=True):
            place[:] = values
        state = begin()[0][0].copy()
        self.engine.begin.give_back(begin)
        wall_time = self.limits.wall_time
        loop = self.engine.march if self.gear is None else partial(self.engine.march, self.gear, integrator)
        recorder = Recorder(lambda rows: History(self.model, rows, controls, integrator), observers, block)
        ending = loop(state, controls, recorder.keep, wall_time=wall_time, progress=progress)
        recorder.flush()
        return ending

    def made(
        self,
        tolerance: float,
        scales: Scales,
        times: np.ndarray | None,
        *,
        progress: Callable[[float], object] | None = None,
        beside: np.ndarray | None = None,
        alone: bool = False,
    ) -> _Made:
        """Run and keep every step or the states at some times [s], what is found, and the states at times `beside`, or these `alone`."""
        if alone:
            times = beside
        kept = Steps() if times is None else Grid(times)
        given = self.given
        period = self.model.period(given.bound)
        findings = Findings(self.model, self.method, later=times is None, duration=given.seconds, period=period)
        speeds = tuple(_approach_speeds(self.model, self.given.bound))
        other = kept if beside is None or alone else Grid(beside)
        observers = (
            [kept] if alone else [kept, findings, *speeds] if other is kept else [kept, findings, *speeds, other]
        )
        before = self.gear.compile_s if self.gear else 0.0
        ending = self(tolerance, scales, observers, None if times is None else BLOCK, progress)
        return _Made(
            tolerance=tolerance,
            ending=ending,
            kept=kept,
            beside=other,
            findings=findings,
            speeds=speeds,
            counted={name: int(ending.last[row]) for name, row in self.engine.counters.items()},
            compiled=self.gear is not None and self.gear.compiled,
            compile_s=self.gear.compile_s - before if self.gear else 0.0,
        )

    def outcome(self, made: _Made) -> Outcome:
        """How a run ended."""
        limits, ends = self.limits, made.kept.ends
        return outcome(
            made.ending.status,
            t=float(ends.t[-1]),
            where=_deepest(self.model, ends) if made.ending.status == OUTSIDE_LAW_RANGE else "",
            tolerance=made.tolerance,
            **vars(limits),
        )


@dataclass(frozen=True)
class _Made:
    """One run, and what was kept of it."""

    tolerance: float
    ending: Ending
    kept: Steps | Grid
    beside: Steps | Grid
    findings: Findings
    speeds: tuple[ApproachSpeeds, ...]
    counted: Mapping[str, int]
    compiled: bool
    compile_s: float


def prepare(model: Model, method: str, compiled: bool | Literal["auto"], ahead: float = 0.0) -> bool:
    """Build what runs of a model need, before they are made side by side; returns whether they are to be compiled.

    That is as `compiled` says, or with "auto" if it saves time for runs that take `ahead` [s] uncompiled. Raises InputError without a compiler.
    """
    bound, _ = model.check({})
    q, _ = _start(model, bound, {}, [])
    typical = model if bound is None else model.without_redundancy(_dependent(model, bound, q))
    code = _engine_for(typical, method, compiled).code
    if compiled == "auto":
        return code is not None and code.worthwhile(math.inf, ahead) is not None
    return compiled and code is not None


def check_settings(
    model: Model,
    duration: str | float | None,
    accuracy: float | None,
    method: str,
    compiled: bool | Literal["auto"],
    *,
    tolerance: float | None = None,
    output: Output = "steps",
    max_steps: int = MAX_STEPS,
    max_events: int = MAX_EVENTS,
    wall_time: float | None = None,
) -> None:
    """Raise InputError for what is bad input to a run whatever its parameters."""
    faults: list[Fault] = []
    limits = _Limits(max_steps, max_events, math.inf if wall_time is None else wall_time)
    _check(accuracy, tolerance, method, limits, faults)
    _check_compiled(compiled, faults)
    times_of(output, _duration(duration, faults), faults)
    if faults:
        raise InputError(model.name, faults)


def _engine_for(model: Model, method: str, compiled: bool | Literal["auto"]) -> _Engine:
    """The engine, and its C version where that is asked for."""
    engine: _Engine = model.once(("engine", method), lambda: _engine(model, method))
    if compiled is True and engine.code is not None:
        from hertzwerk.runtime.integrate.compiled import NoCompilerError

        try:
            engine.code.compile()
        except NoCompilerError as error:
            way_out = "compiled=False runs the same functions, slower"
            raise InputError(model.name, [Fault("compiled", str(error), "a working C compiler", way_out)]) from error
    return engine


def _engine(model: Model, method: str) -> _Engine:
    made = model.once(("integrator", method), lambda: integrator(model, tuple(table() for table in METHODS[method])))
    rows = made.layouts.state
    counters = {name: rows[name].start for name in COUNTERS}
    if method in SUNDIALS:  # never in the graph
        from hertzwerk.runtime.integrate import sundials

        reference = sundials.reference(model, made.layouts, method)
        return _Engine(made, Callers(made.begin), counters, None, partial(sundials.march, reference))
    return _Engine(made, Callers(made.begin), counters, Code(chunk(made)), march)


def _read(
    model: Model,
    duration: str | float | None,
    accuracy: float | None,
    tolerance: float | None,
    method: str,
    compiled: bool | Literal["auto"],
    limits: _Limits,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    output: Output,
) -> tuple[_Given, np.ndarray | None]:
    """Everything given, read, and the times of a grid; raises InputError with every fault. Text that was read before is not read again."""
    faults: list[Fault] = []
    _check(accuracy, tolerance, method, limits, faults)
    _check_compiled(compiled, faults)
    known: dict[str, _Given] = model.once("given", dict)
    key = repr((duration, parameters, initial))  # tells 1 from True and from "1"
    given = None if faults else known.get(key)
    seconds = _duration(duration, faults) if given is None else given.seconds
    times = times_of(output, seconds, faults)
    if given is not None and not faults:
        return given, times
    bound, wrong = model.check(parameters)
    q, u = _start(model, bound, initial, faults)
    if bound is None or wrong or faults:
        raise InputError(model.name, wrong + faults)
    given = _Given(bound, q, u, seconds, scaling.of_parameters(model, bound), _dependent(model, bound, q))
    if len(known) >= REMEMBERED:
        known.clear()
    known[key] = given
    return given, times


def _check(accuracy: float | None, tolerance: float | None, method: str, limits: _Limits, faults: list[Fault]) -> None:
    for name, value, (low, high) in (("accuracy", accuracy, ACCURACIES), ("tolerance", tolerance, TOLERANCES)):
        if value is not None and not (_real(value) and low <= value <= high):
            way_out = "it is measured in the scene's scales"
            faults.append(Fault(name, repr(value), f"a number in {low:g}..{high:g}", way_out))
    if accuracy is not None and tolerance is not None:
        way_out = "an accuracy is of the end of the run, a tolerance is local and without an estimate"
        faults.append(Fault("tolerance", f"{tolerance!r} beside accuracy={accuracy!r}", "one of the two", way_out))
    if method not in METHODS:
        faults.append(unknown("method", str(method), sorted(METHODS)))
    for name, limit in vars(limits).items():
        if not (_real(limit) and limit > 0):
            faults.append(Fault(name, repr(limit), "a positive number"))


def _check_compiled(compiled: object, faults: list[Fault]) -> None:
    if not (isinstance(compiled, bool) or compiled == "auto"):
        faults.append(Fault("compiled", repr(compiled), 'True, False or "auto"'))


def _real(value: object) -> bool:
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)


def _duration(duration: str | float | None, faults: list[Fault]) -> float:
    """Seconds of a duration; what is none becomes a fault."""
    expected = 'a positive time, such as "24 ms" or a number of seconds'
    if isinstance(duration, str):
        return read_time("duration", duration, expected, faults)
    if duration is not None and _real(duration) and math.isfinite(duration) and duration > 0:
        return float(duration)
    faults.append(Fault("duration", "none" if duration is None else repr(duration), expected))
    return math.nan


def start_of(
    model: Model, parameters: Mapping[str, Value], initial: Mapping[str, Value]
) -> tuple[Bound, np.ndarray, np.ndarray]:
    """What a run would start from: the numbers bound, q and u, loops closed; raises InputError with every fault."""
    faults: list[Fault] = []
    bound, wrong = model.check(parameters)
    q, u = _start(model, bound, initial, faults)
    if bound is None or wrong or faults:
        raise InputError(model.name, wrong + faults)
    return bound, q, u


def _start(
    model: Model, bound: Bound | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """q and u at the start: the model's, with `initial` in their place; in absolute coordinates both are of the joints, and are placed."""
    joints = model.joints
    q, u = _assembled(joints, bound, initial, faults)
    if joints is model or bound is None or faults:
        return q, u
    q, u = (np.array(x).ravel() for x in model.function("placed")(0.0, q, u, bound.c))
    return q, u


def _assembled(
    model: Model, bound: Bound | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """The start in joint coordinates, loops closed."""
    values: dict[str, float] = {}
    names = (*model.coordinates, *model.speeds)
    for name, value in initial.items():
        if name not in names:
            faults.append(unknown("state", name, names))
            continue
        si, fault = read_state(name, model.units[name], value)
        values[name] = si
        if fault is not None:
            faults.append(fault)
    if bound is None:
        return np.zeros(model.nq), np.zeros(model.nu)
    start = np.concatenate([np.array(x).ravel() for x in model.function("start")(bound.p)])
    for i, name in enumerate(names):
        start[i] = values.get(name, start[i])
        if not math.isfinite(start[i]) and name not in values:
            faults.append(
                Fault(name, f"{float(start[i])!r} at the start", "a finite value", "it follows from the parameters")
            )
    for i in model.quaternions:
        norm = float(np.linalg.norm(start[i : i + 4]))
        if math.isfinite(norm):
            if norm == 0:
                faults.append(
                    Fault(
                        names[i].removesuffix("0"),
                        "a quaternion of norm 0 at the start",
                        "one that can be divided by its norm",
                    )
                )
            start[i : i + 4] /= norm or 1
    q, u = start[: model.nq], start[model.nq :]
    if model.nl and not faults:
        from hertzwerk.runtime.assembly import assemble  # a tree needs none

        q, u, open_ones = assemble(model, bound, q, u, {*model.module.GIVEN, *values})
        faults.extend(open_ones)
    return q, u


def _dependent(model: Model, bound: Bound, q: np.ndarray) -> tuple[Dependent, ...]:
    """Constraints that follow from others, from a start on."""
    if not model.nl:
        return ()
    from hertzwerk.runtime.assembly import dependent  # a tree needs none

    return dependent(model, bound, q)


def _deepest(model: Model, history: History) -> str:
    return ", ".join(f"{pair} at penetration {history[f'{pair}.penetration'][-1]:.4g} m" for pair in model.pairs)


def _open_forces(model: Model, given: _Given) -> Iterator[str]:
    """Redundant constraints: the motion does not say how they share what they hold."""
    if not model.nl:
        return
    from hertzwerk.runtime.assembly import undetermined  # a tree needs none

    names = [holding_force(name) for name in undetermined(model, given.bound, given.q)]
    if names:
        yield f"redundant constraints leave these forces open, of all that hold the least are given: {', '.join(names)}"


def unchecked(model: Model) -> tuple[str, ...]:
    """What of a model runs although it is inconsistent."""
    return tuple(
        f"{effect} is dimensionally inconsistent and runs unchecked: {why}" for effect, why in model.module.UNCHECKED
    )


def _approach_speeds(model: Model, bound: Bound) -> Iterator[ApproachSpeeds]:
    """Of the pairs whose compliant law holds up to a speed: those whose material has a density."""
    for pair, limit in zip(getattr(model.module, "SPEED_LIMITED", ()), _speed_limits(model, bound), strict=True):
        yield ApproachSpeeds(float(limit), Track(model.pairs.index(pair)))


def _too_fast(model: Model, speeds: Sequence[ApproachSpeeds]) -> Iterator[str]:
    """Contacts faster than their compliant law allows."""
    for seen in speeds:
        if seen.over:
            yield (
                f"{seen.over} of {seen.count} impacts of {model.pairs[seen.track.pair]} exceed the law's limit "
                f"v0 <= 1e-5*sqrt(E/rho) = {seen.limit:.3g} m/s (worst {seen.worst:.3g} m/s)"
            )


def _speed_limits(model: Model, bound: Bound) -> np.ndarray:
    """Of the pairs in SPEED_LIMITED [m/s]."""
    if not hasattr(model.module, "SPEED_LIMITED"):
        return np.zeros(0)
    return np.asarray(model.function("speed_limits")(bound.p)).ravel()


def _floored(count: int, floor: float) -> tuple[str, ...]:
    if not count:
        return ()
    contacts = "one contact began" if count == 1 else f"{count} contacts began"
    return (f"{contacts} slower than approach_floor = {floor:g} m/s, which its damping took for the approach speed",)
