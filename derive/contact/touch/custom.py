"""Contact geometry of user-defined surfaces."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from hertzwerk.derive.algebra.vectors import Vector, add, apply, multiply, transpose
from hertzwerk.derive.contact.touch.touch import Touch, touch
from hertzwerk.derive.effects.expression import as_choice
from hertzwerk.derive.mechanism.pairs.custom import APART, TURN, CustomPair


@touch.register(CustomPair)
class Custom(Touch):
    """User-defined surfaces."""

    @cached_property
    def _pose(self) -> dict[Any, Any]:
        """The user's pose symbols on the tape."""
        back = transpose(self.kin.axes_of(self.second))
        apart = self.named(apply(back, self.apart), "local_apart")
        turn = self.tape.matrix(multiply(back, self.kin.axes_of(self.first)), f"{self.pair.name}_turn")
        rows = zip(TURN, turn, strict=True)
        return dict(zip(APART, apart, strict=True)) | {s: v for row in rows for s, v in zip(*row, strict=True)}

    def _stated(self, value: Any) -> Any:
        return as_choice(value).xreplace(self._pose)

    def _in_ground(self, components: Any, what: str) -> Vector:
        x, y, z = (self._stated(value) for value in components)
        local = self.named((x, y, z), f"local_{what}")
        return self.named(apply(self.kin.axes_of(self.second), local), what)

    @cached_property
    def gap(self) -> Any:
        """Gap as declared."""
        return self.let(self._stated(self.pair.gap), "gap")

    @cached_property
    def normal(self) -> Vector:
        """Normal as declared."""
        return self._in_ground(self.pair.normal, "normal")

    @cached_property
    def position(self) -> Vector:
        """The contact point."""
        return add(self.base, self._in_ground(self.pair.contact_point, "contact_arm"))
