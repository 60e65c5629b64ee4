"""Multiple shooting: measured runs in segments, whose starts are free and must meet the ends before.

Within a segment a motion is told by its start, however long the whole is in chaos. A step of Gauss and Newton eliminates
the starts from the last on by orthogonal factors of their blocks (condensing), which stays sound where products of
transition matrices overflow; it is shortened by the natural monotonicity test (Bock, Bonner Math. Schriften 183, 1987).

1. joined      one by one, each begun where the one before ends, in flight: what a contact remembers is no part of a start
2. drawn       what is told so far allows other numbers of impacts: places drawn from it are tried on the next segment
3. settled     Gauss and Newton, relaxed where curvature that they leave out makes them swing (Aitken)
4. met         all of it from other draws, until the least squares were met several times: valleys are many and narrow
5. followed    profiles walk from there in steps within which the squares rise as their slopes say, on one branch

Noise model: what is measured has independent normal noise; the motion has none, but for the runs' own error, which is
taken as a normal change at every joint of segments. Intervals follow from the factor that remains for the parameters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.fitting.experiment import Observed
from hertzwerk.runtime.fitting.forward import Forward, Point
from hertzwerk.runtime.fitting.search import FEW, FINER, Found, Search
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.continuation import parameters_of
from hertzwerk.runtime.run.request import Settings
from hertzwerk.runtime.sensitivity.sensitivities import Sensitivities
from hertzwerk.runtime.simulation import Solution, solve

Array = NDArray[np.float64]

GROWTH = 10.0  # of a change of the start within a segment that is chosen automatically
HALVED = 3  # lengths that are tried, each half of the one before, until all data are met
WINDOW = 0.6, 1.15  # of a segment's length: where it may end, at the step farthest from contact
CERTAIN = 10.0  # times the tolerance, of the scales: least error that is taken of a run
TIMES = 3.0  # a run's error seen, by which it may miss
SMALL, STUCK = 1e-7, 1.0  # length of steps that may be the runs' own error, and root of the squares that it may be
FINEST = 1e-13  # tolerance of a run
STEPS, SHORTEST, LONGEST = 30, 1 / 200, 2.0  # most steps, the least part of one, and the most
CONVERGED, JOINING = 0.1, 1.0  # root of what the squares may still fall by, at the end and while segments are joined
DOWN = 40  # runs down a step to a corner
LIKELY, MET = 3.0, 10.0  # deviations of the mean square of all residuals: no other start is followed, data are met
MORE = 1, 4, 16  # times the starts that are asked for
DRAWS, WIDTHS, FOLLOWED = 24, (1.0, 2.0), 3  # places tried before a segment is joined, their deviations, and settled
SMOOTH, HALVINGS = 0.5, 64  # rise of squares that slopes do not say, for which a step is halved, and its least part
CUTS = 3  # times that segments are cut
TRIES, MEETINGS, SAME = 8, 3, 0.1  # followed at most; that end in the least; squares by which they differ
ALIKE = 0.02  # of the ranges: starts that are one
JOINED = 4.0  # mean square of a new segment's residuals over the noise beyond which it is not joined


@dataclass(frozen=True)
class _Block:
    """Linearised segment: residuals (m,) and end (n,), with derivatives by x and by its start."""

    residual: Array
    by_x: Array
    by_start: Array
    end: Array
    end_by_x: Array
    end_by_start: Array


@dataclass
class _Piece:
    """Segment of a measured run, from `begin` to `end` [s], with its rows of the data.

    start      state (n,) that it begins with, None of the first: the scene's
    allowed    misses (n,) of its end, one standard deviation
    """

    run: int
    begin: float
    end: float
    rows: NDArray[np.intp]
    start: Array | None
    allowed: Array
    known: dict[tuple[bytes, bytes, float], Solution | None] = field(default_factory=dict)
    linear: tuple[tuple[bytes, bytes, bytes], _Block | None] | None = None


_Place = tuple[Array, list[list[tuple[_Piece, Array | None]]]]


class Shot(Forward):
    """Forward model in segments; `at` is that of the starts found, which are no function of x alone."""

    def __init__(self, whole: Forward, length: float) -> None:
        self.__dict__.update(vars(whole))
        self.length, self.chains = length, [list[_Piece]() for _ in whole.observed]
        self.tolerance = max(whole.tolerance / FINER, FINEST)
        self.names = [free.name for free in self.free]
        self.of_start = [free.name in _states(self.observed[0].model) for free in self.free]

    def at(self, x: Array, tolerance: float | None = None) -> Point:
        """Return the segments' runs, in order, and what they predict."""
        predicted, times = np.full((2, len(self.measured)), np.nan)
        runs = []
        for piece in self.pieces:
            each, offset = self.observed[piece.run], self.offset(piece.run, x)
            run = self.run_of(piece, x)
            runs.append(run)
            if run is not None:
                local = piece.rows - self._first(piece)
                predicted[piece.rows] = each.predicted(run, offset)[local]
                times[piece.rows] = each.times(run, offset)[local]
        return Point(tuple(runs), self.gains(x) * predicted, times)

    @property
    def pieces(self) -> list[_Piece]:
        """All segments, run by run."""
        return [piece for chain in self.chains for piece in chain]

    def run_of(self, piece: _Piece, x: Array, tolerance: float | None = None) -> Solution | None:
        """Return the run of a segment; None where it cannot be made or ends before its time."""
        start, tol = piece.start, tolerance or self.tolerance
        key = x.tobytes(), b"" if start is None else start.tobytes(), tol
        if key not in piece.known:
            while len(piece.known) >= 3:
                piece.known.pop(next(iter(piece.known)))
            piece.known[key] = self._solved(piece, x, tol)
        return piece.known[key]

    def _solved(self, piece: _Piece, x: Array, tolerance: float) -> Solution | None:
        each = self.observed[piece.run]
        parameters, initial = self.given(each, x)
        self.runs_made += 1
        try:
            run = solve(
                each.model,
                Settings(piece.end, None, tolerance, self._method),
                parameters,
                initial,
                start=None if piece.start is None else (piece.begin, piece.start),
            )
        except InputError:
            return None
        if run.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return run if run.t_end >= piece.end else None

    def residual(self, piece: _Piece, x: Array, sigma: Array) -> tuple[Array, Array] | None:
        """Return the residuals of a segment over the noise, and its end; None where it has none."""
        each, run = self.observed[piece.run], self.run_of(piece, x)
        if run is None:
            return None
        predicted = each.predicted(run, self.offset(piece.run, x))[piece.rows - self._first(piece)]
        residual = (self.measured[piece.rows] - self.gains(x)[piece.rows] * predicted) / sigma[piece.rows]
        end = np.array([run.final[name] for name in _states(each.model)])
        return (residual, end) if np.isfinite(residual).all() and np.isfinite(end).all() else None

    def _first(self, piece: _Piece) -> int:
        """Return the first row of a segment's measured run."""
        return int(np.flatnonzero(self.run == piece.run)[0])

    def linear(self, piece: _Piece, x: Array, sigma: Array) -> _Block | None:
        """Return a segment with its derivatives, that of the last place remembered; None where it has none."""
        key = x.tobytes(), b"" if piece.start is None else piece.start.tobytes(), sigma[piece.rows].tobytes()
        if piece.linear is None or piece.linear[0] != key:
            piece.linear = key, self._linear(piece, x, sigma)
        return piece.linear[1]

    def _linear(self, piece: _Piece, x: Array, sigma: Array) -> _Block | None:
        each, run, offset = self.observed[piece.run], self.run_of(piece, x), self.offset(piece.run, x)
        found = self.residual(piece, x, sigma)
        if run is None or found is None:
            return None
        model = each.model
        states, k, free = _states(model), len(x), len(self.free)
        if piece.start is None:
            of = run.sensitivities(*self.names)
            changes = slice(free)
        else:
            given = [name for name, start in zip(self.names, self.of_start, strict=True) if not start]
            begin = np.hstack([np.zeros((len(states), len(given))), np.eye(len(states))])
            bound = model.bind(parameters_of(run, model))
            of = Sensitivities(run.history, bound, {}, (*given, *states), compiled=run.compiled, begin=begin)
            changes = slice(len(given))
        if of.until < piece.end:
            return None
        local, gains = piece.rows - self._first(piece), self.gains(x)[piece.rows]
        slopes = each.slopes(run, of, offset)[local] * gains[:, None]
        at_end = np.array([of.along(np.array([piece.end]), name)[0] for name in states])
        scales = np.array([one.slope(one.outer(place)) for one, place in zip(self.searched, x, strict=True)])
        by_x, end_by_x = np.zeros((len(local), k)), np.zeros((len(states), k))
        moving = np.flatnonzero([piece.start is None or not start for start in self.of_start])
        by_x[:, moving], end_by_x[:, moving] = slopes[:, changes], at_end[:, changes]
        predicted = each.predicted(run, offset)[local]
        column = self._gain[piece.rows]
        scaled = np.flatnonzero(column >= 0)
        by_x[scaled, column[scaled]] = predicted[scaled]
        rest = slice(changes.stop, None)
        block = _Block(
            found[0],
            -by_x * scales / sigma[piece.rows, None],
            -slopes[:, rest] / sigma[piece.rows, None],
            found[1],
            end_by_x * scales,
            at_end[:, rest],
        )
        return block if all(np.isfinite(part).all() for part in vars(block).values()) else None


