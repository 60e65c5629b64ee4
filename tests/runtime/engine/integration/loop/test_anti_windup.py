"""Controllers with limits: an independent recursion of the sampled one, an independent integration of the continuous one, what they save."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

J, Kp, Ki, TARGET, LOW, HIGH, PERIOD = 0.02, 0.1, 4.0, 100.0, -1.0, 3.0, 0.01


def p(name, unit, value):
    return hd.Parameter(name, unit, value)


def scene(limit="both", tracking=None, period=None, **fields):
    """Rotor whose torque is the command of a controller."""
    limits = {"both": (p("low", "N m", LOW), p("high", "N m", HIGH)), "one": p("high", "N m", HIGH), None: None}
    times = {"tracking": tracking, "period": period}
    control = hd.SpeedController(
        *("control", "main", p("target", "rad/s", TARGET), p("Kp", "N m s/rad", Kp), p("Ki", "N m/rad", Ki), "N m"),
        limit=limits.get(limit, limit), **{name: value and p(name, "s", value) for name, value in times.items()}, **fields,
    )  # fmt: skip
    rotor = hd.Body("rotor", p("mass", "kg", 1), p("J", "kg m^2", J))
    mechanism = hd.Mechanism("shaft", (hd.Revolute("main", hd.GROUND, rotor, axis=hd.Z),))
    scales = hd.Scales(p("size", "m", 1), p("pace", "m/s", 100), arm=p("arm", "m", 1))
    return hd.Scene(mechanism, (hd.JointForce("drive", "main", control.command), control), scales)


@cache
def run(duration, **how):
    return simulate(load(scene(**how)), duration=duration, tolerance=1e-10, compiled=False)


@pytest.mark.parametrize(("tracking", "limit"), [(None, "both"), (PERIOD, "both"), (0.05, "one"), (None, None)])
def test_a_sampled_one_is_its_recursion(tracking, limit):
    """The rotor between samples is exact: w' = u/J."""
    actual = run(0.7999, tracking=tracking, limit=limit, period=PERIOD)
    low, high = {"both": (LOW, HIGH), "one": (-HIGH, HIGH), None: (-np.inf, np.inf)}[limit]
    w, total, commands, speeds = 0.0, 0.0, [], []
    for _ in range(80):
        e = TARGET - w
        v = Kp * e + Ki * total
        u = min(max(v, low), high)
        back = Kp if tracking is None else Ki * tracking
        commands.append(u)
        speeds.append(w)
        w, total = w + PERIOD * u / J, total + PERIOD * (e + (u - v) / back)
    middle = (np.arange(80) + 0.5) * PERIOD
    assert actual.at(middle)["control.command"] == pytest.approx(commands, rel=1e-7, abs=1e-7)
    expected = np.array(speeds) + PERIOD / 2 * np.array(commands) / J
    assert actual.at(middle)["main.speed"] == pytest.approx(expected, rel=1e-8, abs=1e-6)
    if limit is not None:
        assert HIGH in commands and commands[-1] not in (low, high)


@pytest.mark.parametrize("tracking", [None, 0.2])
def test_a_continuous_one_beside_another_integrator(tracking):
    result = run(1.5, tracking=tracking)

    def rates(t, y):
        e = TARGET - y[0]
        v = Kp * e + Ki * y[1]
        u = np.clip(v, LOW, HIGH)
        return [u / J, e + (u - v) / (Kp if tracking is None else Ki * tracking)]

    t = np.linspace(0, 1.5, 16)
    other = solve_ivp(rates, (0, 1.5), [0, 0], method="Radau", t_eval=t, rtol=1e-10, atol=1e-10, max_step=1e-3)
    assert result.at(t)["main.speed"] == pytest.approx(other.y[0], abs=2e-5)
    assert result.at(t)["control.error"] == pytest.approx(other.y[1], abs=2e-5)


def test_a_command_at_its_limit_does_not_wind_up():
    """Without it the integral goes on to grow while the torque is at its limit, and the speed shoots over."""
    torque = run(1.5)["drive.torque"]
    assert torque.max() == HIGH and torque.min() >= LOW
    over = [run(1.5, tracking=tracking)["main.speed"].max() / TARGET - 1 for tracking in (None, 1e3)]
    assert over[0] < 0.1 < 0.3 < over[1]
    until = TARGET * J / HIGH
    assert run(1.5).at([0.9 * until])["main.speed"][0] == pytest.approx(
        0.9 * TARGET, rel=1e-9
    )  # at the limit throughout


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"limit": p("high", "V", 3)}, "control, limit: found high"), ({"limit": p("high", "N m", -3)}, "limit"),
        ({"limit": (p("low", "N m", 3), p("high", "N m", 1))}, "the least command first"), ({"limit": "3 N m"}, "the largest command, or"),
        ({"limit": (1, 2, 3)}, "the largest command, or"), ({"limit": None, "tracking": 0.1}, "a limit beside it"),
        ({"tracking": -0.1}, "tracking time"),
    ],
)  # fmt: skip
def test_limits_that_are_none_are_refused(fields, message):
    with pytest.raises(hd.InputError, match=message):
        scene(**fields)


def test_without_a_proportional_gain_a_tracking_time_is_requested():
    found = (*("control", "main", p("target", "rad/s", TARGET), 0, p("Ki", "N m/rad", Ki), "N m"),)
    with pytest.raises(hd.InputError, match="a limit without a proportional gain"):
        control = hd.SpeedController(*found, limit=p("high", "N m", HIGH))
        rotor = hd.Body("rotor", p("mass", "kg", 1), p("J", "kg m^2", J))
        hd.Scene(
            hd.Mechanism("shaft", (hd.Revolute("main", hd.GROUND, rotor, axis=hd.Z),)),
            (hd.JointForce("drive", "main", control.command), control),
            scene().scales,
        )
