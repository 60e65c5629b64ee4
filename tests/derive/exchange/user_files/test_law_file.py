"""Own laws from TOML: the records they make, every fault at once, the audit of what is written, and a scene that uses one."""

import tomllib
from dataclasses import replace

import pytest
import sympy as sp
from each import each
from hypothesis import example, given
from hypothesis import strategies as st

from hertzwerk.derive import InconsistentUnits, Parameter, audit_scene, generate, laws_from
from hertzwerk.derive.audit.audit import audit_law, verdict
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.exchange.user_files.law_file import audit_laws_as_written, read_laws
from hertzwerk.derive.expressions.parameter import Interval
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import APPROACH_SPEED, DampingLaw, FrictionLaw, Law, Quantity, StiffnessLaw, d, dR, s
from hertzwerk.derive.scenes import soft_ball, two_spheres

FOAM = """
[[law]]
name = "foam"
kind = "stiffness"
form = "any"
title = "Foam pad"
source = "measured, 2024"
grade = "C"
force = "K*d**n*exp(d/h)"
reach = "h"
exponent = "n"
symbols.K = { unit = "N/m^n", meaning = "stiffness", limits = "(0, inf)" }
symbols.n = { unit = "1", meaning = "exponent", limits = "[1, 3]" }
symbols.h = { unit = "mm", meaning = "thickness", limits = "[1, 5 cm)", default = 20 }
ranges.dR = { defined = "[5e-6, 1 mm]", recommended = "(1 um, inf)" }
"""
HERTZ = """
[[law]]
name = "my_hertz"
kind = "stiffness"
form = "any"
source = "Hertz 1882"
force = "K*d**1.5"
stored = "2/5*K*d**2.5"
reach = "R_min"
exponent = 1.5
symbols.E = { unit = "GPa", meaning = "Young's modulus of both bodies", limits = "(0, inf)" }
symbols.nu = { unit = "1", meaning = "Poisson's ratio of both bodies", limits = "(-1, 0.5]" }
definitions = [
    { symbol = "E_eff", unit = "Pa", meaning = "effective modulus", expression = "E/(2*(1 - nu**2))" },
    { symbol = "K", unit = "N/m^1.5", meaning = "stiffness", expression = "4/3*E_eff*sqrt(R_eff)" },
]
"""
DAMPING = """
[[law]]
name = "my_flores"
kind = "damping"
source = "Flores et al. 2011"
factor = "8*(1 - e)/(5*e)"
symbols.e = { unit = "1", meaning = "coefficient of restitution" }
ranges.e = { defined = "(0, 1]", recommended = "[0.1, 1]" }

[[law]]
name = "my_dashpot"
kind = "damping"
source = "a textbook"
term = "2*xi*sqrt(k_t*m_eff)*v"
exponent = 0
release = "gap"
symbols.xi = { unit = "1", meaning = "damping ratio", limits = "[0, inf)" }
"""
FRICTION = """
[[law]]
name = "my_coulomb"
kind = "friction"
source = "a textbook"
force = "mu*N*tanh(s/v_s)"
symbols.mu = { unit = "1", meaning = "coefficient of friction", limits = "[0, inf)" }
symbols.v_s = { unit = "mm/s", meaning = "speed of build-up", limits = "(0, inf)" }
"""


@pytest.fixture
def file(tmp_path):
    def write(text):
        path = tmp_path / "laws.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def named(law: Law, name: str) -> Quantity:
    return next(symbol for symbol in law.symbols() if symbol.name == name)


# --- records --------------------------------------------------------------------------------------------------------


def test_a_stiffness_law(file):
    law = laws_from(file(FOAM))["foam"]
    assert isinstance(law, StiffnessLaw)
    K, n, h = law.parameters
    assert law.force == K * d**n * sp.exp(d / h)
    assert (law.exponent, law.reach, law.stored) == (n, h, None)
    assert (K.unit, n.meaning, h.limit) == ("N/m^n", "exponent", Interval(1e-3, 0.05, open_right=True))
    assert K.limit == Interval(0, None, open_left=True)
    assert [(symbol, value.default, value.unit) for symbol, value in law.defaults] == [(h, 20, "mm")]
    assert [(row.quantity, row.kind, row.interval.lower, row.interval.upper) for row in law.ranges] == [
        (dR, "defined", 5e-6, 1e-3), (dR, "recommended", 1e-6, None),
    ]  # fmt: skip
    assert (law.title, law.source, law.grade, law.verdict) == ("Foam pad", "measured, 2024", "C", "consistent")
    assert law.geometry == (dR,)
    values = {K: 3.0, n: 2.0, h: 0.02, d: 1e-3}
    work = sp.Integral(law.force.subs({K: 3, n: 2, h: sp.Rational(1, 50)}), (d, 0, sp.Rational(1, 1000))).doit()
    assert float(law.work.subs(values)) == pytest.approx(float(work), rel=1e-12)  # stored is integrated numerically


