"""Of damping laws: the exact relation of h and e, work balances, linear oscillators; factors typed again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp
from bench import evaluate, numbers
from known import DIGITS, EXACT, LIMIT, TYPED, Evidence, same
from mpmath import mp, mpf

from hertzwerk.derive.laws.law import F, d, k_t, m_eff, v, v0
from reference import laws as cited
from reference.closed_forms import FACTORS, exact_factor, restitution

# -- damping -----------------------------------------------------------------------------------------------------------


def factor_of(law: Any, e: Any) -> Any:
    return evaluate(law.factor, numbers(law, e=e))


def factor_is(formula: Callable[[Any], Any]) -> Evidence:
    def check(law: Any) -> None:
        for e in ("0.05", "0.3", "0.6", "0.93"):
            same(factor_of(law, e), formula(mpf(e)))

    return Evidence(TYPED, "the factor h(e) as published", check)


def nearly_elastic(law: Any) -> None:
    """h -> (3/2)(1 - e): the exact relation to first order."""
    e = 1 - mpf("1e-14")
    same(factor_of(law, e), mpf(exact_factor(str(e))), mpf("1e-11"))


def nearly_plastic(law: Any) -> None:
    """h e -> 1: the exact relation as e goes to 0."""
    same(factor_of(law, "1e-14") * mpf("1e-14"), mpf(1), mpf("1e-12"))


def work_balance(law_name: str) -> Callable[[Any], None]:
    """The factor as it was found: of K d^1.5, 2/5 K dm^2.5 is stored and share chi v dm^2.5 lost, going in at v = v0 and out at e v0."""

    def check(law: Any) -> None:
        for e in ("0.2", "0.7"):
            x, stored = mpf(e), mpf(2) / 5
            share = mpf(LOSS[law_name][0]) / LOSS[law_name][1]

            def missing(h: Any, x: Any = x, stored: Any = stored, share: Any = share) -> Any:
                inward = stored + share * h  # m v0^2/2
                return stored - share * h * x - x**2 * inward

            same(factor_of(law, e), mp.findroot(missing, 1), mpf("1e-12"))

    return check


LOSS = {
    "flores": (1, 4),
    "hu_guo": (4, 15),
}  # int x^1.5 sqrt(1 - x^2) dx = 0.24968, printed as 1/4; of sqrt(1 - x^2.5) it is 4/15


def limits_are(at_one: Any, at_zero: Any) -> Evidence:
    """Of the coefficient."""

    def check(law: Any) -> None:
        for stated, known in ((law.at_one, at_one), (law.at_zero, at_zero)):
            assert stated == known

    return Evidence(TYPED, "limits as e goes to 1 and to 0", check, of_the_force=False)


def bounds_are(defined: str, recommended: str) -> Evidence:
    def check(law: Any) -> None:
        assert (str(law.defined), str(law.recommended)) == (defined, recommended)

    return Evidence(TYPED, "ranges of e", check, of_the_force=False)


def least(printed: str) -> Evidence:
    def check(law: Any) -> None:
        assert f"{restitution(str(factor_of(law, '1e-30'))):.4f}" == printed

    return Evidence(DIGITS, "least restitution there is", check)


def resists(
    formula: Callable[..., Any], kind: str = TYPED, what: str = "the force as published", **given: Any
) -> Evidence:
    """The resistance beside K d^1.5 (or another) is a formula of K, d, v, m."""
    n, K = mpf(given.pop("n", "1.5")), mpf("2.4e9")

    def check(law: Any) -> None:
        for depth, rate in (("1e-6", "0.3"), ("4e-5", "0.7"), ("4e-5", "-0.2")):
            x, speed = mpf(depth), mpf(rate)
            state = {F: K * x**n, k_t: n * K * x ** (n - 1), d: x, v: speed, v0: mpf(1), m_eff: mpf("0.2")}
            found = evaluate(law.resistance, numbers(law, **given) | state)
            same(found, formula(K, x, speed, mpf("0.2")))

    return Evidence(kind, what, check)


def damping_exponent(stated: str) -> Evidence:
    def check(law: Any) -> None:
        assert law.exponent == sp.Rational(stated)

    return Evidence(TYPED, f"m = {stated}", check, of_the_force=False)


def oscillator(n: Any, approaching_only: bool = False) -> Callable[[Any], None]:
    """K d^n + b sqrt(m K d^(n-1)) v is linear in w = d^((n+1)/2): a half swing of damping zeta returns exp(-pi zeta/sqrt(1 - zeta^2))."""

    def check(law: Any) -> None:
        K, mass, x, speed = mpf("2.4e9"), mpf("0.2"), mpf("1e-5"), mpf("0.5")
        for e in ("0.9", "0.5", "0.2"):
            state = {F: K * x**n, d: x, v: speed, m_eff: mass, k_t: n * K * x ** (n - 1), v0: mpf(1)}
            b = evaluate(law.resistance, numbers(law, e=e) | state) / (mp.sqrt(mass * K * x ** (n - 1)) * speed)
            zeta = b / mp.sqrt(2 * (n + 1))
            same(mp.exp(-mp.pi * zeta / mp.sqrt(1 - zeta**2)), mpf(e), mpf("1e-12"))

    return check


def jankowski_out(law: Any) -> None:
    """Damped over the first quarter alone, exp(-zeta acos(zeta)/sqrt(1 - zeta^2)) comes out: the printed digits."""
    K, mass, x, speed = mpf("2.4e9"), mpf("0.2"), mpf("1e-5"), mpf("0.5")
    for e, printed in cited.JANKOWSKI.items():
        values = numbers(law, e=e) | {F: K * x**1.5, d: x, m_eff: mass}
        zeta = evaluate(law.resistance, values | {v: speed}) / (mp.sqrt(mass * K * mp.sqrt(x)) * speed) / mp.sqrt(5)
        out = mp.exp(-zeta * mp.acos(zeta) / mp.sqrt(mp.mpc(1 - zeta**2))).real
        assert f"{float(out):.4f}" == printed
        assert evaluate(law.resistance, values | {v: -speed}) == 0


def kuwabara_loss(law: Any) -> None:
    """First order of 1 - e: twice the loss of an undamped impact, int A k_t v^2 dt over m v0^2, is 1.15345 (3/2) A (K/m)^(2/5) v0^(1/5)."""
    K, mass, speed, A = mpf("2.4e9"), mpf("0.2"), mpf("0.5"), mpf("1e-12")
    deepest = (5 * mass * speed**2 / (4 * K)) ** mpf("0.4")

    def power(t: Any) -> Any:  # d = dmax sin(t)^(4/5): v = v0 cos t
        x = deepest * mp.sin(t) ** mpf("0.8")
        state = {F: K * x**1.5, k_t: mpf("1.5") * K * mp.sqrt(x), d: x, v: speed * mp.cos(t), m_eff: mass}
        return (
            evaluate(law.resistance, numbers(law, A=A) | state)
            * deepest
            * mpf("0.8")
            * mp.sin(t) ** mpf("-0.2")
            * mp.cos(t)
        )

    with mp.workdps(15):
        lost = 2 * mp.quad(power, [mpf(0), mp.pi / 2])
    first = lost / (mass * speed**2)
    same(first, mpf(cited.KUWABARA_KONO) * mpf("1.5") * A * (K / mass) ** mpf("0.4") * speed ** mpf("0.2"), mpf("1e-5"))


def langevin(t: Any) -> Any:
    return mp.coth(t) - 1 / t


def exact_chain(law: Any) -> None:
    """Each definition by itself: Kroeger's start, t over Langevin's function below 1, what stands for it above, and Newton's step."""
    seam = langevin(mpf("1.005"))  # between 1 and 1.01, where the chain changes from one form to the other
    for x in (mpf("0.05"), mpf("0.3"), (1 - seam) / (1 + seam), mpf("0.7"), mpf("0.97")):
        values = {q.name: value for q, value in numbers(law, e=x).items()}
        y = (1 - x) / (1 + x)
        same(values["y"], y)
        same(values["r"], 1 - y)
        start = y * (3 - mpf("1.2") * y**2 - mpf("0.2") * y**4 + mpf("0.4") * y**6) / (1 - y**2)
        same(values["t_0"], start)
        for k in range(3):
            t = values[f"t_{k}"]
            fraction = mpf(17)
            for odd in range(15, 1, -2):  # Lambert's continued fraction of coth, from its end
                fraction = odd + t**2 / fraction
            same(values[f"q_{k}"], fraction)
            same(values[f"w_{k}"], 1 / max(t, mpf(1)))
            same(values[f"c_{k}"], 2 / mp.expm1(2 * max(t, mpf(1))))
            value = t / fraction if t < 1 else langevin(t)
            same(value, langevin(t), mpf("1e-15"))
            step = (y - value) / (1 - value**2 - 2 * value / t)
            assert abs(values[f"t_{k + 1}"] - t - step) <= mpf("1e-28") * t


