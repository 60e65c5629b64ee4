"""Junctions of tracks: events where a point passes from one piece of a chain to the next."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.effects.effect import NOWHERE, Declared, Effect, Element, Event, Kinematics, State


@dataclass(frozen=True)
class Junctions(Effect):
    """Junctions of a track along a chain of `pieces`, at which its curvature jumps.

    A scene has one for each such track. A step ends at each of them: across it, no method has the order that its error is
    judged by. The state `<name>.piece` is the number of pieces passed, as of the track's parameter.
    """

    name: str
    track: str
    pieces: int
    closed: bool
    kind: ClassVar[str] = "junctions"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return f"junctions of {self.track}, where steps end"

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the piece; the first step finds it."""
        yield State("piece", "1", size=sp.S.One)

    def element(self, kin: Kinematics) -> Element:
        """Event at both ends of the piece."""
        piece, at = kin.state(f"{self.name}.piece"), kin.along_track(self.track)
        n, past = self.pieces, at - piece
        if self.closed:
            half = sp.Rational(1, 2)
            past += Where(past > n - half, -n, Where(past < half + 1 - n, n, 0))
        past = kin.tape.let(past, f"{self.name}_past")
        passed = sp.Add(*(Where(at >= k, 1, 0) for k in range(1, n)))
        return Element(events=(Event("junction", past * (1 - past), sp.S.One, {"piece": passed}),))
