"""Web pages of the handbook: a copy of its Markdown and the pictures of its code, built by Sphinx."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from warnings import catch_warnings, simplefilter

from hertzwerk.runtime.handbook.reference_pages import write_reference
from hertzwerk.runtime.system.forked_tasks import cores

_RUN = """
import sys
from pathlib import Path
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.handbook.page_code import run_page
run_page(Path(sys.argv[1]), Path(), main)
"""
SOURCE = Path(__file__).parent
_PICTURE = re.compile(r"!\[[^\]]*\]\(([\w.-]+\.(?:png|svg|gif))\)")


def pages() -> list[Path]:
    """Return the Markdown files of the handbook."""
    return sorted(SOURCE.rglob("*.md"))


def pictures_of(page: str) -> list[str]:
    """Return the names of the pictures that a page shows, which its code draws."""
    return _PICTURE.findall(page)


def build(
    out: Path,
    command: Any,
    *,
    pictures: bool = True,
    builder: str = "html",
    progress: Callable[[float], object] = lambda _: None,
) -> str:
    """Build the web pages into a folder; return the warnings of Sphinx, "" for none.

    command    the command line, `hertzwerk.runtime.cli.main`, for its pages of reference
    pictures   False: empty ones stand in place of those that code draws
    builder    of Sphinx; "linkcheck" requests the external links, and warns of those without an answer
    progress   called with the fraction done, as pictures are drawn
    """
    with TemporaryDirectory() as folder:
        stage = Path(folder)
        for page in pages():
            copy = stage / page.relative_to(SOURCE)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(page, copy)
        write_reference(stage / "reference", command)
        _draw_all(stage, progress, pictures=pictures)
        return sphinx(stage, out, builder)


def _draw_all(stage: Path, progress: Callable[[float], object], *, pictures: bool) -> None:
    """Run the pages that show pictures, in processes beside each other, or write empty pictures."""
    shown = {page: names for page in stage.rglob("*.md") if (names := pictures_of(page.read_text("utf-8")))}
    if pictures:
        with ThreadPoolExecutor(cores()) as pool:
            for number, _ in enumerate(pool.map(_draw, shown, shown.values()), 1):
                progress(number / (len(shown) + 1))
        return
    from PIL import Image

    blank = Image.new("L", (1, 1), "white")
    for place in (page.parent / name for page, names in shown.items() for name in names):
        blank.save(place, "png")


def _draw(page: Path, names: list[str]) -> None:
    """Run a page in a process of its own and put its pictures beside it; raises CalledProcessError."""
    with TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-c", _RUN, str(page)], cwd=folder, check=True, stdin=subprocess.DEVNULL)
        for name in names:
            shutil.copyfile(Path(folder, name), page.parent / name)


def sphinx(stage: Path, out: Path, builder: str) -> str:
    """Build a folder of Markdown files with the settings of the handbook; return the warnings."""
    from sphinx.application import Sphinx
    from sphinx.util.docutils import docutils_namespace

    warnings = io.StringIO()
    with catch_warnings(), docutils_namespace():  # a process may build twice
        simplefilter("ignore")  # deprecations within Sphinx and its extensions; what it finds in pages is in the stream
        app = Sphinx(stage, SOURCE, out, out / ".doctrees", builder, status=None, warning=warnings)
        app.build()
    return re.sub(r"\x1b\[[\d;]*m", "", warnings.getvalue()).replace(f"{stage}/", "").strip()
