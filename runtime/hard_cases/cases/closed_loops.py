"""Closed loops: singular positions, redundant constraints, clearance in every joint."""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.hard_cases.case import METHODS, HardCase, Known, Source, final
from hertzwerk.runtime.solution.solution import Solution

TURNED = -31.750597186986102  # rad, of two windows after 10 s

ROUND = 10 * (0.08 + 0.03 * np.pi) / 2  # s, of a bead ten times round its track


def closed(within: float) -> Known:
    """Expect closed loops over the accepted steps."""

    def opening(run: Solution) -> float:
        return max(float(np.max(np.abs(run[name]))) for name in run.model.constraints)

    return Known("largest opening", opening, 0.0, within, "", "closed loops")


CASES = (
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
)
