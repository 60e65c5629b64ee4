"""Elastic-plastic impacts: restitution and dent against quadrature of the laws, the dent found again, what does not fit."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from bench import evaluate
from mpmath import mp, mpf
from pytest import approx

import hertzwerk.derive as hd
from hertzwerk.derive import laws
from hertzwerk.derive.laws.law import F_m, d, d_m, d_r, h_m
from hertzwerk.runtime import equilibrium, load, modes, propagate, simulate, sweep
from hertzwerk.runtime.engine.solution.error_scales import event_differences

RADIUS, DENSITY, MODULUS, POISSON, STRENGTH = 5e-3, 7800.0, 207e9, 0.3, 1e9
MASS = 4 / 3 * np.pi * RADIUS**3 * DENSITY
GAP = 1e-7
LAWS = ("thornton", "kogut_etsion", "jackson_green")


@cache
def scene(**fields):
    """A steel ball that flies against a plane, without gravity; `fields` of its contact."""
    radius, speed = hd.Parameter("radius", "m", RADIUS), hd.Parameter("speed", "m/s", 1)
    E, nu, Y = hd.Parameter("E", "Pa", MODULUS), hd.Parameter("nu", "1", POISSON), hd.Parameter("Y", "Pa", STRENGTH)
    steel = hd.Material(E, nu, yield_strength=Y)
    ball = hd.Body.sphere("ball", radius, density=hd.Parameter("rho", "kg/m^3", DENSITY))
    floor = hd.SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=radius, plane=hd.GROUND.at(0, 0, 0), normal=hd.Y)
    law = getattr(laws, fields.pop("law", "thornton"))
    return hd.Scene(
        hd.Mechanism("flying_ball", (hd.Prismatic("vertical", hd.GROUND, ball, axis=hd.Y),), (floor,)),
        effects=(hd.Contact("floor", law(steel, steel), **fields), hd.EnergyLedger()),
        start=hd.Start(position={"vertical": radius + hd.Parameter("gap", "m", GAP)}, speed={"vertical": -speed}),
        scales=hd.Scales(length=hd.Parameter("depth", "um", 10), speed=speed),
    )


@cache
def model(name):
    return load(scene(law=name))


def numbers(name):
    """Values of a law's symbols for the ball."""
    law, star = laws.LAWS[name], {"E_1": MODULUS, "nu_1": POISSON, "E_2": MODULUS, "nu_2": POISSON, "sigma_y": STRENGTH}
    known = star | {"R_eff": RADIUS, "R_min": RADIUS, "c_p": 1.6}
    values = {symbol: mpf(known[symbol.name]) for symbol in law.symbols() if symbol.name in known}
    for symbol, expression in law.definitions:
        values[symbol] = evaluate(expression, values)
    return law, values


def by_quadrature(name, times):
    """Approach speed [m/s] that reaches a multiple of the depth of first yield, depth, dent [m] and restitution."""
    law, values = numbers(name)
    with mp.workdps(20):
        onset = evaluate(law.onset, values)
        depth = times * onset
        turns = [mpf(turn) for turn in ("1.4831", "1.9", "2", "6.6479")]  # near where the force has kinks
        parts = [0, onset, *(turn * onset for turn in turns if turn < times), depth]
        spent = mp.quad(lambda x: evaluate(law.force, values | {d: x}), parts)
        dent = evaluate(law.dent, values | {d: depth})
        turned = values | {d_m: depth, d_r: dent, h_m: depth - dent, F_m: evaluate(law.force, values | {d: depth})}
        returned = mp.quad(lambda x: evaluate(law.unloading, turned | {d: x}), [dent, depth])
        return (float(x) for x in (mp.sqrt(2 * spent / MASS), depth, dent, mp.sqrt(returned / spent)))


def impact(of, speed, **given):
    return simulate(of, duration=1e-4, tolerance=1e-10, parameters={"speed": (speed, "m/s")}, **given)


