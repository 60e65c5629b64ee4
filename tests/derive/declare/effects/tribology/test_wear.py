"""Wear by Archard's law: closed forms, the volume against a quadrature of its own, and what sectors and acceleration cost."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.equations.contact import worn_surfaces
from hertzwerk.derive.scenes.slider_crank_line import scene as crank
from hertzwerk.runtime import equilibrium, load, simulate

p = hd.Parameter
K, RATE, ACCELERATION = 1e-14, p("wear_rate", "mm^3/(N m)", 1e-5), p("repetitions", "1", 1e4)
G, M, A, V = 9.81, 2.0, 4e-6, 0.3
BUSH, CLEARANCE, LENGTH, SPIN = 0.01, 1e-4, 0.02, 2 * np.pi
PIN = BUSH - CLEARANCE
SIZE = p("size", "mm", 1)
SCALES = hd.Scales(SIZE, p("pace", "m/s", 1), arm=SIZE)
BLOCK, SHAFT = (
    hd.Body("block", p("mass", "kg", M)),
    hd.Body("shaft", p("shaft_mass", "kg", M), inertia=p("J", "kg m^2", 1e-3)),
)
DOWN = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y)
LAW = hd.laws.power(p("K", "N/m", 1e6), 1), hd.laws.kelvin_voigt(p("restitution", "1", 0.3))


def sliding(pair, wear, lift=0, coordinates="tree"):
    """A block pushed along a plane at a constant speed, under its weight."""
    cart = hd.Body("cart", p("cart_mass", "kg", 1))
    joints = hd.Prismatic("along", hd.GROUND, cart, axis=hd.X), hd.Prismatic("down", cart, BLOCK, axis=hd.Y)
    effects = (
        hd.ConstantSpeed("drive", "along", p("speed", "m/s", V)),
        DOWN,
        hd.Contact(pair.name, *LAW),
        wear,
        hd.EnergyLedger(),
    )
    start = hd.Start(position={"down": lift - p("sag", "um", M * G)})
    return hd.Scene(hd.Mechanism("slides", joints, pairs=(pair,)), effects, SCALES, start, coordinates=coordinates)


def corner(**options):
    pair = hd.CornerOnFace("floor", BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Y)
    return pair, hd.Wear("wear", "floor", RATE, acceleration=ACCELERATION, **options)


def sphere():
    radius = p("radius", "mm", 10)
    pair = hd.SphereOnPlane("floor", BLOCK.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    return pair, hd.Wear("wear", "floor", RATE, acceleration=ACCELERATION), radius


@pytest.mark.parametrize(("coordinates", "method"), [("tree", "dop853"), ("absolute", "esdirk")])
def test_a_block_loses_a_depth_in_proportion_to_its_way(coordinates, method):
    """Depth k F s/(H A), of a force that is the weight less what the block takes up as it sinks."""
    model = load(sliding(*corner(area=p("area", "mm^2", 4)), coordinates=coordinates))
    run = simulate(model, duration=2.0, tolerance=1e-9, method=method)
    pressed = M * (G * 2.0 + run["down.speed" if coordinates == "tree" else "block.y_speed"][-1])
    assert pressed == pytest.approx(M * G * 2.0, rel=1e-5)
    assert run["wear.depth"][-1] == pytest.approx(1e4 * K * pressed * V / A, rel=1e-9)
    assert run["wear.volume"] == pytest.approx(1e4 * K * run["wear.load_path"], rel=1e-12)
    lost = run["wear.dissipated"][-1] + run["floor.dissipated"][-1]
    assert lost == pytest.approx(M * G * run["wear.depth"][-1], rel=1e-5)
    assert run.energy_residual < 1e-8


def test_a_sphere_wears_flat():
    """A flat 2 pi R h and Hertz's spot pi R d: pi R (h^2 + d h) = k F s/H."""
    slowly = {"duration": 200.0, "parameters": {"repetitions": (1, "1")}}
    run = simulate(load(sliding(*sphere())), tolerance=1e-9, method="esdirk", **slowly)
    d, lost = M * G / 1e6, K * M * G * V * 200
    depth = (np.sqrt(d**2 + 4 * lost / (np.pi * 0.01)) - d) / 2
    assert run["wear.depth"][-1] == pytest.approx(depth, rel=1e-5)
    assert run["wear.volume"][-1] == pytest.approx(lost, rel=1e-5)
    assert run.energy_residual < 1e-8


