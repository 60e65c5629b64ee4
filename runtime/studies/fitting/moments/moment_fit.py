"""Fit of simulated moments: statistics of runs beyond their horizon.

The tangent of a long average diverges in chaos. Derivatives come from a quadratic regression over runs at points of a
Latin hypercube, whose scatter is the covariance of the runs' own statistics; the box of the points then closes in on the
best, and runs are made again (McFadden, Econometrica 57 (1989) 995).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown
from hertzwerk.runtime.engine.model.binding import Value, flag_faults, read_state, whole_faults
from hertzwerk.runtime.engine.model.free_quantities import Free, read_free
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.ranges import Range, hypercube
from hertzwerk.runtime.engine.run.run_request import progress_of
from hertzwerk.runtime.studies.comparison.series_moments import QUANTILE
from hertzwerk.runtime.studies.fitting.fit_result import Estimates, FittedValue, Goodness
from hertzwerk.runtime.studies.fitting.intervals import LEVEL, Interval, identified
from hertzwerk.runtime.studies.fitting.moments.measured_moments import (
    MeasuredSeries,
    SeriesMoments,
    columns,
    read_series,
)
from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import chosen
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PER_FEATURE = 5  # runs for each coefficient of the regression
ROUNDS = 3  # most boxes
AROUND = 4.0  # standard errors of a quantity that the next box holds, to each side
SMALLEST = 0.1  # of the box before
TOLERANCE = 1e-6  # local, of the runs
PLACES = 61  # of a profile, over the box
REGULAR = 1e-3  # of a correlation: least that it is shrunk by
FAR = 3.0  # deviations of the run at the best fit from the regression that are reported


@dataclass(frozen=True)
class Moment:
    """Measured statistic [SI] with the standard deviation of the measured value, and that of the best fit."""

    name: str
    unit: str
    value: float
    deviation: float
    fitted: float = math.nan
    fitted_deviation: float = math.nan

    def __str__(self) -> str:
        unit = "" if self.unit in ("", "1") else f" {self.unit}"
        deviations = (self.value - self.fitted) / math.hypot(self.deviation, self.fitted_deviation)
        fitted = f"fitted {self.fitted:.5g} +- {self.fitted_deviation:.2g}"
        return f"measured {self.value:.5g} +- {self.deviation:.2g}{unit}, {fitted}: {deviations:+.2f} deviations"


@dataclass(frozen=True)
class Profile:
    """Objective along a quantity less its least (n,), all else fitted anew at each place (n,) [SI]."""

    places: Array
    rises: Array


@dataclass(frozen=True)
class MomentFit(Estimates):
    """Fit of parameters to statistics of long runs, as `fit_moments` returns it."""

    moments: tuple[Moment, ...]
    profiles: Mapping[str, Profile]

    data: ClassVar[str] = "statistics"
    judgement: ClassVar[tuple[str, str]] = (
        "the stated deviations explain what differs",
        "the stated deviations do not explain what differs",
    )

    @property
    def subject(self) -> str:
        """Scene, data and number of runs."""
        return f"{self.scene} to {len(self.moments)} statistics: {self.runs_made:,} runs"

    def details(self) -> Iterator[tuple[str, str]]:
        """Yield each statistic, fitted and measured."""
        return ((moment.name, str(moment)) for moment in self.moments)

    def plot(self) -> Figure:
        """Draw fitted statistics beside measured ones, and the objective along each quantity."""
        from hertzwerk.runtime.studies.fitting.moments import plot_moments

        return plot_moments.figure(self)

    def record(self) -> dict[str, Any]:
        """Return everything as plain numbers, in SI."""
        return {
            **super().record(),
            "moments": [asdict(moment) for moment in self.moments],
            "profiles": {name: {k: v.tolist() for k, v in vars(one).items()} for name, one in self.profiles.items()},
        }


@dataclass(frozen=True)
class MomentFitRequest:
    """Request for a fit of moments; raises nothing: `read_moment_fit` checks."""

    model: EngineModel
    free: tuple[Free, ...]
    moments: tuple[Moment, ...]
    half_widths: tuple[str, ...]  # names of the columns with half the width of a run's own 95 % interval, empty without
    series: tuple[SeriesMoments, ...]  # of the last of the moments, which have no value stated
    how: Mapping[str, Any]
    seed: int
    independent: bool  # whether stated values are of records of their own, else of one

    def covariance(self, of_runs: Array) -> Array:
        """Return the covariance (m, m) of the measured values.

        of_runs    correlation (m, m) of the statistics of a run, which those of one record have
        """
        deviations, end = np.array([moment.deviation for moment in self.moments]), len(self.half_widths)
        covariance: Array = np.diag(deviations**2)
        if not self.independent:
            covariance[:end, :end] = (np.outer(deviations, deviations) * of_runs)[:end, :end]
        for one in self.series:
            among = slice(end, end := end + len(one.names))
            covariance[among, among] = one.measured.covariance
        return covariance

    @property
    def sweeps(self) -> list[tuple[Mapping[str, Value], list[SeriesMoments]]]:
        """Values that runs are made at, with the series of each; first the fit's own for stated ones."""
        plain = self.how.get("parameters") or {}
        made_at = [plain] if self.half_widths else []
        made_at += [
            one.values
            for k, one in enumerate(self.series)
            if one.values not in [*made_at, *(each.values for each in self.series[:k])]
        ]
        return [(values, [one for one in self.series if one.values == values]) for values in made_at]

    @property
    def correlation(self) -> Array:
        """Correlation (m, m) of the measured values, of stated ones none."""
        deviations = np.array([moment.deviation for moment in self.moments])
        return self.covariance(np.eye(len(deviations))) / np.outer(deviations, deviations)


