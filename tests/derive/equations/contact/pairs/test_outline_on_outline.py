"""Two outlines that may touch: against very many points, closed forms, a journal, a Geneva lock."""

import casadi as ca
import numpy as np
import pytest
from derived import Derived
from matplotlib.path import Path
from plane_pairs import BLOCK, CAM, FREE, PLATE, SHAFT, L, check_gradient, gaps, scene
from scipy.spatial import cKDTree

import hertzwerk.derive as hd
from hertzwerk.derive.scenes.geneva_drive import scene as geneva_drive
from hertzwerk.runtime import equilibrium, load

R, E, C = (hd.Parameter(name, "mm", value) for name, value in (("R_half", 15), ("e_stone", 6), ("c", 0.5)))
CONTACT = hd.Contact("touch", hd.laws.power(hd.Parameter("K", "N/m", 1e6), 1))
STONE = hd.Outline("stone", (-E, -E), [hd.Line((E, -E)), hd.Arc((E, E), (E, 0)), hd.Line((-E, E)), hd.Line((-E, -E))])
TURN = np.linspace(-np.pi / 2, np.pi / 2, 2001)
RIMS = {
    "block": [(0, -15), *np.transpose([40 + 15 * np.cos(TURN), 15 * np.sin(TURN)]),
              *np.transpose([20 - 7.5 * np.sin(TURN), 15 - 7.5 * np.cos(TURN)]), (0, 15), (7.5, 0), (0, -15)],
    "stone": [(-6, -6), *np.transpose([6 + 6 * np.cos(TURN), 6 * np.sin(TURN)]), (-6, 6), (-6, -6)],
}  # fmt: skip


def touching(first, second):
    return scene(hd.CurveOnCurve("touch", first, PLATE.at(0, 0, 0), second, CAM.at(0, 0, 0)))


@pytest.fixture(scope="module")
def stones():
    return Derived(touching(STONE, BLOCK))


def rim(name, angle, x, y):
    """Points of an outline, a tenth of a millimetre apart."""
    corners, c, s = 1e-3 * np.array(RIMS[name]), np.cos(angle), np.sin(angle)
    ways = np.hypot(*np.diff(corners.T))
    along = np.concatenate([[0], np.cumsum(ways)])
    at = np.union1d(along, np.arange(0, along[-1], 1e-4))
    return np.transpose([np.interp(at, along, v) for v in corners.T]) @ [[c, s], [-s, c]] + [x, y]


def test_outlines_are_as_far_as_the_nearest_of_very_many_points(stones):
    random, apart, within = np.random.default_rng(1), 0, 0
    for _ in range(60):
        q = random.uniform(-1, 1, 4) * (3, 0.07, 0.07, 3)
        one, two = rim("stone", q[3], q[1], q[2]), rim("block", q[0], 0, 0)
        gap = gaps(stones, q)[0]
        if Path(two[::9]).contains_points(one[::9]).any() or Path(one[::9]).contains_points(two[::9]).any():
            within += 1
            assert gap < 1e-7
            continue
        apart += 1
        least = cKDTree(two).query(one)[0].min()
        assert gap == pytest.approx(least, abs=1e-7 + 5e-9 / least)
    assert apart > 30 and within > 3


def test_rates_are_those_of_differences(stones):
    random, h = np.random.default_rng(2), 1e-6
    for _ in range(40):
        q, u, a = (random.uniform(-1, 1, 4) * (3, 0.07, 0.07, 3) for _ in range(3))
        _, dG, ddG = gaps(stones, q, u, a)
        after, before = (gaps(stones, q + way * u + way**2 / 2 * a, u + way * a) for way in (h, -h))
        assert dG == pytest.approx((after[0] - before[0]) / (2 * h), rel=1e-6, abs=1e-7)
        assert ddG == pytest.approx((after[1] - before[1]) / (2 * h), rel=1e-5, abs=1e-4)


@pytest.mark.parametrize(
    ("x", "y", "angle", "gap", "normal"),
    [
        pytest.param(66.5, 0, np.pi, -0.5, (1, 0), id="arc on arc"),
        pytest.param(30, -20.5, np.pi, -0.5, (0, -1), id="line on line"),
        pytest.param(20, -14.7 - 6 * np.sqrt(2), -3 * np.pi / 4, -0.3, (0, -1), id="corner on line"),
        pytest.param(-9, 25, np.pi, 5, (-0.6, 0.8), id="corner on corner"),
        pytest.param(21.08, 19.56, -np.pi / 2, -0.3, (-0.6, 0.8), id="arc in hollow"),
    ],
)
def test_each_kind_of_place_equals_its_closed_form(stones, x, y, angle, gap, normal):
    """Of the gap, and of its rate as the stone moves and turns."""
    v = np.array([0.3, -0.7])
    actual = gaps(stones, (0, 1e-3 * x, 1e-3 * y, angle), (0, *v, 0))
    assert actual[:2] == pytest.approx((1e-3 * gap, np.dot(normal, v)), rel=1e-11)


