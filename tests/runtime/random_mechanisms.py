"""Mechanisms at random, without set-valued friction: chains, trees, loops, balls, cranks with clearance, each with several starts and sizes.

The same for every machine and every run.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

import bodies_on_planes
import numpy as np
import random_cranks

import hertzwerk.derive as hd
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model

SEED = 20261126


@dataclass(frozen=True)
class Draw:
    """Sizes and start of one run of a mechanism, by name with units, and its duration [s]."""

    duration: float
    parameters: dict[str, str] = field(default_factory=dict)
    initial: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Drawn:
    """A mechanism and its runs."""

    name: str
    model: Callable[[], EngineModel]
    draws: list[Draw]


class Dice:
    """Numbers at random, and parameters whose default they are."""

    def __init__(self, *seed: int) -> None:
        self.random = np.random.default_rng(seed)
        self.ranges: dict[str, tuple[float, float, str]] = {}

    def uniform(self, low: float, high: float) -> float:
        return float(self.random.uniform(low, high))

    def spread(self, low: float, high: float) -> float:
        """A number whose logarithm is uniform."""
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def chance(self, share: float) -> bool:
        return bool(self.random.random() < share)

    def one(self, *of: Any) -> Any:
        return of[self.random.integers(len(of))]

    def p(self, name: str, unit: str, low: float, high: float) -> hd.Parameter:
        """A parameter that every draw chooses anew."""
        self.ranges[name] = (low, high, unit)
        return hd.Parameter(name, unit, self.spread(low, high))

    def parameters(self, model: EngineModel) -> dict[str, str]:
        """Values of those parameters that a model has."""
        values = {name: f"{self.spread(low, high)!r} {unit}" for name, (low, high, unit) in self.ranges.items()}
        return {name: value for name, value in values.items() if name in model.parameters}

    def speeds(self, model: EngineModel, turning: float, moving: float) -> dict[str, str]:
        """Start of the speeds of a model [rad/s, m/s], up to these sizes."""
        limits, units = {"rad/s": turning, "m/s": moving}, {name: model.units[name] for name in model.speeds}
        return {name: f"{self.uniform(-limits[unit], limits[unit])!r} {unit}" for name, unit in units.items()}


def mechanisms(kinds: str = "", count: int = 10**6, draws: int = 6, first: int = 0) -> Iterator[Drawn]:
    """Yield mechanisms, of the kinds named (all by default) by turns."""
    chosen = kinds.split() or list(KINDS)
    for i in range(first, first + count):
        kind = chosen[i % len(chosen)]
        yield KINDS[kind](Dice(SEED, i), f"{kind} {i}", draws)


def chain(dice: Dice, name: str, draws: int) -> Drawn:
    """Links on journals, universal and ball joints and guides, with friction under their reactions, dampers and springs."""
    plane, n = dice.chance(0.5), int(dice.random.integers(1, 4))
    joints: list[Any] = []
    effects: list[Any] = []
    parent: Any = hd.GROUND
    for i in range(n):
        length, mass = dice.p(f"l{i}", "m", 0.2, 1), dice.p(f"m{i}", "kg", 0.3, 3)
        share = dice.p(f"share{i}", "1", 0.08, 0.2)
        inertia = share * mass * length**2
        body = hd.Body(
            f"link{i}", mass, inertia if plane else (inertia, 0.3 * inertia, 1.1 * inertia), (0, -length / 2, 0)
        )
        kind = "P" if i == 0 and dice.chance(0.15) else "R" if plane else dice.one("R", "R", "U", "S")
        joint = f"joint{i}"
        if kind == "P":
            joints.append(hd.Prismatic(joint, parent, body, axis=hd.X))
            effects.append(hd.JointSpring(f"spring{i}", joint, dice.p(f"k{i}", "N/m", 20, 500)))
        elif kind == "R":
            axis = hd.Z if plane else dice.one(hd.Z, hd.X, hd.Direction((1, 0, 2)), hd.Direction((3, 1, 0)))
            joints.append(hd.Revolute(joint, parent, body, axis))
        elif kind == "U":
            joints.append(hd.Universal(joint, parent, body, hd.X, hd.Z))
        else:
            joints.append(hd.Spherical(joint, parent, body))
        if kind == "R" and dice.chance(0.6):
            effects.append(
                hd.JointFriction(f"rub{i}", joint, smooth(dice, f"_{i}"), radius=dice.p(f"r{i}", "m", 0.005, 0.05))
            )
        elif kind == "S" and dice.chance(0.5):
            effects.append(
                hd.BallFriction(f"rub{i}", joint, smooth(dice, f"_{i}"), radius=dice.p(f"r{i}", "m", 0.005, 0.05))
            )
        elif kind == "R" and dice.chance(0.4):
            effects.append(hd.JointDamper(f"damper{i}", joint, dice.p(f"c{i}", "N m s/rad", 0.01, 1)))
        if kind == "R" and dice.chance(0.2):
            effects.append(hd.JointSpring(f"coil{i}", joint, dice.p(f"kt{i}", "N m/rad", 1, 50)))
        parent = body.at(0, -length, 0)
    effects += [hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger()]
    arm = hd.Parameter("arm", "m", 0.5)
    made = engine_model(
        hd.Scene(
            hd.Mechanism("chain", tuple(joints)), tuple(effects), hd.Scales(arm, hd.Parameter("pace", "m/s", 2), arm)
        )
    )
    found = []
    for _ in range(draws):
        angles = {q: f"{dice.uniform(-1.5, 1.5)!r} rad" for q in made.coordinates if made.units[q] == "rad"}
        found.append(Draw(dice.uniform(0.2, 1.6), dice.parameters(made), angles | dice.speeds(made, 4, 1)))
    return Drawn(name, lambda: made, found)


def smooth(dice: Dice, tag: str, *more: str) -> Any:
    """A smooth law of friction, in proportion to the normal force; of contacts more are."""
    which, p = dice.one("smooth_coulomb", "stribeck", *more), dice.p
    mu, v = p(f"mu{tag}", "1", 0.05, 0.5), p(f"v_s{tag}", "m/s", 1e-3, 0.1)
    if which == "smooth_coulomb":
        return hd.laws.smooth_coulomb(mu, v)
    viscous, falling = p(f"c_v{tag}", "N s/m", 1e-3, 0.1), p(f"v_S{tag}", "m/s", 0.01, 0.2)
    if which == "stribeck":
        return hd.laws.stribeck(mu, 1.3 * mu, falling, v, viscous)
    return hd.laws.brown_mcphee(mu, 1.3 * mu, falling, viscous, p(f"N_t{tag}", "N", 1, 10))


def crank(dice: Dice, name: str, draws: int) -> Drawn:
    """The slider-crank with clearance, over wide ranges, with smooth friction."""
    damping = dice.one(*random_cranks.DAMPING)
    several = (
        each
        for each in random_cranks.cranks(10**6, int(dice.random.integers(2**31)))
        if each.friction == "smooth_coulomb" and each.damping == damping
    )
    found = [
        Draw(
            dice.uniform(0.001, 0.012), {k: f"{v} 1" if isinstance(v, float) else v for k, v in each.parameters.items()}
        )
        for each in islice(several, draws)
    ]
    return Drawn(name, lambda: random_cranks.model(damping, "smooth_coulomb"), found)


def thrown(dice: Dice, name: str, draws: int) -> Drawn:
    """A body on a tilted plane, by any damping law, with smooth friction."""
    first = bodies_on_planes.body_of(int(dice.random.integers(10**6)))
    found: list[Draw] = []
    made = bodies_on_planes.model(first.plane, first.damping, first.exponent, "smooth")
    units = {name: port.unit for name, port in made.parameters.items()} | made.units
    while len(found) < draws:
        body = bodies_on_planes.body_of(int(dice.random.integers(10**6)))
        if (body.plane, body.damping, body.exponent) != (first.plane, first.damping, first.exponent):
            continue
        given = bodies_on_planes.given(body)
        del given["parameters"]["mu_s"]
        given["parameters"]["rub_speed"] = dice.spread(1e-3, 0.1)
        text = {part: {key: f"{value!r} {units[key]}" for key, value in of.items()} for part, of in given.items()}
        found.append(Draw(dice.uniform(0.1, body.duration), text["parameters"], text["initial"]))
    return Drawn(name, lambda: made, found)


def balls(dice: Dice, name: str, draws: int) -> Drawn:
    """Balls in the plane between a floor and two walls, that meet each other."""
    n = int(dice.random.integers(1, 4))
    radius, width = hd.Parameter("radius", "m", 0.05), hd.Parameter("width", "m", 0.4)
    bodies = [
        hd.Body(f"ball{i}", dice.p(f"m{i}", "kg", 0.1, 1), hd.Parameter(f"J{i}", "kg m^2", 4e-4)) for i in range(n)
    ]
    joints = tuple(hd.Planar(f"flight{i}", hd.GROUND, body) for i, body in enumerate(bodies))
    exponent = dice.one(1, 1.5, 2)
    unit = {1: "N/m", 1.5: "N/m^1.5", 2: "N/m^2"}[exponent]
    high = {1: (2e3, 2e5), 1.5: (2e4, 1e7), 2: (2e5, 1e8)}[exponent]
    stiffness, e = dice.p("stiffness", unit, *high), dice.p("restitution", "1", 0.35, 1)
    damping = dice.one(
        "hunt_crossley", "flores", "lankarani_nikravesh", "gonthier", "hu_guo", "exact", "tsuji", "kelvin_voigt"
    )
    sides = {"floor": (0, hd.Y), "left": (-width / 2, hd.X), "right": (width / 2, -hd.X)}
    pairs: list[Any] = list(hd.every_pair("meet", bodies, radius)) if n > 1 else []
    for side, (x, normal) in sides.items():
        pairs += [
            hd.SphereOnPlane(f"{side}{i}", body.at(0, 0, 0), radius, hd.GROUND.at(x, 0, 0), normal)
            for i, body in enumerate(bodies)
        ]
    names = sorted({pair.part_of or pair.name for pair in pairs})
    effects: list[Any] = [
        hd.Contact(each, hd.laws.power(stiffness, exponent), getattr(hd.laws, damping)(e)) for each in names
    ]
    if dice.chance(0.6):
        law = smooth(dice, "", "brown_mcphee")
        effects += [hd.Friction(f"rub_{each}", each, law) for each in names]
    effects += [hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger()]
    scales = hd.Scales(hd.Parameter("depth", "m", 1e-3), hd.Parameter("pace", "m/s", 2), radius)
    made = engine_model(hd.Scene(hd.Mechanism("balls", joints, tuple(pairs)), tuple(effects), scales))
    found = []
    for _ in range(draws):
        start = {}
        for i in range(n):
            start[f"flight{i}.x"] = f"{dice.uniform(-0.08, 0.08)!r} m"
            start[f"flight{i}.y"] = f"{0.06 + 0.11 * i + dice.uniform(0, 0.008)!r} m"
        found.append(Draw(dice.uniform(0.05, 0.25), dice.parameters(made), start | dice.speeds(made, 20, 2)))
    return Drawn(name, lambda: made, found)


def loop(dice: Dice, name: str, draws: int) -> Drawn:
    """A four-bar linkage of random lengths, let go or driven, with friction or dampers in its joints."""
    p, driven = dice.p, dice.chance(0.3)
    a, b = p("crank", "m", 0.1, 0.2), p("coupler", "m", 0.4, 0.5)
    c, d = p("rocker", "m", 0.4, 0.5), p("base", "m", 0.4, 0.5)  # a + 0.5 < 0.8: the crank turns round
    bodies = [
        hd.Body(f"bar{i}", p(f"m{i}", "kg", 0.3, 3), p(f"J{i}", "kg m^2", 0.005, 0.05), centre=(length / 2, 0, 0))
        for i, length in enumerate((a, b, c))
    ]
    joints = (
        hd.Revolute("main", hd.GROUND, bodies[0], hd.Z), hd.Revolute("left", bodies[0].at(a, 0, 0), bodies[1], hd.Z),
        hd.Revolute("foot", hd.GROUND.at(d, 0, 0), bodies[2], hd.Z), hd.Revolute("right", bodies[1].at(b, 0, 0), bodies[2].at(c, 0, 0), hd.Z),
    )  # fmt: skip
    effects: list[Any] = [hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger()]
    if driven:
        effects.append(hd.ConstantSpeed("drive", "main", p("w", "rad/s", 1, 30)))
    for joint in ("left", "foot"):
        if dice.chance(0.5):
            effects.append(
                hd.JointFriction(
                    f"rub_{joint}", joint, smooth(dice, f"_{joint}"), radius=p(f"r_{joint}", "m", 0.005, 0.02)
                )
            )
        elif dice.chance(0.5):
            effects.append(hd.JointDamper(f"damper_{joint}", joint, p(f"c_{joint}", "N m s/rad", 0.01, 0.3)))
    scales = hd.Scales(hd.Parameter("size", "m", 0.2), hd.Parameter("pace", "m/s", 1), hd.Parameter("arm", "m", 0.2))
    coordinates = dice.one("tree", "tree", "absolute")
    angle, speed = p("lift", "rad", 0.1, 6), p("turning", "rad/s", 0.1, 8)
    start = hd.Start(
        {} if driven else {"main": angle}, {} if driven else {"main": speed}, near={"left": 0.5, "foot": 1.5}
    )
    made = engine_model(hd.Scene(hd.Mechanism("loop", joints), tuple(effects), scales, start, coordinates=coordinates))
    return Drawn(name, lambda: made, [Draw(dice.uniform(0.2, 1.2), dice.parameters(made)) for _ in range(draws)])


def tree(dice: Dice, name: str, draws: int) -> Drawn:
    """Bodies on joints of all kinds in space, some driven, on axes that lie askew."""
    joints: list[Any] = []
    effects: list[Any] = []
    places: list[Any] = [hd.GROUND.at(0, 0, 0)]
    n = int(dice.random.integers(1, 4))
    for i in range(n):
        a, mass = dice.p(f"a{i}", "m", 0.1, 0.6), dice.p(f"m{i}", "kg", 0.3, 3)
        J = dice.p(f"J{i}", "kg m^2", 0.01, 0.1)
        body = hd.Body(f"body{i}", mass, (J, 1.2 * J, 0.9 * J), (0, 0.1 * a, -a / 2))
        place, joint = dice.one(*places), f"joint{i}"
        axis = dice.one(hd.X, hd.Y, hd.Z, hd.Direction((1, 2, -1)), hd.Direction((0, 1, 1)))
        kind = dice.one("R", "R", "P", "U", "S")
        joints.append(
            hd.Revolute(joint, place, body, axis)
            if kind == "R"
            else hd.Prismatic(joint, place, body, axis)
            if kind == "P"
            else hd.Universal(joint, place, body, hd.X, hd.Y)
            if kind == "U"
            else hd.Spherical(joint, place, body)
        )
        if kind == "P":
            effects.append(hd.JointSpring(f"spring{i}", joint, dice.p(f"k{i}", "N/m", 20, 500)))
        elif kind == "R" and i < n - 1 and dice.chance(0.25):
            effects.append(hd.ConstantSpeed(f"drive{i}", joint, dice.p(f"w{i}", "rad/s", 1, 10)))
        elif kind == "R" and dice.chance(0.4):
            effects.append(
                hd.JointFriction(f"rub{i}", joint, smooth(dice, f"_{i}"), radius=dice.p(f"r{i}", "m", 0.005, 0.05))
            )
        places.append(body.at(a / 3, 0, -a))
    effects += [
        hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), hd.Direction((1, -3, -9))),
        hd.EnergyLedger(),
    ]
    size = hd.Parameter("size", "m", 0.5)
    made = engine_model(
        hd.Scene(
            hd.Mechanism("tree", tuple(joints)), tuple(effects), hd.Scales(size, hd.Parameter("pace", "m/s", 2), size)
        )
    )
    found = []
    for _ in range(draws):
        angles = {q: f"{dice.uniform(-1.5, 1.5)!r} rad" for q in made.coordinates if made.units[q] == "rad"}
        found.append(Draw(dice.uniform(0.1, 1), dice.parameters(made), angles | dice.speeds(made, 5, 1)))
    return Drawn(name, lambda: made, found)


KINDS: dict[str, Callable[[Dice, str, int], Drawn]] = {
    "chain": chain, "crank": crank, "thrown": thrown, "balls": balls, "loop": loop, "tree": tree,
}  # fmt: skip
