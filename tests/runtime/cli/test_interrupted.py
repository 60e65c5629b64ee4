"""From the first accepted step on nothing is lost: a signal at any moment, a picture that fails, a full disk; and what can be refused is at once."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import re
import resource
import select
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner
from commands import called

from hertzwerk.runtime import Solution
from hertzwerk.runtime.cli import main, run_folder
from hertzwerk.runtime.engine.solution.solution import csv_size

START = [sys.executable, "-X", "importtime", "-c", "from hertzwerk.command_line import start; start()"]
IMPORTS = 40  # modules from a signal on; Matplotlib has 300
WALL_S = 120.0  # of anything that hangs


@dataclass
class Ended:
    """How a process ended that was sent a signal; what it said before it and from then on."""

    code: int
    before: str
    after: str

    @property
    def said(self) -> str:
        return self.before + self.after

    @property
    def imported(self) -> int:
        """Return how many modules were imported from the signal on."""
        return self.after.count("import time:")


class Terminal:
    """A terminal of its own for a process, and what was written on it."""

    def __init__(self, command: list[str], folder: Path) -> None:
        def prepare() -> None:
            for each in (signal.SIGINT, signal.SIGTERM):
                signal.signal(each, signal.default_int_handler if each == signal.SIGINT else signal.SIG_DFL)

        self._mine, its = pty.openpty()
        self.process = subprocess.Popen(command, cwd=folder, stdin=its, stdout=its, stderr=its, preexec_fn=prepare)
        os.close(its)
        self.said = ""

    def read(self, patience: float) -> bool:
        """Read what is there, or comes soon; whether there was anything."""
        if not select.select([self._mine], [], [], patience)[0]:
            return False
        with contextlib.suppress(OSError):  # its end of the terminal is closed
            self.said += os.read(self._mine, 65536).decode(errors="replace")
            return True
        return False

    def signal(self, number: int) -> None:
        """Send a signal while the process stands still, with all read that it wrote before."""
        self.process.send_signal(signal.SIGSTOP)
        _, status = os.waitpid(self.process.pid, os.WUNTRACED)
        if not os.WIFSTOPPED(status):  # it has ended
            self.process.returncode = os.waitstatus_to_exitcode(status)
            return
        while self.read(0):
            pass
        self.process.send_signal(number)
        self.process.send_signal(signal.SIGCONT)

    def close(self) -> None:
        while self.read(0):
            pass
        os.close(self._mine)


def signalled(
    folder: Path, arguments: list[str], moment: str | float, number: int, again: float | None = None
) -> Ended:
    """Run the command line on a terminal of its own; send a signal once it has said what matches `moment`, or after so many seconds."""
    terminal = Terminal([*START, *arguments], folder)
    began, sent, before = time.monotonic(), 0.0, ""
    while terminal.process.poll() is None:
        terminal.read(0.01)
        now = time.monotonic()
        if now - began > WALL_S:
            terminal.process.kill()
            pytest.fail(f"{arguments} does not end; it said {terminal.said[-500:]!r}")
        if not sent and (re.search(moment, terminal.said) if isinstance(moment, str) else now - began > moment):
            terminal.signal(number)
            sent, before = now, terminal.said
        if sent and again is not None and now - sent > again:
            terminal.process.send_signal(number)
            again = None
    terminal.close()
    before = before or terminal.said  # it ended before the moment came
    return Ended(terminal.process.returncode, before, terminal.said[len(before) :])


def whole(folder: Path) -> dict | None:
    """What run.json of the only run below a folder holds, None where there is no run; whatever is there is there completely."""
    runs = folder / "runs"
    if not runs.exists() or not any(runs.iterdir()):
        return None
    (run,) = runs.iterdir()
    assert not run.name.startswith(".")
    record = json.loads((run / "run.json").read_text())
    solution = Solution.load(run / "states.npz")
    assert solution.t[-1] == record["t_end"]
    assert len(solution.t) == record["rows"] > 1
    for file in run.iterdir():
        assert not file.name.startswith(".")
        if file.suffix == ".png":
            assert file.read_bytes().endswith(b"IEND\xaeB`\x82")
        if file.suffix == ".csv":
            assert file.read_text().count("\n") == record["rows"] + 1
    return record


RUN = ["run", "slider_crank"]
LONG = [*RUN, "--duration", "3600 s"]
BAR = r"slider_crank: running  \[[#-]{30}\] +\d+%"


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize(
    ("arguments", "moment", "number", "code", "outcome"),
    [
        (RUN, r"click\.core", signal.SIGINT, -signal.SIGINT, None), (RUN, "building", signal.SIGINT, -signal.SIGINT, None),
        (LONG, BAR, signal.SIGTERM, 1, "interrupted"), pytest.param(LONG, BAR, signal.SIGINT, 1, "interrupted", marks=pytest.mark.exhaustive),
        pytest.param(RUN, r"states\.csv", signal.SIGINT, 1, "finished", marks=pytest.mark.exhaustive),
        pytest.param(RUN, r"writing overview\.png", signal.SIGINT, 1, "finished", marks=pytest.mark.exhaustive),
    ],
)  # fmt: skip
def test_a_signal_ends_it_at_once_and_what_there_is_is_kept(tmp_path, arguments, moment, number, code, outcome):
    ended = signalled(tmp_path, arguments, moment, number)
    assert ended.code == code, ended.said
    assert ended.imported < IMPORTS, ended.after
    reported = whole(tmp_path)
    assert (reported and reported["outcome"]) == outcome
    if outcome is not None:
        (run,) = (tmp_path / "runs").iterdir()
        assert not (run / "slider_pin.png").exists()
        assert any("slider_pin.png is missing" in warning for warning in reported["warnings"])
        assert "slider_pin.png is missing" in ended.said.replace("\r\n", " ")


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_second_signal_later_drops_even_that(tmp_path, monkeypatch):
    """Whoever does not want what there is to be written gets away as well, and no half of it is left."""
    (tmp_path / "sitecustomize.py").write_text(
        "import time\nfrom hertzwerk.runtime.engine.solution.solution import EngineSolution\nEngineSolution.save = lambda *_: time.sleep(100)\n"
    )
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    ended = signalled(tmp_path, LONG, BAR, signal.SIGINT, again=3.0)
    assert ended.code == 130, ended.said
    assert not any((tmp_path / "runs").iterdir())


# ---- each for itself -------------------------------------------------------------------------------------------------


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Run a short scene by the command line in a folder of its own; exit code, what was said, what run.json says."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / ".cache"))

    def run(*arguments: str):
        done = CliRunner().invoke(main, ["run", "two_spheres", *arguments], catch_exceptions=False)
        return done.exit_code, done.output, whole(tmp_path)

    return run


def fails(*_, **__):
    raise ZeroDivisionError("on purpose")


@pytest.mark.parametrize(
    ("place", "name", "lost"),
    [
        (Solution, "to_file", {"states.csv"}), (Solution, "averages", set()),
        ("hertzwerk.runtime.output.plots.plot_run", "_overview", {"overview.png"}),
        pytest.param("hertzwerk.runtime.output.drawings.picture", "of_run", {"mechanism.png"}, marks=pytest.mark.exhaustive),
    ],
)  # fmt: skip
def test_a_picture_that_fails_is_reported_and_alone_missing(run, monkeypatch, place, name, lost):
    files = {"states.npz", "run.json", "states.csv"}
    files |= set() if place is Solution else {"mechanism.png", "overview.png", "spheres.png"}
    monkeypatch.setattr(
        place if place is Solution else f"{place}.{name}", *((name, fails) if place is Solution else (fails,))
    )
    without = [] if place is not Solution else ["--no-plots"]
    code, said, reported = run("--averages", *without)
    assert code == 1
    assert reported["outcome"] == "finished"
    (folder,) = Path("runs").iterdir()
    assert {path.name for path in folder.iterdir()} == files - lost
    (warning,) = (text for text in reported["warnings"] if "on purpose" in text)
    assert warning in said


def test_impacts_that_cannot_be_found_lose_no_data(run, monkeypatch):
    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.follow", fails)
    code, said, reported = run("--no-plots")
    assert code == 1
    assert reported["impacts"] == []
    assert "impacts could not be found: ZeroDivisionError" in said
    (folder,) = Path("runs").iterdir()
    assert len(Solution.load(folder / "states.npz")["energy"]) == reported["rows"]


def test_a_disk_too_full_for_the_states_still_gets_what_is_known_of_the_run(run, monkeypatch, tmp_path):
    """A real one: the system refuses to write more than 40 kB into a file, as it does on a full disk, in the middle of it."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, before[1]))
    try:
        done = called("run", "two_spheres", code=1)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    (folder,) = Path("runs").iterdir()
    assert {path.name for path in folder.iterdir()} <= {"run.json", "states.csv", "mechanism.png"}
    record = json.loads((folder / "run.json").read_text())
    assert record["outcome"] == "finished"
    assert any("states.npz could not be written" in text for text in record["warnings"])
    assert "overview.png could not be made" in done.output


