"""Propagated uncertainty against closed forms, of derivatives and of samples; what bends; bad input."""

import math

import numpy as np
import pytest
from scipy import stats

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import (
    Correlated,
    LogNormal,
    Measurement,
    Normal,
    Triangular,
    TruncatedNormal,
    Uniform,
    fit,
    propagate,
)
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.uncertainty import propagation_result
from hertzwerk.runtime.studies.uncertainty.correlation import correlated_parts, covariance

SHORT = {"tolerance": 1e-9, "workers": 1, "compiled": False}
G = 9.81


@pytest.fixture(scope="module")
def fallen(ball):
    """Ball in flight for 0.4 s: y = h - g t^2/2 is linear in h and g, y' = -g t in g alone."""
    uncertain = {"vertical.travel": Normal("1 m", "3 cm"), "gravity": Normal("9.81 m/s^2", "0.2 m/s^2")}
    outputs = ["final.vertical.travel", "final.vertical.speed", "impacts"]
    return propagate(ball, uncertain, outputs, sample=128, duration="0.4 s", **SHORT)


def test_both_methods_agree_on_a_linear_output(fallen):
    place, speed, _ = fallen
    of_height, of_gravity = 0.03, 0.2 * 0.4**2 / 2
    assert place.linear == pytest.approx(math.hypot(of_height, of_gravity), rel=1e-9)
    assert speed.linear == pytest.approx(0.2 * 0.4, rel=1e-9)
    assert place.derivatives == pytest.approx({"vertical.travel": 1, "gravity": -(0.4**2) / 2}, rel=1e-9)
    assert place.parts == pytest.approx({"vertical.travel": of_height, "gravity": of_gravity}, rel=1e-9)
    assert place.std == pytest.approx(place.linear, rel=0.03)
    assert place.mean == pytest.approx(1 - G * 0.4**2 / 2, abs=2e-4)
    assert place.high - place.low == pytest.approx(2 * 1.96 * place.linear, rel=0.1)
    assert place.mean_error == pytest.approx(place.std / math.sqrt(256), rel=1e-12)
    assert place.std_error == pytest.approx(place.std / math.sqrt(2 * 256), rel=0.15)  # of a normal distribution
    assert fallen.warnings == ()
    assert fallen.draws == 256
    panels = fallen.plot().axes
    assert [panel.get_title(loc="left") for panel in panels[::2]] == [output.name for output in fallen]
    drawn = panels[0].lines[0].get_xydata()
    area = np.trapezoid(drawn[:, 1], drawn[:, 0])
    assert area == pytest.approx(1, abs=1e-3)  # of the normal curve


def test_sobol_indices_of_a_sum_are_its_parts_and_constants_have_none(fallen):
    place, speed, _ = fallen
    part = 0.03**2 / (0.03**2 + (0.2 * 0.08) ** 2)
    for index in (place.first, place.total):
        assert index["vertical.travel"].value == pytest.approx(part, abs=0.05)
        assert index["gravity"].value == pytest.approx(1 - part, abs=0.05)
        assert index["gravity"].low < 1 - part < index["gravity"].high
    assert speed.total["vertical.travel"].value == pytest.approx(0, abs=1e-12)
    impacts = fallen["impacts"]
    assert (impacts.mean, impacts.std, impacts.first, impacts.total) == (0, 0, {}, {})
    assert "impacts: no variance" in fallen.plot().axes[-1].texts[0].get_text()


def test_a_product_has_an_interaction(ball):
    """Kinetic energy m (g t)^2/2 of two independent factors: V = E[a]^2 V[b] + E[b]^2 V[a] + V[a] V[b]."""
    uncertain = {"mass": Uniform("0.2 kg", "1.8 kg"), "gravity": LogNormal("9.81 m/s^2", 1.3)}
    (result,) = propagate(
        ball, uncertain, [], functions={"energy": lambda run: run.settings.parameters["mass"][0] * run.engine.final["vertical.speed"] ** 2 / 2},
        sample=256, duration="0.2 s", **SHORT,
    )  # fmt: skip
    a, b = stats.uniform(0.2, 1.6), stats.lognorm(2 * math.log(1.3), scale=(G * 0.2) ** 2 / 2)
    terms = np.array([a.mean() ** 2 * b.var(), b.mean() ** 2 * a.var(), a.var() * b.var()])
    assert result.std == pytest.approx(math.sqrt(terms.sum()), rel=0.05)
    assert result.first["gravity"].value == pytest.approx(terms[0] / terms.sum(), abs=0.05)
    assert result.total["mass"].value == pytest.approx((terms[1] + terms[2]) / terms.sum(), abs=0.08)
    assert result.total["mass"].value > result.first["mass"].value + 0.01
    assert math.isnan(result.linear)
    assert "function of yours" in result.reason


