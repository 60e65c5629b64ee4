"""Text fitted to the terminal: lines broken between words, wide tables in panels, unbroken in a pipe."""

from __future__ import annotations

import shutil
import sys
import textwrap
from collections.abc import Iterator, Sequence
from itertools import zip_longest

GAP = "  "
PROSE = 100  # columns of prose in a pipe
WHOLE = 16  # longest cell that is never broken


def columns() -> int | None:
    """Return the width of the terminal at standard output; None if it is none."""
    return shutil.get_terminal_size().columns if sys.stdout.isatty() else None


def wrapped(text: str, width: int | None, *, indent: int = 0) -> str:
    """Break each line of a text between words.

    Its further lines are indented as the line, and by `indent` more.
    """
    if width is None:
        return text
    return "\n".join(_wrapped_line(line, width, indent) for line in text.split("\n"))


def _wrapped_line(line: str, width: int, indent: int) -> str:
    if len(line) <= width:
        return line
    margin = " " * (len(line) - len(line.lstrip()) + indent)
    parts = textwrap.wrap(
        line, width, drop_whitespace=True, subsequent_indent=margin, break_long_words=False, break_on_hyphens=False
    )
    return "\n".join(parts)


def tabulated(header: Sequence[str], rows: Sequence[Sequence[str]], width: int | None) -> Iterator[list[list[str]]]:
    """Yield the lines of each panel of a table, as padded cells.

    A cell with more words than its column holds continues in the next line. Panels are as many as needed to break no
    word, each beginning with the first column.
    """
    cells = list(zip(header, *rows, strict=True))
    natural = [max(map(len, column)) for column in cells]
    if width is None:
        yield _lines(cells, natural)
        return
    least = [natural[0], *(_least(column) for column in cells[1:])]
    panel: list[int] = [0]
    for j in range(1, len(cells)):
        if len(panel) > 1 and _wide([least[k] for k in (*panel, j)]) > width:
            yield _lines([cells[k] for k in panel], _shared([(least[k], natural[k]) for k in panel], width))
            panel = [0]
        panel.append(j)
    yield _lines([cells[k] for k in panel], _shared([(least[k], natural[k]) for k in panel], width))


def _least(column: Sequence[str]) -> int:
    """Return the width below which a column breaks a word, or a cell that is read as one."""
    whole = max((len(cell) for cell in column if len(cell) <= WHOLE), default=0)
    return max(whole, max(len(word) for cell in column for word in cell.split() or [""]))


def _wide(widths: Sequence[int]) -> int:
    return sum(widths) + len(GAP) * (len(widths) - 1)


def _shared(bounds: Sequence[tuple[int, int]], width: int) -> list[int]:
    """Return the widths of columns from (least, natural); surplus goes first to those that need least."""
    widths = [least for least, _ in bounds]
    surplus = max(width - _wide(widths), 0)
    order = sorted(range(len(bounds)), key=lambda j: bounds[j][1] - bounds[j][0])
    for done, j in enumerate(order):
        more = min(bounds[j][1] - bounds[j][0], surplus // (len(order) - done))
        widths[j] += more
        surplus -= more
    return widths


def _lines(cells: Sequence[Sequence[str]], widths: Sequence[int]) -> list[list[str]]:
    lines = []
    for row in zip(*cells, strict=True):
        parts = [wrapped(cell, width).split("\n") for cell, width in zip(row, widths, strict=True)]
        for line in zip_longest(*parts, fillvalue=""):
            lines.append([part.ljust(width) for part, width in zip(line, widths, strict=True)])  # noqa: PERF401
    return lines
