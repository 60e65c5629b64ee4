"""Minima against closed forms and against least squares of single runs; constraints, switching maxima, bad input."""

import numpy as np
import pytest
from yokes import ARM, THROW, YOKE, balanced_crank, scotch_yoke

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import load, minimise, simulate
from hertzwerk.runtime.engine.sensitivity.output_derivatives import OutputDerivatives
from hertzwerk.runtime.engine.solution.dense_output import Samples
from hertzwerk.runtime.studies.minimisation.formula import read_formula

BEARING = "bearing.reaction_x.rms**2 + bearing.reaction_y.rms**2"
FORCE = "main_bearing.reaction_x.rms**2 + main_bearing.reaction_y.rms**2"
TURN = {"duration": (2 * np.pi / 100), "tolerance": 1e-10, "compiled": False}


@pytest.fixture(scope="module")
def yoke():
    return load(scotch_yoke())


def test_a_derivative_that_is_a_tenth_too_large_is_seen(yoke, monkeypatch):
    right = OutputDerivatives.__getitem__
    monkeypatch.setattr(OutputDerivatives, "__getitem__", lambda self, name: 1.1 * right(self, name))
    best = minimise(yoke, BEARING, {"counterweight": "0.01..5 kg"}, max_runs=4, **TURN)
    assert best.checked == pytest.approx(1 - 1 / 1.1, rel=1e-3)


def test_half_of_what_reciprocates_is_balanced(yoke):
    """A harmonic force m r w^2 cos: (1 - k)^2 + k^2 of its square is least at k = 1/2."""
    best = minimise(yoke, BEARING, {"counterweight": "0.01..5 kg"}, **TURN)
    assert best.outcome.finished
    assert best["counterweight"] == pytest.approx(YOKE * THROW / (2 * ARM), rel=1e-6)
    assert best.objective == pytest.approx((YOKE * THROW * 100**2) ** 2 / 4, rel=1e-9)
    assert best.unit == "N^2"
    assert best.exact
    assert best.checked < 1e-7
    assert best.at_end == ()
    assert "finished" in str(best)


def test_a_constraint_holds_the_minimum_back(yoke):
    """Of the transverse force alone, which k m r w^2 sin is; and a range that ends before."""
    largest = 0.25 * YOKE * THROW * 100**2
    best = minimise(
        yoke, BEARING, {"counterweight": "0.01..5 kg"}, {"bearing.reaction_y.max": f"<= {largest} N"}, **TURN
    )
    assert best["counterweight"] == pytest.approx(0.25 * YOKE * THROW / ARM, rel=1e-5)
    (held,) = best.constraints
    assert held.active
    assert any("switches" in note for note in best.notes)
    ended = minimise(yoke, BEARING, {"counterweight": "0.01..1 kg"}, **TURN)
    assert ended.at_end == ("counterweight",)
    assert ended["counterweight"] == pytest.approx(1)
    lacking = minimise(yoke, BEARING, {"counterweight": "0.01..1 kg"}, {"counterweight": ">= 2 kg"}, **TURN)
    assert lacking.outcome.name == "infeasible"
    assert [one.constraints[0].state for one in (best, lacking)] == ["holds it back", "is violated"]
    assert "counterweight >= 2 kg is violated: 1 kg" in str(lacking)


def test_a_smooth_stand_in_for_the_largest_force(yoke):
    best = minimise(yoke, "bearing.reaction_x.norm32", {"counterweight": "0.01..5 kg"}, **TURN)
    assert best["counterweight"] == pytest.approx(YOKE * THROW / ARM, rel=1e-3)  # nothing is left along x
    run = simulate(yoke, parameters={"counterweight": "0.1 kg"}, **TURN)
    slope = OutputDerivatives(run, run.sensitivities("counterweight"))["bearing.reaction_x.norm32"][0]
    largest = (YOKE * THROW - 0.1 * ARM) * 100**2
    of_cosine = np.mean(np.cos(np.linspace(0, 2 * np.pi, 4097)[:-1]) ** 32) ** (1 / 32)
    assert Samples(run).highest(lambda h: np.abs(h["bearing.reaction_x"])) == pytest.approx(largest)
    assert slope == pytest.approx(-ARM * 100**2 * of_cosine, rel=1e-6)


def test_counterweight_of_a_crank_with_clearance():
    """The crank is driven, so a counterweight changes no motion: the mean square force is a parabola of its mass."""
    model = load(balanced_crank())
    how = {"duration": "3 ms", "tolerance": 1e-8, "compiled": False}
    best = minimise(model, FORCE, {"counterweight": "0.01..1 kg"}, **how)
    masses, squares = (0.1, 0.4, 0.9), []
    for mass in masses:
        run = simulate(model, parameters={"counterweight": (mass, "kg")}, **how)
        squares.append(sum(Samples(run).mean(lambda h, i=i: h[f"main_bearing.reaction_{i}"] ** 2) for i in "xy"))
    parabola = np.polynomial.Polynomial.fit(masses, squares, 2).convert().coef
    assert len(best.run.impacts) > 3
    assert best["counterweight"] == pytest.approx(-parabola[1] / (2 * parabola[2]), rel=1e-4)
    assert best.objective <= min(squares)
    assert best.checked < 1e-6


