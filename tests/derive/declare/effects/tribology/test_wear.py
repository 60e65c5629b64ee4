"""Wear by Archard's law: closed forms, the volume against a quadrature of its own, and what sectors and acceleration cost."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
import worn
from each import each
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.derive.equations.contact import worn_surfaces
from hertzwerk.derive.program.emit.helpers import HELPERS
from hertzwerk.derive.scenes.slider_crank_line import scene as crank
from hertzwerk.runtime import Solution, equilibrium, load, modes, simulate
from hertzwerk.runtime.engine.solution.step_warnings import SECTORS


@each("name", worn.CHECKS)
def test_the_equations_of_wear_are_what_is_known_of_them(name):
    worn.CHECKS[name](hd.generate(worn.SCENES[name]()))


@pytest.mark.exhaustive
def test_each_number_of_wear_changed_by_one_percent_is_noticed():
    assert not list(worn.survivors())


@pytest.mark.parametrize(("coordinates", "method"), [("tree", "dop853"), ("absolute", "esdirk")])
def test_a_block_loses_a_depth_in_proportion_to_its_way(coordinates, method):
    """Depth k F s/(H A), of a force that is the weight less what the block takes up as it sinks."""
    model = load(worn.sliding(*worn.corner(area=worn.p("area", "mm^2", 4)), coordinates=coordinates))
    run = simulate(model, duration=2.0, tolerance=1e-9, method=method)
    pressed = worn.M * (worn.G * 2.0 + run["down.speed" if coordinates == "tree" else "block.y_speed"][-1])
    assert pressed == pytest.approx(worn.M * worn.G * 2.0, rel=1e-5)
    assert run["wear.depth"][-1] == pytest.approx(1e4 * worn.K * pressed * worn.V / worn.A, rel=1e-9)
    assert run["wear.volume"] == pytest.approx(1e4 * worn.K * run["wear.load_path"], rel=1e-12)
    lost = run["wear.dissipated"][-1] + run["floor.dissipated"][-1]
    assert lost == pytest.approx(worn.M * worn.G * run["wear.depth"][-1], rel=1e-5)
    assert run.energy_residual < 1e-8


def test_a_sphere_wears_flat():
    """A flat 2 pi R h and Hertz's spot pi R d: pi R (h^2 + d h) = k F s/H."""
    slowly = {"duration": 200.0, "parameters": {"repetitions": (1, "1")}}
    run = simulate(load(worn.sliding(*worn.sphere())), tolerance=1e-9, method="esdirk", **slowly)
    d, lost = worn.M * worn.G / 1e6, worn.K * worn.M * worn.G * worn.V * 200
    depth = (np.sqrt(d**2 + 4 * lost / (np.pi * 0.01)) - d) / 2
    assert run["wear.depth"][-1] == pytest.approx(depth, rel=1e-5)
    assert run["wear.volume"][-1] == pytest.approx(lost, rel=1e-5)
    assert run.energy_residual < 1e-8


def test_a_sphere_wears_a_groove():
    """Ten times along a track: R (2 h + d) is a square of the half-width, which integrates to (2 h + d)^1.5 - d^1.5 = 3 k F s/(2 H L sqrt R)."""
    model = load(worn.sliding(*worn.track(8), coordinates="absolute"))
    run = simulate(model, duration=1.0, tolerance=1e-8, method="esdirk", compiled=False)
    lost, d = 1e4 * worn.K * worn.M * worn.G * worn.V, worn.M * worn.G / worn.STIFFNESS
    even = ((1.5 * lost / worn.TRACK / np.sqrt(worn.BUSH) + d**1.5) ** (2 / 3) - d) / 2
    assert depths(run, "track", 8).mean() == pytest.approx(even, rel=3e-3)
    assert depths(run, "track", 8) == pytest.approx(np.full(8, even), rel=0.01)
    assert run["wear.volume"][-1] == pytest.approx(lost, rel=1e-4)
    assert run.energy_residual < 1e-7


def test_a_groove_is_drawn_along_its_track(tmp_path):
    """Of a saved run, whose picture takes a tenth of the time."""
    run = simulate(load(worn.sliding(*worn.track())), duration=0.1, tolerance=1e-6, method="dop853", compiled=False)
    profile, _ = Solution.load(run.save(tmp_path / "run.npz")).plot("wear").axes
    assert len(profile.lines) == 5 and profile.yaxis_inverted()


