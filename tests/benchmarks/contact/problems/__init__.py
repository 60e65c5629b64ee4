"""The problems by name; each file states its formulas first."""

from collections.abc import Callable

from benchmarks.contact.problem import Problem
from benchmarks.contact.problems import balls, cradle

PROBLEMS: dict[str, Callable[[], Problem]] = {**balls.PROBLEMS, **cradle.PROBLEMS}
