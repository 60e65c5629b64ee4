"""Drives and force elements in the equations: against virtual work by complex steps, SymPy's mechanics, and the power balance."""

from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from derived import Derived
from kane import complex_step, driven, random_tree

import hertzwerk.derive as hd
from hertzwerk.derive.laws import brown_mcphee, smooth_coulomb

TREE = random_tree("R+Z P+X R-Y", 5, gravity=0)
ONE, TWO, GROUNDED = (0.3, -0.2, 0.1), (-0.15, 0.25, 0.4), (1.5, 0.7, -0.6)


def place(name, values):
    return tuple(hd.Parameter(f"{name}{k}", "m", value) for k, value in zip("xyz", values, strict=True))


STIFFNESS, DAMPING = hd.Parameter("stiffness", "N/m", 40.0), hd.Parameter("damping", "N s/m", 3.0)
REST = hd.Parameter("rest", "m", 0.6)
FORCE, RATE = hd.Parameter("F", "N", 7.0), hd.Parameter("rate", "rad/s", 2.0)
TORQUE = hd.Parameter("torque", "N m", 1.3)
DRY = smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 0.5))
STRIBECK = brown_mcphee(
    hd.Parameter("mu_k", "1", 0.2), hd.Parameter("mu_s", "1", 0.3), hd.Parameter("v_S", "m/s", 0.2), hd.Parameter("c_v", "N s/m", 0.1),
    hd.Parameter("N_t", "N", 5),
)  # fmt: skip
PRELOAD, RADIUS = hd.Parameter("preload", "N", 30.0), hd.Parameter("radius", "m", 0.05)


def at(body, where, name):
    frame = hd.GROUND if body < 0 else TREE.bodies[body]
    return frame.at(*place(name, where))


def point(body, where):
    """Place of a point at coordinates q, by hand."""
    return lambda q: TREE.point(body, where, q)


def work(body, where, force, q):
    """Generalised forces of a force on a point of a body."""
    return complex_step(point(body, where), q).T @ force


def velocity(body, where, q, u):
    return complex_step(point(body, where), q) @ u


def turning(body, q, u):
    """Angular velocity of a body from the derivative of its rotation matrix."""
    _, matrix = TREE.pose(body, q)
    rate = np.tensordot(complex_step(lambda x: TREE.pose(body, x)[1].reshape(-1), q).reshape(3, 3, -1), u, 1) @ matrix.T
    return np.array([rate[2, 1], rate[0, 2], rate[1, 0]])


@dataclass(frozen=True)
class Case:
    """An effect, and by hand at (t, q, u): generalised forces, stored energy, power dissipated, power put in."""

    effect: Any
    forces: Any
    stored: Any = lambda t, q, u: 0.0
    dissipated: Any = None
    supplied: Any = None


def line(q, u):
    r = point(-1, GROUNDED)(q) - point(2, ONE)(q)
    return r, -velocity(2, ONE, q, u)


def unit(i, value):
    return np.eye(3)[i] * value


def between(q, u):
    """From a point of the first body to one of the third, and its rate."""
    r = point(2, TWO)(q) - point(0, ONE)(q)
    return r, velocity(2, TWO, q, u) - velocity(0, ONE, q, u)


def pulled(tension, q):
    r = point(2, TWO)(q) - point(0, ONE)(q)
    return work(0, ONE, tension * r, q) - work(2, TWO, tension * r, q)


def pushed(t):
    return np.array([7.0 * np.cos(2 * t), 0.0, 7.0])


def couple(q, u, frame):
    moment = np.array([0.0, 1.3, 1.3 * u[1]])
    return TREE.pose(2, q)[1] @ moment if frame else moment


def turned(moment, q):
    return np.array([moment @ turning(2, q, unit) for unit in np.eye(3)])


def stribeck(n, s):
    return n * (0.2 * np.tanh(4 * s / 0.2) + 0.1 * (s / 0.2) / ((s / 0.2) ** 2 / 4 + 0.75) ** 2) + 0.1 * s * np.tanh(
        4 * n / 5
    )


