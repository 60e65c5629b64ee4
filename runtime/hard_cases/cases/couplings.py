"""Couplings beside joints or couplings that say the same, or that contradict them."""

from __future__ import annotations

import math

import numpy as np

from hertzwerk.runtime.hard_cases.case import METHODS, HardCase, Known, Source, final
from hertzwerk.runtime.hard_cases.cases.closed_loops import closed
from hertzwerk.runtime.solution.solution import Solution

ENERGY = "energy"  # the invariant
LEAD, PACE = 1.0, 10.0  # rad, rad/s
RATE = math.sqrt(
    5 / (0.01 + 2**2 * 0.01 + 2 * 0.05**2)
)  # rad/s: of a wheel with a pinion of twice its speed and a rack
EVEN = "nothing turns it but itself: energy and momentum of a parallelogram"


def _apart(run: Solution) -> float:
    return float(np.abs(run["first_pair.moment"] - run["second_pair.moment"]).max())


CASES = (
    HardCase(
        name="gear_beside_a_parallelogram",
        theme="couplings",
        hard="a gear says what four bars say, but where these are in line: twelve constraints of which two are redundant, one in the change points",
        source=Source("geared_parallelogram", hard=True),
        duration=2.0,
        tolerance=1e-9,
        known=(
            final("left.angle", LEAD + 2 * PACE, 1e-9, EVEN, "rad"),
            final("right.angle", LEAD + 2 * PACE, 1e-9, EVEN, "rad"),
            closed(1e-12),
        ),
    ),
    HardCase(
        name="two_equal_gear_pairs",
        theme="couplings",
        hard="two gear pairs and two racks of which any two imply the others: forces are not determined, those of least norm are shared",
        source=Source("twin_gears", hard=True),
        duration=2.0,
        tolerance=1e-9,
        known=(
            final("wheel.angle", math.cos(2 * RATE), 1e-7, "an oscillator with the inertia of all", "rad"),
            final("pinion.angle", -2 * math.cos(2 * RATE), 2e-7, "the ratio", "rad"),
            Known("shares apart", _apart, 0.0, 1e-6, "N m", "equal pairs carry the same"),
            closed(1e-12),
        ),
    ),
    HardCase(
        name="gear_against_a_parallelogram",
        theme="couplings",
        hard="a gear turns one crank ahead of the other, which four bars forbid: by less than a rounding of the bars at first",
        source=Source("torn_parallelogram", hard=True),
        duration=0.5,
        tolerance=1e-9,
        parameters={"torn": (1.0, "rad/s")},
        outcome="constraint_lost",
        failures=dict.fromkeys(
            ((method, ENERGY) for method in METHODS), "the forces of what contradicts grow without bound"
        ),
        known=(Known("time", lambda run: float(run.t[-1]), 0.0, 1e-3, "s", "the bars and the gear part like t^2"),),
    ),
)
