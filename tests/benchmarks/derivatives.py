"""What derivatives of a run cost beside the run."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.ratios import Ratio, hot, medians

COUNTS = (1, 4, 16)  # of derivatives
TOLERANCE = 1e-9
LONG, SHORT = 240e-3, 24e-3  # s: 20 revolutions and 2


def sensitivities() -> Iterator[Ratio]:
    """A run of slider_crank and its derivatives by p parameters against the run alone: issue 15 asks for 2 + 0.6 p of explicit compiled ones."""
    from hertzwerk.runtime.loading import engine_model

    model = engine_model("slider_crank")
    names = that_matter(model)
    for compiled in (True, False):
        for method in ("dop853", "dopri5", "esdirk", "rodas"):
            explicit = method.startswith("dop")
            duration = LONG if compiled and explicit else SHORT
            run = runs(model, method, duration, compiled=compiled)
            for count in COUNTS:
                both = with_derivatives(run, names[:count])
                calls = 5 if explicit else 1
                whole, alone = medians(hot(both, calls=calls, warm=1), hot(run, calls=calls, warm=1), repeats=5)
                bar = f"<= {2 + 0.6 * count:g}" if explicit and compiled else ""
                side = "C" if compiled else "VM"
                yield Ratio(
                    f"{method}, {side}, p = {count}: run and derivatives / run", whole, alone, bar, f"{duration} s"
                )
    for count in COUNTS:
        long, short = (peak(runs(model, "dop853", time, compiled=True), names[:count]) for time in (LONG, LONG / 2))
        yield Ratio(f"memory of derivatives a step, p = {count}: twice as long / once", long, short, "<= 1.1", unit="B")


def that_matter(model: Any) -> list[str]:
    """Names of parameters and starts with derivatives that are not zero: others cost less."""
    names = [*model.parameters, "guide.travel"]
    derivatives = runs(model, "dop853", SHORT, compiled=False)().sensitivities(*names)
    return [
        name for name in names if any(derivatives[state, name].any() for state in (*model.coordinates, *model.speeds))
    ]


def runs(model: Any, method: str, duration: float, *, compiled: bool) -> Callable[[], Any]:
    """Run with its steps."""
    from hertzwerk.runtime import simulate

    return lambda: simulate(model, duration=duration, tolerance=TOLERANCE, method=method, compiled=compiled)


def with_derivatives(run: Callable[[], Any], names: list[str]) -> Callable[[], object]:
    """The run, and the derivatives of its states at every step."""
    return lambda: run().sensitivities(*names)


def peak(run: Callable[[], Any], names: list[str]) -> float:
    """Largest memory [B] that derivatives take beside the run, for each of its steps: those of the second half may be more."""
    found = run()
    found.sensitivities(*names)
    tracemalloc.start()
    found.sensitivities(*names)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return float(most) / len(found.t)
