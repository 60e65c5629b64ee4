"""`method="auto"`: explicit steps, and implicit ones where stability, not accuracy, limits the step.

The measure is the controller's step times the fastest rate of the motion, a sum over eigenvalues that the traces of
the Jacobian give without computing any: damping -tr J, vibration sqrt(-tr(df/dq dq'/du)). An explicit step is stable
up to a few times 1; accuracy alone keeps it below that. A velocity that jumps across the layer in which smoothed
friction reverses is stiff too, though no Jacobian shows it: the layer is thinner than the tolerance.

A run begins with explicit steps alone, at their cost: no Jacobian, nothing implicit is built. The difference of the
last two stages of a step estimates the fastest rates in a few operations. Where that stays stiff, step after step,
the run continues with steps that choose, until explicit ones are no longer stiff. Where explicit steps are rejected again
and again and time stands still, nothing shows stiffness, and the loop (`chunk`) turns to implicit ones. Implicit steps cost more than
explicit ones: where they do not save as many, the run goes back, and is the more wary the more often.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.loop.turning_slip import PASSING
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.implicit_step import fraction_to_rest, linearised, sliding
from hertzwerk.runtime.engine.integration.step.layout import CALM, SUSPECT, layouts
from hertzwerk.runtime.engine.model.model import EngineModel

EXPLICIT, IMPLICIT = 0.0, 1.0  # the state's `method`
STIFF = 3.0  # step x rate: an explicit method of order 5 is stable up to 3.3, of order 8 up to 6
WORTH = 10.0  # step x rate of an implicit step that is worth its cost: that of about three explicit ones
MOST = 3.0  # gain of one implicit step, as a part of its cost
REVERSAL = 2.0  # weight of a step across a friction reversal, in stiff steps
PATIENCE = 10.0  # stiff steps, less the others, before the method changes; implicit steps lost before it changes back
CREDIT = 20.0  # the same after implicit steps that paid: it takes a dozen short ones to enter a thin layer of friction
WARY = 3.0  # times as many before the next change, where implicit steps were not worth their cost
MOST_WARY = 1e9  # times as many at most: more attempts than any run makes
# The same by what stages differ by: of 21 scenes at 1e-5 and 1e-8 those with nothing stiff get to 18 at most, the others to more than 250.
SUSPICIOUS = 20.0


class Choosing(Enum):
    """Choice of method by a step: none, watch for stiffness, choose in every step."""

    NONE = "none"
    ON_SUSPICION = "on suspicion"
    EVERY_STEP = "every step"


def choice(
    model: EngineModel,
    contacts: Contacts,
    old: Mapping[str, Any],
    run: Mapping[str, Any],
    end: Mapping[str, Any],
    h: Any,
    J: Any = None,
) -> dict[str, Any]:
    """Return the state's choice and `status` after a plain step from `old` to `end`.

    h [s]: the step to continue with.
    """
    conditions = (old["mode"], old["m"], run["c"])
    if J is None:
        J, _ = linearised(model, contacts)(old["t"], old["y"], *conditions)
    stiffness = h * _rate(J, model.nq, model.nu)
    slides = sliding(model, contacts)
    v, rate, gradient = slides(old["t"], old["y"], old["dy"], *conditions)
    v1, rate1, _ = slides(end["t"], end["y"], end["dy"], *conditions)
    foreseen = old["h"] * ca.mtimes(gradient, ca.mtimes(J, old["dy"]))
    turned = ca.mmin(fraction_to_rest(v, rate, foreseen, v1, rate1, old["h"])) < 1 if v.numel() else ca.DM(0)
    implicit, wary = old["method"] == IMPLICIT, old["wary"]
    gain = ca.if_else(turned, 1, ca.fmin(stiffness / WORTH - 1, MOST))
    pays = implicit * (old["pressure"] + gain > CREDIT)
    against = ca.if_else(turned, REVERSAL, ca.if_else(stiffness > STIFF, 1, -1))
    pressure = ca.fmax(old["pressure"] + ca.if_else(implicit, gain, against), 0)
    stays = ca.if_else(implicit, pressure > 0, pressure >= PATIENCE)
    given_up = implicit * (1 - stays) * (old["pressure"] != PASSING)
    warier = ca.fmin(WARY * (1 + wary) - 1, MOST_WARY)
    wary = ca.if_else(given_up, warier, ca.if_else(pays, ca.fmax((1 + wary) / WARY - 1, 0), wary))
    return {
        "method": ca.if_else(stays, IMPLICIT, EXPLICIT),
        "pressure": ca.fmin(pressure, ca.if_else(implicit, CREDIT, PATIENCE)),
        "wary": wary,
        "status": ca.if_else(stays + pressure > 0, old["status"], CALM),
        "stiffness": stiffness,
    }


def suspicion(
    model: EngineModel,
    contacts: Contacts,
    old: Mapping[str, Any],
    run: Mapping[str, Any],
    end: Mapping[str, Any],
    to_continue: Any,
    details: Mapping[str, Any],
) -> dict[str, Any]:
    """Return the state's `pressure` and `status` after an explicit step, by its last two stages.

    kept [s]: the step to continue with, by which a step is judged that was cut to an event which did not come: beyond the limit of
    stability a damped force swings to and fro through zero, and the steps cut to that are stable.

    Both stages are at the end of the step. Their accelerations differ by the reaction of stiff forces to their
    difference in speed (damping) or position (vibration). In a motion that limits the step by accuracy the smaller of
    the two rates is seldom large; after Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.2. A
    state of an effect is differentiated instead: what drives it, as a jolted shaft does a motor's current, changes its
    rate by more than the state itself does.
    """
    nq, n = model.nq, model.nq + model.nu
    depends = ca.DM.ones(flow(model, contacts).dependence)
    reacting, fading = depends[nq:n, :], any(depends[i, i].nnz() for i in range(nq))  # states of effects
    if not (reacting.nnz() or fading):  # a free flight: both rates are zero, and stages need no position
        return {"pressure": ca.fmax(old["pressure"] - 1, 0)}
    # what no acceleration depends on is computed in no stage but for this
    free = [not reacting[:, i].nnz() for i in range(n)]
    positions = [i for i in range(nq) if not free[i]] or list(range(nq))
    speeds = [i for i in range(nq, n) if not free[i]] or list(range(nq, n))
    accelerated = [nq + i for i in range(model.nu) if reacting[i, :].nnz()]
    position, speed, acceleration = (
        ca.sumsqr((end[name][part] - details[of][part]) * details["weights"][part])
        for name, of, part in (("y", "stage", positions), ("y", "stage", speeds), ("dy", "slope", accelerated))
    )
    h = ca.if_else(old["retakes"] > 0, to_continue, old["h"]) if model.k else old["h"]
    h2, (length, pace) = h * h, ca.vertsplit(run["scales"][:2])
    damping = h2 * acceleration > STIFF**2 * speed
    vibration = h2 * h2 * acceleration * (pace * pace) > STIFF**4 * position * (length * length)
    stiff = damping * vibration
    if fading:
        stiff = stiff + (h * _fading(model, end, run) > STIFF) > 0
    pressure = ca.fmax(old["pressure"] + ca.if_else(stiff, 1, -1), 0)
    return {
        "pressure": pressure,
        "status": ca.if_else(pressure >= SUSPICIOUS * (1 + old["wary"]), SUSPECT, old["status"]),
    }


def _fading(model: EngineModel, end: Mapping[str, Any], run: Mapping[str, Any]) -> Any:
    """Return the summed rates [1/s] at which effects' states fade by themselves: their part of -tr J."""
    t, q, u, c = model.symbols("t q u c")
    rates = model.function("coordinate_rates")(t, q, u, c)
    own = sum(ca.jacobian(rates[i], q[i]) for i in range(model.nq))
    at = (end["t"], *model.parts(end["y"])[:2], run["c"])
    return -ca.Function("own", [t, q, u, c], [own])(*at)


def fastest(model: EngineModel) -> Any:
    """Build the function (state, controls) -> step times fastest rate, and sliding velocities [m/s]."""
    arguments, (old, run) = layouts(model).symbols("state controls")
    at = (old["mode"], old["m"], run["c"])
    J, _ = linearised(model)(old["t"], old["y"], *at)
    v, *_ = sliding(model, BY_MODE)(old["t"], old["y"], old["dy"], *at)
    results = ca.densify(ca.vertcat(old["h"] * _rate(J, model.nq, model.nu), v))
    return ca.Function("fastest", arguments, [ca.cse(results)], ["state", "controls"], ["found"])


def _rate(J: Any, nq: int, nu: int) -> Any:
    """Return the fastest rate [1/s]: summed damping rates or root of the summed squared frequencies.

    The larger of both; 0 without damping and vibration.
    """
    others = [i for i in range(J.size1()) if not nq <= i < nq + nu]  # coordinates, and bristles
    vibration = ca.trace(ca.mtimes(J[nq : nq + nu, others], J[others, nq : nq + nu]))
    # of two zeros of unlike sign a compiler may choose either
    return ca.fabs(ca.fmax(-ca.trace(J), ca.sqrt(ca.fmax(-vibration, 0))))
