"""Controllers: signals, as expressions for motors and forces, that keep a speed or switch by another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import unit_faults
from hertzwerk.derive.declare.effects.effect import (
    NOWHERE,
    Declared,
    Effect,
    Element,
    Event,
    JointEffect,
    Kinematics,
    State,
)
from hertzwerk.derive.declare.effects.state_expression import Varying, shown, speed_of, state_of
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot, default_value, is_number


@dataclass(frozen=True)
class SpeedController(JointEffect):
    """PI controller of a joint's speed, continuous or sampled.

    Its `command` is proportional e + integral int e dt, with e = target - speed, in `unit`: a `JointForce` (N m) or a
    `DCMotor` (V) takes `controller.command`. Without a period it is continuous, with the state `<name>.error` [rad or
    m], the integral. With a `period` [s] it is sampled: at 0, period, 2 period, .. the speed is read, and the command
    `<name>.command` [unit] held until the next; the integral is then the sum of the errors read before times the period.
    Astrom, Wittenmark, Computer-Controlled Systems, 3rd ed. (1997), chapter 8.

    A command with a `limit`, between -limit and limit or two values (low, high), does not wind up: what the limit cuts
    off is led back to the integral, over the time `tracking`, by default proportional/integral. Astrom, Hagglund,
    Advanced PID Control (2006), section 3.5.
    """

    name: str
    joint: str
    target: Scalar
    proportional: Scalar
    integral: Scalar
    unit: str
    period: Scalar | None = None
    limit: Scalar | tuple[Scalar, Scalar] | None = None
    tracking: Scalar | None = None
    kind: ClassVar[str] = "speed_controller"
    enters: ClassVar[str] = NOWHERE
    measures: ClassVar[Mapping[str, Slot]] = {
        "target": Varying.of("{speed}"),
        "proportional": Slot.of("{command}/({speed})", NOT_NEGATIVE, "proportional gain"),
        "integral": Slot.of("{command}/{coordinate}", NOT_NEGATIVE, "integral gain"),
        "period": Slot.of("s", POSITIVE),
        "tracking": Slot.of("s", POSITIVE, "tracking time"),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        how = "" if self.period is None else f", sampled each {shown(self.period)}"
        how += (
            "" if not self._bounded else f", its command between {shown(self._limits[0])} and {shown(self._limits[1])}"
        )
        return f"PI controller that keeps the speed of {self.joint} at {shown(self.target)}{how}"

    @property
    def command(self) -> Any:
        """Command [unit], an expression for other effects."""
        if self.period is not None:
            return state_of(f"{self.name}.command")
        error = self.target - speed_of(self.joint)
        return self._limited(self.proportional * error + self.integral * state_of(f"{self.name}.error"))

    @property
    def _limits(self) -> tuple[Any, Any]:
        """Least and largest command."""
        limit: Any = self.limit
        return limit if isinstance(limit, tuple) else (-limit, limit)

    @property
    def _bounded(self) -> bool:
        """Whether there are limits; what is none is a fault that the scene reports, and text is never read."""
        limits = self.limit if isinstance(self.limit, tuple) else (self.limit,) * 2
        return len(limits) == 2 and all(map(is_number, limits))

    def _limited(self, command: Any) -> Any:
        """The command within its limits."""
        if not self._bounded:
            return command
        low, high = self._limits
        return Where(command > high, high, Where(command < low, low, command))

    def _cut(self, command: Any, limited: Any) -> Any:
        """Rate of the integral by what the limits cut off the command [rad/s or m/s]."""
        if self.limit is None:
            return sp.S.Zero
        by = self.proportional if self.tracking is None else self.integral * self.tracking
        return (limited - command) / by

    def units(self, scene: Declared) -> Mapping[str, str]:
        """Units of the joint and of the command."""
        return {**super().units(scene), "command": self.unit}

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the target, the gains, the times and the limits."""
        yield from super().slots(scene)
        if isinstance(self.limit, tuple):
            for bound, value in zip(("least", "largest"), self.limit, strict=True):
                yield Slot(f"{self.where}, {bound} command", value, self.unit)
        elif self.limit is not None:
            yield Slot(f"{self.where}, limit", self.limit, self.unit, POSITIVE)

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of an invalid unit and of invalid limits."""
        yield from super().type_faults()
        yield from unit_faults(self.where, self.unit, "the unit of its command, such as N m or V")
        where, limits = f"{self.where}, limit", self.limit if isinstance(self.limit, tuple) else (self.limit,)
        if len(limits) > 2 or not (self.limit is None or all(map(is_number, limits))):
            yield Fault(where, repr(self.limit), "the largest command, or the least and the largest, (low, high)")
        elif self.limit is None and self.tracking is not None:
            yield Fault(
                f"{self.where}, tracking time",
                shown(self.tracking),
                "a limit beside it",
                "Without a limit nothing winds up.",
            )
        elif self.limit is not None and self.tracking is None and self.proportional == 0:
            yield Fault(where, "a limit without a proportional gain or a tracking time", "one of them",
                        "tracking=... is the time constant of anti-windup by back-calculation.")  # fmt: skip
        elif len(limits) == 2 and not default_value(limits[0]) < default_value(limits[1]):
            actual = " and ".join(f"{default_value(x):g}" for x in limits)
            yield Fault(where, f"{actual} [SI], at the defaults", "the least command first")

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the integral of the error; sampled also the command, and the time to the next sample."""
        coordinate, speed, _ = self.freedom(scene).units
        yield State("error", coordinate)
        if self.period is not None:
            yield State("command", self.unit, size=self._size(scene, coordinate, speed))
            yield State("countdown", "s", size=self.period)

    def _size(self, scene: Declared, coordinate: str, speed: str) -> Any:
        """Size of the command: that of errors as large as the scene's scales."""
        sizes, gains = scene.scales.by_unit, (self.proportional, self.integral)
        if speed not in sizes or not all(map(is_number, gains)):
            return None  # faults reported by the scene
        proportional, integral = gains
        return sp.sympify(proportional) * sizes[speed] + sp.sympify(integral) * sizes[coordinate]

    def element(self, kin: Kinematics) -> Element:
        """Rate of the integral, or the samples."""
        integral = kin.state(f"{self.name}.error")
        error = kin.tape.let(kin.expression(self.target) - kin.speed(self.joint), f"{self.name}_speed_error")
        wanted = self.proportional * error + self.integral * integral
        if self.limit is not None:
            wanted = kin.tape.let(wanted, f"{self.name}_wanted")
        limited = self._limited(wanted)
        rate = error + self._cut(wanted, limited)
        if self.period is None:
            return Element(rates={"error": rate})
        countdown = kin.state(f"{self.name}.countdown")
        then = {
            "error": integral + self.period * rate,
            "command": limited,
            "countdown": countdown + self.period,
        }
        sample = Event("sample", margin=countdown, size=self.period, then=then)
        return Element(rates={"countdown": sp.S.NegativeOne}, events=(sample,))


