"""After what time everything in a scene that depends on time repeats."""

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.declare.scene.periods import period
from hertzwerk.derive.expressions.parameter import Parameter as AnyParameter

SIZE, SPIN, RATE, ANGLE = (
    hd.Parameter("size", "m", 0.1), hd.Parameter("spin", "rad/s", -3.0), hd.Parameter("rate", "rad/s", 2.0), hd.Parameter("angle", "rad", 0.3),
)  # fmt: skip
FORCE, RISE, PACE = hd.Parameter("force", "N", 3.0), hd.Parameter("rise", "s", 1.0), hd.Parameter("pace", "m/s", 0.5)
OTHER = hd.Parameter("other", "rad/s", 1.7)
ROTOR, BLOCK = (
    hd.Body("rotor", hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1)),
    hd.Body("block", hd.Parameter("mass", "kg", 1)),
)
MECHANISM = hd.Mechanism(
    "bench", (hd.Revolute("axle", hd.GROUND, ROTOR, axis=hd.Z), hd.Prismatic("slide", hd.GROUND, BLOCK, axis=hd.X))
)
WAVE = hd.Table("wave", (0, 1, 2), (0, 5, 0), ("s", "deg"))


def bench(*effects):
    return hd.Scene(MECHANISM, effects, hd.Scales(length=SIZE, speed=PACE, arm=SIZE))


def push(force):
    return hd.JointForce("push", "slide", force)


PERIODIC = {
    # label: (effects, period at the defaults, what repeats after it, from a time on)
    "a shaft turning backwards": ((hd.ConstantSpeed("d", "axle", SPIN),), 2 * np.pi / 3, sp.sin(SPIN * hd.T)),
    "a speed that is reached": ((hd.Ramp("d", "axle", SPIN, RISE),), 2 * np.pi / 3, sp.sin(SPIN * hd.T)),
    "a shaker": ((hd.Harmonic("d", "slide", SIZE, RATE),), np.pi, sp.sin(RATE * hd.T)),
    "a shaft with a wobble": (
        (hd.Drive("d", "axle", position=SPIN * hd.T + ANGLE * sp.sin(SPIN * hd.T / 3)),), 2 * np.pi, sp.sin(SPIN * hd.T) + sp.sin(SPIN * hd.T / 3),
    ),
    "a given speed": ((hd.Drive("d", "axle", speed=SPIN, start=ANGLE),), 2 * np.pi / 3, sp.sin(SPIN * hd.T)),
    "a force within a root": ((push(FORCE * sp.sqrt(2 + sp.cos(RATE * hd.T + ANGLE))),), np.pi, sp.cos(RATE * hd.T)),
    "two to three": ((push(FORCE * (sp.cos(2 * RATE * hd.T) + sp.sin(3 * RATE * hd.T))),), np.pi, sp.cos(2 * RATE * hd.T) + sp.sin(3 * RATE * hd.T)),
    "a drive and a force": ((hd.Harmonic("d", "axle", ANGLE, RATE), push(FORCE * sp.cos(RATE * hd.T / 2))), 2 * np.pi, sp.cos(RATE * hd.T / 2)),
    "a phase that swings": ((push(FORCE * sp.cos(RATE * hd.T + ANGLE * sp.sin(RATE * hd.T))),), np.pi, sp.cos(RATE * hd.T)),
}  # fmt: skip

APERIODIC = {
    "nothing depends on time": (push(FORCE),),
    "a slide that goes on": (hd.ConstantSpeed("d", "slide", PACE),),
    "a force that grows": (push(FORCE * hd.T / RISE),),
    "a chirp": (push(FORCE * sp.cos(RATE * hd.T**2 / RISE)),),
    "an amplitude that grows": (push(FORCE * hd.T / RISE * sp.cos(RATE * hd.T)),),
    "two frequencies of no common measure": (push(FORCE * (sp.cos(RATE * hd.T) + sp.cos(OTHER * hd.T))),),
    "a table": (hd.Drive("d", "axle", position=WAVE(hd.T)),),
    "a speed that changes": (hd.Drive("d", "axle", speed=SPIN + RATE * sp.cos(RATE * hd.T)),),
    "a force and a slide that goes on": (hd.ConstantSpeed("d", "slide", PACE), hd.JointForce("push", "axle", SIZE * FORCE * sp.cos(RATE * hd.T))),
}  # fmt: skip


@pytest.mark.parametrize("label", PERIODIC)
def test_a_period(label):
    effects, expected, repeats = PERIODIC[label]
    actual = period(bench(*effects))
    values = {
        symbol: symbol.si for symbol in actual.free_symbols | repeats.free_symbols if isinstance(symbol, AnyParameter)
    }
    assert float(actual.subs(values)) == pytest.approx(expected, rel=1e-14)
    f = sp.lambdify(hd.T, repeats.subs(values))
    times = np.linspace(2, 9, 50)
    assert f(times + expected) == pytest.approx(f(times), abs=1e-12)
    assert np.max(np.abs(f(times + expected / 2) - f(times))) > 0.5  # nor after half of it


@pytest.mark.parametrize("label", APERIODIC)
def test_no_period(label):
    scene = bench(*APERIODIC[label])
    assert period(scene) is None
    assert "period" not in hd.generate(scene)  # and none in the module


def test_a_period_does_not_depend_on_the_coordinates():
    scene = bench(hd.ConstantSpeed("d", "axle", SPIN), push(-FORCE * hd.coordinate_of("slide") / SIZE))
    assert period(scene) == period(scene.with_coordinates("absolute")) == 2 * sp.pi / sp.Abs(SPIN)
    assert "def period(p)" in hd.generate(scene.with_coordinates("absolute"))
