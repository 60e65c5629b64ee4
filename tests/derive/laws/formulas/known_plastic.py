"""Of elastic-plastic laws: restitution by quadrature against Thornton's closed form, fits of finite elements typed again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bench import evaluate, numbers
from known import DIGITS, EXACT, TYPED, Evidence, same
from known_stiffness import PAIRS, SMALLER, Bodies
from mpmath import mp, mpf

from hertzwerk.derive.laws.law import F_m, d, d_m, d_r, h_m

STRENGTH = "1e9"
QUADRATURE = mpf("1e-11")  # of an integral with double the digits of a double


def _values(law: Any, pair: Any, **given: Any) -> dict[Any, Any]:
    return numbers(law, pair, sigma_y=STRENGTH, **given)


def restitution(law: Any, values: dict[Any, Any], depth: Any) -> tuple[Any, Any]:
    """Work spent [J] on the way to a largest penetration, and the restitution: the root of the part that unloading returns."""
    onset = evaluate(law.onset, values)
    spent = mp.quad(lambda x: evaluate(law.force, values | {d: x}), [0, onset, depth])
    dent = evaluate(law.dent, values | {d: depth})
    turned = values | {d_m: depth, d_r: dent, h_m: depth - dent, F_m: evaluate(law.force, values | {d: depth})}
    returned = mp.quad(lambda x: evaluate(law.unloading, turned | {d: x}), [dent, depth])
    return spent, mp.sqrt(returned / spent)


def thornton_closed(law: Any) -> None:
    """Thornton (1997), eq. 22: e of an approach speed over that of first yield, whatever the pressure that limits."""
    for pair, ratio in ((PAIRS[0], "1.6"), (PAIRS[1], "2.8")):
        values = _values(law, pair, c_p=ratio)
        onset = evaluate(law.onset, values)
        first = restitution(law, values, onset)[0]
        for times in (mpf("1.2"), mpf(3), mpf(40)):
            spent, e = restitution(law, values, times * onset)
            r = mp.sqrt(first / spent)  # V_y/V
            closed = (
                mp.sqrt(6 * mp.sqrt(3) / 5)
                * mp.sqrt(1 - r**2 / 6)
                * mp.root(r / (r + 2 * mp.sqrt(mpf(6) / 5 - r**2 / 5)), 4)
            )
            same(e, closed, QUADRATURE)


def yield_speed_digits(law: Any) -> None:
    """Thornton (1997), eq. 33: V_y = 1.56 sqrt(p^5/(E*^4 rho)) of a sphere on a half-space, whatever its radius."""
    bodies, values = Bodies.of(PAIRS[0]), _values(law, PAIRS[0], c_p="1.6")
    onset, mass = (
        evaluate(law.onset, values),
        mp.pi * 4 / 3 * bodies.R**3,
    )  # density 1, of a sphere of the relative radius
    speed = mp.sqrt(2 * mp.quad(lambda x: evaluate(law.force, values | {d: x}), [0, onset]) / mass)
    assert mp.nstr(speed / mp.sqrt((mpf("1.6") * mpf(STRENGTH)) ** 5 / bodies.star**4), 3) == "1.56"


def first_yield(pressure: Callable[[Any], Any], what: str, **given: Any) -> Evidence:
    """First yield is where Hertz's largest pressure 2 E* a/(pi R), a^2 = R d, is a multiple of the yield strength."""

    def check(law: Any) -> None:
        for pair in PAIRS:
            bodies, values = Bodies.of(pair), _values(law, pair, **given)
            onset = evaluate(law.onset, values)
            same(2 * bodies.star / mp.pi * mp.sqrt(onset / bodies.R), pressure(bodies) * mpf(STRENGTH))
            for part in ("0.1", "0.99"):
                x = mpf(part) * onset
                same(evaluate(law.force, values | {d: x}), mpf(4) / 3 * bodies.star * mp.sqrt(bodies.R * x) * x)

    return Evidence(TYPED, what, check)


def fits(what: str, *rows: tuple[str, Callable[[Bodies, Any], Any]]) -> Evidence:
    """Force over that of first yield, dent over depth and steepness at multiples of the depth of first yield."""

    def check(law: Any) -> None:
        for pair in PAIRS:
            values = _values(law, pair)
            onset = evaluate(law.onset, values)
            peak = evaluate(law.force, values | {d: onset})
            for times, formula in rows:
                there = values | {d: mpf(times) * onset}
                force, dent, steepness = formula(Bodies.of(pair), mpf(times))
                same(evaluate(law.force, there) / peak, force)
                same(evaluate(law.dent, there) / (mpf(times) * onset), dent)
                same(evaluate(law.steepness, there), steepness)

    return Evidence(TYPED, what, check)


