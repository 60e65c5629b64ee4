"""Involute teeth of spur gears, as curves of their flanks. Declarations only."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.declare.mechanism.curve import Curve, S, SolidCurve
from hertzwerk.derive.expressions.algebra.planar_curve import Drawn, DrawnTeeth, PlanarCurve
from hertzwerk.derive.expressions.parameter import POSITIVE, Interval, Scalar, Slot, default_value, is_number

FEWEST = 5  # teeth
ROOT = 0.04  # of the roll angle at the tip, where a flank starts: on the base circle its radius of curvature is zero
DEDENDUM = sp.Rational(5, 4)  # in modules
ACUTE = Interval(0, math.pi / 4)


@dataclass(frozen=True)
class InvoluteTeeth:
    """Teeth of an external spur gear with involute flanks, one of them on the X axis of its place.

    module          pitch diameter over the number of teeth [m]; that is `teeth`
    pressure_angle  at the reference circle [rad]
    thinning        arc of the reference circle by which a tooth is narrower than a space is wide, half of it [m]
    addendum        height of the tip over the reference circle, in modules; the root is 1.25 below
    left, right     flanks that look counterclockwise and clockwise, each a `Curve` that repeats
    """

    name: str
    module: Scalar
    teeth: int
    pressure_angle: Scalar
    thinning: Scalar = 0
    addendum: Scalar = 1

    @property
    def where(self) -> str:
        """Its name in messages."""
        return f"teeth {self.name}"

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities."""
        yield Slot(f"{self.where}, module", self.module, "m", POSITIVE)
        yield Slot(f"{self.where}, pressure angle", self.pressure_angle, "rad", ACUTE)
        yield Slot(f"{self.where}, thinning", self.thinning, "m")
        yield Slot(f"{self.where}, addendum", self.addendum, "1", POSITIVE)

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of its numbers, and of teeth that are pointed below their tip."""
        yield from name_faults(self.where, self.name)
        if not isinstance(self.teeth, int) or isinstance(self.teeth, bool) or self.teeth < FEWEST:
            yield Fault(f"{self.where}, teeth", repr(self.teeth), f"a whole number, {FEWEST} or more")
        elif all(is_number(slot.value) for slot in self.slots()):
            tip = default_value(self.half_tip)
            if math.isfinite(tip) and tip <= 0:
                yield Fault(self.where, "flanks that cross below the tip", "a tooth with a tip of some width",
                            "A lower addendum, less thinning, or more teeth.")  # fmt: skip

    @property
    def base_radius(self) -> Any:
        """Radius of the base circle [m], whose tangent is the line of action."""
        return sp.sympify(self.module) * self.teeth / 2 * sp.cos(self.pressure_angle)

    @property
    def roll(self) -> Any:
        """Angle by which the line of action has rolled off the base circle at the tip [rad]."""
        return sp.sqrt(((1 + 2 * sp.sympify(self.addendum) / self.teeth) / sp.cos(self.pressure_angle)) ** 2 - 1)

    @property
    def _half_base(self) -> Any:
        """Half the angle of a tooth on the base circle [rad]."""
        a = self.pressure_angle
        return sp.pi / (2 * self.teeth) - sp.sympify(self.thinning) / (self.module * self.teeth) + sp.tan(a) - a

    @property
    def half_tip(self) -> Any:
        """Half the angle of a tooth at its tip [rad]."""
        return self._half_base - self.roll + sp.atan(self.roll)

    def _flank(self, side: int) -> Curve:
        part = ROOT + (1 - ROOT) * (S if side < 0 else 1 - S)
        t, r = self.roll * part, self.base_radius
        a = t - self._half_base
        x, y = r * (sp.cos(a) + t * sp.sin(a)), r * (sp.sin(a) - t * sp.cos(a))
        name = f"{self.name}_{'right' if side < 0 else 'left'}"
        return Curve(name, x, -side * y, 0.0, 1.0, closed=False, repeats=self.teeth)

    @cached_property
    def right(self) -> Curve:
        """Flanks that look clockwise, from root to tip."""
        return self._flank(-1)

    @cached_property
    def left(self) -> Curve:
        """Flanks that look counterclockwise, from tip to root."""
        return self._flank(1)

    @cached_property
    def profile(self) -> SolidCurve:
        """All teeth, for pictures."""
        return Profile(self)


@dataclass(frozen=True)
class Profile(SolidCurve):
    """Outline of all teeth, for pictures: their flanks, joined by lines."""

    teeth: InvoluteTeeth
    closed = True
    hole = False

    @property
    def planar(self) -> PlanarCurve:
        """One flank, for equations."""
        return self.teeth.right.planar

    @property
    def drawn(self) -> Drawn:
        """Each flank, and its mirror image."""
        root = sp.sympify(self.teeth.module) * (self.teeth.teeth / sp.Integer(2) - DEDENDUM)
        return DrawnTeeth(self.planar, root, *self.planar.parameters)  # type: ignore[no-any-return]  # SymPy is untyped
