"""Friction that sticks: an incline just below and just above the angle of friction."""

from __future__ import annotations

import math

from hertzwerk.runtime.hard_cases.case import IMPLICIT, HardCase, Known, Source, final

G, START, LAYER = 9.81, 0.01, 1e-7
DRIVE = 0.6 * 1.001 * G  # N: of the block of 1 kg and its carriage of 1 g, down an incline of 3 in 4
LOAD = 0.8 * G  # N
CRITICAL = DRIVE / LOAD  # coefficient of friction that just holds
MASS = 1.001


def creep(mu: float) -> float:
    """Speed [m/s] at which smoothed friction carries the drive."""
    return LAYER * math.atanh(CRITICAL / mu)


def _smooth(
    name: str, hard: str, mu: float, duration: float, known: tuple[Known, ...], methods: tuple[str, ...]
) -> HardCase:
    return HardCase(
        name=name,
        theme="friction",
        hard=hard,
        source=Source("incline_smooth_coulomb", hard=True),
        duration=duration,
        accuracy=1e-7,
        methods=methods,
        parameters={"friction_coefficient": mu, "friction_speed": (LAYER, "m/s"), "speed": (START, "m/s")},
        known=known,
    )


def _accelerated(mu: float, time: float) -> float:
    """Speed [m/s] of a block that slides all the time, its smoothed friction saturated."""
    return START + (DRIVE - mu * LOAD) / MASS * time


_HOLDS, _SLIDES = 1.01 * CRITICAL, 0.99 * CRITICAL

CASES = (
    _smooth(
        "incline_holds_smooth",
        "just below the angle of friction, smoothed over 1e-7 m/s: slides to a stop, then creeps",
        _HOLDS,
        10.0,
        (final("downhill.speed", creep(_HOLDS), 1e-6 * creep(_HOLDS), "v_s atanh(tan(angle)/mu)"),),
        (*IMPLICIT, "auto"),
    ),
    _smooth(
        "incline_slides_smooth",
        "just above the angle of friction, smoothed over 1e-7 m/s: never stops",
        _SLIDES,
        10.0,
        (final("downhill.speed", _accelerated(_SLIDES, 10.0), 1e-6, "uniform acceleration, m a = drive - mu load"),),
        ("dopri5", "dop853", *IMPLICIT, "auto"),
    ),
)
