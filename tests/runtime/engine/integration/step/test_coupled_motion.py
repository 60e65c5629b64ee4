"""Couplings against closed forms: reduced inertias, Willis' equation, a rack, a screw, a differential, Cardan's circles, a Scotch yoke."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.derive.equations.motion import constraints as coupled
from hertzwerk.derive.laws import power
from hertzwerk.runtime import load, simulate

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

BOTH = ("tree", "absolute")
TOLERANCE, EXACT = 1e-10, 1e-9
r, pace = hd.Parameter("arm_length", "m", 0.4), hd.Parameter("pace", "m/s", 1.0)
m, g = hd.Parameter("wheel_mass", "kg", 2.0), hd.Parameter("g", "m/s^2", 9.81)
J1, J2, J3 = (hd.Parameter(f"J{k}", "kg m^2", value) for k, value in ((1, 0.2), (2, 0.05), (3, 0.11)))
M, ratio = hd.Parameter("M", "N m", 2.0), hd.Parameter("ratio", "1", -3.0)
wheel, pinion, third = (hd.Body(f"{name}_body", m, J) for name, J in (("wheel", J1), ("pinion", J2), ("third", J3)))
WHEEL, PINION = (
    hd.Revolute("wheel", hd.GROUND, wheel, axis=hd.Z),
    hd.Revolute("pinion", hd.GROUND.at(r, 0, 0), pinion, axis=hd.Z),
)
MESH = hd.Coupling("mesh", "pinion", "wheel", ratio)
MOTOR = hd.JointForce("motor", "wheel", M)


def scene(joints, *effects, **start) -> hd.Scene:
    return hd.Scene(
        hd.Mechanism("coupled", joints), (*effects, hd.EnergyLedger()), hd.Scales(r, pace, arm=r), hd.Start(**start)
    )  # fmt: skip


def gears(*effects, **start) -> hd.Scene:
    return scene((WHEEL, PINION), *(effects or (MOTOR, MESH)), **start)


def run(declared: hd.Scene, coordinates: str = "tree", duration: float = 2.0, **options):
    found = simulate(
        load(declared.with_coordinates(coordinates)), duration=duration, **{"tolerance": TOLERANCE, **options}
    )
    assert found.outcome.finished
    assert found.energy_residual < EXACT
    assert max(np.max(np.abs(found[name])) for name in found.engine.model.constraints) < EXACT
    return found


def at_rate(found, name: str, acceleration: float) -> None:
    """A speed that grows from its start at a constant rate."""
    assert found[name] == pytest.approx(found[name][0] + acceleration * found.t, abs=EXACT, rel=EXACT)


# -- linear couplings --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_geared_pair_has_the_inertia_of_both(coordinates):
    """J1 + i^2 J2 on the wheel's shaft; what holds the mesh turns the pinion alone."""
    actual, rate = run(gears(), coordinates), 2.0 / (0.2 + 9 * 0.05)
    at_rate(actual, "wheel.speed", rate)
    at_rate(actual, "pinion.speed", -3 * rate)
    assert actual["mesh.moment"] == pytest.approx(0.05 * -3 * rate, rel=EXACT)
    assert 2.0 + 3.0 * actual["mesh.moment"] == pytest.approx(0.2 * rate, rel=EXACT)  # what is left for the wheel


@pytest.mark.parametrize("coordinates", BOTH)
def test_an_offset_and_a_start_are_kept_and_a_coupling_stated_twice_holds_once(coordinates):
    """One angle and one speed are given, of different shafts; the others follow."""
    offset, given, turned = (
        hd.Parameter("offset", "deg", 30), hd.Parameter("given", "rad", 0.3), hd.Parameter("w0", "rad/s", 0.6),
    )  # fmt: skip
    mesh = replace(MESH, offset=offset)
    actual = run(gears(MOTOR, mesh, position={"wheel": given}, speed={"pinion": turned}), coordinates)
    assert actual["pinion.angle"][0] == pytest.approx(-0.9 + np.pi / 6, abs=1e-12)
    assert actual["wheel.speed"][0] == pytest.approx(-0.2, abs=1e-12)
    assert actual["pinion.angle"] == pytest.approx(-3 * actual["wheel.angle"] + np.pi / 6, abs=EXACT)
    actual = run(gears(MOTOR, MESH, hd.Coupling("again", "wheel", "pinion", 1 / ratio)), coordinates)
    at_rate(actual, "wheel.speed", 2.0 / 0.65)
    assert any("mesh.moment, again.moment" in warning for warning in actual.warnings)


