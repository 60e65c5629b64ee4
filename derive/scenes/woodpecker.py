"""The woodpecker toy: a sleeve with play on a bar, a bird on a spring at it, a beak that hits the bar.

It jams, slips and hits in turn and pecks its way down on a limit cycle. Data: Ch. Glocker, Dynamik von
Starrkoerpersystemen mit Reibung und Stoessen, thesis, TU Muenchen, 1995, pp. 162 ff., as the public code Siconos states
them (grade B); the toy as in Pfeiffer, Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 10. There
contacts are rigid and friction is Coulomb's; the compliance, and the layer that smooths friction, are our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    CornerOnFace,
    Direction,
    EnergyLedger,
    Friction,
    Gravity,
    JointSpring,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import hunt_crossley, power, smooth_coulomb

BAR, SLEEVE = Parameter("bar_radius", "mm", 2.5), Parameter("sleeve_radius", "mm", 3.1)
HALF, HINGE = Parameter("sleeve_half_height", "mm", 5.8), Parameter("hinge", "mm", 10)
CENTRE = Parameter("bird_centre", "mm", 15, "from the hinge")
BEAK = Parameter("beak_back", "mm", 20.1, "from the bird's mass centre"), Parameter("beak_height", "mm", 20)
LAYER = Parameter("friction_speed", "m/s", 1e-5)


carriage = Body("carriage", 0)
light, heavy = Parameter("sleeve_mass", "g", 0.3), Parameter("bird_mass", "g", 4.5)
wall, arm = (HINGE - SLEEVE) / 4, 3 * (HINGE - SLEEVE) / 4
outlines = {  # for pictures: sleeve and arm, bird and beak
    "sleeve": (
        Body.box("wall", wall, 2 * HALF, wall, mass=light, centre=(SLEEVE + wall / 2, 0, 0)),
        Body.box("back", wall, 2 * HALF, wall, mass=light, centre=(-SLEEVE - wall / 2, 0, 0)),
        Body.rod("arm", arm, mass=light, centre=(HINGE - arm / 2, 0, 0)),
    ),
    "bird": (
        Body.cylinder("breast", CENTRE / 2, CENTRE, mass=heavy, centre=(CENTRE, 0, 0)),
        Body.cylinder("head", CENTRE / 4, CENTRE, mass=heavy, centre=(CENTRE - BEAK[0] / 3, BEAK[1] * 4 / 5, 0)),
        Body.rod(
            "neck",
            BEAK[1] * 2 / 3,
            mass=heavy,
            axis=Direction((-1, 3, 0)),
            centre=(CENTRE - BEAK[0] / 6, BEAK[1] / 2, 0),
        ),
        Body.rod(
            "beak",
            2 * BEAK[0] / 3,
            mass=heavy,
            axis=Direction((-BEAK[0] * 2 / 3, BEAK[1] / 5, 0)),
            centre=(CENTRE - 2 * BEAK[0] / 3, BEAK[1] * 9 / 10, 0),
        ),
    ),
}
shapes = {name: tuple(shape for part in parts for shape in part.shapes) for name, parts in outlines.items()}
sleeve = Body("sleeve", light, Parameter("sleeve_inertia", "kg m^2", 5e-9), shapes=shapes["sleeve"])
bird = Body("bird", heavy, Parameter("bird_inertia", "kg m^2", 7e-7), centre=(CENTRE, 0, 0), shapes=shapes["bird"])
face = GROUND.at(BAR, 0, 0)
corners = {
    "upper": sleeve.at(SLEEVE, HALF, 0),
    "lower": sleeve.at(SLEEVE, -HALF, 0),
    "beak": bird.at(CENTRE - BEAK[0], BEAK[1], 0),
}
compliant = power(Parameter("stiffness", "N/m^1.5", 1e6), 1.5)
damped = {
    name: hunt_crossley(Parameter(f"{of}_restitution", "1", e))
    for name, of, e in (("upper", "sleeve", 0.05), ("lower", "sleeve", 0.05), ("beak", "beak", 0.5))
}
rubbing = smooth_coulomb(Parameter("friction_coefficient", "1", 0.3), LAYER)
scene = Scene(
    Mechanism(
        "woodpecker",
        joints=(
            Prismatic("fall", GROUND, carriage, axis=Y),
            Revolute("tilt", carriage, sleeve, axis=Z),
            Revolute("spring_hinge", sleeve.at(HINGE, 0, 0), bird, axis=Z),
        ),
        pairs=tuple(CornerOnFace(name, corner, face, X) for name, corner in corners.items()),
    ),
    effects=(
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        JointSpring("spring", "spring_hinge", Parameter("spring_stiffness", "N m/rad", 5.6e-3)),
        *(Contact(name, compliant, damped[name]) for name in corners),
        *(Friction(f"{name}_friction", pair=name, law=rubbing) for name in corners),
        EnergyLedger(),
    ),
    start=Start(
        position={
            "tilt": Parameter("start_tilt", "rad", -0.1036),
            "spring_hinge": Parameter("bent", "rad", -0.1752),
        },
        speed={
            "fall": Parameter("start_fall", "m/s", -0.3411),
            "spring_hinge": Parameter("start_bend", "rad/s", -7.4583),
        },
    ),
    scales=Scales(length=SLEEVE - BAR, speed=Parameter("pace", "m/s", 0.3), arm=HALF),
    summary="limit cycle of jamming, slipping and pecking",
)
