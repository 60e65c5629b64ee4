"""The expression reader: what it reads, what it refuses and how it says so, bounds; tests/test_hostile_input.py reads random texts."""

import math

import pytest
import scipy.special
import sympy as sp
from calls import calls_of
from each import each
from expressions import CONSISTENT, INCONSISTENT, STATE, UNITS
from hypothesis import given
from hypothesis import strategies as st

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.dimension.expression import TextError, to_sympy
from hertzwerk.derive.expressions.dimension.reader import FUNCTIONS, MAX_DEPTH, MAX_TEXT, read

TABLE = [row[0] for row in (*CONSISTENT, *INCONSISTENT)]


# --- reading --------------------------------------------------------------------------------------------------------


def test_the_tree_keeps_what_is_written():
    expression = read("K*d**1 + (m - m) - 0*s")
    assert [expression.quote(node) for node in expression.root.args] == ["K*d**1", "m - m", "0*s"]
    assert [expression.source[a:b] for a, b in expression.root.spans] == ["K*d**1", "(m - m)", "0*s"]
    assert expression.names == ("K", "d", "m", "s")


@each("text", TABLE)
def test_every_node_quotes_its_own_text(text):
    """What is quoted for a node reads back to that node."""
    expression = read(text)
    for node in expression.root.walk():
        if node.op in ("inf",) or (node.op in ("<", "<=") and expression.quote(node).count("<") > 1):
            continue  # a bound of integrate; a link of a chain quotes the whole chain
        again = read(expression.quote(node)).root
        inner = node.args[0] if node.op in ("inverse", "neg") and again.op != node.op else node
        assert (again.op, len(again.args), again.number) == (inner.op, len(inner.args), inner.number)


@each("text", TABLE)
def test_spacing_and_outer_parentheses_change_nothing(text):
    def shape(node):
        return node.op, node.name, node.number, tuple(map(shape, node.args))

    spaced = "".join(f" {c} " if c in "+/,[]()" else c for c in text)  # * and - and < may be half of a sign
    assert shape(read(f"(\n{spaced}\n)").root) == shape(read(text).root)


def test_names_beyond_ascii():
    expression = read("μ*(F_N + ö)*θ")
    assert expression.names == ("μ", "F_N", "ö", "θ")
    assert expression.quote(expression.root.args[1]) == "F_N + ö"
    assert read("\u00b5").names == read("\u03bc").names  # two ways to type micro are one name


