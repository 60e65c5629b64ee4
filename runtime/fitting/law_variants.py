"""Variants of a model by the laws of its effects, and the fit that is asked of each."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.runtime.fitting.fitting import Asked, read_fit
from hertzwerk.runtime.loading import load
from hertzwerk.runtime.model.model import Model


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


def law_variants(model: Model, laws: Mapping[str, Sequence[str]]) -> tuple[dict[str, Model], list[Fault]]:
    """Return a model with every combination of laws, by what says which, and what is wrong with them."""
    faults: list[Fault] = []
    if not isinstance(laws, Mapping) or not laws or any(isinstance(each, str) for each in laws.values()):
        expected = 'laws by effect, such as {"floor": ["flores", "hunt_crossley"]}'
        return {}, [Fault("laws", shown(laws), expected)]
    if model.declaration is None:
        return {}, [Fault("laws", "a model without its scene", "a model that `load` returned")]
    variants: dict[str, Model] = {}
    of, many = model.declaration, [effect for effect, each in laws.items() if len(each) > 1]
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
        try:
            variants[name] = load(
                of.target, without=of.without, laws={**dict(of.laws), **by_effect}, coordinates=of.coordinates
            ).with_signals(model.signals)
        except InputError as error:
            faults += [fault for fault in error.faults if fault not in faults]
    return variants, faults


def read_laws(
    variants: Mapping[str, Model], data: object, free: object, how: Mapping[str, Any], faults: list[Fault]
) -> dict[str, Asked]:
    """Return the fit that is asked of every variant; raises InputError with every fault.

    Names that a variant does not have are left out of it, if another has them.
    """
    if not variants:
        raise InputError("laws", faults)
    if isinstance(free, Sequence) and not isinstance(free, str):
        free = dict.fromkeys(free)
    known = {name for model in variants.values() for name in _names(model)}
    asked: dict[str, Asked] = {}
    how = {name: value for name, value in how.items() if name not in ("progress", "free", "data")}
    for law, model in variants.items():
        its = _names(model)
        elsewhere = known - its
        own = (
            {name: ends for name, ends in free.items() if name not in elsewhere} if isinstance(free, Mapping) else free
        )
        given = how["parameters"]
        parameters = {name: value for name, value in (given or {}).items() if name not in elsewhere}
        try:
            asked[law] = read_fit(model, data, own, **{**how, "parameters": parameters})
        except InputError as error:
            faults += [fault for fault in error.faults if fault not in faults]
    if faults:
        raise InputError("laws", faults)
    return asked


def _names(model: Model) -> set[str]:
    return {*model.parameters, *model.joints.coordinates, *model.joints.speeds}