def test_definitions_and_the_built_in_law_they_retype(file):
    law = laws_from(file(HERTZ))["my_hertz"]
    E, nu = law.parameters
    (E_eff, modulus), (K, stiffness) = law.definitions
    assert modulus == E / (2 * (1 - nu**2))
    assert stiffness == sp.Rational(4, 3) * E_eff * sp.sqrt(named(law, "R_eff"))
    assert law.force == K * d ** sp.Rational(3, 2)
    assert law.exponent == sp.Rational(3, 2)
    assert law.geometry == LAWS["hertz_point"].geometry


def test_damping_laws(file):
    laws = laws_from(file(DAMPING))
    flores, dashpot = laws["my_flores"], laws["my_dashpot"]
    assert isinstance(flores, DampingLaw)
    (e,) = flores.parameters
    assert flores.factor.subs(e, sp.Rational(1, 2)) == LAWS["flores"].factor.subs(
        LAWS["flores"].parameters[0], sp.Rational(1, 2)
    )
    assert flores.memory == (APPROACH_SPEED,)
    assert (flores.defined, flores.recommended) == (Interval(0, 1, open_left=True), Interval(0.1, 1))
    assert (dashpot.memory, dashpot.release, dashpot.exponent) == ((), "gap", 0)
    assert [symbol.name for symbol in dashpot.geometry] == ["m_eff"]


def test_a_friction_law_and_its_slope(file):
    law = laws_from(file(FRICTION))["my_coulomb"]
    assert isinstance(law, FrictionLaw)
    assert law.slope == sp.diff(law.force, s).subs(s, 0)
    mu, v_s = law.parameters
    assert law.slope == mu * named(law, "N") / v_s
    with pytest.raises(InputError, match="slope at s = 0"):
        laws_from(file(FRICTION.replace("tanh(s/v_s)", "sign(s)*(1 - exp(-abs(s)/v_s))")))
    given = FRICTION.replace("tanh(s/v_s)", "sign(s)*(1 - exp(-abs(s)/v_s))").replace(
        'force = "', 'slope = "mu*N/v_s"\nforce = "'
    )
    assert laws_from(file(given))["my_coulomb"].slope == law.slope.subs(
        dict(zip(law.parameters, laws_from(file(given))["my_coulomb"].parameters, strict=True))
    )


# --- audit ----------------------------------------------------------------------------------------------------------


def test_every_expression_is_audited_as_written(file):
    findings = audit_laws_as_written(file(FOAM + HERTZ + DAMPING + FRICTION))
    assert {f.verdict for f in findings} == {"consistent"}
    assert [f.quantity for f in findings if f.law == "my_hertz"] == [
        "definition of E_eff", "definition of K", "force", "stored", "reach", "exponent",
    ]  # fmt: skip
    assert [f.found for f in findings if f.law == "my_hertz"] == ["Pa", "N/m^1.5", "N", "J", "m", "1"]