def test_a_disc_in_a_ring_is_a_journal():
    """Gap c - e, its rate and second derivative, wherever either has its seam."""
    disc = hd.Outline("disc", (R - C, 0), [hd.Arc((R - C, 0), (0, 0))])
    ring = hd.Outline("ring", (0, R), [hd.Arc((0, R), (0, 0))], hole=True)
    derived, random, t = Derived(touching(disc, ring)), np.random.default_rng(3), ca.SX.sym("t")
    for _ in range(30):
        q, u, a = (random.uniform(-1, 1, 4) * (3, 6e-4, 6e-4, 3) for _ in range(3))
        way = ca.DM(q) + t * ca.DM(u) + t**2 / 2 * ca.DM(a)
        closed = 5e-4 - ca.norm_2(way[1:3])
        rate = ca.jacobian(closed, t)
        expected = ca.Function("expected", [t], [closed, rate, ca.jacobian(rate, t)])(0)
        assert gaps(derived, q, u, a) == pytest.approx(np.array(expected).ravel(), rel=1e-8, abs=1e-11)


def test_forces_are_minus_the_gradient_of_the_stored_energy(stones):
    random, states = np.random.default_rng(4), []
    while len(states) < 8:
        q = random.uniform(-1, 1, 4) * (3, 0.07, 0.07, 3)
        if -2e-3 < gaps(stones, q)[0] < -1e-5:
            states.append(q)
    check_gradient(stones, states, h=1e-7, rtol=1e-5, atol=1e-2)


def test_a_thin_bow_is_not_entered_from_behind():
    """A stone in the hollow of a bow half a millimetre thick: its corner or arc is as far from the inside as it is."""
    bow = [hd.Arc((-L, 0), (0, -E)), hd.Line((-L, -C)), hd.Arc((L, -C), (0, -E - C), clockwise=True), hd.Line((L, 0))]
    derived = Derived(touching(STONE, hd.Outline("bow", (L, 0), bow)))
    for y in (0.0, 0.02, 0.0273):
        reach = max(np.hypot(0.006, 0.006 + y + 0.0065), np.hypot(0.006, y + 0.0065) + 0.006)
        assert gaps(derived, (0, 0, y, np.pi))[0] == pytest.approx(np.hypot(0.04, 0.006) - reach, abs=1e-12)


# -- several places ------------------------------------------------------------------------------------------------------


def test_each_corner_of_a_box_carries_its_share():
    """A box on a bench, pushed off its middle: by the lever's law."""
    g = hd.Parameter("g", "m/s^2", 9.81)
    box = hd.Outline("box", (-L, -R), [hd.Line((L, -R)), hd.Line((L, R)), hd.Line((-L, R)), hd.Line((-L, -R))])
    bench = hd.Outline(
        "bench", (-4 * L, -R), [hd.Line((4 * L, -R)), hd.Line((4 * L, 0)), hd.Line((-4 * L, 0)), hd.Line((-4 * L, -R))]
    )
    pair = hd.OutlineOnOutline("touch", box, PLATE.at(0, 0, 0), bench, hd.GROUND.at(0, 0, 0))
    at, pushed = hd.Parameter("at", "mm", 15), hd.Parameter("pushed", "N", 3)
    hold, push = (
        hd.JointSpring("hold", "free.x", hd.Parameter("k", "N/m", 1)),
        hd.PointForce("push", PLATE.at(at, 0, 0), (0, -pushed, 0)),
    )
    effects = hd.Gravity("gravity", g, direction=-hd.Y), CONTACT, push, hold, hd.EnergyLedger()
    start = hd.Start(position={"free.y": R})
    declared = hd.Scene(
        hd.Mechanism("bench", (FREE,), (pair,)), effects, hd.Scales(C, hd.Parameter("v", "m/s", 1), arm=L), start
    )
    model = load(declared)
    assert model.pairs == tuple(f"touch_{k}" for k in range(1, 9))
    rest = equilibrium(model)
    left, right = (rest.contacts[f"touch_{k}"] for k in (1, 2))
    weight = 0.2 * 9.81
    assert (left + right, (right - left) * 0.04) == pytest.approx((weight + 3, 3 * 0.015), rel=1e-4)
    assert not any(rest.contacts.get(f"touch_{k}", 0) for k in range(3, 9))


