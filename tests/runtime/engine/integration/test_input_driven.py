"""Runs driven by inputs: exact discretisation, expressions of the time, every method, contacts, events, both coordinates."""

import math
import pickle
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from shaken import exact, shaken

import hertzwerk.derive as hd
from hertzwerk.derive.scenes.slider_crank import scene as crank
from hertzwerk.runtime import Samples, simulate
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(6)  # methods and coordinates that run the same code

RNG = np.random.default_rng(5)
TIMES = np.concatenate([[0.0], np.cumsum(RNG.uniform(0.01, 0.3, 12))])
VALUES = RNG.normal(size=13)
END = float(TIMES[-1])


@pytest.mark.parametrize("held", [True, False])
@pytest.mark.parametrize("method", ["auto", "dopri5", "esdirk", "rodas", "cvodes"])
def test_samples_are_met_as_by_exact_discretisation(method, held):
    samples = Samples(TIMES, VALUES, ("s", "N"), "held" if held else "linear")
    run = simulate(shaken(), duration=END, tolerance=1e-12, method=method, inputs={"push": samples})
    at = run.engine.history.at(TIMES)
    actual = np.column_stack([at["slide.travel"], at["slide.speed"]])
    assert np.max(np.abs(actual - exact(TIMES, VALUES, held=held))) < (1e-9 if method == "cvodes" else 1e-10)
    assert run.energy_residual < 1e-8
    assert set(TIMES) <= set(run.t)  # to the bit
    power = np.interp(TIMES[:-1], TIMES, VALUES) * at["slide.speed"][:-1]
    np.testing.assert_allclose(run.engine.history.at(TIMES[:-1])["motor.power"], power, atol=1e-9)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_both_coordinates_move_alike(coordinates):
    samples = Samples(TIMES, VALUES, ("s", "N"), "held")
    run = simulate(shaken(coordinates), duration=END, tolerance=1e-11, inputs={"push": samples})
    assert run["slide.travel"][-1] == pytest.approx(exact(TIMES, VALUES, held=True)[-1, 0], abs=1e-9)


@pytest.mark.parametrize(("method", "order"), [("dopri5", 5), ("rodas", 4), ("esdirk", 5)])
def test_breakpoints_leave_the_order_of_a_method(method, order):
    """Error against steps, at falling tolerance: a step across a jump would leave order 1."""
    samples = Samples(TIMES, 30 * VALUES, ("s", "N"), "held")
    end = exact(TIMES, 30 * VALUES, held=True)[-1, 0]
    errors, steps = [], []
    for tolerance in (1e-5, 1e-9):
        run = simulate(shaken(), duration=END, tolerance=tolerance, method=method, inputs={"push": samples})
        errors.append(abs(run["slide.travel"][-1] - end))
        steps.append(run.statistics.steps - len(TIMES))
    assert math.log(errors[0] / errors[1]) / math.log(steps[1] / steps[0]) > order - 1.5


TORQUE = hd.Input("torque", "N m", "of the motor on the crank")


@cache
def driven_crank(coordinates, by_input):
    """Slider-crank with a pin in its bush, whose crank a torque 20 N m sin(800 t/s) drives."""
    value = TORQUE if by_input else hd.Parameter("M", "N m", 20) * sp.sin(hd.Parameter("rate", "rad/s", 800) * hd.T)
    effects = tuple(
        hd.JointForce("motor", "main_bearing", value) if e.name == "crank_drive" else e for e in crank.effects
    )
    start = replace(crank.start, speed={"main_bearing": crank.parameters["crank_speed"], **crank.start.speed})
    return engine_model(replace(crank, effects=effects, start=start).with_coordinates(coordinates))


@pytest.mark.parametrize("coordinates", ["tree", pytest.param("absolute", marks=pytest.mark.slow)])
def test_a_crank_moves_as_by_the_same_torque_as_an_expression(coordinates):
    given = {"torque": lambda t: 20 * math.sin(800 * t)}
    other = simulate(driven_crank(coordinates, False), duration="6 ms", accuracy=1e-7)
    run = simulate(driven_crank(coordinates, True), duration="6 ms", accuracy=1e-7, inputs=given)
    assert run.outcome.finished and len(run.impacts) == len(other.impacts) > 5
    scale = run.engine.scales.state[: run.engine.model.nq + run.engine.model.nu]
    ends = (each.engine.history.part("y")[-1][: len(scale)] for each in (run, other))
    assert np.max(np.abs(np.subtract(*ends)) / scale) < 1e-6
    assert run.energy_residual < 1e-7
    np.testing.assert_array_equal(run["torque"], run["motor.torque"])


