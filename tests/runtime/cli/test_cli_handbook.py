"""`hertzwerk handbook`: where the text is, notebooks, and pages that are found again once they are built."""

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.handbook import web_pages


@pytest.fixture
def call(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    return lambda *words: CliRunner().invoke(main, ["handbook", *words])


def test_without_pages_it_shows_where_the_text_is(call):
    done = call()
    assert done.exit_code == 0
    assert str(web_pages.SOURCE / "index.md") in done.stdout
    assert "hertzwerk handbook --build" in done.stdout


def test_pages_that_were_built_are_found(call, tmp_path, monkeypatch):
    def build(folder, command):
        (folder / "index.html").write_text("<h1>hertzwerk</h1>")
        return ""

    monkeypatch.setattr(web_pages, "build", build)
    assert call("--build", "pages").exit_code == 0
    assert str(tmp_path / "pages" / "index.html") in call().stdout
    assert call("--build", "pages").exit_code == 2  # it has other content
    (tmp_path / "pages" / "index.html").unlink()
    assert str(web_pages.SOURCE) in call().stdout


@pytest.mark.parametrize("words", [("--build", "pages"), ("--links",)])
def test_warnings_of_sphinx_are_shown_and_end_it_with_one(call, monkeypatch, words):
    monkeypatch.setattr(web_pages, "build", lambda *_, **options: f"page.md:1: WARNING: link {options}")
    done = call(*words)
    assert (done.exit_code, "page.md:1: WARNING: link" in done.stdout) == (1, True)
    assert ("linkcheck" in done.stdout) == (words == ("--links",))


def test_notebooks_are_written_into_a_new_folder(call, tmp_path):
    assert call("--notebooks", "lessons").exit_code == 0
    assert len(list((tmp_path / "lessons").glob("*.ipynb"))) == 6
