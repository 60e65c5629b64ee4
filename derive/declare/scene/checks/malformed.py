"""Faults of entries that are not even records of the expected kind.

Their names cannot be read, so all other checks are skipped.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.declare.effects.effect import Effect
from hertzwerk.derive.declare.mechanism.bodies import Body
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.declare.mechanism.pair import Pair

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene

TEXTS = (
    "name",
    "pair",
    "summary",
)  # text fields of any record; the type of an effect's joint is stated by the effect
EFFECT = "an effect, such as Gravity(...), Contact(...), JointSpring(...), Drive(...), EnergyLedger()"
PAIR = "a pair, such as PinInBush(...), SphereOnPlane(...)"
JOINT = "a joint, such as Revolute(...), Prismatic(...)"


def shape_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of entries that are no record of their kind, or contain mutable values."""
    mechanism, start = scene.mechanism, scene.start
    for name in ("name", "summary", "coordinates"):
        if not isinstance(getattr(scene, name), str):
            yield Fault(f"scene, {name}", shown(getattr(scene, name)), "text")
    if not (hasattr(mechanism, "joints") and hasattr(mechanism, "pairs")):
        yield Fault("mechanism", shown(mechanism), "Mechanism(name, joints=(...), pairs=(...))")
    else:
        yield from _texts("mechanism", mechanism)
        yield from _all("joints", mechanism.joints, JOINT, lambda joint: isinstance(joint, Joint))
        yield from _all("pairs", mechanism.pairs, PAIR, lambda pair: isinstance(pair, Pair))
    yield from _all(
        "effects", scene.effects, EFFECT, lambda e: isinstance(e, Effect) and is_dataclass(e) and hasattr(e, "kind")
    )
    if not hasattr(scene.scales, "length"):
        yield Fault("scales", shown(scene.scales), "Scales(length=..., speed=...)")
    if not all(hasattr(start, attribute) for attribute in ("position", "near", "speed")):
        yield Fault("start", shown(start), "Start(position={...}, speed={...})")
        return
    if not isinstance(getattr(start, "seated", False), bool):
        yield Fault("start, seated", shown(start.seated), "True or False")
    for attribute in ("position", "near", "speed"):
        values = getattr(start, attribute)
        if not isinstance(values, Mapping) or not all(isinstance(name, str) for name in values):
            example = '"guide": Parameter(...)'
            yield Fault(
                f"start, {attribute}", shown(values), f"values by the name of a coordinate or joint, {{{example}}}"
            )


def _all(label: str, records: Any, expected: str, fits: Callable[[Any], bool]) -> Iterator[Fault]:
    """Faults of a value that should be a tuple of records of one kind."""
    if not isinstance(records, tuple):
        yield Fault(
            label, shown(records), f"a tuple; each entry is {expected}", "A tuple of one has a comma: (entry,)."
        )
        return
    for record in records:
        if isinstance(record, type) or not fits(record):
            yield Fault(label, shown(record), expected)
            continue
        yield from _texts(f"{label.removesuffix('s')} {record.name}" if isinstance(record.name, str) else label, record)
        yield from _changing(f"{label.removesuffix('s')} {record.name}", record)


def _texts(where: str, record: Any) -> Iterator[Fault]:
    for name in TEXTS:
        if hasattr(record, name) and not isinstance(getattr(record, name), str):
            yield Fault(f"{where}, {name}", shown(getattr(record, name)), "text")
            return


def _changing(where: str, record: Any) -> Iterator[Fault]:
    """Faults of lists, dictionaries and arrays within a record, and in the bodies of a joint.

    A scene is compared and must not change.
    """
    if isinstance(record, Joint):
        for point in (record.parent, record.child):
            body = getattr(point, "body", None)
            if isinstance(body, Body):
                yield from _texts(f"body {body.name}" if isinstance(body.name, str) else "body", body)
                yield from _changing(f"body {body.name}", body)
                if not _constant(body):
                    return  # not reported again for the joint
    for entry in fields(record) if is_dataclass(record) and not isinstance(record, type) else ():
        value = getattr(record, entry.name)
        if entry.name == "unchecked" and not isinstance(value, bool):
            yield Fault(f"{where}, {entry.name}", shown(value), "True or False")
        elif not _constant(value):
            remedy = "Write (1, 2, 3) in place of a list or an array; an inertia is one number, the three principal ones, or three rows."
            yield Fault(f"{where}, {entry.name.replace('_', ' ')}", shown(value), "what cannot change: a number, an expression, or a tuple of them",
                        remedy)  # fmt: skip


def _constant(value: Any) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True
