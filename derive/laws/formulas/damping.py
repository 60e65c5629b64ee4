"""Damping laws: the dissipative part of the normal force beside an elastic force F(d).

Hysteresis laws, m = n: F h v/v0 with h a function of the coefficient of restitution e. All obey, whatever F, the masses and v0,

    h (1 + e_out) = ln((1 + h)/(1 - h e_out)),  the same as  coth t - 1/t = (1 - e_out)/(1 + e_out),  t = h (1 + e_out)/2,

so that the factor which returns e is h = 2 t/(1 + e) with t the inverse Langevin function of (1 - e)/(1 + e): the law `exact`.
The other laws were published for one stiffness law; with the secant F/d or the tangent k_t = dF/dd they go with every one.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Interval
from hertzwerk.derive.laws.law import APPROACH_SPEED, DampingLaw, F, Quantity, d, k_t, m_eff, v

e = Quantity("e", "1", "coefficient of restitution")

_WHOLE = Interval(0, 1, open_left=True)
_CLOSED = Interval(0, 1)
_HIGH = Interval(0.8, 1, open_left=True)

# -- m = n -------------------------------------------------------------------------------------------------------------


def hysteresis(factor: sp.Expr, at_zero: sp.Expr, *, at_one: sp.Expr = sp.S.Zero, **fields: Any) -> DampingLaw:
    """Build the law F h v/v0 with h = `factor`; an infinite h at e = 0 opens that end of its range."""
    fields.setdefault("defined", _WHOLE if at_zero is sp.oo else _CLOSED)
    fields.setdefault("recommended", _WHOLE)
    return DampingLaw(
        parameters=(e,), factor=factor, memory=(APPROACH_SPEED,), at_one=at_one, at_zero=at_zero, **fields
    )


hunt_crossley = hysteresis(
    3 * (1 - e) / 2,
    sp.Rational(3, 2),
    name="hunt_crossley",
    title="Hunt and Crossley",
    recommended=Interval(0.8, 1),
    source="Hunt, Crossley, J. Appl. Mech. 42 (1975) 440",
    grade="A",
    note="Never returns less than e = 0.4877. Often quoted with the 1/e of hu_guo.",
)

herbert_mcwhannell = hysteresis(
    6 * (1 - e) / ((2 * e - 1) ** 2 + 3),
    sp.Rational(3, 2),
    name="herbert_mcwhannell",
    title="Herbert and McWhannell",
    recommended=_HIGH,
    source="Herbert, McWhannell, J. Eng. Ind. 99 (1977) 513",
    grade="B",
)

lee_wang = hysteresis(
    3 * (1 - e) / 4,
    sp.Rational(3, 4),
    name="lee_wang",
    title="Lee and Wang",
    recommended=_HIGH,
    source="Lee, Wang, J. Mech. Transm. Autom. Des. 105 (1983) 534",
    grade="B",
)

lankarani_nikravesh = hysteresis(
    3 * (1 - e**2) / 4,
    sp.Rational(3, 4),
    name="lankarani_nikravesh",
    title="Lankarani and Nikravesh",
    recommended=_HIGH,
    source="Lankarani, Nikravesh, J. Mech. Des. 112 (1990) 369",
    grade="A",
    note="For v0 up to 1e-5 sqrt(E/rho). Never returns less than e = 0.6630.",
)

gonthier = hysteresis(
    (1 - e**2) / e,
    sp.oo,
    name="gonthier",
    title="Gonthier, McPhee, Lange and Piedboeuf",
    source="Gonthier, McPhee, Lange, Piedboeuf, Multibody Syst. Dyn. 11 (2004) 209",
    grade="B",
)

zhiying_qishao = hysteresis(
    3 * (1 - e**2) * sp.exp(2 * (1 - e)) / 4,
    3 * sp.exp(2) / 4,
    name="zhiying_qishao",
    title="Qin Zhiying and Lu Qishao",
    recommended=Interval(0.33, 1, open_left=True),
    source="Qin, Lu, J. Dyn. Control 4 (2006) 294",
    grade="A",
)

flores = hysteresis(
    8 * (1 - e) / (5 * e),
    sp.oo,
    name="flores",
    title="Flores, Machado, Silva and Martins",
    source="Flores, Machado, Silva, Martins, Multibody Syst. Dyn. 25 (2011) 357, eq. 18; Ye, Li, Zheng, Earthq. Eng. Struct. Dyn. 38 (2009) 1135",
    grade="A",
)

gharib_hurmuzlu = hysteresis(
    1 / e,
    sp.oo,
    at_one=sp.S.One,
    name="gharib_hurmuzlu",
    title="Gharib and Hurmuzlu",
    recommended=Interval(0, 0.2, open_left=True),
    source="Gharib, Hurmuzlu, J. Appl. Mech. 79 (2012) 064506",
    grade="A",
    note="For small e (the bound 0.2 is where it is 2 % from the exact factor). e = 1 does not give the elastic law.",
)

hu_guo = hysteresis(
    3 * (1 - e) / (2 * e),
    sp.oo,
    name="hu_guo",
    title="Hu and Guo",
    source="Hu, Guo, Multibody Syst. Dyn. 35 (2015) 131",
    grade="A",
    note="Often quoted with half the factor.",
)

carvalho_martins = hysteresis(
    3 * (1 - e) * (11 - e) / (2 * (1 + 9 * e)),
    sp.Rational(33, 2),
    name="carvalho_martins",
    title="Carvalho and Martins",
    source="Carvalho, Martins, Mech. Mach. Theory 139 (2019) 174",
    grade="A",
    note="At e = 0 the factor is 33/2: large, not infinite.",
)

safaeifar_farshidianfar = hysteresis(
    5 * (1 - e) / (4 * e),
    sp.oo,
    name="safaeifar_farshidianfar",
    title="Safaeifar and Farshidianfar",
    source="Safaeifar, Farshidianfar, Multibody Syst. Dyn. 50 (2020) 233",
    grade="C",
)

# -- another power of the penetration ----------------------------------------------------------------------------------

A = Quantity("A", "s", "material time of the viscous stress", NOT_NEGATIVE)
chi = Quantity("chi", "N s/m^(m+1)", "coefficient of the damping", POSITIVE)
m = Quantity("m", "1", "exponent of the penetration", Interval(lower=0, upper=10))
gamma = Quantity("gamma", "1/s", "damping rate", NOT_NEGATIVE)
xi = Quantity("xi", "1", "damping ratio")
_SECANT = F / d
_LOG_RATIO = -sp.log(e) / sp.sqrt(sp.pi**2 + sp.log(e) ** 2)

kelvin_voigt = DampingLaw(
    name="kelvin_voigt",
    title="Kelvin and Voigt, in the form of Anagnostopoulos",
    parameters=(e,),
    definitions=((xi, _LOG_RATIO),),
    term=2 * xi * sp.sqrt(_SECANT * m_eff) * v,
    exponent=sp.S.Zero,
    defined=_WHOLE,
    recommended=_WHOLE,
    release="gap",
    at_one=sp.S.Zero,
    at_zero=sp.S.One,
    source="Anagnostopoulos, Earthq. Eng. Struct. Dyn. 16 (1988) 443",
    grade="A",
    note="Published for K d, where the secant F/d is K: exact e when the contact ends at d = 0. Jumps at the onset, pulls before release.",
)

power_damping = DampingLaw(
    name="power_damping",
    title="Power damping, coefficient and exponent given: beside K d^n the general law K d^n + chi d^m v",
    parameters=(chi, m),
    term=chi * d**m * v,
    exponent=m,
    source="Wang, Liu, Mech. Mach. Theory 153 (2020) 103986, section 2: the form that the laws of its survey share",
    grade="A",
    note="chi carries the unit N s/m^(m+1). With m = n and chi = h K/v0 a hysteresis law of one approach speed; m = 0 jumps at the onset.",
)

ristow = DampingLaw(
    name="ristow",
    title="Ristow; Lee and Herrmann",
    parameters=(gamma,),
    term=gamma * m_eff * v,
    exponent=sp.S.Zero,
    source="Ristow, J. Phys. I France 2 (1992) 649; Lee, Herrmann, J. Phys. A 26 (1993) 373",
    grade="B",
    note="Published beside K d^1.5. The force jumps at the onset; the contact ends where it would pull.",
)

tsuji = DampingLaw(
    name="tsuji",
    title="Tsuji, Tanaka and Ishida",
    parameters=(e,),
    definitions=((xi, sp.sqrt(5) * _LOG_RATIO),),
    term=xi * sp.sqrt(m_eff * _SECANT) * v,
    exponent=sp.Rational(1, 4),
    defined=_WHOLE,
    recommended=_WHOLE,
    release="gap",
    at_one=sp.S.Zero,
    at_zero=sp.sqrt(5),
    source="Tsuji, Tanaka, Ishida, Powder Technol. 71 (1992) 239",
    grade="A",
    note="Published for K d^1.5, where sqrt(F/d) is sqrt(K) d^(1/4): exact e when the contact ends at d = 0. Pulls before release.",
)

kuwabara_kono = DampingLaw(
    name="kuwabara_kono",
    title="Kuwabara and Kono",
    parameters=(A,),
    term=A * k_t * v,
    exponent=sp.Rational(1, 2),
    source="Kuwabara, Kono, Jpn. J. Appl. Phys. 26 (1987) 1230",
    grade="A",
    note="Published for K d^1.5, where A k_t v is (3/2) A K d^(1/2) v: e = 1 - 1.15345 (3/2) A (K/m_eff)^(2/5) v0^(1/5) + ...",
)

jankowski = DampingLaw(
    name="jankowski",
    title="Jankowski, damped while approaching only",
    parameters=(e,),
    definitions=((xi, 9 * sp.sqrt(5) / 2 * (1 - e**2) / (e * (e * (9 * sp.pi - 16) + 16))),),
    term=Where(v > 0, 2 * xi * sp.sqrt(m_eff * _SECANT) * v, 0),
    exponent=sp.Rational(1, 4),
    defined=_WHOLE,
    recommended=_WHOLE,
    at_one=sp.S.Zero,
    at_zero=sp.oo,
    source="Jankowski, Earthq. Eng. Struct. Dyn. 34 (2005) 595; 35 (2006) 517",
    grade="A",
    note="Published for K d^1.5, where sqrt(F/d) is sqrt(K) d^(1/4).",
)
