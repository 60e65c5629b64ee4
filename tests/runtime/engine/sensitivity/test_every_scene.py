"""Derivatives of every built-in scene beside extrapolated differences of runs, by every method and in both coordinates."""

from functools import cache

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.model.build import built_in_scenes
from hertzwerk.runtime.engine.model.si_values import si_units
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.exhaustive

METHODS = {"dop853": 1e-12, "dopri5": 1e-12, "auto": 1e-11, "esdirk": 1e-12, "rodas": 1e-11}
TIGHTEST = 1e-13  # tolerance of the runs that differences are taken of, by dop853
NOISY = (2e-13, 3e-13)  # of two that tell their noise: one may end by chance as the tightest does
SHORT = {  # within the horizon of derivatives: with some impacts, before they have grown a thousandfold
    "ball_between_walls": "50 ms", "bouncing_ball": "2 s", "four_bar_clearance": "6 ms", "newtons_cradle": "0.5 s",
    "slider_crank": "1.5 ms", "slider_crank_line": "1.5 ms", "slider_crank_frictionless": "1.5 ms",
    "slider_crank_two_clearances": "0.7 ms", "slider_crank_three_clearances": "1.5 ms", "slider_crank_dc_motor": "1.5 ms",
    "spatial_slider_crank": "3 ms", "translational_clearance": "3 ms", "two_spheres": "50 ms", "soft_ball": "1 s", "journal_in_bearing": "3 ms",
    "cam_follower": "5 ms", "woodpecker": "20 ms", "andrews_squeezer": "3 ms", "geared_hoist": "0.2 s",
    "gears_with_backlash": "15 ms", "geneva_drive": "30 ms", "ball_bearing": "0.3 ms", "ball_on_oil": "8 ms",
}  # fmt: skip
TELLING = ("lift", "thinning", "rim", "radius", "restitution", "clearance", "friction", "mu", "mass", "gravity", "stiffness",
           "length", "inertia")  # fmt: skip
STEP, HALVINGS = 1e-3, 5  # of a parameter: the first, largest difference, and how many there are
BOUND, SURE = 1e-6, 1e-7  # of the largest derivative of a history: error, and doubt in a difference that can judge it
SEEN = 1e-8  # of a state, by a change of a parameter of its own size: less is the rounding of what is zero by structure


@cache
def case(scene, coordinates):
    """Model, names, states, and of each name the difference of the states at the end and the doubt in it."""
    try:
        model = engine_model(scene, coordinates=coordinates)
    except InputError as refused:
        pytest.skip(str(refused).splitlines()[0])
    bound, units = model.bind(), si_units(model)
    named = [name for name in model.parameters if bound[name] and any(part in name for part in TELLING)][:6]
    named = named or [*model.parameters][:3]
    states = [*model.coordinates, *model.speeds]

    def ends(changed, tolerance=TIGHTEST):
        given = {name: (value, units[name] or "1") for name, value in changed.items()}
        how = {"duration": SHORT.get(scene, "0.2 s"), "method": "dop853", "compiled": False}
        run = simulate(model, tolerance=tolerance, parameters=given, **how)
        return np.array([run.engine.final[state] for state in states])

    exact = ends({})
    noise = np.max([np.abs(exact - ends({}, tolerance)) for tolerance in NOISY], axis=0)
    found = {}
    for name in named:
        try:
            found[name] = ridders(lambda value, name=name: ends({name: value}), bound[name], noise)
        except InputError:
            continue  # at the end of its range
    return model, named, states, found


def ridders(function, at, noise):
    """Derivative and the doubt in it, of extrapolated central differences those in least doubt.

    Ridders, Adv. Eng. Software 4 (1982) 75. Two of them may be near by chance: below their noise none is sure.
    """
    rows, best, least = [], None, np.inf
    for k in range(HALVINGS):
        step = abs(at) * STEP / 2**k
        row = [(function(at + step) - function(at - step)) / (2 * step)]
        for j, before in enumerate(rows[-1] if rows else []):
            row.append((4 ** (j + 1) * row[-1] - before) / (4 ** (j + 1) - 1))
            doubt = np.maximum(np.abs(row[-1] - row[-2]), np.abs(row[-1] - before)) + noise / step
            better = doubt < least
            best, least = np.where(better, row[-1], row[-1] if best is None else best), np.where(better, doubt, least)
        rows.append(row)
    return best, least


def compared(scene, coordinates, method):
    """Of each derivative that a difference is sure of: name, state, its error over the history's largest, the doubt."""
    model, named, states, differences = case(scene, coordinates)
    duration, tolerance = SHORT.get(scene, "0.2 s"), METHODS[method]
    run = simulate(model, duration=duration, tolerance=tolerance, method=method, compiled=False)
    derivatives = run.sensitivities(*named)
    assert derivatives.reason == ""
    for name, (expected, doubt) in differences.items():
        for state, value, unsure in zip(states, expected, doubt, strict=True):
            history = derivatives[state, name]
            size = np.abs(history).max()
            if size * abs(model.bind()[name]) > SEEN and unsure <= SURE * size:
                yield name, state, abs(history[-1] - value) / size, unsure / size


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("scene", built_in_scenes())
def test_a_scene(scene, coordinates):
    judged = {method: [*compared(scene, coordinates, method)] for method in METHODS}
    if not any(judged.values()):
        pytest.skip("no difference is sure")
    assert not {method: wrong for method, rows in judged.items() if (wrong := [row for row in rows if row[2] > BOUND])}
