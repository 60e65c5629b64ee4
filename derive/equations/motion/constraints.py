"""Constraints of a scene: of joints that close loops, couplings, and what rolls or has an edge.

The second derivative of a coupling's equation is exact: its derivatives by coordinates and time, times their rates.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from math import inf
from typing import Any

import sympy as sp
from mpmath import mp  # SymPy brings it

from hertzwerk.derive.audit.numeric import DIGITS
from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.declare.effects.couplings import LENGTH, Coupling
from hertzwerk.derive.declare.effects.effect import SpeedConstraint
from hertzwerk.derive.declare.effects.state_expression import T, states_in
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.loop_closure import Constraint, Measured, closing_constraints, measured
from hertzwerk.derive.equations.motion.probe import STATES, UNDEFINED, Probe
from hertzwerk.derive.equations.motion.spanning_tree import Row
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, cross, dot, sub

ZERO = 1e-15  # SI: what is smaller, evaluated with 40 digits, cancels
ON_SPEED = "m/s"  # unit of a constraint on a speed, which has no integral


def constraints_of(kinematics: Kinematics) -> tuple[Constraint, ...]:
    """Constraints of a scene: of closing joints, of their drives, of couplings, on speeds, in order.

    Raises InputError for a constraint that can never be met.
    """
    constraints = list(closing_constraints(kinematics))
    still = [constraint for constraint in constraints if constraint.rate == 0]
    never = [
        (constraint, f"= {constraint.value}")
        for constraint in still
        if sp.expand(kinematics.tape.written_out(constraint.value)) != 0
    ]
    moving = [constraint for constraint in constraints if constraint.rate != 0 and constraint.value != 0]
    largest = list(zip(moving, *_largest(kinematics, moving), strict=True))
    never += [(constraint, "other than 0") for constraint, rate, value in largest if rate <= ZERO < value]
    if never:
        faults = [
            Fault(f"joint {constraint.group.split('.')[0]}", f"{constraint.name} {value}, whatever the motion",
                  "0, or the loop stays open", "Give both points the same place across the plane of motion.")
            for constraint, value in never
        ]  # fmt: skip
        raise InputError(f"mechanism {kinematics.mechanism.name}", faults)
    constraints = [constraint for constraint, rate, _ in largest if rate > ZERO]
    constraints += [] if kinematics.by_expressions is None else kinematics.by_expressions.constraints
    constraints += [_coupled(kinematics, coupling) for coupling in kinematics.scene.all(Coupling)]
    for effect in kinematics.scene.effects:
        on_speeds = (_on_speeds(kinematics, effect.name, c) for c in effect.speed_constraints(kinematics))
        constraints += [constraint for constraint in on_speeds if constraint.rate != 0]
    return tuple(constraints)


def _largest(kinematics: Kinematics, constraints: list[Constraint]) -> tuple[list[float], list[float]]:
    """Largest rate and value of each constraint at random states and parameters; infinite if undefined.

    A constraint that every motion fulfils vanishes by structure in the coordinate planes. Along an axis that
    parameters tilt only its terms cancel: cos(tilt) sin(tilt) - sin(tilt) cos(tilt).
    """
    count, probe = len(constraints), Probe(kinematics, kinematics.scene.size)
    if not constraints:
        return [], []
    wanted = [*(constraint.rate for constraint in constraints), *(constraint.value for constraint in constraints)]
    try:
        with mp.workdps(DIGITS):
            states = [probe.values(wanted, state) for state in islice(probe.states(parameters=True), STATES)]
    except UNDEFINED:
        if count == 1:  # structure decides
            return [inf], [inf]
        alone = [_largest(kinematics, [constraint]) for constraint in constraints]
        return [rate for (rate,), _ in alone], [value for _, (value,) in alone]
    largest = [max(map(abs, column)) for column in zip(*states, strict=True)]
    return largest[:count], largest[count:]


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

    def let(expression: Any, label: str) -> Any:
        return tape.let(expression, f"{name.replace('.', '_')}_{label}")

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


def _on_speeds(kinematics: Kinematics, effect: str, constraint: SpeedConstraint) -> Constraint:
    """Constraint of a velocity between material points of two bodies at a place that moves in both."""
    tape, name, motions = (
        kinematics.tape,
        f"{effect}_{constraint.name}",
        [kinematics.motion(body) for body in constraint.bodies],
    )

    def rates(vector: Vector, label: str) -> Vector:
        return tuple(tape.rate(part, f"{name}_{label}_{axis}") for part, axis in zip(vector, "xyz", strict=True))

    moved = rates(constraint.position, "place_rate")
    velocity = sub(*(kinematics.velocity_at(body, constraint.position) for body in constraint.bodies))
    biases = []
    for body, motion in zip(constraint.bodies, motions, strict=True):
        alpha, bias = kinematics.bias_of(kinematics.link_of(body))
        turned = cross(motion.angular_velocity, sub(moved, motion.velocity))
        biases.append(add(bias, cross(alpha, sub(constraint.position, motion.origin)), turned))
    velocity, bias = tape.vector(velocity, f"{name}_velocity"), tape.vector(sub(*biases), f"{name}_apart_bias")
    turning = dot(rates(constraint.direction, "direction_rate"), velocity)
    column = kinematics.generalised(constraint.direction, constraint.position, *constraint.bodies, name)
    return Constraint(
        f"{effect}.{constraint.name}",
        ON_SPEED if constraint.distance is None else LENGTH,
        f"{effect}.{constraint.name}",
        sp.S.Zero if constraint.distance is None else constraint.distance,
        tape.let(dot(constraint.direction, velocity), f"{name}_rate"),
        tape.let(dot(constraint.direction, bias) + turning, f"{name}_bias"),
        {row: share for row, share in column.items() if share != 0},
    )
