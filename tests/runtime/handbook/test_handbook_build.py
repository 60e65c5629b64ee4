"""The web pages of the handbook: Sphinx has no warning, and a page requests nothing from a network."""

import re
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.handbook.reference_pages import laws_page
from hertzwerk.runtime.handbook.web_pages import build, sphinx


@pytest.mark.slow
def test_pages_have_no_warnings_request_nothing_and_search_prefers_titles(tmp_path):
    """One build: each worker would make its own. Links that a reader follows aside."""
    assert build(tmp_path, main, pictures=False) == ""
    pages = list(tmp_path.rglob("*.html"))
    assert len(pages) > 5
    assert [(page.name, url) for page in pages for url in requested(page.read_text(encoding="utf-8"))] == []
    assert "8 * found.length" in (tmp_path / "_static" / "language_data.js").read_text(encoding="utf-8")


class Answer(BaseHTTPRequestHandler):
    """A site that has /here and no other page."""

    def do_HEAD(self):
        self.send_response(200 if self.path == "/here" else 404)
        self.end_headers()

    do_GET = do_HEAD

    def log_message(self, *_):
        """Nothing on the terminal."""


@pytest.mark.slow
def test_links_that_lead_nowhere_are_found(tmp_path):
    """To a page, a heading of another one and of its own, and to a site."""
    (stage := tmp_path / "stage").mkdir()
    (stage / "b.md").write_text("# B\n")
    with ThreadingHTTPServer(("127.0.0.1", 0), Answer) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        site = f"http://127.0.0.1:{server.server_port}"
        links = (f"{site}/here", f"{site}/gone", "b.md", "c.md", "b.md#none", "#nowhere")
        (stage / "index.md").write_text(
            "# A\n\n" + " ".join(f"[x]({link})" for link in links) + "\n```{toctree}\nb\n```\n"
        )
        warnings = sphinx(stage, tmp_path / "out", "linkcheck")
        server.shutdown()
    assert len(warnings.splitlines()) == 4
    assert [word for word in ("gone", "c.md", "'none'", "'nowhere'") if word not in warnings] == []


def test_external_addresses_stand_in_the_handbook_too():
    """There `hertzwerk handbook --links` requests them."""
    root = Path(__file__).parents[3]
    pages = "\n".join(page.read_text("utf-8") for page in (root / "runtime/handbook").rglob("*.md"))
    files = [
        *root.glob("*.md"),
        root / "pyproject.toml",
        *(root / "derive").rglob("*.py"),
        *(root / "derive").rglob("*.md"),
    ]
    found = {
        url
        for file in files
        for url in re.findall(r"https?://[^\s)>\"'`,]+", file.read_text("utf-8"))
        if "w3.org" not in url
    }
    assert found - set(re.findall(r"\((https?://[^\s)]+)\)", pages)) == set()


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
