"""Balls and wheels that roll and spin to rest under resistance fed by the normal force, against closed forms."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from balls import GRAVITY, MASS, RADIUS, ball, brake, dry

from hertzwerk.derive import DrillingResistance, InputError, Parameter, RollingResistance, generate
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(4)  # methods and coordinates that run the same code

ARM, PATCH, LAYER, MU = 3e-4, 1e-4, 1e-2, 0.2  # m, m, rad/s, 1
DRILL = 3 * math.pi / 16 * MU * PATCH  # m, of Hertz's pressure
LAWS = {"coulomb": dry(MU), "smooth": smooth_coulomb(Parameter("mu_k", "1", MU), Parameter("v_s", "m/s", 1e-4))}
METHODS = ("dop853", "auto")


def rolling():
    return RollingResistance("rolling", "floor", Parameter("arm", "mm", 1e3 * ARM), Parameter("layer", "rad/s", LAYER))


def drilling():
    hertz = 3 * sp.pi / 16 * Parameter("mu_k", "1", MU) * Parameter("patch", "mm", 1e3 * PATCH)
    return DrillingResistance("drilling", "floor", hertz, Parameter("layer", "rad/s", LAYER))


def scene(law, *more, **coordinates):
    found = ball(LAWS[law], **coordinates)
    return replace(found, effects=(*found.effects, *more))


@cache
def model(law, coordinates="tree"):
    return engine_model(scene(law, rolling(), drilling(), coordinates=coordinates))


def way(speed, rate):
    """Angle until rest [rad] of w' = -rate w/sqrt(w^2 + w0^2): half of w sqrt(w^2 + w0^2) + w0^2 asinh(w/w0), by the rate."""
    return (speed * math.hypot(speed, LAYER) + LAYER**2 * math.asinh(speed / LAYER)) / (2 * rate)


# ---- rolling ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize(("law", "method"), [("coulomb", "dop853"), ("coulomb", "auto"), ("smooth", "rodas")])
def test_a_ball_rolls_to_rest(law, method, coordinates):
    """c g/(r (1 + 2/5)) brakes it, wherever it rolls to: after v^2/(2 a) it rests; the heat is its energy."""
    speed, heading = 0.2, math.radians(30)
    x, z = speed * math.cos(heading), speed * math.sin(heading)
    start = {"v_x": x, "v_z": z, "w_z": -x / RADIUS, "w_x": z / RADIUS}
    given = {name: f"{value!r} {'m/s' if name[0] == 'v' else 'rad/s'}" for name, value in start.items()}
    rate = ARM * GRAVITY / (RADIUS * 1.4)
    run = simulate(model(law, coordinates), duration="3.2 s", method=method, tolerance=1e-7, parameters=given)
    left = math.hypot(run.engine.final["flight.angular_speed_x"], run.engine.final["flight.angular_speed_z"])
    actual = np.array([run.engine.final["flight.x"], run.engine.final["flight.z"]])
    expected = RADIUS * (way(speed / RADIUS, rate / RADIUS) - way(left, rate / RADIUS))
    assert left < LAYER / 10  # v/a is 2.9 s
    assert expected == pytest.approx(speed**2 / (2 * rate), rel=1e-4)
    assert actual == pytest.approx(expected * np.array([math.cos(heading), math.sin(heading)]), rel=3e-5)
    assert run.engine.final["rolling.dissipated"] == pytest.approx(0.7 * MASS * speed**2, rel=1e-4)
    assert run.engine.final["drilling.dissipated"] == pytest.approx(0, abs=1e-10)
    assert run.energy_residual < 1e-6


