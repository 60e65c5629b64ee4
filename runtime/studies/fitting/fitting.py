"""Pipeline of a fit: request -> least squares -> identifiability -> intervals -> goodness.

1. request     what is free, measured runs, nuisance, options, with every fault        free_quantities, experiment
2. forward     runs, what they predict, exact Jacobian                                 forward
3. search      starts, windows, trust region                                           search
4. identified  singular values, unidentifiable combinations                           intervals
5. fitted      intervals, goodness of fit, residuals                                   intervals, fitted
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, among, refuse, shown, unknown
from hertzwerk.runtime.engine.model.binding import Value, named_values, whole_faults
from hertzwerk.runtime.engine.model.free_quantities import Free, read_free
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import unit_at
from hertzwerk.runtime.engine.run.run_request import Compiled, Settings
from hertzwerk.runtime.studies.comparison.comparison_request import Between, read_between
from hertzwerk.runtime.studies.comparison.residuals import residual_of
from hertzwerk.runtime.studies.fitting.experiment import Observed, read_experiments
from hertzwerk.runtime.studies.fitting.fit_result import CORRELATED, Fit, FittedSignal, FittedValue, Goodness
from hertzwerk.runtime.studies.fitting.intervals import identified, intervals
from hertzwerk.runtime.studies.fitting.least_squares import Estimate, Forward, Search
from hertzwerk.runtime.system.arrays import Array

FEWEST = 8  # residuals of a column whose correlation is judged
IDLE = 1e-6  # of a column's spread, by a change as large as the scale of the search: less is the error of runs
PROBES = 3  # places besides the model's own values at which a quantity must enter what is measured


@dataclass(frozen=True)
class FitRequest:
    """Request for a fit; raises nothing: `read_fit` checks."""

    free: tuple[Free, ...]
    nuisance: tuple[Free, ...]
    offsets: tuple[int | float, ...]
    gains: dict[str, int]
    observed: tuple[Observed, ...]
    tolerance: float
    method: str
    compiled: Compiled
    starts: int
    seed: int
    profile: bool | str

    def forward(self) -> Forward:
        """Return the forward model of all measured runs."""
        return Forward(
            self.observed,
            self.free,
            self.nuisance,
            self.offsets,
            self.gains,
            tolerance=self.tolerance,
            method=self.method,
            compiled=self.compiled,
        )


def read_fit(
    model: EngineModel,
    data: object,
    free: object,
    *,
    map: Mapping[str, str] | None,
    noise: Mapping[str, Value] | None,
    parameters: Mapping[str, Value] | None,
    initial: Mapping[str, Value] | None,
    inputs: Mapping[str, Any] | None,
    duration: str | float | None,
    offset: Between,
    gain: Mapping[str, Between] | None,
    tolerance: float,
    method: str,
    compiled: Compiled,
    starts: object,
    seed: object,
    profile: object,
    before: list[Fault] | None = None,
) -> FitRequest:
    """Read a fit; raises InputError with every fault."""
    faults = list(before or [])
    freed = read_free(model, free, faults)
    low, high = read_between("offset", offset, "s", faults)
    observed = read_experiments(
        model,
        data,
        map=map,
        noise=noise,
        parameters=parameters or {},
        initial=initial or {},
        inputs=inputs,
        duration=duration,
        latest=max(high, 0.0),
        free=[one.name for one in freed],
        faults=faults,
    )
    faults += whole_faults(starts=starts, seed=seed)
    if not among(profile, "auto", True, False):
        faults.append(Fault("profile", shown(profile), '"auto", True or False'))
    nuisance: list[Free] = []
    offsets: list[int | float] = [low] * len(observed)
    if low < high:
        for i, each in enumerate(observed):
            offsets[i] = len(freed) + len(nuisance)
            where = f"offset of {each.name}" if len(observed) > 1 else "offset"
            nuisance.append(Free(low, high, "s", False, where, min(max(0.0, low), high)))
    gains: dict[str, int] = {}
    columns = {channel.column for each in observed for channel in each.channels}
    stated_gains: Mapping[str, Any] = named_values("gain", {} if gain is None else gain, faults)
    for column, between in stated_gains.items():
        if observed and column not in columns:
            faults.append(unknown("column", column, sorted(columns)))
            continue
        ends = read_between(f"gain of {column}", between, "1", faults)
        gains[column] = len(freed) + len(nuisance)
        if not 0 < ends[0] < ends[1]:
            faults.append(Fault(f"gain of {column}", shown(between), 'a range of positive numbers, such as "0.9..1.1"'))
            continue
        nuisance.append(Free(*ends, "1", False, f"gain of {column}", min(max(1.0, ends[0]), ends[1])))
    faults += Settings(1.0, None, tolerance, method, compiled).faults()
    if tolerance is None:
        faults.append(Fault("tolerance", "none", "the local tolerance of the runs"))
    count = sum(len(each.at) for each in observed)
    if observed and count < len(freed) + len(nuisance):
        faults.append(
            Fault("data", f"{count} numbers", f"at least {len(freed) + len(nuisance)}, as many as are fitted")
        )
    refuse(f"fit of {model.name}", faults)
    return FitRequest(
        freed,
        tuple(nuisance),
        tuple(offsets),
        gains,
        observed,
        tolerance,
        method,
        compiled,
        int(starts),  # type: ignore[call-overload]
        int(seed),  # type: ignore[call-overload]
        profile,  # type: ignore[arg-type]
    )


def fitted(request: FitRequest, progress: Callable[[float], object] | None = None) -> Fit:
    """Return the fit of a request; raises InputError for what enters nothing measured."""
    return concluded(request, *searched(request, progress))


def searched(request: FitRequest, progress: Callable[[float], object] | None = None) -> tuple[Search, Estimate]:
    """Return the search and its least squares; raises InputError for what enters nothing measured."""
    forward = request.forward()
    search = Search(forward, stated_noise(forward), progress)
    _refuse_idle(search, request)
    return search, search.best(request.starts, request.seed)


def stated_noise(forward: Forward) -> Array:
    """Return the stated noise of every datum (n,), nan where none is stated."""
    sizes = [forward.observed[i].channels[k].noise for i, k in forward.columns]
    noise: Array = np.array([math.nan if size is None else size for size in sizes])[forward.column]
    return noise


def _refuse_idle(search: Search, request: FitRequest) -> None:
    """Raise InputError for quantities that change nothing measured, wherever they are tried."""
    forward, sensitivity = search.forward, np.zeros(len(request.free))
    for x in search.starts(PROBES, request.seed):
        sensitivity = np.maximum(
            sensitivity, np.max(np.abs(forward.slopes(x)[:, : len(request.free)] / search.spread[:, None]), axis=0)
        )
        if np.all(sensitivity > IDLE):
            return
    columns = sorted({f"{c.column} ({c.history})" for each in request.observed for c in each.channels})
    remedy = "omit it, or measure a quantity that it changes"
    raise InputError(
        f"fit of {request.observed[0].model.name}",
        [
            Fault(free.name, f"a quantity that changes nothing of {', '.join(columns)}", "one that does", remedy)
            for free, size in zip(request.free, sensitivity, strict=True)
            if not size > IDLE
        ],
    )


def concluded(request: FitRequest, search: Search, estimate: Estimate) -> Fit:
    """Return the fit with its identifiability, intervals, goodness and residuals."""
    share = float(np.mean(estimate.used))
    forward = search.forward
    known = identified(estimate.jacobian, forward.searched)
    ends, warnings = intervals(search, estimate, known, request.profile)
    count, point = len(request.free), forward.at(estimate.x)
    made = [run.settings.parameters for run in point.runs if run is not None]
    units = {free.name: {unit_at(free.unit, parameters) for parameters in made} for free in forward.searched}
    values = [
        FittedValue.of(free, free.outer(float(x)), interval, *(units[free.name] if len(units[free.name]) == 1 else ()))
        for free, x, interval in zip(forward.searched, estimate.x, ends, strict=True)
    ]
    signals = tuple(_signals(search, estimate))
    exact = "exact, from the variational equations through every impact"
    reasons = "; ".join(sorted(forward.without_exact)[:3])
    return Fit(
        scene=request.observed[0].model.name,
        observed=request.observed,
        values={value.name: value for value in values[:count]},
        nuisance={value.name: value for value in values[count:]},
        known=known,
        unidentified=tuple(known.unidentified([value.value for value in values], count)),
        goodness=_goodness(search, estimate),
        criterion=criterion_of(search, estimate),
        share=share,
        signals=signals,
        offsets=tuple(forward.offset(i, estimate.x) for i in range(len(request.observed))),
        solutions=tuple(run for run in point.runs if run is not None),
        runs_made=forward.runs_made,
        derivatives=f"{exact}; in part by differences: {reasons}" if reasons else exact,
        warnings=(*_warnings(search, estimate, signals, values, share), *dict.fromkeys(warnings)),
    )


def _signals(search: Search, estimate: Estimate) -> list[FittedSignal]:
    forward = search.forward
    point, made = forward.at(estimate.x), []
    for number, (i, k) in enumerate(forward.columns):
        each = forward.observed[i]
        rows = forward.column == number
        used, measured, predicted = estimate.used[rows], forward.measured[rows], point.predicted[rows]
        at = each.at[each.column == k]
        judged = used & np.isfinite(predicted)
        sigma = float(estimate.sigma[rows][0])
        stated = each.channels[k].noise is not None
        residual = (
            residual_of(at[judged], measured[judged], predicted[judged], sigma if stated else None)
            if np.any(judged)
            else None
        )
        made.append(
            FittedSignal(
                each.name, each.channels[k], each.by_impacts, at, measured, predicted, used, sigma, stated, residual
            )
        )
    return made


def _goodness(search: Search, estimate: Estimate) -> Goodness | None:
    """Return chi-squared and its chance, of the rows whose noise is stated."""
    from scipy.stats import chi2  # slow to import

    stated = np.isfinite(search.stated[estimate.used])
    if not np.any(stated):
        return None
    freedom = round(float(np.sum(stated)) - len(estimate.x) * float(np.mean(stated)))
    if freedom < 1:
        return None
    square = float(np.sum(estimate.residuals[stated] ** 2))
    return Goodness(square, freedom, float(chi2.sf(square, freedom)))


def criterion_of(search: Search, estimate: Estimate) -> float:
    """Return Akaike's criterion with the correction for few data, but for a constant of the data.

    The noise of columns without a stated one is that which makes their residuals likeliest, and counts as fitted.
    """
    stated, group = np.isfinite(search.stated[estimate.used]), search.forward.group[estimate.used]
    likelihood = float(np.sum(estimate.residuals[stated] ** 2 + 2 * np.log(estimate.sigma[estimate.used][stated])))
    estimated = np.unique(group[~stated])
    for k in estimated:
        part = (estimate.residuals * estimate.sigma[estimate.used])[group == k]
        likelihood += len(part) * (1 + math.log(max(float(np.mean(part**2)), 1e-300)))
    n, k = len(estimate.residuals), len(estimate.x) + len(estimated)
    return likelihood + 2 * k + (2 * k * (k + 1) / (n - k - 1) if n > k + 1 else math.inf)


def _warnings(
    search: Search, estimate: Estimate, signals: tuple[FittedSignal, ...], values: list[FittedValue], share: float
) -> list[str]:
    """Return what to heed before the numbers are believed."""
    warnings, forward = [], search.forward
    if not estimate.converged:
        warnings.append("the search ended before it converged")
    if share < 1:
        warnings.append(
            f"{1 - share:.0%} of the data lie beyond the horizon, where the run's own error exceeds a tenth of the noise: they are omitted; "
            "a shorter record, a smaller tolerance, or statistics of them (fit_moments)"
        )
    lost = int(np.sum(~np.isfinite(forward.at(estimate.x).predicted) & estimate.used))
    if lost:
        warnings.append(f"the best fit has no value for {lost} of the data: its run has fewer impacts, or ended before")
    warnings += [
        f"{value.name} lies at an end of its range, {value.low:.6g}..{value.high:.6g} {value.unit}"
        for value in values
        if value.at_end(value.value)
    ]
    for signal in signals:
        residual = signal.residual
        if residual is None or residual.samples < FEWEST or signal.by_impacts:
            continue
        if residual.independent < CORRELATED * residual.samples:
            warnings.append(
                f"{signal.channel.column}: neighbouring residuals are correlated, {residual.samples} of them are worth {residual.independent:.0f}: "
                "the model or the stated noise is wrong, and the intervals are too narrow"
            )
    for run in forward.at(estimate.x).runs:
        if run is not None:
            warnings += run.warnings
    return list(dict.fromkeys(warnings))
