"""What is wrong with an input, said once and completely; imports nothing, so both sides report in the same form."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    """One fault: where it is, what was found, what was expected, and the way out (each a short phrase)."""

    where: str
    found: str
    expected: str
    remedy: str = ""

    def __str__(self) -> str:
        text = f"{self.where}: found {self.found}; expected {self.expected}"
        return f"{text}\n    {self.remedy}" if self.remedy else text


class InputError(ValueError):
    """Bad input: every fault of it at once (`faults`), nothing done, nothing written."""

    def __init__(self, subject: str, faults: Iterable[Fault]) -> None:
        self.subject = subject
        self.faults = tuple(faults)
        count = len(self.faults)
        head = f"{subject}: {count} fault{'s' if count != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {fault}".replace("\n", "\n  ") for fault in self.faults)]))
