"""Unfinished files: never half written, removed by the next where their maker was killed, and never anybody else's."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from hertzwerk.runtime.system import atomic_files
from hertzwerk.runtime.system.atomic_files import scratch_folder, sweep, write_atomically

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="locks of POSIX")


def test_a_write_that_fails_leaves_the_old_content_and_no_pieces(tmp_path, monkeypatch):
    path = tmp_path / "a.txt"
    write_atomically(path, b"old")

    def fails(self, target):
        raise OSError("no")

    monkeypatch.setattr(Path, "replace", fails)
    with pytest.raises(OSError, match="no"):
        write_atomically(path, b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_is_removed_unless_it_was_renamed(tmp_path):
    with scratch_folder(tmp_path) as folder:
        (folder / "x").write_text("x")
    assert list(tmp_path.iterdir()) == []
    with scratch_folder(tmp_path) as folder:
        (folder / "x").write_text("x")
        folder.rename(tmp_path / "kept")
    assert [path.name for path in tmp_path.rglob("*")] == ["kept", "x"]


MAKER = """
import sys, time
from pathlib import Path
from hertzwerk.runtime.system.atomic_files import scratch_folder
with scratch_folder(Path(sys.argv[1])) as folder:
    (folder / "x").write_text("x")
    print(folder, flush=True)
    time.sleep(600)
"""


def _aged(path):
    old = time.time() - 2 * atomic_files.YOUNG
    os.utime(path, (old, old))


def test_leftovers_of_the_killed_are_removed_and_what_is_held_is_not(tmp_path):
    maker = subprocess.Popen([sys.executable, "-c", MAKER, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    folder = Path(maker.stdout.readline().strip())
    _aged(folder)
    sweep(tmp_path)
    assert (folder / "x").exists()
    maker.send_signal(signal.SIGKILL)
    maker.wait()
    maker.stdout.close()
    sweep(tmp_path)
    assert not folder.exists()


def test_young_or_foreign_files_stay(tmp_path):
    young = tmp_path / (atomic_files._PREFIX + 16 * "0")
    young.write_text("x")
    elsewhere = tmp_path / "elsewhere"
    elsewhere.write_text("x")
    for name in (".ball-0123abcd", ".hertzwerk-unfinished-mine", "hertzwerk-x", atomic_files._PREFIX + 17 * "0"):
        (tmp_path / name).mkdir()
        _aged(tmp_path / name)
    (tmp_path / (atomic_files._PREFIX + 16 * "1")).symlink_to(elsewhere)
    before = set(tmp_path.iterdir())
    with scratch_folder(tmp_path):
        pass
    assert set(tmp_path.iterdir()) == before
    _aged(young)
    write_atomically(elsewhere, b"y")
    assert set(tmp_path.iterdir()) == before - {young}
