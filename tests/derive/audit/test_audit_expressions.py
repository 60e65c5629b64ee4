"""The audit of expression text: the table, what is written against what SymPy would make of it, exponents, repairs, the catalogue, files."""

import contextlib
import json
import re
import textwrap
from pathlib import Path

import pytest
import sympy as sp
from calls import calls_of
from each import each
from expressions import CONSISTENT, INCONSISTENT, UNITS
from hypothesis import given
from hypothesis import strategies as st

from hertzwerk.derive.audit.audit import audit_law, verdict
from hertzwerk.derive.audit.audit_text import audit_expression, declarations
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.common.units import parse_unit, unit_text
from hertzwerk.derive.exchange.user_files.audit_files import (
    audit_catalogue,
    audit_files,
    audit_path,
    differing_verdicts,
)
from hertzwerk.derive.expressions.dimension.dimension import Dimension, DimensionError
from hertzwerk.derive.expressions.dimension.expression import to_sympy
from hertzwerk.derive.expressions.dimension.reader import read
from hertzwerk.derive.expressions.dimension.walker import check, dimension_of
from hertzwerk.derive.laws import LAWS


def shown(unit):
    return unit_text(parse_unit(unit).exponents)


# --- the table ------------------------------------------------------------------------------------------------------


@each(("text", "unit"), CONSISTENT)
def test_consistent(text, unit):
    finding = audit_expression(text, UNITS, {}, unit)
    assert (finding.verdict, finding.found, finding.expected) == ("consistent", shown(unit), shown(unit))
    assert (finding.subexpression, finding.reason, finding.repair) == ("", "", None)
    open_ended = audit_expression(text, UNITS)
    assert open_ended.found == (shown(unit) if text != "0.0" else "any unit")
    assert open_ended.expected == ""


@each(("text", "unit"), CONSISTENT)
def test_consistent_with_nothing_else(text, unit):
    """The check can fail: each expression is refused where a unit of one more length or temperature is expected."""
    if text == "0.0":
        return
    finding = audit_expression(text, UNITS, {}, f"({unit})*{'mK'[len(text) % 2]}")
    assert finding.verdict == "inconsistent"
    assert finding.subexpression in text


@each(("text", "expect", "part", "one", "other"), INCONSISTENT)
def test_inconsistent(text, expect, part, one, other):
    finding = audit_expression(text, UNITS, {}, expect)
    assert finding.verdict == "inconsistent"
    assert finding.subexpression == part
    assert part in text
    # which of two is right nobody can say without an expectation: the audit expects the commoner, and names both
    assert {finding.found, finding.expected} == {one, other}
    if part == text and expect is not None:
        assert (finding.found, finding.expected) == (one, shown(expect))
    for quoted in (part, finding.found.split(" to the power ")[0]):
        assert quoted in finding.sentence


# --- what is written, and SymPy -------------------------------------------------------------------------------------

SYMBOLS = {name: sp.Symbol(name, real=True) for name in UNITS}
CONSTANTS = [SYMBOLS[name] for name, unit in UNITS.items() if unit == "1"]
DIMENSIONS = {SYMBOLS[name]: Dimension.from_unit(unit, SYMBOLS) for name, unit in UNITS.items()}
COLLAPSED = {  # SymPy has lost what was wrong, or written differently, by the time it could be audited
    "m - m + t", "0*(x + v)", "(x + t)/(x + t)", "sin(omega)**2 + cos(omega)**2", "x + v*(1 - 1)", "(x + v)**0", "log(exp(x))",
    "d**(n + x - x)", "where(d > v, F, F)", "K*d**1",
}  # fmt: skip


