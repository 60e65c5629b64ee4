"""Exported C libraries: the bits of the compiled path, two compilers, sanitizers, starts that follow parameters, outcomes."""

import ctypes
import shutil
import subprocess

import numpy as np
import pytest
from libraries import Library, compile_c

from hertzwerk import InputError, simulate
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.export import c_library
from hertzwerk.runtime.export.export_contents import ExportRequest
from hertzwerk.runtime.loading import engine_model

TOLERANCE, DURATION = 1e-7, 2.0


def exported(folder, target, duration, *, method="dop853", tolerance=TOLERANCE, parameters=None, outputs=(), **rest):
    model = engine_model(target) if isinstance(target, str) else target
    settings = Settings(duration, None, tolerance, method)
    requested = ExportRequest(model, parameters or {}, rest.pop("initial", {}), settings, outputs)
    c_library.write(requested, folder)
    return Library(compile_c(folder, f"{model.name}.c", shared="library.so", **rest), model.name)


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    return exported(tmp_path_factory.mktemp("ball") / "c", "bouncing_ball", DURATION)


def same_bits(library, run, simulation, rounding=0.0):
    states = [run[name][-1] for name in library.names("state")]
    outputs = [run[name][-1] for name in library.names("output")]
    assert simulation.vector("states").tolist() == states
    assert simulation.vector("outputs") == pytest.approx(outputs, rel=rounding, abs=rounding)
    assert simulation.counts()[0] == run.statistics.steps


def test_one_call_to_the_end_gives_the_bits_of_a_run(ball):
    run = simulate(engine_model("bouncing_ball"), duration=DURATION, tolerance=TOLERANCE, method="dop853")
    simulation = ball.simulation()
    assert simulation.run(DURATION) == 0
    same_bits(ball, run, simulation)
    balance = (ctypes.c_double * 3)()
    assert simulation("balance", balance) == 0
    assert balance[:] == pytest.approx((0, 9.81 * 1.0, 9.81 * 1.1), rel=1e-2, abs=1e-4)  # a fall of 1 m, from 1.1 m
    assert balance[0] > 0
    latest, last = simulation.latest(), run.impacts[-1]
    assert (latest.count, latest.begin, latest.approach_speed) == (len(run.impacts), last.t, last.speed)


def test_parameters_and_start_are_followed_as_in_a_run(ball):
    options = {"drop_height": 0.7, "restitution": 0.6, "radius": 0.08}
    texts = {"drop_height": "0.7 m", "restitution": 0.6, "radius": "80 mm"}
    settings = {"duration": DURATION, "tolerance": TOLERANCE, "method": "dop853", "parameters": texts}
    simulation = ball.simulation(**options)
    assert simulation.run(DURATION) == 0
    same_bits(ball, simulate(engine_model("bouncing_ball"), **settings), simulation)
    simulation = ball.simulation(**options)
    assert simulation("set_start", ball.find("start", "vertical.speed"), 1.5) == 0
    assert simulation.run(DURATION) == 0
    run = simulate(engine_model("bouncing_ball"), **settings, initial={"vertical.speed": "1.5 m/s"})
    same_bits(ball, run, simulation)


def test_communication_points_and_stops_at_impacts(ball):
    whole, parts, stopped = (ball.simulation() for _ in range(3))
    whole.run(DURATION)
    assert parts.run(DURATION, np.linspace(0, DURATION, 57)[1:]) == 0
    assert parts.time == DURATION
    assert parts.vector("states") == pytest.approx(whole.vector("states"), abs=1e-6)
    assert stopped("start", DURATION) == 0
    assert stopped("set_limits", 1e6, 2.0) == 0  # of each call, in which one contact begins
    times = []
    while (code := stopped("advance", DURATION, 1)) == 1:
        times.append(stopped.time)
        assert stopped.latest().begin == stopped.time
    assert code == 0
    assert len(times) == whole.latest().count > 2
    assert stopped.vector("states").tolist() == whole.vector("states").tolist()  # stops change nothing
    assert times[0] == pytest.approx((2 * 1.0 / 9.81) ** 0.5, rel=1e-6)  # of a fall


