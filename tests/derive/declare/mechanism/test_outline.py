"""Chains of arcs and lines: each piece and corner by its closed form, brute force, a corner hit, a track, a Geneva drive, faults."""

from itertools import pairwise

import numpy as np
import pytest
from derived import Derived
from matplotlib.path import Path
from plane_pairs import BLOCK, CAM, FREE, PLATE, SHAFT, L, gaps, scene

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

R, ROLLER = (hd.Parameter(name, "mm", value) for name, value in (("R_half", 15), ("roller", 5)))
PACE = hd.Parameter("pace", "m/s", 2)
SCALES = hd.Scales(length=R, speed=PACE, arm=R)
HALF = np.linspace(0, np.pi, 4001)
RIM = 1e-3 * np.concatenate([
    [(0, -15)],
    np.transpose([40 + 15 * np.sin(HALF), -15 * np.cos(HALF)]),
    np.transpose([20 + 7.5 * np.cos(HALF), 15 - 7.5 * np.sin(HALF)]),
    [(0, 15), (7.5, 0), (0, -15)],
])  # fmt: skip


@pytest.fixture(scope="module")
def beside():
    return Derived(scene(hd.PointOnCurve("touch", PLATE.at(0, 0, 0), BLOCK, CAM.at(0, 0, 0))))


def turned(angle, x, y):
    return np.array([np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y])


@pytest.mark.parametrize(
    ("at", "centre", "sign", "least"),
    [
        pytest.param((20, -21), None, 1, 6, id="beside a line"), pytest.param((20, -12), None, 1, -3, id="within, below a line"),
        pytest.param((46, 8), (40, 0), 1, -15, id="within an arc to the left"),
        pytest.param((58, -9), (40, 0), 1, -15, id="beside an arc to the left"), pytest.param((21, 13), (20, 15), -1, 7.5, id="in a hollow"),
        pytest.param((18, 6.5), (20, 15), -1, 7.5, id="below a hollow"), pytest.param((-3, 19), (0, 15), 1, 0, id="beside a corner"),
        pytest.param((28, 17), None, 1, 2, id="above a line"), pytest.param((9.5, 1), (7.5, 0), -1, 0, id="within, beside the corner of a notch"),
    ],
)  # fmt: skip
def test_each_piece_and_corner_equals_its_closed_form(beside, at, centre, sign, least):
    """Of a circle: distance of its centre, and v_t^2 over it, at a block that is turned; of a line, its height and no curvature."""
    (x, y), angle, v = 1e-3 * np.array(at), 0.7, np.array([0.4, -1.1])
    if centre is None:
        n = np.array([0, np.sign(y)])
        expected = 1e-3 * least, n @ v, 0
    else:
        w = np.array([x, y]) - 1e-3 * np.array(centre)
        away = np.hypot(*w)
        n = w / away
        expected = (
            sign * (away if not least else away + sign * 1e-3 * least), sign * n @ v, sign * (v @ [-n[1], n[0]]) ** 2 / away,
        )  # fmt: skip
    actual = gaps(beside, (angle, *turned(angle, x, y), 0), (0, *turned(angle, *v), 0))
    assert actual == pytest.approx(expected, rel=1e-12, abs=1e-11)


def test_it_is_as_far_as_the_nearest_of_very_many_points(beside):
    """Signs by counting crossings of a ray; the points miss the hollow's and the half circle's rims by 1e-9 m."""
    rim, random = Path(RIM), np.random.default_rng(4)
    lines = [(a, b) for a, b in pairwise(RIM)]
    a, way = np.array([a for a, _ in lines]), np.array([b - a for a, b in lines])
    long = np.sum(way**2, axis=1)
    inside = 0
    for p in random.uniform((-0.02, -0.03), (0.07, 0.03), (150, 2)):
        share = np.clip(np.sum((p - a) * way, axis=1) / np.where(long > 0, long, 1), 0, 1)[:, None]
        apart = np.min(np.hypot(*(a + share * way - p).T))
        within = rim.contains_point(p)
        inside += within
        assert gaps(beside, (0, *p, 0))[0] == pytest.approx(-apart if within else apart, abs=2e-8)
    assert 20 < inside < 120


def test_a_face_touches_the_hull():
    """At random angles against all points; its rates against differences."""
    derived = Derived(scene(hd.FaceOnCurve("touch", PLATE.at(0, 0, 0), -hd.Y, BLOCK, CAM.at(0, 0, 0))))
    random, h = np.random.default_rng(5), 1e-6
    for _ in range(40):
        q, u = random.uniform(-1, 1, 4) * (3, 0.1, 0.1, 3), random.uniform(-1, 1, 4)
        down = np.array([np.sin(q[3]), -np.cos(q[3])])
        least = np.min((turned(q[0], *RIM.T).T - q[1:3]) @ down)
        G, dG, ddG = gaps(derived, q, u)
        assert pytest.approx(least, abs=2e-8) == G
        after, before = (gaps(derived, q + way * u, u) for way in (h, -h))
        assert dG == pytest.approx((after[0] - before[0]) / (2 * h), abs=1e-6)
        assert ddG == pytest.approx((after[1] - before[1]) / (2 * h), abs=1e-6)


