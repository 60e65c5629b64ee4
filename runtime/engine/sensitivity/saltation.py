"""Jumps of sensitivities where the modes of a run change.

An event happens when its guard g(t, y, m) reaches zero. What changes the state before it moves the time of the event by
dt = -(g_y S + g_m M + g_c dc)/(dg/dt), and where the right-hand side or the state jumps the change after it is

    S+ = R_y (S + f- dt) + R_t dt + R_c dc - f+ dt

with the reset R and the right-hand sides f-, f+ before and after. The last term becomes a shift of time until the next
event, where the equations allow it (`step_chain`). The latched approach speed is a reset too. Where field
and state are continuous nothing jumps. Aizerman, Gantmacher, Quart. J. Mech. Appl. Math. 11 (1958) 225; Leine, Nijmeijer,
Dynamics and Bifurcations of Non-Smooth Mechanical Systems (2004), chapter 7.

Guards: the gap where a contact begins or opens; the normal force where it runs out under overlap; the gap rate where a
released pair is pressed again; the margin of a pair with set-valued friction (sliding velocity, or holding force less
the force that holds); the margin of an effect's event.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.events.effect_events import jump
from hertzwerk.runtime.engine.integration.events.stick_and_slip import at_rest
from hertzwerk.runtime.engine.integration.step.explicit_step import flow, written_flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, FLIGHT, RELEASED
from hertzwerk.runtime.engine.integration.step.set_valued_friction import LANDING, grips_of, groups_of
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.sensitivity.step_chain import along, methods_of
from hertzwerk.runtime.engine.sensitivity.tangent import (
    ARGUMENTS,
    PARTS,
    Directions,
    Tangent,
    moves_with_events,
    rowwise,
    tangent,
)
from hertzwerk.runtime.engine.solution.history import History, steps_of
from hertzwerk.runtime.system.lazy import cached_property

GUARDS = ("gap", "gap_rate", "force", "margin", "event")
GUARD_OF = {  # by the modes of a pair before and after
    (FLIGHT, CONTACT): "gap",
    (CONTACT, FLIGHT): "gap",
    (CONTACT, RELEASED): "force",
    (RELEASED, FLIGHT): "gap",
    (RELEASED, CONTACT): "gap_rate",
}
NEAR = 1e-3  # of a step: a margin this close to zero at its end is what ended it
WITHIN = (1e-7, 1e-9, 1e-11)  # of the scene's length: penetrations from which the limit at the surface is taken
LEVEL = 1e-6  # of margins of events: those below happened
TOGETHER = 1e-6  # relative difference of the times' changes below which events at one instant are one
UNCHANGED, FLOORED = -1, -2  # of a latch at an event
GRAZE = "a graze: surfaces that touch without approaching"


@dataclass(frozen=True)
class Jumps:
    """Jumps at j events: what there is before each, along its instant, and what changes.

    rows (j,)               rows of the run that follow the events
    at                      values and derivatives of `watched` before them
    slopes                  dy/dt (j, ny) before and after them
    guards (j, size)        whether a row of `at` fell to zero
    latched (j, latches)    row of `at` whose negative each latch becomes; FLOORED: the floor of approach speeds; KEPT: none
    booked (j, pairs)       sign with which a pair's stored energy is added to its ledger
    emptied (j, ny)         whether a state is set to zero
    moved (j,)              whether coordinates became those of `at`
    graze (j,)              whether surfaces touched without approaching
    rested, stops (j,)      values and derivatives of `rested` after the events, and whether a pair came to rest in two directions
    places                  rows of `at` by name
    ledgers                 row of the state, and the pair whose stored energy is added to it
    moving                  whether changes after them are those at a fixed time since them
    """

    rows: np.ndarray
    at: Tangent
    slopes: tuple[np.ndarray, np.ndarray]
    guards: np.ndarray
    latched: np.ndarray
    booked: np.ndarray
    emptied: np.ndarray
    moved: np.ndarray
    graze: np.ndarray
    rested: Tangent
    stops: np.ndarray
    places: dict[str, slice]
    ledgers: tuple[tuple[int, int], ...]
    moving: bool

    @cached_property
    def speed(self) -> np.ndarray:
        """Rates (j, size) of what is watched, before the events."""
        return self.at.rate(self.slopes[0])

    @cached_property
    def determined(self) -> np.ndarray:
        """Whether guards determine the time of each event (j,), and it changes smoothly."""
        determined: np.ndarray = self.guards.any(axis=1) & ~self.graze & ~(self.guards & (self.speed == 0)).any(axis=1)
        return determined

    @cached_property
    def change(self) -> np.ndarray:
        """Maps (j, size, n + P) to the changes of what is watched, at fixed time."""
        shift = (self.at.to_time - self.speed)[:, :, None]
        return np.concatenate([self.at.to_state, self.at.to_memory, shift, self.at.by_constants], axis=2)

    @cached_property
    def time(self) -> np.ndarray:
        """Maps (j, n + P) to the changes of the events' times [s]; 0 where none is determined."""
        if not self.guards.size:
            return np.zeros((len(self.rows), self.change.shape[2]))
        first = np.arange(len(self.rows)), self.guards.argmax(axis=1)
        speed = np.where(self.determined, self.speed[first], np.inf)
        time: np.ndarray = -self.change[first] / speed[:, None]
        return time

    @cached_property
    def then(self) -> np.ndarray:
        """Maps (j, size, n + P) to the changes of what is watched, at the events."""
        changes: np.ndarray = self.change + self.speed[:, :, None] * self.time[:, None]
        return changes

    def maps(self, floor: np.ndarray) -> np.ndarray:
        """Return the maps (j, n, n + P) to the changes after the events.

        floor (P,): change of the least approach speed
        """
        (before, after), time = self.slopes, self.time[:, None]
        (events, ny), n = before.shape, before.shape[1] + self.at.to_memory.shape[2] + 1
        maps = np.zeros((events, n, n + len(floor)))
        maps[:, np.arange(n), np.arange(n)] = 1
        state, memory = maps[:, :ny], maps[:, ny:-1]
        state[:, :, n - 1] = -before
        state += before[:, :, None] * time
        for row, pair in self.ledgers:
            state[:, row] += self.booked[:, [pair]] * self.then[:, self.places["stored"].start + pair]
        state[self.emptied] = 0
        if self.moved.any():
            jumped = self.places["jumped"]
            state[self.moved, : jumped.stop - jumped.start] = self.then[self.moved, jumped]
        for latch, of in enumerate(self.latched.T):
            memory[of >= 0, latch] = -self.then[of >= 0, of[of >= 0]]
            memory[of == FLOORED, latch] = np.append(np.zeros(n), floor)
        maps[:, -1] = self.time if self.moving else 0
        if not self.moving:
            state -= after[:, :, None] * time
        # the margin tells that sliding ends along the slip; across it, friction has held it to a straight end
        held = self.rested[self.stops]
        stopped = np.concatenate([held.to_state, held.to_memory, held.to_time[:, :, None]], axis=2) @ maps[self.stops]
        stopped[:, :, n:] += held.by_constants
        state[self.stops] = stopped
        return maps

    def first_without(self, before: np.ndarray, least: np.ndarray) -> tuple[int, str]:
        """Return the first event after which there is no derivative, and why; else how many events, and "".

        before (j, n, P): changes before the events; least (P,): changes of times [s] so small are rounding
        """
        parting = np.zeros(len(self.rows), dtype=bool)
        for k in np.flatnonzero(self.determined & (np.count_nonzero(self.guards, axis=1) > 1)):
            guards = self.guards[k]
            times = -along(self.change[k, guards], before[k]) / self.speed[k, guards, None]
            parting[k] = np.any(np.abs(times - times[0]) > TOGETHER * (np.abs(times) + np.abs(times[0])) + least)
        bad = np.flatnonzero(~self.determined | parting)
        if not len(bad):
            return len(self.rows), ""
        first = int(bad[0])
        if self.determined[first]:
            return first, "simultaneous events that would separate"
        none = not self.graze[first] and not self.guards[first].any()
        return first, "an event whose time no margin determines" if none else GRAZE


