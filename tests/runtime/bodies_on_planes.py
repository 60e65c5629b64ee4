"""Bodies at random against a plane, with set-valued friction: the same for every machine and every run.

The truth is `reference.body_on_plane`. A body's line there is its record: all that is needed to run it again.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk import simulate
from hertzwerk.derive import Body as RigidBody
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.loading import engine_model
from reference.body_on_plane import Body, Motion, motions, program

SEED, GRAVITY, RUB_SPEED = 20261124, 9.81, 1e-3
RESTITUTIONS = {  # of each law by restitution: what it is tried with
    "hunt_crossley": (0.3, 1.0), "herbert_mcwhannell": (0.2, 1.0), "lee_wang": (0.3, 1.0),
    "lankarani_nikravesh": (0.3, 1.0), "gonthier": (0.15, 1.0), "zhiying_qishao": (0.2, 1.0), "flores": (0.15, 1.0),
    "gharib_hurmuzlu": (0.1, 0.6), "hu_guo": (0.15, 1.0), "carvalho_martins": (0.1, 1.0),
    "safaeifar_farshidianfar": (0.15, 1.0), "exact": (0.1, 1.0), "kelvin_voigt": (0.1, 1.0), "tsuji": (0.1, 1.0),
    "jankowski": (0.1, 1.0),
}  # fmt: skip
OTHERS = ("elastic", "ristow", "kuwabara_kono", "power_damping")
REQUESTS = (1e-4, 1e-6, 1e-8)
SAMPLES = 100  # rows of a run, at most, at which it is judged
MOST = 100_000  # steps: a run, or one that checks it, that takes more is at fault, whatever the machine
LEAST = 1e-12  # of the scales: what no estimate is judged below
ROUNDING = 1e-16  # share of the start by which that of the second truth differs
AMPLIFIED = 1e3  # roundings in a run, each amplified like one of the start, that a request may fail by
IN_DOUBLES = 10.0  # times the error of the oracle in double precision, likewise
DRAWS = (
    8  # runs of it, each from a start of its own: one may hit the truth by chance, within a tenth of what others leave
)


@cache
def model(plane: bool, damping: str, exponent: float, friction: str):
    """Model of all bodies of these laws: everything else is a parameter or a start."""
    p = hd.Parameter
    mass, radius = p("mass", "kg", 1), p("radius", "m", 0.05)
    inertia = tuple(p(f"inertia_{axis}", "kg m^2", 1e-3) for axis in "xyz")
    offset = [p(f"offset_{axis}", "m", 0) for axis in "xyz"]
    tilt, turn = p("tilt", "rad", 0.1), p("turn", "rad", 0.1)
    body = RigidBody("body", mass=mass, inertia=inertia[2] if plane else inertia)
    up = hd.Y if plane else hd.Z
    if plane:
        normal, centre = hd.Direction((sp.sin(tilt), sp.cos(tilt), 0)), body.at(offset[0], offset[1], 0)
    else:
        normal = hd.Direction((sp.sin(tilt) * sp.cos(turn), sp.sin(tilt) * sp.sin(turn), sp.cos(tilt)))
        centre = body.at(*offset)
    joint = hd.Planar("flight", hd.GROUND, body) if plane else hd.Free("flight", hd.GROUND, body)
    stiffness = p("stiffness", {1: "N/m", 1.5: "N/m^1.5", 2: "N/m^2"}[exponent], 1e6)
    resistance = None
    if damping in RESTITUTIONS:
        resistance = getattr(hd.laws, damping)(p("restitution", "1", 0.7))
    elif damping == "ristow":
        resistance = hd.laws.ristow(p("damping_rate", "1/s", 10))
    elif damping == "kuwabara_kono":
        resistance = hd.laws.kuwabara_kono(p("material_time", "s", 1e-5))
    elif damping == "power_damping":
        resistance = hd.laws.power_damping(p("damping", "N s/m^2", 10), 1)
    law = hd.laws.coulomb(p("mu_k", "1", 0.3), p("mu_s", "1", 0.3))
    if friction == "smooth":
        law = hd.laws.smooth_coulomb(p("mu_k", "1", 0.3), p("rub_speed", "m/s", RUB_SPEED))
    return engine_model(
        hd.Scene(
            hd.Mechanism(
                "thrown", (joint,), (hd.SphereOnPlane("floor", centre, radius, hd.GROUND.at(0, 0, 0), normal),)
            ),
            (
                hd.Gravity("gravity", p("gravity", "m/s^2", GRAVITY), direction=-up),
                hd.Contact("floor", hd.laws.power(stiffness, exponent), resistance), hd.Friction("rub", "floor", law), hd.EnergyLedger(),
            ),
            hd.Scales(length=p("depth", "m", 1e-4), speed=p("pace", "m/s", 1), arm=radius),
            hd.Start(position={"flight.y" if plane else "flight.z": radius * 2}),
        )
    )  # fmt: skip


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
        plane=plane, damping=damping, exponent=exponent, mass=mass, inertia=inertia, offset=tuple(map(float, offset)), radius=radius, tilt=tilt,
        turn=turn, stiffness=stiffness, known=known, mu_k=mu, mu_s=mu_s, duration=uniform(0.2, 0.7), x=tuple(map(float, x)), q=tuple(map(float, q)),
        angle=angle if plane else 0.0, v=tuple(map(float, v)), w=tuple(map(float, w)), depth=deep, pace=pace,
    )  # fmt: skip


def _rotated(q: np.ndarray, a: np.ndarray) -> np.ndarray:
    return a + 2 * np.cross(q[1:], np.cross(q[1:], a) + q[0] * a)


def given(body: Body) -> dict[str, dict[str, float]]:
    """Parameters and start of a body, as `simulate` takes them."""
    parameters = {
        "mass": body.mass, "radius": body.radius, "tilt": body.tilt, "stiffness": body.stiffness, "mu_k": body.mu_k, "mu_s": body.mu_s,
        "depth": body.depth, "pace": body.pace, **body.known,
    }  # fmt: skip
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


def run(body: Body, friction: str = "coulomb", **request: Any) -> EngineSolution:
    """Simulate a body in the virtual machine."""
    made = model(body.plane, body.damping, body.exponent, friction)
    named = given(body)
    if friction == "smooth":
        del named["parameters"]["mu_s"]
    units = {name: port.unit for name, port in made.parameters.items()} | made.units
    named = {part: {name: f"{value!r} {units[name]}" for name, value in of.items()} for part, of in named.items()}
    return simulate(made, duration=body.duration, compiled=False, **named, **request)


def truth_of(motion: Motion, found: EngineSolution, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return differences of a run's rows from the truth, and rates of the truth, both scaled.

    (rows, n) each. The truth has its states at these rows' times; angle and sign of the quaternion are as in the run.
    """
    y, dy = motion.states, motion.rates
    of_axes = "xy" if motion.body.plane else "xyz"
    truth = {f"flight.{axis}": (y[:, k], dy[:, k]) for k, axis in enumerate(of_axes)}
    truth |= {f"flight.{axis}_speed": (y[:, 7 + k], dy[:, 7 + k]) for k, axis in enumerate(of_axes)}
    if motion.body.plane:
        angle, reached = 2 * np.arctan2(y[:, 6], y[:, 3]), found["flight.angle"][rows]
        turns = np.round((reached - angle) / (2 * math.pi))
        truth["flight.angle"] = angle + 2 * math.pi * turns, y[:, 12]
        truth["flight.angle_speed"] = y[:, 12], dy[:, 12]
    else:
        sign = np.copysign(1, sum(found[f"flight.q{k}"][rows] * y[:, 3 + k] for k in range(4)))
        truth |= {f"flight.q{k}": (sign * y[:, 3 + k], sign * dy[:, 3 + k]) for k in range(4)}
        truth |= {f"flight.angular_speed_{a}": (y[:, 10 + k], dy[:, 10 + k]) for k, a in enumerate("xyz")}
    known = dict(zip(found.engine.model.units, found.engine.scales.state, strict=False))
    scales = np.array([known[name] for name in truth])
    apart = np.column_stack([found[name][rows] - value for name, (value, _) in truth.items()])
    return apart / scales, np.column_stack([rate for _, rate in truth.values()]) / scales


