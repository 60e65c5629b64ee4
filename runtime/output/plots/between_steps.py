"""Histories of a saved run between its steps, by the rates that were saved with them."""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.history import History, acceleration_of

FLIGHT, CONTACT = 0.0, 1.0  # modes of a pair, as they are saved


class BetweenSteps:
    """Histories of a saved run between its steps, by Hermite interpolation; `between[name]` in SI.

    Coordinates by value, rate and second rate (where the rate is a speed whose rate is known), what else has a rate
    by value and rate, and the rest by a monotone cubic. A mode that changes where a step ends may change rates there:
    these are not used.
    """

    def __init__(self, history: History, times: np.ndarray) -> None:
        """Take times [s] within the run, shape (n,)."""
        self._history, self.t, t = history, times, history.t
        self._row = np.clip(np.searchsorted(t, times, side="right") - 1, 0, max(len(t) - 2, 0))
        self._next = np.minimum(self._row + 1, len(t) - 1)
        self._h = t[self._next] - t[self._row]
        self._part = np.clip(
            np.divide(times - t[self._row], self._h, out=np.zeros(len(times)), where=self._h > 0), 0, 1
        )
        self._values: dict[str, np.ndarray] = {"t": times}

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._values:
            self._values[name] = self._between(name)
        return self._values[name]

    def _between(self, name: str) -> np.ndarray:
        history, model = self._history, self._history.model
        pair, _, part = name.rpartition(".")
        if pair in model.pairs:
            mode = history[f"{pair}.mode"][self._row]
            if part == "normal_force":
                return np.where(mode == CONTACT, np.maximum(self._smooth(name), 0), 0)
            if part == "sliding_velocity":
                return np.where(mode == CONTACT, self._smooth(name), 0)
            if part == "penetration":
                return np.where(mode != FLIGHT, np.maximum(-self[f"{pair}.gap"], 0), 0)
            inside = [model.outputs[i] for i in model.journals.get(pair, ())]
            if part == "gap" and inside:  # the clearance, which changes slowly or never, less the eccentricity
                clearance = history[name] + np.sqrt(sum(history[each] ** 2 for each in inside))
                return self._monotone(clearance) - np.sqrt(sum(self[each] ** 2 for each in inside))
        if part == "mode" or name in (*model.latches, *(slip for slip, *_ in model.slips)):
            return history[name][self._row]
        return self._smooth(name)

    def _smooth(self, name: str) -> np.ndarray:
        """Interpolate a history by as many rates as are known."""
        history, model, s, h = self._history, self._history.model, self._part, self._h
        for speed in model.speeds:
            if name == acceleration_of(speed):  # the slope of the speed's cubic
                (u0, u1), (a0, a1) = self._ends(history[speed]), self._ends(history[name])
                mean = np.divide(u1 - u0, h, out=a0.copy(), where=h > 0)
                slope: np.ndarray = a0 + s * (
                    2 * (mean - a0) + np.where(self._changes, 0, (3 * s - 2) * (a0 + a1 - 2 * mean))
                )
                return slope
        values, rates = history[name], history.rates.get(name)
        if rates is None:
            return self._monotone(values)
        (x0, x1), (r0, r1) = self._ends(values), self._ends(rates)
        r0, r1 = (np.where(np.isfinite(r), r * h, x1 - x0) for r in (r0, r1))
        places = {*model.coordinates, *(model.outputs[i] for rows in model.journals.values() for i in rows)}
        if name not in places:  # a quadratic, where the rate at the end is that of another mode
            r1 = np.where(self._changes, 2 * (x1 - x0) - r0, r1)
        cubic: np.ndarray = x0 + s * (r0 + s * (3 * (x1 - x0) - 2 * r0 - r1 + s * (r0 + r1 - 2 * (x1 - x0))))
        second = history.rates.get(_speed_of(model, name))
        if second is None or not np.array_equal(rates, history[_speed_of(model, name)]):
            return cubic
        a0, a1 = (a * h**2 for a in self._ends(second))
        a0 -= 6 * (x1 - x0) - 4 * r0 - 2 * r1  # second rates of the cubic
        a1 -= 2 * r0 + 4 * r1 - 6 * (x1 - x0)
        more = 0.5 * (s * (1 - s)) ** 2 * ((1 - s) * a0 + s * a1)
        return cubic + np.where(self._changes, 0, more)

    def _monotone(self, values: np.ndarray) -> np.ndarray:
        """Interpolate values without rates by cubics that add no extremes."""
        from scipy.interpolate import PchipInterpolator

        t, last = np.unique(self._history.t[::-1], return_index=True)  # of two rows at an event the later
        values = values[len(values) - 1 - last]
        if len(t) < 2 or not np.all(np.isfinite(values)):
            straight: np.ndarray = np.interp(self.t, t, values)
            return straight
        interpolated: np.ndarray = PchipInterpolator(t, values)(self.t)
        return interpolated

    def _ends(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return values[self._row], values[self._next]

    @property
    def _changes(self) -> np.ndarray:
        """Whether a mode changes where the step of a time ends."""
        history, model = self._history, self._history.model
        if not hasattr(self, "_changed"):
            of = [f"{pair}.mode" for pair in model.pairs] + [slip for slip, *_ in model.slips]
            parts = [np.not_equal(*self._ends(history[name])) for name in of]
            self._changed: np.ndarray = np.any(parts, axis=0) if parts else np.zeros(len(self.t), dtype=bool)
        return self._changed


def _speed_of(model: EngineModel, name: str) -> str:
    """Name the speed of a coordinate; empty where it has none of its own."""
    scalar_parts = [each for i, each in enumerate(model.coordinates) if i not in model.quaternions]
    place = scalar_parts.index(name) if name in scalar_parts else len(model.speeds)
    return model.speeds[place] if place < len(model.speeds) else ""
