"""`hertzwerk handbook`: open the handbook, build its pages, check its links, write its notebooks."""

from __future__ import annotations

import sys
from hashlib import blake2b
from pathlib import Path
from tempfile import TemporaryDirectory

import click

from hertzwerk.derive.common.faults import refuse
from hertzwerk.runtime.cli.target_options import unwritable_faults
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input

FOLDER = click.Path(path_type=Path, file_okay=False)


@click.command(epilog="Example: hertzwerk handbook --build pages")
@click.option("--build", "pages", type=FOLDER, metavar="DIR", help="Build the web pages into a new folder.")
@click.option("--notebooks", type=FOLDER, metavar="DIR", help="Write the six lessons as Jupyter notebooks.")
@click.option("--links", is_flag=True, help="Check the external links of the pages over the network.")
@reports_bad_input
def handbook(pages: Path | None, notebooks: Path | None, links: bool) -> int:
    """Open the handbook in a browser, or show where its text is.

    The text is Markdown and part of the installation. `--build` makes web pages of it, with pictures, in a minute; that
    needs `pip install "hertzwerk[docs]"`. Pages that were built are opened from then on. They need no network.
    """
    refuse("handbook", [*unwritable_faults(pages, wanted=False), *unwritable_faults(notebooks, wanted=False)])
    if notebooks is not None:
        _write_notebooks(notebooks)
    if pages is not None or links:
        return max(_build(pages) if pages is not None else GOOD, _check_links() if links else GOOD)
    if notebooks is None:
        from hertzwerk.runtime.handbook.web_pages import SOURCE

        built = _built()
        line("pages" if built else "text", str(built or SOURCE / "index.md"))
        if built is None:
            line("build", "hertzwerk handbook --build DIR makes web pages of it")
        elif sys.stdout.isatty():
            click.launch(built.as_uri())
    return GOOD


def _build(out: Path) -> int:
    """Build the pages into a new folder, and remember where."""
    warnings: list[str] = []

    def fill(folder: Path) -> list[str]:
        warnings.append(build(folder, main, progress=progress))
        return ["index.html"]

    with Progress("handbook") as progress:
        from hertzwerk.runtime.cli import main
        from hertzwerk.runtime.handbook.web_pages import build
        from hertzwerk.runtime.system import cache
        from hertzwerk.runtime.system.result_folder import new_folder

        folder, files = new_folder("handbook", out, fill)
    index = (folder / files[0]).resolve()
    cache.keep(_key(), ".txt", str(index).encode())
    line("written", str(folder / files[0]))
    return _warned(warnings[0])


def _check_links() -> int:
    from hertzwerk.runtime.cli import main
    from hertzwerk.runtime.handbook.web_pages import build

    with TemporaryDirectory() as folder:
        return _warned(build(Path(folder), main, pictures=False, builder="linkcheck"))


def _warned(warnings: str) -> int:
    """Print the warnings of Sphinx, if any, and return the exit code."""
    if warnings:
        line("warning", warnings)
    return OTHER_OUTCOME if warnings else GOOD


def _built() -> Path | None:
    """Return the first page of the pages that were built from this text; None where there are none."""
    from hertzwerk.runtime.system import cache

    index = Path(cache.read(_key(), ".txt") or "")
    return index if index.is_file() else None


def _key() -> str:
    """Return the key of the built pages in the cache: a digest of the text."""
    from hertzwerk.runtime.handbook.web_pages import pages

    digest = blake2b(digest_size=16)
    for page in pages():
        digest.update(page.read_bytes())
    return f"handbook-{digest.hexdigest()}"


def _write_notebooks(out: Path) -> None:
    from hertzwerk.runtime.handbook.notebooks import write_notebooks
    from hertzwerk.runtime.system.result_folder import new_folder

    folder, files = new_folder("notebooks", out, write_notebooks)
    line("written", f"{folder}/ ({', '.join(files)})")