def distance(apart: np.ndarray, rates: np.ndarray, pace: float) -> np.ndarray:
    """Return the least over a shift in time of the largest difference (rows), the shift counted by `pace` [1/s].

    As the handbook defines it, with the motion linear in the shift: convex, so that its least is found by thirds.
    """

    def off(shift: np.ndarray) -> np.ndarray:
        return np.maximum(pace * np.abs(shift), np.max(np.abs(apart - rates * shift[:, None]), axis=1))

    high = np.max(np.abs(apart), axis=1) / pace
    low = -high
    for _ in range(120):
        one, two = low + (high - low) / 3, high - (high - low) / 3
        nearer = off(one) < off(two)
        low, high = np.where(nearer, low, one), np.where(nearer, two, high)
    return np.minimum(off((low + high) / 2), off(np.zeros(len(apart))))


def contacts_of(motion: Motion, until: float) -> list[tuple[float, float, float]]:
    """Return onset, approach speed and duration of contacts that begin by a time; one that lasts longer counts up to it."""
    contacts: list[tuple[float, float, float]] = []
    released = False
    for t, kind, v0 in motion.events:
        if t > until:
            break
        if kind == "touches":
            contacts.append((t, v0, until - t))
        elif contacts and kind in ("released", "opens", "resumes") and not (kind == "opens" and released):
            begun, speed, _ = contacts[-1]
            contacts[-1] = begun, speed, (until if kind == "resumes" else t) - begun
        released = kind == "released"
    return contacts


