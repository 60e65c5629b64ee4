"""hertzwerk: `simulate` of a loaded model with a local tolerance, in CasADi's virtual machine and compiled; results are bitwise the same."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import pi
from typing import Any, NamedTuple

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

from reference import scenes

NAME, PACKAGE = "hertzwerk", "hertzwerk"
METHODS = ("dopri5", "dop853")
IMPLICIT = ("rodas", "esdirk")  # where friction is stiff
COMPILED = 12  # contacts of the equations and coordinates up to which models are compiled: more take minutes


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return tolerances; those of compiled runs are the same."""
    if problem.kind not in BUILDERS:
        return {}
    ways = (" compiled", "") if max(problem.contacts, problem.compared) <= COMPILED else ("",)
    return {
        f"{m}{how}": decades(1, 12, 1)
        for how in ways
        for m in (*METHODS, *(IMPLICIT if problem.kind == "belt" else ()))
    }


class Model(NamedTuple):
    """A scene, the histories that are compared, speeds [per s] at which their frames move, a matrix that combines them, and offsets."""

    scene: Any
    histories: Sequence[str]
    moving: Any = 0.0
    combined: Any = None
    offset: Any = 0.0
    onsets: Callable[[Any], Any] = lambda found: [hit.t for hit in found.impacts]


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
    return Model(scene, [f"joint_{i}.angle" for i in range(numbers.links)], combined=np.tri(numbers.links))


def belt(problem: Problem) -> Model:
    """Return the mass that slides on a driven belt, whose travel is against the belt."""
    import hertzwerk.derive as hd
    from hertzwerk.derive.laws import coulomb, stribeck

    numbers = problem.physics
    kinetic, static = hd.Parameter("mu_k", "1", numbers.kinetic), hd.Parameter("mu_s", "1", numbers.static)
    law = (
        coulomb(kinetic, static)
        if numbers.smooth is None
        else stribeck(
            kinetic,
            static,
            hd.Parameter("v_S", "m/s", numbers.stribeck),
            hd.Parameter("v_s", "m/s", numbers.smooth),
            hd.Parameter("c_v", "N s/m", 0),
        )
    )
    band, mass = (
        hd.Body("band", hd.Parameter("band_mass", "kg", 1)),
        hd.Body("mass", hd.Parameter("mass", "kg", numbers.mass)),
    )
    speed = hd.Parameter("belt_speed", "m/s", numbers.speed)
    scene = hd.Scene(
        hd.Mechanism(
            "mass_on_belt",
            (hd.Prismatic("drum", hd.GROUND, band, axis=hd.X), hd.Prismatic("slide", band, mass, axis=hd.X)),
        ),
        effects=(
            hd.ConstantSpeed("drive", joint="drum", speed=speed),
            hd.PointSpring(
                "spring", hd.GROUND.at(0, 0, 0), mass.at(0, 0, 0), hd.Parameter("stiffness", "N/m", numbers.stiffness)
            ),
            hd.JointFriction("friction", "slide", law, hd.Parameter("load", "N", numbers.load)),
        ),
        start=hd.Start(speed={"slide": -speed}),
        scales=hd.Scales(length=hd.Parameter("size", "mm", 10), speed=speed),
        summary="a mass that sticks and slips on a belt",
    )
    return Model(scene, ["slide.travel"], np.array([numbers.speed]), onsets=sticking)


def sticking(found: Any) -> Any:
    """Return the times at which the mass sticks."""
    slips = found["friction.slip"] != 0
    return found.t[1:][slips[:-1] & ~slips[1:]]


def loops(problem: Problem) -> Model:
    """Return the built-in squeezer, or windows of the built-in kind in gravity along their posts, so that they hang."""
    import hertzwerk.derive as hd
    from hertzwerk.derive.scenes.n_four_bar import n_four_bar

    if problem.name == "squeezer":
        names = ("beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon")
        return Model("andrews_squeezer", [f"{name}.angle" for name in names], combined=SQUEEZER)
    windows = len(problem.physics.rods) // 2
    scene = n_four_bar(windows)
    gravity = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", problem.physics.gravity), direction=hd.Y)
    start = hd.Start(speed={"foot_0": hd.Parameter("turning", "rad/s", problem.physics.rods[0].speed)})
    scene = replace(scene, effects=(gravity,), start=start)
    names = [f"foot_{i}.angle" for i in range(windows + 1)] + [f"left_{i}.angle" for i in range(windows)]
    combined = np.eye(len(names))
    combined[windows + 1 :, :windows] += np.eye(windows)  # beams turn on posts
    return Model(scene, names, combined=combined, offset=np.array([-pi / 2] * (windows + 1) + [0.0] * windows))


# bodies turn on the ground, but the second on the first, the fourth on the fifth, the sixth on the seventh
SQUEEZER = np.eye(7)
SQUEEZER[[1, 3, 5], [0, 4, 6]] = 1


BUILDERS: dict[str, Callable[[Problem], Model]] = {
    "balls": balls, "cradle": cradle, "crank": crank, "chain": chain, "belt": belt, "loops": loops,
}  # fmt: skip
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

    scene, histories, moving, combined, offset, onsets = loaded(problem)
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
        states = states if combined is None else states @ combined.T
        return Result(states + offset, lambda: np.array(onsets(found)))

    return run


def sweep(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the sweep over the heights at the start, in this process."""
    from hertzwerk.runtime import sweep

    scene, histories, *_ = loaded(problem)
    method, *compiled = integrator.split()
    starts = ["height"] if len(histories) == 1 else [f"z_{i}" for i in range(len(histories))]
    end = float(problem.rows[0].grid[-1])
    first, second = (np.array([place[2] for place in row.physics.places]) for row in problem.rows[:2])
    step = (second - first) * len(problem.rows) / problem.all_rows
    heights = first + np.outer(np.arange(problem.all_rows), step)
    over = {name: [f"{z!r} m" for z in column.tolist()] for name, column in zip(starts, heights.T, strict=True)}
    outputs = [f"final.{name}" for name in histories]
    compared = problem.all_rows // len(problem.rows)

    def run() -> Result:
        table = sweep(
            scene,
            over,
            zip=True,
            outputs=outputs,
            duration=end,
            tolerance=setting,
            method=method,
            compiled=bool(compiled),
            workers=1,
        )
        return Result(np.column_stack([table[name] for name in outputs])[::compared])

    return run
