"""Projection of a step's end onto the loop constraints: positions first, then speeds.

The correction is the least in kinetic energy, so that no unit has to be weighed against another. Hairer, Lubich,
Wanner, Geometric Numerical Integration (2006), IV.4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.rounding_errors import STATE, bounds
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

ITERATIONS = 2  # Newton's: the residual after a step is small, its square below rounding
RUNAWAY = 1e3  # speeds over their scales: near a position in which a driven mechanism locks they grow without bound
CALLED = 3000  # instructions of all projections of a step's end, beyond which they are called: written out they take long to build
LOST = 1e200  # error norm of a step whose end does not close the loops; no other is as large


@dataclass(frozen=True)
class Closing:
    """Projection onto the constraints of a mechanism with loops."""

    function: Any
    along: Any
    """(t, y, error (ny), c) -> part of an error that closing leaves: along the constraints."""
    lengths: tuple[bool, ...]
    """Whether each constraint is a length [m], not an angle's sine [1]."""
    speeds: slice
    """Rows of the state."""

    def __call__(self, t: Any, y: Any, run: Any) -> tuple[Any, Any]:
        """Return the projected state (ny) and whether its loops are closed.

        Closed means: residuals within the tolerance, though not below the rounding of the coordinates.
        """
        y, phi, rounding, rate = self.function(t, y, run["c"])
        length, speed = run["scales"][0], run["scales"][1]
        small = ca.fmax(
            rounding, run["tolerance"] * ca.vertcat(*(length if is_length else 1 for is_length in self.lengths))
        )
        # a singular position leaves a part of the rates undetermined
        slow = ca.sqrt(run["tolerance"]) * ca.vertcat(
            *(speed if is_length else speed / length for is_length in self.lengths)
        )
        closed = ca.mmax(ca.vertcat(ca.fabs(phi) - small, ca.fabs(rate) - slow)) <= 0  # false for NaN
        return y, closed * (ca.mmax(ca.fabs(y[self.speeds]) / run["scale"][self.speeds]) < RUNAWAY)


def closing(model: EngineModel) -> Closing | None:
    """Return the projection of a model; None for a tree."""
    if not model.nl:
        return None
    speeds = slice(model.nq, model.nq + model.nu)
    return Closing(_closed(model), _along(model), model.is_length, speeds)


@per_model
def _closed(model: EngineModel) -> Any:
    """Build the function (t, y, c) -> (projected y, residuals, their rounding bounds, their rates (nl))."""
    constraints, project = model.function("constraints"), model.function("projection")
    called = (1 + ITERATIONS) * project.n_instructions() > CALLED
    t, y, c = model.symbols("t y c", ca.MX if called else ca.SX)
    q, u, z = model.parts(y)
    rates, still = model.function("coordinate_rates"), ca.DM.zeros(model.nu)
    phi, _ = constraints(t, q, u, c)
    for _ in range(ITERATIONS):
        q = q + rates(t, q, project(t, q, -phi, c)[0], c) - rates(t, q, still, c)
        phi, phi_rate = constraints(t, q, u, c)
    u = u - project(t, q, phi_rate, c)[0]
    _, rate = constraints(t, q, u, c)
    rounding, _ = bounds(constraints, STATE)(t, q, u, c)  # an angle after many turns is known to fewer digits
    results = [ca.vertcat(q, u, z), phi, rounding, rate]
    return ca.Function("closed", [t, y, c], results if called else ca.cse(results))


@per_model
def _along(model: EngineModel) -> Any:
    """Build the function (t, y, error (ny), c) -> error projected onto the constraints' tangent space."""
    t, y, c = model.symbols("t y c")
    error = ca.SX.sym("error", y.numel())
    (q, u, _), (dq, du, dz) = model.parts(y), model.parts(error)
    constraints, project = model.function("constraints"), model.function("projection")
    rates, still = model.function("coordinate_rates"), ca.SX.zeros(model.nu)
    phi, rate = constraints(t, q, u, c)
    back = project(t, q, ca.jtimes(phi, q, dq), c)[0]
    dq = dq - (rates(t, q, back, c) - rates(t, q, still, c))
    du = du - project(t, q, ca.jtimes(rate, u, du), c)[0]
    return ca.Function("along", [t, y, error, c], ca.cse([ca.vertcat(dq, du, dz)]))