def switched(history: History) -> np.ndarray:
    """Return whether each row (rows,) follows a change of modes or slips, or an effect's event.

    The first row does."""
    changes = (part[1:] != part[:-1] for part in (history.part("mode"), _sliding(history)))
    return np.append(True, np.any([part.any(axis=1) for part in changes], axis=0) | _happened(history))


def _sliding(history: History) -> np.ndarray:
    """Return the slips (rows, ns), of pairs that slide in two directions 1 or 0: theirs follow the motion."""
    model = history.model
    slips = history.part("m")[:, model.nm - model.ns :].copy()
    for group in groups_of(grips_of(model)):
        if len(group) > 1:
            slips[:, group] = np.any(slips[:, group] != 0, axis=1, keepdims=True)
    return slips


def _happened(history: History) -> np.ndarray:
    """Return whether an effect had an event at the end of each step (rows - 1,)."""
    mode, counted = history.part("mode"), np.diff(history.part("events")[:, 0])
    some = np.flatnonzero(counted)
    begun = ((mode[some + 1] == CONTACT) & (mode[some] == FLIGHT)).sum(axis=1)
    happened = np.zeros(len(counted), dtype=bool)
    happened[some] = counted[some] > begun
    return happened


def events_of(history: History, after: np.ndarray, directions: Directions) -> Jumps:
    """Return the jumps before the rows that follow an event (`after`); before the first there is none."""
    index = np.flatnonzero(after[1:])
    model, layout = history.model, history.engine.layouts.state
    h = np.diff(history.t)[index]
    before = history.later(history.rows[index], h)
    before[:, layout["t"]] = history.part("t")[index + 1]
    was, now = (history.part("mode")[rows] for rows in (index, index + 1))
    places, run = watched_columns(model), history.engine.layouts.controls
    floor, length = history.controls[run["floor"]][0], history.controls[run["scales"]][0]
    at = tangent(watched, history, before, directions)
    guards = np.zeros(at.value.shape, dtype=bool)
    by_gap = np.zeros(was.shape, dtype=bool)
    for (earlier, later), part in GUARD_OF.items():
        turned = (was == earlier) & (now == later)
        guards[:, places[part]] |= turned
        by_gap |= turned & (part == "gap")
    alone = ~guards.any(axis=1, keepdims=True)  # else slips change in consequence
    guards[:, places["margin"]] |= _slipping(history, index, before, h) & alone
    moved = _happened(history)[index]
    guards[:, places["event"]] = moved[:, None] & (before[:, layout["event"]] <= LEVEL)
    rate, acceleration = (before[:, layout[part]] for part in ("gap_rate", "gap_acceleration"))
    near = LANDING * history.controls[run["tolerance"]][0] * length
    pairs = np.array([pair for _, _, pair in model.module.LATCHES], dtype=int)
    onset = ((was == FLIGHT) & (now == CONTACT))[:, pairs]
    leaving = ((was == CONTACT) & (now != CONTACT)).astype(int) - ((was == RELEASED) & (now == CONTACT))
    stops = _stopping(history, index)
    emptied = np.zeros((len(index), layout.sizes["y"]), dtype=bool)
    for row, pair in model.module.BRISTLES:
        emptied[:, model.nq + model.nu + row] = now[:, pair] != CONTACT
    booked = model.module.DISSIPATED if model.has_ledger else ()
    return Jumps(
        rows=index + 1,
        at=at,
        slopes=(
            _rates_inside(history, before, by_gap),
            _rates_inside(history, history.rows[index + 1], by_gap),
        ),
        guards=guards,
        latched=np.where(
            onset, np.where(-rate[:, pairs] < floor, FLOORED, places["gap_rate"].start + pairs), UNCHANGED
        ),
        booked=leaving,
        emptied=emptied,
        moved=moved,
        rested=tangent(rested, history, history.rows[index + 1], directions),
        stops=stops,
        graze=(by_gap & (rate**2 <= 2 * np.abs(acceleration) * near)).any(axis=1),
        places=places,
        ledgers=tuple((model.nq + model.nu + row, pair) for pair, row in enumerate(booked)),
        moving=moves_with_events(model),
    )


