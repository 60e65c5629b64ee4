"""Tables of a module: names, units and roles of its vectors' entries, and facts about the scene."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.audit import advice_findings
from hertzwerk.derive.declare.effects.nonholonomic import RollingWithoutSlip
from hertzwerk.derive.declare.effects.state_expression import tables_in
from hertzwerk.derive.declare.mechanism.joints.joint import Port
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.output_functions import output_rows, posed_names
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.expressions.parameter import Interval, Parameter
from hertzwerk.derive.program.expression_text import table_name

NO_PAIR = -1
"""In SLIPS, of the friction of a joint."""


def tables(system: System) -> Mapping[str, Any]:
    """Name of a table -> its rows, in the order of the module's text."""
    scene = system.scene
    pairs = {pair.pair.name: i for i, (pair, _, _) in enumerate(system.contacts)}
    entries = {name: i for i, (name, _) in enumerate(system.memory)}
    meanings = meanings_of(scene)
    used = dict.fromkeys(table for slot in scene.slots() for table in tables_in(slot.value))
    return {
        "EFFECTS": tuple((effect.name, effect.kind, effect.text) for effect in scene.effects),
        "UNCHECKED": tuple((e.name, e.text) for e in scene.effects if e.unchecked),
        "CONTRADICTIONS": scene.mechanism.contradictions,
        "ADVICE": tuple(finding.reason for finding in advice_findings(scene)),
        "PARAMETERS": tuple(
            (p.name, p.unit, p.default, p.meaning or meanings.get(p.name, "")) for p in scene.parameters.values()
        ),
        "LIMITS": tuple(_limits(scene)),
        "SUM_LIMITS": _sum_limits(scene),
        # the last entries of c are their pieces, in this order
        "INPUTS": tuple((signal.name, signal.unit, signal.meaning) for signal in scene.inputs.values()),
        # derivatives that must be continuous: how many, and for what
        "SMOOTH_INPUTS": tuple((name, order, slot.where) for name, (order, slot) in scene.smooth_inputs.items()),
        "COORDINATES": tuple((name, unit) for name, unit in system.coordinates),
        "QUATERNIONS": _quaternions(system.coordinates),
        "SPEEDS": tuple((name, unit) for name, unit in system.speeds),
        "MEMORY": tuple(system.memory),
        "LATCHES": tuple((f"{name}.approach_speed", "m/s", pairs[name]) for name in system.latches),
        "PAIRS": tuple((pair.pair.name, pair.pair.kind) for pair, _, _ in system.contacts),
        "EVENTS": _events(system),
        **_loads(system),
        "GUIDES": tuple(contact.pair.name for contact, _, _ in system.contacts if contact.pair.guides),
        "SLIPS": _slips(system),
        "RELEASES": tuple("force" if c.damping is None else c.damping.law.release for _, c, _ in system.contacts),
        "DISSIPATED": tuple(entries[f"{name}.dissipated"] for name in pairs) if scene.ledger else (),
        **_loop_tables(system),
        "BRISTLES": tuple(_bristle_rows(system)),
        "OUTPUTS": tuple((name, unit) for name, unit, _ in output_rows(system)),
        "SPEED_LIMITED": tuple(system.limited),
        "BODIES": posed_names(scene.mechanism),
        "LANDMARKS": tuple(landmark.row for landmark in system.landmarks),
        "FAMILIES": (),
        **({"WORN": _worn(system)} if system.worn else {}),
        **{table_name(table): table.pieces() for table in used},
    }


def _events(system: System) -> tuple[Any, ...]:
    """Table of events of effects: their names, and the entries of q that each changes."""
    entries = [name for name, _ in system.coordinates]
    return tuple(
        (f"{effect}.{event.name}", tuple(entries.index(f"{effect}.{state}") for state in event.then))
        for effect, event in system.events
    )


def _loads(system: System) -> dict[str, tuple[Any, ...]]:
    """Tables of joints whose reactions loads depend on, and of friction that changes these.

    FED: places of these among the reactions. RUBBING: places of a joint's friction among the forces, of its coefficient where it
    slides and of its force where it sticks, and of the coefficient among the reactions.
    """
    names = tuple(joint for joint, *_ in system.kin.carried)
    if not system.feeds or system.carried is None:
        return {"LOADS": names, "FED": (), "RUBBING": ()}
    places = {key: i for i, key in enumerate(row.key for row in system.rows)}
    own = [s for s, group in system.tape.inputs.items() if group == "reactions" and s not in system.supplied]
    first = len(system.driven)
    carried = tuple(first + own.index(symbol) for symbol in system.carried.read)
    rubbing = tuple(
        (name, places[f"{name}.coefficient"], places[f"{name}.holding"], first + own.index(system.kin.rubbing[name][0]))
        for name, _ in system.rubbing
    )
    return {"LOADS": names, "FED": carried, "RUBBING": rubbing}


