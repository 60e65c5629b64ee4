"""The audit of one expression: tables of both verdicts, symbolic exponents, repairs, the algebra of dimensions."""

import pytest
import sympy as sp
from calls import calls_of
from each import each
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf
from rescaling import ROUNDING, rescale
from sympy import Max, Min, Rational, acos, atan, atan2, cos, cosh, exp, log, pi, sign, sin, sqrt, tan, tanh
from sympy.core.function import AppliedUndef

from hertzwerk.derive.common.units import UnitError
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.splines import Table
from hertzwerk.derive.expressions.dimension.dimension import ONE, ZERO, Dimension, DimensionError
from hertzwerk.derive.expressions.dimension.rules import SIGNATURES
from hertzwerk.derive.expressions.dimension.symbolic import as_immutable, symbolic
from hertzwerk.derive.expressions.dimension.walker import check, dimension_of

n, k, xi = sp.symbols("n k xi")  # constant parameters of unit 1
CONSTANTS = {n, k, xi}

UNITS = {
    "N/m^1.5": "K", "N/m^n": "Kn", "N s/m^(n+1)": "chi", "Pa": "E G p tau H", "N": "F F_N F_t", "N/m": "q c sigma",
    "m": "d R R1 R2 dR L x y z b_w c_R h_f lam", "m/s": "v v0 v_s v_S U w_s", "m/s^2": "a g", "s": "t t0 A",
    "kg": "m m1 m2 m_eff", "kg m^2": "J I_z", "1/s": "omega wn", "N m": "M_t", "kg/m^3": "rho", "Pa s": "eta",
    "m^2/s": "nu_k alpha_t", "W/(m K)": "k_t", "J/(kg K)": "c_p", "W/(m^2 K)": "h_t", "K": "Th Th0",
    "1/Pa": "s_c beta_p",
    "1": "e mu mu_s mu_k phi theta eps nu A_p B_p n k xi N_c", "N s/m": "c_v", "1/m": "s0 kappa", "s/m": "s1",
    "m^4": "I_a", "m^2": "Ar", "W": "P_w", "m^3/s": "Q", "1/K": "al", "W/(m^2 K^4)": "sb",
}  # fmt: skip
TABLE = {
    sp.Symbol(name): Dimension.from_unit(unit, {"n": n}) for unit, names in UNITS.items() for name in names.split()
}
K, Kn, chi, E, G, p, tau, H, F, F_N, F_t, q, c, sigma = sp.symbols("K Kn chi E G p tau H F F_N F_t q c sigma")
d, R, R1, R2, dR, L, x, y, z, b_w, c_R, h_f, lam = sp.symbols("d R R1 R2 dR L x y z b_w c_R h_f lam")
v, v0, v_s, v_S, U, w_s, a, g, t, t0, A = sp.symbols("v v0 v_s v_S U w_s a g t t0 A")
m, m1, m2, m_eff, J, I_z, omega, wn, M_t, rho, eta, nu_k = sp.symbols("m m1 m2 m_eff J I_z omega wn M_t rho eta nu_k")
alpha_t, k_t, c_p, h_t, Th, Th0, s_c, beta_p, I_a, Ar = sp.symbols("alpha_t k_t c_p h_t Th Th0 s_c beta_p I_a Ar")
e, mu, mu_s, mu_k, phi, theta, eps, nu, A_p, B_p, N_c = sp.symbols("e mu mu_s mu_k phi theta eps nu A_p B_p N_c")
c_v, s0, s1, kappa, P_w, Q, al, sb = sp.symbols("c_v s0 s1 kappa P_w Q al sb")
stranger = sp.Symbol("stranger")
lift = Table("lift", (0, 1), (0, 5), ("ms", "mm"))


def written(*factors):
    """A product as written, before SymPy collapses it."""
    return sp.Mul(*factors, evaluate=False)


def dim(unit):
    return Dimension.from_unit(unit, {"n": n})


