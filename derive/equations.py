"""Equations of motion of a tree: mass matrix, bias, gravity, accelerations, drive reactions, energy.

Kane's equations by composite bodies: one column of the mass matrix is the momentum of what hangs on a joint under the joint's unit speed, seen by
the joints below it (Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 6).
"""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

from hertzwerk.derive.axes import of_matrix
from hertzwerk.derive.kinematics import Kinematics
from hertzwerk.derive.links import UNIT, Link, Row
from hertzwerk.derive.recursion import Recursion
from hertzwerk.derive.scene import Scene
from hertzwerk.derive.vectors import ZERO, Vector, add, cross, dot, is_zero, scale


class Equations:
    """Equations of one scene on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, scene: Scene) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.scene = scene
        self.links = kinematics.tree.links
        self.recursion = Recursion(kinematics.tree, scene.mechanism.bodies)
        self.link_of = {row: link for link in self.links for row in link.rows}
        self.rows = list(self.link_of)
        self.free = [row for row in self.rows if row.free]
        self.driven = [row for row in self.rows if not row.free]
        self._pull = cache(self._pull_in)  # keyed by links, which live as long as this does
        self.mass_matrix = cache(self._mass_matrix)

    # -- mass matrix and bias --------------------------------------------------------------------------------------

    def _axes(self, link: Link) -> tuple[Vector, ...]:
        """Axis of each row of a link, in the axes of its run."""
        return UNIT if link.kind == "ball" else (self.recursion.axis(link),)

    def _columns(self, link: Link) -> dict[tuple[str, str], Any]:
        """Mass matrix entries of the rows of one link with themselves and those of the links below, by keys."""
        found: dict[tuple[str, str], Any] = {}
        parts = self.recursion
        for i, (row, axis) in enumerate(zip(link.rows, self._axes(link), strict=True)):
            name = row.key.replace(".", "_")
            slides = link.kind == "slide"
            force = scale(parts.mass(link), axis) if slides else cross(axis, parts.moment(link))
            # seen from the link's own rows first: of an inertia only what somebody asks for is worked out
            for other, along in zip(link.rows[: i + 1], self._axes(link), strict=False):
                value = dot(force, along) if slides else dot(parts.inertia(link).apply(axis), along)
                found[row.key, other.key] = self.tape.let(value, f"M_{name}_{other.key.replace('.', '_')}")
            if any(below.kind != "slide" for below in link.path[:-1]):
                torque = cross(parts.moment(link), axis) if slides else parts.inertia(link).apply(axis)
            else:
                torque = ZERO
            here = link
            while here.parent is not None and here.parent.parent is not None:
                # what is handed on, in the axes of the parent's run
                arm = parts.arm(here)
                force = self.tape.vector(here.change.out(force), f"{name}_{here.name}_force")
                torque = self.tape.vector(add(here.change.out(torque), cross(arm, force)), f"{name}_{here.name}_torque")
                here = here.parent
                for other, along in zip(here.rows, self._axes(here), strict=True):
                    value = dot(along, force if here.kind == "slide" else torque)
                    found[row.key, other.key] = self.tape.let(value, f"M_{name}_{other.key.replace('.', '_')}")
        return found

    def _mass_matrix(self) -> dict[tuple[str, str], Any]:
        """Entries by pair of row keys, free and driven, structural zeros left out."""
        entries: dict[tuple[str, str], Any] = {}
        for link in self.links:
            for (row, other), value in self._columns(link).items():
                if value != 0:
                    entries[row, other] = entries[other, row] = value
        return entries

    def bias(self, row: Row) -> Any:
        """Generalised inertia force at zero generalised accelerations [N m or N]."""
        link, parts = self.link_of[row], self.recursion
        axis = self._axis_of(row)
        if link.kind != "slide":
            return dot(axis, parts.torque(link))
        return dot(axis, add(scale(parts.mass(link), parts.bias(link)), parts.force(link)))

    def _axis_of(self, row: Row) -> Vector:
        link = self.link_of[row]
        return self._axes(link)[link.rows.index(row)]

    # -- forces and accelerations ----------------------------------------------------------------------------------

    def gravity(self, row: Row) -> Any:
        """Generalised force of gravity; 0 where the scene has none [N m or N]."""
        link, axis = self.link_of[row], self._axis_of(row)
        if link.kind == "slide":
            return dot(self._pull(link), scale(self.recursion.mass(link), axis))
        return dot(self._pull(link), cross(axis, self.recursion.moment(link)))

    def _pull_in(self, link: Link) -> Vector:
        """Gravity in the axes of a link's run."""
        if link.parent is None:
            return self._gravity_vector()
        return self.tape.vector(link.change.back(self._pull(link.parent)), f"{link.name}_gravity")

    def _gravity_vector(self) -> Vector:
        effects = self.scene.of_kind("gravity")
        if not effects:
            return ZERO
        return scale(sp.sympify(effects[0].acceleration), effects[0].direction.unit)

    def accelerations(self, forces: dict[str, Any]) -> list[Any]:
        """Of the free rows, from M a = f - bias by an unrolled L D L^T without pivoting (M is positive definite)."""
        tape = self.tape
        names = [row.key for row in self.free]
        label = {name: name.replace(".", "_") for name in names}
        mass = self.mass_matrix()
        right = {row.key: tape.let(forces[row.key] - self.bias(row), f"{label[row.key]}_net") for row in self.free}
        lower: dict[tuple[str, str], Any] = {}
        diagonal: dict[str, Any] = {}
        work: dict[tuple[str, str], Any] = {}
        # Leaves first: eliminating a chain from its end keeps the branches' zeros.
        order = names[::-1]
        for i, row in enumerate(order):
            for k in order[:i]:
                terms = [
                    lower[k, j] * work[row, j] for j in order[: order.index(k)] if (k, j) in lower and (row, j) in work
                ]
                value = tape.let(mass.get((row, k), sp.S.Zero) - sp.Add(*terms), f"L_{label[row]}_{label[k]}")
                if value != 0:
                    work[row, k] = value
                    lower[row, k] = tape.let(value / diagonal[k], f"l_{label[row]}_{label[k]}")
            terms = [lower[row, j] * work[row, j] for j in order[:i] if (row, j) in lower]
            diagonal[row] = tape.let(mass[row, row] - sp.Add(*terms), f"D_{label[row]}")
        solved: dict[str, Any] = {}
        for i, row in enumerate(order):
            terms = [lower[row, k] * solved[k] for k in order[:i] if (row, k) in lower]
            solved[row] = tape.let(right[row] - sp.Add(*terms), f"y_{label[row]}") if terms else right[row]
        result: dict[str, Any] = {}
        for i in reversed(range(len(order))):
            row = order[i]
            terms = [lower[k, row] * result[k] for k in order[i + 1 :] if (k, row) in lower]
            result[row] = tape.let(solved[row] / diagonal[row] - sp.Add(*terms), f"{label[row]}_acc")
        return [result[name] for name in names]

    def reactions(self, forces: dict[str, Any], accelerations: list[Any]) -> list[Any]:
        """What each drive must supply: its row of M a + bias - f [N m or N]."""
        mass = self.mass_matrix()
        out = []
        for row in self.driven:
            terms = [
                mass[row.key, f.key] * a
                for f, a in zip(self.free, accelerations, strict=True)
                if (row.key, f.key) in mass
            ]
            total = sp.Add(*terms) + self.bias(row) - forces[row.key]
            out.append(self.tape.let(total, f"{row.key.replace('.', '_')}_reaction"))
        return out

    # -- energy ----------------------------------------------------------------------------------------------------

    def kinetic(self) -> Any:
        """[J]."""
        half, parts, tape = sp.Rational(1, 2), self.recursion, self.tape
        total = []
        for link in self.links:
            mass, moment, inertia = parts.own(link)
            within = link.orientation.within
            v, w = parts.velocity(link), parts.spin(link).w
            total.append(half * mass * dot(v, v))
            if not is_zero(moment):
                first = tape.vector(within.out(tape.vector(moment, f"{link.name}_h")), f"{link.name}_moment")
                total.append(dot(v, cross(w, first)))
            turned = within.symmetric(of_matrix(inertia).named(tape, f"{link.name}_I"), tape, f"{link.name}_J")
            total.append(half * dot(w, turned.apply(w)))
        return tape.let(sp.Add(*total), "kinetic")

    def potential(self) -> Any:
        """Of gravity, zero at the ground's origin [J]."""
        pull = self._gravity_vector()
        bodies = self.scene.mechanism.bodies
        total = [-sp.sympify(body.mass) * dot(self.kin.centre(body), pull) for body in bodies]
        return self.tape.let(sp.Add(*total), "potential")
