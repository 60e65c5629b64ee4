"""Pictures of statics: a mechanism at rest, and the shapes of its small vibrations."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.start.assembly import closed_near
from hertzwerk.runtime.output.drawings import picture
from hertzwerk.runtime.output.drawings.gallery import sheet
from hertzwerk.runtime.output.drawings.places import GROUND, Places
from hertzwerk.runtime.system.arrays import Array

LARGE, TURNED = 0.14, 0.4  # largest displacement drawn, of the size of the mechanism; largest change of a direction
PHASES = 24  # positions of a period, whose paths are drawn
TRIAL = 1e-6  # amplitude by which the size of a shape is measured
COLUMNS = 3


def at_rest(
    model: EngineModel, bound: BoundParameters, t: float, q: Array, caption: str, notes: Sequence[str]
) -> Figure:
    """Draw a mechanism at coordinates q (nq,) and the time t [s] of its drives."""
    return picture.figure(Places.at(model, bound, t, q[None]), notes, caption=caption)


def of_shapes(model: EngineModel, bound: BoundParameters, t: float, q: Array, shapes: Mapping[str, Array]) -> Figure:
    """Draw a cell for each complex shape (nq,), by title: at rest in q (nq,), faint its extreme positions."""
    cells = [_Vibration(model, bound, t, q).places(shape) for shape in shapes.values()]
    return sheet(cells, list(shapes), faint=(PHASES // 4, 3 * PHASES // 4), columns=COLUMNS)


@dataclass(frozen=True)
class _Vibration:
    """Vibrations of a mechanism about q (nq,)."""

    model: EngineModel
    bound: BoundParameters
    t: float
    q: Array

    def places(self, shape: Array) -> Places:
        """Return the mechanism at rest and through one period, as large as a picture needs."""
        turn = shape[int(np.argmax(np.abs(shape)))]
        shape = shape * np.conj(turn) / abs(turn)
        angles = 2 * math.pi * np.arange(1, PHASES) / PHASES
        ways = np.outer(np.sin(angles), shape.real) + np.outer(np.cos(angles), shape.imag)
        return self._at([np.zeros(len(shape)), *(self._amplitude(shape.real) * ways)])

    def _amplitude(self, way: Array) -> float:
        """Return the factor that makes a deviation as large as a picture needs."""
        places = self._at([np.zeros(len(way)), TRIAL * way])
        points = np.array([places.point(mark) for mark in places.landmarks])
        moves = np.array([mark.body != GROUND for mark in places.landmarks])
        size = max(float(np.max(np.ptp(points[:, 0], axis=0))), _largest(places)) or 1.0
        moved = float(np.max(np.linalg.norm(points[moves, 1] - points[moves, 0], axis=1), initial=0.0))
        turned = float(np.max(np.abs(places.rotations[1] - places.rotations[0])))
        return TRIAL * min(LARGE * size / max(moved, 1e-300), TURNED / max(turned, 1e-300))

    def _at(self, deviations: Sequence[Array]) -> Places:
        """Return the places after deviations, with quaternions of norm 1 and loops closed."""
        positions = []
        for deviation in deviations:
            q = self.q + deviation
            for i in self.model.quaternions:
                q[i : i + 4] /= np.linalg.norm(q[i : i + 4])
            positions.append(closed_near(self.model, self.bound, q, self.t) if np.any(deviation) else self.q)
        return replace(Places.at(self.model, self.bound, self.t, np.array(positions)), enlarged=False)


def _largest(places: Places) -> float:
    """Return the largest radius or length among the landmarks [m]; 0 where there is none."""
    named = (mark.beside.items() for mark in places.landmarks)
    return max((float(value[0]) for each in named for name, value in each if name in ("radius", "length")), default=0.0)
