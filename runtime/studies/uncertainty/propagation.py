"""Uncertainty of a run's numbers: by the derivatives of one run, and by samples, side by side.

1. distributions   of parameters and starts, in SI                        studies/uncertainty/distributions
2. one run         at their means, and the derivatives of its outputs     engine/sensitivity/output_derivatives
3. samples         A, B and A with a column of B, a run for each          studies/sweeps/parameter_sweep
4. indices         parts of the variance, by Saltelli's estimators        scipy.stats.sobol_indices
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown
from hertzwerk.runtime.engine.inputs.input_values import Input
from hertzwerk.runtime.engine.model.binding import Value, flag_faults, whole_faults
from hertzwerk.runtime.engine.model.free_quantities import quantities
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.engine.run.run_request import METHOD, Accuracy, Compiled, duration_follows
from hertzwerk.runtime.engine.sensitivity.output_derivatives import NoDerivativeError, OutputDerivatives
from hertzwerk.runtime.engine.solution.outcome import REACHED_END
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.sweeps.parameter_sweep import outputs_of, refused_by_sweep, sweep
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Measured
from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep
from hertzwerk.runtime.studies.uncertainty.correlation import Correlated, correlated_parts, covariance, read_correlation
from hertzwerk.runtime.studies.uncertainty.distributions import Distribution, read_distributions
from hertzwerk.runtime.studies.uncertainty.propagation_result import Index, Propagated, Uncertain

if TYPE_CHECKING:
    from distributed import Client


RESAMPLED = 200  # times that the samples are drawn from themselves, for the intervals of indices
INSIDE = 2.0**-31  # half the spacing of Sobol's points, so that none is at an end of a distribution
LEAST, MOST = 8, 2**20


def propagate(
    target: Target,
    uncertain: Mapping[str, Distribution | str] | Correlated,
    outputs: Sequence[str] = (),
    *,
    correlation: Mapping[str, float] | None = None,
    sample: int = 256,
    indices: bool | None = None,
    seed: int = 0,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    functions: Mapping[str, Callable[[Solution], float]] | None = None,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    workers: int | None = None,
    client: Client | None = None,
    out: str | Path | None = None,
    widen: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Propagated:
    """Propagate parameter uncertainty to outputs: first order and Monte Carlo, with Sobol indices.

    target      a scene or a Model, as `simulate` takes it
    uncertain   parameters and initial states with their distributions, or those of a fit, `fit(...).distribution()`:
                {"clearance": Normal("0.5 mm", "0.02 mm"), "restitution": TruncatedNormal(0.9, 0.05, 0, 1)}, or as text
                "Normal(0.5 mm, 0.02 mm)"
    outputs     names as of `sweep`: "slider_pin.peak_force", "final.guide.travel", "main_bearing.reaction_x.rms"
    correlation    correlations of normal scores: {"clearance, restitution": -0.8}; others are independent
    sample      number N of samples, a power of two; N (d + 2) runs with indices, of d uncertain names, else N
    indices     Sobol indices of first order and total, by SciPy's estimators, with intervals by resampling. The default is True where all
                are independent: the variance due to correlated quantities is no sum of parts
    functions   further outputs, which have no derivatives

    The other arguments are those of `sweep`. With `out` every run is stored, and the same call resumes. A warning names outputs whose two
    spreads differ by more than their errors. Raises InputError with every fault.
    """
    model = engine_model(target)
    known = quantities(model)
    faults: list[Fault] = []
    # 1. distributions
    if isinstance(uncertain, Correlated):
        if correlation is not None:
            faults.append(Fault("correlation", "beside Correlated", "one of the two"))
        correlation, uncertain = uncertain.correlation, uncertain.distributions
    drawn = read_distributions(model, uncertain, known, faults)
    together = read_correlation(tuple(uncertain) if isinstance(uncertain, Mapping) else (), correlation, faults)
    tied = [name for name, row in zip(drawn, together, strict=False) if np.count_nonzero(row) > 1]
    if indices is True and tied:
        found_tied = f"indices of {', '.join(tied)}, which are correlated"
        faults.append(
            Fault("indices", found_tied, "independent quantities", "indices=False: the samples give the spread")
        )
    indices = not tied if indices is None else indices
    faults += [*_sample_faults(sample, indices), *whole_faults(seed=seed)]
    settings: dict[str, Any] = {
        **{"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method},
        **{"max_steps": max_steps, "max_events": max_events, "wall_time": wall_time, "compiled": compiled},
    }
    values: dict[str, Any] = {"parameters": parameters, "initial": initial, "inputs": inputs}
    arguments = {**values, "outputs": outputs, "functions": functions, **settings}
    arguments |= {"out": out, "widen": widen, "client": client, "progress": progress}
    faults += refused_by_sweep({**arguments, "target": model}, workers)
    refuse(f"propagation of {model.name}", faults)
    # 2. one run
    means = {name: (float(one.mean()), known[name] or "1") for name, one in drawn.items()}
    run = simulate(model, **settings, **{**values, "parameters": {**(parameters or {}), **means}})
    derivatives, lacking = _derivatives(run, tuple(drawn), duration)
    # 3. samples
    matrices = _matrices(list(drawn.values()), together, sample, seed, indices=indices)
    columns = np.concatenate([*matrices], axis=1)
    over = {name: [(float(x), known[name] or "1") for x in row] for name, row in zip(drawn, columns, strict=True)}
    rows = sweep(model, over, zip=True, workers=workers, **arguments)
    # 4. indices
    spreads = covariance(list(drawn.values()), together)
    good = np.array([row.outcome in REACHED_END for row in rows])
    measured, results = Measured(run), {}
    for output in outputs_of(model, outputs, functions, {}, []):
        name, unit = next(iter(output.columns.items()))
        change, why = (
            _gradient(derivatives, name) if derivatives is not None else (np.full(len(drawn), math.nan), lacking)
        )
        parts = np.abs(change) * np.sqrt(np.diag(spreads))
        spread = _Spread(np.where(good, rows[name], math.nan).reshape(-1, sample))
        first, total = spread.indices(tuple(drawn), seed) if indices else ({}, {})
        results[name] = Uncertain(
            name=name,
            unit=unit,
            nominal=output.of(measured)[0],
            derivatives=dict(zip(drawn, change.tolist(), strict=True)),
            linear=float(np.sqrt(change @ spreads @ change)),
            parts=dict(zip(drawn, parts.tolist(), strict=True)),
            reason=why,
            first=first,
            total=total,
            **spread.moments(),
        )
    named = {
        f"{a}, {b}": float(together[i, j])
        for i, a in enumerate(drawn)
        for j, b in enumerate(drawn)
        if i < j and together[i, j]
    }
    notes = (*_of_run(run), *_missing(rows, good, indices=indices))
    draws = sample * (2 if indices else 1)
    return Propagated(model.name, tuple(drawn), results, run, rows, draws, notes, named)


def _sample_faults(sample: object, indices: object) -> list[Fault]:
    """Return the faults of what is said of the samples."""
    faults = []
    whole = isinstance(sample, int) and not isinstance(sample, bool)
    if not whole or not LEAST <= sample <= MOST or sample & (sample - 1):  # type: ignore[operator]
        expected = f"a power of two, {LEAST} to {MOST:,}, as Sobol points are balanced"
        faults.append(Fault("sample", shown(sample), expected))
    return [*faults, *flag_faults(indices=indices)]


def _derivatives(run: Solution, names: tuple[str, ...], duration: object) -> tuple[OutputDerivatives | None, str]:
    """Return the derivatives of a run's outputs; None with the reason where there are none."""
    if run.outcome.name not in REACHED_END:
        return None, f"the run at the means ended: {run.outcome.message}"
    if duration_follows(run.engine.model, names, duration):
        return None, f"the duration {duration} changes with what is uncertain: state it as a time"
    try:
        whole = with_steps(run)
        return OutputDerivatives(whole, run.sensitivities(*names)), ""
    except InputError as error:
        return None, "; ".join(f"{fault.where}: {fault.found}" for fault in error.faults)


