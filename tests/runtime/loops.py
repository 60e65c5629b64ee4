"""Closed loops that several tests run, the closed motion of some of them, and how far a run is open."""

import mpmath
import numpy as np

import hertzwerk.derive as hd


def four_bar(crank: float, coupler: float, rocker: float, base: float, *drive: float, **start) -> hd.Scene:
    lengths = {name: hd.Parameter(name, "m", value) for name, value in
               (("crank", crank), ("coupler", coupler), ("rocker", rocker), ("base", base))}  # fmt: skip
    m, J, w = hd.Parameter("mass", "kg", 1.0), hd.Parameter("inertia", "kg m^2", 0.1), hd.Parameter("w", "rad/s", 2.0)
    a, b, c = (hd.Body(name, m, J, centre=(lengths[name] / 2, 0, 0)) for name in ("crank", "coupler", "rocker"))
    joints = (
        hd.Revolute("main", hd.GROUND, a, axis=hd.Z),
        hd.Revolute("left", a.at(lengths["crank"], 0, 0), b, axis=hd.Z),
        hd.Revolute("foot", hd.GROUND.at(lengths["base"], 0, 0), c, axis=hd.Z),
        hd.Revolute("right", b.at(lengths["coupler"], 0, 0), c.at(lengths["rocker"], 0, 0), axis=hd.Z),
    )
    driven = (hd.ConstantSpeed("drive", "main", w),) if drive else ()
    return hd.Scene(
        hd.Mechanism("four_bar", joints=joints),
        effects=(*driven, hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y), hd.EnergyLedger()),
        start=hd.Start(**start),
        scales=hd.Scales(length=lengths["crank"], speed=lengths["crank"] * w, arm=lengths["crank"]),
    )


def cranks() -> hd.Scene:
    """Three equal cranks side by side on one coupler: without any of the three it would move the same."""
    length, base = hd.Parameter("crank", "m", 1.0), hd.Parameter("base", "m", 2.0)
    m, J = hd.Parameter("mass", "kg", 1.0), hd.Parameter("inertia", "kg m^2", 0.1)
    one, two, three = (hd.Body(name, m, J, centre=(length / 2, 0, 0)) for name in ("one", "two", "three"))
    coupler = hd.Body("coupler", m, J, centre=(base / 2, 0, 0))
    joints = (
        hd.Revolute("first", hd.GROUND, one, axis=hd.Z), hd.Revolute("left", one.at(length, 0, 0), coupler, axis=hd.Z),
        hd.Revolute("second", hd.GROUND.at(base, 0, 0), two, axis=hd.Z), hd.Revolute("third", hd.GROUND.at(base / 2, 0, 0), three, axis=hd.Z),
        hd.Revolute("right", coupler.at(base, 0, 0), two.at(length, 0, 0), axis=hd.Z),
        hd.Revolute("middle", coupler.at(base / 2, 0, 0), three.at(length, 0, 0), axis=hd.Z),
    )  # fmt: skip
    effects = (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y), hd.EnergyLedger())
    start = hd.Start(position={"first": hd.Parameter("lift", "rad", 0.4)})
    return hd.Scene(
        hd.Mechanism("cranks", joints=joints), effects, hd.Scales(length, hd.Parameter("pace", "m/s", 1.0), length), start,
    )  # fmt: skip


def rad(value: float) -> hd.Parameter:
    return hd.Parameter(f"a{str(abs(value)).replace('.', '')}", "rad", value)


def turned(windows: int, t: float) -> float:
    """Angle of the posts of N windows at t, as one pendulum th'' = k sin(th) from the upright with -1 rad/s, by elliptic functions."""
    with mpmath.workdps(30):
        k = mpmath.mpf("9.81") * (mpmath.mpf(windows + 1) / 2 + windows) / (mpmath.mpf(windows + 1) / 3 + windows)
        m, u = -4 * k, mpmath.mpf(t) / 2  # of th/2: x'^2 = 1/4 + k sin(x)^2
        period = 2 * mpmath.ellipk(m)
        turns = mpmath.nint(u / period)
        s, c = (mpmath.re(mpmath.ellipfun(f)(u - turns * period, m=m)) for f in ("sn", "cn"))
        return float(-2 * (mpmath.atan2(s, c) + turns * mpmath.pi))


def open_by(run) -> float:
    """Largest |constraint| over the accepted steps."""
    model, y = run.engine.model, run.engine.history.part("y")
    constraints, c = model.function("constraints"), run.engine.history.controls[: model.nc]
    ends = model.nq, model.nq + model.nu
    return max(
        np.max(np.abs(np.array(constraints(t, x[: ends[0]], x[ends[0] : ends[1]], c)[0])))
        for t, x in zip(run.t, y, strict=True)
    )
