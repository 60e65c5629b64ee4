"""`hertzwerk sweep`: options, a file and Python make the same table; Ctrl-C, and what is done afterwards; bad input at once."""

import json
import os
import pty
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import xarray as xr
from commands import called

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, sweep
from hertzwerk.runtime.engine.model.build import located_laws
from hertzwerk.runtime.studies.sweeps.definition_file import form_of, read_definition_file

OPTIONS = [
    *("--over", "drop_height=0.5..1 m:3", "--over", "restitution=0.5,0.7", "--set", "radius=21 mm"),
    *("--law", "floor=flores", "--output", "floor.peak_force", "--output", "floor.impact_rate"),
    *("--duration", "1 s", "--tolerance", "1e-7"),
]
FILE = """
target = "bouncing_ball"
duration = "1 s"
tolerance = 1e-7
outputs = ["floor.peak_force", "floor.impact_rate"]
[over]
drop_height = "0.5..1 m:3"
restitution = [0.5, 0.7]
[parameters]
radius = "21 mm"
[laws]
floor = "flores"
"""


COMMAND = ("sweep",)


@pytest.mark.slow
def test_options_a_file_and_python_make_the_same_table(hertzwerk, tmp_path):
    (tmp_path / "study.toml").write_text(FILE)
    done = hertzwerk("bouncing_ball", *OPTIONS)
    assert done.stderr == ""
    assert "finished      6 rows" in done.stdout
    first = tmp_path / "runs" / "bouncing_ball-sweep-001"
    assert str(first.relative_to(tmp_path)) in done.stdout
    hertzwerk("study.toml", "--out", "filed", "--workers", "1")
    table = (first / "table.csv").read_bytes()
    assert (tmp_path / "filed" / "table.csv").read_bytes() == table
    over = {"drop_height": ["0.5 m", "0.75 m", "1 m"], "restitution": (0.5, 0.7)}
    python = sweep(
        *("bouncing_ball", over), parameters={"radius": "21 mm"}, laws={"floor": "flores"}, outputs=["floor.peak_force", "floor.impact_rate"],
        duration=1.0, tolerance=1e-7,
    )  # fmt: skip
    assert python.to_csv(tmp_path / "python.csv").read_bytes() == table


def test_json_is_one_object_and_writes_no_file(hertzwerk, tmp_path):
    done = hertzwerk("bouncing_ball", *OPTIONS, "--json")
    record = json.loads(done.stdout)
    assert (record["rows"], record["outcomes"], record["out"]) == (6, {"finished": 6}, None)
    assert record["units"]["floor.impact_rate.half_width"] == "1/s"
    assert record["table"]["restitution"] == [0.5, 0.7] * 3
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", ["csv", "parquet", "nc"])
def test_a_table_is_written_by_the_ending_of_its_file(hertzwerk, tmp_path, ending):
    hertzwerk("bouncing_ball", *OPTIONS, "--out", "a", "--workers", 1)
    done = hertzwerk("--resume", "a", "--table", f"new/t.{ending}")
    assert done.stderr == ""
    assert f"written       new/t.{ending}" in done.stdout
    python = Sweep.load("a").to_file(tmp_path / f"python.{ending}")
    if ending == "nc":
        actual, expected = (xr.load_dataset(file, engine="h5netcdf") for file in (f"new/t.{ending}", python))
        assert actual.identical(expected)
    else:
        assert (tmp_path / "new" / f"t.{ending}").read_bytes() == python.read_bytes()


def test_a_table_that_cannot_be_written_is_reported_before_a_row_is_computed(hertzwerk, tmp_path, monkeypatch):
    (tmp_path / "t.nc").touch()
    monkeypatch.setitem(sys.modules, "xarray", None)
    done = hertzwerk("bouncing_ball", *OPTIONS, "--table", "t.nc", "--workers", "few", code=2)
    assert all(text in done.stderr for text in ("t.nc, which exists", "pip install 'hertzwerk[data]'", "--workers"))
    assert [path.name for path in tmp_path.iterdir()] == ["t.nc"]


def test_a_table_that_fails_later_is_reported_and_the_rest_is_there(hertzwerk, tmp_path, monkeypatch):
    monkeypatch.setattr(Sweep, "to_file", lambda *_: (_ for _ in ()).throw(OSError("disk full")))
    done = hertzwerk("bouncing_ball", *OPTIONS, "--table", "t.nc", "--out", "a", "--workers", 1, code=1)
    assert "disk full" in done.stderr
    assert "written       t.nc" not in done.stdout
    assert len(Sweep.load("a")) == 6


def test_rows_that_fail_are_reported_and_are_another_outcome(hertzwerk):
    done = hertzwerk(
        "bouncing_ball", "--over", "mass=-1,1 kg", "--duration", "0.1 s", "--tolerance", "1e-5", "--out", "a", code=1
    )
    assert re.search(r"bad_input +1 row: mass: found -1 kg", done.stdout)


