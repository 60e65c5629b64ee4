"""Against the hand-written C++ at equal error, and what a run costs beyond its evaluations of the right-hand side."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

from benchmarks import programs
from benchmarks.bare import evaluations
from benchmarks.equal_error import DURATION, TARGETS, Contender, absolute
from benchmarks.ratios import Measurement, Ratio, hot, medians, seconds

from reference.slider_crank import SliderCrank

BARS = {2e-2: "<= 1.3", 2e-3: "<= 1.3", 5e-5: "<= 1.0", 1e-6: "<= 0.8"}  # issue 40: as C, with the energy ledger
WITHOUT = {"C": "<= 1.3", "VM": "<= 12"}  # issue 4: without
SANE = (
    (2e-3, 10_000),
    (2e-6, 21_000),
)  # issue 4, "Numbers": evaluations of the hand-written program for an error, frictionless

PARAMETERS = {"crank_inertia": "1e-5 kg m^2"}  # its ledger alone depends on it
STIFFNESS = f"power(K={SliderCrank().K!r} N/m^1.5, n=1.5)"  # 6.61e10, to the digits of the reference


@cache
def model(friction: bool, *, ledger: bool = False) -> Any:
    """The slider-crank with a stiffness by number, no built-in scene; without the energy ledger unless requested."""
    from hertzwerk.runtime.loading import engine_model

    name = "slider_crank" if friction else "slider_crank_frictionless"
    laws = {"slider_pin": f"{STIFFNESS} x lankarani_nikravesh"}
    return engine_model(name, without=() if ledger else ("energy_ledger",), laws=laws)


@cache
def hertzwerk(method: str, *, compiled: bool, friction: bool, ledger: bool = False) -> Contender:
    """simulate() of a loaded model, called again and again; its results do not depend on `compiled`."""
    from hertzwerk.runtime import simulate

    crank = model(friction, ledger=ledger)

    def run(duration: float, tolerance: float) -> Any:
        options = {"parameters": PARAMETERS, "method": method, "compiled": compiled}
        return simulate(crank, duration=duration, tolerance=tolerance, **options)

    def state(duration: float, tolerance: float) -> Sequence[float]:
        found = run(duration, tolerance)
        if not found.outcome.finished:
            raise ArithmeticError(str(found.outcome))
        return absolute(duration, [found[name][-1] for name in (*crank.coordinates, *crank.speeds)])

    def time(tolerance: float) -> Measurement:
        return hot(lambda: run(DURATION, tolerance), calls=25 if compiled else 7, warm=5 if compiled else 2)

    return Contender(f"{method}, {'C' if compiled else 'VM'}", friction, state, time)


@cache
def handwritten(friction: bool) -> Contender:
    """The hand-written program with its method of order 8, the cheaper one below an error of 1e-2."""

    def state(duration: float, tolerance: float) -> Sequence[float]:
        run = programs.handwritten("dop853", tolerance, friction=friction, times=(duration,))
        return run["states"][0][1:]

    def time(tolerance: float) -> Measurement:
        def measure() -> float:
            run = programs.handwritten("dop853", tolerance, friction=friction, times=(DURATION,), repeats=51)
            return run["seconds"]

        return measure

    return Contender("C++", friction, state, time)


def limit() -> Iterator[Ratio]:
    """Against the hand-written C++ at equal error, and what a run costs beyond its evaluations."""
    if programs.COMPILER is None:
        print("  not measured: needs g++")
        return
    for friction in (False, True):
        name = "friction" if friction else "frictionless"
        by_hand = handwritten(friction)
        sides = [
            hertzwerk("dop853", compiled=compiled, friction=friction, ledger=ledger)
            for compiled, ledger in ((True, True), (True, False), (False, False))
        ]
        for target in (2e-2, *TARGETS):
            theirs, *mine = (side.tolerance_for(target) for side in (by_hand, *sides))
            if theirs is None or None in mine:
                print(f"  error {target:g} not reached: hertzwerk {mine}, C++ {theirs}")
                continue
            measured = (side.time(tolerance) for side, tolerance in zip(sides, mine, strict=True))
            hand, kept, *times = medians(by_hand.time(theirs), *measured)
            note = f"tolerances {mine[0]:.1e}, {theirs:.1e}"
            yield Ratio(f"dop853, C with ledger / C++, {name}, error {target:g}", kept, hand, BARS[target], note)
            note = f"tolerances {mine[1]:.1e}, {theirs:.1e}"
            for path, time in zip(WITHOUT, times, strict=True):
                yield Ratio(f"dop853, {path} / C++, {name}, error {target:g}", time, hand, WITHOUT[path], note)
            yield _work(friction, name, target, mine[0], theirs)
            yield from _overhead(friction, name, target, mine[1], dict(zip(WITHOUT, times, strict=True)))
        yield from _sanity(by_hand, name)
    print("  bare C++ evaluation:", ", ".join(f"{mode} {seconds(s)}" for mode, s in programs.bare().items()))


def _run(friction: bool, tolerance: float, *, ledger: bool) -> Any:
    """A run of two revolutions, compiled."""
    from hertzwerk.runtime import simulate

    crank = model(friction, ledger=ledger)
    return simulate(crank, duration=DURATION, tolerance=tolerance, parameters=PARAMETERS, compiled=True)


def _work(friction: bool, name: str, target: float, mine: float, theirs: float) -> Ratio:
    """Evaluations on both sides, and the steps they were made for; with the ledger."""
    ours = _run(friction, mine, ledger=True).statistics
    by_hand = programs.handwritten("dop853", theirs, friction=friction, times=(DURATION,))
    note = (
        f"steps {ours.steps} (rejected {ours.rejected}, retaken {ours.retaken}), "
        f"{by_hand['steps']} (rejected {by_hand['rejected']})"
    )
    what = f"    evaluations, {name}, error {target:g}"
    return Ratio(what, ours.rhs_evaluations, by_hand["evaluations"], "", note, unit="evaluations")


def _overhead(friction: bool, name: str, target: float, tolerance: float, times: dict[str, float]) -> Iterator[Ratio]:
    """A whole run over its evaluations by themselves."""
    run = _run(friction, tolerance, ledger=False)
    for path, time in times.items():
        found = evaluations(run, compiled=path == "C")
        alone = sum(each.number * each.seconds for each in found.values())
        note = ", ".join(f"{mode} {each.number} x {seconds(each.seconds)}" for mode, each in found.items())
        yield Ratio(f"    run / its bare evaluations, {path}, {name}, error {target:g}", time, alone, "", note)


def _sanity(by_hand: Contender, name: str) -> Iterator[Ratio]:
    """What the hand-written program itself should cost."""
    tolerance = 1e-6
    counts = programs.handwritten("dop853", tolerance, friction=by_hand.friction, times=(DURATION,))
    contact = counts["contact_evaluations"]
    flight = counts["evaluations"] - contact

    def alone() -> float:
        cost = programs.bare()
        return contact * cost["friction" if by_hand.friction else "contact"] + flight * cost["flight"]

    whole, bare = medians(by_hand.time(tolerance), alone)
    yield Ratio(f"C++ / its {contact + flight:,} bare evaluations, {name}", whole, bare, "<= 1.5")
    if by_hand.friction:
        return
    for error, expected in SANE:
        tolerance = by_hand.tolerance_for(error)
        if tolerance is not None:
            run = programs.handwritten("dop853", tolerance, friction=False, times=(DURATION,))
            note = f"issue 4: near {expected:,}"
            yield Ratio(f"C++'s evaluations, {name}, error {error:g}", run["evaluations"], expected, "", note, unit="")
