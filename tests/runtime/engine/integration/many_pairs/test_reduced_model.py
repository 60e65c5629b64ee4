"""Reduced models: bounds by intervals, and runs of the near pairs against runs that evaluate every pair."""

import math

import casadi as ca
import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, power
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.loop import reduced_rows, reduced_runs
from hertzwerk.runtime.engine.integration.many_pairs import reduced_model
from hertzwerk.runtime.engine.integration.many_pairs.interval_arithmetic import interval_extension
from reference import scenes

WALLS = 18
OPTIONS = {"duration": "1 s", "tolerance": 1e-8, "method": "dop853", "compiled": False}


def test_bounds_contain_the_values():
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    values = ca.vertcat(
        x + 2 * y, x - y, -x, x * y, x * x, ca.fabs(x), ca.sin(x), ca.cos(3 * x), x / y, 1 / y, ca.sqrt(x), ca.fmin(x, y),
        ca.fmax(x, y), ca.exp(x), ca.atan(y), ca.tanh(x), x**3, ca.sqrt(x * x + y * y), ca.atan2(x, y), ca.erf(2.0) + x,
    )  # fmt: skip
    function = ca.Function("values", [x, y], [values])
    lowest, random = interval_extension(function), np.random.default_rng(3)
    for _ in range(200):
        low, width = random.normal(size=2), random.exponential(size=2)
        bound = np.array(lowest(*low, *(low + width))).ravel()
        for _ in range(20):
            value = np.array(function(*(low + random.random(2) * width))).ravel()
            assert np.all((bound <= value + 1e-12) | np.isnan(value))
    exact = np.array(lowest(0.5, 0.7, 0.5, 0.7)).ravel()
    assert exact == pytest.approx(np.array(function(0.5, 0.7)).ravel(), abs=1e-15)


@pytest.fixture(scope="module")
def ball_among_walls():
    """A ball that flies to and fro in a room of 18 walls: it meets them one after the other."""
    room, radius = hd.Parameter("room", "m", 1), hd.Parameter("radius", "m", 0.05)
    ball = hd.Body.sphere("ball", radius, mass=hd.Parameter("mass", "kg", 1))
    normals = [(math.cos(x), math.sin(x)) for x in np.arange(WALLS) * 2 * math.pi / WALLS]
    walls = [
        hd.SphereOnPlane(
            f"wall_{i}", ball.at(0, 0, 0), radius, plane=hd.GROUND.at(-x * room, -y * room, 0), normal=hd.Direction((x, y, 0)),
        )
        for i, (x, y) in enumerate(normals)
    ]  # fmt: skip
    law = power(hd.Parameter("stiffness", "N/m^1.5", 1e7), n=1.5), flores(hd.Parameter("restitution", "1", 0.95))
    scene = hd.Scene(
        hd.Mechanism("ball_among_walls", (hd.Planar("flight", hd.GROUND, ball, normal=hd.Z),), tuple(walls)),
        effects=(
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 1), direction=-hd.Y),
            *(hd.Contact(wall.name, *law) for wall in walls),
            hd.EnergyLedger(),
        ),
        start=hd.Start(speed={"flight.x": hd.Parameter("pace", "m/s", 20), "flight.y": hd.Parameter("rise", "m/s", 7)}),
        scales=hd.Scales(length=radius, arm=radius, speed=hd.Parameter("pace_scale", "m/s", 5)),
    )
    return load(scene)


def begun(run):
    return [(impact.contact, impact.t) for impact in run.impacts]


@pytest.fixture(scope="module")
def every_wall(ball_among_walls):
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(reduced_runs, "MOST", -1)
        return simulate(ball_among_walls, **OPTIONS)


def run_reduced(model, monkeypatch, options=OPTIONS, **constants):
    """Return a run, and the pairs of the models that it used."""
    used, code = [], reduced_runs._reduced_code
    monkeypatch.setattr(reduced_runs, "_reduced_code", lambda *given: used.append(given[2]) or code(*given))
    for name, value in constants.items():
        monkeypatch.setattr(reduced_runs, name, value)
    return simulate(model, **options), used


