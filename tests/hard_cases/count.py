"""Count the steps that every hard case takes with every method, and write them to runtime/analysis/hard_cases/tried_steps.py; 5 minutes.

    python tests/hard_cases/count.py [CASE...]     those cases anew; by default all

The bounds on steps follow from them with a margin: do this after a change that is meant to change steps, and look at what it changes.
"""

from __future__ import annotations

import sys
from pathlib import Path

from hertzwerk.runtime.analysis.hard_cases.case_table import CASES
from hertzwerk.runtime.analysis.hard_cases.runner import solve
from hertzwerk.runtime.analysis.hard_cases.tried_steps import TRIES

FILE = Path(__file__).parents[2] / "runtime" / "analysis" / "hard_cases" / "tried_steps.py"
HEAD = '''"""Measured steps tried (accepted, rejected, retaken) by case and method.

Written by tests/hard_cases/count.py.
"""

TRIES: dict[str, dict[str, int]] = {
'''


def count(names: list[str]) -> None:
    """Measure, and write what is known by then, should it be interrupted."""
    found = dict(TRIES)
    try:
        for case in CASES:
            if names and case.name not in names:
                continue
            now = {}
            for method in case.methods:
                statistics = solve(case, method, compiled="auto").statistics
                now[method] = statistics.steps + statistics.rejected + statistics.retaken
            print(case.name, found.get(case.name), "->", now, flush=True)
            found[case.name] = now
    finally:
        rows = {case.name: found[case.name] for case in CASES if case.name in found}
        FILE.write_text(HEAD + "".join(map(_line, rows.items())) + "}\n", encoding="utf-8")


def _line(row: tuple[str, dict[str, int]]) -> str:
    name, tries = row
    return f'    "{name}": {{{", ".join(f"{chr(34)}{method}{chr(34)}: {n}" for method, n in tries.items())}}},\n'


if __name__ == "__main__":
    count(sys.argv[1:])
