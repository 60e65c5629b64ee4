"""Result of a minimisation: the best values found, what they give, and how sure that is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.output.tables.notebook import Printed
from hertzwerk.runtime.system.digests import finite

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.engine.model.ranges import Range
    from hertzwerk.runtime.engine.solution.outcome import Outcome
    from hertzwerk.runtime.simulation import Solution

LEVEL = 1e-3  # of an objective: minima are one whose values differ by less,
NEAR = 1e-2  # and whose places by less than this part of a range


@dataclass(frozen=True)
class Held:
    """Constraint at the minimum, in SI: lower <= value <= upper.

    active: it holds the minimum back; satisfied: false where no run satisfies it.
    """

    text: str
    value: float
    unit: str
    lower: float
    upper: float
    active: bool
    satisfied: bool

    @property
    def state(self) -> str:
        """Say whether it is violated, kept, or holds the minimum back."""
        return "is violated" if not self.satisfied else "holds it back" if self.active else "is kept"


@dataclass(frozen=True)
class Trial:
    """One run of a minimisation: values in SI, objective, and whether the constraints are kept."""

    values: Mapping[str, float]
    objective: float
    feasible: bool


@dataclass(frozen=True)
class Ended:
    """End of a search from one start, both in SI; here: whether it is that of the best."""

    begun: Mapping[str, float]
    values: Mapping[str, float]
    objective: float
    outcome: str
    here: bool


@dataclass(frozen=True)
class Minimum(Printed):
    """Values that minimise an objective: `found["counterweight"]` is one, in SI.

    values    the same with units, as `simulate` takes them; objective, unit    the least value; begun    that at the start
    gradient    of the objective there, by name, SI; exact    whether by derivatives, else by differences of runs
    checked    relative difference of the derivatives from a difference of runs, along them, at the start; nan where not
    at_end    names at an end of their range; constraints    as they are there
    run    at the minimum; trials    every run, in order; searches    where every start ended
    """

    scene: str
    objective_text: str
    values: Mapping[str, tuple[float, str]]
    objective: float
    begun: float
    unit: str
    gradient: Mapping[str, float]
    exact: bool
    checked: float
    at_end: tuple[str, ...]
    constraints: tuple[Held, ...]
    run: Solution
    trials: tuple[Trial, ...]
    outcome: Outcome
    notes: tuple[str, ...]
    searches: tuple[Ended, ...] = ()

    def __getitem__(self, name: str) -> float:
        return self.values[name][0]

    def __repr__(self) -> str:
        return f"<Minimum {self.scene}: {self.outcome.name}, {self.objective_text} = {self.objective:.6g} {self.unit}>"

    def __str__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        how = "exact derivatives" if self.exact else "differences of runs"
        lines = [
            f"{self.scene}: {self.outcome.name} after {len(self.trials)} runs, by {how}",
            f"{self.objective_text}: {self.objective:.6g}{unit}, from {self.begun:.6g}{unit}",
        ]
        for name, (value, text) in self.values.items():
            end = ", at the end of its range" if name in self.at_end else ""
            lines.append(f"    {name} = {value:.6g} {text}{end}".rstrip())
        lines += [f"    {held.text} {held.state}: {held.value:.6g} {held.unit}".rstrip() for held in self.constraints]
        if not self.outcome.finished:
            lines.append(f"{self.outcome.message}; {self.outcome.remedy}")
        return "\n".join([*lines, *(f"note: {text}" for text in self.notes)])

    def plot(self) -> Figure:
        """Draw the objective and the values of all runs, one after the other."""
        from hertzwerk.runtime.studies.minimisation import plot_minimum

        return plot_minimum.figure(self)

    def record(self) -> dict[str, Any]:
        """Return everything but the run as plain data."""
        return {
            "scene": self.scene,
            "outcome": self.outcome.name,
            "message": self.outcome.message,
            "objective": {"text": self.objective_text, "value": self.objective, "unit": self.unit, "begun": self.begun},
            "values": {name: {"value": value, "unit": unit} for name, (value, unit) in self.values.items()},
            "gradient": dict(self.gradient),
            "exact": self.exact,
            "checked": self.checked if np.isfinite(self.checked) else None,
            "at_end": list(self.at_end),
            "constraints": [finite({**vars(held), "state": held.state}) for held in self.constraints],
            "trials": [vars(trial) for trial in self.trials],
            "searches": [vars(search) for search in self.searches],
            "notes": list(self.notes),
        }


def best_of(minima: Sequence[Minimum], ranges: Sequence[Range], failed: int) -> Minimum:
    """Return the best of several minima, with what became of the other starts.

    failed    starts from which no run reached its end
    """
    best = min(minima, key=lambda one: (one.outcome.name == "infeasible", one.objective))
    places = np.array([[r.inner(one[name]) for r, name in zip(ranges, best.values, strict=True)] for one in minima])
    apart = np.abs(places - places[minima.index(best)]) / [np.ptp(one.bounds) for one in ranges]
    size = LEVEL * max(abs(best.objective), abs(best.begun) * LEVEL)
    searches = tuple(
        Ended(
            one.trials[0].values,
            {name: value for name, (value, _) in one.values.items()},
            one.objective,
            one.outcome.name,
            here=bool(one.objective - best.objective <= size and np.all(far <= NEAR)),
        )
        for one, far in zip(minima, apart, strict=True)
    )
    notes, count = best.notes, len(minima) + failed
    if count > 1:
        here = sum(search.here for search in searches)
        others = [search for search in searches if not search.here]
        unit = f" {best.unit}" if best.unit else ""
        remark = f"{here} of {count} starts ended in this minimum"
        if others:
            worst = sorted(search.objective for search in others)
            remark += f", the others at {', '.join(f'{value:.6g}' for value in worst)}{unit}: there are several minima"
            if any(search.outcome != "finished" for search in others):
                remark += ", or searches that did not end"
        notes = (*notes, f"{remark}; from {failed} no run reached its end" if failed else remark)
    trials = tuple(trial for one in minima for trial in one.trials)
    return replace(best, begun=minima[0].begun, trials=trials, searches=searches, notes=notes)
