"""Elements of a URDF file as pydantic models: each element, attribute and number by itself.

Relations between elements are checked in `urdf`. Imported only where such a file is read: importing pydantic takes a
good part of a second. Source of the format: the ROS wiki, urdf/XML/link and urdf/XML/joint.
"""

from __future__ import annotations

from collections import Counter
from typing import Annotated, Any, Literal
from xml.etree.ElementTree import Element

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.file_schema import form_faults

Name = Annotated[str, Field(description="a name")]
Number = Annotated[float, Field(allow_inf_nan=False, description="a finite number")]
Size = Annotated[float, Field(allow_inf_nan=False, gt=0, description="a positive number")]
Mass = Annotated[float, Field(allow_inf_nan=False, ge=0, description="a mass of at least 0 kg")]


def _numbers(text: Any) -> Any:
    return text.split() if isinstance(text, str) else text


Triple = Annotated[tuple[Number, Number, Number], BeforeValidator(_numbers), Field(description="three numbers")]


class _Element(BaseModel):
    model_config = ConfigDict(frozen=True)


class Named(_Element):
    """Reference to a link."""

    link: Name


class Origin(_Element):
    """Pose in the frame it stands in: position [m], turned by fixed-axis angles roll, pitch, yaw [rad]."""

    xyz: Triple = (0, 0, 0)
    rpy: Triple = (0, 0, 0)


class MassValue(_Element):
    """Mass [kg]."""

    value: Mass


class Inertia(_Element):
    """Inertia about the mass centre [kg m^2], products with J_xy = -integral of x y dm."""

    ixx: Number
    iyy: Number
    izz: Number
    ixy: Number = 0
    ixz: Number = 0
    iyz: Number = 0


class Inertial(_Element):
    """Mass, mass centre and inertia of a link."""

    origin: Origin = Origin()
    mass: MassValue
    inertia: Inertia


class Box(_Element):
    """Box of these sizes [m]."""

    size: Annotated[tuple[Size, Size, Size], BeforeValidator(_numbers), Field(description="three positive numbers")]


class Cylinder(_Element):
    """Cylinder along z [m]."""

    radius: Size
    length: Size


class Sphere(_Element):
    """Sphere [m]."""

    radius: Size


class Geometry(_Element):
    """One solid; a mesh has none of these."""

    box: Box | None = None
    cylinder: Cylinder | None = None
    sphere: Sphere | None = None


class Collision(_Element):
    """A solid of a link that may touch."""

    origin: Origin = Origin()
    geometry: Geometry


class Link(_Element):
    """A rigid body."""

    name: Name
    inertial: Inertial | None = None
    collision: tuple[Collision, ...] = ()


class Axis(_Element):
    """Axis of a joint in its own frame."""

    xyz: Triple


class Limit(_Element):
    """Range of a joint [rad or m], its greatest effort [N m or N] and speed [rad/s or m/s]."""

    lower: Number = 0
    upper: Number = 0
    effort: Number
    velocity: Number


class Dynamics(_Element):
    """Viscous damping [N m s/rad or N s/m] and dry friction [N m or N] of a joint."""

    damping: Annotated[float, Field(allow_inf_nan=False, ge=0, description="a number of at least 0")] = 0
    friction: Annotated[float, Field(allow_inf_nan=False, ge=0, description="a number of at least 0")] = 0


class Mimic(_Element):
    """Joint whose value another follows: multiplier * value + offset."""

    joint: Name
    multiplier: Number = 1
    offset: Number = 0


class Joint(_Element):
    """A joint from its parent's frame; the child's frame is that of the joint."""

    name: Name
    type: Literal["revolute", "continuous", "prismatic", "fixed", "floating", "planar"]
    parent: Named
    child: Named
    origin: Origin = Origin()
    axis: Axis = Axis(xyz=(1, 0, 0))
    limit: Limit | None = None
    dynamics: Dynamics = Dynamics()
    mimic: Mimic | None = None


_MODELS: dict[str, type[Link] | type[Joint]] = {"link": Link, "joint": Joint}
_LISTS = ("collision",)
_DRAWN = ("visual",)


def elements_of(root: Element) -> tuple[list[Link], list[Joint], list[Fault], Counter[str]]:
    """Links, joints, all their faults, and how often each tag was left out."""
    elements: dict[str, list[Any]] = {"link": [], "joint": []}
    faults: list[Fault] = []
    left = Counter(child.tag for child in root if child.tag not in _MODELS and isinstance(child.tag, str))
    counts: Counter[str] = Counter()
    for child in root:
        model = _MODELS.get(child.tag)
        if model is None:
            continue
        counts[child.tag] += 1
        where = f"{child.tag} {child.get('name', counts[child.tag])}"
        left.update(part.tag for part in child if part.tag not in (*model.model_fields, *_DRAWN))
        try:
            elements[child.tag].append(model.model_validate(_record(child)))
        except ValidationError as error:
            faults.extend(form_faults(error, model, where))
    return elements["link"], elements["joint"], faults, left


def _record(element: Element) -> dict[str, Any]:
    """Attributes and children by name."""
    record: dict[str, Any] = dict(element.attrib)
    for child in element:
        if child.tag in _LISTS:
            record.setdefault(child.tag, []).append(_record(child))
        elif isinstance(child.tag, str):
            record[child.tag] = _record(child)
    return record
