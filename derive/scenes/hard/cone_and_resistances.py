"""Hard scenes at the edge of the cone of friction, and with set-valued resistances.

Derived when run, never committed.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from hertzwerk.derive import Where
from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.forces import JointForce
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.state_expression import T
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import DrillingResistance, RollingResistance
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, X, Y, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic
from hertzwerk.derive.declare.mechanism.joints.free import Free
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.on_plane import SphereOnPlane
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import coulomb, flores, power

_MASS, _RADIUS = Parameter("mass", "kg", 1), Parameter("radius", "m", 0.02)
_GRAVITY = Parameter("gravity", "m/s^2", 9.81)


def turning_load() -> Scene:
    """A block on a plane that a load pulls on, which turns, and grows to a share of what friction holds."""
    mu, stiffness, rise = (
        Parameter("friction_coefficient", "1", 0.5),
        Parameter("stiffness", "N/m", 1e6),
        Parameter("rise", "s", 0.05),
    )
    along, aside, block = Body("along", 0), Body("aside", 0), Body("block", _MASS)
    joints = (
        Prismatic("x", GROUND, along, axis=X),
        Prismatic("z", along, aside, axis=Z),
        Prismatic("y", aside, block, axis=Y),
    )
    grown = T / rise
    load = (
        Parameter("share", "1", 1) * mu * _MASS * _GRAVITY * Where(grown < 1, (1 + 3 * grown**2 - 2 * grown**3) / 2, 1)
    )
    turned = Parameter("rate", "rad/s", 20) * T
    return Scene(
        Mechanism(
            "turning_load",
            joints,
            (SphereOnPlane("floor", block.at(0, 0, 0), _RADIUS, GROUND.at(0, -_RADIUS, 0), normal=Y),),
        ),
        effects=(
            Gravity("gravity", _GRAVITY, direction=-Y),
            Contact("floor", power(stiffness, 1), flores(Parameter("restitution", "1", 0.5))),
            Friction("rub", "floor", coulomb(mu, mu)),
            JointForce("pull_x", "x", load * sp.cos(turned)),
            JointForce("pull_z", "z", load * sp.sin(turned)),
            EnergyLedger(),
        ),
        start=Start(position={"y": -_MASS * _GRAVITY / stiffness}),
        scales=Scales(length=Parameter("size", "mm", 1), speed=Parameter("pace", "m/s", 0.1)),
        summary="a block under a load that turns at the edge of the cone of friction",
    )


def spun_ball() -> Scene:
    """A ball that spins and bounces to rest, with set-valued resistances and without friction."""
    ball = Body("ball", _MASS, (2 * _MASS * _RADIUS**2 / 5,) * 3)
    spin, roll = Parameter("spin", "rad/s", 40), Parameter("roll", "rad/s", 21)
    height = Parameter("drop_height", "m", 0.05)
    return Scene(
        Mechanism(
            "spun_ball",
            (Free("flight", GROUND, ball),),
            (SphereOnPlane("floor", ball.at(0, 0, 0), _RADIUS, GROUND.at(0, 0, 0), normal=Y),),
        ),
        effects=(
            Gravity("gravity", _GRAVITY, direction=-Y),
            Contact(
                "floor", power(Parameter("stiffness", "N/m^1.5", 1e8), 1.5), flores(Parameter("restitution", "1", 0.6))
            ),
            RollingResistance("rolling", "floor", Parameter("rolling_arm", "m", 1e-3)),
            DrillingResistance("drilling", "floor", Parameter("drilling_arm", "m", 2e-3)),
            EnergyLedger(),
        ),
        start=Start(
            position={"flight.y": _RADIUS + height},
            speed={"flight.angular_speed_x": roll, "flight.angular_speed_y": spin},
        ),
        scales=Scales(length=Parameter("size", "mm", 0.1), speed=Parameter("pace", "m/s", 1), arm=_RADIUS),
        summary="a ball that spins, bounces to rest, and is held at rest",
    )


AT_LIMITS: dict[str, Callable[[], Scene]] = {scene.__name__: scene for scene in (turning_load, spun_ball)}
