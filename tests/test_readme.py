"""The README keeps its promises: a result by line 40, Python that runs, commands that exist, and the picture its example draws."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
PYTHON = [text for language, text in BLOCKS if language == "python"]
SHELL = [text for language, text in BLOCKS if language in ("sh", "console")]
PICTURES = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", README)


def test_set_up_example_and_picture_stand_by_line_40():
    top = "\n".join(README.splitlines()[:40])
    assert "pip install" in top
    assert "hertzwerk run slider_crank" in top
    assert "pytest" in top
    assert "```python" in top
    assert PICTURES
    assert f"({PICTURES[0]})" in top


def test_the_first_example_is_short():
    assert len(PYTHON[0].splitlines()) <= 20


@pytest.mark.parametrize("picture", PICTURES)
def test_pictures_are_committed_png_files(picture):
    content = (ROOT / picture).read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    assert len(content) < 500_000


def test_the_picture_of_all_mechanisms_has_them_all():
    from PIL import Image

    from hertzwerk.runtime.model.build import built_in_scenes

    with Image.open(ROOT / ".readme" / "mechanisms.png") as picture:
        assert picture.text["Description"].split() == list(built_in_scenes())


@pytest.mark.parametrize("index", range(len(PYTHON)))
def test_python_runs_as_written(index, tmp_path):
    """In a folder of its own, warnings as errors; what it says it writes, it writes."""
    (tmp_path / "example.py").write_text(PYTHON[index], encoding="utf-8")
    command = [sys.executable, "-W", "error", "example.py"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stderr
    for name in re.findall(r'savefig\("([^"]+)"', PYTHON[index]):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


def test_every_command_it_shows_exists():
    from hertzwerk.runtime.cli import main

    shown = set(re.findall(r"hertzwerk ([a-z]+)", "\n".join(SHELL)))
    assert shown
    assert shown <= set(main.commands)


def test_every_option_it_shows_exists():
    from hertzwerk.runtime.cli import main

    for command, rest in re.findall(r"hertzwerk ([a-z]+)([^\n|&]*)", "\n".join(SHELL)):
        known = {name for option in main.commands[command].params for name in option.opts}
        assert set(re.findall(r"(?<=\s)--[a-z-]+", rest)) <= known | {"--help"}, command
