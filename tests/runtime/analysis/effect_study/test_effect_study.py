"""What effects cost and change, against closed forms: an oscillator with springs and forces that matter, that do not, and that cancel."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import study_effects
from hertzwerk.runtime.analysis.effect_study import output_errors
from hertzwerk.runtime.analysis.effect_study.compared_outputs import automatic, chosen
from hertzwerk.runtime.analysis.effect_study.leaving_out import leave_out
from hertzwerk.runtime.analysis.effect_study.output_errors import Bench, Case, Number
from hertzwerk.runtime.analysis.effect_study.smallest_scene import smallest
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.loading import engine_model

MASS, STIFFNESS, START = 2.0, 50.0, 0.1
TINY, WHISPER = 1e-3, 1e-9  # of the stiffness
DURATION = 7.3  # s, no whole number of periods


def oscillator(*effects) -> hd.Scene:
    block = hd.Body("block", hd.Parameter("mass", "kg", MASS))
    start = hd.Parameter("start", "m", START)
    spring = hd.JointSpring("spring", "slide", hd.Parameter("stiffness", "N/m", STIFFNESS))
    return hd.Scene(
        hd.Mechanism("oscillator", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),)), effects=(spring, *effects),
        start=hd.Start(position={"slide": start}), scales=hd.Scales(length=start, speed=hd.Parameter("pace", "m/s", 1)),
    )  # fmt: skip


def spring(name: str, part: float) -> hd.JointSpring:
    return hd.JointSpring(name, "slide", hd.Parameter(f"{name}_stiffness", "N/m", part * STIFFNESS))


def force(name: str, part: float) -> hd.JointForce:
    """One that shifts the position of rest by a part of the start."""
    return hd.JointForce(name, "slide", hd.Parameter(f"{name}_force", "N", part * STIFFNESS * START))


SPRINGS = oscillator(
    spring("tiny", TINY), spring("whisper", WHISPER), hd.EnergyLedger(),
)  # fmt: skip
SPEED, MEAN = "max.slide.speed", "mean.slide.travel"


@pytest.fixture(scope="module")
def springs():
    return study_effects(SPRINGS, duration=DURATION, outputs=("peak_acceleration", SPEED, MEAN))


def test_a_spring_in_parallel_changes_what_it_does_in_closed_form_within_the_errors(springs):
    rows = {row.effect: row for row in springs.rows}
    (stiff, without) = (STIFFNESS * (1 + part) for part in (TINY + WHISPER, WHISPER))
    omega = math.sqrt(stiff / MASS)
    numbers = {name: number.value for name, number in springs.numbers.items()}
    assert numbers["peak_acceleration"] == pytest.approx(START * omega**2, rel=1e-12)
    assert numbers[SPEED] == pytest.approx(START * omega, rel=1e-7)
    assert numbers[MEAN] == pytest.approx(START * math.sin(omega * DURATION) / (omega * DURATION), rel=1e-6)
    changes = rows["tiny"].changes
    assert changes["peak_acceleration"].relative == pytest.approx(without / stiff - 1, rel=1e-7)
    assert changes[SPEED].relative == pytest.approx(math.sqrt(without / stiff) - 1, abs=changes[SPEED].noise)
    assert 0 < changes[SPEED].noise < 1e-5
    assert not rows["spring"].changes["peak_acceleration"].why
    omega = math.sqrt(STIFFNESS * (1 + TINY + WHISPER) / MASS)
    for name, exact in (
        ("peak_acceleration", START * omega**2), (SPEED, START * omega), (MEAN, START * math.sin(omega * DURATION) / (omega * DURATION)),
    ):  # fmt: skip
        number = springs.numbers[name]
        assert abs(number.value - exact) <= number.error < 1e-4 * abs(exact), name


def test_changes_below_the_error_and_of_no_acceleration_count_as_none(springs):
    """A spring of 1e-9 of the stiffness is in the equations, and below the error of the runs."""
    (row,) = (row for row in springs.rows if row.effect == "whisper")
    assert not row.notes
    change = row.changes[SPEED]
    assert (change.relative, change.why) == (None, "below error")
    assert change.noise > WHISPER
    (row,) = (row for row in springs.rows if row.effect == "energy_ledger")
    assert {(change.relative, change.noise) for change in row.changes.values()} == {(None, 0.0)}
    assert "same accelerations" in row.notes[0]


def test_without_an_estimate_of_the_error_it_would_be_a_number(monkeypatch):
    """The seeded fault of the one above: every difference between two runs would then be taken for what an effect does."""
    monkeypatch.setattr(output_errors, "SAFETY", 0.0)
    monkeypatch.setattr(output_errors, "ROUNDING", 0.0)
    study = study_effects(oscillator(spring("whisper", WHISPER)), duration=DURATION, outputs=(SPEED,))
    (row,) = (row for row in study.rows if row.effect == "whisper")
    assert row.changes[SPEED].relative is not None


def test_costs_are_those_of_the_modules(springs):
    rows = {row.effect: row for row in springs.rows}
    headers = [engine_model(SPRINGS, without=gone).module.__doc__ for gone in ((), ("tiny",))]
    whole, without = (int(re.search(r"Operations: flight (\d+)", header)[1]) for header in headers)
    assert springs.cost.flight == whole
    assert rows["tiny"].cost.flight == whole - without > 0
    assert (rows["tiny"].cost.contact, rows["tiny"].cost.states, rows["tiny"].cost.events) == (0, 0, 0)
    assert all(row.share.low <= row.share.median <= row.share.high < 1 for row in springs.rows)


# -- the smallest scene ------------------------------------------------------------------------------------------------


def test_two_forces_that_cancel_go_together_and_two_small_ones_do_not():
    """Each of `pull` and `push` alone shifts the oscillation by 30 %, both together by nothing; each breath by 0.7 %, both by 1.4 %."""
    scene = oscillator(force("pull", 0.3), force("push", -0.3), force("breath", 7e-3), force("draught", 7e-3))
    study = study_effects(scene, duration=3.0, outputs=("amplitude.slide.travel",), within=0.01)
    alone = {row.effect: row.changes["amplitude.slide.travel"].relative for row in study.rows}
    shifted = 1 - 0.014  # amplitude of the whole scene over the start
    assert alone["pull"] == pytest.approx(0.3 / shifted, rel=1e-5)
    assert alone["push"] == pytest.approx(-0.3 / shifted, rel=1e-5)
    assert alone["breath"] == pytest.approx(alone["draught"], rel=1e-5)
    assert alone["breath"] == pytest.approx(7e-3 / shifted, rel=1e-5)
    actual = study.smallest
    assert set(actual.left_out) in ({"pull", "push", "breath"}, {"pull", "push", "draught"})
    assert actual.change == pytest.approx(7e-3 / shifted, rel=1e-4)
    assert study.record()["smallest"] == list(actual.effects)
    assert actual.complete


def searched(changes, within, following=None, most=80):
    """The search on changes that add up."""
    names = tuple(changes)
    goes = following or {name: frozenset({name}) for name in names}
    return smallest(names, within, goes, lambda gone: abs(sum(changes[name] for name in gone)), most)


def test_the_search_tries_all_together_keeps_what_depends_and_is_bounded():
    assert searched({"a": 1.0, "b": 1.0, "c": 1.0}, 2.0).effects == ("c",)
    assert searched({"a": 5.0, "b": -5.0, "c": 9.0}, 2.0).effects == ("c",)
    assert searched({"a": 5.0, "b": 5.0}, 2.0).left_out == ()
    following = {"contact": frozenset({"contact", "friction"}), "friction": frozenset({"friction"})}
    actual = searched({"contact": 1.0, "friction": -1.0}, 0.5, following)
    assert actual.left_out == ("contact", "friction")
    assert searched({"a": math.inf, "b": 0.0}, 0.5).effects == ("a",)
    names = {f"e{i}": 10.0 + i for i in range(12)}
    actual = searched(names, 1.0, most=20)
    assert actual.tried <= 20
    assert not actual.complete
    assert searched(names, 1.0).complete  # 12 alone, 66 pairs


# -- what depends on what ----------------------------------------------------------------------------------------------


def test_friction_goes_with_its_contact_and_nothing_else_does():
    whole, effects = engine_model("slider_crank"), ("gravity", "slider_pin", "slider_pin_friction")
    gone, model = leave_out(whole, effects, ["slider_pin"])
    assert gone == {"slider_pin", "slider_pin_friction"}
    assert [name for name, *_ in model.module.EFFECTS] == ["crank_drive", "gravity", "energy_ledger"]
    assert leave_out(whole, effects, ["gravity"])[0] == {"gravity"}


def test_an_effect_that_a_scene_cannot_do_without_says_why():
    """Without its drive the wheel would have an angle, and the scales no arm to measure it by."""
    block = hd.Body("block", hd.Parameter("mass", "kg", MASS))
    wheel = hd.Body("wheel", hd.Parameter("wheel_mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1))
    length = hd.Parameter("length", "m", START)
    scene = hd.Scene(
        hd.Mechanism(
            "driven",
            (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X), hd.Revolute("axle", hd.GROUND, wheel, axis=hd.Z)),
        ),
        effects=(
            hd.ConstantSpeed("motor", "axle", hd.Parameter("rate", "rad/s", 3)),
            hd.JointSpring("spring", "slide", hd.Parameter("stiffness", "N/m", STIFFNESS)),
        ),
        start=hd.Start(position={"slide": length}),
        scales=hd.Scales(length=length, speed=hd.Parameter("pace", "m/s", 1)),
    )
    study = study_effects(scene, duration="1 s", within=0.5)
    motor, spring_row = study.rows
    assert motor.fault.startswith("cannot be omitted: scales: found no arm")
    assert (motor.cost, dict(motor.changes)) == (None, {})
    assert spring_row.changes["amplitude.slide.travel"].relative == -1
    assert study.smallest.effects == ("motor", "spring")
    assert study.record()["rows"][0]["fault"] == motor.fault


# -- errors ------------------------------------------------------------------------------------------------------------


def test_the_error_of_a_mean_is_students_and_of_a_ladder_that_of_its_first_run_twice():
    from scipy.special import stdtrit

    values = np.array([3.0, 4.0, 4.5, 2.0, 3.3, 3.1, 5.0, 2.2, 3.9])
    number = output_errors._mean(values)
    assert number.value == pytest.approx(values.mean())
    assert number.error == pytest.approx(stdtrit(8, 0.975) * values.std(ddof=1) / 3, rel=1e-3)
    number = output_errors._converged([1.01, 1.001, 1.0])
    assert number == Number(1.0, pytest.approx(0.02))


@pytest.mark.slow
def test_past_the_horizon_two_intervals_of_a_rate_agree():
    """The mean of nine runs that part, and the blocks of a single one; without friction the crank never settles, within the horizon nothing parts."""
    case, bench = Case(engine_model("slider_crank_frictionless")), Bench("300 ms", 1e-6, "dop853", {})
    short = Bench("10 ms", 1e-6, "dop853", {})
    outputs, faults = chosen(short.simulate(case), ("impact_rate", "slider_pin.impact_rate"))
    assert faults == []
    measured = bench.measure(case, outputs)
    of_runs, of_blocks = (measured.numbers[output.name] for output in outputs)
    assert measured.past_horizon
    assert abs(of_runs.value - of_blocks.value) <= of_runs.error + of_blocks.error < 0.5 * of_runs.value
    assert min(of_runs.error, of_blocks.error) > 1
    within = short.measure(case, outputs[:1])
    assert not within.past_horizon
    assert within.numbers["impact_rate"].error < 1e-6


def test_a_run_that_does_not_finish_is_replaced_by_its_neighbour_and_said(monkeypatch):
    case, bench, run_of = Case(engine_model("pendulum")), Bench("0.5 s", 1e-6, "dop853", {}), output_errors.simulate
    outputs = automatic(bench.simulate(case))

    def measured(*failing):
        tolerances = [bench.tolerance_of(eighths) for eighths in failing]
        lost = Outcome("step_too_small", "lost", "")

        def simulate(model, **options):
            run = run_of(model, **options)
            return replace(run, outcome=lost) if options["tolerance"] in tolerances else run

        monkeypatch.setattr(output_errors, "simulate", simulate)
        return bench.measure(case, outputs)

    whole, replaced, unfinished = measured(), measured(4), measured(4, 3)
    assert (whole.failed, replaced.failed) == ((), ("lost",))
    for name, number in whole.numbers.items():
        assert abs(replaced.numbers[name].value - number.value) <= number.error
    assert (unfinished.outcome.name, unfinished.numbers) == ("step_too_small", {})
