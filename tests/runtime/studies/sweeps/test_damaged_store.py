"""Damaged folders of sweeps: whatever is damaged is found and computed again, and what is whole is kept.

What a folder must yield is known from the folder before its damage. The rows that SQLite reads by itself are found by a reader of
their own, which knows nothing of digests: it compares with the rows before.
"""

import json
import random
import shutil
import sqlite3
from contextlib import closing, suppress
from hashlib import sha256

import pytest
from commands import called

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, sweep
from hertzwerk.runtime.studies.sweeps import stored_rows, sweep_store

ROWS = 10
HOW = {
    "over": {"drop_height": f"0.5..1.5 m:{ROWS}"},
    **{"duration": "0.6 s", "tolerance": 1e-5, "compiled": False, "workers": 1},
    **{"outputs": ["floor.peak_force", "final.vertical.speed"], "grid": 250},
}


@pytest.fixture(scope="module")
def whole(ball, tmp_path_factory):
    """A folder whose process was killed when half of its rows were in the log, and its table."""
    folder = tmp_path_factory.mktemp("whole") / "a"
    table = sweep("bouncing_ball", out=folder, **HOW)
    with (
        closing(sqlite3.connect(folder / sweep_store.ROWS)) as one,
        closing(sqlite3.connect(folder / sweep_store.ROWS)) as other,
    ):
        one.execute("PRAGMA wal_autocheckpoint=0")
        with one:
            half = "(SELECT key FROM rows ORDER BY key LIMIT 5)"
            kept = one.execute(f"SELECT * FROM rows WHERE key IN {half}").fetchall()
            one.execute(f"DELETE FROM rows WHERE key IN {half}")
        other.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        with one:
            one.executemany(f"INSERT INTO rows VALUES ({', '.join('?' * len(kept[0]))})", kept)
        killed = folder.with_name("killed")
        shutil.copytree(folder, killed, ignore=shutil.ignore_patterns("*-shm", "*.csv"))
    assert (killed / f"{sweep_store.ROWS}-wal").stat().st_size > 20000
    with closing(sqlite3.connect(f"file:{killed / sweep_store.ROWS}?mode=ro", uri=True)) as connection:
        assert connection.execute("SELECT min(length(arrays)) FROM rows").fetchone()[0] > 4096  # in pages of their own
    return killed, table


def numbers(table):
    """Everything that a table says of its rows, by their indices."""
    return {
        row.index: repr((row.stated, row.outcome, row.message, row.values, row.outputs, row.warnings, row.arrays))
        for row in table
    }


def checkpointed(folder):
    """Write the log of a folder through, as the end of a process does that is not killed."""
    with closing(sqlite3.connect(folder / sweep_store.ROWS)) as connection:
        connection.execute("SELECT * FROM rows").fetchone()
    assert not (folder / f"{sweep_store.ROWS}-wal").exists()