def test_unworn_spheres_may_begin_where_they_just_touch():
    """With no area yet, and Hertz's force of none: the groove and the flat begin without a division by zero."""
    hertz = hd.laws.power(worn.p("hertz", "N/m^1.5", 1e9), 1.5)
    for spot in (worn.track(), worn.sphere()):
        scene = worn.sliding(*spot[:2], spot[2] + worn.p("sag", "um", worn.M * worn.G)).replace(
            floor=hd.Contact("floor", hertz)
        )
        run = simulate(load(scene), duration=1e-3, tolerance=1e-6, method="dop853", compiled=False)
        assert run.outcome.name == "finished" and run["wear.volume"][-1] > 0


def depths(run, surface, count):
    return np.array([run[f"wear.{surface}_{k}"][-1] for k in range(1, count + 1)])


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_pin_that_turns_wears_evenly(coordinates):
    """Depth k F s/(H 2 pi R L) all around after a whole turn; the bush, which is too hard to wear, has no depth."""
    model = load(worn.journal(worn.RATE, None, coordinates=coordinates))
    run = simulate(model, duration=1.0, tolerance=1e-9, parameters={"repetitions": (100, "1")})
    even = 100 * worn.K * 2 * worn.M * worn.G * worn.SPIN * worn.PIN / (2 * np.pi * worn.PIN * worn.LENGTH)
    assert depths(run, "pin", 16) == pytest.approx(np.full(16, even), rel=1e-3)
    assert depths(run, "pin", 16).mean() == pytest.approx(even, rel=1e-6)
    assert run["wear.volume"] == pytest.approx(100 * worn.K * run["wear.load_path"], rel=1e-12)
    assert not any(name.startswith("wear.bush") for name in run)
    assert run.energy_residual < 1e-8


def test_doubled_sectors_leave_a_quarter_of_the_error():
    """A pin under a load that varies with its angle: the first harmonic of its depth, against a quadrature of force over sliding."""
    errors, t = [], np.linspace(0, 1, 801)
    for count in (8, 16):
        model = load(worn.journal(worn.RATE, None, count, load_ratio=0.5))
        run = simulate(model, duration=1.0, tolerance=1e-8, parameters={"repetitions": (1, "1")}, method="dop853")
        if count == 8:
            dose = run.at(t)["bearing.normal_force"] * worn.SPIN * worn.PIN * np.exp(1j * (1.5 * np.pi - worn.SPIN * t))
            exact = worn.K / (np.pi * worn.PIN * worn.LENGTH) * np.trapezoid(dose, t)
        found = 2 * np.mean(depths(run, "pin", count) * np.exp(2j * np.pi * np.arange(count) / count))
        errors.append(abs(found / exact - 1))
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)
    assert errors[1] == pytest.approx(6 / 16**2, rel=0.02)  # half the variance of the kernel, 12/n^2


def test_sectors_wider_than_the_contact_are_reported():
    """By its half-width in the approach of a pin to the axis of its bush, Johnson (1985), section 5.6; not where they are narrower."""
    model, found = load(worn.journal(None, worn.RATE)), []
    for weight in (2 * worn.M * worn.G, 0.04):
        light = {
            "g": (weight / (2 * worn.M), "m/s^2"), "low": (-worn.CLEARANCE - weight / worn.STIFFNESS, "m"), "repetitions": (1, "1"),
        }  # fmt: skip
        options = {"duration": 0.05, "tolerance": 1e-6, "method": "dop853", "compiled": False}
        found.append(simulate(model, parameters=light, **options).warnings)
    product = worn.BUSH * worn.PIN

    def approach(a):
        return a**2 * worn.CLEARANCE / (4 * product) * (np.log(16 * product / a**2) - 1)

    arc = 2 * brentq(lambda a: approach(a) - 0.04 / worn.STIFFNESS, 1e-6, 5e-3) / worn.BUSH
    none, (warning,) = found
    assert f"{arc:.2g} rad on average, and each of 16 sectors 0.39 rad" in warning
    assert f"sectors={2 ** round(np.log2(10 / arc))}. " in warning
    assert not none


