"""Newton's cradle with a linear law of contact.

Five steel spheres of mass m and radius R on rigid strings of length L, pivots 2.04 R apart. With the angles q_i, centres
p_i = (2.04 R i + L sin q_i, -L cos q_i), and D_i = |p_{i+1} - p_i|, unit vectors n_i along p_{i+1} - p_i, penetrations d_i = 2 R - D_i,

    (m L^2 + 2/5 m R^2) q_i'' = -m g L sin q_i + (F_{i-1} n_{i-1} - F_i n_i) . L (cos q_i, sin q_i),    F_i = K d_i where d_i > 0, else 0.

R = 20 mm, density 7800 kg/m^3, L = .25 m, K = 1e6 N/m, g = 9.81 m/s^2; q_0 = -30 degrees at rest, the others hang. For .6 s: a transfer of four
impacts, and the last sphere returns. Samples are 12 equal parts of the time.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import pi, radians
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem


@dataclass(frozen=True)
class Cradle:
    """Numbers in SI."""

    spheres: int = 5
    radius: float = 0.02
    density: float = 7800.0
    length: float = 0.25
    spacing: float = 1.02  # of the pivots, in diameters
    stiffness: float = 1e6
    gravity: float = 9.81
    angle: float = radians(-30)

    @property
    def mass(self) -> float:
        return 4 / 3 * pi * self.density * self.radius**3

    @property
    def inertia(self) -> float:
        """Of a sphere about its centre [kg m^2]."""
        return 2 / 5 * self.mass * self.radius**2

    @property
    def pitch(self) -> float:
        """Distance of two pivots [m]."""
        return 2 * self.spacing * self.radius

    def apart(self, y: Any, m: Any) -> tuple[Any, Any, Any, Any, Any]:
        """Return vectors between neighbours, their lengths, sines and cosines."""
        q = y[: self.spheres]
        s, c = m.sin(q), m.cos(q)
        x, z = self.pitch + self.length * (s[1:] - s[:-1]), self.length * (c[:-1] - c[1:])
        return x, z, m.sqrt(x * x + z * z), s, c

    def rates(self, t: Any, y: Any, on: Any, m: Any) -> Any:
        x, z, distance, s, c = self.apart(y, m)
        push = on * (self.stiffness * (2 * self.radius - distance)) / distance
        right = push * (x * c[1:] + z * s[1:])  # on the right one of a pair
        left = push * (x * c[:-1] + z * s[:-1])
        none = np.zeros(1)
        moment = np.concatenate((none, right)) - np.concatenate((left, none)) - self.mass * self.gravity * s
        whole = self.mass * self.length**2 + self.inertia
        return np.concatenate((y[self.spheres :], self.length * moment / whole))

    def gaps(self, t: Any, y: Any, m: Any) -> Any:
        return self.apart(y, m)[2] - 2 * self.radius

    @property
    def start(self) -> np.ndarray:
        return np.array([self.angle] + [0.0] * (2 * self.spheres - 1))


@cache
def cradle() -> Problem:
    p = Cradle()
    return Problem(
        "cradle",
        "Newton's cradle, linear law",
        "cradle",
        p,
        p.start,
        np.linspace(0, 0.6, 13)[1:],
        p.rates,
        p.gaps,
        p.spheres - 1,
        p.spheres,
        unit="rad",
        longest=2e-4,
    )


PROBLEMS = {"cradle": cradle}
