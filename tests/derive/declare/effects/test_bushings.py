"""Bushings, spherical springs and potentials of a pose, against scipy's eigenvalues and closed forms."""

from dataclasses import replace

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.linalg import eigh
from scipy.spatial.transform import Rotation

import hertzwerk.derive as hd
from hertzwerk.derive.declare.effects.bushings import ARCS, BENDS, NEAR
from hertzwerk.runtime import load, modes, simulate

p = hd.Parameter
SIZE = p("size", "m", 0.1)
SCALES = hd.Scales(SIZE, p("pace", "m/s", 1), arm=SIZE)
MASS, INERTIA = 2.0, (0.02, 0.03, 0.04)
UNITS = ("N/m", "N", "N m")
RANDOM = np.random.default_rng(7)
ROOT = RANDOM.normal(size=(6, 6)) * np.repeat([30.0, 3.0], 3)[:, None]
STIFF = ROOT @ ROOT.T + np.diag([500, 600, 700, 5, 6, 7.0])


def named(matrix, letter, rate=""):
    """Symmetric matrix of parameters."""
    entry = {}
    for i in range(6):
        for j in range(i, 6):
            unit = {"N/m": "N s/m", "N": "N s", "N m": "N m s"}[u] if (u := UNITS[(i > 2) + (j > 2)]) and rate else u
            entry[i, j] = entry[j, i] = p(f"{letter}_{i + 1}{j + 1}", unit, float(matrix[i, j]))
    return tuple(tuple(entry[i, j] for j in range(6)) for i in range(6))


BODY = hd.Body(
    "body", p("mass", "kg", MASS), inertia=tuple(p(f"J_{k}", "kg m^2", j) for k, j in zip("xyz", INERTIA, strict=True))
)
MOUNT = hd.Bushing("mount", BODY.at(0, 0, 0), hd.GROUND.at(0, 0, 0), named(STIFF, "k"))


def model_of(joint, *effects, coordinates="tree", **start):
    """A body in space, with its mass centre at its origin."""
    mechanism = hd.Mechanism("mounted", (joint,))
    return load(hd.Scene(mechanism, (*effects, hd.EnergyLedger()), SCALES, hd.Start(**start), coordinates=coordinates))


def floating(*effects, **start):
    return model_of(hd.Free("free", hd.GROUND, BODY), *effects, **start)


def test_vibrations_on_a_bushing():
    """Six frequencies of M x'' + K x = 0, by scipy.linalg.eigh."""
    actual = modes(floating(MOUNT))
    squares = eigh(STIFF, np.diag([MASS] * 3 + list(INERTIA)), eigvals_only=True)
    assert np.sort(actual.frequencies) == pytest.approx(np.sqrt(squares) / (2 * np.pi), rel=1e-7)


LARGE = {
    "position": {"free.x": p("x0", "m", 0.05)}
    | {f"free.q{i}": p(f"q{i}", "1", q) for i, q in enumerate((0.4, 0.5, -0.6))},
    "speed": {"free.angular_speed_x": p("w0", "rad/s", 3)},
}


@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_large_rotations_conserve_energy(method):
    """The force is the gradient of the stored energy at rotations of two radians, with all entries at work."""
    run = simulate(floating(MOUNT, **LARGE), duration=0.3, tolerance=1e-9, method=method)
    pose = np.array([run[f"mount.{what}_{k}"] for what in ("displacement", "rotation") for k in "xyz"])
    turned = Rotation.from_quat(np.array([run[f"free.q{i}"] for i in (1, 2, 3, 0)]).T).as_rotvec()
    assert pytest.approx(turned, abs=1e-9) == pose[3:].T
    assert np.max(np.linalg.norm(turned, axis=1)) > 2
    assert run["mount.stored_energy"] == pytest.approx(np.einsum("it,ij,jt->t", pose, STIFF, pose) / 2, rel=1e-9)
    assert run.energy_residual < 1e-7


