"""Something known of a law from elsewhere, as a check of its record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

DIGITS, EXACT, QUADRATURE, LIMIT, TYPED = (
    "digits from elsewhere", "exact relation", "quadrature", "another law in a limit", "closed form typed again",
)  # fmt: skip
INDEPENDENT = (DIGITS, EXACT, QUADRATURE, LIMIT)
SHARP = mpf("1e-12")  # relative, of closed forms at 40 digits


@dataclass(frozen=True)
class Evidence:
    """One thing known of a law: what kind of thing, in words, and a check of a record, which raises AssertionError where it does not hold.

    `of_the_force` is False for what is about a range, a limit, an exponent or a stored energy alone.
    """

    kind: str
    what: str
    check: Callable[[Any], None]
    of_the_force: bool = True


def same(found: Any, expected: Any, within: Any = SHARP) -> None:
    """Assert that numbers agree to a relative tolerance; nothing is nothing."""
    assert abs(found - expected) <= within * abs(expected), (mp.nstr(found, 15), mp.nstr(expected, 15))
