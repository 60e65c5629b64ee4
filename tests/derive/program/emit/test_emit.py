"""Text of expressions and functions: it means what the SymPy expression means, it is cheap, and nothing unknown slips through."""

import ast
from dataclasses import fields, is_dataclass, replace

import casadi as ca
import mpmath
import numpy as np
import pytest
import sympy as sp
from derived import Derived
from drop import FLOOR, GRAVITY, SCALES, STIFFNESS, drop, heavy
from each import each
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st

import hertzwerk.derive as hd
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.laws import flores
from hertzwerk.derive.laws.formulas.damping import e
from hertzwerk.derive.laws.law import BoundLaw
from hertzwerk.derive.program.emit.cost import operations
from hertzwerk.derive.program.expression_text import EmitError, expression_text
from hertzwerk.derive.program.program import OWN
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank

x, y, z, n = sp.symbols("x y z n", real=True)
VALUES = {x: 0.7, y: 1.9, z: 0.31, n: 2.25}


def run(text, values=VALUES):
    """Value of an expression's text, as CasADi computes it."""
    out = eval(text, {"ca": ca}, {symbol.name: ca.DM(value) for symbol, value in values.items()})
    return float(ca.DM(out))


def exact(expression, values=VALUES):
    """SymPy's own value, 30 digits; the inputs are the doubles."""
    return sp.N(
        sp.sympify(expression).xreplace({symbol: sp.Float(value, 30) for symbol, value in values.items()}).doit(), 30
    )


# -- random expressions ------------------------------------------------------------------------------------------------

LEAVES = st.sampled_from(
    [x, y, z, sp.Integer(2), sp.Integer(-3), sp.Rational(1, 2), sp.Rational(-4, 3), sp.Float(0.1), sp.pi]
)
EXPONENTS = (
    [sp.Integer(k) for k in (-3, -2, -1, 2, 3, 4)]
    + [sp.Rational(k, 2) for k in (-3, -1, 1, 3, 5)]
    + [sp.Rational(2, 3)]
)


def compound(parts):
    positive = parts.map(lambda a: a**2 + sp.Rational(1, 4))
    pair = st.tuples(parts, parts)
    return st.one_of(
        pair.map(lambda ab: ab[0] + ab[1]),
        pair.map(lambda ab: ab[0] - ab[1]),
        pair.map(lambda ab: ab[0] * ab[1]),
        st.tuples(parts, positive).map(lambda ab: ab[0] / ab[1]),
        st.tuples(positive, st.sampled_from(EXPONENTS)).map(lambda ab: ab[0] ** ab[1]),
        st.tuples(st.sampled_from([x, y, z]), st.sampled_from([*EXPONENTS, n, n - 1, -n])).map(lambda ab: ab[0] ** ab[1]),
        pair.map(lambda ab: -ab[0] * (ab[1] - x)),
        parts.map(sp.sin),
        parts.map(sp.cos),
        parts.map(sp.tanh),
        parts.map(lambda a: sp.exp(sp.tanh(a))),
        parts.map(lambda a: sp.log(a**2 + 1)),
        parts.map(sp.atan),
        parts.map(sp.Abs),
        pair.map(lambda ab: sp.Min(*ab)),
        pair.map(lambda ab: sp.Max(*ab, z)),
        pair.map(lambda ab: Where(x > y, *ab)),
        pair.map(lambda ab: Where(z <= y, *ab)),
        pair.map(lambda ab: sp.atan2(ab[0], ab[1] ** 2 + 1)),
    )  # fmt: skip


@settings(max_examples=150, phases=[Phase.explicit, Phase.generate])
@given(st.recursive(LEAVES, compound, max_leaves=8))
def test_text_means_what_the_expression_means(expression):
    assume(
        not expression.has(sp.re, sp.im)
    )  # SymPy's own Abs(exp(x**n)) of a base without a sign: no rule, which raises
    nodes = [node for node in sp.preorder_traversal(expression) if not node.is_Relational and not node.is_Boolean]
    size = max(abs(exact(node)) for node in nodes)  # what rounding errors are measured by
    assert abs(run(expression_text(expression)) - exact(expression)) <= 1e-12 * max(1, size) * len(nodes)


