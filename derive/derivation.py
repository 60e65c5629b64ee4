"""The derivation, start to end: scene -> audited program -> text. Reads as the list of what a generated module holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.audit import audit_laws, audit_program, refuse_inconsistent
from hertzwerk.derive.constrained import REGULAR
from hertzwerk.derive.contact import Forces, PairKinematics
from hertzwerk.derive.coordinates import MEASURED, Absolute, absolute, placed
from hertzwerk.derive.dimension import Dimension
from hertzwerk.derive.effects.element import DISSIPATED
from hertzwerk.derive.effects.expression import tables_in
from hertzwerk.derive.elements import element
from hertzwerk.derive.emit import emit, of_a_step, table_name
from hertzwerk.derive.equations import Equations
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.joints import Port
from hertzwerk.derive.kinematics import Kinematics, acceleration_of
from hertzwerk.derive.landmarks import Landmark, landmarks_of
from hertzwerk.derive.laws.law import speed_limit
from hertzwerk.derive.loops import Constraint, constraints_of
from hertzwerk.derive.parameter import Interval, Parameter
from hertzwerk.derive.periods import period
from hertzwerk.derive.program import CONSTANT, Function, Program, Result, Tape
from hertzwerk.derive.resistance import resistance_faults
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
    """The program in the scene's coordinates, not yet audited."""
    return _in_coordinates(scene)[1]


def unsolved(scene: Scene) -> Program:
    """The program, not yet audited, with one function more than a module has: `motion`, the equations of motion before they are solved."""
    derivation, program = _in_coordinates(scene)
    return replace(program, functions=(*program.functions, derivation.motion()))


def _in_coordinates(scene: Scene) -> tuple[_Derivation, Program]:
    """The derivation and its program; "auto" takes what has fewer operations a step, of equals the joints' coordinates."""
    if scene.coordinates == "absolute":
        return _with_program(_Derivation(absolute(scene)))
    by_joints, tree = _with_program(_Derivation(scene))
    if scene.coordinates == "tree":
        return by_joints, tree
    try:
        by_bodies, other = _with_program(_Derivation(absolute(scene)))
    except InputError as error:
        return by_joints, replace(tree, note=f"of the joints; the bodies' own cannot be had: {error.faults[0].where}")
    here, there = of_a_step(tree), of_a_step(other)
    both = f"{here} operations a step by those of the joints, {there} by the bodies' own"
    if there < here:
        return by_bodies, replace(other, note=f"absolute, as the cheaper: {both}")
    return by_joints, replace(tree, note=f"of the joints, as the cheaper: {both}")


