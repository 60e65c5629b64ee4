"""Effects: what a scene calls for beside its mechanism. Each kind is a frozen dataclass derived from `Effect`, its declaration beside what it does.

A kind of effect of one's own is one such class: what it is asked for and does not have is as declared here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Protocol

import sympy as sp

from hertzwerk.derive.algebra.vectors import Matrix, Vector, apply
from hertzwerk.derive.effects.expression import SPEED
from hertzwerk.derive.faults import Fault, InputError, one_of
from hertzwerk.derive.laws.law import BoundLaw, Law
from hertzwerk.derive.mechanism.bodies import GROUND, Body, Direction, Frame, Ground, Point, Slot
from hertzwerk.derive.mechanism.joints import Freedom
from hertzwerk.derive.mechanism.mechanism import Mechanism
from hertzwerk.derive.program.program import Tape

DISSIPATED, INPUT = "dissipated", "input"
APPLIED, CONTACT, NOWHERE = "applied", "contact", ""

Mark = tuple[str, str, Point, Mapping[str, Any]]
"""A landmark of an effect: kind, place, point, and directions and sizes beside it."""


@dataclass(frozen=True)
class Element:
    """Generalised forces by joint [N m or N]; stored energy [J]; power [W] that the energy ledger books as `DISSIPATED` or `INPUT`, None where the
    element stores; outputs (name, unit, expression)."""

    forces: Mapping[str, Any] = field(default_factory=dict)
    stored: Any = sp.S.Zero
    power: Any = None
    booked: str = DISSIPATED
    outputs: tuple[tuple[str, str, Any], ...] = ()


class Declared(Protocol):
    """The scene as its effects see it."""

    @property
    def mechanism(self) -> Mechanism:
        """Bodies, joints, pairs."""

    @property
    def effects(self) -> tuple[Effect, ...]:
        """All effects, in declared order."""

    @property
    def scales(self) -> Any:
        """`length` [m] and `speed` [m/s] that accuracy is measured by."""

    @property
    def scalars(self) -> Mapping[str, Freedom]:
        """Freedoms of one coordinate by their keys."""

    def geometry(self, pair: str) -> Mapping[str, Any]:
        """Quantities that a pair offers its laws, by name; empty for no pair."""


class Journal(Protocol):
    """A pin in its bush on the tape: both places, the bush's centre, and from there to the pin's [m]."""

    pair: Any
    first: Point
    second: Point
    base: Vector
    apart: Vector

    @property
    def eccentricity(self) -> Vector:
        """`apart` without its part along the axis [m]."""

    def rate_at(self, position: Vector) -> Vector:
        """Velocity of the first body's point at `position` against the second body's [m/s]."""


class Kinematics(Protocol):
    """Motion of a mechanism as the equations of its effects see it: vectors in ground axes, in SI, results named on the tape."""

    tape: Tape

    @property
    def scene(self) -> Declared:
        """The scene that moves."""

    def expression(self, value: Any) -> Any:
        """An expression of a scene over the tape."""

    def coordinate(self, key: str) -> Any:
        """Coordinate of a freedom [rad or m]."""

    def speed(self, key: str) -> Any:
        """Its rate [rad/s or m/s]."""

    def on_joint(self, key: str, force: Any, name: str) -> dict[str, Any]:
        """Generalised forces of a force along a slide or a torque about a turn, on its child; the parent feels the opposite."""

    def point(self, point: Point, name: str) -> tuple[Vector, Vector, Vector]:
        """Position, velocity, acceleration of a point [m, m/s, m/s^2]."""

    def rotation(self, body: Frame) -> Matrix:
        """From a body's axes to the ground's."""

    def direction(self, point: Point, direction: Direction) -> Vector:
        """A direction given in a point's axes."""

    def angular_velocity(self, body: Frame) -> Vector:
        """Angular velocity of a body [rad/s]."""

    def generalised(self, force: Vector, position: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces of a force on one body and its reaction on another at the same point."""

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces of a moment on one body and its reaction on another."""

    def journal(self, pair: str) -> Journal:
        """The pin and bush of this name."""


class Effect:
    """Base of every effect; a kind is a frozen dataclass derived from it, with a `name`, unique in its scene, and a `kind`.

    takes       fields that hold a law -> the kind of law they take
    asks        COORDINATE or SPEED of its joints: coordinates of those that close loops cannot always be had
    enters      function of a module that its generalised forces stand in: APPLIED, CONTACT, or NOWHERE for what has none
    quantities  words after its name -> letter, subscript, meaning of a quantity, for people; `sought`: those looked for by name
    unchecked   whether an inconsistent law may run
    """

    name: str
    kind: ClassVar[str]
    takes: ClassVar[Mapping[str, str]] = {}
    asks: ClassVar[str] = SPEED
    enters: ClassVar[str] = APPLIED
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = {}
    sought: ClassVar[tuple[str, ...]] = ()
    unchecked = False

    @property
    def text(self) -> str:
        """What the effect is, for people."""
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
        """Directions by what they are called."""
        return {}

    @property
    def laws(self) -> tuple[BoundLaw, ...]:
        """Laws in the order of their fields."""
        return tuple(law for law in (getattr(self, name) for name in self.takes) if law is not None)

    @property
    def section(self) -> str:
        """Title of the section that equations for people show its laws in."""
        return ""

    @property
    def only(self) -> str:
        """Of what there can be one in a scene, such as "drive of joint crank"; "" for any number."""
        return ""

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Quantities in declared order; asked for only where its joints are freedoms of the scene."""
        return iter(())

    def type_faults(self) -> Iterator[Fault]:
        """Fields of the wrong type, so that nothing else can be asked of them."""
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
        """What does not fit the scene, beyond quantities."""
        for body in self.frames:
            if body != GROUND and body not in scene.mechanism.bodies:
                names = [b.name for b in scene.mechanism.bodies]
                yield Fault(
                    self.where, f"body {body.name}", f"{one_of(names, 'a body of the mechanism')}, or the ground"
                )

    def element(self, kin: Kinematics) -> Element | None:
        """Forces, energy and outputs of the effect; None for what other parts of the derivation see to. Raises InputError for a kind without one."""
        found = f"the kind {self.kind!r}, which has no element"
        raise InputError(self.where, [Fault(self.where, found, "one that says what it does",
                         f"def element(self, kin): return Element(...), in {type(self).__name__}.")])  # fmt: skip

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Marks of a picture."""
        return iter(())


class JointEffect(Effect):
    """An effect on a `joint` with one coordinate, or on one of several: "column.angle".

    drawn  whether a picture shows it on the joint
    """

    joint: str
    drawn: ClassVar[bool] = False

    @property
    def joints(self) -> tuple[str, ...]:
        """The one joint."""
        return (self.joint,)

    def freedom(self, scene: Declared) -> Freedom:
        """The freedom it acts on."""
        return scene.scalars[self.joint]

    def type_faults(self) -> Iterator[Fault]:
        """A joint that is no name."""
        if not isinstance(self.joint, str):
            yield Fault(self.where, f"joint {self.joint!r}", "the name of a joint")
        yield from super().type_faults()

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """A joint that is not there, or has not just one coordinate."""
        if self.joint not in scene.scalars:
            closing = self.joint in [joint.name for joint in scene.mechanism.closures]
            known = self.joint in [joint.name for joint in scene.mechanism.joints]
            why = ", which closes a loop" if closing else ", which has not just one coordinate" if known else ""
            expected = one_of(scene.scalars, "a joint with one coordinate, of which the mechanism has none")
            way_out = "The first joint to reach a body has the coordinates: declare this one before the others."
            yield Fault(self.where, f"joint {self.joint!r}{why}", expected, way_out if closing else "")
        yield from super().faults(scene)

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Of a turn its axis; of a slide both points, and the axis."""
        freedoms = ((joint, freedom) for joint in scene.mechanism.joints for freedom in joint.freedoms)
        joint, freedom = next(found for found in freedoms if found[1].key == self.joint)
        if not self.drawn or freedom.axis is None:
            return
        kind = f"{freedom.kind}_{self.kind}"
        # the last axis is fixed in the child, as the first turn's and every slide's is in the parent
        last = freedom.kind == "turn" and freedom == joint.freedoms[-1]
        point, place = (joint.child, "child") if last else (joint.parent, "parent")
        yield kind, place, point, {"axis": apply(point.axes, freedom.axis.unit)}
        if freedom.kind == "slide":
            yield kind, "child", joint.child, {}


class PairEffect(Effect):
    """An effect at a `pair`, one of its kind there."""

    pair: str

    @property
    def pairs(self) -> tuple[str, ...]:
        """The one pair."""
        return (self.pair,)

    @property
    def only(self) -> str:
        """One of a kind at a pair."""
        return f"{self.kind} of pair {self.pair}"

    @property
    def section(self) -> str:
        """That of the contact."""
        return f"Contact {self.pair}"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Parameters of the laws, and what of the pair's geometry they limit."""
        for bound in self.laws:
            yield from bound.slots(self.where, dict(scene.geometry(self.pair)))

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """A pair that is not there, or not the one that a law was made for."""
        pairs = {pair.name: pair for pair in scene.mechanism.pairs}
        if self.pair not in pairs:
            yield Fault(self.where, f"pair {self.pair!r}", one_of(pairs, "a pair of the mechanism, which has none"))
            return
        kind, offered = pairs[self.pair].kind, scene.geometry(self.pair)
        for law in (bound.law for bound in self.laws):
            for quantity in law.geometry():
                if offered and quantity.name not in offered:
                    yield Fault(self.where, f"a pair without {quantity.name}, {quantity.meaning}",
                                f"one that has it, because {law.name} asks for it",
                                "Line contacts need a length: PinInBush(..., length=...), ParallelCylinders, CylinderOnPlane; "
                                "edges and corners have no radius: power(K, n) does without one.")  # fmt: skip
            if law.pairs and kind not in law.pairs:
                expected = f"the pair it was made for, {' or '.join(law.pairs)}"
                yield Fault(self.where, f"law {law.name} at a {kind} pair", expected)
        yield from super().faults(scene)


def axes_faults(where: str, axes: Any, what: str, components: Any) -> Iterator[Fault]:
    """Faults of a vector that is no triple, or is given along the axes of no frame."""
    if not isinstance(components, tuple) or len(components) != 3:
        yield Fault(f"{where}, {what}", repr(components), "three values, (x, y, z)")
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
