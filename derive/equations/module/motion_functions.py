"""Functions of motion: start, kinematic equations, forces, accelerations, events, loops, energy."""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.equations.module.equation_system import Joints, System
from hertzwerk.derive.equations.module.labelled_results import (
    MULTIPLIER_UNITS,
    RATE_UNITS,
    SECOND_UNITS,
    VALUE_UNITS,
    of_loops,
    vector,
)
from hertzwerk.derive.equations.module.scale_functions import coordinate_sizes
from hertzwerk.derive.equations.motion.absolute_coordinates import placed
from hertzwerk.derive.equations.motion.kinematics import acceleration_of
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.equations.motion.reaction_loads import Carried, Solved
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.program.program import Function, Result


def coordinate_rates(system: System) -> Function:
    """Kinematic equations."""
    names = system.coordinates
    labels, units = (
        tuple(port.name for port in names),
        tuple("1/s" if unit == "1" else f"{unit}/s" for _, unit in names),
    )
    # of states that change at events alone: zero
    known = {f"{effect.name}.{name}": rate for effect, e in system.elements.items() for name, rate in e.rates.items()}
    of_states = [sp.sympify(known.get(name, 0)) for name in system.scene.states]
    return system.function(
        "coordinate_rates",
        "Rates of the coordinates.",
        "t q u c",
        Result(
            "dq",
            labels,
            units,
            (*system.kin.rates, *(state.rate for state in system.kin.drive_states), *of_states),
        ),
    )


def applied(system: System) -> Function:
    """Generalised forces other than contact forces."""
    pressed = [*system.pressed.values(), *system.worn]
    weight = {row.key: sp.S.Zero if row in pressed else system.equations.gravity(row) for row in system.rows}
    for gravity in system.scene.all(Gravity):
        system.enter(gravity.name, weight)
    for effect, e in system.elements.items():
        system.enter(effect.name, e.forces)
    f = [weight[row.key] + system.force(row.key, carried=False) for row in system.rows]
    return system.function(
        "applied", "Generalised forces other than contact forces.", "t q u c", system.of_rows("f", f)
    )


def accelerations(system: System) -> tuple[Function, ...]:
    """Equations of motion, solved for the accelerations, and loads by reactions where there are any."""
    symbols = {
        row.key: system.tape.input(f"{row.key.replace('.', '_')}_force", "f", Dimension.from_unit(row.unit))
        for row in system.rows
    }
    if system.carried is not None:
        return _accelerations_under_loads(system, system.carried, symbols)
    a, multipliers = system.equations.accelerations(symbols)
    reactions = system.equations.reactions(symbols, a, multipliers) if system.scene.ledger else []
    return (_accelerations(system, a, multipliers, reactions, []),)


def _accelerations_under_loads(system: System, carried: Carried, symbols: dict[str, Any]) -> tuple[Function, ...]:
    """Accelerations under loads by reactions, these loads, and how unique the reactions are."""
    pressed = {symbol: symbols[row.key] for symbol, row in system.pressed.items()}
    beside = [*pressed.values(), *(row.key for row in system.worn)]
    solved = carried.solved({row: force for row, force in symbols.items() if row not in beside}, pressed)
    a, multipliers, of_drives = solved.accelerations, solved.multipliers, []
    if system.scene.ledger:
        of_drives = system.equations.reactions(solved.forces, a, multipliers)
    names = [symbol.name for symbol in carried.read]
    magnitudes = [*zip(names, solved.magnitudes, strict=True), *((s.name, force) for s, force in pressed.items())]
    by_input = dict(magnitudes)
    own = [s.name for s, group in system.tape.inputs.items() if group == "reactions" and s not in system.supplied]
    return (
        _accelerations(system, a, multipliers, of_drives, [(name, by_input[name]) for name in own]),
        system.function(
            "loads", "Generalised forces that depend on reactions and normal forces.", "t q u reactions c",
            system.of_rows("f", [carried.loads.get(row.key, sp.S.Zero) for row in system.rows])),
        system.function(
            "settling", "Margins of uniqueness of the reactions, positive where they are unique; residuals of their solution.",
            "t q u f c", Result("margins", tuple(names), ("1",) * len(names), tuple(solved.margins)),
            Result("residuals", tuple(names), ("1",) * len(names), tuple(solved.residuals))),
        *([_unloaded(system, solved, names)] if system.feeds else []),
        *([_rubbing(system)] if system.rubbing else []),
    )  # fmt: skip


def _unloaded(system: System, solved: Solved, names: list[str]) -> Function:
    """Accelerations and reactions without loads that depend on these, linear in the forces."""
    whose = [name for name in names for _ in range(3)]
    parts = tuple(sp.sympify(part) for vector in solved.parts for part in vector)
    return system.function(
        "unloaded",
        "Accelerations without loads by reactions, and the three components of each of these.",
        "t q u f c",
        vector("a", [acceleration_of(port) for port in system.speeds], solved.unloaded),
        Result("parts", tuple(whose), ("N",) * len(parts), parts),
    )


