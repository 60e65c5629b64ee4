"""Mechanism whose motion and equations are given as expressions, in place of joints.

Downstream it is a mechanism like any other: its bodies move with the coordinates and speeds, by partial velocities as
all bodies do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.state_expression import coordinate_of, speed_of
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.equations_of_motion import Equations
from hertzwerk.derive.equations.motion.kinematics import Kinematics, Motion
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.equations.motion.spanning_tree import Link, Place, Row
from hertzwerk.derive.expressions.algebra.vectors import IDENTITY, ZERO, Matrix, Vector, add, cross, dot, scale, sub
from hertzwerk.derive.expressions.parameter import Slot

Columns = Mapping[str, Vector]
"""Partial velocities by row."""

MASSES = ("kg", "g", "mg", "t")
_GROUPS = {
    "m": "given_lengths",
    "1": "given_angles",
    "m/s": "given_speeds",
}  # by unit: one alone may vanish at a position


Linear = tuple[Mapping[str, Any], Any]
"""Expression that is linear in the speeds: coefficient by row, and the rest."""


@dataclass(frozen=True, eq=False)
class Placed:
    """Motion of a body as expressions: axes, origin [m], velocity [m/s] and angular velocity [rad/s].

    Along the ground's axes. `velocity` and `angular_velocity` are three expressions that are linear in the speeds.
    """

    axes: Matrix
    origin: Vector
    velocity: tuple[Linear, Linear, Linear]
    angular_velocity: tuple[Linear, Linear, Linear]

    def stays_across(self, k: int) -> bool:
        """Whether it moves in planes perpendicular to a coordinate axis, by structure."""
        across = [self.velocity[k], *(self.angular_velocity[i] for i in range(3) if i != k)]
        still = all(rest == 0 and all(share == 0 for share in shares.values()) for shares, rest in across)
        return still and self.axes[k][k] == 1


@dataclass(frozen=True)
class Condition:
    """Constraint: its value, or 0 of one on speeds, and its rate, linear in the speeds.

    unit  m, 1 (an angle), or m/s of a constraint on speeds alone
    """

    name: str
    unit: str
    value: Any
    rate: Linear


@dataclass(frozen=True, eq=False)
class Description:
    """Motion and equations of a mechanism as expressions, in place of joints.

    They are of Parameters, `T`, coordinates and speeds (`coordinate_of`, `speed_of`), inputs, and of the symbols of `steps`, a straight-line program.

    coordinates   freedoms: of one coordinate and its rate, or `given` ones, of a coordinate or a speed alone
    measured      `given` coordinates with their rates, and speeds without a coordinate (`uncounted`), for effects on them
    rates         key of a `given` coordinate -> its rate
    steps         symbols and expressions of what other expressions share, in order
    mass, bias, potential    equations M du/dt + bias = forces, by rows, and the potential energy in them [J]
    quantities    parameters and what varies, with their units
    contradictions  velocities that are taken as they were set: where, as they were set, and as they follow from positions and axes
    """

    coordinates: tuple[Freedom, ...]
    measured: tuple[Freedom, ...]
    uncounted: tuple[str, ...]
    rates: Mapping[str, Linear]
    steps: tuple[tuple[sp.Symbol, Any], ...]
    places: Mapping[str, Placed]
    mass: Mapping[tuple[str, str], Any]
    bias: Mapping[str, Any]
    potential: Any
    conditions: tuple[Condition, ...]
    quantities: tuple[Slot, ...]
    contradictions: tuple[tuple[str, str, str], ...] = ()


@dataclass(frozen=True, init=False)
class Carried(Joint):
    """Relation of a body to the ground where its motion is given; it is no joint of the mechanism."""

    moved_by: tuple[Freedom, ...]

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Every freedom of the mechanism."""
        return self.moved_by


