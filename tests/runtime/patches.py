"""A flat disc that slides and spins on its whole face, and the forces of its friction as published."""

import math

from scipy.special import ellipe, ellipk

import hertzwerk.derive as hd
from hertzwerk.derive.laws import kelvin_voigt, power

DISC, RIM, GRAVITY, MU = 2.0, 0.1, 9.81, 0.2  # kg, m, m/s^2, 1


def flat_disc(*more, **coordinates):
    """A disc, m R^2/2, that carries its weight on its whole face."""
    p = hd.Parameter
    mass, rim, radius = p("mass", "kg", DISC), p("rim", "m", RIM), p("radius", "m", 0.01)
    gravity, stiffness = p("gravity", "m/s^2", GRAVITY), p("stiffness", "N/m", 1e5)
    tray, disc = hd.Body("tray", 0), hd.Body("disc", mass, (mass * rim**2 / 4, mass * rim**2 / 2, mass * rim**2 / 4))
    joints = (hd.Planar("floor_plane", hd.GROUND, tray, normal=hd.Y), hd.Prismatic("up", tray, disc, axis=hd.Y))
    return hd.Scene(
        hd.Mechanism(
            "flat_disc", joints, (hd.SphereOnPlane("floor", disc.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y),)
        ),
        (
            hd.Gravity("gravity", gravity, direction=-hd.Y),
            hd.Contact("floor", power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.2))), *more, hd.EnergyLedger(),
        ),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=rim),
        hd.Start(
            position={"up": radius - mass * gravity / stiffness},
            speed={"floor_plane.x": p("slide", "m/s", 1), "floor_plane.angle": p("spin", "rad/s", 10)},
        ),
        **coordinates,
    )  # fmt: skip


def shares(ratio):
    """Force in mu N and moment in mu N R at v/(R w), by the elliptic integrals as published."""
    m = ratio**2 if ratio < 1 else 1 / ratio**2
    E, K = ellipe(m), ellipk(m)
    if ratio < 1:
        force, moment = ((m + 1) * E + (m - 1) * K) / ratio, (4 - 2 * m) * E + (m - 1) * K
    else:
        e2 = ratio**2
        force = (e2 + 1) * E - (e2 - 1) * K
        moment = ratio * ((4 - 2 * e2) * E + (2 * e2 - 5 + 3 * m) * K)
    return 4 / (3 * math.pi) * force, 4 / (9 * math.pi) * moment
