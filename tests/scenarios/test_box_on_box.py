"""Boxes on boxes: distances by bounded least squares, virtual work, impulses in closed form, stacks, tipping; their declaration."""

import numpy as np
import pytest
from scipy.optimize import lsq_linear
from scipy.spatial.transform import Rotation

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

G = 9.81
R = hd.Parameter("r", "mm", 1)
W, H, D, L, S = (hd.Parameter(n, "mm", v) for n, v in (("w", 100), ("h", 80), ("d", 60), ("l", 300), ("s", 30)))
w, h, r, s = W.si, H.si, R.si, S.si
RHO = hd.Parameter("rho", "kg/m^3", 1000)
MASS = 1000 * w * h * D.si
K = hd.Parameter("K", "N/m", 1e6)
SIZES = hd.Scales(length=R, speed=hd.Parameter("pace", "m/s", 0.1), arm=W)
GRAVITY = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", G), -hd.Y)
DAMPED = hd.laws.power(K, 1), hd.laws.hunt_crossley(hd.Parameter("e", "1", 0.3))


def at(**values):
    """Coordinates or speeds at the start by name, two underscores for the point, in SI."""
    units = {"x": "m", "y": "m", "z": "m", "angle": "rad"}
    return {
        name.replace("__", "."): hd.Parameter(name, units.get(name.split("__")[1], "1"), float(value))
        for name, value in values.items()
    }


def pair(
    *effects, space=False, coordinates="tree", sizes=((W, H, D), (W, H, D)), position=None, speed=None, swap=False
):
    """Two free bodies of a density, a and b, that may touch."""
    a, b = (hd.Body.box(name, *of, density=RHO) for name, of in zip("ab", sizes, strict=True))
    joint = hd.Free if space else hd.Planar
    of = [(body.at(0, 0, 0), *size) for body, size in zip((a, b), sizes, strict=True)]
    (one, ox, oy, oz), (two, tx, ty, tz) = of[::-1] if swap else of
    touch = hd.BoxOnBox("hit", one, ox, oy, two, tx, ty, R, *((oz, tz) if space else ()))
    speeds = {
        k: hd.Parameter(f"{k.replace('.', '_')}_speed_0", "m/s" if k[-1] in "xyz" else "rad/s", v)
        for k, v in (speed or {}).items()
    }
    return hd.Scene(
        hd.Mechanism("pair", (joint("A", hd.GROUND, a), joint("B", hd.GROUND, b)), (touch,)),
        (*(effects or (hd.Contact("hit", hd.laws.power(K, 1)),)), hd.EnergyLedger()), SIZES, hd.Start(position=position or at(A__y=1), speed=speeds),
        coordinates=coordinates,
    )  # fmt: skip


@pytest.fixture(scope="module")
def boxes():
    model = load(pair(space=True, position=at(A__y=1)))
    return model, model.bind({}).c


def nearest(where, turns):
    """Vector between the nearest points of the boxes less their rounding, by least squares with bounds."""
    half = np.array([W.si, H.si, D.si]) / 2 - r
    sides = np.hstack([turns[0], -turns[1]])
    return where + sides @ lsq_linear(sides, -where, (-np.tile(half, 2), np.tile(half, 2)), tol=1e-15).x


def placed(rng, reach):
    """Two boxes at random, this far apart less their rounding; their coordinates and any speeds."""
    turns, apart = Rotation.random(2, rng=rng), np.zeros(3)
    while np.linalg.norm(apart) < 1e-3:
        where = rng.normal(size=3)
        where *= rng.uniform(0.07, 0.13) / np.linalg.norm(where)
        apart = nearest(where, turns.as_matrix())
    where = where + (reach / np.linalg.norm(apart) - 1) * apart
    places = zip((where, np.zeros(3)), turns, strict=True)
    return np.concatenate([np.concatenate([p, t.as_quat(scalar_first=True)]) for p, t in places]), rng.normal(size=12)


