"""Stiffness laws of line contact of parallel cylinders, or pin and bush, of axial length L.

See `logarithmic` for those published as d(F).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import Interval, Parameter
from hertzwerk.derive.laws.formulas.stiffness import (
    EFFECTIVE_MODULUS,
    HERTZ_STIFFNESS,
    MATERIALS,
    REVIEW,
    E_eff,
    K_hertz,
    n,
)
from hertzwerk.derive.laws.law import F, L, Quantity, R_min, Range, StiffnessLaw, d, dR

# -- fits with a hidden unit, and their repairs ------------------------------------------------------------------------

l_ref = Quantity("l_ref", "m", "reference length of the fit, 1 mm", Interval(1e-3, 1e-3))
p_ref = Quantity("p_ref", "Pa", "reference pressure of the fit, 1 MPa", Interval(1e6, 1e6))
F_ref = Quantity("F_ref", "N", "reference force of the fit, 1 N", Interval(1, 1))
_LENGTH = (l_ref, Parameter("reference_length", "mm", 1, "unit the fit was made in: not to be changed"))
_PRESSURE = (p_ref, Parameter("reference_pressure", "MPa", 1, "unit the fit was made in: not to be changed"))
_FORCE = (F_ref, Parameter("reference_force", "N", 1, "unit the fit was made in: not to be changed"))

c_P = Quantity("c_P", "1", "constant of Palmgren's fit")
a = Quantity("a", "1", "constant of the fit")
b = Quantity("b", "1", "constant of the fit")
Y_1 = Quantity("Y_1", "1", "Y for dR up to 0.34954 mm")
Y_2 = Quantity("Y_2", "1", "Y for dR from 0.34954 mm on")
Y = Quantity("Y", "1", "exponent but for the factor dR^-0.005")
n_fit = Quantity("n", "1", "exponent of the fit")
_LIMIT = sp.Rational("0.34954")  # mm, where the two branches of Y meet


def _palmgren(length: Any, force: Any, **fields: Any) -> StiffnessLaw:
    """Palmgren's fit with d and L in units of `length` and F in units of `force`.

    As published both are 1, which hides the units.
    """
    elastic = force * (d / length * (L / length) ** sp.Rational(4, 5) / c_P) ** sp.Rational(10, 9)
    return StiffnessLaw(
        definitions=((c_P, sp.Rational("3.84e-5")),),
        relation=length * c_P * (F / force) ** sp.Rational(9, 10) / (L / length) ** sp.Rational(4, 5),
        force=elastic,
        stored=sp.Rational(9, 19) * d * elastic,
        exponent=sp.Rational(10, 9),
        reach=R_min,
        forms=("line",),
        source="Palmgren, Ball and Roller Bearing Engineering (1959)",
        grade="C",
        **fields,
    )


palmgren = _palmgren(
    1,
    1,
    name="palmgren",
    title="Palmgren, steel roller on a raceway, as published",
    parameters=(),
    verdict="outside_si",
    fitted_in="mm, N",
    repair="palmgren_si",
)

palmgren_si = _palmgren(
    l_ref,
    F_ref,
    name="palmgren_si",
    title="Palmgren, steel roller on a raceway, with its reference length and force named",
    parameters=(l_ref, F_ref),
    defaults=(_LENGTH, _FORCE),
    note="For steel only: the modulus is in the constant.",
)


def _pereira(length: Any, pressure: Any, fit: tuple[tuple[Quantity, sp.Expr], ...], **fields: Any) -> StiffnessLaw:
    """The fit of Pereira et al. with lengths in units of `length` and E* in units of `pressure`.

    As published both are 1, which hides the units. The reference pressure cancels: the force is proportional to E*.
    """
    width = (a * dR / length + b) * (L / length) * (E_eff / pressure) / (dR / length)
    elastic = pressure * length**2 * width * (d / length) ** n_fit
    return StiffnessLaw(
        definitions=(EFFECTIVE_MODULUS, *fit),
        force=elastic,
        stored=d * elastic / (n_fit + 1),
        exponent=n_fit,
        reach=R_min,
        forms=("line",),
        source=f"{REVIEW}, fitted to Johnson's law",
        grade="B",
        **fields,
    )


def _internal(length: Any) -> tuple[tuple[Quantity, sp.Expr], ...]:
    clearance = dR / length
    return (
        (a, sp.Rational("0.965")),
        (b, sp.Rational("0.0965")),
        (Y_1, sp.Rational("1.51") * sp.log(1000 * clearance) ** sp.Rational("-0.151")),
        (Y_2, sp.Rational("0.0151") * clearance + sp.Rational("1.151")),
        (Y, Where(clearance <= _LIMIT, Y_1, Y_2)),
        (n_fit, Y * clearance ** sp.Rational("-0.005")),
    )


_EXTERNAL = ((a, sp.Rational("0.39")), (b, sp.Rational("0.85")), (n_fit, sp.Rational("1.094")))
_FITTED_CLEARANCE = (Range(dR, Interval(5e-6, 1e-2), "defined"),)  # .005 to 10 mm

pereira_internal = _pereira(
    1,
    1,
    _internal(1),
    name="pereira_internal",
    title="Pereira, Ramalho and Ambrosio, pin in bush, as published",
    parameters=MATERIALS,
    ranges=_FITTED_CLEARANCE,
    verdict="outside_si",
    fitted_in="mm, N, MPa",
    repair="pereira_internal_si",
    pairs=("pin_in_bush",),
)

pereira_internal_si = _pereira(
    l_ref,
    p_ref,
    _internal(l_ref),
    name="pereira_internal_si",
    title="Pereira, Ramalho and Ambrosio, pin in bush, with its reference length and pressure named",
    parameters=(*MATERIALS, l_ref, p_ref),
    defaults=(_LENGTH, _PRESSURE),
    ranges=_FITTED_CLEARANCE,
    pairs=("pin_in_bush",),
)

pereira_external = _pereira(
    1,
    1,
    _EXTERNAL,
    name="pereira_external",
    title="Pereira, Ramalho and Ambrosio, cylinders side by side, as published",
    parameters=MATERIALS,
    verdict="outside_si",
    fitted_in="mm, N, MPa",
    repair="pereira_external_si",
    pairs=("parallel_cylinders",),
)

pereira_external_si = _pereira(
    l_ref,
    p_ref,
    _EXTERNAL,
    name="pereira_external_si",
    title="Pereira, Ramalho and Ambrosio, cylinders side by side, with its reference length and pressure named",
    parameters=(*MATERIALS, l_ref, p_ref),
    defaults=(_LENGTH, _PRESSURE),
    pairs=("parallel_cylinders",),
)

lankarani_nikravesh_cylinders = StiffnessLaw(
    name="lankarani_nikravesh_cylinders",
    title="Lankarani-Nikravesh law for cylinders (1994)",
    parameters=(*MATERIALS, n),
    definitions=(EFFECTIVE_MODULUS, HERTZ_STIFFNESS),
    force=K_hertz * d**n,
    stored=K_hertz * d ** (n + 1) / (n + 1),
    exponent=n,
    forms=("line",),
    ranges=(Range(n, Interval(1, 1.5), "recommended"),),
    source="Lankarani, Nikravesh, Nonlinear Dyn. 5 (1994) 193; used with n in 1..1.5 and no length",
    grade="A",
    verdict="inconsistent",
    repair="hertz_point",
    note="Consistent only with n = 3/2, where it is Hertz's point contact; a line contact needs a length.",
)

# -- the cylindrical joint fitted to finite elements, and what was made of it ------------------------------------------

_LIU = sp.pi / 2 * E_eff * d * sp.sqrt(d / (2 * (dR + d)))  # per length
_TANGENT = sp.pi * E_eff / 8 * (3 * dR + 2 * d) * sp.sqrt(2 * d / (dR + d) ** 3)
_LIU_SOURCE = "Liu, Zhang, Yang, Mech. Mach. Theory 42 (2007) 183"
_HYBRID_SOURCE = "Bai, Zhao, Int. J. Non-Linear Mech. 48 (2013) 15"

liu = StiffnessLaw(
    name="liu",
    title="Liu, Zhang and Yang, cylindrical joint, as printed (without a length)",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=_LIU,
    reach=R_min,
    forms=("line",),
    source=_LIU_SOURCE,
    grade="A",
    verdict="inconsistent",
    repair="liu_with_length",
)

liu_with_length = StiffnessLaw(
    name="liu_with_length",
    title="Liu, Zhang and Yang, cylindrical joint, with its length",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=L * _LIU,
    reach=R_min,
    forms=("line",),
    source=_LIU_SOURCE,
    grade="A",
)

bai_zhao = StiffnessLaw(
    name="bai_zhao",
    title="Bai and Zhao, hybrid law of a revolute joint with clearance, n = 3/2",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=_TANGENT * d ** sp.Rational(3, 2),
    exponent=sp.Rational(3, 2),
    reach=R_min,
    forms=("line",),
    source=_HYBRID_SOURCE,
    grade="A",
    verdict="inconsistent",
    repair="bai_zhao_repaired",
    note="The stiffness is the derivative of Liu's force per length, so Pa. Its own damping is zhiying_qishao.",
)

bai_zhao_repaired = StiffnessLaw(
    name="bai_zhao_repaired",
    title="Bai and Zhao, hybrid law of a revolute joint with clearance, with a length and n = 1",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=_TANGENT * L * d,
    reach=R_min,
    forms=("line",),
    source=_HYBRID_SOURCE,
    grade="A",
    note="Units hold, yet a tangent stiffness is used as a secant: 1.5 times too stiff at small d. liu_with_length is the law itself.",
)

_PERSSON_B2 = d / (2 * dR + d)  # b^2 = tan^2(eps/2) where cos eps = dR/(dR + d)

persson = StiffnessLaw(
    name="persson",
    title="Persson, conforming contact of pin and bush",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS,),
    force=2
    * sp.pi
    * E_eff
    * L
    * dR
    * (_PERSSON_B2 + 1)
    * _PERSSON_B2
    / (2 - sp.log(_PERSSON_B2 + 1) - 2 * _PERSSON_B2**2),
    reach=8 * dR,
    forms=("line", "surface"),
    source="Persson, On the stress distribution of cylindrical elastic bodies in contact, Chalmers (1964)",
    grade="B",
    note="b = tan(eps/2), cos eps = dR/(dR + d). The denominator vanishes at b^2 = 0.835, d = 10.1 dR; the reach is b^2 = 0.8.",
    pairs=("pin_in_bush",),
)

# -- linear laws -------------------------------------------------------------------------------------------------------


def linear(share: sp.Expr, **fields: Any) -> StiffnessLaw:
    """Build the law F = `share` E* L d."""
    return StiffnessLaw(
        parameters=MATERIALS,
        definitions=(EFFECTIVE_MODULUS,),
        force=share * E_eff * L * d,
        stored=share / 2 * E_eff * L * d**2,
        exponent=sp.S.One,
        reach=R_min,
        forms=("line",),
        **fields,
    )


popov_line = linear(
    sp.pi / 4,
    name="popov_line",
    title="Popov, line contact of a cylinder",
    source="Popov, Contact Mechanics and Friction (2010), chapter 5",
    grade="B",
)

hertz_half_width = linear(
    sp.pi / 2,
    name="hertz_half_width",
    title="Hertz's half-width with the geometry of the chord",
    source="a^2 = 4 F R/(pi E* L) (Hertz) with a^2 = 2 R d, the chord at depth d",
    grade="A",
)
