"""Hard scenes of balls that stick and slip: before they lift off, where their law pulls, as they roll.

Derived when run, never committed.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, X, Y, Z
from hertzwerk.derive.declare.mechanism.joints.free import Free
from hertzwerk.derive.declare.mechanism.joints.planar import Planar
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.on_plane import SphereOnPlane
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import coulomb, gonthier, hunt_crossley, kelvin_voigt, power, ristow

_GRAVITY = Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y)
_PACE = Parameter("pace", "m/s", 1)


def ball_on_diagonal() -> Scene:
    """A ball in space that falls on a plane of 45 degrees."""
    inertia, radius = Parameter("inertia", "kg m^2", 1e-3), Parameter("radius", "m", 0.05)
    ball = Body("ball", mass=Parameter("mass", "kg", 1), inertia=(inertia,) * 3)
    floor = SphereOnPlane("floor", ball.at(0, 0, 0), radius, GROUND.at(0, 0, 0), Direction((1, 1, 0)))
    friction = Parameter("friction_coefficient", "1", 0.3)
    return Scene(
        Mechanism("ball_on_diagonal", (Free("flight", GROUND, ball),), (floor,)),
        effects=(
            _GRAVITY,
            Contact("floor", power(Parameter("stiffness", "N/m^1.5", 1e7), 1.5)),
            Friction("rub", "floor", coulomb(friction, friction)),
            EnergyLedger(),
        ),
        start=Start(position={"flight.y": Parameter("height", "m", 0.3)}),
        scales=Scales(length=radius, speed=_PACE, arm=radius),
        summary="a ball that sticks in an impact and slips before it lifts off",
    )


def ball_beside_wall() -> Scene:
    """A spinning ball in plane motion that falls on an incline, and a wall that it never touches."""
    radius = Parameter("radius", "m", 0.0605589)
    ball = Body("ball", mass=Parameter("mass", "kg", 0.0508701), inertia=Parameter("inertia", "kg m^2", 1.87915e-5))
    floor = SphereOnPlane("floor", ball.at(0, 0, 0), radius, GROUND.at(0, 0, 0), Direction((0.3949301626, 1, 0)))
    far = GROUND.at(Parameter("distance", "m", 2), 0, 0)
    wall = SphereOnPlane("wall", ball.at(0, 0, 0), radius, far, -X)
    friction = Parameter("friction_coefficient", "1", 0.580968)
    return Scene(
        Mechanism("ball_beside_wall", (Planar("flight", GROUND, ball, normal=Z),), (floor, wall)),
        effects=(
            _GRAVITY,
            Contact(
                "floor",
                power(Parameter("stiffness", "N/m", 36263.5), 1),
                hunt_crossley(Parameter("restitution", "1", 0.743093)),
            ),
            Friction("rub", "floor", coulomb(friction, friction)),
            Contact("wall", power(Parameter("wall_stiffness", "N/m^1.5", 1e7), 1.5)),
            EnergyLedger(),
        ),
        start=Start(
            position={"flight.y": radius + Parameter("drop", "m", 0.0885309)},
            speed={
                "flight.x": Parameter("approach", "m/s", -0.930101),
                "flight.angle": Parameter("spin", "rad/s", -29.8337),
            },
        ),
        scales=Scales(length=radius, speed=_PACE, arm=radius),
        summary="a ball that slips before it lifts off, beside a wall out of reach",
    )


def ball_that_is_held_back() -> Scene:
    """A ball without weight in plane motion that slides in an impact whose law pulls at its end."""
    radius = Parameter("radius", "m", 0.05)
    ball = Body("ball", mass=Parameter("mass", "kg", 1), inertia=Parameter("inertia", "kg m^2", 1e-3))
    friction = Parameter("friction_coefficient", "1", 0.2)
    law = power(Parameter("stiffness", "N/m", 1e6), 1), kelvin_voigt(Parameter("restitution", "1", 0.5))
    return Scene(
        Mechanism(
            "ball_that_is_held_back",
            (Planar("flight", GROUND, ball, normal=Z),),
            (SphereOnPlane("floor", ball.at(0, 0, 0), radius, GROUND.at(0, 0, 0), Y),),
        ),
        effects=(Contact("floor", *law), Friction("rub", "floor", coulomb(friction, friction)), EnergyLedger()),
        start=Start(
            position={"flight.y": Parameter("height", "m", 0.0505)},
            speed={"flight.x": Parameter("slide", "m/s", 3), "flight.y": Parameter("approach", "m/s", -1)},
        ),
        scales=Scales(length=radius, speed=_PACE, arm=radius),
        summary="a ball that slides until the law of its contact pulls",
    )


def ball_down_a_slope() -> Scene:
    """A spinning ball in plane motion that bounces down an incline on a damped spring."""
    p, radius, tilt = (
        Parameter,
        Parameter("radius", "m", 0.0784880898607521),
        Parameter("tilt", "rad", -0.3376417015945289),
    )
    ball = Body("ball", mass=p("mass", "kg", 2.6263181767461665), inertia=p("inertia", "kg m^2", 0.00552853063401062))
    friction = p("friction_coefficient", "1", 0.16269648291272948)
    law = power(p("stiffness", "N/m", 12216043.017469913), 1), ristow(p("damping_rate", "1/s", 200.3531697372722))
    normal = Direction((sp.sin(tilt), sp.cos(tilt), 0))
    return Scene(
        Mechanism(
            "ball_down_a_slope",
            (Planar("flight", GROUND, ball, normal=Z),),
            (SphereOnPlane("floor", ball.at(0, 0, 0), radius, GROUND.at(0, 0, 0), normal),),
        ),
        effects=(
            _GRAVITY,
            Contact("floor", *law),
            Friction("rub", "floor", coulomb(friction, friction)),
            EnergyLedger(),
        ),
        start=Start(position={"flight.y": radius}),
        scales=Scales(
            length=p("depth", "m", 8.25982667326283e-05), speed=p("pace", "m/s", 0.17814044834465342), arm=radius
        ),
        summary="a ball that bounces down a slope, sticking and slipping in an impact",
    )


def ball_off_centre() -> Scene:
    """Return a ball in space, its mass centre off its own, on a level plane."""
    p, radius = Parameter, Parameter("radius", "m", 0.016334458026309572)
    inertia = (7.493111234267321e-06, 4.628664286932459e-06, 4.151422020214849e-06)
    offset = (0.003908890352220624, 0.000939709124307184, 0.003328536910237479)
    ball = Body(
        "ball",
        mass=p("mass", "kg", 0.060292592621589154),
        inertia=tuple(p(f"inertia_{axis}", "kg m^2", value) for axis, value in zip("xyz", inertia, strict=True)),
    )
    centre = ball.at(*(p(f"offset_{axis}", "m", value) for axis, value in zip("xyz", offset, strict=True)))
    friction = p("friction_coefficient", "1", 0.25824217513416187)
    law = power(p("stiffness", "N/m^1.5", 1010248.9234377254), 1.5), gonthier(p("restitution", "1", 0.7658307696002731))
    return Scene(
        Mechanism(
            "ball_off_centre",
            (Free("flight", GROUND, ball),),
            (SphereOnPlane("floor", centre, radius, GROUND.at(0, 0, 0), Z),),
        ),
        effects=(
            Gravity("gravity", p("gravity", "m/s^2", 9.81), direction=-Z),
            Contact("floor", *law),
            Friction("rub", "floor", coulomb(friction, friction)),
            EnergyLedger(),
        ),
        start=Start(position={"flight.z": radius}),
        scales=Scales(length=p("depth", "m", 0.00011735733225087817), speed=p("pace", "m/s", 0.05), arm=radius),
        summary="a ball that rolls until its mass centre is thrown about",
    )


LATE_SLIPS: dict[str, Callable[[], Scene]] = {
    scene.__name__: scene
    for scene in (ball_on_diagonal, ball_beside_wall, ball_that_is_held_back, ball_down_a_slope, ball_off_centre)
}
