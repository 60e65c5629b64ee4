"""The engine against closed forms, against itself as C, and at the edges: every outcome, every kind of bad input."""

import math
from concurrent.futures import ThreadPoolExecutor

import casadi as ca
import numpy as np
import pytest
from each import each
from handmade import point

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.integration.loop import c_compilation, c_files
from hertzwerk.runtime.engine.integration.step import explicit_step, implicit_step
from hertzwerk.runtime.loading import engine_model
from reference import closed_forms
from reference.slider_crank import SliderCrank, reference

pytestmark = pytest.mark.by_turns(5)  # methods and sizes that run the same code

METHODS = {"dopri5": 1e-12, "dop853": 1e-11}  # the tolerance that gives 1e-9 over an impact
DROP = 4.42944692


@pytest.fixture(autouse=True)
def little_optimised(monkeypatch):
    """As what runs seldom is compiled, by -O1."""
    monkeypatch.setattr(c_files, "OFTEN", c_files.SELDOM)


@pytest.fixture(scope="module")
def crank():
    return engine_model("slider_crank_frictionless")


def impact_alone(ball, method, **parameters):
    """The ball at the surface, DROP m/s, no gravity."""
    return simulate(
        ball, duration="1 ms", tolerance=METHODS[method], method=method, parameters={"gravity": "0 m/s^2", **parameters},
        initial={"vertical.travel": "0.1 m", "vertical.speed": f"{-DROP} m/s"},
    )  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("e", [1.0, 0.95, 0.5, 0.05])
