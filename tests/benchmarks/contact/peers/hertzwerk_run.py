"""hertzwerk: `simulate` of a loaded model with a local tolerance, in CasADi's virtual machine and compiled; results are bitwise the same."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

from reference import scenes

NAME, PACKAGE = "hertzwerk", "hertzwerk"
METHODS = ("dopri5", "dop853")
COMPILED = 12  # contacts of the equations and coordinates up to which models are compiled: more take minutes


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return tolerances; those of compiled runs are the same."""
    if problem.kind not in BUILDERS:
        return {}
    ways = ("", " compiled") if max(problem.contacts, problem.compared) <= COMPILED else ("",)
    return {f"{m}{how}": decades(1, 12, 1) for how in ways for m in METHODS}


class Model(NamedTuple):
    """A scene, the histories that are compared, speeds [per s] at which their frames move, and whether each turns on the one before."""

    scene: Any
    histories: Sequence[str]
    moving: Any = 0.0
    summed: bool = False


def balls(problem: Problem) -> Model:
    if len(problem.physics.places) == 1:
        return Model(ball(problem.physics), ["vertical.travel"])
    n = len(problem.physics.places)
    return Model(scenes.falling_balls(n), [f"flight_{i}.z" for i in range(n)])


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


def cradle(problem: Problem) -> Model:
    """Return the built-in cradle, whose numbers are those of the problem."""
    return Model("newtons_cradle", [f"string_{i}.angle" for i in range(problem.physics.spheres)])


def crank(problem: Problem) -> Model:
    """Return the built-in slider-crank, whose rod turns against the crank."""
    scene = "slider_crank" if problem.physics.friction else "slider_crank_frictionless"
    return Model(scene, ["crank_pin.angle", "guide.travel"], np.array([problem.physics.w, 0.0]))


def chain(problem: Problem) -> Model:
    """Return the rods on hinges, whose angles are against each other."""
    import hertzwerk.derive as hd

    numbers = problem.physics
    a, mass = hd.Parameter("length", "m", numbers.length), hd.Parameter("mass", "kg", numbers.mass)
    joints, end = [], hd.GROUND.at(0, 0, 0)
    for i in range(numbers.links):
        rod = hd.Body(f"rod_{i}", mass, mass * a**2 / 12, centre=(a / 2, 0, 0))
        joints.append(hd.Revolute(f"joint_{i}", end, rod, axis=hd.Z))
        end = rod.at(a, 0, 0)
    scene = hd.Scene(
        hd.Mechanism("falling_chain", tuple(joints)),
        effects=(hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", numbers.gravity), direction=-hd.Y),),
        scales=hd.Scales(length=a, arm=a, speed=hd.Parameter("pace", "m/s", 1)),
        summary="a chain that falls from the horizontal",
    )
    return Model(scene, [f"joint_{i}.angle" for i in range(numbers.links)], summed=True)


BUILDERS: dict[str, Callable[[Problem], Model]] = {
    "balls": balls,
    "cradle": cradle,
    "crank": crank,
    "chain": chain,
}
LOADED: dict[str, Model] = {}


def loaded(problem: Problem) -> Model:
    from hertzwerk.runtime import load

    if problem.name not in LOADED:
        built = BUILDERS[problem.kind](problem)
        LOADED[problem.name] = built._replace(scene=load(built.scene))
    return LOADED[problem.name]


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the model is derived before it, and compiled by its first call."""
    from hertzwerk.runtime import simulate

    scene, histories, moving, summed = loaded(problem)
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
        states = np.column_stack([at[name] for name in histories]) + np.outer(times, moving)
        states = np.cumsum(states, axis=1) if summed else states
        return Result(states, lambda: np.array([hit.t for hit in found.impacts]))

    return run
