"""Sums over equal time intervals, for averages: impulses, largest forces, the energy ledger."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Self

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.events.cubics import crest_of_cubic
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.engine.solution.history import History


NODES = ((1 - 5**-0.5) / 2, (1 + 5**-0.5) / 2)  # of Lobatto's rule, with the ends of the step
BESIDE = 1e-4  # of a step, from its end: there the contact certainly lasts
ROWS = 4096  # processed at once
BENT = 3e-3  # of a mean force: difference of parabola and chord beyond which a cubic is not used


@dataclass(frozen=True)
class Sums:
    """Sums over n whole intervals from the start, of k pairs and nz states of memory.

    interval  length of an interval [s]
    impulse   normal force, integrated over each interval (n, k) [N s]
    largest   largest normal force in each interval (n, k) [N]
    memory    states of memory where intervals begin and end (n + 1, nz)
    """

    interval: float
    impulse: np.ndarray
    largest: np.ndarray
    memory: np.ndarray

    @property
    def count(self) -> int:
        """Number of intervals."""
        return len(self.impulse)

    @property
    def mean_force(self) -> np.ndarray:
        """Mean normal force in each interval (n, k) [N]."""
        return self.impulse / self.interval

    @property
    def power(self) -> np.ndarray:
        """Mean rate of each state of memory in each interval (n, nz)."""
        return np.diff(self.memory, axis=0) / self.interval

    def joined(self, many: int) -> Sums:
        """Join `many` intervals to one, from the start on."""
        n = self.count // many
        impulse, largest = (x[: n * many].reshape(n, many, x.shape[1]) for x in (self.impulse, self.largest))
        memory = self.memory[: n * many + 1 : many]
        return Sums(self.interval * many, impulse.sum(axis=1), largest.max(axis=1), memory)

    def about(self) -> dict[str, Any]:
        """All fields as plain numbers, to be saved."""
        return {name: x.tolist() if isinstance(x, np.ndarray) else x for name, x in asdict(self).items()}

    @classmethod
    def saved(cls, about: Mapping[str, Any], model: EngineModel) -> Self:
        """Restore the sums of a saved run."""
        widths = {"impulse": model.k, "largest": model.k, "memory": model.nz}
        tables = {name: np.array(about[name]).reshape(len(about[name]), width) for name, width in widths.items()}
        return cls(interval=about["interval"], **tables)


class Summing:
    """Observer that sums over intervals [s] between two times [s].

    Within most steps a force is the cubic that its values and rates at both ends give, which costs no evaluation;
    where that is curved, it is evaluated at two points between them.
    """

    def __init__(self, model: EngineModel, interval: float, until: float, begin: float = 0.0) -> None:
        count = int((until - begin) / interval * (1 + 1e-12))
        self._model, self._interval, self._marks = model, interval, begin + interval * np.arange(count + 1)
        self._impulse, self._largest = np.zeros((count + 1, model.k)), np.zeros((count + 1, model.k))
        self._memory: list[np.ndarray] = []
        self._known = 0  # marks
        self._last: History

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._last = block.of(block.rows[-1:].copy())
        for first in range(max(fresh - 1, 0), max(len(block.t) - 1, 1), ROWS):  # copies of rows fit into a cache
            self._take(block, block.rows[first : first + ROWS + 1])

    def _take(self, block: History, rows: np.ndarray) -> None:
        """Sum over the steps between some rows of a block."""
        t = block.of(rows).t
        stop = int(np.searchsorted(self._marks, t[-1]))  # at the last row an event may change the state yet
        marked = np.zeros(len(t), dtype=bool)
        if stop > self._known:
            marks = self._marks[self._known : stop]
            places = np.searchsorted(t, marks, side="right")
            within = block.at(marks).rows
            self._memory.append(self._memory_of(block.of(within)))
            rows, marked = np.insert(rows, places, within, axis=0), np.insert(marked, places, True)
        if self._model.k and len(rows) > 1:
            interval = self._known - 1 + np.cumsum(marked)[:-1]
            with np.errstate(all="ignore"):  # a run without a good end may hold what is no number
                impulse, largest = _forces(block.of(rows))
                np.add.at(self._impulse, interval, impulse)
                np.maximum.at(self._largest, interval, largest)
        self._known = stop

    def _memory_of(self, history: History) -> np.ndarray:
        y = history.part("y")
        return y[:, y.shape[1] - self._model.nz :].copy()

    @property
    def sums(self) -> Sums:
        """Sums over the intervals that the run completed."""
        memory, count = self._memory, self._known - 1
        arrived = self._known < len(self._marks) and self._last.t[0] >= self._marks[self._known] * (1 - 1e-12)
        if arrived:
            memory, count = [*memory, self._memory_of(self._last)], count + 1
        if count < 1:
            k, nz = self._model.k, self._model.nz
            return Sums(self._interval, np.zeros((0, k)), np.zeros((0, k)), np.zeros((1, nz)))
        return Sums(self._interval, self._impulse[:count], self._largest[:count], np.concatenate(memory))


def _forces(history: History) -> tuple[np.ndarray, np.ndarray]:
    """Return impulse [N s] and largest force [N] of every pair from each row to the next, (rows - 1, k)."""
    rows, h = history.rows, np.diff(history.t)[:, None]
    mode = history.part("mode")
    touching = mode[:-1] == CONTACT
    ends = rows[1:]
    cut = np.flatnonzero(np.any(touching & (mode[:-1] != mode[1:]), axis=1) & (h[:, 0] > 0))  # the step ended otherwise
    if len(cut):
        ends = ends.copy()
        ends[cut] = history.later(rows[cut], h[cut, 0])
    start, end = history.of(rows[:-1]), history.of(ends)
    f0, f1 = (np.where(touching, side.part("force"), 0) for side in (start, end))
    g0, g1 = (np.where(touching, h * side.part("force_rate"), 0) for side in (start, end))
    chords, bend = (f0 + f1) / 2, (g0 - g1) / 12
    mean, largest = chords + bend, np.maximum(np.maximum(f0, f1), _between(f0, f1, g0, g1))
    # where a gap is not below zero neither rate nor force is known: the force may jump there
    known = np.array([start.part("gap") < 0, end.part("gap") < 0])
    curved = touching & (h > 0) & (~known.all(axis=0) | (np.abs(bend) > BENT * np.abs(chords)))
    for j in np.flatnonzero(np.any(curved, axis=0)).tolist():
        here, sides = curved[:, j], known[:, curved[:, j], j]
        inner = _inner_forces(start.of(start.rows[here]), end.of(end.rows[here]), h[here], j).T
        inner = np.where(np.isfinite(inner), inner, mean[here, j])
        values = np.where(sides, (f0[here, j], f1[here, j]), inner[[0, 3]])
        slopes = np.where(sides, (g0[here, j], g1[here, j]), np.nan)
        mean[here, j] = (values.sum(axis=0) + 5 * inner[1:3].sum(axis=0)) / 12
        peak = np.fmax(inner[1:3].max(axis=0), _peak(*values, *slopes, *inner[1:3]))
        largest[here, j] = np.maximum(values.max(axis=0), peak)
    return h * mean, largest


def _between(f0: np.ndarray, f1: np.ndarray, g0: np.ndarray, g1: np.ndarray) -> np.ndarray:
    """Return the maximum inside 0..1 of a cubic, by values and slopes at its ends; f0 if there is none."""
    return np.where((g0 > 0) & (g1 < 0), crest_of_cubic(np, f0, f1, g0, g1)[1], f0)


def _peak(*values: np.ndarray) -> np.ndarray:
    """Return the peak of the quintic by values and slopes at both ends and values at NODES; NaN if none."""
    peaks, (x, *_) = (values[2] > 0) & (values[3] < 0), crest_of_cubic(np, *values[:4])
    coefficients = np.linalg.solve(_SEXTUPLE, np.array(values))  # (6, n), of rising powers
    slope, bend = (np.polynomial.polynomial.polyder(coefficients, m) for m in (1, 2))
    for _ in range(3):
        value, rate = (np.polynomial.polynomial.polyval(x, c, tensor=False) for c in (slope, bend))
        x = np.clip(x - np.divide(value, rate, out=np.zeros_like(x), where=rate < 0), 0, 1)
    return np.where(peaks, np.polynomial.polynomial.polyval(x, coefficients, tensor=False), np.nan)


def _inner_forces(start: History, end: History, h: np.ndarray, j: int) -> np.ndarray:
    """Return a pair's normal forces at NODES of steps h (n, 1) [s] and beside their ends, shape (n, 4)."""
    model = start.model
    parts = [side.part(part) for side in (start, end) for part in ("t", "y", "dy")]
    return inner(model, j)(start.controls[: model.nc], *parts[:3], *parts[4:], start.part("m"), h)[0]


