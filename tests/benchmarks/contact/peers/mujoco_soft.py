"""MuJoCo: its soft law of contact, which none of the problems has, measured against its own limit of small steps; chains against the reference.

Stiffness and damping per mass are given directly (negative `solref`), as its pages on solver parameters explain, with a constant impedance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME, PACKAGE = "MuJoCo", "mujoco"
INTEGRATORS = ("Euler", "RK4", "implicit", "implicitfast")
DAMPING = 20.0  # 1/s
LIMIT = 1e-5  # s, a tenth of the smallest step that is measured
LARGEST = 12  # balls: the limit of more takes minutes


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return steps [s]."""
    if problem.kind == "chain":
        return dict.fromkeys(INTEGRATORS, decades(2, 5, 2))
    if problem.rows or problem.kind not in WORLDS or len(problem.start) > 2 * LARGEST:
        return {}
    return dict.fromkeys(INTEGRATORS, decades(2, 4, 3))


@cache
def limit(problem: Problem) -> Result | None:
    """Return the solution of the smallest step; None where no contact makes the physics differ."""
    return None if not problem.contacts else prepare(problem, "RK4", LIMIT)()


def balls(numbers: Any) -> tuple[str, slice]:
    """Return the bodies of a world, and which of its coordinates are compared."""
    surface = material(numbers, DAMPING)
    bodies = "".join(
        f'<body pos="{x} {y} {z}"><freejoint/><geom type="sphere" size="{numbers.radius}" mass="{numbers.mass}" {surface}/></body>'
        for x, y, z in numbers.places
    )
    return f'<geom type="plane" size="9 9 1" {surface}/>{bodies}', slice(2, None, 7)


def cradle(numbers: Any) -> tuple[str, slice]:
    """Return the bodies of a world, and which of its coordinates are compared."""
    surface = material(numbers, 1e-9)  # both numbers must be negative
    sphere = (
        f'<geom type="sphere" pos="0 0 {-numbers.length}" size="{numbers.radius}" mass="{numbers.mass}" {surface}/>'
    )
    bodies = "".join(
        f'<body pos="{i * numbers.pitch} 0 0"><joint type="hinge" axis="0 -1 0"/>{sphere}</body>'
        for i in range(numbers.spheres)
    )
    return bodies, slice(None)


def material(numbers: Any, damping: float) -> str:
    """Return attributes of a geometry: stiffness and damping per mass."""
    return f'solref="{-numbers.stiffness / numbers.mass} {-damping}" solimp="0.9 0.9 0.001" condim="1"'


def chain(numbers: Any) -> tuple[str, slice]:
    """Return the rods in the plane of x and z, and their angles against each other."""
    a, m = numbers.length, numbers.mass
    inertia = m * a * a / 12
    rod = f'<joint type="hinge" axis="0 -1 0"/><inertial pos="{a / 2} 0 0" mass="{m}" diaginertia="1e-9 {inertia} {inertia}"/>'
    bodies = "".join(f'<body pos="{a if i else 0} 0 0">{rod}' for i in range(numbers.links))
    return bodies + "</body>" * numbers.links, slice(None)


WORLDS: dict[str, Callable[[Any], tuple[str, slice]]] = {"balls": balls, "cradle": cradle, "chain": chain}


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the model is compiled before it."""
    import mujoco

    numbers = problem.physics
    world, coordinates = WORLDS[problem.kind](numbers)
    # every sample after a whole number of steps
    spacing = float(problem.grid[0])
    steps = max(1, round(spacing / setting))
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{spacing / steps!r}" integrator="{integrator}" gravity="0 0 {-numbers.gravity}"/>'
        f"<worldbody>{world}</worldbody></mujoco>"
    )
    data = mujoco.MjData(model)
    places = [round(t / spacing) for t in problem.times]

    def run() -> Result:
        mujoco.mj_resetData(model, data)
        if problem.kind == "cradle":
            data.qpos[:] = problem.start[: len(data.qpos)]
        states, at = [], 0
        for place in places:
            mujoco.mj_step(model, data, nstep=(place - at) * steps)
            at = place
            states.append(data.qpos[coordinates].copy())
        return Result(np.cumsum(states, axis=1) if problem.kind == "chain" else np.array(states))

    return run
