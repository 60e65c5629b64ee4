"""Balls that roll and slide on a plane in space, which is level or inclined towards X; a wheel under a block."""

import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import coulomb, kelvin_voigt, power

MASS, RADIUS, GRAVITY, STIFFNESS = 0.17, 0.03, 9.81, 1e6  # kg, m, m/s^2, N/m


def dry(mu_k=0.2, mu_s=None):
    """Set-valued Coulomb friction."""
    return coulomb(hd.Parameter("mu_k", "1", mu_k), hd.Parameter("mu_s", "1", mu_k if mu_s is None else mu_s))


def ball(law, *, share=0.4, turns=True, **coordinates):
    """A ball on a plane through the origin, gravity turned by `slope` towards X; its inertia is a share of m r^2.

    One that does not turn is carried along X, Z and Y: a particle.
    """
    mass, radius, slope = (
        hd.Parameter("mass", "kg", MASS), hd.Parameter("radius", "m", RADIUS), hd.Parameter("slope", "rad", 0),
    )  # fmt: skip
    gravity, stiffness = hd.Parameter("gravity", "m/s^2", GRAVITY), hd.Parameter("stiffness", "N/m", STIFFNESS)
    inertia = (hd.Parameter("share", "1", share) * mass * radius**2,) * 3
    body, *carts = (
        (hd.Body("ball", mass=mass, inertia=inertia),)
        if turns
        else (hd.Body("ball", mass=mass), hd.Body("sledge", 0), hd.Body("cart", 0))
    )
    joints = (hd.Free("flight", hd.GROUND, body),)
    if carts:
        joints = tuple(map(hd.Prismatic, "xzy", (hd.GROUND, *carts), (*carts, body), (hd.X, hd.Z, hd.Y)))
    floor = hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    return hd.Scene(
        hd.Mechanism("ball", joints, (floor,)),
        (
            hd.Gravity("gravity", gravity * sp.cos(slope), direction=-hd.Y),
            hd.PointForce("downhill", body.at(0, 0, 0), (mass * gravity * sp.sin(slope), 0, 0)),
            hd.Contact("floor", power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.2))),
            hd.Friction("rub", "floor", law),
            hd.EnergyLedger(),
        ),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius),
        hd.Start(
            position={"flight.y" if turns else "y": radius - mass * gravity * sp.cos(slope) / stiffness},
            speed={f"flight.{axis}_speed" if turns else axis: hd.Parameter(f"v_{axis}", "m/s", 0) for axis in "xz"}
            | {
                f"flight.angular_speed_{axis}": hd.Parameter(f"w_{axis}", "rad/s", 0)
                for axis in ("xyz" if turns else "")
            },
        ),
        **coordinates,
    )


def brake(*effects):
    """A block, guided along Y, that its weight presses on a wheel; no friction."""
    mass, inertia, radius = (
        hd.Parameter("mass", "kg", 2), hd.Parameter("inertia", "kg m^2", 1e-3), hd.Parameter("radius", "mm", 50),
    )  # fmt: skip
    gravity, stiffness = hd.Parameter("gravity", "m/s^2", GRAVITY), hd.Parameter("stiffness", "N/m", STIFFNESS)
    wheel, block = hd.Body("wheel", mass=mass, inertia=inertia), hd.Body("block", mass=mass, inertia=inertia)
    face = block.at(0, 0, 0)
    pair = hd.CylinderOnPlane("rub", wheel.at(0, 0, 0), hd.Z, radius, hd.Parameter("length", "mm", 10), face, -hd.Y)
    joints = hd.Revolute("axle", hd.GROUND, wheel, axis=hd.Z), hd.Prismatic("guide", hd.GROUND, block, axis=hd.Y)
    return hd.Scene(
        hd.Mechanism("brake", joints, (pair,)),
        (
            hd.Gravity("gravity", gravity, direction=-hd.Y),
            hd.Contact("rub", power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.2))), hd.EnergyLedger(), *effects,
        ),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius),
        hd.Start(
            position={"guide": radius - mass * gravity / stiffness}, speed={"axle": hd.Parameter("spin", "rad/s", 100)}
        ),
    )  # fmt: skip