CONSISTENT = [
    # contact
    (K * d ** Rational(3, 2), "N"),
    (K * d**1.5, "N"),
    (Kn * d**n, "N"),
    (chi * d**n * v, "N"),
    (Kn * d**n * (1 + 3 * (1 - e**2) / 4 * v / v0), "N"),
    (Kn * d**n + chi * d**n * v, "N"),
    (Kn * d ** (n + 1) / (n + 1), "J"),
    (Rational(4, 3) * E * sqrt(R), "N/m^1.5"),
    (Rational(4, 3) * E * sqrt(R1 * R2 / (R1 + R2)) * d**1.5, "N"),
    (E / (1 - nu**2), "Pa"),
    (1 / ((1 - nu**2) / E + (1 - nu**2) / G), "Pa"),
    (pi / 4 * E * L * d, "N"),
    (pi / 2 * E * L * d * sqrt(d / (2 * (dR + d))), "N"),
    (q / (pi * E) * (log(4 * pi * E * dR / q) - 1), "m"),
    (F * s_c / L * (log(L**3 * dR / (F * R1 * R2 * s_c)) + 1), "m"),
    (F * s_c / L * (log(L**3 / (F * R * s_c)) + 1), "m"),
    (4 * pi * E * L * dR * exp(sp.LambertW(-sp.E * d / (4 * dR), -1)) / sp.E, "N"),
    (-sqrt(5) * log(e) / sqrt(pi**2 + log(e) ** 2) * sqrt(m_eff * K) * d ** Rational(1, 4) * v, "N"),
    (Rational(3, 2) * A * K * sqrt(d) * v, "N"),
    (2 * xi * sqrt(m * c) * v, "N"),
    (((n + 1) * m_eff * v0**2 / (2 * Kn)) ** (1 / (n + 1)), "m"),
    (dR / cos(theta), "m"),
    (Where(d > 0, K * d**1.5, 0), "N"),
    (sp.Derivative(K * d**1.5, d), "N/m"),
    (sp.Integral(Kn * d**n, (d, 0, x)), "J"),
    # friction
    (mu * F_N * tanh(v / v_s), "N"),
    (F_N * (mu_k + (mu_s - mu_k) * exp(-((v / v_S) ** 2))) + c_v * v, "N"),
    (F_N * (s0 * z + s1 * (v - s0 * sp.Abs(v) * z / mu)), "N"),
    (mu * F_N * sign(v), "N"),
    (Min(sp.Abs(F_t), mu * F_N), "N"),
    (Where(sp.Abs(v) < v_S, mu_s, mu_k) * F_N, "N"),
    (v_s * sp.atanh(tan(theta) / mu), "m/s"),
    (Max(v0, sp.Integer(0)), "m/s"),
    # mechanics
    (m * v**2 / 2 + m * g * y + c * x**2 / 2, "J"),
    (J * omega**2 / 2, "J"),
    (m * R**2 * omega, "J s"),
    (sqrt(c / m), "1/s"),
    (log(x) - log(y), "1"),  # log(x/y)
    (2 * log(x) - log(y) - log(L) + theta, "1"),
    (F * log(x) - F * log(y) + F, "N"),
    (v * (log(x * y) - 2 * log(L)) + v, "m/s"),
    (x * cos(wn * t) + v / wn * sin(wn * t), "m"),
    (exp(-xi * wn * t) * x * cos(wn * t * sqrt(1 - xi**2)), "m"),
    (atan2(y, x), "1"),
    (acos((x**2 + y**2 - L**2) / (2 * x * y)), "1"),
    (R * cos(theta) + sqrt(L**2 - R**2 * sin(theta) ** 2), "m"),
    (F * L**3 / (3 * E * I_a), "m"),
    (pi**2 * E * I_a / L**2, "N"),
    (sp.Derivative(x, t, t), "m/s^2"),
    (sp.Eq(m * a, F), "1"),
    (sp.Matrix([x, y, 0]), "m"),
    (sp.MatMul(sp.Matrix([[c, 0], [0, c]]), sp.Matrix([x, y]), evaluate=False), "N"),
    (sp.Determinant(sp.Matrix([[x, y], [y, x]])), "m^2"),
    (sp.Piecewise((x, x > y), (y, True)), "m"),
    # lubrication, fluid, heat
    (6 * eta * U * L * (R / c_R) ** 2, "N"),
    (sp.Derivative(h_f**3 / (12 * eta) * sp.Derivative(p, x), x), "m/s"),
    (eta * exp(beta_p * p), "Pa s"),
    (rho * U * L / eta, "1"),
    (p + rho * U**2 / 2 + rho * g * z, "Pa"),
    (8 * eta * L * Q / (pi * R**4), "Pa"),
    (sigma * (1 / R1 + 1 / R2), "Pa"),
    (6 * pi * eta * R * U, "N"),
    (k_t * Ar * (Th - Th0) / L, "W"),
    (h_t * Ar * (Th - Th0) + sb * Ar * (Th**4 - Th0**4), "W"),
    (x / sqrt(4 * alpha_t * t), "1"),
    (Th0 + (Th - Th0) * sp.erf(x / sqrt(4 * alpha_t * t)), "K"),
    (L * al * (Th - Th0), "m"),
    (Rational(1, 2) * m * v**2 / (rho * c_p * Ar * L), "K"),
    # zero, infinity, numbers
    (written(0, d) + v, "m/s"),
    (sp.Integral(F, (x, 0, sp.oo)), "J"),
    (sp.Integer(7), "1"),
]  # fmt: skip


