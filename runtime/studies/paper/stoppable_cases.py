"""Cases of a study, one after another, until Ctrl-C: what is done by then makes its page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from hertzwerk.runtime.system.interrupt import raise_interrupts

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

Case = TypeVar("Case")
Row = TypeVar("Row")
Run = TypeVar("Run", bound="EngineSolution")


def until_stopped(
    cases: Sequence[Case], row: Callable[[Case], Row], progress: Callable[[float], object]
) -> tuple[list[Row], str]:
    """Compute the rows of cases until Ctrl-C; return them, and a sentence where some are missing."""
    rows: list[Row] = []
    try:
        with raise_interrupts():
            for case in cases:
                rows.append(row(case))
                progress(len(rows) / len(cases))
    except KeyboardInterrupt:
        if len(rows) < len(cases):
            return rows, f"stopped by the user: {len(rows)} of {len(cases)} cases are done, and these alone are shown"
    return rows, ""


def whole(run: Run) -> Run:
    """Return a run that was not stopped; raises KeyboardInterrupt for another."""
    if run.outcome.name == "interrupted":
        raise KeyboardInterrupt
    return run
