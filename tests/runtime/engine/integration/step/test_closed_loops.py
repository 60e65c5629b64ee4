"""Closed loops in motion: closed forms, conserved quantities, singular positions, redundant constraints, assembly, and the ways it can fail."""

from dataclasses import replace

import numpy as np
import pytest
from loops import four_bar, open_by, rad
from scipy.integrate import quad

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.scenes.n_four_bar import L, n_four_bar, v
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from reference import bricard


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("method", ["dop853", "dopri5", "rodas", "esdirk", "auto"])
def test_a02_at_4_seconds(method):
    """B0 of two windows as the benchmark library's other implementations have it; singular positions have been passed."""
    run = simulate(
        engine_model("n_four_bar"), duration=4.0, tolerance=1e-10 if method != "dopri5" else 1e-11, method=method
    )
    assert run.outcome.finished
    angle = run.engine.final["foot_0.angle"]
    limit = 1e-8 if method in ("dop853", "dopri5", "auto") else 1e-7
    assert (-np.sin(angle), np.cos(angle)) == pytest.approx((0.1176161024, 0.9930591385), abs=limit)
    assert open_by(run) < 1e-13
    assert run.energy_residual < 1e-9


def test_a_quick_return_turns_as_its_one_freedom_equation_says():
    """A crank pin on a block that slides along a turning arm, unforced: I(phi) phi'^2 stays, I = J_1 + m r^2 + (J_2 + J_3) (dpsi/dphi)^2."""
    R, base, W = hd.Parameter("r", "m", 0.1), hd.Parameter("base", "m", 0.25), hd.Parameter("w", "rad/s", 12.0)
    mass = hd.Parameter("mass", "kg", 0.8)
    inertias = (("crank", 4e-3), ("arm", 3e-2), ("block", 1e-3))
    crank, arm, block = (hd.Body(name, mass, hd.Parameter(f"J_{name}", "kg m^2", J)) for name, J in inertias)
    joints = (
        hd.Revolute("main", hd.GROUND, crank, axis=hd.Z), hd.Revolute("pivot", hd.GROUND.at(-base, 0, 0), arm, axis=hd.Z),
        hd.Prismatic("slot", arm, block, axis=hd.X), hd.Revolute("pin", crank.at(R, 0, 0), block, axis=hd.Z),
    )  # fmt: skip
    start = hd.Start(position={"slot": R + base}, speed={"main": W})
    model = engine_model(
        hd.Scene(hd.Mechanism("quick_return", joints), (hd.EnergyLedger(),), hd.Scales(R, R * W, R), start)
    )
    run = simulate(model, duration=0.6, tolerance=1e-10)

    def inertia(phi):
        r, c = 0.1, 0.25
        k = (r**2 + r * c * np.cos(phi)) / (r**2 + c**2 + 2 * r * c * np.cos(phi))
        return 4e-3 + 0.8 * r**2 + 3.1e-2 * k**2

    needed, _ = quad(
        lambda phi: np.sqrt(inertia(phi) / inertia(0)) / 12.0, 0, run.engine.final["main.angle"], epsabs=1e-12
    )
    assert needed == pytest.approx(0.6, rel=1e-8)


def test_bricard_keeps_its_energy_and_its_loop_and_redundant_constraints_are_named():
    """One redundant constraint; by counting it could not move at all."""
    run = simulate(engine_model("bricard"), duration=10.0, tolerance=1e-11)
    assert run.outcome.finished
    assert run.energy_residual < 1e-9
    assert open_by(run) < 1e-9
    expected = bricard.first_angle(0.3, 1e-9)
    assert expected > 0.05
    assert run.at([0.3])["hinge_a.angle"] == pytest.approx([expected], abs=1e-8)
    # Nothing but the hinges across the loop's symmetry can share; the windows' constraints are independent.
    assert any(
        "hinge_f.moment" in warning
        for warning in simulate(engine_model("bricard"), duration=0.1, tolerance=1e-6).warnings
    )
    assert not simulate(engine_model("n_four_bar"), duration=0.1, tolerance=1e-6).warnings


