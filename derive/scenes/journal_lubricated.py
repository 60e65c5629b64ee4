"""A journal at constant speed in a short bearing, carried by its oil film under a steady load.

Released from the middle it settles where Ocvirk's short-bearing film balances the load: eccentric, and ahead of the
load by the attitude angle. The load is the sum of all forces on the journal, its weight included. Data of our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Lubrication,
    Mechanism,
    Parameter,
    PinInBush,
    Planar,
    PointForce,
    Scales,
    Scene,
    Z,
)
from hertzwerk.derive.laws import flores, power, short_bearing

m = Parameter("mass", "kg", 2.0, "of the journal and what it carries")
w = Parameter("speed", "rpm", 1500, "of the journal")
load = Parameter("load", "N", 300, "downwards")
R = Parameter("bush_radius", "mm", 20)
c = Parameter("clearance", "um", 50, "bush radius minus journal radius")

journal = Body("journal", m, Parameter("inertia", "kg m^2", 4e-4))

mechanism = Mechanism(
    "journal_lubricated",
    joints=(Planar("shaft", GROUND, journal),),
    pairs=(PinInBush("bearing", pin=journal.at(0, 0, 0), bush=GROUND.at(0, 0, 0), axis=Z, bush_radius=R, clearance=c,
                     length=Parameter("length", "mm", 10)),),
)  # fmt: skip

scene = Scene(
    mechanism,
    effects=(
        ConstantSpeed("motor", joint="shaft.angle", speed=w),
        PointForce("load", journal.at(0, 0, 0), (0, -load, 0)),
        Contact("bearing", power(Parameter("contact_stiffness", "N/m^1.5", 1e10), 1.5), flores(Parameter("restitution", "1", 0.5))),
        Lubrication("oil", "bearing", short_bearing(Parameter("viscosity", "Pa s", 0.05)), Parameter("boundary_layer", "um", 0.5)),
        EnergyLedger(),
    ),
    scales=Scales(length=c, speed=R * w, arm=R),
    summary="loaded journal on the oil film of a short bearing",
)  # fmt: skip
