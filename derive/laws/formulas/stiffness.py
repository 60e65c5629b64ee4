"""Stiffness laws of point contact, and the power law.

Stiffness and exponent belong together: K d^n must have the unit newton.
"""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.expressions.parameter import POSITIVE, Interval
from hertzwerk.derive.laws.law import FORMS, Quantity, R_eff, R_min, StiffnessLaw, d

E_1 = Quantity("E_1", "Pa", "Young's modulus of the first body", POSITIVE)
nu_1 = Quantity("nu_1", "1", "Poisson's ratio of the first body", Interval(-1, 0.5, open_left=True))
E_2 = Quantity("E_2", "Pa", "Young's modulus of the second body", POSITIVE)
nu_2 = Quantity("nu_2", "1", "Poisson's ratio of the second body", Interval(-1, 0.5, open_left=True))
MATERIALS = (E_1, nu_1, E_2, nu_2)
E_eff = Quantity("E_eff", "Pa", "effective modulus, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2")
EFFECTIVE_MODULUS = (E_eff, 1 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2))

REVIEW = "Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681"  # quotes most laws of line contact

n = Quantity("n", "1", "exponent", Interval(lower=1, upper=10))
K_n = Quantity("K", "N/m^n", "stiffness", POSITIVE)
K_hertz = Quantity("K", "N/m^1.5", "(4/3)*E_eff*sqrt(R_eff), Hertz stiffness of a point contact")
HERTZ_STIFFNESS = (K_hertz, sp.Rational(4, 3) * E_eff * sp.sqrt(R_eff))

k = Quantity("k", "1", "exponent of the profile C r^k", Interval(lower=0.1, upper=100))
C = Quantity("C", "m^(1-k)", "coefficient of the profile C r^k", POSITIVE)
kappa = Quantity("kappa", "1", "sqrt(pi) gamma(1 + k/2)/gamma((1 + k)/2)")

hertz_point = StiffnessLaw(
    name="hertz_point",
    title="Hertz, point contact of two spheres, a sphere and a plane, or a ball in a socket",
    parameters=MATERIALS,
    definitions=(EFFECTIVE_MODULUS, HERTZ_STIFFNESS),
    force=K_hertz * d ** sp.Rational(3, 2),
    stored=sp.Rational(2, 5) * K_hertz * d ** sp.Rational(5, 2),
    exponent=sp.Rational(3, 2),
    reach=R_min,
    forms=("point",),
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
    forms=FORMS,
    source="Hertz's law with the exponent left open; K carries the unit N/m^n",
    grade="A",
)

_RADIUS = (d / (C * kappa)) ** (1 / k)  # of the contact circle

galin_sneddon = StiffnessLaw(
    name="galin_sneddon",
    title="Galin and Sneddon, point contact of a rigid axisymmetric profile z = C r^k",
    parameters=(*MATERIALS, k, C),
    definitions=(EFFECTIVE_MODULUS, (kappa, sp.sqrt(sp.pi) * sp.gamma(1 + k / 2) / sp.gamma((1 + k) / 2))),
    force=2 * E_eff * k / (k + 1) * d * _RADIUS,
    stored=2 * E_eff * k**2 / ((k + 1) * (2 * k + 1)) * d**2 * _RADIUS,
    exponent=1 + 1 / k,
    forms=("point",),
    source="Sneddon, Int. J. Eng. Sci. 3 (1965) 47",
    grade="A",
    note="A legitimate n other than 3/2: n = 1 + 1/k, the stiffness following from the profile. k = 2, C = 1/(2 R) is Hertz's law.",
)
