"""What is known of every law of the catalogue from elsewhere, as checks of a record: published digits, exact relations, quadratures, other laws in a
limit, and closed forms typed again from the literature.

`test_evidence.py` holds every law to its own; `mutate_laws.py` changes each constant by 1 % and asks that one of them notices. A grade follows: A
needs a check that is more than a formula typed twice.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from bench import evaluate, numbers
from known import DIGITS, EXACT, LIMIT, QUADRATURE, TYPED, Evidence, same
from known_damping import (
    bounds_are,
    damping_exponent,
    exact_chain,
    exact_root,
    factor_is,
    free_power,
    jankowski_out,
    kuwabara_loss,
    least,
    limits_are,
    nearly_elastic,
    nearly_plastic,
    oscillator,
    resists,
    work_balance,
)
from known_friction import (
    brenner_typed,
    brown_published,
    coulomb_cone,
    creep,
    curve,
    drags,
    full_film,
    lugre_bristle,
    paraboloid,
    reynolds,
    slope_at_rest,
    sphere_before_plane,
    threlfall_published,
)
from known_plastic import JACKSON_GREEN, KOGUT_ETSION, THORNTON
from known_stiffness import (
    PAIRS,
    SEAM,
    SMALLER,
    THIN,
    WHOLE_WIDTH,
    both_halves,
    chord,
    compression_agrees,
    digits,
    ellipse,
    exponent_is,
    force_is,
    general_power,
    half_space_agrees,
    hertz_by_quadrature,
    hertz_width,
    in_millimetres,
    johnson_published,
    liu_formula,
    log_law,
    named_units,
    near_johnson,
    other_units,
    palmgren_mm,
    parabola,
    pereira_exponent,
    pereira_mm,
    persson_formula,
    persson_is_hertz,
    persson_onset,
    popov,
    radzimovsky_roark,
    reach_is,
    roark_width,
    sneddon_by_quadrature,
    stored_is_the_integral,
    strip_closed,
    tangent_of_liu,
)
from mpmath import mp, mpf

from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import StiffnessLaw, d
from reference.closed_forms import FACTORS

# -- the table ---------------------------------------------------------------------------------------------------------


def goldsmith_quoted(b: Any, q: Any) -> Any:
    """F s/L (ln(L/(F R s)) + 1), s of both bodies: the numbers of SI, for the logarithm is of 1/m^2."""
    s = 2 / (mp.pi * b.plane_strain)
    return q * s / b.L * (1 + mp.log(b.L / (q * b.R * s)))


LOG = {
    "johnson": ("both bodies to their centres", lambda b, q: both_halves(b, q, -1), {}),
    "hertz_cylinder": (
        "as quoted by Pereira et al.",
        lambda b, q: 2 * q / (mp.pi * b.star * b.L) * (2 * mp.log(2 * mp.sqrt(b.R * b.dR) / b.half_width(q)) - 1), {},
    ),
    "radzimovsky": ("Roark's table", radzimovsky_roark, WHOLE_WIDTH),
    "goldsmith": ("as quoted", goldsmith_quoted, {}),
    "goldsmith_m3": ("long strip", strip_closed, {}),
    "dubowsky_freudenstein": ("long strip", strip_closed, {}),
    "esdu_78035": ("Johnson's with + 1 for - 1", lambda b, q: both_halves(b, q, 1), {}),
    "wang_liu_johnson": ("both bodies to their centres", lambda b, q: both_halves(b, q, -1), {}),
}  # fmt: skip


def _log(name: str) -> tuple[Evidence, ...]:
    what, relation, options = LOG[name]
    return tuple(log_law(relation, TYPED, what, **options))


def _hysteresis(
    name: str, at_one: Any, at_zero: Any, defined: str, recommended: str, *more: Evidence
) -> tuple[Evidence, ...]:
    formula = FACTORS.get(name)
    typed = (factor_is(formula),) if formula is not None else ()
    return (*typed, limits_are(at_one, at_zero), bounds_are(defined, recommended), *more)


R = sp.Rational
ELASTIC = Evidence(LIMIT, "the exact relation as e goes to 1", nearly_elastic)
PLASTIC = Evidence(LIMIT, "the exact relation as e goes to 0", nearly_plastic)
HALF_SPACE = Evidence(QUADRATURE, "Hertz's strip on a half-space", half_space_agrees)
COMPRESSION = Evidence(QUADRATURE, "strains of cylinders pressed across", compression_agrees(ellipse))
PUBLISHED = Evidence(DIGITS, "forces of aluminium, 10 digits", johnson_published)
UNITS = Evidence(EXACT, "the reference quantities are the units of the fit", named_units, of_the_force=False)
SLOPE = Evidence(EXACT, "the slope at rest is the derivative", slope_at_rest, of_the_force=False)
OSCILLATOR_1 = Evidence(EXACT, "the linear oscillator returns e", oscillator(mpf(1)))
OSCILLATOR = Evidence(EXACT, "linear in d^(5/4): returns e", oscillator(mpf("1.5")))


def fitted_clearance() -> Evidence:
    def check(law: Any) -> None:
        (row,) = law.ranges
        assert (row.quantity.name, row.kind, row.interval.lower, row.interval.upper) == ("dR", "defined", 5e-6, 1e-2)

    return Evidence(TYPED, "fitted for clearances of 0.005 to 10 mm", check, of_the_force=False)


def exponents_of_cylinders() -> Evidence:
    def check(law: Any) -> None:
        (row,) = law.ranges
        assert (row.quantity.name, row.kind, row.interval.lower, row.interval.upper) == ("n", "recommended", 1, 1.5)
        same(evaluate(law.exponent, numbers(law, n="1.2")), mpf("1.2"))

    return Evidence(TYPED, "n of 1 to 1.5", check, of_the_force=False)


def local_exponent(**given: Any) -> Evidence:
    """d ln F/d ln d is the stated exponent."""

    def check(law: Any) -> None:
        values = numbers(law, **given)
        one, two = (evaluate(law.force, values | {d: mpf(x)}) for x in ("1e-6", "1e-5"))
        same(evaluate(law.exponent, values), mp.log(two / one) / mp.log(10))

    return Evidence(EXACT, "the exponent is the local one", check, of_the_force=False)


EVIDENCE: dict[str, tuple[Evidence, ...]] = {
    "hertz_point": (
        digits("hertz_point"), force_is(QUADRATURE, "Hertz's pressure on a half-space", hertz_by_quadrature), SMALLER, local_exponent(),
    ),
    "power": (Evidence(EXACT, "2.4e9 N/m^n at 1 um", general_power),),
    "galin_sneddon": (
        *(force_is(QUADRATURE, f"Sneddon's integrals, k = {k}", sneddon_by_quadrature(mpf(k), mpf(c)), k=k, C=c)
          for k, c in (("2", "3"), ("4", "500"))),
        force_is(EXACT, "a cone, 2 E* d^2/(pi tan)", lambda b, x: 2 * b.star * x**2 / (mp.pi * mpf("0.3")), k="1", C="0.3"),
        local_exponent(k="4", C="500"),
    ),
    "thornton": (*THORNTON, SMALLER),
    "kogut_etsion": KOGUT_ETSION,
    "jackson_green": JACKSON_GREEN,
    "palmgren": (in_millimetres(palmgren_mm, lambda b: mpf(10) / 9, PAIRS), SMALLER),
    "palmgren_si": (force_is(TYPED, "as printed", palmgren_mm), Evidence(TYPED, "in other units", other_units), SMALLER, UNITS, local_exponent(),
                    near_johnson("side by side")),
    "pereira_internal": (in_millimetres(pereira_mm(True), pereira_exponent, (*PAIRS, THIN, *SEAM)), SMALLER, fitted_clearance()),
    "pereira_internal_si": (
        digits("pereira_internal_si"), force_is(TYPED, "as printed", pereira_mm(True), pairs=(*PAIRS, THIN, *SEAM)),
        SMALLER, fitted_clearance(), UNITS, local_exponent(), near_johnson("inside"),
    ),
    "pereira_external": (in_millimetres(pereira_mm(False), lambda b: mpf("1.094"), PAIRS), SMALLER),
    "pereira_external_si": (force_is(TYPED, "as printed", pereira_mm(False)), SMALLER, UNITS, local_exponent(), near_johnson("side by side")),
    "lankarani_nikravesh_cylinders": (
        force_is(LIMIT, "Hertz at n = 3/2", hertz_by_quadrature, n="1.5"), exponents_of_cylinders(), local_exponent(n="1.1"),
    ),
    "liu": (digits("liu_with_length", "0.015"), force_is(TYPED, "per length", lambda b, x: liu_formula(b, x) / b.L), SMALLER),
    "liu_with_length": (digits("liu_with_length"), force_is(TYPED, "as printed, with L", liu_formula), SMALLER),
    "bai_zhao": (force_is(EXACT, "derivative of Liu's force, times d^1.5", lambda b, x: tangent_of_liu(b, x) * x ** mpf("1.5"), mpf("1e-10")),
                 SMALLER, exponent_is("1.5")),
    "bai_zhao_repaired": (
        force_is(EXACT, "derivative of Liu's force, times L d", lambda b, x: tangent_of_liu(b, x) * b.L * x, mpf("1e-10")), SMALLER,
    ),
    "persson": (
        force_is(TYPED, "as Ciavarella and Decuzzi print it", persson_formula), Evidence(LIMIT, "Hertz's half-width", persson_is_hertz),
        reach_is(lambda b: 8 * b.dR, "8 clearances"),
    ),
    "popov_line": (digits("popov_line"), force_is(TYPED, "quarter of pi E*", popov), SMALLER, local_exponent()),
    "hertz_half_width": (force_is(EXACT, "Hertz's half-width is the chord", chord), SMALLER, local_exponent()),
    "johnson": (digits("johnson"), PUBLISHED, COMPRESSION, *_log("johnson")),
    "hertz_cylinder": _log("hertz_cylinder"),
    "radzimovsky": (
        *_log("radzimovsky"), Evidence(QUADRATURE, "strains under a parabola of pressure over Hertz's width", compression_agrees(parabola)),
        Evidence(EXACT, "b is Hertz's whole width", hertz_width, of_the_force=False),
        Evidence(DIGITS, "Roark's width, of diameters", roark_width, of_the_force=False),
    ),
    "goldsmith": _log("goldsmith"),
    "goldsmith_m3": (digits("goldsmith_m3"), HALF_SPACE, *_log("goldsmith_m3")),
    "dubowsky_freudenstein": (digits("dubowsky_freudenstein"), HALF_SPACE, *_log("dubowsky_freudenstein")),
    "esdu_78035": (digits("esdu_78035"), *_log("esdu_78035")),
    "wang_liu_external": (digits("wang_liu_external"), force_is(TYPED, "quarter of pi E*", popov), SMALLER, local_exponent()),
    "wang_liu_internal": (
        force_is(EXACT, "Hertz's half-width is the chord", chord), Evidence(LIMIT, "the slope of Persson's law at the onset", persson_onset),
        SMALLER, local_exponent(),
    ),
    "wang_liu_half_width": (force_is(EXACT, "Hertz's half-width is the chord", chord), SMALLER, local_exponent()),
    "wang_liu_secant": (digits("wang_liu_secant"), force_is(TYPED, "the secant of Liu's law, with L", liu_formula), SMALLER, exponent_is("1")),
    "wang_liu_johnson": (digits("wang_liu_johnson"), COMPRESSION, *_log("wang_liu_johnson"), exponent_is("1")),
    "hunt_crossley": _hysteresis("hunt_crossley", 0, R(3, 2), "[0, 1]", "[0.8, 1]", ELASTIC, least("0.4877")),
    "herbert_mcwhannell": _hysteresis("herbert_mcwhannell", 0, R(3, 2), "[0, 1]", "(0.8, 1]", ELASTIC),
    "lee_wang": _hysteresis("lee_wang", 0, R(3, 4), "[0, 1]", "(0.8, 1]"),
    "lankarani_nikravesh": _hysteresis("lankarani_nikravesh", 0, R(3, 4), "[0, 1]", "(0.8, 1]", ELASTIC, least("0.6630")),
    "gonthier": _hysteresis("gonthier", 0, sp.oo, "(0, 1]", "(0, 1]", PLASTIC),
    "zhiying_qishao": _hysteresis("zhiying_qishao", 0, 3 * sp.exp(2) / 4, "[0, 1]", "(0.33, 1]", ELASTIC),
    "flores": _hysteresis("flores", 0, sp.oo, "(0, 1]", "(0, 1]", Evidence(EXACT, "its own balance of work", work_balance("flores"))),
    "gharib_hurmuzlu": _hysteresis("gharib_hurmuzlu", 1, sp.oo, "(0, 1]", "(0, 0.2]", PLASTIC),
    "hu_guo": _hysteresis("hu_guo", 0, sp.oo, "(0, 1]", "(0, 1]", ELASTIC, Evidence(EXACT, "its own balance of work", work_balance("hu_guo"))),
    "carvalho_martins": _hysteresis("carvalho_martins", 0, R(33, 2), "[0, 1]", "(0, 1]", ELASTIC),
    "safaeifar_farshidianfar": (
        factor_is(lambda e: 5 * (1 - e) / (4 * e)), *_hysteresis("safaeifar_farshidianfar", 0, sp.oo, "(0, 1]", "(0, 1]"),
    ),
    "exact": _hysteresis("exact", 0, sp.oo, "(0, 1]", "(0, 1]", Evidence(EXACT, "each step of the chain", exact_chain),
                         Evidence(EXACT, "root of the exact relation", exact_root)),
    "kelvin_voigt": (OSCILLATOR_1, limits_are(0, 1), bounds_are("(0, 1]", "(0, 1]"), damping_exponent("0")),
    "ristow": (resists(lambda K, x, speed, mass: 10_000 * mass * speed), damping_exponent("0")),
    "power_damping": (Evidence(EXACT, "hysteresis with m = n, and one form for all m", free_power),),
    "tsuji": (OSCILLATOR, limits_are(0, sp.sqrt(5)), bounds_are("(0, 1]", "(0, 1]"), damping_exponent("0.25")),
    "kuwabara_kono": (Evidence(DIGITS, "1 - e to first order, 1.15345", kuwabara_loss), damping_exponent("0.5")),
    "jankowski": (Evidence(DIGITS, "restitution returned", jankowski_out), limits_are(0, sp.oo), bounds_are("(0, 1]", "(0, 1]"),
                  damping_exponent("0.25"),
                  resists(lambda K, x, speed, mass: 9 * mp.sqrt(5) * mpf("0.51") / (mpf("0.7") * (mpf("0.7") * (9 * mp.pi - 16) + 16))
                          * mp.sqrt(mass * K) * x ** mpf("0.25") * max(speed, 0))),
    "coulomb": (Evidence(EXACT, "the cone", coulomb_cone),),
    "smooth_coulomb": (Evidence(EXACT, "creep on an incline", creep), SLOPE, drags(lambda x, n, p: p["mu"] * n * mp.tanh(x / p["v_s"]))),
    "ambrosio": (drags(lambda x, n, p: p["mu"] * n * min(max((x - p["v_a"]) / (p["v_b"] - p["v_a"]), 0), 1), lambda n, p: mpf(0)),),
    "threlfall": (Evidence(DIGITS, "0.95 beyond the transition", threlfall_published), SLOPE,
                  drags(lambda x, n, p: p["mu"] * n * (1 - mp.exp(-3 * min(x, p["v_r"]) / p["v_r"])))),
    "stribeck": (drags(lambda x, n, p: n * curve(x, p) * mp.tanh(x / p["v_s"]) + p["c_v"] * x), SLOPE),
    "brown_mcphee": (
        Evidence(EXACT, "the top of its curve", brown_published), SLOPE,
        drags(lambda x, n, p: n * (p["mu_k"] * mp.tanh(4 * x / p["v_S"]) + (p["mu_s"] - p["mu_k"]) * (x / p["v_S"])
                                   / (mpf("0.25") * (x / p["v_S"]) ** 2 + mpf("0.75")) ** 2) + p["c_v"] * x * mp.tanh(4 * n / p["N_t"])),
    ),
    "bengisu_akay": (
        SLOPE,
        drags(lambda x, n, p: n * (p["mu_s"] - p["mu_s"] / p["v_S"] ** 2 * (x - p["v_S"]) ** 2 if x < p["v_S"]
                                   else p["mu_k"] + (p["mu_s"] - p["mu_k"]) * mp.exp(-p["xi"] * (x - p["v_S"])))),
    ),
    "lugre": (Evidence(EXACT, "steady sliding on its Stribeck curve", lugre_bristle),),
    "short_bearing": (Evidence(QUADRATURE, "Reynolds' equation", reynolds),),
    "long_bearing": (Evidence(QUADRATURE, "Reynolds' equation", reynolds),),
    "short_bearing_full": (Evidence(QUADRATURE, "both halves by Reynolds' equation", full_film),),
    "long_bearing_full": (Evidence(QUADRATURE, "both halves by Reynolds' equation", full_film),),
    "sphere_film": (Evidence(QUADRATURE, "Reynolds' equation of a paraboloid", paraboloid),),
    "brenner": (Evidence(EXACT, "Brenner's series, and both its limits", sphere_before_plane), Evidence(TYPED, "typed again", brenner_typed)),
}  # fmt: skip
EVIDENCE |= {
    name: (*checks, stored_is_the_integral()) if isinstance(LAWS[name], StiffnessLaw) else checks
    for name, checks in EVIDENCE.items()
}
