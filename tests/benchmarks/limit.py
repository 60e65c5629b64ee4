"""Compiles and runs the hand-written slider-crank (handwritten/slider_crank.cpp), the limit generated code is measured by."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

SOURCE = Path(__file__).parent / "handwritten" / "slider_crank.cpp"
COMPILER = shutil.which("g++")


@cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="hertzwerk-limit-")  # removed when the interpreter ends


@cache
def program(real: str = "double") -> Path:
    """The compiled program; `real` is its floating-point type."""
    if COMPILER is None:
        raise RuntimeError("the hand-written program needs g++")
    path = Path(_folder().name) / f"slider_crank_{real.replace(' ', '_')}"
    flags = ["-std=c++17", "-O3", "-march=native", f"-DREAL={real}"]
    subprocess.run([COMPILER, *flags, str(SOURCE), "-o", str(path)], check=True)
    return path


def run(
    method: str,
    tolerance: float,
    *,
    friction: bool,
    times: tuple[float, ...],
    repeats: int = 0,
    clearance: float = 5e-4,
    real: str = "double",
) -> dict[str, Any]:
    """States [t, theta, x, theta', x'], impacts [onset, speed], counts, and the median time of `repeats` runs [s]."""
    numbers = [repr(float(tolerance)), str(int(friction)), repr(float(clearance)), str(repeats), *map(repr, times)]
    return _json([str(program(real)), "run", method, *numbers])


def bare() -> dict[str, float]:
    """Time of one evaluation of the right-hand side in flight, in contact and in contact with friction [s]."""
    return _json([str(program()), "bare"])


def _json(command: list[str]) -> Any:
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True, timeout=120).stdout)
