"""Slider-crank with clearance at main bearing, crank pin and slider pin; crank and rod move freely.

A motor turns the crank at constant speed through a coupling that lets its shaft move sideways: the crank's angle is
driven, its position is not. Data as with one clearance.
"""

from hertzwerk.derive import GROUND, ConstantSpeed, EnergyLedger, Mechanism, Planar, Prismatic, Scales, Scene, Start, X
from hertzwerk.derive.scenes import slider_crank as one
from hertzwerk.derive.scenes.slider_crank import c, crank, l, r, rod, slider, w
from hertzwerk.derive.scenes.slider_crank_two_clearances import (
    clearance,
    crank_pin,
    effects,
    position,
    slider_pin,
    speed,
)

scene = Scene(
    Mechanism(
        "slider_crank_three_clearances",
        joints=(
            Planar("crank_plane", GROUND, crank),
            Planar("rod_plane", GROUND, rod),
            Prismatic("guide", GROUND, slider, axis=X),
        ),
        pairs=(clearance("main_bearing", crank.at(0, 0, 0), GROUND.at(0, 0, 0)), crank_pin, slider_pin),
    ),
    effects=(
        ConstantSpeed("crank_drive", joint="crank_plane.angle", speed=w),
        one.scene.effect("gravity"),
        *effects("main_bearing", "crank_pin", "slider_pin"),
        EnergyLedger(),
    ),
    start=Start(position=position, speed=speed),
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="slider-crank with clearance at all three pins",
)
