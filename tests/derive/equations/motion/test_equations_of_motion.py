"""Derived equations against independent ones: sympy.physics.mechanics, textbooks, energy, virtual work, the hand-derived slider-crank."""

import cProfile
import pstats
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from derived import Derived, energy_balance
from hypothesis import HealthCheck, given, reject, settings
from hypothesis import strategies as st
from kane import TURNED, Tree, deviation_of_poses, driven, line, link, random_tree, rows

import hertzwerk.derive as hd
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.program.program import Tape
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.derive.scenes.slider_crank_frictionless import scene as slider_crank_frictionless
from reference.slider_crank import SliderCrank

PLANAR = {
    "pendulum": random_tree("R+Z", 1, planar=2), "two links": random_tree("R+Z R+Z", 2, planar=2),
    "opposite axes": random_tree("R+Z R-Z R+Z", 3, planar=2), "four links": random_tree("R-Z R+Z R+Z R-Z", 4, planar=2),
    "cart-pole": random_tree("P+X R+Z", 5, planar=2), "slider on a rotating arm": random_tree("R+Z P+X R-Z", 6, planar=2),
    "table": random_tree("P+X P-Y R+Z", 7, planar=2), "branches": random_tree("R+Z R+Z R-Z R+Z P+Y", 8, parents=(-1, 0, 0, 1, -1), planar=2),
    "in the plane of y and z": random_tree("R+X P+Y R-X", 9, planar=0, down="-Z"),
    "sideways gravity": random_tree("R-Y R+Y", 10, planar=1, down="+X"), "no gravity": random_tree("R+Z R+Z", 11, planar=2, gravity=0.0),
}  # fmt: skip
SPATIAL = {
    "z x": random_tree("R+Z R+X", 21), "z -x y": random_tree("R+Z R-X R+Y", 22, down="+Z"), "prismatic between": random_tree("R-Y P+Z R+X", 23),
    "merged, then across": random_tree("R+X R-X R-Y", 24, down="-X"), "branches": random_tree("R+X R-Y R+Z P-X", 25, parents=(-1, 0, 0, 2)),
    "prismatic first": random_tree("P-Z R+X R+Y", 26),
}  # fmt: skip
SIGNED = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"]
TREES = {
    **{f"planar, {name}": tree for name, tree in PLANAR.items()}, **{f"spatial, {name}": tree for name, tree in SPATIAL.items()},
    "driven root, planar": driven(random_tree("R+Z R+Z R+Z", 31, planar=2), 0, 2.5),
    "driven root, spatial": driven(random_tree("R+Z R-X R+Y", 32), 0, -1.5), "driven slide": driven(random_tree("P+X R+Z", 33, planar=2), 0, 0.7),
    "driven in the middle": driven(random_tree("R+Z R+X R+Z", 34), 1, 3.0),
    "two drives": driven(driven(random_tree("R+Z P+X R-Z", 35), 0, 1.1), 1, 0.4),
}  # fmt: skip

TREES |= {
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
}  # joints of every kind


@cache
def derived_of(name):
    return Derived(TREES[name].scene())


def states(tree, count, seed=0):
    """Random (t, q, u, extra force by row of the tree)."""
    return tree.states(count, seed)


def deviation(tree, derived, count=4):
    """Largest relative difference of accelerations and reactions from KanesMethod."""
    worst = 0.0
    for t, q, u, force in states(tree, count):
        f = derived.call("applied", t=t, q=q, u=u) + rows(tree, force)
        ours = derived.call("accelerations", t=t, q=q, u=u, f=f)
        for a, b in zip(ours, tree.accelerations(t, q, u, force), strict=True):
            worst = np.maximum(
                worst, np.max(np.abs(a - b), initial=0.0) / np.max(np.abs(b), initial=1e-300)
            )  # NaN stays
    return worst


# -- against sympy.physics.mechanics -----------------------------------------------------------------------------------


LARGE = {
    "free on an arm, turned", "skew axes, turned", "skew after turned", "free, carrying", "welds",
    "planar, four links", "spatial, branches", "driven in the middle", "two drives", "spatial, merged, then across",
}  # fmt: skip


@pytest.mark.by_turns(8)
@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.exhaustive) if n in LARGE else n for n in TREES])
def test_accelerations_and_drive_reactions_equal_kanes_method(name):
    assert deviation(TREES[name], derived_of(name)) < 1e-10


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


