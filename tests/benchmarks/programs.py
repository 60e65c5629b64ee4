"""Compiles and runs the programs of handwritten/: the slider-crank as one writes it by hand, and the same through SUNDIALS CVODE called from C."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent / "handwritten"
COMPILER = shutil.which("g++")


@cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="hertzwerk-programs-")  # removed when the interpreter ends


@cache
def _program(source: str, *flags: str) -> Path:
    """A compiled program of the folder."""
    if COMPILER is None:
        raise RuntimeError("the hand-written programs need g++")
    path = Path(_folder().name) / f"program_{_program.cache_info().currsize}"
    command = [COMPILER, "-std=c++17", "-O3", "-march=native", str(FOLDER / source), "-o", str(path), *flags]
    subprocess.run(command, check=True)
    return path


def handwritten(
    method: str,
    tolerance: float,
    *,
    friction: bool,
    times: Sequence[float],
    repeats: int = 0,
    clearance: float = 5e-4,
    real: str = "double",
) -> dict[str, Any]:
    """States [t, theta, x, theta', x'], impacts [onset, speed], counts, and the median time of `repeats` runs [s]; `real` is the number type."""
    numbers = [repr(float(tolerance)), str(int(friction)), repr(float(clearance)), str(repeats), *map(repr, times)]
    return _json(_program("slider_crank.cpp", f"-DREAL={real}"), "run", method, *numbers)


def bare() -> dict[str, float]:
    """Time of one hand-written evaluation of the right-hand side in flight, in contact and in contact with friction [s]."""
    return _json(_program("slider_crank.cpp", "-DREAL=double"), "bare")


@cache
def sundials() -> Path | None:
    """The folder of CasADi's CVODE, if a program can be linked to it."""
    import casadi

    folder = Path(casadi.__file__).parent
    names = ("libcasadi_integrator_cvodes.so", "libcasadi_sundials_common.so")
    return folder if COMPILER is not None and all((folder / name).is_file() for name in names) else None


def cvode(
    formula: str, solver: str, tolerance: float, *, friction: bool, times: Sequence[float], repeats: int = 0
) -> Any:
    """States [theta, x, theta', x'] at times [s], onsets of impacts, evaluations, and the median time of `repeats` runs [s].

    formula "adams" or "bdf", solver "functional" or "newton". Raises ArithmeticError where CVODE gives up.
    """
    library = sundials()
    if library is None:
        raise RuntimeError("CasADi's wheel has no CVODE to link to")
    flags = [f"-L{library}", "-lcasadi_integrator_cvodes", "-lcasadi_sundials_common", f"-Wl,-rpath,{library}"]
    program = _program("slider_crank_cvode.cpp", *flags)
    numbers = [repr(float(tolerance)), str(int(friction)), str(repeats), *map(repr, times)]
    try:
        return _json(program, formula, solver, *numbers)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        raise ArithmeticError(f"CVODE failed: {error.stderr}") from error


def _json(program: Path, *arguments: str) -> Any:
    run = subprocess.run([str(program), *arguments], check=True, capture_output=True, text=True, timeout=120)
    return json.loads(run.stdout)
