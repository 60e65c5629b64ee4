"""Derivatives of outputs by name, each beside extrapolated differences of runs, with forces that jump too."""

import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.model.si_values import si_units
from hertzwerk.runtime.engine.sensitivity.output_derivatives import NoDerivativeError, OutputDerivatives
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Measured, chosen

DASHPOT = {"floor": "power(K=1e6 N/m, n=1) x power_damping(chi=200 N s/m, m=0)"}


def made(model, name, value, duration):
    given = {name: (value, si_units(model)[name] or "1")} if name else {}
    return simulate(model, duration=duration, tolerance=1e-12, method="dop853", compiled=False, parameters=given)


def values(model, run, outputs):
    measured = Measured(run)
    return np.array([output.of(measured)[0] for output in chosen(model, outputs, [])])


def worst(model, name, outputs, duration, step=1e-4):
    """Largest relative difference of the outputs' derivatives from extrapolated differences."""
    run, now = made(model, "", 0, duration), model.bind()[name]
    actual = OutputDerivatives(run, run.sensitivities(name))
    first = [
        (values(model, made(model, name, now + d, duration), outputs) - values(model, made(model, name, now - d, duration), outputs)) / (2 * d)
        for d in (step * now, step * now / 2)
    ]  # fmt: skip
    expected = (4 * first[1] - first[0]) / 3
    return {
        output: abs(actual[output][0] - value) / abs(value) for output, value in zip(outputs, expected, strict=True)
    }


def test_outputs_of_a_crank_with_clearance():
    outputs = (
        "final.guide.travel", "energy_ledger.input", "peak_force", "slider_pin.peak_force", "slider_pin.max_penetration",
        "slider_pin.impulse", "guide.speed.mean", "guide.acceleration.rms", "guide.acceleration.min",
        "slider_pin.normal_force.max", "slider_pin.eccentricity_x.peak_to_peak", "main_bearing.reaction_x.rms",
    )  # fmt: skip
    differences = worst(engine_model("slider_crank"), "restitution", outputs, "0.6 ms")
    assert {name: part for name, part in differences.items() if part > 3e-5} == {}


def test_integrals_over_a_force_that_jumps(monkeypatch):
    model = engine_model("bouncing_ball", laws=DASHPOT)
    outputs = ("floor.impulse", "floor.normal_force.mean", "floor.normal_force.rms", "vertical.acceleration.max")
    assert max(worst(model, "gravity", outputs[:3], "0.5 s").values()) < 3e-5
    assert worst(model, "floor_chi", outputs[3:], "0.5 s")["vertical.acceleration.max"] < 2e-5
    monkeypatch.setattr(OutputDerivatives, "_sides", lambda self, name, rows: (np.zeros(len(rows)),) * 2)
    assert max(worst(model, "gravity", outputs[:3], "0.5 s").values()) > 1e-3  # what the jumps are worth


def test_outputs_without_a_derivative_say_why():
    run = simulate(engine_model("bouncing_ball"), duration="0.5 s", tolerance=1e-8)
    result = OutputDerivatives(run, run.sensitivities("mass"))
    for output, why in (("impacts", "count"), ("floor.impact_rate", "average"), ("energy_residual", "error"),
                        ("stroke", "function of yours")):  # fmt: skip
        with pytest.raises(NoDerivativeError, match=why):
            result[output]
    assert result["floor.peak_force"][0] > 0
    still = simulate(engine_model("bouncing_ball"), duration="0.1 s", tolerance=1e-8)
    assert OutputDerivatives(still, still.sensitivities("mass"))["floor.peak_force"] == 0
