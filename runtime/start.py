"""The start of a motion: the model's, with given values in their place, quaternions of norm 1, loops closed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np

from hertzwerk.derive.faults import Fault, InputError, unknown
from hertzwerk.runtime.binding import Value, named_values, read_state
from hertzwerk.runtime.model import Bound, Dependent, Model

Given = TypeVar("Given", bound=Value)


def sorted_out(model: Model, values: Mapping[str, Given]) -> tuple[dict[str, Given], dict[str, Given]]:
    """Values given by name as parameters and initial states, which are of the joints; a name that is neither is left among the parameters."""
    states = {*model.joints.coordinates, *model.joints.speeds}
    parameters = {name: value for name, value in values.items() if name not in states}
    return parameters, {name: value for name, value in values.items() if name in states}


def start_of(
    model: Model, parameters: Mapping[str, Value], initial: Mapping[str, Value], faults: Sequence[Fault] = ()
) -> tuple[Bound, np.ndarray, np.ndarray]:
    """What a run would start from: the numbers bound, q (nq,) and u (nu,); raises InputError with every fault, those found before included."""
    found = list(faults)
    bound, wrong = model.check(parameters)
    q, u = read_start(model, bound, initial, found)
    if bound is None or found:
        raise InputError(model.name, wrong + found)
    return bound, q, u


def read_start(
    model: Model, bound: Bound | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """q and u at the start; in absolute coordinates both are given of the joints, and are placed. What is bad becomes faults."""
    joints = model.joints
    q, u = _assembled(joints, bound, initial, faults)
    if joints is model or bound is None or faults:
        return q, u
    q, u = (np.array(x).ravel() for x in model.function("placed")(0.0, q, u, bound.c))
    return q, u


def _assembled(
    model: Model, bound: Bound | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """The start in joint coordinates, loops closed."""
    values: dict[str, float] = {}
    names = (*model.coordinates, *model.speeds)
    for name, value in named_values("initial", initial, faults).items():
        if name not in names:
            faults.append(unknown("state", name, names))
            continue
        si, fault = read_state(name, model.units[name], value)
        values[name] = si
        if fault is not None:
            faults.append(fault)
    if bound is None:
        return np.zeros(model.nq), np.zeros(model.nu)
    start = np.concatenate([np.array(x).ravel() for x in model.function("start")(bound.p)])
    for i, name in enumerate(names):
        start[i] = values.get(name, start[i])
        if not math.isfinite(start[i]) and name not in values:
            faults.append(
                Fault(name, f"{float(start[i])!r} at the start", "a finite value", "it follows from the parameters")
            )
    for i in model.quaternions:
        norm = float(np.linalg.norm(start[i : i + 4]))
        if math.isfinite(norm):
            if norm == 0:
                faults.append(
                    Fault(
                        names[i].removesuffix("0"),
                        "a quaternion of norm 0 at the start",
                        "one that can be divided by its norm",
                    )
                )
            start[i : i + 4] /= norm or 1
    q, u = start[: model.nq], start[model.nq :]
    if model.nl and not faults:
        from hertzwerk.runtime.assembly import assemble  # a tree needs none

        q, u, open_ones = assemble(model, bound, q, u, {*model.module.GIVEN, *values})
        faults.extend(open_ones)
    return q, u


def dependent(model: Model, bound: Bound, q: np.ndarray) -> tuple[Dependent, ...]:
    """Constraints that follow from others, from a start on."""
    if not model.nl:
        return ()
    from hertzwerk.runtime import assembly  # a tree needs none

    return assembly.dependent(model, bound, q)
