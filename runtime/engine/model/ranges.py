"""Ranges of quantities: as text that reads back exactly, and as the scale on which one is searched.

"0.05..0.5 mm:10"        ten values, equally spaced, ends included
"1e6..1e9 N/m:7 log"     seven values, of equal ratios
"0.05..0.5 mm"           a range to be sampled or searched, "... log" on a logarithmic scale

Values of a range are computed in exact or extended precision and rounded once: 0.05..0.5 mm:10 and :19 share ten.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from decimal import Context, Decimal
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.units import UnitError, parse_unit
from hertzwerk.runtime.system.arrays import Array

ValueWithUnit: TypeAlias = tuple[float, str]  # a number and its unit

MOST = 1_000_000  # values
LARGEST = 300  # power of ten
NUMBER = r"[-+]?(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:[eE][-+]?[0-9]{1,3})?"
_RANGE = re.compile(rf"\s*({NUMBER})\s*\.\.\s*({NUMBER})\s*([^:]*?)\s*(?::\s*([0-9]{{1,9}})\s*)?((?<![^\s0-9])log)?\s*")
_DIGITS = Context(prec=40)
EXPECTED = 'a range "0.05..0.5 mm:10", "1e6..1e9 N/m:7 log", or values "0.1, 0.2, 0.4 mm"'
AT_END = 1e-6  # of a range: nearer to its end a value is at it
KNOWN = 10_000  # values of a range that are kept once they are computed


@dataclass(frozen=True)
class Range:
    """Range of one quantity, ends included, in `unit`; `log`: equal parts are equal ratios.

    A place x in it is a value in half ranges, or the logarithm of one: what is searched.
    """

    low: Fraction | float
    high: Fraction | float
    unit: str
    log: bool

    def __str__(self) -> str:
        ends = "..".join(
            format(Decimal(end.numerator) / Decimal(end.denominator), "g")
            for end in (Fraction(self.low), Fraction(self.high))
        )
        return f"{ends} {self.unit}{' log' if self.log else ''}"

    def at(self, part: Fraction) -> ValueWithUnit:
        """Return the value at a part of the way, 0..1, rounded once."""
        low, high = Fraction(self.low), Fraction(self.high)
        if not self.log:
            return float(low + part * (high - low)), self.unit
        first, last, way = (_DIGITS.divide(x.numerator, x.denominator) for x in (low, high, part))
        rise = _DIGITS.multiply(way, _DIGITS.ln(_DIGITS.divide(last, first)))
        return float(_DIGITS.multiply(first, _DIGITS.exp(rise))), self.unit

    @property
    def scale(self) -> float:
        """Value of one unit of a place: half the range; 1 where places are logarithms."""
        return 1.0 if self.log else float(self.high - self.low) / 2

    def inner(self, value: float) -> float:
        """Return the place of a value."""
        return math.log(value) if self.log else value / self.scale

    def outer(self, x: float) -> float:
        """Return the value of a place, within the range."""
        value = math.exp(x) if self.log else x * self.scale
        return min(max(value, float(self.low)), float(self.high))

    def slope(self, value: float) -> float:
        """Return the change of the value with its place, at a value."""
        return value if self.log else self.scale

    @property
    def bounds(self) -> tuple[float, float]:
        """Places of the ends."""
        return self.inner(float(self.low)), self.inner(float(self.high))

    def at_end(self, value: float) -> bool:
        """Return whether a value lies at an end."""
        x, (low, high) = self.inner(value), self.bounds
        return min(x - low, high - x) <= AT_END * (high - low)


@dataclass(frozen=True)
class RangeValues:
    """Values of a range at equal parts, ends included; each is computed when it is first looked at."""

    range: Range
    count: int
    _known: dict[int, ValueWithUnit] = field(default_factory=dict, compare=False, repr=False)

    def __str__(self) -> str:
        ends, *log = str(self.range).rsplit(" log", 1)
        return f"{ends}:{self.count}{' log' if log else ''}"

    def __len__(self) -> int:
        return self.count

    def __getitem__(self, i: int) -> ValueWithUnit:
        value = self._known.get(i)
        if value is None:
            if not 0 <= i < self.count:
                raise IndexError(i)
            value = self.range.at(Fraction(i, self.count - 1))
            if len(self._known) < KNOWN:
                self._known[i] = value
        return value

    def __iter__(self) -> Iterator[ValueWithUnit]:
        return map(self.__getitem__, range(self.count))


def hypercube(box: Array, count: int, seed: int) -> Array:
    """Return places (count, k) of a Latin hypercube in a box (k, 2)."""
    from scipy.stats import qmc  # slow to import

    low, high = np.transpose(box)
    values: Array = low + qmc.LatinHypercube(len(low), rng=seed).random(count) * (high - low)
    return values


def starts_in(ranges: Sequence[Range], values: Sequence[float], count: int, seed: int) -> Array:
    """Return places (1 + count, k) to search from: of values, and a Latin hypercube.

    values    one of each range, whose middle takes its place where it does not lie within
    """
    own = [
        one.inner(value) if one.low <= value <= one.high else sum(one.bounds) / 2
        for one, value in zip(ranges, values, strict=True)
    ]
    return np.vstack([own, hypercube(np.array([one.bounds for one in ranges]), count, seed)])


def read_range(where: str, text: str, sampled: bool, faults: list[Fault]) -> Range | RangeValues | None:
    """Read a range, or where it is not sampled its values; bad input is appended to `faults`."""
    text = text.replace("−", "-")
    written = _RANGE.fullmatch(text)
    if written is None:
        faults.append(Fault(where, shown(text), EXPECTED))
        return None
    low, high, unit, count, log = written.groups()
    if max(abs(Decimal(end).adjusted()) for end in (low, high)) > LARGEST:
        faults.append(Fault(where, shown(text), f"numbers within 1e{LARGEST}"))
        return None
    span = Range(Fraction(Decimal(low)), Fraction(Decimal(high)), unit or "1", log is not None)
    before = len(faults)
    try:
        parse_unit(span.unit)
    except UnitError as error:
        faults.append(Fault(where, shown(text), EXPECTED, str(error)))
    if not span.low < span.high:
        faults.append(Fault(where, f"{low}..{high}", "the smaller end first"))
    if span.log and not span.low > 0:
        faults.append(Fault(where, shown(text), "ends above zero, as the values have equal ratios"))
    if sampled and count is not None:
        faults.append(Fault(where, shown(text), "a range without a number of values", "sample is the number of points"))
    if not sampled and count is None:
        expected = f'a number of values after it, such as "{text.strip()}:10"'
        faults.append(Fault(where, shown(text), expected, "or sample=200: points within it"))
    elif not sampled and not 2 <= int(count) <= MOST:
        faults.append(Fault(where, f"{count} values", f"2 to {MOST:,}, ends included"))
    if len(faults) > before:
        return None
    return span if sampled else RangeValues(span, int(count))
