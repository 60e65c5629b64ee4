"""Of stiffness laws: Hertz, Sneddon, strips on half-spaces and cylinders pressed across by quadrature; fits and relations typed again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from bench import evaluate, numbers
from known import DIGITS, EXACT, LIMIT, QUADRATURE, SHARP, TYPED, Evidence, same
from mpmath import mp, mpf

from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import F, d
from reference import laws as cited

THIN = cited.STEEL | {"R_2": "0.00972"}  # clearance of 0.28 mm, below the seam of Pereira's fit at 0.34954 mm
SEAM = tuple(cited.STEEL | {"R_2": str(mpf("0.010") - mpf(gap))} for gap in ("3.49e-4", "3.5e-4"))
PAIRS = (cited.STEEL, cited.ALUMINIUM)
DEPTHS = ("1e-7", "1e-5", "8e-5")


# -- stiffness: numbers of a pair --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Bodies:
    """Two cylinders or spheres in SI, worked out from E, nu, R1, R2, L here and not by the catalogue."""

    E: Any
    nu: Any
    R1: Any
    R2: Any
    L: Any

    @classmethod
    def of(cls, pair: Mapping[str, str]) -> Bodies:
        return cls(*(mpf(pair[name]) for name in ("E", "nu", "R_1", "R_2", "L")))

    @property
    def plane_strain(self) -> Any:
        """E/(1 - nu^2) of either body."""
        return self.E / (1 - self.nu**2)

    @property
    def star(self) -> Any:
        return self.plane_strain / 2

    @property
    def dR(self) -> Any:
        return self.R1 - self.R2

    @property
    def R(self) -> Any:
        return 1 / (1 / self.R2 - 1 / self.R1)

    def half_width(self, load: Any) -> Any:
        """Hertz's half-width of the contact, a^2 = 4 q R/(pi E*), Johnson (1985) eq. 4.43."""
        return mp.sqrt(4 * load / self.L * self.R / (mp.pi * self.star))


def elastic(law: Any, depth: Any, pair: Mapping[str, str], **given: Any) -> Any:
    return evaluate(law.force, numbers(law, pair, **given) | {d: mpf(depth)})


def force_is(
    kind: str, what: str, formula: Callable[[Bodies, Any], Any], within: Any = SHARP, pairs: Any = PAIRS, **given: Any
) -> Evidence:
    """The force at some depths is that of a formula of the bodies and the depth."""

    def check(law: Any) -> None:
        for pair in pairs:
            for depth in DEPTHS:
                load = formula(Bodies.of(pair), mpf(depth))
                same(elastic(law, depth, pair, **given), load, within)
                if law.relation is not None:
                    same(relation_of(law, numbers(law, pair, **given), load), mpf(depth), within)

    return Evidence(kind, what, check)


def digits(name: str, times: str = "1") -> Evidence:
    """The forces of the table, in which a law without a length is multiplied by one."""

    def check(law: Any) -> None:
        for depth, printed in zip(cited.STEEL_PENETRATIONS, cited.STEEL_FORCES[name], strict=True):
            half = mpf(10) ** -len(printed.partition(".")[2]) / 2
            assert abs(elastic(law, depth, cited.STEEL) * mpf(times) - mpf(printed)) <= half * mpf("1.000001")

    return Evidence(DIGITS, "forces of steel at 0.1, 1 and 10 um", check)


def stored_is_the_integral() -> Evidence:
    def check(law: Any) -> None:
        if law.stored is None:
            return
        values = numbers(law)
        limit = evaluate(law.reach, values) if law.reach is not None else mpf("1e-3")
        for part in ("0.3", "0.9"):
            depth = min(limit, mpf("1e-3")) * mpf(part)
            peak = evaluate(law.force, values | {d: depth})
            with mp.workdps(16):
                share = mp.quad(lambda x: evaluate(law.force, values | {d: x * x * depth}) / peak * 2 * x, [0, 1])  # noqa: B023
            same(evaluate(law.stored, values | {d: depth}), peak * depth * share, mpf("1e-7"))

    return Evidence(EXACT, "the stored energy is the integral of the force", check, of_the_force=False)


def exponent_is(stated: Any, **given: Any) -> Evidence:
    """The n of K d^n as published."""

    def check(law: Any) -> None:
        same(evaluate(law.exponent, numbers(law, **given)), mpf(stated))

    return Evidence(TYPED, f"exponent {stated}", check, of_the_force=False)