def error_of_impacts(motion: Motion, found: EngineSolution) -> float:
    """Return the largest error of onset times and durations, by length over approach speed, and of approach speeds, by the scene's.

    Of contacts on which run and truth agree by order; one that only one of them has counts by its approach speed.
    """
    (length, speed), end = found.engine.scales.scene[:2], found.t[-1]
    true = contacts_of(motion, end)
    mine = [(of.t, of.speed, end - of.t if of.duration is None else of.duration) for of in found.impacts if of.t > 0]
    worst = 0.0
    while true or mine:
        if true and mine:
            (t, v, lasts), (u, w, lasted) = true[0], mine[0]
            off = max(max(v, w) / length * float(np.maximum(abs(t - u), abs(lasts - lasted))), abs(v - w) / speed)
            if off <= max(v, w) / speed:
                worst, true, mine = np.maximum(worst, off), true[1:], mine[1:]
                continue
        only = true if not mine or (true and true[0] < mine[0]) else mine
        worst = np.maximum(worst, only.pop(0)[1] / speed)
    return float(worst)


@dataclass(frozen=True)
class Finding:
    """What a request of a body came to: truth and estimate of its error, what rounding does to it, steps beside those with smooth friction.

    truth, rounding: largest over the run, impacts included; nan where there is none
    doubles: largest error of the oracle in double precision, of several starts, where a request failed
    """

    body: Body
    accuracy: float
    outcome: str
    truth: float = math.nan
    estimate: float = math.nan
    rounding: float = math.nan
    steps: int = 0
    smooth_steps: int = 0
    seconds: float = 0.0
    remark: str = ""
    doubles: float = math.nan

    @property
    def amplified(self) -> bool:
        """Return whether the motion amplifies what rounding leaves, beyond the request."""
        return AMPLIFIED * self.rounding >= self.accuracy or IN_DOUBLES * self.doubles >= self.accuracy

    @property
    def faults(self) -> list[str]:
        """What must not be, in words; empty where all holds. What is no number is a fault."""
        found = []
        if self.remark:
            found.append(self.remark)
        if self.outcome == "finished":
            if not self.truth <= self.accuracy:
                found.append(f"over the request {self.truth / self.accuracy:.3g} times")
            ratio = self.truth / max(self.estimate, LEAST)
            if not (ratio <= 10 or self.truth <= LEAST):
                found.append(f"estimate {ratio:.3g} times too small")
        elif self.outcome != "exception" and not self.amplified:
            found.append(
                f"{self.outcome} without a reason: rounding makes {self.rounding:.1e}, doubles {self.doubles:.1e}"
            )
        if self.smooth_steps and self.steps > 3 * self.smooth_steps:
            found.append(f"{self.steps / self.smooth_steps:.3g} times the steps")
        return found


