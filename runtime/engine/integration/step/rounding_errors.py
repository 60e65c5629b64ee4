"""Running rounding error analysis of derived functions, such as gaps and gap rates.

A gap is a difference of coordinates and lengths and so no more accurate than their last digits, however small it is:
spheres that touch 1 m from the origin do so within 1e-16 m. No decision on a gap may require more. Every operation
adds the rounding of its result to its arguments' propagated errors, to first order. Higham, Accuracy and Stability of
Numerical Algorithms, 2nd ed. (2002), section 3.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import compress
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import NearModel, gaps_by_kind
from hertzwerk.runtime.engine.integration.many_pairs.vectorised import Alike, Kind, alike
from hertzwerk.runtime.engine.integration.step.layout import event_layouts
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

EPS = 2.0**-52
EXACT = {ca.OP_NEG, ca.OP_FABS, ca.OP_TWICE, ca.OP_CONST, ca.OP_ASSIGN}  # operations that round nothing
# inputs of `gaps` that are rounded themselves, being integrated: q, u; time and constants are taken as exact
STATE = (1, 2)


def time_rounding(t: Any, rate: Any) -> Any:
    """Return a bound on what a quantity of this rate changes by within the rounding of the time."""
    return 4 * EPS * ca.fabs(rate) * ca.fabs(t)


@per_model
def gap_rounding(model: EngineModel) -> Any:
    """Return the function (t, q, u, c) -> rounding bounds of gap (k) [m] and gap_rate (k) [m/s]."""
    if isinstance(model, NearModel):
        return model.at_places("rounding", _of_kinds(gaps_by_kind(model.whole), STATE), (0, 0))
    gaps = model.function("gaps")
    if event_layouts(model).kind is ca.MX:
        arguments = gaps.sx_in()
        items = zip(*map(ca.vertsplit, gaps.call(arguments)), strict=True)
        grouped = alike(arguments, [ca.vertcat(*parts) for parts in items])
        if grouped is not None:
            symbols = gaps.mx_in()
            return ca.Function("rounding", symbols, _of_kinds(grouped, STATE).results(symbols))
    return bounds(gaps, STATE)


def _of_kinds(grouped: Alike, rounded: tuple[int, ...]) -> Alike:
    """Return the items with rounding error bounds of their results: of a kind, not of each."""
    arguments = grouped.shared.sx_in()
    values = grouped.shared(*arguments)
    shared = ca.Function("shared", arguments, [ca.vertcat(values, bounds(grouped.shared, rounded)(*arguments))])
    part_of, n = [part for part, entries in enumerate(grouped.taken) for _ in entries], values.numel()
    kinds = []
    for kind in grouped.kinds:
        leaves, places = ca.SX.sym("leaves", kind.one.numel_in(0)), kind.leaves[0]
        of_shared = [i for i, place in enumerate(places) if place >= len(part_of)]
        errors = ca.SX.zeros(leaves.numel())
        errors[of_shared] = known = ca.SX.sym("errors", len(of_shared))
        for i, place in enumerate(places):
            if place < len(part_of) and part_of[place] in rounded:
                errors[i] = EPS * ca.fabs(leaves[i])
        (found_errors,) = _propagated(kind.one, [leaves], [errors])
        one = ca.Function("one", [ca.vertcat(leaves, known)], [ca.cse(found_errors)])
        kinds.append(Kind(kind.items, [[*of, *(of[i] + n for i in of_shared)] for of in kind.leaves], one))
    return Alike(grouped.taken, shared, kinds)


def bounds(function: Any, rounded: tuple[int, ...]) -> Any:
    """Return the function of the same arguments -> rounding error bounds of an SX function's results.

    rounded: the inputs that are rounded themselves.
    """
    arguments = [ca.SX.sym(f"x{i}", function.sparsity_in(i)) for i in range(function.n_in())]
    errors = [EPS * ca.fabs(part) if i in rounded else ca.SX.zeros(part.sparsity()) for i, part in enumerate(arguments)]
    return ca.Function("rounding", arguments, ca.cse(_propagated(function, arguments, errors)))


def _propagated(function: Any, arguments: list[Any], known: list[Any]) -> list[Any]:
    """Return rounding error bounds of an SX function's results from its arguments and bounds of theirs."""
    errors = [ca.SX.zeros(function.sparsity_out(i)) for i in range(function.n_out())]
    work: dict[int, Sequence[Any]] = {}
    for k in range(function.n_instructions()):
        operation, places, target = (
            function.instruction_id(k),
            function.instruction_input(k),
            function.instruction_output(k),
        )
        if operation == ca.OP_INPUT:
            work[target[0]] = arguments[places[0]].nz[places[1]], known[places[0]].nz[places[1]]
        elif operation == ca.OP_OUTPUT:
            errors[target[0]].nz[target[1]] = work[places[0]][1]
        elif operation == ca.OP_CALL:
            called = function.instructions_sx()[k].which_function()
            results = _call(called, [work[place] for place in places])
            work |= {place: entry for place, entry in zip(target, results, strict=True) if place >= 0}
        elif operation == ca.OP_CONST:
            work[target[0]] = ca.SX(function.instruction_constant(k)), ca.SX(0)
        else:
            values, bounds_of = zip(*(work[place] for place in places), strict=True)
            inexact = tuple(not bound.is_zero() for bound in bounds_of)
            work[target[0]] = _operation(operation, inexact).call([*values, *compress(bounds_of, inexact)])
    return errors


@cache
def _operation(operation: int, inexact: tuple[bool, ...]) -> Any:
    """Return the function of an operation's arguments and errors -> its value and the bound of its error.

    Errors are those of the inexact arguments alone.
    """
    x, known = ([ca.SX.sym(f"x{i}") for i in range(n)] for n in (len(inexact), sum(inexact)))
    result = (ca.SX.unary if len(x) == 1 else ca.SX.binary)(operation, *x)
    error = ca.SX(0) if operation in EXACT else EPS * ca.fabs(result)
    for argument, bound in zip(compress(x, inexact), known, strict=True):
        error = error + ca.fabs(ca.gradient(result, argument)) * bound
    return ca.Function("operation", [*x, *known], [result, error])


def _call(called: Any, arguments: list[Sequence[Any]]) -> list[tuple[Any, Any]]:
    """Return the values of a function that is called, and the bounds of their errors.

    Such a function finds the nearest point of a curve, or looks up a table. It is taken to be as exact
    as its results and arguments rounded once.
    """
    values, known = (ca.vertcat(*(pair[part] for pair in arguments)) for part in (0, 1))
    own = [ca.SX.sym(f"x{i}", called.sparsity_in(i)) for i in range(called.n_in())]
    x, y = ca.vertcat(*(part.nz[:] for part in own)), ca.vertcat(*(part.nz[:] for part in called.call(own)))
    # CasADi embeds the derivative as a call too: that of a table looks its interval up, which no expression can
    results, slopes = ca.Function("call", [x], [y, ca.jacobian(y, x)])(values)
    moved = known + EPS * ca.fabs(values) * (known > 0)
    error = EPS * ca.fabs(results) + ca.fabs(slopes) @ moved
    return [(results[j], error[j]) for j in range(results.numel())]
