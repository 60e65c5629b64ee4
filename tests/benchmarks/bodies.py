"""Many bodies: what pairs cost that are far from contact. Balls beside Drake are in contact/."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.ratios import Ratio, medians

from reference import scenes

CRANK = {"duration": "24 ms", "tolerance": 1e-8}  # two revolutions, about 1500 attempts
FALL = {"duration": "0.5 s", "tolerance": 1e-6, "method": "dop853"}
RUNS = 10  # of which a measurement is the shortest: a run is shorter than the time slice of whatever else there is


def bodies() -> Iterator[Ratio]:
    """Cost per attempt of 1, 10 and 100 pairs of which one touches, and of 12 and 24 balls."""
    from hertzwerk.runtime import load

    models = {1 + guards: load(scenes.guarded_crank(guards)) for guards in (0, 9, 99)}
    for compiled in (False, True):
        one, *others = medians(*(attempt(model, compiled) for model in models.values()))
        for count, cost in zip(list(models)[1:], others, strict=True):
            yield Ratio(f"{count} pairs / 1 pair, per attempt, {'C' if compiled else 'VM'}", cost, one, "<= 1.5")
    few, many = medians(*(attempt(load(scenes.balls(n)), False, FALL, runs=1) for n in (12, 24)), repeats=3)
    yield Ratio("24 balls / 12 balls, per attempt, VM", many, few, "<= 2.3")  # 2 ** 1.2


def attempt(model: Any, compiled: bool, options: dict[str, Any] = CRANK, runs: int = RUNS) -> Callable[[], float]:
    """The measurement of the time [s] that an attempt takes."""
    from hertzwerk.runtime import simulate

    def measure() -> float:
        made = [simulate(model, compiled=compiled, **options).statistics for _ in range(runs)]
        return min(s.wall_s / (s.steps + s.rejected + s.retaken) for s in made)

    measure()  # builds, compiles
    return measure