@each(("text", "expect"), [(t, u) for t, u in CONSISTENT] + [row[:2] for row in INCONSISTENT])  # fmt: skip
def test_both_walks_agree(text, expect):
    """The audit of the text and the audit of the SymPy expression it means have one verdict, except where SymPy has collapsed the fault."""
    expression = to_sympy(read(text), SYMBOLS)
    try:
        if expect is None:
            dimension_of(expression, DIMENSIONS, CONSTANTS)
            symbolic = "consistent"
        else:
            fault = check(expression, DIMENSIONS, Dimension.from_unit(expect, SYMBOLS), CONSTANTS)
            symbolic = "consistent" if fault is None else "inconsistent"
    except DimensionError:
        symbolic = "inconsistent"
    written = audit_expression(text, UNITS, {}, expect).verdict
    assert written == symbolic or (text in COLLAPSED and symbolic == "consistent")


# --- exponents, values, zero ----------------------------------------------------------------------------------------

PAIR = {"K": "N/m^1.5", "d": "m"}


def test_symbolic_exponents_stay_symbolic():
    units = {"K": "N/m^n", "d": "m", "n": "1"}
    assert audit_expression("K*d**n", units, {}, "N").verdict == "consistent"
    for value in (1, 1.1, 1.5, 7):
        assert audit_expression("K*d**n", units, {"n": value}, "N").verdict == "consistent"
    finding = audit_expression("K*d**n", {**PAIR, "n": "1"}, {}, "N")
    assert finding.verdict == "inconsistent"
    assert finding.found == "N m^(n-1.5)"
    assert finding.consistent_exponent == "3/2"
    assert "consistent only with n = 3/2" in finding.sentence


def test_a_value_is_a_number_and_only_a_literal_zero_has_every_dimension():
    assert audit_expression("a*x", {"x": "m"}, {"a": 3.0}).found == "m"
    assert (
        audit_expression("a*x", {"x": "m", "a": "s"}, {"a": 3.0}).found == "m s"
    )  # the value does not take the unit away
    assert audit_expression("x + a", {"x": "m"}, {"a": 3.0}).verdict == "inconsistent"
    assert audit_expression("0*m + v", UNITS).found == "m/s"
    assert audit_expression("0.0*m/t + v", UNITS).found == "m/s"
    assert audit_expression("max(v, 0)", UNITS).found == "m/s"
    assert audit_expression("0", UNITS, {}, "N").verdict == "consistent"
    assert audit_expression("a*m + v", UNITS, {"a": 0.0}).verdict == "inconsistent"
    assert audit_expression("(1 - 1)*m + v", UNITS).verdict == "inconsistent"


@each(
    ("text", "expect", "exponent", "repair"),
    [
        ("K*d", "N", "3/2", "with d**(3/2) it is N"), ("E*d**1.5", "N", "2", "with d**2 it is N, or with d and a factor of unit m"),
        ("4/3*E*sqrt(d)*d", "N", "2", "with d**2 in all it is N, or with d in all and a factor of unit m"),
        ("log(L/(F*R*s_c))", None, "3", "with L**3 it is dimensionless"), ("sqrt(c*m)", "1/s", "-1", "with m**(-1) it is 1/s"),
        ("(E**2*d**3)**(1/2)", "N", "4", "with d**4 it is N"), ("sqrt(E**2*d**3)*theta", "N", "4", "with d**4 it is N"),
        ("E*sqrt(d)", "N", "2", "with d**2 in place of sqrt(d) it is N, or with d and a factor of unit m"),
        ("d*sqrt(E**2*d)", "N", None, "a factor of unit m^0.5 is missing"),  # no one exponent of both
        ("Kn*d**(2*n - 1)", "N", "1", "consistent only with n = 1"), ("Kn*d**k", "N", "n", "consistent only with k = n"),
        ("Kn*d**n*v", "N", None, "a factor of unit s/m is missing"), ("pi/2*E*d*sqrt(d/(2*(dR + d)))", "N", None, "a factor of unit m is missing"),
        ("tanh(5*v)", None, None, "a factor of unit s/m is missing; if the number 5 hides it, declare it with its unit"),
        ("a_P*dR + b_P", None, None, "b_P would need the unit m"), ("Th - 273.15", None, None, "273.15 would need the unit K"),
        ("x**theta", None, None, None),
    ],
)  # fmt: skip
def test_repairs(text, expect, exponent, repair):
    finding = audit_expression(text, UNITS, {}, expect)
    assert (finding.consistent_exponent, finding.repair) == (exponent, repair)


