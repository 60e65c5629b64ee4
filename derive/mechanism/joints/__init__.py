"""Kinds of joints, one file per kind or family."""

from hertzwerk.derive.mechanism.joints.axial import Cylindrical, Prismatic, Revolute
from hertzwerk.derive.mechanism.joints.free import Free
from hertzwerk.derive.mechanism.joints.joint import Freedom, Joint, Port
from hertzwerk.derive.mechanism.joints.planar import Planar
from hertzwerk.derive.mechanism.joints.spherical import Spherical
from hertzwerk.derive.mechanism.joints.universal import Universal
from hertzwerk.derive.mechanism.joints.weld import Weld

__all__ = [
    "Cylindrical",
    "Free",
    "Freedom",
    "Joint",
    "Planar",
    "Port",
    "Prismatic",
    "Revolute",
    "Spherical",
    "Universal",
    "Weld",
]
