"""Bending of a flexible rod: motion of its end, and its inertia beyond that of the rigid rod.

Along the axes of the rod's start, from its point A there, a section at x moves to (x - s, w_y, w_z), with w = sum q_i psi_i(x/L), and
s = 1/2 integral of (w_y'^2 + w_z'^2) from 0 to x, by which bending shortens the rod: the source of its stiffening by axial forces and spin.
The kinetic energy is complete to second order in q and its rates; the equations are Lagrange's of that energy, so that
it is conserved. Kane, Ryan, Banerjee, Dynamics of a cantilever beam attached to a moving base, J. Guidance 10 (1987) 139-151.

The momentum is P = m v + w x c + c', the angular momentum about A is H = c x v + J w + eta, eta = sum of h_i q_i', with the first
moment c, p_i = dc/dq_i and the inertia J. With A's acceleration a and the angular acceleration b the rates of P and H are
m a + b x c + w x (w x c) + 2 w x c' + c'' and c x a + J b + w x J w + J' w + w x eta + eta'. The row of q_i is
p_i.a + h_i.b + M q'' - w.J_i w/2 + w.(h_i' - sum of dh_j/dq_i q_j').
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    about,
    add,
    cross,
    dot,
    multiply,
    product,
    scale,
    total,
)
from hertzwerk.derive.program.program import Tape

NONE = sp.S.Zero
_X, _Y, _Z = IDENTITY
_Table = list[list[Any]]
"""Values by direction, Y and then Z, and shape; zeros in a direction in which the rod does not bend."""


class RodBending:
    """Bending of one rod on a tape, along the axes of its start; rows are those of Y, then those of Z."""

    def __init__(self, tape: Tape, rod: FlexibleRod, q: Sequence[Any], u: Sequence[Any]) -> None:
        self.tape, self.rod, self.name = tape, rod, rod.name
        self.length, self.mass = sp.sympify(rod.length), sp.sympify(rod.mass)
        self.speeds, shapes, self.directions = u, rod.shapes, range(len(rod.stiffnesses))
        self.count = count = len(q) // len(self.directions)
        self.q, self.u = ([[*part[:count]], [*part[count:]] or [NONE] * count] for part in (q, u))
        self._area = [self.mass * number for number in shapes.integrals()]
        self._lever = [self.mass * self.length * number for number in shapes.integrals(1)]
        self._end, self._slope = shapes.at(1), [number / self.length for number in shapes.at(1, 1)]
        self._of_mass = self._scaled(self.mass, shapes.products(0))
        self._shortening = self._scaled(1 / self.length, shapes.products(1))
        self._sinking = self._scaled(self.mass / self.length, shapes.products(1, lambda x: 1 - x))
        self._stiffening = self._scaled(self.mass, shapes.products(1, lambda x: (1 - x**2) / 2))

    # -- sums over the shapes ------------------------------------------------------------------------------------------

    @staticmethod
    def _scaled(factor: Any, rows: Sequence[Sequence[Any]]) -> _Table:
        return [[factor * number for number in row] for row in rows]

    def _times(self, rows: Sequence[Sequence[Any]], of: _Table, label: str) -> _Table:
        """Products of a symmetric matrix of the shapes and vectors."""
        return [[self.tape.let(self._dot(row, part), f"{self.name}_{label}") for row in rows] for part in of]

    def _sum(self, numbers: Sequence[Any], of: _Table, label: str) -> list[Any]:
        """Sum over the shapes, by direction."""
        return [self.tape.let(self._dot(numbers, part), f"{self.name}_{label}") for part in of]

    def _both(self, one: _Table, other: _Table) -> Any:
        """Sum of the products over shapes and directions."""
        return total(*(self._dot(a, b) for a, b in zip(one, other, strict=True)))

    def _by_speeds(self, along: _Table, across: Sequence[Any]) -> list[Vector]:
        """Vectors by each speed: its component along the rod, and that in its direction."""
        return [
            (-along[d][i], *(across[i] if d == k else NONE for k in range(2)))
            for d in self.directions
            for i in range(self.count)
        ]

    # -- motion of the end ---------------------------------------------------------------------------------------------

    @cached_property
    def _drawn_in(self) -> _Table:
        return self._times(self._shortening, self.q, "drawn_in")

    @cached_property
    def tip(self) -> Vector:
        """Vector from A to the end [m]."""
        short = self._both(self.q, self._drawn_in) / 2
        return self.tape.vector((self.length - short, *self._sum(self._end, self.q, "deflection")), f"{self.name}_tip")

    @cached_property
    def slides(self) -> list[Vector]:
        """Velocity of the end by each speed [1]."""
        return self._by_speeds(self._drawn_in, self._end)

    @cached_property
    def angles(self) -> list[tuple[Vector, Any]]:
        """Turns of the end, one after the other: axis and angle [rad]."""
        return self._turned(self._sum(self._slope, self.q, "slope"))

    def _turned(self, slopes: Sequence[Any]) -> list[tuple[Vector, Any]]:
        """Turns of a section by its slopes in the directions: axis and angle [rad]."""
        return [(_Z, slopes[0]), (_Y, -slopes[1])][: len(self.directions)]

    def _cosine_and_sine(self, angle: Any) -> list[Any]:
        return [self.tape.let(f(angle), f"{f.__name__}_{self.name}_slope") for f in (sp.cos, sp.sin)]

    @cached_property
    def rotation(self) -> Matrix:
        """Rotation from the axes of the end to those of the start, of a rod that bends in both directions."""
        matrix = IDENTITY
        for axis, angle in self.angles:
            matrix = multiply(matrix, about(axis, *self._cosine_and_sine(angle)))
        return self.tape.matrix(matrix, f"{self.name}_bent")

    def section(self, percent: int) -> tuple[Vector, Matrix]:
        """Vector from A to a section [m], shortened as the whole rod is, and its rotation matrix."""
        at, matrix = sp.Rational(percent, 100), IDENTITY
        aside = self._sum(self.rod.shapes.at(at), self.q, f"deflection_{percent}")
        slopes = self._sum([number / self.length for number in self.rod.shapes.at(at, 1)], self.q, f"slope_{percent}")
        for axis, angle in self._turned(slopes):
            matrix = multiply(matrix, about(axis, sp.cos(angle), sp.sin(angle)))
        return (at * self.tip[0], *aside), matrix

    @cached_property
    def _hinges(self) -> list[Vector]:
        """Axes of the turns of the end, along the start's axes: of Y's slope, then of Z's."""
        if len(self.directions) == 1:
            return [_Z, ZERO]
        cosine, sine = self._cosine_and_sine(self.angles[0][1])
        return [_Z, (sine, -cosine, NONE)]

    @cached_property
    def turns(self) -> list[Vector]:
        """Angular velocity of the end by each speed [1/m]."""
        return [scale(self._slope[i], self._hinges[d]) for d in self.directions for i in range(self.count)]

    def sum(self, vectors: Sequence[Vector], factors: Sequence[Any], label: str) -> Vector:
        """Sum of a vector of each row times a factor."""
        return self.tape.vector(add(ZERO, *map(scale, factors, vectors)), f"{self.name}_{label}")

    @cached_property
    def moved(self) -> tuple[Vector, Vector]:
        """Velocity and angular velocity of the end, relative to the start."""
        return self.sum(self.slides, self.speeds, "end_velocity"), self.sum(self.turns, self.speeds, "end_turning")

    @cached_property
    def bent(self) -> tuple[Vector, Vector]:
        """Acceleration and angular acceleration of the end, relative to the start, at constant speeds."""
        along = self._both(self.u, self._times(self._shortening, self.u, "drawing_in"))
        one, two = self._sum(self._slope, self.u, "slope_rate")
        bias, swung = (-along, NONE, NONE), scale(product(one, two), cross(_Z, self._hinges[1]))
        return self.tape.vector(bias, f"{self.name}_end_bias"), self.tape.vector(swung, f"{self.name}_end_swing")

    # -- inertia -------------------------------------------------------------------------------------------------------

    @cached_property
    def _weighed(self) -> _Table:
        return self._times(self._of_mass, self.q, "weighed")

    @cached_property
    def _weighed_rates(self) -> _Table:
        return self._times(self._of_mass, self.u, "weighed_rate")

    @cached_property
    def _sunk(self) -> _Table:
        return self._times(self._sinking, self.q, "sunk")

    @cached_property
    def _stiffened(self) -> _Table:
        return self._times(self._stiffening, self.q, "stiffened")

    @cached_property
    def moment(self) -> Vector:
        """First moment c, in addition to that of the straight rod [kg m]."""
        along = -self._both(self.q, self._sunk) / 2
        return self.tape.vector((along, *self._sum(self._area, self.q, "aside")), f"{self.name}_bent_moment")

    @cached_property
    def inertia(self) -> Matrix:
        """Inertia J about A, in addition to that of the straight rod [kg m^2]."""
        return self._inertia(self.q, 1, "")

    @cached_property
    def _inertia_rate(self) -> Matrix:
        return self._inertia(self.u, 2, "_rate")

    def _inertia(self, of: _Table, order: int, label: str) -> Matrix:
        """Inertia by the integrals of x x, x w, w w and w_y w_z over the mass, of order 1, or its rate, 2."""
        along, (xy, xz) = -order * self._both(of, self._stiffened), self._sum(self._lever, of, f"lever{label}")
        y, z = (order * self._dot(part, other) for part, other in zip(of, self._weighed, strict=True))
        mixed = total(*(self._dot(of[d], self._weighed[1 - d]) for d in range(order)))
        rows = ((total(y, z), -xy, -xz), (-xy, total(along, z), -mixed), (-xz, -mixed, total(along, y)))
        return self.tape.matrix(rows, f"{self.name}_bent_inertia{label}")

    @staticmethod
    def _dot(one: Sequence[Any], other: Sequence[Any]) -> Any:
        return total(*map(product, one, other))

    @cached_property
    def pushes(self) -> list[Vector]:
        """Momentum p_i by each speed [kg]."""
        return self._by_speeds(self._sunk, self._area)

    @cached_property
    def twists(self) -> list[Vector]:
        """Angular momentum h_i about A by each speed [kg m]."""
        one, two = self._weighed
        twists = [(-two[i], NONE, self._lever[i]) for i in range(self.count)]
        return [*twists, *((one[i], -self._lever[i], NONE) for i in range(self.count))][: len(self.speeds)]

    def mass_of(self, row: int, other: int) -> Any:
        """Entry of the mass matrix of two rows [kg]."""
        (d, i), (k, j) = divmod(row, self.count), divmod(other, self.count)
        return self._of_mass[i][j] if d == k else NONE

    @cached_property
    def momentum(self) -> tuple[Vector, Vector]:
        """Momentum c' and angular momentum eta of the speeds."""
        return self.sum(self.pushes, self.speeds, "momentum"), self.sum(self.twists, self.speeds, "spin")

    def bias(self, w: Vector) -> tuple[Vector, Vector]:
        """Force 2 w x c' + c'' and moment about A, J' w + w x eta, of the speeds at an angular velocity."""
        along = self._both(self.u, self._times(self._sinking, self.u, "sinking"))
        moved, spin = self.momentum
        turned = tuple(dot(row, w) for row in self._inertia_rate)
        force = add(scale(2, cross(w, moved)), (-along, NONE, NONE))
        return self.tape.vector(force, f"{self.name}_bias"), self.tape.vector(
            add(turned, cross(w, spin)), f"{self.name}_twist"
        )

    def needed(self, w: Vector, alpha: Vector, acceleration: Vector, seconds: Sequence[Any]) -> tuple[Vector, Vector]:
        """Force, and moment about A, that accelerate the rod, beyond those of the straight one."""
        force, moment = self.bias(w)
        turned, inertia = cross(alpha, self.moment), [tuple(dot(row, of) for row in self.inertia) for of in (w, alpha)]
        force = add(force, turned, cross(w, cross(w, self.moment)), self.sum(self.pushes, seconds, "push"))
        gyroscopic = add(cross(w, inertia[0]), inertia[1], cross(self.moment, acceleration))
        return force, add(moment, gyroscopic, self.sum(self.twists, seconds, "twisted"))

    def row_bias(self, row: int, w: Vector, acceleration: Vector, angular: Vector) -> Any:
        """Generalised inertia force of a row at zero accelerations of the shapes [N]."""
        d, i = divmod(row, self.count)
        across, let = (w[2], w[1]), self.tape.let  # components of w about which a direction swings, and along it
        square = let(w[1] ** 2 + w[2] ** 2, f"{self.name}_spin_squared")
        swing = let(w[0] ** 2 + across[d] ** 2, f"{self.name}_swing_squared")
        mixed = [self._stiffened[d][i] * square, -self._weighed[d][i] * swing, self._lever[i] * w[0] * across[1 - d]]
        if len(self.directions) > 1:
            mixed += [self._weighed[1 - d][i] * w[1] * w[2], (-2, 2)[d] * self._weighed_rates[1 - d][i] * w[0]]
        return total(dot(self.pushes[row], acceleration), dot(self.twists[row], angular), *mixed)

    @cached_property
    def kinetic(self) -> Any:
        """Kinetic energy of the speeds alone [J]."""
        return self._both(self.u, self._weighed_rates) / 2
