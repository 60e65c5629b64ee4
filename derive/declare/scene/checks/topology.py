"""Faults of joints and pairs that are impossible, connect nothing, or connect a rigid whole."""

from __future__ import annotations

from collections.abc import Iterator

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults, repeated
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism


def topology_faults(mechanism: Mechanism) -> Iterator[Fault]:
    """Yield faults of joints and pairs that are impossible or connect nothing."""
    yield from name_faults("mechanism", mechanism.name)
    for body in dict.fromkeys(body.name for body in mechanism.bodies):
        yield from name_faults("body", body)
        if body == GROUND.name:
            yield Fault("body", f"the name {body!r}, which is that of the frame that does not move", "another name")
    yield from repeated("joint", [joint.name for joint in mechanism.joints])
    yield from repeated("pair", [*(pair.name for pair in mechanism.pairs), *mechanism.parts])
    yield from connection_faults(mechanism)
    for joint in mechanism.joints:
        yield from joint.faults()
    for joint in mechanism.closures:
        unruled = joint.unruled()
        yield from unruled
        if not unruled and not joint.constraints():
            yield Fault(f"joint {joint.name}", f"a free joint to {joint.child.body.name}, which another joint carries", "one that closes the loop",
                        "A free joint constrains nothing: leave it out, or declare it first.")  # fmt: skip
    for pair in mechanism.pairs:
        for point in pair.places:
            if point.body != GROUND and mechanism.joint_of(point.body) is None:
                yield Fault(f"pair {pair.name}", f"body {point.body.name}", "a body that a joint connects")
        yield from pair.faults()
        first, second = (place.body for place in pair.places)
        if first == second:
            yield Fault(f"pair {pair.name}", f"both sides on {first.name}", "two different bodies")
        elif rigid_root(mechanism, first) == rigid_root(mechanism, second):
            yield Fault(
                f"pair {pair.name}",
                f"{first.name} and {second.name}, which are welded",
                "bodies that can move against each other",
            )


def connection_faults(mechanism: Mechanism) -> Iterator[Fault]:
    """Yield faults of joints that are not in order from the ground outwards."""
    reached: list[Frame] = [GROUND]
    names: dict[str, Body] = {}
    for joint in mechanism.joints:
        where, child, parent = f"joint {joint.name}", joint.child.body, joint.parent.body
        if not isinstance(child, Body):
            yield Fault(where, "the ground as child", "a body", "Give the ground as the parent.")
            continue
        if child not in reached and names.setdefault(child.name, child) != child:
            yield Fault(where, f"a second body named {child.name}", "names that are unique", "Rename one of them.")
        if parent == child:
            yield Fault(where, f"{child.name} as parent and child", "two different bodies")
        elif parent not in reached:
            declared = any(parent == other.child.body for other in mechanism.joints)
            yield Fault(
                where,
                f"parent {parent.name}, " + ("declared later" if declared else "which is not in the mechanism"),
                "the ground or a body of an earlier joint",
                "Put the joints in order from the ground outwards."
                if declared
                else f"Connect {parent.name} to the ground by a joint of its own.",
            )
        if joint.carries:
            reached.append(child)
        elif child not in reached:
            yield Fault(where, f"{child.name}, which no joint before carries", "a body of an earlier joint",
                        "A track only removes freedoms: let a Planar(...) or another joint carry the body.")  # fmt: skip


def rigid_root(mechanism: Mechanism, body: Frame) -> Frame:
    """The innermost of the bodies that are welded to each other."""
    joint = mechanism.joint_of(body)
    return rigid_root(mechanism, joint.parent.body) if joint is not None and not joint.freedoms else body
