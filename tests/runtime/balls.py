"""Balls that roll and slide on a plane in space, which is level or inclined towards X; a wheel under a block."""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    CylinderOnPlane,
    EnergyLedger,
    Free,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    PointForce,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import coulomb, kelvin_voigt, power

MASS, RADIUS, GRAVITY, STIFFNESS = 0.17, 0.03, 9.81, 1e6  # kg, m, m/s^2, N/m


def dry(mu_k=0.2, mu_s=None):
    """Set-valued Coulomb friction."""
    return coulomb(Parameter("mu_k", "1", mu_k), Parameter("mu_s", "1", mu_k if mu_s is None else mu_s))


def ball(law, *, share=0.4, turns=True, **coordinates):
    """A ball on a plane through the origin, gravity turned by `slope` towards X; its inertia is a share of m r^2.

    One that does not turn is carried along X, Z and Y: a particle.
    """
    mass, radius, slope = Parameter("mass", "kg", MASS), Parameter("radius", "m", RADIUS), Parameter("slope", "rad", 0)
    gravity, stiffness = Parameter("gravity", "m/s^2", GRAVITY), Parameter("stiffness", "N/m", STIFFNESS)
    inertia = (Parameter("share", "1", share) * mass * radius**2,) * 3
    body, *carts = (
        (Body("ball", mass=mass, inertia=inertia),)
        if turns
        else (Body("ball", mass=mass), Body("sledge", 0), Body("cart", 0))
    )
    joints = (Free("flight", GROUND, body),)
    if carts:
        joints = tuple(map(Prismatic, "xzy", (GROUND, *carts), (*carts, body), (X, Z, Y)))
    floor = SphereOnPlane("floor", body.at(0, 0, 0), radius, GROUND.at(0, 0, 0), Y)
    return Scene(
        Mechanism("ball", joints, (floor,)),
        (
            Gravity("gravity", gravity * sp.cos(slope), direction=-Y),
            PointForce("downhill", body.at(0, 0, 0), (mass * gravity * sp.sin(slope), 0, 0)),
            Contact("floor", power(stiffness, 1), kelvin_voigt(Parameter("restitution", "1", 0.2))),
            Friction("rub", "floor", law),
            EnergyLedger(),
        ),
        Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 1), arm=radius),
        Start(
            position={"flight.y" if turns else "y": radius - mass * gravity * sp.cos(slope) / stiffness},
            speed={f"flight.{axis}_speed" if turns else axis: Parameter(f"v_{axis}", "m/s", 0) for axis in "xz"}
            | {f"flight.angular_speed_{axis}": Parameter(f"w_{axis}", "rad/s", 0) for axis in ("xyz" if turns else "")},
        ),
        **coordinates,
    )


def brake(*effects):
    """A block, guided along Y, that its weight presses on a wheel; no friction."""
    mass, inertia, radius = (
        Parameter("mass", "kg", 2),
        Parameter("inertia", "kg m^2", 1e-3),
        Parameter("radius", "mm", 50),
    )
    gravity, stiffness = Parameter("gravity", "m/s^2", GRAVITY), Parameter("stiffness", "N/m", STIFFNESS)
    wheel, block = Body("wheel", mass=mass, inertia=inertia), Body("block", mass=mass, inertia=inertia)
    face = block.at(0, 0, 0)
    pair = CylinderOnPlane("rub", wheel.at(0, 0, 0), Z, radius, Parameter("length", "mm", 10), face, -Y)
    joints = Revolute("axle", GROUND, wheel, axis=Z), Prismatic("guide", GROUND, block, axis=Y)
    return Scene(
        Mechanism("brake", joints, (pair,)),
        (
            Gravity("gravity", gravity, direction=-Y),
            Contact("rub", power(stiffness, 1), kelvin_voigt(Parameter("restitution", "1", 0.2))),
            EnergyLedger(),
            *effects,
        ),
        Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 1), arm=radius),
        Start(position={"guide": radius - mass * gravity / stiffness}, speed={"axle": Parameter("spin", "rad/s", 100)}),
    )
