"""Models of SymPy's mechanics as scenes.

    model = from_sympy(kane, units={m: "kg", l: "m", q: "rad"}, parameters={m: 1, l: 0.3}, origin=O)
    scene = model.scene(pairs=(SphereOnPlane("wall", sphere=model.at(P), ...),), effects=(Contact("wall", ...),), scales=...)

Equations are taken as SymPy built them, as a straight-line program of what they share. Nothing is simplified, no
matrix inverted. Every expression is audited for units, the author's own first.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from typing import Any, ClassVar

import sympy as sp
from mpmath import mp

from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.common.faults import Fault, InputError, among, refuse, shown, unknown
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.declare.effects.effect import Declared, Effect, Element
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.state_expression import COORDINATE, Input, T, Varying, states_in
from hertzwerk.derive.declare.mechanism.bodies import Body, Point
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.exchange.sympy_models.kinematics_audit import kinematic_faults
from hertzwerk.derive.exchange.sympy_models.mechanism_by_expressions import (
    Condition,
    Description,
    Linear,
    MechanismByExpressions,
    Placed,
)
from hertzwerk.derive.exchange.sympy_models.model_equations import (
    Reading,
    connected,
    frames_of,
    mass_centre,
    points_of,
    reading_of,
)
from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME
from hertzwerk.derive.exchange.sympy_models.translation import METRE, SECOND, Naming, name_of
from hertzwerk.derive.exchange.sympy_models.unit_audit import unit_faults
from hertzwerk.derive.expressions.algebra.vectors import IDENTITY, ZERO
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.walker import dimension_of
from hertzwerk.derive.expressions.parameter import Parameter, Slot

STILL: Linear = ({}, sp.S.Zero)


def from_sympy(
    method: Any, *, units: Mapping[Any, str], parameters: Mapping[Any, float], name: str = "model", origin: Any = None,
    specified: Mapping[Any, Any] | None = None, kinematics: str = "audited",
) -> Model:  # fmt: skip
    """Model of SymPy's KanesMethod, LagrangesMethod or System after its equations are formed.

    Raises InputError, listing every fault, for symbols without unit or value, for expressions whose units part, and for
    velocities that were set and do not follow from positions and axes.

    units      unit of every symbol, coordinate and function of time, and of speeds that are no derivatives, by symbol or name
    parameters    value of every constant symbol in its unit; a run may set it anew
    origin     fixed point from which positions are known; without one nothing has a place, and no pair may touch
    specified  functions of time that are neither coordinates nor speeds: expressions of `T`, or an `Input`; of loads
               also of coordinates, speeds and states
    kinematics  "audited", or "as given": velocities that do not follow are taken as they were set, and the generated
                module, solutions and pictures name them
    """
    if kinematics not in ("audited", "as given"):
        raise InputError(f"from_sympy, {name}", [Fault("kinematics", shown(kinematics), '"audited" or "as given"')])
    reading = reading_of(method, origin)
    naming = Naming(reading, _expressions(reading), units, parameters, specified or {})
    return Model(reading, name, naming, as_given=kinematics == "as given")


class Model:
    """Model that was imported: its parameters by name, points of its bodies, and scenes of it."""

    def __init__(self, reading: Reading, name: str, naming: Naming, as_given: bool) -> None:
        self.name, self._reading = name, reading
        self._points, self._frames = points_of(reading), frames_of(reading)
        self._names = names = naming.names()
        faults = [*name_faults("model", name), *naming.faults]
        faults += unit_faults(reading, names.table) if not faults else []
        wrong = kinematic_faults(reading, names) if not naming.faults else []
        self._contradictions = tuple((f.where, f.found, f.expected) for f in wrong if as_given)
        faults += [] if as_given else wrong
        faults += naming.unused
        faults += [fault for body in reading.bodies for fault in self._orientation_faults(*mass_centre(body))]
        refuse(f"from_sympy, {name}", dict.fromkeys(faults))
        self.parameters: Mapping[str, Parameter] = names.parameters
        """The constants by name, for use in pairs and effects."""
        self._bodies: dict[str, tuple[Body, Placed]] = {}
        self._linear = cache(self._find_linear)
        self.bodies: tuple[Body, ...] = tuple(self._body(body) for body in reading.bodies)
        """The model's own bodies."""

    def at(self, point: Any, frame: Any = None) -> Point:
        """Point of the model, as pairs and effects take it, by itself or its name.

        It is fixed in `frame`, which matters where surfaces slide; by default a body's whose mass centre it is, else
        it keeps the axes of the ground. Raises InputError.
        """
        where, axes = self._find(point, self._points, "point"), self._find(frame, self._frames, "frame")
        if self._position(where) is None:
            actual = f"no position{', for there is no' if self._reading.origin is None else ' from the'} origin"
            raise InputError(f"model {self.name}", [Fault(f"point {where.name}", actual, "a position from a fixed point",
                             "Locate it in SymPy, P.set_pos(O, ...), and give from_sympy(..., origin=O).")])  # fmt: skip
        for body, own in zip(self.bodies, self._reading.bodies, strict=True):
            centre, carrier = mass_centre(own)
            if centre == where and axes in (None, carrier):
                return Point(body)
        refuse(f"model {self.name}", [*self._orientation_faults(where, axes)])
        name = where.name if axes is None else f"{where.name}_{axes.name}"
        if name not in self._bodies:
            self._bodies[name] = Body(name, mass=0), self._placed(where, axes)
        return Point(self._bodies[name][0])

    def scene(
        self, *, scales: Scales, pairs: Sequence[Pair] = (), effects: Sequence[Effect] = (), start: Start | None = None,
        summary: str = "",
    ) -> Scene:  # fmt: skip
        """Scene of the model with its loads, and pairs and effects in addition; raises InputError."""
        refuse(f"scene {self.name}", list(ledger_faults(tuple(effects), self._follows_time(), self._reading.alone)))
        used = list(dict.fromkeys([*self.bodies, *_bodies_in((*pairs, *effects))]))
        moved = tuple(body for body in used if body.name in self._bodies and self._bodies[body.name][0] == body)
        mechanism = MechanismByExpressions(
            self.name, (), tuple(pairs), moved=moved, description=self._description(moved)
        )
        return Scene(mechanism, (*self._loads(), *effects), scales, start or Start(), summary=summary)

    # -- bodies and points ---------------------------------------------------------------------------------------------

    def _find(self, item: Any, known: Mapping[str, Any], kind: str) -> Any:
        by = {**known, **{each: each for each in known.values()}, **({None: None} if kind == "frame" else {})}
        if not among(item, *by):
            raise InputError(f"model {self.name}", [unknown(kind, getattr(item, "name", item), known)])
        return by[item]

    def _position(self, point: Any) -> Any:
        """Position of a point from the origin, None where it has none."""
        try:
            return self._reading.origin and point.pos_from(self._reading.origin)
        except ValueError:
            return None

    def _orientation_faults(self, point: Any, frame: Any) -> Iterator[Fault]:
        """Faults of frames without an orientation: of a body, and those in which its velocity is written."""
        ground, velocity = self._reading.frame, self._reading.velocity(point)
        used = [axes for _, axes in velocity.args] if frame is None else [frame, *(axes for _, axes in velocity.args)]
        for each in dict.fromkeys(used):
            if each not in connected([ground], "_dcm_dict"):
                yield Fault(f"frame {each.name}", f"no orientation in {ground.name}", "axes whose directions are known",
                            f"Orient it in SymPy, such as {each.name}.orient_axis({ground.name}, {ground.name}.z, q).")  # fmt: skip

    def _body(self, body: Any) -> Body:
        """A body of SymPy's, its frame at the mass centre."""
        centre, frame = mass_centre(body)
        made = Body(body.name, self._names.of(sp.sympify(body.mass, strict=True)))
        self._bodies[body.name] = made, self._placed(centre, frame)
        return made

    def _placed(self, point: Any, frame: Any) -> Placed:
        reading, of = self._reading, self._names.of
        axes: Any = IDENTITY
        turning: tuple[Linear, Linear, Linear] = (STILL, STILL, STILL)
        if frame is not None:
            matrix = reading.frame.dcm(frame)
            axes = tuple(tuple(of(matrix[i, k]) for k in range(3)) for i in range(3))
            turning = self._linear_vector(frame.ang_vel_in(reading.frame))
        place = self._position(point)
        position = (
            ZERO if place is None else place.to_matrix(reading.frame)
        )  # it may have mass and velocity, and no place
        x, y, z = (of(sp.sympify(value)) for value in position)
        return Placed(axes, (x, y, z), self._linear_vector(reading.velocity(point)), turning)

    def _linear_vector(self, vector: Any) -> tuple[Linear, Linear, Linear]:
        """Components along the ground's axes."""
        components = vector.to_matrix(self._reading.frame) if vector != 0 else ZERO
        x, y, z = map(self._linear, components)
        return x, y, z

    def _find_linear(self, expression: Any) -> Linear:
        """Coefficients of the speeds in an expression that is linear in them, and the rest."""
        reading, names = self._reading, self._names
        expression = expression.xreplace(reading.derivatives)
        shares = {names.keys[u]: names.of(expression.diff(u)) for u in reading.u if expression.has(u)}
        rest = names.of(expression.xreplace(dict.fromkeys(reading.u, sp.S.Zero)))
        return {key: share for key, share in shares.items() if share != 0}, rest

    # -- equations -----------------------------------------------------------------------------------------------------

    def _description(self, moved: Iterable[Body]) -> Description:
        """Everything that a mechanism is given by, with what its expressions share named once."""
        reading, names = self._reading, self._names
        of, rows = names.of, [names.keys[u] for u in reading.u]
        n = range(len(rows))
        mass = {(rows[i], rows[k]): of(reading.mass[i, k]) for i in n for k in n if reading.mass[i, k] != 0}
        whole = (
            {} if names.minimal else {name_of(q): self._linear(rate) for q, rate in reading.rates.items()},
            {body.name: self._bodies[body.name][1] for body in moved},
            mass, dict(zip(rows, map(of, reading.bias), strict=True)), of(reading.potential or sp.S.Zero), self._conditions(),
        )  # fmt: skip
        gathered: list[Any] = []
        _each(whole, gathered.append)
        steps, reduced = sp.cse(gathered, sp.numbered_symbols("step_"), order="none")
        replacements = iter(reduced)
        rates, places, mass, bias, potential, conditions = _each(whole, lambda e: next(replacements))
        quantities = [Slot(f"symbol {p.name}", p, p.unit) for p in names.parameters.values()]
        quantities += [Varying(f"function {name_of(f)}(t)", v, str(names.table[f])) for f, v in names.moving.items()]
        return Description(
            names.freedoms, names.measured, names.uncounted, rates, tuple(steps), places,
            mass, bias, potential, conditions, tuple(quantities), self._contradictions,
        )  # fmt: skip

    def _loads(self) -> tuple[Loads, ...]:
        """The loads, as an effect."""
        reading, names = self._reading, self._names
        units = {port.name: port.unit for freedom in names.freedoms for port in freedom.forces}
        named = [(names.keys[u], names.of(f)) for u, f in zip(reading.u, reading.force, strict=True)]
        forces = tuple((key, units[key], force) for key, force in named if force != 0)
        return (Loads("loads", forces, names.of(reading.stored)),) if forces else ()

    def _conditions(self) -> tuple[Condition, ...]:
        """Constraints, in metres, angles or metres a second: others are scaled by a length."""
        on_places = [(f"holonomic_{n}", e, e.diff(TIME)) for n, e in enumerate(self._reading.holonomic, 1)]
        on_speeds = [(f"nonholonomic_{n}", None, e) for n, e in enumerate(self._independent(), 1)]
        return tuple(self._condition(*each) for each in (*on_places, *on_speeds))

    def _condition(self, name: str, value: Any, rate: Any) -> Condition:
        dimension = dimension_of(rate if value is None else value, self._names.table)
        length = dimension if value is not None else dimension * SECOND
        power = 0 if length.every else length.L
        if length not in (METRE**power, Dimension.from_unit("1")) and not length.every:
            unit = "a length, an angle, or a power of a length" + ("" if value is not None else ", a second")
            raise InputError(
                f"model {self.name}", [Fault(name, f"{rate if value is None else value} [{dimension}]", unit)]
            )
        angle = value is not None and power == 0
        factor = sp.S.One if angle else self._size ** (1 - power)
        shares, rest = self._linear(rate)
        scaled = {key: factor * share for key, share in shares.items()}, factor * rest
        zero = sp.S.Zero if value is None else factor * self._names.of(value)
        unit, label = ("m/s", "rate") if value is None else ("1", "turned") if angle else ("m", "off")
        return Condition(f"{name}.{label}", unit, zero, scaled)

    @property
    def _size(self) -> Any:
        """A length of the model, by which constraints are scaled."""
        lengths = [p for p in self.parameters.values() if Dimension.from_unit(p.unit) == METRE and p.default]
        return lengths[0] if lengths else sp.S.One

    def _independent(self) -> list[Any]:
        """Constraints on speeds that are no rates of those on coordinates, at the values and random states."""
        columns = [self._linear(expression.diff(TIME))[0] for expression in self._reading.holonomic]
        if not self._reading.mixed or not columns:
            return list(self._reading.nonholonomic)

        def follows(expression: Any) -> bool:
            column = self._linear(expression)[0]
            return all(_depends(columns, column, [*self._names.keys.values()], seed) for seed in (1, 2))

        return [expression for expression in self._reading.nonholonomic if not follows(expression)]

    def _follows_time(self) -> bool:
        """Whether the motion itself follows time, so that there is a drive whose force is not known."""
        reading = self._reading
        linear = [self._linear(rate) for rate in reading.rates.values()]
        for _, place in self._bodies.values():
            linear += [*place.velocity, *place.angular_velocity]
        drives = states_in(self._names.of(sp.sympify(reading.lagrangian or 0)))
        return any(symbol == T or isinstance(symbol, Input) for symbol in drives) or any(
            rest != 0 for _, rest in linear
        )


