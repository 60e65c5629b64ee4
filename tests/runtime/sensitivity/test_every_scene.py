"""Derivatives of every built-in scene beside extrapolated differences of runs, by every method and in both coordinates."""

import numpy as np
import pytest

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.model.build import built_in_scenes
from hertzwerk.runtime.model.si_values import si_units

pytestmark = pytest.mark.exhaustive

METHODS = {"dop853": 1e-12, "dopri5": 1e-11, "auto": 1e-11, "esdirk": 1e-10, "rodas": 1e-10}
SHORT = {  # within the horizon of derivatives: with some impacts, before they have grown a thousandfold
    "ball_between_walls": "50 ms", "bouncing_ball": "2 s", "four_bar_clearance": "6 ms", "newtons_cradle": "0.5 s",
    "slider_crank": "1.5 ms", "slider_crank_frictionless": "1.5 ms", "slider_crank_two_clearances": "1.5 ms",
    "slider_crank_three_clearances": "1.5 ms", "slider_crank_dc_motor": "1.5 ms", "spatial_slider_crank": "3 ms",
    "translational_clearance": "3 ms", "two_spheres": "50 ms", "soft_ball": "1 s", "journal_in_bearing": "3 ms",
    "cam_follower": "10 ms", "woodpecker": "20 ms", "andrews_squeezer": "3 ms", "geared_hoist": "0.2 s",
    "gears_with_backlash": "15 ms", "geneva_drive": "30 ms",
}  # fmt: skip
TELLING = ("restitution", "clearance", "friction", "mu", "mass", "gravity", "stiffness", "length", "inertia")
BOUND = 2e-5  # of the largest derivative of a history: what the runs themselves err by, at their tolerances
SEEN = 1e-8  # of a state, by a change of a parameter of its own size: less is the rounding of what is zero by structure


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("scene", built_in_scenes())
def test_a_scene(scene, coordinates, method):
    try:
        model = load(scene, coordinates=coordinates)
    except InputError as refused:
        pytest.skip(str(refused).splitlines()[0])
    how = {"duration": SHORT.get(scene, "0.2 s"), "tolerance": METHODS[method], "method": method, "compiled": False}
    bound, units = model.bind(), si_units(model)
    named = [name for name in model.parameters if bound[name] and any(part in name for part in TELLING)][:5]
    named = named or [*model.parameters][:3]
    states = [*model.coordinates, *model.speeds]
    run = simulate(model, **how)
    found, judged = run.sensitivities(*named), 0
    assert found.reason == ""
    for name in named:

        def ends(value, name=name):
            changed = simulate(model, parameters={name: (value, units[name] or "1")}, **how)
            return np.array([changed.final[state] for state in states])

        by = [1e-4 * bound[name] / 2**k for k in range(3)]
        try:
            first = [(ends(bound[name] + d) - ends(bound[name] - d)) / (2 * d) for d in by]
        except InputError:
            continue  # at the end of its range
        second = [(4 * first[k + 1] - first[k]) / 3 for k in range(2)]
        expected = (16 * second[1] - second[0]) / 15
        for state, value, doubt in zip(states, expected, np.abs(expected - second[1]), strict=True):
            history = found[state, name]
            size = np.abs(history).max()
            if size * abs(bound[name]) > SEEN and doubt <= 1e-7 * size:
                judged += 1
                assert abs(history[-1] - value) <= BOUND * size, (name, state, history[-1], value)
    assert judged or not named
