"""Designs: values as exact as they are written, points in order, samples spread as their theory says, every fault at once."""

import itertools
import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hertzwerk.runtime.engine.model.ranges import Range
from hertzwerk.runtime.studies.sweeps.points.design_points import read_design


def design(over, **how):
    faults = []
    found = read_design(over, **how, faults=faults)
    assert faults == []
    return found


def faults_of(over, **how):
    faults = []
    read_design(over, **how, faults=faults)
    return [f"{fault.where}: {fault.found}" for fault in faults]


def column(points, name):
    return [point[name] for point in points]


def test_values_of_a_range_are_those_one_would_type():
    points = list(design({"clearance": "0.05..0.5 mm:10"}))
    assert column(points, "clearance") == [(float(f"{5 * i}e-2"), "mm") for i in range(1, 11)]
    naive = np.linspace(0.05, 0.5, 10).tolist()
    assert [value for value, _ in column(points, "clearance")] != naive  # the seeded fault: 0.15000000000000002
    decades = list(design({"stiffness": "1e6..1e9 N/m:7 log"}))
    assert [value for value, _ in column(decades, "stiffness")][::2] == [1e6, 1e7, 1e8, 1e9]


@given(
    low=st.decimals("-1000", "1000", places=3), rise=st.decimals("0.001", "1000", places=3), parts=st.integers(1, 30), finer=st.integers(1, 6),
)  # fmt: skip
def test_a_finer_range_has_the_values_of_the_coarser_bitwise(low, rise, parts, finer):
    high = low + rise
    coarse, fine = (column(list(design({"x": f"{low}..{high} m:{n + 1}"})), "x") for n in (parts, parts * finer))
    assert fine[::finer] == coarse
    assert [value for value, _ in coarse] == [
        float(Fraction(Decimal(low)) + Fraction(i, parts) * Fraction(Decimal(rise))) for i in range(parts + 1)
    ]


@given(low=st.floats(1e-12, 1e12), ratio=st.floats(1.001, 1e9), parts=st.integers(1, 20), finer=st.integers(2, 5))
def test_a_logarithmic_range_has_equal_ratios_and_nests(low, ratio, parts, finer):
    ends = Fraction(low), Fraction(low) * Fraction(ratio)
    values = [Range(*ends, "m", log=True).at(Fraction(i, parts))[0] for i in range(parts + 1)]
    assert values[0] == low
    expected = [low * ratio ** (i / parts) for i in range(parts + 1)]
    assert np.allclose(values, expected, rtol=1e-12, atol=0)
    nested = [Range(*ends, "m", log=True).at(Fraction(i, parts * finer))[0] for i in range(0, parts * finer + 1, finer)]
    assert nested == values


def test_points_of_a_grid_and_pairs_are_in_order():
    over = {"a": (1, 2), "b": (3, 4)}
    rows = [tuple(value for value, _ in point.values()) for point in list(design(over))]
    assert rows == list(itertools.product((1, 2), (3, 4)))
    pairs = [tuple(value for value, _ in point.values()) for point in design(over, zip=True)]
    assert pairs == [(1, 3), (2, 4)]
    expected = [(0.1, "mm"), (0.2, "mm"), (0.4, "mm")]
    for written in ("0.1,0.2,0.4 mm", "0.1 mm, 0.2 mm, 0.4 mm", ("0.1 mm", (0.2, "mm"), "0.4 mm")):
        assert column(list(design({"c": written})), "c") == expected
    assert column(list(design({"e": "0.5,0.7"})), "e") == [(0.5, "1"), (0.7, "1")]
    assert column(list(design({"e": np.array([0.5, 0.7])})), "e") == [(0.5, "1"), (0.7, "1")]
    assert column(list(design({"e": 0.5, "c": (0.2, "mm")})), "c") == [(0.2, "mm")]
    over = {"a": "0..1"}
    assert list(design(over, sample=8, seed=1)) == list(design(over, sample=8, seed=1))
    assert list(design(over, sample=8, seed=1)) != list(design(over, sample=8, seed=2))


def test_a_latin_hypercube_has_one_point_in_each_part_of_every_range():
    over = {"a": "0..1 m", "b": "-3..5", "c": "1e-3..1e3 log"}
    points = list(design(over, sample=50, seed=7))
    scaled = np.array(
        [[a, (b + 3) / 8, (math.log10(c) + 3) / 6] for (a, _), (b, _), (c, _) in (p.values() for p in points)]
    )
    assert np.array_equal(np.sort(np.floor(scaled * 50), axis=0), np.tile(np.arange(50.0)[:, None], 3))
    uniform = np.random.default_rng(7).random((50, 3))  # the seeded fault: points at random
    assert not np.array_equal(np.sort(np.floor(uniform * 50), axis=0), np.tile(np.arange(50.0)[:, None], 3))


def test_sobol_points_are_balanced_and_those_of_a_shorter_sequence_are_among_them():
    over = {"a": "0..1", "b": "0..1", "e": (5, 7)}
    few, many = (list(design(over, sample=n, sampler="sobol", seed=3)) for n in (16, 64))
    assert many[:16] == few
    values = np.array([[a, b] for (a, _), (b, _), _ in (point.values() for point in many)])
    cells = np.floor(values * 8).astype(int)
    assert np.all(np.bincount(cells[:, 0] * 8 + cells[:, 1]) == 1)
    assert column(many, "e").count((5.0, "1")) == 32


@pytest.mark.parametrize(
    ("over", "how", "places"),
    [
        ({"a": "1..2 m"}, {}, ["over['a']"]),
        ({"a": "2..1 m:3", "b": "1..2 furlong:3", "c": "-1..1:3 log"}, {}, ["over['a']", "over['b']", "over['c']"]),
        ({"a": "1..2:1", "b": "x", "d": [], "e": [True], "f": "1e999..2:3"}, {}, ["over['a']", "over['b']", "over['d']", "over['e']", "over['f']"]),
        ({"a": "1..2:3"}, {"sample": 5}, ["over['a']"]),
        ({"a": "1..2"}, {"sample": 0, "sampler": "lattice", "seed": -1}, ["sample", "lattice", "seed"]),
        ({"a": "1..2"}, {"sample": 100, "sampler": "sobol"}, ["sample"]),
        ({"a": "1,2", "b": "1,2,3"}, {"zip": True}, ["zip"]),
        ({"a": "1..2"}, {"zip": True, "sample": 5}, ["zip"]),
        ({"a": "1..2:1000", "b": "1..2:1000", "c": "1,2"}, {}, ["over"]),
        ({}, {}, ["over"]),
        ([1], {}, ["over"]),
    ],
)  # fmt: skip
def test_every_fault_is_found_at_once(over, how, places):
    assert [fault.partition(":")[0] for fault in faults_of(over, **how)] == places