def check_shooting(model: Model, observed: Sequence[Observed], *, fitted_offset: bool, faults: list[Fault]) -> None:
    """Append to `faults` what forbids segments."""
    where = "shooting"
    for lacks, found in (
        (bool(model.nl), "a scene with closed loops"),
        (bool(model.quaternions), "a scene with quaternions"),
        (bool(model.ne), "a scene whose effects have states"),
        (bool(model.inputs), "a scene with inputs"),
        (model.joints is not model, "absolute coordinates"),
    ):
        if lacks:
            faults.append(Fault(where, found, "a tree, in joint coordinates, whose state is that of its joints"))
    if any(each.by_impacts for each in observed):
        faults.append(Fault(where, "data of impacts", "data over time", "numbered impacts belong to no segment"))
    if fitted_offset:
        faults.append(Fault(where, "beside a range of offsets", "an offset that is known"))


def shot(
    search: Search, length: float | None, starts: int, seed: int, progress: Callable[[float], object]
) -> tuple[Search, Found, str]:
    """Return the fit of all segments, the search that it ended in, and how its intervals are obtained.

    length    of a segment [s], halved where data are not met; None: chosen by the growth of changes
    The best few starts are fitted to the data of the first segments alone, from more and more starts until one meets them;
    each is then followed, by turns and by other draws, until the least was met three times.
    """
    whole, begin = search.forward, search.starts(0, seed)[0]
    first = _chosen(whole, begin) if length is None else length
    times = np.concatenate([each.at + whole.offset(i, begin) for i, each in enumerate(whole.observed)])
    enough = float(np.sort(times)[min(FEW * len(begin), len(times)) - 1])
    ends = [float(np.max(times[whole.run == i])) for i in range(len(whole.observed))]
    tried: list[_Solver] = []
    for length in (first / 2**k for k in range(HALVED)):
        if tried and tried[0].worth()[0]:
            break
        places = list(_first(search, times <= max(length * WINDOW[1], enough), starts, seed))
        for number in range(TRIES):
            found, sigma = places[number % len(places)]
            solver = _Solver(Shot(whole, length), sigma, found.x, search.low, search.high, ends, number)
            solver.join(progress)
            tried = sorted([*tried, solver], key=_Solver.worth, reverse=True)
            if sum(other.worth()[0] and other.cost() < tried[0].cost() + SAME for other in tried) == MEETINGS:
                break
    best = tried[0]
    best.forward.runs_made = sum(solver.forward.runs_made for solver in tried)
    if not best.forward.pieces:
        fault = Fault("shooting", "no run of a first segment", "ranges within which the scene runs", "narrower ranges")
        raise InputError(f"fit of {whole.observed[0].model.name}", [fault])
    searched = Segments(best, search.stated)
    for _ in range(3 if np.any(np.isnan(search.stated)) else 0):  # noise follows residuals, and they the noise
        best.sigma = searched.estimated(best.found())
        best.settle()
    searched.begin()
    how = (
        f"linear: curvature of the least squares of multiple shooting over {len(best.forward.pieces)} segments, each "
        f"beginning where the one before ends to {best.loosest():.1g} of the scales; no other noise of the motion"
    )
    return searched, best.found(), how


