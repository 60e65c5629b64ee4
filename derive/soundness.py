"""What is wrong with a scene: every fault of its declarations at once, found before anything is derived.

In order: types, topology, effects, start, parameters, quantities. A stage that needs sound input from an earlier one looks only at what is sound.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import sympy as sp

from hertzwerk.derive.dimension import Dimension, check
from hertzwerk.derive.effects.drives import Drive
from hertzwerk.derive.effects.expression import Varying, as_choice, expression_faults, smoothness_faults, table_faults
from hertzwerk.derive.effects.faults import element_faults, type_faults
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.laws.law import BoundLaw, Law
from hertzwerk.derive.mechanism import (
    GROUND,
    Body,
    CornerOnFace,
    CustomPair,
    Direction,
    Frame,
    Free,
    Ground,
    Joint,
    Mechanism,
    PinInBush,
    Planar,
    Point,
    Slot,
    Universal,
    Weld,
)
from hertzwerk.derive.pairs import Posed, PoseSymbol
from hertzwerk.derive.parameter import Parameter, default_value, dimensions_of, is_number, parameters_of
from hertzwerk.derive.units import parse_unit, unit_text
from hertzwerk.derive.vectors import along, apply, cross, sub

if TYPE_CHECKING:
    from hertzwerk.derive.scene import Scene


def faults_of(scene: Scene) -> tuple[Fault, ...]:
    """Every fault of a scene, each once."""
    wrong_types = tuple(_type_faults(scene))
    if wrong_types:
        return tuple(dict.fromkeys(wrong_types))
    found: list[Fault] = [
        *_length_faults(scene),
        *_topology_faults(scene.mechanism),
        *_effect_faults(scene),
        *_start_faults(scene),
    ]
    if not scene.name.isidentifier():
        found.append(Fault("scene", f"the name {scene.name!r}", "a Python identifier"))
    parameters, broken = _declared(scene)
    found.extend(broken)
    sound = _sound(parameters, broken)
    table = dimensions_of(sound)
    freedoms = {freedom.key: freedom for freedom in scene.mechanism.freedoms if freedom.scalar}
    for slot in scene.slots():
        if not all(sound.get(parameter.name) == parameter for parameter in parameters_of(slot.value)):
            continue
        if isinstance(slot, Posed):
            found.extend(_posed_faults(slot, table))
        elif isinstance(slot, Varying):
            found.extend(expression_faults(slot, freedoms, table, partial(_quantity_faults, table=table)))
        else:
            found.extend(_quantity_faults(slot, table))
    found.extend(_inertia_faults(scene.mechanism, sound))
    found.extend(table_faults(_expressions(scene)))
    return tuple(dict.fromkeys(found))


def _expressions(scene: Scene) -> Iterator[Any]:
    """Of every quantity; of effects on joints that are not there too."""
    yield from (slot.value for slot in scene.slots())
    yield from (value for effect in scene.effects if hasattr(effect, "joint") for value in vars(effect).values())


# -- types -------------------------------------------------------------------------------------------------------------


def _type_faults(scene: Scene) -> Iterator[Fault]:
    if scene.coordinates not in ("tree", "absolute", "auto"):
        yield Fault("coordinates", repr(scene.coordinates), "'tree', 'absolute' or 'auto'")
    for effect in scene.effects:
        if not hasattr(effect, "kind") or not hasattr(effect, "name"):
            yield Fault(
                "effects",
                repr(effect),
                "an effect, such as Gravity(...), Contact(...), JointSpring(...), Drive(...), EnergyLedger()",
            )
        else:
            yield from type_faults(effect)
    if not hasattr(scene.scales, "length"):
        yield Fault("scales", repr(scene.scales), "Scales(length=..., speed=...)")
    for joint in scene.mechanism.joints:
        where = f"joint {joint.name}"
        yield from _is(where, "parent", joint.parent.body, Body | Ground, "a Body, GROUND, or a point of one")
        yield from _is(where, "child", joint.child.body, Body | Ground, "a Body or a point of one")
        for point in (joint.parent, joint.child):
            yield from _three(f"{where}, point", point.position)
    for body in scene.mechanism.bodies:
        yield from _three(f"body {body.name}, mass centre", body.centre)
        if isinstance(body.inertia, tuple):
            yield from _three(f"body {body.name}, inertia", body.inertia)
    for pair in scene.mechanism.pairs:
        where = f"pair {pair.name}"
        for place in pair.places:
            yield from _is(where, "place", place, Point, "a point of a body: body.at(x, y, z)")
            if isinstance(place, Point):
                yield from _three(f"{where}, point", place.position)
        if isinstance(pair, CustomPair):
            yield from _three(f"{where}, normal", pair.normal)
            yield from _three(f"{where}, contact point", pair.contact_point)
    for where, direction in _directions(scene):
        yield from _direction_faults(where, direction)
    for effect in scene.of_kind("contact"):
        yield from _law_faults(effect.name, "stiffness", effect.stiffness)
        if effect.damping is not None:
            yield from _law_faults(effect.name, "damping", effect.damping)
    lawful: list[Any] = [effect for effect in scene.effects if hasattr(effect, "takes")]
    for effect in lawful:
        yield from _law_faults(effect.name, effect.takes, effect.law)


def _direction_faults(where: str, value: Any) -> Iterator[Fault]:
    if not isinstance(value, Direction):
        yield Fault(where, repr(value), "a Direction, such as X, -Y or Direction((1, 0, 1))")
    elif not (
        isinstance(value.components, tuple) and len(value.components) == 3 and all(map(is_number, value.components))
    ):
        yield Fault(where, repr(value.components), "three numbers or expressions of parameters of one unit")


def _length_faults(scene: Scene) -> Iterator[Fault]:
    """Directions that point nowhere."""
    for where, direction in _directions(scene):
        if not _points(direction):
            yield Fault(where, "a direction of length 0", "one that points somewhere",
                        "Its components are ratios: Direction((1, 0, 1)) lies between X and Z.")  # fmt: skip


def _directions(scene: Scene) -> Iterator[tuple[str, Any]]:
    """Every direction that is declared, and where."""
    for joint in scene.mechanism.joints:
        yield from ((f"joint {joint.name}, {name}", direction) for name, direction in joint.directions.items())
        for point in (joint.parent, joint.child):
            if isinstance(point, Point):
                yield from ((f"joint {joint.name}, turned point, axis", direction) for direction, _ in point.turns)
    for pair in scene.mechanism.pairs:
        if not isinstance(pair, CustomPair):
            named = ((name, getattr(pair, name, None)) for name in ("normal", "axis", "along"))
            yield from ((f"pair {pair.name}, {name}", direction) for name, direction in named if direction is not None)
    yield from ((f"effect {effect.name}, direction", effect.direction) for effect in scene.of_kind("gravity"))


def _points(direction: Direction) -> bool:
    return any(default_value(component) != 0 for component in direction.components)


def _is(where: str, what: str, value: Any, kind: Any, expected: str) -> Iterator[Fault]:
    if not isinstance(value, kind):
        yield Fault(f"{where}, {what}", repr(value), expected)


def _three(where: str, values: Any) -> Iterator[Fault]:
    if not isinstance(values, tuple) or len(values) != 3:
        yield Fault(where, repr(values), "three values, (x, y, z)")


def _law_faults(effect: str, kind: str, bound: Any) -> Iterator[Fault]:
    where = f"effect {effect}, {kind}"
    if isinstance(bound, Law):
        names = ", ".join(parameter.name for parameter in bound.parameters)
        yield Fault(where, f"law {bound.name} without its parameters", f"{bound.name}({names})")
    elif not isinstance(bound, BoundLaw):
        yield Fault(where, repr(bound), f"a {kind} law with its parameters")
    elif bound.law.kind != kind:
        yield Fault(where, f"{bound.law.name}, a {bound.law.kind} law", f"a {kind} law")


# -- topology ----------------------------------------------------------------------------------------------------------


def _topology_faults(mechanism: Mechanism) -> Iterator[Fault]:
    if not mechanism.name.isidentifier():
        yield Fault("mechanism", f"the name {mechanism.name!r}", "a Python identifier")
    yield from _repeated("joint", [joint.name for joint in mechanism.joints])
    yield from _repeated("pair", [pair.name for pair in mechanism.pairs])
    yield from _connection_faults(mechanism)
    for joint in mechanism.joints:
        yield from _axis_faults(joint)
    for joint in mechanism.closures:
        if isinstance(joint, Free):
            yield Fault(f"joint {joint.name}", f"a free joint to {joint.child.body.name}, which another joint carries", "one that closes the loop",
                        "A free joint forbids nothing: leave it out, or declare it first.")  # fmt: skip
    for pair in mechanism.pairs:
        for point in pair.places:
            if point.body != GROUND and mechanism.joint_of(point.body) is None:
                yield Fault(f"pair {pair.name}", f"body {point.body.name}", "a body that a joint connects")
        if isinstance(pair, PinInBush) and _points(pair.axis) and along(pair.axis.unit) is None:
            yield Fault(f"pair {pair.name}", f"the axis {pair.axis.components}", "X, Y, Z or the opposite of one",
                        "Turn the bush: body.at(...).turned(axis, angle).")  # fmt: skip
        if isinstance(pair, CornerOnFace):
            yield from _face_faults(pair)
        first, second = (place.body for place in pair.places)
        if first == second:
            yield Fault(f"pair {pair.name}", f"both sides on {first.name}", "two different bodies")
        elif _rigid_root(mechanism, first) == _rigid_root(mechanism, second):
            yield Fault(
                f"pair {pair.name}",
                f"{first.name} and {second.name}, which are welded",
                "bodies that can move against each other",
            )


def _face_faults(pair: CornerOnFace) -> Iterator[Fault]:
    """A face that ends needs a direction in it, and a length."""
    if (pair.along is None) != (pair.length is None):
        found = "a length without a direction along the face" if pair.along is None else "a direction without a length"
        yield Fault(f"pair {pair.name}", found, "both, for a face that ends, or neither")
    if pair.along is not None:
        normal, along_face = ([default_value(part) for part in axis.unit] for axis in (pair.normal, pair.along))
        cosine = sum(a * b for a, b in zip(normal, along_face, strict=True))
        if abs(cosine) > 1e-9:
            yield Fault(
                f"pair {pair.name}, along", f"a direction at a cosine of {cosine:.3g} to the normal", "one square to it"
            )


def _axis_faults(joint: Joint) -> Iterator[Fault]:
    """Axes that leave a joint fewer freedoms than it claims, or that it cannot take."""
    where = f"joint {joint.name}"
    if isinstance(joint, Universal):
        first, second = ([default_value(component) for component in axis.unit] for axis in (joint.first, joint.second))
        cosine = sum(a * b for a, b in zip(first, second, strict=True))
        if abs(cosine) > 1 - 1e-9:
            yield Fault(where, "two parallel axes", "axes that are not parallel",
                        "One rotation about one axis is a Revolute.")  # fmt: skip
    if isinstance(joint, Planar) and _points(joint.normal) and along(joint.normal.unit) is None:
        yield Fault(where, f"the normal {joint.normal.components}", "X, Y, Z or the opposite of one",
                    "Turn the joint's points: parent.at(...).turned(axis, angle).")  # fmt: skip


def _connection_faults(mechanism: Mechanism) -> Iterator[Fault]:
    reached: list[Frame] = [GROUND]
    names: dict[str, Body] = {}
    for joint in mechanism.joints:
        where, child, parent = f"joint {joint.name}", joint.child.body, joint.parent.body
        if not isinstance(child, Body):
            yield Fault(where, "the ground as child", "a body", "Give the ground as the parent.")
            continue
        if child not in reached and names.setdefault(child.name, child) != child:
            yield Fault(where, f"a second body named {child.name}", "names that are unique", "Rename one of them.")
        if parent == child:
            yield Fault(where, f"{child.name} as parent and child", "two different bodies")
        elif parent not in reached:
            declared = any(parent == other.child.body for other in mechanism.joints)
            yield Fault(
                where,
                f"parent {parent.name}, " + ("declared later" if declared else "which is not in the mechanism"),
                "the ground or a body of an earlier joint",
                "Put the joints in order from the ground outwards."
                if declared
                else f"Connect {parent.name} to the ground by a joint of its own.",
            )
        reached.append(child)


def _inertia_faults(mechanism: Mechanism, sound: dict[str, Parameter]) -> Iterator[Fault]:
    """A body turned about its mass centre needs an inertia about the axis; the rest of a principal triple may be zero in plane motion. The last of
    a chain needs a mass, and an inertia about every axis where it may turn in every way."""
    if any(True for _ in _connection_faults(mechanism)):
        return
    loaded = {
        _rigid_root(mechanism, body) for body in mechanism.bodies if not (is_number(body.mass) and body.mass == 0)
    }
    moved = [joint for joint in mechanism.joints if not isinstance(joint, Weld)]
    carriers = {_rigid_root(mechanism, joint.parent.body) for joint in moved}
    alone = {joint.parent.body for joint in mechanism.joints}
    for body in mechanism.bodies:
        root = _rigid_root(mechanism, body)
        if body == root and body not in carriers and body not in loaded:
            yield Fault(f"body {body.name}, mass", "0 kg at the end of a chain", "a value in (0, inf), because nothing beyond it has a mass",
                        "Give it a mass, or leave it out.")  # fmt: skip
        if body.mass == 0:
            continue
        given = (body.mass, *body.centre, *(body.inertia if isinstance(body.inertia, tuple) else (body.inertia,) * 3))
        if not all(is_number(v) and all(sound.get(p.name) == p for p in parameters_of(v)) for v in given):
            continue
        zero = [default_value(value) == 0 for value in given[4:]]
        for axis in _turning_axes(mechanism, body):
            if axis is None and body == root and body not in {*carriers, *alone} and _spins_freely(mechanism, body):
                yield Fault(f"body {body.name}", "inertia 0 about an axis through its joint",
                            "a positive one about every axis, because the joint lets the body turn in every way",
                            "Body(name, mass, (J_x, J_y, J_z)), or a Universal joint, which does not let it turn about itself.")  # fmt: skip
            elif (
                axis is not None
                and _points(axis)
                and all(zero[k] for k in range(3) if axis.components[k] != 0)
                and not _swings(mechanism, body, axis)
            ):
                yield Fault(
                    f"body {body.name}",
                    "inertia 0",
                    "a positive inertia about the joint's axis, because the body rotates",
                    "Body(name, mass, inertia) about the mass centre, or a joint beside it.",
                )


def _rigid_root(mechanism: Mechanism, body: Frame) -> Frame:
    """The first of the bodies that are welded to each other, from the ground outwards."""
    joint = mechanism.joint_of(body)
    return _rigid_root(mechanism, joint.parent.body) if isinstance(joint, Weld) else body


def _spins_freely(mechanism: Mechanism, body: Body) -> bool:
    """Whether a body has no inertia about some axis through its joint's point, at the defaults."""
    joint = mechanism.joint_of(body)
    at = joint.child.position if joint is not None else (0, 0, 0)
    arm = [default_value(c) - default_value(p) for c, p in zip(body.centre, at, strict=True)]
    own = [default_value(J) for J in (body.inertia if isinstance(body.inertia, tuple) else (body.inertia,) * 3)]
    mass, square = default_value(body.mass), sum(x * x for x in arm)
    about = sp.Matrix(3, 3, lambda i, j: (own[i] + mass * square) * (i == j) - mass * arm[i] * arm[j])
    return bool(about.det() <= 1e-12 * about.trace() ** 3)


