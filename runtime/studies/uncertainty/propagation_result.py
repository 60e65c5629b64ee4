"""Result of a propagation: the spread of outputs by derivatives and by samples, side by side."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.runtime.engine.solution.solution import write
from hertzwerk.runtime.output.tables.notebook import Printed
from hertzwerk.runtime.system.digests import finite

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.simulation import Solution
    from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep

FACTOR = 3.0  # standard errors by which spreads differ before it is said
SLACK = 1e-3  # of a spread: error that is left to derivatives and to the runs themselves
ROUNDING = 1e-12  # of a mean: spreads below are none
PLAIN = 1e-3, 1e7  # sizes of numbers that are written without an exponent


@dataclass(frozen=True)
class Index:
    """Part of an output's variance, with its 95 % interval by resampling the samples."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:.3f} ({self.low:.3f} to {self.high:.3f})"


@dataclass(frozen=True)
class Uncertain:
    """One output and its uncertainty, in SI.

    nominal    at the means of what is uncertain; derivatives    there, by name
    linear    standard deviation by the derivatives; nan where there are none, for the `reason`
    parts    standard deviation that each name alone causes, by the derivatives
    mean, std    of the samples, each with its standard error, as of independent draws
    low, high    2.5 % and 97.5 % quantiles of the samples
    first, total    Sobol indices by name: part of the variance that a name explains alone, and with all it interacts with
    """

    name: str
    unit: str
    nominal: float
    derivatives: Mapping[str, float]
    linear: float
    parts: Mapping[str, float]
    reason: str
    mean: float
    mean_error: float
    std: float
    std_error: float
    low: float
    high: float
    first: Mapping[str, Index] = field(default_factory=dict)
    total: Mapping[str, Index] = field(default_factory=dict)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Differences between derivatives and samples beyond their errors."""
        if not math.isfinite(self.linear) or not math.isfinite(self.std):
            return ()
        remarks = []
        slack = SLACK * self.std + ROUNDING * abs(self.mean)
        if abs(self.linear - self.std) > FACTOR * self.std_error + slack:
            remarks.append(
                f"{self.name}: {self.linear:.3g} {self.unit} by derivatives, but {self.std:.3g} +- {self.std_error:.2g} "
                f"{self.unit} in the samples: it is not linear over this spread; use the samples"
            )
        if abs(self.nominal - self.mean) > FACTOR * self.mean_error + slack:
            remarks.append(
                f"{self.name}: its mean {self.mean:.6g} +- {self.mean_error:.2g} {self.unit} is not its value at the means, "
                f"{self.nominal:.6g} {self.unit}: it curves over this spread"
            )
        return tuple(remarks)


@dataclass(frozen=True)
class Propagated(Printed):
    """Uncertain outputs of a model: `found["slider_pin.peak_force"]` is one, iteration yields all.

    names    what is uncertain; run    at its means; samples    the rows, a sweep, of which the first `draws` are
    independent of each other
    notes    why something is missing: runs that did not finish, indices that could not be estimated
    correlation    of normal scores, by the names of two that are correlated
    """

    scene: str
    names: tuple[str, ...]
    outputs: Mapping[str, Uncertain]
    run: Solution
    samples: Sweep
    draws: int
    notes: tuple[str, ...]
    correlation: Mapping[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Uncertain:
        if name not in self.outputs:
            raise KeyError(f"no output {name!r}; there are {', '.join(self.outputs)}")
        return self.outputs[name]

    def __iter__(self) -> Iterator[Uncertain]:
        return iter(self.outputs.values())

    @property
    def warnings(self) -> tuple[str, ...]:
        """Differences between derivatives and samples, and missing numbers."""
        return (*(text for output in self for text in output.warnings), *self.notes)

    def __repr__(self) -> str:
        return f"<Propagated {self.scene}: {', '.join(self.outputs)} over {', '.join(self.names)}>"

    def __str__(self) -> str:
        lines = [f"{self.scene}: {len(self.samples)} runs over {', '.join(self.names)}"]
        for one in self:
            unit = f" {one.unit}" if one.unit else ""
            linear = f"{one.linear:.3g}{unit}" if math.isfinite(one.linear) else f"none: {one.reason}"
            lines += [
                f"{one.name}: {one.nominal:.6g}{unit} at the means",
                f"    standard deviation by derivatives {linear}; of samples {_rounded(one.std, one.std_error)}{unit}",
                f"    mean {_rounded(one.mean, one.mean_error)}{unit}, 95 % within {one.low:.6g} to {one.high:.6g}{unit}",
            ]
            lines += [
                f"    {name}: Sobol index {one.first[name]} of first order, {one.total[name]} total"
                for name in one.first
            ]
        return "\n".join([*lines, *(f"warning: {text}" for text in self.warnings)])

    def record(self) -> dict[str, Any]:
        """Return everything but the runs as plain data, nan as None."""
        return {
            "scene": self.scene,
            "uncertain": list(self.names),
            "runs": len(self.samples),
            "outputs": finite({one.name: asdict(one) for one in self}),
            "warnings": list(self.warnings),
            "damage": self.samples.damage,
        }

    def plot(self) -> Figure:
        """Draw the samples of every output beside the spread that derivatives give, and the Sobol indices."""
        from hertzwerk.runtime.studies.uncertainty import plot_uncertainty

        return plot_uncertainty.figure(self)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write a line for each output, in SI; raises FileExistsError. `samples.to_csv` has the runs."""
        numbers = ("nominal", "linear", "mean", "mean_error", "std", "std_error", "low", "high")
        indices = [(kind, name) for kind in ("first", "total") for name in self.names]
        lines = [["output", "unit", *numbers, *(f"{kind}.{name}" for kind, name in indices)]]
        for one in self:
            cells = [getattr(one, number) for number in numbers]
            cells += [getattr(one, kind)[name].value if getattr(one, kind) else math.nan for kind, name in indices]
            lines.append([one.name, one.unit, *(repr(float(cell)) for cell in cells)])
        return write(path, "".join(",".join(line) + "\n" for line in lines).encode(), overwrite=overwrite)


def _rounded(value: float, error: float) -> str:
    """Format a value with its standard error, both to the second digit of the error."""
    if not (math.isfinite(value) and 0 < error < math.inf):
        return f"{value:.6g} +- {error:.2g}"
    place, size = math.floor(math.log10(error)) - 1, max(abs(value), error)
    if not PLAIN[0] <= size < PLAIN[1]:
        return f"{value:.{math.floor(math.log10(size)) - place}e} +- {error:.1e}"
    return " +- ".join(f"{round(number, -place):.{max(-place, 0)}f}" for number in (value, error))
