"""Hysteresis law that returns the requested restitution; its factor is a root of Newton's method."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.laws.formulas.damping import e, hysteresis
from hertzwerk.derive.laws.law import Quantity

_y = Quantity("y", "1", "(1 - e)/(1 + e), of which t is the inverse Langevin function")
_r = Quantity("r", "1", "1 - y, without cancellation")


def _inverse_langevin(steps: int) -> Iterator[tuple[Quantity, sp.Expr]]:
    """Yield definitions of t = L^-1(y), the inverse Langevin function, L(t) = coth t - 1/t, r = 1 - y.

    Newton's method from a start that is accurate to 0.3 %. Below t = 1 the Langevin function is its continued
    fraction t/(3 + t^2/(5 + t^2/(7 + ...))), because coth t - 1/t cancels there; above, y - L is taken as 1/t - (coth
    t - 1) - r, because 1 - y cancels there.
    """
    t = Quantity("t_0", "1", "first guess of h (1 + e)/2")
    yield (
        t,
        _y * (3 - (6 * _y**2 + _y**4 - 2 * _y**6) / 5) / (_r * (1 + _y)),
    )  # Kroeger, J. Non-Newton. Fluid Mech. 223 (2015) 77
    for k in range(steps):
        q = Quantity(f"q_{k}", "1", "t/L(t) by the continued fraction, for t < 1")
        w = Quantity(f"w_{k}", "1", "1/t, for t > 1")  # bounded: the branch that is not taken stays finite
        c = Quantity(f"c_{k}", "1", "coth t - 1, for t > 1")
        yield q, _langevin_fraction(t)
        yield w, 1 / sp.Max(t, 1)
        yield c, 2 / (sp.exp(2 / w) - 1)
        step = Where(t < 1, (_y - t / q) / (1 - (t / q) ** 2 - 2 / q), (w - c - _r) / (w**2 - c * (c + 2)))
        following = Quantity(f"t_{k + 1}", "1", f"h (1 + e)/2 after {k + 1} of Newton's steps")
        yield following, t + step
        t = following


def _langevin_fraction(t: Quantity) -> sp.Expr:
    """Continued fraction 3 + t^2/(5 + t^2/(7 + ... 17)) as one quotient of polynomials.

    All coefficients are positive, so nothing cancels.
    """
    above, below = [17], [1]
    for odd in range(15, 1, -2):
        shifted = [0, *below]
        size = max(len(above), len(shifted))
        padded = above + [0] * (size - len(above)), shifted + [0] * (size - len(shifted))
        above, below = [odd * a + b for a, b in zip(*padded, strict=True)], above
    top, bottom = (sp.Add(*(c * t ** (2 * k) for k, c in enumerate(row))) for row in (above, below))
    return top / bottom


_LANGEVIN = tuple(_inverse_langevin(3))

exact = hysteresis(
    2 * _LANGEVIN[-1][0] / (1 + e),
    sp.oo,
    name="exact",
    title="Exact factor: restitution out equals restitution in",
    definitions=((_y, (1 - e) / (1 + e)), (_r, 2 * e / (1 + e)), *_LANGEVIN),
    source="root of h (1 + e) = ln((1 + h)/(1 - h e)), the relation of F (1 + h v/v0): Hunt, Crossley, J. Appl. Mech. 42 (1975) 440",
    grade="A",
    note="coth t - 1/t = (1 - e)/(1 + e), h = 2 t/(1 + e): computed once, from the restitution alone.",
)
