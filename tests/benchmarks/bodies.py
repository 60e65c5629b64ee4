"""Many bodies: what pairs cost that are far from contact. Balls beside Drake are in contact/."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.pairs import attempt
from benchmarks.ratios import Ratio, medians

from reference import scenes


def bodies() -> Iterator[Ratio]:
    """Pairs of which one touches, 100 over one."""
    from hertzwerk.runtime import load

    models = [load(scenes.guarded_crank(guards)) for guards in (0, 99)]
    for compiled in (False, True):
        one, many = medians(*(attempt(model, compiled) for model in models))
        yield Ratio(f"100 pairs / 1 pair, per attempt, {'C' if compiled else 'VM'}", many, one, "<= 1.5")
