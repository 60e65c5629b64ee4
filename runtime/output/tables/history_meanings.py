"""Meanings of histories in a few words, and the list of all that a model has."""

from __future__ import annotations

from dataclasses import dataclass

from hertzwerk.derive.common.markup import table
from hertzwerk.runtime.engine.model.derived_histories import readings_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.history import acceleration_of, constraint_force, friction_force, units_of

_WORDS = {  # by the last part of a name, or by the one before an axis: meaning, without what it is of
    "mode": "whether the surfaces touch: 0 apart, 1 in contact",
    "gap": "distance of the surfaces",
    "gap_rate": "rate of the distance of the surfaces",
    "penetration": "penetration of the surfaces",
    "normal_force": "normal force",
    "sliding_velocity": "sliding velocity while in contact",
    "approach_speed": "approach speed, latched at the onset of contact",
    "eccentricity": "eccentricity in the bush's axes",
    "parameter": "parameter of the curve where it is touched or followed",
    "slip": "mode of set-valued friction: 0 where the surfaces stick, else the sign of sliding, 1 in two directions",
    "friction_force": "friction force",
    "turning": "mode of set-valued resistance: 0 where nothing turns, else the sign of turning, 1 in two directions",
    "moment": "moment",
    "dissipated": "energy dissipated since the start",
    "input": "work put in since the start",
    "force": "force",
    "volume": "volume lost",
    "thickness": "minimum thickness of the film",
    "side_velocity": "velocity across the edge",
    "side_force": "force across the edge",
    "apart": "opening of the closed loop",
    "off": "opening of the closed loop",
    "turned": "sine of the angle that the closed loop is open by",
}
SECTIONS = (False, "in every run"), (True, "derived on request")
_ENERGY = "kinetic and potential energy, with what springs and surfaces store"


@dataclass(frozen=True)
class Entry:
    """History of a model: its name, SI unit and meaning; whether it is derived on request."""

    name: str
    unit: str
    meaning: str
    derived: bool


class Histories(tuple[Entry, ...]):
    """Histories of a model, shown as a table of their names, units and meanings."""

    __slots__ = ()

    def __repr__(self) -> str:
        widths = [max(map(len, column), default=0) for column in zip(*self._cells, strict=True)][:2]
        parts = []
        for derived, title in SECTIONS:
            rows = [
                "  ".join([name.ljust(widths[0]), unit.ljust(widths[1]), meaning])
                for entry, (name, unit, meaning) in zip(self, self._cells, strict=True)
                if entry.derived == derived
            ]
            parts += [f"{title}:", *rows] if rows else []
        return "\n".join(parts)

    def _repr_html_(self) -> str:
        return table(("history", "unit", "meaning"), self._cells)

    @property
    def _cells(self) -> list[tuple[str, str, str]]:
        return [(entry.name, entry.unit, entry.meaning) for entry in self]


def entries(model: EngineModel) -> Histories:
    """Return all histories of a model: those of every run, then the readings, where it has its scene."""
    units = units_of(model, None)
    return Histories(
        Entry(name, units[name], meaning_of(model, name), not units.lists(name)) for name in units.everything
    )


def meaning_of(model: EngineModel, name: str) -> str:
    """Return what a history is, in a few words."""
    if name in ("t", "energy"):
        return "time" if name == "t" else _ENERGY
    if name in model.inputs:
        return model.inputs[name][1] or f"input {name}"
    for saved, _, meaning in getattr(model.module, "BESIDE", ()):
        if saved == name:
            return str(meaning)
    if model.reads and not units_of(model, None).lists(name):
        return readings_of(model).rows[name].meaning
    whose, _, part = name.rpartition(".")
    axis = f", {label}" if (label := part.rpartition("_")[2]) != part and len(label) == 1 else ""
    if name in model.coordinates:
        return f"coordinate {part} of {whose}"
    if name in model.speeds:
        return f"{part.replace('_', ' ')} of {whose}"
    along = [slip for slip, *_ in model.slips if name in (slip, friction_force(slip)) and slip[-1].isdigit()]
    if along:
        turning = units_of(model, None)[friction_force(along[0])] == "N m"
        way, force = ("turning", "moment") if turning else ("sliding", "friction force")
        subject = f"direction of {way}, zero while it sticks," if name in along else force
        return f"{subject} of {whose}, " + (
            "of its spin at the rim" if name[-1] == "3" else f"along its tangent {name[-1]}"
        )
    if name in map(acceleration_of, model.speeds):
        return f"{part.replace('_', ' ')} of {whose}"
    kind, labelled, _ = part.partition("_")
    if kind in ("force", "moment") and name in map(constraint_force, model.constraints):
        held = f"closed loop of {whose}{axis}" if labelled else f"coupling {whose}, on its first coordinate"
        return f"{kind} that holds the {held}"
    if name in model.constraints and part in ("off", "turned"):
        return f"error of the coupling {whose}"
    words = _WORDS.get(part) or _WORDS.get(part.rpartition("_")[0])
    return f"{part.replace('_', ' ')} of {whose}" if words is None else f"{words}, of {whose}{axis}"
