"""Slider-crank at constant speed whose coupler bends.

Data: the slider crank of the test set for IVP solvers (F. Mazzia, C. Magherini, release 2.4, 2008), after B. Simeon, Math.
Modelling of Systems 2 (1996) 1-18, as a public code has it (grade B). There the coupler stretches as well, and its axial force does not
stiffen it. It starts straight, with the speeds of a rigid one.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    EnergyLedger,
    FlexibleRod,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    X,
    Z,
)

# Numbers with units. Change any of them for one run: --set youngs_modulus="70 GPa".
r = Parameter("crank_length", "m", 0.15)
l = Parameter("coupler_length", "m", 0.30)
b = Parameter("coupler_width", "mm", 8, "side of the square section")
E, rho = Parameter("youngs_modulus", "GPa", 200), Parameter("density", "kg/m^3", 7870)
w = Parameter("crank_speed", "rad/s", 150, "constant speed of the crank")

# Bodies; the coupler is a rod with its own two, coupler.start and coupler.end.
crank = Body(
    "crank",
    mass=Parameter("crank_mass", "kg", 0.36),
    inertia=Parameter("crank_inertia", "kg m^2", 7.02e-4),
    centre=(r / 2, 0, 0),
)
slider = Body("slider", mass=Parameter("slider_mass", "kg", 0.075552))
coupler = FlexibleRod(
    "coupler", length=l, mass=rho * b**2 * l, stiffness=E * b**4 / 12, modes=3, ends=("pinned", "pinned"),
    damping_ratio=Parameter("damping_ratio", "1", 0), section_modulus=b**3 / 6,
)  # fmt: skip

mechanism = Mechanism(
    "flexible_slider_crank",
    joints=(
        Revolute("main_bearing", GROUND, crank, axis=Z),
        Revolute("crank_pin", crank.at(r, 0, 0), coupler.start, axis=Z),
        coupler,
        Prismatic("guide", GROUND, slider, axis=X),
        Revolute("slider_pin", coupler.end, slider, axis=Z),  # closes the loop
    ),
)

scene = Scene(
    mechanism,
    effects=(ConstantSpeed("crank_drive", "main_bearing", w), EnergyLedger()),
    scales=Scales(
        length=Parameter("deflection", "mm", 1, "scale of the deflection"),
        speed=Parameter("vibration", "m/s", 1),
        arm=l,
    ),
    summary="slider-crank whose coupler bends",
)
