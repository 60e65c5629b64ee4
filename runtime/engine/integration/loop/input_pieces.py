"""Inputs in the loop of a run: steps end where a piece does, and the next is put into the state."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.model.caller import Callers

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
    from hertzwerk.runtime.engine.model.signal import Schedule


class Pieces:
    """Pieces of the inputs of one run, which states are given one after another."""

    def __init__(self, integrator: Integrator, schedule: Schedule, controls: np.ndarray) -> None:
        layouts = integrator.layouts
        self._enter, self._schedule, self._controls = Callers(integrator.enter), schedule, controls
        self._t, self._h, self._stop = (layouts.state[name].start for name in ("t", "h", "stop"))
        self._pieces = layouts.state["pieces"]
        self._t_end = float(controls[layouts.controls["t_end"].start])

    def ended(self, state: np.ndarray) -> bool:
        """Return whether the run goes on after a state that is where its pieces end."""
        return bool(state[self._t] < self._t_end)

    def with_pieces(self, state: np.ndarray) -> np.ndarray:
        """Return a state with the pieces that hold from its time on, and when they end."""
        place = self._schedule.place(float(state[self._t]))
        state, before = state.copy(), state[self._pieces]
        state[self._pieces] = self._schedule.pieces[place]
        state[self._stop] = stop = self._schedule.stop(place, self._t_end)
        if np.array_equal(before, state[self._pieces]) and state[self._h] > 0:
            state[self._h] = min(state[self._h], stop - state[self._t])
            return state
        return self._enter(state, self._controls)[0]
