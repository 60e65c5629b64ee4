"""A million rows: made, known and read a few at a time, whatever their number, and resumed wherever they ended.

What is counted is what is made and what is alive, not seconds or bytes.
"""

import gc
import json
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from benchmarks import rows
from commands import called

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, sweep
from hertzwerk.runtime.engine.inputs.inputs_by_row import NO_CHOICES
from hertzwerk.runtime.studies.sweeps import parameter_sweep, stored_rows, sweep_store, sweep_table
from hertzwerk.runtime.studies.sweeps.points.design_points import Design, read_design
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import Keys, as_text, axes_of, design_of, read_definition
from hertzwerk.runtime.studies.sweeps.rows.row import Row

MILLION = {"drop_height": "0.5..1.5 m:1000", "restitution": "0.5..0.9:1000"}
BALL = {"duration": "0.1 s", "tolerance": 1e-6, "compiled": False}


@pytest.fixture
def made(monkeypatch):
    """Numbers of points and keys that were made."""
    counts = Counter()

    def count(owner, name):
        call = getattr(owner, name)

        def counted(self, values):
            counts[name] += 1
            return call(self, values)

        monkeypatch.setattr(owner, name, counted)

    count(Design, "__getitem__")
    count(Keys, "of")
    return counts


def stopped_after(most):
    """Return a progress that stops a sweep like Ctrl-C once so many reports are in."""
    reports = []

    def progress(fraction):
        reports.append(fraction)
        if len(reports) > most:
            raise KeyboardInterrupt

    return progress


def begin(ball, folder, made, over=MILLION):
    """Begin a sweep twice, each for three rows; few points are made, and it goes on where it ended."""
    for known in (0, 3):
        table = sweep(ball, over, out=folder, workers=1, progress=stopped_after(3), **BALL)
        assert table.outcome.name == "interrupted"
        assert [row.index for row in table] == list(range(known + 3))
        assert max(made.values()) < 3 * parameter_sweep.BATCH
        made.clear()


@pytest.mark.parametrize("how", ["grid", "zip", "chains"])
def test_a_million_rows_begin_at_once_and_go_on(ball, tmp_path, made, how):
    if how == "grid":
        begin(ball, tmp_path / "a", made)
    elif how == "zip":
        over = {"drop_height": "0.5..1.5 m:1000000", "restitution": "0.5..0.9:1000000 log"}
        table = sweep(ball, over, zip=True, out=tmp_path / "a", workers=1, progress=stopped_after(2), **BALL)
        assert len(table) == 2 and max(made.values()) < 3 * parameter_sweep.BATCH
    else:
        over = {"restitution": "0.5..0.9:1000", "drop_height": "0.5..1.5 m:1000"}
        how = {"continued": "down", "workers": 1, "progress": stopped_after(1), **BALL}
        (row, *_) = sweep(ball, over, out=tmp_path / "a", **how)
        assert row.stated["restitution"] == (0.9, "1")
        assert max(made.values()) < 3 * 1000 + 3
    record = json.loads((tmp_path / "a" / "definition.json").read_text())
    assert record["points"] == 1_000_000
    assert len(json.dumps(record)) < 3000
    assert "0.5..1.5 m:1000" in record["over"]["drop_height"]


def test_keys_that_are_all_made_first_would_be_found(ball, tmp_path, made, monkeypatch):
    missing = parameter_sweep.ToDo.missing
    monkeypatch.setattr(parameter_sweep.ToDo, "missing", lambda self: iter(list(missing(self))))
    with pytest.raises(AssertionError):
        begin(ball, tmp_path / "a", made, {**MILLION, "restitution": "0.5..0.9:3"})


def test_points_of_a_definition_are_those_that_it_was_written_from():
    """Ranges, lists, samples, pairs and values read back bitwise, also those that no row can read."""
    lists = {"drop_height": ["0.7 m", "55 cm", (0.1 + 0.2, "m")], "restitution": [0.5, 1 / 3, 0.7]}
    for over, how in (
        ({"drop_height": "0.5..1.5 m:1000", "mass": "1e-3..2 kg:7 log"}, {}),
        ({"drop_height": "0.5..1.5 m", "mass": "1e-3..2 kg log"}, {"sample": 16, "sampler": "sobol", "seed": 3}), (lists, {"zip": True}), (lists, {}),
    ):  # fmt: skip
        faults = []
        design = replace(read_design(over, faults=faults, **how), fixed={"radius": (21.0, "mm"), "gravity": "9,81"})
        assert not faults
        values = {name: as_text(value) for name, value in design.fixed.items()}
        spread = {"zip": False, "sample": None, "sampler": "latin", "seed": 0, **how}
        read = design_of({"over": axes_of(design, NO_CHOICES), "parameters": values, **spread})
        assert len(read) == len(design)
        places = np.linspace(0, len(design) - 1, 20).astype(int).tolist()
        assert [read[i] for i in places] == [design[i] for i in places]


# -- rows that stay in the folder ----------------------------------------------------------------------------------------

FEW = 20  # rows that a table holds in these tests


