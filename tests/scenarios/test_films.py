"""Lubricated joints in motion: equilibria and squeeze against closed forms, the way into dry contact, a slider-crank on oil."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hertzwerk.derive import Lubrication, Parameter, Scales
from hertzwerk.derive.laws import short_bearing
from hertzwerk.derive.scenes.journal_lubricated import R, c, scene
from hertzwerk.derive.scenes.slider_crank import scene as crank
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
    """The slider-crank whose pin runs in oil, a variation of the scene."""
    pair = replace(crank.mechanism.pairs[0], length=Parameter("joint_length", "mm", 10))
    film = Lubrication(
        "slider_pin_film", "slider_pin", short_bearing(Parameter("viscosity", "Pa s", 0.4)), Parameter("layer", "um", 5)
    )
    *effects, ledger = crank.effects
    return load(
        replace(
            crank,
            name="oiled_crank",
            mechanism=replace(crank.mechanism, pairs=(pair,)),
            effects=(*effects, film, ledger),
        )
    )


def test_oil_keeps_the_pin_of_a_slider_crank_off_its_bush(oiled):
    """Two methods that share nothing agree; the ledger closes; what was three impacts is a film."""
    runs = [
        simulate(oiled, duration="12 ms", tolerance=tolerance, method=method)
        for method, tolerance in (("rodas", 1e-8), ("dop853", 1e-9))
    ]
    for run in runs:
        assert len(run.impacts) == 0
        assert run.energy_residual < 1e-7
        assert run["slider_pin_film.thickness"].min() > 5e-6
        assert np.all(np.diff(run["slider_pin_film.dissipated"]) >= 0)
    one, two = (run["guide.travel"][-1] for run in runs)
    assert one == pytest.approx(two, abs=1e-6 * 0.5e-3)
    dry = simulate(oiled, duration="12 ms", tolerance=1e-6, parameters={"viscosity": (1e-3, "Pa s")})
    assert len(dry.impacts) > 0