MISTAKES = [  # law, change, expression at fault, sub-expression, found, expected
    (FOAM, ("K*d**n*exp(d/h)", "K*d**1*exp(d/h)"), "force", "K*d**1*exp(d/h)", "N/m^(n-1)", "N"),
    (FOAM, ("exp(d/h)", "exp(5*d)"), "force", "exp(5*d)", "m", "1"), (FOAM, ("exp(d/h)", "(1 + d - d)"), "force", "1 + d", "1", "m"),
    (FOAM, ('reach = "h"', 'reach = "h**2"'), "reach", "h**2", "m^2", "m"),
    (FOAM, ('"N/m^n"', '"N/m^1.5"'), "force", "K*d**n*exp(d/h)", "N m^(n-1.5)", "N"),
    (HERTZ, ("sqrt(R_eff)", "sqrt(L)*R_eff"), "definition of K", "4/3*E_eff*sqrt(L)*R_eff", "N/m^0.5", "N/m^1.5"),
    (HERTZ, ("d**2.5", "d**1.5"), "stored", "2/5*K*d**1.5", "N", "J"), (DAMPING, ("8*(1 - e)", "8*(m_eff - e)"), "factor", "m_eff - e", "1", "kg"),
    (DAMPING, ("k_t*m_eff", "F*m_eff"), "term", "2*xi*sqrt(F*m_eff)*v", "N m^0.5", "N"),
    (FRICTION, ("s/v_s", "5*s"), "force", "tanh(5*s)", "m/s", "1"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "change", "what", "part", "found", "expected"), MISTAKES, ids=[row[1][1] for row in MISTAKES]
)
def test_a_mistake_is_found_in_the_text(file, text, change, what, part, found, expected):
    assert change[0] in text
    wrong = [f for f in audit_laws_as_written(file(text.replace(*change))) if f.verdict != "consistent"]
    assert [(f.quantity, f.subexpression) for f in wrong][:1] == [(what, part)]
    assert (wrong[0].found, wrong[0].expected) == (found, expected) or {wrong[0].found, wrong[0].expected} == {
        found,
        expected,
    }


@pytest.mark.parametrize("text", [FOAM, HERTZ, DAMPING, FRICTION], ids=["foam", "hertz", "damping", "friction"])
def test_the_audit_of_the_record_agrees_with_that_of_the_text(file, text):
    path = file(text)
    for name, law in laws_from(path).items():
        assert verdict(audit_law(law)) == verdict(f for f in audit_laws_as_written(path) if f.law == name)
    wrong = file(FOAM.replace("N/m^n", "N/m^1.5"))
    assert verdict(audit_law(laws_from(wrong)["foam"])) == verdict(audit_laws_as_written(wrong)) == "inconsistent"


def test_a_law_may_say_that_it_was_fitted_outside_si(file):
    text = FOAM.replace("exp(d/h)", "exp(5*d)").replace('grade = "C"', 'verdict = "outside_si"\nfitted_in = "mm, N"')
    path = file(text)
    assert laws_from(path)["foam"].fitted_in == "mm, N"
    assert verdict(audit_laws_as_written(path)) == verdict(audit_law(laws_from(path)["foam"])) == "outside_si"


# --- a scene --------------------------------------------------------------------------------------------------------


def test_a_scene_uses_a_law_of_a_file_like_a_built_in_one(file):
    """The built-in scene with its stiffness law retyped in TOML derives to the same forces."""
    retyped = HERTZ.replace("E/(2*(1 - nu**2))", "1/((1 - nu**2)/E + (1 - nu_2**2)/E_2)").replace(
        "definitions = [", 'symbols.E_2 = { unit = "Pa" }\nsymbols.nu_2 = { unit = "1" }\ndefinitions = ['
    )
    retyped = retyped.replace("of both bodies", "of the first body")
    law = laws_from(file(retyped))["my_hertz"]
    contact = two_spheres.scene.effect("spheres")
    scene = two_spheres.scene.replace(spheres=replace(contact, stiffness=law(two_spheres.steel, two_spheres.steel)))
    assert {f.verdict for f in audit_scene(scene)} == {"consistent"}
    ours, theirs = (generate(made, "a test").splitlines() for made in (scene, two_spheres.scene))
    changed = [pair for pair in zip(ours, theirs, strict=True) if pair[0] != pair[1]]
    changed = [pair for pair in changed if not pair[0].startswith("DIGEST = ")]  # of the text
    assert changed
    assert all("my_hertz" in one and one.replace("my_hertz", "hertz_point") == other for one, other in changed)


def test_a_scene_with_an_inconsistent_law_of_a_file_is_refused(file):
    text = "\n".join(line for line in FOAM.splitlines() if not line.startswith("ranges.dR"))  # a plane has no clearance
    law = laws_from(file(text.replace("N/m^n", "N/m^1.5")))["foam"]
    contact = soft_ball.scene.effect("floor")
    K = Parameter("K", "N/m^1.5", 1e6)
    scene = soft_ball.scene.replace(floor=replace(contact, stiffness=law(K, 1.1)))
    with pytest.raises(InconsistentUnits, match="Foam pad"):
        generate(scene, "a test")


# --- faults ---------------------------------------------------------------------------------------------------------

