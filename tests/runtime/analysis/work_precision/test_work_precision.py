"""What accuracy costs and buys: fits on data with known answers, and studies of linear motions whose states and growth are known in closed form."""

import dataclasses
import json
import math
from functools import partial

import numpy as np
import pytest
import sympy as sp
from commands import called

import hertzwerk.derive as hd
from hertzwerk.runtime import simulate
from hertzwerk.runtime.analysis.work_precision import accuracy_report as accuracy_report
from hertzwerk.runtime.analysis.work_precision import reference_run as referencing
from hertzwerk.runtime.analysis.work_precision import timed_runs
from hertzwerk.runtime.analysis.work_precision import work_precision_study as work_precision
from hertzwerk.runtime.analysis.work_precision.reference_run import NoReferenceError, Problem, reference
from hertzwerk.runtime.analysis.work_precision.work_precision_study import decade_cost, order, study
from hertzwerk.runtime.engine.integration.loop.c_compilation import available
from hertzwerk.runtime.loading import engine_model

RATE, SWING = 2.0, 3.0  # 1/s, rad/s
METHODS, ACCURACIES = ("dop853", "esdirk"), (1e-3, 1e-5, 1e-7)


def scene():
    """A block of 1 kg at an unstable point, pushed so that it swings there as cos(w t) all the same, while any error grows as e^(rate t).

    With another sign of `push`, and drag, it is a damped oscillator.
    """
    size, mass = hd.Parameter("size", "m", 1), hd.Parameter("mass", "kg", 1)
    push, drag, w = (
        hd.Parameter("push", "N/m", RATE**2), hd.Parameter("drag", "N s/m", 0), hd.Parameter("w", "rad/s", SWING),
    )  # fmt: skip
    swung = (push + mass * w**2) * size * sp.cos(w * hd.T)
    force = push * hd.coordinate_of("slide") - drag * hd.speed_of("slide") - swung
    return hd.Scene(
        hd.Mechanism("swinging_block", (hd.Prismatic("slide", hd.GROUND, hd.Body("block", mass), axis=hd.X),)),
        effects=(hd.JointForce("force", "slide", force),),
        start=hd.Start(position={"slide": size}),
        scales=hd.Scales(length=size, speed=hd.Parameter("pace", "m/s", RATE)),
    )


@pytest.fixture(scope="module")
def model():
    return engine_model(scene())


@pytest.fixture(scope="module")
def unstable(model):
    return Problem(model, "4 s")


@pytest.fixture(scope="module")
def damped(model):
    return Problem(model, "4 s", parameters={"push": "-25 N/m", "drag": "4 N s/m"})


