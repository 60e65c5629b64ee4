"""Sectors of a circle as SymPy objects: shares of a direction in them, and means by these shares."""

from __future__ import annotations

from typing import Any

from hertzwerk.derive.expressions.algebra.functions import NoText


class Shares(NoText):
    """`Shares(n, order, x, y)`: shares of n sectors in the direction (x, y), a vector.

    They are not negative, and their sum is 1; with the order 1 or 2 their derivatives by the direction's angle. The
    function is that of `emit.sector_helpers`.
    """

    nargs = 4


class Share(NoText):
    """`Share(shares, k)`: the share of one sector, a pure number."""

    nargs = 2


class Mean(NoText):
    """`Mean(shares, *values)`: sum of the shares times the values of their sectors."""

    def _eval_is_real(self) -> bool:
        return True

    def _latex(self, printer: Any) -> str:
        shares, first, *_ = map(printer.doprint, self.args)
        last = printer.doprint(self.args[-1])
        row = rf"\left({first}, \dots, {last}\right)" if len(self.args) > 2 else first
        return rf"{shares} \cdot {row}"
