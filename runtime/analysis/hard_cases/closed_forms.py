"""Closed forms of contacts in double precision, SI.

v0: approach speed, F = K d^n (1 + h v/v0), m the effective mass. Sources: Johnson, Contact Mechanics (1985), section
11.4, for the elastic impact; Hunt and Crossley, J. Appl. Mech. 42 (1975) 440, for the relation between h and the
restitution; the damped oscillator for K d + c v.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from scipy.optimize import brentq


def flores(e: float) -> float:
    """Return the factor h of Flores' law."""
    return 8 * (1 - e) / (5 * e)


def restitution_out(h: float) -> float:
    """Return the restitution by a factor h: root of h (1 + e) = ln((1 + h)/(1 - h e)).

    Independent of n, K, masses and speed; solved for x = -ln(1 - h e).
    """
    if h == 0:
        return 1.0
    x = _root(lambda x: math.log1p(h) + x - h + math.expm1(-x), 1e-9 * h, 1 + h)
    return -math.expm1(-x) / h


def depth(K: float, n: float, m: float, v0: float, h: float = 0.0) -> float:
    """Return the largest penetration of an impact without other forces."""
    share = (h - math.log1p(h)) / h**2 if h else 0.5
    return float(((n + 1) * m * v0**2 * share / K) ** (1 / (n + 1)))


def depth_under_gravity(K: float, n: float, m: float, v0: float, g: float) -> float:
    """Return the largest penetration of an elastic impact on the floor.

    Root of K d^(n+1)/(n+1) = m v0^2/2 + m g d.
    """
    free = depth(K, n, m, v0)
    return _root(lambda d: K * d ** (n + 1) / (n + 1) - m * v0**2 / 2 - m * g * d, free, 10 * free)


def thornton(R: float, m: float, modulus: float, pressure: float, fall: float, g: float) -> tuple[float, float]:
    """Return largest penetration [m] and returned energy [J] of a ball that falls on a plane and yields.

    By Thornton's law, with the effective modulus and the limiting pressure [Pa], gravity counted to the largest penetration.
    """
    d_y = R * (math.pi * pressure / (2 * modulus)) ** 2
    F_y, slope = math.pi**3 * R**2 * pressure**3 / (6 * modulus**2), math.pi * pressure * R

    def left(x: float) -> float:
        return 2 * F_y * d_y / 5 + F_y * x + slope * x**2 / 2 - m * g * (fall + d_y + x)

    x = _root(left, 0, R)
    force, depth = F_y + slope * x, d_y + x
    return depth, 2 / 5 * force * depth * force / (4 / 3 * modulus * math.sqrt(R) * depth**1.5)


def static_penetration(K: float, n: float, m: float, g: float) -> float:
    """Return the penetration that carries the weight."""
    return float((m * g / K) ** (1 / n))


def damping_ratio(e: float) -> float:
    """Return xi of K d + 2 xi sqrt(K m) v with restitution e where the contact ends at d = 0."""
    return -math.log(e) / math.hypot(math.pi, math.log(e))


def oscillator(K: float, m: float, xi: float, *, pulls: bool) -> tuple[float, float]:
    """Return (restitution, duration) of a contact K d + 2 xi sqrt(K m) v.

    It ends at d = 0 after its force has pulled, or, unless `pulls`, at zero force.
    """
    root = math.sqrt(1 - xi**2)
    phase = math.pi if pulls else math.pi - 2 * math.asin(xi)
    return math.exp(-xi * phase / root), phase / (root * math.sqrt(K / m))


def peak_of_oscillator(K: float, m: float, c: float, v0: float, load: float) -> float:
    """Return the largest force K d + c v of a contact that begins with speed v0 under a constant load."""
    rate = complex(-c / 2 / m, math.sqrt(K / m - (c / 2 / m) ** 2))  # d = load/K + Re(size exp(rate t))
    size = complex(-load / K, (-v0 - rate.real * load / K) / rate.imag)
    t = (math.pi / 2 - cmath.phase(size * rate**3)) % math.pi / rate.imag  # the third derivative of d is zero
    return load - m * (size * rate**2 * cmath.exp(rate * t)).real


def _root(f: Callable[[float], float], low: float, high: float) -> float:
    return float(brentq(f, low, high, xtol=1e-300, rtol=1e-15))
