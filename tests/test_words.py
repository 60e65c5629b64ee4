"""Docstring summaries are short and begin with a verb or a noun phrase; text avoids words that stand for plainer ones."""

import ast
import re
from pathlib import Path

import pytest
from each import each
from sentences import LONGEST as LONGEST_SENTENCE
from sentences import MEAN, SHARE, measured, words
from statements import statements

ROOT = Path(__file__).parent.parent
LONGEST = 100
RIDDLE = re.compile(r"(What|Of|Whose|Who)\b")
AVOIDED = re.compile(r"(?i:\b(told|tells?|in vain|owe[sd]?|ask(s|ed)? for)\b)|^(#+ )?What (?![^\n]*\?)")
PLAIN = (  # pages of short sentences
    *(
        "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "derive/README.md", "derive/scenes/README.md",
        "runtime/README.md", "tests/README.md",
    ),
    *(page.relative_to(ROOT).as_posix() for page in sorted((ROOT / "runtime" / "handbook").rglob("*.md"))),
)  # fmt: skip
PAGES = tuple(page for page in PLAIN if page != "CONTRIBUTING.md")  # CONTRIBUTING.md lists the words


def faults(text):
    """Summaries of a module's text that are too long or begin like a riddle, as 'line: summary'."""
    found = []
    for node in statements(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            summary = (ast.get_docstring(node) or "").partition("\n")[0]
            if len(summary) > LONGEST or RIDDLE.match(summary):
                found.append(f"{getattr(node, 'lineno', 1)}: {summary}")
    return found


@pytest.mark.parametrize("side", ["derive", "runtime"])
def test_summaries_are_short_and_texts_use_plain_words(side):
    """Words except in `emit`: text of generated modules, which keep their bytes."""
    files = sorted((ROOT / side).rglob("*.py"))
    assert files
    for file in files:
        text = file.read_text("utf-8")
        assert [*faults(text), *(avoided(text) if file.parent.name != "emit" else [])] == [], file


@pytest.mark.parametrize("summary", ["What is left of a step.", "Of a pair: its gap.", "x" * (LONGEST + 1)])
@pytest.mark.parametrize("head", ["", "def f():\n    ", "class A:\n    ", "class A:\n    async def f(self):\n        "])
def test_a_riddle_or_a_long_summary_is_found(head, summary):
    assert faults(f'{head}"""{summary}"""\n') != []
    assert faults(f'{head}"""Gap of a pair.\n\n{summary}"""\n') == []


def avoided(text):
    """Texts of a module (docstrings, messages, headings) with words to avoid, as 'line: text'; told -> reported, shown."""
    texts = (
        node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Constant) and isinstance(node.value, str)
    )
    found = ((node.lineno, match, node.value) for node in texts if (match := AVOIDED.search(node.value)))
    return [f"{line}: ...{text[max(match.start() - 40, 0) : match.end() + 20]}" for line, match, text in found]


@each("page", PAGES)
def test_pages_use_plain_words(page):
    lines = (ROOT / page).read_text("utf-8").splitlines()
    assert lines
    assert [
        f"{page}:{k}: {line}"
        for k, line in enumerate(lines, 1)
        if AVOIDED.search(line) and not line.startswith("What ")
    ] == []


@pytest.mark.parametrize(
    "text",
    ["Steps tried in vain.", "The data cannot tell.", "An accuracy asked for.", "What it is owed to", "Told at once."],
)
def test_an_avoided_word_is_found(text):
    """In a docstring, a message and a part of a formatted one."""
    for module in (f'"""{text}"""\n', f'f(1, "{text}")\n', f'x = f"{{y}}: 1" f"{text}"\n'.replace('{y}: 1" f"', "")):
        assert avoided(module) != []
    assert avoided('"""What do the laws return?"""\n') == []


def excesses(page):
    """Limits of CONTRIBUTING.md, section English, that a page exceeds."""
    mean, share, longest = measured(page)
    return [
        *([f"mean of {mean:.1f} words, at most {MEAN}"] if mean > MEAN else []),
        *([f"{share:.1%} of sentences are long, at most {SHARE:.0%}"] if share > SHARE else []),
        *([f"{words(longest)} words: {longest}"] if words(longest) > LONGEST_SENTENCE else []),
    ]


@each("page", PLAIN)
def test_sentences_are_short(page):
    assert excesses((ROOT / page).read_text("utf-8")) == []


SHORT = "A ball bounces on a plane. "


@pytest.mark.parametrize(
    ("page", "limits"),
    [
        (SHORT * 20, 0),
        (SHORT + "word " * 45 + ".", 2),  # mean and share
        (SHORT * 40 + "word " * 46 + ".", 1),
        (SHORT * 18 + ("word " * 31 + ". ") * 2, 1),
        (("word " * 17 + ". ") * 20, 1),
        (SHORT * 18 + ("- " + "word " * 15 + "\n") * 3, 0),  # items of a list need no full stop
        (SHORT * 40 + "\n\n" + "[" + "word " * 23 + "](target.md) " + "word " * 23, 1),
    ],
)
def test_long_sentences_are_found(page, limits):
    assert len(excesses(page)) == limits


@pytest.mark.parametrize(
    "block", ["```python\n{}\n```", "| {} |", "# {}", "$$\n{}\n$$", "```{{math}}\n{}\n```", "`{}`", "[code]({})"]
)
def test_code_tables_headings_and_targets_do_not_count(block):
    assert excesses(SHORT * 20 + "\n\n" + block.format("word " * 46)) == []