def _first(search: Search, early: NDArray[np.bool_], starts: int, seed: int) -> Iterator[tuple[Found, Array]]:
    """Yield least squares over early data (n,) that meet them, the least first, with the noise of each.

    Of data with a stated noise there are more and more starts until the least meets them.
    """
    whole = search.forward
    there = early.copy()
    there[[int(np.flatnonzero(whole.column == k)[0]) for k in range(len(whole.columns))]] = True
    part, found = Search(whole.cut(there), search.stated[there]), list[Found]()
    for more in MORE:
        found = part.candidates(starts * more, seed)
        met = [one for one in found if np.mean(one.residuals**2) < 1 + LIKELY * math.sqrt(2 / len(one.residuals))]
        found = met or found
        if met or np.any(np.isnan(search.stated)):
            break
    whole.runs_made += part.forward.runs_made
    for k, one in enumerate(found):
        if not any(_alike(search, one, other) for other in found[:k]):
            sigma = part.estimated(one)
            yield one, np.array([sigma[part.forward.group == group][0] for group in whole.group])


def _alike(search: Search, one: Found, other: Found) -> bool:
    return bool(np.max(np.abs(one.x - other.x) / (search.high - search.low)) < ALIKE)


@dataclass
class _Solver:
    """Gauss-Newton over x and the starts of all segments."""

    forward: Shot
    sigma: Array
    x: Array
    low: Array
    high: Array
    ends: Sequence[float]  # [s] of the measured runs
    seed: int = 0
    converged: bool = True
    cornered: bool = False  # whether the least squares lie where a contact is about to begin
    scale: Array = field(default_factory=lambda: np.ones(0))
    closed: set[int] = field(default_factory=set)
    held: int | None = None  # place in x that stays

    def join(self, progress: Callable[[float], object]) -> None:
        """Join segments one by one, as long as they meet their data, until the ends of the measured runs."""
        chains, ends = self.forward.chains, self.ends
        while True:
            going = [
                i for i, chain in enumerate(chains) if i not in self.closed and not (chain and chain[-1].end >= ends[i])
            ]
            if not going:
                self.settle()
                return
            draws = self._draws()
            for i in going:
                self._add(i, chains[i][-1].end if chains[i] else 0.0, ends[i])
            self._settle_likeliest(draws)
            self._drop()
            progress(min(chain[-1].end / end if chain else 1.0 for chain, end in zip(chains, ends, strict=True)))

    def _draws(self) -> list[Array]:
        """Return places drawn from what the segments joined so far tell of x, the estimate first."""
        blocks = self._blocks() if self.forward.pieces else None
        if blocks is None:
            return [self.x]
        told, k = np.asarray(np.linalg.qr(self._condensed(blocks)[1], mode="r")), len(self.x)
        normal = np.random.default_rng(self.seed).normal(size=(DRAWS, k)) * np.resize(WIDTHS, DRAWS)[:, None]
        changes = normal @ np.linalg.pinv(told[:k, :k], rcond=1e-9).T
        return [self.x, *np.clip(self.x + changes, self.low, self.high)]

    def _settle_likeliest(self, places: Sequence[Array]) -> None:
        """Settle from the place whose runs from the scene's start meet the data best."""
        costs = [self._squares(x) for x in places]
        for at in np.argsort(costs)[:FOLLOWED]:
            self.x = places[at]
            self._cut()
            self.settle(JOINING)
            if self.converged:
                return

    def _squares(self, x: Array) -> float:
        """Return the squares of the residuals of one run from the scene's start through each chain."""
        found = 0.0
        for i, chain in enumerate(self.forward.chains):
            if chain:
                rows = np.concatenate([piece.rows for piece in chain])
                told = self.forward.residual(_Piece(i, 0.0, chain[-1].end, rows, None, np.zeros(0)), x, self.sigma)
                found += math.inf if told is None else float(told[0] @ told[0])
        return found

    def _cut(self) -> None:
        """Cut the runs from the scene's start at x into segments anew, at least as far as they were followed."""
        for i, chain in enumerate(self.forward.chains):
            end, self.forward.chains[i] = chain[-1].end if chain else 0.0, []
            begin = 0.0
            while begin < end and i not in self.closed:
                self._add(i, begin, self.ends[i])
                begin = self.forward.chains[i][-1].end if self.forward.chains[i] else begin

    def _touching(self) -> bool:
        """Return whether surfaces touch where segments join: what a contact remembers is lost there."""
        for chain in self.forward.chains:
            for piece in chain[:-1]:
                run = self.forward.run_of(piece, self.x)
                if run is not None and run.model.pairs:
                    end = run.at(np.array([piece.end]))
                    if min(float(end[f"{pair}.gap"][0]) for pair in run.model.pairs) <= 0:
                        return True
        return False

    def worth(self, most: float = LIKELY) -> tuple[bool, int, float]:
        """Return whether all data are met, their number, and less their mean square over the noise.

        most    deviations of that mean square from 1
        """
        if not self.forward.pieces:
            return False, 0, -math.inf
        found = self.found()
        square, count = float(np.mean(found.residuals**2)), int(np.sum(found.used))
        met = square < 1 + most * math.sqrt(2 / count)
        return bool(np.all(found.used) and met and self.converged), count, -square

    def _add(self, i: int, begin: float, end: float) -> None:
        forward, length = self.forward, self.forward.length
        chain, states = forward.chains[i], _states(forward.observed[i].model)
        piece = _Piece(i, begin, begin, np.zeros(0, dtype=int), None, np.zeros(0))
        if chain:
            before = forward.run_of(chain[-1], self.x)
            assert before is not None
            piece.start = np.array([before.final[name] for name in states])
        joint, times = math.nan, 0
        while math.isnan(joint):  # surfaces may touch throughout: longer
            times += 1
            piece.end = min(begin + times * WINDOW[1] * length, end)
            run = forward.run_of(piece, self.x)
            piece.known.clear()
            if run is None:
                self.closed.add(i)
                return
            last = piece.end >= end
            joint = end if last else _apart(run, begin + (times - 1 + WINDOW[0]) * length)
        piece.end = joint
        if not len(self.scale):
            assert run is not None  # else it was closed
            self.scale = np.array(run.scales.state[: len(states)])
        at = forward.observed[i].at + forward.offset(i, self.x)
        inside = (at >= begin) & ((at < piece.end) | (last & (at <= piece.end)))
        piece.rows = np.flatnonzero(forward.run == i)[inside]
        coarse, fine = (
            forward.run_of(piece, self.x),
            forward.run_of(piece, self.x, max(forward.tolerance / FINER, FINEST)),
        )
        if coarse is None or fine is None:
            self.closed.add(i)
            return
        miss = np.abs([coarse.final[name] - fine.final[name] for name in states])
        piece.allowed = np.maximum(TIMES * miss, CERTAIN * forward.tolerance * self.scale)
        chain.append(piece)

    def _drop(self) -> None:
        """Take back segments whose data are not met."""
        for i, chain in enumerate(self.forward.chains):
            if len(chain) > 1 and i not in self.closed and len(chain[-1].rows):
                found = self.forward.residual(chain[-1], self.x, self.sigma)
                if found is None or not np.mean(found[0] ** 2) < JOINED:
                    chain.pop()
                    self.closed.add(i)

    def loosest(self) -> float:
        """Return the largest miss that is allowed at a joint, of the scales."""
        return float(np.max([piece.allowed / self.scale for piece in self.forward.pieces]))

    def settle(self, within: float = CONVERGED) -> None:
        """Find the least squares; where surfaces come to touch at a joint, segments are cut anew."""
        for _ in range(CUTS):
            self._settle(within)
            if not (self.converged and self._touching()):
                return
            self.converged = False
            self._cut()

    def _settle(self, within: float) -> None:
        """Take steps, relaxed and shortened, until squares fall by no more than within^2.

        Where the curvature that the least squares leave out is c times theirs, steps of x are -c times the last:
        1 / (1 + c) of one is taken, c by the last two (Aitken).
        """
        taken, share, self.cornered = np.zeros(0), 1.0, False
        for _ in range(STEPS):
            blocks = self._blocks()
            if blocks is None:
                break
            step, size = self._step(blocks)
            length, dx = self._length(step), step[0, : len(self.x)] / (self.high - self.low)
            if size < (STUCK if length < SMALL else within):
                self.converged = True
                return
            if len(taken):
                share = 1 / max(1 / LONGEST, 1 / share - float(dx @ taken) / float(taken @ taken))
                step, _ = self._step(blocks, share=share)
            part, longest = 1.0, max(length, SMALL)
            while part > SHORTEST and not self._moved(blocks, step, part, longest * (1 - min(share, 1) * part / 4)):
                part /= 2
            if part <= SHORTEST:
                fell = self._descended(step[0, : len(self.x)])
                if not fell > within**2:
                    self.converged = self.cornered = fell >= 0
                    return
                taken, share = np.zeros(0), 1.0
                continue
            share *= part
            taken = share * dx
        self.converged = False

    def _descended(self, dx: Array) -> float:
        """Go down along a change of x by runs from the scene's start, and return how far squares fell.

        Where a contact is about to begin the least squares have a corner, to whose other side slopes say nothing. nan without a run.
        """
        x, begun = self.x, self._squares(self.x)
        least, part = begun, 1.0
        for _ in range(DOWN):
            there = np.clip(x + part * dx, self.low, self.high)
            found = self._squares(there)
            if found < least:
                x, least = there, found
            else:
                part /= 2
        self.x = x
        self._cut()
        followed = bool(self.forward.pieces) and math.isfinite(begun) and abs(self.cost() - least) < SAME
        return begun - least if followed else math.nan

    def _moved(self, blocks: Sequence[_Block], step: Array, part: float, length: float) -> bool:
        """Take part of a step, unless the next one, by the same derivatives, would be longer than `length`."""
        before = self.place
        self._take(part * step)
        found = [self.forward.residual(piece, self.x, self.sigma) for piece in self.forward.pieces]
        if all(one is not None for one in found):
            later = [
                replace(block, residual=one[0], end=one[1]) for block, one in zip(blocks, found, strict=True) if one
            ]
            if self._length(self._step(later)[0]) <= length:
                return True
        self.place = before
        return False

    def _take(self, step: Array) -> None:
        self.x = np.clip(self.x + step[0, : len(self.x)], self.low, self.high)
        for piece, change in zip(self.forward.pieces, step[1:], strict=True):
            if piece.start is not None:
                piece.start = piece.start + change[: len(self.scale)] * self.scale

    @property
    def place(self) -> _Place:
        """Where it is: x, and the segments of every run with their starts."""
        return self.x, [[(piece, piece.start) for piece in chain] for chain in self.forward.chains]

    @place.setter
    def place(self, place: _Place) -> None:
        self.x = place[0]
        for i, chain in enumerate(place[1]):
            self.forward.chains[i] = [piece for piece, _ in chain]
            for piece, start in chain:
                piece.start = start

    def hold(self, j: int, at: float) -> None:
        """Settle with one entry of x held at a place, all else moved there first by the derivatives."""
        self.held, self.converged = j, False
        try:
            blocks = self._blocks()
            if blocks is not None:
                self._take(self._step(blocks, at - float(self.x[j]))[0])
                self.settle()
        finally:
            self.held = None

    def cost(self) -> float:
        """Return the squares of all residuals over the noise, and of what segments miss over what they may."""
        pieces, found = self.forward.pieces, 0.0
        for piece, after in zip(pieces, [*pieces[1:], None], strict=True):
            told = self.forward.residual(piece, self.x, self.sigma)
            if told is None:
                return math.inf
            found += float(told[0] @ told[0])
            if after is not None and after.start is not None:
                found += float(np.sum(((told[1] - after.start) / piece.allowed) ** 2))
        return found

    def slope(self, j: int) -> float:
        """Return the derivative of the least squares by an entry of x that is held; nan at a corner."""
        blocks = self._blocks()
        if blocks is None or self.cornered:
            return math.nan
        rows = self._condensed(blocks)[1]
        return -2 * float(rows[:, j] @ rows[:, -1])

    def _length(self, step: Array) -> float:
        """Return the length of a step, x over the width of its range and starts over the scales."""
        return float(np.linalg.norm(np.append(step[0, : len(self.x)] / (self.high - self.low), step[1:])))

    def _blocks(self) -> list[_Block] | None:
        found = [self.forward.linear(piece, self.x, self.sigma) for piece in self.forward.pieces]
        return None if any(block is None for block in found) else [block for block in found if block is not None]

    def _step(self, blocks: Sequence[_Block], by: float = 0.0, share: float = 1.0) -> tuple[Array, float]:
        """Return the changes of x (first row) and of all starts over scales, and how far squares fall.

        by       the change of what is held; squares fall by the square of what is returned
        share    of the change of x that is taken, which the starts follow
        """
        factors, rows = self._condensed(blocks)
        k, n = len(self.x), len(self.scale)
        moving, dx = np.array([j != self.held for j in range(k)]), np.full(k, by)
        if np.any(moving):
            rest = rows[:, k] - by * (rows[:, :k] @ ~moving)
            dx[moving] = np.linalg.lstsq(rows[:, :k][:, moving], rest, rcond=1e-12)[0]
        fall = [
            float(np.linalg.norm(rows[:, :k] @ dx)),
            *(float(np.linalg.norm(f[:, -1])) for f in factors if f is not None),
        ]
        dx *= share
        step = np.zeros((1 + len(blocks), max(n, k)))
        step[0, :k] = dx
        for j, factor in enumerate(factors):
            if factor is not None:
                right = factor[:, -1] - factor[:, n : 2 * n] @ step[j, :n] * (j > 0 and factors[j - 1] is not None)
                step[1 + j, :n] = np.linalg.solve(factor[:, :n], right - factor[:, 2 * n : -1] @ dx)
        return step, math.hypot(*fall)

    def _condensed(self, blocks: Sequence[_Block]) -> tuple[list[Array | None], Array]:
        """Return the factor of every start, (start, start before, x, right side), and rows (m, k + 1) of x."""
        n, k = len(self.scale), len(self.x)
        factors: list[Array | None] = []
        rest = np.zeros((0, k + 1))
        carry = np.zeros((0, n + k + 1))  # of (start, x, right side), from the segments after
        pieces = self.forward.pieces
        for j in reversed(range(len(pieces))):
            piece, block = pieces[j], blocks[j]
            if piece.start is None:
                rest = np.vstack([rest, np.hstack([block.by_x, -block.residual[:, None]]), carry[:, n:]])
                carry = np.zeros((0, n + k + 1))
                factors.append(None)
                continue
            before, weights = blocks[j - 1], 1 / pieces[j - 1].allowed[:, None]
            first = pieces[j - 1].start is None
            to_before = np.zeros((n, n)) if first else before.end_by_start * self.scale
            own = np.hstack([block.by_start * self.scale, block.by_x, -block.residual[:, None]])
            inner = np.vstack([carry, own])
            inner = np.hstack([inner[:, :n], np.zeros((len(inner), n)), inner[:, n:]])
            miss = (before.end - piece.start)[:, None]
            joint = weights * np.hstack([-np.diag(self.scale), to_before, before.end_by_x, -miss])
            r: Array = np.asarray(np.linalg.qr(np.vstack([joint, inner]), mode="r"))
            factors.append(r[:n])
            carry = r[n:, n:]
        return factors[::-1], rest

    def found(self) -> Found:
        """Return the place with residuals, and the factor of what all segments tell of x as their Jacobian."""
        forward, k = self.forward, len(self.x)
        used = np.zeros(len(forward.measured), dtype=bool)
        used[np.concatenate([piece.rows for piece in forward.pieces])] = True
        residual = ((forward.measured - forward.at(self.x).predicted) / self.sigma)[used]
        blocks = self._blocks()
        told = np.zeros((k, k))
        if blocks is not None:
            told = np.asarray(np.linalg.qr(self._condensed(blocks)[1], mode="r"))[:k, :k]
        missed = self.cost() - float(residual @ residual)
        return Found(self.x, used, self.sigma, residual, told, self.converged and blocks is not None, missed)