ENDS = (at(0, ONE, "one"), at(2, TWO, "two"))
MOTOR = TORQUE * sp.sin(RATE * hd.T) - hd.Parameter("drag", "N m s", 0.4) * hd.speed_of("joint0") * sp.cos(
    hd.coordinate_of("joint2")
)
BOWL = STIFFNESS * hd.coordinate_of("joint1") ** 2 / 2 + TORQUE * sp.cos(hd.coordinate_of("joint0")) * hd.coordinate_of(
    "joint2"
)
CASES = {
    "joint spring": Case(
        hd.JointSpring("x", "joint1", STIFFNESS, REST), lambda t, q, u: unit(1, -40 * (q[1] - 0.6)), lambda t, q, u: 20 * (q[1] - 0.6) ** 2
    ),
    "torsional spring": Case(
        hd.JointSpring("x", "joint2", TORQUE), lambda t, q, u: unit(2, -1.3 * q[2]), lambda t, q, u: 0.65 * q[2] ** 2
    ),
    "joint damper": Case(
        hd.JointDamper("x", "joint0", hd.Parameter("c0", "N m s/rad", 0.7)), lambda t, q, u: unit(0, -0.7 * u[0]),
        dissipated=lambda t, q, u: 0.7 * u[0] ** 2
    ),
    "spring between points": Case(
        hd.PointSpring("x", *ENDS, STIFFNESS, REST),
        lambda t, q, u: pulled(40 * (1 - 0.6 / np.linalg.norm(between(q, u)[0])), q),
        lambda t, q, u: 20 * (np.linalg.norm(between(q, u)[0]) - 0.6) ** 2,
    ),
    "spring of no rest length": Case(
        hd.PointSpring("x", *ENDS, STIFFNESS), lambda t, q, u: pulled(40.0, q), lambda t, q, u: 20 * np.sum(between(q, u)[0] ** 2)
    ),
    "spring to the ground": Case(
        hd.PointSpring("x", at(2, ONE, "one"), at(-1, GROUNDED, "peg"), STIFFNESS),
        lambda t, q, u: work(2, ONE, 40 * line(q, u)[0], q), lambda t, q, u: 20 * np.sum(line(q, u)[0] ** 2),
    ),
    "damper between points": Case(
        hd.PointDamper("x", *ENDS, DAMPING),
        lambda t, q, u: pulled(3 * (between(q, u)[0] @ between(q, u)[1]) / np.sum(between(q, u)[0] ** 2), q),
        dissipated=lambda t, q, u: 3 * (between(q, u)[0] @ between(q, u)[1]) ** 2 / np.sum(between(q, u)[0] ** 2),
    ),
    "torque of time, coordinates and speeds": Case(
        hd.JointForce("x", "joint0", MOTOR),
        lambda t, q, u: unit(0, 1.3 * np.sin(2 * t) - 0.4 * u[0] * np.cos(q[2])),
        supplied=lambda t, q, u: u[0] * (1.3 * np.sin(2 * t) - 0.4 * u[0] * np.cos(q[2])),
    ),
    "force on a point": Case(
        hd.PointForce("x", at(2, ONE, "one"), (FORCE * sp.cos(RATE * hd.T), 0, FORCE)),
        lambda t, q, u: work(2, ONE, pushed(t), q), supplied=lambda t, q, u: pushed(t) @ velocity(2, ONE, q, u),
    ),
    "force that turns with a body": Case(
        hd.PointForce("x", at(2, ONE, "one"), (FORCE * sp.cos(RATE * hd.T), 0, FORCE), axes=TREE.bodies[0]),
        lambda t, q, u: work(2, ONE, TREE.pose(0, q)[1] @ pushed(t), q),
        supplied=lambda t, q, u: (TREE.pose(0, q)[1] @ pushed(t)) @ velocity(2, ONE, q, u),
    ),
    "torque on a body": Case(
        hd.BodyTorque("x", TREE.bodies[2], (0, TORQUE, TORQUE * hd.speed_of("joint1") / hd.Parameter("pace", "m/s", 1.0))),
        lambda t, q, u: turned(couple(q, u, False), q), supplied=lambda t, q, u: couple(q, u, False) @ turning(2, q, u),
    ),
    "torque in a body's axes": Case(
        hd.BodyTorque("x", TREE.bodies[2], (0, TORQUE, TORQUE * hd.speed_of("joint1") / hd.Parameter("pace", "m/s", 1.0)), axes=TREE.bodies[2]),
        lambda t, q, u: turned(couple(q, u, True), q), supplied=lambda t, q, u: couple(q, u, True) @ turning(2, q, u),
    ),
    "potential": Case(
        hd.Potential("x", BOWL),
        lambda t, q, u: np.array([1.3 * np.sin(q[0]) * q[2], -40 * q[1], -1.3 * np.cos(q[0])]),
        lambda t, q, u: 20 * q[1] ** 2 + 1.3 * np.cos(q[0]) * q[2],
    ),
    "friction of a journal": Case(
        hd.JointFriction("x", "joint0", DRY, PRELOAD, RADIUS),
        lambda t, q, u: unit(0, -0.05 * 6 * np.tanh(0.05 * u[0] / 0.5)), dissipated=lambda t, q, u: 0.05 * u[0] * 6 * np.tanh(0.05 * u[0] / 0.5),
    ),
    "friction of a slide under a varying load": Case(
        hd.JointFriction("x", "joint1", STRIBECK, PRELOAD + FORCE * sp.sin(RATE * hd.T)),
        lambda t, q, u: unit(1, -stribeck(30 + 7 * np.sin(2 * t), u[1])), dissipated=lambda t, q, u: u[1] * stribeck(30 + 7 * np.sin(2 * t), u[1]),
    ),
}  # fmt: skip


