"""Condensed Gauss-Newton steps: starts are eliminated from the last on by orthogonal factors.

That stays sound where products of transition matrices overflow (Bock, Bonner Math. Schriften 183, 1987).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.fitting.shooting.segments import Block, Segment

Array = NDArray[np.float64]


def condensed(segments: Sequence[Segment], blocks: Sequence[Block], scale: Array) -> tuple[list[Array | None], Array]:
    """Return the factor of every start, (start, start before, x, right side), and rows (m, k + 1) of x.

    scale    of starts (n,)
    """
    n, k = len(scale), blocks[0].by_x.shape[1]
    factors: list[Array | None] = []
    rest = np.zeros((0, k + 1))
    carry = np.zeros((0, n + k + 1))  # of (start, x, right side), from the segments after
    for j in reversed(range(len(segments))):
        segment, block = segments[j], blocks[j]
        if segment.start is None:
            rest = np.vstack([rest, np.hstack([block.by_x, -block.residual[:, None]]), carry[:, n:]])
            carry = np.zeros((0, n + k + 1))
            factors.append(None)
            continue
        before, weights = blocks[j - 1], 1 / segments[j - 1].allowed[:, None]
        first = segments[j - 1].start is None
        to_before = np.zeros((n, n)) if first else before.end_by_start * scale
        own = np.hstack([block.by_start * scale, block.by_x, -block.residual[:, None]])
        inner = np.vstack([carry, own])
        inner = np.hstack([inner[:, :n], np.zeros((len(inner), n)), inner[:, n:]])
        miss = (before.end - segment.start)[:, None]
        joint = weights * np.hstack([-np.diag(scale), to_before, before.end_by_x, -miss])
        r: Array = np.asarray(np.linalg.qr(np.vstack([joint, inner]), mode="r"))
        factors.append(r[:n])
        carry = r[n:, n:]
    return factors[::-1], rest


def step(
    factors: Sequence[Array | None],
    rows: Array,
    n: int,
    *,
    held: int | None = None,
    by: float = 0.0,
    share: float = 1.0,
) -> tuple[Array, float]:
    """Return the changes of x (first row) and of all starts (n,) over scales, and how far squares fall.

    held     place in x that changes by a given amount; squares fall by the square of what is returned
    share    of the change of x that is taken, which the starts follow
    """
    k = rows.shape[1] - 1
    moving, dx = np.array([j != held for j in range(k)]), np.full(k, by)
    if np.any(moving):
        rest = rows[:, k] - by * (rows[:, :k] @ ~moving)
        dx[moving] = np.linalg.lstsq(rows[:, :k][:, moving], rest, rcond=1e-12)[0]
    fall = [
        float(np.linalg.norm(rows[:, :k] @ dx)),
        *(float(np.linalg.norm(f[:, -1])) for f in factors if f is not None),
    ]
    dx *= share
    changes = np.zeros((1 + len(factors), max(n, k)))
    changes[0, :k] = dx
    for j, factor in enumerate(factors):
        if factor is not None:
            right = factor[:, -1] - factor[:, n : 2 * n] @ changes[j, :n] * (j > 0 and factors[j - 1] is not None)
            changes[1 + j, :n] = np.linalg.solve(factor[:, :n], right - factor[:, 2 * n : -1] @ dx)
    return changes, math.hypot(*fall)
