"""Reconstructions (grade R) of the two stiffness laws of Wang and Liu 2020, not accessible to us.

Known of them: one for external, one for internal contact of cylinders, both with the joint's length L and the
exponent n = 1, so K is N/m. These are all dimensionally admissible candidates, each a force that the catalogue has
under another name; the two named after the paper are the defaults: their local exponent is n = 1 too. The sheet of
each shows them as a band. With the paper at hand, replace one expression each.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from hertzwerk.derive.laws.formulas.line import linear
from hertzwerk.derive.laws.formulas.logarithmic import johnson
from hertzwerk.derive.laws.formulas.stiffness import EFFECTIVE_MODULUS, MATERIALS, E_eff
from hertzwerk.derive.laws.law import L, R_min, StiffnessLaw, d, dR

_SOURCE = "reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986"

wang_liu_external = linear(
    sp.pi / 4,
    name="wang_liu_external",
    title="Wang and Liu, external contact of cylinders (reconstruction)",
    source=_SOURCE,
    grade="R",
    note="K = (pi/4) E* L, the same force as popov_line: 2.6 to 3.8 times Johnson's at penetrations of micrometres.",
    pairs=("parallel_cylinders", "cylinder_on_plane"),
)

wang_liu_internal = linear(
    sp.pi / 2,
    name="wang_liu_internal",
    title="Wang and Liu, internal contact of cylinders (reconstruction)",
    source=_SOURCE,
    grade="R",
    note="K = (pi/2) E* L, n = 1 as the paper says: the slope of Persson's law of pin and bush at the onset, the same force as hertz_half_width.",
    pairs=("pin_in_bush",),
)

wang_liu_secant = StiffnessLaw(
    name="wang_liu_secant",
    title="Wang and Liu, internal contact, the secant of Liu's law (reconstruction, further candidate)",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=sp.pi / 2 * E_eff * L * sp.sqrt(d / (2 * (dR + d))) * d,
    exponent=sp.S.One,
    reach=R_min,
    forms=("line",),
    source=_SOURCE,
    grade="R",
    note="K(d) = (pi/2) E* L sqrt(d/(2 (dR + d))), the same force as liu_with_length. Written as K(d) d it has n = 1; its local exponent is 1.5 at "
    "small d, so it is not the default.",
    pairs=("pin_in_bush",),
)

wang_liu_half_width = linear(
    sp.pi / 2,
    name="wang_liu_half_width",
    title="Wang and Liu, external or internal contact, K = (pi/2) E* L (reconstruction, further candidate)",
    source=_SOURCE,
    grade="R",
    note="The same force as hertz_half_width; inside it is that of wang_liu_internal.",
)

wang_liu_johnson = replace(
    johnson,
    name="wang_liu_johnson",
    title="Wang and Liu, external or internal contact, the secant of Johnson's law (reconstruction, further candidate)",
    exponent=sp.S.One,
    source=_SOURCE,
    grade="R",
    note="K(d) = F(d)/d of Johnson's law, so the same force.",
)
