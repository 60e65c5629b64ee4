"""Motions without inertia: bodies without mass or inertia that neither a mass nor a closed loop holds.

The fault is in the mechanism: its mass matrix is singular on the motions that the constraints allow, in every position.
It is tested at a random position, with parameters at their defaults.
"""

from __future__ import annotations

from collections.abc import Iterator
from operator import mul

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.absolute_coordinates import Absolute
from hertzwerk.derive.equations.motion.equations_of_motion import equations_of
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.probe import Probe
from hertzwerk.derive.expressions.parameter import default_value
from hertzwerk.derive.program.program import Tape

SINGULAR = 1e-10  # pivot relative to the diagonal entry that counts as zero
ROUNDING = 1e-12
SMALL = 1e-6  # share of a motion that counts as rounding


def resistance_faults(scene: Scene) -> Iterator[Fault]:
    """Yield a fault for each motion of the free joints without inertia.

    Only bodies without mass, or turned ones without inertia, allow such motions, so other scenes skip the test. In
    absolute coordinates bodies without inertia are allowed if joint coordinates allow them, which are tested.
    """
    mechanism = scene.mechanism
    massless = [
        body.name
        for body in mechanism.bodies
        if default_value(body.mass) == 0
        or (
            mechanism.tree
            and mechanism.turned_by(body) is not None
            and not any(default_value(value) for value in body.moments)
        )
    ]
    if isinstance(scene, Absolute):
        scene = scene.declared
        massless = [b.name for b in scene.mechanism.bodies if any(default_value(v) == 0 for v in (b.mass, *b.moments))]
    if not massless:
        return
    names, matrix, constraints = _mass_matrix(scene)
    for motion in _free_of(_null_vectors(matrix), constraints):
        moved = [names[i] for i, share in enumerate(motion) if abs(share) > SMALL * max(map(abs, motion))]
        joints = list(dict.fromkeys(name.split(".")[0] for name in moved))
        several = len(moved) > 1
        yield Fault(
            f"joint{'s' if len(joints) > 1 else ''} {' and '.join(joints)}",
            f"{'axes that coincide: ' if several and not constraints else ''}{' and '.join(moved)} {'together move' if several else 'moves'} no mass",
            f"a mass that every motion moves{', where the loops leave it free' if constraints else ''}; without one: {', '.join(massless)}",
            f"Leave one of the joints out, turn its axis, or give {' or '.join(massless)} a mass and an inertia.",
        )


def _mass_matrix(scene: Scene) -> tuple[list[str], list[list[float]], list[list[float]]]:
    """Names of the free rows, mass matrix and constraints' rows in numbers."""
    tape = Tape()
    for parameter, dimension in scene.dimensions.items():
        tape.input(parameter.name, "p", dimension, symbol=parameter)
    kin = Kinematics(tape, scene)
    equations = equations_of(kin, scene)
    entries, rows = equations.mass_matrix(), [row.key for row in equations.free]
    probe = Probe(kin, scene.size)
    state = next(probe.states())
    values = dict(zip(entries, probe.values(list(entries.values()), state), strict=True))
    columns = [[constraint.column.get(row, 0) for row in rows] for constraint in equations.constraints]
    matrix = [[values.get((row, other), 0.0) for other in rows] for row in rows]
    return rows, matrix, [probe.values(column, state) for column in columns]


def _free_of(motions: list[list[float]], constraints: list[list[float]]) -> list[list[float]]:
    """Combinations of motions that every constraint allows."""
    if not constraints:
        return motions
    rates = [[_rate(constraint, motion) for motion in motions] for constraint in constraints]
    squares = [[sum(rate[i] * rate[k] for rate in rates) for k in range(len(motions))] for i in range(len(motions))]
    shares = _null_vectors(squares)
    return [[sum(map(mul, share, column)) for column in zip(*motions, strict=True)] for share in shares]


def _rate(constraint: list[float], motion: list[float]) -> float:
    """Rate of a constraint by a motion; 0 where it is rounding."""
    rate = sum(map(mul, constraint, motion))
    return rate if abs(rate) > ROUNDING * max(map(abs, constraint)) * max(map(abs, motion)) else 0.0


def _null_vectors(matrix: list[list[float]]) -> list[list[float]]:
    """Null vectors of a positive semidefinite matrix."""
    count = len(matrix)
    remainder = [row[:] for row in matrix]
    lower: list[list[float]] = [[0.0] * count for _ in matrix]
    vectors = []
    for k in range(count):
        pivot = remainder[k][k]
        if not pivot > SINGULAR * matrix[k][k]:
            vector = [0.0] * count
            vector[k] = 1.0
            for i in reversed(range(k)):
                vector[i] = -sum(lower[j][i] * vector[j] for j in range(i + 1, k + 1))
            vectors.append(vector)
            continue
        for i in range(k + 1, count):
            lower[i][k] = remainder[i][k] / pivot
            for j in range(k + 1, count):
                remainder[i][j] -= lower[i][k] * remainder[k][j]
    return vectors
