"""Sweeps of a study, each stored in a folder of its own, so that the study goes on where it ended."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

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