def exact_root(law: Any) -> None:
    for e, printed in cited.EXACT_FACTORS.items():
        assert abs(factor_of(law, e) - mpf(printed)) <= mpf("5.01e-7")
        same(factor_of(law, e), mpf(exact_factor(e)), mpf("1e-13"))


def free_power(law: Any) -> None:
    """chi d^m v: of m = n it is the hysteresis h = chi v0/K, and as sqrt of the secant's power the linear oscillator."""
    K, speed, x = mpf("2.4e9"), mpf("0.5"), mpf("1e-5")
    for n, h in ((mpf("1.5"), mpf("0.4")), (mpf(1), mpf("0.2"))):
        values = numbers(law, chi=h * K / speed, m=n) | {d: x, v: mpf("0.3")}
        same(evaluate(law.resistance, values), K * x**n * h * mpf("0.3") / speed)
    same(evaluate(law.exponent, numbers(law, m="0.25")), mpf("0.25"))


# -- what is known of each ----------------------------------------------------------------------------------------------


def _hysteresis(
    name: str, at_one: Any, at_zero: Any, defined: str, recommended: str, *more: Evidence
) -> tuple[Evidence, ...]:
    formula = FACTORS.get(name)
    typed = (factor_is(formula),) if formula is not None else ()
    return (*typed, limits_are(at_one, at_zero), bounds_are(defined, recommended), *more)


R = sp.Rational
ELASTIC = Evidence(LIMIT, "the exact relation as e goes to 1", nearly_elastic)
PLASTIC = Evidence(LIMIT, "the exact relation as e goes to 0", nearly_plastic)
OSCILLATOR_1 = Evidence(EXACT, "the linear oscillator returns e", oscillator(mpf(1)))
OSCILLATOR = Evidence(EXACT, "linear in d^(5/4): returns e", oscillator(mpf("1.5")))


EVIDENCE: dict[str, tuple[Evidence, ...]] = {
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
}  # fmt: skip