def reach_is(length: Callable[[Bodies], Any], what: str = "the smaller radius") -> Evidence:
    def check(law: Any) -> None:
        for pair in PAIRS:
            same(evaluate(law.reach, numbers(law, pair)), length(Bodies.of(pair)))

    return Evidence(TYPED, f"defined up to {what}", check, of_the_force=False)


SMALLER = reach_is(lambda b: b.R2)


# -- stiffness: point contact ------------------------------------------------------------------------------------------


def hertz_by_quadrature(b: Bodies, depth: Any) -> Any:
    """Hertz's pressure over a circle a^2 = R d: its scale from the half-space's displacement at the centre, then its integral."""
    a = mp.sqrt(b.R * depth)
    under = 2 / b.star * mp.quad(lambda r: mp.sqrt(1 - (r / a) ** 2), [0, a])  # of p/(pi E* r) over the circle, per p0
    return depth / under * mp.quad(lambda r: 2 * mp.pi * r * mp.sqrt(1 - (r / a) ** 2), [0, a])


def sneddon_by_quadrature(k: Any, coefficient: Any) -> Callable[[Bodies, Any], Any]:
    """Sneddon (1965) for the profile f(x): d = a int f'/sqrt(a^2 - x^2), F = 2 E* int x^2 f'/sqrt(a^2 - x^2), x = a sin t."""

    def formula(b: Bodies, depth: Any) -> Any:
        def integral(power: int) -> Any:
            return mp.quad(lambda t: mp.sin(t) ** (k - 1 + power), [0, mp.pi / 2])

        a = (depth / (coefficient * k * integral(0))) ** (1 / k)
        return 2 * b.star * coefficient * k * a ** (k + 1) * integral(2)

    return formula


def general_power(law: Any) -> None:
    for n, expected in (("1.5", "2.4"), ("1", "2400"), ("2", "2.4e-3")):  # 2.4e9 N/m^n at 1 um
        same(evaluate(law.force, numbers(law, K="2.4e9", n=n) | {d: mpf("1e-6")}), mpf(expected))
    same(evaluate(law.exponent, numbers(law, n="1.3")), mpf("1.3"))


# -- stiffness: line contact -------------------------------------------------------------------------------------------


def log_law(
    relation: Callable[[Bodies, Any], Any], kind: str, what: str, within: Any = SHARP, **given: Any
) -> Iterator[Evidence]:
    """A published d(F): the record's relation, its force as the inverse, and its reach as the largest d there is."""

    def loads(b: Bodies) -> Iterator[Any]:
        yield from (b.star * b.L * b.dR * mpf(part) for part in ("1e-6", "1e-3"))

    def is_relation(law: Any) -> None:
        for pair in PAIRS:
            b, values = Bodies.of(pair), numbers(law, pair, **given)
            for load in loads(b):
                same(evaluate(law.relation, values | {F: load}), relation(b, load), within)

    def inverts(law: Any) -> None:
        for pair in PAIRS:
            b, values = Bodies.of(pair), numbers(law, pair, **given)
            for load in loads(b):
                same(evaluate(law.force, values | {d: relation(b, load)}), load, within)

    def turns(law: Any) -> None:
        for pair in PAIRS:
            b, values = Bodies.of(pair), numbers(law, pair, **given)
            reach = evaluate(law.reach, values)
            load = evaluate(law.force, values | {d: reach * (1 - mpf("1e-20"))})
            slope = mp.diff(lambda x: relation(b, x), load)  # noqa: B023
            assert abs(slope) <= mpf("1e-9") * reach / load
            same(reach, relation(b, load), max(within, mpf("1e-18")))

    yield Evidence(kind, f"{what}: d(F)", is_relation)
    yield Evidence(kind, f"{what}: F(d)", inverts)
    yield Evidence(EXACT, "the reach is the turning point", turns, of_the_force=False)


def relation_of(law: Any, values: Mapping[Any, Any], load: Any) -> Any:
    return evaluate(law.relation, {**values, F: load})


def both_halves(b: Bodies, load: Any, constant: Any) -> Any:
    """q/(pi E*) (ln(4 R1/a) + ln(4 R2/a) + constant) with Hertz's half-width a."""
    a = b.half_width(load)
    return load / (mp.pi * b.star * b.L) * (mp.log(4 * b.R1 / a) + mp.log(4 * b.R2 / a) + constant)


