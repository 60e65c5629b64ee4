"""Kinds of effects of one's own: each a class in a file of the user's, with its scene, that is loaded and run; what they lack is refused."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.exchange.readable_equations.equations_for_readers import equations_of
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

HEAD = """
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive import *
from hertzwerk.derive.laws import flores, power
from hertzwerk.derive.declare.mechanism.bodies import Slot

ball, size = Body("ball", Parameter("mass", "kg", 0.7), Parameter("inertia", "kg m^2", 3e-4)), Parameter("size", "m", 0.1)
SIZES = Scales(length=size, speed=Parameter("pace", "m/s", 1), arm=size)
k = Parameter("k", "{unit}", 0.3)


@dataclass(frozen=True)
"""
DRAG = '''class AirDrag(Effect):
    """Drag k |v| v of a body's point."""

    name: str
    point: Point
    coefficient: object
    kind: ClassVar[str] = "air_drag"
    measures: ClassVar = {"coefficient": Varying.of("kg/m", on=())}

    @property
    def points(self):
        return (self.point,)

    def element(self, kin):
        position, velocity, _ = kin.point(self.point, f"{self.name}_point")
        speed = kin.tape.let(sp.sqrt(sum(v**2 for v in velocity)), f"{self.name}_speed")
        force = kin.tape.vector(tuple(-self.coefficient * speed * v for v in velocity), f"{self.name}_force")
        forces = kin.generalised(force, position, self.point.body, GROUND, self.name)
        return Element(forces, dissipated=self.coefficient * speed**3, outputs=((f"{self.name}.speed", "m/s", speed),))


planar = Mechanism("thrown", (Planar("flight", GROUND, ball),))
scene = Scene(planar, (AirDrag("air", ball.at(0, 0, 0), k), EnergyLedger()), SIZES)
'''
HARDENING = '''class HardeningSpring(JointEffect):
    """Force k q^3 on a joint."""

    name: str
    joint: str
    coefficient: object
    kind: ClassVar[str] = "hardening_spring"
    measures: ClassVar = {"coefficient": Slot.of("{force}/({coordinate})^3")}

    def element(self, kin):
        q = kin.coordinate(self.joint)
        force = kin.tape.let(-self.coefficient * q**3, f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), stored=self.coefficient * q**4 / 4)


slide = Mechanism("slide", (Prismatic("slide", GROUND, ball, axis=X),))
scene = Scene(slide, (HardeningSpring("spring", "slide", k), EnergyLedger()), SIZES, Start(position={"slide": size}))
'''
CENTRING = '''class Centring(PairEffect):
    """A spring that pulls a pin to the middle of its bush."""

    name: str
    pair: str
    stiffness: object
    kind: ClassVar[str] = "centring"

    def slots(self, scene):
        yield Slot(f"{self.where}, stiffness", self.stiffness, "N/m")

    def element(self, kin):
        journal = kin.journal(self.pair)
        e = journal.eccentricity
        force = kin.tape.vector(tuple(-self.stiffness * x for x in e), f"{self.name}_force")
        forces = kin.generalised(force, journal.base, journal.first.body, journal.second.body, self.name)
        return Element(forces, stored=self.stiffness * sum(x**2 for x in e) / 2)


