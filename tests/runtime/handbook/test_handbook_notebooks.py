"""The lessons as notebooks: the same text and code as the pages, in the form that Jupyter reads."""

import json
import re

import pytest

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.handbook.notebooks import notebook, write_notebooks
from hertzwerk.runtime.handbook.page_code import PageError, run_page


@pytest.fixture(scope="module")
def lessons(tmp_path_factory):
    folder = tmp_path_factory.mktemp("notebooks")
    return {name: json.loads((folder / name).read_text(encoding="utf-8")) for name in write_notebooks(folder)}


def sources(content, kind):
    return ["".join(cell["source"]) for cell in content["cells"] if cell["cell_type"] == kind]


def test_there_are_six_with_text_code_and_links_to_each_other(lessons):
    assert len(lessons) == 6
    for content in lessons.values():
        assert (content["nbformat"], content["nbformat_minor"]) == (4, 5)
        assert len({cell["id"] for cell in content["cells"]}) == len(content["cells"])
        assert all("outputs" in cell for cell in content["cells"] if cell["cell_type"] == "code")
        linked = re.findall(r"\]\((lesson[^)]*)\)", "\n".join(sources(content, "markdown")))
        assert set(linked) <= {*lessons}
    assert sum(len(sources(content, "code")) for content in lessons.values()) > 30


# CI runs the same code as pages
@pytest.mark.parametrize("lesson", [0, *(pytest.param(i, marks=pytest.mark.exhaustive) for i in range(1, 6))])
def test_cells_run_in_order(lessons, lesson, tmp_path):
    """As IPython would: lines that begin with an exclamation mark are commands."""
    text = ""
    for cell in sources([*lessons.values()][lesson], "code"):
        commands = cell.startswith("!")
        code = re.sub("^!", "", cell, flags=re.MULTILINE)
        text += f"```{'sh' if commands else 'python'}\n{code}\n```\n\n"
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    (tmp_path / "cells").mkdir()
    run_page(page, tmp_path / "cells", main)


def test_a_file_that_a_page_shows_is_written_by_its_cell(tmp_path):
    page = "# A\n\n```toml\n# a.toml\nb = 1\n```\n\n```output\nnothing\n```\n\nText.\n"
    content = notebook(page)
    assert sources(content, "markdown") == ["# A", "Text."]
    (cell,) = sources(content, "code")
    (tmp_path / "page.md").write_text(
        f"```python\n{cell}\nassert Path('a.toml').read_text() == '# a.toml\\nb = 1'\n```\n"
    )
    run_page(tmp_path / "page.md", tmp_path, main)
    (tmp_path / "page.md").write_text("```python\nprint(1)\n```\n\n```output\n2\n```\n")
    with pytest.raises(PageError):
        run_page(tmp_path / "page.md", tmp_path, main)
