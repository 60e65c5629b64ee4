"""Symbols of the pose of one body against another, which user-defined surfaces are expressed by."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.expressions.algebra.tagged import Tagged
from hertzwerk.derive.expressions.parameter import Slot


class PoseSymbol(Tagged):
    """Coordinate of a pair's first place, or of its axes, in the axes of the second."""

    __slots__ = ("unit",)
    tags = ("unit",)


APART = tuple(PoseSymbol(f"apart_{k}", "m") for k in "xyz")
"""Vector from the second place to the first, along the axes of the second [m]."""
TURN = tuple(tuple(PoseSymbol(f"turn_{i}{k}", "1") for k in "xyz") for i in "xyz")
"""Rotation from the axes of the first place to those of the second: its columns are the first's axes."""

ROTATION = tuple(PoseSymbol(f"rotation_{k}", "rad") for k in "xyz")
"""Rotation vector of the first frame against the second, axis times angle, along the second's axes [rad]; of frames."""


@dataclass(frozen=True)
class Posed(Slot):
    """Quantity that may vary with the pose of one body against another: `APART`, `TURN`.

    symbols  those it may contain beside parameters, `words` their names in messages; `tables` whether it may contain tables
    """

    symbols: ClassVar[tuple[Any, ...]] = (*APART, *(symbol for row in TURN for symbol in row))
    words: ClassVar[str] = "APART, TURN"
    tables: ClassVar[bool] = False


@dataclass(frozen=True)
class PosedFrames(Posed):
    """Quantity that may vary with the pose of one frame against another: `APART`, `ROTATION`, `TURN`."""

    symbols: ClassVar[tuple[Any, ...]] = (*Posed.symbols, *ROTATION)
    words: ClassVar[str] = "APART, ROTATION, TURN"
