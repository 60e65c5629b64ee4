"""Variational equations over steps of a run: what changes before a step do at its end.

Within a step, under its modes, S' = f_y S + f_m M + f_c dc, linear, with coefficients along the motion that the run
has. It is solved by collocation at Gauss' points (order 12; stable however stiff), on the states that the step's own method
has there. Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, chapters I.14 and II.7.

Beside the onset or the end of a contact coefficients grow like a root of the penetration. Steps that begin or end with an
event are divided into parts that shrink towards it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS, gap_rounding
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.sensitivity.tangent import Directions, rates, tangent
from hertzwerk.runtime.engine.solution.history import History

NODES = 6  # of Gauss: order 12, as coefficients are rougher than the motion
BYTES = 2e7  # of the systems solved at once
GROWTH = 4.0  # most by which the distance from an event grows within a part of a step in contact
HEAD = 1e4  # roundings of the gap: beside a surface, coefficients within so much of it are their powers of time
LEAST = 1e-3  # of a time beside an event: its first part
POWERS = (-0.99, 4.0)  # within which


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
    parts = [*_parts(history, index, h, switched)]
    of = np.repeat(np.arange(len(index)), [len(part) for part in parts])
    places, row = np.concatenate([np.zeros((0, len(_COLUMNS))), *parts]), index[of]
    ny = history.engine.layouts.state.sizes["y"]
    n, block = ny + history.model.nm, max(int(BYTES / (8 * (ny * NODES) ** 2)), 1)
    maps = np.zeros((len(index), n, n + directions.count))
    maps[:, np.arange(n), np.arange(n)] = 1
    for first in range(0, len(row), block):
        some = slice(first, first + block)
        for k, grown in zip(of[some], _over(history, history.rows[row[some]], places[some], directions), strict=True):
            maps[k, :ny] += grown[:, :n] @ maps[k]
            maps[k, :ny, n:] += grown[:, n:]
    return maps


_COLUMNS = ("begin", "end", "event", "head")


def _parts(history: History, index: np.ndarray, h: np.ndarray, switched: np.ndarray) -> Iterator[np.ndarray]:
    """Yield the parts (n, 4) of each time after a row [s], by `_COLUMNS`.

    They are begin, end, and of a head its event's time and its length.

    A head lies beside an event at a surface, on either side; elsewhere its length is 0.
    """
    t, events = history.t, np.flatnonzero(switched)
    heads = np.append(_heads(history, events), 0.0)
    touches = (history.part("mode") == CONTACT).any(axis=1)
    place = np.searchsorted(events, index, side="right") - 1
    since = t[index] - t[events[place]]
    until = np.append(t[events], np.inf)[place + 1] - t[index]
    for row, time, before, after, first, last in zip(
        index, h, since, until, heads[place], heads[place + 1], strict=True
    ):
        if not touches[row] or time <= 0:
            yield np.array([[0.0, time, 0.0, 0.0]])
            continue
        cuts = [d - before for d in _distances(before, before + time, first)]
        cuts += [after - d for d in _distances(after - time, after, last)]
        ends = np.array([0.0, *sorted(cut for cut in cuts if 0 < cut < time), time])
        begin, end = ends[:-1], ends[1:]
        near, far = before + end <= first * (1 + EPS), after - begin <= last * (1 + EPS)
        event = np.where(near, -before, after if np.isfinite(after) else 0.0)
        yield np.column_stack([begin, end, event, np.where(near, first, np.where(far, -last, 0.0))])


def _distances(least: float, most: float, head: float) -> np.ndarray:
    """Return distances from an event that divide what lies between two of them in parts that grow with it."""
    first = max(least, head, LEAST * most)
    if first >= most or not np.isfinite(most):
        return np.zeros(0)
    count = int(np.ceil(np.log(most / first) / np.log(GROWTH)))
    return most * (first / most) ** (np.arange(count, 0, -1) / count)


def _heads(history: History, events: np.ndarray) -> np.ndarray:
    """Return the times [s] beside events (n,) in which the gaps of their pairs are little but rounding."""
    model = history.model
    if not model.k:
        return np.zeros(len(events))
    rows = history.of(history.rows[events])
    q, u, _ = np.split(rows.part("y"), [model.nq, model.nq + model.nu], axis=1)
    bound, mode = _rounding(model)(history.controls[: model.nc], rows.part("t"), q, u)[0], history.part("mode")
    changed = np.concatenate([mode[:1] == CONTACT, mode[1:] != mode[:-1]])[events]
    gap, rate = np.abs(rows.part("gap")), np.abs(rows.part("gap_rate"))
    wide = HEAD * bound
    heads: np.ndarray = np.where(changed & (gap < wide) & (rate > 0), wide / np.where(rate > 0, rate, 1), 0).max(axis=1)
    return heads


@per_model
def _rounding(model: EngineModel) -> Rowwise:
    return Rowwise(gap_rounding(model), constant=3)


def _over(history: History, rows: np.ndarray, places: np.ndarray, directions: Directions) -> np.ndarray:
    """Return the growth (n, ny, ny + nm + P) of the state's changes over parts (n, 4) after rows.

    By the changes of state and memory before it, and by directions.
    """
    head = places[:, _COLUMNS.index("head")] != 0
    widths = history.engine.layouts.state.sizes["y"], history.model.nm, directions.count
    growth = np.empty((len(rows), widths[0], sum(widths)))
    for some, over in ((~head, _collocated), (head, _by_powers)):
        if some.any():
            growth[some] = over(history, rows[some], places[some], directions)
    return growth


def _sources(history: History, rows: np.ndarray, directions: Directions) -> np.ndarray:
    """Return the rates of the changes (n, ny, ny + nm + P) by state, memory and directions."""
    derivative = tangent(rates, history, rows, directions)
    return np.concatenate([derivative.to_state, derivative.to_memory, derivative.by_constants], axis=2)


def _collocated(history: History, rows: np.ndarray, places: np.ndarray, directions: Directions) -> np.ndarray:
    n, ny = len(rows), history.engine.layouts.state.sizes["y"]
    begin, end, *_ = places.T
    h = end - begin
    inside = np.concatenate([history.later(rows, begin + node * h) for node in C])  # by nodes, then rows
    sources = h[:, None, None] * _sources(history, inside, directions).reshape(NODES, n, ny, -1)
    core = np.flatnonzero((sources[:, :, :, :ny] != 0).any(axis=(0, 1, 2)))  # states that rates depend on: no ledger
    size, by_core = len(core), sources[:, :, :, core]
    system = np.zeros((n, NODES, size, NODES, size))
    for i in range(NODES):
        for j in range(NODES):
            system[:, i, :, j, :] = (i == j) * np.eye(size) - A[i, j] * by_core[i][:, core]
    right = sources[:, :, core].swapaxes(0, 1).reshape(n, NODES * size, -1)
    slopes = np.linalg.solve(system.reshape(n, NODES * size, -1), right).reshape(n, NODES, size, -1)
    return np.tensordot(B, sources + by_core @ np.tensordot(A, slopes, axes=(1, 1)), axes=1)


def _by_powers(history: History, rows: np.ndarray, places: np.ndarray, directions: Directions) -> np.ndarray:
    """Return the changes over heads: each rate a power of the distance from the event.

    To first order in them, as they are short."""
    begin, end, event, head = places.T
    length = np.abs(head)
    whole, half = (_sources(history, history.later(rows, event + part * head), directions) for part in (1.0, 0.5))
    alike = (whole * half > 0) & np.isfinite(whole) & np.isfinite(half)
    power = np.clip(np.log2(np.where(alike, whole / np.where(alike, half, 1), 1)), *POWERS)
    near, far = (np.abs(time - event) / length for time in (begin, end))
    low, high = (np.minimum(near, far)[:, None, None], np.maximum(near, far)[:, None, None])
    grown: np.ndarray = whole * length[:, None, None] * (high ** (1 + power) - low ** (1 + power)) / (1 + power)
    return grown
