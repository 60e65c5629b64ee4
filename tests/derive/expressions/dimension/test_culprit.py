"""The message names the symbol whose unit is wrong: units seeded over the whole catalogue, one at a time, and the share that is named."""

from dataclasses import fields, replace

import pytest
import sympy as sp

from hertzwerk.derive.audit.audit import audit_law
from hertzwerk.derive.audit.audit_text import audit_expression
from hertzwerk.derive.common.units import UnitError, parse_unit
from hertzwerk.derive.exchange.user_files.law_file import audit_laws_as_written
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import GEOMETRY, STATE, Quantity

SEEDS = ("m", "1/m", "s", "kg", "1/s", "m^0.5", "1/N")


def with_unit(law, symbol, unit):
    """The law, one symbol declared in another unit."""
    other = Quantity(symbol.name, unit, symbol.meaning, symbol.limit)

    def changed(value):
        if isinstance(value, Quantity):
            return other if value == symbol else value
        if isinstance(value, sp.Basic):
            return value.xreplace({symbol: other})
        return tuple(map(changed, value)) if isinstance(value, tuple) else value

    kept = ("defined", "recommended")
    return replace(law, **{f.name: changed(getattr(law, f.name)) for f in fields(law) if f.name not in kept})


def own_symbols(law):
    return [s for s in law.symbols() if s in law.parameters or s not in (*STATE, *GEOMETRY)]


def seeded(law, seeds=SEEDS):
    """Of every wrong unit that the audit sees: symbol, unit, its findings."""
    for symbol in own_symbols(law):
        for seed in seeds:
            unit = seed if symbol.unit == "1" else f"({symbol.unit})*({seed})"
            try:
                findings = audit_law(with_unit(law, symbol, unit))
            except UnitError as error:  # an exponent of another unit, which is a fault of its own
                assert symbol.name in str(error)
                continue
            wrong = [finding for finding in findings if finding.verdict != "consistent"]
            if wrong:
                yield symbol, unit, wrong


def named(symbol, wrong):
    """Whether every finding names the symbol first, with the unit it should have."""
    given = "as a number" if symbol.unit == "1" else f"in {parse_unit(symbol.unit)}"
    return all((f.repair or "").startswith(f"{symbol.name} {given}, not ") for f in wrong)


def share(laws, seeds):
    rows = [(symbol, wrong) for law in laws for symbol, _, wrong in seeded(law, seeds)]
    return sum(named(*row) for row in rows) / len(rows), len(rows)


def test_a_wrong_unit_is_named_first_in_each_of_some_laws():
    laws = [LAWS[name] for name in ("hertz_point", "johnson", "flores", "lugre", "kuwabara_kono")]
    actual, count = share(laws, SEEDS[:2])
    assert count > 30
    assert actual == 1.0


CUBIC = """
[[law]]
name = "cubic"
kind = "stiffness"
form = "any"
source = "measured"
force = "K1*d + K3*d**3"
STORED
symbols.K1 = { unit = "UNIT1", meaning = "linear" }
symbols.K3 = { unit = "UNIT3", meaning = "cubic" }
"""
WHOLE = 'stored = "K1*d**2/2 + K3*d**4/4"'


def audited(tmp_path, unit1="N/m", unit3="N/m^3", stored=""):
    file = tmp_path / "laws.toml"
    file.write_text(CUBIC.replace("UNIT1", unit1).replace("UNIT3", unit3).replace("STORED", stored))
    return [finding for finding in audit_laws_as_written(file) if finding.verdict != "consistent"]


@pytest.mark.parametrize("stored", ["", WHOLE])
def test_a_wrong_stiffness_of_a_written_law_is_named(tmp_path, stored):
    """Without its stored energy another exponent would do as well, and is told behind."""
    cubic, linear = audited(tmp_path, unit3="N/m^2", stored=stored), audited(tmp_path, unit1="N/m^2", stored=stored)
    assert len(cubic) == len(linear) == (2 if stored else 1)
    for finding in cubic:
        assert finding.repair.startswith("K3 in N/m^3, not in N/m^2, makes ")
    for finding in linear:
        assert finding.repair.startswith("K1 in N/m, not in N/m^2, makes ")


def test_a_wrong_stored_energy_is_said_to_be_what_is_wrong(tmp_path):
    (finding,) = audited(tmp_path, stored='stored = "K1*d**2/2 + K3*d**3/4"')
    assert finding.quantity == "stored"
    assert finding.repair.startswith(
        "every other expression of the law holds, so that it is the stored that is wrong; with d**4"
    )
    assert "keep n" not in str(finding)


def test_a_single_expression_names_the_symbol_where_no_other_is_left():
    units = {"K1": "N/m", "K3": "N/m^2", "d": "m"}
    finding = audit_expression("K1*d + K3*d**3", units, {}, "N")
    assert finding.sentence.endswith(
        "K3 in N/m^3, not in N/m^2, makes it consistent; or with d**2 it is N, or with d and a factor of unit m"
    )
    assert finding.consistent_exponent == "2"
    # any of three may be wrong in E*sqrt(R)*d: the exponent is told alone
    assert audit_expression("E*sqrt(R)*d", {"E": "Pa", "R": "m", "d": "m"}, {}, "N").repair == "with d**(3/2) it is N"
