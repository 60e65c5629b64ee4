"""Several pairs at once."""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.hard_cases import closed
from hertzwerk.runtime.hard_cases.case import METHODS, REFERENCED, HardCase, Known, Source, contacts, final, impact

TOLERANCE = 1e-8
PART = 100 * TOLERANCE  # of a speed after a few impacts
APART = 1e-6  # m, and so as many seconds
NEARLY = {"left": -0.999758604583, "middle": -0.000482616145, "right": 1.000241220728}  # m/s
TOUCHING = (-0.071085017086, -0.030273764097, -0.014463629032, 0.127044986067, 0.988777424148)  # m/s, after 20 ms


def _passed_on(count: int) -> tuple[Known, ...]:
    """Elastic impacts of equal spheres, one after another: each hands its speed on."""
    source = "equal masses exchange their speeds"
    return tuple(final(f"path_{i}.speed", float(i == count), PART, source) for i in (1, 2, count - 1, count))


def _conserved(count: int) -> Known:
    def momentum(run: object) -> float:
        return float(np.sum([run[f"path_{i}.speed"][-1] for i in range(1, count + 1)]))  # type: ignore[index]

    return Known("final sum of speeds", momentum, 1.0, 1e-12, "m/s", "momentum of equal masses")


def _both_sides(e: float) -> HardCase:
    out = closed.restitution_out(closed.flores(e))
    source = "by symmetry each meets a wall"
    return HardCase(
        name=f"both_sides_e{10 * e:02.0f}",
        theme="many pairs",
        hard="two pairs of one sphere hit at the same instant" + ("" if e == 1 else ", and are damped"),
        source=Source("struck_from_both_sides", hard=True),
        duration=0.01,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"restitution": e},
        known=(
            contacts(2, "two impacts"),
            final("left.speed", -out, PART, source),
            final("middle.speed", 0.0, 1e-12, source),
            final("right.speed", out, PART, source),
        ),
    )


def _nearly_both_sides() -> HardCase:
    source = "SciPy's DOP853 at 1e-13, without events"
    free = "uniform motion; what the first contact moves in 1 us is 1e-14 m"
    return HardCase(
        name="both_sides_1us_apart",
        theme="many pairs",
        hard="two pairs of one sphere hit 1 us apart: a step that has landed on one must not be moved on to the other, past the one",
        source=Source("struck_from_both_sides", hard=True),
        duration=0.01,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        initial={"right.travel": (0.041 + APART, "m")},
        known=(
            contacts(2, "two impacts"),
            impact(0, "t", 1e-3, 1e-12, free),
            impact(1, "t", 1e-3 + APART, 1e-12, free),
            *(final(f"{body}.speed", speed, PART, source) for body, speed in NEARLY.items()),
        ),
    )


def _row(count: int, *, long: bool) -> HardCase:
    return HardCase(
        name=f"row_of_{count}",
        theme="many pairs",
        hard=f"a sphere meets a row of {count - 1}, 1 mm apart: {count - 1} impacts, one after another",
        source=Source(f"row_of_{count}", hard=True),
        duration=0.004 * count,
        tolerance=TOLERANCE,
        methods=METHODS if long else REFERENCED,
        known=(contacts(count - 1, "each pair meets once"), *_passed_on(count), _conserved(count)),
        long=long,
    )


CASES = (
    _both_sides(1.0),
    _both_sides(0.5),
    _nearly_both_sides(),
    _row(5, long=False),
    HardCase(
        name="touching_row_of_5",
        theme="many pairs",
        hard="a sphere meets a row of four that touch: four pairs in contact at once, gaps of rounding between them at the start",
        source=Source("row_of_5", hard=True),
        duration=0.02,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"gap": "0 m"},
        known=(
            *(
                final(f"path_{i}.speed", speed, PART, "SciPy's DOP853 at 1e-13, without events")
                for i, speed in enumerate(TOUCHING, 1)
            ),
            _conserved(5),
        ),
    ),
    _row(50, long=True),
)
