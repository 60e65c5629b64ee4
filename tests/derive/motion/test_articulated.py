"""Articulated bodies, the solution along long paths, against Kane's method and against elimination."""

import numpy as np
import pytest
from derived import Derived
from kane import chain
from test_coordinates import SCENES
from test_equations import TREES, deviation
from test_massless import scene, whitworth

from hertzwerk.derive.derivation import derivation_of
from hertzwerk.derive.motion import equations

ALONG = {
    name: SCENES[name]
    for name in ("spatial", "turned points", "free, with a tail", "slender rods and a cross without mass")
}


@pytest.fixture
def articulated(monkeypatch):
    """Any path is long."""
    monkeypatch.setattr(equations, "LONG_PATH", 0)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", ["planar, branches", "spatial, branches", "driven root, spatial", "two drives"])
def test_articulated_bodies_move_as_by_kanes_method(name, articulated):
    assert deviation(TREES[name], Derived(TREES[name].scene()), 2) < 1e-10


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", [*ALONG, "whitworth"])
def test_elimination_gives_the_same_accelerations(name, monkeypatch):
    """With balls, slides, turned axes, in a loop with a body without mass, to which inertia is lent."""
    of = scene(whitworth()) if name == "whitworth" else ALONG[name]
    found, rng = [], np.random.default_rng(0)
    for longest in (0, 1000):
        monkeypatch.setattr(equations, "LONG_PATH", longest)
        found.append(Derived(of))
    q, u = rng.uniform(-1, 1, found[0].nq), rng.uniform(-2, 2, found[0].nu)
    for i in found[0].names.get("QUATERNIONS", ()):
        q[i : i + 4] /= np.linalg.norm(q[i : i + 4])
    one, other = (each.call("accelerations", t=0.3, q=q, u=u, f=np.arange(1.0, len(u) + 1)) for each in found)
    for here, there in zip(one, other, strict=True):
        assert here == pytest.approx(there, rel=1e-8, abs=1e-9 * np.max(np.abs(other[0])))
    assert found[0].OPERATIONS != found[1].OPERATIONS  # two ways


@pytest.mark.parametrize(("axes", "lengths"), [("Z", (11, 12, 13)), ("ZYX", (12, 15, 18))])
def test_steps_in_joint_coordinates_are_linear_in_the_length_of_a_chain(axes, lengths):
    """Each further link about the same axis takes as many assignments as the one before."""
    counts = []
    for n in lengths:
        program = derivation_of(chain(n, axes).scene(ledger=False))
        counts += [len(function.body) for function in program.functions if function.name == "accelerations"]
    assert counts[2] - counts[1] == counts[1] - counts[0]
