"""Request for a comparison with measured data, read and checked: columns, instrument, ranges, noise."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse, shown, unknown
from hertzwerk.derive.common.units import UnitError, parse_unit, rate_remedy
from hertzwerk.runtime.engine.inputs.measurement_csv import Columns, MeasuredTable, Measurement, read_measurement
from hertzwerk.runtime.engine.model.binding import Value, flag_faults, named_values, read, read_state
from hertzwerk.runtime.engine.solution.history import Histories
from hertzwerk.runtime.studies.comparison.alignment import Range
from hertzwerk.runtime.studies.comparison.filtered_run import ORDERS, Instrument
from hertzwerk.runtime.system.arrays import Array

HERTZ = {"Hz": "1/s", "kHz": "1/ms", "MHz": "1/us"}  # of periods; elsewhere hertz might count radians or turns

AS_MEASURED = "Measurement(run.t, dict(run), run.units) makes a measurement of a run"
Between = str | float | tuple[float, float]  # "-2..2 ms", (-0.002, 0.002), or one value


@dataclass(frozen=True)
class Channel:
    """Measured column beside a history.

    Samples in the history's unit (SI), nan where missing; noise: their standard deviation in SI, None where none is
    stated.
    """

    column: str
    history: str
    unit: str
    samples: Array
    noise: float | None = None


@dataclass(frozen=True)
class ComparisonRequest:
    """Request for a comparison; instrument: None where the run is compared as it is."""

    measurement: Measurement
    channels: tuple[Channel, ...]
    instrument: Instrument | None
    offsets: Range
    drifts: Range

    @property
    def lasts(self) -> float:
        """Time [s] until which a run covers the data, wherever in the ranges they are put."""
        times = self.measurement.times
        settling = self.instrument.settling if self.instrument is not None and self.instrument.zero_phase else 0.0
        return self.offsets[1] + float(times[-1] + self.drifts[1] * (times[-1] - times[0])) + settling


def read_comparison_request(
    units: Mapping[str, str],
    data: Measurement | MeasuredTable,
    map: Mapping[str, str] | None,
    *,
    bandwidth: str | float | None,
    order: int,
    zero_phase: bool,
    offset: Between,
    drift: Between,
    noise: Mapping[str, Value] | None,
) -> ComparisonRequest:
    """Read a comparison against the SI units of a run's histories; raises InputError with every fault."""
    faults: list[Fault] = []
    instrument = _instrument(bandwidth, order, zero_phase, faults)
    offsets, drifts = read_between("offset", offset, "s", faults), read_between("drift", drift, "1", faults)
    if drifts[0] <= -1:
        faults.append(Fault("drift", f"{drifts[0]:g}", "more than -1", "0.01 means that the run takes 1 % longer"))
    if map is not None and not (isinstance(map, Mapping) and map):
        faults.append(Fault("map", shown(map), "histories by column, such as {'acceleration': 'guide.acceleration'}"))
        map = None
    measurement: Measurement | None = None
    with noted(faults):
        refuse("data", [Fault("data", "a run", "measured data", AS_MEASURED)] if isinstance(data, Histories) else [])
        measurement = (
            data if isinstance(data, Measurement) else read_measurement(data, None if map is None else list(map))
        )
    channels = read_channels(units, measurement, map, noise, faults)
    if faults or measurement is None:
        raise InputError("comparison with measured data", faults)
    return ComparisonRequest(measurement, channels, instrument, offsets, drifts)


def read_channels(
    units: Mapping[str, str],
    measurement: Columns | None,
    map: Mapping[str, str] | None,
    noise: Mapping[str, Value] | None,
    faults: list[Fault],
) -> tuple[Channel, ...]:
    """Return measured columns beside histories of these SI units; bad input is appended to `faults`.

    measurement: None where it could not be read, so that names alone are checked.
    """
    noise = named_values("noise", {} if noise is None else noise, faults)
    channels: list[Channel] = []
    pairs = dict(map) if map is not None else {name: name for name in (measurement.columns if measurement else ())}
    for column, history in pairs.items():
        if not isinstance(history, str) or history not in units or history == "t":
            fault, mapped = unknown("history", history, [name for name in units if name != "t"]), map is not None
            remedy = fault.remedy or ("" if mapped else f'name the history: --map "{column}=NAME"')
            where = f"{column}, {fault.where}" if mapped else column
            faults.append(Fault(where, fault.found, fault.expected, remedy))
        elif measurement is not None and column not in measurement.columns:
            faults.append(unknown("column", column, measurement.columns))
        elif measurement is not None:
            channels += _channel(measurement, column, history, units[history], noise, faults)
    if measurement is not None and not pairs:
        faults.append(Fault("map", f"no column of {measurement.source or 'the data'}", "columns beside histories"))
    faults += [unknown("column", name, pairs) for name in noise if name not in pairs]
    return tuple(channels)