def test_couplings_that_contradict_each_other_or_the_start_are_refused():
    given = {"wheel": hd.Parameter("one", "rad", 0.3), "pinion": hd.Parameter("other", "rad", 0.3)}
    with pytest.raises(hd.InputError, match=r"mesh off by 1\.2 rad; expected .*couplings that hold") as error:
        run(gears(MOTOR, MESH, position=given))
    assert "stated: wheel.angle, pinion.angle" in error.value.faults[0].remedy
    # Another ratio by a part in a thousand: the pen cannot be where its guide and its rim want it.
    with pytest.raises(hd.InputError, match=r"over-determined .*ring off by 0\.0"):
        run(pen(-2.002))
    other = replace(MESH, name="other", offset=hd.Parameter("offset", "rad", 0.1))
    with pytest.raises(hd.InputError, match=r"mesh off by 0\.05 rad, other off by 0\.05 rad"):
        run(gears(MOTOR, MESH, other))


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_planetary_gear_obeys_willis(coordinates):
    """Sun 0.1 m, planet 0.05 m, ring 0.2 m that stands: carrier = sun/(1 + ring/sun), and the energy of all at the sun's speed."""
    rs, rp = hd.Parameter("sun_radius", "m", 0.1), hd.Parameter("planet_radius", "m", 0.05)
    rr = rs + 2 * rp
    sun, carrier, planet = hd.coordinate_of("wheel"), hd.coordinate_of("carrier"), hd.coordinate_of("planet")
    joints = (
        WHEEL, hd.Revolute("carrier", hd.GROUND, third, axis=hd.Z), hd.Revolute("planet", third.at(rs + rp, 0, 0), pinion, axis=hd.Z),
    )  # fmt: skip
    inner = hd.Coupling("inner", equation=(sun - carrier) * rs / rp + planet)
    actual = run(scene(joints, MOTOR, inner, hd.Coupling("outer", "planet", "carrier", -rr / rp)), coordinates)
    over = 1 / (1 + 0.2 / 0.1)  # Willis, carrier over sun
    spin = over * (1 - 0.2 / 0.05)  # planet's rotation against the ground over the sun's
    reduced = 0.2 + over**2 * (0.11 + 2.0 * 0.15**2) + spin**2 * 0.05
    at_rate(actual, "wheel.speed", 2.0 / reduced)
    at_rate(actual, "carrier.speed", over * 2.0 / reduced)
    # torque on the planet's angle from the sun's side: on the sun acts rs/rp times as much
    assert 2.0 + actual["inner.moment"][-1] * 0.1 / 0.05 == pytest.approx(0.2 * 2.0 / reduced, rel=EXACT)


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_rack_falls_with_its_pinion(coordinates):
    """-m g = (m + J/r^2) a; the rack is held by J a/r^2."""
    joints = hd.Prismatic("rack", hd.GROUND, third, axis=hd.Y), WHEEL
    mesh = hd.Coupling("mesh", "rack", "wheel", r)
    actual = run(scene(joints, hd.Gravity("gravity", g, -hd.Y), mesh), coordinates, duration=1.0)
    a = -2.0 * 9.81 / (2.0 + 0.2 / 0.4**2)
    at_rate(actual, "rack.speed", a)
    assert actual["mesh.force"] == pytest.approx(-0.2 * a / 0.4**2, rel=EXACT)
    assert actual.engine.history.units["mesh.force"] == "N"


def test_a_screw_press_is_lifted_by_its_torque():
    """h = lead/2 pi: (J + m h^2) alpha = M - m g h, on one body that turns and slides."""
    lead = hd.Parameter("lead", "mm", 800)
    nut = hd.Body("nut", m, (J3, J3, J1))
    screw = hd.Coupling("screw", "press.travel", "press.angle", lead / (2 * sp.pi))
    turned = hd.JointForce("spindle", "press.angle", M)
    weight = hd.Gravity("gravity", g, -hd.Z)
    actual = run(scene((hd.Cylindrical("press", hd.GROUND, nut, axis=hd.Z),), turned, weight, screw), duration=1.0)
    h = 0.8 / (2 * np.pi)
    alpha = (2.0 - 2.0 * 9.81 * h) / (0.2 + 2.0 * h**2)
    at_rate(actual, "press.angle_speed", alpha)
    assert actual["screw.force"] == pytest.approx(2.0 * (9.81 + h * alpha), rel=EXACT)


# -- equations that bend -----------------------------------------------------------------------------------------------


