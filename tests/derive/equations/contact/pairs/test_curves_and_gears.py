"""Two curves that may touch: circles, ellipses and involutes against closed forms and independent minimisation; ends, holes, hollows."""

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from derived import Derived
from plane_pairs import CAM, ECCENTRIC, LOBED, OVAL, PLATE, A, B, E, R, check_gradient, gaps, scene
from scipy.optimize import brentq, minimize

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

P = hd.Parameter("p", "mm", 20)
DISC = hd.Curve("disc", P * sp.cos(hd.S), E + P * sp.sin(hd.S))
EGG = hd.Curve("egg", P * sp.cos(hd.S), B * sp.sin(hd.S) / 2)


def moved(curve, angle, x, y, at):
    values = {p: p.si for p in (R, E, A, B, P)}
    px, py = (np.broadcast_to(sp.lambdify(hd.S, c.xreplace(values))(at), np.shape(at)) for c in (curve.x, curve.y))
    return np.array([x + np.cos(angle) * px - np.sin(angle) * py, y + np.sin(angle) * px + np.cos(angle) * py])


def touching(first, second, place=None):
    """The second curve on the cam, the first on the plate."""
    return scene(hd.CurveOnCurve("touch", first, place or PLATE.at(0, 0, 0), second, CAM.at(0, 0, 0)))


@pytest.fixture(scope="module")
def made():
    known = {}
    return lambda *curves: known.setdefault(curves, Derived(touching(*curves)))


@pytest.mark.parametrize("hole", [False, True])
def test_two_circles_equal_their_closed_form(made, hole):
    """Gap, rate and second derivative at random states of two eccentric circles, beside and within one another."""
    second = hd.Curve("bore", E + A * sp.cos(hd.S), A * sp.sin(hd.S), hole=True) if hole else ECCENTRIC
    derived, random = made(DISC, second), np.random.default_rng(1)
    t = ca.SX.sym("t")
    for _ in range(40):
        q, u, a = (random.uniform(-1, 1, 4) * (3, *[0.005 if hole else 0.1] * 2, 3) for _ in range(3))
        way = ca.DM(q) + t * ca.DM(u) + t**2 / 2 * ca.DM(a)
        one = way[1:3] + 0.005 * ca.vertcat(-ca.sin(way[3]), ca.cos(way[3]))
        apart = ca.norm_2(one - 0.005 * ca.vertcat(ca.cos(way[0]), ca.sin(way[0])))
        closed = 0.02 - apart if hole else apart - 0.05
        rate = ca.jacobian(closed, t)
        expected = ca.Function("expected", [t], [closed, rate, ca.jacobian(rate, t)])(0)
        if expected[0] < -0.004:
            continue
        assert np.allclose(gaps(derived, q, u, a), np.array(expected).ravel(), rtol=1e-8, atol=1e-9)


def separation(one, other):
    """Least distance of two convex rims (functions of a parameter), or of penetration minus the least, by SciPy: max over directions."""

    def negative(angle):
        n = np.array([np.cos(angle), np.sin(angle)])
        return n @ np.array([other(n)]).reshape(2) - n @ np.array([one(-n)]).reshape(2)

    at = np.linspace(0, 2 * np.pi, 100)
    start = at[np.argmin([negative(angle) for angle in at])]
    return -minimize(
        lambda x: negative(x[0]), [start], method="Nelder-Mead", options={"xatol": 1e-12, "fatol": 1e-16}
    ).fun


def ellipse(angle, x, y, a, b):
    """Point of a turned ellipse that is farthest along a direction."""
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s], [s, c]])

    def farthest(n):
        m = turn.T @ n
        return [x, y] + turn @ (np.array([a * a * m[0], b * b * m[1]]) / np.hypot(a * m[0], b * m[1]))

    return farthest


def test_two_ellipses_are_as_far_as_scipy_finds(made):
    """Apart, touching, and pressed into each other up to a third of the smaller one's least radius of curvature."""
    derived, random, deepest = made(EGG, OVAL), np.random.default_rng(2), 0.0
    tried = 0
    while tried < 30:
        q = random.uniform(-1, 1, 4) * (3, 0.06, 0.05, 3)
        expected = separation(ellipse(q[3], q[1], q[2], 0.02, 0.0075), ellipse(q[0], 0, 0, 0.04, 0.015))
        if expected < -9e-4:
            continue
        tried, deepest = tried + 1, min(deepest, expected)
        assert gaps(derived, q)[0] == pytest.approx(expected, abs=1e-10)
    assert deepest < -2e-4


