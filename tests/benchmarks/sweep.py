"""What a row of a sweep costs beside the compiled loop of its run, both on every core at once.

Rows are computed by as many processes as there are cores, which share cache, memory and heat: a processor's second is then
worth less than to a process that runs alone, by nothing that a row does. So the loops are run in as many processes at once,
in turn with the rows, and what is divided is processor time by processor time, per row and core. Of the rows all of it
counts: processes begun and ended, rows sent, stored and written as a table; of the loops nothing but the loops. How much
faster a loop is that runs alone stands beside the ratio; times it, the ratio is that of rows to a loop alone.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import resource
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.ratios import Ratio

ROWS = int(os.environ.get("HERTZWERK_BENCHMARK_ROWS", "100"))  # of a sweep; 1000 for the record
ROUNDS = 5  # in which rows and loops alternate
TOLERANCE = 1e-6
PERIOD = 12e-3  # s, of a revolution
OUTPUTS: dict[str, tuple[str, ...]] = {
    "final states": (),
    "impacts, peaks, rates": ("impacts", "peak_force", "slider_pin.max_penetration", "slider_pin.impact_rate"),
}
BARS = {2: ("<= 1.6", "<= 1.6"), 20: ("<= 1.15", "<= 1.3")}


def sweep() -> Iterator[Ratio]:
    """A row of a stored, compiled sweep of slider_crank over its clearance against the bare loop of its run, by processor time."""
    from hertzwerk.runtime.loading import engine_model
    from hertzwerk.runtime.studies.sweeps.batch import cores

    model = engine_model("slider_crank")
    sets = [{"clearance": f"{0.1 + 0.3 * i / ROWS:.9g} mm"} for i in range(ROWS)]
    for revolutions, bars in BARS.items():
        duration = revolutions * PERIOD
        loops = [bare_loop(model, given, duration) for given in sets]
        swept = {name: rows(model, sets, duration, outputs) for name, outputs in OUTPUTS.items()}
        for outputs in OUTPUTS.values():  # what is built once is built here: processes are forked with it
            rows(model, sets, duration, outputs, workers=1)()
        measured: dict[str, Callable[[], float]] = {
            **{name: partial(processor_time, action) for name, action in swept.items()},
            "side by side": partial(time_of_loops, loops, cores()),
            "alone": partial(time_of_loops, loops, 1),
        }
        times: dict[str, list[float]] = {name: [] for name in measured}
        for _ in range(ROUNDS):
            for name, measure in measured.items():
                gc.collect()
                times[name].append(measure() / ROWS)
        loop, alone = (median(times[name]) for name in ("side by side", "alone"))
        for name, bar in zip(swept, bars, strict=True):
            note = f"{ROWS} rows; loop on {cores()} cores at once / alone {loop / alone:.2f}"
            yield Ratio(f"{revolutions} revolutions, {name}: row / loop", median(times[name]), loop, bar, note)


def rows(
    model: Any, sets: Sequence[Mapping[str, str]], duration: float, outputs: Sequence[str], workers: int | None = None
) -> Callable[[], object]:
    """A sweep with these outputs, stored in a new folder."""
    from hertzwerk.runtime import sweep as sweep_over

    over = {"clearance": [given["clearance"] for given in sets]}
    settings: dict[str, Any] = {"duration": duration, "tolerance": TOLERANCE, "compiled": True, "workers": workers}

    def run() -> None:
        with tempfile.TemporaryDirectory() as folder:
            table = sweep_over(model, over, outputs=outputs, out=Path(folder) / "sweep", **settings)
            if not all(row.outcome == "finished" for row in table):
                raise ArithmeticError("a row did not finish")

    return run


def bare_loop(model: Any, given: Mapping[str, str], duration: float) -> Callable[[], object]:
    """The march of a run by itself: compiled chunks until the end, nothing kept."""
    from hertzwerk.runtime.engine.run.recorder import ENDS
    from hertzwerk.runtime.engine.run.run_request import Settings, read
    from hertzwerk.runtime.engine.run.single_run import set_up

    settings = Settings(duration, None, TOLERANCE, compiled=True)
    inputs, _ = read(model, settings, given, {})
    run = set_up(model, settings, inputs)
    scales = run.scales(TOLERANCE)
    return lambda: run.observe(TOLERANCE, scales, [], ENDS)


def time_of_loops(loops: Sequence[Callable[[], object]], processes: int) -> float:
    """Processor time [s] of loops shared by processes that run at once; none of what begins and ends them."""
    context = multiprocessing.get_context("fork")
    ready, found = context.Barrier(processes), context.SimpleQueue()

    def share(mine: Sequence[Callable[[], object]]) -> None:
        mine[0]()
        ready.wait()
        begin = time.process_time()
        for loop in mine:
            loop()
        found.put(time.process_time() - begin)

    started = [context.Process(target=share, args=(loops[i::processes],)) for i in range(processes)]
    for process in started:
        process.start()
    total = sum(found.get() for _ in started)
    for process in started:
        process.join()
    return total


def processor_time(action: Callable[[], object]) -> float:
    """Processor time [s] of an action in this process and in those it starts: what else the machine does counts little."""
    begin = _used()
    action()
    return _used() - begin


def _used() -> float:
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime
