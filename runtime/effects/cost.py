"""What scenes cost: operations of a right-hand side in each mode, states, event functions, and the time of runs made side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from hertzwerk.runtime.effects.measuring import Bench, Case
    from hertzwerk.runtime.model.model import Model

FLIGHT = ("applied", "accelerations", "gaps", "gap_accelerations")  # as the header of a generated module counts them
TRIES = 3  # runs of one round
ROUNDS, TIMED = (5, 25), 1.5  # of timing: least and most, and the time [s] that the fastest of all of them may take
INTERVAL = (0.1, 0.9)  # of the shares in all rounds


@dataclass(frozen=True)
class Cost:
    """flight: operations of a right-hand side where nothing touches; contact: further ones where all pairs do; states integrated; events:
    functions whose zeros are looked for, of pairs that touch and of those that stick."""

    flight: int
    contact: int
    states: int
    events: int

    def __sub__(self, other: Cost) -> Cost:
        return Cost(*(here - there for here, there in zip(vars(self).values(), vars(other).values(), strict=True)))


def cost_of(model: Model) -> Cost:
    """What one evaluation of a model costs."""
    counts = dict(model.module.OPERATIONS)
    contact = sum(count for name, count in counts.items() if name.startswith("contact_"))
    states = model.nq + model.nu + model.nz
    return Cost(sum(counts.get(name, 0) for name in FLIGHT), contact, states, model.k + model.ns)


@dataclass(frozen=True)
class Share:
    """Part of the time of the whole scene that an effect takes: the median of the rounds, and what most of them lie within."""

    median: float
    low: float
    high: float

    @property
    def seen(self) -> bool:
        """Whether it differs from none by more than it scatters."""
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
    """The share of the whole scene's time that each of the others saves, runs taken in turns.

    eighths    the tolerance of each round, one after another (see `Bench`): of runs that part, several, so that the shares scatter as they do
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
    """Time [s] of the integration of a run: the least of some, because what else the machine does only adds to it; NaN if it does not finish."""
    runs = (bench.simulate(case, eighths, compiled=compiled) for _ in range(TRIES))
    return min(run.statistics.wall_s if run.outcome.finished else math.nan for run in runs)
