"""Onset of yield of a Hertzian point contact: depth, force and approach speed at first yield.

Yield begins below the surface, where the largest pressure reaches 1.60 Y for nu = 0.3, Y the yield strength in simple
tension (von Mises, and within 1 % Tresca). Johnson, Contact Mechanics (1985), sections 3.4, 4.2, 6.1 and 11.5.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

YIELD_PRESSURE = sp.Rational(8, 5)
"""Largest pressure at first yield over the yield strength in simple tension [1], for nu = 0.3."""


def yield_depth(modulus: Any, radius: Any, pressure: Any) -> Any:
    """Return the penetration [m] at which Hertz's largest pressure [Pa] is reached; E* [Pa], R [m]."""
    return radius * (sp.pi * pressure / (2 * modulus)) ** 2


def yield_force(modulus: Any, radius: Any, pressure: Any) -> Any:
    """Return the force [N] at which Hertz's largest pressure [Pa] is reached; E* [Pa], R [m]."""
    return sp.pi**3 * radius**2 * pressure**3 / (6 * modulus**2)


def yield_speed(modulus: Any, radius: Any, pressure: Any, mass: Any) -> Any:
    """Return the approach speed [m/s] of an impact that just reaches a largest pressure [Pa].

    The mass is the effective one, m1 m2/(m1 + m2) [kg]. The kinetic energy is that stored by Hertz's law at the depth of yield, (2/5) F d.
    """
    work = 2 * yield_force(modulus, radius, pressure) * yield_depth(modulus, radius, pressure) / 5
    return sp.sqrt(2 * work / mass)
