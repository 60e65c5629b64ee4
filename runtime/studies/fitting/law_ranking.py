"""Ranking of contact and friction laws, as variants of a model, by what measured data say of them.

Each law is fitted to the same data. Akaike's criterion, corrected for few data, weighs how well it fits against how much
is fitted (Burnham and Anderson, Model Selection and Multimodel Inference, 2002). Where there are several measured runs,
each is left out in turn and predicted by the fit of the others: what is free of that run alone, its offset, stays.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse, shown
from hertzwerk.derive.common.module_format import without_scene
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_request import progress_of
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.tables.notebook import Sentences
from hertzwerk.runtime.studies.fitting.fit_result import Fit
from hertzwerk.runtime.studies.fitting.fitting import (
    FitRequest,
    concluded,
    criterion_of,
    read_fit,
    searched,
    stated_noise,
)
from hertzwerk.runtime.studies.fitting.least_squares import Estimate, Search

APART = 6.0  # difference of the criteria below which laws are not told apart: one is 20 times as likely as the other
DOUBT = 2.0  # standard errors by which the held-out runs must prefer a law against the criterion's choice to be heard


def split_laws(text: str) -> list[str]:
    """Return the laws of a text, divided by commas that stand in no brackets."""
    depth, parts = 0, [""]
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def law_variants(model: EngineModel, laws: Mapping[str, Sequence[str]]) -> tuple[dict[str, EngineModel], list[Fault]]:
    """Return a model with every combination of laws, by what says which, and what is wrong with them."""
    faults: list[Fault] = []
    lists = laws.values() if isinstance(laws, Mapping) else ()
    if not lists or not all(isinstance(each, list | tuple) and all(isinstance(x, str) for x in each) for each in lists):
        expected = 'laws by effect, such as {"floor": ["flores", "hunt_crossley"]}'
        return {}, [Fault("laws", shown(laws), expected)]
    if model.declaration is None:
        return {}, [*without_scene("laws", model.module.SOURCE, model.name).faults]
    variants: dict[str, EngineModel] = {}
    many = [effect for effect, each in laws.items() if len(each) > 1]
    if not many:
        faults.append(Fault("laws", shown(dict(laws)), "two or more of an effect"))
    for chosen in itertools.product(*laws.values()):
        by_effect = dict(zip(laws, chosen, strict=True))
        name = ", ".join(
            law if len(many) == 1 else f"{effect}={law}" for effect, law in by_effect.items() if effect in many
        )
        if name in variants:
            faults.append(Fault("laws", f"{name} twice", "every law once"))
            continue
        with noted(faults):
            variants[name] = engine_model(model, laws=by_effect)
    return variants, faults


def read_laws(
    variants: Mapping[str, EngineModel], data: object, free: object, how: Mapping[str, Any], faults: list[Fault]
) -> dict[str, FitRequest]:
    """Return the fit that is asked of every variant; raises InputError with every fault.

    Names that a variant does not have are left out of it, if another has them.
    """
    if not variants:
        raise InputError("laws", faults)
    if isinstance(free, list | tuple) and all(isinstance(name, str) for name in free):
        free = dict.fromkeys(free)
    known = {name for model in variants.values() for name in _names(model)}
    request: dict[str, FitRequest] = {}
    for law, model in variants.items():
        its = _names(model)
        elsewhere = known - its
        own = (
            {name: ends for name, ends in free.items() if name not in elsewhere} if isinstance(free, Mapping) else free
        )
        stated = how["parameters"]
        parameters = {name: value for name, value in (stated or {}).items() if name not in elsewhere}
        with noted(faults):
            request[law] = read_fit(model, data, own, **{**how, "parameters": parameters})
    refuse("laws", faults)
    return request


def _names(model: EngineModel) -> set[str]:
    return {*model.parameters, *model.joints.coordinates, *model.joints.speeds}


@dataclass(frozen=True)
class RankedLaw:
    """Law with its fit: criterion, less that of the best, Akaike's weight, log-densities held out."""

    name: str
    fitted: Fit
    criterion: float
    difference: float
    weight: float
    held_out: tuple[float, ...]

    @property
    def held_out_total(self) -> float | None:
        """Log-density of all runs, each held out; None with one run."""
        return sum(self.held_out) if self.held_out else None