def read_moment_fit(
    model: EngineModel,
    moments: object,
    free: object,
    how: Mapping[str, Any],
    seed: int,
    before: Sequence[Fault] = (),
    series: Sequence[MeasuredSeries] = (),
    *,
    independent: bool = False,
) -> MomentFitRequest:
    """Read a fit of moments; raises InputError with every fault but those that a sweep finds.

    moments    by name of a sweep's output, each (value, standard deviation), or text "412 +- 5 1/s"; None for COLUMN.KIND
               of the measured series, each with values of its own that it was made at
    how        further arguments of `sweep`
    """
    faults = [*before, *whole_faults(seed=seed), *flag_faults(independent=independent)]
    freed = read_free(model, free, faults)
    stated: list[Moment] = []
    half_widths: list[str] = []
    if not isinstance(moments, Mapping) or not moments:
        faults.append(
            Fault(
                "moments",
                shown(moments),
                'statistics by name, such as {"slider_pin.impact_rate": ("412 1/s", "5 1/s")}',
            )
        )
        moments = {}
    computed = read_series(
        model, [name for name, entry in moments.items() if entry is None], series, how.get("parameters"), faults
    )
    moments = {name: entry for name, entry in moments.items() if entry is not None}
    wrong = len(faults)
    outputs = chosen(model, list(moments), faults)
    for output, (name, entry) in zip(outputs, moments.items(), strict=False) if len(faults) == wrong else ():
        pair = _pair(entry)
        if pair is None:
            faults.append(Fault(name, shown(entry), 'a value and its standard deviation, "412 +- 5 1/s"'))
            continue
        unit = output.columns[name] or "1"
        read = [read_state(name, unit, each) for each in pair]
        faults += [fault for _, fault in read if fault is not None]
        if all(fault is None for _, fault in read) and not read[1][0] > 0:
            faults.append(Fault(name, shown(entry), "a positive standard deviation"))
        stated.append(Moment(name, unit, read[0][0], read[1][0]))
        half_widths.append(next(iter(list(output.columns)[1:]), ""))
    for one in computed:
        measured = zip(one.names, one.units, one.measured.values, one.measured.deviations, strict=True)
        stated += [Moment(name, unit, float(value), float(deviation)) for name, unit, value, deviation in measured]
    if stated and len(stated) < len(freed):
        faults.append(Fault("moments", f"{len(stated)} statistics", f"at least {len(freed)}, as many as are free"))
    refuse(f"fit of {model.name}", faults)
    if computed:
        how = {"duration": max(one.sight.lasts for one in computed), **how}
    return MomentFitRequest(model, freed, tuple(stated), tuple(half_widths), computed, how, seed, independent)


