"""The law sheet against published numbers, an integration of the law expressions alone, and text read back by the reader of user expressions."""

import json
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from bench import evaluate, numbers
from each import each
from mpmath import mp, mpf

from hertzwerk.derive import InputError
from hertzwerk.derive.audit.audit_text import audit_expression, declarations
from hertzwerk.derive.exchange.law_sheets.free_impact import (
    restitution_limits,
    restitution_out,
    trials,
)
from hertzwerk.derive.exchange.law_sheets.law_sheet import laws_named, operations_of, sheet
from hertzwerk.derive.expressions.algebra.notation import latex_name, text_of
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import GRADES, DampingLaw, StiffnessLaw

DAMPING = {name: law for name, law in LAWS.items() if isinstance(law, DampingLaw)}
STIFFNESS = {name: law for name, law in LAWS.items() if isinstance(law, StiffnessLaw)}


@pytest.fixture(scope="module")
def sheets():
    return {name: sheet(law) for name, law in LAWS.items()}


def test_every_law_has_a_sheet_that_is_json_without_forces_of_inconsistent_laws(sheets):
    for name, result in sheets.items():
        assert json.loads(json.dumps(result.record()))["name"] == name
        assert result.grade_meaning == GRADES[LAWS[name].grade]
        assert result.formulas
        assert all(f.text and f.latex for f in (*result.formulas, *result.definitions))
        explained = {entry.name for entry in result.symbols} | {f.symbol for f in result.definitions}
        assert {q.name for q in LAWS[name].quantities} <= explained
    assert all(point.force is None for point in sheets["bai_zhao"].points)
    assert all(point.force is not None for point in sheets["palmgren"].points)  # fitted in mm and N, and taken there
    for a, b in zip(sheets["palmgren"].points, sheets["palmgren_si"].points, strict=True):
        assert a.force == pytest.approx(b.force, rel=1e-12)


@each("name", [name for name, law in STIFFNESS.items() if law.verdict == "consistent"])
def test_local_exponent_is_the_slope_in_a_log_log_plot(sheets, name):
    """By a difference quotient of the forces, against the derivative on the sheet."""
    law = STIFFNESS[name]
    outside = law.pairs == ("parallel_cylinders",)
    for point in sheets[name].points:
        pair = {"E": "207e9", "nu": "0.3", "R_1": "0.010", "R_2": "0.0095", "L": "0.015"}
        values = numbers(law, pair)
        if outside:
            values |= {q: mpf("0.0195") for q in values if q.name == "dR"}
        with mp.workdps(40):
            d = next(q for q in law.force.free_symbols if q.name == "d")
            step = mpf("1e-12")
            high, low = (
                evaluate(law.force, values | {d: mpf(repr(point.penetration)) * (1 + s)}) for s in (step, -step)
            )
            slope = mp.log(high / low) / mp.log((1 + step) / (1 - step))
        assert point.exponent == pytest.approx(float(slope), rel=1e-9)
        if sheets[name].local_exponent.replace("/", "").isdigit():
            assert point.exponent == pytest.approx(float(sp.Rational(sheets[name].local_exponent)), rel=1e-12)


def test_exponents_of_the_models_named_after_the_paper(sheets):
    """The models named after it have n = 1, at every penetration; the secant of Liu's law is stated so too, and is 3/2 at small penetration."""
    for name in ("wang_liu_internal", "wang_liu_external"):
        result = sheets[name]
        assert (result.exponent, result.local_exponent, result.law.grade) == ("1", "1", "R")
    result = sheets["wang_liu_secant"]
    assert (result.exponent, result.local_exponent, result.law.grade) == ("1", "", "R")
    assert result.points[0].exponent == pytest.approx(1.5, abs=2e-5)
    assert sheets["galin_sneddon"].local_exponent == "(k + 1)/k"


@each("name", DAMPING)
def test_limits_are_what_is_approached(name):
    """Towards e = 0 and e = 1 what is returned comes ever closer to the limit stated."""
    law, limits = DAMPING[name], restitution_limits(DAMPING[name])
    if limits[0] is None:
        return
    for limit, near, nearer in ((limits[0], 1 - 1e-3, 1 - 1e-6), (limits[1], 1e-3, 1e-6)):
        far, close = (abs(restitution_out(law, e) - limit) for e in (near, nearer))
        assert close < 2e-5
        assert close <= far / 100 or far < 1e-12


def test_published_exponents():
    """Of Kelvin and Voigt a spring K d; of the rest Hertz."""
    assert {t.law.name: t.exponent for t in trials() if t.exponent != 1.5} == {"kelvin_voigt": 1.0}


@each("name", [n for n, law in LAWS.items() if law.kind != "damping" and law.verdict == "consistent"])
def test_text_is_what_the_audit_of_expressions_reads(sheets, name):
    """`hertzwerk audit --expr` finds the unit that the sheet states for each formula it can read."""
    law, found = LAWS[name], sheets[name]
    units = [f"{q.name}={q.unit.replace('(1-k)', '(-1)')}" for q in (*law.symbols(), *(q for q, _ in law.definitions))]
    units += [] if any(u.startswith("F=") for u in units) else ["F=N"]
    for formula in found.formulas:
        if "LambertW" in formula.text or "gamma(" in formula.text or name == "galin_sneddon":
            continue
        finding = audit_expression(formula.text, *declarations(sorted(set(units)), []), formula.unit)
        assert finding.verdict == "consistent", (formula, finding.sentence)


