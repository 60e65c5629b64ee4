"""Slider-crank with clearance for studies: models with other laws, numbers with their errors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from hertzwerk.runtime.analysis.effect_study.compared_outputs import chosen
from hertzwerk.runtime.analysis.effect_study.output_errors import Bench, Case, Measurement
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.studies.paper.study_page import Cell

SCENE, PIN = "slider_crank", "slider_pin"
SPEED, CLEARANCE, TURN = 5000.0, 0.5e-3, "12 ms"  # rpm and m of the scene, one revolution
PENETRATION = f"max.{PIN}.penetration"
OUTPUTS = {  # name, unit, SI of the unit
    "peak_force": ("peak force", "kN", 1e3),
    PENETRATION: ("penetration", "µm", 1e-6),
    "impact_rate": ("impact rate", "1/s", 1.0),
    "peak_acceleration": ("acceleration", "km/s²", 1e3),
}
TOLERANCE = 1e-8  # of the loosest of the runs of a measurement


def crank_with(law: str | None) -> EngineModel:
    """Return the slider-crank with another stiffness law in its pin; None: Hertz's with a free exponent.

    Raises InputError.
    """
    from hertzwerk.runtime.engine.model.build import build_compared

    return EngineModel(build_compared(SCENE, PIN, law))


def measure(model: EngineModel, values: Mapping[str, Value], duration: str = TURN) -> Measurement:
    """Measure OUTPUTS by runs at several tolerances; see `output_errors`. Raises InputError."""
    bench = Bench(duration, TOLERANCE, "auto", values)
    first = bench.simulate(Case(model), max_steps=1)
    return bench.measure(Case(model), chosen(first, tuple(OUTPUTS))[0])


def header() -> Iterator[tuple[str, str]]:
    """Yield the columns of OUTPUTS, each with that of its error."""
    for name, unit, _ in OUTPUTS.values():
        yield from ((name, unit), (f"{name} ±", unit))


def cells(measurement: Measurement) -> Iterator[Cell]:
    """Yield the cells of a measurement in the columns of `header`."""
    for output, (_, _, factor) in OUTPUTS.items():
        number = measurement.numbers.get(output)
        yield from (None, None) if number is None else (number.value / factor, number.error / factor)
