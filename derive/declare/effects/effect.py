"""Base classes of effects; each kind is a frozen dataclass with its declaration and its forces.

A user-defined kind of effect is one such class; the defaults are declared here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Protocol

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, one_of
from hertzwerk.derive.declare.effects.state_expression import (
    COORDINATE,
    REACTION,
    SPEED,
    Scope,
    states_in,
    uncounted_fault,
)
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, Frame, Ground, Point, measured
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.expressions.algebra.vectors import Matrix, Vector, apply
from hertzwerk.derive.expressions.parameter import Slot
from hertzwerk.derive.laws.law import BoundLaw, Law
from hertzwerk.derive.program.program import Tape

DISSIPATED, INPUT = "dissipated", "input"
APPLIED, CONTACT, NOWHERE = "applied", "contact", ""
FORCE, RADIAL, FRONT, REAR = "force", "radial force", "force of the front pad", "force of the rear pad"
"""Parts of a reaction: of a guide by two pads, a length apart, about the child's point."""

Mark = tuple[str, str, Point, Mapping[str, Any]]
"""Landmark of an effect: kind, place, point, and directions and sizes there."""


@dataclass(frozen=True)
class State:
    """State of an effect: name, unit, value at t = 0, and the size by which its errors are measured.

    Without a size it is the scene's scale of that unit: m, rad, m/s, rad/s, or 1 of a plain number.
    """

    name: str
    unit: str
    start: Any = sp.S.Zero
    size: Any = None


@dataclass(frozen=True)
class Event:
    """Change of an effect's states where its `margin` falls through zero, which a run locates.

    margin  expression, positive until the event; beside its `size`, of the same unit, it is located to the tolerance
    then    state -> its value from the event on, by the values before
    """

    name: str
    margin: Any
    size: Any
    then: Mapping[str, Any]


@dataclass(frozen=True)
class Rubbing:
    """Set-valued friction of a joint: sliding velocity [m/s], normal force [N], coefficients [1]."""

    velocity: Any
    pressing: Any
    kinetic: Any
    static: Any


@dataclass(frozen=True)
class Element:
    """Generalised forces by joint [N m or N], stored energy [J], powers [W] and outputs of an effect.

    The energy ledger books what is `dissipated` and put in as `input`; None where there is none. Outputs are (name,
    unit, expression). `rates` are those of its states; a state without one changes at `events` alone. `rubbing` is given for
    friction of a joint that sticks.
    """

    forces: Mapping[str, Any] = field(default_factory=dict)
    stored: Any = sp.S.Zero
    dissipated: Any = None
    input: Any = None
    outputs: tuple[tuple[str, str, Any], ...] = ()
    rates: Mapping[str, Any] = field(default_factory=dict)
    events: tuple[Event, ...] = ()
    rubbing: Rubbing | None = None

    @property
    def powers(self) -> dict[str, Any]:
        """Powers that the ledger books, by `DISSIPATED` and `INPUT`."""
        booked = ((DISSIPATED, self.dissipated), (INPUT, self.input))
        return {name: power for name, power in booked if power is not None}


@dataclass(frozen=True)
class SpeedConstraint:
    """Condition that a point of one body has no velocity along a direction against another body.

    name       name of the constraint, after the effect's
    direction  unit vector, and position of the point, in ground axes [1, m]
    bodies     the body and that against which it moves
    distance   length whose rate the velocity is, zero too; None where the velocity has no integral
    """

    name: str
    direction: Vector
    position: Vector
    bodies: tuple[Frame, Frame]
    distance: Any = None


class Declared(Scope, Protocol):
    """Protocol of the scene as needed by its effects."""

    @property
    def mechanism(self) -> Mechanism:
        """Bodies, joints, pairs."""

    @property
    def effects(self) -> tuple[Effect, ...]:
        """All effects, in declared order."""

    @property
    def scales(self) -> Any:
        """Scales of error tolerances: `length` [m] and `speed` [m/s]."""

    @property
    def driven(self) -> Mapping[str, Any]:
        """Drives by the key of the freedom they drive."""

    @property
    def start(self) -> Any:
        """Start: coordinates and speeds at t = 0."""

    def joint_of(self, key: str) -> Joint:
        """The joint that has a freedom."""

    def follows_drives(self, body: Frame) -> bool:
        """Whether drives alone move a body; true of the ground."""

    def geometry(self, pair: str) -> Mapping[str, Any]:
        """Geometry of a pair by name; empty for an unknown pair."""


