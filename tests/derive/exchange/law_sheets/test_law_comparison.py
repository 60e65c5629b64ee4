"""Laws side by side: forces known from elsewhere, units of K d^n, scenes of comparison."""

import math

import pytest
import sympy as sp
from each import each

from hertzwerk.derive.exchange.law_sheets.law_comparison import (
    FORMS,
    dropped,
    exponent_unit,
    force_curve,
    with_open_exponent,
    with_stiffness,
)
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank

DEPTHS, CLEARANCES = (1e-7, 1e-6, 1e-5), (0.5e-3,) * 3
KNOWN = {  # N at 0.1, 1, 10 um: E = 207 GPa, nu = 0.3, R1/R2 = 10/9.5 mm, L = 15 mm, computed independently
    "johnson": (47.301, 610.964, 8775.02), "dubowsky_freudenstein": (41.420, 514.336, 6842.86), "esdu_78035": (39.682, 487.304, 6357.79),
    "pereira_internal_si": (44.199, 642.661, 9344.46), "liu_with_length": (2.6796, 84.660, 2653.44), "hertz_point": (2.0903, 66.102, 2090.33),
    "popov_line": (133.992, 1339.92, 13399.2),
}  # fmt: skip


@each("law", KNOWN)
def test_forces_are_those_known(law):
    assert force_curve(law, DEPTHS, CLEARANCES).forces == pytest.approx(KNOWN[law], rel=2e-5)


def test_a_force_follows_the_clearance_and_ends_with_the_law():
    # Dry formula of Liu with its length: sqrt(d/(2 (dR + d))).
    narrow, wide = force_curve("liu_with_length", (1e-6, 1e-6), (5e-5, 5e-4)).forces
    assert narrow / wide == pytest.approx(math.sqrt((5e-4 + 1e-6) / (5e-5 + 1e-6)), rel=1e-12)
    johnson = force_curve("johnson", (1e-4, 3e-4), CLEARANCES[:2])
    assert johnson.reach == pytest.approx([4 / math.e**2 * 0.5e-3] * 2)
    assert [math.isnan(force) for force in johnson.forces] == [False, True]
    assert all(map(math.isnan, force_curve("pereira_internal", DEPTHS, CLEARANCES).forces))  # ln(1000 dR) < 0 in SI


OTHERS = ("bai_zhao", "liu", "goldsmith", "pereira_internal", "persson", "radzimovsky")


@each("law", [*KNOWN, *OTHERS])
def test_millimetres_change_the_force_of_inconsistent_laws_alone(law):
    """Pereira's as published is right in mm, N and MPa, and has no value in SI."""
    curve = force_curve(law, DEPTHS, CLEARANCES)
    assert (curve.in_mm == pytest.approx(curve.forces, rel=1e-12)) == (LAWS[law].verdict == "consistent")
    if law == "pereira_internal":
        assert curve.in_mm == pytest.approx(KNOWN["pereira_internal_si"], rel=2e-5)


def test_open_exponents_are_put_in_and_units_are_those_of_the_formula():
    curve = force_curve("lankarani_nikravesh_cylinders", (1e-5,), (0.5e-3,), 1.25)
    assert curve.unit == "N/m^0.25"
    assert curve.forces[0] == pytest.approx(2090.33 * 1e-5**-0.25, rel=1e-5)
    expected = {"bai_zhao": "N/m^0.5", "liu": "N/m", "johnson": "N"}
    assert {name: force_curve(name, DEPTHS, CLEARANCES).unit for name in expected} == expected
    assert "is 1/m^2, and log takes" in force_curve("goldsmith", DEPTHS, CLEARANCES).unit
    with pytest.raises(TypeError, match="damping law"):
        force_curve("flores", DEPTHS, CLEARANCES)


@each(("n", "unit"), [(1, "N/m^0.5"), (1.1, "N/m^0.4"), (1.5, "N"), (2, "N m^0.5")])
def test_the_unit_of_another_exponent(n, unit):
    actual = exponent_unit(n)
    assert (actual.unit, actual.consistent) == (unit, n == 1.5)
    assert actual.in_mm == pytest.approx(1000 ** (n - 1.5))


def test_inconsistent_laws_run_unchecked_and_consistent_ones_checked():
    assert with_stiffness(slider_crank, "slider_pin", "bai_zhao").effect("slider_pin").unchecked
    assert not with_stiffness(slider_crank, "slider_pin", "johnson").effect("slider_pin").unchecked
    opened = with_open_exponent(slider_crank, "slider_pin")
    assert opened.effect("slider_pin").unchecked
    assert opened.parameters["exponent"].default == 1.5


@pytest.mark.parametrize("form", FORMS)
def test_bodies_are_dropped_on_a_law_of_their_form(form):
    scene = dropped(form, "flores")
    assert scene.effect("contact").stiffness.law.forms == (("point",) if form == "spheres" else ("line",))
    depth = float(sp.sympify(scene.scales.length).xreplace({p: p.si for p in scene.parameters.values()}))
    modulus = 207e9 / (2 * (1 - 0.3**2))
    stored = modulus * (8 / 15 * math.sqrt(0.025) * depth**2.5 if form == "spheres" else math.pi / 8 * 0.05 * depth**2)
    assert stored == pytest.approx(1 * 9.81 * 0.1)  # J, of the fall: its length is the largest elastic penetration
