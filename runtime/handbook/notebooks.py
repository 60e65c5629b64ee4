"""Lessons of the tutorial as notebooks of Jupyter, made from the pages' own text."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from hertzwerk.runtime.handbook.page_code import Block, between_blocks, blocks
from hertzwerk.runtime.handbook.web_pages import SOURCE

_LINK = re.compile(r"\]\(([\w/.-]+)\.md\)")


def write_notebooks(folder: Path) -> list[str]:
    """Write a notebook for each lesson into a folder; return the names of the files."""
    lessons = sorted((SOURCE / "tutorial").glob("lesson-*.md"))
    for lesson in lessons:
        (folder / f"{lesson.stem}.ipynb").write_text(
            json.dumps(notebook(lesson.read_text(encoding="utf-8")), indent=1, ensure_ascii=False) + "\n",
            encoding="utf-8",
        )
    return [f"{lesson.stem}.ipynb" for lesson in lessons]


def notebook(page: str) -> dict[str, Any]:
    """Return a page as a notebook (nbformat 4.5): text and code, without outputs, which running it makes."""
    cells = []
    for text, block in zip(between_blocks(page), [*blocks(page), None], strict=True):
        if text.strip():
            cells.append(_cell("markdown", _LINK.sub(r"](\1.ipynb)", text).strip()))
        if block is not None and block.language != "output":
            cells.append(_cell("code", code_of(block)))
    for number, cell in enumerate(cells):
        cell["id"] = f"cell-{number}"
    metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": metadata, "cells": cells}


def code_of(block: Block) -> str:
    """Return the Python code of a cell: a block that begins with the name of a file writes it too."""
    text = block.text.rstrip()
    write = f"from pathlib import Path\n\nPath({block.file!r}).write_text({text!r})\n" if block.file else ""
    if block.language == "sh":
        return "\n".join(f"!{line}" for line in text.splitlines())
    return write + text * (block.language == "python")


def _cell(kind: str, text: str) -> dict[str, Any]:
    own: dict[str, Any] = {"execution_count": None, "outputs": []} if kind == "code" else {}
    return {"cell_type": kind, "id": "", "metadata": {}, **own, "source": text.splitlines(keepends=True)}
