"""Balls that stick in an impact and slip again just before they lift off."""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.hard_cases.case import HardCase, Known, Source, impact
from hertzwerk.runtime.solution.solution import Solution

NORMAL = "motion along the normal alone, by SciPy to 1e-13"
STICKS = NORMAL + ": rolling needs m g sin(tilt) J/(J + m R^2), friction holds mu N"


def _first_slip_after_stick(run: Solution) -> float:
    """Return the time [s] at which the floor first slips after it stuck, while it touches."""
    slips, touches = np.abs(run["floor.slip"]) > 0, run["floor.normal_force"] > 0
    found = np.flatnonzero(~slips[:-1] & slips[1:] & touches[:-1])
    return float(run.t[found[0] + 1]) if len(found) else float("nan")


def _slips_at(expected: float, within: float) -> Known:
    return Known("onset of slip", _first_slip_after_stick, expected, within, "s", STICKS)


CASES = (
    HardCase(
        name="slips_before_lift_off_in_space",
        theme="friction",
        hard="slip begins 50 us before a ball lifts off, in two directions, where the force that holds falls to the one needed",
        source=Source("ball_on_diagonal", hard=True),
        duration=0.4,
        tolerance=1e-10,
        known=(_slips_at(0.2208738910664, 1e-10), impact(0, "t", 0.2162083234280, 1e-12, "free fall")),
    ),
    HardCase(
        name="slips_before_lift_off_beside_wall",
        theme="friction",
        hard="slip begins 1.2 us before a ball lifts off: in the last two per cent of a step, where its end is moved to the surface",
        source=Source("ball_beside_wall", hard=True),
        duration=0.55225,
        tolerance=1e-8,
        known=(_slips_at(0.1024180826476, 1e-8), impact(0, "t", 0.0986560487228, 1e-11, "free fall")),
    ),
)
