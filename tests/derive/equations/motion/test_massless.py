"""Massless links and slot blocks that close loops: closed forms, and the limit of a small mass."""

import numpy as np
import pytest
from scipy.integrate import quad

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

A, D, L = hd.Parameter("a", "mm", 50.0), hd.Parameter("d", "mm", 100.0), hd.Parameter("l", "mm", 150.0)
CRANK = hd.Body("crank", hd.Parameter("m_crank", "kg", 1.0), hd.Parameter("J_crank", "kg m^2", 2e-3))
SLIDER = hd.Body("slider", hd.Parameter("m_slider", "kg", 0.8))
ROCKER = hd.Body(
    "rocker", hd.Parameter("m_rocker", "kg", 2.0), hd.Parameter("J_rocker", "kg m^2", 1e-2), centre=(L, 0, 0)
)
TURNING = hd.Start(
    position={"main": 0}, speed={"main": hd.Parameter("w_0", "rad/s", 10.0)}, near={"swing": hd.Parameter("up", "rad", 1.0)},
)  # fmt: skip
ACROSS = hd.Start(position={"main": 0}, speed={"main": TURNING.speed["main"]}, near={"guide": D})
SIZES = hd.Scales(length=A, speed=hd.Parameter("pace", "m/s", 1.0), arm=A)


def scene(joints, effects=(), start=TURNING, coordinates="tree"):
    return hd.Scene(hd.Mechanism("loop", joints), (hd.EnergyLedger(), *effects), SIZES, start, coordinates=coordinates)


def whitworth(mass=0, inertia=0):
    """A crank whose slot block drives a rocker, below it."""
    block = hd.Body("block", mass, inertia)
    return (
        hd.Revolute("main", hd.GROUND, CRANK, axis=hd.Z), hd.Revolute("pin", CRANK.at(A, 0, 0), block, axis=hd.Z),
        hd.Revolute("swing", hd.GROUND.at(0, -D, 0), ROCKER, axis=hd.Z), hd.Prismatic("slot", ROCKER, block, axis=hd.X),
    )  # fmt: skip


def swing(turn):
    """Angle of the rocker and its slope by the crank's angle: tan(angle) = (d + a sin)/(a cos)."""
    x, y = 0.05 * np.cos(turn), 0.1 + 0.05 * np.sin(turn)
    return np.arctan2(y, x), (x * 0.05 * np.cos(turn) + y * 0.05 * np.sin(turn)) / (x**2 + y**2)


def yoke():
    block = hd.Body("block", 0)
    return (
        hd.Revolute("main", hd.GROUND, CRANK, axis=hd.Z), hd.Revolute("pin", CRANK.at(A, 0, 0), block, axis=hd.Z),
        hd.Prismatic("guide", hd.GROUND, SLIDER, axis=hd.X), hd.Prismatic("slot", SLIDER, block, axis=hd.Y),
    )  # fmt: skip


def slider_crank():
    """Its connecting rod has no mass: a member of two forces."""
    rod = hd.Body("rod", 0)
    return (
        hd.Revolute("main", hd.GROUND, CRANK, axis=hd.Z), hd.Revolute("pin", CRANK.at(A, 0, 0), rod, axis=hd.Z),
        hd.Prismatic("guide", hd.GROUND, SLIDER, axis=hd.X), hd.Revolute("wrist", rod.at(L, 0, 0), SLIDER, axis=hd.Z),
    )  # fmt: skip


