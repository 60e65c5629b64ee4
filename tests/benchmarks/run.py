"""hertzwerk beside its peers, as ratios measured in one run on one machine. From the repository's root:

    python tests/benchmarks/run.py [startup] [engine] [derivation] [limit]

Every number is a median of at least five alternating measurements. A ratio's limit is what issue 2 ("Speed") asks for; nothing
here fails a test, for seconds depend on the machine.
"""

from __future__ import annotations

import argparse
import gc
import itertools
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).parents[1]))
sys.path.insert(0, str(Path(__file__).parents[1] / "derive"))

from benchmarks import limit

from reference.slider_crank import SliderCrank, reference

REPEATS = 7
ERROR_AT = 0.010  # s
DURATION = 0.024  # s, two revolutions: what is timed
TARGETS = (2e-3, 5e-5)
TOLERANCES = tuple(10 ** (-k / 2) for k in range(6, 23))


class Ratio(NamedTuple):
    """One line of the report: two medians [s] and what their ratio should be."""

    what: str
    first: float
    second: float
    wanted: str  # such as "<= 5"
    note: str = ""

    def __str__(self) -> str:
        ratio = self.first / self.second
        times = f"{_time(self.first):>9} / {_time(self.second):>9}"
        return f"  {self.what:<58} {ratio:>8.2f}  {self.wanted:>6}  {self._verdict(ratio):<6}  {times}  {self.note}"

    def _verdict(self, ratio: float) -> str:
        if not self.wanted:
            return ""
        sign, bound = self.wanted.split()
        return "kept" if (ratio <= float(bound) if sign == "<=" else ratio >= float(bound)) else "MISSED"


