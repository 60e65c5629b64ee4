"""Planar curves as SymPy objects, and searches along them, which are never evaluated.

A generated module searches. It samples the curve once per run, starts from the samples and ends by Newton's method, anew
at every call: nothing is kept between calls that could be lost.
"""

from __future__ import annotations

from typing import Any, Self

import sympy as sp

from hertzwerk.derive.expressions.algebra.functions import NoText


class _OfData(sp.AtomicExpr):  # type: ignore[misc]  # SymPy is untyped
    """Common part of curves: a SymPy object that is the data named by its slots."""

    __slots__: tuple[str, ...] = ()

    def __new__(cls, **data: Any) -> Self:
        """Make one of all its data."""
        self = super().__new__(cls)
        for name in cls.__slots__:
            setattr(self, name, data[name])
        return self  # type: ignore[no-any-return]

    def _hashable_content(self) -> tuple[Any, ...]:
        return tuple(getattr(self, name) for name in self.__slots__)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), {name: getattr(self, name) for name in self.__slots__})

    def _sympystr(self, _: Any) -> str:
        return str(self.name)

    def _latex(self, _: Any) -> str:
        return rf"\mathrm{{{self.name}}}".replace("_", r"\,")


def _restored(kind: type[_OfData], data: dict[str, Any]) -> _OfData:
    return kind(**data)


class PlanarCurve(_OfData):
    """A curve x(s), y(s) with its data for a generated module.

    x, y, s  coordinates [m] as expressions of the parameter s
    parameters    symbols that they contain beside s
    start    least parameter, `end` the greatest
    closed   whether it ends where it starts, smoothly
    hole     whether the solid is to its right, not to its left
    tries    number of candidates compared: 1 for a convex curve, else 2
    repeats  number of its copies, turned about its place by equal parts of a turn
    at       parameters of the samples of one copy, from which the search starts
    """

    searched = ""
    __slots__ = ("at", "closed", "end", "hole", "name", "parameters", "repeats", "s", "start", "tries", "x", "y")

    @property
    def width(self) -> int:
        """Number of entries of what is computed once per run."""
        return 2 * len(self.at)

    @property
    def row(self) -> tuple[Any, ...]:
        """Data beside the expressions, as a module has them."""
        return (self.start, self.end), self.closed, self.hole, self.tries, self.repeats, self.at


class PlanarChain(_OfData):
    """A chain of circle arcs and lines with its data for a generated module.

    pieces  of each its start, its end and its centre (x, y) [m]; a line has its start for a centre
    turns   of each 1 for an arc to the left, -1 for one to the right, 0 for a line
    parameters    symbols that the pieces contain; closed, hole as of a `PlanarCurve`
    """

    __slots__ = ("closed", "hole", "name", "parameters", "pieces", "turns")
    searched = "_of_chain"

    @property
    def width(self) -> int:
        """Number of entries of what is computed once per run."""
        return 12 * len(self.turns)

    @property
    def row(self) -> tuple[Any, ...]:
        """Data beside the expressions, as a module has them."""
        return self.closed, self.hole, self.turns


class ChainPoints(_OfData):
    """Corners and arcs of a chain that another chain may touch.

    corners  numbers of the pieces that begin there; the end of an open chain has that of pieces
    arcs     numbers of convex arcs
    thick    half of how thick its solid is, relative to the sum of its pieces' lengths and radii
    """

    __slots__ = ("arcs", "corners", "name", "thick")

    @property
    def row(self) -> tuple[Any, ...]:
        """The data, as a module has them."""
        return self.corners, self.arcs, self.thick


class Place(_OfData):
    """Number of a place where curves with copies touch, by depth."""

    __slots__ = ("name", "row")


class Sampled(NoText):
    """`Sampled(curve, *parameters)`: what is computed of a curve once per run, such as samples: a vector."""


class Drawn(Sampled):
    """`Drawn(curve, *parameters)`: coordinates for a picture, first all x, then all y: a vector."""


class DrawnTeeth(Drawn):
    """`DrawnTeeth(flank, root, *parameters)`: the same of teeth, down to the radius of their root."""


class _Search(NoText):
    """Common part of searches along curves: readers see the curves and the place."""

    curves = 1

    def _latex(self, printer: Any) -> str:
        n = self.curves  # behind them as many samples, two numbers of a place for each, and parameters
        shown = ", ".join(map(printer.doprint, (*self.args[:n], *self.args[2 * n : 4 * n])))
        return rf"\operatorname{{{type(self).__name__.lower()}}}\left({shown}\right)"


class Nearest(_Search):
    """`Nearest(curve, samples, x, y, *parameters)`: where it is nearest to a point (x, y): a vector.

    Signed distance, normal there (two), curvature of the parallel curve through the point, parameter.
    """


class Support(_Search):
    """`Support(curve, samples, x, y, *parameters)`: where it is least along (x, y): a vector.

    Its point there (two), radius of curvature, parameter.
    """


class Between(_Search):
    """`Between(one, two, samples, samples, x, y, cos, sin, *parameters)`: where they are nearest.

    A vector. The place of the first is at (x, y) along the axes of the second's, and turned. Signed distance, normal out of the
    second (two), its point there (two), three coefficients of their motion, both parameters (`OnCurve.between`). Of two chains
    the last two are the `ChainPoints` of each, of copies the last may be a `Place`.
    """

    curves = 2


class Entry(NoText):
    """`Entry(vector, k)`: an entry of a symbol that stands for a vector."""

    nargs = 2

    def _eval_is_real(self) -> bool:
        return True

    def _sympystr(self, printer: Any) -> str:
        vector, k = self.args
        return f"{printer.doprint(vector)}[{k}]"

    def _latex(self, printer: Any) -> str:
        vector, k = self.args
        return rf"{printer.doprint(vector)}_{{{int(k) + 1}}}"
