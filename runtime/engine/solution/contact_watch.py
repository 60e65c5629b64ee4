"""Contacts of runs, found block by block among their steps, of several short runs at once.

In an impact the gap rate never exceeds the approach speed v0, and a damping factor over v0 is made for that. In a contact that
lasts, which loads press and shake, it does: a force h F v/v0 then refers to a speed that has nothing to do with the motion. Such
contacts are found from the accepted steps, as impacts are: 25 us for a short run, a ten-thousandth of a long one's time.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import islice, pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

from hertzwerk.runtime.engine.integration.events.cubics import crest_of_cubic
from hertzwerk.runtime.engine.integration.events.event_location import NEAR
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, FLIGHT, RELEASED
from hertzwerk.runtime.engine.integration.step.set_valued_friction import slips_in
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.impacts import KINDS, RANKINGS, Impact, peaks

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.history import History

TOGETHER = 256  # contacts of a run whose peaks are found at once
PIECE = 2**14  # rows of a run followed at once: what is found of them is held no longer
FEW = (
    2**11
)  # rows of a block that may wait for those of other runs: more leave the cache, and their memory is given back
BESIDE = np.array([-1, 0, 1])
ROOTS = 8  # iterations for the root of a force that pulls briefly; from afar each divides the way by three
AT_ONCE = 1e-12  # of the time: rows so near each other are one
CREST = 2.0  # times the larger end of a step: most that is believed of the cubic in it
BEYOND = 1.1  # gap rate over approach speed from which a contact has left its law; rounding and steps make an impact's no larger than 1.001

Piece: TypeAlias = tuple["History", slice]
"""Block of a run, and the rows of it that are to be followed."""


class Contacts(NamedTuple):
    """Contacts of a pair in the order of onset, over or not, each a row of these tables.

    t, speed    onset [s] and approach speed [m/s]
    left     when the surfaces left each other last [s]; nan where they touch
    largest  of each KIND the largest at a row and in a step so far (n, kinds * RANKINGS)
    tops     rows of these values, each between its neighbours, none before the onset (n, kinds * RANKINGS, 3, ns)
    """

    pair: int
    t: np.ndarray
    speed: np.ndarray
    left: np.ndarray
    largest: np.ndarray
    tops: np.ndarray

    def part(self, first: int, stop: int) -> Contacts:
        """Return some of them."""
        return Contacts(self.pair, *(table[first:stop] for table in self[1:]))

    def goes_on_from(self, begun: Contacts, i: int) -> None:
        """Make contact i that of which a part was known before."""
        higher = self.largest[i] > begun.largest[0]
        self.tops[i] = np.where(higher[:, None, None], self.tops[i], begun.tops[0])
        self.t[i], self.speed[i] = begun.t[0], begun.speed[0]
        self.largest[i] = np.maximum(self.largest[i], begun.largest[0])


class Watch:
    """Observer of every contact of a run; keeps rows beside their tops, and a short block to be followed.

    A contact begins at a row in contact and ends at the next in flight; between them it may be released and touch
    again.
    """

    def __init__(self, model: EngineModel) -> None:
        self.model = model
        self.view: History  # of the last row
        self.open: dict[int, Contacts] = {}  # one that is not over, by pair
        self.ended: list[Contacts] = []  # whose peaks are not known yet
        self.known: list[Impact] = []
        self.waiting: list[Piece] = []  # pieces that are not followed yet

    def __getstate__(self) -> dict[str, Any]:
        follow([self])  # a pickle needs no block
        return vars(self)

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        follow([self])
        self.view = block.of(block.rows[-1:].copy())
        for contact in self.open.values():
            _, top, after = contact.tops[0].swapaxes(0, 1)
            after[(top == after).all(axis=1)] = block.rows[fresh]  # that was not there yet
        count = len(block.rows)
        self.waiting = [(block, slice(i, min(i + PIECE, count))) for i in range(fresh, count, PIECE)]
        if count > FEW:
            follow([self])

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        (impacts,) = impacts_of([self])
        return impacts


class Lasting(NamedTuple):
    """Contact of a pair that left its law.

    since        its onset [s]; speed: the approach speed that is latched [m/s]
    ratio        largest gap rate over that
    dissipated   by the pair's contact since then [J], nan without a ledger
    """

    pair: str
    since: float
    speed: float
    ratio: float
    dissipated: float


class LastingContacts:
    """Observer of contacts whose gap rates exceed the latched approach speed.

    A contact is a row: its onset [s], approach speed [m/s], largest ratio of gap rate to that, dissipation [J].
    """

    def __init__(self, model: EngineModel) -> None:
        self._model, self._latched = model, [(pair, row) for row, (*_, pair) in enumerate(model.module.LATCHES)]
        self._booked = list(model.module.DISSIPATED) if model.has_ledger else []
        self._open: dict[int, np.ndarray] = {}  # contacts that are not over, by pair, with what was booked at the onset
        self._ended: list[tuple[int, np.ndarray]] = []  # pairs and their contacts (n, 4)
        self._now: dict[int, float] = {}  # booked for pairs by now [J]

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        busy, t = {*block.busy(), *self._open}, block.t[fresh:]
        for j, latch in self._latched:
            if j not in busy:
                continue
            modes, speeds = block.of_pair("mode", j)[fresh:], block.latch(latch, j)[fresh:]
            ratios = np.where(modes == CONTACT, np.abs(block.of_pair("gap_rate", j)[fresh:]) / speeds, 0.0)
            if np.any(ratios > BEYOND) or j in self._open or modes[-1] != FLIGHT:
                booked = block.memory(self._booked[j])[fresh:] if self._booked else np.full(len(modes), math.nan)
                self._now[j] = float(booked[-1])
                self._follow(j, modes, np.stack([t, speeds, ratios, booked], axis=1))

    def _follow(self, j: int, modes: np.ndarray, rows: np.ndarray) -> None:
        """Follow the contacts of a pair through rows, each as a contact would be that begins and ends with it."""
        known = self._open.pop(j, None)
        is_open = goes_on(modes, known is not None)
        if known is not None:
            rows, is_open = np.vstack([known, rows]), np.append(True, is_open)
        edges = np.flatnonzero(np.diff(is_open, prepend=False, append=False))
        begins, ends = edges[::2], edges[1::2]
        if not len(begins):
            return
        contacts = rows[begins]
        contacts[:, 2] = np.maximum.reduceat(rows[:, 2], begins)
        if ends[-1] == len(rows):
            self._open[j], contacts, ends = contacts[-1], contacts[:-1], ends[:-1]
        contacts[:, 3] = rows[ends, 3] - contacts[:, 3]
        left = contacts[contacts[:, 2] > BEYOND]
        if left.size:
            self._ended.append((j, left))

    @property
    def contacts(self) -> tuple[Lasting, ...]:
        """Every contact that left its law, in the order in which they end, those that go on last."""
        last = [(j, [[*row[:3], self._now[j] - row[3]]]) for j, row in self._open.items() if row[2] > BEYOND]
        tables = [(j, rows.tolist()) for j, rows in self._ended] + last
        return tuple([Lasting(self._model.pairs[j], *row) for j, rows in tables for row in rows])


def impacts_of(watches: Sequence[Watch]) -> list[tuple[Impact, ...]]:
    """Return the contacts of each of several runs of a model, see `Watch.impacts`, found of all at once."""
    follow(watches)
    last = _with_peaks([(watch, [*watch.ended, *watch.open.values()]) for watch in watches])
    place = watches[0].model.pairs.index
    return [
        tuple(sorted([*watch.known, *impacts], key=lambda impact: (impact.t, place(impact.contact))))
        for watch, impacts in zip(watches, last, strict=True)
    ]


def follow(watches: Sequence[Watch]) -> None:
    """Follow the contacts of runs of a model through the blocks that wait."""
    while left := [watch for watch in watches if watch.waiting]:
        pieces = [watch.waiting.pop(0) for watch in left]
        open_or_new = {j for watch in left for j in watch.open} | {j for block, _ in pieces for j in block.busy()}
        for j in sorted(open_or_new):
            _follow(left, pieces, j)
        many = [(watch, watch.ended) for watch in left if sum(len(some.t) for some in watch.ended) >= TOGETHER]
        for (watch, _), impacts in zip(many, _with_peaks(many), strict=True):
            watch.known += impacts
            watch.ended = []


def _with_peaks(contacts: Sequence[tuple[Watch, Sequence[Contacts]]]) -> list[list[Impact]]:
    """Return the contacts of every run with their peaks."""
    parts = [some for _, of_run in contacts for some in of_run]
    if not parts:
        return [[] for _ in contacts]
    counts = [sum(len(some.t) for some in of_run) for _, of_run in contacts]
    controls = np.repeat([watch.view.controls for watch, _ in contacts], counts, axis=0)
    pairs = np.repeat([some.pair for some in parts], [len(some.t) for some in parts])
    t, speed, left, _, tops = (np.concatenate(tables) for tables in list(zip(*parts, strict=True))[1:])
    values = peaks(contacts[0][0].view, controls, pairs, tops)
    names = contacts[0][0].model.pairs
    columns = (pairs, t, speed, values[:, 0], left - t, values[:, 1])
    impacts = (
        Impact(names[j], t, speed, force, None if math.isnan(duration) else duration, penetration)
        for j, t, speed, force, duration, penetration in zip(*(column.tolist() for column in columns), strict=True)
    )
    return [list(islice(impacts, count)) for count in counts]


def _follow(watches: Sequence[Watch], pieces: Sequence[Piece], j: int) -> None:
    """Follow the contacts of pair j of several runs, each through its next rows.

    They are joined, the rows of one run after those of another; no contact goes on from run to run.
    """
    begun = [watch.open.pop(j, None) for watch in watches]
    stops = np.cumsum([rows.stop - rows.start for _, rows in pieces])
    starts = np.append(0, stops[:-1])
    modes, t = _joined(pieces, "mode", j), np.concatenate([block.t[rows] for block, rows in pieces])
    touching, is_open = modes == CONTACT, goes_on(modes, [each is not None for each in begun], starts)
    touched = _before(touching, starts, [each is not None and math.isnan(each.left[0]) for each in begun])
    for watch, contact, start in zip(watches, begun, starts.tolist(), strict=True):
        if contact is not None and not is_open[start]:
            watch.ended.append(contact._replace(left=t[[start]]) if touched[start] else contact)
    begins = np.flatnonzero(is_open & ~_before(is_open, starts, False))  # or goes on from the rows before
    if not len(begins):
        return
    final = np.zeros(len(t), dtype=bool)  # of a run
    final[stops - 1] = True
    ends = np.flatnonzero(is_open & (final | ~np.append(is_open[1:], False)))  # the last row of each
    run = np.searchsorted(stops, begins, side="right")
    goes = final[ends]
    leaves = np.append(np.flatnonzero(touched & ~touching), -1)  # the last: before these rows
    module, left = watches[0].model.module, leaves[:-1]
    if module.RELEASES[j] != "force" or any(pair == j for *_, pair in module.LATCHES):
        # with an approach speed damping is a factor of the force, and vanishes with it
        left = left[modes[left] == RELEASED]
    if left.size:
        t[left] -= _since_released(pieces, starts, j, left, modes[left] == RELEASED)
    latest = leaves[np.searchsorted(leaves[:-1], ends + ~goes, side="right") - 1]
    before = np.array([math.nan if each is None else each.left[0] for each in begun])[run]
    lefts = np.where(latest >= starts[run], t[latest], before)
    lefts[goes & touching[ends]] = math.nan
    joins = (begins == starts[run]) & np.array([each is not None for each in begun])[run]
    speeds = np.maximum(-_joined(pieces, "gap_rate", j)[begins], 0.0)
    largest, places = _largest(pieces, j, np.flatnonzero(is_open), ends + 1 - begins)
    shifts = (np.array([rows.start for _, rows in pieces]) - starts)[run][:, None]
    onsets = np.where(joins[:, None], 0, begins[:, None] + shifts)  # or before
    tops = _beside(pieces, run, places + shifts, onsets)
    contacts = Contacts(j, t[begins], speeds, lefts, largest, tops)
    bounds = np.searchsorted(run, np.arange(len(watches) + 1)).tolist()
    for watch, earlier, (first, stop) in zip(watches, begun, pairwise(bounds), strict=True):
        if first == stop:
            continue
        if earlier is not None and joins[first]:
            contacts.goes_on_from(earlier, first)
        last = stop - int(goes[stop - 1])
        if last > first:
            watch.ended.append(contacts.part(first, last))
        if last < stop:
            watch.open[j] = contacts.part(last, stop)


def _since_released(
    pieces: Sequence[Piece], starts: np.ndarray, j: int, leaves: np.ndarray, released: np.ndarray
) -> np.ndarray:
    """Return the times (n,) [s] since the normal force of pair j ran out.

    At joined rows at which it is released or has opened. Landings miss the former by what rounding changes a force of the scene's
    stiffness by: long where the last of a force fades slowly. A force that pulls just before the gap opens has run out unseen, in the
    last NEAR of the step or within its tolerance at the start: its root is found by Newton's method from there.
    """
    piece, late = np.searchsorted(starts, leaves, side="right") - 1, np.zeros(len(leaves))
    for i in sorted(set(piece.tolist())):
        block, rows = pieces[i]
        fades = released[piece == i]
        ends = leaves[piece == i] - starts[i] + rows.start
        before, h = block.rows[ends - 1], block.t[ends] - block.t[ends - 1]
        with np.errstate(all="ignore"):
            near, at_end = _nearer(block, j, before, h, np.where(fades, 0.0, NEAR**2 * h))
            known, since = fades & (np.abs(near) <= NEAR * h), near  # a force that jumps has no root
            pulls = ~fades & (at_end.of_pair("force", j) < 0)
            if pulls.any():
                before, h = before[pulls], h[pulls]
                root = h
                for _ in range(ROOTS):
                    root, at = _nearer(block, j, before, h, root)
                since[pulls], known[pulls] = root, (at.of_pair("force_rate", j) < 0) & (root <= h)
        late[piece == i] = np.where(known, since, 0.0)
    return late


def _nearer(block: History, j: int, before: np.ndarray, h: np.ndarray, since: np.ndarray) -> tuple[np.ndarray, History]:
    """Return the times (n,) [s] since a force was zero, better known than `since`, and the states there.

    before, h    rows that the steps begin at (n, ns), and their lengths [s]
    """
    at = block.of(block.later(before, h - since))
    return since + at.of_pair("force", j) / at.of_pair("force_rate", j), at


def goes_on(modes: np.ndarray, before: bool | Sequence[bool], starts: int | np.ndarray = 0) -> np.ndarray:
    """Return whether a contact goes on at rows of these modes (n,): it may be released and touch again.

    before    whether it is open before the rows of each run, which begin at `starts`
    """
    touches: np.ndarray = modes == CONTACT
    released = modes == RELEASED
    if released.any():
        latest = np.maximum.accumulate(np.where(released, -1, np.arange(len(modes))))
        lengths = np.diff(np.append(starts, len(modes)))
        touches = np.where(latest < np.repeat(starts, lengths), np.repeat(before, lengths), touches[latest])
    return touches


def _before(values: np.ndarray, starts: np.ndarray, first: bool | Sequence[bool]) -> np.ndarray:
    """Return the values (n,) of the rows before, of runs that begin at `starts` after these first ones."""
    before = np.append(False, values[:-1])
    before[starts] = first
    return before


def _joined(pieces: Sequence[Piece], part: str, pair: int) -> np.ndarray:
    """Return the column of a pair in a part of all pieces (n,)."""
    return np.concatenate([block.of_pair(part, pair)[rows] for block, rows in pieces])


def _largest(pieces: Sequence[Piece], j: int, within: np.ndarray, lengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the largest values in n contacts of pair j and the rows at which they are.

    Each (n, kinds * RANKINGS).
    Of each kind that of the rows and, as a contact may go up and down, of the crests in the steps that end there: a cubic may err,
    so that neither hides the other.

    within    rows in contact, of one contact after another, so many each
    """
    starts = np.cumsum(lengths) - lengths
    values = np.empty((len(KINDS), RANKINGS, len(within)))
    values[:, 0], values[:, 1] = (table[:, within] for table in _heights(pieces, j))
    values[np.isnan(values)] = math.inf  # what is no number counts as the largest
    largest = np.maximum.reduceat(values, starts, axis=2)
    hits = np.where(values == np.repeat(largest, lengths, axis=2), np.arange(len(within)), len(within))
    places = within[np.minimum.reduceat(hits, starts, axis=2)]
    row, crest = places[:, 0], places[:, 1]
    places[:, 1] = np.where((crest == row) | (crest == row + 1), row, crest)
    return largest.reshape(-1, len(starts)).T, places.reshape(-1, len(starts)).T


