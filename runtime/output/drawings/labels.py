"""Placement of names beside their parts: candidate places are weighed by the ink beneath them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.textpath import TextPath

from hertzwerk.runtime.output.drawings.drawing_primitives import Paper
from hertzwerk.runtime.output.plots.plot_style import GREY
from hertzwerk.runtime.system.arrays import Array

RINGS = (9.0, 14.0, 20.0, 28.0, 38.0, 50.0, 66.0)  # distances of a name from its part, points
WAYS = 16  # directions
LEADER = 24.0  # points: distance from which a line leads to the name
INK, LIGHT, NAME, EDGE, FAR = (
    1.0,
    0.35,
    60.0,
    400.0,
    0.12,
)  # cost of ink, of a ghost's, of another name, of leaving the frame, of a point of distance
LATER = 1.5  # cost of an anchor that is not the first


Frame = tuple[float, float, float, float]
"""Left, right, bottom, top."""


@dataclass(frozen=True)
class Label:
    """A name, its colour and size, and the points (n, 2) it may stand beside."""

    text: str
    anchors: Array
    colour: str
    size: float = 9.0


def place(paper: Paper, labels: Sequence[Label], frame: Frame, point: float) -> None:
    """Write the names; `point` is a point of their size in the units of the axis."""
    ink = [_by_x(np.concatenate([np.zeros((0, 2)), *points])) for points in (paper.ink, paper.light)]
    taken = np.zeros((0, 2, 2))
    for label in labels:
        half = point * _half(label)
        centres, cost = _candidates(label.anchors, half, paper.point)
        low, high = centres - half, centres + half
        for points, price in zip(ink, (INK, LIGHT), strict=True):
            cost += price * _inside(points, low - paper.point, high + paper.point)
        cost += NAME * np.sum(np.all((low[:, None] < taken[:, 1]) & (high[:, None] > taken[:, 0]), axis=-1), axis=1)
        cost += EDGE * np.any((low < frame[::2]) | (high > frame[1::2]), axis=1)
        best = int(np.argmin(cost))
        taken = np.concatenate([taken, [[low[best], high[best]]]])
        anchor = label.anchors[best // (len(RINGS) * WAYS)]
        _lead(paper, centres[best], anchor, half)
        paper.text(centres[best], label.text, label.colour, label.size, gid="name")


def _half(label: Label) -> Array:
    """Return half the size of a name with a margin [points]."""
    path = TextPath((0, 0), label.text, size=label.size)
    x = path.vertices[path.codes != path.CLOSEPOLY, 0]  # with the points that bend its curves: wider by no pixel
    return np.array([np.ptp(x) / 2 + 1.5, label.size * 0.55 + 0.5])


def _candidates(anchors: Array, half: Array, point: float) -> tuple[Array, Array]:
    """Return centres (k, 2) around the anchors, in every direction and distance, and their costs (k,)."""
    angles = 2 * np.pi * np.arange(WAYS) / WAYS
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    edge = np.min(half / np.maximum(np.abs(ways), 1e-9), axis=1)  # of the box, from its centre
    away = np.array(RINGS)[:, None] * point + edge  # (rings, ways)
    centres = anchors[:, None, None] + away[..., None] * ways
    price = FAR * np.array(RINGS)[:, None] + LATER * (np.arange(len(anchors)) > 0)[:, None, None]
    return centres.reshape(-1, 2), np.array(np.broadcast_to(price, centres.shape[:-1])).ravel()


def _by_x(points: Array) -> Array:
    """Return points (n, 2) in the order of x, as columns (2, n)."""
    return points[np.argsort(points[:, 0])].T


def _inside(points: Array, low: Array, high: Array) -> Array:
    """Count the points (2, n), in the order of x, in each of the boxes (k, 2)."""
    x, y = points
    begins, ends = np.searchsorted(x, low[:, 0], side="right"), np.searchsorted(x, high[:, 0])
    boxes = zip(begins, ends, low[:, 1], high[:, 1], strict=True)
    return np.array([np.count_nonzero((y[i:j] > bottom) & (y[i:j] < top)) for i, j, bottom, top in boxes], dtype=float)


def _lead(paper: Paper, centre: Array, anchor: Array, half: Array) -> None:
    """Draw a line from a name to its part, where that is not near."""
    way = anchor - centre
    length = float(np.linalg.norm(way))
    edge = float(np.min(half / np.maximum(np.abs(way) / length, 1e-9)))
    if length - edge > LEADER * paper.point:
        paper.line(np.array([centre + edge * way / length, anchor]), GREY, 0.5, 8.5)
