"""Where a run ends before its end: a stall, a limit of its own, the time of the call, which compiling shares."""

from types import SimpleNamespace

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import gonthier, power, smooth_coulomb
from hertzwerk.runtime import load, simulate, simulation
from hertzwerk.runtime.engine.accuracy.error_estimate import CHECK
from hertzwerk.runtime.engine.integration.loop import automatic_compilation, c_compilation, chunk
from hertzwerk.runtime.engine.integration.loop.chunk import STALL, STALLED
from hertzwerk.runtime.engine.model import caller
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.engine.solution.outcome import outcome
from hertzwerk.runtime.system import interrupt

SLOW = 60.0  # s that the compiler takes
SHORT = {"duration": "10 s", "tolerance": 1e-8, "wall_time": 1.0}


@pytest.fixture
def crank(tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    return load("slider_crank_frictionless")


@pytest.fixture
def slow_compiler(tmp_path, monkeypatch):
    """A compiler that takes a minute, to be started at once, and the file that it then writes."""
    script, done = tmp_path / "slow_cc", tmp_path / "done"
    text = f'#!/bin/sh\n[ "$1" = --version ] && echo 1.0 && exit 0\nsleep {SLOW}\ntouch {done}\n'
    script.write_text(text, encoding="utf-8")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    c_compilation._compiler.cache_clear()
    for name, value in (("LOOK", 0.0), ("GAIN", 1e9), ("SURE", 0.0)):
        monkeypatch.setattr(automatic_compilation, name, value)
    yield done
    c_compilation._compiler.cache_clear()


@pytest.mark.parametrize("given", [{"tolerance": 1e-8}, {"tolerance": None, "accuracy": 1e-6}])
@pytest.mark.parametrize("how", ["auto", True])
def test_a_compiler_is_stopped_when_the_time_of_the_call_is_over(crank, slow_compiler, how, given):
    run = simulate(crank, **SHORT | given, compiled=how)
    assert not slow_compiler.exists()
    assert run.outcome.name == "wall_time_limit"
    assert "wall_time = 1 s" in run.outcome.message
    assert not run.settings.compiled
    assert run.engine.t_end > 0
    assert np.all(np.isfinite(run.engine.history.rows))


def test_the_time_is_that_of_all_runs_of_a_request(crank, monkeypatch):
    """By a clock that counts calls of the loop: a limit that each run keeps ends all of them."""
    calls, attempts = 0, chunk._March.attempts

    def counted(self):
        nonlocal calls
        calls += 1
        return attempts(self)

    monkeypatch.setattr(chunk._March, "attempts", counted)
    clock = SimpleNamespace(perf_counter=lambda: float(calls), thread_time=lambda: float(calls))
    for module in (chunk, simulation):
        monkeypatch.setattr(module, "time", clock)
    request = {"duration": "24 ms", "accuracy": 1e-4, "compiled": False}
    assert simulate(crank, **request).outcome.finished
    limit, calls = 0.8 * calls, 0
    assert simulate(crank, **request, wall_time=limit).outcome.name == "wall_time_limit"
    assert limit - 1 <= calls <= limit  # another call would lead beyond it


def test_nothing_is_found_of_a_run_that_the_limit_stops(crank, monkeypatch):
    """States at which it would be compared with others took seconds of a large model. On the old code they were found nevertheless."""
    between, read = History.between, []
    monkeypatch.setattr(
        History, "between", lambda self, *given, **named: read.append(given) or between(self, *given, **named)
    )
    request = {"duration": "24 ms", "accuracy": 1e-6, "compiled": False}
    stopped = simulate(crank, **request, wall_time=1e-9)
    assert stopped.outcome.name == "wall_time_limit"
    assert 0 < stopped.engine.t_end < 24e-3
    assert not read
    assert simulate(crank, **request).outcome.finished
    assert read


def test_builds_during_a_run_end_with_its_time_limit(crank, monkeypatch):
    """Steps that choose between methods take a second to build of a large model: as they begin the time runs out."""
    late, built, loaded = 0.0, [], load(crank.name)
    clock = SimpleNamespace(perf_counter=lambda: late, thread_time=lambda: late)

    def use_choice(self, poll):
        nonlocal late
        late = 10.0
        interrupt.poll()  # as what builds does now and then
        built.append(self)

    for module in (chunk, simulation):
        monkeypatch.setattr(module, "time", clock)
    monkeypatch.setattr(automatic_compilation.AutomaticCallers, "use_choice", use_choice)
    monkeypatch.setattr(chunk._March, "_fails", lambda self, states: True)
    run = simulate(loaded, duration="24 ms", accuracy=1e-4, compiled=False, wall_time=5)
    assert run.outcome.name == "wall_time_limit"
    assert not built


def test_max_steps_is_a_limit_of_each_run(crank):
    options = {"duration": "12 ms", "accuracy": 1e-5, "compiled": False}
    whole = simulate(crank, **options)
    assert whole.error.runs > 1
    steps = whole.statistics.steps
    limited = simulate(crank, **options, max_steps=2 * steps)  # all of them take more
    assert limited.outcome.finished
    assert np.array_equal(limited.engine.history.rows, whole.engine.history.rows)
    cut = simulate(crank, **options, max_steps=steps + 1)  # the run that checks it takes more
    assert cut.outcome.name == "too_many_steps"
    assert f"max_steps = {steps + 1:,}" in cut.outcome.message
    assert f"the run at tolerance {whole.settings.tolerance / CHECK:.2g}" in cut.outcome.message


def test_without_a_limit_no_count_ends_a_run(monkeypatch):
    """Two million steps are counted, more than were ever allowed, of a motion that goes on."""
    ball, evaluate = load("bouncing_ball"), caller.Caller.__call__
    options = {"duration": "5 s", "tolerance": 1e-12, "method": "dopri5", "compiled": False}
    plain = simulate(ball, **options)
    assert plain.statistics.steps > 1000
    layout, counted = plain.engine.history.integrator.layouts.state, 2_000_000

    def counts(self):
        results = evaluate(self)
        states = results[0]
        if states.shape[0] == 256 and states[0, layout["steps"]] < counted:
            states[:, layout["steps"]] += counted
        return results

    monkeypatch.setattr(caller.Caller, "__call__", counts)
    run = simulate(ball, **options)
    assert run.outcome.finished
    assert run.statistics.steps == plain.statistics.steps + counted


def test_a_run_that_stands_still_is_stopped_as_a_stall(monkeypatch):
    """Every attempt is rejected: nothing but the lack of progress can end it."""
    ball, evaluate = load("bouncing_ball"), caller.Caller.__call__
    options = {"duration": "1 s", "tolerance": 1e-6, "compiled": False, "method": "dop853"}
    layout = simulate(ball, **options).engine.history.integrator.layouts.state

    def rejects(self):
        results = evaluate(self)
        states = results[0]
        if states.shape[0] == 256:
            states[:] = self.inputs[0]
            states[:, layout["accepted"]] = 0
            states[:, layout["rejected"]] += 100 * np.arange(1, 257)[:, None]
        return results

    monkeypatch.setattr(caller.Caller, "__call__", rejects)
    run = simulate(ball, **options)
    assert run.outcome.name == "stalled"
    assert STALL <= run.statistics.rejected < 1.1 * STALL
    assert f"{run.statistics.rejected:,} rejected" in run.outcome.message
    assert run.outcome.remedy.count("esdirk") == run.outcome.remedy.count("rodas") == 1
    counted = simulate(ball, **options, max_steps=2 * STALL)  # a limit of one's own holds in its place
    assert counted.outcome.name == "too_many_steps"
    assert counted.statistics.rejected > 2 * STALL


def test_the_remedy_of_a_stall_names_a_method_once_and_not_its_own(monkeypatch):
    history = simulate(load("bouncing_ball"), duration="1 ms", tolerance=1e-6, compiled=False).engine.history
    options = {"tolerance": 1e-6, "t": 0.0, "steps": 0, "rejected": 0}

    def remedy(method):
        return outcome(STALLED, method, history, **options).remedy

    for stiff in ("", "take rodas or esdirk"):
        monkeypatch.setattr(
            "hertzwerk.runtime.engine.solution.outcome._method_for_steps", lambda *_, stiff=stiff: stiff
        )
        assert remedy("dopri5").count("esdirk") == remedy("dopri5").count("rodas") == 1
        assert remedy("dopri5").endswith("with a stated max_steps the run continues")
    monkeypatch.setattr("hertzwerk.runtime.engine.solution.outcome._method_for_steps", lambda *_: "")
    assert remedy("esdirk").startswith("take rodas; else change the tolerance")


# ---- where explicit steps fail -----------------------------------------------------------------------------------------


def sphere():
    """A sphere 4.3 mm deep in an inclined plane that opens: its force is released, and it is pressed anew."""
    mass, inertia, radius = (
        hd.Parameter("mass", "kg", 0.0129), hd.Parameter("inertia", "kg m^2", 2.91e-4), hd.Parameter("radius", "m", 0.0855),
    )  # fmt: skip
    body = hd.Body("ball", mass=mass, inertia=inertia)
    plane = hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Direction((-0.3948, 1, 0)))
    return hd.Scene(
        hd.Mechanism("pressed_sphere", (hd.Planar("base", hd.GROUND, body),), (plane,)),
        (
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y),
            hd.Contact("floor", power(hd.Parameter("stiffness", "N/m^2", 4.4065e8), 2), gonthier(hd.Parameter("restitution", "1", 0.3377))),
            hd.Friction("rub", "floor", smooth_coulomb(hd.Parameter("mu", "1", 0.2885), hd.Parameter("v_s", "m/s", 0.01233))),
        ),
        hd.Scales(length=radius, arm=radius, speed=hd.Parameter("pace", "m/s", 1)),
        hd.Start(
            position={"base.y": radius + hd.Parameter("above", "mm", 1.757)},
            speed={"base.x": hd.Parameter("v_x", "m/s", -0.3019), "base.angle": hd.Parameter("spin", "rad/s", 32.67)},
        ),
    )  # fmt: skip


