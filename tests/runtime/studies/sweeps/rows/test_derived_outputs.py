"""Derivatives as outputs of sweeps: beside differences, stored, refused by name; by regression where one run has none."""

import numpy as np
import pytest
from scipy.stats import linregress

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate, sweep
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.rows.row import Row
from hertzwerk.runtime.studies.sweeps.slope import slope_of
from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep

PEAK, HOW = "slider_pin.peak_force", {"duration": "1 ms", "tolerance": 1e-10, "compiled": False, "workers": 1}
BY = f"d({PEAK})/d(restitution)"


def test_a_derivative_is_a_column_with_its_unit_and_is_kept(crank, tmp_path):
    names = [PEAK, BY, "d(final.guide.travel)/d(guide.travel)"]
    table = sweep(crank, {"clearance": "0.2, 0.4 mm"}, outputs=names, out=tmp_path / "rows", **HOW)
    assert (table.unit(BY), table.unit(names[2])) == ("N", "m/m")
    now = crank.bind()["restitution"]
    sides = [
        sweep(crank, {"clearance": "0.2, 0.4 mm"}, parameters={"restitution": now + d}, outputs=[PEAK], **HOW)[PEAK]
        for d in (1e-4, -1e-4)
    ]
    np.testing.assert_allclose(table[BY], (sides[0] - sides[1]) / 2e-4, rtol=1e-5)
    again = sweep(crank, {"clearance": "0.2, 0.4 mm"}, outputs=names, out=tmp_path / "rows", **HOW)
    assert again[BY].tolist() == table[BY].tolist()
    assert Sweep.load(tmp_path / "rows")[BY].tolist() == table[BY].tolist()


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("d(slider_pin.peak_forc)/d(restitution)", "did you mean slider_pin.peak_force"), ("d(peak_force)/d(restitutio)", "did you mean restitution"),
        ("d(slider_pin.impact_rate)/d(restitution)", "average of a long run"), ("d(impacts)/d(restitution)", "count"),
        (f"d({BY})/d(restitution)", "a derivative of a derivative"),
    ],
)  # fmt: skip
def test_outputs_without_derivative_are_refused_before_a_run(crank, name, said):
    with pytest.raises(InputError, match=said):
        sweep(crank, {"clearance": "0.2 mm"}, outputs=[name], **HOW)


def test_methods_and_durations_that_derivatives_cannot_follow_are_refused(crank):
    with pytest.raises(InputError, match="a run by cvodes"):
        sweep(crank, {"clearance": "0.2 mm"}, outputs=[BY], method="cvodes", **HOW)
    with pytest.raises(InputError, match="changes with what derivatives"):
        sweep(crank, {"clearance": "0.2 mm"}, outputs=["d(peak_force)/d(crank_speed)"], **{**HOW, "duration": "1 rev"})


def test_an_average_beyond_the_horizon_says_so():
    """Of a chaotic double pendulum: errors of 1e-8 reach 1 % within ten seconds, see `test_lyapunov`."""
    model, name = engine_model("double_pendulum"), "d(elbow.speed.rms)/d(shoulder.angle)"
    how = {"parameters": {"elbow.angle": "2 rad"}, "outputs": [name]}
    how |= {"tolerance": 1e-8, "compiled": False, "workers": 1}
    (short,) = sweep(model, {"shoulder.angle": "2.5 rad"}, duration="2 s", **how)
    (long,) = sweep(model, {"shoulder.angle": "2.5 rad"}, duration="20 s", **how)
    assert short.outcome == "finished"
    assert np.isfinite(short[name])
    assert long.outcome == "no_derivative"
    assert np.isnan(long[name])
    assert "horizon of its derivatives" in long.message
    assert "slope(OUTPUT, NAME)" in long.message
    run = simulate(model, duration="20 s", tolerance=1e-8, initial=long.stated, compiled=False, sensitivities=["shoulder.angle"])  # fmt: skip
    assert 4 < run.sensitivities().horizon < 12


def test_a_slope_of_scattered_rows_is_within_its_interval_19_times_of_20():
    """y = 3 + 2 x - x^2 and noise: dy/dx at x = 0.25 is 1.5."""
    noise, inside = np.random.default_rng(4), 0
    for _ in range(200):
        x = noise.uniform(0, 1, 30)
        y = 3 + 2 * x - x**2 + noise.normal(0, 0.1, len(x))
        rows = tuple(
            Row(i, {"x": a}, "finished", values={"x": a}, outputs={"y": b})
            for i, (a, b) in enumerate(zip(x.tolist(), y.tolist(), strict=True))
        )
        table = Sweep("made", rows, {"x": "m", "outcome": "", "y": "N"}, ("x",), Outcome("finished", "", ""))
        result = table.slope("y", "x", at=0.25)
        inside += abs(result.value - 1.5) <= result.half_width
    assert (result.unit, result.name, result.rows) == ("N/m", "d(y)/d(x)", 30)
    assert 180 <= inside <= 198


def test_the_slope_of_few_rows_has_the_interval_of_the_textbook():
    """Of a line through six rows: Student's t of 4 degrees, 2.776445, times the standard error."""
    x, y = np.array([0, 0, 1, 1, 2, 2.0]), np.array([0.1, -0.2, 1.3, 0.8, 1.9, 2.2])
    actual, expected = slope_of("slope", "1", x, y), linregress(x, y)
    assert actual.value == pytest.approx(expected.slope, rel=1e-12)
    assert actual.half_width == pytest.approx(2.776445 * expected.stderr, rel=1e-6)
    table = Sweep("made", (), {"x": "m", "outcome": "", "y": "N"}, ("x",), Outcome("finished", "", ""))
    with pytest.raises(InputError, match="at least 5 with several"):
        table.slope("y", "x")
    with pytest.raises(InputError, match="varied number"):
        table.slope("y", "z")
