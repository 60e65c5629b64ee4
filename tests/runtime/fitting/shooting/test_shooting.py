"""Multiple shooting against one run, against differences, and in chaos, where single shooting ends in another valley."""

import numpy as np
import pytest
from scipy.stats import binom

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime import MeasuredImpacts, Measurement, fit, load, simulate
from hertzwerk.runtime.fitting.fitting import read_fit, search_of
from hertzwerk.runtime.fitting.shooting.segments import SegmentedForward, states_of
from hertzwerk.runtime.fitting.shooting.shooting import check_shooting
from hertzwerk.runtime.fitting.shooting.solver import Solver

WALLS = {"restitution": "0.97", "speed": "9 m/s"}
FREE = {"restitution": (0.9, 1), "speed": "5..15 m/s"}
NOTHING = {
    **dict.fromkeys(("noise", "parameters", "initial", "inputs", "duration", "gain")),
    **{"offset": 0.0, "tolerance": 1e-9, "method": "auto", "starts": 0, "seed": 0, "profile": False},
}


def positions(model, true, name, sigma, t, seed=0):
    run = simulate(model, duration=float(t[-1]) * 1.001, tolerance=1e-11, parameters=true)
    noise = np.random.default_rng(seed).normal(0, sigma, len(t))
    return Measurement(t, {"x": run.at(t)[name] + noise}, {"x": "m"})


@pytest.fixture(scope="module")
def walls():
    return load("ball_between_walls")


def test_segments_tell_what_one_run_tells(walls):
    """Where one run can be followed, its least squares and their curvature are those of the joined segments."""
    data = positions(walls, WALLS, "track.travel", 5e-3, np.linspace(0.01, 4, 80))
    how = {"map": {"x": "track.travel"}, "noise": {"x": "5 mm"}, "starts": 0, "profile": False}
    free = {"restitution": (0.95, 0.99), "speed": "8.5..9.5 m/s"}
    one, many = (fit(walls, data, free=free, shooting=length, **how) for length in (None, "1 s"))
    assert len(many.solutions) >= 3
    for name in FREE:
        a, b = one[name], many[name]
        width = a.interval.high - a.interval.low
        assert abs(b.value - a.value) < 0.02 * width
        assert b.interval.high - b.interval.low == pytest.approx(width, rel=1e-3)
    assert many.goodness.chi_square == pytest.approx(one.goodness.chi_square, rel=1e-3)
    assert "multiple shooting over" in many["speed"].interval.how
    assert many.explained
    assert many.share == 1


def test_a_step_solves_the_whole_sparse_system(walls):
    """Eliminated from the last start on, a step is that of the dense least squares; derivatives are those of differences."""
    data = positions(walls, WALLS, "track.travel", 5e-3, np.linspace(0.01, 4, 60))
    asked = read_fit(walls, data, FREE, map={"x": "track.travel"}, **NOTHING)
    search = search_of(asked, None)
    x = np.array([one.inner(value) for one, value in zip(asked.free, (0.969, 9.02), strict=True)])
    solver = Solver(SegmentedForward(search.forward, 1.0), np.full(60, 5e-3), x, search.low, search.high, [4.0])
    for _ in range(3):
        end = solver.forward.chains[0][-1].end if solver.forward.chains[0] else 0.0
        solver._add(0, end, 4.0)
    segments = solver.forward.segments
    for segment in segments[1:]:
        segment.start = segment.start + np.array([2e-4, 0.01])
    blocks, d = solver._blocks(), solver.scale
    m, k, n = [len(block.residual) for block in blocks], 2, 2
    rows = np.zeros((sum(m) + 2 * n, k + 2 * n + 1))
    for j, block in enumerate(blocks):
        here = slice(sum(m[:j]), sum(m[: j + 1]))
        rows[here, :k], rows[here, -1] = block.by_x, -block.residual
        if j:
            own, weights = slice(k + n * (j - 1), k + n * j), 1 / segments[j - 1].allowed[:, None]
            joint = slice(sum(m) + n * (j - 1), sum(m) + n * j)
            rows[here, own] = block.by_start * d
            rows[joint, :k], rows[joint, own] = weights * blocks[j - 1].end_by_x, -weights * np.diag(d)
            if j > 1:
                rows[joint, own.start - n : own.start] = weights * blocks[j - 1].end_by_start * d
            rows[joint, -1] = weights[:, 0] * (segments[j].start - blocks[j - 1].end)
    whole = np.linalg.lstsq(rows[:, :-1], rows[:, -1], rcond=None)[0]
    step, _ = solver._step(blocks)
    assert step[0] == pytest.approx(whole[:k], rel=1e-5)
    assert step[2:].ravel() == pytest.approx(whole[k:], rel=1e-5)
    segment, h = segments[1], 1e-7
    for j in range(n):
        kept, ends = segment.start, []
        for sign in (1, -1):
            segment.start = kept + sign * h * d * (np.arange(n) == j)
            ends.append(np.concatenate(solver.forward.residual(segment, x, solver.sigma)))
        segment.start = kept
        difference = (ends[0] - ends[1]) / (2 * h * d[j])
        exact = np.concatenate([blocks[1].by_start[:, j], blocks[1].end_by_start[:, j]])
        assert exact == pytest.approx(difference, rel=1e-4, abs=1e-4 * np.max(np.abs(difference)))


RATTLING = {"restitution": "0.85", "clearance": "0.45 mm"}
RANGES = {"restitution": (0.6, 1), "clearance": "0.3..0.7 mm"}
SEEN = {"map": {"x": "guide.travel"}, "noise": {"x": "0.02 mm"}, "profile": False}


