"""Sheet of a law: formulas, symbols, ranges, local exponent, restitution, cost.

All are plain values, for people and for JSON.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.common.faults import refuse, unknown
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.exchange.law_sheets.free_impact import (
    coefficient_at,
    published_exponent,
    restitution_limits,
    restitution_out,
    restitution_symbol,
)
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.notation import latex_name, latex_of, text_of
from hertzwerk.derive.expressions.dimension.dimension import ONE
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import (
    FORMS,
    GEOMETRY,
    GRADES,
    STATE,
    DampingLaw,
    F,
    FrictionLaw,
    Law,
    Quantity,
    StiffnessLaw,
    d,
    v,
    v0,
)
from hertzwerk.derive.laws.listing import remembered
from hertzwerk.derive.laws.smoothing import begun
from hertzwerk.derive.program.emit.cost import operations
from hertzwerk.derive.program.expression_text import expression_text
from hertzwerk.derive.program.program import PARAMETER, Function, Result, Tape, eliminate_common_subexpressions

PER_DECADE, FIRST, DECADES = 8, -8, 4  # penetrations of 10 nm to 0.1 mm
DEFAULT_PAIRS = ("pin_in_bush",)  # of the example of a law that holds for every pair


@dataclass(frozen=True)
class Candidate:
    """Forces [N] and local exponents dlnF/dlnd of one candidate, at the penetrations of the band."""

    law: str
    forces: tuple[float, ...]
    exponents: tuple[float, ...]


@dataclass(frozen=True)
class Band:
    """All candidates at the same penetrations [m], for the example of the sheet."""

    penetrations: tuple[float, ...]
    candidates: tuple[Candidate, ...]

    @property
    def spread(self) -> tuple[float, ...]:
        """Ratio of the largest to the smallest force at each penetration."""
        columns = zip(*(candidate.forces for candidate in self.candidates), strict=True)
        return tuple(max(column) / min(column) for column in columns)


def band_of(law: StiffnessLaw) -> Band | None:
    """Band of a law of grade R; None for other laws."""
    if law.grade != "R":
        return None
    depths = tuple(10 ** (FIRST + k / PER_DECADE) for k in range(DECADES * PER_DECADE + 1))
    return Band(depths, tuple(_candidate(other, _example(other, law.pairs), depths) for other in _candidates(law)))


def _candidates(law: StiffnessLaw) -> list[StiffnessLaw]:
    """Reconstructions that are alternatives to the law, itself first."""
    places = set(law.pairs or DEFAULT_PAIRS)
    others = [
        other
        for other in LAWS.values()
        if isinstance(other, StiffnessLaw) and other.grade == "R" and (not other.pairs or places & set(other.pairs))
    ]
    return [law, *(other for other in others if other is not law)]


def _candidate(law: StiffnessLaw, values: Mapping[Any, Any], depths: tuple[float, ...]) -> Candidate:
    slope = sp.diff(law.force, d)
    with mp.workdps(30):
        rows = [(x, *(evaluate(e, {**values, d: x}) for e in (law.force, slope))) for x in map(mpf, depths)]
        return Candidate(law.name, tuple(float(f) for _, f, _ in rows), tuple(float(x * k / f) for x, f, k in rows))


# ----------------------------------------------------------------------------------------------------------------------


RELEASES = {
    "force": "the contact ends where the normal force falls to zero",
    "gap": "the contact ends where the gap opens; the law may pull before",
}
EXAMPLE = {"E_1": "207e9", "E_2": "207e9", "nu_1": "0.3", "nu_2": "0.3",
          "R_1": "0.010", "R_2": "0.0095", "R_min": "0.0095", "L": "0.015"}  # fmt: skip
EXAMPLES = {
    "pin_in_bush": ("pin in bush", {"dR": "0.0005", "R_eff": "0.19"}),
    "parallel_cylinders": ("rollers side by side", {"dR": "0.0195", "R_eff": repr(0.010 * 0.0095 / 0.0195)}),
}
"""Name and geometry of the example, by the kind of pair that a law is made for; a law for other kinds has no example."""
DEPTHS = (1e-8, 1e-7, 1e-6, 1e-5, 1e-4)  # m, of the example
SMOOTHING = 1e-6  # m, of the example
RESTITUTIONS = (0.99, 0.9, 0.7, 0.5, 0.3, 0.1, 0.05)

h = Quantity("h", "1", "hysteresis damping factor")


@dataclass(frozen=True)
class Formula:
    """One expression: `symbol` = `text`, in `unit`."""

    symbol: str
    unit: str
    meaning: str
    text: str
    latex: str


@dataclass(frozen=True)
class Entry:
    """One symbol of a law, with its ranges as text, in SI.

    `origin` is parameter, definition, pair, contact or memory.
    """

    name: str
    unit: str
    meaning: str
    origin: str
    defined: str = ""
    recommended: str = ""


@dataclass(frozen=True)
class Point:
    """Elastic force [N] and local exponent dlnF/dlnd at one penetration [m] of the example.

    The force is None where the units are inconsistent. `smoothed` is the force with Contact(..., smooth="1 um") over the
    law's own, less 1.
    """

    penetration: float
    force: float | None
    exponent: float
    smoothed: float


@dataclass(frozen=True)
class Restitution:
    """Restitution returned by a damping law.

    `coefficient` names h, or the symbol in its place; its limits and those of e_out are as e -> 1 and e -> 0. Numbers
    are None where no closed form is known, limits of the coefficient are text such as "3/2" or "oo". `points`: (e,
    coefficient, e_out). `beside` is the exponent n of the K d^n for which it holds, "" where it holds for every
    elastic law.
    """

    coefficient: str
    coefficient_at_one: str
    coefficient_at_zero: str
    out_at_one: float | None
    out_at_zero: float | None
    points: tuple[tuple[float, float, float], ...]
    beside: str


_STATED = ("name", "kind", "title", "grade", "verdict", "fitted_in", "source", "note", "repair", "pairs")


@dataclass(frozen=True)
class Sheet:
    """Everything the catalogue states of one law.

    `law` is the law itself. `form`: of contact, point, line, surface or any. `band`: candidates, for a reconstruction. `operations`: of the
    generated text, once per run and per evaluation.
    """

    law: Any
    form: str
    formulas: tuple[Formula, ...]
    definitions: tuple[Formula, ...]
    symbols: tuple[Entry, ...]
    exponent: str
    memory: tuple[str, ...]
    modes: tuple[str, ...]
    release: str
    local_exponent: str
    example: str
    points: tuple[Point, ...]
    band: Band | None
    restitution: Restitution | None
    operations: tuple[int, int]

    @property
    def grade_meaning(self) -> str:
        """How well what the law states is known."""
        return GRADES[self.law.grade]

    def record(self) -> dict[str, Any]:
        """The sheet as plain values for JSON."""
        own = {name: getattr(self.law, name) for name in _STATED} | {"grade_meaning": self.grade_meaning}
        return own | {name: value for name, value in asdict(replace(self, law=None)).items() if name != "law"}


def laws_named(names: Iterable[str]) -> tuple[Law, ...]:
    """Laws of these names; raises InputError listing every unknown name and the names like it."""
    refuse("laws", [unknown("law", name, LAWS, "as `hertzwerk laws` lists them") for name in names if name not in LAWS])
    return tuple(LAWS[name] for name in names)


def sheet(law: Law) -> Sheet:
    """Make the sheet of a law."""
    damps = isinstance(law, DampingLaw)
    elastic = isinstance(law, StiffnessLaw)
    example = _example(law) if elastic else {}
    exponent = getattr(law, "exponent", None)
    return Sheet(
        law=law,
        form="any" if set(law.forms) == set(FORMS) else " or ".join(law.forms),
        formulas=tuple(_formulas(law)),
        definitions=tuple(_formula(s.name, s.unit, s.meaning, e, latex_name(s)) for s, e in _definitions(law)),
        symbols=tuple(_entries(law)),
        exponent=("n" if damps and law.factor is not None else "") if exponent is None else str(exponent),  # type: ignore[attr-defined]
        memory=tuple(f"{symbol.name} [{symbol.unit}], {symbol.meaning}" for symbol in remembered(law)),
        modes=law.modes if isinstance(law, FrictionLaw) else (),
        release=RELEASES[law.release] if isinstance(law, DampingLaw) else "",
        local_exponent=_constant_exponent(law) if isinstance(law, StiffnessLaw) else "",
        example=_example_text(law) if example else "",
        points=tuple(_points(law, example)) if isinstance(law, StiffnessLaw) and example else (),
        band=band_of(law) if isinstance(law, StiffnessLaw) and example else None,
        restitution=_restitution(law) if isinstance(law, DampingLaw) and restitution_symbol(law) else None,
        operations=operations_of(law),
    )


# -- formulas ----------------------------------------------------------------------------------------------------------


def _formula(symbol: str, unit: str, meaning: str, expression: Any, latex: str = "") -> Formula:
    left = latex or latex_name(sp.Symbol(symbol))
    unit = str(parse_unit(unit)) if unit.startswith("(") else unit
    return Formula(symbol, unit, meaning, text_of(expression), f"{left} = {latex_of(expression)}")


_RESULTS = {
    "penetration": "d",
    "normal force": "F",
    "stored energy": "W",
    "reach": "d_max",
    "depth of first yield": "d_on",
    "dent": "d_r",
    "unloading force": "F_u",
    "damping force": "F_d",
    "friction force": "F_t",
    "slope of the friction force at rest": "c_0",
    "force held at rest": "F_s",
    "drag against the approach": "D",
    "drag along the squeeze velocity": "D_w",
    "drag across the squeeze velocity": "D_c",
    "drag against the spin": "D_spin",
}


def _formulas(law: Law) -> Iterator[Formula]:
    for quantity, expression, unit in law.expressions():
        if isinstance(law, DampingLaw):
            expression = _resistance(law)
        kind, _, name = quantity.rpartition(" of ")
        if quantity in _RESULTS:
            yield _formula(_RESULTS[quantity], unit, quantity, expression)
        elif kind == "rate":
            yield _formula(f"d{name}/dt", unit, quantity, expression, rf"\dot{{{name}}}")
        else:
            meaning = f"{quantity}, by which its accuracy is measured"
            yield _formula(f"{name}_size", unit, meaning, expression, rf"{name}_{{\mathrm{{size}}}}")


def _definitions(law: Law) -> tuple[tuple[Quantity, sp.Expr], ...]:
    """Definitions of a law; the factor of hysteresis damping is the last of them."""
    own = ((h, law.factor),) if isinstance(law, DampingLaw) and law.factor is not None else ()
    return (*law.definitions, *own)


def _resistance(law: DampingLaw) -> sp.Expr:
    return law.resistance if law.factor is None else F * h * v / v0


def operations_of(law: Law) -> tuple[int, int]:
    """Count operations of the generated text of a law's force: once per run, and per evaluation."""
    tape = Tape()
    defined = {symbol for symbol, _ in _definitions(law)}
    expressions = (_resistance(law),) if isinstance(law, DampingLaw) else law.forces
    read = {node for e in (*expressions, *(e for _, e in _definitions(law))) for node in e.free_symbols}
    for symbol in sorted(read - defined, key=str):
        tape.input(symbol.name, "q" if symbol in STATE else PARAMETER, ONE, symbol)
    values: dict[Any, Any] = {}
    for symbol, definition in _definitions(law):
        values[symbol] = tape.let(definition.xreplace(values), symbol.name)
    forces = tuple(tape.let(expression.xreplace(values), "force") for expression in expressions)
    blank = ("",) * len(forces)
    force = tape.function("force", "", ("q", "c"), [Result("force", blank, blank, forces)])
    needed = [symbol for symbol in tape.constants([force]) if symbol in tape.assignments]
    once = tape.function(
        "constants", "", ("p",), [Result("c", ("",) * len(needed), ("",) * len(needed), tuple(needed))]
    )
    return _count(once), _count(force)


