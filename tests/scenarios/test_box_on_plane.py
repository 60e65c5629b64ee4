"""A box on a plane by its corners: bounces, tipping, rocking, load shared by corners, boxes on boxes; and what its declaration says."""

import numpy as np
import pytest
from scipy.integrate import quad

import hertzwerk.derive as hd
from hertzwerk.runtime import equilibrium, load, simulate

G, MASS, K = 9.81, 7.0, 1e6
W, H, D = (hd.Parameter(name, "mm", value) for name, value in (("w", 100), ("h", 200), ("d", 60)))
TALL = hd.Parameter("tall", "mm", 600)
STIFFNESS = hd.Parameter("K", "N/m", K)
GRIP = hd.Friction("rub", "floor", hd.laws.coulomb(hd.Parameter("mu", "1", 0.8), hd.Parameter("mu_s", "1", 0.8)))

GRIP_SMOOTH = hd.Friction(
    "rub", "floor", hd.laws.smooth_coulomb(hd.Parameter("mu", "1", 0.8), hd.Parameter("v_s", "m/s", 1e-5))
)


def si(*parameters):
    return [p.si for p in parameters]


def block(height=H, depth=D, centre=(0, 0, 0)):
    w, h, d = si(W, height, depth)
    inertia = [MASS * (a * a + b * b) / 12 for a, b in ((h, d), (w, d), (w, h))]
    about = tuple(hd.Parameter(f"J_{axis}", "kg m^2", value) for axis, value in zip("xyz", inertia, strict=True))
    return hd.Body("block", hd.Parameter("m", "kg", MASS), about, centre=centre)


def standing(
    *effects, height=H, space=False, z=None, centre=(0, 0, 0), down=-hd.Y, coordinates="tree", law=None, **start
):
    """A box on the ground or above it, its coordinates at the start by name in SI."""
    body = block(height, centre=centre)
    joint = hd.Free("move", hd.GROUND, body) if space else hd.Planar("move", hd.GROUND, body, normal=hd.Z)
    floor = hd.BoxOnPlane("floor", body.at(0, 0, 0), W, height, hd.GROUND.at(0, 0, 0), hd.Y, z=z)
    units = {"x": "m", "y": "m", "z": "m", "angle": "rad", "x_speed": "m/s"}
    at = {
        f"move.{name}": hd.Parameter(f"{name}_0", units[name], value)
        for name, value in start.items()
        if name in "xyz angle"
    }
    return hd.Scene(
        hd.Mechanism("standing", (joint,), (floor,)),
        (
            hd.Gravity("gravity", hd.Parameter("g", "m/s^2", G), down), law or hd.Contact("floor", hd.laws.power(STIFFNESS, 1)), *effects,
            hd.EnergyLedger(),
        ),
        hd.Scales(length=hd.Parameter("size", "mm", 1), speed=hd.Parameter("pace", "m/s", 0.1), arm=W),
        hd.Start(position=at),
        coordinates=coordinates,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("space", "z", "coordinates", "springs"),
    [(False, None, "tree", 2), (False, D, "absolute", 4), (True, D, "tree", 4)],
)
def test_a_flat_fall_bounces_as_a_point_mass_on_springs_in_parallel(space, z, coordinates, springs):
    """Contact time under gravity: omega T = 2 (pi - atan(omega v/g)); the box does not turn."""
    drop = 0.05
    scene = standing(space=space, z=z, coordinates=coordinates, y=H.si / 2 + drop)
    run = simulate(load(scene), duration="0.2 s", accuracy=1e-9)
    speed, rate = np.sqrt(2 * G * drop), np.sqrt(springs * K / MASS)
    assert len(run.impacts) == springs
    for impact in run.impacts:
        assert impact.speed == pytest.approx(speed, rel=1e-9)
        assert impact.duration == pytest.approx(2 * (np.pi - np.arctan(rate * speed / G)) / rate, rel=1e-7)
        depth = G / rate**2 + np.hypot(speed / rate, G / rate**2)
        assert impact.peak_force == pytest.approx(K * depth, rel=1e-7)
    if not space:
        assert abs(run.engine.final["move.angle"]) < 1e-12


