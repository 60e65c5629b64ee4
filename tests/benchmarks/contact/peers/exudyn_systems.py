"""Exudyn: systems of nodes, objects and connectors.

Chains are kinematic trees. Balls are mass points with a spring-damper to the ground whose force is a symbolic user function, which its
documentation recommends for speed.
The slider-crank has rigid bodies and revolute joints in the plane, and Exudyn's contact element of a sphere in a hollow sphere: Hunt and
Crossley's K d^n (1 + 3 (1 - e)/2 d'/v0) with v0 latched at the onset. Its e is chosen so that the factor is that of the problem. Joints need
implicit integrators. The crank turns at constant speed because nothing can slow it.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME, PACKAGE = "Exudyn", "exudyn"
IMPLICIT = ("GeneralizedAlpha", "TrapezoidalIndex2")
FIXED = ("ExplicitEuler", "ExplicitMidpoint", "VelocityVerlet", "RK33", "RK44", "RK67")
CONTROLLED = ("ODE23", "DOPRI5")
HEAVY = 1e8  # kg m^2: the rod's torques change the crank's speed by less than 1e-9


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return steps [s], and tolerances where the step is controlled."""
    if problem.kind == "loops":
        return dict.fromkeys(IMPLICIT, decades(2, 5, 2))
    if problem.kind == "crank" and not problem.physics.friction:  # its contact element has none
        return dict.fromkeys(IMPLICIT, decades(5, 8, 2))
    if problem.kind in ("balls", "chain") or (problem.kind == "belt" and problem.physics.smooth):
        return {**dict.fromkeys((*IMPLICIT, *FIXED), decades(3, 5, 2)), **dict.fromkeys(CONTROLLED, decades(3, 12, 1))}
    return {}


class Filled(NamedTuple):
    """Function that returns the compared coordinates of a system, and objects that live as long as it does."""

    coordinates: Callable[[], Sequence[float]]
    kept: Sequence[Any] = ()


def balls(system: Any, numbers: Any) -> Filled:
    import exudyn as exu
    from exudyn import itemInterface as items  # noqa: N813
    from exudyn.advancedUtilities import CreateSymbolicUserFunction

    still = ground(system)

    def force(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
        return exu.symbolic.IfThenElse(u < 0, k * u * (1 - d * v), exu.symbolic.Real(0))

    kept = []
    for x, y, z in numbers.places:
        node = system.AddNode(
            items.NodePoint(referenceCoordinates=[x, y, numbers.radius], initialCoordinates=[0, 0, z - numbers.radius])
        )
        body = system.AddObject(items.ObjectMassPoint(physicsMass=numbers.mass, nodeNumber=node))
        weigh(system, body, [0, 0, -numbers.gravity])
        height = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=2))
        spring = system.AddObject(
            items.ObjectConnectorCoordinateSpringDamper(
                markerNumbers=[still, height], stiffness=numbers.stiffness, damping=numbers.loss
            )
        )
        kept.append(CreateSymbolicUserFunction(system, force, "springForceUserFunction", spring))
        system.SetObjectParameter(spring, "springForceUserFunction", kept[-1])
    return Filled(lambda: numbers.radius + np.array(system.systemData.GetODE2Coordinates()[2::3]), kept)