def test_impact_of_two_bodies(ball, method, e):
    h = closed_forms.factor("flores", str(e))
    exact = closed_forms.collision("2.4e10", 1.5, 1, str(DROP), h)
    run = impact_alone(ball, method, restitution=e)
    (impact,) = run.impacts
    assert impact.t == 0
    assert impact.peak_penetration == pytest.approx(exact.depth, rel=1e-9)
    assert impact.peak_force == pytest.approx(exact.peak_force, rel=1e-9)
    assert impact.duration == pytest.approx(exact.duration, rel=1e-9)
    assert run.engine.final["vertical.speed"] / DROP == pytest.approx(exact.restitution, rel=1e-9)
    assert run.engine.final["floor.dissipated"] == pytest.approx(exact.dissipated, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("e", [0.9, 0.5])
def test_between_two_walls_bounce_by_bounce(method, e):
    run = simulate(
        engine_model("ball_between_walls"), duration="4 s", tolerance=1e-12, method=method, parameters={"restitution": e},
    )  # fmt: skip
    h = closed_forms.factor("hunt_crossley", str(e))
    bounces = closed_forms.ball_between_walls("1e6", 1, "1.6", 10, h, 10, "0.4", "0.8")
    impacts = run.impacts[:10]
    count = min(len(impacts), 10)
    assert count == (10 if e == 0.9 else sum(b.onset < 4 for b in bounces))
    for impact, bounce in zip(impacts, bounces, strict=False):
        assert impact.t == pytest.approx(bounce.onset, rel=1e-8)
        assert impact.speed == pytest.approx(bounce.approach, rel=1e-8)
        assert impact.peak_penetration == pytest.approx(bounce.depth, rel=1e-8)
    assert [impact.contact for impact in impacts] == [("right_wall", "left_wall")[i % 2] for i in range(count)]


def test_work_at_a_given_error_of_the_slider_crank(crank):
    """Impacts amplify errors at random: the mean over tolerances counts. The hand-written program needs 6050 evaluations for 5e-5 (10 ms)."""
    truth = reference(friction=False)
    logarithms, evaluations = [], []
    for tolerance in np.logspace(-6, -9, 13):
        run = simulate(crank, duration="10 ms", tolerance=tolerance)
        angle, travel, spin, speed = (run.engine.final[name] for name in (*crank.coordinates, *crank.speeds))
        w = SliderCrank().w
        logarithms.append(math.log10(truth.error(0.010, (angle + 0.010 * w, travel, spin + w, speed))))
        evaluations.append(run.statistics.rhs_evaluations)
    assert np.mean(logarithms) < math.log10(2e-5)
    assert np.mean(evaluations) < 7500


def test_landings_cost_little(crank):
    """Aimed and nudged: on parabolic flights no step is taken twice, and one in two elsewhere."""
    run = simulate(engine_model("ball_between_walls"), duration="4 s", tolerance=1e-8)
    assert run.statistics.events > 10
    assert run.statistics.retaken == 0
    run = simulate(crank, duration="24 ms", tolerance=1e-8)
    assert run.statistics.retaken < run.statistics.events  # an onset and an end each


@pytest.mark.parametrize("name", ["bouncing_ball", "slider_crank"])
def test_compiled_is_bitwise_the_virtual_machine(name, tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    model, duration = engine_model(name), "24 ms" if name == "slider_crank" else "5 s"
    machine = simulate(model, duration=duration, tolerance=1e-8)
    native = simulate(model, duration=duration, tolerance=1e-8, compiled=True)
    assert np.array_equal(machine.engine.history.rows, native.engine.history.rows)
    libraries = list((tmp_path / "cache").iterdir())
    assert [library.suffix for library in libraries] == [".so"]
    before = libraries[0].stat().st_mtime_ns
    again = simulate(engine_model(name), duration=duration, tolerance=1e-8, compiled=True)
    assert libraries[0].stat().st_mtime_ns == before  # found, not compiled again
    assert np.array_equal(machine.engine.history.rows, again.engine.history.rows)


def test_without_a_compiler_the_message_names_the_way_out(crank, monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    c_compilation._compiler.cache_clear()
    with pytest.raises(InputError, match="compiled=False"):
        simulate(engine_model("slider_crank"), duration="1 ms", compiled=True, tolerance=1e-6)
    c_compilation._compiler.cache_clear()


def test_dense_output_has_the_method_s_accuracy(ball):
    run = simulate(ball, duration="1 s", tolerance=1e-10, parameters={"restitution": 1.0})
    times = np.linspace(0, 0.45, 50)
    between = run.at(times)
    assert np.allclose(between["vertical.travel"], 1.1 - 9.81 * times**2 / 2, rtol=0, atol=1e-13)
    middle = run.impacts[0].t + np.linspace(0, 1, 200) * run.impacts[0].duration
    energy = run.at(middle)["energy"]
    assert np.max(np.abs(energy - energy[0])) < 1e-8 * 9.81
    assert np.array_equal(run.at(run.t)["vertical.speed"], run["vertical.speed"])
    with pytest.raises(ValueError, match="outside the run"):
        run.at([1.5])


@pytest.mark.parametrize(
    "norm", [lambda e: explicit_step._norm([e], 1.0, of_each=False), lambda e: implicit_step._norm(e, 1.0, 0 * e)]
)
def test_bodies_that_err_nothing_do_not_excuse_the_two_that_collide(norm):
    """Of few entries the error is the root of their mean square; more than eight dilute it no further."""
    few, more, many = (ca.vertcat(ca.DM([3.0, 4.0]), ca.DM.zeros(n)) for n in (0, 6, 98))
    assert float(norm(few)) == pytest.approx(math.sqrt(25 / 2), rel=1e-14)
    assert float(norm(more)) == pytest.approx(math.sqrt(25 / 8), rel=1e-14)
    assert float(norm(many)) == float(norm(more))


# ---- starts ----------------------------------------------------------------------------------------------------------


def test_a_start_that_leaves_the_surface_and_a_push_at_rest():
    model = point(lambda d, v, v0: 1e4 * d, scales=(1e-2, 1.0, 100.0, 1.0))
    run = simulate(model, duration=1.0, initial={"path.travel": "0 m", "path.speed": "1 m/s"}, tolerance=1e-6)
    assert run.impacts == ()
    assert run.engine.final["path.travel"] == pytest.approx(1.0, rel=1e-12)
    # At rest steps grow; K = 9.81 N/m from x = -1 m, pushed by 0.1 N for 1.2 s of 10 s: it swings by 2 P/K sin(w 1.2/2) afterwards.
    k, push = 9.81, 0.1
    model = point(
        lambda d, v, v0: k * d * (1 + 0 * v0), push=lambda t, x, v: -k + ca.if_else((t > 5) * (t < 6.2), push, 0), scales=(1.0, 1.0, 10.0, 1.0),
    )  # fmt: skip
    run = simulate(model, duration=10.0, tolerance=1e-8, initial={"path.travel": "-1 m"})
    assert np.max(np.abs(run["path.travel"][run.t < 5] + 1)) < 1e-12
    x, v = run.engine.final["path.travel"] + 1, run.engine.final["path.speed"]
    amplitude = math.hypot(x, v / math.sqrt(k))
    assert amplitude == pytest.approx(2 * push / k * abs(math.sin(math.sqrt(k) * 0.6)), rel=1e-5)


def test_runs_of_one_model_side_by_side_do_not_disturb_each_other(ball):
    heights = [f"{0.5 + 0.1 * i} m" for i in range(8)]

    def rows(height):
        return simulate(ball, duration="5 s", tolerance=1e-9, parameters={"drop_height": height}).engine.history.rows

    alone = list(map(rows, heights))
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(rows, heights))
    assert all(np.array_equal(a, b) for a, b in zip(alone, together, strict=True))
    assert not np.array_equal(alone[0], alone[1])


def squeezed(speed, duration):
    """The ball between walls that overlap it by 1 mm on either side, elastic."""
    return simulate(
        engine_model("ball_between_walls"), duration=duration, tolerance=1e-11, parameters={"gap": "-1 mm", "restitution": 1.0, "speed": speed},
    )  # fmt: skip


def test_pairs_in_contact_at_once_and_one_that_opens_and_closes_while_the_other_is():
    run = squeezed("0.1 m/s", 0.02)
    w = math.sqrt(2e6 / 1.6)
    times = np.linspace(0, 0.02, 100)
    assert np.allclose(run.at(times)["track.travel"], 0.1 / w * np.sin(w * times), rtol=0, atol=1e-9 * 0.1 / w)
    assert [impact.duration for impact in run.impacts] == [None, None]
    # Half periods: K x^2 + m v^2 conserved; beyond 1 mm only one spring acts, from its own zero.
    run = squeezed("10 m/s", 0.1)
    two, one = math.sqrt(2e6 / 1.6), math.sqrt(1e6 / 1.6)
    middle = math.asin(1e-3 * two / 10) / two
    speed = 10 * math.cos(two * middle)
    beyond = (
        math.pi - 2 * math.atan2(2e-3 * one, speed)
    ) / one  # d'' = -one^2 d from d = 2 mm at `speed`, back to 2 mm
    half = 2 * middle + beyond
    opened = [impact.t + impact.duration for impact in run.impacts if impact.duration is not None]
    assert opened[:6] == pytest.approx([middle + i * half for i in range(6)], rel=1e-8)
    assert [impact.t for impact in run.impacts[2:8]] == pytest.approx(
        [half - middle + i * half for i in range(6)], rel=1e-8
    )
    assert run.energy_residual < 1e-9


# ---- outcomes --------------------------------------------------------------------------------------------------------


def falling(law, **options):
    return point(law, push=lambda t, x, v: -10.0 + 0 * t, scales=(1e-2, 1.0, 100.0, 1.0), **options)


def stopped(run, name):
    assert run.outcome.name == name
    assert run.outcome.message
    assert run.outcome.remedy
    assert np.all(np.isfinite(run.engine.history.rows))
    return run


def test_outcomes_come_at_the_counts_given_outside_the_law_s_range_and_where_nothing_is_finite(ball):
    run = stopped(simulate(ball, duration="1 s", max_steps=5, tolerance=1e-6), "too_many_steps")
    assert run.statistics.steps == 5
    run = stopped(simulate(ball, duration="5 s", max_events=3, tolerance=1e-6), "event_limit")
    assert run.statistics.events == 4
    model = falling(lambda d, v, v0: 1e3 * d, in_range=lambda d: d < 0.05)
    run = stopped(simulate(model, duration=1.0, tolerance=1e-6), "outside_law_range")
    assert run["surface.penetration"][-1] >= 0.05
    assert "surface" in run.outcome.message
    model = falling(lambda d, v, v0: ca.sqrt(0.01 - d) * 1e3)
    run = stopped(simulate(model, duration=1.0, tolerance=1e-6), "not_finite")
    assert -0.01 <= run.engine.final["path.travel"] < -0.0099


# ---- bad input -------------------------------------------------------------------------------------------------------


def faults_of(model, **arguments):
    with pytest.raises(InputError) as error:
        simulate(model, **{"duration": "1 s", **arguments})
    return {fault.where: str(fault) for fault in error.value.faults}


def test_all_faults_of_an_input_come_at_once(ball):
    faults = faults_of(
        ball,
        duration="-1 s",
        tolerance=0.5,
        method="rk4",
        parameters={
            "mas": "1 kg", "mass": "-1 kg", "gravity": "3 m", "drop_height": 1.0, "restitution": 1.5,
            "approach_floor": "1 knot",
        },
        initial={"vertical.speed": 3.0, "sideways.speed": "1 m/s", "vertical.travel": "1 kg"},
    )  # fmt: skip
    assert set(faults) == {
        *("duration", "tolerance", "rk4", "mas", "mass", "gravity", "drop_height", "restitution", "approach_floor"),
        *("vertical.speed", "sideways.speed", "vertical.travel"),
    }
    assert "did you mean mass" in faults["mas"]
    assert "m/s^2" in faults["gravity"]
    assert "1 m" in faults["drop_height"]
    for edge in (1e-13, 1e-1):
        assert simulate(ball, duration="1 s", tolerance=edge).outcome.finished


NONE = {
    "duration": [0, -1.0, math.nan, math.inf, "0 s", "1 m", "soon", None, True],
    "tolerance": [0, 9e-14, 0.11, -1e-6, math.nan, "1e-6", True],
    "mass": ["nan kg", "inf kg", (math.nan, "kg"), (math.inf, "kg"), (1.0,), ("1", "kg"), None, True, "kg"],
}


@each(("name", "value"), [(name, value) for name, values in NONE.items() for value in values])
def test_durations_tolerances_and_values_that_are_none(ball, name, value):
    assert name in faults_of(ball, **({"parameters": {"mass": value}} if name == "mass" else {name: value}))


def test_an_exponent_goes_with_its_stiffness(ball):
    alone = faults_of(ball, parameters={"exponent": 1.1})
    assert "the same number in another unit is another stiffness" in alone["stiffness"]
    assert "N/m^1.1" in faults_of(ball, parameters={"exponent": 1.1, "stiffness": "1e9 N/m^1.5"})["stiffness"]
    assert "stiffness" in faults_of(ball, parameters={"exponent": 1.1, "stiffness": "1e9 N/m^exponent"})
    assert "stiffness" in faults_of(ball, parameters={"stiffness": "1e9 N/m^1.1"})
    both = simulate(
        ball, duration="1 s", parameters={"exponent": 1.1, "stiffness": "1e9 N/m^1.1", "restitution": 1.0}, tolerance=1e-6,
    )  # fmt: skip
    n, K = 1.1, 1e9
    depth = closed_forms.depth_with_gravity(K, n, 1, closed_forms.drop_speed(1, "9.81"), "9.81")
    assert both.impacts[0].peak_penetration == pytest.approx(depth, rel=1e-5)


def test_values_in_other_units_are_the_same_run(ball):
    first = simulate(ball, duration="1 s", parameters={"mass": "2 kg", "drop_height": (50, "cm")}, tolerance=1e-6)
    second = simulate(ball, duration="1000 ms", parameters={"mass": "2000 g", "drop_height": "0.5 m"}, tolerance=1e-6)
    assert np.array_equal(first.engine.history.rows, second.engine.history.rows)


def test_outside_the_recommended_range_is_a_warning(crank):
    run = simulate(crank, duration="1 ms", parameters={"restitution": 0.5}, tolerance=1e-6)
    assert any("restitution = 0.5" in warning and "recommended" in warning for warning in run.warnings)
    assert not any("recommended" in warning for warning in simulate(crank, duration="1 ms", tolerance=1e-6).warnings)


def test_a_derived_constant_without_a_value_is_bad_input_and_geometry_that_can_just_be_is_accepted(crank):
    """K = 4/3 E* sqrt(R): of a modulus near the largest double it is none, and that is where all that follow from it come from."""
    ((where, text),) = faults_of(crank, parameters={"youngs_modulus": "1.7e308 Pa"}).items()
    assert where == "slider_pin_K"
    for part in ("finite constant", "inf, the value of 4 * slider_pin_E_eff * ca.sqrt(slider_pin_R_eff) / 3 at ", "slider_pin_R_eff = 0.19",
                 "follows from youngs_modulus = 1.7e+308 Pa, poissons_ratio = 0.3, clearance = 0.5 mm, bush_radius = 10 mm"):  # fmt: skip
        assert part in text
    assert crank.check({"clearance": "9.999 mm"})[0] is not None
    assert crank.check({"clearance": "10 mm", "bush_radius": "10.001 mm"})[0] is not None
    assert crank.check({"clearance": "10 mm"})[0] is None  # a pin of no radius


@pytest.mark.parametrize(
    ("scene", "given", "found"),
    [
        ("slider_crank", {"clearance": "0.5 m"}, "-0.49 m, of bush_radius = 10 mm and clearance = 0.5 m"),
        ("slider_crank", {"clearance": "6 mm", "bush_radius": "5 mm"}, "-0.001 m, of bush_radius = 5 mm and clearance = 6 mm"),
        ("ball_in_socket", {"clearance": "1 m"}, "-0.975 m, of clearance = 1 m and socket_radius = 25 mm"),
        ("ball_bearing", {"ball_diameter": "1 m"}, "ball_diameter = 1 m and clearance = "),
    ],
)  # fmt: skip
def test_geometry_that_cannot_be_names_both_lengths(scene, given, found):
    """A pin, a ball or a race without a radius, with and without a law that would notice."""
    ((where, text), *_) = faults_of(engine_model(scene), parameters=given).items()
    assert "radius" in where and where.startswith("pair ")
    assert found in text and "(0, inf) m" in text


# ---- the solution ----------------------------------------------------------------------------------------------------


def test_one_line_says_how_it_went_and_csv_every_step(ball, tmp_path):
    run = simulate(ball, duration="1 s", tolerance=1e-6)
    text = str(run)
    assert text.startswith("finished: 1 s in ")
    assert "1 impact," in text
    assert "energy closed to" in text
    path = run.to_file(tmp_path / "run.csv")
    head = path.read_text().splitlines()[0].split(",")
    assert head[:3] == ["t [s]", "vertical.travel [m]", "vertical.speed [m/s]"]
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    assert np.array_equal(table[:, 0], run.t)
    assert np.array_equal(table[:, 1], run["vertical.travel"])
    with pytest.raises(InputError, match="overwrite"):
        run.to_file(path)
    run.to_file(path, overwrite=True)
    assert [file.name for file in tmp_path.iterdir()] == ["run.csv"]


def test_npz_there_and_back(crank, tmp_path):
    run = simulate(crank, duration="1 ms", tolerance=1e-6)
    path = run.save(tmp_path / "run.npz")
    again = Solution.load(path)
    assert list(again) == list(run)
    assert all(np.array_equal(again[name], run[name]) for name in ("t", *run))
    for name in ("outcome", "statistics", "impacts", "energy_residual", "warnings", "settings"):
        assert getattr(again, name) == getattr(run, name), name
    assert again.engine.final == run.engine.final
    assert again.engine.model.module.PARAMETERS == crank.module.PARAMETERS
    with pytest.raises(ValueError, match="simulate again"):
        again.at([0.0])
    with pytest.raises(FileExistsError):
        run.save(path)
