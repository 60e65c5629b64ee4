"""Balls that fall onto a plane.

Ball i of mass m and radius R is at the height z_i. With the penetration d_i = R - z_i,

    m z_i'' = -m g + F_i,    F_i = K d_i (1 + c d_i')  where d_i > 0,  else 0,    K = 1e5 N/m, c = .2 s/m, g = 9.81 m/s^2.

`ball`: one ball of 1 kg and .1 m, at rest at z = .5 m, for 2 s. Samples are those of 40 whose gap is above 5 mm: away from impacts.

`balls_n`: n balls of 1 kg and 50 mm at rest beside each other, .12 m apart, ball i at z = .1 + .003 i + .01 (i mod 4) m, for .5 s. Any two may touch
(n (n + 1)/2 pairs), and none of them does, so that the solution is that of each ball alone. Peers that state bodies have all pairs; peers that
state equations have only these n, which favours them. Samples are 10 equal parts of the time: an impact near them shifts positions, not speeds.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem

from reference.scenes import FALLING


@dataclass(frozen=True)
class Balls:
    """Numbers in SI."""

    radius: float
    places: tuple[tuple[float, float, float], ...]
    mass: float = FALLING.mass
    stiffness: float = FALLING.stiffness
    loss: float = FALLING.loss
    gravity: float = FALLING.gravity

    def rates(self, t: Any, y: Any, on: Any, m: Any) -> Any:
        n = len(self.places)
        z, v = y[:n], y[n:]
        depth = self.radius - z
        push = on * (self.stiffness * depth * (1 - self.loss * v))
        return np.concatenate((v, push / self.mass - self.gravity))

    def gaps(self, t: Any, y: Any, m: Any) -> Any:
        return y[: len(self.places)] - self.radius

    @property
    def start(self) -> np.ndarray:
        return np.array([z for *_, z in self.places] + [0.0] * len(self.places))


def problem(name: str, title: str, physics: Balls, grid: np.ndarray, **more: Any) -> Problem:
    n = len(physics.places)
    return Problem(name, title, "balls", physics, physics.start, grid, physics.rates, physics.gaps, n, n, **more)


ALONE = "heyoka, SciPy and Exudyn have the contacts with the plane alone. The others have those of any two balls too."


@cache
def ball() -> Problem:
    physics = Balls(radius=0.1, places=((0.0, 0.0, 0.5),))
    return problem("ball", "A ball that bounces for 2 s", physics, np.linspace(0, 2, 41)[1:], margin=5e-3)


@cache
def balls(n: int) -> Problem:
    physics = Balls(radius=FALLING.radius, places=tuple(map(FALLING.place, range(n))))
    return problem(
        f"balls_{n}", f"{n} balls that fall onto a plane", physics, np.linspace(0, 0.5, 11)[1:], remark=ALONE
    )


PROBLEMS = {"ball": ball, **{f"balls_{n}": lambda n=n: balls(n) for n in (4, 12, 40, 100)}}
