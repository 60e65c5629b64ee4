"""Contents of an export: the numbers of a scene and the tables of its names."""

from __future__ import annotations

import keyword
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
from hertzwerk.runtime.engine.integration.step.set_valued_friction import NO_PAIR
from hertzwerk.runtime.engine.integration.tableaux.methods import SUNDIALS
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.signal import constant
from hertzwerk.runtime.engine.run.run_request import Settings, read
from hertzwerk.runtime.engine.run.single_run import APPROACH_FLOOR, set_up
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.engine.solution.step_observers import Needs
from hertzwerk.runtime.engine.start.assembly import journals
from hertzwerk.runtime.engine.start.start_values import assembled
from hertzwerk.runtime.output.tables.history_meanings import meaning_of
from hertzwerk.runtime.simulation import solve

IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,62}")
C_WORDS = frozenset(re.findall(r"\w+", """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while main
"""))  # fmt: skip


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


class Row(NamedTuple):
    """Row of a table of names: SI unit, default [SI], meaning, and another unit that it was declared in."""

    name: str
    unit: str
    value: float
    meaning: str
    shown: str = ""


@dataclass(frozen=True)
class Contents:
    """Numbers and names of an export.

    parameters, starts (coordinates and speeds of the joints), states, outputs, inputs, pairs    tables of names
    stated, requested    of each start, whether the scene states it, and whether the export request does
    scales           (ny + 4,) of a run, for those that the scene does not state
    loops            unit of each constraint that the start closes, those of closed clearances last
    """

    model: EngineModel
    made: Integrator
    parameters: tuple[Row, ...]
    starts: tuple[Row, ...]
    states: tuple[Row, ...]
    outputs: tuple[Row, ...]
    inputs: tuple[Row, ...]
    pairs: tuple[Row, ...]
    stated: tuple[bool, ...]
    requested: tuple[bool, ...]
    scales: np.ndarray
    loops: tuple[str, ...]
    seconds: float
    tolerance: float
    method: str
    floor: float

    @property
    def follows(self) -> bool:
        """Whether the start follows from other parameters by closing loops, or needs none."""
        return not self.model.module.SEATED


def name_faults(where: str, name: str) -> list[Fault]:
    """Return the fault of a name that is no identifier of C."""
    if IDENTIFIER.fullmatch(name) and name not in C_WORDS and not keyword.iskeyword(name):
        return []
    return [
        Fault(where, repr(name), "an identifier of C: letters, digits and _, beginning with a letter, and no word of C")
    ]