@dataclass(frozen=True)
class MechanismByExpressions(Mechanism):
    """Mechanism of bodies whose motion is given by a description; it has no joints."""

    moved: tuple[Body, ...] = ()
    description: Description = field(kw_only=True)

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The bodies, in their order."""
        return self.moved

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The freedoms of the description."""
        return self.description.coordinates

    @property
    def dependent_freedoms(self) -> tuple[Freedom, ...]:
        """Coordinates with their rates, and speeds, where these are no freedoms."""
        return self.description.measured

    @property
    def uncounted(self) -> tuple[str, ...]:
        """Keys of speeds without a coordinate."""
        return self.description.uncounted

    @property
    def contradictions(self) -> tuple[tuple[str, str, str], ...]:
        """Velocities of the description that its positions and axes contradict, and what follows from these."""
        return self.description.contradictions

    @property
    def plane(self) -> int | None:
        """Coordinate axis normal to the motion of all bodies, by structure; None in space."""
        places = [self.description.places[body.name] for body in self.moved]
        return next((k for k in (2, 1, 0) if all(place.stays_across(k) for place in places)), None)

    @property
    def total_mass(self) -> Any:
        """Mass by which energies are scaled [kg]: of the bodies, else all masses among the parameters."""
        masses = [slot.value for slot in self.description.quantities if slot.unit in MASSES]
        return super().total_mass or sp.Add(*masses)

    def joint_of(self, body: Frame) -> Joint | None:
        """Relation of a body to the ground; None for the ground."""
        if body not in self.moved:
            return None
        place = self.description.places[body.name]
        still = all(
            not any(map(bool, shares.values())) and rest == 0
            for shares, rest in (*place.velocity, *place.angular_velocity)
        )
        return Carried(body.name, Point(GROUND), Point(body), moved_by=() if still else self.freedoms)

    def slots(self) -> Iterator[Slot]:
        """Yield every quantity, in declared order."""
        yield from self.description.quantities
        yield from super().slots()

    def motion_by_expressions(self, kinematics: Any) -> MotionByExpressions:
        """Its motion on the tape of a kinematics."""
        return MotionByExpressions(kinematics, self.description)