def compression_by_quadrature(b: Bodies, load: Any, share: Callable[[Any], Any]) -> Any:
    """Approach of the contact to both centres: strain along the axis, each cylinder pressed between a strip and a line across.

    The strip is Hertz's, of half-width a, its pressure q share(t)/a at x = a t. Of a line load at x (Flamant) sigma_z and sigma_x under the
    centre are -(2 q/pi) (z^3, z x^2)/(x^2 + z^2)^2, here integrated over z from 0 to R; then the load across, at 2 R, and the tension q/(pi R)
    that frees the rim (Johnson 1985, section 5.6).
    """
    q, a = load / b.L, b.half_width(load)
    ratio = b.nu / (1 - b.nu)

    def to_centre(x: Any, R: Any) -> Any:
        rest = x**2 / (x**2 + R**2)
        return mp.log((x**2 + R**2) / x**2) - (1 - rest) * (1 + ratio) + 2 * mp.log(2) - 1 + ratio

    with mp.workdps(20):
        strains = (mp.quad(lambda t: 2 * share(t) * to_centre(a * t, R), [0, 1]) for R in (b.R1, b.R2))  # noqa: B023
        return q / (mp.pi * b.plane_strain) * sum(strains)


def ellipse(t: Any) -> Any:
    """Hertz's pressure."""
    return 2 / mp.pi * mp.sqrt(1 - t**2)


def parabola(t: Any) -> Any:
    """Foeppl's."""
    return (1 - t**2) * 3 / 4


def strip_on_half_space(b: Bodies, load: Any) -> Any:
    """Displacement of two half-spaces at the centre of Hertz's strip, 2 a by L: the kernel 1/(pi E* r), along the strip in closed form."""
    a, q = b.half_width(load), load / b.L
    with mp.workdps(20):

        def share(t: Any) -> Any:  # x = a sin t, pressure 2 q/(pi a) cos t
            return mp.cos(t) ** 2 * 2 * mp.asinh(b.L / (2 * a * mp.sin(t)))

        return (
            2 * q / (mp.pi * b.star) * 2 / mp.pi * mp.quad(share, [0, mpf("1e-6"), mpf("1e-3"), mpf("0.1"), mp.pi / 2])
        )


def strip_closed(b: Bodies, load: Any) -> Any:
    """q/(pi E*) (2 ln(2 L/a) + 1): the same for a strip that is long for its width."""
    return load / (mp.pi * b.star * b.L) * (2 * mp.log(2 * b.L / b.half_width(load)) + 1)


def half_space_agrees(law: Any) -> None:
    """The kernel itself, at loads where a/L is 1e-3: to its square."""
    b, values = Bodies.of(cited.STEEL), numbers(law)
    load = mp.pi * b.star * b.L * (b.L * mpf("1e-3")) ** 2 / (4 * b.R)
    same(relation_of(law, values, load), strip_on_half_space(b, load), mpf("1e-6"))
    same(evaluate(law.force, values | {d: strip_on_half_space(b, load)}), load, mpf("1e-6"))


def compression_agrees(share: Callable[[Any], Any]) -> Callable[[Any], None]:
    """The integrated strains under a pressure, at a load where a/R is 1e-3."""

    def check(law: Any) -> None:
        b, values = Bodies.of(cited.STEEL), numbers(law)
        load = mp.pi * b.star * b.L * (b.R2 * mpf("1e-3")) ** 2 / (4 * b.R)
        depth = compression_by_quadrature(b, load, share)
        same(relation_of(law, values, load), depth, mpf("1e-6"))
        same(evaluate(law.force, values | {d: depth}), load, mpf("1e-6"))

    return check


def johnson_published(law: Any) -> None:
    for depth, printed in cited.JOHNSON.items():
        same(elastic(law, depth, cited.ALUMINIUM), mpf(printed), mpf("1e-9"))


def radzimovsky_roark(b: Bodies, load: Any) -> Any:
    """Roark's table of line contact: 2 q (1 - nu^2)/(pi E) (2/3 + ln(2 D1/b) + ln(2 D2/b)), one material, b the width from Hertz."""
    D1, D2, q = 2 * b.R1, 2 * b.R2, load / b.L
    width = 2 * b.half_width(load)
    return 2 * q / (mp.pi * b.plane_strain) * (mpf(2) / 3 + mp.log(2 * D1 / width) + mp.log(2 * D2 / width))


