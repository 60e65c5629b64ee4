"""A million rows: the first row of a new sweep and of one that goes on, and what its table, page, picture and export take.

The store is filled by its own writer, with the run of the first row and numbers of their own. Every measurement is a process of its own: time from
its start on the clock, its largest memory, and that of its workers.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.ratios import Ratio

OVER = {"drop_height": "0.5..1.5 m:1000", "restitution": "0.5..0.9:1000"}
HOW: dict[str, Any] = {"duration": "0.3 s", "tolerance": 1e-6, "compiled": False}
MISSING = 100  # rows of a store that is filled
FIRST, RESUMED, MEMORY = 3, 10, 300  # s, s, MB: bars
TOGETHER = 5000  # rows of a transaction

SWEPT = """
import sys, time
from hertzwerk.runtime import sweep
begin, known = float(sys.argv[4]), []

def progress(fraction):
    known.append(fraction)
    if fraction > known[0] or fraction == 1:
        print(time.time() - begin, flush=True)
        if sys.argv[2] == "first":
            raise KeyboardInterrupt

def swept(client=None):
    global begin
    begin = time.time() if client else begin
    sweep("bouncing_ball", {over}, out=sys.argv[1], progress=progress, client=client, **{how})

if __name__ == "__main__":
    if sys.argv[3] == "dask":
        from distributed import Client
        with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
            swept(client)
    else:
        swept()
"""
LOADED = "from hertzwerk.runtime import Sweep\nimport sys\ntable = Sweep.load(sys.argv[1])\n"
READ = {
    "CSV": LOADED + "table.to_csv(sys.argv[2])",
    "Parquet": LOADED + "table.to_file(sys.argv[2] + '.parquet')",
    "picture": LOADED + "table.plot().savefig(sys.argv[2] + '.png')",
    "page": "from hertzwerk.runtime.cli import main\nimport sys\n"
    "main(['report', sys.argv[1], '--out', sys.argv[2] + '.html'], standalone_mode=False)",
}


class Taken(NamedTuple):
    """What a process took: what it printed first, time on the clock [s], largest memory of it or its workers [MB]."""

    first: str
    wall: float
    memory: float


def rows() -> Iterator[Ratio]:
    """First row, memory, table, page, picture and Parquet of a sweep of a million rows, here and on a Dask cluster."""
    with tempfile.TemporaryDirectory() as place:
        new, full = Path(place) / "new", Path(place) / "full"
        for engine in ("processes", "dask"):
            taken = process(SWEPT.format(over=OVER, how=HOW), str(new), "first", engine)
            yield Ratio(f"first row of a million, {engine} / bar", float(taken.first), FIRST, "<= 1")
            yield Ratio(f"memory until then, {engine} / bar", taken.memory, MEMORY, "<= 1", unit="MB")
            shutil.rmtree(new)
        begin = time.process_time()
        fill(full)
        yield Ratio("storing a row / 100 us", (time.process_time() - begin) / 1e6, 1e-4, "", "by the store alone")
        for engine in ("dask", "processes"):
            taken = process(SWEPT.format(over=OVER, how=HOW), str(full), "first", engine)
            yield Ratio(f"first row of those missing of a million, {engine} / bar", float(taken.first), RESUMED, "<= 1")
            yield Ratio(f"memory until then, table included, {engine} / bar", taken.memory, MEMORY, "<= 1", unit="MB")
        taken = process(SWEPT.format(over=OVER, how=HOW), str(full), "all", "processes")
        yield Ratio("the rest and the table / a minute", taken.wall, 60, "")
        for name, script in READ.items():
            taken = process(script, str(full), str(Path(place) / "read"))
            yield Ratio(f"{name} / a minute", taken.wall, 60, "")
            yield Ratio(f"memory, {name} / bar", taken.memory, MEMORY, "<= 1", unit="MB")


def process(script: str, *arguments: str) -> Taken:
    """Run a script in a process of its own."""
    with tempfile.NamedTemporaryFile("w", suffix=".py") as file:
        file.write(script)
        file.flush()
        begin = time.perf_counter()
        command = [sys.executable, file.name, *arguments, str(time.time())]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
            assert started.stdout is not None
            first = started.stdout.readline()
            started.stdout.read()
            _, status, used = os.wait4(started.pid, 0)
            started.returncode = os.waitstatus_to_exitcode(status)
    if started.returncode:
        raise RuntimeError(f"{arguments} ended with {started.returncode}")
    return Taken(first, time.perf_counter() - begin, used.ru_maxrss / 1000)


def fill(folder: Path, missing: int = MISSING) -> None:
    """Store all but the last rows of the sweep, by the store's own writer."""
    from hertzwerk.runtime import sweep
    from hertzwerk.runtime.studies.sweeps.points.sweep_definition import read_definition
    from hertzwerk.runtime.studies.sweeps.sweep_store import opened

    def stop(fraction: float) -> None:
        if fraction:
            raise KeyboardInterrupt

    first = sweep("bouncing_ball", OVER, out=folder, progress=stop, workers=1, **HOW).rows[0]
    definition = read_definition(folder)
    assert definition is not None
    with opened(folder) as store:
        store.plan, count = definition["digest"], definition["points"] - missing
        for begin in range(1, count, TOGETHER):
            made = {}
            for i in range(begin, min(begin + TOGETHER, count)):
                own = {name: value + i * 1e-6 for name, value in first.outputs.items()}
                made[f"{i:032x}"] = replace(first, index=i, outputs=own)
            store.add(made, {row.index: key for key, row in made.items()})
