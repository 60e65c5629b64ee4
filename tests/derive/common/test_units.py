"""The unit reader and printer: tables, refusals, round trip, and pint as an independent reader."""

import math
from decimal import Decimal, localcontext
from fractions import Fraction

import pint
import pytest
from each import each
from hypothesis import given
from hypothesis import strategies as st

from hertzwerk.derive.common.units import Exponent, UnitError, parse_quantity, parse_unit, rational, unit_text

N_NAME = Exponent.named("n")


def exponents(*base):
    given = (*base, *(0,) * (5 - len(base)))
    return tuple(e if isinstance(e, Exponent) else Exponent(Fraction(e)) for e in given)


# text, factor to SI, M, L, T, Theta, printed
READ = [
    ("1", 1.0, 0, 0, 0, 0, "1"), ("m", 1.0, 0, 1, 0, 0, "m"), ("mm", 0.001, 0, 1, 0, 0, "m"), ("um", 1e-6, 0, 1, 0, 0, "m"),
    ("µm", 1e-6, 0, 1, 0, 0, "m"),  # micro sign
    ("μm", 1e-6, 0, 1, 0, 0, "m"),  # Greek mu
    ("dam", 10.0, 0, 1, 0, 0, "m"), ("kg", 1.0, 1, 0, 0, 0, "kg"), ("g", 0.001, 1, 0, 0, 0, "kg"), ("t", 1000.0, 1, 0, 0, 0, "kg"),
    ("min", 60.0, 0, 0, 1, 0, "s"), ("h", 3600.0, 0, 0, 1, 0, "s"), ("km/h", 1 / 3.6, 0, 1, -1, 0, "m/s"), ("rpm", math.pi / 30, 0, 0, -1, 0, "1/s"),
    ("rev/min", math.pi / 30, 0, 0, -1, 0, "1/s"), ("rad/s", 1.0, 0, 0, -1, 0, "1/s"), ("rad", 1.0, 0, 0, 0, 0, "1"),
    ("deg", math.pi / 180, 0, 0, 0, 0, "1"), ("°", math.pi / 180, 0, 0, 0, 0, "1"), ("%", 0.01, 0, 0, 0, 0, "1"), ("N", 1.0, 1, 1, -2, 0, "N"),
    ("kg m/s^2", 1.0, 1, 1, -2, 0, "N"), ("GPa", 1e9, 1, -1, -2, 0, "Pa"), ("N/mm^2", 1e6, 1, -1, -2, 0, "Pa"), ("bar", 1e5, 1, -1, -2, 0, "Pa"),
    ("N m", 1.0, 1, 2, -2, 0, "J"), ("N·m", 1.0, 1, 2, -2, 0, "J"), ("kW", 1e3, 1, 2, -3, 0, "W"), ("kg m^2", 1.0, 1, 2, 0, 0, "kg m^2"),
    ("kg·m²", 1.0, 1, 2, 0, 0, "kg m^2"), ("s⁻¹", 1.0, 0, 0, -1, 0, "1/s"), ("m/s^2", 1.0, 0, 1, -2, 0, "m/s^2"),
    ("m s**-2", 1.0, 0, 1, -2, 0, "m/s^2"), ("kg/m^3", 1.0, 1, -3, 0, 0, "kg/m^3"), ("N s/m", 1.0, 1, 0, -1, 0, "N s/m"),
    ("N*s/m", 1.0, 1, 0, -1, 0, "N s/m"), ("kg/s", 1.0, 1, 0, -1, 0, "N s/m"), ("kg m/s", 1.0, 1, 1, -1, 0, "N s"),
    ("mPa s", 1e-3, 1, -1, -1, 0, "Pa s"), ("cP", 1e-3, 1, -1, -1, 0, "Pa s"), ("cSt", 1e-6, 0, 2, -1, 0, "m^2/s"),
    ("1/Pa", 1.0, -1, 1, 2, 0, "1/Pa"), ("m/N", 1.0, -1, 0, 2, 0, "m/N"), ("W/(m K)", 1.0, 1, 1, -3, -1, "W/(m K)"),
    ("W/m/K", 1.0, 1, 1, -3, -1, "W/(m K)"), ("W/(m^2*K)", 1.0, 1, 0, -3, -1, "W/(m^2 K)"), ("J/(kg K)", 1.0, 0, 2, -2, -1, "m^2/(s^2 K)"),
    ("J/K", 1.0, 1, 2, -2, -1, "J/K"), ("um/(m K)", 1e-6, 0, 0, 0, -1, "1/K"), ("N/m^1.5", 1.0, 1, "-1/2", -2, 0, "N/m^1.5"),
    ("N/m**(3/2)", 1.0, 1, "-1/2", -2, 0, "N/m^1.5"), ("N/m^0.5", 1.0, 1, "1/2", -2, 0, "N/m^0.5"),
    ("N/mm^1.5", 10**4.5, 1, "-1/2", -2, 0, "N/m^1.5"), ("Pa m^0.5", 1.0, 1, "-1/2", -2, 0, "N/m^1.5"),
    ("N^(1/3)", 1.0, "1/3", "1/3", "-2/3", 0, "N^(1/3)"), ("(N/m)^0.5", 1.0, "1/2", 0, -1, 0, "N^0.5/m^0.5"),
    ("N/m^n", 1.0, 1, 1 + N_NAME * -1, -2, 0, "N/m^n"), ("GPa/m^n", 1e9, 1, N_NAME * -1 - 1, -2, 0, "N/m^(n+2)"),
    ("N s/m^(n+1)", 1.0, 1, N_NAME * -1, -1, 0, "N s/m^(n+1)"), ("N m^(n-1.5)", 1.0, 1, N_NAME - Fraction(1, 2), -2, 0, "N m^(n-1.5)"),
    ("N (s/m)^k", 1.0, 1, 1 - Fraction(0) + Exponent.named("k") * -1, Exponent.named("k") - 2, 0, "N s^k/m^k"),
    ("m^(2n/3-1)", 1.0, 0, N_NAME * Fraction(2, 3) - 1, 0, 0, "m^(2*n/3-1)"),
    ("m^(2*(n+k)-(n-1))", 1.0, 0, N_NAME + Exponent.named("k") * 2 + 1, 0, 0, "m^(2*k+n+1)"), ("m^-n", 1.0, 0, N_NAME * -1, 0, 0, "1/m^n"),
]  # fmt: skip


@each(("text", "factor", "m", "l", "t", "theta", "printed"), READ)
def test_reads_units_as_people_write_them(text, factor, m, l, t, theta, printed):
    unit = parse_unit(text)
    assert unit.exponents == exponents(m, l, t, theta)
    assert unit.factor == pytest.approx(factor, rel=1e-15, abs=0)
    assert unit_text(unit.exponents) == str(unit) == printed


@each(
    ("text", "of", "printed"),
    [("V", "W/A", "W/A"), ("ohm", "V/A", "W/A^2"), ("mH", "mV s/A", "J/A^2"), ("V s/rad", "N m/A", "J/A"), ("A", "A", "A")],
)  # fmt: skip
def test_reads_electric_units(text, of, printed):
    """A motor's torque for each ampere is its voltage for each rad/s."""
    assert (parse_unit(text).exponents, parse_unit(text).factor) == (parse_unit(of).exponents, parse_unit(of).factor)
    assert str(parse_unit(text)) == printed


# text, what the message must say (found ... and the way out)
REFUSED = [
    ("Hz", "rpm (1 Hz of turns is 60 rpm) or rad/s"), ("kHz", "rpm (1 Hz of turns is 60 rpm) or rad/s"), ("", "found no unit"),
    ("  ", "found no unit"), ("Mpa", "did you mean MPa?"), ("newton", "did you mean N?"), ("kilograms", "did you mean kg?"), ("Nm", "'N m'"),
    ("m2", "m^2"), ("furlong", "known are m g s K rad A N Pa"), ("degC", "in K"), ("°C", "in K"), ("mol", "amount of substance"),
    ("cd", "luminous intensity"), ("C", "an electric charge in A s"), ("kkg", "found 'kkg'"), ("mmin", "found 'mmin'"),  # a minute takes no prefix
    ("N/mm^n", "would depend on n"), ("rpm^n", "would depend on n"), ("N/m s", "expected parentheses"), ("W/m^2 K", "expected parentheses"),
    ("m^3/2", "m^(3/2)"), ("5 mm", "no number but 1"), ("m^(n*k)", "linear in its names"), ("(m^n)^k", "linear in its names"),
    ("m^(1/n)", "division by n"), ("m^(1/0)", "division by 0"), ("m^2^3", "one exponent"), ("m^", "found the end"), ("m^^2", "found '^'"),
    ("(m", "expected ')'"), ("m)", "found ')'"), ("/s", "found '/'"), ("m+s", "found '+'"), ("m^%", "expected an exponent"),
    ("m^200", "beyond +-100"), ("m^" + "9" * 300, "beyond +-100"), ("m^0." + "3" * 300, "beyond +-100"), ("((Gm/m)^100)^100", "beyond 1e300"),
    ("fm^100", "beyond 1e300"), ("(" * 30 + "m" + ")" * 30, "nested parentheses"), ("m " * 300, "at most 400"), ("__import__('os')", "found"),
    ("m;s", "found ';s'"),
]  # fmt: skip


