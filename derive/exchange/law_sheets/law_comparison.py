"""Laws side by side, for studies: units of K d^n, forces of stiffness laws, scenes of comparison."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from hertzwerk.derive.audit.audit import audit_law
from hertzwerk.derive.audit.numeric import evaluate, scale_factor
from hertzwerk.derive.declare.effects.contacts import Contact
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Y, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import ParallelCylinders, SphereOnSphere
from hertzwerk.derive.exchange.law_sheets.law_sheet import EXAMPLE, values_of
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.walker import dimension_of
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.formulas.line import lankarani_nikravesh_cylinders
from hertzwerk.derive.laws.formulas.reconstruction import wang_liu_external
from hertzwerk.derive.laws.formulas.stiffness import K_hertz, hertz_point
from hertzwerk.derive.laws.law import StiffnessLaw, d
from hertzwerk.derive.laws.law_call import split_call
from hertzwerk.derive.laws.material import Material

DIGITS = 30

# -- units of K d^n ----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ExponentUnit:
    """Unit of K d^n with Hertz's K of a point contact, by the audit, at one exponent n.

    `in_mm`: the force with K and d in mm over that in m, by numbers alone; 1 for a force.
    """

    exponent: float
    unit: str
    consistent: bool
    in_mm: float


def exponent_unit(exponent: float) -> ExponentUnit:
    """Find the unit of Hertz's K d^n with another exponent, by the audit and by numbers in other units."""
    table = {K_hertz: Dimension.from_unit("N/m^1.5"), d: Dimension.from_unit("m")}
    force = K_hertz * d ** sp.Rational(str(exponent))
    dimension = dimension_of(force, table)
    with mp.workdps(DIGITS):
        K, depth, mm = mpf("6e10"), mpf("1e-5"), mpf(1000)
        ratio = evaluate(force, {K_hertz: K / mm ** mpf("1.5"), d: depth * mm}) / evaluate(
            force, {K_hertz: K, d: depth}
        )
    return ExponentUnit(exponent, str(dimension), dimension == Dimension.from_unit("N"), float(ratio))


# -- forces of stiffness laws ------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ForceCurve:
    """Forces [N] of a law at penetrations and clearances [m] of a steel pin in its bush, SI values put in.

    Forces are nan beyond the reach [m] of the law at that clearance, and where the formula has no real value. `in_mm`:
    the same with mm, N, MPa put in. `unit`: that of the force as the audit finds it. `ranges`: those the law states.
    """

    law: str
    title: str
    grade: str
    verdict: str
    unit: str
    source: str
    ranges: str
    forces: tuple[float, ...]
    in_mm: tuple[float, ...]
    reach: tuple[float, ...]


SI, MILLIMETRES = (
    (mpf(1),) * 5,
    (mpf(1000), mpf("0.001"), *(mpf(1),) * 3),
)  # units of mass, length, time, temperature, current


def force_curve(
    name: str, penetrations: Sequence[float], clearances: Sequence[float], exponent: float | None = None
) -> ForceCurve:
    """Evaluate a stiffness law at penetrations and clearances [m]; raises TypeError for another law.

    `exponent`: of a law that leaves it open.
    """
    law = LAWS[name]
    if not isinstance(law, StiffnessLaw):
        raise TypeError(f"found {name}, a {law.kind} law, expected a stiffness law")
    with mp.workdps(DIGITS):
        rows = [
            _at(law, mpf(repr(float(x))), mpf(repr(float(c))), exponent)
            for x, c in zip(penetrations, clearances, strict=True)
        ]
        forces, in_mm, reach = (tuple(column) for column in zip(*rows, strict=True))
    unit = _unit(law, exponent)
    ranges = "; ".join(
        f"{row.quantity.name} [{row.quantity.unit}] in {row.interval} ({row.kind})" for row in law.ranges
    )
    return ForceCurve(name, law.title, law.grade, law.verdict, unit, law.source, ranges, forces, in_mm, reach)


def _unit(law: StiffnessLaw, exponent: float | None) -> str:
    """Unit of the force as the audit finds it, or what it finds wrong within the formula."""
    findings = {finding.quantity: finding for finding in audit_law(law)}
    printed = findings["normal force"], findings.get("penetration", findings["normal force"])
    wrong = next((finding for finding in printed if finding.verdict != "consistent"), None)
    if wrong is None:
        return "N"
    if wrong.expected != "N":
        return wrong.reason
    exponents = {} if exponent is None else {"n": sp.Rational(str(exponent))}
    return str(Dimension.from_unit(wrong.found, exponents))


