"""Slider-crank with a clearance at the pin between rod and slider.

The crank of radius r turns at constant speed, phi = w t. The state is (theta, x, theta', x'), the angle of the rod and the travel of the slider:

    (J + m_r s^2) theta'' = m_r s (r w^2 sin(phi - theta) - g cos theta) - F l n.u' - f (l t.u' + R_pin)
    m_s x''               = F n_x - f n_y,        u' = (-sin theta, cos theta),  t = (-n_y, n_x)

With the eccentricity e = (r cos phi + l cos theta - x, r sin phi + l sin theta), n = e/|e| and d = |e| - c, where d > 0

    F = K d^(3/2) (1 + h d'/v0),  h = 3 (1 - .9^2)/4,  v0 = d' at the onset, at least 1 mm/s;    f = mu F tanh(v_t/v_s),

v_t = t.e' + R_pin theta'. Numbers are in `tests/reference/slider_crank.py`: 5000 rpm, c = .5 mm, K = 6.61e10 N/m^1.5. The problem
`crank` has no friction, `crank_friction` has mu = .1, v_s = .1 m/s.

The reference is that file's, in quadruple precision; two of its runs differ by less than 1e-16. Impacts amplify errors about tenfold each,
so the motion is compared for 10 ms. The angle counts times the length of the rod.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result

from reference.slider_crank import SliderCrank, reference

TIMES = np.array([k / 1000 for k in range(1, 11)])
LEAST = 1e-13  # m; it keeps powers and quotients finite at 0, and changes an impulse by less than 1e-16


@dataclass(frozen=True)
class Crank(SliderCrank):
    """Numbers in SI."""

    friction: bool = False

    def eccentricity(self, t: Any, y: Any, m: Any) -> tuple[Any, ...]:
        """Return sine and cosine of the rod's angle, the eccentricity and its rate."""
        theta, x, turning, speed = y
        s, c, sine, cosine = m.sin(theta), m.cos(theta), m.sin(self.w * t), m.cos(self.w * t)
        ex, ey = self.r * cosine + self.l * c - x, self.r * sine + self.l * s
        vx = -self.r * self.w * sine - self.l * turning * s - speed
        vy = self.r * self.w * cosine + self.l * turning * c
        return s, c, sine * c - cosine * s, ex, ey, vx, vy

    def rates(self, t: Any, y: Any, on: Any, m: Any) -> Any:
        touching, per_v0 = on
        s, c, sine, ex, ey, vx, vy = self.eccentricity(t, y, m)
        size = m.sqrt(ex * ex + ey * ey + LEAST * LEAST)  # e is 0 at the start
        nx, ny = ex / size, ey / size
        d, closing = size - self.c, nx * vx + ny * vy
        push = self.K * d * (d * d + LEAST * LEAST) ** 0.25 * (1 + self.h * per_v0 * closing)
        moment, force = push * self.l * (ny * c - nx * s), push * nx
        if self.friction:
            rub = self.mu * push * m.tanh((nx * vy - ny * vx + self.R_pin * y[2]) / self.v_s)
            moment, force = moment + rub * (self.l * (nx * c + ny * s) + self.R_pin), force - rub * ny
        moment, force = (m.where(touching, each, 0.0) for each in (moment, force))
        moment = self.m_rod * self.s * (self.r * self.w**2 * sine - self.g * c) - moment
        return np.array([y[2], y[3], moment / (self.J_rod + self.m_rod * self.s**2), force / self.m_slider])

    def gaps(self, t: Any, y: Any, m: Any) -> Any:
        """Return (c^2 - |e|^2)/(2 c), which is -d near the surface."""
        *_, ex, ey, _, _ = self.eccentricity(t, y, m)
        return np.array([(self.c * self.c - ex * ex - ey * ey) / (2 * self.c)])

    def latched(self, t: Any, y: Any) -> np.ndarray:
        """Return 1/v0."""
        *_, ex, ey, vx, vy = self.eccentricity(t, y, np)
        return np.array([1 / max((ex * vx + ey * vy) / (np.hypot(ex, ey) + LEAST), self.floor)])

    def digits(self) -> Result:
        """Return the reference in quadruple precision, rounded."""
        stored = reference(self.friction)
        onsets = np.array([hit.onset for hit in stored.impacts if hit.onset < TIMES[-1]])
        return Result(np.array([stored.states[t] for t in TIMES]), lambda: onsets)


@cache
def crank(friction: bool) -> Problem:
    p = Crank(friction=friction)
    return Problem(
        "crank_friction" if friction else "crank",
        f"Slider-crank with a clearance at the pin, {'with' if friction else 'without'} friction",
        "crank",
        p,
        np.array(p.start),
        TIMES,
        p.rates,
        p.gaps,
        1,
        2,
        longest=1e-5,
        weights=np.array([p.l, 1.0]),
        latched=p.latched,
        digits=p.digits,
    )


PROBLEMS = {"crank": lambda: crank(False), "crank_friction": lambda: crank(True)}
