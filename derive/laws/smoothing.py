"""Contact laws with two continuous derivatives at the onset: of a penetration that begins smoothly.

A law F(d) that begins like d^n has no second derivative at d = 0 for n < 2, and none at all where the surfaces part. With
a length epsilon its penetration d is replaced by

    s = 2 epsilon (x^3 - x^4/2)  for x = d/(2 epsilon) < 1,   s = d - epsilon  beyond,

which is 0 with two derivatives at d = 0, and joins the straight line with two. F(s) begins like d^(3 n), so it is twice
continuously differentiable for every n > 2/3. Beyond 2 epsilon the same force has a penetration deeper by epsilon exactly;
before it never exceeds the law's, which rises with d. The stored energy is the integral of F(s) over d.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.parameter import parameters_of
from hertzwerk.derive.laws.law import BoundLaw, DampingLaw, F, Law, StiffnessLaw, d, gauss_legendre, k_t

NODES = 12  # of the energy stored on the way to 2 epsilon: to 1e-13 of it
LEAST_GROWTH = sp.Rational(2, 3)  # exponent of d from which a force of the smoothed penetration has two derivatives


def begun(share: Any, length: Any) -> Any:
    """Return the smoothed penetration [m] at a share x <= 1 of twice the length epsilon [m]."""
    return 2 * length * (share**3 - share**4 / 2)


def energy_begun(law: StiffnessLaw, values: dict[sp.Symbol, Any], share: Any, length: Any) -> Any:
    """Return the energy [J] that a law stores up to a share x <= 1, by Gaussian quadrature in sqrt(x).

    values    of the law's symbols, but for d
    """
    terms = [
        weight * 2 * node * law.force.xreplace({**values, d: begun(share * node**2, length)})
        for node, weight in gauss_legendre(NODES)
    ]
    return 2 * length * share * sp.Add(*terms)


def growths(stiffness: BoundLaw, damping: BoundLaw | None) -> Iterator[tuple[Law, float]]:
    """Yield both laws with the exponent of d that their forces begin with, at the parameters' defaults."""
    elastic: StiffnessLaw = stiffness.law
    yield elastic, _growth(elastic.force, elastic, stiffness)
    if damping is not None:
        law: DampingLaw = damping.law
        force = {F: _written_out(elastic.force, elastic, stiffness)}
        force[k_t] = sp.diff(force[F], d)
        yield law, _growth(law.resistance, law, damping, force)


def _written_out(expression: sp.Expr, law: Law, bound: BoundLaw) -> sp.Expr:
    """Return an expression with its definitions and parameters put in."""
    for symbol, definition in reversed(law.definitions):
        expression = expression.xreplace({symbol: definition})
    return expression.xreplace(bound.binding)


def _growth(expression: sp.Expr, law: Law, bound: BoundLaw, known: dict[sp.Symbol, Any] | None = None) -> float:
    """Return dlnf/dlnd of a force at a small penetration; nan where it is unknown.

    Quantities that are no parameters are 0.01: the exponent does not depend on them.
    """
    written = _written_out(expression, law, bound).xreplace(known or {})
    values = {p: sp.Float(p.si, 17) for p in parameters_of(written)}
    others = {s: sp.Float(0.01) for s in written.free_symbols if s not in values and s != d}
    numbers = written.xreplace({**values, **others})
    if not numbers.has(d):
        return 0.0
    try:
        slope = float((d * sp.diff(numbers, d) / numbers).subs(d, sp.Float(1e-12)))
    except (TypeError, ValueError):
        return math.nan
    return slope
