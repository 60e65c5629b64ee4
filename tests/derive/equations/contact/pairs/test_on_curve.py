"""Circles, points and faces on planar curves: against closed forms, high precision and brute force; a cam whose follower lifts off."""

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from derived import Derived
from mpmath import mp
from plane_pairs import BLOCK, CAM, ECCENTRIC, LOBED, OVAL, PLATE, A, B, R, check_gradient, check_shapes, gaps, scene
from scipy.interpolate import make_interp_spline

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

ROLLER = hd.Parameter("roller", "mm", 8)
ARCH = hd.Curve("arch", A * hd.S, B * hd.S**2 / 2, start=-1, end=1, closed=False)


def circle(curve, radius=ROLLER):
    return hd.CircleOnCurve("touch", PLATE.at(0, 0, 0), radius, curve, CAM.at(0, 0, 0))


def point(curve):
    return hd.PointOnCurve("touch", PLATE.at(0, 0, 0), curve, CAM.at(0, 0, 0))


FACE = hd.FaceOnCurve("touch", PLATE.at(0, 0, 0), -hd.Y, ECCENTRIC, CAM.at(0, 0, 0))


@pytest.fixture(scope="module")
def made():
    known = {}
    return lambda pair: known.setdefault(pair, Derived(scene(pair)))


@pytest.mark.parametrize("flat", [False, True], ids=["roller", "face"])
def test_an_eccentric_circle_equals_its_closed_form(made, flat):
    """Gap, its rate and its second derivative at random states, to 1e-13 of their size, of a disc turning off its centre."""
    derived, random = made(FACE if flat else circle(ECCENTRIC)), np.random.default_rng(1)
    t = ca.SX.sym("t")
    for _ in range(40):
        q, u, a = (random.uniform(-1, 1, 4) * (3, 0.1, 0.1, 2) for _ in range(3))
        way = ca.DM(q) + t * ca.DM(u) + t**2 / 2 * ca.DM(a)
        centre = 0.005 * ca.vertcat(ca.cos(way[0]), ca.sin(way[0]))
        apart = centre - way[1:3]
        down = ca.vertcat(ca.sin(way[3]), -ca.cos(way[3]))
        closed = ca.dot(apart, down) - 0.03 if flat else ca.norm_2(apart) - 0.038
        rate = ca.jacobian(closed, t)
        expected = ca.Function("expected", [t], [closed, rate, ca.jacobian(rate, t)])(0)
        if not flat and abs(expected[0]) > 0.1:
            continue
        assert np.allclose(gaps(derived, q, u, a), np.array(expected).ravel(), rtol=1e-13, atol=1e-13 * 10)


def nearest_on_ellipse(x, y):
    """Distance of a point outside an ellipse, to 30 digits: the greatest root of Eberly's equation."""
    with mp.workdps(30):
        a, b, x, y = mp.mpf("0.04"), mp.mpf("0.015"), abs(mp.mpf(float(x))), abs(mp.mpf(float(y)))
        root = mp.findroot(
            lambda t: (a * x / (t + a**2)) ** 2 + (b * y / (t + b**2)) ** 2 - 1,
            (-(b**2) + b * y, -(b**2) + mp.hypot(a * x, b * y)),
            solver="anderson",
        )
        px, py = a**2 * x / (root + a**2), b**2 * y / (root + b**2)
        return float(mp.sign(root) * mp.hypot(x - px, y - py))


def test_a_point_beside_an_ellipse_is_as_far_as_mpmath_finds(made):
    derived, random = made(point(OVAL)), np.random.default_rng(2)
    actual = [
        (gaps(derived, (0, x, y, 0))[0], nearest_on_ellipse(x, y)) for x, y in random.uniform(-0.06, 0.06, (60, 2))
    ]
    assert np.max(np.abs(np.subtract(*np.transpose(actual)))) < 1e-16 * 5
    assert min(expected for _, expected in actual) < -0.005  # deep within too


@pytest.mark.parametrize("curve", [LOBED, ARCH, OVAL], ids=lambda curve: curve.name)
def test_of_several_candidates_the_nearest_is_taken(made, curve):
    """Against the least of very many points, where hollows compete."""
    derived, random = made(point(curve)), np.random.default_rng(3)
    s = sp.lambdify(hd.S, [value.xreplace({p: p.si for p in (R, A, B)}) for value in (curve.x, curve.y)])
    rim = np.array(s(np.linspace(float(curve.start), float(curve.end), 400_001)))
    for x, y in random.uniform(-0.05, 0.05, (60, 2)):
        apart = np.hypot(*(rim - [[x], [y]]))
        assert abs(gaps(derived, (0, x, y, 0))[0]) == pytest.approx(np.min(apart), rel=1e-6, abs=2e-7)


