"""The integrators of the slider-crank that are compared: hertzwerk's, the hand-written C++, CVODE from C, SciPy's."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from benchmarks import programs
from benchmarks.equal_error import DURATION, Contender, absolute
from benchmarks.ratios import Measurement, decades, hot

from reference.slider_crank import SliderCrank

COARSE = 4  # tolerances to a decade for what takes long
PARAMETERS = {"crank_inertia": "1e-5 kg m^2"}  # its ledger alone depends on it
STIFFNESS = f"power(K={SliderCrank().K!r} N/m^1.5, n=1.5)"  # 6.61e10, to the digits of the reference


@cache
def model(friction: bool, *, ledger: bool = False) -> Any:
    """The slider-crank with a stiffness by number, no built-in scene; without the energy ledger, which no peer keeps, unless requested."""
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


@cache
def cvode(formula: str, solver: str, friction: bool) -> Contender:
    """SUNDIALS CVODE called from C."""

    def state(duration: float, tolerance: float) -> Sequence[float]:
        return programs.cvode(formula, solver, tolerance, friction=friction, time=duration)["state"]

    def time(tolerance: float) -> Measurement:
        def measure() -> float:
            run = programs.cvode(formula, solver, tolerance, friction=friction, time=DURATION, repeats=15)
            return run["seconds"]

        return measure

    return Contender(f"CVODE {formula}, {solver}", friction, state, time, decades(2, 13, COARSE))


@cache
def scipy(method: str, friction: bool, *, compiled: bool) -> Contender:
    """solve_ivp on the generated functions, restarted at its events."""
    from benchmarks.peers import SolveIvp

    solve = SolveIvp(model(friction), method, compiled=compiled)

    def state(duration: float, tolerance: float) -> Sequence[float]:
        return absolute(duration, solve(duration, tolerance))

    def time(tolerance: float) -> Measurement:
        return hot(lambda: solve(DURATION, tolerance), calls=1, warm=0)

    return Contender(f"solve_ivp {method}", friction, state, time, decades(3, 10, COARSE))
