"""Initial state of a motion: the model's, with given values, unit quaternions and closed loops."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, unknown
from hertzwerk.runtime.engine.model.binding import Value, named_values, plain_value, read_state
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import BoundParameters, Dependent, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.si_values import latch_units

AnyValue = TypeVar("AnyValue", bound=Value)


def split_values(model: EngineModel, values: Mapping[str, AnyValue]) -> tuple[dict[str, AnyValue], dict[str, AnyValue]]:
    """Split values by name into parameters and initial states of the joints.

    A name that is neither is left among the parameters.
    """
    states = _states(model)
    parameters = {name: value for name, value in values.items() if name not in states}
    return parameters, {name: value for name, value in values.items() if name in states}


@per_model
def _states(model: EngineModel) -> frozenset[str]:
    """Return the names of the initial states of the joints."""
    return frozenset((*model.joints.coordinates, *model.joints.speeds, *model.latches))


def stated_values(
    model: EngineModel, parameters: Mapping[str, Value] | None, initial: Mapping[str, Value] | None, faults: list[Fault]
) -> tuple[dict[str, Value], dict[str, Value]]:
    """Return parameters and initial states, which may stand among the parameters too; faults are appended."""
    own, states = split_values(model, _plain("parameters", parameters, faults))
    stated = _plain("initial", initial, faults)
    faults += [Fault(name, "among parameters and initial", "one of the two") for name in stated if name in states]
    return own, {**states, **stated}


def _plain(where: str, values: Mapping[str, Value] | None, faults: list[Fault]) -> dict[str, Value]:
    stated = named_values(where, {} if values is None else values, faults)
    return {name: plain_value(value) for name, value in stated.items()}


@np.errstate(all="ignore")  # what is not finite is a fault, or an outcome
def start_of(
    model: EngineModel, parameters: Mapping[str, Value], initial: Mapping[str, Value], faults: Sequence[Fault] = ()
) -> tuple[BoundParameters, np.ndarray, np.ndarray]:
    """Return the bound numbers, q (nq,) and u (nu,) that a run would start from.

    Raises InputError with every fault, those passed included.
    """
    problems = list(faults)
    bound, wrong = model.check(parameters)
    has_initial = not isinstance(initial, Mapping) or len(initial) > 0  # what is no mapping is a fault, told below
    stated = None if bound is None or has_initial else as_stated(model, bound)
    q, u = read_start(model, bound, initial, problems) if stated is None else stated
    if bound is None or problems:
        raise InputError(model.name, wrong + problems)
    return bound, q, u


def read_start(
    model: EngineModel, bound: BoundParameters | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """Return q and u at the start; bad input is appended to `faults`.

    In absolute coordinates both are given for the joints and converted.
    """
    q, u = assembled(model, bound, initial, faults)
    return (q, u) if bound is None or faults else model.placed(bound, q, u)


def assembled(
    whole: EngineModel, bound: BoundParameters | None, initial: Mapping[str, Value], faults: list[Fault]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the start in joint coordinates: loops closed, journals centred where possible, or seated."""
    model = whole.joints
    values: dict[str, float] = {}
    names = (*model.coordinates, *model.speeds)
    latches = latch_units(whole)
    for name, value in named_values("initial", initial, faults).items():
        if name in latches:
            faults += [fault for _, fault in [read_state(name, latches[name], value)] if fault is not None]
            continue
        if name not in names:
            faults.append(unknown("state", name, names))
            continue
        si, fault = read_state(name, model.units[name], value)
        values[name] = si
        if fault is not None:
            faults.append(fault)
    if bound is None:
        return np.zeros(model.nq), np.zeros(model.nu)
    start = np.concatenate(model.evaluate("start", bound.p))
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
    if whole.module.GIVEN is not None and not faults:
        from hertzwerk.runtime.engine.start.assembly import assemble  # a tree without journals needs none

        q, u, unclosed = assemble(whole, bound, q, u, {*whole.module.GIVEN, *values})
        faults.extend(unclosed)
        if whole.module.SEATED and not faults:
            from hertzwerk.runtime.engine.start.seating import seat

            q, u, unclosed = seat(whole, bound, q, u, {*whole.module.GIVEN, *values})
            faults.extend(unclosed)
    return q, u


def dependent(model: EngineModel, bound: BoundParameters, q: np.ndarray) -> tuple[Dependent, ...]:
    """Return groups of redundant constraints, valid from a start on."""
    if not model.nl:
        return ()
    from hertzwerk.runtime.engine.start import assembly  # a tree needs none

    return assembly.dependent(model, bound, q)


def as_stated(model: EngineModel, bound: BoundParameters) -> tuple[np.ndarray, np.ndarray] | None:
    """Return q (nq,) and u (nu,) as a scene states them; None where they are to be found."""
    stated = _stated(model)
    if stated is None:
        return None
    q, u, closed = stated(bound.p, bound.c)
    return (q, u) if closed[0] else None


@per_model
def _stated(model: EngineModel) -> Callers | None:
    """Build the function (p, c) -> q, u, and whether they are closed; None where more is to be done."""
    module = model.module
    if module.GIVEN is None or module.SEATED or model.quaternions or model.joints is not model:
        return None
    from hertzwerk.runtime.engine.start.assembly import journals, judged  # a tree without journals needs none

    if model.nl and journals(model):
        return None
    p, c = model.symbols("p c", ca.MX)
    q, u = model.function("start")(p)
    closed: Any = ca.sum1(ca.fabs(ca.vertcat(q, u))) < ca.inf
    loops = judged(model, model if journals(model) else None).function
    phi, rate, _, _, size, rate_size = loops(0, q, u, c, model.function("scales")(p)[1])
    closed *= ca.sum1(ca.vertcat(ca.fabs(phi) <= size, ca.fabs(rate) <= rate_size)) == 2 * size.numel()
    return Callers(ca.Function("as_stated", [p, c], [q, u, closed]))
