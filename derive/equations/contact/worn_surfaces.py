"""Worn surfaces of a pair: their depth where they touch, its change with the pose, and Archard's law.

The depth of a pin in its bush is a mean over the sectors, by the shares of the direction in which they touch. The same
shares divide what is lost: their sum is 1, so the volume is exact. It opens the clearance in that direction. A
force along the gradient of the penetration does no work beside what is stored: its normal turns, by the contour's
slope over the eccentricity, and a worn pin takes a couple.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.tribology.wear import CONTOUR, DEPTH, LOAD_PATH, Wear
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.sectors import Mean, Share, Shares
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, cross, dot, scale, sub, transpose
from hertzwerk.derive.expressions.dimension.dimension import Dimension

PURE = Dimension.from_unit("1")
INNER, OUTER = sp.Float("0.0625"), sp.Float("0.5")  # exact in binary, and printed as one number
"""Squares of eccentricity over clearance between which a direction begins to count: the centre has none."""


@dataclass(frozen=True)
class Progress:
    """Rates of the wear's states by name [m/s, W], and the rate at which the gap opens by them [m/s]."""

    rates: dict[str, Any]
    recession: Any


class Worn:
    """Worn surfaces of a contact geometry on its tape."""

    def __init__(self, touch: Any, wear: Wear) -> None:
        self.touch, self.wear, self.tape = touch, wear, touch.tape
        self.specific = wear.rates(touch.pair)
        names = {label: [f"{wear.name}.{name}" for name in names] for label, names in wear.depths(touch.pair).items()}
        self.states = {label: [touch.kin.state(name) for name in of] for label, of in names.items()}
        for state in (state for states in self.states.values() for state in states):
            self.tape.set_rate(state, sp.S.Zero)  # at rates of the pose alone: wear adds its own in contact

    def let(self, expression: Any, label: str, dimension: Dimension | None = None) -> Any:
        """Name a result of the wear on the tape."""
        return self.tape.let(expression, f"{self.wear.name}_{label}", dimension)

    @property
    def depth(self) -> Any:
        """Sum of the depths of both surfaces where they touch [m]."""
        raise NotImplementedError

    @property
    def volume(self) -> Any:
        """Volume lost [m^3]."""
        raise NotImplementedError

    def progress(self, force: Any, speed: Any) -> Progress:
        """Archard's law under a normal force [N] at a sliding speed [m/s]."""
        power = self.let(force * speed, "power")
        rates: dict[str, Any] = {f"{self.wear.name}.{LOAD_PATH}": power}
        recession: list[Any] = []
        for label, specific in self.specific.items():
            lost = self.let(specific * self.wear.acceleration * power, f"{label}_loss")
            shares, opening = self.lost(label, lost)
            names = self.wear.depths(self.touch.pair)[label]
            rates |= {f"{self.wear.name}.{name}": share for name, share in zip(names, shares, strict=True)}
            recession.append(opening)
        return Progress(rates, self.let(sp.Add(*recession), "recession"))

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rates of a surface's depths, and of that where it touches [m/s], of a volume lost [m^3/s]."""
        raise NotImplementedError


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

    @cached_property
    def volume(self) -> Any:
        """Volume lost [m^3]: of a sphere, whose spot grows, by Archard's law itself."""
        if self.wear.area is not None:
            return self.wear.area * self.depth
        path = self.touch.kin.state(f"{self.wear.name}.{LOAD_PATH}")
        return self.specific[DEPTH] * self.wear.acceleration * path

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rate of the depth, of a sphere over pi R (2 h + d): its flat and the spot under Hertz's pressure."""
        radius, area = getattr(self.touch.pair, "radius", None), self.wear.area
        if area is None:
            area = self.let(sp.pi * radius * (self.touch.penetration + 2 * self.depth), "area")
        opening = self.let(rate / area, "depth_rate")
        return [opening], opening


@dataclass(frozen=True)
class Side:
    """One surface: shares of its sectors; depth [m] and slope by the angle [m] where it touches."""

    shares: Any
    depth: Any
    slope: Any


