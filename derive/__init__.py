"""Declaration, derivation and audit: from a scene to the text of a generated module. Names are handed on lazily (PEP 562)."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOME = {
    "Parameter": "parameter",
    "Interval": "parameter",
    **dict.fromkeys(
        ("GROUND", "X", "Y", "Z", "BallInSocket", "Body", "CornerOnFace", "CustomPair", "CylinderOnPlane", "Cylindrical", "Direction",
         "Free", "Material", "Mechanism", "ParallelCylinders", "PinInBush", "Planar", "Point", "Prismatic", "Revolute", "RimOnPlane",
         "SphereOnPlane", "SphereOnSphere", "Spherical", "Universal", "Weld"), "mechanism"),
    **dict.fromkeys(
        ("BodyTorque", "ConstantSpeed", "Contact", "Drive", "EnergyLedger", "Friction", "Gravity", "Harmonic", "JointDamper", "JointForce",
         "JointFriction", "JointSpring", "Lubrication", "PointDamper", "PointForce", "PointSpring", "Potential", "Ramp", "Scales", "Scene",
         "Start"), "scene"),
    "Element": "effects.element",
    "element": "elements",
    **dict.fromkeys(("APART", "TURN"), "pairs"),
    **dict.fromkeys(("T", "coordinate_of", "speed_of"), "effects.expression"),
    "Table": "tables",
    "Where": "functions",
    "InputError": "faults",
    "Fault": "faults",
    **dict.fromkeys(("audit_scene", "Finding", "InconsistentUnits"), "audit"),
    **dict.fromkeys(("derive", "generate"), "derivation"),
    "LAWS": "laws",
    "laws_from": "lawfile",
    "audit_expression": "audit_text",
    **dict.fromkeys(("audit_catalogue", "audit_path"), "audit_files"),
}  # fmt: skip

__all__ = sorted(_HOME)


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
