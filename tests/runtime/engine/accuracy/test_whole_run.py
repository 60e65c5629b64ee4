"""The error of a whole run: how a shift in time and impacts count, and that the request holds along the way.

Oracles: brute force over shifts; a ball that bounces, in closed form by its own impacts at a tight tolerance.
"""

import casadi as ca
import numpy as np
import pytest
from handmade import point

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate, sweep
from hertzwerk.runtime.engine.run import accurate_run
from hertzwerk.runtime.engine.run.run_difference import impact_differences
from hertzwerk.runtime.engine.run.run_request import Request, read_accuracy
from hertzwerk.runtime.engine.solution.error_scales import Scales as SolutionScales
from hertzwerk.runtime.engine.solution.error_scales import distance, error
from hertzwerk.runtime.engine.solution.history import COMPARED
from hertzwerk.runtime.engine.solution.impacts import Impact
from hertzwerk.runtime.loading import engine_model


def by_search(apart, rates, pace):
    """The least over shifts, by ever finer rows of them."""
    width, middle = np.abs(apart).max() / pace, 0.0
    for _ in range(12):
        shifts = middle + np.linspace(-width, width, 401)
        sizes = np.maximum(pace * np.abs(shifts), np.abs(apart[:, None] - rates[:, None] * shifts).max(axis=0))
        middle, width = shifts[np.argmin(sizes)], width / 50
    return sizes.min()


def test_the_distance_is_the_least_over_shifts_in_time_that_count_by_their_own_scale():
    draw = np.random.default_rng(1)
    for _ in range(100):
        n = draw.integers(1, 6)
        apart = draw.normal(size=n) * 10.0 ** draw.uniform(-6, 0)
        rates, pace = draw.normal(size=n) * 10.0 ** draw.uniform(-2, 4, size=n), 10.0 ** draw.uniform(0, 4)
        actual, shift = distance(apart, rates, pace)
        assert actual == pytest.approx(by_search(apart, rates, pace), rel=1e-6)
        assert max(pace * abs(shift), np.abs(apart - rates * shift).max()) == pytest.approx(actual, rel=1e-6)
    rates, pace, late = np.array([1.0, 1e6]), 10.0, 1e-9  # in an impact the speed changes by its scale in a microsecond
    assert distance(rates * late, rates, pace)[0] == pytest.approx(pace * late, rel=1e-4)
    assert distance(np.array([1e-3, 0.0]), rates, pace)[0] > 0.9e-3  # what no shift explains counts in full


def test_impacts_count_by_speed_force_and_the_time_in_which_their_length_is_covered():
    scales = SolutionScales(np.ones(2), np.array([1e-3, 2.0, 100.0, 1.0]))
    true = Impact("floor", 0.1, 1.0, 50.0, 1e-4, 1e-5)

    def errors(*other, one=(true,)):
        return [error for _, error, _ in impact_differences(one, other, scales)]

    assert errors(true) == [0.0]
    assert errors(true._replace(t=0.1 + 1e-6)) == pytest.approx([1e-3])  # 1 m/s for 1 us, of 1 mm
    assert errors(true._replace(duration=1e-4 + 2e-6)) == pytest.approx([2e-3])
    assert errors(true._replace(speed=1.02, peak_force=50.0)) == pytest.approx([1e-2])
    assert errors(true._replace(peak_force=60.0)) == pytest.approx([0.1])
    assert errors() == [0.5]  # missing altogether
    assert errors(true, true._replace(t=0.2, speed=1e-3, peak_force=0.01)) == pytest.approx([0, 5e-4])
    assert errors(true._replace(duration=None, peak_force=1.0)) == [0.0]  # stopped in it


def test_an_impact_that_is_off_is_an_error_of_the_run(monkeypatch):
    """By as much as it is off, from a run that has 7/8 of it; the states are as they were."""

    def off(one, *_):
        return [(impact.t, 4.2e-3, 7e6) for impact in one]

    monkeypatch.setattr("hertzwerk.runtime.engine.run.run_difference.impact_differences", off)
    run = simulate(engine_model("bouncing_ball"), duration="1 s", accuracy=1e-2, compiled=False)
    assert run.error.worst == pytest.approx(4.8e-3, rel=1e-4)
    assert run.error.of("floor.normal_force") == pytest.approx(8e6, rel=1e-4)


