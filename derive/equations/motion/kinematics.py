"""Positions, velocities, accelerations and partial velocities of bodies of a tree, in ground axes.

Everything refers to O, the point of a body's link on its joint, which is fixed in the body: the vector from O to any
other point of the body is short, so there is no cancellation of large numbers. Consecutive rotations about parallel
axes merge into one angle; structural zeros make plane mechanisms plane. Only requested terms are computed. Kane,
Levinson, Dynamics: Theory and Applications (1985), chapter 2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import InputError, unknown
from hertzwerk.derive.declare.effects.effect import FORCE
from hertzwerk.derive.declare.effects.state_expression import (
    COORDINATE,
    INPUT,
    NORMAL_FORCE,
    REACTION,
    STATE,
    TIME,
    StateSymbol,
    T,
    as_choice,
    inputs_in,
    states_in,
)
from hertzwerk.derive.declare.effects.tracking import CountedAngle
from hertzwerk.derive.declare.mechanism.bodies import Body, Direction, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Port
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.spanning_tree import Link, Orientation, Row, Tree
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    cross,
    dot,
    multiply,
    scale,
    sub,
    transpose,
)
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.program.program import Tape

PIECE_DEGREE = 5
"""Degree of the pieces of an input, as of those of a table."""


@dataclass(frozen=True)
class Motion:
    """Rotation to ground axes, position of O, velocities and accelerations of a link.

    The accelerations include the generalised accelerations.
    """

    rotation: Matrix
    origin: Vector
    angular_velocity: Vector
    velocity: Vector
    angular_acceleration: Vector
    acceleration: Vector


@dataclass(frozen=True)
class DriveState:
    """State integrated for a drive, an entry of q without a speed in u.

    Its port, symbol, rate, and value at t = 0.
    """

    port: Port
    symbol: sp.Symbol
    rate: Any
    start: Any


class Kinematics:
    """Motions of all bodies of a scene, recorded on a tape.

    `q`, `u`, `a` are the free coordinates, speeds, accelerations, and `rates` the rates of `q`; `t` is time.
    """

    def __init__(self, tape: Tape, scene: Scene, groups: tuple[str, str, str] = ("q", "u", "a")) -> None:
        self.tape = tape
        self.scene = scene
        self.mechanism: Mechanism = scene.mechanism
        self.t = tape.input("t", "t", Dimension.from_unit("s"))
        tape.set_rate(self.t, sp.S.One)
        self.inputs = {name: self._input_value(name, signal.unit) for name, signal in scene.inputs.items()}
        free = scene.free
        inputs = [[self._input(port, groups[0]) for port in freedom.coordinates] for freedom in free]
        speeds = [[self._input(port, groups[1]) for port in freedom.speeds] for freedom in free]
        seconds = [[self._input(acceleration_of(port), groups[2]) for port in freedom.speeds] for freedom in free]
        self.q, self.u, self.a = ([symbol for part in parts for symbol in part] for parts in (inputs, speeds, seconds))
        self.rates: list[Any] = []
        self.drive_states: list[DriveState] = []
        motion: dict[str, tuple[tuple[Any, ...], tuple[Row, ...]]] = {}
        for freedom, q, u, a in zip(free, inputs, speeds, seconds, strict=True):
            if freedom.kind != "given":  # whose rates its description gives
                rates = self._quaternion_rates(q, u) if freedom.kind == "ball" else u
                self.rates.extend(rates)
                for symbol, rate in zip(q, rates, strict=True):
                    tape.set_rate(symbol, rate)
            for speed, acceleration in zip(u, a, strict=True):
                tape.set_rate(speed, acceleration)
            of_rows = zip(freedom.forces, u, a, strict=True)
            motion[freedom.key] = tuple(q), tuple(Row(*port, speed, rate, True) for port, speed, rate in of_rows)
        for freedom in scene.mechanism.freedoms:
            if freedom.key not in motion:
                motion[freedom.key] = self._driven(freedom, scene, groups[0])
        self.prescribed = {freedom.key: self._driven(freedom, scene, groups[0]) for freedom in scene.prescribed}
        self.effect_states = {name: self._input(Port(name, s.unit), groups[0]) for name, s in scene.states.items()}
        self.counted = {
            effect.joint: self.effect_states[f"{effect.name}.near"]
            for effect in scene.all(CountedAngle)
            if effect.counts(scene)
        }
        self.states = {key: (q[0], rows[0].speed) for key, (q, rows) in motion.items() if q and rows}
        self.motions = motion
        """Coordinates and rows of each freedom of the tree by its key."""
        self.tree = Tree(tape, scene.mechanism, motion, scene.held)
        self.carried: dict[tuple[str, str, Any], sp.Symbol] = {}
        self.normal_forces: dict[str, sp.Symbol] = {}
        self.rubbing: dict[str, tuple[sp.Symbol, sp.Symbol]] = {}
        # keyed by links and bodies, which live as long as this does
        self.motion_of = cache(self._motion)
        self.bias_of = cache(self._bias)
        self._rotations: dict[Orientation, Matrix] = {}
        self.origin_of = cache(self._origin)
        self.direction_of = cache(self._direction)
        self.turned = cache(self._turned_about)
        self.by_expressions = scene.mechanism.motion_by_expressions(self)
        """Motion given by expressions, see `sympy_models`; None where links have their own."""

    def _quaternion_rates(self, q: Sequence[Any], rate: Sequence[Any]) -> tuple[Any, ...]:
        """Quaternion rates q' = q (0, w/2), with w in the rotated axes."""
        (q0, q1, q2, q3), (x, y, z) = q, (self.tape.let(w / 2, f"half_{w.name}") for w in rate)
        return (
            -q1 * x - q2 * y - q3 * z,
            q0 * x + q2 * z - q3 * y,
            q0 * y + q3 * x - q1 * z,
            q0 * z + q1 * y - q2 * x,
        )

    def _driven(self, freedom: Freedom, scene: Scene, group: str) -> tuple[tuple[Any, ...], tuple[Row, ...]]:
        """Coordinate, speed and acceleration of a driven freedom: the drive's law and its derivatives.

        Orders below the law's are states that integrate it.
        """
        motion = scene.driven[freedom.key].motion
        ports = (*freedom.coordinates, *freedom.speeds, *map(acceleration_of, freedom.speeds))
        names = [port.name.replace(".", "_") for port in ports]
        chain: list[Any] = [self._input(port, group) for port in ports[: motion.order]]
        law = motion.law.xreplace({T: self.t, **{signal: self._state(signal) for signal in inputs_in(motion.law)}})
        uniform = motion.order == 0 and sp.diff(law, self.t, 2) == 0  # one product, named where it is used
        chain.append(law if uniform else self.tape.let(law, names[motion.order]))
        measured = bool(inputs_in(motion.law))  # an input's rates are those of its pieces, by the tape's chain rule
        while len(chain) < 3:
            if measured:
                chain.append(self.tape.rate(law, names[len(chain)]))
                law = self.tape.assignments.get(chain[-1], chain[-1])
                continue
            law = sp.diff(law, self.t)
            chain.append(self.tape.let(law, names[len(chain)]))
        for low, high in pairwise(chain):
            self.tape.set_rate(low, high)
        for order, start in enumerate(motion.start):
            self.drive_states.append(DriveState(ports[order], chain[order], chain[order + 1], sp.sympify(start)))
        (force,) = freedom.forces
        return (chain[0],), (Row(*force, chain[1], chain[2], False),)

    def motion_of_freedom(self, freedom: Freedom) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """Coordinates and speeds of a freedom, free or driven."""
        coordinates, rows = self.motions[freedom.key]
        return coordinates, tuple(row.speed for row in rows)

    def coordinate(self, key: str) -> Any:
        """Coordinate of a scalar freedom of the tree, free or driven [rad or m]."""
        return self.states[key][0]

    def speed(self, key: str) -> Any:
        """Rate of the coordinate [rad/s or m/s]."""
        return self.states[key][1]

    def state(self, name: str) -> Any:
        """State of an effect, `motor.current`; raises InputError for an unknown name."""
        if name not in self.effect_states:
            raise InputError(f"scene {self.scene.name}", [unknown("state", name, self.effect_states)])
        return self.effect_states[name]

    def reaction(self, joint: str, part: str = FORCE, length: Any = None) -> Any:
        """Magnitude of the force that a joint carries, or of a part of it [N]; `reaction_loads` solves it.

        length  between the pads of a guide [m]
        """
        return self._load(self.carried, (joint, part, length), f"{joint}_{part.replace(' ', '_')}")

    def normal_force(self, pair: str) -> Any:
        """Normal force of a contact [N]: an input."""
        return self._load(self.normal_forces, pair, f"{pair}_pressed")

    def friction(self, effect: str) -> tuple[Any, Any]:
        """Coefficient [1], with its sign, of a friction that slides, and force [N] of one that sticks."""
        if effect not in self.rubbing:
            self.rubbing[effect] = self._carried(f"{effect}_coefficient", "1"), self._carried(f"{effect}_holding", "N")
        return self.rubbing[effect]

    @property
    def loaded(self) -> bool:
        """Whether forces depend on what joints and contacts carry."""
        return bool(self.carried or self.normal_forces or self.rubbing)

    def _load(self, known: dict[Any, sp.Symbol], key: Any, name: str) -> sp.Symbol:
        if key not in known:
            known[key] = self._carried(name, "N")
        return known[key]

    def _carried(self, name: str, unit: str) -> sp.Symbol:
        return self.tape.input(name, "reactions", Dimension.from_unit(unit))

    def row(self, key: str) -> Row:
        """Row of a scalar freedom of the tree."""
        (row,) = self.motions[key][1]
        return row

    def _turned_about(self, body: Frame, k: int) -> Any:
        """Angle of a body against the ground about a coordinate axis [rad].

        All turns on the way to the body must be about that axis.
        """
        if self.by_expressions is not None:
            return self.by_expressions.turned(body, k)
        joint = self.mechanism.joint_of(body)
        if joint is None:
            return sp.S.Zero
        turns = ((freedom.key, freedom.axis) for freedom in joint.freedoms if freedom.kind == "turn")
        bent = self.link_of(body).rod.angles if joint.bends else []
        total = self.turned(joint.parent.body, k) + joint.parent.turned_about(k) - joint.child.turned_about(k)
        total += sp.Add(*(axis.unit[k] * self.coordinate(key) for key, axis in turns if axis is not None))
        total += sp.Add(*(axis[k] * angle for axis, angle in bent))
        return self.tape.let(total, f"{body.name}_turned")

    def expression(self, value: Any) -> Any:
        """An expression of a scene on the tape: of time, coordinates, speeds and states of effects."""
        value = as_choice(value)
        return value.xreplace({symbol: self._state(symbol) for symbol in states_in(value)})

    def _state(self, symbol: StateSymbol) -> Any:
        if symbol.quantity == TIME:
            return self.t
        if symbol.quantity == STATE:
            return self.state(symbol.joint)
        if symbol.quantity == REACTION:
            return self.reaction(symbol.joint)
        if symbol.quantity == NORMAL_FORCE:
            return self.normal_force(symbol.joint)
        if symbol.quantity == INPUT:
            if symbol.name not in self.inputs:
                raise InputError(f"scene {self.scene.name}", [unknown("input", symbol.name, self.inputs)])
            return self.inputs[symbol.name]
        return self.coordinate(symbol.joint) if symbol.quantity == COORDINATE else self.speed(symbol.joint)

    def _input_value(self, name: str, unit: str) -> Any:
        """Value of an input on the tape: a polynomial of the time since its piece began."""
        of, per = Dimension.from_unit(unit), Dimension.from_unit("s")
        begin, *factors = self.tape.piece(name, [per, *(of / per**k for k in range(PIECE_DEGREE + 1))])
        since = self.tape.let(self.t - begin, f"{name}_since")
        value = sp.S.Zero
        for factor in reversed(factors):
            value = factor + since * value
        return self.tape.let(value, name)

    def _input(self, port: Port, group: str) -> sp.Symbol:
        return self.tape.input(port.name.replace(".", "_"), group, Dimension.from_unit(port.unit))

    # -- links in ground axes --------------------------------------------------------------------------------------

    def rotation_of(self, orientation: Orientation, name: str) -> Matrix:
        """Rotation matrix from a link's axes to the ground's; a new one is named after `name`."""
        if orientation not in self._rotations:
            run, matrix = orientation.run, IDENTITY
            if run.outer is not None:
                matrix = multiply(self.rotation_of(run.outer, f"{name}_base"), run.constant)
            for step in orientation.whole.steps:
                matrix = multiply(matrix, step.matrix)
            self._rotations[orientation] = self.tape.matrix(matrix, f"{name}_R")
        return self._rotations[orientation]

    def _turned(self, link: Link) -> Matrix:
        if link.kind == "given":
            return self.by_expressions.rotation(link)  # type: ignore[no-any-return]
        return self.rotation_of(link.orientation, link.name)

    def _arm(self, link: Link) -> Vector:
        """Vector from the parent's O to the link's, ground axes [m]."""
        if link.parent is None:
            return ZERO
        return self.tape.vector(apply(self._turned(link.parent), link.offset), f"{link.name}_arm")

    def _direction(self, link: Link) -> Vector:
        """Axis of a turn or slide, ground axes."""
        # the axis of a turn is fixed in the parent, and a slide keeps its parent's axes
        outer = link.parent if link.parent is not None else link
        local = link.axis
        if link.kind == "turn" and link.orientation.run is not outer.orientation.run:
            local = apply(link.orientation.run.constant, local)
        name = link.joint.name if link.joint is not None else link.name
        return self.tape.vector(apply(self._turned(outer), local), f"{name}_axis")

    def _origin(self, link: Link) -> Vector:
        """Position of O [m]."""
        if link.parent is None:
            return ZERO
        if link.kind == "given":
            return self.by_expressions.origin(link)  # type: ignore[no-any-return]
        return self.tape.vector(add(self.origin_of(link.parent), self._arm(link)), link.name)

    def _motion(self, link: Link) -> Motion:
        tape, name = self.tape, link.name
        if link.parent is None:
            return Motion(IDENTITY, ZERO, ZERO, ZERO, ZERO, ZERO)
        if link.kind == "given":
            return self.by_expressions.motion(link)  # type: ignore[no-any-return]
        before = self.motion_of(link.parent)
        accelerations = before.angular_acceleration, before.acceleration
        spin, relative, alpha, acceleration = self._moved(link, *accelerations, [row.acceleration for row in link.rows])
        w, velocity = before.angular_velocity, add(before.velocity, spin)
        if link.kind == "bend":
            velocity = add(velocity, self.of_rod(link, link.rod.moved[0], "end_velocity"))
        if link.kind == "slide":
            velocity = add(velocity, relative)
        else:
            w = tape.vector(add(w, relative), f"{name}_rate")
            alpha = tape.vector(alpha, f"{name}_angular_acceleration")
        origin = self.origin_of(link)
        velocity = tape.vector(velocity, f"{name}_velocity")
        acceleration = tape.vector(acceleration, f"{name}_acceleration")
        for position, rate, second in zip(origin, velocity, acceleration, strict=True):
            tape.set_rate(position, rate)
            tape.set_rate(rate, second)
        return Motion(self._turned(link), origin, w, velocity, alpha, acceleration)

    def _bias(self, link: Link) -> tuple[Vector, Vector]:
        """Angular acceleration, and acceleration of O, at zero generalised accelerations.

        The accelerations of drives are included.
        """
        if link.parent is None:
            return ZERO, ZERO
        if link.kind == "given":
            return self.by_expressions.bias(link)  # type: ignore[no-any-return]
        seconds = [sp.S.Zero if row.free else row.acceleration for row in link.rows]
        _, _, alpha, bias = self._moved(link, *self.bias_of(link.parent), seconds)
        tape, name = self.tape, link.name
        return tape.vector(alpha, f"{name}_angular_bias"), tape.vector(bias, f"{name}_bias")

    def _moved(self, link: Link, alpha: Vector, acceleration: Vector, seconds: list[Any]) -> tuple[Vector, ...]:
        """Rate of the arm, relative velocity, angular acceleration, acceleration of O.

        `alpha` and `acceleration` are those of the parent, `seconds` the accelerations of the link's rows.
        """
        w, arm = self.motion_of(link.parent).angular_velocity, self._arm(link)
        spin = self.tape.vector(cross(w, arm), f"{link.name}_arm_rate")
        acceleration = add(acceleration, cross(alpha, arm), cross(w, spin))
        if link.kind == "bend":
            return spin, *self._bent(link, w, alpha, acceleration, seconds)
        slides = link.kind == "slide"
        axes = [self.direction_of(link)] if slides else self.partial_turns(link)
        relative = add(*(scale(row.speed, axis) for row, axis in zip(link.rows, axes, strict=True)))
        along = [scale(a, axis) for a, axis in zip(seconds, axes, strict=True)]
        if slides:
            twice = scale(2 * link.rows[0].speed, cross(w, axes[0]))
            return spin, relative, alpha, add(acceleration, twice, *along)
        relative = self.tape.vector(relative, f"{link.name}_turning")
        return spin, relative, add(alpha, cross(w, relative), *along), acceleration

    def _bent(
        self, link: Link, w: Vector, alpha: Vector, acceleration: Vector, seconds: list[Any]
    ) -> tuple[Vector, ...]:
        """Relative angular velocity, angular acceleration, acceleration of O of the end of a rod."""
        rod = link.rod
        (velocity, turning), (bias, swing) = (
            [self.of_rod(link, part, f"end_{label}") for part, label in zip(parts, labels, strict=True)]
            for parts, labels in ((rod.moved, ("velocity", "turning")), (rod.bent, ("bias", "swing")))
        )
        moving, turned = (
            self.of_rod(link, rod.sum(rows, seconds, label), label)
            for rows, label in ((rod.slides, "end_acceleration"), (rod.turns, "end_angular_acceleration"))
        )
        return (
            turning,
            add(alpha, cross(w, turning), swing, turned),
            add(acceleration, scale(2, cross(w, velocity)), bias, moving),
        )

    def _rod_axes(self, link: Link) -> Matrix:
        """Rotation matrix from the axes of a rod's start to the ground's."""
        matrix, axes = self._turned(link.parent), link.base[1]  # type: ignore[arg-type]
        return matrix if axes == IDENTITY else self.tape.matrix(multiply(matrix, axes), f"{link.rod.name}_start_R")

    def section(self, end: Link, percent: int) -> tuple[Vector, Matrix]:
        """Position [m] and rotation matrix of a section of a rod, for pictures."""
        start, section = end.joint.parent.body, end.rod.section(percent)  # type: ignore[union-attr]
        name, axes = f"{end.rod.name}_{percent}", self.rotation(start)
        place = add(self.frame_origin(start), apply(axes, section[0]))  # type: ignore[arg-type]
        return self.tape.vector(place, name), self.tape.matrix(multiply(axes, section[1]), f"{name}_R")

    def of_rod(self, link: Link, vector: Vector, label: str) -> Vector:
        """A vector along the axes of a rod's start, in ground axes."""
        return self.tape.vector(apply(self._rod_axes(link), vector), f"{link.name}_{label}")

    # -- bodies, points and paths ----------------------------------------------------------------------------------

    def link_of(self, body: Frame) -> Link:
        """The link that carries a body."""
        return self.tree.places[body].link

    def motion(self, body: Frame) -> Motion:
        """Motion of the link that carries a body."""
        return self.motion_of(self.link_of(body))

    def angular_velocity(self, body: Frame) -> Vector:
        """Angular velocity of a body [rad/s]."""
        return self.motion(body).angular_velocity

    def rotation(self, body: Frame) -> Matrix:
        """Rotation matrix from a body's axes to the ground's."""
        place = self.tree.places[body]
        matrix = self._turned(place.link)
        return matrix if place.axes == IDENTITY else self.tape.matrix(multiply(matrix, place.axes), f"{body.name}_R")

    def axes_of(self, point: Point) -> Matrix:
        """Rotation matrix from a point's axes to the ground's."""
        body = self.rotation(point.body)
        return multiply(body, point.axes) if point.turns else body

    def direction(self, point: Point, direction: Direction) -> Vector:
        """Unit vector in ground axes of a direction given in a point's axes."""
        return apply(self.axes_of(point), direction.unit)

    def arm(self, point: Point, name: str) -> Vector:
        """Vector from its body's O to the point, ground axes [m]."""
        place = self.tree.places[point.body]
        return self.tape.vector(apply(self._turned(place.link), place.point(point)), f"{name}_arm")

    def frame_origin(self, body: Body) -> Vector:
        """Origin of a body's frame [m]."""
        return add(self.origin_of(self.link_of(body)), self.arm(Point(body), f"{body.name}_frame"))

    def centre(self, body: Body) -> Vector:
        """Mass centre of a body [m]."""
        return add(self.origin_of(self.link_of(body)), self.arm(Point(body, body.centre), f"{body.name}_centre"))

    def point(self, point: Point, name: str) -> tuple[Vector, Vector, Vector]:
        """Position, velocity, acceleration (with the generalised accelerations) of a point [m, m/s, m/s^2]."""
        motion, arm = self.motion(point.body), self.arm(point, name)
        spin = self.tape.vector(cross(motion.angular_velocity, arm), f"{name}_arm_rate")
        return (
            add(motion.origin, arm),
            add(motion.velocity, spin),
            add(motion.acceleration, cross(motion.angular_acceleration, arm), cross(motion.angular_velocity, spin)),
        )

    def point_bias(self, point: Point, name: str) -> Vector:
        """Acceleration of a point at zero generalised accelerations [m/s^2]."""
        motion, arm = self.motion(point.body), self.arm(point, name)
        alpha, bias = self.bias_of(self.link_of(point.body))
        spin = self.tape.vector(cross(motion.angular_velocity, arm), f"{name}_arm_rate")
        return add(bias, cross(alpha, arm), cross(motion.angular_velocity, spin))

    def touch(self, pair: str) -> Any:
        """Contact geometry of the pair of this name, on the tape."""
        return self.mechanism.pair_named[pair].touch(self)

    def velocity_at(self, body: Frame, position: Vector) -> Vector:
        """Velocity of the point of `body` that is at `position` [m/s]."""
        motion = self.motion(body)
        return add(motion.velocity, cross(motion.angular_velocity, sub(position, motion.origin)))

    def of_force(self, link: Link, force: Vector, position: Vector) -> list[Any]:
        """Generalised forces in each row of a link, of a force at `position` on the link or its subtree."""
        if link.kind == "given":
            return self.by_expressions.of_force(link, force, position)  # type: ignore[no-any-return]
        if link.kind == "slide":
            return [dot(force, self.direction_of(link))]
        arm = sub(position, self.origin_of(link))
        if link.kind == "bend":
            back = transpose(self._rod_axes(link))
            push, moment = (
                self.tape.vector(apply(back, vector), f"{link.name}_{label}")
                for vector, label in ((force, "push"), (cross(arm, force), "moment"))
            )
            return [
                dot(slide, push) + dot(turn, moment)
                for slide, turn in zip(link.rod.slides, link.rod.turns, strict=True)
            ]
        if link.kind == "turn":
            return [dot(force, cross(self.direction_of(link), arm))]
        moment = self.tape.vector(cross(arm, force), f"{link.name}_moment")
        return [dot(axis, moment) for axis in transpose(self._turned(link))]

    def partial_turns(self, link: Link) -> list[Vector]:
        """Partial angular velocities of a link and its subtree, by each speed of the link [1]."""
        if link.kind == "given":
            return self.by_expressions.partial_turns(link)  # type: ignore[no-any-return]
        if link.kind == "slide":
            return [ZERO]
        if link.kind == "bend":
            return [apply(self._rod_axes(link), turn) for turn in link.rod.turns]
        return [self.direction_of(link)] if link.kind == "turn" else list(transpose(self._turned(link)))

    def generalised(self, force: Vector, position: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a force on one body and its reaction on another at the same point.

        Links common to both cancel.
        """
        return self._between(on, against, lambda link: self.of_force(link, force, position), name)

    def generalised_moment(self, moment: Vector, on: Frame, against: Frame, name: str) -> dict[str, Any]:
        """Generalised forces, by row, of a moment on one body and its reaction on another."""
        return self._between(on, against, lambda link: [dot(moment, axis) for axis in self.partial_turns(link)], name)

    def _between(self, on: Frame, against: Frame, effect: Callable[[Link], list[Any]], name: str) -> dict[str, Any]:
        first, second = self.link_of(on).path, self.link_of(against).path
        out: dict[str, Any] = {}
        for sign, path, other in ((1, first, second), (-1, second, first)):
            for link in path:
                if link in other:
                    continue
                for row, value in zip(link.rows, effect(link), strict=True):
                    share = self.tape.let(sign * value, f"{name}_on_{row.key.replace('.', '_')}")
                    out[row.key] = out[row.key] + share if row.key in out else share
        return out


def acceleration_of(speed: Port) -> Port:
    """Port of a speed's rate: `<joint>.speed` -> `<joint>.acceleration`."""
    joint, name = speed.name.rsplit(".", 1)
    return Port(f"{joint}.{name.replace('speed', 'acceleration')}", f"{speed.unit}^2")
