"""Motion and equations of a mechanism as expressions, in place of joints.

They are of Parameters, `T`, coordinates and speeds (`coordinate_of`, `speed_of`), inputs, and of the symbols of the
description's `steps`, a straight-line program.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.mechanism.joints.joint import Freedom
from hertzwerk.derive.expressions.algebra.vectors import Matrix, Vector
from hertzwerk.derive.expressions.parameter import Slot

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
class Equations:
    """Equations M du/dt + bias = forces, by rows, and the potential energy in them [J]."""

    mass: Mapping[tuple[str, str], Any]
    bias: Mapping[str, Any]
    potential: Any = sp.S.Zero


@dataclass(frozen=True, eq=False)
class Description:
    """Motion and equations as expressions.

    coordinates   freedoms: of one coordinate and its rate, or `given` ones, of a coordinate or a speed alone
    measured      `given` coordinates with their rates, and speeds without a coordinate (`uncounted`), for effects on them
    rates         key of a `given` coordinate -> its rate
    steps         symbols and expressions of what other expressions share, in order
    quantities    parameters and what varies, with their units
    contradictions  velocities that are taken as they were set: where, as they were set, and as they follow from positions and axes
    """

    coordinates: tuple[Freedom, ...]
    measured: tuple[Freedom, ...]
    uncounted: tuple[str, ...]
    rates: Mapping[str, Linear]
    steps: tuple[tuple[sp.Symbol, Any], ...]
    places: Mapping[str, Placed]
    equations: Equations
    conditions: tuple[Condition, ...]
    quantities: tuple[Slot, ...]
    contradictions: tuple[tuple[str, str, str], ...] = ()