def test_a_large_csv_is_written_on_request_only(run, monkeypatch):
    monkeypatch.setattr(run_folder, "CSV_LIMIT", 1000)
    code, said, reported = run("--no-plots")
    assert code == 0
    (folder,) = Path("runs").iterdir()
    assert {path.name for path in folder.iterdir()} == {"states.npz", "run.json"}
    for way in ("--table", "--grid", "to_file"):
        assert way in said
        assert any(way in text for text in reported["warnings"])
    called("run", "two_spheres", "--no-plots", "--table", "forced.csv", "--out", "forced")
    size = Path("forced.csv").stat().st_size
    assert abs(csv_size(Solution.load("forced/states.npz")) / size - 1) < 0.1


# ---- refused before anything is computed -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("command", "out"),
    [
        *(("run", out) for out in (".", "link", "file", "file/below", "full", "x" * 300)),
        *((command, "/proc/x") for command in ("run", "accuracy", "effects")),
    ],
)
def test_a_folder_that_cannot_be_written_is_refused_before_anything_is_computed(tmp_path, monkeypatch, command, out):
    monkeypatch.chdir(tmp_path)
    for place in ("single_run.SingleRun.trace", "single_run.engine_for", "built_engine.engine_for"):
        monkeypatch.setattr(f"hertzwerk.runtime.engine.run.{place}", fails)
    Path("file").touch()
    Path("target").mkdir()
    Path("link").symlink_to("target")
    Path("full").mkdir()
    Path("full/thesis.txt").touch()
    before = sorted(tmp_path.rglob("*"))
    if out == ".":
        monkeypatch.chdir("target")
    assert "--out" in called(command, "two_spheres", "--out", out, code=2).output
    assert sorted(tmp_path.rglob("*")) == before


def test_a_stop_while_a_run_is_sampled_for_pictures_keeps_the_rest(tmp_path, monkeypatch):
    from hertzwerk.runtime import load, simulate
    from hertzwerk.runtime.output.plots import plot_run

    class Stop:
        requested = False
        stage = staticmethod(lambda name: None)
        at_once = staticmethod(contextlib.nullcontext)

    stop = Stop()

    def stopped(run):
        stop.requested = True
        raise KeyboardInterrupt

    monkeypatch.setattr(plot_run, "pages", stopped)
    run = simulate(load("two_spheres"), duration="1 ms", tolerance=1e-6)
    written = run_folder.write(run, tmp_path / "run", plots=True, stopping=stop)
    assert written.files == ["states.npz", "run.json", "states.csv"]
    assert written.missing == [
        f"{name}.png is missing: it was stopped before" for name in ("overview", "mechanism", "spheres")
    ]
