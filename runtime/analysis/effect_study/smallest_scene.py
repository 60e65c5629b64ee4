"""Smallest scene whose outputs stay within a tolerance, by leaving out effects one after another.

Effects that change little alone may change much together, and two that change much may cancel. So every further
effect is tried in the scene that is left, and where no single one can go, every two of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations

MOST = 80  # scenes tried


@dataclass(frozen=True)
class Smallest:
    """Effects kept and left out, largest change of an output with its error, scenes tried, completeness."""

    effects: tuple[str, ...]
    left_out: tuple[str, ...]
    change: float
    tried: int
    complete: bool


def smallest(
    effects: tuple[str, ...],
    within: float,
    following: Mapping[str, frozenset[str]],
    change: Callable[[frozenset[str]], float],
    most: int = MOST,
) -> Smallest:
    """Leave out as many effects as the outputs allow.

    following    of each effect that can be left out: it, and what goes with it
    change    largest relative change of the outputs with its error, of the scene without these effects; infinite where it is no scene or
              lacks one of them: then no further effect is left out with these
    """
    known: dict[frozenset[str], float] = {frozenset(): 0.0}
    gone: frozenset[str] = frozenset()
    complete = True

    def tried(without: frozenset[str]) -> float:
        nonlocal complete
        if without not in known:
            if len(known) > most:
                complete = False
                return math.inf
            known[without] = change(without)
        return known[without]

    while True:
        left = [name for name in following if name not in gone]
        single = {name: gone | following[name] for name in left}
        fitting = [without for without in single.values() if tried(without) <= within]
        if not fitting:
            possible = [name for name in left if math.isfinite(tried(single[name]))]
            pairs = [single[a] | single[b] for a, b in combinations(possible, 2)]
            fitting = [without for without in pairs if tried(without) <= within]
        if not fitting:
            break
        gone = min(fitting, key=tried)
    remaining = tuple(name for name in effects if name not in gone)
    left_out = tuple(name for name in effects if name in gone)
    return Smallest(remaining, left_out, known[gone], len(known) - 1, complete)
