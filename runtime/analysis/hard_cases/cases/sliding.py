"""Sticking friction: an incline just below and just above the angle of friction, falling chains."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.analysis.hard_cases import closed_forms
from hertzwerk.runtime.analysis.hard_cases.case import EXPLICIT, IMPLICIT, METHODS, HardCase, Known, Source, final
from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import RigidImpact
from hertzwerk.runtime.analysis.rigid_limit.rigid_limit import RigidLimit, rigid_limit

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

G, START, LAYER = 9.81, 0.01, 1e-7
DRIVE = 0.6 * 1.001 * G  # N: of the block of 1 kg and its carriage of 1 g, down an incline of 3 in 4
LOAD = 0.8 * G  # N
CRITICAL = DRIVE / LOAD  # coefficient of friction that just holds
MASS = 1.001


def creep(mu: float) -> float:
    """Return the speed [m/s] at which smoothed friction carries the drive."""
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
        tolerance=1e-7,
        methods=methods,
        parameters={"friction_coefficient": mu, "friction_speed": (LAYER, "m/s"), "speed": (START, "m/s")},
        known=known,
    )


def _accelerated(mu: float, time: float) -> float:
    """Return the speed [m/s] of a block that slides all the time, its smoothed friction saturated."""
    return START + (DRIVE - mu * LOAD) / MASS * time


def _incline(law: str, name: str, hard: str, mu: float, known: tuple[Known, ...], duration: float = 10.0) -> HardCase:
    """Make a case with one coefficient for sliding and rest, so that the angle of friction is unique."""
    parameters: dict[str, Value] = {"friction_coefficient": mu, "static_coefficient": mu, "speed": (START, "m/s")}
    source = Source(f"incline_{law}", hard=True)
    return HardCase(name, "friction", hard, source, duration, 1e-7, parameters=parameters, known=known)


def _way(mu: float) -> float:
    """Return the distance [m] on which the block comes to rest."""
    return START**2 * MASS / (2 * (mu * LOAD - DRIVE))


def _of_corners(
    count: int, quantity: str, of: Callable[[EngineSolution, str, np.ndarray], np.ndarray], within: float, unit: str
) -> Known:
    """Expect the largest value over rows with a touching corner, which Coulomb's law keeps at or below 0."""

    def largest(run: EngineSolution) -> float:
        values = (of(run, f"corner_{i}", run[f"corner_{i}.slip"] == 0) for i in range(count + 1))
        modes = (run[f"corner_{i}.mode"] == 1 for i in range(count + 1))
        return max(float(np.max(value, where=mode, initial=0.0)) for value, mode in zip(values, modes, strict=True))

    return Known(quantity, largest, 0.0, within, unit, "Coulomb's law")


def _falling_chain(count: int, *, long: bool) -> HardCase:
    mu = 0.3
    return HardCase(
        name=f"falling_chain_of_{count}",
        theme="friction",
        hard=f"{count} links fall on a floor and rest nearly in line, {count + 1} corners with set-valued friction: forces all but undetermined",
        source=Source(f"falling_chain_of_{count}", hard=True),
        duration=1.0,
        tolerance=1e-6,
        methods=EXPLICIT if long else METHODS,
        parameters={
            "friction_coefficient": mu,
            "static_coefficient": mu,
            "stiffness": (1e7, "N/m^1.5"),
            "restitution": 0.5,
        },
        known=(
            _of_corners(
                count,
                "friction force above mu N",
                lambda run, corner, _: np.abs(run[f"{corner}.friction_force"]) - mu * run[f"{corner}.normal_force"],
                BEYOND,
                "N",
            ),
            _of_corners(
                count,
                "sliding velocity while sticking",
                lambda run, corner, sticks: np.abs(run[f"{corner}.sliding_velocity"]) * sticks,
                1e-6,
                "m/s",
            ),
            _of_corners(
                count,
                "power of friction",
                lambda run, corner, _: run[f"{corner}.friction_force"] * run[f"{corner}.sliding_velocity"],
                1e-7,
                "W",
            ),
        ),
        long=long,
    )


