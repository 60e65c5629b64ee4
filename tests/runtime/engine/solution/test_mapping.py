"""A run and its histories are mappings from names to arrays, in units of one's own too."""

from fractions import Fraction

import numpy as np
import pint
import pytest
import sympy as sp

from hertzwerk.derive import Parameter
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Model, Normal, equilibrium, load, modes, simulate, sweep

BALL = load("bouncing_ball")
SHORT = {"duration": "0.1 s", "tolerance": 1e-6}
UNITS = pint.UnitRegistry()


@pytest.fixture(scope="module")
def run():
    return simulate(BALL, **SHORT, sensitivities=["mass"])


def test_a_run_is_a_mapping_from_names_to_arrays_and_compares_by_identity(run):
    for each in (run, run.engine.history, run.at([0.05, 0.06])):
        assert list(each) == list(each.keys()) == [name for name, _ in each.items()]
        assert len(each) == len(list(each)) == len(dict(each)) == len(list(each.values()))
        assert "vertical.travel" in each
        assert "t" in each
        assert "t" not in list(each)
        assert all(name not in each for name in ("vertical.travle", 3, None, ("vertical.travel", "mm")))
        assert each.get("no such name") is None
        assert np.array_equal(dict(each)["vertical.travel"], each["vertical.travel"])
    again = simulate(BALL, **SHORT)
    assert run == run
    assert run != again
    assert len({run, again, run}) == 2
    listed, named = run.plot(["vertical.travel", "floor.gap"]), run.plot("vertical.travel", "floor.gap")
    assert [axis.get_ylabel() for axis in listed.axes] == [axis.get_ylabel() for axis in named.axes]
    assert len(listed.axes) == 2


@pytest.mark.parametrize("key", [0, None, slice(3), ["vertical.travel"], ("a", "b", "c"), ("vertical.travel", 3), 1.5])
def test_an_unknown_name_lists_those_that_exist(run, key):
    for request in (
        lambda: run[key], lambda: run.engine.history[key], lambda: run.plot(*(key if isinstance(key, list) else (key,)), 0),
    ):  # fmt: skip
        with pytest.raises(KeyError, match=r"no history .*there are t, vertical\.travel"):
            request()


def test_a_history_in_a_unit_of_ones_own(run):
    assert run.units["vertical.travel"] == "m"
    assert np.array_equal(run["vertical.travel", "mm"], run["vertical.travel"] / 1e-3)
    assert np.array_equal(run["vertical.speed", "km/h"], run["vertical.speed"] / (1000 / 3600))
    for unit in ("kg", "no_unit", "vertical.speed"):
        with pytest.raises(InputError, match=rf"vertical.travel in {unit}"):
            run["vertical.travel", unit]


def test_one_time_is_a_time(run):
    for time in (0.05, "50 ms", (50, "ms"), 50 * UNITS.ms, np.float64(0.05)):
        there = run.at(time)
        assert there.t == [0.05]
        assert there["vertical.travel"].shape == (1,)
    assert run.at([1, 2] * UNITS.ms).t == pytest.approx([1e-3, 2e-3], abs=0)
    for time in ("1 kg", "soon", [None, "x"], object()):
        with pytest.raises(InputError, match="times"):
            run.at(time)
    for time in (7.0, None):
        with pytest.raises(ValueError, match="outside the run"):
            run.at(time)


class Unit:
    """As a unit of astropy shows itself."""

    def __init__(self, scale: float, **powers: float) -> None:
        self.scale, self.bases, self.powers = scale, list(powers), list(powers.values())


class Quantity:
    def __init__(self, value: float, unit: Unit) -> None:
        self.value, self.unit = value, unit


@pytest.mark.parametrize(
    ("stiffness", "text"),
    [
        (2 * UNITS("GN/m^1.5"), "2 GN/m^1.5"),
        (Quantity(2.0, Unit(1e6, kN=1, m=-1.5)), "2 GN/m^1.5"),
        (2.0e9 * UNITS.newton / UNITS.m**1.5, "2 GN/m^1.5"),
    ],
)
def test_quantities_are_values_with_units(stiffness, text):
    given = {"stiffness": stiffness, "drop_height": 4 * UNITS.cm, "restitution": 0.5 * UNITS.dimensionless}
    run = simulate(BALL, duration=100 * UNITS.ms, tolerance=1e-6, parameters=given)
    plain = {"stiffness": text, "drop_height": "4 cm", "restitution": 0.5}
    other = simulate(BALL, **SHORT, parameters=plain)
    assert run.engine.t_end == 0.1
    assert run.impacts and run.engine.final == pytest.approx(other.engine.final, rel=1e-12)
    with pytest.raises(InputError, match=r"drop_height: found .*which is kg"):
        simulate(BALL, **SHORT, parameters={"drop_height": 1 * UNITS.kg})
    table = sweep(BALL, {"drop_height": [0.4 * UNITS.m, 500 * UNITS.mm]}, **SHORT, workers=1)
    assert table["drop_height"] == pytest.approx([0.4, 0.5], rel=1e-15)


def test_no_picture_of_an_object_is_its_address(run):
    things = [
        *(run, run.engine.history, run.at(0.05), run.sensitivities(), run.impacts, run.statistics, run.outcome),
        *(run.engine.findings, run.engine.model, Model(run.engine.model).histories, run.engine.model.bind()),
        run.averages(),
        *(equilibrium(BALL), modes(BALL), Normal("1 m", "1 mm"), sweep(BALL, {"mass": ["1 kg"]}, **SHORT, workers=1)),
    ]
    assert [repr(thing) for thing in things if " at 0x" in repr(thing)] == []


@pytest.mark.parametrize("value", [np.float64(0.5), np.float32(0.5), np.int64(2), Fraction(1, 2), sp.Rational(1, 2)])
def test_numbers_of_every_kind_are_numbers_of_a_parameter(value):
    parameter = Parameter("mass", "kg", value)
    assert list(parameter.faults()) == []
    assert type(parameter.default) in (int, float)
    assert parameter == Parameter("mass", "kg", int(value) if value == 2 else 0.5)