def belt(system: Any, numbers: Any) -> Filled:
    """Fill with a mass whose spring and friction are one symbolic user function."""
    import exudyn as exu
    from exudyn import itemInterface as items  # noqa: N813
    from exudyn.advancedUtilities import CreateSymbolicUserFunction

    m, speed, wide = exu.symbolic, numbers.speed, numbers.stribeck
    kinetic, more, narrow = (
        numbers.load * numbers.kinetic,
        numbers.load * (numbers.static - numbers.kinetic),
        numbers.smooth,
    )

    def force(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
        s = v - speed
        return k * u + (kinetic + more * m.exp(-(s / wide) * (s / wide))) * m.tanh(s / narrow)

    node = system.AddNode(items.Node1D(referenceCoordinates=[0], initialCoordinates=[0], initialVelocities=[0]))
    system.AddObject(items.ObjectMass1D(physicsMass=numbers.mass, nodeNumber=node))
    moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    spring = system.AddObject(
        items.ObjectConnectorCoordinateSpringDamper(
            markerNumbers=[ground(system), moving], stiffness=numbers.stiffness, damping=0
        )
    )
    kept = CreateSymbolicUserFunction(system, force, "springForceUserFunction", spring)
    system.SetObjectParameter(spring, "springForceUserFunction", kept)
    return Filled(system.systemData.GetODE2Coordinates, [kept])


def chain(system: Any, numbers: Any) -> Filled:
    """Fill with a kinematic tree, whose coordinates are angles of the rods against each other."""
    import exudyn as exu
    from exudyn import itemInterface as items  # noqa: N813

    n, a, m = numbers.links, numbers.length, numbers.mass
    none = [0.0] * n
    node = system.AddNode(
        items.NodeGenericODE2(
            referenceCoordinates=none, initialCoordinates=none, initialCoordinates_t=none, numberOfODE2Coordinates=n
        )
    )
    system.AddObject(
        items.ObjectKinematicTree(
            nodeNumber=node,
            jointTypes=[exu.JointType.RevoluteZ] * n,
            linkParents=list(range(-1, n - 1)),
            jointTransformations=exu.Matrix3DList([np.eye(3)] * n),
            jointOffsets=exu.Vector3DList([[a if i else 0.0, 0, 0] for i in range(n)]),
            linkInertiasCOM=exu.Matrix3DList([np.diag([0, 1, 1]) * m * a * a / 12] * n),
            linkCOMs=exu.Vector3DList([[a / 2, 0, 0]] * n),
            linkMasses=[m] * n,
            gravity=[0, -numbers.gravity, 0],
        )
    )
    return Filled(lambda: np.cumsum(system.systemData.GetODE2Coordinates()))


def ground(system: Any) -> int:
    """Add a marker that stands still."""
    from exudyn import itemInterface as items  # noqa: N813

    node = system.AddNode(items.NodePointGround())
    return system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


def weigh(system: Any, body: int, gravity: Sequence[float]) -> None:
    """Add the weight of a body."""
    from exudyn import itemInterface as items  # noqa: N813

    whole = system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
    system.AddLoad(items.LoadMassProportional(markerNumber=whole, loadVector=gravity))


class Plane:
    """Rigid bodies in the plane, with their nodes; angles are those of the ground's frame."""

    def __init__(self, system: Any) -> None:
        from exudyn import itemInterface as items  # noqa: N813

        self.system, self.items = system, items
        self.ground = system.AddObject(items.ObjectGround())

    def body(self, place: Sequence[float], velocities: Sequence[float], mass: float, inertia: float) -> tuple[int, int]:
        """Add a body at (x, y, angle); returns its node and itself."""
        node = self.system.AddNode(self.items.NodeRigidBody2D(referenceCoordinates=place, initialVelocities=velocities))
        body = self.items.ObjectRigidBody2D(nodeNumber=node, physicsMass=mass, physicsInertia=inertia)
        return node, self.system.AddObject(body)

    def at(self, body: int, x: float, y: float = 0.0) -> int:
        """Add a marker on a body."""
        return self.system.AddMarker(self.items.MarkerBodyRigid(bodyNumber=body, localPosition=[x, y, 0]))

    def joint(self, first: int, second: int) -> None:
        """Add a revolute joint of two markers."""
        self.system.AddObject(self.items.ObjectJointRevolute2D(markerNumbers=[first, second]))


def crank(system: Any, m: Any) -> Filled:
    plane = Plane(system)
    items = plane.items
    turning = -m.w * m.r / m.l
    _, crank = plane.body([0, 0, 0], [0, 0, m.w], 1, HEAVY)
    rod_node, rod = plane.body([m.r + m.s, 0, 0], [0, m.r * m.w + m.s * turning, turning], m.m_rod, m.J_rod)
    slider_node, slider = plane.body([m.r + m.l, 0, 0], [0, 0, 0], m.m_slider, 1)
    plane.joint(plane.at(plane.ground, 0), plane.at(crank, 0))
    plane.joint(plane.at(crank, m.r), plane.at(rod, -m.s))
    still = ground(system)
    for coordinate in (1, 2):  # the slider neither lifts nor turns
        moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=slider_node, coordinate=coordinate))
        system.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[still, moving]))
    weigh(system, rod, [0, -m.g, 0])
    memory = system.AddNode(items.NodeGenericData(initialCoordinates=[m.c, 0, 0, 0], numberOfDataCoordinates=4))
    system.AddObject(
        items.ObjectContactSphereSphere(
            markerNumbers=[plane.at(rod, m.l - m.s), plane.at(slider, 0)],
            nodeNumber=memory,
            spheresRadii=[m.R_pin, m.R_bush],
            isHollowSphere1=True,
            contactStiffness=m.K,
            contactStiffnessExponent=1.5,
            impactModel=1,
            restitutionCoefficient=1 - 2 * m.h / 3,
            minimumImpactVelocity=m.floor,
        )
    )

    def coordinates() -> Sequence[float]:
        import exudyn as exu

        read = exu.OutputVariableType.Coordinates
        (_, _, theta), (travel, *_) = (system.GetNodeOutput(node, read) for node in (rod_node, slider_node))
        return [theta, m.r + m.l + travel]

    return Filled(coordinates)


