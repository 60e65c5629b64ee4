"""A ball that falls on a floor: a sound scene, of which tests replace a part to make it faulty."""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
)
from hertzwerk.derive.laws import flores, power

BALL = Body("ball", mass=Parameter("mass", "kg", 1.0))
FALL = Prismatic("fall", GROUND, BALL, axis=Y)
RADIUS = Parameter("radius", "m", 0.1)
FLOOR = SphereOnPlane("floor", BALL.at(0, 0, 0), RADIUS, GROUND.at(0, 0, 0), normal=Y)
GRAVITY = Gravity("gravity", Parameter("g", "m/s^2", 9.81), -Y)
STIFFNESS = power(Parameter("K", "N/m^1.5", 1e6), 1.5)
BOUNCE = Contact("floor", STIFFNESS, flores(Parameter("restitution", "1", 0.8)))
EFFECTS = (GRAVITY, BOUNCE, EnergyLedger())
SCALES = Scales(length=RADIUS, speed=Parameter("pace", "m/s", 1), arm=RADIUS)


def drop(joints=(FALL,), pairs=(FLOOR,), effects=EFFECTS, scales=SCALES, start=None, name="drop"):
    """A sound scene unless something of it is replaced."""
    return Scene(Mechanism(name, joints, pairs), effects, scales, start or Start())
