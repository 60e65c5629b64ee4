"""Request for an export: the model with its numbers, and how it is to be simulated there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar

from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.signal import constant
from hertzwerk.runtime.engine.run.run_request import Settings

AnyModel = TypeVar("AnyModel", bound=EngineModel)


def with_zero_inputs(model: AnyModel) -> AnyModel:
    """Return a model whose inputs are zero where they have no value: each is set where the export runs."""
    missing = {name: constant(0.0, "0") for name in model.inputs if name not in model.signals}
    return model.with_signals({**model.signals, **missing}) if missing else model


@dataclass(frozen=True)
class ExportRequest:
    """Model to export, the parameters and start that become its defaults, and the settings of its runs.

    outputs    names of histories, readings included, to export beside those of every export
    fmi        version of FMI
    """

    model: EngineModel
    parameters: Mapping[str, Value]
    initial: Mapping[str, Value]
    settings: Settings
    outputs: tuple[str, ...] = ()
    fmi: int = 3
