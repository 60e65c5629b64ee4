"""Equations of a scene for SymPy: the circle closes, from_sympy of what was exported has the scene's accelerations and runs."""

import types

import numpy as np
import pytest
import sympy as sp
from derived import Derived

from hertzwerk.derive import EnergyLedger, InputError, Parameter, Scales, Start, from_sympy, to_sympy
from hertzwerk.derive.exchange.sympy_models.to_sympy import python_file
from hertzwerk.derive.scenes import (
    cam_follower,
    double_pendulum,
    flyball_governor,
    slider_crank,
    slider_crank_dc_motor,
    tippe_top,
)
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

SIZE = Parameter("size_of_scene", "m", 0.1)
SCALES = Scales(length=SIZE, speed=Parameter("pace_of_scene", "m/s", 1), arm=SIZE)


def imported(scene):
    """The module of a scene's file, executed as its user imports it."""
    module = types.ModuleType(scene.name)
    exec(python_file(to_sympy(scene), scene.name), module.__dict__)
    return module


@pytest.mark.parametrize("scene", [slider_crank.scene, tippe_top.scene], ids=lambda scene: scene.name)
def test_accelerations_come_back(scene):
    module = imported(scene)
    still = dict.fromkeys(module.specified, sp.S.Zero)
    model = from_sympy(module, units=module.units, parameters=module.values, specified=still, name="back")
    back, here, rng = Derived(model.scene(scales=SCALES)), Derived(scene), np.random.default_rng(2)
    for _ in range(3):
        q, u = rng.uniform(-0.4, 0.4, here.nq), rng.uniform(-1, 1, here.nu)
        a, b = (each.call("accelerations", q=q, u=u, f=each.call("applied", q=q, u=u)) for each in (here, back))
        assert b[0] == pytest.approx(a[0], rel=1e-11, abs=1e-11)


def test_a_normal_force_has_the_generalised_force_of_the_contact():
    scene = slider_crank.scene.without("slider_pin_friction")
    here, found = Derived(scene), to_sympy(scene)
    (force,) = found.specified
    q, u = np.array((0.2, 0.25)), np.array((1.0, -2.0))
    push, _, normal, *_ = here.call("contact_slider_pin", q=q, u=u, m=np.ones(1), z=np.zeros(len(here.MEMORY)))
    values = dict(zip((*found.q, *found.u), (*q, *u), strict=True)) | {sp.Symbol("t"): 0}
    values |= {
        symbol: here.p[i]
        for i, (name, *_) in enumerate(here.PARAMETERS)
        for symbol in found.values
        if symbol.name == name
    }
    share = [float(row.diff(force).xreplace(values)) for row in found.forcing]
    assert normal[0] > 0
    assert np.array(share) * normal[0] == pytest.approx(push[: len(u)], rel=1e-12)


def test_a_run_of_what_came_back_is_the_scenes_own():
    scene = double_pendulum.scene
    module = imported(scene)
    model = from_sympy(module, units=module.units, parameters=module.values, name="pendulum_back")
    q, u = (
        simulate(engine_model("double_pendulum"), duration="1 s", accuracy=1e-9)[f"{j}.{w}"]
        for j, w in (("elbow", "angle"), ("elbow", "speed"))
    )
    names = {name: symbol.func.__name__ for name, symbol in module.names.items()}
    start = {names[f"{joint}.angle"]: scene.start.position[joint] for joint in ("shoulder", "elbow")}
    run = simulate(
        engine_model(model.scene(scales=SCALES, start=Start(position=start))), duration="1 s", accuracy=1e-9,
    )  # fmt: skip
    assert run[f"{names['elbow.angle']}.angle"][-1] == pytest.approx(q[-1], abs=1e-7)
    assert run[f"{names['elbow.angle']}.speed"][-1] == pytest.approx(u[-1], abs=1e-6)
    with pytest.raises(InputError, match="equations alone"):
        model.scene(scales=SCALES, effects=(EnergyLedger(),))


@pytest.mark.parametrize(
    ("scene", "found"), [(cam_follower.scene, "Nearest"), (slider_crank_dc_motor.scene, "a state that is no coordinate")], ids=["a curve", "a state"],
)  # fmt: skip
def test_effects_that_sympy_lacks_are_listed(scene, found):
    with pytest.raises(InputError, match=found):
        to_sympy(scene)


@pytest.mark.parametrize("speed", ["0 rad/s", pytest.param("160 rpm", marks=pytest.mark.exhaustive)])
def test_redundant_loops_come_back_also_where_a_constraint_vanishes(speed):
    """In the plane of its spindle at rest the governor has two constraints whose rows are zero."""
    native = engine_model(scene := flyball_governor.scene)
    module, found = imported(scene), to_sympy(scene)
    still = dict.fromkeys(module.specified, sp.S.Zero)
    model = engine_model(
        from_sympy(module, units=module.units, parameters=module.values, specified=still, name="back").scene(
            scales=SCALES
        )
    )
    run = simulate(native, duration="0.1 s", accuracy=1e-8, initial={"spindle.speed": speed})
    names = {name: f"{found.names[name].func}.{name.split('.')[1]}" for name in native.coordinates}
    start = {names[name]: f"{float(run[name][0])!r} {native.units[name]}" for name in names}
    back = simulate(model, duration="0.1 s", accuracy=1e-8, initial={**start, "spindle_angle.speed": speed})
    assert back.outcome.finished
    for name, other in names.items():
        assert back.engine.final[other] == pytest.approx(run.engine.final[name], abs=1e-8)
