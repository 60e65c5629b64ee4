"""Mechanisms with a counterweight at the crank: a Scotch yoke, and the slider-crank with clearance."""

from dataclasses import replace

import hertzwerk.derive as hd
from hertzwerk.derive.scenes.slider_crank import crank, scene

p = hd.Parameter
THROW, ARM, YOKE = 0.05, 0.04, 2.0


def counterweight(body, arm):
    """A mass of its own opposite the crank pin, fixed to the crank."""
    weight = hd.Body("weight", p("counterweight", "kg", 0.1), p("counterweight_inertia", "kg m^2", 1e-6))
    return hd.Weld("mount", body.at(-arm, 0, 0), weight)


def scotch_yoke():
    """A yoke driven in x = r cos(w t) by a massless block in its slot: a single harmonic force on the bearing."""
    r, speed, arm = p("throw", "m", THROW), p("speed", "rad/s", 100), p("arm", "m", ARM)
    wheel = hd.Body("wheel", p("wheel_mass", "kg", 1), p("wheel_inertia", "kg m^2", 1e-4))
    yoke, block = hd.Body("yoke", p("yoke_mass", "kg", YOKE)), hd.Body("block", 0)
    joints = (
        hd.Revolute("bearing", hd.GROUND, wheel, axis=hd.Z), hd.Revolute("pin", wheel.at(r, 0, 0), block, axis=hd.Z),
        hd.Prismatic("guide", hd.GROUND, yoke, axis=hd.X), hd.Prismatic("slot", yoke, block, axis=hd.Y), counterweight(wheel, arm),
    )  # fmt: skip
    return hd.Scene(
        hd.Mechanism("scotch_yoke", joints), effects=(hd.ConstantSpeed("drive", "bearing", speed=speed),), start=hd.Start(near={"guide": r}),
        scales=hd.Scales(length=r, speed=hd.Parameter("pace", "m/s", 5), arm=r),
    )  # fmt: skip


def balanced_crank():
    """The built-in slider-crank with clearance, and a counterweight on its crank."""
    mechanism = scene.mechanism
    arm = hd.Parameter("arm", "mm", 30, "main bearing to counterweight")
    joints = (*mechanism.joints, counterweight(crank, arm))
    return replace(scene, mechanism=replace(mechanism, name="balanced_crank", joints=joints))