def judged(
    body: Body,
    requests: Sequence[float] = REQUESTS,
    *,
    smooth: bool = True,
    made: Callable[..., EngineSolution] = run,
    **more: Any,
) -> Iterator[Finding]:
    """Yield what comes of each request for a body, over the whole run; `made` makes a run as `run` does."""
    more = {"max_steps": MOST, **more}
    for accuracy in requests:
        begun, smoothed = time.process_time(), 0
        try:
            found = made(body, accuracy=accuracy, **more)
        except Exception as raised:
            yield Finding(body, accuracy, "exception", remark=f"{type(raised).__name__}: {raised}"[:300])
            continue
        seconds, outcome = time.process_time() - begun, found.outcome
        remark = str(outcome)[:300] if outcome.name == "exception" else ""
        if smooth and outcome.finished:
            smoothed = run(body, "smooth", accuracy=accuracy, **more).statistics.steps
        rows = np.unique(np.linspace(0, len(found.t) - 1, SAMPLES).round().astype(int))
        (truth,), (other,) = (motions([body], by, at=found.t[rows].tolist()) for by in (0.0, ROUNDING))
        if truth.wrong or other.wrong:
            yield Finding(body, accuracy, outcome.name, remark="the oracle did not get to the end")
            continue
        pace = found.engine.scales.pace
        apart, rates = truth_of(truth, found, rows)
        perturbed = apart - truth_of(other, found, rows)[0]
        worst = float(np.maximum(distance(apart, rates, pace).max(), error_of_impacts(truth, found)))
        off = float(distance(perturbed, rates, pace).max())
        if outcome.finished and found.t[-1] != body.duration:
            worst, remark = math.nan, "finished before its end"
        estimate = math.nan if found.error is None else found.error.worst
        doubles = math.nan
        if not outcome.finished:
            doubles = max(_in_doubles(body, found, rows), default=math.nan)
        counts = found.statistics.steps, smoothed
        yield Finding(body, accuracy, outcome.name, worst, estimate, off, *counts, seconds, remark, doubles)


def _in_doubles(body: Body, found: EngineSolution, rows: np.ndarray) -> Iterator[float]:
    """Yield the largest error of each run of the oracle in double precision that ends, at rows of a run of the engine."""
    for k in range(DRAWS):
        pair = [
            motions([body], k * ROUNDING, at=found.t[rows].tolist(), by=program(False, *of))
            for of in ((), ("-DDOUBLE",))
        ]
        if not any(motion.wrong for (motion,) in pair):
            (exact, rates), (rounded, _) = (truth_of(motion, found, rows) for (motion,) in pair)
            yield float(distance(rounded - exact, rates, found.engine.scales.pace).max())


def main() -> None:
    """Judge bodies FIRST to LAST of a seed and print what fails, a line each: `python bodies_on_planes.py FIRST LAST [SEED]`."""
    first, last, *seed = map(int, sys.argv[1:])
    total, failed = 0, 0
    for i in range(first, last):
        for finding in judged(body_of(i, *seed)):
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
