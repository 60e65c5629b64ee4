"""Tests of many cases: all are tried, those that fail are named, and one that has none is no test."""

import pytest
from each import each


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
