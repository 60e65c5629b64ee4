"""Faults of bodies that lack the mass or inertia their joints' motions need."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from hertzwerk.derive.algebra.vectors import apply, cross, sub
from hertzwerk.derive.declare.soundness.topology import connection_faults, rigid_root
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.bodies import Body, Direction, Frame
from hertzwerk.derive.mechanism.mechanism import Mechanism
from hertzwerk.derive.mechanism.parameter import Parameter, default_value, is_number, parameters_of


def inertia_faults(mechanism: Mechanism, sound: dict[str, Parameter]) -> Iterator[Fault]:
    """Yield faults of missing masses and inertias.

    A body turned about its mass centre needs an inertia about the axis; other principal inertias may be zero in plane
    motion. The last body of a chain needs a mass, and an inertia about every axis where it may turn about every axis.
    """
    if any(True for _ in connection_faults(mechanism)):
        return
    loaded = {rigid_root(mechanism, body) for body in mechanism.bodies if not (is_number(body.mass) and body.mass == 0)}
    moved = [joint for joint in mechanism.joints if joint.freedoms]
    carriers = {rigid_root(mechanism, joint.parent.body) for joint in moved}
    alone = {joint.parent.body for joint in mechanism.joints}
    for body in mechanism.bodies:
        root = rigid_root(mechanism, body)
        if body == root and body not in carriers and body not in loaded:
            yield Fault(f"body {body.name}, mass", "0 kg at the end of a chain", "a value in (0, inf), because nothing beyond it has a mass",
                        "Give it a mass, or leave it out.")  # fmt: skip
        if body.mass == 0:
            continue
        given = (body.mass, *body.centre, *(body.inertia if isinstance(body.inertia, tuple) else (body.inertia,) * 3))
        if not all(is_number(v) and all(sound.get(p.name) == p for p in parameters_of(v)) for v in given):
            continue
        zero = [default_value(value) == 0 for value in given[4:]]
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
                    "Body(name, mass, inertia) about the mass centre, or a joint beside it.",
                )


def _spins_freely(mechanism: Mechanism, body: Body) -> bool:
    """Whether a body has no inertia about some axis through its joint's point, at the defaults."""
    joint = mechanism.joint_of(body)
    at = joint.child.position if joint is not None else (0, 0, 0)
    arm = [default_value(c) - default_value(p) for c, p in zip(body.centre, at, strict=True)]
    own = [default_value(J) for J in (body.inertia if isinstance(body.inertia, tuple) else (body.inertia,) * 3)]
    mass, square = default_value(body.mass), sum(x * x for x in arm)
    about = sp.Matrix(3, 3, lambda i, j: (own[i] + mass * square) * (i == j) - mass * arm[i] * arm[j])
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
    joint = mechanism.joint_of(body)
    if joint is None:
        return []
    turning = [freedom.axis for freedom in joint.freedoms if freedom.kind != "slide"]
    return turning[-1:] or _turning_axes(mechanism, joint.parent.body)