@dataclass(frozen=True)
class Relay(Effect):
    """Relay with hysteresis.

    Its `output` is 1, from signal = hysteresis on -1, and from signal = -hysteresis on 1 again. The signal is an
    expression in `unit`; other effects take `relay.output`, a state [1], as in thrust * relay.output. Switching is
    located to the tolerance beside `size`, by default the scene's scale of that unit. Without hysteresis a relay may
    switch as fast as that lets it. Tsypkin, Relay Control Systems (1984), chapter 1.
    """

    name: str
    signal: Scalar
    unit: str
    hysteresis: Scalar = 0
    size: Scalar | None = None
    start: int = 1
    kind: ClassVar[str] = "relay"
    enters: ClassVar[str] = NOWHERE
    measures: ClassVar[Mapping[str, Slot]] = {
        "signal": Varying.of("{signal}"),
        "hysteresis": Slot.of("{signal}", NOT_NEGATIVE),
        "size": Slot.of("{signal}", POSITIVE),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"relay by {shown(self.signal)}"

    @property
    def output(self) -> Any:
        """Output, 1 or -1, an expression for other effects."""
        return state_of(f"{self.name}.output")

    def units(self, scene: Declared) -> Mapping[str, str]:
        """Unit of the signal."""
        return {"signal": self.unit}

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of an invalid unit, and of a start other than 1 or -1."""
        yield from super().type_faults()
        yield from unit_faults(self.where, self.unit, "the unit of its signal, such as m/s")
        if self.start not in (1, -1):
            yield Fault(self.where, f"start {self.start!r}", "1 or -1")

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield the fault of a signal that the scene has no scale for."""
        yield from super().faults(scene)
        if self.size is None and self.unit != "1" and self.unit not in scene.scales.by_unit:
            yield Fault(self.where, f"no size of a signal in {self.unit}", "one that switching is located beside",
                        f"size=...; without one it is the scene's scale in {', '.join(scene.scales.by_unit)}.")  # fmt: skip

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the output."""
        yield State("output", "1", self.start)

    def element(self, kin: Kinematics) -> Element:
        """Switching."""
        output, scale = kin.state(f"{self.name}.output"), kin.scene.scales.by_unit.get(self.unit, sp.S.One)
        margin = self.hysteresis - output * kin.expression(self.signal)
        size = sp.S.One if self.unit == "1" else scale
        switch = Event("switch", margin, size if self.size is None else self.size, {"output": -output})
        return Element(events=(switch,))
