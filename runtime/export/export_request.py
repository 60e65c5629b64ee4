"""Request for an export: the model with its numbers, and how it is to be simulated there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.request import Settings


@dataclass(frozen=True)
class Asked:
    """Model to export, the parameters and start that become its defaults, and the settings of its runs.

    outputs    names of histories, readings included, to export beside those of every export
    fmi        version of FMI
    """

    model: Model
    parameters: Mapping[str, Value]
    initial: Mapping[str, Value]
    settings: Settings
    outputs: tuple[str, ...] = ()
    fmi: int = 3