def _rubbing(system: System) -> Function:
    """Sliding velocities and limits of the set-valued frictions of joints."""
    names = tuple(name for name, _ in system.rubbing)
    fields = (("velocity", "m/s"), ("pressing", "N"), ("kinetic", "1"), ("static", "1"))
    return system.function(
        "rubbing",
        "Set-valued frictions of joints, see RUBBING: sliding velocity, normal force, coefficients of sliding and of rest.",
        "t q u reactions c",
        *(
            Result(
                part, names, (unit,) * len(names), tuple(sp.sympify(getattr(rub, part)) for _, rub in system.rubbing)
            )
            for part, unit in fields
        ),
    )


def _accelerations(
    system: System, a: list[Any], multipliers: list[Any], reactions: list[Any], loads: list[tuple[str, Any]]
) -> Function:
    rates = [acceleration_of(port) for port in system.speeds]
    units = {symbol.name: row.unit for symbol, row in system.pressed.items()}
    return system.function(
        "accelerations",
        "Generalised accelerations a from M a = f - bias, and the reactions of the drives.",
        "t q u f c",
        vector("a", rates, a),
        Result(
            "reactions",
            (*(f"{row.key}.reaction" for row in system.driven), *(name for name, _ in loads)),
            (*(row.unit for row in system.driven), *(units.get(name, "N") for name, _ in loads)),
            (*reactions, *(value for _, value in loads)),
        ),
        *((of_loops("multipliers", system.loops, multipliers, MULTIPLIER_UNITS),) if system.loops else ()),
    )


def margins(system: System) -> Function:
    """Margins of the effects' events."""
    names = tuple(f"{effect}.{event.name}" for effect, event in system.events)
    values = tuple(sp.sympify(event.margin) / sp.sympify(event.size) for _, event in system.events)
    return system.function(
        "margins",
        "Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.",
        "t q u c",
        Result("margin", names, ("1",) * len(names), values),
    )


def jumps(system: System) -> Function:
    """States after the effects' events."""
    rows = [(f"{effect}.{name}", value) for effect, event in system.events for name, value in event.then.items()]
    names, values = tuple(name for name, _ in rows), tuple(sp.sympify(value) for _, value in rows)
    return system.function(
        "jumps",
        "Values of the states that each event changes, event by event, by the values before it.",
        "t q u c",
        Result("then", names, tuple(system.scene.states[name].unit for name in names), values),
    )


def balance(system: System) -> Function:
    """Residuals of the equations of motion for given accelerations and multipliers."""
    equations, loops = system.equations, system.loops
    mass = equations.mass_matrix()
    held = [
        system.tape.input(
            f"{row.name.replace('.', '_')}_multiplier", "multipliers", Dimension.from_unit(MULTIPLIER_UNITS[row.unit])
        )
        for row in loops
    ]
    inertia = []
    for row in equations.free:
        terms = [mass[row.key, f.key] * f.acceleration for f in equations.free if (row.key, f.key) in mass]
        ties = [loop.column[row.key] * force for loop, force in zip(loops, held, strict=True) if row.key in loop.column]
        inertia.append(sp.Add(*terms, equations.bias(row)) - sp.Add(*ties))
    second = [
        sp.Add(*(loop.column[f.key] * f.acceleration for f in equations.free if f.key in loop.column), loop.bias)
        for loop in loops
    ]
    return system.function(
        "balance",
        "M a + bias - G^T multipliers, the forces that accelerations need, and G a + bias, the loops' second derivatives.",
        "t q u a multipliers c",
        Result(
            "needed",
            tuple(row.key for row in equations.free),
            tuple(row.unit for row in equations.free),
            tuple(inertia),
        ),
        of_loops("ddphi", loops, second, SECOND_UNITS),
    )


def motion(system: System) -> Function:
    """Equations of motion before they are solved, for readers."""
    free = [row.key for row in system.equations.free]
    mass = system.equations.mass_matrix()
    rows = [*system.equations.free, *(system.equations.driven if system.scene.ledger else [])]
    keys = [(row.key, column) for row in rows for column in free if (row.key, column) in mass]
    entries = tuple(mass[key] for key in keys)
    held = {
        f"{row.key} {loop.name}": loop.column[row.key]
        for row in rows
        for loop in system.loops
        if row.key in loop.column
    }
    return system.function(
        "motion",
        "Mass matrix M, bias and the columns of G^T, by row, of M a + bias = f + G^T multipliers.",
        "t q u",
        Result("M", tuple(map(" ".join, keys)), ("",) * len(keys), entries),
        Result(
            "bias", tuple(r.key for r in rows), tuple(r.unit for r in rows), tuple(map(system.equations.bias, rows))
        ),
        Result("held", tuple(held), ("",) * len(held), tuple(held.values())),
    )


