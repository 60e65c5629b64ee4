"""An idle gear that rattles within its backlash, because the pinion that drives it turns unevenly.

The flanks are involutes, so that the gaps are lengths of the lines of action: r_b1 a_1 + r_b2 a_2 apart from half the
backlash, whatever teeth are in mesh. The wheel's drag holds it on the driving flanks as long as it alone can brake the wheel
as the pinion slows down: up to an acceleration of drag/inertia teeth_2/teeth_1. Above it knocks from side to side. Our
choice of numbers; a stiffness for each mm of face width of 14 N/(mm um) is that of ISO 6336.
"""

import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    Contact,
    Drive,
    EnergyLedger,
    GearMesh,
    InvoluteTeeth,
    JointForce,
    Mechanism,
    Parameter,
    Revolute,
    Scales,
    Scene,
    Start,
    T,
    Z,
)
from hertzwerk.derive.laws import power, power_damping

Z1, Z2 = 20, 31  # teeth; of an odd number, a space is opposite to a tooth

module = Parameter("module", "mm", 3)
angle = Parameter("pressure_angle", "deg", 20)
thinning = Parameter("thinning", "mm", 0.05, "of each tooth: half the backlash on the reference circle")
speed = Parameter("pinion_speed", "rpm", 900)
swing = Parameter("swing", "rad/s^2", 1500, "greatest acceleration of the pinion")
firing = Parameter("firing", "rad/s", 240, "frequency of that")
drag = Parameter("drag", "N m", 0.8)
inertia = Parameter("wheel_inertia", "kg m^2", 2e-3)
K = Parameter("mesh_stiffness", "N/m", 1.4e8)

pinion = Body("pinion", Parameter("pinion_mass", "kg", 0.5), Parameter("pinion_inertia", "kg m^2", 3e-4))
wheel = Body("wheel", Parameter("wheel_mass", "kg", 1.5), inertia)
teeth = (
    InvoluteTeeth("pinion_teeth", module, Z1, angle, thinning),
    InvoluteTeeth("wheel_teeth", module, Z2, angle, thinning),
)
base = teeth[1].base_radius
pressed = (drag + inertia * swing * Z1 / Z2) / base  # at the start, where the wheel is accelerated

scene = Scene(
    Mechanism(
        "gears_with_backlash",
        joints=(
            Revolute("input", GROUND, pinion, axis=Z),
            Revolute("idler", GROUND.at(module * (Z1 + Z2) / 2, 0, 0), wheel, axis=Z),
        ),
        pairs=(GearMesh("mesh", teeth[0], pinion.at(0, 0, 0), teeth[1], wheel.at(0, 0, 0)),),
    ),
    effects=(
        Drive("engine", "input", position=speed * T + swing / firing**2 * (1 - sp.cos(firing * T))),
        JointForce("oil", "idler", drag),
        Contact("mesh", power(K, n=1), power_damping(chi=Parameter("mesh_damping", "N s/m^2", 4e8), m=1)),
        EnergyLedger(),
    ),
    start=Start(
        position={"idler": 2 * thinning / (module * Z2) + pressed / (K * base)}, speed={"idler": -speed * Z1 / Z2}
    ),
    scales=Scales(length=thinning, speed=speed * teeth[0].base_radius / 10, arm=base),
    summary="idle gear that rattles within its backlash",
)
