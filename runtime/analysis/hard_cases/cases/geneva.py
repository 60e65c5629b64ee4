"""Geneva drive at speed: its locking disc's edge passes a tip, its pin knocks in its slot."""

from __future__ import annotations

from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Source, final

LOCKED = final(
    "axle.angle",
    -0.7853981633974483,
    4.5e-4,
    "a quarter of a turn, locked within the plays: 2.4e-4 rad of a triangle, and what the disc is pressed in",
    "rad",
)

CASES = (
    HardCase(
        name="locking_disc_at_speed",
        theme="curves",
        hard="600 rpm: a corner of the locking disc passes under a tip that is pressed into it: the normal jumps, and the force below zero",
        source=Source("geneva_drive"),
        duration=0.05,
        tolerance=1e-6,
        parameters={"crank_speed": (600, "rpm")},
        known=(LOCKED,),
    ),
    HardCase(
        name="pin_knocks_in_slot",
        theme="curves",
        hard="240 rpm: sums beside differences of two products, which a compiler likes to fuse; the pin knocks in its slot",
        source=Source("geneva_drive"),
        duration=0.125,
        tolerance=1e-6,
        parameters={"crank_speed": (240, "rpm")},
        known=(LOCKED,),
        long=True,
    ),
)
