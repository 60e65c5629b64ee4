"""Robots of URDF files: bodies, joints, limits, solids of contact; each number is a parameter.

The format is that of the ROS wiki, urdf/XML; its units are SI. The file is read as data: nothing in it is executed or
fetched, and meshes are left out by name.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal
from xml.etree import ElementTree

import sympy as sp

from hertzwerk.derive.common.execute_file import beside
from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.identifiers import repeated
from hertzwerk.derive.common.toml_file import read_at_most
from hertzwerk.derive.declare.effects.couplings import Coupling
from hertzwerk.derive.declare.effects.effect import Effect
from hertzwerk.derive.declare.effects.springs import JointDamper
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, Frame, Point, Triple, X, Y, Z
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
from hertzwerk.derive.expressions.algebra.vectors import Matrix, Vector, about, multiply, transpose
from hertzwerk.derive.expressions.parameter import Parameter

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.user_files import urdf_elements

MAX_BYTES = 10_000_000
_EXPECTED = "a URDF file: XML with the root element <robot>"


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
    """

    mechanism: Mechanism
    bodies: Mapping[str, Frame]
    effects: tuple[Effect, ...] = ()
    limits: Mapping[str, Limits] = field(default_factory=dict)
    friction: Mapping[str, float] = field(default_factory=dict)
    collisions: Mapping[str, tuple[Solid, ...]] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()

    def scene(
        self, *effects: Effect, scales: Scales, pairs: tuple[Pair, ...] = (), start: Start | None = None, name: str = ""
    ) -> Scene:
        """Scene of the robot with its own effects and these; raises InputError for unsound declarations."""
        mechanism = Mechanism(self.mechanism.name, self.mechanism.joints, tuple(pairs))
        return Scene(mechanism, (*self.effects, *effects), scales, start or Start(), name)


def from_urdf(path: str | Path, base: Literal["fixed", "floating"] = "fixed") -> Robot:
    """Robot of a URDF file, whose first link is fixed to the ground or floats.

    A relative path is from the scene file's folder. Raises InputError with every fault of the file.
    """
    if base not in ("fixed", "floating"):
        raise InputError(str(path), [Fault("base", repr(base), "'fixed' or 'floating'")])
    from hertzwerk.derive.exchange.user_files.urdf_elements import elements_of  # imports pydantic

    root = _read(beside(path))
    links, joints, faults, left = elements_of(root)
    reader = _Reader(root.get("name", ""), links, joints, base)
    if not faults:
        faults = list(reader.faults())
    if faults:
        raise InputError(str(path), faults)
    return reader.robot(left)


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


def _plain(name: str) -> str:
    """Name as hertzwerk's names are: other characters become _."""
    return re.sub(r"\W", "_", name, flags=re.ASCII)


