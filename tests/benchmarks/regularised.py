"""Does a regularised contact pay? s = sqrt(d) as a state, sigma with dt = s dsigma as time, so that a force K d^1.5 (...) is analytic. From the root:

    python tests/benchmarks/regularised.py    (needs g++; about 30 s)

First one impact with few steps, then the whole slider-crank by hand in C++ (handwritten/regularised.hpp against slider_crank.cpp) at equal
error. One error at one instant is half luck, so the error of a tolerance is the median over five instants, and what an error costs is read
off a parabola through the logarithms of all tolerances.

Found: it pays below an error of about 1e-5 only. A step of order 8 that is graded towards the surface sees little of the term t^3.5 that the
root leaves in the motion, and more than half of a run's evaluations are made in contacts of milliseconds, which are smooth.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from statistics import median

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from benchmarks import programs

from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import dop853
from reference.slider_crank import reference

INSTANTS = (0.008, 0.009, 0.010, 0.011, 0.012)  # s, at which the error is taken
DURATION = 0.024  # s, of what is timed
TOLERANCES = tuple(10 ** (-k / 8) for k in range(28, 84))
LARGEST = 5e-2  # errors above it are those of another trajectory
TARGETS = (2e-3, 5e-5, 1e-6)
TABLE = dop853()
HYSTERESIS = 0.75 * (1 - 0.9**2)

Rates = Callable[[np.ndarray], np.ndarray]


# ---- one impact: v' = -d^1.5 (1 + h v), d' = v, from d = 0, v = 1 ------------------------------------------------------


def in_time(y: np.ndarray) -> np.ndarray:
    """Rates of (v, d) in t."""
    v, d = y
    return np.array([-(max(d, 0) ** 1.5) * (1 + HYSTERESIS * v), v])


def in_sigma(y: np.ndarray) -> np.ndarray:
    """Rates of (v, s, t) in sigma."""
    v, s, _ = y
    return np.array([-(s**4) * (1 + HYSTERESIS * v), v / 2, s])


def in_s(y: np.ndarray) -> np.ndarray:
    """Rates of (v, s, t) in s."""
    rates = in_sigma(y)
    return rates / rates[1]


def step(rates: Rates, y: np.ndarray, h: float) -> np.ndarray:
    """One step of dop853."""
    slopes: list[np.ndarray] = []
    for row in (*TABLE.A, TABLE.b):
        moved = y + h * sum((a * k for a, k in zip(row, slopes, strict=False) if a), start=np.zeros_like(y))
        slopes.append(rates(moved))
    return moved


def regularised_impact(steps: int, duration: float) -> tuple[float, float]:
    """Speed and time of separation; even steps of sigma, the last one lands on s = 0."""
    y = np.array([1.0, 0.0, 0.0])
    for _ in range(steps - 1):
        y = step(in_sigma, y, duration / steps)
    y = step(in_s, y, -y[1])
    return y[0], y[2]


def plain_impact(steps: int, duration: float, grading: float) -> tuple[float, float]:
    """The same in t, the steps finer towards both ends by a power; the landing is found for nothing."""
    nodes = np.linspace(0, 1, steps + 1)
    nodes = np.where(nodes < 0.5, (2 * nodes) ** grading, 2 - (2 * (1 - nodes)) ** grading) * duration / 2
    y = np.array([1.0, 0.0])
    for h in np.diff(nodes)[:-1]:
        y = step(in_time, y, h)
    left, last = -y[1] / y[0], y
    for _ in range(30):
        last = step(in_time, y, left)
        left -= last[1] / last[0]
    return last[0], nodes[-2] + left


def impacts() -> None:
    """Table of errors over numbers of steps."""
    sigma, y = 0.0, np.array([1.0, 0.0, 0.0])
    while y[1] >= 0:
        before, y, sigma = y, step(in_sigma, y, 0.01), sigma + 0.01
    y = step(lambda z: np.append(in_s(z[:3]), 1 / in_sigma(z[:3])[1]), np.append(before, 0), -before[1])
    speed, time = regularised_impact(400, total := sigma - 0.01 + y[3])

    def error(found: tuple[float, float]) -> float:
        return max(abs(found[0] - speed), abs(found[1] / time - 1))

    print("One impact, K d^1.5, restitution 0.9: larger error of the separation's speed and time")
    print("  steps   sigma, even   t, even   t, best grading t ~ i^q")
    for steps in (3, 4, 6, 8, 12, 16):
        graded = min((error(plain_impact(steps, time, q)), q) for q in np.arange(1, 3.2, 0.1))
        even = error(plain_impact(steps, time, 1))
        print(
            f"  {steps:5d}   {error(regularised_impact(steps, total)):11.1e}   {even:7.1e}   {graded[0]:.1e} (q = {graded[1]:.1f})"
        )


# ---- the slider-crank ------------------------------------------------------------------------------------------------


class Costs:
    """Error, evaluations and time [s] of a method at every tolerance."""

    def __init__(self, method: str, friction: bool) -> None:
        truth = reference(friction)
        self.method, self.friction = method, friction
        rows = []
        for tolerance in TOLERANCES:
            ends = [
                programs.handwritten(method, tolerance, friction=friction, times=(t,))["states"][0] for t in INSTANTS
            ]
            error = median(truth.error(t, tuple(state)) for t, *state in ends)
            if error < LARGEST:
                rows.append((error, tolerance, self.run(tolerance)["evaluations"]))
        self.errors, self.tolerances, self.evaluations = np.log(np.array(rows)).T

    def run(self, tolerance: float, repeats: int = 0) -> dict[str, float]:
        return programs.handwritten(self.method, tolerance, friction=self.friction, times=(DURATION,), repeats=repeats)

    def at(self, error: float, values: Sequence[float]) -> float:
        """The value at an error, off the parabola."""
        return math.exp(np.polyval(np.polyfit(self.errors, values, 2), math.log(error)))


def runs() -> None:
    """Ratios at equal error, over one: the regularised contact is cheaper."""
    print("Two revolutions of the slider-crank, plain over regularised (hand-written C++, dop853 both)")
    for friction in (False, True):
        plain, ours = (Costs(method, friction) for method in ("dop853", "regularised"))
        for target in TARGETS:
            tolerances = [costs.at(target, costs.tolerances) for costs in (plain, ours)]
            ratios = []
            for nearby in np.geomspace(0.6, 1.6, 9):  # side by side
                times = [
                    costs.run(nearby * tolerance, 15)["seconds"]
                    for costs, tolerance in zip((plain, ours), tolerances, strict=True)
                ]
                ratios.append(times[0] / times[1])
            evaluations = [costs.at(target, costs.evaluations) for costs in (plain, ours)]
            print(
                f"  {'friction' if friction else 'frictionless':<12}  error {target:.0e}:  evaluations {evaluations[0]:6.0f} / {evaluations[1]:6.0f}"
                f" = {evaluations[0] / evaluations[1]:.2f}   time {median(ratios):.2f}"
            )


if __name__ == "__main__":
    impacts()
    runs()
