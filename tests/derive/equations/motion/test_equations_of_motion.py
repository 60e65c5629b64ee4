"""Derived equations against independent ones: sympy.physics.mechanics, textbooks, energy, virtual work, the hand-derived slider-crank."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from derived import Derived, energy_balance, rate_along
from kane import Tree, deviation_of_poses, driven, random_tree, rows
from touching import V0, Touching

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    EnergyLedger,
    Gravity,
    InputError,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    X,
    Y,
    Z,
)
from hertzwerk.derive.equations.motion import equations_of_motion
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.derive.scenes.slider_crank_frictionless import scene as slider_crank_frictionless
from reference.slider_crank import SliderCrank

PLANAR = {
    "pendulum": random_tree("R+Z", 1, planar=2),
    "two links": random_tree("R+Z R+Z", 2, planar=2),
    "opposite axes": random_tree("R+Z R-Z R+Z", 3, planar=2),
    "four links": random_tree("R-Z R+Z R+Z R-Z", 4, planar=2),
    "cart-pole": random_tree("P+X R+Z", 5, planar=2),
    "slider on a rotating arm": random_tree("R+Z P+X R-Z", 6, planar=2),
    "table": random_tree("P+X P-Y R+Z", 7, planar=2),
    "branches": random_tree("R+Z R+Z R-Z R+Z P+Y", 8, parents=(-1, 0, 0, 1, -1), planar=2),
    "in the plane of y and z": random_tree("R+X P+Y R-X", 9, planar=0, down="-Z"),
    "sideways gravity": random_tree("R-Y R+Y", 10, planar=1, down="+X"),
    "no gravity": random_tree("R+Z R+Z", 11, planar=2, gravity=0.0),
}
SPATIAL = {
    "z x": random_tree("R+Z R+X", 21),
    "z -x y": random_tree("R+Z R-X R+Y", 22, down="+Z"),
    "prismatic between": random_tree("R-Y P+Z R+X", 23),
    "merged, then across": random_tree("R+X R-X R-Y", 24, down="-X"),
    "branches": random_tree("R+X R-Y R+Z P-X", 25, parents=(-1, 0, 0, 2)),
    "prismatic first": random_tree("P-Z R+X R+Y", 26),
}
TREES = {
    **{f"planar, {name}": tree for name, tree in PLANAR.items()},
    **{f"spatial, {name}": tree for name, tree in SPATIAL.items()},
    "driven root, planar": driven(random_tree("R+Z R+Z R+Z", 31, planar=2), 0, 2.5),
    "driven root, spatial": driven(random_tree("R+Z R-X R+Y", 32), 0, -1.5),
    "driven slide": driven(random_tree("P+X R+Z", 33, planar=2), 0, 0.7),
    "driven in the middle": driven(random_tree("R+Z R+X R+Z", 34), 1, 3.0),
    "two drives": driven(driven(random_tree("R+Z P+X R-Z", 35), 0, 1.1), 1, 0.4),
}


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
    "planar, four links",
    "spatial, branches",
    "driven in the middle",
    "two drives",
    "spatial, merged, then across",
}


@pytest.mark.by_turns(4)
@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow) if n in LARGE else n for n in TREES])
def test_accelerations_and_drive_reactions_equal_kanes_method(name):
    assert deviation(TREES[name], derived_of(name)) < 1e-10


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", ["planar, branches", "spatial, branches", "driven root, spatial", "two drives"])
def test_articulated_bodies_move_as_by_kanes_method(name, monkeypatch):
    """The way of long paths, taken along short ones."""
    monkeypatch.setattr(equations_of_motion, "LONG_PATH", 0)
    assert deviation(TREES[name], Derived(TREES[name].scene()), 2) < 1e-10


@pytest.mark.by_turns(3)
@pytest.mark.parametrize(
    "seed", [pytest.param(n, marks=pytest.mark.slow if n < 3 else pytest.mark.exhaustive) for n in range(30)]
)
def test_random_trees_equal_kanes_method(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 5))
    kinds, axes = rng.choice(["R", "R", "P"], n), rng.choice(["+X", "-X", "+Y", "-Y", "+Z", "-Z"], n)
    tree = random_tree(
        " ".join(kind + axis for kind, axis in zip(kinds, axes, strict=True)),
        seed,
        parents=[int(rng.integers(-1, i)) if i else -1 for i in range(n)],
        down=str(rng.choice(["+X", "-Y", "+Z"])),
    )
    if rng.random() < 0.4:
        tree = driven(tree, int(rng.integers(n)), 1.7)
    try:
        derived = Derived(tree.scene())
    except InputError as error:  # gravity across every joint is refused: KanesMethod, which keeps it, must not notice
        assert [fault.where for fault in error.faults] == ["effect gravity"]
        derived = Derived(replace(tree, gravity=0.0).scene())
    assert deviation(tree, derived) < 1e-10


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


# -- against textbooks -------------------------------------------------------------------------------------------------

LENGTHS = Scales(length=Parameter("size", "m", 1), speed=Parameter("pace", "m/s", 1), arm=Parameter("size", "m", 1))


def matrices(derived, q, u):
    """Mass matrix, forces at zero accelerations without gravity, gravity's generalised forces, read off the generated functions."""
    n = derived.nu
    zero, _ = derived.call("accelerations", q=q, u=u, f=np.zeros(n))
    inverse = np.array([derived.call("accelerations", q=q, u=u, f=row)[0] - zero for row in np.eye(n)]).T
    mass = np.linalg.inv(inverse)
    return mass, -mass @ zero, derived.call("applied", q=q, u=u)


