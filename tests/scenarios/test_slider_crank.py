"""The slider-crank with a clearance joint against quadruple precision, the ideal mechanism and published numbers.

Oracles: tests/reference/slider_crank.py (equations by hand, 24 ms in quadruple precision), tests/reference/ideal_slider_crank.py (closed form).
"""

from functools import cache

import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from reference import ideal_slider_crank as ideal
from reference.slider_crank import SliderCrank, reference

pytestmark = pytest.mark.by_turns(4)  # methods and sizes that run the same code

SCENES = {"slider_crank_frictionless": False, "slider_crank": True}  # friction
METHODS = ("dopri5", "dop853")
MECHANISM = SliderCrank()
R, L, W = MECHANISM.r, MECHANISM.l, MECHANISM.w
DEAD_CENTRE = 19419.3605  # m/s^2, w^2 r (1 + r/l)
WINDOW = 1e-3  # s
FLUCTUATION = {"0.5 mm": 0.25, "0.05 mm": 0.05, "0.005 mm": 0.005}  # of DEAD_CENTRE, by clearance


@cache
def model(scene):
    return engine_model(scene)


@cache
def two_revolutions(scene, method="dop853", tolerance=1e-12, clearance="0.5 mm"):
    run = simulate(
        model(scene), duration="24 ms", tolerance=tolerance, method=method, parameters={"clearance": clearance}
    )
    assert run.outcome.finished
    return run


# ---- the first impact ------------------------------------------------------------------------------------------------


def effective_mass(run, t):
    """Mass [kg] that the contact feels along its normal: 1/(J M^-1 J'), M^-1 from unit forces, J the gap's rate per speed."""
    here, functions = run.at([t]), run.engine.model.function
    c = run.engine.model.bind().c
    q, u = (
        np.array([here[name][0] for name in names]) for names in (run.engine.model.coordinates, run.engine.model.speeds)
    )

    def acceleration(f):
        return np.array(functions("accelerations")(t, q, u, f, c)[0]).ravel()

    def gap_rate(u):
        return float(functions("gaps")(t, q, u, c)[1])

    forces, speeds = np.eye(functions("accelerations").size1_in(3)), np.eye(len(u))
    inverse = np.column_stack([acceleration(forces[i]) - acceleration(0 * forces[i]) for i in range(len(u))])
    normal = np.array([gap_rate(u + speed) - gap_rate(u) for speed in speeds])
    return 1 / (normal @ inverse @ normal)


def check_first_impact(run, friction):
    """Against the quadruple digits: onset, approach, penetration, force, end; to 1e-8."""
    hit, impact = reference(friction).impacts[0], run.impacts[0]
    assert impact.t == pytest.approx(hit.onset, rel=1e-10)
    assert impact.speed == pytest.approx(hit.speed, rel=1e-10)
    assert impact.peak_penetration == pytest.approx(hit.depth, rel=1e-8)
    assert impact.peak_force == pytest.approx(hit.force, rel=1e-8)
    assert impact.t + impact.duration == pytest.approx(hit.end, rel=1e-8)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("scene", "penetration"), [("slider_crank_frictionless", 7.795e-5), ("slider_crank", 7.817e-5)]
)
def test_first_impact(scene, penetration, method):
    run = simulate(model(scene), duration="0.4 ms", tolerance=1e-11, method=method)
    impact = run.impacts[0]
    assert impact.t == pytest.approx(2.2728e-4, abs=5e-9)  # the printed digits
    assert impact.speed == pytest.approx(4.38583, abs=5e-6)
    assert impact.peak_penetration == pytest.approx(penetration, rel=1e-4)
    mass = effective_mass(run, impact.t)
    assert mass == pytest.approx(0.14013, abs=5e-6)
    assert mass == pytest.approx(reference(SCENES[scene]).impacts[0].effective_mass, rel=1e-9)
    check_first_impact(run, SCENES[scene])


@pytest.mark.parametrize("fault", ["207.0001 GPa", "206.99 GPa"])
def test_a_wrong_stiffness_is_noticed(fault):
    run = simulate(model("slider_crank"), duration="0.4 ms", tolerance=1e-11, parameters={"youngs_modulus": fault})
    with pytest.raises(AssertionError):
        check_first_impact(run, friction=True)


