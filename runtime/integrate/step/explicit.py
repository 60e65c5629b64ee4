"""Right-hand side under given modes and explicit Runge-Kutta steps of it, as CasADi functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.step.classes import BY_MODE, Contacts, active_contacts, masked
from hertzwerk.runtime.integrate.step.closing import LOST, Closing, closing
from hertzwerk.runtime.integrate.step.fed_friction import booked, certificate, solved
from hertzwerk.runtime.integrate.step.layout import CONTACT, ENERGY_PARTS, EVENT_PARTS, GRIP_PARTS, PAIR_PARTS, layouts
from hertzwerk.runtime.integrate.step.many_contacts import (
    contact_sum,
    energies_of_bodies,
    force_rates,
    of_pairs,
    stored_energies,
)
from hertzwerk.runtime.integrate.step.rounding import EPS
from hertzwerk.runtime.integrate.step.set_valued_friction import at_slips, grips, may_slip
from hertzwerk.runtime.integrate.step.set_valued_friction import forces as friction_forces
from hertzwerk.runtime.integrate.step.singular import time_to_singular
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.tableaux.explicit_tableaux import RungeKutta
    from hertzwerk.runtime.model.model import Model

ARGUMENTS = "t y mode m c"
"""Arguments of the functions of a step: time, state, and the pairs' modes, latches and constants."""
HELD = "multipliers", "reactions"
SETTLED = 1e-9  # largest relative residual of a solved reaction
MEAN_OF = 8  # most entries an error is averaged over: many bodies without error must not hide the two that collide