def _with_program(derivation: _Derivation) -> tuple[_Derivation, Program]:
    return derivation, derivation.program()


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
        found = {effect: element(effect, self.kin, scene) for effect in scene.effects}
        self.elements = {effect: e for effect, e in found.items() if e is not None}
        rows = list(self.equations.free)
        if scene.ledger:
            rows += self.equations.driven
        self.driven = [*self.equations.driven, *self.equations.prescribed] if scene.ledger else []
        self.rows = rows
        self.row_units = tuple(row.unit for row in rows)
        self.loops = self.equations.constraints
        faults = [fault for pair, _, friction in self.contacts for fault in pair.faults(friction, scene.size)]
        faults += resistance_faults(scene)
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
        # effects that have a term in an equation of motion, found as it is written; a drive takes a coordinate away, a ledger has its quadratures
        self.entered = {effect.name for effect in scene.effects if effect.kind in ("drive", "ledger")}

    def _memory(self) -> list[tuple[str, str]]:
        """Entries of z: (name, unit); first, in the order of the inputs, those that functions read."""
        bristles = [(f"{name}.bristle", "m") for name in self.bristles]
        if not self.scene.ledger:
            return bristles
        ledger = self.scene.of_kind("ledger")[0].name
        drives = [(f"{ledger}.input", "J")] if self.driven else []
        rows = {effect.name: DISSIPATED for effect in self.scene.effects if isinstance(effect, Contact | Friction)}
        rows |= {effect.name: e.booked for effect, e in self.elements.items() if e.power is not None}
        booked = [(f"{e.name}.{rows[e.name]}", "J") for e in self.scene.effects if e.name in rows]
        return bristles + drives + booked

    @property
    def limited(self) -> dict[str, Any]:
        """Pair -> approach speed up to which its law holds, where a material's density says."""
        limits = {contact.name: speed_limit(contact.laws) for _, contact, _ in self.contacts}
        return {name: limit for name, limit in limits.items() if limit is not None}

    @cached_property
    def periodic(self) -> Any | None:
        """After what time everything that depends on time repeats [s], where it does."""
        return period(self.scene)

    def program(self) -> Program:
        functions = [
            *(self.placement() if isinstance(self.scene, Absolute) else [self.start(self.scene, self.kin)]),
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
            *([self.period()] if self.periodic is not None else []),
            self.landmarks(),
        ]
        idle = [effect.name for effect in self.scene.effects if effect.name not in self.entered]
        if idle:
            raise InputError(f"scene {self.scene.name}", map(self._idle_fault, idle))
        constants = self.tape.constants(functions)
        softness = [symbol for symbol, group in self.tape.inputs.items() if group == CONSTANT]
        values = (*constants, *(sp.Float(REGULAR) for _ in softness))
        constants = [*constants, *softness]
        names = tuple(symbol.name for symbol in constants)
        result = Result("c", names, ("",) * len(names), values)  # of any unit: see CONSTANTS
        summary = "What depends on the parameters alone, once per run."
        functions.insert(0, self.tape.function("constants", summary, ("p",), [result]))
        note = "absolute" if isinstance(self.scene, Absolute) else ""
        return Program(self.scene, self.tape, tuple(functions), tuple(constants), self._tables(), note)

    def _enter(self, effect: str, forces: Mapping[str, Any]) -> None:
        """Note an effect whose generalised forces are not zero in every row."""
        if any(forces.get(row.key, 0) != 0 for row in self.rows):
            self.entered.add(effect)

    def _idle_fault(self, name: str) -> Fault:
        driven = getattr(self.scene.effect(name), "joint", "") in self.scene.driven
        why = "its joint is driven, whatever acts on it" if driven else "what it acts on cannot move that way"
        return Fault(
            f"effect {name}",
            "no equation that it enters",
            f"an effect that changes the motion; {why}",
            f"Turn it, or leave it out: scene.without({name!r}).",
        )

    # -- functions of the contract ---------------------------------------------------------------------------------

    def _function(self, name: str, summary: str, arguments: str, *results: Result) -> Function:
        return self.tape.function(name, summary, tuple(arguments.split()), results)

    def start(self, scene: Scene, kin: Kinematics) -> Function:
        """Initial state."""
        start = scene.start
        q = [sp.sympify(value) for freedom in scene.free for value in start.coordinates(freedom)]
        q += [state.start for state in kin.drive_states]
        u = [sp.sympify(value) for freedom in scene.free for value in start.speeds(freedom)]
        coordinates, speeds = _ports(scene, kin)
        return self._function(
            "start", "Coordinates and speeds at t = 0.", "p", _vector("q", coordinates, q), _vector("u", speeds, u)
        )

    def placement(self) -> list[Function]:
        """The start by the joints' coordinates, which say what is given and what follows, and the way from there to those of the bodies."""
        declared, joints = self.absolute.declared, self.joints
        coordinates, speeds = _ports(declared, joints)
        sizes = self._sizes()
        q, u = placed(self.absolute, joints, self.kin)
        functions = [
            self.start(declared, joints),
            self._function(
                "joint_scales",
                "Sizes of the joints' coordinates and speeds.",
                "p",
                _vector("sq", coordinates, [sizes[unit] for _, unit in coordinates]),
                _vector("su", speeds, [sizes[unit] for _, unit in speeds]),
            ),
            self._function(
                "placed",
                "Coordinates and speeds of the bodies, from those of the joints.",
                "t joints joint_speeds c",
                self._coordinates("q", q),
                self._speeds("u", u),
            ),
        ]
        if self.joint_loops:
            functions.append(self._closed("joint_constraints", self.joint_loops, "t joints joint_speeds c"))
        return functions

    @cached_property
    def joints(self) -> Kinematics:
        """Of the scene as declared, in the joints' coordinates: where the bodies are at the start."""
        return Kinematics(self.tape, self.absolute.declared, ("joints", "joint_speeds", "joint_accelerations"))

    @property
    def absolute(self) -> Absolute:
        """The scene, in coordinates of the bodies."""
        if not isinstance(self.scene, Absolute):
            raise TypeError(f"scene {self.scene.name} is in the joints' coordinates")
        return self.scene

    @cached_property
    def joint_loops(self) -> tuple[Constraint, ...]:
        """The loops of the scene as declared."""
        return constraints_of(self.joints)

    def scales(self) -> Function:
        """Sizes of everything a tolerance is set for."""
        scales, of_unit = self.scene.scales, self._sizes()
        length, speed = sp.sympify(scales.length), sp.sympify(scales.speed)
        mass = self.tape.let(sp.Add(*(sp.sympify(body.mass) for body in self.scene.mechanism.bodies)), "total_mass")
        energy = self.tape.let(mass * speed**2 / 2, "energy_scale")
        force = self.tape.let(energy / length, "force_scale")
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

    def _sizes(self) -> dict[str, Any]:
        """Of coordinates and speeds, by unit."""
        scales = self.scene.scales
        length, speed = sp.sympify(scales.length), sp.sympify(scales.speed)
        if scales.arm is None:
            return {"m": length, "m/s": speed}
        # a quaternion moves by half the angle
        angles = {"rad": length / scales.arm, "rad/s": speed / scales.arm, "1": length / scales.arm / 2}
        return {"m": length, "m/s": speed, **angles}

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
        self._enter(name, forces.generalised)
        if friction is not None:
            self._enter(friction.name, forces.rubbing if forces.grip is None else forces.grip.along)
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
        weight = {row.key: self.equations.gravity(row) for row in self.rows}
        for effect in self.scene.of_kind("gravity"):
            self._enter(effect.name, weight)
        for effect, e in self.elements.items():
            self._enter(effect.name, e.forces)
        f = [sp.Add(weight[row.key], *(e.forces.get(row.key, 0) for e in self.elements.values())) for row in self.rows]
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
        labels, units = zip(*(acceleration_of(port) for port in self._speed_names()), strict=True)
        return self._function(
            "accelerations",
            "Generalised accelerations a from M a = f - bias, and what each drive must supply.",
            "t q u f c",
            Result("a", labels, units, tuple(a)),
            Result(
                "reactions",
                tuple(f"{row.key}.reaction" for row in self.driven),
                tuple(row.unit for row in self.driven),
                tuple(reactions),
            ),
            *((_rows("multipliers", self.loops, multipliers, MULTIPLIER_UNITS),) if self.loops else ()),
        )

    def constraints(self) -> Function:
        """What closes the loops."""
        return self._closed("constraints", self.loops, "t q u c")

    def _closed(self, name: str, loops: tuple[Constraint, ...], arguments: str) -> Function:
        return self._function(
            name,
            "What must be zero for the loops to be closed, and its rate.",
            arguments,
            _rows("phi", loops, [row.value for row in loops], {}),
            _rows("dphi", loops, [row.rate for row in loops], RATE_UNITS),
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
            for row in self.driven
        ]
        drives = f"{self.scene.of_kind('ledger')[0].name}.input"
        rows = {f"{effect.name}.{e.booked}": e.power for effect, e in self.elements.items() if e.power is not None}
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

    def period(self) -> Function:
        """When what depends on time repeats."""
        summary = "After what time everything that depends on time repeats."
        return self._function("period", summary, "p", Result("period", ("period",), ("s",), (self.periodic,)))

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

    def landmarks(self) -> Function:
        """What a picture shows."""
        return self._function(
            "landmarks",
            "What a picture of the mechanism shows, row by row of LANDMARKS: point, directions and sizes, along the axes of its body.",
            "p",
            *(landmark.result for landmark in self._landmarks),
        )

    @cached_property
    def _landmarks(self) -> tuple[Landmark, ...]:
        """Of the scene as declared: joints that only coordinates ask for are not there."""
        return tuple(landmarks_of(self.scene.declared if isinstance(self.scene, Absolute) else self.scene))

    def outputs(self) -> Function:
        """Named quantities of the pairs."""
        rows = self._outputs()
        result = Result("y", tuple(n for n, _, _ in rows), tuple(u for _, u, _ in rows), tuple(e for _, _, e in rows))
        return self._function("outputs", "Named quantities, see OUTPUTS.", "t q u c", result)

    def _outputs(self) -> list[tuple[str, str, Any]]:
        of_pairs = [row for pair, _, _ in self.contacts for row in pair.touch.outputs()]
        of_pairs += [row for e in self.elements.values() for row in e.outputs]
        return of_pairs + (self._joint_outputs() if isinstance(self.scene, Absolute) else [])

    def _joint_outputs(self) -> list[tuple[str, str, Any]]:
        """What the joints' coordinates and speeds are, where they can be measured."""
        closures = [joint for joint in self.scene.mechanism.closures if type(joint).__name__ in MEASURED]
        freedoms = [freedom for joint in closures for freedom in joint.freedoms]
        rows = [
            (port, value)
            for freedom in freedoms
            for port, value in (
                (freedom.coordinates[0], self.kin.coordinate(freedom.key)),
                (freedom.speeds[0], self.kin.speed(freedom.key)),
            )
        ]
        return [(port.name, port.unit, value) for port, value in rows if value is not None]

    # -- ports -----------------------------------------------------------------------------------------------------

    def _coordinate_names(self) -> list[Port]:
        return _ports(self.scene, self.kin)[0]

    def _speed_names(self) -> list[Port]:
        return _ports(self.scene, self.kin)[1]

    def _coordinates(self, name: str, values: list[Any]) -> Result:
        return _vector(name, self._coordinate_names(), values)

    def _speeds(self, name: str, values: list[Any]) -> Result:
        return _vector(name, self._speed_names(), values)

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
        loops = {"CONSTRAINTS": _names(self.loops)} if self.loops else {}
        if not isinstance(self.scene, Absolute):
            return loops | {"GIVEN": _given(self.scene, self.kin)} if loops else {}
        coordinates, speeds = _ports(self.scene.declared, self.joints)
        given = {"GIVEN": _given(self.scene.declared, self.joints)} if self.joint_loops else {}
        return (
            loops
            | given
            | {
                "JOINT_COORDINATES": tuple(map(tuple, coordinates)),
                "JOINT_SPEEDS": tuple(map(tuple, speeds)),
                "JOINT_QUATERNIONS": _quaternions(coordinates),
                "JOINT_CONSTRAINTS": _names(self.joint_loops),
            }
        )

    def _tables(self) -> Mapping[str, tuple[Any, ...]]:
        scene = self.scene
        pairs = [pair.pair.name for pair, _, _ in self.contacts]
        entries = [name for name, _ in self.memory]
        meanings = meanings_of(scene)
        quaternions = _quaternions(self._coordinate_names())
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
            **self._loop_tables(),
            **({"BRISTLES": tuple(self._bristle_rows())} if self.bristles else {}),
            "OUTPUTS": tuple((name, unit) for name, unit, _ in self._outputs()),
            **({"SPEED_LIMITED": tuple(self.limited)} if self.limited else {}),
            "BODIES": tuple(body.name for body in scene.mechanism.bodies),
            "LANDMARKS": tuple(landmark.row for landmark in self._landmarks),
            **{table_name(table): table.pieces() for table in self._tables_used()},
        }

    def _tables_used(self) -> list[Table]:
        """Tables that stand in some expression of the scene."""
        return list(dict.fromkeys(table for slot in self.scene.slots() for table in tables_in(slot.value)))


