"""Printing of commands: lines, tables, progress, errors; colours and a bar on a terminal only."""

from __future__ import annotations

import contextlib
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self, TypeVar

import click

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.cli import line_wrapping
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Written = TypeVar("Written")
Item = TypeVar("Item")

GOOD, OTHER_OUTCOME, BAD_INPUT = 0, 1, 2
COLOURS = {
    "finished": "green",
    "consistent": "green",
    "passed": "green",
    "holds": "green",
    "failed": "red",
    "fails": "red",
    "inconsistent": "red",
    "outside_si": "red",
    "unchecked": "yellow",
    "different": "yellow",
    "known failure": "yellow",
    "warning": "yellow",
    "advice": "yellow",
    "remedy": "yellow",
    "written": "cyan",
}
BAR_AFTER, BETWEEN = 0.5, 0.1  # s: least age of a stage with a bar; between two updates
BAR, LONGEST = 30, 1e5  # characters; s: longest remaining time that is shown
NO_BREAK = "\N{NO-BREAK SPACE}"
WHOLE = re.compile(r"`[^`]+`|(?<=\d) (?=[A-Za-z]{1,3}\b)")  # commands, and numbers with their units, are not broken
INTERRUPTED = 130  # exit code of a process ended by SIGINT, as in a shell


def reports_bad_input(command: Callable[..., int]) -> Callable[..., None]:
    """Wrap a command to report bad input and missing packages with exit code 2, Ctrl-C with exit code 130."""

    def guarded(*args: Any, **options: Any) -> None:
        try:
            code = command(*args, **options)
        except InputError as error:
            _report_error(error)
            code = BAD_INPUT
        except OSError as error:
            if isinstance(error, BrokenPipeError):
                raise
            _report_error(error)
            code = BAD_INPUT
        except ModuleNotFoundError as error:
            package = str(error.name).partition(".")[0]
            if package == "hertzwerk":
                raise
            fault = Fault(package, "not installed", "a package that this command needs", f"pip install {package}")
            _report_error(InputError(command.__name__, [fault]))
            code = BAD_INPUT
        except KeyboardInterrupt:
            code = INTERRUPTED
        click.get_current_context().exit(code)

    guarded.__doc__ = command.__doc__
    guarded.__name__ = command.__name__
    return guarded


def written_or_none(write: Callable[[], Written], missing: list[str], *, wanted: bool) -> Written | None:
    """Return the result of `write`, if wanted; a failure is appended to `missing`."""
    if not wanted:
        return None
    try:
        return write()
    except (OSError, InputError) as error:
        missing.append(str(error))
        return None


def conclude(
    write: Callable[[list[str]], tuple[Path, list[str]]],
    content: Callable[[], dict[str, Any]],
    report: Callable[[], None],
    *,
    wanted: bool,
    as_json: bool,
) -> int:
    """Write a folder, if wanted, and print the content as JSON or the report; return the exit code.

    `write` returns the folder and its files; what it could not write it appends to the list.
    """

    missing: list[str] = []
    written = written_or_none(lambda: write(missing), missing, wanted=wanted)
    if as_json:
        click.echo(json_text(content()))
    else:
        report()
        if written is not None:
            line("written", f"{written[0]}/ ({', '.join(written[1])})")
    return report_missing(missing)


def draw_into(out: Path | None, picture: Callable[[], Figure], *, announced: bool) -> None:
    """Write a picture as PNG, if a file is given."""
    if out is None:
        return
    from hertzwerk.runtime.engine.solution.solution import write
    from hertzwerk.runtime.output.plots.save_figure import png_of

    path = write(out, png_of(picture(), dpi="figure"), overwrite=False)
    if announced:
        line("written", str(path))


def report_missing(missing: Sequence[str]) -> int:
    """Print warnings for what could not be written; return the exit code."""
    for text in missing:
        click.echo(f"{click.style('warning', fg='yellow')}  {text}", err=True)
    return OTHER_OUTCOME if missing else GOOD


def _report_error(error: Exception) -> None:
    width = shutil.get_terminal_size().columns if sys.stderr.isatty() else None
    text = line_wrapping.wrapped(f"error  {error}", width, indent=4).removeprefix("error")
    click.echo(click.style("error", fg="red") + text, err=True)


