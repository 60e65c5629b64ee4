"""Robots of URDF files: bodies, joints, limits, solids of contact; each number is a parameter.

The format is that of the ROS wiki, urdf/XML; its units are SI. The file is read as data: nothing in it is executed or
fetched, and meshes are left out by name.
"""

from __future__ import annotations

import keyword
import math
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from numbers import Real
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal
from xml.etree import ElementTree

import sympy as sp

from hertzwerk.derive.common.execute_file import beside
from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown, unknown
from hertzwerk.derive.common.identifiers import repeated
from hertzwerk.derive.common.toml_file import read_at_most
from hertzwerk.derive.declare.effects.couplings import Coupling
from hertzwerk.derive.declare.effects.effect import Effect
from hertzwerk.derive.declare.effects.springs import JointDamper
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, Frame, Point, X, Y, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic, Revolute
from hertzwerk.derive.declare.mechanism.joints.free import Free
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.declare.mechanism.joints.planar import Planar
from hertzwerk.derive.declare.mechanism.joints.weld import Weld
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.declare.mechanism.solids import Shape
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.exchange.user_files.urdf_inertias import Massed, number, position, repaired
from hertzwerk.derive.expressions.algebra.vectors import Matrix, about, add, apply, multiply, scale, transpose
from hertzwerk.derive.expressions.parameter import Parameter

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.user_files import urdf_elements

MAX_BYTES = 10_000_000
_EXPECTED = "a URDF file: XML with the root element <robot>"
_SCALAR = ("revolute", "continuous", "prismatic")
_FLOATING = "floating_base"


@dataclass(frozen=True)
class Limits:
    """Limits of a joint: range [rad or m], effort [N m or N], speed [rad/s or m/s]."""

    lower: float
    upper: float
    effort: float
    speed: float


@dataclass(frozen=True)
class Solid:
    """A solid of contact: a box, cylinder (along its z) or sphere about the point `at`, sizes [m] by name."""

    kind: str
    at: Point
    sizes: Mapping[str, Parameter]


@dataclass(frozen=True)
class Robot:
    """Robot of a URDF file, to which a scene adds pairs and effects.

    bodies      bodies by the name of their link; the base is GROUND where it is fixed
    effects     couplings of joints that mimic others, dampers of joints that have damping
    limits      limits by the name of the joint: data, no stops
    friction    dry friction by the name of the joint [N m or N]: data, as its law is a choice
    collisions  solids of contact by the name of the link
    left_out    descriptions of what the file has beside these
    repairs     descriptions of what the file has wrong and is read otherwise: names, inertias, joints that mimic
    """

    mechanism: Mechanism
    bodies: Mapping[str, Frame]
    effects: tuple[Effect, ...] = ()
    limits: Mapping[str, Limits] = field(default_factory=dict)
    friction: Mapping[str, float] = field(default_factory=dict)
    collisions: Mapping[str, tuple[Solid, ...]] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()
    repairs: tuple[str, ...] = ()

    def scene(
        self, *effects: Effect, scales: Scales, pairs: tuple[Pair, ...] = (), start: Start | None = None, name: str = ""
    ) -> Scene:
        """Scene of the robot with its own effects and these; raises InputError for unsound declarations."""
        mechanism = Mechanism(self.mechanism.name, self.mechanism.joints, tuple(pairs))
        return Scene(mechanism, (*self.effects, *effects), scales, start or Start(), name)


