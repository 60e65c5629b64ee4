"""Equations as texts by `hertzwerk export`: LaTeX that is balanced, a page that fetches nothing, a file that Python imports."""

import re
import types
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.cli.scene_commands.export import export


def printed(*arguments):
    result = CliRunner().invoke(export, ["slider_crank", *arguments], standalone_mode=False)
    assert result.exception is None, result.output
    return result.output


def test_latex_is_a_balanced_document_of_all_equations():
    text = printed("--latex")
    assert text.startswith(r"\documentclass")
    plain = re.sub(r"\\[{}]", "", text)
    assert plain.count("{") == plain.count("}")
    for opened, closed in ((r"\[", r"\]"), (r"\left", r"\right")):
        assert len(re.findall(re.escape(opened) + r"(?![a-z])", text)) == len(
            re.findall(re.escape(closed) + r"(?![a-z])", text)
        )
    assert re.findall(r"\\begin{(\w+\*?)}", text).count("longtable") == text.count(r"\end{longtable}") == 2
    assert r"\tag{1}" in text


def test_mathml_is_a_page_of_formulas():
    page = printed("--mathml")
    formulas = re.findall(r"<math.*?</math>", page, re.DOTALL)
    assert len(formulas) > 30
    for formula in formulas:
        ElementTree.fromstring(formula)
    assert "default-src" in page  # it fetches nothing


def test_a_file_for_sympy_has_the_values_requested():
    module = types.ModuleType("slider_crank")
    exec(printed("--sympy", "--set", "clearance=0.7 mm"), module.__dict__)
    values = {symbol.name: (value, module.units[symbol]) for symbol, value in module.values.items()}
    assert values["clearance"] == (pytest.approx(0.7), "mm")
    assert module.mass_matrix.shape == (2, 2)
    assert module.mass_matrix == module.mass_matrix.T
