"""Fits of statistics by simulated moments: against power laws of a drop, a scene in chaos, and bad input."""

import math

import numpy as np
import pytest
from scipy.stats import binom, chi2

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import fit_moments, load, sweep
from hertzwerk.runtime.studies.fitting.moments import moment_fit

RANGES = {"drop_height": "0.7..1.5 m log", "stiffness": "1e10..4e10 N/m^1.5 log"}
HOW = {"duration": "0.7 s", "parameters": {"restitution": 1}, "tolerance": 1e-9, "workers": 1}


@pytest.fixture(scope="module")
def ball():
    return load("bouncing_ball")


def test_a_drop_follows_its_power_laws(ball):
    """Impulse 2 m sqrt(2 g h), peak force K^(2/5) (5/4 m v^2)^(3/5): h and K, and their intervals, in closed form."""
    h, stiffness = 1.0, 2.2e10
    v = math.sqrt(2 * 9.81 * h)
    impulse, force = 2 * v, stiffness**0.4 * (1.25 * v**2) ** 0.6
    part = 0.01
    moments = {
        "floor.impulse": ((impulse, "N s"), (part * impulse, "N s")),
        "floor.peak_force": f"{force} +- {part * force} N",
    }
    fitted = fit_moments(ball, moments, free=RANGES, **HOW)
    of_height = 2 * part
    of_stiffness = math.hypot(part, 0.6 * of_height) / 0.4
    for name, value, deviation in (("drop_height", h, of_height), ("stiffness", stiffness, of_stiffness)):
        one = fitted[name]
        assert one.value == pytest.approx(value, rel=2e-3)
        assert math.log(one.interval.high / one.interval.low) == pytest.approx(2 * 1.96 * deviation, rel=0.05)
        assert "simulated moments" in one.interval.how
    assert fitted.goodness is None and fitted.unidentified == () and fitted.explained is None
    for moment in fitted.moments:
        assert moment.fitted == pytest.approx(moment.value, rel=1e-3)


def test_statistics_that_do_not_tell_are_said_by_name(ball):
    """The force alone tells a product of powers of height and stiffness, and a third that contradicts is rejected."""
    h = 1.0
    impulse = 2 * math.sqrt(2 * 9.81 * h)
    moments = {"floor.impulse": f"{impulse} +- {impulse / 100} N s", "floor.impacts": "1 +- 0.1"}
    fitted = fit_moments(ball, moments, free=RANGES, **HOW)
    assert (
        len(fitted.unidentified) == 1
        and "stiffness times 2" in fitted.unidentified[0]
        and "none" in fitted["stiffness"].interval.how
    )
    wrong = {**moments, "floor.peak_force": "1000 +- 100 N"}
    assert fit_moments(ball, wrong, free=RANGES, **HOW).explained is False


def test_bad_moments_are_one_error(ball):
    moments = {"floor.impulse": "3 N s", "floor.peak_force": ("5 kN", "0.1 mm"), "floor.impacts": "1 +- 0"}
    with pytest.raises(InputError) as raised:
        fit_moments(ball, moments, free={"drop_heigth": None}, **HOW)
    text = str(raised.value)
    for part in ("did you mean drop_height", "412 +- 5 1/s", "0.1 mm", "a positive standard deviation"):
        assert part in text
    with pytest.raises(InputError, match="no_such"):
        fit_moments(ball, {"floor.no_such": "1 +- 1 N"}, free=RANGES, **HOW)
    with pytest.raises(InputError, match=r"runs that finish(.|\n)*too_many_steps: .* 3 steps accepted"):
        fit_moments(ball, {"floor.impulse": "8.9 +- 0.1 N s"}, free=["drop_height"], **HOW, max_steps=3)


class Runs:
    """Table of runs that were made: what `sweep` returns, columns by name."""

    interrupted = False

    def __init__(self, columns):
        self.columns = columns

    def __getitem__(self, name):
        return self.columns[name]

    def __iter__(self):
        return ({"outcome": "finished", "message": ""} for _ in next(iter(self.columns.values())))


STATISTICS = {"floor.impact_rate": "1/s", "floor.mean_force": "N", "floor.mean_peak_force": "N"}


