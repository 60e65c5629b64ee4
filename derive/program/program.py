"""The straight-line program: inputs with dimensions, assignments in order, functions.

One `Tape` records the derivation of a whole scene. `let` names an intermediate result once (equal expressions share a
symbol), moves subexpressions of parameters alone into constants, and keeps expressions small. A `Function` is the
backward slice of the tape that its results need; slices that read `c` stop at the constants, so that these are
computed once per run.
"""

from __future__ import annotations

import keyword
import operator
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.planar_curve import PlanarChain, PlanarCurve, Sampled
from hertzwerk.derive.expressions.algebra.vectors import Matrix, Vector
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import TABLE

PARAMETER = "p"
CONSTANT = "c"
NUMBERED = "k1"
"""Name of the first constant that has none of its own."""
OWN = {
    "ca": "casadi", "t": "time", "p": "parameters", "q": "coordinates", "u": "speeds", "a": "speed_rates", "f": "forces", "z": "memory",
    "m": "latches", "c": "constant_values", "wanted": "wanted_rates", "multipliers": "constraint_forces", "reactions": "drive_reactions",
    "joints": "joint_coordinates", "joint_speeds": "speeds_of_joints", "friction": "friction_forces", "touching": "contact_forces",
}  # fmt: skip
"""Names of CasADi and of arguments in generated functions, and what stands for one where a parameter has its name."""
_NO_GROUPS: frozenset[str] = frozenset()
_STILL = frozenset((PARAMETER,))


@dataclass(frozen=True)
class Result:
    """One column vector returned by a function: labels, unit texts and expressions of its entries."""

    name: str
    labels: tuple[str, ...]
    units: tuple[str, ...]
    expressions: tuple[Any, ...]


@dataclass(frozen=True)
class Function:
    """A function of the module: arguments by group (`t`, `q`, `u`, ...), assignments in order, results."""

    name: str
    summary: str
    arguments: tuple[str, ...]
    body: tuple[tuple[sp.Symbol, sp.Expr], ...]
    results: tuple[Result, ...]
    shared: Mapping[sp.Symbol, sp.Symbol | None] = field(default_factory=dict)
    """Numbered symbol of a shared subexpression -> the assignment whose whole value it is, if there is one."""
    places: Mapping[sp.Symbol, str] | None = None
    """Inputs of a function of one tree or pair, `q[3]` of its own coordinates; None of one of the whole vectors."""

    @cached_property
    def reads(self) -> tuple[sp.Symbol, ...]:
        """The symbols it takes from outside, in order of first use."""
        expressions = [e for _, e in self.body] + [e for result in self.results for e in result.expressions]
        made = {symbol for symbol, _ in self.body}  # assigned before use
        return tuple(s for s in symbols_in(*expressions) if s not in made)