def _channel(
    measurement: Columns,
    column: str,
    history: str,
    declared: str,
    noise: Mapping[str, Value],
    faults: list[Fault],
) -> list[Channel]:
    """Return the channel of a column, if its unit and its noise are those of the history; else its faults."""
    where, unit, expected = f"{measurement.source or 'data'}, {column}", measurement.unit(column), parse_unit(declared)
    text = f"[{measurement.units[column]}]"
    size: float | None = None
    fault: Fault | None = None
    if unit.exponents != expected.exponents:
        fault = Fault(where, f"{text}, which is {unit}", f"a unit of {declared}, as {history} has")
    elif unit.mistaken_for(expected):
        fault = Fault(where, text, f"a unit of {declared}, as {history} has", rate_remedy(unit))
    elif column in noise:
        size, fault = read_state(f"noise of {column}", declared, noise[column])
        if fault is None and not size > 0:
            fault = Fault(f"noise of {column}", shown(noise[column]), f"a positive standard deviation in {declared}")
    if fault is not None:
        faults.append(fault)
        return []
    return [Channel(column, history, declared, measurement.si(column), size)]


def _instrument(
    bandwidth: str | float | None, order: object, zero_phase: bool, faults: list[Fault]
) -> Instrument | None:
    whole = isinstance(order, int) and not isinstance(order, bool) and ORDERS[0] <= order <= ORDERS[1]
    faults += flag_faults(zero_phase=zero_phase)
    if not whole:
        faults.append(Fault("order", shown(order), f"a whole number in {ORDERS[0]}..{ORDERS[1]}"))
    if bandwidth is None:
        return None
    stated: Any = (bandwidth, "1/s")
    if isinstance(bandwidth, str):
        stated = re.sub(r"(?<=[\d.])\s*([kM]?Hz)", lambda unit: f" {HERTZ[unit[1]]}", bandwidth)
    cut_off, fault = read_state("bandwidth", "1/s", stated)
    if fault is not None or not cut_off > 0:
        remedy = "in Hz, kHz or MHz, of periods: rad/s is no frequency"
        faults.append(Fault("bandwidth", shown(bandwidth), 'a positive cut-off frequency, such as "5 kHz"', remedy))
        return None
    return Instrument(cut_off, order, zero_phase) if whole and isinstance(order, int) else None


def read_between(where: str, between: Between, unit: str, faults: list[Fault]) -> Range:
    """Return the ends of a range in SI; bad input is appended to `faults`."""
    example = '"-2..2 ms"' if unit == "s" else '"-1e-4..1e-4" or "-0.01..0.01 %"'
    expected = f"a range such as {example}, or one value"
    try:
        if isinstance(between, str):
            low, dots, high = between.partition("..")
            texts = (low, high) if dots else (low, low)
            _, _, unit_text = read(texts[1])
            values = [
                read(text if k or read(text)[2] != "1" else f"{text} {unit_text}") for k, text in enumerate(texts)
            ]
        else:
            ends = between if isinstance(between, tuple) and len(between) == 2 else (between, between)
            values = [read((end, unit)) for end in ends]
    except UnitError as error:
        faults.append(Fault(where, shown(between), expected, str(error)))
        return 0.0, 0.0
    si = [each.to_si(value) for value, each, _ in values]
    if any(each.exponents != parse_unit(unit).exponents for _, each, _ in values):
        faults.append(Fault(where, shown(between), expected, "in a unit of time" if unit == "s" else "a plain number"))
    elif not all(map(math.isfinite, si)) or si[0] > si[1]:
        faults.append(Fault(where, shown(between), expected, "the lower end first"))
    else:
        return si[0], si[1]
    return 0.0, 0.0