@pytest.mark.parametrize("independent", [False, True])
def test_statistics_of_one_record_are_correlated_as_those_of_a_run(independent, ball, monkeypatch):
    """Each is 1 + h; three with a correlation r have 1 + 2 r of the variance of three that are independent."""
    r, deviation = 0.9, 0.05

    def made(model, over, *, outputs, sample=1, seed=0, **how):
        rng = np.random.default_rng(seed)
        h = rng.uniform(0.7, 1.3, sample)
        together, own = rng.normal(size=sample), rng.normal(size=(3, sample))
        chance = 0.1 * deviation * (math.sqrt(r) * together + math.sqrt(1 - r) * own)
        columns = {"drop_height": h} | dict(zip(outputs, 1 + h + chance, strict=True))
        return Runs(columns | {f"{name}.half_width": np.full(sample, 0.196 * deviation) for name in outputs})

    monkeypatch.setattr(moment_fit, "sweep", made)
    moments = {name: f"2 +- {deviation} {unit}" for name, unit in STATISTICS.items()}
    one = fit_moments(ball, moments, free={"drop_height": "0.7..1.3 m"}, independent=independent)["drop_height"]
    expected = 1.96 * deviation * math.sqrt((1 if independent else 1 + 2 * r) / 3)
    assert (one.interval.high - one.interval.low) / 2 == pytest.approx(expected, rel=0.06)


def drawn(columns, left, random):
    """Return a sweep over clearances that draws from runs `left` in each part of the range, without putting back."""
    places = columns["clearance"]

    def drawing(model, over, *, sample=None, **how):
        (wanted,) = over.values()
        if sample is None:  # of a list of one
            rows = [np.argmin(abs(places - wanted[0][0]))]
        else:
            low, high = map(float, wanted.split()[0].split(".."))
            middles = low + (high - low) * (np.arange(sample) + random.uniform(size=sample)) / sample
            rows = []
            for middle in middles:
                rows.append(min(left, key=lambda k, middle=middle: abs(places[k] - middle)))
                left.remove(rows[-1])
        return Runs({name: column[rows] for name, column in columns.items()})

    return drawing


@pytest.mark.exhaustive
def test_intervals_hold_the_clearance_of_a_rattling_pin(monkeypatch):
    """Runs far beyond their horizon, each once the measured one, against the others as runs of its fit.

    Right intervals of 95 %: binomial, and chi squared for the mean of the squares, are beyond these bounds once in 500.
    """
    units = {"impact_rate": "1/s", "mean_peak_force": "N", "dissipated_power": "W", "mean_force": "N"}
    units = {f"slider_pin.{name}": unit for name, unit in units.items()}
    model, free, how = load("slider_crank_frictionless"), {"clearance": "0.3..0.7 mm"}, {"duration": "200 rev"}
    made = sweep(model, free, outputs=list(units), sample=200, tolerance=1e-6, **how)
    names = ["clearance", *(name + end for name in units for end in ("", ".half_width"))]
    columns = {name: np.asarray(made[name], dtype=float) for name in names}
    whole = np.all(np.isfinite(list(columns.values())), axis=0)
    columns = {name: column[whole] for name, column in columns.items()}
    places, squares, held = columns["clearance"], [], 0
    for i in np.flatnonzero((places > 0.37e-3) & (places < 0.63e-3)).tolist():
        left = [k for k in range(len(places)) if k != i]
        monkeypatch.setattr(moment_fit, "sweep", drawn(columns, left, np.random.default_rng(i)))
        moments = {
            name: ((columns[name][i], unit), (columns[f"{name}.half_width"][i] / 1.96, unit))
            for name, unit in units.items()
        }
        one = fit_moments(model, moments, free=free, **how)["clearance"]
        deviation = (one.interval.high - one.interval.low) / 2 / 1.96
        squares.append(((one.value - places[i]) / deviation) ** 2)
        held += one.interval.low <= places[i] <= one.interval.high
    print("held", held, "of", len(squares), "mean square", np.mean(squares))
    assert binom.cdf(held, len(squares), 0.95) > 0.002
    assert chi2.cdf(sum(squares), len(squares)) < 0.998