@pytest.mark.parametrize("method", ["auto", "rodas"])
@pytest.mark.parametrize("name", LAWS)
def test_restitution_dent_and_energy_are_those_of_the_quadrature(name, method):
    for times in (1.3, 30):
        speed, depth, dent, e = by_quadrature(name, times)
        run = impact(model(name), speed, method=method)
        assert run["vertical.speed"][-1] == approx(e * speed, rel=1e-10 if method == "auto" else 1e-9)
        assert run["floor.deepest"].max() == approx(depth, rel=1e-9)
        assert run["floor.dent"].max() == approx(dent, rel=1e-8)
        assert run["floor.dissipated"][-1] == approx(MASS * speed**2 / 2 * (1 - e**2), rel=1e-8)
        assert run["floor.dent"][-1] == run["floor.stage"][-1] == 0  # the surfaces meet elsewhere the next time


def test_the_dent_of_a_fast_impact_leaves_the_fourth_root_of_the_speed():
    """e ~ v^(-1/4) far above yield (Johnson 1985, 11.5); and e = 1 at and below it."""
    speeds = (40.0, 80.0)
    restitutions = [impact(model("thornton"), speed)["vertical.speed"][-1] / speed for speed in speeds]
    assert np.log(restitutions[0] / restitutions[1]) / np.log(2) == approx(0.25, abs=1e-3)
    run = impact(model("thornton"), 0.1)
    assert run["vertical.speed"][-1] == approx(0.1, rel=1e-10)
    assert run["floor.dissipated"][-1] == 0


def test_a_dent_is_found_again_on_the_same_spot():
    """A second, slower impact is elastic and begins in the dent; a faster one deepens it, as if it had come at first."""
    spot = load(scene(same_spot=True))
    first = impact(spot, 2.0)
    units = {"floor.stage": "1", "floor.deepest": "m", "floor.dent": "m"}
    kept = {name: (first[name][-1], unit) for name, unit in units.items()}
    assert kept["floor.dent"][0] > 1e-6
    slower = impact(spot, 0.9, initial=kept)
    assert slower["vertical.speed"][-1] == approx(0.9, rel=1e-9)
    assert slower["floor.dent"][-1] == kept["floor.dent"][0]
    assert slower.impacts[0].t == approx((GAP + kept["floor.dent"][0]) / 0.9, rel=1e-9)
    faster, fresh = impact(spot, 3.0, initial=kept), impact(spot, 3.0)
    spent = first["floor.dissipated"][-1]
    deep = MASS * 3.0**2 / 2 + spent  # the work of loading from the virgin surface up to there
    assert fresh["floor.deepest"][-1] < faster["floor.deepest"][-1]
    law, values = numbers("thornton")
    with mp.workdps(20):
        onset, depth = evaluate(law.onset, values), mpf(faster["floor.deepest"][-1])
        assert float(mp.quad(lambda x: evaluate(law.force, values | {d: x}), [0, onset, depth])) == approx(
            deep, rel=1e-9
        )
    assert faster.energy_residual < 1e-9


def test_hysteresis_dissipates_beside_the_dent():
    damped = load(scene(damping=laws.hunt_crossley(hd.Parameter("e", "1", 0.9))))
    plain, run = impact(model("thornton"), 2.0), impact(damped, 2.0)
    assert run["vertical.speed"][-1] < 0.95 * plain["vertical.speed"][-1]
    left = MASS * (2.0**2 - run["vertical.speed"][-1] ** 2) / 2
    assert run["floor.dissipated"][-1] == approx(left, rel=1e-8)


def test_the_error_of_a_dent_is_that_of_its_values_not_of_its_time():
    """Two runs have the turn at slightly different times; a dent that is wrong by a part in ten thousand is an error."""
    dents = np.array([[0.0], [0.0], [1.0], [1.0], [1.0], [3.0]])
    early = np.array([[0.0], [1.0], [1.0], [1.0], [3.0], [3.0]])
    assert not event_differences(dents, early).any()
    assert event_differences(dents * 1.0001, early).max() == approx(3e-4)
    run = simulate("yielding_ball", duration="0.8 s", accuracy=1e-7)
    assert run.outcome.name == "finished"
    assert run.error.of("floor.dent") < 1e-7 * run["floor.dent"].max()


