"""Springs, dampers and potentials between two frames, by displacement and rotation vector.

The pose of the first frame is taken against the second, along the second's axes: displacement d of its origin, rotation
vector theta (axis times angle). Their rates follow from relative velocities, d' = v and theta' = J^-1 w with the left
Jacobian J of the exponential map; by the same matrices forces follow from the gradient of an energy, so that work and
energy are equal for finite motion, along any path. (Sola, Deray, Atchuthan, A micro Lie theory, arXiv:1812.01537, eq.
146; Bullo, Murray, Proportional derivative control on the Euclidean group (1995).)

In space a rotation beyond half a turn counts the short way round; in plane motion the angle counts whole turns.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import Declared, Element, Kinematics, together
from hertzwerk.derive.declare.effects.springs import BetweenPoints
from hertzwerk.derive.declare.effects.state_expression import as_choice, shown
from hertzwerk.derive.declare.mechanism.bodies import AXES, Point
from hertzwerk.derive.declare.mechanism.pose import APART, ROTATION, TURN, PosedFrames
from hertzwerk.derive.expressions.algebra.functions import Where, slope
from hertzwerk.derive.expressions.algebra.vectors import (
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    cross,
    dot,
    is_zero,
    scale,
    sub,
    transpose,
)
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, Scalar, Slot, default_value, is_number

SIX = ("x", "y", "z", "rotation x", "rotation y", "rotation z")
NEAR = sp.Rational(1, 100)  # square of the sine of half the angle below which series replace quotients
# of asin(s)/s and (1 - asin(s) sqrt(1 - s^2)/s)/s^2 by powers of s^2: rounding remains up to NEAR
ARCS = tuple(sp.Rational(*r) for r in ((1, 1), (1, 6), (3, 40), (5, 112), (35, 1152), (63, 2816), (231, 13312)))
BENDS = tuple(sp.Rational(*r) for r in ((1, 3), (2, 15), (8, 105), (16, 315), (128, 3465), (256, 9009), (1024, 45045)))
INDEFINITE = 1e-9  # pivot of a matrix scaled to a diagonal of ones below which it is negative


@dataclass(frozen=True)
class Pose:
    """Pose of one frame against another, along the axes of the other, with relative velocities.

    axes       of the second frame, as columns in ground axes
    place      of the first frame's origin, ground axes [m]
    part       vector part of the half rotation's quaternion, and `bend`, by which the rotation's rate bends; zero in the plane
    """

    axes: Matrix
    place: Vector
    displacement: Vector
    velocity: Vector
    rotation: Vector
    spin: Vector
    part: Vector
    bend: Any

    @property
    def rate(self) -> Vector:
        """Rate of the rotation vector [rad/s]."""
        return self._curved(self.spin, -1)

    def moment(self, gradient: Vector) -> Vector:
        """Moment that does the work of a gradient by the rotation vector [N m]."""
        return self._curved(gradient, 1)

    def _curved(self, vector: Vector, sign: int) -> Vector:
        """J^-1 of a vector, or its transpose."""
        if is_zero(self.part):
            return vector
        twice = cross(self.part, cross(self.part, vector))
        return add(vector, scale(sp.Rational(sign, 2), cross(self.rotation, vector)), scale(self.bend, twice))


class BetweenFrames(BetweenPoints):
    """Effect between two frames: points of two bodies, with their axes."""

    name: str
    kind: ClassVar[str] = "bushing"
    ends: ClassVar[str] = "frames"

    def pose(self, kin: Kinematics) -> Pose:
        """Pose of the first frame against the second, on the tape."""
        tape, name = kin.tape, self.name
        x, y, z = (kin.direction(self.second, axis) for axis in AXES)
        one, one_rate, _ = kin.point(self.first, f"{name}_first")
        two, two_rate, _ = kin.point(self.second, f"{name}_second")
        w = [kin.angular_velocity(point.body) for point in self.points]

        def along(vector: Vector, label: str) -> Vector:
            return tape.vector(apply((x, y, z), vector), f"{name}_{label}")

        apart = tape.vector(sub(one, two), f"{name}_between")
        velocity = along(sub(sub(one_rate, two_rate), cross(w[1], apart)), "velocity")
        spin = along(sub(*w), "spin")
        rotation, part, bend = self._turned(kin)
        return Pose(transpose((x, y, z)), one, along(apart, "displacement"), velocity, rotation, spin, part, bend)

    def _turned(self, kin: Kinematics) -> tuple[Vector, Vector, Any]:
        """Rotation vector, vector part of the quaternion, and the bend of the rotation's rate."""
        tape, name, plane = kin.tape, self.name, kin.scene.mechanism.plane
        if plane is not None:
            one, two = (kin.turned(point.body, plane) + point.turned_about(plane) for point in self.points)
            return scale(tape.let(one - two, f"{name}_turned"), AXES[plane].unit), ZERO, sp.S.Zero
        turn = kin.turn_between(self.first, self.second, f"{name}_turn")
        sign = Where(turn[0] < 0, -1, 1)
        q0 = tape.let(sp.Abs(turn[0]), f"{name}_cosine")
        part = tape.vector(scale(sign, turn[1:]), f"{name}_part")
        square = tape.let(dot(part, part), f"{name}_square")
        sine = tape.let(sp.sqrt(Where(square > NEAR, square, 1)), f"{name}_sine")
        arc = tape.let(Where(square > NEAR, sp.atan2(sine, q0) / sine, _series(ARCS, square)), f"{name}_arc")
        bend = tape.let(Where(square > NEAR, (1 - arc * q0) / sine**2, _series(BENDS, square)), f"{name}_bend")
        return tape.vector(scale(2 * arc, part), f"{name}_rotation"), part, bend

    def acting(self, kin: Kinematics, pose: Pose, force: Vector, moment: Vector) -> dict[str, Any]:
        """Generalised forces of a force and a moment on the first body, along the second's axes."""
        one, two = (
            kin.tape.vector(apply(pose.axes, v), f"{self.name}_{w}") for v, w in ((force, "force"), (moment, "moment"))
        )
        bodies = self.first.body, self.second.body
        pushed = kin.generalised(one, pose.place, *bodies, self.name)
        return together(pushed, kin.generalised_moment(two, *bodies, self.name))


