"""Gravity that varies with time, against a support that is driven."""

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

p = hd.Parameter
SIZE, A, W = p("size", "m", 0.3), p("A", "m", 0.05), p("w", "rad/s", 30)
BOB = hd.Body("bob", p("mass", "kg", 2), inertia=p("J", "kg m^2", 0.01), centre=(0, -SIZE, 0))
CART = hd.Body("cart", p("cart_mass", "kg", 1))
DOWN = hd.Gravity("gravity", p("g", "m/s^2", 9.81), direction=-hd.Y)
SCALES, START = hd.Scales(SIZE, p("pace", "m/s", 1), arm=SIZE), hd.Start(position={"hinge": p("lift", "rad", 0.5)})
HUNG = hd.Mechanism("hung", (hd.Revolute("hinge", hd.GROUND, BOB, axis=hd.Z),))


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("axis", [hd.X, hd.Y])
def test_a_frame_that_is_shaken(axis, coordinates):
    """A pendulum in a frame that moves by A sin(w t) swings as one whose support is driven so."""
    shaken = hd.Gravity("shaken", A * W**2 * sp.sin(W * hd.T), direction=axis)  # minus the frame's acceleration
    scene = hd.Scene(HUNG, (DOWN, shaken, hd.EnergyLedger()), SCALES, START, coordinates=coordinates)
    run = simulate(load(scene), duration=1.0, tolerance=1e-10)
    joints = hd.Prismatic("slide", hd.GROUND, CART, axis=axis), hd.Revolute("hinge", CART, BOB, axis=hd.Z)
    effects = DOWN, hd.Harmonic("support", "slide", A, frequency=W), hd.EnergyLedger()
    driven = hd.Scene(hd.Mechanism("driven", joints), effects, SCALES, START)
    other = simulate(load(driven), duration=1.0, tolerance=1e-10)
    assert run["hinge.angle"][-1] == pytest.approx(other["hinge.angle"][-1], abs=1e-7)
    assert run["hinge.reaction_y"][-1] == pytest.approx(other["hinge.reaction_y"][-1], rel=1e-6)
    assert np.ptp(run["shaken.input"]) > 0.01
    assert run.energy_residual < 1e-8


def test_gravity_depends_on_time_alone_and_is_one_where_it_does_not():
    with pytest.raises(hd.InputError, match="depends on hinge"):
        hd.Scene(HUNG, (hd.Gravity("g", p("g", "m/s^2", 1) * hd.coordinate_of("hinge"), direction=hd.X),), SCALES)
    with pytest.raises(hd.InputError, match="gravity of the scene"):
        hd.Scene(HUNG, (DOWN, hd.Gravity("other", p("g", "m/s^2", 9.81), direction=hd.X)), SCALES)
