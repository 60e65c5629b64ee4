"""Hard scenes with couplings beside what implies or contradicts them.

Derived when run, never committed.
"""

from __future__ import annotations

from collections.abc import Callable

from hertzwerk.derive.declare.effects.couplings import Coupling
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.springs import JointSpring
from hertzwerk.derive.declare.effects.state_expression import T, coordinate_of
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, X, Z
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic, Revolute
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.expressions.parameter import Parameter

_SIZE, _BASE = Parameter("size", "m", 0.1, "of a crank"), Parameter("base", "m", 0.3, "between the shafts")
_MASS, _PACE = Parameter("mass", "kg", 2), Parameter("pace", "rad/s", 10, "of the cranks at the start")
_SCALES = Scales(length=_SIZE, speed=_SIZE * _PACE, arm=_SIZE)


def _parallelogram(name: str, summary: str, coupling: Coupling) -> Scene:
    """Two equal cranks with a coupler between them, and what couples their shafts.

    Without gravity they turn at a constant speed.
    """
    inertia = Parameter("inertia", "kg m^2", 0.01)
    left, right, bar = (
        Body("left_crank", _MASS, inertia),
        Body("right_crank", _MASS, inertia),
        Body("bar", _MASS, inertia, (_BASE / 2, 0, 0)),
    )
    joints = (
        Revolute("left", GROUND, left, axis=Z),
        Revolute("right", GROUND.at(_BASE, 0, 0), right, axis=Z),
        Revolute("pin", left.at(_SIZE, 0, 0), bar, axis=Z),
        Revolute("end", bar.at(_BASE, 0, 0), right.at(_SIZE, 0, 0), axis=Z),
    )
    lead = Parameter("lead", "rad", 1)
    start = Start(position={"left": lead}, speed={"left": _PACE}, near={"right": lead, "pin": -lead})
    return Scene(Mechanism(name, joints), (coupling, EnergyLedger()), _SCALES, start, summary=summary)


def geared_parallelogram() -> Scene:
    """Parallelogram whose cranks are geared 1 to 1 too, which its bars imply but in its change points."""
    return _parallelogram(
        "geared_parallelogram",
        "a parallelogram with a gear that says the same",
        Coupling("gear", "right", "left", ratio=1),
    )


def torn_parallelogram() -> Scene:
    """Parallelogram of which a gear turns one crank ahead of the other, as its bars do not allow."""
    torn = Parameter("torn", "rad/s", 0)
    gear = Coupling(
        "gear", equation=coordinate_of("right") - coordinate_of("left") - torn * T**2 * Parameter("rate", "1/s", 1)
    )
    return _parallelogram("torn_parallelogram", "a parallelogram that a gear tears", gear)


def twin_gears() -> Scene:
    """Two wheels with two equal gear pairs, and a rack that both of them drive, on a spring."""
    inertia, ratio, pitch = (
        Parameter("inertia", "kg m^2", 0.01),
        Parameter("ratio", "1", -2),
        Parameter("pitch_radius", "m", 0.05),
    )
    wheel, pinion, rack = (Body(name, _MASS, inertia) for name in ("wheel_body", "pinion_body", "rack_body"))
    joints = (
        Revolute("wheel", GROUND, wheel, axis=Z),
        Revolute("pinion", GROUND.at(_BASE, 0, 0), pinion, axis=Z),
        Prismatic("rack", GROUND, rack, axis=X),
    )
    effects = (
        Coupling("first_pair", "pinion", "wheel", ratio),
        Coupling("second_pair", "pinion", "wheel", ratio),
        Coupling("wheel_rack", "rack", "wheel", ratio=pitch),
        Coupling("pinion_rack", "rack", "pinion", ratio=pitch / ratio),
        JointSpring("spring", "wheel", Parameter("stiffness", "N m/rad", 5)),
        EnergyLedger(),
    )
    start = Start(position={"wheel": Parameter("lead", "rad", 1)}, speed={"wheel": Parameter("still", "rad/s", 0)})
    return Scene(
        Mechanism("twin_gears", joints),
        effects,
        _SCALES,
        start,
        summary="two gear pairs and two racks that say the same",
    )


COUPLED: dict[str, Callable[[], Scene]] = {
    scene.__name__: scene for scene in (geared_parallelogram, torn_parallelogram, twin_gears)
}
