"""Variational equations over steps of a run: what changes before a step do at its end.

Within a step, under its modes, S' = f_y S + f_m M + f_t T + f_c dc, linear, with coefficients along the motion that the run
has. It is solved by collocation at Gauss' points (order 12; stable however stiff), on the states that the step's own method
has there. Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, chapters I.14 and II.7.

In contact, the time from the nearer event is the fourth power of a linear function of the collocation's variable: beside a
surface, forces like the fourth root of the penetration are smooth in it, and so are their derivatives.
"""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.engine.sensitivity.step_chain import evenness, quadratic
from hertzwerk.runtime.engine.sensitivity.tangent import Directions, rates, tangent
from hertzwerk.runtime.engine.solution.history import History

NODES = 6  # of Gauss: order 12, as coefficients are rougher than the motion
BYTES = 2e7  # of the systems solved at once


def _gauss(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return nodes, matrix and weights of Gauss' method."""
    nodes = (1 + np.polynomial.legendre.leggauss(count)[0]) / 2
    powers = np.arange(count)
    at_nodes = nodes[:, None] ** powers
    matrix = np.linalg.solve(at_nodes.T, (nodes[:, None] ** (powers + 1) / (powers + 1)).T).T
    return nodes, matrix, np.linalg.solve(at_nodes.T, 1 / (powers + 1))


C, A, B = _gauss(NODES)


def transitions(
    history: History, index: np.ndarray, h: np.ndarray, switched: np.ndarray, directions: Directions
) -> np.ndarray:
    """Return the maps (j, n, n + P) over times h (j,) [s] after rows, as those of a link (`step_chain`).

    index (j,): the rows; switched (rows,): whether a row follows an event
    """
    ny = history.engine.layouts.state.sizes["y"]
    n, block = ny + history.model.nm + 1, max(int(BYTES / (8 * (ny * NODES) ** 2)), 1)
    maps = np.zeros((len(index), n, n + directions.count))
    maps[:, np.arange(n), np.arange(n)] = 1
    root, fourth = evenness(history, index, h, switched, powers=(0.5, 0.25))
    for first in range(0, len(index), block):
        some = slice(first, first + block)
        evens = root[some], fourth[some]
        maps[some, :ny] += _collocated(history, history.rows[index[some]], h[some], evens, directions)
    return maps


def _collocated(
    history: History, rows: np.ndarray, h: np.ndarray, evens: tuple[np.ndarray, np.ndarray], directions: Directions
) -> np.ndarray:
    """Return the growth (j, ny, n + P) of the state's changes over times h (j,) [s] after rows."""
    j, ny = len(rows), history.engine.layouts.state.sizes["y"]
    root, fourth = evens
    inner = [quadratic(fourth, node) for node in C]
    outer = [quadratic(root, share) for share, _ in inner]
    inside = np.concatenate([history.later(rows, h * share) for share, _ in outer])  # by nodes, then rows
    pace = np.array([h * by_inner * by_s for (_, by_inner), (_, by_s) in zip(outer, inner, strict=True)])
    at = tangent(rates, history, inside, directions)
    by = np.concatenate([at.to_state, at.to_memory, at.to_time[:, :, None], at.by_constants], axis=2)
    sources = pace[:, :, None, None] * by.reshape(NODES, j, ny, -1)
    core = np.flatnonzero((sources[:, :, :, :ny] != 0).any(axis=(0, 1, 2)))  # states that rates depend on: no ledger
    size, by_core = len(core), sources[:, :, :, core]
    system = np.zeros((j, NODES, size, NODES, size))
    for i in range(NODES):
        for k in range(NODES):
            system[:, i, :, k, :] = (i == k) * np.eye(size) - A[i, k] * by_core[i][:, core]
    right = sources[:, :, core].swapaxes(0, 1).reshape(j, NODES * size, -1)
    slopes = np.linalg.solve(system.reshape(j, NODES * size, -1), right).reshape(j, NODES, size, -1)
    grown: np.ndarray = np.tensordot(B, sources + by_core @ np.tensordot(A, slopes, axes=(1, 1)), axes=1)
    return grown