def contents(request: ExportRequest) -> Contents:
    """Find the numbers of an export, its tolerance by runs; raises InputError for what cannot be exported."""
    model, settings = request.model, request.settings
    refuse("export", _refused(model, settings.method, request.initial))
    model = with_zero_inputs(model)
    run_inputs, _ = read(model, settings, request.parameters, request.initial)
    run = set_up(model, settings, run_inputs, needs=Needs.ENDS)
    tolerance = settings.tolerance
    if tolerance is None:
        solution = solve(model, settings, request.parameters, request.initial, needs=Needs.ENDS)
        if not solution.outcome.finished:
            actual = f"{solution.outcome.name}: {solution.outcome.message}"
            way_out = f"{solution.outcome.remedy or 'another accuracy or duration'}; or a local --tolerance, without an estimate"
            raise InputError(model.name, [Fault("accuracy", actual, "a run that reaches it", way_out)])
        tolerance, scales = solution.settings.tolerance, solution.engine.scales
    else:
        scales = run.scales(tolerance)
    joints = model.joints
    q, u = assembled(model, run_inputs.bound, request.initial, [])
    names = (*joints.coordinates, *joints.speeds)
    found_by_assembly = model.module.GIVEN is not None
    said = {*(model.module.GIVEN if found_by_assembly else names)}
    numbers = dict(zip(model.parameters, map(float, run_inputs.bound.p), strict=True))  # exponents of units among them
    signals = {name: float(model.signals[name](np.zeros(1))[0]) for name in model.inputs}
    loops = joints.module.CONSTRAINTS if found_by_assembly else ()
    closed = [model.module.OUTPUTS[i] for i in journals(model)] if found_by_assembly else []
    return Contents(
        model=model,
        made=run.engine.integrator,
        parameters=tuple(
            Row(name, _si(port.unit, numbers), float(value), port.meaning, _shown(port.unit))
            for (name, port), value in zip(model.parameters.items(), run_inputs.bound.p, strict=True)
        ),
        starts=tuple(
            Row(name, joints.units[name], float(value), f"{name} at the start")
            for name, value in zip(names, (*q, *u), strict=True)
        ),
        states=_rows(model, tuple(model.units), [*run_inputs.q, *run_inputs.u, *np.zeros(model.nz)]),
        outputs=_rows(model, _outputs(model, request.outputs)),
        inputs=tuple(
            Row(name, _si(unit, numbers), signals[name], meaning or f"input {name}")
            for name, (unit, meaning) in model.inputs.items()
        ),
        pairs=tuple(Row(pair, "1", 0.0, f"contact pair {pair}") for pair in model.pairs),
        stated=tuple(name in said for name in names),
        requested=tuple(name in request.initial for name in names),
        scales=np.concatenate([scales.state, scales.scene]),
        loops=tuple(row[1] for row in (*loops, *closed)),
        seconds=run_inputs.seconds,
        tolerance=tolerance,
        method=settings.method,
        floor=APPROACH_FLOOR,
    )


def _refused(model: EngineModel, method: str, initial: Collection[str]) -> list[Fault]:
    """Return the faults of what an export cannot have."""
    faults = []
    if method in SUNDIALS:
        expected = "a method whose steps are in the generated functions: dop853, dopri5, esdirk, rodas or auto"
        faults.append(Fault("method", f"{method}, whose steps are those of SUNDIALS", expected))
    begun = [name for name in model.latches if name in initial]
    faults += [Fault(name, "a contact begun before the start", "a start without one", "leave it out") for name in begun]
    for name, (_, use) in model.smooth.items():
        why = f"an input that must be smooth, for {use}"
        way_out = "drive the joint through a spring and a damper (SpringDamper, JointForce) instead"
        faults.append(Fault(f"input {name}", why, "inputs that may jump between communication points", way_out))
    return faults


def _outputs(model: EngineModel, further: Sequence[str]) -> tuple[str, ...]:
    """Return the names of the outputs: histories of every run that are no states, then others."""
    states = {"t", *model.units, *model.inputs}
    pairs = [pair for *_, pair in model.slips if pair != NO_PAIR]
    both = {pair for pair in pairs if pairs.count(pair) > 1}
    left = {f"{model.pairs[j]}.{part}" for j in both for part in ("slip", "friction_force")}
    return tuple(dict.fromkeys((*(n for n in units_of(model, None) if n not in states | left), *further)))


def _rows(model: EngineModel, names: Sequence[str], values: Sequence[float] | None = None) -> tuple[Row, ...]:
    units = units_of(model, None)
    numbers = values if values is not None else np.zeros(len(names))
    return tuple(
        Row(name, units[name], float(value), meaning_of(model, name))
        for name, value in zip(names, numbers, strict=True)
    )


def _si(unit: str, numbers: Mapping[str, float]) -> str:
    """Return the SI unit of a value that is declared in another one: what is in mm is exported in m."""
    parsed = parse_unit(unit).at(numbers)
    text = str(parsed)
    if parsed.angle != 1:
        return text
    return "rad" if text == "1" else f"rad{text[1:]}" if text.startswith("1/") else text


def _shown(unit: str) -> str:
    """Return a unit that differs from the SI one by a factor; else nothing."""
    return "" if parse_unit(unit).factor == 1 else unit
