"""Histories of a run by name, at its rows and between them: states, outputs, contacts, energies."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import MappingProxyType

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, similar, unknown
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
from hertzwerk.runtime.engine.integration.loop.near_list import Departures
from hertzwerk.runtime.engine.integration.loop.near_rows import NearRows, places
from hertzwerk.runtime.engine.integration.loop.reduced_rows import Rows
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import APART, NearModel
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts, contact_classes, contacts_at
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, ENERGY_PARTS, FLIGHT
from hertzwerk.runtime.engine.integration.step.set_valued_friction import grips_of, groups_of, turns
from hertzwerk.runtime.engine.model.binding import si_of_all, times_within
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.derived_histories import Units, evaluate
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.system.lazy import cached_property

_HELD_BY = {  # ending of a constraint's name -> that of the force which holds it
    **{"apart": "force", "off": "force", "turned": "moment", "gap": "normal_force"},
    **{"sliding_velocity": "friction_force", "side_velocity": "side_force", "rate": "force"},
}
FLIES_OR_NOT: tuple[Contacts, ...] = (), BY_MODE  # classes between rows: of each contact alone there would be many
COMPARED = "t", "y", "dy", "force", "force_rate"  # parts of the rows by which two runs are compared
_PAIR = {"mode": "1", "gap": "m", "gap_rate": "m/s", "penetration": "m", "normal_force": "N"}


class Histories(Mapping[str, np.ndarray]):
    """Mapping from names to histories, compared by identity; `[name, "mm"]` is one in another unit."""

    @property
    @abstractmethod
    def units(self) -> Mapping[str, str]:
        """SI unit text of "t" and of every name."""

    def __iter__(self) -> Iterator[str]:
        """Iterate over every name except "t", without readings that are not listed."""
        return (name for name in self.units if name != "t")

    def __len__(self) -> int:
        return len(self.units) - 1

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and name in self.units

    __eq__ = object.__eq__
    __hash__ = object.__hash__


class History(Histories):
    """Histories over `t`, in SI; `history[name]` has shape (rows,), `history[name, "mm"]` is converted.

    rows: states of the engine, shape (rows, ns), as `layout` names them. steps: whether each row is one accepted step
    after the row before, so that the steps between can be interpolated. p: the parameters in SI, which readings need.
    beside: readings that are listed among the names, and written with them. departures: what pairs had that left a list of
    near ones.
    """

    def __init__(
        self,
        model: EngineModel,
        rows: Rows,
        controls: np.ndarray,
        integrator: Integrator | None,
        *,
        steps: bool = True,
        p: np.ndarray | None = None,
        beside: tuple[str, ...] = (),
        departures: Departures | None = None,
    ) -> None:
        self.model = model
        self.rows, self.controls, self.integrator = rows, controls, integrator
        self.steps = steps and integrator is not None
        self.p, self.beside = p, beside
        self.departures: Departures = {} if departures is None else departures
        self.rates: dict[str, np.ndarray] = {}  # of a saved run, by which it is known between its steps
        self._values: dict[str, np.ndarray] = {}

    @classmethod
    def stored(
        cls,
        model: EngineModel,
        histories: Mapping[str, np.ndarray],
        rates: Mapping[str, np.ndarray] = MappingProxyType({}),
    ) -> History:
        """Restore saved histories, with rates where they are those of steps; there are no rows behind them."""
        history = cls(model, np.zeros((0, 0)), np.zeros(0), None)
        history._values, history.rates = dict(histories), dict(rates)
        return history

    def with_model(self, model: EngineModel) -> History:
        """Return saved histories with the model that they are of."""
        return History.stored(model, self._values, self.rates)

    @cached_property
    def units(self) -> Units:
        """SI unit text of "t" and of every name, in their order; of readings when requested."""
        units = units_of(self.model, tuple(self._values) if self.integrator is None else None)
        return Units({**units, **{name: units[name] for name in self.beside}}, self.model)

    def __repr__(self) -> str:
        span = f", {self.t[0]:g} to {self.t[-1]:g} s" if len(self.t) else ""
        return f"<History {self.model.name}: {len(self)} names over {len(self.t)} times{span}>"

    @property
    def t(self) -> np.ndarray:
        """Times [s], shape (rows,)."""
        return self["t"] if self.integrator is None else self.part("t")[:, 0]

    def __getitem__(self, name: str | tuple[str, str]) -> np.ndarray:
        if isinstance(name, tuple) and list(map(type, name)) == [str, str]:
            values = self[name[0]]
            converted: np.ndarray = values / si_of_all(f"{name[0]} in {name[1]}", self.units[name[0]], (1.0, name[1]))
            return converted
        known = self.known(name)
        if known not in self._values:
            self._values |= self._evaluate(known)
        return self._values[known]

    def known(self, name: object) -> str:
        """Return the name of a history; raises KeyError, with what there is, for any other."""
        if isinstance(name, str) and name in self.units:
            return name
        names = self.units.everything
        hint = (similar(name, names) if isinstance(name, str) else "") or f"there are {', '.join(names)}"
        raise KeyError(f"no history {name!r}; {hint}{self.units.missing}")

    def part(self, name: str) -> np.ndarray:
        """Columns of a part of the rows, shape (rows, size); of pairs those of all."""
        if self.near is not None:
            return self.near.part(name)
        return self.rows[:, self.columns(name)]

    @cached_property
    def near(self) -> NearRows | None:
        """The rows by pair, where they have a list of near ones."""
        model = None if self.integrator is None else self.integrator.model
        if not isinstance(model, NearModel):
            return None
        return NearRows(model, self.engine.layouts.state, np.asarray(self.rows), self.departures)

    def of_pair(self, name: str, pair: int) -> np.ndarray:
        """Return the column of a pair in a part that has one for each, shape (rows,)."""
        if self.near is not None:
            return self.near.column(name, pair)
        return self.rows[:, self.columns(name).start + pair]

    def memory(self, row: int) -> np.ndarray:
        """Return a row of memory, shape (rows,)."""
        if self.near is not None:
            return self.near.memory(row)
        return self.rows[:, self.columns("y").start + self.model.nq + self.model.nu + row]

    def latch(self, row: int, pair: int) -> np.ndarray:
        """Return a row of what is latched, that is of a pair, shape (rows,)."""
        if self.near is not None:
            return self.near.latch(row, pair)
        return self.rows[:, self.columns("m").start + row]

    def places(self, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        """Return the places of pairs (n,) in the parts of these rows (n, ns) of the engine."""
        if not isinstance(self.engine.model, NearModel):
            return pairs
        return places(self.engine.model, rows[:, self.columns("pieces")], pairs)

    def busy(self) -> list[int]:
        """Return the pairs that are not in flight at some row."""
        if self.near is not None:
            return self.near.busy()
        return np.flatnonzero(np.any(self.part("mode") != FLIGHT, axis=0)).tolist()

    def columns(self, name: str) -> slice:
        """Return the columns of a part in a row."""
        return self.engine.layouts.state[name]

    @property
    def engine(self) -> Integrator:
        """Functions that the rows came from."""
        if self.integrator is None:
            raise ValueError("a saved run has histories but not the rows and functions they came from; simulate again")
        return self.integrator

    def _evaluate(self, name: str) -> dict[str, np.ndarray]:
        """Return the history of a name, and those that come with it."""
        model = self.model
        if not units_of(model, None).lists(name):
            return evaluate(self, name)
        ny = [*model.coordinates, *model.speeds, *model.memory]
        if name == "t":
            return {name: self.part("t")[:, 0]}
        if name in ny and self.near is not None:
            i = ny.index(name)
            moving = model.nq + model.nu
            return {name: self.rows[:, self.columns("y").start + i] if i < moving else self.near.memory(i - moving)}
        if name in ny:
            return dict(zip(ny, self.part("y").T, strict=True))
        if name in model.outputs:
            return dict(zip(model.outputs, self.map("outputs", "t q u")[0].T, strict=True))
        if name in model.latches:
            row = model.latches.index(name)
            return {name: self.latch(row, model.module.LATCHES[row][2])}
        for i, (slip, *_) in enumerate(model.slips):
            if name == slip:
                return {name: self.part("m")[:, len(model.latches) + i]}
            if name == friction_force(slip):
                return {name: self.part("friction")[:, i]}
        for slip, both in _in_two_directions(model).items():
            if name == slip:
                slips = self.part("m")[:, len(model.latches) :][:, both]
                return {name: np.any(slips != 0, axis=1).astype(float)}
            if name == friction_force(slip):
                return {name: -np.hypot(*self.part("friction")[:, both[:2]].T)}  # against the sliding velocity
        if name in model.constraints:
            value, rate = self.map("constraints", "t q u")  # of a constraint on a speed the value is zero
            return dict(zip(model.constraints, (value + model.on_speeds * rate).T, strict=True))
        of_constraints = [constraint_force(constraint) for constraint in model.constraints]
        if name in of_constraints:
            return dict(zip(of_constraints, self.held().T, strict=True))
        if name == "energy":
            return {name: np.sum(self.energies, axis=0)}
        for speed in model.speeds:
            if name == acceleration_of(speed):
                return {name: self.part("dy")[:, ny.index(speed)]}
        pair, _, part = name.rpartition(".")
        return {name: self._of_pair(pair, part, model.pairs.index(pair))}

    @property
    def energies(self) -> np.ndarray:
        """Kinetic and potential energy [J], springs and touching surfaces included, shape (2, rows)."""
        return np.hstack([self.part(name) for name in ENERGY_PARTS]).T

    def _of_pair(self, pair: str, part: str, j: int) -> np.ndarray:
        mode = self.of_pair("mode", j)
        if part in ("gap", "gap_rate"):
            passed_over = self.near or np.any(self.of_pair("gap", j) == APART)
            values = self._event_function(j)[part == "gap_rate"] if passed_over else self.of_pair(part, j)
            return self._gap(pair, values) if part == "gap" else values
        if part == "penetration":
            return np.where(mode != FLIGHT, np.maximum(-self[f"{pair}.gap"], 0), 0)
        if part == "sliding_velocity":
            velocity = self.map(f"contact_{pair}", "t q u z m")[3]
            along = velocity[:, 0] if velocity.shape[1] == 1 else np.hypot(*velocity.T)
            return np.where(mode == CONTACT, along, 0)  # apart, the direction of contact may not exist
        return self.of_pair({"normal_force": "force"}.get(part, part), j)

    def _event_function(self, j: int) -> list[np.ndarray]:
        """Return the gap of a pair and its rate, listed or not."""
        y, nq, nu = self.rows[:, self.columns("y")], self.model.nq, self.model.nu
        tables = (self.rows[:, self.columns("t")], y[:, :nq], y[:, nq : nq + nu])
        return [x[:, 0] for x in _gap_of(self.model, j)(self.controls[: self.model.nc], *tables)]

    def _gap(self, pair: str, event: np.ndarray) -> np.ndarray:
        """Return the distance [m] of the surfaces from the event function G.

        They are the same but for a pin in a bush: there G = (c^2 - e^2)/(2 c), the distance c - e to first order
        only; c follows from G and e.
        """
        eccentricity = [self[self.model.outputs[i]] for i in self.model.journals.get(pair, ())]
        if not eccentricity:
            return event
        squared = sum(part * part for part in eccentricity)
        distance: np.ndarray = event + np.sqrt(event * event + squared) - np.sqrt(squared)
        return distance

    def map(self, function: str, arguments: str) -> list[np.ndarray]:
        """Evaluate a model's function over all rows, its last argument c constant.

        Each result has shape (rows, size).
        """
        model = self.model
        y, nq, nu = self.part("y"), model.nq, model.nu
        known = {
            "t": self.part("t"),
            "q": y[:, :nq],
            "u": y[:, nq : nq + nu],
            "z": y[:, nq + nu :],
            "m": self.part("m"),
        }
        names = arguments.split()
        # c comes first
        tables = [*(known[name] for name in names), *self.pieces]
        return rowwise(model, function, len(names))(self.controls[: model.nc], *tables)

    @property
    def pieces(self) -> list[np.ndarray]:
        """Pieces of the inputs at the rows (rows, npieces), for `Model.with_pieces`; none without inputs."""
        return [self.part("pieces")] if self.model.inputs else []

    def output_rates(self) -> np.ndarray:
        """Return the time derivatives of the outputs, shape (rows, outputs)."""
        model, moving = self.model, slice(0, self.model.nq + self.model.nu)
        tables = (self.part("t"), self.part("y")[:, moving], self.part("dy")[:, moving])
        return _output_rates(model)(self.controls[: model.nc], *tables, *self.pieces)[0]

    def touches(self, pair: int) -> np.ndarray:
        """Return whether the surfaces of a pair touch, shape (rows,)."""
        touching: np.ndarray = self.of_pair("mode", pair) == CONTACT
        return touching

    def held(self) -> np.ndarray:
        """Return the forces that hold the constraints, shape (rows, nl)."""
        return self._holding[0]

    def supplied(self) -> np.ndarray:
        """Return the forces of the drives, and reactions that loads depend on, shape (rows, n)."""
        return self._holding[1]

    def margins(self) -> np.ndarray:
        """Return margins of uniqueness of reactions that loads read, shape (rows, n): 0 or less where lost."""
        parts = (self.part(part) for part in ("t", "y", "mode", "m"))
        return _settling(self.model)(self.controls[: self.model.nc], *parts, *self.pieces)[0]

    @property
    def _holding(self) -> list[np.ndarray]:
        parts = (self.part(part) for part in ("t", "y", "mode", "m"))
        return _constraint_forces(self.model)(self.controls[: self.model.nc], *parts, *self.pieces)

    def at(self, times: np.ndarray, *, compared: bool = False) -> History:
        """Return histories at other times [s] within the run; at an event, the state just after it.

        compared    see `between`
        """
        t = self.part("t")[:, 0]
        if not self.steps:
            return self._rows_at(times)
        times = times_within(times, t[0], t[-1])
        index = t.searchsorted(times, side="right") - 1
        history = self.between(index, times - t[index], compared=compared)
        history.part("t")[:, 0] = times  # not t + (time - t), which may differ in the last digit
        return history

    def _rows_at(self, times: np.ndarray) -> History:
        """Return the rows at times [s] that are among them."""
        index = np.searchsorted(self.t, times)
        if times.ndim != 1 or np.any(index == len(self.t)) or np.any(self.t[index] != times):
            raise ValueError(
                "found times between the rows of a run that did not keep its steps; expected times among run.t, "
                "or name them before: simulate(..., grid=times), or none (grid=None), after which any time can be requested"
            )
        return self.of(self.rows[index])

    def between(self, index: np.ndarray, h: np.ndarray, *, compared: bool = False) -> History:
        """Return histories a time h (n,) [s] after the rows `index` (n,), under those rows' modes.

        With h = 0 the rows themselves. Behind a singular position that a step passes over, they are found from its end:
        a step from its start would evaluate there.

        compared    compute only the parts COMPARED; others are those of the rows
        """
        rows = self.later(self.rows[index], h, compared=compared)
        if self.model.nl:
            behind = np.flatnonzero(h > self.rows[index][:, self.columns("ahead")][:, 0])
            after = self.rows[index[behind] + 1]
            for part in ("mode", "m", "method"):  # that were those of the step, and may have changed at its end
                after[:, self.columns(part)] = rows[behind][:, self.columns(part)]
            to = _columns(self.model, self.engine, self.engine.layouts.shared)
            back = self.t[index[behind]] + h[behind] - self.t[index[behind] + 1]
            rows[behind[:, None], to] = self.later(after, back, compared=compared)[:, to]
        return self.of(rows)

    def later(self, rows: np.ndarray, h: np.ndarray, *, compared: bool = False) -> np.ndarray:
        """Return rows (n, ns) a time h (n,) [s] after others, by a step of length h from each.

        Of the method's order, under that row's modes. compared: see `between`.
        """
        later: np.ndarray = rows.copy()
        moving = np.flatnonzero(h)
        if not len(moving):
            return later
        before, model = rows[moving], self.engine.model
        mode, parts, classes = before[:, self.columns("mode")], self.engine.layouts.shared, FLIES_OR_NOT
        places = (mode != FLIGHT).any(axis=1)
        if compared:
            parts, classes, places = COMPARED, contact_classes(model), contacts_at(model, mode)

        def step(model: EngineModel, engine: Integrator, number: int) -> Rowwise:
            return part_of_step(model, engine, number, classes, parts)

        values = self.by_method(step, before, h[moving, None], classes=(len(classes), places))
        later[moving[:, None], _columns(self.model, self.engine, parts)] = values
        return later

    def by_method(
        self,
        function: Callable[[EngineModel, Integrator, int], Rowwise],
        rows: np.ndarray,
        *tables: np.ndarray,
        controls: np.ndarray | None = None,
        classes: tuple[int, np.ndarray | int] = (1, 0),
    ) -> np.ndarray:
        """Return results (n, size) of a function of rows (n, ns), each by that row's method.

        function    returns (controls, state, *tables) -> result for a method
        controls    of each row (n, size), for rows of several runs; else those of this one
        classes    number of classes of contacts of each method, and the class of each row: the function's number counts both
        """
        count, places = classes
        methods = rows[:, self.columns("method")][:, 0] * count + places
        if (methods == methods[:1]).all():
            constants = self.controls if controls is None else controls
            return function(self.model, self.engine, int(methods[0]))(constants, rows, *tables)[0]
        order, parts = np.argsort(methods, kind="stable"), []
        for method in sorted(set(methods.tolist())):  # np.unique would import what takes as long as 20 short runs
            here = methods == method
            evaluate = function(self.model, self.engine, int(method))
            constants = self.controls if controls is None else controls[here]
            parts += evaluate(constants, rows[here], *(table[here] for table in tables))
        joined = np.concatenate(parts)
        ordered = np.empty_like(joined)
        ordered[order] = joined
        return ordered

    def of(self, rows: Rows) -> History:
        """Return histories over other rows (n, ns) of the same run."""
        return self._with(rows, self.beside, steps=False)

    def with_names(self, names: Iterable[str]) -> History:
        """Return the same histories with readings listed among them; raises KeyError for an unknown name."""
        readings = [name for name in names if not isinstance(name, str) or not self.units.lists(name)]
        for name in readings:
            self[name]
        readings = list(dict.fromkeys(readings))
        if not readings:
            return self
        return self._with(self.rows, (*self.beside, *readings), steps=self.steps)

    def _with(self, rows: Rows, beside: tuple[str, ...], *, steps: bool) -> History:
        """Return histories of the same run over some rows."""
        run = self.model, rows, self.controls, self.integrator
        return History(*run, steps=steps, p=self.p, beside=beside, departures=self.departures)


@per_model
def units_of(model: EngineModel, stored: tuple[str, ...] | None) -> Units:
    """Return the SI unit text by name; `stored`: names of a saved run, None where there are functions."""
    units = {"t": "s", **model.units}
    for name in model.speeds:
        units[acceleration_of(name)] = f"{model.units[name]}^2"  # m/s^2, rad/s^2
    units |= {row[0]: row[1] for row in (*model.module.OUTPUTS, *model.module.LATCHES, *model.slips)}
    for name in (*(slip for slip, *_ in model.slips), *_in_two_directions(model)):
        units |= {friction_force(name): "N m" if turns(name) else "N", name: units.get(name, "1")}
    first = {row[0]: rows[0][0] for _, rows in model.module.FAMILIES for row in rows}  # of its kind
    for pair in model.pairs:
        units |= {f"{pair}.{part}": unit for part, unit in _PAIR.items()}
        slides = f"{pair}.sliding_velocity"  # there is one only where something depends on it
        if model.function(f"contact_{first.get(pair, pair)}").size1_out(3) if stored is None else slides in stored:
            units[slides] = "m/s"
    if model.has_ledger:
        units["energy"] = "J"
    for name, unit in model.module.CONSTRAINTS:
        units |= {name: unit, constraint_force(name): "N m" if unit == "1" else "N"}
    units |= {name: unit for name, unit, _ in getattr(model.module, "BESIDE", ())}  # readings of a saved run
    return Units(units, model)


def unknown_histories(model: EngineModel, names: Iterable[str]) -> list[Fault]:
    """Return the faults of names that no history of a model has, readings included."""
    units = units_of(model, None)
    return [unknown("history", name, units.everything) for name in names if name not in units]


@per_model
def rowwise(model: EngineModel, function: str, constant: int) -> Rowwise:
    """Return a model's function of a state and, as the last argument, c; that one is constant."""
    return Rowwise(model.with_pieces(model.function(function), constant), constant=constant)


