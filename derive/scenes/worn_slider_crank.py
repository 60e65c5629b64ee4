"""Slider-crank with clearance whose dry pin and bush wear, a revolution counted for ten thousand.

Data as of `slider_crank_line`. The specific wear rates of pin and bush, 1e-6 mm^3/(N m), are our choice, as the data of P. Flores,
Modeling and simulation of wear in revolute clearance joints in multibody systems, Mech. Mach. Theory 44 (2009) 1211, were not
available. The arc of contact is 0.27 rad wide on average in two revolutions, for which 32 sectors are the right number.
"""

from dataclasses import replace

from hertzwerk.derive import Parameter, Wear
from hertzwerk.derive.scenes.slider_crank_line import scene as unworn

rate = Parameter("wear_rate", "mm^3/(N m)", 1e-6, "volume lost for each newton metre of pin and bush")
wear = Wear("wear", "slider_pin", first=rate, second=rate,
            acceleration=Parameter("repetitions", "1", 1e4, "revolutions that one of the run stands for"))  # fmt: skip
*effects, ledger = unworn.effects
scene = replace(unworn, effects=(*effects, wear, ledger)).named(
    "worn_slider_crank", "slider-crank, clearance joint that wears"
)
