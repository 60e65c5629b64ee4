"""Interval extension of SX functions: bounds of their results over boxes of arguments.

Moore, Interval Analysis (1966). Bounds are rigorous but for rounding, and wider than the range where an argument occurs more than once.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import casadi as ca

LARGEST = 1e30  # bound of what is not bounded
RISING = {ca.OP_SQRT, ca.OP_EXP, ca.OP_ATAN, ca.OP_TANH, ca.OP_FMIN, ca.OP_FMAX, ca.OP_TWICE, ca.OP_ADD, ca.OP_ASSIGN}

Interval: TypeAlias = tuple[Any, Any]  # lower and upper bound (SX)


def interval_extension(function: Any, results: int = 1) -> Any:
    """Return the function (lower bounds of all arguments, upper bounds) -> lower bounds of results.

    results    how many of the SX function, the first ones
    """
    lower, upper = ([ca.SX.sym(f"x{i}", function.size1_in(i)) for i in range(function.n_in())] for _ in range(2))
    lowest = [ca.SX.zeros(function.size1_out(i)) for i in range(results)]
    work: dict[int, Interval] = {}
    for k in range(function.n_instructions()):
        operation, places = function.instruction_id(k), function.instruction_input(k)
        target = function.instruction_output(k)
        if operation == ca.OP_INPUT:
            work[target[0]] = lower[places[0]].nz[places[1]], upper[places[0]].nz[places[1]]
        elif operation == ca.OP_CONST:
            work[target[0]] = (ca.SX(function.instruction_constant(k)),) * 2
        elif operation == ca.OP_CALL:
            work |= {place: (ca.SX(-LARGEST), ca.SX(LARGEST)) for place in target if place >= 0}
        elif operation != ca.OP_OUTPUT:
            work[target[0]] = _bounds(operation, [work[place] for place in places])
        elif target[0] < results:
            lowest[target[0]].nz[target[1]] = work[places[0]][0]
    return ca.Function("lowest", [*lower, *upper], ca.cse(lowest))


def _bounds(operation: int, arguments: list[Interval]) -> Interval:
    """Return the bounds of the result of an operation."""
    (low, high), *others = arguments
    (low1, high1) = others[0] if others else arguments[0]
    if operation == ca.OP_SQRT:
        low, high = ca.fmax(low, 0), ca.fmax(high, 0)
    if operation in RISING:
        lows, highs = [low, low1][: len(arguments)], [high, high1][: len(arguments)]
        return _value(operation, lows), _value(operation, highs)
    if operation == ca.OP_SUB:
        return low - high1, high - low1
    if operation == ca.OP_NEG:
        return -high, -low
    if operation == ca.OP_MUL:
        return _extremes([low * low1, low * high1, high * low1, high * high1])
    if operation in (ca.OP_SQ, ca.OP_FABS):
        least, most = _extremes([_value(operation, [low]), _value(operation, [high])])
        return ca.if_else(low * high > 0, least, 0), most
    if operation in (ca.OP_SIN, ca.OP_COS):
        middle, half = _value(operation, [(low + high) / 2]), (high - low) / 2
        return ca.fmax(middle - half, -1), ca.fmin(middle + half, 1)
    if operation in (ca.OP_DIV, ca.OP_INV):
        numerator = (low, high) if others else (ca.SX(1), ca.SX(1))
        least, most = _extremes([x / y for x in numerator for y in (low1, high1)])
        bounded = low1 * high1 > 0
    else:
        least = most = _value(operation, [low, low1][: len(arguments)])
        bounded = ca.logic_and(low == high, low1 == high1)
    return ca.if_else(bounded, least, -LARGEST), ca.if_else(bounded, most, LARGEST)


def _value(operation: int, x: list[Any]) -> Any:
    return (ca.SX.unary if len(x) == 1 else ca.SX.binary)(operation, *x)


def _extremes(values: list[Any]) -> Interval:
    least = most = values[0]
    for value in values[1:]:
        least, most = ca.fmin(least, value), ca.fmax(most, value)
    return least, most
