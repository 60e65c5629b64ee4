"""Sticking at the edge of the cone of friction, slips just before lift-off, repeated resistances."""

from __future__ import annotations

import math

import numpy as np

from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Known, Source, final, impact, largest
from hertzwerk.runtime.analysis.hard_cases.closed_forms import damping_ratio, oscillator, peak_of_oscillator
from hertzwerk.runtime.engine.solution.solution import EngineSolution

MU, G, RATE, BEYOND = 0.5, 9.81, 20.0, 1.05
CIRCLE = MU * G * math.sqrt(BEYOND**2 - 1) / RATE  # m/s
HELD = "friction holds all up to mu N, whichever way"
STICKS = "normal motion alone, by SciPy to 1e-13: rolling needs m g sin(tilt) J/(J + m R^2), friction holds mu N"
PULLING = "mu times what the force gives until it is zero: Schwager, Poeschel, Granular Matter 9 (2007) 465"
ORACLE = "the oracle of a body on a plane, in quadruple precision"
PRESSED = 0.2 * (1 + oscillator(1e6, 1.0, damping_ratio(0.5), pulls=False)[0])  # m/s
INERTIA, DRILLING, ROLLING, SPIN, ROLL = 0.4 * 0.02**2, 2e-3, 1e-3, 40.0, 21.0  # per mass


def _spin_left(run: EngineSolution) -> float:
    """Return how far angular speeds are off what the normal force has left of them [rad/s]."""
    pressed = run["flight.y_speed"] - run["flight.y_speed"][0] + G * run.t
    spin, roll = (np.maximum(start - arm / INERTIA * pressed, 0) for start, arm in ((SPIN, DRILLING), (ROLL, ROLLING)))
    speed = np.sqrt(sum(run[f"flight.angular_speed_{axis}"] ** 2 for axis in "xyz"))
    return float(np.abs(np.hypot(spin, roll) - speed).max())


def _first_slip_after_stick(run: EngineSolution) -> float:
    """Return the time [s] at which the floor first slips after it stuck, while it touches."""
    slips, touches = np.abs(run["floor.slip"]) > 0, run["floor.normal_force"] > 0
    rows = np.flatnonzero(~slips[:-1] & slips[1:] & touches[:-1])
    return float(run.t[rows[0] + 1]) if len(rows) else float("nan")


def _slips_at(expected: float, within: float, source: str = STICKS) -> Known:
    return Known("onset of slip", _first_slip_after_stick, expected, within, "s", source)


def _peaks_beside_their_speeds(run: EngineSolution) -> float:
    """Return how far peak forces are off those by their approach speeds, at most, as a part."""
    K, m, rate, tilt, g = (
        run.settings.parameters[name][0] for name in ("stiffness", "mass", "damping_rate", "tilt", "gravity")
    )
    load = m * g * math.cos(tilt)
    return max(abs(each.peak_force / peak_of_oscillator(K, m, rate * m, each.speed, load) - 1) for each in run.impacts)


