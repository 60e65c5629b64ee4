"""Implicit methods against explicit ones: where they pay, and where not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from benchmarks.equal_error import crossing
from benchmarks.limit import model as slider_crank
from benchmarks.ratios import Measurement, Ratio, decades, hot, medians
from benchmarks.stiff_scenes import incline

EXPLICIT, IMPLICIT = ("dop853", "dopri5"), ("esdirk", "rodas", "auto")
TOLERANCE, TARGET = 1e-5, 2e-5
TOLERANCES = decades(4, 8, 2)


@dataclass(frozen=True)
class Case:
    """A run of a model: every method at the tolerance 1e-5, or each at the tolerance that gives an error of `TARGET` in the scene's scales."""

    name: str
    model: Any = field(repr=False)
    duration: float
    parameters: Mapping[str, Any]
    equal_error: bool = False
    pays: bool = True

    def run(self, method: str, tolerance: float) -> Any:
        """In the virtual machine, explicit or implicit."""
        from hertzwerk.runtime import simulate

        return simulate(
            self.model,
            duration=self.duration,
            tolerance=tolerance,
            method=method,
            parameters=self.parameters,
            compiled=False,
        )

    def tolerance(self, method: str) -> float | None:
        """What to ask a method for."""
        if not self.equal_error:
            return TOLERANCE
        errors = [float(np.max(np.abs(self._state(method, a) - self._exact))) for a in TOLERANCES]
        return crossing(TOLERANCES, errors, TARGET, reach=1)

    @property
    def _exact(self) -> np.ndarray:
        return _exact(self.name, self._state)

    def _state(self, method: str, tolerance: float) -> np.ndarray:
        """Coordinates and speeds at the end, in the scene's scales."""
        run, bound = self.run(method, tolerance), self.model.bind(self.parameters)
        scales = np.concatenate([np.array(part).ravel() for part in self.model.function("scales")(bound.p)[:2]])
        names = (*self.model.coordinates, *self.model.speeds)
        return np.array([run[name][-1] for name in names]) / scales


@cache
def _exact(name: str, state: Any) -> np.ndarray:
    """By two methods of which neither steps over the layer; they must agree."""
    found, other = state("esdirk", 1e-10), state("rodas", 1e-10)
    if not np.max(np.abs(found - other)) < TARGET / 20:
        raise ArithmeticError(f"{name}: esdirk and rodas do not agree")
    return found


def cases() -> tuple[Case, ...]:
    """Settling, sticking, impacts among which friction sticks; and one impact alone, where nothing is stiff."""
    from hertzwerk.runtime.loading import engine_model

    ball, layer = engine_model("bouncing_ball"), {"friction_speed": "1e-7 m/s"}
    return (
        Case("settling at restitution 0.01, 1 s", ball, 1.0, {"restitution": 0.01}),
        Case("block held on an incline, v_s = 1e-7, 2 s", incline(), 2.0, {}),
        Case(f"slider-crank, v_s = 1e-7, 4 ms, error {TARGET:g}", slider_crank(True), 4e-3, layer, equal_error=True),
        Case("one impact at restitution 0.9", ball, 0.6, {"restitution": 0.9}, pays=False),
    )


def _time(case: Case, method: str, tolerance: float) -> Measurement:
    return hot(lambda: case.run(method, tolerance), calls=1, warm=1)


def implicit() -> Iterator[Ratio]:
    """Explicit over implicit at tolerance 1e-5, steps and time in the virtual machine; of the explicit methods the better one."""
    for case in cases():
        if not case.pays:
            print("  where implicit methods do not pay:")
        tolerances = {method: case.tolerance(method) for method in (*EXPLICIT, *IMPLICIT)}
        missing = [method for method, tolerance in tolerances.items() if tolerance is None]
        if missing:
            print(f"  {case.name}: error not reached by {', '.join(missing)}")
        reached = {method: tolerance for method, tolerance in tolerances.items() if tolerance is not None}
        steps = {method: case.run(method, tolerance).statistics.steps for method, tolerance in reached.items()}
        measured = medians(*(_time(case, m, a) for m, a in reached.items()), repeats=5)
        times = dict(zip(reached, measured, strict=True))
        fewest, cheapest = (min(EXPLICIT, key=lambda m: of.get(m, np.inf)) for of in (steps, times))
        for method in IMPLICIT:
            if method not in reached:
                continue
            note = f"tolerances {reached[fewest]:.1e}, {reached[method]:.1e}"
            what = f"{fewest} / {method}, {case.name}"
            yield Ratio(what, steps[fewest], steps[method], ">= 10" if case.pays else "", note, unit="steps")
            yield Ratio(f"    time, {cheapest}", times[cheapest], times[method], ">= 1" if case.pays else "")
