"""Scenes that wear, and what is known of their equations: a potential and Archard's law, typed again with NumPy.

`python tests/derive/laws/formulas/mutate_laws.py wear` changes each number in the source of wear by 1 %, and asks that one of these
checks notices.
"""

from __future__ import annotations

import ast
import inspect
import sys
import types
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import sympy as sp
from derived import Derived, rate_along
from numpy.testing import assert_allclose

import hertzwerk.derive as hd
from hertzwerk.derive.equations.contact import touch, worn_surfaces
from hertzwerk.derive.program.emit.sector_helpers import SECTOR_HELPERS

p = hd.Parameter
K, RATE, ACCELERATION = 1e-14, p("wear_rate", "mm^3/(N m)", 1e-5), p("repetitions", "1", 1e4)
G, M, A, V = 9.81, 2.0, 4e-6, 0.3
BUSH, CLEARANCE, LENGTH, SPIN, STIFFNESS = 0.01, 1e-4, 0.02, 2 * np.pi, 1e6
PIN, COUNT, TRACK = BUSH - CLEARANCE, 8, 0.03
SIZE = p("size", "mm", 1)
SCALES = hd.Scales(SIZE, p("pace", "m/s", 1), arm=SIZE)
BLOCK, SHAFT = (
    hd.Body("block", p("mass", "kg", M)),
    hd.Body("shaft", p("shaft_mass", "kg", M), inertia=p("J", "kg m^2", 1e-3)),
)
DOWN = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y)
ELASTIC = hd.laws.power(p("K", "N/m", STIFFNESS), 1)
LAW = ELASTIC, hd.laws.kelvin_voigt(p("restitution", "1", 0.3))


def sliding(pair, wear, lift=0, coordinates="tree"):
    """A block pushed along a plane at a constant speed, under its weight."""
    cart = hd.Body("cart", p("cart_mass", "kg", 1))
    joints = hd.Prismatic("along", hd.GROUND, cart, axis=hd.X), hd.Prismatic("down", cart, BLOCK, axis=hd.Y)
    effects = (
        hd.ConstantSpeed("drive", "along", p("speed", "m/s", V)), DOWN, hd.Contact(pair.name, *LAW), wear, hd.EnergyLedger(),
    )  # fmt: skip
    start = hd.Start(position={"down": lift - p("sag", "um", M * G)})
    return hd.Scene(hd.Mechanism("slides", joints, pairs=(pair,)), effects, SCALES, start, coordinates=coordinates)


def corner(**options):
    pair = hd.CornerOnFace("floor", BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Y)
    return pair, hd.Wear("wear", "floor", RATE, acceleration=ACCELERATION, **options)


