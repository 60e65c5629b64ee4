"""Quantities that are fitted: their ranges, and the scale on which they are searched."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import Fault, shown, unknown
from hertzwerk.derive.units import UnitError
from hertzwerk.runtime.model.binding import Value, read, read_state
from hertzwerk.runtime.model.si_values import si_of, si_units
from hertzwerk.runtime.sweeps.design import Range, read_range

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model

Array = NDArray[np.float64]
Freed = str | tuple[Value, Value] | None  # "0.3..1", "1e6..1e9 N/m log", "log", (0.3, 1); None: the law's range

DECADES = 100.0  # ratio of a range's ends from which it is searched by ratios
WIDE = 100.0  # a positive quantity without a range is searched within this factor of the model's value
INSIDE = 1e-9  # part of a range by which an end stays off a value that a law does not have
EXPECTED = 'a range such as "0.3..1" or "1e6..1e9 N/m log", "log", or None for the range of its law'


@dataclass(frozen=True)
class Free:
    """Quantity that is fitted, in SI, between low and high; log: searched by ratios."""

    name: str
    unit: str
    low: float
    high: float
    log: bool
    value: float = math.nan

    @property
    def scale(self) -> float:
        """Value of one unit on the scale of the search: half the range, or a factor of e."""
        return 1.0 if self.log else (self.high - self.low) / 2

    def inner(self, value: float) -> float:
        """Return a value [SI] on the scale of the search."""
        return math.log(value) if self.log else value / self.scale

    def outer(self, x: float) -> float:
        """Return the value [SI] of a place on the scale of the search."""
        found = math.exp(x) if self.log else x * self.scale
        return min(max(found, self.low), self.high)

    def slope(self, value: float) -> float:
        """Return the change [SI] with the place on the scale, at a value."""
        return value if self.log else self.scale

    @property
    def bounds(self) -> tuple[float, float]:
        """Ends on the scale of the search."""
        return self.inner(self.low), self.inner(self.high)

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"{self.low:.6g}..{self.high:.6g}{unit}{' log' if self.log else ''}"


def read_free(model: Model, given: object, faults: list[Fault]) -> tuple[Free, ...]:
    """Read what is fitted, by name, or names alone; bad input is appended to `faults`."""
    if isinstance(given, Sequence) and not isinstance(given, str) and all(isinstance(name, str) for name in given):
        given = dict.fromkeys(given)
    if not isinstance(given, Mapping) or not given:
        faults.append(
            Fault("free", shown(given), 'ranges by name, such as {"restitution": (0.3, 1), "stiffness": "log"}')
        )
        return ()
    known = (*model.parameters, *model.joints.coordinates, *model.joints.speeds)
    found = []
    for name, text in given.items():
        if name not in known:
            faults.append(unknown("parameter or initial state", name, known))
            continue
        before = len(faults)
        one = _one(model, name, text, faults)
        if len(faults) == before and one is not None:
            found.append(one)
    return tuple(found)


def _one(model: Model, name: str, given: object, faults: list[Fault]) -> Free | None:
    unit = si_units(model)[name] or "1"
    where = f"free[{name!r}]"
    port = model.parameters.get(name)
    value = si_of(model, name, (port.default, port.unit)) if port is not None else math.nan
    asked_log = given == "log"
    if given is None or asked_log:
        low, high = _ranges_of_law(model, name)
        bounded = math.isfinite(low) and math.isfinite(high)
        if not bounded or (asked_log and low <= 0):
            if not value > 0:
                faults.append(
                    Fault(where, "no range", 'a range, such as "-1..1 mm"', "neither its law nor its value gives one")
                )
                return None
            low, high = max(low, value / WIDE), min(high, value * WIDE)
            asked_log = True
    else:
        ends = _ends(where, given, faults)
        if ends is None:
            return None
        texts, asked_log = ends
        faults += [fault for text in texts for fault in _end_faults(model, name, text)]
        low, high = (si_of(model, name, text) for text in texts)
    low, high = _off_open_ends(model, name, low, high)
    if not low < high:
        faults.append(Fault(where, f"{low:g}..{high:g} {unit}", "the smaller end first, within the range of its law"))
        return None
    if asked_log and low <= 0:
        faults.append(Fault(where, shown(given), "ends above zero, as the values have equal ratios"))
        return None
    return Free(name, unit, low, high, asked_log or (low > 0 and high / low >= DECADES), value)


def _ends(where: str, given: object, faults: list[Fault]) -> tuple[tuple[Value, Value], bool] | None:
    """Return both ends of a range with their units, and whether it is logarithmic."""
    if isinstance(given, str):
        found = read_range(where, given.replace("−", "-"), True, faults) if ".." in given else None
        if isinstance(found, Range):
            return ((float(found.low), found.unit), (float(found.high), found.unit)), found.log
        if ".." in given:
            return None
    if isinstance(given, tuple) and len(given) == 2:
        try:
            for end in given:
                read(end)
        except UnitError as error:
            faults.append(Fault(where, shown(given), EXPECTED, str(error)))
            return None
        return given, False
    faults.append(Fault(where, shown(given), EXPECTED))
    return None


def _end_faults(model: Model, name: str, value: Value) -> list[Fault]:
    """Return the faults of an end of a range; one at an open end of the law's is none."""
    if name not in model.parameters:
        return [fault for _, fault in [read_state(name, model.joints.units[name], value)] if fault is not None]
    _, faults = model.check({name: value})
    si = si_of(model, name, value)
    open_ends = {
        end for row in _limits(model, name) for end, is_open in zip(row[2:4], row[4:6], strict=True) if is_open
    }
    return [] if si in open_ends else [fault for fault in faults if fault.where == name or math.isfinite(si)]


def _limits(model: Model, name: str) -> list[tuple[str, str, float | None, float | None, bool, bool, str]]:
    return [row for row in model.module.LIMITS if row[0] == name and row[1] == "defined"]


def _ranges_of_law(model: Model, name: str) -> tuple[float, float]:
    """Return the range [SI] in which all laws of a parameter are defined; infinite where they say nothing."""
    rows = _limits(model, name)
    low = max((row[2] for row in rows if row[2] is not None), default=-math.inf)
    high = min((row[3] for row in rows if row[3] is not None), default=math.inf)
    return low, high


def _off_open_ends(model: Model, name: str, low: float, high: float) -> tuple[float, float]:
    step = INSIDE * (high - low)
    for _, _, lower, upper, lower_open, upper_open, _ in _limits(model, name):
        low = low + step if lower_open and low == lower else low
        high = high - step if upper_open and high == upper else high
    return low, high
