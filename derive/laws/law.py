"""Records of contact laws: expressions, units and ranges of their symbols, source and its grade.

Grades: A checked against an independent published number or an exact relation; B seen in a public source; C from
general knowledge of the literature; R reconstruction of an expression that was not accessible.

Calling a law binds its parameters, in order or by name; a `Material` fills a pair (Young's modulus, Poisson's ratio).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, fields
from fractions import Fraction
from functools import cached_property
from inspect import Parameter as Argument
from inspect import Signature
from itertools import pairwise
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.markup import Markup, heading, joined, table, tag
from hertzwerk.derive.common.mathml import inline, lines_of
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.notation import latex_name, latex_of, text_of
from hertzwerk.derive.expressions.algebra.tagged import Tagged
from hertzwerk.derive.expressions.parameter import POSITIVE, Interval, Parameter, Slot
from hertzwerk.derive.laws.material import Material


class Quantity(Tagged):
    """A symbol of a law: name, unit text, meaning, and the range (SI) its value must keep."""

    __slots__ = ("limit", "meaning", "unit")
    tags = ("unit", "meaning", "limit")

    def __new__(cls, name: str, unit: str, meaning: str, limit: Interval | None = None) -> Quantity:
        """Make a new symbol."""
        return super().__new__(cls, name, unit, meaning, limit)


# Supplied by a contact while it lasts.
d = Quantity("d", "m", "penetration")
v = Quantity("v", "m/s", "penetration rate")
v0 = Quantity("v0", "m/s", "approach speed, latched at the onset of the contact")
F = Quantity("F", "N", "elastic force of the stiffness law")
k_t = Quantity("k_t", "N/m", "tangent stiffness dF/dd of the stiffness law")
N = Quantity("N", "N", "normal force")
s = Quantity("s", "m/s", "sliding velocity")
z = Quantity("z", "m", "bristle deflection")
d_m = Quantity("d_m", "m", "largest penetration of the contact")
d_r = Quantity("d_r", "m", "dent, the penetration at which the contact is unloaded")
h_m = Quantity("h_m", "m", "depth that unloading recovers, d_m - d_r")
F_m = Quantity("F_m", "N", "force of loading at the largest penetration")
eps_w = Quantity("epsilon_w", "1", "eccentricity over clearance, along the squeeze velocity")
eps_c = Quantity("epsilon_c", "1", "eccentricity over clearance, across it, a quarter turn on about the axis")
h = Quantity("h", "m", "thickness of the film between a sphere and what it nears")
STATE = (d, v, v0, F, k_t, N, s, z, d_m, d_r, h_m, F_m, eps_w, eps_c, h)

# Supplied by a pair, once per run.
R_eff = Quantity("R_eff", "m", "radius of relative curvature of the pair", POSITIVE)
R_min = Quantity("R_min", "m", "smaller radius of the pair", POSITIVE)
R_1 = Quantity("R_1", "m", "radius of the bush, or of the first body", POSITIVE)
R_2 = Quantity("R_2", "m", "radius of the pin, or of the second body", POSITIVE)
dR = Quantity("dR", "m", "R1 - R2 inside (the clearance), R1 + R2 outside", POSITIVE)
L = Quantity("L", "m", "axial length of the contact", POSITIVE)
m_eff = Quantity("m_eff", "kg", "effective mass m1 m2/(m1 + m2)", POSITIVE)
GEOMETRY = (R_eff, R_min, R_1, R_2, dR, L, m_eff)

GRADES = {
    "A": "checked against an independent published number or an exact relation",
    "B": "seen in a public source",
    "C": "from general knowledge of the literature, not checked again",
    "R": "reconstruction: the expression of the paper was not available",
}
"""How well what a law states is known."""

FORMS = ("point", "line", "surface")
"""Forms of contact: the region in which two surfaces touch."""

BRISTLE = z
"""Continuous memory: for a law that contains it the deflection is integrated during a contact, and reset to zero when it ends."""

YIELD_STRENGTH = "sigma_y"
"""Name of the parameter that a material supplies from its yield strength; of two the lower one."""

APPROACH_SPEED = v0
"""Discrete memory: for a law that contains it the approach speed is latched at the onset of a contact."""


@dataclass(frozen=True)
class Range:
    """Range of validity of a law, bounds in SI.

    A value outside a "defined" range is an error, outside a "recommended" one a warning.
    """

    quantity: Quantity
    interval: Interval
    kind: str


@dataclass(frozen=True)
class Law:
    """Fields common to all contact laws.

    `definitions` are named intermediate results (symbol, expression), in order. `verdict` is the catalogue's
    statement on the units of the law as published, which the audit must reproduce: consistent, inconsistent, or
    outside_si (inconsistent, but `fitted_in` names the units of the fit). `repair` names a consistent law to use
    instead, where there is one. `defaults` are parameters with values of the law's own, such as the reference length
    of a fit. `forms` are the forms of contact it holds for; `pairs` the kinds of pair, where it does not hold for all
    that have its geometry.
    """

    name: str
    title: str
    parameters: tuple[Quantity, ...]
    source: str
    grade: str
    definitions: tuple[tuple[Quantity, sp.Expr], ...] = ()
    ranges: tuple[Range, ...] = ()
    verdict: str = "consistent"
    fitted_in: str = ""
    repair: str = ""
    note: str = ""
    defaults: tuple[tuple[Quantity, Parameter], ...] = ()
    forms: tuple[str, ...] = ()
    pairs: tuple[str, ...] = ()
    kind: ClassVar[str]

    def __post_init__(self) -> None:
        """Check the forms of contact; raises ValueError."""
        if not self.forms or not set(self.forms) <= set(FORMS):
            actual = f"the forms of contact {self.forms!r}" if self.forms else "no form of contact"
            raise ValueError(
                f"law {self.name}: found {actual}, expected some of {FORMS}; FORMS itself where it is for all of them"
            )
        object.__setattr__(self, "__doc__", "\n".join(self._documentation()))
        with suppress(ValueError):  # names that are none, or stand twice: the scene that uses the law tells them
            object.__setattr__(self, "__signature__", self._signature())

    def _repr_html_(self) -> str:
        return law_html(self)

    def _documentation(self) -> Iterator[str]:
        """Yield the lines of a law's `help`."""
        names = ", ".join(symbol.name for symbol in self.parameters)
        yield from (f"{self.name}({names}): {self.title} ({self.kind} law, grade {self.grade}).", "")
        yield from (f"{symbol.name} [{symbol.unit}]: {symbol.meaning}" for symbol in self.parameters)
        yield f"Source: {self.source}"
        yield from filter(None, [self.note])

    def _signature(self) -> Signature:
        """Signature of a call, for `inspect` and completion."""
        values = dict(self.defaults)
        return Signature(
            [
                Argument(symbol.name, Argument.POSITIONAL_OR_KEYWORD, default=values.get(symbol, Argument.empty))
                for symbol in self.parameters
            ],
            return_annotation=BoundLaw,
        )

    def __call__(self, *values: Any, **named: Any) -> BoundLaw:
        """Bind the parameters; raises TypeError if their number or names do not fit."""
        arguments: list[Any] = []
        for value in values:
            arguments.extend((value.youngs_modulus, value.poissons_ratio) if isinstance(value, Material) else (value,))
        names = [parameter.name for parameter in self.parameters]
        unknown = [name for name in named if name not in names[len(arguments) :]]
        named = {
            symbol.name: value for symbol, value in self.defaults if symbol.name in names[len(arguments) :]
        } | named
        materials = tuple(value for value in values if isinstance(value, Material))
        softest = [material.yield_strength for material in materials if material.yield_strength is not None]
        if softest and YIELD_STRENGTH in names[len(arguments) :]:
            named = {YIELD_STRENGTH: sp.Min(*softest)} | named
        missing = [name for name in names[len(arguments) :] if name not in named]
        if len(arguments) > len(names) or unknown or missing:
            wrong = [f"missing {', '.join(missing)}"] if missing else []
            wrong += ["no material has a yield_strength"] if materials and YIELD_STRENGTH in missing else []
            wrong += [f"not expected {', '.join(unknown)}"] if unknown else []
            wrong += [f"{len(arguments)} values for {len(names)}"] if len(arguments) > len(names) else []
            raise TypeError(f"law {self.name} takes ({', '.join(names)}): {'; '.join(wrong)}")
        arguments += [named[name] for name in names[len(arguments) :]]
        return BoundLaw(self, tuple(_exact(value) for value in arguments), materials)

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield (description, expression, required unit) of everything the law computes."""
        raise NotImplementedError

    @property
    def forces(self) -> tuple[sp.Expr, ...]:
        """The expressions that are evaluated at every step."""
        raise NotImplementedError

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """Every symbol of the law's expressions and definitions, in order of appearance."""
        texts = [*(e for _, e in self.definitions), *(e for _, e, _ in self.expressions())]
        quantities = (node for text in texts for node in sp.preorder_traversal(text) if isinstance(node, Quantity))
        return tuple(dict.fromkeys(quantities))

    def symbols(self) -> tuple[Quantity, ...]:
        """List the parameters, the defined symbols, and all other symbols of the expressions."""
        return tuple(dict.fromkeys((*self.parameters, *(symbol for symbol, _ in self.definitions), *self.quantities)))

    @cached_property
    def geometry(self) -> tuple[Quantity, ...]:
        """Geometric quantities the law reads from its pair."""
        own = {*self.parameters, *(symbol for symbol, _ in self.definitions)}
        symbols = {*self.quantities, *(row.quantity for row in self.ranges)} - own
        return tuple(quantity for quantity in GEOMETRY if quantity in symbols)


