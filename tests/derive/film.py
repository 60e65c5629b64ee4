"""Reynolds' equation by quadrature: what a film does to pin and bush, in the two limits that have closed forms; see `test_lubrication`."""

from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

ETA, PIN, LENGTH, C = 0.08, 0.0099, 0.012, 1e-4  # Pa s, m
GAUSS = np.polynomial.legendre.leggauss(120)


def thickness(e, angle):
    return C - e[0] * np.cos(angle) - e[1] * np.sin(angle)


def source(e, rate, spins):
    """Right-hand side of Reynolds' equation [Pa m], 6 eta (sum of the spins) dh/dangle + 12 eta dh/dt, and its integral over the angle."""

    def value(angle):
        wedge = 6 * ETA * spins * (e[0] * np.sin(angle) - e[1] * np.cos(angle))
        return wedge - 12 * ETA * (rate[0] * np.cos(angle) + rate[1] * np.sin(angle))

    def integral(angle):
        wedge = -6 * ETA * spins * (e[0] * np.cos(angle) + e[1] * np.sin(angle))
        return wedge - 12 * ETA * (rate[0] * np.sin(angle) - rate[1] * np.cos(angle))

    return value, integral


def short_pressure(e, rate, spins):
    """Pressure integrated over the length [N/m] by angle, and the angle where the film that bears begins."""
    value, _ = source(e, rate, spins)
    around = 0.1234 + np.linspace(0, 2 * np.pi, 721)
    signs = np.sign(value(around))
    rising = next(
        i for i in range(720) if signs[i] > 0 >= signs[i + 1]
    )  # the source turns negative, the pressure positive
    begin = brentq(value, around[rising], around[rising + 1], xtol=1e-15)
    return lambda angle: -value(angle) * LENGTH**3 / (12 * thickness(e, angle) ** 3), begin


def long_pressure(e, rate, spins):
    """The same; the equation integrated once in closed form, then as a Fourier series, up to the constant that makes both edges zero."""
    _, integral = source(e, rate, spins)
    n = 4096
    grid = 2 * np.pi * np.arange(n) / n
    flow, cubes = integral(grid), thickness(e, grid) ** -3
    slope = np.fft.rfft(PIN**2 * (flow - np.sum(flow * cubes) / np.sum(cubes)) * cubes) / n
    slope[1:] *= 2
    orders = np.arange(len(slope))
    keep = np.abs(slope) > 1e-17 * np.abs(slope).max()
    orders, terms = orders[keep & (orders > 0)], slope[keep & (orders > 0)]
    series = terms / (1j * orders)

    def pressure(angle):
        return np.real(np.exp(1j * np.multiply.outer(angle, orders)) @ series)

    def apart(angle):
        return float(pressure(angle + np.pi) - pressure(angle))

    around = 0.1234 + np.linspace(0, 2 * np.pi, 181)
    edges = [brentq(apart, a, b, xtol=1e-15) for a, b in pairwise(around) if apart(a) * apart(b) < 0]
    begin = next(a for a in edges if pressure(a + np.pi / 2) > pressure(a))
    return lambda angle: LENGTH * (pressure(angle) - pressure(begin)), begin


def by_quadrature(law, e, rate, spin_pin=0.0, spin_bush=0.0):
    """Force and moment on the pin, force and moment on the bush, each about its centre: pressure over the half that bears, shear over the whole."""
    pressure, begin = {"short_bearing": short_pressure, "long_bearing": long_pressure}[law](
        e, rate, spin_pin + spin_bush
    )
    nodes, weights = begin + np.pi / 2 * (GAUSS[0] + 1), np.pi / 2 * GAUSS[1]
    bearing = pressure(nodes)
    assert bearing.min() > 0
    force = [-PIN * np.sum(weights * bearing * side(nodes)) for side in (np.cos, np.sin)]
    # of the shear h/2 dp/ds on both surfaces, by parts: -p/2 dh/ds
    slopes = e[0] * np.sin(nodes) - e[1] * np.cos(nodes)
    tilted = PIN / 2 * np.sum(weights * bearing * slopes)
    around = 2 * np.pi * np.arange(2000) / 2000
    dragged = ETA * PIN**3 * LENGTH * (spin_pin - spin_bush) * np.mean(2 * np.pi / thickness(e, around))
    return np.array([*force, tilted - dragged, -force[0], -force[1], tilted + dragged])
