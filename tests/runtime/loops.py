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


def spatial_crank_at(t: float) -> dict[str, float]:
    """Angles, travel and their rates of the spatial slider-crank at t: t = integral sqrt(M(th) / 2 (E - V(th))) dth over the crank's angle."""
    with mpmath.workdps(25):
        r, l, y, z, slider, rod = (mpmath.mpf(x) for x in (0.08, 0.3, 0.1, 0.12, 2.0, 0.5))

        def moved(th):
            """Position, its derivatives by th, and kinetic and potential energy at one rad/s."""
            a2 = mpmath.asin((z + r * mpmath.cos(th)) / l)
            s2, c2 = mpmath.sin(a2), mpmath.cos(a2)
            a1 = -mpmath.asin((y - r * mpmath.sin(th)) / (l * c2))
            s1, c1 = mpmath.sin(a1), mpmath.cos(a1)
            d2 = -r * mpmath.sin(th) / (l * c2)
            d1 = (r * mpmath.cos(th) + l * s2 * d2 * s1) / (l * c2 * c1)
            dx = -l * (s2 * d2 * c1 + c2 * s1 * d1)
            spin = 4e-4 * (d1 * s2) ** 2 + 4e-3 * (d2**2 + (d1 * c2) ** 2)
            mass = 1e-4 + rod * (dx**2 + r**2) / 4 + spin + slider * dx**2
            return (th, l * c2 * c1, a1, a2), (mpmath.mpf(1), dx, d1, d2), mass / 2, rod * 9.81 * l * s2 / 2

        *_, mass, height = moved(mpmath.mpf(0))
        energy = 36 * mass + height

        def slowness(th):
            *_, mass, height = moved(th)
            return mpmath.sqrt(mass / (energy - height))

        count = 300  # of a periodic function: the trapezoidal rule errs by less than 1e-25
        period = sum(slowness(2 * mpmath.pi * k / count) for k in range(count)) * 2 * mpmath.pi / count
        turns = mpmath.floor(t / period)
        rest = t - turns * period
        th = mpmath.findroot(
            lambda th: mpmath.quad(slowness, mpmath.linspace(0, th, 7)) - rest, 2 * mpmath.pi * rest / period
        )
        place, rates, *_ = moved(th)
        names = ("main_bearing.angle", "guide.travel", "slider_joint.angle_1", "slider_joint.angle_2")
        speeds = ("main_bearing.speed", "guide.speed", "slider_joint.angle_1_speed", "slider_joint.angle_2_speed")
        found = dict(zip((*names, *speeds), (*place, *(rate / slowness(th) for rate in rates)), strict=True))
        found["main_bearing.angle"] += 2 * mpmath.pi * turns
        return {name: float(value) for name, value in found.items()}


def open_by(run) -> float:
    """Largest |constraint| over the accepted steps."""
    model, y = run.model, run.history.part("y")
    constraints, c = model.function("constraints"), run.history.controls[: model.nc]
    ends = model.nq, model.nq + model.nu
    return max(
        np.max(np.abs(np.array(constraints(t, x[: ends[0]], x[ends[0] : ends[1]], c)[0])))
        for t, x in zip(run.t, y, strict=True)
    )
