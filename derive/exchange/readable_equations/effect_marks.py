"""Trace which effects a result depends on, by marks carried through the derivation.

Each effect's parameters and inputs are multiplied by a mark of its own, a symbol of value 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws.law import BoundLaw
from hertzwerk.derive.laws.material import Material


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
