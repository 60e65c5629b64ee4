"""1,000 rows of a sweep of the ball and of four balls, on one core.

Row i has the balls of `ball` or `balls_4` start higher by i/1000 of 50 mm, and yields their heights at the end. Peers without a sweep of their own
take the rows in a loop; of these every hundredth is run, and the time is scaled to all. Errors are those of every hundredth row.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.contact.problems import balls
from benchmarks.contact.problems.balls import Balls

ROWS = 1000
EVERY = 100
HIGHER = 0.05  # m


def higher(problem: Problem, row: int) -> Problem:
    """Return a row of the sweep, compared at its end."""
    p = problem.physics
    shifted = Balls(p.radius, tuple((x, y, z + HIGHER * row / ROWS) for x, y, z in p.places))
    grid = problem.grid[-1:]
    return balls.problem(f"{problem.name}_{row}", problem.title, shifted, grid)


@cache
def sweep(problem: Problem) -> Problem:
    rows = tuple(higher(problem, row) for row in range(0, ROWS, EVERY))
    return replace(
        problem,
        name=f"sweep_{problem.contacts}",
        title=f"1,000 rows of a sweep: {problem.title[0].lower()}{problem.title[1:]}",
        grid=np.arange(len(rows)),
        margin=0.0,
        rows=rows,
        all_rows=ROWS,
        digits=lambda: Result(np.array([row.reference.states[-1] for row in rows])),
        remark=REMARK + (ONCE if problem.contacts == 4 else ""),
    )


REMARK = "Times are those of all rows, on one core. hertzwerk has a sweep; of the others every hundredth row is run, and the time is scaled."
ONCE = " Each call was measured once, hertzwerk's after the others, on a loaded machine. SciPy's DOP853 was not."
PROBLEMS = {"sweep_1": lambda: sweep(balls.ball()), "sweep_4": lambda: sweep(balls.balls(4))}
