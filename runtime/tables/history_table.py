"""Histories of a run as a labelled table: units, meanings, parameters."""

from __future__ import annotations

from hertzwerk.derive.units import parse_unit
from hertzwerk.runtime.host.versions import versions
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.solution.history import acceleration_of, constraint_force
from hertzwerk.runtime.solution.solution import Solution
from hertzwerk.runtime.tables.labelled_table import Column, LabelledTable

_WORDS = {  # by the last part of a name, or by the one before an axis: meaning, without what it is of
    "mode": "whether the surfaces touch: 0 apart, 1 in contact",
    "gap": "distance of the surfaces",
    "gap_rate": "rate of the distance of the surfaces",
    "penetration": "penetration of the surfaces",
    "normal_force": "normal force",
    "sliding_velocity": "sliding velocity while in contact",
    "approach_speed": "approach speed, latched at the onset of contact",
    "eccentricity": "eccentricity in the bush's axes",
    "slip": "mode of set-valued friction",
    "friction_force": "friction force",
    "dissipated": "energy dissipated since the start",
    "input": "work put in since the start",
    "force": "force",
    "thickness": "least thickness of the film",
    "apart": "opening of the closed loop",
    "off": "opening of the closed loop",
    "turned": "sine of the angle that the closed loop is open by",
}
_ENERGY = "kinetic and potential energy, with what springs and surfaces store"


def history_table(run: Solution) -> LabelledTable:
    """Return every history of a run over its times, with parameters and outcome."""
    model, units = run.model, run.history.units
    columns = {name: Column(run[name], units[name], meaning_of(model, name)) for name in ("t", *run.names)}
    about: dict[str, str | float] = {
        "scene": model.name,
        "outcome": run.outcome.name,
        "method": run.method,
        "tolerance": run.tolerance,
        **({} if run.error is None else {"error": run.error.end}),
        "hertzwerk": versions()["hertzwerk"],
    }
    given = {f"parameter.{name}": _parameter(run, name) for name in run.parameters}
    return LabelledTable("t", columns, {**about, **given})


def _parameter(run: Solution, name: str) -> str:
    """Return a parameter as text that `simulate` takes, with every digit."""
    value, unit = run.parameters[name]
    read = parse_unit(unit)
    if read.free_names:  # N/m^exponent, of a law whose exponent is a parameter
        value, unit = read.to_si(value), str(read.at({of: run.parameters[of][0] for of in read.free_names}))
    return repr(value) if unit == "1" else f"{value!r} {unit}"


def meaning_of(model: Model, name: str) -> str:
    """Return what a history is, in a few words."""
    if name in ("t", "energy"):
        return "time" if name == "t" else _ENERGY
    whose, _, part = name.rpartition(".")
    axis = f", {label}" if (label := part.rpartition("_")[2]) != part and len(label) == 1 else ""
    if name in model.coordinates:
        return f"coordinate {part} of {whose}"
    if name in model.speeds:
        return f"{part.replace('_', ' ')} of {whose}"
    if name in map(acceleration_of, model.speeds):
        return f"{part.replace('_', ' ')} of {whose}"
    if name in map(constraint_force, model.constraints):
        kind, labelled, _ = part.partition("_")
        held = f"closed loop of {whose}{axis}" if labelled else f"coupling {whose}, on its first coordinate"
        return f"{kind} that holds the {held}"
    if name in model.constraints and part in ("off", "turned"):
        return f"error of the coupling {whose}"
    words = _WORDS.get(part) or _WORDS.get(part.rpartition("_")[0])
    return f"{part.replace('_', ' ')} of {whose}" if words is None else f"{words}, of {whose}{axis}"