def test_a_four_bar_driven_round_follows_its_geometry_and_one_that_locks_ends_as_constraint_lost():
    """Crank at constant speed: the rocker's angle by the law of cosines, at every time the same branch."""
    run = simulate(engine_model(four_bar(0.5, 1.5, 1.2, 1.6, 2.0)), duration=6.0, tolerance=1e-10)
    assert run.outcome.finished
    angle = 2.0 * run.t
    tip = 0.5 * np.exp(1j * angle) - 1.6
    side = np.arccos((1.2**2 + np.abs(tip) ** 2 - 1.5**2) / (2 * 1.2 * np.abs(tip)))
    rocker, towards = np.exp(1j * run["foot.angle"]), tip / np.abs(tip)
    assert min(np.max(np.abs(rocker - towards * np.exp(sign * 1j * side))) for sign in (1, -1)) < 1e-9
    assert run.energy_residual < 1e-8
    # The crank is driven on, the other two are stretched out before it has gone round.
    run = simulate(engine_model(four_bar(1.5, 1.2, 1.0, 2.0, 2.0)), duration=10.0, tolerance=1e-6)
    assert run.outcome.name == "constraint_lost"
    locked = np.arccos((1.5**2 + 2.0**2 - 2.2**2) / (2 * 1.5 * 2.0)) / 2.0  # the triangle 1.5, 2, 1.2 + 1
    assert run.t[-1] == pytest.approx(locked, abs=1e-5)


def test_a_parallelogram_keeps_its_branch_through_the_change_point():
    """Stretched out it could go on as an antiparallelogram; driven by its own weight it stays what it was."""
    run = simulate(
        engine_model(four_bar(1.0, 2.0, 1.0, 2.0, position={"main": rad(0.4)})), duration=5.0, tolerance=1e-9
    )
    assert run.outcome.finished
    assert np.min(run["main.angle"]) < -np.pi  # past the change points at 0 and -pi
    assert run["foot.angle"] == pytest.approx(run["main.angle"], abs=1e-6)
    assert run.energy_residual < 1e-7


def test_after_a_thousand_turns_loops_are_closed_as_far_as_the_angles_are_known():
    """The last digit of the crank's angle moves its end by more than the tolerance: the motion is that of the first turn all the same."""
    first, late = (
        simulate(
            engine_model(four_bar(0.5, 1.5, 1.2, 1.6, position={"main": rad(angle)})), duration=1.0, tolerance=1e-13
        )
        for angle in (0.4, 0.4 + 2000 * np.pi)
    )
    assert first.outcome.finished
    assert late.outcome.finished
    turned = np.spacing(2000 * np.pi)
    assert 0.5 * turned / 2 > 1e-13 * 0.5  # half a digit times the crank, against the tolerance of closing
    assert late["foot.angle"][-1] == pytest.approx(first["foot.angle"][-1], abs=100 * turned)
    assert max(np.max(np.abs(late[name])) for name in late.engine.model.constraints) < 4 * turned


# -- assembly ----------------------------------------------------------------------------------------------------------


def test_initial_values_count_as_given():
    run = simulate(
        engine_model("n_four_bar"), duration=1e-3, initial={"left_1.angle": "0.2 rad", "foot_2.speed": "-1 rad/s", "foot_0.speed": "-1 rad/s"},
        tolerance=1e-6,
    )  # fmt: skip
    assert [run[name][0] for name in run.engine.model.coordinates] == pytest.approx(
        [-0.2, -0.2, -0.2, 0.2, 0.2], abs=1e-12
    )


def test_too_much_too_little_and_speeds_that_tear_a_loop_are_refused_with_what_is_open_or_free():
    start = hd.Start(position={"foot_0": rad(0.3), "foot_1": rad(0.4)})
    with pytest.raises(InputError) as error:
        simulate(engine_model(replace(n_four_bar(2), start=start)), duration=1.0, tolerance=1e-6)
    (fault,) = error.value.faults
    assert "over-determined" in fault.found
    assert "right_0 open by 0.0" in fault.found
    assert "foot_0.angle, foot_1.angle" in fault.remedy
    with pytest.raises(InputError, match=r"over-determined: right_0 open by 2 m/s"):
        simulate(
            engine_model(replace(n_four_bar(2), start=hd.Start(speed={"foot_0": -v / L, "foot_1": v / L}))), duration=1.0, tolerance=1e-6,
        )  # fmt: skip
    # Nothing given, and the zeros do not close the loop: one angle is missing.
    with pytest.raises(InputError) as error:
        simulate(engine_model(four_bar(0.5, 1.5, 1.2, 1.6)), duration=1.0, tolerance=1e-6)
    (fault,) = error.value.faults
    assert fault.found == "under-determined: main.angle, left.angle, foot.angle"
    assert fault.expected == "1 more value among them"


