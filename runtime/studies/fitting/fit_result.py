"""Fitted parameters in numbers, words and JSON."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.model.free_quantities import Free
from hertzwerk.runtime.output.tables.notebook import Sentences
from hertzwerk.runtime.simulation import Solution
from hertzwerk.runtime.studies.comparison.comparison_request import Channel
from hertzwerk.runtime.studies.comparison.residuals import Residual
from hertzwerk.runtime.studies.fitting.experiment import Observed
from hertzwerk.runtime.studies.fitting.intervals import LEVEL, Identified, Interval
from hertzwerk.runtime.studies.uncertainty.correlation import Correlated
from hertzwerk.runtime.studies.uncertainty.distributions import Distribution, LogNormal, Normal, TruncatedNormal
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure

REJECTED = 0.05  # p-value below which noise alone does not explain the residuals
CORRELATED = 0.5  # part of the residuals that are worth independent ones, below which intervals are too narrow
FAR = 5.0  # deviations within which an end of the range cuts a distribution
CLOSE = 0.95  # correlation of estimates that is told


@dataclass(frozen=True)
class FittedValue(Free):
    """Fitted quantity [SI]: its value and 95 % interval, within the range that was searched."""

    interval: Interval

    @classmethod
    def of(cls, free: Free, value: float, interval: Interval, unit: str | None = None) -> FittedValue:
        """Return what was free, fitted."""
        return cls(**{**vars(free), "value": value, "unit": unit or free.unit}, interval=interval)

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        digits = _digits(self.value, self.interval)
        low, high = _ends(self.interval, digits)
        other = " and ".join(parse_unit(self.unit).free_names)
        return f"{self.value:.{digits}g}{unit} ({low} to {high}){f', its unit depends on {other}' if other else ''}"


@dataclass(frozen=True)
class FittedSignal:
    """Measured column of one run beside the best fit.

    at          times [s] of the samples or numbers of the impacts (n,); measured, predicted there [SI]
    used        which of them the fit rests on; sigma: standard deviation of the noise, stated or estimated
    residual    of those used; None where there are none
    """

    run: str
    channel: Channel
    by_impacts: bool
    at: Array
    measured: Array
    predicted: Array
    used: NDArray[np.bool_]
    sigma: float
    stated: bool
    residual: Residual | None


@dataclass(frozen=True)
class Goodness:
    """Sum of squares over the stated noise, and the chance that noise alone gives as much."""

    chi_square: float
    freedom: int
    p_value: float


@dataclass(frozen=True)
class Estimates(Sentences):
    """Fitted quantities of a scene, of whatever data.

    values      what was fitted, by name
    known       singular values, combinations, correlation
    unidentified      combinations of quantities that the data do not identify, in words; their values are not to be used
    goodness    None where the deviations of the data are not stated, or nothing is left over
    data, judgement    what they are called; what is said where their deviations explain the difference, and where not
    """

    data: ClassVar[str] = "data"
    judgement: ClassVar[tuple[str, str]]

    scene: str
    values: Mapping[str, FittedValue]
    known: Identified
    unidentified: tuple[str, ...]
    goodness: Goodness | None
    runs_made: int
    warnings: tuple[str, ...]

    @property
    def explained(self) -> bool | None:
        """Return whether the stated deviations explain what differs, at 5 %; None where they are not judged."""
        return None if self.goodness is None else self.goodness.p_value >= REJECTED

    def __getitem__(self, name: str) -> FittedValue:
        """Fitted quantity; raises KeyError for an unknown name."""
        return self.fitted[name]

    @property
    def fitted(self) -> Mapping[str, FittedValue]:
        """Everything that was fitted, by name."""
        return self.values

    @property
    def untested(self) -> str:
        """Reason why the model is not tested, where `goodness` is None."""
        return f"as many quantities as {self.data} are fitted: no degree of freedom is left to test the model"

    @property
    def verdict(self) -> str:
        """Say whether the model explains the data, and whether they identify its parameters."""
        g, lost = self.goodness, len(self.unidentified)
        text = (
            self.untested
            if g is None
            else (
                f"{self.judgement[not self.explained]}: chi-squared {g.chi_square:.4g} of {g.freedom} degrees of freedom, p = {g.p_value:.3g}"
            )
        )
        many = f"{lost} combination{'s' if lost > 1 else ''} of parameters cannot be identified from these data"
        return f"{text}; {many}" if lost else text

    @property
    @abstractmethod
    def subject(self) -> str:
        """Scene, data and number of runs."""

    @abstractmethod
    def details(self) -> Iterator[tuple[str, str]]:
        """Yield labels and sentences on these data."""

    @abstractmethod
    def plot(self) -> Figure:
        """Draw the data over the best fit."""

    def lines(self) -> Iterator[tuple[str, str]]:
        """Yield what was found, as labels and sentences."""
        yield "fit", self.subject
        for value in self.fitted.values():
            yield value.name, f"{value}; {value.interval.how}"
        for text in self.unidentified:
            yield "unidentified", text
        yield from self.details()
        yield "verdict", self.verdict
        for warning in self.warnings:
            yield "warning", warning

    def record(self) -> dict[str, Any]:
        """Return everything but the data as plain numbers, in SI, null for missing ones."""
        return {
            "scene": self.scene,
            "values": {name: asdict(value) for name, value in self.values.items()},
            "level": LEVEL,
            "names": [free.name for free in self.known.free],
            "correlation": self.known.correlation.tolist(),
            "singular_values": self.known.singular_values.tolist(),
            "directions": self.known.directions.T.tolist(),
            "unidentified": list(self.unidentified),
            "goodness": self.goodness and asdict(self.goodness),
            "explained": self.explained,
            "distribution": None if self.unidentified else self.distribution().record(),
            "runs_made": self.runs_made,
            "verdict": self.verdict,
            "warnings": list(self.warnings),
        }

    def distribution(self) -> Correlated:
        """Return how uncertain the quantities are, as `propagate` takes it.

        Raises InputError where some are not identified.
        Normal on the scale of the search, by the curvature of the least squares; cut at an end of the range that was searched.
        """
        names = [free.name for free in self.known.free]
        lost = [name for name in self.values if self.known.concerned(names.index(name))]
        if lost:
            remedy = "measure a quantity that determines it, or fit without it"
            faults = [
                Fault(name, "a quantity that the data do not determine", "those that they determine", remedy)
                for name in lost
            ]
            raise InputError(f"distribution of the fit of {self.scene}", faults)
        deviations = np.sqrt(np.diag(self.known.covariance))
        distributions: dict[str, Distribution | str] = {}
        for name, value in self.values.items():
            size = float(deviations[names.index(name)])
            at, width = (value.value, value.unit), (size * value.scale, value.unit)
            cut = (
                value.inner(value.value) - FAR * size < value.bounds[0]
                or value.inner(value.value) + FAR * size > value.bounds[1]
            )
            if value.log:
                distributions[name] = LogNormal(at, math.exp(size))
            elif cut:
                distributions[name] = TruncatedNormal(at, width, (value.low, value.unit), (value.high, value.unit))
            else:
                distributions[name] = Normal(at, width)
        pairs = combinations(self.values, 2)
        correlation = {
            f"{one}, {other}": float(self.known.correlation[names.index(one), names.index(other)])
            for one, other in pairs
        }
        return Correlated(distributions, correlation)


@dataclass(frozen=True)
class Fit(Estimates):
    """Fit of parameters to measured runs.

    nuisance            offsets and gains that were fitted, by name
    criterion           Akaike's, corrected for few data
    share               part of the data that the fit rests on: what lies beyond the horizon is left out
    offsets             run time less measured time [s] of each run
    solutions           runs at the best fit, one of each measured run
    """

    observed: tuple[Observed, ...]
    nuisance: Mapping[str, FittedValue]
    criterion: float
    share: float
    signals: tuple[FittedSignal, ...]
    offsets: tuple[float, ...]
    solutions: tuple[Solution, ...]
    derivatives: str

    judgement: ClassVar[tuple[str, str]] = (
        "the stated noise explains the residuals",
        "the stated noise does not explain the residuals, the model is rejected at 5 %",
    )

    @property
    def fitted(self) -> Mapping[str, FittedValue]:
        """Quantities, and offsets and gains, by name."""
        return {**self.values, **self.nuisance}

    @property
    def parameters(self) -> dict[str, tuple[float, str]]:
        """Fitted quantities as `simulate` takes parameters and initial states."""
        return {name: (value.value, value.unit) for name, value in self.values.items()}

    @property
    def subject(self) -> str:
        """Scene, data and number of runs."""
        used = sum(int(np.sum(signal.used)) for signal in self.signals)
        return (
            f"{self.scene} to {', '.join(each.name for each in self.observed)}: {used:,} data, {self.runs_made:,} runs"
        )

    def details(self) -> Iterator[tuple[str, str]]:
        """Yield identification, residuals and derivatives."""
        values = ", ".join(f"{s:.3g}" for s in self.known.singular_values)
        unit = "1 over the standard deviation, in half ranges or factors of e"
        yield "identified", f"singular values {values} of the scaled Jacobian ({unit})"
        if pairs := list(self._pairs()):
            yield "correlated", ", ".join(pairs)
        for signal in self.signals:
            if signal.residual is not None:
                yield "residual", _residual(signal, many=len(self.observed) > 1)
        yield "derivatives", self.derivatives

    @property
    def untested(self) -> str:
        """Reason why the model is not tested, where `goodness` is None."""
        stated = any(signal.stated for signal in self.signals)
        return (
            super().untested
            if stated
            else "the model is not tested, as the noise of the measurement is not stated (noise)"
        )

    def plot(self) -> Figure:
        """Draw measured data over the best fit, and the residuals, for each signal."""
        from hertzwerk.runtime.studies.fitting import plot_fit

        return plot_fit.figure(self)

    def _pairs(self) -> Iterator[str]:
        correlation, free = self.known.correlation, self.known.free
        for i in range(len(free)):
            for j in range(i):
                if abs(correlation[i, j]) >= CLOSE:
                    yield f"{free[j].name} and {free[i].name} {correlation[i, j]:+.3f}"

    def csv(self) -> str:
        """Return every datum as CSV, with what is predicted, the residual, and whether it was used."""
        rows = ["run,column,unit,time [s] or number,measured,predicted,residual,used"]
        for signal in self.signals:
            for at, measured, predicted, used in zip(
                signal.at, signal.measured, signal.predicted, signal.used, strict=True
            ):
                numbers = [
                    "" if math.isnan(v) else repr(float(v)) for v in (at, measured, predicted, measured - predicted)
                ]
                name = [signal.run, signal.channel.column, signal.channel.unit]
                rows.append(",".join([*(f'"{text}"' for text in name), *numbers, str(int(used))]))
        return "\n".join(rows) + "\n"

    def record(self) -> dict[str, Any]:
        """Return everything but the data as plain numbers, in SI, null for missing ones."""
        return {
            **super().record(),
            "runs": [each.name for each in self.observed],
            "nuisance": {name: asdict(value) for name, value in self.nuisance.items()},
            "criterion": self.criterion,
            "share": self.share,
            "signals": [_record(signal) for signal in self.signals],
            "derivatives": self.derivatives,
        }


def _record(signal: FittedSignal) -> dict[str, Any]:
    return {
        "run": signal.run,
        "column": signal.channel.column,
        "history": signal.channel.history,
        "unit": signal.channel.unit,
        "data": len(signal.at),
        "used": int(np.sum(signal.used)),
        "noise": signal.sigma,
        "noise_stated": signal.stated,
        "residual": signal.residual and asdict(signal.residual),
    }


def _residual(signal: FittedSignal, *, many: bool) -> str:
    residual, unit = signal.residual, "" if signal.channel.unit == "1" else f" {signal.channel.unit}"
    assert residual is not None
    name = f"{signal.run}, {signal.channel.column}" if many else signal.channel.column
    noise = (
        f"{residual.rms / signal.sigma:.3g} times the stated noise" if signal.stated else "its noise is taken from it"
    )
    return f"{name} ({signal.channel.history}): rms {residual.rms:.4g}{unit}, {noise}, peak {residual.peak:.4g}{unit}"


def _ends(interval: Interval, digits: int) -> tuple[str, str]:
    """Return both ends as text; those that the data do not end are marked."""
    low, high = f"{interval.low:.{digits}g}", f"{interval.high:.{digits}g}"
    return f"<= {low}" if interval.open_low else low, f">= {high}" if interval.open_high else high


def _digits(value: float, interval: Interval) -> int:
    """Return the significant digits that an interval leaves, two of its width."""
    width = interval.high - interval.low
    if not width > 0 or value == 0:
        return 6
    return min(max(math.floor(math.log10(abs(value))) - math.floor(math.log10(width)) + 3, 3), 12)