def _ports(scene: Scene, kin: Kinematics) -> tuple[list[Port], list[Port]]:
    """Coordinates, with what drives integrate, and speeds."""
    coordinates = [port for freedom in scene.free for port in freedom.coordinates]
    coordinates += [state.port for state in kin.drive_states]
    return coordinates, [port for freedom in scene.free for port in freedom.speeds]


def _vector(name: str, ports: list[Port], values: list[Any]) -> Result:
    return Result(name, tuple(port.name for port in ports), tuple(port.unit for port in ports), tuple(values))


def _rows(name: str, loops: tuple[Constraint, ...], values: list[Any], units: Mapping[str, str]) -> Result:
    labels, of = tuple(row.name for row in loops), tuple(units.get(row.unit, row.unit) for row in loops)
    return Result(name, labels, of, tuple(values))


def _names(loops: tuple[Constraint, ...]) -> tuple[tuple[str, str], ...]:
    return tuple((row.name, row.unit) for row in loops)


def _quaternions(ports: list[Port]) -> tuple[int, ...]:
    """Where quaternions begin."""
    return tuple(i for i, port in enumerate(ports) if port.name.endswith(".q0"))


def _given(scene: Scene, kin: Kinematics) -> tuple[str, ...]:
    """What of the start is stated, and not to be found by assembly."""
    stated = [name for freedom in scene.free for name in scene.start.stated(freedom)]
    return (*stated, *(state.port.name for state in kin.drive_states))


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
