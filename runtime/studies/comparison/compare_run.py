"""Comparison of a run with measured data, as users call it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, cast

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.inputs.input_values import Input
from hertzwerk.runtime.engine.inputs.measurement_csv import MeasuredTable, Measurement
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.run.run_request import Accuracy, Compiled
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.comparison.comparison_request import Between, read_comparison_request
from hertzwerk.runtime.studies.comparison.comparison_result import Comparison
from hertzwerk.runtime.studies.comparison.matching import match


def compare(
    target: Solution | Target,
    data: Measurement | MeasuredTable,
    *,
    map: Mapping[str, str] | None = None,
    bandwidth: str | float | None = None,
    order: int = 4,
    zero_phase: bool = False,
    offset: Between = 0.0,
    drift: Between = 0.0,
    noise: Mapping[str, Value] | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str | None = None,
    compiled: Compiled | None = None,
    progress: Callable[[float], object] | None = None,
) -> Comparison:
    """Compare a run with measured data: a `Measurement`, or a table as `read_measurement` reads it.

    target      a run; or a scene or a Model, which is run as long as the data last, or for a `duration`, as `simulate` does with
                `parameters`, `initial`, `inputs`, `accuracy`, `tolerance`, `method`, `compiled`, `progress`
    map         histories of the run by measured column, {"acceleration": "guide.acceleration"}; by default equal names
    bandwidth   cut-off frequency of the instrument, "5 kHz" or [Hz]: the run goes through a Butterworth low-pass of this `order`, causal
                (3 dB down there), or with zero_phase forwards and backwards (6 dB); None: the run is compared as it is
    offset      run time less measured time: a value, or the range in which the best is searched, "-2..2 ms"; (low, high) in s
    drift       part by which the run takes longer than the measured clock says: a value or a range, "-1e-4..1e-4"
    noise       standard deviations of the measurement's noise by column, {"acceleration": "5 m/s^2"}: what a residual is judged by

    Trajectories are compared while the run's own numerical error (`run.error`) is within 0.1 % of its scales, statistics beyond it.
    Raises InputError with every fault: lines of the file, units, names, ranges; a run that did not keep its steps.
    """
    of_run = {
        **{"parameters": parameters, "initial": initial, "inputs": inputs, "duration": duration},
        **{"accuracy": accuracy, "tolerance": tolerance, "method": method, "compiled": compiled, "progress": progress},
    }
    settings: dict[str, Any] = {name: value for name, value in of_run.items() if value is not None}
    run = target if isinstance(target, Solution) else None
    if run is not None and settings:
        raise InputError("compare", [Fault(", ".join(settings), "values beside a run", "none: it has its own")])
    model = run.engine.model if run is not None else engine_model(cast("Target", target))
    request = read_comparison_request(
        units_of(model, None) if run is None else run.units,
        data,
        map,
        bandwidth=bandwidth,
        order=order,
        zero_phase=zero_phase,
        offset=offset,
        drift=drift,
        noise=noise,
    )
    return match(run or simulate(model, **{"duration": request.lasts, **settings}), request)