@dataclass(frozen=True)
class StiffnessLaw(Law):
    """Elastic normal force F(d) [N].

    `stored` is its integral [J]; None has it integrated by Gaussian quadrature. `exponent` is the n of K d^n. `reach`
    [m] is the penetration up to which the law is defined: beyond it a run ends with `outside_law_range`. `relation`
    is d(F) [m] as published, where `force` is its inverse.
    """

    force: sp.Expr = sp.S.Zero
    relation: sp.Expr | None = None
    stored: sp.Expr | None = None
    exponent: sp.Expr | None = None
    reach: sp.Expr | None = None
    kind = "stiffness"

    def __post_init__(self) -> None:
        """Check that no definition depends on d; raises ValueError.

        Definitions are computed once per run; `work` and the tangent stiffness differentiate the force alone.
        """
        super().__post_init__()
        if any(expression.has(d) for _, expression in self.definitions):
            raise ValueError(f"law {self.name}: a definition depends on the penetration; write it out in the force")

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield the published relation d(F), the elastic force, stored energy and reach, as far as given."""
        if self.relation is not None:
            yield "penetration", self.relation, "m"
        yield "normal force", self.force, "N"
        if self.stored is not None:
            yield "stored energy", self.stored, "J"
        if self.reach is not None:
            yield "reach", self.reach, "m"

    @property
    def forces(self) -> tuple[sp.Expr, ...]:
        """The elastic force."""
        return (self.force,)

    @property
    def work(self) -> sp.Expr:
        """Stored energy [J]: as given, else by Gaussian quadrature.

        16 points in sqrt(d), exact for d^(k/2), k < 31.
        """
        if self.stored is not None:
            return self.stored
        terms = [weight * 2 * node * self.force.xreplace({d: d * node**2}) for node, weight in gauss_legendre(16)]
        return d * sp.Add(*terms)


_HERTZ = sp.Rational(3, 2)  # exponent of his law


@dataclass(frozen=True)
class PlasticLaw(StiffnessLaw):
    """Elastic-plastic normal force, with the largest penetration as memory: `force` is that of loading.

    It is `elastic`, Hertz's, up to `onset` [m], first yield, then by `stages` [N]: each takes over from the one before where it is
    less. From a largest penetration d_m beyond first yield the force is

        F_m ((d - d_r)/h_m)^steepness,   F_m = force and d_r = dent at d_m, h_m = d_m - d_r,

    at every smaller penetration d, in both directions: elastic unloading down to `dent` [m], the depth that stays. It and
    `steepness` are given as functions of d, which is d_m there.
    """

    force: sp.Expr = field(init=False)
    elastic: sp.Expr = sp.S.Zero
    onset: sp.Expr = sp.S.Zero
    stages: tuple[sp.Expr, ...] = ()
    dent: sp.Expr = sp.S.Zero
    steepness: sp.Expr = _HERTZ

    def __post_init__(self) -> None:
        """Compose the force of loading; raises ValueError as for every stiffness law."""
        loading = self.stages[0]
        for before, after in pairwise(self.stages):
            loading = Where(after < before, after, loading)
        object.__setattr__(self, "force", Where(d <= self.onset, self.elastic, loading))
        super().__post_init__()

    @property
    def loading(self) -> StiffnessLaw:
        """Elastic law with the force of loading, which a first contact has up to its largest penetration."""
        own = {field.name: getattr(self, field.name) for field in fields(StiffnessLaw)}
        return StiffnessLaw(**own)

    @property
    def kinks(self) -> tuple[sp.Expr, ...]:
        """Where each stage takes over from the one before: expressions of d [1] that fall through zero there."""
        return tuple(after / before - 1 for before, after in pairwise(self.stages))

    @property
    def returned(self) -> tuple[sp.Expr, ...]:
        """Energy [J] that unloading from a penetration d returns, before first yield and in each stage."""
        beyond = (force * (d - self.dent) / (self.steepness + 1) for force in self.stages)
        return self.elastic * d / (_HERTZ + 1), *beyond

    @property
    def unloading(self) -> sp.Expr:
        """Force [N] at a penetration d from a largest penetration d_m beyond first yield."""
        return F_m * ((d - d_r) / h_m) ** self.steepness.xreplace({d: d_m})

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield the loading force, then first yield, dent and unloading force from the largest penetration."""
        yield from super().expressions()
        yield "depth of first yield", self.onset, "m"
        yield "dent", self.dent.xreplace({d: d_m}), "m"
        yield "unloading force", self.unloading, "N"


