"""hertzwerk: `simulate` of a loaded model with a local tolerance, in CasADi's virtual machine and compiled; results are bitwise the same."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

from reference import scenes

NAME, PACKAGE = "hertzwerk", "hertzwerk"
METHODS = ("dopri5", "dop853")
COMPILED = 12  # contacts of the equations up to which models are compiled: more take minutes


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return tolerances; those of compiled runs are the same."""
    if problem.kind not in BUILDERS:
        return {}
    ways = ("", " compiled") if problem.contacts <= COMPILED else ("",)
    return {f"{m}{how}": decades(1, 12, 1) for how in ways for m in METHODS}


def balls(problem: Problem) -> tuple[Any, list[str]]:
    """Return the scene and the histories that are compared."""
    if len(problem.physics.places) == 1:
        return ball(problem.physics), ["vertical.travel"]
    return scenes.falling_balls(len(problem.physics.places)), [
        f"flight_{i}.z" for i in range(len(problem.physics.places))
    ]


def ball(numbers: Any) -> Any:
    from hertzwerk.derive import (
        GROUND,
        Body,
        Contact,
        Gravity,
        Mechanism,
        Parameter,
        Prismatic,
        Scales,
        Scene,
        SphereOnPlane,
        Start,
        Z,
    )
    from hertzwerk.derive.laws import power, power_damping

    radius, stiffness = Parameter("radius", "m", numbers.radius), Parameter("stiffness", "N/m", numbers.stiffness)
    body = Body("ball", Parameter("mass", "kg", numbers.mass))
    plane = GROUND.at(0, 0, 0)
    ((*_, height),) = numbers.places
    return Scene(
        Mechanism(
            "falling_ball",
            (Prismatic("vertical", GROUND, body, axis=Z),),
            (SphereOnPlane("floor", body.at(0, 0, 0), radius, plane, normal=Z),),
        ),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", numbers.gravity), direction=-Z),
            Contact(
                "floor", power(stiffness, n=1), power_damping(Parameter("loss", "s/m", numbers.loss) * stiffness, 1)
            ),
        ),
        start=Start(position={"vertical": Parameter("height", "m", height)}),
        scales=Scales(length=radius / 10, speed=Parameter("pace", "m/s", 1)),
        summary="a ball falls onto a plane",
    )


def cradle(problem: Problem) -> tuple[Any, list[str]]:
    """Return the built-in cradle, whose numbers are those of the problem."""
    return "newtons_cradle", [f"string_{i}.angle" for i in range(problem.physics.spheres)]


BUILDERS: dict[str, Callable[[Problem], tuple[Any, list[str]]]] = {"balls": balls, "cradle": cradle}


LOADED: dict[str, tuple[Any, list[str]]] = {}


def loaded(problem: Problem) -> tuple[Any, list[str]]:
    from hertzwerk.runtime import load

    if problem.name not in LOADED:
        scene, histories = BUILDERS[problem.kind](problem)
        LOADED[problem.name] = load(scene), histories
    return LOADED[problem.name]


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the model is derived before it, and compiled by its first call."""
    from hertzwerk.runtime import simulate

    scene, histories = loaded(problem)
    method, *compiled = integrator.split()
    times = problem.times.tolist()

    def run() -> Result:
        found = simulate(
            scene,
            duration=times[-1],
            tolerance=setting,
            method=method,
            compiled=bool(compiled),
            grid=None,
        )
        if not found.outcome.finished:
            raise ArithmeticError(str(found.outcome))
        at = found.at(times)
        return Result(
            np.column_stack([at[name] for name in histories]), lambda: np.array([hit.t for hit in found.impacts])
        )

    return run
