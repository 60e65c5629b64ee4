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
        gaps = problem.opens if direction > 0 and problem.opens else problem.gaps

        def event(t: float, y: np.ndarray) -> float:
            return float(gaps(t, y, np)[i])

        event.terminal = True  # type: ignore[attr-defined]
        event.direction = direction  # type: ignore[attr-defined]
        return event

    events = [{on: gap(i, 1 if on else -1) for on in (0, 1)} for i in range(problem.contacts)]
    options: dict[str, Any] = {"method": integrator, "rtol": max(setting, 3e-14), "atol": setting / 1000}
    end = problem.times[-1]
    brief = (
        problem.kind == "crank"
    )  # the first step off a surface that SciPy chooses would pass its contacts and flights

    def run() -> Result:
        t, y, states, onsets = 0.0, problem.start, [], []
        on = problem.memory.copy()
        while t < end:
            part = solve_ivp(
                lambda t, y: problem.rates(t, y, on, np),
                (t, end),
                y,
                t_eval=problem.times[problem.times > t],
                first_step=min(problem.longest / 100, end - t) if brief else None,
                events=[each[k] for each, k in zip(events, on, strict=False)],
                **options,
            )
            if part.status < 0:
                raise ArithmeticError(part.message)
            states += [*np.transpose(part.y)[:, : problem.compared]] if len(part.t) else []
            if part.status == 0:
                break
            changed = next(i for i, found in enumerate(part.t_events) if len(found))
            t, y = float(part.t_events[changed][0]), part.y_events[changed][0]
            if on[changed]:
                on[changed] = 0
            else:
                problem.onset(on, changed, t, y)
                onsets.append(t)
        return Result(np.array(states), lambda: np.array(onsets))

    return run
