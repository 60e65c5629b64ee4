"""Contacts of a run: when each began and how fast, how long it lasted, its largest force and penetration."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.integrate.layout import CONTACT, FLIGHT

if TYPE_CHECKING:
    from hertzwerk.runtime.history import History

PEAK = 1e-8
MAX_ITERATIONS = 60


@dataclass(frozen=True)
class Impact:
    """One contact: onset t [s], approach speed [m/s], largest normal force [N], duration [s] (None if unfinished), largest penetration [m]."""

    contact: str
    t: float
    speed: float
    peak_force: float
    duration: float | None
    peak_penetration: float


@dataclass(frozen=True)
class _Span:
    """Rows of a contact of pair j: onset, and the last one in contact; the step after `last` is still a step in contact."""

    j: int
    onset: int
    last: int


def find(history: History) -> tuple[Impact, ...]:
    """Every contact of a run, in the order of onset; peaks to the accuracy of the run, found within its steps."""
    spans = sorted(
        (span for j in range(history.model.k) for span in _spans(history.part("mode")[:, j], j)),
        key=lambda s: (s.onset, s.j),
    )
    if not spans:
        return ()
    t = history.t
    forces = _peaks(history, spans, "force", "force_rate", +1, "normal_force")
    penetrations = _peaks(history, spans, "gap", "gap_rate", -1, "penetration")
    found = []
    for span, force, penetration in zip(spans, forces, penetrations, strict=True):
        finished = span.last + 1 < len(t)
        found.append(
            Impact(
                contact=history.model.pairs[span.j],
                t=float(t[span.onset]),
                speed=max(0.0, -float(history.part("gap_rate")[span.onset, span.j])),
                peak_force=float(force),
                duration=float(t[span.last + 1] - t[span.onset]) if finished else None,
                peak_penetration=float(penetration),
            )
        )
    return tuple(found)


def approach_speeds(history: History, j: int) -> np.ndarray:
    """Approach speeds [m/s] of every contact of pair j, in order."""
    spans = list(_spans(history.part("mode")[:, j], j))
    speeds: np.ndarray = np.maximum(-history.part("gap_rate")[[span.onset for span in spans], j], 0)
    return speeds


def _spans(mode: np.ndarray, j: int) -> Iterator[_Span]:
    """Contacts of one pair: from a row in contact to the last such row before the gap opens (it may be released and touch again between)."""
    onset, last = -1, -1
    for i, value in enumerate(mode):
        if value == CONTACT:
            onset, last = (i if onset < 0 else onset), i
        elif value == FLIGHT and onset >= 0:
            yield _Span(j, onset, last)
            onset = -1
    if onset >= 0:
        yield _Span(j, onset, last)


def _peaks(history: History, spans: list[_Span], part: str, rate: str, sign: int, name: str) -> np.ndarray:
    """Largest value of `name` in each span: at its rows, and where sign * rate falls through zero within the steps beside the largest row."""
    values, rates = sign * history.part(part), sign * history.part(rate)
    owner, index, length, pair = [], [], [], []
    for i, span in enumerate(spans):
        top = span.onset + int(np.argmax(values[span.onset : span.last + 1, span.j]))
        for row in {max(top - 1, span.onset), top}:
            if row + 1 < len(history.t):
                owner.append(i)
                index.append(row)
                length.append(history.t[row + 1] - history.t[row])
                pair.append(span.j)
    peaks = np.array([np.max(history[f"{history.model.pairs[s.j]}.{name}"][s.onset : s.last + 1]) for s in spans])
    if not owner:
        return peaks
    rows, steps, column, owners = np.array(index), np.array(length), np.array(pair), np.array(owner)
    at_low = rates[rows, column]
    at_high = sign * history.between(rows, steps).part(rate)[np.arange(len(rows)), column]
    at_low = np.where(
        at_low == 0, np.abs(at_high), at_low
    )  # a force begins with no slope, or none that is known, and rises
    inside = (at_low > 0) & (at_high < 0)
    rows, steps, column, owners = rows[inside], steps[inside], column[inside], owners[inside]
    at = history.between(rows, _roots(history, rows, steps, column, rate, sign, at_low[inside], at_high[inside]))
    best = np.array([at[f"{history.model.pairs[j]}.{name}"][i] for i, j in enumerate(column)])
    np.maximum.at(peaks, owners, best)
    return peaks


def _roots(
    history: History,
    rows: np.ndarray,
    steps: np.ndarray,
    column: np.ndarray,
    rate: str,
    sign: int,
    at_low: np.ndarray,
    at_high: np.ndarray,
) -> np.ndarray:
    """Times after the rows at which sign * rate falls through zero, by regula falsi (Illinois); all at once.

    A peak is flat: its value is right to rounding when its time is to PEAK of the step.
    """
    low, high, root = np.zeros(len(rows)), steps.copy(), np.zeros(len(rows))
    for _ in range(MAX_ITERATIONS):
        before, root = root, low + (high - low) * at_low / (at_low - at_high)
        if np.all(np.abs(root - before) <= PEAK * steps):
            break
        value = sign * history.between(rows, root).part(rate)[np.arange(len(rows)), column]
        rising = value > 0
        at_high = np.where(rising, at_high / 2, value)
        at_low = np.where(rising, value, at_low / 2)
        low, high = np.where(rising, root, low), np.where(rising, high, root)
    return root