@pytest.fixture(scope="module")
def pressed():
    return load(sphere())


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
def test_auto_turns_to_implicit_steps_where_explicit_ones_are_rejected(pressed, tolerance):
    """esdirk and rodas take some 30 steps; explicit ones are rejected for phantom ends of the contact, 9 in 10 of them."""
    options = {"duration": "0.19 s", "tolerance": tolerance, "compiled": False, "max_steps": 3000}
    run, check = simulate(pressed, **options), simulate(pressed, **options, method="esdirk")
    assert run.outcome.finished
    assert check.outcome.finished
    for name in ("base.x", "base.y", "base.angle"):
        assert run.engine.final[name] == pytest.approx(check.engine.final[name], abs=1e3 * tolerance)
    assert run.statistics.steps < 200
    assert [choice.method for choice in run.engine.choices] == ["explicit", "implicit"]


def test_auto_leaves_a_chatter_within_the_tolerance():
    """A ball that comes to rest 7 nm deep, under a tolerance of 110 nm: explicit steps land on its plane and leave it for ever."""
    radius, body = hd.Parameter("radius", "mm", 11), hd.Body("ball", hd.Parameter("mass", "kg", 0.114))
    floor = hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    scene = hd.Scene(
        hd.Mechanism("chattering_ball", (hd.Prismatic("fall", hd.GROUND, body, axis=hd.Y),), (floor,)),
        (
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y),
            hd.Contact("floor", power(hd.Parameter("stiffness", "N/m", 1.5e8), 1), gonthier(hd.Parameter("restitution", "1", 0.62))),
        ),
        hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 30)),
        hd.Start(position={"fall": radius + hd.Parameter("height", "mm", 1)}),
    )  # fmt: skip
    run = simulate(load(scene), duration="0.3 s", tolerance=1e-3, compiled=False, max_steps=3000)
    assert run.outcome.finished
    assert run.engine.final["fall.travel"] == pytest.approx(0.011 - 0.114 * 9.81 / 1.5e8, abs=1e-9)
    assert any("rejected repeatedly" in choice.reason for choice in run.engine.choices)


@pytest.mark.parametrize("output", [None, 2])
def test_an_overlap_that_opens_is_warned_of(pressed, output):
    """It is no faster than this scene, so that nothing else is said of it."""
    options = {"duration": "0.1 ms", "tolerance": 1e-6, "grid": output, "parameters": {"pace": "100 m/s"}}
    (text,) = (text for text in simulate(pressed, **options).warnings if text.startswith("floor starts"))
    assert "0.00434 m deep and opening" in text
    still = simulate(pressed, **options, initial={"base.x": "-1 m"})  # far above the plane
    assert not any("deep" in text for text in still.warnings)


def test_the_remedy_of_explicit_steps_helps(pressed):
    options = {"duration": "0.19 s", "tolerance": 1e-6, "compiled": False, "max_steps": 3000}
    run = simulate(pressed, **options, method="dop853")
    assert run.outcome.name == "too_many_steps"
    assert 'method="auto"' in run.outcome.remedy
    assert simulate(pressed, **options, method="auto").outcome.finished