def test_two_link_arm_equals_the_textbook():
    """Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation (1994), eq. (4.11), with M(q) a + C(q, u) u = force;
    gravity as in Spong, Hutchinson, Vidyasagar, Robot Modeling and Control (2006), section 7.4."""
    m1, m2, l1, r1, r2, I1, I2, g = 1.3, 0.7, 0.8, 0.35, 0.25, 0.06, 0.03, 9.81
    names = ("m1", "kg", m1), ("m2", "kg", m2), ("l1", "m", l1), ("r1", "m", r1), ("r2", "m", r2)
    pm1, pm2, pl1, pr1, pr2 = (Parameter(*row) for row in names)
    upper = Body("upper", pm1, Parameter("I1", "kg m^2", I1), (pr1, 0, 0))
    lower = Body("lower", pm2, Parameter("I2", "kg m^2", I2), (pr2, 0, 0))
    joints = Revolute("shoulder", GROUND, upper, Z), Revolute("elbow", upper.at(pl1, 0, 0), lower, Z)
    gravity = Gravity("gravity", Parameter("g", "m/s^2", g), -Y)
    arm = Derived(Scene(Mechanism("arm", joints), (gravity, EnergyLedger()), LENGTHS))

    alpha = I1 + I2 + m1 * r1**2 + m2 * (l1**2 + r2**2)
    beta, delta = m2 * l1 * r2, I2 + m2 * r2**2
    for q1, q2, u1, u2 in ((0.3, -1.1, 0.7, 2.0), (-2.0, 0.4, -1.5, 0.2), (1.0, 3.0, 4.0, -3.0)):
        c2, s2 = np.cos(q2), np.sin(q2)
        M = [[alpha + 2 * beta * c2, delta + beta * c2], [delta + beta * c2, delta]]
        C = np.array([[-beta * s2 * u2, -beta * s2 * (u1 + u2)], [beta * s2 * u1, 0]])
        G2 = m2 * r2 * g * np.cos(q1 + q2)
        G = np.array([(m1 * r1 + m2 * l1) * g * np.cos(q1) + G2, G2])
        mass, bias, pull = matrices(arm, (q1, q2), (u1, u2))
        assert mass == pytest.approx(np.array(M), rel=1e-12)
        assert bias == pytest.approx(C @ (u1, u2), rel=1e-12, abs=1e-12)
        assert pull == pytest.approx(-G, rel=1e-12)