def _at(law: StiffnessLaw, depth: Any, clearance: Any, exponent: float | None) -> tuple[float, float, float]:
    """Force of a law at one point [N], the same with mm, N, MPa put in, and its reach there [m]."""
    si, in_mm = (_values(law, clearance, exponent, units) for units in (SI, MILLIMETRES))
    reach = mp.inf if law.reach is None else evaluate(law.reach, si)
    forces = (evaluate(law.force, {**v, d: depth / u}) for v, u in ((si, 1), (in_mm, MILLIMETRES[1])))
    first, second = (float(f) if depth < reach and mp.im(f) == 0 else math.nan for f in forces)
    return first, second, float(reach)


@lru_cache(maxsize=8)
def _values(law: StiffnessLaw, clearance: Any, exponent: float | None, units: Sequence[Any]) -> dict[sp.Symbol, Any]:
    """Values of a law's symbols for the pin in its bush of the sheets' example, with another clearance."""
    bush = mpf(EXAMPLE["R_1"])
    pin = bush - clearance
    numbers = {name: mpf(text) for name, text in EXAMPLE.items()}
    numbers |= {symbol.name: mpf(repr(parameter.si)) for symbol, parameter in law.defaults}
    numbers |= {"R_2": pin, "R_min": pin, "dR": clearance, "R_eff": bush * pin / clearance}
    numbers |= {} if exponent is None else {"n": mpf(repr(exponent))}
    symbols = (*law.parameters, *law.geometry)
    return values_of(law, symbols, numbers, lambda unit: scale_factor(Dimension.from_unit(unit), units, {}))


# -- scenes ------------------------------------------------------------------------------------------------------------


def with_stiffness(scene: Scene, contact: str, law: str) -> Scene:
    """The scene with another stiffness law; one with inconsistent units runs unchecked, and says so."""
    name, _ = split_call(law)
    wrong = name in LAWS and LAWS[name].verdict != "consistent"
    return scene.replace(**{contact: replace(scene.effect(contact), unchecked=wrong)}).with_law(contact, law)


def with_open_exponent(scene: Scene, contact: str) -> Scene:
    """The scene with Hertz's stiffness of a point contact and a free `exponent`, unchecked."""
    effect: Contact = scene.effect(contact)
    values = {symbol.name: value for symbol, value in effect.stiffness.binding.items()}
    exponent = Parameter("exponent", "1", 1.5, "n of K d^n, the number of K kept")
    law = lankarani_nikravesh_cylinders(
        **{s.name: values.get(s.name, exponent) for s in lankarani_nikravesh_cylinders.parameters}
    )
    return scene.replace(**{contact: replace(effect, stiffness=law, unchecked=True)})


FORMS = ("spheres", "cylinders")

_MASS = Parameter("mass", "kg", 1)
_RADIUS = Parameter("radius", "mm", 50, "of both bodies")
_LENGTH = Parameter("length", "mm", 50, "of the cylinders")
_HEIGHT = Parameter("drop_height", "m", 0.1, "gap at the start")
_GRAVITY = Parameter("gravity", "m/s^2", 9.81)
_STEEL = Material(Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3))


def dropped(form: str, damping: str) -> Scene:
    """A sphere or a cylinder dropped on an equal one that is fixed; the gap is the coordinate itself.

    Spheres have Hertz's stiffness, cylinders the reconstruction of the external model of Wang and Liu (grade R).
    """
    upper, below = Body("upper", mass=_MASS), GROUND.at(0, -2 * _RADIUS, 0)
    modulus = _STEEL.youngs_modulus / (2 * (1 - _STEEL.poissons_ratio**2))
    speed = sp.sqrt(2 * _GRAVITY * _HEIGHT)
    if form == "spheres":
        pair = SphereOnSphere("contact", upper.at(0, 0, 0), below, _RADIUS, _RADIUS)
        stiffness, K, n = (
            hertz_point(_STEEL, _STEEL),
            sp.Rational(4, 3) * modulus * sp.sqrt(_RADIUS / 2),
            sp.Rational(3, 2),
        )
    else:
        pair = ParallelCylinders("contact", upper.at(0, 0, 0), below, _RADIUS, _RADIUS, axis=Z, length=_LENGTH)
        stiffness, K, n = wang_liu_external(_STEEL, _STEEL), sp.pi / 4 * modulus * _LENGTH, sp.S.One
    return Scene(
        Mechanism(f"dropped_{form}", joints=(Prismatic("height", GROUND, upper, axis=Y),), pairs=(pair,)),
        effects=(
            Gravity("gravity", _GRAVITY, direction=-Y),
            Contact("contact", stiffness, LAWS[damping](e=Parameter("restitution", "1", 0.9))),
            EnergyLedger(),
        ),
        start=Start(position={"height": _HEIGHT}),
        scales=Scales(length=((n + 1) * _MASS * speed**2 / (2 * K)) ** (1 / (n + 1)), speed=speed),
        summary=f"one of two equal {form} dropped on the other, {damping}",
    )