@dataclass(frozen=True)
class Bushing(BetweenFrames):
    """Elastic mount of one frame in another, by stiffness and damping matrices, 6 x 6.

    They are of the first frame's displacement (x, y, z) and rotation vector against the second, along the second's axes:
    symmetric and positive semidefinite, in N/m, N (for each rad) and N m (for each rad); six values are a diagonal. The
    force is the exact gradient of the energy pose' K pose/2, for any displacement and, in space, up to half a turn.
    Definiteness is checked at the parameters' defaults.
    """

    name: str
    first: Point
    second: Point
    stiffness: tuple[Any, ...]
    damping: tuple[Any, ...] = (0, 0, 0, 0, 0, 0)

    @property
    def text(self) -> str:
        """Description for people."""
        return f"bushing of {self.first.body.name} in {self.second.body.name}"

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of matrices of another shape."""
        yield from super().type_faults()
        for label, entries in (("stiffness", self.stiffness), ("damping", self.damping)):
            rows = entries if isinstance(entries, tuple) else ()
            if (
                len(rows) != 6
                or any(isinstance(row, tuple) and len(row) != 6 for row in rows)
                or len({isinstance(row, tuple) for row in rows}) > 1
            ):
                yield Fault(f"{self.where}, {label}", f"{entries!r:.60}", "six rows of six, or the six of a diagonal")

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield points and the entries of both matrices."""
        yield from super().slots(scene)
        for label, entries, second in (("stiffness", self.stiffness, ""), ("damping", self.damping, " s")):
            for i, row in enumerate(_full(entries)):
                for j, value in enumerate(row):
                    unit = ("N/m", "N", "N m")[(i > 2) + (j > 2)]
                    unit = unit if not second else {"N/m": "N s/m", "N": "N s", "N m": "N m s"}[unit]
                    if i == j or value != 0:
                        yield Slot(f"{self.where}, {label} of {SIX[i]} by {SIX[j]}", value, unit)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of matrices that are not symmetric or not positive semidefinite."""
        yield from super().faults(scene)
        for label, entries in (("stiffness", self.stiffness), ("damping", self.damping)):
            matrix = _full(entries)
            if not all(is_number(value) for row in matrix for value in row):
                continue  # a fault of the quantity
            uneven = [(i, j) for i in range(6) for j in range(i) if sp.expand(matrix[i][j] - matrix[j][i]) != 0]
            for i, j in uneven:
                yield Fault(f"{self.where}, {label}", f"{matrix[i][j]} of {SIX[i]} by {SIX[j]}, {matrix[j][i]} of {SIX[j]} by {SIX[i]}",
                            "a symmetric matrix: else the work depends on the path", "Make both equal.")  # fmt: skip
            if not uneven and not _semidefinite([[default_value(value) for value in row] for row in matrix]):
                yield Fault(f"{self.where}, {label}", "a matrix that feeds some motion, at the defaults",
                            "a positive semidefinite one",
                            "Entries off the diagonal are at most the root of the product of those on it.")  # fmt: skip

    def element(self, kin: Kinematics) -> Element:
        """Force and moment, the stored energy, the dissipated power, and histories of the pose."""
        pose = self.pose(kin)
        at, rate = (*pose.displacement, *pose.rotation), (*pose.velocity, *pose.rate)
        elastic, viscous = _times(_full(self.stiffness), at), _times(_full(self.damping), rate)
        pull = [
            kin.tape.let(a + b, f"{self.name}_gradient_{i}")
            for i, (a, b) in enumerate(zip(elastic, viscous, strict=True), 1)
        ]
        forces = self.acting(kin, pose, scale(-1, tuple(pull[:3])), scale(-1, pose.moment(tuple(pull[3:]))))
        outputs = [
            (f"{self.name}.{quantity}_{axis}", unit, value)
            for quantity, unit, values in (("displacement", "m", pose.displacement), ("rotation", "rad", pose.rotation))
            for axis, value in zip("xyz", values, strict=True)
            if value != 0
        ]
        damped = any(value != 0 for row in _full(self.damping) for value in row)
        return Element(
            forces,
            stored=sp.Add(*(x * y for x, y in zip(elastic, at, strict=True))) / 2,
            dissipated=sp.Add(*(x * y for x, y in zip(viscous, rate, strict=True))) if damped else None,
            outputs=tuple(outputs),
        )


@dataclass(frozen=True)
class SphericalSpring(BetweenFrames):
    """Torsional spring of a ball joint, energy k angle^2/2 of the angle between two frames, and damper.

    The moment is k times the rotation vector, about the axis of the rotation; the damper's c times the relative angular
    velocity. Three stiffnesses are those of the rotation vector's components along the second frame's axes.
    """

    name: str
    first: Point
    second: Point
    stiffness: Scalar | tuple[Scalar, Scalar, Scalar]
    damping: Scalar = 0

    @property
    def text(self) -> str:
        """Description for people."""
        return f"torsional spring of {self.first.body.name} against {self.second.body.name}"

    def type_faults(self) -> Iterator[Fault]:
        """Yield the fault of a stiffness that is neither one value nor three."""
        yield from super().type_faults()
        if isinstance(self.stiffness, tuple) and len(self.stiffness) != 3:
            yield Fault(
                f"{self.where}, stiffness",
                f"{self.stiffness!r:.60}",
                "one value, or three along the second frame's axes",
            )

    @property
    def _stiffness(self) -> tuple[Any, ...]:
        stiffness = self.stiffness
        return stiffness if isinstance(stiffness, tuple) else (stiffness, stiffness, stiffness)

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield points, stiffness, damping."""
        yield from super().slots(scene)
        for value in self._stiffness:
            yield Slot(f"{self.where}, stiffness", value, "N m/rad", NOT_NEGATIVE)
        yield Slot(f"{self.where}, damping", self.damping, "N m s/rad", NOT_NEGATIVE)

    def element(self, kin: Kinematics) -> Element:
        """Moment, the stored energy, the dissipated power, and the history of the rotation."""
        pose = self.pose(kin)
        pull = tuple(sp.sympify(k) * x for k, x in zip(self._stiffness, pose.rotation, strict=True))
        even = not isinstance(self.stiffness, tuple)  # then it is along the rotation vector, which J leaves as it is
        drag = scale(sp.sympify(self.damping), pose.spin)
        moment = scale(-1, add(pull if even else pose.moment(pull), drag))
        return Element(
            self.acting(kin, pose, ZERO, moment),
            stored=dot(pull, pose.rotation) / 2,
            dissipated=dot(drag, pose.spin) if self.damping != 0 else None,
            outputs=tuple(
                (f"{self.name}.rotation_{k}", "rad", x) for k, x in zip("xyz", pose.rotation, strict=True) if x != 0
            ),
        )


