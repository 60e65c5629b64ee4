"""Worn surfaces of a pair: their depth where they touch, its change with the pose, and Archard's law.

The depth of a pin in its bush is a mean over the sectors, by the shares of the direction in which they touch. The same
shares divide what is lost: their sum is 1, so the volume is exact. It opens the clearance in that direction. A
force along the gradient of the penetration does no work beside what is stored: its normal turns, by the contour's
slope over the eccentricity, and a worn pin takes a couple. A track of a plane is such a contour, unrolled.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, cast

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.tribology.wear import CONTOUR, DEPTH, LOAD_PATH, TRACK, Wear
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.sectors import Mean, Share, Shares
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, cross, dot, scale, sub, transpose
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.program.program import Tape

PURE = Dimension.from_unit("1")
INNER, OUTER = sp.Float("0.0625"), sp.Float("0.5")  # exact in binary, and printed as one number
"""Squares of eccentricity over clearance between which a direction begins to count: the centre has none."""


class Worn(ABC):
    """Worn surfaces of a contact geometry on its tape."""

    stretch: Any = None
    """Length of the gradient of the penetration [1] where the depth varies with the place of contact."""
    spin_rate: Any = sp.S.Zero
    """Rate of the penetration by the first body's spin against the second [m/s]."""

    def __init__(self, touch: Any, wear: Wear) -> None:
        self.touch, self.wear, self.tape = touch, wear, cast(Tape, touch.tape)
        self.specific, depths = wear.rates(touch.pair), wear.depths(touch.pair)
        self.states = {label: [touch.kin.state(f"{wear.name}.{name}") for name in of] for label, of in depths.items()}
        for state in (state for states in self.states.values() for state in states):
            self.tape.set_rate(state, sp.S.Zero)  # at rates of the pose alone: wear adds its own in contact

    def let(self, expression: Any, label: str, dimension: Dimension | None = None) -> Any:
        """Name a result of the wear on the tape."""
        return self.tape.let(expression, f"{self.wear.name}_{label}", dimension)

    @property
    @abstractmethod
    def depth(self) -> Any:
        """Sum of the depths of both surfaces where they touch [m]."""

    @property
    def volume(self) -> Any:
        """Volume lost [m^3], by Archard's law itself."""
        (specific,) = self.specific.values()
        return specific * self.wear.acceleration * self.touch.kin.state(f"{self.wear.name}.{LOAD_PATH}")

    def couple(self, force: Any) -> Vector:
        """Couple on the first body of a force along the gradient of the penetration [N m]."""
        return ZERO

    def faults(self) -> Iterator[Fault]:
        """Yield faults that only the derived motion shows."""
        yield from ()

    @cached_property
    def deep(self) -> Any:
        """Twice the depth and the penetration of a sphere [m]; its radius at the onset, which has no area."""
        penetration = self.touch.penetration
        return self.let(Where(penetration > 0, penetration + 2 * self.depth, self.touch.pair.radius), "deep")

    def pressed(self, rate: Any) -> Any:
        """A rate of a sphere's wear, zero at the very onset."""
        return Where(self.touch.penetration > 0, rate, 0)

    def progress(self, force: Any, speed: Any) -> tuple[dict[str, Any], Any]:
        """Archard's law under a normal force [N] at a sliding speed [m/s].

        Rates of the wear's states by name [m/s, W], and the rate at which the gap opens by them [m/s].
        """
        power = self.let(force * speed, "power")
        rates: dict[str, Any] = {f"{self.wear.name}.{LOAD_PATH}": power}
        recession: list[Any] = []
        for label, specific in self.specific.items():
            lost = self.let(specific * self.wear.acceleration * power, f"{label}_loss")
            shares, opening = self.lost(label, lost)
            names = self.wear.depths(self.touch.pair)[label]
            rates |= {f"{self.wear.name}.{name}": share for name, share in zip(names, shares, strict=True)}
            recession.append(opening)
        return rates, self.let(sp.Add(*recession), "recession")

    @abstractmethod
    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rates of a surface's depths, and of that where it touches [m/s], of a volume lost [m^3/s]."""