@each("base", ["E**2*d**3", "E**2/d", "E**2*R*d", "E*d", "d/E**2"])
@each("form", ["({})**(1/2)", "sqrt({})", "a*({})**2", "1/({})", "3/sqrt({})", "sqrt(sqrt({}))"])
def test_a_repair_within_a_root_or_power_is_right_where_it_is_written(base, form):
    """The power that is offered, put into the text in place of the name's, gives the unit expected."""
    units = {"E": "Pa", "d": "m", "R": "m", "a": "1"}
    text = form.format(base)
    for expect in ("N", "N^2", "1/N", "N^0.5"):
        repair = audit_expression(text, units, {}, expect).repair or ""
        named = re.match(r"with (\w)(\*\*\S+)? it is", repair)
        if named is not None:
            put = re.sub(rf"\b{named[1]}\b(\*\*\d)?", named[0].split()[1], text)
            assert audit_expression(put, units, {}, expect).verdict == "consistent", (text, repair)


@each(
    ("text", "expect", "blamed"),
    [
        ("Kn*d**n*(1 + 3*(1 - theta**2)/4*v/t)", "N", "3*(1 - theta**2)/4*v/t is m/s^2"), ("Kn*d**n/(1 + v/t)", "N", "v/t is m/s^2"),
        ("F*(m + x)", "J", "m is kg"), ("1 + 3*v/t", None, "3*v/t is m/s^2"), ("x + 1", None, "1 is 1"),
    ],
)  # fmt: skip
def test_of_a_sum_the_term_is_blamed_that_the_other_factors_contradict(text, expect, blamed):
    assert blamed in audit_expression(text, UNITS, {}, expect).reason


EXPONENTS = st.fractions(min_value=-5, max_value=5, max_denominator=6)


@given(EXPONENTS, EXPONENTS, EXPONENTS)
def test_products_add_exponents(a, b, c):
    """An oracle without the walk: the exponents of a monomial are the sums of its factors' exponents."""
    text = f"F**({a})*x**({b})/t**({c})"
    total = Dimension(a, a + b, -2 * a - c)
    assert audit_expression(text, UNITS).found == str(total)
    assert audit_expression(text, UNITS, {}, str(total)).verdict == "consistent"


@given(EXPONENTS.filter(bool), EXPONENTS)
def test_the_exponent_named_is_the_one(n, power):
    """K [N/m^n] d**p: wrong for p other than n, and the value named makes it right."""
    units = {"K": f"N/m^({n})", "d": "m", "p": "1"}
    if power != n:
        assert audit_expression(f"K*d**({power})", units, {}, "N").verdict == "inconsistent"
    named = audit_expression("K*d**p", units, {}, "N").consistent_exponent
    assert named == str(n)
    assert audit_expression(f"K*d**({named})", units, {}, "N").verdict == "consistent"


# --- bad input ------------------------------------------------------------------------------------------------------


def test_all_faults_come_at_once():
    with pytest.raises(InputError) as raised:
        audit_expression(
            "K*dd**n + q", {"K": "N/m^p", "d": "Hz", "sin": "m", "2x": "m"}, {"n": float("nan")}, "newton!"
        )
    text = str(raised.value)
    for part in (
        "dd", "Did you mean d?", "name q", "exponent p", "rad/s", "rpm", "1/s", "'sin'", "'2x'", "finite number",
        "newton!",
    ):  # fmt: skip
        assert part in text