def test_the_deepest_feature_is_as_deep_as_the_rounded_boxes(boxes):
    """And nothing touches where they are apart: corners on faces, and edges that cross."""
    model, c = boxes
    rng, crossed = np.random.default_rng(1), 0
    for _ in range(80):
        reach = rng.uniform(1.2, 2.8) * r
        q, u = placed(rng, reach)
        gaps = np.array(model.evaluate("gaps", 0.0, q, u, c)[0]).ravel()
        if reach > 2 * r:
            assert gaps.min() > 0
            continue
        depths = np.where(np.arange(24) < 8, 2 * r - np.sqrt(np.maximum(4 * r * gaps + 4 * r * r, 0)), -gaps)
        assert depths.max() == pytest.approx(2 * r - reach, rel=1e-6)
        crossed += depths.argmax() >= 8
    assert 5 < crossed < 40


def test_gaps_have_their_rates_and_second_rates(boxes):
    model, c = boxes
    rng, step = np.random.default_rng(2), 1e-6
    q, u = placed(rng, 1.6 * r)
    a = rng.normal(size=12)

    def along(tau):
        dq = model.evaluate("coordinate_rates", 0.0, q, u, c)
        dq = np.array(dq[0] if isinstance(dq, tuple | list) else dq).ravel()
        return [np.array(v).ravel() for v in model.evaluate("gaps", 0.0, q + tau * dq, u + tau * a, c)]

    (low, low_rate), (high, high_rate) = along(-step), along(step)
    _, rate = along(0)
    np.testing.assert_allclose(rate, (high - low) / (2 * step), rtol=1e-6, atol=1e-6)
    found = model.evaluate("gap_accelerations", 0.0, q, u, a, c)
    second = np.array(found[0] if isinstance(found, tuple | list) else found).ravel()
    np.testing.assert_allclose(second, (high_rate - low_rate) / (2 * step), rtol=1e-4, atol=1e-4)


def test_forces_do_the_work_of_the_penetration(boxes):
    """Power on both boxes is minus force times the rate of the penetration, turning included; linear and angular momentum stay."""
    model, c = boxes
    rng, touched = np.random.default_rng(3), 0
    for _ in range(25):
        q, u = placed(rng, 1.7 * r)
        gaps, rates = (np.array(v).ravel() for v in model.evaluate("gaps", 0.0, q, u, c))
        for k in np.flatnonzero(gaps < 0):
            touched += 1
            f, _, normal, *_ = model.evaluate(f"contact_hit_{k + 1}", 0.0, q, u, np.zeros(24), np.zeros(0), c)
            f, force = np.array(f).ravel(), float(normal[0])
            distance = 2 * r / (2 * r - force / K.si) if k < 8 else 1  # not its square
            depth_rate = -rates[k] * distance
            assert f @ u == pytest.approx(-force * depth_rate, rel=1e-8)
            np.testing.assert_allclose(f[:3], -f[6:9], rtol=1e-12)
            turns = [Rotation.from_quat(part, scalar_first=True) for part in (q[3:7], q[10:14])]
            moments = [turn.apply(m) for turn, m in zip(turns, (f[3:6], f[9:12]), strict=True)]
            about = moments[0] + np.cross(q[:3], f[:3]) + moments[1] + np.cross(q[7:10], f[6:9])
            np.testing.assert_allclose(about, 0, atol=1e-12 * force)
    assert touched > 20


# -- motion in the plane -----------------------------------------------------------------------------------------------


def test_momentum_and_energy_stay_and_swapped_boxes_move_alike():
    """Rectangles that hit each other obliquely, without loss; with the first as the second the motion is the same."""
    position, speed = at(A__x=0.03, A__y=h + 12e-3, A__angle=0.2), {"A.y": -1.0, "A.x": -0.3, "B.angle": 2.0}
    models = [load(pair(position=position, speed=speed, swap=swap)) for swap in (False, True)]
    runs = [simulate(model, duration="30 ms", accuracy=1e-9) for model in models]
    assert all(run.outcome.finished and run.impacts for run in runs)
    one, two = (run.engine.final for run in runs)
    for name in ("A.x", "A.y", "A.angle", "B.x", "B.y", "B.angle"):
        assert one[name] == pytest.approx(two[name], abs=1e-9)
    assert one["A.x_speed"] + one["B.x_speed"] == pytest.approx(-0.3, abs=1e-10)
    assert one["A.y_speed"] + one["B.y_speed"] == pytest.approx(-1, abs=1e-10)
    assert runs[0].energy_residual < 1e-9