def test_corners_share_the_load_as_springs_at_them_do():
    """N = (m g/4)(1 + 4 x X/w^2 + 4 z Z/d^2) for a mass centre at (x, z) and a corner at (X, Z); statics and ground agree."""
    x, z = 0.01, -0.005
    centre = (hd.Parameter("off_x", "m", x), 0, hd.Parameter("off_z", "m", z))
    stiff = hd.Contact("floor", hd.laws.power(hd.Parameter("K_9", "N/m", 1e9), 1))
    rest = equilibrium(load(standing(space=True, z=D, centre=centre, law=stiff, y=H.si / 2)))
    w, _, d = si(W, H, D)
    corners = {1: (-w / 2, -d / 2), 2: (w / 2, -d / 2), 5: (-w / 2, d / 2), 6: (w / 2, d / 2)}
    for number, (X, Z_) in corners.items():
        expected = MASS * G / 4 * (1 + 4 * x * X / w**2 + 4 * z * Z_ / d**2)
        assert rest.contacts[f"floor_{number}"] == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize(("part", "falls"), [pytest.param(0.98, False, marks=pytest.mark.exhaustive), (1.02, True)])
def test_a_box_on_an_incline_tips_where_its_weight_passes_its_edge(part, falls):
    """It stands up to tan = w/h and tips above, where friction holds it."""
    tangent = part * W.si / H.si
    hold = hd.laws.power(hd.Parameter("K_8", "N/m", 1e8), 1), hd.laws.hunt_crossley(hd.Parameter("e", "1", 0.1))
    scene = standing(
        GRIP, law=hd.Contact("floor", *hold), down=hd.Direction((tangent, -1, 0)), y=H.si / 2 - MASS * G / 2e8
    )
    run = simulate(load(scene), duration="0.6 s", tolerance=1e-6)
    assert run.outcome.finished
    turned = -run.engine.final["move.angle"]
    if not falls:
        assert abs(turned) < 1e-4
        return
    # about the edge: angle'' = m g R/J sin(angle beyond the balance)
    radius, beyond = np.hypot(W.si, H.si) / 2, np.arctan(tangent) - np.arctan2(W.si, H.si)
    pull = G * radius / ((W.si**2 + H.si**2) / 3)
    speed = np.sqrt(2 * pull * (np.cos(beyond) - np.cos(beyond + turned)))
    assert -run.engine.final["move.angle_speed"] == pytest.approx(speed, rel=5e-3)


def rocking(law, stiffness, duration):
    """A slender block let go at half the angle of its balance, on its second corner."""
    w, h = si(W, TALL)
    slender, radius = np.arctan2(w, h), np.hypot(w, h) / 2
    tilt = slender / 2
    x = w / 2 - radius * np.sin(slender - tilt)
    y = radius * np.cos(slender - tilt) - MASS * G / stiffness
    scene = standing(GRIP_SMOOTH, height=TALL, law=law, x=x, y=y, angle=-tilt)
    run = simulate(load(scene), duration=duration, tolerance=1e-7)
    assert run.outcome.finished
    return run, radius, slender, tilt


@pytest.fixture(scope="module")
def rocked():
    law = hd.Contact(
        "floor", hd.laws.power(hd.Parameter("K_8", "N/m", 1e8), 1), hd.laws.flores(hd.Parameter("e", "1", 0.05))
    )
    return rocking(law, 1e8, "0.4 s")


