"""Elastic-plastic laws of point contact: Hertz's up to first yield, then softer.

Beyond first yield one published expression takes over from another where it is less, each as printed: the loading force is
continuous. As printed, the fits of Kogut and Etsion jump by 3 and 1.7 %, that of Jackson and Green by up to 3 %.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.parameter import POSITIVE, Parameter
from hertzwerk.derive.laws.formulas.stiffness import (
    EFFECTIVE_MODULUS,
    HERTZ_STIFFNESS,
    MATERIALS,
    E_eff,
    K_hertz,
    nu_1,
)
from hertzwerk.derive.laws.formulas.yield_onset import yield_depth, yield_force
from hertzwerk.derive.laws.law import YIELD_STRENGTH, PlasticLaw, Quantity, R_eff, R_min, d

sigma_y = Quantity(YIELD_STRENGTH, "Pa", "yield strength in simple tension of the body that yields", POSITIVE)
c_p = Quantity("c_p", "1", "pressure that limits the contact over the yield strength", POSITIVE)
p_y = Quantity("p_y", "Pa", "pressure that limits the contact")
F_y = Quantity("F_y", "N", "force at first yield")
d_y = Quantity("d_y", "m", "depth of first yield")
C_nu = Quantity("C", "1", "largest pressure at first yield over the yield strength")
e_y = Quantity("e_y", "1", "yield strength over the effective modulus")
B_y = Quantity("B", "1", "exponent of the contact radius beyond first yield")

_HERTZ = K_hertz * d ** sp.Rational(3, 2)
_x = d / d_y


def _plastic(*stages: sp.Expr, **fields: Any) -> PlasticLaw:
    """Make a law that is Hertz's up to `d_y`, and then by its stages."""
    return PlasticLaw(elastic=_HERTZ, onset=d_y, stages=stages, forms=("point",), **fields)


thornton = _plastic(
    F_y + sp.pi * p_y * R_eff * (d - d_y),
    name="thornton",
    title="Thornton, elastic-perfectly plastic spheres: Hertz's pressure cut off at p_y",
    parameters=(*MATERIALS, sigma_y, c_p),
    defaults=(
        (c_p, Parameter("limiting_pressure", "1", 1.6, "pressure that limits the contact over the yield strength")),
    ),
    definitions=(
        EFFECTIVE_MODULUS,
        HERTZ_STIFFNESS,
        (p_y, c_p * sigma_y),
        (d_y, yield_depth(E_eff, R_eff, p_y)),
        (F_y, yield_force(E_eff, R_eff, p_y)),
    ),
    dent=d - (F_y + sp.pi * p_y * R_eff * (d - d_y)) * d / _HERTZ,
    reach=R_min,
    source="Thornton, J. Appl. Mech. 64 (1997) 383",
    grade="A",
    note="p_y = 1.6 sigma_y is first yield by Johnson; a contact that has yielded fully bears 2.5 to 3 sigma_y, which suits impacts far above first "
    "yield better. Unloading is Hertz's with the contact radius that is left: (d_m - dent)/d_m = F(d_m)/(K d_m^1.5).",
)

kogut_etsion = _plastic(
    _HERTZ,
    sp.Rational("1.03") * F_y * _x ** sp.Rational("1.425"),
    sp.Rational("1.40") * F_y * _x ** sp.Rational("1.263"),
    name="kogut_etsion",
    title="Kogut and Etsion, elastic-plastic sphere against a rigid flat, with the unloading of Etsion, Kligerman and Kadin",
    parameters=(*MATERIALS, sigma_y),
    definitions=(
        EFFECTIVE_MODULUS,
        HERTZ_STIFFNESS,
        (C_nu, sp.Rational("2.8") * (sp.Rational("0.454") + sp.Rational("0.41") * nu_1)),
        (d_y, yield_depth(E_eff, R_eff, C_nu * sigma_y)),
        (F_y, yield_force(E_eff, R_eff, C_nu * sigma_y)),
    ),
    dent=d * (1 - _x ** sp.Rational("-0.28")) * (1 - _x ** sp.Rational("-0.69")),
    steepness=sp.Rational(3, 2) * _x ** sp.Rational("-0.0331"),
    reach=110 * d_y,
    source="Kogut, Etsion, J. Appl. Mech. 69 (2002) 657; unloading: Etsion, Kligerman, Kadin, Int. J. Solids Struct. 42 (2005) 3716",
    grade="C",
    note="The first body yields; its hardness is 2.8 sigma_y. Fits of finite elements up to 110 depths of first yield. Up to 1.1 of them they "
    "return up to 0.05 % more energy than was spent.",
)

_RADIUS = (
    sp.pi * C_nu * e_y / 2 * sp.sqrt(_x * (_x / sp.Rational("1.9")) ** B_y)
)  # of the contact over that of the sphere
_HARDNESS = sp.Rational("2.84") * (
    1 - sp.exp(-sp.Rational("0.82") * _RADIUS ** sp.Rational("-0.7"))
)  # over the yield strength

jackson_green = _plastic(
    _HERTZ,
    F_y
    * (
        sp.exp(-(_x ** sp.Rational(5, 12)) / 4) * _x ** sp.Rational(3, 2)
        + 4 * _HARDNESS / C_nu * (1 - sp.exp(-(_x ** sp.Rational(5, 9)) / 25)) * _x
    ),
    name="jackson_green",
    title="Jackson and Green, elastic-plastic sphere against a rigid flat, with the residual depth of Jackson, Chusoipin and Green",
    parameters=(*MATERIALS, sigma_y),
    definitions=(
        EFFECTIVE_MODULUS,
        HERTZ_STIFFNESS,
        (C_nu, sp.Rational("1.295") * sp.exp(sp.Rational("0.736") * nu_1)),
        (e_y, sigma_y / E_eff),
        (B_y, sp.Rational("0.14") * sp.exp(23 * e_y)),
        (d_y, yield_depth(E_eff, R_eff, C_nu * sigma_y)),
        (F_y, yield_force(E_eff, R_eff, C_nu * sigma_y)),
    ),
    dent=d * sp.Rational("1.02") * (1 - ((_x + sp.Rational("5.9")) / sp.Rational("6.9")) ** sp.Rational("-0.54")),
    reach=d_y * ((2 * sp.Rational("0.41") / (sp.pi * C_nu * e_y)) ** 2 * sp.Rational("1.9") ** B_y) ** (1 / (1 + B_y)),
    source="Jackson, Green, J. Tribol. 127 (2005) 343; unloading: Jackson, Chusoipin, Green, J. Tribol. 127 (2005) 484, and "
    "Jackson, Green, Marghitu, Nonlinear Dyn. 60 (2010) 217",
    grade="C",
    note="The first body yields. Fits of finite elements up to a contact radius of 0.41 R; the hardness falls as the contact grows.",
)
