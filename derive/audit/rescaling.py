"""Rescaling audit: consistent equations hold in every system of units, tested with numbers.

An expression is evaluated at states that span the range of each of its arguments; then mass, length, time and
temperature are scaled by 2, 3, 5 and 7, together and one at a time, every argument following its declared unit. A
consistent result follows its own unit to rounding. A wrong power of a unit leaves one factor for all states; a
logarithm of a length, a sum of unlike terms or a constant that hides a unit leaves a factor that depends on the
state. The form of the expression is not used: this is the independent check of `dimension`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp
from mpmath import mp, mpf  # SymPy brings it

from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.laws.law import (
    R_1,
    R_2,
    F,
    L,
    Law,
    Quantity,
    R_eff,
    R_min,
    StiffnessLaw,
    d,
    dR,
    eps_c,
    eps_w,
    s,
    v,
)
from hertzwerk.derive.mechanism.parameter import Interval
from hertzwerk.derive.units import parse_unit

DIGITS = 40
ROUNDING = mpf(10) ** -25  # 40 digits, less the cancellation in any law
STATES = 11  # prime: each argument takes every one of its eleven values, in an order of its own

FACTORS = (2, 3, 5, 7)
SCALINGS: dict[str, tuple[int, int, int, int]] = {
    "all": FACTORS,
    "mass": (2, 1, 1, 1),
    "length": (1, 3, 1, 1),
    "time": (1, 1, 5, 1),
    "temperature": (1, 1, 1, 7),
}

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
    "v_a": (1e-3, 1e-2),
    "v_b": (0.1, 1),
    "epsilon_w": (0.05, 0.65),
    "epsilon_c": (0.05, 0.65),
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


@dataclass(frozen=True)
class Rescaling:
    """Scaled results of one expression over those its unit predicts, by scaling and state."""

    what: str
    states: tuple[State, ...]
    ratios: Mapping[str, tuple[Any, ...]]

    @property
    def deviation(self) -> float:
        """Largest deviation of a ratio from 1."""
        return float(max(abs(ratio - 1) for row in self.ratios.values() for ratio in row))

    @property
    def consistent(self) -> bool:
        """Whether every ratio is 1 to rounding."""
        return all(abs(ratio - 1) <= ROUNDING for row in self.ratios.values() for ratio in row)

    @property
    def excess(self) -> tuple[Fraction, ...] | None:
        """Powers of mass, length, time, temperature beyond the expected ones; None where none fit all states."""
        powers = []
        for base, name in zip(FACTORS, ("mass", "length", "time", "temperature"), strict=True):
            row = self.ratios[name]
            if any(abs(ratio - row[0]) > ROUNDING * abs(row[0]) for ratio in row) or mp.im(row[0]) or row[0] <= 0:
                return None
            with mp.workdps(DIGITS):
                powers.append(Fraction(str(mp.nstr(mp.log(row[0]) / mp.log(base), 20))).limit_denominator(1000))
        return tuple(powers)


def rescale(
    what: str,
    expression: sp.Expr,
    expected: Dimension,
    dimensions: Mapping[sp.Symbol, Dimension],
    states: Sequence[State],
) -> Rescaling:
    """Scale one expression at `states`, which have values of all symbols, also of those in exponents."""
    with mp.workdps(DIGITS):
        symbols, value = _numeric(expression)
        before = [value(*(state[symbol] for symbol in symbols)) for state in states]
        ratios = {}
        for name, factors in SCALINGS.items():
            row = []
            for state, old in zip(states, before, strict=True):
                new = value(*(state[symbol] * _factor(dimensions[symbol], factors, state) for symbol in symbols))
                row.append(_ratio(new, old * _factor(expected, factors, state)))
            ratios[name] = tuple(row)
    return Rescaling(what, tuple(states), ratios)


def rescale_law(law: Law) -> tuple[Rescaling, ...]:
    """Scale every definition and expression of a law, at states in its units."""
    names = {symbol.name: symbol for symbol in law.parameters if symbol.unit == "1"}
    dimensions = {symbol: Dimension.from_unit(parse_unit(symbol.unit), names) for symbol in law.symbols()}
    states = list(states_of(law, dimensions))
    rows = [*((f"definition of {q.name}", e, q.unit) for q, e in law.definitions), *law.expressions()]
    return tuple(
        rescale(what, e, Dimension.from_unit(parse_unit(unit), names), dimensions, states) for what, e, unit in rows
    )


def states_of(law: Law, dimensions: Mapping[sp.Symbol, Dimension]) -> Iterator[State]:
    """Yield values of every symbol of a law: the lattice and the results of the law."""
    with mp.workdps(DIGITS):
        for state in lattice(law, dimensions):
            yield _with_law_results(law, state)


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


def _with_law_results(law: Law, state: dict[sp.Symbol, Any]) -> State:
    """Add the law's definitions; for a stiffness law also its force, with the penetration in its reach."""
    for symbol, expression in law.definitions:
        state[symbol] = evaluate(expression, state)
    if isinstance(law, StiffnessLaw):
        if law.reach is not None and d in state:
            state[d] = min(state[d], evaluate(law.reach, state) * mpf("0.99"))
        state[F] = evaluate(law.force, state)
    return state


def _in_units(state: State, dimensions: Mapping[sp.Symbol, Dimension], system: Sequence[Any]) -> dict[sp.Symbol, Any]:
    """Convert values from SI to a system with the given units of mass, length, time, temperature."""
    if all(unit == 1 for unit in system):
        return dict(state)
    return {
        q: value / _factor(dimensions[q], system, state) if q in dimensions else value for q, value in state.items()
    }


def _base_units(fitted_in: str) -> list[Any]:
    """SI sizes of the units of mass, length, time, temperature in a list such as "mm, N, MPa".

    The second and the kelvin unless the list determines others.
    """
    texts = [text.strip() for text in fitted_in.split(",") if text.strip()]
    if not texts:
        return [mpf(1)] * 4
    units = [parse_unit(text) for text in (*texts, "s", "K")]
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
    return symbols, sp.lambdify(symbols, expression, [{"Where": _choose}, "mpmath"])


def _choose(condition: Any, a: Any, b: Any) -> Any:
    return a if condition else b


def _ratio(new: Any, predicted: Any) -> Any:
    """Ratio new/predicted; 1 where both are zero."""
    if predicted == 0:
        return mpf(1) if new == 0 else mp.inf
    return new / predicted


def _factor(dimension: Dimension, factors: Sequence[Any], state: State) -> Any:
    """Scale factor of a quantity of this dimension; symbols in its exponents have the state's values."""
    total = mpf(1)
    if dimension.every:
        return total
    for factor, exponent in zip(factors, dimension.exponents, strict=True):
        if exponent != 0 and factor != 1:
            power = mpf(exponent.p) / exponent.q if exponent.is_Rational else evaluate(exponent, state)
            total *= mpf(factor) ** power
    return total