@pytest.mark.parametrize("rule", [SECTORS, 2 * SECTORS, SECTORS / 2])
def test_the_number_of_sectors_that_a_run_advises_is_the_best(rule):
    """A direction that lasts, spread by Hertz's pressure: the rule is within 10 % of the best power of 2, and twice or half of it is not."""
    angles, worst = np.linspace(-np.pi, np.pi, 1024, endpoint=False), 1.0
    for arc in (0.1, 0.14, 0.2, 0.3):
        hertz = np.sqrt(np.clip(1 - (angles / arc) ** 2, 0, None)) * 2 / (np.pi * arc)
        lines = {n: worn.kernel(n, angles) @ worn.kernel(n, 0.0)[0] * n / (2 * np.pi) for n in (8, 16, 32, 64, 128)}
        errors = {n: np.abs(line - hertz).max() for n, line in lines.items()}
        worst = max(worst, errors[2 ** round(np.log2(rule / arc))] / min(errors.values()))
    assert (worst < 1.1) == (rule == SECTORS)


def test_halved_acceleration_leaves_half_of_the_error():
    """Pin and bush after the wear of ten thousand turns, in one turn, in two, and in four."""
    model, hollow = load(worn.journal(worn.RATE, worn.RATE)), []
    for turns in (1, 2, 4):
        accelerated = {"repetitions": (1e4 / turns, "1")}
        options = {"tolerance": 1e-9, "method": "dop853", "compiled": False}
        run = simulate(model, duration=float(turns), parameters=accelerated, **options)
        hollow.append(np.concatenate([depths(run, "pin", 16), depths(run, "bush", 16)]))
    first, second = (np.abs(b - a).max() for a, b in pairwise(hollow))
    assert first / second == pytest.approx(2, rel=0.02)
    assert first < 2e-3 * hollow[-1].max()


@cache
def crank_model():
    return load(worn_crank())


def worn_crank():
    wear = hd.Wear("wear", "slider_pin", worn.RATE, worn.RATE, sectors=16, acceleration=worn.ACCELERATION)
    return replace(crank, effects=(*crank.effects[:-1], wear, crank.effects[-1]), name="worn_crank")


def lost_by_quadrature(run):
    """Volume by Gauss's rule in every step."""
    x, weights = np.polynomial.legendre.leggauss(8)
    begin, h = run.t[:-1], np.diff(run.t)
    history = run.at((begin[:, None] + h[:, None] * (x + 1) / 2).ravel())
    power = np.abs(history["slider_pin.normal_force"] * history["slider_pin.sliding_velocity"]).reshape(len(h), 8)
    return 2 * 1e4 * worn.K * (power @ weights * h / 2).sum()


def check_impacts(model=None, duration="3 ms"):
    """Volume and energy in a run with impacts."""
    run = simulate(model or load(worn_crank()), duration=duration, tolerance=1e-8, method="dop853", compiled=False)
    assert run["wear.volume"] == pytest.approx(2 * 1e4 * worn.K * run["wear.load_path"], rel=1e-11)
    assert run["wear.volume"][-1] == pytest.approx(lost_by_quadrature(run), rel=1e-6)
    assert run.energy_residual < 1e-7
    return run


def test_the_volume_is_force_times_sliding_in_a_run_with_impacts():
    """To rounding by the run's own states, to the tolerance by a quadrature of its histories."""
    run = check_impacts(crank_model(), "12 ms")
    assert depths(run, "bush", 16).max() > 5e-6


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
            assert run.sensitivities()[history, name][-1] == pytest.approx(difference, rel=1e-5)


def test_rest_and_vibrations_in_a_worn_bush():
    """A pin at rest sinks by the depth below it, and swings in the hollow's curvature; depths are given, not solved for."""
    still, hollow = {"spin": (1e-9, "rad/s")}, 1e-6
    at_rest = equilibrium(
        load(worn.journal(None, worn.RATE)), parameters=still, initial={"wear.bush_13": (hollow, "m")}
    )
    less, shares, more = worn.kernel(16, 1.5 * np.pi + np.array([-1e-4, 0, 1e-4]))[:, 12]
    radius = worn.CLEARANCE + 2 * worn.M * worn.G / worn.STIFFNESS + hollow * shares
    assert at_rest["down.travel"][0] == pytest.approx(-radius, rel=1e-9)
    assert at_rest["wear.bush_13"][0] == pytest.approx(hollow, rel=1e-12)
    curvature = 1 / radius - hollow * (less - 2 * shares + more) / 1e-4**2 / radius**2
    swing, bounce = np.sqrt(2 * worn.M * worn.G * curvature / (2 * worn.M + 1)), np.sqrt(worn.STIFFNESS / (2 * worn.M))
    assert [2 * np.pi * mode.natural_frequency for mode in modes(at_rest)] == pytest.approx([swing, bounce], rel=1e-6)