def sphere():
    radius = p("radius", "mm", 10)
    pair = hd.SphereOnPlane("floor", BLOCK.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    return pair, hd.Wear("wear", "floor", RATE, acceleration=ACCELERATION), radius


def track(sectors=COUNT):
    """The plane below that sphere wears, along a track of 30 mm."""
    pair, wear, radius = sphere()
    length = p("track", "mm", 30)
    return pair, replace(wear, first=None, second=RATE, sectors=sectors, track=length, along=hd.X), radius


def rolling(pair, wear):
    """A shaft that moves in a plane as it likes, and touches another with a sphere."""
    joint = hd.Planar("way", hd.GROUND, SHAFT, normal=hd.Z)
    effects = DOWN, hd.Contact(pair.name, *LAW), wear, hd.EnergyLedger()
    return hd.Scene(hd.Mechanism("rolls", (joint,), pairs=(replace(pair, sphere=SHAFT.at(0, 0, 0)),)), effects, SCALES)


def journal(first, second, sectors=16, coordinates="tree", load_ratio=0):
    """A shaft that turns at a constant speed in a fixed bush, under its weight, and that times a cosine of its angle."""
    hub = hd.Body("hub", p("hub_mass", "kg", 1))
    joints = (
        hd.Prismatic("across", hd.GROUND, hub, axis=hd.X), hd.Prismatic("down", hub, BLOCK, axis=hd.Y), hd.Revolute("spin", BLOCK, SHAFT, axis=hd.Z),
    )  # fmt: skip
    pair = hd.PinInBush("bearing", SHAFT.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Z, p("bush_radius", "mm", 10),
                        p("clearance", "mm", 0.1), p("length", "mm", 20))  # fmt: skip
    spin = p("spin", "rad/s", SPIN)
    beat = hd.JointForce("beat", "down", -p("beat", "N", load_ratio * 2 * M * G) * sp.cos(spin * hd.T))
    effects = (
        hd.ConstantSpeed("drive", "spin", spin), DOWN, hd.Contact("bearing", *LAW),
        hd.Wear("wear", "bearing", first, second, sectors, acceleration=ACCELERATION), *([beat] if load_ratio else []), hd.EnergyLedger(),
    )  # fmt: skip
    start = hd.Start(position={"down": p("low", "um", -100 - 2 * M * G * (1 + load_ratio))})
    return hd.Scene(hd.Mechanism("turns", joints, pairs=(pair,)), effects, SCALES, start, coordinates=coordinates)


def kernel(count, angles):
    """Shares of sectors by the sines of Jackson's kernel, (angles, sectors)."""
    half = (np.atleast_1d(angles)[:, None] - 2 * np.pi * np.arange(count) / count) / 2
    values = (np.sinc(count / (2 * np.pi) * half) / np.sinc(half / np.pi)) ** 4
    return values / values.sum(axis=1, keepdims=True)


def elastic(pair):
    """The law without damping."""
    return {pair: hd.Contact(pair, ELASTIC)}


SPOTS = {"sphere": sphere()[:2], "corner": corner(area=p("area", "mm^2", 4))}
SCENES = {
    "journal": lambda: journal(RATE, RATE, COUNT).replace(**elastic("bearing")),
    "track": lambda: rolling(*track()[:2]).replace(**elastic("floor")),
    **{name: lambda spot=spot: sliding(*spot).replace(**elastic("floor")) for name, spot in SPOTS.items()},
}


class Worn:
    """Penetration of a worn journal by place of the shaft's centre, its angle, depths of pin and bush."""

    def __init__(self, pin, bush):
        self.pin, self.bush = pin, bush

    def depth(self, x, y, angle):
        (of_pin,), (of_bush,) = kernel(COUNT, np.arctan2(y, x) - angle), kernel(COUNT, np.arctan2(y, x))
        return of_pin @ self.pin + of_bush @ self.bush

    def penetration(self, x, y, angle):
        return np.hypot(x, y) - CLEARANCE - self.depth(x, y, angle)

    def slopes(self, x, y, angle):
        """Of the penetration by x, y [1] and by the angle [m]: differences of fourth order."""
        at, steps = np.array([x, y, angle]), np.diag([1e-6 * CLEARANCE, 1e-6 * CLEARANCE, 1e-4])
        first, second = (
            np.array([self.penetration(*(at + k * h)) - self.penetration(*(at - k * h)) for h in steps]) for k in (1, 2)
        )
        return (8 * first - second) / (12 * steps.sum(axis=0))


def check_journal(text):
    """Forces by a potential, Archard's law by sectors, the gap whose depth fades towards the centre, and its rates."""
    derived, rng = Derived(text=text), np.random.default_rng(4)
    zero = {"t": 0.0, "u": np.zeros(2), "z": np.zeros(derived.nq), "m": np.zeros(1)}
    for ratio in (0.1, 0.35, 0.6, 0.9, 1.3, 1.3):  # eccentricity over clearance
        t, direction, u = rng.uniform(0, 1), rng.uniform(-np.pi, np.pi), rng.uniform(-1, 1, 2)
        x, y = ratio * CLEARANCE * np.array([np.cos(direction), np.sin(direction)])
        pin, bush = rng.uniform(0, 2e-5, (2, COUNT))
        q, surface = np.array([x, y, *pin, *bush, 0.0]), Worn(pin, bush)
        given = zero | {"t": t, "q": q, "u": u}
        volume = 2 * np.pi * LENGTH / COUNT * (PIN * pin.sum() + BUSH * bush.sum())
        assert_allclose(derived.call("outputs", **given)[-1], volume, rtol=1e-12)

        share = np.clip((ratio**2 - 1 / 16) / (1 / 2 - 1 / 16), 0, 1)
        reach = CLEARANCE + share**3 * (10 - 15 * share + 6 * share**2) * surface.depth(x, y, SPIN * t)
        gap, rate = derived.call("gaps", **given)
        assert_allclose(gap, (reach**2 - x**2 - y**2) / (2 * reach), rtol=1e-10)
        a = rng.uniform(-1, 1, 2)
        moving = {"t": t, "q": q, "u": u, "a": a}
        assert_allclose(rate, rate_along(derived, "gaps", 0, **moving), rtol=1e-9, atol=1e-15)
        second = derived.call("gap_accelerations", t=t, q=q, u=u, a=a)
        assert_allclose(second, rate_along(derived, "gaps", 1, **moving), rtol=1e-9, atol=1e-12)

        depth = surface.penetration(x, y, SPIN * t)
        if depth <= 0:
            continue
        forces, powers, normal, *_ = derived.call("contact_bearing", **given)
        slopes = surface.slopes(x, y, SPIN * t)
        push = STIFFNESS * depth * slopes
        assert_allclose(forces[:3], -push, rtol=1e-5, atol=1e-5 * np.abs(push[:2]).max() * BUSH)
        load = np.hypot(*push[:2])
        assert_allclose(normal, load, rtol=1e-6)
        tangent = np.array([slopes[1], -slopes[0]]) / np.hypot(*slopes[:2])
        power = load * abs(u @ tangent - SPIN * PIN)
        assert_allclose(forces[-1], power, rtol=1e-6)
        of_pin, of_bush = kernel(COUNT, direction - SPIN * t)[0], kernel(COUNT, direction)[0]
        lost = 1e4 * K * power / (2 * np.pi * LENGTH / COUNT)
        rates = lost * np.concatenate([of_pin / PIN, of_bush / BUSH])
        assert_allclose(forces[3:-1], rates, rtol=1e-6, atol=1e-9 * rates.max())
        assert_allclose(powers[-1], STIFFNESS * depth * np.concatenate([of_pin, of_bush]) @ rates, rtol=1e-6)


def check_track(text):
    """The same of a plane's track, which lies under a sphere that rolls and slides, and repeats beyond its ends."""
    derived, rng = Derived(text=text), np.random.default_rng(5)
    for deep in (-1e-5, 1e-6, 2e-5):
        x, angle, u, a = (
            rng.uniform(-2 * TRACK, 2 * TRACK), rng.uniform(0, 6), rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3),
        )  # fmt: skip
        worn = rng.uniform(0, 2e-5, COUNT)
        less, depth, more = kernel(COUNT, 2 * np.pi / TRACK * (x + np.array([-1e-6, 0, 1e-6]))) @ worn
        slope, load = (more - less) / 2e-6, STIFFNESS * deep
        q = np.array([x, BUSH - depth - deep, angle, *worn, 5e6])
        given = {"t": 0.0, "q": q, "u": u, "z": np.zeros(3), "m": np.zeros(1)}
        gap, rate = derived.call("gaps", **given)
        assert_allclose(gap, -deep, rtol=1e-9)
        assert_allclose(rate, rate_along(derived, "gaps", 0, t=0.0, q=q, u=u, a=a), rtol=1e-9)
        second = derived.call("gap_accelerations", t=0.0, q=q, u=u, a=a)
        assert_allclose(second, rate_along(derived, "gaps", 1, t=0.0, q=q, u=u, a=a), rtol=1e-9)
        assert_allclose(derived.call("outputs", **given)[-1], 1e4 * K * 5e6, rtol=1e-9)
        if deep < 0:
            continue
        forces, powers, normal, *_ = derived.call("contact_floor", **given)
        assert_allclose(forces[:3], [load * slope, load, 0], rtol=1e-6, atol=1e-9 * load)
        assert_allclose(normal, load * np.hypot(1, slope), rtol=1e-9)
        power = normal * abs((u[0] - slope * u[1]) / np.hypot(1, slope) + BUSH * u[2])
        assert_allclose(forces[-1], power, rtol=1e-8)
        (shares,) = kernel(COUNT, 2 * np.pi / TRACK * x)
        rates = 1e4 * K * power * shares / (2 * np.sqrt(BUSH * (deep + 2 * depth)) * TRACK / COUNT)
        assert_allclose(forces[3:-1], rates, rtol=1e-8)
        assert_allclose(powers[-1], load * shares @ rates, rtol=1e-8)