def journal(first, second, sectors=16, coordinates="tree", load_ratio=0):
    """A shaft that turns at a constant speed in a fixed bush, under its weight, and that times a cosine of its angle."""
    hub = hd.Body("hub", p("hub_mass", "kg", 1))
    joints = (
        hd.Prismatic("across", hd.GROUND, hub, axis=hd.X),
        hd.Prismatic("down", hub, BLOCK, axis=hd.Y),
        hd.Revolute("spin", BLOCK, SHAFT, axis=hd.Z),
    )
    pair = hd.PinInBush("bearing", SHAFT.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Z, p("bush_radius", "mm", 10),
                        p("clearance", "mm", 0.1), p("length", "mm", 20))  # fmt: skip
    spin = p("spin", "rad/s", SPIN)
    beat = hd.JointForce("beat", "down", -p("beat", "N", load_ratio * 2 * M * G) * sp.cos(spin * hd.T))
    effects = (
        hd.ConstantSpeed("drive", "spin", spin),
        DOWN,
        hd.Contact("bearing", *LAW),
        hd.Wear("wear", "bearing", first, second, sectors, acceleration=ACCELERATION),
        *([beat] if load_ratio else []),
        hd.EnergyLedger(),
    )
    start = hd.Start(position={"down": p("low", "um", -100 - 2 * M * G * (1 + load_ratio))})
    return hd.Scene(hd.Mechanism("turns", joints, pairs=(pair,)), effects, SCALES, start, coordinates=coordinates)


def kernel(count, angles):
    """Shares of sectors by the sines of Jackson's kernel, (angles, sectors)."""
    half = (np.atleast_1d(angles)[:, None] - 2 * np.pi * np.arange(count) / count) / 2
    values = (np.sinc(count / (2 * np.pi) * half) / np.sinc(half / np.pi)) ** 4
    return values / values.sum(axis=1, keepdims=True)


def depths(run, surface, count):
    return np.array([run[f"wear.{surface}_{k}"][-1] for k in range(1, count + 1)])


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_pin_that_turns_wears_evenly(coordinates):
    """Depth k F s/(H 2 pi R L) all around after a whole turn; the bush, which is too hard to wear, has no depth."""
    model = load(journal(RATE, None, coordinates=coordinates))
    run = simulate(model, duration=1.0, tolerance=1e-9, parameters={"repetitions": (100, "1")})
    even = 100 * K * 2 * M * G * SPIN * PIN / (2 * np.pi * PIN * LENGTH)
    assert depths(run, "pin", 16) == pytest.approx(np.full(16, even), rel=1e-3)
    assert depths(run, "pin", 16).mean() == pytest.approx(even, rel=1e-6)
    assert run["wear.volume"] == pytest.approx(100 * K * run["wear.load_path"], rel=1e-12)
    assert not any(name.startswith("wear.bush") for name in run)
    assert run.energy_residual < 1e-8


def test_a_bush_wears_where_it_is_loaded():
    """Below the shaft, at 270 degrees, by the shares of the kernel; the pin sinks by their mean."""
    run = simulate(load(journal(None, RATE)), duration=1.0, tolerance=1e-9)
    (shares,) = kernel(16, 1.5 * np.pi)
    whole = 1e4 * K * 2 * M * G * SPIN * PIN / (2 * np.pi * BUSH * LENGTH / 16)
    assert depths(run, "bush", 16) == pytest.approx(whole * shares, rel=1e-5, abs=1e-12)
    sunk = run["down.travel"][0] - run["down.travel"][-1]
    assert sunk == pytest.approx(whole * shares @ shares, rel=1e-2)  # beside what damping carries while it sinks


def test_doubled_sectors_leave_a_quarter_of_the_error():
    """A pin under a load that varies with its angle: the first harmonic of its depth, against a quadrature of force over sliding."""
    errors, t = [], np.linspace(0, 1, 801)
    for count in (8, 16):
        model = load(journal(RATE, None, count, load_ratio=0.5))
        run = simulate(model, duration=1.0, tolerance=1e-8, parameters={"repetitions": (1, "1")}, method="dop853")
        if count == 8:
            dose = run.at(t)["bearing.normal_force"] * SPIN * PIN * np.exp(1j * (1.5 * np.pi - SPIN * t))
            exact = K / (np.pi * PIN * LENGTH) * np.trapezoid(dose, t)
        found = 2 * np.mean(depths(run, "pin", count) * np.exp(2j * np.pi * np.arange(count) / count))
        errors.append(abs(found / exact - 1))
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)
    assert errors[1] == pytest.approx(6 / 16**2, rel=0.02)  # half the variance of the kernel, 12/n^2


def test_halved_acceleration_leaves_half_of_the_error():
    """Pin and bush after the wear of ten thousand turns, in one turn, in two, and in four."""
    model, worn = load(journal(RATE, RATE)), []
    for turns in (1, 2, 4):
        accelerated = {"repetitions": (1e4 / turns, "1")}
        run = simulate(model, duration=float(turns), tolerance=1e-9, parameters=accelerated, compiled=False)
        worn.append(np.concatenate([depths(run, "pin", 16), depths(run, "bush", 16)]))
    first, second = (np.abs(b - a).max() for a, b in pairwise(worn))
    assert first / second == pytest.approx(2, rel=0.02)
    assert first < 2e-3 * worn[-1].max()


def worn_crank():
    wear = hd.Wear("wear", "slider_pin", RATE, RATE, sectors=16, acceleration=ACCELERATION)
    return replace(crank, effects=(*crank.effects[:-1], wear, crank.effects[-1]), name="worn_crank")


@cache
def crank_model():
    return load(worn_crank())


