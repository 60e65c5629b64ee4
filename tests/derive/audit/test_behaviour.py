"""What every law owes beyond its units: the catalogue gives it, and every way to fail is told with the point where."""

from dataclasses import replace

import pytest
import sympy as sp
from drop import drop
from each import each

from hertzwerk.derive import Contact, Friction, InputError, Parameter, generate, laws_from
from hertzwerk.derive.audit.admissibility import faults_if_consistent, law_faults, scene_faults
from hertzwerk.derive.exchange.user_files.audit_files import audit_path
from hertzwerk.derive.expressions.parameter import POSITIVE
from hertzwerk.derive.laws import LAWS, flores, hertz_point, power
from hertzwerk.derive.laws.formulas.friction import mu, v_s
from hertzwerk.derive.laws.formulas.lubrication import eta
from hertzwerk.derive.laws.law import (
    FORMS,
    DampingLaw,
    F,
    FrictionLaw,
    N,
    Quantity,
    R_eff,
    R_min,
    StiffnessLaw,
    d,
    s,
    v,
    v0,
)

K = Quantity("K", "N/m^1.5", "stiffness", POSITIVE)
K_1 = Quantity("K_1", "N/m", "stiffness", POSITIVE)
K_3 = Quantity("K_3", "N/m^3", "softening")
F_0 = Quantity("F_0", "N", "preload", POSITIVE)
W_0 = Quantity("W_0", "J", "an energy", POSITIVE)
c = Quantity("c", "N s/m", "damping", POSITIVE)
HALF = sp.Rational(1, 2)


def stiffness(force, *parameters, **fields):
    return StiffnessLaw("own", "own", parameters, "a test", "C", force=force, **({"forms": FORMS} | fields))


def damping(term, *parameters):
    memory = (v0,) if term.has(v0) else ()
    return DampingLaw("own", "own", parameters, "a test", "C", term=term, memory=memory)


def friction(force, slope=sp.S.Zero, **fields):
    return FrictionLaw("own", "own", (mu, v_s), "a test", "C", force=force, slope=slope, **fields)


HERTZ = K * d ** sp.Rational(3, 2)
SMOOTH = mu * N * sp.tanh(s / v_s)
bristle = LAWS["lugre"]
film = LAWS["short_bearing"]

WRONG = {
    "stored, a wrong factor": (stiffness(HERTZ, K, stored=sp.Rational(3, 5) * K * d ** sp.Rational(5, 2)), "as everywhere: 1.5 of it"),
    "stored, of another shape": (stiffness(HERTZ, K, stored=K * d**3 / (d + R_eff) ** HALF), "the force, "),
    "stored, not zero at the onset": (stiffness(HERTZ, K, W_0, stored=sp.Rational(2, 5) * K * d ** sp.Rational(5, 2) + W_0), "0 J before"),
    "a preload": (stiffness(K_1 * d + F_0, K_1, F_0), "0 N, and no jump at the onset"),
    "a pull": (stiffness(-K_1 * d, K_1), "a force above 0 that rises"),
    "a softening force": (stiffness(K_1 * d - K_1 * d**2 / R_min, K_1), "state a `reach` below"),
    "a force that ends": (stiffness(K_1 * d * sp.sqrt(1 - 4 * d / R_min), K_1), "no finite real number"),
    "a reach of nothing": (replace(hertz_point, name="own", reach=-hertz_point.reach), "a penetration above 0"),
    "another relation": (replace(LAWS["johnson"], name="own", relation=2 * LAWS["johnson"].relation), "of which `force` is the force"),
    "a dashpot that pushes": (damping(-c * v, c), "takes energy, and gives none"),
    "a dashpot even in the rate": (damping(c * sp.Abs(v), c), "takes energy, and gives none"),
    "damping that stays at rest": (damping(c * v + F * sp.Rational(1, 100), c), "takes energy, and gives none"),
    "damping undefined at a rate": (damping(c * v * sp.sqrt(1 - (v / v0) ** 2), c), "no finite real number"),
    "even friction": (friction(mu * N * sp.cos(s / v_s)), "0 N at rest"),
    "friction that drives": (friction(-SMOOTH, -mu * N / v_s), "takes energy, and gives none"),
    "friction of one direction": (friction(SMOOTH * sp.exp(s / v_s), mu * N / v_s), "an odd function of s"),
    "another slope at rest": (friction(SMOOTH, 2 * mu * N / v_s), "its derivative there"),
    "an infinite slope": (friction(mu * N * sp.sign(s) * sp.Abs(s / v_s) ** HALF, mu * N / v_s), "its derivative there"),
    "sticking that pushes": (replace(LAWS["coulomb"], name="own", holding=-LAWS["coulomb"].holding), "not below 0"),
    "a bristle that drives": (replace(bristle, name="own", force=-bristle.force), "takes energy, and gives none"),
    "a film that drives": (replace(film, name="own", along=-film.along), "a drag not below 0"),
    "a film undefined": (replace(film, name="own", couple=film.couple * sp.sqrt(-eta / eta)), "no finite real number"),
}  # fmt: skip


