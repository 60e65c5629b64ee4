"""The energy residual: an error over the energy that a run moves, which knows nothing of where the potential is zero."""

import pytest

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    EnergyLedger,
    Gravity,
    JointDamper,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.runtime import load, simulate

L, SPEED, MASS = Parameter("length", "m", 1.0), Parameter("pace", "m/s", 1.0), Parameter("mass", "kg", 2.0)
GRAVITY = Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), -Y)
BOB = Body("bob", MASS, 0, (L, 0, 0))
SCALES = Scales(length=L, speed=SPEED, arm=L)


@pytest.fixture(scope="module")
def pendulum():
    """Let go at the level of its hinge: all its energy is zero where the hinge is at the origin."""
    height = Parameter("height", "m", 0.0)
    hinge = Revolute("hinge", GROUND.at(0, height, 0), BOB, Z)
    return load(Scene(Mechanism("swing", (hinge,)), (GRAVITY, EnergyLedger()), SCALES))


def test_a_total_energy_of_zero_is_no_measure(pendulum):
    run = simulate(pendulum, duration="3 s", tolerance=1e-7)
    assert max(abs(run["energy"])) < 1e-4
    assert 1e-12 < run.energy_residual < 1e-5


def test_the_zero_of_the_potential_does_not_matter_and_the_error_does(pendulum):
    for tolerance in (1e-4, 1e-7):
        given = {"duration": "3 s", "tolerance": tolerance, "method": "dopri5"}
        low, high = (simulate(pendulum, **given, parameters={"height": h}).energy_residual for h in ("0 m", "30 m"))
        assert high == pytest.approx(low, rel=0.01)
        energy = simulate(pendulum, **given)["energy"]
        assert low == pytest.approx(max(abs(energy - energy[0])) / (2.0 * 9.81), rel=0.01)  # it falls by its length


def test_what_a_drive_or_a_damper_moves_counts():
    """A body that is dragged along by a damper: kinetic 1 J and 1 J lost, put in 2 J."""
    cart = Body("cart", MASS)
    body, other = Prismatic("one", GROUND, cart, X), Prismatic("two", cart, Body("load", MASS), X)
    effects = (
        ConstantSpeed("drive", "one", SPEED),
        JointDamper("damper", "two", Parameter("damping", "N s/m", 20.0)),
        EnergyLedger(),
    )
    scene = Scene(
        Mechanism("towed", (body, other)), effects, Scales(length=L, speed=SPEED), Start(speed={"two": -SPEED})
    )
    run = simulate(load(scene), duration="2 s", tolerance=1e-6)
    error = run["energy"] - run["energy"][0] + run["damper.dissipated"] - run["energy_ledger.input"]
    assert run["energy_ledger.input"][-1] == pytest.approx(2.0, rel=1e-5)
    assert run.energy_residual == pytest.approx(max(abs(error)) / 2.0, rel=1e-3)


def test_at_rest_rounding_is_no_error(pendulum):
    run = simulate(pendulum, duration="1 s", initial={"hinge.angle": "-90 deg"})
    assert run.energy_residual < 1e-9
