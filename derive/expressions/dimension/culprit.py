"""Find the symbol with the wrong unit: the one that in another unit makes every expression consistent.

A fault states where two dimensions differ, not which is wrong: `K3*d**3` beside `K1*d` may lack a power of d as well
as have its K3 in the wrong unit. Each symbol is tried in the unit that would repair the fault, in every expression
that contains it, including the definitions and the stored energy of a law: few symbols remain, mostly one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension, DimensionFault, canonical
from hertzwerk.derive.expressions.dimension.tree import Node

SHOWN = 2  # most equally likely culprits that are named


@dataclass(frozen=True)
class Row:
    """One expression, by its fault for given dimensions of the symbols and the powers of a symbol in it."""

    fault: Callable[[Mapping[Any, Dimension]], DimensionFault | None]
    powers: Callable[[Any], Iterable[Any]]


@dataclass(frozen=True)
class Culprit:
    """A symbol, its unit as declared, its dimension, and the one in which all would be consistent."""

    name: str
    text: str
    unit: Dimension
    needed: Dimension

    @property
    def gain(self) -> int:
        """Difference in complexity between its unit and the needed one."""
        return _complexity(self.unit) - _complexity(self.needed)

    @property
    def plausible(self) -> bool:
        """Whether the needed unit is plausible: whole or half powers, or those of named exponents."""
        return all(not e.is_number or (e.is_Rational and e.q <= 2 and abs(e) <= 6) for e in self.needed.exponents)

    def __str__(self) -> str:
        other = "as a number" if self.needed == ONE else f"in {self.needed}"
        return f"{self.name} {other}, not {'a number' if self.unit == ONE else f'in {self.text}'}"


def culprits(
    rows: Sequence[Row], dimensions: Mapping[Any, Dimension], candidates: Mapping[Any, str]
) -> tuple[Culprit, ...]:
    """Symbols for which one other unit makes all rows consistent, the likeliest first.

    `candidates` are symbols with their units as declared. The likeliest is that whose unit becomes the simplest.
    """
    missing = list(
        dict.fromkeys(f.missing for row in rows if (f := row.fault(dimensions)) is not None if f.missing is not None)
    )
    suspects = []
    for symbol, text in candidates.items():
        powers = dict.fromkeys(power for row in rows for power in row.powers(symbol))
        steps = (
            step ** (sign / power) for step in missing for power in powers for sign in (sp.S.One, sp.S.NegativeOne)
        )
        for needed in dict.fromkeys(dimensions[symbol] * step for step in steps):
            if all(row.fault({**dimensions, symbol: needed}) is None for row in rows):
                suspects.append(Culprit(str(symbol), text, dimensions[symbol], needed))
                break
    return tuple(sorted(suspects, key=lambda culprit: -culprit.gain))


def likeliest(suspects: Sequence[Culprit], alone: bool) -> tuple[Culprit, ...]:
    """The equally likely culprits; () where they are too many to name.

    For a single expression (`alone`), one culprit is evidence only if it is unique.
    """
    if alone:
        numeric = all(exponent.is_number for culprit in suspects for exponent in culprit.needed.exponents)
        return tuple(suspects) if len(suspects) == 1 and suspects[0].plausible and numeric else ()
    suspects = [culprit for culprit in suspects if culprit.plausible]
    best = tuple(culprit for culprit in suspects if culprit.gain == suspects[0].gain)
    return best if len(best) <= SHOWN else ()


def sentence(suspects: Sequence[Culprit], subject: str) -> str:
    """Repair by which `subject` becomes consistent."""
    return f"{', or '.join(map(str, suspects))}, makes {subject} consistent"


def powers_in(node: Node, name: Any) -> set[Any]:
    """Powers of a name in a tree and its parts: of d in sqrt(R*d**3) 3 and 3/2."""
    if node.op == "name":
        return {sp.S.One} if node.name == name else set()
    inside = [powers for arg in node.args if (powers := powers_in(arg, name))]
    exponents = set().union(*inside)
    if node.op == "product" and len(inside) > 1:
        exponents |= {sp.Add(*powers) for powers in product(*inside)}
    exponent = {"inverse": sp.S.NegativeOne, "sqrt": sp.S.Half}.get(node.op)
    if node.op == "**" and name not in {part.name for part in node.args[1].walk()}:
        number = node.args[1].number
        exponent = node.args[1].expr if number is None else canonical(number)
    if exponent is not None:
        exponents |= {power * exponent for power in exponents}
    return exponents - {sp.S.Zero}


def _complexity(dimension: Dimension) -> int:
    """Complexity of a dimension: units in its text plus powers, fractional ones counted twice."""
    text = str(dimension)
    powers = re.findall(r"\^\(?[^\s/)]+\)?", text)
    return len(re.findall(r"[A-Za-z]+(?![^(]*n)", text)) + len(powers) + sum("." in power for power in powers)
