"""Joints of every kind: against sympy.physics.mechanics, textbooks, energy; and how they are declared."""

import numpy as np
import pytest
from derived import Derived
from kane import TURNED, Tree, line, link

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Direction,
    Drive,
    EnergyLedger,
    Free,
    InputError,
    Mechanism,
    Parameter,
    Planar,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Spherical,
    Start,
    T,
    Table,
    Universal,
    Weld,
    X,
    Z,
)

TREES = {
    "cylindrical": line("C-Y"),
    "planar": line("L+Z"),
    "planar across X, then a slide": line("L-X", "P+Y"),
    "universal": line("U+X", second="-Z"),
    "universal, axes not square": line("U+X", second=(1.0, 2.0, -0.5)),
    "spherical": line("S"),
    "spherical on an arm": line("R+Z", "S"),
    "spherical in turned axes": line("S", turned=TURNED),
    "free": line("F"),
    "free, carrying": line("F", "R+Y"),
    "free on an arm, turned": line("R-X", "F", turned=TURNED),
    "welds": line("W", "R+Z", "W", "C+Z", turned=TURNED),
    "two balls": line("S", "S"),
    "skew axis": Tree((link("R", (1.0, 2.0, -1.0), -1, 5),)),
    "skew axes, turned": Tree((link("R", (1.0, 2.0, -1.0), -1, 5, turned=TURNED), link("C", (0.0, 1.0, 1.0), 0, 6))),
    "turned in the plane": line("R+Z", "R-Z", "P+X", turned=(("+Z", 0.4), ("-Z", 0.7)), plane=True),
    "universal in turned axes": line("U-Z", second="-Y", turned=(("+X", -0.9), None)),
    "skew after turned": Tree((link("R", "+Z", -1, 5, turned=TURNED), link("R", (1.0, 0.0, 1.0), 0, 6, turned=TURNED))),
    "driven, then a ball": Tree((link("R", "+Z", -1, 7, speed=2.0), link("S", "+X", 0, 8))),
}


def rows(tree, force):
    """Generalised forces in the order of the contract: free rows, then driven ones."""
    return np.concatenate([force[tree.free], force[tree.driven]])


@pytest.fixture(scope="module")
def derived():
    made = {}
    return lambda name: made.setdefault(name, None) or made.update({name: Derived(TREES[name].scene())}) or made[name]


# -- against textbooks -------------------------------------------------------------------------------------------------

