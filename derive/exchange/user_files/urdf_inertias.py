"""Masses and inertias of the links of a URDF file, and repairs of physically impossible inertias.

Only rigid wholes move, so an impossible inertia counts with the link that it is welded to. Where the whole has an
impossible one, the nearest is the orthogonal projection of its principal values onto those of which none exceeds the
sum of the others; what is possible: Wensing, Kim, Slotine, IEEE Robotics and Automation Letters 3 (2018) 60.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from mpmath import diag, matrix, mp  # SymPy brings it

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame, Triple
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.mechanism.solids import Shape
from hertzwerk.derive.declare.scene.checks.inertia import ROUNDING, principal, tensor_faults, whole_of
from hertzwerk.derive.declare.scene.checks.topology import rigid_root
from hertzwerk.derive.expressions.algebra.vectors import Vector
from hertzwerk.derive.expressions.parameter import Parameter, default_value

Rows = tuple[tuple[float, ...], ...]
NO_ROWS: Rows = ((0.0,) * 3,) * 3
DENSE = 1e-15
"""Square of the radius of gyration [m^2] below which an inertia is rounding: 30 nm."""


@dataclass(frozen=True)
class Massed:
    """Mass [kg], mass centre [m] and inertia about it [kg m^2] of a link, along its axes."""

    mass: float = 0.0
    centre: tuple[float, ...] = (0.0, 0.0, 0.0)
    rows: Rows = NO_ROWS

    def body(self, name: str, shapes: tuple[Shape, ...] = ()) -> Body:
        """Body of parameters, of this name."""
        mass = number(f"{name}_mass", "kg", self.mass, f"mass of {name}")
        return Body(name, mass, self._inertia(name), position(f"{name}_centre", self.centre), shapes)

    def _inertia(self, name: str) -> Triple:
        """Principal values, or all rows where there are products."""
        xx, xy, xz, yy, yz, zz = (
            number(f"{name}_i{'xyz'[i]}{'xyz'[k]}", "kg m^2", self.rows[i][k]) for i in range(3) for k in range(i, 3)
        )
        return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)) if any((xy, xz, yz)) else (xx, yy, zz)

    @property
    def rounded(self) -> Massed:
        """The same with zeros for entries that are rounding."""
        least = max(ROUNDING * max(abs(value) for row in self.rows for value in row), DENSE * self.mass)
        return replace(self, rows=tuple(tuple(v if abs(v) > least else 0.0 for v in row) for row in self.rows))

    @property
    def nearest(self) -> tuple[Massed, str]:
        """The same with the nearest possible inertia, and how far that is in the Frobenius norm."""
        values, axes = mp.eigsy(matrix(self.rows))
        least, middle, most = values
        third = (most - least - middle) / 3
        new = [least + third, middle + third, most - third]
        if new[0] < ROUNDING * new[2]:  # a slender rod, of a little thickness for the sake of rounding
            across = max((middle + most) / 2, 0)
            new = [2 * ROUNDING * across, across, across]
        rows = axes * diag(new) * axes.T
        distance, size = mp.norm(matrix(new) - values), mp.norm(values)
        step = f"at a distance of {float(distance):.3g} kg m^2, {float(100 * distance / size):.2g} %"
        return replace(self, rows=tuple(tuple(float(rows[i, k]) for k in range(3)) for i in range(3))), step


Made = tuple[Mechanism, Mapping[str, Frame]]


def repaired(
    masses: Mapping[str, Massed], make: Callable[[Mapping[str, Massed]], Made], take_nearest: bool
) -> tuple[Made, list[str], list[Fault]]:
    """Mechanism and bodies of links with possible inertias, repairs, and faults of what cannot be.

    `make` gives the mechanism and its bodies by link.
    """
    numbers, repairs, faults = dict(masses), list[str](), list[Fault]()
    made = mechanism, bodies = make(numbers)
    moved = {name: body for name, body in bodies.items() if isinstance(body, Body)}
    if points := [name for name in moved if masses[name].mass and masses[name].rows == NO_ROWS]:
        repairs.append(f"masses without inertia, taken as point masses: {', '.join(points)}")
    wrong = [name for name, body in moved.items() if not _possible(mechanism, body)]
    if zeros := [name for name in wrong if _possible(mechanism, numbers[name].rounded.body(name))]:
        numbers.update({name: numbers[name].rounded for name in zeros})
        made = mechanism, bodies = make(numbers)
        repairs.append(f"inertias impossible by rounding, their rounding errors set to zero: {', '.join(zeros)}")
    wholes = grouped((rigid_root(mechanism, bodies[name]), name) for name in wrong if name not in zeros)
    for root, names in wholes.items():
        first, counted = _counted(mechanism, bodies, numbers, root, names)
        numbers.update(counted)
        if counted:
            welded = ", ".join(name for name in counted if name != first)
            repairs.append(f"impossible inertias, added to that of {first}, to which the links are welded: {welded}")
        for name in () if counted else names:
            values = f"principal values {', '.join(f'{value:.4g}' for value in principal(numbers[name].rows))} kg m^2"
            numbers[name], step = numbers[name].nearest
            if take_nearest:
                repairs.append(f"impossible inertia of {name}, {values}: replaced by the nearest possible one, {step}")
            else:
                faults.append(Fault(f"link {name}, inertia", values, "none negative, none larger than the sum of the others",
                                    "No distribution of mass has these: check the values and the signs of the products. "
                                    f'from_urdf(..., inertia="nearest") takes the nearest possible one, {step}.'))  # fmt: skip
    return (make(numbers) if wholes else made), repairs, faults


def _possible(mechanism: Mechanism, body: Body) -> bool:
    """Whether some distribution of mass has the inertia of a body."""
    return all(default_value(value) >= 0 for value in body.moments) and not any(tensor_faults(mechanism, body))


def _counted(
    mechanism: Mechanism, bodies: Mapping[str, Frame], numbers: Mapping[str, Massed], root: Frame, wrong: list[str]
) -> tuple[str, dict[str, Massed]]:
    """Link that impossible ones count with, and the numbers of these links then.

    It takes the impossible ones, or all that is welded to it. No numbers where the sum is impossible too.
    """
    if root == GROUND:
        return GROUND.name, {name: replace(numbers[name], rows=NO_ROWS) for name in wrong}
    first = next(name for name, body in bodies.items() if body == root)
    welded = [name for name, body in bodies.items() if rigid_root(mechanism, body) == root]
    for counted in (dict.fromkeys((first, *wrong)), welded):
        whole = whole_of(mechanism, [body for name in counted if isinstance(body := bodies[name], Body)])
        rows = tuple(tuple(map(float, row)) for row in whole.tensor)
        together = Massed(float(whole.mass), tuple(map(float, whole.centre)), rows)
        if len(counted) > 1 and together.mass and _possible(mechanism, together.body(first)):
            return first, {name: Massed() for name in counted if numbers[name] != Massed()} | {first: together}
    return first, {}


def number(name: str, unit: str, value: Any, meaning: str = "") -> Any:
    """Parameter, or a structural zero."""
    return Parameter(name, unit, float(value), meaning) if value else 0


def position(name: str, xyz: Iterable[float]) -> Vector:
    """Position [m] of parameters."""
    x, y, z = (number(f"{name}_{k}", "m", value) for k, value in zip("xyz", xyz, strict=True))
    return (x, y, z)