def test_below_the_angle_of_repose_it_creeps_and_above_it_rolls_off():
    """tan(slope) < c/r: it is held but for the smoothing, w0 s/sqrt(1 - s^2) with s = r tan(slope)/c.

    Above with g (sin - c/r cos)/(1 + 2/5), but for what the smoothing lets off at the start.
    """
    for share in (0.5, 0.9):
        slope = math.atan(share * ARM / RADIUS)
        run = simulate(model("coulomb"), duration="1 s", tolerance=1e-8, parameters={"slope": slope})
        creeps = -LAYER * share / math.sqrt(1 - share**2)
        assert run.engine.final["flight.angular_speed_z"] == pytest.approx(creeps, rel=1e-5)
    slope = math.atan(2 * ARM / RADIUS)
    run = simulate(model("coulomb"), duration="1 s", tolerance=1e-8, parameters={"slope": slope})
    rate = GRAVITY * (math.sin(slope) - ARM / RADIUS * math.cos(slope)) / 1.4
    assert run.engine.final["flight.x_speed"] == pytest.approx(rate, rel=5 * LAYER * RADIUS / rate)


# ---- spin ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_a_ball_spins_to_rest(method):
    """Its spin falls by c N/I each second; it stays where it is."""
    rate = DRILL * MASS * GRAVITY / (0.4 * MASS * RADIUS**2)
    spin = rate / 2  # 1 s to rest
    run = simulate(
        model("coulomb"), duration="0.5 s", method=method, tolerance=1e-9, parameters={"w_y": f"{spin!r} rad/s"}
    )
    left = run.engine.final["flight.angular_speed_y"]
    assert left == pytest.approx(spin - rate * 0.5, rel=1e-3, abs=LAYER)
    assert run.engine.final["drilling.dissipated"] == pytest.approx(
        0.2 * MASS * RADIUS**2 * (spin**2 - left**2), rel=1e-6
    )
    assert run.energy_residual < 1e-8
    assert math.hypot(run.engine.final["flight.x"], run.engine.final["flight.z"]) < 1e-12


# ---- a wheel in plane motion -----------------------------------------------------------------------------------------


def arm():
    return RollingResistance("drag", "rub", Parameter("arm", "mm", 1e3 * ARM), Parameter("layer", "rad/s", LAYER))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_wheel_under_a_block_slows_down_and_turns_its_guide(coordinates):
    """By c N/I; what the block is turned with, its guide holds."""
    moment, spin = ARM * 2 * GRAVITY, 100
    run = simulate(engine_model(brake(arm()).with_coordinates(coordinates)), duration="1 s", tolerance=1e-8)
    final = run.with_histories("axle.speed", "guide.reaction_moment_z", "drag.moment_z", "drag.power")
    left = final["axle.speed"][-1]
    assert left == pytest.approx(spin - moment / 1e-3, rel=1e-6)
    assert final["drag.moment_z"][-1] == pytest.approx(-moment, rel=1e-6)
    assert final["guide.reaction_moment_z"][-1] == pytest.approx(-moment, rel=1e-6)
    assert final["drag.power"][-1] == pytest.approx(moment * left, rel=1e-6)
    assert run.engine.final["drag.dissipated"] == pytest.approx(1e-3 / 2 * (spin**2 - left**2), rel=1e-6)
    assert run.energy_residual < 1e-8


# ---- declared and shown ----------------------------------------------------------------------------------------------


def test_every_fault_is_reported():
    """A pair without a contact, wrong units, two of one kind, a spin that there cannot be."""
    bare = [effect for effect in brake(arm()).effects if effect.name != "rub"]
    with pytest.raises(InputError, match="Rolling resistance needs a normal force"):
        generate(replace(brake(), effects=tuple(bare)))
    wrong = RollingResistance("wrong", "floor", Parameter("wrong_arm", "1", 1), Parameter("wrong_layer", "1/s", LAYER))
    with pytest.raises(InputError) as caught:
        generate(scene("coulomb", rolling(), wrong))
    text = str(caught.value)
    for word in ("effect wrong, coefficient", "effect wrong, speed", "rolling_resistance of pair floor"):
        assert word in text
    spin = DrillingResistance("drag", "rub", Parameter("arm", "mm", 1), Parameter("layer", "rad/s", LAYER))
    with pytest.raises(InputError, match="drag: found no equation"):
        generate(brake(spin))
