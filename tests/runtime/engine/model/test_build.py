"""The door to derive and the cache behind it: the same text either way, trusted only where nobody else can write, never half written."""

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.common.module_format import FORMAT, sealed
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.model import build
from hertzwerk.runtime.system import cache


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    path = tmp_path / "made" / "cache"
    monkeypatch.setenv("HERTZWERK_CACHE", str(path))
    return path


def test_the_cache_is_made_for_its_user_alone_and_leaves_no_temporary_files(folder):
    assert cache.folder() == folder
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    kept = cache.keep("a", ".py", b"x = 1\n")
    assert cache.read("a", ".py") == "x = 1\n"
    assert cache.read("b", ".py") is None
    assert list(folder.iterdir()) == [kept]


@pytest.mark.skipif(os.name == "nt", reason="permissions of POSIX")
@pytest.mark.parametrize("mode", [0o770, 0o707, 0o777])
def test_a_folder_that_others_can_write_is_not_trusted(folder, mode):
    folder.mkdir(parents=True)
    kept = cache.keep("x", ".py", b"evil")
    folder.chmod(mode)
    assert cache.folder() is None
    assert cache.read("x", ".py") is None
    assert cache.keep("y", ".py", b"text") is None
    assert list(folder.iterdir()) == [kept]


def test_a_user_who_turned_the_cache_off_or_without_a_home_has_none(monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", "")
    assert cache.folder() is None

    def nowhere():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("HERTZWERK_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(Path, "home", nowhere)
    assert cache.folder() is None
    assert cache.keep("a", ".py", b"") is None


@pytest.mark.parametrize("content", [b"", b"x = 1", b"x = 2\n", b"x = 1\n\n", b"\xff"])
def test_an_entry_that_is_not_as_it_was_written_is_removed(folder, content):
    kept = cache.keep("a", ".py", b"x = 1\n")
    kept.write_bytes(content)
    assert cache.read("a", ".py") is None
    assert list(folder.iterdir()) == []


def test_a_changed_module_is_derived_again(folder, monkeypatch):
    monkeypatch.setattr(build, "derive_text", lambda *_: sealed(f'FORMAT = "{FORMAT}"\nDIGEST = ""\nNUMBER = 1.0\n'))
    build.build_built_in("two_spheres", ["energy_ledger"])
    (kept,) = folder.iterdir()
    kept.write_text("NUMBER = 2.0\n")
    assert build.build_built_in("two_spheres", ["energy_ledger"]).NUMBER == 1


def test_a_full_disk_ends_nothing_that_can_do_without_the_cache(folder, monkeypatch):
    def full(path, content):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(cache, "write_atomically", full)
    assert cache.keep("a", ".py", b"x") is None
    assert build.build_built_in("two_spheres", ["energy_ledger"]).PARAMETERS
    assert simulate(load("bouncing_ball"), duration="10 ms", tolerance=1e-6, compiled=True).settings.compiled
    assert list(folder.iterdir()) == []


TRUNCATED = """
from hertzwerk.runtime import load, simulate
print(simulate(load("bouncing_ball"), duration="10 ms", tolerance=1e-6, method="dopri5", compiled=True).engine.final)
"""


@pytest.mark.slow
def test_a_truncated_library_is_compiled_again(folder):
    """In processes of their own: loaded, a truncated library is a bus error."""

    def run():
        done = subprocess.run([sys.executable, "-c", TRUNCATED], capture_output=True, text=True, check=True)
        (library,) = folder.glob("compiled-*.so")
        return done.stdout, library

    before, library = run()
    library.write_bytes(library.read_bytes()[: library.stat().st_size // 2])
    after, again = run()
    assert before == after
    assert again == library


def test_a_variation_is_derived_once_and_read_afterwards(folder, monkeypatch):
    first = build.build_built_in("two_spheres", ["energy_ledger"])
    assert len(list(folder.iterdir())) == 1
    monkeypatch.setattr(build, "derive_text", lambda *_: pytest.fail("derived again"))
    again = build.build_built_in("two_spheres", ["energy_ledger"])
    assert first.PARAMETERS == again.PARAMETERS
    assert first.EFFECTS == again.EFFECTS


def test_another_variation_or_another_derivation_is_another_entry(folder, monkeypatch):
    build.build_built_in("two_spheres", ["energy_ledger"])
    build.build_built_in("two_spheres", [], {"spheres": "hunt_crossley"})
    monkeypatch.setattr(build, "derive_digest", lambda: "changed")
    build.build_built_in("two_spheres", ["energy_ledger"])
    assert len(list(folder.iterdir())) == 3


def test_all_faults_of_a_variation_come_at_once():
    with pytest.raises(InputError) as caught:
        build.vary(build.scene_from("slider_crank"), ["nope", "nor_this"], {"slider_pin": "newton", "guide": "flores"})
    text = str(caught.value)
    assert all(word in text for word in ("nope", "nor_this", "newton", "guide"))


def test_tracebacks_find_the_lines_of_a_generated_module():
    """Its text has no file."""
    import linecache

    module = build.build_built_in("two_spheres", ["energy_ledger"])
    assert linecache.getline(module.__file__, 1).startswith('"""two_spheres')
