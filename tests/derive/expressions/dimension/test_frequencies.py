"""Frequencies taken as angular speeds: which expressions are doubted, in text, in laws and in scenes."""

from importlib import import_module

import pytest
import sympy as sp
from each import each

from hertzwerk.derive import GROUND, Body, JointForce, Mechanism, Parameter, Prismatic, Scales, Scene, T, X
from hertzwerk.derive.audit.audit import advice_findings, audit_law
from hertzwerk.derive.audit.audit_text import audit_expression
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime.loading import engine_model

UNITS = {
    "f": "1/s", "h": "1/ms", "w": "rad/s", "n": "rpm", "t": "s", "J": "kg m^2", "m": "kg", "x": "m", "k": "N/m",
    "c": "N s", "p": "1",
}  # fmt: skip
DOUBTED = ("cos(f*t)", "sin(f*t + 0.3)", "tan(-t*h)", "cos(2*f*t)", "J*f**2", "J*f**2/2", "m*(f*x)**2", "m*f*f*x", "k/f**2", "x*f**(1 + 1)",
           "sqrt(J*f**4/m)", "exp(cos(f*t))", "m*x*(1 + p*cos(f*t))**p")  # fmt: skip
FINE = ("cos(2*pi*f*t)", "cos(6.2832*f*t)", "cos(2*3.1416*f*t)", "J*(2*pi*f)**2", "39.478*J*f**2", "cos(w*t)", "J*w**2", "J*n**2/2", "exp(-f*t)",
        "exp(-f*t)*cos(w*t)", "c*f", "m*f*x", "sqrt(w**2 - f**2)", "f**2", "x*f**p", "cos(exp(-f*t))", "cos(t*sqrt(k/m))")  # fmt: skip


@each("text", DOUBTED)
def test_a_frequency_that_may_lack_two_pi_is_doubted(text):
    finding = audit_expression(text, UNITS)
    (name,) = {"f", "h"} & set(text)
    assert finding.sound
    assert (
        f" takes {name} [{UNITS[name]}] as an angular speed: write 2*pi*{name} if it counts turns, or declare it in rad/s"
        in finding.advice
    )


@each("text", FINE)
def test_a_frequency_with_two_pi_or_of_no_rotation_is_not_doubted(text):
    finding = audit_expression(text, UNITS)
    assert (finding.sound, finding.advice) == (True, "")


def test_no_law_and_no_scene_of_ours_is_doubted():
    assert not [f.advice for law in LAWS.values() for f in audit_law(law) if f.advice]
    scenes = [import_module(f"hertzwerk.derive.scenes.{name}").scene for name in NAMES]
    assert not [f for scene in scenes for f in advice_findings(scene) if f.kind == "frequency"]


@pytest.mark.parametrize(("unit", "doubts"), [("1/s", 1), ("rad/s", 0)])
def test_a_scene_is_advised_and_its_module_says_so(unit, doubts):
    body, rate = Body("slug", Parameter("mass", "kg", 1)), Parameter("rate", unit, 3)
    push = JointForce("push", "slide", Parameter("amplitude", "N", 1) * sp.cos(rate * T))
    scales = Scales(Parameter("size", "m", 1), Parameter("pace", "m/s", 1))
    model = engine_model(Scene(Mechanism("shaker", (Prismatic("slide", GROUND, body, axis=X),)), (push,), scales))
    said = model.module.ADVICE
    assert len(said) == doubts
    assert all(text.startswith("effect push, force: cos(rate*t) takes rate [1/s]") for text in said)
