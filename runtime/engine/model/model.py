"""Model of a generated module: names, units and defaults, CasADi functions, bound parameters."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, unknown
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.common.module_format import without_scene
from hertzwerk.runtime.engine.model.binding import Declared, Port, Value, quantity_text, read_parameters
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.direct_sx import direct
from hertzwerk.runtime.engine.model.generated_text import module_of, require_tables, text_of, with_tables
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.signal import WIDTH, Schedule, Signal
from hertzwerk.runtime.engine.model.undefined_constants import origin
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene
    from hertzwerk.derive.exchange.readable_equations.readable_record import Readable


@dataclass(frozen=True)
class BoundParameters:
    """Numbers for one run: p (np,) and c (nc,) in SI, and each parameter's value in its given unit."""

    p: np.ndarray
    c: np.ndarray
    values: Mapping[str, tuple[float, str]]
    warnings: tuple[str, ...]

    def __getitem__(self, name: str) -> float:
        """SI value of a parameter."""
        return float(self.p[list(self.values).index(name)])


Dependent: TypeAlias = tuple[tuple[int, ...], int]
"""Constraints that imply each other, and how many of them are independent."""

SOLVING = ("accelerations", "settling", "unloaded", "projection")  # functions that solve for the constraint forces


@dataclass(frozen=True)
class Declaration:
    """Origin of a model: a built-in scene's name or a scene, with its variation."""

    target: str | Scene
    without: tuple[str, ...] = ()
    laws: tuple[tuple[str, str], ...] = ()
    coordinates: str | None = None

    def scene(self) -> Scene:
        """Return the scene of the model; raises InputError."""
        from hertzwerk.runtime.engine.model import build

        scene = build.scene_from(self.target) if isinstance(self.target, str) else self.target
        return build.vary(scene, self.without, dict(self.laws), self.coordinates)

    def readings(self, coordinates: str) -> str:
        """Return the text of the module of the scene's readings in these coordinates, derived once."""
        known: dict[str, str] = self.__dict__.setdefault("_readings", {})  # pickled with the model
        if coordinates not in known:
            from hertzwerk.runtime.engine.model import build

            known[coordinates] = build.readings_text(
                self.target,
                self.without,
                dict(self.laws),
                coordinates,
                lambda: self.scene().with_coordinates(coordinates),
            )
        return known[coordinates]