@per_model
def _gap_of(model: EngineModel, j: int) -> Rowwise:
    arguments = model.symbols("t q u c")
    gap = [x[j] for x in model.function("gaps").call(arguments)]
    return Rowwise(ca.Function("gap_of", arguments, gap), constant=3)


@per_model
def _constraint_forces(model: EngineModel) -> Rowwise:
    return Rowwise(model.with_pieces(flow(model).holding, 4), constant=4)


@per_model
def _settling(model: EngineModel) -> Rowwise:
    return Rowwise(model.with_pieces(flow(model).settling, 4), constant=4)


@per_model
def _output_rates(model: EngineModel) -> Rowwise:
    t, q, u, c = model.symbols("t q u c")
    x, at, moves = ca.vertcat(q, u), *(ca.SX.sym(name, model.nq + model.nu) for name in ("x", "moves"))
    rates = ca.jtimes(model.function("outputs")(t, q, u, c), ca.vertcat(t, q, u), ca.vertcat(1, moves))
    function = ca.Function("output_rates", [t, at, moves, c], [ca.substitute(ca.densify(rates), x, at)])
    return Rowwise(model.with_pieces(function, 3), constant=3)


@per_model
def part_of_step(
    _: EngineModel, integrator: Integrator, number: int, classes: tuple[Contacts, ...], parts: tuple[str, ...]
) -> Rowwise:
    """Return the function (state, controls, h) -> parts of a step.

    The number counts the classes of contacts of one method after another.
    """
    method, contacts = divmod(number, len(classes))
    return Rowwise(integrator.step(method, classes[contacts], parts), constant=1)


