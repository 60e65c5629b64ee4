"""Forms of contact: the region in which a pair touches (point, line, surface), and laws for it.

A law of another form, such as Hertz's point contact for a pin in a bush, has consistent units but models another
joint. So it is advice: the scene runs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.grouping import grouped, some
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import FORMS, Law

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


_TOUCHES = {"point": "at a point", "line": "along a line", "surface": "over a surface"}


def form_of(pair: Pair) -> str:
    """Form of contact of a pair: "point", "line" or "surface". Raises TypeError if it states none."""
    form = getattr(pair, "form", None)
    if form not in FORMS:
        raise TypeError(f"pair {pair.name}: found the form of contact {form!r}, expected one of {FORMS}")
    return str(form)


def laws_of_form(form: str) -> Iterator[Law]:
    """Yield consistent laws made for a form of contact, but not for every form, in catalogue order."""
    laws = (law for law in LAWS.values() if law.verdict == "consistent")
    yield from (law for law in laws if form in law.forms and law.forms != FORMS)


def fitting_laws(kind: str, pair: Pair, offered: Mapping[str, Any]) -> Iterator[str]:
    """Yield the names of consistent laws that fit a pair's form and geometry, in catalogue order."""
    for law in laws_of_form(form_of(pair)):
        fits = not law.pairs or pair.kind in law.pairs
        if law.kind == kind and fits and all(quantity.name in offered for quantity in law.geometry):
            yield law.name


def advice(scene: Scene) -> tuple[str, ...]:
    """One finding for each law used at pairs of another form of contact than its own."""
    places = grouped(
        ((law.name, pair.kind, "L" in scene.geometry(pair.name)), effect)
        for effect, law, pair in _laws_at_pairs(scene)
        if form_of(pair) not in law.forms
    )
    return tuple(_sentence(scene, *key, effects) for key, effects in places.items())


def _laws_at_pairs(scene: Scene) -> Iterator[tuple[str, Law, Pair]]:
    """Yield effect, law and pair, in declared order."""
    pairs = scene.mechanism.pair_named
    for effect in scene.effects:
        for name in effect.pairs:
            yield from ((effect.name, bound.law, pairs[name]) for bound in effect.laws)


def _sentence(scene: Scene, name: str, kind: str, long: bool, effects: list[str]) -> str:
    effect = scene.effect(effects[0])
    law = next(bound.law for bound in effect.laws if bound.law.name == name)
    pair = next(pair for pair in scene.mechanism.pairs if pair.name in effect.pairs)
    form, own = form_of(pair), " or ".join(law.forms)
    offered = scene.geometry(pair.name) | ({} if long else {"L": None})
    condition = "" if long or form != "line" else "; others take its length"
    listed = f"take a law of {form} contact (`hertzwerk laws --form {form}`)"
    way = listed if any(fitting_laws(law.kind, pair, offered)) else f"the catalogue has no law of {form} contact for it"
    touches = f"a {kind.replace('_', ' ')} touches {_TOUCHES[form]}"
    return f"{some(effects)}: {way}. At {', '.join(effects)} {touches}, and {name} is a law of {own} contact{condition}"
