"""The default method against dop853: what watching for stiffness costs where nothing is stiff."""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Iterator
from math import comb
from statistics import median
from typing import Any

from benchmarks.ratios import Ratio

TOLERANCES = (1e-6, 1e-9)
BAR, FEWEST, MOST = 1.05, 15, 90  # rounds
LASTING = 0.02  # s of the processor: shorter runs are repeated
LONGEST = 0.25  # s: longer runs are cut
CHAIN = "falling_chain_of_8"


def automatic() -> Iterator[Ratio]:
    """The default method, auto, against dop853 on every scene: runs in the virtual machine, by turns, of processor time."""
    from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME
    from hertzwerk.runtime.analysis.hard_cases.runner import model_of
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.loading import engine_model

    for name in scenarios.names():
        for tolerance in TOLERANCES:
            numbers = scenarios.read(name)
            yield _ratio(name, engine_model(name), tolerance, numbers["duration"], numbers.get("parameters", {}))
    chain = BY_NAME[CHAIN]
    for tolerance in TOLERANCES:
        yield _ratio(CHAIN, model_of(chain.source), tolerance, chain.duration, chain.parameters)


def _ratio(name: str, model: Any, tolerance: float, duration: Any, parameters: Any) -> Ratio:
    """Both methods on a model, in rounds of auto, dop853, dop853, auto, until the bar is kept or missed for sure."""
    from hertzwerk.runtime import simulate

    def run(method: str, until: Any) -> Any:
        return simulate(
            model,
            duration=until,
            tolerance=tolerance,
            parameters=parameters,
            method=method,
            compiled=False,
            max_steps=10**7,
        )

    first, taken = run("dop853", duration), _taken(lambda: run("dop853", duration))
    until = first.engine.t_end * min(1, LONGEST / taken)
    taken, auto = _taken(lambda: run("dop853", until)), run("auto", until)
    repeats = max(int(LASTING / taken), 1)
    rounds: list[tuple[float, float]] = []
    while len(rounds) < MOST:
        sides = [_taken(lambda method=method: [run(method, until) for _ in range(repeats)]) for method in ORDER]
        rounds.append((sides[0] + sides[3], sides[1] + sides[2]))
        low, high = interval([mine / theirs for mine, theirs in rounds])
        if len(rounds) >= FEWEST and (high <= BAR or low > BAR):
            break
    theirs = median([theirs for _, theirs in rounds]) / (2 * repeats)
    ratio = median([mine / theirs for mine, theirs in rounds])
    turned = auto.engine.history.part("method").any()
    note = f"95 % {low:.3f} to {high:.3f}, {len(rounds)} rounds" + ("; with implicit steps" if turned else "")
    return Ratio(f"auto / dop853, {name}, {tolerance:g}", ratio * theirs, theirs, f"<= {BAR:g}", note)


ORDER = ("auto", "dop853", "dop853", "auto")


def _taken(action: Callable[[], object]) -> float:
    gc.collect()
    begin = time.thread_time()
    action()
    return time.thread_time() - begin


def interval(ratios: list[float]) -> tuple[float, float]:
    """The 95 % interval of the median, free of distributions: order statistics, whose ranks are binomial."""
    n, ordered = len(ratios), sorted(ratios)
    below, k = 0.0, 0
    while below + comb(n, k) / 2**n <= 0.025:
        below += comb(n, k) / 2**n
        k += 1
    return ordered[max(k - 1, 0)], ordered[min(n - k, n - 1)]