@pytest.fixture(scope="module")
def ball_crank():
    """A crank about Z, a rod on it by a ball, that pushes a slider on a line along X, 0.2 m above and 0.3 m beside, by a universal joint."""
    triple = tuple(hd.Parameter(f"inertia_{k}", "kg m^2", 0.02) for k in "xyz")
    m, l, far = hd.Parameter("mass", "kg", 1.0), hd.Parameter("rod", "m", 1.5), hd.Parameter("far", "m", 0.5)
    crank, rod, slider = (hd.Body(name, m, triple, centre=(far, 0, 0)) for name in ("crank", "rod", "slider"))
    joints = (
        hd.Revolute("main", hd.GROUND, crank, axis=hd.Z),
        hd.Spherical("ball", crank.at(2 * far, 0, 0), rod),
        hd.Prismatic("guide", hd.GROUND.at(0, 0.4 * far, 0.6 * far), slider, axis=hd.X),
        hd.Universal("cross", rod.at(l, 0, 0), slider, first=hd.Y, second=hd.Z),
    )
    gravity = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y)
    pace = hd.Parameter("pace", "m/s", 1.0)
    return engine_model(
        hd.Scene(
            hd.Mechanism("pushed", joints), (gravity, hd.EnergyLedger()), hd.Scales(length=far, speed=pace, arm=far)
        )
    )


@pytest.mark.parametrize("degrees", [10, 60, 100, 300])
def test_a_ball_in_a_loop_is_turned_until_it_closes(ball_crank, degrees):
    """One angle determines the rest: a quaternion has one number more than freedoms, and it is no freedom."""
    run = simulate(ball_crank, duration=1e-3, initial={"main.angle": (degrees, "deg")})
    a = np.radians(degrees)
    reach = np.sqrt(1.5**2 - (np.sin(a) - 0.2) ** 2 - 0.3**2)
    assert min(abs(run["guide.travel"][0] - np.cos(a) - sign * reach) for sign in (1, -1)) < 1e-11
    assert max(abs(run[name][0]) for name in ball_crank.constraints) < 1e-11
    assert sum(run[f"ball.q{i}"][0] ** 2 for i in range(4)) == pytest.approx(1, abs=1e-14)


def test_too_little_is_said_of_a_ball_too(ball_crank):
    with pytest.raises(InputError) as error:
        simulate(ball_crank, duration=1e-3)
    (fault,) = error.value.faults
    assert fault.expected == "1 more value among them"
    with pytest.raises(InputError, match="out of reach: cross open by"):
        simulate(ball_crank, duration=1e-3, initial={"guide.travel": "0 m"})


def test_more_drives_than_a_loop_has_freedoms_are_named():
    """The window has one freedom: both feet driven are too many where their speeds differ, and where the posts cannot be parallel."""
    drives = [
        hd.ConstantSpeed(f"drive_{i}", f"foot_{i}", hd.Parameter(f"pace_{i}", "rad/s", 1.0 + i)) for i in range(2)
    ]
    window = n_four_bar(1)
    with pytest.raises(InputError) as error:
        simulate(engine_model(replace(window, effects=(*window.effects, *drives), start=hd.Start())), duration=1.0)
    (fault,) = error.value.faults
    assert fault.where == "start, speeds"
    assert "over-determined: right_0 open by" in fault.found
    assert "driven by drive_0, drive_1" in fault.remedy
    assert "omit one" in fault.remedy
    one = replace(window, effects=(*window.effects, drives[0]), start=hd.Start())
    assert simulate(engine_model(one), duration=1e-2).outcome.finished


# -- what holds the loops ----------------------------------------------------------------------------------------------


def test_the_force_in_a_hinge_is_what_its_body_needs():
    """Beam 1 of two windows, cut free: its mass times the acceleration of its centre, less its weight, is what both hinges push with."""
    run = simulate(engine_model("n_four_bar"), duration=0.6, tolerance=1e-11)
    t, h = np.linspace(0.05, 0.55, 11), 1e-5
    angle = [run.at(t + k * h)["foot_1.angle"] for k in (-1, 0, 1)]
    centre = [
        np.column_stack([-np.sin(a), np.cos(a)]) for a in angle
    ]  # of the beam, but for a constant: it stays level
    needed = (centre[0] - 2 * centre[1] + centre[2]) / h**2 + [0, 9.81]
    # the beam does not turn: both hinges bear the same vertical force
    assert run.at(t)["right_1.force_y"] == pytest.approx(needed[:, 1] / 2, abs=1e-4)
