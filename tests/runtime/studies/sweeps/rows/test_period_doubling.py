"""Section of a ball on a vibrating table, whose period doubles at an acceleration that is known in closed form."""

import math

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import load, sweep

E, OMEGA, GRAVITY = 0.8, 40 * math.pi, 9.81
DOUBLES = math.sqrt(math.pi**2 * (1 - E**2) ** 2 + 4 * (1 + E**2) ** 2) / (1 + E) ** 2  # largest acceleration, in g
SPEED = math.pi * GRAVITY / OMEGA  # of a flight of one period [m/s]


def table_and_ball():
    """A table of a prescribed sine at 20 Hz under a ball; contacts of 20 us."""
    mass, radius = hd.Parameter("mass", "kg", 0.1), hd.Parameter("radius", "mm", 10)
    table, ball = hd.Body("table", mass=mass), hd.Body("ball", mass=mass)
    joints = (hd.Prismatic("lift", hd.GROUND, table, axis=hd.Y), hd.Prismatic("vertical", hd.GROUND, ball, axis=hd.Y))
    pair = hd.SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=radius, plane=table.at(0, 0, 0), normal=hd.Y)
    damping = hd.laws.exact(e=hd.Parameter("restitution", "1", E))
    frequency, phase = hd.Parameter("frequency", "rad/s", OMEGA), hd.Parameter("phase", "rad", 1)
    effects = (
        hd.Harmonic("shaker", "lift", hd.Parameter("amplitude", "mm", 0.5), frequency, phase),
        hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", GRAVITY), direction=-hd.Y),
        hd.Contact("floor", hd.laws.power(hd.Parameter("stiffness", "N/m", 2.5e9), n=1), damping),
    )
    scales = hd.Scales(length=hd.Parameter("length", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 0.3))
    return load(hd.Scene(hd.Mechanism("vibrating_table", joints, (pair,)), effects, scales))


def test_the_period_doubles_where_it_must():
    """Holmes, J. Sound Vib. 84 (1982) 173: a bounce a period, stable up to DOUBLES; then two unlike ones.

    Each starts from the bounce a period, as a ball at rest on the table is another attractor.
    """
    accelerations = np.array([0.7, 0.9 * DOUBLES, 0.99 * DOUBLES, 1.01 * DOUBLES, 1.05 * DOUBLES])
    amplitudes = accelerations * GRAVITY / OMEGA**2
    phases = np.arccos((1 - E) / (1 + E) * math.pi / accelerations)
    over = {
        "amplitude": [f"{a!r} m" for a in amplitudes.tolist()],
        "phase": [f"{phi!r} rad" for phi in phases.tolist()],
        "vertical.travel": [f"{x!r} m" for x in (0.01 + 1e-7 + amplitudes * np.sin(phases)).tolist()],
    }
    table = sweep(
        table_and_ball(), over, zip=True, parameters={"vertical.speed": f"{SPEED!r} m/s"}, duration="10 s", after="9 s",
        section="floor.gap = 0 falling", histories=["vertical.speed"], tolerance=1e-8,
    )  # fmt: skip
    for row, acceleration, phi in zip(table, accelerations, phases, strict=True):
        actual = table.section.of(row)
        assert len(actual["t"]) in (19, 20, 21)
        first, second = actual["vertical.speed"][:18:2], actual["vertical.speed"][1:18:2]
        if acceleration < DOUBLES:
            assert actual["vertical.speed"] == pytest.approx(-SPEED, rel=2e-3)
            assert (OMEGA * actual["t"] + phi) % (2 * math.pi) == pytest.approx(phi, abs=3e-3)
        else:
            assert abs(first.mean() - second.mean()) > 0.05 * SPEED
            assert max(np.ptp(first), np.ptp(second)) < 0.01 * SPEED