def test_a_run_goes_on_and_is_made_again_to_the_bit():
    held = Samples(np.linspace(0, 20, 200), 20 * np.sin(np.arange(200)), ("ms", "N m"), "held")
    short = simulate(driven_crank("tree", True), duration="2 ms", tolerance=1e-8, inputs={"torque": held})
    whole = simulate(short.engine.model, duration="4 ms", tolerance=1e-8, compiled=False)
    rest = short.continued("4 ms", compiled=False)
    for name in ("t", "y"):  # it may begin where a piece does, after the row that ends the piece before
        np.testing.assert_array_equal(whole.engine.history.part(name)[-len(rest.t) :], rest.engine.history.part(name))
    again = simulate(pickle.loads(pickle.dumps(short.engine.model)), duration="2 ms", tolerance=1e-8)
    np.testing.assert_array_equal(again.engine.history.rows, short.engine.history.rows)
    grid = simulate(short.engine.model, duration="2 ms", tolerance=1e-8, grid=101)
    np.testing.assert_array_equal(with_steps(grid).engine.history.rows, short.engine.history.rows)


def _shaft(*effects):
    rotor = hd.Body("rotor", hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1e-3))
    scales = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", 100), hd.Parameter("arm", "m", 1))
    shaft = hd.Mechanism("shaft", (hd.Revolute("main", hd.GROUND, rotor, axis=hd.Z),))
    return hd.Scene(shaft, (*effects, hd.EnergyLedger()), scales)


def test_a_motor_at_a_measured_voltage_and_a_controller_with_a_set_point_that_steps():
    gains = hd.Parameter("Kp", "V s/rad", 0.5), hd.Parameter("Ki", "V/rad", 5)
    control = hd.SpeedController("control", "main", hd.Input("target", "rpm"), *gains, unit="V")
    values = hd.Parameter("R", "ohm", 2), hd.Parameter("L", "mH", 5), hd.Parameter("k", "N m/A", 0.1)
    motor = hd.DCMotor("motor", "main", control.command + hd.Input("noise", "V"), *values)
    target = Samples((0, 0.5, 2), (1000, 2000, 2000), ("s", "rpm"), "held")
    run = simulate(
        engine_model(_shaft(motor, control)), duration="2 s", accuracy=1e-6, inputs={"target": target, "noise": "0 V"}
    )
    at = run.engine.history.at(np.array([0.49, 2.0]))["main.speed"] * 30 / math.pi
    assert at == pytest.approx([1000, 2000], rel=2e-3) and run.energy_residual < 1e-6


def test_an_input_that_jumps_switches_a_relay_there():
    sizes = {"hysteresis": hd.Parameter("band", "mm", 1), "size": hd.Parameter("width", "m", 1)}
    relay = hd.Relay("relay", hd.Input("signal", "m"), unit="m", **sizes)
    jets = hd.JointForce("jets", "main", hd.Parameter("thrust", "N m", 1e-3) * relay.output)
    model = engine_model(_shaft(relay, jets))
    for between in ("held", "linear"):
        signal = Samples((0, 0.25, 0.5, 1.1), (-1, 1, -1, -1), ("s", "m"), between)
        run = simulate(model, duration="1 s", tolerance=1e-9, inputs={"signal": signal})
        changes = run.t[1:][np.diff(run["relay.output"]) != 0]
        expected = [0.25, 0.5] if between == "held" else [0.125125, 0.375125]
        assert changes == pytest.approx(expected, abs=1e-9)


def test_a_prescribed_acceleration_is_integrated():
    block = hd.Body("block", hd.Parameter("mass", "kg", 2))
    scales = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", 1))
    table = hd.Mechanism("table", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),))
    drive = hd.Drive("shaker", "slide", acceleration=hd.Input("felt", "m/s^2"))
    other = hd.Prismatic("top", block, hd.Body("load", hd.Parameter("load", "kg", 1)), axis=hd.X)
    scene = hd.Scene(replace(table, joints=(*table.joints, other)), (drive, hd.EnergyLedger()), scales)
    run = simulate(engine_model(scene), duration="2 s", tolerance=1e-10, inputs={"felt": ((0, 1, 2), (0, 3, 0))})
    assert run["slide.speed"][-1] == pytest.approx(3, abs=1e-9)
    assert run["slide.travel"][-1] == pytest.approx(3, abs=1e-9)  # 1/2 + 3/2 + 1