def _pair(entry: object) -> tuple[Value, Value] | None:
    if isinstance(entry, str):
        value, sign, deviation = entry.partition("+-")
        if not sign:
            return None
        unit = deviation.strip().partition(" ")[2]
        plain = value.strip()
        return (plain if " " in plain or not unit else f"{plain} {unit}"), deviation.strip()
    return entry if isinstance(entry, tuple) and len(entry) == 2 else None


def fitted_moments(request: MomentFitRequest, progress: Callable[[float], object] | None = None) -> MomentFit:
    """Return the fit of moments; raises InputError where too few runs finish."""
    free, count = request.free, len(request.free)
    full = np.array([each.bounds for each in free])
    box, features = full.copy(), 1 + count + count * (count + 1) // 2
    places, numbers, noise = np.zeros((0, count)), *np.zeros((2, 0, len(request.moments)))
    made = 0
    for number in range(ROUNDS):
        report = progress_of(progress, number, ROUNDS)
        tried = PER_FEATURE * features
        x, y, own, why = _runs(request, _spread(request.free, box), report, sample=tried, seed=request.seed + number)
        places, numbers, noise = np.vstack([places, x]), np.vstack([numbers, y]), np.vstack([noise, own])
        made += tried
        inside = np.all((places >= box[:, 0]) & (places <= box[:, 1]), axis=1)
        if np.sum(inside) < features + 2:
            fault = Fault(
                "free",
                f"{int(np.sum(inside))} of {tried} runs that finish with these statistics",
                f"at least {features + 2}",
                why,
            )
            raise InputError(f"fit of {request.model.name}", [fault])
        known = np.sum(np.isfinite(noise[inside]), axis=0)  # a run may be too short to tell its own
        own_noise = np.nansum(noise[inside], axis=0) / np.maximum(known, 1)
        surface = _Surface(places[inside], numbers[inside], own_noise, request.correlation, box)
        best, covariance, jacobian = _least(request, surface)
        errors = np.sqrt(np.diag(np.linalg.pinv(jacobian.T @ np.linalg.solve(covariance, jacobian))))
        half = np.clip(AROUND * errors, SMALLEST * np.ptp(box, axis=1) / 2, np.ptp(box, axis=1) / 2)
        closer = np.clip(np.column_stack([best - half, best + half]), full[:, :1], full[:, 1:])
        if number + 1 == ROUNDS or np.all(np.ptp(closer, axis=1) > 0.7 * np.ptp(box, axis=1)):
            break
        box = closer
    return _concluded(request, surface, best, covariance, jacobian, made, full)


def _spread(free: Sequence[Free], box: Array) -> dict[str, str]:
    """Return the ranges of a box as a sweep takes them."""
    return {
        each.name: str(Range(each.outer(low), each.outer(high), each.unit, each.log))
        for each, (low, high) in zip(free, box.tolist(), strict=True)
    }


