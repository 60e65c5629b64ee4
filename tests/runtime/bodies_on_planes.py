"""Bodies at random against a plane, with set-valued friction: the same for every machine and every run.

The truth is `reference.body_on_plane`. A body's line there is its record: all that is needed to run it again.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import sympy as sp

from hertzwerk import load, simulate
from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Contact,
    Direction,
    EnergyLedger,
    Free,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
    Z,
    laws,
)
from hertzwerk.derive import Body as RigidBody
from reference.body_on_plane import Body, Motion, motions

SEED, GRAVITY, RUB_SPEED = 20261124, 9.81, 1e-3
RESTITUTIONS = {  # of each law by restitution: what it is tried with
    "hunt_crossley": (0.3, 1.0),
    "herbert_mcwhannell": (0.2, 1.0),
    "lee_wang": (0.3, 1.0),
    "lankarani_nikravesh": (0.3, 1.0),
    "gonthier": (0.15, 1.0),
    "zhiying_qishao": (0.2, 1.0),
    "flores": (0.15, 1.0),
    "gharib_hurmuzlu": (0.1, 0.6),
    "hu_guo": (0.15, 1.0),
    "carvalho_martins": (0.1, 1.0),
    "safaeifar_farshidianfar": (0.15, 1.0),
    "exact": (0.1, 1.0),
    "kelvin_voigt": (0.1, 1.0),
    "tsuji": (0.1, 1.0),
    "jankowski": (0.1, 1.0),
}
OTHERS = ("elastic", "ristow", "kuwabara_kono", "power_damping")
REQUESTS = (1e-4, 1e-6, 1e-8)
ROUNDING = 1e-16  # share of the start by which that of the second truth differs
AMPLIFIED = 1e3  # roundings in a run, each amplified like one of the start, that a request may fail by


@cache
def model(plane: bool, damping: str, exponent: float, friction: str):
    """Model of all bodies of these laws: everything else is a parameter or a start."""
    p = Parameter
    mass, radius = p("mass", "kg", 1), p("radius", "m", 0.05)
    inertia = tuple(p(f"inertia_{axis}", "kg m^2", 1e-3) for axis in "xyz")
    offset = [p(f"offset_{axis}", "m", 0) for axis in "xyz"]
    tilt, turn = p("tilt", "rad", 0.1), p("turn", "rad", 0.1)
    body = RigidBody("body", mass=mass, inertia=inertia[2] if plane else inertia)
    up = Y if plane else Z
    if plane:
        normal, centre = Direction((sp.sin(tilt), sp.cos(tilt), 0)), body.at(offset[0], offset[1], 0)
    else:
        normal = Direction((sp.sin(tilt) * sp.cos(turn), sp.sin(tilt) * sp.sin(turn), sp.cos(tilt)))
        centre = body.at(*offset)
    joint = Planar("flight", GROUND, body) if plane else Free("flight", GROUND, body)
    stiffness = p("stiffness", {1: "N/m", 1.5: "N/m^1.5", 2: "N/m^2"}[exponent], 1e6)
    resistance = None
    if damping in RESTITUTIONS:
        resistance = getattr(laws, damping)(p("restitution", "1", 0.7))
    elif damping == "ristow":
        resistance = laws.ristow(p("damping_rate", "1/s", 10))
    elif damping == "kuwabara_kono":
        resistance = laws.kuwabara_kono(p("material_time", "s", 1e-5))
    elif damping == "power_damping":
        resistance = laws.power_damping(p("damping", "N s/m^2", 10), 1)
    law = laws.coulomb(p("mu_k", "1", 0.3), p("mu_s", "1", 0.3))
    if friction == "smooth":
        law = laws.smooth_coulomb(p("mu_k", "1", 0.3), p("rub_speed", "m/s", RUB_SPEED))
    return load(
        Scene(
            Mechanism("thrown", (joint,), (SphereOnPlane("floor", centre, radius, GROUND.at(0, 0, 0), normal),)),
            (
                Gravity("gravity", p("gravity", "m/s^2", GRAVITY), direction=-up),
                Contact("floor", laws.power(stiffness, exponent), resistance),
                Friction("rub", "floor", law),
                EnergyLedger(),
            ),
            Scales(length=p("depth", "m", 1e-4), speed=p("pace", "m/s", 1), arm=radius),
            Start(position={"flight.y" if plane else "flight.z": radius * 2}),
        )
    )


def bodies(count: int, seed: int = SEED) -> Iterator[Body]:
    """Yield bodies in plane motion and in space by turns; see the comments for the ranges."""
    for i in range(count):
        yield body_of(i, seed)


def body_of(i: int, seed: int = SEED) -> Body:
    """Return one of them."""
    return _body(np.random.default_rng((seed, i)), plane=i % 2 == 0)


def _body(random: np.random.Generator, *, plane: bool) -> Body:
    def uniform(low: float, high: float) -> float:
        return float(random.uniform(low, high))

    def spread(low: float, high: float) -> float:
        return math.exp(uniform(math.log(low), math.log(high)))

    exponent = (1, 1.5, 2)[random.integers(3)]
    damping = str(random.choice([*RESTITUTIONS, *OTHERS]))
    mass, radius = spread(0.01, 3), spread(0.01, 0.1)
    while True:  # moments that a body can have
        shares = random.uniform(0.1, 0.6, 3)
        if 2 * max(shares) < sum(shares):
            break
    inertia = tuple(float(share) * mass * radius**2 for share in shares)
    offset = np.zeros(3) if random.random() < 0.4 else random.uniform(-0.3, 0.3, 3) * radius
    if plane:
        offset[2] = 0
    tilt = 0.0 if random.random() < 0.2 else uniform(-0.7, 0.7) if plane else uniform(0.02, 0.7)
    turn = 0.0 if plane or random.random() < 0.3 else uniform(-3, 3)
    start = str(random.choice(["drop", "spin", "glance", "low", "rest"], p=[0.15, 0.35, 0.25, 0.15, 0.1]))
    height = spread(0.001, 0.02) if start == "low" else 0.0 if start == "rest" else uniform(0.02, 0.5)
    pace = max(math.sqrt(2 * GRAVITY * height), 0.05)
    shock = spread(3e-4, 8e-3)  # about half the period of the impact
    # of m d'' = -K d^n: the deepest is about pace shock/3, K deep^n = m pace^2/deep
    deep = pace * shock / 3
    stiffness = mass * pace**2 / deep ** (exponent + 1)
    known = {}
    if damping in RESTITUTIONS:
        known["restitution"] = uniform(*RESTITUTIONS[damping])
    elif damping == "ristow":
        known["damping_rate"] = uniform(0.02, 1) * 3 / shock
    elif damping == "kuwabara_kono":
        known["material_time"] = uniform(0.005, 0.3) * shock
    elif damping == "power_damping":
        known["damping"] = uniform(0.02, 1) * stiffness * deep ** (exponent - 1) / pace
    mu = uniform(0.05, 0.6)
    mu_s = mu * uniform(1, 1.5) if random.random() < 0.3 else mu
    normal = (
        np.array([math.sin(tilt), math.cos(tilt), 0.0])
        if plane
        else np.array([math.sin(tilt) * math.cos(turn), math.sin(tilt) * math.sin(turn), math.cos(tilt)])
    )
    q = np.array([1.0, 0, 0, 0])
    if plane:
        angle = uniform(-3, 3)
        q = np.array([math.cos(angle / 2), 0, 0, math.sin(angle / 2)])
    elif random.random() < 0.7:
        q = random.normal(size=4)
        q /= np.linalg.norm(q)
        angle = 0.0
    v, w = np.zeros(3), np.zeros(3)
    if start in ("spin", "rest"):
        v, w = random.uniform(-0.5, 0.5, 3), random.uniform(-40, 40, 3)
    elif start in ("glance", "low"):
        v, w = random.uniform(-3, 3, 3), random.uniform(-20, 20, 3)
    v -= normal * (normal @ v) * (start == "rest") + normal * max(normal @ v, 0)
    if plane:
        v[2] = w[0] = w[1] = 0
    gap = height if height else -((mass * GRAVITY * math.cos(tilt) / stiffness) ** (1 / exponent))
    x = normal * (radius + gap) - _rotated(q, offset)
    return Body(
        plane=plane,
        damping=damping,
        exponent=exponent,
        mass=mass,
        inertia=inertia,
        offset=tuple(map(float, offset)),
        radius=radius,
        tilt=tilt,
        turn=turn,
        stiffness=stiffness,
        known=known,
        mu_k=mu,
        mu_s=mu_s,
        duration=uniform(0.2, 0.7),
        x=tuple(map(float, x)),
        q=tuple(map(float, q)),
        angle=angle if plane else 0.0,
        v=tuple(map(float, v)),
        w=tuple(map(float, w)),
        depth=deep,
        pace=pace,
    )


def _rotated(q: np.ndarray, a: np.ndarray) -> np.ndarray:
    return a + 2 * np.cross(q[1:], np.cross(q[1:], a) + q[0] * a)


def given(body: Body) -> dict[str, dict[str, float]]:
    """Parameters and start of a body, as `simulate` takes them."""
    parameters = {
        "mass": body.mass,
        "radius": body.radius,
        "tilt": body.tilt,
        "stiffness": body.stiffness,
        "mu_k": body.mu_k,
        "mu_s": body.mu_s,
        "depth": body.depth,
        "pace": body.pace,
        **body.known,
    }
    axes = "xy" if body.plane else "xyz"
    parameters |= {f"offset_{axis}": value for axis, value in zip(axes, body.offset, strict=False)}
    if body.plane:
        parameters["inertia_z"] = body.inertia[2]
        start = {"flight.angle": body.angle, "flight.angle_speed": body.w[2]}
    else:
        parameters["turn"] = body.turn
        parameters |= {f"inertia_{axis}": value for axis, value in zip(axes, body.inertia, strict=True)}
        start = {f"flight.q{k}": body.q[k] for k in range(4)}
        start |= {f"flight.angular_speed_{axis}": value for axis, value in zip(axes, body.w, strict=True)}
    start |= {f"flight.{axis}": value for axis, value in zip(axes, body.x, strict=False)}
    start |= {f"flight.{axis}_speed": value for axis, value in zip(axes, body.v, strict=False)}
    return {"parameters": parameters, "initial": start}


def run(body: Body, friction: str = "coulomb", **request):
    """Simulate a body in the virtual machine."""
    made = model(body.plane, body.damping, body.exponent, friction)
    named = given(body)
    if friction == "smooth":
        del named["parameters"]["mu_s"]
    units = {name: port.unit for name, port in made.parameters.items()} | made.units
    named = {part: {name: f"{value!r} {units[name]}" for name, value in of.items()} for part, of in named.items()}
    return simulate(made, duration=body.duration, compiled=False, **named, **request)


def state(motion: Motion, found) -> dict[str, float]:
    """Final state of the truth by the names of histories, angle and sign of the quaternion as in the run."""
    y = motion.state
    truth = dict(zip([f"flight.{axis}" for axis in "xyz"], y[:3], strict=True))
    truth |= dict(zip([f"flight.{axis}_speed" for axis in "xyz"], y[7:10], strict=True))
    if motion.body.plane:
        angle, reached = 2 * math.atan2(y[6], y[3]), float(found["flight.angle"][-1])
        truth |= {
            "flight.angle": reached + math.remainder(angle - reached, 2 * math.pi),
            "flight.angle_speed": y[12],
        }
        return {name: value for name, value in truth.items() if not name.startswith("flight.z")}
    sign = math.copysign(1, sum(float(found[f"flight.q{k}"][-1]) * y[3 + k] for k in range(4)))
    truth |= {f"flight.q{k}": sign * y[3 + k] for k in range(4)}
    return truth | {f"flight.angular_speed_{axis}": y[10 + k] for k, axis in enumerate("xyz")}


def error(motion: Motion, found) -> float:
    """Distance of the end of a run from the truth, in the scene's scales."""
    scales = dict(zip(found.model.units, found.scales.state, strict=False))
    return max(abs(float(found[name][-1]) - value) / scales[name] for name, value in state(motion, found).items())


