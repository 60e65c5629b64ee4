"""Contact pairs beyond spheres and pins: geometry by hand and complex step, virtual work, energy, and what is refused."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from derived import Derived, rate_along
from each import each
from kane import Tree, driven, random_tree
from touching import V0, Touching

import hertzwerk.derive as hd
from hertzwerk.derive.expressions.parameter import default_value
from hertzwerk.derive.laws import hertz_point, power

LENGTH = 0.8  # of a bounded face
OFF = (0.1, -0.2, 0.15)  # of a knob


class Pair(Touching):
    """`axis` is of the second body; `other` a direction of the first or, of a face, along it."""

    def __init__(self, kind, tree, first, second, axis="+Y", other="+X", sizes=(0.4, 0.3)):
        self.other = np.eye(3)["XYZ".index(other[1])] * (1 if other[0] == "+" else -1)
        super().__init__(kind, tree, first, second, axis, sizes)

    def declared(self, one, two, normal, big, small):
        other = hd.Direction(tuple(int(k) for k in self.other))
        length, off = (
            hd.Parameter("length", "m", LENGTH),
            [hd.Parameter(f"off_{k}", "m", v) for k, v in zip("xyz", OFF, strict=True)],
        )
        distance = sp.sqrt(sum(k**2 for k in hd.APART))
        knob = [a + sum(t * o for t, o in zip(row, off, strict=True)) for a, row in zip(hd.APART, hd.TURN, strict=True)]
        return {
            "ball_in_socket": lambda: hd.BallInSocket("touch", one, two, big, small),
            "cylinder_on_plane": lambda: hd.CylinderOnPlane("touch", one, other, big, length, two, normal),
            "rim_on_plane": lambda: hd.RimOnPlane("touch", one, other, big, two, normal),
            "corner_on_face": lambda: hd.CornerOnFace("touch", one, two, normal),
            "bounded": lambda: hd.CornerOnFace("touch", one, two, normal, other, length),
            "custom spheres": lambda: hd.CustomPair(
                "touch", one, two, distance - big - small, tuple(k / distance for k in hd.APART), tuple(small * k / distance for k in hd.APART)
            ),
            "custom knob": lambda: hd.CustomPair("touch", one, two, knob[1] - big, (0, 1, 0), (knob[0], knob[1] - big, knob[2])),
        }[self.kind]()  # fmt: skip

    def geometry(self, q):
        a, b = self.tree.point(*self.first, q), self.tree.point(*self.second, q)
        turn = self.tree.pose(self.second[0], q)[1]
        n, e, (big, small) = turn @ self.axis, a - b, self.sizes
        if self.kind == "ball_in_socket":
            distance = np.sqrt(e @ e)
            return distance - small, -e / distance, a + (big - small) * e / distance
        if self.kind == "custom spheres":
            distance = np.sqrt(e @ e)
            return big + small - distance, e / distance, b + small * e / distance
        if self.kind == "custom knob":
            knob = a + self.tree.pose(self.first[0], q)[1] @ np.array(OFF)
            return big - n @ (knob - b), n, knob - big * n
        if self.kind == "cylinder_on_plane":
            return big - n @ e, n, a - big * n
        if self.kind == "rim_on_plane":
            axis = self.tree.pose(self.first[0], q)[1] @ self.other
            down = np.cross(axis, np.cross(axis, n))  # in the disc, down the plane's normal
            lowest = a + big * down / np.sqrt(down @ down)
            return -n @ (lowest - b), n, lowest
        along = turn @ self.other
        ways = [(-n @ e, n)]
        if self.kind == "bounded":
            ways += [(LENGTH / 2 - side * along @ e, side * along) for side in (1, -1)]
        depth, normal = min(ways, key=lambda way: np.real(way[0]))
        return depth, normal, a

    def states(self, derived, count=3):
        depth = {"bounded": 0.1, "corner_on_face": 0.1}.get(self.kind, 0.2 * min(self.sizes))
        rng = np.random.default_rng(5)
        for _ in range(count):
            t = rng.uniform(0, 1)
            q = derived.with_gap(t, rng.uniform(-1, 1, derived.nu), 0, -depth)
            yield t, q, rng.uniform(-1, 1, derived.nu)


FLAT = random_tree("P+X P+Y R+Z R+Z", 60, (-1, 0, 1, -1), planar=2)
DEEP = random_tree("R+Z R+X P+Y", 61, (-1, 0, -1))
AT, ON = (0.3, 0.1, 0.2), (0.1, 0.2, 0.1)
PAIRS = {
    "ball in socket, spatial": Pair("ball_in_socket", random_tree("R+Z R+X R+Y", 45, (-1, 0, -1)), (1, AT), (2, ON), sizes=(0.3, 0.2)),
    "ball in socket, planar": Pair("ball_in_socket", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0)), sizes=(0.5, 0.4)),
    "cylinder on a turning plane": Pair("cylinder_on_plane", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0)), other="+Z"),
    "cylinder that may yaw": Pair("cylinder_on_plane", random_tree("P+Y P+X R+Y R+X", 62), (3, (0, 0.1, 0)), (-1, ON), other="-X"),
    "rim, planar": Pair("rim_on_plane", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0)), other="+Z"),
    "rim, tilting": Pair("rim_on_plane", DEEP, (1, AT), (2, ON), other="+Z"),
    "corner": Pair("corner_on_face", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0)), axis="-Y"),
    "corner, spatial": Pair("corner_on_face", DEEP, (1, AT), (2, ON), axis="+Z"),
    "bounded": Pair("bounded", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0))),
    "bounded, spatial": Pair("bounded", DEEP, (1, AT), (2, ON), axis="-Z", other="-Y"),
    "custom spheres": Pair("custom spheres", DEEP, (1, AT), (2, ON)),
    "custom knob": Pair("custom knob", DEEP, (1, AT), (2, ON)),
    "custom knob, planar": Pair("custom knob", FLAT, (2, (0.3, 0.1, 0)), (3, (0.1, 0.2, 0))),
}  # fmt: skip


def many(*kinds, parents=None):
    """Bodies on joints of these kinds, on the ground unless `parents` says otherwise."""
    links = random_tree(" ".join(["R+Z"] * len(kinds)), 53, parents or [-1] * len(kinds)).links
    return Tree(tuple(replace(link, kind=kind, second="+X") for link, kind in zip(links, kinds, strict=True)))


PAIRS |= {
    "pin in bush, planar": Touching(
        "pin_in_bush", random_tree("R+Z R+Z P+X", 41, (-1, 0, -1), planar=2), (1, (0.5, 0.1, 0)), (2, (0.1, 0.2, 0)), sizes=(0.3, 0.1)
    ),
    "pin in bush, driven": Touching(
        "pin_in_bush", driven(random_tree("R+Z R+Z P+X", 143, (-1, 0, -1), planar=2), 0, 2.0), (1, (0.5, 0.1, 0)), (2, (0, 0, 0)), sizes=(0.3, 0.1)
    ),
    "pin in bush, spatial": Touching(
        "pin_in_bush", random_tree("R+Z R+X R+Y", 45, (-1, 0, -1)), (1, (0.3, 0.1, 0.2)), (2, (0.1, 0.4, 0.1)), axis="-X", sizes=(0.3, 0.2)
    ),
    "sphere on sphere, spatial": Touching("sphere_on_sphere", random_tree("R+Z R-X R+Y", 47, (-1, 0, -1)), (1, (0.4, 0.1, 0)), (2, (0.1, 0.2, 0.3))),
    "sphere on plane, spatial": Touching("sphere_on_plane", random_tree("P+X R+Z R-Y", 50), (2, (0.4, 0.1, 0.1)), (-1, (0, 0.2, 0.1)), axis="-X"),
    "sphere on sphere, both on balls": Touching("sphere_on_sphere", many("S", "F"), (0, (0.4, 0.1, 0)), (1, (0.1, 0.2, 0.3))),
    "pin in bush, a free body in a free one": Touching(
        "pin_in_bush", many("F", "F"), (0, (0.3, 0.1, 0.2)), (1, (0.1, 0.4, 0.1)), axis="-X", sizes=(0.3, 0.2)
    ),
    "sphere on a turning plane, spatial": Touching(
        "sphere_on_plane", random_tree("R+Z R+X P+Y", 52, (-1, 0, -1)), (2, (0.4, 0.1, 0.3)), (1, (0, 0.2, 0.1)), axis="+Y"
    ),
}  # fmt: skip


@pytest.mark.by_turns(4)
@pytest.mark.parametrize("friction", [False, True], ids=["frictionless", "friction"])
@pytest.mark.parametrize("name", PAIRS)
def test_contact_forces_do_the_virtual_work_of_the_contact_point(name, friction):
    PAIRS[name].check_forces(friction)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", PAIRS)
def test_gaps_and_their_rates_are_those_of_the_geometry(name):
    case = PAIRS[name]
    derived = case.derive(friction=False)
    rng = np.random.default_rng(3)
    for t, q, u in case.states(derived, 2):
        beside = [q + rng.uniform(-0.05, 0.05, derived.nu)] if derived.nq == derived.nu else []  # no quaternion
        for there in (q, *beside):
            a = rng.uniform(-5, 5, derived.nu)
            gap, rate = derived.call("gaps", t=t, q=there, u=u)
            second = derived.call("gap_accelerations", t=t, q=there, u=u, a=a)
            assert gap == pytest.approx([case.event(case.tree.whole(t, there, speeds=False))], rel=1e-9, abs=1e-14)
            assert rate == pytest.approx(rate_along(derived, "gaps", 0, t, there, u, a), rel=1e-11)
            assert second == pytest.approx(rate_along(derived, "gaps", 1, t, there, u, a), rel=1e-10)


def test_friction_vanishes_smoothly_where_a_spatial_contact_does_not_slide():
    """At rest the tangent has no direction; the force must be zero there, not 0/0."""
    case = PAIRS["sphere on plane, spatial"]
    derived = case.derive(friction=True)
    _, q, _ = next(case.states(derived, 1))
    at_rest = derived.call("contact_touch", q=q, u=np.zeros(3), m=[V0])
    frictionless = case.derive(friction=False).call("contact_touch", q=q, u=np.zeros(3), m=[V0])
    assert np.all(np.isfinite(at_rest[0]))
    assert at_rest[0] == pytest.approx(frictionless[0], rel=1e-14)


def test_both_parts_of_a_bounded_face_are_among_the_states_above():
    case = PAIRS["bounded"]
    derived = case.derive(friction=False)
    normals = [case.geometry(q)[1] - case.tree.pose(3, q)[1] @ case.axis for _, q, _ in case.states(derived)]
    assert {bool(np.linalg.norm(n) > 0.1) for n in normals} == {False, True}


def test_a_ball_in_the_centre_of_its_socket_has_a_gap_a_rate_and_a_second_derivative():
    case = PAIRS["ball in socket, planar"]
    derived = case.derive(friction=True)
    q = np.zeros(derived.nu)
    q[:2] -= (case.tree.point(*case.first, q) - case.tree.point(*case.second, q))[:2]
    apart = case.tree.point(*case.first, q) - case.tree.point(*case.second, q)
    assert np.max(np.abs(apart)) < 1e-15
    u = np.array([0.3, -0.2, 0.0, 0.0])
    gap, rate = derived.call("gaps", q=q, u=u)
    assert gap == pytest.approx([case.sizes[1] / 2], rel=1e-14)
    assert rate == pytest.approx([0], abs=1e-14)
    second = derived.call("gap_accelerations", q=q, u=u, a=np.zeros(4))
    assert second == pytest.approx([-(0.3**2 + 0.2**2) / case.sizes[1]], rel=1e-12)
    for function in ("gaps", "gap_accelerations"):
        for argument in ("q", "u"):
            options = {"t": 0.0, "q": q, "u": u} | ({"a": np.zeros(4)} if function == "gap_accelerations" else {})
            assert np.all(np.isfinite(derived.jacobian(function, argument, **options)))
    assert derived.OUTPUTS == (("touch.eccentricity_x", "m"), ("touch.eccentricity_y", "m"))  # no third in the plane


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", PAIRS)
def test_derivatives_are_numbers_in_contact_and_apart(name):
    case = PAIRS[name]
    derived = case.derive(friction=True)
    for t, q, u in case.states(derived, 1):
        options = {"t": t, "q": q, "u": u}
        for which in ("q", "u"):
            assert np.all(np.isfinite(derived.jacobian("contact_touch", which, **options, m=[V0])))
            assert np.all(np.isfinite(derived.jacobian("gap_accelerations", which, **options, a=u)))
        apart = {**options, "q": derived.with_gap(t, q, 0, 0.05)}
        for which in ("q", "u"):
            assert np.all(np.isfinite(derived.jacobian("gaps", which, result=1, **apart)))
            assert not np.any(derived.jacobian("contact_touch", which, **apart, m=[V0]))


# -- a face ends -------------------------------------------------------------------------------------------------------

SIZE, PACE = hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 1)
MASS = hd.Parameter("mass", "kg", 1)
STIFF = power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5)
BLOCK = hd.Body("block", MASS, hd.Parameter("J", "kg m^2", 0.01))


def scene(pair, joint=None, effects=None):
    joint = joint or hd.Planar("float", hd.GROUND, BLOCK)
    return hd.Scene(
        hd.Mechanism("touching", (joint,), (pair,)),
        effects or (hd.Contact("touch", STIFF), hd.EnergyLedger()),
        hd.Scales(length=SIZE, speed=PACE, arm=SIZE),
    )


def test_a_bounded_face_makes_no_contact_beyond_its_ends():
    """A point all around the solid, x < 1 to both sides and y < 0: the gap is negative inside alone."""
    derived = Derived(
        scene(
            hd.CornerOnFace(
                "touch", BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Y, hd.X, hd.Parameter("length", "m", 2)
            )
        )
    )
    for x, y, gap in (
        (0, 0.1, 0.1), (0.5, -0.1, -0.1), (1.2, -0.1, 0.2), (-1.2, -3, 0.2), (1.2, 0.5, 0.5), (0.95, -0.3, -0.05),
        (-0.7, -0.9, -0.3),
    ):  # fmt: skip
        (outcome, *_) = derived.call("gaps", q=[x, y, 0.4], u=np.zeros(3))
        assert outcome == pytest.approx([gap], rel=1e-12)
        f, *_ = derived.call("contact_touch", q=[x, y, 0.4], u=np.zeros(3), m=[])
        towards = np.array([np.sign(x), 0, 0]) if abs(x) > 0.6 else np.array([0, 1, 0])
        assert f == pytest.approx(1e8 * max(-gap, 0) ** 1.5 * towards, rel=1e-12)


# -- bad input ---------------------------------------------------------------------------------------------------------

R, CLEARANCE = hd.Parameter("radius", "m", 0.05), hd.Parameter("clearance", "m", 0.001)
HERE, THERE = BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0)
GAP = hd.APART[1] - R
FOOT = (hd.APART[0], 0, hd.APART[2])


def faults(pair, joint=None, **given):
    with pytest.raises(hd.InputError) as caught:
        hd.derive(scene(pair, joint, **given))
    return str(caught.value)


ROLLER = hd.Body("roller", MASS, tuple(hd.Parameter(f"J_{k}", "kg m^2", 0.1) for k in "xyz"))
BAD = {
    "no socket": (lambda: hd.BallInSocket("touch", HERE, THERE, hd.Parameter("r", "m", 0), CLEARANCE), "socket radius: found 0 m"),
    "clearance above the socket": (lambda: hd.BallInSocket("touch", HERE, THERE, CLEARANCE, R), "minus clearance): found -0.049 m"),
    "no clearance": (lambda: hd.BallInSocket("touch", HERE, THERE, R, hd.Parameter("none", "m", 0)), "clearance: found 0 m"),
    "no radius": (lambda: hd.RimOnPlane("touch", HERE, hd.Z, hd.Parameter("r", "m", 0), THERE, hd.Y), "pair touch, radius: found 0 m"),
    "no length": (lambda: hd.CylinderOnPlane("touch", HERE, hd.Z, R, hd.Parameter("l", "m", 0), THERE, hd.Y), "pair touch, length: found 0 m"),
    "a normal of no length": (lambda: hd.CornerOnFace("touch", HERE, THERE, hd.Direction((0, 0, 0))), "a direction of length 0"),
    "a length without a direction": (lambda: hd.CornerOnFace("touch", HERE, THERE, hd.Y, length=R), "a length without a direction"),
    "a direction without a length": (lambda: hd.CornerOnFace("touch", HERE, THERE, hd.Y, along=hd.X), "a direction without a length"),
    "along the normal": (lambda: hd.CornerOnFace("touch", HERE, THERE, hd.Y, hd.Direction((1, 1, 0)), R), "a cosine of 0.707 to the normal"),
    "a body and itself": (lambda: hd.CornerOnFace("touch", HERE, BLOCK.at(R, 0, 0), hd.Y), "both sides on block"),
    "text": (lambda: hd.CustomPair("touch", HERE, THERE, "apart_y", (0, 1, 0), FOOT), "'apart_y'"),
    "a wrong unit": (lambda: hd.CustomPair("touch", HERE, THERE, hd.APART[1] ** 2, (0, 1, 0), FOOT), "pair touch, gap: found apart_y**2 [m^2]"),
    "units that do not add": (lambda: hd.CustomPair("touch", HERE, THERE, GAP, (0, 1 + hd.APART[0], 0), FOOT), "pair touch, normal, y"),
    "a bare number": (lambda: hd.CustomPair("touch", HERE, THERE, GAP, (0, 1, 0), (0, 0.2, 0)), "the bare number 0.2"),
    "a strange symbol": (lambda: hd.CustomPair("touch", HERE, THERE, GAP - sp.Symbol("x"), (0, 1, 0), FOOT), "the symbol x"),
    "two components": (lambda: hd.CustomPair("touch", HERE, THERE, GAP, (0, 1), FOOT), "three values"),
    "no unit vector": (lambda: hd.CustomPair("touch", HERE, THERE, GAP, (0, 2, 0), FOOT), "a length of 2 where the gap is closed"),
    "the wrong side": (lambda: hd.CustomPair("touch", HERE, THERE, GAP, (0, -1, 0), FOOT), "expected the distance of the surfaces"),
    "no distance": (lambda: hd.CustomPair("touch", HERE, THERE, 2 * GAP, (0, 1, 0), FOOT), "expected the distance of the surfaces"),
    "a point off the line of action": (
        lambda: hd.CustomPair("touch", BLOCK.at(R, 0, 0), THERE, GAP, (0, 1, 0), (0, 0, 0)), "expected the distance of the surfaces",
    ),
    "a gap that never closes": (lambda: hd.CustomPair("touch", HERE, THERE, R + hd.APART[0] ** 2 / R, (1, 0, 0), FOOT),
    "no position where it is negative"),
}  # fmt: skip


@each("label", BAD)
def test_a_bad_pair_is_refused(label):
    declare, message = BAD[label]
    assert message in faults(declare())


def test_faults_of_several_pairs_come_at_once():
    one, two = hd.Body("one", MASS, hd.Parameter("J", "kg m^2", 0.01)), BLOCK
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("many", (hd.Planar("a", hd.GROUND, one), hd.Planar("b", hd.GROUND, two)), (
                hd.BallInSocket("first", one.at(0, 0, 0), two.at(0, 0, 0), CLEARANCE, R),
                hd.CornerOnFace("second", one.at(0, 0, 0), one.at(0, 0, 0), hd.Y, hd.Y, hd.Parameter("l", "m", -1)),
                hd.CustomPair("third", one.at(0, 0, 0), two.at(0, 0, 0), GAP**2, (0, 1, 0), (MASS, 0, 0)),
            )),
            (hd.Contact("first", STIFF), hd.Contact("second", STIFF), hd.EnergyLedger()),
            hd.Scales(length=SIZE, speed=PACE),
        )  # fmt: skip
    text = str(caught.value)
    for piece in (
        "ball radius", "both sides on one", "pair second, length: found -1 m", "a cosine of 1 to the normal", "[m^2]",
        "mass [kg]", "no arm",
    ):  # fmt: skip
        assert piece in text, piece


def test_a_cylinder_that_may_tilt_is_refused_and_one_that_may_yaw_is_not():
    pair = hd.CylinderOnPlane("touch", ROLLER.at(0, 0, 0), hd.X, R, SIZE, hd.GROUND.at(0, 0, 0), hd.Y)
    assert "RimOnPlane for each end" in faults(pair, hd.Spherical("ball", hd.GROUND, ROLLER))
    hd.derive(scene(pair, hd.Cylindrical("yaw", hd.GROUND, ROLLER, axis=hd.Y), effects=(hd.Contact("touch", STIFF),)))
    assert "RimOnPlane for each end" in faults(pair, hd.Revolute("tilt", hd.GROUND, ROLLER, axis=hd.Z))


def test_relative_curvature_is_that_of_both_surfaces():
    """R_eff = sqrt(R' R'') of the principal relative radii, concave ones negative (Johnson 1985, section 4.1), of cylinders that across; in mm."""
    big, small, gap, mm = (hd.Parameter(f"size_{k}", "mm", k) for k in (30, 20, 10, 15))
    balls = {"R_min": 20, "R_1": 30, "R_2": 20}
    side_by_side = {**balls, "R_eff": 1 / (1 / 20 + 1 / 30), "dR": 50}
    hollow = {**balls, "R_eff": 1 / (1 / 20 - 1 / 30), "dR": 10}
    flat = {"R_eff": 20, "R_min": 20, "R_2": 20}
    cases = (
        (hd.SphereOnSphere("touch", HERE, THERE, big, small), side_by_side),
        (hd.ParallelCylinders("touch", HERE, THERE, big, small, hd.Z, mm), {**side_by_side, "L": 15}),
        (hd.PinInBush("touch", HERE, THERE, hd.Z, big, gap, length=mm), {**hollow, "L": 15}),
        (hd.BallInSocket("touch", HERE, THERE, big, gap), hollow),
        (hd.SphereOnPlane("touch", HERE, small, THERE, hd.Y), flat),
        (hd.CylinderOnPlane("touch", HERE, hd.X, small, mm, THERE, hd.Y), {"R_eff": 20, "R_min": 20, "L": 15}),
        (hd.SphereOnBox("touch", HERE, small, THERE, big, big, big), flat),
        (hd.SphereOnFace("touch", HERE, small, THERE, hd.Y, hd.X, big, big), flat),
        (hd.SphereOnCylinder("touch", HERE, small, THERE, big, hd.Z), {**balls, "R_eff": 1 / np.sqrt(1 / 20 * (1 / 20 + 1 / 30))}),
    )  # fmt: skip
    for pair, expected in cases:
        actual = {name: 1e3 * default_value(value) for name, value in pair.geometry.items()}
        assert actual == pytest.approx(expected, rel=1e-12), pair.kind


def test_laws_ask_pairs_for_the_geometry_they_need():
    steel = hd.Parameter("E", "GPa", 207), hd.Parameter("nu", "1", 0.3)
    hertz = hd.Contact("touch", hertz_point(hd.Material(*steel), hd.Material(*steel)))
    edge = hd.RimOnPlane("touch", HERE, hd.Z, R, THERE, hd.Y)
    assert "without R_eff" in faults(edge, effects=(hertz,))
    hd.derive(scene(hd.BallInSocket("touch", HERE, THERE, R, CLEARANCE), effects=(hertz,)))
    given = hd.CustomPair("touch", HERE, THERE, GAP, (0, 1, 0), FOOT)
    assert "without R_eff" in faults(given, effects=(hertz,))
    hd.derive(scene(hd.CustomPair("touch", HERE, THERE, GAP, (0, 1, 0), FOOT, radius=R), effects=(hertz,)))