def yoke(**start) -> hd.Scene:
    """A crank of 0.4 m that moves a slide by a slot across it."""
    joints = WHEEL, hd.Prismatic("slide", hd.GROUND, third, axis=hd.X)
    slot = hd.Coupling("slot", equation=hd.coordinate_of("slide") - r * sp.cos(hd.coordinate_of("wheel")))
    return scene(joints, slot, speed={"wheel": hd.Parameter("w0", "rad/s", 5.0)}, **start)


def yoke_is_right(coordinates: str) -> None:
    found = run(yoke(position={"wheel": hd.Parameter("given", "rad", 0.2)}), coordinates, duration=3.0)
    inertia = 0.2 + 2.0 * 0.4**2 * np.sin(found["wheel.angle"]) ** 2
    assert found["wheel.speed"] == pytest.approx(5.0 * np.sqrt(inertia[0] / inertia), rel=EXACT)
    phi, w = found["wheel.angle"], found["wheel.speed"]
    alpha = -2.0 * 0.4**2 * np.sin(phi) * np.cos(phi) * w**2 / inertia
    assert found["slot.force"] == pytest.approx(-2.0 * 0.4 * (np.cos(phi) * w**2 + np.sin(phi) * alpha), abs=1e-8)


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_scotch_yoke_has_an_inertia_of_its_angle(coordinates):
    yoke_is_right(coordinates)


def pen(turns: float = -2.0) -> hd.Scene:
    """A wheel that rolls in a ring of twice its radius, a point of its rim pinned to a pen that slides along X, on a spring."""
    along = hd.Prismatic("along", hd.GROUND, hd.Body("pen", m), axis=hd.X)
    planet = hd.Revolute("planet", third.at(r, 0, 0), pinion, axis=hd.Z)
    tip = hd.Revolute("tip", along.child, pinion.at(r, 0, 0), axis=hd.Z)
    ring = hd.Coupling("ring", "planet", "carrier", hd.Parameter("turns", "1", turns))
    spring = hd.JointSpring("spring", "along", hd.Parameter("stiffness", "N/m", 50.0))
    joints = hd.Revolute("carrier", hd.GROUND, third, axis=hd.Z), planet, along, tip
    return scene(joints, ring, spring, position={"carrier": hd.Parameter("given", "rad", 0.5)})


@pytest.mark.parametrize("coordinates", ["tree", pytest.param("absolute", marks=pytest.mark.slow)])
def test_cardan_circles_draw_a_line(coordinates):
    """The rim is at 2 r cos(c), with a pen on a spring; the pen's guide holds the ring's coupling too, a redundant constraint."""
    actual = run(pen(), coordinates, duration=3.0)
    c, w = actual["carrier.angle"], actual["carrier.speed"]
    assert np.ptp(c) > 2.0
    assert actual["along.travel"] == pytest.approx(0.8 * np.cos(c), abs=EXACT)
    inertia = 0.11 + 2.0 * 0.4**2 + 0.05 + 2.0 * (0.8 * np.sin(c)) ** 2
    assert inertia * w**2 / 2 + 25.0 * (0.8 * np.cos(c)) ** 2 == pytest.approx(
        25.0 * (0.8 * np.cos(0.5)) ** 2, rel=EXACT
    )
    assert any("tip.force_y, ring.moment" in warning for warning in actual.warnings)


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_rack_hits_a_stop_with_the_inertia_of_its_pinion(coordinates):
    """Free fall of m + J/r^2 by m g, then Hertz' spring: its depth from the energy of both, gravity's on the way in too."""
    drop, stiff = hd.Parameter("drop_height", "m", 0.2), hd.Parameter("stiffness", "N/m^1.5", 1e7)
    joints = hd.Prismatic("rack", hd.GROUND, third, axis=hd.Y), WHEEL
    stop = hd.SphereOnPlane("stop", third.at(0, 0, 0), hd.Parameter("tip", "m", 0.02), hd.GROUND.at(0, -r, 0), hd.Y)
    effects = (
        hd.Gravity("gravity", g, -hd.Y), hd.Contact("stop", power(stiff, 1.5)), hd.Coupling("mesh", "rack", "wheel", r), hd.EnergyLedger(),
    )  # fmt: skip
    declared = hd.Scene(
        hd.Mechanism("coupled", joints, (stop,)), effects, hd.Scales(r, pace, arm=r),
        hd.Start(position={"rack": drop + hd.Parameter("tip", "m", 0.02) - r}),
    )  # fmt: skip
    actual = run(declared, coordinates, duration=0.4)
    weight, both = 2.0 * 9.81, 2.0 + 0.2 / 0.4**2
    first = actual.impacts[0]
    assert first.t == pytest.approx(np.sqrt(2 * 0.2 * both / weight), rel=EXACT)
    assert first.speed == pytest.approx(np.sqrt(2 * 0.2 * weight / both), rel=EXACT)
    depth = brentq(lambda d: 0.4 * 1e7 * d**2.5 - weight * (0.2 + d), 1e-6, 0.1, xtol=1e-15)
    assert first.peak_penetration == pytest.approx(depth, rel=1e-8)
    rate = (actual["stop.normal_force"] - weight) / both  # at every row, in contact and apart
    assert actual["mesh.force"] == pytest.approx(-0.2 / 0.4**2 * rate, rel=1e-8, abs=1e-8)


