"""The yardstick is right before it is fast: the hand-written program against the quadruple-precision digits."""

import pytest
from benchmarks import programs

from reference.slider_crank import SliderCrank, reference

pytestmark = [pytest.mark.skipif(programs.COMPILER is None, reason="needs g++"), pytest.mark.exhaustive]


@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize(("method", "tolerance", "error"), [("dop853", 1e-15, 1e-10), ("dopri5", 1e-11, 1e-6)])
def test_extended_precision_meets_the_reference(friction, method, tolerance, error):
    """80-bit arithmetic, another method and another code than the reference's: all onsets and states agree."""
    truth = reference(friction)
    run = programs.handwritten(method, tolerance, friction=friction, times=tuple(truth.states), real="long double")
    assert len(run["impacts"]) == len(truth.impacts)
    for (onset, speed), hit in zip(run["impacts"], truth.impacts, strict=True):
        assert onset == pytest.approx(hit.onset, rel=error)
        assert speed == pytest.approx(hit.speed, rel=100 * error)
    for t, *state in run["states"]:
        assert truth.error(t, tuple(state)) < 10 * error


@pytest.mark.parametrize(("error", "evaluations"), [(2e-3, 10_000), (2e-6, 21_000)])
def test_evaluations_for_an_error(error, evaluations):
    """Independent sanity figures (issue 4, "Numbers"): evaluations for two frictionless revolutions, error taken at 10 ms."""
    truth, costs = reference(False), []
    for exponent in range(18, 7, -1):  # from tight to loose, while every run keeps the error
        run = programs.handwritten("dop853", 10 ** (-exponent / 2), friction=False, times=(0.010, 0.024))
        if truth.error(0.010, tuple(run["states"][0][1:])) > error:
            break
        costs.append(run["evaluations"])
    assert costs and evaluations / 2 < costs[-1] < 1.5 * evaluations


def test_smallest_clearance_follows_the_ideal_mechanism():
    """At 5 um and two revolutions the slider stays within gain x (clearance + depth) of the ideal one."""
    from reference import ideal_slider_crank

    m, clearance = SliderCrank(), 5e-6
    run = programs.handwritten(
        "dop853", 1e-6, friction=False, times=tuple(k * 1e-3 for k in range(1, 25)), clearance=clearance
    )
    for t, _, x, *_ in run["states"]:
        ideal = ideal_slider_crank.position(m.w * t, m.r, m.l)
        assert abs(x - ideal) < ideal_slider_crank.gain(m.r, m.l) * (clearance + 2e-5)
