"""Hysteresis damping laws: F (1 + h v/v0), h a function of the coefficient of restitution; e = 1 must give the elastic law."""

from __future__ import annotations

from hertzwerk.derive.laws.law import APPROACH_SPEED, DampingLaw, Quantity
from hertzwerk.derive.parameter import Interval

e = Quantity("e", "1", "coefficient of restitution")

_WHOLE = Interval(0, 1, open_left=True)

hunt_crossley = DampingLaw(
    name="hunt_crossley",
    title="Hunt and Crossley",
    parameters=(e,),
    factor=3 * (1 - e) / 2,
    defined=Interval(0, 1),
    recommended=Interval(0.8, 1),
    memory=(APPROACH_SPEED,),
    source="Hunt, Crossley, J. Appl. Mech. 42 (1975) 440",
    grade="A",
)

lankarani_nikravesh = DampingLaw(
    name="lankarani_nikravesh",
    title="Lankarani and Nikravesh",
    parameters=(e,),
    factor=3 * (1 - e**2) / 4,
    defined=Interval(0, 1),
    recommended=Interval(0.8, 1, open_left=True),
    memory=(APPROACH_SPEED,),
    source="Lankarani, Nikravesh, J. Mech. Des. 112 (1990) 369",
    grade="A",
)

flores = DampingLaw(
    name="flores",
    title="Flores, Machado, Silva and Martins",
    parameters=(e,),
    factor=8 * (1 - e) / (5 * e),
    defined=_WHOLE,
    recommended=_WHOLE,
    memory=(APPROACH_SPEED,),
    source="Flores, Machado, Silva, Martins, Multibody Syst. Dyn. 25 (2011) 357, eq. 18",
    grade="A",
)
