"""Docstring summaries are short and begin with a verb or a noun phrase."""

import ast
import re
from pathlib import Path

import pytest
from statements import statements

ROOT = Path(__file__).parent.parent
LONGEST = 100
RIDDLE = re.compile(r"(What|Of|Whose|Who)\b")


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
def test_summaries_are_short_and_no_riddles(side):
    files = sorted((ROOT / side).rglob("*.py"))
    assert files
    assert [f"{file.relative_to(ROOT)}:{fault}" for file in files for fault in faults(file.read_text("utf-8"))] == []


@pytest.mark.parametrize("summary", ["What is left of a step.", "Of a pair: its gap.", "x" * (LONGEST + 1)])
@pytest.mark.parametrize("head", ["", "def f():\n    ", "class A:\n    ", "class A:\n    async def f(self):\n        "])
def test_a_riddle_or_a_long_summary_is_found(head, summary):
    assert faults(f'{head}"""{summary}"""\n') != []
    assert faults(f'{head}"""Gap of a pair.\n\n{summary}"""\n') == []
