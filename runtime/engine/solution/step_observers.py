"""Results from all accepted steps of a run, kept or not: contacts, choices, sums.

They are found block by block as the run proceeds.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
from hertzwerk.runtime.engine.integration.loop.method_choice import EXPLICIT, IMPLICIT, STIFF
from hertzwerk.runtime.engine.integration.loop.turning_slip import PASSING
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.contact_watch import Lasting, LastingContacts, Watch, impacts_of
from hertzwerk.runtime.engine.solution.history import History, steps_of
from hertzwerk.runtime.engine.solution.impacts import Impact, crest
from hertzwerk.runtime.engine.solution.interval_sums import Summing, Sums, inner
from hertzwerk.runtime.system.lazy import cached_property

INTERVALS = 240  # with sums, of a run that has no period
MOST_INTERVALS = 10_000  # most intervals with sums


class Needs(enum.Flag):
    """Parts of a run that are wanted beside its ends."""

    ENDS = 0
    IMPACTS = enum.auto()
    SUMS = enum.auto()  # over intervals
    CHOICES = enum.auto()  # of method
    STEPS = enum.auto()  # every one kept: the others follow from them


EVERYTHING = Needs.IMPACTS | Needs.SUMS | Needs.CHOICES


def finders(model: EngineModel, integrator: Integrator, needs: Needs, *, compared: bool = False) -> list[Rowwise]:
    """Return the functions that find what is needed in runs by the integrator's first method.

    compared    whether runs are compared with others, for an accuracy
    """
    peaks = compared or bool(needs & (Needs.IMPACTS | Needs.STEPS))
    functions: list[Rowwise] = []
    if peaks and model.k:
        functions.append(crest(model, integrator, 0))
    if needs & (Needs.SUMS | Needs.STEPS):
        functions += [*steps_of(model, integrator, 0), *(inner(model, j) for j in range(model.k))]
    if compared:
        functions += steps_of(model, integrator, 0, compared=True)
    return list(dict.fromkeys(functions))


class Observer(Protocol):
    """Receiver of every accepted step of a run, in order."""

    def take(self, block: History, fresh: int) -> None:
        """Take the rows of `block` from `fresh` on.

        Before them stand the last two rows of the block before, if there was one.
        """


AnyObserver = TypeVar("AnyObserver", bound=Observer)


@dataclass(frozen=True)
class Choice:
    """Start t [s] of "explicit" or "implicit" steps, and the reason."""

    t: float
    method: str
    reason: str


class Choices:
    """Observer of the choices of `method="auto"`: the first method and every change."""

    def __init__(self) -> None:
        self.made: list[Choice] = []

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        method, stiffness, pressure = (block.part(part)[:, 0] for part in ("method", "stiffness", "pressure"))
        if not fresh:
            self.made.append(Choice(float(block.t[0]), "explicit", "runs begin with explicit steps"))
        first = max(fresh, 1)
        for i in first + np.flatnonzero(method[first:] != method[first - 1 : -1]):
            if method[i] == EXPLICIT and pressure[i] > 0:
                reason = "a singular position is near, where the Jacobian does not predict the motion beyond"
            elif method[i] == EXPLICIT:
                reason = f"step x fastest rate fell to {stiffness[i]:.2g}: implicit steps save less than they cost"
            elif pressure[i] == PASSING:
                reason = "a direction of sliding turns faster than explicit steps can follow"
            elif stiffness[i] > STIFF:
                reason = f"step x fastest rate = {stiffness[i]:.2g}: stability, not accuracy, limits explicit steps"
            elif stiffness[i] == 0:
                reason = "explicit steps were rejected repeatedly and made hardly any progress"
            else:
                reason = "step after step crossed the layer in which friction reverses: the pair sticks"
            self.made.append(Choice(float(block.t[i]), "implicit" if method[i] == IMPLICIT else "explicit", reason))


class Findings:
    """Impacts, contacts that left their law, choices and sums of a run.

    Found as the run proceeds, what is needed of them, or, where steps are kept, on demand.

    duration, begin    end and start of the run [s]
    period    of everything that depends on time [s], None where nothing does
    """

    def __init__(
        self,
        model: EngineModel,
        method: str,
        *,
        needs: Needs,
        duration: float,
        period: float | None,
        begin: float = 0.0,
    ) -> None:
        self._model, self._duration, self._begin, self.period = model, duration, begin, period
        self._later = Needs.STEPS in needs
        self.needs = EVERYTHING if self._later else needs
        self._steps: list[History] = []
        self._watch = Watch(model) if not self._later and model.k and Needs.IMPACTS in needs else None
        self._choices = Choices() if method == "auto" and Needs.CHOICES in self.needs else None
        self._lasting = LastingContacts(model) if not self._later and needs and model.latches else None
        self._summing = self._new_sums(None) if not self._later and Needs.SUMS in needs else None

    def __repr__(self) -> str:
        return f"<Findings {self._model.name}: of {self._begin:g} to {self._duration:g} s>"

    @classmethod
    def saved(
        cls,
        model: EngineModel,
        impacts: Sequence[Impact],
        chosen: Sequence[Choice],
        sums: Sums,
        period: float | None,
    ) -> Findings:
        """Restore the findings of a saved run."""
        findings = cls(model, "", needs=Needs.STEPS, duration=math.nan, period=period)
        findings.impacts, findings.choices, findings._sums = tuple(impacts), tuple(chosen), sums
        return findings

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        if self._later:
            self._steps.append(block)
            return
        for observer in (self._watch, self._choices, self._lasting, self._summing):
            if observer is not None:
                observer.take(block, fresh)

    @staticmethod
    def find_impacts(runs: Sequence[Findings]) -> None:
        """Find the impacts of runs, of all at once: of short ones each costs less."""
        alike: dict[int, list[tuple[Findings, Watch]]] = {}
        for run in runs:
            watch = None if "impacts" in vars(run) else run._watched()
            if watch is not None and (run._steps or watch.waiting):
                alike.setdefault(id(watch.view.engine), []).append((run, watch))
        for some in alike.values():
            for (run, _), impacts in zip(some, impacts_of([watch for _, watch in some]), strict=True):
                run.impacts = impacts

    def _needed(self, need: Needs) -> None:
        """Raise LookupError if something is requested that was not found."""
        if need not in self.needs:
            raise LookupError(f"{need.name} of a run that was made for {self.needs}; make it for {need.name} as well")

    def _observed(self, observer: AnyObserver) -> AnyObserver:
        for block in self._steps:
            observer.take(block, 0)
        return observer

    @cached_property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        self._needed(Needs.IMPACTS)
        watch = self._watched()
        return () if watch is None else watch.impacts()

    def _watched(self) -> Watch | None:
        """Return the observer of impacts, which has seen all steps; None of a model without pairs."""
        return self._observed(Watch(self._model)) if self._later and self._model.k else self._watch

    @cached_property
    def lasting(self) -> tuple[Lasting, ...]:
        """Every contact that left its law, none where nothing is needed of the steps."""
        if self._later and self._model.latches:
            return self._observed(LastingContacts(self._model)).contacts
        return () if self._lasting is None else self._lasting.contacts

    @cached_property
    def choices(self) -> tuple[Choice, ...]:
        """See `Solution.choices`."""
        self._needed(Needs.CHOICES)
        return tuple(self._observed(self._choices).made) if self._choices is not None else ()

    def compute_all(self) -> Iterator[str]:
        """Compute everything now, replacing by nothing and reporting what fails, so that the rest is not lost."""
        nothing = Sums(math.nan, *(np.zeros((0, n)) for n in (self._model.k, self._model.k, self._model.nz)))
        for name, empty in (("impacts", ()), ("choices", ()), ("_sums", nothing)):
            try:
                getattr(self, name)
            except Exception as error:  # whatever it is
                setattr(self, name, empty)
                yield f"{name.strip('_').replace('_', ' ')} could not be found: {type(error).__name__}: {error}"

    def sums(self, interval: float | None = None) -> Sums:
        """Return sums over intervals [s], by default of the period or of a part of the run.

        Intervals are longer where there are many. Raises InputError where steps are not kept and the interval is no
        multiple of the known ones.
        """
        if interval is not None and self._steps:
            return self._observed(self._new_sums(interval)).sums
        known = self._sums
        if interval is None:
            return known
        many = round(interval / known.interval)
        if many < 1 or abs(many * known.interval - interval) > 1e-6 * interval:
            expected = f"a multiple of {known.interval:g} s, over which a run without its steps has its sums"
            raise InputError(f"averages of {self._model.name}", [Fault("interval", f"{interval:g} s", expected)])
        return known.joined(many)

    def intervals(self, interval: float | None, reached: float) -> tuple[float, int]:
        """Return length [s] and number of the intervals of `sums`, in a run that got to a time [s]."""
        if Needs.SUMS in self.needs:
            sums = self.sums(interval)
            return sums.interval, sums.count
        length = self._interval(self._duration - self._begin) if interval is None else interval
        return length, int((reached - self._begin) / length * (1 + 1e-12))

    @cached_property
    def _sums(self) -> Sums:
        self._needed(Needs.SUMS)
        return self._observed(self._new_sums(None)).sums if self._summing is None else self._summing.sums

    def _new_sums(self, interval: float | None) -> Summing:
        begin, until = self._begin, float(self._steps[-1].t[-1]) if self._steps else 0.0
        if until <= begin:
            until = self._duration  # of a run without a step as well: its sums are of no interval
        return Summing(self._model, self._interval(until - begin) if interval is None else interval, until, begin)

    def _interval(self, span: float) -> float:
        """Return the interval [s] for a time [s]: whole periods, or a part of it."""
        if self.period is None:
            return span / INTERVALS
        return self.period * math.ceil(span / self.period / MOST_INTERVALS)
