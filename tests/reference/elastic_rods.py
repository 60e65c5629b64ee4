"""Elastic rods by other means: hyperbolic eigenfunctions, kinetic energy by quadrature, finite elements of the slope angle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
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
                lambda x, b=b, s=s, c=size: (b * (np.sinh(b * x) + np.sin(b * x) - s * (np.cosh(b * x) - np.cos(b * x))) / c),
            )
        )  # fmt: skip
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


@dataclass(frozen=True)
class Piece:
    """A rod in a row along X: length [m], mass [kg], bending stiffness [N m^2], whether its start is hinged to what carries it.

    mass and inertia about its own centre, [kg], [kg m^2], of a body at `ahead` [m] beyond its end, hinged there or held.
    """

    length: float
    mass: float
    stiffness: float
    hinged: bool
    load: tuple[float, float, float] = (0.0, 0.0, 0.0)
    swings: bool = False


def frequencies(row: Sequence[Piece], elements: int = 12) -> Any:
    """Angular frequencies of small bending of rods in a row from the ground [rad/s], by Hermite's elements; without those of free motions."""
    parts, count, place = [], 2, (0, 1)
    held = {0} if row[0].hinged else {0, 1}
    for k, piece in enumerate(row):
        h = piece.length / elements
        stiff = piece.stiffness / h**3 * np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
                                                   [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]])  # fmt: skip
        heavy = piece.mass / elements / 420 * np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
                                                        [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]])  # fmt: skip
        if k and piece.hinged:
            place, count = (place[0], count), count + 1
        for _ in range(elements):
            parts.append(((*place, count, count + 1), stiff, heavy))
            place, count = (count, count + 1), count + 2
        m, inertia, ahead = piece.load
        at = (place[0], count) if piece.swings else place
        count += piece.swings
        parts.append((at, np.zeros((2, 2)), np.array([[m, m * ahead], [m * ahead, m * ahead**2 + inertia]])))
    K, M = np.zeros((2, count, count))
    for at, stiff, heavy in parts:
        K[np.ix_(at, at)] += stiff
        M[np.ix_(at, at)] += heavy
    free = [i for i in range(count) if i not in held]
    squares = eigh(K[np.ix_(free, free)], M[np.ix_(free, free)], eigvals_only=True)
    return np.sqrt(squares[squares > 1e-6 * squares[6]])


class BentCoupler:
    """Slider-crank of constant speed whose inextensible coupler bends by any amount, pinned at both ends; SI.

    Quadratic elements of the angle of the centre line against the ground: r' = (cos, sin), strain energy E I angle'^2/2, an end
    that stays on the slider's line by a multiplier. No floating frame, no assumed shapes, no small deflections.
    """

    def __init__(
        self, elements: int, crank: float, length: float, mass: float, stiffness: float, slider: float, pace: float
    ) -> None:
        self.crank, self.length, self.slider, self.pace, count = crank, length, slider, pace, 6
        x, w = np.polynomial.legendre.leggauss(count)
        x, h = (x + 1) / 2, length / elements
        powers = np.arange(1, count + 1)
        within = (x[:, None] ** powers / powers) @ np.linalg.inv(
            np.vander(x, increasing=True)
        )  # from an element's start
        places = elements * count
        self.N, slope, self.W = (np.zeros((places, n)) for n in (2 * elements + 1, 2 * elements + 1, places))
        self.weights = np.tile(w / 2 * h, elements)
        for k in range(elements):
            rows, nodes = slice(k * count, (k + 1) * count), slice(2 * k, 2 * k + 3)
            self.N[rows, nodes] = np.stack([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)], axis=-1)
            slope[rows, nodes] = np.stack([4 * x - 3, 4 - 8 * x, 4 * x - 1], axis=-1) / h
            self.W[rows, rows], self.W[rows, : k * count] = within * h, self.weights[: k * count]
        self.K = stiffness * (slope.T * self.weights) @ slope
        self.masses = mass / length * self.weights
        self.half = np.where(np.arange(places) < places // 2, self.weights, 0)

    def rates(self, t: float, y: Any) -> Any:
        """Rates of the nodes' angles and angular velocities."""
        angle, turning = self.N @ y[: y.size // 2], self.N @ y[y.size // 2 :]
        cosine, sine = np.cos(angle), np.sin(angle)
        base = -self.crank * self.pace**2 * np.array([np.cos(self.pace * t), np.sin(self.pace * t)])
        places = -(self.W * sine) @ self.N, (self.W * cosine) @ self.N
        biases = base[0] - self.W @ (cosine * turning**2), base[1] - self.W @ (sine * turning**2)
        mass = sum((J.T * self.masses) @ J for J in places)
        force = -self.K @ y[: y.size // 2] - sum((J.T * self.masses) @ b for J, b in zip(places, biases, strict=True))
        along, across = -(self.weights * sine) @ self.N, (self.weights * cosine) @ self.N
        mass = mass + self.slider * np.outer(along, along)
        force -= self.slider * (base[0] - self.weights @ (cosine * turning**2)) * along
        held = np.block([[mass, -across[:, None]], [across, np.zeros((1, 1))]])
        right = np.append(force, self.weights @ (sine * turning**2) - base[1])
        return np.concatenate([y[y.size // 2 :], np.linalg.solve(held, right)[:-1]])

    def run(self, times: Any) -> Any:
        """Position of the slider and sag of the middle (2, n), from a straight coupler with the speeds of a rigid one at angle 0."""
        nodes = self.N.shape[1]
        start = np.repeat([0.0, -self.crank * self.pace / self.length], nodes)
        run = solve_ivp(self.rates, (0, times[-1]), start, "DOP853", t_eval=times, rtol=1e-7, atol=1e-10)
        angles = self.N @ run.y[:nodes]
        end, half = (np.array([w @ np.cos(angles), w @ np.sin(angles)]) for w in (self.weights, self.half))
        sag = (end[0] * half[1] - end[1] * half[0]) / np.hypot(*end)
        return self.crank * np.cos(self.pace * np.asarray(times)) + end[0], sag