def floor(one: Motion, other: Motion, found) -> float:
    """Difference that a perturbation of the start by its rounding makes at the end, in the scene's scales."""
    scales = dict(zip(found.model.units, found.scales.state, strict=False))
    a, b = state(one, found), state(other, found)
    return max(abs(a[name] - b[name]) / scales[name] for name in a)


@dataclass(frozen=True)
class Finding:
    """What a request of a body came to: truth and estimate of its error, what rounding does to it, steps beside those with smooth friction."""

    body: Body
    accuracy: float
    outcome: str
    truth: float
    estimate: float
    rounding: float
    steps: int
    smooth_steps: int
    seconds: float
    remark: str = ""

    @property
    def faults(self) -> list[str]:
        """What must not be, in words; empty where all holds."""
        found = []
        if self.remark:
            found.append(self.remark)
        if self.outcome == "finished":
            if self.truth > self.accuracy:
                found.append(f"over the request {self.truth / self.accuracy:.3g} times")
            ratio = self.truth / max(self.estimate, 1e-13)
            if ratio > 10 and self.truth > 1e-12:
                found.append(f"estimate {ratio:.3g} times too small")
        elif self.outcome != "exception" and AMPLIFIED * self.rounding < self.accuracy:
            found.append(f"{self.outcome} without a reason: rounding makes {self.rounding:.1e}")
        if self.smooth_steps and self.steps > 3 * self.smooth_steps:
            found.append(f"{self.steps / self.smooth_steps:.3g} times the steps")
        return found