@dataclass(frozen=True)
class _Held:
    """Least squares with an entry of x held: where, what is there, and their derivative by it."""

    place: _Place
    found: Found
    slope: float


class Segments(Search):
    """Search at the least squares of all segments, which least squares with a quantity held begin from."""

    followed_only = True

    def __init__(self, solver: _Solver, stated: Array) -> None:
        super().__init__(solver.forward, stated)
        self._solver, self._known = solver, dict[int, dict[float, _Held]]()

    def begin(self) -> None:
        """Take the place of the solver as the least, and refuse intervals where it does not meet all data."""
        solver = self._solver
        self._known = {j: {float(x): self._here(j)} for j, x in enumerate(solver.x)}
        if not solver.worth(MET)[0]:
            self.refused = (
                "the segments that were found do not meet all data: other lengths of them, or a shorter record"
            )

    def least(
        self, x: Array, used: NDArray[np.bool_], sigma: Array, *, fixed: int | None = None, within: float = CONVERGED
    ) -> Found:
        """Return the least squares with one entry of x held, followed from the nearest place where it was."""
        if fixed is None:
            raise ValueError("segments are fitted by their solver")
        solver, before = self._solver, self._solver.place
        try:
            return self._followed(fixed, float(x[fixed]))
        finally:
            solver.place, solver.converged = before, True

    def _followed(self, j: int, to: float) -> Found:
        """Walk to a place of one entry of x, all else fitted anew, and return what is found there.

        Within a step the squares rise as their slopes at its ends say: else it was onto another branch, and is halved.
        """
        solver, known = self._solver, self._known[j]
        at = min(known, key=lambda other: abs(other - to))
        step = to - at
        finest = abs(step) / HALVINGS
        while at != to:
            there = to if abs(step) >= abs(to - at) * (1 - 1e-9) else at + step
            here = known[at]
            solver.place = here.place
            solver.hold(j, there)
            after = self._here(j)
            jump = after.found.cost - here.found.cost - (there - at) * (here.slope + after.slope) / 2
            if (not solver.converged or abs(jump) > SMOOTH) and abs(step) > finest:
                step /= 2
                continue
            if not solver.converged:
                return after.found
            known[there], at = after, there
            step *= 2
        return known[at].found

    def _here(self, j: int) -> _Held:
        return _Held(self._solver.place, self._solver.found(), self._solver.slope(j))


