"""Lubricated joints in motion: equilibria and squeeze against closed forms, the way into dry contact, a slider-crank on oil."""

from dataclasses import replace
from functools import cache

import film
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hertzwerk.derive import Parameter, Scales
from hertzwerk.derive.scenes.journal_lubricated import R, c, scene
from hertzwerk.runtime import load, simulate

ETA, PIN, LENGTH, C, MASS = 0.05, 0.02 - 50e-6, 0.01, 50e-6, 2.0
STILL = replace(
    scene, scales=Scales(length=c, speed=Parameter("pace", "m/s", 0.1), arm=R)
)  # its own measure of speed is that of the motor


@cache
def model(which):
    """The journal at rest or turning, on a short or a long bearing."""
    return load({"short": scene, "long": scene.with_law("oil", "long_bearing"), "still": STILL}[which])


@pytest.mark.parametrize(("which", "load_", "speed"), [("short", 1200, 3000), ("long", 6000, 1500)])
def test_a_journal_settles_where_its_film_holds_the_load(which, load_, speed):
    """Load and attitude angle of Ocvirk's short bearing and of the half-Sommerfeld long one, at other loads and speeds than the scenario's."""
    w = speed * 2 * np.pi / 60

    def film(eps):
        """Back to the centre, and onwards [N]."""
        q = np.sqrt(1 - eps**2)
        if which == "short":
            return ETA * w * PIN * LENGTH**3 / C**2 * np.array([eps**2 / q**4, np.pi * eps / (4 * q**3)])
        return ETA * w * PIN**3 * LENGTH / C**2 * 6 * eps / (2 + eps**2) * np.array([2 * eps / q**2, np.pi / q])

    eps = brentq(lambda eps: np.hypot(*film(eps)) - load_, 0.1, 0.97, xtol=1e-15)
    angle = np.arctan2(*film(eps)[::-1])
    given = {"load": (load_, "N"), "speed": (speed, "rpm")}
    run = simulate(model(which), duration=0.2, tolerance=1e-9, method="rodas", parameters=given)
    assert run["shaft.x"][-1] == pytest.approx(eps * C * np.sin(angle), rel=1e-8)
    assert run["shaft.y"][-1] == pytest.approx(-eps * C * np.cos(angle), rel=1e-8)
    assert run["oil.thickness"].min() > 1e-6  # thicker than two layers, where the law is all there is
    assert len(run.impacts) == 0


def test_a_journal_that_does_not_turn_sinks_by_the_law_of_its_squeeze():
    """m c eps'' = W - eta R L^3/c^2 J(eps) eps', J of the half film that closes (Booker 1965), integrated apart from the engine."""

    def rates(_, y):
        eps, rate = y
        q = np.sqrt(1 - eps**2)
        J = ((np.pi / 2 + np.arcsin(eps)) * (1 + 2 * eps**2) + 3 * eps * q) / q**5
        return [rate, (300 - ETA * PIN * LENGTH**3 / C**2 * J * rate) / (MASS * C)]

    times = np.linspace(0, 0.02, 11)
    sunk = solve_ivp(rates, (0, 0.02), [0, 0], method="Radau", rtol=1e-11, atol=1e-14, t_eval=times).y[0]
    run = simulate(model("still"), duration=0.02, tolerance=1e-11, method="rodas", parameters={"speed": (0, "rpm")})
    assert -run.at(times)["shaft.y"] / C == pytest.approx(sunk, rel=1e-8, abs=1e-10)
    assert sunk[-1] > 0.8
    assert np.abs(run["shaft.x"]).max() == 0


