"""What work costs, counted: calls of functions, which no load of the machine changes."""

from collections.abc import Callable
from cProfile import Profile


def calls_of(work: Callable[[], object]) -> int:
    """Count the calls of functions, Python's and C's, while `work` runs."""
    profile = Profile()
    profile.runcall(work)
    return sum(entry.callcount for entry in profile.getstats())