def _swings(mechanism: Mechanism, body: Body, axis: Direction) -> bool:
    """Whether the joint that carries a body turns it about an axis that misses its mass centre: then it needs no inertia of its own."""
    joint = mechanism.joint_of(body)
    if joint is None or all(freedom.kind == "slide" for freedom in joint.freedoms):
        return False
    arm = sub(body.centre, joint.child.position)
    turned = apply(joint.child.axes, axis.unit)
    return any(default_value(component) != 0 for component in cross(arm, turned))


def _turning_axes(mechanism: Mechanism, body: Frame) -> list[Direction | None]:
    """Axis of the last turn of the nearest joint that turns a body, in the joint's axes; None if that is every axis; empty if nothing turns it."""
    joint = mechanism.joint_of(body)
    if joint is None:
        return []
    turning = [freedom.axis for freedom in joint.freedoms if freedom.kind != "slide"]
    return turning[-1:] or _turning_axes(mechanism, joint.parent.body)


# -- effects and start -------------------------------------------------------------------------------------------------


def _effect_faults(scene: Scene) -> Iterator[Fault]:
    yield from _repeated("effect", [effect.name for effect in scene.effects])
    pairs = [pair.name for pair in scene.mechanism.pairs]
    contacts = [effect.pair for effect in scene.of_kind("contact")]
    for effect in scene.effects:
        yield from element_faults(effect, scene.mechanism)
    paired: list[Any] = [effect for effect in scene.effects if hasattr(effect, "pair")]
    for effect in paired:
        if effect.kind != "friction" and effect.pair not in pairs:
            offer = ", ".join(pairs) or "no pair is declared"
            yield Fault(f"effect {effect.name}", f"pair {effect.pair!r}", f"one of {offer}")
    for effect in scene.of_kind("friction"):
        if effect.pair not in contacts:
            yield Fault(f"effect {effect.name}", f"pair {effect.pair!r} without a contact", f"one of {', '.join(contacts) or 'none'}",
                        "Friction needs a normal force: leave it out too, or add the pair's Contact.")  # fmt: skip
    for effect in paired:
        yield from _geometry_faults(effect, scene.geometry(effect.pair))
        yield from _demand_faults(
            effect, next((pair.kind for pair in scene.mechanism.pairs if pair.name == effect.pair), None)
        )
    drives = [effect.joint for effect in scene.of_kind("drive")]
    yield from _twice("drive of joint", drives)
    for kind in dict.fromkeys(effect.kind for effect in paired if effect.kind != "contact"):
        yield from _twice(f"{kind} of pair", [effect.pair for effect in scene.of_kind(kind)])
    for kind in ("ledger", "gravity"):
        if len(scene.of_kind(kind)) > 1:
            yield Fault("effects", f"{len(scene.of_kind(kind))} of kind {kind}", "at most one")
    if all(freedom.key in drives for freedom in scene.mechanism.freedoms):
        found = "a drive on every joint" if scene.mechanism.freedoms else "no joint that can move"
        yield Fault("effects", found, "at least one joint that is free to move")


