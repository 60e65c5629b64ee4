"""Electric motors: a torque or a force by a current, which a voltage drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.declare.effects.effect import Declared, Element, JointEffect, Kinematics, State
from hertzwerk.derive.declare.effects.state_expression import Varying, shown
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot, is_number


@dataclass(frozen=True)
class DCMotor(JointEffect):
    """Direct-current motor on a joint: L di/dt = voltage - R i - constant speed; its torque is constant i.

    The constant is the torque for each ampere and the back EMF for each rad/s; on a prismatic joint (a linear motor)
    the force for each ampere. The voltage is any expression, `controller.command` of a `SpeedController` for one. The
    rotor's inertia is the body's. State `<name>.current` [A]; energy is stored in the inductance, lost in the resistance,
    and put in by the voltage. Leonhard, Control of Electrical Drives, 3rd ed. (2001), chapter 5.
    """

    name: str
    joint: str
    voltage: Scalar
    resistance: Scalar
    inductance: Scalar
    constant: Scalar
    start_current: Scalar = 0
    kind: ClassVar[str] = "motor"
    drawn: ClassVar[bool] = True
    measures: ClassVar[Mapping[str, Slot]] = {
        "voltage": Varying.of("V"),
        "resistance": Slot.of("ohm", POSITIVE),
        "inductance": Slot.of("H", POSITIVE),
        "constant": Slot.of("{force}/A"),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"direct-current motor on {self.joint} at the voltage {shown(self.voltage)}"

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the current, with the size of that which the back EMF at the scene's speed would drive."""
        scales, size = scene.scales, None
        scales = scales if is_number(scales.arm) else replace(scales, arm=scales.length)  # which is a fault of its own
        speed = scales.by_unit.get(self.freedom(scene).units[1])
        if speed is not None and is_number(self.constant) and is_number(self.resistance):  # else faults of the scene
            size = sp.Abs(sp.sympify(self.constant)) * speed / self.resistance
        yield State("current", "A", self.start_current, size)

    def element(self, kin: Kinematics) -> Element:
        """Force, energy of the inductance, heat of the resistance, electric power, and the current's rate."""
        current, speed = kin.state(f"{self.name}.current"), kin.speed(self.joint)
        voltage = kin.tape.let(kin.expression(self.voltage), f"{self.name}_voltage")
        force = kin.tape.let(self.constant * current, f"{self.name}_force")
        drop = kin.tape.let(voltage - self.resistance * current - self.constant * speed, f"{self.name}_drop")
        unit = "N m" if kin.scene.scalars[self.joint].kind == "turn" else "N"
        return Element(
            kin.on_joint(self.joint, force, self.name),
            stored=self.inductance * current**2 / 2,
            dissipated=self.resistance * current**2,
            input=voltage * current,
            outputs=(
                (f"{self.name}.voltage", "V", voltage),
                (f"{self.name}.{'torque' if unit == 'N m' else 'force'}", unit, force),
            ),
            rates={"current": drop / self.inductance},
        )
