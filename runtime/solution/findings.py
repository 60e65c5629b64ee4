"""Results from all accepted steps of a run, kept or not: contacts, energy balance, choices, sums.

They are found block by block as the run proceeds.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Protocol, TypeVar

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.host.lazy import cached_property
from hertzwerk.runtime.solution.choices import Choice, Choices
from hertzwerk.runtime.solution.history import energies_of, part_of_step, rowwise
from hertzwerk.runtime.solution.impacts import Contacts, Impact, crest
from hertzwerk.runtime.solution.sums import Summing, Sums, inner

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.caller import Rowwise
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History


INTERVALS = 240  # with sums, of a run that has no period
MOST_INTERVALS = 10_000  # most intervals with sums


class Needs(enum.Flag):
    """Parts of a run that are wanted beside its ends and, where it is booked, its balance of energy."""

    ENDS = 0
    IMPACTS = enum.auto()
    SUMS = enum.auto()  # over intervals
    CHOICES = enum.auto()  # of method
    STEPS = enum.auto()  # every one kept: the others follow from them


EVERYTHING = Needs.IMPACTS | Needs.SUMS | Needs.CHOICES


def finders(model: Model, integrator: Integrator, needs: Needs) -> list[Rowwise]:
    """Return the functions that find what is needed in runs by the integrator's first method."""
    found = [energies_of(model, integrator)] if model.has_ledger else []
    if needs & (Needs.IMPACTS | Needs.STEPS):
        found += [crest(model, integrator, 0), part_of_step(model, integrator, 0), rowwise(model, "outputs", 3)]
    if needs & (Needs.SUMS | Needs.STEPS):
        found += [part_of_step(model, integrator, 0), *(inner(model, j) for j in range(model.k))]
    return list(dict.fromkeys(found))


class Observer(Protocol):
    """Receiver of every accepted step of a run, in order."""

    def take(self, block: History, fresh: int) -> None:
        """Take the rows of `block` from `fresh` on.

        Before them stand the last two rows of the block before, if there was one.
        """


Seen = TypeVar("Seen", bound=Observer)


EPSILON = float(np.finfo(float).eps)
SMALL = 1e-6  # of the scene's energy scale: least energy that errors are relative to


class Balance:
    """Observer of the energy balance: energy - initial energy + dissipated - input should stay zero.

    Measured by the energy that the run moves: the largest kinetic energy, energy dissipated or put in, or change of
    potential energy. The total energy is no measure, since the zero of the potential is arbitrary.
    """

    def __init__(self) -> None:
        self._start: np.ndarray | None = None
        self._largest = self._error = self._scale = self._size = 0.0
        self._rows = 0
        self._finite = True

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        parts = block.balance
        size = float(np.abs(parts).max())
        self._finite = self._finite and math.isfinite(size)
        if not self._finite:
            return
        if self._start is None:
            self._start = parts[:, :1]
            self._scale = block.energy_scale
            self._largest = SMALL * self._scale
        self._rows += len(block.rows) - fresh
        self._size = max(self._size, size)
        kinetic, potential, dissipated, given = change = parts - self._start
        self._largest = max(self._largest, float(parts[0].max()), float(np.abs(change[1:]).max()))
        self._error = max(self._error, float(np.abs(kinetic + potential + dissipated - given).max()))

    @property
    def residual(self) -> float | None:
        """Return the largest error over the largest energy moved; None where something was not finite."""
        return self._error / self._largest if self._finite and self._largest > 0 else None

    @property
    def unclosed(self) -> float:
        """Return the largest error beyond rounding over the largest energy moved or the scene's energy scale.

        The larger of the two: a run's accuracy is relative to its scales, however little moves. 0 where something was
        not finite, which ends a run by itself.
        """
        measure = max(self._largest, self._scale)
        # of energies that are large because their zero is far, and of sums over steps
        rounding = EPSILON * self._rows * self._size
        return max(self._error - rounding, 0.0) / measure if self._finite and measure > 0 else 0.0


class Findings:
    """Impacts, energy residual, choices and sums of a run.

    Found as the run proceeds, what is needed of them, or, where steps are kept, on demand.

    duration, begin    end and start of the run [s]
    period    of everything that depends on time [s], None where nothing does
    """

    def __init__(
        self,
        model: Model,
        method: str,
        *,
        needs: Needs,
        duration: float,
        period: float | None,
        begin: float = 0.0,
    ) -> None:
        self._model, self._duration, self._begin, self.period = model, duration, begin, period
        self._later = Needs.STEPS in needs
        self._needs = EVERYTHING if self._later else needs
        self._steps: list[History] = []
        self._balance = Balance() if model.has_ledger else None
        self._contacts = Contacts(model) if Needs.IMPACTS in self._needs else None
        self._choices = Choices() if method == "auto" and Needs.CHOICES in self._needs else None
        self._summing = self._new_sums(None) if Needs.SUMS in needs and not self._later else None

    @classmethod
    def saved(
        cls,
        model: Model,
        impacts: Sequence[Impact],
        energy_residual: float | None,
        chosen: Sequence[Choice],
        sums: Sums,
        period: float | None,
    ) -> Findings:
        """Restore the findings of a saved run."""
        findings = cls(model, "", needs=Needs.STEPS, duration=math.nan, period=period)
        findings.impacts, findings.choices = tuple(impacts), tuple(chosen)
        findings.energy_residual, findings._sums = energy_residual, sums
        return findings

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        if self._later:
            self._steps.append(block)
            return
        for observer in (self._contacts, self._balance, self._choices, self._summing):
            if observer is not None:
                observer.take(block, fresh)

    def _needed(self, need: Needs) -> None:
        """Raise LookupError if something is asked for that was not found."""
        if need not in self._needs:
            raise LookupError(f"{need.name} of a run that was made for {self._needs}; make it for {need.name} as well")

    def _observed(self, observer: Seen) -> Seen:
        for block in self._steps:
            observer.take(block, 0)
        return observer

    @cached_property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        self._needed(Needs.IMPACTS)
        return () if self._contacts is None else self._observed(self._contacts).impacts()

    @cached_property
    def _balanced(self) -> Balance | None:
        return None if self._balance is None else self._observed(self._balance)

    @cached_property
    def energy_residual(self) -> float | None:
        """See `Solution.energy_residual`."""
        return None if self._balanced is None else self._balanced.residual

    @cached_property
    def energy_unclosed(self) -> float:
        """See `Balance.unclosed`; 0 without a ledger."""
        return 0.0 if self._balanced is None else self._balanced.unclosed

    @cached_property
    def choices(self) -> tuple[Choice, ...]:
        """See `Solution.choices`."""
        self._needed(Needs.CHOICES)
        return tuple(self._observed(self._choices).made) if self._choices is not None else ()

    def compute_all(self) -> Iterator[str]:
        """Compute everything now, replacing by nothing and reporting what fails, so that the rest is not lost."""
        nothing = Sums(math.nan, *(np.zeros((0, n)) for n in (self._model.k, self._model.k, self._model.nz)))
        for name, empty in (("impacts", ()), ("energy_residual", None), ("choices", ()), ("_sums", nothing)):
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
        if Needs.SUMS in self._needs:
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