def test_a_copy_of_the_memory_is_a_copy_of_the_simulation_in_mid_contact(ball):
    simulation = ball.simulation()
    simulation("start", DURATION)
    assert simulation("advance", DURATION, 1) == 1
    assert simulation("advance", simulation.time + 1e-4, 0) == 0
    assert simulation.latest().touching == 1
    kept = bytes(simulation.memory)
    assert simulation("advance", DURATION, 0) == 0
    other = ball.simulation()
    ctypes.memmove(other.memory, kept, len(kept))
    assert other.latest().touching == 1
    assert other("advance", DURATION, 0) == 0
    assert bytes(other.memory) == bytes(simulation.memory)


def test_bad_arguments_and_outcomes_are_codes_with_text(ball):
    simulation = ball.simulation()
    assert simulation("advance", 1.0, 0) == -1
    assert simulation("set_parameter", 99, 1.0) == simulation("set_parameter", 0, float("nan")) == -2
    assert simulation("start", -1.0) == -2
    mass = ball.find("parameter", "mass")
    assert simulation("set_parameter", mass, -1.0) == 0
    assert simulation("start", DURATION) == -3
    assert simulation("set_parameter", mass, 1.0) == simulation("start", DURATION) == 0
    for value, code in ((0.0, -3), (1.0, 0)):  # the coefficient of restitution lies in (0, 1]
        assert ball.simulation(restitution=value)("start", DURATION) == code
    assert simulation("set_limits", 5.0, 100.0) == 0
    assert simulation.run(DURATION) == -10
    assert simulation("advance", DURATION, 0) == -10
    assert "max_steps" in simulation.text(-10)
    assert simulation("set_limits", 1e6, 2.0) == 0
    assert simulation.run(DURATION) == -9
    assert ball.find("parameter", "no such") == -1
    small = (ctypes.c_double * 4)()
    assert ball.function("create", ctypes.c_void_p)(small, ctypes.c_size_t(32)) is None
    sunk = ball.simulation()
    assert sunk("set_start", ball.find("start", "vertical.travel"), -5.0) == 0
    assert sunk("start", DURATION) == -4


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_it_compiles_without_a_warning_and_runs_under_sanitizers(compiler, ball, tmp_path):
    if shutil.which(compiler) is None:
        pytest.skip(f"NOT TESTED: exported C with {compiler}, as there is none")
    flags = ("-g0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    for file in ball.folder.iterdir():
        shutil.copy(file, tmp_path)
    program = compile_c(tmp_path, "bouncing_ball.c", "main.c", compiler=compiler, flags=flags)
    said = subprocess.run([program], capture_output=True, text=True)
    assert (said.returncode, said.stderr) == (0, "")
    assert said.stdout.endswith("good\n")


@pytest.mark.slow
def test_slider_crank_closes_its_start_under_other_parameters(tmp_path):
    library = exported(tmp_path / "c", "slider_crank", 0.004)
    run = simulate(engine_model("slider_crank"), duration=0.004, tolerance=TOLERANCE, method="dop853")
    simulation = library.simulation()
    assert simulation.run(0.004) == 0
    same_bits(library, run, simulation)
    turned = library.simulation(crank_radius=0.06, rod_length=0.15)
    assert turned("start", 0.004) == 0
    texts = {"crank_radius": "60 mm", "rod_length": "150 mm"}
    run = simulate(engine_model("slider_crank"), duration=0.004, tolerance=TOLERANCE, method="dop853", parameters=texts)
    assert turned.vector("states") == pytest.approx([run[name][0] for name in library.names("state")], rel=1e-11)


def test_models_that_cannot_be_exported_are_refused_by_name(tmp_path, capsys):
    with pytest.raises(InputError, match="SUNDIALS"):
        exported(tmp_path / "c", "bouncing_ball", 1.0, method="cvodes")
    occupied = tmp_path / "occupied"
    occupied.mkdir()
    (occupied / "mine").write_text("kept")
    command = ["export", "bouncing_ball", "--c", str(occupied), "--output", "floor.colour", "--tolerance", "7"]
    assert main.main(command, standalone_mode=False) == 2
    said = capsys.readouterr().err
    for fault in ("--c: found", "never overwrites", "occupied", "floor.colour", "1e-13..0.1"):
        assert fault in said
    assert [path.name for path in occupied.iterdir()] == ["mine"]
    assert main.main(["export", "bouncing_ball"], standalone_mode=False) == 2
    assert "--c DIR" in capsys.readouterr().err
