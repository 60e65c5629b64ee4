"""The cubic through values and slopes at both ends of a step: where it is largest."""

from __future__ import annotations

from typing import Any


def crest_of_cubic(of: Any, start: Any, end: Any, rising: Any, falling: Any) -> tuple[Any, Any, Any]:
    """Return the part of a step at which a cubic peaks, its value there, and the part at which it bends.

    of    numpy or casadi, whose numbers the others are
    start, end, rising, falling    values and slopes at both ends, the latter times the step

    The maximum lies in the step where the slopes are of opposite signs, and may lie there where they are of one; elsewhere
    the part is outside 0 to 1, not a number, or one at which the cubic is not above both ends.
    """
    square, cube = 3 * (end - start) - 2 * rising - falling, 2 * (start - end) + rising + falling
    place = rising / (of.sqrt(of.fmax(square * square - 3 * cube * rising, 0)) - square)
    return place, start + place * (rising + place * (square + place * cube)), -square / (3 * cube)
