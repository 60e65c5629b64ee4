"""Springs, dampers, forces, friction and drives through the engine, against closed forms; the energy ledger closed with each."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

M, K, C, J, KAPPA = 2.0, 50.0, 0.7, 0.3, 4.0  # kg, N/m, N s/m, kg m^2, N m
MASS, STIFFNESS, DAMPING = (
    hd.Parameter("mass", "kg", M), hd.Parameter("stiffness", "N/m", K), hd.Parameter("damping", "N s/m", C),
)  # fmt: skip
INERTIA, TORSION = hd.Parameter("inertia", "kg m^2", J), hd.Parameter("torsion", "N m", KAPPA)
SIZE, PACE = hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 1.0)
FORCE, RATE = hd.Parameter("force", "N", 4.0), hd.Parameter("rate", "rad/s", 3.0)
W = np.sqrt(K / M)


def block(*effects, **start):
    """A block that slides along x."""
    mechanism = hd.Mechanism("block_on_rails", (hd.Prismatic("slide", hd.GROUND, hd.Body("block", MASS), axis=hd.X),))
    begin = hd.Start(**{what: {"slide": value} for what, value in start.items()})
    return hd.Scene(mechanism, (*effects, hd.EnergyLedger()), hd.Scales(length=SIZE, speed=PACE, arm=SIZE), begin)


def wheel(*effects, **start):
    """A wheel that turns about z."""
    mechanism = hd.Mechanism(
        "wheel_on_axle", (hd.Revolute("axle", hd.GROUND, hd.Body("wheel", MASS, INERTIA), axis=hd.Z),)
    )
    begin = hd.Start(**{what: {"axle": value} for what, value in start.items()})
    return hd.Scene(mechanism, (*effects, hd.EnergyLedger()), hd.Scales(length=SIZE, speed=PACE, arm=SIZE), begin)


def follower(drive, *effects):
    """A block on a spring between it and a carriage that is driven along the same line."""
    carriage, other = hd.Body("carriage", hd.Parameter("carriage_mass", "kg", 3.0)), hd.Body("block", MASS)
    joints = (hd.Prismatic("rail", hd.GROUND, carriage, axis=hd.X), hd.Prismatic("slide", hd.GROUND, other, axis=hd.X))
    spring = hd.PointSpring("spring", carriage.at(0, 0, 0), other.at(0, 0, 0), STIFFNESS)
    return hd.Scene(
        hd.Mechanism("follower", joints), (drive, spring, *effects, hd.EnergyLedger()), hd.Scales(length=SIZE, speed=PACE),
    )  # fmt: skip


def run(scene, duration, **options):
    given = {"tolerance": 1e-10, **options}
    found = simulate(engine_model(scene), duration=duration, **given)
    assert found.outcome.finished
    assert found.energy_residual < 100 * given["tolerance"]
    return found


SPRING, DAMPER = hd.JointSpring("spring", "slide", STIFFNESS), hd.JointDamper("damper", "slide", DAMPING)


def test_driven_oscillator_settles_to_its_amplitude_and_phase():
    """x = F/sqrt((k - m w^2)^2 + (c w)^2) cos(w t - phi), tan(phi) = c w/(k - m w^2), once exp(-c t/2m) is gone."""
    result = run(block(SPRING, DAMPER, hd.JointForce("motor", "slide", FORCE * sp.cos(RATE * hd.T))), 160.0)
    t = np.linspace(150, 160, 201)
    response = 4.0 / complex(K - M * 3.0**2, C * 3.0)
    assert result.at(t)["slide.travel"] == pytest.approx(np.real(response * np.exp(3j * t)), abs=1e-9)
    per_period = np.pi * C * 3.0 * abs(response) ** 2  # put in and dissipated
    ends = result.at(np.array([158.0 - 2 * np.pi / 3, 158.0]))
    for name in ("motor.input", "damper.dissipated"):
        assert np.diff(ends[name])[0] == pytest.approx(per_period, rel=1e-6)


def test_friction_brings_a_block_to_rest():
    """m v' = -mu N tanh(v/v_s): sinh(v/v_s) falls as exp(-mu N t/(m v_s))."""
    law = smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 0.5))
    scene = block(hd.JointFriction("friction", "slide", law, hd.Parameter("load", "N", 30.0)), speed=PACE)
    actual = run(scene, 1.0)
    expected = 0.5 * np.arcsinh(np.sinh(2.0) * np.exp(-0.2 * 30 / (M * 0.5) * actual.t))
    assert actual["slide.speed"] == pytest.approx(expected, abs=1e-9)
    assert actual["friction.dissipated"][-1] == pytest.approx(M / 2 * (1 - expected[-1] ** 2), rel=1e-8)


# -- drives ------------------------------------------------------------------------------------------------------------

AMPLITUDE = hd.Parameter("amplitude", "m", 0.05)


def test_a_harmonic_carriage_takes_its_block_along():
    """m x'' = k (A sin(W t) - x): x = A/(1 - r^2) (sin(W t) - r sin(w t)), r = W/w."""
    result = run(follower(hd.Harmonic("drive", "rail", AMPLITUDE, RATE)), 10.0)
    t, ratio = result.t, 3.0 / W
    assert result["slide.travel"] == pytest.approx(
        0.05 / (1 - ratio**2) * (np.sin(3 * t) - ratio * np.sin(W * t)), abs=1e-9
    )
    assert result["energy_ledger.input"] == pytest.approx(result["energy"] - result["energy"][0], abs=1e-9)


