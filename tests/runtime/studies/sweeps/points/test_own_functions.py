"""Digests of own functions: another for another result, the same for another layout."""

import functools
import math

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.studies.sweeps.points.own_functions import digest


def defined(source, name="f"):
    namespace = {"__name__": "mine", "np": np, "math": math}
    exec(source, namespace)
    return digest("f", namespace[name])


PLAIN = "def f(run):\n    return np.ptp(run['x'])\n"


@pytest.mark.parametrize(
    "other",
    [
        "def f(run):\n\n    # of the slider\n    return np.ptp(\n        run['x'],\n    )\n",
        "unused = 3\n" + PLAIN,
    ],
)
def test_layout_comments_and_what_is_not_used_do_not_matter(other):
    assert defined(other) == defined(PLAIN)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (PLAIN, "def f(run):\n    return np.ptp(run['y'])\n"), (PLAIN, "def f(run):\n    return np.max(run['x'])\n"),
        ("def f(run, k=1):\n    return k\n", "def f(run, k=2):\n    return k\n"),
        ("K = 1.0\ndef f(run):\n    return K\n", "K = 2.0\ndef f(run):\n    return K\n"),
        ("def g(x):\n    return x\ndef f(run):\n    return g(run)\n", "def g(x):\n    return -x\ndef f(run):\n    return g(run)\n"),
        ("T = np.zeros(3)\ndef f(run):\n    return T\n", "T = np.ones(3)\ndef f(run):\n    return T\n"),
        ("f = lambda run: (lambda x: x + 1)(run)\n", "f = lambda run: (lambda x: x + 2)(run)\n"),
        ("def h(k):\n    return lambda run: k\nf = h(1)\n", "def h(k):\n    return lambda run: k\nf = h(2)\n"),
        ("f = lambda run: run in {'a', 'b'}\n", "f = lambda run: run in {'a', 'c'}\n"),
    ],
)  # fmt: skip
def test_changes_of_the_result_change_the_digest(one, other):
    assert defined(one) == defined(one)
    assert defined(one) != defined(other)


def test_functions_that_call_each_other_partial_ones_and_those_of_packages():
    recursive = "def g(n):\n    return f(n)\ndef f(n):\n    return g(n - 1) if n else math.pi\n"
    assert defined(recursive) == defined(recursive)
    assert digest("f", functools.partial(max, 1)) != digest("f", functools.partial(max, 2))
    assert digest("f", np.max) == digest("f", np.max) != digest("f", np.min)
    with pytest.raises(InputError, match="a value of type object, enclosed or used"):
        defined("K = object()\ndef f(run):\n    return K\n")
