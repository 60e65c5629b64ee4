"""Hydrodynamic lubrication: the film in the generated module against a quadrature of Reynolds' equation and against published closed forms.

The oracle starts from the textbook's equation, d/ds(h^3 dp/ds) + d/dz(h^3 dp/dz) = 6 eta (U_1 + U_2) dh/ds + 12 eta dh/dt with both surfaces turning;
the derivation starts from the velocity midway between the centres. Neither sees the other's algebra.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from derived import Derived
from film import ETA, LENGTH, PIN, C, by_quadrature

import hertzwerk.derive as hd
from hertzwerk.derive.audit.audit import InconsistentUnits
from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.laws import LAWS, flores, long_bearing, power, short_bearing

LAYER = 2e-6  # m

pin, bush = (
    hd.Body("pin", hd.Parameter("pin_mass", "kg", 0.7), hd.Parameter("pin_inertia", "kg m^2", 3e-4)),
    hd.Body("bush", hd.Parameter("bush_mass", "kg", 1.1), hd.Parameter("bush_inertia", "kg m^2", 5e-4)),
)
viscosity, layer = hd.Parameter("viscosity", "Pa s", ETA), hd.Parameter("layer", "um", LAYER * 1e6)
clearance, radius = hd.Parameter("clearance", "um", C * 1e6), hd.Parameter("bush_radius", "mm", (PIN + C) * 1e3)
LONG = hd.Parameter("length", "mm", LENGTH * 1e3)
JOINT = hd.PinInBush("joint", pin.at(0, 0, 0), bush.at(0, 0, 0), hd.Z, radius, clearance, length=LONG)
BOTH_FREE = (hd.Planar("of_pin", hd.GROUND, pin), hd.Planar("of_bush", hd.GROUND, bush))
TOUCHING = hd.Contact(
    "joint", power(hd.Parameter("stiffness", "N/m^1.5", 1e9), 1.5), flores(hd.Parameter("restitution", "1", 0.6))
)


def film(law=short_bearing, *, thin=layer, name="oil"):
    return hd.Lubrication(name, "joint", law(viscosity), thin)


def scene(*effects, pair=JOINT):
    """Pin and bush, both free in the plane."""
    scales = hd.Scales(length=clearance, speed=hd.Parameter("pace", "m/s", 1), arm=radius)
    return hd.Scene(hd.Mechanism("oiled", BOTH_FREE, (pair,)), effects, scales)


@cache
def derived(law):
    return Derived(scene(film(LAWS[law]), TOUCHING, hd.EnergyLedger()))


def state(e, rate, spin_pin=0.0, spin_bush=0.0, *, away=0.0):
    """Coordinates and speeds where the pin is at e in the bush and moves at `rate` against it, the bush `away` and on its way."""
    q = np.array([3 * away + e[0], -2 * away + e[1], 0.4, 3 * away, -2 * away, 1.1])
    return q, np.array([7 * away + rate[0], -9 * away + rate[1], spin_pin, 7 * away, -9 * away, spin_bush])


def resultants(law, e, rate, spin_pin=0.0, spin_bush=0.0):
    """Generalised forces of the module: force on the pin and moment on it, force on the bush and moment on it."""
    q, u = state(e, rate, spin_pin, spin_bush)
    return derived(law).call("applied", t=0.0, q=q, u=u)


# -- the oracle is `film` ---------------------------------------------------------------------------------------------

MOTIONS = {
    "wedge": ((3e-5, 4e-5), (0, 0), 100, 0), "whirl": ((6e-5, 0), (0, -0.02), 0, 0),
    "squeeze": ((3e-5, -4e-5), (0.02, -0.03), 0, 0), "opening": ((-5e-5, 4e-5), (0.03, -0.01), 0, 0),
    "whirl at the mean spin, all but": ((2e-5, 5e-5), (-5e-5 * 70, 2e-5 * 70), 100, 40.1),
    "all at once": ((6e-5, 2e-5), (-0.02, 0.05), -300, 700), "bush alone": ((-1e-5, -7e-5), (0.01, 0.002), 0, 250),
    "nearly touching": ((8e-5, 3e-5), (0.03, 0.04), 500, 0), "from the centre": ((0, 0), (0.01, 0.07), 300, -100),
}  # fmt: skip


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("law", ["short_bearing", "long_bearing"])
def test_the_film_is_that_of_reynolds_equation(law, motion):
    got, expected = resultants(law, *MOTIONS[motion]), by_quadrature(law, *MOTIONS[motion])
    sizes = np.array([np.hypot(*expected[:2])] * 2 + [abs(expected[2]) + abs(expected[5])])
    assert np.all(np.abs(got - expected) <= 1e-10 * np.tile(sizes, 2)), (got - expected) / np.tile(sizes, 2)


# -- regular everywhere ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", ["short_bearing", "long_bearing"])
def test_nothing_is_undefined_at_the_centre_or_at_rest(law):
    for e, rate in (
        ((0, 0), (0, 0)), ((0, 0), (0.02, 0)), ((5e-5, 0), (0, 0)), ((C, 0), (0, 0)), ((1.1 * C, 0), (0.1, 0)),
    ):  # fmt: skip
        q, u = state(e, rate)
        u[:] = [*rate, 0, 0, 0, 0]
        for which in ("q", "u"):
            assert np.all(np.isfinite(derived(law).jacobian("applied", which, q=q, u=u, t=0.0)))
    at_centre = resultants(law, (0, 0), (0.02, 0.01))
    for turned in np.linspace(0, 6, 5):
        near = resultants(law, (1e-9 * C * np.cos(turned), 1e-9 * C * np.sin(turned)), (0.02, 0.01))
        assert near == pytest.approx(at_centre, rel=1e-8, abs=1e-8 * np.abs(at_centre).max())


@pytest.mark.parametrize("law", ["short_bearing", "long_bearing"])
def test_the_film_gives_way_to_dry_contact(law):
    """Its law's up to two layers, finite up to contact, gone one layer deep; force and slope without a jump on the way."""
    drag = derived(law)

    def force(e):
        q, u = state((e, 0), (0.01, 0))
        return drag.call("applied", t=0.0, q=q, u=u)[0], drag.jacobian("applied", "q", t=0.0, q=q, u=u)[0, 0]

    given = {"eta": ETA, "R_2": PIN, "L": LENGTH, "dR": C, "epsilon_w": 1 - LAYER / C, "epsilon_c": 0.0}
    values = {q: given[q.name] for q in LAWS[law].symbols() if q.name in given}
    for symbol, expression in LAWS[law].definitions:
        values[symbol] = evaluate(expression, values)
    least = float(evaluate(LAWS[law].along, values))  # of a film of one layer
    assert force(C - 2.5 * LAYER)[0] == pytest.approx(by_quadrature(law, (C - 2.5 * LAYER, 0), (0.01, 0))[0], rel=1e-8)
    assert force(C)[0] == pytest.approx(-0.01 * least, rel=1e-9)
    assert np.all(resultants(law, (C + LAYER, 0), (0.01, 0.02), 50.0) == 0)
    for seam in (C - 2 * LAYER, C, C + LAYER):
        (f, slope), (g, other) = force(seam - 1e-8 * LAYER), force(seam + 1e-8 * LAYER)
        assert f == pytest.approx(g, rel=1e-6, abs=1e-6 * 0.01 * least)
        assert slope == pytest.approx(other, rel=1e-4, abs=1e-5 * 0.01 * least / LAYER)
    before, at, after = (force(C - 2 * LAYER + way)[1] for way in (-1e-3 * LAYER, 0, 1e-3 * LAYER))
    assert at - before == pytest.approx(after - at, rel=0.02)  # not even the curvature jumps


