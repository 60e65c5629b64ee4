"""Request for a run, read and checked: method, limits, duration, parameters, start."""

from __future__ import annotations

import contextlib
import math
import pickle
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, refuse, shown, unknown
from hertzwerk.derive.common.units import UnitError, parse_quantity
from hertzwerk.runtime.engine.accuracy.error_estimate import LEAST
from hertzwerk.runtime.engine.integration.loop.near_list import listing
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH, METHODS, SUNDIALS
from hertzwerk.runtime.engine.model.binding import Value, plain_value, read_time
from hertzwerk.runtime.engine.model.free_quantities import derivative_faults
from hertzwerk.runtime.engine.model.model import BoundParameters, Dependent, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.si_values import si_of, si_units
from hertzwerk.runtime.engine.model.signal import digest_of
from hertzwerk.runtime.engine.run.drive_speed import drive_speed
from hertzwerk.runtime.engine.run.output_times import Grid, times_of
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.start.separation import overlaps
from hertzwerk.runtime.engine.start.start_values import dependent, start_of
from hertzwerk.runtime.system.lazy import cached_property

ACCURACIES, TOLERANCES = (1e-12, 1e-1), (LEAST, 1e-1)
METHOD: Final = "auto"  # where none is named: bitwise dop853 where nothing is stiff, within 5 % of its time
REMEMBERED = 64  # inputs of a model kept as read
LIMITS = "max_steps", "max_events", "wall_time"

Compiled: TypeAlias = bool | Literal["auto"]
Accuracy: TypeAlias = float | str
"""Largest error of a whole run, 1e-6, or of its end alone, "1e-6 at the end", in the scene's scales."""
AT_END = " at the end"


@dataclass(frozen=True)
class Request:
    """Accuracy as read: the largest error, and whether it is requested at the end alone."""

    error: float
    at_end: bool = False


@dataclass(frozen=True)
class Limits:
    """Limits of steps and of contacts of a run, and of wall time [s] of a call; infinite by default.

    whose    who limits the steps
    """

    max_steps: float
    max_events: float
    wall_time: float
    whose: str = "max_steps"


@dataclass(frozen=True)
class Settings:
    """Arguments of `simulate` but for parameters and start, as given by the user."""

    duration: str | float | None
    accuracy: Accuracy | None
    tolerance: float | None
    method: str = METHOD
    compiled: Compiled = "auto"
    grid: Grid = None
    max_steps: int | None = None
    max_events: int | None = None
    wall_time: float | None = None
    sensitivities: Sequence[str] = ()

    @property
    def request(self) -> Request | None:
        """The accuracy as read; None where there is none, or no sound one."""
        return None if self.accuracy is None else read_accuracy(self.accuracy)

    @cached_property
    def limits(self) -> Limits:
        """Limits of steps and contacts of each run, of the wall time of all runs together."""
        return Limits(self.max_steps or math.inf, self.max_events or math.inf, self.wall_time or math.inf)

    def check(self, model: EngineModel) -> None:
        """Raise InputError for input that is bad whatever the parameters of the run."""
        faults = self.faults()
        times_of(self.grid, read_duration(model, {}, self.duration, faults), faults)
        faults += self.sensitivity_faults(model)
        refuse(model.name, faults)

    def sensitivity_faults(self, model: EngineModel) -> list[Fault]:
        """Return the faults of the names of derivatives."""
        names = self.sensitivities
        if isinstance(names, str) or not isinstance(names, Sequence):
            expected = 'names of parameters and initial states, such as ("restitution",)'
            return [Fault("sensitivities", shown(names), expected)]
        return [*derivative_faults(model, names), *steps_faults("sensitivities", self.method, model)] if names else []

    def faults(self) -> list[Fault]:
        """Return the faults of everything but the duration and the grid, which depends on it."""
        return list(self._faults)

    @cached_property
    def _faults(self) -> list[Fault]:
        faults: list[Fault] = []
        low, high = ACCURACIES
        if self.accuracy is not None and (self.request is None or not low <= self.request.error <= high):
            expected = f'a number in {low:g}..{high:g}, or "1e-6{AT_END}"'
            faults.append(Fault("accuracy", shown(self.accuracy), expected, "it is measured in the scene's scales"))
        low, high = TOLERANCES
        if self.tolerance is not None and not (is_real(self.tolerance) and low <= self.tolerance <= high):
            way_out = "it is measured in the scene's scales"
            faults.append(Fault("tolerance", shown(self.tolerance), f"a number in {low:g}..{high:g}", way_out))
        if self.accuracy is not None and self.tolerance is not None:
            way_out = "accuracy bounds the error of the whole run, tolerance the local error, without an estimate"
            faults.append(
                Fault("tolerance", f"{self.tolerance!r} and accuracy={self.accuracy!r}", "one of the two", way_out)
            )
        if not isinstance(self.method, str):
            faults.append(Fault("method", shown(self.method), f"one of {', '.join(sorted(METHODS))}"))
        elif self.method not in METHODS:
            faults.append(unknown("method", self.method, sorted(METHODS)))
        for name in LIMITS:
            limit, whole = getattr(self, name), name != "wall_time"
            if limit is not None and not (is_real(limit) and limit > 0 and not (whole and limit % 1)):
                faults.append(Fault(name, shown(limit), f"a positive {'whole ' * whole}number"))
        if not (isinstance(self.compiled, bool) or (isinstance(self.compiled, str) and self.compiled == "auto")):
            faults.append(Fault("compiled", shown(self.compiled), 'True, False or "auto"'))
        return faults


