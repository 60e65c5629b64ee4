"""Check of a scene: every fault of its declarations at once, before anything is derived.

In order: types, topology, effects, start, parameters, quantities. A stage that needs sound input from an earlier one
skips what is not.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults, text_faults
from hertzwerk.derive.declare.effects.state_expression import Varying, expression_faults, input_faults, table_faults
from hertzwerk.derive.declare.mechanism.curve import curve_faults
from hertzwerk.derive.declare.mechanism.pose import Posed
from hertzwerk.derive.declare.scene.checks.actions import effect_faults, start_faults
from hertzwerk.derive.declare.scene.checks.directions import length_faults
from hertzwerk.derive.declare.scene.checks.inertia import inertia_faults
from hertzwerk.derive.declare.scene.checks.malformed import shape_faults
from hertzwerk.derive.declare.scene.checks.quantities import (
    declared,
    posed_faults,
    quantity_faults,
    rate_faults,
    sound_of,
)
from hertzwerk.derive.declare.scene.checks.topology import topology_faults
from hertzwerk.derive.declare.scene.checks.types import scene_type_faults
from hertzwerk.derive.expressions.parameter import Slot, dimensions_of, parameters_of

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


def faults_of(scene: Scene) -> tuple[Fault, ...]:
    """Faults of a scene, each once."""
    wrong_types = tuple(shape_faults(scene)) or tuple(scene_type_faults(scene))
    if wrong_types:
        return tuple(dict.fromkeys(wrong_types))
    faults: list[Fault] = [
        *length_faults(scene),
        *topology_faults(scene.mechanism),
        *effect_faults(scene),
        *start_faults(scene),
        *name_faults("scene", scene.name),
        *_wording_faults(scene),
    ]
    parameters, broken = declared(scene)
    faults.extend(broken)
    sound = sound_of(parameters, broken)
    table = dimensions_of(sound)
    settled: set[tuple[Any, ...]] = set()  # sound quantities, each checked once: many pairs share theirs
    for slot in scene.declarations():
        key = slot.value, slot.unit, slot.limit
        if type(slot) is Slot and isinstance(slot.value, sp.Basic) and key in settled:
            continue
        before = len(faults)
        if not all(sound.get(parameter.name) == parameter for parameter in parameters_of(slot.value)):
            continue
        if isinstance(slot, Posed):
            faults.extend(posed_faults(slot, table))
        elif isinstance(slot, Varying):
            faults.extend(expression_faults(slot, scene, table, partial(quantity_faults, table=table)))
        else:
            faults.extend(quantity_faults(slot, table))
        faults.extend(rate_faults(slot))
        if len(faults) == before and type(slot) is Slot and isinstance(slot.value, sp.Basic):
            settled.add(key)
    faults.extend(curve_faults(_curves(scene), parameters))
    faults.extend(inertia_faults(scene.mechanism, sound))
    faults.extend(table_faults(_expressions(scene)))
    faults.extend(input_faults(_expressions(scene), parameters))
    return tuple(dict.fromkeys(faults))


def _curves(scene: Scene) -> Iterator[tuple[str, Any]]:
    """Yield the curves of the mechanism, with where they are declared."""
    yield from ((f"joint {joint.name}", curve) for joint in scene.mechanism.joints for curve in joint.curves)
    yield from ((f"pair {pair.name}", curve) for pair in scene.mechanism.pairs for curve in pair.curves)


def _parts(scene: Scene) -> Iterator[tuple[str, tuple[Any, ...]]]:
    """Yield named parts by kind."""
    mechanism = scene.mechanism
    yield "mechanism", (mechanism,)
    yield "body", mechanism.bodies
    yield "joint", mechanism.joints
    yield "pair", mechanism.pairs
    yield "effect", scene.effects


def _wording_faults(scene: Scene) -> Iterator[Fault]:
    """Faults of texts that cannot be printed, and of names in laws."""
    yield from text_faults("scene, summary", scene.summary)
    checked: set[int] = set()
    for effect in scene.effects:
        yield from text_faults(f"effect {effect.name}, text", effect.text)
        for law in (bound.law for bound in effect.laws if id(bound.law) not in checked):
            checked.add(id(law))
            where = f"law {law.name}"
            yield from name_faults("law", law.name)
            for attribute in ("title", "source", "note", "repair", "fitted_in"):
                yield from text_faults(f"{where}, {attribute}", getattr(law, attribute))
            for symbol in law.symbols():
                yield from name_faults(where, symbol.name)
                yield from text_faults(f"{where}, {symbol.name}", getattr(symbol, "meaning", ""))


def _expressions(scene: Scene) -> Iterator[Any]:
    """Expressions of every quantity, also of effects on missing joints."""
    yield from (slot.value for slot in scene.slots())
    yield from (value for effect in scene.effects for value in vars(effect).values())