def from_urdf(
    path: str | Path,
    base: Literal["fixed", "floating"] = "fixed",
    *,
    locked: Mapping[str, float] = MappingProxyType({}),
    inertia: Literal["as given", "nearest"] = "as given",
) -> Robot:
    """Robot of a URDF file, whose first link is fixed to the ground or floats.

    `locked` welds joints at a value [rad or m] by their names in the file. With `inertia="nearest"` the nearest possible
    one stands for each that no body has. A relative path is from the scene file's folder. Raises InputError with every
    fault of the file.
    """
    faults = [
        Fault(option, shown(value), f"{one!r} or {other!r}")
        for option, value, (one, other) in (
            ("base", base, ("fixed", "floating")),
            ("inertia", inertia, ("as given", "nearest")),
        )
        if value not in (one, other)
    ]
    if not isinstance(locked, Mapping):
        faults.append(Fault("locked", shown(locked), 'values by the names of joints, {"finger_joint": 0}'))
    refuse(str(path), faults)
    from hertzwerk.derive.exchange.user_files.urdf_elements import elements_of  # imports pydantic

    root = _read(beside(path))
    links, joints, faults, left = elements_of(root)
    reader = _Reader(root.get("name", ""), links, joints, base, locked)
    faults = faults or list(reader.faults())
    refuse(str(path), faults)
    robot, faults = reader.robot(left, inertia == "nearest")
    refuse(str(path), faults)
    return robot


def _read(path: str | Path) -> ElementTree.Element:
    """Root element of a file. Raises InputError."""
    raw = read_at_most(MAX_BYTES, path, _EXPECTED)
    try:
        root = ElementTree.fromstring(raw)
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise InputError(str(path), [Fault("file", str(error), _EXPECTED)]) from error
    if root.tag != "robot":
        remedy = "Convert it first: xacro FILE > robot.urdf." if "xacro" in root.tag else ""
        raise InputError(str(path), [Fault("file", f"the root element <{root.tag}>", _EXPECTED, remedy)])
    return root


def _names(kind: str, names: Iterable[str], *taken: str) -> dict[str, str]:
    """Names as hertzwerk's are, by those of the file.

    Other characters become _. The kind goes before `taken` ones, keywords of Python, and those that begin with a digit.
    """
    plain = {name: re.sub(r"\W", "_", name, flags=re.ASCII) for name in names}
    return {
        name: f"{kind}_{text}" if text in taken or keyword.iskeyword(text) or text[:1].isdigit() else text or kind
        for name, text in plain.items()
    }


