"""The tape: naming, hash-consing, hoisting of constants, slices, rates of change, shared sub-expressions."""

import random

import casadi as ca
import mpmath
import pytest
import sympy as sp
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.dimension.dimension import ONE
from hertzwerk.derive.program.emit.cost import operations
from hertzwerk.derive.program.emit.printer import function_text
from hertzwerk.derive.program.program import (
    Function,
    Program,
    Result,
    Tape,
    eliminate_common_subexpressions,
)


class Small:
    """A tape with two parameters, two coordinates, their speeds and accelerations, and time."""

    def __init__(self):
        self.tape = Tape()
        self.t = self.tape.input("t", "t", ONE)
        self.k, self.m = (self.tape.input(name, "p", ONE) for name in ("stiff", "mass"))
        self.q = [self.tape.input(f"q_{i}", "q", ONE) for i in range(2)]
        self.u = [self.tape.input(f"u_{i}", "u", ONE) for i in range(2)]
        self.a = [self.tape.input(f"a_{i}", "a", ONE) for i in range(2)]
        self.tape.set_rate(self.t, sp.S.One)
        for q, u, a in zip(self.q, self.u, self.a, strict=True):
            self.tape.set_rate(q, u)
            self.tape.set_rate(u, a)

    def function(self, *expressions, arguments=("t", "q", "u", "a", "c")):
        """One function of these results."""
        labels = tuple(str(i) for i in range(len(expressions)))
        return self.tape.function(
            "f", "A function.", arguments, [Result("y", labels, ("",) * len(labels), expressions)]
        )

    def evaluate(self, function, values, share=True):
        """Results of a function's text, the constants from the text of theirs; `values` by symbol."""
        constants = self.tape.constants([function])
        c = self.tape.function(
            "constants", "Constants.", ("p",), [Result("c", ("",) * len(constants), ("",) * len(constants), tuple(constants))],
        )  # fmt: skip
        program = Program(None, self.tape, (c, function), tuple(constants), {})
        groups = {g: [v for s, v in values.items() if self.tape.inputs[s] == g] for g in ("t", "p", "q", "u", "a")}
        known = {name: ca.DM(numbers) for name, numbers in groups.items()}
        for one in (c, function):
            text = function_text(program, one)
            names = {"ca": ca}
            exec(text, names)
            known["c"] = names[one.name](*(known[name] for name in one.arguments))
        return known["c"].full().reshape(-1)

    def value(self, expression, values, digits=30):
        """Value by substitution along the tape."""
        known = {s: sp.Float(v, digits) for s, v in values.items()}
        for symbol, assigned in self.tape.assignments.items():
            known[symbol] = sp.N(assigned.xreplace(known).doit(), digits)
        return sp.N(sp.sympify(expression).xreplace(known).doit(), digits)


NUMBERS = {
    "t": 0.4, "stiff": 1.7, "mass": 0.6, "q_0": 0.8, "q_1": -1.3, "u_0": 0.5, "u_1": 2.1, "a_0": -0.7, "a_1": 1.1,
}  # fmt: skip


def values_of(small):
    return {symbol: NUMBERS[symbol.name] for symbol in small.tape.inputs}


OPERATIONS = (
    lambda a, b, s: a + b, lambda a, b, s: a * b, lambda a, b, s: a - 2 * b, lambda a, b, s: a * b / (a**2 + 1),
    lambda a, b, s: (a**2 + 1) ** sp.Rational(3, 2) * b, lambda a, b, s: b / sp.sqrt(a**2 + 1), lambda a, b, s: sp.sin(a) + b,
    lambda a, b, s: sp.cos(a) * b, lambda a, b, s: sp.tanh(a - b), lambda a, b, s: Where(s.q[0] > s.q[1] * s.m, a, b),
)  # fmt: skip


class Recorded(Small):
    """A tape on which random results have been named, each over inputs and earlier results; their plain values are kept beside."""

    def __init__(self, seed):
        super().__init__()
        rng = random.Random(seed)
        pool = [self.k, self.m, self.t, *self.q, *self.u, sp.Integer(2), sp.Rational(1, 3)]
        self.names, self.plain = [], []

        def draw(depth):
            if depth == 0 or rng.random() < 0.2:
                return rng.choice([*pool, *self.names])
            return rng.choice(OPERATIONS)(draw(depth - 1), draw(depth - 1), self)

        for i in range(rng.randint(2, 5)):
            expression = sp.sympify(draw(rng.randint(1, 3)))
            self.plain.append(self.value(expression, values_of(self)))
            self.names.append(sp.sympify(self.tape.let(expression, f"r_{i}")))


SEEDS = st.integers(0, 10**6)


# -- values survive naming, hoisting, sharing, emission ----------------------------------------------------------------


@settings(max_examples=40, phases=[Phase.explicit, Phase.generate])
@given(SEEDS)
def test_naming_hoisting_and_sharing_keep_every_value(seed):
    small = Recorded(seed)
    function = small.function(*small.names)
    got = small.evaluate(function, values_of(small))
    for ours, expected, name in zip(got, small.plain, small.names, strict=True):
        assert abs(small.value(name, values_of(small)) - expected) <= 1e-20 * (1 + abs(expected))
        assert ours == pytest.approx(float(expected), rel=1e-11, abs=1e-11)