@cache
def derived_of(label):
    return Derived(TREE.scene(CASES[label].effect))


def states(tree, count=3, seed=1):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield rng.uniform(0, 1), rng.uniform(-2, 2, len(tree.free)), rng.uniform(-3, 3, len(tree.free))


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("label", CASES)
def test_generalised_forces_energy_and_powers_are_those_of_virtual_work(label):
    case, derived = CASES[label], derived_of(label)
    rest = Derived(TREE.scene())
    for t, q, u in states(TREE):
        assert derived.call("applied", t=t, q=q, u=u) == pytest.approx(case.forces(t, q, u), rel=1e-12, abs=1e-12)
        kinetic, potential, _ = derived.call("energy", t=t, q=q, u=u)
        assert potential == pytest.approx([case.stored(t, q, u)], rel=1e-12)
        assert np.array_equal(kinetic, rest.call("energy", t=t, q=q, u=u)[0])
        booked = dict(
            zip([name for name, _ in derived.MEMORY], derived.call("ledger", t=t, q=q, u=u, reactions=[]), strict=True)
        )
        expected = {"x.dissipated": case.dissipated, "x.input": case.supplied}
        assert set(booked) == {name for name, power in expected.items() if power is not None}
        for name, value in booked.items():
            assert value == pytest.approx(expected[name](t, q, u), rel=1e-12)


def test_the_comparison_has_teeth():
    """A force of the wrong sign, or on the wrong point, is not within 1e-12."""
    t, q, u = next(states(TREE))
    right = derived_of("spring between points").call("applied", t=t, q=q, u=u)
    assert np.max(np.abs(right + CASES["spring between points"].forces(t, q, u))) > 1
    moved = Derived(TREE.scene(hd.PointSpring("x", ENDS[0], at(2, ONE, "three"), STIFFNESS, REST)))
    assert np.max(np.abs(moved.call("applied", t=t, q=q, u=u) - right)) > 1e-3


# -- power balance -----------------------------------------------------------------------------------------------------