@dataclass
class Tape:
    """Inputs and assignments of one derivation."""

    inputs: dict[sp.Symbol, str] = field(default_factory=dict)
    """Input symbol -> group."""
    assignments: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    _places: dict[sp.Symbol, int] = field(default_factory=dict)
    """Place of each assignment in their order."""
    declared: dict[sp.Symbol, Dimension] = field(default_factory=dict)
    """Dimensions of the inputs, and of assignments whose dimension is stated instead of inferred (unchecked laws)."""
    names: set[str] = field(default_factory=lambda: set(OWN))
    """Names in use."""
    numbered: list[sp.Symbol] = field(default_factory=list)
    """Assignments of constants that have no name but a number."""
    pieces: dict[str, tuple[sp.Symbol, ...]] = field(default_factory=dict)
    """Inputs of the scene by name, and the entries of c that a run changes with their pieces."""
    _instead: dict[str, str] = field(default_factory=dict)
    _groups: dict[Any, frozenset[str]] = field(default_factory=dict)
    _known: dict[Any, sp.Symbol] = field(default_factory=dict)
    _sign_free_keys: set[Any] = field(default_factory=set)
    """Keys of the named expressions, equal for an expression and its negative."""
    _rates: dict[sp.Symbol, Any] = field(default_factory=dict)
    widths: dict[sp.Symbol, int] = field(default_factory=dict)
    """Number of entries of assignments that are vectors."""

    # -- recording -------------------------------------------------------------------------------------------------

    def input(self, name: str, group: str, dimension: Dimension, symbol: sp.Symbol | None = None) -> sp.Symbol:
        """Declare an input of a group; an existing `symbol` (a Parameter) is used as it is."""
        if symbol is None:
            symbol = sp.Symbol(self.own(name) if group == "t" else self._unique(name), real=True)
        else:
            self.names.add(name)
        self.inputs[symbol] = group
        self.declared[symbol] = dimension
        self._groups[symbol] = frozenset((group,))
        return symbol

    def piece(self, name: str, dimensions: Iterable[Dimension]) -> tuple[sp.Symbol, ...]:
        """Entries of c that hold the piece of an input: its begin, then its coefficients; declared once."""
        if name not in self.pieces:
            labels = enumerate(dimensions, -1)
            symbols = (self.input(f"{name}_begin" if k < 0 else f"{name}_c{k}", CONSTANT, of) for k, of in labels)
            self.pieces[name] = tuple(symbols)
            self._rates |= dict.fromkeys(self.pieces[name], sp.S.Zero)
        return self.pieces[name]

    def own(self, name: str) -> str:
        """Text of a name in `OWN`, once all parameters are declared: they keep theirs."""
        if name not in self._instead:
            taken = any(symbol.name == name for symbol, group in self.inputs.items() if group == PARAMETER)
            self._instead[name] = self._unique(OWN[name]) if taken else name
        return self._instead[name]

    def let(self, expression: Any, name: str, dimension: Dimension | None = None) -> Any:
        """Name an intermediate result; numbers and symbols (also negated) pass through.

        `dimension` states its dimension, which is then not inferred.
        """
        expression = sp.sympify(expression)
        if dimension is not None:
            symbol = self._assign(expression, name)
            self.declared[symbol] = dimension
            return symbol
        if expression.is_Atom:
            return expression
        expression = self._hoist(expression)
        if expression.is_Atom or _negated_atom(expression).is_Symbol:
            return expression
        key = _sign_free_key(expression)
        if key in self._sign_free_keys:
            if -expression in self._known and expression.could_extract_minus_sign():
                return -self._known[-expression]
            if expression in self._known:
                return self._known[expression]
        self._sign_free_keys.add(key)
        self._known[expression] = symbol = self._assign(expression, name)
        return symbol

    def block(self, expression: Any, name: str, width: int, dimension: Dimension) -> sp.Symbol:
        """Name a vector of a stated dimension; equal ones share a symbol. Its entries are named one by one."""
        if expression not in self._known:
            self._known[expression] = symbol = self._assign(expression, name)
            self.declared[symbol], self.widths[symbol] = dimension, width
        return self._known[expression]

    def _assign(self, expression: Any, name: str) -> sp.Symbol:
        symbol = sp.Symbol(self._unique(name), real=True)
        if name == NUMBERED:
            self.numbered.append(symbol)
        self._places[symbol] = len(self._places)
        self.assignments[symbol] = expression
        self._groups[symbol] = self._groups_of(expression)
        return symbol

    def vector(self, vector: Vector, name: str) -> Vector:
        """Name the three components of a vector."""
        return tuple(self.let(v, f"{name}_{axis}") for v, axis in zip(vector, "xyz", strict=True))

    def matrix(self, matrix: Matrix, name: str) -> Matrix:
        """Name the nine entries of a matrix."""
        return tuple(self.vector(row, f"{name}_{axis}") for row, axis in zip(matrix, "xyz", strict=True))  # type: ignore[return-value]

    def is_constant(self, expression: Any) -> bool:
        """Whether an expression depends on parameters alone."""
        return self._groups_of(expression) <= _STILL

    def depends_on(self, expression: Any, group: str) -> bool:
        """Whether an expression depends on an input of a group."""
        return group in self._groups_of(sp.sympify(expression))

    def written_out(self, expression: Any) -> Any:
        """Substitute assignments until only inputs remain; for constants, which are short."""
        expression = sp.sympify(expression)
        known = {
            symbol: self.written_out(self.assignments[symbol])
            for symbol in symbols_in(expression)
            if symbol in self.assignments
        }
        return expression.xreplace(known)

    def _groups_of(self, expression: Any) -> frozenset[str]:
        """Groups of the inputs that an expression depends on, cached for all its parts."""
        groups = self._groups.get(expression)
        if groups is None:
            if expression.is_Symbol:
                raise KeyError(expression)
            groups = _NO_GROUPS.union(*map(self._groups_of, expression.args))
            self._groups[expression] = groups
        return groups

    def _unique(self, name: str) -> str:
        name = f"{name}_" if keyword.iskeyword(name) else name
        base, count = (name[:-1], 1) if name[-1].isdigit() else (f"{name}_", 1)
        while name in self.names or name.endswith(TABLE):
            count += 1
            name = f"{base}{count}"
        self.names.add(name)
        return name

    def _hoist(self, expression: Any) -> Any:
        """Name the subexpressions of parameters alone, so that they are computed once per run."""
        if expression.is_Atom or self.is_constant(expression):
            return expression
        if expression.is_Mul or expression.is_Add:
            still: list[Any] = []
            others: list[Any] = []
            for arg in expression.args:
                (still if self.is_constant(arg) else others).append(arg)
            moving = [self._hoist(arg) for arg in others]
            part = still[0] if len(still) == 1 else expression.func(*still)
            if not (part.is_Atom or _negated_atom(part).is_Symbol):
                sign = -1 if expression.is_Mul and part.could_extract_minus_sign() else 1
                part = sign * self.let(sign * part, NUMBERED)
            elif all(map(operator.is_, moving, others)):
                return expression  # no constant part
            return expression.func(part, *moving)
        if expression.is_Pow:  # an exponent stays as written: the audit compares it with the exponent in a unit
            base = self._hoist(expression.base)
            return sp.Pow(base if expression.exp == -1 else self.let(base, "base"), expression.exp)
        return expression.func(*(arg if arg.is_Relational else self._hoist_argument(arg) for arg in expression.args))

    def _hoist_argument(self, argument: Any) -> Any:
        """Name a function's whole argument if it depends on parameters alone, else hoist its parts."""
        if self.is_constant(argument) and not argument.is_number:
            return self.let(argument, NUMBERED)
        return self._hoist(argument)

    # -- rates of change -------------------------------------------------------------------------------------------

    def set_rate(self, symbol: Any, rate: Any) -> None:
        """State d(symbol)/dt where a shorter form than the chain rule's is known.

        Numbers and expressions are ignored.
        """
        if isinstance(symbol, sp.Symbol) and symbol not in self._rates:
            self._rates[symbol] = rate

    def rate(self, expression: Any, name: str) -> Any:
        """Derivative d(expression)/dt along the motion, by the chain rule over the tape."""
        moving = [symbol for symbol in symbols_in(expression) if self._rate_of(symbol) != 0]
        terms = (sp.diff(expression, symbol) * self._rate_of(symbol) for symbol in moving)
        return self.let(sp.Add(*terms), name)

    def _rate_of(self, symbol: sp.Symbol) -> Any:
        if symbol not in self._rates:
            if self._groups[symbol] <= _STILL:
                self._rates[symbol] = sp.S.Zero
            elif symbol in self.assignments:
                self._rates[symbol] = self.rate(self.assignments[symbol], f"{symbol.name}_rate")
            else:
                raise KeyError(f"no rate of change is known for the input {symbol}")
        return self._rates[symbol]

    # -- slicing ---------------------------------------------------------------------------------------------------

    def function(self, name: str, summary: str, arguments: tuple[str, ...], results: Iterable[Result]) -> Function:
        """Slice of the tape that `results` need; with `c` among the arguments it stops at the constants."""
        results = tuple(results)
        body = self.needed((e for result in results for e in result.expressions), stop=CONSTANT in arguments)
        function = Function(name, summary, arguments, body, results)
        foreign = [s for s in function.reads if self.inputs.get(s, PARAMETER) not in (*arguments, PARAMETER)]
        if foreign:
            raise ValueError(f"{name}({', '.join(arguments)}) would read {', '.join(map(str, foreign))}")
        return function

    def needed(self, expressions: Iterable[Any], *, stop: bool = False) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """Assignments that expressions need, in order; `stop` at those of parameters alone."""
        symbols: set[sp.Symbol] = set()
        pending = symbols_in(*expressions)
        while pending:
            symbol = pending.pop()
            if symbol in symbols or symbol not in self.assignments or (stop and self.is_constant(symbol)):
                continue
            symbols.add(symbol)
            pending.extend(symbols_in(self.assignments[symbol]))
        return tuple((symbol, self.assignments[symbol]) for symbol in sorted(symbols, key=self._places.__getitem__))

    def constants(self, functions: Iterable[Function]) -> list[sp.Symbol]:
        """Entries of c: parameters, then constant results that `functions` read, in declared order."""
        wanted = {s for f in functions if CONSTANT in f.arguments for s in f.reads if self.is_constant(s)}
        return [symbol for symbol in (*self.inputs, *self.assignments) if symbol in wanted]


