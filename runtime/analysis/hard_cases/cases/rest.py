"""Settling, lasting contact, and starts inside a contact."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from hertzwerk.runtime.analysis.hard_cases import closed_forms
from hertzwerk.runtime.analysis.hard_cases.case import (
    IMPLICIT,
    METHODS,
    HardCase,
    Known,
    Source,
    contacts,
    final,
    largest,
)

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value

BALL, BALL_EXACT = Source("bouncing_ball"), Source("bouncing_ball", laws=(("floor", "exact"),))
BALL_PULLED = Source("bouncing_ball", laws=(("floor", "kelvin_voigt"),))
FREE = Source("free_impact_flores", hard=True)
G, FALL = 9.81, math.sqrt(2 / 9.81)
STATIC = closed_forms.static_penetration(2.4e10, 1.5, 1, G)
WEIGHT = "the penetration that carries the weight, (m g/K)^(1/n)"
STABLE = {"dopri5": 3.3, "dop853": 6.0}  # longest stable step times a damping rate


def _at_rest(penetration: float = STATIC) -> tuple[Known, ...]:
    return (
        final("floor.penetration", penetration, 1e-8 * penetration, WEIGHT),
        final("vertical.speed", 0, 1e-9, "rest"),
    )


def _settling(law: str, source: Source, h: float) -> tuple[HardCase, HardCase]:
    """Make two cases: to the end for stiff methods, and the beginning for all methods."""
    hard = "restitution 0.01: the ball sinks into its rest under a damping of 1.5e6 1/s"
    begun = 0.6
    rate = h * G / 1e-3  # of the damping at rest, h K d^n/(m v0), v0 the floor of the approach speed
    explicit = {method: int(1.2 * rate * (begun - FALL) / limit) + 500 for method, limit in STABLE.items()}
    parameters = {"restitution": 0.01}
    return (
        HardCase(
            f"settling_{law}",
            "rest",
            f"{hard}, within 10 s",
            source,
            10,
            1e-6,
            (*IMPLICIT, "auto"),
            parameters,
            known=_at_rest(),
        ),
        HardCase(
            f"sinking_{law}",
            "rest",
            f"{hard}, which holds explicit steps at 3.3 (order 5) or 6 (order 8) over it",
            source,
            begun,
            1e-6,
            METHODS,
            parameters,
            theory=explicit,
        ),
    )


def _start(name: str, hard: str, e: float, speed: float, duration: float, known: tuple[Known, ...]) -> HardCase:
    initial: dict[str, Value] = {"ball.travel": "-0.01 m", "ball.speed": (speed, "m/s")}
    return HardCase(name, "starts", hard, FREE, duration, 1e-8, METHODS, {"e": e}, initial, known)


_STORED = 0.4 * 1e8 * 0.01**2.5  # J, at the depth of the starts
_N1: dict[str, Value] = {"exponent": 1, "stiffness": (1e8, "N/m^1"), "restitution": 0.5}

CASES = (
    HardCase(
        name="drop_to_rest",
        theme="rest",
        hard="dropped from 1 m, nine bounces, then at rest until 10 s",
        source=BALL,
        duration=10,
        tolerance=1e-12,
        parameters={"restitution": 0.5},
        known=_at_rest(),
    ),
    HardCase(
        name="many_bounces_to_rest",
        theme="rest",
        hard="restitution 0.9: some sixty bounces, each shorter than the last, then at rest until 10 s",
        source=BALL,
        duration=10,
        tolerance=1e-12,
        parameters={"restitution": 0.9},
        known=_at_rest(),
        failures={
            ("esdirk", "energy"): "the errors of sixty impacts, mostly of one sign, add up to 1.4 times the limit"
        },
    ),
    HardCase(
        name="bounces_accumulate",
        theme="rest",
        hard="restitution 0.5 at every speed (Kelvin-Voigt): without end, the bounces would end at 1.4 s",
        source=BALL_PULLED,
        duration=10,
        tolerance=1e-12,
        parameters=_N1,
        known=_at_rest(closed_forms.static_penetration(1e8, 1, 1, G)),
    ),
    *_settling("flores", BALL, closed_forms.flores(0.01)),
    *_settling("exact", BALL_EXACT, 100.0),
    HardCase(
        name="start_at_rest",
        theme="starts",
        hard="starts at rest in its static penetration, and stays there for 10 s",
        source=BALL,
        duration=10,
        tolerance=1e-10,
        parameters={"drop_height": (STATIC, "m")},  # for the scales: lengths of the penetration at rest
        initial={"vertical.travel": (0.1 - STATIC, "m")},
        known=(
            *_at_rest(),
            largest("floor.penetration", STATIC, 1e-8 * STATIC, WEIGHT),
            final("floor.dissipated", 0, 1e-12, "nothing moves"),
        ),
    ),
    _start(
        "start_deep",
        "starts at rest, 14 times as deep as the scale of lengths",
        1.0,
        0.0,
        5e-3,
        (final("ball.speed", math.sqrt(2 * _STORED), 1e-7 * 30, "all that is stored becomes kinetic"),),
    ),
    _start(
        "start_separating",
        "starts deep and separating; the elastic law pushes on",
        1.0,
        10.0,
        5e-3,
        (final("ball.speed", math.sqrt(100 + 2 * _STORED), 1e-7 * 30, "all that is stored becomes kinetic"),),
    ),
    _start(
        "start_released",
        "starts deep and separating so fast that the damped law would pull: no force before the gap has opened",
        0.5,
        10.0,
        5e-3,
        (
            final("ball.travel", 0.04, 1e-12, "uniform motion"),
            final("ball.speed", 10.0, 1e-12, "uniform motion"),
            contacts(0, "released from the start"),
        ),
    ),
)
