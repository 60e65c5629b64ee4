"""SUNDIALS' CVODES and IDAS (through CasADi) as an independent reference: BDF of variable order.

Run from Python, window by window; a window stops at the first event, located to rounding by integrating anew from the
grid point before it. Mode changes are taken without the engine's tolerances. Shared with the engine are only the
right-hand side, the initial state, the layout of the rows and the resolution of stick and slip. Hindmarsh et al., ACM
Trans. Math. Softw. 31 (2005) 363.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from scipy.optimize import brentq

from hertzwerk.runtime.engine.integration.events.effect_events import jump
from hertzwerk.runtime.engine.integration.events.event_location import ends_with_force, rubs_till_it_pulls
from hertzwerk.runtime.engine.integration.events.stick_and_slip import resolve_slips
from hertzwerk.runtime.engine.integration.loop.chunk import EXCEPTION, INTERRUPTED, WALL_TIME_LIMIT, Ending
from hertzwerk.runtime.engine.integration.loop.tally import Tally, tally
from hertzwerk.runtime.engine.integration.step.explicit_step import written_flow
from hertzwerk.runtime.engine.integration.step.layout import (
    CONTACT,
    END_PARTS,
    EVENT_LIMIT,
    FINISHED,
    FLIGHT,
    NOT_FINITE,
    OUTSIDE_LAW_RANGE,
    RELEASED,
    RUNNING,
    TOO_MANY_STEPS,
    Layouts,
)
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS
from hertzwerk.runtime.engine.integration.step.set_valued_friction import NO_PAIR, pairs_of, sticking
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.signal import Schedule
from hertzwerk.runtime.system.interrupt import defer_interrupts

GRID = 16  # points of a window
FIRST_WINDOW = 0.5  # after an event, of length/speed of the scene
WINDOWS = 20  # least number in a run
SHORTEST = 1e-9  # of the first window: a shorter one means failure
MAX_STEPS = 1_000_000  # inside SUNDIALS, per window
GRIP, EFFECT, KINK = 3.0, 4.0, 5.0  # beside the modes of a pair, see _Event
DUE = 1e-9  # margin of an event of an effect, beside its size, up to which it has been reached
BREAKS_LOOSE = -1e300  # N: holding force of a pair that breaks loose
AT_REST = 1e-9  # m/s: largest sliding velocity that counts as rest at an event
RELATIVE = 1e-14  # the absolute tolerance, in the scene's scales, is the one asked for


@dataclass(frozen=True)
class Reference:
    """CasADi integrators of a model over one window, and its end quantities.

    window: tolerance -> integrators to all points of the window and to its end.
    """

    model: EngineModel
    layouts: Layouts
    window: Callable[[float], tuple[Any, Any]]
    ends: Any
    resolve_slips: Any  # see `stick_and_slip.resolve_slips`; None without set-valued friction
    tally: Tally


def reference(model: EngineModel, layouts: Layouts, method: str) -> Reference:
    """Build the integrators of a model with "cvodes" or "idas"."""
    right = written_flow(model)
    sizes = {"t": 1, "h": 1, "mode": model.k, "m": model.nm, "c": model.nc, "scale": layouts.trial.sizes["y"]}
    p = {name: ca.SX.sym(name, size) for name, size in sizes.items()}
    s, x = ca.SX.sym("s"), ca.SX.sym("x", sizes["scale"])
    dy = right.rates(p["t"] + s * p["h"], x * p["scale"], p["mode"], p["m"], p["c"])
    problem = {"x": x, "t": s, "p": ca.vertcat(*p.values()), "ode": p["h"] * dy / p["scale"]}
    options = {"reltol": RELATIVE, "max_num_steps": MAX_STEPS, "show_eval_warnings": False}
    points = [i / GRID for i in range(1, GRID + 1)]

    def window(tolerance: float) -> tuple[Any, Any]:
        settings = {**options, "abstol": tolerance}
        many, one = (ca.integrator("window", method, problem, 0, grid, settings) for grid in (points, [1.0]))
        return many, one

    return Reference(model, layouts, window, right.ends, resolve_slips(model) if model.ns else None, tally(model))


def march(
    functions: Reference,
    state: np.ndarray,
    controls: np.ndarray,
    keep: Callable[[np.ndarray], object],
    *,
    deadline: float = np.inf,
    progress: Callable[[float], object] | None = None,
    schedule: Schedule | None = None,
) -> Ending:
    """Integrate from an initial state of the engine to the end of the run, as `chunk.march` does.

    An exception or KeyboardInterrupt ends the run with the rows kept so far.
    """
    run = _Run(functions, state, controls, schedule)
    start, status = time.perf_counter(), RUNNING
    row, error = state, None
    (tallied,) = functions.tally.first(state, controls)
    add = Callers(functions.tally.add)
    try:
        with defer_interrupts() as interrupts:
            keep(row[None, :])
            for row in run.rows():
                keep(row[None, :])
                (tallied,) = add(tallied, row, controls)
                interrupts()
                if progress is not None:
                    progress(run.t / run.t_end)
                if time.perf_counter() > deadline:
                    status = WALL_TIME_LIMIT
                    break
            else:
                status = run.status
    except KeyboardInterrupt:
        status = INTERRUPTED
    except Exception as raised:
        status, error = EXCEPTION, raised
    return Ending(row, tallied, status, time.perf_counter() - start, error=error)


@dataclass(frozen=True)
class _Event:
    """Mode change of a pair, or event of an effect, that ends a window.

    It lies after grid point `index` (-1: the start) at the fraction theta of that interval. The mode GRIP stands for
    a friction margin that reached zero: the pair begins to slip or to stick. EFFECT stands for an event of an effect, KINK for a force
    that goes on through zero and takes friction with it, or brings it back.
    """

    index: int
    theta: float
    pair: int
    mode: float


class _Run:
    """State and counters of a run in progress."""

    def __init__(
        self, functions: Reference, state: np.ndarray, controls: np.ndarray, schedule: Schedule | None
    ) -> None:
        self.functions, self.model = functions, functions.model
        self.layout = functions.layouts.state
        split = functions.layouts.controls.split(controls)
        self.c, self.scale = split["c"], split["scale"]
        self.t_end, self.floor = float(split["t_end"][0]), float(split["floor"][0])
        self.schedule, self.stop = schedule, self.t_end
        self.max_events, self.max_steps = float(split["max_events"][0]), float(split["max_steps"][0])
        self.first_window = FIRST_WINDOW * float(split["scales"][0] / split["scales"][1])
        self.many, self.one = functions.window(float(split["tolerance"][0]))
        parts = self.layout.split(state.copy())
        self.t, self.y, self.mode, self.m = float(parts["t"][0]), parts["y"], parts["mode"], parts["m"]
        self.status = int(parts["status"][0])
        self.ends_with_force = np.array(ends_with_force(self.model)).ravel() > 0
        self.pushes = np.ones(self.model.k)  # -1 where a law pulls that ends with the gap
        self.rubs_till_it_pulls = rubs_till_it_pulls(self.model)
        self.steps = self.events = 0
        self.floored = float(parts["floored"][0])
        self.unsettled = float(parts["unsettled"][0])
        self.give_pieces()

    def give_pieces(self) -> None:
        """Put the pieces of the inputs that hold from now on into c, and take where they end."""
        if self.schedule is not None:
            place = self.schedule.place(self.t)
            self.c = self.c.copy()
            self.c[self.c.size - self.schedule.pieces.shape[1] :] = self.schedule.pieces[place]
            self.stop = self.schedule.stop(place, self.t_end)

    def rows(self) -> Iterator[np.ndarray]:
        """Yield the rows of the run after its first; `status` says how it ended."""
        window = self.first_window
        while self.status == RUNNING:
            h = min(window, self.stop - self.t)
            try:
                points = self.integrate(self.many, self.t, self.y, h)
            except RuntimeError:  # SUNDIALS gave up, or something was not a number
                window = h / 4
                if window < SHORTEST * self.first_window:
                    self.status = NOT_FINITE
                continue
            event = self.first_event(points, h)
            arrives = event is None and h >= self.stop - self.t
            times = self.t + h * np.arange(1, GRID + 1) / GRID
            if arrives:
                times[-1] = self.stop
            for t, y in zip(times[: GRID if event is None else event.index + 1], points, strict=False):
                self.t, self.y, self.steps = float(t), y, self.steps + 1
                if arrives and t == self.t_end:
                    self.happen_at_the_end()
                self.set_status(arrives=arrives and t == self.t_end)
                yield self.row()
                if self.status != RUNNING:
                    return
            window = min(2 * window, self.t_end / WINDOWS)
            if event is not None:
                self.change(event, h / GRID)
                self.set_status()
                yield self.row()
                window = min(self.first_window, self.t_end / WINDOWS)
            if self.t == self.stop < self.t_end and self.status == RUNNING:
                self.give_pieces()
                yield self.row()

    def integrate(self, function: Any, t: float, y: np.ndarray, h: float) -> np.ndarray:
        """Return the states at the points of a window of h [s], shape (points, ny)."""
        p = np.concatenate([[t, h], self.mode, self.m, self.c, self.scale])
        states: np.ndarray = np.array(function(x0=y / self.scale, p=p)["xf"]).T * self.scale
        if not np.all(np.isfinite(states)):
            raise RuntimeError("not a number")
        for i in self.model.quaternions:
            states[:, i : i + 4] /= np.linalg.norm(states[:, i : i + 4], axis=1, keepdims=True)
        return states

    def at(self, t: float, y: np.ndarray) -> dict[str, np.ndarray]:
        """Evaluate dy and the pair quantities of a state, by name."""
        ends = self.functions.ends
        values = ends.call([t, y, self.mode, self.m, self.c])
        return {name: np.array(value).ravel() for name, value in zip(ends.name_out(), values, strict=True)}

    def event_functions(self, t: float, y: np.ndarray) -> list[tuple[int, float, float, float]]:
        """Return the event functions of a state: (pair, mode once the value is negative, value, rate)."""
        end, watched = self.at(t, y), []
        for j, mode in enumerate(self.mode):
            gap, rate, acceleration = (float(end[name][j]) for name in ("gap", "gap_rate", "gap_acceleration"))
            if mode == FLIGHT:
                watched.append((j, CONTACT, gap, rate))
                continue
            watched.append((j, FLIGHT, -gap, -rate))
            if mode == CONTACT and self.ends_with_force[j]:
                watched.append((j, RELEASED, float(end["force"][j]), float(end["force_rate"][j])))
            elif mode == CONTACT and self.rubs_till_it_pulls[j]:
                force, force_rate = (float(self.pushes[j] * end[name][j]) for name in ("force", "force_rate"))
                watched.append((j, KINK, force, force_rate))
            elif mode == RELEASED:
                watched.append((j, CONTACT, rate, acceleration))
        for i, j in enumerate(pairs_of(self.model)):
            if j == NO_PAIR or self.mode[j] == CONTACT:
                watched.append((j, GRIP, float(end["margin"][i]), float(end["margin_rate"][i])))
        of_effects = zip(end["event"], end["event_rate"], strict=True)
        return watched + [(i, EFFECT, float(margin), float(rate)) for i, (margin, rate) in enumerate(of_effects)]

    def first_event(self, points: np.ndarray, h: float) -> _Event | None:
        """Find the first event of a window.

        At the window's start every signal counts as positive: an event has just been handled there.
        """
        before, start = self.event_functions(self.t, self.y), self.y
        for i, y in enumerate(points):
            t, step = self.t + h * i / GRID, h / GRID
            after = self.event_functions(t + step, y)
            roots = []
            for n, (a, b) in enumerate(zip(before, after, strict=True)):
                high = 1.0 if b[2] <= 0 else self.minimum(t, start, step, n) if a[3] < 0 < b[3] else None
                if high is not None:
                    roots.append((self.root(t, start, step, n, high), n))
            if roots:
                theta, n = min(roots)
                return _Event(i - 1, theta, after[n][0], after[n][1])
            before, start = after, y
        return None

    def value(self, t: float, y: np.ndarray, h: float, n: int, part: int) -> float:
        """Return signal n (part 0) or its rate (part 1) a time h [s] after a state."""
        if h > 0:
            (y,) = self.integrate(self.one, t, y, h)
        return self.event_functions(t + h, y)[n][2:][part]

    def minimum(self, t: float, y: np.ndarray, step: float, n: int) -> float | None:
        """Locate the minimum of signal n in an interval, as a fraction of it; None if the minimum is positive."""
        if not self.value(t, y, 0, n, 1) < 0 < self.value(t, y, step, n, 1):
            return None  # flat, to the tolerance of two integrations
        theta = float(brentq(lambda x: self.value(t, y, x * step, n, 1), 0, 1))
        return theta if theta > 0 and self.value(t, y, theta * step, n, 0) <= 0 else None

    def root(self, t: float, y: np.ndarray, step: float, n: int, high: float) -> float:
        """Locate the zero crossing of signal n in an interval to rounding; 0 if it is negative from the start."""
        if self.value(t, y, high * step, n, 0) > 0:
            return high  # zero to the tolerance of two integrations
        low = 0.0
        while self.value(t, y, low * step, n, 0) <= 0:
            low = high / 2 if low == 0 else low / 8
            if low < EPS:
                return 0.0
        precision = max(2 * EPS * t / step, EPS)
        return float(brentq(lambda x: self.value(t, y, x * step, n, 0), low, high, xtol=precision, rtol=4 * EPS))

    def change(self, event: _Event, step: float) -> None:
        """Advance to an event, change the pair's mode, set its latches and book its energy."""
        if event.theta > 0:
            (self.y,) = self.integrate(self.one, self.t, self.y, event.theta * step)
            self.t += event.theta * step
            self.steps += 1
        if event.mode == EFFECT:
            self.events += 1
            self.y = np.array(jump(self.model)(self.t, self.y, self.c, DUE)).ravel()
            return
        if event.mode == GRIP:
            self.resolve_slip(event.pair, ran_out=True)
            return
        if event.mode == KINK:
            self.pushes[event.pair] *= -1
            return
        end, old, j = self.at(self.t, self.y), self.mode[event.pair], event.pair
        if old == FLIGHT:
            self.events += 1
            self.pushes[j] = 1
            for i, (_, _, pair) in enumerate(self.model.module.LATCHES):
                if pair == j:
                    self.m = self.m.copy()
                    self.m[i] = max(-end["gap_rate"][j], self.floor)
            self.floored += bool(self.model.latches) and -end["gap_rate"][j] < self.floor
        elif self.model.has_ledger:
            stored = np.array(self.model.function("energy")(self.t, *self.parts(), self.c)[2]).ravel()[j]
            leaves = 1 if old == CONTACT else -1 if event.mode == CONTACT else 0
            self.y = self.y.copy()
            self.y[self.model.nq + self.model.nu + self.model.module.DISSIPATED[j]] += leaves * stored
        self.mode = self.mode.copy()
        self.mode[j] = event.mode
        for row, pair in self.model.module.BRISTLES:
            if self.mode[pair] != CONTACT:
                self.y = self.y.copy()
                self.y[self.model.nq + self.model.nu + row] = 0

        if j in pairs_of(self.model):
            self.resolve_slip(j, ran_out=False)

    def happen_at_the_end(self) -> None:
        """Let the events of effects happen that are due, as `effect_events.due` has them in the other methods."""
        end = self.at(self.t, self.y)
        levels = np.where(end["event_rate"] < 0, DUE, 0.0)
        if np.any(end["event"] <= levels):
            self.events += int(np.sum(end["event"] <= levels))
            self.y = np.array(jump(self.model)(self.t, self.y, self.c, levels)).ravel()

    def resolve_slip(self, j: int, *, ran_out: bool) -> None:
        """Resolve stick and slip of pair j after its margin ran out or its contact began or ended."""
        mine = np.array([pair == j for pair in pairs_of(self.model)])
        breaks = mine & ran_out & sticking(self.model, self.m)
        tolerances = np.full(mine.size, AT_REST), np.where(breaks, BREAKS_LOOSE, 0.0)
        results = self.functions.resolve_slips(self.t, self.y, self.mode, self.m, self.c, mine & ~breaks, *tolerances)
        self.m, self.y, busy = (np.array(result).ravel() for result in results)
        self.unsettled += float(busy[0])

    def parts(self) -> tuple[np.ndarray, np.ndarray]:
        """Return q and u."""
        nq = self.model.nq
        return self.y[:nq], self.y[nq : nq + self.model.nu]

    def set_status(self, *, arrives: bool = False) -> None:
        """Update the status from the state and the counters."""
        if np.any(self.at(self.t, self.y)["in_range"] < 0.5):
            self.status = OUTSIDE_LAW_RANGE
        elif arrives:
            self.status = FINISHED
        elif self.events > self.max_events:
            self.status = EVENT_LIMIT
        elif self.steps >= self.max_steps:
            self.status = TOO_MANY_STEPS

    def row(self) -> np.ndarray:
        """Return the engine's state vector of the current state."""
        end = self.at(self.t, self.y)
        values: dict[str, Any] = {"t": self.t, "y": self.y, "dy": end["dy"], "mode": self.mode, "m": self.m}
        values |= {name: end[name] for name in END_PARTS}
        values |= {
            "accepted": 1,
            "status": self.status,
            "steps": self.steps,
            "events": self.events,
            "floored": self.floored,
            "unsettled": self.unsettled,
            "pieces": self.c[self.c.size - self.model.npieces :],
            "stop": self.stop,
        }
        row = np.zeros(self.layout.size)
        for name, value in values.items():
            row[self.layout[name]] = value
        return row
