"""The slider-crank with clearance in Exudyn: rigid bodies and revolute joints in the plane, its own contact element, its generalised-alpha method.

The element, a sphere in a hollow sphere, is Hunt and Crossley's K d^n (1 + 3 (1 - e)/2 d'/v0) with v0 latched at the onset; e is chosen so that
the factor is that of Lankarani and Nikravesh: the same law as everywhere else here. The crank turns at constant speed because nothing can slow it.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from importlib.util import find_spec
from typing import Any

from benchmarks.equal_error import DURATION, Contender
from benchmarks.ratios import Measurement, decades, hot

from reference.slider_crank import SliderCrank

INSTALLED = find_spec("exudyn") is not None
HEAVY = 1e8  # kg m^2: the rod's torques change the crank's speed by less than 1e-9
NEWTON = 1e-6  # relative tolerance; tighter ones change no digit of the error
ANY = 1e3  # of the discontinuous iteration, which fails at the first contact unless it is let go
STEPS = decades(5, 8, 4)[2:-3]  # s


def state(duration: float, step: float) -> Sequence[float]:
    """(theta, x, theta', x') after about duration/step equal steps; raises ArithmeticError where Newton's iteration gives up."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its extension modules, and of new names for old parameters
        return _solved(duration, step)


def _solved(duration: float, step: float) -> Sequence[float]:
    import exudyn as exu

    m = SliderCrank()
    container = exu.SystemContainer()  # owns the system
    system = container.AddSystem()
    rod, slider = _assemble(system, m)
    settings = exu.SimulationSettings()
    settings.solution.file.write = False
    run = settings.timeIntegration
    run.endTime, run.numberOfSteps, run.verboseMode = duration, round(duration / step), 0
    run.minimumStepSize = step / 1000
    run.newton.relativeTolerance, run.discontinuous.iterationTolerance = NEWTON, ANY
    try:
        system.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    except (RuntimeError, ValueError) as error:
        raise ArithmeticError("Exudyn did not solve a step") from error
    kinds = exu.OutputVariableType.Coordinates, exu.OutputVariableType.Coordinates_t
    (_, _, theta), (_, _, turning) = (system.GetNodeOutput(rod, kind) for kind in kinds)
    (travel, *_), (speed, *_) = (system.GetNodeOutput(slider, kind) for kind in kinds)
    return float(theta), m.r + m.l + float(travel), float(turning), float(speed)


def _assemble(system: Any, m: SliderCrank) -> tuple[int, int]:
    """Fill a system; returns the nodes of rod and slider."""
    from exudyn import itemInterface as items  # noqa: N813

    def body(x: float, velocities: list[float], mass: float, inertia: float) -> tuple[int, int]:
        node = system.AddNode(items.NodeRigidBody2D(referenceCoordinates=[x, 0, 0], initialVelocities=velocities))
        return node, system.AddObject(
            items.ObjectRigidBody2D(nodeNumber=node, physicsMass=mass, physicsInertia=inertia)
        )

    def at(body: int, x: float) -> int:
        return system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0]))

    def joint(first: int, second: int) -> None:
        system.AddObject(items.ObjectJointRevolute2D(markerNumbers=[first, second]))

    turning = -m.w * m.r / m.l
    ground = system.AddObject(items.ObjectGround())
    _, crank = body(0, [0, 0, m.w], 1, HEAVY)
    rod_node, rod = body(m.r + m.s, [0, m.r * m.w + m.s * turning, turning], m.m_rod, m.J_rod)
    slider_node, slider = body(m.r + m.l, [0, 0, 0], m.m_slider, 1)
    joint(at(ground, 0), at(crank, 0))
    joint(at(crank, m.r), at(rod, -m.s))
    still = system.AddMarker(
        items.MarkerNodeCoordinate(nodeNumber=system.AddNode(items.NodePointGround()), coordinate=0)
    )
    for coordinate in (1, 2):  # the slider neither lifts nor turns
        moving = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=slider_node, coordinate=coordinate))
        system.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[still, moving]))
    whole = system.AddMarker(items.MarkerBodyMass(bodyNumber=rod))
    system.AddLoad(items.LoadMassProportional(markerNumber=whole, loadVector=[0, -m.g, 0]))
    memory = system.AddNode(items.NodeGenericData(initialCoordinates=[m.c, 0, 0, 0], numberOfDataCoordinates=4))
    system.AddObject(
        items.ObjectContactSphereSphere(
            markerNumbers=[at(rod, m.l - m.s), at(slider, 0)],
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
    system.Assemble()
    return rod_node, slider_node


def contender() -> Contender:
    """Its accuracy is chosen by the length of its equal steps."""

    def time(step: float) -> Measurement:
        return hot(lambda: state(DURATION, step), calls=1, warm=0)

    return Contender("Exudyn", False, state, time, STEPS)
