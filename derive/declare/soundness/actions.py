"""Effects without what they act on, or in each other's way; a start that is given to what is not free."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.effects.drives import Drive
from hertzwerk.derive.effects.faults import element_faults
from hertzwerk.derive.faults import Fault, one_of
from hertzwerk.derive.identifiers import repeated, twice

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene import Scene


def effect_faults(scene: Scene) -> Iterator[Fault]:
    """Effects that lack what they act on, or stand in each other's way."""
    yield from repeated("effect", [effect.name for effect in scene.effects])
    pairs = [pair.name for pair in scene.mechanism.pairs]
    contacts = [effect.pair for effect in scene.of_kind("contact")]
    for effect in scene.effects:
        yield from element_faults(effect, scene.mechanism)
    paired: list[Any] = [effect for effect in scene.effects if hasattr(effect, "pair")]
    for effect in paired:
        if effect.kind != "friction" and effect.pair not in pairs:
            yield Fault(
                f"effect {effect.name}",
                f"pair {effect.pair!r}",
                one_of(pairs, "a pair of the mechanism, which has none"),
            )
    for effect in scene.of_kind("friction"):
        if effect.pair not in contacts:
            yield Fault(f"effect {effect.name}", f"pair {effect.pair!r} without a contact", one_of(contacts, "a pair with a Contact"),
                        "Friction needs a normal force: leave it out too, or add the pair's Contact.")  # fmt: skip
    for effect in paired:
        yield from _geometry_faults(effect, scene.geometry(effect.pair))
        yield from _demand_faults(
            effect, next((pair.kind for pair in scene.mechanism.pairs if pair.name == effect.pair), None)
        )
    drives = [effect.joint for effect in scene.of_kind("drive")]
    yield from twice("drive of joint", drives)
    for kind in dict.fromkeys(effect.kind for effect in paired if effect.kind != "contact"):
        yield from twice(f"{kind} of pair", [effect.pair for effect in scene.of_kind(kind)])
    for kind in ("ledger", "gravity"):
        if len(scene.of_kind(kind)) > 1:
            yield Fault("effects", f"{len(scene.of_kind(kind))} of kind {kind}", "at most one")
    if all(freedom.key in drives for freedom in scene.mechanism.freedoms):
        found = "a drive on every joint" if scene.mechanism.freedoms else "no joint that can move"
        yield Fault("effects", found, "at least one joint that is free to move")


def _geometry_faults(effect: Any, offered: dict[str, Any]) -> Iterator[Fault]:
    for bound in getattr(effect, "laws", ()):
        for quantity in bound.law.geometry():
            if offered and quantity.name not in offered:
                yield Fault(f"effect {effect.name}", f"a pair without {quantity.name}, {quantity.meaning}",
                            f"one that has it, because {bound.law.name} asks for it",
                            "Line contacts need a length: PinInBush(..., length=...), ParallelCylinders, CylinderOnPlane; "
                            "edges and corners have no radius: power(K, n) does without one.")  # fmt: skip


def _demand_faults(effect: Any, kind: str | None) -> Iterator[Fault]:
    """What laws ask of a scene beyond units and geometry: the pair they were made for."""
    for law in (bound.law for bound in getattr(effect, "laws", ())):
        if law.pairs and kind is not None and kind not in law.pairs:
            expected = f"the pair it was made for, {' or '.join(law.pairs)}"
            yield Fault(f"effect {effect.name}", f"law {law.name} at a {kind} pair", expected)


def start_faults(scene: Scene) -> Iterator[Fault]:
    """Positions and speeds given to what is not free, and the size that angles need."""
    of_joints = [freedom.key for freedom in scene.free if freedom.scalar]
    for given, ports in (("position", "coordinates"), ("near", "coordinates"), ("speed", "speeds")):
        full = [port.name for freedom in scene.free for port in getattr(freedom, ports)]
        short = [name for name in full if name.rsplit(".", 1)[0] not in of_joints]
        for name in getattr(scene.start, given):
            if name not in (*of_joints, *full):
                closing = name.split(".")[0] in [joint.name for joint in scene.mechanism.closures]
                driven = "driven, its motion is the drive's" if name in scene.driven else "unknown"
                why = "closes a loop, its motion follows" if closing else driven
                yield Fault(
                    "start",
                    f"{given} of joint {name!r} ({why})",
                    one_of((*of_joints, *short), "nothing, because no joint is free"),
                )
    yield from _seat_faults(scene)
    # a drive that is integrated keeps a coordinate of its own
    moving = [
        freedom
        for freedom in scene.mechanism.freedoms
        if freedom in scene.free or _integrates(scene.driven[freedom.key])
    ]
    if scene.scales.arm is None and any(freedom.kind != "slide" for freedom in moving):
        yield Fault("scales", "no arm", "an arm [m], because the scene has angles",
                    "Scales(length=..., speed=..., arm=...): an angle is measured as length/arm.")  # fmt: skip


def _seat_faults(scene: Scene) -> Iterator[Fault]:
    """A start with seated journals where there is none, or where what a pair would be as a closed joint is not known."""
    if not scene.start.seated:
        return
    expected = "pairs that stand for a joint, pin_in_bush or ball_in_socket, each with a contact"
    pairs, touching = scene.mechanism.pairs, [contact.pair for contact in scene.of_kind("contact")]
    wrong = [f"{pair.name} ({pair.kind})" for pair in pairs if not pair.journal]
    wrong += [f"{pair.name} (no contact)" for pair in pairs if pair.journal and pair.name not in touching]
    if wrong or not pairs:
        found = f"seated with {', '.join(wrong)}" if wrong else "seated without a pair that has clearance"
        yield Fault(
            "start", found, expected, "Without seated=True journals start centred, other pairs as the start says."
        )


def _integrates(drive: Any) -> bool:
    return isinstance(drive, Drive) and drive.position is None
