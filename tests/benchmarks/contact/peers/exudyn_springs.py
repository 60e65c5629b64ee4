"""Exudyn: mass points with a spring-damper to the ground whose force is a symbolic user function, which its documentation recommends for speed."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME, PACKAGE = "Exudyn", "exudyn"
IMPLICIT = ("GeneralizedAlpha", "TrapezoidalIndex2")
FIXED = ("ExplicitEuler", "ExplicitMidpoint", "VelocityVerlet", "RK33", "RK44", "RK67")
CONTROLLED = ("ODE23", "DOPRI5")


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return steps [s], and tolerances where the step is controlled."""
    if problem.kind != "balls":
        return {}
    return {**dict.fromkeys((*IMPLICIT, *FIXED), decades(3, 5, 2)), **dict.fromkeys(CONTROLLED, decades(3, 12, 1))}


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the system is assembled before it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its extension modules, and of new names for old parameters
        return _prepared(problem, integrator, setting)


def _prepared(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    import exudyn as exu
    from exudyn import itemInterface as items  # noqa: N813
    from exudyn.advancedUtilities import CreateSymbolicUserFunction

    numbers = problem.physics
    container = exu.SystemContainer()
    system = container.AddSystem()
    still = system.AddMarker(
        items.MarkerNodeCoordinate(nodeNumber=system.AddNode(items.NodePointGround()), coordinate=0)
    )

    def force(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
        return exu.symbolic.IfThenElse(u < 0, k * u * (1 - d * v), exu.symbolic.Real(0))

    nodes, kept = [], [container]
    for x, y, z in numbers.places:
        node = system.AddNode(
            items.NodePoint(referenceCoordinates=[x, y, numbers.radius], initialCoordinates=[0, 0, z - numbers.radius])
        )
        nodes.append(node)
        body = system.AddObject(items.ObjectMassPoint(physicsMass=numbers.mass, nodeNumber=node))
        system.AddLoad(
            items.LoadMassProportional(
                markerNumber=system.AddMarker(items.MarkerBodyMass(bodyNumber=body)),
                loadVector=[0, 0, -numbers.gravity],
            )
        )
        height = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=2))
        spring = system.AddObject(
            items.ObjectConnectorCoordinateSpringDamper(
                markerNumbers=[still, height], stiffness=numbers.stiffness, damping=numbers.loss
            )
        )
        # kept as long as the system is, by the closure below
        kept.append(CreateSymbolicUserFunction(system, force, "springForceUserFunction", spring))
        system.SetObjectParameter(spring, "springForceUserFunction", kept[-1])
    system.Assemble()
    solver = getattr(exu.DynamicSolverType, integrator)
    start = system.systemData.GetODE2Coordinates()
    rest = np.zeros_like(start)
    run_settings = exu.SimulationSettings()
    run_settings.solution.file.write = False
    time = run_settings.timeIntegration
    time.verboseMode, time.minimumStepSize = 0, 1e-14
    if integrator in CONTROLLED:
        time.relativeTolerance, time.absoluteTolerance, time.automaticStepSize = setting, setting / 1000, True

    def run() -> Result:
        data = system.systemData
        data.SetODE2Coordinates(start, exu.ConfigurationType.Initial)
        data.SetODE2Coordinates_t(rest, exu.ConfigurationType.Initial)
        states, t = [], 0.0
        for end in map(float, problem.times):
            time.startTime, time.endTime = t, end
            time.numberOfSteps = 100 if integrator in CONTROLLED else max(1, round((end - t) / setting))
            if not system.SolveDynamic(run_settings, solverType=solver, updateInitialValues=True):
                raise ArithmeticError("Exudyn did not solve a step")
            t = end
            states.append([numbers.radius + data.GetODE2Coordinates()[3 * k + 2] for k in range(len(nodes))])
        assert kept
        return Result(np.array(states))

    return run