def judged(body: Body, requests: Sequence[float] = REQUESTS, *, smooth: bool = True, **more) -> Iterator[Finding]:
    """Yield what comes of each request for a body."""
    (truth,), (other,) = motions([body]), motions([body], ROUNDING)
    if truth.wrong:
        raise RuntimeError(f"the oracle did not get to the end of {body}")
    for accuracy in requests:
        begun, remark, smoothed = time.process_time(), "", 0
        try:
            found = run(body, accuracy=accuracy, **more)
        except Exception as raised:
            yield Finding(
                body, accuracy, "exception", *[math.nan] * 3, 0, 0, 0, f"{type(raised).__name__}: {raised}"[:300]
            )
            continue
        seconds = time.process_time() - begun
        if found.outcome.name == "exception":
            remark = str(found.outcome)[:300]
        if smooth and found.outcome.name == "finished":
            smoothed = run(body, "smooth", accuracy=accuracy, **more).statistics.steps
        off = floor(truth, other, found)
        ended = found.t[-1] == body.duration
        estimate = math.nan if found.error is None else found.error.end
        numbers = error(truth, found) if ended else math.nan, estimate, off, found.statistics.steps, smoothed
        yield Finding(body, accuracy, found.outcome.name, *numbers, seconds, remark)


def main() -> None:
    """Judge bodies FIRST to LAST of a seed and print what fails, a line each: `python bodies_on_planes.py FIRST LAST [SEED]`."""
    first, last, *seed = map(int, sys.argv[1:])
    total, failed = 0, 0
    for i in range(first, last):
        for finding in judged(body_of(i, *seed), wall_time=40):
            total += 1
            failed += bool(finding.faults)
            print(
                f"{'FAIL' if finding.faults else 'ok'} {i} {finding.accuracy:g} {finding.outcome} truth {finding.truth:.2e} estimate "
                f"{finding.estimate:.2e} rounding {finding.rounding:.1e} steps {finding.steps} / {finding.smooth_steps} "
                f"{finding.seconds:.1f} s {'; '.join(finding.faults)} {finding.body if finding.faults else ''}",
                flush=True,
            )
    print(f"{failed} of {total} requests failed")


if __name__ == "__main__":
    main()
