"""A steel ball that slides to and fro on a plate of polymer and wears its track: a wear test.

Ball, load and stroke as of procedure A of ASTM G133, from general knowledge (C). The plate's elasticity and specific wear rate,
those of a soft filled polymer, are our choice. Wear spreads along the track as Hertz's pressure does for 32 sectors.
"""

from sympy import Rational, sqrt

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Harmonic,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Wear,
    X,
    Y,
)
from hertzwerk.derive.laws import kelvin_voigt, power, smooth_coulomb

R = Parameter("radius", "mm", 4.7625, "of the ball")
load = Parameter("load", "kg", 25 / 9.81, "dead weight on the ball, which moves with it")
g = Parameter("gravity", "m/s^2", 9.81)
stroke = Parameter("stroke", "mm", 10)
pace = Parameter("pace", "rpm", 300, "strokes to and fro")
E, nu = Parameter("youngs_modulus", "GPa", 0.8, "of the plate"), Parameter("poissons_ratio", "1", 0.4, "of the plate")

carriage, ball = Body("carriage", Parameter("carriage_mass", "kg", 0.5)), Body("ball", load)
K = Rational(4, 3) * E / (1 - nu**2) * sqrt(R)  # of a rigid ball
sunk = (load * g / K) ** Rational(2, 3)

scene = Scene(
    Mechanism(
        "worn_track",
        joints=(Prismatic("along", GROUND, carriage, axis=X), Prismatic("down", carriage, ball, axis=-Y)),
        pairs=(SphereOnPlane("plate", ball.at(0, 0, 0), R, GROUND.at(0, -R, 0), normal=Y),),
    ),
    effects=(
        Gravity("gravity", g, direction=-Y),
        Harmonic("drive", "along", stroke / 2, pace),
        Contact("plate", power(K, Rational(3, 2)), kelvin_voigt(Parameter("restitution", "1", 0.3))),
        Friction("plate_friction", "plate", smooth_coulomb(Parameter("friction", "1", 0.2), Parameter("friction_speed", "mm/s", 1))),
        Wear("wear", "plate", second=Parameter("wear_rate", "mm^3/(N m)", 1e-4, "volume lost for each newton metre of the plate"),
             acceleration=Parameter("repetitions", "1", 1000, "strokes that one of the run stands for"),
             track=Parameter("track", "mm", 16), along=X),
        EnergyLedger(),
    ),
    start=Start(position={"down": sunk}),
    scales=Scales(length=sunk, speed=pace * stroke / 2),
    summary="ball that wears its track, to and fro",
)  # fmt: skip