def test_nonlinear_outputs_and_runs_that_fail_are_warned_of(ball):
    """Some balls reach the floor within the run, others do not: a derivative tells one side alone."""
    wide = {"vertical.travel": Normal("0.9 m", "10 cm")}
    spread = propagate(ball, wide, ["final.vertical.speed"], sample=64, indices=False, duration="0.43 s", **SHORT)
    (one,) = spread
    assert len(spread.samples) == 64
    assert one.first == {}
    assert any("not linear" in text for text in one.warnings)
    assert "warning" in str(spread)
    spread = propagate(
        ball, {"restitution": Normal(0.95, 0.05)}, ["final.vertical.speed"], sample=16, duration="0.1 s", **SHORT
    )
    (one,) = spread
    assert one.first == {}
    assert (
        spread.warnings[-1].startswith("10 of 48 runs")
        or "runs are omitted, the first because: bad_input" in spread.warnings[-1]
    )


def test_the_same_seed_gives_the_same_and_a_folder_is_gone_on_with(ball, tmp_path):
    how = {"sample": 8, "duration": "0.1 s", "out": tmp_path / "rows", **SHORT}
    uncertain = {"mass": Triangular("0.5 kg", "1 kg", "2 kg")}
    first, again = (propagate(ball, uncertain, ["final.vertical.speed"], **how) for _ in range(2))
    assert [row.outputs for row in first.samples] == [row.outputs for row in again.samples]
    first.to_csv(tmp_path / "found.csv")
    assert (tmp_path / "found.csv").read_text().splitlines()[1].startswith("final.vertical.speed,m/s,")
    assert first.record()["outputs"]["final.vertical.speed"]["mean"] == first["final.vertical.speed"].mean


def test_a_duration_that_is_uncertain_has_no_derivative_of_its_own():
    crank = engine_model("slider_crank")
    spread = propagate(crank, {"crank_speed": Normal("5000 rpm", "10 rpm")}, ["final.guide.travel"], sample=8, indices=False,
                      duration="0.01 rev", tolerance=1e-6, workers=1)  # fmt: skip
    assert "duration" in spread["final.guide.travel"].reason


def test_distributions_and_their_covariance_are_those_of_their_names(ball):
    from hertzwerk.runtime.studies.uncertainty.distributions import distribution_of

    faults = []
    cut = distribution_of(ball, "restitution", TruncatedNormal(0.9, 0.2, 0.5, 1), faults)
    assert cut.ppf([0, 1]) == pytest.approx([0.5, 1])
    assert cut.pdf(0.8) / cut.pdf(0.9) == pytest.approx(math.exp(-0.125))
    triangle = distribution_of(ball, "mass", Triangular("500 g", "1 kg", "2 kg"), faults)
    assert triangle.mean() == pytest.approx(3.5 / 3)
    assert distribution_of(ball, "gravity", LogNormal("10 m/s^2", 1.5), faults).median() == pytest.approx(10)
    assert distribution_of(ball, "vertical.speed", Uniform("-10 cm/s", "10 cm/s"), faults).std() == pytest.approx(
        0.2 / math.sqrt(12)
    )
    assert faults == []
    s, rho = (math.log(1.3), math.log(1.1)), -0.6
    drawn = [stats.lognorm(s[0], scale=2.0), stats.lognorm(s[1], scale=3.0), stats.uniform(0, 1)]
    scores = np.array([[1, rho, 0], [rho, 1, 0.5], [0, 0.5, 1]])
    result = covariance(drawn, scores)
    assert result[0, 1] == pytest.approx(drawn[0].mean() * drawn[1].mean() * math.expm1(rho * s[0] * s[1]), rel=1e-9)
    assert result[2, 2] == pytest.approx(1 / 12)
    assert result[0, 2] == 0
    points = correlated_parts(((np.arange(3 * 4096).reshape(3, -1) + 0.5) * [[0.618], [0.414], [0.732]]) % 1, scores)
    ranks = stats.spearmanr(points[0], points[1]).statistic
    assert ranks == pytest.approx(6 / math.pi * math.asin(rho / 2), abs=0.05)  # of a Gaussian copula