def _runs(
    request: MomentFitRequest, over: Mapping[str, Any], progress: Callable[[float], object] | None, **points: Any
) -> tuple[Array, Array, Array, str]:
    """Return places (n, k) of finished runs, statistics (n, moments), their variances, why one is lost."""
    stated = [moment.name for moment in request.moments[: len(request.half_widths)]]
    how, sweeps = {"tolerance": TOLERANCE, **request.how}, request.sweeps
    numbers, there, why, x = dict[str, Array](), np.ones(0, dtype=bool), "", np.zeros((0, 0))
    for number, (values, series) in enumerate(sweeps):
        report = progress_of(progress, number, len(sweeps))
        functions = {name: function for one in series for name, function in one.functions().items()}
        own = stated if number == 0 else []
        how["parameters"] = values
        table = sweep(request.model, over, outputs=own, functions=functions, progress=report, **points, **how)
        if table.interrupted:
            raise KeyboardInterrupt
        x = np.column_stack([[free.inner(float(v)) for v in table[free.name]] for free in request.free])
        half = [name for name in request.half_widths if name] if number == 0 else []
        numbers |= {name: np.asarray(table[name], dtype=float) for name in (*own, *half, *functions)}
        ended = np.array([row["outcome"] == "finished" for row in table])
        there = ended if number == 0 else there & ended
        lost = next((row for row, stays in zip(table, ended, strict=True) if not stays), None)
        if lost is not None and not why:
            why = f"{lost['outcome']}: {lost['message']}" if lost["message"] else str(lost["outcome"])
    of_series = [columns(name) for one in request.series for name in one.names]
    y = np.column_stack([numbers[name] for name in (*stated, *(name for name, _ in of_series))])
    own_half = [numbers[name] / QUANTILE if name else np.zeros(len(x)) for name in request.half_widths]
    noise = np.column_stack([*own_half, *(numbers[name] for _, name in of_series)])
    there &= np.all(np.isfinite(y), axis=1)
    return x[there], y[there], noise[there] ** 2, why


class _Surface:
    """Quadratic regression of statistics (n, moments) over places (n, k) in a box.

    noise    variances (moments,) of one run's statistics by its own account: what scatters more is no quadratic function,
             what scatters less is an error that all runs share, as those pushed by the same random input do,
             with the correlation (moments, moments) of the measured values
    """

    def __init__(self, places: Array, numbers: Array, noise: Array, correlation: Array, box: Array) -> None:
        self.middle, self.half = np.mean(box, axis=1), np.ptp(box, axis=1) / 2
        design = np.array([self._features(x) for x in places])
        self.coefficients, *_ = np.linalg.lstsq(design, numbers, rcond=None)
        left = numbers - design @ self.coefficients
        freedom = len(places) - design.shape[1]
        self.scatter: Array = left.T @ left / freedom
        self.correlation = correlation_of(self.scatter, noise > 0, freedom)
        more = np.diag(self.scatter) - noise
        shared = np.sqrt(np.maximum(-more, 0.0))
        self.misfit = np.diag(np.maximum(more, 0.0)) + np.outer(shared, shared) * correlation
        self._inverse = np.linalg.pinv(design.T @ design)
        self.box = box

    def _features(self, x: Array) -> Array:
        z = (x - self.middle) / self.half
        rows, columns = np.triu_indices(len(z))
        return np.concatenate([[1.0], z, z[rows] * z[columns]])

    def at(self, x: Array) -> Array:
        """Return the statistics (moments,) at a place."""
        statistics: Array = self._features(x) @ self.coefficients
        return statistics

    def covariance(self, x: Array) -> Array:
        """Return the covariance (moments, moments) of what the regression says there."""
        f = self._features(x)
        return self.scatter * float(f @ self._inverse @ f) + self.misfit

    def jacobian(self, x: Array) -> Array:
        """Return the derivatives (moments, k) of the statistics."""
        step = 1e-3 * self.half
        columns = [(self.at(x + d) - self.at(x - d)) / (2 * s) for d, s in zip(np.diag(step), step, strict=True)]
        return np.column_stack(columns)


