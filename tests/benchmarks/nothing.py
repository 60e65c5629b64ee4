"""What an effect costs that was taken away: the slider-crank without friction against the one that never had any."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from benchmarks.pairs import DURATION, TOLERANCE
from benchmarks.ratios import Ratio, hot, medians


def nothing() -> Iterable[Ratio]:
    """slider_crank --without slider_pin_friction against slider_crank_frictionless, and what friction costs: runs of two revolutions."""
    from hertzwerk.runtime import load

    models = (
        load("slider_crank", without=["slider_pin_friction"]),
        load("slider_crank_frictionless"),
        load("slider_crank"),
    )
    for compiled in (False, True):
        taken, none, friction = medians(*(hot(_run(model, compiled), calls=15) for model in models))
        path = "C" if compiled else "VM"
        yield Ratio(f"friction taken away / never had, {path}", taken, none)
        yield Ratio(f"with / without friction, {path}", friction, none)


def _run(model: Any, compiled: bool) -> Callable[[], object]:
    from hertzwerk.runtime import simulate

    return lambda: simulate(model, duration=DURATION, tolerance=TOLERANCE, compiled=compiled)
