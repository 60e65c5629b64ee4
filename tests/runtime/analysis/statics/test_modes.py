"""Small vibrations against closed forms, Bessel's zeros, and eigenproblems written another way."""

import math

import numpy as np
import pytest
from balls import MASS, STIFFNESS, ball, dry
from handmade import point
from scipy.linalg import eigh
from scipy.special import jn_zeros

import hertzwerk.derive as hd
from hertzwerk.runtime import equilibrium, modes, simulate
from hertzwerk.runtime.engine.start.start_values import start_of
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.insets import clearances
from hertzwerk.runtime.output.drawings.places import Places

G = 9.81
LINKS, LENGTH = 8, 2.0


@pytest.fixture(scope="module")
def pendulum():
    return engine_model("pendulum")


def test_a_pendulum_hanging_upright_and_on_its_way(pendulum):
    """w^2 = g/L hanging, minus that upright, g/L cos(angle) in the frozen equations of a swing."""
    hanging = modes(pendulum)
    assert hanging.frequencies == pytest.approx([math.sqrt(G) / (2 * math.pi)], rel=1e-12)
    assert hanging.stable and hanging.damping_ratios == pytest.approx([0])
    upright = equilibrium(pendulum, initial={"hinge.angle": "3.1 rad"}, nearest=True)
    assert upright.q[0] == pytest.approx(math.pi) and not upright.stable
    growing = modes(upright)
    assert sorted(mode.eigenvalue.real for mode in growing) == pytest.approx([-math.sqrt(G), math.sqrt(G)])
    assert not growing.stable
    run = simulate(pendulum, duration="0.3 s", tolerance=1e-9)
    seen = modes(run, at="0.2 s")
    angle = float(run.at([0.2])["hinge.angle"][0])
    assert 2 * math.pi * seen.frequencies == pytest.approx([math.sqrt(G * math.cos(angle))], rel=1e-9)
    with pytest.raises(hd.InputError, match="at"):
        modes(run, at="1 s")


def test_a_damped_oscillator():
    """x'' + 2 z w x' + w^2 x = 0, below and above critical damping."""
    w, z = 7.0, 0.3
    (mode,) = modes(point(push=lambda t, x, v: -2 * z * w * v - w * w * x))
    assert mode.damping_ratio == pytest.approx(z, rel=1e-12)
    assert 2 * math.pi * mode.frequency == pytest.approx(w * math.sqrt(1 - z * z), rel=1e-12)
    assert 2 * math.pi * mode.natural_frequency == pytest.approx(w, rel=1e-12)
    assert list(mode.shape.values()) == pytest.approx([1])  # its largest, with no phase
    over = modes(point(push=lambda t, x, v: -4 * w * v - w * w * x))
    assert sorted(m.eigenvalue.real for m in over) == pytest.approx([-w * (2 + math.sqrt(3)), -w * (2 - math.sqrt(3))])
    assert not any(mode.vibrates for mode in over)


def hanging(n: int) -> np.ndarray:
    """Angular frequencies of n equal masses on a massless string, n equal parts: tensions and lumped masses."""
    part, tension = LENGTH / n, G * np.arange(n, 0, -1) / n  # of 1 kg in all
    K = np.diag(tension + np.append(tension[1:], 0)) - np.diag(tension[1:], 1) - np.diag(tension[1:], -1)
    return np.sqrt(eigh(K / part, np.eye(n) / n, eigvals_only=True))


