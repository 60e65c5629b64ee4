"""Results of a study of effects: cost and changes of each, the smallest scene within a tolerance."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.effect_study.compared_outputs import Output
    from hertzwerk.runtime.analysis.effect_study.output_errors import Number
    from hertzwerk.runtime.analysis.effect_study.scene_cost import Cost, Share
    from hertzwerk.runtime.analysis.effect_study.smallest_scene import Smallest
    from hertzwerk.runtime.engine.solution.outcome import Outcome

BELOW_ERROR = "below error"
GONE = "gone"  # there is no such output without the effect
NEW = "new"  # it is zero with the effect, to its error


@dataclass(frozen=True)
class Change:
    """Relative change of an output when something is left out; None with the reason.

    why: BELOW_ERROR, GONE or NEW, with the detail. noise: the errors of both scenes together, relative likewise, below
    which no change is seen; None where there is nothing to compare.
    """

    relative: float | None
    why: str = ""
    detail: str = ""
    noise: float | None = None

    @property
    def bound(self) -> float:
        """Upper bound of the change."""
        return math.inf if self.noise is None else abs(self.relative or 0.0) + self.noise


@dataclass(frozen=True)
class Row:
    """Cost of one effect and the changes without it.

    along_with    effects that go with it
    fault    why it cannot be left out, or why the scene without it does not run; then there are no changes
    notes    remarks on the scene without it
    """

    effect: str
    along_with: tuple[str, ...] = ()
    cost: Cost | None = None
    share: Share | None = None
    changes: Mapping[str, Change] = field(default_factory=dict)
    fault: str = ""
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Study:
    """Every effect of a scene; without rows where the whole scene's run does not finish (`outcome`)."""

    scene: str
    outcome: Outcome
    duration: float
    method: str
    tolerances: tuple[float, float]
    compiled: bool
    cost: Cost
    effects: tuple[str, ...]
    past_horizon: bool = False
    outputs: tuple[Output, ...] = ()
    numbers: Mapping[str, Number] = field(default_factory=dict)
    rows: tuple[Row, ...] = ()
    within: float | None = None
    smallest: Smallest | None = None
    smallest_share: Share | None = None
    warnings: tuple[str, ...] = ()

    def record(self) -> dict[str, Any]:
        """Return the study as JSON."""
        smallest = self.smallest
        return {
            "scene": self.scene,
            "outcome": self.outcome.name,
            "duration": self.duration,
            "method": self.method,
            "tolerances": list(self.tolerances),
            "compiled": self.compiled,
            "past_horizon": self.past_horizon,
            "whole": vars(self.cost),
            "outputs": {
                output.name: {"unit": output.unit, "meaning": output.meaning, **vars(self.numbers[output.name])}
                for output in self.outputs
            },
            "rows": [_record(row) for row in self.rows],
            "within": self.within,
            "smallest": None if smallest is None else list(smallest.effects),
            "smallest_found": None
            if smallest is None
            else {
                "left_out": list(smallest.left_out),
                "largest_change": smallest.change,
                "scenes_tried": smallest.tried,
                "all_tried": smallest.complete,
                "time_share": None if self.smallest_share is None else self.smallest_share.median,
            },
            "warnings": list(self.warnings),
        }


def _record(row: Row) -> dict[str, Any]:
    cost, share = row.cost, row.share
    return {
        "effect": row.effect,
        "along_with": list(row.along_with),
        "operations": None if cost is None else {"flight": cost.flight, "contact": cost.contact},
        "states": None if cost is None else cost.states,
        "events": None if cost is None else cost.events,
        "time_share": None if share is None else share.median,
        "time_interval": None if share is None else [share.low, share.high],
        "changes": {name: change.relative for name, change in row.changes.items()},
        "noise": {name: change.noise for name, change in row.changes.items()},
        "why": {
            name: ": ".join(filter(None, (change.why, change.detail)))
            for name, change in row.changes.items()
            if change.relative is None
        },
        "fault": row.fault or None,
        "notes": list(row.notes),
    }


def percent(value: float, *, sign: bool = True) -> str:
    """Format a fraction in percent, with as many digits as are read."""
    form = "+" if sign else ""
    number = 100 * value
    if not math.isfinite(number):
        return f"{number}"
    if abs(number) >= 100:
        return f"{number:{form},.0f} %"
    return f"{number:{form}.1f} %" if abs(number) >= 10 else f"{number:{form}#.2g} %"
