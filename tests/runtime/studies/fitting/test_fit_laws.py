"""Laws ranked by what data say: one that forces tell, two that are one law under two names, and bad input."""

import numpy as np
import pytest
from scipy.stats import norm

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Experiment, MeasuredImpacts, Measurement, fit_laws, simulate
from hertzwerk.runtime.studies.fitting.fitting import read_fit
from hertzwerk.runtime.studies.fitting.law_ranking import ranked, split_laws

NOISE = {"v": "0.01 m/s", "f": "100 N"}
HOW = {
    "free": {"restitution": (0.3, 1)}, "starts": 0, "map": {"v": "impacts.speed", "f": "impacts.peak_force"}, "profile": False,
}  # fmt: skip


FALLS = {
        "map": {"height": "vertical.travel"}, "noise": {"height": "1 mm"}, "initial": None, "inputs": None, "duration": None, "offset": "0 s",
        "gain": None, "tolerance": 1e-11, "method": "dop853", "starts": 0, "seed": 0, "compiled": False, "profile": False,
}  # fmt: skip


def drops(model, heights=(0.4, 0.8, 1.2)):
    """Speeds and peak forces of the first two impacts of drops, with noise."""
    rng, made = np.random.default_rng(5), []
    for h in heights:
        run = simulate(
            model, duration="1.8 s", tolerance=1e-10, parameters={"drop_height": (h, "m"), "restitution": 0.8}
        )
        columns = {"v": [i.speed for i in run.impacts[:2]], "f": [i.peak_force for i in run.impacts[:2]]}
        noise = {"v": 0.01, "f": 100.0}
        data = {name: np.array(values) + rng.normal(0, noise[name], 2) for name, values in columns.items()}
        table = MeasuredImpacts([1, 2], data, {"v": "m/s", "f": "N"})
        made.append(Experiment(table, {"drop_height": (h, "m")}, duration="1.8 s"))
    return made


@pytest.mark.slow  # derives other laws
def test_peak_forces_tell_the_form_of_damping_and_not_its_name(ball):
    """Flores and Hunt-Crossley are one law, h(e) apart; Tsuji's damps early, and peaks earlier and lower."""
    fitted = fit_laws(ball, drops(ball), {"floor": ["tsuji", "hunt_crossley", "flores"]}, noise=NOISE, **HOW)
    *alike, last = fitted.laws
    assert {law.name for law in alike} == {"flores", "hunt_crossley"} and last.name == "tsuji"
    assert alike[1].difference < 1e-3 and last.difference > 20
    assert (
        last.held_out_total < fitted.best.held_out_total - 3
        and fitted.best.fitted.explained
        and not last.fitted.explained
    )
    assert fitted.alike == (alike[1].name,) and fitted.verdict.startswith("not distinguished by these data")
    assert abs(sum(law.weight for law in fitted.laws) - 1) < 1e-12
    fitted = fit_laws(ball, drops(ball), {"floor": ["tsuji", "flores"]}, noise=NOISE, **HOW)
    assert fitted.alike == () and "flores is distinguished" in str(fitted)


def test_weights_are_akaikes(ball):
    """Two regressions on one fall, h = s - g t^2/2 with g free or held: weights of exp(-AICc/2), which add up to 1."""
    t, sigma = np.linspace(0.02, 0.44, 40), 1e-3
    y = 1.1 - 9.81 * t**2 / 2 + sigma * np.sin(37 * np.arange(40))
    data = Measurement(t, {"height": y}, {"height": "m"})
    start = {"vertical.travel": "1..1.2 m"}
    result = ranked({
        "free": read_fit(ball, data, {"gravity": "9..11 m/s^2", **start}, parameters=None, **FALLS),
        "held": read_fit(ball, data, start, parameters={"gravity": "9.81 m/s^2"}, **FALLS),
    })  # fmt: skip

    def aicc(*columns):
        _, square, *_ = np.linalg.lstsq(np.column_stack(columns), y + (0 if len(columns) > 1 else 9.81 * t**2 / 2))
        k, n = len(columns), len(t)
        return square[0] / sigma**2 + 2 * k + 2 * k * (k + 1) / (n - k - 1)

    ones = np.ones(40)
    apart = aicc(ones, -(t**2) / 2) - aicc(ones)
    weights = {law.name: law.weight for law in result.laws}
    assert 1 < apart < 4
    assert weights["held"] == pytest.approx(1 / (1 + np.exp(-apart / 2)), abs=1e-6)
    assert weights["free"] == pytest.approx(1 / (1 + np.exp(apart / 2)), abs=1e-6)
    assert [law.name for law in result.laws] == ["held", "free"]


def test_runs_held_out_are_judged_by_the_fit_of_the_others(ball):
    """Two falls h = s - g t^2/2 with s free: each has the density of normal noise about the mean of the other."""
    t, sigma = np.linspace(0.02, 0.4, 30), 1e-3
    falls = [1.1 - 9.81 * t**2 / 2 + sigma * np.sin(factor * np.arange(30)) for factor in (37, 11)]
    data = [Measurement(t, {"height": fall}, {"height": "m"}) for fall in falls]
    actual = ranked(
        {"one": read_fit(ball, data, {"vertical.travel": "1..1.2 m"}, parameters=None, **FALLS)}
    ).best.held_out
    raised = [fall + 9.81 * t**2 / 2 for fall in falls]
    expected = [norm.logpdf(one, np.mean(other), sigma).sum() for one, other in (raised, raised[::-1])]
    assert actual == pytest.approx(expected, rel=1e-6)


def test_bad_laws_are_one_error(ball):
    data = drops(ball, heights=(0.4,))
    with pytest.raises(InputError) as raised:
        fit_laws(ball, data, {"floor": ["flores", "no_such_law"]}, free={"restitutoin": None}, map=HOW["map"])
    assert "no_such_law" in str(raised.value) and "restitutoin" in str(raised.value)
    with pytest.raises(InputError, match="two or more"):
        fit_laws(ball, data, {"floor": ["flores"]}, free=["restitution"], map=HOW["map"])
    with pytest.raises(InputError, match="laws by effect"):
        fit_laws(ball, data, {"floor": "flores"}, free=["restitution"])
    assert split_laws("flores, power(K=1e6 N/m, n=1) x flores,hunt_crossley") == [
        "flores", "power(K=1e6 N/m, n=1) x flores", "hunt_crossley",
    ]  # fmt: skip
