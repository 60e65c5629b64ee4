"""Names that cannot be, or are there twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from hertzwerk.derive.faults import Fault


def repeated(kind: str, names: Iterable[str]) -> Iterator[Fault]:
    """Names that are no identifiers, or not unique."""
    names = list(names)
    for name in dict.fromkeys(names):
        if not name.isidentifier():
            yield Fault(kind, f"the name {name!r}", "a Python identifier")
        if names.count(name) > 1:
            yield Fault(
                f"{kind} {name}", f"{names.count(name)} of this name", "names that are unique", "Rename one of them."
            )


def twice(what: str, names: list[str]) -> Iterator[Fault]:
    """What there can be one of, and is more."""
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            yield Fault(f"{what} {name}", f"{names.count(name)}", "one")
