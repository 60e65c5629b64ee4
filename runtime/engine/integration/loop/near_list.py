"""List of near pairs of a run: when it is made anew, and how."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import APART, NONE, NearModel, distances, near_model
from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT, RUNNING, STALE, Layouts, layouts
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table


def listing(model: EngineModel, tables: tuple[Table, ...]) -> NearModel | None:
    """Return the model by which runs of a method list near pairs; None where they list none.

    Implicit steps need derivatives of all pairs.
    """
    return near_model(model) if isinstance(tables[0], RungeKutta) else None


def keeps_to_list(model: WatchedModel, vectors: Layouts) -> Any:
    """Build the function (state, controls) -> state that keeps to list or box, or is STALE.

    A list that was just made, and is too short for the step, cuts it.
    """
    (state, controls), (old, run) = vectors.symbols("state controls")
    longest, moved = model.time_left(run, old)
    over = (old["status"] == RUNNING) * (old["h"] > longest)
    new = {
        **old,
        "status": ca.if_else(over * moved, STALE, old["status"]),
        "h": ca.if_else(over * (1 - moved), longest, old["h"]),
    }
    return ca.Function("keeps_to_list", [state, controls], [vectors.state.join(new)])


@per_model
def _renewed(model: NearModel) -> Callers:
    """Build the function (state, controls) -> state with all that follows from a new list."""
    vectors = layouts(model)
    (state, controls), (old, run) = vectors.symbols("state controls", ca.MX)
    end = flow(model).at(old["t"], old["y"], old["mode"], old["m"], run["c"])
    end.pop("in_range")
    longest, _ = model.time_left(run, old)
    new = {
        **old,
        **end,
        "h": ca.fmin(old["h"], longest),
        "status": ca.DM(RUNNING),
        "evaluations": old["evaluations"] + 1,
    }
    return Callers(ca.Function("renewed", [state, controls], [vectors.state.join(new)]))


@per_model
def _distances(model: NearModel) -> Callers:
    """Build the function (t, q, c) -> distance of all pairs of the whole model, watched centres (3 n)."""
    whole = model.whole
    t, q, c = whole.symbols("t q c", ca.MX)
    y = ca.vertcat(q, ca.DM.zeros(model.nu + model.nz))
    constants = ca.vertcat(c, ca.DM.zeros(model.npieces))
    r, _, _ = model.centres()(t, y, ca.DM.zeros(y.numel()), constants)
    return Callers(ca.Function("distances", [t, q, c], [distances(whole)(t, q, ca.DM.zeros(whole.nu), c), r]))


def constants_of(model: NearModel, c: np.ndarray, t: float, q: np.ndarray) -> np.ndarray:
    """Return the constants of a run (nc,) with a first list, from those of the whole model and a start."""
    none = np.full(model.k, NONE)
    return np.concatenate([c, *_list(model, c, t, q, none, np.zeros(model.k))])


def scale_of(model: NearModel, scale: np.ndarray) -> np.ndarray:
    """Return the scales of a state (ny,) from those of the whole model."""
    moving = model.nq + model.nu
    energies = scale[moving:]
    size = energies.max(initial=0.0)
    return np.concatenate([scale[:moving], energies[model.others], np.full(model.nz - len(model.others), size)])


def latches_of(model: NearModel, latches: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the latches of a run's places from those of all pairs; 0 for none."""
    near = c[model.whole.nc :][: model.k].astype(int)
    rows = np.array(model.whole_latches, dtype=int)[near]  # (k, latches of a pair)
    return np.where(near >= 0, latches[rows].T, 0.0).ravel()


class Departure(NamedTuple):
    """Rows of memory [J] and latches of a pair that left the list at t [s].

    Memory is summed since it was listed.
    """

    t: float
    memory: np.ndarray
    latches: np.ndarray


Departures: TypeAlias = dict[int, list[Departure]]
"""Departures of each pair of a run, in their order."""


def renewed(model: NearModel, state: np.ndarray, controls: np.ndarray, departures: Departures) -> np.ndarray:
    """Return a state with a list made anew of the pairs that are near now.

    What those had that left is noted in `departures`. Pairs that stay keep their places. Latches of one that comes back are those that it left with.
    """
    vectors = layouts(model)
    at: Mapping[str, np.ndarray] = {name: state[vectors.state[name]].copy() for name in vectors.state.sizes}
    c = controls[vectors.controls["c"]][: model.whole.nc]
    before, moving = at["pieces"][: model.k].copy(), model.nq + model.nu
    new = _list(model, c, float(at["t"][0]), at["y"][: model.nq], before, at["mode"])
    at["pieces"][:] = np.concatenate(new)
    for place in np.flatnonzero(new[0] != before).tolist():
        rows, latches = [moving + row for row in model.rows[place]], slice(place, None, model.k)
        left, come = (int(numbers[place]) for numbers in (before, new[0]))
        if left >= 0 and (np.any(at["y"][rows]) or np.any(at["m"][latches] != 1.0)):
            departure = Departure(float(at["t"][0]), at["y"][rows], at["m"][latches].copy())
            departures.setdefault(left, []).append(departure)
        for row, name in zip(rows, model.summed[place], strict=True):
            at["y"][moving + model.departed[name]] += at["y"][row]
            at["y"][row] = 0.0
        at["mode"][place] = FLIGHT
        known = departures.get(come) if come >= 0 else None
        at["m"][latches] = known[-1].latches if known else 1.0
    (found_state,) = _renewed(model)(np.concatenate([at[name] for name in vectors.state.sizes]), controls)
    return found_state


def _list(
    model: NearModel, c: np.ndarray, t: float, q: np.ndarray, before: np.ndarray, mode: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a list: numbers of pairs by place, watched centres, skin [m].

    The nearest of each family, as many as it has places; the skin is the distance of the nearest pair that is not listed.
    """
    apart, centres = _distances(model)(t, q, c)
    near, skin = before.copy(), APART
    for family in model.families:
        places = slice(family.first, family.first + family.count)
        own = apart[family.number : family.number + len(family.rows)]
        listed = near[places]
        busy = listed[mode[places] != FLIGHT].astype(int) - family.number
        own[busy] = -np.inf
        chosen = np.arange(len(own))
        if family.count < len(own):
            order = np.argpartition(own, family.count)
            chosen, skin = order[: family.count], min(skin, own[order[family.count]])
        stays = np.isin(listed - family.number, chosen)
        fresh = np.setdiff1d(chosen, listed[stays].astype(int) - family.number)
        listed[~stays] = NONE
        listed[np.flatnonzero(~stays)[: len(fresh)]] = family.number + fresh
    return near, centres, np.array([max(skin, 0.0)])
