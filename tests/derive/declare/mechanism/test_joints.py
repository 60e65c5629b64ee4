"""Joints of every kind: against sympy.physics.mechanics, textbooks, energy; and how they are declared."""

from dataclasses import replace

import numpy as np
import pytest
from derived import Derived, energy_balance
from hypothesis import HealthCheck, given, reject, settings
from hypothesis import strategies as st
from kane import TURNED, Tree, deviation_of_poses, line, link

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Direction,
    Drive,
    EnergyLedger,
    Free,
    Gravity,
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
    Y,
    Z,
)

SIGNED = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"]


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
LARGE = {"free on an arm, turned", "skew axes, turned", "skew after turned", "free, carrying", "welds"}  # seconds each


def rows(tree, force):
    """Generalised forces in the order of the contract: free rows, then driven ones."""
    return np.concatenate([force[tree.free], force[tree.driven]])


def deviation(tree, derived, count=3):
    """Largest relative difference of accelerations and reactions from KanesMethod."""
    worst = 0.0
    for t, q, u, force in tree.states(count):
        f = derived.call("applied", t=t, q=q, u=u) + rows(tree, force)
        for a, b in zip(
            derived.call("accelerations", t=t, q=q, u=u, f=f), tree.accelerations(t, q, u, force), strict=True
        ):
            worst = np.maximum(
                worst, np.max(np.abs(a - b), initial=0.0) / np.max(np.abs(b), initial=1e-300)
            )  # NaN stays
    return worst


@pytest.fixture(scope="module")
def derived():
    made = {}
    return lambda name: made.setdefault(name, None) or made.update({name: Derived(TREES[name].scene())}) or made[name]


# -- against sympy.physics.mechanics -----------------------------------------------------------------------------------


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.exhaustive) if n in LARGE else n for n in TREES])
def test_accelerations_equal_kanes_method(name, derived):
    assert deviation(TREES[name], derived(name)) < 1e-10


def test_a_wrong_axis_is_noticed(derived):
    wrong = Derived(replace(TREES["universal"], links=(replace(TREES["universal"].links[0], second="+Z"),)).scene())
    assert deviation(TREES["universal"], wrong) > 1e-3


@st.composite
def trees(draw):
    """1 to 8 bodies, in a plane or in space, on joints of all kinds, some driven, some in turned axes."""
    n, plane = draw(st.integers(1, 8)), draw(st.booleans())
    seed = draw(st.integers(0, 2**16))
    links = []
    for i in range(n):
        many = sum(other.nu > 1 for other in links) > 1  # KanesMethod's expressions grow with every freedom in a row
        kind = draw(st.sampled_from("RRPLW" if plane else "RRPW" if many else "RRRPPCLUSFW"))
        axis = draw(st.sampled_from(["+X", "-Y"] if plane and kind == "P" else ["+Z", "-Z"] if plane else SIGNED))
        second = draw(st.sampled_from([other for other in SIGNED if other[1] != axis[1]]))
        about = ["+Z"] if plane else SIGNED
        turned = draw(st.none() | st.tuples(st.sampled_from(about), st.floats(-1, 1).filter(lambda x: x != 0)))
        if not plane and kind in "RPC" and draw(st.integers(0, 3)) == 0:
            axis = draw(st.sampled_from([(1.0, 2.0, -1.0), (0.0, -1.0, 0.5), (0.3, 0.0, 0.4)]))
        speed = 1.7 if i and kind in "RP" and draw(st.integers(0, 5)) == 0 else None
        parent = draw(st.integers(-1, i - 1))
        links.append(link(kind, axis, parent, seed + i, second=second, turned=(turned, None), speed=speed, plane=plane))
    if not any(joint.moves and joint.speed is None for joint in links):
        links.append(link("R", "+Z", n - 1, seed + n, plane=plane))
    return Tree(tuple(links), down=draw(st.sampled_from(["-Y", "+X"] if plane else SIGNED)))


def of_random_trees(count):
    return settings(max_examples=count, derandomize=True, database=None, suppress_health_check=[HealthCheck.too_slow])


@pytest.mark.exhaustive  # 50 s a tree
@of_random_trees(3)
@given(trees())
def test_random_trees_equal_kanes_method(tree):
    check_random_tree(tree)


@pytest.mark.exhaustive
@of_random_trees(50)
@given(trees())
def test_fifty_random_trees_equal_kanes_method(tree):
    check_random_tree(tree)


def check_random_tree(tree):
    try:
        found = Derived(tree.scene())
    except InputError as error:  # gravity along the only axis that something turns about
        assert [fault.found for fault in error.faults] == ["no equation that it enters"]
        reject()
    assert deviation(tree, found, 2) < 1e-10
    for t, q, u, force in tree.states(1, seed=1):
        work = force @ tree.whole(t, u, speeds=True)
        assert energy_balance(found, t, q, u, rows(tree, force), work) < 1e-12


