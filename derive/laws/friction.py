"""Friction laws: force opposing the sliding velocity, from the normal force."""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.laws.law import FrictionLaw, N, Quantity, s
from hertzwerk.derive.parameter import NOT_NEGATIVE, POSITIVE

mu = Quantity("mu", "1", "coefficient of friction", NOT_NEGATIVE)
v_s = Quantity("v_s", "m/s", "speed over which the friction force builds up", POSITIVE)

smooth_coulomb = FrictionLaw(
    name="smooth_coulomb",
    title="Coulomb friction, smoothed by tanh; creeps at v_s atanh(tan(theta)/mu) on an incline",
    parameters=(mu, v_s),
    force=mu * N * sp.tanh(s / v_s),
    slope=mu * N / v_s,
    source="Andersson, Soderberg, Bjorklund, Tribology Int. 40 (2007) 580",
    grade="A",
)
