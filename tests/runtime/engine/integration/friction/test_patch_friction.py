"""A flat disc that slides and spins: the coupling against the integral over the patch, and the published end of its motion."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from patches import DISC, GRAVITY, MU, RIM, flat_disc, shares
from scipy.integrate import dblquad, solve_ivp
from scipy.optimize import brentq

from hertzwerk.derive import DrillingResistance, Friction, InputError, Parameter, PatchFriction, generate
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.runtime import load, simulate

LAYER = 1e-5  # m/s
FARKAS = 0.653  # v/(R w) at the end: Phys. Rev. Lett. 90 (2003) 248302


def patch(coefficient=MU, name="rub"):
    return PatchFriction(
        name, "floor", Parameter("mu", "1", coefficient), Parameter("rim", "m", RIM), Parameter("layer", "m/s", LAYER)
    )


def scene(*more, **coordinates):
    return flat_disc(*(more or (patch(),)), **coordinates)


@cache
def built(**coordinates):
    return load(scene(**coordinates))


def over_the_patch(v, u):
    """The same by cubature of the direction of sliding at every point, at a sliding v and a rim's speed u."""

    def part(of):
        value, _ = dblquad(
            lambda phi, r: of(r * math.cos(phi), r * math.sin(phi)) * r / math.pi, 0, 1, 0, 2 * math.pi, epsabs=1e-7
        )
        return value

    def along(x, y):
        return (v - u * y) / max(math.hypot(v - u * y, u * x), 1e-30)

    def about(x, y):
        return (x * u * x - y * (v - u * y)) / max(math.hypot(v - u * y, u * x), 1e-30)

    return part(along), part(about)


# ---- force and moment ------------------------------------------------------------------------------------------------


def found(v, w):
    """Force and moment on the disc at the start, beside mu N and mu N R."""
    given = {"slide": (v, "m/s"), "spin": (w, "rad/s"), "layer": (1e-14, "m/s")}
    run = simulate(built(), duration="1 ns", method="dop853", tolerance=1e-8, parameters=given, compiled=False)
    load_ = MU * run["floor.normal_force"][0]
    return math.hypot(run["floor.force_x"][0], run["floor.force_z"][0]) / load_, -run["rub.moment_y"][0] / (load_ * RIM)


@pytest.mark.parametrize("ratio", [0.3, 1.7])
def test_the_integral_over_the_patch_is_what_acts(ratio):
    assert found(ratio, 1 / RIM) == pytest.approx(over_the_patch(ratio, 1.0), abs=1e-5)


def test_from_rolling_about_its_middle_to_sliding_alone_to_the_last_digits():
    """Where the published forms cancel, by their limits: F = v/(R w) and M = 2/3 below, F = 1 and M = R w/(4 v) above."""
    for ratio in (1e-2, 0.1, 0.653, 0.9, 0.999, 1.001, 1.1, 3.0, 20.0):
        assert found(ratio, 1 / RIM) == pytest.approx(shares(ratio), rel=1e-9)
    for tiny in (1e-8, 1e-5):
        assert found(tiny, 1 / RIM) == pytest.approx((tiny, 2 / 3), rel=1e-9)
        assert found(1.0, tiny / RIM) == pytest.approx((1.0, tiny / 4), rel=1e-9)
    assert found(1.0, 1 / RIM) == pytest.approx((8 / (3 * math.pi), 8 / (9 * math.pi)), rel=1e-9)  # E(1) = 1
    assert found(0.0, 1 / RIM)[0] == found(1.0, 0.0)[1] == 0


# ---- motion ----------------------------------------------------------------------------------------------------------


def ratios(run):
    speed = np.hypot(run["floor_plane.x_speed"], run["floor_plane.y_speed"])
    return speed, speed / (RIM * np.abs(run["floor_plane.angle_speed"]))