def _expressions(reading: Reading) -> list[Any]:
    """Every expression in which symbols may stand."""
    expressions: list[Any] = [*reading.rates.values(), *reading.mass, *reading.bias, *reading.force]
    expressions += [*reading.holonomic, *reading.nonholonomic, reading.stored, *(body.mass for body in reading.bodies)]
    expressions += [] if reading.lagrangian is None else [reading.lagrangian]
    vectors = [v for _, v in reading.loads]
    for point in points_of(reading).values():
        vectors += point._pos_dict.values()
    for body in reading.bodies:
        vectors.append(reading.velocity(mass_centre(body)[0]))
        expressions += [value for value, *_ in (body.inertia[0].args if hasattr(body, "inertia") else ())]
    for frame in frames_of(reading).values():
        expressions += [entry for matrix in frame._dcm_dict.values() for entry in matrix]
    expressions += [value for vector in vectors if vector != 0 for values, _ in vector.args for value in values]
    return [sp.sympify(value, strict=True) for value in expressions]


def _bodies_in(records: Iterable[Any]) -> list[Body]:
    """Bodies that records refer to."""
    values = [getattr(record, entry.name) for record in records if is_dataclass(record) for entry in fields(record)]
    places = [place for value in values for place in (value if isinstance(value, tuple) else (value,))]
    bodies = (place.body if isinstance(place, Point) else place for place in places)
    return [body for body in bodies if isinstance(body, Body)]