def progress_faults(progress: object) -> list[Fault]:
    """Return the fault of a progress that cannot be called."""
    if progress is None or callable(progress):
        return []
    return [Fault("progress", shown(progress), "a function of the fraction that is done, such as print")]


def progress_of(progress: Callable[[float], object] | None, done: int, count: int) -> Callable[[float], object]:
    """Return what reports the progress of one of several tasks as part of all."""
    return lambda part: progress and progress((done + part) / count)


def read_accuracy(value: object) -> Request | None:
    """Read an accuracy, a number or text such as "1e-6" or "1e-6 at the end"; None for anything else."""
    if isinstance(value, str):
        text = value.strip()
        try:
            return Request(float(text.removesuffix(AT_END)), text.endswith(AT_END))
        except ValueError:
            return None
    return Request(float(value)) if is_real(value) else None  # type: ignore[arg-type]  # a real number


def steps_faults(subject: str, method: str, model: EngineModel) -> list[Fault]:
    """Return the fault of what follows the steps of a run that has none of ours, or lists near pairs."""
    if method not in SUNDIALS:
        if method not in METHODS or listing(model, tuple(table() for table in METHODS[method])) is None:
            return []
        actual = f"a run by {method} of {model.k} pairs, which lists the near ones"
        return [Fault(subject, actual, "a model of fewer pairs, or a method without a list", 'method="esdirk"')]
    expected = f"a method of {', '.join(IN_GRAPH)}, whose steps are followed"
    return [Fault(subject, f"a run by {method}", expected, f'method="{METHOD}"')]


@dataclass(frozen=True)
class RunRequest:
    """Start and extent of a run.

    Bound parameters, q (nq,) and u (nu,) with loops closed, latches of contacts in progress, duration [s], scales stated by the scene, redundant
    constraints, given initial states, the period [s] of everything that depends on time, limits of approach speeds [m/s], warnings, and the time
    [s] at which it begins.
    """

    bound: BoundParameters
    q: np.ndarray
    u: np.ndarray
    latches: np.ndarray
    seconds: float
    scales: Scales
    dependent: tuple[Dependent, ...]
    initial: Mapping[str, Value]
    period: float | None
    speed_limits: np.ndarray
    warnings: tuple[str, ...]
    begin: float = 0.0


def read(
    model: EngineModel,
    settings: Settings,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    before: Sequence[Fault] = (),
) -> tuple[RunRequest, np.ndarray | None]:
    """Read everything given; return it with the times [s] of a grid.

    Raises InputError with `before` and every fault. Text that was read before is not read again.
    """
    faults = [*before, *settings.faults(), *settings.sensitivity_faults(model)]
    known, key = _remembered(model), _key((settings.duration, parameters, initial, digest_of(model.signals)))
    request = None if faults else known.get(key)
    seconds = read_duration(model, parameters, settings.duration, faults) if request is None else request.seconds
    times = times_of(settings.grid, seconds, faults)
    faults += input_faults(model, seconds, faults)
    if request is not None and not faults:
        return request, times
    bound, q, u = start_of(model, parameters, initial, faults)
    latches = np.array([0.0 if name not in initial else si_of(model, name, initial[name]) for name in model.latches])
    inside, pressed = overlaps(model, bound, initial, q, u)
    refuse(model.name, inside)
    request = RunRequest(
        bound,
        q,
        u,
        latches,
        seconds,
        scaling.of_parameters(model, bound),
        dependent(model, bound, q),
        dict(initial),
        model.period(bound),
        model.speed_limits(bound),
        (*bound.warnings, *(() if latches.any() else pressed)),
    )
    if len(known) >= REMEMBERED:
        known.clear()
    known[key] = request
    return request, times


def check(
    model: EngineModel,
    settings: Settings,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    before: Sequence[Fault] = (),
) -> None:
    """Check the input of a run without running; raises InputError with `before` and every fault found."""
    read(model, settings, parameters, initial, before)