# ---- two revolutions -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("scene", SCENES)
def test_every_impact_of_two_revolutions(scene, method):
    run, hits = two_revolutions(scene, method), reference(SCENES[scene]).impacts
    assert len(run.impacts) == len(hits)
    for i, (impact, hit) in enumerate(zip(run.impacts, hits, strict=True)):
        assert impact.t == pytest.approx(hit.onset, abs=2e-10)
        assert (impact.duration is None) == (hit.end is None)
        if i < 10:  # later ones carry the growth of the error from impact to impact
            actual = (impact.speed, impact.peak_penetration, impact.peak_force)
            assert actual == pytest.approx((hit.speed, hit.depth, hit.force), rel=1e-8)
            assert impact.t + impact.duration == pytest.approx(hit.end, abs=2e-12)


def kinematic_gain(eccentricity):
    """C of |x - x_ideal| <= C |e|, by search over every crank angle and direction of the eccentricity.

    The loop closes to r sin phi + l sin theta = e_y, x = r cos phi + l cos theta - e_x. The deviation grows with |e| and is steepest at the
    largest one, so that a search at that size is enough; its grid misses the maximum by half a spacing, squared.
    """
    phi, turn = np.linspace(0, 2 * np.pi, 721), np.linspace(0, 2 * np.pi, 721)[:, None]
    e_x, e_y = eccentricity * np.cos(turn), eccentricity * np.sin(turn)
    x = R * np.cos(phi) + np.sqrt(L**2 - (e_y - R * np.sin(phi)) ** 2) - e_x
    gain = np.max(np.abs(x - ideal.position(phi, R, L))) / eccentricity
    return float(gain) * (1 + 2 * (np.pi / 720) ** 2)


@pytest.mark.parametrize("clearance", FLUCTUATION)
@pytest.mark.parametrize("scene", SCENES)
def test_the_slider_stays_within_the_kinematic_gain_of_the_ideal_one(scene, clearance):
    run = two_revolutions(scene, tolerance=1e-9, clearance=clearance)
    eccentricity = float(clearance.split()[0]) * 1e-3 + max(impact.peak_penetration for impact in run.impacts)
    t = np.union1d(run.t, np.linspace(0, 0.024, 12001))
    off = np.max(np.abs(run.at(t)["guide.travel"] - ideal.position(W * t, R, L)))
    assert off <= kinematic_gain(eccentricity) * eccentricity
    assert off > 0.85 * kinematic_gain(eccentricity) * eccentricity  # the bound is not a loose one


def fluctuation(run, begins):
    """|mean acceleration - ideal mean acceleration|/DEAD_CENTRE of the slider over the windows [begin, begin + WINDOW]."""
    ends = np.minimum(begins + WINDOW, run.t[-1])
    gained = run.at(ends)["guide.speed"] - run.at(begins)["guide.speed"]
    of_ideal = ideal.velocity(W * ends, W, R, L) - ideal.velocity(W * begins, W, R, L)
    return np.abs(gained - of_ideal) / WINDOW / DEAD_CENTRE


@pytest.mark.parametrize("clearance", FLUCTUATION)
@pytest.mark.parametrize("scene", SCENES)
def test_mean_acceleration_over_any_millisecond(scene, clearance):
    run = two_revolutions(scene, tolerance=1e-9, clearance=clearance)
    begins = np.linspace(0.012, 0.023, 11001)
    largest = np.max(fluctuation(run, begins))
    finer = np.max(fluctuation(run, np.linspace(0.012, 0.023, 17333)))
    assert largest == pytest.approx(finer, rel=2e-3)  # the grid is fine enough for "any"
    assert 0.2 * FLUCTUATION[clearance] < largest < FLUCTUATION[clearance]


def test_the_force_of_the_line_contact_is_that_of_its_law():
    """Liu, Zhang, Yang, pi E* L d/2 sqrt(d/(2 (c + d))), under the damping of Lankarani and Nikravesh, at every step of the first contacts."""
    run = simulate(engine_model("slider_crank_line"), duration="2 ms", tolerance=1e-8, compiled=False)
    touching = run["slider_pin.mode"] == 1
    d, rate = run["slider_pin.penetration"][touching], -run["slider_pin.gap_rate"][touching]
    modulus, length, room, e = 207e9 / (2 * (1 - 0.3**2)), 0.015, 0.5e-3, 0.9
    elastic = np.pi / 2 * modulus * length * d * np.sqrt(d / (2 * (room + d)))
    sinking = rate * room / (room + d)  # the event function of a journal is (c^2 - e^2)/(2 c)
    damped = 1 + 0.75 * (1 - e**2) * sinking / run["slider_pin.approach_speed"][touching]
    assert np.count_nonzero(touching) > 50
    assert run["slider_pin.normal_force"][touching] == pytest.approx(elastic * damped, rel=1e-6, abs=1e-3)