def correlation_of(scatter: Array, varies: NDArray[np.bool_], freedom: int) -> Array:
    """Return the correlation (m, m) of the statistics of runs that vary (m,), of others none.

    scatter    (m, m) of them, from as many residuals as `freedom`. It is shrunk towards none by the part of it that chance explains:
               Schaefer, Strimmer, Stat. Appl. Genet. Mol. Biol. 4 (2005) 32, with the variance (1 - r^2)^2/freedom of normal numbers
    """
    sizes = np.sqrt(np.where(varies, np.diag(scatter), 0.0))
    pairs = np.outer(sizes, sizes) > 0
    np.fill_diagonal(pairs, val=False)
    r: Array = np.where(pairs, scatter, 0.0) / np.where(pairs, np.outer(sizes, sizes), 1.0)
    by_chance, squares = float(np.sum((1 - r[pairs] ** 2) ** 2)) / freedom, float(np.sum(r**2))
    r *= 1 - max(REGULAR, min(by_chance / squares, 1.0) if squares else 1.0)
    np.fill_diagonal(r, 1.0)
    return r


def _least(request: MomentFitRequest, surface: _Surface) -> tuple[Array, Array, Array]:
    """Return the best place, the covariance of what differs there, and the derivatives of the statistics."""
    from scipy.optimize import least_squares  # slow to import

    measured = np.array([moment.value for moment in request.moments])
    stated = request.covariance(surface.correlation)
    low, high = surface.box.T
    best = surface.middle
    for _ in range(3):  # the covariance is that at the best
        root = np.linalg.cholesky(stated + surface.covariance(best))
        starts = [best, *hypercube(surface.box, 8, 0)]
        minima = [
            least_squares(
                lambda x, root=root: np.linalg.solve(root, measured - surface.at(x)),
                np.clip(start, low + 1e-9 * (high - low), high - 1e-9 * (high - low)),
                jac=lambda x, root=root: -np.linalg.solve(root, surface.jacobian(x)),
                bounds=(low, high),
            )
            for start in starts
        ]
        best = min(minima, key=lambda each: each.cost).x
    return best, stated + surface.covariance(best), surface.jacobian(best)


def _concluded(
    request: MomentFitRequest,
    surface: _Surface,
    best: Array,
    covariance: Array,
    jacobian: Array,
    made: int,
    full: Array,
) -> MomentFit:
    from scipy.stats import chi2, norm  # slow to import

    root = np.linalg.cholesky(covariance)
    known = identified(np.linalg.solve(root, jacobian), request.free)
    errors, quantile = np.sqrt(np.diag(known.covariance)), float(norm.ppf((1 + LEVEL) / 2))
    how = "simulated moments: profile of the objective over a regression of runs, covariance of measured values and of that"
    values, profiles, warnings = {}, {}, list[str]()
    for j, each in enumerate(request.free):
        low, high = full[j]
        places, rises = _profile(request, surface, root, best, j)
        profiles[each.name] = Profile(np.array([each.outer(float(x)) for x in places]), rises)
        ends, determined = _ends(places, rises, best[j], quantile), not known.concerned(j)
        if determined and any(
            math.isnan(end) and edge not in (low, high) for end, edge in zip(ends, surface.box[j], strict=True)
        ):
            warnings.append(
                f"{each.name}: its interval extends beyond the runs of the regression, where it rests on curvature alone"
            )
        linear = best[j] - quantile * errors[j], best[j] + quantile * errors[j]
        ends = (linear[0] if math.isnan(ends[0]) else ends[0]), (linear[1] if math.isnan(ends[1]) else ends[1])
        ends = ends if determined else (low, high)
        interval = Interval(
            each.outer(float(max(ends[0], low))),
            each.outer(float(min(ends[1], high))),
            how if determined else "none: it is in a combination that the statistics do not identify",
            bool(ends[0] <= low),
            bool(ends[1] >= high),
        )
        values[each.name] = FittedValue.of(each, each.outer(float(best[j])), interval)
    at, deviations = surface.at(best), np.sqrt(np.diag(surface.covariance(best)))
    moments = tuple(
        Moment(m.name, m.unit, m.value, m.deviation, float(value), float(deviation))
        for m, value, deviation in zip(request.moments, at, deviations, strict=True)
    )
    warnings += _checked(request, surface, values)
    residual = np.linalg.solve(root, np.array([m.value for m in request.moments]) - at)
    freedom, square = len(moments) - len(best), float(residual @ residual)
    goodness = Goodness(square, freedom, float(chi2.sf(square, freedom))) if freedom > 0 else None
    warnings += [
        f"{m.name}: runs and regression are less certain than the measured value: take longer runs or a narrower range"
        for m in moments
        if m.fitted_deviation > m.deviation
    ]
    warnings += [f"{value.name} lies at an end of its range" for value in values.values() if value.at_end(value.value)]
    unidentified = known.unidentified([value.value for value in values.values()], len(values))
    return MomentFit(
        request.model.name, values, known, tuple(unidentified), goodness, made, tuple(warnings), moments, profiles
    )