def _geometry_faults(effect: Any, offered: dict[str, Any]) -> Iterator[Fault]:
    for bound in getattr(effect, "laws", ()):
        for quantity in bound.law.geometry():
            if offered and quantity.name not in offered:
                yield Fault(f"effect {effect.name}", f"a pair without {quantity.name}, {quantity.meaning}",
                            f"one that has it, because {bound.law.name} asks for it",
                            "Line contacts need a length: PinInBush(..., length=...), ParallelCylinders, CylinderOnPlane; "
                            "edges and corners have no radius: power(K, n) does without one.")  # fmt: skip


def _demand_faults(effect: Any, kind: str | None) -> Iterator[Fault]:
    """What laws ask of a scene beyond units and geometry: the pair they were made for."""
    for law in (bound.law for bound in getattr(effect, "laws", ())):
        if law.pairs and kind is not None and kind not in law.pairs:
            expected = f"the pair it was made for, {' or '.join(law.pairs)}"
            yield Fault(f"effect {effect.name}", f"law {law.name} at a {kind} pair", expected)


def _start_faults(scene: Scene) -> Iterator[Fault]:
    of_joints = [freedom.key for freedom in scene.free if freedom.scalar]
    for given, ports in (("position", "coordinates"), ("speed", "speeds")):
        full = [port.name for freedom in scene.free for port in getattr(freedom, ports)]
        short = [name for name in full if name.rsplit(".", 1)[0] not in of_joints]
        for name in getattr(scene.start, given):
            if name not in (*of_joints, *full):
                closing = name.split(".")[0] in [joint.name for joint in scene.mechanism.closures]
                driven = "driven, its motion is the drive's" if name in scene.driven else "unknown"
                why = "closes a loop, its motion follows" if closing else driven
                yield Fault("start", f"{given} of joint {name!r} ({why})", f"one of {', '.join((*of_joints, *short))}")
    # a drive that is integrated keeps a coordinate of its own
    moving = [
        freedom
        for freedom in scene.mechanism.freedoms
        if freedom in scene.free or _integrates(scene.driven[freedom.key])
    ]
    if scene.scales.arm is None and any(freedom.kind != "slide" for freedom in moving):
        yield Fault("scales", "no arm", "an arm [m], because the scene has angles",
                    "Scales(length=..., speed=..., arm=...): an angle is measured as length/arm.")  # fmt: skip


