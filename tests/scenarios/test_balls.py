"""Balls against closed forms and published numbers: free impact, fall, restitution of the damping laws, ten bounces, two spheres.

The closed forms are those of tests/reference/closed_forms.py, in 60 digits; published numbers are those of shared/reference/scenarios.md. What
tests/runtime/engine/integration/step/test_engine.py measures already (bouncing_ball at its own speed, Flores) is not measured again.
"""

import math
from functools import cache

import pytest

from hertzwerk.runtime import load, simulate
from reference import closed_forms

pytestmark = pytest.mark.by_turns(3)  # methods and sizes that run the same code

METHODS = ("dopri5", "dop853")
STIFFNESS = {"bouncing_ball": "2.4e10", "soft_ball": "1.4e8"}  # N/m^1.5
V0 = closed_forms.drop_speed(1, "9.81")
PRINTED = {  # without gravity: depth [m], peak force [N], duration [s]; with gravity: depth [m]
    "bouncing_ball": ((2.53372286e-4, 96794.33, 1.6836060e-4), 2.53398e-4),
    "soft_ball": ((1.98332e-3, 12365.6, 1.31787e-3), 1.98332e-3 * (1 + 7.9e-4)),
}
PAIRS = {"bouncing_ball": ("floor",), "two_spheres": ("spheres",), "ball_between_walls": ("left_wall", "right_wall")}
BETWEEN_WALLS = {"0.9": (9.090298887, 8.263743089, 7.512142692), "0.5": (6.629838391, 4.395155252, 2.913688144)}  # m/s


@cache
def model(scene, *, law=None, without=()):
    return load(scene, without=without, laws=dict.fromkeys(PAIRS[scene], law) if law else None)


@cache
def collision(*data):
    return closed_forms.collision(*data)


def undamped(scene):
    return {"restitution": 1.0} if scene == "bouncing_ball" else {}  # h = 0; soft_ball has no damping


def struck(ball, method, *, speed=V0, **parameters):
    """A ball that starts at gap 0."""
    return simulate(
        ball,
        duration="8 ms",
        tolerance=1e-12,
        method=method,
        parameters=parameters,
        initial={"vertical.travel": "0.1 m", "vertical.speed": (-speed, "m/s")},
    )


def check_impact(impact, exact, rel=1e-9):
    assert impact.peak_penetration == pytest.approx(exact.depth, rel=rel)
    assert impact.peak_force == pytest.approx(exact.peak_force, rel=rel)
    assert impact.duration == pytest.approx(exact.duration, rel=rel)


