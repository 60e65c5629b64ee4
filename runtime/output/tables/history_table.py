"""Histories of a run as a labelled table: units, meanings, parameters."""

from __future__ import annotations

from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.model.si_values import unit_at
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.output.tables.history_meanings import meaning_of
from hertzwerk.runtime.output.tables.labelled_table import Column, LabelledTable
from hertzwerk.runtime.system.versions import versions


def history_table(run: EngineSolution) -> LabelledTable:
    """Return every history of a run over its times, with parameters and outcome."""
    model, units = run.engine.model, run.engine.history.units
    columns = {name: Column(run[name], units[name], meaning_of(model, name)) for name in ("t", *run)}
    about: dict[str, str | float] = {
        "scene": model.name,
        "outcome": run.outcome.name,
        "method": run.settings.method,
        "tolerance": run.settings.tolerance,
        **({} if run.error is None else {"error": run.error.judged}),
        "hertzwerk": versions()["hertzwerk"],
    }
    parameters = {f"parameter.{name}": _parameter(run, name) for name in run.settings.parameters}
    return LabelledTable("t", columns, {**about, **parameters})


def _parameter(run: EngineSolution, name: str) -> str:
    """Return a parameter as text that `simulate` takes, with every digit."""
    value, unit = run.settings.parameters[name]
    read = parse_unit(unit)
    if read.free_names:  # N/m^exponent, of a law whose exponent is a parameter
        value, unit = read.to_si(value), unit_at(unit, run.settings.parameters)
    return repr(value) if unit == "1" else f"{value!r} {unit}"
