"""Faults of couplings, each with its way out; units proven; scenes that cannot have one; what readers see."""

from dataclasses import dataclass

import pytest
import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    Coupling,
    Cylindrical,
    InputError,
    Joint,
    JointForce,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Spherical,
    T,
    Where,
    X,
    Y,
    Z,
    audit_scene,
    coordinate_of,
    derive,
    speed_of,
)

r, m, J = Parameter("pitch_radius", "m", 0.1), Parameter("mass", "kg", 1.0), Parameter("inertia", "kg m^2", 0.1)
pace, w, number = Parameter("pace", "m/s", 1.0), Parameter("w", "rad/s", 1.0), Parameter("teeth_ratio", "1", -2.0)
wheel, pinion, block = (Body(name, m, J) for name in ("wheel_body", "pinion_body", "block"))
PARTS = (
    Revolute("wheel", GROUND, wheel, axis=Z),
    Revolute("pinion", GROUND.at(r, 0, 0), pinion, axis=Z),
    Prismatic("rack", GROUND, block, axis=X),
)
angle, other, travel = map(coordinate_of, ("wheel", "pinion", "rack"))


def scene(*effects, joints=PARTS) -> Scene:
    return Scene(Mechanism("coupled", joints), effects, Scales(r, pace, arm=r))


SMOOTH = "an equation that is twice differentiable"
REFUSED = {
    "a ratio of the wrong unit": (Coupling("mesh", "rack", "wheel", number), "effect mesh, ratio", "a quantity in m"),
    "a number for a radius": (Coupling("mesh", "rack", "wheel", 0.1), "effect mesh, ratio", "a quantity in m/rad"),
    "an offset in metres": (Coupling("mesh", "pinion", "wheel", -2, offset=r), "effect mesh, offset", "a quantity in 1"),
    "no ratio": (Coupling("mesh", "pinion", "wheel"), "effect mesh", "two joints and their ratio, or an equation"),
    "nothing": (Coupling("mesh"), "effect mesh", "two joints and their ratio, or an equation"),
    "both": (Coupling("mesh", "pinion", "wheel", -2, equation=angle), "effect mesh", "either"),
    "text": (Coupling("mesh", equation="wheel - pinion"), "effect mesh, equation", "an expression that is zero where it holds"),
    "a number for a joint": (Coupling("mesh", 3, "wheel", -2), "effect mesh, first", "the name of a joint"),
    "another joint": (Coupling("mesh", "pinion", "gear", -2), "effect mesh", "one of wheel, pinion, rack"),
    "another joint in an equation": (Coupling("mesh", equation=angle - coordinate_of("gear")), "effect mesh", "one of wheel, pinion, rack"),
    "itself": (Coupling("mesh", "wheel", "wheel", -2), "effect mesh", "two coordinates"),
    "a ratio of zero": (Coupling("mesh", "wheel", "pinion", 0), "effect mesh, ratio", "another ratio"),
    "no coordinate": (Coupling("mesh", equation=w * T), "effect mesh, equation", "an equation between coordinates"),
    "unlike terms": (Coupling("mesh", equation=angle - travel), "effect mesh, equation", "1"),
    "an area": (Coupling("mesh", equation=travel**2 - r**2), "effect mesh, equation", "a length [m] or an angle [rad]"),
    "a speed": (Coupling("mesh", equation=angle - speed_of("pinion") / w), "effect mesh, equation", "an expression of time and coordinate"),
    "a jump": (Coupling("mesh", equation=angle - sp.Abs(other)), "effect mesh, equation", SMOOTH),
    "a step": (Coupling("mesh", equation=angle - sp.Heaviside(other)), "effect mesh, equation", SMOOTH),
    "a choice": (Coupling("mesh", equation=angle - Where(other > 0, other, 2 * other)), "effect mesh, equation", SMOOTH),
    "a branch": (Coupling("mesh", equation=angle - sp.Piecewise((other, other > 0), (0, True))), "effect mesh, equation", SMOOTH),
    "a function without a rule": (Coupling("mesh", equation=angle - sp.gamma(other)), "effect mesh, equation", "known functions"),
}  # fmt: skip