def line(label: str, text: str) -> None:
    """Print one line of a report, or several under one label; in a pipe, up to 100 columns."""
    width, room = line_wrapping.columns() or line_wrapping.PROSE, max(len(label), 12)
    bound = WHOLE.sub(lambda part: part[0].replace(" ", NO_BREAK), text)
    first, *rest = line_wrapping.wrapped(bound, width - room - 2).replace(NO_BREAK, " ").split("\n")
    click.echo(f"{click.style(f'{label:<12}', fg=COLOURS.get(label))}  {first}".rstrip())
    for line in rest:
        click.echo(f"{'':14}{line}".rstrip())


def report_damage(*damages: str) -> None:
    """Print what was found damaged among kept rows, and was computed again; empty texts are nothing."""
    for text in filter(None, damages):
        line("damage", text)


def print_prose(text: str, indent: int = 0) -> None:
    """Print prose, broken between words where a terminal ends, each line's further ones indented."""
    click.echo(line_wrapping.wrapped(text, line_wrapping.columns(), indent=indent))


def table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print aligned columns, in panels where a terminal is too narrow for them."""
    for panel, lines in enumerate(line_wrapping.tabulated(columns, rows, line_wrapping.columns())):
        if panel:
            click.echo()
        for row in lines:
            click.echo(line_wrapping.GAP.join(map(_coloured, row)).rstrip())


def _coloured(cell: str) -> str:
    """Return a cell in its colour; one that begins with ! is red."""
    word = cell.rstrip()
    colour = "red" if word.startswith("!") else COLOURS.get(word)
    return click.style(word, fg=colour) + cell[len(word) :] if colour else cell


class Progress:
    """Progress line on standard error, on a terminal only; called with the fraction done."""

    def __init__(self, title: str, *, shown: bool = True) -> None:
        self._title, self._shown = title, shown and sys.stderr.isatty()
        self._stage, self._width, self._from = "", 0, 0.0
        self._start = self._shown_at = time.perf_counter()

    def __enter__(self) -> Self:
        self._show(self._title)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._show("")

    def stage(self, name: str, done: float = 0.0) -> None:
        """Announce the stage that begins, a part of it done.

        Shown at once, as the stage may keep this process from reporting for a while.
        """
        self._stage, self._start, self._from = name, time.perf_counter(), done
        self._show(f"{self._title}: {name}")

    def over(self, items: Sequence[Item], name: Callable[[Item], str] = str) -> Iterator[Item]:
        """Yield items, each a stage; the time left is estimated from those before."""
        begun = time.perf_counter()
        for number, item in enumerate(items):
            self.stage(name(item))
            self._start = begun
            if number:
                self._bar(number / len(items))
            yield item

    def __call__(self, fraction: float) -> None:
        """Show the fraction done and the estimated time left."""
        now = time.perf_counter()
        if now - self._shown_at >= BETWEEN and now - self._start >= BAR_AFTER:
            self._bar(fraction)

    def _bar(self, fraction: float) -> None:
        seconds = (time.perf_counter() - self._start) * (1 - fraction) / max(fraction - self._from, 1e-9)
        rest = f"{seconds // 60:.0f}:{seconds % 60:02.0f} to go" if seconds < LONGEST else ""
        bar = "#" * round(BAR * min(fraction, 1))
        stage = f"{self._title}: {self._stage}" if self._stage else self._title
        self._show(f"{stage}  [{bar:-<{BAR}}] {fraction:4.0%}  {rest}")

    def aside(self, report: Callable[[], object]) -> None:
        """Let something print: the line disappears and returns with the next call."""
        self._show("")
        report()

    def _show(self, text: str) -> None:
        """Replace the line by a text.

        The cursor stays visible, so that a process which is killed leaves the terminal unchanged.
        """
        if not self._shown or (not text and not self._width):
            return
        self._shown_at = time.perf_counter()
        text = text.rstrip()[: shutil.get_terminal_size().columns - 1]
        with contextlib.suppress(OSError):  # the terminal may be gone
            sys.stderr.write(f"\r{text:<{self._width}}\r{text}")
            sys.stderr.flush()
        self._width = len(text)