def test_segments_join_in_flight(walls):
    """A contact that remembers its approach may not be cut: its squares would be those of another law."""
    data = positions(walls, WALLS, "track.travel", 5e-3, np.linspace(0.01, 4, 60))
    search = search_of(read_fit(walls, data, FREE, map={"x": "track.travel"}, **NOTHING), None)
    x = np.array([one.inner(value) for one, value in zip(search.forward.free, (0.97, 9.0), strict=True)])
    solver = Solver(SegmentedForward(search.forward, 1.0), np.full(60, 5e-3), x, search.low, search.high, [4.0])
    solver._add(0, 0.0, 4.0)
    solver._add(0, solver.forward.chains[0][-1].end, 4.0)
    assert not solver._touching()
    assert solver.cost() == pytest.approx(solver._squares(x), rel=1e-6)
    first, second = solver.forward.segments
    impact = simulate(walls, duration="4 s", parameters=WALLS).impacts[0]
    first.end = second.begin = impact.t + impact.duration / 2
    for segment in (first, second):
        segment.known.clear()
        segment.rows = np.flatnonzero((data.times >= segment.begin) & (data.times < segment.end))
    second.start = np.array([solver.forward.run_of(first, x).final[name] for name in states_of(walls)])
    assert solver._touching()
    assert solver.cost() > 100 * solver._squares(x)
    solver._cut()
    assert not solver._touching()
    assert solver.cost() == pytest.approx(solver._squares(x), rel=1e-6)


@pytest.mark.exhaustive
def test_a_rattling_pin_beyond_the_reach_of_one_run():
    """32 impacts: one run ends in another valley, and is rejected; segments find the truth."""
    model = load("slider_crank_frictionless")
    data = positions(model, RATTLING, "guide.travel", 2e-5, np.linspace(2e-4, 20e-3, 200), seed=0)
    one = fit(model, data, free=RANGES, starts=16, **SEEN)
    many = fit(model, data, free=RANGES, starts=16, shooting="2 ms", **{**SEEN, "profile": True})
    assert one.explained is False
    assert not one["restitution"].interval.low < 0.85 < one["restitution"].interval.high
    assert many.explained
    assert many["restitution"].value == pytest.approx(0.85, abs=2e-4)
    assert many["clearance"].value == pytest.approx(0.45e-3, abs=2e-7)
    for name, true in (("restitution", 0.85), ("clearance", 0.45e-3)):
        assert many[name].interval.how.startswith("profile")
        assert many[name].interval.low < true < many[name].interval.high
    values = {name: many[name].value for name in RATTLING}
    through = simulate(
        model,
        duration="20.02 ms",
        tolerance=1e-11,
        parameters={"restitution": values["restitution"], "clearance": (values["clearance"], "m")},
    )
    square = np.sum(((data.columns["x"] - through.at(data.times)["guide.travel"]) / 2e-5) ** 2)
    assert square == pytest.approx(many.goodness.chi_square, abs=0.5)  # segments are one run
    assert len(many.solutions) >= 5


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("scene", "true", "free", "name", "sigma", "end", "length", "seeds"),
    [
        ("ball_between_walls", WALLS, FREE, "track.travel", 5e-3, 25.0, "5 s", 200),
        pytest.param(
            *("slider_crank_frictionless", RATTLING, RANGES, "guide.travel", 2e-5, 12e-3, "2 ms", 200),
            marks=pytest.mark.xfail(
                reason="69 and 71 of 80: the least of many valleys lies lower than one valley's would"
            ),
        ),
    ],
)
def test_intervals_of_segments_hold_the_truth_as_often_as_they_say(scene, true, free, name, sigma, end, length, seeds):
    """Intervals of 95 %; those of the walls held 191 and 188 times of 200, those of the pin 69 and 71 times of 80."""
    model = load(scene)
    bound, held, met = model.bind(true), dict.fromkeys(free, 0), 0  # of fits with intervals: others say so
    run = simulate(model, duration=end * 1.001, tolerance=1e-11, parameters=true, compiled=True)  # as all runs are then
    t = np.linspace(0.01 * end, end, 120)
    clean = run.at(t)[name]
    for seed in range(seeds):
        data = Measurement(t, {"x": clean + np.random.default_rng(seed).normal(0, sigma, len(t))}, {"x": "m"})
        how = {"map": {"x": name}, "noise": {"x": (sigma, "m")}, "seed": seed}
        found = fit(model, data, free=free, shooting=length, **how)
        refused = any(found[one].interval.how.startswith("none") for one in free)
        if found.share < 1 or found.goodness.p_value < 1e-4 or refused:
            continue
        met += 1
        for one in free:
            held[one] += found[one].interval.low <= bound[one] <= found[one].interval.high
    print(scene, len(run.impacts), "impacts", held, met)
    low, high = binom.interval(0.996, met, 0.95)
    assert all(low <= count <= high for count in held.values()), held
    assert met >= 0.8 * seeds


def test_what_has_no_segments_is_refused(walls):
    data = MeasuredImpacts([1, 2], {"speed": [9, 8]}, {"speed": "m/s"})
    with pytest.raises(InputError) as raised:
        fit(walls, data, free=FREE, duration="2 s", offset="-1..1 ms", shooting="1 m")
    text = str(raised.value)
    for part in ("data of impacts", "a range of offsets", "a positive time"):
        assert part in text
    faults = []
    check_shooting(load("tippe_top"), (), fitted_offset=False, faults=faults)
    assert [fault.found for fault in faults] == ["a scene with quaternions"]