def test_cart_pole_equals_the_textbook():
    """Astrom, Murray, Feedback Systems (2008), eq. (2.9), the balance system without friction:
    [[M + m, -m l cos], [-m l cos, J + m l^2]] (x'', angle'') + (m l sin angle'^2, -m g l sin) = (F, 0)."""
    M, m, l, J, g = 2.0, 0.4, 0.6, 0.05, 9.81
    cart = Body("cart", Parameter("M", "kg", M))
    pole = Body("pole", Parameter("pole_mass", "kg", m), Parameter("J", "kg m^2", J), (0, Parameter("l", "m", l), 0))
    joints = Prismatic("rail", GROUND, cart, X), Revolute("hinge", cart, pole, Z)
    gravity = Gravity("gravity", Parameter("g", "m/s^2", g), -Y)
    derived = Derived(Scene(Mechanism("cart_pole", joints), (gravity, EnergyLedger()), LENGTHS))
    for x, angle, dx, rate in ((0.2, 0.1, 1.0, -2.0), (-1.0, 2.5, 0.3, 4.0)):
        c, s = np.cos(angle), np.sin(angle)
        mass, bias, pull = matrices(derived, (x, angle), (dx, rate))
        assert mass == pytest.approx(np.array([[M + m, -m * l * c], [-m * l * c, J + m * l**2]]), rel=1e-12)
        assert bias == pytest.approx((m * l * s * rate**2, 0), rel=1e-12, abs=1e-12)
        assert pull == pytest.approx((0, m * g * l * s), rel=1e-12, abs=1e-12)


def test_spherical_pendulum_equals_the_textbook():
    """Landau, Lifshitz, Mechanics, section 14, problem 1: L = m l^2 (theta'^2 + phi'^2 sin^2 theta)/2 + m g l cos theta,
    here with the bob's own inertia (A, A, C), whose spin about the rod is phi' cos theta, and with the yoke's Jz."""
    m, l, A, C, Jz, g = 0.9, 0.5, 0.07, 0.03, 0.02, 9.81
    tiny = Parameter("Jx", "kg m^2", 0.01)
    yoke = Body("yoke", Parameter("yoke_mass", "kg", 1.0), (tiny, tiny, Parameter("Jz", "kg m^2", Jz)))
    pA, pC = Parameter("A", "kg m^2", A), Parameter("C", "kg m^2", C)
    bob = Body("bob", Parameter("bob_mass", "kg", m), (pA, pA, pC), (0, 0, -Parameter("l", "m", l)))
    joints = Revolute("azimuth", GROUND, yoke, Z), Revolute("tilt", yoke, bob, Y)
    gravity = Gravity("gravity", Parameter("g", "m/s^2", g), -Z)
    derived = Derived(Scene(Mechanism("pendulum", joints), (gravity, EnergyLedger()), LENGTHS))
    across = A + m * l**2
    for phi, theta, dphi, dtheta in ((0.4, 0.7, 1.5, -2.0), (2.0, -1.9, -3.0, 0.5)):
        c, s = np.cos(theta), np.sin(theta)
        mass, bias, pull = matrices(derived, (phi, theta), (dphi, dtheta))
        assert mass == pytest.approx(np.diag([Jz + across * s**2 + C * c**2, across]), rel=1e-12, abs=1e-14)
        turning = (across - C) * s * c
        assert bias == pytest.approx((2 * turning * dphi * dtheta, -turning * dphi**2), rel=1e-12)
        assert pull == pytest.approx((0, -m * g * l * s), rel=1e-12, abs=1e-14)


# -- energy ------------------------------------------------------------------------------------------------------------


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", TREES)
def test_energy_changes_by_the_power_of_the_other_forces_and_the_drives(name):
    tree = TREES[name]
    derived = derived_of(name)
    for t, q, u, force in states(tree, 2):
        work = force @ tree.whole(t, u, speeds=True)
        assert energy_balance(derived, t, q, u, rows(tree, force), work) < 1e-12


