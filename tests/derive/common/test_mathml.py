"""LaTeX of equations as MathML: every equation of the built-in scenes, and what is refused."""

import re
from collections import Counter
from xml.etree import ElementTree

import pytest
import sympy as sp

from hertzwerk.derive.common.mathml import inline, lines_of
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.notation import latex_of
from hertzwerk.runtime.engine.model.build import built_in_scenes, equations, scene_from


def read(latex):
    return ElementTree.fromstring(inline(latex))


def said(element):
    """A formula as text again, by the meaning that the MathML standard gives each element."""
    parts = [said(child) for child in element]
    match element.tag:
        case "mfrac":
            return "({})/({})".format(*parts)
        case "msub":
            return "{}_{}".format(*parts)
        case "msup":
            return "{}^{}".format(*parts)
        case "msubsup":
            return "{}_{}^{}".format(*parts)
        case "mover":
            return "{1}{0}".format(*parts)
        case "msqrt":
            return f"√({''.join(parts)})"
        case "mspace":
            return " "
        case "mtr":
            return f"[{','.join(parts)}]"
    return (element.text or "") + "".join(parts)


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"\varphi_{\mathrm{crank\,pin}}", "φ_crank\N{THIN SPACE}pin"),
        (r"\frac{4 E_{\mathrm{eff}} \sqrt{R}}{3}", "(4E_eff√(R))/(3)"),
        (r"\delta^{3/2}", "δ^3/2"),
        (r"s_{\mathrm{rod}}^{2}", "s_rod^2"),
        (r"a^{2}_{x}", "a_x^2"),
        (r"\dot{\delta} h", "˙δh"),
        (r"- \sin {\varphi} \tanh{\left(\frac{s}{v} \right)}", "− sin φ tanh((s)/(v))"),
        (
            r"\begin{cases} K & \text{if } x \leq 0 \\ 0 & \text{else} \end{cases}",
            "{[K,if\N{NO-BREAK SPACE}x≤0][0,else]",
        ),
        (r"\left|{\omega}\right|", "|ω|"),
        (r"1.0 \cdot 10^{-5}", "1.0·10^−5"),
        (r"\mathrm{slider\_pin}", "slider_pin"),
        (
            r"2 K \mathrm{floor\,depth} \frac{\mathrm{d}}{\mathrm{d}t} a - \mathrm{lift}",
            "2K floor\N{THIN SPACE}depth (d)/(dt)a−lift",
        ),
    ],
)
def test_formulas_keep_their_meaning(latex, text):
    assert said(read(latex)) == text


def test_lines_break_before_signs_and_keep_their_remark():
    latex = "\\begin{aligned}\n& m \\ddot{x} && \\text{inertia} \\\\\n&= F && \\text{slider\\_pin} \\\\\n&\\quad - g\n\\end{aligned}"
    assert [remark for _, remark in lines_of(latex)] == ["inertia", "slider_pin", ""]
    ((line, _),) = lines_of(r"a = - b + \left(c + d\right) - e")
    assert [said(ElementTree.fromstring(piece)) for piece in re.findall("<math.*?</math>", line)] == [
        "a", "=−b", "+(c+d)", "−e",
    ]  # fmt: skip


def test_long_brackets_and_fractions_break_and_keep_their_meaning():
    long = " + ".join(rf"a_{{{k}}} b_{{{k}}}" for k in range(9))
    plain = long.replace(" ", "").replace("{", "").replace("}", "")
    for latex, text in [
        (rf"2 \left({long}\right)^{{2}} c", f"2({plain})^2c"), (rf"\frac{{{long}}}{{3}}", f"(1)/(3)({plain})"),
        (rf"- \frac{{1}}{{{long}}}", f"−(1)/({plain})"), (rf"\sin{{\left({long}\right)}}", f"sin({plain})"),
        (rf"\operatorname{{near}}\left({long.replace('+', ',')}\right)", f"near({plain.replace('+', ',')})"),
    ]:  # fmt: skip
        ((line, _),) = lines_of(latex)
        assert line.count("<math") > (1 if "," in latex else 8)
        assert said(ElementTree.fromstring(f"<p>{line.replace('> <', '><')}</p>")).strip() == text


