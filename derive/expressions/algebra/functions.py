"""Branch function `Where`, differentiable without distributions."""

from __future__ import annotations

from functools import reduce
from typing import Any

import sympy
from sympy.logic.boolalg import Boolean


class NoText(sympy.Function):  # type: ignore[misc]  # SymPy is untyped
    """A function that rejects text as an argument, which SymPy would execute."""

    def __new__(cls, *args: Any, **options: Any) -> Any:
        """Check the arguments; raises TypeError for text."""
        for arg in args:
            if isinstance(arg, str):
                raise TypeError(f"{cls.__name__}: found the text {arg!r}, expected an expression")
        return super().__new__(cls, *args, **options)


class Where(NoText):
    """`Where(condition, a, b)`: a where the condition holds, else b. Evaluated where that is known.

    The derivative is that of the branch taken, as a simulation needs that locates the kink as an event. SymPy's
    Piecewise, Max and Heaviside would rewrite themselves or bring in DiracDelta instead.
    """

    nargs = 3

    @classmethod
    def eval(cls, condition: Any, a: Any, b: Any) -> Any:
        """Return the branch of a condition that is true or false. Raises TypeError for what is no condition."""
        if not isinstance(condition, Boolean) or isinstance(condition, sympy.Expr):
            raise TypeError(f"Where: found the condition {condition}, expected a comparison such as d > 0")
        return a if condition == sympy.true else b if condition == sympy.false else None

    def fdiff(self, argindex: int = 2) -> Any:
        """Partial derivative with respect to a (2) or b (3)."""
        if argindex not in (2, 3):
            raise sympy.ArgumentIndexError(self, argindex)
        return Where(self.args[0], int(argindex == 2), int(argindex == 3))

    def _eval_derivative(self, symbol: Any) -> Any:
        condition, a, b = self.args
        da, db = a.diff(symbol), b.diff(symbol)
        return sympy.S.Zero if da == 0 and db == 0 else Where(condition, da, db)

    def _eval_is_real(self) -> bool | None:
        _, a, b = self.args
        return True if a.is_real and b.is_real else None

    def doit(self, **hints: Any) -> Any:
        """The same of conditions and branches that are evaluated themselves."""
        return Where(*(arg.doit(**hints) for arg in self.args))


def slope(expression: Any, symbol: Any) -> Any:
    """Derivative by a symbol, of Max and Min by branches: SymPy's own has steps, which no rule emits."""
    return (
        expression.replace(sympy.Max, lambda *of: reduce(lambda a, b: Where(a > b, a, b), of))
        .replace(sympy.Min, lambda *of: reduce(lambda a, b: Where(a < b, a, b), of))
        .diff(symbol)
    )


def with_pieces(expression: Any) -> Any:
    """Write branches as SymPy's Piecewise: for texts, never to be differentiated."""
    if not expression.has(Where):
        return expression
    return expression.replace(Where, lambda condition, a, b: sympy.Piecewise((a, condition), (b, True)))
