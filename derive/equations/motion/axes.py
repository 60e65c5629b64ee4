"""Changes of axes by rotations of vectors and symmetric matrices.

They are applied entry by entry, and only to entries that are requested.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import sympy as sp

from hertzwerk.derive.expressions.algebra.vectors import (
    Matrix,
    Vector,
    apply,
    dot,
    less,
    product,
    rotation,
    total,
    transpose,
)
from hertzwerk.derive.program.program import Tape


class Entries:
    """A 3 x 3 matrix whose entries are computed, and named, on first request."""

    def __init__(self, entry: Callable[[int, int], Any]) -> None:
        self._entry = entry
        self._known: dict[tuple[int, int], Any] = {}

    def __getitem__(self, place: tuple[int, int]) -> Any:
        if place not in self._known:
            self._known[place] = self._entry(*place)
        return self._known[place]

    def row(self, i: int) -> Vector:
        """A row."""
        return (self[i, 0], self[i, 1], self[i, 2])

    def column(self, j: int) -> Vector:
        """A column."""
        return (self[0, j], self[1, j], self[2, j])

    def named(self, tape: Tape, name: str) -> Self:
        """The same matrix with every entry named on the tape."""
        return type(self)(lambda i, j: tape.let(self[i, j], f"{name}_{'xyz'[i]}_{'xyz'[j]}"))

    def apply(self, a: Vector) -> Vector:
        """Product M a; entries multiplied by zero are never requested."""
        return tuple(total(*(product(self[i, j], a[j]) for j in range(3) if a[j] != 0)) for i in range(3))

    @property
    def transposed(self) -> Entries:
        """The transpose."""
        return Entries(lambda i, j: self[j, i])


class Symmetric(Entries):
    """A symmetric matrix, of which the upper triangle is computed."""

    def __getitem__(self, place: tuple[int, int]) -> Any:
        return super().__getitem__((min(place), max(place)))


def added(*parts: Symmetric) -> Symmetric:
    """Sum of symmetric matrices."""
    return Symmetric(lambda i, j: total(*(part[i, j] for part in parts)))


def of_matrix(matrix: Matrix) -> Symmetric:
    """Symmetric matrix from given entries."""
    return Symmetric(lambda i, j: matrix[i][j])


@dataclass(frozen=True)
class Turn:
    """Rotation about a coordinate axis by an angle with named cosine and (signed) sine."""

    k: int
    cosine: Any
    sine: Any

    @cached_property
    def matrix(self) -> Matrix:
        """Rotation matrix from the rotated to the original axes."""
        return rotation(tuple(sp.Integer(int(i == self.k)) for i in range(3)), self.cosine, self.sine)

    def out(self, a: Vector) -> Vector:
        """Components in the original axes, from those in the rotated axes."""
        return self._rotated(a, self.sine)

    def back(self, a: Vector) -> Vector:
        """Components in the rotated axes, from those in the original axes."""
        return self._rotated(a, -self.sine)

    def _rotated(self, a: Vector, sine: Any) -> Vector:
        i, j = (self.k + 1) % 3, (self.k + 2) % 3
        out = list(a)
        out[i] = less(product(self.cosine, a[i]), product(sine, a[j]))
        out[j] = total(product(sine, a[i]), product(self.cosine, a[j]))
        return (out[0], out[1], out[2])

    def symmetric(self, inner: Symmetric, tape: Tape, name: str) -> Symmetric:
        """Components of a symmetric matrix in the original axes, with fewer operations than R J R^T.

        With D = J_jj - J_ii and e = s D - 2 c J_ij, J_ii grows by s e, J_jj shrinks by it, and J_ij becomes -c e -
        J_ij.
        """
        i, j, k = (self.k + 1) % 3, (self.k + 2) % 3, self.k

        def swing() -> Any:
            twice = tape.let(2 * inner[i, j], f"{name}_twice") if tape.is_constant(inner[i, j]) else 2 * inner[i, j]
            return tape.let(self.sine * (inner[j, j] - inner[i, i]) - self.cosine * twice, f"{name}_swing")

        def entry(a: int, b: int) -> Any:
            if (a, b) == (k, k):
                return inner[k, k]
            if k in (a, b):
                other = b if a == k else a
                crossed = self.out(tuple(inner[n, k] if n != k else sp.S.Zero for n in range(3)))
                return crossed[other]
            if a != b:
                return -self.cosine * swing() - inner[i, j]
            return inner[a, a] + (self.sine * swing() if a == i else -self.sine * swing())

        return Symmetric(entry)


@dataclass(frozen=True)
class Fixed:
    """Any rotation, given by its matrix from the inner axes to the outer ones."""

    matrix: Matrix

    def out(self, a: Vector) -> Vector:
        """Components in the outer axes."""
        return apply(self.matrix, a)

    def back(self, a: Vector) -> Vector:
        """Components in the inner axes."""
        return apply(transpose(self.matrix), a)

    def symmetric(self, inner: Symmetric, tape: Tape, name: str) -> Symmetric:
        """Product R J R^T."""
        R = self.matrix
        half = [tape.vector(inner.apply(R[i]), f"{name}_half_{'xyz'[i]}") for i in range(3)]
        return Symmetric(lambda i, j: dot(R[j], half[i]))


Step = Turn | Fixed


@dataclass(frozen=True)
class Change:
    """A change of axes: its steps from the outermost inwards."""

    steps: tuple[Step, ...] = ()

    def out(self, a: Vector) -> Vector:
        """Components in the outer axes."""
        for step in reversed(self.steps):
            a = step.out(a)
        return a

    def back(self, a: Vector) -> Vector:
        """Components in the inner axes."""
        for step in self.steps:
            a = step.back(a)
        return a

    def symmetric(self, inner: Symmetric, tape: Tape, name: str) -> Symmetric:
        """Components of a symmetric matrix in the outer axes."""
        for step in reversed(self.steps):
            inner = step.symmetric(inner, tape, name).named(tape, name)
        return inner

    def both(self, inner: Entries, tape: Tape, name: str) -> Entries:
        """Components of any matrix in the outer axes."""
        if not self.steps:
            return inner
        half = [tape.vector(self.out(inner.column(j)), f"{name}_{'xyz'[j]}") for j in range(3)]
        rows = [self.out((half[0][i], half[1][i], half[2][i])) for i in range(3)]
        return Entries(lambda i, j: rows[i][j])