def test_rates_are_those_of_differences(made):
    """Of ellipses and of a lobed curve: rate and second derivative along a motion, against central differences."""
    random, h = np.random.default_rng(3), 1e-5
    for curves in ((EGG, OVAL), (LOBED, OVAL)):
        derived = made(*curves)
        for _ in range(15):
            q, u, a = (random.uniform(-1, 1, 4) * (3, 0.1, 0.1, 3) for _ in range(3))
            q[1:3] *= 0.08 / np.hypot(*q[1:3])
            G, dG, ddG = gaps(derived, q, u, a)
            after, before = (gaps(derived, q + way * u + way**2 / 2 * a)[0] for way in (h, -h))
            assert dG == pytest.approx((after - before) / (2 * h), rel=1e-6, abs=1e-7)
            assert ddG == pytest.approx((after - 2 * G + before) / h**2, rel=1e-3, abs=1e-4)


def test_of_several_hollows_the_nearest_is_taken(made):
    """Two lobed curves against the least of very many pairs of points."""
    other = hd.Curve(
        "star", P * (1 + sp.cos(3 * hd.S) / 4) * sp.cos(hd.S), P * (1 + sp.cos(3 * hd.S) / 4) * sp.sin(hd.S)
    )
    derived, random, at = made(other, LOBED), np.random.default_rng(4), np.linspace(0, 2 * np.pi, 1001)
    for _ in range(25):
        q = random.uniform(-1, 1, 4) * (3, 1, 1, 3)
        q[1:3] *= random.uniform(0.062, 0.08) / np.hypot(*q[1:3])
        one, two = moved(other, q[3], q[1], q[2], at), moved(LOBED, q[0], 0, 0, at)
        least = np.sqrt(np.min((one[0][:, None] - two[0]) ** 2 + (one[1][:, None] - two[1]) ** 2))
        assert gaps(derived, q)[0] == pytest.approx(least, abs=4e-5 * (least + 0.1))


def test_an_end_touches_as_a_corner(made):
    """Of the first curve, of the second, and of both: distance and turning of the normal as of points."""
    blade = hd.Curve("blade", P * hd.S, P * hd.S**2 / 40, -1, 1, closed=False)  # its solid is above
    derived = made(blade, ECCENTRIC)
    v = np.array([0.3, -0.7])
    G, dG, ddG = gaps(derived, (0, 0.065, 0.0001, 0), (0, *v, 0))
    end = np.array([0.045, 0.0006]) - [0.005, 0]
    assert pytest.approx(np.hypot(*end) - 0.03, rel=1e-12) == G
    n = end / np.hypot(*end)
    assert (dG, ddG) == pytest.approx((n @ v, (v @ [-n[1], n[0]]) ** 2 / np.hypot(*end)), rel=1e-10)
    other = hd.Curve("edge", -P * hd.S, R, -1, 1, closed=False)  # its solid is below
    derived = made(blade, other)
    G, dG, ddG = gaps(derived, (0, 0.043, 0.034, 0), (0, *v, 0))
    apart = np.array([0.003, 0.0045])
    n = apart / np.hypot(*apart)
    assert pytest.approx(np.hypot(*apart)) == G
    assert (dG, ddG) == pytest.approx((n @ v, (v @ [-n[1], n[0]]) ** 2 / np.hypot(*apart)))


def test_forces_are_minus_the_gradient_of_the_stored_energy(made):
    check_gradient(made(EGG, OVAL), [(0.4, 0.02, 0.0282, 0.2)])


# -- gears ---------------------------------------------------------------------------------------------------------------

MODULE, ALPHA, THIN, APART = (
    hd.Parameter(name, unit, value)
    for name, unit, value in (("module", "mm", 3), ("alpha", "deg", 20), ("thin", "mm", 0.1), ("apart", "mm", 75.2))
)
PINION, WHEEL = (
    hd.InvoluteTeeth("pinion_teeth", MODULE, 20, ALPHA, THIN),
    hd.InvoluteTeeth("wheel_teeth", MODULE, 30, ALPHA, THIN),
)


def meshing(*effects, start=None, sharing=False, damping=None):
    mesh = hd.GearMesh("mesh", PINION, PLATE.at(0, 0, 0), WHEEL, CAM.at(0, 0, 0), sharing=sharing)
    joints = (
        hd.Revolute("one", hd.GROUND, PLATE, axis=hd.Z),
        hd.Revolute("two", hd.GROUND.at(APART, 0, 0), CAM, axis=hd.Z),
    )
    effects = *effects, hd.Contact("mesh", hd.laws.power(hd.Parameter("K", "N/m", 1e6), 1), damping), hd.EnergyLedger()
    scales = hd.Scales(MODULE / 100, hd.Parameter("v", "m/s", 1), APART)
    return hd.Scene(hd.Mechanism("gears", joints, (mesh,)), effects, scales, start or hd.Start())