@each(("text", "said"), REFUSED)
def test_refuses_with_the_way_out(text, said):
    with pytest.raises(UnitError) as raised:
        parse_unit(text)
    assert said in str(raised.value)
    assert "found" in str(raised.value)


@each("value", [5, None, ["m"], b"m"])
def test_refuses_what_is_no_text(value):
    for read in (parse_unit, parse_quantity):
        with pytest.raises(UnitError, match=r"as text such as|unit text such as"):
            read(value)


# text, value, SI value (exact), unit
QUANTITIES = [
    ("0.2 mm", 0.2, 0.0002, "m"), ("0.5mm", 0.5, 0.0005, "m"), ("3.3 um", 3.3, 3.3e-6, "m"), ("5000 rpm", 5000.0, 523.5987755982989, "1/s"),
    ("-3e-4", -3e-4, -3e-4, "1"), ("+.5 GPa", 0.5, 5e8, "Pa"), ("1e9 N/m^1.5", 1e9, 1e9, "N/m^1.5"), ("50%", 50.0, 0.5, "1"),
    ("24 ms", 24.0, 0.024, "s"), ("5/s", 5.0, 5.0, "1/s"), ("2*m", 2.0, 2.0, "m"), ("−1 m", -1.0, -1.0, "m"),  # the typographic minus
]  # fmt: skip


@each(("text", "value", "si", "printed"), QUANTITIES)
def test_reads_quantities(text, value, si, printed):
    actual, unit = parse_quantity(text)
    assert actual == value
    assert unit.to_si(actual) == si
    assert str(unit) == printed


@each(
    ("text", "said"),
    [
        ("mm", "no finite number"), ("nan m", "no finite number"), ("inf", "no finite number"),
        ("1e400 m", "beyond the range"), ("1,5 mm", "1.5 mm"), ("1 2 mm", "found '2'"), ("3 Hz", "rad/s"),
        ("2*", "expected a unit"), ("", "no finite number"),
    ],
)  # fmt: skip
def test_refuses_quantities(text, said):
    with pytest.raises(UnitError) as raised:
        parse_quantity(text)
    assert said in str(raised.value)


@given(
    st.decimals(min_value=-(10**6), max_value=10**6, places=4), st.sampled_from(["mm", "um", "ms", "GPa", "kN", "min"])
)
def test_decimal_units_round_once(value, text):
    """The SI value is the double nearest the decimal product, which the product of two doubles often is not."""
    exact = {"mm": "1e-3", "um": "1e-6", "ms": "1e-3", "GPa": "1e9", "kN": "1e3", "min": "60"}
    with localcontext() as context:
        context.prec = 60
        assert parse_unit(text).to_si(float(value)) == float(Decimal(repr(float(value))) * Decimal(exact[text]))


def test_rational_reads_the_fraction_that_was_meant():
    assert rational(1.5) == Fraction(3, 2)
    assert rational(0.1) == Fraction(1, 10)
    assert rational(1 / 3) == Fraction(1, 3)
    assert rational(math.pi) == Fraction(math.pi) != Fraction(355, 113)
    with pytest.raises(UnitError, match="finite"):
        rational(math.inf)


# --- properties -----------------------------------------------------------------------------------------------------

