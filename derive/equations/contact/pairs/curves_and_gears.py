"""Pairs of two planar curves and of two gears, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.declare.mechanism.curve import Curve, SolidCurve
from hertzwerk.derive.declare.mechanism.outline import Outline
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.declare.mechanism.teeth import InvoluteTeeth
from hertzwerk.derive.equations.contact.pairs.on_curve import CurveTouch, OnSolidCurve, outline
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.curve_frame import Meeting, Pose
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.planar_curve import Place
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, dot, sub
from hertzwerk.derive.expressions.parameter import Scalar, Slot, is_number


@dataclass(frozen=True)
class CurveOnCurve(OnSolidCurve):
    """Solid beside a curve that may touch the solid beside another, as flanks of teeth, in plane motion.

    Each curve is fixed to its place, two curves or two outlines. They touch in one point, the deepest of those that are compared,
    where curves penetrate no more than their samples are apart, outlines half of how thick they are. An end touches as a
    corner. Outlines that may touch in several points at a time are an `OutlineOnOutline`.
    """

    first_curve: SolidCurve
    first: Point
    second_curve: SolidCurve
    second: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "curve_on_curve"

    @property
    def curves(self) -> tuple[Any, ...]:
        """Both curves."""
        return self.first_curve, self.second_curve

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Axes and points of both curves, for landmarks."""
        return outline(self.first, self.first_curve), outline(self.second, self.second_curve)

    @property
    def tips(self) -> tuple[Sequence[Any], Sequence[Any]]:
        """Tips of both outlines by which they touch, by default all."""
        return tuple(curve.tips if isinstance(curve, Outline) else () for curve in self.curves)  # type: ignore[return-value]

    @property
    def points(self) -> list[Any]:
        """Points of outlines by which they touch, for equations."""
        chains = zip(self.curves, self.tips, strict=True)
        return [curve.points(tips) for curve, tips in chains if isinstance(curve, Outline)]

    def faults(self) -> Iterator[Fault]:
        """Yield faults of curves that cannot touch each other from outside, and of a curve on an outline."""
        if {type(curve) for curve in self.curves} == {Curve, Outline}:
            yield Fault(f"pair {self.name}, curves", "a curve and an outline", "two curves, or two outlines",
                        "An Outline is also touched by circles, points and faces; a circle is an Outline of one Arc.")  # fmt: skip
        yield from hole_faults(self)

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return BetweenCurves(self, kinematics)


