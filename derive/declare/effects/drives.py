"""Drives: the motion of a joint as a function of time. A driven joint has no freedom.

A declared position is a closed form. A declared speed or acceleration is integrated with the states, from a position
(and speed) at t = 0. The smoothness of a motion affects methods of high order: at a kink a run keeps its accuracy by
shorter steps.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import NOWHERE, Declared, JointEffect, joint_faults
from hertzwerk.derive.declare.effects.state_expression import INPUT, TIME, T, Varying, as_choice, shown
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class Motion:
    """Motion of a drive: `law` is the derivative of order `order` of the position with respect to time.

    `start` holds the values of the lower derivatives at t = 0.
    """

    law: Any
    order: int = 0
    start: tuple[Any, ...] = ()


class AnyDrive(JointEffect):
    """Base class of drives, which declare their `motion`.

    They have no element: the kinematics contains the motion, and the joint's coordinate is removed.
    """

    kind: ClassVar[str] = "drive"
    enters: ClassVar[str] = NOWHERE
    drawn: ClassVar[bool] = True

    @property
    def motion(self) -> Motion:
        """Motion of the joint."""
        raise NotImplementedError

    @property
    def integrates(self) -> bool:
        """Whether the motion is integrated with the states."""
        return False

    @property
    def only(self) -> str:
        """Description of the one on a joint."""
        return f"drive of joint {self.joint}"

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield the fault of a joint that does not carry its body, beside those of any effect on a joint."""
        dependent = [freedom.key for freedom in scene.mechanism.dependent_freedoms]
        yield from (
            joint_faults(self.where, self.joint, scene, carried=True)
            if self.joint in dependent
            else super().faults(scene)
        )


@dataclass(frozen=True)
class ConstantSpeed(AnyDrive):
    """Drive at constant speed, from coordinate 0 at t = 0; removes the joint's coordinate.

    For a joint with several coordinates one is named: `joint="column.angle"`.
    """

    name: str
    joint: str
    speed: Scalar
    measures: ClassVar[Mapping[str, Slot]] = {"speed": Slot.of("{speed}")}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"constant speed of {self.joint}"

    @property
    def motion(self) -> Motion:
        """Position speed t."""
        return Motion(sp.sympify(self.speed) * T)


@dataclass(frozen=True)
class Ramp(AnyDrive):
    """Drive from rest at coordinate 0: its speed rises to `speed` within the time `rise`, and stays.

    The rise is the polynomial of least degree whose first `smoothness` derivatives vanish at both ends: 0 is a
    straight line (constant acceleration, which jumps at both ends), 2 has a continuous acceleration and jerk. The
    displacement of the rise is speed rise/2 in any case.
    """

    name: str
    joint: str
    speed: Scalar
    rise: Scalar
    smoothness: int = 2
    measures: ClassVar[Mapping[str, Slot]] = {"speed": Slot.of("{speed}"), "rise": Slot.of("s", POSITIVE)}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"speed of {self.joint} rising to a constant, {self.smoothness} derivatives of it continuous"

    @property
    def motion(self) -> Motion:
        """Integral of the rise, then a constant speed."""
        speed, rise, n, x = sp.sympify(self.speed), sp.sympify(self.rise), self.smoothness, sp.Dummy("x")
        terms = (sp.binomial(n + k, k) * sp.binomial(2 * n + 1, n - k) * (-x) ** k for k in range(n + 1))
        way = sp.horner(sp.integrate(sp.expand(x ** (n + 1) * sp.Add(*terms)), x)).subs(x, T / rise)
        return Motion(speed * Where(rise > T, rise * way, T - rise / 2))

    def type_faults(self) -> Iterator[Fault]:
        """Yield the fault of an invalid smoothness."""
        yield from super().type_faults()
        if isinstance(self.smoothness, bool) or not isinstance(self.smoothness, int) or not 0 <= self.smoothness <= 4:
            yield Fault(f"{self.where}, smoothness", repr(self.smoothness), "a whole number from 0 to 4")


@dataclass(frozen=True)
class Harmonic(AnyDrive):
    """Drive of a joint's coordinate at mean + amplitude sin(frequency t + phase); frequency in rad/s."""

    name: str
    joint: str
    amplitude: Scalar
    frequency: Scalar
    phase: Scalar = 0
    mean: Scalar = 0
    measures: ClassVar[Mapping[str, Slot]] = {
        "amplitude": Slot.of("{coordinate}"),
        "frequency": Slot.of("rad/s"),
        "phase": Slot.of("rad"),
        "mean": Slot.of("{coordinate}"),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"harmonic motion of {self.joint}"

    @property
    def motion(self) -> Motion:
        """The closed form."""
        return Motion(self.mean + self.amplitude * sp.sin(self.frequency * T + self.phase))


@dataclass(frozen=True)
class Drive(AnyDrive):
    """Drive with position, speed or acceleration as an expression of time T, parameters, tables, inputs.

    Exactly one of them is given. A speed is integrated from the coordinate `start`, an acceleration also from the
    speed `start_speed`. A `Table` given for the position has a continuous acceleration; a run refuses values of an
    `Input` without one, as those joined by straight lines: samples of a position or speed are "cubic".
    """

    name: str
    joint: str
    position: Scalar | None = None
    speed: Scalar | None = None
    acceleration: Scalar | None = None
    start: Scalar = 0
    start_speed: Scalar = 0
    measures: ClassVar[Mapping[str, Slot]] = {
        "position": Varying.of("{coordinate}", on=(TIME, INPUT), derivatives=2),
        "speed": Varying.of("{speed}", on=(TIME, INPUT), derivatives=1),
        "acceleration": Varying.of("{coordinate}/s^2", on=(TIME, INPUT)),
        "start": Slot.of("{coordinate}"),
        "start_speed": Slot.of("{speed}"),
    }

    @property
    def _stated(self) -> list[tuple[int, str, Any]]:
        laws = enumerate((("position", self.position), ("speed", self.speed), ("acceleration", self.acceleration)))
        return [(order, quantity, law) for order, (quantity, law) in laws if law is not None]

    @property
    def text(self) -> str:
        """Description for people."""
        return ", ".join(f"{quantity} of {self.joint} = {shown(law)}" for _, quantity, law in self._stated)

    @property
    def integrates(self) -> bool:
        """Whether a speed or acceleration is given."""
        return self.position is None

    @property
    def motion(self) -> Motion:
        """Motion as declared."""
        order, _, law = self._stated[0]
        return Motion(as_choice(law), order, (self.start, self.start_speed)[:order])

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of several laws or none, and of initial values the law does not need."""
        yield from super().type_faults()
        if len(self._stated) != 1:
            actual = " and ".join(quantity for _, quantity, _ in self._stated) or "none of them"
            yield Fault(self.where, actual, "one of position, speed and acceleration", "The others follow from it.")
            return
        order, quantity, _ = self._stated[0]
        for name, value, needed in (("start", self.start, 1), ("start_speed", self.start_speed, 2)):
            if order < needed and value != 0:
                yield Fault(
                    self.where,
                    f"{name} {value} beside a {quantity}",
                    f"{name} 0",
                    f"The {quantity} determines where it begins.",
                )
