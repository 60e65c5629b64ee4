"""Bricard's mechanism without angles or frames: the coordinates are the positions of its four moving vertices.

A rod is as long as ever; the hinge across two rods that meet is square to both, and the hinges at the two ends of a rod are square to each other. A
uniform rod is m/6 [[2, 1], [1, 2]] on its ends. Positions, speeds, multipliers by least squares; projected onto the constraints
after every interval. Run as a script it prints the digits of runtime/analysis/validation/scenarios/bricard.toml (a minute and a half).
"""

from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

FIRST, LAST = np.zeros(3), np.array([0.0, 0.0, 1.0])
START = np.array([[1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1]], dtype=float).ravel()
NODES, WEIGHTS = (
    np.arange(-3, 4),
    np.array([-1, 9, -45, 0, 45, -9, 1]) / 60,
)  # derivative of a polynomial of degree 6 or less

_ends = np.zeros((4, 4))
for rod in range(5):
    for i in (rod - 1, rod):
        for j in (rod - 1, rod):
            if {i, j} <= {0, 1, 2, 3}:
                _ends[i, j] += (2 if i == j else 1) / 6
MASS, WEIGHT = np.kron(_ends, np.eye(3)), np.tile([0, -9.81, 0], 4)


def constraints(x):
    """Twelve, one of them redundant; for complex x too."""
    vertices = np.vstack([FIRST, x.reshape(4, 3), LAST])
    rods = vertices[1:] - vertices[:-1]
    e = np.vstack([FIRST - LAST, rods, FIRST - LAST])  # the ground is the sixth edge
    lengths = [rod @ rod - 1 for rod in rods]
    hinges = [(e[i] @ e[i + 1]) * (e[i + 1] @ e[i + 2]) - (e[i] @ e[i + 2]) * (e[i + 1] @ e[i + 1]) for i in range(5)]
    return np.array([*lengths, *hinges, rods[0][1], rods[4][0]])


def along(x, v):
    """Derivative of the constraints along v."""
    return constraints(x + 1e-30j * v).imag / 1e-30


def jacobian(x):
    return np.array([along(x, v) for v in np.eye(12)]).T


def rates(t, s):
    x, v = s[:12], s[12:]
    jac = jacobian(x)
    bend = sum(weight * along(x + 1e-3 * node * v, v) for node, weight in zip(NODES, WEIGHTS, strict=True)) / 1e-3
    saddle = np.block([[MASS, jac.T], [jac, np.zeros((12, 12))]])
    return np.concatenate([v, np.linalg.lstsq(saddle, np.concatenate([WEIGHT, -bend]), rcond=1e-10)[0][:12]])


def closed(s):
    """The state nearby that meets the constraints and their rates."""
    x, v = s[:12].copy(), s[12:].copy()
    for _ in range(4):
        x -= np.linalg.lstsq(jacobian(x), constraints(x), rcond=1e-6)[0]
    jac = jacobian(x)
    return np.concatenate([x, v - np.linalg.lstsq(jac, jac @ v, rcond=1e-6)[0]])


def first_angle(t, tolerance=3e-13):
    """Angle of the first hinge a time t [s] after the start at rest, by intervals of 25 ms."""
    s = np.concatenate([START, np.zeros(12)])
    times = np.linspace(0, t, max(2, round(t / 0.025) + 1))
    for begin, end in pairwise(times):
        s = closed(solve_ivp(rates, (begin, end), s, method="DOP853", rtol=tolerance, atol=tolerance).y[:, -1])
    return float(np.arctan2(-s[2], s[0]))


if __name__ == "__main__":
    print(first_angle(10.0))
