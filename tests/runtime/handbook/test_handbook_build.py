"""The web pages of the handbook: Sphinx has no warning, and a page requests nothing from a network."""

import re

import pytest

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.handbook.reference_pages import laws_page
from hertzwerk.runtime.handbook.web_pages import build


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    return folder, build(folder, main, pictures=False)


@pytest.mark.slow
def test_sphinx_has_no_warnings(built):
    assert built[1] == ""


@pytest.mark.slow
def test_pages_request_nothing_from_a_network(built):
    """Links that a reader follows aside."""
    pages = list(built[0].rglob("*.html"))
    assert len(pages) > 5
    assert [(page.name, url) for page in pages for url in requested(page.read_text(encoding="utf-8"))] == []


def test_every_law_is_in_a_table_of_three_columns():
    """Rows with more cells than the heading would lose what is behind them."""
    rows = [line for line in laws_page().splitlines() if line.startswith(("| `", "| law "))]
    assert len(rows) > 50
    assert {row.count(" | ") for row in rows} == {2}


@pytest.mark.exhaustive
def test_pictures_are_drawn_and_shown(tmp_path):
    assert build(tmp_path / "pages", main) == ""
    shown = {path.name: path.stat().st_size for path in (tmp_path / "pages" / "_images").iterdir()}
    assert {"bouncing_ball.png", "damping.png", "slider_pin.png"} <= set(shown)
    assert min(shown.values()) > 5000


def requested(page):
    """Addresses of other machines that a browser loads with a page."""
    return re.findall(r"<(?:script|link|img|iframe|source)\b[^>]*?(?:src|href)=\"((?:https?:)?//[^\"]*)\"", page)


@pytest.mark.parametrize("tag", ['<script src="https://cdn/x.js">', '<link rel="a" href="//b/c.css">'])
def test_a_request_would_be_found(tag):
    assert len(requested(f"<p>{tag}</p>")) == 1
    assert requested('<a href="https://example.org">x</a>') == []
