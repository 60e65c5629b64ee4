"""Joint of a point in a track or slot along a planar curve."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import AXES, Frame, Point
from hertzwerk.derive.declare.mechanism.curve import SolidCurve, single_faults
from hertzwerk.derive.declare.mechanism.joints.conditions import Condition, OnTrack
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.outline import Outline
from hertzwerk.derive.expressions.algebra.vectors import apply
from hertzwerk.derive.expressions.parameter import Slot


@dataclass(frozen=True, init=False)
class PointInTrack(Joint):
    """Point of the child in a track, slot or groove along a curve fixed to the parent, in plane motion.

    The curve is in the plane of X and Y of the parent's point. Another joint carries the child, such as a `Planar`. The
    track holds the point to both sides, by `<name>.off_track.force`, and has no ends: that of an open curve is a fault of a run.
    """

    curve: SolidCurve
    carries: ClassVar[bool] = False
    symbol: ClassVar[str] = "track"

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, curve: SolidCurve) -> None:
        super().__init__(name, parent, child, curve=curve)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """No freedoms of its own: those of the joint that carries the child, less one."""
        return ()

    @property
    def curves(self) -> tuple[Any, ...]:
        """The curve."""
        return (self.curve,)

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the two points, and of the curve."""
        yield from super().slots()
        if isinstance(self.curve, SolidCurve):
            yield from self.curve.slots()

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a track with a corner, where a point that is held would have to stop."""
        yield from super().faults()
        yield from single_faults(f"joint {self.name}", self.curve)
        corner = self.curve.corner() if isinstance(self.curve, Outline) else None
        if corner is not None:
            yield Fault(f"joint {self.name}, curve {self.curve.name}", f"a corner at the end of its piece {corner}", "a smooth track",
                        "Round it by an Arc that both pieces touch.")  # fmt: skip

    def constraints(self) -> tuple[Condition, ...]:
        """One: the point is on the curve."""
        return (OnTrack(self.curve),)

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield the curve with its axes, and the point."""
        along, across, _ = (apply(self.parent.axes, axis.unit) for axis in AXES)
        yield "parent", self.parent, {"along": along, "across": across, "track": self.curve}
        yield "child", self.child, {}
