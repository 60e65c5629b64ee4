"""The catalogue and its audits: stated verdicts, the nine published mistakes, and the two audits against each other."""

from dataclasses import fields, replace

import pytest
import sympy as sp
from each import each
from mpmath import mp, mpf
from rescaling import SCALINGS, rescale_law, states_of

import hertzwerk.derive as hd
from hertzwerk.derive.audit.audit import audit_law, verdict
from hertzwerk.derive.audit.numeric import STATES
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.dimension.dimension import Dimension, DimensionError
from hertzwerk.derive.expressions.dimension.walker import dimension_of
from hertzwerk.derive.laws import LAWS, johnson, pereira_internal_si
from hertzwerk.derive.laws.formulas.damping import e
from hertzwerk.derive.laws.formulas.line import l_ref, p_ref
from hertzwerk.derive.laws.law import FORMS, DampingLaw, F, FrictionLaw, L, N, Quantity, StiffnessLaw, d, s, v, v0, z

WRONG = {
    "goldsmith": "inconsistent", "lankarani_nikravesh_cylinders": "inconsistent", "liu": "inconsistent",
    "bai_zhao": "inconsistent", "palmgren": "outside_si", "pereira_internal": "outside_si",
    "pereira_external": "outside_si",
}  # fmt: skip
CONSISTENT = [name for name in LAWS if name not in WRONG]


# -- records -----------------------------------------------------------------------------------------------------------


@each("name", LAWS)
def test_record_is_complete(name):
    law = LAWS[name]
    assert law.name == name
    assert law.title and law.source
    assert law.grade in ("A", "B", "C", "R")
    assert (law.grade == "R") == ("reconstruction" in law.title) == name.startswith("wang_liu")
    assert bool(law.fitted_in) == (law.verdict == "outside_si")
    assert all(q.meaning and parse_unit(q.unit) for q in law.symbols())
    if law.verdict != "consistent":
        assert LAWS[law.repair].verdict == "consistent"
    if isinstance(law, DampingLaw):
        assert (v0 in law.quantities) == (v0 in law.memory)
        assert law.release in ("force", "gap")
        assert (law.factor is None) != (law.term is None)
        assert (law.defined is None) == (e not in law.parameters)
    if isinstance(law, FrictionLaw):
        assert bool(law.modes) == (law.holding is not None)


def test_names_do_not_collide_within_a_law():
    for law in LAWS.values():
        names = [q.name for q in law.symbols()]
        assert len(names) == len(set(names)), law.name


# -- the audit of every law --------------------------------------------------------------------------------------------


@pytest.mark.by_turns(6)
@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.exhaustive] * (name == "jackson_green")) for name in CONSISTENT],  # seconds
)
def test_a_consistent_law_is_refused_with_another_unit(name):
    """The audit can fail: with the unit of one symbol multiplied by a length, no law passes."""
    law = LAWS[name]
    for symbol in law.parameters:
        if symbol.unit == "1" or symbol == p_ref:
            continue  # exponents and pure numbers; Pereira's reference pressure cancels
        stretched = Quantity(symbol.name, f"({symbol.unit}) m", symbol.meaning)
        change = {symbol: stretched}
        changed = replace(
            law, parameters=tuple(change.get(q, q) for q in law.parameters), definitions=tuple((q, x.xreplace(change)) for q, x in law.definitions),
            **{f.name: getattr(law, f.name).xreplace(change) for f in fields(law) if f.init and isinstance(getattr(law, f.name), sp.Basic)},
        )  # fmt: skip
        assert verdict(audit_law(changed)) == "inconsistent", symbol


