"""Numerical evaluation of a tape at random states, to test a user's pair where symbols do not decide."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.numeric import numeric
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.program.program import symbols_in

STATES = 4
BENT = 1e-4  # amplitude of each shape of a rod beside the length: small enough for a dozen, as their equations suppose
UNDEFINED = (ValueError, TypeError, ZeroDivisionError, OverflowError, NotImplementedError)
"""Errors of an evaluation where an expression has no value, or a function that mpmath lacks, such as a curve's."""
_TRIES, _CORRECTIONS = 20, 30

Numbers = dict[Any, Any]


class Probe:
    """Random states of a mechanism: parameters at their defaults, coordinates and speeds of order 1.

    Lengths are of the order of `length` [m].
    """

    def __init__(self, kinematics: Kinematics, length: float) -> None:
        self.kin = kinematics
        self.length = length
        self._random = random.Random(1)
        self._functions: dict[tuple[Any, ...], tuple[list[Any], Callable[..., Sequence[Any]]]] = {}

    def values(self, wanted: Sequence[Any], inputs: Mapping[Any, Any]) -> list[float]:
        """Values of expressions on the tape, with the values `inputs`; inputs of a run are random."""
        symbols, function = self._function(tuple(wanted))
        known = dict(inputs)
        for symbol in symbols:
            if symbol not in known:
                known[symbol] = symbol.si if isinstance(symbol, Parameter) else self._random.uniform(-1, 1)
        return [float(value) for value in function(*(known[symbol] for symbol in symbols))]

    def _function(self, wanted: tuple[Any, ...]) -> tuple[list[Any], Callable[..., Sequence[Any]]]:
        """Inputs of expressions on the tape, and their function of these, with the assignments that it needs."""
        if wanted not in self._functions:
            needed, named = set().union(*map(symbols_in, wanted)), []
            for symbol, value in reversed(self.kin.tape.assignments.items()):
                if symbol in needed:
                    named.append((symbol, value))
                    needed.update(symbols_in(value))
            inputs = sorted(needed.difference(symbol for symbol, _ in named), key=str)
            self._functions[wanted] = inputs, numeric(inputs, wanted, named[::-1])
        return self._functions[wanted]

    def states(self, *, parameters: bool = False) -> Iterator[Numbers]:
        """Yield random coordinates and speeds, of drives too, without end; parameters near their defaults."""
        freedoms = [(freedom, self.kin.motion_of_freedom(freedom)) for freedom in self.kin.mechanism.freedoms]
        while True:
            state: Numbers = {self.kin.t: self._random.uniform(0, 1)}
            for freedom, (coordinates, speeds) in freedoms:
                size = {"slide": self.length, "bend": BENT * self.length}.get(freedom.kind, 1.0)
                self._fill(state, coordinates, size)
                self._fill(state, speeds, size)
            for parameter in self.kin.scene.dimensions if parameters else ():
                state[parameter] = (parameter.si or 1.0) * self._random.uniform(0.7, 0.9)
            yield self._normalised(state)

    def _fill(self, state: Numbers, symbols: Any, size: float) -> None:
        for symbol in symbols:
            if isinstance(symbol, sp.Symbol) and not isinstance(symbol, Parameter) and symbol != self.kin.t:
                state[symbol] = self._random.uniform(-size, size)

    def _normalised(self, state: Numbers) -> Numbers:
        for freedom in self.kin.mechanism.freedoms:
            if freedom.kind == "ball":
                quaternion, _ = self.kin.motion_of_freedom(freedom)
                norm = sum(state[symbol] ** 2 for symbol in quaternion) ** 0.5
                state.update({symbol: state[symbol] / norm for symbol in quaternion})
        return state

    def states_where(self, expression: Any, rate: Any, target: float) -> list[Numbers]:
        """States at which an expression with the given rate has the value `target`, by Newton's method.

        Several, or none where the iteration finds none.
        """
        source = self.states()
        states = (self._solve(next(source), expression, rate, target) for _ in range(_TRIES))
        return [state for state in states if state is not None][:STATES]

    def _solve(self, state: Numbers, expression: Any, rate: Any, target: float) -> Numbers | None:
        still = dict.fromkeys(self.kin.u, 0.0)
        for _ in range(_CORRECTIONS):
            try:
                (value,) = self.values([expression], state)
                slopes = [self.values([rate], {**state, **still, symbol: 1.0})[0] for symbol in self.kin.u]
                drift = self.values([rate], {**state, **still})[0]
                slopes = [slope - drift for slope in slopes]
                if abs(value - target) <= 1e-12 * self.length:
                    return state
                length = sum(slope**2 for slope in slopes)
                step = {s: (target - value) * k / length for s, k in zip(self.kin.u, slopes, strict=True)}
                moves = self.values(list(self.kin.rates), {**state, **step})
            except UNDEFINED:
                return None  # not defined there
            state = dict(state)
            for symbol, move in zip(self.kin.q, moves, strict=True):
                state[symbol] += move
            state = self._normalised(state)
        return None
