"""Values of a scene's inputs as a user gives them, read into signals with every fault at once.

"0.5 N m"                      a constant, also as (0.5, "N m"), a bare number where it is dimensionless
(times, values)                two arrays, in s and in the input's unit, joined by straight lines; `Samples` says more
Samples(times, values, units)  samples with units, joined, held or as a spline
"FILE.csv:column"              a column of a file headed `name [unit]`, also "FILE.csv:column:held"
"FILE.csv"                     the column that is called as the input
"FILE.csv?skip=3&decimal=,&units.t=ms&columns.load=CH 2&missing=-999"    read as `read_measurement` does with these arguments
Table(...)                     a table of the time as scenes have it
function                       of the time [s], returning the value in the input's unit
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar
from urllib.parse import parse_qsl

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown, unknown
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.inputs.time_series import BETWEEN, Samples, Unresolved, fault_of, sampled
from hertzwerk.runtime.engine.model.binding import Value, named_values, read_state
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.signal import DEGREE, Signal, constant
from hertzwerk.runtime.engine.run.run_request import read_duration

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.inputs.measurement_csv import Reading

Input: TypeAlias = Any
"""Value of an input, as this module's docstring lists them."""
Duration: TypeAlias = str | float | None
AnyModel = TypeVar("AnyModel", bound=EngineModel)
_HOW = r"(?P<how>\?[^:]*)?"
_COLUMN = re.compile(rf"(?P<file>[^?]+\.[A-Za-z]+){_HOW}:(?P<column>[^:]+?)(?::(?P<between>\w+))?")
_FILE = re.compile(rf"(?P<file>[^?]+\.csv){_HOW}", re.IGNORECASE)
INPUTS = 'values of inputs by name, such as torque = "bench.csv:load"'
FORMS = 'a value such as "0.5 N m", "FILE.csv:column", Samples(times, values, units), a Table or a function of the time'


def signals_of(
    model: EngineModel, inputs: Mapping[str, Input] | None, seconds: float, faults: list[Fault]
) -> dict[str, Signal]:
    """Return the signals of a model's inputs; faults are appended.

    seconds    [s], up to which functions are sampled
    """
    signals: dict[str, Signal] = {}
    for name, value in named_values("inputs", {} if inputs is None else inputs, faults).items():
        if name not in model.inputs:
            faults.append(unknown("input", name, model.inputs))
            continue
        signal = signal_of(name, value, model.inputs[name][0], seconds, faults)
        signals |= {} if signal is None else {name: signal}
    return signals


def in_file(value: object) -> dict[str, str]:
    """Return file, how, column and between of "FILE?how:column:between" or "FILE.csv?how"; {} for others."""
    text = value.strip() if isinstance(value, str) else ""
    written = _COLUMN.fullmatch(text) or _FILE.fullmatch(text)
    return {} if written is None else {part: piece for part, piece in written.groupdict().items() if piece is not None}


def located(value: Input, folder: Path) -> Input:
    """Return "NAME=FILE:column", or "FILE:column", with the file as seen from a folder; other values stay."""
    if not isinstance(value, str):
        return value
    before, query, how = value.partition("?")
    name, equals, rest = before.rpartition("=")
    rest = (rest + query + how).strip()
    file = in_file(rest).get("file", "")
    if not file or Path(file).is_absolute():
        return value
    return f"{name}{equals}{folder / file}{rest[len(file) :]}"


def input_text(value: Input) -> str | None:
    """Return the value of an input as text that reads back, files by whole paths; None where it is none."""
    if isinstance(value, str):
        return str(located(value, Path.cwd()))
    if isinstance(value, int | float):
        return repr(value)
    return f"{value[0]!r} {value[1]}" if isinstance(value, tuple) and isinstance(value[-1], str) else None


def with_input_values(
    model: AnyModel, inputs: Mapping[str, Input] | None, duration: Duration, parameters: Mapping[str, Value]
) -> tuple[AnyModel, list[Fault]]:
    """Return a model with the values of its inputs for runs of a duration, and the faults of those.

    What a model was given before, it keeps. Faults of the duration and of inputs without a value are for `run_request` to find.
    """
    faults: list[Fault] = []
    if inputs is None or (isinstance(inputs, Mapping) and not inputs):
        return model, faults
    seconds = read_duration(model, parameters, duration, [])
    signals = signals_of(model, inputs, seconds, faults)
    return model.with_signals({**model.signals, **signals}), faults


