"""Every way a run can end, on built-in scenes and through the public interface alone."""

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate


def stop(fraction):
    raise KeyboardInterrupt


def broken(fraction):
    raise ValueError("no such bar")


CRANK, BALL = ("slider_crank_frictionless", "24 ms"), ("bouncing_ball", "5 s")


@pytest.mark.parametrize(
    ("outcome", "scene", "options"),
    [
        ("finished", CRANK, {}),
        ("interrupted", CRANK, {"progress": stop}),
        ("exception", CRANK, {"progress": broken}),
        ("wall_time_limit", CRANK, {"wall_time": 1e-9}),
        ("too_many_steps", CRANK, {"max_steps": 100}),
        ("event_limit", CRANK, {"max_events": 2}),
        # a crank longer than the rod goes round: the pin is torn out of its bush
        ("outside_law_range", CRANK, {"parameters": {"crank_radius": "0.13 m"}}),
        # an impact shorter than the spacing of doubles at its time
        ("step_too_small", CRANK, {"parameters": {"youngs_modulus": "1e30 GPa"}}),
        # damping 8 (1 - e)/(5 e) beyond the largest double as soon as it is multiplied by the stiffness
        ("not_finite", BALL, {"parameters": {"restitution": 1e-300}}),
    ],
)
def test_outcome(outcome, scene, options):
    name, duration = scene
    run = simulate(load(name), duration=duration, tolerance=1e-11, **options)
    assert run.outcome.name == outcome
    assert run.outcome.finished == (outcome == "finished")
    assert bool(run.outcome.remedy) != run.outcome.finished
    assert run.outcome.message
    assert (run.t[-1] == run.settings.duration) == run.outcome.finished
    assert run.t[-1] > 0
    assert len(run.impacts) >= 1  # what was computed until then is there
    assert np.all(np.isfinite([run[state] for state in run.engine.states]))
    assert str(run).startswith(outcome)


def test_impacts_beyond_the_materials_limit_are_counted():
    """Steel of 7800 kg/m^3: v0 <= 1e-5 sqrt(E/rho) = 0.0515 m/s; the two spheres meet at 0.3 m/s, or at 0.05 m/s."""
    from dataclasses import replace

    from hertzwerk.derive import Contact, Parameter
    from hertzwerk.derive.laws import flores, hertz_point
    from hertzwerk.derive.scenes.two_spheres import e, scene, steel

    dense = replace(steel, density=Parameter("density", "kg/m^3", 7800))
    model = load(scene.replace(spheres=Contact("spheres", hertz_point(dense, dense), flores(e))))
    run = simulate(model, duration="50 ms", tolerance=1e-6)
    (warning,) = [text for text in run.warnings if "1 of 1 impacts of spheres" in text]
    assert "0.0515 m/s (worst 0.3 m/s)" in warning
    slow = simulate(model, duration="300 ms", parameters={"speed": "0.05 m/s"}, tolerance=1e-6)
    assert not any("impacts of spheres" in text for text in slow.warnings)