def test_a_rocking_block_takes_housners_time_to_its_other_corner(rocked):
    """A quarter period: acosh(1/(1 - theta/alpha))/p, p^2 = 3 g/(4 R), for a slender block; exactly an elliptic integral."""
    run, radius, slender, tilt = rocked
    p = np.sqrt(3 * G / (4 * radius))
    over = next(impact for impact in run.impacts if impact.contact == "floor_1").t
    assert over == pytest.approx(np.arccosh(1 / (1 - tilt / slender)) / p, rel=2e-3)

    def slowness(root):
        angle = tilt - root**2
        return 2 * root / np.sqrt(2 * p * p * (np.cos(slender - tilt) - np.cos(slender - angle)))

    exact, _ = quad(slowness, 0, np.sqrt(tilt))
    assert over == pytest.approx(exact, rel=5e-5)


def test_the_other_corner_leaves_a_rocking_block_housners_part_of_its_speed(rocked):
    """1 - 3/2 sin^2(alpha) of the angular velocity is left, Housner 1963, where the impact is plastic and nothing slides."""
    run, radius, slender, tilt = rocked
    over = next(impact for impact in run.impacts if impact.contact == "floor_1").t
    kinetic = MASS * G * radius * (np.cos(slender - tilt) - np.cos(slender))
    before, after = run.at(np.array([over - 1e-4, over + 0.08]))["energy"]
    assert np.sqrt(1 - (before - after) / kinetic) == pytest.approx(1 - 1.5 * np.sin(slender) ** 2, abs=2e-4)


# -- the declaration ---------------------------------------------------------------------------------------------------


def test_effects_of_a_box_act_at_each_corner_without_its_own():
    soft = hd.Contact("floor_3", hd.laws.power(hd.Parameter("K_soft", "N/m", 1e3), 1))
    scene = standing(soft, GRIP, y=0.2)
    assert [effect.name for effect in scene.effects if effect.kind == "contact"] == [f"floor_{i}" for i in (1, 2, 4, 3)]
    assert scene.effect("floor_3").stiffness.binding != scene.effect("floor_1").stiffness.binding
    assert [effect.pair for effect in scene.effects if effect.kind == "friction"] == [
        f"floor_{i}" for i in (1, 2, 3, 4)
    ]
    assert {"K", "K_soft", "mu"} < set(scene.parameters)


def test_its_name_stands_for_all_corners_in_variations():
    scene = standing(GRIP, y=0.2)
    assert [e.kind for e in scene.without("rub").effects] == ["gravity", *["contact"] * 4, "ledger"]
    assert [e.name for e in scene.without("rub_2").effects if e.kind == "friction"] == ["rub_1", "rub_3", "rub_4"]
    damped = scene.with_law("floor", "hunt_crossley(e=0.5)")
    assert all(damped.effect(f"floor_{i}").damping.law.name == "hunt_crossley" for i in (1, 2, 3, 4))
    assert "floor_e" not in scene.parameters
    one = scene.with_law("floor_2", "hunt_crossley(e=0.5)")
    assert [i for i in (1, 2, 3, 4) if one.effect(f"floor_{i}").damping] == [2]
    other = scene.replace(rub=hd.Friction("rub", "floor", GRIP_SMOOTH.law))
    assert {e.law.law.name for e in other.effects if e.kind == "friction"} == {"smooth_coulomb"}
    with pytest.raises(hd.InputError, match=r"flor: found no effect of this name; expected .*floor_1"):
        scene.without("flor")


def test_sizes_of_a_box_are_lengths():
    body = block()
    floor = hd.BoxOnPlane(
        "floor", body.at(0, 0, 0), hd.Parameter("x", "kg", 1), hd.Parameter("y", "mm", -3), hd.GROUND.at(0, 0, 0), hd.Y
    )
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("bad", (hd.Planar("move", hd.GROUND, body),), (floor,)),
            (hd.Contact("floor", hd.laws.power(STIFFNESS, 1)), hd.Friction("grip", "flor", GRIP.law)),
            hd.Scales(W, hd.Parameter("pace", "m/s", 1), W),
        )
    text = str(caught.value)
    assert "pair floor, x" in text
    assert "pair floor, y" in text
    assert "'flor'" in text