# An oracle of the meaning: Python's own evaluation of a text of this file's, in floats.
PYTHON = {name: getattr(math, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan")}
PYTHON |= {name: getattr(math, name) for name in ("sinh", "cosh", "tanh", "atan2", "pi")}
PYTHON |= {
    "abs": abs,
    "gamma": math.gamma,
    "LambertW": lambda x, branch=0: float(scipy.special.lambertw(x, branch).real),
    "min": min,
    "max": max,
    "sign": lambda x: (x > 0) - (x < 0),
    "where": lambda c, a, b: a if c else b,
}
SCALAR = [text for text, _ in CONSISTENT if not any(word in text for word in ("diff", "integrate", "[", "=="))]


@each("text", SCALAR)
def test_sympy_means_what_python_means(text):
    expected = eval(text, dict(PYTHON), dict(STATE))  # a literal of this repository
    symbols = {name: sp.Symbol(name, real=True) for name in UNITS}
    actual = to_sympy(read(text), symbols).subs({symbols[name]: sp.Float(value, 17) for name, value in STATE.items()})
    if isinstance(expected, bool):
        assert bool(actual) == expected
    else:
        assert float(actual.doit()) == pytest.approx(expected, rel=1e-12)


def test_numbers_are_the_fractions_written():
    x = sp.Symbol("x")
    assert to_sympy(read("x**1.5"), {"x": x}) == x ** sp.Rational(3, 2)
    assert to_sympy(read("0.965*x"), {"x": x}) == sp.Rational(965, 1000) * x
    assert to_sympy(read("3.84e-5"), {}) == sp.Rational("3.84e-5")
    assert float(to_sympy(read("0.12345678901234567"), {})) == 0.12345678901234567
    assert to_sympy(read("4/3"), {}) == sp.Rational(4, 3)
    assert float(to_sympy(read("1e300*x"), {"x": 1})) == 1e300
    assert to_sympy(read("where(x > 0, x, -x)"), {"x": x}) == Where(x > 0, x, -x)


# --- refusals -------------------------------------------------------------------------------------------------------

REFUSED = [  # text, position of the fault, part of the message
    ("", 1, "no expression"), ("   ", 1, "no expression"), ("K*d^n", 4, "a power is written d**n"), ("K*d**", 6, "the end"), ("2x", 1, "'2x'"),
    ("x = 3", 3, "'='"), ("x; y", 2, "';'"), ("a if b else c", 1, "where(condition, a, b)"), ("lambda*2", 8, "'lambda' is a word of Python"),
    ("lambda: 0", 1, "choose another name"), ("x # y", 3, "leave comments out"), ("x\\\n+1", 2, "leave it out"),
    ("1,5*x", 1, "a decimal point is written 1.5"), ("ln(x)", 1, "did you mean log?"), ("arctan(x)", 1, "did you mean atan?"),
    ("sqr(x)", 1, "did you mean sqrt"), ("2*(x)(y)", 4, "a product is written with *"), ("K(d)", 1, "a product is written with *"),
    ("np.sqrt(x)", 1, "write sqrt(...)"), ("x.real", 1, "a dot between names"), ("x[0]", 1, "an index"),
    ("__import__('os').system('true')", 1, "bare name"), ("open('/etc/passwd')", 1, "known function"), ("(lambda: 1)()", 2, "bare name"),
    ("[x for x in y]", 1, "ListComp"), ("{1: 2}", 1, "Dict"), ("f'{x}'", 1, "without quotes"), ("'x'", 1, "a real number or a name"),
    ("True", 1, "a real number or a name"), ("None*x", 1, "a real number or a name"), ("2j", 1, "a real number or a name"),
    ("0x10", 1, "a decimal number"), ("x // y", 1, "the operations + - * / **"), ("x % y", 1, "the operations + - * / **"), ("~x", 1, "found"),
    ("x is y", 1, "< <= > >= == or !="), ("(x > 0)*F", 2, "a choice is written where(condition, a, b)"),
    ("where(x, 1, 2)", 7, "a comparison such as d > 0"), ("x and y", 1, "a comparison such as d > 0"), ("sin(x, y)", 1, "2 arguments of sin"),
    ("sin", 1, "sin(...)"), ("min(x)", 1, "1 arguments of min"), ("sin(a=x)", 7, "an argument by name"), ("sin(*x)", 5, "Starred"),
    ("diff(x, 2)", 9, "a name to differentiate"), ("diff(x, t, 9)", 12, "a name to differentiate"), ("diff(x, t, 3, y, 3)", 1, "order 6"),
    ("integrate(x, t, 0)", 1, "integrate(f, x, lower, upper)"), ("inf", 1, "a bound of integrate"), ("[[1, 2], [3]]", 1, "rows of one length"),
    ("[]", 1, "rows of one length"), ("[x, y]*[x, y]", 1, "A @ B"), ("[x, y] @ [x, y]", 1, "as many rows"), ("x @ y", 1, "a matrix beside @"),
    ("[x, y] + z", 10, "a scalar"), ("1/[x, y]", 3, "a scalar divisor"), ("[x, y]**2", 1, "a scalar"), ("det([x, y])", 5, "a square matrix"),
    ("inv(x)", 5, "a matrix"), ("sin([x, y])", 5, "a scalar"),
    # numbers out of bounds
    ("9**9**9", 4, "at most 100"), ("x**101", 4, "at most 100"), ("((x**10)**10)**2", 16, "at most 100 in all"), ("2**-101", 4, "at most 100"),
    ("1e999", 1, "within the range of a double"), ("1e-999", 1, "within the range of a double"), ("9" * 400, 1, "within the range of a double"),
    ("exp(exp(exp(9)))", 5, "within the range of a double"), ("1/0", 3, "divides by zero"), ("x/(2 - 2)", 4, "divides by zero"),
    ("0**-1", 1, "finite real number"), ("sqrt(-1)", 1, "finite real number"), ("(-8)**(1/3)", 1, "finite real number"),
    ("log(0)", 1, "finite real number"), ("asin(2)", 1, "finite real number"),
]  # fmt: skip


@each(("text", "position", "part"), REFUSED)
def test_refused(text, position, part):
    with pytest.raises(TextError) as raised:
        read(text)
    assert part in str(raised.value)
    assert "found" in str(raised.value)
    assert "expected" in str(raised.value)
    assert raised.value.position == position


def test_refuses_what_is_no_text():
    for value in (None, 5, b"x", ["x"]):
        with pytest.raises(TextError, match="expected text"):
            read(value)  # type: ignore[arg-type]


@each("text", ["(" * 1900, "-" * 1900 + "x", "x" * (MAX_TEXT + 1), "sin(" * 300 + "x" + ")" * 300, "[" * 190 + "]" * 190,
     "x**" * 600 + "x", "not " * 400 + "x > 0", "1+" * 5000 + "1", "\x00", "\ud800", "x\x0cy", "\u2028", "((((" * 90])  # fmt: skip
def test_too_much_or_unprintable_is_refused_at_once(text):
    def refused():
        with pytest.raises(TextError):
            read(text)

    assert calls_of(refused) < 2_000  # 700 measured; 61 to read sin(x)


def test_the_bounds_leave_room():
    assert len(read("+".join(["x"] * 900)).root.args) == 900
    assert read("(" * 100 + "x" + ")" * 100).root.op == "name"
    deep = MAX_DEPTH - 1
    assert read("sin(" * deep + "x" + ")" * deep).root.op == "sin"
    assert read("x**100").root.op == "**"
    assert read("10**-12*x").root.op == "product"


def test_every_function_is_read():
    calls = {"where": "where(x > 0, x, y)", "diff": "diff(x**2, x)", "integrate": "integrate(x, x, 0, y)"}
    for name, (fewest, _) in FUNCTIONS.items():
        arguments = "[[x, y], [y, x]]" if name in ("transpose", "inv", "det", "trace") else ", ".join("xyz"[:fewest])
        text = calls.get(name, f"{name}({arguments})")
        symbols = {letter: sp.Symbol(letter, real=True) for letter in "xyz"}
        assert read(text).root.op == name
        assert to_sympy(read(text), symbols).free_symbols <= set(symbols.values())


# --- properties -----------------------------------------------------------------------------------------------------

LEAVES = st.sampled_from(["x", "y", "z", "2", "0.5", "pi"])
TEXTS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from(["+", "-", "*"]), inner),
        st.builds("{}({})".format, st.sampled_from(["sin", "cos", "tanh", "abs", "atan", "exp"]), inner),
        st.builds("{}({}, {})".format, st.sampled_from(["min", "max"]), inner, inner),
        st.builds("where({} > {}, {}, {})".format, LEAVES, LEAVES, inner, inner), st.builds("(-{})".format, inner), st.builds("{}**2".format, LEAVES),
    ),
    max_leaves=8,
)  # fmt: skip


@given(TEXTS, st.floats(-2, 2), st.floats(-2, 2), st.floats(-2, 2))
def test_random_good_texts_mean_what_python_means(text, x, y, z):
    values = {"x": x, "y": y, "z": z}
    try:
        expected = eval(text, dict(PYTHON), dict(values))  # made of the pieces above
    except OverflowError:
        return
    expression = to_sympy(read(text), {name: sp.Float(value, 17) for name, value in values.items()})
    assert float(sp.sympify(expression).doit()) == pytest.approx(expected, rel=1e-9, abs=1e-9)
