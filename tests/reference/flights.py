"""How mechanisms with clearance reach their first impact: until then every body moves by itself, freely or as a pendulum. Equations by hand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

G, C = 9.81, 0.5e-3  # m/s^2; clearance [m]
R, L = 0.05, 0.12  # crank, rod or coupler [m]

Apart = Callable[[float], complex]  # from bush centre to pin centre [m], by time [s]


def first(pins: dict[str, Apart], until: float) -> tuple[str, float, float]:
    """The pin that first reaches its bush, when [s], and how fast it comes [m/s]."""

    def onset(apart: Apart) -> float:
        times = np.linspace(0, until, 400)
        touched = next((i for i, t in enumerate(times) if abs(apart(t)) > C), None)
        if touched is None:
            return np.inf
        return float(brentq(lambda t: abs(apart(t)) - C, times[touched - 1], times[touched], xtol=1e-18))

    name, t = min(((name, onset(apart)) for name, apart in pins.items()), key=lambda found: found[1])
    h = 1e-7
    return name, t, (abs(pins[name](t + h)) - abs(pins[name](t - h))) / (2 * h)


def slider_crank(*, floating: bool, rpm: float = 5000.0) -> tuple[str, float, float]:
    """Crank from angle 0, rod and slider as in the ideal mechanism; `floating`: the crank falls too."""
    w = rpm * 2 * np.pi / 60
    turning = -w * R / L  # of the rod

    def fall(t: float) -> complex:
        return -0.5j * G * t**2

    def crank(t: float) -> complex:
        return fall(t) if floating else 0j

    def rod(t: float, along: float) -> complex:
        return R + L / 2 + 0.5j * R * w * t + fall(t) + (along - L / 2) * np.exp(1j * turning * t)

    pins: dict[str, Apart] = {
        "crank_pin": lambda t: crank(t) + R * np.exp(1j * w * t) - rod(t, 0.0),
        "slider_pin": lambda t: rod(t, L) - (R + L),
    }
    if floating:
        pins["main_bearing"] = crank
    return first(pins, 2e-3)


def four_bar(rpm: float = 1000.0) -> tuple[str, float, float]:
    """The coupler a pendulum on the crank's pin, the rocker one on the ground, from the ideal mechanism at crank angle 0."""
    w, k, base = rpm * 2 * np.pi / 60, 0.10, 0.13
    of_coupler, of_rocker = 0.21 * L / 2 / (2.5e-4 + 0.21 * L**2 / 4), 0.18 * k / 2 / (1.5e-4 + 0.18 * k**2 / 4)
    tip = intersection(R, L, k, base)
    start = np.angle(tip - R), np.angle(tip - base)
    # w R i + x (tip - R) i = y (tip - base) i
    x, y = np.linalg.solve([[(tip - R).real, -(tip - base).real], [(tip - R).imag, -(tip - base).imag]], [-w * R, 0])

    def rates(t: float, s: np.ndarray) -> list[float]:
        pull = w**2 * R * np.exp(1j * w * t) - 1j * G  # what the coupler feels per mass on its moving pivot
        return [s[2], s[3], of_coupler * (np.conj(np.exp(1j * s[0])) * pull).imag, -of_rocker * G * np.cos(s[1])]

    flight = solve_ivp(rates, (0, 0.02), [*start, x, y], method="DOP853", rtol=1e-13, atol=1e-14, dense_output=True).sol

    def apart(t: float) -> complex:
        coupler, rocker = flight(t)[:2]
        return complex(R * np.exp(1j * w * t) + L * np.exp(1j * coupler) - base - k * np.exp(1j * rocker))

    return first({"rocker_pin": apart}, 0.02)


def intersection(crank: complex, coupler: float, rocker: float, base: float) -> complex:
    """Where coupler and rocker meet, on the left of the way from the crank's pin to the base."""
    way = base - crank
    cosine = (coupler**2 + abs(way) ** 2 - rocker**2) / (2 * coupler * abs(way))
    return crank + coupler * way / abs(way) * (cosine + 1j * np.sqrt(1 - cosine**2))
