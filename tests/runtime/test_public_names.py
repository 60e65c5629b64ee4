"""What a user sees of the objects that the functions return: few names, each documented."""

import inspect
from collections.abc import Mapping
from dataclasses import fields, is_dataclass

import pytest

from hertzwerk.runtime import Model, Solution, simulate

# A run is read, drawn, written, continued and differentiated by one object: its names beside those of every mapping.
MOST = {Model: 15, Solution: 27}


def fields_of(kind):
    return {each.name for each in fields(kind)} if is_dataclass(kind) else set()


def shown(kind):
    return sorted(name for name in {*dir(kind), *fields_of(kind)} - {*dir(Mapping)} if not name.startswith("_"))


@pytest.mark.parametrize("kind", MOST)
def test_a_class_shows_what_users_use_and_documents_it(kind):
    assert len(shown(kind)) <= MOST[kind], shown(kind)
    of_fields = "\n".join(inspect.getdoc(each) for each in kind.__mro__ if is_dataclass(each))
    assert [name for name in fields_of(kind) if f"\n{name}    " not in of_fields] == []
    others = set(shown(kind)) - fields_of(kind)
    assert [name for name in others if not inspect.getdoc(getattr(kind, name))] == []


def test_an_object_shows_no_more_than_its_class():
    model = Model("bouncing_ball")
    assert sorted(name for name in dir(model) if not name.startswith("_")) == shown(Model)
    assert (model.summary, model.inputs, model.pairs) == (model.engine.module.SUMMARY, {}, ("floor",))
    assert list(model.effects) == ["gravity", "floor", "energy_ledger"]
    assert next(iter(model.states.items())) == ("vertical.travel", "m")
    assert model.text.startswith('"""') and "def accelerations" in model.text
    assert model.evaluate("constants", model.bind().p)[0] == pytest.approx(model.bind().c)


def test_a_run_has_its_model_its_settings_and_the_record_of_the_engine():
    run = simulate("bouncing_ball", duration="10 ms", tolerance=1e-6, method="dop853", compiled=False)
    assert Model(run.engine.model).engine is run.engine.model
    assert (run.settings.duration, run.settings.accuracy, run.settings.tolerance) == (0.01, None, 1e-6)
    assert (run.settings.method, run.settings.compiled) == ("dop853", False)
    assert sorted(name for name in vars(run) if not name.startswith("_")) == sorted(each.name for each in fields(run))