def _gradient(derivatives: OutputDerivatives, name: str) -> tuple[np.ndarray, str]:
    """Return the derivatives (P,) of an output; nan with the reason where there are none."""
    try:
        return derivatives[name], ""
    except NoDerivativeError as error:
        return np.full(len(derivatives.of.names), math.nan), str(error)


def _matrices(
    drawn: list[Any], correlation: np.ndarray, sample: int, seed: int, *, indices: bool
) -> Iterator[np.ndarray]:
    """Yield points (d, N): A, and for indices B, and A with each row of B in turn."""
    from scipy.stats import qmc

    d = len(drawn)
    points = qmc.Sobol(2 * d if indices else d, rng=seed).random(sample).T + INSIDE
    A, *others = (
        np.array([one.ppf(part) for one, part in zip(drawn, correlated_parts(half, correlation), strict=True)])
        for half in np.split(points, 2 if indices else 1)
    )
    yield A
    for B in others:
        yield B
        for i in range(d):
            yield np.where(np.arange(d)[:, None] == i, B, A)


@dataclass(frozen=True)
class _Spread:
    """Values (matrices, N) of one output in the samples, nan where there is none."""

    values: np.ndarray

    def moments(self) -> dict[str, float]:
        """Return mean and standard deviation with their errors, and quantiles, of A and B: independent draws."""
        values = self.values[:2].ravel()
        values = values[np.isfinite(values)]
        n = len(values)
        if n < 2:
            return dict.fromkeys(("mean", "mean_error", "std", "std_error", "low", "high"), math.nan)
        mean, std = float(values.mean()), float(values.std(ddof=1))
        fourth = float(((values - mean) ** 4).mean())
        low, high = np.quantile(values, [0.025, 0.975])
        return {
            **{"mean": mean, "mean_error": std / math.sqrt(n), "std": std, "low": float(low), "high": float(high)},
            "std_error": math.sqrt(max(fourth - std**4, 0) / n) / (2 * std) if std > 0 else 0.0,
        }

    def indices(self, names: tuple[str, ...], seed: int) -> tuple[dict[str, Index], dict[str, Index]]:
        """Return the Sobol indices of first order and total; none of missing values, or of equal ones."""
        if not np.isfinite(self.values).all() or np.ptp(self.values) == 0:
            return {}, {}
        rng, n = np.random.default_rng(seed), self.values.shape[1]
        estimated = _indices(self.values)
        again = np.array([_indices(self.values[:, rng.integers(n, size=n)]) for _ in range(RESAMPLED)])
        low, high = np.quantile(again, [0.025, 0.975], axis=0)
        first, total = (
            {
                name: Index(*map(float, row))
                for name, row in zip(names, np.transpose([estimated[k], low[k], high[k]]), strict=True)
            }
            for k in range(2)
        )
        return first, total