@each(("expression", "unit"), CONSISTENT)
def test_consistent(expression, unit):
    assert dimension_of(expression, TABLE, CONSTANTS) == dim(unit)
    assert check(expression, TABLE, dim(unit), CONSTANTS) is None


@each(("expression", "unit"), CONSISTENT)
def test_consistent_with_nothing_else(expression, unit):
    """The check can fail: each expression is refused where a unit of one more length or temperature is expected."""
    for wrong in (dim(unit) * dim("m"), dim(unit) * dim("K")):
        fault = check(expression, TABLE, wrong, CONSTANTS)
        assert fault is not None
        assert (fault.found, fault.expected) == (str(dim(unit)), str(wrong))


# expression, smallest sub-expression that has no dimension, found, expected
INCONSISTENT = [
    # the mistakes of contact-laws.md, section 5
    ((Rational(965, 1000) * dR + B_p) * L * E / dR * d**n, "B_p + 193*dR/200", "1", "m"),  # 3
    (Rational(151, 100) * log(1000 * dR), "log(1000*dR)", "m", "1"),
    (d ** (Rational(151, 100) * dR ** Rational(-5, 1000)), "d**(151/(100*dR**(1/200)))", "1/m^0.005", "1"),
    (F * s_c / L * (log(L / (F * R * s_c)) + 1), "log(L/(F*R*s_c))", "1/m^2", "1"),  # 4
    (K * d**1.5 + chi * d**1.5 * v, "K*d**1.5 + chi*d**1.5*v", "N/m^(n-1.5)", "N"),  # 6
    ((K / v0) ** 2 * d**1.5 * v + K * d**1.5, "K**2*d**1.5*v/v0**2 + K*d**1.5", "N^2 s/m^2.5", "N"),  # 8
    (F_N * (mu_k + v_S * v), "mu_k + v*v_S", "1", "m^2/s^2"),
    (F_N * (z + s1 * v), "s1*v + z", "1", "m"),
    (F_N * mu * tanh(5 * v), "tanh(5*v)", "m/s", "1"),
    # sums, comparisons, branches
    (m * v + F, "F + m*v", "N s", "N"),
    (x + v * t + a * t, "a*t + t*v + x", "m/s", "m"),
    (x + 1, "x + 1", "1", "m"),
    (sin(theta) * (x + v) / L, "v + x", "m", "m/s"),
    (Max(x, v), "Max(v, x)", "m", "m/s"),
    (Min(F, mu), "Min(F, mu)", "1", "N"),
    (Where(d > v, K, K), "d > v", "m/s", "m"),
    (Where(d > 0, K, E), "Where(d > 0, K, E)", "Pa", "N/m^1.5"),
    (Where(sp.And(d > 0, v > 1), K, 0), "v > 1", "1", "m/s"),
    (sp.Piecewise((x, x > y), (t, True)), "Piecewise((x, x > y), (t, True))", "s", "m"),
    (sp.Piecewise((x, x > t), (y, True)), "t < x", "s", "m"),
    (sp.Eq(m * a, p), "Eq(a*m, p)", "Pa", "N"),
    (sp.Ne(x, v), "Ne(x, v)", "m", "m/s"),
    (atan2(y, v), "atan2(y, v)", "m/s", "m"),
    (sp.Mod(x, t), "Mod(x, t)", "s", "m"),
    (sp.Matrix([x, theta]), "Matrix([[x], [theta]])", "1", "m"),
    (written(0, x + v), "v + x", "m", "m/s"),  # a zero factor excuses nothing inside the product
    # functions of dimensional arguments
    (log(x) - log(t), "log(t)", "s", "1"),
    (2 * log(x) - log(y), "log(y)", "m", "1"),
    (log(x) + log(y), "log(x)", "m", "1"),
    (F * log(x) - v * log(y), "log(x)", "m", "1"),
    (log(x) - log(y) + sin(log(x)), "log(x)", "m", "1"),  # one that stands elsewhere is not excused
    (x * sin(omega), "sin(omega)", "1/s", "1"),
    (cos(x), "cos(x)", "m", "1"),
    (tan(L / v), "tan(L/v)", "s", "1"),
    (atan(y), "atan(y)", "m", "1"),
    (cosh(L * kappa * x), "cosh(L*kappa*x)", "m", "1"),
    (exp(-t / wn), "exp(-t/wn)", "s^2", "1"),
    (eta * exp(p), "exp(p)", "Pa", "1"),
    (log(Th), "log(Th)", "K", "1"),
    (log(E) - log(2), "log(E)", "Pa", "1"),
    (sp.LambertW(d), "LambertW(d)", "m", "1"),
    (sp.gamma(t), "gamma(t)", "s", "1"),
    (sp.erf(x**2 / t), "erf(x**2/t)", "m^2/s", "1"),
    # powers
    (F**d, "F**d", "m", "1"),
    (2**t, "2**t", "s", "1"),
    (x**theta, "x**theta", "m to the power theta", "a rational exponent, or one of constant parameters"),
    (x ** (n * theta), "x**(n*theta)", "m to the power n*theta", "a rational exponent, or one of constant parameters"),
    (x**pi, "x**pi", "m to the power pi", "a rational exponent, or one of constant parameters"),
    # derivatives and integrals
    (sp.Derivative(x, t) + a, "a + Derivative(x, t)", "m/s", "m/s^2"),
    (sp.Integral(F, (x, 0, t)), "Integral(F, (x, 0, t))", "s", "m"),
    # heat, fluid, tribology
    (h_t * Ar * (Th - Th0) + sb * Ar * Th**3, "Ar*Th**3*sb + Ar*h_t*(Th - Th0)", "W/K", "W"),
    (p + rho * U / 2, "U*rho/2 + p", "N s/m^3", "Pa"),
    (rho * g * z + eta * U / h_f**2, "U*eta/h_f**2 + g*rho*z", "N/m^3", "Pa"),
    # what the audit does not know
    (stranger * x, "stranger", "unknown", "a declared unit"),
    (sp.Function("f")(x), "f(x)", "unknown", "a declared unit"),
    (sp.zeta(theta), "zeta(theta)", "unknown", "a known operation"),
    (1 + sp.I, "I", "unknown", "a known operation"),
    (sp.nan, "nan", "unknown", "a known operation"),
    (sp.Sum(theta, (k, 1, 3)), "Sum(theta, (k, 1, 3))", "unknown", "a known operation"),
]  # fmt: skip