def _profile(
    request: MomentFitRequest, surface: _Surface, root: NDArray[np.floating[Any]], best: Array, j: int
) -> tuple[Array, Array]:
    """Return places along a quantity within the box of the regression, and what the objective rises there."""
    from scipy.optimize import least_squares  # slow to import

    measured, moving = np.array([moment.value for moment in request.moments]), np.arange(len(best)) != j
    low, high = surface.box[moving].T

    def residual(x: Array) -> Array:
        return np.asarray(np.linalg.solve(root, measured - surface.at(x)))

    def fitted(x: Array) -> Array:
        """Return the best place from a near one, the quantity held."""
        place = x.copy()
        if np.any(moving):
            inside = np.clip(x[moving], low + 1e-9 * (high - low), high - 1e-9 * (high - low))
            place[moving] = least_squares(lambda part: residual(np.insert(part, j, x[j])), inside, bounds=(low, high)).x
        return place

    grid = np.linspace(surface.box[j, 0], surface.box[j, 1], PLACES)
    rises = {float(best[j]): 0.0}
    for side in (grid[grid > best[j]], grid[grid < best[j]][::-1]):
        near = best
        for place in side:
            near = fitted(np.where(moving, near, place))
            rises[float(place)] = float(np.sum(residual(near) ** 2) - np.sum(residual(best) ** 2))
    places = np.array(sorted(rises))
    return places, np.array([rises[place] for place in places.tolist()])


def _ends(places: Array, rises: Array, best: float, quantile: float) -> tuple[float, float]:
    """Return where the root of the rises first exceeds a quantile to each side; nan where it does not."""
    roots, ends = np.sqrt(np.maximum(rises, 0.0)), []
    for side in (np.flatnonzero(places <= best)[::-1], np.flatnonzero(places >= best)):
        above = np.flatnonzero(roots[side] > quantile)
        k = side[: above[0] + 1][-2:] if len(above) else side[:0]
        ends.append(float(np.interp(quantile, roots[k], places[k])) if len(k) else math.nan)
    return ends[0], ends[1]


def _checked(request: MomentFitRequest, surface: _Surface, values: Mapping[str, FittedValue]) -> list[str]:
    """Return in what a run at the best fit is not as the regression says."""
    over = {value.name: [(value.value, value.unit)] for value in values.values()}
    x, y, noise, _ = _runs(request, over, None)
    if not len(x):
        return ["the run at the best fit does not finish with these statistics"]
    at = surface.at(x[0])
    sizes = np.sqrt(np.diag(surface.covariance(x[0])) + np.nan_to_num(noise[0]) + np.diag(surface.scatter))
    return [
        f"{moment.name}: a run at the best fit has {simulated:.5g}, the regression {said:.5g}: the range is too wide for a quadratic function"
        for moment, simulated, said, size in zip(request.moments, y[0], at, sizes, strict=True)
        if abs(simulated - said) > FAR * size
    ]
