"""Fit of parameters to measurements, as users call it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.free_quantities import Freed
from hertzwerk.runtime.engine.run.run_request import METHOD, Compiled, progress_faults
from hertzwerk.runtime.engine.start.start_values import stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.studies.comparison.comparison_request import Between
from hertzwerk.runtime.studies.fitting.experiment import Data, Experiment
from hertzwerk.runtime.studies.fitting.fit_result import Fit
from hertzwerk.runtime.studies.fitting.fitting import fitted, read_fit
from hertzwerk.runtime.studies.fitting.law_ranking import Ranking, law_variants, ranked, read_laws
from hertzwerk.runtime.studies.fitting.moments.measured_moments import MeasuredSeries
from hertzwerk.runtime.studies.fitting.moments.moment_fit import MomentFit, fitted_moments, read_moment_fit

if TYPE_CHECKING:
    from distributed import Client

TOLERANCE = 1e-9  # local, of the runs of a fit
STARTS = 16  # beside the model's own values


def fit(
    target: Target,
    data: Data | Experiment | Sequence[Data | Experiment],
    *,
    free: Mapping[str, Freed] | Sequence[str],
    map: Mapping[str, str] | None = None,
    noise: Mapping[str, Value] | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Any] | None = None,
    duration: str | float | None = None,
    offset: Between = 0.0,
    gain: Mapping[str, Between] | None = None,
    tolerance: float = TOLERANCE,
    method: str = METHOD,
    compiled: Compiled = "auto",
    starts: int = STARTS,
    seed: int = 0,
    profile: bool | str = "auto",
    progress: Callable[[float], object] | None = None,
) -> Fit:
    """Fit parameters and initial states to measurements, with exact derivatives through impacts.

    target      a scene or a Model, as `simulate` takes it
    data        a table over time, or with a column `impact [1]`, as `read_measurement` reads it; a `Measurement`, `MeasuredImpacts`;
                an `Experiment`, which states the values of its run; or several of them, fitted together
    free        ranges by name, {"restitution": (0.3, 1), "stiffness": "1e7..1e9 N/m log", "clearance": "log"}; a name alone takes the range of its
                law. A quantity is searched by ratios where its range states log, or spans two decades
    map         histories by measured column, {"height": "vertical.travel"}; of impacts "impacts.t", "impacts.speed", "floor.impacts.peak_force", or
                "impacts.rebound.vertical.travel", the largest value until the next impact. By default equal names
    noise       standard deviations by column, {"height": "0.1 mm"}, which judge the residuals; by default estimated from the residuals
    parameters, initial, inputs    known values, as `simulate` takes them
    duration    of the runs; required where impacts have no times
    offset      run time less measured time, for each run: a value, or a range in which it is fitted, "-2..2 ms"
    gain        ranges of a sensor's gain by column, {"height": "0.95..1.05"}: measured = gain times run
    tolerance, method, compiled    of the runs. Data beyond the time at which their error exceeds a tenth of the noise are omitted, with a warning
    starts, seed    Latin hypercube of starts beside the model's values; the best are followed over windows that lengthen
    profile     intervals by profile likelihood: "auto" of badly identified quantities, True of all, False of none

    Raises InputError with every fault: units, columns, lines of a file, names, ranges, and quantities that change nothing measured.
    `unidentified` lists combinations of quantities that the data do not identify.
    """
    model, faults = engine_model(target), progress_faults(progress)
    own, states = stated_values(model, parameters, initial, faults)
    request = read_fit(
        model,
        data,
        free,
        before=faults,
        map=map,
        noise=noise,
        parameters=own,
        initial=states,
        inputs=inputs,
        duration=duration,
        offset=offset,
        gain=gain,
        tolerance=tolerance,
        method=method,
        compiled=compiled,
        starts=starts,
        seed=seed,
        profile=profile,
    )
    return fitted(request, progress)


def fit_laws(
    target: Target,
    data: Data | Experiment | Sequence[Data | Experiment],
    laws: Mapping[str, Sequence[str]],
    *,
    free: Mapping[str, Freed] | Sequence[str],
    map: Mapping[str, str] | None = None,
    noise: Mapping[str, Value] | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Any] | None = None,
    duration: str | float | None = None,
    offset: Between = 0.0,
    gain: Mapping[str, Between] | None = None,
    tolerance: float = TOLERANCE,
    method: str = METHOD,
    compiled: Compiled = "auto",
    starts: int = STARTS,
    seed: int = 0,
    profile: bool | str = "auto",
    progress: Callable[[float], object] | None = None,
) -> Ranking:
    """Fit a scene with each of several laws to the same data, and rank them by AICc and by runs held out.

    laws    by effect, {"floor": ["flores", "hunt_crossley", "power(K=1e6 N/m, n=1) x flores"]}: all combinations, each derived
    free    as of `fit`; a quantity that one law has, and another has not, is free where it is

    The other arguments are those of `fit`. Raises InputError with every fault.
    """
    model, wrong = engine_model(target), progress_faults(progress)
    own, states = stated_values(model, parameters, initial, wrong)
    variants, faults = law_variants(model, laws)
    how = {
        **{"map": map, "noise": noise, "parameters": own, "initial": states, "inputs": inputs, "duration": duration},
        **{"offset": offset, "gain": gain, "tolerance": tolerance, "method": method, "compiled": compiled},
        **{"starts": starts, "seed": seed, "profile": profile},
    }
    return ranked(read_laws(variants, data, free, how, [*wrong, *faults]), progress)


def fit_moments(
    target: Target,
    moments: Mapping[str, str | tuple[Value, Value] | None],
    *,
    free: Mapping[str, Freed] | Sequence[str],
    series: MeasuredSeries | Sequence[MeasuredSeries] = (),
    independent: bool = False,
    seed: int = 0,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Any] | None = None,
    duration: str | float | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    workers: int | None = None,
    client: Client | None = None,
    progress: Callable[[float], object] | None = None,
) -> MomentFit:
    """Fit parameters to statistics of runs longer than their horizon, by simulated moments.

    moments    measured values and their standard deviations by the name of an output of `sweep`:
               {"slider_pin.impact_rate": ("412 1/s", "5 1/s"), "slider_pin.dissipated_power": "3.1 +- 0.1 W"}; None of those that
               are computed from a measured series: {"acceleration.rms": None}, COLUMN.KIND, with mean, rms, norm8, norm32, largest
               (mean of the largest values in the drives' period), excursions (their rate, as `compare` counts them); of
               measured impacts, {"t.rate": None, "speed.rms": None}, their rate and means over them
    independent    whether values that are stated were measured one by one: else they are of one record, and correlated as
               those of a run are
    series     the measured columns, of one series or several,
               MeasuredSeries("long.csv", map={"acceleration": "guide.acceleration"}, bandwidth="5 kHz"), with the values that
               each was measured at: runs are seen through the same instrument at the same spacing, and one function takes the
               statistics of both, with the covariance of means of blocks longer than the motion is correlated. Series are
               independent of each other. Runs last as long as the longest, without a duration
    free       as of `fit`; tolerance: local, by default 1e-6. The other arguments are those of `sweep`

    Derivatives are those of a quadratic regression over runs at points of a Latin hypercube, the scatter of the runs' own statistics its covariance;
    the box of the points closes in on the best, at most twice. Raises InputError with every fault.
    """
    model, faults = engine_model(target), progress_faults(progress)
    own, states = stated_values(model, parameters, initial, faults)
    how = {
        **{"parameters": {**own, **states}, "inputs": inputs, "duration": duration},
        **{"tolerance": tolerance, "method": method, "compiled": compiled, "max_steps": max_steps},
        **{"max_events": max_events, "wall_time": wall_time, "workers": workers, "client": client},
    }
    how = {name: value for name, value in how.items() if value is not None}
    several = (series,) if isinstance(series, MeasuredSeries) else series
    if not isinstance(several, list | tuple) or not all(isinstance(one, MeasuredSeries) for one in several):
        raise InputError("fit_moments", [Fault("series", shown(series), "a MeasuredSeries, or a list of them")])
    return fitted_moments(
        read_moment_fit(model, moments, free, how, seed, faults, several, independent=independent), progress
    )
