"""Step size control by error estimate, smoothness of contact forces and distance to a surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.layout import CONTACT, FLIGHT

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table

SAFETY = 0.85
SHRINK, GROW = 0.2, 3.0  # limits of the factor between steps
ONSET_ORDER = 2.5  # a force like d^1.5 from zero: the first step's speed error falls with h^2.5 whatever the method
ONSET_GROW = 3.0  # from a contact's first step to its second
ROUGHEST = 16.0  # largest factor of `roughness`; 8 to 64 cost the same within a tenth at equal error
LANDING_PART = 0.7  # of the way back to the surface: most that a step in contact covers, unless it lands
LANDING_STEP = 1.1  # of the onset's step: longest step that lands
FAR = 1e300


def roughness(touching: Any, gap: Any, end_gap: Any) -> Any:
    """Return the factor, 1..ROUGHEST, on the error estimate for nonsmooth contact forces.

    touching, gap, end_gap (k): contact, and the gaps at both ends of the step. An estimate is built for smooth
    functions. A force d^n is singular at d = 0, so what counts is how much of the way to zero a step covers. On d'' =
    -d^1.5 the true error of a step over its estimate is, for dop853 | dopri5, at d_big/d_small = 1.3: 0.1 | 0.1, 2:
    0.4 | 0.6, 4: 0.9 | 2, 8: 1.4 | 4, 30: 2.3 | 7.5, from or to the surface: 3.4 | 11. Smooth steps' estimates are
    pessimistic by that tenth; only the relation matters, and (d_big/d_small)^2, limited, is an upper bound of it.
    """
    a, b = ca.fabs(gap), ca.fabs(end_gap)
    ratio = ca.fmax(a, b) / ca.fmax(ca.fmin(a, b), 1 / FAR)
    factor = ca.fmin(ratio * ratio, ROUGHEST)
    return ca.mmax(ca.if_else(touching, factor, 1))


def factor(table: Table, error: Any) -> Any:
    """Return the ratio of new to old step by the error norm (elementary controller).

    Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4.
    """
    return _within(SAFETY / _root(ca.fmax(error, 1e-30), table.error_order))


def onset_factor(error: Any) -> Any:
    """Return the ratio of new to old step for the first step of a contact."""
    return _within(SAFETY / ca.fmax(error, 1e-30) ** (1 / ONSET_ORDER))


def step_to_continue(h: Any, planned: Any, grown: Any) -> Any:
    """Return the step [s] to continue with after an accepted one.

    A step shortened by an event or by the end of the run does not reduce it.
    """
    return ca.if_else(h < planned * (1 - 1e-9), ca.fmax(planned, grown), grown)


def limited_by_surfaces(free: Any, h_onset: Any, mode: Any, end: dict[str, Any], resting: Any = 0) -> Any:
    """Limit the step `free` [s] to land on the next surface or, in contact, approach it gradually.

    A step over the kink of the force would be rejected; a step to just before it is followed by a tiny one. resting:
    1 for the pairs (k) that stay in contact while on their surface, so that no surface lies ahead of them.
    """
    sign = ca.if_else(mode == FLIGHT, 1, -1)
    g, rate, acceleration = (sign * end[part] for part in ("gap", "gap_rate", "gap_acceleration"))
    opening = time_to_root(g, rate, acceleration)
    opening = ca.if_else(opening <= LANDING_STEP * h_onset, opening, LANDING_PART * opening)
    landing = time_to_landing(g, rate, acceleration)
    leaving = (mode == CONTACT) * (1 - resting)
    return ca.fmin(free, ca.mmin(ca.if_else(leaving, opening, ca.if_else(mode == FLIGHT, landing, FAR))))


def time_to_root(g: Any, rate: Any, acceleration: Any) -> Any:
    """Return the time [s] until g, constantly accelerated, falls through zero; FAR where it does not fall.

    Negative where it has fallen through zero already.
    """
    root = ca.sqrt(ca.fmax(rate * rate - 2 * acceleration * g, 0))
    return ca.if_else(rate < 0, 2 * g / (root - rate), FAR)  # of the two roots the first, without cancellation


def time_to_landing(g: Any, rate: Any, acceleration: Any) -> Any:
    """Return the time [s] until g, constantly accelerated, next falls through zero; FAR if never.

    Where g rises now, the time is that of its return.
    """
    falls = rate < 0
    reach = ca.sqrt(ca.fmax(rate * rate - 2 * acceleration * g, 0)) + ca.fabs(rate)
    # of the two roots the one wanted, without cancellation, by one division
    time = ca.if_else(falls, 2 * g, reach) / ca.if_else(falls, reach, -acceleration)
    return ca.if_else(falls + (acceleration < 0) > 0, time, FAR)


def _within(value: Any) -> Any:
    return ca.fmin(ca.fmax(value, SHRINK), GROW)


def _root(x: Any, order: int) -> Any:
    """Return x^(1/order), by square roots where possible: a power costs more than all of them."""
    while order % 2 == 0:
        x, order = ca.sqrt(x), order // 2
    return x if order == 1 else x ** (1 / order)