FAULTS = [  # text, parts of the message
    ("", ["no laws", "[[law]]"]), ("x = 1", ["the key 'x'"]), ("law = 3", ["[[law]]"]), ("[[law]\n", ["TOML"]),
    ("[[law]]\nkind = 'spring'", ["'spring'", "stiffness, damping, friction, film"]), (FOAM.replace("kind", "kinds"), ["kind", "none"]),
    (FOAM.replace("force =", "forse ="), ["law foam, forse: found no key", "did you mean force or form?", "the force"]),
    (FOAM.replace('reach = "h"', 'factor = "h"'), ["law foam, factor: found no key", "belongs to a damping law"]),
    (FOAM + FOAM, ["a second law foam"]), (FOAM.replace('"foam"', '"hertz_point"'), ["the name of a built-in law"]),
    (FOAM.replace('"foam"', '"my foam"'), ["'my foam'", "letters, digits and _"]),
    (FOAM.replace('grade = "C"', 'grade = "A+"'), ["'A+'", "A, B, C, R"]), (FOAM.replace("source", "note"), ["where the law comes from"]),
    (FOAM.replace("N/m^n", "newton/m"), ["newton/m", "a unit"]), (FOAM.replace("N/m^n", "Hz"), ["rpm (1 Hz of turns is 60 rpm) or rad/s"]),
    (FOAM.replace("N/m^n", "N/m^q"), ["the exponent q", "declare q"]), (FOAM.replace("[1, 3]", "1..3"), ["an interval such as"]),
    (FOAM.replace("[1, 3]", "[3, 1]"), ["a lower bound below"]), (FOAM.replace("5 cm", "5 s"), ["a quantity in mm"]),
    (FOAM.replace("default = 20", "default = '20 mm'"), ["a finite number"]),
    (FOAM.replace("default = 20", "defualt = 20"), ["symbols.h.defualt: found no key", "did you mean default?"]),
    (FOAM.replace("ranges.dR", "ranges.q"), ["ranges.q"]),
    (FOAM.replace("defined =", "allowed ="), ["ranges.dR.allowed: found no key", "one of defined, recommended"]),
    (FOAM.replace("symbols.h =", "symbols.d ="), ["which the contact supplies", "name h"]),
    (FOAM.replace("symbols.h =", "symbols.exp ="), ["which expressions use themselves"]),
    (FOAM.replace("K*d**n*exp(d/h)", "K*d^n"), ["force, character 4", "a power is written d**n"]),
    (FOAM.replace("K*d**n*exp(d/h)", "K*d**n*v"), ["the name v"]), (FOAM.replace("K*d**n*exp(d/h)", "K*d**n*R_ef"), ["the name R_ef", "R_eff"]),
    (FOAM.replace("K*d**n*exp(d/h)", "diff(K*d**n, d)"), ["'diff'", "operations on scalars"]),
    (FOAM.replace("K*d**n*exp(d/h)", "d > 0"), ["the comparison", "a quantity"]),
    (FOAM.replace("K*d**n*exp(d/h)", "K*d**n*tan(pi/2)"), ["without a value"]),
    (FOAM.replace("K*d**n*exp(d/h)", "__import__('os').system('true')"), ["bare name"]),
    (FOAM.replace('reach = "h"', 'reach = "d"'), ["an expression without d"]),
    (HERTZ.replace("E/(2*(1 - nu**2))", "E*d"), ["definition of E_eff", "an expression without d"]),
    (HERTZ.replace('symbol = "K"', 'symbol = "E"'), ["a second symbol E"]),
    (HERTZ.replace('expression = "E/(2*(1 - nu**2))"', "expression = true"), ["expected"]), (DAMPING.replace("term =", "factor ="), []),
    (DAMPING.replace('term = "2', 'factor = "xi"\nterm = "2'), ["factor and term"]), (DAMPING.replace('"gap"', '"never"'), ["force or gap"]),
    (FRICTION.replace('force = "mu*N', 'note = "mu*N'), ["the force"]),
    (FOAM.replace('grade = "C"', 'fitted_in = "mm"'), ["with verdict outside_si alone"]),
    (FOAM.replace('grade = "C"', 'verdict = "fine"'), ["'fine'"]), (FOAM.replace('title = "Foam pad"', "title = 3"), ["printable text"]),
]  # fmt: skip


@each(("text", "parts"), FAULTS)
def test_faults(file, text, parts):
    with pytest.raises(InputError) as raised:
        laws_from(file(text))
    for part in parts:
        assert part in str(raised.value)


