"""The woodpecker by hand: Lagrange's equations of sleeve and bird, one set for each state of its contacts, integrated by SciPy.

Coordinates are height, tilt of the sleeve and pitch of the bird, both against the ground. Corners at the bar press with K d^1.5 (1 + 3/2 (1 - e)
d'/v0), v0 the speed at the onset, until that is zero, and rub with mu N tanh(s/v_s). Run as a script it prints the digits of
runtime/analysis/validation/scenarios/woodpecker.toml (ten seconds).
"""

from functools import partial

import numpy as np
from scipy.integrate import solve_ivp

G, K, MU, LAYER, SPRING, FLOOR = 9.81, 1e6, 0.3, 1e-5, 5.6e-3, 1e-3
BAR, SLEEVE, HALF, HINGE, CENTRE = 2.5e-3, 3.1e-3, 5.8e-3, 10e-3, 15e-3
BEHIND, HIGH = 15e-3 - 20.1e-3, 20e-3  # the beak in the bird's frame
M, J, M_BIRD, J_BIRD = 3e-4, 5e-9, 4.5e-3, 7e-7
DAMPING = 1.5 * (1 - np.array([0.05, 0.05, 0.5]))
START = np.array([0, -0.1036, -0.1036 - 0.1752, -0.3411, 0, -7.4583])


def corners(q):
    """Upper and lower corner of the sleeve, beak: gaps, and the derivatives of their x and y by the coordinates."""
    _, tilt, pitch = q
    c, s, C, S = np.cos(tilt), np.sin(tilt), np.cos(pitch), np.sin(pitch)
    x = [SLEEVE * c - HALF * s, SLEEVE * c + HALF * s, HINGE * c + BEHIND * C - HIGH * S]
    dx = [[0, -SLEEVE * s - HALF * c, 0], [0, -SLEEVE * s + HALF * c, 0], [0, -HINGE * s, -BEHIND * S - HIGH * C]]
    dy = [[1, SLEEVE * c - HALF * s, 0], [1, SLEEVE * c + HALF * s, 0], [1, HINGE * c, BEHIND * C - HIGH * S]]
    return np.array(x) - BAR, np.array(dx), np.array(dy)


def approach_of(y):
    """Speeds at which the corners come nearer."""
    return -(corners(y[:3])[1] @ y[3:])


def damped(y, onset):
    """Factor of the elastic forces."""
    return 1 + DAMPING * approach_of(y) / onset


def gap_of(i, y):
    return corners(y[:3])[0][i]


def force_of(i, onset, y):
    return damped(y, onset)[i]


def rates(closed, onset, t, y):
    del t
    (_, tilt, pitch), (_, w, v) = y[:3], y[3:]
    c, C, turn = np.cos(tilt), np.cos(pitch), pitch - tilt
    both = M_BIRD * HINGE * CENTRE
    mass = [
        [M + M_BIRD, M_BIRD * HINGE * c, M_BIRD * CENTRE * C],
        [M_BIRD * HINGE * c, J + M_BIRD * HINGE**2, both * np.cos(turn)],
        [M_BIRD * CENTRE * C, both * np.cos(turn), J_BIRD + M_BIRD * CENTRE**2],
    ]
    force = [
        -(M + M_BIRD) * G + M_BIRD * (HINGE * np.sin(tilt) * w**2 + CENTRE * np.sin(pitch) * v**2),
        -M_BIRD * G * HINGE * c + both * np.sin(turn) * v**2 + SPRING * turn,
        -M_BIRD * G * CENTRE * C - both * np.sin(turn) * w**2 - SPRING * turn,
    ]
    gap, dx, dy = corners(y[:3])
    normal = closed * K * np.maximum(-gap, 0) ** 1.5 * damped(y, onset)
    force = force + dx.T @ normal - dy.T @ (MU * normal * np.tanh(dy @ y[3:] / LAYER))
    return np.concatenate([y[3:], np.linalg.solve(mass, force)])


def event(function, direction):
    """An event of SciPy that ends the integration."""

    def margin(t, y):
        return function(y)

    margin.terminal, margin.direction = True, direction
    return margin


def fallen(y, end, rtol):
    """State after a time, from one where the corners that touch are those without a gap; and the onsets of the beak."""
    t, closed, onset = 0.0, corners(y[:3])[0] < 0, np.maximum(FLOOR, approach_of(y))
    released, hits = np.zeros(3, bool), []  # whose damping would pull, though they are not yet apart
    while True:
        events = [event(partial(gap_of, i), 1 if closed[i] or released[i] else -1) for i in range(3)]
        events += [event(partial(force_of, i, onset.copy()), -1) for i in np.flatnonzero(closed)]
        pieces = partial(rates, closed.copy(), onset.copy())
        run = solve_ivp(pieces, (t, end), y, "Radau", events=events, rtol=rtol, atol=1e-3 * rtol)
        t, y = run.t[-1], run.y[:, -1]
        if run.status != 1:
            return y, hits
        found = next(k for k, times in enumerate(run.t_events) if len(times))
        if found >= 3:
            i = np.flatnonzero(closed)[found - 3]
            closed[i], released[i] = False, True
        elif closed[found] or released[found]:
            closed[found] = released[found] = False
        else:
            closed[found], onset[found] = True, max(FLOOR, approach_of(y)[found])
            hits += [(t, onset[2])] if found == 2 else []


if __name__ == "__main__":
    for rtol in (1e-8, 1e-9, 1e-10):
        state, hits = fallen(START, 0.3, rtol)
        print(rtol, repr(state), hits)