@cache
def crank_run(method="dop853"):
    return simulate(crank_model(), duration="12 ms", tolerance=1e-8, method=method, compiled=False)


def lost_by_quadrature(run):
    """Volume by Gauss's rule in every step."""
    x, weights = np.polynomial.legendre.leggauss(8)
    begin, h = run.t[:-1], np.diff(run.t)
    history = run.at((begin[:, None] + h[:, None] * (x + 1) / 2).ravel())
    power = np.abs(history["slider_pin.normal_force"] * history["slider_pin.sliding_velocity"]).reshape(len(h), 8)
    return 2 * 1e4 * K * (power @ weights * h / 2).sum()


def test_the_volume_is_force_times_sliding_in_a_run_with_impacts():
    """To rounding by the run's own states, to the tolerance by a quadrature of its histories."""
    run = crank_run()
    assert run["wear.volume"] == pytest.approx(2 * 1e4 * K * run["wear.load_path"], rel=1e-11)
    assert run["wear.volume"][-1] == pytest.approx(lost_by_quadrature(run), rel=1e-6)
    assert depths(run, "bush", 16).max() > 5e-6
    assert run.energy_residual < 1e-7


def test_derivatives_pass_through_wear():
    """Of a run from a worn bush, against differences."""
    names, start = {"wear_rate": ("mm^3/(N m)", 1e-5, 1e-9), "clearance": ("mm", 0.5, 1e-3)}, {"wear.bush_1": "2 um"}
    options = {"duration": "1 ms", "tolerance": 1e-11, "method": "dop853", "initial": start, "compiled": False}
    run = simulate(crank_model(), sensitivities=tuple(names), **options)
    for name, (unit, value, si) in names.items():
        less, more = (
            simulate(crank_model(), parameters={name: (value * (1 + step), unit)}, **options) for step in (-1e-5, 1e-5)
        )
        for history in ("guide.travel", "wear.volume", "wear.bush_1"):
            difference = (more[history][-1] - less[history][-1]) / (2e-5 * value * si)
            assert run.derivatives[history, name][-1] == pytest.approx(difference, rel=1e-5)


def test_rest_in_a_worn_bush():
    """A pin at rest sinks by the depth below it; depths are given, not solved for."""
    still = {"spin": (1e-9, "rad/s")}
    at_rest = equilibrium(load(journal(None, RATE)), parameters=still, initial={"wear.bush_13": "50 um"})
    (shares,) = kernel(16, 1.5 * np.pi)
    low = CLEARANCE + 2 * M * G / 1e6 + 5e-5 * shares[12]
    assert at_rest["down.travel"][0] == pytest.approx(-low, rel=1e-9)
    assert at_rest["wear.bush_13"][0] == pytest.approx(5e-5, rel=1e-12)


@pytest.mark.parametrize("name", ["lost", "couple", "progress"])
def test_a_fault_in_the_wear_is_seen(monkeypatch, name):
    """Depths 1 % off lose volume; a pin without its couple, or what is worn off without its energy, does not balance."""
    of = getattr(worn_surfaces.WornContour, name)
    faults = {
        "lost": lambda self, label, rate: of(self, label, 1.01 * rate),
        "couple": lambda self, force: of(self, 0),
        "progress": lambda self, force, speed: replace(of(self, force, speed), recession=sp.S.Zero),
    }
    monkeypatch.setattr(worn_surfaces.WornContour, name, faults[name])
    run = simulate(load(worn_crank()), duration="6 ms", tolerance=1e-8, method="dop853", compiled=False)
    if name == "lost":
        assert run["wear.volume"][-1] == pytest.approx(1.01 * 2 * 1e4 * K * run["wear.load_path"][-1], rel=1e-9)
    else:
        assert run.energy_residual > 1e-6


def test_wear_that_fits_no_pair_is_refused():
    """All faults at once: a pair that cannot wear, numbers that are missing or too much, sectors, a film in the gap."""
    floor, wear = corner(area=p("area", "mm^2", 4))
    for text, scene in {
        "no specific wear rate": lambda: sliding(floor, replace(wear, first=None)),
        "an area for a corner": lambda: sliding(floor, replace(wear, area=None)),
        "along a track": lambda: sliding(floor, replace(wear, second=RATE)),
        "a power of 2": lambda: journal(RATE, RATE, sectors=12),
        "a quantity in 1/Pa": lambda: hd.generate(sliding(floor, replace(wear, first=p("hardness", "Pa", 1e9)))),
    }.items():
        with pytest.raises(hd.InputError, match=text):
            scene()
    rolling = hd.Scene(
        hd.Mechanism("rolls", (hd.Planar("way", hd.GROUND, SHAFT, normal=hd.Z),),
                     pairs=(replace(sphere()[0], sphere=SHAFT.at(0, 0, 0)),)),
        (DOWN, hd.Contact("floor", *LAW), sphere()[1]), SCALES,
    )  # fmt: skip
    with pytest.raises(hd.InputError, match="may turn against the plane"):
        hd.generate(rolling)
