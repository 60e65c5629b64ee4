"""Limit sets of friction: convex sets of the forces that a grip holds with, and how it slides.

In one direction an interval, in two a disc, and of a circular patch, which slides in two directions and spins, a body
of revolution: forces along both tangents, and the moment about the normal over the patch's radius. A force on its edge
opposes the velocity along the outward normal there (maximal dissipation): two speeds and that of the rim. The body's support function is
the mean phi of |v + w x r| over the patch, of which force and moment are the derivatives. Its gauge is found by the
normal whose force is along a given one. Leine, Glocker, European Journal of Mechanics A/Solids 22 (2003) 193.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import casadi as ca

MEANS = 7  # arithmetic-geometric means, see `derive.declare.effects.tribology.patch_friction`
ALIKE = 1e-24  # of 1: difference of the squared speeds of sliding and of the rim that counts as none
TURNS = 6  # iterations of Newton's method from the normal of an ellipsoid
SPINNING = 2 / 3  # of the largest force: the largest moment over the radius


def size_of(x: Any) -> Any:
    """Length of a vector; its derivative at zero is taken as zero."""
    squared = ca.sumsqr(x)
    return ca.if_else(squared > 0, ca.sqrt(positive(squared)), 0)


def unit_of(x: Any) -> Any:
    """Unit vector along a vector, or zero."""
    return x / ca.sqrt(positive(ca.sumsqr(x)))


def positive(x: Any) -> Any:
    """Return x where it is positive, else 1."""
    return ca.if_else(x > 0, x, 1)


def gauge(force: Any) -> Any:
    """Return the size of a force: the least limit that holds it."""
    if force.numel() < 3:
        return size_of(force)
    _, way, reach = _edge(force)
    return ca.if_else(ca.sumsqr(force) > 0, ca.dot(force, way) / reach, 0)


def outward(force: Any) -> Any:
    """Return the unit velocity that the opposite of a force belongs to; zero for none."""
    return unit_of(force) if force.numel() < 3 else _edge(force)[1] * (ca.sumsqr(force) > 0)


def opposed(velocity: Any) -> Any:
    """Return the force whose opposite a velocity is opposed with, as a part of its limit; zero for none."""
    if velocity.numel() < 3:
        return unit_of(velocity)
    moves = ca.sumsqr(velocity) > 0
    across, slides, spins = _parts(velocity)
    pull, turn = _slopes(slides, ca.if_else(moves, spins, 1))
    return ca.if_else(moves, ca.vertcat(pull * across, ca.sign(velocity[2]) * turn), 0)


def normal_and_curvature(x: Any) -> tuple[Any, Any]:
    """Return gradient (n) and Hessian (n, n) of half the squared gauge at a force."""
    n = x.numel()
    if n < 3:
        return x, ca.SX.eye(n)
    normal, curvature = _curved()(x, _edge(x)[0])
    none = ca.sumsqr(x) == 0
    at_rest = ca.diag(ca.DM([1, 1, 1 / SPINNING**2]))
    return ca.if_else(none, 0, normal), ca.if_else(none, at_rest, curvature)


def _parts(x: Any) -> tuple[Any, Any, Any]:
    """Direction across the normal, length along it, and size about the normal."""
    return unit_of(x[:2]), size_of(x[:2]), ca.fabs(x[2])


def _edge(force: Any) -> tuple[Any, Any, Any]:
    """Return the angle of the velocity that a patch's force belongs to, its direction (3), and phi there."""
    force = ca.if_else(ca.sumsqr(force) > 0, force, ca.DM([1, 0, 0]))
    across, pull, turn = _parts(force)
    wanted = ca.atan2(turn / SPINNING, pull)
    angle = ca.atan2(turn / SPINNING**2, pull)
    for _ in range(TURNS):
        aimed, slope = _aimed()(angle)
        angle = ca.fmin(ca.fmax(angle - (aimed - wanted) / slope, 0), math.pi / 2)
    way, reach = _way(angle, across, force[2])
    return angle, way, reach


def _way(angle: Any, across: Any, turn: Any) -> tuple[Any, Any]:
    """Return the unit velocity at an angle, and phi there."""
    slides, spins = ca.cos(angle), ca.sin(angle)
    return ca.vertcat(slides * across, spins * ca.sign(turn)), ca.dot(
        ca.vertcat(*_slopes(slides, spins)), ca.vertcat(slides, spins)
    )


@cache
def _aimed() -> Any:
    """Build the function of the angle of a velocity -> angle of its force in a unit sphere, and its slope."""
    angle = ca.SX.sym("angle")
    pull, turn = _slopes(ca.cos(angle), ca.sin(angle))
    aimed = ca.atan2(turn / SPINNING, pull)
    return ca.Function("aimed", [angle], ca.cse([aimed, ca.jacobian(aimed, angle)]))


@cache
def _curved() -> Any:
    """Build the function (force, angle of its velocity) -> gradient and Hessian of half the squared gauge."""
    x, angle = ca.SX.sym("x", 3), ca.SX.sym("angle")
    across, pull, turn = _parts(x)
    aimed, slope = _aimed()(angle)
    way, reach = _way(angle - (aimed - ca.atan2(turn / SPINNING, pull)) / slope, across, x[2])
    normal = ca.dot(x, way) / reach**2 * way
    return ca.Function("curved", [x, angle], ca.cse([normal, ca.densify(ca.jacobian(normal, x))]))


def _slopes(slides: Any, spins: Any) -> tuple[Any, Any]:
    """Return the derivatives of phi by the speeds of sliding and of the rim.

    By complete elliptic integrals of the smaller over the larger squared, evaluated by arithmetic-geometric means.
    """
    faster = slides > spins
    more, less = ca.if_else(faster, slides, spins), ca.if_else(faster, spins, slides)
    m = (less / more) ** 2
    left = 1 - m
    a, b, c, total = 1.0, ca.sqrt(ca.if_else(left > ALIKE, left, ALIKE)), None, 0.0
    for n in range(MEANS):
        mean = (a + b) / 2
        c = 1 / (4 * mean) if c is None else m * c**2 / (4 * mean)
        a, b, total = mean, ca.sqrt(a * b), total + 2**n * c**2
    half, period = 1 / 2 + m * total, math.pi / (2 * a)
    pull = 4 / (3 * math.pi) * (2 - (1 + m) * half)
    turn = 4 / (9 * math.pi) * ca.if_else(faster, 1 + 2 * total * (1 - 2 * m), 3 - m - (4 - 2 * m) * m * half)
    return period * pull * slides / more, period * turn * spins / more


@cache
def measured() -> Any:
    """Build the function of a patch's force (3) -> its gauge."""
    force = ca.SX.sym("force", 3)
    return ca.Function("gauge", [force], ca.cse([gauge(force)]))
