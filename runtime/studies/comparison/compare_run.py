"""Comparison of a run with measured data, as users call it, with its picture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from hertzwerk.runtime.engine.inputs.measurement_csv import MeasuredTable, Measurement
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.solution.solution import Solution
from hertzwerk.runtime.studies.comparison.comparison_request import Between, read_asked
from hertzwerk.runtime.studies.comparison.comparison_result import Compared
from hertzwerk.runtime.studies.comparison.matching import match

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Comparison(Compared):
    """Run beside measured data, as `compare` returns it, with its picture."""

    def plot(self) -> Figure:
        """Draw measured data over the run, the residual, and spectra, for each signal."""
        from hertzwerk.runtime.studies.comparison import plot_comparison

        return plot_comparison.figure(self)


def compare(
    run: Solution,
    data: Measurement | MeasuredTable,
    *,
    map: Mapping[str, str] | None = None,
    bandwidth: str | float | None = None,
    order: int = 4,
    zero_phase: bool = False,
    offset: Between = 0.0,
    drift: Between = 0.0,
    noise: Mapping[str, Value] | None = None,
) -> Comparison:
    """Compare a run with measured data: a `Measurement`, or a table as `read_measurement` reads it.

    map         histories of the run by measured column, {"acceleration": "guide.acceleration"}; by default equal names
    bandwidth   cut-off frequency of the instrument, "5 kHz" or [Hz]: the run goes through a Butterworth low-pass of this `order`, causal
                (3 dB down there), or with zero_phase forwards and backwards (6 dB); None: the run is compared as it is
    offset      run time less measured time: a value, or the range in which the best is searched, "-2..2 ms"; (low, high) in s
    drift       part by which the run takes longer than the measured clock says: a value or a range, "-1e-4..1e-4"
    noise       standard deviations of the measurement's noise by column, {"acceleration": "5 m/s^2"}: what a residual is judged by

    Trajectories are compared while the run's own numerical error (`run.error`) is within 0.1 % of its scales, statistics beyond it.
    Raises InputError with every fault: lines of the file, units, names, ranges; a run that did not keep its steps.
    """
    asked = read_asked(
        run.history.units,
        data,
        map,
        bandwidth=bandwidth,
        order=order,
        zero_phase=zero_phase,
        offset=offset,
        drift=drift,
        noise=noise,
    )
    return Comparison(**vars(match(run, asked)))
