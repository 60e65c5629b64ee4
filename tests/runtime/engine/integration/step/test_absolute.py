"""The same scene run in joint and in absolute coordinates: one motion, one energy, one drive; loops that stay closed; starts and their faults."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from loops import cranks, four_bar, open_by, rad

import hertzwerk.derive as hd
from hertzwerk.derive.laws import coulomb
from hertzwerk.derive.scenes.bricard import scene as bricard
from hertzwerk.derive.scenes.n_four_bar import L, n_four_bar, v
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

TOLERANCE = 1e-11


def both(scene: hd.Scene, duration: float, tolerance: float = TOLERANCE, **options):
    """The scene's run by its joints, and by its bodies."""
    return [
        simulate(engine_model(scene.with_coordinates(kind)), duration=duration, tolerance=tolerance, **options)
        for kind in ("tree", "absolute")
    ]


def poses(run, t: np.ndarray) -> np.ndarray:
    """Positions and rotation matrices of all bodies, row by row."""
    found, model = run.at(t), run.engine.model
    q = np.column_stack([found[name] for name in model.coordinates])
    c = run.engine.history.controls[: model.nc]
    return np.array(
        [
            np.concatenate([np.array(x).ravel() for x in model.function("poses")(s, row, c)])
            for s, row in zip(t, q, strict=True)
        ]
    )


def pendulum(n: int) -> hd.Scene:
    m, J, length, g = (
        hd.Parameter(*row)
        for row in (("mass", "kg", 1.0), ("J", "kg m^2", 0.02), ("reach", "m", 0.5), ("g", "m/s^2", 9.81))
    )
    joints, before, at = [], hd.GROUND, 0
    for i in range(n):
        body = hd.Body(f"link_{i}", m, J, centre=(0, -length / 2, 0))
        joints.append(hd.Revolute(f"pin_{i}", before.at(0, at, 0), body, hd.Z))
        before, at = body, -length
    start = hd.Start(
        position={"pin_0": hd.Parameter("lift", "rad", 1.0)}, speed={f"pin_{n - 1}": hd.Parameter("kick", "rad/s", 2.0)}
    )
    scales = hd.Scales(length, hd.Parameter("pace", "m/s", 1.0), length)
    return hd.Scene(
        hd.Mechanism("pendulum", tuple(joints)), (hd.Gravity("gravity", g, -hd.Y), hd.EnergyLedger()), scales, start
    )


def driven_within() -> hd.Scene:
    """A double pendulum whose elbow is moved, its shoulder on a spring with a damper."""
    scene = pendulum(2)
    swing, pace = hd.Parameter("swing", "rad", 0.8), hd.Parameter("pulse", "1/s", 5.0)
    effects = (
        hd.Drive("elbow", "pin_1", position=swing * (1 - sp.cos(pace * hd.T))),
        hd.JointSpring("shoulder", "pin_0", hd.Parameter("k", "N m/rad", 6.0)),
        hd.JointDamper("oil", "pin_0", hd.Parameter("d", "N m s/rad", 0.3)),
    )
    return replace(
        scene, effects=(*scene.effects, *effects), start=hd.Start(position={"pin_0": hd.Parameter("lift", "rad", 1.0)})
    )


def ball_chain() -> hd.Scene:
    m, length, g = hd.Parameter("mass", "kg", 1.0), hd.Parameter("reach", "m", 0.5), hd.Parameter("g", "m/s^2", 9.81)
    J = tuple(hd.Parameter(f"J{k}", "kg m^2", value) for k, value in zip("xyz", (0.03, 0.01, 0.02), strict=True))
    one, two = (hd.Body(name, m, J, centre=(0, -length / 2, 0)) for name in ("upper", "lower"))
    joints = (hd.Spherical("shoulder", hd.GROUND, one), hd.Spherical("elbow", one.at(0, -length, 0), two))
    speed = {
        "shoulder.angular_speed_x": hd.Parameter("wx", "rad/s", 4.0),
        "elbow.angular_speed_y": hd.Parameter("wy", "rad/s", 9.0),
    }
    position = {"shoulder.q0": hd.Parameter("q0", "1", 1.0), "shoulder.q3": hd.Parameter("q3", "1", 0.5)}
    scales = hd.Scales(length, hd.Parameter("pace", "m/s", 1.0), length)
    return hd.Scene(
        hd.Mechanism("balls", joints), (hd.Gravity("gravity", g, -hd.Y), hd.EnergyLedger()), scales, hd.Start(position, speed),
    )  # fmt: skip