@each("name", LAWS)
def test_the_catalogue_gives_what_is_owed(name):
    assert law_faults(LAWS[name]) == ()


@each("wrong", WRONG)
def test_a_law_that_fails_is_reported_with_the_point(wrong):
    law, said = WRONG[wrong]
    fault, *_ = law_faults(law)
    assert said in str(fault)
    assert fault.where.startswith("law own, ") and " = " in fault.where
    assert fault.remedy


def test_the_turning_point_is_found():
    """K d (1 - d/(2 h)) rises up to h: the point told is known to three digits."""
    h = Quantity("h", "m", "length", POSITIVE)
    law = stiffness(K_1 * d * (1 - d / (2 * h)), K_1, h, defaults=((h, Parameter("h", "mm", 0.3)),))
    fault, *_ = law_faults(law)
    assert "state a `reach` below 0.0003 m" in fault.remedy
    assert "h = 0.0003 m" in fault.where
    assert law_faults(replace(law, reach=h * sp.Rational(99, 100))) == ()


def test_units_come_first():
    """Of a law whose units do not hold numbers say nothing: its audit has the cause."""
    hidden = stiffness(K_1 * d * sp.log(sp.Rational(1, 10) * d), K_1)
    assert law_faults(hidden) != () == faults_if_consistent(hidden)


# -- scenes --------------------------------------------------------------------------------------------------------------

E_SCENE = Parameter("stiffness", "N/m", 1e6)


def softening(third):
    law = stiffness(K_1 * d - K_3 * d**3, K_1, K_3)
    return law(E_SCENE, Parameter("third", "N/m^3", third))


def test_a_scene_is_tried_at_its_numbers_unless_its_law_is_unchecked():
    # A softening spring holds or not by the numbers it is given: at those of the scene, up to the smaller radius.
    assert "state a `reach` below 0.000577 m" in str(*scene_faults(drop(effects=(Contact("floor", softening(1e12)),))))
    assert not [*scene_faults(drop(effects=(Contact("floor", softening(1.0)),)))]
    with pytest.raises(InputError, match="no longer rising"):
        generate(drop(effects=(Contact("floor", softening(1e12)),)))
    assert not [*scene_faults(drop(effects=(Contact("floor", softening(1e12), unchecked=True),)))]


def test_laws_of_ones_own_are_tried_over_their_ranges_in_a_scene():
    bad = stiffness(HERTZ, K, stored=K * d ** sp.Rational(5, 2))(Parameter("stiff", "N/m^1.5", 1e8))
    with pytest.raises(InputError, match="a factor is wrong"):
        generate(drop(effects=(Contact("floor", bad),)))
    drags = friction(mu * N * sp.cos(s / v_s))(Parameter("mu", "1", 0.1), Parameter("v_s", "m/s", 0.01))
    sound = Contact("floor", power(Parameter("stiff", "N/m^1.5", 1e8), 1.5), flores(Parameter("e", "1", 0.8)))
    with pytest.raises(InputError, match="0 N at rest"):
        generate(drop(effects=(sound, Friction("drag", "floor", drags))))


# -- files -------------------------------------------------------------------------------------------------------------

FILE = """
[[law]]
name = "mine"
kind = "stiffness"
source = "a test"
form = "point"
force = "K*d**1.5"
stored = "3/5*K*d**2.5"
symbols.K = { unit = "N/mm^1.5", meaning = "stiffness", limits = "(0, inf)" }

[[law]]
name = "even"
kind = "friction"
source = "a test"
force = "mu*N*cos(s/v_s)"
slope = "0"
symbols.mu = { unit = "1", meaning = "coefficient of friction", limits = "[0, inf)" }
symbols.v_s = { unit = "mm/s", meaning = "a speed", default = 10 }
"""


def test_a_file_of_laws_is_refused_with_every_fault(tmp_path):
    path = tmp_path / "laws.toml"
    path.write_text(FILE, encoding="utf-8")
    for read in (laws_from, audit_path):
        with pytest.raises(InputError) as raised:
            read(path)
        stored, even = raised.value.faults
        assert "law mine, stored energy at d = " in stored.where and "N/mm^1.5" in stored.where
        assert "law even, friction force at s = 0.0 m/s, N = 1.0 N" in even.where and "v_s = 10.0 mm/s" in even.where
    path.write_text(FILE.replace("3/5", "2/5").replace("cos", "tanh").replace('slope = "0"\n', ""), encoding="utf-8")
    assert [*laws_from(path)] == ["mine", "even"]