NAMES = st.sampled_from(["n", "k", "exponent", "n_1", "alpha"])
RATIONALS = st.fractions(min_value=-12, max_value=12, max_denominator=12)
FORMS = st.builds(
    lambda c, terms: Exponent(c, tuple(terms.items())), RATIONALS, st.dictionaries(NAMES, RATIONALS, max_size=2)
)
SIMPLE = st.builds(Exponent, RATIONALS)
DIMENSIONS = st.tuples(st.one_of(SIMPLE, FORMS), FORMS, FORMS, st.one_of(SIMPLE, FORMS), st.one_of(SIMPLE, FORMS))


@given(DIMENSIONS)
def test_printed_units_read_back(exponents_given):
    assert parse_unit(unit_text(exponents_given)).exponents == exponents_given


@given(FORMS, FORMS, FORMS, RATIONALS, RATIONALS)
def test_exponents_are_a_vector_space(a, b, c, x, y):
    assert a + b == b + a
    assert (a + b) + c == a + (b + c)
    assert (a + b) * x == a * x + b * x
    assert a * x * y == a * (x * y)
    assert a - a == Exponent()
    assert not (a - a)
    assert hash(a + b) == hash(b + a)


@given(FORMS, st.integers(-5, 5))
def test_exponent_at_a_value(form, value):
    names = dict.fromkeys(form.names, value)
    assert form.at(names) == Exponent(form.constant + sum(c * value for _, c in form.terms))


def test_symbolic_unit_at_a_value():
    assert parse_unit("N/m^n").free_names == ("n",)
    assert str(parse_unit("N/m^n").at({"n": 1.5})) == "N/m^1.5"
    assert str(parse_unit("N s/m^(n+1)").at({"n": 1.5})) == "N s/m^2.5"
    assert parse_unit("N/m^n").at({"k": 2}) == parse_unit("N/m^n")
    assert parse_unit("rad/s").dimensionless is False
    assert parse_unit("deg").dimensionless is True


# --- pint as oracle -------------------------------------------------------------------------------------------------

PINT = pint.UnitRegistry(cache_folder=None)
ATOMS = [
    "m", "mm", "um", "µm", "cm", "km", "nm", "g", "kg", "mg", "s", "ms", "us", "K", "mK", "N", "kN", "mN", "Pa",
    "kPa", "MPa", "GPa", "J", "kJ", "W", "kW", "mW", "bar", "min", "rad", "mrad", "deg", "rpm", "P", "cP", "St",
    "cSt", "L", "t", "A", "mA", "V", "kV", "ohm", "mH",
]  # fmt: skip
BASES = ("[mass]", "[length]", "[time]", "[temperature]", "[current]")
PINT_NAMES = {"P": "poise", "cP": "centipoise", "St": "stokes", "cSt": "centistokes", "h": "hour"}


@given(
    st.lists(st.tuples(st.sampled_from(ATOMS), st.sampled_from([1, -1, 2, -2, 0.5, -1.5, 3])), min_size=1, max_size=4)
)
def test_agrees_with_pint(powers):
    ours = parse_unit(" ".join(f"{atom}^{power}" for atom, power in powers))
    theirs = PINT.parse_expression("*".join(f"{PINT_NAMES.get(atom, atom)}**({power})" for atom, power in powers))
    base = (1 * theirs).to_base_units()
    dimensionality = dict(base.dimensionality)
    assert ours.factor == pytest.approx(float(base.magnitude), rel=1e-12)
    for exponent, name in zip(ours.exponents, BASES, strict=True):
        assert float(exponent.constant) == pytest.approx(float(dimensionality.pop(name, 0)), abs=1e-12)
    assert not dimensionality


@each("text", ["kg*m**2/s**3", "N/(m*K)", "1/(s*Pa)", "J/kg/K", "N*s/m", "m/s/s", "(kg*m)/(s**2)", "N/m*s"])
def test_agrees_with_pint_on_division(text):
    base = (1 * PINT.parse_expression(text)).to_base_units()
    ours = parse_unit(text)
    theirs = [dict(base.dimensionality).get(name, 0) for name in BASES]
    assert [float(e.constant) for e in ours.exponents] == theirs


# --- bounded --------------------------------------------------------------------------------------------------------