def _count(function: Function) -> int:
    function = eliminate_common_subexpressions(function)
    results = (expression for result in function.results for expression in result.expressions)
    return sum(operations(expression_text(e)) for e in (*(e for _, e in function.body), *results))


# -- symbols -----------------------------------------------------------------------------------------------------------


def _entries(law: Law) -> Iterator[Entry]:
    ranges = {(row.quantity, row.kind): row.interval for row in law.ranges}
    if isinstance(law, DampingLaw) and (e := restitution_symbol(law)) is not None:
        ranges |= {
            (e, kind): i for kind, i in (("defined", law.defined), ("recommended", law.recommended)) if i is not None
        }
    memory = {*law.memory} if isinstance(law, DampingLaw) else {s for s, *_ in getattr(law, "memory", ())}
    defined = {symbol for symbol, _ in _definitions(law)}
    shown = dict.fromkeys(
        (*law.symbols(), *(row.quantity for row in law.ranges), *((F, v, v0) if h in defined else ()))
    )
    for symbol in shown:
        if symbol in defined:
            continue  # listed among the definitions
        origin = (
            "parameter"
            if symbol in law.parameters
            else "memory"
            if symbol in memory
            else "pair"
            if symbol in GEOMETRY
            else "contact"
        )
        limits = [ranges.get((symbol, "defined"), symbol.limit), ranges.get((symbol, "recommended"))]
        yield Entry(
            symbol.name, symbol.unit, symbol.meaning, origin, *("" if one is None else str(one) for one in limits)
        )


