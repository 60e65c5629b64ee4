"""What is printed on a narrow terminal: no word broken, nothing beyond the last column, the words of a pipe; colours where they are wanted."""

import io
import os
import pty
import re
import subprocess
import sys
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime.cli import line_wrapping, terminal
from hertzwerk.runtime.cli.line_wrapping import tabulated, wrapped

WORDS = st.text(st.characters(codec="ascii", categories=("L", "N", "P")), min_size=1, max_size=12)
TEXTS = st.lists(WORDS, max_size=12).map(" ".join)
HARDCASES = "hardcases --case exponent_1 --method dop853 --method esdirk --method auto --method rodas --method dopri5"


@given(text=TEXTS, width=st.integers(12, 60), indent=st.integers(0, 4))
def test_folding_keeps_the_words_and_the_width(text, width, indent):
    lines = wrapped(text, width, indent=indent).split("\n")
    assert " ".join(lines).split() == text.split()
    assert all(len(line) <= width or len(line.split()) == 1 for line in lines)


@given(
    table=st.integers(1, 6).flatmap(lambda n: st.lists(st.lists(TEXTS, min_size=n, max_size=n), min_size=1, max_size=5)), width=st.integers(30, 90),
)  # fmt: skip
def test_a_table_in_panels_has_every_word_whole_and_begins_each_with_the_first_column(table, width):
    header, *rows = table
    panels = list(tabulated(header, rows, width))
    words = sorted(word for row in table for cell in row for word in cell.split())
    first = sorted(word for row in table for word in row[0].split())
    shown = sorted(word for lines in panels for line in lines for cell in line for word in cell.split())
    assert shown == sorted(words + first * (len(panels) - 1))
    columns = list(zip(*table, strict=True))
    whole = (
        max([0, *(len(part) for cell in column for part in ([cell] if len(cell) <= 16 else cell.split()))])
        for column in columns[1:]
    )
    unbroken = max(map(len, columns[0])) + max([0, *(2 + width for width in whole)])
    for lines in panels:
        assert len({len("  ".join(line)) for line in lines}) == 1
        assert len("  ".join(lines[0])) <= max(width, unbroken)


def test_a_table_that_fits_is_one_panel_as_in_a_pipe():
    table = ("law", "grade"), [("flores", "A"), ("a law", "")]
    assert list(tabulated(*table, 80)) == list(tabulated(*table, None)) == [
        [["law   ", "grade"], ["flores", "A    "], ["a law ", "     "]]
    ]  # fmt: skip


@cache
def on_terminal(command, **environment):
    """What a command prints on a terminal of 80 columns."""
    code = "import os, sys; from hertzwerk.runtime.cli import main; main(sys.argv[1:], prog_name='hertzwerk')"
    main, of_terminal = pty.openpty()
    environment = {**os.environ, "COLUMNS": "80", "TERM": "xterm", **environment}
    process = subprocess.Popen(
        [sys.executable, "-c", code, *command.split()], stdout=of_terminal, stderr=subprocess.DEVNULL, env=environment
    )
    os.close(of_terminal)
    read = b""
    while True:
        try:
            chunk = os.read(main, 65536)
        except OSError:  # its other end is closed
            break
        if not chunk:
            break
        read += chunk
    os.close(main)
    process.wait(60)
    return read.decode().replace("\r\n", "\n")


@pytest.mark.parametrize(
    "command",
    ["list woodpecker", "laws", *(pytest.param(line, marks=pytest.mark.exhaustive) for line in ("hardcases --list", "laws flores", HARDCASES))],
)  # fmt: skip
def test_commands_fit_80_columns(command):
    lines = re.sub(r"\x1b\[[0-9;]*m", "", on_terminal(command)).split("\n")
    assert len(lines) > 10
    assert max(map(len, lines)) <= 80


def test_the_list_has_one_line_a_scene_and_colours_are_for_terminals_that_want_them():
    lines = on_terminal("list").splitlines()
    assert [line.split()[0] for line in lines] == ["scene", *NAMES]
    assert max(map(len, lines)) <= 80
    assert "\x1b[32mconsistent\x1b[0m" in on_terminal("laws")
    assert "\x1b" not in on_terminal("laws", NO_COLOR="1")


def test_a_line_with_a_long_label_fits_a_terminal_too(monkeypatch, capsys):
    monkeypatch.setattr(line_wrapping, "columns", lambda: 80)
    terminal.line("accuracy_unreachable", text := " ".join(["word"] * 60))
    terminal.print_prose(f"output\n    clearance: {text}", indent=4)
    lines = capsys.readouterr().out.split("\n")
    assert max(map(len, lines)) <= 80
    assert " ".join(lines).split() == ["accuracy_unreachable", *text.split(), "output", "clearance:", *text.split()]


def test_long_work_is_shown_from_its_beginning_with_the_share_done_and_the_time_left(monkeypatch):
    """On a terminal alone; what a command prints meanwhile stands on lines of its own."""
    shown, now = io.StringIO(), [0.0]
    monkeypatch.setattr(shown, "isatty", lambda: True, raising=False)
    monkeypatch.setattr(sys, "stderr", shown)
    monkeypatch.setattr(terminal.time, "perf_counter", lambda: now[0])
    with terminal.Progress("work") as progress:
        assert shown.getvalue().endswith("\rwork")
        for item in progress.over(["one", "two", "three", "four"]):
            assert f"work: {item}" in shown.getvalue()
            now[0] += 10
        assert "work: four  [######################--------]  75%  0:10 to go" in shown.getvalue()
        progress.aside(lambda: shown.write("printed"))
    assert re.search(r"\r *\rprinted$", shown.getvalue())
    before = shown.getvalue()
    with terminal.Progress("work", shown=False) as progress:
        assert list(progress.over("ab")) == ["a", "b"]
    assert shown.getvalue() == before


SHOWN_FIRST = """
import sys
from click.testing import CliRunner
from hertzwerk.runtime.cli import main, terminal

class Shown(Exception):
    pass

def enter(progress):
    raise Shown

terminal.Progress.__enter__ = enter
for line in sys.argv[1:]:
    shown = CliRunner().invoke(main, line.split())
    print(line, isinstance(shown.exception, Shown), sorted({"sympy", "matplotlib"} & sys.modules.keys()))
"""


def test_commands_show_themselves_before_they_import_what_takes_long():
    """SymPy and Matplotlib take a second of processor time each."""
    lines = ["draw pendulum", "derive pendulum --check", "audit pendulum", "audit --laws", "statics pendulum", "modes pendulum", "report pendulum",
             "validate pendulum", "export pendulum --c c", "animate pendulum", "hardcases", "run pendulum", "effects pendulum"]  # fmt: skip
    done = subprocess.run([sys.executable, "-c", SHOWN_FIRST, *lines], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == [f"{line} True []" for line in lines]
