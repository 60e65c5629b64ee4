"""Derivatives through a sample of a controller that is due at the very end of a run, which rounding leaves just before it."""

import numpy as np
import pytest

from hertzwerk.derive import GROUND, Body, JointForce, Mechanism, Parameter, Revolute, Scales, Scene, SpeedController, Z
from hertzwerk.runtime import load, simulate

J, GAIN, TARGET, PERIOD, SAMPLES = 0.02, 0.1, 100.0, 0.01, 5


def p(name, unit, value):
    return Parameter(name, unit, value)


@pytest.mark.parametrize(
    ("method", "tolerance"), [("dop853", 1e-12), ("dopri5", 1e-8), ("esdirk", 1e-8), ("rodas", 1e-8)]
)
def test_a_sample_that_is_due_at_the_end_has_derivatives(method, tolerance):
    """Between samples w' = u/J is exact: w <- w (1 - gain T/J) + gain T/J target."""
    gains = p("target", "rad/s", TARGET), p("gain", "N m s/rad", GAIN), p("none", "N m/rad", 0), "N m"
    control = SpeedController("control", "main", *gains, period=p("period", "s", PERIOD))
    rotor = Body("rotor", p("mass", "kg", 1), p("J", "kg m^2", J))
    scene = Scene(
        Mechanism("shaft", (Revolute("main", GROUND, rotor, axis=Z),)),
        (JointForce("drive", "main", control.command), control),
        Scales(p("size", "m", 1), p("pace", "m/s", 100), arm=p("arm", "m", 1)),
    )
    run = simulate(load(scene), duration=SAMPLES * PERIOD, tolerance=tolerance, method=method, compiled=False)
    assert run.statistics.events == SAMPLES
    derivatives = run.sensitivities("gain", "target")
    assert derivatives.reason == "" and derivatives.until == run.engine.t_end
    x = GAIN * PERIOD / J
    by_gain = TARGET * SAMPLES * (1 - x) ** (SAMPLES - 1) * PERIOD / J
    assert derivatives["main.speed", "gain"][-1] == pytest.approx(by_gain, rel=1e-6)
    assert derivatives["main.speed", "target"][-1] == pytest.approx(1 - (1 - x) ** SAMPLES, rel=1e-6)
    command = TARGET * (1 - x) ** SAMPLES - GAIN * by_gain  # of the sample at the end
    assert derivatives["control.command", "gain"][-1] == pytest.approx(command, rel=1e-6)
    assert np.isfinite(derivatives["main.angle", "gain"]).all()