def held(offset, *effects, law=DAMPED, duration="0.3 s", **start):
    """A rectangle on another, which is held, both flat."""
    a = hd.Body.box("a", W, H, D, density=RHO)
    touch = hd.BoxOnBox("hit", a.at(0, 0, 0), W, H, hd.GROUND.at(0, 0, 0), W, H, R)
    start = at(A__x=offset, A__y=h - 1e-6) if not start else at(A__x=offset, **start)
    scene = hd.Scene(
        hd.Mechanism("held", (hd.Planar("A", hd.GROUND, a),), (touch,)), (GRAVITY, hd.Contact("hit", *law), *effects, hd.EnergyLedger()), SIZES,
        hd.Start(position=start),
    )  # fmt: skip
    return simulate(load(scene), duration=duration, tolerance=1e-7)


def test_corners_of_both_carry_what_hangs_over():
    """The lower left corner of the upper one and the upper right corner of the lower: forces in the ratio of their levers."""
    run = held(0.03)
    forces = run.at(np.array([0.3]))
    left, right = (forces[f"hit_{k}.normal_force"] + forces[f"hit_{k + 1}.normal_force"] for k in (1, 3))
    reach = w / 2 - r
    assert left[0] == pytest.approx(MASS * G * (reach - 0.03) / (2 * reach - 0.03), rel=1e-3)
    assert right[0] == pytest.approx(MASS * G * reach / (2 * reach - 0.03), rel=1e-3)


GRIP = hd.Friction("rub", "hit", hd.laws.coulomb(hd.Parameter("mu", "1", 0.9), hd.Parameter("mu_s", "1", 0.9)))


def test_deeper_than_the_rounding_the_run_ends_and_says_where():
    run = held(0.03, law=(hd.laws.power(hd.Parameter("K_soft", "N/m", 200), 1),), A__y=h + 0.05, duration="0.3 s")
    assert run.outcome.name == "outside_law_range"
    assert "hit_" in str(run)
    with pytest.raises(hd.InputError, match=r"hit_1.*found a penetration"):
        held(0.03, A__y=h - 0.01)


# -- motion in space ---------------------------------------------------------------------------------------------------


@pytest.mark.exhaustive
def test_crossed_bars_hit_edge_on_edge_as_rigid_ones():
    """Two square bars on their edges, crossed, off both middles: J = 2 v/(2/m + (x^2 + z^2)/I) on each; energy and momentum stay."""
    x, z, v = 0.06, 0.04, 0.5
    c, n, high = np.cos(np.pi / 8), np.sin(np.pi / 8), s * np.sqrt(2) - 2 * (np.sqrt(2) - 1) * r
    position = at(A__x=x, A__y=high + 1e-5, A__q0=c, A__q1=n, B__q0=c, B__q3=n, B__z=z)
    stiff = hd.Contact("hit", hd.laws.power(hd.Parameter("K_9", "N/m", 1e9), 1))
    scene = pair(stiff, space=True, sizes=((L, S, S), (S, S, L)), position=position, speed={"A.y": -v})
    run = simulate(load(scene), duration="1 ms", tolerance=1e-8)
    (impact,) = run.impacts
    assert int(impact.contact[4:]) > 8
    mass = 1000 * L.si * s**2
    inertia = mass * (L.si**2 + s**2) / 12
    impulse = 2 * v / (2 / mass + (x**2 + z**2) / inertia)
    assert run.engine.final["A.y_speed"] == pytest.approx(-v + impulse / mass, rel=1e-3)
    assert run.engine.final["B.y_speed"] == pytest.approx(-impulse / mass, rel=1e-3)
    for body, arm in (("A", x), ("B", z)):
        spin = np.linalg.norm([run.engine.final[f"{body}.angular_speed_{axis}"] for axis in "xyz"])
        assert spin == pytest.approx(arm * impulse / inertia, rel=1e-3)
    assert run.energy_residual < 1e-8


