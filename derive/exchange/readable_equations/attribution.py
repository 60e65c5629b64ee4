"""Attribute equations and their terms to effects, by the marks on the effects' parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.contacts import Contact
from hertzwerk.derive.declare.effects.effect import APPLIED, CONTACT, Effect, PairEffect
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.exchange.readable_equations.drafts import ENERGY, LEDGER, Draft, Part, pair_of
from hertzwerk.derive.exchange.readable_equations.symbols import contact_title
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws.law import BoundLaw
from hertzwerk.derive.laws.material import Material
from hertzwerk.derive.program.program import symbols_in


@dataclass(frozen=True)
class Marked:
    """A scene whose effects' parameters carry marks; `effect_of` maps each mark to its effect."""

    scene: Scene
    effect_of: Mapping[sp.Symbol, str]

    def plain(self, expression: Any) -> Any:
        """An expression without marks."""
        return sp.sympify(expression).xreplace(dict.fromkeys(self.effect_of, sp.S.One))


def marked(scene: Scene) -> Marked:
    """Mark the parameters of a scene's effects, so that effects sharing a parameter stay distinct.

    A parameter that is an exponent in the unit of another (N/m^exponent) takes no mark: the unit would no longer
    hold.
    """
    parameters = scene.parameters.values()
    exponents = {name for p in parameters for e in p.parsed_unit.exponents for name in e.names}
    prefix = "mark_"
    while any(p.name.startswith(prefix) for p in parameters):
        prefix += "_"
    records: tuple[Any, ...] = scene.effects
    effects, effect_of = [], {}
    for i, effect in enumerate(records):
        mark = Parameter(f"{prefix}{i}", "1", 1)
        table: dict[sp.Symbol, Any] = {p: p * mark for p in parameters if p.name not in exponents}
        table |= {signal: signal * mark for signal in scene.inputs.values()}
        effects.append(replace(effect, **_changed(effect, table)))
        effect_of[mark] = effect.name
    return Marked(replace(scene, effects=tuple(effects)), effect_of)


def _changed(record: Any, table: Mapping[Any, Any]) -> dict[str, Any]:
    return {f.name: _with(getattr(record, f.name), table) for f in fields(record) if f.init}


def _with(value: Any, table: Mapping[Any, Any]) -> Any:
    """Put the marks into the expressions of a value; places, bodies and laws stay as they are."""
    if isinstance(value, sp.Basic):
        return value.xreplace(table)
    if isinstance(value, tuple):
        return tuple(_with(part, table) for part in value)
    if isinstance(value, BoundLaw | Material) and is_dataclass(value):
        return replace(value, **_changed(value, table))
    return value


# ----------------------------------------------------------------------------------------------------------------------


class Attribution:
    """Attribution of the equations of one scene; `forms` are its intermediate results, with their marks."""

    def __init__(self, scene: Scene, marked: Marked, forms: Mapping[sp.Symbol, Any]) -> None:
        self._scene, self._marked, self._forms = scene, marked, forms
        self._effects = {effect.name: effect for effect in scene.effects}
        self._pairs = {effect.pair for effect in scene.all(Contact)}

    def split_by_effect(self, draft: Draft) -> None:
        """Split the generalised forces of an equation of motion by effect, in declared order."""
        forces: dict[str, Part] = {}
        for part in draft.parts:
            if part.left:
                continue
            for term in sp.Add.make_args(part.expression) if part.source else (part.expression,):
                if term == 0:
                    continue
                effect = part.effect or self._owner(part.source, term)
                meaning = (effect if part.source else "") or part.meaning
                known = forces.get(meaning)
                total = term if known is None else known.expression + term
                forces[meaning] = replace(part, meaning=meaning, expression=total, effect=effect)
        order = list(self._effects)
        known_last = sorted(forces.values(), key=lambda p: order.index(p.effect) if p.effect in order else len(order))
        draft.parts = [*(part for part in draft.parts if part.left), *known_last]

    def of(self, draft: Draft, drafts: list[Draft]) -> tuple[str, ...]:
        """Names of the effects that an equation comes from.

        These are the effects whose parameters it contains, whose term it has, whose contact it describes, and the
        energy ledger.
        """
        names = {*draft.effects, *(name for part in draft.parts for name in part.effect.split(", "))}
        for expression in draft.expressions():
            names |= {self._marked.effect_of[s] for s in symbols_in(expression) if s in self._marked.effect_of}
        names |= {self._of_contact(pair, draft, drafts) for pair in self._pairs if draft.section == contact_title(pair)}
        if draft.section in (LEDGER, ENERGY):
            names |= {effect.name for effect in self._scene.all(EnergyLedger)}
        return tuple(name for name in self._effects if name in names)

    # -- by the marks ----------------------------------------------------------------------------------------------

    def _dependencies(self, expression: Any) -> set[str]:
        """Effects that an expression depends on, directly or through intermediate results."""
        reached, pending = set(), symbols_in(expression)
        while pending:
            symbol = pending.pop()
            if symbol not in reached:
                reached.add(symbol)
                pending.extend(symbols_in(self._forms.get(symbol, sp.S.Zero)))
        return {effect for mark, effect in self._marked.effect_of.items() if mark in reached}

    def _owner(self, function: str, term: Any) -> str:
        """The effect that a term of a generalised force comes from; several where they share one term."""
        far, pair = self._dependencies(term), pair_of(function)
        if pair:
            return next((name for name in self._beside(pair) if name in far), pair)
        return ", ".join(e.name for e in self._effects.values() if e.name in far and e.enters == APPLIED)

    def _beside(self, pair: str) -> list[str]:
        """Effects fed by the pair's normal force: friction, resistance to rolling and drilling."""
        return [effect.name for effect in self._scene.all(PairEffect)
                if effect.pair == pair and effect.enters == CONTACT and not isinstance(effect, Contact)]  # fmt: skip

    def _of_contact(self, pair: str, draft: Draft, drafts: list[Draft]) -> str:
        """Attribute an equation of a contact to the normal force, or to an effect fed by it.

        To friction, for one, belongs what depends on it, and what is used for that alone.
        """
        beside, own = self._beside(pair), self._dependencies(draft.expression)
        users = [other for other in drafts if draft.symbol in other.symbols()]
        for effect in beside:
            if effect in own:
                return effect
            if users and all(
                user.expression is not None and effect in self._dependencies(user.expression) for user in users
            ):
                return effect
        return pair


def sources(scene: Scene) -> Iterator[tuple[Effect, str]]:
    """Yield every effect with the sources of its laws as text."""
    for effect in scene.effects:
        laws = dict.fromkeys(bound.law for bound in effect.laws)
        yield effect, "; ".join(f"{law.name}: {law.source}, grade {law.grade}" for law in laws)
