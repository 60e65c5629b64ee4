"""Limits of Hertz's theory, each approached from both sides by a ball that falls on a plane, in closed form."""

import math
from functools import cache

import mpmath
import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.common.hertzian_laws import LINE, POINT
from hertzwerk.derive.laws.catalogue import FILES
from hertzwerk.derive.laws.law import StiffnessLaw
from hertzwerk.runtime import Solution, load, simulate, sweep
from hertzwerk.runtime.engine.solution.hertz_validity import CROSSINGS, WIDE, WORDS, validity

E, NU, RHO, Y, R = 210e9, 0.3, 7850.0, 0.5e9, 0.01
MASS = 4 / 3 * math.pi * R**3 * RHO
MODULUS = E / (2 * (1 - NU**2))  # of two bodies of this material
CONFORMING = {
    "persson", "liu", "liu_with_length", "bai_zhao", "bai_zhao_repaired", "wang_liu_internal", "wang_liu_secant",
}  # fmt: skip
WITHOUT_CURVATURE = {"galin_sneddon"}  # of a rigid profile of its own


@cache
def ball(strength=True, stiffness=None, solid=False):
    """A ball that flies at a plane, both of one material, with or without a yield strength, a solid or a point with mass."""
    steel = hd.Material(
        hd.Parameter("E", "GPa", E / 1e9), hd.Parameter("nu", "1", NU), hd.Parameter("rho", "kg/m^3", RHO),
        hd.Parameter("Y", "MPa", Y / 1e6) if strength else None,
    )  # fmt: skip
    radius = hd.Parameter("radius", "mm", 1e3 * R)
    body = (
        hd.Body.cylinder("ball", radius, 20 * radius, density=steel)
        if solid
        else hd.Body("ball", hd.Parameter("mass", "kg", MASS))
    )
    pair = hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    return load(
        hd.Scene(
            hd.Mechanism("hertzian_ball", (hd.Prismatic("fall", hd.GROUND, body, axis=hd.Y),), (pair,)),
            (
                hd.Contact("floor", hd.laws.hertz_point(steel, steel) if stiffness is None else stiffness),
                hd.EnergyLedger(),
            ),
            hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 1)),
            hd.Start(position={"fall": 1.1 * radius}, speed={"fall": -hd.Parameter("speed", "m/s", 1)}),
        )
    )


def impact(speed, **scene):
    """The checks of one impact, by name."""
    run = simulate(ball(**scene), duration=0.001 / speed + 3e-4, tolerance=1e-9, parameters={"speed": f"{speed!r} m/s"})
    assert len(run.impacts) == 1
    return run, {check.check: check for check in run.engine.validity}


LIMITS = {
    # Johnson, Contact Mechanics (1985), eq. 11.32: the kinetic energy at the onset of yield is 53 R^3 Y^5/E*^4
    "yield": math.sqrt(2 * 53.48 * R**3 * Y**5 / MODULUS**4 / MASS),
    # a^2 = R d at the depth of v^2 = (4/5) K d^2.5/m, Johnson, eq. 11.23
    "width": math.sqrt(16 / 15 * MODULUS * math.sqrt(R) * (WIDE**2 * R) ** 2.5 / MASS),
    # T = 2.87 (m^2/(R E*^2 v))^(1/5), Johnson, eq. 11.24, against a wave through the ball
    "waves": MASS**2 / (R * MODULUS**2) * (2.8683 / (CROSSINGS * 2 * R / math.sqrt(E / RHO))) ** 5,
}  # fmt: skip


@pytest.mark.parametrize("check", LIMITS)
def test_the_speed_of_each_limit_is_that_of_the_closed_form_from_both_sides(check):
    for factor, exceeded in ((0.997, 0), (1.003, 1)):
        found = impact(factor * LIMITS[check])[1][check]
        assert (found.exceeded, found.of, found.contacts) == (exceeded, 1, ("floor",))
        assert found.worst == pytest.approx(1, rel=0.01)