def _heights(pieces: Sequence[Piece], j: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the values at joined rows, and the crests in the steps that end there, each (kinds, n).

    Crests are those of cubics, also where both ends rise or fall, and -inf where there is none. One far above both is none: in hard
    contacts rates may be wild.
    """
    before = [(block, slice(max(rows.start - 1, 0), rows.stop)) for block, rows in pieces]
    values, rates = (np.stack([sign * _joined(before, names[i], j) for *names, sign in KINDS]) for i in range(2))
    t = np.concatenate([block.t[rows] for block, rows in before])
    h, higher = np.diff(t), np.maximum(values[:, :-1], values[:, 1:])
    with np.errstate(all="ignore"):
        place, crest, _ = crest_of_cubic(np, values[:, :-1], values[:, 1:], h * rates[:, :-1], h * rates[:, 1:])
        sound = (place > 0) & (place < 1) & (crest > higher) & (crest < CREST * higher)
    crests = np.pad(np.where(sound, crest, -math.inf), ((0, 0), (1, 0)), constant_values=-math.inf)
    ends = np.cumsum([rows.stop - rows.start for _, rows in before])
    among = np.ones(len(t), dtype=bool)
    for (_, rows), (_, own), end in zip(before, pieces, ends.tolist(), strict=True):
        first = end - (rows.stop - rows.start)
        crests[:, first] = -math.inf  # no step of this run ends there
        among[first] = rows.start == own.start
    return values[:, among], crests[:, among]


def _beside(pieces: Sequence[Piece], run: np.ndarray, places: np.ndarray, onsets: np.ndarray) -> np.ndarray:
    """Return the rows at places (n, kinds) in the blocks of runs (n,), and beside them, (n, kinds, 3, ns).

    None is before the onset (n, 1) of its contact, nor, if there is another, at the same time but for rounding: landings leave such
    steps, whose values are the largest by chance, while the crest is beside them. Of rows at one time between which friction sticks or
    slips the last one counts: the step behind it goes on from there.
    """
    bounds = np.searchsorted(run, np.arange(len(pieces) + 1))
    rows = []
    for (block, _), (first, stop) in zip(pieces, pairwise(bounds), strict=True):
        least, last = onsets[first:stop], len(block.rows) - 1
        top = _last_change(block)[places[first:stop]]
        least = np.broadcast_to(least, top.shape)
        sides = np.clip(top[:, :, None] + BESIDE, least[:, :, None], last)
        for side, edge in ((0, least), (2, np.full_like(top, last))):
            while True:
                beside = sides[:, :, side]
                goes_on = _at_once(block.t[beside], block.t[top]) & (beside != edge)
                if not goes_on.any():
                    break
                sides[:, :, side] = beside + BESIDE[side] * goes_on
        rows.append(block.rows[sides])
    return np.concatenate(rows)


def _at_once(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return whether times [s] are the same but for rounding."""
    same: np.ndarray = np.abs(one - other) <= AT_ONCE * np.abs(other)
    return same


def _last_change(block: History) -> np.ndarray:
    """Return for each row (n,) itself, or the last one at its time that friction has changed to."""
    last, model = np.arange(len(block.rows)), block.engine.model
    if not model.ns:
        return last
    slips = block.rows[:, block.columns("m")][:, slips_in(model)]
    changed = (slips[1:] != slips[:-1]).any(axis=1) & _at_once(block.t[1:], block.t[:-1])
    for i in np.flatnonzero(changed)[::-1]:
        last[i] = last[i + 1]
    return last