def filled(ball, folder, count=300, warned=()):
    """A store with rows that the store itself wrote: the run of the first, with numbers of their own."""
    over = {"drop_height": f"0.5..1.5 m:{count}"}
    first = sweep(ball, over, out=folder, workers=1, progress=stopped_after(1), **BALL).rows[0]
    plan = read_definition(folder)["digest"]
    with sweep_store.opened(folder) as opened:
        opened.plan = plan
        numbers = range(len(opened.keys([0])), count)
        made = {}
        for i in numbers:
            values, outputs = {"drop_height": 0.5 + i / (count - 1)}, dict.fromkeys(first.outputs, float(i))
            made[f"{i:032x}"] = replace(first, index=i, values=values, outputs=outputs, warnings=warned)
        opened.add(made, {row.index: key for key, row in made.items()})
    return over


@pytest.fixture
def few(monkeypatch):
    """A table holds FEW rows."""
    monkeypatch.setattr(stored_rows, "HELD", FEW)
    monkeypatch.setattr(parameter_sweep, "HELD", FEW)


def alive(table):
    """Largest number of rows alive in a pass over a table."""
    most = 0
    for i, _ in enumerate(table):
        if i % 100 == 0:
            most = max(most, sum(isinstance(each, Row) for each in gc.get_objects()))
    return most


def test_rows_beyond_those_that_are_held_are_read_one_by_one(ball, tmp_path, few):
    filled(ball, tmp_path / "a")
    before = sum(isinstance(each, Row) for each in gc.get_objects())
    table = Sweep.load(tmp_path / "a")
    assert (len(table), table.outcome.finished) == (300, True)
    assert alive(table) < before + FEW
    held = replace(table, rows=tuple(table.rows))  # the seeded fault: all of them
    assert alive(held) >= before + 300
    del held
    assert [row.index for row in table.rows[-2:]] == [298, 299]
    assert table.rows[-1].stated == {"drop_height": (1.5, "m")}
    assert table["drop_height"][[0, -1]].tolist() == [0.5, 1.5]
    assert table.counts() == {"finished": 300}


def test_a_file_of_rows_that_are_read_is_that_of_rows_that_are_held(ball, tmp_path, few, monkeypatch):
    over = filled(ball, tmp_path / "a")
    again = sweep(ball, over, out=tmp_path / "a", workers=1, **BALL)
    text = (tmp_path / "a" / sweep_store.TABLE).read_bytes()
    monkeypatch.undo()
    held = Sweep.load(tmp_path / "a")
    assert isinstance(held.rows, tuple) and not isinstance(again.rows, tuple)
    assert held.to_csv(tmp_path / "held.csv").read_bytes() == text
    assert text.count(b"\n") == 301


def test_a_damaged_row_among_many_is_computed_again_and_reported(ball, tmp_path, few):
    """The digest of a row is checked when its row is read: no later than the table is written."""
    over = filled(ball, tmp_path / "a")
    with sweep_store.opened(tmp_path / "a") as opened:
        opened._rows.execute("UPDATE rows SET outputs = replace(outputs, '7', '8') WHERE key = ?", (f"{77:032x}",))
    assert len(Sweep.load(tmp_path / "a")) == 299
    again = sweep(ball, over, out=tmp_path / "a", workers=1, **BALL)
    assert "299 rows of it are whole; row 77 damaged" in again.damage
    assert (len(again), again.outcome.finished) == (300, True)
    assert again.rows[77].outputs != again.rows[76].outputs
    assert Sweep.load(tmp_path / "a").outcome.finished


def test_more_rows_than_memory_holds_are_refused_without_a_folder_and_as_one_object(ball, tmp_path, monkeypatch):
    for name in ("IN_MEMORY", "PART"):
        monkeypatch.setattr(sweep_table, name, 2)
    over, folder = {"drop_height": "0.5..1.5 m:3"}, tmp_path / "a"
    with pytest.raises(InputError, match="3 in memory"):
        sweep(ball, over, workers=1, **BALL)
    table = sweep("bouncing_ball", over, out=folder, workers=1, **BALL)
    for make in (table.to_pandas, table.to_xarray, lambda: table.to_file(tmp_path / "a.nc")):
        with pytest.raises(InputError, match="3 in memory"):
            make()
    assert table.to_file(tmp_path / "a.parquet").stat().st_size > 0
    record = json.loads(called("sweep", "--resume", folder, "--json").stdout)
    assert (record["rows"], record["outcomes"], record["table"]) == (3, {"finished": 3}, {})


@pytest.mark.exhaustive
def test_a_million_rows_are_resumed_and_written_in_bounded_memory(tmp_path):
    """All but a hundred are there: the rest, and the table, in a process whose largest memory counts."""
    folder = tmp_path / "a"
    rows.fill(folder)
    taken = rows.process(rows.SWEPT.format(over=rows.OVER, how=rows.HOW), str(folder), "all", "processes")
    assert taken.memory < rows.MEMORY
    with (folder / sweep_store.TABLE).open() as lines:
        head, *numbers = (line.partition(",")[0] for line in lines)
    assert head == "row"
    assert list(map(int, numbers)) == list(range(1_000_000))