def test_a_body_at_rest_loads_its_contact_and_then_rests_on_its_dent():
    """Weight above first yield: penetration in closed form; small vibrations follow the loading, in a run the unloading."""
    heavy = {"gravity": (1e6, "m/s^2")}
    radius, mass = 0.025, 4 / 3 * np.pi * 0.025**3 * DENSITY
    star = MODULUS / (2 * (1 - POISSON**2))
    onset, slope = radius * (np.pi * 1.6 * STRENGTH / (2 * star)) ** 2, np.pi * 1.6 * STRENGTH * radius
    depth = onset + (mass * 1e6 - np.pi**3 * radius**2 * (1.6 * STRENGTH) ** 3 / (6 * star**2)) / slope
    rest = equilibrium("yielding_ball", parameters=heavy)
    assert rest.penetrations["floor"] == approx(depth, rel=1e-9)
    assert modes(rest).frequencies[0] == approx(np.sqrt(slope / mass) / (2 * np.pi), rel=1e-6)
    assert "loads" in modes(rest).notes[0]
    run = simulate("yielding_ball", duration="1 ms", tolerance=1e-9, parameters=heavy, initial=rest)
    assert np.ptp(run["vertical.travel"]) < 1e-8 * depth
    lift = depth - run["floor.dent"][-1]
    assert modes(run).frequencies[0] == approx(np.sqrt(1.5 * 1e6 / lift) / (2 * np.pi), rel=1e-6)


def test_derivatives_pass_the_events_of_a_dent():
    how, step = {"duration": "0.8 s", "tolerance": 1e-11}, 1e4
    found = simulate("yielding_ball", **how, sensitivities=("yield_strength",)).sensitivities()
    runs = (simulate("yielding_ball", **how, parameters={"yield_strength": (1e9 + h, "Pa")}) for h in (step, -step))
    speeds = [run.impacts[1].speed for run in runs]
    assert found.impacts("speed", "yield_strength")[1] == approx((speeds[0] - speeds[1]) / (2 * step), rel=1e-5)


def test_studies_of_a_dent_are_those_of_single_runs():
    """A sweep has the same bits; the first order of an uncertain speed is that of two runs beside its mean."""
    options = {"duration": 1e-4, "tolerance": 1e-8, "compiled": False}
    spot = load(scene(same_spot=True))
    low, high, mean = (
        simulate(spot, parameters={"speed": (v, "m/s")}, **options)["floor.dent"][-1] for v in (1.98, 2.02, 2.0)
    )
    rows = sweep(spot, {"speed": "1.98, 2 m/s"}, outputs=("final.floor.dent",), workers=1, **options)
    assert rows["final.floor.dent"].tolist() == [low, mean]
    spread = propagate(
        spot, {"speed": "Normal(2 m/s, 0.01 m/s)"}, ("final.floor.dent",), sample=8, workers=1, **options
    ).outputs["final.floor.dent"]
    assert spread.linear == approx((high - low) / 0.04 * 0.01, rel=3e-4)
    assert spread.linear != approx((mean - low) / 0.02 * 0.01, rel=3e-4)  # what the comparison above would see


def test_laws_made_for_elastic_contact_and_spots_without_a_dent_are_refused():
    with pytest.raises(hd.InputError, match="law tsuji beside thornton"):
        scene(damping=laws.tsuji(hd.Parameter("e", "1", 0.9)))
    with pytest.raises(hd.InputError, match="smooth with thornton"):
        scene(smooth="1 um")
    elastic = laws.power(hd.Parameter("K", "N/m^1.5", 1e9), n=1.5)
    with pytest.raises(hd.InputError, match="leaves no dent"):
        scene().replace(floor=replace(scene().effect("floor"), stiffness=elastic, same_spot=True))
