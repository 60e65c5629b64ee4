"""Record of a hard case: its difficulty, its run, and its expected results."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from hertzwerk.runtime.engine.integration.tableaux import methods

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

EXPLICIT, IMPLICIT, METHODS = tuple(methods.EXPLICIT), tuple(methods.IMPLICIT), tuple(methods.IN_GRAPH)
REFERENCED = tuple(methods.METHODS)  # with SUNDIALS as an independent reference
MARGIN, EXTRA = 1.5, 20  # factor and addend of the bound on steps over the measured number


@dataclass(frozen=True)
class Source:
    """Model of a case: a built-in scene, with its variation, or one of `derive.scenes.hard`."""

    scene: str
    hard: bool = False
    without: tuple[str, ...] = ()
    laws: tuple[tuple[str, str], ...] = ()

    def load(self) -> EngineModel:
        """Return the model; derived, or from the cache, where it is not committed."""
        from hertzwerk.runtime.engine.model.model import EngineModel
        from hertzwerk.runtime.loading import engine_model

        if not self.hard:
            return engine_model(self.scene, without=self.without, laws=dict(self.laws))
        from hertzwerk.runtime.engine.model.build import build_hard_scene

        return EngineModel(build_hard_scene(self.scene))


@dataclass(frozen=True)
class Known:
    """Quantity of a run with a known value: SI, allowed to be `within` of `expected`."""

    quantity: str
    of: Callable[[EngineSolution], float]
    expected: float
    within: float
    unit: str
    source: str


@dataclass(frozen=True, eq=False)
class HardCase:
    """One row of the table; SI.

    methods    those that claim the case
    theory     bound on steps tried by method, where theory gives one; elsewhere it is MARGIN times what was measured, and EXTRA (`measured`)
    failures   known failures of a method, by (method, invariant), with the reason
    long       runs only when all cases are requested, or this one
    """

    name: str
    theme: str
    hard: str
    source: Source
    duration: float
    tolerance: float
    methods: tuple[str, ...] = METHODS
    parameters: Mapping[str, Value] = field(default_factory=dict)
    initial: Mapping[str, Value] = field(default_factory=dict)
    known: tuple[Known, ...] = ()
    outcome: str = "finished"
    theory: Mapping[str, int] = field(default_factory=dict)
    failures: Mapping[tuple[str, str], str] = field(default_factory=dict)
    long: bool = False


# -- what is known -----------------------------------------------------------------------------------------------------


def final(name: str, expected: float, within: float, source: str, unit: str = "") -> Known:
    """Expect the last value of a history."""
    return Known(f"final {name}", lambda run: float(run[name][-1]), expected, within, unit or _unit(name), source)


def largest(name: str, expected: float, within: float, source: str, unit: str = "") -> Known:
    """Expect the largest value of a history, over the steps."""
    return Known(f"largest {name}", lambda run: float(run[name].max()), expected, within, unit or _unit(name), source)


def contacts(count: int, source: str) -> Known:
    """Expect the number of contacts that begin."""
    return Known("contacts", lambda run: float(len(run.impacts)), count, 0, "1", source)


def impact(index: int, part: str, expected: float, within: float, source: str) -> Known:
    """Expect a field of an impact: t, speed, peak_force, peak_penetration, duration; NaN if missing."""
    unit = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m", "duration": "s"}[part]

    def of(run: EngineSolution) -> float:
        value = getattr(run.impacts[index], part) if index < len(run.impacts) else None
        return float("nan") if value is None else float(value)

    return Known(f"{part} of impact {index}", of, expected, within, unit, source)


def at(time: float, name: str, expected: float, within: float, source: str) -> Known:
    """Expect the value of a history at an output time [s]."""
    return Known(
        f"{name} at {time:g} s", lambda run: float(run.at([time])[name][0]), expected, within, _unit(name), source
    )


def on_grid(
    parameters: Mapping[str, Value],
    times: Sequence[float],
    index: int,
    name: str,
    expected: float,
    within: float,
    source: str,
) -> Known:
    """Expect the value of a history at an output time [s] of a run that keeps only `times`."""

    def of(run: EngineSolution) -> float:
        from hertzwerk.runtime.simulation import simulate

        again = simulate(
            run.engine.model,
            duration=run.settings.duration,
            tolerance=run.settings.tolerance,
            method=run.settings.method,
            parameters=parameters,
            grid=times,
            compiled=False,
        )
        return float(again[name][index]) if list(again.t) == list(times) else float("nan")

    return Known(f"{name} on a grid", of, expected, within, _unit(name), source)


def _unit(name: str) -> str:
    return {"speed": "m/s", "travel": "m", "penetration": "m", "gap": "m", "dissipated": "J"}.get(
        name.rpartition(".")[2], ""
    )
