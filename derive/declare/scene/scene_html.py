"""Scenes as notebooks show them: bodies and joints, pairs, effects with their laws, parameters."""

from __future__ import annotations

from collections.abc import Iterable

from hertzwerk.derive.common.markup import Markup, joined
from hertzwerk.derive.common.plain_table import heading, titled
from hertzwerk.derive.declare.effects.effect import Effect
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.expressions.parameter import Parameter


def scene_html(
    name: str, summary: str, mechanism: Mechanism, effects: tuple[Effect, ...], parameters: Iterable[Parameter]
) -> Markup:
    """Everything that a scene declares, as tables."""
    sizes = {"body": mechanism.bodies, "joint": mechanism.joints, "pair": mechanism.pairs, "effect": effects}
    plural = {"body": "bodies"}
    counts = ", ".join(
        f"{len(parts)} {kind if len(parts) == 1 else plural.get(kind, f'{kind}s')}" for kind, parts in sizes.items()
    )
    joints = [
        (joint.name, type(joint).__name__, f"{joint.parent.body.name} → {joint.child.body.name}",
         ", ".join(port.name for freedom in joint.freedoms for port in freedom.coordinates))
        for joint in mechanism.joints
    ]  # fmt: skip
    pairs = [
        (pair.name, type(pair).__name__, " and ".join(place.body.name for place in pair.places))
        for pair in mechanism.pairs
    ]
    rows = [(effect.name, effect.kind, effect.text) for effect in effects]
    values = [(p.name, f"{p.default:.6g}", p.unit, p.meaning) for p in parameters]
    return joined([
        heading(name, summary, f" ({counts})", good=True),
        titled("Joints", ("joint", "kind", "from, to", "coordinates"), joints),
        titled("Pairs", ("pair", "kind", "between"), pairs),
        titled("Effects", ("effect", "kind", "what it is"), rows),
        titled("Parameters", ("parameter", "value", "unit", "meaning"), values),
    ])  # fmt: skip
