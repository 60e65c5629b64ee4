"""Tests of many cases: all are tried and those that fail are named; by turns, every value of a short list is."""

from itertools import product
from pathlib import Path
from types import SimpleNamespace

import pytest
from each import each
from turns import FEW, take_turns


def test_every_case_is_tried_and_those_that_fail_are_named(tmp_path):
    tried = []

    @each("a", [1, 2])
    @each(("b", "c"), [(3, 4), (5, 6)])
    def test(a, b, c, folder):
        tried.append((a, b, c, folder))
        assert a == 1
        with pytest.raises(ValueError, match="4"):
            raise ValueError(c)

    with pytest.raises(BaseExceptionGroup, match="3 of 4 cases") as raised:
        test(folder=tmp_path)
    assert [row[:3] for row in tried] == [(1, 3, 4), (1, 5, 6), (2, 3, 4), (2, 5, 6)]
    assert [error.__notes__ for error in raised.value.exceptions] == [
        [f"with b = {b}, c = {c}, a = {a}"] for a, b, c, _ in tried[1:]
    ]


def test_no_case_is_no_test():
    with pytest.raises(AssertionError):
        each("a", [])(lambda a: None)()


class Case:
    """What `take_turns` asks of a test, all of one module."""

    path = Path("m.py")
    parent = type("Module", (), {"path": path})

    def __init__(self, name, n, **params):
        self.originalname, self.callspec = name, SimpleNamespace(params=params)
        self.marks = {} if n is None else {"by_turns": pytest.mark.by_turns(n).mark}

    def get_closest_marker(self, name):
        return self.marks.get(name)

    def add_marker(self, mark):
        self.marks[mark.name] = mark


def taken(*cases):
    take_turns(cases)
    return [(case.originalname, *case.callspec.params.values()) for case in cases if "exhaustive" not in case.marks]


def test_turns_take_one_in_n_and_every_value_of_a_short_list():
    grid = product("ab", [True, False], "xy")
    rows = taken(*(Case("one", 4, p=p, q=q, r=r) for p, q, r in grid))
    assert len(rows) == 2
    assert {value for _, *row in rows for value in row} == {"a", "b", True, False, "x", "y"}
    rows = taken(*(Case(name, 4, method=method) for name in ("one", "two") for method in "abc"))
    assert {name for name, _ in rows} == {"one", "two"} and len(rows) == 3
    assert {method for _, method in rows} == set("abc")  # though two tests alone take one each
    assert len(taken(*(Case("one", 4, law=law) for law in range(4 * FEW)))) == FEW  # of a long list its share alone
    always = [Case("always", None, method=method) for method in "ab"]
    assert taken(*always, *(Case("one", 3, method=method) for method in "abc"))[2:] == [("one", "c")]
