"""Slider-crank with clearance between rod and slider (the example of Wang & Liu 2020, section 6).

Data: the set ascribed to Ravn, Schwab and Flores, from general knowledge of the literature (grade C); none of their
papers was accessible for comparison, nor were the data of Wang & Liu. The length of the bush and the density of the
steel are our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Material,
    Mechanism,
    Parameter,
    PinInBush,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import hertz_point, lankarani_nikravesh, smooth_coulomb

# Numbers with units. Change any of them for one run: --set clearance="0.2 mm".
r = Parameter("crank_radius", "m", 0.05, "main bearing to crank pin")
l = Parameter("rod_length", "m", 0.12, "crank pin to slider pin")
w = Parameter("crank_speed", "rpm", 5000, "constant speed of the crank")
c = Parameter("clearance", "mm", 0.5, "bush radius minus pin radius")
b = Parameter("bush_length", "mm", 15, "of the slider pin in its bush")
steel = Material(Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3),
                 Parameter("density", "kg/m^3", 7800, "of the steel"))  # fmt: skip

# Bodies: mass, inertia about the mass centre, and where that centre is in the frame of the body.
crank = Body("crank", mass=Parameter("crank_mass", "kg", 0.30), inertia=Parameter("crank_inertia", "kg m^2", 1.0e-4))
rod = Body("rod", mass=Parameter("rod_mass", "kg", 0.21), inertia=Parameter("rod_inertia", "kg m^2", 2.5e-4),
           centre=(Parameter("rod_mass_centre", "m", 0.06, "crank pin to mass centre"), 0, 0))  # fmt: skip
slider = Body("slider", mass=Parameter("slider_mass", "kg", 0.14))

# Joints give the bodies their coordinates. The slider pin is none: pin and bush are surfaces that may touch.
mechanism = Mechanism(
    "slider_crank",
    joints=(
        Revolute("main_bearing", GROUND, crank, axis=Z),
        Revolute("crank_pin", crank.at(r, 0, 0), rod, axis=Z),
        Prismatic("guide", GROUND, slider, axis=X),
    ),
    pairs=(
        PinInBush("slider_pin", pin=rod.at(l, 0, 0), bush=slider.at(0, 0, 0), axis=Z,
                  bush_radius=Parameter("bush_radius", "mm", 10), clearance=c, length=b),
    ),
)  # fmt: skip

# Everything that acts. An effect that is not listed here enters no equation.
scene = Scene(
    mechanism,
    effects=(
        ConstantSpeed("crank_drive", joint="main_bearing", speed=w),
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        Contact("slider_pin", hertz_point(steel, steel), lankarani_nikravesh(Parameter("restitution", "1", 0.9))),
        Friction("slider_pin_friction", pair="slider_pin",
                 law=smooth_coulomb(Parameter("friction_coefficient", "1", 0.1), Parameter("friction_speed", "m/s", 0.1))),
        EnergyLedger(),
    ),
    # The ideal mechanism at crank angle 0, the pin centred in its bush.
    start=Start(speed={"crank_pin": -w * (1 + r / l)}, position={"guide": r + l}),
    # Typical sizes, of lengths in the clearance, speeds and levers: errors count by them.
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="slider-crank, clearance between rod and slider",
)  # fmt: skip
