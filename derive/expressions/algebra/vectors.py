"""Three-component vectors and matrices of SymPy expressions; structural zeros and ones are skipped."""

from __future__ import annotations

from typing import Any

import sympy as sp

Vector = tuple[Any, Any, Any]
ZERO: Vector = (sp.S.Zero, sp.S.Zero, sp.S.Zero)


def product(a: Any, b: Any) -> Any:
    """Product a b; zeros and ones are detected without SymPy, a hundred times faster."""
    if a is ZERO[0] or b is ZERO[0]:
        return ZERO[0]
    if a is sp.S.One or b is sp.S.One:
        return b if a is sp.S.One else a
    if isinstance(a, sp.Symbol) and isinstance(b, sp.Symbol) and (order := a.compare(b)):
        return sp.Mul._from_args((a, b) if order < 0 else (b, a))  # as SymPy, six times faster
    return a * b


def total(*summands: Any) -> Any:
    """Sum of terms."""
    terms = [term for term in summands if term is not ZERO[0]]
    return terms[0] if len(terms) == 1 else sp.Add(*terms)


def less(value: Any, *terms: Any) -> Any:
    """A value minus a sum of terms, each negated by itself, which is cheaper than negating the sum."""
    return total(value, *(-term for term in terms))


def add(*vectors: Vector) -> Vector:
    """Sum of vectors."""
    return tuple(total(*(v[i] for v in vectors)) for i in range(3))


def sub(a: Vector, b: Vector) -> Vector:
    """Difference a - b."""
    return tuple(x if y is ZERO[0] else x - y for x, y in zip(a, b, strict=True))


def scale(factor: Any, a: Vector) -> Vector:
    """Product factor * a."""
    factor = sp.sympify(factor)
    return tuple(product(factor, x) for x in a)


def dot(a: Vector, b: Vector) -> Any:
    """Scalar product a . b."""
    return total(*(product(x, y) for x, y in zip(a, b, strict=True)))


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product a x b."""
    out = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        first, second = product(a[j], b[k]), product(a[k], b[j])
        out.append(first if second is ZERO[0] else first - second)
    return (out[0], out[1], out[2])


def is_zero(a: Vector) -> bool:
    """Whether a vector is structurally zero."""
    return all(component == 0 for component in a)


Matrix = tuple[Vector, Vector, Vector]
"""Rows."""
IDENTITY: Matrix = (
    (sp.S.One, sp.S.Zero, sp.S.Zero),
    (sp.S.Zero, sp.S.One, sp.S.Zero),
    (sp.S.Zero, sp.S.Zero, sp.S.One),
)


def apply(m: Matrix, a: Vector) -> Vector:
    """Product M a."""
    return (dot(m[0], a), dot(m[1], a), dot(m[2], a))


def transpose(m: Matrix) -> Matrix:
    """Transpose of a matrix."""
    return tuple(tuple(m[j][i] for j in range(3)) for i in range(3))  # type: ignore[return-value]


def multiply(a: Matrix, b: Matrix) -> Matrix:
    """Product A B."""
    columns = transpose(b)
    return tuple(tuple(dot(a[i], columns[j]) for j in range(3)) for i in range(3))  # type: ignore[return-value]


def combine(*matrices: Matrix) -> Matrix:
    """Sum of matrices."""
    return tuple(add(*(m[i] for m in matrices)) for i in range(3))  # type: ignore[return-value]


def outer(a: Vector, b: Vector) -> Matrix:
    """Outer product a b^T."""
    return (scale(a[0], b), scale(a[1], b), scale(a[2], b))


def diagonal(a: Any, b: Any, c: Any) -> Matrix:
    """Diagonal matrix."""
    zero = sp.S.Zero
    return ((sp.sympify(a), zero, zero), (zero, sp.sympify(b), zero), (zero, zero, sp.sympify(c)))


def rotation(axis: Vector, cosine: Any, sine: Any) -> Matrix:
    """Rotation about a coordinate axis (one entry +-1), with exact zeros and ones."""
    k = next(i for i in range(3) if axis[i])
    s = axis[k] * sine
    i, j = (k + 1) % 3, (k + 2) % 3
    rows: list[list[Any]] = [[sp.S.Zero] * 3 for _ in range(3)]
    rows[k][k] = sp.S.One
    rows[i][i] = rows[j][j] = cosine
    rows[i][j], rows[j][i] = -s, s
    return tuple(tuple(row) for row in rows)  # type: ignore[return-value]


def along(axis: Vector) -> int | None:
    """Index of the coordinate axis that a unit vector is parallel to; None if none."""
    return next((k for k in range(3) if axis[k] in (1, -1)), None)


def about(axis: Vector, cosine: Any, sine: Any) -> Matrix:
    """Rotation about any unit vector (Rodrigues' formula)."""
    if along(axis) is not None:
        return rotation(axis, cosine, sine)
    x, y, z = axis
    tilde: Matrix = ((sp.S.Zero, -z, y), (z, sp.S.Zero, -x), (-y, x, sp.S.Zero))
    return combine(*(scaled(f, m) for f, m in ((cosine, IDENTITY), (sine, tilde), (1 - cosine, outer(axis, axis)))))


def scaled(factor: Any, matrix: Matrix) -> Matrix:
    """Product factor * M."""
    return (scale(factor, matrix[0]), scale(factor, matrix[1]), scale(factor, matrix[2]))