BASE = np.array([0.030, 0.045]) * np.cos(np.radians(20))
WORKING = np.arccos(sum(BASE) / 0.0752)
PATH = sum(np.sqrt(tip**2 - base**2) for tip, base in zip((0.033, 0.048), BASE, strict=True)) - 0.0752 * np.sin(WORKING)
RATIO = PATH / (np.pi / 10 * BASE[0])  # of contact: the path of contact over the base pitch
LEAD = 2 * (np.tan(np.radians(20)) - np.radians(20) - np.tan(WORKING) + WORKING)  # of a tooth's angles
HALF_BACKLASH = (2 * np.pi / 20 - sum((np.pi / z - 0.1 / (1.5 * z) + LEAD) * z / 20 for z in (20, 30))) * BASE[0] / 2


@pytest.fixture(scope="module")
def gears():
    return Derived(meshing())


def test_gaps_of_involutes_are_lengths_of_the_line_of_action(gears):
    """Right round: both add up to the normal backlash in closed form; each changes by r_b1 w_1 + r_b2 w_2, at no acceleration."""
    random = np.random.default_rng(5)
    for angle in np.linspace(-9, 9, 41):
        w = random.uniform(-10, 10, 2)
        off = random.uniform(-1, 1) * 0.9 * HALF_BACKLASH / BASE[1]
        q = np.array([angle, np.pi + np.pi / 30 - angle * 20 / 30 + off])
        G, dG = gears.call("gaps", q=q, u=w)
        assert pytest.approx((HALF_BACKLASH - off * BASE[1], HALF_BACKLASH + off * BASE[1]), abs=1e-12) == tuple(G)
        assert dG == pytest.approx((-BASE @ w, BASE @ w), rel=1e-9)
        second = gears.call("gap_accelerations", q=q, u=w, a=np.zeros(2))
        assert second == pytest.approx([0, 0], abs=1e-9 * (w @ w) * 0.03)


def test_the_points_of_contact_are_those_of_involutes(gears):
    """On the flanks rolled off by what a gear has turned: base radius times roll angle is the way along the line of action."""
    names = [name for name, _ in gears.OUTPUTS]
    rolls = [np.sqrt(((1 + 2 / z) / np.cos(np.radians(20))) ** 2 - 1) for z in (20, 30)]
    length = np.sqrt(0.0752**2 - sum(BASE) ** 2)  # between the points where the line of action touches the base circles
    for angle in np.linspace(0, 0.3, 7):
        q = np.array([angle, np.pi + np.pi / 30 - angle * 20 / 30])
        actual = dict(zip(names, gears.call("outputs", q=q, u=np.zeros(2), a=np.zeros(2)), strict=False))
        s = [actual[f"mesh_2.{which}_parameter"] % 1 for which in ("first", "second")]
        ways = [r * roll * (0.04 + 0.96 * part) for r, roll, part in zip(BASE, rolls, s, strict=True)]
        assert sum(ways) + actual["mesh_2.gap"] == pytest.approx(length, rel=1e-12)


