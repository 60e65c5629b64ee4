"""Impulses of several contacts at one instant: against an enumeration of what may be active, and Coulomb's law itself."""

from itertools import product

import numpy as np
import pytest

from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import Contact, NoSolutionError, solved


def inverse_inertia(rng, rows):
    A = rng.standard_normal((rows, rows + 2))
    return A @ A.T


def enumerated(D, b):
    """Solution x >= 0, D x + b >= 0, x (D x + b) = 0, by all choices of active rows."""
    for active in product([False, True], repeat=len(b)):
        rows = np.flatnonzero(active)
        x = np.zeros(len(b))
        x[rows] = np.linalg.solve(D[np.ix_(rows, rows)], -b[rows])
        if np.all(x >= 0) and np.all(D @ x + b >= -1e-12):
            return x
    raise AssertionError


def test_impulses_without_friction_are_those_of_an_enumeration():
    rng = np.random.default_rng(20261127)
    for _ in range(50):
        count = int(rng.integers(1, 6))
        D, b = inverse_inertia(rng, count), rng.standard_normal(count)
        x = solved(D, b, [Contact("pair", i, [], 0.0) for i in range(count)])
        assert x == pytest.approx(enumerated(D, b), abs=1e-9)


@pytest.mark.parametrize("tangents", [1, 2])
def test_friction_holds_or_opposes_the_sliding_with_all_that_it_may(tangents):
    rng = np.random.default_rng(7)
    for _ in range(30):
        D, b, mu = (
            inverse_inertia(rng, 1 + tangents) + np.eye(1 + tangents), rng.standard_normal(1 + tangents), rng.uniform(0.05, 0.4),
        )  # fmt: skip
        b[0] = -abs(b[0])
        x = solved(D, b, [Contact("pair", 0, [*range(1, 1 + tangents)], mu)])
        v = D @ x + b
        held, slip = np.linalg.norm(x[1:]), np.linalg.norm(v[1:])
        assert x[0] > 0 and abs(v[0]) < 1e-10
        assert held <= mu * x[0] * (1 + 1e-9)
        if slip > 1e-9:
            assert x[1:] == pytest.approx(-mu * x[0] * v[1:] / slip, abs=1e-8)


def test_a_contact_that_friction_jams_has_no_impulse():
    jam = np.array(
        [[1.0, 2.0], [2.0, 5.0]]
    )  # a newton of friction along its way closes the contact by more than one of pressure opens
    with pytest.raises(NoSolutionError, match="Painleve"):
        solved(jam, np.array([-1.0, 0.0]), [Contact("pair", 0, [1], 0.6, slides=np.array([1.0]))])
    assert solved(jam, np.array([-1.0, 0.0]), [Contact("pair", 0, [1], 0.4, slides=np.array([1.0]))])[
        0
    ] == pytest.approx(5)
