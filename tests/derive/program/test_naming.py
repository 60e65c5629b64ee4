"""Names in words of constants and shared subexpressions that have none of their own."""

from dataclasses import replace

import casadi as ca
import sympy as sp
from each import each

from hertzwerk.derive import derive
from hertzwerk.derive.program import naming
from hertzwerk.derive.program.emit.module_text import emit
from hertzwerk.derive.program.naming import LONGEST, names_in_words
from hertzwerk.derive.scenes.slider_crank import scene

a, b, c = sp.symbols("a b c", real=True)
k1, k2 = sp.symbols("k1 k2", real=True)
long = sp.Symbol("l" * LONGEST, real=True)


@each(
    ("expression", "words"),
    [
        (a**2, "a_squared"), (a**3, "a_cubed"), (a**6, "a_to_the_6"), (1 / a, "inverse_a"), (1 / (2 * a), "half_inverse_a"),
        (2 * a / 5, "two_fifths_of_a"), (-2 * a, "minus_twice_a"), (a * b, "a_times_b"), (a * b / c, "a_times_b_over_c"),
        (a * b**2 / 2, "half_a_times_b_squared"), (a - b, "a_minus_b"), (-a - b, "minus_a_minus_b"), (1 + a, "one_plus_a"),
        (2 * a - c, "twice_a_minus_c"), (sp.sqrt(a), "sqrt_a"), (1 / sp.sqrt(a), "inverse_sqrt_a"), (sp.cos(a), "cos_a"), (sp.pi / 2, "half_pi"),
    ],
)  # fmt: skip
def test_words_say_what_the_expression_is(expression, words):
    assert names_in_words([(k1, expression)], {}, set()) == {"k1": words}


@each(
    "expression",
    [a / (b * c), a * (b + c), a**b, a ** sp.Rational(2, 3), 7 * a, 3 + a, a * b - c, sp.sqrt(a * b), long**2, sp.Max(a, b), sp.exp(-1)],
)  # fmt: skip
def test_steps_without_a_short_clear_name_keep_their_number(expression):
    assert names_in_words([(k1, expression)], {}, set()) == {"k1": "k1"}


def test_a_name_that_is_taken_is_not_given():
    assert names_in_words([(k1, a**2)], {}, {"a_squared"}) == {"k1": "k1"}
    assert names_in_words([(k1, a**2)], {"x1": "a_squared"}, set())["k1"] == "k1"


@each(
    ("first", "then", "words"),
    [
        (a**2, 1 / k1, "inverse_a_squared"),
        (a + b, 2 * k1, "k2"),  # not twice_a_plus_b, which is another sum
        (-a, b + k1, "k2"),
        (a / 2, 2 * k1, "k2"),
        (a**b, k1**2, "k2"),  # no name of its own to speak of
    ],
)
def test_words_of_words_must_not_mislead(first, then, words):
    assert names_in_words([(k1, first), (k2, then)], {}, set())["k2"] == words


def test_names_change_no_function(monkeypatch):
    """The graphs of a module are the same with words and with numbers."""
    program = derive(scene)
    words = emit(program, "")
    monkeypatch.setattr(naming, "LONGEST", 0)
    numbers = emit(replace(program, names={}), "")
    assert "half_inverse_clearance = 1/(2*clearance)" in words
    assert "k2 = 1/(2*clearance)" in numbers
    assert graphs(words) == graphs(numbers)


def graphs(text):
    """Every function of a module, serialised."""
    module, found = {}, {}
    exec(text, module)
    for name, _ in module["OPERATIONS"]:
        code = module[name].__code__
        given = [ca.SX.sym(argument, 1 if argument == "t" else 40) for argument in code.co_varnames[: code.co_argcount]]
        results = module[name](*given)
        found[name] = ca.Function(name, given, list(results) if isinstance(results, tuple) else [results]).serialize()
    return found
