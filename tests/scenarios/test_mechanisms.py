"""Mechanisms against closed forms: pendulums, the centrifugal governor, Newton's cradle, several clearances at once, a journal under load."""

from dataclasses import replace
from functools import cache

import mpmath
import numpy as np
import pytest
from scipy.optimize import brentq

from hertzwerk.derive import ConstantSpeed
from hertzwerk.derive.scenes.flyball_governor import scene, w
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from reference import flights

model = cache(engine_model)


def test_a_pendulum_swings_as_its_elliptic_function_says():
    """From -90 degrees: sin(angle/2) = -k cd(w t, k), from which the scenario has its digits."""
    run = simulate(model("pendulum"), duration=10.0, tolerance=1e-12)
    with mpmath.workdps(30):
        m, w = mpmath.sin(mpmath.pi / 4) ** 2, mpmath.sqrt(mpmath.mpf("9.81"))
        for t in np.linspace(0, 10, 41):
            expected = -2 * mpmath.asin(mpmath.sqrt(m) * mpmath.ellipfun("cd", w * mpmath.mpf(t), m=m))
            assert run.at([t])["hinge.angle"][0] == pytest.approx(float(expected), abs=1e-9)


# ---- the governor ----------------------------------------------------------------------------------------------------


class Governor:
    """The governor as one freedom, by hand: its moment of inertia about the spindle, its potential energy, by the angle of the arms."""

    l, h, a, m, R, rod, g, k, rest = 0.3, 0.2, 0.03, 2.0, 0.04, 0.2, 9.81, 400.0, 0.35
    start, speed = np.radians(30), 160 * 2 * np.pi / 60

    def lean(self, angle):
        """Of the rods."""
        return np.arcsin(self.l * np.sin(angle) / (2 * self.h))

    def height(self, angle):
        """Of the hinges above the collar."""
        return self.l * np.cos(angle) / 2 + self.h * np.cos(self.lean(angle))

    def inertia(self, angle):
        """About the spindle's axis."""
        ball = self.m * (self.a + self.l * np.sin(angle)) ** 2 + 0.4 * self.m * self.R**2
        rod = self.rod * ((self.a + self.l * np.sin(angle) / 4) ** 2 + (self.h * np.sin(self.lean(angle))) ** 2 / 12)
        return 0.05 + 0.003 + 2 * (ball + rod)

    def potential(self, angle):
        """Of weights and spring."""
        rods = self.l * np.cos(angle) / 2 + self.h * np.cos(self.lean(angle)) / 2
        weights = 2 * self.m * self.l * np.cos(angle) + 2 * self.rod * rods + 1.5 * self.height(angle)
        return -self.g * weights + self.k * (self.rest - self.height(angle)) ** 2 / 2

    @property
    def momentum(self):
        """About the spindle, constant."""
        return self.inertia(self.start) * self.speed

    def surplus(self, angle):
        """Energy that is left for opening or closing."""
        at_start = self.momentum**2 / (2 * self.inertia(self.start)) + self.potential(self.start)
        return at_start - self.momentum**2 / (2 * self.inertia(angle)) - self.potential(angle)


def test_the_governor_keeps_energy_loops_and_angular_momentum_and_turns_back_where_it_must():
    governor = Governor()
    run = simulate(model("flyball_governor"), duration=4.0, tolerance=1e-11)
    assert run.outcome.finished, run
    assert run.energy_residual < 1e-9
    assert max(np.max(np.abs(run[name])) for name in run if ".apart_" in name) < 1e-9
    dense = run.at(np.linspace(0, 4, 8001))
    angle = dense["right_hinge.angle"]
    assert dense["left_hinge.angle"] == pytest.approx(angle, abs=1e-9)
    assert dense["spindle.speed"] == pytest.approx(governor.momentum / governor.inertia(angle), rel=1e-9)
    assert dense["guide.travel"] == pytest.approx(-governor.height(angle), abs=1e-9)
    furthest = brentq(governor.surplus, 1.0, 1.5, xtol=1e-14)
    assert np.max(angle) == pytest.approx(furthest, abs=1e-6)
    assert np.min(angle) == pytest.approx(governor.start, abs=1e-6)
    (warning,) = run.warnings
    assert "right_foot.force_z, left_foot.force_z" in warning  # across the plane that turns


def test_a_driven_governor_keeps_its_loops():
    """The same constraints where the spindle's motion is given and has no row of its own."""
    start = replace(scene.start, speed={})
    driven = replace(scene, effects=(ConstantSpeed("motor", "spindle", w), *scene.effects), start=start)
    run = simulate(engine_model(driven), duration=2.0, tolerance=1e-10, parameters={"start_speed": "100 rpm"})
    assert run.outcome.finished, run
    assert run.energy_residual < 1e-8
    angle = run.at(np.linspace(0, 2, 2001))["right_hinge.angle"]
    governor, speed = Governor(), 100 * 2 * np.pi / 60

    def effective(angle):  # seen from the turning spindle
        return governor.potential(angle) - governor.inertia(angle) * speed**2 / 2

    furthest = brentq(lambda a: effective(a) - effective(governor.start), governor.start + 0.05, 1.55, xtol=1e-14)
    assert np.max(angle) == pytest.approx(furthest, abs=1e-5)


