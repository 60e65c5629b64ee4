"""Mass on a belt, which sticks and slips.

A mass m = 1 kg on a spring k = 100 N/m is pressed onto a belt by N = 10 N. The belt moves at v_b = 50 mm/s; the mass starts at x = 0 at rest.

    m x'' = -k x - F,    s = x' - v_b,    mu_s = .3, mu_k = .2

`belt_set`: F = mu_k N sign(s) where s is not 0, and |F| <= mu_s N where it is. The motion is one of arcs, w^2 = k/m, x_k = mu_k N/k, x_s = mu_s N/k:
it slips, x = x_k (1 - cos w t), until x' = v_b; sticks, x' = v_b, until x = x_s; slips as x = x_k + R cos(w t - p) from there, R^2 = (x_s - x_k)^2 +
(v_b/w)^2, for 2 (pi - atan(w (x_s - x_k)/v_b))/w, until x' = v_b at 2 x_k - x_s; and so on. This closed form is the reference.

`belt_3`, `belt_5`, v_s = 1e-3 and 1e-5 m/s: F = N (mu_k + (mu_s - mu_k) exp(-(s/v_S)^2)) tanh(s/v_s), Stribeck's smoothed curve, v_S = 10 mm/s.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import asin, atan2, cos, hypot, pi, sin
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result

TIMES = np.linspace(0, 2, 21)[1:]


@dataclass(frozen=True)
class Belt:
    """Numbers in SI; `smooth` is v_s, or None."""

    smooth: float | None
    mass: float = 1.0
    stiffness: float = 100.0
    load: float = 10.0
    speed: float = 0.05
    kinetic: float = 0.2
    static: float = 0.3
    stribeck: float = 0.01

    def rates(self, t: Any, y: Any, on: Any, m: Any) -> Any:
        x, v = y
        if self.smooth is None:
            (sticks,) = on
            return np.array([v, (1 - sticks) * (self.kinetic * self.load - self.stiffness * x) / self.mass])
        s = v - self.speed
        part = (s / self.stribeck) * (s / self.stribeck)
        rub = self.load * (self.kinetic + (self.static - self.kinetic) * m.exp(-part)) * m.tanh(s / self.smooth)
        return np.array([v, (-self.stiffness * x - rub) / self.mass])

    def gaps(self, t: Any, y: Any, m: Any) -> Any:
        """Return the speed against the belt, at whose zero the mass sticks."""
        return np.array([self.speed - y[1]] if self.smooth is None else [])

    def opens(self, t: Any, y: Any, m: Any) -> Any:
        """Return the distance to where the mass breaks loose."""
        return np.array([y[0] - self.static * self.load / self.stiffness])

    def digits(self) -> Result:
        """Return the closed form."""
        w = (self.stiffness / self.mass) ** 0.5
        middle, most = (mu * self.load / self.stiffness for mu in (self.kinetic, self.static))
        rise, along = most - middle, self.speed / w
        radius, phase = hypot(rise, along), atan2(along, rise)
        slip = 2 * (pi - atan2(rise, along)) / w
        sticks = [asin(self.speed / (w * middle)) / w]
        stuck = [middle * (1 - cos(w * sticks[0]))]  # where it sticks
        loose = []
        while sticks[-1] < TIMES[-1]:
            loose.append(sticks[-1] + (most - stuck[-1]) / self.speed)
            sticks.append(loose[-1] + slip)
            stuck.append(middle - rise)

        def state(t: float) -> tuple[float, float]:
            k = sum(t >= begin for begin in sticks) - 1
            if k < 0:
                return middle * (1 - cos(w * t)), middle * w * sin(w * t)
            if t < loose[k]:
                return stuck[k] + self.speed * (t - sticks[k]), self.speed
            turn = w * (t - loose[k]) - phase
            return middle + radius * cos(turn), -radius * w * sin(turn)

        onsets = np.array([t for t in sticks if t < TIMES[-1]])
        return Result(np.array([state(t) for t in TIMES]), lambda: onsets)


@cache
def belt(smooth: float | None) -> Problem:
    p = Belt(smooth)
    contacts = smooth is None
    return Problem(
        f"belt_{'set' if smooth is None else round(-np.log10(smooth))}",
        f"Mass on a belt, friction {'set-valued' if smooth is None else f'smoothed over {smooth:.0e} m/s'.replace('e-0', 'e-')}",
        "belt",
        p,
        np.zeros(2),
        TIMES,
        p.rates,
        p.gaps,
        int(contacts),
        1,
        longest=1e-3,
        opens=p.opens if contacts else None,
        digits=p.digits if contacts else None,
        remark="Drake and MuJoCo have friction laws of their own, and state none of these."
        + (" An onset is where the mass sticks." if contacts else ""),
    )


PROBLEMS = {f"belt_{name}": lambda v=v: belt(v) for name, v in (("3", 1e-3), ("5", 1e-5), ("set", None))}