@dataclass(frozen=True, eq=False)
class Flow:
    """CasADi functions of (t, y, mode (k), m, c): the right-hand side and the quantities of a step's end.

    rates:  dy/dt (ny)
    ends:   dy/dt; gap, gap rate, gap acceleration (k each); raw normal force and its rate along the flow (k each, 0
            unless in contact); in_range (k, and 1 of loads by reactions, if any); of the pairs with set-valued
            friction (ns each, 0 unless in contact): force along the tangent, margin, its rate, size of the forces; of the effects'
            events (ne): margin [1] and its rate [1/s]; kinetic and potential energy (1 each, none without a ledger),
            touching surfaces included; time to a singular position (1, none in a tree)
    holding: constraint forces of the loops (nl) [N or N m]; forces of drives, and reactions that loads read
    settling: margins of uniqueness of these reactions, and of set-valued friction that they press, and residuals of their solution;
            None without such loads
    """

    rates: Any
    ends: Any
    holding: Any
    settling: Any | None = None
    closing: Closing | None = None
    quaternions: tuple[int, ...] = ()

    def closed(self, t: Any, y: Any, run: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the state with closed loops and unit quaternions, and whether the loops are closed."""
        y, is_closed = (y, ca.SX(1)) if self.closing is None else self.closing(t, y, run)
        return unit_quaternions(y, self.quaternions), is_closed

    def tangential_error(self, t: Any, y: Any, error: Any, run: Mapping[str, Any]) -> Any:
        """Return the part of a step's error (ny) that remains once the loops are closed.

        Near a singular position most of the error is off the constraints.
        """
        return error if self.closing is None else self.closing.along(t, y, error, run["c"])

    def error(self, error: Any, is_closed: Any) -> Any:
        """Return the error norm of a step; LOST if its end does not close the loops."""
        return error if self.closing is None else ca.if_else(is_closed, error, LOST)

    def at(self, t: Any, y: Any, mode: Any, m: Any, c: Any) -> dict[str, Any]:
        """Return the results of `ends` by name."""
        return dict(zip(self.ends.name_out(), self.ends.call([t, y, mode, m, c]), strict=True))


def flow(model: Model, contacts: Contacts = BY_MODE) -> Flow:
    """Return the right-hand side of a model with the forces of these contacts."""
    if calls_parts(model) and contacts in (BY_MODE, ()):
        return _flow_of_calls(model, contacts)
    return _flow(model, contacts if model.k else ())  # without pairs all classes are one


def calls_parts(model: Model) -> bool:
    """Return whether the right-hand side calls its parts, contacts as vectors: pays off for many."""
    return layouts(model).kind is ca.MX and not (model.nl or model.ne or model.loads) and contact_sum(model) is not None


@per_model
def _flow_of_calls(model: Model, contacts: Contacts) -> Flow:
    t, y, mode, m, c = given = model.symbols(ARGUMENTS, ca.MX)
    q, u, _ = model.parts(y)
    at = t, q, u, c
    f, dz = model.function("applied")(*at), ca.DM.zeros(model.nz)
    forces, rate, in_range = ca.DM.zeros(model.k), ca.DM.zeros(model.k), ca.DM.ones(model.nr)
    if contacts is BY_MODE:
        pushed, dz, forces, in_range = contact_sum(model)(*given)
        f = f + pushed
    a, reactions, *_ = model.function("accelerations").call([t, q, u, f, c])
    if model.has_ledger:
        dz = dz + model.function("ledger")(t, q, u, reactions, c)
    dy = ca.vertcat(model.function("coordinate_rates")(*at), a, dz)
    gap, gap_rate = of_pairs(model, "gaps")(*at)
    if contacts is BY_MODE:  # at zero penetration the derivative of a root is not a number
        rate = ca.if_else(gap < 0, force_rates(model)(t, y, dy, mode, m, c), 0)
    energies: list[Any] = [ca.DM(0, 1)] * 2
    if model.has_ledger:
        kinetic, potential = energies_of_bodies(model)(*at)
        stored = ca.if_else(mode == CONTACT, stored_energies(model)(*at), 0) if contacts is BY_MODE else ca.DM(0)
        energies = [kinetic, potential + ca.sum1(stored)]
    none = ca.DM(0, 1)

    def function(name: str, results: list[Any], outputs: list[str]) -> Any:
        return ca.Function(name, given, [ca.densify(ca.MX(x)) for x in results], ARGUMENTS.split(), outputs)

    pair_parts = [gap, gap_rate, of_pairs(model, "gap_accelerations")(t, q, u, a, c), forces, rate, in_range]
    ends = [dy, *pair_parts, *[none] * (len(GRIP_PARTS) + len(EVENT_PARTS)), *energies, none]
    end_names = ["dy", *PAIR_PARTS, "in_range", *GRIP_PARTS, *EVENT_PARTS, *ENERGY_PARTS, "ahead"]
    return Flow(
        quaternions=model.quaternions,
        rates=function("rates", [dy], ["dy"]),
        ends=function("ends", ends, end_names),
        holding=function("holding", [none, reactions], list(HELD)),
    )


@per_model
def _flow(model: Model, contacts: Contacts) -> Flow:
    t, q, u, z, mode, m, c = model.symbols("t q u z mode m c")
    y = ca.vertcat(q, u, z)
    f = model.function("applied")(t, q, u, c)
    dz = ca.SX.zeros(model.nz)
    forces, in_range = ca.SX.zeros(model.k), ca.SX.ones(model.nr)
    for j, contact, active in active_contacts(model, contacts, mode):
        f_j, dz_j, normal, _, valid, *_ = contact(t, q, u, z, m, c)
        f += masked(active, f_j)
        dz += masked(active, dz_j)
        forces[j] = masked(active, normal)
        in_range[j] = masked(active, valid, 1)
    friction, margin, margin_rate, grip_force = (ca.SX.zeros(model.ns) for _ in range(4))
    grip = grips(model, contacts, t, y, mode, m, c) if may_slip(model, contacts) else None
    fed = None
    if grip is not None and model.fed:
        fed = solved(model, grip, t, q, u, f, c)
        found, f = fed.friction, fed.f
        dz += booked(model, grip, found)
    elif grip is not None:
        slipping = grip.slipping()
        n = len(grip.places)
        found = friction_forces(model, n)(t, q, u, f, grip.along, grip.drift, slipping, grip.sticks, c)
        f += ca.mtimes(grip.along, found)
        dz += ca.mtimes(grip.power, found)
    dq = model.function("coordinate_rates")(t, q, u, c)
    a, reactions, *multipliers = model.function("accelerations").call([t, q, u, f, c])
    if model.has_ledger:
        dz += model.function("ledger")(t, q, u, reactions, c)
    margins = residuals = ca.SX(0, 1)
    if model.loads:
        margins, residuals = model.function("settling")(t, q, u, f, c)
        in_range[model.k] = ca.logic_and(ca.mmin(margins) > 0, ca.mmax(ca.fabs(residuals)) < SETTLED)
    if grip is not None and fed is not None:
        unique = certificate(model, grip, t, q, u, reactions, c)
        in_range[model.k] *= reduce(ca.logic_and, (margin > 0 for margin in ca.vertsplit(unique)), fed.settled)
        margins = ca.vertcat(margins, unique, ca.repmat(fed.settled, model.ns))
    dy = ca.vertcat(dq, a, dz)
    gap, gap_rate = model.function("gaps")(t, q, u, c)
    gap_acceleration = model.function("gap_accelerations")(t, q, u, a, c)
    along = ca.jtimes(forces, ca.vertcat(t, y), ca.vertcat(1, dy)) if contacts != () else ca.SX.zeros(model.k)
    force_rate = ca.if_else(gap < 0, along, 0)  # at zero penetration the derivative of a root is not a number
    if grip is not None:
        hold, grip_force[grip.places] = grip.hold(found, 1 if fed is None else fed.pressing)
        gaps = at_slips(model, gap, ca.SX(-1))[grip.places]
        hold_rate = ca.if_else(gaps < 0, ca.jtimes(hold, ca.vertcat(t, y), ca.vertcat(1, dy)), 0)
        sliding = grip.pace(grip.drift + ca.mtimes(grip.across, a))
        friction[grip.places] = found
        margin[grip.places] = ca.if_else(grip.sticks, hold, grip.pace(grip.velocity))
        margin_rate[grip.places] = ca.if_else(grip.sticks, hold_rate, sliding)
    event = model.function("margins")(t, q, u, c) if model.ne else ca.SX(0, 1)
    event_rate = ca.jtimes(event, ca.vertcat(t, y), ca.vertcat(1, dy)) if model.ne else event
    arguments, names = [t, y, mode, m, c], ARGUMENTS.split()
    return Flow(
        quaternions=model.quaternions,
        rates=ca.Function("rates", arguments, [ca.cse(dy)], names, ["dy"]),
        ends=ca.Function(
            "ends",
            arguments,
            ca.cse(
                [
                    dy,
                    *(gap, gap_rate, gap_acceleration, forces, force_rate, in_range),
                    *(friction, margin, margin_rate, grip_force),
                    *(event, event_rate),
                    *_energies(model, contacts, mode, (t, q, u, c)),
                    time_to_singular(model, t, q, dq, c),
                ]
            ),
            names,
            ["dy", *PAIR_PARTS, "in_range", *GRIP_PARTS, *EVENT_PARTS, *ENERGY_PARTS, "ahead"],
        ),
        holding=ca.Function("holding", arguments, [*(multipliers or [ca.SX(0, 1)]), reactions], names, list(HELD)),
        settling=ca.Function("settling", arguments, [margins, residuals], names, ["margins", "residuals"])
        if model.nr > model.k
        else None,
        closing=closing(model),
    )


def _energies(model: Model, contacts: Contacts, mode: Any, at: tuple[Any, ...]) -> tuple[Any, Any]:
    """Return kinetic and potential energy [J] at (t, q, u, c), springs and touching surfaces included."""
    if not model.has_ledger:
        return ca.SX(0, 1), ca.SX(0, 1)
    kinetic, potential, stored = model.function("energy")(*at)
    touching = (masked(active, stored[j]) for j, _, active in active_contacts(model, contacts, mode))
    return kinetic, potential + sum(touching, ca.SX(0))


def explicit_step(
    table: RungeKutta,
    right: Flow,
    start: Mapping[str, Any],
    run: Mapping[str, Any],
    h: Any,
    seen: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """Take one step of h [s] from a state under its modes and latches; return the parts of a trial.

    seen: receives the last stage (an estimate of the step's end), its slope and the error weights (for
    `choose.suspicion`).
    """
    given = (start["mode"], start["m"], run["c"])
    t, y = start["t"], start["y"]
    slopes = [start["dy"]]
    for row, node in zip(table.A[1:], table.c[1:], strict=True):
        stage = _combined(y, h, row, slopes)
        slopes.append(right.rates(t + node * h, stage, *given))
    t1 = t + h
    y1, is_closed = right.closed(t1, _combined(y, h, table.b, slopes), run)
    end = right.at(t1, y1, *given)
    weights = 1 / (run["tolerance"] * run["scale"] + 4 * EPS * ca.fabs(y1))
    if seen is not None:
        seen |= {"stage": stage, "slope": slopes[-1], "weights": weights}
    slopes.append(end["dy"])
    errors = (right.tangential_error(t1, y1, _weighted(estimate.weights, slopes), run) for estimate in table.errors)
    error = _norm([error * weights for error in errors], h)
    return {"t": t1, "y": y1, **end, "error": right.error(error, is_closed)}


def short_step(
    right: Flow, start: Mapping[str, Any], end: Mapping[str, Any], run: Mapping[str, Any], delta: Any
) -> dict[str, Any]:
    """Continue from a step's end by a short delta [s] with the classical Runge-Kutta method of order 4.

    Return the parts of a trial without its error: delta is too short for one that counts.
    """
    given = (start["mode"], start["m"], run["c"])
    t, y, k1 = end["t"], end["y"], end["dy"]
    k2 = right.rates(t + delta / 2, y + delta / 2 * k1, *given)
    k3 = right.rates(t + delta / 2, y + delta / 2 * k2, *given)
    k4 = right.rates(t + delta, y + delta * k3, *given)
    y1, _ = right.closed(t + delta, y + delta / 6 * (k1 + 2 * (k2 + k3) + k4), run)
    return {"t": t + delta, "y": y1, **right.at(t + delta, y1, *given)}


def unit_quaternions(y: Any, first: tuple[int, ...]) -> Any:
    """Normalise the quaternions (four entries from each row in `first`) of an SX column.

    Done once per step: the derived rotation matrices need the norm 1, and a step's departure from it is of the order
    of its error.
    """
    if not first:
        return y
    parts = ca.vertsplit(y)
    for i in first:
        four = ca.vertcat(*parts[i : i + 4])
        parts[i : i + 4] = ca.vertsplit(four / ca.sqrt(ca.sumsqr(four)))
    return ca.vertcat(*parts)


def _combined(y: Any, h: Any, weights: tuple[float, ...], slopes: list[Any]) -> Any:
    """Return y + h sum(weights * slopes), with the last slope added last to shorten the dependency chain."""
    *older, last = (i for i, weight in enumerate(weights) if weight)
    if older:
        y = y + h * _sum([weights[i] * slopes[i] for i in older])
    return y + h * weights[last] * slopes[last]


def _weighted(weights: tuple[float, ...], slopes: list[Any]) -> Any:
    return _sum([weight * slope for weight, slope in zip(weights, slopes, strict=False) if weight])


def _sum(terms: list[Any]) -> Any:
    """Sum pairwise: independent additions, and rounding grows with the logarithm of the number of terms."""
    while len(terms) > 1:
        pairs = [a + b for a, b in zip(terms[::2], terms[1::2], strict=False)]
        terms = pairs + terms[2 * len(pairs) :]
    return terms[0]


def _norm(errors: list[Any], h: Any) -> Any:
    """Return the root mean square of an error estimate.

    Two estimates are combined as e5^2/sqrt(e5^2 + 0.01 e3^2), which behaves as h^8 (Hairer, dop853).
    """
    squares = [ca.sumsqr(error) / min(error.numel(), MEAN_OF) for error in errors]
    if len(squares) == 1:
        return h * ca.sqrt(squares[0])
    return h * squares[0] / ca.sqrt(squares[0] + 0.01 * squares[1] + 1e-300)
