"""Slider-crank with clearance for studies: models with other laws, numbers with their errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from hertzwerk.runtime.effects.compared_outputs import chosen
from hertzwerk.runtime.effects.measuring import Bench, Case, Measurement
from hertzwerk.runtime.loading import Model

if TYPE_CHECKING:
    from hertzwerk.runtime.model.binding import Value

SCENE, PIN = "slider_crank", "slider_pin"


def crank_with(law: str | None) -> Model:
    """Return the slider-crank with another stiffness law in its pin; None: a free exponent."""
    from hertzwerk.runtime.model.build import build_compared

    return Model(build_compared(SCENE, PIN, law))


def measure(
    model: Model, duration: str, values: Mapping[str, Value], outputs: Sequence[str], tolerance: float
) -> Measurement:
    """Measure outputs by name, from several runs at different tolerances; see `effects.measuring`."""
    bench = Bench(duration, tolerance, "auto", values)
    first = bench.simulate(Case(model), max_steps=1)
    return bench.measure(Case(model), chosen(first, outputs)[0])
