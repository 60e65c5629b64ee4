"""Spheres that fall into a box and come to rest: forces of a pyramid in closed form, and of a heap by its positions alone."""

from itertools import combinations

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate
from reference import scenes

R, G, K = 0.02, 9.81, 1e5
WEIGHT = 1100 * 4 / 3 * np.pi * R**3 * G
WALLS = {1: (0, 1), 2: (0, -1), 3: (2, 1), 4: (2, -1)}  # axis and sign of the normal


def forces_of(centres, width):
    """Forces [N] on spheres at rest by their positions (n x 3) alone, and the largest penetration: f = K d^1.5 along the line of centres."""
    forces, depths = np.zeros_like(centres), [0.0]
    for i, j in combinations(range(len(centres)), 2):
        apart = centres[i] - centres[j]
        distance = np.linalg.norm(apart)
        depths.append(max(2 * R - distance, 0))
        forces[i] += K * depths[-1] ** 1.5 * apart / distance
        forces[j] -= K * depths[-1] ** 1.5 * apart / distance
    for axis, sign, away in ((1, 1, 0), *((axis, sign, width / 2) for axis, sign in WALLS.values())):
        depth = np.maximum(R - away - sign * centres[:, axis], 0)
        depths.append(depth.max())
        forces[:, axis] += sign * K * depth**1.5
    return forces, max(depths)


def places(run, n, times):
    """Positions of the spheres [m], n x 3 at each time."""
    found = run.at(times)
    return np.array([[found[f"flight_{i}.{axis}"] for axis in "xyz"] for i in range(1, n + 1)]).transpose(2, 0, 1)


def pressing(end, name, n):
    return sum(end[f"{name}_{i}.normal_force"][0] for i in range(1, n + 1))


def test_a_pyramid_rests_with_the_forces_of_statics():
    """Four spheres in the corners carry a fifth: 5/4 of a weight on the floor under each; on a wall tan(a)/(4 sqrt 2) of one by each."""
    width = 4.4 * R
    run = simulate(load(scenes.spheres_in_box(5)), duration="2 s", tolerance=1e-7, parameters={"width": f"{width} m"})
    end = run.at([2.0])
    wall = top = 0.0
    # the angle of the top's contacts from the vertical, with the spheres pressed into walls and each other
    for _ in range(50):
        sine = np.sqrt(2) * (width / 2 - R + (wall / K) ** (2 / 3)) / (2 * R - (top / K) ** (2 / 3))
        top = WEIGHT / (4 * np.sqrt(1 - sine**2))
        wall = top * sine / np.sqrt(2)
    assert [end[f"floor_{i}.normal_force"][0] for i in range(1, 5)] == pytest.approx([1.25 * WEIGHT] * 4, rel=1e-4)
    assert [end[f"balls_{i}_5.normal_force"][0] for i in range(1, 5)] == pytest.approx([top] * 4, rel=1e-4)
    assert end["wall_1_1.normal_force"][0] == pytest.approx(wall, rel=1e-4)
    assert end["floor_5.normal_force"][0] == end["balls_1_2.normal_force"][0] == 0
    assert run.energy_residual < 1e-6


@pytest.mark.slow
def test_a_heap_falls_settles_and_rests():
    """No two spheres pass through each other on the way, each is in equilibrium at the end, and the ledger closes."""
    n, width = 8, 0.1
    run = simulate(load(scenes.spheres_in_box(n)), duration="2 s", tolerance=1e-6)
    assert run.outcome.finished, run
    assert len(run.impacts) > 2 * n
    starts = places(run, n, [0.0])[0]
    energy = WEIGHT * np.sum(starts[:, 1])  # all of it in one contact, 2/5 K d^2.5, is the deepest that there can be
    deepest = max(forces_of(centres, width)[1] for centres in places(run, n, np.linspace(0, 2, 2001)))
    assert 0 < deepest < (2.5 * energy / K) ** 0.4
    end, (centres,) = run.at([2.0]), places(run, n, [2.0])
    balance = forces_of(centres, width)[0] - [0, WEIGHT, 0]
    assert np.abs(balance).max() < 1e-3 * WEIGHT
    assert pressing(end, "floor", n) == pytest.approx(n * WEIGHT, rel=1e-3)
    assert pressing(end, "wall_1", n) == pytest.approx(pressing(end, "wall_2", n), rel=1e-3)
    assert pressing(end, "wall_3", n) == pytest.approx(pressing(end, "wall_4", n), rel=1e-3)
    assert run.energy_residual < 1e-4


@pytest.mark.exhaustive
def test_a_hundred_spheres_come_to_rest():
    """5,450 pairs, of which those that are near are listed; equilibrium by the positions of all, so that a pair that was missed shows."""
    n, across = 100, 5
    run = simulate(load(scenes.spheres_in_box(n, across)), duration="3 s", tolerance=1e-5, output="steps")
    end = run.at([3.0])
    forces, depth = forces_of(places(run, n, [3.0])[0], 0.05 * across)
    assert np.abs(forces - [0, WEIGHT, 0]).max() < 1e-2 * WEIGHT
    assert depth < R / 20
    assert pressing(end, "floor", n) == pytest.approx(n * WEIGHT, rel=1e-3)
    assert run.energy_residual < 1e-5