def test_a_hanging_chain_and_the_zeros_of_bessels_function():
    """Daniel Bernoulli 1732: w = j_0k / 2 sqrt(g/L); n links tend to it as 1/n."""
    part, mass = hd.Parameter("part", "m", LENGTH / LINKS), hd.Parameter("mass", "kg", 1 / LINKS)
    bodies = [hd.Body(f"link_{i}", mass, centre=(0, -part, 0)) for i in range(LINKS)]
    places = [hd.GROUND, *(body.at(0, -part, 0) for body in bodies[:-1])]
    hinges = [
        hd.Revolute(f"hinge_{i}", place, body, axis=hd.Z)
        for i, (place, body) in enumerate(zip(places, bodies, strict=True))
    ]
    scales = hd.Scales(length=part, speed=hd.Parameter("pace", "m/s", 1), arm=part)
    model = engine_model(
        hd.Scene(
            hd.Mechanism("chain", tuple(hinges)), (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", G), direction=-hd.Y),), scales,
        )
    )  # fmt: skip
    actual = 2 * math.pi * modes(model, initial={"hinge_0.angle": "1 rad", "hinge_3.angle": "-2 rad"}).frequencies
    assert actual == pytest.approx(hanging(LINKS), rel=1e-8)
    bessel = jn_zeros(0, 3) / 2 * math.sqrt(G / LENGTH)
    errors = [np.abs(hanging(n)[:3] / bessel - 1) for n in (200, 400)]
    assert np.all(errors[1] < 0.01) and errors[0] / errors[1] == pytest.approx(np.full(3, 2), rel=0.02)


@pytest.fixture(scope="module")
def springs():
    """Three masses under each other on springs and dampers."""
    n, zero = (
        3,
        {"damping": hd.Parameter("damping", "N s/m", 2.0), "stiffness": hd.Parameter("stiffness", "N/m", 500.0)},
    )
    bodies = [hd.Body(f"mass_{i}", hd.Parameter("mass", "kg", 2.0)) for i in range(n)]
    joints = [hd.Prismatic(f"slide_{i}", (hd.GROUND, *bodies)[i], body, axis=-hd.Y) for i, body in enumerate(bodies)]
    effects = [hd.JointSpring(f"spring_{i}", f"slide_{i}", zero["stiffness"]) for i in range(n)]
    effects += [hd.JointDamper(f"damper_{i}", f"slide_{i}", zero["damping"]) for i in range(n)]
    gravity = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", G), direction=-hd.Y)
    scales = hd.Scales(length=hd.Parameter("size", "m", 0.1), speed=hd.Parameter("pace", "m/s", 1))
    return hd.Scene(hd.Mechanism("springs", tuple(joints)), (*effects, gravity), scales)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_masses_on_springs(springs, coordinates):
    """w_k = 2 sqrt(k/m) sin((2k-1) pi / (2 (2n+1))), damping in proportion to stiffness: ratio c/k w/2."""
    model = engine_model(springs, coordinates=coordinates)
    rest = equilibrium(model)
    assert rest.q == pytest.approx(2 * G / 500 * np.array([3, 2, 1]), rel=1e-12)
    actual = modes(rest)
    w = 2 * math.sqrt(500 / 2) * np.sin((2 * np.arange(1, 4) - 1) * math.pi / 14)
    assert [2 * math.pi * mode.natural_frequency for mode in actual] == pytest.approx(w, rel=1e-10)
    assert actual.damping_ratios == pytest.approx(2 / 500 * w / 2, rel=1e-9)
    shape = np.array([actual[0].shape[f"slide_{i}.travel"] for i in range(3)])  # stretches: cosines
    wanted = np.cos(math.pi / 14 * np.array([1, 3, 5]))
    assert np.abs(shape / shape[0] - wanted / wanted[0]).max() < 1e-9


TURN = 5.0  # rad/s^2
TURNED = {
    "position": {"position": hd.Parameter("turn", "rad/s^2", TURN) * hd.T**2},
    "speed": {"speed": 2 * hd.Parameter("turn", "rad/s^2", TURN) * hd.T},
    "acceleration": {"acceleration": 2 * hd.Parameter("turn", "rad/s^2", TURN)},
}


def turntable(drive):
    """A bead on a spring along the groove of a turntable that is turned ever faster."""
    table, bead = (
        hd.Body(name, hd.Parameter("mass", "kg", 2), hd.Parameter("I", "kg m^2", 0.1)) for name in ("table", "bead")
    )
    joints = (hd.Revolute("axle", hd.GROUND, table, axis=hd.Z), hd.Prismatic("groove", table, bead, axis=hd.X))
    spring = hd.JointSpring("spring", "groove", hd.Parameter("stiffness", "N/m", 200))
    size = hd.Parameter("size", "m", 0.1)
    return hd.Scene(
        hd.Mechanism("turntable", joints), (hd.Drive("drive", "axle", **TURNED[drive]), spring),
        hd.Scales(length=size, speed=hd.Parameter("pace", "m/s", 1), arm=size), start=hd.Start(position={"groove": hd.Parameter("away", "m", 0.1)}),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("drive", "coordinates"),
    [("position", "tree"), ("speed", "tree"), ("acceleration", "tree"), ("speed", "absolute")],
)
def test_a_bead_on_a_turntable_whose_turning_is_frozen(drive, coordinates):
    """Along the groove r'' = (w^2 - k/m) r; y = r sin(th) has y'' = s''/s y + 2 s'/s (y' - s'/s y) + (w^2 - k/m) y, s = sin(th)."""
    run = simulate(engine_model(turntable(drive), coordinates=coordinates), duration="0.7 s", tolerance=1e-8)
    actual, w, angle = modes(run, at="0.6 s"), 2 * TURN * 0.6, TURN * 0.6**2
    if coordinates == "tree":
        wanted, notes = 1j * math.sqrt(200 / 2 - w**2), 1
    else:
        s = np.array([math.sin(angle), w * math.cos(angle), 2 * TURN * math.cos(angle) - w**2 * math.sin(angle)])
        s = s / s[0]
        wanted, notes = np.roots([1, -2 * s[1], 2 * s[1] ** 2 - s[2] + 200 / 2 - w**2])[0], 2
        assert "bead.y" in actual.notes[-1]
    (mode,) = actual
    assert mode.eigenvalue == pytest.approx(wanted if wanted.imag > 0 else wanted.conjugate(), rel=1e-5)
    assert len(actual.notes) == notes


def test_orientations_that_nothing_holds_are_zeros_and_sticking_joints_are_held():
    """A ball in a socket, turned by 1 rad: three turns, two swings sqrt(g/(c + d)) of the point contact's normal, one bounce."""
    turned = {"float.q0": math.cos(0.5), "float.q1": 0, "float.q2": math.sin(0.5), "float.q3": 0}
    rest = equilibrium(engine_model("ball_in_socket"), initial=turned)
    actual = modes(rest)
    assert rest.outcome.name == "not_unique" and rest.indifferent == ("float.orientation",)
    assert [bool(mode.eigenvalue) for mode in actual] == [False] * 3 + [True] * 3
    swing = math.sqrt(G / float(np.linalg.norm(rest.q[:3]))) / (2 * math.pi)
    assert actual.frequencies[:2] == pytest.approx([swing, swing], rel=1e-9)
    # A particle on a slope under Coulomb's friction: it vibrates along the normal alone, with sqrt(K/m), and is nowhere free.
    (mode,) = modes(engine_model(ball(dry(), turns=False)), parameters={"slope": "0.1 rad"})
    assert mode.natural_frequency == pytest.approx(math.sqrt(STIFFNESS / MASS) / (2 * math.pi), rel=1e-6)


def test_texts_tables_and_pictures(pendulum, tmp_path):
    actual = modes(pendulum)
    assert "0.498488 Hz" in str(actual)[:30] or "0.4984879" in str(actual)
    assert repr(actual) == "<Modes pendulum: 0.49849 Hz>"
    assert "hinge.angle" in actual._repr_html_() and "hinge.angle" in equilibrium(pendulum)._repr_html_()
    actual.plot().savefig(tmp_path / "modes.png")
    equilibrium(pendulum).plot().savefig(tmp_path / "rest.png")
    frame = actual.to_pandas()
    assert list(frame.frequency) == list(actual.frequencies) and frame.attrs["units"]["hinge.angle"] == "rad"


def test_the_inset_shows_where_the_pin_is_in_a_bush_that_has_turned():
    """At the start its axes are the ground's, whatever way the bush stands: from its centre to the pin's."""
    model = engine_model("four_bar_clearance")
    bound, q, _ = start_of(model, {}, {})
    q = q + np.array([1e-3, -2e-3])  # rad: the pin leaves the middle of its bush
    places = Places.at(model, bound, 0.0, q[None])
    drawing = Drawing.of(places, (6.0, 4.0))
    (inset,) = clearances(drawing.parts, drawing.point)
    pin, bush = (drawing.parts.at(mark, 0) for mark in inset.marks)
    assert np.linalg.norm(pin - bush) > 0
    assert inset.path[0] == pytest.approx((pin - bush) * (inset.exaggerated or 1.0), rel=1e-9)
