"""Parameters and states of a model in SI: their unit texts, and values as numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping

from hertzwerk.derive.common.units import Unit, UnitError, parse_unit
from hertzwerk.runtime.engine.model.binding import Value, read
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

NUMBER = parse_unit("1")  # unit of what no model declares


@per_model
def si_units(model: EngineModel) -> Mapping[str, str]:
    """Return the SI unit text of every parameter and state, "" of a number."""
    return {name: si_text(unit) for name, unit in _texts(model).items()}


def si_of(model: EngineModel, name: str, value: Value) -> float:
    """Return the value of a parameter, state or input in SI; nan where it cannot be read as one."""
    try:
        number, unit, _ = read(value)
    except UnitError:
        return math.nan
    declared = _units(model).get(name, NUMBER)
    alike = unit.exponents == declared.exponents or bool(declared.free_names)
    return unit.to_si(number) if alike else math.nan


@per_model
def latch_units(model: EngineModel) -> Mapping[str, str]:
    """Return the unit text of what a contact in progress keeps of its onset."""
    return {row[0]: row[1] for row in model.module.LATCHES}


@per_model
def _units(model: EngineModel) -> Mapping[str, Unit]:
    """Return the unit of every parameter, state, latch and input as the model declares it."""
    inputs = {name: unit for name, (unit, _) in model.inputs.items()}
    return {name: parse_unit(text) for name, text in {**_texts(model), **latch_units(model), **inputs}.items()}


def _texts(model: EngineModel) -> dict[str, str]:
    """Return the unit text of every parameter and state as the model declares it."""
    return {**{name: port.unit for name, port in model.parameters.items()}, **model.joints.units, **model.units}


def si_text(unit: str) -> str:
    """Return the text of a unit's SI unit, angles named: mm -> m, rpm -> rad/s, "" for a number."""
    read = parse_unit(unit)
    text = str(read)
    if read.angle == 1:
        return text.replace("1", "rad", 1)
    return "" if text == "1" else text


def unit_at(unit: str, parameters: Mapping[str, tuple[float, str]]) -> str:
    """Return a unit text with the values of parameters in its exponents: N/m^exponent -> N/m^1.5."""
    read = parse_unit(unit or "1")
    return str(read.at({name: parameters[name][0] for name in read.free_names})) if read.free_names else unit


def ratio(above: str, below: str) -> str:
    """Return the unit text of a derivative, of the units above and below, such as "N/(m/s)"."""
    if not below:
        return above
    return f"{above or 1}/({below})" if set(below) & set("/ ") else f"{above or 1}/{below}"