@pytest.mark.exhaustive
@of_random_trees(50)
@given(trees())
def test_random_trees_equal_kanes_method(tree):
    """Up to eight bodies in a plane or in space: accelerations, reactions and the balance of powers; 50 s a tree."""
    try:
        actual = Derived(tree.scene())
    except hd.InputError as error:  # gravity along the only axis that something turns about
        assert [fault.found for fault in error.faults] == ["no equation that it enters"]
        reject()
    assert deviation(tree, actual, 2) < 1e-10
    for t, q, u, force in tree.states(1, seed=1):
        work = force @ tree.whole(t, u, speeds=True)
        assert energy_balance(actual, t, q, u, rows(tree, force), work) < 1e-12


@pytest.mark.parametrize("name", ["spherical", "free", "two balls"])
def test_a_quaternion_keeps_its_norm_and_turns_by_the_angular_velocity(name):
    """q.q' = 0, and R' = R [w]x, w in the child's axes."""
    found, tree = derived_of(name), TREES[name]
    for t, q, u, _ in tree.states(2):
        dq = found.call("coordinate_rates", t=t, q=q, u=u)
        for i in found.QUATERNIONS:
            assert q[i : i + 4] @ dq[i : i + 4] == pytest.approx(0, abs=1e-15)
        rate = (found.jacobian("poses", "q", 1, t=t, q=q) @ dq)[:9].reshape(3, 3)
        R = found.call("poses", t=t, q=q)[1][:9].reshape(3, 3)
        x, y, z = u[found.SPEEDS.index(("joint0.angular_speed_x", "rad/s")) :][:3]
        assert R.T @ rate == pytest.approx(np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), abs=1e-14)


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("parameter", ["m1", "J1z", "s1x", "b1y", "a2z", "w0", "g"])
def test_one_number_changed_by_a_thousandth_is_noticed(parameter):
    tree = TREES["driven root, spatial"]
    right = derived_of("driven root, spatial")
    wrong = {name: default * 1.001 for name, _, default, _ in right.PARAMETERS if name == parameter}
    assert wrong
    assert deviation(tree, Derived(text=right.text, values=wrong), 1) > 1e-7


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", ["planar, branches", "spatial, branches", "driven root, spatial"])
def test_without_a_ledger_the_same_accelerations_and_no_reactions(name):
    tree = TREES[name]
    with_ledger, without = derived_of(name), Derived(tree.scene(ledger=False))
    for t, q, u, force in states(tree, 2):
        f = rows(tree, force)
        a, _ = with_ledger.call("accelerations", t=t, q=q, u=u, f=f)
        b, none = without.call("accelerations", t=t, q=q, u=u, f=f[: len(tree.free)])
        assert np.array_equal(a, b)
        assert none.size == 0


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", TREES)
def test_poses_equal_products_of_rotations(name):
    assert deviation_of_poses(TREES[name], derived_of(name)) < 1e-13


# -- energy ------------------------------------------------------------------------------------------------------------


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", TREES)
def test_energy_changes_by_the_power_of_the_other_forces_and_the_drives(name):
    tree = TREES[name]
    derived = derived_of(name)
    for t, q, u, force in states(tree, 2):
        work = force @ tree.whole(t, u, speeds=True)
        assert energy_balance(derived, t, q, u, rows(tree, force), work) < 1e-12


# -- the slider-crank, derived by hand ---------------------------------------------------------------------------------


def hand_states(mechanism, depth, count=6, seed=2):
    """States of the reference (theta, x, theta', x') at time t with the journal at the given penetration."""
    rng = np.random.default_rng(seed)
    while count:
        t, direction = rng.uniform(0, 0.024), rng.uniform(-np.pi, np.pi)
        eps = mechanism.c + depth * rng.uniform(0.2, 1.0)
        phi = mechanism.w * t
        theta = np.arcsin((eps * np.sin(direction) - mechanism.r * np.sin(phi)) / mechanism.l)
        x = mechanism.r * np.cos(phi) + mechanism.l * np.cos(theta) - eps * np.cos(direction)
        rod_rate = -mechanism.w * mechanism.r * np.cos(phi) / (mechanism.l * np.cos(theta))
        yield t, (theta, x, rod_rate + rng.uniform(-20, 20), rng.uniform(-30, 30))
        count -= 1