# -- energy, poses, rates ----------------------------------------------------------------------------------------------


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", TREES)
def test_energy_changes_by_the_power_of_the_other_forces(name, derived):
    """The power balance identity, which sees every coordinate's rate, four of a quaternion from three speeds."""
    tree = TREES[name]
    for t, q, u, force in tree.states(3):
        work = force @ tree.whole(t, u, speeds=True)
        assert energy_balance(derived(name), t, q, u, rows(tree, force), work) < 1e-12


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", TREES)
def test_poses_equal_products_of_rotations(name, derived):
    assert deviation_of_poses(TREES[name], derived(name)) < 1e-13


@pytest.mark.parametrize("name", ["spherical", "free", "two balls"])
def test_a_quaternion_keeps_its_norm_and_turns_by_the_angular_velocity(name, derived):
    """q.q' = 0, and R' = R [w]x, w in the child's axes."""
    found, tree = derived(name), TREES[name]
    for t, q, u, _ in tree.states(2):
        dq = found.call("coordinate_rates", t=t, q=q, u=u)
        for i in found.QUATERNIONS:
            assert q[i : i + 4] @ dq[i : i + 4] == pytest.approx(0, abs=1e-15)
        rate = (found.jacobian("poses", "q", 1, t=t, q=q) @ dq)[:9].reshape(3, 3)
        R = found.call("poses", t=t, q=q)[1][:9].reshape(3, 3)
        x, y, z = u[found.SPEEDS.index(("joint0.angular_speed_x", "rad/s")) :][:3]
        assert R.T @ rate == pytest.approx(np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), abs=1e-14)


# -- against textbooks -------------------------------------------------------------------------------------------------

