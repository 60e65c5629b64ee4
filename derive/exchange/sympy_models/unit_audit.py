"""Units of a SymPy model: of what its author wrote, then of the equations that SymPy built from it.

Expressions are judged as they are written, so that a fault names the smallest part of the author's own expression.
What SymPy built is judged only where all of that is sound: a length that is forgotten in a position would show again in
every equation.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sympy.physics.mechanics import Particle, ReferenceFrame

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.exchange.sympy_models.model_equations import Reading, connected, frames_of, mass_centre, points_of
from hertzwerk.derive.exchange.sympy_models.translation import METRE, SECOND, TURNING
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension
from hertzwerk.derive.expressions.dimension.walker import check

KILOGRAM, INERTIA, FORCE, MOMENT, ENERGY, POWER = (
    Dimension.from_unit(unit) for unit in ("kg", "kg m^2", "N", "N m", "J", "W")
)

Row = tuple[str, Any, Dimension | None]
"""Place of an expression, the expression, and its dimension; None for any."""


def unit_faults(reading: Reading, table: Mapping[Any, Dimension]) -> list[Fault]:
    """Faults of units: of what the author wrote or, if that is sound, of what SymPy built."""
    for rows in (_written(reading, table), _moving(reading), _built(reading, table)):
        faults = [fault for row in rows if (fault := _fault(*row, table)) is not None]
        if faults:
            return list(dict.fromkeys(faults))
    return []


def _fault(where: str, expression: Any, expected: Dimension | None, table: Mapping[Any, Dimension]) -> Fault | None:
    fault = check(expression, table, expected)
    if fault is None:
        return None
    whole = "" if fault.subexpression == str(expression) else f", in {expression}" if len(str(expression)) < 120 else ""
    return Fault(where, f"{fault.subexpression} [{fault.found}]{whole}", fault.expected, fault.repair or fault.reason)


def _components(where: str, vector: Any, expected: Dimension) -> Iterator[Row]:
    """Components of a vector of SymPy, along the axes in which it is written."""
    for values, frame in vector.args if vector != 0 else ():
        for value, axis in zip(values, "xyz", strict=True):
            yield f"{where}, along {frame.name}.{axis}", value, expected


def _written(reading: Reading, table: Mapping[Any, Dimension]) -> Iterator[Row]:
    """Positions, axes, bodies, loads, constraints, kinematical equations, and the Lagrangian."""
    near = connected([] if reading.origin is None else [reading.origin], "_pos_dict")
    points = [*dict.fromkeys((*near, *points_of(reading).values()))]
    for i, point in enumerate(points):
        for other, vector in ((other, other.pos_from(point)) for other in point._pos_dict if other not in points[:i]):
            yield from _components(f"position of {other.name} from {point.name}", vector, METRE)
    for frame in frames_of(reading).values():
        for other, matrix in frame._dcm_dict.items():
            yield from ((f"axes of {frame.name} in {other.name}", entry, ONE) for entry in matrix)
    for body in reading.bodies:
        yield f"body {body.name}, mass", body.mass, KILOGRAM
        if not isinstance(body, Particle):
            dyadic, _ = body.inertia
            yield from ((f"body {body.name}, inertia about {a}|{b}", value, INERTIA) for value, a, b in dyadic.args)
    for number, (on, vector) in enumerate(reading.loads, 1):
        turns = isinstance(on, ReferenceFrame)
        yield from _components(
            f"load {number}, {'torque' if turns else 'force'} on {on.name}", vector, MOMENT if turns else FORCE
        )
    yield "potential energy of the bodies", reading.stored, ENERGY
    for number, expression in enumerate(reading.holonomic, 1):
        yield f"configuration constraint {number}", expression, None
    if reading.lagrangian is not None:
        yield "Lagrangian", reading.lagrangian, ENERGY
    for q, rate in reading.rates.items():
        yield f"kinematical equation of {q}", rate, table[q] / SECOND


def _moving(reading: Reading) -> Iterator[Row]:
    """Velocities, which follow from the positions or were set."""
    for body in reading.bodies:
        point, frame = mass_centre(body)
        yield from _components(f"velocity of {point.name}", reading.velocity(point), METRE / SECOND)
        if frame is not None:
            yield from _components(f"angular velocity of {frame.name}", frame.ang_vel_in(reading.frame), TURNING)
    for number, expression in enumerate(reading.nonholonomic, 1):
        yield f"velocity constraint {number}", expression, None


def _built(reading: Reading, table: Mapping[Any, Dimension]) -> Iterator[Row]:
    """Equations of motion."""
    for i, u in enumerate(reading.u):
        row = POWER / table[u]
        for j, other in enumerate(reading.u):
            yield f"mass matrix, {u} and {other}", reading.mass[i, j], row * SECOND / table[other]
        yield f"inertia force of {u}", reading.bias[i], row
        yield f"force of {u}", reading.force[i], row
