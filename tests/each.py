"""One test of many cases: every one is tried, and all that fail are named; a test each costs five times as much as these."""

import inspect
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import Any

import pytest


def each(names: str | Sequence[str], cases: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Try a test with every case, as `pytest.mark.parametrize` would; used twice, with all combinations."""
    wanted = (names,) if isinstance(names, str) else tuple(names)
    rows = [dict(zip(wanted, (case,) if isinstance(names, str) else case, strict=True)) for case in cases]

    def decorate(test: Callable[..., None]) -> Callable[..., None]:
        alone, others = getattr(test, "tried", (test, [{}]))
        tried = [{**other, **row} for row, other in product(rows, others)]

        def try_all(**fixtures: Any) -> None:
            failed = []
            for row in tried:
                try:
                    alone(**fixtures, **row)
                except (Exception, pytest.fail.Exception) as error:
                    error.add_note(f"with {', '.join(f'{name} = {value!r:.200}' for name, value in row.items())}")
                    failed.append(error)
            assert tried
            if failed:
                raise BaseExceptionGroup(f"{len(failed)} of {len(tried)} cases", failed)

        kept = [
            p
            for p in inspect.signature(alone).parameters.values()
            if p.name not in {name for row in tried for name in row}
        ]
        try_all.__dict__.update(test.__dict__, tried=(alone, tried), __signature__=inspect.Signature(kept))
        try_all.__name__, try_all.__doc__, try_all.__module__ = alone.__name__, alone.__doc__, alone.__module__
        return try_all

    return decorate
