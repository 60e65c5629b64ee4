"""Many contact pairs: a step evaluates the pairs in contact and no others, and a row of spheres does what the laws of impact say."""

from functools import cache

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.integrate import classes
from hertzwerk.runtime.integrate.explicit import flow
from hertzwerk.runtime.model import Model
from reference import scenes

APART, CLOSE = "1 mm", "0.1 um"  # gaps between neighbours; an impact is about 10 um deep


@cache
def row(n):
    return load(scenes.row(n))


def hit(model, gap, **options):
    """The row, its first sphere coming in."""
    return simulate(model, duration="5 ms", parameters={"gap": gap}, **options)


def part(run, name):
    return run.history.part(name)


@pytest.mark.parametrize(("method", "gap"), [("dop853", APART), ("dop853", CLOSE), ("rodas", CLOSE), ("auto", CLOSE)])
def test_a_class_for_each_pair_changes_no_number(monkeypatch, method, gap):
    """Steps that evaluate one pair alone, against the same steps with every pair evaluated and masked.

    Explicit steps are bitwise the same; implicit ones eliminate fewer unknowns, which rounds otherwise.
    """
    options = {"accuracy": 1e-7, "method": method, "compiled": False}
    own = hit(row(4), gap, **options)
    monkeypatch.setattr(classes, "ALONE", 0)
    masked = hit(Model(row(4).module), gap, **options)
    first, second, third, several = 2.0, 3.0, 4.0, 5.0
    assert ({first, several} if gap == CLOSE else {first, second, third}) <= set(part(own, "class")[:, 0])
    assert set(part(masked, "class")[:, 0]) == {0.0, 1.0, 2.0}
    if method == "dop853":
        names = own.history.integrator.layouts.state.sizes
        assert [name for name in names if not np.array_equal(part(own, name), part(masked, name))] == ["class"]
    assert part(own, "y") == pytest.approx(part(masked, "y"), rel=1e-10, abs=1e-13)


def test_a_pair_out_of_contact_costs_no_operation_of_a_stage():
    """Guards that nothing reaches: a stage in contact does what it does without them, and sets the rates of their ledgers to zero."""
    bare, guarded = (load(scenes.guarded_crank(guards)) for guards in (0, 3))
    operations = [flow(model, (0,)).rates.n_instructions() for model in (bare, guarded)]
    assert operations[1] - operations[0] == guarded.nz - bare.nz == 3


@pytest.mark.parametrize("method", ["dop853", "auto"])
def test_the_same_digits_compiled(method):
    machine, native = (hit(row(4), CLOSE, accuracy=1e-8, method=method, compiled=c) for c in (False, True))
    assert np.array_equal(machine.history.rows, native.history.rows)