SIZES = Scales(length=Parameter("size", "m", 1), speed=Parameter("pace", "m/s", 1), arm=Parameter("size", "m", 1))
MASS = Parameter("mass", "kg", 0.9)
TRIPLE = tuple(Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", (0.07, 0.05, 0.03), strict=True))
GRAVITY = Gravity("gravity", Parameter("g", "m/s^2", 9.81), -Z)


def test_a_spherical_pendulum_obeys_eulers_equations_about_its_fixed_point():
    """Landau, Lifshitz, Mechanics, section 36: I w' + w x I w = moment, in the body's principal axes about the point of support."""
    l = Parameter("l", "m", 0.5)
    bob = Body("bob", MASS, TRIPLE, (0, 0, -l))
    found = Derived(Scene(Mechanism("top", (Spherical("ball", GROUND, bob),)), (GRAVITY, EnergyLedger()), SIZES))
    inertia = np.diag([0.07 + 0.9 * 0.25, 0.05 + 0.9 * 0.25, 0.03])
    rng = np.random.default_rng(1)
    for _ in range(3):
        q, w = rng.normal(size=4), rng.normal(size=3)
        q /= np.linalg.norm(q)
        R = found.call("poses", q=q)[1].reshape(3, 3)
        moment = np.cross([0, 0, -0.5], R.T @ [0, 0, -0.9 * 9.81])
        f = found.call("applied", q=q, u=w)
        a, _ = found.call("accelerations", q=q, u=w, f=f)
        assert f == pytest.approx(moment, rel=1e-12, abs=1e-14)
        assert a == pytest.approx(np.linalg.solve(inertia, moment - np.cross(w, inertia @ w)), rel=1e-12)


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


def test_a_hookes_joint_transmits_as_the_textbook_says():
    """tan(output) = tan(input)/cos(bend), Seherr-Thoss, Schmelz, Aucktor, Universal Joints (2006): the two axes of the cross stay square.

    The fork's angle about its bent shaft is read off a universal joint whose two angles the geometry gives."""
    bend, angle = 0.6, 0.8
    shaft, fork = Body("shaft", MASS, TRIPLE), Body("fork", MASS, TRIPLE)
    joints = (Revolute("inlet", GROUND, shaft, Z), Universal("cross", shaft, fork, X, Y))
    found = Derived(Scene(Mechanism("hooke", joints), (EnergyLedger(),), SIZES))
    # the fork's axis z must lie along the bent shaft, which is turned about the ground's x
    out = np.array([0, -np.sin(bend), np.cos(bend)])
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    x, y, z = turn.T @ out
    second = np.arcsin(x)
    first = np.arctan2(-y, z)
    _, rotations = found.call("poses", q=[angle, first, second])
    R = rotations[9:].reshape(3, 3)
    assert R[:, 2] == pytest.approx(out, abs=1e-14)
    across = np.array([0, np.cos(bend), np.sin(bend)])  # with x and out a frame of the bent shaft
    y_axis = R[:, 1]
    output = np.arctan2(-y_axis[0], y_axis @ across)
    assert np.tan(output) == pytest.approx(np.tan(angle) * np.cos(bend), rel=1e-12)


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


def test_without_a_ball_there_is_no_table_of_quaternions():
    assert "QUATERNIONS" not in Derived(scene(Revolute("pin", GROUND, BODY, Z))).names


def test_a_start_names_coordinates_and_an_orientation_is_normalised():
    start = Start(
        position={"float.x": Parameter("x0", "m", 2.0), "float.q0": 3, "float.q2": 4, "pin": 0.5},
        speed={"float.angular_speed_z": Parameter("w0", "rad/s", 7.0), "pin.speed": Parameter("w1", "rad/s", 8.0)},
    )
    q, u = Derived(scene(Free("float", GROUND, BODY), Revolute("pin", BODY, OTHER, Z), start=start)).start()
    assert q == pytest.approx([2, 0, 0, 0.6, 0, 0.8, 0, 0.5])
    assert u == pytest.approx([0, 0, 0, 0, 0, 7, 8])


def test_one_freedom_of_several_can_be_driven():
    drive = ConstantSpeed("drive", "cross.angle_2", Parameter("w", "rad/s", 3.0))
    found = Derived(scene(Universal("cross", GROUND, BODY), effects=(drive,)))
    assert [name for name, _ in found.SPEEDS] == ["cross.angle_1_speed"]


def test_a_turned_joint_is_the_joint_about_the_turned_axis():
    """Z turned about X by the angle a is the direction (0, -sin a, cos a)."""
    angle = 0.3
    turn = Parameter("tilt", "rad", angle)
    one = Derived(scene(Revolute("pin", GROUND.at(0, 0, 0).turned(X, turn), BODY.at(0, 0, 0).turned(X, turn), Z)))
    two = Derived(scene(Revolute("pin", GROUND, BODY, Direction((0, -np.sin(angle), np.cos(angle))))))
    for found in (one.call("poses", q=[0.7])[1], two.call("poses", q=[0.7])[1]):
        assert found == pytest.approx(one.call("poses", q=[0.7])[1], abs=1e-15)
    assert dict(one.OPERATIONS)["accelerations"] == dict(two.OPERATIONS)["accelerations"] == 1


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
    declare, where, found, way_out = BAD[label]
    with pytest.raises(InputError) as caught:
        declare()
    faults = [fault for fault in caught.value.faults if where in fault.where]
    assert faults, str(caught.value)
    assert any(found in fault.found and way_out in f"{fault.expected} {fault.remedy}" for fault in faults), str(
        caught.value
    )


def test_faults_of_joints_come_at_once():
    with pytest.raises(InputError) as caught:
        scene(
            Universal("cross", GROUND, BODY, X, X),
            Revolute("pin", BODY, OTHER, Direction((1, 1, 0))),
            Prismatic("slide", OTHER, Body("end", 0), X),
        )
    assert len(caught.value.faults) == 2


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


def test_a_slender_rod_may_hang_on_a_ball_beside_its_axis():
    """It has no inertia about its own axis, but its mass moves about any axis through the joint."""
    scene(Spherical("ball", GROUND, Body("rod", MASS, (TRIPLE[0], TRIPLE[0], 0), (Parameter("l", "m", 1.0), 0, 0))))


def test_a_frame_without_mass_may_be_welded_on():
    found = Derived(scene(Revolute("pin", GROUND, BODY, Z), Weld("mark", BODY, Body("marker", 0))))
    assert dict(found.OPERATIONS)["accelerations"] == 1


def test_a_massless_body_between_others_is_one_that_only_carries():
    """A cross without mass is a universal joint."""
    cross = Body("cross", 0)
    two = Derived(scene(Revolute("first", GROUND, cross, X), Revolute("second", cross, BODY, Y)))
    one = Derived(scene(Universal("joint", GROUND, BODY, X, Y)))
    given = {"q": [0.3, -0.4], "u": [1.0, 2.0], "f": [0.5, -0.6]}
    assert two.call("accelerations", **given)[0] == pytest.approx(one.call("accelerations", **given)[0], rel=1e-13)


@pytest.mark.parametrize("joint", [Spherical, Free, Weld])
def test_a_joint_takes_no_field_it_does_not_have(joint):
    with pytest.raises(TypeError, match="axis"):
        joint("hinge", GROUND, Body("rod", Parameter("mass", "kg", 1)), axis=Z)
