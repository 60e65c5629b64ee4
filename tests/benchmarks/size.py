"""Text, C and compilation of models of many pairs: balls on a floor with 3, 10, 55 and 300, and every built-in scene."""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.ratios import Ratio, medians

from reference import scenes

BALLS = {2: (450, 0.25), 4: (600, 0.3), 10: (1400, 0.5), 24: (None, 1.2)}  # most lines of the module, most MB of C
LINES = {"ball_bearing": 1900, "newtons_cradle": 800}
FASTEST, SLOWER, MANY_SLOWER = (
    "bouncing_ball",
    4,
    8,
)  # compilations of built-in scenes and of 300 pairs over the fastest
MEMORY = 600  # MB, most of a compiler


def size() -> Iterator[Ratio]:
    """Lines of modules, C of the loop (dop853), processor time and memory of the compiler."""
    from hertzwerk.runtime.engine.model.build import built_in_scenes
    from hertzwerk.runtime.engine.model.generated_text import text_of
    from hertzwerk.runtime.loading import engine_model

    models = {f"balls, {n * (n + 1) // 2} pairs": engine_model(scenes.balls(n)) for n in BALLS}
    names = built_in_scenes()
    models |= {name: engine_model(name) for name in names}
    lines = dict(zip(models, [most for most, _ in BALLS.values()], strict=False)) | LINES
    for name, most in lines.items():
        if most is not None:
            yield Ratio(
                f"lines of the module, {name} / bar",
                len(text_of(models[name].module).splitlines()),
                most,
                "<= 1",
                unit="lines",
            )
    files = {name: c_of(model) for name, model in models.items()}
    for name, (_, megabytes) in zip(models, BALLS.values(), strict=False):
        length = sum(len(file.text) for file in files[name])
        yield Ratio(f"C, {name} / bar", length / 1000, 1000 * megabytes, "<= 1", unit="kB")
    least = Compilation(files[FASTEST])
    for name, own_files in files.items():
        if name == FASTEST:
            continue
        own = Compilation(own_files)
        bar = MANY_SLOWER if "300" in name else SLOWER if name in names else None
        time, fastest = medians(own, least, repeats=3)
        yield Ratio(f"compiling {name} / {FASTEST}", time, fastest, f"<= {bar}" if bar else "")
        yield Ratio(f"memory of the compiler, {name} / bar", own.megabytes, MEMORY, "<= 1", unit="MB")


def c_of(model: Any) -> list[Any]:
    """Files in C, as they are compiled, of the loop of a model by dop853."""
    from hertzwerk.runtime.engine.integration.loop.attempt import integrator
    from hertzwerk.runtime.engine.integration.loop.c_compilation import c_text
    from hertzwerk.runtime.engine.integration.loop.c_files import c_files
    from hertzwerk.runtime.engine.integration.loop.chunk import chunk
    from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS

    return c_files(c_text([chunk(integrator(model, tuple(table() for table in METHODS["dop853"])))]))


class Compilation:
    """The measurement of the processor time [s] of a compilation of all files; `megabytes`: the most memory of a compiler."""

    def __init__(self, files: list[Any]) -> None:
        self._files, self.megabytes = files, 0.0

    def __call__(self) -> float:
        from hertzwerk.runtime.engine.integration.loop.c_compilation import FLAGS

        seconds = 0.0
        for file in self._files:
            with tempfile.TemporaryDirectory() as folder:
                source = Path(folder) / "chunk.c"
                source.write_text(file.text, encoding="utf-8")
                command = ["cc", file.level, *FLAGS, "-c", "-o", str(source.with_suffix(".o")), str(source)]
                run = subprocess.Popen(command)
                _, status, usage = os.wait4(run.pid, 0)
                run.returncode = os.waitstatus_to_exitcode(status)
            if run.returncode:
                raise RuntimeError(f"{' '.join(command)} failed")
            self.megabytes = max(self.megabytes, usage.ru_maxrss / 1000)
            seconds += usage.ru_utime + usage.ru_stime
        return seconds