def own(name="own", **given):
    """A user's law; parameters are what its expressions contain beyond what a contact supplies."""
    kind = {"force": StiffnessLaw, "term": DampingLaw}.get(next(iter(given)), FrictionLaw)
    state = {d, v, v0, F, N, s, z, L}
    body = given.get("friction", next(iter(given.values())))
    if "friction" in given:
        given = {"force": body, **{k: x for k, x in given.items() if k != "friction"}}
    symbols = [q for q in sp.preorder_traversal(body) if isinstance(q, Quantity) and q not in state]
    if kind is StiffnessLaw:
        given["forms"] = FORMS
    return kind(name=name, title="own", parameters=tuple(dict.fromkeys(symbols)), source="test", grade="C", **given)


E = Quantity("E", "Pa", "modulus")
K = Quantity("K", "N/m^1.5", "stiffness")
chi = Quantity("chi", "N s/m^2.5", "damping of a law with n = 3/2")
mu = Quantity("mu", "1", "friction")
v_S = Quantity("v_S", "m/s", "Stribeck speed")
s_0 = Quantity("s_0", "1/m", "bristle stiffness")
s_1 = Quantity("s_1", "s/m", "bristle damping")
pure_z = Quantity("z", "1", "bristle, called dimensionless")
_pereira = pereira_internal_si

# contact-laws.md, section 5: law, sub-expression as written, found, expected, exponent that would do
MISTAKES = {
    "1 Bai-Zhao, n = 3/2": (LAWS["bai_zhao"], "sqrt(2)*pi*E_eff*d**(3/2)*sqrt(d/(d + dR)**3)*(2*d + 3*dR)/8", "N/m^0.5", "N", None),
    "2 Hertz with a fitted n": (LAWS["lankarani_nikravesh_cylinders"], "K*d**n", "N m^(n-1.5)", "N", "3/2"),
    "3 Pereira, length plus number": (LAWS["pereira_internal"], "a*dR + b", "1", "m", None),
    "3 Pereira, length plus number, outside": (LAWS["pereira_external"], "a*dR + b", "1", "m", None),
    "3 Pereira, logarithm of a length": (LAWS["pereira_internal"], "log(1000*dR)", "m", "1", None),
    "3 Pereira, power of a length": (LAWS["pereira_internal"], "Y/dR**(1/200)", "1/m^0.005", "1", None),
    "4 Goldsmith, m = 1": (LAWS["goldsmith"], "log(L/(F*R_eff*sigma))", "1/m^2", "1", "3"),
    "5 Liu without a length": (LAWS["liu"], "pi*E_eff*d*sqrt(d/(2*d + 2*dR))/2", "N/m", "N", None),
    "6 damping factor of another n": (own(term=chi * d * v), "chi*d*v", "N/m^0.5", "N", "3/2"),
    "7 radius dropped": (own(force=sp.Rational(4, 3) * E * sp.sqrt(d) * d), "4*E*d**(3/2)/3", "N/m^0.5", "N", "2"),
    "8 Lee-Wang, (K/v0)^2": (
        own(term=sp.Rational(3, 4) * (1 - e) * (K / v0) ** 2 * d ** sp.Rational(3, 2) * v),
        "K**2*d**(3/2)*v/v0**2", "N^2 s/m^2.5", "N", None,
    ),
    "8 Pereira, L twice": (
        replace(_pereira, name="twice", force=_pereira.force * L, stored=None),
        "E_eff*L**2*l_ref**2*(d/l_ref)**n/dR", "J", "N", "1",
    ),
    "8 Stribeck speed as viscous coefficient": (
        own(friction=mu * N * sp.tanh(s / v_S) + v_S * s, slope=mu * N / v_S), "s*v_S", "m^2/s^2", "N", None,
    ),
    "8 LuGre's z dimensionless": (own(friction=N * (s_0 * pure_z + s_1 * s), slope=N * s_1), "s_0*z", "1/m", "1", None),
    "8 LuGre's z dimensionless, its rate": (
        own(friction=mu * N * sp.tanh(s / v_S), slope=mu * N / v_S, memory=((pure_z, s - s_0 * sp.Abs(s) * pure_z, mu),)),
        "s - s_0*z*Abs(s)", "m/s", "1/s", None,
    ),
}  # fmt: skip