def test_a_fast_impact_warns_once_of_all_limits_with_the_ways_out():
    run, checks = impact(60.0)
    (text,) = [text for text in run.warnings if "Hertz's theory" in text]
    assert [check for check, words in WORDS.items() if f"1 of 1 {words.brief}" in text] == ["yield", "waves"]
    assert text.startswith("floor: contacts exceed Hertz's theory; take an elastic-plastic law. ")
    assert text.endswith("measure the restitution")
    assert all(WORDS[check].remedy in str(checks[check]) for check in ("yield", "waves"))
    assert not any("exceed the law's limit" in text for text in run.warnings)  # which the onset of yield replaces


def test_without_a_yield_strength_none_is_checked_and_waves_cross_the_longest_solid():
    run, checks = impact(1.0, strength=False)
    assert str(checks["yield"]) == "yield of floor not checked: no yield strength"
    assert not any("yield strength" in text for text in run.warnings)
    assert any("exceed the law's limit" in text for text in run.warnings)
    assert impact(1.0, solid=True)[1]["waves"].limit == pytest.approx(10 * impact(1.0)[1]["waves"].limit)


def test_laws_that_are_not_hertzs_are_not_compared_and_their_impacts_not_searched():
    model = ball(False, hd.laws.power(hd.Parameter("K", "N/m^1.5", 1e10), 1.5))
    assert validity(model.engine, np.zeros(5), lambda: pytest.fail("searched")) == ()
    assert simulate(model, duration="1 ms", tolerance=1e-6).engine.validity == ()


@pytest.mark.parametrize("law, line", [("hertz_point", False), ("johnson", True)])
def test_a_pin_encloses_its_limit_at_the_depth_of_johnsons_law(law, line):
    model = load("slider_crank_line", laws={"slider_pin": law}) if line else "slider_crank"
    run = simulate(model, duration="1 ms", tolerance=1e-6)
    (found,) = [check for check in run.engine.validity if check.check == "conformity"]
    outer, apart = 0.010, 0.0005
    inner = outer - apart
    curvature = outer * inner / apart
    if line:
        per = (WIDE * inner) ** 2 / (4 * curvature)  # F/(pi E* L), of Hertz's half-width
        depth = per * (mpmath.log(4 * apart / per) - 1)  # as the law reads with that
    else:
        depth = (WIDE * inner) ** 2 / curvature
    assert found.limit == pytest.approx(float(depth), rel=1e-12)
    assert found.worst == pytest.approx(max(each.peak_penetration for each in run.impacts) / float(depth), rel=1e-12)


def test_every_law_with_an_effective_modulus_is_hertzs_or_known_not_to_be():
    yielding = {
        name for file, names in FILES if file == "plastic" for name in names.split()
    }  # elastic up to the onset of yield
    known = {*POINT, *LINE, *CONFORMING, *WITHOUT_CURVATURE, *yielding}
    elastic = {
        name for name, law in hd.laws.LAWS.items()
        if isinstance(law, StiffnessLaw) and "E_1" in [symbol.name for symbol in law.parameters]
    }  # fmt: skip
    assert elastic <= known and known <= {*hd.laws.LAWS}
    assert all(hd.laws.LAWS[name].forms == ("point",) for name in POINT)
    assert all("line" in hd.laws.LAWS[name].forms for name in LINE)


def test_a_saved_run_keeps_its_warnings_and_a_sweep_states_each_once(tmp_path):
    run, _ = impact(60.0)
    saved = Solution.load(run.save(tmp_path / "run.npz"))
    assert (saved.warnings, saved.engine.validity) == (run.warnings, ())
    result = sweep(ball(), {"speed": ["50 m/s", "60 m/s"]}, duration="60 us", tolerance=1e-6, outputs=["impacts"])
    (shared,) = [each for each in result.summary.warnings.values() if "1 of 1 yield" in each.text]
    assert shared.rows == 2 and shared.worst == 1