@dataclass(frozen=True)
class Ranking(Sentences):
    """Laws fitted to the same data, the best first.

    alike    names of those between which and the best the data do not discriminate
    """

    laws: tuple[RankedLaw, ...]
    alike: tuple[str, ...]
    share: float

    @property
    def best(self) -> RankedLaw:
        """First of the laws."""
        return self.laws[0]

    @property
    def verdict(self) -> str:
        """Say between which laws the data discriminate."""
        best = self.best
        alike = f"not distinguished by these data: {', '.join((best.name, *self.alike))}"
        text = alike if self.alike else f"{best.name} is distinguished from the others"
        if best.fitted.explained is False:
            return f"{text}; but the best is itself rejected at 5 % by the stated noise: none of these laws explains the data"
        return text

    def lines(self) -> Iterator[tuple[str, str]]:
        """Yield what was found, as labels and sentences."""
        for law in self.laws:
            yield law.name, self._line(law)
        yield "verdict", self.verdict
        if not self.best.held_out:
            yield "note", "one measured run: no cross-validation, which leaves out runs"

    def _line(self, law: RankedLaw) -> str:
        values = ", ".join(f"{value.name} {value}" for value in law.fitted.values.values())
        held = (
            ""
            if law.held_out_total is None
            else f", held-out log-density {law.held_out_total - (self.best.held_out_total or 0.0):+.4g}"
        )
        fits = {None: "", True: ", explains the data", False: ", rejected"}[law.fitted.explained]
        return f"AICc {law.difference:+.4g}, weight {law.weight:.3g}{held}{fits}; {values}"

    def record(self) -> dict[str, Any]:
        """Return everything but the data as plain numbers."""
        return {
            "verdict": self.verdict,
            "alike": list(self.alike),
            "share": self.share,
            "laws": [
                {
                    "name": law.name,
                    "criterion": law.criterion,
                    "difference": law.difference,
                    "weight": law.weight,
                    "held_out": list(law.held_out),
                    "fit": law.fitted.record(),
                }
                for law in self.laws
            ],
        }


def ranked(request: Mapping[str, FitRequest], progress: Callable[[float], object] | None = None) -> Ranking:
    """Rank laws by their fits to the same data, as far as they lie before the horizon of each."""
    fits: dict[str, tuple[Search, Estimate]] = {}
    for k, (name, one) in enumerate(request.items()):
        fits[name] = searched(one, progress_of(progress, k, len(request)))
    common = np.logical_and.reduce([estimate.used for _, estimate in fits.values()])
    laws = []
    for name, (search, estimate) in fits.items():
        again = (
            estimate
            if np.array_equal(estimate.used, common)
            else search.settled(search.least(estimate.x, common, estimate.sigma))
        )
        held = _held_out(search, again)
        fitted = concluded(request[name], search, again)
        laws.append((name, fitted, criterion_of(search, again), held))
    least = min(criterion for *_, criterion, _ in laws)
    weights = [math.exp(-(criterion - least) / 2) for *_, criterion, _ in laws]
    found_laws = sorted(
        (
            RankedLaw(name, fitted, criterion, criterion - least, weight / sum(weights), held)
            for (name, fitted, criterion, held), weight in zip(laws, weights, strict=True)
        ),
        key=lambda law: law.criterion,
    )
    alike = tuple(law.name for law in found_laws[1:] if not _apart(found_laws[0], law))
    return Ranking(tuple(found_laws), alike, float(np.mean(common)))


def _apart(best: RankedLaw, other: RankedLaw) -> bool:
    """Return whether data rank a law below the best: by the criterion, not against held-out runs."""
    if other.difference < APART:
        return False
    prefer = np.subtract(best.held_out, other.held_out)
    if len(prefer) < 2:
        return True
    return bool(np.sum(prefer) > -DOUBT * math.sqrt(len(prefer)) * float(np.std(prefer, ddof=1)) and np.sum(prefer) > 0)


def _held_out(search: Search, estimate: Estimate) -> tuple[float, ...]:
    """Return the log-density of every run, predicted by the fit of the others; empty with one run."""
    forward, made = search.forward, []
    if len(forward.observed) < 2:
        return ()
    for i in range(len(forward.observed)):
        training, left = estimate.used & (forward.run != i), estimate.used & (forward.run == i)
        trained = search.settled(search.least(estimate.x, training, estimate.sigma))
        sigma = np.where(np.isnan(stated_noise(forward)), trained.sigma, estimate.sigma)
        residuals = search.residuals(trained.x, left, sigma)
        made.append(-float(residuals @ residuals) / 2 - float(np.sum(np.log(sigma[left] * math.sqrt(2 * math.pi)))))
    return tuple(made)
