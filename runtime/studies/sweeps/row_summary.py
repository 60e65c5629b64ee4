"""Summary of rows, in one pass over them, whatever their number."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from statistics import median

from hertzwerk.runtime.studies.sweeps.rows.row import Row

SPREAD = 10_000  # rows whose numbers are kept for the median, at least, where there are so many


@dataclass
class Spread:
    """Least and largest of numbers, how many there are, and for the median some of them, spread evenly."""

    least: float = math.inf
    largest: float = -math.inf
    count: int = 0

    def __post_init__(self) -> None:
        self._some: list[float] = []
        self._step = 1

    def add(self, value: float) -> None:
        """Take one more; nan and infinities are none."""
        if not math.isfinite(value):
            return
        self.least, self.largest = min(self.least, value), max(self.largest, value)
        if self.count % self._step == 0:
            self._some.append(value)
            if len(self._some) > 2 * SPREAD:
                del self._some[1::2]
                self._step *= 2
        self.count += 1

    @property
    def median(self) -> float:
        """Median of the numbers, of many that of some; nan of none."""
        return median(self._some) if self._some else math.nan


@dataclass
class SharedWarning:
    """Warning that rows share but for its numbers: `text` that of the worst row, `where` which that is."""

    text: str
    size: float
    worst: int
    last: int
    rows: int = 1
    alike: bool = True

    def __str__(self) -> str:
        where = f", such as row {self.worst}" if math.isnan(self.size) else f", worst in row {self.worst}"
        return f"{self.rows:,} row{'s' * (self.rows > 1)}{'' if self.alike else where}: {self.text}"


_NUMBER = r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?"


def form_of(warning: str) -> str:
    """Return what a warning shares with those of other rows: all but its numbers."""
    return re.sub(_NUMBER, "#", warning)


class Summary:
    """Counts, ranges and warnings of rows.

    counts, messages    number of rows by outcome, and the first row's reason
    spreads    least, median and largest of the columns of numbers
    warnings    each once, by its form; `warned` is the number of rows that have any
    ran    whether any row has outputs
    """

    def __init__(self, rows: Iterable[Row], names: Sequence[str]) -> None:
        self.counts: Counter[str] = Counter()
        self.messages: dict[str, str] = {}
        self.spreads = {name: Spread() for name in names}
        self.warnings: dict[str, SharedWarning] = {}
        self.warned, self.ran = 0, False
        for row in rows:
            self.counts[row.outcome] += 1
            self.messages.setdefault(row.outcome, row.message)
            for name, spread in self.spreads.items():
                entry = row[name]
                if not isinstance(entry, str):
                    spread.add(entry)
            self.ran = self.ran or bool(row.outputs)
            self.warned += bool(row.warnings)
            for text in row.warnings:
                self._warn(row.index, text)

    def _warn(self, index: int, text: str) -> None:
        worst = re.search(f"worst ({_NUMBER})", text)
        size = math.nan if worst is None else float(worst[1])
        form = form_of(text)
        shared = self.warnings.get(form)
        if shared is None:
            self.warnings[form] = SharedWarning(text, size, index, index)
            return
        shared.alike = shared.alike and text == shared.text
        shared.rows += index != shared.last
        shared.last = index
        if size > shared.size:
            shared.text, shared.size, shared.worst = text, size, index