def test_work_along_any_path_is_the_difference_of_energy():
    """A damped run loses what its damper books, by rates of the rotation vector; the rest is in the spring."""
    damped = replace(MOUNT, damping=named(0.01 * STIFF, "c", rate="1"))
    run = simulate(floating(damped, **LARGE), duration=0.5, tolerance=1e-9)
    assert run.energy_residual < 1e-7
    assert run["mount.dissipated"][-1] > 0.9 * run["energy"][0] > 0
    assert np.all(np.diff(run["mount.dissipated"]) >= 0)


PIVOT, ENDS = hd.Spherical("pivot", hd.GROUND, BODY), (BODY.at(0, 0, 0), hd.GROUND.at(0, 0, 0))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_spherical_spring_swings_by_its_angle(coordinates):
    """About a principal axis it is a torsional vibration of any amplitude: angle = a cos(sqrt(k/J) t)."""
    k, amplitude, omega = 2.0, 2.5, np.sqrt(2.0 / INERTIA[2])
    half = {"pivot.q0": p("q0", "1", np.cos(amplitude / 2)), "pivot.q3": p("q3", "1", np.sin(amplitude / 2))}
    spring = hd.SphericalSpring("spring", *ENDS, p("k", "N m/rad", k))
    run = simulate(model_of(PIVOT, spring, coordinates=coordinates, position=half), duration=1.0, tolerance=1e-9)
    assert run["spring.rotation_z"] == pytest.approx(amplitude * np.cos(omega * run.t), abs=1e-6)
    assert run.energy_residual < 1e-7


def test_a_damper_opposes_the_angular_velocity_at_any_rotation():
    """Of a body alike about all axes w = w_0 exp(-c t/J), whatever it is turned by: here 1.2 rad about another axis."""
    J, c, turned = 0.03, 0.2, 1.2
    body = hd.Body("top", p("mass", "kg", MASS), inertia=(p("J", "kg m^2", J),) * 3)
    damper = hd.SphericalSpring("spring", body.at(0, 0, 0), hd.GROUND.at(0, 0, 0), 0, p("c", "N m s/rad", c))
    position = {"pivot.q0": p("q0", "1", np.cos(turned / 2)), "pivot.q2": p("q2", "1", np.sin(turned / 2))}
    start = {"position": position, "speed": {"pivot.angular_speed_x": p("w0", "rad/s", 5)}}
    run = simulate(model_of(hd.Spherical("pivot", hd.GROUND, body), damper, **start), duration=0.3, tolerance=1e-10)
    assert run["pivot.angular_speed_x"] == pytest.approx(5 * np.exp(-c * run.t / J), abs=1e-7)
    assert np.abs([run[f"pivot.angular_speed_{k}"] for k in "yz"]).max() < 1e-7


def test_series_beside_no_rotation_are_those_of_the_arc_and_its_bend():
    """asin(s)/s and (1 - asin(s) sqrt(1 - s^2)/s)/s^2, up to where the quotients take over."""
    with mp.workdps(30):
        for square in (mpf(NEAR.p) / NEAR.q, mpf("1e-3"), mpf("1e-9")):
            s = mp.sqrt(square)
            arc = mp.asin(s) / s
            for known, exact in ((ARCS, arc), (BENDS, (1 - arc * mp.sqrt(1 - square)) / square)):
                actual = sum(mpf(k.p) / k.q * square**i for i, k in enumerate(known))
                assert abs(actual / exact - 1) < mpf("2e-15")


