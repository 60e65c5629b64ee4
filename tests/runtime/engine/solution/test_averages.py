"""Averages of a run and their confidence: how often an interval holds the true mean, and means that are known exactly."""

import json

import numpy as np
import pytest
from commands import called
from scipy.signal import lfilter

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.solution.averages import FEWEST, MOST, estimate
from hertzwerk.runtime.loading import engine_model
from reference import closed_forms

SEEDS = 1000
ERROR = 4 * np.sqrt(0.05 * 0.95 / SEEDS)  # of a coverage of 95 %, four standard deviations


def correlated(phi, n, count=SEEDS):
    """Series of mean 0, each value phi times the one before and a normal number, begun long before."""
    noise = np.random.default_rng(0).standard_normal((count, n + 100))
    return lfilter([1.0], [1.0, -phi], noise, axis=1)[:, 100:]


def covered(series):
    """Part of the intervals that hold the mean 0, and part of the series that have one."""
    found = [estimate(x) for x in series]
    holds = [abs(one.mean) <= one.half_width for one in found if one.half_width is not None]
    return np.mean(holds), len(holds) / len(found)


@pytest.mark.parametrize(("phi", "n", "low"), [(0.0, 240, 0.95), (0.6, 60, 0.91), (0.9, 1000, 0.94)])
def test_an_interval_holds_the_mean_as_often_as_it_says(phi, n, low):
    """Nearly so where a series is but 15 times as long as it is correlated (phi = 0.6, n = 60)."""
    coverage, known = covered(correlated(phi, n))
    assert low - ERROR < coverage < 0.96 + ERROR
    assert known > 0.95


def test_an_interval_follows_the_spread_of_its_blocks_or_there_is_none():
    """Of 30 values, 1 and -1 in turn: t s/sqrt(n) with t = 2.04523 of 29 degrees and s^2 = 30/29."""
    actual = estimate(np.resize([1.0, -1.0], 30))
    assert (actual.mean, actual.blocks) == (0, 30)
    assert actual.half_width == pytest.approx(2.04523 / np.sqrt(29), rel=1e-5)
    actual = estimate(5 + 1e-7 * np.linspace(0, 1, 90))
    assert actual.half_width == pytest.approx(1e-7 * 29 / 29.667, rel=1e-2)
    assert actual.blocks == MOST
    assert estimate(np.zeros(50)).half_width == 0
    drifting = estimate(np.linspace(1, 2, 100))
    assert (drifting.mean, drifting.half_width) == (pytest.approx(1.5), None)
    assert "still correlated" in drifting.reason
    short = estimate(np.array([1.0, 3.0, 2.0]))
    assert (short.mean, short.half_width, short.blocks) == (2.0, None, 3)
    assert str(FEWEST) in short.reason


def test_ten_times_longer_is_root_ten_narrower_and_blocks_that_are_not_joined_would_be_too_narrow():
    short, long = (np.mean([estimate(x).half_width for x in correlated(0.3, n, 100)]) for n in (400, 4000))
    assert short / long == pytest.approx(np.sqrt(10), rel=0.1)
    series = correlated(0.6, 240)
    half_width = 1.96 * series.std(axis=1, ddof=1) / np.sqrt(series.shape[1])
    assert np.mean(np.abs(series.mean(axis=1)) <= half_width) < 0.75


