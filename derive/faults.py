"""What is wrong with an input, said once and completely; imports nothing, so both sides report in the same form."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any


def visible(text: str) -> str:
    """Text with an escape for every character that does not print, so that it can be shown and written anywhere; lines stay."""
    return "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode() for c in text)


@dataclass(frozen=True)
class Fault:
    """One fault: where it is, what was found, what was expected, and the way out (each a short phrase)."""

    where: str
    found: str
    expected: str
    remedy: str = ""

    def __str__(self) -> str:
        text = f"{self.where}: found {self.found}; expected {self.expected}"
        return visible(f"{text}\n    {self.remedy}" if self.remedy else text)


class PicklableError(ValueError):
    """An error that other processes receive whole, whatever its constructor takes: worker pools hang on those that cannot be unpickled."""

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (type(self), self.args, self.__dict__)


def _made_again(kind: type[PicklableError], args: tuple[Any, ...], attributes: dict[str, Any]) -> PicklableError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(attributes)
    return error


class InputError(PicklableError):
    """Bad input: every fault of it at once (`faults`), nothing done, nothing written."""

    def __init__(self, subject: str, faults: Iterable[Fault]) -> None:
        self.subject = subject
        self.faults = tuple(faults)
        count = len(self.faults)
        head = f"{visible(subject)}: {count} fault{'s' if count != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {fault}".replace("\n", "\n  ") for fault in self.faults)]))