def test_a_wrong_energy_is_noticed():
    tree = TREES["spatial, z x"]
    derived = Derived(text=derived_of("spatial, z x").text.replace("kinetic = ", "kinetic = 1.0001*", 1))
    t, q, u, force = next(states(tree, 1))
    assert energy_balance(derived, t, q, u, rows(tree, force), force @ u) > 1e-7


# -- contact forces against virtual work -------------------------------------------------------------------------------


def many(*kinds, parents=None):
    """Bodies on joints of these kinds, on the ground unless `parents` says otherwise."""
    links = random_tree(" ".join(["R+Z"] * len(kinds)), 53, parents or [-1] * len(kinds)).links
    return Tree(tuple(replace(link, kind=kind, second="+X") for link, kind in zip(links, kinds, strict=True)))


TOUCHING = {
    "pin in bush, planar": Touching(
        "pin_in_bush", random_tree("R+Z R+Z P+X", 41, (-1, 0, -1), planar=2), (1, (0.5, 0.1, 0)), (2, (0.1, 0.2, 0)), sizes=(0.3, 0.1)
    ),
    "pin in bush, both turning": Touching(
        "pin_in_bush", random_tree("R+Z R+Z R-Z R+Z", 42, (-1, 0, -1, 2), planar=2), (1, (0.4, 0, 0)), (3, (0.3, -0.2, 0)), sizes=(0.3, 0.1)
    ),
    "pin in bush, driven": Touching(
        "pin_in_bush", driven(random_tree("R+Z R+Z P+X", 143, (-1, 0, -1), planar=2), 0, 2.0), (1, (0.5, 0.1, 0)), (2, (0, 0, 0)), sizes=(0.3, 0.1)
    ),
    "pin in bush, on the ground": Touching("pin_in_bush", random_tree("R+Z R+X", 44), (1, (0.3, 0.1, 0.2)), (-1, (0.1, 0.4, 0.1)), sizes=(0.5, 0.4)),
    "pin in bush, spatial": Touching(
        "pin_in_bush", random_tree("R+Z R+X R+Y", 45, (-1, 0, -1)), (1, (0.3, 0.1, 0.2)), (2, (0.1, 0.4, 0.1)), axis="-X", sizes=(0.3, 0.2)
    ),
    "sphere on sphere, planar": Touching("sphere_on_sphere", random_tree("R+Z P+X", 46, (-1, -1), planar=2), (0, (0.4, 0.1, 0)), (1, (0.1, 0, 0))),
    "sphere on sphere, spatial": Touching("sphere_on_sphere", random_tree("R+Z R-X R+Y", 47, (-1, 0, -1)), (1, (0.4, 0.1, 0)), (2, (0.1, 0.2, 0.3))),
    "sphere on sphere, common root": Touching(
        "sphere_on_sphere", driven(random_tree("R+Z R-X R+Y", 48, (-1, 0, 0)), 0, 1.3), (1, (0.4, 0.1, 0)), (2, (0.1, 0.2, 0.3))
    ),
    "sphere on plane, planar": Touching("sphere_on_plane", random_tree("P+X R+Z", 49, planar=2), (1, (0.4, 0.1, 0)), (-1, (0, 0.2, 0)), axis="+Y"),
    "sphere on plane, spatial": Touching("sphere_on_plane", random_tree("P+X R+Z R-Y", 50), (2, (0.4, 0.1, 0.1)), (-1, (0, 0.2, 0.1)), axis="-X"),
    "sphere on sphere, both on balls": Touching("sphere_on_sphere", many("S", "F"), (0, (0.4, 0.1, 0)), (1, (0.1, 0.2, 0.3))),
    "pin in bush, a free body in a free one": Touching(
        "pin_in_bush", many("F", "F"), (0, (0.3, 0.1, 0.2)), (1, (0.1, 0.4, 0.1)), axis="-X", sizes=(0.3, 0.2)
    ),
    "sphere on plane, universal on a slide": Touching(
        "sphere_on_plane", many("P", "U", parents=(-1, 0)), (1, (0.4, 0.1, 0.1)), (-1, (0, 0.2, 0.1)), axis="-X"
    ),
    "sphere on a turning plane": Touching(
        "sphere_on_plane", random_tree("R+Z P+X P+Y R-Z", 51, (-1, -1, 1, 2), planar=2), (3, (0.4, 0.1, 0)), (0, (0.1, 0.2, 0)), axis="+Y"
    ),
    "sphere on a turning plane, spatial": Touching(
        "sphere_on_plane", random_tree("R+Z R+X P+Y", 52, (-1, 0, -1)), (2, (0.4, 0.1, 0.3)), (1, (0, 0.2, 0.1)), axis="+Y"
    ),
}  # fmt: skip


