"""Histories as functions of the state, of which derivatives can be taken."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.explicit_step import written_flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, ENERGY_PARTS
from hertzwerk.runtime.engine.model.derived_histories import ARGUMENTS as READ_FROM
from hertzwerk.runtime.engine.model.derived_histories import CONTACTS, Reading, readings_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.sensitivity.tangent import ARGUMENTS
from hertzwerk.runtime.engine.solution.history import acceleration_of, constraint_force, friction_force
from hertzwerk.runtime.engine.solution.impacts import distances, penetrations

OF_PAIR = ("gap", "gap_rate", "penetration", "normal_force", "sliding_velocity")


@dataclass(frozen=True)
class Readout:
    """Builder of the function (t, y, mode, m, c, p) -> value (1) of a history."""

    name: str

    def __call__(self, model: EngineModel) -> Any:
        """Build the function; raises KeyError for an unknown history."""
        arguments = model.symbols(ARGUMENTS)
        value = Expressions(model, arguments)[self.name]
        return ca.Function("readout", arguments, [ca.densify(ca.SX(value))])


class Expressions:
    """Expressions of histories by name, in a state under its modes; KeyError for an unknown one."""

    def __init__(self, model: EngineModel, arguments: list[Any]) -> None:
        self.model = model
        self.t, self.y, self.mode, self.m, self.c, self.p = arguments
        self.q, self.u, self.z = model.parts(self.y)
        self.ends = written_flow(model).at(*arguments[:-1])

    def __getitem__(self, name: str) -> Any:
        model, m = self.model, self.m
        states = [*model.coordinates, *model.speeds, *model.memory]
        memory = [*model.latches, *(slip for slip, *_ in model.slips)]
        if name == "t":
            return self.t
        if name in model.inputs:
            return ca.SX(0)  # it is given, and does not change
        if name in states:
            return self.y[states.index(name)]
        if name in memory:
            return m[memory.index(name)]
        if name == "energy":
            return sum(self.ends[part] for part in ENERGY_PARTS)
        tables: dict[str, tuple[Sequence[str], Callable[[], Any]]] = {
            "outputs": (model.outputs, lambda: model.function("outputs")(*self._place())),
            "friction": ([friction_force(slip) for slip, *_ in model.slips], lambda: self.ends["friction"]),
            "constraints": (model.constraints, self._constraints),
            "held": ([constraint_force(row) for row in model.constraints], self._held),
            "accelerations": ([acceleration_of(speed) for speed in model.speeds], lambda: self.ends["dy"][model.nq :]),
        }
        for names, column in tables.values():
            if name in names:
                return column()[names.index(name)]
        pair, _, part = name.rpartition(".")
        if pair in model.pairs and part in OF_PAIR:
            return self._of_pair(pair, part)
        return self._reading(readings_of(model).rows[name])

    def _constraints(self) -> Any:
        value, rate = self.model.function("constraints").call(self._place())
        return value + self.model.on_speeds * rate

    def _place(self) -> list[Any]:
        return [self.t, self.q, self.u, self.c]

    def _held(self) -> Any:
        return self._holding(0)

    def _holding(self, which: int) -> Any:
        """Forces that hold the constraints (0), or those of drives and reactions that loads depend on (1)."""
        holding: Any = written_flow(self.model).holding
        return holding.call([self.t, self.y, self.mode, self.m, self.c])[which]

    def _of_pair(self, pair: str, part: str) -> Any:
        j, at = self.model.pairs.index(pair), {**self.ends, "t": self.t, "y": self.y}
        if part == "gap":
            return distances(self.model, at, self.c)[j]
        if part == "penetration":
            return penetrations(self.model, at, self.mode, self.c)[j]
        if part == "sliding_velocity":
            value = self.model.function(f"contact_{pair}").call([self.t, self.q, self.u, self.z, self.m, self.c])[3]
            return ca.if_else(self.mode[j] == CONTACT, value, 0)  # apart, the direction of contact may not exist
        return self.ends[{"normal_force": "force"}.get(part, part)][j]

    def _reading(self, reading: Reading) -> Any:
        """Reading; of a contact 0 while its surfaces are apart."""
        model, readings, of_contact = self.model, readings_of(self.model), reading.function == CONTACTS
        constants = readings.module.constants(self.p)
        touching = [] if of_contact else [self._reading(readings.rows[name]) for name in readings.module.TOUCHING]
        values = {
            **{"t": self.t, "q": self.q, "u": self.u, "z": self.z, "m": self.m, "friction": self.ends["friction"]},
            **{"a": self.ends["dy"][model.nq : model.nq + model.nu], "touching": ca.vertcat(ca.SX(0, 1), *touching)},
            "multipliers": self._held() if model.nl else ca.SX(0, 1),
            "reactions": self._holding(1)
            if model.has_function("loads")
            else ca.SX.zeros(model.function("accelerations").size1_out(1)),
            "c": ca.vertcat(
                ca.SX(constants)[: len(readings.module.CONSTANTS) - model.npieces], self.c[model.nc - model.npieces :]
            ),
        }
        results = getattr(readings.module, reading.function)(
            *(values[name] for name in READ_FROM[reading.function].split())
        )
        columns = results[reading.result] if isinstance(results, tuple) else results
        value = columns[[row.name for row in readings.together(reading)].index(reading.name)]
        return ca.if_else(self.mode[reading.result] == CONTACT, value, 0) if of_contact else value