def _negated_atom(expression: Any) -> Any:
    """The atom whose negative an expression is, else zero; a hundred times faster than negating it."""
    negated = expression.is_Mul and len(expression.args) == 2 and expression.args[0] is sp.S.NegativeOne
    return expression.args[1] if negated and expression.args[1].is_Atom else sp.S.Zero


def _sign_free_key(expression: Any) -> Any:
    """A key that an expression shares with its negative and hardly any other expression.

    Looking it up first avoids building most of the negatives.
    """
    if expression.is_Add:
        return frozenset(map(_sign_free_key, expression.args))
    if expression.is_Mul and expression.args[0].is_Number:
        number, *factors = expression.args
        return (*factors,) if number is sp.S.NegativeOne else (*factors, abs(number))
    return expression.args if expression.is_Mul else (expression,)


def symbols_in(*expressions: Any) -> list[sp.Symbol]:
    """List the symbols of expressions in order of appearance (never in hash order)."""
    symbols: dict[sp.Symbol, None] = {}
    pending = [sp.sympify(expression) for expression in reversed(expressions)]
    while pending:
        node = pending.pop()
        if node.is_Symbol:
            symbols[node] = None
        else:
            pending.extend(reversed(node.args))
    return list(symbols)


def eliminate_common_subexpressions(function: Function) -> Function:
    """Eliminate common subexpressions: those that occur twice are named once (`x1`, `x2`, ...)."""
    count: dict[Any, int] = {}
    for expression in _expressions(function):
        for node in _compound_parts(expression):
            count[node] = count.get(node, 0) + 1
    names: dict[Any, sp.Symbol] = {}
    shared: dict[sp.Symbol, sp.Symbol | None] = {}
    body: list[tuple[sp.Symbol, sp.Expr]] = []
    taken = {symbol.name for symbol in (*function.reads, *(symbol for symbol, _ in function.body))}
    count_names = 0

    def visit(expression: Any, whole: bool = False) -> Any:
        """Rewrite with the names given so far; a `whole` right-hand side is named by its assignment."""
        nonlocal count_names
        if expression in names:
            return names[expression]
        if expression.is_Atom:
            return expression
        parts = [visit(arg) for arg in expression.args]
        changed = any(a is not b for a, b in zip(parts, expression.args, strict=True))
        rebuilt = expression.func(*parts) if changed else expression
        if whole or count.get(expression, 0) < 2:
            return rebuilt
        count_names += 1
        while f"x{count_names}" in taken:
            count_names += 1
        names[expression] = new = sp.Symbol(f"x{count_names}", real=True)
        shared[new] = None
        body.append((new, rebuilt))
        return new

    for symbol, expression in function.body:
        rebuilt = visit(expression, whole=True)
        if rebuilt.is_Symbol:
            names[symbol] = rebuilt  # the result has a name already
            if rebuilt in shared:
                shared[rebuilt] = shared[rebuilt] or symbol
        else:
            names[expression] = symbol
            body.append((symbol, rebuilt))
    results = tuple(
        Result(r.name, r.labels, r.units, tuple(visit(sp.sympify(e)) for e in r.expressions)) for r in function.results
    )
    return replace(function, body=tuple(body), results=results, shared=shared)


