"""Contacts of a run: onset, duration, largest force and penetration, found within the steps."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.events.cubics import crest_of_cubic
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import NearModel
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT
from hertzwerk.runtime.engine.integration.step.set_valued_friction import slips_in
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
    from hertzwerk.runtime.engine.solution.history import History

PEAK = 2e-4  # of a step: last move of a root, over which the value is followed by its rate, to about 1e-9
TRIES = (4, 8)  # most iterations, nested: groups of them, and iterations of a group
RANKINGS = 2  # of each kind: by the values at rows, and by the crests of cubics between them
KINDS = (("force", "force_rate", +1), ("gap", "gap_rate", -1))  # sign * part peaks: normal force and penetration


class Impact(NamedTuple):
    """One contact: onset t [s], approach speed [m/s], largest normal force [N], duration [s], penetration.

    duration: None if unfinished; peak_penetration [m].
    """

    contact: str
    t: float
    speed: float
    peak_force: float
    duration: float | None
    peak_penetration: float


def peaks(history: History, controls: np.ndarray, pairs: np.ndarray, tops: np.ndarray) -> np.ndarray:
    """Return the peak normal forces [N] and penetrations [m] of contacts of pairs (n,), shape (n, 2).

    The largest in the rows, or within the steps beside it and beside the largest crest of a cubic.

    controls    of the run of each (n, size); history: of any of these runs
    tops    by KINDS and RANKINGS the row of the largest value, between its neighbours (n, kinds * RANKINGS, 3, ns)
    """
    count, many, _, ns = tops.shape
    k = history.engine.model.k
    # most cubics are highest beside the highest row: these steps are looked through once
    new = np.ones((count, many), dtype=bool)
    new[:, 1::RANKINGS] = (tops[:, 1::RANKINGS, 1] != tops[:, ::RANKINGS, 1]).any(axis=2)
    contact, ranked = np.nonzero(new)
    rows, kind = tops[contact, ranked], ranked // RANKINGS
    signs = np.zeros((len(rows), 2, len(KINDS) * k))
    places = history.places(rows[:, 1], pairs[contact]) + kind * k
    signs[np.arange(len(rows)), :, places] = np.array([sign for *_, sign in KINDS])[kind, None]
    results = history.by_method(
        crest,
        *(rows[:, side].reshape(-1, ns) for side in (slice(0, 2), slice(1, 3))),
        signs.reshape(-1, signs.shape[-1]),
        controls=np.repeat(controls[contact], 2, axis=0),
    ).reshape(-1, 2, 3)
    values = np.full((count, len(KINDS)), -math.inf)
    np.maximum.at(values, (contact, kind), np.maximum(results[:, 0, 1], results[:, :, 2].max(axis=1)))
    return values


@per_model
def crest(model: EngineModel, integrator: Integrator, method: int) -> Rowwise:
    """Build the function that finds the crest of a value in the step between two rows.

    (controls, state, upper, weights) -> values at the row, at the next, and at the crest, -inf where there is none.
    `weights` (2 k) is the sign of one value among the normal forces and gaps of all pairs; of a gap the value is the
    penetration. A crest is where the rate of the value falls through zero in the step between the rows: first that of
    the cubic through values and rates of both, then by inverse quadratic interpolation, or halving where that is not
    safe (Chandrupatla, Adv. Eng. Softw. 28 (1997) 145). It is flat: where the next root is within PEAK of the step,
    the value there follows from value and rate here. A value that rises, falls and rises again, or falls first, has its crest on one
    side of the cubic's inflection, if the rate there says so too.
    """
    vectors, model = integrator.layouts, integrator.model
    sizes = {"controls": vectors.controls.size, "state": vectors.state.size, "weights": len(KINDS) * model.k}
    kind: Any = ca.MX if isinstance(model, NearModel) else ca.SX
    controls, state, weights = (kind.sym(name, size) for name, size in sizes.items())
    trial, upper = vectors.trial.symbol("trial", kind), vectors.state.symbol("upper", kind)
    old, new, end = vectors.state.split(state), vectors.state.split(upper), vectors.trial.split(trial)
    c = vectors.within(vectors.controls.split(controls), old)["c"]

    def rate(parts: dict[str, Any]) -> Any:
        of_each = ca.vertcat(*(parts[name] for _, name, _ in KINDS))
        return ca.sum1(ca.if_else(weights == 0, 0, weights * of_each))

    def value(parts: dict[str, Any], mode: Any) -> Any:
        of_each = ca.vertcat(parts["force"], penetrations(model, parts, mode, c))
        return ca.sum1(ca.if_else(weights == 0, 0, of_each))

    h = new["t"] - old["t"]
    held = [ca.vertcat(parts["mode"], parts["m"][slips_in(model)]) for parts in (old, new)]
    changed = (h != 0) * ca.mmax(held[0] != held[1])  # there the step ended otherwise
    rates = ca.vertcat(rate(old), ca.if_else(h == 0, rate(old), rate(new)))
    values = ca.vertcat(value(old, old["mode"]), value(new, new["mode"]))
    ends = ca.Function("ends", [controls, state, upper, weights], [h, changed, *ca.vertsplit(rates), values])
    at_trial = ca.Function("at_trial", [controls, state, trial, weights], [rate(end), value(end, old["mode"])])

    arguments: list[Any] = [ca.MX.sym(name, size) for name, size in {**sizes, "h": 1}.items()]
    controls, state, weights, h = arguments

    def at(h: Any) -> Any:
        return at_trial(controls, state, integrator.step(method)(state, controls, h), weights)

    taken = ca.MX.sym("taken")
    as_taken = ca.Function("as_taken", [taken, *arguments], [taken])
    rate_at = ca.Function.if_else("rate_at", ca.Function("evaluated", [taken, *arguments], [at(h)[0]]), as_taken)
    search = ca.MX.sym("search", 8)
    rate_there, value_there = at(search[6])
    known = ca.MX.sym("found")
    after, gain = _narrowed()(search, rate_there, h)
    once = ca.Function("once", [search, known, *arguments], [after, value_there + gain])
    unchanged = ca.Function("kept", [search, known, *arguments], [search, known])
    for tries in TRIES:
        searched, best = search, known
        goes_on = ca.Function.if_else("goes_on", once, unchanged)
        for _ in range(tries):
            searched, best = goes_on(searched[7], searched, best, *arguments)
        once = ca.Function("tried", [search, known, *arguments], [searched, best])
    upper = ca.MX.sym("upper", vectors.state.size)
    h, changed, at_low, at_high, values = ends(controls, state, upper, weights)
    at_high = rate_at(changed, at_high, controls, state, weights, h)
    # a force begins with no slope, or none that is known, and rises; as it ends it falls
    at_low = ca.if_else(at_low == 0, ca.fabs(at_high), at_low)
    at_high = ca.if_else(at_high == 0, -ca.fabs(at_low), at_high)
    guess, bend = _crest_and_bend()(*ca.vertsplit(values), h * at_low, h * at_high)
    at_bend = rate_at(bend > 0, 0, controls, state, weights, h * bend)
    before, behind = ((bend > 0) * side for side in (at_low > 0, at_low < 0))
    low, at_low = ca.if_else(behind, h * bend, 0), ca.if_else(behind, at_bend, at_low)
    high, at_high = ca.if_else(before, h * bend, h), ca.if_else(before, at_bend, at_high)
    within = ca.logic_and(at_low > 0, at_high < 0)
    search = ca.vertcat(low, high, high, at_low, at_high, at_high, h * guess, within)
    _, best = once(search, -math.inf, controls, state, weights, h)
    return Rowwise(ca.Function("crest", [controls, state, upper, weights], [ca.vertcat(values, best)]), constant=None)


def _crest_and_bend() -> Any:
    """Return the function that finds where a cubic peaks and where it has its inflection.

    (values and slopes at 0 and 1) -> place of both, the latter where both ends rise or fall and the peak between is above them, else 0.
    """
    start, end, rising, falling = arguments = [ca.SX.sym(name) for name in ("start", "end", "rising", "falling")]
    place, crest, bend = crest_of_cubic(ca, *arguments)
    sound = ca.logic_and(place > 0, place < 1)
    twice = sound * (rising * falling > 0) * (crest > ca.fmax(start, end)) * (bend > 0) * (bend < 1)
    place = ca.if_else(sound, place, rising / (rising - falling))
    return ca.Function("place", arguments, [place, ca.if_else(twice, bend, 0)])


def _narrowed() -> Any:
    """Return the function (search, rate at its root, h) -> search after it, gain of the value.

    That is what the value gains from this root to the next. A search is the ends of a bracket, the later one first, a
    third place, the rates at these three, a root between the ends, and whether it goes on.
    """
    search, value, h = (ca.SX.sym(name, size) for name, size in (("search", 8), ("value", 1), ("h", 1)))
    near, far, _, at_near, at_far, _, root, _ = ca.vertsplit(search)
    same = value * at_near > 0
    third, at_third = ca.if_else(same, near, far), ca.if_else(same, at_near, at_far)
    far, at_far = ca.if_else(same, far, near), ca.if_else(same, at_far, at_near)
    place, height = (root - far) / (third - far), (value - at_far) / (at_third - at_far)
    safe = ca.logic_and(height**2 < place, (1 - height) ** 2 < 1 - place)
    part = value / (at_far - value) * at_third / (at_far - at_third)
    part += (third - root) / (far - root) * value / (at_third - value) * at_far / (at_third - at_far)
    move = (far - root) * ca.if_else(safe, part, 0.5)
    goes_on = (ca.fabs(move) > PEAK * h) * (value != 0)
    after = ca.vertcat(root, far, third, value, at_far, at_third, root + move, goes_on)
    return ca.Function("narrowed", [search, value, h], [after, ca.if_else(value == 0, 0, value * move / 2)])


def penetrations(model: EngineModel, at: dict[str, Any], mode: Any, c: Any) -> Any:
    """Return the penetration of every pair [m], an expression (k,) in the parts of a state and the modes."""
    gap = distances(model, at, c)
    return ca.if_else(ca.logic_and(mode != FLIGHT, gap < 0), -gap, 0)


def distances(model: EngineModel, at: dict[str, Any], c: Any) -> Any:
    """Return the gap of every pair [m], an expression (k,) in the parts of a state.

    The event function G of round surfaces is their gap to first order only: that of two spheres is an output, that of
    a pin in a bush follows from its eccentricity; see `History`.
    """
    if isinstance(model, NearModel):
        return model.of_places("distances")(at["t"], *model.parts(at["y"])[:2], c)
    gaps = ca.vertsplit(at["gap"])
    outputs = model.function("outputs")(at["t"], at["y"][: model.nq], at["y"][model.nq : model.nq + model.nu], c)
    for j, pair in enumerate(model.pairs):
        parts = [outputs[i] for i in model.journals.get(pair, ())]
        if f"{pair}.gap" in model.outputs:
            gaps[j] = outputs[model.outputs.index(f"{pair}.gap")]
        elif parts:
            squared = sum(part * part for part in parts)
            gaps[j] = gaps[j] + ca.sqrt(gaps[j] * gaps[j] + squared) - ca.sqrt(squared)
    return ca.vertcat(*gaps)