WITHOUT_A_NUMBER = [  # text, parts of the message: nothing of a law that is tried with numbers may raise by itself
    (FOAM.replace('"K*d**n*exp(d/h)"', "0"), ["0, without d"]),
    (FOAM.replace("K*d**n*exp(d/h)", "K*h**n"), ["K*h**n, without d"]),
    (FOAM.replace('"h"', '"h*sqrt(1 - n)"'), ["no length above 0"]),  # complex
    (FOAM.replace('"h"', '"h*max(sqrt(1 - n), 0)"'), ["no length above 0"]),  # compared while complex
    (FOAM.replace('"h"', '"h/max(0, 1 - n)"'), ["no length above 0"]),  # divided by zero
    (FOAM.replace('"h"', '"h*gamma(min(0, n))"'), ["no length above 0"]),  # a pole
    (FOAM.replace("exp(d/h)", "max(sqrt(0.5 - n), 0)"), ["force at d", "no finite real number"]),
    (HERTZ.replace("E/(2*(1 - nu**2))", "E/max(0, nu - 2)"), ["no finite real number"]),
    (HERTZ.replace("E/(2*(1 - nu**2))", "E*where(sqrt(nu - 2) > 0, 1, 2)"), ["no finite real number"]),
]


@pytest.mark.parametrize(("text", "parts"), WITHOUT_A_NUMBER, ids=range(len(WITHOUT_A_NUMBER)))
def test_a_law_without_a_number_has_one_fault(file, text, parts):
    with pytest.raises(InputError) as raised:
        laws_from(file(text))
    assert len(raised.value.faults) == 1
    for part in parts:
        assert part in str(raised.value)


def test_all_faults_of_the_tables_come_at_once(file):
    """Of one law what each entry is by itself, beside what the entries of another mean to each other."""
    wrong = {
        "title = ": "title = 3 #", 'grade = "C"': "grad = 1", 'unit = "mm"': 'unit = "inch"', '"[1, 3]"': "[1, 3]", "default = 20": "default = inf",
    }  # fmt: skip
    text = FOAM
    for old, new in wrong.items():
        text = text.replace(old, new)
    with pytest.raises(InputError) as raised:
        laws_from(file(text + FRICTION.replace("mu*N", "my*N")))
    places = {fault.where for fault in raised.value.faults}
    assert places == {
        "law foam, title", "law foam, grad", "law foam, symbols.h.unit", "law foam, symbols.n.limits", "law foam, symbols.h.default",
        "law my_coulomb, force",
    }  # fmt: skip
    assert all(fault.found and fault.expected for fault in raised.value.faults)


def test_a_file_that_is_none(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        laws_from(tmp_path / "missing.toml")
    with pytest.raises(InputError, match="a folder"):
        laws_from(tmp_path)
    (tmp_path / "large.toml").write_bytes(b"#" * 2_000_000)
    with pytest.raises(InputError, match="more than 100 kB"):
        laws_from(tmp_path / "large.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match="TOML"):
        laws_from(tmp_path / "binary.toml")


JUNK = st.recursive(
    st.one_of(
        st.integers(-9, 9), st.booleans(), st.sampled_from(["", "d", "K*d**n", "N", "1", "(0, 1]", "stiffness", "damping", "friction"]), st.floats(),
    ),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.sampled_from(["K", "n", "unit", "meaning", "symbol", "expression"]), inner, max_size=3),
    ),
    max_leaves=6,
)  # fmt: skip
KEYS = ["name", "kind", "title", "source", "grade", "force", "stored", "reach", "exponent", "factor", "term", "slope", "release", "symbols",
        "definitions", "ranges", "verdict", "fitted_in", "note", "relation"]  # fmt: skip


@example(text=FOAM, changes={"force": 0})  # with a reach
@given(st.sampled_from([FOAM, HERTZ, DAMPING, FRICTION]), st.dictionaries(st.sampled_from(KEYS), JUNK, max_size=3))
def test_junk_in_a_table_is_a_fault_of_the_file(monkeypatch_load, text, changes):
    tables = tomllib.loads(text)["law"]
    tables[0].update(changes)
    monkeypatch_load({"law": tables})
    try:
        for written in read_laws("junk.toml"):
            assert isinstance(written.law, Law)
    except InputError as error:
        assert error.faults


@pytest.fixture(scope="module")
def monkeypatch_load():
    """Sets what the next file is read as."""
    from hertzwerk.derive.exchange.user_files import law_file

    content = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(law_file, "read_toml", lambda path, expected: content["now"])
        yield lambda tables: content.update(now=tables)
