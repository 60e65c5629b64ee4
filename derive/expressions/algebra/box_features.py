"""Nearest features of two boxes as SymPy objects, which a generated module finds."""

from __future__ import annotations

from hertzwerk.derive.expressions.algebra.functions import NoText


class Stacked(NoText):
    """`Stacked(*values)`: a vector of these entries."""


class Features(NoText):
    """`Features(dimensions, slot, pose, *rates)`: how near certain features of two boxes are.

    Gap, penetration, normal (three) and point of the first from the second's middle (three), along the ground's axes; with
    a rate of the pose their rates, with two their second rates. The slots are those of `emit.box_helpers`.
    """