def _each(value: Any, change: Callable[[Any], Any]) -> Any:
    """A nested record with each of its expressions changed, in order."""
    if isinstance(value, Placed):
        return Placed(*(_each(getattr(value, entry.name), change) for entry in fields(value)))
    if isinstance(value, Condition):
        return Condition(value.name, value.unit, _each(value.value, change), _each(value.rate, change))
    if isinstance(value, tuple):
        return tuple(_each(part, change) for part in value)
    if isinstance(value, Mapping):
        return {key: _each(part, change) for key, part in value.items()}
    return change(value)


def _depends(columns: list[Mapping[str, Any]], column: Mapping[str, Any], rows: list[str], seed: int) -> bool:
    """Whether a column is a combination of others, at a random state."""
    source = random.Random(seed)
    symbols = {s for c in (*columns, column) for e in c.values() for s in e.free_symbols}
    state = {s: s.si if isinstance(s, Parameter) else source.uniform(0.1, 1) for s in sorted(symbols, key=str)}
    numbers = [[evaluate(each.get(row, sp.S.Zero), state) for row in rows] for each in (*columns, column)]
    unit = mp.matrix([[value / (mp.norm(row) or 1) for value in row] for row in numbers])
    ranks = [sum(size > 1e-9 for size in mp.svd_r(part, compute_uv=False)) for part in (unit, unit[:-1, :])]
    return bool(ranks[0] == ranks[1])


