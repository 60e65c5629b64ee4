"""Constraints of a scene: of joints that close loops, and of couplings.

The second derivative of a coupling's equation is exact: its derivatives by coordinates and time, times their rates.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from hertzwerk.derive.effects.couplings import LENGTH, Coupling
from hertzwerk.derive.effects.state_expression import T, states_in
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.motion.kinematics import Kinematics
from hertzwerk.derive.motion.links import Row
from hertzwerk.derive.motion.loops import Constraint, Measured, closing_constraints, measured


def constraints_of(kinematics: Kinematics) -> tuple[Constraint, ...]:
    """Constraints of a scene: of closing joints, in declared order, of their drives, of couplings.

    Raises InputError for a constraint that can never be met.
    """
    found = list(closing_constraints(kinematics))
    still = [constraint for constraint in found if constraint.rate == 0]
    never = [constraint for constraint in still if sp.expand(kinematics.tape.written_out(constraint.value)) != 0]
    if never:
        faults = [
            Fault(f"joint {constraint.group.split('.')[0]}", f"{constraint.name} = {constraint.value}, whatever the motion",
                  "0, or the loop stays open", "Give both points the same place across the plane of motion.")
            for constraint in never
        ]  # fmt: skip
        raise InputError(f"mechanism {kinematics.mechanism.name}", faults)
    found = [constraint for constraint in found if constraint.rate != 0 and constraint.value != 0]
    return (*found, *(_coupled(kinematics, coupling) for coupling in kinematics.scene.all(Coupling)))


def driving_rows(constraints: Iterable[Constraint]) -> list[Row]:
    """Rows of the couplings that time enters: what they are driven by, force times speed is their power."""
    return [
        Row(constraint.drives, "N" if constraint.unit == LENGTH else "N m", -constraint.by_time, sp.S.Zero, False)
        for constraint in constraints
        if constraint.by_time != 0
    ]


def _coupled(kinematics: Kinematics, coupling: Coupling) -> Constraint:
    """The constraint of a coupling; time is a coordinate of rate 1 that no force moves."""
    tape, name = kinematics.tape, coupling.constraint(kinematics.scene)
    time = Measured(kinematics.t, sp.S.One, sp.S.Zero, {})
    of = {symbol: measured(kinematics, symbol.joint) if symbol != T else time for symbol in states_in(coupling.zero)}
    here = {symbol: state.value for symbol, state in of.items()}

    def let(expression: Any, what: str) -> Any:
        return tape.let(expression, f"{name.replace('.', '_')}_{what}")

    slopes = {symbol: sp.diff(coupling.zero, symbol) for symbol in of}
    partial = {
        symbol: let(slope.xreplace(here), f"by_{symbol.joint or 'time'}".replace(".", "_"))
        for symbol, slope in slopes.items()
    }
    bent = [
        sp.diff(slope, other).xreplace(here) * of[one].rate * of[other].rate
        for one, slope in slopes.items()
        for other in of
    ]
    column: dict[str, Any] = {}
    for symbol, state in of.items():
        for row, share in state.column.items():
            column[row] = column.get(row, sp.S.Zero) + partial[symbol] * share
    by_time = partial.get(T, sp.S.Zero)
    return Constraint(
        name,
        coupling.unit(kinematics.scene),
        name,
        let(coupling.zero.xreplace(here), "left"),
        let(sp.Add(*(partial[symbol] * state.rate for symbol, state in of.items())), "rate"),
        let(sp.Add(*bent, *(partial[symbol] * state.bias for symbol, state in of.items())), "bias"),
        {row: let(share, f"on_{row.replace('.', '_')}") for row, share in column.items() if share != 0},
        name if by_time != 0 else "",
        by_time,
    )  # fmt: skip