@settings(max_examples=40, phases=[Phase.explicit, Phase.generate])
@given(SEEDS)
def test_functions_that_read_constants_compute_none(seed):
    """No assignment or result of a function of c contains a product, sum or call of parameters alone."""
    small = Recorded(seed)
    function = small.function(*small.names)
    for _, expression in function.body:
        for node in sp.preorder_traversal(expression):
            if node.is_Atom or node.is_Relational or not node.free_symbols:
                continue
            inside_exponent_or_condition = any(
                node in sp.preorder_traversal(part)
                for other in sp.preorder_traversal(expression)
                for part in ((other.exp,) if other.is_Pow else (other,) if other.is_Relational else ())
            )
            plain = (node.is_Pow and node.exp == -1 and node.base.is_Symbol) or (-node).is_Symbol
            if not inside_exponent_or_condition and not plain:
                assert not small.tape.is_constant(node), f"{node} in {expression}"


@settings(max_examples=40, phases=[Phase.explicit, Phase.generate])
@given(SEEDS)
def test_sharing_never_adds_operations(seed):
    small = Recorded(seed)
    function = small.function(*small.names)
    program = Program(None, small.tape, (function,), tuple(small.tape.constants([function])), {})
    once = eliminate_common_subexpressions(function)
    plain = sum(int(sp.count_ops(e)) for _, e in function.body)
    after = sum(int(sp.count_ops(e)) for _, e in once.body)
    assert after <= plain
    assert operations(function_text(program, function)) >= 0


def test_sharing_respects_names_that_are_taken():
    x1, y = sp.symbols("x1 y", real=True)
    a = sp.Symbol("a", real=True)
    once = eliminate_common_subexpressions(
        Function("f", "", ("q",), ((a, sp.sin(x1 * y) + sp.cos(x1 * y)),), (Result("r", ("",), ("",), (a + x1,)),))
    )
    assert x1 not in [symbol for symbol, _ in once.body]


# -- naming ------------------------------------------------------------------------------------------------------------


def test_names_are_unique_no_keywords_and_one_for_each_dimension():
    small = Small()
    names = [small.tape.let(sp.sin(small.q[0] + i), "lambda").name for i in range(3)]
    names += [small.tape.let(sp.cos(small.q[0] + i), "q").name for i in range(2)]
    assert len(set(names)) == 5
    assert not {"lambda", "q", "t", "c"} & set(names)
    assert all(name.isidentifier() for name in names)
    # An unchecked force must not be confused with a checked result of the same form.
    small = Small()
    checked = small.tape.let(small.q[0] * small.q[1], "checked")
    stated = small.tape.let(small.q[0] * small.q[1], "stated", ONE)
    assert stated != checked
    assert small.tape.declared[stated] == ONE


# -- slices ------------------------------------------------------------------------------------------------------------


def test_a_function_that_would_read_what_it_is_not_given_is_refused():
    small = Small()
    b = small.tape.let(small.q[0] * small.u[0], "b_result")
    with pytest.raises(ValueError, match=r"f\(t, q, c\) would read u_0"):
        small.function(b, arguments=("t", "q", "c"))


# -- rates -------------------------------------------------------------------------------------------------------------


def moving(small, when):
    """Inputs along a motion q_i(t) = q + u s + a s^2/2 about NUMBERS, s = when."""
    values = values_of(small)
    for q, u, a in zip(small.q, small.u, small.a, strict=True):
        values[q], values[u] = values[q] + values[u] * when + values[a] * when**2 / 2, values[u] + values[a] * when
    values[small.t] = values[small.t] + when
    return values


@settings(max_examples=40, phases=[Phase.explicit, Phase.generate])
@given(SEEDS)
def test_rates_are_derivatives_along_the_motion(seed):
    small = Recorded(seed)
    name = small.names[-1]
    rate = sp.sympify(small.tape.rate(name, "rate"))

    def along(when):
        return mpmath.mpf(str(small.value(name, moving(small, sp.Float(when, 80)), digits=80)))

    with mpmath.workdps(80):
        step = mpmath.mpf("1e-20")  # a random program may bend as fast as 1e25
        expected = (along(step) - along(-step)) / (2 * step)
    assert float(small.value(rate, values_of(small))) == pytest.approx(float(expected), rel=1e-9, abs=1e-9)


def test_rates_are_stated_zero_or_refused():
    small = Small()
    height = small.tape.let(sp.sin(small.q[0]), "height")
    small.tape.set_rate(height, small.u[1])
    assert small.tape.rate(height * 2, "rate") == small.tape.let(2 * small.u[1], "other")
    small = Small()
    assert small.tape.rate(small.k * small.m + 1, "rate") == 0
    force = small.tape.input("push", "f", ONE)
    with pytest.raises(KeyError, match="push"):
        small.tape.rate(force * small.q[0], "rate")