@dataclass(frozen=True)
class FramePotential(BetweenFrames):
    """Forces and moments of an energy [J] of the pose of one frame against another.

    An expression of `APART` (m), `ROTATION` (rad) and `TURN`, the directions of the first frame's axes, along the
    second's axes: -m B TURN[2][2] of a magnet along z, k (3 - TURN[0][0] - TURN[1][1] - TURN[2][2])/2 = k (1 - cos(angle)).
    """

    name: str
    first: Point
    second: Point
    energy: Scalar
    kind: ClassVar[str] = "bushing"
    measures: ClassVar[Mapping[str, Slot]] = {"energy": PosedFrames.of("J")}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"energy {shown(self.energy)} of {self.first.body.name} against {self.second.body.name}"

    def element(self, kin: Kinematics) -> Element:
        """Force and moment, and the stored energy."""
        energy, pose, tape = as_choice(sp.sympify(self.energy)), self.pose(kin), kin.tape
        columns = [
            tape.vector(apply(transpose(pose.axes), kin.direction(self.first, axis)), f"{self.name}_turn_{k}")
            for k, axis in zip("xyz", AXES, strict=True)
        ]
        values = dict(zip(APART, pose.displacement, strict=True)) | dict(zip(ROTATION, pose.rotation, strict=True))
        values |= {TURN[i][k]: columns[k][i] for i in range(3) for k in range(3)}

        def gradient(symbols: Sequence[Any]) -> Vector:
            return tuple(tape.let(slope(energy, s).xreplace(values), f"{self.name}_by_{s.name}") for s in symbols)

        by_turn = [gradient([TURN[i][k] for i in range(3)]) for k in range(3)]
        twist = add(ZERO, *(cross(column, slope) for column, slope in zip(columns, by_turn, strict=True)))
        moment = add(pose.moment(gradient(ROTATION)), twist)
        forces = self.acting(kin, pose, scale(-1, gradient(APART)), scale(-1, moment))
        return Element(forces, stored=energy.xreplace(values))