def imbalance(derived, t, q, u):
    """Rate of energy + dissipated - input at a state, over the largest of the powers."""
    f = derived.call("applied", t=t, q=q, u=u)
    a, reactions = derived.call("accelerations", t=t, q=q, u=u, f=f)
    rates = {"t": np.ones(1), "q": derived.call("coordinate_rates", t=t, q=q, u=u), "u": a}
    powers = [
        float((derived.jacobian("energy", which, part, t=t, q=q, u=u) @ rate).item())
        for part in (0, 1)
        for which, rate in rates.items()
    ]
    booked = derived.call("ledger", t=t, q=q, u=u, reactions=reactions)
    for (name, _), power in zip(derived.MEMORY, booked, strict=True):
        powers.append(power if name.endswith(".dissipated") else -power)
    return abs(sum(powers)) / max(map(abs, powers))


# -- drives ------------------------------------------------------------------------------------------------------------

AMPLITUDE, PHASE, MEAN = (
    hd.Parameter(name, "rad", x) for name, x in (("amplitude", 0.4), ("phase", 0.3), ("mean", 0.2))
)
SPEED, RISE = hd.Parameter("speed", "rad/s", 2.5), hd.Parameter("rise", "s", 0.8)
SPIN = SPEED * (1 + sp.cos(RATE * hd.T) / 2)


def smooth(s):
    """Way of the quintic rise 10 s^3 - 15 s^4 + 6 s^5, its rate, the rate of that."""
    return 2.5 * s**4 - 3 * s**5 + s**6, 10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 - 60 * s**3 + 30 * s**4


def risen(t, way):
    s = t / 0.8
    return (2.5 * 0.8 * way(s)[0], 2.5 * way(s)[1], 2.5 / 0.8 * way(s)[2]) if t < 0.8 else (2.5 * (t - 0.4), 2.5, 0.0)


DRIVES = {  # drive, then (position, speed, acceleration) by hand of t and the coordinates the drive integrates
    "ramp": (hd.Ramp("drive", "joint", SPEED, RISE), lambda t, _: risen(t, smooth)),
    "straight ramp": (hd.Ramp("drive", "joint", SPEED, RISE, 0), lambda t, _: risen(t, lambda s: (s**2 / 2, s, 1))),
    "harmonic": (
        hd.Harmonic("drive", "joint", AMPLITUDE, RATE, PHASE, MEAN),
        lambda t, _: (0.2 + 0.4 * np.sin(2 * t + 0.3), 0.8 * np.cos(2 * t + 0.3), -1.6 * np.sin(2 * t + 0.3)),
    ),
    "position": (
        hd.Drive("drive", "joint", position=AMPLITUDE * sp.exp(-RATE * hd.T)),
        lambda t, _: (0.4 * np.exp(-2 * t), -0.8 * np.exp(-2 * t), 1.6 * np.exp(-2 * t)),
    ),
    "choice": (
        hd.Drive("drive", "joint", position=sp.Piecewise((AMPLITUDE * (RATE * hd.T) ** 3, hd.T < RISE / 2), (AMPLITUDE, True))),
        lambda t, _: (3.2 * t**3, 9.6 * t**2, 19.2 * t) if t < 0.4 else (0.4, 0, 0),
    ),
    "speed": (
        hd.Drive("drive", "joint", speed=SPIN, start=MEAN),
        lambda t, z: (z[0], 2.5 * (1 + np.cos(2 * t) / 2), -2.5 * np.sin(2 * t)),
    ),
    "acceleration": (
        hd.Drive("drive", "joint", acceleration=SPEED * RATE * sp.cos(RATE * hd.T), start=MEAN, start_speed=SPEED),
        lambda t, z: (z[0], z[1], 5 * np.cos(2 * t)),
    ),
}  # fmt: skip