@pytest.mark.by_turns(5)
@pytest.mark.parametrize("friction", [False, True], ids=["frictionless", "friction"])
@pytest.mark.parametrize("name", TOUCHING)
def test_contact_forces_do_the_virtual_work_of_the_contact_point(name, friction):
    TOUCHING[name].check_forces(friction)


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", TOUCHING)
def test_gap_is_minus_the_penetration_to_first_order_and_its_rates_are_its_derivatives(name):
    case = TOUCHING[name]
    derived = case.derive(friction=False)
    rng = np.random.default_rng(3)
    for t, q, u in case.states(derived, 2):
        a = rng.uniform(-5, 5, derived.nu)
        gap, rate = derived.call("gaps", t=t, q=q, u=u)
        second = derived.call("gap_accelerations", t=t, q=q, u=u, a=a)
        assert rate == pytest.approx(rate_along(derived, "gaps", 0, t, q, u, a), rel=1e-11)
        assert second == pytest.approx(rate_along(derived, "gaps", 1, t, q, u, a), rel=1e-10)
        depth = case.geometry(case.tree.whole(t, q, speeds=False))[0]
        reach = {"sphere_on_plane": None, "sphere_on_sphere": sum(case.sizes), "pin_in_bush": case.sizes[1]}[case.kind]
        inside = 1 if case.kind == "pin_in_bush" else -1  # distance = reach + inside * depth
        expected = -depth if reach is None else -depth - inside * depth**2 / (2 * reach)
        assert gap == pytest.approx([expected], rel=1e-9)
        assert gap[0] < 0 < depth


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", ["pin in bush, spatial", "sphere on sphere, spatial", "sphere on plane, spatial"])
def test_an_open_pair_does_nothing(name):
    case = TOUCHING[name]
    derived = case.derive(friction=True)
    rng = np.random.default_rng(8)
    q = derived.with_gap(0.3, rng.uniform(-1, 1, derived.nq), 0, 0.1 * min(case.sizes))
    f, dz, normal_force, *_ = derived.call("contact_touch", t=0.3, q=q, u=rng.uniform(-1, 1, derived.nu), m=[V0])
    assert not np.any(f)
    assert not np.any(dz)
    assert not np.any(normal_force)
    assert derived.call("energy", t=0.3, q=q, u=np.ones(derived.nu))[2] == [0]


def test_friction_vanishes_smoothly_where_a_spatial_contact_does_not_slide():
    """At rest the tangent has no direction; the force must be zero there, not 0/0."""
    case = TOUCHING["sphere on plane, spatial"]
    derived = case.derive(friction=True)
    _, q, _ = next(case.states(derived, 1))
    at_rest = derived.call("contact_touch", q=q, u=np.zeros(3), m=[V0])
    frictionless = case.derive(friction=False).call("contact_touch", q=q, u=np.zeros(3), m=[V0])
    assert np.all(np.isfinite(at_rest[0]))
    assert at_rest[0] == pytest.approx(frictionless[0], rel=1e-14)