@each("name", MISTAKES)
def test_published_mistake(name):
    law, subexpression, actual, expected, exponent = MISTAKES[name]
    findings = [f for f in audit_law(law) if f.subexpression == subexpression]
    assert findings, [f.subexpression for f in audit_law(law)]
    finding = findings[0]
    assert finding.verdict == ("outside_si" if law.fitted_in else "inconsistent")
    assert (finding.found, finding.expected) == (actual, expected)
    assert finding.consistent_exponent == exponent


# -- both audits -------------------------------------------------------------------------------------------------------


@each("name", LAWS)
def test_both_audits_agree(name):
    """Expression by expression; for a monomial fault the factor is the one the found unit predicts."""
    law = LAWS[name]
    findings, rescaled = audit_law(law), rescale_law(law)
    names = {q.name: q for q in law.parameters if q.unit == "1"}
    table = {q: Dimension.from_unit(q.unit, names) for q in law.symbols()}
    constants = [q for q in table if q.unit == "1"]
    rows = [*((x, q.unit) for q, x in law.definitions), *((x, unit) for _, x, unit in law.expressions())]
    for finding, numbers, (expression, unit) in zip(findings, rescaled, rows, strict=True):
        assert (finding.verdict == "consistent") == numbers.consistent, finding
        assert len(numbers.states) == STATES >= 5
        if numbers.consistent:
            continue
        try:
            excess = dimension_of(expression, table, constants) / Dimension.from_unit(unit, names)
        except DimensionError:
            assert any(abs(ratio - 1) > 1e-3 for row in numbers.ratios.values() for ratio in row)
            assert numbers.excess is None  # depends on the state
        else:
            assert_predicted(numbers, excess)


def assert_predicted(rescaled, excess):
    """Each ratio is the product of the scales to the powers by which the unit is wrong."""
    with mp.workdps(30):
        for name, row in rescaled.ratios.items():
            for state, ratio in zip(rescaled.states, row, strict=True):
                powers = [
                    mpf(str(sp.N(x.subs({q: sp.Float(str(state[q]), 30) for q in x.free_symbols}), 30)))
                    for x in excess.exponents
                ]
                predicted = mp.fprod(mpf(f) ** p for f, p in zip(SCALINGS[name], powers, strict=True))
                assert abs(ratio / predicted - 1) < mpf(10) ** -12


@each(
    ("name", "what", "excess"),
    [
        ("liu", "normal force", (0, -1, 0, 0, 0)),
        ("bai_zhao", "normal force", (0, -0.5, 0, 0, 0)),
        ("goldsmith", "definition of B", (0, -2, 0, 0, 0)),
        ("palmgren", "normal force", (-1, 1, 2, 0, 0)),
        ("pereira_internal", "definition of n", (0, -0.005, 0, 0, 0)),
    ],
)
def test_rescaling_reads_off_the_wrong_power(name, what, excess):
    (row,) = (row for row in rescale_law(LAWS[name]) if row.what == what)
    assert row.excess == pytest.approx(excess, abs=1e-12)


def test_states_span_every_branch():
    """Both sides of each choice are among the states, and both signs of a rate."""
    for name in ("ambrosio", "bengisu_akay", "pereira_internal_si", "jankowski", "threlfall"):
        law = LAWS[name]
        names = {q.name: q for q in law.parameters if q.unit == "1"}
        states = list(states_of(law, {q: Dimension.from_unit(q.unit, names) for q in law.symbols()}))
        conditions = {x.args[0] for x in _nodes(law) if type(x).__name__ == "Where"}
        conditions |= {x.args[0] < x.args[1] for x in _nodes(law) if isinstance(x, sp.Min)}
        assert conditions
        for condition in conditions:
            outcomes = {bool(condition.subs({q: sp.Float(str(x)) for q, x in state.items()})) for state in states}
            assert outcomes == {True, False}, (name, condition)