class WornContour(Worn):
    """Contours of a pin and its bush, each by sectors about the axis."""

    @cached_property
    def _axis(self) -> Vector:
        direction = self.touch.kin.direction(self.touch.second, self.touch.pair.axis)
        axis: Vector = self.tape.vector(direction, f"{self.wear.name}_axis")
        return axis

    @cached_property
    def _length(self) -> Any:
        """Eccentricity where its direction counts [m]; a fixed length near the centre."""
        least = INNER * sp.sympify(self.touch.pair.clearance) ** 2
        return self.let(
            sp.sqrt(self.let(Where(self.touch.squared > least, self.touch.squared, least), "safe_squared")), "length"
        )

    @cached_property
    def _sides(self) -> dict[str, Side]:
        places: dict[str, Point] = dict(zip(self.touch.pair.labels, (self.touch.first, self.touch.second), strict=True))
        return {label: self._side(label, places[label]) for label in self.states}

    def _side(self, label: str, place: Point) -> Side:
        """Surface of the body at a place."""
        axis, count = self.touch.pair.axis.unit, sp.Integer(self.wear.sectors)
        k = next(i for i in range(3) if axis[i])
        columns = transpose(self.touch.kin.axes_of(place))
        e = self.touch.eccentricity
        x = self.let(dot(columns[(k + 1) % 3], e), f"{label}_x")
        y = self.let(axis[k] * dot(columns[(k + 2) % 3], e), f"{label}_y")
        cosine, sine = (self.let(part / self._length, f"{label}_{name}") for part, name in ((x, "cosine"), (y, "sine")))
        depths = self.states[label]

        def mean(order: int, name: str) -> tuple[Any, Any]:
            node = Shares(count, sp.Integer(order), cosine, sine)
            shares = self.tape.block(node, f"{self.wear.name}_{label}_shares{'_slope' * order}", int(count), PURE)
            return shares, self.let(Mean(shares, *depths), f"{label}_{name}")

        (shares, depth), (_, slope), (_, bend) = (mean(i, name) for i, name in enumerate(("depth", "slope", "bend")))
        rates = [self.tape.rate(part, f"{self.wear.name}_{label}_{name}_rate") for part, name in ((x, "x"), (y, "y"))]
        turning = self.let((x * rates[1] - y * rates[0]) / self._length**2, f"{label}_turning")
        self.tape.set_rate(depth, slope * turning)
        self.tape.set_rate(slope, bend * turning)
        return Side(shares, depth, slope)

    @cached_property
    def depth(self) -> Any:
        """Sum of the depths of pin and bush where they touch [m]."""
        return self.let(sp.Add(*(side.depth for side in self._sides.values())), "depth")

    @cached_property
    def counted(self) -> Any:
        """Depth of the event function [m], which fades towards the centre."""
        ratio = self.let(self.touch.squared / sp.sympify(self.touch.pair.clearance) ** 2, "ratio")
        x = self.let((ratio - INNER) / (OUTER - INNER), "nearness")
        share = Where(ratio < INNER, 0, Where(ratio < OUTER, x**3 * (10 - 15 * x + 6 * x**2), 1))
        return self.let(self.let(share, "counted_share") * self.depth, "counted")

    @cached_property
    def slope(self) -> Any:
        """Slope of the contour that the pin's centre may follow, by its angle, over the eccentricity [1]."""
        slopes = sp.Add(*(side.slope for side in self._sides.values()))
        return self.let(slopes / self._length, "slope")

    @cached_property
    def stretch(self) -> Any:
        """Length of the gradient of the penetration [1]."""
        return self.let(sp.sqrt(1 + self.slope**2), "stretch")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector along which the pin is pushed, against that gradient."""
        radial = self.tape.vector(scale(1 / self._length, self.touch.eccentricity), f"{self.wear.name}_radial")
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
        side = self._sides.get(self.touch.pair.labels[0])
        return sp.S.Zero if side is None else side.slope

    def couple(self, force: Any) -> Vector:
        """Couple on the pin of a force along the gradient [N m]."""
        couple: Vector = self.tape.vector(scale(-force * self._lever, self._axis), f"{self.wear.name}_couple")
        return couple

    def _area(self, label: str) -> Any:
        """Area of a sector [m^2]."""
        pair = self.touch.pair
        radius = pair.first_radius if label == pair.labels[0] else pair.outer_radius
        return self.let(2 * sp.pi * radius * pair.length / self.wear.sectors, f"{label}_sector")

    @cached_property
    def volume(self) -> Any:
        """Volume lost by both surfaces [m^3]."""
        return sp.Add(*(self._area(label) * sp.Add(*states) for label, states in self.states.items()))

    def lost(self, label: str, rate: Any) -> tuple[Sequence[Any], Any]:
        """Rates of the sectors' depths, each by its share, and their mean by these shares."""
        shares = self._sides[label].shares
        pace = self.let(rate / self._area(label), f"{label}_pace")
        rates = [pace * Share(shares, sp.Integer(k)) for k in range(self.wear.sectors)]
        return rates, pace * self.let(Mean(shares, shares), f"{label}_concentration")


def worn_at(touch: Any) -> Any:
    """The worn surfaces of a contact geometry's pair, by how it wears; None without wear."""
    wear = next((effect for effect in touch.kin.scene.all(Wear) if effect.pair == touch.pair.name), None)
    return None if wear is None else (WornContour if touch.pair.wears == CONTOUR else WornSpot)(touch, wear)