@dataclass(frozen=True)
class DampingLaw(Law):
    """Dissipative part of the normal force, added to the elastic force F.

    It is F h v/v0 with h = `factor`, a function of the restitution e, or another `term` [N].

    `exponent` is the m of chi d^m v, None where it is the stiffness law's n. `release`: "force" ends the contact
    where the normal force falls to zero, "gap" where the gap opens, so that the law may pull before. `at_one` and
    `at_zero` are the limits of h, or of the coefficient in its place, as e goes to 1 (0 is the elastic law) and to 0
    (oo is infinite damping); None for a law without e.
    """

    factor: sp.Expr | None = None
    term: sp.Expr | None = None
    defined: Interval | None = None
    recommended: Interval | None = None
    memory: tuple[Quantity, ...] = ()
    exponent: sp.Expr | None = None
    release: str = "force"
    at_one: sp.Expr | None = None
    at_zero: sp.Expr | None = None
    forms: tuple[str, ...] = FORMS  # added to an elastic law of any form
    kind = "damping"

    @property
    def resistance(self) -> sp.Expr:
        """Dissipative part of the normal force [N]."""
        return F * self.factor * v / v0 if self.term is None else self.term

    @property
    def forces(self) -> tuple[sp.Expr, ...]:
        """The damping force."""
        return (self.resistance,)

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield the damping force."""
        yield "damping force", self.resistance, "N"


@dataclass(frozen=True)
class FrictionLaw(Law):
    """Friction force [N] opposing the sliding velocity s, an odd function of s.

    `slope` is its derivative at s = 0 [N s/m]. A set-valued law has `modes`: `force` is then the sliding friction, a
    function of N times sign(s), and `holding` [N] the greatest static friction. A law with continuous `memory` gives
    each state with its rate and its size, the scale of its error tolerance.
    """

    force: sp.Expr = sp.S.Zero
    slope: sp.Expr = sp.S.Zero
    modes: tuple[str, ...] = ()
    holding: sp.Expr | None = None
    memory: tuple[tuple[Quantity, sp.Expr, sp.Expr], ...] = ()
    forms: tuple[str, ...] = FORMS  # it depends on the normal force alone
    kind = "friction"

    def __post_init__(self) -> None:
        """Check that a law with modes does not depend on the sliding speed; raises ValueError."""
        super().__post_init__()
        if self.modes and (self.holding is None or self.sliding.has(s) or self.holding.has(s)):
            raise ValueError(f"law {self.name}: with modes, force/sign(s) and holding are functions of N alone")

    @property
    def needs_contact(self) -> bool:
        """Whether it has meaning only between surfaces: it sticks, remembers, or depends on their geometry."""
        return bool(self.modes or self.memory or self.geometry or self.pairs)

    @property
    def sliding(self) -> sp.Expr:
        """Magnitude of the friction force while sliding [N]; for laws with modes."""
        return self.force.xreplace({sp.sign(s): sp.S.One})

    @property
    def forces(self) -> tuple[sp.Expr, ...]:
        """The friction force."""
        return (self.force,)

    @property
    def in_two_directions(self) -> tuple[tuple[sp.Expr, sp.Expr], ...] | None:
        """Force and rate of a law with memory per deflection and per sliding velocity, at a speed s >= 0.

        With vectors in place of deflection and velocity the law is isotropic. None where it is not linear in the deflection, or
        neither vanishes with both.
        """
        ((bristle, rate, _),) = self.memory
        pairs = []
        for expression in (self.force, rate):
            ahead = expression.xreplace({sp.Abs(s): s, sp.sign(s): sp.S.One})
            bent, per_speed = sp.diff(ahead, bristle), sp.expand(ahead.xreplace({bristle: sp.S.Zero}) / s)
            if bent.has(bristle) or per_speed.xreplace({s: sp.S.Zero}).has(sp.zoo, sp.nan, sp.oo, -sp.oo):
                return None
            pairs.append((bent, per_speed))
        return tuple(pairs)

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield the friction force, its slope at rest, the static friction, rates and sizes of the memory."""
        yield "friction force", self.force, "N"
        yield "slope of the friction force at rest", self.slope, "N s/m"
        if self.holding is not None:
            yield "force held at rest", self.holding, "N"
        for symbol, rate, size in self.memory:
            yield f"rate of {symbol.name}", rate, f"({symbol.unit})/s"
            yield f"size of {symbol.name}", size, symbol.unit


