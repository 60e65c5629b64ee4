"""Several pairs in contact at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.analysis.hard_cases import closed_forms
from hertzwerk.runtime.analysis.hard_cases.case import (
    EXPLICIT,
    METHODS,
    REFERENCED,
    HardCase,
    Known,
    Source,
    contacts,
    final,
    impact,
)

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value

TOLERANCE = 1e-8
PART = 100 * TOLERANCE  # of a speed after a few impacts
APART = 1e-6  # m, and as many seconds
NEARLY = {"left": -0.999758604583, "middle": -0.000482616145, "right": 1.000241220728}  # m/s
TOUCHING = (-0.071085017086, -0.030273764097, -0.014463629032, 0.127044986067, 0.988777424148)  # m/s, after 20 ms
FINE, FINEST, TELLING = 1e-12, 1e-13, 1e-10
STRUCK = {  # m/s, by exponent, after the duration of their cases
    1.0: (-0.1322794847097020, -0.0753291698025603, -0.0310108290140364, 0.2962177501414400, 0.9424017333848588),
    1.5: (-0.0710850170860991, -0.0302737640970669, -0.0144636290320699, 0.1270449860678819, 0.9887774241473539),
    3.0: (-0.0103968770547632, -0.0008912036151512, -0.0000729610229864, 0.0114814076070423, 0.9998796340858583),
}
PRESSED = (-0.0092809015761356, 0.0190062863717532, -0.0926698973902975, 0.1564240841793510, 0.9265204284153288)
WAVES = (-0.9907490241037828, -0.1357069314271816, 0.0, 0.1357069314271816, 0.9907490241037828)
FIFTY = {
    1: -0.0710850170861,
    2: -0.0302737893645,
    25: -6.07205e-08,
    48: 0.0040125260607,
    49: 0.1486004632362,
    50: 0.9856788570900,
}


def _conserved(count: int) -> Known:
    def momentum(run: object) -> float:
        return float(np.sum([run[f"path_{i}.speed"][-1] for i in range(1, count + 1)]))  # type: ignore[index]

    return Known("final sum of speeds", momentum, 1.0, 1e-12, "m/s", "momentum of equal masses")


def _both_sides(e: float) -> HardCase:
    out = closed_forms.restitution_out(closed_forms.flores(e))
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
    speeds = ((i, float(i == count)) for i in (1, 2, count - 1, count))
    return HardCase(
        name=f"row_of_{count}",
        theme="many pairs",
        hard=f"a sphere meets a row of {count - 1}, 1 mm apart: {count - 1} impacts, one after another",
        source=Source(f"row_of_{count}", hard=True),
        duration=0.004 * count,
        tolerance=TOLERANCE,
        methods=METHODS if long else REFERENCED,
        known=(
            contacts(count - 1, "each pair meets once"),
            *(final(f"path_{i}.speed", speed, PART, "equal masses exchange their speeds") for i, speed in speeds),
            _conserved(count),
        ),
        long=long,
    )


def _touching(
    name: str, hard: str, speeds: Sequence[float], duration: float, *, tolerance: float = FINE, **parameters: Value
) -> HardCase:
    """Make a case of five spheres in a row that touch, each where its coordinate begins.

    At the finest tolerance only by the methods of order 8; others accumulate more errors.
    """
    return HardCase(
        name=name,
        theme="many pairs",
        hard=f"a row of five that touch{hard}, at tolerance {tolerance:g}: gaps as small as the rounding of what they are differences of",
        source=Source("touching_row_of_5", hard=True),
        duration=duration,
        tolerance=tolerance,
        methods=METHODS if tolerance == FINE else ("dop853", "auto"),
        parameters=parameters,
        known=tuple(
            final(f"path_{i}.speed", speed, TELLING, "extrapolated midpoint rule in 80 bits, without events")
            for i, speed in enumerate(speeds, 1)
        ),
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
    _touching("touching_row_fine", ", struck", STRUCK[1.5], 0.004),
    _touching("touching_row_finest", ", struck", STRUCK[1.5], 0.004, tolerance=FINEST),
    _touching("touching_row_linear", ", struck, F = K d", STRUCK[1.0], 0.002, exponent=1, stiffness=(1e8, "N/m^1")),
    _touching("touching_row_cubic", ", struck, F = K d^3", STRUCK[3.0], 0.1, exponent=3, stiffness=(1e8, "N/m^3")),
    _touching("touching_row_pressed", ", pressed together, struck", PRESSED, 0.004, preload="100 N"),
    _touching("two_waves_meet", ", struck at both ends", WAVES, 0.004, last_speed="-1 m/s"),
    HardCase(
        name="touching_row_of_50",
        theme="many pairs",
        hard="a row of fifty that touch, struck: what runs ahead of the wave is far below rounding",
        source=Source("touching_row_of_50", hard=True),
        duration=0.05,
        tolerance=1e-12,
        methods=EXPLICIT,
        known=(
            *(
                final(f"path_{i}.speed", speed, 1e-9, "extrapolated midpoint rule in 80 bits, without events")
                for i, speed in FIFTY.items()
            ),
            _conserved(50),
        ),
        long=True,
    ),
)
