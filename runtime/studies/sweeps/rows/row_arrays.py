"""Arrays that rows of a sweep keep: histories at a section and on a grid, after a transient."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, refuse, shown, unknown
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.output_times import Grid, times_of
from hertzwerk.runtime.engine.run.run_request import read_duration
from hertzwerk.runtime.engine.solution.history import History, units_of
from hertzwerk.runtime.engine.solution.step_observers import Needs
from hertzwerk.runtime.studies.sweeps.rows.poincare_section import Section, read_section
from hertzwerk.runtime.studies.sweeps.rows.row import Packed

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

SECTION, HISTORIES, END = "section", "histories", "end"
WHOLE = 1e-9  # relative: a number of periods this close to a whole one counts as whole


@dataclass(frozen=True)
class Times:
    """Times [s] of one row that are known before it: `section` is None where its points are crossings."""

    row_arrays: RowArrays
    begin: float
    section: np.ndarray | None
    grid: np.ndarray | None

    @property
    def all(self) -> np.ndarray:
        """Every time, increasing."""
        known = [times for times in (self.section, self.grid) if times is not None]
        return np.unique(np.concatenate([np.zeros(0), *known]))

    def arrays(self, run: EngineSolution) -> dict[str, Packed]:
        """Return the arrays of a run, of a shorter one as far as it got."""
        return self.row_arrays.of(run, self)


@dataclass(frozen=True)
class RowArrays:
    """Arrays of a row: histories at the points of a section and on a grid, both after a transient.

    units    unit text of the histories by name
    duration    of the runs, as `simulate` takes it
    end    names of the final state that is kept for the row that continues from it
    """

    units: Mapping[str, str]
    section: Section | None
    grid: Grid
    after: str | float | None
    duration: str | float | None
    end: tuple[str, ...] = ()

    @property
    def columns(self) -> dict[str, dict[str, str]]:
        """Unit text of every array by what it is of and name, the time first."""
        names = {SECTION: self.section, HISTORIES: self.grid}
        return {name: {"t": "s", **self.units} for name, wanted in names.items() if wanted is not None}

    @property
    def read(self) -> list[str]:
        """Names of the histories that they are made of."""
        crossed = [] if self.section is None or self.section.steady else [self.section.name]
        return [*self.units, *crossed]

    @property
    def needs(self) -> Needs:
        """Parts of a run that they are computed from, beside its states at times that are known before."""
        return Needs.ENDS if self.section is None or self.section.steady else Needs.STEPS

    def times(self, model: EngineModel, parameters: Mapping[str, Value]) -> Times:
        """Return the times of a row; raises InputError with every fault."""
        faults: list[Fault] = []
        seconds = read_duration(model, parameters, self.duration, faults)
        begin = 0.0
        if self.after is not None:
            wrong: list[Fault] = []
            begin = read_duration(model, parameters, self.after, wrong)
            faults += [replace(fault, where="after") for fault in wrong]
            if begin >= seconds:
                faults.append(Fault("after", shown(self.after), f"less than the duration, {seconds:g} s"))
        grid = None
        if self.grid is not None and not faults:
            wrong = []
            grid = times_of(self.grid, seconds, wrong)
            faults += [replace(fault, where="grid") for fault in wrong]
        bound = model.check(parameters)[0]
        period = None if bound is None or not self.end else model.period(bound)
        if period is not None and abs(seconds / period - round(seconds / period)) > WHOLE * seconds / period:
            expected = "a whole number of periods, as each value starts where the one before ended"
            faults.append(Fault("duration", f"{seconds / period:.9g} periods of what depends on time", expected))
        refuse(model.name, faults)
        section = None
        if self.section is not None and self.section.steady and bound is not None:
            section = self.section.returns(model, bound, begin, seconds)
        return Times(self, begin, section, None if grid is None else grid[grid >= begin])

    def of(self, run: EngineSolution, times: Times) -> dict[str, Packed]:
        """Return the arrays of a run with these times; see `Times.arrays`."""
        arrays = {}
        if self.section is not None:
            at = self.section.crossings(run, times.begin) if times.section is None else times.section
            arrays[SECTION] = self._packed(run, at)
        if times.grid is not None:
            arrays[HISTORIES] = self._packed(run, times.grid)
        end = np.array([run.engine.ends[name][-1] for name in self.end])
        if self.end and run.engine.t_end >= run.settings.duration and np.isfinite(end).all():
            arrays[END] = Packed.of(end)
        return arrays

    def _packed(self, run: EngineSolution, times: np.ndarray) -> Packed:
        reached = times[times <= run.engine.t_end]
        if not len(reached):
            return Packed.of(np.zeros((0, 1 + len(self.units))))
        history: History = run.at(reached)
        return Packed.of(np.column_stack([history[name] for name in ("t", *self.units)]))


def place_of(section: object, grid: object, after: object) -> str:
    """Return the phrase that says where arrays are kept."""
    places = [f"section at {_in_degrees(str(section))}"] if section is not None else []
    places += [f"histories on a grid of {grid}"] if grid is not None else []
    late = [f"after {after if isinstance(after, str) else f'{after:g} s'}"] if places and after is not None else []
    return re.sub(r"\d+\.\d{6,}", lambda number: f"{float(number[0]):.6g}", " ".join([" and ".join(places), *late]))


def _in_degrees(section: str) -> str:
    """Return the text of a section with its angle as people give angles."""
    return re.sub(r"(\S+) rad\b", lambda angle: f"{math.degrees(float(angle[1])):.6g} deg", section)


def read_row_arrays(
    model: EngineModel,
    *,
    section: object,
    histories: object,
    grid: object,
    after: object,
    duration: str | float | None,
    end: tuple[str, ...] = (),
    faults: list[Fault],
) -> RowArrays | None:
    """Read what each row keeps; bad input is appended to `faults`. None where nothing is requested."""
    if section is None and grid is None:
        for name, value in (("histories", histories), ("after", after)):
            if value is not None and not (isinstance(value, list | tuple) and not value):
                faults.append(
                    Fault(name, shown(value), "none without a section or a grid", "state a section or a grid")
                )
        return RowArrays({}, None, None, None, duration, end) if end else None
    place = None if section is None else read_section(model, section, faults)
    units = _units(model, histories, faults)
    if after is not None and (isinstance(after, bool) or not isinstance(after, str | int | float)):
        faults.append(Fault("after", shown(after), 'a time or revolutions, such as "100 rev"'))
        after = None
    return RowArrays(units, place, grid, after, duration, end)  # type: ignore[arg-type]


def _units(model: EngineModel, names: object, faults: list[Fault]) -> dict[str, str]:
    """Return the units of the histories that are kept, by default of coordinates and speeds."""
    if isinstance(names, str) or not isinstance(names, Sequence):
        faults.append(Fault("histories", shown(names), 'a list of names, such as ["guide.travel", "guide.speed"]'))
        return {}
    there = units_of(model, None)
    wanted = list(dict.fromkeys(names)) or [*model.coordinates, *model.speeds]
    faults += [unknown("history", name, there) for name in wanted if not isinstance(name, str) or name not in there]
    faults += [Fault("histories", f"{name} twice", "each once") for name in wanted if names.count(name) > 1]
    return {name: "" if there[name] == "1" else there[name] for name in wanted if name in there and name != "t"}