@per_model
def inner(model: EngineModel, j: int) -> Rowwise:
    """Build the function (c, t, y, dy, y1, dy1, m, h) -> normal forces at NODES and beside the ends.

    Coordinates are interpolated by quintics, other states by cubics.
    """
    c, m, t, h = ca.SX.sym("c", model.nc), ca.SX.sym("m", model.nm), ca.SX.sym("t"), ca.SX.sym("h")
    nq, nu = model.nq, model.nu
    ny = nq + nu + model.nz
    y0, d0, y1, d1 = (ca.SX.sym(name, ny) for name in ("y", "dy", "y1", "dy1"))
    forces = []
    for x in (BESIDE, *NODES, 1 - BESIDE):
        q = _blend(
            _QUINTIC,
            x,
            h,
            *((y[:nq], d[:nq], _second(model, s, y, d, c)) for s, y, d in ((t, y0, d0), (t + h, y1, d1))),
        )
        for row, _ in model.worn:  # by forces, which give no second derivative
            q[row] = _blend(_CUBIC, x, h, (y0[row], d0[row]), (y1[row], d1[row]))
        others = _blend(_CUBIC, x, h, (y0[nq:], d0[nq:]), (y1[nq:], d1[nq:]))
        contact = model.function(f"contact_{model.pairs[j]}")
        forces.append(contact(t + x * h, q, others[:nu], others[nu:], m, c)[2])
    return Rowwise(ca.Function("inner", [c, t, y0, d0, y1, d1, m, h], [ca.cse(ca.vertcat(*forces))]), constant=0)


