"""Inputs as the motion of a drive: a crank by samples of its closed law, a measured speed, and what is too rough for either."""

from functools import cache

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import hertzwerk.derive as hd
from hertzwerk.derive.scenes.slider_crank import scene
from hertzwerk.runtime import Samples, equilibrium, load, simulate

SPEED = scene.parameters["crank_speed"].si
HOW = {"duration": "3 ms", "tolerance": 1e-11, "compiled": False}
ANGLE, RATE = hd.Input("crank", "deg", "encoder"), hd.Input("crank_rate", "rpm", "tachometer")


@cache
def driven(coordinates="tree", **motion):
    """Slider-crank whose crank follows an input, inputs by their names."""
    return load(
        scene.replace(crank_drive=hd.Drive("crank_drive", "main_bearing", **motion)).with_coordinates(coordinates)
    )


@cache
def closed(coordinates="tree", method="dop853"):
    """Its run at the scene's constant speed."""
    return simulate(
        load("slider_crank", coordinates=coordinates if coordinates != "tree" else None), method=method, **HOW
    )


def encoder(between="cubic"):
    t = np.linspace(0, 6e-3, 31)
    return Samples(1e3 * t, np.degrees(SPEED * t), ("ms", "deg"), between)


def tachometer(between="cubic"):
    return Samples((0, 2, 3, 6), (SPEED,) * 4, ("ms", "rad/s"), between)


def agree(run, other, tolerance):
    assert len(run.impacts) == len(other.impacts) > 3
    for name in other.engine.final:
        scale = np.abs(other[name]).max()
        assert abs(run.engine.final[name] - other.engine.final[name]) <= tolerance * scale, name


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_samples_of_the_closed_law_turn_the_crank_as_it_does(coordinates):
    run = simulate(driven(coordinates, position=ANGLE), inputs={"crank": encoder()}, **HOW)
    agree(run, closed(coordinates), 1e-9)
    work = closed(coordinates)["energy_ledger.input"]
    assert run["energy_ledger.input"][-1] == pytest.approx(work[-1], rel=1e-9)


@pytest.mark.parametrize(
    "given",
    [lambda t: np.degrees(SPEED * t), hd.Table("law", (0, 3, 7), (0, 3e-3 * SPEED, 7e-3 * SPEED), ("ms", "rad"))],
)
def test_functions_and_tables_turn_it_too(given):
    agree(simulate(driven(position=ANGLE), inputs={"crank": given}, **HOW), closed(), 1e-7)


def test_a_measured_speed_is_integrated():
    model = driven(speed=RATE, start=0)
    agree(simulate(model, inputs={"crank_rate": tachometer()}, **HOW), closed(), 1e-8)
    t = np.linspace(0, 6e-3, 13)
    rpm = 5000 + 600 * np.sin(900 * t)
    run = simulate(model, inputs={"crank_rate": Samples(t, rpm, ("s", "rpm"), "cubic")}, **HOW)
    exact = CubicSpline(t, rpm * 2 * np.pi / 60).antiderivative()
    assert run["main_bearing.angle"] == pytest.approx(exact(run.t) - exact(0), abs=1e-9)
    assert abs(run.energy_residual) < 1e-8


@cache
def shaken_table():
    """Block that moves by an expression of an input, with the force that this takes, and a rider on a spring."""
    block, rider = hd.Body("block", hd.Parameter("m", "kg", 2)), hd.Body("rider", hd.Parameter("m_rider", "kg", 1))
    lift = hd.Parameter("gain", "1/m", 3) * hd.Input("sway", "m") ** 2
    joints = (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X), hd.Prismatic("seat", block, rider, axis=hd.X))
    spring = hd.JointSpring("spring", "seat", hd.Parameter("k", "N/m", 40), rest=hd.Parameter("rest", "m", 0.5))
    scales = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", 1))
    effects = (hd.Drive("shaker", "slide", position=lift), spring, hd.EnergyLedger())
    return load(
        hd.Scene(
            hd.Mechanism("table", joints), effects, scales, start=hd.Start(position={"seat": 0.5 * hd.Parameter("one", "m", 1)}),
        )
    )  # fmt: skip


def test_forces_follow_from_the_second_derivative():
    t = np.linspace(0, 1, 8)
    values = 0.1 + np.sin(3 * t)
    run = simulate(
        shaken_table(), duration="1 s", tolerance=1e-9, inputs={"sway": Samples(t, values, ("s", "m"), "cubic")}
    )
    s = CubicSpline(t, values)
    assert run["slide.travel"] == pytest.approx(3 * s(run.t) ** 2, rel=1e-12)
    assert run["slide.speed"] == pytest.approx(6 * s(run.t) * s(run.t, 1), rel=1e-9, abs=1e-9)
    force = 2 * (6 * s(run.t, 1) ** 2 + 6 * s(run.t) * s(run.t, 2)) - 40 * (run["seat.travel"] - 0.5)
    assert run["shaker.force"] == pytest.approx(force, rel=1e-8, abs=1e-7)


def kinked(t):
    return np.degrees(SPEED * (t + abs(t - 2.5e-3)))  # at an end of a piece


@pytest.mark.parametrize(
    ("motion", "given", "message"),
    [
        ("position", encoder("linear"), "31 values, linear: its rate jumps from piece to piece; expected values with two continuous derivatives"),
        ("position", encoder("held"), "held: the value jumps"),
        ("position", kinked, "kinked, sampled in .*: its rate jumps"),
        ("position", lambda t: np.degrees(SPEED * (t + abs(t - 2.4e-3))), "its rate jumps"),
        ("position", lambda t: np.degrees(SPEED * t + 1e4 * abs(t - 2.5e-3) * (t - 2.5e-3)), "its second derivative jumps"),
        ("position", lambda t: 0 if t < 2e-3 else 1, "the value jumps"),
        ("position", "10 N", "10 N"),
        ("speed", Samples((0, 1, 6), (5000, 5100, 5000), ("ms", "rpm")), "its rate jumps.*one continuous derivative"),
        ("speed", tachometer("held"), None),  # of equal values: one piece
        ("speed", "5000 rpm", None),
        ("acceleration", Samples((0, 1, 6), (0, 50, 0), ("ms", "rad/s^2"), "held"), None),
    ],
)  # fmt: skip
def test_a_motion_that_is_too_rough_is_refused_with_the_reason(motion, given, message):
    symbol = {"position": ANGLE, "speed": RATE, "acceleration": hd.Input("crank_acceleration", "rad/s^2")}[motion]
    how = {"duration": "5 ms", "tolerance": 1e-6, "max_steps": 5, "inputs": {symbol.name: given}}
    if message is None:
        assert len(simulate(driven(**{motion: symbol}), **how).t)
        return
    with pytest.raises(hd.InputError, match=message):
        simulate(driven(**{motion: symbol}), **how)


def test_a_held_drive_stands_where_its_input_is_and_has_no_revolutions():
    rest = equilibrium(shaken_table(), inputs={"sway": Samples((0, 1, 2), (1, 2, 1), ("s", "m"), "cubic")}, at="1 s")
    assert rest.converged and rest["seat.travel"][0] == pytest.approx(0.5)
    assert simulate(shaken_table(), duration="1 s", tolerance=1e-6, inputs={"sway": "2 m"})["slide.travel"][0] == 12
    with pytest.raises(hd.InputError, match="one drive of constant speed"):
        simulate(driven(position=ANGLE), duration="1 rev", inputs={"crank": encoder()}, tolerance=1e-6)
