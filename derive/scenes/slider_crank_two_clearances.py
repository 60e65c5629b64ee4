"""Slider-crank with clearance at crank pin and slider pin; the rod moves freely in the plane.

Source: two clearance joints at once, Flores, Lankarani, J. Comput. Nonlinear Dyn. 7 (2012) 031003; data as with one.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Mechanism,
    Parameter,
    PinInBush,
    Planar,
    Point,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    X,
    Z,
)
from hertzwerk.derive.laws import hertz_point, lankarani_nikravesh, smooth_coulomb
from hertzwerk.derive.scenes import slider_crank as one
from hertzwerk.derive.scenes.slider_crank import c, crank, l, r, rod, slider, steel, w

e, R, b = Parameter("restitution", "1", 0.9), Parameter("bush_radius", "mm", 10), Parameter("bush_length", "mm", 15)
rubbing = smooth_coulomb(Parameter("friction_coefficient", "1", 0.1), Parameter("friction_speed", "m/s", 0.1))


def clearance(name: str, pin: Point, bush: Point) -> PinInBush:
    """Revolute joint with clearance, of the common size."""
    return PinInBush(name, pin=pin, bush=bush, axis=Z, bush_radius=R, clearance=c, length=b)


def effects(*pins: str) -> tuple[Contact | Friction, ...]:
    """Normal force and friction of each clearance joint."""
    contacts = tuple(Contact(pin, hertz_point(steel, steel), lankarani_nikravesh(e)) for pin in pins)
    return (*contacts, *(Friction(f"{pin}_friction", pin, rubbing) for pin in pins))


crank_pin = clearance("crank_pin", crank.at(r, 0, 0), rod.at(0, 0, 0))
slider_pin = clearance("slider_pin", rod.at(l, 0, 0), slider.at(0, 0, 0))

# The ideal mechanism at crank angle 0, all pins centred in their bushes: the rod turns about the slider's pin.
position = {"rod_plane.x": r, "guide": r + l}
speed = {"rod_plane.y_speed": r * w, "rod_plane.angle_speed": -r * w / l}

scene = Scene(
    Mechanism(
        "slider_crank_two_clearances",
        joints=(
            Revolute("main_bearing", GROUND, crank, axis=Z),
            Planar("rod_plane", GROUND, rod),
            Prismatic("guide", GROUND, slider, axis=X),
        ),
        pairs=(crank_pin, slider_pin),
    ),
    effects=(
        ConstantSpeed("crank_drive", joint="main_bearing", speed=w),
        one.scene.effect("gravity"),
        *effects("crank_pin", "slider_pin"),
        EnergyLedger(),
    ),
    start=Start(position=position, speed=speed),
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="slider-crank with clearance at both rod pins",
)
