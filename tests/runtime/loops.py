"""Closed loops that several tests run, the closed motion of some of them, and how far a run is open."""

import mpmath
import numpy as np

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Revolute,
    Scales,
    Scene,
    Spherical,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.scenes.spatial_slider_crank import scene as with_clearance


def four_bar(crank: float, coupler: float, rocker: float, base: float, *drive: float, **start) -> Scene:
    lengths = {name: Parameter(name, "m", value) for name, value in
               (("crank", crank), ("coupler", coupler), ("rocker", rocker), ("base", base))}  # fmt: skip
    m, J, w = Parameter("mass", "kg", 1.0), Parameter("inertia", "kg m^2", 0.1), Parameter("w", "rad/s", 2.0)
    a, b, c = (Body(name, m, J, centre=(lengths[name] / 2, 0, 0)) for name in ("crank", "coupler", "rocker"))
    joints = (
        Revolute("main", GROUND, a, axis=Z),
        Revolute("left", a.at(lengths["crank"], 0, 0), b, axis=Z),
        Revolute("foot", GROUND.at(lengths["base"], 0, 0), c, axis=Z),
        Revolute("right", b.at(lengths["coupler"], 0, 0), c.at(lengths["rocker"], 0, 0), axis=Z),
    )
    driven = (ConstantSpeed("drive", "main", w),) if drive else ()
    return Scene(
        Mechanism("four_bar", joints=joints),
        effects=(*driven, Gravity("gravity", Parameter("g", "m/s^2", 9.81), direction=-Y), EnergyLedger()),
        start=Start(**start),
        scales=Scales(length=lengths["crank"], speed=lengths["crank"] * w, arm=lengths["crank"]),
    )


def cranks() -> Scene:
    """Three equal cranks side by side on one coupler: without any of the three it would move the same."""
    length, base = Parameter("crank", "m", 1.0), Parameter("base", "m", 2.0)
    m, J = Parameter("mass", "kg", 1.0), Parameter("inertia", "kg m^2", 0.1)
    one, two, three = (Body(name, m, J, centre=(length / 2, 0, 0)) for name in ("one", "two", "three"))
    coupler = Body("coupler", m, J, centre=(base / 2, 0, 0))
    joints = (
        Revolute("first", GROUND, one, axis=Z),
        Revolute("left", one.at(length, 0, 0), coupler, axis=Z),
        Revolute("second", GROUND.at(base, 0, 0), two, axis=Z),
        Revolute("third", GROUND.at(base / 2, 0, 0), three, axis=Z),
        Revolute("right", coupler.at(base, 0, 0), two.at(length, 0, 0), axis=Z),
        Revolute("middle", coupler.at(base / 2, 0, 0), three.at(length, 0, 0), axis=Z),
    )
    effects = (Gravity("gravity", Parameter("g", "m/s^2", 9.81), direction=-Y), EnergyLedger())
    start = Start(position={"first": Parameter("lift", "rad", 0.4)})
    return Scene(
        Mechanism("cranks", joints=joints), effects, Scales(length, Parameter("pace", "m/s", 1.0), length), start
    )


def rad(value: float) -> Parameter:
    return Parameter(f"a{str(abs(value)).replace('.', '')}", "rad", value)


def turned(windows: int, t: float) -> float:
    """Angle of the posts of N windows at t, as one pendulum th'' = k sin(th) from the upright with -1 rad/s, by elliptic functions."""
    with mpmath.workdps(30):
        k = mpmath.mpf("9.81") * (mpmath.mpf(windows + 1) / 2 + windows) / (mpmath.mpf(windows + 1) / 3 + windows)
        m, u = -4 * k, mpmath.mpf(t) / 2  # of th/2: x'^2 = 1/4 + k sin(x)^2
        period = 2 * mpmath.ellipk(m)
        turns = mpmath.nint(u / period)
        s, c = (mpmath.re(mpmath.ellipfun(f)(u - turns * period, m=m)) for f in ("sn", "cn"))
        return float(-2 * (mpmath.atan2(s, c) + turns * mpmath.pi))


def spatial_crank() -> Scene:
    """The spatial slider-crank, its ball joint without clearance and its crank let go at 6 rad/s."""
    given, arm = with_clearance.mechanism, Parameter("crank_length", "m", 0.08)
    (ball,) = given.pairs
    joints = (*given.joints, Spherical("crank_ball", ball.socket, ball.ball))
    effects = tuple(effect for effect in with_clearance.effects if isinstance(effect, (Gravity, EnergyLedger)))
    pace = Parameter("start_speed", "rad/s", 6)
    start = Start(with_clearance.start.position, {"main_bearing": pace})
    return Scene(Mechanism("spatial_crank", joints), effects, Scales(arm, arm * pace, with_clearance.scales.arm), start)


def open_by(run) -> float:
    """Largest |constraint| over the accepted steps."""
    model, y = run.engine.model, run.engine.history.part("y")
    constraints, c = model.function("constraints"), run.engine.history.controls[: model.nc]
    ends = model.nq, model.nq + model.nu
    return max(
        np.max(np.abs(np.array(constraints(t, x[: ends[0]], x[ends[0] : ends[1]], c)[0])))
        for t, x in zip(run.t, y, strict=True)
    )