@dataclass(frozen=True)
class FilmLaw(Law):
    """Resistances of a fluid film per unit of velocity, between pin and bush or before a sphere.

    Of a pin they depend on its position in the bush alone (`eps_w`, `eps_c`), of a sphere on the thickness `h`; it has
    the first alone.

    along   force against the squeeze velocity, or against the approach of a sphere [N s/m]
    across  force against the direction a quarter turn on from it, about the axis [N s/m]
    couple  couple against the spin of the pin in the bush [N m s]
    """

    along: sp.Expr = sp.S.Zero
    across: sp.Expr = sp.S.Zero
    couple: sp.Expr = sp.S.Zero
    forms: tuple[str, ...] = ("line",)  # of a pin in its bush
    kind = "film"

    @property
    def forces(self) -> tuple[sp.Expr, ...]:
        """The resistances, one or three."""
        return (self.along,) if self.forms == ("point",) else (self.along, self.across, self.couple)

    def expressions(self) -> Iterator[tuple[str, sp.Expr, str]]:
        """Yield the resistances along and across the squeeze velocity, and against the spin."""
        if self.forms == ("point",):
            yield "drag against the approach", self.along, "N s/m"
            return
        yield "drag along the squeeze velocity", self.along, "N s/m"
        yield "drag across the squeeze velocity", self.across, "N s/m"
        yield "drag against the spin", self.couple, "N m s"


