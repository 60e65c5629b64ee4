"""Models of SymPy's mechanics as scenes: against the same scenes declared natively, and against the literature."""

import math

import numpy as np
import pytest
import sympy as sp
import sympy_models as models
from sympy.physics.mechanics import dynamicsymbols

from hertzwerk.derive import (
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Gravity,
    InputError,
    Mechanism,
    Parameter,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
    Y,
    Z,
    from_sympy,
    laws,
)
from hertzwerk.runtime import load, simulate


def struck(sphere, l):
    """Pair and effects of a bob that strikes a wall, scales and start, for a point of any mechanism."""
    radius, wall = Parameter("radius", "mm", 20), GROUND.at(-Parameter("radius", "mm", 20), 0, 0)
    stiffness, restitution = Parameter("K", "N/m^1.5", 1e8), Parameter("e", "1", 0.7)
    pair = SphereOnPlane("wall", sphere=sphere, radius=radius, plane=wall, normal=X)
    effects = Contact("wall", laws.power(stiffness, 1.5), laws.flores(e=restitution)), EnergyLedger()
    return (
        pair,
        effects,
        Scales(length=radius, speed=Parameter("pace", "m/s", 1), arm=l),
        Start(position={"q": Parameter("q0", "rad", 0.5)}),
    )


def test_a_pendulum_strikes_a_wall_as_the_native_one_does():
    method, at, units, values = models.pendulum()
    model = from_sympy(method, units=units, values=values, origin=at["O"], name="imported_pendulum")
    pair, effects, scales, start = struck(model.at("P"), model.parameters["l"])
    run = simulate(
        load(model.scene(pairs=(pair,), effects=effects, scales=scales, start=start)), duration="2 s", accuracy=1e-8
    )
    l = Parameter("l", "m", 0.5)
    bob = Body("bob", Parameter("m", "kg", 1))
    pair, effects, scales, start = struck(bob.at(0, 0, 0), l)
    native = Scene(
        Mechanism("native_pendulum", (Revolute("q", GROUND, bob.at(0, l, 0), axis=Z),), pairs=(pair,)),
        (Gravity("gravity", Parameter("g", "m/s^2", 9.81), direction=-Y), *effects), scales, start,
    )  # fmt: skip
    other = simulate(load(native), duration="2 s", accuracy=1e-8)
    assert len(run.impacts) == len(other.impacts) == 3
    assert [i.t for i in run.impacts] == pytest.approx([i.t for i in other.impacts], abs=1e-9)
    assert [i.peak_force for i in run.impacts] == pytest.approx([i.peak_force for i in other.impacts], rel=1e-8)
    assert run["q.angle"][-1] == pytest.approx(other["q.angle"][-1], abs=1e-8)
    assert run["energy"][-1] + run["wall.dissipated"][-1] - run["loads.input"][-1] == pytest.approx(
        run["energy"][0], abs=1e-9
    )


def test_a_disc_that_rolls_upright_wobbles_at_the_frequency_of_theory():
    # thin disc, spin W, small lean x: 5/4 x'' = g/r x - 3/2 W y', 1/4 y'' = 1/2 W x' for the yaw y (Neimark, Fufaev 1972, chapter 4)
    method, units, values = models.rolling_disc()
    model = from_sympy(method, units=units, values=values, name="disc")
    r = model.parameters["r"]
    scene = model.scene(
        effects=(EnergyLedger(),), scales=Scales(length=r, speed=Parameter("pace", "m/s", 1), arm=r),
        start=Start(position={"q2": Parameter("lean", "rad", 1e-5)}, speed={"u2": Parameter("spin", "rad/s", 8)}),
    )  # fmt: skip
    run = simulate(load(scene), duration="1 s", accuracy=1e-12)
    square = 12 / 5 * 8**2 - 4 / 5 * 9.81 / 0.3
    middle = 1e-5 * 12 / 5 * 8**2 / square
    assert run["q2.angle"] == pytest.approx(middle + (1e-5 - middle) * np.cos(math.sqrt(square) * run.t), abs=1e-12)


@pytest.mark.parametrize(
    ("arm", "where", "found"),
    [
        (lambda A, q, l: -A.y, "position of P from O, along A.y", "-1 [1]"),
        (lambda A, q, l: -l * A.y - sp.sin(q) * A.x, "position of P from O, along A.x", "-sin(q(t)) [1]"),
        (lambda A, q, l: -l * (1 + l * sp.cos(q)) * A.y, "position of P from O, along A.y", "l*cos(q(t)) + 1"),
    ],
)  # fmt: skip
def test_a_length_that_is_forgotten_is_named_in_the_users_own_expression(arm, where, found):
    method, at, units, values = models.pendulum(arm)
    with pytest.raises(InputError) as caught:
        from_sympy(method, units=units, values=values, origin=at["O"])
    fault = caught.value.faults[0]
    assert fault.where == where
    assert fault.found.startswith(found)


def test_every_symbol_without_a_unit_or_a_value_is_told_at_once():
    wind, k = dynamicsymbols("wind"), sp.Symbol("k")
    method, at, units, values = models.pendulum(extra=wind + k)
    with pytest.raises(InputError) as caught:
        from_sympy(method, units=units, values={**values, "m": True, sp.Symbol("drag"): 1}, origin=at["O"])
    told = {fault.where: fault.found for fault in caught.value.faults}
    assert told == {
        "symbol m": "value True", "symbol k": "no value", "symbol wind": "no unit", "values, drag": "no such symbol in the model",
        "function wind(t)": "neither a coordinate nor a speed, and not specified",
    }  # fmt: skip
    assert len(caught.value.faults) == 6  # k has no unit either


def test_equations_not_yet_formed_and_other_objects_are_refused():
    with pytest.raises(InputError, match="KanesMethod, a LagrangesMethod or a System"):
        from_sympy("KanesMethod", units={}, values={})