BEYOND = 0.05  # N, beside a link's weight of 1 N: friction of nearly straight links jumps by this with errors of the contact forces
BRISTLE = 1e7  # 1/m, stiffness of the bristles per normal force
LUGRE_SPEED = 0.0388918036404  # m/s, of a block that slides on them from START, after 0.5 s

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
    _incline(
        "coulomb",
        "incline_holds_coulomb",
        "just below the angle of friction, set-valued friction: slides to a stop, and sticks",
        _HOLDS,
        (
            final("downhill.speed", 0.0, 0.0, "it sticks"),
            final(
                "downhill.travel",
                _way(_HOLDS),
                1e-6 * _way(_HOLDS),
                "uniform deceleration, m v^2/(2 (mu load - drive))",
            ),
        ),
    ),
    _incline(
        "coulomb",
        "incline_slides_coulomb",
        "just above the angle of friction, set-valued friction: never stops",
        _SLIDES,
        (final("downhill.speed", _accelerated(_SLIDES, 10.0), 1e-6, "uniform acceleration, m a = drive - mu load"),),
    ),
    _incline(
        "lugre",
        "incline_holds_lugre",
        "just below the angle of friction, bristles of s0 = 1e7 1/m: slides to a stop, and vibrates on them at 1400 Hz",
        _HOLDS,
        (
            final("downhill.speed", 0.0, 1e-6, "the bristles hold it"),
            final("friction.bristle", -CRITICAL / BRISTLE, 1e-5 * CRITICAL / BRISTLE, "drive = s0 z load", unit="m"),
        ),
        0.5,
    ),
    _incline(
        "lugre",
        "incline_slides_lugre",
        "just above the angle of friction, bristles of s0 = 1e7 1/m: never stops",
        _SLIDES,
        (
            final("downhill.speed", LUGRE_SPEED, 1e-7, "SciPy's Radau, of the three equations"),
            final("friction.bristle", -_SLIDES / BRISTLE, 1e-6 * _SLIDES / BRISTLE, "saturated, mu = s0 z", unit="m"),
        ),
        0.5,
    ),
    _falling_chain(3, long=False),
    _falling_chain(8, long=True),
)


# -- beside the rigid limit ----------------------------------------------------------------------------------------------
# Across the incline a block of 1 kg falls and bounces with the restitution e of every speed: the flights end at t (1 + e)/(1 - e), t the time of
# the first fall. Along it friction has taken by then what it takes of one that slides, as the impulses of impacts and weight are equal.

SOURCE, DURATION, TOLERANCE = Source("incline_coulomb", hard=True), 1.2, 1e-8
E, MU, HEIGHT, SPEED = closed_forms.restitution_out(closed_forms.flores(0.5)), 0.9, 0.1, 1.0
FALL, STRIKES = math.sqrt(2 * HEIGHT / LOAD), math.sqrt(2 * HEIGHT * LOAD)  # s, m/s
BOUNCED = FALL * (1 + E) / (1 - E)  # s
SLOWS = (MU * LOAD - DRIVE) / MASS  # m/s^2
LEFT = SPEED - SLOWS * BOUNCED  # m/s, as the bounces end
WAY = (  # to the end of the bounces, each of whose impacts at t takes MU (1 + E) v (BOUNCED - t) of it, and of the slide
    SPEED * BOUNCED
    + DRIVE / MASS * BOUNCED**2 / 2
    - MU / MASS * 2 * E * STRIKES**2 / LOAD / (1 - E) ** 2
    + LEFT**2 / 2 / SLOWS
)
PARAMETERS: dict[str, Value] = {
    "restitution": 0.5,
    "friction_coefficient": MU,
    "static_coefficient": MU,
    "speed": (SPEED, "m/s"),
}
INITIAL: dict[str, Value] = {"normal.travel": (HEIGHT, "m")}


@cache
def _limit(mu: float) -> RigidLimit:
    """Return the rigid limit, the same beside every method."""
    return rigid_limit(SOURCE.load(), RigidImpact(E, mu), duration=DURATION, parameters=PARAMETERS, initial=INITIAL)


def _of_limit(
    quantity: str, of: Callable[[RigidLimit], float], expected: float, within: float, unit: str, source: str
) -> Known:
    def of_run(run: EngineSolution) -> float:
        return of(_limit(run.settings.parameters["friction_coefficient"][0]))

    return Known(f"rigid: {quantity}", of_run, expected, within, unit, source)


BESIDE_RIGID_LIMIT = (
    HardCase(
        name="incline_bounces_to_rest",
        theme="rigid limit",
        hard="bounces down an incline that accumulate, a slide that stops, beside their rigid limit with its own invariants",
        source=SOURCE,
        duration=DURATION,
        tolerance=TOLERANCE,
        parameters=PARAMETERS,
        initial=INITIAL,
        known=(
            _of_limit("end of bounces", lambda run: run.accumulations[0].t, BOUNCED, 1e-12, "s", "t (1 + e)/(1 - e)"),
            _of_limit("final speed", lambda run: float(run["downhill.speed"][-1]), 0, 0, "m/s", "it sticks"),
            _of_limit("final travel", lambda run: float(run["downhill.travel"][-1]), WAY, 1e-10, "m", "sum of bounces and slide"),
            _of_limit("energy", lambda run: run.balance / run.energy[0], 0, 1e-9, "1", "10 tolerance"),
            _of_limit("rise of energy", lambda run: float(np.diff(run.energy).max()) / run.energy[0], 0, 1e-9, "1", "nothing drives it"),
            _of_limit("depth", lambda run: float(-run.gaps(run.t).min()), 0, 1e-12, "m", "rigid surfaces"),
            _of_limit("not finite", lambda run: float(np.sum(~np.isfinite(run.motion.y))), 0, 0, "1", "states"),
            _of_limit("steps", lambda run: len(run.t) / 134, 1, 0.5, "1", "134 measured"),
            final("downhill.speed", 0, 0, "it sticks"),
            final("downhill.travel", WAY, 5e-5, "the rigid limit, but for the time that impacts last"),
        ),
    ),
)  # fmt: skip
