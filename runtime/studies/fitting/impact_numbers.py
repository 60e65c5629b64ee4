"""Numbers of a run's impacts in their order, with derivatives, as measured impacts have them.

impacts.speed                    of all contacts, in the order of their onsets; also t, peak_force, peak_penetration
floor.impacts.speed              of one pair
impacts.rebound.vertical.travel  largest value that a history reaches between an impact and the next one
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.sensitivity.sensitivities import Sensitivities
    from hertzwerk.runtime.engine.solution.solution import EngineSolution


IMPACTS = ".impacts."
OF_IMPACT = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m"}
REBOUND = "rebound."
PER_STEP = 8  # places in a step between which a largest value is sought


def impact_units(model: EngineModel) -> dict[str, str]:
    """Return the SI unit text of what impacts can be compared by, by name."""
    whats = {**OF_IMPACT, **{f"{REBOUND}{name}": unit for name, unit in units_of(model, None).items() if name != "t"}}
    return {
        f"{place}{IMPACTS}{quantity}".removeprefix("."): unit
        for place in ("", *model.pairs)
        for quantity, unit in whats.items()
    }


def parts_of(name: str) -> tuple[str, str]:
    """Return the pair, empty for all contacts, and what of its impacts a name is."""
    pair, _, quantity = f".{name}".partition(IMPACTS)
    return pair.removeprefix("."), quantity


def onsets(run: EngineSolution, name: str) -> Array:
    """Return the onsets [s] of the impacts that a name counts."""
    pair, _ = parts_of(name)
    return np.array([impact.t for impact in run.impacts if pair in ("", impact.contact)])


def of_impacts(run: EngineSolution, name: str, by: Sensitivities | None = None) -> Array:
    """Return one number of each impact (impacts,), or its derivatives (impacts, P) by all names, SI."""
    pair, quantity = parts_of(name)
    chosen = [i for i, impact in enumerate(run.impacts) if not pair or impact.contact == pair]
    if quantity.startswith(REBOUND):
        return _rebounds(run, quantity.removeprefix(REBOUND), [run.impacts[i].t for i in chosen], by)
    if by is not None:
        return np.asarray(by.along_impacts(quantity))[chosen]
    return np.array([getattr(run.impacts[i], quantity) for i in chosen], dtype=float)


def _rebounds(run: EngineSolution, history: str, onsets: list[float], by: Sensitivities | None) -> Array:
    """Return the largest values of a history between onsets [s], or their derivatives by all names.

    A largest value within an interval changes as the history does at its time. The last impact has none: the run may end before.
    """
    from scipy.optimize import minimize_scalar  # slow to import

    largest = np.full(len(onsets) if by is None else (len(onsets), len(by.names)), np.nan)
    steps = with_steps(run).t
    for i, (start, end) in enumerate(pairwise(onsets)):
        nodes = np.unique(np.concatenate([[start, end], steps[(steps > start) & (steps < end)]]))
        parts = np.arange(PER_STEP) / PER_STEP
        times = np.unique(np.concatenate([(nodes[:-1, None] + np.diff(nodes)[:, None] * parts).ravel(), [end]]))
        values = run.at(times)[history]
        top = int(np.argmax(values))
        low, high = times[max(top - 1, 0)], times[min(top + 1, len(times) - 1)]
        best = minimize_scalar(
            lambda t: -float(run.at(np.array([t]))[history][0]),
            bounds=(low, high),
            method="bounded",
            options={"xatol": 1e-9 * (end - start)},
        )
        at, value = (float(best.x), -float(best.fun)) if -best.fun > values[top] else (float(times[top]), values[top])
        if by is None:
            largest[i] = value
        elif at <= by.until:
            largest[i] = by.along(np.array([at]), history)[0]
    return largest
