"""Closed loops without contact, in the plane.

Bodies i of mass m_i and inertia J_i have an angle a_i and a mass centre p_i. Joints make points of two bodies coincide, g(p, a) = 0. With
forces f, G = dg/d(p, a), and the multipliers L,

    M (p'', a'') + G^T L = f,    G (p'', a'') = -G' (p', a')

`squeezer`: Andrews' squeezing mechanism, seven bodies in three loops, driven by a torque for 30 ms. Numbers and start are those of Mazzia, Magherini,
Test Set for Initial Value Problem Solvers (Bari 2008), II-11. The reference is by extrapolation; the published digits, END, are compared with it.

`four_bars_n`: n windows of rods of 1 kg and 1 m (IFToMM benchmark A02), which hang and swing here, so that no position is singular; posts begin
at 4 rad/s. All posts keep one angle q from the vertical, and beams none, so that q'' = -w^2 sin q, w^2 = g (n + (n + 1)/2)/(L (n + (n + 1)/3)),
and with k = q'(0)/(2 w) the motion is sin(q/2) = k sn(w t, k): the reference, in 30 digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from math import pi
from typing import Any, NamedTuple

import mpmath
import numpy as np
from benchmarks.contact.problem import Problem, Result

Pair = tuple[float, float]


class Rod(NamedTuple):
    """Mass [kg], inertia [kg m^2], angle at the start [rad], and angular speed [rad/s]."""

    mass: float
    inertia: float
    angle: float
    speed: float = 0.0


class Joint(NamedTuple):
    """A point of one body on a point of another, from their mass centres [m]; -1 is the ground."""

    first: int
    on_first: Pair
    second: int
    on_second: Pair


@dataclass(frozen=True)
class Loops:
    """Numbers in SI. Bodies are placed by the first joint that names them second; `spring` is (body, point, place, stiffness, length)."""

    rods: tuple[Rod, ...]
    joints: tuple[Joint, ...]
    gravity: float = 0.0  # along -y
    torque: float = 0.0  # on the first body
    spring: tuple[int, Pair, Pair, float, float] | None = None

    @cached_property
    def places(self) -> list[np.ndarray]:
        """Mass centres at the start [m]."""
        found: dict[int, np.ndarray] = {-1: np.zeros(2)}
        angles = [rod.angle for rod in self.rods] + [0.0]
        while len(found) <= len(self.rods):
            for first, on_first, second, on_second in self.joints:
                if first in found and second not in found:
                    found[second] = found[first] + turned(angles[first], on_first) - turned(angles[second], on_second)
        return [found[i] for i in range(len(self.rods))]

    @property
    def start(self) -> np.ndarray:
        """Angles, places, and their rates, the places' by the joints."""
        q = np.concatenate(([rod.angle for rod in self.rods], np.ravel(self.places)))
        n, turning = len(self.rods), np.array([rod.speed for rod in self.rods])
        jacobian, _ = self.constraints(q, np.zeros_like(q))
        moving = np.linalg.lstsq(jacobian[:, n:], -jacobian[:, :n] @ turning, rcond=None)[0]
        return np.concatenate((q, turning, moving))

    @cached_property
    def masses(self) -> np.ndarray:
        return np.array([rod.inertia for rod in self.rods] + [rod.mass for rod in self.rods for _ in range(2)])

    def constraints(self, q: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return G and -G' (p', a')."""
        n = len(self.rods)
        k = 2 * len(self.joints)
        jacobian, right = np.zeros((k, 3 * n), q.dtype), np.zeros(k, q.dtype)
        for row, (first, on_first, second, on_second) in enumerate(self.joints):
            rows = slice(2 * row, 2 * row + 2)
            for body, point, sign in ((first, on_first, 1.0), (second, on_second, -1.0)):
                if body < 0:
                    continue
                x, y = turned(q[body], point)
                jacobian[rows, n + 2 * body : n + 2 * body + 2] = sign * np.eye(2)
                jacobian[rows, body] = sign * -y, sign * x
                right[rows] += sign * u[body] ** 2 * np.array([x, y])
        return jacobian, right

    def forces(self, q: np.ndarray) -> np.ndarray:
        n = len(self.rods)
        found = np.zeros(3 * n, q.dtype)
        found[0] = self.torque
        found[n + 1 :: 2] = [-rod.mass * self.gravity for rod in self.rods]
        if self.spring:
            body, point, place, stiffness, length = self.spring
            arm = np.array(turned(q[body], point))
            between = np.array(place) - q[n + 2 * body : n + 2 * body + 2] - arm
            pull = stiffness * (1 - length / np.hypot(*between)) * between
            found[n + 2 * body : n + 2 * body + 2] += pull
            found[body] += arm[0] * pull[1] - arm[1] * pull[0]
        return found

    def rates(self, t: Any, y: Any, on: Any, m: Any) -> Any:
        q, u = np.split(y, 2)
        jacobian, right = self.constraints(q, u)
        n, k = len(q), len(right)
        matrix = np.zeros((n + k, n + k), q.dtype)
        matrix[range(n), range(n)], matrix[:n, n:], matrix[n:, :n] = self.masses, jacobian.T, jacobian
        return np.concatenate((u, solved(matrix, np.concatenate((self.forces(q), right)))[:n]))

    def gaps(self, t: Any, y: Any, m: Any) -> Any:
        return np.zeros(0)


def turned(angle: float, point: Sequence[float]) -> Pair:
    """Return a vector of a body in the ground's frame."""
    x, y = point
    c, s = np.cos(angle), np.sin(angle)
    return x * c - y * s, x * s + y * c


def solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return the solution of linear equations, in extended precision by elimination with pivots."""
    if matrix.dtype == float:
        return np.linalg.solve(matrix, right)
    rows = np.column_stack((matrix, right))
    for i in range(len(rows)):
        pivot = i + int(np.argmax(np.abs(rows[i:, i])))
        rows[[i, pivot]] = rows[[pivot, i]]
        rows[i, i:] /= rows[i, i]
        below = i + 1 + np.flatnonzero(rows[i + 1 :, i])
        rows[below, i:] -= np.outer(rows[below, i], rows[i, i:])
    for i in range(len(rows) - 1, 0, -1):
        rows[:i, -1] -= rows[:i, i] * rows[i, -1]
    return rows[:, -1]


def relative(angles: Sequence[float]) -> np.ndarray:
    """Return the angles of the squeezer's bodies from those of the source: beta, Theta, gamma, Phi, delta, Omega, epsilon."""
    beta, theta, gamma, phi, delta, omega, epsilon = angles
    return np.array([beta, beta + theta, gamma, delta + phi, delta, epsilon + omega, epsilon])


BEGIN = (
    -0.0617138900142764496358948458001, 0.0, 0.455279819163070380255912382449, 0.222668390165885884674473185609,
    0.487364979543842550225598953530, -0.222668390165885884674473185609, 1.23054744454982119249735015568,
)  # fmt: skip
END = (
    15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304,
    0.5347301163226948, 1.048080741042263,
)  # fmt: skip


@cache
def squeezer() -> Problem:
    masses = (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498)
    inertias = (2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5)
    rr, ra, d, da, ss, sa, sb, sc, sd = 7e-3, 0.92e-3, 28e-3, 11.5e-3, 35e-3, 18.74e-3, 10.43e-3, 18e-3, 20e-3
    e, ea, zt, ta, tb, zf, fa, u, ua, ub = (
        20e-3, 14.21e-3, 40e-3, 23.08e-3, 9.16e-3, 20e-3, 14.21e-3, 40e-3, 12.28e-3, 4.49e-3,
    )  # fmt: skip
    a, b, c = (-69.34e-3, -2.27e-3), (-36.35e-3, 32.73e-3), (14e-3, 72e-3)
    end, ground = (-d + da, 0.0), -1
    joints = (
        Joint(ground, (0.0, 0.0), 0, (-ra, 0.0)),
        Joint(0, (rr - ra, 0.0), 1, (da, 0.0)),
        Joint(ground, b, 2, (-sb, sa)),
        Joint(ground, a, 4, (-ta, -tb)),
        Joint(4, (zt - ta, -tb), 3, (0.0, e - ea)),
        Joint(ground, a, 6, (-ua, ub)),
        Joint(6, (-ua, ub - u), 5, (fa - zf, 0.0)),
        Joint(1, end, 2, (-sb, sa - ss)),
        Joint(1, end, 3, (0.0, -ea)),
        Joint(1, end, 5, (fa, 0.0)),
    )
    rods = tuple(map(Rod, masses, inertias, relative(BEGIN)))
    p = Loops(rods, joints, torque=33e-3, spring=(2, (sd - sb, sa - sc), c, 4530.0, 77.85e-3))
    grid = np.array([0.03])
    return problem("squeezer", "Andrews' squeezing mechanism", p, grid, longest=1e-3)


WINDOW_LENGTH, SPEED, GRAVITY = 1.0, 4.0, 9.81  # m, rad/s, m/s^2


@cache
def four_bars(windows: int) -> Problem:
    """Posts first, then beams; angles are those of the rods against x."""
    n, half, length = windows, WINDOW_LENGTH / 2, WINDOW_LENGTH
    posts = [Rod(1.0, length**2 / 12, -pi / 2, SPEED)] * (n + 1)
    beams = [Rod(1.0, length**2 / 12, 0.0)] * n
    joints = [Joint(-1, (i * length, 0.0), i, (-half, 0.0)) for i in range(n + 1)]
    joints += [Joint(i, (half, 0.0), n + 1 + i, (-half, 0.0)) for i in range(n)]
    joints += [Joint(i + 1, (half, 0.0), n + 1 + i, (half, 0.0)) for i in range(n)]
    grid = np.linspace(0, 2, 11)[1:]

    def swing() -> Result:
        with mpmath.workdps(30):
            w = mpmath.sqrt(mpmath.mpf(GRAVITY) * (n + mpmath.mpf(n + 1) / 2) / (n + mpmath.mpf(n + 1) / 3))
            k = SPEED / (2 * w)
            angles = [
                2 * mpmath.asin(k * mpmath.ellipfun("sn", w * t, k=k)) - mpmath.pi / 2 for t in map(mpmath.mpf, grid)
            ]
        return Result(np.array([[float(q)] * (n + 1) + [0.0] * n for q in angles]))

    p = Loops(tuple(posts + beams), tuple(joints), gravity=GRAVITY)
    return problem(f"four_bars_{n}", f"{n} four-bar windows that swing", p, grid, digits=swing)


def problem(name: str, title: str, physics: Loops, grid: np.ndarray, **more: Any) -> Problem:
    p, n = physics, len(physics.rods)
    return Problem(name, title, "loops", p, p.start, grid, p.rates, p.gaps, 0, n, unit="rad", remark=REMARK, **more)


REMARK = "SciPy takes the equations of all coordinates, and solves for the multipliers at each evaluation."
PROBLEMS = {"squeezer": squeezer, **{f"four_bars_{n}": lambda n=n: four_bars(n) for n in (2, 10)}}
