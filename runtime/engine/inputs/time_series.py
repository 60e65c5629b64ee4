"""Samples: values of an input at times, and what holds between them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.units import Unit, UnitError, parse_unit
from hertzwerk.runtime.engine.model.signal import DEGREE, Signal

BETWEEN = ("linear", "held", "cubic")


@dataclass(frozen=True, eq=False)
class Samples:
    """Values of an input at increasing times, in `units` of a time and of a value.

    between    "linear": straight from sample to sample; "held": each value holds until the next sample, where it jumps, the last one for as
               long as the one before; "cubic": the spline through them with two continuous derivatives (not-a-knot)
    source     where they are from, for people
    """

    times: Any
    values: Any
    units: tuple[str, str]
    between: Literal["linear", "held", "cubic"] = "linear"
    source: str = ""

    def signal(self) -> Signal:
        """Return the signal of samples without faults."""
        t, v = (
            np.array([unit.to_si(float(x)) for x in part]) for unit, part in zip(self._units, self._arrays, strict=True)
        )
        text = f"{self.source or 'samples'}: {len(t)} values, {self.between}"
        if self.between == "held":
            changes = np.concatenate([[True], v[1:] != v[:-1]])  # one that stays ends no step
            begins, coefficients, end = t[changes], _raised(v[changes, None]), t[-1] + (t[-1] - t[-2])
            smooth = -1
        elif self.between == "linear" or len(t) < 3:
            begins, coefficients, end = t[:-1], _raised(np.column_stack([v[:-1], np.diff(v) / np.diff(t)])), t[-1]
            smooth = 0
        else:
            from scipy.interpolate import CubicSpline

            begins, coefficients, end = t[:-1], _raised(CubicSpline(t, v).c[::-1].T), t[-1]
            smooth = 2
        return Signal(begins, coefficients, float(end), text, smooth if len(begins) > 1 else DEGREE)

    @property
    def _arrays(self) -> tuple[np.ndarray, np.ndarray]:
        return np.asarray(self.times, dtype=float), np.asarray(self.values, dtype=float)

    @property
    def _units(self) -> tuple[Unit, Unit]:
        time, value = map(parse_unit, self.units)
        return time, value

    def faults(self, where: str) -> Iterator[Fault]:
        """Yield the faults of the samples; their reader checks the unit."""
        if self.between not in BETWEEN:
            yield Fault(where, f"between {shown(self.between)}", f"one of {', '.join(BETWEEN)}")
        if not isinstance(self.units, tuple | list) or len(self.units) != 2:
            yield Fault(where, f"units {shown(self.units)}", 'two, of a time and of a value, such as ("ms", "N m")')
        for unit in self.units if isinstance(self.units, tuple | list) else ():
            try:
                parse_unit(unit)
            except UnitError as error:
                yield Fault(where, f"unit {shown(unit)}", "a unit", str(error))
        try:
            t, v = self._arrays
        except (TypeError, ValueError):
            yield Fault(where, f"{shown(self.times)} and {shown(self.values)}", "an array of times and one of values")
            return
        if t.ndim != 1 or t.shape != v.shape or t.size < 2:
            yield Fault(
                where, f"times of shape {t.shape} and values of shape {v.shape}", "as many values as times, two or more"
            )
            return
        for kind, array in (("time", t), ("value", v)):
            strange = np.flatnonzero(~np.isfinite(array))
            if strange.size:
                actual = f"the {kind} {array[strange[0]]} in place {strange[0] + 1}"
                yield Fault(where, actual, "finite numbers", "omit missing samples")
                return
        falls = np.flatnonzero(np.diff(t) <= 0)
        if falls.size:
            k = int(falls[0])
            actual = f"the time {t[k + 1]:g} after {t[k]:g} in place {k + 2}, and {falls.size - 1} more like it"
            yield Fault(
                where, actual, "times that increase", "sort the samples by time; omit one of two at the same time"
            )


def _raised(coefficients: np.ndarray) -> np.ndarray:
    """Return coefficients (n, few) as those of the degree of all pieces, (n, 6)."""
    whole = np.zeros((len(coefficients), DEGREE + 1))
    whole[:, : coefficients.shape[1]] = coefficients
    return whole