def steps_of(model: EngineModel, integrator: Integrator, method: int, *, compared: bool = False) -> list[Rowwise]:
    """Return the functions that interpolate a method's steps, or states for a comparison of runs."""
    classes, parts = FLIES_OR_NOT, integrator.layouts.shared
    if compared:
        classes, parts = contact_classes(integrator.model), COMPARED
    count = len(classes)
    return [part_of_step(model, integrator, method * count + i, classes, parts) for i in range(count)]


@per_model
def _columns(_: EngineModel, integrator: Integrator, parts: tuple[str, ...]) -> np.ndarray:
    """Return the columns of parts in a row."""
    state = integrator.layouts.state
    return np.concatenate([np.arange(state.size)[state[part]] for part in parts])


def friction_force(slip: str) -> str:
    """Name the friction force of a slip: `floor.slip_1` -> `floor.friction_force_1`.

    Of a turning the moment: `rolling.turning` -> `rolling.moment`.
    """
    grip, _, name = slip.rpartition(".")
    return f"{grip}.{name.replace('slip', 'friction_force').replace('turning', 'moment')}"


def _in_two_directions(model: EngineModel) -> dict[str, list[int]]:
    """Return the slips of each grip in two directions, by their common name: `floor.slip`."""
    groups = groups_of(grips_of(model))
    return {model.slips[group[0]][0].rpartition("_")[0]: group for group in groups if len(group) > 1}


def constraint_force(constraint: str) -> str:
    """Name the force that holds a constraint.

    `pin.apart_x` -> `pin.force_x`, `pin.off_y` -> `pin.force_y`, `pin.turned_x` -> `pin.moment_x`; of a coupling
    `mesh.turned` -> `mesh.moment`, `rack.off` -> `rack.force`; of what rolls `tyre.gap` -> `tyre.normal_force`,
    `tyre.sliding_velocity_1` -> `tyre.friction_force_1`; of an edge `skate.side_velocity` -> `skate.side_force`.
    """
    whose, _, name = constraint.rpartition(".")
    kind = next(kind for kind in _HELD_BY if name.startswith(kind))
    return f"{whose}.{_HELD_BY[kind]}{name.removeprefix(kind)}"


def acceleration_of(speed: str) -> str:
    """Name the rate of a speed: `pin.speed` -> `pin.acceleration`."""
    joint, _, name = speed.rpartition(".")
    return f"{joint}.{name.replace('speed', 'acceleration')}"
