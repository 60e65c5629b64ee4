"""What a user sees of the objects that the functions return: few names, each documented."""

import inspect

import pytest

from hertzwerk.runtime import Model

MOST = {Model: 15}


def shown(kind):
    return [name for name in dir(kind) if not name.startswith("_")]


@pytest.mark.parametrize("kind", MOST)
def test_a_class_shows_what_users_use_and_documents_it(kind):
    assert len(shown(kind)) <= MOST[kind], shown(kind)
    undocumented = [name for name in shown(kind) if not inspect.getdoc(getattr(kind, name))]
    assert undocumented == []


def test_an_object_shows_no_more_than_its_class():
    model = Model("bouncing_ball")
    assert shown(model) == shown(Model)
    assert (model.summary, model.inputs, model.pairs) == (model.engine.module.SUMMARY, {}, ("floor",))
    assert list(model.effects) == ["gravity", "floor", "energy_ledger"]
    assert next(iter(model.states.items())) == ("vertical.travel", "m")
    assert model.text.startswith('"""') and "def accelerations" in model.text
    assert model.evaluate("constants", model.bind().p)[0] == pytest.approx(model.bind().c)