def _second(model: EngineModel, t: Any, y: Any, dy: Any, c: Any) -> Any:
    """Return the second derivatives of the coordinates."""
    nq, nu = model.nq, model.nu
    at = [ca.SX.sym(name, size) for name, size in (("t", 1), ("q", nq), ("u", nu))]
    rates = model.function("coordinate_rates")(*at, c)
    along = ca.vertcat(1, dy[: nq + nu])
    second = ca.Function("second", [*at, c, dy], [ca.jtimes(rates, ca.vertcat(*at), along)])
    return second(t, y[:nq], y[nq : nq + nu], c, dy)


def _blend(basis: np.ndarray, x: float, h: Any, start: tuple[Any, ...], end: tuple[Any, ...]) -> Any:
    """Return Hermite's interpolant at x in 0..1 of a step h, from values and derivatives at its ends."""
    n = len(start)
    weights = np.polynomial.polynomial.polyval(x, basis)
    return sum(weights[i] * h ** (i % n) * value for i, value in enumerate((*start, *end)))


def _hermite(order: int) -> np.ndarray:
    """Return the coefficients (order + 1, order + 1) of Hermite's basis polynomials on 0..1.

    Rising powers, a column each; each has one value or derivative 1 at an end and the others 0: those at 0 first.
    """
    n = (order + 1) // 2
    powers = np.eye(order + 1)
    conditions = [
        [np.polynomial.polynomial.polyval(end, np.polynomial.polynomial.polyder(power, m)) for power in powers]
        for end in (0, 1)
        for m in range(n)
    ]
    return np.linalg.inv(np.array(conditions))


_CUBIC, _QUINTIC = _hermite(3), _hermite(5)
_SEXTUPLE = np.array(
    [[x**k for k in range(6)] for x in (0, 1)]
    + [[k * x ** max(k - 1, 0) for k in range(6)] for x in (0, 1)]
    + [[x**k for k in range(6)] for x in NODES]
)