def gauss_legendre(points: int) -> Iterator[tuple[sp.Float, sp.Float]]:
    """Yield the nodes and weights of Gauss-Legendre quadrature on (0, 1), as doubles."""
    from mpmath import legendre, mp, polyroots  # SymPy brings it

    with mp.workdps(40):
        x = sp.Symbol("x")
        polynomial = sp.legendre_poly(points, x, polys=True)
        for root in polyroots(
            [mp.mpf(int(c.p)) / int(c.q) for c in polynomial.all_coeffs()], maxsteps=200, extraprec=200
        ):
            slope = points * (legendre(points - 1, root) - root * legendre(points, root)) / (1 - root**2)
            yield sp.Float((1 + root) / 2, 17), sp.Float(1 / ((1 - root**2) * slope**2), 17)


def _exact(value: Any) -> Any:
    """Convert a number to an exact rational (1.5 -> 3/2), so that exponents compare exactly."""
    if isinstance(value, float) and value == value and abs(value) != float("inf"):
        fraction = Fraction(value).limit_denominator(10_000)
        near = abs(float(fraction) - value) <= 1e-15 * max(1.0, abs(value))
        return sp.Rational(fraction.numerator, fraction.denominator) if near else sp.Float(value)
    return sp.sympify(value) if isinstance(value, (int, sp.Basic)) else value


