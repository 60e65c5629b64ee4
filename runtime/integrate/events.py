"""Where in a step a gap closes or opens, or a force runs out: polynomials in theta = (t - t0)/h, their Bernstein form, and their first root.

A gap is a quintic from its value, rate and acceleration at both ends of the step, a force a cubic from value and rate. A polynomial whose
Bernstein coefficients are all positive has no root in the step; only otherwise is one searched for. Farin, Curves and Surfaces for CAGD, ch. 5.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import comb
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.explicit import EPS
from hertzwerk.runtime.integrate.layout import CONTACT, FLIGHT, RELEASED, Layouts

if TYPE_CHECKING:
    from hertzwerk.runtime.model import Model

LANDING = 1e-2  # the tolerances of a landing are this times the accuracy, in the scene's scales
DOUBT = 0.1  # part of |quintic - cubic| that a graze must stay clear of
PARTS = 8  # sub-intervals searched
NEWTON_STEPS = 12  # within one of them, bisecting where Newton would leave the bracket
NO_EVENT = 2.0  # theta beyond every step


def tolerances(model: Model, run: Mapping[str, Any], t: Any, y: Any, gap_rate: Any) -> tuple[Any, Any, Any]:
    """Tolerance of a gap (k) [m], of a gap rate [m/s] and of a force [N] at a landing: a hundredth of the accuracy, but not below rounding.

    A gap is rounded with the positions it is a difference of, and with the time it is landed at.
    """
    length, speed, force = (run["scales"][i] for i in range(3))
    q, scale = y[: model.nq], run["scale"][: model.nq]
    position = length * ca.mmax(ca.fabs(q) / scale)
    gap = ca.fmax(
        ca.fmax(LANDING * run["accuracy"] * length, 8 * EPS * position), 4 * EPS * ca.fabs(gap_rate) * ca.fabs(t)
    )
    small = LANDING * run["accuracy"]
    return gap, small * speed, small * force


def polynomials(model: Model, layouts: Layouts, *, contacts: bool) -> Any:
    """CasADi function (state, controls, trial) -> (bernstein (6, n), margin (n), doubt (n), suspect) for the n possible events of a trial step.

    n = 2 k: the gaps, then what ends a contact or a release before the gap opens. An event is the first theta where a polynomial, falling from
    above, has a root and goes on to -margin; a graze whose minimum is below doubt is resolved by a shorter step. suspect: 1 if any of it is possible.
    """
    names, parts = ("state", "controls", "trial"), (layouts.state, layouts.controls, layouts.trial)
    arguments = [layout.symbol(name) for layout, name in zip(parts, names, strict=True)]
    start, run, end = (layout.split(vector) for layout, vector in zip(parts, arguments, strict=True))
    h = start["h"]
    tol, tol_rate, tol_force = tolerances(model, run, end["t"], end["y"], end["gap_rate"])
    sign = ca.if_else(start["mode"] == FLIGHT, 1, -1)
    g, rate, acceleration = (sign * start[part] for part in ("gap", "gap_rate", "gap_acceleration"))
    g1, rate1, acceleration1 = (sign * end[part] for part in ("gap", "gap_rate", "gap_acceleration"))
    b = _quintic([g, rate, acceleration], [g1, rate1, acceleration1], h)
    # On the surface and leaving it: the root at 0 is no event, the return is. (g(theta) - g)/theta is a quartic, here raised to degree 5.
    leaving, resting = (g <= tol) * (rate >= 0), (g <= tol) * (rate < 0)
    deflated = _raise([5 * (b[i] - b[0]) / i for i in range(1, 6)])
    # At rest within the tolerance the end of the step decides, not the polynomial.
    b = [ca.if_else(leaving, d, ca.if_else(resting, 1, x)) for d, x in zip(deflated, b, strict=True)]
    between = DOUBT * ca.fabs(h * (rate - rate1) / 32 + h * h * (acceleration + acceleration1) / 64)
    bernstein, margin = [ca.vertcat(*(x.T for x in b))], [ca.if_else(leaving, 2, 1) * tol]
    doubt = [ca.if_else((between > tol) * (1 - leaving), between, 0)]
    # A cubic falls from above zero: in contact the force, which would pull from there on; released, the opening speed, after which the
    # bodies close again. Aimed half the tolerance below zero, so that the landing is beyond.
    ends = [
        (end["gap_rate"], start["gap_rate"], end["gap_acceleration"], start["gap_acceleration"], RELEASED, tol_rate)
    ]
    if contacts:
        ends.append((end["force"], start["force"], end["force_rate"], start["force_rate"], CONTACT, tol_force))
    rows = [ca.SX(1)] * 6
    aim = ca.SX(0)
    for f1, f, rate1, rate, where, small in ends:
        falls = (start["mode"] == where) * (f >= 0) * (f1 < -small) * (end["gap"] < -tol)
        cubic = _raise(_raise([f, f + h * rate / 3, f1 - h * rate1 / 3, f1]))
        rows = [ca.if_else(falls, x + small / 2, row) for x, row in zip(cubic, rows, strict=True)]
        aim = ca.if_else(falls, small / 2, aim)
    bernstein.append(ca.vertcat(*(row.T for row in rows)))
    margin.append(aim)
    doubt.append(ca.SX.zeros(model.k))
    bernstein, margin, doubt = ca.horzcat(*bernstein), ca.vertcat(*margin), ca.vertcat(*doubt)
    suspect = ca.mmin(_row_minimum(bernstein.T) - doubt) <= 0
    return ca.Function(
        "polynomials",
        arguments,
        [ca.densify(bernstein), ca.densify(margin), ca.densify(doubt), suspect],
        names,
        ["bernstein", "margin", "doubt", "suspect"],
    )


def locate(n: int) -> Any:
    """CasADi function (bernstein (6, n), margin (n), doubt (n)) -> theta in (0, 1] of the first event, or NO_EVENT.

    Half the step where a graze is in doubt. The polynomials are evaluated at the ends of equal parts; the first part with a change of sign, or with a
    minimum that reaches -margin, brackets the root, which bisection-safeguarded Newton steps find. All n at once, branch-free.
    """
    bernstein, margin, doubt = ca.SX.sym("bernstein", 6, n), ca.SX.sym("margin", n), ca.SX.sym("doubt", n)
    a = ca.mtimes(ca.DM(_POWERS), bernstein)
    value = [a[j, :].T for j in range(6)]
    slope = [j * value[j] for j in range(1, 6)]
    curvature = [j * slope[j] for j in range(1, 5)]
    nodes = [i / PARTS for i in range(PARTS + 1)]
    values = ca.horzcat(*(_horner(value, x) for x in nodes)) + ca.repmat(margin, 1, PARTS + 1)
    slopes = ca.horzcat(*(_horner(slope, x) for x in nodes))
    above, falls = values > 0, slopes < 0
    index = ca.repmat(ca.DM(range(PARTS)).T, n, 1)
    crosses = above[:, :-1] * (1 - above[:, 1:])
    dips = above[:, :-1] * above[:, 1:] * falls[:, :-1] * (1 - falls[:, 1:])
    crossing, dip = (_row_minimum(ca.if_else(kind, index, PARTS)) for kind in (crosses, dips))  # PARTS: none

    bottom = (dip + 0.5) / PARTS
    for _ in range(3):
        bend = _horner(curvature, bottom)
        step = ca.if_else(bend > 0, _horner(slope, bottom) / bend, 0)
        bottom = ca.fmin(ca.fmax(bottom - step, dip / PARTS), (dip + 1) / PARTS)
    lowest = _horner(value, bottom)
    in_dip = (dip < crossing) * (lowest <= -margin)
    in_doubt = (dip < crossing) * (lowest > -margin) * (lowest < doubt)
    part = ca.if_else(in_dip, dip, crossing)
    first = low = part / PARTS
    high = ca.if_else(in_dip, bottom, (part + 1) / PARTS)
    at_bottom = bottom - ca.sqrt(ca.fmax(-2 * lowest / _horner(curvature, bottom), 0))
    x = ca.if_else(in_dip, ca.fmax(at_bottom, low), (low + high) / 2)
    for _ in range(NEWTON_STEPS):
        at_x, rate = _horner(value, x), _horner(slope, x)
        positive = at_x > 0
        low, high = ca.if_else(positive, x, low), ca.if_else(positive, high, x)
        newton = x - at_x / rate
        x = ca.if_else((newton >= low) * (newton <= high), newton, (low + high) / 2)
    # within the margin of zero already at the part's left end: that end will do
    x = ca.if_else(_horner(value, first) > 0, x, ca.fmax(first, high / PARTS))
    theta = ca.if_else(part < PARTS, x, ca.if_else(in_doubt, 0.5, NO_EVENT))
    return ca.Function(
        "locate", [bernstein, margin, doubt], [ca.mmin(theta)], ["bernstein", "margin", "doubt"], ["theta"]
    )


_POWERS = [
    [comb(5, j) * (-1) ** (i + j) * comb(j, i) if i <= j else 0 for i in range(6)] for j in range(6)
]  # of 1, theta, ..., theta^5


def _quintic(start: list[Any], end: list[Any], h: Any) -> list[Any]:
    """Bernstein coefficients of the quintic with value, rate and acceleration at both ends of a step h."""
    left = [start[0], start[0] + h * start[1] / 5, start[0] + 2 * h * start[1] / 5 + h * h * start[2] / 20]
    right = [end[0], end[0] - h * end[1] / 5, end[0] - 2 * h * end[1] / 5 + h * h * end[2] / 20]
    return [*left, *reversed(right)]


def _raise(b: list[Any]) -> list[Any]:
    """The same polynomial in Bernstein form, one degree higher."""
    n = len(b)
    return [b[0], *(i / n * b[i - 1] + (1 - i / n) * b[i] for i in range(1, n)), b[-1]]


def _horner(a: list[Any], x: Any) -> Any:
    total = a[-1]
    for coefficient in reversed(a[:-1]):
        total = total * x + coefficient
    return total


def _row_minimum(matrix: Any) -> Any:
    smallest = matrix[:, 0]
    for j in range(1, matrix.shape[1]):
        smallest = ca.fmin(smallest, matrix[:, j])
    return smallest
