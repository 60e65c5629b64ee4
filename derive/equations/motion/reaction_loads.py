"""Loads by reactions of joints, such as friction of bearings, solved with the accelerations.

A reaction R depends on the accelerations, and these on the load that depends on R. Loads are linear in the magnitudes
N = |R| that they read, and R is linear in the loads, so that N = |R0 + B N|, with R0 the reactions without such loads
and B their response to each: alone a quadratic equation, several by Newton's method. Where I - P, with P of the magnitudes of the entries of B, has
positive pivots, it is an M-matrix: P has a spectral radius below 1, and N exists and is unique (the map contracts).
With one load this bound is sharp: beyond it there is none, or there are two (Painleve 1895), and a guide locks itself.
A run that gets there reports it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.declare.effects.effect import FRONT, RADIAL, REAR
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.equations.motion.equations_of_motion import Equations
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, cross, dot, scale, sub
from hertzwerk.derive.program.program import symbols_in

ITERATIONS = 8  # of Newton's method, which converges from below, quadratically: enough up to |B| = 0.98


@dataclass(frozen=True)
class Solved:
    """Accelerations, multipliers and generalised forces with the loads, and N.

    Margins are positive where N is unique; residuals are what its solution leaves, relative. `unloaded` are the accelerations
    without loads by N, and `parts` the components of each reaction then: linear in the forces.
    """

    accelerations: list[Any]
    multipliers: list[Any]
    forces: dict[str, Any]
    magnitudes: list[Any]
    margins: list[Any]
    residuals: list[Any]
    unloaded: list[Any]
    parts: list[Vector]


class Carried:
    """Loads of one scene by reactions: generalised forces by row, in which these are inputs of the tape."""

    def __init__(self, kinematics: Kinematics, equations: Equations, loads: Mapping[str, Any]) -> None:
        self.kin, self.tape, self.equations = kinematics, kinematics.tape, equations
        self.loads = loads
        self.read = {symbol: key for key, symbol in kinematics.carried.items()}
        self._slopes: dict[tuple[Any, Any], Any] = {}

    def require_linear(self) -> None:
        """Raise InputError for a joint whose reaction enters a load other than linearly."""
        for symbol, (joint, *_) in self.read.items():
            slopes = [self._slope(load, symbol) for load in self.loads.values()]
            if any(self._depends(slope, other) for slope in slopes for other in self.read):
                fault = Fault(f"reaction of joint {joint}", "a load that depends on it other than linearly",
                              "loads proportional to it: those of smooth_coulomb, threlfall, ambrosio, stribeck, bengisu_akay",
                              "Where friction grows otherwise, declare the normal force.")  # fmt: skip
                raise InputError(f"joint {joint}", [fault])

    def solved(self, forces: Mapping[str, Any], pressed: Mapping[Any, Any]) -> Solved:
        """Solve the equations of motion for given forces by row, and for normal forces of contacts by symbol."""
        tape, equations = self.tape, self.equations
        still = {**dict.fromkeys(self.read, sp.S.Zero), **pressed}
        names = [symbol.name for symbol in self.read]
        known = {
            row: tape.let(
                force + self._replaced(self.loads.get(row, sp.S.Zero), still), f"{row.replace('.', '_')}_known"
            )
            for row, force in forces.items()
        }
        columns = [
            {row: self._replaced(self._slope(load, symbol), still) for row, load in self.loads.items()}
            for symbol in self.read
        ]
        a, multipliers = equations.accelerations(known)
        of = [equations.response(column, f"by_{name}") for column, name in zip(columns, names, strict=True)]
        base, by, parts = [], [], []
        for key in self.read.values():
            whole = self._parts(key, known, a, multipliers, whole=True)
            shares = [self._parts(key, c, *response, whole=False) for c, response in zip(columns, of, strict=True)]
            parts.append(whole)
            axes = [k for k in range(3) if any(vector[k] != 0 for vector in (whole, *shares))]
            base.append([whole[k] for k in axes])
            by.append([[share[k] for k in axes] for share in shares])
        magnitudes, residuals = self._magnitudes(base, by, names)

        def total(first: Any, shares: Sequence[Any], name: str) -> Any:
            return tape.let(sp.Add(first, *(x * n for x, n in zip(shares, magnitudes, strict=True))), name)

        return Solved(
            [total(x, [r[0][i] for r in of], f"loaded_acceleration_{i + 1}") for i, x in enumerate(a)],
            [total(x, [r[1][i] for r in of], f"loaded_multiplier_{i + 1}") for i, x in enumerate(multipliers)],
            {row: total(f, [c.get(row, sp.S.Zero) for c in columns], f"{row.replace('.', '_')}_loaded") for row, f in known.items()},
            magnitudes,
            self._margins(by, names),
            residuals,
            a,
            parts,
        )  # fmt: skip

    # -- reactions -----------------------------------------------------------------------------------------------------

    def _parts(
        self, key: tuple[str, str, Any], forces: Mapping[str, Any], a: list[Any], multipliers: list[Any], *, whole: bool
    ) -> Vector:
        """Components of a reaction; without `whole`, of what given forces and motion add to it."""
        name, part, length = key
        joint = next(joint for joint in self.kin.mechanism.joints if joint.name == name)
        force, moment, axis = (self._of_rows if name in self.kin.tree.held else self._of_constraints)(
            joint, forces, a, multipliers, whole
        )
        if part == RADIAL:
            force = sub(force, scale(dot(force, axis), axis))
        elif part in (FRONT, REAR):
            sign = 1 if part == FRONT else -1
            force = add(scale(sp.Rational(1, 2), force), scale(sign / sp.sympify(length), cross(moment, axis)))
        label = f"{name}_{part}".replace(" ", "_")
        return self.tape.vector(force, label if whole else f"{label}_response")

    def _of_rows(
        self, joint: Joint, forces: Mapping[str, Any], a: list[Any], multipliers: list[Any], whole: bool
    ) -> tuple[Vector, Vector, Vector]:
        """Force and moment on the child of a joint of the tree, and its axis, in the joint's axes."""
        equations, held = self.equations, self.kin.tree.held[joint.name]

        def along(rows: Sequence[tuple[Any, Any]]) -> Vector:
            total = ZERO
            for direction, row in rows:
                rest = (equations.bias(row) if whole else sp.S.Zero) - forces.get(row.key, sp.S.Zero)
                needed = equations.needed(row, a, multipliers, rest)
                total = add(total, scale(self.tape.let(needed, f"{row.key.replace('.', '_')}_by"), direction.unit))
            return total

        return along(held.slides), along(held.turns), ZERO if joint.main_axis is None else joint.main_axis.unit

    def _of_constraints(
        self, joint: Joint, forces: Mapping[str, Any], a: list[Any], multipliers: list[Any], whole: bool
    ) -> tuple[Vector, Vector, Vector]:
        """Force and moment on the child of a joint that closes a loop, and its axis, in ground axes."""
        pairs = zip(self.equations.constraints, multipliers, strict=True)
        own = [(row, held) for row, held in pairs if row.name.split(".")[0] == joint.name]
        force = add(ZERO, *(scale(held, row.force) for row, held in own))
        moment = add(ZERO, *(scale(held, row.moment) for row, held in own))
        return force, moment, ZERO if joint.main_axis is None else self.kin.direction(joint.parent, joint.main_axis)

    # -- magnitudes ----------------------------------------------------------------------------------------------------

    def _magnitudes(
        self, base: list[list[Any]], by: list[list[list[Any]]], names: list[str]
    ) -> tuple[list[Any], list[Any]]:
        """N by Newton's method, and what remains of each equation, relative."""
        tape, count = self.tape, range(len(base))

        def sizes(n: Sequence[Any], label: str) -> list[tuple[Any, list[Any]]]:
            """Magnitude of each reaction, and its derivatives."""
            entries = []
            for i in count:
                parts = [
                    tape.let(sp.Add(r, *(share[k] * x for share, x in zip(by[i], n, strict=True))), label)
                    for k, r in enumerate(base[i])
                ]
                size, unit = self._norm(parts, names[i])
                slopes = [sp.Add(*(u * x for u, x in zip(unit, share, strict=True))) for share in by[i]]
                entries.append((size, [tape.let(slope, f"{names[i]}_slope") for slope in slopes]))
            return entries

        if len(base) == 1:
            return [self._alone(base[0], by[0][0], names[0])], [sp.S.Zero]
        n = [size for size, _ in sizes([sp.S.Zero] * len(base), "unloaded")]
        if all(not any(share) for row in by for share in row):
            return n, [sp.S.Zero] * len(base)
        for _ in range(ITERATIONS):
            at = sizes(n, "loaded")
            matrix = [[int(i == j) - at[i][1][j] for j in count] for i in count]
            steps = self._eliminated(matrix, [at[i][0] - n[i] for i in count], "newton")[1]
            n = [tape.let(n[i] + steps[i], names[i]) for i in count]
        left = [(size, n[i]) for i, (size, _) in enumerate(sizes(n, "loaded"))]
        return n, [
            tape.let((size - x) / (sp.Abs(x) + self._small), f"{names[i]}_left") for i, (size, x) in enumerate(left)
        ]

    def _alone(self, base: list[Any], by: list[Any], name: str) -> Any:
        """The positive root of n^2 = |base + by n|^2, which is one where |by| < 1."""
        tape, r, b = self.tape, base, by
        if not any(b):
            return self._norm(r, name)[0]
        whole, mixed = (
            tape.let(sp.Add(*(x * y for x, y in zip(r, s, strict=True))), f"{name}_{w}")
            for s, w in ((r, "squared"), (b, "fed_back"))
        )
        rest = tape.let(1 - sp.Add(*(x**2 for x in b)), f"{name}_rest")
        square = tape.let(mixed**2 + rest * whole, f"{name}_discriminant")
        root = sp.sqrt(Where(square > 0, square, self._small**2))
        return tape.let((mixed + Where(square > 0, root, 0)) / rest, name)

    def _norm(self, parts: list[Any], name: str) -> tuple[Any, list[Any]]:
        """Magnitude of a vector and the derivatives by its components, zero at zero."""
        if len(parts) < 2:
            return (sp.S.Zero, []) if not parts else (self.tape.let(sp.Abs(parts[0]), name), [sp.sign(parts[0])])
        square = self.tape.let(sp.Add(*(x**2 for x in parts)), f"{name}_squared")
        root = self.tape.let(sp.sqrt(Where(square > 0, square, self._small**2)), f"{name}_root")
        return self.tape.let(Where(square > 0, root, 0), name), [x / root for x in parts]

    @cached_property
    def _small(self) -> Any:
        """A force of no account [N]."""
        scales, mass = self.kin.scene.scales, self.kin.scene.mechanism.total_mass
        return self.tape.let(1e-9 * mass * sp.sympify(scales.speed) ** 2 / sp.sympify(scales.length), "small_force")

    def _margins(self, by: list[list[list[Any]]], names: list[str]) -> list[Any]:
        """Pivots of I - P, all positive where the magnitudes exist and are unique."""
        matrix = [
            [
                int(i == j) - (sp.Abs(share[0]) if len(share) == 1 else sp.sqrt(sp.Add(*(x**2 for x in share))))
                for j, share in enumerate(row)
            ]
            for i, row in enumerate(by)
        ]
        return self._eliminated(matrix, [sp.S.Zero] * len(by), "margin")[0]

    def _eliminated(self, matrix: list[list[Any]], right: list[Any], name: str) -> tuple[list[Any], list[Any]]:
        """Pivots and solution by elimination without exchanges: an H-matrix needs none."""
        tape, n = self.tape, len(matrix)
        a = [[tape.let(x, name) for x in row] for row in matrix]
        r = list(right)
        for k in range(n):
            for i in range(k + 1, n):
                if a[i][k] != 0:
                    factor = tape.let(a[i][k] / a[k][k], name)
                    a[i] = [*a[i][: k + 1], *(tape.let(a[i][j] - factor * a[k][j], name) for j in range(k + 1, n))]
                    r[i] = tape.let(r[i] - factor * r[k], name)
        x = [sp.S.Zero] * n
        for k in reversed(range(n)):
            x[k] = tape.let((r[k] - sp.Add(*(a[k][j] * x[j] for j in range(k + 1, n)))) / a[k][k], name)
        return [sp.sympify(a[k][k]) for k in range(n)], x

    # -- loads ---------------------------------------------------------------------------------------------------------

    def _depends(self, expression: Any, symbol: Any) -> bool:
        """Whether an expression on the tape depends on an input."""
        return any(
            s == symbol or (s in self.tape.assignments and self._depends(self.tape.assignments[s], symbol))
            for s in symbols_in(expression)
            if self.tape.depends_on(s, "reactions")
        )

    def _slope(self, expression: Any, symbol: Any) -> Any:
        """Derivative of an expression on the tape by an input, through its assignments."""
        if expression == symbol:
            return sp.S.One
        key = (expression, symbol)
        if key not in self._slopes:
            expression = sp.sympify(expression)
            inner = self.tape.assignments.get(expression, expression)
            moving = [s for s in symbols_in(inner) if self.tape.depends_on(s, "reactions")]
            terms = [sp.diff(inner, s) * self._slope(s, symbol) for s in moving if self._depends(s, symbol)]
            self._slopes[key] = self.tape.let(sp.Add(*terms), f"{symbol.name}_load")
        return self._slopes[key]

    def _replaced(self, expression: Any, values: Mapping[Any, Any]) -> Any:
        """An expression on the tape with inputs replaced, in its assignments too."""
        expression = sp.sympify(expression)
        moving = [s for s in symbols_in(expression) if self.tape.depends_on(s, "reactions")]
        instead = {s: values[s] if s in values else self._replaced(self.tape.assignments[s], values) for s in moving}
        return self.tape.let(expression.xreplace(instead), "known_load") if instead else expression