def _stopping(history: History, index: np.ndarray) -> np.ndarray:
    """Return whether a pair that slid in two directions sticks after the steps (j,) from rows `index`."""
    sliding, stopping = _sliding(history), np.zeros(len(index), dtype=bool)
    for group in groups_of(grips_of(history.model)):
        if len(group) > 1:
            stopping |= (sliding[index, group[0]] == 1) & (sliding[index + 1, group[0]] == 0)
    return stopping


def tables_of_events(history: History, count: int) -> list[Rowwise]:
    """Return the functions that `events_of` calls row by row."""
    model = history.model
    steps = [step for method in methods_of(history) for step in steps_of(model, history.engine, method)]
    return [rowwise(model, watched, count), _rates(model), *steps]


def _slipping(history: History, index: np.ndarray, before: np.ndarray, h: np.ndarray) -> np.ndarray:
    """Return whether each friction (j, ns) itself began or ceased to slip at the end of a step.

    The step takes h (j,) [s] after the rows `index`. Not those that follow another's change: where no margin is near zero, the first.
    """
    layout, slips = history.engine.layouts.state, _sliding(history)
    margin, rate = (before[:, layout[part]] for part in ("margin", "margin_rate"))
    turned = slips[index] != slips[index + 1]
    own = turned & (np.abs(margin) <= np.abs(rate) * NEAR * h[:, None])
    first = turned & (np.cumsum(turned, axis=1) == 1)
    slipping: np.ndarray = np.where(own.any(axis=1)[:, None], own, first)
    return slipping


