"""Equations of motion: mass matrix, bias, gravity, accelerations, multipliers, reactions, energy.

Kane's equations by composite bodies: one column of the mass matrix is the momentum of the subtree of a joint at the
joint's unit speed, projected on the joints below it (Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 6).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache, cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.mechanism.bodies import Body
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.articulated_bodies import Articulated
from hertzwerk.derive.equations.motion.constraints import constraints_of, driving_rows
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.multipliers import Loops
from hertzwerk.derive.equations.motion.recursion import Recursion
from hertzwerk.derive.equations.motion.spanning_tree import Link, Row
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, cross, dot, scale, total
from hertzwerk.derive.program.elimination import Factor

# of the multipliers: with multipliers.SOFTNESS, minimises the sum of the errors by singularity and by rounding
REFINEMENTS = 2

# artificial inertia of a row without any, relative to that about other axes, or of the mean body
ARTIFICIAL_RATIO = sp.Rational(1, 10_000)
# additional refinements with artificial inertia: each reduces its effect by about the factor ARTIFICIAL_RATIO
EXTRA_REFINEMENTS = 2
# free rows on a path up to which the mass matrix is written out and eliminated: articulated bodies take fewer operations
# beyond 7 in the plane and 12 in space
LONG_PATH = 10


class Equations:
    """Equations of motion of one scene on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, scene: Scene) -> None:
        self.kin = kinematics
        self.tape = kinematics.tape
        self.scene = scene
        self.links = kinematics.tree.links
        self.recursion = Recursion(kinematics.tree, scene.mechanism.bodies)
        self.link_of = {row: link for link in self.links for row in link.rows}
        self.rows = list(self.link_of)
        self.free = [row for row in self.rows if row.free]
        still = {row for held in kinematics.tree.held.values() for _, row in (*held.slides, *held.turns)}
        self.driven = [row for row in self.rows if not row.free and row not in still]
        self.held = [row for row in self.rows if row in still]
        self.constraints = constraints_of(kinematics)
        self.prescribed = [row for _, (row,) in kinematics.prescribed.values()]
        self.prescribed += driving_rows(self.constraints)
        self._pull = cache(self._pull_in)  # keyed by links, which live as long as this object
        self.mass_matrix = cache(self._mass_matrix)

    # -- mass matrix and bias --------------------------------------------------------------------------------------

    def _columns(self, link: Link) -> dict[tuple[str, str], Any]:
        """Mass matrix entries of a link's rows with themselves and the rows of the links below, by keys."""
        entries: dict[tuple[str, str], Any] = {}
        parts = self.recursion
        if link.kind == "bend":
            return self._bent_columns(link)
        for i, (row, axis) in enumerate(zip(link.rows, self.recursion.axes(link), strict=True)):
            name = row.key.replace(".", "_")
            slides = link.kind == "slide"
            force = scale(parts.mass(link), axis) if slides else cross(axis, parts.moment(link))
            # the link's own rows first: only requested entries of an inertia are computed
            for other, along in zip(link.rows[: i + 1], self.recursion.axes(link), strict=False):
                value = dot(force, along) if slides else dot(parts.inertia(link).apply(axis), along)
                entries[row.key, other.key] = self.tape.let(value, f"M_{name}_{other.key.replace('.', '_')}")
            if any(below.kind != "slide" for below in link.path[:-1]):
                torque = cross(parts.moment(link), axis) if slides else parts.inertia(link).apply(axis)
            else:
                torque = ZERO
            entries |= self._passed(row, link, force, torque)
        return entries

    def _passed(
        self, row: Row, here: Link, force: Vector, torque: Vector, at_start: tuple[Vector, Vector] = (ZERO, ZERO)
    ) -> dict[tuple[str, str], Any]:
        """Entries of a row with those of the links below, of the momentum at its unit speed.

        at_start  momentum and angular momentum of a rod that ends here, about the O of its link
        """
        parts, name, entries = self.recursion, row.key.replace(".", "_"), {}
        while here.parent is not None and here.parent.parent is not None:
            # resolved in the axes of the parent's run
            arm = parts.arm(here)
            force = self.tape.vector(here.change.out(force), f"{name}_{here.name}_force")
            torque = self.tape.vector(add(here.change.out(torque), cross(arm, force)), f"{name}_{here.name}_torque")
            force, torque = add(force, at_start[0]), add(torque, at_start[1])
            here, at_start = here.parent, (ZERO, ZERO)
            for other, value in zip(here.rows, self._along(here, force, torque), strict=True):
                entries[row.key, other.key] = self.tape.let(value, f"M_{name}_{other.key.replace('.', '_')}")
        return entries

    def _along(self, link: Link, force: Vector, torque: Vector) -> list[Any]:
        """Shares of a force and of a moment about O in each row of a link."""
        if link.kind == "bend":
            return [dot(slide, force) + dot(turn, torque) for turn, slide in self.recursion.screws(link)]
        return [dot(along, force if link.kind == "slide" else torque) for along in self.recursion.axes(link)]

    def _bent_columns(self, link: Link) -> dict[tuple[str, str], Any]:
        """As `_columns`, of a rod's shapes: of the bodies at its end, and of its own."""
        entries: dict[tuple[str, str], Any] = {}
        parts, rod = self.recursion, link.rod
        out = parts.of_start(link)
        for i, (row, (turn, slide)) in enumerate(zip(link.rows, parts.screws(link), strict=True)):
            name = row.key.replace(".", "_")
            moment = parts.moment(link)
            force = self.tape.vector(add(scale(parts.mass(link), slide), cross(turn, moment)), f"{name}_end_force")
            torque = self.tape.vector(add(cross(moment, slide), parts.inertia(link).apply(turn)), f"{name}_end_torque")
            for j, (other, value) in enumerate(zip(link.rows[: i + 1], self._along(link, force, torque), strict=False)):
                own = total(value, rod.mass_of(i, j))
                entries[row.key, other.key] = self.tape.let(own, f"M_{name}_{other.key.replace('.', '_')}")
            push = self.tape.vector(out.out(rod.pushes[i]), f"{name}_push")
            twist = add(out.out(rod.twists[i]), cross(parts.start_arm(link), push))
            entries |= self._passed(row, link, force, torque, (push, twist))
        return entries

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
        if link.kind == "bend":
            i, force = link.rows.index(row), add(scale(parts.mass(link), parts.bias(link)), parts.force(link))
            return total(self._along(link, force, parts.torque(link))[i], parts.row_bias(link, i))
        axis = self._axis_of(row)
        if link.kind != "slide":
            return dot(axis, parts.torque(link))
        return dot(axis, add(scale(parts.mass(link), parts.bias(link)), parts.force(link)))

    def _axis_of(self, row: Row) -> Vector:
        link = self.link_of[row]
        return self.recursion.axes(link)[link.rows.index(row)]

    # -- forces and accelerations ----------------------------------------------------------------------------------

    def gravity(self, row: Row) -> Any:
        """Generalised force of gravity; 0 where the scene has none [N m or N]."""
        link = self.link_of[row]
        if link.kind == "bend":
            i, pull = link.rows.index(row), self._pull(link)
            weight, moment = scale(self.recursion.mass(link), pull), cross(self.recursion.moment(link), pull)
            back = self.recursion.of_start(link).back(self._pull(link.parent))
            return total(self._along(link, weight, moment)[i], dot(link.rod.pushes[i], back))
        axis = self._axis_of(row)
        if link.kind == "slide":
            return dot(self._pull(link), scale(self.recursion.mass(link), axis))
        return dot(self._pull(link), cross(axis, self.recursion.moment(link)))

    def _pull_in(self, link: Link) -> Vector:
        """Gravity vector in the axes of a link's run."""
        if link.parent is None:
            return self._gravity_vector()
        return self.tape.vector(link.change.back(self._pull(link.parent)), f"{link.name}_gravity")

    def _gravity_vector(self) -> Vector:
        return gravity_vector(self.kin, self.scene.all(Gravity))

    def accelerations(self, forces: dict[str, Any]) -> tuple[list[Any], list[Any]]:
        """Accelerations of the free rows, and the multipliers, which are none in a tree.

        Solves M a = f - bias + G^T multipliers and G a + bias of G = 0.
        """
        right = {
            row.key: self.tape.let(forces[row.key] - self.bias(row), f"{row.key.replace('.', '_')}_net")
            for row in self.free
        }
        return self._solved(right, [-constraint.bias for constraint in self.constraints], "acc")

    def response(self, forces: Mapping[str, Any], name: str) -> tuple[list[Any], list[Any]]:
        """Accelerations and multipliers that forces by row add."""
        right = {row.key: forces.get(row.key, sp.S.Zero) for row in self.free}
        return self._solved(right, [sp.S.Zero] * len(self.constraints), name)

    def _solved(self, right: dict[str, Any], wanted: list[Any], name: str) -> tuple[list[Any], list[Any]]:
        solution = self._factor.solve(right, name)
        multipliers: list[Any] = []
        if self.constraints:
            refinements = REFINEMENTS + (EXTRA_REFINEMENTS if self.artificial_inertia else 0)
            solution, multipliers = self._loops.corrected(solution, wanted, name, refinements, self.artificial_inertia)
        return [solution[row.key] for row in self.free], multipliers

    def projection(self, wanted: list[Any]) -> list[Any]:
        """Speeds v of the free rows with the least kinetic energy that satisfy G v = wanted."""
        still = dict.fromkeys(self._factor.names, sp.S.Zero)
        speeds, _ = self._loops.corrected(still, wanted, "push", 1)
        return [speeds[row.key] for row in self.free]

    def independence(self) -> list[Any]:
        """Independence of each constraint, 0 where it is redundant: see `multipliers`."""
        return self._loops.independence()

    @cached_property
    def _factor(self) -> Factor | Articulated:
        """Inverse of the mass matrix of the free rows.

        Along long paths it is found link by link, else by elimination, leaves first: to eliminate a chain from its end
        keeps the zeros of the branches.
        """
        if self._longest_path() > LONG_PATH and not any(link.kind == "bend" for link in self.links):
            return Articulated(self.recursion, self.artificial_inertia)
        artificial = {(key, key): value for key, value in self.artificial_inertia.items()}
        return Factor(self.tape, [row.key for row in self.free][::-1], {**self.mass_matrix(), **artificial})

    def _longest_path(self) -> int:
        """Number of free rows of the path that has most."""
        return max((sum(row.free for below in link.path for row in below.rows) for link in self.links), default=0)

    @cached_property
    def artificial_inertia(self) -> dict[str, Any]:
        """Artificial mass or inertia of rows without any, such as a slender rod's about its own axis.

        Only with loop constraints, which tie the row to bodies with inertia. Its effect is removed while the
        multipliers are refined (`multipliers`), which converges fast where it is small.
        """
        if not self.constraints:
            return {}
        mass, mechanism, scales = self.mass_matrix(), self.scene.mechanism, self.scene.scales
        mean = mechanism.total_mass / len(mechanism.bodies)
        inertia = {}
        for row in self.free:
            if (row.key, row.key) in mass:
                continue
            link = self.link_of[row]
            own = [mass[other.key, other.key] for other in link.rows if (other.key, other.key) in mass]
            size = mean if link.kind == "slide" else sp.Add(*own) or mean * sp.sympify(scales.arm) ** 2
            inertia[row.key] = self.tape.let(ARTIFICIAL_RATIO * size, f"{row.key.replace('.', '_')}_lent")
        return inertia

    @cached_property
    def _loops(self) -> Loops:
        return Loops(self.tape, self.constraints, self._factor)

    def reactions(self, forces: dict[str, Any], accelerations: list[Any], multipliers: list[Any]) -> list[Any]:
        """Force or torque that each drive must supply [N m or N].

        That is its row of M a + bias - f - G^T multipliers; for a loop-closing joint it is its multiplier.
        """
        out = []
        for row in self.driven:
            reaction = self.needed(row, accelerations, multipliers, self.bias(row) - forces[row.key])
            out.append(self.tape.let(reaction, f"{row.key.replace('.', '_')}_reaction"))
        multiplier_of = {
            constraint.drives: force for constraint, force in zip(self.constraints, multipliers, strict=True)
        }
        return [*out, *(multiplier_of[row.key] for row in self.prescribed)]

    def needed(self, row: Row, accelerations: list[Any], multipliers: list[Any], rest: Any) -> Any:
        """Force along a row that a motion needs: M a + rest - G^T multipliers [N m or N]."""
        mass = self.mass_matrix()
        terms = [
            mass[row.key, f.key] * a for f, a in zip(self.free, accelerations, strict=True) if (row.key, f.key) in mass
        ]
        of_constraints = [
            constraint.column[row.key] * force
            for constraint, force in zip(self.constraints, multipliers, strict=True)
            if row.key in constraint.column
        ]
        return sp.Add(*terms) + rest - sp.Add(*of_constraints)

    # -- energy ----------------------------------------------------------------------------------------------------

    def kinetic(self) -> Any:
        """Kinetic energy [J]."""
        return self.kinetic_of(self.links)

    def kinetic_of(self, links: Iterable[Link]) -> Any:
        """Kinetic energy of some links [J]."""
        half, parts, tape = sp.Rational(1, 2), self.recursion, self.tape
        energy: list[Any] = []
        for link in links:
            mass, moment, inertia = parts.resolved(link)
            v, w = parts.velocity(link), parts.spin(link).w
            energy += half * mass * dot(v, v), dot(v, cross(w, moment)), half * dot(w, inertia.apply(w))
            if link.kind == "bend":
                start: Link = link.parent  # type: ignore[assignment]
                moved, spin = (parts.of_start(link).out(vector) for vector in link.rod.momentum)
                spin = add(spin, cross(parts.start_arm(link), moved))
                energy += dot(parts.velocity(start), moved), dot(parts.spin(start).w, spin), link.rod.kinetic
        return tape.let(sp.Add(*energy), "kinetic")

    def potential(self) -> Any:
        """Potential energy of gravity that does not vary, zero at the ground's origin [J]."""
        return self.potential_of(self.scene.mechanism.bodies)

    def potential_of(self, bodies: Sequence[Body]) -> Any:
        """Potential energy of some bodies, as of all [J]."""
        pull = gravity_vector(self.kin, [effect for effect in self.scene.all(Gravity) if not effect.varies])
        fallen = [sp.sympify(body.mass) * dot(self.kin.centre(body), pull) for body in bodies]
        fallen += [
            dot(pull, self.kin.of_rod(link, link.rod.moment, "bent_moment"))
            for link in self.links
            if link.joint is not None and link.joint.bends and link.joint.parent.body in bodies
        ]
        return self.tape.let(sp.Add(*(-energy for energy in fallen)), "potential")


def equations_of(kinematics: Kinematics, scene: Scene) -> Equations:
    """Equations of motion of the links, or those that the mechanism has by expressions."""
    expressions = kinematics.by_expressions
    return Equations(kinematics, scene) if expressions is None else expressions.equations(scene)


def gravity_vector(kinematics: Kinematics, effects: Sequence[Gravity]) -> Vector:
    """Sum of gravities, in ground axes [m/s^2]."""
    return add(ZERO, *(scale(kinematics.expression(sp.sympify(e.acceleration)), e.direction.unit) for e in effects))
