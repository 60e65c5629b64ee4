"""Faults of couplings, each with its way out; units proven; scenes that cannot have one; what readers see."""

from dataclasses import dataclass

import pytest
import sympy as sp
from each import each

import hertzwerk.derive as hd

p = hd.Parameter
r, m, J = p("pitch_radius", "m", 0.1), p("mass", "kg", 1.0), p("inertia", "kg m^2", 0.1)
pace, w, number = p("pace", "m/s", 1.0), p("w", "rad/s", 1.0), p("teeth_ratio", "1", -2.0)
wheel, pinion, block = (hd.Body(name, m, J) for name in ("wheel_body", "pinion_body", "block"))
PARTS = (
    hd.Revolute("wheel", hd.GROUND, wheel, axis=hd.Z),
    hd.Revolute("pinion", hd.GROUND.at(r, 0, 0), pinion, axis=hd.Z),
    hd.Prismatic("rack", hd.GROUND, block, axis=hd.X),
)
angle, other, travel = map(hd.coordinate_of, ("wheel", "pinion", "rack"))


def scene(*effects, joints=PARTS) -> hd.Scene:
    return hd.Scene(hd.Mechanism("coupled", joints), effects, hd.Scales(r, pace, arm=r))


SMOOTH = "an equation that is twice differentiable"
REFUSED = {
    "a ratio of the wrong unit": (hd.Coupling("mesh", "rack", "wheel", number), "effect mesh, ratio", "a quantity in m"),
    "a number for a radius": (hd.Coupling("mesh", "rack", "wheel", 0.1), "effect mesh, ratio", "a quantity in m/rad"),
    "an offset in metres": (hd.Coupling("mesh", "pinion", "wheel", -2, offset=r), "effect mesh, offset", "a quantity in 1"),
    "no ratio": (hd.Coupling("mesh", "pinion", "wheel"), "effect mesh", "two joints and their ratio, or an equation"),
    "nothing": (hd.Coupling("mesh"), "effect mesh", "two joints and their ratio, or an equation"),
    "both": (hd.Coupling("mesh", "pinion", "wheel", -2, equation=angle), "effect mesh", "either"),
    "text": (hd.Coupling("mesh", equation="wheel - pinion"), "effect mesh, equation", "an expression that is zero where it holds"),
    "a number for a joint": (hd.Coupling("mesh", 3, "wheel", -2), "effect mesh, first", "the name of a joint"),
    "another joint": (hd.Coupling("mesh", "pinion", "gear", -2), "effect mesh", "one of wheel, pinion, rack"),
    "another joint in an equation": (hd.Coupling("mesh", equation=angle - hd.coordinate_of("gear")), "effect mesh", "one of wheel, pinion, rack"),
    "itself": (hd.Coupling("mesh", "wheel", "wheel", -2), "effect mesh", "two coordinates"),
    "a ratio of zero": (hd.Coupling("mesh", "wheel", "pinion", 0), "effect mesh, ratio", "another ratio"),
    "no coordinate": (hd.Coupling("mesh", equation=w * hd.T), "effect mesh, equation", "an equation between coordinates"),
    "unlike terms": (hd.Coupling("mesh", equation=angle - travel), "effect mesh, equation", "1"),
    "an area": (hd.Coupling("mesh", equation=travel**2 - r**2), "effect mesh, equation", "a length [m] or an angle [rad]"),
    "a speed": (hd.Coupling("mesh", equation=angle - hd.speed_of("pinion") / w), "effect mesh, equation", "an expression of time and coordinate"),
    "a jump": (hd.Coupling("mesh", equation=angle - sp.Abs(other)), "effect mesh, equation", SMOOTH),
    "a step": (hd.Coupling("mesh", equation=angle - sp.Heaviside(other)), "effect mesh, equation", SMOOTH),
    "a choice": (hd.Coupling("mesh", equation=angle - hd.Where(other > 0, other, 2 * other)), "effect mesh, equation", SMOOTH),
    "a branch": (hd.Coupling("mesh", equation=angle - sp.Piecewise((other, other > 0), (0, True))), "effect mesh, equation", SMOOTH),
    "a function without a rule": (hd.Coupling("mesh", equation=angle - sp.gamma(other)), "effect mesh, equation", "known functions"),
}  # fmt: skip


