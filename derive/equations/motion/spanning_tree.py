"""Tree of a mechanism as links: one per freedom of a joint, the last of which carries the child.

Each link has axes of its own, L, and a point O on its joint. A slide keeps its parent's axes; a weld adds no link,
its child is fixed to the parent's. Where a joint's axis is skew to its parent's axes, constant rotations align the
link's axes with it, so that every turn is one about a coordinate axis and no angle is multiplied by a full matrix;
bodies keep their own axes by a constant `Place`.

Consecutive links that turn about parallel axes form a run: their angles add, and all their vectors can be resolved in
the same axes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import sympy as sp

from hertzwerk.derive.declare.mechanism.bodies import AXES, GROUND, Direction, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.conditions import across
from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.equations.flexible.rod_bending import RodBending
from hertzwerk.derive.equations.motion.axes import Change, Fixed, Turn
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    along,
    apply,
    cross,
    dot,
    multiply,
    scale,
    sub,
    transpose,
)
from hertzwerk.derive.expressions.parameter import default_value
from hertzwerk.derive.program.program import Tape, symbols_in

UNIT: tuple[Vector, Vector, Vector] = IDENTITY
"""Coordinate axes."""


@dataclass(frozen=True, eq=False)
class Row:
    """One speed of the mechanism, and its row in the equations of motion.

    `key` and `unit` are of its generalised force; `speed` and `acceleration` on the tape.
    """

    key: str
    unit: str
    speed: Any
    acceleration: Any
    free: bool


@dataclass(frozen=True, eq=False)
class Run:
    """Links that turn about the same axis.

    `outer` is the orientation in which the first is fixed (None: the ground), `constant` the rotation between. A
    run's vectors are resolved in the axes of its first orientation, rotated: bodies there have constant inertia. Only
    the run on the ground is resolved in the ground's axes, before any turn.
    """

    outer: Orientation | None
    constant: Matrix
    members: list[Orientation]

    @property
    def change(self) -> Change:
        """Change from the axes of this run to those of the outer one."""
        if self.outer is None:
            return Change()
        between = () if self.constant == IDENTITY else (Fixed(self.constant),)
        return Change((*self.outer.within.steps, *between, *self.members[0].whole.steps))


@dataclass(frozen=True, eq=False)
class Orientation:
    """Orientation of a link's axes: in its run by `whole`; against the run's resolution axes by `within`."""

    run: Run
    axis: Vector
    """Signed coordinate axis of the run's turns; zero where nothing turns, and of a ball."""
    angle: Any
    whole: Change
    within: Change


@dataclass(frozen=True, eq=False)
class Link:
    """The part of a mechanism that moves with one freedom.

    parent       the link it moves on; None for the ground, which is a link without a freedom
    offset       from the parent's O to this O, in the parent's axes [m]: constant but for the travel of a slide
    axis         unit vector of a turn or slide, in its own axes
    rows         its speeds: one, the three of a ball, or those of a rod's shapes
    bending      of a rod that the link is the end of
    base         origin and axes of that rod's start, in the parent's axes
    """

    name: str
    parent: Link | None
    joint: Joint | None
    freedom: Freedom | None
    coordinates: tuple[Any, ...]
    rows: tuple[Row, ...]
    offset: Vector
    axis: Vector
    orientation: Orientation
    bending: RodBending | None = None
    base: tuple[Vector, Matrix] = (ZERO, IDENTITY)

    @property
    def rod(self) -> RodBending:
        """Bending of the rod that it is the end of; raises TypeError where it is none."""
        if self.bending is None:
            raise TypeError(f"{self.name} is no end of a rod")
        return self.bending

    @property
    def kind(self) -> str:
        """Kind of its freedom: turn, slide, ball or bend; ground."""
        return "ground" if self.freedom is None else self.freedom.kind

    @cached_property
    def path(self) -> tuple[Link, ...]:
        """Links from the ground to this one, without the ground."""
        return () if self.parent is None else (*self.parent.path, self)

    @property
    def change(self) -> Change:
        """Change from the axes in which this link is resolved to those of its parent."""
        same = self.parent is None or self.parent.orientation.run is self.orientation.run
        return Change() if same else self.orientation.run.change


@dataclass(frozen=True)
class Place:
    """Position and orientation of a body on its link, both constant in the link's axes.

    `origin` of its frame from the link's O, and its `axes`.
    """

    link: Link
    origin: Vector
    axes: Matrix

    def point(self, point: Point) -> Vector:
        """Vector from the link's O to a point of the body, in the link's axes [m]."""
        return add(self.origin, apply(self.axes, sympified(point.position)))


@dataclass(frozen=True)
class Held:
    """Directions along and about which a joint holds its child, with the rows of its reaction."""

    slides: tuple[tuple[Direction, Row], ...]
    turns: tuple[tuple[Direction, Row], ...]


Motion = Mapping[str, tuple[tuple[Any, ...], tuple[Row, ...]]]
"""Coordinates and rows by the key of the freedom."""


