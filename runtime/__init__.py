"""Loads generated models and runs them: `from hertzwerk.runtime import load, simulate`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hertzwerk.derive.faults import Fault, InputError
    from hertzwerk.runtime.effects.leaving_out import study_effects
    from hertzwerk.runtime.loading import Model, load
    from hertzwerk.runtime.model.model import Bound
    from hertzwerk.runtime.simulation import Solution, simulate
    from hertzwerk.runtime.solution.impacts import Impact
    from hertzwerk.runtime.solution.outcome import Outcome
    from hertzwerk.runtime.solution.solution import Statistics
    from hertzwerk.runtime.sweep.sweep import simulate_many
    from hertzwerk.runtime.sweep.sweep_table import Sweep

_PLACES = {
    "Bound": "model.model",
    "Fault": "hertzwerk.derive.faults",
    "Impact": "solution.impacts",
    "InputError": "hertzwerk.derive.faults",
    "Model": "loading",
    "Outcome": "solution.outcome",
    "Solution": "simulation",
    "Statistics": "solution.solution",
    "Sweep": "sweep.sweep_table",
    "load": "loading",
    "simulate": "simulation",
    "simulate_many": "sweep.sweep",
    "study_effects": "effects.leaving_out",
}

__all__ = [
    "Bound",
    "Fault",
    "Impact",
    "InputError",
    "Model",
    "Outcome",
    "Solution",
    "Statistics",
    "Sweep",
    "load",
    "simulate",
    "simulate_many",
    "study_effects",
]


def __getattr__(name: str) -> Any:
    """Return a name from its module, imported on first use (PEP 562)."""
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    place = _PLACES[name]
    value = getattr(import_module(place if place.startswith("hertzwerk.") else f"{__name__}.{place}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
