"""Cost of scenes: operations of a right-hand side in each mode, states, event functions, run time."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.effect_study.output_errors import Bench, Case
    from hertzwerk.runtime.engine.model.model import EngineModel

FLIGHT = ("applied", "accelerations", "gaps", "gap_accelerations")  # as the header of a generated module counts them
TRIES = 3  # runs of one round
ROUNDS, TIMED = (5, 25), 1.5  # least and most rounds of timing, and the time [s] in which more are made
INTERVAL = (0.1, 0.9)  # quantiles of the shares over the rounds


@dataclass(frozen=True)
class Cost:
    """Operations of one evaluation, states and event functions of a scene.

    flight: operations of a right-hand side without contact; contact: further ones where all pairs touch; states:
    integrated ones; events: event functions of pairs that touch and of those that stick.
    """

    flight: int
    contact: int
    states: int
    events: int

    def __sub__(self, other: Cost) -> Cost:
        return Cost(*(here - there for here, there in zip(vars(self).values(), vars(other).values(), strict=True)))


def cost_of(model: EngineModel) -> Cost:
    """Return the cost of one evaluation of a model."""
    counts = dict(model.module.OPERATIONS)
    contact = sum(count for name, count in counts.items() if name.startswith("contact_"))
    states = model.nq + model.nu + model.nz
    return Cost(sum(counts.get(name, 0) for name in FLIGHT), contact, states, model.k + model.ns)


@dataclass(frozen=True)
class Share:
    """Part of the whole scene's time that an effect takes: median and interval of the rounds."""

    median: float
    low: float
    high: float

    @property
    def significant(self) -> bool:
        """Return whether the share differs from 0 by more than its scatter."""
        return self.low > 0 or self.high < 0


def shares(
    whole: Case,
    others: Mapping[str, Case],
    bench: Bench,
    *,
    compiled: bool,
    eighths: Sequence[int] = (0,),
    progress: Callable[[float], object] = lambda fraction: None,
) -> dict[str, Share]:
    """Measure the share of the whole scene's time that each of the other scenes saves.

    Runs are made in turns.

    eighths    the tolerance of each round, one after another (see `Bench`): several beyond the horizon, so that the shares scatter as the runs do
    """
    cases = [whole, *others.values()]
    for case in cases:
        bench.simulate(case, compiled=compiled)  # what is built and compiled is not timed
    taken: list[list[float]] = []
    least, most = max(ROUNDS[0], len(eighths)), ROUNDS[1]
    while len(taken) < most and (len(taken) < least or float(np.nansum(taken)) < TIMED):
        tolerance = eighths[len(taken) % len(eighths)]
        taken.append([_time(case, bench, tolerance, compiled=compiled) for case in cases])
        progress(max(len(taken) / most, float(np.nansum(taken)) / TIMED))
    times = np.array(taken)
    saved = 1 - times[:, 1:] / times[:, :1]
    low, median, high = np.nanquantile(saved, (INTERVAL[0], 0.5, INTERVAL[1]), axis=0)
    of = zip(median, low, high, strict=True)
    return dict(zip(others, (Share(*map(float, share)) for share in of), strict=True))


def _time(case: Case, bench: Bench, eighths: int, *, compiled: bool) -> float:
    """Return the least integration time [s] of several runs; nan if one does not finish.

    The least, because disturbances by other processes only add to it.
    """
    runs = (bench.simulate(case, eighths, compiled=compiled) for _ in range(TRIES))
    return min(run.statistics.wall_s if run.outcome.finished else math.nan for run in runs)