def test_a_section_on_the_command_line_is_that_of_python(hertzwerk, tmp_path):
    places = ("--section", "floor.gap = 0 falling", "--after", "0.4 s", "--grid", "5", "--history", "vertical.speed")
    arguments = ("bouncing_ball", "--over", "drop_height=0.5,1 m", "--duration", "1 s", "--tolerance", "1e-6", *places)
    hertzwerk(*arguments, "--out", "a", "--plot")
    assert (tmp_path / "a" / "sweep.png").read_bytes().startswith(b"\x89PNG")
    table = sweep(
        *("bouncing_ball", {"drop_height": "0.5,1 m"}), section="floor.gap = 0 falling", after="0.4 s", grid=5,
        histories=["vertical.speed"], duration="1 s", tolerance=1e-6,
    )  # fmt: skip
    for arrays in (table.section, table.histories):
        assert (tmp_path / "a" / f"{arrays.name}.csv").read_bytes() == arrays.to_csv(arrays.name).read_bytes()
    reported = json.loads(hertzwerk(*arguments, "--json").stdout)["arrays"]
    assert reported == {"section": table.section.record(), "histories": table.histories.record()}
    hertzwerk("--resume", "a")
    written = hertzwerk("--resume", "a", "--table", "t.csv").stdout
    assert "section and histories, as CSV has no lists: --table FILE.parquet" in " ".join(written.split())


def test_values_are_followed_on_the_command_line_as_in_python(hertzwerk, tmp_path):
    how = ("bouncing_ball", "--over", "restitution=0.5..0.9:3", "--duration", "0.6 s", "--tolerance", "1e-5")
    for way in ("up", "down"):
        hertzwerk(*how, "--continue", way, "--out", way)
        over = {"restitution": "0.5..0.9:3"}
        expected = sweep("bouncing_ball", over, duration="0.6 s", tolerance=1e-5, continued=way)
        actual = Sweep.load(way)
        assert list(actual["final.vertical.travel"]) == list(expected["final.vertical.travel"])
    assert actual["final.vertical.travel"][1] != Sweep.load("up")["final.vertical.travel"][1]
    assert "continued: found 'up'" in hertzwerk(*how, "--continue", "up", "--out", "down", code=2).stderr
    assert "up" in hertzwerk(*how, "--continue", "sideways", "--out", "c", code=2).stderr


def test_a_folder_goes_on_with_its_own_definition_and_with_no_other(hertzwerk, tmp_path):
    hertzwerk("bouncing_ball", *OPTIONS, "--out", "a")
    table = (tmp_path / "a" / "table.csv").read_bytes()
    hertzwerk("--resume", "a")
    assert (tmp_path / "a" / "table.csv").read_bytes() == table
    wider = [option.replace("1 m:3", "1 m:5") for option in OPTIONS]
    refused = hertzwerk("bouncing_ball", *wider, "--out", "a", code=2)
    assert "over.drop_height: found '0.5..1 m:5'" in refused.stderr
    hertzwerk("bouncing_ball", *wider, "--out", "a", "--widen")
    assert len(Sweep.load("a")) == 10