class WornSpot(Worn):
    """A spot of the first surface: of the declared area, or the flat of a sphere."""

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a sphere that may turn against the plane."""
        axes = transpose(self.touch.kin.axes_of(self.touch.first))
        if not all(self.tape.is_constant(dot(axis, self.touch.normal)) for axis in axes):
            yield Fault(self.wear.where, f"a sphere at {self.touch.pair.name} that may turn against the plane", "one that slides on the same spot",
                        "Where it rolls, its spot wanders over the sphere, which has no state.")  # fmt: skip

    @cached_property
    def depth(self) -> Any:
        """Depth of the spot [m]."""
        return self.states[DEPTH][0]

    @property
    def volume(self) -> Any:
        """Volume lost [m^3]: of a corner by its depth."""
        return super().volume if self.wear.area is None else self.wear.area * self.depth

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rate of the depth, of a sphere over pi R (2 h + d): its flat and the spot under Hertz's pressure."""
        area = self.wear.area
        if area is None:
            area, rate = self.let(sp.pi * self.touch.pair.radius * self.deep, "area"), self.pressed(rate)
        opening = self.let(rate / area, "depth_rate")
        return [opening], opening


@dataclass(frozen=True)
class Side:
    """One surface: shares of its sectors; depth [m] and slope by the angle [m] where it touches."""

    shares: Any
    depth: Any
    slope: Any


class WornSectors(Worn):
    """Contours of surfaces, each by sectors of a turn."""

    @property
    @abstractmethod
    def length(self) -> Any:
        """Way of the place of contact along the contour, over the angle of its turn [m]."""

    @property
    @abstractmethod
    def sides(self) -> dict[str, Side]:
        """Surfaces that wear, by name."""

    @abstractmethod
    def area(self, label: str) -> Any:
        """Area of a sector [m^2]."""

    def side(self, label: str, cosine: Any, sine: Any, turning: Callable[[], Any]) -> Side:
        """Surface where a turn has a cosine and a sine, and a rate [rad/s]."""
        count, depths = sp.Integer(self.wear.sectors), self.states[label]

        def mean(order: int, name: str) -> tuple[Any, Any]:
            node = Shares(count, sp.Integer(order), cosine, sine)
            shares = self.tape.block(node, f"{self.wear.name}_{label}_shares{'_slope' * order}", int(count), PURE)
            return shares, self.let(Mean(shares, *depths), f"{label}_{name}")

        (shares, depth), (_, slope), (_, bend) = (mean(i, name) for i, name in enumerate(("depth", "slope", "bend")))
        rate = self.let(turning(), f"{label}_turning")
        self.tape.set_rate(depth, slope * rate)
        self.tape.set_rate(slope, bend * rate)
        return Side(shares, depth, slope)

    @cached_property
    def depth(self) -> Any:
        """Sum of the depths where they touch [m]."""
        return self.let(sp.Add(*(side.depth for side in self.sides.values())), "depth")

    @cached_property
    def slope(self) -> Any:
        """Slope of the contour that the first place may follow, by its way [1]."""
        slopes = sp.Add(*(side.slope for side in self.sides.values()))
        return self.let(slopes / self.length, "slope")

    @cached_property
    def stretch(self) -> Any:
        """Length of the gradient of the penetration [1]."""
        return self.let(sp.sqrt(1 + self.slope**2), "stretch")

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rates of the sectors' depths, each by its share, and their mean by these shares."""
        shares = self.sides[label].shares
        pace = self.let(rate / self.area(label), f"{label}_pace")
        rates = [pace * Share(shares, sp.Integer(k)) for k in range(self.wear.sectors)]
        return rates, pace * self.let(Mean(shares, shares), f"{label}_concentration")


class WornTrack(WornSectors):
    """Track of a plane under a sphere, which turns once over its length."""

    @property
    def length(self) -> Any:
        """Way along the track over the turn [m]."""
        return self.wear.track / (2 * sp.pi)

    @cached_property
    def _along(self) -> Vector:
        return self.tape.vector(self.touch.kin.direction(self.touch.second, self.wear.along), f"{self.wear.name}_along")

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a sphere that may leave the track to its side."""
        if not self.tape.is_constant(dot(cross(self.touch.direction, self._along), self.touch.apart)):
            yield Fault(self.wear.where, f"a sphere at {self.touch.pair.name} that may leave the track to its side",
                        "one that stays in the plane of the track and of the normal")  # fmt: skip

    @cached_property
    def sides(self) -> dict[str, Side]:
        """The plane."""
        x = self.let(dot(self._along, self.touch.apart), "track_position")
        angle = x / self.length
        cosine, sine = self.let(sp.cos(angle), "track_cosine"), self.let(sp.sin(angle), "track_sine")
        rate = self.tape.rate(x, f"{self.wear.name}_track_rate")
        return {TRACK: self.side(TRACK, cosine, sine, lambda: rate / self.length)}

    @cached_property
    def normal(self) -> Vector:
        """Unit vector along which the sphere is pushed, against the gradient of the penetration."""
        return scale(1 / self.stretch, add(self.touch.direction, scale(self.slope, self._along)))

    def area(self, label: str) -> Any:
        """Area of a sector [m^2]: of a groove in contact, under the chord of the sphere."""
        breadth = self.let(2 * sp.sqrt(self.touch.pair.radius * self.deep), "breadth")
        return breadth * self.wear.track / self.wear.sectors

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rates of the sectors' depths, and their mean."""
        return super().lost(label, self.pressed(rate))


