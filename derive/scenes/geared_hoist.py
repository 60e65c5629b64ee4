"""A geared hoist: a motor's pinion turns the wheel of a drum, which lifts a load on a rope.

Two couplings without compliance or loss, gear pair and drum; wheels and drum of steel by their shapes. The load rises
at a constant acceleration in closed form, and what the teeth and the rope bear follows. Data: our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Coupling,
    EnergyLedger,
    Gravity,
    JointForce,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Y,
    Z,
)

module, face = Parameter("module", "mm", 4, "of the teeth"), Parameter("face_width", "mm", 30)
teeth, more_teeth = Parameter("pinion_teeth", "1", 17), Parameter("wheel_teeth", "1", 51)
R = Parameter("drum_radius", "mm", 80)
steel = Parameter("density", "kg/m^3", 7850)
torque = Parameter("torque", "N m", 30, "of the motor")

small, large = module * teeth / 2, module * more_teeth / 2  # pitch radii
pinion = Body.cylinder("pinion", small, face, density=steel)
wheel = Body.cylinder("wheel", large, face, density=steel)
drum = Body.cylinder("drum", R, 3 * face, density=steel, centre=(0, 0, -2 * face))
load = Body("load", mass=Parameter("load_mass", "kg", 80))

mechanism = Mechanism(
    "geared_hoist",
    joints=(
        Revolute("pinion_shaft", GROUND.at(small + large, 0, 0), pinion, axis=Z),
        Revolute("drum_shaft", GROUND, Body.of("winch", wheel, drum), axis=Z),
        Prismatic("rope_end", GROUND.at(-R, -6 * R, 0), load, axis=Y),
    ),
)

scene = Scene(
    mechanism,
    effects=(
        JointForce("motor", "pinion_shaft", torque),
        Coupling("mesh", "drum_shaft", "pinion_shaft", ratio=-teeth / more_teeth),
        Coupling("rope", "rope_end", "drum_shaft", ratio=-R),
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        EnergyLedger(),
    ),
    scales=Scales(length=R, speed=Parameter("speed_scale", "m/s", 1), arm=R),
    summary="a motor lifts a load by a gear pair and a drum",
)
