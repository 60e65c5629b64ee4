"""Closed loops and couplings: singular positions, redundant or contradicting constraints, clearances."""

from __future__ import annotations

import math

import numpy as np

from hertzwerk.runtime.analysis.hard_cases.case import METHODS, HardCase, Known, Source, final
from hertzwerk.runtime.engine.solution.solution import EngineSolution

RIGID = 0.15 * math.cos(0.3) + math.sqrt(0.3**2 - (0.15 * math.sin(0.3)) ** 2)  # m, of the slider after 2 ms
TURNED = -31.750597186986102  # rad, of two windows after 10 s

ROUND = 10 * (0.08 + 0.03 * np.pi) / 2  # s, of a bead ten times round its track

ENERGY = "energy"  # the invariant
LEAD, PACE = 1.0, 10.0  # rad, rad/s
RATE = math.sqrt(
    5 / (0.01 + 2**2 * 0.01 + 2 * 0.05**2)
)  # rad/s: of a wheel with a pinion of twice its speed and a rack
EVEN = "nothing turns it but itself: energy and momentum of a parallelogram"


def closed(within: float) -> Known:
    """Expect closed loops over the accepted steps."""

    def opening(run: EngineSolution) -> float:
        return max(float(np.max(np.abs(run[name]))) for name in run.engine.model.constraints)

    return Known("largest opening", opening, 0.0, within, "", "closed loops")


def _apart(run: EngineSolution) -> float:
    return float(np.abs(run["first_pair.moment"] - run["second_pair.moment"]).max())


CASES = (
    HardCase(
        name="stiff_coupler",
        theme="loops",
        hard="a coupler that bends, a thousand times as stiff as steel: its shapes vibrate at up to 58 kHz, without damping",
        source=Source("flexible_slider_crank"),
        duration=0.002,
        tolerance=1e-8,
        methods=METHODS,
        parameters={"youngs_modulus": "200 TPa"},
        known=(final("guide.travel", RIGID, 1e-8, "the rigid slider-crank"), closed(1e-12)),
    ),
    HardCase(
        name="many_shapes",
        theme="loops",
        hard="a spinning rod with eight shapes, whose frequencies reach 158 times the first, thrown from straight",
        source=Source("whirling_rod", hard=True),
        duration=0.5,
        tolerance=1e-6,
        methods=METHODS,
    ),
    HardCase(
        name="change_points",
        theme="loops",
        hard="two four-bar windows pass a change point, all rods in line, ten times in 10 s: three freedoms and unbounded forces there",
        source=Source("n_four_bar"),
        duration=10.0,
        tolerance=1e-10,
        methods=METHODS,
        known=(
            final("foot_0.angle", TURNED, 1e-6, "one pendulum, by elliptic functions", "rad"),
            final("foot_2.angle", TURNED, 1e-6, "the same for every post", "rad"),
            closed(1e-12),
        ),
    ),
    HardCase(
        name="redundant_constraints",
        theme="loops",
        hard="Bricard's mechanism: by counting freedoms it cannot move, but one of its constraints is redundant",
        source=Source("bricard"),
        duration=10.0,
        tolerance=1e-9,
        methods=METHODS,
        known=(closed(1e-9),),
    ),
    HardCase(
        name="track_of_arcs_and_lines",
        theme="loops",
        hard="a bead passes forty junctions of arcs and lines, at which the force of its track jumps, in ten rounds",
        source=Source("track_round", hard=True),
        duration=ROUND,
        tolerance=1e-9,
        methods=("dop853", "auto"),
        known=(
            final("plane.x", 0.02, 1e-7, "once round after the perimeter over the speed", "m"),
            final("plane.x_speed", 2.0, 1e-7, "no work is done on it", "m/s"),
            final("track.force_track", 0.0, 1e-4, "nothing bends its way on a line", "N"),
            closed(1e-11),
        ),
    ),
    HardCase(
        name="three_clearances",
        theme="loops",
        hard="a slider-crank with clearance in all three pins, for 200 revolutions",
        source=Source("slider_crank_three_clearances"),
        duration=2.4,
        tolerance=1e-7,
        methods=("dop853", "esdirk", "auto"),
        long=True,
    ),
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
