"""Multiple shooting: measured runs in segments, whose starts are free and must meet the ends before.

Within a segment a motion is told by its start, however long the whole is in chaos.

1. joined      one by one, each begun where the one before ends, in flight: what a contact remembers is no part of a start
2. drawn       what is told so far allows other numbers of impacts: places drawn from it are tried on the next segment
3. settled     Gauss and Newton, shortened, and relaxed where curvature that they leave out makes them swing    solver, condensing
4. met         all of it from other draws, until the least squares were met several times: valleys are many and narrow
5. followed    profiles walk from there in steps within which the squares rise as their slopes say    followed_branch

Noise model: what is measured has independent normal noise; the motion has none, but for the runs' own error, which is
taken as a normal change at every joint of segments. Intervals follow from the factor that remains for the parameters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.fitting.experiment import Observed
from hertzwerk.runtime.fitting.forward import Forward
from hertzwerk.runtime.fitting.search import FEW, Found, Search
from hertzwerk.runtime.fitting.shooting.followed_branch import SegmentSearch
from hertzwerk.runtime.fitting.shooting.segments import SegmentedForward, states_of
from hertzwerk.runtime.fitting.shooting.solver import LIKELY, SAME, WINDOW, Solver
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.continuation import parameters_of
from hertzwerk.runtime.sensitivity.sensitivities import Sensitivities

Array = NDArray[np.float64]

GROWTH = 10.0  # of a change of the start within a segment that is chosen automatically
HALVED = 3  # lengths that are tried, each half of the one before, until all data are met
MORE = 1, 4, 16  # times the starts that are asked for
TRIES, MEETINGS = 8, 3  # followed at most; that end in the least
ALIKE = 0.02  # of the ranges: starts that are one


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
    first = chosen_length(whole, begin) if length is None else length
    times = np.concatenate([each.at + whole.offset(i, begin) for i, each in enumerate(whole.observed)])
    enough = float(np.sort(times)[min(FEW * len(begin), len(times)) - 1])
    ends = [float(np.max(times[whole.run == i])) for i in range(len(whole.observed))]
    tried: list[Solver] = []
    for length in (first / 2**k for k in range(HALVED)):
        if tried and tried[0].worth()[0]:
            break
        places = list(_first(search, times <= max(length * WINDOW[1], enough), starts, seed))
        for number in range(TRIES):
            found, sigma = places[number % len(places)]
            solver = Solver(SegmentedForward(whole, length), sigma, found.x, search.low, search.high, ends, number)
            solver.join(progress)
            tried = sorted([*tried, solver], key=Solver.worth, reverse=True)
            if sum(other.worth()[0] and other.cost() < tried[0].cost() + SAME for other in tried) == MEETINGS:
                break
    best = tried[0]
    best.forward.runs_made = sum(solver.forward.runs_made for solver in tried)
    if not best.forward.segments:
        fault = Fault("shooting", "no run of a first segment", "ranges within which the scene runs", "narrower ranges")
        raise InputError(f"fit of {whole.observed[0].model.name}", [fault])
    searched = SegmentSearch(best, search.stated)
    for _ in range(3 if np.any(np.isnan(search.stated)) else 0):  # noise follows residuals, and they the noise
        best.sigma = searched.estimated(best.found())
        best.settle()
    searched.begin()
    how = (
        f"linear: curvature of the least squares of multiple shooting over {len(best.forward.segments)} segments, each "
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


def chosen_length(forward: Forward, x: Array) -> float:
    """Return the time [s] in which a change of the start grows by `GROWTH`, at most half of a run."""
    lengths = []
    for each, run in zip(forward.observed, forward.at(x).runs, strict=True):
        if run is None:
            continue
        states = states_of(each.model)
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