@pytest.mark.parametrize("asked", [1e-2, 1e-4])
def test_the_request_holds_on_the_way_to_rest_and_of_peaks(asked):
    """On the old code `bouncing_ball` for 15 s at 1e-4 was off by 1.6e-3 on the way, and at rest by nothing."""
    ball = engine_model("bouncing_ball")
    run = simulate(ball, duration="5 s", accuracy=asked, compiled=False)
    truth = simulate(ball, duration="5 s", tolerance=1e-13, method="dopri5", compiled=False)
    assert run.outcome.finished
    assert run.error.end <= run.error.worst <= asked
    for mine, true in zip(run.impacts, truth.impacts, strict=True):
        assert abs(mine.speed - true.speed) <= asked * run.engine.scales.scene[1]
        assert abs(mine.peak_force - true.peak_force) <= asked * max(
            run.engine.scales.scene[2], truth.impacts[0].peak_force
        )
    times = np.linspace(0.1, 4.9, 500)
    off = np.abs(run.at(times)["vertical.travel"] - truth.at(times)["vertical.travel"])
    assert off.max() <= 2 * asked * run.engine.scales.scene[0]  # a shift of one scale moves it by another at most


def test_the_end_alone_is_requested_by_name():
    run = simulate(engine_model("four_bar_clearance"), duration="30 ms", accuracy="1e-4 at the end", compiled=False)
    assert run.outcome.finished
    assert run.error.at_end
    assert run.error.judged == run.error.end <= 1e-4
    assert read_accuracy("1e-6 at the end") == Request(1e-6, True)
    assert read_accuracy("1e-6") == Request(1e-6)
    for wrong in ("at the end", "1e-6 at the start", "1e-20 at the end", None.__class__):
        with pytest.raises(InputError, match="accuracy"):
            simulate(engine_model("soft_ball"), duration="1 s", accuracy=wrong)


def test_an_error_says_the_worst_when_the_end_and_of_a_history_in_its_unit():
    run = simulate(engine_model("bouncing_ball"), duration="2 s", accuracy=1e-5, compiled=False)
    error = run.error
    assert repr(error) == f"<ErrorEstimate {error}>"
    assert len(repr(error)) < 80
    assert f"t = {error.when:.4g} s" in str(error)
    assert error.times[np.argmax(error.values)] == error.when
    travel = error.of("vertical.travel")
    assert 0 < travel <= error.worst * run.engine.scales.state[0] * (1 + 1e-9)
    assert 0 < error.of("floor.normal_force") < 1e-3 * run.impacts[0].peak_force
    with pytest.raises(KeyError, match=r"vertical\.travel"):
        error.of("vertical.acceleration")


def pendulum_on_a_universal_joint():
    """Of its motion the limit on growth chooses every step: at 1e-3 three of them."""
    mass, arm = hd.Parameter("mass", "kg", 1.0), hd.Parameter("arm", "m", 0.5)
    inertia = tuple(
        hd.Parameter(f"inertia_{axis}", "kg m^2", value) for axis, value in zip("xyz", (0.09, 0.08, 0.01), strict=True)
    )
    bob = hd.Body("bob", mass, inertia, centre=(0, -arm, 0))
    joint = hd.Universal("joint", hd.GROUND, bob, hd.X, hd.Z)
    return hd.Scene(
        hd.Mechanism("hung", (joint,)), (hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y),),
        start=hd.Start(position={"joint.angle_1": hd.Parameter("a", "rad", 0.7), "joint.angle_2": hd.Parameter("b", "rad", 0.4)}),
        scales=hd.Scales(length=arm, speed=hd.Parameter("pace", "m/s", 2), arm=arm),
    )  # fmt: skip


@pytest.mark.parametrize("method", ["dop853", "dopri5", "esdirk", "rodas"])
def test_two_runs_of_the_same_steps_are_no_estimate(method, monkeypatch):
    """On the old code the error of three steps by dop853 was 1e-13, as those of the run that checked them were the same."""
    hung = engine_model(pendulum_on_a_universal_joint())
    truth = simulate(hung, duration="0.3 s", tolerance=1e-13, method="dop853", compiled=False)

    def ratio():
        run = simulate(hung, duration="0.3 s", accuracy=1e-3, method=method, compiled=False)
        off = [abs(run.engine.final[name] - truth.engine.final[name]) for name in (*hung.coordinates, *hung.speeds)]
        return run.error.end / np.max(off / run.engine.scales.state[: len(off)])

    assert 0.1 < ratio() < 10
    if method == "dop853":
        monkeypatch.setattr(accurate_run, "SHORTER", 1.0)  # the seeded fault
        assert ratio() < 0.1


