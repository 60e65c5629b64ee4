"""Forces between two points by any law of their distance and its rate, against closed forms."""

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

M, G, K, REST = 70.0, 9.81, 100.0, 20.0  # of a bungee jump: kg, m/s^2, N/m, m
JUMPER, HOOK = hd.Body("jumper", hd.Parameter("mass", "kg", M)), hd.GROUND.at(0, 0, 0)
k, rest = hd.Parameter("k", "N/m", K), hd.Parameter("rest", "m", REST)
FALL = hd.Mechanism("fall", (hd.Prismatic("fall", hd.GROUND, JUMPER, axis=-hd.Y),))
SCALES = hd.Scales(hd.Parameter("size", "m", 10), hd.Parameter("pace", "m/s", 20))


def fall(tension, *, coordinates="tree", weight=True, **start):
    effects = [hd.LineForce("cord", HOOK, JUMPER.at(0, 0, 0), tension), hd.EnergyLedger()]
    effects += [hd.Gravity("gravity", hd.Parameter("g", "m/s^2", G), direction=-hd.Y)] if weight else []
    return hd.Scene(FALL, effects, SCALES, hd.Start(**start), coordinates=coordinates)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("method", ["auto", "esdirk"])
def test_a_rope_that_only_pulls(method, coordinates):
    """A free fall until it is taut, then a vibration: deepest where m g x = k (x - l)^2/2, at a time in closed form."""
    rope = hd.Where(rest < hd.LENGTH, k * (hd.LENGTH - rest), 0)
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
    other = simulate(load(fall(k * (hd.LENGTH - rest))), duration=6.0, tolerance=1e-9)
    assert abs(np.max(other["cord.length"]) - np.max(x)) > 1


def test_a_bilinear_spring():
    """Half a period of each stiffness: pi sqrt(m/k1) + pi sqrt(m/k2)."""
    soft = hd.Parameter("soft", "N/m", 25)
    law = (hd.LENGTH - rest) * hd.Where(rest < hd.LENGTH, k, soft)
    period = np.pi * (np.sqrt(M / K) + np.sqrt(M / 25))
    pushed = {"position": {"fall": rest}, "speed": {"fall": hd.Parameter("push", "m/s", 3)}}
    run = simulate(load(fall(law, weight=False, **pushed)), duration=period, tolerance=1e-9)
    assert run.engine.final["fall.travel"] == pytest.approx(REST, abs=1e-6)
    assert run.engine.final["fall.speed"] == pytest.approx(3, rel=1e-8)
    there = run.at(np.linspace(0, period, 4001))["fall.travel"]
    assert np.ptp(there) == pytest.approx(3 * (np.sqrt(M / K) + np.sqrt(M / 25)), rel=1e-6)


def test_linear_laws_are_a_spring_and_a_damper():
    """Between points of two links, in a plane motion that turns the line."""
    length, damping = hd.Parameter("l", "m", 1), hd.Parameter("damping", "N s/m", 30)
    mass, inertia = hd.Parameter("m", "kg", 2), hd.Parameter("J", "kg m^2", 0.2)
    upper, lower = (hd.Body(name, mass, inertia, (length / 2, 0, 0)) for name in ("upper", "lower"))
    joints = (
        hd.Revolute("top", hd.GROUND, upper, axis=hd.Z),
        hd.Revolute("elbow", upper.at(length, 0, 0), lower, axis=hd.Z),
    )
    scales = hd.Scales(length, hd.Parameter("pace", "m/s", 1), length)
    ends = hd.GROUND.at(0.3 * length, 0.7 * length, 0), lower.at(length, 0, 0)
    stretch = hd.Parameter("free", "m", 0.5)
    start = hd.Start(position={"elbow": hd.Parameter("bend", "rad", 0.4)})

    def final(*effects):
        scene = hd.Scene(hd.Mechanism("arm", joints), (*effects, hd.EnergyLedger()), scales, start)
        run = simulate(load(scene), duration=1.0, tolerance=1e-10)
        return np.array([run.engine.final[name] for name in ("top.angle", "elbow.angle", "top.speed", "elbow.speed")])

    one = final(hd.LineForce("strut", *ends, k * (hd.LENGTH - stretch) + damping * hd.LENGTH_RATE))
    two = final(hd.PointSpring("spring", *ends, k, stretch), hd.PointDamper("damper", *ends, damping))
    assert one == pytest.approx(two, abs=1e-8)


def test_a_law_of_the_wrong_unit_or_of_a_joint_is_refused():
    with pytest.raises(hd.InputError, match="effect cord, tension"):
        fall(k * hd.LENGTH_RATE)
    with pytest.raises(hd.InputError, match="which depends on length"):
        heavy = hd.Gravity("g", hd.Parameter("g", "m/s^2", G) * hd.LENGTH, -hd.Y)
        hd.Scene(FALL, (hd.PointSpring("s", HOOK, JUMPER.at(0, 0, 0), k), heavy), SCALES)
    with pytest.raises(hd.InputError, match="fal"):
        fall(k * hd.coordinate_of("fal") + k * hd.speed_of("fall"))