@pytest.fixture(scope="module")
def quick():
    """One round of timing, and no compiler."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timed_runs, "ROUNDS", (1, 1))
        patch.setattr(work_precision, "ready", lambda *_: False)
        yield


@pytest.fixture(scope="module")
def of_unstable(unstable, quick):
    return study(unstable, methods=METHODS, accuracies=ACCURACIES)


@pytest.fixture(scope="module")
def of_damped(damped, quick):
    return study(damped, methods=("dop853",), accuracies=ACCURACIES)


# ---- fits ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("p", [5, 8])
def test_order_and_cost_of_a_method_of_known_order(p):
    evaluations = 100 * 2.0 ** np.arange(8)
    errors = 1e3 * evaluations ** -float(p)
    assert order(errors, evaluations) == pytest.approx(p, rel=1e-9)
    assert decade_cost(errors, 1e-6 * evaluations) == pytest.approx(10 ** (1 / p), rel=1e-9)


def test_one_lucky_error_and_one_slow_run_do_not_turn_a_fit():
    evaluations = 100 * 2.0 ** np.arange(8)
    errors, times = 1e3 * evaluations**-5.0, 1e-6 * evaluations
    errors[3] *= 1e-3
    times[5] *= 4
    assert order(errors, evaluations) == pytest.approx(5, rel=0.12)
    assert decade_cost(errors, times) == pytest.approx(10**0.2, rel=0.05)


def test_errors_that_do_not_stand_apart_tell_no_cost():
    assert decade_cost([], []) is None
    assert decade_cost([1e-5, 1.1e-5, 0.9e-5], [1.0, 2.0, 3.0]) is None
    assert order([1e-5, 1e-5], [100, 200]) is None


# ---- reference -------------------------------------------------------------------------------------------------------


def test_a_reference_is_the_true_motion_within_its_uncertainty(of_unstable):
    held = of_unstable.reference
    true = np.cos(SWING * held.t)
    departure = np.abs(held.y[:, 0] - true)
    assert departure[-1] <= 3 * held.uncertainty < 1e-7
    assert held.run.settings.method != held.partner.settings.method
    assert held.horizon == math.inf
    assert held.levels[-1][1] < 1e-3 * held.levels[0][1]


def test_two_methods_that_disagree_move_the_floor(unstable, of_unstable):
    """One method starts 1e-7 beside the other: by the end that is 1e-7 cosh(rate t) apart, whatever the tolerance."""

    def disturbed(model, **options):
        beside = {"slide.travel": f"{1 + 1e-7!r} m"} if options["method"] == "rodas" else {}
        return simulate(model, **{**options, "initial": beside})

    held = reference(dataclasses.replace(unstable, solve=disturbed))
    assert held.uncertainty == pytest.approx(1e-7 * math.cosh(4 * RATE), rel=0.01)
    moved = dataclasses.replace(of_unstable, reference=held)
    assert moved.least > 1e3 * of_unstable.least
    assert len(moved.levels) < len(of_unstable.levels)
    assert any(cells[2].startswith("<") for cells in accuracy_report.rows(moved))


def test_errors_are_measured_where_the_reference_is_known(model, quick):
    """1e-13 of an error reaches 1 % at about ln(1e11)/rate; what is known to 1e-6 ends ln(1e4)/rate earlier."""
    held = reference(Problem(model, "20 s"))
    assert held.horizon < 20
    assert held.horizon - held.known == pytest.approx(math.log(1e4) / RATE, rel=0.1)
    actual = study(Problem(model, "20 s"), methods=("dop853",), accuracies=(1e-3, 1e-4))
    assert actual.shortened
    assert actual.requested == 20
    assert actual.reference.t[-1] == pytest.approx(held.known)
    assert all(row.error is not None and row.error < row.accuracy for row in actual.rows)
    assert any("run.averages()" in text for text in accuracy_report.warnings(actual))


def test_without_two_methods_that_get_there_there_is_no_reference(unstable, monkeypatch):
    monkeypatch.setitem(referencing.LIMITS, "max_steps", 3)
    with pytest.raises(NoReferenceError, match=r"dop853: .* 3 steps accepted"):
        reference(unstable)


# ---- studies ---------------------------------------------------------------------------------------------------------


def test_growth_and_horizon_of_an_unstable_motion(of_unstable):
    grows = of_unstable.growth
    assert grows.kind == "exponential"
    assert grows.rate == pytest.approx(RATE, rel=0.15)
    for row in of_unstable.rows:
        departure = of_unstable.along[row.method, row.accuracy][1][-1]
        assert row.horizon == pytest.approx(4 + math.log(0.01 / departure) / RATE, rel=0.2)
    said = accuracy_report.conclusions(of_unstable)[1]
    assert f"for {accuracy_report.seconds(grows.gained)} more" in said
    assert grows.gained == pytest.approx(math.log(10) / RATE, rel=0.15)


def test_a_damped_motion_is_unbounded(of_damped):
    assert of_damped.growth.kind == "none"
    assert all(row.horizon == math.inf for row in of_damped.rows)
    assert "unbounded" in accuracy_report.conclusions(of_damped)[1]


def test_errors_are_true_and_requests_met(of_unstable):
    for row in of_unstable.rows:
        run = simulate(
            of_unstable.problem.model, duration=4.0, accuracy=row.accuracy, method=row.method, compiled=False
        )
        travel = abs(run.engine.final["slide.travel"] - math.cos(4 * SWING))
        speed = abs(run.engine.final["slide.speed"] + SWING * math.sin(4 * SWING))
        assert row.error == pytest.approx(max(travel, speed / RATE), rel=0.02)
        assert row.error <= 10 * row.accuracy
        assert 0.1 <= row.estimate / row.error <= 10
        assert (row.steps, row.rhs_evaluations) == (run.statistics.steps, run.statistics.rhs_evaluations)
        assert row.time > run.statistics.wall_s / 20


def test_the_recommended_method_is_the_cheapest_and_the_sentence_says_so(of_unstable):
    slow, fast = METHODS
    times = {slow: 2.0, fast: 0.5}
    rows = tuple(
        dataclasses.replace(row, error=0.3 * row.accuracy, time=times[row.method] * row.accuracy**-0.1)
        for row in of_unstable.rows
    )
    actual = dataclasses.replace(of_unstable, rows=rows)
    assert actual.recommended == fast
    assert actual.relative_times[slow] == pytest.approx(4.0)
    assert actual.decade_cost == pytest.approx(10**0.1)
    assert (
        f"costs {accuracy_report.plain(actual.decade_cost)} x the time here; take {fast}"
        in accuracy_report.conclusions(actual)[0]
    )


def test_a_method_that_takes_too_long_is_said_to_and_not_tried_further(unstable, quick):
    def limited(model, **options):
        return simulate(model, **options | ({"max_steps": 5} if "accuracy" in options else {}))

    actual = study(dataclasses.replace(unstable, solve=limited), methods=("dop853",), accuracies=ACCURACIES)
    assert [row.outcome for row in actual.rows] == ["too_many_steps", "not_tried", "not_tried"]
    assert actual.recommended is None
    table = accuracy_report.rows(actual)
    assert table[0][7].startswith("more than")
    assert table[1][-1] == "not tried"
    assert "No run reached an error" in accuracy_report.conclusions(actual)[0]


def test_an_accuracy_that_rounding_forbids_is_said_to_be_with_its_floor(model, quick):
    actual = study(Problem(model, "8 s"), methods=("dop853",), accuracies=(1e-4, 1e-9))
    last = actual.rows[-1]
    assert last.outcome == "accuracy_unreachable"
    assert 1e-9 < last.floor < 1e-4
    assert accuracy_report.rows(actual)[-1][-1] == f"accuracy unreachable, floor {last.floor:.1e}"


def test_ctrl_c_ends_the_study_and_not_one_run_of_it(unstable):
    def stopped(model, **options):
        run = simulate(model, **options)
        return dataclasses.replace(run, outcome=dataclasses.replace(run.outcome, name="interrupted"))

    with pytest.raises(KeyboardInterrupt):
        study(dataclasses.replace(unstable, solve=stopped))


# ---- command ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def hertzwerk(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(timed_runs, "ROUNDS", (1, 1))
    monkeypatch.setattr(work_precision, "ready", timed_runs.ready)
    monkeypatch.setattr(
        work_precision, "study", partial(study, methods=("dop853", "auto"), accuracies=(1e-3, 1e-5, 1e-7))
    )
    return partial(called, "accuracy")


@pytest.mark.slow  # compiles, and draws
def test_the_command_prints_json_writes_a_new_folder_and_never_overwrites(hertzwerk, tmp_path):
    request = ("pendulum", "--duration", "1 s", "--json", "--out", "study")
    done = hertzwerk(*request)
    printed = json.loads(done.stdout)
    assert len(printed["rows"]) == (12 if available() else 6)
    row = {"method", "compiled", "accuracy", "error", "estimate", "steps", "rhs_evaluations", "time", "horizon"}
    assert all(row <= set(one) for one in printed["rows"])
    assert 0 < printed["reference"]["uncertainty"] < 1e-8
    assert printed["recommended"] in ("dop853", "auto")
    assert printed["decade_cost"] > 0
    assert printed["auto"][0]["share_of_time"] == {"dop853": 1.0, "esdirk": 0.0}
    assert json.loads((tmp_path / "study" / "accuracy.json").read_text())["rows"] == printed["rows"]
    assert (tmp_path / "study" / "accuracy.png").read_bytes().startswith(b"\x89PNG")
    assert "never overwrites" in hertzwerk(*request, code=2).stderr


def test_bad_input_is_reported_all_at_once(hertzwerk, tmp_path):
    done = hertzwerk("pendulum", "--set", "length", "--set", "gravity=1 kg", "--duration", "soon", code=2)
    assert all(word in done.stderr for word in ("--set", "gravity", "duration"))
    assert not list(tmp_path.glob("runs"))


def test_without_a_reference_the_command_says_why(hertzwerk, monkeypatch):
    monkeypatch.setitem(referencing.LIMITS, "max_steps", 3)
    done = hertzwerk("pendulum", "--duration", "1 s", "--json", code=1)
    printed = json.loads(done.stdout)
    assert (printed["rows"], printed["reference"], printed["recommended"]) == ([], None, None)
    assert printed["outcomes"]["dop853"]["outcome"] == "too_many_steps"


def test_rows_arrive_before_anything_is_compiled_or_repeated(damped, monkeypatch):
    """A user waited a minute for the first number."""
    events = []

    def compiled(problem, methods):
        events.append("compile")
        return False

    monkeypatch.setattr(work_precision, "ready", compiled)
    monkeypatch.setattr(work_precision, "repeat", lambda made, progress: events.append("repeat"))
    short = dataclasses.replace(damped, duration="0.1 s")
    study(short, methods=METHODS, accuracies=(1e-3, 1e-4), arrived=lambda held, rows: events.append(tuple(rows)))
    first, second, *rest = events
    assert rest == ["compile", "repeat"]
    for method, rows in zip(METHODS, (first, second), strict=True):
        assert [(row.method, row.compiled, row.accuracy) for row in rows] == [
            (method, False, 1e-3),
            (method, False, 1e-4),
        ]
        assert all(0 < row.error <= row.accuracy and row.time > 0 for row in rows)
        assert all(
            len(line) == len(accuracy_report.NUMBERS) + 2 for line in accuracy_report.first_rows(reference(short), rows)
        )