pair = PinInBush("pin", ball.at(0, 0, 0), GROUND.at(0, 0, 0), Z, size, Parameter("clearance", "m", 0.05))
held = Mechanism("held", (Planar("flight", GROUND, ball),), (pair,))
scene = Scene(held, (Centring("centring", "pin", k), EnergyLedger()), SIZES, Start(speed={"flight.x_speed": Parameter("start", "m/s", 0.01)}))
'''


@pytest.fixture
def own(tmp_path):
    def written(text, unit):
        file = tmp_path / "own.py"
        file.write_text(HEAD.replace("{unit}", unit) + text)
        return file

    return written


def test_effects_of_ones_own_on_a_body_a_joint_and_a_pair(own):
    # v = v0/(1 + k v0 t/m), and ledger, outputs and equations for people know of it without a line elsewhere.
    model = engine_model(own(DRAG, "kg/m"))
    speeds = {"flight.x_speed": (3, "m/s"), "flight.y_speed": (4, "m/s")}
    run = simulate(model, duration=2.0, tolerance=1e-11, initial=speeds)
    assert run["air.speed"][-1] == pytest.approx(5 / (1 + 0.3 * 5 * 2 / 0.7), rel=1e-9)
    assert run["air.dissipated"][-1] == pytest.approx(0.35 * (25 - run["air.speed"][-1] ** 2), rel=1e-9)
    assert ("air", "air_drag", "air drag") in model.module.EFFECTS
    # The energy k q^4/4 it stores is what the block's motion gives up.
    run = simulate(engine_model(own(HARDENING, "N/m^3")), duration=20.0, tolerance=1e-11)
    q, u = run["slide.travel"], run["slide.speed"]
    assert 0.7 * u[-1] ** 2 / 2 + 0.3 * q[-1] ** 4 / 4 == pytest.approx(0.3 * 0.1**4 / 4, rel=1e-8)
    assert abs(q[-1]) < 0.0999
    # The pin swings at sqrt(k/m) in its bush, which has no contact.
    run = simulate(engine_model(own(CENTRING, "N/m")), duration=3.0, tolerance=1e-11)
    rate = (0.3 / 0.7) ** 0.5
    np.testing.assert_allclose(run["flight.x"][-1], 0.01 / rate * np.sin(3 * rate), rtol=1e-8)


@pytest.mark.parametrize(("text", "unit"), [(DRAG, "N"), (HARDENING, "N/m"), (CENTRING, "N")])
def test_the_units_of_an_effect_of_ones_own_are_proven(own, text, unit):
    with pytest.raises(hd.InputError, match=r"(coefficient|stiffness): found k"):
        engine_model(own(text, unit))


@pytest.mark.parametrize(
    ("text", "old", "new", "said"),
    [
        (DRAG, "ball.at(0, 0, 0), k", 'Body("other", 1).at(0, 0, 0), k', "body other"),
        (DRAG, "ball.at(0, 0, 0), k", "ball, k", "a point of a body"),
        (HARDENING, '"spring", "slide"', '"spring", "slid"', "joint 'slid'"),
        (CENTRING, '"centring", "pin"', '"centring", "pi"', "pair 'pi'"),
        (CENTRING, '(Centring("centring", "pin", k)', '(Centring("a", "pin", k), Centring("b", "pin", k)', "centring of pair pin"),
        (DRAG, "(Effect)", "", "an effect, such as Gravity"),
        (DRAG, 'kind: ClassVar[str] = "air_drag"', "", "an effect, such as Gravity"),
    ],
)  # fmt: skip
def test_own_effects_that_do_not_fit_are_refused(own, text, old, new, said):
    assert old in text
    with pytest.raises(hd.InputError, match=said):
        engine_model(own(text.replace(old, new), {DRAG: "kg/m", HARDENING: "N/m^3", CENTRING: "N/m"}[text]))


@dataclass(frozen=True)
class Mystery(hd.Effect):
    name: str
    kind: ClassVar[str] = "mystery"


def test_a_kind_of_effect_that_does_nothing_is_refused():
    body, size = hd.Body("body", hd.Parameter("mass", "kg", 1)), hd.Parameter("size", "m", 1)
    slide = hd.Mechanism("slide", (hd.Prismatic("slide", hd.GROUND, body, axis=hd.X),))
    gravity = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), hd.X)
    scene = hd.Scene(slide, (gravity, Mystery("x")), hd.Scales(size, hd.Parameter("pace", "m/s", 1)))
    with pytest.raises(hd.InputError, match="the kind 'mystery', which has no element"):
        hd.generate(scene)
    assert next(e for e in equations_of(scene.without("x")).effects if e.name == "gravity").enters
