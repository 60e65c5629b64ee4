"""Poincare section of a run: the times at which an angle returns, or a history crosses a value.

"main_bearing.angle = 0"          every return of the drive, modulo 2 pi
"phase = 90 deg"                  of the period of everything that depends on time
"floor.gap = 0 m falling"         every onset of a contact
"hinge.angle = 0.1 rad rising"    an angle, modulo 2 pi

Times of the first two are known before the run, those of crossings are found within its steps.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown, unknown
from hertzwerk.derive.common.units import UnitError
from hertzwerk.runtime.engine.model.binding import read, read_state
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.run.drive_speed import drive_angle, drive_rate
from hertzwerk.runtime.engine.solution.history import units_of

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

PHASE = "phase"
DIRECTIONS = {"rising": (1,), "falling": (-1,), "both": (1, -1)}
EXPECTED = 'NAME = VALUE, such as "main_bearing.angle = 0" or "floor.gap = 0 m falling"'
TURN = 2 * math.pi
LEAST_PARTS, MOST_PARTS, SAMPLES = 4, 32, 4000  # of a step, in which one crossing is seen; wanted in a run
BLOCK = 4096  # steps looked at together
EDGE = 1e-12  # of the time looked at: a crossing this close to its beginning is at it, whatever rounding says
WHOLE = 1e-9  # of a turn: an end this close to a return is one
_WRITTEN = re.compile(r"\s*([^\s=]+)\s*=\s*(.+?)(?:\s+(rising|falling|both))?\s*")


@dataclass(frozen=True)
class Section:
    """Place of a section: the history `name` is at `value` (SI).

    steady    whether that is an angle known before the run
    """

    name: str
    value: float
    unit: str
    direction: str
    steady: bool

    def __str__(self) -> str:
        value = f"{self.value:.17g} {self.unit}".removesuffix(" 1")
        return f"{self.name} = {value}{'' if self.steady else f' {self.direction}'}"

    def returns(self, model: EngineModel, bound: BoundParameters, begin: float, end: float) -> np.ndarray:
        """Return the times [s] after `begin`, up to `end`, of a steady section; raises InputError."""
        rate = self._rate(model, bound)
        turns = (rate * np.array([begin, end]) - self.value) / math.copysign(TURN, rate)
        first, last = math.floor(turns[0] + WHOLE) + 1, math.floor(turns[1] + WHOLE)
        times = (math.copysign(TURN, rate) * np.arange(first, last + 1) + self.value) / rate
        return np.minimum(times, end)

    def _rate(self, model: EngineModel, bound: BoundParameters) -> float:
        """Return the rate [rad/s] of a steady angle; raises InputError where it stands still."""
        period = model.period(bound) if self.name == PHASE else None
        rate = TURN / period if period is not None else drive_rate(model, bound) if self.name != PHASE else None
        if rate is None:
            raise InputError(model.name, [Fault("section", f"{self.name}, which stands still", "an angle that turns")])
        return rate

    def crossings(self, run: EngineSolution, begin: float) -> np.ndarray:
        """Return the times [s] after `begin` of a run with its steps at which the history crosses the value."""
        history, t = run.engine.history, run.t
        first = max(int(np.searchsorted(t, begin, side="right")) - 1, 0)
        parts = int(np.clip(SAMPLES // max(len(t) - 1 - first, 1), LEAST_PARTS, MOST_PARTS))
        crossings = []
        for start in range(first, len(t) - 1, BLOCK):
            rows = np.arange(start, min(start + BLOCK, len(t) - 1))
            h = np.diff(t)[rows, None] * np.arange(parts) / parts
            index, within = np.repeat(rows, parts), h.ravel()
            last = rows[-1] + 1
            values = history.between(np.append(index, last), np.append(within, 0.0))[self.name]
            times = np.append(t[index] + within, t[last])
            crossings.append(self._located(run, times, values))
        times = np.concatenate(crossings) if crossings else np.zeros(0)
        after: np.ndarray = times[times > begin + EDGE * (t[-1] - begin)]
        return after

    def _located(self, run: EngineSolution, times: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the crossings [s] between samples of the history at increasing times."""
        place = (values - self.value) / TURN if self.unit == "rad" else np.where(values >= self.value, 0.5, -0.5)
        level = np.floor(place)
        passed = np.diff(level)
        here = np.flatnonzero(np.isin(np.sign(passed), DIRECTIONS[self.direction]) & np.isfinite(passed))
        many = np.abs(passed[here]).astype(int)
        among = np.arange(int(many.sum())) - np.repeat(np.cumsum(many) - many, many)
        here, many = np.repeat(here, many), np.repeat(many, many)
        if not len(here):
            return np.zeros(0)
        rising = passed[here] > 0
        crossed = np.where(rising, level[here] + 1 + among, level[here] - among)
        target = self.value + TURN * crossed if self.unit == "rad" else np.full(len(here), self.value)
        low, high = times[here].copy(), times[here + 1].copy()
        return _zeros(run, self.name, target, low, high, np.where(rising, -1.0, 1.0))