def takes_over(before: Callable[[Any, Any, Any], Any], after: Callable[[Any, Any, Any], Any], near: str) -> Evidence:
    """The lesser of two expressions acts on either side of where they meet: forces over that of first yield."""

    def check(law: Any) -> None:
        for strength in (STRENGTH, "2e10"):
            bodies, values = Bodies.of(PAIRS[0]), numbers(law, sigma_y=strength)
            strain, onset = mpf(strength) / bodies.star, evaluate(law.onset, values)
            peak = evaluate(law.force, values | {d: onset})
            meeting = mp.findroot(lambda x: before(bodies, strain, x) - after(bodies, strain, x), mpf(near))  # noqa: B023
            for times, formula in ((1 - mpf("1e-7"), before), (1 + mpf("1e-7"), after)):
                x = meeting * times
                same(evaluate(law.force, values | {d: x * onset}) / peak, formula(bodies, strain, x))
            kink = min(law.kinks, key=lambda kink: abs(evaluate(kink, values | {d: meeting * onset})))
            assert abs(evaluate(kink, values | {d: meeting * onset})) < mpf("1e-25")

    return Evidence(TYPED, f"one expression after the other, near {near}", check)


def _hertz(_bodies: Any, _strain: Any, x: Any) -> Any:
    return x ** mpf("1.5")


def _kogut(factor: str, exponent: str) -> Callable[[Any, Any, Any], Any]:
    return lambda _bodies, _strain, x: mpf(factor) * x ** mpf(exponent)


def _etsion(x: Any) -> tuple[Any, Any]:
    return (1 - 1 / x ** mpf("0.28")) * (1 - 1 / x ** mpf("0.69")), mpf("1.5") / x ** mpf("0.0331")


def _jackson(bodies: Any, x: Any) -> tuple[Any, Any, Any]:
    dent = mpf("1.02") * (1 - ((x + mpf("5.9")) / mpf("6.9")) ** mpf("-0.54"))
    return _jackson_force(bodies, mpf(STRENGTH) / bodies.star, x), dent, mpf("1.5")


def _jackson_force(bodies: Any, strain: Any, x: Any) -> Any:
    C = mpf("1.295") * mp.exp(mpf("0.736") * bodies.nu)
    radius = mp.pi * C * strain / 2 * mp.sqrt(x * (x / mpf("1.9")) ** (mpf("0.14") * mp.exp(23 * strain)))
    hardness = mpf("2.84") * (1 - mp.exp(-mpf("0.82") / radius ** mpf("0.7")))
    return (
        mp.exp(-(x ** (mpf(5) / 12)) / 4) * x ** mpf("1.5")
        + 4 * hardness / C * (1 - mp.exp(-(x ** (mpf(5) / 9)) / 25)) * x
    )


def reach_of_radius(law: Any) -> None:
    """At the reach the contact radius is 0.41 R."""
    for pair in PAIRS:
        bodies, values = Bodies.of(pair), _values(law, pair)
        x = evaluate(law.reach, values) / evaluate(law.onset, values)
        strain, C = mpf(STRENGTH) / bodies.star, mpf("1.295") * mp.exp(mpf("0.736") * bodies.nu)
        same(mp.pi * C * strain / 2 * mp.sqrt(x * (x / mpf("1.9")) ** (mpf("0.14") * mp.exp(23 * strain))), mpf("0.41"))


def reach_in_depths(law: Any) -> None:
    values = _values(law, PAIRS[0])
    same(evaluate(law.reach, values), 110 * evaluate(law.onset, values))


def pressure_ratio(law: Any) -> None:
    ((symbol, value),) = law.defaults
    assert symbol.name == "c_p"
    same(mpf(repr(value.default)), mpf("1.6"))


THORNTON = (
    Evidence(EXACT, "restitution by quadrature, his closed form", thornton_closed),
    Evidence(DIGITS, "speed of first yield, 1.56", yield_speed_digits),
    first_yield(lambda b: mpf("2.8"), "first yield at p_y", c_p="2.8"),
    Evidence(TYPED, "p_y = 1.6 Y by Johnson", pressure_ratio, of_the_force=False),
)
KOGUT_ETSION = (
    first_yield(lambda b: mpf("2.8") * (mpf("0.454") + mpf("0.41") * b.nu), "first yield at K H"),
    fits(
        "the fits as printed",
        ("1.2", lambda b, x: (x ** mpf("1.5"), *_etsion(x))),
        *((x, lambda b, x: (mpf("1.03") * x ** mpf("1.425"), *_etsion(x))) for x in ("1.6", "5.9")),
        *((x, lambda b, x: (mpf("1.40") * x ** mpf("1.263"), *_etsion(x))) for x in ("7", "100")),
    ),
    takes_over(_hertz, _kogut("1.03", "1.425"), "1.5"),
    takes_over(_kogut("1.03", "1.425"), _kogut("1.40", "1.263"), "6.6"),
    Evidence(TYPED, "up to 110 depths of first yield", reach_in_depths, of_the_force=False),
)
JACKSON_GREEN = (
    first_yield(lambda b: mpf("1.295") * mp.exp(mpf("0.736") * b.nu), "first yield at C Y"),
    fits("the fits as printed", *((x, _jackson) for x in ("3", "30", "400"))),
    takes_over(_hertz, _jackson_force, "1.9"),
    Evidence(TYPED, "up to a contact radius of 0.41 R", reach_of_radius, of_the_force=False),
)


# -- what is known of each ----------------------------------------------------------------------------------------------


EVIDENCE: dict[str, tuple[Evidence, ...]] = {
    "thornton": (*THORNTON, SMALLER),
    "kogut_etsion": KOGUT_ETSION,
    "jackson_green": JACKSON_GREEN,
}  # fmt: skip