def _integrates(drive: Any) -> bool:
    return isinstance(drive, Drive) and drive.position is None


# -- parameters and quantities -----------------------------------------------------------------------------------------


def _declared(scene: Scene) -> tuple[dict[str, Parameter], list[Fault]]:
    """Parameters by name, and what is wrong with their declarations."""
    seen: dict[str, Parameter] = {}
    found: list[Fault] = []
    for parameter in (p for slot in scene.slots() for p in parameters_of(slot.value)):
        where = f"parameter {parameter.name}"
        if seen.setdefault(parameter.name, parameter) != parameter:
            found.append(Fault(where, "two different parameters of this name", "names that are unique",
                               "Share one Parameter object, or rename one."))  # fmt: skip
        found.extend(parameter.faults())
    readable = [p for p in seen.values() if not any(fault.where == f"parameter {p.name}" for fault in found)]
    for parameter in readable:
        found.extend(_exponent_faults(parameter, seen))
    return seen, found


def _exponent_faults(parameter: Parameter, seen: dict[str, Parameter]) -> Iterator[Fault]:
    for name in parameter.parsed_unit.free_names:
        where, found = f"parameter {parameter.name}", f"unit {parameter.unit} with the exponent {name}"
        if name not in seen:
            yield Fault(where, found, "a parameter of the scene as exponent",
                        f"Declare Parameter({name!r}, '1', ...) and use it.")  # fmt: skip
        elif seen[name].unit != "1":
            yield Fault(where, f"{found}, which is in {seen[name].unit}", "an exponent whose unit is 1")


