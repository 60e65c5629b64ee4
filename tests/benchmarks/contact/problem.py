"""What a problem states, and what a peer returns: the protocol between `problems/` and `peers/`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from benchmarks.contact.extrapolation import integrate

TOLERANCE = 1e-15  # of the reference; at 1e-13 its solutions shift by less than 1e-15 m


@dataclass(frozen=True)
class Result:
    """States at the sample times (times x coordinates).

    impacts: function that returns the onsets of impacts [s], where the peer reports them; it is called after the time was taken
    seconds: time that the peer measured itself [s], such as a program of its own; None for calls
    """

    states: np.ndarray
    impacts: Callable[[], np.ndarray] | None = None
    seconds: float | None = None


@dataclass(frozen=True, eq=False)
class Problem:
    """Ordinary differential equations with contacts, each of which acts where its gap is negative.

    kind        peers that state bodies in place of equations choose their model by it
    physics     the numbers, in SI, from which such a model is built
    start       state at time 0, coordinates first, then their rates
    grid        times at which solutions are compared [s]
    rates       (t, y, on, m) -> dy/dt; on: 1 or 0 for each contact, then what is latched; m: namespace of sin, cos, sqrt, where ..
    gaps        (t, y, m) -> gaps, one for each contact
    compared    number of coordinates that are compared, the first of the state
    unit        of the error
    longest     step of the reference [s], within which no contact begins and ends
    smallest    size of a state below which the reference's error is absolute, not relative
    weights     factors of the compared coordinates in an error
    latched     (t, y) -> numbers that are kept from the onset of a contact
    opens       (t, y, m) -> functions at whose rise through 0 a contact ends, where these are not the gaps
    digits      () -> states of all coordinates on the grid and onsets, where they are known without integration
    rows        of a sweep, those that are compared, each a problem of its own; all_rows: how many it has
    remark      sentence for the page
    margin      samples of which a gap is smaller are omitted, as an impact is near
    """

    name: str
    title: str
    kind: str
    physics: Any
    start: np.ndarray
    grid: np.ndarray
    rates: Callable[[Any, Any, Any, Any], Any]
    gaps: Callable[[Any, Any, Any], Any]
    contacts: int
    compared: int
    unit: str = "m"
    longest: float = 2e-3
    smallest: float = 1e-3
    margin: float = 0.0
    targets: tuple[float, ...] = (1e-3, 1e-5, 1e-7, 1e-9)
    remark: str = ""
    weights: Any = 1.0
    latched: Callable[[Any, Any], np.ndarray] | None = None
    opens: Callable[[Any, Any, Any], Any] | None = None
    rows: tuple[Problem, ...] = ()
    all_rows: int = 0
    digits: Callable[[], Result] | None = None

    @cached_property
    def reference(self) -> Result:
        """Solution in extended precision at the sample times."""
        (states, impacts), clear = self._solved, self._clear
        return Result(states[clear, : self.compared], lambda: impacts)

    @cached_property
    def times(self) -> np.ndarray:
        """Sample times away from impacts [s]; the end is one of them."""
        return self.grid[self._clear]

    @cached_property
    def memory(self) -> np.ndarray:
        """What `on` has at the start, before any onset: a contact that overlaps is on, and nothing is latched."""
        none = () if self.latched is None else np.zeros_like(self.latched(0.0, self.start))
        return np.array([*(gap < 0 for gap in self.gaps(0.0, self.start, np)), *none], dtype=float)

    def onset(self, on: np.ndarray, contact: int, t: float, y: np.ndarray) -> None:
        """Switch a contact on, in `on`."""
        on[contact] = 1
        if self.latched is not None:
            on[self.contacts :] = self.latched(t, y)

    @cached_property
    def _solved(self) -> tuple[np.ndarray, np.ndarray]:
        if self.digits is not None:
            known = self.digits()
            return known.states, known.impacts() if known.impacts else np.zeros(0)
        return integrate(self, self.grid, TOLERANCE, self.longest)

    @cached_property
    def _clear(self) -> np.ndarray:
        """Whether each time of the grid is a sample."""
        if not self.margin:
            return np.ones(len(self.grid), dtype=bool)
        gaps = [np.abs(self.gaps(t, y, np)).min() for t, y in zip(self.grid, self._solved[0], strict=True)]
        return (np.array(gaps) >= self.margin) | (self.grid == self.grid[-1])

    def errors(self, result: Result, exact: Result | None = None) -> tuple[float, float]:
        """Return the largest error of a coordinate at the sample times, and of the onset of an impact [s].

        The latter is nan where the peer reports no impacts, and infinite where it has another number of them.
        """
        exact = exact or self.reference
        error = float((np.abs(result.states - exact.states) * self.weights).max())
        if result.impacts is None or exact.impacts is None or not self.contacts:
            return error, float("nan")
        found, true = np.sort(result.impacts()), np.sort(exact.impacts())
        if len(found) != len(true):
            return error, float("inf")
        late = np.abs(found - true).astype(float)
        return error, float(late.max(initial=0.0))