CHAINS = [driven(random_tree("R+Z R-X R+Y", 12), root, 1.0) for root in (0, 1)]


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("root", [0, 1])
@pytest.mark.parametrize("label", DRIVES)
def test_an_accelerated_drive_moves_the_others_and_is_loaded_as_in_kanes_method(label, root):
    """All joints free in KanesMethod; the driven one's motion put in, its row of M a - forcing is what the drive must supply."""
    tree = CHAINS[root]
    drive, by_hand = DRIVES[label]
    derived = Derived(
        tree.scene().replace(**{f"drive{root}": replace(drive, name=f"drive{root}", joint=f"joint{root}")})
    )
    integrated = [name for name, _ in derived.COORDINATES if name.startswith(f"joint{root}.")]
    rng = np.random.default_rng(3)
    for t, q, u in states(tree):
        z = rng.uniform(-2, 2, len(integrated))
        full_q, full_u, a_d = tree.whole(t, q, False), tree.whole(t, u, True), by_hand(t, z)[2]
        full_q[root], full_u[root] = by_hand(t, z)[:2]
        mass, forcing = tree.mass_and_forcing(full_q, full_u)
        free = tree.free
        a = np.linalg.solve(mass[np.ix_(free, free)], forcing[free] - mass[free, root] * a_d)
        reaction = mass[root, free] @ a + mass[root, root] * a_d - forcing[root]
        options = {"t": t, "q": np.concatenate([q, z]), "u": u}
        ours, reactions = derived.call("accelerations", **options, f=derived.call("applied", **options))
        assert ours == pytest.approx(a, rel=1e-10)
        assert reactions == pytest.approx([reaction], rel=1e-10)
        assert derived.call("ledger", **options, reactions=reactions) == pytest.approx(
            [reaction * full_u[root]], rel=1e-10
        )
        assert imbalance(derived, **options) < 1e-12
        rates = derived.call("coordinate_rates", **options)[len(free) :]
        assert rates == pytest.approx(by_hand(t, z)[1 : 1 + len(integrated)], rel=1e-14)


@pytest.mark.parametrize("label", DRIVES)
def test_a_drive_is_where_its_declaration_says(label):
    tree = CHAINS[0]
    drive, by_hand = DRIVES[label]
    derived = Derived(tree.scene().replace(drive0=replace(drive, name="drive0", joint="joint0")))
    z = np.array([0.7, -0.4])[: len(derived.COORDINATES) - 2]
    for t in (0.0, 0.1, 0.45, 0.79, 0.81, 1.7):
        full = np.array([by_hand(t, z)[0], 0.3, -0.8])
        _, rotations = derived.call("poses", t=t, q=np.concatenate([full[1:], z]))
        assert rotations[:9] == pytest.approx(tree.pose(0, full)[1].reshape(-1), abs=1e-14)


@pytest.mark.parametrize("label", ["ramp", "position", "choice", "speed", "acceleration"])
def test_the_start_of_what_a_drive_integrates_is_declared(label):
    tree = driven(random_tree("R+Z R-X", 12), 0, 1.0)
    derived = Derived(tree.scene().replace(drive0=replace(DRIVES[label][0], name="drive0", joint="joint0")))
    starts = {"speed": [0.2], "acceleration": [0.2, 2.5]}.get(label, [])
    assert derived.start()[0].tolist() == [0.0, *starts]
    assert derived.call("scales", p=derived.p)[0].size == len(derived.COORDINATES)


# -- where there is no direction ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("rest", [None, REST])
def test_springs_and_dampers_are_clean_where_their_ends_meet(rest):
    """Force, power and all their derivatives are numbers; the energy is that of the spring's length, zero."""
    tree = random_tree("P+X P+Y", 3, gravity=0)
    tree = replace(tree, links=tuple(replace(l, on_parent=(0, 0, 0), on_child=(0, 0, 0)) for l in tree.links))
    ends = (tree.bodies[1].at(0, 0, 0), hd.GROUND.at(0, 0, 0))
    derived = Derived(
        tree.scene(hd.PointSpring("spring", *ends, STIFFNESS, rest), hd.PointDamper("damper", *ends, DAMPING))
    )
    options = {"t": 0.0, "q": np.zeros(2), "u": np.array([1.0, 2.0])}
    assert derived.call("applied", **options).tolist() == [0, 0]
    assert derived.call("ledger", **options, reactions=[]).tolist() == [0]
    assert derived.call("energy", **options)[1] == pytest.approx([0.0 if rest is None else 20 * 0.36])
    for which in "qu":
        assert np.all(np.isfinite(derived.jacobian("applied", which, **options)))
    assert isinstance(derived.results("applied", options)[0], ca.DM)


