"""What every command prints with: lines, tables, progress, bad input. A terminal gets colours and a bar, a pipe gets plain text."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any, Self

import click

from hertzwerk.derive.faults import InputError

GOOD, OTHER_OUTCOME, BAD_INPUT = 0, 1, 2
COLOURS = {
    "finished": "green",
    "consistent": "green",
    "passed": "green",
    "failed": "red",
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
BAR_AFTER = 0.5  # s; what is done sooner needs no bar


def reports_bad_input(command: Callable[..., int]) -> Callable[..., None]:
    """A command whose InputError becomes one message and exit code 2, and so does a file that cannot be read or written."""

    def guarded(*args: Any, **options: Any) -> None:
        try:
            code = command(*args, **options)
        except InputError as error:
            click.echo(f"{click.style('error', fg='red')}  {error}", err=True)
            code = BAD_INPUT
        except OSError as error:
            if isinstance(error, BrokenPipeError):
                raise
            click.echo(f"{click.style('error', fg='red')}  {error}", err=True)
            code = BAD_INPUT
        click.get_current_context().exit(code)

    guarded.__doc__ = command.__doc__
    guarded.__name__ = command.__name__
    return guarded


def line(label: str, text: str) -> None:
    """One line of a report, or several under one label."""
    first, *rest = text.split("\n")
    click.echo(f"{click.style(f'{label:<12}', fg=COLOURS.get(label))}  {first}")
    for line in rest:
        click.echo(f"{'':14}{line}")


def table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """A table on a terminal, aligned plain text in a pipe."""
    if sys.stdout.isatty():
        from rich.box import SIMPLE_HEAD
        from rich.console import Console
        from rich.table import Table
        from rich.text import Text

        grid = Table(box=SIMPLE_HEAD)
        for column in columns:
            grid.add_column(column, no_wrap=column == columns[0], overflow="fold")
        for row in rows:
            grid.add_row(*(Text(cell, style=COLOURS.get(cell, "")) for cell in row))
        Console().print(grid)
        return
    widths = [max(len(cell) for cell in column) for column in zip(columns, *rows, strict=True)]
    for row in (columns, *rows):
        click.echo("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())


class Progress:
    """Called with the fraction done; shows a bar on a terminal once the work proves long."""

    def __init__(self, title: str, *, shown: bool) -> None:
        self._title = title
        self._shown = shown
        self._start = time.perf_counter()
        self._bar: Any = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def __call__(self, fraction: float) -> None:
        """Show the fraction done."""
        if not self._shown or (self._bar is None and time.perf_counter() - self._start < BAR_AFTER):
            return
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress as Bar

            self._bar = Bar(console=Console(stderr=True), transient=True)
            self._task = self._bar.add_task(self._title, total=1.0)
            self._bar.start()
        self._bar.update(self._task, completed=fraction)

    def aside(self, report: Callable[[], object]) -> None:
        """Let something print while a bar is up: the bar goes, and comes back with the next call."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None
        report()