@each("name", LAWS)
def test_text_evaluates_to_the_law(name):
    """The printed formula, evaluated as Python, is the record's expression: nothing is lost in tidying up."""
    law = LAWS[name]
    functions = {f: getattr(mp, f) for f in ("sqrt", "exp", "log", "tanh", "atan", "sign", "gamma", "pi")}
    functions |= {"where": lambda c, a, b: a if c else b, "max": max, "min": min, "abs": abs}
    functions["LambertW"] = lambda x, k: mp.lambertw(x, k).real
    with mp.workdps(40):
        expressions = [e for _, e, _ in law.expressions()] + [e for _, e in law.definitions]
        for expression in expressions:
            symbols = sorted(expression.free_symbols, key=str)
            values = {q: mpf(3 + i) / 7 for i, q in enumerate(symbols)}
            if expression.has(sp.LambertW):
                values |= {q: mpf("0.01") for q in symbols if q.name == "d"}
            text = text_of(expression).replace("/", "/mpf(1)/")
            actual = eval(
                text, functions | {q.name: x for q, x in values.items()} | {"mpf": mpf}
            )  # our own text, of our own laws
            expected = evaluate(expression, values)
            assert abs(actual - expected) <= mpf("1e-14") * abs(expected)


def test_latex(sheets):
    assert sheets["hertz_point"].formulas[0].latex == r"F = K d^{\frac{3}{2}}"
    assert [latex_name(sp.Symbol(x)) for x in ("dR", "E_eff", "nu_1", "v0")] == [
        r"\Delta R", r"E_{\mathrm{eff}}", r"\nu_{1}", "v_{0}",
    ]  # fmt: skip
    zhiying = sheets["zhiying_qishao"].definitions[-1].latex
    assert r"\mathrm{e}^{2 - 2 e}" in zhiying  # Euler's number is not the restitution
    for name, result in sheets.items():
        for formula in result.formulas:
            assert formula.latex.count("{") == formula.latex.count("}"), name
            assert "Where" not in formula.latex


def test_operations_are_those_of_the_generated_text():
    """By hand: K d sqrt(d) is three; F h v/v0 is three; Johnson adds the rational steps of Lambert's function."""
    assert operations_of(LAWS["hertz_point"])[1] == 3
    assert operations_of(LAWS["popov_line"])[1] == 1
    assert operations_of(LAWS["hunt_crossley"]) == (4, 3)  # 3/2 is one of the four
    assert operations_of(LAWS["exact"])[1] == 3
    assert operations_of(LAWS["johnson"])[1] > 50


def test_ranges_memory_and_unknown_names_are_reported(sheets):
    e = next(entry for entry in sheets["lankarani_nikravesh"].symbols if entry.name == "e")
    assert (e.origin, e.defined, e.recommended) == ("parameter", "[0, 1]", "(0.8, 1]")
    assert sheets["lankarani_nikravesh"].memory == ("v0 [m/s], approach speed, latched at the onset of the contact",)
    assert "gap opens" in sheets["tsuji"].release
    assert next(s for s in sheets["pereira_internal_si"].symbols if s.name == "dR").defined == "[5e-06, 0.01]"
    assert sheets["lugre"].memory[0].startswith("z [m]")
    with pytest.raises(InputError) as caught:
        laws_named(("flores", "jonson", "nonsense"))
    assert len(caught.value.faults) == 2
    assert "johnson" in caught.value.faults[0].remedy
    assert "hertzwerk laws" in caught.value.faults[1].expected


def test_trials_take_one_parameter_each():
    for trial in trials():
        assert isinstance(trial.scene.parameters[trial.parameter], Parameter)
        assert (trial.recommended is None) == (trial.parameter != "e")
    assert np.isfinite([t.exponent for t in trials()]).all()


def test_reconstructions_show_the_band_of_their_candidates(sheets):
    """Every candidate that may stand at the pair, the law first; forces are those of the laws they equal under another name."""
    inside, outside = sheets["wang_liu_internal"].band, sheets["wang_liu_external"].band
    assert {c.law for c in inside.candidates} == {
        "wang_liu_internal", "wang_liu_secant", "wang_liu_half_width", "wang_liu_johnson",
    }  # fmt: skip
    assert outside.candidates[0].law == "wang_liu_external"
    assert {c.law for c in outside.candidates} == {"wang_liu_external", "wang_liu_half_width", "wang_liu_johnson"}
    for band in (inside, outside):
        assert band.penetrations[0] == pytest.approx(1e-8) and band.penetrations[-1] == pytest.approx(1e-4)
        assert set(band.candidates[0].exponents) == {1.0}
    micrometre = next(k for k, depth in enumerate(inside.penetrations) if depth == pytest.approx(1e-6))
    at = {c.law: c.forces[micrometre] for c in inside.candidates}
    assert at["wang_liu_johnson"] == pytest.approx(610.964, abs=5e-4)
    assert at["wang_liu_secant"] == pytest.approx(84.660, abs=5e-4)
    assert at["wang_liu_internal"] == pytest.approx(2 * 1339.92, abs=0.01)
    assert inside.spread[micrometre] == pytest.approx(2 * 1339.92 / 84.660, rel=1e-5)
    assert sheets["johnson"].band is None


def test_a_law_for_pairs_of_ones_own_has_no_example_of_another_kind(sheets):
    law = replace(LAWS["wang_liu_internal"], pairs=("dome",))
    assert sheets["wang_liu_internal"].example
    assert (sheet(law).example, sheet(law).points, sheet(law).band) == ("", (), None)