def _sound(parameters: dict[str, Parameter], broken: list[Fault]) -> dict[str, Parameter]:
    """The parameters without a fault, of their own or of one that stands in their unit's exponent."""
    wrong = {fault.where for fault in broken}
    good = {name: p for name, p in parameters.items() if f"parameter {name}" not in wrong}
    return {name: p for name, p in good.items() if all(other in good for other in p.parsed_unit.free_names)}


def _quantity_faults(slot: Slot, table: dict[sp.Symbol, Dimension]) -> Iterator[Fault]:
    """Kind, unit and range of what was given for one quantity."""
    if not is_number(slot.value):
        yield Fault(slot.where, repr(slot.value), "a Parameter, an expression of parameters, or a number",
                    "A quantity with a unit is declared: Parameter(name, unit, value).")  # fmt: skip
        return
    value, unit = sp.sympify(slot.value), parse_unit(slot.unit)
    strangers = [
        str(node) for node in sp.preorder_traversal(value) if node.is_Symbol and not isinstance(node, Parameter)
    ]
    if strangers:
        yield Fault(slot.where, f"the symbol {strangers[0]}", "an expression of Parameters alone")
        return
    if value.is_number and value != 0 and not unit.dimensionless:
        yield Fault(slot.where, f"the bare number {slot.value}", f"a quantity in {slot.unit}",
                    f"Give it a name and a unit: Parameter('...', {slot.unit!r}, {slot.value}).")  # fmt: skip
        return
    if not value.is_number and not unit.free_names:
        fault = check(value, table, Dimension.from_unit(unit, {}), list(table))
        if fault is not None:
            yield Fault(slot.where, f"{fault.subexpression} [{fault.found}]", f"a quantity in {unit_text(unit.exponents)}",
                        fault.repair or fault.reason)  # fmt: skip
            return
    number = default_value(value)
    if not math.isfinite(number):
        yield Fault(slot.where, f"{value}, which at the defaults is no finite real number", "a finite number")
    elif slot.limit is not None and not slot.limit.holds(number):
        shown = f"{number:g}" if unit.dimensionless else f"{number:g} {unit_text(unit.exponents)}"
        yield Fault(slot.where, shown, f"a value in {slot.limit}")