class MotionByExpressions:
    """Expressions of a description on a tape; links of kind `given`, one a body, move by them."""

    def __init__(self, kinematics: Kinematics, description: Description) -> None:
        self.kin, self.tape, self.description = kinematics, kinematics.tape, description
        self.rotation, self.motion, self.bias = cache(self._rotation), cache(self._motion), cache(self._bias)
        self._partial = cache(self._partial_velocities)
        self.rows = {row.key: row for freedom in description.coordinates for row in kinematics.motions[freedom.key][1]}
        self._speeds = {
            freedom.key: kinematics.motion_of_freedom(freedom)[1][0]
            for freedom in description.coordinates
            if freedom.speeds
        }
        self._coordinates = {
            freedom.key: kinematics.motion_of_freedom(freedom)[0][0]
            for freedom in description.coordinates
            if freedom.coordinates
        }
        self._steps: dict[sp.Symbol, Any] = {coordinate_of(key): symbol for key, symbol in self._coordinates.items()}
        self._steps |= {speed_of(key): symbol for key, symbol in self._speeds.items()}
        for symbol, expression in description.steps:
            self._steps[symbol] = self.tape.let(self.of(expression), symbol.name)
        self._rates = {key: self._linear(rate, f"{key}_by") for key, rate in description.rates.items()}
        for key, (shares, rest) in self._rates.items():
            rate = self.tape.let(self._total(shares, rest), f"{key}_rate")
            kinematics.rates.append(rate)
            self.tape.set_rate(self._coordinates[key], rate)
        self._add_links()

    def _add_links(self) -> None:
        """Add a link for each body to the tree, and one, with the rows, for the whole."""
        tree = self.kin.tree
        still, rows = tree.ground.orientation, tuple(self.rows.values())
        freedom = Freedom("given", "", None, (), (), ())
        tree.links.append(Link("whole", tree.ground, None, freedom, (), rows, ZERO, ZERO, still))
        tree.children[tree.links[-1]] = []
        for body in self.kin.mechanism.bodies:
            link = Link(body.name, tree.ground, None, freedom, (), rows, ZERO, ZERO, still)
            tree.children[link] = []
            tree.places[body] = Place(link, ZERO, IDENTITY)

    def of(self, expression: Any) -> Any:
        """An expression of the description on the tape."""
        return self.kin.expression(sp.sympify(expression).xreplace(self._steps))

    def coordinate(self, key: str) -> Any:
        """A coordinate on the tape."""
        return self._coordinates[key]

    def speed(self, key: str) -> Any:
        """A speed, or the rate of a coordinate, on the tape."""
        return self._speeds[key] if key in self._speeds else self._total(*self._rates[key])

    def measured(self, key: str) -> tuple[Any, Any, Any, dict[str, Any]]:
        """Coordinate, its rate, bias and column; of a speed without a coordinate its value alone."""
        if key in self._speeds:
            row = self.rows[key]
            return None, row.speed, sp.S.Zero if row.free else row.acceleration, {key: sp.S.One}
        shares, rest = self._rates[key]
        bias = self._drift(shares, rest, f"{key}_bias")
        return self._coordinates[key], self._total(shares, rest), bias, {k: s for k, s in shares.items() if s != 0}

    # -- links ---------------------------------------------------------------------------------------------------------

    def _rotation(self, link: Link) -> Matrix:
        """Rotation matrix from a body's axes to the ground's."""
        x, y, z = ((self.of(a), self.of(b), self.of(c)) for a, b, c in self.description.places[link.name].axes)
        return self.tape.matrix((x, y, z), f"{link.name}_R")

    def origin(self, link: Link) -> Vector:
        """Position of a body's origin [m]."""
        x, y, z = map(self.of, self.description.places[link.name].origin)
        return self.tape.vector((x, y, z), link.name)

    def turned(self, body: Frame, k: int) -> Any:
        """Angle of a body against the ground about a coordinate axis [rad], up to whole turns."""
        link = self.kin.link_of(body)
        if link.parent is None:
            return sp.S.Zero
        R, i, j = self.rotation(link), (k + 1) % 3, (k + 2) % 3
        return self.tape.let(sp.atan2(R[j][i], R[i][i]), f"{body.name}_turned")

    def _partial_velocities(self, link: Link) -> tuple[tuple[Columns, Vector], tuple[Columns, Vector]]:
        """Partial velocities and the rest, of a body's origin and of its turning."""
        place = self.description.places[link.name]
        origin = self._vector(place.velocity, f"{link.name}_v")
        return origin, self._vector(place.angular_velocity, f"{link.name}_w")

    def _vector(self, components: tuple[Linear, Linear, Linear], name: str) -> tuple[Columns, Vector]:
        parts = [self._linear(part, f"{name}_{axis}") for part, axis in zip(components, "xyz", strict=True)]
        columns = {key: tuple(shares.get(key, sp.S.Zero) for shares, _ in parts) for key in self.rows}
        x, y, z = (rest for _, rest in parts)
        return columns, (x, y, z)

    def _motion(self, link: Link) -> Motion:
        """Motion of a body."""
        tape, name = self.tape, link.name
        origin, (alpha, acceleration) = self.kin.origin_of(link), self.kin.bias_of(link)
        (v, v_rest), (w, w_rest) = self._partial(link)
        velocity = tape.vector(
            add(v_rest, *(scale(row.speed, v[key]) for key, row in self.rows.items())), f"{name}_velocity"
        )
        rate = tape.vector(add(w_rest, *(scale(row.speed, w[key]) for key, row in self.rows.items())), f"{name}_rate")
        free = [(key, row.acceleration) for key, row in self.rows.items() if row.free]
        alpha = tape.vector(add(alpha, *(scale(a, w[key]) for key, a in free)), f"{name}_angular_acceleration")
        acceleration = tape.vector(add(acceleration, *(scale(a, v[key]) for key, a in free)), f"{name}_acceleration")
        for position, speed, second in zip(origin, velocity, acceleration, strict=True):
            tape.set_rate(position, speed)
            tape.set_rate(speed, second)
        return Motion(self.rotation(link), origin, rate, velocity, alpha, acceleration)

    def _bias(self, link: Link) -> tuple[Vector, Vector]:
        """Angular acceleration and acceleration of a body at zero generalised accelerations."""
        biases = []
        for (columns, rest), label in zip(reversed(self._partial(link)), ("angular_bias", "bias"), strict=True):
            parts = [
                self._drift(
                    {key: column[k] for key, column in columns.items()}, rest[k], f"{link.name}_{label}_{'xyz'[k]}"
                )
                for k in range(3)
            ]
            biases.append((parts[0], parts[1], parts[2]))
        return biases[0], biases[1]

    def of_force(self, link: Link, force: Vector, position: Vector) -> list[Any]:
        """Generalised forces in each row, of a force on a body at `position`."""
        (v, _), (w, _) = self._partial(link)
        arm = sub(position, self.kin.origin_of(link))
        return [dot(force, add(v[row.key], cross(w[row.key], arm))) for row in link.rows]

    def partial_turns(self, link: Link) -> list[Vector]:
        """Partial angular velocities of a body [1]."""
        (w, _) = self._partial(link)[1]
        return [w[row.key] for row in link.rows]

    # -- constraints and equations -------------------------------------------------------------------------------------

    @cached_property
    def constraints(self) -> list[Constraint]:
        """Constraints of the description."""
        constraints = []
        for condition in self.description.conditions:
            name = condition.name.replace(".", "_")
            shares, rest = self._linear(condition.rate, f"{name}_by")
            constraints.append(
                Constraint(
                    condition.name, condition.unit, _GROUPS[condition.unit],
                    self.tape.let(self.of(condition.value), f"{name}_left"),
                    self.tape.let(self._total(shares, rest), f"{name}_rate"),
                    self._drift(shares, rest, f"{name}_bias"),
                    {key: share for key, share in shares.items() if share != 0},
                )
            )  # fmt: skip
        return constraints

    def equations(self, scene: Scene) -> Equations:
        """Equations of motion of the description."""
        return EquationsByExpressions(self, scene)

    def _linear(self, linear: Linear, name: str) -> tuple[dict[str, Any], Any]:
        shares, rest = linear
        named = {key: self.tape.let(self.of(share), f"{name}_{key}") for key, share in shares.items()}
        return named, self.tape.let(self.of(rest), f"{name}_rest")

    def _total(self, shares: Mapping[str, Any], rest: Any) -> Any:
        return sp.Add(rest, *(share * self.rows[key].speed for key, share in shares.items()))

    def _drift(self, shares: Mapping[str, Any], rest: Any, name: str) -> Any:
        """Rate of what is linear in the speeds, at zero generalised accelerations; drives' are included."""
        bent = [self.tape.rate(share, f"{name}_{key}") * self.rows[key].speed for key, share in shares.items()]
        driven = [share * self.rows[key].acceleration for key, share in shares.items() if not self.rows[key].free]
        return self.tape.let(sp.Add(self.tape.rate(rest, f"{name}_rest"), *bent, *driven), name)


