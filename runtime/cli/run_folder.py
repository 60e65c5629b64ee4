"""Record of a run on disk and as JSON: one new folder with data, provenance and plots."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.cli.stop_signals import Stopping
from hertzwerk.runtime.cli.terminal import Progress
from hertzwerk.runtime.system.atomic_files import scratch_folder, write_atomically
from hertzwerk.runtime.system.digests import record_text
from hertzwerk.runtime.system.forked_tasks import side_by_side
from hertzwerk.runtime.system.result_folder import failures_of, new_folder
from hertzwerk.runtime.system.versions import versions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.engine.solution.averages import Average
    from hertzwerk.runtime.simulation import Solution

PICTURED = 24  # pairs up to which each gets a picture
CSV_LIMIT = 50e6  # bytes: larger files are written only on request


def summary(solution: Solution, *, averages: bool = False) -> dict[str, Any]:
    """Return the content of `run --json`: plain numbers in SI, null for missing ones.

    averages: include them.
    """
    statistics, error, derivatives = solution.statistics, solution.error, solution.engine.derivatives
    return {
        "scene": solution.engine.model.name,
        "outcome": solution.outcome.name,
        "t_start": solution.engine.t_start,
        "t_end": solution.engine.t_end,
        "duration": solution.settings.duration,
        "accuracy": solution.settings.accuracy,
        "tolerance": solution.settings.tolerance,
        "method": solution.settings.method,
        "compiled": solution.settings.compiled,
        "steps": statistics.steps,
        "rejected": statistics.rejected,
        "rhs_evaluations": statistics.rhs_evaluations,
        "wall_s": statistics.wall_s,
        "impacts": [
            {"contact": i.contact, "t": i.t, "speed": i.speed, "peak_force": i.peak_force, "duration": i.duration}
            for i in solution.impacts
        ],
        "final": solution.engine.final,
        "energy_residual": solution.energy_residual,
        "error_estimate": error and error.judged,
        "horizon": error and error.horizon,
        "growth": error and error.growth,
        "decade_cost": error and error.decade_cost,
        "warnings": list(solution.warnings),
        "advice": list(solution.engine.advice),
        **({"averages": [asdict(average) for average in solution.averages()]} if averages else {}),
        **(
            {"sensitivities": derivatives.record(solution.engine.states, solution.engine.t_end)}
            if derivatives is not None
            else {}
        ),
    }


def record(solution: Solution) -> dict[str, Any]:
    """Return the content of `run.json`: the summary, and everything needed to repeat the run."""
    model = solution.engine.model
    return {
        **summary(solution),
        "outcome_message": solution.outcome.message,
        "remedy": solution.outcome.remedy,
        "source": model.module.SOURCE,
        "effects": [{"name": name, "kind": kind, "text": text} for name, kind, text in model.module.EFFECTS],
        "unchecked": [{"effect": effect, "reason": reason} for effect, reason in model.module.UNCHECKED],
        "parameters": {
            name: {"value": value, "unit": unit} for name, (value, unit) in solution.settings.parameters.items()
        },
        "initial": solution.engine.initial,
        "rows": len(solution.t),
        "statistics": asdict(solution.statistics),
        "error": solution.error and solution.error.numbers,
        "choices": [asdict(choice) for choice in solution.engine.choices],
        "versions": versions(),
    }


def write_study(
    name: str, out: Path | None, texts: Mapping[str, str], draw: Callable[[], Figure] | None, missing: list[str]
) -> tuple[Path, list[str]]:
    """Write texts by file name, and the picture that `draw` makes; return the folder and its files.

    The picture is named as the first file. A failure of it is appended to `missing`.
    """

    def fill(folder: Path) -> list[str]:
        for file, text in texts.items():
            (folder / file).write_text(text, encoding="utf-8")
        if draw is None:
            return list(texts)
        from hertzwerk.runtime.output.plots.save_figure import png_of

        picture = f"{Path(next(iter(texts))).stem}.png"
        failures = failures_of(picture, lambda: (folder / picture).write_bytes(png_of(draw())))
        missing.extend(failures)
        return [*texts, *([] if failures else [picture])]

    return new_folder(name, out, fill)


@dataclass
class Written:
    """Written folder of a run: files, averages, failures (`missing`), and files left out."""

    folder: Path
    files: list[str]
    missing: list[str]
    averages: tuple[Average, ...] = ()
    left_out: list[str] = field(default_factory=list)


def write(
    solution: Solution,
    out: Path | None,
    *,
    plots: bool,
    averages: bool = False,
    stopping: Stopping | None = None,
    request: Mapping[str, Any] | None = None,
) -> Written:
    """Write a run to `out`, or to the next free runs/<scene>-NNN: data first, then derived files.

    `request` is recorded with it. The data, states.npz and run.json, appear at once. Averages, states.csv and
    pictures follow independently: a failed or stopped one is reported in run.json and leaves no part of a file.
    Raises OSError where no data can be written.
    """
    stop = stopping or Stopping(Progress("", shown=False))
    lost = list(solution.engine.findings.compute_all())
    stop.stage("writing states.npz")
    folder, files = new_folder(solution.engine.model.name, out, lambda at: _write_data(solution, at, lost, request))
    written = Written(folder, files, lost)
    extras = _Extras(solution, written, stop)
    if averages:
        extras.make("averages", lambda _: setattr(written, "averages", solution.averages()))
    extras.make_csv()
    if solution.engine.derivatives is not None:
        extras.make("sensitivities.csv", lambda at: _write_derivatives(solution, at / "sensitivities.csv"))
    if plots:
        extras.make_pictures()
    missing = [*lost, *written.left_out]
    if missing or averages:
        extras.guarded(
            "run.json",
            lambda: write_atomically(folder / "run.json", _text(solution, missing, request, written.averages)),
        )
    return written


@dataclass
class _Extras:
    """Files made from the data of a run that are written already."""

    solution: Solution
    written: Written
    stop: Stopping

    def make(self, name: str, make: Callable[[Path], object]) -> None:
        """Make one file, or something without a file, in a scratch folder, and move complete files."""
        if self.stop.requested:
            self.written.missing.append(f"{name} is missing: it was stopped before")
            return
        self.guarded(name, lambda: self._made(name, make))

    def _made(self, name: str, make: Callable[[Path], object]) -> None:
        with self.stop.at_once(), scratch_folder(self.written.folder.parent) as at:
            self.stop.stage(f"writing {name}")
            make(at)
            for file in sorted(at.iterdir()):
                file.replace(self.written.folder / file.name)
                self.written.files.append(file.name)

    def guarded(self, name: str, make: Callable[[], object]) -> None:
        """Run a task whose failure is reported but not raised."""
        try:
            make()
        except KeyboardInterrupt:
            self.written.missing.append(f"{name} is missing: it was stopped while it was made")
        except Exception as error:  # whatever it is: the data are there, and so is what else can be made from them
            self.written.missing.append(f"{name} could not be made: {type(error).__name__}: {error}")

    def make_csv(self) -> None:
        """Write states.csv, unless it would be large."""
        from hertzwerk.runtime.engine.solution.solution import csv_size

        size = csv_size(self.solution)
        if size <= CSV_LIMIT:
            self.make("states.csv", lambda at: self.solution.to_file(at / "states.csv"))
            return
        self.written.left_out.append(
            f"states.csv would have {size / 1e6:.0f} MB and is not written: states.npz has the same; --table FILE.csv writes it, "
            f'--grid 10000 keeps less, and Solution.load("states.npz").to_file("states.csv") makes it later'
        )

    def make_pictures(self) -> None:
        """Draw the mechanism, the overview and one picture of each pair."""
        from hertzwerk.runtime.engine.run.continuation import with_steps

        drawn = cache(partial(with_steps, self.solution))  # a run that kept a grid is made again for them, once

        def mechanism(at: Path) -> None:
            from hertzwerk.runtime.output.drawings import picture
            from hertzwerk.runtime.output.plots.save_figure import png_of

            (at / "mechanism.png").write_bytes(png_of(picture.of_run(drawn())))

        @cache
        def pages() -> Mapping[str, Callable[[Path], None]]:
            from hertzwerk.runtime.output.plots import plot_run  # slow to import: not after a stop

            return plot_run.pages(drawn())

        def page(name: str, at: Path) -> None:
            pages()[name](at / f"{name}.png")

        makers: dict[str, Callable[[Path], object]] = {"overview": partial(page, "overview"), "mechanism": mechanism}
        makers |= {name: partial(page, name) for name in self._pictured()}
        with suppress(Exception, KeyboardInterrupt), self.stop.at_once():  # each page reports what is wrong with it
            if not self.stop.requested:
                pages()
        made = side_by_side([partial(self._apart, f"{name}.png", make) for name, make in makers.items()])
        for i, name in enumerate(makers):
            files, missing = made.get(i, ([], [f"{name}.png is missing: the process that drew it ended"]))
            self.written.files += files
            self.written.missing += missing

    def _pictured(self) -> list[str]:
        """Return the pairs that get a picture: of many those with the largest forces."""
        pairs = self.solution.engine.model.pairs
        if len(pairs) <= PICTURED:
            return [*pairs]
        peaks: dict[str, float] = {}
        with suppress(Exception):  # of impacts that cannot be found the run's record tells
            for impact in self.solution.impacts:
                peaks[impact.contact] = max(impact.peak_force, peaks.get(impact.contact, 0.0))
        shown = sorted(peaks, key=lambda pair: peaks[pair])[-PICTURED:]
        self.written.left_out.append(
            f"{len(pairs) - len(shown)} of {len(pairs)} pairs have no picture: of many only the {PICTURED} with the largest forces do; "
            "Solution.plot(PAIR) draws any other"
        )
        return [pair for pair in pairs if pair in shown]

    def _apart(self, name: str, make: Callable[[Path], object]) -> tuple[list[str], list[str]]:
        """Make one file; return the files that are there, and what is missing."""
        written = Written(self.written.folder, [], [])
        _Extras(self.solution, written, self.stop).make(name, make)
        return written.files, written.missing


def _write_data(solution: Solution, folder: Path, lost: list[str], request: Mapping[str, Any] | None) -> list[str]:
    """Write states.npz and run.json, either one if the other fails; raises OSError if both fail."""
    files: list[str] = []
    errors: list[OSError] = []
    for file, make in (
        ("states.npz", lambda path: solution.save(path)),
        ("run.json", lambda path: write_atomically(path, _text(solution, lost, request))),
    ):
        try:
            make(folder / file)
            files.append(file)
        except OSError as error:
            errors.append(error)
            lost.append(f"{file} could not be written: {error}")
    if not files:
        raise errors[0]
    return files


def _write_derivatives(solution: Solution, path: Path) -> None:
    """Write the derivatives of every state and normal force, by each name, over the run's rows."""
    of = solution.sensitivities()
    histories = [*solution.engine.states, *(f"{pair}.normal_force" for pair in solution.engine.model.pairs)]
    columns = [(history, name) for name in of.names for history in histories]
    header = ",".join(["t [s]", *(f"d({history})/d({name}) [{of.unit(history, name)}]" for history, name in columns)])
    text = io.StringIO()
    np.savetxt(
        text,
        np.column_stack(
            [
                solution.t,
                *(of[column] if solution.engine.history.steps else of.at(solution.t, *column) for column in columns),
            ]
        ),
        "%.17g",
        ",",
        header=header,
        comments="",
    )
    write_atomically(path, text.getvalue().encode())


def _text(
    solution: Solution, lost: Sequence[str], request: Mapping[str, Any] | None, averages: Sequence[Average] = ()
) -> bytes:
    content = record(solution)
    content |= {"averages": [asdict(average) for average in averages]} if averages else {}
    content |= {"request": dict(request)} if request is not None else {}
    return record_text({**content, "warnings": [*content["warnings"], *lost]}).encode()