@each("expression", [
        -x, -x * y, x - y, -x - y, x - (y - z), x / y / z, x / (y * z), 1 / (x + y), -1 / x, x * y / (z * (x + y)), sp.Rational(-3, 4) * x,
        sp.Rational(1, 3) - x, x**-2, (x * y) ** -1, (x + y) ** -2, (x + y) ** sp.Rational(3, 2), x ** sp.Rational(-3, 2), x / sp.sqrt(y),
        (x + 1) ** n, x ** (n - 1), x**-n, 2**x, sp.Rational(2, 3) ** x, sp.sqrt(2) * x, x**7, (-x) ** 3, (x - y) ** 3, sp.exp(1) * x,
        x * sp.Float("1e-300"), sp.Float("0.1") + x, Where(x > 0, x, -x), Where(x > y, 1, 0) * 3, x - Where(x < y, z, 0), x**2 * y**-3,
        -(x + y) / z, 1 / (x / y + 1), x ** sp.Rational(1, 3), sp.Mul(x, sp.Pow(y, -1), sp.Pow(z, -2)), -(x**2), (x + y) * (x - y),
        (y - x) ** sp.Rational(3, 2) * z, (-sp.log(z)) ** sp.Rational(3, 2) * y, 3 - n * (-sp.log(z)) ** sp.Rational(3, 2),
        y / (-sp.log(z)) ** sp.Rational(3, 2),
        sp.asin(z), sp.acos(z), sp.sinh(x), sp.cosh(x), sp.tan(x), sp.sign(x - y) * z, sp.Max(x, y) - sp.Min(x, y, z),
    ])  # fmt: skip
def test_signs_parentheses_and_quotients(expression):
    assert run(expression_text(expression)) == pytest.approx(float(exact(expression)), rel=4e-16 * 8, abs=1e-310)


def test_the_comparison_would_notice_a_missing_parenthesis():
    text = expression_text(x * (y - z)).replace("(", "").replace(")", "")
    assert run(text) != pytest.approx(float(exact(x * (y - z))))


# -- strength reduction ------------------------------------------------------------------------------------------------


@each(
    ("expression", "text"),
    [
        (x**2, "x*x"), (x**3, "x*x*x"), (x ** sp.Rational(3, 2), "x*ca.sqrt(x)"), (x ** sp.Rational(5, 2), "x*x*ca.sqrt(x)"),
        ((-x) ** sp.Rational(3, 2), "-x*ca.sqrt(-x)"), ((x - y) ** sp.Rational(3, 2), "(x - y)*ca.sqrt(x - y)"), (sp.sqrt(x), "ca.sqrt(x)"),
        (1 / sp.sqrt(x), "1/ca.sqrt(x)"), (x**-1, "1/x"), (x**n, "x**n"),
    ],
)  # fmt: skip
def test_powers_are_reduced_to_products_and_roots(expression, text):
    assert expression_text(expression) == text


@each("exponent", [2, 3, "1/2", "3/2", "5/2", "-1/2", "-3/2", -1, -2])
def test_no_general_power_of_a_name_where_a_cheaper_form_exists(exponent):
    assert "**" not in expression_text(y * x ** sp.Rational(exponent))


def test_operations_are_counted():
    """By hand: 2 products, a sum, a root, a negation, a comparison and a choice."""
    text = "def f(x, c):\n    y = c[0]*x + ca.sqrt(x*x)\n    return ca.vertcat(-y, ca.if_else(y > 0, y, -1))\n"
    assert operations(text) == 2 + 1 + 1 + 1 + 1 + 1


# -- what is not known -------------------------------------------------------------------------------------------------


@each("node", [
        sp.Function("mystery")(x), sp.besselj(0, x), sp.Heaviside(x), sp.Piecewise((x, x > 0), (y, True)), sp.Derivative(sp.Function("f")(x), x),
        sp.Integral(sp.Function("f")(x), x), sp.I * x, sp.zoo, sp.oo, sp.nan, sp.erf(x), sp.LambertW(x), sp.LambertW(x, 2), sp.Eq(x, y),
    ])  # fmt: skip
def test_a_node_without_a_rule_is_an_error(node):
    with pytest.raises(EmitError):
        expression_text(node)
    with pytest.raises(EmitError):
        expression_text(sp.Mul(2, sp.sin(node)) if not node.is_Relational and node.is_finite is not False else node)


# -- text of modules ---------------------------------------------------------------------------------------------------

HOSTILE = 'a "quoted" """summary""" with C:\\new\\x, {braces}, %s and a\nline end'