def loops(system: Any, numbers: Any) -> Filled:
    """Fill with bodies and revolute joints in the plane."""
    plane = Plane(system)
    n, start = len(numbers.rods), numbers.start
    bodies = []
    for i, rod in enumerate(numbers.rods):
        moving = [*start[3 * n + n + 2 * i : 3 * n + n + 2 * i + 2], rod.speed]
        bodies.append(plane.body([*numbers.places[i], rod.angle], moving, rod.mass, rod.inertia))
        weigh(system, bodies[-1][1], [0, -numbers.gravity, 0])
    whole = [body for _, body in bodies] + [plane.ground]
    for first, on_first, second, on_second in numbers.joints:
        plane.joint(plane.at(whole[first], *on_first), plane.at(whole[second], *on_second))
    items = plane.items
    if numbers.torque:
        system.AddLoad(items.LoadTorqueVector(markerNumber=plane.at(whole[0], 0), loadVector=[0, 0, numbers.torque]))
    if numbers.spring:
        body, point, place, stiffness, length = numbers.spring
        ends = [plane.at(plane.ground, *place), plane.at(whole[body], *point)]
        system.AddObject(
            items.ObjectConnectorSpringDamper(markerNumbers=ends, stiffness=stiffness, referenceLength=length)
        )

    def coordinates() -> Sequence[float]:
        import exudyn as exu

        read = exu.OutputVariableType.Coordinates
        return [
            rod.angle + system.GetNodeOutput(node, read)[2] for rod, (node, _) in zip(numbers.rods, bodies, strict=True)
        ]

    return Filled(coordinates)


MODELS: dict[str, Callable[[Any, Any], Filled]] = {
    "balls": balls, "belt": belt, "chain": chain, "crank": crank, "loops": loops,
}  # fmt: skip


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the system is assembled before it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its extension modules, and of new names for old parameters
        return _prepared(problem, integrator, setting)


def _prepared(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    import exudyn as exu

    container = exu.SystemContainer()
    system = container.AddSystem()
    filled = MODELS[problem.kind](system, problem.physics)
    system.Assemble()
    solver = getattr(exu.DynamicSolverType, integrator)
    start = system.systemData.GetSystemState(exu.ConfigurationType.Initial)
    run_settings = exu.SimulationSettings()
    run_settings.solution.file.write = False
    time = run_settings.timeIntegration
    time.verboseMode, time.minimumStepSize = 0, 1e-14
    if integrator in CONTROLLED:
        time.relativeTolerance, time.absoluteTolerance, time.automaticStepSize = setting, setting / 1000, True
    if problem.kind == "crank":
        # the discontinuous iteration fails at the first contact unless it is let go
        time.newton.relativeTolerance, time.discontinuous.iterationTolerance = 1e-6, 1e3

    def run() -> Result:
        assert container  # owns the system
        system.systemData.SetSystemState(start, exu.ConfigurationType.Initial)
        states, t = [], 0.0
        for end in map(float, problem.times):
            time.startTime, time.endTime = t, end
            time.numberOfSteps = 100 if integrator in CONTROLLED else max(1, round((end - t) / setting))
            if not system.SolveDynamic(run_settings, solverType=solver, updateInitialValues=True):
                raise ArithmeticError("Exudyn did not solve a step")
            t = end
            states.append(filled.coordinates())
        return Result(np.array(states))

    return run