# -- local exponent ----------------------------------------------------------------------------------------------------


def _constant_exponent(law: StiffnessLaw) -> str:
    """Local exponent dlnF/dlnd where it does not depend on d, else ""."""
    if law.force.has(sp.LambertW, Where):  # which have none, and take long
        return ""
    exponent = sp.simplify(d * sp.diff(law.force, d) / law.force)
    return "" if exponent.has(d) else str(exponent)


def _example(law: Law, pairs: tuple[str, ...] | None = None) -> dict[sp.Symbol, Any]:
    """Values of a stiffness law's symbols for steel bodies of its kind of pair, in the law's units.

    `pairs` are those of the law for whose sheet the example is made; None for its own. Returns {} for a law that
    takes other symbols, or is made for other kinds than EXAMPLES has.
    """
    kind = _kind_of_example(law.pairs if pairs is None else pairs)
    if not isinstance(law, StiffnessLaw) or kind is None:
        return {}
    numbers = EXAMPLE | EXAMPLES[kind][1]
    numbers |= {symbol.name: repr(parameter.si) for symbol, parameter in law.defaults}
    defined = {symbol for symbol, _ in law.definitions}
    symbols = [symbol for symbol in law.symbols() if symbol not in defined and symbol not in STATE]
    if not all(symbol.name in numbers for symbol in symbols):
        return {}
    with mp.workdps(30):
        return values_of(law, symbols, numbers, lambda unit: _unit_of(law, unit))