class _Reader:
    """Converter of sound elements to a robot; checks them against each other."""

    def __init__(
        self, name: str, links: list[urdf_elements.Link], joints: list[urdf_elements.Joint], base: str
    ) -> None:
        self.name = name
        self.links = {link.name: link for link in links}
        self.joints = {joint.name: joint for joint in joints}
        self.base = base
        self.every = (links, joints)
        self.carried = {joint.child.link: joint for joint in joints}

    # -- faults ----------------------------------------------------------------------------------------------------

    def faults(self) -> Iterator[Fault]:
        """Yield what is wrong between sound elements."""
        links, joints = self.every
        yield from repeated("robot", (_plain(self.name),))
        yield from repeated("link", (_plain(link.name) for link in links))
        yield from repeated("joint", (_plain(joint.name) for joint in joints))
        carried = Counter(joint.child.link for joint in joints)
        for joint in joints:
            where = f"joint {joint.name}"
            for role, link in (("parent", joint.parent.link), ("child", joint.child.link)):
                if link not in self.links:
                    yield Fault(
                        f"{where}, {role}", f"{link}, which is no link", f"one of {', '.join(self.links)}"[:200]
                    )
            if carried[joint.child.link] > 1:
                yield Fault(where, f"{joint.child.link}, which another joint carries too", "a tree",
                            "Close the loop by a joint of its own, Mechanism(name, (*robot.mechanism.joints, Revolute(...))).")  # fmt: skip
            yield from self._joint_faults(joint)
        roots = [name for name in self.links if name not in carried]
        if len(roots) != 1:
            yield Fault("links", f"{len(roots)} that no joint carries{': ' * bool(roots)}{', '.join(roots)}", "one: the base",
                        "" if roots else "The joints form a ring.")  # fmt: skip
        elif unreached := [name for name in self.links if self._base_of(name) != roots[0]]:
            yield Fault("links", f"a ring of joints: {', '.join(unreached)}", "a tree")
        else:
            yield from self._mass_faults()

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
            yield Fault(f"{where}, mimic", f"{joint.mimic.joint}, which is no joint", "another joint")
        for each in (joint, *((other,) if other is not None else ())):
            if each.type not in ("revolute", "continuous", "prismatic"):
                yield Fault(f"{where}, mimic", f"{each.name}, a {each.type} joint", "a joint of one coordinate")

    def _mass_faults(self) -> Iterator[Fault]:
        """Yield moving links that have no mass with what is fixed to them, because an element is missing."""
        for joint in self.joints.values():
            fixed = [link for link in self.links if joint.type != "fixed" and self._rigid(link) == joint.child.link]
            if fixed and all(self.links[link].inertial is None for link in fixed):
                found = f"no <inertial>, and joint {joint.name} moves it"
                remedy = 'A mass of 0 is given as <mass value="0"/>, and is allowed within a chain.'
                yield Fault(f"link {joint.child.link}", found, "mass, mass centre and inertia", remedy)

    def _rigid(self, link: str) -> str:
        """First of the links that are fixed to each other."""
        joint = self.carried.get(link)
        return self._rigid(joint.parent.link) if joint is not None and joint.type == "fixed" else link

    def _base_of(self, link: str) -> str | None:
        """Link at the root of the tree it stands in; None in a ring."""
        seen = [link]
        while (joint := self.carried.get(seen[-1])) is not None:
            if joint.parent.link in seen:
                return None
            seen.append(joint.parent.link)
        return seen[-1]

    # -- the robot -------------------------------------------------------------------------------------------------

    def robot(self, left: Counter[str]) -> Robot:
        """Robot of elements without a fault."""
        base = next(name for name in self.links if name not in self.carried)
        bodies: dict[str, Frame] = {}
        made: list[Joint] = []
        if self.base == "floating":
            bodies[base] = self._body(self.links[base])
            made.append(Free("floating_base", GROUND, bodies[base]))
        else:
            bodies[base] = GROUND
        waiting = [joint for joint in self.joints.values() if joint.parent.link == base]
        while waiting:
            joint = waiting.pop(0)
            child = bodies[joint.child.link] = self._body(self.links[joint.child.link])
            made.append(self._joint(joint, bodies[joint.parent.link], child))
            waiting[:0] = [other for other in self.joints.values() if other.parent.link == joint.child.link]
        collisions = {name: tuple(self._solids(link, bodies[name])) for name, link in self.links.items()}
        return Robot(
            Mechanism(_plain(self.name), tuple(made)),
            MappingProxyType(bodies),
            tuple(self._effects()),
            {_plain(j.name): Limits(j.limit.lower, j.limit.upper, j.limit.effort, j.limit.velocity)
             for j in self.joints.values() if j.limit is not None and j.type != "fixed"},
            {_plain(j.name): j.dynamics.friction for j in self.joints.values() if j.dynamics.friction},
            {name: solids for name, solids in collisions.items() if solids},
            tuple(self._left_out(left)),
        )  # fmt: skip

    def _body(self, link: urdf_elements.Link) -> Body:
        """Make the body of a link, massless where the file gives it no mass."""
        name, given = _plain(link.name), link.inertial
        shapes = tuple(self._shapes(link))
        if given is None or given.mass.value == 0:
            return Body(name, 0, shapes=shapes)
        mass = Parameter(f"{name}_mass", "kg", given.mass.value, f"mass of {link.name}")
        return Body(name, mass, _inertia(name, given), _position(f"{name}_centre", given.origin.xyz), shapes)

    def _joint(self, joint: urdf_elements.Joint, parent: Frame, child: Body) -> Joint:
        """Joint between two bodies; the child's frame is the joint's."""
        name = _plain(joint.name)
        point = _placed(name, parent, joint.origin)
        if joint.type == "fixed":
            return Weld(name, point, child)
        if joint.type == "floating":
            return Free(name, point, child)
        x, y, z = (int(value) if value == int(value) else value for value in joint.axis.xyz)
        if joint.type == "planar":
            return Planar(name, point, child, normal=next(d for d, value in ((X, x), (Y, y), (Z, z)) if value))
        kind = Prismatic if joint.type == "prismatic" else Revolute
        return kind(name, point, child, axis=Direction((x, y, z)))

    def _effects(self) -> Iterator[Effect]:
        """Yield couplings of joints that mimic others, and dampers."""
        for joint in self.joints.values():
            name, slides = _plain(joint.name), joint.type == "prismatic"
            if joint.mimic is not None:
                other = self.joints[joint.mimic.joint]
                kinds = ("m" if slides else "rad", "m" if other.type == "prismatic" else "rad")
                unit = "1" if kinds[0] == kinds[1] else {"m": "m", "rad": "1/m"}[kinds[0]]
                ratio = Parameter(f"{name}_multiplier", unit, joint.mimic.multiplier)
                offset = _number(f"{name}_offset", kinds[0], joint.mimic.offset)
                yield Coupling(f"{name}_mimic", name, _plain(other.name), ratio=ratio, offset=offset)
            if joint.dynamics.damping and joint.type in ("revolute", "continuous", "prismatic"):
                unit = "N s/m" if slides else "N m s/rad"
                damping = Parameter(f"{name}_damping", unit, joint.dynamics.damping)
                yield JointDamper(f"{name}_damper", name, damping)

    def _solids(self, link: urdf_elements.Link, body: Frame) -> Iterator[Solid]:
        """Yield the solids of contact of a link."""
        for number, solid in enumerate(link.collision, start=1):
            name = f"{_plain(link.name)}_solid_{number}"
            for kind in ("box", "cylinder", "sphere"):
                given = getattr(solid.geometry, kind)
                if given is not None:
                    values = dict(zip("xyz", given.size, strict=True)) if kind == "box" else given.model_dump()
                    sizes = {what: Parameter(f"{name}_size_{what}", "m", value) for what, value in values.items()}
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


