"""The right-hand side under given modes, and one explicit Runge-Kutta step of it, as CasADi functions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.layout import CONTACT, Layouts

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.tables import RungeKutta
    from hertzwerk.runtime.model import Model

EPS = 2.0**-52


@dataclass(frozen=True)
class Flow:
    """Two CasADi functions of (t, y, mode (k), m, c).

    rates:  dy/dt (ny)
    ends:   dy/dt; gap, gap rate, gap acceleration (k each); raw normal force and its rate along the flow (k each, 0 unless in contact); in_range (k)
    """

    rates: Any
    ends: Any

    def at(self, t: Any, y: Any, mode: Any, m: Any, c: Any) -> dict[str, Any]:
        """Results of `ends` by name."""
        return dict(zip(self.ends.name_out(), self.ends.call([t, y, mode, m, c]), strict=True))


def flow(model: Model, *, contacts: bool) -> Flow:
    """Right-hand side of a model; without `contacts` no contact force is evaluated at all, whatever the modes."""
    t, q, u, z = ca.SX.sym("t"), ca.SX.sym("q", model.nq), ca.SX.sym("u", model.nu), ca.SX.sym("z", model.nz)
    mode, m, c = ca.SX.sym("mode", model.k), ca.SX.sym("m", model.nm), ca.SX.sym("c", model.nc)
    y = ca.vertcat(q, u, z)
    f = model.function("applied")(t, q, u, c)
    dz = ca.SX.zeros(model.nz)
    forces, in_range = ca.SX.zeros(model.k), ca.SX.ones(model.k)
    if contacts:
        for j, (pair, _) in enumerate(model.module.PAIRS):
            active = mode[j] == CONTACT
            f_j, dz_j, normal, _, valid = model.function(f"contact_{pair}")(t, q, u, z, m, c)
            f += ca.if_else(active, f_j, 0)
            dz += ca.if_else(active, dz_j, 0)
            forces[j] = ca.if_else(active, normal, 0)
            in_range[j] = ca.if_else(active, valid, 1)
    dq = model.function("coordinate_rates")(t, q, u, c)
    a, reactions = model.function("accelerations")(t, q, u, f, c)
    if model.has_ledger:
        dz += model.function("ledger")(t, q, u, reactions, c)
    dy = ca.vertcat(dq, a, dz)
    gap, gap_rate = model.function("gaps")(t, q, u, c)
    gap_acceleration = model.function("gap_accelerations")(t, q, u, a, c)
    along = ca.jtimes(forces, ca.vertcat(t, y), ca.vertcat(1, dy)) if contacts else ca.SX.zeros(model.k)
    force_rate = ca.if_else(gap < 0, along, 0)  # at zero penetration the derivative of a root is not a number
    arguments = [t, y, mode, m, c]
    names = ["t", "y", "mode", "m", "c"]
    return Flow(
        rates=ca.Function("rates", arguments, [ca.cse(dy)], names, ["dy"]),
        ends=ca.Function(
            "ends",
            arguments,
            ca.cse([dy, gap, gap_rate, gap_acceleration, forces, force_rate, in_range]),
            names,
            ["dy", "gap", "gap_rate", "gap_acceleration", "force", "force_rate", "in_range"],
        ),
    )


def step(layouts: Layouts, table: RungeKutta, right: Flow) -> Any:
    """CasADi function (state, controls, h) -> trial: one step of h [s] from a state under its modes and latches.

    Called with a fraction of the step that was taken it is the dense output, of the method's full order.
    """
    state, controls, h = layouts.state.symbol("state"), layouts.controls.symbol("controls"), ca.SX.sym("h")
    start, run = layouts.state.split(state), layouts.controls.split(controls)
    given = (start["mode"], start["m"], run["c"])
    t, y = start["t"], start["y"]
    slopes = [start["dy"]]
    for row, node in zip(table.A[1:], table.c[1:], strict=True):
        slopes.append(right.rates(t + node * h, y + h * _weighted(row, slopes), *given))
    t1 = t + h
    y1 = y + h * _weighted(table.b, slopes)
    end = right.at(t1, y1, *given)
    slopes.append(end["dy"])
    weights = 1 / (run["accuracy"] * run["scale"] + 4 * EPS * ca.fabs(y1))
    error = _norm([_weighted(estimate.weights, slopes) * weights for estimate in table.errors], h)
    trial = layouts.trial.join({"t": t1, "y": y1, **end, "error": error})
    return ca.Function("step", [state, controls, h], [trial], ["state", "controls", "h"], ["trial"])


def _weighted(weights: tuple[float, ...], slopes: list[Any]) -> Any:
    terms = [weight * slope for weight, slope in zip(weights, slopes, strict=False) if weight]
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return total


def _norm(errors: list[Any], h: Any) -> Any:
    """Root mean square of an error estimate; of two, Hairer's combination e5^2/sqrt(e5^2 + 0.01 e3^2), which behaves as h^8."""
    squares = [ca.sumsqr(error) / error.numel() for error in errors]
    if len(squares) == 1:
        return h * ca.sqrt(squares[0])
    return h * squares[0] / ca.sqrt(squares[0] + 0.01 * squares[1] + 1e-300)