# ---- Newton's cradle -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("e", [1.0, 0.95, 0.8])
def test_the_first_transfer_through_newtons_cradle(e):
    """Impacts of two, one after the other: (1 + e)/2 of the speed goes on and e of the closing speed returns; each sphere rises over its gap."""
    run = simulate(model("newtons_cradle"), duration=0.3, tolerance=1e-10, parameters={"restitution": e})
    g, L, R, gap = 9.81, 0.25, 0.02, 0.8e-3
    share = 1 / (1 + 0.4 * (R / L) ** 2)  # m L^2 of the moment of inertia about the pivot
    m = 7800 * 4 / 3 * np.pi * R**3
    speed = np.sqrt(2 * g * L * share * (np.cos(np.arcsin(gap / L)) - np.cos(np.radians(30))))
    firsts = [next(hit for hit in run.impacts if hit.contact == f"contact_{i}") for i in range(4)]
    lost = 0.0
    for hit in firsts:
        assert hit.speed == pytest.approx(speed, rel=2e-4)
        lost += m / share / 4 * (1 - e**2) * speed**2
        speed = np.sqrt(((1 + e) / 2 * speed) ** 2 - share * g * gap**2 / L)
    assert [hit.t for hit in firsts] == sorted(hit.t for hit in firsts)
    end = firsts[-1].t + firsts[-1].duration
    times = np.linspace(firsts[0].t, end, 2001)
    transfer = run.at(times)
    momentum = sum(transfer[f"string_{i}.speed"] for i in range(5))
    weights = -share * g / L * sum(np.sin(transfer[f"string_{i}.angle"]) for i in range(5))
    pulled = np.sum((weights[1:] + weights[:-1]) / 2 * np.diff(times))
    assert abs(pulled) > 1e-4 * momentum[0]
    assert momentum[-1] - momentum[0] == pytest.approx(
        pulled, abs=6e-5 * momentum[0]
    )  # the normals are not quite level
    after = run.at([end])
    assert after["string_4.speed"][0] * L == pytest.approx(speed, rel=3e-4)
    dissipated = sum(after[f"contact_{i}.dissipated"][0] for i in range(4))
    assert dissipated == pytest.approx(lost, rel=1e-3, abs=1e-9)
    assert run.energy_residual < 1e-8


# ---- a journal under load --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("load_N", "mu", "n"), [(500, 0.2, 1.5), (200, 0.1, 1.5), (500, -1, 1.5)])
def test_a_loaded_journal_settles_where_its_contact_force_is_the_load(load_N, mu, n):
    """K d^n = W/sqrt(1 + mu'^2) with mu' the smoothed coefficient at the speed of its surface; the normal leans by atan(mu') against the rotation."""
    backwards = mu < 0
    mu = abs(mu) / 5 if backwards else mu
    parameters = {"load": f"{load_N} N", "friction_coefficient": mu, "speed": f"{-100 if backwards else 100} rpm"}
    run = simulate(model("journal_in_bearing"), duration=2.0, tolerance=1e-9, parameters=parameters)
    w, R, c, K = 100 * 2 * np.pi / 60, 9.5e-3, 0.5e-3, 1e10
    smoothed = mu * np.tanh(w * R / 0.1)
    force = load_N / np.hypot(1, smoothed)
    away, lean = c + (force / K) ** (1 / n), np.arctan(smoothed)
    side = 1 if backwards else -1
    assert run.engine.final["shaft.x"] == pytest.approx(side * away * np.sin(lean), rel=1e-6)
    assert run.engine.final["shaft.y"] == pytest.approx(-away * np.cos(lean), rel=1e-6)
    assert run["bearing.normal_force"][-1] == pytest.approx(force, rel=1e-6)
    times = np.array([1.8, 2.0])
    work = np.diff(run.at(times)["energy_ledger.input"])[0]
    assert work / 0.2 == pytest.approx(smoothed * force * w * R, rel=1e-6)  # all the motor does is rub
    assert run.energy_residual < 1e-9


# ---- clearances ------------------------------------------------------------------------------------------------------

FLIGHTS = {
    "slider_crank_two_clearances": lambda: flights.slider_crank(floating=False),
    "slider_crank_dc_motor": lambda: flights.slider_crank(floating=False),
    "slider_crank_three_clearances": lambda: flights.slider_crank(floating=True),
    "four_bar_clearance": flights.four_bar,
}
TURN = {
    "slider_crank_two_clearances": 0.012, "slider_crank_three_clearances": 0.012, "slider_crank_dc_motor": 0.012, "four_bar_clearance": 0.06,
}  # s  # fmt: skip


@pytest.mark.parametrize("name", FLIGHTS)
def test_the_first_impact_of_several_clearances(name):
    contact, t, speed = FLIGHTS[name]()
    hit = simulate(model(name), duration=2.5e-3, tolerance=1e-10).impacts[0]
    assert hit.contact == contact
    assert hit.t == pytest.approx(t, rel=1e-10)
    assert hit.speed == pytest.approx(speed, rel=1e-7)


@pytest.mark.parametrize("name", TURN)
def test_no_pin_leaves_its_bush_and_no_energy_goes_missing(name):
    """Over two turns; input, dissipation and stored energy close, and dissipation never runs backwards."""
    run = simulate(model(name), duration=2 * TURN[name], tolerance=1e-8)
    assert run.outcome.finished, run
    assert run.energy_residual < 1e-6
    assert {hit.contact for hit in run.impacts} == set(run.engine.model.pairs)
    for pair in run.engine.model.pairs:
        away = np.hypot(run[f"{pair}.eccentricity_x"], run[f"{pair}.eccentricity_y"])
        assert np.max(away) < 0.5e-3 + 0.15e-3  # deepest impact
        assert np.max(away) > 0.5e-3
    for entry in run.engine.model.memory:
        if entry.endswith(".dissipated"):
            assert np.min(np.diff(run[entry])) > -1e-9 * run[entry][-1]