def test_a_roller_that_hits_a_corner_leaves_along_the_line_to_it():
    """Without loss: v - 2 (v . n) n, with n from the corner to the centre where they meet."""
    corner = hd.Outline("corner", (0, -L), [hd.Line((0, 0)), hd.Line((-L, 0))], closed=False)
    pair = hd.CircleOnCurve("touch", PLATE.at(0, 0, 0), ROLLER, corner, hd.GROUND.at(0, 0, 0))
    effects = hd.Contact("touch", hd.laws.power(hd.Parameter("K", "N/m", 1e12), 1)), hd.EnergyLedger()
    start = hd.Start(position={"free.x": 3 * ROLLER / 5, "free.y": ROLLER}, speed={"free.x": 0, "free.y": -PACE})
    run = simulate(
        load(hd.Scene(hd.Mechanism("drop", (FREE,), (pair,)), effects, SCALES, start)), duration="2 ms", accuracy=1e-8
    )
    assert run.outcome.name == "finished"
    v, n = np.array([0, -2.0]), np.array([0.6, 0.8])
    after = np.array([run["free.x_speed"][-1], run["free.y_speed"][-1]])
    assert after == pytest.approx(v - 2 * (v @ n) * n, rel=5e-3)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(
    ("x", "y", "pace"), [(0.02, -1, 2), (0.01, 1, 2), (0.03, 1, -2)], ids=["below", "above", "clockwise"]
)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_bead_round_a_stadium_is_pressed_on_its_arcs_alone(coordinates, x, y, pace):
    """m v^2/R there, nothing on the lines; once round after the perimeter over v. Steps end where arcs meet lines."""
    stadium = hd.Outline(
        "stadium", (0, -R), [hd.Line((L, -R)), hd.Arc((L, R), (L, 0)), hd.Line((0, R)), hd.Arc((0, -R), (0, 0))]
    )
    at, v = hd.Parameter("at", "m", x), hd.Parameter("v", "m/s", -y * pace)
    start = hd.Start(position={"free.x": at}, near={"free.y": y * R}, speed={"free.x": v})
    joints = FREE, hd.PointInTrack("groove", hd.GROUND, PLATE, stadium)
    round_ = hd.Scene(hd.Mechanism("round", joints), (hd.EnergyLedger(),), SCALES, start, coordinates=coordinates)
    run = simulate(load(round_), duration=f"{(0.08 + 0.03 * np.pi) / 2} s", accuracy=1e-8, max_steps=200)
    assert run.outcome.name == "finished"
    body = "free" if coordinates == "tree" else "plate"
    assert (run[f"{body}.x"][-1], run[f"{body}.y"][-1]) == pytest.approx((x, y * 0.015), abs=1e-9)
    force, on_arc = np.abs(run["groove.force_track"]), np.floor(run["groove.parameter"]) % 2 == 1
    clear = np.abs(run["groove.parameter"] % 1 - 0.5) < 0.49
    assert force[on_arc & clear] == pytest.approx(0.2 * 4 / 0.015, rel=1e-7)
    assert np.max(force[~on_arc & clear]) < 1e-6
    assert set(run["groove_junctions.piece"]) == {0, 1, 2, 3}


def test_all_faults_come_at_once():
    s = hd.Parameter("s", "s", 1)
    wrong = (
        hd.Outline("clockwise", (0, 0), [hd.Line((0, L)), hd.Line((L, L)), hd.Line((L, 0)), hd.Line((0, 0))]),
        hd.Outline("apart", (0, 0), [hd.Line((L, 0)), hd.Line((L, L))]),
        hd.Outline("eight", (0, 0), [hd.Line((L, L)), hd.Line((L, 0)), hd.Line((0, L)), hd.Line((0, 0))]),
        hd.Outline("pinched", (0, 0), [hd.Line((L, -R)), hd.Line((L, R)), hd.Line((0, 0)), hd.Line((-L, R)), hd.Line((-L, -R)), hd.Line((0, 0))]),
        hd.Outline("still", (0, 0), [hd.Line((L, 0)), hd.Line((L, 0)), hd.Line((L, L)), hd.Arc((0, 0), (R, R)), hd.Arc((0, 0), (0, 0))]),
        hd.Outline("spike", (0, 0), [hd.Line((L, 0)), hd.Line((R, 0)), hd.Line((0, R)), hd.Line((0, 0))]),
        hd.Outline("bare", (0, 1), [hd.Line((L, 0)), hd.Line((s, L)), hd.Line((0, 1))]),
        hd.Outline("records", (0, L, 0), [3, hd.Line(L), hd.Arc((0, L), "R", clockwise=1)]),
        hd.Outline("none", (0, 0), ()),
        hd.Outline("open hole", (0, 0), [hd.Line((L, 0))], closed=False, hole=True),
    )  # fmt: skip
    pairs = tuple(
        hd.PointOnCurve(f"touch_{k}", PLATE.at(0, 0, 0), curve, CAM.at(0, 0, 0)) for k, curve in enumerate(wrong)
    )
    track = hd.PointInTrack("groove", hd.GROUND, PLATE, BLOCK)
    with pytest.raises(hd.InputError) as error:
        hd.Scene(hd.Mechanism("faulty", (SHAFT, FREE, track), pairs), (), SCALES)
    result = str(error.value)
    for text in (
        "curve clockwise: found a closed chain that runs clockwise", "curve apart: found ends 0.0566 m apart",
        "curve eight, curve pinched, curve spike: found it crosses or touches itself, in its pieces 1 and 3",
        "curve still, piece 2, curve still, piece 5: found a piece of no length",
        "curve still, piece 4: found a start 0.0353553 m and an end 0.0212132 m from the centre",
        "curve still, piece 5: found an arc whose centre is at its end", "curve spike, piece 1: found it turns back",
        "curve bare, start, y, curve bare, piece 3, end, y: found the bare number 1",
        "curve bare, piece 2, end, x: found s", "curve records, start: found (0, L, 0)",
        "curve records, piece 1: found 3", "curve records, piece 2, end: found L",
        "curve records, piece 3, centre: found 'R'", "curve records, piece 3, clockwise: found 1",
        "curve none, pieces: found ()", "name 'open hole'", "open curve as a hole",
        "joint groove, curve block: found a corner at the end of its piece 3",
    ):  # fmt: skip
        assert text in result, text
