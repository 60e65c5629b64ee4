"""The oracles against print. Their agreement with second derivations and integrations is that of the tests that use them."""

from decimal import Decimal

import pytest

from reference import closed_forms
from reference.laws import EXACT_FACTORS
from reference.slider_crank import reference


@pytest.mark.parametrize("friction, depth", [(False, 7.795e-5), (True, 7.817e-5)])
def test_published_first_impact(friction, depth):
    """Independent numbers of issue 2 ("Scenarios"): onset, effective mass, approach, penetration."""
    hit = reference(friction).impacts[0]
    assert hit.onset == pytest.approx(2.2728e-4, abs=5e-9)
    assert hit.effective_mass == pytest.approx(0.14013, abs=5e-6)
    assert hit.speed == pytest.approx(4.38583, abs=5e-6)
    assert hit.depth == pytest.approx(depth, rel=1e-4)


@pytest.mark.parametrize("e, printed", EXACT_FACTORS.items())
def test_exact_factor(e, printed):
    h = closed_forms.exact_factor(e)
    assert round(Decimal(h), 6) == Decimal(printed)
    assert closed_forms.restitution(h) == pytest.approx(float(e), rel=1e-15)


def test_limits_of_the_factors():
    assert closed_forms.restitution(1e-9) == pytest.approx(1 - 2e-9 / 3, rel=1e-15)  # e_out = 1 - 2 h/3 + O(h^2)
    assert closed_forms.restitution(0) == 1
    assert closed_forms.exact_factor("0.01") == pytest.approx(100, rel=1e-15)


@pytest.mark.parametrize(
    "K, depth, force, duration",
    [("2.4e10", 2.53372286e-4, 96794.33, 1.6836060e-4), ("1.4e8", 1.98332e-3, 12365.6, 1.31787e-3)],
)
def test_elastic_impacts_of_scenarios(K, depth, force, duration):
    hit = closed_forms.collision(K, "1.5", 1, closed_forms.drop_speed(1, "9.81"))
    assert (hit.depth, hit.peak_force, hit.duration) == pytest.approx((depth, force, duration), rel=4e-6)
    assert hit.duration == pytest.approx(2.9432751843 * hit.depth / closed_forms.drop_speed(1, "9.81"), rel=1e-10)


def test_impact_under_gravity():
    v0 = closed_forms.drop_speed(1, "9.81")
    assert v0 == pytest.approx(4.42944692, rel=1e-9)
    assert closed_forms.depth_with_gravity("2.4e10", "1.5", 1, v0, "9.81") == pytest.approx(2.53398e-4, rel=2e-6)
    assert closed_forms.static_penetration("2.4e10", "1.5", 1, "9.81") == pytest.approx(5.5e-7, rel=2e-2)
    soft = closed_forms.depth_with_gravity("1.4e8", "1.5", 1, v0, "9.81")
    assert soft / closed_forms.collision("1.4e8", "1.5", 1, v0).depth - 1 == pytest.approx(7.9e-4, rel=1e-2)


@pytest.mark.parametrize(
    "e, printed",
    [("0.9", (9.090298887, 8.263743089, 7.512142692)), ("0.5", (6.629838391, 4.395155252, 2.913688144))],
)
def test_published_speeds_between_walls(e, printed):
    h = closed_forms.factor("hunt_crossley", e)
    rows = closed_forms.ball_between_walls(1e6, 1, "1.6", 10, h, 3, "0.5", 1)
    assert [row.rebound for row in rows] == pytest.approx(printed, rel=2e-4)
    assert rows[1].onset == pytest.approx(rows[0].onset + rows[0].duration + 1 / rows[0].rebound, rel=1e-15)
    assert rows[1].depth == pytest.approx(rows[0].depth * rows[0].rebound / rows[0].approach, rel=1e-14)  # n = 1


def test_two_spheres():
    assert closed_forms.two_spheres("0.3", closed_forms.exact_factor("0.7")) == pytest.approx((0.045, 0.255), rel=1e-14)
