"""Measured orders of convergence; `tests/` asserts them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

WITHIN = 0.3
DEEP = {"vertical.travel": 0.1 - 8e-5, "vertical.speed": -3.0}  # m, m/s: the bouncing ball 80 um deep, still closing
EXACT = 60  # steps of dop853


class Phase(NamedTuple):
    """Of a contact, where the force is smooth: theory's order, its length [s], restitution, numbers of equal steps.

    Few steps leave more than the error's leading term, many leave rounding.
    """

    order: int
    length: float
    restitution: float
    counts: tuple[int, ...]


PHASES = {
    "dopri5": Phase(5, 6e-5, 0.7, (16, 24, 32, 48)),
    "dop853": Phase(8, 1e-4, 1.0, (4, 5, 6, 8, 10)),
    "rodas": Phase(5, 6e-5, 0.7, (16, 24, 32, 48)),
    "esdirk": Phase(5, 6e-5, 0.7, (16, 24, 32, 48)),
}


def orders() -> Iterator[str]:
    """The slope of the error over the step, equal steps in a smooth phase of a contact; within 0.3 of theory."""
    for method, phase in PHASES.items():
        exact = after(phase, "dop853", EXACT)
        errors = [float(np.max(np.abs(after(phase, method, count) - exact))) for count in phase.counts]
        slope = -np.polyfit(np.log(phase.counts), np.log(errors), 1)[0]
        verdict = "kept" if abs(slope - phase.order) <= WITHIN else "MISSED"
        row = ", ".join(f"{count}: {error:.1e}" for count, error in zip(phase.counts, errors, strict=True))
        yield f"  {method:<8} measured {slope:5.2f}  theory {phase.order}  {verdict:<6}  errors by steps {row}"


def after(phase: Phase, method: str, count: int) -> np.ndarray:
    """Travel and speed after so many equal steps through the phase, over the depth and the speed it starts with."""
    from hertzwerk.runtime import load, simulate

    run = simulate(
        load("bouncing_ball"), duration=phase.length, tolerance=1e-11, method=method, compiled=False,
        parameters={"restitution": phase.restitution},
        initial={name: f"{value!r} {unit}" for (name, value), unit in zip(DEEP.items(), ("m", "m/s"), strict=True)},
    )  # fmt: skip
    here = run.history
    for _ in range(count):
        here = here.between(np.array([0]), np.array([phase.length / count]))
    return np.array([here["vertical.travel"][0] / 8e-5, here["vertical.speed"][0] / 3.0])
