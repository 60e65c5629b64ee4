"""Contacts that leave their damping law: a ball pressed on a shaken plane, in closed form for small vibrations; impacts do not."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws.law import APPROACH_SPEED, DampingLaw
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.model.caller import Caller
from hertzwerk.runtime.engine.solution.contact_watch import LastingContacts
from hertzwerk.runtime.engine.solution.step_warnings import headline, left_law

MASS, GRAVITY, DEPTH, POWER = 0.3, 9.81, 1e-4, 1.5  # kg, m/s^2, m of the penetration at rest, 1
OMEGA = 200.0  # rad/s
SMALL, RATIO = 1e-3, 2.0  # vibration over depth, gap rate over v0
FACTOR = POWER * SMALL / RATIO  # damping factor h for which damping and stiffness of the contact weigh alike
RESTITUTION = float(np.sqrt(1 - FACTOR * 4 / 3))  # of Lankarani and Nikravesh, h = 3 (1 - e^2)/4
LATCHING = [name for name, law in hd.laws.LAWS.items() if isinstance(law, DampingLaw) and APPROACH_SPEED in law.memory]


def steady():
    """v0 [m/s], amplitude of the plane [m], and vibration of the penetration, complex [m], as Im(... exp(i w t)).

    m (y'' - d'') = K d^n (1 + h d'/v0) - m g about K d0^n = m g: x'' + (h g/v0) x' + (n g/d0) x = y''.
    """
    v0 = SMALL * DEPTH * OMEGA / RATIO
    response = 1 / (POWER * GRAVITY / DEPTH - OMEGA**2 + 1j * OMEGA * FACTOR * GRAVITY / v0)
    amplitude = SMALL * DEPTH / abs(response) / OMEGA**2
    return v0, amplitude, -amplitude * OMEGA**2 * response


@cache
def ball(damping="lankarani_nikravesh"):
    """A ball on a plane that is moved up and down as amplitude sin(w t)."""
    radius, shaken = hd.Parameter("radius", "mm", 20), hd.Parameter("amplitude", "m", 0)
    stiffness = hd.Parameter("stiffness", "N/m^1.5", MASS * GRAVITY / DEPTH**POWER)
    body, table = (
        hd.Body("ball", hd.Parameter("mass", "kg", MASS)),
        hd.Body("table", hd.Parameter("table_mass", "kg", 1)),
    )
    law = getattr(hd.laws, damping)(
        *(hd.Parameter(symbol.name, symbol.unit, 0.9) for symbol in hd.laws.LAWS[damping].parameters)
    )
    joints = hd.Prismatic("fall", hd.GROUND, body, axis=hd.Y), hd.Prismatic("lift", hd.GROUND, table, axis=hd.Y)
    return load(
        hd.Scene(
            hd.Mechanism(
                "shaken_ball", joints, (hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, table.at(0, 0, 0), hd.Y),)
            ),
            (
                hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", GRAVITY), direction=-hd.Y),
                hd.Drive("shaker", "lift", position=shaken * sp.sin(hd.Parameter("omega", "rad/s", OMEGA) * hd.T)),
                hd.Contact("floor", hd.laws.power(stiffness, POWER), law),
                hd.EnergyLedger(),
            ),
            hd.Scales(length=hd.Parameter("depth", "m", DEPTH), speed=hd.Parameter("pace", "m/s", 0.02)),
            hd.Start(
                position={"fall": radius - hd.Parameter("sunk", "m", 0)},
                speed={"fall": hd.Parameter("rising", "m/s", 0)},
            ),
        )
    )


@cache
def pressed(**options):
    """The ball on the shaken plane in its steady vibration, for 20 of its periods."""
    v0, amplitude, x = steady()
    given = {
        "e": RESTITUTION,
        "amplitude": f"{amplitude!r} m",
        "approach_floor": f"{v0!r} m/s",
        "sunk": f"{DEPTH + x.imag!r} m",
        "rising": f"{amplitude * OMEGA - (1j * OMEGA * x).imag!r} m/s",
    }
    start = {"floor.approach_speed": f"{v0!r} m/s"}
    return simulate(ball(), duration=40 * np.pi / OMEGA, tolerance=1e-11, parameters=given, initial=start, **options)


def test_a_ball_pressed_on_a_shaken_plane():
    """Amplitude and phase of a spring and damper h K d^n/v0, power dissipated, and the largest gap rate."""
    v0, _, x = steady()
    run = pressed(grid=2001)  # 100 a period
    vibration = (run["floor.penetration"] - DEPTH)[1000:-1]  # ten periods
    found = 2j * np.mean(vibration * np.exp(-1j * OMEGA * run.t[1000:-1]))
    assert found == pytest.approx(x, rel=1e-5)
    (left,) = run.engine.findings.lasting
    assert (left.pair, left.since) == ("floor", 0)
    assert left.speed == pytest.approx(v0, rel=1e-12)
    assert left.ratio == pytest.approx(RATIO, rel=1e-3)
    power = MASS * FACTOR * GRAVITY / v0 * (OMEGA * abs(x)) ** 2 / 2
    assert left.dissipated == pytest.approx(power * run.settings.duration, rel=1e-3)
    (warning,) = (text for text in run.warnings if "exceed the damping law" in text)
    assert warning.startswith(
        "floor: gap rates exceed the damping law; take one without v0. "
        f"At floor they are up to {left.ratio:.2g} times the approach speed v0 since t = 0 s (one contact, 100% of"
    )
    assert headline(warning) == "floor: gap rates exceed the damping law; take one without v0"  # the line of a terminal
    assert "hertzwerk laws" in warning
    assert "approach_floor" in warning
    rounded = left_law(run.engine.model, [left._replace(since=2e-18)], run.engine.history)
    assert list(rounded) == [warning]  # it was "since t = 2e-18 s"


def test_nothing_is_computed_beside_the_steps(monkeypatch):
    run = pressed()
    monkeypatch.setattr(Caller, "__call__", None)  # a call of a model's function fails
    observer = LastingContacts(run.engine.model)
    observer.take(run.engine.history, 0)
    assert observer.contacts == run.engine.findings.lasting != ()


def test_lasting_contacts_are_those_of_a_grid_followed_when_read_and_none_without_v0():
    kept, alone = pressed(), pressed(grid=2)
    assert kept.engine.findings.lasting == alone.engine.findings.lasting != ()
    run = simulate(ball(), duration="1 ms", tolerance=1e-6, compiled=False)
    assert "lasting" not in vars(run.engine.findings)  # a third of a short run's time
    assert isinstance(run.warnings, tuple)
    assert "lasting" in vars(run.engine.findings)
    run = simulate(ball("tsuji"), duration="20 ms", tolerance=1e-7, compiled=False)
    assert run.engine.findings.lasting == ()


@pytest.mark.by_turns(4)
@pytest.mark.parametrize("damping", LATCHING)
def test_a_ball_put_down_gently_leaves_every_law_with_v0_and_an_impact_none(damping):
    """It is put on its plane with the least approach speed, and reaches 44 mm/s; or it falls with 1 m/s and leaves with less."""
    options = {"duration": "20 ms", "tolerance": 1e-7, "max_steps": 20_000, "compiled": False}
    down = simulate(ball(damping), **options, parameters={"approach_floor": "1 um/s"})
    assert [left.pair for left in down.engine.findings.lasting] == ["floor"]
    assert down.engine.findings.lasting[0].ratio > 100
    assert any("exceed the damping law" in text for text in down.warnings)
    hit = simulate(ball(damping), **options, parameters={"sunk": "-1 mm", "rising": "-1 m/s"})
    assert len(hit.impacts) == 1
    assert hit.impacts[0].duration is not None
    assert hit.engine.findings.lasting == ()
    assert not any("exceed the damping law" in text for text in hit.warnings)


def test_the_flagship_says_since_when_and_how_much():
    """Its pin comes to stay at about 0.2 s, with an approach speed that is chance."""
    crank = load("slider_crank")
    runs = [simulate(crank, duration="0.3 s", tolerance=1e-6, grid=output, compiled=False) for output in (2, None)]
    first, second = (run.engine.findings.lasting for run in runs)
    assert first == second  # whatever is kept
    worst = max(first, key=lambda left: left.ratio)
    assert 0.15 < worst.since < 0.25
    assert worst.ratio > 5
    impacts = {impact.t: impact for impact in runs[0].impacts}
    for left in first:
        assert impacts[left.since].speed == pytest.approx(left.speed, rel=1e-9)
        ends = left.since + (impacts[left.since].duration or np.inf)
        booked = np.interp((left.since, ends), runs[1].t, runs[1]["slider_pin.dissipated"])
        assert left.dissipated == pytest.approx(booked[1] - booked[0], rel=1e-6)
    (text,) = (text for text in runs[0].warnings if "exceed the damping law" in text)
    assert f"since t = {worst.since:.4g} s ({len(first)} contacts, " in text


def test_a_share_too_small_to_be_a_number_is_said_to_be_small():
    """It was "0% of its dissipation"."""
    run = simulate(load("bouncing_ball"), duration="5 s", parameters={"restitution": 0.7}, tolerance=1e-8)
    (warning,) = (text for text in run.warnings if "exceed the damping law" in text)
    assert ", less than 1% of its dissipation)" in warning
