"""Of friction laws: curves typed again, their slopes, steady sliding; of films Reynolds' equation by quadrature."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from bench import evaluate, numbers
from film import ETA, LENGTH, PIN, C, by_quadrature
from known import DIGITS, EXACT, QUADRATURE, SHARP, TYPED, Evidence, same
from mpmath import mp, mpf

from hertzwerk.derive.laws.law import N, s, z

# -- friction ----------------------------------------------------------------------------------------------------------

SLIDING = ("1e-5", "3e-4", "0.003", "0.009", "0.019", "0.049", "0.051", "0.08", "2")


def drags(formula: Callable[..., Any], slope: Callable[..., Any] | None = None) -> Evidence:
    """The force at many speeds, odd, and its slope at rest, by a formula of N and the law's own numbers."""

    def check(law: Any) -> None:
        values = numbers(law)
        named = {q.name: x for q, x in values.items()}
        for speed, load in ((sign * mpf(text), mpf(load)) for text in SLIDING for sign in (1, -1) for load in (700, 3)):
            expected = mp.sign(speed) * formula(abs(speed), load, named)
            same(evaluate(law.force, values | {s: speed, N: load}), expected)
        if slope is not None:
            actual, expected = evaluate(law.slope, values | {N: mpf(700)}), slope(mpf(700), named)
            assert abs(actual - expected) <= SHARP * abs(expected)

    return Evidence(TYPED, "the force as published", check)


def slope_at_rest(law: Any) -> None:
    tiny = mpf("1e-25")
    for load in (700, 3):
        values = numbers(law) | {N: mpf(load)}
        found = evaluate(law.force, values | {s: tiny}) / tiny
        assert abs(evaluate(law.slope, values) - found) <= mpf("1e-12") * abs(found)


def curve(x: Any, p: Any) -> Any:
    """Stribeck's."""
    return p["mu_k"] + (p["mu_s"] - p["mu_k"]) * mp.exp(-((x / p["v_S"]) ** 2))


def creep(law: Any) -> None:
    """On an incline of slope tan(theta) the smoothed law holds at a creep of v_s atanh(tan(theta)/mu)."""
    speed = mpf("1e-3") * mp.atanh(mpf("0.13") / mpf("0.2"))
    same(evaluate(law.force, numbers(law) | {s: speed, N: mpf(1)}), mpf("0.13"))


def coulomb_cone(law: Any) -> None:
    values = numbers(law) | {N: mpf(700)}
    same(evaluate(law.force, values | {s: mpf("0.3")}), mpf("0.15") * 700)
    same(evaluate(law.force, values | {s: mpf("-3")}), -mpf("0.15") * 700)
    same(evaluate(law.holding, values), mpf("0.25") * 700)


def threlfall_published(law: Any) -> None:
    """0.95 of mu N from the transition speed on, as printed."""
    for speed in ("0.02", "0.5"):
        found = evaluate(law.force, numbers(law) | {s: mpf(speed), N: mpf(1)}) / mpf("0.2")
        assert mp.nstr(found, 2) == "0.95"


def brown_published(law: Any) -> None:
    """At v_S the bump is 1: mu_k tanh 4 + mu_s - mu_k, and its top."""
    dry = numbers(law, c_v="0") | {N: mpf(1)}
    same(evaluate(law.force, dry | {s: mpf("0.05")}), mpf("0.15") * mp.tanh(4) + mpf("0.1"))
    level = {**dry, **{q: mpf(0) for q in dry if q.name == "mu_k"}}
    slope = mp.diff(lambda x: evaluate(law.force, level | {s: x}), mpf("0.05"))
    assert abs(slope) < mpf("1e-12")


def lugre_bristle(law: Any) -> None:
    ((symbol, rate, size),) = law.memory
    for speed in ("0.01", "0.3", "-0.1"):
        x = mpf(speed)
        values = numbers(law) | {s: x, N: mpf(700)}
        g = curve(x, {q.name: value for q, value in values.items()})
        settled = mp.sign(x) * g / mpf("1e5")
        for z_now in (mpf(0), mpf("1e-6"), settled):
            zdot = x - mpf("1e5") * abs(x) * z_now / g
            actual = evaluate(rate, values | {symbol: z_now})
            assert abs(actual - zdot) <= mpf("1e-20") + SHARP * abs(zdot)
            expected = 700 * (mpf("1e5") * z_now + 3 * zdot) + 3 * x
            same(evaluate(law.force, values | {z: z_now}), expected)
        same(evaluate(law.force, values | {z: settled}), mp.sign(x) * 700 * g + 3 * x)
    same(evaluate(size, numbers(law)), mpf("0.25") / mpf("1e5"))
    same(evaluate(law.slope, numbers(law)), mpf(700) * 3 + 3)


# -- films -------------------------------------------------------------------------------------------------------------


def reynolds(law: Any) -> None:
    """Drag along and across the squeeze velocity against Reynolds' equation by quadrature, and Petroff's couple."""
    rate = (mpf("0.02"), mpf("0.03"))
    speed = mp.hypot(*rate)
    w = (rate[0] / speed, rate[1] / speed)
    for e in ((3e-5, -4e-5), (-5e-5, 4e-5), (6e-5, 2e-5), (1e-5, 7e-5)):
        along = (e[0] * w[0] + e[1] * w[1]) / C
        across = (-e[0] * w[1] + e[1] * w[0]) / C
        given = {"eta": ETA, "R_2": PIN, "L": LENGTH, "dR": C, "epsilon_w": along, "epsilon_c": across}
        values = {q: mpf(given[q.name]) for q in law.symbols() if q.name in given}
        for symbol, expression in law.definitions:
            values[symbol] = evaluate(expression, values)
        force = by_quadrature(law.name, e, tuple(float(x) for x in rate))
        size = mp.hypot(force[0], force[1])
        actual = (-evaluate(law.along, values) * speed, -evaluate(law.across, values) * speed)
        expected = (force[0] * w[0] + force[1] * w[1], -force[0] * w[1] + force[1] * w[0])
        assert all(abs(x - y) <= mpf("1e-9") * size for x, y in zip(actual, expected, strict=True)), (actual, expected)
        spin = by_quadrature(law.name, e, (1e-9, 0.0), 200.0, -200.0)
        same(evaluate(law.couple, values) * 400, mpf(-(spin[2] - spin[5]) / 2), mpf("1e-9"))


