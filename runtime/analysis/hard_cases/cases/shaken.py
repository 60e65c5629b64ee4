"""A ball on a vibrating table, which settles on it, rides with it, and is thrown.

The table moves as s = A sin(w t + phi) from its lowest place; a contact of K d carries the ball, so that on the way
m (g + s'') = K d, but for damping, 3e-4 of d here. Where s'' = -g the force is spent, at the speed s' - d': a parabola.
"""

from __future__ import annotations

import math

from hertzwerk.runtime.analysis.hard_cases.case import METHODS, HardCase, Known, Source, final

MASS, RADIUS, STIFFNESS, GRAVITY = 1.0, 0.02, 1e8, 9.81  # kg, m, N/m, m/s^2
PACE = 40 * math.pi  # rad/s
TURN, FLIGHT = 2 * math.pi / PACE, 1 / PACE  # s


def _amplitude(share: float) -> float:
    """Return the amplitude [m] whose largest acceleration is a share of gravity's."""
    return share * GRAVITY / PACE**2


def _riding(share: float) -> tuple[Known, ...]:
    depth = MASS * GRAVITY * (1 + share) / STIFFNESS
    source = "the table's lowest place, less the penetration m (g + A w^2)/K that carries the ball there"
    return (
        final("floor.penetration", depth, 1e-3 * depth, source),
        final("ball.travel", RADIUS - _amplitude(share) - depth, 1e-3 * depth, source),
        final("ball.speed", 0, 1e-6, "that of the table"),
    )


def _thrown(share: float) -> tuple[Known, ...]:
    """Return the parabola from where A w^2 sin(phase) = g."""
    height, pace = GRAVITY / PACE**2, PACE * math.sqrt(_amplitude(share) ** 2 - (GRAVITY / PACE**2) ** 2)
    speed = pace * (1 + MASS * PACE**2 / STIFFNESS)  # the contact opens
    source = "a parabola from where the table's acceleration is -g"
    return (
        final("ball.travel", RADIUS + height + speed * FLIGHT - GRAVITY * FLIGHT**2 / 2, 1e-8, source),
        final("ball.speed", speed - GRAVITY * FLIGHT, 1e-6, source),
    )


CASES = (
    HardCase(
        name="settles_on_a_shaker",
        theme="rest",
        hard="bounces end on a table that vibrates at 0.7 g, and the ball rides with it, a way of 3e-4 m under a penetration of 1e-7 m",
        source=Source("shaken_ball", hard=True),
        duration=6 * TURN,
        tolerance=1e-9,
        methods=METHODS,
        parameters={"amplitude": (_amplitude(0.7), "m"), "restitution": 0.5},
        initial={"ball.travel": (RADIUS - _amplitude(0.7) + 1e-4, "m"), "ball.speed": "0 m/s"},
        known=_riding(0.7),
    ),
    HardCase(
        name="thrown_by_a_shaker",
        theme="rest",
        hard="a table of 1.5 g throws the ball in every period, after it has settled between two throws",
        source=Source("shaken_ball", hard=True),
        duration=(5 * 2 * math.pi + math.pi / 2 + math.asin(1 / 1.5)) / PACE + FLIGHT,
        tolerance=1e-9,
        methods=METHODS,
        parameters={"amplitude": (_amplitude(1.5), "m"), "restitution": 0.5},
        known=_thrown(1.5),
    ),
)
