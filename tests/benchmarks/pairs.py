"""What pairs cost that do not touch: the slider-crank with 3 or 9 guards that nothing reaches, against the same without them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from benchmarks.ratios import Ratio, medians

from reference import scenes

DURATION, TOLERANCE = "24 ms", 1e-8  # two revolutions, about 1500 attempts
RUNS = 10  # of which a measurement is the shortest: a run is shorter than the time slice of whatever else there is


def pairs() -> Iterable[Ratio]:
    """Cost per attempt of 1, 4 and 10 contact pairs of which one touches."""
    from hertzwerk.runtime import load

    models = {1 + guards: load(scenes.guarded_crank(guards)) for guards in (0, 3, 9)}
    for compiled in (False, True):
        one, *others = medians(*(attempt(model, compiled) for model in models.values()))
        for count, cost in zip(list(models)[1:], others, strict=True):
            wanted = "<= 1.5" if compiled and count == 10 else ""
            yield Ratio(f"{count} pairs / 1 pair, per attempt, {'C' if compiled else 'VM'}", cost, one, wanted)


def attempt(model: Any, compiled: bool) -> Callable[[], float]:
    """The measurement of the time [s] that an attempt takes."""
    from hertzwerk.runtime import simulate

    def measure() -> float:
        runs = [simulate(model, duration=DURATION, tolerance=TOLERANCE, compiled=compiled) for _ in range(RUNS)]
        return min(s.wall_s / (s.steps + s.rejected + s.retaken) for s in (run.statistics for run in runs))

    measure()  # builds, compiles
    return measure
