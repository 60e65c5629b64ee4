"""The problems by name; each file states its formulas first."""

from collections.abc import Callable

from benchmarks.contact.problem import Problem
from benchmarks.contact.problems import balls, belt, chains, cradle, crank, loops, sweeps

PROBLEMS: dict[str, Callable[[], Problem]] = {
    **balls.PROBLEMS,
    **belt.PROBLEMS,
    **cradle.PROBLEMS,
    **crank.PROBLEMS,
    **chains.PROBLEMS,
    **loops.PROBLEMS,
    **sweeps.PROBLEMS,
}
