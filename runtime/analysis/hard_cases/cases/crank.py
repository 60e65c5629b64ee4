"""Slider-crank with clearance: extreme clearances and speeds, dead centres, long runs; and wear."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hertzwerk.runtime.analysis.hard_cases.case import REFERENCED, HardCase, Known, Source, final

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value

SMOOTH, ROUGH = Source("slider_crank_frictionless"), Source("slider_crank")
WORN, PRESSED = 9.853558871621333878e-4, 0.2440277658189568107  # m, N
LINEAR = "matrix exponential of pad, spring, stiffness and wear, by mpmath at 40 digits"
SLIPPED = "of a ball that slips by V = 2.4 m/s until it rolls on a plane; slopes of the groove add a thousandth"
QUAD = "quadruple precision, tests/reference/programs/slider_crank_quad.cpp"


def _state(travel: float, speed: float, clearance: float, tip_speed: float, part: float) -> tuple[Known, ...]:
    """Expect the slider's state within a part of clearance and crank speed."""
    return (
        final("guide.travel", travel, part * clearance, QUAD),
        final("guide.speed", speed, part * tip_speed, QUAD),
    )


def _clearance(name: str, hard: str, clearance: str, rpm: float, duration: float, known: tuple[Known, ...]) -> HardCase:
    parameters: dict[str, Value] = {"clearance": clearance, "crank_speed": (rpm, "rpm")}
    return HardCase(name, "slider-crank", hard, SMOOTH, duration, 1e-9, parameters=parameters, known=known)


NEAR_IDEAL = final(
    "guide.travel", 0.17, 1.2 * 5e-4, "whole revolutions: the ideal mechanism, within clearance and penetration"
)

CASES = (
    HardCase(
        name="centred_start",
        theme="slider-crank",
        hard="the journal starts exactly centred, where |e| - c has no derivative",
        source=SMOOTH,
        duration=0.002,
        tolerance=1e-9,
        methods=REFERENCED,
        known=_state(0.1373416982226764233365, -25.73104758197984349727, 5e-4, 26.18, 1e-6),
    ),
    HardCase(
        name="dead_centre",
        theme="slider-crank",
        hard="starts in the outer dead centre and ends exactly in the inner one; with friction",
        source=ROUGH,
        duration=0.006,
        tolerance=1e-9,
        known=_state(6.962904325573187284805e-2, 8.438369804113107325817e-1, 5e-4, 26.18, 1e-5),
    ),
    _clearance(
        "clearance_1um",
        "clearance 1 um at 10,000 rpm: one revolution in permanent contact, penetration twice the clearance",
        "1 um",
        10_000,
        0.006,
        _state(0.1700047189028763161343, 2.291411722586347894995e-6, 1e-6, 52.36, 1e-8),
    ),
    _clearance(
        "clearance_5mm",
        "clearance 5 mm at 10 rpm: forty ever weaker impacts, then permanent contact within 1 s",
        "5 mm",
        10,
        1.0,
        _state(0.1347839478063654505557734, -0.06263243468732951770999, 5e-3, 0.05236, 1e-8),
    ),
    HardCase(
        name="thin_friction_layer",
        theme="slider-crank",
        hard="friction smoothed over 1e-7 m/s only, for two revolutions",
        source=ROUGH,
        duration=0.024,
        tolerance=1e-6,
        parameters={"friction_speed": "1e-7 m/s"},
        known=(NEAR_IDEAL,),
        failures={
            (
                "dopri5",
                "energy",
            ): "its steps cross the layer, thinner than the tolerance, at every reversal of sliding: twice the limit"
        },
    ),
    HardCase(
        name="worn_through",
        theme="wear",
        hard="pin and bush lose a fifth of the clearance within half a revolution",
        source=Source("worn_crank", hard=True),
        duration=0.006,
        tolerance=1e-8,
        parameters={"repetitions": (1e6, "1")},
        known=(
            Known(
                "volume over force and sliding",
                lambda run: float(run["wear.volume"][-1] / run["wear.load_path"][-1]),
                2e-9,
                1e-20,
                "1/Pa",
                "Archard's law, twice 1e-6 mm^3/(N m) 1e6 times",
            ),
        ),
    ),
    HardCase(
        name="worn_until_unloaded",
        theme="wear",
        hard="a pad that its spring presses ever less: nothing but wear brings its force to zero",
        source=Source("worn_pad", hard=True),
        duration=5.0,
        tolerance=1e-8,
        known=(
            final("wear.depth", WORN, 1e-10, LINEAR),
            final("floor.normal_force", PRESSED, 1e-3, LINEAR),
        ),
    ),
    HardCase(
        name="rolls_over_its_worn_track",
        theme="wear",
        hard="a ball just in touch slips along, turns back in the groove that it wears, and rolls over its slopes",
        source=Source("worn_rolling", hard=True),
        duration=0.5,
        tolerance=1e-8,
        known=(
            final("wear.load_path", 2.4**2 / 2.8, 4e-3, f"m V^2/(7 mu) {SLIPPED}"),
            final("way.x_speed", 0.4 - 2 * 2.4 / 7, 2e-3, f"v - 2 V/7 {SLIPPED}"),
        ),
    ),
    HardCase(
        name="thousand_revolutions",
        theme="slider-crank",
        hard="1000 revolutions, some ten thousand impacts",
        source=SMOOTH,
        duration=12.0,
        tolerance=1e-6,
        known=(NEAR_IDEAL,),
        failures={
            (
                "dopri5",
                "energy",
            ): "in permanent contact its steps are as long as stability allows, and their small errors have one sign: "
            "forty times the limit"
        },
        long=True,
    ),
)
