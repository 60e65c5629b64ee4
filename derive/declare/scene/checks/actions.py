"""Faults of effects without a subject or in conflict, and of start values of coordinates not free."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.common.identifiers import repeated
from hertzwerk.derive.declare.effects.contacts import Contact
from hertzwerk.derive.declare.effects.effect import Effect

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


def effect_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of effects whose subject is missing, or that are in conflict."""
    yield from repeated("effect", [effect.name for effect in scene.effects])
    for effect in scene.effects:
        yield from effect.faults(scene)
        yield from _state_faults(scene, effect)
    for subject, count in Counter(effect.only for effect in scene.effects if effect.only).items():
        if count > 1:
            yield Fault(subject, str(count), "one", "Omit the others, or combine them in one.")
    if not scene.mechanism.freedoms:
        yield Fault("effects", "no joint that can move", "at least one joint that is free to move",
                    "A robot without joints that move can float: from_urdf(..., base='floating').")  # fmt: skip
    elif not (scene.free or scene.ledger or scene.states or any(drive.integrates for drive in scene.driven.values())):
        yield Fault("effects", "a drive on every joint", "at least one joint that is free to move, or the work of the drives",
                    "Add EnergyLedger(), or the Contact of what the drives move.")  # fmt: skip


def _state_faults(scene: Scene, effect: Effect) -> Iterator[Fault]:
    """Faults of states of the same name, and of states without a size."""
    if any(key not in scene.scalars for key in effect.joints):
        return  # a fault of its own
    states = list(effect.states(scene))
    yield from repeated(f"{effect.where}, state", [state.name for state in states])
    scales = scene.scales.by_unit
    for state in states:
        if state.size is None and state.unit != "1" and state.unit not in scales:
            yield Fault(f"{effect.where}, {state.name}", "no size", f"a quantity in {state.unit} that its errors are measured by",
                        f"State({state.name!r}, {state.unit!r}, size=...); without one it is the scene's scale in {', '.join(scales)}.")  # fmt: skip


def start_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of positions and speeds given to coordinates not free, and of a missing arm."""
    for quantity, ports in (("position", "coordinates"), ("near", "coordinates"), ("speed", "speeds")):
        of_joints = [freedom.key for freedom in scene.free if freedom.known_by_key and getattr(freedom, ports)]
        full = [port.name for freedom in scene.free for port in getattr(freedom, ports)]
        short = [name for name in full if name.rsplit(".", 1)[0] not in of_joints]
        if quantity == "near":  # whole turns are counted from there
            of_joints += scene.mechanism.wrapped
            full += [scene.scalars[key].coordinates[0].name for key in scene.mechanism.wrapped]
        for name in getattr(scene.start, quantity):
            if name not in (*of_joints, *full):
                closing = name.split(".")[0] in [joint.name for joint in scene.mechanism.closures]
                driven = "driven, its motion is the drive's" if name in scene.driven else "unknown"
                why = "closes a loop, its motion follows" if closing else driven
                yield Fault(
                    "start",
                    f"{quantity} of joint {name!r} ({why})",
                    one_of((*of_joints, *short), "nothing, because no joint is free"),
                )
    yield from _seat_faults(scene)
    # an integrated drive has a coordinate of its own
    moving = [
        freedom for freedom in scene.mechanism.freedoms if freedom in scene.free or scene.driven[freedom.key].integrates
    ]
    if scene.scales.arm is None and any(freedom.kind != "slide" for freedom in moving):
        yield Fault("scales", "no arm", "an arm [m], because the scene has angles",
                    "Scales(length=..., speed=..., arm=...): an angle is measured as length/arm.")  # fmt: skip


def _seat_faults(scene: Scene) -> Iterator[Fault]:
    """Faults of a seated start without journals, or with pairs that do not replace a joint."""
    if not scene.start.seated:
        return
    expected = "pairs that stand for a joint, pin_in_bush or ball_in_socket, each with a contact"
    pairs, touching = scene.mechanism.pairs, [contact.pair for contact in scene.all(Contact)]
    wrong = [f"{pair.name} ({pair.kind})" for pair in pairs if not pair.journal]
    wrong += [f"{pair.name} (no contact)" for pair in pairs if pair.journal and pair.name not in touching]
    if wrong or not pairs:
        actual = f"seated with {', '.join(wrong)}" if wrong else "seated without a pair that has clearance"
        yield Fault(
            "start",
            actual,
            expected,
            "Omit seated=True: journals then start centred, other pairs where the start states, or all at rest by `--start equilibrium`.",
        )
