"""The derivation, start to end: scene -> audited program -> text. Reads as the list of what a generated module holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from hertzwerk.derive.audit import audit_laws, audit_program, refuse_inconsistent
from hertzwerk.derive.contact import Forces, PairKinematics
from hertzwerk.derive.dimension import Dimension
from hertzwerk.derive.effects.expression import tables_in
from hertzwerk.derive.elements import BOOKED, DISSIPATED, ELEMENTS, element
from hertzwerk.derive.emit import emit, table_name
from hertzwerk.derive.equations import Equations
from hertzwerk.derive.faults import InputError
from hertzwerk.derive.joints import Port
from hertzwerk.derive.kinematics import Kinematics, acceleration_of
from hertzwerk.derive.laws.law import speed_limit
from hertzwerk.derive.parameter import Interval, Parameter
from hertzwerk.derive.program import Function, Program, Result, Tape
from hertzwerk.derive.scene import Contact, Friction, Scene
from hertzwerk.derive.tables import Table
from hertzwerk.derive.units import parse_unit

RATE_UNITS = {"m": "m/s", "1": "1/s"}  # of a constraint, by its unit
MULTIPLIER_UNITS = {"m": "N", "1": "N m"}  # of the force that holds it


def derive(scene: Scene) -> Program:
    """The program of a scene. Raises InputError, listing every unit error, unless each assignment and output is consistent."""
    refuse_inconsistent(scene, audit_laws(scene))
    program = derivation_of(scene)
    units, findings = audit_program(program)
    refuse_inconsistent(scene, findings)
    return replace(program, units=units)


def derivation_of(scene: Scene) -> Program:
    """The program, not yet audited."""
    return _Derivation(scene).program()


def unsolved(scene: Scene) -> Program:
    """The program, not yet audited, with one function more than a module has: `motion`, the equations of motion before they are solved."""
    derivation = _Derivation(scene)
    program = derivation.program()
    return replace(program, functions=(*program.functions, derivation.motion()))


def generate(scene: Scene, source: str = "") -> str:
    """Text of the scene's generated module; `source` names the file the scene stands in."""
    return emit(derive(scene), source)