def damaged(file, chance):
    """Damage a file: a few bits, a cut, or zeros."""
    content = bytearray(file.read_bytes())
    how = chance.random()
    if how < 0.6:
        for _ in range(chance.choice((1, 1, 6))):
            content[chance.randrange(len(content))] ^= 1 << chance.randrange(8)
    elif how < 0.8:
        del content[chance.randrange(len(content)) :]
    else:
        begin = 4096 * chance.randrange(-(-len(content) // 4096))
        content[begin : begin + 4096] = bytes(len(content[begin : begin + 4096]))
    file.write_bytes(content)


def by_sqlite(folder, elsewhere, rows):
    """Keys of the rows that SQLite reads, and reads as they were: in order as far as it gets, and one by one."""
    shutil.copytree(folder, elsewhere)
    found = {}
    with suppress(sqlite3.Error), closing(sqlite3.connect(elsewhere / sweep_store.ROWS)) as connection:
        connection.execute("PRAGMA synchronous=OFF")
        for order in ("ASC", "DESC"):
            with suppress(sqlite3.Error, UnicodeError, OverflowError):
                for entry in connection.execute(f"SELECT * FROM rows NOT INDEXED ORDER BY rowid {order}"):
                    found[entry[1]] = entry
        for i in range(2 * ROWS + 2):
            with suppress(sqlite3.Error, UnicodeError, OverflowError):
                for entry in connection.execute("SELECT * FROM rows NOT INDEXED WHERE rowid = ?", (i,)):
                    found[entry[1]] = entry
    shutil.rmtree(elsewhere)
    return {key for key, entry in found.items() if rows.get(key) == entry}


def survive(whole, tmp_path, seed):
    """Damage a copy of a folder, read it, and go on with it as a sweep does; return how that went."""
    before, table = whole
    truth, chance, folder = numbers(table), random.Random(seed), tmp_path / f"{seed}"
    with closing(sqlite3.connect(f"file:{before / sweep_store.ROWS}?mode=ro", uri=True)) as connection:
        rows = {entry[1]: entry for entry in connection.execute("SELECT * FROM rows")}
        keys = [key for (key,) in connection.execute("SELECT key FROM points ORDER BY number")]
    definition = json.loads((before / sweep_store.DEFINITION).read_text())
    del definition["digest"]
    shutil.copytree(before, folder, ignore=shutil.ignore_patterns("*-shm"))
    name = chance.choice((sweep_store.ROWS, sweep_store.ROWS, f"{sweep_store.ROWS}-wal", sweep_store.DEFINITION))
    if name == sweep_store.ROWS and chance.random() < 0.5:
        checkpointed(folder)
    damaged(folder / name, chance)
    readable = by_sqlite(folder, tmp_path / "elsewhere", rows)
    refused = False
    try:
        assert numbers(Sweep.load(folder)).items() <= truth.items(), (seed, name, "read")
    except InputError as error:
        refused = True
        assert name == sweep_store.DEFINITION and str(folder) in str(error), (seed, name, error)
    with sweep_store.opened(folder) as opened:
        how = definition, (before / "model.py").read_text()
        if refused:
            with pytest.raises(InputError, match="widen=True"):
                opened.define(*how, widen=False)
        opened.define(*how, widen=refused)
        rest = dict(enumerate(keys))
        opened.add({}, {i: key for i, key in rest.items() if key in opened.present(keys)})
        with suppress(stored_rows.DamagedError):
            list(stored_rows.StoredRows(folder / sweep_store.ROWS, opened.plan, table.design))
            rest = {}
        if rest:  # what SQLite takes for whole, and digests do not
            opened.mend()
        kept, damage = opened.present(keys), opened.damage
        left = {i: key for i, key in enumerate(keys) if not opened.done(ROWS)[i]}
        opened.add({key: table.rows[i] for i, key in left.items() if key not in kept}, left)
    assert kept >= readable, (seed, name, "lost")
    assert numbers(Sweep.load(folder)) == truth, (seed, name, "went on")
    assert Sweep.load(folder).outcome.finished
    assert damage is None or damage.whole == len(kept)
    with sweep_store.opened(folder) as opened:
        assert opened.damage is None
    shutil.rmtree(folder)
    return len(readable), len(kept), damage is not None, refused


def ends_of(whole, tmp_path, seeds):
    ends = [survive(whole, tmp_path, seed) for seed in seeds]
    read, kept, found, refused = map(sum, zip(*ends, strict=True))
    said = f"{read:,} rows that SQLite reads, {kept:,} kept of {ROWS * len(ends):,}; {found} files replaced, {refused} definitions refused"
    print(said)
    return read, kept, found, refused


def test_random_damage_changes_no_number_and_loses_no_row_that_sqlite_reads(whole, tmp_path):
    read, kept, actual, refused = ends_of(whole, tmp_path, range(40))
    assert read < kept < 40 * ROWS  # more than SQLite reads, and some are damaged
    assert actual > 10
    assert refused > 5


# -- the seeded faults: without each of the guards a number changes or a row is lost --------------------------------------


def test_without_digests_a_number_changes(whole, tmp_path, monkeypatch):
    monkeypatch.setattr(stored_rows, "is_whole", lambda *_: True)
    with pytest.raises((AssertionError, ValueError, TypeError)):  # or a traceback
        ends_of(whole, tmp_path, range(40))


def test_without_a_reader_of_damaged_files_rows_that_sqlite_reads_are_lost(whole, tmp_path, monkeypatch):
    monkeypatch.setattr(stored_rows, "readable", lambda *_: iter(()))
    with pytest.raises(AssertionError, match="lost"):
        ends_of(whole, tmp_path, range(40))


# -- one by one --------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(whole, tmp_path):
    """A folder of its own."""
    shutil.copytree(whole[0], tmp_path / "a", ignore=shutil.ignore_patterns("*-shm"))
    return tmp_path / "a"


def test_resume_computes_the_damaged_row_again_and_says_which(whole, folder):
    """One digit of one number, as SQLite itself would write it: the file is in order, the row is not."""
    with closing(sqlite3.connect(folder / sweep_store.ROWS)) as connection, connection:
        connection.execute(
            "UPDATE rows SET outputs = replace(outputs, '3', '4') WHERE key = (SELECT key FROM points WHERE number = 3)"
        )
    read = Sweep.load(folder)
    assert [row.index for row in read] == [0, 1, 2, *range(4, ROWS)]
    assert read.outcome.message == f"1 of {ROWS} rows are missing, as rows.sqlite is damaged"
    text = " ".join(called("sweep", "--resume", folder, "--workers", "1").output.split())
    assert "rows.sqlite was damaged: 9 rows of it are whole; row 3 damaged; the damaged file is kept as rows.damaged-001.sqlite" in text  # fmt: skip
    assert numbers(Sweep.load(folder)) == numbers(whole[1])
    with closing(sqlite3.connect(folder / "rows.damaged-001.sqlite")) as aside:
        assert aside.execute("SELECT count(*) FROM rows").fetchone() == (ROWS,)
    assert "was damaged" not in called("sweep", "--resume", folder, "--workers", "1").output


def test_a_file_that_is_none_of_sqlite_is_set_aside_with_its_rows_kept(whole, folder):
    checkpointed(folder)
    content = bytearray((folder / sweep_store.ROWS).read_bytes())
    content[:100] = bytes(100)
    (folder / sweep_store.ROWS).write_bytes(content)
    assert numbers(Sweep.load(folder)) == numbers(whole[1])
    with sweep_store.opened(folder) as opened:
        assert opened.done(ROWS).count(1) == ROWS
    assert (folder / "rows.damaged-001.sqlite").read_bytes() == content


def test_a_file_that_sqlite_only_reads_is_damaged(whole, folder):
    """A bit of the version of its format: all was in order until the first row was to be written."""
    checkpointed(folder)
    with (folder / sweep_store.ROWS).open("r+b") as file:
        file.seek(18)
        file.write(b"\3")
    with sweep_store.opened(folder) as opened:
        assert opened.damage.whole == ROWS
        opened.add({"another": whole[1].rows[0]}, {})


def test_a_file_that_is_empty_now_is_damaged_and_one_of_a_process_killed_at_once_is_not(folder, tmp_path):
    checkpointed(folder)
    (folder / sweep_store.ROWS).write_bytes(b"")
    assert "is damaged" in Sweep.load(folder).outcome.message
    with sweep_store.opened(folder) as opened:
        assert opened.damage.whole == 0
    (tmp_path / "new").mkdir()
    (tmp_path / "new" / sweep_store.ROWS).write_bytes(b"")
    with sweep_store.opened(tmp_path / "new") as opened:
        assert opened.damage is None


def test_a_process_killed_between_the_two_files_loses_nothing(whole, folder):
    (folder / sweep_store.ROWS).rename(folder / "rows.damaged-001.sqlite")
    (folder / f"{sweep_store.ROWS}-wal").rename(folder / "rows.damaged-001.sqlite-wal")
    assert numbers(Sweep.load(folder)) == numbers(whole[1])
    with sweep_store.opened(folder) as opened:
        assert opened.done(ROWS).count(1) == ROWS
        assert opened.damage.aside is None


def test_points_of_an_earlier_definition_are_none_of_this_one(ball, tmp_path):
    """They are in pages that SQLite uses no more, with digests that fit: a row must not move to their places."""
    how = {**HOW, "grid": None, "out": tmp_path / "a"}
    first = sweep(ball, **how)
    del how["over"]
    other = sweep(ball, {"drop_height": f"0.6..1.6 m:{ROWS}"}, widen=True, **how)
    with (tmp_path / "a" / sweep_store.ROWS).open("r+b") as file:
        file.write(bytes(100))
    read = Sweep.load(tmp_path / "a")
    assert numbers(read).items() <= numbers(other).items()
    assert other.rows[0].stated != first.rows[0].stated


def test_a_definition_with_faults_names_each(folder):
    file = folder / sweep_store.DEFINITION
    record = json.loads(file.read_text())
    del record["functions"], record["columns"]
    file.write_text(json.dumps({**record, "varied": "drop_height", "seed": None}))
    with pytest.raises(InputError) as refused:
        Sweep.load(folder)
    places = {fault.where.rpartition(": ")[2] for fault in refused.value.faults}
    assert places == {"functions", "columns", "varied", "seed"}
    file.write_text(json.dumps({**record, "functions": {}, "columns": {}}))
    assert "entries that do not fit its digest" in called("sweep", "--resume", folder, code=2).output
    file.write_bytes(b"\xff{")
    called("sweep", "--resume", folder, code=2)


SCENE = """
from pathlib import Path
from hertzwerk.derive.scenes.pendulum import scene
with Path({log!r}).open("a") as log:
    log.write("executed ")
"""


def test_resume_executes_no_file_but_that_of_the_sweep(tmp_path):
    log, target, into = tmp_path / "log", tmp_path / "mine.py", tmp_path / "a"
    log.write_text("")
    target.write_text(SCENE.format(log=str(log)))
    call = (
        "sweep", target, "--over", "length=0.5,1 m", "--duration", "0.1 s", "--tolerance", "1e-6", "--workers", "1",
    )  # fmt: skip
    called(*call, "--out", into)
    called("sweep", "--resume", into, "--workers", "1")
    executed = log.read_text()
    target.write_text(SCENE.format(log=str(log)) + "# changed")
    ended = called("sweep", "--resume", into, "--workers", "1", code=2)
    assert str(target) in ended.output.replace("\n", "")
    assert log.read_text() == executed
    called(*call, "--out", into)  # who names it executes it: the same scene, whose digest is kept
    kept = json.loads((into / sweep_store.DEFINITION).read_text())["target_file"]
    assert kept == sha256(target.read_bytes()).hexdigest()
    target.unlink()
    called("sweep", "--resume", into, "--workers", "1", code=2)