def _slips(system: System) -> tuple[Any, ...]:
    """Table of the friction with modes: its entries of m, after LATCHES, and the pair.

    In one direction the sign of the sliding or angular velocity, else a vector along the pair's two tangents.
    """
    rows: list[tuple[str, str, int]] = []
    for j, (pair, _, friction) in enumerate(system.contacts):
        if friction is not None and friction.law.law.modes:
            rows += _directions(f"{pair.pair.name}.slip", "m/s", j, pair.slides_along)
        for effect in system.scene.resistances(pair.pair.name):
            if effect.has_modes:
                unit = "m/s" if effect.holds == "N" else "rad/s"
                rows += _directions(f"{effect.name}.{effect.mode}", unit, j, len(effect.axes(pair.touch)))
    rows += [(f"{name}.slip", "1", NO_PAIR) for name, _ in system.rubbing]
    return tuple(rows)


def _directions(name: str, unit: str, pair: int, count: int) -> list[tuple[str, str, int]]:
    """Rows of a slip in one direction, a sign, or in several."""
    return [(name, "1", pair)] if count == 1 else [(f"{name}_{i}", unit, pair) for i in range(1, count + 1)]


def _bristle_rows(system: System) -> Iterator[tuple[int, int]]:
    """Entry of z and pair of every bristle."""
    entries = {name: i for i, (name, _) in enumerate(system.memory)}
    for j, (_, _, friction) in enumerate(system.contacts):
        if friction is not None and friction.name in system.bristles:
            yield from ((entries[name], j) for name in system.bristles[friction.name])


def _loop_tables(system: System) -> dict[str, Any]:
    """Constraints, and values of the start that are not found by assembly: None where none is."""
    joints = system.joints
    of = system if joints is None else joints
    rolling = tuple((effect.name, effect.coefficient is not None) for effect in system.scene.all(RollingWithoutSlip))
    stated = [name for freedom in of.scene.free for name in of.scene.start.stated(freedom)]
    assembled = of.loops or (joints is None and rolling) or any(pair.pair.journal for pair, _, _ in system.contacts)
    return {
        "CONSTRAINTS": _names(system.loops),
        "ROLLING": rolling,
        "GIVEN": (*stated, *(state.port.name for state in of.kin.drive_states), *of.scene.states)
        if assembled
        else None,
        "SEATED": tuple(pair.name for pair in of.scene.mechanism.pairs) if of.scene.start.seated else (),
        "JOINT_COORDINATES": None if joints is None else tuple(map(tuple, joints.coordinates)),
        "JOINT_SPEEDS": None if joints is None else tuple(map(tuple, joints.speeds)),
        "JOINT_QUATERNIONS": None if joints is None else _quaternions(joints.coordinates),
        "JOINT_CONSTRAINTS": None if joints is None else _names(joints.loops),
    }


def _worn(system: System) -> tuple[tuple[int, int], ...]:
    """Entries of q whose rates are those of wear, each with its place among the forces."""
    entries, first = [name for name, _ in system.coordinates], len(system.rows) - len(system.worn)
    return tuple((entries.index(row.key), first + i) for i, row in enumerate(system.worn))


def _names(loops: tuple[Constraint, ...]) -> tuple[tuple[str, str], ...]:
    return tuple((row.name, row.unit) for row in loops)


def _quaternions(ports: list[Port]) -> tuple[int, ...]:
    """Indices at which quaternions begin."""
    return tuple(i for i, port in enumerate(ports) if port.name.endswith(".q0"))


def _limits(scene: Scene) -> list[tuple[Any, ...]]:
    """Ranges of parameters: (parameter, kind, lower, upper, lower open, upper open, reason).

    For parameters that are by themselves the value of a quantity.
    """
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


def _sum_limits(scene: Scene) -> tuple[Any, ...]:
    """Table of ranges of sums of parameters.

    Its rows are those of LIMITS, with (parameter, factor) of each term in place of the parameter.

    A pin's radius is such a sum. Scales need none: where one is not positive, a run finds its own.
    """
    rows: dict[tuple[Any, ...], str] = {}
    of_scales = {slot.where for slot in scene.scales.slots()}
    for slot in scene.slots():
        limit = None if slot.where in of_scales else slot.limit
        terms = {} if limit is None else sp.sympify(slot.value).as_coefficients_dict()
        if limit is None or len(terms) < 2 or not all(isinstance(term, Parameter) for term in terms):
            continue
        ordered = sorted((term.name, float(factor)) for term, factor in terms.items())
        bounds = (limit.lower, limit.upper, limit.open_left, limit.open_right)
        rows.setdefault((tuple(ordered), "defined", *bounds), slot.where)
    return tuple((*row, where) for row, where in rows.items())


def meanings_of(scene: Scene) -> dict[str, str]:
    """Meaning of each parameter: as declared, or else the quantity it is the value of."""
    meanings: dict[str, str] = {}
    for slot in scene.slots():
        if isinstance(slot.value, Parameter):
            meanings.setdefault(slot.value.name, slot.value.meaning or slot.where)
    return meanings
