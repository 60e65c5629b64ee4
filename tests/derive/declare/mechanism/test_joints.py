"""Joints of every kind: against sympy.physics.mechanics, textbooks, energy; and how they are declared."""

import numpy as np
import pytest
from derived import Derived
from drop import refused
from each import each

import hertzwerk.derive as hd

# -- against textbooks -------------------------------------------------------------------------------------------------

SIZE = hd.Parameter("size", "m", 1)
SIZES = hd.Scales(length=SIZE, speed=hd.Parameter("pace", "m/s", 1), arm=SIZE)
MASS = hd.Parameter("mass", "kg", 0.9)
TRIPLE = tuple(hd.Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", (0.07, 0.05, 0.03), strict=True))


def test_a_free_body_about_its_mass_centre_costs_eulers_equations_alone():
    """Newton's and Euler's equations do not meet: three divisions, and three gyroscopic moments, each with its division."""
    body = hd.Body("body", MASS, TRIPLE, (hd.Parameter("s", "m", 0.1), 0, 0))
    joint = hd.Free("float", hd.GROUND, body.at(hd.Parameter("s", "m", 0.1), 0, 0))
    result = Derived(hd.Scene(hd.Mechanism("body", (joint,)), (hd.EnergyLedger(),), SIZES))
    assert dict(result.OPERATIONS)["accelerations"] <= 3 + 3 * 5
    u = np.array([1.0, 2.0, 3.0, 0.4, -0.5, 0.6])
    a, _ = result.call("accelerations", q=[0, 0, 0, 1, 0, 0, 0], u=u, f=np.arange(1.0, 7.0))
    w, inertia = u[3:], np.array([0.07, 0.05, 0.03])
    moments = np.arange(4.0, 7.0) - np.cross(w, inertia * w)
    assert a == pytest.approx([*(np.arange(1.0, 4.0) / 0.9), *(moments / inertia)], rel=1e-14)


# -- declaration -------------------------------------------------------------------------------------------------------


def scene(*joints, effects=(), start=None):
    return hd.Scene(hd.Mechanism("tried", joints), (hd.EnergyLedger(), *effects), SIZES, start or hd.Start())


BODY, OTHER = hd.Body("body", MASS, TRIPLE), hd.Body("other", MASS, TRIPLE)


def test_names_of_coordinates_and_starts_by_them():
    result = Derived(scene(hd.Free("float", hd.GROUND, BODY), hd.Universal("cross", BODY, OTHER)))
    coordinates = ["x", "y", "z", "q0", "q1", "q2", "q3"]
    names = [*(f"float.{name}" for name in coordinates), "cross.angle_1", "cross.angle_2"]
    assert [name for name, _ in result.COORDINATES] == names
    speeds = [(f"float.{k}_speed", "m/s") for k in "xyz"]
    assert result.SPEEDS[:4] == (*speeds, ("float.angular_speed_x", "rad/s"))
    assert result.QUATERNIONS == (3,)
    assert (result.nq, result.nu) == (9, 8)
    w0, w1 = (hd.Parameter(name, "rad/s", x) for name, x in (("w0", 7.0), ("w1", 8.0)))
    position = {"float.x": hd.Parameter("x0", "m", 2.0), "float.q0": 3, "float.q2": 4, "pin": 0.5}
    start = hd.Start(position=position, speed={"float.angular_speed_z": w0, "pin.speed": w1})
    q, u = Derived(scene(hd.Free("float", hd.GROUND, BODY), hd.Revolute("pin", BODY, OTHER, hd.Z), start=start)).start()
    assert q == pytest.approx([2, 0, 0, 0.6, 0, 0.8, 0, 0.5])
    assert u == pytest.approx([0, 0, 0, 0, 0, 7, 8])


def test_welded_bodies_cost_what_one_body_costs():
    carried = hd.Weld("glue", BODY.at(hd.Parameter("off", "m", 0.3), 0, 0), OTHER)
    welded, alone = (Derived(scene(hd.Spherical("ball", hd.GROUND, BODY), *more)) for more in ((carried,), ()))
    assert dict(welded.OPERATIONS)["accelerations"] >= dict(alone.OPERATIONS)["accelerations"]
    off = hd.Parameter("off", "m", 0.3)
    inertia = tuple(2 * J + extra * MASS * off**2 / 2 for J, extra in zip(TRIPLE, (0, 1, 1), strict=True))
    whole = hd.Body("whole", 2 * MASS, inertia, (off / 2, 0, 0))
    one = Derived(scene(hd.Spherical("ball", hd.GROUND, whole)))
    assert dict(welded.OPERATIONS)["accelerations"] == dict(one.OPERATIONS)["accelerations"]
    w = np.array([1.0, -2.0, 0.5])
    ours, theirs = (found.call("accelerations", q=[1, 0, 0, 0], u=w, f=np.ones(3))[0] for found in (welded, one))
    assert ours == pytest.approx(theirs, rel=1e-12)


def test_a_rigid_whole_has_the_inertia_that_its_axis_needs():
    """Of one body or another, or by a mass beside the axis; within a chain what follows may have it."""
    off, J = hd.Parameter("off", "m", 0.3), hd.Parameter("J", "kg m^2", 0.2)
    right = hd.Parameter("right", "rad", np.pi / 2)
    hub, disc = hd.Body("hub", MASS), hd.Body("disc", MASS, (0, 0, J))
    pin = hd.Revolute("pin", hd.GROUND, hub, hd.Z)
    swung = Derived(scene(pin, hd.Weld("glue", hub.at(off, 0, 0), hd.Body("tip", MASS))))
    assert swung.call("accelerations", q=[0.4], u=[0.0], f=[2.0])[0] == pytest.approx(2 / (0.9 * 0.3**2), rel=1e-14)
    flat = Derived(scene(pin, hd.Weld("glue", hub, disc)))
    assert flat.call("accelerations", q=[0.4], u=[0.0], f=[2.0])[0] == pytest.approx(2 / 0.2, rel=1e-14)
    with pytest.raises(hd.InputError, match="body hub: found inertia 0"):
        scene(pin, hd.Weld("glue", hub.at(0, 0, off).turned(hd.X, right), disc))
    carried = Derived(scene(pin, hd.Revolute("elbow", hub.at(0, 0, off), BODY, hd.X)))
    alone = Derived(scene(hd.Universal("cross", hd.GROUND, BODY, hd.Z, hd.X)))
    q, u, f = [0.4, 0.7], [1.0, -2.0], [0.3, 0.1]
    actual, expected = (each.call("accelerations", q=q, u=u, f=f)[0] for each in (carried, alone))
    assert actual == pytest.approx(expected, rel=1e-12)


POINT = hd.Body("point", MASS, 0, (0, 0, hd.Parameter("l", "m", 1.0)))
BAD = {
    "universal with parallel axes": (lambda: scene(hd.Universal("cross", hd.GROUND, BODY, hd.X, -hd.X)), "joint cross", "parallel", "Revolute"),
    "direction of length zero": (lambda: scene(hd.Revolute("pin", hd.GROUND, BODY, hd.Direction((0, 0, 0)))), "joint pin, axis",
    "length 0", "somewhere"),
    "turned about nothing": (
        lambda: scene(hd.Revolute("pin", hd.GROUND.at(0, 0, 0).turned(hd.Direction((0, 0, 0)), 1), BODY, hd.Z)), "turned point",
        "length 0", "somewhere",
    ),
    "skew normal of a plane": (lambda: scene(hd.Planar("table", hd.GROUND, BODY, hd.Direction((1, 1, 0)))), "joint table", "normal", "turned"),
    "a ball that carries a point mass": (lambda: scene(hd.Spherical("ball", hd.GROUND, POINT)), "body point", "inertia 0", "every way"),
    "massless end": (
        lambda: scene(hd.Revolute("pin", hd.GROUND, BODY, hd.Z), hd.Prismatic("slide", BODY, hd.Body("end", 0), hd.X)),
        "body end, mass", "end of a chain", "(0, inf)",
    ),
    "a ball that carries a slender rod by its end": (
        lambda: scene(hd.Spherical("ball", hd.GROUND, hd.Body("rod", MASS, (TRIPLE[0], TRIPLE[0], 0), (0, 0, hd.Parameter("l", "m", 1.0))))),
        "body rod", "inertia 0", "every axis",
    ),
    "a pair on one rigid body": (
        lambda: hd.Scene(
            hd.Mechanism("tried", (hd.Revolute("pin", hd.GROUND, BODY, hd.Z), hd.Weld("glue", BODY, OTHER)),
                      (hd.SphereOnPlane("touch", BODY.at(0, 0, 0), hd.Parameter("r", "m", 0.1), OTHER.at(0, 0, 0), hd.Z),)), (), SIZES),
        "pair touch", "welded", "move against each other",
    ),
    "drive of a ball": (
        lambda: scene(hd.Spherical("ball", hd.GROUND, BODY), effects=(hd.ConstantSpeed("drive", "ball", hd.Parameter("w", "rad/s", 1)),)),
        "effect drive", "not just one coordinate", "",
    ),
    "start of a whole joint": (
        lambda: scene(hd.Spherical("ball", hd.GROUND, BODY), start=hd.Start(position={"ball": 1})), "start", "'ball'", "ball.q0",
    ),
    "lengths and numbers in one direction": (
        lambda: scene(hd.Revolute("pin", hd.GROUND, BODY, hd.Direction((hd.Parameter("l", "m", 1.0), 0, 1)))),
        "joint pin, axis", "the bare number 1", "a quantity in m",
    ),
    "only welds": (lambda: scene(hd.Weld("glue", hd.GROUND, BODY)), "effects", "no joint that can move", "free to move"),
}  # fmt: skip


@each("label", BAD)
def test_a_bad_joint_is_a_fault_that_says_where_what_and_the_way_out(label):
    refused(*BAD[label])


def test_an_axis_that_points_nowhere_hides_no_other_fault():
    lift = hd.Table("lift", (0.0, 2.0, 1.0), (0.0, 1.0, 2.0), ("s", "rad"))
    drive = hd.Drive("drive", "nowhere", position=lift(hd.T))
    with pytest.raises(hd.InputError) as caught:
        scene(
            hd.Revolute("pin", hd.GROUND, BODY, hd.Direction((0, 0, 0))), hd.Universal("cross", BODY, OTHER, hd.X, hd.X), effects=(drive,),
        )  # fmt: skip
    result = {fault.where: fault for fault in caught.value.faults}
    assert set(result) == {"joint pin, axis", "joint cross", "effect drive", "table lift"}
    assert result["table lift"].found == "argument 1.0 after 2.0 in place 3"
    assert "Sort the rows" in result["table lift"].remedy


@pytest.mark.parametrize("joint", [hd.Spherical, hd.Free, hd.Weld])
def test_a_joint_takes_no_field_it_does_not_have(joint):
    with pytest.raises(TypeError, match="axis"):
        joint("hinge", hd.GROUND, hd.Body("rod", hd.Parameter("mass", "kg", 1)), axis=hd.Z)
