"""Lyapunov exponents of a run, from its variational equations.

Changes of the start grow on average like e^(lambda t). They are followed along the run, made orthonormal in the
scene's scales again and again, so that none overflows and each column keeps an exponent of its own: Benettin, Galgani,
Giorgilli, Strelcyn, Meccanica 15 (1980) 9; through impacts: Mueller, Chaos, Solitons & Fractals 5 (1995) 1671.

States that nothing depends on, as ledgers, are none of the motion's. Closed loops, quaternions, and rolling leave fewer
changes than states: those tangent to the constraints.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.accuracy.horizon import Growth, growth_law
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.sensitivity.changes_along_run import follow
from hertzwerk.runtime.engine.sensitivity.saltation import watched
from hertzwerk.runtime.engine.sensitivity.step_chain import WIDTH
from hertzwerk.runtime.engine.sensitivity.tangent import ARGUMENTS, Directions, directions_of, rates, tangent
from hertzwerk.runtime.engine.solution.averages import TRANSIENT, Average, estimate
from hertzwerk.runtime.engine.solution.history import History

INTERVALS = 240  # of a run, in which local exponents are taken
FEWEST = 4  # directions at the start: of one alone too little might be along what grows
LINKS = 32  # at most, after which several columns are made orthonormal again: one alone needs it less often
DEPENDENT = 1e-9  # singular values of constraints, of the largest: below they say nothing new


@dataclass(frozen=True)
class Lyapunov:
    """Lyapunov exponents along a run.

    exponents     the largest ones, from the largest down [1/s], each a mean over the run after its transient with a 95 %
                  confidence interval; -inf where changes die out, as by sticking
    local         their values in equal intervals of the run (intervals, exponents) [1/s]: the finite-time spread
    t, growth     times [s] of the run's steps (n,), and the logarithm of the growth since the start (n,) of a small change, its
                  root mean square over all directions, or some
    law           how that grew: exponentially, like a power of time, or not
    dimension     number of exponents that the motion has
    until, reason    time [s] up to which there are derivatives, and why not to the end of the run, else empty
    """

    exponents: tuple[Average, ...]
    local: np.ndarray
    t: np.ndarray
    growth: np.ndarray
    law: Growth
    dimension: int
    until: float
    reason: str

    @property
    def chaotic(self) -> bool:
        """Return whether changes grow exponentially."""
        return self.law.kind == "exponential"

    @property
    def spread(self) -> tuple[float, float]:
        """The least and the largest rate of growth [1/s] in the intervals of `law`."""
        width = self.law.edges[1] - self.law.edges[0]
        rates = [math.log(factor) / width for factor in self.law.factors if factor > 0]
        return (min(rates), max(rates)) if rates else (math.nan, math.nan)

    def horizon(self, error: float, limit: float = VALID) -> float:
        """Return the time [s] in which an error, in the scales, grows to a limit; infinite without chaos."""
        largest = self.exponents[0].mean
        if not self.chaotic or largest is None or largest <= 0:
            return math.inf
        return math.log(limit / error) / largest

    def __str__(self) -> str:
        lines = "\n".join(str(exponent) for exponent in self.exponents)
        return f"{lines}\n{self.reason}, at {self.until:.6g} s" if self.reason else lines


def lyapunov(
    history: History,
    bound: BoundParameters,
    stated: frozenset[str],
    scales: np.ndarray,
    count: int = 1,
    *,
    compiled: bool = False,
) -> Lyapunov:
    """Return the largest exponents of a run with its steps.

    given     names of the states that the run was started with; scales (ny,): of the states
    """
    model = history.model
    of_motion = depended_on(model)
    none = directions_of(model, bound.p, bound.c, np.zeros((len(model.parameters), 1)))
    free = _free(history, none, history.rows[:1], of_motion, scales)
    dimension = free.shape[1]
    if not (isinstance(count, int) and 1 <= count <= min(dimension, WIDTH)):
        expected = f"1 to {min(dimension, WIDTH)}" + ("" if dimension <= WIDTH else f", of the {dimension} there are")
        raise InputError(f"exponents of {model.name}", [Fault("count", repr(count), expected)])
    columns = max(count, min(dimension, FEWEST))
    mixed = free @ np.random.default_rng(0).normal(size=(dimension, columns))
    begin = scales[:, None] * np.linalg.qr(mixed)[0]
    directions = directions_of(model, bound.p, bound.c, np.zeros((len(model.parameters), columns)))
    renewal = _Renewal(history, directions, of_motion, scales, one=count == 1)
    most = int(np.clip(len(history.t) // INTERVALS, 1, LINKS)) if count > 1 else None
    followed = follow(history, directions, begin, stated, compiled=compiled, renew=renewal, most=most)
    known = len(history.t) if not followed.reason else max(int(np.searchsorted(history.t, followed.until)), 1)
    return _of(history.t[:known], renewal, count, dimension, followed.until, followed.reason)


@per_model
def depended_on(model: EngineModel) -> np.ndarray:
    """Return whether each state (ny,) is of the motion: no memory that nothing depends on."""
    arguments = model.symbols(ARGUMENTS)
    parts = ca.vertcat(rates(model)(*arguments), watched(model)(*arguments))
    depends: np.ndarray = np.any(ca.DM(ca.jacobian(parts, arguments[1]).sparsity(), 1.0).full(), axis=0)
    depends[: model.nq + model.nu] = True
    return depends


@per_model
def constrained(model: EngineModel) -> Any:
    """Build the function of what stays zero: constraints, their rates, norms of quaternions less 1."""
    t, y, _, _, c, _ = arguments = model.symbols(ARGUMENTS)
    q, u, _ = model.parts(y)
    residuals = [ca.sumsqr(q[first : first + 4]) - 1 for first in model.quaternions]
    if model.nl:
        residuals += model.function("constraints").call([t, q, u, c])
    return ca.Function("constrained", arguments, [ca.densify(ca.vertcat(ca.SX(0, 1), *residuals))])


def _free(
    history: History, directions: Directions, row: np.ndarray, of_motion: np.ndarray, scales: np.ndarray
) -> np.ndarray:
    """Return an orthonormal basis (ny, dimension) of the scaled changes that constraints leave."""
    model = history.model
    to_state = tangent(constrained, history, row, directions).to_state[0] * scales if _is_constrained(model) else None
    basis = np.eye(len(scales))[:, of_motion]
    if to_state is None:
        return basis
    across = to_state @ basis
    across = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), np.finfo(float).tiny)
    _, values, vectors = np.linalg.svd(across)
    rank = int(np.count_nonzero(values > DEPENDENT * values.max(initial=0.0)))
    free: np.ndarray = basis @ vectors[rank:].T
    return free


def _is_constrained(model: EngineModel) -> bool:
    return bool(model.nl or model.quaternions)


class _Renewal:
    """Columns made orthonormal again, or, where one exponent is requested, small again; and their growth.

    growth (rows,): logarithm of the columns' mean growth; at, logs: rows and logarithms (P,) of each column's own at renewals
    """

    def __init__(
        self, history: History, directions: Directions, of_motion: np.ndarray, scales: np.ndarray, *, one: bool
    ) -> None:
        self._history, self._directions, self._of_motion, self._scales = history, directions, of_motion, scales
        self._one, self._mixed, self._log = one, np.eye(directions.count), 0.0
        self.growth = np.zeros(len(history.rows))
        self.at, self.logs = [0], [np.zeros(directions.count)]

    def __call__(self, rows: np.ndarray, changes: np.ndarray) -> np.ndarray:
        """Take changes (l, P, n) at rows (l,), and return those of the last (P, n), renewed."""
        weights = self._of_motion / self._scales
        (count, _), ny, last = self._mixed.shape, len(weights), changes[-1]
        all_of_start = self._mixed.T @ (changes[:, :, :ny] * weights)  # of the columns that the run began with
        with np.errstate(divide="ignore"):
            sizes = np.log(np.linalg.norm(all_of_start, axis=(1, 2)) / math.sqrt(count))
        self.growth[rows] = self._log + sizes
        if not np.isfinite(last).all():
            return np.asarray(last)
        scaled = (last[:, :ny] * weights).T
        if _is_constrained(self._history.model):
            row = self._history.rows[rows[-1] : rows[-1] + 1]
            free = _free(self._history, self._directions, row, self._of_motion, self._scales)
            scaled = free @ (free.T @ scaled)
        r = np.linalg.norm(scaled) * np.eye(count) if self._one else np.linalg.qr(scaled)[1]
        grown = np.abs(np.diag(r))
        with np.errstate(divide="ignore"):
            self.logs.append(self.logs[-1] + np.log(grown))
        self.at.append(int(rows[-1]))
        r[np.diag_indices_from(r)] = np.where(grown > 0, np.diag(r), 1.0)
        mixed = r @ self._mixed
        size = np.linalg.norm(mixed)
        self._mixed, self._log = mixed / size, self._log + math.log(size)
        return np.linalg.solve(r.T, np.column_stack([scaled.T * self._scales, last[:, ny:]]))


def _of(t: np.ndarray, renewal: _Renewal, count: int, dimension: int, until: float, reason: str) -> Lyapunov:
    """Return exponents from the growth until a time [s], over times t (n,) [s] of the run's steps."""
    growth, logs = renewal.growth[: len(t)], np.array(renewal.logs)
    at = np.minimum(renewal.at, len(t) - 1)
    edges = np.linspace(t[0], until, INTERVALS + 1)
    curves = [growth] if count == 1 else [np.interp(t, t[at], column) for column in logs.T[:count]]
    levels = np.column_stack([np.interp(edges, t, curve) for curve in curves])
    step = (until - t[0]) / INTERVALS
    with np.errstate(invalid="ignore"):
        local = np.where(np.isfinite(levels[1:]), np.diff(levels, axis=0), -np.inf) / step
    settled = local[math.ceil(TRANSIENT * INTERVALS) :]
    return Lyapunov(
        exponents=tuple(_exponent(k + 1, column, step) for k, column in enumerate(settled.T)),
        local=local,
        t=t,
        growth=growth,
        law=growth_law(t, growth),
        dimension=dimension,
        until=until,
        reason=reason,
    )


def _exponent(number: int, local: np.ndarray, step: float) -> Average:
    name = f"lyapunov_exponent_{number}"
    if not np.isfinite(local).all():
        return Average(name, "1/s", -math.inf, None, 0, step, "every such change dies out")
    estimated = estimate(local)
    return Average(
        name,
        "1/s",
        estimated.mean,
        estimated.half_width,
        estimated.blocks,
        estimated.intervals * step,
        estimated.reason,
    )