def _states(model: Model) -> tuple[str, ...]:
    return (*model.coordinates, *model.speeds)


def _apart(run: Solution, earliest: float) -> float:
    """Return the time [s] after another at which surfaces are farthest apart; nan where one touches."""
    middles = (run.t[1:] + run.t[:-1]) / 2  # of steps: a flight may be one
    later = middles[middles >= earliest]
    if not len(later):
        return math.nan
    history = run.at(later)
    gaps = np.min([history[f"{pair}.gap"] for pair in run.model.pairs], axis=0) if run.model.pairs else later
    best = int(np.argmax(gaps))
    return float(later[best]) if gaps[best] > 0 else math.nan


def _chosen(forward: Forward, x: Array) -> float:
    """Return the time [s] in which a change of the start grows by `GROWTH`, at most half of a run."""
    lengths = []
    for each, run in zip(forward.observed, forward.at(x).runs, strict=True):
        if run is None:
            continue
        states = _states(each.model)
        bound = each.model.bind(parameters_of(run, each.model))
        of = Sensitivities(run.history, bound, {}, states, begin=np.eye(len(states)))
        scale = run.scales.state[: len(states)]
        t = run.t[run.t < of.until]
        size = np.max(
            [np.max(np.abs(of.along(t, name)) * scale / s, axis=1) for name, s in zip(states, scale, strict=True)],
            axis=0,
        )
        grown = np.flatnonzero(size > GROWTH)
        if len(grown):
            rate = math.log(float(np.max(size))) / max(float(t[int(np.argmax(size))]), float(t[grown[0]]))
            lengths.append(math.log(GROWTH) / rate)
        lengths.append(float(np.max(each.at)) / 2)
    return min(lengths)
