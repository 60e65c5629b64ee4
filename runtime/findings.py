"""What is found of all accepted steps of a run as it goes, block by block, whether or not they are kept: contacts, energy balance, choices."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Protocol, TypeVar

import numpy as np

from hertzwerk.runtime.impacts import Contacts, Impact
from hertzwerk.runtime.integrate.choose import Choice, choices

if TYPE_CHECKING:
    from hertzwerk.runtime.history import History
    from hertzwerk.runtime.model import Model


class Observer(Protocol):
    """Sees every accepted step of a run, in order."""

    def take(self, block: History, fresh: int) -> None:
        """The next rows, those of `block` from `fresh` on; before them stand the last two rows of the block before, if there was one."""


Seen = TypeVar("Seen", bound=Observer)


SMALL = 1e-6  # part of the scene's energy scale that an error is measured by where a run moves less energy


class Balance:
    """Whether energy - initial energy + dissipated - input stays zero.

    Measured by the energy that the run moves: the largest kinetic energy, energy dissipated or put in, or change of potential energy. The total
    energy is no measure, since where the potential is zero is a matter of choice.
    """

    def __init__(self) -> None:
        self._start: np.ndarray | None = None
        self._largest = self._error = 0.0
        self._finite = True

    def take(self, block: History, fresh: int) -> None:
        """The next accepted steps; see `Observer`."""
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
            self._largest = SMALL * block.energy_scale
        kinetic, *_ = parts
        change = parts - self._start
        self._largest = max(self._largest, float(np.max(kinetic)), float(np.max(np.abs(change[1:]))))
        self._error = max(self._error, float(np.max(np.abs(change[0] + change[1] + change[2] - change[3]))))

    @property
    def residual(self) -> float | None:
        """Largest error over the largest energy moved; None where something was not finite."""
        return self._error / self._largest if self._finite and self._largest > 0 else None


class Choices:
    """What `method="auto"` chose."""

    def __init__(self) -> None:
        self.made: list[Choice] = []

    def take(self, block: History, fresh: int) -> None:
        """The next accepted steps; see `Observer`."""
        self.made += choices(block, fresh)


class Findings:
    """Impacts, energy residual and choices of a run: found as it goes, or, of steps that are kept, when asked for (`later`)."""

    def __init__(self, model: Model, method: str, *, later: bool) -> None:
        self._later = later
        self._steps: list[History] = []
        self._contacts = Contacts(model)
        self._balance = Balance() if model.has_ledger else None
        self._choices = Choices() if method == "auto" else None

    @classmethod
    def saved(
        cls, model: Model, impacts: Sequence[Impact], energy_residual: float | None, chosen: Sequence[Choice]
    ) -> Findings:
        """Those of a run that was saved."""
        findings = cls(model, "", later=True)
        known = {"impacts": tuple(impacts), "energy_residual": energy_residual, "choices": tuple(chosen)}
        findings.__dict__.update(known)
        return findings

    def take(self, block: History, fresh: int) -> None:
        """The next accepted steps; see `Observer`."""
        if self._later:
            self._steps.append(block)
            return
        for observer in (self._contacts, self._balance, self._choices):
            if observer is not None:
                observer.take(block, fresh)

    def _looked(self, observer: Seen) -> Seen:
        for block in self._steps:
            observer.take(block, 0)
        return observer

    @cached_property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        return self._looked(self._contacts).impacts()

    @cached_property
    def energy_residual(self) -> float | None:
        """See `Solution.energy_residual`."""
        return self._looked(self._balance).residual if self._balance is not None else None

    @cached_property
    def choices(self) -> tuple[Choice, ...]:
        """See `Solution.choices`."""
        return tuple(self._looked(self._choices).made) if self._choices is not None else ()