@pytest.mark.parametrize("start", [0.6, 0.75])
def test_sliding_and_spin_end_together_at_the_published_ratio(start):
    """Where both fall alike, F = 2 e M; approached from below and from above with the speed's power 0.615."""
    end = brentq(lambda e: shares(e)[0] - 2 * e * shares(e)[1], 0.1, 0.95, xtol=1e-14)
    assert round(end, 3) == FARKAS
    speeds = {"slide": (start, "m/s"), "spin": (1 / RIM, "rad/s")}
    run = simulate(built(), duration="0.6 s", method="auto", tolerance=1e-7, parameters=speeds)
    speed, ratio = ratios(run)
    moving = speed > 2e-5
    assert ratio[moving][-1] == pytest.approx(end, abs=5e-4)
    assert np.all((ratio[moving] - end) * (start - end) > 0)
    assert speed[-1] < 1e-6
    assert run.energy_residual < 1e-6
    assert run.engine.final["rub.dissipated"] == pytest.approx(DISC / 2 * start**2 + DISC / 4, rel=1e-6)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_the_way_there_is_that_of_equations_of_its_own(coordinates):
    def rates(_, y):
        force, moment = shares(y[0] / (RIM * y[1]))
        return [-MU * GRAVITY * force, -2 * MU * GRAVITY / RIM * moment]

    known = solve_ivp(rates, (0, 0.3), [1, 10.5], "DOP853", t_eval=[0.1, 0.3], rtol=1e-11, atol=1e-12).y
    model, given = built(coordinates=coordinates), {"spin": "10.5 rad/s"}
    run = simulate(model, duration="0.3 s", method="dop853", tolerance=1e-8, parameters=given, compiled=False)
    rows = run.with_histories("disc.x_speed", "disc.z_speed", "disc.angular_speed_y").at(np.array([0.1, 0.3]))
    assert np.hypot(rows["disc.x_speed"], rows["disc.z_speed"]) == pytest.approx(known[0], rel=1e-7)
    assert np.abs(rows["disc.angular_speed_y"]) == pytest.approx(known[1], rel=1e-7)


@pytest.mark.parametrize("method", ["rodas", "esdirk"])
def test_alone_each_ends_in_closed_form(method):
    """Sliding after v/(mu g), spin after 3 R w/(4 mu g)."""
    for given, rest in (
        ({"spin": "0 rad/s"}, 1 / (MU * GRAVITY)),
        ({"slide": "0 m/s"}, 3 * RIM * 10 / (4 * MU * GRAVITY)),
    ):
        run = simulate(
            built(), duration=1.01 * rest, method=method, tolerance=1e-6, parameters=given | {"layer": "1e-4 m/s"}
        )
        moves = np.hypot(run["floor_plane.x_speed"], RIM * run["floor_plane.angle_speed"]) > 1e-4
        assert run.t[np.flatnonzero(moves)[-1]] == pytest.approx(rest, rel=1e-3)
        assert not moves[-1]


def test_friction_that_it_replaces_is_refused_beside_it():
    rub = Friction("also", "floor", smooth_coulomb(Parameter("mu_k", "1", MU), Parameter("v_s", "m/s", 1e-3)))
    drill = DrillingResistance("drill", "floor", Parameter("arm", "m", 1e-3), Parameter("slow", "rad/s", 1e-3))
    with pytest.raises(InputError) as caught:
        generate(scene(patch(), rub, drill))
    assert "friction also at floor too" in str(caught.value)
    assert "drilling resistance drill at floor too" in str(caught.value)
    with pytest.raises(InputError, match="Patch friction needs a normal force"):
        replace(scene(), effects=(patch(),))
    wrong = PatchFriction(
        "rub", "floor", Parameter("mu", "m", 1), Parameter("rim", "m", 1), Parameter("layer", "rad/s", 1)
    )
    with pytest.raises(InputError, match=r"(?s)effect rub, coefficient.*effect rub, speed"):
        generate(scene(wrong))