@each(
    ("text", "units", "part"),
    [
        ("d^2", {"d": "m"}, "a power is written d**n"), ("d**(1/(n - n))", {"d": "m", "n": "1"}, "without a value"),
        ("d**(n*n*n*n*n*n*n)", {"d": "m", "n": "1"}, "degree at most 6"),
        ("d**(a + b + c + e + f)", dict.fromkeys("abcef", "1") | {"d": "m"}, "at most four names"),
        ("d**(a*b*c)*d**(a*b*e)*d**(a/(b + c))*d**(b/(a + e))*d**(c/(e + 2*b))", dict.fromkeys("abce", "1") | {"d": "m"}, "compare"),
        ("K*d", {"K": "N/m^n", "d": "m"}, "declare n with unit 1"),
    ],
)  # fmt: skip
def test_bad_input(text, units, part):
    with pytest.raises(InputError) as raised:
        audit_expression(text, units)
    assert part in str(raised.value)


def test_a_hostile_exponent_takes_little_work():
    names = dict.fromkeys("abce", "1") | {"d": "m"}
    texts = ["d**(" + "*".join(["(a + b + c + e)"] * k) + ")" for k in (2, 4, 6, 60)]
    texts += ["*".join(f"d**(a/(b + {k}))" for k in range(90)), "d**((a + b + c + e)**100)", "d**(a**(b**(c**e)))"]

    def audit():
        for text in texts:
            with contextlib.suppress(InputError):
                audit_expression(text, names)

    assert calls_of(audit) < 6e6  # 1.7e6 measured


def test_declarations_from_the_command_line():
    units, values = declarations(["K=N/m**(3/2)", " d = m"], ["n=1.1", "k=3/2", "z=-2e-3"])
    assert units == {"K": "N/m**(3/2)", "d": "m"}
    assert values == {"n": 1.1, "k": 1.5, "z": -2e-3}
    with pytest.raises(InputError) as raised:
        declarations(["K", "d=", "x=m", "x=s"], ["n=1.1 m", "k=a", "z"])
    assert len(raised.value.faults) == 6


# --- JSON -----------------------------------------------------------------------------------------------------------


def test_the_record_of_a_finding():
    finding = audit_expression("K*d**n", PAIR, {"n": 1.1}, "N")
    assert json.loads(json.dumps(finding.record())) == {
        "law": None, "kind": "expression", "source": None, "grade": None, "verdict": "inconsistent", "found": "N/m^0.4", "expected": "N",
        "subexpression": "K*d**n", "reason": "K*d**n is N/m^0.4, expected N", "consistent_exponent": "3/2",
        "repair": "consistent only with n = 3/2", "advice": None,
    }  # fmt: skip
    assert audit_expression("K*d", PAIR).record()["expected"] is None


# --- the catalogue --------------------------------------------------------------------------------------------------


def test_every_law_has_the_verdict_it_states():
    findings = audit_catalogue()
    assert {finding.law for finding in findings} == set(LAWS)
    assert differing_verdicts(findings) == ()
    for finding in findings:
        law = LAWS[finding.law]
        assert (finding.kind, finding.source) == (law.kind, law.source)
        assert finding.verdict == law.verdict
        if finding.verdict == "consistent":
            assert finding.found == finding.expected != ""
            assert verdict(audit_law(law)) == "consistent"
        else:
            assert finding.subexpression
            assert finding.found != finding.expected
            assert finding.reason


def test_a_wrong_statement_is_noticed():
    from dataclasses import replace

    findings = audit_catalogue()
    changed = [replace(f, verdict="inconsistent") if f.law == "hertz_point" else f for f in findings]
    assert differing_verdicts(changed) == ("hertz_point",)


# --- files ----------------------------------------------------------------------------------------------------------

GOOD_LAW = """
[[law]]
name = "my_foam"
kind = "stiffness"
form = "any"
source = "measured"
force = "K*d**n"
symbols = { K = { unit = "N/m^n", meaning = "stiffness" }, n = { unit = "1", meaning = "exponent", limits = "[1, 3]" } }
"""
BAD_LAW = GOOD_LAW.replace("my_foam", "bad_foam").replace("N/m^n", "N/m^1.5").replace("K*d**n", "K*d**n*(1 + 0*d)")
PYTHON_LAW = """
from hertzwerk.derive.laws import hertz_point  # built in: not this file's
from hertzwerk.derive.laws.law import Quantity, StiffnessLaw, d
c = Quantity("c", "UNIT", "stiffness")
mine = StiffnessLaw(name="mine", title="Mine", parameters=(c,), source="me", grade="C", forms=("point",), force=c*d)
"""