@pytest.mark.parametrize("label", REFUSED)
def test_a_coupling_that_cannot_be_is_refused(label):
    coupling, where, expected = REFUSED[label]
    with pytest.raises(InputError) as caught:
        scene(coupling)
    found = [fault for fault in caught.value.faults if fault.where == where]
    assert any(expected in fault.expected for fault in found), caught.value
    assert all(fault.where.startswith("effect mesh") for fault in caught.value.faults)


def test_all_faults_are_reported_at_once():
    with pytest.raises(InputError) as caught:
        scene(Coupling("mesh", "rack", "wheel", number), Coupling("belt", "wheel", "wheel", -2), Coupling("screw"))
    assert [fault.where for fault in caught.value.faults] == ["effect screw"]  # the form first
    with pytest.raises(InputError) as caught:
        scene(Coupling("mesh", "rack", "wheel", number), Coupling("belt", "wheel", "wheel", -2))
    assert {fault.where for fault in caught.value.faults} == {"effect mesh, ratio", "effect belt"}


def test_a_joint_that_closes_a_loop_without_a_coordinate_is_refused_by_name():
    closing = Spherical("closing", pinion.at(r, 0, 0), wheel)
    with pytest.raises(InputError, match="joint 'closing', which closes a loop"):
        scene(Coupling("mesh", "closing", "wheel", 1), joints=(*PARTS, closing))


def test_angles_in_space_are_counted_in_absolute_coordinates():
    triple = (J, J, J)
    bevel = Body("bevel", m, triple), Body("crown", m, triple)
    joints = Revolute("crown", GROUND, bevel[1], axis=Y), Revolute("bevel", GROUND, bevel[0], axis=X)
    screw = Cylindrical("press", GROUND.at(0, r, 0), Body("nut", m, triple), axis=X)
    turned = scene(Coupling("mesh", "bevel", "crown", number), joints=(*joints, screw))
    assert not turned.states
    module = derive(turned.with_coordinates("absolute"))
    assert [row[0] for row in module.tables["EFFECTS"] if row[1] == "counted_angle"] == ["crown_count", "bevel_count"]


@dataclass(frozen=True, init=False)
class Wrist(Joint):
    """Three turns, of which no rule tells the angles."""

    @property
    def freedoms(self):
        return self.turn(X, "a"), self.turn(Y, "b"), self.turn(Z, "c")


def test_a_freedom_that_cannot_be_measured_is_refused_in_absolute_coordinates():
    hub, cup = (Body(name, m, (J, J, J)) for name in ("hub", "cup"))
    joints = Revolute("wheel", GROUND, hub, axis=Z), Wrist("wrist", hub.at(r, 0, 0), cup)
    with pytest.raises(InputError, match=r"wrist\.a, of a wrist joint"):
        derive(scene(Coupling("mesh", "wrist.a", "wrist.b", 1), joints=joints).with_coordinates("absolute"))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_units_are_proven(coordinates):
    mesh, rack = Coupling("mesh", "pinion", "wheel", number), Coupling("rack_mesh", "rack", "wheel", r)
    slot = Coupling("slot", equation=travel - r * sp.cos(other))
    for coupling, force in ((mesh, "N m"), (rack, "N"), (slot, "N")):
        coupled = scene(coupling, JointForce("motor", "wheel", Parameter("M", "N m", 1.0))).with_coordinates(
            coordinates
        )
        assert not [finding for finding in audit_scene(coupled) if finding.verdict != "consistent"]
        accelerations = next(f for f in derive(coupled).functions if f.name == "accelerations")
        (multipliers,) = [result for result in accelerations.results if result.name == "multipliers"]
        assert multipliers.units[-1] == force


def test_a_steady_rotation_that_is_geared_has_no_common_period():
    """A third of a turn a turn: what the wheel carries repeats after three, which the drive alone does not say."""
    driven = scene(ConstantSpeed("motor", "pinion", w), JointForce("load", "wheel", Parameter("M", "N m", 1.0)))
    assert "period" in [function.name for function in derive(driven).functions]
    geared = scene(*driven.effects, Coupling("mesh", "wheel", "pinion", number))
    assert "period" not in [function.name for function in derive(geared).functions]
