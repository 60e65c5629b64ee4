"""The first minute with a scene: its first run, and the pictures of a run, beside imports that they cannot do without."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from itertools import count
from pathlib import Path

from benchmarks.ratios import Measurement, Ratio, medians

PAGE = Path(__file__).parents[2] / "runtime" / "handbook" / "howto" / "model" / "first-scene.md"
HERTZWERK = (sys.executable, "-c", "from hertzwerk.command_line import start; start()", "run")
VARIED = ("slider_crank", "--without", "slider_pin_friction")


def minute() -> Iterator[Ratio]:
    """First run of a scene beyond its run, and the pictures of one: processor time of all processes over that of an import."""
    with tempfile.TemporaryDirectory() as place:
        names = count()

        def process(*command: str, cache: str = "") -> Measurement:
            """Return the measurement of a process and all that it starts; without a name its cache is new."""

            def measure() -> float:
                own = cache or str(next(names))
                environment = {**os.environ, "HERTZWERK_CACHE": str(Path(place) / f"cache{own}")}
                output = ("--out", f"out{next(names)}") if "run" in command else ()
                with subprocess.Popen(
                    [*command, *output], cwd=place, env=environment, stdout=subprocess.DEVNULL
                ) as started:
                    _, status, used = os.wait4(started.pid, 0)
                    started.returncode = os.waitstatus_to_exitcode(status)
                if started.returncode:
                    raise RuntimeError(f"{command} ended with {started.returncode}")
                return used.ru_utime + used.ru_stime

            return measure

        def run(*target: str, cache: str = "known") -> Measurement:
            return process(*HERTZWERK, *target, cache=cache)

        scene = re.search(r"```python\n# my_ball\.py\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        assert scene is not None
        (Path(place) / "my_ball.py").write_text(scene[1])
        sympy, pyplot = (process(sys.executable, "-c", f"import {name}") for name in ("sympy", "matplotlib.pyplot"))
        known, bare = run(*VARIED, "--no-plots"), run("bouncing_ball", "--duration", "1 s", "--no-plots")
        known()  # derives what is found from then on
        new, least, ball, bouncing, varied = medians(
            run(*VARIED, "--no-plots", cache=""),
            sympy,
            run("my_ball.py", "--duration", "1 s", "--no-plots"),
            bare,
            known,
            repeats=5,
        )
        yield Ratio("first run of my_ball beyond bouncing_ball's / import sympy", ball - bouncing, least, "<= 1.5")
        yield Ratio("first run of a new slider-crank beyond its second / import sympy", new - varied, least, "<= 1.5")
        drawn, without, imported = medians(run("slider_crank"), run("slider_crank", "--no-plots"), pyplot, repeats=5)
        yield Ratio("three pictures of slider_crank / import matplotlib.pyplot", drawn - without, imported, "<= 2")
        yield Ratio("slider_crank without pictures / import matplotlib.pyplot", without, imported)
