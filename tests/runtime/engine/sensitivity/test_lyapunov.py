"""Lyapunov exponents: closed forms, published digits, sum rules, and the growth of errors that runs show."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.laws import power
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.accuracy.horizon import Growth, growth
from hertzwerk.runtime.engine.sensitivity import lyapunov as lyapunovs
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.loading import engine_model

SIGMA, RHO, BETA = 10, 28, sp.Rational(8, 3)
ATTRACTOR = (0.9056, 0.0, -14.5723)  # 1/s: Sprott, Chaos and Time-Series Analysis (2003), of these numbers


@dataclass(frozen=True)
class Lorenz(hd.JointEffect):
    """Force by a chaotic law of its own, Lorenz, J. Atmos. Sci. 20 (1963) 130, that the motion does not act on."""

    name: str
    joint: str
    push: Any
    pace: Any
    kind = "lorenz"

    def slots(self, scene):
        yield hd.Slot(f"{self.where}, push", self.push, "N")
        yield hd.Slot(f"{self.where}, pace", self.pace, "1/s")

    def states(self, scene):
        yield from (hd.State(name, "1", start=start, size=10) for name, start in (("x", 1), ("y", 1), ("z", 20)))

    def element(self, kin):
        x, y, z = (kin.state(f"{self.name}.{name}") for name in "xyz")
        force = kin.tape.let(self.push * x, f"{self.name}_force")
        rates = {"x": SIGMA * (y - x), "y": x * (RHO - z) - y, "z": x * y - BETA * z}
        return hd.Element(
            kin.on_joint(self.joint, force, self.name),
            input=force * kin.speed(self.joint),
            rates={name: self.pace * rate for name, rate in rates.items()},
        )


def block(*effects, pairs=(), axis=hd.X, **start):
    return hd.Scene(
        hd.Mechanism("block", (hd.Prismatic("slide", hd.GROUND, BLOCK, axis=axis),), pairs), effects=effects, start=hd.Start(**start),
        scales=hd.Scales(length=hd.Parameter("size", "m", 1), speed=hd.Parameter("speed_scale", "m/s", 1)),
    )  # fmt: skip


MASS = hd.Parameter("mass", "kg", 2)
BLOCK = hd.Body("block", MASS)


def means(found):
    return np.array([exponent.mean for exponent in found.exponents])


def test_lorenz_has_its_published_exponents_beside_a_block_that_follows_it():
    """Longer than numbers are large: changes grow beyond e^710."""
    model = engine_model(
        block(Lorenz("attractor", "slide", hd.Parameter("push", "N", 1), hd.Parameter("pace", "1/s", 1)))
    )
    run = simulate(model, duration="900 s", tolerance=1e-8, method="dop853", compiled=False)
    actual = run.lyapunov(5)
    assert actual.growth[-1] > 710
    assert actual.chaotic
    assert actual.dimension == 5
    largest, *still, least = actual.exponents
    assert abs(largest.mean - ATTRACTOR[0]) < largest.half_width < 0.04
    assert max(abs(each.mean) for each in still) < 0.01
    assert least.mean == pytest.approx(ATTRACTOR[2], abs=0.05)
    assert actual.law.rate == pytest.approx(ATTRACTOR[0], abs=0.03)
    assert actual.horizon(1e-6) == pytest.approx(math.log(1e4) / largest.mean, rel=1e-12)
    assert run.lyapunov().exponents[0].mean == pytest.approx(largest.mean, abs=2e-3)


def test_at_a_saddle_they_are_the_eigenvalues_and_an_oscillator_has_no_positive_one():
    model = engine_model("pendulum")
    run = simulate(model, duration="8 s", tolerance=1e-13, initial={"hinge.angle": (math.pi, "rad")}, compiled=False)
    found = run.lyapunov(2)
    settled = found.local[120:].mean(axis=0)
    assert settled == pytest.approx([math.sqrt(9.81), -math.sqrt(9.81)], rel=1e-6)
    # Neighbours of an integrable motion part like its time.
    actual = simulate(engine_model("pendulum"), duration="60 s", tolerance=1e-10, compiled=False).lyapunov(2)
    assert actual.law.kind == "power"
    assert not actual.chaotic
    assert 0.5 < actual.law.exponent < 1.5
    assert actual.horizon(1e-6) == math.inf
    assert sum(means(actual)) == pytest.approx(0, abs=1e-9)


def test_through_impacts_they_add_up_to_the_divergence():
    """Between elastic impacts a linear drag c/m contracts, and nothing else does: in contact neither."""
    drag, gravity = hd.Parameter("drag", "N s/m", 0.2), hd.Parameter("gravity", "m/s^2", 9.81)
    radius = hd.Parameter("radius", "m", 0.1)
    floor = hd.SphereOnPlane("floor", BLOCK.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    model = engine_model(
        block(
            hd.Gravity("gravity", gravity, direction=-hd.Y), hd.Contact("floor", power(hd.Parameter("stiffness", "N/m^1.5", 1e7), n=1.5)),
            hd.JointForce("drag", "slide", -drag * hd.speed_of("slide")), pairs=(floor,), axis=hd.Y,
            position={"slide": hd.Parameter("height", "m", 1)},
        )
    )  # fmt: skip
    run = simulate(model, duration="4 s", tolerance=1e-11, compiled=False)
    assert len(run.impacts) > 3
    last = run.lyapunov(2).local.sum(axis=1)
    assert last.mean() == pytest.approx(-0.1, rel=1e-5)


def test_through_forces_that_jump_changes_grow_as_differences_of_runs():
    model = engine_model("bouncing_ball", laws={"floor": "power(K=1e6 N/m, n=1) x power_damping(chi=200 N s/m, m=0)"})
    how = {"duration": "0.6 s", "tolerance": 1e-12, "compiled": False}
    run = simulate(model, **how)
    assert len(run.impacts) == 1
    scales, d = run.engine.scales.state[:2], 1e-5
    units = {name: model.units[name] for name in ("vertical.travel", "vertical.speed")}

    def end(name, change):
        moved = simulate(model, initial={name: (run[name][0] + change, units[name])}, **how).engine.final
        return np.array([moved[name] for name in units])

    change = np.column_stack([(end(name, d) - end(name, -d)) / (2 * d) for name in units])
    grown = np.linalg.norm(change * scales / scales[:, None]) / math.sqrt(2)
    assert run.lyapunov().growth[-1] == pytest.approx(math.log(grown), abs=1e-5)
    assert run.lyapunov(2).growth[-1] == pytest.approx(math.log(grown), abs=1e-5)
    contracted = run.lyapunov(2).local.sum() * 0.6 / lyapunovs.INTERVALS
    assert contracted == pytest.approx(math.log(np.linalg.det(change)), abs=1e-5)


def test_errors_of_runs_grow_as_they_say():
    """Of two double pendulums 1e-10 apart, until they are 1e-2 apart: within 5 %, as `accuracy` fits both."""
    model, start = engine_model("double_pendulum"), {"shoulder.angle": (2.5, "rad"), "elbow.angle": (2.0, "rad")}
    run = simulate(model, duration="12 s", tolerance=1e-12, initial=start, compiled=False)
    t = np.linspace(0, 12, 400)
    errors = []
    for name in start:
        beside = {**start, name: (start[name][0] + 1e-10, "rad")}
        other = simulate(model, duration="12 s", tolerance=1e-12, initial=beside, compiled=False)
        errors.append(scaling.departure(model, run.engine.scales, other.at(t).part("y"), run.at(t).part("y")))
    seen, reported = growth(t, errors, [np.zeros(len(t))] * 2), run.lyapunov()
    assert seen.kind == reported.law.kind == "exponential"
    assert reported.law.rate == pytest.approx(seen.rate, rel=0.05)


def test_constraints_leave_the_exponents_of_the_motion():
    """In coordinates of every body, with constraints, as in those of the joints."""
    both = []
    for how in ({}, {"coordinates": "absolute"}):
        model = engine_model("double_pendulum", **how)
        run = simulate(model, duration="5 s", tolerance=1e-10, initial={"shoulder.angle": (2.5, "rad")}, compiled=False)
        both.append(run.lyapunov(4))
    tree, absolute = both
    assert tree.dimension == absolute.dimension == 4
    assert len(run.lyapunov(2).exponents) == 2
    assert sum(means(absolute)) == pytest.approx(sum(means(tree)), abs=0.1)
    assert absolute.law.rate == pytest.approx(tree.law.rate, rel=0.3)


def test_ledgers_are_no_part_of_the_motion_and_no_more_exponents_than_it_has():
    assert lyapunovs.depended_on(engine_model("bouncing_ball")).sum() == 2
    run = simulate(engine_model("bouncing_ball"), duration="10 ms", tolerance=1e-6, compiled=False)
    for count in (0, 3, 1.5):
        with pytest.raises(InputError, match="expected 1 to 2"):
            run.lyapunov(count)


def test_the_spread_is_the_least_and_the_largest_rate_of_an_interval():
    """Intervals of 2 s in which changes grow e^4 times and shrink e times; one without growth that is known."""
    law = Growth("exponential", 1.0, 0.1, 1.0, (0.0, 2.0, 4.0, 6.0), (math.exp(4), math.exp(-1), math.nan))
    actual = lyapunovs.Lyapunov((), np.zeros((0, 0)), np.zeros(0), np.zeros(0), law, 1, 6.0, "")
    assert actual.spread == pytest.approx((-0.5, 2.0))
