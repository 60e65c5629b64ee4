"""A million measured rows: reading them beside NumPy's reader, and comparing a run with them beside the run."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from benchmarks.ratios import Ratio, hot, medians

from hertzwerk.runtime import Measurement, compare, read_measurement, simulate

ROWS = 1_000_000
SECONDS = 2.0  # that a comparison may take


def measured() -> Iterator[Ratio]:
    """Reading and comparing a million rows: processor time over that of `numpy.loadtxt`, and over two seconds."""
    run = simulate("slider_crank", duration="24 ms")
    times = np.linspace(1e-3, 23e-3, ROWS)
    travel = run.at(times)["guide.travel"] + np.random.default_rng(1).normal(0, 1e-5, ROWS)
    data = Measurement(times, {"travel": travel}, {"travel": "m"})
    how = {"map": {"travel": "guide.travel"}, "noise": {"travel": "1e-5 m"}}
    with tempfile.TemporaryDirectory() as place:
        clean, german = Path(place) / "clean.csv", Path(place) / "german.csv"
        np.savetxt(clean, np.column_stack([times, travel]), "%.9g", ",", header="t [s],travel [m]", comments="")
        german.write_text(clean.read_text().replace(",", ";").replace(".", ","))

        def once(action: Callable[[], object]) -> Callable[[], float]:
            return hot(action, calls=1, warm=0)

        plain, read, commas, bare, seen = medians(
            once(lambda: np.loadtxt(clean, delimiter=",", skiprows=1)),
            once(lambda: read_measurement(clean)),
            once(lambda: read_measurement(german)),
            once(lambda: compare(run, data, **how)),
            once(lambda: compare(run, data, bandwidth="5 kHz", offset="-0.1..0.1 ms", **how)),
            repeats=3,
        )
    yield Ratio("read_measurement of a clean file / numpy.loadtxt", read, plain, "<= 5")
    yield Ratio("read_measurement with decimal commas / numpy.loadtxt", commas, plain)
    yield Ratio("compare as it is / two seconds", bare, SECONDS, "<= 1")
    yield Ratio("compare with an instrument and an offset / two seconds", seen, SECONDS, "<= 1")