def test_distances_beside_a_hollow_and_beyond_an_end(made):
    # Both lobes beside it compete; the nearest sample alone would sometimes belong to the wrong one.
    derived, worst = made(point(LOBED)), 0.0
    for angle in (2 * np.arange(5) + 1) * np.pi / 5:
        for r in np.linspace(0.026, 0.06, 12):
            beside = [
                gaps(derived, (0, r * np.cos(angle + turn), r * np.sin(angle + turn), 0))[0] for turn in (1e-5, -1e-5)
            ]
            worst = max(worst, abs(beside[0] - beside[1]))
    assert worst < 1e-9  # at a centre of curvature, where the nearest point is badly determined; elsewhere 1e-16
    above, below = (gaps(made(point(ARCH)), (0, 0, y, 0))[0] for y in (0.001, -0.001))
    assert (above, below) == pytest.approx((-0.001, 0.001), rel=1e-3)
    beyond = gaps(made(point(ARCH)), (0, 0.05, 0.0075, 0), (0, 1, 0, 0), (0, 0, 0, 0))
    assert beyond == pytest.approx((0.01, 1, 0), abs=1e-14)  # the end is at (40, 7.5) mm


def test_forces_are_minus_the_gradient_of_the_stored_energy(made):
    check_gradient(made(circle(OVAL)), [(0.4, 0.03, 0.028, 0.2)])


def test_derivatives_by_shapes_and_places_are_differences(made):
    block = hd.FaceOnCurve("touch", PLATE.at(0, 0, 0), -hd.Y, BLOCK, CAM.at(0, 0, 0))
    states = [(0.4, 0.03, 0.028, 0.2), (2.0, -0.02, 0.05, -0.3)]
    for pair in (FACE, point(LOBED), point(ARCH), circle(BLOCK), block):
        check_shapes(made(pair), states)
        with pytest.raises(AssertionError, match="gaps"):
            check_shapes(made(pair), states, shaped=False)


def test_a_table_of_points_is_the_smooth_curve_through_them(made):
    """Forty points of an ellipse: to the fourth power of their distance at least; the point where it closes is like any other."""
    at = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    oval = hd.curve_through("oval", 40 * np.cos(at), 15 * np.sin(at), "mm")
    derived = made(point(oval))
    for x, y in ((0.05, 0.001), (0.05, -0.001), (0.001, 0.03), (-0.02, -0.02)):
        assert gaps(derived, (0, x, y, 0))[0] == pytest.approx(nearest_on_ellipse(x, y), abs=2e-7)
    one, other = (gaps(derived, (0, 0.05, y, 0), (0, 0, 1, 0)) for y in (1e-9, -1e-9))
    assert one[2] == pytest.approx(other[2], rel=1e-5)


def test_a_periodic_table_is_scipys_periodic_spline():
    x, y = (0.0, 0.7, 1.1, 2.0, 2.6, 3.0), (1.0, -1.0, 0.5, 2.0, 0.0, 1.0)
    table = hd.Table("wave", x, y, ("1", "m"), periodic=True)
    assert not list(table.faults())
    expected, at = make_interp_spline(x, y, k=5, bc_type="periodic"), np.linspace(0, 2.999, 77)
    rows = np.array(table.pieces())
    k = np.searchsorted(rows[:, 0], at, side="right") - 1
    actual = sum(rows[k, 1 + j] * (at - rows[k, 0]) ** j for j in range(6))
    assert np.allclose(actual, expected(at), atol=1e-12)
    assert [
        fault.found for fault in hd.Table("wave", x, (*y[:-1], 2.0), ("1", "m"), (0, 0), periodic=True).faults()
    ] == [
        "slopes at the ends of a period",
        "2.0 after a period that begins with 1.0",
    ]


def test_a_parameter_may_be_called_s():
    derived = Derived(
        scene(circle(hd.Curve("rim", (s := hd.Parameter("s", "mm", 30)) * sp.cos(hd.S), s * sp.sin(hd.S))))
    )
    assert gaps(derived, (0, 0.05, 0, 0))[0] == pytest.approx(0.05 - 0.03 - 0.008)