@dataclass(frozen=True)
class BoundLaw:
    """A law with values for its parameters: scene parameters, expressions of them, or numbers."""

    law: Any
    values: tuple[Any, ...]
    materials: tuple[Material, ...] = ()

    def _repr_html_(self) -> str:
        return law_html(self.law, self)

    @property
    def binding(self) -> dict[sp.Symbol, Any]:
        """Value of each of the law's parameters."""
        return dict(zip(self.law.parameters, self.values, strict=True))

    def resolved(
        self,
        geometry: Mapping[str, Any],
        let: Callable[..., Any],
        known: Mapping[sp.Symbol, Any],
        stated: Callable[..., Any] = lambda *_: None,
    ) -> dict[sp.Symbol, Any]:
        """Return the values of its symbols: the known ones, parameters, geometry by name, definitions.

        let     names a value: (expression, name, dimension) -> symbol
        stated  dimension of a definition where it is stated: (symbol, values)
        """
        values = {**known, **self.binding}
        for quantity in self.law.geometry:
            values[quantity] = let(geometry[quantity.name], quantity.name)
        for symbol, expression in self.law.definitions:
            values[symbol] = let(expression.xreplace(values), symbol.name, stated(symbol, values))
        return values

    def slots(self, where: str, geometry: dict[str, Any]) -> Iterator[Slot]:
        """Yield the values given to the law, and those of the pair's `geometry` that it has ranges for."""
        limits = {
            row.quantity: {other.kind: other.interval for other in self.law.ranges if other.quantity == row.quantity}
            for row in self.law.ranges
        }
        for symbol, value in self.binding.items():
            limit, recommended = symbol.limit, None
            if isinstance(self.law, DampingLaw) and symbol.name == "e":
                limit, recommended = self.law.defined, self.law.recommended
            known = limits.get(symbol, {})
            place = f"{where}, {symbol.meaning} of {self.law.name}"
            yield Slot(place, value, symbol.unit, known.get("defined", limit), known.get("recommended", recommended))
        for material in dict.fromkeys(self.materials):
            if material.density is not None:
                yield Slot(f"{where}, density", material.density, "kg/m^3", POSITIVE)
            if material.yield_strength is not None:
                yield Slot(f"{where}, yield strength", material.yield_strength, "Pa", POSITIVE)
        for symbol, kinds in limits.items():
            if symbol not in self.binding and symbol.name in geometry:
                place = f"{where}, {symbol.meaning} for {self.law.name}"
                yield Slot(place, geometry[symbol.name], symbol.unit, kinds.get("defined"), kinds.get("recommended"))


# -- laws as notebooks show them: formulas, symbols with units, source -------------------------------------------------


_LETTERS = {"penetration": "d", "normal force": "F", "stored energy": "W", "damping force": r"F_{\mathrm{d}}",
            "friction force": r"F_{\mathrm{t}}", "unloading force": r"F_{\mathrm{u}}", "dent": r"d_{\mathrm{r}}",
            "depth of first yield": r"d_{\mathrm{y}}"}  # fmt: skip


def law_html(law: Law, bound: BoundLaw | None = None) -> Markup:
    """Title, formulas, parameters with their values where they are bound, source, note."""
    parts = [heading(law.name, f"{law.kind} law, {law.verdict}", f": {law.title}", good=law.verdict == "consistent")]
    parts += [tag("p", formula) for formula in _formulas(law)]
    values = {} if bound is None else bound.binding
    header = ("symbol", "unit", "meaning", *(("value",) if bound is not None else ()))
    rows = [
        (inline(latex_name(symbol)), symbol.unit, symbol.meaning, *((text_of(values[symbol]),) if symbol in values else ()))
        for symbol in law.parameters
    ]  # fmt: skip
    parts += [table(header, rows)] if rows else []
    parts += [tag("p", f"Grade {law.grade}. {law.source}")]
    parts += [tag("p", law.note)] if law.note else []
    return joined(parts)


def _formulas(law: Law) -> Iterator[Markup]:
    """Yield each expression of a law, then its intermediate results."""
    for quantity, expression, unit in law.expressions():
        yield joined(
            [f"{quantity[:1].upper()}{quantity[1:]} [{unit}]: ", _math(_LETTERS.get(quantity, ""), expression)]
        )
    for symbol, expression in law.definitions:
        yield joined(
            ["with ", _math(latex_name(symbol), expression), f" [{symbol.unit}]" if symbol.unit != "1" else ""]
        )


def _math(name: str, expression: Any) -> Markup:
    """An expression as MathML, after its name; its text where the reader of LaTeX does not know something."""
    latex = latex_of(expression, {symbol: latex_name(symbol) for symbol in expression.free_symbols})
    try:
        return joined((line for line, _ in lines_of(f"{name} = {latex}" if name else latex)), " ")
    except ValueError:
        return tag("code", text_of(expression))
