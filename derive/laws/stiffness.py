"""Stiffness laws: elastic normal force over penetration. Stiffness and exponent belong together: K d^n must be newton."""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.laws.law import Quantity, R_eff, R_min, StiffnessLaw, d
from hertzwerk.derive.parameter import POSITIVE, Interval

E_1 = Quantity("E_1", "Pa", "Young's modulus of the first body", POSITIVE)
nu_1 = Quantity("nu_1", "1", "Poisson's ratio of the first body", Interval(-1, 0.5, open_left=True))
E_2 = Quantity("E_2", "Pa", "Young's modulus of the second body", POSITIVE)
nu_2 = Quantity("nu_2", "1", "Poisson's ratio of the second body", Interval(-1, 0.5, open_left=True))
E_eff = Quantity("E_eff", "Pa", "effective modulus, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2")
n = Quantity("n", "1", "exponent", Interval(lower=1, upper=10))
K_n = Quantity("K", "N/m^n", "stiffness", POSITIVE)
K_hertz = Quantity("K", "N/m^1.5", "(4/3)*E_eff*sqrt(R_eff), Hertz stiffness of a point contact")

_EFFECTIVE_MODULUS = (E_eff, 1 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2))
_HERTZ_STIFFNESS = (K_hertz, sp.Rational(4, 3) * E_eff * sp.sqrt(R_eff))

hertz_point = StiffnessLaw(
    name="hertz_point",
    title="Hertz, point contact of two spheres, a sphere and a plane, or a ball in a socket",
    parameters=(E_1, nu_1, E_2, nu_2),
    definitions=(_EFFECTIVE_MODULUS, _HERTZ_STIFFNESS),
    force=K_hertz * d ** sp.Rational(3, 2),
    stored=sp.Rational(2, 5) * K_hertz * d ** sp.Rational(5, 2),
    exponent=sp.Rational(3, 2),
    reach=R_min,
    source="Hertz 1882; Johnson, Contact Mechanics (1985), section 4.2",
    grade="A",
)

power = StiffnessLaw(
    name="power",
    title="Power law, stiffness and exponent given",
    parameters=(K_n, n),
    force=K_n * d**n,
    stored=K_n * d ** (n + 1) / (n + 1),
    exponent=n,
    source="Hertz's law with the exponent left open; K carries the unit N/m^n",
    grade="A",
)

lankarani_nikravesh_cylinders = StiffnessLaw(
    name="lankarani_nikravesh_cylinders",
    title="Lankarani-Nikravesh law for cylinders (1994)",
    parameters=(E_1, nu_1, E_2, nu_2, n),
    definitions=(_EFFECTIVE_MODULUS, _HERTZ_STIFFNESS),
    force=K_hertz * d**n,
    stored=K_hertz * d ** (n + 1) / (n + 1),
    exponent=n,
    source="Lankarani, Nikravesh, Nonlinear Dynamics 5 (1994) 193; used with n in 1..1.5 and no length",
    grade="A",
)