class Journal(Protocol):
    """Protocol of a pin in its bush: places, the bush's centre, and from there to the pin's [m]."""

    pair: Any
    first: Point
    second: Point
    base: Vector
    apart: Vector

    @property
    def eccentricity(self) -> Vector:
        """Component of `apart` normal to the axis [m]."""

    def rate_at(self, position: Vector) -> Vector:
        """Velocity of the first body's point at `position` against the second body's [m/s]."""


class Moving(Protocol):
    """Protocol of a mechanism's kinematics as needed by conditions on its speeds.

    Vectors in ground axes, in SI, results named on the tape.
    """

    tape: Tape

    def point(self, point: Point, name: str) -> tuple[Vector, Vector, Vector]:
        """Position, velocity, acceleration of a point [m, m/s, m/s^2]."""

    def direction(self, point: Point, direction: Direction) -> Vector:
        """Unit vector of a direction given in a point's axes."""

    def touch(self, pair: str) -> Any:
        """Contact geometry of the pair of this name."""


class Turning(Protocol):
    """Protocol of a mechanism's kinematics as needed by moments between two bodies.

    Vectors in ground axes, in SI, results named on the tape.
    """

    tape: Tape

    def angular_velocity(self, body: Frame) -> Vector:
        """Angular velocity of a body [rad/s]."""

    def generalised(self, force: Vector, position: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces of a force on one body and its reaction on another at the same point."""

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces of a moment on one body and its reaction on another."""


class Kinematics(Moving, Turning, Protocol):
    """Protocol of a mechanism's kinematics as needed by its effects."""

    @property
    def scene(self) -> Declared:
        """The scene."""

    def expression(self, value: Any) -> Any:
        """An expression of a scene on the tape."""

    def coordinate(self, key: str) -> Any:
        """Coordinate of a freedom [rad or m]."""

    def speed(self, key: str) -> Any:
        """Rate of the coordinate [rad/s or m/s]."""

    def motion_of_freedom(self, freedom: Freedom) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """Coordinates and speeds of a freedom."""

    def state(self, name: str) -> Any:
        """State of an effect, `motor.current`."""

    def reaction(self, joint: str, part: str = FORCE, length: Any = None) -> Any:
        """Magnitude of the force that a joint carries, or of a part of it [N]."""

    def friction(self, effect: str) -> tuple[Any, Any]:
        """Coefficient [1], with its sign, of a friction that slides, and force [N] of one that sticks."""

    def on_joint(self, key: str, force: Any, name: str) -> dict[str, Any]:
        """Generalised forces of a force along a slide or a torque about a turn.

        It acts on the child, its reaction on the parent.
        """

    def rotation(self, body: Frame) -> Matrix:
        """Rotation matrix from a body's axes to the ground's."""

    def turned(self, body: Frame, k: int) -> Any:
        """Angle of a body against the ground about a coordinate axis, in plane motion [rad]."""

    def turn_between(self, first: Point, second: Point, name: str) -> tuple[Any, ...]:
        """Quaternion from the axes of one point to those of another."""

    def journal(self, pair: str) -> Journal:
        """The pin and bush of this name."""

    def along_track(self, joint: str) -> Any:
        """Parameter of a track's curve where its point is."""


class Effect:
    """Base class of effects; a kind has a `name`, unique in its scene, and a `kind`.

    takes       fields that hold a law -> the kind of law they take
    measures    fields that hold a quantity -> its unit and range, `Slot.of(unit, limit)`, or `Varying.of(unit, on=...)`
    reads       COORDINATE or SPEED of its joints; whole turns of loop-closing joints in space are counted where it is COORDINATE
    enters      function of a module that has its generalised forces: APPLIED, CONTACT, or NOWHERE for effects without
    quantities  words after its name -> letter, subscript, meaning of a quantity, for readers; `sought`: those shown by name
    unchecked   whether an inconsistent law may run
    """

    name: str
    kind: ClassVar[str]
    takes: ClassVar[Mapping[str, str]] = {}
    measures: ClassVar[Mapping[str, Slot]] = {}
    reads: ClassVar[str] = SPEED
    enters: ClassVar[str] = APPLIED
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = {}
    sought: ClassVar[tuple[str, ...]] = ()
    unchecked = False

    @property
    def text(self) -> str:
        """Description for people."""
        return self.kind.replace("_", " ")

    @property
    def where(self) -> str:
        """Its name in messages."""
        return f"effect {self.name}"

    @property
    def joints(self) -> tuple[str, ...]:
        """Keys of the freedoms it acts on."""
        return ()

    @property
    def pairs(self) -> tuple[str, ...]:
        """Names of the pairs it acts at."""
        return ()

    @property
    def points(self) -> tuple[Point, ...]:
        """Points it acts at."""
        return ()

    @property
    def frames(self) -> tuple[Frame, ...]:
        """Bodies that it acts on or whose axes it uses."""
        return tuple(point.body for point in self.points)

    @property
    def directions(self) -> Mapping[str, Direction]:
        """Directions by name."""
        return {}

    @property
    def laws(self) -> tuple[BoundLaw, ...]:
        """Laws in the order of their fields."""
        return tuple(law for law in (getattr(self, name) for name in self.takes) if law is not None)

    @property
    def section(self) -> str:
        """Title of the section with its laws in the equations for readers."""
        return ""

    @property
    def only(self) -> str:
        """Description of which only one may exist in a scene ("drive of joint crank"); "" for any number."""
        return ""

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield its quantities: of its laws, points and directions, then its `measures`.

        Called only if its joints are freedoms of the scene.
        """
        geometry = {name: value for pair in self.pairs for name, value in scene.geometry(pair).items()}
        for bound in self.laws:
            yield from bound.slots(self.where, geometry)
        for point in self.points:
            yield from point.slots()
        for name, direction in self.directions.items():
            yield from direction.slots(f"{self.where}, {name}")
        yield from measured(self, self.where, self.used, self.units(scene))

    @property
    def used(self) -> Mapping[str, Slot]:
        """Those of its `measures` that it uses, as declared."""
        return self.measures

    def units(self, scene: Declared) -> Mapping[str, str]:
        """Units by the names that stand for them in `measures`."""
        return {}

    def reactions(self, scene: Declared) -> Iterator[str]:
        """Yield the joints whose reaction it reads, by default in its expressions; called as `slots` is."""
        symbols = (symbol for slot in self.slots(scene) for symbol in states_in(slot.value))
        return (symbol.joint for symbol in symbols if symbol.quantity == REACTION)

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the states that it integrates, or changes at events; called as `slots` is."""
        return iter(())

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of fields of the wrong type, which prevent all other checks."""
        for point in self.points:
            if not isinstance(point, Point):
                yield Fault(self.where, repr(point), "a point of a body: body.at(x, y, z)")
            elif not isinstance(point.position, tuple) or len(point.position) != 3:
                yield Fault(self.where, f"point {point.position!r}", "three values, (x, y, z)")
        for name, kind in self.takes.items():
            bound = getattr(self, name)
            if bound is not None or getattr(type(self), name, self) is not None:  # None by default: it may be left out
                yield from _law_faults(f"{self.where}, {kind}", kind, bound)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of an effect that does not fit the scene, beyond quantities."""
        for body in self.frames:
            if body != GROUND and body not in scene.mechanism.bodies:
                names = [b.name for b in scene.mechanism.bodies]
                yield Fault(
                    self.where, f"body {body.name}", f"{one_of(names, 'a body of the mechanism')}, or the ground"
                )

    def element(self, kin: Kinematics) -> Element | None:
        """Forces, energy and outputs; None for effects that act in contact alone, or are handled elsewhere.

        Raises InputError for a kind that enters applied forces without an element.
        """
        if self.enters != APPLIED:
            return None
        actual = f"the kind {self.kind!r}, which has no element"
        raise InputError(self.where, [Fault(self.where, actual, "an effect with an element",
                         f"def element(self, kin): return Element(...), in {type(self).__name__}.")])  # fmt: skip

    def speed_constraints(self, kin: Moving) -> Iterator[SpeedConstraint]:
        """Yield the conditions that it holds by forces which do no work."""
        return iter(())

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the landmarks of a picture."""
        return iter(())


class JointEffect(Effect):
    """Effect on a `joint` with one coordinate, or on one of several: "column.angle".

    Units of its `measures` may contain {coordinate}, {speed} and {force}, those of the joint.

    drawn  whether a picture shows it on the joint
    """

    joint: str
    drawn: ClassVar[bool] = False

    @property
    def joints(self) -> tuple[str, ...]:
        """The joint."""
        return (self.joint,)

    def freedom(self, scene: Declared) -> Freedom:
        """The freedom it acts on."""
        return scene.scalars[self.joint]

    def units(self, scene: Declared) -> Mapping[str, str]:
        """Units of the joint."""
        return dict(zip(("coordinate", "speed", "force"), self.freedom(scene).units, strict=True))

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of a joint that is no name."""
        if not isinstance(self.joint, str):
            yield Fault(self.where, f"joint {self.joint!r}", "the name of a joint")
        yield from super().type_faults()

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a joint that is missing, or has not just one coordinate."""
        yield from joint_faults(self.where, self.joint, scene, counted=self.reads == COORDINATE)
        yield from super().faults(scene)

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the axis of a turn, or both points and the axis of a slide."""
        if not self.drawn or self.freedom(scene).axis is None:
            return
        kind = f"{self.freedom(scene).kind}_{self.kind}"
        place, point, axis = place_on_joint(scene, self.joint)
        yield kind, place, point, {"axis": axis}
        if self.freedom(scene).kind == "slide":
            yield kind, "child", scene.joint_of(self.joint).child, {}


class PairEffect(Effect):
    """Effect at a `pair`, which has at most one of each kind."""

    pair: str

    @property
    def pairs(self) -> tuple[str, ...]:
        """The pair."""
        return (self.pair,)

    def at_parts(self, parts: Sequence[str]) -> Iterator[PairEffect]:
        """Yield the effect at each part of its pair, with the part's ending behind its own name."""
        for part in parts:
            own: Any = {"name": self.name + part.removeprefix(self.pair)} if "name" in self.__dict__ else {}
            yield replace(self, pair=part, **own)  # type: ignore[type-var]  # a dataclass, as every kind is

    @property
    def only(self) -> str:
        """Description of one kind at a pair."""
        return f"{self.kind} of pair {self.pair}"

    @property
    def section(self) -> str:
        """Title of the contact's section."""
        return f"Contact {self.pair}"

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair that is missing, or not the kind a law was made for."""
        pairs = scene.mechanism.pair_named
        if self.pair not in pairs:
            yield Fault(self.where, f"pair {self.pair!r}", one_of(pairs, "a pair of the mechanism, which has none"))
            return
        kind, offered = pairs[self.pair].kind, scene.geometry(self.pair)
        for law in (bound.law for bound in self.laws):
            for quantity in law.geometry:
                if offered and quantity.name not in offered:
                    yield Fault(self.where, f"a pair without {quantity.name}, {quantity.meaning}",
                                f"one that has it, because {law.name} requires it",
                                "Line contacts need a length: PinInBush(..., length=...), ParallelCylinders, CylinderOnPlane; "
                                "edges and corners have no radius: power(K, n) does without one.")  # fmt: skip
            if law.pairs and kind not in law.pairs:
                expected = f"the pair it was made for, {' or '.join(law.pairs)}"
                yield Fault(self.where, f"law {law.name} at a {kind} pair", expected)
        yield from super().faults(scene)


def place_on_joint(scene: Declared, key: str) -> tuple[str, Point, Vector]:
    """Place of a freedom's axis, `parent` or `child`, the point there, and the axis along its body's axes."""
    joint, freedom = scene.joint_of(key), scene.scalars[key]
    if freedom.axis is None:
        raise TypeError(f"{key} has no axis")
    # the last axis is fixed in the child, as the first turn's and every slide's is in the parent
    last = freedom.kind == "turn" and freedom == joint.freedoms[-1]
    place, point = ("child", joint.child) if last else ("parent", joint.parent)
    return place, point, apply(point.axes, freedom.axis.unit)


def together(*shares: Mapping[str, Any]) -> dict[str, Any]:
    """Sum of generalised forces by row."""
    forces: dict[str, Any] = {}
    for share in shares:
        for row, force in share.items():
            forces[row] = forces[row] + force if row in forces else force
    return forces


def joint_faults(
    where: str, key: str, scene: Declared, *, counted: bool = True, carried: bool = False
) -> Iterator[Fault]:
    """Yield faults of a joint that is missing, or has not just one coordinate.

    counted    whether its angle is needed, not its speed alone; carried    whether it must carry its body
    """
    dependent = scene.mechanism.dependent_freedoms if carried else ()
    if key in scene.scalars and key not in [freedom.key for freedom in dependent]:
        if counted and key in scene.uncounted:
            yield uncounted_fault(where, key)
        return
    closing = key.split(".")[0] in [joint.name for joint in scene.mechanism.closures]
    if dependent and not closing and key in scene.scalars:
        yield Fault(where, f"{key}, whose rate is not a speed", "a coordinate whose rate is a speed of its own",
                    "Kinematical equations q' = u in SymPy make it one.")  # fmt: skip
        return
    known = key in [joint.name for joint in scene.mechanism.joints]
    why = ", which closes a loop" if closing else ", which has not just one coordinate" if known else ""
    expected = one_of(scene.scalars, "a joint with one coordinate, of which the mechanism has none")
    way_out = "The first joint to reach a body has the coordinates: declare this one before the others."
    yield Fault(where, f"joint {key!r}{why}", expected, way_out if closing else "")


def state_faults(effect: Effect, element: Element, scene: Declared) -> Iterator[Fault]:
    """Yield faults of states that nothing changes, and of changes of states that are not declared."""
    declared = [state.name for state in effect.states(scene)]
    changed = list(dict.fromkeys([*element.rates, *(name for event in element.events for name in event.then)]))
    for name in changed:
        if name not in declared:
            yield Fault(effect.where, f"a rate or an event of the state {name!r}", one_of(declared, "a state it declares"),
                        f"Yield State({name!r}, unit) in {type(effect).__name__}.states.")  # fmt: skip
    for name in declared:
        if name not in changed:
            yield Fault(effect.where, f"the state {name!r}, which nothing changes", "a rate or an event that changes it",
                        f"Give it in the element: rates={{{name!r}: ...}}, or Event(..., then={{{name!r}: ...}}).")  # fmt: skip


def axes_faults(where: str, axes: Any, label: str, components: Any) -> Iterator[Fault]:
    """Yield faults of a vector that is no triple, or whose axes are no frame."""
    if not isinstance(components, tuple) or len(components) != 3:
        yield Fault(f"{where}, {label}", repr(components), "three values, (x, y, z)")
    if not isinstance(axes, Body | Ground):
        yield Fault(f"{where}, axes", repr(axes), "a Body or GROUND")


def _law_faults(where: str, kind: str, bound: Any) -> Iterator[Fault]:
    if isinstance(bound, Law):
        names = ", ".join(parameter.name for parameter in bound.parameters)
        yield Fault(where, f"law {bound.name} without its parameters", f"{bound.name}({names})")
    elif not isinstance(bound, BoundLaw):
        yield Fault(where, repr(bound), f"a {kind} law with its parameters")
    elif bound.law.kind != kind:
        yield Fault(where, f"{bound.law.name}, a {bound.law.kind} law", f"a {kind} law")