CASES = {
    "pendulum chain": (pendulum(3), 2.0, 1e-8), "n-four-bar": (n_four_bar(2), 2.0, 1e-8),
    "four-bar, assembled from one angle": (four_bar(0.5, 1.5, 1.2, 1.6, position={"main": rad(0.4)}), 2.0, 1e-8),
    "four-bar, driven": (four_bar(0.5, 1.5, 1.2, 1.6, 2.0), 3.0, 1e-8), "bricard, of slender rods": (bricard, 2.0, 1e-8),
    "driven within": (driven_within(), 2.0, 1e-8), "balls": (ball_chain(), 2.0, 1e-8),
}  # fmt: skip


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.exhaustive) if n.startswith("bricard") else n for n in CASES]
)
def test_the_same_motion_energy_and_work(name):
    scene, duration, limit = CASES[name]
    tree, absolute = both(scene, duration)
    assert tree.outcome.finished
    assert absolute.outcome.finished
    t = np.linspace(0, duration, 25)
    assert np.max(np.abs(poses(absolute, t) - poses(tree, t))) < limit
    assert np.ptp(poses(tree, t), axis=0).max() > 0.3  # and it moves
    assert absolute.energy_residual < 3e-9
    assert open_by(absolute) < 1e-11
    for row in tree.engine.model.memory:
        assert absolute.at(t)[row] == pytest.approx(tree.at(t)[row], abs=1e-7 * max(1.0, np.max(np.abs(tree[row]))))


def test_slider_crank_with_clearance_through_its_impacts_and_with_friction_that_sticks_and_slips():
    tree, absolute = both(slider_crank, 0.012)
    assert len(absolute.impacts) == len(tree.impacts) > 5
    t = np.linspace(0, 0.012, 40)
    one, other = tree.at(t), absolute.at(t)
    assert other["slider.x"] == pytest.approx(one["guide.travel"], abs=1e-9)
    assert absolute.energy_residual < 1e-8
    assert absolute["energy_ledger.input"][-1] == pytest.approx(tree["energy_ledger.input"][-1], rel=1e-6)
    friction = hd.Parameter("friction_coefficient", "1", 0.1)
    dry = replace(slider_crank.effect("slider_pin_friction"), law=coulomb(mu_k=friction, mu_s=friction))
    tree, absolute = both(slider_crank.replace(slider_pin_friction=dry), 0.004, tolerance=1e-10)
    assert len(absolute.impacts) == len(tree.impacts) > 5
    assert absolute["slider.x"][-1] == pytest.approx(tree["guide.travel"][-1], abs=1e-11)
    assert absolute.energy_residual < 1e-9


def test_redundant_constraints_are_named_and_the_force_of_a_drive_holds_its_joint():
    run = simulate(engine_model(cranks().with_coordinates("absolute")), duration=0.1)
    assert any("middle.force_x" in warning for warning in run.warnings)
    # Work of the drive between two bodies against what its multiplier does at its speed, summed over the steps of a fine grid.
    absolute = simulate(
        engine_model(driven_within().with_coordinates("absolute")), duration=1.0, tolerance=1e-10, grid=4001
    )
    power = absolute["pin_1.moment_angle"] * absolute["pin_1.speed"]
    t = absolute.t
    work = np.sum((power[1:] + power[:-1]) / 2 * np.diff(t))
    assert absolute["energy_ledger.input"][-1] == pytest.approx(work, rel=1e-5)
    assert abs(work) > 0.1


@pytest.mark.exhaustive
def test_loops_stay_closed_and_quaternions_of_norm_1_in_a_long_run():
    run = simulate(engine_model(ball_chain().with_coordinates("absolute")), duration=100.0, tolerance=1e-11)
    q = run.engine.history.part("y")[:, : run.engine.model.nq]
    for i in run.engine.model.quaternions:
        assert np.max(np.abs(np.linalg.norm(q[:, i : i + 4], axis=1) - 1)) < 1e-14
    assert open_by(run) < 1e-12
    assert run.energy_residual < 1e-7


# -- starts ------------------------------------------------------------------------------------------------------------


def test_initial_values_are_those_of_the_joints():
    given = {"left_1.angle": "0.2 rad", "foot_2.speed": "-1 rad/s", "foot_0.speed": "-1 rad/s"}
    run = simulate(
        engine_model(n_four_bar(2).with_coordinates("absolute")), duration=1e-3, initial=given, tolerance=1e-6
    )
    assert [run[f"post_{i}.angle"][0] for i in range(3)] == pytest.approx([-0.2] * 3, abs=1e-12)
    with pytest.raises(hd.InputError, match=r"foot_0\.angle"):
        simulate(
            engine_model(n_four_bar(2).with_coordinates("absolute")), duration=1e-3, initial={"post_0.x": "1 m"}, tolerance=1e-6,
        )  # fmt: skip


@pytest.mark.parametrize(
    "scene",
    [
        replace(n_four_bar(2), start=hd.Start(position={"foot_0": rad(0.3), "foot_1": rad(0.4)})),
        replace(n_four_bar(2), start=hd.Start(speed={"foot_0": -v / L, "foot_1": v / L})),
        four_bar(0.5, 1.5, 1.2, 1.6),
        four_bar(0.1, 0.2, 0.3, 5.0, 2.0),
    ],
    ids=["positions over-determined", "speeds over-determined", "under-determined", "out of reach"],
)
def test_assembly_faults_are_the_same_in_words(scene):
    """They speak of joints, which is what starts are given of."""
    texts = []
    for kind in ("tree", "absolute"):
        with pytest.raises(hd.InputError) as error:
            simulate(engine_model(scene.with_coordinates(kind)), duration=1.0, tolerance=1e-6)
        texts.append([str(fault) for fault in error.value.faults])
    assert texts[0] == texts[1]