def _zeros(
    run: EngineSolution, name: str, target: np.ndarray, low: np.ndarray, high: np.ndarray, sign: np.ndarray
) -> np.ndarray:
    """Return the times between `low` and `high` at which a history is at its target, to the last digits.

    sign    of the history less its target at `low`. A jump is at the time after it.
    """
    from scipy.optimize import elementwise  # slow to import

    wide = np.flatnonzero(high > low)
    zeros = high.copy()
    if len(wide):

        def apart(times: np.ndarray, number: np.ndarray) -> np.ndarray:
            which = number.astype(int)
            values: np.ndarray = run.at(times.ravel())[name].reshape(times.shape) - target[which]
            values = np.where(times == low[which], sign[which] * np.maximum(np.abs(values), 5e-324), values)
            return np.where(times == high[which], -sign[which] * np.abs(values), values)

        solved = elementwise.find_root(
            apart,
            (low[wide], high[wide]),
            args=(wide.astype(float),),
            tolerances={"xatol": 0.0, "xrtol": 4e-16, "fatol": 0.0, "frtol": 0.0},
        )
        zeros[wide] = np.where(np.isfinite(solved.x), solved.x, high[wide])
    return zeros


def read_section(model: EngineModel, text: object, faults: list[Fault]) -> Section | None:
    """Read the text of a section; bad input is appended to `faults`."""
    written = _WRITTEN.fullmatch(text) if isinstance(text, str) else None
    if written is None:
        faults.append(Fault("section", shown(text), EXPECTED))
        return None
    name, value, direction = written.groups()
    steady, units = dict(_steady(model)), units_of(model, None)
    before = len(faults)
    unit = steady.get(name) or units.get(name)
    if unit is None or name == "t":
        known = [*steady, *(other for other in units if other != "t")]
        faults.append(unknown("history or angle of a drive", name, known))
    if name in steady and direction is not None:
        faults.append(Fault("section", f"{name} {direction}", f"{name} alone", "it turns one way"))
    si = _value(name, unit, value, faults)
    if len(faults) > before or unit is None:
        return None
    return Section(name, si, unit, direction or "rising", name in steady)


def _steady(model: EngineModel) -> Iterator[tuple[str, str]]:
    """Yield the angles that are known before a run, with their unit."""
    driven = drive_angle(model)
    if driven is not None:
        yield driven, "rad"
    if hasattr(model.module, "period"):
        yield PHASE, "rad"


def _value(name: str, unit: str | None, text: str, faults: list[Fault]) -> float:
    """Return the value of a name in SI, of no unit where it is 0; bad input is appended to `faults`."""
    try:
        number, _, stated = read(text)
    except UnitError as error:
        faults.append(Fault("section", f"{name} = {text}", EXPECTED, str(error)))
        return math.nan
    if unit is None or (number == 0 and stated == "1"):
        return 0.0
    si, fault = read_state(f"section, {name}", unit, text)
    if fault is not None:
        faults.append(fault)
    return si
