"""Four-bar linkage with clearance between coupler and rocker, its crank at constant speed.

Data: crank and coupler are those of the slider-crank with clearance (grade C); rocker and base of our choice, so that
the crank can rotate fully, as are the length of the bush and the density. It is none of the published four-bars with
clearance: their data were not accessible.
"""

import sympy as sp

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
    Revolute,
    Scales,
    Scene,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.laws import flores, hertz_point, smooth_coulomb

# Numbers with units. Change any of them for one run: --set clearance="0.2 mm".
r = Parameter("crank_length", "m", 0.05)
l = Parameter("coupler_length", "m", 0.12)
k = Parameter("rocker_length", "m", 0.10)
base = Parameter("base_length", "m", 0.13, "between the fixed pivots")
w = Parameter("crank_speed", "rpm", 1000, "constant speed of the crank")
c = Parameter("clearance", "mm", 0.5, "bush radius minus pin radius")
steel = Material(Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3),
                 Parameter("density", "kg/m^3", 7800, "of the steel"))  # fmt: skip

# Bodies: mass, inertia about the mass centre, and where that centre is in the frame of the body.
crank = Body("crank", mass=Parameter("crank_mass", "kg", 0.30), inertia=Parameter("crank_inertia", "kg m^2", 1.0e-4))
coupler = Body("coupler", mass=Parameter("coupler_mass", "kg", 0.21), inertia=Parameter("coupler_inertia", "kg m^2", 2.5e-4),
               centre=(l / 2, 0, 0))  # fmt: skip
rocker = Body("rocker", mass=Parameter("rocker_mass", "kg", 0.18), inertia=Parameter("rocker_inertia", "kg m^2", 1.5e-4),
              centre=(k / 2, 0, 0))  # fmt: skip

# Joints give the bodies their coordinates. The rocker pin is none: pin and bush are surfaces that may touch.
mechanism = Mechanism(
    "four_bar_clearance",
    joints=(
        Revolute("main_bearing", GROUND, crank, axis=Z),
        Revolute("crank_pin", crank.at(r, 0, 0), coupler, axis=Z),
        Revolute("rocker_bearing", GROUND.at(base, 0, 0), rocker, axis=Z),
    ),
    pairs=(
        PinInBush("rocker_pin", pin=coupler.at(l, 0, 0), bush=rocker.at(k, 0, 0), axis=Z,
                  bush_radius=Parameter("bush_radius", "mm", 10), clearance=c, length=Parameter("bush_length", "mm", 15)),
    ),
)  # fmt: skip

# The ideal mechanism at crank angle 0, the pin centred in its bush: angles of coupler and rocker by the law of cosines, then their speeds.
d = base - r
alpha = sp.acos((l**2 + d**2 - k**2) / (2 * l * d))
beta = sp.pi - sp.acos((k**2 + d**2 - l**2) / (2 * k * d))
of_coupler = -w * r * sp.sin(beta) / (l * sp.sin(beta - alpha))
of_rocker = -w * r * sp.sin(alpha) / (k * sp.sin(beta - alpha))

# Everything that acts. An effect that is not listed here enters no equation.
scene = Scene(
    mechanism,
    effects=(
        ConstantSpeed("crank_drive", joint="main_bearing", speed=w),
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        Contact("rocker_pin", hertz_point(steel, steel), flores(Parameter("restitution", "1", 0.9))),
        Friction("rocker_pin_friction", pair="rocker_pin",
                 law=smooth_coulomb(Parameter("friction_coefficient", "1", 0.1), Parameter("friction_speed", "m/s", 0.1))),
        EnergyLedger(),
    ),
    start=Start(
        position={"crank_pin": alpha, "rocker_bearing": beta},
        speed={"crank_pin": of_coupler - w, "rocker_bearing": of_rocker},
    ),
    # Typical sizes, of lengths in the clearance, speeds and levers: errors count by them.
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="four-bar linkage with one clearance joint",
)  # fmt: skip