@each("label", REFUSED)
def test_a_coupling_that_cannot_be_is_refused(label):
    coupling, where, expected = REFUSED[label]
    with pytest.raises(hd.InputError) as caught:
        scene(coupling)
    actual = [fault for fault in caught.value.faults if fault.where == where]
    assert any(expected in fault.expected for fault in actual), caught.value
    assert all(fault.where.startswith("effect mesh") for fault in caught.value.faults)


def test_all_faults_are_reported_at_once():
    forms = hd.Coupling("mesh", "rack", "wheel", number), hd.Coupling("belt", "wheel", "wheel", -2)
    with pytest.raises(hd.InputError) as caught:
        scene(*forms, hd.Coupling("screw"))
    assert [fault.where for fault in caught.value.faults] == ["effect screw"]  # the form first
    with pytest.raises(hd.InputError) as caught:
        scene(*forms)
        scene(hd.Coupling("mesh", "rack", "wheel", number), hd.Coupling("belt", "wheel", "wheel", -2))
    assert {fault.where for fault in caught.value.faults} == {"effect mesh, ratio", "effect belt"}
    closing = hd.Spherical("closing", pinion.at(r, 0, 0), wheel)
    with pytest.raises(hd.InputError, match="joint 'closing', which closes a loop"):
        scene(hd.Coupling("mesh", "closing", "wheel", 1), joints=(*PARTS, closing))


def test_angles_in_space_are_counted_in_absolute_coordinates():
    triple = (J, J, J)
    bevel = hd.Body("bevel", m, triple), hd.Body("crown", m, triple)
    joints = hd.Revolute("crown", hd.GROUND, bevel[1], axis=hd.Y), hd.Revolute("bevel", hd.GROUND, bevel[0], axis=hd.X)
    screw = hd.Cylindrical("press", hd.GROUND.at(0, r, 0), hd.Body("nut", m, triple), axis=hd.X)
    turned = scene(hd.Coupling("mesh", "bevel", "crown", number), joints=(*joints, screw))
    assert not turned.states
    module = hd.derive(turned.with_coordinates("absolute"))
    assert [row[0] for row in module.tables["EFFECTS"] if row[1] == "counted_angle"] == ["crown_count", "bevel_count"]


@dataclass(frozen=True, init=False)
class Wrist(hd.Joint):
    """Three turns, of which no rule tells the angles."""

    @property
    def freedoms(self):
        return self.turn(hd.X, "a"), self.turn(hd.Y, "b"), self.turn(hd.Z, "c")


def test_a_freedom_that_cannot_be_measured_is_refused_in_absolute_coordinates():
    hub, cup = (hd.Body(name, m, (J, J, J)) for name in ("hub", "cup"))
    joints = hd.Revolute("wheel", hd.GROUND, hub, axis=hd.Z), Wrist("wrist", hub.at(r, 0, 0), cup)
    with pytest.raises(hd.InputError, match=r"wrist\.a, of a wrist joint"):
        hd.derive(scene(hd.Coupling("mesh", "wrist.a", "wrist.b", 1), joints=joints).with_coordinates("absolute"))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_units_are_proven(coordinates):
    mesh, rack = hd.Coupling("mesh", "pinion", "wheel", number), hd.Coupling("rack_mesh", "rack", "wheel", r)
    slot = hd.Coupling("slot", equation=travel - r * sp.cos(other))
    for coupling, force in ((mesh, "N m"), (rack, "N"), (slot, "N")):
        coupled = scene(coupling, hd.JointForce("motor", "wheel", p("M", "N m", 1.0))).with_coordinates(coordinates)
        assert not [finding for finding in hd.audit_scene(coupled) if finding.verdict != "consistent"]
        accelerations = next(f for f in hd.derive(coupled).functions if f.name == "accelerations")
        (multipliers,) = [result for result in accelerations.results if result.name == "multipliers"]
        assert multipliers.units[-1] == force


def test_a_steady_rotation_that_is_geared_has_no_common_period():
    """A third of a turn a turn: what the wheel carries repeats after three, which the drive alone does not say."""
    driven = scene(hd.ConstantSpeed("motor", "pinion", w), hd.JointForce("load", "wheel", p("M", "N m", 1.0)))
    assert "period" in [function.name for function in hd.derive(driven).functions]
    geared = scene(*driven.effects, hd.Coupling("mesh", "wheel", "pinion", number))
    assert "period" not in [function.name for function in hd.derive(geared).functions]
