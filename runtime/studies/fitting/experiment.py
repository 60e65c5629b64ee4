"""Measured runs: their data, the values that they were made at, and what a run predicts of them.

Numbers of a run's impacts in their order, with derivatives, as measured impacts have them:

impacts.speed                    of all contacts, in the order of their onsets; also t, peak_force, peak_penetration
floor.impacts.speed              of one pair
impacts.rebound.vertical.travel  largest value that a history reaches between an impact and the next one
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, noted, shown, unknown
from hertzwerk.runtime.engine.inputs.input_values import with_input_values
from hertzwerk.runtime.engine.inputs.measurement_csv import (
    Columns,
    MeasuredImpacts,
    MeasuredTable,
    Measurement,
    Reading,
    counts_impacts,
    read_impacts,
    read_measurement,
)
from hertzwerk.runtime.engine.model.binding import Value, named_values
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.engine.run.run_request import read_duration
from hertzwerk.runtime.engine.solution.history import Histories, units_of
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.studies.comparison.comparison_request import Channel, read_channels
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.sensitivity.sensitivities import Sensitivities
    from hertzwerk.runtime.engine.solution.solution import EngineSolution
    from hertzwerk.runtime.simulation import Solution

Data = Measurement | MeasuredImpacts | MeasuredTable

LONGER = 1.25  # times the last measured time of an impact that a run lasts: it may be predicted later
APART = 1e-4  # of the spacing of samples: to both sides of one, for the rate of a history


@dataclass(frozen=True)
class Experiment:
    """Measurement of one run, with the parameter values of that run.

    data       a `Measurement` over time, `MeasuredImpacts`, or a table of either, as `read_measurement` reads it
    parameters, inputs    as `simulate` takes them, initial states among the parameters: {"drop_height": "0.5 m"}
    duration   of the run that is compared, by default that of the data; needed where impacts have no times
    """

    data: Data
    parameters: Mapping[str, Value] = field(default_factory=dict)
    inputs: Mapping[str, Any] | None = None
    duration: str | float | None = None
    name: str = ""


@dataclass(frozen=True)
class Observed:
    """Measured run as it was read.

    model, parameters, initial    what its runs are made of, but for what is fitted
    channels, column, at, measured    what is compared: per datum (n,) its channel, its time [s] or number, its value [SI]
    place      of every datum in the run, 0..1: (0, 1]
    """

    name: str
    model: EngineModel
    parameters: Mapping[str, Value]
    initial: Mapping[str, Value]
    table: Measurement | MeasuredImpacts
    channels: tuple[Channel, ...]
    duration: float
    column: NDArray[np.intp]
    at: Array
    measured: Array
    place: Array

    @property
    def by_impacts(self) -> bool:
        """Whether the data are impacts, not samples."""
        return isinstance(self.table, MeasuredImpacts)

    @property
    def max_events(self) -> int | None:
        """Number of contacts after which no more are needed; None where all may be."""
        counted = self.by_impacts and all(c.history.startswith(IMPACTS) for c in self.channels)
        return int(np.max(self.at)) + 1 if counted else None

    def times(self, run: Solution, offset: float) -> Array:
        """Return the run times [s] of the data (n,); inf for impacts that the run does not have."""
        if not self.by_impacts:
            return self.at + offset
        run_times = np.full(len(self.at), np.inf)
        for k, channel in enumerate(self.channels):
            rows = self.column == k
            run_times[rows] = _numbered(onsets(run, channel.history), self.at[rows], np.inf)
        return run_times

    def predicted(self, run: Solution, offset: float) -> Array:
        """Return what the run has in place of the data (n,) [SI]; nan where it has nothing."""
        predicted = np.full(len(self.at), np.nan)
        if not self.by_impacts:
            times = self.at + offset
            inside = (times >= run.engine.t_start) & (times <= run.engine.t_end)
            for history, rows in self._by_times(inside):
                rows = rows[np.argsort(times[rows], kind="stable")]
                predicted[rows] = run.at(times[rows])[history]
            return predicted
        for k, channel in enumerate(self.channels):
            rows = self.column == k
            values = of_impacts(run, channel.history)
            predicted[rows] = _numbered(values, self.at[rows], np.nan) - offset * (parts_of(channel.history)[1] == "t")
        return predicted

    def slopes(self, run: Solution, of: Sensitivities, offset: float) -> Array:
        """Return the derivatives of what is predicted (n, P) [SI]; nan where there are none."""
        slopes = np.full((len(self.at), len(of.names)), np.nan)
        if not self.by_impacts:
            times = self.at + offset
            inside = (times >= run.engine.t_start) & (times <= min(run.engine.t_end, of.until))
            for history, rows in self._by_times(inside):
                slopes[rows] = of.along(times[rows], history)
        else:
            for k, channel in enumerate(self.channels):
                rows = self.column == k
                slopes[rows] = _numbered(of_impacts(run, channel.history, of), self.at[rows], np.nan)
        return slopes

    def rates(self, run: Solution, offset: float) -> Array:
        """Return the derivatives of what is predicted (n,) with the offset [s]."""
        if self.by_impacts:
            times = np.array([parts_of(channel.history)[1] == "t" for channel in self.channels])
            return -times[self.column].astype(float)
        step = APART * float(np.median(np.diff(self.table.times))) if isinstance(self.table, Measurement) else 0.0
        after, before = (self.predicted(run, offset + d) for d in (step, -step))
        return (after - before) / (2 * step)

    def _by_times(self, inside: NDArray[np.bool_]) -> list[tuple[str, NDArray[np.intp]]]:
        return [
            (channel.history, np.flatnonzero(inside & (self.column == k))) for k, channel in enumerate(self.channels)
        ]


def _numbered(values: Array, numbers: Array, otherwise: float) -> Array:
    """Return the values of numbered impacts, counted from 1."""
    places = numbers.astype(int) - 1
    there = places < len(values)
    chosen = np.full((len(numbers), *values.shape[1:]), otherwise)
    chosen[there] = values[places[there]]
    return chosen


def read_experiments(
    model: EngineModel,
    data: object,
    *,
    map: Mapping[str, str] | None,
    noise: Mapping[str, Value] | None,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    inputs: Mapping[str, Any] | None,
    duration: str | float | None,
    latest: float,
    free: Sequence[str],
    faults: list[Fault],
) -> tuple[Observed, ...]:
    """Read the measured runs; bad input is appended to `faults`.

    latest    largest offset [s] of run time less measured time
    """
    runs = data if isinstance(data, Sequence) and not isinstance(data, str) else [data]
    if not runs:
        faults.append(Fault("data", "none", "measured runs: files, Measurement, MeasuredImpacts or Experiment"))
    if map is not None and not (isinstance(map, Mapping) and map):
        faults.append(Fault("map", shown(map), "histories by column, such as {'height': 'vertical.travel'}"))
        map = None
    noise = named_values("noise", {} if noise is None else noise, faults)
    experiments, measured_columns = [], set[str]()
    for number, each in enumerate(runs, 1):
        experiment = each if isinstance(each, Experiment) else Experiment(each)
        many = len(runs) > 1
        one = _observed(
            model,
            experiment,
            f"run {number}" if many else "",
            map,
            noise,
            {"parameters": parameters, "initial": initial},
            inputs if experiment.inputs is None else experiment.inputs,
            duration if experiment.duration is None else experiment.duration,
            latest,
            free,
            faults,
        )
        if one is not None:
            experiments.append(one)
            measured_columns |= {channel.column for channel in one.channels}
    if len(experiments) == len(runs):
        columns = measured_columns | set(map or ())
        faults += [unknown("column", name, sorted(columns)) for name in noise if name not in columns]
    return tuple(experiments)


def _observed(
    model: EngineModel,
    experiment: Experiment,
    where: str,
    map: Mapping[str, str] | None,
    noise: Mapping[str, Value],
    common: Mapping[str, Mapping[str, Value]],
    inputs: Mapping[str, Any] | None,
    duration: str | float | None,
    latest: float,
    free: Sequence[str],
    faults: list[Fault],
) -> Observed | None:
    before = len(faults)
    parameters, initial = split_values(model, named_values("parameters", experiment.parameters, faults))
    parameters, initial = {**common["parameters"], **parameters}, {**common["initial"], **initial}
    twice = [name for name in free if name in parameters or name in initial]
    faults += [Fault(name, "a value, and it is free", "one of the two") for name in twice]
    table = read_table(experiment.data, map, faults)
    by_impacts = isinstance(table, MeasuredImpacts)
    units = impact_units(model) if by_impacts else units_of(model, None)
    mapped = mapped_columns(table, map, by_impacts)
    sizes = {name: size for name, size in noise.items() if table is None or mapped is None or name in mapped}
    if table is not None and mapped is None:
        sizes = {name: size for name, size in sizes.items() if name in table.columns}
    wrong: list[Fault] = []
    channels = read_channels(units, table, mapped, sizes, wrong) if table is not None else ()
    seconds = _duration(model, table, duration, latest, parameters, wrong)
    faults += [Fault(f"{where}, {f.where}" if where else f.where, f.found, f.expected, f.remedy) for f in wrong]
    faults += model.check({k: v for k, v in parameters.items() if k not in free})[1]
    driven, bad = with_input_values(model, inputs, seconds if math.isfinite(seconds) else 1.0, parameters)
    faults += bad
    if table is None or len(faults) > before:
        return None
    along = table.numbers if isinstance(table, MeasuredImpacts) else table.times
    places = [(k, np.flatnonzero(np.isfinite(channel.samples))) for k, channel in enumerate(channels)]
    at = np.concatenate([along[rows] for _, rows in places])
    begin, end = (0.0 if by_impacts else float(along[0])), float(along[-1])
    return Observed(
        name=experiment.name or Path(table.source).stem or where or "measured data",
        model=driven,
        parameters=parameters,
        initial=initial,
        table=table,
        channels=channels,
        duration=seconds,
        column=np.concatenate([np.full(len(rows), k) for k, rows in places]),
        at=at,
        measured=np.concatenate([channels[k].samples[rows] for k, rows in places]),
        place=(at - begin) / (end - begin),
    )


def read_table(
    data: object, map: Mapping[str, str] | None, faults: list[Fault]
) -> Measurement | MeasuredImpacts | None:
    """Return measured data, read where a file of them is named; None with bad input appended to `faults`."""
    if isinstance(data, Measurement | MeasuredImpacts):
        return data
    if isinstance(data, Histories) or not (
        isinstance(data, str | Path | Mapping | Reading) or hasattr(data, "columns")
    ):
        faults.append(
            Fault("data", shown(data), "a file, a data frame, a Measurement, MeasuredImpacts, or an Experiment")
        )
        return None
    with noted(faults):
        if counts_impacts(data):
            return read_impacts(data, None if map is None else [c for c, h in map.items() if IMPACTS in f".{h}"])
        return read_measurement(data, None if map is None else [c for c, h in map.items() if IMPACTS not in f".{h}"])
    return None


def mapped_columns(table: Columns | None, map: Mapping[str, str] | None, by_impacts: bool) -> dict[str, str] | None:
    """Return the columns of a table beside what they are compared with; None for equal names."""
    if map is not None:
        return {c: h for c, h in map.items() if (IMPACTS in f".{h}") == by_impacts}
    return {name: f"{IMPACTS[1:]}{name}" for name in table.columns} if by_impacts and table is not None else None


def _duration(
    model: EngineModel,
    table: Measurement | MeasuredImpacts | None,
    duration: str | float | None,
    latest: float,
    parameters: Mapping[str, Value],
    faults: list[Fault],
) -> float:
    """Return the duration [s] of the runs that are compared."""
    if duration is not None:
        return read_duration(model, parameters, duration, faults)
    if isinstance(table, Measurement):
        return float(table.times[-1]) + latest
    times = [name for name in (table.columns if table is not None else ()) if table is not None and name == "t"]
    if table is not None and times:
        return LONGER * (float(np.nanmax(table.si("t"))) + latest)
    if table is not None:
        faults.append(Fault("duration", "none, and impacts without times", 'a time that holds them, such as "1.3 s"'))
    return math.nan


# -- numbers of impacts --------------------------------------------------------------------------------------------------

IMPACTS = ".impacts."
OF_IMPACT = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m"}
REBOUND = "rebound."
PER_STEP = 8  # places in a step between which a largest value is sought


def impact_units(model: EngineModel) -> dict[str, str]:
    """Return the SI unit text of what impacts can be compared by, by name."""
    whats = {**OF_IMPACT, **{f"{REBOUND}{name}": unit for name, unit in units_of(model, None).items() if name != "t"}}
    return {
        f"{place}{IMPACTS}{quantity}".removeprefix("."): unit
        for place in ("", *model.pairs)
        for quantity, unit in whats.items()
    }


def parts_of(name: str) -> tuple[str, str]:
    """Return the pair, empty for all contacts, and what of its impacts a name is."""
    pair, _, quantity = f".{name}".partition(IMPACTS)
    return pair.removeprefix("."), quantity


def onsets(run: EngineSolution, name: str) -> Array:
    """Return the onsets [s] of the impacts that a name counts."""
    pair, _ = parts_of(name)
    return np.array([impact.t for impact in run.impacts if pair in ("", impact.contact)])


def of_impacts(run: EngineSolution, name: str, by: Sensitivities | None = None) -> Array:
    """Return one number of each impact (impacts,), or its derivatives (impacts, P) by all names, SI."""
    pair, quantity = parts_of(name)
    chosen = [i for i, impact in enumerate(run.impacts) if not pair or impact.contact == pair]
    if quantity.startswith(REBOUND):
        return _rebounds(run, quantity.removeprefix(REBOUND), [run.impacts[i].t for i in chosen], by)
    if by is not None:
        return np.asarray(by.along_impacts(quantity))[chosen]
    return np.array([getattr(run.impacts[i], quantity) for i in chosen], dtype=float)


def _rebounds(run: EngineSolution, history: str, onsets: list[float], by: Sensitivities | None) -> Array:
    """Return the largest values of a history between onsets [s], or their derivatives by all names.

    A largest value within an interval changes as the history does at its time. The last impact has none: the run may end before.
    """
    from scipy.optimize import minimize_scalar  # slow to import

    largest = np.full(len(onsets) if by is None else (len(onsets), len(by.names)), np.nan)
    steps = with_steps(run).t
    for i, (start, end) in enumerate(pairwise(onsets)):
        nodes = np.unique(np.concatenate([[start, end], steps[(steps > start) & (steps < end)]]))
        parts = np.arange(PER_STEP) / PER_STEP
        times = np.unique(np.concatenate([(nodes[:-1, None] + np.diff(nodes)[:, None] * parts).ravel(), [end]]))
        values = run.at(times)[history]
        top = int(np.argmax(values))
        low, high = times[max(top - 1, 0)], times[min(top + 1, len(times) - 1)]
        best = minimize_scalar(
            lambda t: -float(run.at(np.array([t]))[history][0]),
            bounds=(low, high),
            method="bounded",
            options={"xatol": 1e-9 * (end - start)},
        )
        at, value = (float(best.x), -float(best.fun)) if -best.fun > values[top] else (float(times[top]), values[top])
        if by is None:
            largest[i] = value
        elif at <= by.until:
            largest[i] = by.along(np.array([at]), history)[0]
    return largest
