"""Elastic rods by other means: eigenfunctions by hyperbolic functions and SciPy's roots, kinetic energy by quadrature."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
from scipy.optimize import brentq

POINTS, WEIGHTS = ((x + 1) / 2 if i == 0 else x / 2 for i, x in enumerate(np.polynomial.legendre.leggauss(60)))
Shape = tuple[Callable[[Any], Any], Callable[[Any], Any]]
"""A shape and its slope, functions of x/L."""


def root(ends: tuple[str, str], k: int) -> float:
    """beta L of a uniform rod: clamped-free, clamped-clamped, pinned-pinned."""
    if ends == ("pinned", "pinned"):
        return k * np.pi
    sign = 1 if "free" in ends else -1
    near = (k - sign * 0.5) * np.pi
    return float(brentq(lambda b: np.cos(b) + sign / np.cosh(b), near - 0.5, near + 0.5, xtol=1e-15))


def shapes(ends: tuple[str, str], count: int, cubics: bool) -> list[Shape]:
    """Textbook eigenfunctions, of a pinned start less their slope there, after two cubics."""
    found: list[Shape] = []
    if cubics:
        found = [
            (lambda x: 3 * x**2 - 2 * x**3, lambda x: 6 * x - 6 * x**2),
            (lambda x: x**3 - x**2, lambda x: 3 * x**2 - 2 * x),
        ]
    for k in range(1, count + 1):
        b = root(ends, k)
        if ends == ("pinned", "pinned"):
            found.append((lambda x, b=b: np.sin(b * x) - b * x, lambda x, b=b: b * np.cos(b * x) - b))
            continue
        sign, size = (1, 2) if "free" in ends else (-1, np.sqrt(2))
        s = (np.cosh(b) + sign * np.cos(b)) / (np.sinh(b) + sign * np.sin(b))
        found.append(
            (
                lambda x, b=b, s=s, c=size: (np.cosh(b * x) - np.cos(b * x) - s * (np.sinh(b * x) - np.sin(b * x))) / c,
                lambda x, b=b, s=s, c=size: (
                    b * (np.sinh(b * x) + np.sin(b * x) - s * (np.cosh(b * x) - np.cos(b * x))) / c
                ),
            )
        )
    return found


def sections(derived: Any, rod: Any, q: Any) -> list[Any]:
    """Positions of the sections at `POINTS`, from the pose of the rod's start."""
    names = [name for name, _ in derived.COORDINATES]
    length = value_of(derived, rod.length)
    of = shapes(rod.ends, rod.modes, rod.cubics)
    sides = ["", "z_"][: len(rod.stiffnesses)]
    amplitudes = [[q[names.index(f"{rod.name}.bend_{side}{i + 1}")] for i in range(len(of))] for side in sides]
    origin, rotation = pose(derived, rod.start, q)
    x, w = np.polynomial.legendre.leggauss(30)
    found = []
    for at in POINTS:
        slopes = np.array([slope((x + 1) / 2 * at) for _, slope in of])
        squares = (slopes * w / 2 * at) @ slopes.T / length
        short = sum(squares[i, j] * a[i] * a[j] for a in amplitudes for i in range(len(of)) for j in range(len(of))) / 2
        aside = [sum(shape(at) * a[i] for i, (shape, _) in enumerate(of)) for a in amplitudes]
        found.append(origin + rotation @ ca.vertcat(length * at - short, aside[0], aside[1] if len(aside) > 1 else 0))
    return found


def kinetic_energy(derived: Any, rods: Any, bodies: Any) -> ca.Function:
    """Kinetic energy T(q, u) by velocities of the sections, and of rigid bodies with principal inertias."""
    q, u = ca.SX.sym("q", derived.nq), ca.SX.sym("u", derived.nu)
    dq = derived.results("coordinate_rates", {"q": q, "u": u})[0]
    energy = 0
    for rod in rods:
        mass = value_of(derived, rod.mass)
        for place, weight in zip(sections(derived, rod, q), WEIGHTS, strict=True):
            energy += mass * weight * ca.sumsqr(ca.jtimes(place, q, dq)) / 2
        energy += value_of(derived, rod.start.inertia[0]) * _spin(derived, rod.start, q, dq)[0] ** 2 / 2
    for body in bodies:
        origin, rotation = pose(derived, body, q)
        centre = origin + rotation @ ca.DM([value_of(derived, x) for x in body.centre])
        energy += value_of(derived, body.mass) * ca.sumsqr(ca.jtimes(centre, q, dq)) / 2
        spin = _spin(derived, body, q, dq)
        energy += sum(value_of(derived, J) * spin[i] ** 2 for i, J in enumerate(body.inertia)) / 2
    return ca.Function("T", [q, u], [energy])


def pose(derived: Any, body: Any, q: Any) -> tuple[Any, Any]:
    """Origin and rotation matrix of a body."""
    positions, rotations = derived.results("poses", {"q": q, "t": 0.0})
    k = derived.BODIES.index(body.name)
    return positions[3 * k : 3 * k + 3], ca.reshape(rotations[9 * k : 9 * k + 9], 3, 3).T


def value_of(derived: Any, parameter: Any) -> float:
    """Value of a parameter, or a number."""
    values = {name: value for (name, *_), value in zip(derived.PARAMETERS, derived.p, strict=True)}
    return float(values.get(str(parameter), 0.0))


def _spin(derived: Any, body: Any, q: Any, dq: Any) -> Any:
    """Angular velocity in the body's axes."""
    _, rotation = pose(derived, body, q)
    turned = rotation.T @ ca.reshape(ca.jtimes(ca.reshape(rotation, 9, 1), q, dq), 3, 3)
    return ca.vertcat(turned[2, 1], turned[0, 2], turned[1, 0])
