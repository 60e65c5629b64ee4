"""Gravity that varies with time, against a support that is driven."""

import numpy as np
import pytest
import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    EnergyLedger,
    Gravity,
    Harmonic,
    InputError,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    T,
    X,
    Y,
    Z,
    coordinate_of,
)
from hertzwerk.runtime import load, simulate

p = Parameter
SIZE, A, W = p("size", "m", 0.3), p("A", "m", 0.05), p("w", "rad/s", 30)
BOB = Body("bob", p("mass", "kg", 2), inertia=p("J", "kg m^2", 0.01), centre=(0, -SIZE, 0))
CART = Body("cart", p("cart_mass", "kg", 1))
DOWN = Gravity("gravity", p("g", "m/s^2", 9.81), direction=-Y)
SCALES, START = Scales(SIZE, p("pace", "m/s", 1), arm=SIZE), Start(position={"hinge": p("lift", "rad", 0.5)})
HUNG = Mechanism("hung", (Revolute("hinge", GROUND, BOB, axis=Z),))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("axis", [X, Y])
def test_a_frame_that_is_shaken(axis, coordinates):
    """A pendulum in a frame that moves by A sin(w t) swings as one whose support is driven so."""
    shaken = Gravity("shaken", A * W**2 * sp.sin(W * T), direction=axis)  # minus the frame's acceleration
    scene = Scene(HUNG, (DOWN, shaken, EnergyLedger()), SCALES, START, coordinates=coordinates)
    run = simulate(load(scene), duration=1.0, tolerance=1e-10)
    driven = Mechanism("driven", (Prismatic("slide", GROUND, CART, axis=axis), Revolute("hinge", CART, BOB, axis=Z)))
    support = Harmonic("support", "slide", A, frequency=W)
    other = simulate(load(Scene(driven, (DOWN, support, EnergyLedger()), SCALES, START)), duration=1.0, tolerance=1e-10)
    assert run["hinge.angle"][-1] == pytest.approx(other["hinge.angle"][-1], abs=1e-7)
    assert run["hinge.reaction_y"][-1] == pytest.approx(other["hinge.reaction_y"][-1], rel=1e-6)
    assert np.ptp(run["shaken.input"]) > 0.01
    assert run.energy_residual < 1e-8


def test_gravity_depends_on_time_alone_and_is_one_where_it_does_not():
    with pytest.raises(InputError, match="depends on hinge"):
        Scene(HUNG, (Gravity("g", p("g", "m/s^2", 1) * coordinate_of("hinge"), direction=X),), SCALES)
    with pytest.raises(InputError, match="gravity of the scene"):
        Scene(HUNG, (DOWN, Gravity("other", p("g", "m/s^2", 9.81), direction=X)), SCALES)
