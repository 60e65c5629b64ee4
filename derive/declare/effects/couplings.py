"""Couplings: a holonomic equation between coordinates and time, held by the force that it takes.

Gears, racks, belts, screws and differentials are such equations. They are constraints of the equations of motion, as
those of joints that close loops (`derive.motion.constraints`): without compliance, mass or loss of their own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.units import UnitError
from hertzwerk.derive.declare.effects.drives import AnyDrive
from hertzwerk.derive.declare.effects.effect import NOWHERE, Declared, Effect, Mark, joint_faults
from hertzwerk.derive.declare.effects.state_expression import (
    COORDINATE,
    TIME,
    Varying,
    coordinate_of,
    shown,
    state_dimension,
    states_in,
)
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, apply, dot, scale, sub
from hertzwerk.derive.expressions.dimension.dimension import Dimension, DimensionError
from hertzwerk.derive.expressions.dimension.walker import dimension_of
from hertzwerk.derive.expressions.parameter import Scalar, Slot, default_value, dimensions_of, is_number, parameters_of
from hertzwerk.derive.program.expression_text import EmitError, expression_text

LENGTH, ANGLE = "m", "1"
_ALIGNED = 1e-9  # cosine of a right angle, for pictures
_KINKED = (sp.Max, sp.Min, sp.Abs, sp.sign, sp.Heaviside, sp.Piecewise, sp.floor, sp.ceiling, Where)


@dataclass(frozen=True)
class Coupling(Effect):
    """Coupling of coordinates: first = ratio second + offset, or any `equation` that is zero.

    A gear pair has the ratio -z_second/z_first where both turn about axes that point the same way, a belt
    r_second/r_first; a rack, the first, has the pinion's pitch radius [m/rad], a nut on its screw lead/(2 pi). A joint
    on a carrier has the angle against the carrier. An `equation` is an expression of `coordinate_of(joint)`, of time
    `T` and of parameters, twice differentiable, a length [m] or an angle: a differential has three coordinates.

    What it holds with is a history: of an angle `<name>.moment` [N m], of a length `<name>.force` [N]. It is the
    torque or force on the first coordinate, on the child of its joint, its reaction on the parent; on the second acts
    -ratio times as much; on each coordinate of an equation its derivative by it times as much.

    The start must fulfil it, coordinates and speeds: what is not given follows. It does no work, but where time
    enters, as a drive does: that is booked as input.
    """

    name: str
    first: str = ""
    second: str = ""
    ratio: Scalar | None = None
    offset: Scalar = 0
    equation: Scalar | None = None
    kind: ClassVar[str] = "coupling"
    reads: ClassVar[str] = COORDINATE
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        if self.equation is not None:
            return f"{shown(self.equation)} = 0"
        return f"{self.first} = {shown(self.ratio)} {self.second}{f' + {shown(self.offset)}' if self.offset else ''}"

    @property
    def zero(self) -> Any:
        """Expression that is zero where the coupling holds [m or rad]."""
        if self.equation is not None:
            return sp.sympify(self.equation)
        return coordinate_of(self.first) - sp.sympify(self.ratio) * coordinate_of(self.second) - sp.sympify(self.offset)

    @property
    def joints(self) -> tuple[str, ...]:
        """Keys of the freedoms that it couples."""
        if self.equation is None:
            return self.first, self.second
        return tuple(symbol.joint for symbol in states_in(self.equation) if symbol.joint)

    def unit(self, scene: Declared) -> str:
        """Unit of `zero`: `LENGTH` or `ANGLE`."""
        return LENGTH if self._dimension(scene) == Dimension.from_unit("m") else ANGLE

    def constraint(self, scene: Declared) -> str:
        """Name of its constraint: the history of what it is off by."""
        return f"{self.name}.{'off' if self.unit(scene) == LENGTH else 'turned'}"

    def _dimension(self, scene: Declared) -> Dimension | None:
        """Dimension of `zero`; None for faults that the audit of the quantities reports."""
        if self.equation is None:
            return state_dimension(coordinate_of(self.first), scene)
        parameters = parameters_of(self.equation)
        try:
            table = dimensions_of({parameter.name: parameter for parameter in parameters})
            table |= {symbol: state_dimension(symbol, scene) for symbol in states_in(self.equation)}
            return dimension_of(self.zero, table, parameters)
        except (DimensionError, UnitError):
            return None

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield ratio and offset, or the equation."""
        if self.equation is not None:
            unit = "m" if self.unit(scene) == LENGTH else "rad"
            yield Varying(f"{self.where}, equation", self.equation, unit, on=(TIME, COORDINATE))
            return
        first, second = (scene.scalars[key].units[0] for key in self.joints)
        yield Slot(f"{self.where}, ratio", self.ratio, "1" if first == second else f"{first}/{second}")
        yield Slot(f"{self.where}, offset", self.offset, first)

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of an equation beside a ratio, of neither, and of joints that are no names."""
        yield from super().type_faults()
        pair = {"first": self.first, "second": self.second, "ratio": self.ratio}
        stated = [name for name, value in pair.items() if value is not None and value != ""]
        if self.equation is not None:
            beside = [*stated, *(["offset"] if self.offset != 0 else [])]
            if beside:
                yield Fault(self.where, f"an equation beside {', '.join(beside)}", "either",
                            "An equation is complete: equation=coordinate_of(first) - ratio*coordinate_of(second) - offset.")  # fmt: skip
            if not is_number(self.equation):
                yield Fault(f"{self.where}, equation", repr(self.equation), "an expression that is zero where it holds",
                            "It may contain coordinate_of(joint), T and parameters.")  # fmt: skip
            return
        if len(stated) < len(pair):
            missing = ", ".join(name for name in pair if name not in stated)
            yield Fault(self.where, f"no {missing}", "two joints and their ratio, or an equation",
                        'Coupling("mesh", "wheel", "pinion", ratio=...), or Coupling("mesh", equation=...).')  # fmt: skip
        for role in ("first", "second"):
            if not isinstance(pair[role], str):
                yield Fault(f"{self.where}, {role}", repr(pair[role]), "the name of a joint")

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of joints that are missing, alike or all driven, and of the equation."""
        yield from super().faults(scene)
        strange = [fault for key in dict.fromkeys(self.joints) for fault in joint_faults(self.where, key, scene)]
        yield from strange
        if strange:
            return
        driven = [effect.joint for effect in scene.effects if isinstance(effect, AnyDrive)]
        if not self.joints:
            yield Fault(f"{self.where}, equation", shown(self.equation), "an equation between coordinates",
                        "A coordinate is coordinate_of(joint).")  # fmt: skip
        elif all(key in driven for key in self.joints):
            yield Fault(self.where, f"{' and '.join(dict.fromkeys(self.joints))}, all driven", "a coordinate that is free to follow",
                        "Leave out a drive, or the coupling.")  # fmt: skip
        if self.equation is not None:
            yield from self._equation_faults(scene)
        elif self.first == self.second:
            yield Fault(self.where, f"{self.first} coupled to itself", "two coordinates")
        elif is_number(self.ratio) and self.ratio == 0:
            yield Fault(f"{self.where}, ratio", "0, which holds the first coordinate and leaves the second free", "another ratio",
                        "A coordinate that is held is a Weld, or driven.")  # fmt: skip

    def _equation_faults(self, scene: Declared) -> Iterator[Fault]:
        """Faults of an equation that is no length and no angle, or whose second derivatives jump."""
        where, dimension = f"{self.where}, equation", self._dimension(scene)
        if dimension is not None and dimension not in (Dimension.from_unit("m"), Dimension.from_unit("rad")):
            yield Fault(where, f"{shown(self.equation)} [{dimension}]",
                        "a length [m] or an angle [rad], so that its multiplier is a force or a torque",
                        "Divide it by a parameter that makes it one: x^2 + y^2 - l^2 by l.")  # fmt: skip
        kinks = [node for node in sp.preorder_traversal(sp.sympify(self.equation)) if isinstance(node, _KINKED)]
        if kinks:
            yield Fault(where, f"{shown(kinks[0])}, whose slope jumps or does not exist", "an equation that is twice differentiable",
                        "A Table is smooth; jumps belong to a contact, a spring or a force.")  # fmt: skip
            return
        states = states_in(self.equation)
        try:
            for one in states:
                for other in states:
                    expression_text(sp.diff(self.zero, one, other))
        except (EmitError, ValueError) as error:
            yield Fault(
                where, f"{shown(self.equation)}: {error}", "an equation of known functions, twice differentiable"
            )

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield pitch circles: of wheels that mesh from outside, of a wheel on a rack or with a rope.

        Their shafts and guides are in the same part. A belt, and wheels of other shafts, determine no radii.
        """
        joints = [joint for key in self.joints for joint in scene.mechanism.tree if joint.name == key]
        if self.equation is not None or len(joints) < 2 or joints[0].parent.body != joints[1].parent.body:
            return
        axes = [apply(j.parent.axes, f.axis.unit) for j in joints for f in j.freedoms if f.axis is not None]
        kinds = [freedom.kind for joint in joints for freedom in joint.freedoms]
        ratio, cosine = sp.sympify(self.ratio), default_value(dot(*axes)) if len(axes) == 2 else math.nan
        if kinds == ["slide", "turn"] and abs(cosine) < _ALIGNED:
            size = ratio if default_value(ratio) > 0 else -ratio
            yield "mesh", "first", joints[0].child, {"along": _axis(joints[0])}
            yield "mesh", "second", *_wheel(joints[1], size)
        elif kinds == ["turn", "turn"] and abs(abs(cosine) - 1) < _ALIGNED and default_value(ratio) * cosine < 0:
            ratio = -ratio if cosine > 0 else ratio
            apart = sub(joints[1].parent.position, joints[0].parent.position)
            apart = sub(apart, scale(dot(apart, axes[0]), axes[0]))
            distance = sp.sqrt(dot(apart, apart))
            if default_value(distance) > 0:
                yield "mesh", "first", *_wheel(joints[0], distance / (1 + ratio))
                yield "mesh", "second", *_wheel(joints[1], distance * ratio / (1 + ratio))


def _wheel(joint: Joint, radius: Any) -> tuple[Point, Mapping[str, Any]]:
    """Point of a wheel's shaft, and its axis and pitch radius."""
    return joint.child, {"axis": _axis(joint), "radius": radius}


def _axis(joint: Joint) -> Vector:
    """Axis of the only freedom of a joint, along the axes of its child."""
    axis = joint.freedoms[0].axis
    return (0, 0, 0) if axis is None else apply(joint.child.axes, axis.unit)
