"""Sweeps of a study, each stored in a folder of its own, and its cases, computed until Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep
from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep
from hertzwerk.runtime.system.interrupt import raise_interrupts
from hertzwerk.runtime.system.lazy import cached_property


class SweepStoppedError(Exception):
    """A sweep that is not whole; the message says why."""


class Sweeps:
    """Makes the sweeps of a study.

    begin    returns the folder that they are stored in, each under its name; without it they are kept in memory
    damage    sentences: what was found damaged among the rows that were kept, and was computed again
    """

    def __init__(self, begin: Callable[[], Path] | None = None) -> None:
        self._begin = begin
        self.damage: list[str] = []

    @cached_property
    def folder(self) -> Path | None:
        """Folder of the sweeps, made when the first is."""
        return None if self._begin is None else self._begin()

    def __call__(self, name: str, target: Any, over: Any, **arguments: Any) -> Sweep:
        """Run a sweep, or the rows of it that are missing; arguments as in `sweep`.

        Raises InputError, and SweepStoppedError where Ctrl-C, a full disk or a lost cluster ended it.
        """
        out = None if self.folder is None else self.folder / name
        with raise_interrupts():
            table = sweep(target, over, out=out, **arguments)
        if table.damage:
            self.damage.append(f"{name}: {table.damage}")
        if not table.outcome.finished:
            raise SweepStoppedError(f"{name}, after {len(table)} rows: {table.outcome.message}")
        return table


# -- cases of a study, one after another, until Ctrl-C: what is done by then makes its page ----------------------------


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
