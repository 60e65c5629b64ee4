"""Forces between two points by any law of their distance and its rate, against closed forms."""

import numpy as np
import pytest

from hertzwerk.derive import (
    GROUND,
    LENGTH,
    LENGTH_RATE,
    Body,
    EnergyLedger,
    Gravity,
    InputError,
    LineForce,
    Mechanism,
    Parameter,
    PointDamper,
    PointSpring,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    Where,
    Y,
    Z,
    coordinate_of,
    speed_of,
)
from hertzwerk.runtime import load, simulate

M, G, K, REST = 70.0, 9.81, 100.0, 20.0  # of a bungee jump: kg, m/s^2, N/m, m
JUMPER, HOOK = Body("jumper", Parameter("mass", "kg", M)), GROUND.at(0, 0, 0)
k, rest = Parameter("k", "N/m", K), Parameter("rest", "m", REST)
FALL = Mechanism("fall", (Prismatic("fall", GROUND, JUMPER, axis=-Y),))
SCALES = Scales(Parameter("size", "m", 10), Parameter("pace", "m/s", 20))


def fall(tension, *, coordinates="tree", weight=True, **start):
    effects = [LineForce("cord", HOOK, JUMPER.at(0, 0, 0), tension), EnergyLedger()]
    effects += [Gravity("gravity", Parameter("g", "m/s^2", G), direction=-Y)] if weight else []
    return Scene(FALL, effects, SCALES, Start(**start), coordinates=coordinates)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("method", ["auto", "esdirk"])
def test_a_rope_that_only_pulls(method, coordinates):
    """A free fall until it is taut, then a vibration: deepest where m g x = k (x - l)^2/2, at a time in closed form."""
    rope = Where(rest < LENGTH, k * (LENGTH - rest), 0)
    run = simulate(load(fall(rope, coordinates=coordinates)), duration=6.0, tolerance=1e-9, method=method)
    x, sag, omega = run["cord.length"], M * G / K, np.sqrt(K / M)
    speed = np.sqrt(2 * G * REST)
    amplitude = np.hypot(sag, speed / omega)
    taut = np.sqrt(2 * REST / G)
    deepest = taut + (np.pi / 2 + np.arctan2(sag, speed / omega)) / omega
    assert run.at(np.array([deepest]))["cord.length"][0] == pytest.approx(REST + sag + amplitude, rel=1e-7)
    assert M * G * (REST + sag + amplitude) == pytest.approx(K * (sag + amplitude) ** 2 / 2, rel=1e-12)
    assert run["cord.tension"] == pytest.approx(np.maximum(K * (x - REST), 0), abs=1e-6)
    assert np.min(run["cord.tension"]) == 0
    assert run.energy_residual < 1e-7
    # a cord that also pushes would come to another depth
    other = simulate(load(fall(k * (LENGTH - rest))), duration=6.0, tolerance=1e-9)
    assert abs(np.max(other["cord.length"]) - np.max(x)) > 1


def test_a_bilinear_spring():
    """Half a period of each stiffness: pi sqrt(m/k1) + pi sqrt(m/k2)."""
    soft = Parameter("soft", "N/m", 25)
    law = (LENGTH - rest) * Where(rest < LENGTH, k, soft)
    period = np.pi * (np.sqrt(M / K) + np.sqrt(M / 25))
    pushed = {"position": {"fall": rest}, "speed": {"fall": Parameter("push", "m/s", 3)}}
    run = simulate(load(fall(law, weight=False, **pushed)), duration=period, tolerance=1e-9)
    assert run.final["fall.travel"] == pytest.approx(REST, abs=1e-6)
    assert run.final["fall.speed"] == pytest.approx(3, rel=1e-8)
    there = run.at(np.linspace(0, period, 4001))["fall.travel"]
    assert np.ptp(there) == pytest.approx(3 * (np.sqrt(M / K) + np.sqrt(M / 25)), rel=1e-6)


def test_linear_laws_are_a_spring_and_a_damper():
    """Between points of two links, in a plane motion that turns the line."""
    length, damping = Parameter("l", "m", 1), Parameter("damping", "N s/m", 30)
    upper, lower = (
        Body(name, Parameter(f"{name}_mass", "kg", 2), Parameter(f"{name}_inertia", "kg m^2", 0.2), (length / 2, 0, 0))
        for name in ("upper", "lower")
    )
    joints = Revolute("top", GROUND, upper, axis=Z), Revolute("elbow", upper.at(length, 0, 0), lower, axis=Z)
    ends = GROUND.at(0.3 * length, 0.7 * length, 0), lower.at(length, 0, 0)
    stretch = Parameter("free", "m", 0.5)
    start = Start(position={"elbow": Parameter("bend", "rad", 0.4)})

    def final(*effects):
        scene = Scene(
            Mechanism("arm", joints),
            (*effects, EnergyLedger()),
            Scales(length, Parameter("pace", "m/s", 1), length),
            start,
        )
        run = simulate(load(scene), duration=1.0, tolerance=1e-10)
        return np.array([run.final[name] for name in ("top.angle", "elbow.angle", "top.speed", "elbow.speed")])

    one = final(LineForce("strut", *ends, k * (LENGTH - stretch) + damping * LENGTH_RATE))
    two = final(PointSpring("spring", *ends, k, stretch), PointDamper("damper", *ends, damping))
    assert one == pytest.approx(two, abs=1e-8)


def test_a_law_of_the_wrong_unit_or_of_a_joint_is_refused():
    with pytest.raises(InputError, match="effect cord, tension"):
        fall(k * LENGTH_RATE)
    with pytest.raises(InputError, match="which depends on length"):
        Scene(
            FALL,
            (PointSpring("s", HOOK, JUMPER.at(0, 0, 0), k), Gravity("g", Parameter("g", "m/s^2", G) * LENGTH, -Y)),
            SCALES,
        )
    with pytest.raises(InputError, match="fal"):
        fall(k * coordinate_of("fal") + k * speed_of("fall"))
