"""Borderline events: grazing, at t = 0, at output times, at the end; and leaving a law's range."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.analysis.hard_cases.case import METHODS, HardCase, Source, at, contacts, final, impact, on_grid

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value

BALL, GRAZING = Source("bouncing_ball"), Source("grazing_ball", hard=True)
# meets the floor at 0.5 s with 4 m/s, in numbers without rounding
FALLING: dict[str, Value] = {"gravity": "8 m/s^2", "restitution": 1.0}
PARABOLA = "free motion"
FASTEST, LET_GO = 0.009991, 0.485  # m/s; s: when 0.04 (t - t^2) is that


def _speed_let_go(t: float) -> float:
    """Return the speed [m/s] of the tugged ball, whose contact pushes no more from LET_GO on."""
    depth, share = (
        np.polynomial.Polynomial([0.1, 0, -0.02, 0.04 / 3]),
        np.polynomial.Polynomial([1, -0.04 / FASTEST, 0.04 / FASTEST]),
    )
    pushed = (0.01 * depth * share).integ(lbnd=LET_GO)
    return float(0.04 * (t - t * t) - pushed(t))


def _graze(name: str, gap: float, hard: str, count: int) -> HardCase:
    return HardCase(
        name=name,
        theme="events",
        hard=hard,
        source=GRAZING,
        duration=0.25,
        tolerance=1e-10,
        initial={"ball.travel": (0.0625 + gap, "m"), "ball.speed": "-1 m/s"},
        known=(
            contacts(count, "the turning point of the parabola"),
            final("ball.travel", 0.0625 + gap, 1e-12, PARABOLA),
            final("ball.speed", 1.0, 1e-12, PARABOLA),
        ),
    )


CASES = (
    HardCase(
        name="force_ends_for_a_moment",
        theme="events",
        hard="a force falls through zero and returns, while the surfaces overlap, within 30 ms: less than a step",
        source=Source("tugged_ball", hard=True),
        duration=0.85,
        tolerance=1e-9,
        known=(
            impact(0, "duration", LET_GO, 1e-8, "the path's speed is that at which the force runs out"),
            final("ball.speed", _speed_let_go(0.85), 1e-10, "the force that the path takes, without the contact's"),
        ),
    ),
    HardCase(
        name="bench_of_many_lines",
        theme="events",
        hard="a slider's contact leaves fifteen lines and gains the next at 10 m/s, several in a step, and the seams of its own arcs",
        source=Source("faceted_bench", hard=True),
        duration=1.5e-3,
        tolerance=1e-9,
        methods=METHODS,
        known=(
            final("plane.x", 0.017, 1e-12, "nothing brakes it", "m"),
            final("plane.y_speed", 0.0, 1e-9, "its weight is carried by any line", "m/s"),
        ),
    ),
    _graze("graze_above", 1e-12, "turns back 1e-12 m above the floor: no contact", 0),
    _graze("graze_below", -1e-12, "turns back 1e-12 m below the floor: a contact of 1 us", 1),
    HardCase(
        name="event_at_start",
        theme="events",
        hard="touches the floor exactly at t = 0, approaching",
        source=BALL,
        duration=0.5,
        tolerance=1e-8,
        parameters=FALLING,
        initial={"vertical.travel": "0.1 m", "vertical.speed": "-4 m/s"},
        known=(impact(0, "t", 0.0, 0.0, "the start"), contacts(1, "one impact")),
    ),
    HardCase(
        name="opening_at_start",
        theme="events",
        hard="touches the floor exactly at t = 0, separating, and again exactly at the end",
        source=BALL,
        duration=1.0,
        tolerance=1e-8,
        parameters=FALLING,
        initial={"vertical.travel": "0.1 m", "vertical.speed": "4 m/s"},
        known=(final("floor.gap", 0.0, 1e-12, PARABOLA), final("vertical.speed", -4.0, 1e-12, PARABOLA)),
    ),
    HardCase(
        name="event_at_end",
        theme="events",
        hard="meets the floor exactly at the end",
        source=BALL,
        duration=0.5,
        tolerance=1e-8,
        parameters=FALLING,
        known=(final("floor.gap", 0.0, 1e-12, PARABOLA), final("vertical.speed", -4.0, 1e-12, PARABOLA)),
    ),
    HardCase(
        name="event_at_output",
        theme="events",
        hard="meets the floor exactly at an output time",
        source=BALL,
        duration=0.75,
        tolerance=1e-8,
        parameters=FALLING,
        known=(
            at(0.5, "floor.gap", 0.0, 1e-12, PARABOLA),
            at(0.5, "vertical.speed", -4.0, 1e-12, PARABOLA),
            on_grid(FALLING, (0.0, 0.25, 0.5, 0.75), 2, "floor.gap", 0.0, 1e-12, PARABOLA),
            on_grid(FALLING, (0.0, 0.25, 0.5, 0.75), 2, "vertical.speed", -4.0, 1e-12, PARABOLA),
            impact(0, "t", 0.5, 1e-12, PARABOLA),
        ),
    ),
    HardCase(
        name="law_left",
        theme="events",
        hard="a crank longer than its rod pulls the pin out of its bush: the contact law is not defined so deep",
        source=Source("slider_crank_frictionless"),
        duration=0.024,
        tolerance=1e-6,
        parameters={"crank_radius": "0.13 m"},
        outcome="outside_law_range",
    ),
)