def _time(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def timed(action: Callable[[], object]) -> Callable[[], float]:
    """The measurement of an action [s]."""

    def measure() -> float:
        gc.collect()
        begin = time.perf_counter()
        action()
        return time.perf_counter() - begin

    return measure


def medians(*measurements: Callable[[], float], repeats: int = REPEATS) -> list[float]:
    """Median of each measurement [s], taken in turn so that a busy moment hits all."""
    rounds = [[measure() for measure in measurements] for _ in range(repeats)]
    return [median(column) for column in zip(*rounds, strict=True)]


# ---- whole process ---------------------------------------------------------------------------------------------------


def startup() -> Iterable[Ratio]:
    """A run from the shell, results written, nothing cached, against the imports nobody can avoid."""
    beside = Path(sys.executable).with_name("hertzwerk")
    installed = str(beside) if beside.exists() else shutil.which("hertzwerk")
    command = [installed] if installed else [sys.executable, "-c", "from hertzwerk.runtime.cli import main; main()"]
    with tempfile.TemporaryDirectory() as folder:
        fresh = (Path(folder) / f"run{i}" for i in itertools.count())

        def run() -> None:
            here = next(fresh)
            arguments = ["run", "slider_crank", "--no-plots", "--accuracy", "1e-6", "--out", str(here / "results")]
            here.mkdir()
            environment = {**os.environ, "HERTZWERK_CACHE": str(here / "cache")}
            subprocess.run([*command, *arguments], check=True, capture_output=True, env=environment)

        def imports() -> None:
            subprocess.run([sys.executable, "-c", "import casadi, numpy"], check=True)

        run(), imports()
        whole, least = medians(timed(run), timed(imports), repeats=11)
    yield Ratio("hertzwerk run slider_crank / import casadi, numpy", whole, least, "<= 5")


# ---- engine ----------------------------------------------------------------------------------------------------------


class Contender(NamedTuple):
    """An integrator of the mechanism: (duration, tolerance) -> (theta, x, theta', x') at the end."""

    name: str
    state: Callable[[float, float], Sequence[float]]

    def time(self, tolerance: float) -> Callable[[], float]:
        """The measurement of two revolutions."""
        return timed(lambda: self.state(DURATION, tolerance))


def cheapest(contender: Contender, friction: bool) -> dict[float, float]:
    """For each target error, the loosest tolerance that keeps it together with every tighter one: no lucky hits."""
    truth = reference(friction)
    errors = {tolerance: truth.error(ERROR_AT, tuple(contender.state(ERROR_AT, tolerance))) for tolerance in TOLERANCES}
    chosen = {}
    for target in TARGETS:
        kept = list(itertools.takewhile(lambda tolerance, e=target: errors[tolerance] <= e, reversed(TOLERANCES)))
        if kept:
            chosen[target] = kept[-1]
    return chosen


def hertzwerk(method: str, *, compiled: bool, friction: bool, ledger: bool = False) -> Contender:
    """simulate() of a loaded model; without the energy ledger, which no peer keeps, unless asked for."""
    from hertzwerk.runtime import load, simulate

    name = "slider_crank" if friction else "slider_crank_frictionless"
    model = load(name, without=() if ledger else ("energy_ledger",))

    def state(duration: float, tolerance: float) -> Sequence[float]:
        run = simulate(model, duration=duration, accuracy=tolerance, method=method, compiled=compiled)
        return _absolute(duration, [run[name][-1] for name in (*model.coordinates, *model.speeds)])

    return Contender(f"{method}, {'C' if compiled else 'VM'}", state)


def scipy_peer() -> Contender:
    from benchmarks.peers import SolveIvp

    from hertzwerk.runtime import load

    solve = SolveIvp(load("slider_crank_frictionless"))
    return Contender("LSODA", lambda duration, tolerance: _absolute(duration, solve(duration, tolerance)))


def _absolute(t: float, y: Sequence[float]) -> Sequence[float]:
    """From the crank pin's relative angle to the rod's absolute one."""
    w = SliderCrank().w
    return y[0] + w * t, y[1], y[2] + w, y[3]


def engine() -> Iterable[Ratio]:
    """simulate() of a loaded model against solve_ivp on the same functions: frictionless, two revolutions, equal error, no ledger on either side."""
    peer = scipy_peer()
    booked = hertzwerk("dop853", compiled=False, friction=False, ledger=True)
    virtual, compiled = (hertzwerk("dop853", compiled=c, friction=False) for c in (False, True))
    peer_tolerance, tolerance = cheapest(peer, False), cheapest(virtual, False)
    for target in TARGETS:
        if target not in peer_tolerance or target not in tolerance:
            print(f"  error {target:g} not reached: LSODA {peer_tolerance}, hertzwerk {tolerance}")
            continue
        theirs, ours = peer_tolerance[target], tolerance[target]
        slow, vm, c, kept = medians(peer.time(theirs), virtual.time(ours), compiled.time(ours), booked.time(ours))
        note = f"tolerances {theirs:.0e}, {ours:.0e}"
        yield Ratio(f"solve_ivp LSODA / {virtual.name}, error <= {target:g}", slow, vm, ">= 15", note)
        yield Ratio(f"solve_ivp LSODA / {compiled.name}, error <= {target:g}", slow, c, ">= 60", note)
        yield Ratio(f"with / without the energy ledger, VM, error <= {target:g}", kept, vm, "", note)


# ---- derivation ------------------------------------------------------------------------------------------------------


def derivation() -> Iterable[Ratio]:
    """Scene file to module text, audit included, against KanesMethod and cse; SymPy's cache emptied before each."""
    import importlib.util
    import runpy

    from benchmarks.peers import kane_slider_crank
    from sympy.core.cache import clear_cache

    from hertzwerk.derive.derivation import generate

    spec = importlib.util.find_spec("hertzwerk.derive.scenes.slider_crank")
    assert spec is not None and spec.origin is not None
    origin = spec.origin

    def ours() -> None:
        clear_cache()
        generate(runpy.run_path(origin)["scene"], "slider_crank")

    def theirs() -> None:
        clear_cache()
        kane_slider_crank()

    ours(), theirs()
    mine, peer = medians(timed(ours), timed(theirs))
    yield Ratio("derive slider_crank / sympy.physics.mechanics + cse", mine, peer, "<= 1")
    yield from chains()


def chains() -> Iterable[Ratio]:
    """The chains of tests/derive/operations.py, and one of 40 links against the import of SymPy."""
    import sympy as sp
    from kane import chain
    from operations import CHAINS, of_chain
    from sympy.core.cache import clear_cache

    from hertzwerk.derive.derivation import generate

    for name, (n, axes) in CHAINS.items():
        scene, found = chain(n, axes).scene(ledger=False), []

        def ours(scene: Any = scene) -> None:
            clear_cache()
            generate(scene)

        def theirs(n: int = n, axes: str = axes, found: list[int] = found) -> None:
            clear_cache()
            mass, forcing, _, _ = chain(n, axes).kane()
            shared, reduced = sp.cse([mass, forcing])
            found.append(sum(e.count_ops() for _, e in shared) + sum(e.count_ops() for part in reduced for e in part))

        peer, mine = medians(timed(theirs), timed(ours), repeats=5)
        wanted = "" if n < 3 else ">= 10" if n == 6 else ">= 1"
        note = f"operations {sum(of_chain(n, axes).values())}, KanesMethod {found[0]} (without solving)"
        yield Ratio(f"sympy.physics.mechanics + cse / derive {name}", peer, mine, wanted, note)
    for axes in ("Z", "ZYX"):
        scene = chain(40, axes).scene(ledger=False)

        def long(scene: Any = scene) -> None:
            clear_cache()
            generate(scene)

        def imports() -> None:
            subprocess.run([sys.executable, "-c", "import sympy"], check=True)

        mine, least = medians(timed(long), timed(imports), repeats=5)
        kind = "plane" if axes == "Z" else "spatial"
        yield Ratio(f"derive {kind} chain of 40 links / import sympy", mine, least, "<= 40")


# ---- the limit -------------------------------------------------------------------------------------------------------


def limits() -> Iterable[Ratio]:
    """Against the hand-written C++ at equal error, and what a run costs beyond its evaluations."""
    if limit.COMPILER is None:
        print("  skipped: no g++")
        return
    for friction in (False, True):
        name = "friction" if friction else "frictionless"
        ours = [hertzwerk("dop853", compiled=compiled, friction=friction) for compiled in (True, False)]
        tolerance, hand_tolerance = cheapest(ours[0], friction), cheapest(handwritten(friction), friction)
        for target in sorted(tolerance.keys() & hand_tolerance, reverse=True):
            mine, theirs = tolerance[target], hand_tolerance[target]
            hand, *times = medians(handwritten_time(theirs, friction), *(engine.time(mine) for engine in ours))
            note = f"tolerances {mine:.0e}, {theirs:.0e}"
            for engine, slow in zip(ours, times, strict=True):
                yield Ratio(f"{engine.name} / C++, {name}, error <= {target:g}", slow, hand, "", note)

        counts = limit.run("dop853", 1e-6, friction=friction, times=(DURATION,))
        contact, flight = counts["contact_evaluations"], counts["evaluations"] - counts["contact_evaluations"]

        def bare(
            contact: int = contact, flight: int = flight, mode: str = "friction" if friction else "contact"
        ) -> float:
            cost = limit.bare()
            return contact * cost[mode] + flight * cost["flight"]

        whole, alone = medians(handwritten_time(1e-6, friction), bare)
        yield Ratio(f"C++ / its {contact + flight} bare evaluations, {name}", whole, alone, "<= 1.5")
    cost = limit.bare()
    print(f"  bare C++ evaluation: {', '.join(f'{mode} {_time(seconds)}' for mode, seconds in cost.items())}")


def handwritten(friction: bool) -> Contender:
    def state(duration: float, tolerance: float) -> Sequence[float]:
        return limit.run("dop853", tolerance, friction=friction, times=(duration,))["states"][0][1:]

    return Contender("C++", state)


def handwritten_time(tolerance: float, friction: bool) -> Callable[[], float]:
    """The program's own measurement of two revolutions, the median of 51."""
    return lambda: limit.run("dop853", tolerance, friction=friction, times=(DURATION,), repeats=51)["seconds"]


GROUPS = {"startup": startup, "engine": engine, "derivation": derivation, "limit": limits}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("groups", nargs="*", metavar="GROUP", help=f"of {', '.join(GROUPS)} (default: all)")
    chosen = parser.parse_args().groups or list(GROUPS)
    if unknown := set(chosen) - set(GROUPS):
        parser.error(f"no such group: {', '.join(sorted(unknown))}")
    for name in chosen:
        print(f"{name}: {GROUPS[name].__doc__}")
        for ratio in GROUPS[name]():
            print(ratio, flush=True)


if __name__ == "__main__":
    main()