class Tree:
    """Links and places of a mechanism with given coordinates and speeds.

    Joints that are `held` have further links, which never move, along what they forbid: their rows are the reaction.
    """

    def __init__(self, tape: Tape, mechanism: Mechanism, motion: Motion, held: Sequence[str] = ()) -> None:
        self.tape = tape
        self.held: dict[str, Held] = {}
        self.defaults: dict[Any, Any] = {}
        still = Orientation(Run(None, IDENTITY, []), ZERO, sp.S.Zero, Change(), Change())
        still.run.members.append(still)
        self.ground = Link("ground", None, None, None, (), (), ZERO, ZERO, still)
        self.links: list[Link] = []
        self.places: dict[Frame, Place] = {GROUND: Place(self.ground, ZERO, IDENTITY)}
        for joint in mechanism.tree:
            self._add_joint(joint, motion, _held(joint, mechanism.plane) if joint.name in held else None)
        self.children: dict[Link, list[Link]] = {link: [] for link in (self.ground, *self.links)}
        for link in self.links:
            if link.parent is not None:
                self.children[link.parent].append(link)

    def _add_joint(self, joint: Joint, motion: Motion, held: Held | None) -> None:
        """Add the links of a joint, and the place of its child."""
        child = joint.child.body
        parent = self.places[joint.parent.body]
        link = parent.link
        anchor = parent.point(joint.parent)
        axes = self._named(multiply(parent.axes, joint.parent.axes), f"{joint.name}_axes")  # the joint's, in the link's
        count = len(joint.freedoms)
        if held is not None:
            self.held[joint.name] = held
            link, axes, anchor = self._hold(link, held.slides, "slide", anchor, axes)
        for i, freedom in enumerate(joint.freedoms):
            name = child.name if i == count - 1 else f"{joint.name}_{freedom.coordinates[0].name.rsplit('.', 1)[1]}"
            link, axes = self._add_link(link, joint, freedom, name, anchor, axes, *motion[freedom.key])
            anchor = ZERO
            self.links.append(link)
        if held is not None:  # about the child's point
            link, axes, anchor = self._hold(link, held.turns, "turn", anchor, axes)
        body_axes = self._named(multiply(axes, transpose(joint.child.axes)), f"{child.name}_axes")
        origin = sub(anchor, apply(body_axes, sympified(joint.child.position)))
        self.places[child] = Place(link, origin, body_axes)

    def _hold(
        self, link: Link, held: tuple[tuple[Direction, Row], ...], kind: Literal["turn", "slide"], offset: Vector, axes: Matrix
    ) -> tuple[Link, Matrix, Vector]:  # fmt: skip
        """Links that do not move, one on another, and the joint's axes in the last one's."""
        for direction, row in held:
            freedom = Freedom(kind, row.key, direction, (), (), ())
            name = row.key.replace(".", "_")
            link, axes = self._add_link(link, None, freedom, name, offset, axes, (sp.S.Zero,), (row,))
            self.links.append(link)
            offset = ZERO
        return link, axes, offset

    def _add_link(
        self, parent: Link, joint: Joint | None, freedom: Freedom, name: str, offset: Vector, axes: Matrix,
        coordinates: tuple[Any, ...], rows: tuple[Row, ...],
    ) -> tuple[Link, Matrix]:  # fmt: skip
        """Link of one freedom, and the joint's axes in its axes."""
        base, rod = (offset, axes), None
        if isinstance(joint, FlexibleRod):
            rod = RodBending(self.tape, joint, coordinates, [row.speed for row in rows])
            offset = add(offset, apply(axes, rod.tip))
        if freedom.axis is None:
            matrix = (
                rod.rotation if rod else self.tape.matrix(_of_quaternion(self.tape, coordinates, name), f"{name}_R")
            )
            orientation = _ball(parent.orientation, axes, Fixed(matrix))
            return Link(name, parent, joint, freedom, coordinates, rows, offset, ZERO, orientation, rod, base), IDENTITY
        direction = apply(axes, freedom.axis.unit)
        q = rod.angles[0][1] if rod else coordinates[0]
        if freedom.kind == "slide":
            direction = self.tape.vector(direction, f"{name}_direction")
            moved = add(offset, scale(q, direction))
            return Link(name, parent, joint, freedom, coordinates, rows, moved, direction, parent.orientation), axes
        constant, inner = IDENTITY, axes
        if along(direction) is None and along(freedom.axis.unit) is not None:  # align the link's axes with the joint's
            constant, inner, direction = axes, IDENTITY, freedom.axis.unit
        elif along(direction) is None:
            constant = self._named(self._aligned(direction), f"{name}_lined_up")
            inner = self._named(multiply(transpose(constant), axes), f"{name}_axes")
            direction = UNIT[2]
        orientation = self._turned(parent.orientation, constant, direction, q, name)
        return Link(name, parent, joint, freedom, coordinates, rows, offset, direction, orientation, rod, base), inner

    def _turned(self, parent: Orientation, constant: Matrix, axis: Vector, q: Any, name: str) -> Orientation:
        """Add a turn to an orientation; about a parallel axis the angles add, in the same run."""
        parallel = cross(parent.axis, axis) == ZERO and not _is_ball(parent)
        if constant == IDENTITY and parallel:
            run = parent.run
            axis, total = (axis, q) if parent.axis == ZERO else (parent.axis, parent.angle + dot(parent.axis, axis) * q)
        else:
            run, total = Run(parent, constant, []), q
        total = self.tape.let(total, f"{name}_angle")
        whole = self._turn(axis, total, name)
        first = run.members[0] if run.members and run.outer is not None else None
        if first is None:
            within = whole if run.outer is None else Change()
        else:
            within = self._turn(axis, self.tape.let(total - first.angle, f"{name}_turn"), f"{name}_turn")
        orientation = Orientation(run, axis, total, whole, within)
        run.members.append(orientation)
        return orientation

    def _turn(self, axis: Vector, angle: Any, name: str) -> Change:
        k = along(axis)
        if k is None:
            raise ValueError(f"{axis} is no coordinate axis")
        cosine, sine = self.tape.let(sp.cos(angle), f"cos_{name}"), self.tape.let(sp.sin(angle), f"sin_{name}")
        return Change((Turn(k, cosine, axis[k] * sine),))

    def _aligned(self, direction: Vector) -> Matrix:
        """Rotation whose third column is the given direction.

        The first column is perpendicular to the coordinate axis that, at the defaults, is furthest from the
        direction.
        """
        sizes = [abs(self._default(component)) for component in direction]
        first = cross(UNIT[sizes.index(min(sizes))], direction)
        first = scale(1 / sp.sqrt(dot(first, first)), first)
        return transpose((first, cross(direction, first), direction))

    def _default(self, expression: Any) -> float:
        """Value of a constant on the tape at the parameters' defaults; each assignment is evaluated once."""
        made = self.tape.assignments
        for symbol in symbols_in(sp.sympify(expression)):
            if symbol in made and symbol not in self.defaults:
                self.defaults[symbol] = sp.Float(self._default(made[symbol]))
        return default_value(sp.sympify(expression).xreplace(self.defaults))

    def _named(self, matrix: Matrix, name: str) -> Matrix:
        return self.tape.matrix(matrix, name)