def check_spot(text, name):
    """Archard's law over a flat of the sphere, or over the area of the corner."""
    derived, deep, worn, path = Derived(text=text), 2e-5, 3e-6, 5e6
    radius = 1e-2 if name == "sphere" else 0.0
    q = np.array([radius - worn - deep, worn, path])
    given = {"t": 0.0, "q": q, "u": np.zeros(1), "z": np.zeros(3), "m": np.zeros(1)}
    forces, powers, *_ = derived.call("contact_floor", **given)
    area = np.pi * radius * (2 * worn + deep) if radius else A
    power, rate = STIFFNESS * deep * V, 1e4 * K * STIFFNESS * deep * V / area
    assert_allclose(forces, [STIFFNESS * deep, 0, rate, power], rtol=1e-9)
    assert_allclose(powers[-1], STIFFNESS * deep * rate, rtol=1e-9)
    assert_allclose(derived.call("outputs", **given)[-1], 1e4 * K * path if radius else A * worn, rtol=1e-9)


CHECKS = {
    "journal": check_journal, "track": check_track, **{name: lambda text, name=name: check_spot(text, name) for name in ("sphere", "corner")},
}  # fmt: skip


def numbers(source: str) -> Iterator[tuple[str, str]]:
    """Line and changed source for each number in it, 1 % larger where it stands."""
    places = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Constant)]
    for k, place in enumerate(places):
        if isinstance(place.value, (int, float)) and not isinstance(place.value, bool) and place.value:
            tree = ast.parse(source)
            node = [node for node in ast.walk(tree) if isinstance(node, ast.Constant)][k]
            node.value *= 1.01
            yield f"{place.value} of {source.splitlines()[place.lineno - 1].strip()}", ast.unparse(tree)


