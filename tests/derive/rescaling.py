"""Rescaling audit: consistent equations hold in every system of units, tested with numbers.

An expression is evaluated at states that span the range of each of its arguments; then mass, length, time,
temperature and current are scaled by 2, 3, 5, 7 and 11, together and one at a time, every argument following its declared unit. A
consistent result follows its own unit to rounding. A wrong power of a unit leaves one factor for all states; a
logarithm of a length, a sum of unlike terms or a constant that hides a unit leaves a factor that depends on the
state. The form of the expression is not used: this is the independent check of `dimension`.
"""

from fractions import Fraction
from typing import NamedTuple

from mpmath import mp, mpf

from hertzwerk.derive.audit.numeric import DIGITS, evaluate, lattice, scale_factor
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.laws.law import F, StiffnessLaw, d

ROUNDING = mpf(10) ** -25  # 40 digits, less the cancellation in any law
FACTORS = (2, 3, 5, 7, 11)
SCALINGS = {
    "all": FACTORS, "mass": (2, 1, 1, 1, 1), "length": (1, 3, 1, 1, 1), "time": (1, 1, 5, 1, 1),
    "temperature": (1, 1, 1, 7, 1), "current": (1, 1, 1, 1, 11),
}  # fmt: skip


class Rescaling(NamedTuple):
    """Scaled results of one expression over those its unit predicts, by scaling and state."""

    what: str
    states: tuple
    ratios: dict

    @property
    def consistent(self):
        """Whether every ratio is 1 to rounding."""
        return all(abs(ratio - 1) <= ROUNDING for row in self.ratios.values() for ratio in row)

    @property
    def excess(self):
        """Powers of mass, length, time, temperature, current beyond the expected ones; None where none fit all states."""
        powers = []
        for base, name in zip(FACTORS, ("mass", "length", "time", "temperature", "current"), strict=True):
            row = self.ratios[name]
            if any(abs(ratio - row[0]) > ROUNDING * abs(row[0]) for ratio in row) or mp.im(row[0]) or row[0] <= 0:
                return None
            with mp.workdps(DIGITS):
                powers.append(Fraction(str(mp.nstr(mp.log(row[0]) / mp.log(base), 20))).limit_denominator(1000))
        return tuple(powers)


def rescale(what, expression, expected, dimensions, states):
    """Scale one expression at `states`, which have values of all symbols, also of those in exponents."""
    ratios = {}
    with mp.workdps(DIGITS):
        before = [evaluate(expression, state) for state in states]
        for name, factors in SCALINGS.items():
            row = []
            for state, old in zip(states, before, strict=True):
                scaled = {q: state[q] * scale_factor(dimensions[q], factors, state) for q in expression.free_symbols}
                row.append(_ratio(evaluate(expression, scaled), old * scale_factor(expected, factors, state)))
            ratios[name] = tuple(row)
    return Rescaling(what, tuple(states), ratios)


def rescale_law(law):
    """Scale every definition and expression of a law, at states in its units."""
    names = {symbol.name: symbol for symbol in law.parameters if symbol.unit == "1"}
    dimensions = {symbol: Dimension.from_unit(parse_unit(symbol.unit), names) for symbol in law.symbols()}
    states = list(states_of(law, dimensions))
    rows = [*((f"definition of {q.name}", e, q.unit) for q, e in law.definitions), *law.expressions()]
    return [
        rescale(what, e, Dimension.from_unit(parse_unit(unit), names), dimensions, states) for what, e, unit in rows
    ]


def states_of(law, dimensions):
    """Yield values of every symbol of a law: the lattice, the law's definitions and the force of a stiffness in its reach."""
    with mp.workdps(DIGITS):
        for state in lattice(law, dimensions):
            for symbol, expression in law.definitions:
                state[symbol] = evaluate(expression, state)
            if isinstance(law, StiffnessLaw):
                if law.reach is not None and d in state:
                    state[d] = min(state[d], evaluate(law.reach, state) * mpf("0.99"))
                state[F] = evaluate(law.force, state)
            yield state


def _ratio(new, predicted):
    """Ratio new/predicted; 1 where both are zero."""
    if predicted == 0:
        return mpf(1) if new == 0 else mp.inf
    return new / predicted
