"""Terms of the equations of motion by an outward and an inward pass over the links.

Every term is resolved in the axes of its link's run. The subtree of a joint moves as one rigid body with it
(composite bodies: Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 6). The masses beyond a joint act on
the link before it as one point mass at the joint (augmented bodies: Wittenburg, Dynamics of Multibody Systems
(2008)): mass, first moment and inertia of an augmented link are constant in its axes, so mass parameters are not
multiplied by run-time quantities where a joint only turns.

Bias quantities are those at zero generalised accelerations; driven joints' accelerations count as bias. With U =
[alpha]x + [w]x[w]x, `U r` is the acceleration, relative to O, of the point at r.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, wraps
from typing import Any, TypeVar

import sympy as sp

from hertzwerk.derive.declare.mechanism.bodies import Body, steiner
from hertzwerk.derive.equations.motion.axes import Change, Fixed, Symmetric, added, of_matrix
from hertzwerk.derive.equations.motion.spanning_tree import UNIT, Link, Tree, sympified
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    along,
    apply,
    combine,
    cross,
    is_zero,
    less,
    multiply,
    outer,
    product,
    scale,
    scaled,
    total,
    transpose,
)

Result = TypeVar("Result")


def per_link(method: Callable[[Recursion, Link], Result]) -> Callable[[Recursion, Link], Result]:
    """Cache a method of a recursion by link."""

    @wraps(method)
    def look_up(self: Recursion, link: Link) -> Result:
        known = self.known.setdefault(method.__name__, {})
        if link not in known:
            known[link] = method(self, link)
        return known[link]  # type: ignore[no-any-return]

    return look_up


@dataclass(frozen=True)
class Spin:
    """Angular velocity of a link in its axes, and its bias rate.

    `before` and `alpha_before` are those without the turn of the link's own joint, about `axis`.
    """

    w: Vector
    alpha: Vector
    before: Vector
    alpha_before: Vector
    axis: int | None


class Recursion:
    """Terms of one tree of links, each computed on first request."""

    def __init__(self, tree: Tree, bodies: Sequence[Body]) -> None:
        self.tree = tree
        self.tape = tree.tape
        self.known: dict[str, dict[Link, Any]] = {}
        self.bodies: dict[Link, list[Body]] = {link: [] for link in tree.children}
        for body in bodies:
            self.bodies[tree.places[body].link].append(body)

    # -- constants -------------------------------------------------------------------------------------------------

    @per_link
    def own(self, link: Link) -> tuple[Any, Vector, Matrix]:
        """Mass [kg], first moment [kg m] and inertia [kg m^2] about O of the bodies on a link, in its axes."""
        mass, moment, inertia = sp.S.Zero, ZERO, combine()
        for body in self.bodies[link]:
            place = self.tree.places[body]
            centre = add(place.origin, apply(place.axes, sympified(body.centre)))
            mass += body.mass
            moment = add(moment, scale(body.mass, centre))
            inertia = combine(inertia, self.about_centre(body), scaled(body.mass, steiner(centre)))
        for end in self.rods(link):
            (origin, axes), rod = end.base, end.rod
            bent = apply(axes, rod.moment)
            turned = rod.inertia if axes == IDENTITY else multiply(multiply(axes, rod.inertia), transpose(axes))
            shift = _shifted(origin, bent)
            moment, inertia = add(moment, bent), combine(inertia, turned, (shift.row(0), shift.row(1), shift.row(2)))
        return mass, moment, inertia

    # -- rods, of which the link is the start --------------------------------------------------------------------------

    def rods(self, link: Link) -> list[Link]:
        """Ends of the rods that start on a link; its bodies hold them as if they were straight."""
        return [child for child in self.tree.children[link] if child.kind == "bend"]

    def of_start(self, end: Link) -> Change:
        """Change from the axes of a rod's start to those of the run of its link."""
        axes = end.base[1]
        within = end.parent.orientation.within.steps  # type: ignore[union-attr]
        return Change(within if axes == IDENTITY else (*within, Fixed(axes)))

    def start_arm(self, end: Link) -> Vector:
        """Vector from the O of its link to a rod's start, in the axes of the link's run [m]."""
        arm = end.parent.orientation.within.out(end.base[0])  # type: ignore[union-attr]
        return self.tape.vector(arm, f"{end.rod.name}_start_arm")

    def in_own_axes(self, end: Link, vector: Vector, label: str) -> Vector:
        """A vector along the axes of a rod's start, in those of the run of its end."""
        return self.tape.vector(end.change.back(self.of_start(end).out(vector)), f"{end.name}_{label}")

    @per_link
    def screws(self, link: Link) -> list[tuple[Vector, Vector]]:
        """Angular velocity of a rod's end and velocity of its O by each speed, in the axes of its run."""
        rod = link.rod
        return [
            (self.in_own_axes(link, turn, "turn"), self.in_own_axes(link, slide, "slide"))
            for turn, slide in zip(rod.turns, rod.slides, strict=True)
        ]

    @per_link
    def bent(self, end: Link) -> tuple[Vector, Vector]:
        """Force, and moment about its link's O, of a rod's own speeds, in the axes of the link's run."""
        out, spin = self.of_start(end), self.spin(end.parent)  # type: ignore[arg-type]
        force, moment = (out.out(vector) for vector in end.rod.bias(out.back(spin.w)))
        force = self.tape.vector(force, f"{end.rod.name}_passed_bias")
        return force, add(moment, cross(self.start_arm(end), force))

    def row_bias(self, end: Link, row: int) -> Any:
        """Generalised inertia force of a shape's row, without that of the bodies at the end [N]."""
        start: Link = end.parent  # type: ignore[assignment]
        out, spin, name = self.of_start(end), self.spin(start), end.rod.name
        acceleration = add(self.bias(start), self.acceleration_map(start)(self.start_arm(end)))
        w, alpha, acceleration = (
            self.tape.vector(out.back(vector), f"{name}_start_{label}")
            for vector, label in ((spin.w, "spin"), (spin.alpha, "angular_bias"), (acceleration, "bias"))
        )
        return end.rod.row_bias(row, w, acceleration, alpha)

    @per_link
    def resolved(self, link: Link) -> tuple[Any, Vector, Symmetric]:
        """As `own`, in the axes of the link's run."""
        mass, moment, inertia = self.own(link)
        tape, name, within = self.tape, link.name, link.orientation.within
        turned = within.symmetric(of_matrix(inertia).named(tape, f"{name}_I"), tape, f"{name}_J")
        return mass, tape.vector(within.out(tape.vector(moment, f"{name}_h")), f"{name}_moment"), turned

    def about_centre(self, body: Body) -> Matrix:
        """Inertia about the mass centre, in the link's axes.

        A scalar inertia is about the axis of the joint that turns the body.
        """
        place = self.tree.places[body]
        if isinstance(body.inertia, tuple):
            own = body.tensor
            return own if place.axes == IDENTITY else multiply(multiply(place.axes, own), transpose(place.axes))
        turning = next((link for link in reversed(place.link.path) if link.kind != "slide" and link.joint), None)
        if turning is None:
            return combine()
        alone = turning.joint is not None and sum(freedom.kind != "slide" for freedom in turning.joint.freedoms) == 1
        inertia = sp.sympify(body.inertia)
        return scaled(inertia, outer(turning.axis, turning.axis) if turning.kind == "turn" and alone else IDENTITY)

    @per_link
    def mass(self, link: Link) -> Any:
        """Mass of a link and its subtree [kg]."""
        parts = [self.own(link)[0], *(self.mass(child) for child in self.tree.children[link])]
        return self.tape.let(sp.Add(*parts), f"{link.name}_total_mass")

    @per_link
    def augmented(self, link: Link) -> tuple[Vector, Symmetric]:
        """First moment and inertia about O of the augmented link, in the axes of its run."""
        _, moment, inertia = self.own(link)
        for child in self.tree.children[link]:
            mass = self.mass(child)
            moment = add(moment, scale(mass, child.offset))
            inertia = combine(inertia, scaled(mass, steiner(child.offset)))
        name, within = link.name, link.orientation.within
        local = of_matrix(inertia).named(self.tape, f"{name}_I")
        moment = within.out(self.tape.vector(moment, f"{name}_h"))
        return self.tape.vector(moment, f"{name}_moment"), within.symmetric(local, self.tape, f"{name}_J")

    @per_link
    def arm(self, link: Link) -> Vector:
        """Vector from the parent's O to this O, in the axes of the parent's run [m]."""
        if link.parent is None:
            return ZERO
        return self.tape.vector(link.parent.orientation.within.out(link.offset), f"{link.name}_arm")

    @per_link
    def axis(self, link: Link) -> Vector:
        """Axis of a slide or turn, in the axes of its run."""
        return (
            self.tape.vector(link.orientation.within.out(link.axis), f"{link.name}_axis")
            if link.kind == "slide"
            else link.axis
        )

    def axes(self, link: Link) -> tuple[Vector, ...]:
        """Axis of each row of a link, in the axes of its run."""
        return UNIT if link.kind == "ball" else (self.axis(link),)

    # -- composites ------------------------------------------------------------------------------------------------

    @per_link
    def moment(self, link: Link) -> Vector:
        """First moment about O of a link with its subtree [kg m]."""
        parts = [child.change.out(self.moment(child)) for child in self.tree.children[link]]
        return self.tape.vector(add(self.augmented(link)[0], *parts), f"{link.name}_total_moment")

    @per_link
    def inertia(self, link: Link) -> Symmetric:
        """Inertia about O of a link with its subtree [kg m^2]."""
        tape, name = self.tape, link.name
        parts = [self.augmented(link)[1]]
        for child in self.tree.children[link]:
            parts.append(child.change.symmetric(self.inertia(child), tape, f"{child.name}_turned_J"))
            parts.append(
                _shifted(
                    self.arm(child), tape.vector(child.change.out(self.moment(child)), f"{child.name}_turned_moment")
                )
            )
        return added(*parts).named(tape, f"{name}_total_J")

    # -- bias, outwards --------------------------------------------------------------------------------------------

    @per_link
    def spin(self, link: Link) -> Spin:
        """Angular velocity and its bias rate."""
        if link.parent is None:
            return Spin(ZERO, ZERO, ZERO, ZERO, None)
        tape, name, outer_spin = self.tape, link.name, self.spin(link.parent)
        if link.kind == "slide":
            return outer_spin
        w = tape.vector(link.change.back(outer_spin.w), f"{name}_w")
        alpha = tape.vector(link.change.back(outer_spin.alpha), f"{name}_b")
        axes = self.axes(link)
        if link.kind == "bend":
            turn = self.in_own_axes(link, link.rod.moved[1], "end_turning")
            swing = self.in_own_axes(link, link.rod.bent[1], "end_swing")
            rate = tape.vector(add(w, turn), f"{name}_rate")
            return Spin(rate, tape.vector(add(alpha, cross(w, turn), swing), f"{name}_angular_bias"), w, alpha, None)
        turn = add(*(scale(row.speed, axis) for row, axis in zip(link.rows, axes, strict=True)))
        driven = add(
            *(scale(row.acceleration, axis) for row, axis in zip(link.rows, axes, strict=True) if not row.free)
        )
        rate = tape.vector(add(w, turn), f"{name}_rate")
        bias = tape.vector(add(alpha, cross(w, turn), driven), f"{name}_angular_bias")
        return Spin(rate, bias, w, alpha, along(axes[0]) if link.kind == "turn" else None)

    @per_link
    def acceleration_map(self, link: Link) -> Callable[[Vector], Vector]:
        """The map r -> U r.

        Points on the axis of the link's own turn are not affected by it: their column of U is that before the turn.
        """
        spin, tape, name = self.spin(link), self.tape, link.name

        @cache
        def entry(i: int, j: int) -> Any:
            w, alpha = (spin.before, spin.alpha_before) if j == spin.axis else (spin.w, spin.alpha)
            if i == j:
                squares = [self.product(link, w, k, k) for k in range(3) if k != i]
                return tape.let(-sp.Add(*squares), f"{name}_U_{'xyz'[i]}_{'xyz'[j]}")
            k = 3 - i - j
            sign = 1 if (i - j) % 3 == 1 else -1  # [alpha]x: entry (1, 0) is alpha_2
            return tape.let(sign * alpha[k] + self.product(link, w, i, j), f"{name}_U_{'xyz'[i]}_{'xyz'[j]}")

        def times(r: Vector) -> Vector:
            return tuple(total(*(product(entry(i, j), r[j]) for j in range(3) if r[j] != 0)) for i in range(3))

        return times

    def product(self, link: Link, w: Vector, i: int, j: int) -> Any:
        """Product w_i w_j, named, so that it is computed once."""
        return self.tape.let(product(w[i], w[j]), f"{link.name}_rate_{'xyz'[i]}{'xyz'[j]}")

    @per_link
    def slide_bias(self, link: Link) -> Vector:
        """Bias acceleration of O due to a slide or the bending of a rod; zero elsewhere."""
        if link.kind == "bend":
            out, rod = self.of_start(link), link.rod
            w = out.back(self.spin(link.parent).w)  # type: ignore[arg-type]
            moving = add(scale(2, cross(w, rod.moved[0])), rod.bent[0])
            return self.in_own_axes(link, self.tape.vector(moving, f"{rod.name}_coriolis"), "coriolis")
        if link.kind != "slide":
            return ZERO
        (row,), axis = link.rows, self.axis(link)
        coriolis = scale(2 * row.speed, cross(self.spin(link).w, axis))
        return self.tape.vector(
            add(coriolis, ZERO if row.free else scale(row.acceleration, axis)), f"{link.name}_coriolis"
        )

    @per_link
    def bias(self, link: Link) -> Vector:
        """Bias acceleration of O [m/s^2]."""
        if link.parent is None:
            return ZERO
        before = add(self.bias(link.parent), self.acceleration_map(link.parent)(self.arm(link)))
        return self.tape.vector(add(link.change.back(before), self.slide_bias(link)), f"{link.name}_bias")

    # -- bias, inwards ---------------------------------------------------------------------------------------------

    @per_link
    def force(self, link: Link) -> Vector:
        """Bias force of the composite in addition to `mass * bias` [N]."""
        parts = [child.change.out(self.inward_force(child)) for child in self.tree.children[link]]
        parts += [self.bent(end)[0] for end in self.rods(link)]
        return self.tape.vector(add(self.acceleration_map(link)(self.augmented(link)[0]), *parts), f"{link.name}_force")

    def inward_force(self, link: Link) -> Vector:
        """Bias force including the slide's part, which the augmented parent does not contain [N]."""
        return add(self.force(link), scale(self.mass(link), self.slide_bias(link)))

    @per_link
    def torque(self, link: Link) -> Vector:
        """Bias moment of the composite about O [N m]."""
        tape, name = self.tape, link.name
        moment, inertia = self.augmented(link)
        parts = [self._gyroscopic(link, inertia), cross(moment, self.bias(link))]
        for child in self.tree.children[link]:
            inward_force = tape.vector(child.change.out(self.inward_force(child)), f"{child.name}_turned_force")
            parts += [child.change.out(self.torque(child)), cross(self.arm(child), inward_force)]
        parts += [self.bent(end)[1] for end in self.rods(link)]
        return tape.vector(add(*parts), f"{name}_torque")

    def _gyroscopic(self, link: Link, J: Symmetric) -> Vector:
        """J alpha + w x J w, reusing the products of w in U."""
        spin = self.spin(link)
        w, alpha = spin.w, spin.alpha
        if is_zero(w):
            return ZERO
        out = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            terms = []
            if alpha[i] != 0:
                terms.append(product(J[i, i], alpha[i]))
            if w[j] != 0 and w[k] != 0:
                terms.append((J[k, k] - J[j, j]) * self.product(link, w, j, k))
            products = (
                ((i, j), alpha[j] - self.product(link, w, i, k)),
                ((i, k), alpha[k] + self.product(link, w, i, j)),
                ((j, k), self.product(link, w, j, j) - self.product(link, w, k, k)),
            )
            terms += [product(J[place], value) for place, value in products if value != 0]
            out.append(total(*terms))
        return (out[0], out[1], out[2])

    # -- velocity, for the energy ----------------------------------------------------------------------------------

    @per_link
    def velocity(self, link: Link) -> Vector:
        """Velocity of O [m/s]."""
        if link.parent is None:
            return ZERO
        before = add(self.velocity(link.parent), cross(self.spin(link.parent).w, self.arm(link)))
        slide = scale(link.rows[0].speed, self.axis(link)) if link.kind == "slide" else ZERO
        if link.kind == "bend":
            slide = self.in_own_axes(link, link.rod.moved[0], "end_velocity")
        return self.tape.vector(add(link.change.back(before), slide), f"{link.name}_velocity")


def _shifted(arm: Vector, moment: Vector) -> Symmetric:
    """Change of inertia of a composite of first moment h moved by d: 2 (d.h) 1 - d h^T - h d^T.

    Without the part of its mass.
    """

    def entry(i: int, j: int) -> Any:
        if i != j:
            return less(-product(arm[i], moment[j]), product(arm[j], moment[i]))
        return total(*(2 * product(arm[k], moment[k]) for k in range(3) if k != i))

    return Symmetric(entry)
