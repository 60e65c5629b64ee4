"""Contact laws as records: one expression each, with the unit of every symbol, the range, the source and its grade.

Grades: A checked against an independent published number or an exact relation; B seen in a public source; C from general knowledge of
the literature; R reconstruction of an expression that could not be had.
Calling a law binds its parameters, in order or by name; a `Material` fills a pair (Young's modulus, Poisson's ratio).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.mechanism import Material, Slot
from hertzwerk.derive.parameter import Interval


class Quantity(sp.Symbol):  # type: ignore[misc]  # SymPy is untyped
    """A symbol of a law: name, unit text, meaning, and the range (SI) its value must keep."""

    __slots__ = ("limit", "meaning", "unit")

    def __new__(cls, name: str, unit: str, meaning: str, limit: Interval | None = None) -> Quantity:
        """A symbol of its own: never taken from SymPy's cache, so that equal names with other units stay apart."""
        self = sp.Symbol.__xnew__(cls, name, real=True)
        self.unit = unit
        self.meaning = meaning
        self.limit = limit
        return self  # type: ignore[no-any-return]

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, self.unit, self.meaning)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name, self.unit, self.meaning, self.limit), {}


# What a contact supplies to its laws.
d = Quantity("d", "m", "penetration")
v = Quantity("v", "m/s", "penetration rate")
v0 = Quantity("v0", "m/s", "approach speed, latched at the onset of the contact")
F = Quantity("F", "N", "elastic force of the stiffness law")
N = Quantity("N", "N", "normal force")
s = Quantity("s", "m/s", "sliding velocity")
R_eff = Quantity("R_eff", "m", "radius of relative curvature of the pair")
R_min = Quantity("R_min", "m", "smaller radius of the pair")

APPROACH_SPEED = v0
"""The one discrete memory of step 1: a law that names it has the speed of approach latched at the onset."""


@dataclass(frozen=True)
class Law:
    """What all laws share; `definitions` are named intermediate results (symbol, expression), in order."""

    name: str
    title: str
    parameters: tuple[Quantity, ...]
    source: str
    grade: str
    definitions: tuple[tuple[Quantity, sp.Expr], ...] = ()
    kind: ClassVar[str]

    def __call__(self, *values: Any, **named: Any) -> BoundLaw:
        """Bind the parameters; raises TypeError if their number or names do not fit."""
        given: list[Any] = []
        for value in values:
            given.extend((value.youngs_modulus, value.poissons_ratio) if isinstance(value, Material) else (value,))
        names = [parameter.name for parameter in self.parameters]
        unknown = [name for name in named if name not in names[len(given) :]]
        missing = [name for name in names[len(given) :] if name not in named]
        if len(given) > len(names) or unknown or missing:
            raise TypeError(
                f"law {self.name} takes {', '.join(names)}; missing {missing}, not expected {unknown or given[len(names) :]}"
            )
        given += [named[name] for name in names[len(given) :]]
        return BoundLaw(self, tuple(_exact(value) for value in given))

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """What the law computes: (what it is, expression, unit it must have)."""
        raise NotImplementedError


@dataclass(frozen=True)
class StiffnessLaw(Law):
    """Elastic normal force F(d) [N] and the energy it stores [J]; `exponent` n where F = K d^n; `reach` [m], the penetration it is defined up to."""

    force: sp.Expr = sp.S.Zero
    stored: sp.Expr = sp.S.Zero
    exponent: sp.Expr | None = None
    reach: sp.Expr | None = None
    kind = "stiffness"

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """The elastic force, then the stored energy."""
        yield "normal force", self.force, "N"
        yield "stored energy", self.stored, "J"
        if self.reach is not None:
            yield "reach", self.reach, "m"


@dataclass(frozen=True)
class DampingLaw(Law):
    """Hysteresis damping: resistance F h v/v0 [N] beside the elastic force F, h = `factor` of the restitution e."""

    factor: sp.Expr = sp.S.Zero
    defined: Interval = field(default_factory=Interval)
    recommended: Interval | None = None
    memory: tuple[Quantity, ...] = ()
    kind = "damping"

    @property
    def resistance(self) -> sp.Expr:
        """Dissipative part of the normal force."""
        return F * self.factor * v / v0

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """The resistance."""
        yield "damping force", self.resistance, "N"


@dataclass(frozen=True)
class FrictionLaw(Law):
    """Friction force [N] opposing the sliding velocity s, an odd function of s; `slope` is its derivative at s = 0 [N s/m]."""

    force: sp.Expr = sp.S.Zero
    slope: sp.Expr = sp.S.Zero
    kind = "friction"

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """The friction force and its slope at rest."""
        yield "friction force", self.force, "N"
        yield "slope of the friction force at rest", self.slope, "N s/m"


def _exact(value: Any) -> Any:
    """Numbers as exact rationals (1.5 -> 3/2), so that exponents compare exactly."""
    if isinstance(value, float) and value == value and abs(value) != float("inf"):
        fraction = Fraction(value).limit_denominator(10_000)
        near = abs(float(fraction) - value) <= 1e-15 * max(1.0, abs(value))
        return sp.Rational(fraction.numerator, fraction.denominator) if near else sp.Float(value)
    return sp.sympify(value) if isinstance(value, (int, sp.Basic)) else value


@dataclass(frozen=True)
class BoundLaw:
    """A law with its parameters given: parameters of a scene, expressions of them, or numbers."""

    law: Any
    values: tuple[Any, ...]

    @property
    def binding(self) -> dict[sp.Symbol, Any]:
        """Law symbol -> what is given for it."""
        return dict(zip(self.law.parameters, self.values, strict=True))

    def slots(self, where: str) -> Iterator[Slot]:
        """The quantities given to the law."""
        for symbol, value in self.binding.items():
            limit = symbol.limit
            recommended = None
            if isinstance(self.law, DampingLaw):
                limit, recommended = self.law.defined, self.law.recommended
            yield Slot(f"{where}, {symbol.meaning} of {self.law.name}", value, symbol.unit, limit, recommended)