@pytest.mark.parametrize("transition, left", [("linear", 0.5), ("abrupt", 0.0)])
def test_a_hybrid_film_has_its_share_of_the_force_at_one_layer(transition, left):
    """Flores' share falls in proportion to the penetration, Ravn's ends with the onset: both of a film of one layer."""
    model = Derived(scene(replace(film(), transition=transition), TOUCHING))

    def force(e):
        q, u = state((e, 0), (0.01, 0))
        return model.call("applied", t=0.0, q=np.append(q, (e >= C - LAYER) + (e >= C)), u=u)[0]

    least = by_quadrature("short_bearing", (C - LAYER, 0), (0.01, 0))[0]
    before = C - 1.5 * LAYER
    assert force(before) == pytest.approx(by_quadrature("short_bearing", (before, 0), (0.01, 0))[0], rel=1e-6)
    for e in (C - 0.3 * LAYER, C - 1e-6 * LAYER):
        assert force(e) == pytest.approx(least, rel=1e-6)
    assert force(C + LAYER / 2) == pytest.approx(left * least, rel=1e-6)
    assert force(C + LAYER) == 0


@pytest.mark.parametrize("law", ["short_bearing", "long_bearing"])
def test_size_and_thickness_are_what_a_caliper_and_a_scale_would_show(law):
    """The force of the quadrature, and the clearance less the eccentricity, down to a boundary layer and no less."""
    model = derived(law)
    rows = [[name for name, _ in model.OUTPUTS].index(f"oil.{what}") for what in ("force", "thickness")]
    for e, thickness in (((3e-5, 4e-5), C - 5e-5), ((0, 0), C), ((0, -C), LAYER), ((C + LAYER, 0), LAYER)):
        q, u = state(e, (0.01, -0.03), 200.0)
        size, actual = model.call("outputs", t=0.0, q=q, u=u)[rows]
        assert actual == pytest.approx(thickness, rel=1e-9)
        if np.hypot(*e) < C - 2 * LAYER:
            assert size == pytest.approx(np.hypot(*by_quadrature(law, e, (0.01, -0.03), 200.0, 0.0)[:2]), rel=1e-9)


