"""Spheres on boxes, bounded faces, edges and cylinders: distances by brute force, forces by virtual work, rolling off an edge."""

import itertools
from dataclasses import replace

import numpy as np
import pytest
from derived import Derived
from scipy.optimize import minimize

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

R, A, B, C, BIG = (
    hd.Parameter(name, "mm", value) for name, value in (("r", 20), ("a", 100), ("b", 60), ("c", 40), ("R", 30))
)
r, a, b, c, big = (p.si for p in (R, A, B, C, BIG))
K = hd.Parameter("K", "N/m^1.5", 1e8)
SIZES = hd.Scales(length=R, speed=hd.Parameter("pace", "m/s", 1), arm=R)
STEP, PACE = hd.Parameter("step", "mm", 5), hd.Parameter("v_in", "m/s", 2)
SKEW = hd.Direction((1, 2, 2))


def tri(name):
    return (hd.Parameter(f"J_{name}", "kg m^2", 1e-3),) * 3


BALL, BLOCK = (
    hd.Body("ball", hd.Parameter("m", "kg", 0.5), tri("ball")),
    hd.Body("block", hd.Parameter("m_block", "kg", 2), tri("block")),
)
PLACE = BLOCK.at(A / 2, B / 3, -C).turned(SKEW, hd.Parameter("turn", "rad", 0.7))
PAIRS = {
    "box": hd.SphereOnBox("touch", BALL.at(0, 0, 0), R, PLACE, A, B, C),
    "face": hd.SphereOnFace("touch", BALL.at(0, 0, 0), R, PLACE, hd.Z, hd.Y, A, B),
    "edge": hd.SphereOnEdge("touch", BALL.at(0, 0, 0), R, PLACE, SKEW, A),
    "cylinder": hd.SphereOnCylinder("touch", BALL.at(0, 0, 0), R, PLACE, BIG, hd.X, A),
    "endless edge": hd.SphereOnEdge("touch", BALL.at(0, 0, 0), R, PLACE, SKEW),
    "endless cylinder": hd.SphereOnCylinder("touch", BALL.at(0, 0, 0), R, PLACE, BIG, hd.X),
}
FAR = 1.0  # half of what has no end


def boxed(half):
    """Points of a box by three numbers in [-1, 1]."""
    return lambda s: np.array(half) * s


def along(axis):
    axis = np.array(axis, float) / np.linalg.norm(axis)
    return lambda half: lambda s: axis * half * s[0]


def rounded(half):
    """Points of a cylinder about x: way, turn, share of the radius."""
    return lambda s: np.array([half * s[0], big * s[2] * np.cos(np.pi * s[1]), big * s[2] * np.sin(np.pi * s[1])])


POINTS = {
    "box": boxed((a / 2, b / 2, c / 2)), "face": boxed((b / 2, a / 2, 0)), "edge": along((1, 2, 2))(a / 2), "cylinder": rounded(a / 2),
    "endless edge": along((1, 2, 2))(FAR), "endless cylinder": rounded(FAR),
}  # fmt: skip