# -- joints of several freedoms ----------------------------------------------------------------------------------------


def column(*effects):
    """A cylindrical joint from the ground, a spherical one on it, and a free body beside them."""
    inertia = tuple(hd.Parameter(f"J{k}", "kg m^2", value) for k, value in zip("xyz", (0.2, 0.3, 0.25), strict=True))
    post, arm, stone = (
        hd.Body(name, hd.Parameter(f"{name}_mass", "kg", mass), inertia)
        for name, mass in (("post", 2), ("arm", 1), ("stone", 3))
    )
    joints = (
        hd.Cylindrical("column", hd.GROUND, post, axis=hd.Z),
        hd.Spherical("shoulder", post.at(*place("s", ONE)), arm.at(*place("h", TWO))),
        hd.Free("flight", hd.GROUND, stone),
    )
    size = hd.Parameter("size", "m", 1.0)
    scales = hd.Scales(length=size, speed=hd.Parameter("pace", "m/s", 1.0), arm=size)
    made = [effect(post, arm, stone) for effect in effects]
    gravity = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y)
    return hd.Scene(hd.Mechanism("column", joints), (*made, gravity, hd.EnergyLedger()), scales)


TRAVEL = hd.coordinate_of("column.travel")
SEVERAL = {
    "spring of one of two coordinates": lambda *_: hd.JointSpring("x", "column.angle", TORQUE),
    "damper of the other": lambda *_: hd.JointDamper("x", "column.travel", DAMPING),
    "drive of one of two": lambda *_: hd.Harmonic("x", "column.angle", AMPLITUDE, RATE),
    "drive of the other, integrated": lambda *_: hd.Drive("x", "column.travel", speed=REST * RATE * sp.cos(RATE * hd.T)),
    "potential of both": lambda *_: hd.Potential("x", STIFFNESS * (sp.Max(TRAVEL, 0)**2 - sp.Min(TRAVEL, 0)**3 / REST)
    * sp.cos(hd.coordinate_of("column.angle"))),
    "spring between ball and free body": lambda post, arm, stone: hd.PointSpring("x", arm.at(*place("one", ONE)), stone.at(0, 0, 0), STIFFNESS, REST),
    "damper between ball and free body": lambda post, arm, stone: hd.PointDamper("x", arm.at(*place("one", ONE)), stone.at(*place("two",
    TWO)), DAMPING),
    "force on a free body": lambda post, arm, stone: hd.PointForce("x", stone.at(*place("two", TWO)), (FORCE, 0,
    FORCE * sp.cos(RATE * hd.T)), axes=arm),
    "torque on a free body": lambda post, arm, stone: hd.BodyTorque("x", stone, (0, TORQUE, TORQUE), axes=stone),
    "torque on a ball": lambda post, arm, stone: hd.BodyTorque("x", arm, (TORQUE, 0, TORQUE)),
}  # fmt: skip


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("label", SEVERAL)
def test_power_is_balanced_on_joints_of_several_freedoms(label):
    derived = Derived(column(SEVERAL[label]))
    rng = np.random.default_rng(2)
    names = [name for name, _ in derived.COORDINATES]
    for t in rng.uniform(0, 1, 3):
        q, u = rng.uniform(-1, 1, len(names)), rng.uniform(-2, 2, derived.nu)
        for first in (i for i, name in enumerate(names) if name.endswith(".q0")):
            q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
        assert imbalance(derived, t, q, u) < 1e-11


def test_a_ball_has_no_single_coordinate():
    for effect in (
        hd.JointSpring("x", "shoulder", TORQUE), hd.JointDamper("x", "column", DAMPING), hd.Harmonic("x", "flight", AMPLITUDE, RATE),
    ):  # fmt: skip
        with pytest.raises(hd.InputError) as caught:
            column(lambda *_, effect=effect: effect)
        assert "which has not just one coordinate" in caught.value.faults[0].found
        assert "column.travel, column.angle" in caught.value.faults[0].expected