def test_a_mean_over_impacts_is_one_of_sums():
    """A chance number of impacts in an interval, each with a peak that depends on how many there are."""
    random = np.random.default_rng(3)
    holds = []
    for _ in range(SEEDS // 2):
        hits = random.poisson(1.5, 120)
        peaks = np.array([random.exponential(1 + n, n).sum() for n in hits])
        actual = estimate(peaks, hits.astype(float))
        used = slice(120 - actual.blocks * actual.intervals, None)
        assert actual.mean == pytest.approx(peaks[used].sum() / hits[used].sum(), rel=1e-12)
        if actual.half_width is not None:  # the mean over impacts of 1 + n is 1 + E n^2/E n = 1 + 1 + 1.5
            holds.append(abs(actual.mean - 3.5) <= actual.half_width)
    assert len(holds) > 0.98 * SEEDS // 2
    assert 0.95 - 1.5 * ERROR < np.mean(holds) < 0.96 + 1.5 * ERROR


# -- exact means -------------------------------------------------------------------------------------------------------


def named(run, **options):
    return {average.name: average for average in run.averages(**options)}


MASS, STIFFNESS, SPEED, APART = 1.6, 1e6, 10.0, 0.8
ROUND = 2 * (APART / SPEED + closed_forms.collision(STIFFNESS, 1, MASS, SPEED).duration)


@pytest.fixture(scope="module")
def between_walls():
    return simulate(
        engine_model("ball_between_walls"), duration=40 * ROUND, tolerance=1e-9, parameters={"restitution": 1.0}, compiled=False,
    )  # fmt: skip


def test_a_ball_between_walls(between_walls):
    """Elastic: each wall is hit once in twice the time across and twice the time in contact, and given 2 m v."""
    for options, precise in (({}, False), ({"interval": ROUND}, True)):
        averages = named(between_walls, **options)
        for wall in ("left_wall", "right_wall"):
            rate, force, peak = (averages[f"{wall}.{name}"] for name in ("impact_rate", "normal_force", "peak_force"))
            exact = 2 * MASS * SPEED / ROUND
            assert abs(rate.mean - 1 / ROUND) <= (1e-12 if precise else rate.half_width)
            assert abs(force.mean - exact) <= (1e-6 * exact if precise else force.half_width)
            assert peak.mean == pytest.approx(SPEED * np.sqrt(STIFFNESS * MASS), rel=1e-7)
            assert (rate.unit, force.unit, peak.unit) == ("1/s", "N", "N")
    assert averages["left_wall.largest_force"].mean == pytest.approx(SPEED * np.sqrt(STIFFNESS * MASS), rel=1e-6)


@pytest.mark.parametrize(("tolerance", "expected"), [(1e-6, 1e-5), (1e-9, 2e-7)])
def test_a_bouncing_ball_presses_on_average_with_its_weight(tolerance, expected):
    run = simulate(engine_model("soft_ball"), duration="20 s", tolerance=tolerance, compiled=False)
    (period,) = {round((run.impacts[-1].t - run.impacts[0].t) / (len(run.impacts) - 1), 12)}
    force = named(run, interval=period)["floor.normal_force"]
    assert force.mean == pytest.approx(9.81, rel=expected)
    assert abs(named(run)["floor.normal_force"].mean - 9.81) < named(run)["floor.normal_force"].half_width


@pytest.mark.parametrize("law", ["kelvin_voigt", "hunt_crossley"])
def test_an_impact_passes_on_what_the_ball_loses(law):
    """Whatever a law does at the ends of a contact, where its force may jump."""
    model = engine_model(
        "ball_between_walls", laws={"right_wall": law} if law != "hunt_crossley" else None
    )  # which it has
    run = simulate(model, duration="100 ms", tolerance=1e-9, parameters={"restitution": 0.7}, compiled=False)
    impulse = run.engine.findings.sums(0.05).impulse[:, model.pairs.index("right_wall")].sum()
    assert impulse == pytest.approx(
        MASS * (run.engine.initial["track.speed"] - run.engine.final["track.speed"]), rel=2e-5
    )


def test_a_motor_puts_in_what_friction_takes():
    """A loaded journal turning in its bush, at rest but for that: N and F_t = mu N carry the load."""
    run = simulate(engine_model("journal_in_bearing"), duration="10 s", tolerance=1e-8, compiled=False)
    model, values, averages = run.engine.model, run.engine.model.bind(), named(run)
    load_, speed = values["load"], (values["bush_radius"] - values["clearance"]) * values["speed"]
    mu = values["friction_coefficient"] * np.tanh(speed / values["friction_speed"])
    exact = mu * load_ / np.sqrt(1 + mu**2) * speed
    assert averages["bearing.normal_force"].mean == pytest.approx(load_ / np.sqrt(1 + mu**2), rel=1e-6)
    assert averages["energy_ledger.input_power"].mean == pytest.approx(exact, rel=1e-6)
    assert averages["bearing_friction.dissipated_power"].mean == pytest.approx(exact, rel=1e-6)
    assert averages["bearing.peak_force"].mean is None
    assert averages["bearing.impact_rate"].mean == 0
    assert averages["bearing.normal_force"].block == pytest.approx(2 * np.pi / values["speed"])
    assert model.period(values) == 2 * np.pi / values["speed"]


# -- runs that do not keep their steps ---------------------------------------------------------------------------------


CRANK = {"duration": "120 ms", "tolerance": 1e-4, "compiled": False, "max_steps": 20_000}


@pytest.fixture(scope="module")
def crank():
    return simulate(engine_model("slider_crank_frictionless"), **CRANK)


@pytest.mark.parametrize("block", [5_000, 2**23])
def test_a_run_on_a_grid_has_the_averages_of_its_steps(crank, block, monkeypatch):
    monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", block)
    grid = simulate(engine_model("slider_crank_frictionless"), **CRANK, grid=7)
    kept = named(crank)
    assert 9 in {average.blocks for average in kept.values()}  # some may be correlated: the motion is chaotic
    for name, average in named(grid).items():
        assert (average.blocks, average.block, average.reason) == (
            kept[name].blocks, kept[name].block, kept[name].reason,
        )  # fmt: skip
        assert average.mean == pytest.approx(kept[name].mean, rel=1e-12)
        assert (average.half_width or 0) == pytest.approx(kept[name].half_width or 0, rel=1e-9)
    assert named(grid, interval="24 ms").keys() == kept.keys()
    with pytest.raises(InputError, match=r"interval: found 0\.005 s; expected a multiple of 0\.012 s"):
        grid.averages(interval="5 ms")


def test_a_saved_run_has_them_too(crank, tmp_path):
    again = Solution.load(crank.save(tmp_path / "run.npz"))
    assert again.averages() == crank.averages()
    wider = {"interval": "24 ms", "skip": "24 ms"}  # of steps that are cut where other intervals begin
    assert [a.mean for a in again.averages(**wider)] == pytest.approx(
        [a.mean for a in crank.averages(**wider)], rel=1e-4
    )
    free = simulate(engine_model("pendulum"), duration="1 s")
    assert Solution.load(free.save(tmp_path / "free.npz")).averages() == free.averages() == ()


def test_the_transient_is_left_out(crank):
    whole, later = (named(crank, skip=skip)["slider_pin.impact_rate"] for skip in (0, "60 ms"))
    times = np.array([impact.t for impact in crank.impacts])
    assert whole.mean == pytest.approx(len(times) / 0.12)
    assert later.mean == pytest.approx(np.sum(times >= 0.06) / 0.06)
    assert "at least 8" in later.reason
    assert named(crank)["slider_pin.impact_rate"].mean == pytest.approx(np.sum(times >= 0.012) / 0.108)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"interval": "5 mm"}, "interval: found '5 mm'"), ({"interval": -1.0}, "interval: found -1.0"), ({"skip": True}, "skip: found True"),
        ({"interval": "1 s"}, "interval: found 1 s; expected at most the run's 0.12 s"),
        ({"skip": "1 s"}, "skip: found 1 s; expected less than the run's 0.12 s"),
    ],
)  # fmt: skip
def test_bad_input(crank, options, message):
    with pytest.raises(InputError, match=message):
        crank.averages(**options)


def test_the_command_line_shows_averages_where_they_are_requested(tmp_path):
    requested = ["run", "ball_between_walls", "--duration", "2 s", "--accuracy", "1e-4"]
    plain, with_averages = (called(*requested, "--json", *more) for more in ((), ("--averages",)))
    assert "averages" not in json.loads(plain.stdout)
    shown = json.loads(with_averages.stdout)["averages"]
    assert [row["name"] for row in shown][:3] == [
        f"left_wall.{x}" for x in ("impact_rate", "normal_force", "peak_force")
    ]
    assert shown[0].keys() == {"name", "unit", "mean", "half_width", "blocks", "block", "reason"}
    text = called(*requested, "--averages", "--no-plots", "--out", tmp_path / "run")
    (row,) = (line.split() for line in text.stdout.splitlines() if line.startswith("left_wall.impact_rate"))
    assert row[1] == f"{shown[0]['mean']:.4g}"
    short = ["--accuracy", "1e-3", "--averages", "--no-plots", "--out", tmp_path / "short"]
    text = called("run", "slider_crank", *short)
    assert text.stdout.count("1 of at least 8 intervals after the transient") == 1  # not once for each average
    assert json.loads((tmp_path / "run" / "run.json").read_text())["averages"] == shown
