"""A rigid block on two corners with set-valued friction, which share what holds it; one is struck."""

from __future__ import annotations

import math

from hertzwerk.runtime.hard_cases.case import HardCase, Known, Source, impact

MASS, WIDTH, HEIGHT, TILT, G = 7.0, 0.1, 0.6, 0.08, 9.81
RADIUS, SLENDER = math.hypot(WIDTH, HEIGHT) / 2, math.atan2(WIDTH, HEIGHT)
FALLEN = MASS * G * RADIUS * (math.cos(SLENDER - TILT) - math.cos(SLENDER))  # J
TURNING = math.sqrt(2 * FALLEN / (4 / 3 * MASS * RADIUS**2))  # rad/s about the corner it stands on
KEPT = 1 - 1.5 * math.sin(SLENDER) ** 2  # of that in a plastic impact

CASES = (
    HardCase(
        name="rocking_block",
        theme="friction",
        hard="rounding of the gap changes the force of the struck corner, of strong damping, by more than the tolerance",
        source=Source("rocking_block", hard=True),
        duration=0.35,
        tolerance=1e-7,
        parameters={"friction_coefficient": 0.8, "static_coefficient": 0.8, "restitution": 0.1},
        known=(
            impact(1, "speed", WIDTH * TURNING, 2e-5 * WIDTH * TURNING, "energy"),
            Known(
                "energy lost",
                lambda run: float(run["energy"][0] - run["energy"][-1]),
                FALLEN * (1 - KEPT**2),
                1e-4 * FALLEN,
                "J",
                "Housner 1963",
            ),
        ),
    ),
)
