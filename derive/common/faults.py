"""Faults of an input, collected and reported at once.

Imports nothing from the package, so that derivation and runtime report in the same form.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

FEW, MANY = 12, 40  # most names listed as expected: where similar names are suggested, and where there are none


def visible(text: str) -> str:
    """Escape every character that does not print; line breaks stay."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode() for c in text)


def shown(value: object, most: int = 80) -> str:
    """Representation of a user's value for a message, cut to `most` characters."""
    try:
        text = repr(value)
    except Exception:  # an integer of too many digits, an object whose own repr fails
        text = f"a {type(value).__name__} that cannot be shown"
    return text if len(text) <= most else f"{text[: most - 4]} ..."


@dataclass(frozen=True)
class Fault:
    """One fault: where it is, what was found, what was expected, and the remedy (short phrases)."""

    where: str
    found: str
    expected: str
    remedy: str = ""

    def __str__(self) -> str:
        text = f"{self.where}: found {self.found}; expected {self.expected}"
        return visible(f"{text}\n    {self.remedy}" if self.remedy else text)


def among(value: object, *options: object) -> bool:
    """Return whether a value is one of some options; an array, which NumPy compares by element, is none."""
    return isinstance(value, Hashable) and value in options


def unknown(kind: str, name: object, known: Iterable[str], otherwise: str = "") -> Fault:
    """Fault of an unknown name, with similar names, or all known ones.

    `otherwise` is a phrase for what is accepted instead of a name.
    """
    names = list(known)
    where = name if isinstance(name, str) and name else shown(name)
    more = f", {otherwise}" if otherwise else ""
    if not isinstance(name, str):
        return Fault(where, f"a {kind} named by {type(name).__name__}", f"text{more}")
    if not names:
        return Fault(where, f"no {kind} of this name", f"none, as there is no {kind}{more}")
    remedy = similar(name, names)
    listed = len(names) <= (FEW if remedy else MANY)
    expected = f"one of {', '.join(names)}" if listed else f"the name of a {kind}"
    return Fault(where, f"no {kind} of this name", f"{expected}{more}", remedy)


def similar(name: str, names: Collection[str]) -> str:
    """Phrase of the names that resemble one, and of the quantities of its owner, `<owner>.<quantity>`."""
    from difflib import get_close_matches

    near, owner = get_close_matches(name, names, n=3), name.rpartition(".")[0]
    own = [quantity for whose, _, quantity in (other.rpartition(".") for other in names) if owner and whose == owner]
    phrases = [f"did you mean {' or '.join(near)}?"] if near else []
    return " ".join([*phrases, *([f"{owner} has {', '.join(own)}"] if own else [])])


def as_path(where: str, path: object) -> Path:
    """Return the path that a user names; raises InputError for what is none."""
    if isinstance(path, str | Path):
        return Path(path)
    raise InputError(where, [Fault(where, shown(path), "the path of a file or folder, as text or a Path")])


def unreadable(path: object, error: Exception, expected: str) -> Fault:
    """Fault of a file that cannot be read, where `expected` (such as "a readable TOML file") was."""
    plain = [
        (FileNotFoundError, "no such file"),
        (IsADirectoryError, "a folder"),
        (PermissionError, "no right to read it"),
    ]
    actual = next(
        (text for kind, text in plain if isinstance(error, kind)), getattr(error, "strerror", None) or str(error)
    )
    return Fault(str(path), actual, expected)


class PicklableError(ValueError):
    """An error that can be unpickled in other processes, whatever its constructor takes.

    Worker pools hang on errors that cannot be unpickled.
    """

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuild, (type(self), self.args, self.__dict__)


def _rebuild(kind: type[PicklableError], args: tuple[Any, ...], attributes: dict[str, Any]) -> PicklableError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(attributes)
    return error


def one_of(names: Iterable[str], otherwise: str) -> str:
    """Phrase for an expected name: "one of ...", or `otherwise` where there are none."""
    listed = ", ".join(names)
    return f"one of {listed}" if listed else otherwise


class InputError(PicklableError):
    """Bad input, with all its `faults`.

    Raised before anything is done or written.
    """

    def __init__(self, subject: str, faults: Iterable[Fault]) -> None:
        self.subject = subject
        self.faults = tuple(faults)
        merged = _merge_repeated(self.faults)
        head = f"{visible(subject)}: {len(merged)} fault{'s' if len(merged) != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {fault}".replace("\n", "\n  ") for fault in merged)]))


@contextmanager
def noted(faults: list[Fault]) -> Iterator[None]:
    """Append the faults of bad input that is found within to a list, those that it has not."""
    try:
        yield
    except InputError as error:
        faults += [fault for fault in error.faults if fault not in faults]


def faults_if(*checks: tuple[bool, Fault]) -> list[Fault]:
    """Return the faults whose condition holds."""
    return [fault for wrong, fault in checks if wrong]


def refuse(subject: str, faults: Collection[Fault]) -> None:
    """Raise InputError with faults, if there are any."""
    if faults:
        raise InputError(subject, faults)


def _merge_repeated(faults: Iterable[Fault]) -> list[Fault]:
    """Merge faults that differ only in `where`, as when many pairs share a parameter."""
    places: dict[tuple[str, str, str], list[str]] = {}
    for fault in faults:
        where = places.setdefault((fault.found, fault.expected, fault.remedy), [])
        if fault.where not in where:
            where.append(fault.where)
    return [Fault(", ".join(where), *rest) for rest, where in places.items()]
