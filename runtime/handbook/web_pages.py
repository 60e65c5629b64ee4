"""Web pages of the handbook: a copy of its Markdown and the pictures of its code, built by Sphinx."""

from __future__ import annotations

import io
import os
import re
import shutil
import struct
import subprocess
import sys
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

_RUNNER = "hertzwerk.runtime.handbook.page_code"
SOURCE = Path(__file__).parent
_PICTURE = re.compile(r"!\[[^\]]*\]\(([\w.-]+\.(?:png|svg|gif))\)")


def pages() -> list[Path]:
    """Return the Markdown files of the handbook."""
    return sorted(SOURCE.rglob("*.md"))


def pictures_of(page: str) -> list[str]:
    """Return the names of the pictures that a page shows, which its code draws."""
    return _PICTURE.findall(page)


def build(out: Path, *, pictures: bool = True) -> str:
    """Build the web pages into a folder; return the warnings of Sphinx, "" for none.

    With `pictures=False` empty pictures stand in place of those that the code of pages draws.
    """
    with TemporaryDirectory() as folder:
        stage = Path(folder)
        for page in pages():
            copy = stage / page.relative_to(SOURCE)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(page, copy)
        drawn = {page: names for page in stage.rglob("*.md") if (names := pictures_of(page.read_text("utf-8")))}
        if pictures:
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                list(pool.map(_draw, drawn, drawn.values()))
        else:
            for page, names in drawn.items():
                for name in names:
                    (page.parent / name).write_bytes(_BLANK)
        return _sphinx(stage, out)


def _draw(page: Path, names: list[str]) -> None:
    """Run a page in a process of its own and put its pictures beside it; raises CalledProcessError."""
    with TemporaryDirectory() as folder:
        code = f"from {_RUNNER} import run_page; from pathlib import Path; run_page(Path({str(page)!r}), Path())"
        subprocess.run([sys.executable, "-c", code], cwd=folder, check=True, stdin=subprocess.DEVNULL)
        for name in names:
            shutil.copyfile(Path(folder, name), page.parent / name)


def _sphinx(stage: Path, out: Path) -> str:
    from sphinx.application import Sphinx

    warnings = io.StringIO()
    app = Sphinx(stage, SOURCE, out, out / ".doctrees", "html", status=None, warning=warnings)
    app.build()
    return re.sub(r"\x1b\[[\d;]*m", "", warnings.getvalue()).replace(f"{stage}/", "").strip()


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


_BLANK = (
    b"\x89PNG\r\n\x1a\n"
    + _chunk(b"IHDR", struct.pack(">2I5B", 1, 1, 8, 0, 0, 0, 0))
    + _chunk(b"IDAT", zlib.compress(b"\0\xff"))
    + _chunk(b"IEND", b"")
)