def turned(axis, angle):
    """Rodrigues."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    tilde = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * tilde + (1 - np.cos(angle)) * tilde @ tilde


@pytest.fixture(scope="module", params=PAIRS)
def tried(request):
    """Name and scene of a pair, with states of ball and block at random, the centre of the ball outside the solid and near."""
    joints = hd.Free("flight", hd.GROUND, BALL), hd.Free("drift", hd.GROUND, BLOCK)
    law = hd.Contact("touch", hd.laws.power(K, 1.5))
    mechanism = hd.Mechanism("tried", joints, (PAIRS[request.param],))
    derived = Derived(hd.Scene(mechanism, (law, hd.EnergyLedger()), SIZES))
    rng, found = np.random.default_rng(3), []
    while len(found) < 14:
        turn = rng.normal(size=4)
        local = rng.uniform(-1, 1, 3) * 1.8 * np.array([a, b, c]) / 2 + rng.normal(size=3) * 0.2 * r
        block = np.concatenate([rng.normal(size=3) * 0.1, turn / np.linalg.norm(turn)])
        w, x, y, z = block[3:]
        pose = turned((x, y, z), 2 * np.arctan2(np.linalg.norm((x, y, z)), w)) @ turned((1, 2, 2), 0.7)
        centre = block[:3] + pose @ turned((1, 2, 2), -0.7) @ np.array([a / 2, b / 3, -c]) + pose @ local
        q = np.concatenate([centre, [1, 0, 0, 0], block])
        (gap,) = derived.call("outputs", t=0.0, q=q, u=np.zeros(12))[-1:]
        if gap > -0.9 * r:
            found.append((q, local, gap))
    return request.param, derived, found


def nearest(name, centre):
    """Distance of a centre from a solid by minimisation from many starts."""
    starts = itertools.product((0.1,), (-0.6, 0.1, 0.7) if "cylinder" in name else (0.1,), (0.6,))
    found = [
        minimize(lambda s: np.sum((POINTS[name](s) - centre) ** 2) / r**2, start, bounds=[(-1, 1)] * 3, tol=1e-16)
        for start in starts
    ]
    return np.sqrt(min(result.fun for result in found)) * r


@pytest.mark.by_turns(3)
def test_the_gap_is_the_shortest_distance_minus_the_radius(tried):
    name, _, states = tried
    for _, local, gap in states[:3]:
        assert gap == pytest.approx(nearest(name, local) - r, abs=2e-6 * r)


def test_forces_do_the_work_of_the_penetration_and_have_derivatives_everywhere(tried):
    # Power on both bodies in contact is minus force times the rate of the exact gap, turning included.
    _, derived, states = tried
    rng, touching = np.random.default_rng(5), 0
    for q, _, near in states:
        if near > -1e-3 * r:
            continue
        touching += 1
        u = rng.normal(size=12)
        rates, step = derived.call("coordinate_rates", t=0.0, q=q, u=u), 1e-7

        def gap(time, q=q, rates=rates):
            moved = q + time * rates
            return derived.call("outputs", t=0.0, q=moved, u=np.zeros(12))[-1]

        rate = (gap(step) - gap(-step)) / (2 * step)
        force, _, (normal,), *_ = derived.call("contact_touch", t=0.0, q=q, u=u, m=[])
        assert normal > 0
        assert force @ u == pytest.approx(normal * rate, rel=2e-6, abs=1e-6 * normal)
    assert touching > 1
    for q, *_ in states[:6]:
        for which in ("q", "u"):
            assert np.all(np.isfinite(derived.jacobian("gaps", which, result=1, t=0.0, q=q, u=np.ones(12))))
            assert np.all(np.isfinite(derived.jacobian("contact_touch", which, t=0.0, q=q, u=np.ones(12), m=[])))


def rolling(pair, coordinates="tree", speed=0.0, start=0.0, gravity=9.81, law=None):
    """A ball without friction on a pair fixed in the ground, in the plane, put on it at a place x."""
    cart = hd.Body("cart", 0)
    joints = hd.Prismatic("way", hd.GROUND, cart, axis=hd.X), hd.Prismatic("height", cart, BALL, axis=hd.Y)
    effects = (
        hd.Gravity("gravity", hd.Parameter("g", "m/s^2", gravity), -hd.Y),
        law or hd.Contact("touch", hd.laws.power(hd.Parameter("K_1", "N/m", 1e7), 1)),
        hd.EnergyLedger(),
    )
    at = {"way": hd.Parameter("x_0", "m", start), "height": hd.Parameter("y_0", "m", r - 0.5 * gravity / 1e7)}
    return hd.Scene(
        hd.Mechanism("rolling", joints, (pair,)), effects, SIZES,
        hd.Start(position=at, speed={"way": hd.Parameter("v_0", "m/s", speed)}), coordinates=coordinates,
    )  # fmt: skip


TABLE = hd.GROUND.at(-A / 2, -C / 2, 0)  # its right edge is the origin
OVER = {
    "box": hd.SphereOnBox("touch", BALL.at(0, 0, 0), R, TABLE, A, C, B),
    "face": hd.SphereOnFace("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(-A / 2, 0, 0), hd.Y, hd.X, A, B),
    "rim": hd.SphereOnCylinder("touch", BALL.at(0, 0, 0), R, TABLE, A / 2, hd.Y, C),
}


@pytest.mark.parametrize(
    ("solid", "coordinates"), [("box", "tree"), ("box", "absolute"), ("face", "tree"), ("rim", "absolute")]
)
def test_a_ball_leaves_the_edge_of_a_table_where_its_weight_no_longer_holds_it(solid, coordinates):
    """It slides over the face, then about the edge, which it leaves at cos = 2/3 + v^2/(3 g r), within weight/stiffness."""
    speed, gravity = 0.1, 9.81
    run = simulate(load(rolling(OVER[solid], coordinates, speed, start=-0.3 * r)), duration="0.3 s", accuracy=1e-7)
    assert run.outcome.name == "finished"
    assert abs(run.energy_residual) < 1e-6
    cosine = 2 / 3 + speed**2 / (3 * gravity * r)
    leaving = np.sqrt(gravity * r) * cosine**1.5  # the speed across stays in flight
    before, after = run.at(np.array([0.28, 0.3]))["way.travel"]
    assert (after - before) / 0.02 == pytest.approx(leaving, rel=2e-3)


def inside(pair, half):
    """A ball with its centre at points within a solid fixed in the ground: depth and outward normal by the derivation."""
    law = hd.Contact("touch", hd.laws.power(hd.Parameter("K_1", "N/m", 1), 1))
    derived = Derived(
        hd.Scene(
            hd.Mechanism("within", (hd.Free("flight", hd.GROUND, BALL),), (pair,)), (law, hd.EnergyLedger()), SIZES
        )
    )
    rng = np.random.default_rng(8)
    for centre in rng.uniform(-0.999, 0.999, (20, 3)) * half:
        q = np.array([*centre, 1, 0, 0, 0])
        gap = derived.call("outputs", t=0.0, q=q, u=np.zeros(6))[-1]
        force, _, (normal,), *_ = derived.call("contact_touch", t=0.0, q=q, u=np.zeros(6), m=[])
        slope = derived.jacobian("outputs", "q", t=0.0, q=q, u=np.zeros(6))[-1][:3]
        yield centre, -gap - r, force[:3] / normal, slope


def test_a_centre_within_a_box_is_pushed_out_through_the_nearest_face():
    half = np.array([a, b, c]) / 2
    for centre, depth, push, slope in inside(
        hd.SphereOnBox("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(0, 0, 0), A, B, C), half
    ):
        below = half - np.abs(centre)
        nearest_face = np.argmin(below)
        assert depth == pytest.approx(below[nearest_face], rel=1e-9)
        assert push == pytest.approx(np.sign(centre) * (np.arange(3) == nearest_face), abs=1e-9)
        assert slope == pytest.approx(push, abs=1e-9)


@pytest.mark.parametrize("length", [A, None])
def test_a_centre_within_a_cylinder_is_pushed_out_through_its_side_or_end(length):
    pair = hd.SphereOnCylinder("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(0, 0, 0), BIG, hd.X, length)
    inner = 0.7 * big
    for centre, depth, push, slope in inside(pair, np.array([a / 2, inner, inner])):
        aside = np.hypot(*centre[1:])
        ways = [(big - aside, [0, *centre[1:] / aside])]
        if length is not None:
            ways.append((a / 2 - abs(centre[0]), [np.sign(centre[0]), 0, 0]))
        least, out = min(ways, key=lambda way: way[0])
        assert depth == pytest.approx(least, rel=1e-9)
        assert push == pytest.approx(out, abs=1e-9)
        assert slope == pytest.approx(push, abs=1e-9)


@pytest.mark.parametrize("solid", ["box", "rim"])
def test_a_ball_shot_into_a_soft_solid_comes_back_as_fast(solid):
    """It turns deeper than its radius, at v sqrt(m/K); in the plane of motion no face beside it is a way out."""
    law = hd.Contact("touch", hd.laws.power(hd.Parameter("K_1", "N/m", 2000), 1))
    pair = {
        "box": hd.SphereOnBox("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(-A / 2, -A, 0), A, 2 * A, R),
        "rim": hd.SphereOnCylinder("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(-A / 2, -A, 0), A, hd.Y, 2 * A),
    }[solid]
    scene = rolling(pair, start=-a / 2, law=law)
    speed, m = 2.0, 0.5
    scene = replace(scene.without("gravity"), start=hd.Start({"way": -A / 2, "height": R + STEP}, {"height": -PACE}))
    run = simulate(load(scene), duration="0.1 s", accuracy=1e-8)
    assert run.impacts[0].peak_penetration == pytest.approx(speed * np.sqrt(m / 2000), rel=1e-7)
    assert run.impacts[0].peak_penetration > 1.5 * r
    assert run.engine.final["height.speed"] == pytest.approx(speed, rel=1e-7)


def test_gap_and_force_go_on_from_face_to_edge_to_corner():
    """Along a way over a corner, force and slope of the gap change by no more than the step."""
    pair = hd.SphereOnBox("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(-A / 2, -B / 2, -C / 2), A, B, C)
    law = hd.Contact("touch", hd.laws.power(K, 1.5))
    derived = Derived(
        hd.Scene(
            hd.Mechanism("corner", (hd.Free("flight", hd.GROUND, BALL),), (pair,)), (law, hd.EnergyLedger()), SIZES
        )
    )
    ways = np.linspace(-0.5, 0.3, 321)
    forces, slopes = [], []
    for way in ways:
        q = np.array([way * r + 1e-5, 0.7 * way * r, 0.9 * r, 1, 0, 0, 0])
        forces.append(derived.call("contact_touch", t=0.0, q=q, u=np.zeros(6), m=[])[0][:3])
        slopes.append(derived.jacobian("gaps", "q", 0, t=0.0, q=q, u=np.zeros(6))[0][:3])
    forces, slopes = np.array(forces), np.array(slopes)
    assert np.max(np.abs(np.diff(forces, axis=0))) < 0.02 * np.max(np.abs(forces))
    assert np.max(np.abs(np.diff(slopes, axis=0))) < 0.01
    assert forces[0] == pytest.approx([0, 0, 1e8 * (0.1 * r) ** 1.5], rel=1e-9)  # once on the face
    assert np.all(forces[-1] > 0.005 * forces[0][2])


def test_a_face_needs_a_direction_square_to_its_normal():
    slanted = hd.SphereOnFace("touch", BALL.at(0, 0, 0), R, hd.GROUND.at(0, 0, 0), hd.Y, hd.Direction((1, 1, 0)), A, B)
    with pytest.raises(hd.InputError, match=r"pair touch, along: found a direction at a cosine of 0\.707"):
        rolling(slanted)
