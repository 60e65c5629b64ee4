"""Elasticity and damping of a flexible rod, with deflections, moments and stresses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.declare.effects.effect import Effect, Element, Kinematics
from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.expressions.algebra.vectors import product, total


@dataclass(frozen=True)
class RodElasticity(Effect):
    """Elasticity and damping of a flexible rod, which a scene adds for each.

    The strain energy is q.K q/2, K = E I/L^3 times the integral of psi_i'' psi_j''. Damping forces are -D q' with D =
    2 zeta sqrt(E I m/L^3) times the matrix of `BendingShapes.damping`.
    """

    name: str
    rod: FlexibleRod
    kind: ClassVar[str] = "rod_elasticity"

    @property
    def text(self) -> str:
        """Description for people."""
        return f"elasticity of the rod {self.rod.name}"

    def element(self, kin: Kinematics) -> Element:
        """Forces on the shapes, strain energy, what damping dissipates, and histories at the stations."""
        rod, (freedom,), shapes = self.rod, self.rod.freedoms, self.rod.shapes
        coordinates, speeds = kin.motion_of_freedom(freedom)
        count, length = len(coordinates) // len(rod.stiffnesses), sp.sympify(rod.length)
        curvature, damping = shapes.products(2), shapes.damping()
        ratio, stored, dissipated = sp.sympify(rod.damping_ratio), sp.S.Zero, sp.S.Zero
        forces: dict[str, Any] = {}
        for d, stiffness in enumerate(rod.stiffnesses):
            part = slice(d * count, (d + 1) * count)
            rows, q, u = freedom.forces[part], coordinates[part], speeds[part]
            unit = stiffness / length**3
            pace = 2 * ratio * unit / sp.sqrt(stiffness / (rod.mass * length**3))
            bent = [self._named(kin, unit, row, q, "bent") for row in curvature]
            damped = [self._named(kin, pace, row, u, "damped") for row in damping]
            forces |= {row.name: -elastic - drag for row, elastic, drag in zip(rows, bent, damped, strict=True)}
            stored += total(*map(product, q, bent)) / 2
            dissipated += total(*map(product, u, damped))
        booked = dissipated if ratio != 0 else None
        return Element(forces, stored=stored, dissipated=booked, outputs=tuple(self._histories(coordinates, count)))

    def _named(self, kin: Kinematics, unit: Any, numbers: Sequence[Any], of: Sequence[Any], label: str) -> Any:
        terms = (product(unit * number, x) for number, x in zip(numbers, of, strict=True) if number != 0)
        return kin.tape.let(total(*terms), f"{self.rod.name}_{label}")

    def _histories(self, coordinates: Sequence[Any], count: int) -> Iterator[tuple[str, str, Any]]:
        """Yield deflection from the tangent, sag from the line of both ends, moment, stress at each station."""
        rod, shapes = self.rod, self.rod.shapes
        at_end = shapes.at(1)
        for d, stiffness in enumerate(rod.stiffnesses):
            q, side = coordinates[d * count : (d + 1) * count], ("", "z_")[d]
            for at in rod.stations:
                value, bent = shapes.at(sp.Rational(at, 100)), shapes.at(sp.Rational(at, 100), 2)
                sag = [v - end * sp.Rational(at, 100) for v, end in zip(value, at_end, strict=True)]
                moment = stiffness / sp.sympify(rod.length) ** 2 * total(*map(product, bent, q))
                yield f"{rod.name}.{side}deflection_{at}", "m", total(*map(product, value, q))
                yield f"{rod.name}.{side}sag_{at}", "m", total(*map(product, sag, q))
                yield f"{rod.name}.{side}moment_{at}", "N m", moment
                if rod.section_modulus is not None:
                    yield f"{rod.name}.{side}stress_{at}", "Pa", moment / rod.section_modulus