@pytest.mark.parametrize(
    "latex", [r"\href{x}{y}", r"\frac{a}", r"{a", r"a}", r"\left(a", r"\begin{array} \end{array}", "a ~ b"]
)
def test_anything_else_is_refused(latex):
    with pytest.raises(ValueError, match=r"found|too early|expected"):
        lines_of(latex)


@pytest.mark.parametrize("scene", ["slider_crank", pytest.param("all", marks=pytest.mark.exhaustive)])
def test_every_symbol_of_an_equation_is_in_its_formula(scene):
    """The letters and numbers of the LaTeX, read by a pattern alone, are those of the MathML in their order."""
    for name in built_in_scenes() if scene == "all" else [scene]:
        shown = equations(scene_from(name))
        latex = [equation.latex for equation in shown.equations] + [s.latex for s in (*shown.states, *shown.parameters)]
        for text in latex:
            found = "".join(said(ElementTree.fromstring(f"<p>{line}</p>")) for line, _ in lines_of(text))
            text = re.sub(r"\\(sin|cos|tan|tanh|max|min|log|exp)\b", r"\1", text)
            words = re.sub(
                r"\\(?:begin|end)\{\w+\}|&& *\\text\{.*?\}(?= *(?:\\\\|\n|$))|\\[a-zA-Z]+|[^0-9A-Za-z]", "", text
            )
            letters = re.sub(r"[^0-9A-Za-z]", "", found)
            more = Counter(letters) - Counter(words)
            assert not Counter(words) - Counter(letters), text
            assert set(more) <= {"1"}, text  # of a long fraction taken apart


def test_fractions_and_cases_keep_their_form():
    terms = " + ".join(rf"\frac{{1 - \nu_{{{k}}}^{{2}}}}{{E_{{{k}}}}}" for k in (1, 2))
    assert len(lines_of(rf"E = \frac{{1}}{{{terms}}}")[0][0].split("<mfrac>")) == 4
    assert "(" not in lines_of(rf"E = \frac{{1}}{{{terms}}}")[0][0]
    assert "(" in lines_of(rf"E = \frac{{a + b + {terms}}}{{c}}")[0][0]
    for count, lines in ((2, 0), (20, 3)):
        terms = " + ".join(f"a_{{{k}}} b c" for k in range(10, 10 + count))
        cases = read(rf"\begin{{cases}} {terms} & \text{{if }} x < 0 \\ 0 & \text{{else}} \end{{cases}}")
        found = [said(row)[1:-1].strip() for row in cases.iterfind(".//mtable//mtable/mtr")]
        assert len(found) == lines
        assert "".join(found) in ("", re.sub("[ {}]", "", terms))
    below = read(rf"\begin{{cases}} {'a' * 40} & \text{{if }} {'b' * 30} < 0 \\ 0 & \text{{else}} \end{{cases}}")
    assert [len(row) for row in below.iter("mtr")] == [1, 1, 2]
    x = sp.Symbol("x", real=True)
    inner = Where(x < 2, x**2, 3)
    shown = latex_of(Where(x < 1, 0, inner) + inner**2, {x: "x"})
    rows = r"x^{2} & \text{if } x < 2 \\ 3 & \text{else} \end{cases}"
    assert rf"\begin{{cases}} 0 & \text{{if }} x < 1 \\ {rows}" in shown
    assert rf"\left(\begin{{cases}} {rows}\right)^{{2}}" in shown
    assert latex_of(Where(x < 2, x, 2), {x: "x"}).startswith(r"\min")
    assert latex_of(Where(x < 2, x, sp.I), {x: "x"}).startswith(r"\begin{cases}")  # branches that nothing compares