def test_extremes_are_found_within_the_steps_as_a_sweep_finds_them():
    """On the old code the largest of the steps was all there was, .4 to 2 % below the peak."""
    crank = engine_model("slider_crank")
    run = simulate(crank, duration="5 ms", accuracy=1e-5, compiled=False)
    actual = run.extremes("slider_pin.normal_force")
    peak = max(run.impacts, key=lambda impact: impact.peak_force)
    assert actual.highest == pytest.approx(peak.peak_force, rel=1e-7)
    assert peak.t < actual.highest_t < peak.t + peak.duration
    assert actual.highest > run["slider_pin.normal_force"].max()
    swept = sweep(
        crank, {"restitution": [0.9]}, outputs=["slider_pin.normal_force.max", "guide.travel.min"], duration="5 ms", accuracy=1e-5,
    )  # fmt: skip
    assert swept["slider_pin.normal_force.max"][0] == actual.highest
    assert swept["guide.travel.min"][0] == run.extremes("guide.travel").lowest
    with pytest.raises(KeyError, match="did you mean"):
        run.extremes("slider_pin.normal_forc")


def met_within_steps(model, asked, methods, parts, **options):
    """Check that the error at these parts of the steps, against a run by another method, is below the request and seen."""
    run = simulate(model, accuracy=asked, method=methods[0], compiled=False, **options)
    truth = simulate(model, tolerance=1e-13, method=methods[1], compiled=False, **options)
    times = np.unique(np.concatenate([run.t[:-1] + part * np.diff(run.t) for part in parts]))
    states = (side.part(name) for name in ("y", "dy") for side in (run.at(times), truth.at(times)))
    true = error(model, run.engine.scales, *states).max()
    assert run.outcome.finished
    assert true <= asked
    assert true <= 3 * run.error.worst


@pytest.mark.parametrize(
    ("asked", "duration", "sizes"),
    [(1e-3, 1.1155945691947136e-3, (1.65767217, 1.1268926, 0.60793)), (1e-5, 8.752949356809732e-4, (1.07636913, 2.5098988, 0.56774569)),
     (1e-3, 1.1745568585120932e-3, (3.157783013328199, 1.6061091202254833, 0.7105406747549909))],
)  # fmt: skip
def test_where_friction_turns_round_within_a_step_the_error_is_seen(asked, duration, sizes):
    """At the ends of steps, and where rates change at once, in steps of a microsecond too.

    On the old code 29, 7 and 4.7 times over, 87, 65 and 46 times the estimate.
    """
    units = {"clearance": "mm", "friction_speed": "mm/s", "friction_coefficient": "1"}
    given = {name: f"{size!r} {unit}" for (name, unit), size in zip(units.items(), sizes, strict=True)}
    options = {"duration": duration, "parameters": given}
    met_within_steps(engine_model("slider_crank"), asked, ("dop853", "dopri5"), (0, 0.4, 0.8), **options)


def test_a_step_over_a_turn_is_compared_as_often_as_its_dense_output_may_bend():
    """dopri5 takes one step over the turn of tanh(v/10 mm/s), after 70 % of which it is off most. On the old code 1.35 times over."""
    rubbed = point(None, push=lambda t, x, v: 2 * ca.cos(3 * t) - 0.8 * ca.tanh(v / 1e-2))
    options = {"duration": 5, "parameters": {"v0": "1 m/s"}}
    met_within_steps(rubbed, 1e-2, ("dopri5", "dop853"), np.arange(0, 1, 0.05), **options)


def test_of_three_links_on_journals_the_request_holds():
    """Compared at even times alone dopri5 is 1.3 times over, estimated half the request; without a third run dop853 is 1.7 times over."""
    sizes = {"m": 1, "l": 0.5, "mu": 0.142, "v_s": 0.0246, "r": 0.02, "pace": 2, "g": 9.81}
    units = dict(zip(sizes, ("kg", "m", "1", "m/s", "m", "m/s", "m/s^2"), strict=True))
    m, length, mu, v_s, radius, pace, g = (hd.Parameter(name, units[name], size) for name, size in sizes.items())
    journals, rubs, carrier = [], [], hd.GROUND
    for i in range(3):
        link = hd.Body(f"link{i}", m, m * length**2 / 12, (0, -length / 2, 0))
        journals.append(hd.Revolute(f"joint{i}", carrier, link, hd.Z))
        rubs.append(hd.JointFriction(f"rub{i}", f"joint{i}", hd.laws.smooth_coulomb(mu, v_s), radius=radius))
        carrier = link.at(0, -length, 0)
    scales = hd.Scales(length, pace, length)
    scene = hd.Scene(hd.Mechanism("links", tuple(journals)), (*rubs, hd.Gravity("gravity", g, -hd.Y)), scales)
    links, starts = engine_model(scene), {"dopri5": (1.437, -0.426, -1.497), "dop853": (0.9749, -1.0429, 0.7028)}
    for methods in (starts, [*starts][::-1]):
        method, other = methods
        initial = {f"joint{i}.angle": f"{angle} rad" for i, angle in enumerate(starts[method])}
        met_within_steps(links, 1e-6, (method, other), (0, 0.25, 0.5, 0.75), duration=1.6, initial=initial)


