"""Bodies on quaternions through the whole chain, scene to solution: closed forms, conserved quantities, and the same motion on simpler joints."""

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import hunt_crossley, power, smooth_coulomb
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(4)  # methods and coordinates that run the same code

SIZE = hd.Parameter("size", "m", 0.1)
MASS = hd.Parameter("mass", "kg", 0.9)
SCALES = hd.Scales(length=SIZE, speed=hd.Parameter("pace", "m/s", 1.0), arm=SIZE)
FALL = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y)


def spinning(*inertia, effects=()):
    """A free body about its mass centre, its start to be given."""
    triple = tuple(hd.Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", inertia, strict=True))
    joint = hd.Free("float", hd.GROUND, hd.Body("body", MASS, triple))
    return engine_model(hd.Scene(hd.Mechanism("spinning", (joint,)), (hd.EnergyLedger(), *effects), SCALES))


def rate(*w):
    return {f"float.angular_speed_{k}": (value, "rad/s") for k, value in zip("xyz", w, strict=True)}


def of(run, *names, joint="float"):
    """Columns of histories."""
    return np.column_stack([run[f"{joint}.{name}"] for name in names])


def rotations(run):
    """Rotation matrices of the first body, shape (rows, 3, 3)."""
    return run.engine.history.map("poses", "t q")[1][:, :9].reshape(-1, 3, 3)


QUATERNION, ANGULAR = ("q0", "q1", "q2", "q3"), ("angular_speed_x", "angular_speed_y", "angular_speed_z")
TOP = {"J": (0.05, 0.05, 0.02), "w": (2.0, 0.0, 9.0)}


def turn(axis, angle):
    """Rotation about an axis."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    tilde = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * tilde + (1 - np.cos(angle)) * tilde @ tilde


ERRORS = {
    "dop853": (1e-10, 1e-8), "dopri5": (1e-9, 1e-6), "rodas": (1e-8, 1e-5), "esdirk": (1e-7, 1e-4), "cvodes": (1e-10, 1e-6),
}  # fmt: skip


@pytest.mark.parametrize("method", ERRORS)
def test_a_symmetric_top_precesses_as_in_closed_form(method):
    """Landau, Lifshitz, Mechanics, section 33: about the angular momentum with |L|/A, and about its own axis with w_z (A - C)/A."""
    tolerance, error = ERRORS[method]
    (A, _, C), w = TOP["J"], np.array(TOP["w"])
    run = simulate(spinning(*TOP["J"]), duration=5.0, tolerance=tolerance, method=method, initial=rate(*w))
    assert run.outcome.finished, run
    L = np.array(TOP["J"]) * w
    expected = turn(L, np.linalg.norm(L) / A * 5.0) @ turn([0, 0, 1], w[2] * (A - C) / A * 5.0)
    assert np.max(np.abs(rotations(run)[-1] - expected)) < error
    assert np.linalg.norm(of(run, *QUATERNION), axis=1) == pytest.approx(1, abs=1e-12)


def test_a_tumbling_body_keeps_energy_and_angular_momentum():
    """Euler and Poinsot: about the middle axis, where the motion is unstable, through several somersaults; and the mass centre flies straight on."""
    inertia = np.array([0.05, 0.03, 0.02])
    initial = {**rate(0.01, 6.0, 0.01), "float.x_speed": "2 m/s"}
    run = simulate(spinning(*inertia), duration=20.0, tolerance=1e-11, initial=initial)
    assert run.outcome.finished, run
    w = of(run, *ANGULAR)
    assert np.min(w[:, 1]) < -5.9 < 5.9 < np.max(w[:, 1])  # it does tumble
    L = np.einsum("nij,nj->ni", rotations(run), inertia * w)
    assert np.max(np.abs(L - L[0])) < 1e-9 * np.linalg.norm(L[0])
    assert np.max(np.abs(run["energy"] / run["energy"][0] - 1)) < 1e-9
    assert run["float.x"] == pytest.approx(2 * run.t, rel=1e-12)


def test_a_quaternion_keeps_its_norm_however_long_and_rough_the_run():
    model = spinning(0.05, 0.03, 0.02)
    run = simulate(model, duration=2000.0, tolerance=1e-2, initial=rate(3.0, 6.0, 1.0))
    assert run.statistics.steps > 2000
    assert np.max(np.abs(np.linalg.norm(of(run, *QUATERNION), axis=1) - 1)) < 4e-16 * 4
    # The check above can fail: the same run on a model that says it has no quaternions.
    model = spinning(0.05, 0.03, 0.02)
    model.quaternions = ()
    run = simulate(model, duration=2000.0, tolerance=1e-2, initial=rate(3.0, 6.0, 1.0))
    assert np.max(np.abs(np.linalg.norm(of(run, *QUATERNION), axis=1) - 1)) > 1e-3


def test_a_start_is_normalised_and_a_norm_of_zero_is_a_fault():
    from hertzwerk.derive import InputError

    model = spinning(0.05, 0.03, 0.02)
    run = simulate(model, duration=0.1, initial={"float.q0": 3.0, "float.q3": 4.0}, tolerance=1e-6)
    assert of(run, *QUATERNION)[0] == pytest.approx([0.6, 0, 0, 0.8], rel=1e-15)
    with pytest.raises(InputError, match="norm 0"):
        simulate(model, duration=0.1, initial={"float.q0": 0.0}, tolerance=1e-6)


def pendulum(joint, effects=(FALL,)):
    triple = tuple(hd.Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", (0.05, 0.03, 0.02), strict=True))
    bob = hd.Body("bob", MASS, triple, (0, -hd.Parameter("l", "m", 0.5), 0))
    scene = hd.Scene(hd.Mechanism("swing", (joint(bob),)), (hd.EnergyLedger(), *effects), SCALES)
    return engine_model(scene)


@pytest.mark.parametrize("method", ["dop853", "rodas", "auto"])
def test_a_spherical_pendulum_in_a_plane_is_a_plane_pendulum(method):
    tolerance = 1e-7 if method == "rodas" else 1e-10
    flat = simulate(
        pendulum(lambda bob: hd.Revolute("pin", hd.GROUND, bob, hd.Z)), duration=5.0, tolerance=1e-11, initial={"pin.angle": 2.5},
    )  # fmt: skip
    half = {"pin.q0": np.cos(1.25), "pin.q3": np.sin(1.25)}
    ball = simulate(
        pendulum(lambda bob: hd.Spherical("pin", hd.GROUND, bob)), duration=5.0, tolerance=tolerance, method=method, initial=half,
    )  # fmt: skip
    times = np.linspace(0, 5, 101)
    swing, dense = flat.at(times)["pin.angle"], ball.at(times)
    assert 2 * np.unwrap(np.arctan2(dense["pin.q3"], dense["pin.q0"]), period=np.pi) == pytest.approx(
        swing, abs=1e3 * tolerance
    )
    assert np.max(np.abs(dense["pin.angular_speed_x"])) < 1e3 * tolerance
    assert ball.energy_residual < 1e3 * tolerance


def ball_on_floor(joint, *, friction=False):
    radius = hd.Parameter("radius", "mm", 20)
    inertia = tuple(0.4 * MASS * radius**2 for _ in range(3))
    ball = hd.Body("ball", MASS, inertia)
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    effects = [
        FALL, hd.Contact("floor", power(hd.Parameter("stiffness", "N/m^1.5", 1e8), 1.5), hunt_crossley(hd.Parameter("restitution", "1", 0.8))),
    ]  # fmt: skip
    if friction:
        effects.append(
            hd.Friction(
                "rub", "floor", smooth_coulomb(hd.Parameter("friction", "1", 0.2), hd.Parameter("v_s", "m/s", 1e-2))
            )
        )
    scales = hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 3.0), arm=radius)
    return engine_model(hd.Scene(hd.Mechanism("ball", (joint(ball),), (floor,)), (*effects, hd.EnergyLedger()), scales))


@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_friction_turns_a_free_ball_by_what_it_takes_from_its_flight(method):
    """I dw = R x m dv: the impulse acts at the contact point, R away but for a penetration; sliding, it is mu times the normal one."""
    free = ball_on_floor(lambda ball: hd.Free("fall", hd.GROUND, ball), friction=True)
    start = {"fall.y": "0.1 m", "fall.x_speed": "2 m/s", "fall.z_speed": "-1 m/s", "fall.q0": 0.8, "fall.q1": 0.6}
    run = simulate(free, duration=0.2, tolerance=1e-8, method=method, initial=start)
    assert run.outcome.finished, run
    assert len(run.impacts) == 1
    v, w = of(run, "x_speed", "y_speed", "z_speed", joint="fall"), of(run, *ANGULAR, joint="fall")
    spin = np.einsum("nij,nj->ni", rotations(run), w)[-1]
    change = v[-1] - v[0] + np.array([0, 9.81 * 0.2, 0])
    assert 0.4 * 0.02**2 * spin == pytest.approx(np.cross([0, -0.02, 0], change), rel=5e-3, abs=1e-9)
    assert np.hypot(change[0], change[2]) == pytest.approx(0.2 * change[1], rel=1e-3)
    assert run.energy_residual < 1e-6


def test_a_run_on_quaternions_is_saved_read_and_drawn(tmp_path):
    from hertzwerk.runtime.engine.solution.solution import EngineSolution
    from hertzwerk.runtime.output.plots.curves import Curves

    run = simulate(
        pendulum(lambda bob: hd.Spherical("pin", hd.GROUND, bob)), duration=0.5, initial={"pin.q3": 0.2}, tolerance=1e-6
    )
    read = EngineSolution.load(run.save(tmp_path / "run.npz"))
    assert np.array_equal(read["pin.angular_acceleration_z"], run["pin.angular_acceleration_z"])
    assert run.engine.history.units["pin.angular_acceleration_z"] == "rad/s^2"
    shown = [("pin.q1", "pin.angular_speed_x", "pin.angular_acceleration_x")]
    assert (
        [motion.names for motion in Curves.of(read).motions][:1]
        == [motion.names for motion in Curves.of(run).motions][:1]
        == shown
    )
    run.plot().savefig(tmp_path / "run.png")