# -- action and reaction, energy ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", ["short_bearing", "long_bearing"])
def test_action_is_reaction_and_the_film_dissipates(law):
    """In any frame: the bush itself is away from the origin, and moves."""
    rng = np.random.default_rng(7)
    model, power = derived(law), []
    row = [name for name, _ in model.MEMORY].index("oil.dissipated")
    for _ in range(40):
        e = C * rng.uniform(0, 1.01) * np.array([np.cos(a := rng.uniform(0, 7)), np.sin(a)])
        q, u = state(e, rng.normal(0, 0.1, 2), *rng.normal(0, 200, 2), away=0.1)
        f = model.call("applied", t=0.0, q=q, u=u)
        assert f[:2] == pytest.approx(-f[3:5], rel=1e-12)
        about_origin = f[2] + f[5] + q[0] * f[1] - q[1] * f[0] + q[3] * f[4] - q[4] * f[3]
        assert abs(about_origin) <= 1e-12 * (abs(f[2]) + abs(f[5]) + np.hypot(*f[:2]))
        dissipated = model.call("ledger", t=0.0, q=q, u=u, reactions=np.zeros(0))[row]
        assert dissipated == pytest.approx(-f @ u, rel=1e-9, abs=1e-9 * np.abs(f * u).max())
        power.append(dissipated)
    assert min(power) > 0


def test_a_film_in_space_is_the_one_in_the_plane():
    """About another axis, the pin off along it: what is along the axis, and the turn of the frame, do nothing."""
    bodies = [hd.Body(b.name, b.mass, (b.inertia,) * 3) for b in (pin, bush)]
    joint = replace(JOINT, pin=bodies[0].at(0, 0, 0), bush=bodies[1].at(0, 0, 0), axis=hd.X)
    joints = (hd.Free("of_pin", hd.GROUND, bodies[0]), hd.Free("of_bush", hd.GROUND, bodies[1]))
    sizes = hd.Scales(length=clearance, speed=hd.Parameter("pace", "m/s", 1), arm=radius)
    model = Derived(hd.Scene(hd.Mechanism("spatial", joints, (joint,)), (film(long_bearing),), sizes))
    e, rate, spin_pin, spin_bush = MOTIONS["all at once"]
    q, u = np.array([1e-3, *e, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0]), np.zeros(12)
    u[:4], u[9] = (0.3, *rate, spin_pin), spin_bush
    got, plane = model.call("applied", t=0.0, q=q, u=u), resultants("long_bearing", e, rate, spin_pin, spin_bush)
    assert got[[1, 2, 3, 7, 8, 9]] == pytest.approx(plane, rel=1e-12)
    assert got[[0, 6]] == pytest.approx(0, abs=1e-12 * np.abs(plane).max())


# -- a scene with a film -----------------------------------------------------------------------------------------------


