"""Motions without inertia: axes that coincide or cancel, with only massless bodies between them.

The fault is in the mechanism: its mass matrix is singular in every position. It is tested at a random position, with
parameters at their defaults.
"""

from __future__ import annotations

from collections.abc import Iterator

from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.bodies import Body
from hertzwerk.derive.mechanism.parameter import default_value
from hertzwerk.derive.motion.absolute import Absolute
from hertzwerk.derive.motion.equations import Equations
from hertzwerk.derive.motion.kinematics import Kinematics
from hertzwerk.derive.motion.probe import Probe
from hertzwerk.derive.program.program import Tape

SINGULAR = 1e-10  # pivot relative to the diagonal entry that counts as zero


def resistance_faults(scene: Scene) -> Iterator[Fault]:
    """Yield a fault for each motion of the free joints without inertia.

    Only massless bodies allow such motions, so other scenes skip the test. In absolute coordinates bodies without
    inertia are allowed if joint coordinates allow them, which are tested.
    """
    massless = [body.name for body in scene.mechanism.bodies if default_value(body.mass) == 0]
    if isinstance(scene, Absolute):
        scene = scene.declared
        massless = [body.name for body in scene.mechanism.bodies if not _is_whole(body)]
    if not massless:
        return
    names, matrix = _mass_matrix(scene)
    for motion in _null_vectors(matrix):
        joints = list(dict.fromkeys(names[i].split(".")[0] for i in motion))
        several = len(motion) > 1
        yield Fault(
            f"joint{'s' if len(joints) > 1 else ''} {' and '.join(joints)}",
            f"{'axes that coincide: ' if several else ''}{' and '.join(names[i] for i in motion)} {'together move' if several else 'moves'} no mass",
            f"a mass that every motion moves; without one: {', '.join(massless)}",
            f"Leave one of the joints out, turn its axis, or give {' or '.join(massless)} a mass and an inertia.",
        )


def _is_whole(body: Body) -> bool:
    """Whether a body has a mass, and an inertia about every axis."""
    return all(default_value(value) != 0 for value in (body.mass, *body.moments))


def _mass_matrix(scene: Scene) -> tuple[list[str], list[list[float]]]:
    """Names of the free rows, and the mass matrix in numbers."""
    tape = Tape()
    for parameter, dimension in scene.dimensions.items():
        tape.input(parameter.name, "p", dimension, symbol=parameter)
    kin = Kinematics(tape, scene)
    equations = Equations(kin, scene)
    entries, rows = equations.mass_matrix(), [row.key for row in equations.free]
    probe = Probe(kin, scene.size)
    values = dict(zip(entries, probe.values(list(entries.values()), next(probe.states())), strict=True))
    return rows, [[values.get((row, other), 0.0) for other in rows] for row in rows]


def _null_vectors(matrix: list[list[float]]) -> Iterator[list[int]]:
    """Yield the indices of the non-zero entries of each null vector of a positive semidefinite matrix."""
    count = len(matrix)
    remainder = [row[:] for row in matrix]
    lower: list[list[float]] = [[0.0] * count for _ in matrix]
    for k in range(count):
        pivot = remainder[k][k]
        if not pivot > SINGULAR * matrix[k][k]:
            vector = [0.0] * count
            vector[k] = 1.0
            for i in reversed(range(k)):
                vector[i] = -sum(lower[j][i] * vector[j] for j in range(i + 1, k + 1))
            yield [i for i in range(k + 1) if vector[i] ** 2 * matrix[i][i] > SINGULAR * matrix[k][k] or i == k]
            continue
        for i in range(k + 1, count):
            lower[i][k] = remainder[i][k] / pivot
            for j in range(k + 1, count):
                remainder[i][j] -= lower[i][k] * remainder[k][j]