def test_all_faults_come_at_once():
    wrong = (
        hd.Curve("clockwise", R * sp.cos(hd.S), -R * sp.sin(hd.S)), hd.Curve("half", R * sp.cos(hd.S), R * sp.sin(hd.S), end=3),
        hd.Curve("eight", R * sp.sin(2 * hd.S), R * sp.sin(hd.S)), hd.Curve("bare", 30 * sp.cos(hd.S), R * sp.sin(hd.S)),
        hd.Curve("no_metres", hd.Parameter("turn", "rad", 1) * sp.cos(hd.S), R * sp.sin(hd.S)), hd.Curve("still", R, R),
        hd.Curve("cusp", R * hd.S**2, R * hd.S**3, -1, 1, closed=False), hd.Curve("gap", R * sp.log(hd.S), R * hd.S, closed=False),
        hd.Curve("strange", hd.X, R * sp.Symbol("q"), 2, 1), hd.Curve("open hole", R * hd.S, R * hd.S**2, closed=False, hole=True),
        hd.curve_through("flat", (0, 1, 1, 0), (0, 0, 1, 1), "s"), "R*cos(S)",
    )  # fmt: skip
    pairs = tuple(
        hd.CircleOnCurve(f"touch_{k}", PLATE.at(0, 0, 0), ROLLER, curve, CAM.at(0, 0, 0))
        for k, curve in enumerate(wrong)
    )
    joints = (hd.Revolute("shaft", hd.GROUND, CAM, axis=hd.Z), hd.Planar("free", hd.GROUND, PLATE))
    with pytest.raises(hd.InputError) as error:
        hd.Scene(hd.Mechanism("faulty", joints, pairs), (), hd.Scales(R, hd.Parameter("pace", "m/s", 1), R))
    result = str(error.value)
    for text in (
        "runs clockwise", "curve half: found ends", "crosses itself", "30*cos(s)", "curve no_metres, x", "no length", "stands still",
        "curve gap: found no numbers", "curve strange, x: found Direction", "symbol q", "from 2 to 1", "name 'open hole'", "open curve as a hole",
        "curve flat, x: found",
        "pair touch_11, curve: found 'R*cos(S)'",
    ):  # fmt: skip
        assert text in result, text


def test_names_of_a_curve_are_its_own():
    other = hd.Curve("RIM", R * sp.cos(hd.S), R * sp.sin(hd.S) * 2)
    pairs = (
        circle(ECCENTRIC),
        hd.CircleOnCurve("other", PLATE.at(0, 0, 0), hd.Parameter("rim_curve", "mm", 8), other, CAM.at(0, 0, 0)),
    )
    with pytest.raises(hd.InputError, match="two different curves of this name") as error:
        hd.Scene(
            hd.Mechanism("faulty", (hd.Revolute("shaft", hd.GROUND, CAM, axis=hd.Z), hd.Planar("free", hd.GROUND, PLATE)), pairs), (),
            hd.Scales(R, hd.Parameter("pace", "m/s", 1), R),
        )  # fmt: skip
    assert "a parameter named RIM_curve" in str(error.value)


def test_a_curve_out_of_the_plane_of_motion_is_refused():
    tilted = hd.CircleOnCurve(
        "touch", PLATE.at(0, 0, 0), ROLLER, ECCENTRIC, CAM.at(0, 0, 0).turned(hd.X, hd.Parameter("tilt", "rad", 0.3))
    )
    with pytest.raises(hd.InputError, match="motion out of the curve's plane"):
        Derived(scene(tilted))


@pytest.mark.parametrize(("share", "lifts"), [(0.995, False), (1.005, True)])
def test_a_cam_loses_its_follower_above_the_speed_in_closed_form(share, lifts):
    """w^2 = 2 (preload + k lift + m g)/(m lift), from both sides."""
    critical = np.sqrt(2 * (50 + 2000 * 0.01 + 0.5 * 9.81) / (0.5 * 0.01))
    model = load("cam_follower")
    run = simulate(
        model, duration=f"{2 * np.pi / critical} s", accuracy=1e-6, parameters={"cam_speed": f"{share * critical} rad/s"},
    )  # fmt: skip
    assert run.outcome.name == "finished"
    assert (len(run.impacts) > 1) == lifts
    assert (run["roller.gap"].max() > 1e-7) == lifts