UNSOUND = {
    "viscosity that is none": (lambda: film(lambda eta: short_bearing(hd.Parameter("viscosity", "Pa", 1))), "viscosity", "Pa s"),
    "kinematic viscosity": (lambda: film(lambda eta: long_bearing(hd.Parameter("viscosity", "mm^2/s", 1))), "viscosity", "Pa s"),
    "a bare number": (lambda: film(lambda eta: short_bearing(0.05)), "bare number", "Parameter"),
    "a layer of half the clearance": (lambda: film(thin=clearance / 2), "0.5", "(0, 0.5)"),
    "a layer that is no length": (lambda: film(thin=viscosity), "viscosity", "m"),
    "a transition that is none": (lambda: replace(film(), transition="sharp"), "'sharp'", "abrupt"),
    "cavitation of a journal": (lambda: replace(film(), cavitation=True), "cavitation=True", "sphere_film"),
    "no pair": (lambda: hd.Lubrication("oil", "elsewhere", short_bearing(viscosity), layer), "elsewhere", "joint"),
    "a law that is no film": (lambda: hd.Lubrication("oil", "joint", flores(0.5), layer), "flores", "film law"),
    "a film as friction": (lambda: hd.Friction("rub", "joint", short_bearing(viscosity)), "short_bearing", "friction law"),
    "a law without its viscosity": (lambda: hd.Lubrication("oil", "joint", short_bearing, layer), "without its parameters", "eta"),
}  # fmt: skip


@pytest.mark.parametrize("case", UNSOUND)
def test_unsound_films_are_refused(case):
    make, *texts = UNSOUND[case]
    with pytest.raises((hd.InputError, InconsistentUnits)) as raised:
        hd.generate(scene(make(), TOUCHING))
    for text in texts:
        assert text in str(raised.value)


def test_films_need_a_pin_with_a_length_and_consistent_units():
    short = replace(JOINT, length=None)
    with pytest.raises(hd.InputError, match="axial length"):
        scene(film(), pair=short)
    ball = hd.BallInSocket("joint", pin.at(0, 0, 0), bush.at(0, 0, 0), radius, clearance)
    with pytest.raises(hd.InputError, match="pin_in_bush"):
        scene(film(), pair=ball)
    with pytest.raises(hd.InputError, match="lubrication of pair joint"):
        scene(film(), film(name="more"))
    # A film law of one's own with a wrong unit is refused by the audit; marked, it runs and the module says so.
    wrong = replace(short_bearing, name="wrong", couple=short_bearing.along)
    with pytest.raises(InconsistentUnits, match="drag against the spin"):
        hd.generate(scene(film(wrong)))
    assert "UNCHECKED" in hd.generate(scene(replace(film(wrong), unchecked=True)))


WRITTEN = """
[[law]]
name = "full_squeeze"
kind = "film"
title = "Full film of a short bearing, its pressures below that at the ends kept"
source = "Frene et al. (1997)"
symbols.eta = { unit = "Pa s", meaning = "viscosity" }
definitions = [{ symbol = "T", unit = "1", meaning = "1 - eps^2", expression = "1 - epsilon_w**2 - epsilon_c**2" }]
along = "pi*eta*R_2*L**3/dR**3*(1 + 2*epsilon_w**2 - epsilon_c**2)/T**2.5"
across = "3*pi*eta*R_2*L**3/dR**3*epsilon_w*epsilon_c/T**2.5"
couple = "2*pi*eta*R_2**3*L/(dR*sqrt(T))"
"""


def test_a_film_law_of_a_file(tmp_path):
    """The full film is the two halves together, at w and at -w."""
    file = tmp_path / "own.toml"
    file.write_text(WRITTEN)
    full = Derived(scene(film(hd.laws_from(file)["full_squeeze"])))
    e, rate = (3e-5, -6e-5), np.array([0.02, 0.05])
    q, u = state(e, rate)
    halves = resultants("short_bearing", e, rate) - resultants("short_bearing", e, -rate)
    assert full.call("applied", t=0.0, q=q, u=u) == pytest.approx(halves, rel=1e-10)
    assert all(finding.verdict == "consistent" for finding in hd.audit_path(file))
    file.write_text(WRITTEN.replace("R_2**3*L/(dR", "R_2**3*L/(dR**2"))
    assert [finding.quantity for finding in hd.audit_path(file) if finding.verdict != "consistent"] == ["couple"]
    file.write_text("\n".join(line for line in WRITTEN.splitlines() if not line.startswith("across")))
    with pytest.raises(hd.InputError, match="across: found none"):
        hd.laws_from(file)
