"""Readings of a run: histories by a module that is derived when the first of them is needed.

Motions of bodies and named points, joint reactions, drives, contact forces as vectors, energies by body. A model
derives them from the scene that it was loaded from, in under a second for most; text of built-in scenes is cached.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any, NamedTuple, Protocol

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

CONTACTS, MOTION = "contact_readings", "readings"  # functions of the module
ARGUMENTS = {CONTACTS: "t q u z m friction c", MOTION: "t q u a touching multipliers reactions c"}


class Rows(Protocol):
    """Protocol of a run's histories as readings need them: states by rows, and what holds there."""

    model: EngineModel
    rows: Any
    p: np.ndarray | None

    def part(self, name: str) -> np.ndarray:
        """Columns of a part of the rows, shape (rows, size)."""

    def touches(self, pair: int) -> np.ndarray:
        """Whether the surfaces of a pair touch, shape (rows,)."""

    @property
    def pieces(self) -> list[np.ndarray]:
        """Pieces of the inputs at the rows, (rows, npieces); none without inputs."""

    def held(self) -> np.ndarray:
        """Forces that hold the constraints, shape (rows, nl)."""

    def supplied(self) -> np.ndarray:
        """Forces of the drives, and reactions that loads depend on, shape (rows, n)."""

    def __getitem__(self, name: str) -> np.ndarray:
        """A history, shape (rows,)."""


class Reading(NamedTuple):
    """Row of the table READINGS: name, SI unit, meaning; the function, and which of its results has it."""

    name: str
    unit: str
    meaning: str
    function: str
    result: int


@dataclass(frozen=True)
class Readings:
    """Module of a model's readings, and its rows by name."""

    module: ModuleType
    rows: Mapping[str, Reading]

    def together(self, reading: Reading) -> list[Reading]:
        """Readings that are evaluated with one, in order."""
        return [row for row in self.rows.values() if (row.function, row.result) == (reading.function, reading.result)]


@per_model
def readings_of(model: EngineModel) -> Readings:
    """Derive the readings of a model; raises InputError for one without its scene."""
    module = model.reading_module()
    states = (*model.coordinates, *model.speeds, *model.memory)
    if (module.STATES, tuple(name for name, _ in module.PARAMETERS)) != (states, tuple(model.parameters)):
        fault = Fault("readings", "a scene with other states than the model", "the scene that the model was made of",
                      "load it anew; a built-in one by `hertzwerk derive NAME`")  # fmt: skip
        raise InputError(model.name, [fault])
    return Readings(module, {row[0]: Reading(*row) for row in module.READINGS})


class Units(dict[str, str]):
    """SI unit text of histories by name: those of every run are listed, readings found on request."""

    def __init__(self, listed: Mapping[str, str], model: EngineModel) -> None:
        super().__init__(listed)
        self._model = model

    def __missing__(self, name: str) -> str:
        rows = readings_of(self._model).rows if self._model.reads else {}
        if name not in rows:
            raise KeyError(name)
        return rows[name].unit

    def __contains__(self, name: object) -> bool:
        if super().__contains__(name):
            return True
        return isinstance(name, str) and self._model.reads and name in readings_of(self._model).rows

    def lists(self, name: str) -> bool:
        """Whether a name is one of those of every run."""
        return super().__contains__(name)

    def get(self, name: str, default: Any = None) -> Any:
        """Return the unit of a name, or else the default."""
        try:
            return self[name]
        except KeyError:
            return default

    def text_behind(self, names: Iterable[str]) -> str:
        """Text that the readings among these names are computed by; empty where there is none."""
        read = any(not self.lists(name) and name in self for name in names)
        return text_of(readings_of(self._model).module) if read else ""

    @property
    def missing(self) -> str:
        """Remark on readings that a model without its scene does not have; else empty."""
        if self._model.reads:
            return ""
        return (
            "; motions of bodies, joint reactions and other readings are derived from the scene, a model without its scene has none: "
            f"load the scene, of {getattr(self._model.module, 'SOURCE', '') or 'its file'}, and simulate, "
            "or name readings before a run is saved, run.with_histories(NAME, ...)"
        )

    @property
    def everything(self) -> tuple[str, ...]:
        """Names of all, readings included."""
        rows = readings_of(self._model).rows if self._model.reads else {}
        return tuple(dict.fromkeys((*self, *rows)))


