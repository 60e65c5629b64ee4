"""Flexible rods at random: ends, shapes, sections, joints, what they carry between and at their ends, in the plane and in space."""

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import load, modes, simulate
from reference.elastic_rods import Piece, frequencies

SEED = 41
ENDS = [("clamped", "free"), ("pinned", "pinned"), ("clamped", "clamped"), ("pinned", "free"), ("free", "free"), ("clamped", "pinned")]  # fmt: skip
JOINTS = {
    "weld": hd.Weld, "hinge": lambda name, parent, child: hd.Revolute(name, parent, child, hd.Z), "ball": hd.Spherical,
}  # fmt: skip


def draw(number, *effects, fitted):
    """One or two rods in a row with bodies at their ends; and the same in Y and, in space, in Z as `Piece`s.

    fitted: shapes that fit every joint, else any.
    """
    random = np.random.default_rng([SEED, number])
    space = bool(random.random() < 0.4)
    joints, rows, carrier = [], ([], []) if space else ([],), hd.GROUND

    def p(name, unit, low, high):
        return hd.Parameter(name, unit, float(np.exp(random.uniform(np.log(low), np.log(high)))))

    for i in range(random.integers(1, 3)):
        kinds = [*random.choice(["weld", "hinge", "ball"][: 2 + space], 2)]
        length, mass = p(f"length{i}", "m", 0.4, 1.2), p(f"mass{i}", "kg", 0.2, 2)
        stiff = [p(f"stiffness{i}_{axis}", "N m^2", 5, 80) for axis in "yz"[: 1 + space]]
        options = {"modes": int(random.integers(1, 4)), "cubics": bool(random.random() < 0.4), "ends": ENDS[random.integers(6)],
                   "damping_ratio": p(f"damping{i}", "1", 1e-3, 1e-1)}  # fmt: skip
        if fitted:
            options = {"modes": 4, "cubics": True, "ends": ("clamped", "clamped")}
        options |= {"stiffness_z": stiff[1]} if space else {}
        rod = hd.FlexibleRod(
            f"rod{i}", length, mass, stiff[0], twist_inertia=p(f"twist{i}", "kg m^2", 1e-4, 1e-3), **options
        )
        m, J, ahead = p(f"m{i}", "kg", 0.1, 1), p(f"J{i}", "kg m^2", 1e-4, 1e-2), p(f"ahead{i}", "m", 0.01, 0.1)
        body = hd.Body(f"body{i}", m, (J, J, J) if space else J, centre=(ahead, 0, 0))
        joints += [JOINTS[kinds[0]](f"joint{i}", carrier, rod.start), rod, JOINTS[kinds[1]](f"held{i}", rod.end, body)]
        carrier = rod.end
        for axis, row in enumerate(rows):
            turns = [kind == "ball" or (kind == "hinge" and axis == 0) for kind in kinds]
            numbers = [float(each.default) for each in (length, mass, stiff[axis])]
            row.append(Piece(*numbers, turns[0], tuple(float(each.default) for each in (m, J, ahead)), turns[1]))
    scales = hd.Scales(
        length=hd.Parameter("size", "m", 0.01), speed=hd.Parameter("pace", "m/s", 1), arm=joints[1].length
    )
    return hd.Scene(hd.Mechanism("random_rods", tuple(joints)), (*effects, hd.EnergyLedger()), scales), rows


@pytest.mark.by_turns(10)
@pytest.mark.parametrize("number", range(20))
def test_small_vibrations_are_those_of_finite_elements(number):
    """The first three; a stiffness one per cent off would be seen."""
    scene, rows = draw(number, fitted=True)
    found = 2 * np.pi * modes(load(scene)).frequencies[:3]
    expected = np.sort(np.concatenate([*map(frequencies, rows)]))[:3]
    assert found[0] == pytest.approx(expected[0], rel=1e-4)
    assert found == pytest.approx(expected, rel=2e-3)
    assert found != pytest.approx(expected * np.sqrt(1.01), rel=2e-3)


@pytest.mark.by_turns(10)
@pytest.mark.parametrize("number", range(20, 40))
def test_both_coordinates_give_the_same_motion_and_keep_the_energy(number):
    weight = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y)
    scene, ((first, *_), *_) = draw(number, weight, fitted=False)
    duration = 0.1 * float(np.sqrt(first.mass * first.length**3 / first.stiffness))
    options = {"duration": duration, "tolerance": 1e-8, "method": "dop853", "compiled": False}
    one, other = (simulate(load(scene.with_coordinates(kind)), **options) for kind in ("tree", "absolute"))
    for name in ("body0.x", "body0.y", "rod0.bend_1"):
        assert one[name][-1] == pytest.approx(other[name][-1], abs=1e-9), name
    assert max(one.energy_residual, other.energy_residual) < 1e-7
    assert abs(one["body0.y"][-1] - one["body0.y"][0]) > 1e-5
