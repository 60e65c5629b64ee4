"""A journal at constant speed in a dry bush with clearance, under a steady load.

Released from the middle it bounces, climbs the bush against its rotation, and settles where the contact force, normal
and friction together, balances the load. The load is the sum of all forces on the journal, its weight included. Data
of our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Mechanism,
    Parameter,
    PinInBush,
    Planar,
    PointForce,
    Scales,
    Scene,
    Z,
)
from hertzwerk.derive.laws import flores, power, smooth_coulomb

m = Parameter("mass", "kg", 1.0, "of the journal and what it carries")
w = Parameter("speed", "rpm", 100, "of the journal")
load = Parameter("load", "N", 500, "downwards")
c = Parameter("clearance", "mm", 0.5, "bush radius minus journal radius")
n = Parameter("exponent", "1", 1.5, "exponent of the force law")
K = Parameter("contact_stiffness", "N/m^exponent", 1e10)

R, length = Parameter("bush_radius", "mm", 10), Parameter("bush_length", "mm", 15)
journal = Body("journal", m, Parameter("inertia", "kg m^2", 1e-4))

mechanism = Mechanism(
    "journal_in_bearing",
    joints=(Planar("shaft", GROUND, journal),),
    pairs=(
        PinInBush(
            "bearing",
            pin=journal.at(0, 0, 0),
            bush=GROUND.at(0, 0, 0),
            axis=Z,
            bush_radius=R,
            clearance=c,
            length=length,
        ),
    ),
)

scene = Scene(
    mechanism,
    effects=(
        ConstantSpeed("motor", joint="shaft.angle", speed=w),
        PointForce("load", journal.at(0, 0, 0), (0, -load, 0)),
        Contact("bearing", power(K, n), flores(Parameter("restitution", "1", 0.5))),
        Friction("bearing_friction", "bearing",
                 smooth_coulomb(Parameter("friction_coefficient", "1", 0.2), Parameter("friction_speed", "m/s", 0.1))),
        EnergyLedger(),
    ),
    scales=Scales(length=c, speed=R * w, arm=R),
    summary="loaded journal turning in a bush with clearance",
)  # fmt: skip