def write(folder: Path, **files: str) -> Path:
    for name, text in files.items():
        path = folder / name.replace("__", "/").replace("_toml", ".toml").replace("_py", ".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text))
    return folder


def test_files_of_laws_and_of_a_scene(tmp_path):
    write(tmp_path, laws_toml=GOOD_LAW + BAD_LAW)
    good, bad = audit_path(tmp_path / "laws.toml")
    assert (good.law, good.kind, good.verdict, good.found) == ("my_foam", "stiffness", "consistent", "N")
    assert (bad.law, bad.verdict, bad.consistent_exponent) == ("bad_foam", "inconsistent", "3/2")
    assert bad.subexpression == "K*d**n"  # as written, and without the sum that cannot be at fault
    write(tmp_path, good_py=PYTHON_LAW.replace("UNIT", "N/m"), bad_py=PYTHON_LAW.replace("UNIT", "N/m^1.5"))
    assert {f.verdict for f in audit_path(tmp_path / "good.py")} == {"consistent"}
    (bad,) = audit_path(tmp_path / "bad.py")
    assert (bad.law, bad.found, bad.expected) == ("mine", "N/m^0.5", "N")
    from hertzwerk.derive.scenes import bouncing_ball

    write(tmp_path, scene_py=Path(bouncing_ball.__file__).read_text())
    findings = audit_path(tmp_path / "scene.py")
    assert findings
    assert {f.verdict for f in findings} == {"consistent"}
    assert {f.kind for f in findings} <= {"stiffness", "damping", "friction", "program"}


def test_a_folder(tmp_path):
    write(
        tmp_path, a__laws_toml=GOOD_LAW, b_py=PYTHON_LAW.replace("UNIT", "N/m^2"),
        other_py="raise SystemExit('never executed: it does not import hertzwerk')",
        tool_py="from hertzwerk.derive import laws\nraise SystemExit('never executed: no scene, no law')", pyproject_toml="[project]\nname = 'x'\n",
        broken_py="def (", c__note_txt="",
    )  # fmt: skip
    write(tmp_path / ".hidden", d_toml=BAD_LAW)
    actual = audit_files(tmp_path)
    assert [path.relative_to(tmp_path).as_posix() for path in actual] == ["a/laws.toml", "b.py"]
    assert [f.verdict for f in audit_path(tmp_path)] == ["consistent", "inconsistent"]


def test_files_that_are_no_input(tmp_path):
    write(tmp_path, empty_py="x = 1", fails_py="1/0", laws_toml="[[law]]\nname = 3", e__pyproject_toml="[project]\n")
    for target, part in (
        (tmp_path / "empty.py", "neither a scene nor a law"), (tmp_path / "fails.py", "ZeroDivisionError"), (tmp_path / "laws.toml", "kind"),
        (tmp_path / "e" / "pyproject.toml", "no laws"), (tmp_path / "e", "a folder without either"), (tmp_path / "missing.py", "no such file"),
        (tmp_path / "missing.toml", "no such file"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=part):
            audit_path(target)
    write(
        tmp_path, again_toml="[[law]]\nkind = 'stiffness'", half_py="from hertzwerk.derive import Scene\nscene = Scene(", half_toml="[[law]]\nname =",
    )  # fmt: skip
    with pytest.raises(InputError) as raised:
        audit_path(tmp_path)
    assert "laws.toml" in str(raised.value)
    assert "again.toml" in str(raised.value)
    assert "half.py, line 2: found SyntaxError" in str(raised.value)  # one that is broken is not passed over
    assert "half.toml" in str(raised.value)
