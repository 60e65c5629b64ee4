"""Distributions of uncertain parameters and starts: records with units, read against a model.

`distribution_of` checks one and returns SciPy's distribution in SI.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.units import UnitError, parse_unit
from hertzwerk.runtime.engine.model.binding import Value, read, read_state
from hertzwerk.runtime.engine.model.free_quantities import read_quantity
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import as_text


@dataclass(frozen=True)
class Distribution:
    """Distribution of a quantity, by values with units.

    places    fields that are values of the quantity, within its limits; factors    those that are numbers; all others
    are in its unit
    """

    places: ClassVar[tuple[str, ...]] = ()
    factors: ClassVar[tuple[str, ...]] = ()

    def __str__(self) -> str:
        texts = (as_text(getattr(self, part.name)) for part in fields(self))
        return f"{type(self).__name__}({', '.join(texts)})"

    def fault(self, **si: float) -> str:
        """Return a phrase: values expected in place of these in SI; "" where they are right."""
        raise NotImplementedError

    def frozen(self, stats: Any, **si: float) -> Any:
        """Return the distribution of `scipy.stats` with these values in SI."""
        raise NotImplementedError


@dataclass(frozen=True)
class Normal(Distribution):
    """Normal distribution: Normal("0.5 mm", "0.02 mm")."""

    mean: Value
    std: Value
    places = ("mean",)

    def fault(self, mean: float, std: float) -> str:  # type: ignore[override]
        """Return the expected values, or "" if these are sound."""
        return "" if std > 0 else "a standard deviation above zero"

    def frozen(self, stats: Any, mean: float, std: float) -> Any:  # type: ignore[override]
        """Return the distribution of `scipy.stats` with these values in SI."""
        return stats.norm(mean, std)


@dataclass(frozen=True)
class TruncatedNormal(Distribution):
    """Normal distribution within limits, as of a restitution: TruncatedNormal(0.9, 0.05, 0, 1)."""

    mean: Value
    std: Value
    low: Value
    high: Value
    places = ("mean", "low", "high")

    def fault(self, mean: float, std: float, low: float, high: float) -> str:  # type: ignore[override]
        """Return the expected values, or "" if these are sound."""
        return "" if std > 0 and low < high else "a standard deviation above zero, and the lower limit first"

    def frozen(self, stats: Any, mean: float, std: float, low: float, high: float) -> Any:  # type: ignore[override]
        """Return the distribution of `scipy.stats` with these values in SI."""
        return stats.truncnorm((low - mean) / std, (high - mean) / std, mean, std)


@dataclass(frozen=True)
class Uniform(Distribution):
    """Equal probability between two values: Uniform("0.4 mm", "0.6 mm")."""

    low: Value
    high: Value
    places = ("low", "high")

    def fault(self, low: float, high: float) -> str:  # type: ignore[override]
        """Return the expected values, or "" if these are sound."""
        return "" if low < high else "the lower value first"

    def frozen(self, stats: Any, low: float, high: float) -> Any:  # type: ignore[override]
        """Return the distribution of `scipy.stats` with these values in SI."""
        return stats.uniform(low, high - low)


@dataclass(frozen=True)
class Triangular(Distribution):
    """Triangular distribution: Triangular("0.4 mm", "0.5 mm", "0.7 mm"), of which the second is likeliest."""

    low: Value
    mode: Value
    high: Value
    places = ("low", "mode", "high")

    def fault(self, low: float, mode: float, high: float) -> str:  # type: ignore[override]
        """Return the expected values, or "" if these are sound."""
        return "" if low <= mode <= high and low < high else "values in the order low, mode, high"

    def frozen(self, stats: Any, low: float, mode: float, high: float) -> Any:  # type: ignore[override]
        """Return the distribution of `scipy.stats` with these values in SI."""
        return stats.triang((mode - low) / (high - low), low, high - low)


@dataclass(frozen=True)
class LogNormal(Distribution):
    """Logarithm normally distributed: LogNormal("1e8 N/m", 1.2) is within a factor of 1.2 with 68 %.

    The factor is the exponential of the logarithm's standard deviation.
    """

    median: Value
    factor: Value
    places = ("median",)
    factors = ("factor",)

    def fault(self, median: float, factor: float) -> str:  # type: ignore[override]
        """Return the expected values, or "" if these are sound."""
        return "" if median > 0 and factor > 1 else "a median above zero, and a factor above 1"

    def frozen(self, stats: Any, median: float, factor: float) -> Any:  # type: ignore[override]
        """Return the distribution of `scipy.stats` with these values in SI."""
        return stats.lognorm(math.log(factor), scale=median)


_WRITTEN = re.compile(r"\s*(\w+)\s*\((.*)\)\s*")
KINDS: dict[str, Any] = {kind.__name__: kind for kind in (Normal, TruncatedNormal, Uniform, Triangular, LogNormal)}


def written(text: str) -> Distribution | None:
    """Return the distribution of a text such as "Normal(0.5 mm, 0.02 mm)"; None where it is none."""
    match = _WRITTEN.fullmatch(text)
    kind = None if match is None else KINDS.get(match[1])
    values = [] if match is None else [part.strip() for part in match[2].split(",")]
    return None if kind is None or len(values) != len(fields(kind)) else kind(*values)


def distribution_of(model: EngineModel, name: str, distribution: object, faults: list[Fault]) -> Any:
    """Return SciPy's distribution of a parameter or initial state in SI; None with faults appended.

    given    a distribution, or its text
    """
    if isinstance(distribution, str) and (read_from := written(distribution)) is not None:
        distribution = read_from
    if not isinstance(distribution, Distribution):
        kinds = (f"{kind.__name__}({', '.join(part.name for part in fields(kind))})" for kind in KINDS.values())
        expected = f"a distribution: {', '.join(kinds)}"
        faults.append(Fault(name, shown(distribution), expected))
        return None
    from scipy import stats  # slow to import

    before = len(faults)
    values: dict[str, Value] = {field.name: getattr(distribution, field.name) for field in fields(distribution)}
    si = {part: _si_of(model, name, part, value, distribution, faults) for part, value in values.items()}
    if len(faults) == before and (wrong := distribution.fault(**si)):
        faults.append(Fault(name, shown(distribution), wrong))
    return None if len(faults) > before else distribution.frozen(stats, **si)


def _si_of(
    model: EngineModel, name: str, part: str, value: Value, distribution: Distribution, faults: list[Fault]
) -> float:
    """Return one value of a distribution in SI; nan with faults appended."""
    where = f"{name}, {part}"
    if part in distribution.factors:
        si, fault = read_state(where, "1", value)
        faults += [] if fault is None else [fault]
        return si
    if name not in model.parameters or part in distribution.places:
        return read_quantity(model, name, value, where, faults)
    return _width(model, name, where, value, distribution, faults)


def _width(
    model: EngineModel, name: str, where: str, value: Value, distribution: Distribution, faults: list[Fault]
) -> float:
    """Return a difference of values of a parameter in SI: it has the unit, but not the limits."""
    declared = model.parameters[name].unit
    try:
        number, unit, _ = read(value)
        like = (
            read(getattr(distribution, distribution.places[0]))[1]
            if parse_unit(declared).free_names
            else parse_unit(declared)
        )
    except UnitError as error:
        faults.append(Fault(where, shown(value), f"a value in {declared}", str(error)))
        return math.nan
    if unit.exponents != like.exponents or not math.isfinite(si := unit.to_si(number)):
        faults.append(Fault(where, shown(value), "a finite number" if declared == "1" else f"a value in {declared}"))
        return math.nan
    return si


def read_distributions(
    model: EngineModel, uncertain: object, known: Mapping[str, str], faults: list[Fault]
) -> dict[str, Any]:
    """Return SciPy's distributions by name, in SI; bad input is appended to `faults`."""
    from hertzwerk.derive.common.faults import unknown

    if not isinstance(uncertain, Mapping) or not uncertain:
        expected = 'distributions by name, such as {"clearance": Normal("0.5 mm", "0.02 mm")}'
        faults.append(Fault("uncertain", shown(uncertain), expected))
        return {}
    distributions = {}
    for name, distribution in uncertain.items():
        if name not in known:
            faults.append(unknown("parameter or initial state", name, known))
        else:
            distributions[name] = distribution_of(model, name, distribution, faults)
    return distributions