# ---- one impact ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("gravity", ["left out", "zero"])
@pytest.mark.parametrize("scene", STIFFNESS)
def test_elastic_impact_of_two_bodies(scene, gravity, method):
    weightless = model(scene, without=("gravity",)) if gravity == "left out" else model(scene)
    zero = {"gravity": "0 m/s^2"} if gravity == "zero" else {}
    run = struck(weightless, method, **undamped(scene), **zero)
    exact = collision(STIFFNESS[scene], "1.5", 1, V0)
    (impact,) = run.impacts
    assert impact.t == 0
    check_impact(impact, exact)
    assert (impact.peak_penetration, impact.peak_force, impact.duration) == pytest.approx(PRINTED[scene][0], rel=4e-6)
    assert run.final["vertical.speed"] == pytest.approx(V0, rel=1e-9)
    v0, n, K = V0, 1.5, float(STIFFNESS[scene])  # contact-laws.md section 2, in floats
    depth = ((n + 1) * v0**2 / (2 * K)) ** (1 / (n + 1))
    assert impact.peak_penetration == pytest.approx(depth, rel=1e-9)
    assert impact.duration == pytest.approx(2.9432751843 * depth / v0, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("n", [1.0, 1.1, 2.0])
def test_elastic_impact_of_other_exponents(n, method):
    stiffness = {"exponent": n, "stiffness": f"3e7 N/m^{n}"}
    run = struck(model("bouncing_ball", without=("gravity",)), method, **undamped("bouncing_ball"), **stiffness)
    check_impact(run.impacts[0], collision("3e7", str(n), 1, V0))
    depth = ((n + 1) * V0**2 / (2 * 3e7)) ** (1 / (n + 1))
    duration = depth / V0 * 2 * math.sqrt(math.pi) * math.gamma(1 + 1 / (n + 1)) / math.gamma(0.5 + 1 / (n + 1))
    assert run.impacts[0].duration == pytest.approx(duration, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("scene", STIFFNESS)
def test_drop_under_gravity(scene, method):
    run = simulate(model(scene), duration="0.5 s", tolerance=1e-12, method=method, parameters=undamped(scene))
    (impact,) = run.impacts
    assert impact.t == pytest.approx(math.sqrt(2 / 9.81), rel=1e-12)
    assert impact.speed == pytest.approx(V0, rel=1e-12)
    exact = closed_forms.depth_with_gravity(STIFFNESS[scene], "1.5", 1, V0, "9.81")
    assert impact.peak_penetration == pytest.approx(exact, rel=1e-9)
    assert impact.peak_penetration == pytest.approx(PRINTED[scene][1], rel=4e-6)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("e", ["0.95", "0.7", "0.3"])
@pytest.mark.parametrize("law", ["lankarani_nikravesh", "hunt_crossley", "flores"])
def test_damped_impact_of_two_bodies(law, e, method):
    exact = collision(STIFFNESS["bouncing_ball"], "1.5", 1, V0, closed_forms.factor(law, e))
    run = struck(model("bouncing_ball", law=law, without=("gravity",)), method, restitution=float(e))
    (impact,) = run.impacts
    check_impact(impact, exact)
    e_out = run.final["vertical.speed"] / V0
    assert e_out == pytest.approx(exact.restitution, rel=1e-9)
    h = closed_forms.factor(law, e)
    assert h * (1 + e_out) == pytest.approx(math.log((1 + h) / (1 - h * e_out)), rel=1e-8)  # ill conditioned in e_out
    assert run.final["floor.dissipated"] == pytest.approx(exact.dissipated, rel=1e-9)


@pytest.mark.parametrize("speed", ["0.1 m/s", "1000 m/s"])
def test_restitution_depends_on_no_speed(speed):
    """The relation between h and e_out holds no mass, stiffness or speed: nor may the scales of the run."""
    ball = model("bouncing_ball", law="hunt_crossley", without=("gravity",))
    v0 = float(speed.split()[0])
    start = {"vertical.travel": "0.1 m", "vertical.speed": f"-{speed}"}
    run = simulate(ball, duration="8 ms", tolerance=1e-12, parameters={"restitution": 0.7}, initial=start)
    e_out = closed_forms.restitution(closed_forms.factor("hunt_crossley", "0.7"))
    assert run.final["vertical.speed"] / v0 == pytest.approx(e_out, rel=1e-9)


# ---- ten bounces -----------------------------------------------------------------------------------------------------


def ten_bounces(method, e, law="hunt_crossley", **parameters):
    """A run over the first ten impacts between the walls, and the closed form of each."""
    h = closed_forms.factor("hunt_crossley", e)
    bounces = closed_forms.ball_between_walls("1e6", 1, "1.6", 10, h, 11, "0.4", "0.8")
    end = (bounces[9].onset + bounces[9].duration + bounces[10].onset) / 2
    walls = model("ball_between_walls", law=None if law == "hunt_crossley" else law)
    run = simulate(
        walls, duration=end, tolerance=1e-12, method=method, parameters={"restitution": float(e)} | parameters
    )
    return run, bounces[:10]


def check_bounces(run, bounces, rel=1e-8):
    assert [impact.contact for impact in run.impacts] == ["right_wall", "left_wall"] * 5
    rebounds = abs(run.at([impact.t + impact.duration for impact in run.impacts])["track.speed"])
    for impact, rebound, bounce in zip(run.impacts, rebounds, bounces, strict=True):
        assert impact.t == pytest.approx(bounce.onset, rel=rel)
        assert impact.speed == pytest.approx(bounce.approach, rel=rel)
        assert rebound == pytest.approx(bounce.rebound, rel=rel)
        assert impact.peak_penetration == pytest.approx(bounce.depth, rel=rel)
        assert impact.duration == pytest.approx(bounce.duration, rel=rel)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("e", BETWEEN_WALLS)
def test_ten_bounces_between_walls(e, method):
    run, bounces = ten_bounces(method, e)
    check_bounces(run, bounces)
    published = BETWEEN_WALLS[e]
    rebounds = abs(run.at([impact.t + impact.duration for impact in run.impacts[:3]])["track.speed"])
    assert rebounds == pytest.approx(published, rel=2e-4)
    assert abs(run["track.speed"][-1]) == pytest.approx(bounces[-1].rebound, rel=1e-8)


# ---- two spheres -----------------------------------------------------------------------------------------------------


def after_two_spheres(method, law=None):
    run = simulate(model("two_spheres", law=law), duration="0.1 s", tolerance=1e-12, method=method)
    return run, (run.final["striker_path.speed"], run.final["target_path.speed"])


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("law", ["flores", "lankarani_nikravesh", "hunt_crossley"])
def test_two_spheres(law, method):
    run, speeds = after_two_spheres(method, law)
    h = closed_forms.factor(law, "0.7")
    e_out = closed_forms.restitution(h)
    assert speeds == pytest.approx((0.3 * (1 - e_out) / 2, 0.3 * (1 + e_out) / 2), rel=1e-9)
    momentum = run["striker_path.speed"] + run["target_path.speed"]
    assert momentum == pytest.approx(0.3, rel=1e-14)
    (impact,) = run.impacts
    K = 4 / 3 * 207e9 / (2 * (1 - 0.3**2)) * math.sqrt(0.02 / 2)
    check_impact(impact, collision(K, "1.5", "0.046", "0.3", h))
    assert impact.t == pytest.approx(0.01 / 0.3, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_two_spheres_of_the_law_that_returns_e(method):
    _, speeds = after_two_spheres(method, "exact")
    assert speeds == pytest.approx((0.045, 0.255), rel=1e-9)


# ---- the checks can fail ---------------------------------------------------------------------------------------------


def test_a_stiffness_wrong_in_the_ninth_digit_is_noticed():
    run = struck(model("soft_ball", without=("gravity",)), "dop853", stiffness="1.40000001e8 N/m^1.5")
    with pytest.raises(AssertionError):
        check_impact(run.impacts[0], collision(STIFFNESS["soft_ball"], "1.5", 1, V0))


@pytest.mark.parametrize(
    "fault", [{"law": "hu_guo"}, {"law": "flores"}, {"stiffness": "1.0000001e6 N/m"}, {"gap": "0.40000001 m"}]
)
def test_a_wrong_law_or_number_between_walls_is_noticed(fault):
    run, bounces = ten_bounces("dop853", "0.9", **fault)
    with pytest.raises(AssertionError):
        check_bounces(run, bounces)
