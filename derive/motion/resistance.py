"""Motions that no mass resists: axes that coincide, or cancel, with nothing but massless bodies between them.

What is wrong then is the mechanism, not a number: the mass matrix is singular in every position. It is tried at a random one, at the defaults.
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

SINGULAR = 1e-10  # what elimination leaves of a diagonal entry, as a part of it, that counts as nothing


def resistance_faults(scene: Scene) -> Iterator[Fault]:
    """One for each motion of the free joints that moves no mass. Only massless bodies make any, so a scene without them costs nothing here.

    Absolute coordinates can do with bodies without an inertia too as long as the joints' coordinates can, which are what is tried.
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
    inertia = body.inertia if isinstance(body.inertia, tuple) else (body.inertia,)
    return all(default_value(value) != 0 for value in (body.mass, *inertia))


def _mass_matrix(scene: Scene) -> tuple[list[str], list[list[float]]]:
    """Of the free freedoms, in numbers, on a tape of its own; and what they are called."""
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
    """Of a positive semidefinite matrix: the entries of each that are not zero."""
    count = len(matrix)
    left = [row[:] for row in matrix]
    lower: list[list[float]] = [[0.0] * count for _ in matrix]
    for k in range(count):
        pivot = left[k][k]
        if not pivot > SINGULAR * matrix[k][k]:
            vector = [0.0] * count
            vector[k] = 1.0
            for i in reversed(range(k)):
                vector[i] = -sum(lower[j][i] * vector[j] for j in range(i + 1, k + 1))
            yield [i for i in range(k + 1) if vector[i] ** 2 * matrix[i][i] > SINGULAR * matrix[k][k] or i == k]
            continue
        for i in range(k + 1, count):
            lower[i][k] = left[i][k] / pivot
            for j in range(k + 1, count):
                left[i][j] -= lower[i][k] * left[k][j]
