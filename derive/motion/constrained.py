"""Motions of a tree corrected so that its loops stay closed: multipliers by G M^-1 G^T, in steps that refine each other.

Redundant constraints and singular positions leave G M^-1 G^T singular, so a small part of its diagonal is added to it. What that leaves open is
measured on the corrected motion itself and corrected again. The part is a constant of each constraint, its softness: a run that makes it huge
takes the constraint out, as it does, step by step, with what others say already.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import sympy as sp

from hertzwerk.derive.dimension.dimension import ONE
from hertzwerk.derive.motion.loops import Constraint
from hertzwerk.derive.program.elimination import Factor, least_fill
from hertzwerk.derive.program.program import CONSTANT, Tape

REGULAR = 3e-9  # of the diagonal of G M^-1 G^T: what is added where nothing is taken out


class Loops:
    """The constraints of a mechanism on its mass matrix."""

    def __init__(self, tape: Tape, constraints: tuple[Constraint, ...], mass: Factor) -> None:
        self._tape, self._constraints, self._mass = tape, constraints, mass
        self._names = [constraint.name.replace(".", "_") for constraint in constraints]
        each = list(zip(constraints, self._names, strict=True))
        self._through = [  # what a unit multiplier does to each speed: M^-1 G^T
            mass.solve({key: constraint.column.get(key, sp.S.Zero) for key in mass.names}, f"by_{name}")
            for constraint, name in each
        ]
        matrix: dict[tuple[str, str], Any] = {}
        for i, (constraint, name) in enumerate(each):
            for other, through in zip(self._names[: i + 1], self._through, strict=False):
                value = tape.let(_seen(constraint, through), f"W_{name}_{other}")
                if value != 0:
                    matrix[name, other] = matrix[other, name] = value
        self._sizes: dict[str, Any] = {}
        order = least_fill(self._names, matrix)
        groups: dict[str, list[Any]] = {}
        for constraint, name in each:
            groups.setdefault(constraint.group, []).append(matrix.get((name, name), sp.S.Zero))
        for constraint, name in each:  # one alone may vanish in a singular position, its group does not
            size = tape.let(sp.Add(*groups[constraint.group]), f"{constraint.group.replace('.', '_')}_size")
            softness = tape.input(f"{name}_softness", CONSTANT, ONE)
            matrix[name, name] = tape.let(matrix.get((name, name), sp.S.Zero) + softness * size, f"W_{name}_raised")
            self._sizes[name] = size
        self._factor = Factor(tape, order, matrix)

    def independence(self) -> list[Any]:
        """What the constraints eliminated before leave of each one, over the size of its group: near a singular position a square."""
        left = self._factor.diagonal
        return [self._tape.let(left[name] / self._sizes[name], f"{name}_independence") for name in self._names]

    def corrected(
        self,
        motion: dict[str, Any],
        wanted: list[Any],
        label: str,
        refinements: int,
        lent: Mapping[str, Any] = MappingProxyType({}),
    ) -> tuple[dict[str, Any], list[Any]]:
        """Speeds or accelerations by row, least far from `motion` in kinetic energy, whose constraints are as `wanted`; and the multipliers.

        lent    by row, what the mass matrix has too much: accelerations are found as if what it takes to move it came on top of the forces
        """
        tape, names = self._tape, self._names
        multipliers = dict.fromkeys(names, sp.S.Zero)
        before = dict.fromkeys(motion, sp.S.Zero)
        for i in range(1 + refinements):
            if lent and i:
                given = {key: lent.get(key, sp.S.Zero) * (value - before[key]) for key, value in motion.items()}
                back = self._mass.solve(given, f"{label}_back")
                before = motion
                motion = {
                    key: tape.let(value + back[key], f"{key.replace('.', '_')}_{label}")
                    for key, value in motion.items()
                }
            left = {
                name: tape.let(value - _seen(constraint, motion), f"{name}_left")
                for constraint, name, value in zip(self._constraints, names, wanted, strict=True)
            }
            more = self._factor.solve(left, label)
            multipliers = {name: tape.let(multipliers[name] + more[name], f"{name}_{label}") for name in names}
            corrected = {}
            for key, value in motion.items():
                pushes = (more[name] * through[key] for name, through in zip(names, self._through, strict=True))
                corrected[key] = tape.let(value + sp.Add(*pushes), f"{key.replace('.', '_')}_{label}")
            motion = corrected
        return motion, list(multipliers.values())


def _seen(constraint: Constraint, motion: dict[str, Any]) -> Any:
    """A constraint's rate under a motion."""
    return sp.Add(*(entry * motion[key] for key, entry in constraint.column.items() if key in motion))