@pytest.mark.parametrize("models", [3, 100])
def test_no_wall_is_missed(ball_among_walls, every_wall, monkeypatch, models):
    """The ball meets wall after wall: each is near only when it comes, also after a reduced model or the whole took over."""
    run, used = run_reduced(ball_among_walls, monkeypatch, AHEAD=0.5, MODELS=models)
    assert [name for name, _ in begun(run)] == [name for name, _ in begun(every_wall)]
    assert len(begun(run)) > 4
    assert [t for _, t in begun(run)] == pytest.approx([t for _, t in begun(every_wall)], abs=1e-8)
    assert len(used) > 1 and max(map(len, used)) <= reduced_runs.MOST
    assert run["flight.x"][-1] == pytest.approx(every_wall["flight.x"][-1], abs=1e-6)
    assert run.energy_residual < 1e-6
    for part in ("gap", "gap_rate"):
        for wall in range(WALLS):
            expected = every_wall.at([0.123, 0.7])[f"wall_{wall}.{part}"]
            assert run.at([0.123, 0.7])[f"wall_{wall}.{part}"] == pytest.approx(expected, abs=1e-6)


def test_a_box_that_is_not_kept_to_misses_walls(ball_among_walls, every_wall, monkeypatch):
    monkeypatch.setattr(reduced_model, "BEYOND", -1e9)
    monkeypatch.setattr(reduced_model, "STEPS", 1e-9)
    run, _ = run_reduced(ball_among_walls, monkeypatch, AHEAD=0.5)
    assert begun(run) != begun(every_wall)


def test_far_guards_are_in_no_model(monkeypatch):
    """Of 19 guards all but one are apart at every position; that one is while the slider keeps to its stroke."""
    options = {"duration": "24 ms", "tolerance": 1e-8, "compiled": False}
    run, used = run_reduced(load(scenes.guarded_crank(19)), monkeypatch, options)
    alone = simulate(load(scenes.guarded_crank(0)), **options)
    assert used == [(0,)]
    native = simulate(run.engine.model, **options | {"compiled": True})
    assert used == [(0,), (0,)]
    assert np.array_equal(np.asarray(native.engine.history.rows), np.asarray(run.engine.history.rows))
    assert [impact.contact for impact in run.impacts] == [impact.contact for impact in alone.impacts]
    assert run["guide.travel"][-1] == pytest.approx(alone["guide.travel"][-1], abs=1e-6)
    rows = run.engine.history.rows  # only the columns of the reduced model are stored
    assert rows.nbytes / len(rows) < 1.5 * alone.engine.history.rows.nbytes / len(alone.engine.history.rows)
    whole, layout = np.asarray(rows), run.engine.history.engine.layouts.state
    for name in layout.sizes:
        assert np.array_equal(rows[:, layout[name]], whole[:, layout[name]])
        assert np.array_equal(rows[-2:, layout[name]], whole[-2:, layout[name]])
    for column in range(whole.shape[1]):
        assert np.array_equal(rows[:, column], whole[:, column])
    again = reduced_rows.joined([whole[:3], rows])
    assert isinstance(again, reduced_rows.ReducedRows)
    assert np.array_equal(np.asarray(again), np.concatenate([whole[:3], whole]))
    other = whole[:3].copy()
    other[1, layout["gap"]] = 2.0  # of a pair that the reduced model does not have
    assert np.array_equal(reduced_rows.joined([other, rows]), np.concatenate([other, whole]))


def test_a_run_goes_on_from_its_end(ball_among_walls, every_wall):
    run = simulate(ball_among_walls, **OPTIONS | {"duration": "0.6 s"})
    later = run.continued("1 s")
    assert later["flight.x"][-1] == pytest.approx(every_wall["flight.x"][-1], abs=1e-6)
    restitution = run.sensitivities("restitution")["flight.x", "restitution"][-1]
    assert np.isfinite(restitution)


@pytest.mark.exhaustive
def test_compiled_runs_are_the_same_to_the_bit(ball_among_walls):
    runs = [simulate(ball_among_walls, **OPTIONS | {"compiled": compiled}) for compiled in (False, True)]
    assert np.array_equal(*(run.engine.history.part("y") for run in runs))
