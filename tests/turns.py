"""Which cases of tests marked `by_turns` run in CI: every value of short lists, and of all in one test as little alike as can be."""

from collections import Counter, defaultdict
from zlib import crc32

import pytest

FEW = 8  # values of a parameter that all occur in CI, such as methods and coordinates; of laws, scenes, seeds there are more


def values(item):
    """Names and values of a case's parameters, by which one case is told to be like another."""
    params = item.callspec.params if hasattr(item, "callspec") else {}
    return {
        (name, repr(value) if isinstance(value, str | int | float | tuple) else id(value))
        for name, value in params.items()
    }


def take_turns(items):
    """Leave to CI one case in n of each test marked `by_turns(n)`, and every value of a parameter that has few in its module.

    It is always a case whose values its test, then its module, has had least.
    """
    turns, modules = defaultdict(list), defaultdict(Counter)
    for item in items:
        if not item.get_closest_marker("exhaustive"):
            mark, had = item.get_closest_marker("by_turns"), modules[item.path]
            had.update(dict.fromkeys(values(item), 0) if mark else values(item))
            if mark:
                turns[item.parent, item.originalname, mark.args[0]].append(item)
    spare = defaultdict(list)
    for (parent, name, n), alike in turns.items():
        test, module = Counter(), modules[parent.path]
        first = crc32(name.encode()) % len(alike)  # tests of the same methods begin with different ones of them
        left = alike[first:] + alike[:first]
        for _ in range(max(1, round(len(alike) / n))):
            case = min(left, key=lambda case: [sum(had[value] for value in values(case)) for had in (test, module)])
            left.remove(case)
            test.update(values(case))
            module.update(values(case))
        spare[parent.path] += left
    for path, left in spare.items():
        module = modules[path]
        several = Counter(name for name, _ in module)
        for case in left:
            if any(not module[name, value] and several[name] <= FEW for name, value in values(case)):
                module.update(values(case))
            else:
                case.add_marker(pytest.mark.exhaustive)
