"""Declaration, derivation and audit: from a scene to the text of a generated module. Names are handed on lazily (PEP 562)."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOME = {
    name: module
    for module, names in {
        "mechanism.parameter": "Interval Parameter",
        "mechanism.bodies": "GROUND Body Direction Material Point X Y Z",
        "mechanism.joints": "Cylindrical Free Freedom Joint Planar Prismatic Revolute Spherical Universal Weld",
        "mechanism.pairs": "APART BallInSocket CornerOnFace CustomPair CylinderOnPlane ParallelCylinders PinInBush RimOnPlane SphereOnPlane "
        "SphereOnSphere TURN",
        "mechanism.mechanism": "Mechanism",
        "effects.drives": "ConstantSpeed Drive Harmonic Ramp",
        "effects.element": "Element",
        "effects.elements": "element",
        "effects.expression": "T coordinate_of speed_of",
        "effects.forces": "BodyTorque JointForce PointForce Potential",
        "effects.lubrication": "Lubrication",
        "effects.springs": "JointDamper JointFriction JointSpring PointDamper PointSpring",
        "declare.scene": "Contact EnergyLedger Friction Gravity Scales Scene Start",
        "algebra.functions": "Where",
        "algebra.splines": "Table",
        "laws": "LAWS",
        "faults": "Fault InputError",
        "audit.audit": "Finding InconsistentUnits",
        "files.audit_files": "audit_catalogue audit_path",
        "files.audit_text": "audit_expression",
        "files.lawfile": "laws_from",
        "derivation": "audit_scene derive generate",
    }.items()
    for name in names.split()
}

__all__ = sorted(_HOME)


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return __all__
