"""The audit without symbols on the table of expressions: it agrees with the symbolic audit, except where numbers cannot show the fault."""

import sympy as sp
from each import each
from expressions import CONSISTENT, INCONSISTENT, STATE, UNITS
from mpmath import mp, mpf
from rescaling import ROUNDING, rescale

from hertzwerk.derive.audit.numeric import DIGITS
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension
from hertzwerk.derive.expressions.dimension.expression import to_sympy
from hertzwerk.derive.expressions.dimension.reader import read

SYMBOLS = {name: sp.Symbol(name, real=True) for name in UNITS}
DIMENSIONS = {SYMBOLS[name]: Dimension.from_unit(unit, SYMBOLS) for name, unit in UNITS.items()}
STATES = 5


def states():
    """Five states around the table's own, each symbol on a path of its own; the first is the table's."""
    with mp.workdps(DIGITS):
        for j in range(STATES):
            yield {
                SYMBOLS[name]: mpf(value) * (1 + mpf(j * ((i * i + 3 * i + j) % 101)) / 1000)
                for i, (name, value) in enumerate(STATE.items())
            }


def values_of(text):
    """What an expression means; then, because the value of one alternative does not show the other, the difference of the two sides of every
    comparison, of the arguments of every min and max, and of the branches of every where."""
    expression = to_sympy(read(text), SYMBOLS)
    meant = expression.doit()
    yield from meant if isinstance(meant, sp.MatrixBase) else [meant if isinstance(meant, sp.Expr) else sp.S.Zero]
    for node in sp.preorder_traversal(expression):
        if isinstance(node, sp.core.relational.Relational):
            yield node.lhs - node.rhs
        elif isinstance(node, sp.Max | sp.Min):
            yield from (x - node.args[0] for x in node.args[1:])
        elif isinstance(node, Where) and 0 not in node.args[1:]:
            yield node.args[1] - node.args[2]


def numeric(value):
    return isinstance(value, sp.Expr) and not value.has(
        sp.Derivative, sp.Integral, sp.MatrixBase, sp.MatrixExpr, sp.Determinant
    )


def follows(value, expected):
    """Whether a value scales with the unit it is said to have, or as a difference with any unit at all."""
    if not value.free_symbols:
        return True
    if expected is not None:
        return rescale("", value, expected, DIMENSIONS, list(states())).consistent
    ratios = rescale("", value, ONE, DIMENSIONS, list(states())).ratios
    return all(abs(x - row[0]) <= ROUNDING * abs(row[0]) for name, row in ratios.items() if name != "all" for x in row)


@each(("text", "unit"), CONSISTENT)
def test_laws_that_pass_by_symbols_pass_by_numbers(text, unit):
    first, *rest = [value if numeric(value) else sp.S.Zero for value in values_of(text)]
    assert follows(first, Dimension.from_unit(unit, SYMBOLS))
    assert all(follows(value, None) for value in rest)


BLIND = {
    # by the time there is a number, nothing is left of the fault
    "m - m + t", "0*(x + v)", "x + v*(1 - 1)", "(x + t)/(x + t)", "(x + v)**0", "log(exp(x))", "sin(omega)**2 + cos(omega)**2",
    "diff(m*v**2/2 + x, v)",
    # a power like any other, only no unit has it; a bound that is no length; entries that are consistent one by one
    "x**pi", "d**sqrt(2)", "integrate(F, x, 0, t)", "[x, theta]", "[[c, 0], [0, c_v]] @ [x, y]",
}  # fmt: skip


@each("row", INCONSISTENT)
def test_laws_refused_by_symbols_are_refused_by_numbers(row):
    """Whatever unit such an expression is said to have, scaling finds that it has not; except where no number can show it."""
    text, unit, *_ = row
    first, *rest = [value if numeric(value) else sp.S.Zero for value in values_of(text)]
    expected = None if unit is None else Dimension.from_unit(unit, SYMBOLS)
    noticed = not follows(first, expected) or any(not follows(value, None) for value in rest)
    assert noticed != (text in BLIND)
