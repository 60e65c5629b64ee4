"""Code of a handbook page: Python and commands, which run in the order in which they stand.

A block that begins with the name of a file, `# my_ball.py`, becomes that file first. A block `output` is the text that
the block before it prints. A command with the remark `# exit code 1` ends with that code.
"""

from __future__ import annotations

import contextlib
import io
import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

RUN = ("python", "sh")
_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_FILE = re.compile(r"(?:# |<!-- )(\w+\.\w+)(?: -->)?\n")
_EXIT = re.compile(r"#.*\bexit code (\d+)")
_TOKEN = re.compile(r"\.\.\.|-?\d[\d,]*(?:\.\d+)?(?:e[+-]?\d+)?|[^\W\d]+|\S")
_NUMBER = re.compile(r"-?\d[\d,]*(\.\d+)?(e[+-]?\d+)?")


@dataclass(frozen=True)
class Block:
    """Fenced block of a page: its language, its text, and the line at which the text begins."""

    language: str
    text: str
    line: int

    @property
    def file(self) -> str | None:
        """Name of the file that the text is, as its first line states it; None where it is no file."""
        return match[1] if (match := _FILE.match(self.text)) else None


class PageError(Exception):
    """A block of a page that does not do what the page states."""


def blocks(page: str) -> list[Block]:
    """Return the fenced blocks of a page, in order."""
    return [Block(match[1], match[2], page[: match.start(2)].count("\n") + 1) for match in _BLOCK.finditer(page)]


def between_blocks(page: str) -> list[str]:
    """Return the text before, between and after the blocks of a page: one more than these."""
    return _BLOCK.split(page)[:: _BLOCK.groups + 1]


def is_long(page: str) -> bool:
    """Return whether the front matter of a page says that its code takes minutes."""
    return re.match(r"---\n(?:.*\n)*?long: true\n(?:.*\n)*?---\n", page) is not None


def run_page(page: Path, folder: Path, command: Any) -> None:
    """Run the code of a page in a folder, in which its files appear; raises PageError.

    Exceptions of the code itself are raised too.

    command    the command line, `hertzwerk.runtime.cli.main`
    """
    names: dict[str, Any] = {"__name__": "__main__"}
    printed = ""
    with contextlib.chdir(folder):
        for block in blocks(page.read_text(encoding="utf-8")):
            if block.file:
                Path(block.file).write_text(block.text, encoding="utf-8")
            if block.language in RUN:
                stream = io.StringIO()
                with contextlib.redirect_stdout(stream):
                    _run(block, page, names, command)
                printed = stream.getvalue()
            elif block.language == "output" and (different := difference(block.text, printed)):
                raise PageError(f"{page}:{block.line}: the page shows {different}\nAll of it:\n{printed}")


def _run(block: Block, page: Path, names: dict[str, Any], command: Any) -> None:
    if block.language == "python":
        exec(compile("\n" * (block.line - 1) + block.text, str(page), "exec"), names)
        return
    for number, line in enumerate(block.text.splitlines(), block.line):
        if line and not line.startswith("#"):
            expected = int(code[1]) if (code := _EXIT.search(line)) else 0
            words = shlex.split(line, comments=True)
            if words[:1] != ["hertzwerk"]:
                raise PageError(f"{page}:{number}: `{line}` is no command of hertzwerk (blocks `console` do not run)")
            if (actual := int(command.main(words[1:], "hertzwerk", standalone_mode=False) or 0)) != expected:
                raise PageError(f"{page}:{number}: `{line}` ended with exit code {actual}")


def difference(shown: str, printed: str) -> str:
    """Return the first difference between a page's output and what was printed, or "".

    Space does not count, `...` stands for anything, and a number with decimals agrees within one and
    a half units of its last digit.
    """
    actual = iter(_TOKEN.findall(printed))
    expected = _TOKEN.findall(shown)
    for position, token in enumerate(expected):
        if token == "...":
            if position == len(expected) - 1:
                return ""
            actual = _from(actual, expected[position + 1])
        elif (other := next(actual, "")) != token and not _close(token, other):
            return f"`{' '.join(expected[max(position - 3, 0) : position + 3])}`, printed was `{other}`"
    return f"nothing, printed was `{rest}`" if (rest := next(actual, "")) else ""


def _from(tokens: Iterator[str], wanted: str) -> Iterator[str]:
    """Return the tokens from the first one that agrees with another."""
    rest = list(tokens)
    start = next((i for i, token in enumerate(rest) if token == wanted or _close(wanted, token)), len(rest))
    return iter(rest[start:])


def _close(shown: str, printed: str) -> bool:
    match = _NUMBER.fullmatch(shown)
    if match is None or _NUMBER.fullmatch(printed) is None or (shown + printed).replace(",", "").lstrip("-").isdigit():
        return False  # whole numbers, which count something, are equal or not
    exponent = int((match[2] or "e0")[1:])
    unit = 10.0 ** (exponent - max(len(match[1] or ".") - 1, 0))
    return abs(float(shown.replace(",", "")) - float(printed.replace(",", ""))) <= 1.5 * unit
