"""SciPy: every method of `solve_ivp`, restarted at each zero of a gap by terminal events, as its documentation shows for a cannon."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades
from scipy.integrate import solve_ivp

NAME, PACKAGE = "SciPy", "scipy"
METHODS = ("RK23", "RK45", "DOP853", "Radau", "BDF", "LSODA")


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return the relative tolerances of each integrator; the absolute one is a thousandth."""
    return dict.fromkeys(METHODS, decades(3, 12, 1))


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured."""

    def gap(i: int, direction: int) -> Callable[[float, np.ndarray], float]:
        def event(t: float, y: np.ndarray) -> float:
            return float(problem.gaps(t, y, np)[i])

        event.terminal = True  # type: ignore[attr-defined]
        event.direction = direction  # type: ignore[attr-defined]
        return event

    events = [{on: gap(i, 1 if on else -1) for on in (0, 1)} for i in range(problem.contacts)]
    options: dict[str, Any] = {"method": integrator, "rtol": max(setting, 3e-14), "atol": setting / 1000}
    end = problem.times[-1]

    def run() -> Result:
        t, y, states, onsets = 0.0, problem.start, [], []
        on = np.array([value < 0 for value in problem.gaps(t, y, np)], dtype=int)
        while t < end:
            part = solve_ivp(
                lambda t, y: problem.rates(t, y, on, np),
                (t, end),
                y,
                t_eval=problem.times[problem.times > t],
                events=[each[k] for each, k in zip(events, on, strict=True)],
                **options,
            )
            if part.status < 0:
                raise ArithmeticError(part.message)
            states += [*np.transpose(part.y)[:, : problem.compared]] if len(part.t) else []
            if part.status == 0:
                break
            changed = next(i for i, found in enumerate(part.t_events) if len(found))
            t, y = float(part.t_events[changed][0]), part.y_events[changed][0]
            on[changed] = 1 - on[changed]
            onsets += [t] * int(on[changed])
        return Result(np.array(states), lambda: np.array(onsets))

    return run