class _Reader:
    """Converter of sound elements to a robot; checks them against each other."""

    def __init__(
        self, name: str, links: list[urdf_elements.Link], joints: list[urdf_elements.Joint], base: str,
        locked: Mapping[str, float],
    ) -> None:  # fmt: skip
        self.links = {link.name: link for link in links}
        self.joints = {joint.name: joint for joint in joints}
        self.names = _names("robot", (name,))
        self.link_names = _names("link", self.links, GROUND.name)
        self.joint_names = _names("joint", self.joints, *[_FLOATING] * (base == "floating"))
        self.base = base
        self.every = (links, joints)
        self.carried = {joint.child.link: joint for joint in joints}
        self.locked = locked
        self.held = {joint.name: 0.0 for joint in joints if joint.type == "fixed"}
        self.held.update({name: float(value) for name, value in locked.items() if isinstance(value, Real)})
        self.repairs = list(self._held_mimics())

    def _held_mimics(self) -> Iterator[str]:
        """Yield repairs of joints that mimic where one of the two is held.

        A joint that mimics one that is held is held too.
        """
        mimics = {joint.name: joint.mimic for joint in self.joints.values() if joint.mimic is not None}
        if still := [name for name in mimics if name in self.held]:
            yield f"mimic of joints that are fixed, left out: {', '.join(still)}"
        moving = [name for name in mimics if self.joints[name].type in _SCALAR]
        while follower := next(
            (name for name in moving if name not in self.held and mimics[name].joint in self.held), None
        ):
            mimic = mimics[follower]
            self.held[follower] = mimic.multiplier * self.held[mimic.joint] + mimic.offset
            yield f"joint {follower} mimics {mimic.joint}, which is fixed: fixed at {self.held[follower]:.6g}"

    # -- faults ----------------------------------------------------------------------------------------------------

    def faults(self) -> Iterator[Fault]:
        """Yield what is wrong between sound elements."""
        links, joints = self.every
        yield from repeated("robot", self.names.values())
        yield from repeated("link", (self.link_names[link.name] for link in links))
        yield from repeated("joint", (self.joint_names[joint.name] for joint in joints))
        yield from self._locked_faults()
        carried = Counter(joint.child.link for joint in joints)
        roots = [name for name in self.links if name not in carried]
        for joint in joints:
            where = f"joint {joint.name}"
            for role, link in (("parent", joint.parent.link), ("child", joint.child.link)):
                if link not in self.links:
                    meant = f"No joint carries {' and '.join(roots)}: one may be meant." if role == "child" else ""
                    yield Fault(f"{where}, {role}", f"{link}, which is no link", f"one of {', '.join(self.links)}"[:200],
                                meant or unknown("link", link, self.links).remedy)  # fmt: skip
            if carried[joint.child.link] > 1:
                yield Fault(where, f"{joint.child.link}, which another joint carries too", "a tree",
                            "Close the loop by a joint of its own, Mechanism(name, (*robot.mechanism.joints, Revolute(...))).")  # fmt: skip
            yield from self._joint_faults(joint)
        if len(roots) != 1:
            yield Fault("links", f"{len(roots)} that no joint carries{': ' * bool(roots)}{', '.join(roots)}", "one: the base",
                        "" if roots else "The joints form a ring." if links else "No <link>: is the macro of an .xacro not called?")  # fmt: skip
        elif unreached := [name for name in self.links if self._base_of(name) != roots[0]]:
            yield Fault("links", f"a ring of joints: {', '.join(unreached)}", "a tree")
        else:
            yield from self._mass_faults()

    def _locked_faults(self) -> Iterator[Fault]:
        """Yield faults of locked joints and their values."""
        for name, value in self.locked.items():
            joint = self.joints.get(name)
            if joint is None:
                yield replace(unknown("joint", name, self.joints), where=f"locked, {name}")
            elif joint.type not in _SCALAR:
                yield Fault(f"locked, {name}", f"a {joint.type} joint", "a joint of one coordinate")
            if not isinstance(value, Real) or not math.isfinite(value):
                yield Fault(f"locked, {name}", shown(value), "a finite number, in rad or m")

    def _joint_faults(self, joint: urdf_elements.Joint) -> Iterator[Fault]:
        """Yield faults of a joint's axis and of what it mimics."""
        where, length = f"joint {joint.name}", sum(value**2 for value in joint.axis.xyz) ** 0.5
        if joint.type in ("revolute", "continuous", "prismatic", "planar") and not length > 0:
            yield Fault(f"{where}, axis", "0 0 0", "a direction")
        elif joint.type == "planar" and not any(abs(value) == length for value in joint.axis.xyz):
            expected = "an axis of the joint's frame, as normal of the plane"
            yield Fault(f"{where}, axis", f"{joint.axis.xyz}", expected, "Turn the frame by its <origin rpy>.")
        if joint.mimic is None:
            return
        other = self.joints.get(joint.mimic.joint)
        if other is None:
            yield Fault(f"{where}, mimic", f"{joint.mimic.joint}, which is no joint", "another joint",
                        unknown("joint", joint.mimic.joint, self.joints).remedy)  # fmt: skip
        if joint.name in self.held:
            return
        for each in (joint, *((other,) if other is not None else ())):
            if each.type not in _SCALAR:
                yield Fault(f"{where}, mimic", f"{each.name}, a {each.type} joint", "a joint of one coordinate")

    def _mass_faults(self) -> Iterator[Fault]:
        """Yield moving links that have no mass with what is fixed to them, because an element is missing."""
        for joint in self.joints.values():
            fixed = [
                link for link in self.links if joint.name not in self.held and self._rigid(link) == joint.child.link
            ]
            if fixed and all(self.links[link].inertial is None for link in fixed):
                actual = f"no <inertial>, and joint {joint.name} moves it"
                remedy = f'from_urdf(..., locked={{"{joint.name}": 0}}) welds it; within a chain <mass value="0"/> is allowed.'
                yield Fault(f"link {joint.child.link}", actual, "mass, mass centre and inertia", remedy)

    def _rigid(self, link: str) -> str:
        """First of the links that are fixed to each other."""
        joint = self.carried.get(link)
        return self._rigid(joint.parent.link) if joint is not None and joint.name in self.held else link

    def _base_of(self, link: str) -> str | None:
        """Link at the root of the tree it stands in; None in a ring."""
        chain = [link]
        while (joint := self.carried.get(chain[-1])) is not None:
            if joint.parent.link in chain:
                return None
            chain.append(joint.parent.link)
        return chain[-1]

    # -- the robot -------------------------------------------------------------------------------------------------

    def robot(self, left: Counter[str], nearest: bool) -> tuple[Robot, list[Fault]]:
        """Robot of elements without a fault, and faults of its inertias."""
        masses = {name: _massed(link.inertial) for name, link in self.links.items()}
        (mechanism, bodies), repairs, faults = repaired(masses, self._mechanism, nearest)
        named = [*self.names.items(), *self.link_names.items(), *self.joint_names.items()]
        renamed = ", ".join(f"{old or 'none'} is {new}" for old, new in named if new != old)
        collisions = {name: tuple(self._solids(link, bodies[name])) for name, link in self.links.items()}
        moving = {self.joint_names[name]: joint for name, joint in self.joints.items() if name not in self.held}
        return Robot(
            mechanism,
            MappingProxyType(bodies),
            tuple(self._effects(moving)),
            {name: Limits(j.limit.lower, j.limit.upper, j.limit.effort, j.limit.velocity)
             for name, j in moving.items() if j.limit is not None},
            {name: j.dynamics.friction for name, j in moving.items() if j.dynamics.friction},
            {name: solids for name, solids in collisions.items() if solids},
            tuple(self._left_out(left)),
            (*([f"names: {renamed}"] if renamed else []), *self.repairs, *repairs),
        ), faults  # fmt: skip

    def _mechanism(self, numbers: Mapping[str, Massed]) -> tuple[Mechanism, dict[str, Frame]]:
        """Mechanism of links of these numbers, and their bodies."""
        base = next(name for name in self.links if name not in self.carried)
        bodies: dict[str, Frame] = {base: GROUND}
        made: list[Joint] = []
        if self.base == "floating":
            body = bodies[base] = self._body(base, numbers)
            made.append(Free(_FLOATING, GROUND, body))
        waiting = [joint for joint in self.joints.values() if joint.parent.link == base]
        while waiting:
            joint = waiting.pop(0)
            child = bodies[joint.child.link] = self._body(joint.child.link, numbers)
            made.append(self._joint(joint, bodies[joint.parent.link], child))
            waiting[:0] = [other for other in self.joints.values() if other.parent.link == joint.child.link]
        return Mechanism(next(iter(self.names.values())), tuple(made)), bodies

    def _body(self, link: str, numbers: Mapping[str, Massed]) -> Body:
        """Make the body of a link, with the solids that are drawn."""
        return numbers[link].body(self.link_names[link], tuple(self._shapes(self.links[link])))

    def _joint(self, joint: urdf_elements.Joint, parent: Frame, child: Body) -> Joint:
        """Joint between two bodies; the child's frame is the joint's."""
        name = self.joint_names[joint.name]
        point = _placed(name, parent, joint.origin)
        x, y, z = (int(value) if value == int(value) else value for value in joint.axis.xyz)
        axis = Direction((x, y, z))
        if joint.name in self.held:
            return Weld(name, _moved(point, joint.type, axis, f"{name}_locked", self.held[joint.name]), child)
        if joint.type == "floating":
            return Free(name, point, child)
        if joint.type == "planar":
            return Planar(
                name, point, child, normal=next(d for d, value in zip((X, Y, Z), axis.components, strict=True) if value)
            )
        return (Prismatic if joint.type == "prismatic" else Revolute)(name, point, child, axis=axis)

    def _effects(self, moving: Mapping[str, urdf_elements.Joint]) -> Iterator[Effect]:
        """Yield couplings of joints that mimic others, and dampers."""
        for name, joint in moving.items():
            slides = joint.type == "prismatic"
            if joint.mimic is not None:
                other = self.joints[joint.mimic.joint]
                kinds = ("m" if slides else "rad", "m" if other.type == "prismatic" else "rad")
                unit = "1" if kinds[0] == kinds[1] else {"m": "m", "rad": "1/m"}[kinds[0]]
                ratio = Parameter(f"{name}_multiplier", unit, joint.mimic.multiplier)
                offset = number(f"{name}_offset", kinds[0], joint.mimic.offset)
                yield Coupling(f"{name}_mimic", name, self.joint_names[other.name], ratio=ratio, offset=offset)
            if joint.dynamics.damping and joint.type in _SCALAR:
                unit = "N s/m" if slides else "N m s/rad"
                damping = Parameter(f"{name}_damping", unit, joint.dynamics.damping)
                yield JointDamper(f"{name}_damper", name, damping)

    def _solids(self, link: urdf_elements.Link, body: Frame) -> Iterator[Solid]:
        """Yield the solids of contact of a link."""
        for count, solid in enumerate(link.collision, start=1):
            name = f"{self.link_names[link.name]}_solid_{count}"
            for kind in ("box", "cylinder", "sphere"):
                shape = getattr(solid.geometry, kind)
                if shape is not None:
                    values = dict(zip("xyz", shape.size, strict=True)) if kind == "box" else shape.model_dump()
                    sizes = {size: Parameter(f"{name}_size_{size}", "m", value) for size, value in values.items()}
                    yield Solid(kind, _placed(name, body, solid.origin), MappingProxyType(sizes))

    def _shapes(self, link: urdf_elements.Link) -> Iterator[Shape]:
        """Yield the solids of contact that a picture shows; boxes along the axes of the link alone."""
        for solid in self._solids(link, GROUND):
            if solid.kind != "box" or not solid.at.turns:
                axis = tuple(row[2] for row in solid.at.axes)
                yield Shape(solid.kind, tuple(solid.sizes.items()), axis, solid.at.position)

    def _left_out(self, left: Counter[str]) -> Iterator[str]:
        """Yield what the file has that the robot has not."""
        meshes = [
            link.name
            for link in self.links.values()
            if any(not any(vars(solid.geometry).values()) for solid in link.collision)
        ]
        if meshes:
            yield f"meshes, of {', '.join(meshes)}: their contact is for pairs of the scene to declare"
        for tag, count in sorted(left.items()):
            yield f"<{tag}>, {count} times"


