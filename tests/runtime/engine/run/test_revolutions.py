"""A duration in revolutions: of the one drive of constant speed, at the parameters of the run."""

import pytest

from hertzwerk.derive import GROUND, Body, Harmonic, Mechanism, Parameter, Ramp, Revolute, Scales, Scene, Z
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.run.drive_speed import drive_speed
from hertzwerk.runtime.loading import engine_model

CRANKS = ("slider_crank", "four_bar_clearance", "spatial_slider_crank", "journal_in_bearing")


@pytest.mark.parametrize("name", CRANKS)
def test_the_speed_of_a_drive_is_the_parameter_it_was_given(name):
    model = engine_model(name)
    (speed,) = (
        port for port in model.parameters if port in ("crank_speed", "shaft_speed", "speed", "omega", "motor_speed")
    )
    for factor in (1.0, -0.37):
        bound = model.bind({speed: (factor * model.parameters[speed].default, model.parameters[speed].unit)})
        assert drive_speed(model, bound) == pytest.approx(abs(bound[speed]), rel=1e-12)


def test_in_absolute_coordinates_too():
    model = engine_model("slider_crank", coordinates="absolute")
    bound = model.bind({"crank_speed": "3000 rpm"})
    assert drive_speed(model, bound) == pytest.approx(bound["crank_speed"], rel=1e-12)


@pytest.mark.parametrize("text", ["0.1 rev", "36 deg"])
def test_revolutions_are_counted_with_the_run_s_own_parameters(text):
    run = simulate(engine_model("slider_crank"), duration=text, tolerance=1e-4, parameters={"crank_speed": "3000 rpm"})
    assert run.engine.t_end == pytest.approx(0.1 * 60 / 3000, rel=1e-15)
    longer = run.continued("0.2 rev")
    assert longer.engine.t_end == pytest.approx(0.2 * 60 / 3000, rel=1e-15)


def driven(*drives):
    arms = [
        Body(f"arm_{i}", Parameter(f"mass_{i}", "kg", 1), inertia=Parameter(f"inertia_{i}", "kg m^2", 1))
        for i in range(3)
    ]
    joints = [Revolute(f"pin_{i}", GROUND, arm, axis=Z) for i, arm in enumerate(arms)]
    scales = Scales(length=Parameter("size", "m", 1), speed=Parameter("pace", "m/s", 1), arm=Parameter("arm", "m", 1))
    return engine_model(Scene(Mechanism("driven", joints=tuple(joints)), effects=drives, scales=scales))


def test_a_scene_without_one_drive_of_constant_speed_has_no_revolutions():
    speed, rise = Parameter("omega", "rad/s", 3), Parameter("rise", "s", 1)
    shaken = Harmonic("drive", "pin_0", Parameter("swing", "rad", 1), Parameter("pulse", "rad/s", 2))
    for model in (engine_model("bouncing_ball"), driven(Ramp("drive", "pin_0", speed, rise)), driven(shaken)):
        with pytest.raises(InputError, match="one drive of constant speed"):
            simulate(model, duration="2 rev", tolerance=1e-4)
    for bad in ("0 rev", "-1 rev"):
        with pytest.raises(InputError, match="duration"):
            simulate(engine_model("slider_crank"), duration=bad, tolerance=1e-4)
    with pytest.raises(InputError) as caught:  # all faults at once, the parameter's among them
        simulate(engine_model("slider_crank"), duration="2 rev", tolerance=7, parameters={"crank_sped": "1 rpm"})
    assert {fault.where for fault in caught.value.faults} == {"tolerance", "crank_sped"}
