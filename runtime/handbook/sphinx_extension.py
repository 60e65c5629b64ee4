"""Extension of Sphinx: formulas as MathML, without a script or a network; docstrings."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from docutils.nodes import math, math_block
    from sphinx.application import Sphinx
    from sphinx.writers.html5 import HTML5Translator


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the renderer of formulas and the reader of docstrings; Sphinx calls this."""
    app.connect("autodoc-process-docstring", _process)
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _inline(translator: HTML5Translator, node: math) -> None:
    translator.body.append(_mathml(node.astext(), "inline"))
    _skip()


def _block(translator: HTML5Translator, node: math_block) -> None:
    translator.body.append(f'<div class="formula">{_mathml(node.astext(), "block")}</div>\n')
    _skip()


def _skip() -> None:
    from docutils.nodes import SkipNode

    raise SkipNode


def _mathml(latex: str, display: str) -> str:
    from latex2mathml.converter import convert

    return str(convert(latex, display=display))


# -- docstrings --------------------------------------------------------------------------------------------------------

_ENTRY = re.compile(r"(\S(?:.*?\S)?) {2,}(\S.*)")


def _process(_app: Sphinx, _kind: str, _name: str, _member: Any, _options: Any, lines: list[str]) -> None:
    lines[:] = restructured(lines)


def restructured(lines: list[str]) -> list[str]:
    """Return the lines of a docstring as reStructuredText.

    A name, two spaces or more and a text are an entry of a list; indented lines after it go on with it. Other indented
    lines stay as they are.
    """
    result: list[str] = []
    state = ""
    for line in lines:
        entry = _ENTRY.fullmatch(line) if not line.startswith(" ") else None
        if entry:
            result += [*[""] * (state != "entry"), _escaped(entry[1]), f"    {_escaped(entry[2])}"]
        elif line.startswith(" ") and state == "entry":
            result.append(f"    {_escaped(line.strip())}")
        elif line.startswith(" "):
            result += [*(["::", ""] if state != "literal" else []), line]
        elif line:
            result += [*[""] * (state in ("entry", "literal")), _escaped(line)]
        else:
            result.append("")
        if line:
            state = (
                "entry" if entry or (state == "entry" and line.startswith(" ")) else "literal" * line.startswith(" ")
            )
        elif state == "entry":
            state = ""
    return result


def _escaped(text: str) -> str:
    """Return a text with marks of its own escaped, and what stands in backticks as code."""
    parts = re.split(r"`([^`]+)`", text)
    plain = (re.sub(r"([\\*|_`])", r"\\\1", part) for part in parts[::2])
    code = (f"\\ ``{part}``\\ " for part in parts[1::2])
    return "".join(x for pair in zip(plain, [*code, ""], strict=True) for x in pair)