def test_a_potential_of_directions_is_gravity():
    """The weight of a mass centre off the pivot, m g z of its place, as an energy of TURN and as gravity."""
    body = hd.Body("top", p("mass", "kg", MASS), inertia=(p("J", "kg m^2", 0.02),) * 3, centre=(0, 0, SIZE))
    g, mass = p("g", "m/s^2", 9.81), p("mass", "kg", MASS)
    spin = {"pivot.angular_speed_x": p("w1", "rad/s", 2), "pivot.angular_speed_z": p("w3", "rad/s", 40)}
    energy = hd.FramePotential("weight", body.at(0, 0, 0), hd.GROUND.at(0, 0, 0), mass * g * SIZE * hd.TURN[2][2])
    joint, weight = hd.Spherical("pivot", hd.GROUND, body), hd.Gravity("weight", g, direction=-hd.Z)
    runs = [simulate(model_of(joint, e, speed=spin), duration=0.4, tolerance=1e-10) for e in (energy, weight)]
    ends = [[run[f"pivot.q{i}"][-1] for i in range(4)] for run in runs]
    assert ends[0] == pytest.approx(ends[1], abs=1e-8)
    assert runs[0].energy_residual < 1e-8


def test_in_the_plane_whole_turns_count():
    """A planar bushing winds up beyond half a turn: angle = w sqrt(J/k) sin(sqrt(k/J) t), up to 8 rad."""
    wheel = hd.Body("wheel", p("mass", "kg", MASS), inertia=p("J", "kg m^2", 0.02))
    rows = (*(p("k", "N/m", 100),) * 3, *(p("k_t", "N m", 2),) * 3)
    bushing = hd.Bushing("mount", wheel.at(0, 0, 0), hd.GROUND.at(0, 0, 0), rows)
    plane, speed = hd.Planar("table", hd.GROUND, wheel, normal=hd.Z), {"table.angle": p("w", "rad/s", 80)}
    run = simulate(model_of(plane, bushing, speed=speed), duration=0.5, tolerance=1e-9)
    assert run["table.angle"] == pytest.approx(8 * np.sin(10 * run.t), abs=1e-6)
    assert np.max(run["mount.rotation_z"]) > 7.9


def test_faults_of_matrices_come_at_once():
    stiff = np.diag([1.0, 1, 1, 1, 1, 1])
    stiff[0, 4], stiff[4, 0] = 2, 2
    skew = [list(row) for row in named(np.eye(6), "c", rate="1")]
    skew[0][1] = p("other", "N s/m", 3)
    wrong = [list(row) for row in named(np.eye(6), "w")]
    wrong[3][3] = p("soft", "N/m", 3)
    base, one, unknown = MOUNT, MOUNT.first, p("k_u", "J", 1) * p("x", "1", 1) * hd.TURN[0][0] + hd.APART[0]
    with pytest.raises(hd.InputError) as caught:
        floating(
            replace(base, name="pushes", stiffness=named(stiff, "k"), damping=tuple(map(tuple, skew))),
            replace(base, name="wrong", stiffness=tuple(map(tuple, wrong))), replace(base, name="itself", second=one, stiffness=(0,) * 6),
            hd.FramePotential("energy", one, base.second, p("k_e", "N", 1) * hd.ROTATION[0]), hd.FramePotential("unknown", one, base.second, unknown),
        )  # fmt: skip
    text = str(caught.value)
    for part in (
        "pushes, stiffness", "pushes, damping", "symmetric", "positive semidefinite", "effect wrong", "soft",
        "both frames on body", "effect energy", "effect unknown",
    ):  # fmt: skip
        assert part in text, part
    with pytest.raises(hd.InputError, match="six rows of six"):
        floating(replace(base, stiffness=(1, 2)))
    gap = hd.APART[1] - SIZE * hd.ROTATION[0]
    pair = hd.CustomPair("p", *ENDS, gap=gap, normal=(0, 1, 0), contact_point=(hd.APART[0], 0, 0))
    with pytest.raises(hd.InputError, match="rotation_x"):
        hd.Scene(
            hd.Mechanism("m", (hd.Free("free", hd.GROUND, BODY),), (pair,)), (hd.Gravity("g", p("g", "m/s^2", 1), -hd.Y),), SCALES,
        )  # fmt: skip