def _rates_inside(history: History, rows: np.ndarray, by_gap: np.ndarray) -> np.ndarray:
    """Return dy/dt (n, ny) at rows on the surface of pairs (n, k) that touch there: its limit from within.

    By rounding a row may lie outside, where there is no force. Forces may jump at the surface, or rise from it by any power
    of the penetration: the limit is that of Aitken of three small ones.
    """
    layout = history.engine.layouts.state
    gap, rate, mode = (rows[:, layout[part]] for part in ("gap", "gap_rate", "mode"))
    moves = by_gap & (mode == CONTACT) & (rate != 0)
    first, second, third = (
        _moved(rows, np.where(moves, -(gap + depth) / np.where(moves, rate, 1), 0.0), history)
        for depth in history.controls[history.engine.layouts.controls["scales"]][0] * np.array(WITHIN)
    )
    change, before = third - second, second - first
    curved = change - before
    return third - np.where(np.abs(change) < np.abs(before), change**2 / np.where(curved == 0, 1, curved), 0)


def _moved(rows: np.ndarray, times: np.ndarray, history: History) -> np.ndarray:
    """Return dy/dt (n, ny) at rows moved along their motion by the longest of some times (n, k) [s]."""
    layout, moved = history.engine.layouts.state, rows.copy()
    if times.size:
        longest = np.take_along_axis(times, np.abs(times).argmax(axis=1)[:, None], axis=1)
        moved[:, layout["t"]] += longest
        moved[:, layout["y"]] += longest * rows[:, layout["dy"]]
    parts = (moved[:, layout[part]] for part in PARTS)
    pieces = [rows[:, layout["pieces"]]] if history.model.inputs else []
    return _rates(history.model)(history.controls[: history.model.nc], *parts, *pieces)[0]


@per_model
def _rates(model: EngineModel) -> Rowwise:
    return Rowwise(model.with_pieces(flow(model).rates, 4), constant=4)


def _parts(model: EngineModel) -> tuple[list[Any], dict[str, Any]]:
    """Arguments of `watched`, and expressions in them by name."""
    t, y, mode, m, c, _ = arguments = model.symbols(ARGUMENTS)
    ends = written_flow(model).at(t, y, mode, m, c)
    q, u, _ = model.parts(y)
    parts = {name: ends[name] for name in GUARDS}
    if model.has_ledger:
        parts["stored"] = model.function("energy")(t, q, u, c)[2]
    if model.ne:
        parts["jumped"] = jump(model)(t, y, c, LEVEL)[: model.nq]
    return arguments, parts


@per_model
def watched_columns(model: EngineModel) -> dict[str, slice]:
    """Rows of `watched` by name."""
    columns, start = {}, 0
    for name, part in _parts(model)[1].items():
        columns[name] = slice(start, start := start + part.numel())
    return columns


@per_model
def watched(model: EngineModel) -> Any:
    """Build the function of everything that a jump depends on."""
    arguments, parts = _parts(model)
    return ca.Function("watched", arguments, [ca.vertcat(*map(ca.vec, parts.values()))])


@per_model
def rested(model: EngineModel) -> Any:
    """Build the function of the state (ny) whose sticking pairs are at rest."""
    t, y, mode, m, c, _ = arguments = model.symbols(ARGUMENTS)
    slips = m[model.nm - model.ns :]
    return ca.Function("rested", arguments, [at_rest(model)(t, y, mode, m, c, slips)[1] if model.ns else y])
