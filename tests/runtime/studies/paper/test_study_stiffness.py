"""The study of stiffness laws: forces against closed forms, two audits that agree, verdicts that see faults."""

from dataclasses import replace

import pytest

from hertzwerk.runtime.studies.paper import study_stiffness as study


@pytest.fixture(scope="module")
def laws():
    return study._laws()[0]


def verdicts(laws):
    return [verdict.holds for verdict in study._law_verdicts(laws)[:3]]


def with_fault(laws, name, **fields):
    return [replace(law, **fields) if law.name == name else law for law in laws]


def test_exponents_are_those_of_the_formulas(laws):
    assert study.fitted_exponent(3e9 * study.DEPTHS**1.23) == pytest.approx(1.23, abs=1e-4)
    assert 1 < study.fitted_exponent(laws[0].over_depth) < 1.5
    actual = {law.name: law.exponent() for law in laws}
    assert actual["hertz_point"] == pytest.approx(1.5)
    assert actual["popov_line"] == pytest.approx(1)
    x = study.DEPTH / study.CLEARANCE
    assert actual["liu_with_length"] == pytest.approx(1 + 0.5 / (1 + x), rel=1e-3)
    # 8775.02 N at 10 um: computed independently.
    assert study.johnson_penetration(8775.02) == pytest.approx(1e-5, rel=1e-6)


def test_the_verdicts_hold_and_see_a_fault_in_the_forces(laws):
    assert verdicts(laws) == [True] * 3
    wrong = {law.name for law in laws if not law.consistent}
    assert wrong == {"goldsmith", "pereira_internal", study.FITTED, "liu", "bai_zhao"}
    assert {law.name for law in laws if study._abnormal(law, laws)} == wrong - {"goldsmith"}
    by_name = {law.name: law for law in laws}
    shifted = with_fault(laws, "hertz_point", over_depth=by_name["hertz_point"].over_depth * (1 + 1e-8))
    assert verdicts(shifted) == [False, True, True]
    shifted = with_fault(laws, "johnson", over_depth=by_name["johnson"].over_depth * (1 + 1e-8))
    assert verdicts(shifted) == [True, False, True]
    hidden = replace(by_name["liu"].curve, in_mm=by_name["liu"].curve.forces)
    assert verdicts(with_fault(laws, "liu", curve=hidden)) == [True, True, False]
