"""What is wrong with an input, said once and completely; imports nothing, so both sides report in the same form."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

FEW, MANY = 12, 24  # names that are listed: beside those like the one that was given, and where none is like it


def visible(text: str) -> str:
    """Text with an escape for every character that does not print, so that it can be shown and written anywhere; lines stay."""
    return "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode() for c in text)


def shown(value: object, most: int = 80) -> str:
    """A value of the user's as a message quotes it, whatever it is: its repr, cut where it is long."""
    try:
        text = repr(value)
    except Exception:  # an integer of too many digits, an object whose own repr fails
        text = f"a {type(value).__name__} that cannot be shown"
    return text if len(text) <= most else f"{text[: most - 4]} ..."


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


def unknown(kind: str, name: object, known: Iterable[str], otherwise: str = "") -> Fault:
    """The fault of a name that does not exist: the names like it, or all there are; `otherwise` is what may stand in place of one."""
    names = list(known)
    where = name if isinstance(name, str) and name else shown(name)
    more = f", {otherwise}" if otherwise else ""
    if not isinstance(name, str):
        return Fault(where, f"a {kind} named by {type(name).__name__}", f"text{more}")
    if not names:
        return Fault(where, f"no {kind} of this name", f"none, as there is no {kind}{more}")
    from difflib import get_close_matches

    near = get_close_matches(name, names, n=3)
    remedy = f"did you mean {' or '.join(near)}?" if near else ""
    listed = len(names) <= (FEW if near else MANY)
    expected = f"one of {', '.join(names)}" if listed else f"the name of a {kind}"
    return Fault(where, f"no {kind} of this name", f"{expected}{more}", remedy)


def unreadable(path: object, error: Exception, expected: str) -> Fault:
    """The fault of a file that cannot be read, such as "a readable TOML file" was expected."""
    plain = [
        (FileNotFoundError, "no such file"),
        (IsADirectoryError, "a folder"),
        (PermissionError, "no right to read it"),
    ]
    found = next(
        (text for kind, text in plain if isinstance(error, kind)), getattr(error, "strerror", None) or str(error)
    )
    return Fault(str(path), found, expected)


class PicklableError(ValueError):
    """An error that other processes receive whole, whatever its constructor takes: worker pools hang on those that cannot be unpickled."""

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (type(self), self.args, self.__dict__)


def _made_again(kind: type[PicklableError], args: tuple[Any, ...], attributes: dict[str, Any]) -> PicklableError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(attributes)
    return error


def one_of(names: Iterable[str], otherwise: str) -> str:
    """What was expected where a name was: one of those there are, or, where there are none, what to say of that."""
    listed = ", ".join(names)
    return f"one of {listed}" if listed else otherwise


class InputError(PicklableError):
    """Bad input: every fault of it at once (`faults`), nothing done, nothing written."""

    def __init__(self, subject: str, faults: Iterable[Fault]) -> None:
        self.subject = subject
        self.faults = tuple(faults)
        told = _told_once(self.faults)
        head = f"{visible(subject)}: {len(told)} fault{'s' if len(told) != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {fault}".replace("\n", "\n  ") for fault in told)]))


def _told_once(faults: Iterable[Fault]) -> list[Fault]:
    """Faults that differ only in where they are, as when many pairs share a parameter, told as one."""
    places: dict[tuple[str, str, str], list[str]] = {}
    for fault in faults:
        where = places.setdefault((fault.found, fault.expected, fault.remedy), [])
        if fault.where not in where:
            where.append(fault.where)
    return [Fault(", ".join(where), *said) for said, where in places.items()]