# -- loads of an imported model: generalised forces, and the power that they put in ------------------------------------


@dataclass(frozen=True)
class Loads(Effect):
    """Generalised forces of loads, each with its row and unit, and the potential energy of some.

    Their power is booked as input, but for what changes that energy.
    """

    name: str
    forces: tuple[tuple[str, str, Any], ...]
    stored: Any = sp.S.Zero
    kind: ClassVar[str] = "loads"

    @property
    def text(self) -> str:
        """Description for people."""
        return "loads of the imported model"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the generalised forces and the energy."""
        yield from (Varying(f"{self.where}, {key}", force, unit) for key, unit, force in self.forces)
        yield Varying(f"{self.where}, stored energy", self.stored, "J", on=(COORDINATE,))

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield a fault of a mechanism that was not imported."""
        if not isinstance(scene.mechanism, MechanismByExpressions):
            yield Fault(self.where, f"mechanism {scene.mechanism.name}", "the imported model that has these loads")

    def element(self, kin: Any) -> Element:
        """Generalised forces, stored energy and power."""
        tape, motion = kin.tape, kin.by_expressions
        forces = {key: tape.let(motion.of(value), f"{self.name}_on_{key}") for key, _, value in self.forces}
        power = sp.Add(*(force * motion.speed(key) for key, force in forces.items()))
        stored = tape.let(motion.of(self.stored), f"{self.name}_stored")
        drawn = tape.rate(stored, f"{self.name}_stored_rate") if stored != 0 else sp.S.Zero
        return Element(forces, stored, input=tape.let(power + drawn, f"{self.name}_power"))


def ledger_faults(effects: tuple[Any, ...], follows_time: bool, alone: bool) -> Iterator[Fault]:
    """Yield faults of an energy ledger beside a motion that follows time, and beside equations alone."""
    if not any(isinstance(effect, EnergyLedger) for effect in effects):
        return
    if alone:
        yield Fault("effects", "an energy ledger beside equations alone", "a model whose loads or potential are known",
                    "Omit it: loads of a KanesMethod or a LagrangesMethod are known.")  # fmt: skip
    elif follows_time:
        yield Fault("effects", "an energy ledger beside a motion that itself follows time",
                    "a motion with a drive: the equations of SymPy do not contain its force",
                    "Make the specified function a coordinate with Drive(..., position=...), or omit the ledger.")  # fmt: skip