class _Derivation:
    """One scene's way through the derivation; each method yields one function of the contract."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.tape = Tape()
        for parameter, dimension in scene.dimensions.items():
            self.tape.input(parameter.name, "p", dimension, symbol=parameter)
        self.kin = Kinematics(self.tape, scene)
        self.equations = Equations(self.kin, scene)
        self.contacts = [
            (PairKinematics(self.kin, pair, scene.geometry(pair.name)), contact, friction)
            for pair, contact, friction in scene.contacts
        ]
        self.elements = {
            effect: element(effect, self.kin, scene.scales.length)
            for effect in scene.effects
            if effect.kind in ELEMENTS
        }
        rows = list(self.equations.free)
        if scene.ledger:
            rows += self.equations.driven
        self.rows = rows
        self.row_units = tuple(row.unit for row in rows)
        self.loops = self.equations.constraints
        faults = [fault for pair, _, friction in self.contacts for fault in pair.faults(friction, scene.size)]
        if faults:
            raise InputError(f"scene {scene.name}", faults)
        self.bristles = {
            friction.name: self.tape.input(f"{friction.name}_bristle", "z", _dimension("m"))
            for _, _, friction in self.contacts
            if friction is not None and friction.law.law.memory
        }
        self.memory = self._memory()
        self.latches = {
            contact.name: self.tape.input(f"{contact.name}_approach_speed", "m", _dimension("m/s"))
            for _, contact, _ in self.contacts
            if contact.latches
        }

    def _memory(self) -> list[tuple[str, str]]:
        """Entries of z: (name, unit); first, in the order of the inputs, those that functions read."""
        bristles = [(f"{name}.bristle", "m") for name in self.bristles]
        if not self.scene.ledger:
            return bristles
        ledger = self.scene.of_kind("ledger")[0].name
        drives = [(f"{ledger}.input", "J")] if self.equations.driven else []
        booked = [
            (f"{effect.name}.{BOOKED.get(effect.kind, DISSIPATED)}", "J")
            for effect in self.scene.effects
            if isinstance(effect, Contact | Friction) or effect.kind in BOOKED
        ]
        return bristles + drives + booked

    @property
    def limited(self) -> dict[str, Any]:
        """Pair -> approach speed up to which its law holds, where a material's density says."""
        limits = {contact.name: speed_limit(contact.laws) for _, contact, _ in self.contacts}
        return {name: limit for name, limit in limits.items() if limit is not None}

    def program(self) -> Program:
        functions = [
            self.start(),
            self.scales(),
            self.coordinate_rates(),
            self.gaps(),
            self.gap_accelerations(),
            *(self.contact(*entry) for entry in self.contacts),
            self.applied(),
            self.accelerations(),
            *([self.constraints(), self.projection()] if self.loops else []),
            *([self.ledger(), self.energy()] if self.scene.ledger else []),
            self.poses(),
            self.outputs(),
            *([self.speed_limits()] if self.limited else []),
        ]
        constants = self.tape.constants(functions)
        names = tuple(symbol.name for symbol in constants)
        result = Result("c", names, ("",) * len(names), tuple(constants))  # of any unit: see CONSTANTS
        summary = "What depends on the parameters alone, once per run."
        functions.insert(0, self.tape.function("constants", summary, ("p",), [result]))
        return Program(self.scene, self.tape, tuple(functions), tuple(constants), self._tables())

    # -- functions of the contract ---------------------------------------------------------------------------------

    def _function(self, name: str, summary: str, arguments: str, *results: Result) -> Function:
        return self.tape.function(name, summary, tuple(arguments.split()), results)

    def start(self) -> Function:
        """Initial state."""
        start = self.scene.start
        q = [sp.sympify(value) for freedom in self.scene.free for value in start.coordinates(freedom)]
        q += [state.start for state in self.kin.drive_states]
        u = [sp.sympify(value) for freedom in self.scene.free for value in start.speeds(freedom)]
        return self._function(
            "start", "Coordinates and speeds at t = 0.", "p", self._coordinates("q", q), self._speeds("u", u)
        )

    def scales(self) -> Function:
        """Sizes of everything a tolerance is set for."""
        scales = self.scene.scales
        length, speed, arm = sp.sympify(scales.length), sp.sympify(scales.speed), scales.arm
        mass = self.tape.let(sp.Add(*(sp.sympify(body.mass) for body in self.scene.mechanism.bodies)), "total_mass")
        energy = self.tape.let(mass * speed**2 / 2, "energy_scale")
        force = self.tape.let(energy / length, "force_scale")
        # a quaternion moves by half the angle
        of_unit = {"m": length, "m/s": speed}
        if arm is not None:
            of_unit |= {"rad": length / arm, "rad/s": speed / arm, "1": length / arm / 2}
        q = [of_unit[port.unit] for port in self._coordinate_names()]
        u = [of_unit[port.unit] for port in self._speed_names()]
        sizes = {
            f"{friction.name}.bristle": pair.bristle_size(friction)
            for pair, _, friction in self.contacts
            if friction is not None and friction.law.law.memory
        }
        return self._function(
            "scales",
            "Sizes that accuracy is measured by: of coordinates, speeds, memory; then length, speed, force, energy.",
            "p",
            self._coordinates("sq", q),
            self._speeds("su", u),
            self._memory_result("sz", [sizes.get(name, energy) for name, _ in self.memory]),
            Result("s", ("length", "speed", "force", "energy"), ("m", "m/s", "N", "J"), (length, speed, force, energy)),
        )

    def coordinate_rates(self) -> Function:
        """Kinematic equations."""
        names = self._coordinate_names()
        labels, units = (
            tuple(port.name for port in names),
            tuple("1/s" if unit == "1" else f"{unit}/s" for _, unit in names),
        )
        return self._function(
            "coordinate_rates",
            "Rates of the coordinates.",
            "t q u c",
            Result("dq", labels, units, (*self.kin.rates, *(state.rate for state in self.kin.drive_states))),
        )

    def _pairs(self, name: str, unit: str, values: list[Any]) -> Result:
        names = tuple(pair.pair.name for pair, _, _ in self.contacts)
        return Result(name, names, (unit,) * len(names), tuple(values))

    def gaps(self) -> Function:
        """Event functions and rates."""
        return self._function(
            "gaps",
            "Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.",
            "t q u c",
            self._pairs("G", "m", [pair.touch.gap for pair, _, _ in self.contacts]),
            self._pairs("dG", "m/s", [pair.touch.gap_rate for pair, _, _ in self.contacts]),
        )

    def gap_accelerations(self) -> Function:
        """Second derivatives of the event functions."""
        values = [pair.touch.gap_acceleration for pair, _, _ in self.contacts]
        return self._function(
            "gap_accelerations", "Second derivative of every gap.", "t q u a c", self._pairs("ddG", "m/s^2", values)
        )

    def contact(self, pair: PairKinematics, contact: Contact, friction: Friction | None) -> Function:
        """Forces of one pair."""
        bristle = None if friction is None else self.bristles.get(friction.name)
        forces = pair.forces(contact, friction, self.latches.get(contact.name), bristle)
        name = contact.name
        f = [forces.generalised.get(row.key, sp.S.Zero) for row in self.rows]
        rates = {f"{name}.dissipated": forces.normal_power}
        if friction is not None:
            rates[f"{friction.name}.dissipated"] = forces.friction_power
        if friction is not None and forces.bristle_rate is not None:
            rates[f"{friction.name}.bristle"] = forces.bristle_rate
        sliding = () if friction is None else (forces.sliding_velocity,)
        grip = [] if friction is None or forces.grip is None else self._grip(friction, forces)
        return self._function(
            f"contact_{name}",
            f"Forces of {name}: {contact.text}{f', {friction.law.law.name}' if friction else ''}. "
            "The normal force is the laws' own, not clamped: where it would pull, the contact ends."
            + (" Friction comes on top: `along` times its force, which is that of slip or stick." if grip else ""),
            "t q u z m c",
            self._forces("f", f),
            self._memory_rates([rates.get(entry, sp.S.Zero) for entry, _ in self.memory]),
            Result("normal_force", (name,), ("N",), (forces.normal_force,)),
            Result("sliding_velocity", (name,) * len(sliding), ("m/s",) * len(sliding), sliding),
            Result("in_range", (name,), ("1",), (forces.in_range,)),
            *grip,
        )

    def _grip(self, friction: Friction, forces: Forces) -> list[Result]:
        """Of friction with modes, per newton along the tangent: generalised force and dissipated power; the forces of slip and stick."""
        grip, name = forces.grip, friction.pair
        if grip is None:
            raise ValueError(f"{friction.name} has no modes")
        along = [grip.along.get(row.key, sp.S.Zero) for row in self.rows]
        per_newton = {"N": "1", "N m": "m"}
        units = tuple(per_newton[unit] for unit in self.row_units)
        power = [
            -forces.sliding_velocity if entry == f"{friction.name}.dissipated" else sp.S.Zero
            for entry, _ in self.memory
        ]
        rates = {"J": "W/N", "m": "m/(s N)"}
        return [
            Result("along", tuple(row.key for row in self.rows), units, tuple(along)),
            Result("dz_along", tuple(n for n, _ in self.memory), tuple(rates[u] for _, u in self.memory), tuple(power)),
            Result("sliding_force", (name,), ("N",), (grip.sliding,)),
            Result("holding_force", (name,), ("N",), (grip.holding,)),
        ]

    def applied(self) -> Function:
        """Forces that are no contact's."""
        f = [
            sp.Add(self.equations.gravity(row), *(e.forces.get(row.key, 0) for e in self.elements.values()))
            for row in self.rows
        ]
        return self._function(
            "applied", "Generalised forces of everything that is no contact.", "t q u c", self._forces("f", f)
        )

    def accelerations(self) -> Function:
        """The equations of motion, solved."""
        symbols = {
            row.key: self.tape.input(f"{row.key.replace('.', '_')}_force", "f", _dimension(row.unit))
            for row in self.rows
        }
        a, multipliers = self.equations.accelerations(symbols)
        reactions = self.equations.reactions(symbols, a, multipliers) if self.scene.ledger else []
        driven = self.equations.driven if self.scene.ledger else []
        labels, units = zip(*(acceleration_of(port) for port in self._speed_names()), strict=True)
        return self._function(
            "accelerations",
            "Generalised accelerations a from M a = f - bias, and what each drive must supply.",
            "t q u f c",
            Result("a", labels, units, tuple(a)),
            Result(
                "reactions",
                tuple(f"{row.key}.reaction" for row in driven),
                tuple(row.unit for row in driven),
                tuple(reactions),
            ),
            *((self._rows("multipliers", multipliers, MULTIPLIER_UNITS),) if self.loops else ()),
        )

    def constraints(self) -> Function:
        """What closes the loops."""
        return self._function(
            "constraints",
            "What must be zero for the loops to be closed, and its rate.",
            "t q u c",
            self._rows("phi", [row.value for row in self.loops], {}),
            self._rows("dphi", [row.rate for row in self.loops], RATE_UNITS),
        )

    def projection(self) -> Function:
        """The way back to closed loops."""
        wanted = [
            self.tape.input(f"{row.name.replace('.', '_')}_wanted_rate", "wanted", _dimension(RATE_UNITS[row.unit]))
            for row in self.loops
        ]
        return self._function(
            "projection",
            "Speeds of least kinetic energy that change the constraints at the rates wanted.",
            "t q wanted c",
            self._speeds("v", self.equations.projection(wanted)),
        )

    def _rows(self, name: str, values: list[Any], units: Mapping[str, str]) -> Result:
        return Result(
            name,
            tuple(row.name for row in self.loops),
            tuple(units.get(row.unit, row.unit) for row in self.loops),
            tuple(values),
        )

    def motion(self) -> Function:
        """What stands in the equations of motion, for people: they are solved in the program."""
        free = [row.key for row in self.equations.free]
        mass = self.equations.mass_matrix()
        keys = [(row.key, column) for row in self.rows for column in free if (row.key, column) in mass]
        entries = tuple(mass[key] for key in keys)
        held = {
            f"{row.key} {loop.name}": loop.column[row.key]
            for row in self.rows
            for loop in self.loops
            if row.key in loop.column
        }
        return self._function(
            "motion",
            "Mass matrix M, bias and the columns of G^T, by row, of M a + bias = f + G^T multipliers.",
            "t q u",
            Result("M", tuple(map(" ".join, keys)), ("",) * len(keys), entries),
            self._forces("bias", [self.equations.bias(row) for row in self.rows]),
            Result("held", tuple(held), ("",) * len(held), tuple(held.values())),
        )

    def ledger(self) -> Function:
        """Power put in."""
        power = [
            self.tape.input(f"{row.key.replace('.', '_')}_reaction_in", "reactions", _dimension(row.unit)) * row.speed
            for row in self.equations.driven
        ]
        drives = f"{self.scene.of_kind('ledger')[0].name}.input"
        rows = {
            f"{effect.name}.{BOOKED[effect.kind]}": e.power
            for effect, e in self.elements.items()
            if effect.kind in BOOKED
        }
        rows[drives] = sp.Add(*power)
        values = [rows.get(name, sp.S.Zero) for name, _ in self.memory]
        return self._function(
            "ledger",
            f"Power the drives put in, in its row of z{'; put in and dissipated by force elements, in theirs' if len(rows) > 1 else ''}.",
            "t q u reactions c",
            self._memory_rates(values),
        )

    def energy(self) -> Function:
        """Energies."""
        stored = [pair.elastic(contact)[1] for pair, contact, _ in self.contacts]
        kinetic = self.equations.kinetic()
        potential = sp.Add(self.equations.potential(), *(e.stored for e in self.elements.values()))
        return self._function(
            "energy",
            "Kinetic and potential energy, and what each pair's stiffness stores.",
            "t q u c",
            Result("kinetic", ("kinetic",), ("J",), (kinetic,)),
            Result("potential", ("potential",), ("J",), (potential,)),
            self._pairs("stored", "J", stored),
        )

    def speed_limits(self) -> Function:
        """Ranges of the compliant laws."""
        names, values = tuple(self.limited), tuple(self.limited.values())
        return self._function(
            "speed_limits",
            "Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.",
            "p",
            Result("limits", names, ("m/s",) * len(names), values),
        )

    def poses(self) -> Function:
        """Where the bodies are."""
        positions: list[Any] = []
        rotations: list[Any] = []
        names = [body.name for body in self.scene.mechanism.bodies]
        for body in self.scene.mechanism.bodies:
            positions.extend(self.kin.frame_origin(body))
            rotations.extend(entry for row in self.kin.rotation(body) for entry in row)
        return self._function(
            "poses",
            "Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.",
            "t q c",
            Result(
                "positions", tuple(f"{n}.{k}" for n in names for k in "xyz"), ("m",) * len(positions), tuple(positions)
            ),
            Result(
                "rotations",
                tuple(f"{n}.R_{i}{j}" for n in names for i in "xyz" for j in "xyz"),
                ("1",) * len(rotations),
                tuple(rotations),
            ),
        )

    def outputs(self) -> Function:
        """Named quantities of the pairs."""
        rows = self._outputs()
        result = Result("y", tuple(n for n, _, _ in rows), tuple(u for _, u, _ in rows), tuple(e for _, _, e in rows))
        return self._function("outputs", "Named quantities, see OUTPUTS.", "t q u c", result)

    def _outputs(self) -> list[tuple[str, str, Any]]:
        return [row for pair, _, _ in self.contacts for row in pair.touch.outputs()]

    # -- ports -----------------------------------------------------------------------------------------------------

    def _coordinate_names(self) -> list[Port]:
        free = [port for freedom in self.scene.free for port in freedom.coordinates]
        return free + [state.port for state in self.kin.drive_states]

    def _speed_names(self) -> list[Port]:
        return [port for freedom in self.scene.free for port in freedom.speeds]

    def _coordinates(self, name: str, values: list[Any]) -> Result:
        names = self._coordinate_names()
        return Result(name, tuple(n for n, _ in names), tuple(u for _, u in names), tuple(values))

    def _speeds(self, name: str, values: list[Any]) -> Result:
        names = self._speed_names()
        return Result(name, tuple(n for n, _ in names), tuple(u for _, u in names), tuple(values))

    def _forces(self, name: str, values: list[Any]) -> Result:
        return Result(name, tuple(row.key for row in self.rows), self.row_units, tuple(values))

    def _memory_result(self, name: str, values: list[Any]) -> Result:
        return Result(name, tuple(n for n, _ in self.memory), tuple(unit for _, unit in self.memory), tuple(values))

    def _memory_rates(self, values: list[Any]) -> Result:
        units = {"J": "W", "m": "m/s"}
        names, rates = tuple(n for n, _ in self.memory), tuple(units[unit] for _, unit in self.memory)
        return Result("dz", names, rates, tuple(values))

    def _slips(self) -> dict[str, tuple[Any, ...]]:
        """Table of the pairs whose friction has modes: entries of m behind LATCHES, with their pair; none without such a pair."""
        rows = [
            (f"{pair.pair.name}.slip", "1", j)
            for j, (pair, _, friction) in enumerate(self.contacts)
            if friction is not None and friction.law.law.modes
        ]
        return {"SLIPS": tuple(rows)} if rows else {}

    def _bristle_rows(self) -> Iterator[tuple[int, int]]:
        """Of every bristle: its row of z, and its pair."""
        entries = [name for name, _ in self.memory]
        for j, (_, _, friction) in enumerate(self.contacts):
            if friction is not None and friction.name in self.bristles:
                yield entries.index(f"{friction.name}.bristle"), j

    def _loop_tables(self) -> dict[str, tuple[Any, ...]]:
        """The constraints, and what of the start is stated and not to be found by assembly."""
        stated = [name for freedom in self.scene.free for name in self.scene.start.stated(freedom)]
        given = (*stated, *(state.port.name for state in self.kin.drive_states))
        return {"CONSTRAINTS": tuple((row.name, row.unit) for row in self.loops), "GIVEN": given}

    def _tables(self) -> Mapping[str, tuple[Any, ...]]:
        scene = self.scene
        pairs = [pair.pair.name for pair, _, _ in self.contacts]
        entries = [name for name, _ in self.memory]
        meanings = meanings_of(scene)
        quaternions = tuple(i for i, port in enumerate(self._coordinate_names()) if port.name.endswith(".q0"))
        return {
            "EFFECTS": tuple((effect.name, effect.kind, effect.text) for effect in scene.effects),
            "UNCHECKED": tuple((e.name, e.text) for e in scene.effects if getattr(e, "unchecked", False)),
            "PARAMETERS": tuple(
                (p.name, p.unit, p.default, p.meaning or meanings.get(p.name, "")) for p in scene.parameters.values()
            ),
            "LIMITS": tuple(_limits(scene)),
            "COORDINATES": tuple((name, unit) for name, unit in self._coordinate_names()),
            **({"QUATERNIONS": quaternions} if quaternions else {}),
            "SPEEDS": tuple((name, unit) for name, unit in self._speed_names()),
            "MEMORY": tuple(self.memory),
            "LATCHES": tuple((f"{name}.approach_speed", "m/s", pairs.index(name)) for name in self.latches),
            "PAIRS": tuple((pair.pair.name, pair.pair.kind) for pair, _, _ in self.contacts),
            **self._slips(),
            "RELEASES": tuple("force" if c.damping is None else c.damping.law.release for _, c, _ in self.contacts),
            "DISSIPATED": tuple(entries.index(f"{name}.dissipated") for name in pairs) if scene.ledger else (),
            **(self._loop_tables() if self.loops else {}),
            **({"BRISTLES": tuple(self._bristle_rows())} if self.bristles else {}),
            "OUTPUTS": tuple((name, unit) for name, unit, _ in self._outputs()),
            **({"SPEED_LIMITED": tuple(self.limited)} if self.limited else {}),
            "BODIES": tuple(body.name for body in scene.mechanism.bodies),
            **{table_name(table): table.pieces() for table in self._tables_used()},
        }

    def _tables_used(self) -> list[Table]:
        """Tables that stand in some expression of the scene."""
        return list(dict.fromkeys(table for slot in self.scene.slots() for table in tables_in(slot.value)))


def _limits(scene: Scene) -> list[tuple[Any, ...]]:
    """Ranges of parameters that fill a slot alone: (parameter, kind, lower, upper, lower open, upper open, why)."""
    rows: dict[tuple[Any, ...], str] = {}
    for slot in scene.slots():
        if not isinstance(slot.value, Parameter):
            continue
        ranges: tuple[tuple[str, Interval | None], ...] = (("defined", slot.limit), ("recommended", slot.recommended))
        for kind, interval in ranges:
            if interval is not None and not (kind == "recommended" and interval == slot.limit):
                bounds = (interval.lower, interval.upper, interval.open_left, interval.open_right)
                rows.setdefault((slot.value.name, kind, *bounds), slot.where)
    return [(*row, where) for row, where in rows.items()]


def meanings_of(scene: Scene) -> dict[str, str]:
    """What each parameter is: as declared, or else the slot it fills."""
    meanings: dict[str, str] = {}
    for slot in scene.slots():
        if isinstance(slot.value, Parameter):
            meanings.setdefault(slot.value.name, slot.value.meaning or slot.where)
    return meanings


def _dimension(unit: str) -> Dimension:
    return Dimension.from_unit(parse_unit(unit), {})
