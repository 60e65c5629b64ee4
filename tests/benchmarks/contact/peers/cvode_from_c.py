"""SUNDIALS CVODE, in CasADi's wheel, called from C++ on right-hand sides written by hand, restarted at each root of the gap."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from benchmarks import programs
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME = "CVODE"
REPEATS = 5  # of a run of the program, which takes the median of them


def version() -> str:
    """Return the version of the library; empty if no program can be linked to it."""
    return "2.6" if programs.sundials() else ""


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return the tolerances."""
    kinds = [f"{formula} {solver}" for formula in ("adams", "bdf") for solver in ("functional", "newton")]
    return dict.fromkeys(kinds, decades(2, 13, 1)) if problem.kind == "crank" else {}


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured."""
    options = {"friction": problem.physics.friction, "times": problem.times.tolist(), "repeats": REPEATS}

    def run() -> Result:
        found = programs.cvode(*integrator.split(), setting, **options)
        states = np.array(found["states"])[:, : problem.compared]
        return Result(states, lambda: np.array(found["impacts"]), found["seconds"])

    return run
