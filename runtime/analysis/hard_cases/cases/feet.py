"""Blocks that rock or stand corner over corner, feet sliding two ways, lift-off, a still knife edge."""

from __future__ import annotations

import math

from hertzwerk.runtime.analysis.hard_cases.case import EXPLICIT, HardCase, Known, Source, final, impact

MASS, G, MU, SPEED = 1.0, 9.81, 0.5, 0.3
SLIDES = math.hypot(SPEED, SPEED)  # m/s
LEAST, HILL, BALL = math.cos(0.1), 1.0, 0.02
BLOCK, WIDTH, HEIGHT, TILT = 7.0, 0.1, 0.6, 0.08
RADIUS, SLENDER = math.hypot(WIDTH, HEIGHT) / 2, math.atan2(WIDTH, HEIGHT)
FALLEN = BLOCK * G * RADIUS * (math.cos(SLENDER - TILT) - math.cos(SLENDER))  # J
TURNING = math.sqrt(2 * FALLEN / (4 / 3 * BLOCK * RADIUS**2))  # rad/s about the corner it stands on
HOUSNER_RATIO = 1 - 1.5 * math.sin(SLENDER) ** 2  # of that in a plastic impact

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
                FALLEN * (1 - HOUSNER_RATIO**2),
                1e-4 * FALLEN,
                "J",
                "Housner 1963",
            ),
        ),
    ),
    HardCase(
        name="boxes_corner_over_corner",
        theme="friction",
        hard="four corners at two places to within rounding, all stuck, carry a box: forces not determined but by compliance",
        source=Source("aligned_boxes", hard=True),
        duration=0.2,
        tolerance=1e-6,
        parameters={"friction_coefficient": MU, "static_coefficient": MU, "restitution": 0.2},
        known=(
            final("high_move.y", 0.15 - MASS * G / 4e6 - 2 * MASS * G / 2e6, 2e-8, "statics", "m"),
            final("high_move.angle", 0.0, 1e-9, "symmetry", "rad"),
            final("stack_1.normal_force", MASS * G / 4, 1e-2, "statics: each of the four the same", "N"),
        ),
    ),
    HardCase(
        name="table_slides_to_rest",
        theme="friction",
        hard="four feet in two directions stop at once, and hold what is left at the cone's edge",
        source=Source("sliding_table", hard=True),
        duration=0.15,
        tolerance=1e-6,
        methods=EXPLICIT,
        parameters={"friction_coefficient": MU, "static_coefficient": MU, "restitution": 0.1, "speed": (SPEED, "m/s")},
        known=(
            final("move.x", SPEED * SLIDES / (2 * MU * G), 1e-5, "v^2/(2 mu g) along the way", "m"),
            final("move.z", SPEED * SLIDES / (2 * MU * G), 1e-5, "v^2/(2 mu g) along the way", "m"),
            final("move.x_speed", 0.0, 1e-7, "it sticks", "m/s"),
        ),
    ),
    HardCase(
        name="rolling_beyond_lift_off",
        theme="constraints on speeds",
        hard="the normal force of what rolls falls through zero, and pulls",
        source=Source("ball_over_ball", hard=True),
        duration=1.6,
        tolerance=1e-8,
        known=(
            Known(
                "normal force against 17 cos - 10 cos(start)",
                lambda run: float(
                    abs(
                        run["rolls.normal_force"] - MASS * G * (17 * run["ride.y"] / (HILL + BALL) - 10 * LEAST) / 7
                    ).max()
                ),
                0.0,
                1e-4,
                "N",
                "energy: it would part at 10/17 of the height",
            ),
            Known(
                "least normal force is a pull",
                lambda run: float(run["rolls.normal_force"].min() < 0),
                1.0,
                0.0,
                "1",
                "it goes on rolling",
            ),
        ),
    ),
    HardCase(
        name="knife_edge_at_no_speed",
        theme="constraints on speeds",
        hard="a sleigh let go on a slope, its mass centre above its edge: no speed shows the edge which way to run",
        source=Source("resting_sleigh", hard=True),
        duration=0.5,
        tolerance=1e-8,
        known=(
            final("move.x", 0.0, 1e-9, "it heads down the line of slope", "m"),
            final("move.y_speed", -5 * 0.5, 1e-7, "free fall along its edge", "m/s"),
            final("skate.side_force", 0.0, 1e-6, "nothing pushes across", "N"),
        ),
    ),
)