def _number(name: str, unit: str, value: Any, meaning: str = "") -> Any:
    """A parameter, or a structural zero."""
    return Parameter(name, unit, float(value), meaning) if value else 0


def _inertia(name: str, given: urdf_elements.Inertial) -> Triple:
    """Inertia about the mass centre along the link's axes [kg m^2]: principal values, or all rows."""
    J = given.inertia
    rows: Any = ((J.ixx, J.ixy, J.ixz), (J.ixy, J.iyy, J.iyz), (J.ixz, J.iyz, J.izz))
    if any(given.origin.rpy):
        turn = _rotation(given.origin.rpy)
        rows = multiply(multiply(turn, rows), transpose(turn))
    xx, xy, xz, yy, yz, zz = (
        _number(f"{name}_i{'xyz'[i]}{'xyz'[k]}", "kg m^2", rows[i][k]) for i in range(3) for k in range(i, 3)
    )
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)) if any((xy, xz, yz)) else (xx, yy, zz)


def _position(name: str, xyz: tuple[float, float, float]) -> Vector:
    """Position [m] of parameters."""
    return tuple(_number(f"{name}_{k}", "m", value) for k, value in zip("xyz", xyz, strict=True))


def _placed(name: str, body: Frame, origin: urdf_elements.Origin) -> Point:
    """Point of a body, with the axes that an origin gives it."""
    point = body.at(*_position(name, origin.xyz))
    for what, axis, value in zip(("yaw", "pitch", "roll"), (Z, Y, X), reversed(origin.rpy), strict=True):
        if value:
            point = point.turned(axis, Parameter(f"{name}_{what}", "rad", value))
    return point


def _rotation(rpy: tuple[float, float, float]) -> Matrix:
    """Rotation matrix of roll, pitch and yaw [rad] about fixed axes, R_z R_y R_x."""
    turns = zip((X, Y, Z), map(sp.Float, rpy), strict=True)
    x, y, z = (about(axis.unit, sp.cos(angle), sp.sin(angle)) for axis, angle in turns)
    return multiply(z, multiply(y, x))