def _expressions(function: Function) -> Iterator[Any]:
    for _, expression in function.body:
        yield expression
    for result in function.results:
        yield from map(sp.sympify, result.expressions)


def _compound_parts(expression: Any) -> Iterator[Any]:
    """Yield the nodes worth a name: no atoms, negated atoms, conditions or reciprocals."""
    pending = [expression]
    while pending:
        node = pending.pop()
        if node.is_Atom:
            continue
        pending.extend(node.args)
        if not (node.is_Relational or (node.is_Pow and node.exp == -1) or _negated_atom(node) is not sp.S.Zero):
            yield node


@dataclass(frozen=True)
class Repeated:
    """Trees, or pairs between them, that are alike: the program has the functions of one.

    name     by which its functions end, `gaps_of_balls`
    members  name of each, and the places of its trees
    rows     of its own vectors, by their letter: for each entry those of the members in the whole one
    """

    name: str
    members: tuple[tuple[Any, ...], ...]
    rows: Mapping[str, tuple[tuple[int, ...], ...]]


@dataclass(frozen=True)
class Program:
    """Result of the derivation: the tape, the functions of the module, constants and tables."""

    scene: Any
    tape: Tape
    functions: tuple[Function, ...]
    constants: tuple[sp.Symbol, ...]
    tables: Mapping[str, Any]
    """Name of a module-level table (COORDINATES, PAIRS, ...) -> its rows."""
    note: str = ""
    """The choice of coordinates and its reason, where they are chosen automatically."""
    names: Mapping[str, str] = field(default_factory=dict)
    """Numbered constant -> its name in words, in the text of the module."""
    units: Mapping[sp.Symbol, str] = field(default_factory=dict)
    """Unit of every input and assignment, once the audit has passed."""
    trees: tuple[Repeated, ...] = ()
    pairs: tuple[Repeated, ...] = ()
    """Kinds of trees and pairs of which one is derived for all; none where each is derived."""

    @cached_property
    def parts(self) -> Mapping[str, str]:
        """Name of each joint, pair, effect and body of the scene -> its kind."""
        bodies = ((name, "body") for name in self.tables.get("BODIES", ()))
        effects = ((name, kind) for name, kind, _ in self.tables.get("EFFECTS", ()))
        marked = ((part, kind) for part, kind, *_ in self.tables.get("LANDMARKS", ()))
        return dict((*bodies, *effects, *marked, *self.tables.get("PAIRS", ())))

    def entries(self, symbol: sp.Symbol) -> list[str]:
        """Names of a constant's entries: its own, or of a vector's numbered ones."""
        name, width = self.names.get(symbol.name, symbol.name), self.tape.widths.get(symbol)
        return [name] if width is None else [f"{name}_{k + 1}" for k in range(width)]

    def assignments(self) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
        """Yield each assignment that some function computes, once, in order."""
        used = {symbol for function in self.functions for symbol, _ in function.body}
        return ((symbol, e) for symbol, e in self.tape.assignments.items() if symbol in used)


def curves_in(program: Program) -> list[PlanarCurve | PlanarChain]:
    """List the curves that the functions of a program use, in order of appearance."""
    curves: dict[PlanarCurve | PlanarChain, None] = {}
    for function in program.functions:
        for expression in _expressions(function):
            if isinstance(expression, Sampled):  # or drawn
                curves[expression.args[0]] = None
    return list(curves)
