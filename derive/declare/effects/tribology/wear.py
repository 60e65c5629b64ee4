"""Wear of a pair by Archard's law: material lost in proportion to normal force and sliding distance."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.declare.effects.contacts import contact_faults
from hertzwerk.derive.declare.effects.effect import CONTACT, Declared, Element, Kinematics, PairEffect, State
from hertzwerk.derive.declare.effects.tribology.lubrication import Lubrication
from hertzwerk.derive.declare.mechanism.bodies import Direction
from hertzwerk.derive.expressions.algebra.vectors import dot
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot, default_value

QUANTITIES = {
    "length": ("e", "", "eccentricity, at least a quarter of the clearance"),
    "radial": ("e", "0", "direction in which pin and bush touch"),
    "pin_cosine": ("c", r"\mathrm{pin}", "cosine of that direction in the axes of the pin"),
    "pin_sine": ("s", r"\mathrm{pin}", "its sine"),
    "pin_shares": (r"\varphi", r"\mathrm{pin}", "shares of the pin's sectors in that direction"),
    "bush_shares": (r"\varphi", r"\mathrm{bush}", "shares of the bush's sectors in that direction"),
    "pin_shares_slope": (r"\varphi'", r"\mathrm{pin}", "their slopes by its angle"),
    "bush_shares_slope": (r"\varphi'", r"\mathrm{bush}", "their slopes by its angle"),
    "pin_depth": ("w", r"\mathrm{pin}", "depth of the pin there"),
    "bush_depth": ("w", r"\mathrm{bush}", "depth of the bush there"),
    "pin_slope": ("w'", r"\mathrm{pin}", "slope of the pin's depth by the angle"),
    "bush_slope": ("w'", r"\mathrm{bush}", "slope of the bush's depth by the angle"),
    "pin_turning": (r"\omega", r"\mathrm{pin}", "rate of the direction's angle in the axes of the pin"),
    "bush_turning": (r"\omega", r"\mathrm{bush}", "rate of the direction's angle in the axes of the bush"),
    "track_position": ("x", "", "position of the contact along the track"),
    "track_cosine": ("c", "", "cosine of that position, a whole turn over the track"),
    "track_sine": ("s", "", "its sine"),
    "track_shares": (r"\varphi", "", "shares of the track's sectors there"),
    "track_shares_slope": (r"\varphi'", "", "their slopes by that turn"),
    "track_depth": ("w", "", "depth of the track there"),
    "track_slope": ("w'", "", "slope of that depth by the turn"),
    "track_turning": (r"\omega", "", "rate of that turn"),
    "deep": ("d", "", "twice the depth, and the penetration"),
    "breadth": ("b", "", "breadth of the groove under the sphere"),
    "slope": ("s", "", "slope of the worn contour, of a pin over the eccentricity"),
    "depth": ("w", "", "depth of both"),
    "counted": ("w", r"\mathrm{G}", "depth of both, faded towards the centre"),
    "area": ("A", "", "area of the spot"),
    "power": ("P", r"\mathrm{s}", "normal force times sliding speed"),
    "recession": (r"\dot{w}", "", "rate at which wear opens the gap"),
}
SOUGHT = (
    "length",
    "pin_depth",
    "bush_depth",
    "pin_slope",
    "bush_slope",
    "track_depth",
    "track_slope",
    "breadth",
    "slope",
    "depth",
    "counted",
    "power",
    "recession",
)
CONTOUR, FLAT = "contour", "flat"
"""How a pair wears: around the circles of both surfaces, or at one spot of the first."""
DEPTH, TRACK, LOAD_PATH = "depth", "track", "load_path"


@dataclass(frozen=True)
class Wear(PairEffect):
    """Wear of a pair's surfaces: volume lost by a specific wear rate, normal force and sliding distance.

    `first` and `second` are the specific wear rates of the two bodies' surfaces, in 1/Pa or mm^3/(N m): k/H of a wear
    coefficient k [1] and a hardness H [Pa], an expression of two parameters. What is lost opens the gap where they touch.

    A pin in its bush, which needs a `length`, loses a depth in each of the `sectors` of its circumference, a power of 2: states
    `<name>.pin_1`.. and `<name>.bush_1`.. [m], about the axis from the x axis of the place. A sphere or a corner loses
    `<name>.depth`, over the corner's `area`, or over the sphere's growing flat.

    The plane under a sphere wears, `second`, in the `sectors` of a `track` of that length [m] `along` a direction of the plane's
    frame: states `<name>.track_1`.. [m] from the plane's place, and again beyond its ends.

    With an `acceleration` a, the wear of each sliding counts a times: as many repetitions are left out.
    `<name>.load_path` is the force integrated over the sliding distance [N m], `<name>.volume` what is lost. Archard,
    J. Appl. Phys. 24 (1953) 981, eq. 3.
    """

    name: str
    pair: str
    first: Scalar | None = None
    second: Scalar | None = None
    sectors: int = 32
    area: Scalar | None = None
    acceleration: Scalar = 1
    track: Scalar | None = None
    along: Direction | None = None
    kind: ClassVar[str] = "wear"
    enters: ClassVar[str] = CONTACT
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = QUANTITIES
    sought: ClassVar[tuple[str, ...]] = SOUGHT
    measures: ClassVar[Mapping[str, Slot]] = {
        "first": Slot.of("1/Pa", NOT_NEGATIVE),
        "second": Slot.of("1/Pa", NOT_NEGATIVE),
        "area": Slot.of("m^2", POSITIVE),
        "acceleration": Slot.of("1", POSITIVE),
        "track": Slot.of("m", POSITIVE),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"Archard's wear at {self.pair}"

    @property
    def directions(self) -> Mapping[str, Direction]:
        """The direction of its track."""
        return {} if self.along is None else {"along": self.along}

    def rates(self, pair: Any) -> dict[str, Any]:
        """Specific wear rates of the surfaces that wear, by the names of their states."""
        names = pair.labels if pair.wears == CONTOUR else (DEPTH, TRACK)
        return {name: rate for name, rate in zip(names, (self.first, self.second), strict=False) if rate is not None}

    def depths(self, pair: Any) -> dict[str, list[str]]:
        """States of each surface that wears, without the effect's name."""
        numbers = range(1, self.sectors + 1)
        return {name: [name] if name == DEPTH else [f"{name}_{k}" for k in numbers] for name in self.rates(pair)}

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield its quantities, and the length of the bush."""
        yield from super().slots(scene)
        pair: Any = scene.mechanism.pair_named.get(self.pair)
        if getattr(pair, "wears", "") == CONTOUR and pair.length is not None:
            yield Slot(f"pair {pair.name}, length", pair.length, "m", POSITIVE)

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the depths, and the force integrated over the sliding distance."""
        pair: Any = scene.mechanism.pair_named.get(self.pair)
        if pair is None or not pair.wears or not isinstance(self.sectors, int):
            return  # a fault
        yield from (State(name, "m") for names in self.depths(pair).values() for name in names)
        scale = scene.scales
        yield State(LOAD_PATH, "N m", size=scene.mechanism.total_mass * scale.speed**2 / 2)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair that cannot wear, and of what is missing or too much."""
        yield from contact_faults(self, scene) or super().faults(scene)
        pair: Any = scene.mechanism.pair_named.get(self.pair)
        if pair is None:
            return
        if not pair.wears:
            known = [other.name for other in scene.mechanism.pairs if other.wears]
            yield Fault(self.where, f"pair {self.pair}, a {pair.kind}", one_of(known, "a pin, a sphere or a corner"))
            return
        if self.first is None and self.second is None:
            yield Fault(self.where, "no specific wear rate", "one of `first` or of `second`")
        if (self.track is None) != (self.along is None) or (self.track is not None and pair.wears == CONTOUR):
            yield Fault(self.where, "a track and a direction along it that do not belong together, or those of a pin",
                        "both for a plane that wears under a sphere, else neither")  # fmt: skip
        yield from self._contour_faults(scene, pair) if pair.wears == CONTOUR else self._flat_faults(pair)

    def _flat_faults(self, pair: Any) -> Iterator[Fault]:
        """Yield faults of a flat of a sphere or a corner, or of a plane's track."""
        sphere = hasattr(pair, "radius")
        if self.second is None:
            if (self.area is None) != sphere:
                yield Fault(self.where, "no area" if self.area is None else "an area of a sphere",
                            "an area for a corner, none for a sphere", "A sphere's flat grows with its depth.")  # fmt: skip
        elif self.first is not None or self.track is None or not sphere:
            yield Fault(self.where, f"a specific wear rate of the second body at {self.pair}", "a plane that wears alone, under a sphere",
                        "A plane wears along its `track`, under a sphere that keeps its form: leave `first` out, or `second`.")  # fmt: skip
        else:
            yield from self._sector_faults()
        if self.along is not None and abs(default_value(dot(self.along.unit, pair.normal.unit))) > 1e-9:
            yield Fault(f"{self.where}, along", "a direction that is inclined to the plane", "one in the plane")

    def _contour_faults(self, scene: Declared, pair: Any) -> Iterator[Fault]:
        """Yield faults of the contours of a pin and its bush."""
        if pair.length is None:
            yield Fault(f"pair {self.pair}, length", "None", "a length, for the area of a sector",
                        "The length over which both touch: PinInBush(..., length=...).")  # fmt: skip
        if self.area is not None:
            yield Fault(self.where, "an area of a pin in its bush", "none", "Its sectors have theirs.")
        yield from self._sector_faults()
        for other in scene.effects:
            if isinstance(other, Lubrication) and other.pair == self.pair:
                yield Fault(self.where, f"film {other.name} at {self.pair} too", "a dry pair",
                            "A film in a worn gap has no law: leave one out.")  # fmt: skip

    def _sector_faults(self) -> Iterator[Fault]:
        count = self.sectors
        if not (isinstance(count, int) and count >= 4 and count & (count - 1) == 0):
            yield Fault(self.where, f"sectors={count!r}", "a power of 2, at least 4")

    def element(self, kin: Kinematics) -> Element:
        """The volume lost [m^3]; its states rest but in contact, whose forces are known there alone."""
        volume = sp.sympify(kin.touch(self.pair).worn.volume)
        still = {state.name: sp.S.Zero for state in self.states(kin.scene)}
        return Element(outputs=((f"{self.name}.volume", "m^3", volume),), rates=still)