@pytest.mark.parametrize("friction", [False, True], ids=["frictionless", "friction"])
@pytest.mark.parametrize("depth", [1e-4, -4e-4], ids=["contact", "flight"])
def test_slider_crank_equals_the_equations_derived_by_hand(friction, depth):
    mechanism = SliderCrank()
    derived = Derived(slider_crank if friction else slider_crank_frictionless)
    for t, state in hand_states(mechanism, depth):
        q = state[0] - mechanism.w * t, state[1]
        u = state[2] - mechanism.w, state[3]
        f, _, normal_force, sliding, in_range = derived.call("contact_slider_pin", t=t, q=q, u=u, m=[2.5])
        a, _ = derived.call("accelerations", t=t, q=q, u=u, f=f + derived.call("applied", t=t, q=q, u=u))
        F, _, v_t = mechanism.contact(t, state, 2.5, friction)
        expected = mechanism.accelerations(t, state, v0=2.5 if depth > 0 else None, friction=friction)
        assert a == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.max(np.abs(expected)))
        assert normal_force == pytest.approx([F], rel=1e-8)  # a penetration of 1e-5 m is known to 1e-17/1e-5
        assert np.abs(sliding) == pytest.approx([abs(v_t)] if friction else [], rel=1e-10)
        assert in_range == [1]
        e = derived.call("outputs", t=t, q=q, u=u)
        assert e == pytest.approx(mechanism.journal(t, state)[:2], rel=1e-9)
        gap, rate = derived.call("gaps", t=t, q=q, u=u)
        ex, ey, vx, vy = mechanism.journal(t, state)
        assert gap == pytest.approx([(mechanism.c**2 - ex**2 - ey**2) / (2 * mechanism.c)], rel=1e-9)
        assert rate == pytest.approx([-(ex * vx + ey * vy) / mechanism.c], rel=1e-9)
    assert (normal_force[0] > 0) == (depth > 0)


# -- planar equations come out planar ----------------------------------------------------------------------------------


def test_no_plane_and_no_further_inertia_costs_more():
    # There is no special path for the plane of x and y.
    for elsewhere, here in (
        ("in the plane of y and z", random_tree("R+Z P+X R-Z", 9, planar=2, down="-Y")),
        ("sideways gravity", random_tree("R-Z R+Z", 10, planar=2, down="+Y")),
    ):
        assert derived_of(f"planar, {elsewhere}").OPERATIONS == Derived(here.scene()).OPERATIONS
    # A triple of principal inertias beside plane motion adds no operation after the constants.
    flat = random_tree("R+Z R+Z R+Z", 61, planar=2)
    full = Tree(tuple(replace(link, scalar=None) for link in flat.links), flat.gravity, flat.down)
    counts = [dict(Derived(tree.scene()).OPERATIONS) for tree in (flat, full)]
    assert counts[0]["accelerations"] == counts[1]["accelerations"]


def test_a_chain_of_skew_axes_is_not_written_out():
    """Each axis once was written out in all angles before it: 12 million calls for three links, now some 300,000."""
    length, tilt = hd.Parameter("length", "m", 0.3), hd.Parameter("tilt", "rad", 0.4)
    joints, parent = [], hd.GROUND
    for i in range(3):
        child = hd.Body(f"link_{i}", hd.Parameter("mass", "kg", 1.0), (hd.Parameter("inertia", "kg m^2", 0.1),) * 3)
        joints.append(
            hd.Revolute(f"hinge_{i}", parent.at(length, 0, 0).turned(hd.X, tilt), child, hd.Direction((1, 2, i + 1)))
        )
        parent = child
    scales = hd.Scales(length, length * hd.Parameter("rate", "1/s", 1.0), arm=length)
    scene, tape = hd.Scene(hd.Mechanism("chain", tuple(joints)), (hd.EnergyLedger(),), scales), Tape()
    for parameter, dimension in scene.dimensions.items():
        tape.input(parameter.name, "p", dimension, symbol=parameter)
    with cProfile.Profile() as profile:
        Kinematics(tape, scene)
    assert pstats.Stats(profile).total_calls < 2_000_000
