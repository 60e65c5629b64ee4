"""Spheres that fall into a box and come to rest: forces of a pyramid in closed form, and of a heap by its positions alone."""

import tomllib
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.analysis.validation import scenarios
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
    rows = run.at(times)
    return np.array([[rows[f"flight_{i}.{axis}"] for axis in "xyz"] for i in range(1, n + 1)]).transpose(2, 0, 1)


def pressing(end, name, n):
    return sum(end[f"{name}_{i}.normal_force"][0] for i in range(1, n + 1))


def test_the_scenario_expects_the_forces_of_statics():
    """Four spheres in the corners carry a fifth: 5/4 of a weight on the floor under each; on a wall tan(a)/(4 sqrt 2) of one by each."""
    stated = tomllib.loads((Path(scenarios.__file__).parent / "spheres_in_box.toml").read_text())
    expected = {check["quantity"]: check.get("expected", "") for check in stated["checks"]}
    width = float(stated["parameters"]["width"].removesuffix(" mm")) * 1e-3
    wall = top = 0.0
    # the angle of the top's contacts from the vertical, with the spheres pressed into walls and each other
    for _ in range(50):
        sine = np.sqrt(2) * (width / 2 - R + (wall / K) ** (2 / 3)) / (2 * R - (top / K) ** (2 / 3))
        top = WEIGHT / (4 * np.sqrt(1 - sine**2))
        wall = top * sine / np.sqrt(2)
    for quantity, force in (("floor_1", 1.25 * WEIGHT), ("balls_1_5", top), ("wall_1_1", wall)):
        assert float(expected[f"final.{quantity}.normal_force"].removesuffix(" N")) == pytest.approx(force, rel=3e-6)


@pytest.mark.exhaustive
def test_a_hundred_spheres_come_to_rest():
    """5,450 pairs, of which those that are near are listed; equilibrium by the positions of all, so that a pair that was missed shows."""
    n, across = 100, 5
    run = simulate(load(scenes.spheres_in_box(n, across)), duration="3 s", tolerance=1e-5, grid=None)
    end = run.at([3.0])
    forces, depth = forces_of(places(run, n, [3.0])[0], 0.05 * across)
    assert np.abs(forces - [0, WEIGHT, 0]).max() < 1e-2 * WEIGHT
    assert depth < R / 20
    assert pressing(end, "floor", n) == pytest.approx(n * WEIGHT, rel=1e-3)
    assert run.energy_residual < 1e-5