# -- a Geneva wheel's lock -----------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def geneva():
    return Derived(geneva_drive)


@pytest.mark.parametrize("crank", [90, 180, 250])
def test_the_tips_of_a_locked_hollow_leave_the_free_play_of_a_triangle(geneva, crank):
    """Between the axes, the wheel's rim and the disc's radius: cos(b) = (D^2 + r^2 - R^2)/(2 D r), to both sides."""
    D, r, disc, hollow = 0.06, 0.0435, 0.03 - 1e-5, 0.03

    def tip(radius):
        return np.arccos((D**2 + r**2 - radius**2) / (2 * D * r))

    free, t = tip(hollow) - tip(disc), np.radians(crank + 60) / (4 * np.pi)
    assert np.degrees(free) == pytest.approx(0.01385, rel=1e-3)
    for side in (1, -1):
        for share in (0.5, 1, 1.01):
            angle = np.pi / 4 + side * share * free
            gap = np.sqrt(D**2 + r**2 - 2 * D * r * np.cos(tip(hollow) - share * free)) - disc
            actual = geneva.call("gaps", t=t, q=np.array([angle]), u=np.zeros(1))[0][1]
            assert actual == pytest.approx(gap, abs=1e-14)
            assert (actual > -1e-16) == (share <= 1)


@pytest.mark.parametrize("crank", [-60, -50, 47, 60])
def test_beside_its_recess_the_edge_of_the_disc_locks_the_wheel(geneva, crank):
    """It meets the hollow itself: the triangle of the axes' distance, the edge's from the axle, and the hollow's radius."""
    D, disc, hollow = 0.06, 0.03 - 1e-5, 0.03
    side = np.sign(crank)
    edge = np.radians(crank) - side * np.pi / 4
    x, y = D - disc * np.cos(edge), disc * np.sin(edge)  # from the axle, towards the crank
    rho = np.hypot(x, y)
    turned = np.arccos((rho**2 + D**2 - hollow**2) / (2 * rho * D)) - abs(np.arctan2(y, x))
    assert turned > 1e-5
    for share in (0.5, 1):
        apart = np.sqrt(rho**2 + D**2 - 2 * rho * D * np.cos(abs(np.arctan2(y, x)) + share * turned))
        actual = geneva.call(
            "gaps", t=np.radians(crank + 60) / (4 * np.pi), q=np.array([np.pi / 4 + side * share * turned]), u=np.zeros(1),
        )[0][1]  # fmt: skip
        assert actual == pytest.approx(hollow - apart, abs=1e-14)


def test_an_edge_of_the_disc_passes_a_tip_that_is_pressed_in_without_a_jump_of_the_gap(geneva):
    """The tip comes in through the recess, from where it is no deeper; 1.3 m/s at most between two times."""
    step, angle = 5e-8, np.array([-np.pi / 4 + 2.511e-4])
    times = 5 * 0.0412712 + np.arange(-50, 51) * step
    gaps = [geneva.call("gaps", t=t, q=angle, u=np.zeros(1))[0][1] for t in times]
    assert min(gaps) < -3.8e-7
    assert np.abs(np.diff(gaps)).max() < 1.3 * 4 * np.pi * 0.03 * step


def test_all_faults_come_at_once():
    ring, clock = (
        hd.Outline("ring", (R, 0), [hd.Arc((R, 0), (0, 0))], hole=True),
        hd.Outline("clock", (0, 0), [hd.Line((0, L)), hd.Line((L, 0)), hd.Line((0, 0))]),
    )
    pairs = (
        hd.OutlineOnOutline("text", "ring", PLATE.at(0, 0, 0), STONE, CAM.at(0, 0, 0)),
        hd.OutlineOnOutline("holes", ring, PLATE.at(0, 0, 0), ring, CAM.at(0, 0, 0)),
        hd.OutlineOnOutline("backwards", clock, PLATE.at(0, 0, 0), STONE, CAM.at(0, 0, 0)),
    )
    with pytest.raises(hd.InputError) as error:
        hd.Scene(hd.Mechanism("faulty", (SHAFT, FREE), pairs), (), hd.Scales(R, hd.Parameter("pace", "m/s", 1), R))
    for text in (
        "pair text, first outline: found 'ring'; expected an Outline",
        "pair holes, curves: found two holes",
        "curve clock: found a closed chain that runs clockwise",
    ):
        assert text in str(error.value), text