def _nodes(law):
    texts = [*(x for _, x in law.definitions), *(x for _, x, _ in law.expressions())]
    return [node for text in texts for node in sp.preorder_traversal(text)]


def test_states_stay_within_reach():
    law = johnson
    states = list(states_of(law, {q: Dimension.from_unit(q.unit) for q in law.symbols()}))
    assert all(state[d] > 0 for state in states)
    assert len({state[d] for state in states}) == STATES


# -- binding -----------------------------------------------------------------------------------------------------------

STEEL = hd.Material(hd.Parameter("E_s", "GPa", 207), hd.Parameter("nu_s", "1", 0.3))
PIN = hd.Body("pin", mass=hd.Parameter("pin_mass", "kg", 0.2))
SLIDE = hd.Prismatic("slide", hd.GROUND, PIN, axis=hd.X)
RADIUS = hd.Parameter("bush_radius", "mm", 10)
CLEARANCE = hd.Parameter("clearance", "mm", 0.5)
LENGTH = hd.Parameter("joint_length", "mm", 15)
SPEED = hd.Parameter("pace", "m/s", 0.5)
JOURNAL = hd.PinInBush("joint", PIN.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Z, RADIUS, CLEARANCE, length=LENGTH)
ROLLERS = hd.ParallelCylinders("joint", PIN.at(0, 0, 0), hd.GROUND.at(3 * RADIUS, 0, 0), RADIUS, RADIUS, hd.Z, LENGTH)


def scene(pair, stiffness, damping=None, friction=None, unchecked=False):
    effects = [hd.Contact("joint", stiffness, damping, unchecked=unchecked)]
    effects += [hd.Friction("drag", "joint", friction)] if friction else []
    return hd.Scene(
        hd.Mechanism("impact", (SLIDE,), (pair,)), (*effects, hd.EnergyLedger()), hd.Scales(length=CLEARANCE, speed=SPEED),
        hd.Start(speed={"slide": SPEED}),
    )  # fmt: skip


def refused(*arguments, **given):
    with pytest.raises(hd.InputError) as raised:
        scene(*arguments, **given)
    return str(raised.value)


def test_a_law_with_modes_knows_no_speed():
    with pytest.raises(ValueError, match="functions of N alone"):
        replace(LAWS["coulomb"], force=mu * N * sp.sign(s) + v_S * s)
    with pytest.raises(ValueError, match="functions of N alone"):
        replace(LAWS["coulomb"], holding=None)


def test_laws_for_another_pair_or_clearance_are_refused():
    text = refused(JOURNAL, LAWS["pereira_external_si"](STEEL, STEEL))
    assert "pereira_external_si at a pin_in_bush pair" in text and "parallel_cylinders" in text
    assert "pin_in_bush" in refused(ROLLERS, LAWS["wang_liu_internal"](STEEL, STEEL))
    scene(ROLLERS, LAWS["wang_liu_external"](STEEL, STEEL))
    wide = replace(JOURNAL, clearance=hd.Parameter("thin_film", "um", 3))
    text = refused(wide, pereira_internal_si(STEEL, STEEL))
    assert "for pereira_internal_si" in text and "[5e-06, 0.01]" in text


def test_reference_quantities_have_their_values():
    """The fit's own units come with the law, named, and cannot be given another value."""
    bound = pereira_internal_si(STEEL, STEEL)
    values = {q.name: value for q, value in bound.binding.items()}
    assert (values["l_ref"].unit, values["l_ref"].default, values["p_ref"].unit) == ("mm", 1, "MPa")
    text = hd.generate(scene(JOURNAL, bound))
    assert '("reference_length", "mm", 1, ' in text
    wrong = pereira_internal_si(STEEL, STEEL, l_ref=hd.Parameter("reference_length", "mm", 2), p_ref=values["p_ref"])
    assert "reference length" in refused(JOURNAL, wrong)
    assert {q for q, _ in pereira_internal_si.defaults} == {l_ref, p_ref}
