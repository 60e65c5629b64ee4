"""Values of expressions with mpmath, and states that span the range of each of a law's arguments."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import sympy as sp
from mpmath import mp, mpf  # SymPy brings it

from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import Interval
from hertzwerk.derive.laws.law import R_1, R_2, L, Law, Quantity, R_eff, R_min, dR, eps_c, eps_w, s, v

DIGITS = 40
STATES = 11  # prime: each argument takes every one of its eleven values, in an order of its own

SPANS_OF_SYMBOLS: dict[str, tuple[float, float]] = {
    "d": (1e-9, 1e-3),
    "dR": (1e-5, 2e-3),
    "R_2": (5e-3, 2e-2),
    "L": (5e-3, 5e-2),
    "z": (1e-7, 1e-4),
    "e": (0.05, 0.99),
    "nu_1": (0.05, 0.45),
    "nu_2": (0.05, 0.45),
    "c_b": (1.1, 2.3),
    "c_p": (1.1, 3.0),
    "sigma_y": (1e6, 2e7),
    "d_m": (1e-5, 1e-3),
    "v_a": (1e-3, 1e-2),
    "v_b": (0.1, 1),
    "epsilon_w": (0.05, 0.65),
    "epsilon_c": (0.05, 0.65),
    "h": (1e-7, 1e-3),
}
SPANS_OF_UNITS: dict[str, tuple[float, float]] = {
    "1": (0.05, 0.9),
    "Pa": (1e9, 4e11),
    "N": (1, 1e5),
    "N/m": (1e5, 1e9),
    "m/s": (1e-3, 10),
    "kg": (1e-2, 10),
    "s": (1e-8, 1e-3),
    "1/s": (1, 1e4),
    "1/m": (1e2, 1e6),
    "N/m^n": (1e6, 1e10),
    "m^(1-k)": (1, 1e2),
}
"""Ranges of states, SI, sampled evenly in the logarithm: a symbol's bounded range, else by its name, else by its unit, else (1/10, 10)."""

_SIGNED = (v, s, eps_w, eps_c)

State = Mapping[sp.Symbol, Any]


def lattice(law: Law, dimensions: Mapping[sp.Symbol, Dimension]) -> Iterator[dict[sp.Symbol, Any]]:
    """Yield values of a law's arguments over their spans, with a consistent geometry of the pair."""
    with mp.workdps(DIGITS):
        system = _base_units(law.fitted_in)
        defined = {row.quantity: row.interval for row in law.ranges if row.kind == "defined"}
        for j in range(STATES):
            state: dict[sp.Symbol, Any] = {}
            for i, q in enumerate(dict.fromkeys((*law.symbols(), dR, R_2, L))):
                at = mpf(((1 + i % (STATES - 1)) * j + i**2) % STATES) / (STATES - 1)
                low, high = _span(q, defined.get(q, q.limit))
                sign = -1 if q in _SIGNED and j % 2 else 1
                state[q] = sign * mpf(low) * (mpf(high) / mpf(low)) ** at
            state |= {R_1: state[R_2] + state[dR], R_min: state[R_2]}
            state[R_eff] = state[R_1] * state[R_2] / state[dR]
            yield _in_units(state, dimensions, system)


def _span(q: Quantity, interval: Interval | None) -> tuple[float, float]:
    """Sampled range of a symbol: its own where that is bounded and positive, else as listed."""
    if interval is not None and interval.lower and interval.lower > 0 and interval.upper:
        return interval.lower, interval.upper
    return SPANS_OF_SYMBOLS.get(q.name) or SPANS_OF_UNITS.get(q.unit, (0.1, 10.0))


def _in_units(state: State, dimensions: Mapping[sp.Symbol, Dimension], system: Sequence[Any]) -> dict[sp.Symbol, Any]:
    """Convert values from SI to a system with the given units of mass, length, time, temperature, current."""
    if all(unit == 1 for unit in system):
        return dict(state)
    return {
        q: value / scale_factor(dimensions[q], system, state) if q in dimensions else value
        for q, value in state.items()
    }


def _base_units(fitted_in: str) -> list[Any]:
    """SI sizes of the units of mass, length, time, temperature, current in a list such as "mm, N, MPa".

    The second, the kelvin and the ampere unless the list determines others.
    """
    texts = [text.strip() for text in fitted_in.split(",") if text.strip()]
    if not texts:
        return [mpf(1)] * 5
    units = [parse_unit(text) for text in (*texts, "s", "K", "A")]
    rows = [
        [mpf(exponent.constant.numerator) / exponent.constant.denominator for exponent in u.exponents] for u in units
    ]
    solution = mp.lu_solve(mp.matrix(rows), mp.matrix([mp.log(mpf(repr(u.factor))) for u in units]))
    return [mp.exp(x) for x in solution]


def evaluate(expression: sp.Expr, state: State) -> Any:
    """Evaluate an expression with mpmath, at the working precision."""
    symbols, value = _numeric(expression)
    return value(*(state[symbol] for symbol in symbols))


@lru_cache(maxsize=1024)
def _numeric(expression: sp.Expr) -> tuple[list[sp.Symbol], Callable[..., Any]]:
    """Function of mpmath numbers for an expression, and its arguments."""
    symbols = sorted(expression.free_symbols, key=str)
    return symbols, numeric(symbols, expression)


def numeric(symbols: Sequence[Any], wanted: Any, named: Sequence[tuple[Any, Any]] = ()) -> Callable[..., Any]:
    """Function of mpmath numbers, the values of `symbols`, for an expression or several.

    named  assignments that they use, in order
    """
    choose = {"Where": lambda condition, a, b: a if condition else b}
    made: Callable[..., Any] = sp.lambdify(symbols, wanted, [choose, "mpmath"], cse=lambda of: (named, of))
    return made


def scale_factor(dimension: Dimension, factors: Sequence[Any], state: State) -> Any:
    """Scale factor of a quantity of this dimension; symbols in its exponents have the state's values."""
    total = mpf(1)
    if dimension.every:
        return total
    for factor, exponent in zip(factors, dimension.exponents, strict=True):
        if exponent != 0 and factor != 1:
            power = mpf(exponent.p) / exponent.q if exponent.is_Rational else evaluate(exponent, state)
            total *= mpf(factor) ** power
    return total