def evaluate(history: Rows, name: str) -> dict[str, np.ndarray]:
    """Return a reading over the rows of a history, and those that come with it."""
    readings = readings_of(history.model)
    reading = readings.rows[name]
    together = readings.together(reading)
    columns = _of_contact(history, reading) if reading.function == CONTACTS else _of_motion(history, readings, reading)
    return {row.name: column for row, column in zip(together, columns.T, strict=True)}


def _of_contact(history: Rows, reading: Reading) -> np.ndarray:
    """Return readings of one contact; while its surfaces are apart they are 0, and its point is nowhere."""
    model = history.model
    columns = _mapped(
        history, reading, {**_states(history), "m": history.part("m"), "friction": history.part("friction")}
    )
    apart = ~history.touches(reading.result)  # contacts are the results, in the order of the pairs
    points = [".point_" in row.name for row in readings_of(model).together(reading)]
    return np.where(apart[:, None], np.where(points, np.nan, 0.0), columns)


def _of_motion(history: Rows, readings: Readings, reading: Reading) -> np.ndarray:
    model, rows = history.model, len(history.rows)
    nq, nu, supplied = model.nq, model.nu, model.function("accelerations").size1_out(1)
    touching = [np.nan_to_num(history[name]) for name in readings.module.TOUCHING]
    values = {
        **_states(history),
        "a": history.part("dy")[:, nq : nq + nu],
        "touching": np.stack(touching, axis=1) if touching else np.zeros((rows, 0)),
        "multipliers": history.held() if model.nl else np.zeros((rows, 0)),
        "reactions": history.supplied() if model.has_function("loads") else np.zeros((rows, supplied)),
    }
    return _mapped(history, reading, values)


def _states(history: Rows) -> dict[str, np.ndarray]:
    model, y = history.model, history.part("y")
    nq, nu = model.nq, model.nu
    return {"t": history.part("t"), "q": y[:, :nq], "u": y[:, nq : nq + nu], "z": y[:, nq + nu :]}


def _mapped(history: Rows, reading: Reading, values: Mapping[str, np.ndarray]) -> np.ndarray:
    if history.p is None:
        raise ValueError("readings need the parameters of a run; these rows belong to none")
    names = ARGUMENTS[reading.function].split()[:-1]
    (constants,) = _constants(history.model)(history.p)
    (result,) = _function(history.model, reading.function, reading.result)(
        constants, *(values[name] for name in names), *history.pieces
    )
    return result


@per_model
def _constants(model: EngineModel) -> Callable[..., list[np.ndarray]]:
    p = ca.SX.sym("p", len(model.parameters))
    function = ca.Function("constants", [p], [ca.densify(readings_of(model).module.constants(p))])
    return lambda values: [np.array(function(values)).ravel()]


@per_model
def _function(model: EngineModel, name: str, result: int) -> Rowwise:
    """Return one result of a function: what else the function has is not computed."""
    module = readings_of(model).module
    sizes = {
        **{"t": 1, "q": model.nq, "u": model.nu, "z": model.nz, "m": model.nm, "a": model.nu},
        **{"friction": model.ns, "touching": len(module.TOUCHING), "multipliers": model.nl, "c": len(module.CONSTANTS)},
    }
    sizes["reactions"] = model.function("accelerations").size1_out(1)
    symbols = [ca.SX.sym(part, sizes[part]) for part in ARGUMENTS[name].split()]
    results = getattr(module, name)(*symbols)
    column = results[result] if isinstance(results, tuple) else results
    function = ca.Function(f"{name}_{result}", symbols, [ca.cse(ca.densify(ca.SX(column)))])
    constant = len(symbols) - 1
    return Rowwise(model.with_pieces(function, constant), constant=constant)