def test_every_fault_is_reported_at_once(ball):
    uncertain = {
        "mas": Normal("1 kg", "0.1 kg"), "mass": Normal("1 s", "0.1 kg"), "restitution": Uniform(0.9, 1.2), "gravity": 3,
        "drop_height": Normal("1 m", "-1 m"), "vertical.speed": Uniform("1 m/s", "0 m/s"), "radius": LogNormal("1 cm", "2 m"),
    }  # fmt: skip
    with pytest.raises(InputError) as caught:
        propagate(
            ball, uncertain, ["final.nothing"], sample=100, duration="1 m", parameters={"mass": "2 s"}, indices="no"
        )
    places = [fault.where for fault in caught.value.faults]
    for place in ("mas", "mass, mean", "restitution, high", "gravity", "drop_height", "vertical.speed", "radius, factor",
                  "sample", "indices", "final.nothing", "duration"):  # fmt: skip
        assert place in places
    with pytest.raises(InputError, match="distributions by name"):
        propagate(ball, {}, duration="1 s")
    uncertain = {"mass": "Normal(1 kg, 0.1 kg)", "gravity": "Normal(9.8 m/s^2, 0.1 m/s^2)"}
    uncertain |= {"restitution": "Uniform(0.5, 1)"}
    bad = {"mass, gravty": 0.5, "mass": 0.1, "mass, restitution": 2, "gravity, mass": -0.5, "mass, gravity": 0.5}
    with pytest.raises(InputError) as raised:
        propagate(ball, uncertain, correlation=bad, duration="0.1 s")
    text = str(raised.value)
    for part in ("did you mean gravity", "two names", "between -1 and 1", "each pair once"):
        assert part in text
    tied = {"mass, gravity": 0.9, "gravity, restitution": 0.9, "mass, restitution": -0.9}
    with pytest.raises(InputError, match="positive definite"):
        propagate(ball, uncertain, correlation=tied, duration="0.1 s")


def test_correlated_quantities_spread_together(ball):
    """y = h - g t^2/2 of normal h and g: variances and twice their covariance; no indices, and it says so where asked."""
    rho, of_height, of_gravity = 0.8, 0.03, 0.2 * 0.4**2 / 2
    uncertain = {"vertical.travel": Normal("1 m", "3 cm"), "gravity": Normal("9.81 m/s^2", "0.2 m/s^2")}
    how = {"sample": 128, "duration": "0.4 s", **SHORT}
    (actual,) = propagate(
        ball, Correlated(uncertain, {"gravity, vertical.travel": rho}), ["final.vertical.travel"], **how
    )
    expected = math.sqrt(of_height**2 + of_gravity**2 - 2 * rho * of_height * of_gravity)
    assert actual.linear == pytest.approx(expected, rel=1e-9)
    assert actual.std == pytest.approx(expected, rel=0.05)
    assert actual.parts["vertical.travel"] == pytest.approx(of_height)
    assert actual.first == {}
    with pytest.raises(InputError, match=r"indices of vertical\.travel, gravity, which are correlated"):
        propagate(ball, uncertain, correlation={"gravity, vertical.travel": rho}, indices=True, **how)


def test_a_fit_is_propagated_with_its_correlation(ball):
    """Start and gravity of a fall, fitted: their covariance, carried to a later time, is that of the regression there."""
    t, sigma, end = np.linspace(0.05, 0.4, 40), 1e-3, 0.42
    heights = 1 - G * t**2 / 2 + np.random.default_rng(1).normal(0, sigma, len(t))
    data = Measurement(t, {"y": heights}, {"y": "m"})
    free = {"vertical.travel": "0.9..1.2 m", "gravity": "9..11 m/s^2"}
    fitted = fit(ball, data, free=free, map={"y": "vertical.travel"}, noise={"y": (sigma, "m")}, starts=0)
    design = np.column_stack([np.ones(40), -(t**2) / 2])
    way = np.array([1, -(end**2) / 2])
    expected = sigma * math.sqrt(way @ np.linalg.solve(design.T @ design, way))
    joint = fitted.distribution()
    assert joint.correlation["vertical.travel, gravity"] > 0.7
    for given in (joint, Correlated(**joint.record())):
        (later,) = propagate(ball, given, ["final.vertical.travel"], sample=32, duration=end, **SHORT)
        assert later.linear == pytest.approx(expected, rel=1e-4)
        assert later.std == pytest.approx(expected, rel=0.2)


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [(87775.4, 123.4, "87780 +- 120"), (1.15625, 0.065, "1.156 +- 0.065"), (-5, 2e-5, "-5.000000 +- 0.000020"),
     (1e-9, 3e-12, "1.0000e-09 +- 3.0e-12"), (1e12, 3e8, "1.00000e+12 +- 3.0e+08"), (math.nan, 1, "nan +- 1"), (2, 0, "2 +- 0")],
)  # fmt: skip
def test_a_value_has_the_digits_that_its_error_leaves(value, error, text):
    """It was 87775.4 +- 1.2e+02."""
    assert propagation_result._rounded(value, error) == text