def _indices(values: np.ndarray) -> np.ndarray:
    """Return indices (2, d) of first order and total from values (2 + d, N) at A, B, and A with rows of B."""
    from scipy.stats import sobol_indices

    twice = np.stack([values, values], axis=1)  # of one output by one name SciPy 1.17 loses the shape
    indices = sobol_indices(func={"f_A": twice[0], "f_B": twice[1], "f_AB": twice[2:]}, n=values.shape[1])
    return np.array([order.reshape(2, -1)[0] for order in (indices.first_order, indices.total_order)])


def _of_run(run: Solution) -> Iterator[str]:
    """Yield what is to be known of the run at the means."""
    if not run.outcome.finished:
        yield f"the run at the means: {run.outcome.name}: {run.outcome.message}"


def _missing(rows: Sweep, good: np.ndarray, *, indices: bool) -> Iterator[str]:
    """Yield what the samples lack."""
    if not rows.outcome.finished:
        yield f"{rows.outcome.message}; {rows.outcome.remedy}"
    if not good.all():
        first = next(row for row, fine in zip(rows, good, strict=True) if not fine)
        lost = "; without them there are no Sobol indices" if indices else ""
        yield f"{int((~good).sum())} of {len(good)} runs are omitted, the first because: {first.outcome}: {first.message}{lost}"
