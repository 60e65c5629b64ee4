"""Sensitivities of a run: first derivatives of its histories and impacts, through every event.

1. directions   changes of parameters and starts, and of the constants           sensitivity/tangent, sensitivity/start_changes
2. steps        the variational equations over each step                         sensitivity/transitions
3. events       the jump where modes change                                      sensitivity/saltation
4. histories    by the chain rule from states, memory and directions             sensitivity/readout

They are found after the run, from its steps: a run that is not asked pays nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.faults import Fault, InputError, unknown
from hertzwerk.runtime.integrate.step.layout import CONTACT, FLIGHT
from hertzwerk.runtime.model.si_values import si_units
from hertzwerk.runtime.sensitivity.readout import Readout
from hertzwerk.runtime.sensitivity.saltation import (
    Instant,
    NoDerivativeError,
    events_of,
    switched,
    watched,
    watched_columns,
)
from hertzwerk.runtime.sensitivity.start_changes import start_changes
from hertzwerk.runtime.sensitivity.tangent import directions_of, tangent
from hertzwerk.runtime.sensitivity.transitions import Transition, transitions
from hertzwerk.runtime.solution.watch import goes_on

if TYPE_CHECKING:
    from hertzwerk.runtime.model.binding import Value
    from hertzwerk.runtime.model.model import Bound
    from hertzwerk.runtime.solution.history import History

BISECTIONS = 60  # of the step in which a force or penetration is largest
PEAKS = {"peak_force": ("force", 1, "normal_force"), "peak_penetration": ("gap", -1, "penetration")}


class Sensitivities:
    """Derivatives of a run with respect to parameters and initial states, in SI.

    history: that of a run whose steps are kept; initial: states that it was given, beside the scene's
    until    time [s] up to which there are derivatives; reason    why not to the end of the run, else empty
    """

    def __init__(self, history: History, bound: Bound, initial: Mapping[str, Value], names: tuple[str, ...]) -> None:
        self.history, self.names = history, names
        model = history.model
        faults = [
            unknown("parameter or initial state", name, _known(history))
            for name in names
            if name not in _known(history)
        ]
        if not names:
            faults.append(
                Fault("names", "none", "parameters or initial states", f"such as {next(iter(_known(history)))!r}")
            )
        if len({pair for *_, pair in model.slips}) < model.ns:
            expected = "friction that is smooth, or set-valued along one tangent"
            faults.append(Fault("friction", "set-valued in two directions, whose slip follows the motion", expected))
        if faults:
            raise InputError(f"sensitivities of {model.name}", faults)
        dp = np.array([[float(parameter == name) for name in names] for parameter in model.parameters])
        self._directions = directions_of(model, bound.p, bound.c, dp.reshape(-1, len(names)))
        parameters = list(model.parameters)
        floors = self._directions.dp[parameters.index("approach_floor")] if "approach_floor" in parameters else 0.0
        self._floor = floors + np.zeros(len(names))
        self.until, self.reason = float(history.t[-1]), ""
        self._instants: dict[int, Instant] = {}  # by the row after the event
        self._follow(start_changes(model, bound, initial, names), frozenset(initial))

    # -- what is read ------------------------------------------------------------------------------------------------

    def __getitem__(self, asked: tuple[str, str]) -> np.ndarray:
        """Derivative of a history with respect to a name, shape (rows,), SI.

        At the run's steps; nan beyond `until`."""
        name, to = asked
        everywhere = np.arange(len(self.history.rows))
        return self._at(everywhere, np.zeros(len(everywhere)), name)[:, self._column(to)]

    def at(self, times: np.ndarray, name: str, to: str) -> np.ndarray:
        """Return the derivative of a history at any times [s] of the run; at an event, that just after it."""
        return self.along(times, name)[:, self._column(to)]

    def along(self, times: np.ndarray, name: str) -> np.ndarray:
        """Return the derivatives (n, P) of a history by all `names`, at times (n,) as `at` has them."""
        t = self.history.t
        index = np.searchsorted(t, times, side="right") - 1
        return self._at(index, times - t[index], name)

    @property
    def events(self) -> tuple[np.ndarray, np.ndarray]:
        """Rows (n,) of the run that follow an event, and the derivatives (n, P) of those events' times."""
        rows = np.array(sorted(self._instants), dtype=int)
        return rows, np.array([self._instants[row].time for row in rows]).reshape(len(rows), len(self.names))

    def after_event(self, row: int, name: str) -> np.ndarray:
        """Return the derivatives (P,) of a history just after the event before a row, whose time changes too."""
        return self._just_after(name, row)

    def unit(self, name: str, to: str) -> str:
        """Return the SI unit text of a derivative, such as "N/(m/s)"."""
        above, below = self.history.units[name], _known(self.history)[to]
        return above if not below else f"{above}/({below})" if set(below) & set("/ ") else f"{above}/{below}"

    def impacts(self, what: str, to: str) -> np.ndarray:
        """Return the derivatives of one number of the impacts, shape (impacts,).

        what    "t", "speed", "peak_force" or "peak_penetration"

        nan for the onset of a contact that the run began with, and beyond `until`.
        """
        column, onsets = self._column(to), []
        for pair, mode in enumerate(self.history.part("mode").T):
            touching = goes_on(mode, False)
            rows = np.flatnonzero(touching & ~np.concatenate([[False], touching[:-1]]))
            onsets += [(int(row), pair) for row in rows]
        of = self._peak if what in PEAKS else self._onset
        return np.array([of(what, row, pair)[column] for row, pair in sorted(onsets)])

    # -- how it is found ---------------------------------------------------------------------------------------------

    def _follow(self, begin: np.ndarray, given: frozenset[str]) -> None:
        """Follow the changes from row to row, through steps and events."""
        history, count, n = self.history, len(self.names), len(self.history.rows)
        model, ny = history.model, history.engine.layouts.state.sizes["y"]
        state, memory = np.zeros((ny, count)), np.zeros((model.nm, count))
        state[: len(begin)] = begin
        self._latch(state, memory, given)
        self._state, self._memory = (np.full((n, *part.shape), np.nan) for part in (state, memory))
        self._state[0], self._memory[0] = state, memory
        self._switched = switched(history)
        jumps = events_of(history, self._switched, self._directions)
        for row, over in enumerate(self._transitions(np.arange(n - 1), np.diff(history.t)), start=1):
            state = over.along(state, memory)
            if row in jumps:
                try:
                    state, memory, self._instants[row] = jumps[row](state, memory, self._floor)
                except NoDerivativeError as error:
                    self.until, self.reason = float(history.t[row]), str(error)
                    return
            self._state[row], self._memory[row] = state, memory

    def _transitions(self, index: np.ndarray, h: np.ndarray) -> Iterator[Transition]:
        return transitions(self.history, index, h, self._switched, self._directions)

    def _latch(self, state: np.ndarray, memory: np.ndarray, given: frozenset[str]) -> None:
        """Set the changes of the approach speeds of pairs that touch at the start."""
        history, places = self.history, watched_columns(self.history.model)["gap_rate"]
        change = tangent(watched, history, history.rows[:1], self._directions).along(state, memory)[0, places]
        floor = history.controls[history.engine.layouts.controls["floor"]][0]
        mode, rates = history.part("mode")[0], history.part("gap_rate")[0]
        for row, (name, _, pair) in enumerate(history.model.module.LATCHES):
            if mode[pair] == CONTACT and name not in given:
                memory[row] = -change[pair] if -rates[pair] > floor else self._floor

    def _at(self, index: np.ndarray, h: np.ndarray, name: str) -> np.ndarray:
        """Return the changes (n, P) of a history a time h (n,) [s] after rows `index` (n,), under their modes."""
        history = self.history
        state, memory, later = self._state[index].copy(), self._memory[index], np.flatnonzero(h)
        for k, over in zip(later, self._transitions(index[later], h[later]), strict=True):
            state[k] = over.along(state[k], memory[k])
        rows = history.later(history.rows[index], h)
        changes: np.ndarray = tangent(Readout(name), history, rows, self._directions).along(state, memory)[:, 0]
        return changes

    def _onset(self, what: str, row: int, pair: int) -> np.ndarray:
        """Return the changes (P,) of the time or the approach speed of the onset before a row."""
        instant = self._instants.get(row)
        if instant is None:
            return np.full(len(self.names), np.nan)
        of_rates = watched_columns(self.history.model)["gap_rate"]
        changes: np.ndarray = instant.time if what == "t" else -instant.then[of_rates][pair]
        return changes

    def _peak(self, what: str, row: int, pair: int) -> np.ndarray:
        """Return the changes (P,) of the largest force or penetration of the contact from a row.

        They are those at its instant: the time of a largest value does not count."""
        history, (part, sign, history_of) = self.history, PEAKS[what]
        name = f"{history.model.pairs[pair]}.{history_of}"
        values, rates = (sign * history.part(kind)[:, pair] for kind in (part, f"{part}_rate"))
        apart = np.flatnonzero(history.part("mode")[row:, pair] == FLIGHT)
        end = row + int(apart[0]) if len(apart) else len(history.rows) - 1
        top = row + int(np.argmax(values[row:end]))
        index = top if rates[top] > 0 else top - 1
        if index < row:  # it is largest at its onset
            return self._just_after(name, row)
        low, high = 0.0, float(history.t[min(index + 1, end)] - history.t[index])
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            there = history.later(history.rows[[index]], np.array([middle]))
            rising = sign * there[0, history.columns(f"{part}_rate")][pair] > 0
            low, high = (middle, high) if rising else (low, middle)
        changes: np.ndarray = self._at(np.array([index]), np.array([low]), name)[0]
        return changes

    def _just_after(self, name: str, row: int) -> np.ndarray:
        """Return the changes (P,) of a history just after the event before a row, whose time changes too."""
        instant = self._instants.get(row)
        if instant is None:
            return np.full(len(self.names), np.nan)
        found = tangent(Readout(name), self.history, self.history.rows[[row]], self._directions)[0]
        rate = found.rate(self.history.part("dy")[row])
        changes: np.ndarray = found.along(self._state[row], self._memory[row])[0] + rate * instant.time
        return changes

    def _column(self, to: str) -> int:
        if to not in self.names:
            raise InputError("sensitivities", [unknown("parameter or initial state", to, self.names)])
        return self.names.index(to)


def _known(history: History) -> dict[str, str]:
    """SI unit text of everything that a derivative can be taken to."""
    model, units = history.model, si_units(history.model)
    return {name: units[name] for name in (*model.parameters, *model.joints.coordinates, *model.joints.speeds)}
