"""Slider-crank with clearance at both pins, driven by a direct-current motor: impacts slow the crank.

Crank and rotor are free; a sampled PI controller that sets the motor's voltage keeps their speed. Mechanism and data as
with two clearances; motor, rotor and controller our choice. Without contact the motor without load keeps the crank at its speed, so
that the first impact is that of the prescribed speed.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    DCMotor,
    EnergyLedger,
    Mechanism,
    Parameter,
    Planar,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SpeedController,
    Start,
    Weld,
    X,
    Z,
)
from hertzwerk.derive.scenes import slider_crank as one
from hertzwerk.derive.scenes.slider_crank import c, crank, l, r, rod, slider, w
from hertzwerk.derive.scenes.slider_crank_two_clearances import crank_pin, effects, position, slider_pin, speed

constant = Parameter("motor_constant", "N m/A", 0.1, "torque for each ampere, back EMF for each rad/s")
rotor = Body("rotor", mass=Parameter("rotor_mass", "kg", 1), inertia=Parameter("rotor_inertia", "kg m^2", 2e-3))
control = SpeedController(
    "speed_control",
    joint="main_bearing",
    target=w,
    proportional=Parameter("proportional_gain", "V s/rad", 0.2),
    integral=Parameter("integral_gain", "V/rad", 20),
    unit="V",
    period=Parameter("sampling_period", "ms", 0.5),
)

scene = Scene(
    Mechanism(
        "slider_crank_dc_motor",
        joints=(
            Revolute("main_bearing", GROUND, crank, axis=Z),
            Weld("shaft", crank, rotor),
            Planar("rod_plane", GROUND, rod),
            Prismatic("guide", GROUND, slider, axis=X),
        ),
        pairs=(crank_pin, slider_pin),
    ),
    effects=(
        DCMotor(
            "motor",
            joint="main_bearing",
            voltage=constant * w + control.command,
            resistance=Parameter("motor_resistance", "ohm", 0.5),
            inductance=Parameter("motor_inductance", "mH", 1),
            constant=constant,
        ),
        control,
        one.scene.effect("gravity"),
        *effects("crank_pin", "slider_pin"),
        EnergyLedger(),
    ),
    start=Start(position=position, speed={"main_bearing": w, **speed}),
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="slider-crank, two clearances, controlled DC motor",
)
