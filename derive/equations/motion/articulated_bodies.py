"""Solution of M a = f for a tree by articulated bodies, link by link.

The links beyond a joint, free to move in theirs, resist a motion of it as one body whose inertia is found from the leaves
inwards: a linear number of operations, where elimination takes a cubic one along a chain (Featherstone, Rigid Body
Dynamics Algorithms (2008), chapter 7). A motion is (alpha, a of O), a force (moment about O, force), both in the axes of
the link's run.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.equations.motion.axes import Change, Entries, Symmetric, added
from hertzwerk.derive.equations.motion.recursion import Recursion
from hertzwerk.derive.equations.motion.spanning_tree import UNIT, Link, Row
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, cross, dot, less, product, scale, total
from hertzwerk.derive.program.program import Tape


@dataclass(frozen=True)
class Inertia:
    """Inertia of an articulated body.

    moment = turning alpha + coupling a, force = coupling^T alpha + moving a
    """

    turning: Symmetric
    coupling: Entries
    moving: Symmetric

    def named(self, tape: Tape, name: str) -> Inertia:
        """The same with every entry named on the tape."""
        return Inertia(
            self.turning.named(tape, f"{name}_J"), self.coupling.named(tape, f"{name}_H"), self.moving.named(tape, f"{name}_M")
        )  # fmt: skip

    def force(self, link: Link, axis: Vector) -> tuple[Vector, Vector]:
        """Moment and force that accelerate a joint about or along its axis."""
        if link.kind == "slide":
            return self.coupling.apply(axis), self.moving.apply(axis)
        return self.turning.apply(axis), self.coupling.transposed.apply(axis)

    def freed(self, force: tuple[Vector, Vector], share: tuple[Vector, Vector]) -> Inertia:
        """Inertia that is left where a joint gives way: less force share^T."""
        (moment, push), (turn, move) = force, share
        return Inertia(
            Symmetric(lambda i, j: less(self.turning[i, j], product(moment[i], turn[j]))),
            Entries(lambda i, j: less(self.coupling[i, j], product(moment[i], move[j]))),
            Symmetric(lambda i, j: less(self.moving[i, j], product(push[i], move[j]))),
        )

    def in_parent_axes(self, change: Change, arm: Vector, tape: Tape, name: str) -> Inertia:
        """In the axes of the parent, about its O, from which this one is an arm away."""
        pairs = ((self.turning, "J"), (self.moving, "M"))
        turning, moving = (change.symmetric(of, tape, f"{name}_turned_{label}") for of, label in pairs)
        coupling = change.both(self.coupling, tape, f"{name}_turned_H")
        lever = Entries(lambda i, j: total(coupling[i, j], cross(arm, moving.column(j))[i])).named(
            tape, f"{name}_lever"
        )
        # J + (H + [r]x M) [r]x^T + [r]x H^T
        shifted = Symmetric(
            lambda i, j: total(turning[i, j], cross(arm, lever.row(i))[j], cross(arm, coupling.row(j))[i])
        )
        return Inertia(shifted, lever, moving)


class Articulated:
    """Inverse of the mass matrix of the free rows of a tree."""

    def __init__(self, parts: Recursion, artificial: Mapping[str, Any]) -> None:
        self._parts, self._tape, self._links = parts, parts.tape, parts.tree.links
        self._shares: dict[Row, tuple[Vector, Vector]] = {}
        """Force that accelerates a free row, relative to the row's own inertia."""
        self._own: dict[Row, Any] = {}
        tape, bodies = self._tape, {link: self._rigid(link) for link in self._links}
        for link in reversed(self._links):
            name, left = link.name, bodies[link].named(self._tape, f"{link.name}_articulated")
            for row, axis in reversed([*zip(link.rows, parts.axes(link), strict=True)]):
                if not row.free:
                    continue
                label = row.key.replace(".", "_")
                force = left.force(link, axis)
                own = dot(axis, force[link.kind == "slide"]) + artificial.get(row.key, sp.S.Zero)
                self._own[row] = own = tape.let(own, f"D_{label}")
                turn, move = (scale(1 / own, part) for part in force)
                share = tape.vector(turn, f"{label}_turn_share"), tape.vector(move, f"{label}_move_share")
                self._shares[row] = share
                left = left.freed(force, share)
            if link.parent in bodies:
                moved = left.named(tape, f"{name}_left").in_parent_axes(link.change, parts.arm(link), tape, name)
                bodies[link.parent] = _together(bodies[link.parent], moved)

    @property
    def names(self) -> list[str]:
        """Keys of the free rows."""
        return [row.key for row in self._shares]

    def solve(self, right: Mapping[str, Any], label: str) -> dict[str, Any]:
        """Solve for one right-hand side: forces inwards, accelerations outwards."""
        tape, parts = self._tape, self._parts
        forces: dict[Link, list[tuple[Vector, Vector]]] = {link: [] for link in parts.tree.children}
        driving: dict[Row, Any] = {}
        for link in reversed(self._links):
            moment, force = (add(ZERO, *each) for each in zip(*forces[link], strict=True)) if forces[link] else (ZERO, ZERO)  # fmt: skip
            moment, force = tape.vector(moment, f"{link.name}_passed_moment"), tape.vector(force, f"{link.name}_passed_force")  # fmt: skip
            for row, axis in reversed([*zip(link.rows, parts.axes(link), strict=True)]):
                if row.free:
                    held = less(right[row.key], dot(axis, force if link.kind == "slide" else moment))
                    driving[row] = y = tape.let(held, f"y_{row.key.replace('.', '_')}")
                    moment, force = (
                        add(part, scale(y, share))
                        for part, share in zip((moment, force), self._shares[row], strict=True)
                    )
            if link.parent is not None and link.parent.parent is not None:
                force = tape.vector(link.change.out(force), f"{link.name}_turned_push")
                moment = add(link.change.out(moment), cross(parts.arm(link), force))
                forces[link.parent].append((moment, force))
        accelerations: dict[str, Any] = {}
        moves: dict[Link, tuple[Vector, Vector]] = {parts.tree.ground: (ZERO, ZERO)}
        for link in self._links:
            turn, move = moves[link.parent]  # type: ignore[index]
            move = link.change.back(add(move, cross(turn, parts.arm(link))))
            turn, move = (
                tape.vector(link.change.back(turn), f"{link.name}_turn"),
                tape.vector(move, f"{link.name}_move"),
            )
            for row, axis in zip(link.rows, parts.axes(link), strict=True):
                if row.free:
                    by_turn, by_move = self._shares[row]
                    value = less(driving[row] / self._own[row], dot(by_turn, turn), dot(by_move, move))
                    accelerations[row.key] = value = tape.let(value, f"{row.key.replace('.', '_')}_{label}")
                    if link.kind == "slide":
                        move = add(move, scale(value, axis))
                    else:
                        turn = add(turn, scale(value, axis))
            moves[link] = tape.vector(turn, f"{link.name}_turn"), tape.vector(move, f"{link.name}_move")
        return accelerations

    def _rigid(self, link: Link) -> Inertia:
        """Inertia of the bodies on a link alone."""
        mass, moment, inertia = self._parts.resolved(link)
        return Inertia(
            inertia,
            Entries(lambda i, j: cross(moment, UNIT[j])[i]),
            Symmetric(lambda i, j: mass if i == j else sp.S.Zero),
        )


def _together(one: Inertia, other: Inertia) -> Inertia:
    return Inertia(
        added(one.turning, other.turning),
        Entries(lambda i, j: total(one.coupling[i, j], other.coupling[i, j])),
        added(one.moving, other.moving),
    )