def inertia_of(name, turn):
    """Moment of inertia reduced to the crank [kg m^2], from the closed form of the position."""
    s, c = 0.05 * np.sin(turn), 0.05 * np.cos(turn)
    moved = {
        "whitworth": (1e-2 + 2.0 * 0.15**2) * swing(turn)[1] ** 2,
        "yoke": 0.8 * s**2,
        "slider_crank": 0.8 * (s + s * c / np.sqrt(0.15**2 - s**2)) ** 2,
    }
    return 2e-3 + moved[name]


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("make", [whitworth, yoke, slider_crank], ids=lambda make: make.__name__)
def test_a_free_crank_turns_as_its_reduced_inertia_lets_it(make, coordinates):
    """Without loads J(turn) speed^2 stays: the time at each angle is an integral."""
    start = TURNING if make is whitworth else ACROSS
    run = simulate(load(scene(make(), start=start, coordinates=coordinates)), duration="0.4 s", accuracy=1e-8)
    assert run.outcome.name == "finished"
    name, end = make.__name__, run["main.angle"][-1]
    first = np.sqrt(inertia_of(name, 0.0)) * 10
    time, _ = quad(lambda turn: np.sqrt(inertia_of(name, turn)) / first, 0, end, epsabs=1e-12, limit=400)
    assert time == pytest.approx(0.4, abs=2e-9)
    assert run["main.speed"] == pytest.approx(first / np.sqrt(inertia_of(name, run["main.angle"])), rel=1e-6)


def test_a_driven_slot_block_moves_as_its_geometry_says():
    motor = hd.ConstantSpeed("motor", "main", hd.Parameter("w", "rad/s", 10.0))
    model = load(scene(whitworth(), (motor,), hd.Start(near=TURNING.near)))
    run = simulate(model, duration="1 s", accuracy=1e-8)
    assert np.unwrap(swing(10 * run.t)[0]) == pytest.approx(run["swing.angle"], abs=1e-10)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_no_mass_is_the_limit_of_a_small_one(coordinates):
    def end(mass):
        of = (hd.Parameter("m", "kg", mass), hd.Parameter("J", "kg m^2", mass * 1e-3)) if mass else (0, 0)
        run = simulate(load(scene(whitworth(*of), coordinates=coordinates)), duration="0.5 s", accuracy=1e-9)
        return run["main.angle"][-1]

    none, small, smaller = end(0), end(2e-5), end(1e-5)
    assert small - none == pytest.approx(2 * (smaller - none), rel=1e-2)
    assert abs(smaller - none) > 1e-7


def in_space(last):
    """A massless link from a crank to a slider across it."""
    rod = hd.Body("rod", 0)
    guide = hd.Prismatic("guide", hd.GROUND, SLIDER, axis=hd.X)
    return (
        hd.Revolute("main", hd.GROUND, CRANK, axis=hd.Z), hd.Spherical("ball", CRANK.at(A, 0, 0), rod), guide, last(rod),
    )  # fmt: skip


def test_a_massless_link_in_space_needs_a_joint_that_holds_its_spin():
    universal = in_space(lambda rod: hd.Universal("cross", SLIDER, rod.at(L, 0, 0), first=hd.Y, second=hd.Z))
    run = simulate(load(scene(universal, start=ACROSS)), duration="0.4 s", accuracy=1e-8)
    flat = simulate(load(scene(slider_crank(), start=ACROSS)), duration="0.4 s", accuracy=1e-8)
    assert run["main.angle"][-1] == pytest.approx(flat["main.angle"][-1], abs=1e-7)
    with pytest.raises(
        hd.InputError, match=r"joint ball: .* moves? no mass; .*where the loops leave it free; without one: rod"
    ):
        load(scene(in_space(lambda rod: hd.Spherical("end", SLIDER, rod.at(L, 0, 0))), start=ACROSS))


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_block_that_its_loop_leaves_free_to_turn_is_refused(coordinates):
    block = hd.Body("block", 0)
    other = hd.Revolute("other", ROCKER.at(D, 0, 0), block, axis=hd.Z)
    with pytest.raises(hd.InputError, match=r"joint pin: found pin moves no mass; .*the loops leave it free"):
        load(
            scene(
                (*whitworth()[:1], hd.Revolute("pin", CRANK.at(A, 0, 0), block, axis=hd.Z), whitworth()[2], other),
                coordinates=coordinates,
            )
        )
