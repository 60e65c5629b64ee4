"""The problems by name; each file states its formulas first."""

from collections.abc import Callable

from benchmarks.contact.problem import Problem
from benchmarks.contact.problems import balls, chains, cradle, crank

PROBLEMS: dict[str, Callable[[], Problem]] = {**balls.PROBLEMS, **cradle.PROBLEMS, **crank.PROBLEMS, **chains.PROBLEMS}
