"""Picture of a result as a new PNG file."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from hertzwerk.runtime.cli.terminal import line

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_into(out: Path | None, picture: Callable[[], Figure], *, announced: bool) -> None:
    """Write a picture as PNG, if a file is given."""
    if out is None:
        return
    from hertzwerk.runtime.engine.solution.solution import write

    content = io.BytesIO()
    picture().savefig(content, format="png", dpi="figure")
    path = write(out, content.getvalue(), overwrite=False)
    if announced:
        line("written", str(path))