class EngineModel:
    """Model of a scene.

    `declaration` is its origin; a saved run, or a generated module by itself, has none.
    """

    lists: tuple[int, ...] = ()
    """Sizes of the parts of a list of near pairs, which is among the constants as pieces of inputs are; empty without one."""

    def __init__(
        self,
        module: ModuleType | SimpleNamespace,
        declaration: Declaration | None = None,
        dependent: tuple[Dependent, ...] = (),
        signals: Mapping[str, Signal] | None = None,
    ) -> None:
        require_tables(module)
        self.module = module
        self.declaration = declaration
        self.dependent = dependent
        self.signals: Mapping[str, Signal] = {} if signals is None else signals
        """Values of the inputs over time, by name, as a run was given them."""
        self.name: str = module.NAME
        self.parameters: dict[str, Port] = {row[0]: Port(*row) for row in module.PARAMETERS}
        self.coordinates, self.speeds, self.memory, self.latches, self.pairs, self.outputs = (
            tuple(row[0] for row in rows)
            for rows in (module.COORDINATES, module.SPEEDS, module.MEMORY, module.LATCHES, module.PAIRS, module.OUTPUTS)
        )
        self.nq, self.nu, self.nz = len(self.coordinates), len(self.speeds), len(self.memory)
        self.slips: tuple[tuple[str, str, int], ...] = module.SLIPS
        self.ns, self.k, self.nc = len(self.slips), len(self.pairs), len(module.CONSTANTS)
        self.nm = len(self.latches) + self.ns
        self.events: tuple[tuple[str, tuple[int, ...]], ...] = module.EVENTS
        """Events of effects, by name, and the rows of q that each changes."""
        self.ne = len(self.events)
        self.loads: tuple[str, ...] = module.LOADS
        """Reactions that loads depend on; empty without such loads."""
        self.carried: tuple[int, ...] = module.FED
        """Places of magnitudes among the reactions, of loads that set-valued friction changes and depends on."""
        self.rubbing: tuple[tuple[str, int, int, int], ...] = module.RUBBING
        """Set-valued frictions of joints: places of coefficient and holding force among the forces, of the former among the reactions."""
        self.fed = bool(self.carried or self.rubbing)
        """Whether set-valued friction changes loads that it depends on."""
        self.nr = self.k + bool(self.loads or self.rubbing)
        """Number of ranges that a run must not leave: of each pair's law, and of loads by reactions."""
        rows: dict[str, list[int]] = {}
        for i, name in enumerate(self.outputs):
            pair, _, part = name.rpartition(".")
            if part.startswith("eccentricity_"):
                rows.setdefault(pair, []).append(i)
        self.journals: dict[str, tuple[int, ...]] = {pair: tuple(rows[pair]) for pair in self.pairs if pair in rows}
        """Rows of the outputs that are the eccentricity of a pair, by the name of a pair that is a joint with clearance."""
        self.guides: tuple[str, ...] = module.GUIDES
        """Names of pairs that guide a body with clearance, together in place of a joint."""
        self.quaternions: tuple[int, ...] = module.QUATERNIONS
        """Rows of q where one begins."""
        self.constraints: tuple[str, ...] = tuple(row[0] for row in module.CONSTRAINTS)
        self.nl = len(self.constraints)
        self.is_length = tuple(row[1] != "1" for row in module.CONSTRAINTS)
        """Whether each constraint is a length [m], not an angle's sine [1]."""
        self.worn: tuple[tuple[int, int], ...] = getattr(module, "WORN", ())
        """Rows of q that wear changes in contact, each with the place of its rate among the forces."""
        self.inputs: dict[str, tuple[str, str]] = {row[0]: row[1:] for row in module.INPUTS}
        """Unit and meaning of the inputs by name; the last `npieces` entries of c are their pieces, see `Signal`."""
        self.smooth: dict[str, tuple[int, str]] = {row[0]: row[1:] for row in module.SMOOTH_INPUTS}
        """Continuous derivatives that inputs must have, and for what, of those that must."""
        self.npieces = WIDTH * len(self.inputs) + sum(self.lists)
        self.has_ledger = hasattr(module, "ledger")
        self.on_speeds = np.array([float(row[1] == "m/s") for row in module.CONSTRAINTS])
        self.rolling: tuple[tuple[str, bool], ...] = module.ROLLING
        self.speed_limited: tuple[str, ...] = module.SPEED_LIMITED
        """Pairs whose law limits how fast contacts may begin."""
        self.known: dict[Hashable, Any] = {}
        """Results of functions that are `per_model`."""

    def effects_at_pairs(self, kind: str) -> dict[str, str]:
        """Return the effect of a kind at each pair that has one."""
        effects = [(name, text.removesuffix(", UNCHECKED")) for name, of, text in self.module.EFFECTS if of == kind]
        return {pair: name for pair in self.pairs for name, text in effects if text.endswith(f" at {pair}")}

    def __repr__(self) -> str:
        return f"Model({self.name}: {self.nq} coordinates, {self.k} contact pairs, {len(self.parameters)} parameters)"

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle and copy text and tables; functions are built anew where they are wanted."""
        text = text_of(self.module)
        tables = {} if text else {name: x for name, x in vars(self.module).items() if not name.startswith("__")}
        return _restored, (type(self), self.name, text, tables, self.declaration, self.dependent, self.signals)

    @cached_property
    def held(self) -> tuple[int, ...]:
        """Rows of q that events alone change: their rates are zero."""
        return tuple(row for row, rate in self._constant_rates.items() if rate == 0)

    @cached_property
    def timers(self) -> tuple[int, ...]:
        """Rows of q that events set, and that time alone changes between them, such as a countdown."""
        return tuple(row for row, rate in self._constant_rates.items() if rate != 0)

    @cached_property
    def _constant_rates(self) -> dict[int, float]:
        """Constant rates of rows of q that events change."""
        changed = sorted({row for _, rows in self.events for row in rows})
        rates = self.expressions("coordinate_rates", *self.symbols("t q u c"))[0] if changed else ()
        return {row: float(rates[row]) for row in changed if rates[row].is_constant()}

    @cached_property
    def units(self) -> dict[str, str]:
        """Unit text of every state by name, in the order q, u, z."""
        module = self.module
        return {row[0]: row[1] for rows in (module.COORDINATES, module.SPEEDS, module.MEMORY) for row in rows}

    @cached_property
    def declared(self) -> Declared:
        """Parameters and their limits, with the defaults in SI."""
        return Declared(self.parameters, self.module.LIMITS, self.module.SUM_LIMITS)

    @cached_property
    def joints(self) -> EngineModel:
        """Model by the joints' coordinates, in which starts are given: itself, unless in absolute coordinates."""
        module = self.module
        if module.JOINT_COORDINATES is None:
            return self
        own = ("NAME", "EFFECTS", "PARAMETERS", "CONSTANTS", "LIMITS", "SUM_LIMITS", "INPUTS", "GIVEN", "start")
        attributes = {name: getattr(module, name) for name in own}
        attributes |= {
            name: getattr(module, f"JOINT_{name}") for name in ("COORDINATES", "SPEEDS", "QUATERNIONS", "CONSTRAINTS")
        }
        attributes["scales"] = module.joint_scales
        if module.JOINT_CONSTRAINTS:
            attributes["constraints"] = module.joint_constraints
        return EngineModel(with_tables(**attributes))

    def without_redundancy(self, dependent: tuple[Dependent, ...]) -> EngineModel:
        """Return the model with these redundant constraints relaxed in every step; itself if none."""
        return _with_dependent(self, dependent).with_signals(self.signals) if dependent else self

    def with_signals(self, signals: Mapping[str, Signal]) -> Self:
        """Return the model with these values of its inputs; both share everything that is built."""
        if signals == self.signals:
            return self
        other = type(self)(self.module, self.declaration, self.dependent, signals)
        other.known = self.known
        return other

    def schedule(self) -> Schedule | None:
        """Return the pieces of the inputs in the order of a run; None for a scene without inputs."""
        return Schedule([self.signals[name] for name in self.inputs]) if self.inputs else None

    def function(self, name: str, beside: tuple[str, ...] = ()) -> Any:
        """Return the CasADi function of one of the module's builders, e.g. "gaps" or "contact_slider_pin".

        Inputs and outputs as the module documents them. Raises InputError for an unknown name, with those that there are
        `beside` the module's.
        """
        if not isinstance(name, str) or not self.has_function(name):
            known = [*filter(self.has_function, _INPUTS), *(f"contact_{pair}" for pair in self.pairs), *beside]
            raise InputError(self.name, [unknown("function", name, known)])
        return self._build(name)

    def evaluate(self, name: str, *arguments: float | np.ndarray) -> list[np.ndarray]:
        """Evaluate one of the module's functions on numbers and vectors, in SI; its results as vectors."""
        return self._callers(name)(*arguments)

    @per_model
    def _callers(self, name: str) -> Callers:
        return Callers(self.function(name))

    def has_function(self, name: str) -> bool:
        """Return whether the module has a builder of this name."""
        listed = name in _INPUTS or name.removeprefix("contact_") in self.pairs
        return listed and callable(getattr(self.module, name, None))

    def placed(self, bound: BoundParameters, q: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the coordinates and speeds at the start from those of the joints."""
        if self.joints is self:
            return q, u
        q, u = self.evaluate("placed", 0.0, q, u, bound.c)
        return q, u

    def symbols(self, names: str, kind: Any = ca.SX) -> list[Any]:
        """Return CasADi symbols of arguments of the module's functions, as in "t q u c"; y is (q, u, z)."""
        return [kind.sym(name, self._size(name)) for name in names.split()]

    def parts(self, y: Any) -> list[Any]:
        """Return the parts (q, u, z) of a vector of states, or of their errors."""
        return ca.vertsplit(y, [0, self.nq, self.nq + self.nu, y.numel()])

    def coordinate_rates(self, t: Any, q: Any, u: Any, f: Any, c: Any) -> Any:
        """Return the rates of the coordinates under forces f, symbolic: wear is among these."""
        rates = self.function("coordinate_rates")(t, q, u, c)
        if not self.worn:
            return rates
        rows, places = zip(*self.worn, strict=True)
        return rates + ca.mtimes(ca.DM.triplet(rows, places, ca.DM.ones(len(rows)), self.nq, f.numel()), f)

    def _size(self, name: str) -> int:
        if name == "f":
            return int(self.function("applied").size1_out(0))
        if name == "reactions":
            return int(self.function("accelerations").size1_out(1))
        return {
            "t": 1,
            "q": self.nq,
            "u": self.nu,
            "z": self.nz,
            "y": self.nq + self.nu + self.nz,
            "mode": self.k,
            "m": self.nm,
            "c": self.nc,
            "p": len(self.parameters),
            "a": self.nu,
            "wanted": self.nl,
            "multipliers": self.nl,
            "joints": self.joints.nq,
            "joint_speeds": self.joints.nu,
        }[name]

    def expressions(self, name: str, *arguments: Any) -> list[Any]:
        """Return the results of one of the module's builders, columns in its arguments (SX)."""
        results = getattr(self.module, name)(*(direct(ca.SX(x)) for x in arguments))
        return [ca.vec(ca.SX(x)) for x in (results if isinstance(results, tuple) else (results,))]

    @per_model
    def _build(self, name: str) -> Any:
        inputs = _INPUTS["contact" if name.startswith("contact_") else name]
        symbols = self.symbols(inputs)
        by_name = dict(zip(inputs.split(), symbols, strict=True))
        if name in SOLVING and self.nl and not self.dependent:
            # a softness that never changes is a number, and what it multiplies is made once
            last = self.nc - self.npieces
            softness = self.module.constants(*self.symbols("p"))[last - self.nl : last]
            by_name["c"] = ca.vertcat(by_name["c"][: last - self.nl], softness, by_name["c"][last:])
        columns = [*map(ca.densify, self.expressions(name, *by_name.values()))]
        return ca.Function(name, symbols, ca.cse(columns), inputs.split(), [f"o{i}" for i in range(len(columns))])

    @cached_property
    def members(self) -> list[tuple[Any, ...]]:
        """Kind of each pair, and its rows of q, u, z and the latches; empty without `FAMILIES`."""
        return [(kind, *row[1:]) for kind, rows in self.module.FAMILIES for row in rows]

    def landmarks(self, p: np.ndarray) -> list[np.ndarray]:
        """Return what `landmarks` returns: a row of LANDMARKS each, of which many spheres have thousands."""
        function, ends = self._landmarks()
        return np.split(np.array(function(p)).ravel(), ends)

    @per_model
    def _landmarks(self) -> tuple[Any, np.ndarray]:
        symbols = self.symbols("p")
        columns = self.expressions("landmarks", *symbols)
        whole = ca.Function("landmarks", symbols, [ca.densify(ca.vertcat(*columns))])
        return whole, np.cumsum([column.numel() for column in columns])[:-1]

    def radii(self, p: np.ndarray) -> dict[str, list[float]]:
        """Return the radii [m] of the surfaces of each pair that has such, in the order of its places."""
        rows = self.module.LANDMARKS
        return grouped(
            (row[0], float(numbers[3]))  # behind the point
            for row, numbers in zip(rows, self.landmarks(p) if rows else (), strict=True)
            if row[4][:1] == ("radius",) and not row[1].startswith("solid_")  # of a body of this name
        )

    def with_pieces(self, function: Any, constant: int) -> Any:
        """Return a function whose argument c, in a place, has the pieces of the inputs from one more argument.

        The function itself for a scene without inputs.
        """
        if not self.inputs:
            return function
        symbols = list(function.mx_in() if function.is_a("MXFunction") else function.sx_in())
        pieces = type(symbols[0]).sym("pieces", self.npieces)
        arguments = list(symbols)
        arguments[constant] = ca.vertcat(symbols[constant][: symbols[constant].numel() - self.npieces], pieces)
        return ca.Function(function.name(), [*symbols, pieces], function.call(arguments))

    def period(self, bound: BoundParameters) -> float | None:
        """Return the period [s] of everything that depends on time; None where nothing does."""
        period = float(self.evaluate("period", bound.p)[0][0]) if hasattr(self.module, "period") else math.inf
        return period if math.isfinite(period) else None  # a drive that stands still has none

    def speed_limits(self, bound: BoundParameters) -> np.ndarray:
        """Return the limits [m/s] of approach speeds by pair (k,); (0,) if all have none.

        Infinite for none, and where the onset of yield is known.
        """
        if not self.speed_limited:
            return np.zeros(0)
        limits = np.full(self.k, math.inf)
        limits[[self.pairs.index(pair) for pair in self.speed_limited]] = self.evaluate("speed_limits", bound.p)[0]
        if self.has_function("yield_forces"):
            limits[self.evaluate("yield_forces", bound.p)[0] > 0] = math.inf
        return limits

    def equations(self) -> Readable:
        """Return the equations of the model for people, derived anew from its scene.

        Markdown with LaTeX, typeset in a notebook. Raises InputError for a model without its scene, as a saved run
        has it.
        """
        from hertzwerk.runtime.engine.model import build

        return build.equations(self.declared_for("equations").scene())

    def sympy_file(self, values: Mapping[str, tuple[float, str]]) -> str:
        """Return a file of Python that makes the model's equations with SymPy; raises InputError.

        values  parameter -> value and unit, in place of its default
        """
        from hertzwerk.runtime.engine.model import build

        return build.sympy_file(self.declared_for("equations").scene(), values)

    def declared_for(self, subject: str) -> Declaration:
        """Return the origin of the model for what needs its scene; raises InputError where it has none."""
        if self.declaration is None:
            raise without_scene(subject, getattr(self.module, "SOURCE", ""), self.name)
        return self.declaration

    @property
    def reads(self) -> bool:
        """Whether the model has its scene, from which readings are derived."""
        return self.declaration is not None

    @per_model
    def reading_module(self) -> ModuleType:
        """Return the module of the readings, derived from the scene; raises InputError for a model without it."""
        coordinates = "tree" if self.joints is self else "absolute"
        return module_of(f"{self.name}_readings", self.declared_for("readings").readings(coordinates))

    def bind(self, parameters: Mapping[str, Value] | None = None) -> BoundParameters:
        """Return the defaults overridden by `parameters`, in SI; raises InputError with every fault."""
        bound, faults = self.check({} if parameters is None else parameters)
        if bound is None:
            raise InputError(self.name, faults)
        return bound

    def check(self, parameters: Mapping[str, Value]) -> tuple[BoundParameters | None, list[Fault]]:
        """Bind parameters, returning the faults as a value: None where there is one."""
        reading = read_parameters(self.declared, parameters)
        if reading.faults:
            return None, list(reading.faults)
        p = np.array(list(reading.si.values()))
        (c,) = self.evaluate("constants", p)
        for i, signal in enumerate(map(self.signals.get, self.inputs)):
            if signal is not None:  # without a value it is zero, as where a scene is drawn
                c[self.nc - self.npieces + WIDTH * i :][:WIDTH] = signal.pieces(np.zeros(1))[0]
        faults = [] if np.isfinite(c).all() else self._undefined(p, c, reading.texts)
        return (None, faults) if faults else (BoundParameters(p, c, reading.texts, reading.warnings), [])

    def _undefined(self, p: np.ndarray, c: np.ndarray, texts: Mapping[str, tuple[float, str]]) -> list[Fault]:
        """Return the faults of constants that are not finite: one for each unchecked law, one for all others."""
        rows = [(*row, float(x)) for row, x in zip(self.module.CONSTANTS, c, strict=True) if not math.isfinite(x)]
        remedy = ("an unchecked law takes SI values as they are, and its formula is undefined there: take its consistent form, "
                  "whose hidden units are named (`hertzwerk laws NAME` lists it)")  # fmt: skip
        faults = {}
        for name, unit, value in rows:
            law = next(((e, text) for e, text in self.module.UNCHECKED if name.startswith(f"{e}_")), None)
            if law is not None:
                actual = f"{law[1]} without a value at these parameters"
                faults[law[0]] = Fault(f"effect {law[0]}", actual, "a law that has one", remedy)
            elif "" not in faults:
                faults[""] = Fault(name, f"{value!r} {unit}", "a finite constant", "It follows from the parameters.")
        source = origin(self.module, p) if "" in faults else None
        if source is not None:
            at = ", ".join(f"{name} = {value:.6g}" for name, value in source.operands.items())
            values = ", ".join(f"{name} = {quantity_text(*texts[name])}" for name in source.parameters)
            actual = f"{source.value!r}, the value of {source.expression} at {at}"
            faults[""] = Fault(source.name, actual, "a finite constant", f"It follows from {values}.")
        return list(faults.values())


def _restored(
    kind: type[EngineModel],
    name: str,
    text: str,
    tables: Mapping[str, Any],
    declaration: Declaration | None,
    dependent: tuple[Dependent, ...],
    signals: Mapping[str, Signal] | None = None,
) -> EngineModel:
    """Return a model that was pickled: by its text, or of a saved run by its tables."""
    return kind(module_of(name, text) if text else SimpleNamespace(**tables), declaration, dependent, signals)


@per_model
def _with_dependent(model: EngineModel, dependent: tuple[Dependent, ...]) -> EngineModel:
    return EngineModel(model.module, model.declaration, dependent)


_INPUTS = {
    "constants": "p",
    "start": "p",
    "placed": "t joints joint_speeds c",
    "scales": "p",
    "coordinate_rates": "t q u c",
    "gaps": "t q u c",
    "gap_accelerations": "t q u a c",
    "contact": "t q u z m c",
    "applied": "t q u c",
    "accelerations": "t q u f c",
    "loads": "t q u reactions c",
    "settling": "t q u f c",
    "unloaded": "t q u f c",
    "rubbing": "t q u reactions c",
    "constraints": "t q u c",
    "balance": "t q u a multipliers c",
    "projection": "t q wanted c",
    "margins": "t q u c",
    "jumps": "t q u c",
    "ledger": "t q u reactions c",
    "energy": "t q u c",
    "poses": "t q c",
    "outputs": "t q u c",
    "speed_limits": "p",
    "yield_forces": "p",
    "rolling_limits": "p",
    "period": "p",
    "landmarks": "p",
}
