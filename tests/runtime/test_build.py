"""The door to derive and the cache behind it: the same text either way, trusted only where nobody else can write, never half written."""

import os
import stat
from pathlib import Path

import pytest

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime import build, cache


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    path = tmp_path / "made" / "cache"
    monkeypatch.setenv("HERTZWERK_CACHE", str(path))
    return path


def test_the_cache_is_made_for_its_user_alone(folder):
    assert cache.folder() == folder
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


@pytest.mark.skipif(os.name == "nt", reason="permissions of POSIX")
@pytest.mark.parametrize("mode", [0o770, 0o707, 0o777])
def test_a_folder_that_others_can_write_is_not_trusted(folder, mode):
    folder.mkdir(parents=True)
    (folder / "x").write_text("evil")
    folder.chmod(mode)
    assert cache.folder() is None
    assert cache.read("x") is None
    cache.write("y", "text")
    assert not (folder / "y").exists()


def test_the_cache_can_be_turned_off(monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", "")
    assert cache.folder() is None


def test_what_was_written_is_read_and_leaves_no_pieces(folder):
    cache.write("a.py", "x = 1\n")
    assert cache.read("a.py") == "x = 1\n"
    assert cache.read("b.py") is None
    assert [path.name for path in folder.iterdir()] == ["a.py"]


def test_a_write_that_fails_leaves_the_old_content_and_no_pieces(tmp_path, monkeypatch):
    path = tmp_path / "a.txt"
    cache.write_atomically(path, b"old")

    def fails(self, target):
        raise OSError("no")

    monkeypatch.setattr(Path, "replace", fails)
    with pytest.raises(OSError, match="no"):
        cache.write_atomically(path, b"new")
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir() if entry.is_file()] == ["a.txt"]


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


def test_variations_do_what_they_say():
    scene = build.scene_from("slider_crank")
    varied = build.vary(scene, ["slider_pin_friction"], {"slider_pin": "flores"})
    assert "slider_pin_friction" not in [effect.name for effect in varied.effects]
    assert "flores" in varied.effect("slider_pin").text
    assert "slider_pin_friction" in [effect.name for effect in scene.effects]


def test_all_faults_of_a_variation_come_at_once():
    with pytest.raises(InputError) as caught:
        build.vary(build.scene_from("slider_crank"), ["nope", "nor_this"], {"slider_pin": "newton", "guide": "flores"})
    text = str(caught.value)
    assert all(word in text for word in ("nope", "nor_this", "newton", "guide"))


def test_errors_in_a_generated_module_show_its_line():
    """The text has no file; a traceback finds its lines all the same."""
    import linecache

    module = build.build_built_in("two_spheres", ["energy_ledger"])
    assert linecache.getline(module.__file__, 1).startswith('"""two_spheres')