def _posed_faults(slot: Posed, table: dict[sp.Symbol, Dimension]) -> Iterator[Fault]:
    """Of an expression of the pose of a user's pair."""
    if not is_number(slot.value):
        yield Fault(slot.where, repr(slot.value), "a number, or an expression of APART, TURN and parameters")
        return
    value = as_choice(slot.value)
    pose = {
        node: Dimension.from_unit(node.unit) for node in sp.preorder_traversal(value) if isinstance(node, PoseSymbol)
    }
    if not pose:
        yield from _quantity_faults(slot, table)
        return
    strangers = sorted(str(s) for s in value.free_symbols if not isinstance(s, Parameter | PoseSymbol))
    if strangers:
        yield Fault(
            slot.where, f"the symbol {', '.join(strangers)}", "an expression of APART, TURN and Parameters alone"
        )
        return
    unit = parse_unit(slot.unit)
    fault = check(value, {**table, **pose}, Dimension.from_unit(unit, {}), list(table))
    if fault is not None:
        yield Fault(
            slot.where,
            f"{fault.subexpression} [{fault.found}]",
            f"a quantity in {slot.unit}",
            fault.repair or fault.reason,
        )
        return
    yield from smoothness_faults(slot, value)


def _repeated(kind: str, names: Iterable[str]) -> Iterator[Fault]:
    names = list(names)
    for name in dict.fromkeys(names):
        if not name.isidentifier():
            yield Fault(kind, f"the name {name!r}", "a Python identifier")
        if names.count(name) > 1:
            yield Fault(
                f"{kind} {name}", f"{names.count(name)} of this name", "names that are unique", "Rename one of them."
            )


def _twice(what: str, names: list[str]) -> Iterator[Fault]:
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            yield Fault(f"{what} {name}", f"{names.count(name)}", "one")