def test_laws_of_a_file_are_found_from_another_folder_and_a_changed_file_is_refused(hertzwerk, tmp_path, monkeypatch):
    foam = '[[law]]\nname = "foam"\nkind = "stiffness"\ntitle = "Foam"\nsource = "measured"\nform = "any"\nforce = "K*d**1.5"\n'
    (tmp_path / "foam.toml").write_text(foam + 'symbols.K = { unit = "N/m^1.5" }\n')
    by_law = ("--law", "floor=foam.toml:foam(K=2e8 N/m^1.5)", "--duration", "0.1 s")
    hertzwerk("bouncing_ball", "--over", "mass=1 kg", *by_law, "--tolerance", "1e-4", "--out", "a", "--workers", "1")
    (tmp_path / "a.toml").write_text(
        'target = "bouncing_ball"\nduration = 0.1\nlaws = {floor = "foam.toml"}\nover = {mass = "1 kg"}\n'
    )
    called("run", "bouncing_ball", *by_law, "--out", "b", "--no-plots")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert read_definition_file(tmp_path / "a.toml", sweep)["laws"] == {"floor": str(tmp_path / "foam.toml")}
    hertzwerk("--resume", "../a")
    called("run", "--continue", "../b", "--duration", "0.12 s", "--no-plots", "--out", "c")
    (tmp_path / "foam.toml").write_text((tmp_path / "foam.toml").read_text() + 'note = "twice as stiff"\n')
    refused = hertzwerk("--resume", "../a", code=2)
    assert "law_files." in refused.stderr and "foam.toml" in refused.stderr


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("foam.toml", "/data/foam.toml"),
        ("floor=foam.toml:foam(K=2 N/m^1.5, n=1.5) x my/d.toml:x", "floor=/data/foam.toml:foam(K=2 N/m^1.5, n=1.5) x /data/my/d.toml:x"),
        ("power(K=2 N/m^1.5) x /etc/d.toml(c=1)", "power(K=2 N/m^1.5) x /etc/d.toml(c=1)"),
        ("hertz x flores", "hertz x flores"),
    ],
)  # fmt: skip
def test_files_of_laws_are_seen_from_a_folder(text, there):
    assert located_laws(text, Path("/data")) == there


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], ["TARGET"]),
        (["--resume", "nowhere"], ["--resume"]),
        (["--resume", "a", "bouncing_ball", "--over", "mass=1 kg"], ["TARGET, --over beside it"]),
        (["file.toml", "--law", "a=b"], ["--law beside it"]),
        (["file.toml"], ["no such file"]),
        (["bouncing_ball", "--over", "mass=1 kg", "--json", "--plot"], ["--plot: found without a folder"]),
        (["bouncing_ball", "--over", "mass", "--sample", "few", "--workers", "x"], ["'mass'", "--sample", "--workers"]),
        (
            ["bouncing_ball", "--over", "mas=1 kg", "--output", "floor.peak", "--duration", "1 kg", "--tolerance", "x"],
            ["did you mean mass", "did you mean floor.peak_force", "'1 kg'", "'x'"],
        ),
    ],
)
def test_bad_input_is_reported_at_once_and_nothing_is_written(hertzwerk, tmp_path, arguments, message):
    done = hertzwerk(*arguments, code=2)
    for each in message:
        assert each in re.sub(r"\s+", " ", done.stderr)
    assert list(tmp_path.iterdir()) == []


def test_faults_of_form_and_of_meaning_of_a_file_come_at_once(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text('targt = "x"\nduration = true\noutputs = "a"\nsample = "3"\nover = {mass = true}\n')
    with pytest.raises(InputError) as caught:
        read_definition_file(file, sweep)
    assert {fault.where for fault in caught.value.faults} == {
        "targt", "target", "duration", "outputs", "sample", "over.mass",
    }  # fmt: skip
    assert "did you mean target?" in str(caught.value)
    file.write_text(
        'target = "bouncing_ball"\ntolerance = 7.0\noutputs = ["floor.peak"]\nsample = "3"\n'
        'over = {mass = true, drop_hight = "1..2 m:3"}\nparameters = {radios = "1 m"}\n'
    )
    with pytest.raises(InputError) as caught:
        read_definition_file(file, sweep)
    reported = {fault.where: str(fault) for fault in caught.value.faults}
    assert set(reported) == {"duration", "sample", "over.mass", "tolerance", "floor.peak", "drop_hight", "radios"}
    assert "did you mean drop_height" in reported["drop_hight"]
    assert len(caught.value.faults) == len(reported)


def test_a_file_has_the_keys_of_sweep():
    import inspect

    keys = set(inspect.signature(sweep).parameters)
    assert keys - set(form_of(sweep).model_fields) == {
        "out", "widen", "workers", "client", "functions", "progress", "compiled",
    }  # fmt: skip
    assert set(form_of(sweep).model_fields) <= keys


@pytest.mark.slow
def test_ctrl_c_keeps_what_is_done_and_says_how_to_go_on(own_folder):
    """On a terminal of 80 columns, without colours where they are not wanted."""
    arguments = [
        "sweep", "slider_crank", "--over", "clearance=0.1..0.5 mm:400", "--duration", "10 rev", "--tolerance", "1e-9",
    ]  # fmt: skip
    code = "from hertzwerk.command_line import start; start()"
    environment = {**os.environ, "COLUMNS": "80", "TERM": "xterm", "NO_COLOR": "1"}
    mine, its = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-c", code, *arguments, "--out", "a"],
        stdin=its, stdout=its, stderr=its, env=environment, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # fmt: skip
    os.close(its)
    said = b""
    while not re.search(rb"rows  \[#*-*\] +[1-9]\d* ?%  \d+:\d\d to go", said):
        said += os.read(mine, 65536)
    process.send_signal(signal.SIGINT)
    while True:
        try:
            chunk = os.read(mine, 65536)
        except OSError:
            break
        if not chunk:
            break
        said += chunk
    os.close(mine)
    assert process.wait(60) == 1
    text = said.decode()
    assert "\x1b" not in text
    assert all(len(line) <= 80 for part in text.split("\n") for line in part.split("\r"))
    assert "hertzwerk sweep --resume a" in re.sub(r"\s+", " ", text)
    count = len(Sweep.load("a"))
    assert 0 < count < 400
    assert Sweep.load("a").outcome.message == f"{400 - count} of 400 rows are missing"