# -- what is driven ----------------------------------------------------------------------------------------------------

k = hd.Parameter("angular_rate", "rad/s^2", 0.7)


@pytest.mark.parametrize("coordinates", BOTH)
@pytest.mark.parametrize("driven", ["wheel", "pinion"])
def test_a_drive_moves_what_is_coupled_to_it(driven, coordinates):
    """The drive puts in the energy of both; what it turns itself is no part of what holds the mesh."""
    actual = run(gears(hd.Drive("drive", driven, position=k * hd.T**2 / 2), MESH), coordinates)
    at_wheel, at_pinion = (0.7, -2.1) if driven == "wheel" else (-0.7 / 3, 0.7)
    free, rate = ("pinion", at_pinion) if driven == "wheel" else ("wheel", at_wheel)
    at_rate(actual, f"{free}.speed", rate)
    torque = 0.05 * at_pinion if driven == "wheel" else 0.2 * at_wheel / 3.0
    assert actual["mesh.moment"] == pytest.approx(torque, rel=EXACT)
    energy = (0.2 * at_wheel**2 + 0.05 * at_pinion**2) * 2.0**2 / 2
    assert actual["energy_ledger.input"][-1] == pytest.approx(energy, rel=EXACT)


@pytest.mark.parametrize("coordinates", BOTH)
def test_time_in_an_equation_puts_work_in(coordinates):
    """pinion + 3 wheel = k t^2/2: the torque that turns both apart, and its work."""
    apart = hd.Coupling(
        "apart", equation=hd.coordinate_of("pinion") - ratio * hd.coordinate_of("wheel") - k * hd.T**2 / 2
    )
    actual = run(gears(apart), coordinates)
    torque = 0.7 / (1 / 0.05 + 9 / 0.2)
    assert actual["apart.moment"] == pytest.approx(torque, rel=EXACT)
    at_rate(actual, "wheel.speed", 3 * torque / 0.2)
    assert actual["energy_ledger.input"][-1] == pytest.approx(torque * 0.7 * 2.0**2 / 2, rel=EXACT)


# -- couplings that say the same, or the contrary ----------------------------------------------------------------------


def test_couplings_of_two_ratios_lock():
    """Only zero and zero fulfil both, so that nothing turns: the motor is held, by the one more than by the other."""
    actual = run(gears(MOTOR, MESH, replace(MESH, name="other", ratio=2 * ratio)))
    assert actual["wheel.angle"] == pytest.approx(0, abs=1e-15)
    one, other = actual["mesh.moment"][-1], actual["other.moment"][-1]
    assert [one + other, 2.0 + 3 * one + 6 * other] == pytest.approx([0, 0], abs=EXACT)


# -- seeded faults -----------------------------------------------------------------------------------------------------


def wrong_bias(constraint):
    return replace(constraint, bias=constraint.bias * sp.Rational(9999, 10000))


def wrong_column(constraint):
    return replace(constraint, column=dict(list(constraint.column.items())[:1]))


def unbooked(constraint):
    return replace(constraint, by_time=sp.S.Zero, drives="")


FAULTS = {
    "curvature": (wrong_bias, lambda: yoke_is_right("tree")),
    "one side only": (wrong_column, lambda: test_a_geared_pair_has_the_inertia_of_both("tree")),
    "work": (unbooked, lambda: test_time_in_an_equation_puts_work_in("tree")),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_in_the_derivation_is_seen(name, monkeypatch):
    fault, check = FAULTS[name]
    right = coupled._coupled
    monkeypatch.setattr(coupled, "_coupled", lambda *given: fault(right(*given)))
    with pytest.raises((AssertionError, hd.InputError)):
        check()