def _series(coefficients: tuple[Any, ...], x: Any) -> Any:
    """Polynomial, by Horner's rule."""
    total = sp.S.Zero
    for coefficient in reversed(coefficients):
        total = coefficient + x * total
    return total


def _full(entries: tuple[Any, ...]) -> tuple[tuple[Any, ...], ...]:
    """Six rows of a matrix, or of a diagonal."""
    if isinstance(entries[0], tuple):
        return entries
    return tuple(tuple(value if i == j else 0 for j in range(6)) for i, value in enumerate(entries))


def _times(matrix: tuple[tuple[Any, ...], ...], vector: Sequence[Any]) -> list[Any]:
    return [sp.Add(*(sp.sympify(k) * x for k, x in zip(row, vector, strict=True))) for row in matrix]


def _semidefinite(matrix: list[list[float]]) -> bool:
    """Whether a symmetric matrix is positive semidefinite: by pivots, scaled to a diagonal of ones."""
    if any(matrix[i][i] < 0 for i in range(6)):
        return False
    sizes = [row[i] ** 0.5 for i, row in enumerate(matrix)]
    if any(x != 0 and sizes[i] * sizes[j] == 0 for i, row in enumerate(matrix) for j, x in enumerate(row)):
        return False
    left = [i for i in range(6) if sizes[i] > 0]
    rest = {(i, j): matrix[i][j] / sizes[i] / sizes[j] for i in left for j in left}
    while left:
        k = max(left, key=lambda i: rest[i, i])
        if rest[k, k] <= INDEFINITE:
            return all(abs(rest[i, j]) <= 10 * INDEFINITE for i in left for j in left)
        left.remove(k)
        for i in left:
            for j in left:
                rest[i, j] -= rest[i, k] * rest[k, j] / rest[k, k]
    return True