def values_of(
    law: Law, symbols: Iterable[Quantity], numbers: Mapping[str, Any], size: Callable[[str], Any]
) -> dict[sp.Symbol, Any]:
    """Values of symbols by name, of `numbers` in SI, in units of a given size; and of definitions.

    A definition that divides by zero is nan: ln(1000 dR) of a millimetre put in in metres is the logarithm of 1.
    """
    values: dict[sp.Symbol, Any] = {s: mpf(numbers[s.name]) / size(s.unit) for s in symbols}
    for symbol, expression in law.definitions:
        try:
            values[symbol] = evaluate(expression, values)
        except ZeroDivisionError:
            values[symbol] = mp.nan
    return values


def _kind_of_example(pairs: tuple[str, ...]) -> str | None:
    return next((kind for kind in pairs or DEFAULT_PAIRS if kind in EXAMPLES), None)


def _example_text(law: Law) -> str:
    kind = _kind_of_example(law.pairs)
    where = "" if kind is None else EXAMPLES[kind][0]
    c_b = ", c_b = 4/sqrt(pi)" if any(q.name == "c_b" for q in law.parameters) else ""
    return f"steel (207 GPa, 0.3), {where}, R1/R2 = 10/9.5 mm, L = 15 mm{c_b}"


def _unit_of(law: Law, unit: str) -> Any:
    """Size in SI of the unit in which a fitted law takes a quantity: 1 unless it names one."""
    texts = [text.strip() for text in law.fitted_in.split(",") if text.strip()]
    same = (other.factor for other in map(parse_unit, texts) if other.exponents == parse_unit(unit).exponents)
    return mpf(repr(next(same, 1.0)))


def _points(law: StiffnessLaw, values: dict[sp.Symbol, Any]) -> Iterator[Point]:
    metre, newton = _unit_of(law, "m"), _unit_of(law, "N")
    with mp.workdps(30):
        length = mpf(repr(SMOOTHING))
        reach = mp.inf if law.reach is None else evaluate(law.reach, values) * metre
        for depth in map(mpf, map(repr, DEPTHS)):
            if depth < reach:
                share = depth / (2 * length)
                begin = begun(share, length) if share < 1 else depth - length
                at, smooth = (values | {d: x / metre} for x in (depth, begin))
                force, slope = (evaluate(e, at) for e in (law.force, sp.diff(law.force, d)))
                known = law.verdict == "consistent" or law.fitted_in
                yield Point(
                    float(depth), float(force * newton) if known else None, float(at[d] * slope / force),
                    float(evaluate(law.force, smooth) / force - 1),
                )  # fmt: skip


# -- restitution -------------------------------------------------------------------------------------------------------


def _restitution(law: DampingLaw) -> Restitution:
    rows = ((e, coefficient_at(law, e), restitution_out(law, e)) for e in RESTITUTIONS)
    return Restitution(
        "h" if law.factor is not None else law.definitions[-1][0].name,
        "" if law.at_one is None else str(law.at_one),
        "" if law.at_zero is None else str(law.at_zero),
        *restitution_limits(law),
        tuple((e, coefficient, out) for e, coefficient, out in rows if out is not None),
        "" if law.factor is not None else str(published_exponent(law)),
    )