def mutants() -> Iterator[tuple[str, dict[str, str]]]:
    """Each number of wear, and the generated modules with that changed; none where the derivation refuses it."""
    for where, source in numbers(inspect.getsource(worn_surfaces)):
        try:
            yield where, _derived_from(source)
        except (TypeError, ValueError):
            yield where, {}
    before = SECTOR_HELPERS["_shares"]
    text = hd.generate(SCENES["journal"]())
    for where, source in numbers(before):
        yield where, {"journal": text.replace(before, source)}


def _derived_from(source):
    module = sys.modules["worn_surfaces_changed"] = types.ModuleType("worn_surfaces_changed")  # where data classes look
    exec(compile(source, "<changed>", "exec"), module.__dict__)
    before, touch.worn_at = touch.worn_at, module.worn_at
    try:
        return {name: hd.generate(scene()) for name, scene in SCENES.items()}
    finally:
        touch.worn_at = before


def survivors() -> Iterator[str]:
    """Numbers whose change no check notices, but for the bound of a loop through halves, which are whole."""
    for where, modules in mutants():
        if (
            modules
            and where != "1 of while half > 1:"
            and not any(_fails(CHECKS[name], text) for name, text in modules.items())
        ):
            yield where


def _fails(check, text):
    try:
        check(text)
    except (AssertionError, TypeError, ValueError, RuntimeError, NotImplementedError):
        return True
    return False