class WornContour(WornSectors):
    """Contours of a pin and its bush, each by sectors about the axis."""

    @cached_property
    def _axis(self) -> Vector:
        axis = self.touch.kin.direction(self.touch.second, self.touch.pair.axis)
        return self.tape.vector(axis, f"{self.wear.name}_axis")

    @cached_property
    def length(self) -> Any:
        """Eccentricity where its direction counts [m]; a fixed length near the centre."""
        least = INNER * sp.sympify(self.touch.pair.clearance) ** 2
        safe = self.let(Where(self.touch.squared > least, self.touch.squared, least), "safe_squared")
        return self.let(sp.sqrt(safe), "length")

    @cached_property
    def sides(self) -> dict[str, Side]:
        """Pin and bush, of those that wear."""
        places: dict[str, Point] = dict(zip(self.touch.pair.labels, (self.touch.first, self.touch.second), strict=True))
        return {label: self._side(label, places[label]) for label in self.states}

    def _side(self, label: str, place: Point) -> Side:
        """Surface of the body at a place."""
        axis = self.touch.pair.axis.unit
        k = next(i for i in range(3) if axis[i])
        columns = transpose(self.touch.kin.axes_of(place))
        e = self.touch.eccentricity
        x = self.let(dot(columns[(k + 1) % 3], e), f"{label}_x")
        y = self.let(axis[k] * dot(columns[(k + 2) % 3], e), f"{label}_y")
        cosine, sine = (self.let(part / self.length, f"{label}_{name}") for part, name in ((x, "cosine"), (y, "sine")))

        def turning() -> Any:
            rates = [
                self.tape.rate(part, f"{self.wear.name}_{label}_{name}_rate") for part, name in ((x, "x"), (y, "y"))
            ]
            return (x * rates[1] - y * rates[0]) / self.length**2

        return self.side(label, cosine, sine, turning)

    @cached_property
    def counted(self) -> Any:
        """Depth of the event function [m], which fades towards the centre."""
        ratio = self.let(self.touch.squared / sp.sympify(self.touch.pair.clearance) ** 2, "ratio")
        x = self.let((ratio - INNER) / (OUTER - INNER), "nearness")
        share = Where(ratio < INNER, 0, Where(ratio < OUTER, x**3 * (10 - 15 * x + 6 * x**2), 1))
        return self.let(self.let(share, "counted_share") * self.depth, "counted")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector along which the pin is pushed, against that gradient."""
        radial = self.tape.vector(scale(1 / self.length, self.touch.eccentricity), f"{self.wear.name}_radial")
        across = cross(self._axis, radial)
        return scale(1 / self.stretch, add(scale(-1, radial), scale(self.slope, across)))

    @cached_property
    def spin_rate(self) -> Any:
        """Rate of the penetration by the pin's spin in the bush [m/s]; zero unless the pin wears."""
        bodies = self.touch.first.body, self.touch.second.body
        spin = dot(self._axis, sub(*map(self.touch.kin.angular_velocity, bodies)))
        return self._lever * self.let(spin, "spin")

    @cached_property
    def _lever(self) -> Any:
        """Slope of the pin's contour by the angle [m]: the arm of the force about its centre."""
        side = self.sides.get(self.touch.pair.labels[0])
        return sp.S.Zero if side is None else side.slope

    def couple(self, force: Any) -> Vector:
        """Couple on the pin of a force along the gradient [N m]."""
        return self.tape.vector(scale(-force * self._lever, self._axis), f"{self.wear.name}_couple")

    def area(self, label: str) -> Any:
        """Area of a sector [m^2]."""
        pair = self.touch.pair
        radius = pair.first_radius if label == pair.labels[0] else pair.outer_radius
        return self.let(2 * sp.pi * radius * pair.length / self.wear.sectors, f"{label}_sector")

    @cached_property
    def volume(self) -> Any:
        """Volume lost by both surfaces [m^3]."""
        return sp.Add(*(self.area(label) * sp.Add(*states) for label, states in self.states.items()))


def worn_at(touch: Any) -> Any:
    """The worn surfaces of a contact geometry's pair, by how it wears; None without wear."""
    wear = next((effect for effect in touch.kin.scene.all(Wear) if effect.pair == touch.pair.name), None)
    if wear is None:
        return None
    return (WornContour if touch.pair.wears == CONTOUR else WornSpot if wear.track is None else WornTrack)(touch, wear)
