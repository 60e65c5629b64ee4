"""Results from all accepted steps of a run, kept or not: contacts, energy balance, choices, sums.

They are found block by block as the run proceeds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Protocol, TypeVar

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.host.lazy import cached_property
from hertzwerk.runtime.solution.choices import Choice, Choices
from hertzwerk.runtime.solution.impacts import Contacts, Impact
from hertzwerk.runtime.solution.sums import Summing, Sums

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History


INTERVALS = 240  # with sums, of a run that has no period
MOST_INTERVALS = 10_000  # most intervals with sums


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
        booked = (
            np.sum([block[name] for name in block.model.memory if name.endswith(end)], axis=0) + np.zeros(len(block.t))
            for end in (".dissipated", ".input")
        )
        parts = np.array([*block.energies, *booked])
        self._finite = self._finite and bool(np.all(np.isfinite(parts)))
        if not self._finite:
            return
        if self._start is None:
            self._start = parts[:, :1]
            self._scale = block.energy_scale
            self._largest = SMALL * self._scale
        kinetic, *_ = parts
        self._rows += len(block.t) - fresh
        self._size = max(self._size, float(np.max(np.abs(parts))))
        change = parts - self._start
        self._largest = max(self._largest, float(np.max(kinetic)), float(np.max(np.abs(change[1:]))))
        self._error = max(self._error, float(np.max(np.abs(change[0] + change[1] + change[2] - change[3]))))

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

    Found as the run proceeds, or, where steps are kept, on demand (`later`).

    duration, begin    end and start of the run [s]
    period    of everything that depends on time [s], None where nothing does
    """

    def __init__(
        self, model: Model, method: str, *, later: bool, duration: float, period: float | None, begin: float = 0.0
    ) -> None:
        self._model, self._later, self._duration, self._begin, self.period = model, later, duration, begin, period
        self._steps: list[History] = []
        self._contacts = Contacts(model)
        self._balance = Balance() if model.has_ledger else None
        self._choices = Choices() if method == "auto" else None
        self._summing = None if later else self._new_sums(None)

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
        findings = cls(model, "", later=True, duration=math.nan, period=period)
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

    def _observed(self, observer: Seen) -> Seen:
        for block in self._steps:
            observer.take(block, 0)
        return observer

    @cached_property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        return self._observed(self._contacts).impacts()

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

    @cached_property
    def _sums(self) -> Sums:
        return self._observed(self._new_sums(None)).sums if self._summing is None else self._summing.sums

    def _new_sums(self, interval: float | None) -> Summing:
        begin, until = self._begin, float(self._steps[-1].t[-1]) if self._steps else 0.0
        if until <= begin:
            until = self._duration  # of a run without a step as well: its sums are of no interval
        if interval is None:
            span = until - begin
            periods = 0.0 if self.period is None else span / self.period
            interval = span / INTERVALS if self.period is None else self.period * math.ceil(periods / MOST_INTERVALS)
        return Summing(self._model, interval, until, begin)