@pytest.mark.exhaustive
def test_a_plank_across_a_plank_rests_on_four_crossings():
    """No corner touches; edges that cross carry a quarter each, or by levers where it lies off the middle."""
    x = 0.004
    plank = hd.Body.box("plank", L, S, S, density=RHO)
    touch = hd.BoxOnBox("hit", plank.at(0, 0, 0), L, S, hd.GROUND.at(0, 0, 0), S, S, R, S, L)
    scene = hd.Scene(
        hd.Mechanism("across", (hd.Free("A", hd.GROUND, plank),), (touch,)), (GRAVITY, hd.Contact("hit", *DAMPED), hd.EnergyLedger()), SIZES,
        hd.Start(position=at(A__x=x, A__y=s)),
    )  # fmt: skip
    run = simulate(load(scene), duration="0.25 s", tolerance=1e-6, method="esdirk")
    forces = {k: run.at(np.array([0.25]))[f"hit_{k}.normal_force"][0] for k in range(1, 25)}
    carry = sorted(value for value in forces.values() if value > 1e-3)
    weight, reach = 1000 * L.si * s**2 * G, s / 2 - r
    assert len(carry) == 4
    assert not any(forces[k] for k in range(1, 9))
    expected = [weight / 4 * (1 + side * x / reach) for side in (-1, -1, 1, 1)]
    assert carry == pytest.approx(expected, rel=2e-3)


# -- the declaration ---------------------------------------------------------------------------------------------------


def test_effects_of_a_box_pair_act_at_each_feature():
    scene = pair(hd.Contact("hit", hd.laws.power(K, 1)), GRIP)
    assert [p.name for p in scene.mechanism.pairs] == ["hit_1", "hit_2", "hit_3", "hit_4"]
    assert [e.pair for e in scene.effects if e.kind == "friction"] == ["hit_1", "hit_2", "hit_3", "hit_4"]
    assert len(pair(space=True).mechanism.pairs) == 24


def test_faults_of_boxes_are_reported_at_once():
    body = hd.Body.box("a", W, H, D, density=RHO)
    flat, thin, heavy = hd.Parameter("flat", "mm", 1.5), hd.Parameter("thin", "mm", -1), hd.Parameter("heavy", "kg", 1)
    bad = (
        hd.BoxOnBox("one", body.at(0, 0, 0), W, H, hd.GROUND.at(0, 0, 0), W, H, R, D),
        hd.BoxOnBox("two", body.at(0, 0, 0), flat, heavy, hd.GROUND.at(0, 0, 0), thin, H, R),
    )
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("bad", (hd.Planar("A", hd.GROUND, body),), bad),
            (hd.Contact("one", hd.laws.power(K, 1)), hd.Contact("two", hd.laws.power(K, 1))),
            SIZES,
        )
    text = str(caught.value)
    for part in ("pair one: found a z of one of both", "two, first x less two radii", "two, first y", "two, second x"):
        assert part in text


def test_rectangles_stay_in_their_plane():
    body, tilted = (
        hd.Body.box("a", W, H, D, density=RHO),
        hd.GROUND.at(0, 0, 0).turned(hd.X, hd.Parameter("q", "deg", 30)),
    )
    touch = hd.BoxOnBox("hit", body.at(0, 0, 0), W, H, tilted, W, H, R)
    mechanism = hd.Mechanism("bad", (hd.Planar("A", hd.GROUND, body, normal=hd.Z),), (touch,))
    with pytest.raises(hd.InputError, match="motion out of the plane of x and y"):
        load(hd.Scene(mechanism, (hd.Contact("hit", hd.laws.power(K, 1)),), SIZES))
