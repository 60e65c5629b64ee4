"""Energy balance and contacts of a run, followed from step to step by a CasADi function."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.step.layout import CONTACT, FLIGHT, RELEASED, Layout
from hertzwerk.runtime.model.caller import Scan
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.solution.history import energies_at
from hertzwerk.runtime.solution.impacts import KINDS, Impact, peaks

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

EPSILON = float(np.finfo(float).eps)
SMALL = 1e-6  # of the scene's energy scale: least energy that errors are relative to
PIECE = 2048  # rows followed at once: what is found of them fits into a cache
TOGETHER = 256  # contacts whose peaks are found at once
ONSET = ("t", "speed", "left")  # and end of a contact
BESIDE = np.array([-1, 0, 1])
TOPS = tuple(f"top_{part}" for part, *_ in KINDS)


class Watch:
    """Observer of the energy balance and of every contact of a run; keeps only rows beside their tops.

    The balance, energy - initial energy + dissipated - input, should stay zero. It is measured by the energy that the
    run moves: the largest kinetic energy, energy dissipated or put in, or change of potential energy. The total energy
    is no measure, since the zero of the potential is arbitrary.

    A contact begins at a row in contact and ends at the next in flight; between them it may be released and touch
    again.

    peaks    whether those of contacts are wanted
    """

    def __init__(self, model: Model, *, peaks: bool) -> None:
        self._model, self._wanted, self._layout = model, peaks, carried(model, peaks)
        self._last = np.zeros(self._layout.size)  # what is carried on
        self._rows = 0
        self._view: History | None = None
        self._kept: dict[int, np.ndarray] = {}  # rows beside the tops of open contacts, by number
        self._ended: list[np.ndarray] = []  # contacts that are over, as in `contacts`
        self._tops: list[np.ndarray] = []  # of contacts whose peaks are not known yet
        self._peaks: list[np.ndarray] = []

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._view, before = block.of(block.rows[-1:].copy()), self._rows - fresh
        follow = following(self._model, block.engine, self._wanted)
        for first in range(fresh, len(block.rows), PIECE):
            found = follow(block.controls, self._last, block.rows[first : first + PIECE])
            self._last, self._rows = found[-1].copy(), before + first + len(found)
            rows, pairs = np.nonzero(found[:, self._layout["ends"]])
            if len(rows):
                self._ended.append(self._table(found, rows, pairs))
                if self._wanted:
                    self._tops.append(self._rows_at(self._near(found, rows, pairs), block, before))
        if self._wanted:
            near = self._near(*self._open)
            self._kept = dict(zip(near.ravel().tolist(), self._rows_at(near.ravel(), block, before), strict=True))
            if sum(map(len, self._tops)) >= TOGETHER:
                self._peaks.append(self._peaks_of(np.concatenate(self._ended), self._tops))
                self._tops.clear()

    @property
    def contacts(self) -> np.ndarray:
        """Every contact: pair, onset [s], approach speed [m/s], when it was left [s] or nan, shape (n, 4)."""
        *_, pairs = self._open
        last = self._table(*self._open)
        last[self._last[self._layout["touching"].start + pairs] > 0, 3] = math.nan
        return np.concatenate([*self._ended, last])

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        table, tops, near = self.contacts, list(self._tops), self._near(*self._open)
        if near.size:
            tops.append(np.array([self._kept[row] for row in near.ravel().tolist()]).reshape(*near.shape, -1))
        if not len(table):
            return ()
        found = np.concatenate([*self._peaks, *([self._peaks_of(table, tops)] if tops else [])])
        order = np.lexsort((table[:, 0], table[:, 1]))
        names = self._model.pairs
        return tuple(
            Impact(names[int(j)], t, speed, force, left - t if left == left else None, penetration)
            for (j, t, speed, left), (force, penetration) in zip(
                table[order].tolist(), found[order].tolist(), strict=True
            )
        )

    @property
    def residual(self) -> float | None:
        """Return the largest error over the largest energy moved; None where something was not finite."""
        measure = max(self._number("moved"), SMALL * self._scale)
        return self._number("error") / measure if self._number("size") < math.inf and measure > 0 else None

    @property
    def unclosed(self) -> float:
        """Return the largest error beyond rounding over the largest energy moved or the scene's energy scale.

        The larger of the two: a run's accuracy is relative to its scales, however little moves. 0 where something was
        not finite, which ends a run by itself.
        """
        measure = max(self._number("moved"), self._scale)
        # of energies that are large because their zero is far, and of sums over steps
        rounding = EPSILON * self._rows * self._number("size")
        return max(self._number("error") - rounding, 0.0) / measure if rounding < math.inf and measure > 0 else 0.0

    @property
    def _scale(self) -> float:
        """The scene's energy scale [J]."""
        return 0.0 if self._view is None else self._view.energy_scale

    @property
    def _open(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Contacts that are not over: what is carried last, its row, the pairs."""
        pairs = np.flatnonzero(self._last[self._layout["open"]])
        return self._last[None], np.zeros_like(pairs), pairs

    def _number(self, name: str) -> float:
        return float(self._last[self._layout[name].start])

    def _of(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
        """Return parts of what is carried at rows (n,) that belong to pairs (n,), shape (n, names)."""
        columns = np.array([self._layout[name].start for name in names])
        part: np.ndarray = found[rows[:, None], columns + pairs[:, None]]
        return part

    def _table(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        table = np.empty((len(pairs), 1 + len(ONSET)))
        table[:, 0], table[:, 1:] = pairs, self._of(found, rows, pairs, ONSET)
        return table

    def _near(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        """Return the numbers of the rows of `tops` (n, kinds, 3); a contact has no row before its onset."""
        numbers = self._of(found, rows, pairs, ("onset", *TOPS)).astype(int)[:, :, None]
        near: np.ndarray = np.clip(numbers[:, 1:] + BESIDE, numbers[:, :1], self._rows - 1)
        return near

    def _rows_at(self, numbers: np.ndarray, block: History, before: int) -> np.ndarray:
        """Return rows by their numbers, of which those before the block's first are kept."""
        rows: np.ndarray = block.rows[np.maximum(numbers - before, 0)]
        for place in zip(*np.nonzero(numbers < before), strict=True):
            rows[place] = self._kept[int(numbers[place])]
        return rows

    def _peaks_of(self, table: np.ndarray, tops: list[np.ndarray]) -> np.ndarray:
        """Return the peaks of the last contacts of a table by their tops."""
        last = np.concatenate(tops)
        assert self._view is not None
        return peaks(self._view, table[len(table) - len(last) :, 0].astype(int), last)


@per_model
def carried(model: Model, peaks: bool) -> Layout:
    """Return the layout of what is carried from row to row.

    row: their number; start (4), moved, error, size: energies at the start, largest moved, largest error, largest [J];
    for each pair whether its contact is open, whether it touches, whether its contact ends at this row, and of the
    last contact onset t [s], approach speed [m/s], when it was left [s]; for peaks its onset and tops (rows), and largest values.
    """
    balance = {"start": 4, "moved": 1, "error": 1, "size": 1} if model.has_ledger else {}
    of_peaks = ("onset", *TOPS, *(part for part, *_ in KINDS)) if peaks else ()
    return Layout({"row": 1} | balance | dict.fromkeys(("open", "touching", "ends", *ONSET, *of_peaks), model.k))


@per_model
def following(model: Model, integrator: Integrator, peaks: bool) -> Scan:
    """Build the function (controls, carried, state) -> carried after one more row."""
    vectors, layout = integrator.layouts, carried(model, peaks)
    controls, state, last = vectors.controls.symbol("controls"), vectors.state.symbol("state"), layout.symbol("carried")
    at, was = vectors.state.split(state), layout.split(last)
    new = {**was, "row": was["row"] + 1}
    if model.k:
        new |= _of_pairs(at, was)
    if model.has_ledger:
        energies = energies_at(model, at, vectors.controls.split(controls)["c"])
        start = ca.if_else(was["row"] == 0, energies, was["start"])
        kinetic, potential, dissipated, given = ca.vertsplit(energies - start)
        size = ca.sum1(ca.fabs(energies))
        new |= {
            "start": start,
            "moved": ca.mmax(ca.vertcat(was["moved"], energies[0], *map(ca.fabs, (potential, dissipated, given)))),
            "error": ca.fmax(was["error"], ca.fabs(kinetic + potential + dissipated - given)),
            "size": ca.if_else(size < math.inf, ca.mmax(ca.vertcat(was["size"], ca.fabs(energies))), math.inf),
        }
    return Scan(ca.Function("following", [controls, last, state], [layout.join(new)]))


def _of_pairs(at: dict[str, Any], was: dict[str, Any]) -> dict[str, Any]:
    """Return what is carried of the pairs after a row."""
    touching = at["mode"] == CONTACT
    begins = touching * (1 - was["open"])
    onset = {"t": at["t"], "speed": ca.if_else(at["gap_rate"] >= 0, 0, -at["gap_rate"])}
    new = {
        "open": ca.if_else(at["mode"] == RELEASED, was["open"], touching),
        "touching": touching,
        "ends": was["open"] * (at["mode"] == FLIGHT),
        **{name: ca.if_else(begins, value, was[name]) for name, value in onset.items()},
        "left": ca.if_else(was["touching"] * (1 - touching), at["t"], ca.if_else(begins, math.nan, was["left"])),
    }
    if "onset" not in was:
        return new
    new["onset"] = ca.if_else(begins, was["row"], was["onset"])
    for part, _, sign in KINDS:
        value = ca.if_else(at[part] == at[part], sign * at[part], math.inf)  # what is no number counts as the largest
        higher = ca.logic_or(begins, new["open"] * (value > was[part]))
        new |= {
            part: ca.if_else(higher, value, was[part]),
            f"top_{part}": ca.if_else(higher, was["row"], was[f"top_{part}"]),
        }
    return new
