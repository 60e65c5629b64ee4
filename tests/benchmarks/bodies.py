"""Many bodies: what pairs cost that are far from contact, and balls that fall onto a plane beside Drake, at equal error.

Balls start at rest at heights of their own over a plane and next to one another, every two of which may touch. Errors are those of their heights
at the end, against each ball's own equation solved by SciPy at 1e-13 from contact to contact. Of each side the fastest setting that keeps to an
error is taken. Drake is an extra of this benchmark alone (pip install drake).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import cache
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
from benchmarks.pairs import attempt
from benchmarks.ratios import Ratio, decades, hot, medians

from reference import scenes
from reference.scenes import FALLING as BALL

DRAKE = ("bogacki_shampine3", "runge_kutta3", "runge_kutta5", "radau3", "cenic")
METHODS = "dopri5", "dop853"
COUNTS, TARGETS, DURATION = (4, 12, 40, 100), (1e-3, 1e-6), 0.5
UNCOMPILED = 12  # balls up to which the bar is for the virtual machine
LONGEST = 4.0  # s, of a run of which five times as long is not tried


class Setting(NamedTuple):
    """An integrator at one tolerance: run: () -> heights at the end [m]; one run takes about `time` [s]."""

    name: str
    run: Callable[[], np.ndarray]
    time: float


def bodies() -> Iterator[Ratio]:
    """Pairs of which one touches, 100 over one; falling balls, Drake's best integrator over hertzwerk at equal error."""
    from hertzwerk.runtime import load

    models = [load(scenes.guarded_crank(guards)) for guards in (0, 99)]
    for compiled in (False, True):
        one, many = medians(*(attempt(model, compiled) for model in models))
        yield Ratio(f"100 pairs / 1 pair, per attempt, {'C' if compiled else 'VM'}", many, one, "<= 1.5")
    if find_spec("pydrake") is None:
        print("  Drake not measured: needs pip install drake")
        return
    for count in COUNTS:
        exact = heights(count)
        for target in TARGETS:
            theirs = fastest(exact, target, {name: drake(count, name) for name in DRAKE})
            for compiled in (False, True):
                ours = fastest(exact, target, {name: hertzwerk(count, name, compiled) for name in METHODS})
                if theirs is None or ours is None:
                    print(f"  {count} balls, error {target:g} not reached: Drake {theirs}, hertzwerk {ours}")
                    continue
                slow, fast = medians(*(hot(each.run, calls=3, warm=1) for each in (theirs, ours)), repeats=5)
                wanted = ">= 10" if compiled or count <= UNCOMPILED else ""
                where = "C" if compiled else "VM"
                note = f"{theirs.name}; {ours.name}"
                yield Ratio(f"Drake / hertzwerk, {count} balls, error {target:g}, {where}", slow, fast, wanted, note)


def fastest(
    exact: np.ndarray, target: float, kinds: dict[str, Callable[[float], Callable[[], np.ndarray]]]
) -> Setting | None:
    """Return the setting of least time whose error, and that of the next tighter one, is below the target.

    Tighter settings are not tried of what is five times as slow as another that was found.
    """
    found: list[Setting] = []
    for name, at in kinds.items():
        kept = None
        for tolerance in decades(1, 11, 2):
            run = at(tolerance)
            begin = time.thread_time()
            error = np.abs(run() - exact).max()
            took = time.thread_time() - begin
            if error <= target and kept is not None:
                found.append(kept)
                break
            kept = Setting(f"{name} at {tolerance:.1e}", run, took) if error <= target else None
            if took > 5 * min((each.time for each in found), default=LONGEST):
                break
    return min(found, key=lambda each: each.time, default=None)


def heights(count: int) -> np.ndarray:
    """Return the heights of the balls at the end [m], each by its own equation."""
    from scipy.integrate import solve_ivp

    def force(t: float, y: np.ndarray) -> list[float]:
        depth = BALL.radius - y[0]
        pushed = BALL.stiffness * depth * (1 - BALL.loss * y[1]) if depth > 0 else 0.0
        return [y[1], pushed / BALL.mass - BALL.gravity]

    def surface(t: float, y: np.ndarray) -> float:
        return float(y[0] - BALL.radius)

    surface.terminal = True  # type: ignore[attr-defined]
    found = []
    for *_, height in map(BALL.place, range(count)):
        t, y, direction = 0.0, [height, 0.0], -1
        while t < DURATION:
            surface.direction = direction  # type: ignore[attr-defined]
            part = solve_ivp(force, (t, DURATION), y, method="DOP853", rtol=1e-13, atol=1e-16, events=surface)
            t, y, direction = part.t[-1], part.y[:, -1], -direction
        found.append(y[0])
    return np.array(found)


@cache
def _model(count: int) -> Any:
    from hertzwerk.runtime import load

    return load(scenes.falling_balls(count))


def hertzwerk(count: int, method: str, compiled: bool) -> Callable[[float], Callable[[], np.ndarray]]:
    """Return simulate() of a loaded model: tolerance -> () -> heights."""
    from hertzwerk.runtime import simulate

    model = _model(count)
    options = {"duration": DURATION, "method": method, "compiled": compiled, "grid": None}

    def at(tolerance: float) -> Callable[[], np.ndarray]:
        def run() -> np.ndarray:
            found = simulate(model, tolerance=tolerance, **options)
            return np.array([found[f"flight_{i}.z"][-1] for i in range(count)])

        return run

    return at


def drake(count: int, scheme: str) -> Callable[[float], Callable[[], np.ndarray]]:
    """Return the run of one of Drake's integrators with error control: accuracy -> () -> heights."""
    import pydrake.all as pd

    builder = pd.DiagramBuilder()
    plant, _ = pd.AddMultibodyPlantSceneGraph(builder, 0.0)
    plant.set_contact_model(pd.ContactModel.kPoint)
    surface = pd.ProximityProperties()
    # of two bodies in a row: half the stiffness, and the mean dissipation
    none = pd.CoulombFriction(0, 0)
    pd.AddContactMaterial(BALL.loss, 2 * BALL.stiffness, none, surface)
    plant.RegisterCollisionGeometry(plant.world_body(), pd.RigidTransform(), pd.HalfSpace(), "floor", surface)
    bodies = []
    for i in range(count):
        inertia = pd.SpatialInertia.SolidSphereWithMass(BALL.mass, BALL.radius)
        bodies.append(plant.AddRigidBody(f"ball_{i}", inertia))
        shape = pd.Sphere(BALL.radius)
        plant.RegisterCollisionGeometry(bodies[-1], pd.RigidTransform(), shape, f"ball_{i}", surface)
    plant.Finalize()
    simulator = pd.Simulator(builder.Build())

    def at(accuracy: float) -> Callable[[], np.ndarray]:
        settings = pd.SimulatorConfig(integration_scheme=scheme, accuracy=accuracy, use_error_control=True)

        def run() -> np.ndarray:
            pd.ApplySimulatorConfig(settings, simulator)
            root = simulator.get_mutable_context()
            root.SetTime(0.0)
            context = plant.GetMyMutableContextFromRoot(root)
            plant.SetVelocities(context, np.zeros(plant.num_velocities()))
            for i, body in enumerate(bodies):
                plant.SetFreeBodyPose(context, body, pd.RigidTransform(np.array(BALL.place(i))))
            simulator.Initialize()
            simulator.AdvanceTo(DURATION)
            return np.array([plant.GetFreeBodyPose(context, body).translation()[2] for body in bodies])

        return run

    return at
