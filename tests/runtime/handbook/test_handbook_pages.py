"""Every page of the handbook does what it states: its code runs, prints its outputs and draws its pictures."""

import math
import re

import pytest
from each import each

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.engine.integration.loop import automatic_compilation
from hertzwerk.runtime.handbook.page_code import RUN, PageError, blocks, difference, is_long, run_page
from hertzwerk.runtime.handbook.web_pages import SOURCE, pages, pictures_of

TEXTS = {page.relative_to(SOURCE).as_posix(): page.read_text(encoding="utf-8") for page in pages()}
WITH_CODE = [
    pytest.param(name, marks=pytest.mark.exhaustive if is_long(text) else ())
    for name, text in TEXTS.items()
    if any(block.language in RUN for block in blocks(text))
]
LANGUAGES = {*RUN, "output", "console", "toml", "csv", "text", "xml", "c"}


@pytest.fixture(autouse=True)
def _uncompiled(monkeypatch):
    """To compile on the way changes no bit, and takes more of the processor than it saves a page."""
    monkeypatch.setattr(automatic_compilation, "LOOK", math.inf)


@pytest.mark.parametrize("name", WITH_CODE)
def test_code_runs_as_written(name, tmp_path):
    run_page(SOURCE / name, tmp_path, main)
    assert [picture for picture in pictures_of(TEXTS[name]) if not (tmp_path / picture).is_file()] == []


@each("name", TEXTS)
def test_every_block_is_of_a_known_language(name):
    """One that is not, a block that nobody closes among them, would not run."""
    fences = re.findall(r"^\s*```(.*)$", TEXTS[name], re.MULTILINE)
    assert len(fences) % 2 == 0
    assert {fence for fence in fences[::2] if not fence.startswith("{")} <= LANGUAGES
    assert not any(fences[1::2])


def page_of(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    return page


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("```python\nprint(2)\n```\n```output\n3.0\n```\n", "page.md:5: the page shows `3.0`, printed was `2`"),
        ("```python\nx = 1\n```\n\n```python\nassert x == 2, x\n```\n", "1"),
        ("```sh\nhertzwerk audit --expr K*d --unit K=N/m --unit d=m --expect Pa\n```\n", "page.md:2: .*exit code 1"),
        ("```sh\npip install x\n```\n", "is no command of hertzwerk"),
    ],
)
def test_a_block_that_does_not_do_what_the_page_states_is_found(tmp_path, text, fault):
    with pytest.raises((PageError, AssertionError), match=fault):
        run_page(page_of(tmp_path, text), tmp_path, main)


def test_blocks_share_names_files_and_exit_codes_and_errors_name_their_line(tmp_path):
    text = (
        "```python\n# half.py\nhalf = 1 / 2\n```\n```toml\n# a.toml\nb = 1\n```\n"
        "```python\nfrom pathlib import Path\nprint(half, Path('a.toml').read_text())\n```\n```output\n0.5 # a... b = 1\n```\n"
        "```sh\nhertzwerk audit --expr K*d --unit K=N/m --unit d=m --expect Pa  # exit code 1\n```\n"
    )
    run_page(page_of(tmp_path, text), tmp_path, main)
    assert (tmp_path / "half.py").is_file()
    with pytest.raises(ZeroDivisionError) as raised:
        run_page(page_of(tmp_path, "One\n\n```python\n\n1 / 0\n```\n"), tmp_path, main)
    assert raised.traceback[-1].lineno + 1 == 5


@each(
    ("shown", "printed", "same"),
    [
        ("error 4e-7", "error 4.3e-07", True), ("error 4e-7", "error 7e-07", False),
        ("1,204 steps", "1204 steps", False), ("1,204 steps", "1,205 steps", False), ("5 m", "5.8 m", True),
        ("-0.52 m", "-0.5213 m", True), ("-0.52 m", "-0.54 m", False), ("in ... ms", "in 3.1 s, 4 ms", True),
        ("in ... ms", "in 3.1 s", False), ("finished", "finished: 2", False), ("a ...", "a b c", True),
    ],
)  # fmt: skip
def test_outputs_agree_within_the_digits_shown(shown, printed, same):
    assert (difference(shown, printed) == "") == same


def test_the_front_matter_marks_long_pages():
    assert is_long("---\nlong: true\n---\n# A\n")
    assert not is_long("# A\n\nlong: true\n")
