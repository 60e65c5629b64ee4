"""Hydrodynamic lubrication of a pin in its bush: a fluid film that gives way to dry contact where the surfaces touch.

The film is a force of its own, in flight as in contact. While it is thicker than two boundary layers (the height of the asperities) it is that of
its law. Closer, the eccentricity the law is given stays behind the true one, so that the film never gets thinner than one layer and its force stays
finite. From contact on it fades, and is gone at a penetration of one layer, where the contact law is all there is: the transition of Flores,
Lankarani, Ambrosio, Claro, Proc. IMechE K 218 (2004) 183, whose dry force needs no weight here because it begins at zero by itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.laws.law import BoundLaw
from hertzwerk.derive.mechanism.bodies import Slot
from hertzwerk.derive.mechanism.parameter import POSITIVE, Interval, Scalar, is_number


@dataclass(frozen=True)
class Lubrication:
    """The film of one pair; `boundary_layer` [m] is the thickness at which the asperities of both surfaces meet, less than half the clearance."""

    name: str
    pair: str
    law: BoundLaw
    boundary_layer: Scalar
    unchecked: bool = False
    kind: ClassVar[str] = "lubrication"
    takes: ClassVar[str] = "film"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"{self.law.law.name} film at {self.pair}" + (", UNCHECKED" if self.unchecked else "")

    @property
    def laws(self) -> tuple[BoundLaw, ...]:
        """The one law."""
        return (self.law,)

    def slots(self, geometry: Mapping[str, Any]) -> Iterator[Slot]:
        """The parameters of the law, the boundary layer, and that against the clearance."""
        where = f"effect {self.name}"
        yield from self.law.slots(where, dict(geometry))
        yield Slot(f"{where}, boundary layer", self.boundary_layer, "m", POSITIVE)
        if "dR" in geometry and is_number(self.boundary_layer):
            yield Slot(
                f"{where}, boundary layer over clearance", self.boundary_layer / geometry["dR"], "1",
                Interval(0, 0.5, open_left=True, open_right=True),
            )  # fmt: skip
