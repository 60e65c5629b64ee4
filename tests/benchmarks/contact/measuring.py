"""Work and error of every setting of every peer on a problem, within a budget of time, as rows of a CSV file."""

from __future__ import annotations

import csv
import gc
import importlib
import io
import os
import platform
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from datetime import date
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result

from hertzwerk.runtime.system.atomic_files import write_atomically

FOLDER = Path(__file__).parent
PEERS = tuple(sorted(path.stem for path in (FOLDER / "peers").glob("*.py")))
COLUMNS = [
    "problem", "peer", "version", "integrator", "setting", "error", "impact_error", "seconds", "calls", "outcome",
    "date", "load", "machine", "python",
]  # fmt: skip
NOT_STATED = "not stated"  # outcome of a peer that has no form of a problem
LONGEST = 0.25  # s; a call that takes longer ends the series of its integrator
PART = 0.2  # of the budget that the first calls of one of many peers may take
SHORT = 5e-3  # s; shorter calls are repeated within a round up to this time
ROUNDS = 7


@dataclass
class Measured:
    """One setting: its call, the error of it, and processor times [s]."""

    peer: Any
    integrator: str
    setting: float
    run: Callable[[], Result] = field(repr=False)
    error: float
    impact_error: float
    times: list[float]

    def again(self) -> None:
        """Measure one round."""
        gc.collect()
        calls, begin, own = 0, time.process_time(), []
        while not calls or time.process_time() - begin < SHORT:
            found = self.run()
            calls += 1
            own += [] if found.seconds is None else [found.seconds]
        self.times.append(median(own) if own else (time.process_time() - begin) / calls)


def used() -> float:
    """Return the processor time of this process and of those that have ended, such as compilers [s]."""
    return sum(os.times()[:4])


def version(peer: Any) -> str:
    """Return the version of a peer, of its package where it has no function for it; empty if it is missing."""
    if hasattr(peer, "version"):
        return peer.version()
    return metadata.version(peer.PACKAGE) if find_spec(getattr(peer, "MODULE", peer.PACKAGE)) else ""


def peers(names: tuple[str, ...] = PEERS) -> list[Any]:
    """Return the modules of the peers."""
    return [importlib.import_module(f"benchmarks.contact.peers.{name}") for name in names]


def measure(problem: Problem, chosen: list[Any], budget: float, rounds: int = ROUNDS) -> list[dict[str, Any]]:
    """Return rows of COLUMNS; a peer that is missing, fails or does not state the problem has one row that says so.

    Every setting is called once, from loose to tight, until a call takes LONGEST. Then all are called in turn.
    """
    rows, found = [], []
    problem.errors(problem.reference)  # the reference is solved here: it is in no peer's part of the budget
    begin = used()
    for peer in chosen:
        first = used()
        if not version(peer):
            rows.append(row(problem, peer, outcome="missing: not installed"))
            continue
        stated = peer.settings(problem)
        if not stated:
            rows.append(row(problem, peer, outcome=NOT_STATED))
        for integrator, values in stated.items():
            if used() - first > budget * max(PART, 1 / len(chosen)):
                rows.append(row(problem, peer, integrator, outcome="not measured: the budget was used up"))
                continue
            longest, values = (16 * LONGEST, values[::3]) if problem.rows else (LONGEST, values)
            for one in attempts(problem, peer, integrator, values, longest):
                if isinstance(one, Measured):
                    found.append(one)
                else:
                    rows.append(one)
    for _ in range(rounds - 1):
        if used() - begin > budget:
            break
        for one in found:
            one.again()
    for one in found:
        numbers = {"error": f"{one.error:.3g}", "impact_error": f"{one.impact_error:.3g}"}
        numbers |= {"seconds": f"{median(one.times):.4g}", "calls": str(len(one.times))}
        rows.append(row(problem, one.peer, one.integrator, one.setting, "finished", **numbers))
    return sorted(rows, key=lambda each: (each["peer"], each["integrator"]))


def attempts(
    problem: Problem, peer: Any, integrator: str, values: Any, longest: float
) -> Iterator[Measured | dict[str, Any]]:
    """Yield the settings of an integrator from loose to tight, failures as rows."""
    exact = peer.limit(problem) if hasattr(peer, "limit") and not problem.rows else None
    failures = 0
    for value in values:
        try:
            run = prepared(problem, peer, integrator, value)
            # the first call warms: what is compiled or cached by it is not measured
            one = Measured(peer, integrator, value, run, *problem.errors(run(), exact), [])
            begin = used()
            one.again()
        except (ArithmeticError, RuntimeError, ValueError) as fault:
            lines = str(fault).splitlines() or [type(fault).__name__]
            yield row(problem, peer, integrator, value, f"failed: {lines[0][:80]}")
            failures += 1
            if failures == 3:
                return
            continue
        if not np.isfinite(one.error):
            yield row(problem, peer, integrator, value, "failed: not finite")
            continue
        yield one
        if used() - begin > max(longest, 2 * SHORT):
            return


def prepared(problem: Problem, peer: Any, integrator: str, value: float) -> Callable[[], Result]:
    """Return the call of a peer; that of a sweep is its own sweep, or takes the rows that are compared in a loop."""
    if not problem.rows:
        return peer.prepare(problem, integrator, value)
    if hasattr(peer, "sweep"):
        return peer.sweep(problem, integrator, value)
    calls = [peer.prepare(row, integrator, value) for row in problem.rows]

    def run() -> Result:
        begin = time.process_time()
        states = [call().states[-1] for call in calls]
        return Result(np.array(states), None, (time.process_time() - begin) * problem.all_rows / len(calls))

    return run


def row(
    problem: Problem, peer: Any, integrator: str = "", setting: float | str = "", outcome: str = "", **numbers: str
) -> dict[str, Any]:
    """Return one row; versions and state of the machine are in each."""
    written = f"{setting:.2g}" if setting != "" else ""
    return dict.fromkeys(COLUMNS, "") | {
        "problem": problem.name,
        "peer": peer.NAME,
        "version": version(peer),
        "integrator": integrator,
        "setting": written,
        "outcome": outcome,
        "date": date.today().isoformat(),
        "load": f"{os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "",
        "machine": machine(),
        "python": platform.python_version(),
        **numbers,
    }


def machine() -> str:
    """Return the processor and the number of cores."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        named = [
            line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")
        ]
        model = named[0] if named else model
    return f"{model}, {os.cpu_count()} cores"


def write(rows: list[dict[str, Any]], path: Path) -> None:
    """Write rows as CSV."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_atomically(path, text.getvalue().encode())


def read(path: Path) -> list[dict[str, str]]:
    """Read rows of a CSV file."""
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