def _massed(inertial: urdf_elements.Inertial | None) -> Massed:
    """Mass, mass centre and inertia along the link's axes; zeros of a link without."""
    if inertial is None:
        return Massed()
    J = inertial.inertia
    rows: Any = ((J.ixx, J.ixy, J.ixz), (J.ixy, J.iyy, J.iyz), (J.ixz, J.iyz, J.izz))
    if any(inertial.origin.rpy):
        turn = _rotation(inertial.origin.rpy)
        rows = multiply(multiply(turn, rows), transpose(turn))
    return Massed(inertial.mass.value, inertial.origin.xyz, tuple(tuple(map(float, row)) for row in rows))


def _moved(point: Point, kind: str, axis: Direction, name: str, value: float) -> Point:
    """Point after a joint's turn about its axis [rad] or slide along it [m]."""
    if not value:
        return point
    if kind != "prismatic":
        return point.turned(axis, Parameter(name, "rad", float(value)))
    step = scale(Parameter(name, "m", float(value)), apply(point.axes, axis.unit))
    return replace(point, position=add(point.position, step))


def _placed(name: str, body: Frame, origin: urdf_elements.Origin) -> Point:
    """Point of a body, with the axes that an origin gives it."""
    point = body.at(*position(name, origin.xyz))
    for angle, axis, value in zip(("yaw", "pitch", "roll"), (Z, Y, X), reversed(origin.rpy), strict=True):
        if value:
            point = point.turned(axis, Parameter(f"{name}_{angle}", "rad", value))
    return point


def _rotation(rpy: tuple[float, float, float]) -> Matrix:
    """Rotation matrix of roll, pitch and yaw [rad] about fixed axes, R_z R_y R_x."""
    turns = zip((X, Y, Z), map(sp.Float, rpy), strict=True)
    x, y, z = (about(axis.unit, sp.cos(angle), sp.sin(angle)) for axis, angle in turns)
    return multiply(z, multiply(y, x))
