"""Friction laws: force opposing the sliding velocity s, at the normal force N. All are odd in s."""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE
from hertzwerk.derive.laws.law import FrictionLaw, N, Quantity, s, z

mu = Quantity("mu", "1", "coefficient of friction", NOT_NEGATIVE)
mu_k = Quantity("mu_k", "1", "coefficient of kinetic friction", NOT_NEGATIVE)
mu_s = Quantity("mu_s", "1", "coefficient of static friction", NOT_NEGATIVE)
v_s = Quantity("v_s", "m/s", "speed over which the friction force builds up", POSITIVE)
v_S = Quantity("v_S", "m/s", "Stribeck speed", POSITIVE)
v_a = Quantity("v_a", "m/s", "speed up to which there is no friction", POSITIVE)
v_b = Quantity("v_b", "m/s", "speed from which there is all of it", POSITIVE)
v_r = Quantity("v_r", "m/s", "speed over which the friction force builds up", POSITIVE)
c_v = Quantity("c_v", "N s/m", "viscous coefficient", NOT_NEGATIVE)
N_t = Quantity("N_t", "N", "normal force over which viscous friction builds up", POSITIVE)
xi = Quantity("xi", "s/m", "decay of static friction with speed", NOT_NEGATIVE)
s_0 = Quantity("s_0", "1/m", "bristle stiffness per normal force", POSITIVE)
s_1 = Quantity("s_1", "s/m", "bristle damping per normal force", NOT_NEGATIVE)

_speed = sp.Abs(s)
_stribeck = mu_k + (mu_s - mu_k) * sp.exp(-((s / v_S) ** 2))

coulomb = FrictionLaw(
    name="coulomb",
    title="Coulomb friction, set-valued",
    parameters=(mu_k, mu_s),
    force=mu_k * N * sp.sign(s),
    holding=mu_s * N,
    modes=("slip", "stick"),
    source="Coulomb 1785",
    grade="A",
    note="At rest any force up to mu_s N, so that s = 0 holds: stick and slip are modes, and their changes events.",
)

smooth_coulomb = FrictionLaw(
    name="smooth_coulomb",
    title="Coulomb friction, smoothed by tanh; creeps at v_s atanh(tan(theta)/mu) on an incline",
    parameters=(mu, v_s),
    force=mu * N * sp.tanh(s / v_s),
    slope=mu * N / v_s,
    source="Andersson, Soderberg, Bjorklund, Tribology Int. 40 (2007) 580",
    grade="A",
)

ambrosio = FrictionLaw(
    name="ambrosio",
    title="Ambrosio, Coulomb friction with a dead zone and a ramp",
    parameters=(mu, v_a, v_b),
    force=mu * N * sp.sign(s) * Where(_speed <= v_a, 0, Where(_speed < v_b, (_speed - v_a) / (v_b - v_a), 1)),
    source="Ambrosio, Impact of rigid and flexible multibody systems, in: Virtual Nonlinear Multibody Systems (2003)",
    grade="B",
    note="Kinks at v_a and v_b; without friction below v_a, so nothing stays at rest.",
)

threlfall = FrictionLaw(
    name="threlfall",
    title="Threlfall, exponential rise up to a transition speed",
    parameters=(mu, v_r),
    force=mu * N * sp.sign(s) * (1 - sp.exp(-3 * sp.Min(_speed, v_r) / v_r)),
    slope=3 * mu * N / v_r,
    source="Threlfall, Mech. Mach. Theory 13 (1978) 475",
    grade="B",
    note="Beyond v_r the published 0.95 is taken as 1 - exp(-3) = 0.9502, which leaves a kink and no jump.",
)

stribeck = FrictionLaw(
    name="stribeck",
    title="Stribeck curve with viscous friction, smoothed by tanh",
    parameters=(mu_k, mu_s, v_S, v_s, c_v),
    force=N * _stribeck * sp.tanh(s / v_s) + c_v * s,
    slope=N * mu_s / v_s + c_v,
    source="Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30 (1994) 1083",
    grade="B",
)

brown_mcphee = FrictionLaw(
    name="brown_mcphee",
    title="Brown and McPhee, Stribeck friction in one smooth expression",
    parameters=(mu_k, mu_s, v_S, c_v, N_t),
    force=N * (mu_k * sp.tanh(4 * s / v_S) + (mu_s - mu_k) * (s / v_S) / ((s / v_S) ** 2 / 4 + sp.Rational(3, 4)) ** 2)
    + c_v * s * sp.tanh(4 * N / N_t),
    slope=N * (4 * mu_k + sp.Rational(16, 9) * (mu_s - mu_k)) / v_S + c_v * sp.tanh(4 * N / N_t),
    source="Brown, McPhee, J. Comput. Nonlinear Dyn. 11 (2016) 054502",
    grade="B",
)

bengisu_akay = FrictionLaw(
    name="bengisu_akay",
    title="Bengisu and Akay, parabolic rise and exponential fall",
    parameters=(mu_k, mu_s, v_S, xi),
    force=N
    * sp.sign(s)
    * Where(
        _speed < v_S,
        mu_s * (2 - _speed / v_S) * _speed / v_S,  # = mu_s - mu_s (|s| - v_S)^2/v_S^2, without cancellation at rest
        mu_k + (mu_s - mu_k) * sp.exp(-xi * (_speed - v_S)),
    ),
    slope=2 * mu_s * N / v_S,
    source="Bengisu, Akay, J. Sound Vib. 171 (1994) 557",
    grade="C",
)

lugre = FrictionLaw(
    name="lugre",
    title="LuGre bristle friction for varying load",
    parameters=(mu_k, mu_s, v_S, s_0, s_1, c_v),
    force=N * (s_0 * z + s_1 * (s - s_0 * _speed * z / _stribeck)) + c_v * s,
    slope=N * s_1 + c_v,  # of an undeflected bristle
    memory=((z, s - s_0 * _speed * z / _stribeck, mu_s / s_0),),
    source="Canudas de Wit, Olsson, Astrom, Lischinsky, IEEE Trans. Autom. Control 40 (1995) 419, the load as a factor",
    grade="B",
    note="The bristle z is forgotten when the contact ends. The form with constant friction forces is wrong under impact and not offered.",
)
