"""Contact between parts that only drives move: its force by the law, its work in the drives' books."""

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import equilibrium, load, simulate

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

RADIUS, STROKE = hd.Parameter("R", "mm", 20), hd.Parameter("stroke", "mm", 1)
RATE, STIFFNESS, MASSES = 100.0, 1e8, {"punch": 1.5, "die": 0.7}
r, a = RADIUS.si, STROKE.si


def press(*effects, damping=None, free=False, coordinates="tree"):
    """A punch at R + a/2 + a sin(w t + phase), a die at a/2 sin(2 w t)."""
    punch, die = (hd.Body(name, hd.Parameter(f"m_{name}", "kg", mass)) for name, mass in MASSES.items())
    joints = [hd.Prismatic("down", hd.GROUND, punch, axis=hd.Y), hd.Prismatic("up", hd.GROUND, die, axis=hd.Y)]
    if free:
        joints.append(hd.Prismatic("beside", hd.GROUND, hd.Body("other", hd.Parameter("m_other", "kg", 1)), axis=hd.X))
    w = hd.Parameter("w", "rad/s", RATE)
    return hd.Scene(
        hd.Mechanism(
            "press", tuple(joints), (hd.SphereOnPlane("tip", punch.at(0, 0, 0), RADIUS, die.at(0, 0, 0), hd.Y),)
        ),
        (
            hd.Harmonic("ram", "down", STROKE, w, phase=hd.Parameter("phase", "rad", 1.5), mean=RADIUS + STROKE / 2),
            hd.Harmonic("bolster", "up", STROKE / 2, 2 * w),
            hd.Contact("tip", hd.laws.power(hd.Parameter("K", "N/m^1.5", STIFFNESS), 1.5), damping),
            *effects,
        ),
        hd.Scales(length=STROKE, speed=hd.Parameter("pace", "m/s", 0.1)),
        coordinates=coordinates,
    )


def motion(t):
    """Positions of punch and die, speeds, accelerations."""
    one, two = RATE * t + 1.5, 2 * RATE * t
    places = r + a / 2 + a * np.sin(one), a / 2 * np.sin(two)
    speeds = a * RATE * np.cos(one), a * RATE * np.cos(two)
    return places, speeds, (-a * RATE**2 * np.sin(one), -2 * a * RATE**2 * np.sin(two))


@pytest.mark.parametrize("free", [False, True])
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_its_force_is_the_laws_of_the_prescribed_penetration(free, coordinates):
    """K delta^1.5, and the drives bear it: their forces and powers, and the work in the ledger."""
    run = simulate(load(press(hd.EnergyLedger(), free=free, coordinates=coordinates)), duration="0.2 s", accuracy=1e-9)
    assert run.outcome.finished
    assert len(run.impacts) == 3
    (high, low), speeds, accelerations = motion(run.t)
    depth = np.maximum(low + r - high, 0)
    force = STIFFNESS * depth**1.5
    size = np.max(force)
    assert run["tip.normal_force"] == pytest.approx(force, abs=1e-9 * size)
    pushes = -force, force  # on the drives
    for drive, mass, push, speed, acceleration in zip(
        ("ram", "bolster"), MASSES.values(), pushes, speeds, accelerations, strict=True
    ):
        assert run[f"{drive}.force"] == pytest.approx(mass * acceleration + push, abs=1e-8 * size)
        assert run[f"{drive}.power"] == pytest.approx((mass * acceleration + push) * speed, abs=1e-8 * size)
    kinetic = sum(m * v**2 / 2 for m, v in zip(MASSES.values(), speeds, strict=True))
    energy = kinetic + 2 / 5 * STIFFNESS * depth**2.5
    assert run["energy_ledger.input"] == pytest.approx(energy - energy[0], abs=1e-7 * np.max(energy))


