"""How often intervals hold the truth, and how often another law is rejected: many seeds (exhaustive)."""

import numpy as np
import pytest

from hertzwerk.runtime import MeasuredImpacts, Measurement, fit, simulate
from hertzwerk.runtime.loading import engine_model

SEEDS = 200
HELD = range(179, 199)  # of 200 intervals of 95 %: binomial, 0.4 % of right ones lie below or above
SCENES = {  # true values and what is free; what is measured, its noise [SI]; times or impacts
    "bouncing_ball": ({"restitution": "0.85", "drop_height": "0.9 m"}, {"restitution": (0.5, 1), "drop_height": "0.5..1.5 m"},
                      {"vertical.travel": 2e-3}, np.linspace(0.05, 1.5, 60)),
    "soft_ball": ({"stiffness": "1.2e8 N/m^1.5", "drop_height": "1.002 m"}, {"stiffness": "3e7..5e8 N/m^1.5 log", "drop_height": "0.95..1.05 m"},
                  {"vertical.speed": 5e-2}, np.linspace(0.44, 0.47, 120)),
    "ball_between_walls": ({"restitution": "0.8", "speed": "9 m/s"}, {"restitution": (0.5, 1), "speed": "5..15 m/s"},
                           {"impacts.t": 1e-3, "impacts.speed": 5e-2}, 5),
    "two_spheres": ({"restitution": "0.75"}, {"restitution": (0.3, 1)}, None, np.linspace(0.01, 0.1, 40)),
    "slider_crank": ({"restitution": "0.85", "clearance": "0.45 mm"}, {"restitution": (0.6, 1), "clearance": "0.3..0.7 mm"},
                     {"guide.acceleration": 300.0, "guide.travel": 2e-5}, np.linspace(2e-4, 2.8e-3, 80)),
}  # fmt: skip


def measured(run, noise, at, rng):
    """Data of a run with noise, and what they are compared with."""
    names = {name: f"y{k}" for k, name in enumerate(noise)}
    if isinstance(at, int):
        parts = {name: np.array([getattr(i, name.rpartition(".")[2]) for i in run.impacts[:at]]) for name in noise}
        units = {names[name]: {"t": "s", "speed": "m/s"}[name.rpartition(".")[2]] for name in noise}
        made = {names[n]: y + rng.normal(0, noise[n], at) for n, y in parts.items()}
        return MeasuredImpacts(np.arange(1, at + 1), made, units), names
    rows = run.at(at)
    made = {names[n]: rows[n] + rng.normal(0, noise[n], len(at)) for n in noise}
    return Measurement(at, made, {names[n]: run.engine.history.units[n] for n in noise}), names


@pytest.mark.exhaustive
@pytest.mark.parametrize("scene", SCENES)
def test_intervals_hold_the_truth_as_often_as_they_say(scene):
    model, (true, free, noise, at) = engine_model(scene), SCENES[scene]
    if noise is None:
        noise = dict.fromkeys(model.speeds, 5e-3)
    duration = 2.0 if isinstance(at, int) else float(at[-1]) * 1.0001
    run = simulate(model, duration=duration, tolerance=1e-11, parameters=true)
    bound, held, explained = model.bind(true), dict.fromkeys(free, 0), 0
    units = {
        name: run.engine.history.units.get(name, {"t": "s", "speed": "m/s"}.get(name.rpartition(".")[2]))
        for name in noise
    }
    for seed in range(SEEDS):
        data, names = measured(run, noise, at, np.random.default_rng(seed))
        fitted = fit(
            model, data, free=free, map={c: n for n, c in names.items()}, noise={names[n]: (s, units[n]) for n, s in noise.items()},
            duration=duration, starts=0,
        )  # fmt: skip
        explained += bool(fitted.explained)
        for name in free:
            held[name] += fitted[name].interval.low <= bound[name] <= fitted[name].interval.high
    print(scene, held, explained)
    assert all(count in HELD for count in held.values()), held
    assert explained in HELD


@pytest.mark.exhaustive
def test_data_of_another_law_are_rejected():
    """Force of a ball with Tsuji's damping, fitted with that of Flores: its shape differs by three times the noise."""
    model, other = engine_model("bouncing_ball"), engine_model("bouncing_ball", laws={"floor": "tsuji"})
    at, how = (
        np.linspace(0.4516, 0.4545, 60),
        {"free": {"restitution": (0.05, 1), "stiffness": "3e7..5e8 N/m^1.5 log"}, "map": {"f": "floor.normal_force"}},
    )
    run = simulate(
        other, duration=0.4546, tolerance=1e-11, parameters={"restitution": "0.6", "stiffness": "1.4e8 N/m^1.5"}
    )
    clean = run.at(at)["floor.normal_force"]
    best = fit(model, Measurement(at, {"f": clean}, {"f": "N"}), starts=4, profile=False, **how)
    sigma = float(np.max(np.abs(best.signals[0].measured - best.signals[0].predicted))) / 3
    rejected = 0
    for seed in range(50):
        data = Measurement(at, {"f": clean + np.random.default_rng(seed).normal(0, sigma, len(at))}, {"f": "N"})
        rejected += fit(model, data, noise={"f": (sigma, "N")}, starts=0, profile=False, **how).explained is False
    print("rejected", rejected, "of 50 at", sigma, "N")
    assert rejected >= 45
