"""Guides under their own reaction, next to locking themselves and beyond."""

from __future__ import annotations

from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Source, final

BOUND = 0.25  # coefficient of friction at which the guide of the scene locks, length/(2 arm)
NEXT = (1 - 1e-6) * BOUND
BRAKED = "a block that slides on two pads brakes by mu g, up to where it locks"

CASES = (
    HardCase(
        name="guide_next_to_locking",
        theme="friction",
        hard="the reaction that friction makes feeds it by all but a millionth",
        source=Source("jamming_guide", hard=True),
        duration=0.1,
        tolerance=1e-8,
        parameters={"friction_coefficient": NEXT},
        known=(final("slide.speed", 1 - NEXT * 9.81 * 0.1, 1e-10, BRAKED),),
    ),
    HardCase(
        name="guide_that_locks",
        theme="friction",
        hard="friction beyond length/(2 arm): no deceleration is in balance (Painleve)",
        source=Source("jamming_guide", hard=True),
        duration=0.1,
        tolerance=1e-8,
        parameters={"friction_coefficient": (1 + 1e-6) * BOUND},
        outcome="friction_locks",
    ),
)