def input_faults(model: EngineModel, seconds: float, before: Sequence[Fault] = ()) -> list[Fault]:
    """Return the faults of inputs without a value, or whose values do not cover the run or are too rough.

    seconds    duration of the run
    Inputs with a fault already, `input NAME`, are left out.
    """
    faults: list[Fault] = []
    reported = {fault.where.partition(",")[0] for fault in before}
    for name, (unit, meaning) in model.inputs.items():
        where = f"input {name}"
        if where in reported:
            continue
        signal = model.signals.get(name)
        if signal is None:
            expected = f"its value in {unit}{f': {meaning}' if meaning else ''}"
            faults.append(Fault(where, "no value", expected, f'inputs={{"{name}": ...}}, or --input {name}=...'))
        elif signal.begins[0] > 0 or signal.end < seconds * (1 - 1e-12):
            actual = f"{signal.text} from {signal.begins[0]:g} s to {signal.end:g} s"
            way_out = "shorten the run, or add a sample at each end"
            faults.append(Fault(where, actual, f"values over the whole run, from 0 to {seconds:g} s", way_out))
        elif signal.smooth < model.smooth.get(name, (-1, ""))[0]:
            derivatives, use = model.smooth[name]
            jumps = ("the value", "its rate", "its second derivative")[signal.smooth + 1]
            counted = ("one continuous derivative", "two continuous derivatives")[derivatives - 1]
            faults.append(Fault(where, f"{signal.text}: {jumps} jumps from piece to piece", f"values with {counted}, for {use}",
                                'Samples(times, values, units, "cubic"), FILE.csv:COLUMN:cubic, a Table or a smooth function'))  # fmt: skip
    return faults


@per_model
def _remembered(_: EngineModel) -> dict[Hashable, RunRequest]:
    """Inputs read before, by `_key`."""
    return {}


def _key(value: object) -> Hashable:
    """Return a key that distinguishes 1, True, 1.0 and "1", 0.0 and -0.0; unique where none exists."""
    try:
        return pickle.dumps(value)
    except Exception:  # whatever an object raises that has no such text
        return object()


def read_duration(
    model: EngineModel, parameters: Mapping[str, Value], duration: str | float | None, faults: list[Fault]
) -> float:
    """Return a duration [s], that of revolutions with these parameters; faults are appended."""
    expected = 'a positive time, such as "24 ms" or a number of seconds'
    value = plain_value(duration)
    duration = f"{value[0]!r} {value[1]}" if isinstance(value, tuple) and len(value) == 2 else value
    with contextlib.suppress(ValueError, TypeError):
        # on a command line "24" is 24 s, as 24 is
        duration = float(duration) if isinstance(duration, str) else duration
    if isinstance(duration, str):
        turned = _angle(duration)
        if turned is None:
            return read_time("duration", duration, expected, faults)
        return _time_to_turn(model, parameters, turned, duration, faults)
    if duration is not None and is_real(duration) and 0 < duration < math.inf:
        return float(duration)
    faults.append(Fault("duration", "none" if duration is None else shown(duration), expected))
    return math.nan


def duration_follows(model: EngineModel, names: Sequence[str], duration: object) -> bool:
    """Return whether a duration, such as "2 rev", changes with a parameter."""
    if not isinstance(duration, str):
        return False
    now = read_duration(model, {}, duration, [])
    bound, units = model.bind(), si_units(model)
    moved = ({name: (1.5 * bound[name], units[name] or "1")} for name in names if name in model.parameters)
    return any(read_duration(model, values, duration, []) not in (now, math.nan) for values in moved)


def _angle(text: str) -> float | None:
    """Return the radians of text such as "200 rev"; None if it is no angle."""
    try:
        value, unit = parse_quantity(text)
    except UnitError:
        return None
    return unit.to_si(value) if unit.dimensionless and unit.angle == 1 else None


def _time_to_turn(
    model: EngineModel, parameters: Mapping[str, Value], angle: float, text: str, faults: list[Fault]
) -> float:
    """Return the time [s] in which the drive of a scene turns through an angle [rad]."""
    bound = model.check(parameters)[0]
    if bound is None:
        return math.nan  # its faults are found where the parameters are read
    speed = drive_speed(model, bound)
    if speed is not None and 0 < angle < math.inf:
        return angle / speed
    if speed is None:
        expected = "a time: revolutions are those of a scene with one drive of constant speed"
        faults.append(Fault("duration", shown(text), expected, 'such as "24 ms"'))
    else:
        faults.append(Fault("duration", shown(text), 'a positive time or angle, such as "24 ms" or "200 rev"'))
    return math.nan


def is_real(value: object) -> bool:
    """Return whether a value is a number that a double can hold."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        return False
    try:
        return not math.isnan(float(value))
    except OverflowError:
        return False