def test_a_motion_that_the_parameter_changes():
    """Through impacts: the restitution for which a ball is at a height; an output without derivatives by differences."""
    ball, how = load("bouncing_ball"), {"duration": "0.7 s", "tolerance": 1e-9, "compiled": False}
    wanted = simulate(ball, parameters={"restitution": 0.7}, **how).engine.final["vertical.travel"]
    best = minimise(
        ball, "restitution", {"restitution": "0.3..0.95"}, {"final.vertical.travel": f"= {wanted} m"}, **how
    )
    assert best["restitution"] == pytest.approx(0.7, rel=1e-5)
    counted = minimise(ball, "abs(final.vertical.travel - drop_height) + 0*floor.impacts*drop_height",
                       {"drop_height": "0.9..1.1 m"}, precision=1e-3, **how)  # fmt: skip
    assert not counted.exact
    assert "count" in counted.notes[0]


def test_a_formula_is_read_and_never_executed(yoke):
    for bad, why in (
        ("__import__('os')", "expected"), ("bearing.reaction_x.rms + counterweight", "N"), ("bearing.reaction_x.rms.real()", "bearing"),
        ("2", "name of an output"), ("bearing.reaction_z9.rms", "sweep output"), (3, "formula"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=why):
            minimise(yoke, bad, {"counterweight": "0.01..5 kg"}, **TURN)
    faults = []
    assert read_formula("objective", "x.a - 2 ms", {"x.a": "m"}, faults) is None
    assert "2 ms" in str(faults[0]) and "quantity__" not in str(faults[0])
    with pytest.raises(InputError) as caught:
        over = {"counterweight": "-1..5 kg", "throw": "1..2 s", "nothing": "1..2", "speed": "1, 2 rad/s"}
        constraints = {"bearing.reaction_x.max": "5 N", "bearing.reaction_y.max": "<= 5 m"}
        how = {"start": {"arm": "1 m", "counterweight": "9 kg"}, "parameters": {"counterweight": "1 kg"}}
        minimise(yoke, BEARING, over, constraints, **how, duration="1 m", precision=0)
    text = str(caught.value)
    for place in ("over['counterweight']", "over['throw']", "nothing", "over['speed']", "constraints['bearing.reaction_x.max']",
                  "constraints['bearing.reaction_y.max']", "start['arm']", "duration", "precision"):  # fmt: skip
        assert place in text


@pytest.mark.parametrize(("text", "unit", "value", "slope"), [
    ("(x.a - 300 mm)**2", "m^2", 0.2**2, 2 * 0.2),
    ("x.a/2 mm + 1", "", 251, 500),
    ("3 kN/m*x.a", "N", 1500, 3000),
    ("1e3 N m*x.b/x.a - 2 N*1 s^0.5*x.b/1 s^0.5", "N", 7992, -16000),
    ("sin(7.5 deg*x.b)*x.a*2 mm^2", "m^3", 0.5e-6, 1e-6),
])  # fmt: skip
def test_a_formula_has_quantities_with_their_units(text, unit, value, slope):
    """By hand at x.a = 0.5 m, x.b = 4; the slope is that over x.a."""
    faults = []
    formula = read_formula("objective", text, {"x.a": "m", "x.b": ""}, faults)
    assert faults == []
    at = {"x.a": 0.5, "x.b": 4.0}
    assert formula.unit == unit
    assert formula(at) == pytest.approx(value, rel=1e-12, abs=1e-18)
    assert formula.gradient(at)[formula.names.index("x.a")] == pytest.approx(slope, rel=1e-12, abs=1e-18)


def test_several_starts_find_the_lower_of_two_minima():
    """(e - 0.4)^2 (e - 0.8)^2 + e/200 has its minima at the roots of its derivative; the start lies by the higher one."""
    ball, how = load("bouncing_ball"), {"duration": "1 ms", "tolerance": 1e-6, "compiled": False, "precision": 1e-9}
    text, over = "(restitution - 0.4)**2 * (restitution - 0.8)**2 + restitution/200", {"restitution": "0.2..0.95"}
    e = np.polynomial.Polynomial([0, 1])
    well = (e - 0.4) ** 2 * (e - 0.8) ** 2 + e / 200
    low, _, high = sorted(well.deriv().roots().real)
    alone = minimise(ball, text, over, start={"restitution": 0.79}, **how)
    assert alone["restitution"] == pytest.approx(high, abs=1e-3)
    assert len(alone.searches) == 1
    best = minimise(ball, text, over, start={"restitution": 0.79}, starts=4, **how)
    assert best["restitution"] == pytest.approx(low, abs=1e-3)
    assert best.begun == alone.begun
    ends = [search.values["restitution"] for search in best.searches]
    here = [search.here for search in best.searches]
    assert here == [abs(end - low) < 0.01 for end in ends]
    assert 0 < sum(here) < 5
    assert f"{sum(here)} of 5 starts ended in this minimum" in str(best)
    assert "several minima" in str(best)
    assert f"{well(high):.6g}" in str(best)
