"""Extrapolation in extended precision: the reference of every problem, from contact to contact.

Gragg's modified midpoint rule with 2, 4, .. 16 parts, extrapolated in the square of the step (order 16; Hairer, Norsett, Wanner, Solving Ordinary
Differential Equations I, II.9). Steps end where a gap is zero, found by retaken steps. Numbers are `numpy.longdouble`, 64 bits of mantissa on x86.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

PARTS = tuple(range(2, 18, 2))
REAL = np.longdouble
FAR = 20  # times the longest step, where no contact is near

Rates = Callable[[Any, Any], Any]


def step(f: Rates, t: Any, y: np.ndarray, h: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the state after a step and an estimate of its error."""
    first, rows = f(t, y), []
    for parts in PARTS:
        s = h / parts
        before, now = y, y + s * first
        for k in range(1, parts):
            before, now = now, before + 2 * s * f(t + k * s, now)
        rows.append((before + now + s * f(t + h, now)) / 2)
    for column in range(1, len(PARTS)):
        for row in range(len(PARTS) - 1, column - 1, -1):
            square = REAL(PARTS[row]) / PARTS[row - column]
            rows[row] = rows[row] + (rows[row] - rows[row - 1]) / (square * square - 1)
    return rows[-1], np.abs(rows[-1] - rows[-2])


def integrate(problem: Any, times: np.ndarray, tolerance: float, longest: float) -> tuple[np.ndarray, np.ndarray]:
    """Return states at the times, and onsets of impacts.

    `tolerance` is relative to the largest value that each state has had, or to the problem's smallest size.
    """
    t, y = REAL(0), problem.start.astype(REAL)
    size = np.maximum(np.abs(y), problem.smallest)
    on = problem.memory.astype(REAL)
    states, onsets, h = [], [], REAL(longest) / 10
    for end in times:
        while t < end:

            def f(t: Any, y: Any) -> Any:
                return np.asarray(problem.rates(t, y, on, np), dtype=REAL)

            cap = longest if on[: problem.contacts].any() else reach(problem, f(t, y), t, y, longest)
            last = t + min(h, cap) >= end
            part = end - t if last else min(h, REAL(cap))
            new, wrong = step(f, t, y, part)
            excess = float((wrong / size).max() / tolerance)
            if excess > 1:
                h = part * max(0.2, 0.8 * excess ** (-1 / 15))
                continue
            part, new, changed = landed(problem, f, t, y, part, new, on)
            t, y = t + part, new
            size = np.maximum(size, np.abs(y))
            if changed is not None:
                if on[changed]:
                    on[changed] = 0
                else:
                    problem.onset(on, changed, t, y)
                    onsets.append(t)
                h = min(h, REAL(longest) / 10)
            else:
                t = REAL(end) if last else t
                h = max(h, part) * min(3.0, 0.8 * max(excess, 1e-12) ** (-1 / 15))
                h = min(h, REAL(FAR * longest))
        states.append(y)
    return np.array(states), np.array(onsets)


def reach(problem: Any, rate: np.ndarray, t: Any, y: np.ndarray, longest: float) -> float:
    """Return the longest step [s] before a contact: a third of the time to the first gap that closes, within [longest, FAR longest]."""
    small = 1e-3 * longest
    now, then = (np.asarray(problem.gaps(*at, np)) for at in ((t, y), (t + small, y + small * rate)))
    closes = then < now
    soonest = (now[closes] * small / (now - then)[closes]).min(initial=np.inf)
    return float(min(max(soonest / 3, longest), FAR * longest))


def landed(
    problem: Any, f: Rates, t: Any, y: np.ndarray, h: Any, new: np.ndarray, on: np.ndarray
) -> tuple[Any, np.ndarray, int | None]:
    """Shorten a step to the first zero of a gap within it: its length, the state, and the contact that changes."""
    sign = 1 - 2 * on[: problem.contacts]
    after = np.asarray(problem.gaps(t + h, new, np)) * sign
    if not (after < 0).any():
        return h, new, None
    changed: int | None = None
    low, low_value = REAL(0), None
    while (after < 0).any():  # the first of several gaps
        changed = int(np.argmin(after))
        high, high_value = h, after[changed]
        low_value = max((np.asarray(problem.gaps(t, y, np)) * sign)[changed], REAL(0))
        low = REAL(0)
        for k in range(80):
            part = (low * high_value - high * low_value) / (high_value - low_value) if k % 3 else (low + high) / 2
            state = step(f, t, y, part)[0]
            value = (np.asarray(problem.gaps(t + part, state, np)) * sign)[changed]
            if value < 0:
                high, high_value = part, value
            else:
                low, low_value = part, value
            if high - low <= 4 * np.finfo(REAL).eps * max(t, high):
                break
        h, new = high, step(f, t, y, high)[0]
        after = np.asarray(problem.gaps(t + h, new, np)) * sign
        after[changed] = 0
    return h, new, changed
