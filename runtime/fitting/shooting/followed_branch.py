"""Profiles of segments: least squares with a quantity held, followed from the least along one branch.

Within a step the squares rise as their slopes at its ends say; else it led onto another branch, and is halved.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.fitting.search import Found, Search
from hertzwerk.runtime.fitting.shooting.solver import CONVERGED, MET, Place, Solver

Array = NDArray[np.float64]

SMOOTH, HALVINGS = 0.5, 64  # rise of squares that slopes do not say, for which a step is halved, and its least part


@dataclass(frozen=True)
class Held:
    """Least squares with an entry of x held: where, what is there, and their derivative by it."""

    place: Place
    found: Found
    slope: float


class SegmentSearch(Search):
    """Search at the least squares of all segments, which least squares with a quantity held begin from."""

    followed_only = True

    def __init__(self, solver: Solver, stated: Array) -> None:
        super().__init__(solver.forward, stated)
        self._solver, self._known = solver, dict[int, dict[float, Held]]()

    def begin(self) -> None:
        """Take the place of the solver as the least, and refuse intervals where it does not meet all data."""
        solver = self._solver
        self._known = {j: {float(x): self._here(j)} for j, x in enumerate(solver.x)}
        if not solver.worth(MET)[0]:
            self.refused = (
                "the segments that were found do not meet all data: other lengths of them, or a shorter record"
            )

    def least(
        self, x: Array, used: NDArray[np.bool_], sigma: Array, *, fixed: int | None = None, within: float = CONVERGED
    ) -> Found:
        """Return the least squares with one entry of x held, followed from the nearest place where it was."""
        if fixed is None:
            raise ValueError("segments are fitted by their solver")
        solver, before = self._solver, self._solver.place
        try:
            return self._followed(fixed, float(x[fixed]))
        finally:
            solver.place, solver.converged = before, True

    def _followed(self, j: int, to: float) -> Found:
        """Walk to a place of one entry of x, all else fitted anew, and return what is found there.

        Within a step the squares rise as their slopes at its ends say: else it was onto another branch, and is halved.
        """
        solver, known = self._solver, self._known[j]
        at = min(known, key=lambda other: abs(other - to))
        step = to - at
        finest = abs(step) / HALVINGS
        while at != to:
            there = to if abs(step) >= abs(to - at) * (1 - 1e-9) else at + step
            here = known[at]
            solver.place = here.place
            solver.hold(j, there)
            after = self._here(j)
            jump = after.found.cost - here.found.cost - (there - at) * (here.slope + after.slope) / 2
            if (not solver.converged or abs(jump) > SMOOTH) and abs(step) > finest:
                step /= 2
                continue
            if not solver.converged:
                return after.found
            known[there], at = after, there
            step *= 2
        return known[at].found

    def _here(self, j: int) -> Held:
        return Held(self._solver.place, self._solver.found(), self._solver.slope(j))
