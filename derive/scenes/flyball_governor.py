"""Centrifugal governor: two arms with balls on a spindle, two rods that lift a collar, a spring.

After benchmark A05 of the IFToMM library, a stiff one: there springs of 8e5 N/m with dampers of 4e4 N s/m replace the
lower rods, and shaft, arms and slider are prisms of 3000 kg/m^3, with 5 kg on each arm, at 2 pi rad/s (data as in the
public code MBS-BOS, grade B). Here those rods are rigid, hinged at both ends, and close two loops. Data of our
choice: spindle and collar with moments of inertia of 0.05 and 0.003 kg m^2; massless arms of 0.3 m with balls of 2 kg
and 4 cm; rods of 0.2 kg and 0.2 m from the middle of the arms; a collar of 1.5 kg; a spring of 400 N/m; 160 rpm with
the arms at 30 degrees, which is no equilibrium. Both loops lie in a plane that turns with the spindle: the
constraints of a hinge across that plane are redundant.

Source: https://www.iftomm-multibody.org/benchmark, A05.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    EnergyLedger,
    Gravity,
    JointSpring,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    Y,
    Z,
)

l = Parameter("arm_length", "m", 0.3, "hinge to ball")
h = Parameter("rod_length", "m", 0.2, "hinge to hinge")
a = Parameter("offset", "m", 0.03, "of the hinges from the spindle's axis")
m = Parameter("ball_mass", "kg", 2.0)
R = Parameter("ball_radius", "m", 0.04)
rod_mass = Parameter("rod_mass", "kg", 0.2)
angle = Parameter("start_angle", "deg", 30, "of the arms from the spindle")
w = Parameter("start_speed", "rpm", 160, "of the spindle")
turning = Parameter("spindle_inertia", "kg m^2", 0.05, "about the spindle's axis")
k = Parameter("spring_stiffness", "N/m", 400)

of_ball, of_rod = sp.Rational(2, 5) * m * R**2, rod_mass * h**2 / 12
spindle = Body("spindle", Parameter("spindle_mass", "kg", 3.0), (0, turning, 0))
collar = Body("collar", Parameter("collar_mass", "kg", 1.5), (0, Parameter("collar_inertia", "kg m^2", 0.003), 0))

# Seen along Z the right arm hangs to +X; both arms turn outwards by a positive angle about their own axes.
joints, closures = [], []
for side, sign in (("right", 1), ("left", -1)):
    axis = Z if sign > 0 else -Z
    arm = Body(f"{side}_arm", m, (of_ball, of_ball, of_ball), centre=(0, -l, 0))
    rod = Body(f"{side}_rod", rod_mass, (of_rod, 0, of_rod), centre=(0, -h / 2, 0))
    joints += [
        Revolute(f"{side}_hinge", spindle.at(sign * a, 0, 0), arm, axis=axis),
        Revolute(f"{side}_knee", arm.at(0, -l / 2, 0), rod, axis=axis),
    ]
    closures.append(Revolute(f"{side}_foot", collar.at(sign * a, 0, 0), rod.at(0, -h, 0), axis=axis))

# The rods lean back to the collar: their lower ends are as far from the axis as the hinges of the arms.
lean = sp.asin(l * sp.sin(angle) / (2 * h))
height = l * sp.cos(angle) / 2 + h * sp.cos(lean)

scene = Scene(
    Mechanism(
        "flyball_governor",
        joints=(
            Revolute("spindle", GROUND, spindle, axis=Y),
            *joints,
            Prismatic("guide", spindle, collar, axis=Y),
            *closures,
        ),
    ),
    effects=(
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        JointSpring("spring", "guide", k, rest=-Parameter("spring_rest", "m", 0.35, "of the collar below the arms' hinges")),
        EnergyLedger(),
    ),
    start=Start(
        position={
            "guide": -height,
            **{f"{side}_hinge": angle for side in ("right", "left")},
            **{f"{side}_knee": -angle - lean for side in ("right", "left")},
        },
        speed={"spindle": w},
    ),
    scales=Scales(length=l, speed=l * w, arm=l),
    summary="centrifugal governor, two loops on a spindle",
)  # fmt: skip
