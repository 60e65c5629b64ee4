"""Sensitivities of a run: first derivatives of its histories and impacts, through every event.

1. directions   changes of parameters and starts, and of the constants           engine/sensitivity/tangent
2. steps        the variational equations by a method of each step's kind        engine/sensitivity/step_chain
                by collocation where that is too coarse                          engine/sensitivity/transitions
3. events       the jump where modes change                                      engine/sensitivity/saltation
                one after the other                                              engine/sensitivity/changes_along_run
4. histories    by the chain rule from states, memory and directions             engine/sensitivity/readout

They are found after the run, from its steps: a run that is not asked pays nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, refuse, unknown
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.integration.events.effect_events import jump
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator, integrator
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT
from hertzwerk.runtime.engine.integration.tableaux.methods import Table
from hertzwerk.runtime.engine.model.binding import Value, times_within
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.free_quantities import derivative_faults, quantities
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.si_values import ratio
from hertzwerk.runtime.engine.sensitivity.changes_along_run import at_fixed_time, follow
from hertzwerk.runtime.engine.sensitivity.readout import Readout
from hertzwerk.runtime.engine.sensitivity.saltation import watched_columns
from hertzwerk.runtime.engine.sensitivity.step_chain import along, later
from hertzwerk.runtime.engine.sensitivity.tangent import directions_by, tangent, with_shapes
from hertzwerk.runtime.engine.sensitivity.transitions import transitions
from hertzwerk.runtime.engine.solution.contact_watch import goes_on
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.engine.start.start_values import assembled, read_start
from hertzwerk.runtime.system.lazy import cached_property

STEP = 1e-3  # relative, of differences: two of them, extrapolated, are right to about its fourth power

BISECTIONS = 60  # of the step in which a force or penetration is largest
OF_IMPACT = ("t", "speed", "peak_force", "peak_penetration")


def start_changes(
    model: EngineModel, bound: BoundParameters, initial: Mapping[str, Value], names: tuple[str, ...]
) -> np.ndarray:
    """Return the changes (nq + nu, P) of the start with parameters, or initial states of the joints.

    Those of a tree are derivatives of its start; where a start is assembled, with loops to be closed or bodies to be
    seated, or effects have events at it, as the first sample of a controller, they are extrapolated differences of
    starts, right to about 1e-11.
    """
    if model.module.GIVEN is not None or model.joints is not model or model.quaternions or model.ne:
        columns = [_difference(model, bound, initial, name) for name in names]
        return np.stack(columns, axis=1)
    states, parameters = [*model.coordinates, *model.speeds], list(model.parameters)
    (by_parameters,) = _start_by_parameters(model)(bound.p)
    by_parameters = by_parameters.reshape(len(states), len(parameters))
    by_parameters[[states.index(name) for name in initial if name in states]] = 0
    unit = np.eye(len(states))
    return np.stack(
        [
            by_parameters[:, parameters.index(name)] if name in parameters else unit[states.index(name)]
            for name in names
        ],
        axis=1,
    )


@per_model
def _start_by_parameters(model: EngineModel) -> Callers:
    p = ca.SX.sym("p", len(model.parameters))
    start = ca.vertcat(*map(ca.SX, model.module.start(p)))
    return Callers(ca.Function("start_by_p", [p], [ca.densify(ca.jacobian(start, p))]))


def _with_shapes(history: History) -> History:
    """Return the steps with functions that have derivatives by the shapes of curves, if any."""
    model = with_shapes(history.model)
    if model is history.model:
        return history
    engine = _shaped_engine(history.engine.model, history.engine.requested)
    return History(model, history.rows, history.controls, engine, p=history.p, beside=history.beside)


@per_model
def _shaped_engine(model: EngineModel, tables: tuple[Table, ...]) -> Integrator:
    return integrator(with_shapes(model), tables)


@per_model
def _jumped(model: EngineModel) -> Callers:
    return Callers(jump(model))


def _difference(model: EngineModel, bound: BoundParameters, initial: Mapping[str, Value], name: str) -> np.ndarray:
    parameters, joints = list(model.parameters), model.joints
    now = dict(zip(parameters, bound.p, strict=True))
    if name not in now:
        q, u = assembled(model, bound, initial, [])
        now = dict(zip((*joints.coordinates, *joints.speeds), (*q, *u), strict=True))
    value = float(now[name])
    step = STEP * (abs(value) or 1.0)

    def at(change: float) -> np.ndarray:
        moved, values = bound, dict(initial)
        if name in parameters:
            p = bound.p.copy()
            p[parameters.index(name)] += change
            c = model.evaluate("constants", p)[0]
            c[model.nc - model.npieces :] = bound.c[model.nc - model.npieces :]
            moved = replace(bound, p=p, c=c)
        else:
            values[name] = (value + change, joints.units[name])
        faults: list[Fault] = []
        q, u = read_start(model, moved, values, faults)
        refuse(f"start of {model.name} with another {name}", faults)
        if model.ne:
            q = _jumped(model)(0.0, np.concatenate([q, u, np.zeros(model.nz)]), moved.c, np.zeros(model.ne))[0][
                : model.nq
            ]
        return np.concatenate([q, u])

    whole, half = ((at(d) - at(-d)) / (2 * d) for d in (step, step / 2))
    derivative: np.ndarray = (4 * half - whole) / 3
    return derivative


PEAKS = {"peak_force": ("force", 1, "normal_force"), "peak_penetration": ("gap", -1, "penetration")}


class Sensitivities:
    """Derivatives of a run with respect to parameters and initial states, in SI.

    history: that of a run whose steps are kept; initial: states that it was given, beside the scene's
    until    time [s] up to which there are derivatives; reason    why not to the end of the run, else empty
    """

    def __init__(
        self,
        history: History,
        bound: BoundParameters,
        initial: Mapping[str, Value],
        names: tuple[str, ...],
        *,
        compiled: bool = False,
    ) -> None:
        refuse(f"sensitivities of {history.model.name}", derivative_faults(history.model, names))
        self.history, self.names = _with_shapes(history), names
        history, model = self.history, self.history.model
        self._directions = directions_by(model, bound, names)
        begin = start_changes(model, bound, initial, names)
        self._followed = follow(history, self._directions, begin, frozenset(initial), compiled=compiled)
        self.until, self.reason = self._followed.until, self._followed.reason

    def __repr__(self) -> str:
        return f"<Sensitivities {self.history.model.name}: by {', '.join(self.names)}, until {self.until:g} s>"

    # -- what is read ------------------------------------------------------------------------------------------------

    def __getitem__(self, key: tuple[str, str]) -> np.ndarray:
        """Derivative of a history with respect to a name, at the run's steps, shape (rows,), SI.

        nan beyond `until`. Raises KeyError for an unknown history, InputError for a name without derivatives.
        """
        name, to = key if isinstance(key, tuple) and len(key) == 2 else (key, "")
        everywhere = np.arange(len(self.history.rows))
        return self._at(everywhere, np.zeros(len(everywhere)), self.history.known(name))[:, self._column(to)]

    def at(self, times: Value | Sequence[float] | np.ndarray, name: str, to: str) -> np.ndarray:
        """Return the derivative (n,) of a history at one or more times of the run [s].

        At an event it is that just after it. Raises InputError for what is no time of the run.
        """
        t = self.history.t
        return self.along(times_within(times, t[0], t[-1]), name)[:, self._column(to)]

    def along(self, times: np.ndarray, name: str) -> np.ndarray:
        """Return the derivatives (n, P) of a history by all `names`, at times (n,) as `at` has them."""
        t = self.history.t
        index = np.searchsorted(t, times, side="right") - 1
        return self._at(index, times - t[index], self.history.known(name))

    @property
    def events(self) -> tuple[np.ndarray, np.ndarray]:
        """Rows (n,) of the run that follow an event, and the derivatives (n, P) of those events' times.

        nan where sliding in two directions ends.
        """
        determined = slice(self._followed.determined)
        return self._followed.jumps.rows[determined], self._followed.times[determined]

    def after_event(self, row: int, name: str) -> np.ndarray:
        """Return the derivatives (P,) of a history just after the event before a row, whose time changes too."""
        changes: np.ndarray = self._just_after(name, np.array([row]))[0]
        return changes

    @cached_property
    def horizon(self) -> float:
        """Time [s] by which an error as small as the run's tolerance has grown to 1 %; else infinite.

        Of a parameter a relative one, of a state one in its scale.
        """
        history, layout = self.history, self.history.engine.layouts.controls
        n = history.model.nq + history.model.nu
        fixed = at_fixed_time(self._followed.after, self._followed.slopes)
        changes = np.abs(fixed[:, :n]) / history.controls[layout["scale"]][:n, None]
        sizes = changes.max(axis=1, initial=0.0)
        of_states = ~self._directions.dp.any(axis=0)
        sizes *= np.where(of_states, 1 / np.where(of_states & (sizes[0] > 0), sizes[0], 1), self._directions.sizes)
        grown = history.controls[layout["tolerance"]][0] * sizes.max(axis=1)
        over = np.flatnonzero(grown > VALID)
        return float(history.t[over[0]]) if len(over) else np.inf

    def record(self, states: Sequence[str], end: float) -> dict[str, Any]:
        """Return the derivatives of states at the end [s], and of impacts, by each name as plain data, in SI."""
        return {
            name: {
                "final": {state: float(self.at(np.array([end]), state, name)[0]) for state in states},
                "impacts": {quantity: self.impacts(quantity, name).tolist() for quantity in OF_IMPACT},
                "until": self.until,
                "reason": self.reason,
            }
            for name in self.names
        }

    def unit(self, name: str, to: str) -> str:
        """Return the SI unit text of a derivative, such as "N/(m/s)"."""
        return ratio(self.history.units[name], quantities(self.history.model)[to])

    def impacts(self, quantity: str, to: str) -> np.ndarray:
        """Return the derivatives of one number of the impacts, shape (impacts,).

        what    "t", "speed", "peak_force" or "peak_penetration"

        nan for the onset of a contact that the run began with, and beyond `until`.
        """
        return self.along_impacts(quantity)[:, self._column(to)]

    def along_impacts(self, quantity: str) -> np.ndarray:
        """Return the derivatives (impacts, P) of one number of the impacts by all `names`."""
        onsets = []
        for pair, mode in enumerate(self.history.part("mode").T):
            touching = goes_on(mode, False)
            rows = np.flatnonzero(touching & ~np.concatenate([[False], touching[:-1]]))
            onsets += [(int(row), pair) for row in rows]
        of = self._peaks if quantity in PEAKS else self._onset
        return of(quantity, *np.array(sorted(onsets), dtype=int).reshape(-1, 2).T)

    # -- how it is found ---------------------------------------------------------------------------------------------

    def _at(self, index: np.ndarray, h: np.ndarray, name: str) -> np.ndarray:
        """Return the changes (n, P) of a history a time h (n,) [s] after rows `index` (n,), under their modes."""
        history = self.history
        after, ny = self._followed.after[index], history.engine.layouts.state.sizes["y"]
        moves = h > 0
        apart = np.append(self._followed.apart, False)[index] & moves
        after[apart] = along(
            transitions(history, index[apart], h[apart], self._followed.switched, self._directions), after[apart]
        )
        moves &= ~apart
        if moves.any():
            after[moves] = later(
                history, index[moves], h[moves], after[moves], self._directions.dc, self._followed.switched
            )
        rows = history.later(history.rows[index], h)
        slopes = np.where(h[:, None] > 0, history.of(rows).part("dy"), self._followed.slopes[index])
        fixed = at_fixed_time(after, slopes)
        at = tangent(Readout(name), history, rows, self._directions)
        return at.along(fixed[:, :ny], fixed[:, ny:])[:, 0]

    def _onset(self, quantity: str, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        """Return the changes (n, P) of times or approach speeds of onsets before rows of the run."""
        event = self._followed.at_rows[rows]
        speeds = watched_columns(self.history.model)["gap_rate"].start + pairs
        changes = self._followed.times[event] if quantity == "t" else -self._followed.then[event, speeds]
        return np.where(event[:, None] >= 0, changes, np.nan)

    def _peaks(self, quantity: str, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        """Return the changes (n, P) of the largest forces or penetrations of contacts from rows of the run on.

        They are those at its instant: the time of a largest value does not count."""
        history, (part, sign, history_of) = self.history, PEAKS[quantity]
        values, rates = (sign * history.part(kind) for kind in (part, f"{part}_rate"))
        mode, t = history.part("mode"), history.t
        index, end = rows.copy(), np.full(len(rows), len(t) - 1)
        for k, (row, pair) in enumerate(zip(rows, pairs, strict=True)):
            apart = np.flatnonzero(mode[row:, pair] == FLIGHT)
            end[k] = row + apart[0] if len(apart) else end[k]
            top = row + int(np.argmax(values[row : end[k], pair]))
            index[k] = top if rates[top, pair] > 0 else top - 1
        changes = np.empty((len(rows), len(self.names)))
        inside = index >= rows  # else largest at its onset
        low, high = np.zeros(len(rows)), t[np.minimum(index + 1, end)] - t[index]
        place = history.columns(f"{part}_rate").start + pairs
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            rising = sign * history.later(history.rows[index], middle)[np.arange(len(rows)), place] > 0
            low, high = np.where(rising, middle, low), np.where(rising, high, middle)
        for pair in np.unique(pairs):
            name = f"{history.model.pairs[pair]}.{history_of}"
            some = pairs == pair
            changes[some & inside] = self._at(index[some & inside], low[some & inside], name)
            changes[some & ~inside] = self._just_after(name, rows[some & ~inside])
        return changes

    def _just_after(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return the changes (n, P) of a history just after the events before rows, whose times change too."""
        event, ny = self._followed.at_rows[rows], self.history.engine.layouts.state.sizes["y"]
        at = tangent(Readout(name), self.history, self.history.rows[rows], self._directions)
        changes = self._followed.after[rows]
        there = at.along(changes[:, :ny], changes[:, ny:-1])[:, 0] + at.to_time * self._followed.times[event]
        return np.where(event[:, None] >= 0, there, np.nan)

    def _column(self, to: str) -> int:
        if to not in self.names:
            raise InputError("sensitivities", [unknown("parameter or initial state", to, self.names)])
        return self.names.index(to)
