"""Samples of a run for pictures: as dense as a picture resolves, through the peak of every impact."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.output.plots.between_steps import BetweenSteps
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.impacts import Impact
    from hertzwerk.runtime.engine.solution.solution import EngineSolution


RESOLVED = 1e-3  # of a curve's range: what a picture resolves
FINER = 16.0  # times finer are chords within steps: of those that miss a curve by half a pixel the corners show
EVEN = 2000  # samples equally spaced
FEWEST, MOST = 500, 10_000  # rows to begin with, and at most
PARTS = 40  # most between two of them
NEAR_PEAK = 16  # between the samples beside the largest
IMPACT_BINS = 1000  # parts of a run in which a picture shows one impact of each pair


def has_steps(run: EngineSolution) -> bool:
    """Return whether a run is known between its rows, which are its steps."""
    return run.engine.history.steps or bool(run.engine.history.rates)


def between(run: EngineSolution, times: Array) -> History | BetweenSteps:
    """Return histories of a run between its steps, at times [s]: by its method, or a saved run by Hermite."""
    return run.at(times) if run.engine.history.integrator is not None else BetweenSteps(run.engine.history, times)


def dense(run: EngineSolution) -> History | BetweenSteps:
    """Return histories of a run with its steps, fine enough for smooth pictures with every peak."""
    steps = _Steps(run)
    times = np.unique(np.concatenate([*steps.resolved(), np.linspace(run.t[0], run.t[-1], EVEN)]))
    peaks = np.concatenate([times, *_near_peaks(run, between(run, times))])
    return between(run, np.unique(peaks))


def hardest(run: EngineSolution) -> list[Impact]:
    """Return the hardest impact of each pair in every part of a run that a picture resolves."""
    part = max(run.engine.t_end - run.engine.t_start, 1e-300) / IMPACT_BINS
    by_pair: dict[tuple[str, int], Impact] = {}
    for impact in run.impacts:
        key = impact.contact, int((impact.t - run.engine.t_start) / part)
        if key not in by_pair or impact.peak_force > by_pair[key].peak_force:
            by_pair[key] = impact
    return list(by_pair.values())


def end_of(impact: Impact, run: EngineSolution) -> float:
    """Return the time [s] at which a contact ends, or the run does before."""
    last = float(run.t[-1])
    return last if impact.duration is None else min(impact.t + impact.duration, last)


class _Steps:
    """Steps of a run and the curves that pictures show of them, in parts of what a picture resolves."""

    def __init__(self, run: EngineSolution) -> None:
        model = run.engine.model
        names = (*model.coordinates, *model.speeds, *model.outputs, *(f"{pair}.normal_force" for pair in model.pairs))
        self._run, self._t = run, run.t
        sizes = {name: float(np.ptp(values)) for name in names if np.isfinite(values := run[name]).all()}
        self._sizes = {name: size * RESOLVED for name, size in sizes.items() if size > 0}

    def resolved(self) -> Iterator[Array]:
        """Yield times of rows, and within steps, between which every curve is straight to the eye."""
        rows, level = self._rows()
        t = self._t[rows]
        yield t
        parts = np.clip(np.ceil(np.sqrt(FINER * self._bent(rows) / level)), 1, PARTS)
        for count in np.unique(parts):
            here = np.flatnonzero(parts == count)
            yield (t[here][:, None] + np.outer(t[here + 1] - t[here], np.arange(1, count) / count)).ravel()

    def _rows(self) -> tuple[NDArray[np.intp], float]:
        """Return rows between which straight lines miss others by at most a level (Douglas and Peucker).

        That is 1 but for more than MOST rows.
        """
        last, level = len(self._t) - 1, 64.0
        rows = np.unique([*np.linspace(0, last, FEWEST).round().astype(int), *_hardest_rows(self._run)])
        while len(rows) < MOST:
            off = np.zeros(last + 1)
            for name, size in self._sizes.items():
                values = self._run[name]
                np.maximum(off, np.abs(values - np.interp(self._t, self._t[rows], values[rows])) / size, out=off)
            off[rows] = 0
            wide = np.maximum.reduceat(off, rows[:-1]) > level
            more = [i + int(np.argmax(off[i:j])) for i, j in zip(rows[:-1][wide], rows[1:][wide], strict=True)]
            if not more and level <= 1:
                break
            level = level if more else level / 2
            rows = np.union1d(rows, more).astype(int)
        return rows, level

    def _bent(self, rows: NDArray[np.intp]) -> Array:
        """Return the largest deviation of a curve from each chord, at thirds of its time."""
        t, off = self._t[rows], np.zeros(len(rows) - 1)
        for third in (1 / 3, 2 / 3):
            inside = between(self._run, t[:-1] + third * np.diff(t))
            for name, size in self._sizes.items():
                values = self._run[name][rows]
                np.fmax(off, np.abs(inside[name] - values[:-1] - third * np.diff(values)) / size, out=off)
        return off


def _hardest_rows(run: EngineSolution) -> Iterator[int]:
    """Yield the row with the largest force of each of the hardest impacts."""
    for impact in hardest(run):
        begin, stop = np.searchsorted(run.t, (impact.t, end_of(impact, run)))
        if stop > begin:
            yield int(begin) + int(np.argmax(run[f"{impact.contact}.normal_force"][begin:stop]))


def _near_peaks(run: EngineSolution, samples: History | BetweenSteps) -> Iterator[Array]:
    """Yield times between the samples, and the steps, beside the largest sampled force of an impact."""
    t, steps, last = samples.t, run.t, len(run.t) - 1
    for impact in hardest(run):
        force = samples[f"{impact.contact}.normal_force"]
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

    def __init__(self, run: EngineSolution) -> None:
        self._run = run
        within = [impact for impact in hardest(run) if impact.t <= run.t[-1]]  # rows may end sooner than the run
        inside = [np.searchsorted(run.t, (impact.t, end_of(impact, run))) for impact in within]
        self._impacts = [(impact, *place) for impact, place in zip(within, inside, strict=True)]
        unseen = [(i.t, _middle(i, run), end_of(i, run)) for i, begin, stop in self._impacts if begin == stop]
        self.t: Array = np.unique(np.concatenate([run.t, np.ravel(unseen)]))

    def __getitem__(self, name: str) -> Array:
        """Return a history, with the true peaks of its pair where it is one of contact."""
        values: Array = np.interp(self.t, self._run.t, self._run[name])
        pair, _, part = name.rpartition(".")
        if part not in ("normal_force", "penetration"):
            return values
        for impact, begin, stop in self._impacts:
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


def _middle(impact: Impact, run: EngineSolution) -> float:
    return (impact.t + end_of(impact, run)) / 2
