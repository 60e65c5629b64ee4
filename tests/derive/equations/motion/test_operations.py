"""The size of derived equations: a gated baseline, and sympy.physics.mechanics beside it."""

import json

import pytest
import sympy as sp
from kane import chain
from operations import ACCEPT, BASELINE, CHAINS, counts, of_chain


def test_operation_counts_are_those_of_the_baseline():
    expected, actual = json.loads(BASELINE.read_text(encoding="utf-8")), counts()
    changes = [
        f"{name}.{function}: {expected.get(name, {}).get(function, 'no entry')} -> {actual.get(name, {}).get(function, 'gone')}"
        for name in {**expected, **actual}
        for function in {**expected.get(name, {}), **actual.get(name, {})}
        if expected.get(name, {}).get(function) != actual.get(name, {}).get(function)
    ]
    assert not changes, "\n".join([*changes, f"if that is meant, accept it: {ACCEPT}"])


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow if n == 3 else pytest.mark.exhaustive) for name, (n, _) in CHAINS.items() if 3 <= n <= 6],
)  # fmt: skip
def test_a_chain_takes_fewer_operations_than_kanes_method_and_cse(name):
    """Theirs are mass matrix and forcing alone; ours solve for the accelerations too."""
    n, axes = CHAINS[name]
    mass, forcing, _, _ = chain(n, axes).kane()
    shared, reduced = sp.cse([mass, forcing])
    theirs = sum(e.count_ops() for _, e in shared) + sum(e.count_ops() for matrix in reduced for e in matrix)
    assert sum(of_chain(n, axes).values()) < theirs