SIZES = Scales(length=Parameter("size", "m", 1), speed=Parameter("pace", "m/s", 1), arm=Parameter("size", "m", 1))
MASS = Parameter("mass", "kg", 0.9)
TRIPLE = tuple(Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", (0.07, 0.05, 0.03), strict=True))


def test_a_free_body_about_its_mass_centre_costs_eulers_equations_alone():
    """Newton's and Euler's equations do not meet: three divisions, and three gyroscopic moments, each with its division."""
    body = Body("body", MASS, TRIPLE, (Parameter("s", "m", 0.1), 0, 0))
    joint = Free("float", GROUND, body.at(Parameter("s", "m", 0.1), 0, 0))
    found = Derived(Scene(Mechanism("body", (joint,)), (EnergyLedger(),), SIZES))
    assert dict(found.OPERATIONS)["accelerations"] <= 3 + 3 * 5
    u = np.array([1.0, 2.0, 3.0, 0.4, -0.5, 0.6])
    a, _ = found.call("accelerations", q=[0, 0, 0, 1, 0, 0, 0], u=u, f=np.arange(1.0, 7.0))
    w, inertia = u[3:], np.array([0.07, 0.05, 0.03])
    assert a == pytest.approx(
        [*(np.arange(1.0, 4.0) / 0.9), *((np.arange(4.0, 7.0) - np.cross(w, inertia * w)) / inertia)], rel=1e-14
    )


# -- declaration -------------------------------------------------------------------------------------------------------


def scene(*joints, effects=(), start=None):
    return Scene(Mechanism("tried", joints), (EnergyLedger(), *effects), SIZES, start or Start())


BODY, OTHER = Body("body", MASS, TRIPLE), Body("other", MASS, TRIPLE)


def test_names_are_those_of_the_joint_and_its_motions():
    found = Derived(scene(Free("float", GROUND, BODY), Universal("cross", BODY, OTHER)))
    coordinates = ["x", "y", "z", "q0", "q1", "q2", "q3"]
    assert [name for name, _ in found.COORDINATES] == [
        *(f"float.{name}" for name in coordinates),
        "cross.angle_1",
        "cross.angle_2",
    ]
    assert found.SPEEDS[:4] == (
        ("float.x_speed", "m/s"),
        ("float.y_speed", "m/s"),
        ("float.z_speed", "m/s"),
        ("float.angular_speed_x", "rad/s"),
    )
    assert found.QUATERNIONS == (3,)
    assert (found.nq, found.nu) == (9, 8)


def test_a_start_names_coordinates_and_an_orientation_is_normalised():
    start = Start(
        position={"float.x": Parameter("x0", "m", 2.0), "float.q0": 3, "float.q2": 4, "pin": 0.5},
        speed={"float.angular_speed_z": Parameter("w0", "rad/s", 7.0), "pin.speed": Parameter("w1", "rad/s", 8.0)},
    )
    q, u = Derived(scene(Free("float", GROUND, BODY), Revolute("pin", BODY, OTHER, Z), start=start)).start()
    assert q == pytest.approx([2, 0, 0, 0.6, 0, 0.8, 0, 0.5])
    assert u == pytest.approx([0, 0, 0, 0, 0, 7, 8])


def test_welded_bodies_cost_what_one_body_costs():
    carried = Weld("glue", BODY.at(Parameter("off", "m", 0.3), 0, 0), OTHER)
    welded, alone = (Derived(scene(Spherical("ball", GROUND, BODY), *more)) for more in ((carried,), ()))
    assert dict(welded.OPERATIONS)["accelerations"] >= dict(alone.OPERATIONS)["accelerations"]
    off = Parameter("off", "m", 0.3)
    inertia = tuple(2 * J + extra * MASS * off**2 / 2 for J, extra in zip(TRIPLE, (0, 1, 1), strict=True))
    whole = Body("whole", 2 * MASS, inertia, (off / 2, 0, 0))
    one = Derived(scene(Spherical("ball", GROUND, whole)))
    assert dict(welded.OPERATIONS)["accelerations"] == dict(one.OPERATIONS)["accelerations"]
    w = np.array([1.0, -2.0, 0.5])
    ours, theirs = (found.call("accelerations", q=[1, 0, 0, 0], u=w, f=np.ones(3))[0] for found in (welded, one))
    assert ours == pytest.approx(theirs, rel=1e-12)


def test_a_rigid_whole_has_the_inertia_that_its_axis_needs():
    """Of one body or another, or by a mass beside the axis; within a chain what follows may have it."""
    off, J, right = Parameter("off", "m", 0.3), Parameter("J", "kg m^2", 0.2), Parameter("right", "rad", np.pi / 2)
    hub, disc = Body("hub", MASS), Body("disc", MASS, (0, 0, J))
    pin = Revolute("pin", GROUND, hub, Z)
    swung = Derived(scene(pin, Weld("glue", hub.at(off, 0, 0), Body("tip", MASS))))
    assert swung.call("accelerations", q=[0.4], u=[0.0], f=[2.0])[0] == pytest.approx(2 / (0.9 * 0.3**2), rel=1e-14)
    flat = Derived(scene(pin, Weld("glue", hub, disc)))
    assert flat.call("accelerations", q=[0.4], u=[0.0], f=[2.0])[0] == pytest.approx(2 / 0.2, rel=1e-14)
    with pytest.raises(InputError, match="body hub: found inertia 0"):
        scene(pin, Weld("glue", hub.at(0, 0, off).turned(X, right), disc))
    carried = Derived(scene(pin, Revolute("elbow", hub.at(0, 0, off), BODY, X)))
    alone = Derived(scene(Universal("cross", GROUND, BODY, Z, X)))
    q, u, f = [0.4, 0.7], [1.0, -2.0], [0.3, 0.1]
    actual, expected = (each.call("accelerations", q=q, u=u, f=f)[0] for each in (carried, alone))
    assert actual == pytest.approx(expected, rel=1e-12)


POINT = Body("point", MASS, 0, (0, 0, Parameter("l", "m", 1.0)))
BAD = {
    "universal with parallel axes": (lambda: scene(Universal("cross", GROUND, BODY, X, -X)), "joint cross", "parallel", "Revolute"),
    "direction of length zero": (lambda: scene(Revolute("pin", GROUND, BODY, Direction((0, 0, 0)))), "joint pin, axis", "length 0", "somewhere"),
    "turned about nothing": (
        lambda: scene(Revolute("pin", GROUND.at(0, 0, 0).turned(Direction((0, 0, 0)), 1), BODY, Z)), "turned point", "length 0", "somewhere",
    ),
    "skew normal of a plane": (lambda: scene(Planar("table", GROUND, BODY, Direction((1, 1, 0)))), "joint table", "normal", "turned"),
    "a ball that carries a point mass": (lambda: scene(Spherical("ball", GROUND, POINT)), "body point", "inertia 0", "every way"),
    "massless end": (
        lambda: scene(Revolute("pin", GROUND, BODY, Z), Prismatic("slide", BODY, Body("end", 0), X)),
        "body end, mass", "end of a chain", "(0, inf)",
    ),
    "a ball that carries a slender rod by its end": (
        lambda: scene(Spherical("ball", GROUND, Body("rod", MASS, (TRIPLE[0], TRIPLE[0], 0), (0, 0, Parameter("l", "m", 1.0))))),
        "body rod", "inertia 0", "every axis",
    ),
    "a pair on one rigid body": (
        lambda: Scene(
            Mechanism("tried", (Revolute("pin", GROUND, BODY, Z), Weld("glue", BODY, OTHER)),
                      (SphereOnPlane("touch", BODY.at(0, 0, 0), Parameter("r", "m", 0.1), OTHER.at(0, 0, 0), Z),)), (), SIZES),
        "pair touch", "welded", "move against each other",
    ),
    "drive of a ball": (
        lambda: scene(Spherical("ball", GROUND, BODY), effects=(ConstantSpeed("drive", "ball", Parameter("w", "rad/s", 1)),)),
        "effect drive", "not just one coordinate", "",
    ),
    "start of a whole joint": (
        lambda: scene(Spherical("ball", GROUND, BODY), start=Start(position={"ball": 1})), "start", "'ball'", "ball.q0",
    ),
    "lengths and numbers in one direction": (
        lambda: scene(Revolute("pin", GROUND, BODY, Direction((Parameter("l", "m", 1.0), 0, 1)))),
        "joint pin, axis", "the bare number 1", "a quantity in m",
    ),
    "only welds": (lambda: scene(Weld("glue", GROUND, BODY)), "effects", "no joint that can move", "free to move"),
}  # fmt: skip


@pytest.mark.parametrize("label", BAD)
def test_a_bad_joint_is_a_fault_that_says_where_what_and_the_way_out(label):
    declare, where, actual, way_out = BAD[label]
    with pytest.raises(InputError) as caught:
        declare()
    faults = [fault for fault in caught.value.faults if where in fault.where]
    assert faults, str(caught.value)
    assert any(actual in fault.found and way_out in f"{fault.expected} {fault.remedy}" for fault in faults), str(
        caught.value
    )


def test_an_axis_that_points_nowhere_hides_no_other_fault():
    lift = Table("lift", (0.0, 2.0, 1.0), (0.0, 1.0, 2.0), ("s", "rad"))
    drive = Drive("drive", "nowhere", position=lift(T))
    with pytest.raises(InputError) as caught:
        scene(
            Revolute("pin", GROUND, BODY, Direction((0, 0, 0))), Universal("cross", BODY, OTHER, X, X), effects=(drive,)
        )
    found = {fault.where: fault for fault in caught.value.faults}
    assert set(found) == {"joint pin, axis", "joint cross", "effect drive", "table lift"}
    assert found["table lift"].found == "argument 1.0 after 2.0 in place 3"
    assert "Sort the rows" in found["table lift"].remedy


@pytest.mark.parametrize("joint", [Spherical, Free, Weld])
def test_a_joint_takes_no_field_it_does_not_have(joint):
    with pytest.raises(TypeError, match="axis"):
        joint("hinge", GROUND, Body("rod", Parameter("mass", "kg", 1)), axis=Z)
