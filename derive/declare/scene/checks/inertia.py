"""Faults of bodies that lack the mass or inertia their joints' motions need."""

from __future__ import annotations

import math
from collections.abc import Iterator

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Body, Direction, Frame
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.checks.topology import connection_faults, rigid_root
from hertzwerk.derive.expressions.algebra.vectors import apply, cross, sub
from hertzwerk.derive.expressions.parameter import Parameter, default_value, is_number, parameters_of

ROUNDING = 1e-9
"""Part of an inertia that counts as rounding."""


def inertia_faults(mechanism: Mechanism, sound: dict[str, Parameter]) -> Iterator[Fault]:
    """Yield faults of missing masses and inertias.

    A body turned about its mass centre needs an inertia about the axis; other principal inertias may be zero in plane
    motion. The last body of a chain needs a mass, unless it closes a loop, and an inertia about every axis where it may
    turn about every axis.
    """
    if any(True for _ in connection_faults(mechanism)):
        return
    loaded = {rigid_root(mechanism, body) for body in mechanism.bodies if not (is_number(body.mass) and body.mass == 0)}
    moved = [joint for joint in mechanism.joints if joint.freedoms]
    carriers = {rigid_root(mechanism, joint.parent.body) for joint in moved}
    alone = {joint.parent.body for joint in mechanism.joints}
    tied = {rigid_root(mechanism, place.body) for joint in mechanism.closures for place in (joint.parent, joint.child)}
    for body in (joint.child.body for joint in mechanism.tree if isinstance(joint.child.body, Body)):
        root = rigid_root(mechanism, body)
        if body == root and body not in carriers and body not in loaded and body not in tied:
            yield Fault(f"body {body.name}, mass", "0 kg at the end of a chain", "a value in (0, inf), because nothing beyond it has a mass",
                        "Give it a mass (under a drive any will do: only the drive's force has it), close a loop by a joint to it, or "
                        "leave it out.")  # fmt: skip
        if body.mass == 0:
            continue
        rows = body.inertia if isinstance(body.inertia, tuple) and body.has_products else (body.moments,)
        given = (body.mass, *body.centre, *(value for row in rows for value in row))
        if not all(is_number(v) and all(sound.get(p.name) == p for p in parameters_of(v)) for v in given):
            continue
        zero = [default_value(value) == 0 for value in body.moments]
        impossible = list(_tensor_faults(mechanism, body))
        yield from impossible
        if impossible:
            continue
        for axis in _turning_axes(mechanism, body):
            if axis is None and body == root and body not in {*carriers, *alone} and _spins_freely(mechanism, body):
                yield Fault(f"body {body.name}", "inertia 0 about an axis through its joint",
                            "a positive one about every axis, because the joint lets the body turn in every way",
                            "Body(name, mass, (J_x, J_y, J_z)), or a Universal joint, which does not let it turn about itself.")  # fmt: skip
            elif (
                axis is not None
                and axis.points
                and all(zero[k] for k in range(3) if axis.components[k] != 0)
                and not _swings(mechanism, body, axis)
            ):
                yield Fault(
                    f"body {body.name}",
                    "inertia 0",
                    "a positive inertia about the joint's axis, because the body rotates",
                    "Body(name, mass, inertia) about the mass centre; or, if another joint keeps it from turning, "
                    "that joint before this one: then it carries the body.",
                )


def _tensor_faults(mechanism: Mechanism, body: Body) -> Iterator[Fault]:
    """Faults of a tensor that is not symmetric, or that no distribution of mass has at the defaults.

    Principal values of zero are short for those that do not matter, as in plane motion.
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
    values = sorted(_principal([[default_value(value) for value in row] for row in J]))
    least, middle, most = values
    found = f"principal values {', '.join(f'{value:.4g}' for value in values)} kg m^2"
    if body.has_products and not least > ROUNDING * most:
        yield Fault(where, found, "three positive ones",
                    "J_xy is -integral of x y dm. A slender rod lies along an axis of its frame, (0, J, J); a turned point carries it.")  # fmt: skip
    elif least > 0 and most > (least + middle) * (1 + ROUNDING):
        yield Fault(where, found, "none larger than the sum of the others, as J_z = integral of (x^2 + y^2) dm <= J_x + J_y",
                    "No distribution of mass has these: see the values, and the signs of the products, J_xy = -integral of x y dm.")  # fmt: skip


def _principal(J: list[list[float]]) -> tuple[float, float, float]:
    """Eigenvalues of a symmetric 3 x 3 matrix. Smith, Comm. ACM 4 (1961) 168."""
    mean = (J[0][0] + J[1][1] + J[2][2]) / 3
    spread = math.sqrt(sum((J[i][k] - mean * (i == k)) ** 2 for i in range(3) for k in range(3)) / 6)
    if not spread > 0:
        return (mean, mean, mean)
    B = sp.Matrix(3, 3, lambda i, k: (J[i][k] - mean * (i == k)) / spread)
    angle = math.acos(max(-1.0, min(1.0, float(B.det()) / 2))) / 3
    first, last = mean + 2 * spread * math.cos(angle), mean + 2 * spread * math.cos(angle + 2 * math.pi / 3)
    return (first, 3 * mean - first - last, last)


def _spins_freely(mechanism: Mechanism, body: Body) -> bool:
    """Whether a body has no inertia about some axis through its joint's point, at the defaults."""
    joint = mechanism.joint_of(body)
    at = joint.child.position if joint is not None else (0, 0, 0)
    arm = [default_value(c) - default_value(p) for c, p in zip(body.centre, at, strict=True)]
    own = [[default_value(value) for value in row] for row in body.tensor]
    mass, square = default_value(body.mass), sum(x * x for x in arm)
    about = sp.Matrix(3, 3, lambda i, j: own[i][j] + mass * square * (i == j) - mass * arm[i] * arm[j])
    return bool(about.det() <= 1e-12 * about.trace() ** 3)


def _swings(mechanism: Mechanism, body: Body, axis: Direction) -> bool:
    """Whether the joint of a body turns it about an axis that misses its mass centre.

    Then it needs no inertia of its own.
    """
    joint = mechanism.joint_of(body)
    if joint is None or all(freedom.kind == "slide" for freedom in joint.freedoms):
        return False
    arm = sub(body.centre, joint.child.position)
    turned = apply(joint.child.axes, axis.unit)
    return any(default_value(component) != 0 for component in cross(arm, turned))


def _turning_axes(mechanism: Mechanism, body: Frame) -> list[Direction | None]:
    """Axis of the last turn of the nearest joint that turns a body, in the joint's axes.

    [None] if that is every axis; [] if nothing turns it.
    """
    joint = mechanism.turned_by(body)
    return [] if joint is None else [joint.turning[-1]]
