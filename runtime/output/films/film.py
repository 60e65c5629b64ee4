"""Films of runs: frames made one after the other and written whole, up to where they were stopped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.solution.solution import EngineSolution, write
from hertzwerk.runtime.output.films.film_clock import Clock
from hertzwerk.runtime.output.films.stage import DPI, Stage
from hertzwerk.runtime.output.films.writers import WRITERS, format_fault
from hertzwerk.runtime.output.plots.plot_style import STYLE
from hertzwerk.runtime.system.atomic_files import scratch_folder
from hertzwerk.runtime.system.result_folder import new_file_faults

FPS = 25.0


@dataclass(frozen=True)
class Film:
    """A written film: its frames, of how many it should have; fewer where it was stopped."""

    path: Path
    frames: int
    of: int
    clock: Clock


def animate(
    run: EngineSolution,
    path: Path,
    *,
    fps: float = FPS,
    slow: float | None = None,
    overwrite: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Film:
    """Write the film of a run; a KeyboardInterrupt ends it with the frames so far, once there are two.

    Raises InputError with every fault, OSError where it cannot be written.
    """
    faults = path_faults(path, overwrite=overwrite)
    clock = Clock.of(run.engine.t_start, run.engine.t_end, fps, slow, path.suffix.lower(), faults)
    if faults or clock is None:
        raise InputError(f"film of {run.engine.model.name}", faults)
    stage = Stage.of(run, clock)
    writer, count, done = WRITERS[path.suffix.lower()](clock.fps), len(clock.times), 0
    with scratch_folder(path.absolute().parent) as folder, mpl.rc_context(STYLE):
        file = folder / f"film{path.suffix.lower()}"
        writer.setup(stage.figure, file, DPI)
        try:
            for k in range(count):
                stage.show(k)
                writer.grab_frame()
                done = k + 1
                if progress is not None:
                    progress(done / count)
        except KeyboardInterrupt:
            if done < 2:
                raise
        writer.finish()
        return Film(write(path, file.read_bytes(), overwrite=overwrite), done, count, clock)


def path_faults(path: Path, *, overwrite: bool) -> list[Fault]:
    """Return the faults of a film's file: its format, one that exists, a folder that cannot be written to."""
    fault = format_fault(path)
    others = new_file_faults("file", path, "name another, or overwrite it", overwrite=overwrite)
    return others if fault is None else [fault, *others]