def _held(joint: Joint, plane: int | None) -> Held:
    """Directions a joint holds: all but those of its slides and, where it only slides, all turns."""
    ways = AXES if joint.main_axis is None else (joint.main_axis, *(way for way, _ in across(joint.main_axis)))
    if joint.sliding:
        ways = ways[1:]
    turns = ways if joint.sliding and not joint.turning else ()
    if plane is not None and not joint.sliding:  # a guide may be pressed across the plane of motion too
        ways = tuple(AXES[k] for k in range(3) if k != plane)

    def rows(directions: Sequence[Direction], unit: str, word: str) -> tuple[tuple[Direction, Row], ...]:
        keys = [f"{joint.name}.{word}_{i}" for i, _ in enumerate(directions, 1)]
        return tuple(
            (way, Row(key, unit, sp.S.Zero, sp.S.Zero, False)) for way, key in zip(directions, keys, strict=True)
        )

    return Held(rows(ways, "N", "holds"), rows(turns, "N m", "twists"))


def _is_ball(orientation: Orientation) -> bool:
    return any(isinstance(step, Fixed) for step in orientation.whole.steps)


def _ball(parent: Orientation, constant: Matrix, rotation: Fixed) -> Orientation:
    run = Run(parent, constant, [])
    orientation = Orientation(run, ZERO, sp.S.Zero, Change((rotation,)), Change())
    run.members.append(orientation)
    return orientation


def _of_quaternion(tape: Tape, q: tuple[Any, ...], name: str) -> Matrix:
    """Rotation matrix of a unit quaternion, in 24 operations.

    The time integration keeps the norm, which saves five more operations to divide by q.q in every evaluation.
    """
    q0, _, q2, q3 = q
    twice = [tape.let(2 * part, f"{name}_twice_q{i}") for i, part in enumerate(q[1:], 1)]
    xx, yy, zz = (tape.let(a * b, f"{name}_q{i}q{i}") for i, (a, b) in enumerate(zip(twice, q[1:], strict=True), 1))
    wx, wy, wz = (tape.let(a * q0, f"{name}_q0q{i}") for i, a in enumerate(twice, 1))
    xy, xz, yz = twice[0] * q2, twice[0] * q3, twice[1] * q3
    return (
        (1 - (yy + zz), xy - wz, xz + wy),
        (xy + wz, 1 - (xx + zz), yz - wx),
        (xz - wy, yz + wx, 1 - (xx + yy)),
    )


def sympified(triple: Any) -> Vector:
    """Three SymPy expressions."""
    x, y, z = (sp.sympify(component) for component in triple)
    return (x, y, z)