def test_two_pairs_of_teeth_touch_for_the_part_of_the_pitch_that_the_contact_ratio_gives():
    """Both as deep, so that each carries half; the second leaves and comes with its tip, as far as the square of the way."""
    derived = Derived(meshing(sharing=True))
    pitch, deep = np.pi / 10, 1e-10

    def second(angle):
        off = (HALF_BACKLASH + deep) / BASE[1]
        G, _ = derived.call("gaps", q=np.array([angle, np.pi + np.pi / 30 - angle * 20 / 30 - off]), u=np.zeros(2))
        assert G[1] == pytest.approx(-deep, abs=1e-13)
        assert G[0] > 0 < G[2]
        return G[3]

    coarse = 0.3 + pitch * np.arange(41) / 40
    touching = np.array([second(angle) for angle in coarse]) < 0
    ends = [brentq(second, coarse[k], coarse[k + 1], xtol=1e-9) for k in np.flatnonzero(np.diff(touching))]
    assert len(ends) == 2
    share = abs(ends[1] - ends[0]) / pitch
    assert (share if touching[len(coarse) // 2] else 1 - share) == pytest.approx(RATIO - 1, abs=5e-4)
    assert all(second(angle) == pytest.approx(-deep, abs=1e-13) for angle in coarse[1:-1][touching[:-2] & touching[2:]])


@pytest.mark.exhaustive
def test_a_mesh_is_twice_as_stiff_where_two_pairs_of_teeth_carry():
    """A slow pinion against a torque: the wheel lags by T/(K r_b), half of that in double contact."""
    pace, load_, damping = (
        hd.Parameter("pace", "rad/s", 10), hd.Parameter("load", "N m", 0.4), hd.laws.power_damping(hd.Parameter("c", "N s/m", 500), 0),
    )  # fmt: skip
    effects = hd.ConstantSpeed("motor", "one", pace), hd.JointForce("brake", "two", load_)
    at = np.pi + np.pi / 30 + (HALF_BACKLASH + 0.4 / BASE[1] / 1e6) / BASE[1]
    start = hd.Start(position={"two": hd.Parameter("at", "rad", at)}, speed={"two": -pace * 2 / 3})
    run = simulate(
        load(meshing(*effects, start=start, sharing=True, damping=damping)), duration=np.pi / 100, accuracy=1e-4
    )
    assert run.outcome.finished
    assert run.energy_residual < 1e-6
    forces = np.array([run[f"mesh_{k}.normal_force"] for k in (1, 3)])
    assert not np.any(run["mesh_2.normal_force"])
    lag, single, both = -run["mesh_1.gap"], forces[1] == 0, (forces[1] > 0) & (np.abs(forces[1] - forces[0]) < 1e-6)
    flanks = single | both  # else a tip enters or leaves, beside the line of action
    torque = 0.4 - 1e-3 * run["two.acceleration"]
    assert (forces.sum(axis=0) * BASE[1])[flanks] == pytest.approx(torque[flanks], rel=1e-6)
    assert np.trapezoid(1.0 * both, run.t) / run.t[-1] == pytest.approx(RATIO - 1, abs=0.02)
    assert np.median(lag[single]) == pytest.approx(0.4 / BASE[1] / 1e6, rel=2e-2)
    assert np.median(lag[both]) == pytest.approx(0.4 / BASE[1] / 2e6, rel=2e-2)


def test_all_faults_come_at_once():
    hole, few = (
        hd.Curve("hole", R * sp.cos(hd.S), R * sp.sin(hd.S), hole=True),
        hd.InvoluteTeeth("few", MODULE, 3, ALPHA),
    )
    none = hd.Curve("none_at_all", R * hd.S, R * hd.S**2, closed=False, repeats=0)
    wrong = (
        hd.CurveOnCurve("chain", hd.Outline("none", (0, 0), ()), PLATE.at(0, 0, 0), "R", CAM.at(0, 0, 0)),
        hd.CurveOnCurve("mixed", OVAL, PLATE.at(0, 0, 0), hd.Outline("ring", (R, 0), (hd.Arc((R, 0), (0, 0)),)), CAM.at(0, 0, 0)),
        hd.CurveOnCurve("holes", hole, PLATE.at(0, 0, 0), replace(hole, name="other_hole"), CAM.at(0, 0, 0)),
        hd.CurveOnCurve("copies", replace(hole, name="round", hole=False, repeats=3), PLATE.at(0, 0, 0), none, CAM.at(0, 0, 0)),
        hd.CircleOnCurve("roller", PLATE.at(0, 0, 0), R, replace(none, name="teeth", repeats=8), CAM.at(0, 0, 0)),
        hd.GearMesh("mesh", few, PLATE.at(0, 0, 0), hd.InvoluteTeeth("pointed", MODULE, 8, ALPHA, addendum=3), CAM.at(0, 0, 0)),
        hd.GearMesh("strange", "teeth", PLATE.at(0, 0, 0), hd.InvoluteTeeth("text", "3 mm", 20, ALPHA), CAM.at(0, 0, 0)),
    )  # fmt: skip
    with pytest.raises(hd.InputError) as error:
        hd.Scene(
            hd.Mechanism("faulty", (hd.Revolute("shaft", hd.GROUND, CAM, axis=hd.Z), hd.Planar("free", hd.GROUND, PLATE)), wrong), (),
            hd.Scales(R, hd.Parameter("pace", "m/s", 1), R),
        )  # fmt: skip
    actual = str(error.value)
    for text in (
        "curve none, pieces: found ()", "pair mixed, curves: found a curve and an outline",
        "pair chain, curve: found 'R'", "pair holes, curves: found two holes",
        "curve round, repeats: found 3 copies of a closed curve", "curve none_at_all, repeats: found 0",
        "pair roller, curve teeth: found 8 copies", "teeth few, teeth: found 3",
        "teeth pointed: found flanks that cross below the tip", "pair strange, first teeth: found 'teeth'",
        "teeth text, module: found '3 mm'",
    ):  # fmt: skip
        assert text in actual, text
    with pytest.raises(hd.InputError, match="a Z of the first curve"):
        turned = PLATE.at(0, 0, 0).turned(hd.X, hd.Parameter("half", "deg", 180))
        Derived(touching(EGG, OVAL, turned))
