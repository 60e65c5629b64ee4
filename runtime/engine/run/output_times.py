"""Grid of a run: every accepted step, or the states at given times."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.runtime.engine.model.binding import read_time

Grid: TypeAlias = str | int | Sequence[float] | np.ndarray | None  # spacing such as "0.1 ms"; points; times [s]; steps

MOST = 1_000_000  # rows of a grid
WHOLE = 1e-9  # relative: a number of intervals this close to a whole one counts as whole


def times_of(grid: Grid, seconds: float, faults: list[Fault]) -> np.ndarray | None:
    """Return the times [s] (n,) of a grid, None for every step; bad input is appended to `faults`."""
    if grid is None:
        return None
    if isinstance(grid, str):
        return _spaced(grid, seconds, faults)
    if isinstance(grid, int | np.integer) and not isinstance(grid, bool):
        if 2 <= grid <= MOST:
            return None if math.isnan(seconds) else np.linspace(0.0, seconds, int(grid))
        faults.append(Fault("grid", f"{shown(grid)} points", f"2 to {MOST:,} points, start and end included"))
        return None
    return _explicit_times(grid, seconds, faults)


def _spaced(text: str, seconds: float, faults: list[Fault]) -> np.ndarray | None:
    """Return start, multiples of a spacing, and end."""
    spacing = read_time("grid", text, 'a spacing such as "0.1 ms"', faults)
    if math.isnan(spacing) or math.isnan(seconds):
        return None
    if spacing > seconds:
        faults.append(Fault("grid", f"a spacing of {text}", f"no more than the duration, {seconds:g} s"))
        return None
    intervals = seconds / spacing
    if intervals > MOST - 1:
        faults.append(Fault("grid", f"{intervals + 1:.6g} points", f"at most {MOST:,}", "choose a wider spacing"))
        return None
    count = round(intervals) if abs(intervals - round(intervals)) <= WHOLE * intervals else math.ceil(intervals)
    return np.append(spacing * np.arange(count), seconds)


def _explicit_times(grid: object, seconds: float, faults: list[Fault]) -> np.ndarray | None:
    """Return times as given, after checks."""
    expected = 'a number of points, increasing times [s], a spacing such as "0.1 ms", or None for every step'
    try:
        times = np.array(grid, dtype=float)
    except (TypeError, ValueError, OverflowError):
        faults.append(Fault("grid", shown(grid), expected))
        return None
    if times.ndim != 1 or not len(times):
        faults.append(Fault("grid", f"numbers of shape {times.shape}" if times.ndim else shown(grid), expected))
        return None
    if len(times) > MOST:
        faults.append(Fault("grid", f"{len(times):,} times", f"at most {MOST:,}"))
    finite = np.isfinite(times)
    if not np.all(finite):
        faults.append(Fault("grid", f"{times[~finite][0]} at {_place(~finite)}", "finite times"))
    falls = np.append(False, np.diff(times) <= 0)  # false beside NaN
    if np.any(falls):
        i = int(np.argmax(falls))
        faults.append(Fault("grid", f"{times[i]:g} s after {times[i - 1]:g} s at {_place(falls)}", "increasing times"))
    outside = finite & ((times < 0) | (times > seconds))
    if np.any(outside):
        actual = f"{times[outside][0]:g} s at {_place(outside)}"
        faults.append(Fault("grid", actual, f"times within the run, 0..{seconds:g} s"))
    return times


def _place(wrong: np.ndarray) -> str:
    """Describe the position of the first true entry and the number of others."""
    count = int(np.sum(wrong))
    return f"index {int(np.argmax(wrong))}" + (f", and {count - 1} more" if count > 1 else "")
