"""After what time everything in a scene that depends on time repeats."""

import numpy as np
import pytest
import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    Drive,
    Harmonic,
    JointForce,
    Mechanism,
    Parameter,
    Prismatic,
    Ramp,
    Revolute,
    Scales,
    Scene,
    T,
    Table,
    X,
    Z,
    coordinate_of,
    generate,
)
from hertzwerk.derive.declare.scene.periods import period
from hertzwerk.derive.expressions.parameter import Parameter as AnyParameter

SIZE, SPIN, RATE, ANGLE = (
    Parameter("size", "m", 0.1),
    Parameter("spin", "rad/s", -3.0),
    Parameter("rate", "rad/s", 2.0),
    Parameter("angle", "rad", 0.3),
)
FORCE, RISE, PACE = Parameter("force", "N", 3.0), Parameter("rise", "s", 1.0), Parameter("pace", "m/s", 0.5)
OTHER = Parameter("other", "rad/s", 1.7)
ROTOR, BLOCK = (
    Body("rotor", Parameter("mass", "kg", 1), Parameter("inertia", "kg m^2", 1)),
    Body("block", Parameter("mass", "kg", 1)),
)
MECHANISM = Mechanism("bench", (Revolute("axle", GROUND, ROTOR, axis=Z), Prismatic("slide", GROUND, BLOCK, axis=X)))
WAVE = Table("wave", (0, 1, 2), (0, 5, 0), ("s", "deg"))


def bench(*effects):
    return Scene(MECHANISM, effects, Scales(length=SIZE, speed=PACE, arm=SIZE))


def push(force):
    return JointForce("push", "slide", force)


PERIODIC = {
    # label: (effects, period at the defaults, what repeats after it, from a time on)
    "a shaft turning backwards": ((ConstantSpeed("d", "axle", SPIN),), 2 * np.pi / 3, sp.sin(SPIN * T)),
    "a speed that is reached": ((Ramp("d", "axle", SPIN, RISE),), 2 * np.pi / 3, sp.sin(SPIN * T)),
    "a shaker": ((Harmonic("d", "slide", SIZE, RATE),), np.pi, sp.sin(RATE * T)),
    "a shaft with a wobble": (
        (Drive("d", "axle", position=SPIN * T + ANGLE * sp.sin(SPIN * T / 3)),), 2 * np.pi, sp.sin(SPIN * T) + sp.sin(SPIN * T / 3),
    ),
    "a given speed": ((Drive("d", "axle", speed=SPIN, start=ANGLE),), 2 * np.pi / 3, sp.sin(SPIN * T)),
    "a force within a root": ((push(FORCE * sp.sqrt(2 + sp.cos(RATE * T + ANGLE))),), np.pi, sp.cos(RATE * T)),
    "two to three": ((push(FORCE * (sp.cos(2 * RATE * T) + sp.sin(3 * RATE * T))),), np.pi, sp.cos(2 * RATE * T) + sp.sin(3 * RATE * T)),
    "a drive and a force": ((Harmonic("d", "axle", ANGLE, RATE), push(FORCE * sp.cos(RATE * T / 2))), 2 * np.pi, sp.cos(RATE * T / 2)),
    "a phase that swings": ((push(FORCE * sp.cos(RATE * T + ANGLE * sp.sin(RATE * T))),), np.pi, sp.cos(RATE * T)),
}  # fmt: skip

APERIODIC = {
    "nothing depends on time": (push(FORCE),),
    "a slide that goes on": (ConstantSpeed("d", "slide", PACE),),
    "a force that grows": (push(FORCE * T / RISE),),
    "a chirp": (push(FORCE * sp.cos(RATE * T**2 / RISE)),),
    "an amplitude that grows": (push(FORCE * T / RISE * sp.cos(RATE * T)),),
    "two frequencies of no common measure": (push(FORCE * (sp.cos(RATE * T) + sp.cos(OTHER * T))),),
    "a table": (Drive("d", "axle", position=WAVE(T)),),
    "a speed that changes": (Drive("d", "axle", speed=SPIN + RATE * sp.cos(RATE * T)),),
    "a force and a slide that goes on": (ConstantSpeed("d", "slide", PACE), JointForce("push", "axle", SIZE * FORCE * sp.cos(RATE * T))),
}  # fmt: skip


@pytest.mark.parametrize("label", PERIODIC)
def test_a_period(label):
    effects, expected, repeats = PERIODIC[label]
    found = period(bench(*effects))
    values = {
        symbol: symbol.si for symbol in found.free_symbols | repeats.free_symbols if isinstance(symbol, AnyParameter)
    }
    assert float(found.subs(values)) == pytest.approx(expected, rel=1e-14)
    f = sp.lambdify(T, repeats.subs(values))
    times = np.linspace(2, 9, 50)
    assert f(times + expected) == pytest.approx(f(times), abs=1e-12)
    assert np.max(np.abs(f(times + expected / 2) - f(times))) > 0.5  # nor after half of it


@pytest.mark.parametrize("label", APERIODIC)
def test_no_period(label):
    scene = bench(*APERIODIC[label])
    assert period(scene) is None
    assert "period" not in generate(scene)  # and none in the module


def test_a_period_does_not_depend_on_the_coordinates():
    scene = bench(ConstantSpeed("d", "axle", SPIN), push(-FORCE * coordinate_of("slide") / SIZE))
    assert period(scene) == period(scene.with_coordinates("absolute")) == 2 * sp.pi / sp.Abs(SPIN)
    assert "def period(p)" in generate(scene.with_coordinates("absolute"))
