"""What pairs cost that do not touch: guards before a slider-crank that nothing reaches, and balls that are far from each other."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from benchmarks.ratios import Ratio, medians

from reference import scenes

DURATION, TOLERANCE = "24 ms", 1e-8  # two revolutions, about 1500 attempts
CRANK = {"duration": DURATION, "tolerance": TOLERANCE}
FALL = {"duration": "0.5 s", "tolerance": 1e-6, "method": "dop853"}
RUNS = 10  # of which a measurement is the shortest: a run is shorter than the time slice of whatever else there is


def pairs() -> Iterable[Ratio]:
    """Cost per attempt of 1, 4 and 10 contact pairs of which one touches."""
    from hertzwerk.runtime.loading import engine_model

    models = {1 + guards: engine_model(scenes.guarded_crank(guards)) for guards in (0, 3, 9)}
    for compiled in (False, True):
        one, *others = medians(*(attempt(model, compiled) for model in models.values()))
        for count, cost in zip(list(models)[1:], others, strict=True):
            wanted = "<= 1.5" if compiled and count == 10 else ""
            yield Ratio(f"{count} pairs / 1 pair, per attempt, {'C' if compiled else 'VM'}", cost, one, wanted)
    few, many = medians(*(attempt(engine_model(scenes.balls(n)), False, FALL, runs=1) for n in (12, 24)), repeats=3)
    yield Ratio("24 balls / 12 balls, per attempt, VM", many, few, "<= 2.3")  # 2 ** 1.2


def attempt(model: Any, compiled: bool, options: dict[str, Any] = CRANK, runs: int = RUNS) -> Callable[[], float]:
    """The measurement of the time [s] that an attempt takes."""
    from hertzwerk.runtime import simulate

    def measure() -> float:
        made = [simulate(model, compiled=compiled, **options).statistics for _ in range(runs)]
        return min(s.wall_s / (s.steps + s.rejected + s.retaken) for s in made)

    measure()  # builds, compiles
    return measure
