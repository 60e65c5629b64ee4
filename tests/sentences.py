"""Lengths of the sentences of a Markdown page: code, formulas, tables, headings and targets of links excluded.

`python tests/sentences.py PAGE...` prints the mean, the share above 30 words and the longest sentence of each page.
"""

import re
import sys
from pathlib import Path

LONG, LONGEST, MEAN, SHARE = 30, 45, 16, 0.05
LEFT_OUT = (
    r"^(`{3,}|~{3,}|:{3,}).*?^\1[ \t]*$",  # fenced blocks: code, formulas, directives
    r"\A---\n.*?^---$",  # front matter
    r"^\$\$.*?\$\$$",
    r"^(\||#|!\[|\[\w+\]:|\(\w[\w-]*\)=$)[^\n]*$",  # tables, headings, pictures, targets
)
WORD = re.compile(r"[^\W_]")


def sentences(page: str) -> list[str]:
    """Sentences of the running text, in the page's order; an item of a list ends one, inline code is a word."""
    for pattern in LEFT_OUT:
        page = re.sub(pattern, "\n", page, flags=re.MULTILINE | re.DOTALL)
    page = re.sub(r"`+[^`]+`+|\$[^$\n]+\$", "code", page)
    page = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", page)
    page = re.sub(r"\b(e\.g|i\.e|cf|vs|eq|fig|sec|et al|no|pp|vol)\.", r"\1", page, flags=re.IGNORECASE)
    paragraphs = re.split(r"\n\s*\n|\n(?=\s*(?:[-*+]|\d+\.)\s)", page)
    cut = (part for paragraph in paragraphs for part in re.split(r"(?<=[.!?])[\"')*_]*\s+(?=\S)", paragraph))
    return [" ".join(part.split()) for part in cut if WORD.search(part)]


def words(sentence: str) -> int:
    """Number of words: parts between blanks that have a letter or a digit."""
    return sum(bool(WORD.search(part)) for part in sentence.split())


def measured(page: str) -> tuple[float, float, str]:
    """Mean length, share above LONG words, and the longest sentence."""
    all_of = sentences(page)
    lengths = [words(sentence) for sentence in all_of]
    n = len(all_of) or 1
    return sum(lengths) / n, sum(length > LONG for length in lengths) / n, max(all_of, key=words, default="")


if __name__ == "__main__":
    for name in sys.argv[1:]:
        mean, share, longest = measured(Path(name).read_text(encoding="utf-8"))
        print(f"{mean:5.1f} {share:6.1%} {words(longest):4} {name}")