WHOLE_WIDTH = {"c_b": "2.256758334191025147792317806243090343376"}  # 4/sqrt(pi)


def pereira_mm(internal: bool) -> Callable[[Bodies, Any], Any]:
    """The fit as printed, in mm, N and MPa."""

    def formula(b: Bodies, depth: Any) -> Any:
        gap, modulus, length = b.dR * 1000, b.star / 10**6, b.L * 1000
        if internal:
            first = gap < mpf("0.34954")
            Y = mpf("1.51") * mp.log(1000 * gap) ** mpf("-0.151") if first else mpf("0.0151") * gap + mpf("1.151")
            a, c, n = mpf("0.965"), mpf("0.0965"), Y / gap ** mpf("0.005")
        else:
            a, c, n = mpf("0.39"), mpf("0.85"), mpf("1.094")
        return (a * gap + c) * length * modulus / gap * (depth * 1000) ** n

    return formula


def in_millimetres(formula: Callable[[Bodies, Any], Any], exponent: Callable[[Bodies], Any], pairs: Any) -> Evidence:
    """Of a law as published: numbers go in as mm and MPa, newtons come out."""

    def check(law: Any) -> None:
        for pair in pairs:
            scale = {"Pa": mpf(10) ** -6, "m": mpf(1000)}
            values = {q: x * scale.get(q.unit, 1) for q, x in numbers_given(law, pair).items()}
            for symbol, expression in law.definitions:
                values[symbol] = evaluate(expression, values)
            for depth in DEPTHS:
                same(evaluate(law.force, values | {d: mpf(depth) * 1000}), formula(Bodies.of(pair), mpf(depth)))
            same(evaluate(law.exponent, values), exponent(Bodies.of(pair)))
            if law.relation is not None:
                load = formula(Bodies.of(pair), mpf("1e-5"))
                same(evaluate(law.relation, values | {F: load}), mpf("1e-2"))

    return Evidence(TYPED, "as printed, in mm, N, MPa", check)


def numbers_given(law: Any, pair: Mapping[str, str]) -> dict[Any, Any]:
    """Of what a law does not define itself."""
    defined = dict(law.definitions)
    known = numbers(LAWS["hertz_point"], pair) | numbers(LAWS["johnson"], pair)
    return {q: x for q, x in known.items() if q in law.symbols() and q not in defined}


def pereira_exponent(b: Bodies) -> Any:
    one, two = (pereira_mm(True)(b, depth) for depth in (mpf("1e-6"), mpf("1e-5")))
    return mp.log(two / one) / mp.log(10)


def palmgren_mm(b: Bodies, depth: Any) -> Any:
    """d = 3.84e-5 F^0.9/L^0.8, in mm and N."""
    return (depth * 1000 * (b.L * 1000) ** mpf("0.8") / mpf("3.84e-5")) ** (mpf(10) / 9)


FITTED = {
    "inside": [("0.010", gap) for gap in ("1e-4", "5e-4", "1e-3")],
    "side by side": [("0.010", "0.0195"), ("0.005", "0.007")],
}  # R_1, dR


def near_johnson(where: str) -> Evidence:
    """Fits to steel or to Johnson's law stay within a fifth of it: a factor misread, of 2, pi or 10, does not."""

    def check(law: Any) -> None:
        for radius, gap in FITTED[where]:
            pair = cited.STEEL | {
                "R_1": radius,
                "R_2": str(mpf(radius) - mpf(gap)),
            }  # below 0 where the other is convex too
            for depth in ("1e-7", "1e-6", "1e-5"):
                same(elastic(law, depth, pair), elastic(LAWS["johnson"], depth, pair), mpf("0.2"))

    return Evidence(LIMIT, f"within a fifth of Johnson's law, {where}", check, of_the_force=False)


def named_units(law: Any) -> None:
    """The reference quantities of a repaired fit are the units it was made in."""
    expected = {"l_ref": mpf("1e-3"), "p_ref": mpf("1e6"), "F_ref": mpf(1)}
    assert law.defaults
    for symbol, parameter in law.defaults:
        same(mpf(repr(parameter.si)), expected[symbol.name])
        same(mpf(symbol.limit.lower), expected[symbol.name])
        same(mpf(symbol.limit.upper), expected[symbol.name])


