"""Dense histories of a run for pictures: within every step, and through the peak of every impact."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from hertzwerk.runtime.solution.history import History
    from hertzwerk.runtime.solution.impacts import Impact
    from hertzwerk.runtime.solution.solution import Solution

Array = NDArray[np.float64]

SAMPLES = 2000  # of the whole run, equally spaced
WITHIN_STEPS = 6000  # further ones, equally many in each step...
MOST, MANY = 24, 20_000  # ... at most so many; of more steps than this some are left out, none with a largest force
NEAR_PEAK = 16  # between the samples beside the largest
TOLD_APART = 1000  # parts of a run in which a picture shows one impact of each pair


def dense(run: Solution) -> History:
    """Return histories of a run with its steps, fine enough for a smooth picture with every peak."""
    found = run.at(_times(run))
    peaks = np.setdiff1d(np.concatenate([np.zeros(0), *_near_peaks(run, found)]), found.t)
    rows = np.concatenate([found.rows, run.at(peaks).rows]) if len(peaks) else found.rows
    return found.of(rows[np.argsort(rows[:, found.columns("t").start], kind="stable")])


def hardest(run: Solution) -> list[Impact]:
    """Return the hardest impact of each pair in every part of a run that a picture can tell from the next."""
    part = max(run.t_end - run.t_start, 1e-300) / TOLD_APART
    found: dict[tuple[str, int], Impact] = {}
    for impact in run.impacts:
        key = impact.contact, int((impact.t - run.t_start) / part)
        if key not in found or impact.peak_force > found[key].peak_force:
            found[key] = impact
    return list(found.values())


def end_of(impact: Impact, run: Solution) -> float:
    """Return the time [s] at which a contact ends, or the run does before."""
    last = float(run.t[-1])
    return last if impact.duration is None else min(impact.t + impact.duration, last)


def _times(run: Solution) -> Array:
    t = run.t
    if len(t) > MANY:
        t = t[_thinned(run.history, run.model.pairs)]
    parts = int(np.clip(WITHIN_STEPS // max(len(t) - 1, 1), 1, MOST))
    within = t[:-1, None] + np.diff(t)[:, None] * (np.arange(parts) / parts)
    return np.unique(np.concatenate([within.ravel(), t[-1:], np.linspace(t[0], t[-1], SAMPLES)]))


def _thinned(history: History, pairs: Sequence[str]) -> NDArray[np.intp]:
    """Return some rows of many: of every stretch the first, and those with the largest force of a pair."""
    size = -(-len(history.t) // SAMPLES)
    starts = np.arange(0, len(history.t), size)
    kept = [starts, np.array([len(history.t) - 1])]
    if pairs:
        forces = history.part("force")
        kept += [begin + np.argmax(forces[begin : begin + size], axis=0) for begin in starts]
    return np.unique(np.concatenate(kept))


def _near_peaks(run: Solution, found: History) -> Iterator[Array]:
    """Yield times between the samples, and the steps, beside the largest sampled force of an impact."""
    t, steps, last = found.t, run.t, len(run.t) - 1
    for impact in hardest(run):
        force = found[f"{impact.contact}.normal_force"]
        begin, stop = np.searchsorted(t, impact.t), np.searchsorted(t, end_of(impact, run), side="right")
        if stop - begin < 1:
            continue
        top = int(begin) + int(np.argmax(force[begin:stop]))
        step = int(np.searchsorted(steps, t[top], side="right")) - 1
        low = max(t[max(top - 1, 0)], steps[max(step - 1, 0)])
        high = min(t[min(top + 1, len(t) - 1)], steps[min(step + 2, last)])
        yield np.linspace(low, high, NEAR_PEAK + 2)[1:-1]


class Rows:
    """Histories of a run of which only rows are known, with onset, peak and end of each contact."""

    def __init__(self, run: Solution) -> None:
        self._run = run
        within = [impact for impact in hardest(run) if impact.t <= run.t[-1]]  # rows may end sooner than the run
        inside = [np.searchsorted(run.t, (impact.t, end_of(impact, run))) for impact in within]
        self._seen = [(impact, *place) for impact, place in zip(within, inside, strict=True)]
        unseen = [(i.t, _middle(i, run), end_of(i, run)) for i, begin, stop in self._seen if begin == stop]
        self.t: Array = np.unique(np.concatenate([run.t, np.ravel(unseen)]))

    def __getitem__(self, name: str) -> Array:
        """Return a history, with the true peaks of its pair where it is one of contact."""
        values: Array = np.interp(self.t, self._run.t, self._run[name])
        pair, _, part = name.rpartition(".")
        if part not in ("normal_force", "penetration"):
            return values
        for impact, begin, stop in self._seen:
            if impact.contact != pair:
                continue
            peak = impact.peak_force if part == "normal_force" else impact.peak_penetration
            ends = np.searchsorted(self.t, (impact.t, end_of(impact, self._run)))
            if begin == stop:
                values[ends] = 0.0
                top = int(np.searchsorted(self.t, _middle(impact, self._run)))
            else:
                top = ends[0] + int(np.argmax(values[ends[0] : ends[1] + 1]))
            values[top] = max(values[top], peak)
        return values


def _middle(impact: Impact, run: Solution) -> float:
    return (impact.t + end_of(impact, run)) / 2