def in_contact(derived):
    """Forces at one state in contact."""
    return np.concatenate(derived.call("contact_floor", q=[0.09], u=[-1.0], m=[3.0]))


def test_any_summary_source_number_and_length_of_a_name_make_a_module():
    derived = Derived(text=hd.generate(drop().named("drop", HOSTILE), source=HOSTILE))
    assert derived.SUMMARY == HOSTILE
    assert derived.SOURCE == HOSTILE
    assert in_contact(derived) == pytest.approx(in_contact(Derived(drop())))
    text = hd.generate(heavy(hd.Parameter("mass", "kg", np.float64(0.1))))
    assert '("mass", "kg", 0.1,' in text
    # Names of many lengths move the line breaks through every column.
    for length in range(1, 60, 3):
        radius = hd.Parameter("r" * length, "m", 0.1)
        text = hd.generate(
            drop(pairs=(replace(FLOOR, radius=radius),), scales=replace(SCALES, length=radius, arm=radius))
        )
        ast.parse(text)
        assert max(map(len, text.split("\n\n\ndef ", 1)[1].splitlines())) < 200


def test_parameters_may_have_every_name_that_the_text_has_for_itself():
    """All functions of a module with a drive, loops, a contact, memory and a ledger: the same values at any arguments."""
    scene = slider_crank.with_coordinates("absolute")
    a, b = Derived(scene), Derived(_renamed(scene, dict(zip(scene.parameters, [*OWN, *OWN.values()], strict=False))))
    assert [name for name, *_ in b.PARAMETERS[: len(OWN)]] == list(OWN)
    used = {name for function, _ in a.OPERATIONS for name in a.arguments(function)}
    assert used == set(OWN) - {
        "ca", "multipliers", "friction", "touching",
    }  # those of a scene without a drive, and of readings  # fmt: skip
    given = {name: np.random.default_rng(1).normal(size=60) for name in used} | {"t": 0.3}
    for function, _ in a.OPERATIONS:
        theirs = {name: given[name] for name in a.arguments(function) if name not in "pc"}
        ours = [np.hstack(derived.call(function, **theirs)) for derived in (a, b)] if function != "constants" else ()
        assert function == "constants" or ours[0] == pytest.approx(ours[1], rel=1e-9, abs=1e-9, nan_ok=True), function


def _renamed(scene, names):
    """The scene with some parameters renamed, by walking its declaration."""
    new = {
        p: hd.Parameter(names[p.name], p.unit, p.default, p.meaning)
        for p in scene.parameters.values()
        if p.name in names
    }
    bodies = {}

    def walk(value):
        if isinstance(value, sp.Basic):
            return value.xreplace(new)
        if isinstance(value, hd.Body):
            if value not in bodies:
                bodies[value] = hd.Body(value.name, walk(value.mass), walk(value.inertia), walk(value.centre))
            return bodies[value]
        if isinstance(value, tuple):
            return tuple(walk(part) for part in value)
        if value is hd.GROUND:
            return value
        if isinstance(value, dict):
            return {key: walk(part) for key, part in value.items()}
        if isinstance(value, BoundLaw):
            return replace(value, values=walk(value.values), materials=walk(value.materials))
        if is_dataclass(value):
            return replace(value, **{field.name: walk(getattr(value, field.name)) for field in fields(value)})
        return value

    return walk(scene)


@each("scale", [1e-6, 1e-3, 0.1, 0.4, 0.6, 0.9, 0.999, 1.0])
def test_the_lower_branch_of_lamberts_w(scale):
    """A damping factor -W_-1(-e/exp(1)) comes out as mpmath has it; near the branch point only half the digits exist."""
    law = replace(flores, name="lambert", factor=-sp.LambertW(-e * sp.exp(-1), -1))
    contact = hd.Contact("floor", STIFFNESS, law(hd.Parameter("restitution", "1", scale)))
    derived = Derived(drop(effects=(GRAVITY, contact, hd.EnergyLedger())))
    elastic = 1e6 * 0.01**1.5
    factor = (in_contact(derived)[2] / elastic - 1) * 3.0 / 1.0  # F (1 + h v/v0), approach 3 m/s, rate 1 m/s
    with mpmath.workdps(40):
        argument = -mpmath.mpf(scale) / mpmath.e
        expected = -mpmath.lambertw(argument, -1).real
    assert factor == pytest.approx(float(expected), rel=1e-7 if scale == 1.0 else 2e-12 / (1 - scale) ** 0.5)