@each(("expression", "subexpression", "found", "expected"), INCONSISTENT)
def test_inconsistent(expression, subexpression, found, expected):
    with pytest.raises(DimensionError) as raised:
        dimension_of(expression, TABLE, CONSTANTS)
    fault = raised.value.fault
    assert fault.subexpression == subexpression
    # which of two is right nobody can say: the audit expects the commoner, and quotes both
    assert {fault.found, fault.expected} == {found, expected}
    assert fault.subexpression in str(raised.value)
    assert fault.found in str(raised.value)
    assert fault.reason in str(raised.value)


# expression, expected unit, sub-expression, found, exponent, repair
REPAIRED = [
    (K * d**n, "N", "K*d**n", "N m^(n-1.5)", Rational(3, 2), "K is N/m^1.5: K*d**n is a force only for n = 3/2"),
    (K * d, "N", "K*d", "N/m^0.5", Rational(3, 2), "K is N/m^1.5: K*d**n is a force only for n = 3/2, not 1"),
    (K * d**1.1, "N", "K*d**1.1", "N/m^0.4", Rational(3, 2),
     "K is N/m^1.5: K*d**n is a force only for n = 3/2, not 1.1"),
    (E * d**n, "N", "E*d**n", "N m^(n-2)", 2,
     "E is Pa: E*d**n is a force only for n = 2; multiplied by a length, for n = 1"),
    (E * d**1.5, "N", "E*d**1.5", "N/m^0.5", 2,
     "E is Pa: E*d**n is a force only for n = 2; multiplied by a length, for n = 1"),  # Bai-Zhao
    (Rational(4, 3) * E * sqrt(R) * d, "N", "4*E*sqrt(R)*d/3", "N/m^0.5", Rational(3, 2),
     "4*E*sqrt(R)/3 is N/m^1.5: 4*E*sqrt(R)*d**n/3 is a force only for n = 3/2, not 1"),
    (Rational(4, 3) * E * sqrt(d) * d, "N", "4*E*d**(3/2)/3", "N/m^0.5", 2,
     "4*E/3 is Pa: 4*E*d**n/3 is a force only for n = 2; multiplied by a length, for n = 1"),  # R dropped
    (K * d**n * (1 + v / v0), "N", "K*d**n", "N m^(n-1.5)", Rational(3, 2),
     "K is N/m^1.5: K*d**n is a force only for n = 3/2"),
    (Kn * d ** (2 * n - 1), "N", "Kn*d**(2*n - 1)", "N m^(n-1)", 1, "Kn*d**(2*n - 1) is a force only for n = 1"),
    (Kn * d ** (n + 1), "N", "Kn*d**(n + 1)", "J", None, "a factor of unit 1/m is missing"),
    (m * v, "J", "m*v", "N s", 2, "m is kg: m*v**n is an energy only for n = 2, not 1"),
    (F * v, "N", "F*v", "W", None, "a factor of unit s/m is missing"),
    (K * d**1.5 + m * g * d, "N", "d*g*m", "J", None, "a factor of unit 1/m is missing"),
    (Where(d > 0, K * d**1.5, E), "N", "Where(d > 0, K*d**1.5, E)", "Pa", None, "a factor of unit m^2 is missing"),
    (Max(F, K * d), "N", "K*d", "N/m^0.5", Rational(3, 2), "K is N/m^1.5: K*d**n is a force only for n = 3/2, not 1"),
    (x + y, "m/s", "x + y", "m", None, "a factor of unit 1/s is missing"),
    (log(L / (F * R * s_c)), "1", "log(L/(F*R*s_c))", "1/m^2", 3,
     "1/(F*R*s_c) is 1/m^3: L**n/(F*R*s_c) is dimensionless only for n = 3, not 1"),
    (log(L**k / (F * R * s_c)), "1", "log(L**k/(F*R*s_c))", "m^(k-3)", 3,
     "1/(F*R*s_c) is 1/m^3: L**k/(F*R*s_c) is dimensionless only for k = 3"),
    (tanh(5 * v), "1", "tanh(5*v)", "m/s", None,
     "a factor of unit s/m is missing; if the number 5 hides it, declare it with its unit"),
    (A_p * dR + B_p, "m", "A_p*dR + B_p", "1", None, "B_p would need the unit m"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("expression", "unit", "subexpression", "found", "exponent", "repair"),
    REPAIRED,
    ids=[str(row[0])[:60] for row in REPAIRED],
)
def test_repair(expression, unit, subexpression, found, exponent, repair):
    fault = check(expression, TABLE, dim(unit), CONSTANTS)
    assert fault is not None
    assert (fault.subexpression, fault.found, fault.expected) == (subexpression, found, unit)
    assert fault.repair == repair
    assert fault.consistent_exponent == exponent


@pytest.mark.parametrize("row", [row for row in REPAIRED if row[4] is not None], ids=lambda row: str(row[0])[:60])
def test_repaired_expression_is_consistent(row):
    """The exponent named, put in the place the sentence names, gives the expected dimension; a neighbour does not."""
    _, unit, _, _, exponent, repair = row
    sentence = repair.split(": ")[-1].split(" is ")[0]
    named = sp.sympify(sentence, locals={str(symbol): symbol for symbol in TABLE})  # a test's own text
    (name,) = named.free_symbols & {n, k}
    at = dict(TABLE) | {symbol: Dimension.from_unit("N/m^n", {"n": exponent}) for symbol in (Kn,)}
    assert dimension_of(named.subs(name, exponent), at) == dim(unit)
    assert dimension_of(named.subs(name, exponent + Rational(1, 2)), at) != dim(unit)


@pytest.mark.parametrize("mixed", [x + 1, 1 + theta + t, Min(F, mu), Where(d > 0, 1, x), sp.Matrix([1, x])], ids=str)
def test_of_two_the_number_is_the_odd_one(mixed):
    """A number beside a length is more often a hidden unit than the length is a mistake."""
    with pytest.raises(DimensionError) as raised:
        dimension_of(mixed, TABLE)
    assert (raised.value.fault.found == "1") == (mixed != 1 + theta + t)  # there the numbers are the majority


@pytest.mark.parametrize("root", [R, L, z, b_w, dR, lam], ids=str)
def test_the_bare_symbol_is_offered_an_exponent_first(root):
    """E*sqrt(R)*d: R**1 would do as well, but the factor without an exponent is the one that lacks it."""
    for product in (E * sqrt(root) * d, written(sqrt(root), d, E), written(E, d, sqrt(root))):
        assert check(product, TABLE, dim("N")).repair.startswith(f"E*sqrt({root}) is N/m^1.5: ")


def test_the_message_of_an_inconsistent_pair():
    """The content of EXAMPLES.md: both operands with their units, found, expected, the one exponent."""
    text = str(check(K * d**n, TABLE, dim("N"), CONSTANTS))
    for part in ("K*d**n", "K [N/m^1.5]", "d [m]", "expected N", "K*d**n is a force only for n = 3/2"):
        assert part in text
    assert "found N/m^0.5, expected N" in str(check(K * d, TABLE, dim("N"), CONSTANTS))


def test_symbolic_exponent_must_be_a_constant():
    assert dimension_of(Kn * d**n, TABLE, {n}) == dim("N")
    with pytest.raises(DimensionError, match="depends on n, no constant parameter"):
        dimension_of(Kn * d**n, TABLE)


def test_symbolic_exponents_are_compared_as_values():
    assert Dimension(L=(n + 1) ** 2 - n**2) == Dimension(L=2 * n + 1)
    assert Dimension(L=n / (n + 1) + 1 / (n + 1)) == dim("m")
    assert Dimension(L=1 + 1 / k) == Dimension(L=(k + 1) / k)
    assert Dimension(L=n) != Dimension(L=k)
    assert hash(Dimension(L=n * 2.0)) == hash(Dimension(L=2 * n))


def test_galin_sneddon_is_consistent_for_every_profile():
    """z = C r^k: F = 2 E (k/(k+1)) d (d/(C kappa))^(1/k), with [C] = m^(1-k)."""
    C = sp.Symbol("C")
    table = TABLE | {C: Dimension(L=1 - k)}
    force = 2 * E * k / (k + 1) * d * (d / (C * xi)) ** (1 / k)
    assert dimension_of(force, table, {k, xi}) == dim("N")
    fault = check(force, table | {C: dim("m")}, dim("N"), {k, xi})  # d/C is then a number
    assert (fault.found, fault.expected) == ("N/m", "N")


def test_float_exponents_are_the_fractions_meant():
    assert dimension_of(d ** sp.Float(1.5), TABLE) == Dimension(L=Rational(3, 2))
    assert dimension_of(d ** sp.Float(0.1), TABLE) == Dimension(L=Rational(1, 10))
    assert dimension_of(d ** (1.0 * n / 3), TABLE, {n}) == Dimension(L=n / 3)
    assert dimension_of(d ** sp.Float(1.50001), TABLE) != Dimension(L=Rational(3, 2))


def test_from_unit_asks_for_the_names_in_exponents():
    assert Dimension.from_unit("N/m^n", {"n": 1.5}) == dim("N/m^1.5")
    assert Dimension.from_unit("N/m^n", {"n": n}) == Dimension(1, 1 - n, -2)
    with pytest.raises(UnitError, match="found the exponent n"):
        Dimension.from_unit("N/m^n")


def test_zero_has_every_dimension():
    for unit in ("N", "m/s", "1", "N/m^n"):
        assert check(sp.Integer(0), TABLE, dim(unit)) is None
        assert ZERO.matches(dim(unit))
        assert dim(unit).matches(ZERO)
        assert ZERO * dim(unit) == dim(unit) * ZERO == ZERO
    assert check(sp.Integer(1), TABLE, dim("N")) is not None
    assert ZERO != ONE


FUNCTIONS_OF_NUMBERS = (sp.asin, sp.sinh, sp.asinh, sp.acosh, sp.floor, sp.ceiling)


def test_every_operation_of_the_table_is_exercised():
    """No row of the signature table is dead: the two tables above build each operation that SymPy has at least once."""
    built = {node.op for row in (*CONSISTENT, *INCONSISTENT) for node in symbolic(as_immutable(row[0])).walk()}
    untested = {op for op in SIGNATURES if op not in built}
    assert untested == {
        *(function.__name__ for function in FUNCTIONS_OF_NUMBERS),
        *("transpose", "trace", "inv", "<=", ">=", "Heaviside", "or", "not", "spline"),
        *("neg", "inverse", "sqrt", "@"),  # of texts: test_text
    }, "a row that neither the tables nor the three tests below exercise, or one they need no longer name"


def test_a_spline_has_the_unit_of_its_values_over_that_of_its_arguments():
    """Not among the tables above: the numbers of a table have units of their own, so the test by other units of measurement does not apply."""
    assert dimension_of(lift(t) + v * t, TABLE) == dim("m")
    assert dimension_of(sp.diff(lift(2 * t), t, 2), TABLE) == dim("m/s^2")
    fault = check(c * lift(x), TABLE, dim("N"))
    assert (fault.subexpression, fault.found, fault.expected) == ("lift(x)", "m", "s")
    fault = check(m * sp.diff(lift(t), t) + F, TABLE, dim("N"))
    assert (fault.subexpression, fault.found, fault.expected) == ("m*lift'(t)", "N s", "N")


@pytest.mark.parametrize("function", FUNCTIONS_OF_NUMBERS, ids=lambda f: f.__name__)
def test_functions_of_numbers(function):
    assert dimension_of(function(x / y), TABLE) == ONE
    with pytest.raises(DimensionError, match="dimensionless argument"):
        dimension_of(function(x), TABLE)


def test_matrices_comparisons_and_logic():
    square, column = sp.Matrix([[x, y], [y, x]]), sp.Matrix([x, y])
    assert dimension_of(square, TABLE) == dim("m")
    assert dimension_of(sp.Inverse(square), TABLE) == dim("1/m")
    assert dimension_of(sp.Transpose(square), TABLE) == dim("m")
    assert dimension_of(sp.Trace(square), TABLE) == dim("m")
    assert dimension_of(sp.MatAdd(column, column, evaluate=False), TABLE) == dim("m")
    with pytest.raises(DimensionError, match="operands of one unit"):
        dimension_of(sp.MatAdd(column, sp.Matrix([v, v]), evaluate=False), TABLE)
    assert dimension_of(sp.Heaviside(x), TABLE) == ONE
    assert dimension_of(sp.Or(x <= y, sp.Not(x >= L)), TABLE) == ONE
    with pytest.raises(DimensionError, match=r"x >= v|v <= x"):
        dimension_of(sp.Or(x <= y, x >= v), TABLE)


def test_declared_applied_functions():
    f = sp.Function("f")(t)
    assert dimension_of(f.diff(t, 2), TABLE | {f: dim("m")}) == dim("m/s^2")


def test_checking_a_thousand_assignments_costs_a_few_walks_of_sympy():
    symbols = sp.symbols("x0:1001")
    table = TABLE | dict.fromkeys(symbols, dim("m"))
    program = [
        symbols[i] * m * sin(theta * i) + symbols[i + 1] * m + (v**2 + g * d * i) / g * m for i in range(1000)
    ]  # fmt: skip

    def checked():
        assert all(check(expression, table, dim("kg m"), CONSTANTS) is None for expression in program)

    def walked():
        assert all(sum(1 for _ in sp.preorder_traversal(expression)) > 9 for expression in program)

    assert calls_of(checked) < 6 * calls_of(walked)  # 2.1 times, as measured


# --- Where ----------------------------------------------------------------------------------------------------------


def test_where_differentiates_branch_by_branch():
    force = Where(d > 0, K * d**2, v)
    assert force.diff(d) == Where(d > 0, 2 * K * d, 0)
    assert force.diff(v) == Where(d > 0, 0, 1)
    assert force.diff(x) == 0
    assert (x * force).diff(d) == x * Where(d > 0, 2 * K * d, 0)
    assert force.fdiff(2) == Where(d > 0, 1, 0)
    assert force.fdiff(3) == Where(d > 0, 0, 1)


def test_where_evaluates_only_when_asked():
    force = Where(d > 0, K * d**2, v)
    assert force.func is Where
    assert force.subs(d, 3).doit() == 9 * K
    assert force.subs(d, -3).doit() == v
    assert force.doit() == force
    with pytest.raises(TypeError, match="expected a comparison"):
        Where(d, 1, 2)


# --- algebra --------------------------------------------------------------------------------------------------------

RATIONALS = st.fractions(min_value=-6, max_value=6, max_denominator=8).map(
    lambda f: Rational(f.numerator, f.denominator)
)
FORMS = st.builds(lambda c, p, q: c + p * n + q * k, RATIONALS, RATIONALS, RATIONALS)
DIMENSIONS = st.builds(Dimension, RATIONALS, FORMS, RATIONALS, RATIONALS)


@settings(max_examples=30)  # symbolic exponents are SymPy's pace
@given(DIMENSIONS, DIMENSIONS, DIMENSIONS)
def test_dimensions_are_a_group(a, b, c):
    assert (a * b) * c == a * (b * c)
    assert a * b == b * a
    assert a * ONE == a
    assert a / a == ONE
    assert (a / b) * b == a


@settings(max_examples=20)
@given(DIMENSIONS, DIMENSIONS, RATIONALS, FORMS)
def test_powers_of_dimensions(a, b, r, s):
    assert (a * b) ** s == a**s * b**s
    assert a ** (r + s) == a**r * a**s
    assert (a**r) ** s == a ** (r * s)
    assert a**0 == ONE


@given(DIMENSIONS)
def test_dimension_text_reads_back(a):
    assert Dimension.from_unit(str(a), {"n": n, "k": k}) == a


@given(st.lists(st.tuples(st.sampled_from([K, E, d, v, m, t, Th, F]), RATIONALS), min_size=1, max_size=5))
def test_products_add_exponents(powers):
    """An oracle without the walk: the exponents of a monomial are the sums of its factors' exponents."""
    expression = sp.Mul(*(symbol**power for symbol, power in powers))
    total = [sum(TABLE[symbol].exponents[i] * power for symbol, power in powers) for i in range(5)]
    found = dimension_of(expression, TABLE)
    assert list(found.exponents) == total


# -- against the audit by other units of measurement ----------------------------------------------------------------------


def _numeric_rows(rows):
    """Of the table what numbers can be put in."""
    symbolic = (sp.Derivative, sp.Integral, sp.MatrixBase, sp.MatrixExpr, sp.Determinant, sp.Sum, sp.zeta)
    for row in rows:
        expression = sp.sympify(row[0])
        nodes = list(sp.preorder_traversal(expression))
        known = all(x in TABLE or x in CONSTANTS for x in expression.free_symbols)
        if (
            isinstance(expression, sp.Expr)
            and known
            and not any(isinstance(x, (*symbolic, AppliedUndef)) for x in nodes)
            and expression.is_real is not False
        ):
            yield expression, row[1]


def _table_states(expression):
    symbols = sorted({*expression.free_symbols, *CONSTANTS}, key=str)
    with mp.workdps(40):
        return [
            {q: mpf(1) / 7 * mpf(40) ** (mpf(((1 + i % 10) * j + i**2) % 11) / 11) for i, q in enumerate(symbols)}
            for j in range(11)
        ]


# What numbers cannot show: branches that are alike, or never taken (d > 0 always), a factor 0; x**pi has a power of its own, only no unit has it.
BLIND = ("Where(d > v, K, K)", "Where(d > 0, K, E)", "0*(v + x)", "I", "nan", "x**pi")


@each(("expression", "unit"), list(_numeric_rows(CONSISTENT)))
def test_both_audits_agree_on_consistent_expressions(expression, unit):
    table = TABLE | dict.fromkeys(CONSTANTS, ONE)
    assert rescale("", expression, dim(unit), table, _table_states(expression)).consistent


@each("expression", [x for x, _ in _numeric_rows(INCONSISTENT) if str(x) not in BLIND])
def test_both_audits_agree_on_inconsistent_expressions(expression):
    """Whatever unit such an expression is said to have, scaling finds that it has not."""
    table = TABLE | dict.fromkeys(CONSTANTS, ONE)
    ratios = rescale("", expression, ONE, table, _table_states(expression)).ratios
    rows = [row for name, row in ratios.items() if name != "all"]
    assert any(abs(ratio - row[0]) > ROUNDING * abs(row[0]) for row in rows for ratio in row)
