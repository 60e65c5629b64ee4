"""The energy residual: an error over the energy that a run moves, which knows nothing of where the potential is zero."""

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power
from hertzwerk.derive.scenes import soft_ball
from hertzwerk.runtime import load, simulate

L, SPEED, MASS = hd.Parameter("length", "m", 1.0), hd.Parameter("pace", "m/s", 1.0), hd.Parameter("mass", "kg", 2.0)
GRAVITY = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y)
BOB = hd.Body("bob", MASS, 0, (L, 0, 0))
SCALES = hd.Scales(length=L, speed=SPEED, arm=L)


@pytest.fixture(scope="module")
def pendulum():
    """Let go at the level of its hinge: all its energy is zero where the hinge is at the origin."""
    height = hd.Parameter("height", "m", 0.0)
    hinge = hd.Revolute("hinge", hd.GROUND.at(0, height, 0), BOB, hd.Z)
    return load(hd.Scene(hd.Mechanism("swing", (hinge,)), (GRAVITY, hd.EnergyLedger()), SCALES))


def test_the_zero_of_the_potential_does_not_matter_and_the_error_does(pendulum):
    run = simulate(pendulum, duration="3 s", tolerance=1e-7)
    assert max(abs(run["energy"])) < 1e-4
    assert 1e-12 < run.energy_residual < 1e-5
    for tolerance in (1e-4, 1e-7):
        options = {"duration": "3 s", "tolerance": tolerance, "method": "dopri5"}
        low, high = (simulate(pendulum, **options, parameters={"height": h}).energy_residual for h in ("0 m", "30 m"))
        assert high == pytest.approx(low, rel=0.01)
        energy = simulate(pendulum, **options)["energy"]
        assert low == pytest.approx(max(abs(energy - energy[0])) / (2.0 * 9.81), rel=0.01)  # it falls by its length


def test_masses_moved_by_drives_or_dampers_count():
    """A body that is dragged along by a damper: kinetic 1 J and 1 J lost, put in 2 J."""
    cart = hd.Body("cart", MASS)
    body, other = hd.Prismatic("one", hd.GROUND, cart, hd.X), hd.Prismatic("two", cart, hd.Body("load", MASS), hd.X)
    effects = (
        hd.ConstantSpeed("drive", "one", SPEED), hd.JointDamper("damper", "two", hd.Parameter("damping", "N s/m", 20.0)), hd.EnergyLedger(),
    )  # fmt: skip
    scene = hd.Scene(
        hd.Mechanism("towed", (body, other)), effects, hd.Scales(length=L, speed=SPEED), hd.Start(speed={"two": -SPEED})
    )
    run = simulate(load(scene), duration="2 s", tolerance=1e-6)
    error = run["energy"] - run["energy"][0] + run["damper.dissipated"] - run["energy_ledger.input"]
    assert run["energy_ledger.input"][-1] == pytest.approx(2.0, rel=1e-5)
    assert run.energy_residual == pytest.approx(max(abs(error)) / 2.0, rel=1e-3)


# -- a ledger that does not close --------------------------------------------------------------------------------------


@cache
def dropped(factor):
    """A ball on a floor whose stored energy is so many times the integral of its force; unchecked, or the law would be refused."""
    wrong = replace(power, name="own", stored=power.stored * sp.Float(factor))
    others = [effect for effect in soft_ball.scene.effects if effect.kind != "contact"]
    contact = hd.Contact("floor", wrong(soft_ball.K, sp.Rational(3, 2)), unchecked=True)
    return load(replace(soft_ball.scene, name="dropped", effects=(*others, contact)))


@pytest.mark.parametrize("factor", [1.5, 0.5, 1.001])
def test_energy_that_is_not_the_forces_ends_a_run_so(factor):
    """`stored` is wrong in contact alone: before and after it the ledger closes."""
    run = simulate(dropped(factor), duration="0.6 s", accuracy=1e-6)
    assert run.outcome.name == "energy_not_closed"
    assert "hertzwerk audit" in run.outcome.remedy
    assert run.engine.t_end == pytest.approx(0.6)
    assert run.energy_residual > 1e-4
    assert simulate(dropped(factor), duration="0.6 s", tolerance=1e-9, grid=50).outcome.name == "energy_not_closed"


def test_energy_that_is_the_forces_does_not():
    given = *({"accuracy": 1e-2}, {"accuracy": 1e-6}), *({"tolerance": 1e-2}, {"tolerance": 1e-12})
    for options in (*given, {"tolerance": 1e-9, "grid": 50}):
        assert simulate(dropped(1.0), duration="0.6 s", **options).outcome.finished
    assert simulate(
        dropped(1.001), duration="0.6 s", accuracy=1e-3
    ).outcome.finished  # 1e-3 is within 100 times what was asked


def test_at_rest_and_far_from_the_zero_of_the_potential_rounding_is_no_error(pendulum):
    """Where nothing moves an error is measured by the scene's energy, and rounding of a large potential is none."""
    for options in ({"initial": {"hinge.angle": "-90 deg"}}, {"parameters": {"height": "1e7 m"}}):
        for accuracy in ({"tolerance": 1e-13}, {"tolerance": 1e-5}):
            assert simulate(pendulum, duration="1 s", **options, **accuracy).outcome.finished
    run = simulate(pendulum, duration="1 s", initial={"hinge.angle": "-90 deg"})
    assert run.energy_residual < 1e-9