class BetweenCurves(CurveTouch):
    """Curve beside a curve."""

    curve_of: ClassVar[str] = "second_curve"

    @cached_property
    def _meeting(self) -> Meeting:
        axes = self.kin.axes_of(self.first)
        cos, sin, _ = self._on.local(tuple(row[0] for row in axes), "turned")
        w = sub(*(self.kin.angular_velocity(place.body) for place in (self.first, self.second)))
        turning = self.let(dot(w, tuple(row[2] for row in self._on.axes)), "relative_turning")
        x, y, _ = self._local
        return self._on.between(self.pair.first_curve.planar, Pose(x, y, cos, sin, turning), self.pair.points)

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield also the fault of a first curve whose Z is not the second's."""
        faults = list(super().faults(length))
        yield from faults
        axes = self.kin.axes_of(self.first)
        z = self._on.local(tuple(row[2] for row in axes), "first_z")
        if not faults and z[2] != 1:
            yield Fault(f"pair {self.pair.name}", f"a Z of the first curve's place of {z[2]} along the second's", "the same Z, 1",
                        "Turn the first place: body.at(...).turned(axis, angle); a mirrored curve is another curve.")  # fmt: skip

    @cached_property
    def gap(self) -> Any:
        """Distance of the curves [m]."""
        return self.let(self._meeting.distance, "gap")

    @cached_property
    def normal(self) -> Vector:
        """Normal of the second curve where it is nearest."""
        return self._on.ground(*self._meeting.normal, "normal")

    @cached_property
    def position(self) -> Vector:
        """Point of contact on the second curve."""
        return self.named(add(self.base, self._on.ground(*self._meeting.point, "foot")), "contact")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Gap, and the parameters of both curves where they are nearest."""
        names = zip(("first", "second"), self._meeting.parameters, strict=True)
        return [*super().outputs(), *((f"{self.pair.name}.{which}_parameter", "1", s) for which, s in names)]


@dataclass(frozen=True)
class OutlineOnOutline(OnSolidCurve):
    """Two outlines that may touch in several points at a time, in plane motion.

    It is a pair for each convex corner and each rounded one of either, NAME_1 of the first outline's first: that is pushed
    where it is deepest within the other. What acts at NAME acts at all. Where two corners meet both are pushed.
    """

    first_outline: Outline
    first: Point
    second_outline: Outline
    second: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "outline_on_outline"

    @property
    def curves(self) -> tuple[Any, ...]:
        """Both outlines."""
        return self.first_outline, self.second_outline

    @property
    def parts(self) -> tuple[Pair, ...]:
        """A pair for each tip; itself where an outline has faults, which the scene finds."""
        if any(self.faults()) or not all(curve.sound for curve in self.curves):
            return (self,)
        one, two = self.curves
        tips = [((tip,), ()) for tip in one.tips] + [((), (tip,)) for tip in two.tips]
        arguments = one, self.first, two, self.second, self.curvature_radius, self.length
        return tuple(
            TipOnOutline(f"{self.name}_{k}", *arguments, whole=self.name, tips=tip) for k, tip in enumerate(tips, 1)
        )

    def faults(self) -> Iterator[Fault]:
        """Yield faults of what is no outline, and of two holes."""
        for which, curve in zip(("first", "second"), self.curves, strict=True):
            if not isinstance(curve, Outline):
                yield Fault(f"pair {self.name}, {which} outline", f"{curve!r:.80}", "an Outline(name, start, pieces)")
        yield from hole_faults(self)


@dataclass(frozen=True)
class TipOnOutline(CurveOnCurve):
    """Corner or rounded corner of an outline beside another, a part of an `OutlineOnOutline`."""

    whole: str = ""
    tips: tuple[Sequence[Any], Sequence[Any]] = ((), ())


def hole_faults(pair: OnSolidCurve) -> Iterator[Fault]:
    """Yield the fault of two holes."""
    if all(getattr(curve, "hole", False) is True for curve in pair.curves):
        yield Fault(
            f"pair {pair.name}, curves", "two holes", "at least one solid that is within the other's hole or beside it"
        )


@dataclass(frozen=True)
class GearMesh(Pair):
    """Two external spur gears that mesh with backlash, in plane motion.

    It is two pairs: NAME_1 of the left flanks, by which the first gear drives the second as it turns counterclockwise, and
    NAME_2 of the right ones. What acts at NAME acts at all. One place of contact carries each: the force of all teeth, along
    their common line of action. With `sharing=True` each pair of teeth carries its own, two of a side at most: NAME_3 and
    NAME_4 are the second deepest of left and right flanks, so that the mesh is twice as stiff where two pairs touch.
    """

    first_teeth: InvoluteTeeth
    first: Point
    second_teeth: InvoluteTeeth
    second: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    sharing: bool = False

    @property
    def parts(self) -> tuple[Pair, ...]:
        """Both pairs of flanks; the mesh itself where they cannot be made, a fault the scene finds."""
        one, two = self.first_teeth, self.second_teeth
        if any(self.faults()):
            return (self,)
        sides = (one.left, two.left), (one.right, two.right)
        arguments = self.curvature_radius, self.length
        return tuple(
            Flanks(f"{self.name}_{2 * row + k}", a, self.first, b, self.second, *arguments, whole=self, row=row)
            for row in range(1 + self.sharing)
            for k, (a, b) in enumerate(sides, 1)
        )

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of both gears' teeth."""
        if not isinstance(self.sharing, bool):
            yield Fault(f"pair {self.name}, sharing", repr(self.sharing), "True or False")
        for which, teeth in (("first", self.first_teeth), ("second", self.second_teeth)):
            if not isinstance(teeth, InvoluteTeeth):
                yield Fault(
                    f"pair {self.name}, {which} teeth", f"{teeth!r:.80}", "an InvoluteTeeth(name, module, teeth, ...)"
                )
            elif not all(is_number(slot.value) for slot in teeth.slots()):
                yield from (
                    Fault(slot.where, f"{slot.value!r:.80}", "a quantity")
                    for slot in teeth.slots()
                    if not is_number(slot.value)
                )
            else:
                yield from teeth.faults()


@dataclass(frozen=True)
class Flanks(CurveOnCurve):
    """Flanks of two gears that mesh."""

    whole: GearMesh | None = None
    row: int = 0

    @property
    def points(self) -> list[Any]:
        """Which pair of teeth, by depth, for equations."""
        return [Place(name="place", row=self.row + 1)] if self.row else []

    @property
    def _teeth(self) -> tuple[InvoluteTeeth, ...]:
        return () if self.whole is None else (self.whole.first_teeth, self.whole.second_teeth)

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the teeth, then of the flanks."""
        for teeth in self._teeth:
            yield from teeth.slots()
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Axes and profiles of both gears, for landmarks."""
        one, two = (outline(p, t.profile) for p, t in zip((self.first, self.second), self._teeth, strict=True))
        return one, two
