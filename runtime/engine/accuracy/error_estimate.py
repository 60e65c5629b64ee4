"""Error of a run, estimated by runs at falling tolerance, and the tolerance that meets a request.

The request holds for the whole run, or for its end alone. A run's error is its difference to a run at a CHECK times
smaller tolerance, and a little more for that run's own. It cannot be had for less, from looser runs: an error is the sum
of a few local errors, each amplified by the motion, and now and then they nearly cancel. Errors are proportional to the
tolerance only on average, and of two draws from one normal distribution the ratio is Cauchy distributed, within a factor
of 10 in 87 % of cases. Measured over the built-in scenes, a looser run's error scaled down is within 10 of the truth in
92 %, the difference to a tighter run in 99 % (CHECK = 10 or 5) or 97 % (3). See tests/benchmarks/honesty.py. Along whole
runs, of 30 motions at 511 tolerances, the difference to a five times tighter run is below 0.4 of the truth in 1 %, that to
a five times looser one, scaled down, in 16 %. The latter would save 13 % of a request's cost.

That difference is too small where both errors have one sign. A third run decides: it is made where the error is within
DOUBTED of the request, or farther below it where rounding in the tighter run hides more. Replayed from runs of 46 motions
at 40 tolerances, 29,680 requests: with CHECK = 8 and DOUBTED = 1.75, .8 of 1,000 are missed, by up to 1.8, and 99.5 % of
estimates are within 10 of the truth; 5 with 2.5, at the same cost, misses as many, by up to 4.7 (98.8 %), 5 with 1.5 2 of
1,000, for 3.5 % less, 8 with 1.5 1.2 of 1,000, for 1 % less. Where all three runs err alike, nothing shows
it. Two runs that take the same steps err alike: where no error holds steps down but the limit on their growth, any two
would. So each run that checks another begins with a shorter step.
Errors that are rounding are independent: where they dominate, up to two runs of nearly the same tolerance show them, beside the tighter one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any, Generic, TypeVar

import numpy as np

CHECK = 8.0  # tolerance of a run over that of the run that checks it
LEAST, LOOSEST = 1e-13, 1e-4  # tolerances of a run that is kept; looser ones chatter at contact
POINTS = 50  # equally spaced, at which runs are compared, beside steps of their own
VALID = 0.01  # of the scales: largest error of a valid trajectory
UNROUNDED = 3e-10  # tolerance down to which errors at a horizon fall with it; rounding, amplified alike, may count from there on
CARRIED = (10.0, 1000.0)  # limits of the ratio of end error to tolerance assumed for the first run
MARGIN = 6.0  # ratio of the request to the error the next run aims at: errors scatter, 90 % of such runs meet it
DOUBTED = 1.75  # ratio of the request to the error below which a third run confirms it
SCATTERED = 2.0  # ratio of a third run's error to what is expected of it, as errors scatter, that is allowed for
HALVED = 4.0  # spacing of doubles over the mean rounding error
IN_VAIN = 10.0  # times the request: error expected at the least tolerance above which the search ends (errors scatter)
# factor by which the tolerance fell, from which on an error that fell by less than its power FALLS no longer falls, where rounding
# dominates: elsewhere that is chance, as errors scatter, and beyond the horizon usual, as none exceeds the scales
STUCK = 100.0
FALLS = 1 / 3
SLACK = 3.0  # factor by which a tighter run may get farther than the fitted growth says (errors grow intermittently)
PER_STEP = 4.0  # rounding error of a step, in roundings of the state; the motion amplifies it as it does the tolerance
# where rounding dominates two runs may agree by chance: their error may exceed their difference by this factor
HIDDEN = 4.0
NEAR = 1.5  # times the tolerance of a run: that of a comparison run with independent rounding
# of errors that are rounding, one exceeds this times its largest difference to three others, and the request that allows so much, once in 500 times
INDEPENDENT = 2.0
ROUNDED = 1 + HIDDEN / 2  # rounding error equal to the tolerance
MORE = 5.0  # most steps of a tighter comparison run over those of the run; usual are 1.2 to 1.4
MORE_ROUNDED = 2.0  # the same where rounding dominates
DETECTABLE = 1e-3  # of the tolerance: smaller differences of two runs are rounding


@dataclass(frozen=True, repr=False)
class ErrorEstimate:
    """Error of a run in the scene's scales (`scales.error`), by comparison with tighter runs.

    worst         largest error along the run, never below 1e-13, at the time `when` [s]; nan where no tighter run reached the end
    end           error at the end of the run, as `worst`
    at_end        whether the end alone was to meet the request
    times, values (n,)   error along the run, times [s], as far as both runs got
    parts         largest difference of each coordinate, speed and normal force along the run, but for the shift in time, in SI
    horizon       time [s] up to which the error stays within 1 % of the scales; None: the whole run. A single time of `times` above is ignored
    growth        rate [1/s] of the error up to the horizon: the slope of its logarithm
    decade_cost   factor of evaluations for a tolerance, and so on average an error, ten times smaller
    floor         least error that was found, or is expected, at any tolerance, where none seems to meet the request
    runs          runs made, this one included; pilot_s the time [s] that the others took
    """

    end: float
    at_end: bool
    times: np.ndarray
    values: np.ndarray
    parts: Mapping[str, float]
    horizon: float | None
    growth: float | None
    decade_cost: float | None
    floor: float | None
    runs: int
    pilot_s: float

    @property
    def worst(self) -> float:
        """Largest error along the run; nan where it is not known to the end."""
        return max(float(np.max(self.values)), self.end) if self.known else math.nan

    @property
    def when(self) -> float:
        """Time [s] of the largest error that is known."""
        return float(self.times[np.argmax(self.values)])

    @property
    def judged(self) -> float:
        """Error that the request is for: the largest, or that at the end."""
        return self.end if self.at_end else self.worst

    @property
    def known(self) -> bool:
        """Return whether the error is known up to the end."""
        return math.isfinite(self.end)

    def of(self, history: str) -> float:
        """Return the largest error of a coordinate, a speed or a normal force along the run, in SI.

        A shift in time, as of an impact that is a nanosecond late, is not in it. Raises KeyError for another name.
        """
        if history not in self.parts:
            raise KeyError(f"no error of {history!r} is known; known are those of {', '.join(self.parts)}")
        return self.parts[history]

    @property
    def numbers(self) -> dict[str, Any]:
        """All fields as lists and plain numbers."""
        return {
            **vars(self),
            "times": self.times.tolist(),
            "values": self.values.tolist(),
            "parts": dict(self.parts),
        }

    @classmethod
    def from_numbers(cls, numbers: Mapping[str, Any]) -> ErrorEstimate:
        """Restore an estimate from `numbers`."""
        return cls(**{**numbers, "times": np.array(numbers["times"]), "values": np.array(numbers["values"])})

    def __str__(self) -> str:
        if not self.known:
            return f"unknown after t = {self.times[-1]:.4g} s"
        if self.worst <= LEAST:
            return f"below {brief(LEAST)}"
        return f"{brief(self.worst, 2)} at t = {self.when:.4g} s, {brief(self.end, 2)} at the end"

    def __repr__(self) -> str:
        return f"<ErrorEstimate {self}>"


def brief(error: float, digits: int = 1) -> str:
    """Format an error with few digits: 4e-7."""
    return f"{error:.{digits}g}".replace("e-0", "e-")


def beyond_horizon(error: ErrorEstimate) -> str:
    """Explain for what a run longer than its horizon is still valid."""
    grow = "" if error.growth is None else f"; errors grow at {error.growth:.3g}/s"
    return (
        f"the run is longer than its horizon: use run.averages() beyond t = {error.horizon:.4g} s. Only statistics are valid there; the "
        f"trajectory has an error below {VALID:.0%} of the scales until then{grow}"
    )


def reach(error: ErrorEstimate, tolerance: float, requested: float) -> float | None:
    """Return the time [s] up to which a smaller tolerance is expected to meet a request.

    Errors are as tolerances, down to where rounding may count.
    """
    return horizon(error.times, error.values, min(requested * max(tolerance / UNROUNDED, 1.0), VALID))


class End(Enum):
    """End of one run: reached; failed, perhaps not at another tolerance; stopped by a limit or the user."""

    REACHED = "reached"
    FAILED = "failed"
    STOPPED = "stopped"


Data = TypeVar("Data")


@dataclass(frozen=True)
class Rung(Generic[Data]):
    """One run of the ladder: tolerance, end, states (n, ny) at times (n,) [s], cost, kept data.

    The times are its own, as far as it got, or the first of those of the run that it checks.
    """

    tolerance: float
    end: End
    times: np.ndarray
    states: np.ndarray
    steps: int
    evaluations: int
    wall_s: float
    data: Data


class Verdict(Enum):
    """Outcome of a request for an error."""

    MET = "met"
    UNREACHABLE = "unreachable"  # by any tolerance, although the trajectory is valid to the end
    BEYOND = "beyond"  # the run is longer than its horizon
    UNKNOWN = "unknown"  # no run to compare with, or the run itself failed
    STOPPED = "stopped"


@dataclass(frozen=True)
class LadderResult(Generic[Data]):
    """Result of a ladder: the run to return, its error, the verdict.

    incomplete: another run that was stopped, failed, or was given up during the search.
    foreseen: no run was made at the least tolerance, whose error is the floor of the estimate.
    """

    run: Rung[Data]
    error: ErrorEstimate | None
    verdict: Verdict
    incomplete: Rung[Data] | None = None
    foreseen: bool = False


def first_tolerance(requested: float, seconds: float, length: float, speed: float) -> float:
    """Return the local tolerance of the first run.

    A speed error of one tolerance, carried along for the whole run, makes a length error of seconds * speed / length
    tolerances.
    """
    carried = min(max(seconds * speed / length, CARRIED[0]), CARRIED[1])
    return min(max(requested / carried, LEAST), LOOSEST)


@dataclass(frozen=True)
class _Checked(Generic[Data]):
    """A run and its differences (n, m) along its times, as far as the comparison runs got.

    The first column is its error. last: tighter runs fail.
    """

    run: Rung[Data]
    differences: np.ndarray
    whole: bool
    last: bool

    @property
    def values(self) -> np.ndarray:
        """Error along the run (n,)."""
        return self.differences[:, 0]

    @property
    def times(self) -> np.ndarray:
        """Times [s] of the values (n,)."""
        return self.run.times[: len(self.differences)]

    def error(self, *, at_end: bool) -> float:
        """Return the error that a request is for; nan where it is not known."""
        # at rest runs agree to more digits than are true
        size = float(self.values[-1] if at_end else np.max(self.values))
        return max(size, LEAST) if self.whole else math.nan


class Ladder(Generic[Data]):
    """Search by runs at falling tolerance until one meets a requested error.

    run       makes a run, given its tolerance, None or the run that it checks and how many check that already, and the number of steps
              after which it is given up as failed
    differ    differences (n, m) of the first n states of a run from those of another that checks it, the first column their error
    rounding  one rounding of states (n, ny), as an error
    end       of the run [s]
    asked     requested error
    at_end    whether it is requested at the end alone
    names     of the other columns
    """

    def __init__(
        self,
        run: Callable[[float, tuple[Rung[Data], int] | None, float], Rung[Data]],
        differ: Callable[[Rung[Data], Rung[Data], int], np.ndarray],
        rounding: Callable[[np.ndarray], float],
        end: float,
        requested: float,
        *,
        at_end: bool = False,
        names: Sequence[str] = (),
    ) -> None:
        self._run, self._differ, self._rounding, self._end, self._requested = run, differ, rounding, end, requested
        self._at_end, self._names = at_end, names
        self._costs: list[tuple[float, int]] = []  # tolerances and evaluations of the runs that reached the end
        self._runs, self._wall_s = 0, 0.0
        self._errors: list[tuple[float, float]] = []  # tolerances and errors
        self._foreseen = math.inf  # error expected of the least tolerance, where it is not tried
        self._abandoned_check: Rung[Data] | None = None  # that was to check the last run
        self._least = LEAST  # tolerance that is worth a run: by so much the start is off already, as it is rounded

    def search(self, tolerance: float) -> LadderResult[Data]:
        """Search from an initial tolerance."""
        best: _Checked[Data] | None = None
        while True:
            run = self._make(tolerance)
            if run.end is End.FAILED:
                failed, run = run, self._make(run.tolerance / CHECK)
                if run.end is End.FAILED:  # not for its tolerance, then
                    farther = run if len(run.states) >= len(failed.states) else failed
                    check = self._make(farther.tolerance / CHECK, (farther, 0))
                    return self._result(best or self._checked(farther, check), Verdict.UNKNOWN, run)
            if run.end is End.STOPPED:
                return (
                    LadderResult(run, None, Verdict.STOPPED)
                    if best is None
                    else self._result(best, Verdict.STOPPED, run)
                )
            self._least = max(LEAST, self._rounding(run.states[:1]) / HALVED)
            comparisons = self._comparison_runs(run)
            checked = self._checked(run, *comparisons)
            error = self._error(checked)
            third = self._third_run(error, run, comparisons)
            if third is not None:
                comparisons.append(third)
                if third.end is not End.FAILED:
                    checked = self._confirmed(run, *comparisons)
                    error = self._error(checked)
            if not math.isfinite(error):
                verdict = Verdict.STOPPED if comparisons[-1].end is End.STOPPED else Verdict.UNKNOWN
                return self._result(best or checked, verdict, comparisons[-1])
            self._errors.append((run.tolerance, error))
            if best is None or error < self._error(best) or self._error(best) > VALID:  # above VALID its size is chance
                best = checked
            decision = self._verdict(checked)
            if decision is Verdict.BEYOND and self._error(best) <= VALID:  # chance: the best run stays valid to its end
                decision = Verdict.UNREACHABLE
            if decision is not None:
                return self._result(best, decision, self._abandoned_check if checked.last else None)
            tolerance = max(run.tolerance * self._requested / (MARGIN * error), self._least)

    def _error(self, checked: _Checked[Data]) -> float:
        return checked.error(at_end=self._at_end)

    def _comparison_runs(self, run: Rung[Data]) -> list[Rung[Data]]:
        """Make the runs that estimate the error of one: a tighter one, or one of nearly the same tolerance.

        The latter where a tighter run fails, or where rounding dominates: there two runs may agree by chance, and
        tighter ones are paid for with steps that rounding rejects.
        """
        rounded = self._rounding_factor(run) > ROUNDED
        check = run
        for i in range(1 if rounded else 2):
            check = self._make(  # far below the least tolerance no step may be accepted
                max(check.tolerance / CHECK, min(LEAST, run.tolerance / 2)),
                (run, i),
                most=(MORE_ROUNDED if rounded else MORE) * run.steps,
            )
            if check.end is not End.FAILED:
                break
        if check.end is End.STOPPED or (check.end is End.REACHED and not rounded):
            return [check]
        near = self._make(run.tolerance * NEAR, (run, 1))
        if near.end is not End.REACHED:
            return [check]
        self._abandoned_check = check
        return [check, near] if check.end is End.REACHED else [near]

    def _make(
        self, tolerance: float, checks: tuple[Rung[Data], int] | None = None, most: float = math.inf
    ) -> Rung[Data]:
        run = self._run(tolerance, checks, most)
        self._runs, self._wall_s = self._runs + 1, self._wall_s + run.wall_s
        if run.end is End.REACHED and run.evaluations:  # SUNDIALS' are not counted
            self._costs.append((tolerance, run.evaluations))
        return run

    def _checked(self, run: Rung[Data], *others: Rung[Data]) -> _Checked[Data]:
        n = min(len(each.states) for each in (run, *others))
        differences = np.zeros((n, 1))
        for other in others:
            part = abs(1 - other.tolerance / run.tolerance)  # of the error that shows, if errors are as tolerances
            unseen = self._rounding_factor(run) if other.tolerance < run.tolerance else 1.0
            differences = np.maximum(differences, self._differ(run, other, n) / part * unseen)
        whole = all(each.end is End.REACHED for each in (run, *others))
        return _Checked(run, differences, whole, whole and all(other.tolerance > run.tolerance for other in others))

    def _third_run(self, error: float, run: Rung[Data], comparisons: Sequence[Rung[Data]]) -> Rung[Data] | None:
        """Make a third run where it may change the verdict; None elsewhere.

        A tighter one or, where rounding dominates, one nearby. It doubts an error within the request that two runs may share, or one
        beyond it that may be hidden rounding for the most.
        """
        check, *near = comparisons
        if check.end is not End.REACHED or check.tolerance > run.tolerance:
            return None
        if near:
            beyond = self._requested < error <= self._requested * ROUNDED
            return self._make(run.tolerance * NEAR**2, (run, 2)) if beyond else None
        hidden = self._rounding_factor(check)  # what of its error is rounding does not fall with its tolerance
        if not self._requested < DOUBTED * error * hidden / self._rounding_factor(run) or error > self._requested:
            return None
        if hidden > ROUNDED:
            return self._make(run.tolerance * NEAR, (run, 1))
        return self._make(check.tolerance / CHECK, (run, 1), most=MORE * run.steps)

    def _confirmed(self, run: Rung[Data], *others: Rung[Data]) -> _Checked[Data]:
        """Bound the error of a run by the third that compares with it.

        By its difference to a tighter third run and twice the error of that, taken from the comparison run's, as errors are
        proportional to tolerances, but for their scatter; where rounding dominates, by differences to independent runs.
        """
        *_, check, third = others
        if third.tolerance > run.tolerance and len(others) == 2:
            return self._checked(run, *others)
        n = min(len(each.states) for each in (run, *others))
        if third.tolerance > run.tolerance:
            bound = INDEPENDENT * np.max([self._differ(run, other, n) for other in others], axis=0)
        else:
            of_run, of_check = (self._differ(each, third, n) for each in (run, check))
            bound = (of_run + SCATTERED * of_check / (CHECK - 1)) * self._rounding_factor(run)
        return _Checked(run, bound, third.end is End.REACHED, last=False)

    def _rounding_factor(self, run: Rung[Data]) -> float:
        """Return the factor by which rounding may hide error from a comparison with a tighter run.

        1 without rounding, up to 1 + HIDDEN where all is rounding.
        """
        rounding = PER_STEP * self._rounding(run.states)
        return 1 + HIDDEN * rounding / (rounding + run.tolerance)

    def _verdict(self, checked: _Checked[Data]) -> Verdict | None:
        """Return the outcome of the request; None where a smaller tolerance may meet it."""
        tolerance, error, least = checked.run.tolerance, self._error(checked), self._least
        if error <= self._requested:
            return Verdict.MET
        times = checked.times
        valid = horizon(times, checked.values)
        foreseen = error * least / tolerance
        lost = valid is not None and error > VALID  # its size then says nothing about smaller tolerances
        rounded = self._rounding_factor(checked.run) > ROUNDED
        stuck = rounded and any(
            before >= STUCK * tolerance and error > earlier * (tolerance / before) ** FALLS
            for before, earlier in self._errors
        )
        if stuck or tolerance <= least or (checked.last and rounded):
            return Verdict.BEYOND if lost else Verdict.UNREACHABLE
        if valid is None or not lost:
            if foreseen <= IN_VAIN * self._requested:
                return None
            self._foreseen = foreseen
            return Verdict.UNREACHABLE
        rate = growth(times, checked.values, tolerance)
        farther = math.inf if rate is None or rate <= 0 else math.log(tolerance / least) / rate
        in_vain = foreseen > self._requested or valid + SLACK * farther < self._end
        return Verdict.BEYOND if in_vain else None

    def _result(
        self, checked: _Checked[Data], verdict: Verdict, incomplete: Rung[Data] | None = None
    ) -> LadderResult[Data]:
        times = checked.times
        in_vain = verdict is Verdict.UNREACHABLE or (verdict is Verdict.UNKNOWN and self._errors)
        reached = min((value for _, value in self._errors), default=math.inf)
        error = ErrorEstimate(
            end=checked.error(at_end=True),
            at_end=self._at_end,
            times=times,
            values=checked.values,
            parts=dict(zip(self._names, checked.differences[:, 1:].max(axis=0).tolist(), strict=True)),
            horizon=horizon(times, checked.values),
            growth=growth(times, checked.values, checked.run.tolerance),
            decade_cost=decade_cost(self._costs),
            floor=min(reached, self._foreseen) if in_vain else None,
            runs=self._runs,
            pilot_s=self._wall_s - checked.run.wall_s,
        )
        return LadderResult(checked.run, error, verdict, incomplete, foreseen=self._foreseen < reached)


def horizon(times: np.ndarray, values: np.ndarray, limit: float = VALID) -> float | None:
    """Return the time [s] up to which the error stays within a limit; None if it does throughout.

    A single time of the grid above the limit is ignored, except at the end.
    """
    if len(values) < 2:
        return None
    neighbours = np.maximum(np.append(values[1:], np.inf), np.insert(values[:-1], 0, np.inf))
    lost = np.minimum(values, neighbours) > limit
    return float(times[max(int(np.argmax(lost)) - 1, 0)]) if np.any(lost) else None


def growth(times: np.ndarray, values: np.ndarray, tolerance: float) -> float | None:
    """Return the slope [1/s] of the error's logarithm up to the horizon; None if too little is known."""
    valid = horizon(times, values)
    usable = (values > DETECTABLE * tolerance) & (times <= (math.inf if valid is None else valid))
    if np.count_nonzero(usable) < 8:
        return None
    return _slope(times[usable], np.log(values[usable]))


def decade_cost(made: Sequence[tuple[float, int]]) -> float | None:
    """Return the factor of evaluations for a ten times smaller tolerance, from (tolerance, evaluations).

    Errors are proportional to the tolerance on average; those of single runs scatter too much for a ratio.
    """
    if len({tolerance for tolerance, _ in made}) < 2:
        return None
    tolerances, evaluations = np.log10(np.array(made)).T
    return 10 ** -_slope(tolerances, evaluations)


def _slope(x: np.ndarray, y: np.ndarray) -> float:
    """Return the slope of the straight line of least squares through points x, y (n,)."""
    off = x - np.mean(x)
    return float(off @ y / (off @ off))
