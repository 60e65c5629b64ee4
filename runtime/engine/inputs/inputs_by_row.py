"""Inputs that differ from row to row of many runs: choices by label, constants, factors.

{"torque": {"calm": "calm.csv:load", "gusty": Samples(...)}}    choices by labels of one's own
{"torque": ["calm.csv:load", "gusty.csv:load", "0.5 N m"]}      choices that are their own labels, as text with commas too
{"torque": "0.1..0.5 N m:5"}                                    constants
{"torque.scale": "0.5..1.5:5"}                                  factors on what the input is otherwise
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import UnitError
from hertzwerk.runtime.engine.inputs.input_values import in_file, input_text, located, signal_of
from hertzwerk.runtime.engine.model.binding import Value, read, read_state
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import si_of, si_text
from hertzwerk.runtime.engine.model.signal import Signal

SCALE = ".scale"
AnyModel = TypeVar("AnyModel", bound=EngineModel)


class Labels(tuple[str, ...]):
    """Labels that rows choose by, in their order."""

    __slots__ = ()


@dataclass(frozen=True)
class Choices:
    """Signals by the name of an input and label, and the texts that they are read from.

    None is the text of one made in Python.
    """

    signals: Mapping[str, Mapping[str, Signal]] = field(default_factory=dict)
    texts: Mapping[str, Mapping[str, str | None]] = field(default_factory=dict)

    def of(self, model: AnyModel, values: Mapping[str, Value]) -> tuple[AnyModel, dict[str, Value]]:
        """Return the model with the inputs of a row, and its values that are of no input; raises InputError."""
        mine = {name: value for name, value in values.items() if str(name).removesuffix(SCALE) in model.inputs}
        if not mine:
            return model, dict(values)
        faults: list[Fault] = []
        signals = dict(model.signals)
        for name in sorted(mine, key=lambda name: name.endswith(SCALE)):
            base = name.removesuffix(SCALE)
            if name == base:
                label = mine[name]
                signal = self.signals.get(name, {}).get(label) if isinstance(label, str) else None
                signal = signal or signal_of(name, label, model.inputs[name][0], 0.0, faults)
                signals |= {} if signal is None else {name: signal}
            else:
                factor, fault = read_state(name, "1", mine[name])
                faults += [] if fault is None else [fault]
                signals |= {base: signals[base].scaled(factor)} if fault is None and base in signals else {}
        refuse(model.name, faults)
        return model.with_signals(signals), {name: value for name, value in values.items() if name not in mine}

    def digests(self) -> dict[str, str]:
        """Digest of everything that rows choose among, by input and label."""
        return {
            f"{name}.{label}": signal.digest
            for name, signals in self.signals.items()
            for label, signal in signals.items()
        }


NO_CHOICES = Choices()


def units_of_inputs(model: EngineModel) -> dict[str, str]:
    """Return the SI unit text of what rows may have of inputs: each, and its factor."""
    units = {name: si_text(unit) for name, (unit, _) in model.inputs.items()}
    return {**units, **{f"{name}{SCALE}": "" for name in units}}


def numbers_of(model: EngineModel, values: Mapping[str, Value]) -> dict[str, float]:
    """Return the values of a row in SI, without the labels of choices."""
    labels = {name for name, value in values.items() if isinstance(value, str) and name in model.inputs}
    return {name: si_of(model, name, value) for name, value in values.items() if name not in labels}


def read_choices(
    model: EngineModel, over: Mapping[str, Any], seconds: float, faults: list[Fault]
) -> tuple[dict[str, Any], Choices]:
    """Return what is varied with the labels of choices, and those; faults are appended.

    seconds    [s], up to which functions are sampled
    """
    varied, signals, texts = dict(over), {}, {}
    for name in model.inputs:
        choices = _listed(over[name]) if name in over else None
        if choices is None:
            continue
        read: dict[str, Signal] = {}
        for label, value in choices.items():
            signal = signal_of(name, value, model.inputs[name][0], seconds, faults)
            read |= {} if signal is None else {label: signal}
        varied[name], signals[name] = Labels(choices), read
        texts[name] = {label: input_text(value) for label, value in choices.items()}
    return varied, Choices(signals, texts)


def located_choices(varied: Any, folder: Path) -> Any:
    """Return what is varied with its files as seen from a folder, labels as they are; others stay."""
    choices = _listed(varied) or {}
    if not any(map(in_file, choices.values())):
        return varied
    return {label: located(x, folder) for label, x in choices.items()}


def read_rows(
    model: EngineModel, rows: Sequence[Mapping[str, Any]], seconds: float
) -> tuple[list[dict[str, Value]], Choices]:
    """Return the rows of many runs with labels, and their choices; raises InputError with every fault."""
    faults: list[Fault] = []
    labelled = [dict(row) for row in rows]
    signals: dict[str, dict[str, Signal]] = {}
    for name in model.inputs:
        mine = [row for row in labelled if name in row]
        if all(map(_plain, (row[name] for row in mine))):
            for row in mine:
                number, _, unit = read(row[name])
                row[name] = number, unit
            continue
        there = signals.setdefault(name, {})
        for row in mine:
            signal = signal_of(name, row[name], model.inputs[name][0], seconds, faults)
            if signal is not None:
                row[name] = _label(_name(row[name]), signal, there)
    refuse(model.name, list(dict.fromkeys(faults)))
    return labelled, Choices(MappingProxyType(signals))


def _listed(choices: Any) -> dict[str, Any] | None:
    """Return choices by label; None for constants, which are numbers."""
    if isinstance(choices, Mapping):
        return {str(label): value for label, value in choices.items()}
    if isinstance(choices, str):
        parts = [part.strip() for part in choices.split(",")]
        return {part: part for part in parts} if any(map(in_file, parts)) else None
    alone = not isinstance(choices, list | tuple) or _plain(choices)
    values: Iterable[Any] = [choices] if alone else choices
    return None if all(map(_plain, values)) else _by_name(values)


def _by_name(values: Iterable[Any]) -> dict[str, Any]:
    by_name: dict[str, Any] = {}
    for value in values:
        by_name[_free(_name(value), by_name)] = value
    return by_name


def _plain(value: Any) -> bool:
    """Return whether a value is a constant."""
    try:
        read(value)
    except UnitError:
        return False
    return True


def _name(value: Any) -> str:
    """Return what a choice is called that has no label of its own."""
    text = input_text(value) if not isinstance(value, str) else value.strip()
    of_its_own = getattr(value, "source", "") or getattr(value, "name", "") or getattr(value, "__name__", "")
    return text or of_its_own or "samples"


def _free(label: str, taken: Iterable[str]) -> str:
    known = set(taken)
    others = (f"{label} {n}" for n in range(2, len(known) + 3))
    return label if label not in known else next(other for other in others if other not in known)


def _label(name: str, signal: Signal, there: dict[str, Signal]) -> str:
    """Return the label of a signal among those that are there, of which equal ones share one."""
    alike = (label for label, other in there.items() if other.digest == signal.digest)
    label = next(alike, None) or _free(name, there)
    there.setdefault(label, signal)
    return label
