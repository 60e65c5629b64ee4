"""Spread of the candidates for a reconstructed law, whose published expression was not accessible."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import StiffnessLaw, d

PER_DECADE, FIRST, DECADES = 8, -8, 4  # penetrations of 10 nm to 0.1 mm
DEFAULT_PAIRS = ("pin_in_bush",)  # of the example of a law that holds for every pair


@dataclass(frozen=True)
class Candidate:
    """Forces [N] and local exponents dlnF/dlnd of one candidate, at the penetrations of the band."""

    law: str
    forces: tuple[float, ...]
    exponents: tuple[float, ...]


@dataclass(frozen=True)
class Band:
    """All candidates at the same penetrations [m], for the example of the sheet."""

    penetrations: tuple[float, ...]
    candidates: tuple[Candidate, ...]

    @property
    def spread(self) -> tuple[float, ...]:
        """Ratio of the largest to the smallest force at each penetration."""
        columns = zip(*(candidate.forces for candidate in self.candidates), strict=True)
        return tuple(max(column) / min(column) for column in columns)


def band_of(law: StiffnessLaw, example: Callable[[StiffnessLaw], Mapping[Any, Any]]) -> Band | None:
    """Band of a law of grade R, with values for the symbols of each candidate; None for other laws."""
    if law.grade != "R":
        return None
    depths = tuple(10 ** (FIRST + k / PER_DECADE) for k in range(DECADES * PER_DECADE + 1))
    return Band(depths, tuple(_candidate(other, example(other), depths) for other in _candidates(law)))


def _candidates(law: StiffnessLaw) -> list[StiffnessLaw]:
    """Reconstructions that are alternatives to the law, itself first."""
    places = set(law.pairs or DEFAULT_PAIRS)
    others = [
        other
        for other in LAWS.values()
        if isinstance(other, StiffnessLaw) and other.grade == "R" and (not other.pairs or places & set(other.pairs))
    ]
    return [law, *(other for other in others if other is not law)]


def _candidate(law: StiffnessLaw, values: Mapping[Any, Any], depths: tuple[float, ...]) -> Candidate:
    slope = sp.diff(law.force, d)
    with mp.workdps(30):
        rows = [(x, *(evaluate(e, {**values, d: x}) for e in (law.force, slope))) for x in map(mpf, depths)]
        return Candidate(law.name, tuple(float(f) for _, f, _ in rows), tuple(float(x * k / f) for x, f, k in rows))