@cache
def tabulated(count):
    """The follower of a table of the same sine over four half periods."""
    times = np.linspace(0, 4 * np.pi / 3, count)
    table = hd.Table("sine", times.tolist(), (50 * np.sin(3 * times)).tolist(), ("s", "mm"))
    return engine_model(follower(hd.Drive("drive", "rail", position=table(hd.T))))


def test_a_tabulated_sine_is_as_good_as_the_spline():
    """Halving the distance of the points divides the difference to the sine by 2^6."""
    errors = []
    for count in (17, 33):
        result = simulate(tabulated(count), duration=4.0, tolerance=1e-12)
        ratio = 3.0 / W
        exact = 0.05 / (1 - ratio**2) * (np.sin(3 * result.t) - ratio * np.sin(W * result.t))
        errors.append(np.max(np.abs(result["slide.travel"] - exact)))
        assert result.energy_residual < 1e-8  # steps go over the points, where the fifth derivative jumps
    assert 2**5.5 < errors[0] / errors[1] < 2**6.5


@pytest.mark.parametrize("method", ["dopri5", "esdirk", "rodas", "auto", "cvodes"])
def test_every_method_reads_tables(method):
    best = simulate(tabulated(17), duration=4.0, tolerance=1e-10)
    result = simulate(tabulated(17), duration=4.0, tolerance=1e-6, method=method)
    assert result.outcome.finished
    assert result.engine.final["slide.travel"] == pytest.approx(best.engine.final["slide.travel"], abs=1e-5)


def ramped(**drive):
    wheel = hd.Body("wheel", MASS, INERTIA)
    joints = (
        hd.Revolute("axle", hd.GROUND, wheel, axis=hd.Z),
        hd.Prismatic("slide", hd.GROUND, hd.Body("block", MASS), axis=hd.X),
    )
    scales = hd.Scales(length=SIZE, speed=PACE, arm=SIZE)
    return hd.Scene(
        hd.Mechanism("ramped", joints), (hd.Drive("drive", "axle", **drive), SPRING, hd.EnergyLedger()), scales
    )


SPEED, RISE = hd.Parameter("speed", "rpm", 120), hd.Parameter("rise", "s", 0.5)


@pytest.mark.parametrize("smoothness", [0, 1, 2, 3])
def test_a_ramp_is_the_integral_of_its_speed_and_of_its_acceleration(smoothness):
    """Integrated as states from its declared speed, and from its acceleration, a ramp comes where its closed form is: speed (t - rise/2)."""
    law = hd.Ramp("drive", "axle", SPEED, RISE, smoothness).motion.law
    speed = 120 * np.pi / 30
    by_speed = run(ramped(speed=sp.diff(law, hd.T)), 2.0)
    by_acceleration = run(ramped(acceleration=sp.diff(law, hd.T, 2)), 2.0)
    for result in (by_speed, by_acceleration):
        late = result.t > 0.5
        assert result["axle.angle"][late] == pytest.approx(speed * (result.t[late] - 0.25), abs=1e-7)
        assert result["axle.angle"][0] == 0
    assert by_acceleration["axle.speed"][-1] == pytest.approx(speed, rel=1e-8)
    # all of the input went into the wheel: J speed^2/2
    assert by_speed["energy_ledger.input"][-1] == pytest.approx(J * speed**2 / 2, rel=1e-8)


def test_states_of_a_drive_can_start_elsewhere():
    model = engine_model(
        ramped(speed=SPEED * hd.Where(hd.T < RISE, hd.T / RISE, 1), start=hd.Parameter("first", "deg", 90))
    )
    assert simulate(model, duration=0.1, tolerance=1e-6)["axle.angle"][0] == pytest.approx(np.pi / 2)
    run = simulate(model, duration=0.1, initial={"axle.angle": "10 deg"}, tolerance=1e-6)
    assert run["axle.angle"][0] == pytest.approx(np.pi / 18)


# -- all at once -------------------------------------------------------------------------------------------------------


def test_the_ledger_closes_with_every_element_at_once():
    law = smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 0.5))
    extra = (
        SPRING, DAMPER, hd.JointForce("motor", "slide", FORCE * sp.cos(RATE * hd.T)),
        hd.JointFriction("friction", "slide", law, hd.Parameter("load", "N", 3.0)),
        hd.Potential("bowl", STIFFNESS * hd.coordinate_of("slide") ** 4 / SIZE**2),
    )  # fmt: skip
    scene = follower(hd.Harmonic("drive", "rail", AMPLITUDE, RATE), hd.JointDamper("rails", "rail", DAMPING))
    result = run(
        hd.Scene(scene.mechanism, (*(e for e in scene.effects if e.name != "spring"), *extra), scene.scales), 10.0
    )
    assert set(result.engine.model.memory) == {
        "energy_ledger.input", "rails.dissipated", "damper.dissipated", "motor.input", "friction.dissipated"
    }  # fmt: skip
    assert min(abs(result[name][-1]) for name in result.engine.model.memory) > 1e-3
    rails = C * (0.05 * 3.0) ** 2 * (10 / 2 + np.sin(60) / 12)  # of the drive alone: c A^2 W^2 cos^2, integrated
    assert result["rails.dissipated"][-1] == pytest.approx(rails, rel=1e-8)
