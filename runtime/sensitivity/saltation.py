"""Jumps of sensitivities where the modes of a run change.

An event happens when its guard g(t, y, m) reaches zero. What changes the state before it moves the time of the event by
dt = -(g_y S + g_m M + g_c dc)/(dg/dt), and where the right-hand side or the state jumps the change after it is

    S+ = R_y (S + f- dt) + R_t dt + R_c dc - f+ dt

with the reset R and the right-hand sides f-, f+ before and after. The latched approach speed is a reset too. Where field
and state are continuous nothing jumps. Aizerman, Gantmacher, Quart. J. Mech. Appl. Math. 11 (1958) 225; Leine, Nijmeijer,
Dynamics and Bifurcations of Non-Smooth Mechanical Systems (2004), chapter 7.

Guards: the gap where a contact begins or opens; the normal force where it runs out under overlap; the gap rate where a
released pair is pressed again; the margin of a pair with set-valued friction (sliding velocity, or holding force less
the force that holds); the margin of an effect's event.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.events.events import LANDING
from hertzwerk.runtime.integrate.events.jumps import jump
from hertzwerk.runtime.integrate.step.explicit import flow
from hertzwerk.runtime.integrate.step.layout import CONTACT, FLIGHT, RELEASED, Layout
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.sensitivity.tangent import ARGUMENTS, Directions, Tangent, rates, tangent

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

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


@dataclass(frozen=True)
class Instant:
    """Changes of an event's time (P,) [s], and of everything `watched` at that time (size, P)."""

    time: np.ndarray
    then: np.ndarray


@dataclass(frozen=True)
class Jump:
    """Jump at one event: what there is before it, along its instant, and what changes.

    at    values and derivatives of `watched` before the event; slopes    dy/dt (ny) before and after it
    guards    rows of `at` that fell to zero; latched    of m: row, and row of `at` whose negative it becomes, or None where
    the floor of approach speeds did; booked    of y: row, row of `at` that is added, sign; emptied    rows of y set to
    zero; moved    whether coordinates became those of `at`
    """

    at: Tangent
    slopes: tuple[np.ndarray, np.ndarray]
    guards: tuple[int, ...]
    latched: tuple[tuple[int, int | None], ...]
    booked: tuple[tuple[int, int, int], ...]
    emptied: tuple[int, ...]
    moved: bool
    columns: dict[str, slice]
    graze: bool

    def __call__(
        self, state: np.ndarray, memory: np.ndarray, floor: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, Instant]:
        """Return the changes of state (ny, P) and memory (nm, P) after the event, and those at it.

        floor (P,): change of the least approach speed. Raises NoDerivativeError.
        """
        before, after = self.slopes
        change, speed = self.at.along(state, memory), self.at.rate(before)
        if self.graze or not all(speed[g] for g in self.guards):
            raise NoDerivativeError("a graze: surfaces that touch without approaching")
        if not self.guards:
            raise NoDerivativeError("an event that no margin tells the time of")
        times = [-change[g] / speed[g] for g in self.guards]
        dt = times[0]
        if any(np.any(np.abs(other - dt) > TOGETHER * (np.abs(other) + np.abs(dt))) for other in times[1:]):
            raise NoDerivativeError("events at one instant that would part")
        then = change + speed[:, None] * dt
        new, kept = state + before[:, None] * dt, memory.copy()
        for row, of, sign in self.booked:
            new[row] += sign * then[of]
        new[list(self.emptied)] = 0
        if self.moved:
            q = self.columns["jumped"]
            new[: q.stop - q.start] = then[q]
        for row, place in self.latched:
            kept[row] = floor if place is None else -then[place]
        return new - after[:, None] * dt, kept, Instant(dt, then)


class NoDerivativeError(ArithmeticError):
    """An event after which the motion does not depend smoothly on what came before."""


def switched(history: History) -> np.ndarray:
    """Return whether each row (rows,) follows a change of modes or slips, or an effect's event.

    The first row does."""
    model, mode, m = history.model, history.part("mode"), history.part("m")
    slips = m[:, model.nm - model.ns :]
    changes = (part[1:] != part[:-1] for part in (mode, slips))
    return np.append(True, np.any([part.any(axis=1) for part in changes], axis=0) | _happened(history))


def _happened(history: History) -> np.ndarray:
    """Return whether an effect had an event at the end of each step (rows - 1,)."""
    mode = history.part("mode")
    begun = ((mode[1:] == CONTACT) & (mode[:-1] == FLIGHT)).sum(axis=1)
    found: np.ndarray = np.diff(history.part("events")[:, 0]) > begun
    return found


def events_of(history: History, after: np.ndarray, directions: Directions) -> dict[int, Jump]:
    """Return the jump before each row that follows an event (`after`), by its index.

    Before the first there is none."""
    index = np.flatnonzero(after[1:])
    if not len(index):
        return {}
    layout, happened = history.engine.layouts.state, _happened(history)
    h = np.diff(history.t)[index]
    before = history.later(history.rows[index], h)
    before[:, layout["t"]] = history.part("t")[index + 1]
    found = tangent(watched, history, before, directions)
    was, now = (history.part("mode")[rows] for rows in (index, index + 1))
    by_gap = (was != now) & ((was == FLIGHT) | (now == FLIGHT))
    slopes = [_rates_inside(history, rows, by_gap, directions) for rows in (before, history.rows[index + 1])]
    return {
        int(i) + 1: _jump(
            history, int(i), h[k], before[k], found[k], (slopes[0][k], slopes[1][k]), happened=bool(happened[i])
        )
        for k, i in enumerate(index)
    }


