"""Hard scenes of wear: a joint that loses clearance, a pad worn until it is free, a ball on its track.

Derived when run, never committed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.drives import ConstantSpeed
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.springs import JointSpring
from hertzwerk.derive.declare.effects.tribology.wear import Wear
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, X, Y, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic
from hertzwerk.derive.declare.mechanism.joints.planar import Planar
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.corner_on_face import CornerOnFace
from hertzwerk.derive.equations.contact.pairs.on_plane import SphereOnPlane
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import coulomb, kelvin_voigt, power
from hertzwerk.derive.scenes.worn_slider_crank import scene as worn_slider_crank


def worn_crank() -> Scene:
    """The worn slider-crank with eight sectors."""
    return worn_slider_crank.replace(wear=replace(worn_slider_crank.effect("wear"), sectors=8)).named("worn_crank")


def worn_pad() -> Scene:
    """A pad that a compressed spring presses on a plane along which a drive pulls it."""
    cart, pad = Body("cart", Parameter("cart_mass", "kg", 1)), Body("pad", Parameter("mass", "kg", 2))
    size = Parameter("size", "mm", 1)
    sunk = Parameter("preload", "N", 10) / Parameter("stiffness", "N/m", 1e6)
    wear = Wear(
        "wear",
        "floor",
        Parameter("wear_rate", "mm^3/(N m)", 1e-5),
        area=Parameter("area", "mm^2", 4),
        acceleration=Parameter("repetitions", "1", 1e5),
    )
    return Scene(
        Mechanism(
            "worn_pad",
            (Prismatic("along", GROUND, cart, axis=X), Prismatic("down", cart, pad, axis=-Y)),
            (CornerOnFace("floor", pad.at(0, 0, 0), GROUND.at(0, 0, 0), Y),),
        ),
        effects=(
            ConstantSpeed("drive", "along", Parameter("speed", "m/s", 0.3)),
            JointSpring(
                "spring", "down", Parameter("spring", "N/m", 1e4), rest=sunk + Parameter("compressed", "mm", 1)
            ),
            Contact("floor", power(Parameter("stiffness", "N/m", 1e6), 1)),
            wear,
            EnergyLedger(),
        ),
        start=Start(position={"down": sunk}),
        scales=Scales(length=size, speed=Parameter("pace", "m/s", 1), arm=size),
    )


def worn_rolling() -> Scene:
    """A ball thrown with backspin, just in touch, which slips, comes back over its track, and rolls."""
    R, g = Parameter("radius", "mm", 20), Parameter("gravity", "m/s^2", 9.81)
    mass, mu = Parameter("mass", "kg", 0.5), Parameter("friction", "1", 0.2)
    ball = Body("ball", mass, inertia=2 * mass * R**2 / 5)
    pair = SphereOnPlane("floor", ball.at(0, 0, 0), R, GROUND.at(0, 0, 0), Y)
    wear = Wear("wear", "floor", second=Parameter("wear_rate", "mm^3/(N m)", 1e-4), acceleration=Parameter("repetitions", "1", 1000),
                track=Parameter("track", "mm", 80), along=X)  # fmt: skip
    speed = Parameter("speed", "m/s", 0.4)
    return Scene(
        Mechanism("worn_rolling", (Planar("way", GROUND, ball, normal=Z),), (pair,)),
        effects=(
            Gravity("gravity", g, direction=-Y),
            Contact("floor", power(Parameter("stiffness", "N/m^1.5", 1e8), 1.5), kelvin_voigt(Parameter("restitution", "1", 0.3))),
            Friction("floor_friction", "floor", coulomb(mu, mu)),
            wear,
            EnergyLedger(),
        ),
        start=Start(position={"way.y": R}, speed={"way.x_speed": speed, "way.angle_speed": Parameter("spin", "rad/s", 100)}),
        scales=Scales(length=Parameter("size", "mm", 1), speed=speed, arm=R),
    )  # fmt: skip


WORN: dict[str, Callable[[], Scene]] = {"worn_crank": worn_crank, "worn_pad": worn_pad, "worn_rolling": worn_rolling}
