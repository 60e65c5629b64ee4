"""Sweeps: rows are the single runs bitwise, outputs what is found from those by hand, faults all at once."""

import math

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate, sweep
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Needs, known

BALL = {"duration": "2 s", "tolerance": 1e-9}
CRANK = {"duration": "240 ms", "tolerance": 1e-6}


@pytest.mark.parametrize("workers", [1, 2])
def test_rows_are_the_single_runs_bitwise(ball, workers):
    over = {"drop_height": "0.5..1.5 m:3", "mass": "0.05, 0.1 kg"}
    table = sweep(ball, over, parameters={"radius": "25 mm"}, workers=workers, compiled=False, **BALL)
    assert table.outcome.name == "finished"
    assert [row.index for row in table] == list(range(6))
    assert list(table["drop_height"]) == [0.5, 0.5, 1, 1, 1.5, 1.5]
    for row in table:
        run = simulate(ball, parameters={**row.stated}, compiled=False, **BALL)
        assert row.final == run.engine.final
        assert row.stated["radius"] == (25.0, "mm")


def test_a_variation_may_be_named(ball):
    over = {"drop_height": "0.5 m"}
    varied = sweep("bouncing_ball", over, laws={"floor": "hunt_crossley"}, workers=1, compiled=False, **BALL)
    plain = sweep(ball, over, workers=1, compiled=False, **BALL)
    assert varied["final.vertical.travel"] != plain["final.vertical.travel"]
    again = sweep(ball, over, laws={"floor": "hunt_crossley"}, workers=1, compiled=False, **BALL)
    assert varied["final.vertical.travel"] == again["final.vertical.travel"]


def test_columns_are_in_si_and_say_so(crank):
    table = sweep(
        crank, {"clearance": "0.2 mm", "crank_speed": "3000 rpm"}, duration="1 ms", tolerance=1e-6, outputs=["steps"]
    )
    assert (table["clearance"][0], table.unit("clearance")) == (0.2e-3, "m")
    assert (table["crank_speed"][0], table.unit("crank_speed")) == (pytest.approx(100 * math.pi, rel=1e-15), "rad/s")
    assert table.names == ("clearance", "crank_speed", "outcome", "steps", "message", "warnings")


def test_outputs_of_contacts_are_those_of_the_impacts(crank):
    names = ("impacts", "peak_force", "slider_pin.impacts", "slider_pin.peak_force", "slider_pin.max_penetration")
    (row,) = sweep(crank, {"clearance": "0.2 mm"}, outputs=names, compiled=False, workers=1, **CRANK)
    run = simulate(crank, parameters={"clearance": "0.2 mm"}, compiled=False, **CRANK)
    forces = [impact.peak_force for impact in run.impacts]
    assert row.outputs == {
        "impacts": len(forces), "peak_force": max(forces), "slider_pin.impacts": len(forces), "slider_pin.peak_force": max(forces),
        "slider_pin.max_penetration": max(impact.peak_penetration for impact in run.impacts),
    }  # fmt: skip


def test_statistics_have_the_interval_of_the_run(crank):
    pairs = {"impact_rate": "impact_rate", "mean_force": "normal_force", "mean_peak_force": "peak_force"}
    pairs = {f"slider_pin.{name}": f"slider_pin.{other}" for name, other in pairs.items()}
    pairs["slider_pin.dissipated_power"] = "slider_pin.dissipated_power"
    (row,) = sweep(crank, {"clearance": "0.5 mm"}, outputs=[*pairs], compiled=False, workers=1, **CRANK)
    run = simulate(crank, parameters={"clearance": "0.5 mm"}, compiled=False, **CRANK)
    found = {average.name: average for average in run.averages()}
    for name, other in pairs.items():
        mean, half_width = found[other].mean, found[other].half_width
        assert row[name] == mean
        np.testing.assert_equal(row[f"{name}.half_width"], math.nan if half_width is None else half_width)
    assert row["slider_pin.impact_rate.half_width"] > 0
    assert row["slider_pin.mean_force.half_width"] > 0


def test_impulse_and_work_obey_the_balances_of_momentum_and_energy(ball):
    """A ball that rests in the end: the floor's impulse is the weight's, what it dissipates the energy of the fall."""
    names = ["floor.impulse", "floor.dissipated", "final.vertical.speed"]
    how = {"parameters": {"drop_height": "0.2 m"}, "duration": "3 s", "tolerance": 1e-9, "workers": 1}
    (row,) = sweep(ball, {"restitution": "0.3"}, outputs=names, **how)
    weight = ball.bind()["mass"] * ball.bind()["gravity"]
    assert row["floor.impulse"] == pytest.approx(3 * weight, rel=1e-6)
    assert row["floor.dissipated"] == pytest.approx(0.2 * weight, rel=1e-3)


def test_reducers_of_a_history_have_their_closed_forms():
    """A ball thrown up that flies freely: a parabola."""
    ball, speed, gravity, seconds = engine_model("bouncing_ball"), 3.0, 9.81, 0.5
    names = [f"vertical.travel.{kind}" for kind in ("max", "min", "mean", "rms", "peak_to_peak")]
    start = {"vertical.travel": "10 m", "gravity": "9.81 m/s^2"}
    (row,) = sweep(
        ball, {"vertical.speed": "3 m/s"}, parameters=start, outputs=names, duration=seconds, tolerance=1e-10, workers=1
    )
    path = np.polynomial.Polynomial([10, speed, -gravity / 2])
    largest, last = path(speed / gravity), path(seconds)
    mean, square = (float(power.integ()(seconds)) / seconds for power in (path, path * path))
    low = min(10.0, last)
    assert [row[name] for name in names] == pytest.approx(
        [largest, low, mean, math.sqrt(square), largest - low], rel=1e-10
    )


def test_every_output_that_is_offered_can_be_had_and_says_what_it_needs(crank):
    names = list(known(crank))
    (row,) = sweep(crank, {"clearance": "0.5 mm"}, outputs=names, duration="60 ms", tolerance=1e-5, workers=1)
    assert row.outcome == "finished"
    assert set(row.outputs) == {name for output in known(crank).values() for name in output.columns}
    nothing = {name for name, value in row.outputs.items() if math.isnan(value)}
    assert nothing == {"error", *(name for name in row.outputs if name.endswith(".half_width"))}  # five revolutions
    outputs = known(crank)
    assert outputs["final.guide.travel"].needs == outputs["slider_pin.dissipated"].needs == Needs.ENDS
    assert outputs["slider_pin.peak_force"].needs == Needs.IMPACTS
    assert outputs["energy_residual"].needs == Needs.ENDS
    assert outputs["slider_pin.impact_rate"].needs == Needs.IMPACTS
    assert outputs["slider_pin.mean_force"].needs == Needs.SUMS
    assert outputs["guide.travel.max"].needs == Needs.STEPS


def test_every_fault_comes_at_once(ball):
    with pytest.raises(InputError) as caught:
        how = {"parameters": {"mass": "1 kg", "radios": "1 m"}, "duration": "2 kg", "tolerance": 2, "workers": 0}
        how |= {"outputs": ["floor.peak", 3, "impacts", "impacts"], "functions": {"steps": 3, "mass": len}}
        sweep(ball, {"drop_hight": "1..2 m:3", "mass": "1..2 m"}, **how)
    places = [fault.where for fault in caught.value.faults]
    assert places == [
        *("over['mass']", "drop_hight", "radios", "mass", "3", "floor.peak", "outputs"),
        *("functions['steps']", "functions['mass']", "workers", "tolerance", "duration"),
    ]
    assert "did you mean floor.peak_force" in str(caught.value)
