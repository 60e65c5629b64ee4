"""heyoka: Taylor series of the order that its tolerance takes; terminal events switch contacts by parameters, as in its pages on event detection."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades

NAME, PACKAGE = "heyoka", "heyoka"
LARGEST = 40  # contacts: each is an event of its own


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return the tolerances."""
    if problem.contacts > LARGEST or problem.kind == "loops":  # these take the solution of linear equations
        return {}
    return {"Taylor": decades(2, 16, 1)}


class Symbols:
    """The functions that a problem's formulas need, of expressions."""

    def __getattr__(self, name: str) -> Any:
        import heyoka

        if name == "where":
            return lambda on, yes, no: heyoka.select(heyoka.gt(on, heyoka.expression(0.0)), yes, heyoka.expression(no))
        return np.frompyfunc(getattr(heyoka, name), 1, 1)


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured; the integrator is compiled before it."""
    import heyoka as hy

    names = [f"y{i}" for i in range(len(problem.start))]
    y = np.array([hy.expression(name) for name in names], dtype=object)
    on = np.array([hy.par[i] for i in range(len(problem.memory))], dtype=object)
    rates = problem.rates(hy.time, y, on, Symbols())
    onsets: list[float] = []

    def switch(i: int) -> Callable[[Any, int], bool]:
        def callback(integrator: Any, direction: int) -> bool:
            if direction < 0:
                problem.onset(integrator.pars, i, integrator.time, integrator.state)
                onsets.append(integrator.time)
            else:
                integrator.pars[i] = 0.0
            return True

        return callback

    gaps = problem.gaps(hy.time, y, Symbols())
    if problem.opens is None:
        events = [hy.t_event(gap, callback=switch(i)) for i, gap in enumerate(gaps)]
    else:  # an event that does not count in its mode is kept away from 0
        opens = problem.opens(hy.time, y, Symbols())
        begin, end = hy.event_direction.negative, hy.event_direction.positive
        events = [hy.t_event(gap + on[i], callback=switch(i), direction=begin) for i, gap in enumerate(gaps)]
        events += [hy.t_event(gap - (1.0 - on[i]), callback=switch(i), direction=end) for i, gap in enumerate(opens)]
    system = [(hy.expression(name), rate) for name, rate in zip(names, rates, strict=True)]
    taylor = hy.taylor_adaptive(
        system,
        list(problem.start),
        pars=list(problem.memory),
        t_events=events,
        tol=setting,
        compact_mode=problem.kind == "chain",
    )
    times = np.concatenate(([0.0], problem.times))

    def run() -> Result:
        onsets.clear()
        taylor.time, taylor.state[:], taylor.pars[:] = 0.0, problem.start, problem.memory
        if events:
            taylor.reset_cooldowns()
        outcome, *_, states = taylor.propagate_grid(times)
        if outcome != hy.taylor_outcome.time_limit:
            raise ArithmeticError(str(outcome))
        return Result(states[1:, : problem.compared], lambda: np.array(onsets))

    return run