def changed(monkeypatch, kind, name, by):
    """A method or a property of a worn surface that gives what `by` makes of its result."""
    of = getattr(kind, name)
    if callable(of):
        monkeypatch.setattr(kind, name, lambda self, *given: by(self, of(self, *given)))
    else:
        monkeypatch.setattr(kind, name, property(lambda self: by(self, of.func(self))))


def turned_by_half_a_sector(monkeypatch):
    text = HELPERS["_shares"]
    monkeypatch.setitem(HELPERS, "_shares", text.replace("ca.DM(range(n))", "(ca.DM(range(n)) + 1/2)"))


SPOT, CONTOUR = worn_surfaces.WornSpot, worn_surfaces.WornContour
FAULTS = {
    "a groove one per cent too broad": (
        test_a_sphere_wears_a_groove, worn_surfaces.WornTrack, "area", lambda self, area: area * sp.Rational(101, 100),
    ),
    "a spot one per cent too small": (
        test_a_sphere_wears_flat, SPOT, "lost", lambda self, found: ([1.01 * found[0][0]], 1.01 * found[1]),
    ),
    "sectors turned by half of one": (test_doubled_sectors_leave_a_quarter_of_the_error, turned_by_half_a_sector),
    "acceleration to a power of 1.01": (
        test_halved_acceleration_leaves_half_of_the_error, CONTOUR, "lost",
        lambda self, found: ([rate * self.wear.acceleration ** sp.Rational(1, 100) for rate in found[0]], found[1]),
    ),
    "a depth one per cent too small": (test_rest_and_vibrations_in_a_worn_bush, CONTOUR, "depth", lambda self, w: w / 1.01),
    "a slope one per cent too small": (test_rest_and_vibrations_in_a_worn_bush, CONTOUR, "slope", lambda self, s: s / 1.01),
    "depths that lose volume": (
        check_impacts, CONTOUR, "lost",
        lambda self, found: ([0.99 * rate for rate in found[0]], found[1]),
    ),
    "no couple on the pin": (
        check_impacts, CONTOUR, "couple", lambda self, couple: (0, 0, 0),
    ),
    "no energy lost with what is worn off": (
        check_impacts, CONTOUR, "progress",
        lambda self, found: (found[0], sp.S.Zero),
    ),
}  # fmt: skip


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_in_the_wear_is_seen(monkeypatch, fault):
    check, change, *where = FAULTS[fault]
    with monkeypatch.context() as patched, pytest.raises(AssertionError):
        changed(patched, change, *where) if where else change(patched)
        check()


def test_wear_that_fits_no_pair_is_refused():
    """All faults at once: a pair that cannot wear, numbers that are missing or too much, sectors, a film in the gap."""
    (floor, wear), groove = worn.corner(area=worn.p("area", "mm^2", 4)), worn.track()
    for text, scene in {
        "no specific wear rate": lambda: worn.sliding(floor, replace(wear, first=None)),
        "an area for a corner": lambda: worn.sliding(floor, replace(wear, area=None)),
        "along its `track`": lambda: worn.sliding(floor, replace(wear, second=worn.RATE)),
        "belong together": lambda: worn.sliding(groove[0], replace(groove[1], along=None)),
        "inclined to the plane": lambda: worn.sliding(groove[0], replace(groove[1], along=hd.Direction((1, 1, 0)))),
        "leave the track to its side": lambda: hd.generate(worn.sliding(groove[0], replace(groove[1], along=hd.Z))),
        "a power of 2": lambda: worn.journal(worn.RATE, worn.RATE, sectors=12),
        "a quantity in 1/Pa": lambda: hd.generate(
            worn.sliding(floor, replace(wear, first=worn.p("hardness", "Pa", 1e9)))
        ),
    }.items():
        with pytest.raises(hd.InputError, match=text):
            scene()
    rolling = hd.Scene(
        hd.Mechanism("rolls", (hd.Planar("way", hd.GROUND, worn.SHAFT, normal=hd.Z),),
                     pairs=(replace(worn.sphere()[0], sphere=worn.SHAFT.at(0, 0, 0)),)),
        (worn.DOWN, hd.Contact("floor", *worn.LAW), worn.sphere()[1]), worn.SCALES,
    )  # fmt: skip
    with pytest.raises(hd.InputError, match="may turn against the plane"):
        hd.generate(rolling)
