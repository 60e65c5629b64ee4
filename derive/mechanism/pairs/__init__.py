"""Kinds of contact pairs, one file per family."""

from hertzwerk.derive.mechanism.pairs.corner import CornerOnFace
from hertzwerk.derive.mechanism.pairs.custom import APART, TURN, CustomPair, Posed, PoseSymbol
from hertzwerk.derive.mechanism.pairs.flat import CylinderOnPlane, RimOnPlane, SphereOnPlane
from hertzwerk.derive.mechanism.pairs.pair import Pair
from hertzwerk.derive.mechanism.pairs.round import BallInSocket, ParallelCylinders, PinInBush, SphereOnSphere

__all__ = [
    "APART",
    "TURN",
    "BallInSocket",
    "CornerOnFace",
    "CustomPair",
    "CylinderOnPlane",
    "Pair",
    "ParallelCylinders",
    "PinInBush",
    "PoseSymbol",
    "Posed",
    "RimOnPlane",
    "SphereOnPlane",
    "SphereOnSphere",
]
