"""Shapes in which a slender rod bends, and their integrals over its length, as numbers.

A shape is a function of xi = x/L. It is seen from the tangent at the start, so that it and its slope vanish there.
Blevins, Formulas for Natural Frequency and Mode Shape (1979), table 8-1; the cubics are those of Hermite. Digits beyond a double's
make the numbers the same on every machine.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import sympy as sp
from mpmath import mp  # SymPy brings it
from mpmath.calculus.quadrature import GaussLegendre

ENDS = ("clamped", "pinned", "free")
"""Conditions of an end, of which the shapes are the eigenfunctions."""
MOST = 12
"""Largest number of eigenfunctions whose products the quadrature integrates to all digits."""
DIGITS, DEGREE = 25, 5  # 48 nodes
ZERO = 1e-20

Shape = Callable[[Any, int], Any]
"""Derivative of order k of a shape at xi."""
Numbers = tuple[Any, ...]
Rows = tuple[Numbers, ...]


class BendingShapes:
    """Eigenfunctions of a rod with these ends, after the two cubics of a loaded end where there are any.

    roots  beta L of each eigenfunction
    """

    def __init__(self, ends: tuple[str, str], count: int, cubics: bool) -> None:
        with mp.workdps(DIGITS):
            self.roots = [_root(*ends, k) for k in range(1, count + 1)]
            self._shapes = [_eigenfunction(*ends, root) for root in self.roots]
            if cubics:  # a unit deflection of the end without slope, then a unit slope without deflection
                self._shapes = [_polynomial(0, 0, 3, -2), _polynomial(0, 0, -1, 1), *self._shapes]
            self._samples = [(x, w, [[of(x, k) for of in self._shapes] for k in range(3)]) for x, w in _nodes()]
        self._range = range(len(self._shapes))

    def at(self, xi: Any, order: int = 0) -> Numbers:
        """Values of the shapes, or of derivatives."""
        with mp.workdps(DIGITS):
            return tuple(_number(shape(mp.mpf(xi), order)) for shape in self._shapes)

    def integrals(self, power: int = 0) -> Numbers:
        """Integrals of xi^power times each shape."""
        with mp.workdps(DIGITS):
            return tuple(_number(mp.fsum(w * x**power * at[0][i] for x, w, at in self._samples)) for i in self._range)

    def products(self, order: int, factor: Callable[[Any], Any] = lambda x: 1) -> Rows:
        """Integrals of a factor times the products of two shapes' derivatives: a symmetric matrix."""
        with mp.workdps(DIGITS):
            return _rows(self._products(order, factor))

    def damping(self) -> Rows:
        """Half the damping matrix of ratio 1, by sqrt(E I m/L^3): a symmetric matrix D.

        It is the geometric mean of the matrices M of mass and K of stiffness, D M^-1 D = K. With cubics each mode of a rod that is
        clamped at its start alone has the ratio; without them M has the frequencies of the eigenfunctions, and each has it.
        """
        with mp.workdps(DIGITS):
            stiff, cubics = self._products(2), len(self.roots) < len(self._range)
            mass = self._products(0) if cubics else mp.diag([stiff[i, i] / b**4 for i, b in enumerate(self.roots)])
            lower = mp.cholesky(mass)
            squares, modes = mp.eigsy(lower**-1 * stiff * lower.T**-1)
            return _rows(lower * modes * mp.diag([mp.sqrt(square) for square in squares]) * modes.T * lower.T)

    def _products(self, order: int, factor: Callable[[Any], Any] = lambda x: 1) -> Any:
        weights = [(w * factor(x), at[order]) for x, w, at in self._samples]
        return mp.matrix([[mp.fsum(w * at[i] * at[j] for w, at in weights) for j in self._range] for i in self._range])


@lru_cache
def bending_shapes(ends: tuple[str, str], count: int, cubics: bool) -> BendingShapes:
    """Shapes of a rod, computed once."""
    return BendingShapes(ends, count, cubics)


def _root(start: str, end: str, k: int) -> Any:
    """Root beta L number k of the frequency equation."""
    if start == end == "pinned":
        return k * mp.pi
    if "pinned" in (start, end):
        return mp.findroot(lambda b: mp.sin(b) - mp.cos(b) * mp.tanh(b), (k + mp.mpf("0.25")) * mp.pi)
    sign = 1 if start != end else -1
    guess = mp.mpf("1.875") if start != end and k == 1 else (k - sign * mp.mpf("0.5")) * mp.pi
    return mp.findroot(lambda b: mp.cos(b) + sign * mp.sech(b), guess)


def _eigenfunction(start: str, end: str, root: Any) -> Shape:
    """Eigenfunction that is 1 at a free end, else of mean square 1/2, seen from the tangent at its start.

    It is falling e^(-b xi) + rising e^(-b (1 - xi)) + c cos b xi + d sin b xi, in which nothing cancels.
    """
    order = {"clamped": 0, "pinned": 0, "free": 2}[end]
    small, sign = mp.exp(-root), (-1) ** order
    cosine, sine = _cosine(root, order), _cosine(root, order - 1)
    if start == "pinned":
        rising = -sine / (1 - sign * small**2)
        falling, c, d = -small * rising, 0, 1
    else:
        side, falling = (1 if start == "free" else -1), 1
        rising = -(sign * small + side * (cosine - sine)) / (1 + side * small * (cosine + sine))
        c, d = side * (1 + small * rising), side * (small * rising - 1)

    def raw(x: Any, k: int) -> Any:
        grown = rising * mp.exp(-root * (1 - x)) + falling * (-1) ** k * mp.exp(-root * x)
        return root**k * (grown + c * _cosine(root * x, k) + d * _cosine(root * x, k - 1))

    square = mp.fsum(w * raw(x, 0) ** 2 for x, w in _nodes()) * (4 if "free" in (start, end) else 2)
    size = mp.sign(raw(mp.zero, {"clamped": 2, "pinned": 1, "free": 0}[start])) * mp.sqrt(square)
    value, slope = (raw(mp.zero, k) if start != "clamped" else mp.zero for k in range(2))
    return lambda x, k: (raw(x, k) - (value + slope * x, slope, 0)[k]) / size


def _cosine(x: Any, k: int) -> Any:
    """Derivative of order k of the cosine; of order -1 the sine."""
    return (1, -1, -1, 1)[k % 4] * (mp.sin(x) if k % 2 else mp.cos(x))


def _polynomial(*coefficients: int) -> Shape:
    return lambda x, k: mp.fsum(mp.ff(power, k) * c * x ** max(power - k, 0) for power, c in enumerate(coefficients))


@lru_cache
def _nodes() -> list[tuple[Any, Any]]:
    """Nodes and weights of Gauss and Legendre on (0, 1)."""
    return [*GaussLegendre(mp).get_nodes(mp.zero, mp.one, DEGREE, mp.prec)]


def _rows(matrix: Any) -> Rows:
    return tuple(tuple(map(_number, row)) for row in matrix.tolist())


def _number(value: Any) -> Any:
    """Double, an integer where the value is one to rounding."""
    whole = mp.nint(value)
    return sp.Integer(int(whole)) if abs(value - whole) < ZERO else sp.Float(float(value))