def signal_of(name: str, value: Input, unit: str, seconds: float, faults: list[Fault]) -> Signal | None:
    """Return the signal of an input's value; faults are appended.

    seconds    [s], up to which functions are sampled
    """
    where = f"input {name}"
    if isinstance(value, Signal):
        return value
    if parts := in_file(value):
        column, between = parts.get("column", name).strip(), parts.get("between", "linear")
        return _of_file(where, parts["file"], parts.get("how", ""), column, between, unit, faults)
    if isinstance(value, Samples):
        return _checked(where, value.faults(where), value.units, unit, value.signal, faults)
    if hasattr(value, "pieces") and hasattr(value, "units"):
        return _checked(where, value.faults(), value.units, unit, partial(_of_table, value), faults)
    if callable(value):
        return _of_function(where, value, unit, seconds, faults)
    if isinstance(value, tuple | list) and len(value) == 2 and not isinstance(value[1], str):
        return signal_of(name, Samples(value[0], value[1], ("s", unit)), unit, seconds, faults)
    plain = isinstance(value, str | int | float | np.number) or (isinstance(value, tuple) and len(value) == 2)
    if not plain or isinstance(value, bool):
        faults.append(Fault(where, shown(value), FORMS))
        return None
    si, fault = read_state(where, unit, value)
    if fault is not None:
        remedy = fault.remedy or f'of a file the column: "FILE.csv:NAME"; what may be given is {FORMS}'
        faults.append(Fault(where, fault.found, fault.expected, remedy))
        return None
    return constant(si, shown(value)[1:-1] if isinstance(value, str) else f"{si:g}")


def _checked(
    where: str,
    own: Iterable[Fault],
    units: tuple[str, str],
    unit: str,
    signal: Callable[[], Signal],
    faults: list[Fault],
) -> Signal | None:
    """Return a signal without faults of its `own` or of its units."""
    wrong = list(own) or _unit_faults(where, units, unit)
    faults += wrong
    return None if wrong else signal()


def _unit_faults(where: str, units: tuple[str, str], unit: str) -> list[Fault]:
    """Return the faults of a time whose unit is none, and of a value in another unit than the input's."""
    faults = [] if parse_unit(units[0]).exponents == parse_unit("s").exponents else [
        Fault(where, f"times in {units[0]}", "a unit of time", 'units are those of time and value, such as ("ms", "N m")')
    ]  # fmt: skip
    _, fault = read_state(where, unit, (1.0, units[1]))
    return faults if fault is None else [*faults, Fault(where, f"values in {units[1]}", f"values in {unit}")]


def _of_table(table: Any) -> Signal:
    pieces = np.array(table.pieces())
    return Signal(pieces[:-1, 0], pieces[:-1, 1 : DEGREE + 2], float(pieces[-1, 0]), f"table {table.name}", 4)


def _of_function(where: str, function: Any, unit: str, seconds: float, faults: list[Fault]) -> Signal | None:
    if not (math.isfinite(seconds) and seconds > 0):
        return None  # the duration is a fault of its own
    to_si = parse_unit(unit).to_si
    try:
        return sampled(lambda t: to_si(function(t)), seconds, getattr(function, "__name__", "function"))
    except Unresolved as error:
        faults.append(fault_of(where, error, unit))
        return None


def _reading(file: str, how: str) -> Reading:
    """Return how a file is read, of "?skip=3&units.t=ms"; raises InputError for other names."""
    from hertzwerk.runtime.engine.inputs.measurement_csv import Reading

    settings: dict[str, Any] = {"units": {}, "columns": {}, "missing": []}
    for key, value in parse_qsl(how.removeprefix("?"), keep_blank_values=True):
        name, _, column = key.partition(".")
        number = int(value) if value.isdecimal() else value
        if name in ("units", "columns") and column:
            settings[name][column] = value if name == "units" else number
        elif key == "missing":
            settings[key].append(value)
        elif key in ("skip", "decimal"):
            settings[key] = number
        else:
            raise InputError(
                file, [Fault(f"?{key}", "no argument", "skip, decimal, missing, units.NAME or columns.NAME")]
            )
    return Reading(file, **{**settings, "columns": settings["columns"] or None})


def _of_file(where: str, file: str, how: str, name: str, between: str, unit: str, faults: list[Fault]) -> Signal | None:
    from hertzwerk.runtime.engine.inputs.measurement_csv import read_measurement

    try:
        measured = read_measurement(_reading(file, how), [name])
    except InputError as error:
        faults += [
            Fault(f"{where}, {fault.where}", fault.found, fault.expected, fault.remedy) for fault in error.faults
        ]
        return None
    if between not in BETWEEN:
        faults.append(Fault(where, f"{file}:{name}:{between}", f"one of {', '.join(BETWEEN)} after the column"))
        return None
    there = np.isfinite(measured.columns[name])  # a missing sample is left out
    samples = Samples(measured.times[there], measured.columns[name][there], ("s", measured.units[name]), between, f"{file}:{name}")  # type: ignore[arg-type]  # fmt: skip
    return _checked(where, samples.faults(where), samples.units, unit, samples.signal, faults)
