"""Right-hand side under given modes and explicit Runge-Kutta steps of it, as CasADi functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts, active_contacts, masked
from hertzwerk.runtime.engine.integration.step.fed_friction import booked, certificate, solved
from hertzwerk.runtime.engine.integration.step.layout import (
    CONTACT,
    ENERGY_PARTS,
    EVENT_PARTS,
    GRIP_PARTS,
    PAIR_PARTS,
    layouts,
)
from hertzwerk.runtime.engine.integration.step.many_contacts import (
    contact_forces,
    energies_of_bodies,
    of_pairs,
    stored_energies,
)
from hertzwerk.runtime.engine.integration.step.projection import LOST, Closing, closing
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS, STATE, bounds
from hertzwerk.runtime.engine.integration.step.set_valued_friction import at_slips, grips, may_slip
from hertzwerk.runtime.engine.integration.step.set_valued_friction import forces as friction_forces
from hertzwerk.runtime.engine.integration.step.singular_positions import time_to_singular
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

ARGUMENTS = "t y mode m c"
"""Arguments of the functions of a step: time, state, and the pairs' modes, latches and constants."""
ENDS = "dy", *PAIR_PARTS, "in_range", *GRIP_PARTS, *EVENT_PARTS, *ENERGY_PARTS, "ahead"
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
    depends: sparsity of dy/dt by y where that of `rates` does not give it
    quadratures: last entries of y that nothing depends on
    touching, of_touching: (mode) -> pairs in contact, of many; rates and ends of these, of one argument more
    """

    rates: Any
    ends: Any
    holding: Any
    settling: Any | None = None
    closing: Closing | None = None
    quaternions: tuple[int, ...] = ()
    depends: Any = None
    quadratures: int = 0
    touching: Any | None = None
    of_touching: tuple[Any, Any] | None = None

    @property
    def dependence(self) -> Any:
        """Sparsity of dy/dt by y."""
        return self.rates.jac_sparsity(0, 1) if self.depends is None else self.depends

    def under(self, mode: Any) -> tuple[Any, Any]:
        """Return rates and ends for many calls under the same modes, whose contacts are found once."""
        if self.touching is None or self.of_touching is None:
            return self.rates, self.ends
        rates, ends, touching = *self.of_touching, self.touching(mode)
        return lambda *arguments: rates(*arguments, touching), lambda *arguments: ends(*arguments, touching)

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

    def symbols(self, kind: Any) -> dict[str, Any]:
        """Return symbols of the results of `ends` by name."""
        return {name: kind.sym(name, self.ends.size1_out(i)) for i, name in enumerate(ENDS)}

    def at(self, t: Any, y: Any, mode: Any, m: Any, c: Any) -> dict[str, Any]:
        """Return the results of `ends` by name."""
        return dict(zip(ENDS, self.ends(t, y, mode, m, c), strict=True))


def flow(model: EngineModel, contacts: Contacts = BY_MODE) -> Flow:
    """Return the right-hand side of a model with the forces of these contacts."""
    if calls_parts(model) and contacts in (BY_MODE, ()):
        return _flow_of_calls(model, contacts)
    return written_flow(model, contacts)


def calls_parts(model: EngineModel) -> bool:
    """Return whether the right-hand side calls its parts, contacts as vectors: pays off for many."""
    return (
        layouts(model).kind is ca.MX
        and not (model.nl or model.ne or model.loads or model.worn)
        and contact_forces(model) is not None
    )


@per_model
def _flow_of_calls(model: EngineModel, contacts: Contacts) -> Flow:
    """Build the right-hand side from functions that it calls, of contacts by the pairs that touch."""
    t, y, mode, _, c = arguments = model.symbols(ARGUMENTS, ca.MX)
    q, u, _ = model.parts(y)
    at, none = (t, q, u, c), ca.DM(0, 1)
    nf = model.function("applied").numel_out(0)
    forces = contact_forces(model) if contacts is BY_MODE else None
    touching = ca.MX.sym("touching", forces.touching.numel_out(0) if forces is not None else 0)
    with_touching = [*arguments, touching]

    def motion(pushed: Any, dz: Any) -> tuple[Any, Any, Any]:
        f = model.function("applied")(*at) + pushed
        a, reactions, *_ = model.function("accelerations").call([t, q, u, f, c])
        if model.has_ledger:
            dz = dz + model.function("ledger")(t, q, u, reactions, c)
        return ca.vertcat(model.coordinate_rates(t, q, u, f, c), a, dz), a, reactions

    dy, a, reactions = motion(ca.DM(0), ca.DM.zeros(model.nz))
    normal = rate = stored = ca.DM.zeros(model.k)
    in_range, quadratures, depends = ca.DM.ones(model.nr), model.nz, ca.DM(nf + model.nz, y.numel())
    gap, gap_rate = of_pairs(model, "gaps")(*at)
    rates = dy
    if forces is not None:
        now = touching[0], *with_touching
        rates, *_ = motion(*forces.pushes(*now))
        pushed, dz, normal, in_range = forces.contacts(*now)
        dy, a, reactions = motion(pushed, dz)
        # at zero penetration the derivative of a root is not a number
        rate = ca.if_else(gap < 0, forces.rates(*now, dy), 0)
        if model.has_ledger:
            stored = ca.if_else(mode == CONTACT, stored_energies(model)(*at), 0)
        quadratures, depends = (0 if forces.reads_memory else model.nz), forces.depends
    energies: list[Any] = [none] * 2
    if model.has_ledger:
        kinetic, potential = energies_of_bodies(model)(*at)
        energies = [kinetic, potential + ca.sum1(stored)]
    by_y = motion(*ca.vertsplit(ca.mtimes(depends, y), [0, nf, nf + model.nz]))[0]
    pair_parts = [gap, gap_rate, of_pairs(model, "gap_accelerations")(t, q, u, a, c), normal, rate, in_range]
    ends = [dy, *pair_parts, *[none] * (len(GRIP_PARTS) + len(EVENT_PARTS)), *energies, none]

    def function(name: str, results: list[Any], outputs: Sequence[str], arguments: list[Any] = arguments) -> Any:
        names = [*ARGUMENTS.split(), "touching"][: len(arguments)]
        return ca.Function(name, arguments, [ca.densify(ca.MX(x)) for x in results], names, [*outputs])

    of_touching = (
        function("rates_of_touching", [rates], ["dy"], with_touching),
        function("ends_of_touching", ends, ENDS, with_touching),
    )
    held = function("held_of_touching", [reactions], ["reactions"], with_touching)
    pairs = forces.touching(mode) if forces is not None else ca.DM(0, 1)
    return Flow(
        rates=function("rates", [of_touching[0](*arguments, pairs)], ["dy"]),
        ends=function("ends", of_touching[1](*arguments, pairs), ENDS),
        holding=function("holding", [none, held(*arguments, pairs)], list(HELD)),
        depends=ca.Function("depends", [y, t, c], [by_y]).jac_sparsity(0, 0),
        quaternions=model.quaternions,
        quadratures=quadratures,
        touching=forces and forces.touching,
        of_touching=of_touching,
    )


def written_flow(model: EngineModel, contacts: Contacts = BY_MODE) -> Flow:
    """Return the right-hand side with every pair written out (SX), for derivatives."""
    return _flow(model, contacts if model.k else ())  # without pairs all classes are one


@per_model
def _flow(model: EngineModel, contacts: Contacts) -> Flow:
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
        tangential, f = fed.friction, fed.f
        dz += booked(model, grip, tangential)
    elif grip is not None:
        slipping = grip.slipping()
        n = len(grip.places)
        tangential = friction_forces(model, n)(t, q, u, f, grip.along, grip.drift, slipping, grip.sticks, c)
        f += ca.mtimes(grip.along, tangential)
        dz += ca.mtimes(grip.power, tangential)
    dq = model.coordinate_rates(t, q, u, f, c)
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
    if model.worn and contacts != ():  # surfaces recede in contact
        gap_rate = ca.jtimes(gap, ca.vertcat(t, y), ca.vertcat(1, dy))
        second = ca.jtimes(gap_rate, ca.vertcat(t, y), ca.vertcat(1, dy))
        gap_acceleration = ca.if_else(gap < 0, second, gap_acceleration)
    along = ca.jtimes(forces, ca.vertcat(t, y), ca.vertcat(1, dy)) if contacts != () else ca.SX.zeros(model.k)
    force_rate = ca.if_else(gap < 0, along, 0)  # at zero penetration the derivative of a root is not a number
    if grip is not None:
        hold, grip_force[grip.places] = grip.hold(tangential, 1 if fed is None else fed.pressing)
        gaps = at_slips(model, gap, ca.SX(-1))[grip.places]
        hold_rate = ca.if_else(gaps < 0, ca.jtimes(hold, ca.vertcat(t, y), ca.vertcat(1, dy)), 0)
        sliding = grip.pace(grip.drift + ca.mtimes(grip.across, a))
        friction[grip.places] = tangential
        margin[grip.places] = ca.if_else(grip.sticks, hold, grip.pace(grip.velocity))
        margin_rate[grip.places] = ca.if_else(grip.sticks, hold_rate, sliding)
    event = model.function("margins")(t, q, u, c) if model.ne else ca.SX(0, 1)
    event_rate = ca.jtimes(event, ca.vertcat(t, y), ca.vertcat(1, dy)) if model.ne else event
    event_rounding = bounds(model.function("margins"), STATE)(t, q, u, c) if model.ne else event
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
                    *(event, event_rate, event_rounding),
                    *_energies(model, contacts, mode, (t, q, u, c)),
                    time_to_singular(model, t, q, dq, c),
                ]
            ),
            names,
            [*ENDS],
        ),
        holding=ca.Function("holding", arguments, [*(multipliers or [ca.SX(0, 1)]), reactions], names, list(HELD)),
        settling=ca.Function("settling", arguments, [margins, residuals], names, ["margins", "residuals"])
        if model.nr > model.k
        else None,
        closing=closing(model),
    )


def _energies(model: EngineModel, contacts: Contacts, mode: Any, at: tuple[Any, ...]) -> tuple[Any, Any]:
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
    details: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """Take one step of h [s] from a state under its modes and latches; return the parts of a trial.

    details: receives the last stage (an estimate of the step's end), its slope and the error weights (for
    `method_choice.suspicion`).
    """
    conditions = (start["mode"], start["m"], run["c"])
    rates, ends = right.under(start["mode"])
    t, y = start["t"], start["y"]
    cuts = [0, y.numel() - right.quadratures, y.numel()]
    slopes, (now, still) = [start["dy"]], ca.vertsplit(y, cuts)
    for row, node in zip(table.A[1:], table.c[1:], strict=True):
        moving = [ca.vertsplit(slope, cuts)[0] for slope in slopes]
        stage = ca.vertcat(_combined(now, h, row, moving), still)
        slopes.append(rates(t + node * h, stage, *conditions))
    t1 = t + h
    y1, is_closed = right.closed(t1, _combined(y, h, table.b, slopes), run)
    end = dict(zip(ENDS, ends(t1, y1, *conditions), strict=True))
    weights = 1 / (run["tolerance"] * run["scale"] + 4 * EPS * ca.fabs(y1))
    if details is not None:
        details |= {"stage": stage, "slope": slopes[-1], "weights": weights}
    slopes.append(end["dy"])
    terms = ([w * slope for w, slope in zip(of.weights, slopes, strict=False) if w] for of in table.errors)
    errors = (right.tangential_error(t1, y1, _sum(each), run) for each in terms)
    error = _norm([error * weights for error in errors], h, of_each=end["margin"].numel() > 0)
    return {"t": t1, "y": y1, **end, "error": right.error(error, is_closed)}


def short_step(
    right: Flow, start: Mapping[str, Any], end: Mapping[str, Any], run: Mapping[str, Any], delta: Any, jumps: Any = None
) -> dict[str, Any]:
    """Continue from a step's end by a short delta [s] with the classical Runge-Kutta method of order 4.

    Return the parts of a trial without its error: delta is too short for one that counts. jumps: 1 where a force ends with a jump at the
    surface that the step is led to, so that rates are those of a place before it, as far from it as the middle of the move.
    """
    conditions = (start["mode"], start["m"], run["c"])
    rates, ends = right.under(start["mode"])
    t, y, k1 = end["t"], end["y"], end["dy"]
    k2 = rates(t + delta / 2, y + delta / 2 * k1, *conditions)
    k3 = rates(t + delta / 2, y + delta / 2 * k2, *conditions)
    k4 = rates(t + delta, y + delta * k3, *conditions)
    moved = y + delta / 6 * (k1 + 2 * (k2 + k3) + k4)
    if jumps is not None:
        before = delta - ca.fabs(delta) / 2
        moved = ca.if_else(jumps, y + delta * rates(t + before, y + before * k1, *conditions), moved)
    y1, _ = right.closed(t + delta, moved, run)
    return {"t": t + delta, "y": y1, **dict(zip(ENDS, ends(t + delta, y1, *conditions), strict=True))}


def unit_quaternions(y: Any, first: tuple[int, ...]) -> Any:
    """Normalise the quaternions (four entries from each row in `first`) of a column.

    Done once per step: the derived rotation matrices need the norm 1, and a step's departure from it is of the order
    of its error.
    """
    if not first:
        return y
    y = type(y)(y)
    rows = [[i + k for i in first] for k in range(4)]
    a, b, c, d = (y[of] for of in rows)
    norm = ca.sqrt(a * a + b * b + c * c + d * d)
    for of, part in zip(rows, (a, b, c, d), strict=True):
        y[of] = part / norm
    return y


def _combined(y: Any, h: Any, weights: tuple[float, ...], slopes: list[Any]) -> Any:
    """Return y + h sum(weights * slopes), with the last slope added last to shorten the dependency chain."""
    *older, last = (i for i, weight in enumerate(weights) if weight)
    if older:
        y = y + h * _sum([weights[i] * slopes[i] for i in older])
    return y + h * weights[last] * slopes[last]


def _sum(terms: list[Any]) -> Any:
    """Sum pairwise: independent additions, and rounding grows with the logarithm of the number of terms."""
    while len(terms) > 1:
        pairs = [a + b for a, b in zip(terms[::2], terms[1::2], strict=False)]
        terms = pairs + terms[2 * len(pairs) :]
    return terms[0]


def _norm(errors: list[Any], h: Any, *, of_each: bool) -> Any:
    """Return the root mean square of an error estimate.

    Two estimates are combined as e5^2/sqrt(e5^2 + 0.01 e3^2), which behaves as h^8 (Hairer, dop853): their norms or, with set-valued
    friction, each entry. Of norms a large e3 of what is smooth, a ball that spins, hides the e5 of what is stiff, its contact at rest:
    stable steps grew to three times that limit, and left errors of 300 tolerances.
    """
    if len(errors) == 1 or of_each:
        error, *others = errors
        for other in others:
            error = error * error / ca.sqrt(error * error + 0.01 * other * other + 1e-300)
        return h * ca.sqrt(ca.sumsqr(error) / min(error.numel(), MEAN_OF))
    squares = [ca.sumsqr(error) / min(error.numel(), MEAN_OF) for error in errors]
    return h * squares[0] / ca.sqrt(squares[0] + 0.01 * squares[1] + 1e-300)
