"""Generated modules where neither SymPy nor the scene is installed: with CasADi, NumPy and SciPy alone."""

import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

import hertzwerk
from hertzwerk.generated import bouncing_ball

ALONE = """
import sys
from importlib import metadata

class Refused:
    \"\"\"Only what may be imported is found, as where nothing else is installed.\"\"\"

    def find_spec(self, name, path=None, target=None):
        package = name.partition(".")[0]
        if package not in {*sys.stdlib_module_names, *ALLOWED}:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

ALLOWED = {"casadi", "numpy", "scipy", "hertzwerk", *MORE}
sys.meta_path.insert(0, Refused())
"""
RUNS = """
from hertzwerk import simulate
from hertzwerk.runtime import sweep

run = simulate("ball.py", duration="0.5 s", tolerance=1e-6, compiled=False)
assert len(run.impacts) == 1, run
run.save("run.npz")
table = sweep("ball.py", over={"restitution": [0.5, 0.7]}, outputs=["impacts"], duration="0.5 s", tolerance=1e-6, out="rows")
assert table.counts() == {"finished": 2}, table
for missing in ("sympy", "matplotlib", "pydantic", "click"):
    try:
        __import__(missing)
    except ModuleNotFoundError:
        continue
    raise SystemExit(f"{missing} is there")
print("done")
"""
COMMANDS = """
from click.testing import CliRunner
from hertzwerk.runtime.cli import main

def told(*words):
    said = CliRunner().invoke(main, words)
    return said.exit_code, said.output

said = told("run", "ball.py", "--duration", "0.1 s", "--accuracy", "1e-6", "--out", "out")
assert said[0] == 1 and "No module named 'matplotlib'" in said[1], said  # all but the pictures
assert told("export", "ball.py", "--c", "library", "--duration", "0.1 s")[0] == 0
for words, package in {("draw", "ball.py"): "matplotlib", ("audit", "bouncing_ball"): "sympy", ("validate",): "pydantic"}.items():
    code, said = told(*words)
    assert code == 2 and f"{package}: found not installed" in said and f"pip install {package}" in said, said
print("done")
"""
NO_CLICK = """
from hertzwerk.command_line import start
start()
"""


CASES = [(RUNS, (), "done"), (COMMANDS, ("click",), "done"), (NO_CLICK, (), "pip install click")]


def said(folder, text, interpreter=sys.executable):
    shutil.copy(bouncing_ball.__file__, folder / "ball.py")
    done = subprocess.run([interpreter, "-c", text], cwd=folder, capture_output=True, text=True, check=False)
    return (done.stdout + done.stderr).strip()


@pytest.mark.parametrize(("text", "more", "last"), CASES, ids=["functions", "commands", "no click"])
def test_with_casadi_numpy_and_scipy_alone(tmp_path, text, more, last):
    assert said(tmp_path, ALONE.replace("MORE", repr(more)) + text).endswith(last)


@pytest.mark.exhaustive
def test_in_an_environment_with_casadi_numpy_and_scipy_alone(tmp_path):
    venv.create(tmp_path / "alone", with_pip=True)
    interpreter = str(tmp_path / "alone" / "bin" / "python")

    def install(*what):
        subprocess.run([interpreter, "-m", "pip", "install", "-q", *what], check=True)

    install("casadi", "numpy", "scipy")
    (site,) = (tmp_path / "alone" / "lib").glob("python*/site-packages")
    shutil.copytree(Path(hertzwerk.__file__).parent, site / "hertzwerk")  # as pip install --no-deps
    (about,) = Path(sysconfig.get_path("purelib")).glob("hertzwerk-*.dist-info")
    shutil.copytree(about, site / about.name)
    for text, more, last in sorted(CASES, key=lambda case: len(case[1])):
        if more:
            install(*more)
        (tmp_path / str(len(text))).mkdir()
        assert said(tmp_path / str(len(text)), text, interpreter).endswith(last)