class EquationsByExpressions(Equations):
    """Equations M du/dt + bias = f as they were given."""

    def __init__(self, motion: MotionByExpressions, scene: Scene) -> None:
        super().__init__(motion.kin, scene)
        self.motion, self.expressions = motion, motion.description

    def _mass_matrix(self) -> dict[tuple[str, str], Any]:
        entries = {
            (row, other): self.tape.let(self.motion.of(value), f"M_{row}_{other}")
            for (row, other), value in self.expressions.mass.items()
        }
        return {key: value for key, value in entries.items() if value != 0}

    def _longest_path(self) -> int:
        """0: the rows are not those of joints."""
        return 0

    def bias(self, row: Row) -> Any:
        """Generalised inertia force at zero generalised accelerations, and the force of the potential."""
        mass = self.mass_matrix()
        driven = [
            mass[row.key, other.key] * other.acceleration for other in self.driven if (row.key, other.key) in mass
        ]
        return self.tape.let(sp.Add(self.motion.of(self.expressions.bias[row.key]), *driven), f"{row.key}_bias")

    def gravity(self, row: Row) -> Any:
        """Generalised force of the effects of gravity."""
        pull, total = self._gravity_vector(), []
        for body in self.scene.mechanism.bodies if self.scene.all(Gravity) else ():
            link = self.kin.link_of(body)
            force = scale(sp.sympify(body.mass), pull)
            total.append(self.motion.of_force(link, force, self.kin.centre(body))[link.rows.index(row)])
        return sp.Add(*total)

    def kinetic(self) -> Any:
        """Kinetic energy, quadratic in the speeds [J]."""
        speeds = {row.key: row.speed for row in self.rows}
        terms = [value * speeds[row] * speeds[other] / 2 for (row, other), value in self.mass_matrix().items()]
        return self.tape.let(sp.Add(*terms), "kinetic")

    def potential(self) -> Any:
        """Potential energy of gravity and of the given equations [J]."""
        return self.tape.let(super().potential() + self.motion.of(self.expressions.potential), "potential")
