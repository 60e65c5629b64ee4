"""Parse unit text (`N/m^1.5`, `kg m^2`, `rpm`, `N/m^n`) and print dimensions in the same form.

A dimension is five exponents over mass, length, time, temperature and electric current (M, L, T, Theta, I); each is a
linear form `rational + sum of rational * name`, so that `N/m^n` with a named exponent is a value like any other. Angles are
dimensionless: the power of an angle in a unit (rad/s and rpm have one, 1/s has none) is its `angle`, which separates
angular speeds from frequencies and does not affect the dimension.

This module imports nothing but the standard library and evaluates no text: input is bounded in size, read by a
recursive descent, and everything else raises `UnitError`, whose message has what was found, what was expected, and
the remedy. Factors are computed with 40 decimal digits and rounded once: mm is the double 0.001, rpm the double
nearest pi/30. Prefixes and unit values: BIPM, The International System of Units, 9th edition (2019), tables 4, 7 and
8.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache

MAX_TEXT = 400  # characters of unit text
MAX_DEPTH = 20  # nested parentheses
MAX_EXPONENT = 100  # of a base unit; also bounds the digits of a fraction below
MAX_DENOMINATOR = 10**12

_DECIMAL = Context(prec=40)
_PI = Decimal("3.141592653589793238462643383279502884197169")


class UnitError(ValueError):
    """Unit text that cannot be read; the message includes a remedy."""


def rational(value: int | float | Fraction) -> Fraction:
    """Nearest small fraction of a number within 1e-12 (1.5 -> 3/2, 0.1 -> 1/10), else its exact value."""
    if isinstance(value, float) and not math.isfinite(value):
        raise UnitError(f"found the exponent {value!r}, expected a finite number")
    exact = Fraction(value)
    small = exact.limit_denominator(1000)
    return small if abs(small - exact) <= Fraction(1, 10**12) else exact


@dataclass(frozen=True)
class Exponent:
    """Normalised linear form `constant + sum of coefficient * name`.

    Names are sorted and distinct, coefficients not zero.
    """

    constant: Fraction = Fraction(0)
    terms: tuple[tuple[str, Fraction], ...] = ()

    def __post_init__(self) -> None:
        total: dict[str, Fraction] = {}
        for name, coefficient in self.terms:
            total[name] = total.get(name, Fraction(0)) + coefficient
        object.__setattr__(self, "constant", Fraction(self.constant))
        object.__setattr__(self, "terms", tuple((name, total[name]) for name in sorted(total) if total[name]))

    @classmethod
    def named(cls, name: str) -> Exponent:
        """The form of a single name."""
        return cls(terms=((name, Fraction(1)),))

    @property
    def names(self) -> tuple[str, ...]:
        """Names in the form, sorted."""
        return tuple(name for name, _ in self.terms)

    def at(self, values: Mapping[str, int | float | Fraction]) -> Exponent:
        """Substitute numbers for the names in `values`."""
        known = sum((c * rational(values[name]) for name, c in self.terms if name in values), self.constant)
        return Exponent(known, tuple(term for term in self.terms if term[0] not in values))

    def __bool__(self) -> bool:
        return bool(self.constant) or bool(self.terms)

    def __add__(self, other: Exponent | int | Fraction) -> Exponent:
        other = _form(other)
        return Exponent(self.constant + other.constant, self.terms + other.terms)

    def __neg__(self) -> Exponent:
        return self * -1

    def __sub__(self, other: Exponent | int | Fraction) -> Exponent:
        return self + _form(other) * -1

    def __mul__(self, other: Exponent | int | Fraction) -> Exponent:
        other = _form(other)
        if self.terms and other.terms:
            raise UnitError(f"found the exponent ({self})*({other}), expected one linear in its names")
        if self.terms:
            self, other = other, self
        return Exponent(self.constant * other.constant, tuple((name, self.constant * c) for name, c in other.terms))

    __radd__ = __add__
    __rmul__ = __mul__

    def __str__(self) -> str:
        text = ""
        for name, coefficient in self.terms:
            size = abs(coefficient)
            text += "-" if coefficient < 0 else "+" if text else ""
            text += f"{size.numerator}*" if size.numerator != 1 else ""
            text += name + (f"/{size.denominator}" if size.denominator != 1 else "")
        if self.constant or not text:
            text += "+" if text and self.constant > 0 else ""
            text += _number_text(self.constant)
        return text


Exponents = tuple[Exponent, Exponent, Exponent, Exponent, Exponent]  # over M, L, T, Theta, I


def _form(value: Exponent | int | Fraction) -> Exponent:
    return value if isinstance(value, Exponent) else Exponent(Fraction(value))


def _number_text(value: Fraction) -> str:
    """Text of a fraction as an exponent: 2, 1.5, 0.25, 1/3."""
    return str(float(value)) if value.denominator != 1 and 10_000 % value.denominator == 0 else str(value)


@dataclass(frozen=True)
class Unit:
    """A unit: its factor to SI (kg, m, s, K, A; rad = 1) and its exponents over M, L, T, Theta, I."""

    factor: float
    exponents: Exponents
    angle: Fraction = field(default=Fraction(0), compare=False)
    """Power of an angle (rad, deg, rev, the turns of rpm) in the unit as written."""

    @property
    def dimensionless(self) -> bool:
        """Whether every exponent is zero (an angle, a ratio)."""
        return not any(self.exponents)

    @property
    def free_names(self) -> tuple[str, ...]:
        """Names in the exponents, sorted."""
        return tuple(sorted({name for exponent in self.exponents for name in exponent.names}))

    def at(self, values: Mapping[str, int | float | Fraction]) -> Unit:
        """Substitute numbers for names: `N/m^n` at n = 1.5 is `N/m^1.5`."""
        return Unit(self.factor, _five(exponent.at(values) for exponent in self.exponents), self.angle)

    def mistaken_for(self, declared: Unit) -> bool:
        """Whether an angular speed stands for a frequency, or the reverse.

        Both are powers of time alone; they differ in the power of an angle.
        """
        mass, length, time, temperature, current = self.exponents
        per_time = not (mass or length or temperature or current or time.terms) and time.constant < 0
        return per_time and self.exponents == declared.exponents and self.angle != declared.angle

    def to_si(self, value: float) -> float:
        """Convert a value to SI: the decimal product rounded once, so that 0.3 mm is the double 0.0003."""
        value = float(value)
        if not math.isfinite(value):
            return value * self.factor
        return float(_DECIMAL.multiply(Decimal(repr(value)), Decimal(repr(self.factor))))

    def __str__(self) -> str:
        return unit_text(self.exponents)


def _five(exponents: Iterable[Exponent]) -> Exponents:
    mass, length, time, temperature, current = exponents
    return mass, length, time, temperature, current


def rate_remedy(unit: Unit, value: float | None = None) -> str:
    """Remedy for an angular speed in place of a frequency, or the reverse (see `Unit.mistaken_for`)."""
    if unit.exponents[2] != Exponent(Fraction(-1)):
        return "name the angle, as in rad/s^2 or rev/s^2" if not unit.angle else "leave the angle out, as in 1/s^2"
    if not unit.angle:
        if value is None:
            return "an angular speed is given in rpm or rad/s"
        rate = unit.to_si(value)
        return f'write "{60 * rate:.6g} rpm" where it counts turns, "{rate:.6g} rad/s" where it counts radians'
    plain = "rpm, deg/s and rad/s are angular speeds, a frequency or a decay is given in 1/s"
    if value is None:
        return plain
    rate = unit.to_si(value)
    return f'{plain}: "{rate / (2 * math.pi):.6g} 1/s" of turns, "{rate:.6g} 1/s" of radians'


# --- known units: symbol -> (word, factor to SI, exponents of M, L, T, Theta, I, takes prefixes) ----------------------

_UNITS: dict[str, tuple[str, Decimal, tuple[int, int, int, int, int], bool]] = {
    "m": ("metre", Decimal(1), (0, 1, 0, 0, 0), True),
    "g": ("gram", Decimal("1e-3"), (1, 0, 0, 0, 0), True),
    "s": ("second", Decimal(1), (0, 0, 1, 0, 0), True),
    "K": ("kelvin", Decimal(1), (0, 0, 0, 1, 0), True),
    "rad": ("radian", Decimal(1), (0, 0, 0, 0, 0), True),
    "A": ("ampere", Decimal(1), (0, 0, 0, 0, 1), True),
    "N": ("newton", Decimal(1), (1, 1, -2, 0, 0), True),
    "Pa": ("pascal", Decimal(1), (1, -1, -2, 0, 0), True),
    "J": ("joule", Decimal(1), (1, 2, -2, 0, 0), True),
    "W": ("watt", Decimal(1), (1, 2, -3, 0, 0), True),
    "V": ("volt", Decimal(1), (1, 2, -3, 0, -1), True),
    "ohm": ("ohm", Decimal(1), (1, 2, -3, 0, -2), True),
    "Ω": ("ohm", Decimal(1), (1, 2, -3, 0, -2), True),
    "H": ("henry", Decimal(1), (1, 2, -2, 0, -2), True),
    "bar": ("bar", Decimal("1e5"), (1, -1, -2, 0, 0), True),
    "P": ("poise", Decimal("0.1"), (1, -1, -1, 0, 0), True),
    "St": ("stokes", Decimal("1e-4"), (0, 2, -1, 0, 0), True),
    "l": ("litre", Decimal("1e-3"), (0, 3, 0, 0, 0), True),
    "L": ("litre", Decimal("1e-3"), (0, 3, 0, 0, 0), True),
    "t": ("tonne", Decimal(1000), (1, 0, 0, 0, 0), False),
    "min": ("minute", Decimal(60), (0, 0, 1, 0, 0), False),
    "h": ("hour", Decimal(3600), (0, 0, 1, 0, 0), False),
    "deg": ("degree", _DECIMAL.divide(_PI, Decimal(180)), (0, 0, 0, 0, 0), False),
    "°": ("degree", _DECIMAL.divide(_PI, Decimal(180)), (0, 0, 0, 0, 0), False),
    "rev": ("revolution", _DECIMAL.multiply(_PI, Decimal(2)), (0, 0, 0, 0, 0), False),
    "rpm": ("revolutions per minute", _DECIMAL.divide(_PI, Decimal(30)), (0, 0, -1, 0, 0), False),
    "%": ("percent", Decimal("0.01"), (0, 0, 0, 0, 0), False),
}
_ANGLES = ("rad", "deg", "°", "rev", "rpm")
_PREFIXES = {"f": -15, "p": -12, "n": -9, "u": -6, "m": -3, "c": -2, "d": -1}
_PREFIXES |= {"da": 1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12}

_OUTSIDE = "expected a unit over mass, length, time, temperature and electric current"
_REFUSED = {
    "Hz": "hertz may count radians or turns: an angular speed is written in rpm (1 Hz of turns is 60 rpm) or rad/s, "
    "another rate in 1/s",
    **dict.fromkeys(
        ("°C", "degC", "celsius"),
        "a Celsius scale has an offset: write the temperature in K (20 degC is 293.15 K), and so a difference of temperatures",
    ),
    **dict.fromkeys(
        ("°F", "degF"), "a Fahrenheit scale has an offset: write the temperature in K (68 degF is 293.15 K)"
    ),
    "C": "a temperature is written in K, an electric charge in A s",
    "mol": f"{_OUTSIDE}, not amount of substance",
    "cd": f"{_OUTSIDE}, not luminous intensity",
}
_WORDS = {word: symbol for symbol, (word, *_) in reversed(_UNITS.items())}
_WORDS |= {"meter": "m", "millimetre": "mm", "millimeter": "mm", "micron": "um", "kilogram": "kg", "sec": "s"}
_COMMON = [*_UNITS, "kg", "mm", "um", "nm", "cm", "km", "ms", "us", "kN", "mN", "kPa", "MPa", "GPa", "kJ", "kW", "mrad"]


@dataclass(frozen=True)
class _Product:
    """Intermediate product of the parser: a factor of 40 digits, and exponents.

    Raises UnitError outside the range of doubles.
    """

    factor: Decimal
    exponents: Exponents
    angle: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if abs(self.factor.adjusted()) > 300:
            raise UnitError("found a unit beyond 1e300 of SI, expected one within the range of a double")
        for exponent in self.exponents:
            for value in (exponent.constant, *(c for _, c in exponent.terms)):
                if abs(value) > MAX_EXPONENT or value.denominator > MAX_DENOMINATOR:
                    raise UnitError(f"found an exponent beyond +-{MAX_EXPONENT} or 12 digits, expected a smaller one")

    def times(self, other: _Product, sign: int) -> _Product:
        operate: Callable[[Decimal, Decimal], Decimal] = _DECIMAL.multiply if sign > 0 else _DECIMAL.divide
        exponents = _five(a + b * sign for a, b in zip(self.exponents, other.exponents, strict=True))
        return _Product(operate(self.factor, other.factor), exponents, self.angle + other.angle * sign)

    def power(self, exponent: Exponent) -> _Product:
        exponents = _Product(Decimal(1), _five(base * exponent for base in self.exponents)).exponents
        if exponent.terms:
            if self.factor != 1:
                raise UnitError(
                    f"found a prefix or a non-SI unit to the power {exponent}, whose factor would depend on "
                    f"{', '.join(exponent.names)}; expected SI there, as in N/m^n"
                )
            return _Product(self.factor, exponents, self.angle * exponent.constant)
        power = _DECIMAL.divide(Decimal(exponent.constant.numerator), Decimal(exponent.constant.denominator))
        if abs(power) * (abs(self.factor.adjusted()) + 1) > 400:
            raise UnitError("found a unit beyond 1e300 of SI, expected one within the range of a double")
        return _Product(_DECIMAL.power(self.factor, power), exponents, self.angle * exponent.constant)


_ONE = _Product(Decimal(1), (Exponent(), Exponent(), Exponent(), Exponent(), Exponent()))


def _lookup(name: str) -> _Product | None:
    """Unit of a symbol with or without prefix; a symbol without prefix has precedence (min, not milli-in)."""
    name = name.replace("µ", "u").replace("μ", "u")  # both code points of micro
    for cut in (0, 1, 2):
        prefix, symbol = name[:cut], name[cut:]
        if symbol in _UNITS and (not cut or (prefix in _PREFIXES and _UNITS[symbol][3])):
            _, factor, exponents, _ = _UNITS[symbol]
            power = Decimal(10) ** _PREFIXES[prefix] if cut else Decimal(1)
            angle = Fraction(int(symbol in _ANGLES))
            return _Product(_DECIMAL.multiply(power, factor), _five(Exponent(Fraction(e)) for e in exponents), angle)
    return None


def _unknown(name: str) -> str:
    """Message for a symbol that is no unit, with similar units."""
    bare = name.replace("µ", "u").replace("μ", "u")
    for symbol, reason in _REFUSED.items():
        if bare == symbol or (bare.endswith(symbol) and bare[: -len(symbol)] in _PREFIXES):
            return f"found {name!r}: {reason}"
    written = re.fullmatch(r"([^\W\d]+)([0-9]+)", name)
    if written and _lookup(written[1]):
        return f"found {name!r}, expected a unit; a power is written {written[1]}^{written[2]}"
    for cut in range(1, len(name)):
        if _lookup(name[:cut]) and _lookup(name[cut:]):
            return f"found {name!r}, expected a unit; a product is written '{name[:cut]} {name[cut:]}'"
    close = [_WORDS[w] for w in difflib.get_close_matches(name.lower().removesuffix("s"), _WORDS, n=1, cutoff=0.8)]
    close += [known for known in _COMMON if known.lower() == name.lower()]
    close += difflib.get_close_matches(name, _COMMON, n=3, cutoff=0.6)
    known = "known are " + " ".join(_UNITS) + " and the prefixes f to T"
    offer = f"did you mean {' or '.join(dict.fromkeys(close))}?" if close else known
    return f"found {name!r}, expected a unit; {offer}"


# --- reading ----------------------------------------------------------------------------------------------------------

_TOKEN = re.compile(
    r"\s*(?:(?P<number>[0-9]+\.?[0-9]*|\.[0-9]+)|(?P<name>°C|[°%]|[^\W\d]\w*)|(?P<mark>\*\*|[-+*/^()]))"
)
_SUPERSCRIPT = re.compile("[⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_PLAIN = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹−·⋅×", "+-0123456789-***")


class _Reader:
    """Recursive-descent parser of unit text.

    `product := power ((* | / | blank) power)*`, `power := atom [^ exponent]`.
    """

    def __init__(self, text: str) -> None:
        text = _SUPERSCRIPT.sub(lambda match: f"^({match[0]})", text).translate(_PLAIN).rstrip()
        self.tokens: list[tuple[str, str]] = []
        self.next = 0
        self.depth = 0
        position = 0
        while position < len(text):
            match = _TOKEN.match(text, position)
            if not match:
                rest = text[position:].strip()[:20]
                raise UnitError(f"found {rest!r}, expected unit symbols, * / ^ ( ) and exponents")
            kind = str(match.lastgroup)
            self.tokens.append((kind, "^" if match[kind] == "**" else match[kind]))
            position = match.end()

    def peek(self) -> tuple[str, str]:
        return self.tokens[self.next] if self.next < len(self.tokens) else ("end", "the end")

    def take(self, *marks: str) -> str:
        """Consume the next token if it is one of the marks; its text, else ""."""
        kind, text = self.peek()
        if kind != "mark" or text not in marks:
            return ""
        self.next += 1
        return text

    def fail(self, expected: str) -> UnitError:
        kind, text = self.peek()
        return UnitError(f"found {text if kind == 'end' else repr(text)}, expected {expected}")

    def close(self) -> None:
        self.depth -= 1
        if not self.take(")"):
            raise self.fail("')'")

    def open(self) -> bool:
        if not self.take("("):
            return False
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise UnitError(f"found more than {MAX_DEPTH} nested parentheses, expected fewer")
        return True

    def product(self) -> _Product:
        total, divided = self.power(), False
        while True:
            if sign := self.take("*", "/"):
                divided = divided or sign == "/"
                total = total.times(self.power(), 1 if sign == "*" else -1)
            elif self.peek()[0] in ("name", "number") or self.peek()[1] == "(":
                if divided:
                    text = self.peek()[1]
                    raise UnitError(
                        f"found {text!r} after a division, which people read both ways; "
                        "expected parentheses: W/(m K) to divide by both, or the divisor last: N s/m"
                    )
                total = total.times(self.power(), 1)
            else:
                return total

    def power(self) -> _Product:
        base = self.atom()
        if not self.take("^"):
            return base
        power = base.power(self.exponent())
        if self.peek() == ("mark", "^"):
            raise self.fail("one exponent; write m^(2*3)")
        return power

    def atom(self) -> _Product:
        kind, text = self.peek()
        if self.open():
            total = self.product()
            self.close()
            return total
        if kind == "name":
            unit = _lookup(text)
            if unit is None:
                raise UnitError(_unknown(text))
            self.next += 1
            return unit
        if kind == "number" and text == "1":
            self.next += 1
            return _ONE
        if kind == "number":
            raise self.fail("a unit; no number but 1 stands in a unit, and a fractional exponent is written m^(3/2)")
        raise self.fail("a unit")

    def exponent(self) -> Exponent:
        sign = -1 if self.take("-", "+") == "-" else 1
        return self.factor() * sign

    def factor(self) -> Exponent:
        kind, text = self.peek()
        if self.open():
            total = self.form()
            self.close()
            return total
        if kind not in ("name", "number") or text in ("%", "°", "°C"):
            raise self.fail("an exponent such as 2, -1.5, (3/2), n or (n+1)")
        self.next += 1
        return Exponent(Fraction(text)) if kind == "number" else Exponent.named(text)

    def form(self) -> Exponent:
        total = Exponent()
        sign = self.take("-", "+") or "+"
        while sign:
            total += self.multiple() * (-1 if sign == "-" else 1)
            sign = self.take("-", "+")
        return total

    def multiple(self) -> Exponent:
        total = self.factor()
        while True:
            if self.take("*") or (self.peek()[0] == "name" and not total.terms):
                total *= self.factor()
            elif self.take("/"):
                divisor = self.factor()
                if divisor.terms or not divisor.constant:
                    raise UnitError(f"found a division by {divisor} in an exponent, expected a number other than 0")
                total *= 1 / divisor.constant
            else:
                return total


def parse_unit(text: str) -> Unit:
    """Parse unit text: `N/m^1.5`, `N/m**(3/2)`, `kg m^2`, `rpm`, `N/m^(n+1)`, `1`. Raises UnitError."""
    if not isinstance(text, str):
        raise UnitError(f"found {text!r}, expected unit text such as 'N/m^1.5' ('1' for a plain number)")
    if len(text) > MAX_TEXT:
        raise UnitError(f"found unit text of {len(text)} characters, expected at most {MAX_TEXT}")
    return _read(text)


@lru_cache(maxsize=4096)
def _read(text: str) -> Unit:
    try:
        reader = _Reader(text)
        if not reader.tokens:
            raise UnitError("found no unit, expected one such as N/m^1.5, or 1 for a plain number")
        product = reader.product()
        if reader.peek()[0] != "end":
            raise reader.fail("the end, or * / ^ and another unit")
    except UnitError as error:
        raise UnitError(f"unit {text!r}: {error}") from None
    return Unit(float(product.factor), product.exponents, product.angle)


_QUANTITY = re.compile(r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(.*)", re.DOTALL)


def parse_quantity(text: str) -> tuple[float, Unit]:
    """Parse a number and its unit: `0.2 mm` -> (0.2, mm), `-3e-4` -> (-3e-4, 1). Raises UnitError.

    `unit.to_si(value)` is the SI value.
    """
    value, unit = split_quantity(text)
    return value, parse_unit(unit)


def split_quantity(text: str) -> tuple[float, str]:
    """Split into a number and the text of its unit, "1" where there is none. Raises UnitError.

    `0.2 mm` -> (0.2, "mm"), `-3 / s` -> (-3, "1/ s").
    """
    if not isinstance(text, str):
        raise UnitError(f"found {text!r}, expected a quantity as text such as '0.2 mm'")
    if len(text) > MAX_TEXT:
        raise UnitError(f"found a quantity of {len(text)} characters, expected at most {MAX_TEXT}")
    match = _QUANTITY.fullmatch(text.replace("−", "-"))
    if not match:
        raise UnitError(f"quantity {text!r}: found no finite number in front, expected one such as 0.2 in '0.2 mm'")
    value, rest = float(match[1]), match[2].strip()
    if not math.isfinite(value):
        raise UnitError(f"quantity {text!r}: found a number beyond the range of a double, expected a finite one")
    if rest.startswith(","):
        raise UnitError(f"quantity {text!r}: found a comma, expected a decimal point: {match[1]}.{rest[1:].strip()}")
    if rest.startswith("*") and not rest.startswith("**"):
        rest = rest[1:] or "*"
    elif rest.startswith("/"):
        rest = "1" + rest
    return value, rest or "1"


# --- printing ---------------------------------------------------------------------------------------------------------


def unit_text(exponents: Exponents) -> str:
    """Text of a dimension in SI, with at most one derived unit: `N/m^1.5`, `N s/m`.

    `parse_unit(unit_text(x)).exponents == x` for every x (within the bounds of the parser).
    """
    mass, length, time, temperature, current = exponents
    parts: list[tuple[str, Exponent]] = []
    if mass.terms or not mass.constant:
        parts.append(("kg", mass))
    else:
        p = mass.constant
        per_mass = time.constant / p
        if -2 <= per_mass <= -1 and length == Exponent(2 * p):
            symbol, per_length, per_time = "J", 2, -2
        elif -2 <= per_mass <= -1 and length == Exponent(-p):
            symbol, per_length, per_time = "Pa", -1, -2
        elif -2 <= per_mass <= -1:
            symbol, per_length, per_time = "N", 1, -2
        elif per_mass == -3:
            symbol, per_length, per_time = "W", 2, -3
        else:
            symbol, per_length, per_time = "kg", 0, 0
        parts.append((symbol, mass))
        length, time = length - p * per_length, time - p * per_time
    # after a derived unit time comes first (N s/m), among base units length does (kg m^2/s)
    rest = [("m", length), ("s", time)] if parts[0][0] == "kg" else [("s", time), ("m", length)]
    parts += [*rest, ("K", temperature), ("A", current)]
    above = [_power_text(symbol, e) for symbol, e in parts if e and not _below(e)]
    below = [_power_text(symbol, -e) for symbol, e in parts if e and _below(e)]
    if not below:
        return " ".join(above) or "1"
    return f"{' '.join(above) or '1'}/{below[0] if len(below) == 1 else '(' + ' '.join(below) + ')'}"


def time_text(seconds: float, digits: int = 6) -> str:
    """Return a time as text: in milliseconds below a second."""
    return f"{seconds:.{digits}g} s" if abs(seconds) >= 1 else f"{seconds * 1e3:.{digits}g} ms"


def _below(exponent: Exponent) -> bool:
    """Whether a power belongs in the denominator: its leading coefficient is negative."""
    return (exponent.terms[0][1] if exponent.terms else exponent.constant) < 0


def _power_text(symbol: str, exponent: Exponent) -> str:
    text = str(exponent)
    if text == "1":
        return symbol
    simple = re.fullmatch(r"[0-9.]+|\w+|\(.*\)", text) is not None and text.count("(") <= 1
    return f"{symbol}^{text}" if simple else f"{symbol}^({text})"
