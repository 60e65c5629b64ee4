"""C++ written by hand for the slider-crank, as fast as one writes it: `tests/benchmarks/handwritten/slider_crank.cpp`, compiled by g++ -O3."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Sequence
from functools import cache

import numpy as np
from benchmarks import programs
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME = "C++"
REPEATS = 5  # of a run of the program, which takes the median of them


@cache
def version() -> str:
    """Return the compiler's version; empty without one."""
    if programs.COMPILER is None:
        return ""
    command = [programs.COMPILER, "-dumpfullversion"]
    return "g++ " + subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return the tolerances."""
    return dict.fromkeys(("dopri5", "dop853"), decades(2, 13, 1)) if problem.kind == "crank" else {}


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured."""

    def run() -> Result:
        found = programs.handwritten(
            integrator, setting, friction=problem.physics.friction, times=problem.times.tolist(), repeats=REPEATS
        )
        states = np.array(found["states"])[:, 1 : 1 + problem.compared]
        return Result(states, lambda: np.array([onset for onset, _ in found["impacts"]]), found["seconds"])

    return run
