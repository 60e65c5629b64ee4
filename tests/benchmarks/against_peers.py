"""Compiled hertzwerk against SUNDIALS CVODE called from C, SciPy's best and Exudyn, on the same mechanism at equal error."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from benchmarks import exudyn_crank, programs
from benchmarks.contenders import cvode, handwritten, hertzwerk, scipy
from benchmarks.equal_error import TARGETS, Contender
from benchmarks.ratios import Ratio, medians

CVODE = (("adams", "functional"), ("adams", "newton"), ("bdf", "functional"), ("bdf", "newton"))
SCIPY = ("LSODA", "DOP853", "Radau")
CVODE_BARS = {False: ">= 7", True: ">= 5"}  # by friction
SCIPY_BARS = {False: ">= 200", True: ">= 100"}


def peers() -> Iterator[Ratio]:
    """CVODE called from C with root finding, and solve_ivp with events on the compiled right-hand side, over hertzwerk compiled, at equal error."""
    if programs.COMPILER is None:
        print("  not measured: needs g++")
        return
    if programs.sundials() is None:
        print("  CVODE not measured: needs the SUNDIALS of CasADi's wheel for Linux")
    else:
        yield from _against("CVODE", lambda friction: [cvode(*kind, friction) for kind in CVODE], CVODE_BARS)
    slow = TARGETS[:2]
    yield from _against(
        "solve_ivp", lambda friction: [scipy(m, friction, compiled=True) for m in SCIPY], SCIPY_BARS, slow
    )


def exudyn() -> Iterator[Ratio]:
    """Exudyn over hertzwerk compiled, frictionless, in its best class of errors."""
    if not exudyn_crank.INSTALLED or programs.COMPILER is None:
        print("  not measured: needs g++ and Exudyn (pip install exudyn)")
        return
    yield from _against("Exudyn", lambda _: [exudyn_crank.contender()], {False: ">= 500"}, (2e-2,))


def _against(
    peer: str,
    contenders: Callable[[bool], list[Contender]],
    bars: dict[bool, str],
    targets: tuple[float, ...] = TARGETS,
) -> Iterator[Ratio]:
    """The peer's configurations over hertzwerk; the bar counts for the cheapest."""
    for friction, bar in bars.items():
        name = "friction" if friction else "frictionless"
        ours, by_hand = hertzwerk("dop853", compiled=True, friction=friction), handwritten(friction)
        for target in targets:
            tolerances = {each: each.tolerance_for(target) for each in (ours, by_hand, *contenders(friction))}
            reached = [(each, tolerance) for each, tolerance in tolerances.items() if tolerance is not None]
            missing = [each.name for each, tolerance in tolerances.items() if tolerance is None]
            if missing:
                print(f"  {peer}, {name}: error {target:g} not reached by {', '.join(missing)}")
            if tolerances[ours] is None or tolerances[by_hand] is None or len(reached) == 2:
                continue
            mine, limit, *times = medians(*(each.time(tolerance) for each, tolerance in reached), repeats=5)
            for (each, tolerance), time in zip(reached[2:], times, strict=True):
                best = time == min(times)
                what = f"{each.name} / hertzwerk, {name}, error {target:g}"
                note = f"tolerances {tolerance:.1e}, {tolerances[ours]:.1e}"
                note += f"; C++ {time / limit:.1f} times faster" if best else ""
                yield Ratio(what if best else f"    {what}", time, mine, bar if best else "", note)
