"""Faults of bodies that lack the mass or inertia their joints' motions need."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp
from mpmath import mp  # SymPy brings it

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame, steiner
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.checks.topology import connection_faults, rigid_root
from hertzwerk.derive.expressions.algebra.vectors import (
    Matrix,
    Vector,
    add,
    apply,
    combine,
    dot,
    multiply,
    scaled,
    sub,
    transpose,
)
from hertzwerk.derive.expressions.parameter import Parameter, default_value, is_number, parameters_of

ROUNDING = 1e-9
"""Part of an inertia that counts as rounding."""


def inertia_faults(mechanism: Mechanism, sound: dict[str, Parameter]) -> Iterator[Fault]:
    """Yield faults of missing masses and inertias.

    The last rigid whole of a chain needs a mass, unless it closes a loop, and an inertia about the axis that its joint
    turns it about, or about every axis where that turns it about every axis.
    """
    if not mechanism.tree or any(connection_faults(mechanism)):  # where motion is given no joint turns a body
        return
    wholes = grouped(
        (rigid_root(mechanism, body), body)
        for body in (joint.child.body for joint in mechanism.tree if isinstance(joint.child.body, Body))
    )
    carriers = {rigid_root(mechanism, joint.parent.body) for joint in mechanism.joints if joint.freedoms}
    rods = {joint.child.body for joint in mechanism.joints if joint.bends}
    tied = {rigid_root(mechanism, place.body) for joint in mechanism.closures for place in (joint.parent, joint.child)}
    for root, bodies in wholes.items():
        if all(is_number(value) and value == 0 for body in bodies for value in (body.mass, *body.moments)):
            if root not in {*carriers, *tied, *rods, GROUND}:
                yield Fault(f"body {root.name}, mass", "0 kg at the end of a chain", "a value in (0, inf), because nothing beyond it has a mass",
                            "Give it a mass (under a drive any will do: only the drive's force has it), close a loop by a joint to it, or "
                            "leave it out; in a robot, lock its joint: from_urdf(..., locked={joint: 0}).")  # fmt: skip
        elif all(_is_sound(body, sound) for body in bodies):
            impossible = [fault for body in bodies for fault in tensor_faults(mechanism, body)]
            yield from impossible or _turning_faults(mechanism, bodies, inner=root in carriers)


def _is_sound(body: Body, sound: dict[str, Parameter]) -> bool:
    """Whether the quantities of a body are numbers or sound parameters."""
    rows = body.inertia if isinstance(body.inertia, tuple) and body.has_products else (body.moments,)
    quantities = (body.mass, *body.centre, *(value for row in rows for value in row))
    return all(is_number(v) and all(sound.get(p.name) == p for p in parameters_of(v)) for v in quantities)


def tensor_faults(mechanism: Mechanism, body: Body) -> Iterator[Fault]:
    """Yield the faults of a tensor that is not symmetric, or that no distribution of mass has.

    Values are at the defaults. Principal values of zero are short for those that do not matter, as in plane motion.
    """
    where, J = f"body {body.name}, inertia", body.tensor
    for i, k in ((0, 1), (0, 2), (1, 2)):
        if J[i][k] != J[k][i]:
            yield Fault(
                f"{where} J_{'xyz'[i]}{'xyz'[k]}",
                f"{J[i][k]} beside J_{'xyz'[k]}{'xyz'[i]} = {J[k][i]}",
                "a symmetric tensor",
            )
            return
    if not isinstance(body.inertia, tuple) or (mechanism.plane is not None and not body.has_products):
        return
    values = sorted(principal([[default_value(value) for value in row] for row in J]))
    least, middle, most = values
    actual = f"principal values {', '.join(f'{value:.4g}' for value in values)} kg m^2"
    if body.has_products and not least > ROUNDING * most:
        yield Fault(where, actual, "three positive ones",
                    "J_xy is -integral of x y dm. A slender rod lies along an axis of its frame, (0, J, J); a turned point carries it.")  # fmt: skip
    elif least > 0 and most > (least + middle) * (1 + ROUNDING):
        yield Fault(where, actual, "none larger than the sum of the others, as J_z = integral of (x^2 + y^2) dm <= J_x + J_y",
                    "No distribution of mass has these: check the values and the signs of the products, J_xy = -integral of x y dm.")  # fmt: skip


def principal(rows: Sequence[Sequence[float]]) -> list[float]:
    """Eigenvalues of a symmetric 3 x 3 matrix, the least first."""
    return [float(value) for value in mp.eigsy(mp.matrix(rows), eigvals_only=True)]


def whole_of(mechanism: Mechanism, bodies: Sequence[Body]) -> Body:
    """Rigid whole of bodies at their defaults, in the frame of the first, which all others are welded to."""
    parts = [_carried(mechanism, body, bodies[0]) for body in bodies]
    if any(part.mass for part in parts):
        return Body.of(bodies[0].name, *parts)
    return replace(parts[0], inertia=combine(*(part.tensor for part in parts)))


def _carried(mechanism: Mechanism, body: Body, root: Body) -> Body:
    """Body at its defaults, in the frame of one that it is welded to."""
    centre, rows = _numbers(body.centre), _matrix(body.tensor)
    place: Frame = body
    while place != root and (joint := mechanism.joint_of(place)) is not None:
        turn = _matrix(multiply(joint.parent.axes, transpose(joint.child.axes)))
        centre = add(_numbers(joint.parent.position), apply(turn, sub(centre, _numbers(joint.child.position))))
        rows, place = multiply(multiply(turn, rows), transpose(turn)), joint.parent.body
    return Body(body.name, sp.Float(default_value(body.mass)), rows, centre)


def _numbers(vector: Vector) -> Vector:
    """Components at the defaults."""
    x, y, z = (sp.Float(default_value(value)) for value in vector)
    return (x, y, z)


def _matrix(rows: Matrix) -> Matrix:
    x, y, z = map(_numbers, rows)
    return (x, y, z)


def _turning_faults(mechanism: Mechanism, bodies: Sequence[Body], inner: bool) -> Iterator[Fault]:
    """Yield the fault of a rigid whole without inertia about an axis that it is turned about.

    Within a chain (`inner`) others beyond may have it.
    """
    own, joint = mechanism.joint_of(bodies[0]), mechanism.turned_by(bodies[0])
    if inner or own is None or joint is None:
        return
    whole, axis = whole_of(mechanism, bodies), joint.turning[-1]
    arm = sub(whole.centre, _numbers(own.child.position))
    about = combine(whole.tensor, scaled(whole.mass, steiner(arm)))
    size = float(about[0][0] + about[1][1] + about[2][2])
    if axis is None:
        if math.prod(principal(about)) <= 1e-12 * size**3:
            yield Fault(f"body {whole.name}", "inertia 0 about an axis through its joint",
                        "a positive one about every axis, because the joint lets the body turn in every way",
                        "Body(name, mass, (J_x, J_y, J_z)), or a Universal joint, which does not let it turn about itself.")  # fmt: skip
    elif axis.points:
        line = _numbers(apply(joint.child.axes, axis.unit))
        if float(dot(line, apply(about if own is joint else whole.tensor, line))) <= 1e-14 * size:
            yield Fault(
                f"body {whole.name}",
                "inertia 0",
                "a positive inertia about the joint's axis, because the body rotates",
                "Body(name, mass, inertia) about the mass centre; or, if another joint keeps it from turning, "
                "that joint before this one: then it carries the body.",
            )
