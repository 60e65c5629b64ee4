"""Mechanisms with a counterweight at the crank: a Scotch yoke, and the slider-crank with clearance."""

from dataclasses import replace

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    Weld,
    X,
    Y,
    Z,
)
from hertzwerk.derive.scenes.slider_crank import crank, scene

THROW, ARM, YOKE = 0.05, 0.04, 2.0


def counterweight(body, arm):
    """A mass of its own opposite the crank pin, fixed to the crank."""
    weight = Body("weight", Parameter("counterweight", "kg", 0.1), Parameter("counterweight_inertia", "kg m^2", 1e-6))
    return Weld("mount", body.at(-arm, 0, 0), weight)


def scotch_yoke():
    """A yoke driven in x = r cos(w t) by a massless block in its slot: a single harmonic force on the bearing."""
    r, speed, arm = Parameter("throw", "m", THROW), Parameter("speed", "rad/s", 100), Parameter("arm", "m", ARM)
    wheel, yoke, block = (
        Body("wheel", Parameter("wheel_mass", "kg", 1), Parameter("wheel_inertia", "kg m^2", 1e-4)),
        Body("yoke", Parameter("yoke_mass", "kg", YOKE)),
        Body("block", 0),
    )
    joints = (
        Revolute("bearing", GROUND, wheel, axis=Z),
        Revolute("pin", wheel.at(r, 0, 0), block, axis=Z),
        Prismatic("guide", GROUND, yoke, axis=X),
        Prismatic("slot", yoke, block, axis=Y),
        counterweight(wheel, arm),
    )
    return Scene(
        Mechanism("scotch_yoke", joints),
        effects=(ConstantSpeed("drive", "bearing", speed=speed),),
        start=Start(near={"guide": r}),
        scales=Scales(length=r, speed=Parameter("pace", "m/s", 5), arm=r),
    )


def balanced_crank():
    """The built-in slider-crank with clearance, and a counterweight on its crank."""
    mechanism = scene.mechanism
    arm = Parameter("arm", "mm", 30, "main bearing to counterweight")
    joints = (*mechanism.joints, counterweight(crank, arm))
    return replace(scene, mechanism=replace(mechanism, name="balanced_crank", joints=joints))
