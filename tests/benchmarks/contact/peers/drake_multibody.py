"""Drake: rigid bodies with point contact of Hunt and Crossley, which is the law of the problems; every integrator with error control, fixed steps
of the others, and the discrete plant, which its documentation recommends, with the two approximations that have this law in the limit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME, PACKAGE, MODULE = "Drake", "drake", "pydrake"
CONTROLLED = (
    "bogacki_shampine3", "runge_kutta3", "runge_kutta5", "radau1", "radau3", "implicit_euler",
    "velocity_implicit_euler", "cenic",
)  # fmt: skip
FIXED = ("explicit_euler", "runge_kutta2", "semi_explicit_euler")
DISCRETE = ("lagged", "similar", "tamsi")


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return accuracies, and steps [s] where there is no error control."""
    if problem.kind not in MODELS:
        return {}
    return {
        **dict.fromkeys(CONTROLLED, decades(2, 10, 1)),
        **dict.fromkeys(FIXED, decades(3, 6, 2)),
        **{f"discrete {name}": decades(2, 6, 2) for name in DISCRETE},
    }


class Model(NamedTuple):
    """Functions of a plant's context: to its start, and its coordinates."""

    begin: Callable[[Any], None]
    coordinates: Callable[[Any], list[float]]


@cache
def plant_of(kind: str, physics: Any, step: float, approximation: str) -> tuple[Any, Any, Model]:
    """Return the simulator, the plant and the model in it."""
    import pydrake.all as pd

    builder = pd.DiagramBuilder()
    plant, _ = pd.AddMultibodyPlantSceneGraph(builder, step)
    plant.set_contact_model(pd.ContactModel.kPoint)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -physics.gravity])
    if step:
        plant.set_discrete_contact_approximation(
            getattr(pd.DiscreteContactApproximation, "k" + approximation.capitalize())
        )
    model = MODELS[kind](plant, physics)
    plant.Finalize()
    return pd.Simulator(builder.Build()), plant, model


def surface_of(stiffness: float, loss: float) -> Any:
    """Return a contact material: of two bodies in a row half the stiffness and the mean dissipation."""
    import pydrake.all as pd

    surface = pd.ProximityProperties()
    pd.AddContactMaterial(loss, 2 * stiffness, pd.CoulombFriction(0, 0), surface)
    return surface


def balls(plant: Any, physics: Any) -> Model:
    import pydrake.all as pd

    surface = surface_of(physics.stiffness, physics.loss)
    plant.RegisterCollisionGeometry(plant.world_body(), pd.RigidTransform(), pd.HalfSpace(), "floor", surface)
    bodies = []
    for i in range(len(physics.places)):
        inertia = pd.SpatialInertia.SolidSphereWithMass(physics.mass, physics.radius)
        bodies.append(plant.AddRigidBody(f"ball_{i}", inertia))
        shape = pd.Sphere(physics.radius)
        plant.RegisterCollisionGeometry(bodies[-1], pd.RigidTransform(), shape, f"ball_{i}", surface)

    def begin(context: Any) -> None:
        for body, place in zip(bodies, physics.places, strict=True):
            plant.SetFreeBodyPose(context, body, pd.RigidTransform(np.array(place)))

    return Model(begin, lambda context: [plant.GetFreeBodyPose(context, body).translation()[2] for body in bodies])


def cradle(plant: Any, physics: Any) -> Model:
    import pydrake.all as pd

    surface = surface_of(physics.stiffness, 0.0)
    joints = []
    for i in range(physics.spheres):
        hang = np.array([0, 0, -physics.length])
        inertia = pd.SpatialInertia.SolidSphereWithMass(physics.mass, physics.radius).Shift(-hang)
        body = plant.AddRigidBody(f"ball_{i}", inertia)
        place = pd.RigidTransform(hang)
        plant.RegisterCollisionGeometry(body, place, pd.Sphere(physics.radius), f"ball_{i}", surface)
        pivot = pd.RigidTransform([i * physics.pitch, 0, 0])
        joint = pd.RevoluteJoint(
            f"string_{i}",
            plant.AddFrame(pd.FixedOffsetFrame(f"pivot_{i}", plant.world_frame(), pivot)),
            body.body_frame(),
            [0, -1, 0],
        )
        joints.append(plant.AddJoint(joint))

    def begin(context: Any) -> None:
        for joint, angle in zip(joints, physics.start, strict=False):
            joint.set_angle(context, angle)

    return Model(begin, lambda context: [joint.get_angle(context) for joint in joints])


def chain(plant: Any, physics: Any) -> Model:
    """Return the rods of a chain in the plane of x and z."""
    import pydrake.all as pd

    end = pd.RigidTransform([physics.length, 0, 0])
    inertia = pd.SpatialInertia.ThinRodWithMass(physics.mass, physics.length, [1, 0, 0]).Shift(
        [-physics.length / 2, 0, 0]
    )
    joints, upper = [], plant.world_frame()
    for i in range(physics.links):
        body = plant.AddRigidBody(f"rod_{i}", inertia)
        joints.append(plant.AddJoint(pd.RevoluteJoint(f"joint_{i}", upper, body.body_frame(), [0, -1, 0])))
        upper = plant.AddFrame(pd.FixedOffsetFrame(f"end_{i}", body.body_frame(), end))

    def begin(context: Any) -> None:
        for joint in joints:
            joint.set_angle(context, 0.0)

    return Model(begin, lambda context: np.cumsum([joint.get_angle(context) for joint in joints]).tolist())


MODELS: dict[str, Callable[[Any, Any], Model]] = {"balls": balls, "cradle": cradle, "chain": chain}


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the diagram is built before it."""
    import pydrake.all as pd

    discrete = integrator.startswith("discrete ")
    simulator, plant, model = plant_of(
        problem.kind, problem.physics, setting if discrete else 0.0, integrator.split()[-1]
    )
    fixed = integrator in FIXED
    options: dict[str, Any] = {"max_step_size": setting} if fixed else {"accuracy": setting}
    scheme = "runge_kutta3" if discrete else integrator

    def run() -> Result:
        # another setting shares the simulator: its integrator is chosen by the call
        pd.ApplySimulatorConfig(
            pd.SimulatorConfig(integration_scheme=scheme, use_error_control=not fixed, **({} if discrete else options)),
            simulator,
        )
        root = simulator.get_mutable_context()
        root.SetTime(0.0)
        context = plant.GetMyMutableContextFromRoot(root)
        plant.SetVelocities(context, np.zeros(plant.num_velocities()))
        model.begin(context)
        simulator.Initialize()
        states = []
        for t in problem.times:
            simulator.AdvanceTo(float(t))
            states.append(model.coordinates(context))
        return Result(np.array(states))

    return run