def _rates_inside(history: History, rows: np.ndarray, by_gap: np.ndarray, directions: Directions) -> np.ndarray:
    """Return dy/dt (n, ny) at rows on the surface of pairs (n, k) that touch there: its limit from within.

    By rounding a row may lie outside, where there is no force. Forces may jump at the surface, or rise from it by any power
    of the penetration: the limit is that of Aitken of three small ones.
    """
    layout = history.engine.layouts.state
    gap, rate, mode = (rows[:, layout[part]] for part in ("gap", "gap_rate", "mode"))
    moves = by_gap & (mode == CONTACT) & (rate != 0)
    first, second, third = (
        _moved(rows, layout, np.where(moves, -(gap + depth) / np.where(moves, rate, 1), 0.0), history, directions)
        for depth in history.controls[history.engine.layouts.controls["scales"]][0] * np.array(WITHIN)
    )
    change, before = third - second, second - first
    curved = change - before
    found: np.ndarray = third - np.where(
        np.abs(change) < np.abs(before), change**2 / np.where(curved == 0, 1, curved), 0
    )
    return found


def _moved(rows: np.ndarray, layout: Layout, times: np.ndarray, history: History, directions: Directions) -> np.ndarray:
    """Return dy/dt (n, ny) at rows moved along their motion by the longest of some times (n, k) [s]."""
    moved = rows.copy()
    if times.size:
        longest = np.take_along_axis(times, np.abs(times).argmax(axis=1)[:, None], axis=1)
        moved[:, layout["t"]] += longest
        moved[:, layout["y"]] += longest * rows[:, layout["dy"]]
    return tangent(rates, history, moved, directions).value


def _jump(
    history: History,
    i: int,
    h: float,
    before: np.ndarray,
    at: Tangent,
    slopes: tuple[np.ndarray, np.ndarray],
    *,
    happened: bool,
) -> Jump:
    columns = watched_columns(history.model)
    model, layout, run = history.model, history.engine.layouts.state, history.engine.layouts.controls
    was, now = history.part("mode")[i], history.part("mode")[i + 1]
    slips = history.part("m")[i : i + 2, model.nm - model.ns :]
    floor, length = history.controls[run["floor"]][0], history.controls[run["scales"]][0]
    changed = np.flatnonzero(was != now)
    guards = [columns[GUARD_OF[was[j], now[j]]].start + int(j) for j in changed]
    gaps = [j for j in changed if GUARD_OF[was[j], now[j]] == "gap"]
    rate, acceleration = (before[layout[part]] for part in ("gap_rate", "gap_acceleration"))
    near = LANDING * history.controls[run["tolerance"]][0] * length
    if not guards:  # else slips change in consequence
        margin, margin_rate = (before[layout[part]] for part in ("margin", "margin_rate"))
        turned = [int(n) for n in np.flatnonzero(slips[0] != slips[1])]
        own = [n for n in turned if abs(margin[n]) <= abs(margin_rate[n]) * NEAR * h] or turned[:1]
        guards += [columns["margin"].start + n for n in own]
    if happened:
        guards += [columns["event"].start + int(n) for n in np.flatnonzero(before[layout["event"]] <= 0)]
    first_z = model.nq + model.nu
    onset = (was == FLIGHT) & (now == CONTACT)
    leaving = ((was == CONTACT) & (now != CONTACT)).astype(int) - ((was == RELEASED) & (now == CONTACT))
    booked = getattr(model.module, "DISSIPATED", ()) if model.has_ledger else ()
    return Jump(
        at=at,
        slopes=slopes,
        guards=tuple(guards),
        latched=tuple(
            (row, None if -rate[j] < floor else columns["gap_rate"].start + j)
            for row, (_, _, j) in enumerate(model.module.LATCHES)
            if onset[j]
        ),
        booked=tuple(
            (first_z + row, columns["stored"].start + j, int(leaving[j])) for j, row in enumerate(booked) if leaving[j]
        ),
        emptied=tuple(first_z + row for row, j in getattr(model.module, "BRISTLES", ()) if now[j] != CONTACT),
        moved=happened,
        columns=columns,
        graze=any(rate[j] ** 2 <= 2 * abs(acceleration[j]) * near for j in gaps),
    )


def _parts(model: Model) -> tuple[list[Any], dict[str, Any]]:
    """Arguments of `watched`, and expressions in them by name."""
    t, y, mode, m, c, _ = given = model.symbols(ARGUMENTS)
    ends = flow(model).at(t, y, mode, m, c)
    q, u, _ = model.parts(y)
    parts = {name: ends[name] for name in GUARDS}
    if model.has_ledger:
        parts["stored"] = model.function("energy")(t, q, u, c)[2]
    if model.ne:
        parts["jumped"] = jump(model)(t, y, c, LEVEL)[: model.nq]
    return given, parts


@per_model
def watched_columns(model: Model) -> dict[str, slice]:
    """Rows of `watched` by name."""
    found, start = {}, 0
    for name, part in _parts(model)[1].items():
        found[name] = slice(start, start := start + part.numel())
    return found


@per_model
def watched(model: Model) -> Any:
    """Build the function of everything that a jump depends on."""
    given, parts = _parts(model)
    return ca.Function("watched", given, [ca.vertcat(*map(ca.vec, parts.values()))])