def other_units(law: Any) -> None:
    """Palmgren's relation of numbers of a newton and a metre each twice the fit's: d/l = c (F/f)^0.9/(L/l)^0.8."""
    given = numbers(law, l_ref="2e-3", F_ref="2") | {F: mpf(500)}
    twice = {q: {"l_ref": mpf("2e-3"), "F_ref": mpf(2)}.get(q.name, x) for q, x in given.items()}
    expected = mpf("2e-3") * mpf("3.84e-5") * mpf(250) ** mpf("0.9") / mpf("7.5") ** mpf("0.8")
    same(evaluate(law.relation, twice), expected)


def hertz_width(law: Any) -> None:
    """The value that the law gives itself: b = 4/sqrt(pi) sqrt(F R/(L E*)) is Hertz's whole width."""
    ((symbol, parameter),) = law.defaults
    b = Bodies.of(cited.STEEL)
    assert symbol.name == "c_b"
    same(mpf(repr(parameter.si)) * mp.sqrt(mpf(100) * b.R / (b.L * b.star)), 2 * b.half_width(mpf(100)), mpf("1e-15"))


def roark_width(law: Any) -> None:
    """Roark's b, of diameters: 1.60 sqrt(p K_D C_E), 2.15 sqrt(p K_D/E) with nu = 0.3; with his largest stress, 0.798 sqrt(p/(K_D C_E)), an
    ellipse of the width b carries p: (pi/4) 1.60 0.798 = 1.00."""
    ((_, parameter),) = law.defaults
    b = mpf(repr(parameter.si)) / mp.sqrt(2)  # R = K_D/2
    printed = cited.ROARK_LINE
    assert [f"{float(x):.2f}" for x in (b, b * mp.sqrt(2 * (1 - mpf("0.09"))))] == [printed["b"], printed["b of steel"]]
    assert f"{float(mp.pi / 4 * b * mpf(printed['stress'])):.2f}" == "1.00"


def liu_formula(b: Bodies, depth: Any) -> Any:
    return mp.pi * b.star * depth * b.L / 2 * mp.sqrt(depth / (2 * (b.dR + depth)))


def tangent_of_liu(b: Bodies, depth: Any) -> Any:
    return mp.diff(lambda x: liu_formula(b, x) / b.L, depth)


def persson_formula(b: Bodies, depth: Any) -> Any:
    """E' dR/q = (2 - ln(1 + b^2) - 2 b^4)/(pi b^2 (1 + b^2)) with E' of one body: Persson's, for one material, as Ciavarella and Decuzzi print it."""
    angle = mp.acos(b.dR / (b.dR + depth))
    t = mp.tan(angle / 2) ** 2
    return b.plane_strain * b.dR * b.L * mp.pi * t * (1 + t) / (2 - mp.log(1 + t) - 2 * t**2)


def persson_is_hertz(law: Any) -> None:
    """A small half-angle: Hertz's half-width is R times it."""
    for pair in PAIRS:
        b = Bodies.of(pair)
        depth = b.dR * mpf("1e-14")
        angle = mp.acos(b.dR / (b.dR + depth))
        load = elastic(law, depth, pair)
        radius = mp.sqrt(b.R1 * b.R2)  # a clearance that is small for both
        same(b.half_width(load), radius * angle, mpf("1e-12"))


def persson_onset(law: Any) -> None:
    for pair in PAIRS:
        depth = Bodies.of(pair).dR * mpf("1e-16")
        same(elastic(law, depth, pair), elastic(LAWS["persson"], depth, pair), mpf("1e-12"))


def chord(b: Bodies, depth: Any) -> Any:
    """The load whose Hertz half-width is the chord at the depth, a^2 = 2 R d."""
    return mp.findroot(lambda x: b.half_width(x) ** 2 / (2 * b.R * depth) - 1, b.star * b.L * depth)


def popov(b: Bodies, depth: Any) -> Any:
    """One quarter of pi E* per unit of length."""
    return b.star * b.L * depth * mp.atan(1)


# -- what is known of each ----------------------------------------------------------------------------------------------


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


HALF_SPACE = Evidence(QUADRATURE, "Hertz's strip on a half-space", half_space_agrees)
COMPRESSION = Evidence(QUADRATURE, "strains of cylinders pressed across", compression_agrees(ellipse))
PUBLISHED = Evidence(DIGITS, "forces of aluminium, 10 digits", johnson_published)
UNITS = Evidence(EXACT, "the reference quantities are the units of the fit", named_units, of_the_force=False)


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
}  # fmt: skip
