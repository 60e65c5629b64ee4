"""What an effect costs that was taken away: the slider-crank without friction against the one that never had any."""

from __future__ import annotations

from collections.abc import Iterable

from benchmarks.pairs import attempt
from benchmarks.ratios import Ratio, medians


def nothing() -> Iterable[Ratio]:
    """slider_crank --without slider_pin_friction against slider_crank_frictionless, and what friction costs: per attempt, compiled or not."""
    from hertzwerk.runtime import load

    without = load("slider_crank", without=["slider_pin_friction"])
    never, with_it = load("slider_crank_frictionless"), load("slider_crank")
    for compiled in (False, True):
        taken, none, friction = medians(*(attempt(model, compiled) for model in (without, never, with_it)))
        path = "C" if compiled else "VM"
        yield Ratio(f"friction taken away / never had, per attempt, {path}", taken, none)
        yield Ratio(f"with / without friction, per attempt, {path}", friction, none)