# -- energy ledger (powers) and energies -------------------------------------------------------------------------------


def ledger(system: System) -> Function:
    """Power of the drives and force elements."""
    power = [force * row.speed for force, row in zip(system.supplied, system.driven, strict=True)]
    rows = {
        f"{effect.name}.{quantity}": power
        for effect, e in system.elements.items()
        for quantity, power in e.powers.items()
    }
    if system.scene.ledger is not None:
        rows[f"{system.scene.ledger.name}.input"] = sp.Add(*power)
    values = [rows.get(name, sp.S.Zero) for name, _ in system.memory]
    return system.function(
        "ledger",
        f"Power put in by drives, in its row of z{'; put in and dissipated by force elements, in theirs' if len(rows) > 1 else ''}.",
        "t q u reactions c",
        system.memory_rates(values),
    )


def energy(system: System) -> Function:
    """Kinetic, potential and stored energy."""
    stored = [pair.elastic(contact)[1] for pair, contact, _ in system.contacts]
    kinetic = system.equations.kinetic()
    potential = sp.Add(system.equations.potential(), *(e.stored for e in system.elements.values()))
    return system.function(
        "energy",
        "Kinetic and potential energy, and the energy stored by each pair's stiffness.",
        "t q u c",
        Result("kinetic", ("kinetic",), ("J",), (kinetic,)),
        Result("potential", ("potential",), ("J",), (potential,)),
        system.of_pairs("stored", "J", stored),
    )


# -- constraints of the loops, and the projection of speeds onto them --------------------------------------------------


def constraints(system: System) -> Function:
    """Loop constraints and their rates."""
    return _closed(system, "constraints", system.loops, "t q u c")


def joint_constraints(system: System, joints: Joints) -> Function:
    """Loop constraints of the declared scene, in joint coordinates."""
    return _closed(system, "joint_constraints", joints.loops, "t joints joint_speeds c")


def _closed(system: System, name: str, loops: tuple[Constraint, ...], arguments: str) -> Function:
    return system.function(
        name,
        "Constraints, zero while the loops are closed, and their rates.",
        arguments,
        of_loops("phi", loops, [row.value for row in loops], VALUE_UNITS),
        of_loops("dphi", loops, [row.rate for row in loops], RATE_UNITS),
    )


def projection(system: System) -> Function:
    """Change of speeds that gives the constraints wanted rates."""
    wanted = [
        system.tape.input(
            f"{row.name.replace('.', '_')}_wanted_rate", "wanted", Dimension.from_unit(RATE_UNITS[row.unit])
        )
        for row in system.loops
    ]
    return system.function(
        "projection",
        "Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.",
        "t q wanted c",
        system.of_speeds("v", system.equations.projection(wanted)),
        of_loops("independence", system.loops, system.equations.independence(), dict.fromkeys(RATE_UNITS, "1")),
    )


# -- initial state, and its conversion from joint to body coordinates --------------------------------------------------


def start(system: System) -> Function:
    """Initial state, in joint coordinates."""
    of = system if system.joints is None else system.joints
    initial, free = of.scene.start, of.scene.free
    q = [sp.sympify(value) for freedom in free for value in initial.coordinates(freedom)]
    q += [state.start for state in of.kin.drive_states]
    q += [sp.sympify(state.start) for state in of.scene.states.values()]
    u = [sp.sympify(value) for freedom in free for value in initial.speeds(freedom)]
    return system.function(
        "start", "Coordinates and speeds at t = 0.", "p", vector("q", of.coordinates, q), vector("u", of.speeds, u)
    )


def joint_scales(system: System, joints: Joints) -> Function:
    """Scales of joint coordinates and speeds, for assembly at the start."""
    sizes = joints.scene.scales.by_unit
    return system.function(
        "joint_scales",
        "Scales of the joints' coordinates and speeds.",
        "p",
        vector("sq", joints.coordinates, coordinate_sizes(joints.scene, joints.coordinates)),
        vector("su", joints.speeds, [sizes[unit] for _, unit in joints.speeds]),
    )


def placed_bodies(system: System, joints: Joints) -> Function:
    """Body coordinates and speeds from those of the joints."""
    q, u = placed(joints.absolute, joints.kin, system.kin)
    return system.function(
        "placed",
        "Coordinates and speeds of the bodies, from those of the joints.",
        "t joints joint_speeds c",
        system.of_coordinates("q", q),
        system.of_speeds("u", u),
    )
