"""Motion of a tree with closed loops: multipliers by G M^-1 G^T, with iterative refinement.

Redundant constraints and singular positions leave G M^-1 G^T singular, so a small fraction of its diagonal is added
to it. The remaining error is measured on the corrected motion and corrected again. The fraction is a constant of each
constraint, its softness: a run removes a constraint by making it huge, as it does, step by step, with redundant
constraints.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import sympy as sp

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.equations.motion.articulated_bodies import Articulated
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.expressions.dimension.dimension import ONE
from hertzwerk.derive.program.elimination import Factor, minimum_degree_order
from hertzwerk.derive.program.program import CONSTANT, Tape

SOFTNESS = 3e-9  # softness of a constraint that is kept: fraction of the diagonal of G M^-1 G^T that is added


class Loops:
    """Constraints of a mechanism with its factored mass matrix."""

    def __init__(self, tape: Tape, constraints: tuple[Constraint, ...], mass: Factor | Articulated) -> None:
        self._tape, self._constraints, self._mass = tape, constraints, mass
        self._names = [constraint.name.replace(".", "_") for constraint in constraints]
        each = list(zip(constraints, self._names, strict=True))
        responses = (
            mass.solve({key: constraint.column.get(key, sp.S.Zero) for key in mass.names}, f"by_{name}")
            for constraint, name in each
        )
        # M^-1 G^T: by constraint, the responses to a unit multiplier of the speeds that have one
        self._through = [{key: value for key, value in one.items() if value != 0} for one in responses]
        matrix: dict[tuple[str, str], Any] = {}
        moved: dict[str, list[int]] = {}  # by speed, the constraints whose multiplier changes it
        for j, through in enumerate(self._through):
            for key in through:
                moved.setdefault(key, []).append(j)
        for i, (constraint, name) in enumerate(each):
            for j in sorted({j for key in constraint.column for j in moved.get(key, ()) if j <= i}):
                other = self._names[j]
                value = tape.let(_constraint_rate(constraint, self._through[j]), f"W_{name}_{other}")
                if value != 0:
                    matrix[name, other] = matrix[other, name] = value
        self._sizes: dict[str, Any] = {}
        order = minimum_degree_order(self._names, matrix)
        groups = grouped((constraint.group, matrix.get((name, name), sp.S.Zero)) for constraint, name in each)
        for constraint, name in each:  # a single one may vanish in a singular position, its group does not
            size = tape.let(sp.Add(*groups[constraint.group]), f"{constraint.group.replace('.', '_')}_size")
            softness = tape.input(f"{name}_softness", CONSTANT, ONE)
            matrix[name, name] = tape.let(matrix.get((name, name), sp.S.Zero) + softness * size, f"W_{name}_raised")
            self._sizes[name] = size
        self._factor = Factor(tape, order, matrix)

    def independence(self) -> list[Any]:
        """Pivot of each constraint after elimination of those before it, relative to the size of its group.

        Near a singular position it is of second order.
        """
        pivots = self._factor.diagonal
        return [self._tape.let(pivots[name] / self._sizes[name], f"{name}_independence") for name in self._names]

    def corrected(
        self,
        motion: dict[str, Any],
        wanted: list[Any],
        label: str,
        refinements: int,
        artificial: Mapping[str, Any] = MappingProxyType({}),
    ) -> tuple[dict[str, Any], list[Any]]:
        """Motion closest to `motion` in kinetic energy that satisfies the constraints, and the multipliers.

        Speeds or accelerations by row, with the constraints' rates as `wanted`.

        artificial  by row, the artificial part of the mass matrix: the forces that accelerate it are added, so that it has no effect
        """
        tape, names = self._tape, self._names
        multipliers = dict.fromkeys(names, sp.S.Zero)
        before = dict.fromkeys(motion, sp.S.Zero)
        for i in range(1 + refinements):
            if artificial and i:
                forces = {key: artificial.get(key, sp.S.Zero) * (value - before[key]) for key, value in motion.items()}
                back = self._mass.solve(forces, f"{label}_back")
                before = motion
                motion = {
                    key: tape.let(value + back[key], f"{key.replace('.', '_')}_{label}")
                    for key, value in motion.items()
                }
            residuals = {
                name: tape.let(value - _constraint_rate(constraint, motion), f"{name}_left")
                for constraint, name, value in zip(self._constraints, names, wanted, strict=True)
            }
            corrections = self._factor.solve(residuals, label)
            multipliers = {name: tape.let(multipliers[name] + corrections[name], f"{name}_{label}") for name in names}
            pushes: dict[str, list[Any]] = {key: [] for key in motion}
            for name, through in zip(names, self._through, strict=True):
                for key, response in through.items():
                    pushes[key].append(corrections[name] * response)
            motion = {
                key: tape.let(value + sp.Add(*pushes[key]), f"{key.replace('.', '_')}_{label}")
                for key, value in motion.items()
            }
        return motion, list(multipliers.values())


def _constraint_rate(constraint: Constraint, motion: dict[str, Any]) -> Any:
    """Rate of a constraint for a given motion."""
    return sp.Add(*(entry * motion[key] for key, entry in constraint.column.items() if key in motion))