def full_film(law: Any) -> None:
    """A full film is the half that bears and, of the opposite motion, the other half: by quadrature."""
    half = law.name.removesuffix("_full")
    speed = mp.hypot(mpf("0.02"), mpf("0.03"))
    w = (mpf("0.02") / speed, mpf("0.03") / speed)
    for e in ((3e-5, -4e-5), (-5e-5, 4e-5), (1e-5, 7e-5)):
        given = {"eta": ETA, "R_2": PIN, "L": LENGTH, "dR": C}
        given |= {"epsilon_w": (e[0] * w[0] + e[1] * w[1]) / C, "epsilon_c": (-e[0] * w[1] + e[1] * w[0]) / C}
        values = {q: mpf(given[q.name]) for q in law.symbols() if q.name in given}
        for symbol, expression in law.definitions:
            values[symbol] = evaluate(expression, values)
        there, back = (by_quadrature(half, e, (sign * 0.02, sign * 0.03)) for sign in (1, -1))
        force, size = there - back, mp.hypot(*map(mpf, there[:2]))
        actual = (-evaluate(law.along, values) * speed, -evaluate(law.across, values) * speed)
        expected = (force[0] * w[0] + force[1] * w[1], -force[0] * w[1] + force[1] * w[0])
        assert all(abs(x - y) <= mpf("1e-9") * size for x, y in zip(actual, expected, strict=True)), (actual, expected)
        spin = by_quadrature(half, e, (1e-9, 0.0), 200.0, -200.0)
        same(evaluate(law.couple, values) * 400, mpf(-(spin[2] - spin[5]) / 2), mpf("1e-9"))


def series(nearness: Any) -> Any:
    """Brenner's drag of a sphere that nears a plane over Stokes' drag, by the distance over the radius: Chem. Eng. Sci. 16 (1961) 242."""
    a, terms = mp.acosh(1 + mpf(nearness)), []
    for n in range(1, int(40 / float(a)) + 20):
        upper = 2 * mp.sinh((2 * n + 1) * a) + (2 * n + 1) * mp.sinh(2 * a)
        lower = 4 * mp.sinh((n + mpf(1) / 2) * a) ** 2 - (2 * n + 1) ** 2 * mp.sinh(a) ** 2
        terms.append(mpf(n * (n + 1)) / ((2 * n - 1) * (2 * n + 3)) * (upper / lower - 1))
    return mpf(4) / 3 * mp.sinh(a) * mp.fsum(terms)


def drag_of(law: Any, radius: Any, distance: Any) -> Any:
    """Drag of a sphere's film over Stokes' drag."""
    given = {"eta": mpf("0.3"), "R_eff": mpf(radius), "h": mpf(distance)}
    return evaluate(law.along, {q: given[q.name] for q in law.symbols()}) / (6 * mp.pi * given["eta"] * given["R_eff"])


def paraboloid(law: Any) -> None:
    """Film of a sphere against Reynolds' equation of a paraboloid, the pressure 6 eta v r/h^3 inwards and the force by quadrature."""
    for radius, least in (("0.01", "1e-6"), ("0.03", "1e-4")):
        R, d = mpf(radius), mpf(least)
        edge = [mp.sqrt(R * d) * mpf(10) ** k for k in (0, 1, 2, 4, 8)]
        # by parts: the pressure times the area within is the area times what the pressure falls by
        fall = partial(lambda R, d, r: 6 * r / (d + r**2 / (2 * R)) ** 3, R, d)
        force = mp.quad(lambda r, fall=fall: mp.pi * r**2 * fall(r), [0, *edge, mp.inf])
        same(drag_of(law, radius, least), force / (6 * mp.pi * R), mpf("1e-12"))


def sphere_before_plane(law: Any) -> None:
    """Brenner's law within 8e-4 of his series, and at both ends of it."""
    for nearness in ("3e-3", "0.02", "0.1", "0.5", "1.5", "4", "20"):
        assert abs(drag_of(law, 1, nearness) / series(nearness) - 1) < mpf("8e-4"), nearness
    near, far = mpf("1e-12"), mpf("1e8")
    same(drag_of(law, 1, near) - 1 / near, mp.log(1 / near) / 5 + mpf("0.971264"), mpf("1e-6"))
    same(drag_of(law, 1, far), mpf(1), mpf("1e-7"))


def brenner_typed(law: Any) -> None:
    """The same, typed again."""
    for nearness in map(mpf, ("1e-3", "0.3", "7")):
        fitted = mpf("0.028736") / (1 + mpf("0.94") * mp.sqrt(nearness) + mpf("0.115") * nearness)
        same(drag_of(law, "0.02", nearness / 50), 1 + 1 / nearness + mp.log(1 + 1 / nearness) / 5 - fitted)


# -- what is known of each ----------------------------------------------------------------------------------------------


SLOPE = Evidence(EXACT, "the slope at rest is the derivative", slope_at_rest, of_the_force=False)


EVIDENCE: dict[str, tuple[Evidence, ...]] = {
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
