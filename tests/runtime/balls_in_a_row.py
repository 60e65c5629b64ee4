"""Rows of equal spheres that touch, integrated independently: extrapolated midpoint rule in extended precision, in displacements from touching.

Bulirsch and Stoer's method: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.9. No events: steps over the
kinks of the forces are rejected until they are as short as the tolerance wants them.
"""

import numpy as np

Real = np.longdouble
SEQUENCE = (2, 4, 6, 8, 10, 12)
MASS, STIFFNESS = Real(1), Real(1e8)  # kg, N/m^n


def row(count, duration, *, exponent=1.5, preload=0.0, last_speed=0.0, tolerance=1e-14):
    """Displacements from touching [m] and speeds [m/s], of each sphere (count), after `duration` [s]; the first is struck at 1 m/s."""
    n, force = Real(exponent), Real(preload)
    x, v = np.zeros(count, Real), np.zeros(count, Real)
    if preload:
        x = -np.arange(count) * (force / STIFFNESS) ** (1 / n)
    v[0], v[-1] = 1, last_speed
    length, t, h, end = Real(1e-4), Real(0), Real(1e-7), Real(duration)
    scale = np.concatenate([np.full(count, length), np.ones(count, Real)])

    def rate(y):
        overlap = np.maximum(y[: count - 1] - y[1:count], 0)
        pushed = np.concatenate([[force], STIFFNESS * overlap**n, [force]])
        return np.concatenate([y[count:], (pushed[:-1] - pushed[1:]) / MASS])

    y = np.concatenate([x, v])
    while t < end:
        last = h >= end - t
        h = end - t if last else h
        new, error = _extrapolated(rate, y, h)
        size = float(np.max(np.abs(error) / scale)) / tolerance
        if size <= 1:
            t, y = end if last else t + h, new
        h *= min(3.0, max(0.2, 0.8 * max(size, 1e-10) ** (-1 / 11)))
    return y[:count], y[count:]


def _extrapolated(rate, y, h):
    """One step of order 12, and what the last extrapolation changed."""
    first, columns = rate(y), []
    for k, parts in enumerate(SEQUENCE):
        small = h / parts
        before, now = y, y + small * first
        for _ in range(parts - 1):
            before, now = now, before + 2 * small * rate(now)
        columns.append((before + now + small * rate(now)) / 2)  # Gragg's smoothing
        for j in range(k - 1, -1, -1):
            columns[j] = columns[j + 1] + (columns[j + 1] - columns[j]) / ((Real(parts) / SEQUENCE[j]) ** 2 - 1)
        if k == len(SEQUENCE) - 2:
            last = columns[0]
    return columns[0], columns[0] - last