@pytest.mark.parametrize("method", ["auto", "esdirk"])
def test_runs_are_compared_by_the_states_that_they_have_at_any_time(method):
    """To the bit, though of each class of contacts only these parts are computed."""
    run = simulate(engine_model("newtons_cradle"), duration="0.9 s", tolerance=1e-5, method=method, compiled=False)
    history, times = run.engine.history, np.unique(np.append(run.t, run.t[:-1] + 0.4 * np.diff(run.t)))
    whole, compared = history.at(times), history.at(times, compared=True)
    assert np.unique(whole.part("mode"), axis=0).shape[0] > 3  # in flight, one pair in contact, another, several
    for part in COMPARED:
        np.testing.assert_array_equal(compared.part(part), whole.part(part), part)


def test_an_error_that_goes_up_and_down_along_the_run_is_looked_for_in_a_hundred_steps_of_it():
    """As in an impact, where it oscillated with 80 of 3,183 steps: 1.3 times the estimate from 60 of them."""
    run = simulate(engine_model("slider_crank"), duration="12 ms", accuracy=1e-5, method="dopri5", compiled=False)
    steps = np.unique(np.searchsorted(run.t, run.error.times))
    assert len(run.t) > 1000
    assert np.diff(steps).max() < len(run.t) / 100 + 2


@pytest.mark.parametrize(("method", "asked"), [("esdirk", 1e-4), ("dopri5", 1e-4)])
def test_of_a_fast_vibration_the_error_is_seen_where_no_shift_in_time_accounts_for_it(method, asked):
    """Against the closed form. Between these instants errors are a hundred times smaller; on the old code 10 and 7 times the estimate."""
    bob, stretch, pulse = hd.Body("bob", hd.Parameter("mass", "kg", 1)), 1e-3, 1e3
    slide = hd.Prismatic("slide", hd.GROUND, bob, axis=hd.X)
    scene = hd.Scene(
        hd.Mechanism("vibrating", (slide,)),
        (hd.JointSpring("spring", "slide", hd.Parameter("stiffness", "N/m", pulse**2)),),
        start=hd.Start(position={"slide": hd.Parameter("stretch", "m", stretch)}),
        scales=hd.Scales(length=hd.Parameter("size", "m", 0.3), speed=hd.Parameter("pace", "m/s", 1)),
    )
    vibrating = engine_model(scene)
    run = simulate(vibrating, duration="50 ms", accuracy=asked, method=method, compiled=False)
    times = (run.t[:-1, None] + np.diff(run.t)[:, None] * np.arange(0.02, 1, 0.02)).ravel()
    place, speed = stretch * np.cos(pulse * times), -stretch * pulse * np.sin(pulse * times)
    true, rates = np.stack([place, speed], axis=1), np.stack([speed, -(pulse**2) * place], axis=1)
    rows = run.at(times)
    off = error(vibrating, run.engine.scales, rows.part("y")[:, :2], true, rows.part("dy")[:, :2], rates)
    assert off.max() <= asked
    assert 0.3 * run.error.worst <= off.max() <= 2 * run.error.worst
    assert np.median(off) < 0.02 * run.error.worst


def test_the_error_of_a_contact_that_alone_is_late_is_seen_at_its_peak():
    """The pin grazes its bush, and no shift in time of the whole linkage accounts for that. On the old code 1.8 times over."""
    bars, requested = engine_model("four_bar_clearance"), 1e-5
    given = {"dop853": {"accuracy": requested}, "dopri5": {"tolerance": 1e-12}}
    run, truth = (simulate(bars, duration="120 ms", method=of, compiled=False, **given[of]) for of in given)
    states = (side.part(name) for name in ("y", "dy") for side in (run.at(run.t), truth.at(run.t)))
    assert run.outcome.finished
    assert error(bars, run.engine.scales, *states).max() <= requested
