"""Slider-crank whose pin runs in thin oil: its film gives way to dry contact, and builds up again.

Data as of `slider_crank_line`. The viscosity, 5 mPa s, and the boundary layer, 5 um, are our choice, as the data of P. Flores,
J. Ambrosio, J. C. P. Claro, H. M. Lankarani, C. S. Koshy, A study on dynamics of mechanical systems including joints with clearance
and lubrication, Mech. Mach. Theory 41 (2006) 247, were not available.
"""

from dataclasses import replace

from hertzwerk.derive import Lubrication, Parameter
from hertzwerk.derive.laws import short_bearing
from hertzwerk.derive.scenes.slider_crank_line import scene as dry

film = Lubrication(
    "oil", "slider_pin", short_bearing(Parameter("viscosity", "mPa s", 5)), Parameter("boundary_layer", "um", 5)
)
*effects, ledger = dry.effects
scene = replace(dry, effects=(*effects, film, ledger)).named(
    "lubricated_slider_crank", "slider-crank, pin in oil and in dry contact"
)
