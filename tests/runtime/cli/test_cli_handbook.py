"""`hertzwerk handbook`: where the text is, notebooks, and pages that are found again once they are built."""

import pytest

from hertzwerk.runtime.handbook import web_pages

COMMAND = ("handbook",)


@pytest.fixture(autouse=True)
def _cache(tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))


def test_it_shows_where_the_text_is_and_writes_notebooks(hertzwerk, tmp_path):
    done = hertzwerk()
    assert str(web_pages.SOURCE / "index.md") in done.stdout
    assert "hertzwerk handbook --build" in done.stdout
    hertzwerk("--notebooks", "lessons")
    assert len(list((tmp_path / "lessons").glob("*.ipynb"))) == 6


def test_pages_that_were_built_are_found(hertzwerk, tmp_path, monkeypatch):
    def build(folder, command, **_):
        (folder / "index.html").write_text("<h1>hertzwerk</h1>")
        return ""

    monkeypatch.setattr(web_pages, "build", build)
    hertzwerk("--build", "pages")
    assert str(tmp_path / "pages" / "index.html") in hertzwerk().stdout
    hertzwerk("--build", "pages", code=2)  # it has other content
    (tmp_path / "pages" / "index.html").unlink()
    assert str(web_pages.SOURCE) in hertzwerk().stdout


@pytest.mark.parametrize("words", [("--build", "pages"), ("--links",)])
def test_warnings_of_sphinx_are_shown_and_end_it_with_one(hertzwerk, monkeypatch, words):
    monkeypatch.setattr(web_pages, "build", lambda *_, **options: f"page.md:1: WARNING: link {options}")
    done = hertzwerk(*words, code=1)
    assert "page.md:1: WARNING: link" in done.stdout
    assert ("linkcheck" in done.stdout) == (words == ("--links",))