CASES = (
    HardCase(
        name="load_turns_on_the_cone",
        theme="friction",
        hard="a load of exactly mu N turns three times round the cone: to within rounding it is held, and may not creep",
        source=Source("turning_load", hard=True),
        duration=1.0,
        tolerance=1e-8,
        known=(
            final("x.travel", 0.0, 1e-12, HELD),
            final("z.travel", 0.0, 1e-12, HELD),
            largest("floor.slip", 0.0, 0.0, HELD, "1"),
            Known(
                "force held",
                lambda run: float(np.abs(run["floor.friction_force"]).max()),
                MU * G,
                1e-12,
                "N",
                "all of mu N",
            ),
        ),
    ),
    HardCase(
        name="load_turns_beyond_the_cone",
        theme="friction",
        hard="a load 5 % beyond mu N lets go at a speed of zero, where the direction of friction turns at once, and ends on a circle",
        source=Source("turning_load", hard=True),
        duration=6.0,
        tolerance=1e-8,
        parameters={"share": BEYOND},
        known=(
            Known(
                "final speed",
                lambda run: math.hypot(run["x.speed"][-1], run["z.speed"][-1]),
                CIRCLE,
                1e-7 * CIRCLE,
                "m/s",
                "on a circle m v w and mu N are the load's components",
            ),
        ),
    ),
    HardCase(
        name="bounces_with_resistances",
        theme="friction",
        hard="a spinning ball bounces to rest: resistances to spin and rolling end, and hold, in one of six impacts each",
        source=Source("spun_ball", hard=True),
        duration=1.5,
        tolerance=1e-8,
        known=(
            Known(
                "angular speed",
                _spin_left,
                0.0,
                1e-9,
                "rad/s",
                "what the impulse of the normal force, m v + m g t, leaves of it",
            ),
            *(final(f"flight.angular_speed_{axis}", 0.0, 1e-12, "held", "rad/s") for axis in "xyz"),
        ),
    ),
    HardCase(
        name="slips_before_lift_off_in_space",
        theme="friction",
        hard="slip begins 50 us before a ball lifts off, in two directions, where the force that holds falls to the one needed",
        source=Source("ball_on_diagonal", hard=True),
        duration=0.4,
        tolerance=1e-10,
        known=(_slips_at(0.2208738910664, 1e-10), impact(0, "t", 0.2162083234280, 1e-12, "free fall")),
    ),
    HardCase(
        name="slips_before_lift_off_beside_wall",
        theme="friction",
        hard="slip begins 1.2 us before a ball lifts off: in the last two per cent of a step, where its end is moved to the surface",
        source=Source("ball_beside_wall", hard=True),
        duration=0.55225,
        tolerance=1e-8,
        known=(_slips_at(0.1024180826476, 1e-8), impact(0, "t", 0.0986560487228, 1e-11, "free fall")),
    ),
    HardCase(
        name="slides_until_its_law_pulls",
        theme="friction",
        hard="friction ends within a contact, where a damped spring begins to pull: a kink that estimates of error may not see",
        source=Source("ball_that_is_held_back", hard=True),
        duration=0.01,
        tolerance=1e-10,
        known=(
            final("flight.x_speed", 3 - PRESSED, 1e-10, PULLING, "m/s"),
            final("flight.angle_speed", -50 * PRESSED, 5e-9, PULLING, "rad/s"),
            final("flight.y_speed", 0.5, 1e-9, "restitution of a damped oscillator"),
        ),
    ),
    HardCase(
        name="peak_beside_a_landing",
        theme="friction",
        hard="slip ends in steps of rounding next to the crest of a normal force: the largest value at a step is not the peak",
        source=Source("ball_down_a_slope", hard=True),
        duration=0.45,
        tolerance=5e-12,
        initial={
            "flight.x": (-0.02653598513519498, "m"),
            "flight.y": (0.07558264452927654, "m"),
            "flight.angle": (-2.3358889477510963, "rad"),
            "flight.x_speed": (1.2004105223444346, "m/s"),
            "flight.y_speed": (0.4214469601513484, "m/s"),
            "flight.angle_speed": (5.158262567359465, "rad/s"),
        },
        known=(
            Known(
                "error of peak forces",
                _peaks_beside_their_speeds,
                0.0,
                1e-9,
                "1",
                "a damped oscillator under a constant load",
            ),
        ),
    ),
    HardCase(
        name="slips_as_it_rolls_off_centre",
        theme="friction",
        hard="a ball that rolls begins to slip in space: the direction of sliding turns without bound where its speed is none",
        source=Source("ball_off_centre", hard=True),
        duration=0.19,
        tolerance=1e-9,
        initial={
            "flight.x": (0.003410755833124888, "m"),
            "flight.y": (-0.0012228502829565325, "m"),
            "flight.z": (0.012507743798069354, "m"),
            "flight.q0": (0.16072528718880816, "1"),
            "flight.q1": (-0.06850562223256233, "1"),
            "flight.q2": (-0.4355627897800884, "1"),
            "flight.q3": (-0.8830398733577047, "1"),
            "flight.x_speed": (0.33712249964381724, "m/s"),
            "flight.y_speed": (-0.13120484113195052, "m/s"),
            "flight.z_speed": (-0.03943186895467998, "m/s"),
            "flight.angular_speed_x": (-37.56976550773186, "rad/s"),
            "flight.angular_speed_y": (17.99465719733164, "rad/s"),
            "flight.angular_speed_z": (-39.34432363220953, "rad/s"),
        },
        known=(
            _slips_at(0.14683035198444438, 1e-9, ORACLE),
            final("flight.x", 0.060854060358704117, 1e-9, ORACLE, "m"),
        ),
    ),
)