def test_a_film_too_thin_to_bear_gives_way_to_dry_contact():
    """The journal sinks through its film and comes to rest on the bush: K d^1.5 = W, deeper than the boundary layer, the film gone."""
    thin = {"speed": (0, "rpm"), "viscosity": (5e-4, "Pa s")}
    run = simulate(model("still"), duration=0.2, tolerance=1e-9, method="rodas", parameters=thin)
    assert run.outcome.name == "finished"
    assert run["bearing.penetration"][-1] == pytest.approx((300 / 1e10) ** (2 / 3), rel=1e-6)
    assert len(run.impacts) == 1
    assert run["oil.force"].max() > 250  # on the way
    assert run["oil.force"][-1] == 0
    assert run["oil.thickness"].min() == pytest.approx(0.5e-6, rel=1e-9)
    assert np.all(np.diff(run["oil.dissipated"]) >= 0)
    assert run.energy_residual < 1e-7


@pytest.fixture(scope="module")
def oiled():
    """The slider-crank whose pin runs in oil."""
    return load("lubricated_slider_crank")


def test_oil_keeps_the_pin_of_a_slider_crank_off_its_bush(oiled):
    """Two methods that share nothing agree; the ledger closes; what was three impacts is a film."""
    runs = [
        simulate(oiled, duration="12 ms", tolerance=tolerance, method=method, parameters={"viscosity": (0.4, "Pa s")})
        for method, tolerance in (("rodas", 1e-8), ("dop853", 1e-9))
    ]
    for run in runs:
        assert len(run.impacts) == 0
        assert run.energy_residual < 1e-7
        assert run["oil.thickness"].min() > 5e-6
        assert np.all(np.diff(run["oil.dissipated"]) >= 0)
    one, two = (run["guide.travel"][-1] for run in runs)
    assert one == pytest.approx(two, abs=1e-6 * 0.5e-3)


def test_a_pin_breaks_through_its_film_when_reynolds_equation_lets_it(oiled, monkeypatch):
    """Up to the first dry contact: the mechanism derived by hand, the film by quadrature, limited from two layers on as the page states."""
    layer, c, r, l, w = 5e-6, 5e-4, 0.05, 0.12, 5000 * 2 * np.pi / 60
    for name, value in {"ETA": 0.005, "PIN": 0.01 - c, "LENGTH": 0.015, "C": c}.items():
        monkeypatch.setattr(film, name, value)

    def apart(t, y):
        (theta, x, spin, speed), along = y, np.array([np.cos(w * t), np.sin(w * t)])
        rod = l * np.array([np.cos(theta), np.sin(theta)])
        e = r * along + rod - [x, 0] + [1e-18, 0]  # off the centre, where at rest nothing bears
        return rod, e, r * w * np.array([-along[1], along[0]]) + spin * np.array([-rod[1], rod[0]]) - [speed, 0]

    def rates(t, y):
        rod, e, rate = apart(t, y)
        x = min(max(1 - (c - np.hypot(*e)) / (2 * layer), 0), 1)
        limited = e if x == 0 else e * (c - 2 * layer * (1 - x + x**3 - x**4 / 2)) / np.hypot(*e)
        midway = rate - y[2] / 2 * np.array([limited[1] - e[1], e[0] - limited[0]])
        *force, moment = film.by_quadrature("short_bearing", limited, midway, y[2])[:3]
        arm = (
            rod - e / 2 + limited / 2
        )  # of the middle, to which the force belongs, and its moment about the limited centre
        turning = arm[0] * force[1] - arm[1] * force[0] + moment
        turning += 0.21 * 0.06 * (r * w**2 * np.sin(w * t - y[0]) - 9.81 * np.cos(y[0]))
        return [y[2], y[3], turning / (2.5e-4 + 0.21 * 0.06**2), -force[0] / 0.14]

    def gap(t, y):
        return c - np.hypot(*apart(t, y)[1])

    gap.terminal = True
    start = [0, r + l, -w * r / l, 0]
    flown = solve_ivp(rates, (0, 1e-3), start, method="DOP853", rtol=1e-8, atol=[1e-10, 5e-12, 1e-6, 1e-7], events=gap)
    run = simulate(oiled, duration="0.7 ms", tolerance=1e-9)
    assert run.impacts[0].t == pytest.approx(flown.t[-1], rel=1e-6)
    assert run["oil.thickness"].min() == pytest.approx(layer, rel=1e-6)
    assert run.energy_residual < 1e-8