def test_a_contact_force_at_the_wrong_point_is_noticed():
    case = TOUCHING["pin in bush, planar"]
    right = case.derive(friction=True)
    t, q, u = next(case.states(right, 1))
    total, *_ = case.by_hand(q, u, True)
    shifted = Derived(
        case.tree.scene(*case.derive(True).scene.effects[1:3], pairs=[case.pair]), values={"first_y": 0.1001}
    )
    f, *_ = shifted.call("contact_touch", t=t, q=q, u=u, m=[V0])
    assert np.max(np.abs(f - rows(case.tree, total))) > 1e-5 * np.max(np.abs(total))


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


def test_slider_crank_starts_as_the_ideal_mechanism():
    mechanism = SliderCrank()
    q, u = Derived(slider_crank).start()
    theta, x, dtheta, dx = mechanism.start
    assert q == pytest.approx([theta, mechanism.r + mechanism.l], rel=1e-15)
    assert x == q[1] or x == pytest.approx(q[1])
    assert u == pytest.approx([dtheta - mechanism.w, dx], rel=1e-15)


def test_the_direction_of_the_sliding_speed_matters():
    """Friction on the other side of the pin would change the slider's acceleration: the comparison above can fail."""
    mechanism = SliderCrank(mu=-0.1)
    derived = Derived(slider_crank)
    t, state = next(hand_states(mechanism, 1e-4))
    q, u = (state[0] - mechanism.w * t, state[1]), (state[2] - mechanism.w, state[3])
    f, *_ = derived.call("contact_slider_pin", t=t, q=q, u=u, m=[2.5])
    a, _ = derived.call("accelerations", t=t, q=q, u=u, f=f + derived.call("applied", t=t, q=q, u=u))
    assert a != pytest.approx(mechanism.accelerations(t, state, v0=2.5), rel=1e-3)


# -- planar equations come out planar ----------------------------------------------------------------------------------


def turned(tree, shift):
    """The same mechanism with its axes renamed x -> y -> z -> x, `shift` times."""
    roll = lambda values: tuple(np.roll(values, shift).tolist())  # noqa: E731
    word = lambda axis: axis[0] + "XYZ"[("XYZ".index(axis[1]) + shift) % 3]  # noqa: E731
    links = tuple(
        replace(
            link,
            axis=word(link.axis),
            on_parent=roll(link.on_parent),
            on_child=roll(link.on_child),
            inertia=roll(link.inertia),
            centre=roll(link.centre),
            scalar=None if link.scalar is None else (link.scalar + shift) % 3,
        )
        for link in tree.links
    )
    return Tree(links, tree.gravity, word(tree.down))


@pytest.mark.parametrize(("name", "shift"), [("planar, branches", 1), ("driven root, planar", 2)])
def test_every_coordinate_plane_costs_the_same(name, shift):
    """There is no special path for the plane of x and y."""
    assert derived_of(name).OPERATIONS == Derived(turned(TREES[name], shift).scene()).OPERATIONS


def test_a_spatial_body_in_a_plane_mechanism_costs_nothing_more():
    """A triple of principal inertias beside plane motion adds no operation after the constants."""
    flat = random_tree("R+Z R+Z R+Z", 61, planar=2)
    full = Tree(tuple(replace(link, scalar=None) for link in flat.links), flat.gravity, flat.down)
    counts = [dict(Derived(tree.scene()).OPERATIONS) for tree in (flat, full)]
    assert counts[0]["accelerations"] == counts[1]["accelerations"]


@pytest.mark.parametrize(
    ("pattern", "planar", "limit"), [("R+Z " * 6, 2, 510), ("R+Z R+X R+Y R+Z", None, 1200)], ids=["plane chain", "spatial chain"]
)  # fmt: skip
def test_the_size_of_derived_equations_is_kept(pattern, planar, limit):
    """A gate, not a target: raise it only with a reason."""
    assert (
        dict(Derived(random_tree(pattern, 71, planar=planar).scene(ledger=False)).OPERATIONS)["accelerations"] <= limit
    )