@pytest.mark.parametrize("free", [False, True])
def test_no_contact_is_missed_where_nothing_else_moves(free):
    """Without a ledger no state changes but for the gap: every contact begins and ends as with one."""
    run, other = (
        simulate(load(press(*e, free=free)), duration="1 s", accuracy=1e-7) for e in ((), (hd.EnergyLedger(),))
    )
    assert len(run.impacts) == len(other.impacts) == 16
    for one, two in zip(run.impacts, other.impacts, strict=True):
        assert (one.t, one.duration) == pytest.approx((two.t, two.duration), rel=1e-8)
        assert one.peak_force == pytest.approx(two.peak_force, rel=1e-8)
    (high, low), *_ = motion(run.t)
    start = motion(np.zeros(1))[0]
    assert run["tip.gap_change"] == pytest.approx((high - low) - (start[0] - start[1]), abs=1e-6 * a)


def test_two_rotors_that_graze_each_other():
    """Arms with round heads, one fast and one slow: a short contact wherever the heads meet, with friction."""
    arm = hd.Parameter("arm", "mm", 100)
    rotors = [
        hd.Body(name, hd.Parameter(f"m_{name}", "kg", 1), hd.Parameter(f"J_{name}", "kg m^2", 0.01))
        for name in ("one", "two")
    ]
    apart = hd.GROUND.at(2 * arm + 2 * RADIUS - STROKE / 2, 0, 0)
    scene = hd.Scene(
        hd.Mechanism(
            "rotors",
            (hd.Revolute("left", hd.GROUND, rotors[0], axis=hd.Z), hd.Revolute("right", apart, rotors[1], axis=hd.Z)),
            (hd.SphereOnSphere("heads", rotors[0].at(arm, 0, 0), rotors[1].at(-arm, 0, 0), RADIUS, RADIUS),),
        ),
        (
            hd.ConstantSpeed("quick", "left", hd.Parameter("w_1", "rad/s", 2 * np.pi * 50)),
            hd.Ramp("slow", "right", hd.Parameter("w_2", "rad/s", -2 * np.pi * 25), rise=hd.Parameter("rise", "ms", 1)),
            hd.Contact("heads", hd.laws.power(hd.Parameter("K", "N/m^1.5", STIFFNESS), 1.5)),
            hd.Friction("rub", "heads", hd.laws.smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 0.01))),
        ),
        hd.Scales(length=STROKE, speed=hd.Parameter("pace", "m/s", 10), arm=arm),
    )  # fmt: skip
    run = simulate(load(scene), duration="0.401 s", accuracy=1e-6)
    assert run.outcome.finished
    times = np.linspace(0, 0.401, 400_001)[1:]
    ramp = np.where(times < 1e-3, times / 1e-3, 1)
    share = ramp**3 * (10 - 15 * ramp + 6 * ramp**2)
    turned = np.cumsum(share) * (times[1] - times[0])
    one, two = 2 * np.pi * 50 * times, np.pi - 2 * np.pi * 25 * turned
    x = 0.2 + 2 * r - a / 2 + 0.1 * (np.cos(two) - np.cos(one))
    touching = np.hypot(x, 0.1 * (np.sin(two) - np.sin(one))) < 2 * r
    assert touching[0]
    assert len(run.impacts) == 1 + np.count_nonzero(np.diff(touching.astype(int)) == 1)


def test_held_drives_press_and_drives_alone_are_refused():
    # Statics, at a time within a contact.
    (high, low), *_ = motion(np.array([0.035]))
    rest = equilibrium(load(press(hd.EnergyLedger())), at="35 ms")
    assert rest.contacts["tip"] == pytest.approx(STIFFNESS * (low + r - high)[0] ** 1.5, rel=1e-9)
    # Without work or contact to read, a scene of drives is an error that says what may be added.
    scene = press()
    with pytest.raises(hd.InputError, match=r"a drive on every joint.*\n.*EnergyLedger\(\), or the Contact"):
        scene.without("tip")
