"""Validation: run a scenario and check its results."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import refuse
from hertzwerk.derive.common.units import parse_unit, split_quantity
from hertzwerk.runtime.analysis.validation.scenario import Check, Scenario, misfit, si

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution


@dataclass(frozen=True)
class Verdict:
    """Result of one check: measured value (SI; None where it does not exist), and whether it passed."""

    check: Check
    measured: float | None
    passed: bool

    @property
    def expectation(self) -> str:
        """Expectation of the check as text."""
        check = self.check
        return (
            f"at most {check.at_most}" if check.at_most is not None else f"{check.expected} within {check.tolerance:g}"
        )

    def __str__(self) -> str:
        _, unit = split_quantity(self.check.expected or self.check.at_most or "")  # of the same dimension, as validated
        value = "not there" if self.measured is None else f"{self.measured / parse_unit(unit).factor:.9g}"
        measured = value if unit == "1" or self.measured is None else f"{value} {unit}"
        return f"{self.check.quantity} = {measured}, expected {self.expectation}: {self.check.source}"


def run_scenario(scenario: Scenario) -> EngineSolution:
    """Simulate a scenario with its own numbers; raises InputError."""
    from hertzwerk.runtime.loading import engine_model
    from hertzwerk.runtime.simulation import simulate

    return simulate(
        engine_model(scenario.scene),
        duration=scenario.duration,
        accuracy=scenario.accuracy,
        method=scenario.method,
        parameters=scenario.parameters,
        initial=scenario.initial,
        inputs=scenario.inputs,
    )


def validate(scenario: Scenario, solution: EngineSolution) -> tuple[Verdict, ...]:
    """Return the verdict of every check; raises InputError for unknown names or unfit units."""
    refuse(
        f"checks of scenario {scenario.scene}",
        [fault for check in scenario.checks if (fault := misfit(check, solution.engine.history.units)) is not None],
    )
    return tuple(_verdict(check, measure(solution, check.quantity)) for check in scenario.checks)


def measure(solution: EngineSolution, quantity: str) -> float | None:
    """Return the value of a check's quantity, SI; None where it does not exist.

    Such as an impact that did not happen, a duration still open, no ledger.
    """
    if quantity == "energy_residual":
        return solution.energy_residual
    if quantity == "impacts":
        return float(len(solution.impacts))
    head, _, name = quantity.partition(".")
    if head == "impacts":
        index, _, field = name.partition(".")
        if int(index) >= len(solution.impacts):
            return None
        value: float | None = getattr(solution.impacts[int(index)], field)
        return value
    history = solution[name]
    by_kind = {"final": history[-1], "max": np.max(history), "min": np.min(history), "largest": np.max(np.abs(history))}
    return float(by_kind[head])


def _verdict(check: Check, measured: float | None) -> Verdict:
    if measured is None or not np.isfinite(measured):
        return Verdict(check, measured, passed=False)
    if check.at_most is not None:
        return Verdict(check, measured, passed=measured <= si(check.at_most))
    expected, tolerance = si(check.expected or ""), check.tolerance or 0.0
    return Verdict(check, measured, passed=abs(measured - expected) <= tolerance * abs(expected))
