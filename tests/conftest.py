"""Settings of all tests."""

import signal
from collections import Counter

import pytest
from hypothesis import settings

settings.register_profile("hertzwerk", deadline=None)  # a deadline would measure the machine's load
settings.load_profile("hertzwerk")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell leaves it to what it runs in the background
    signal.signal(signal.SIGINT, signal.default_int_handler)

EXHAUSTIVE_S = 3600


def pytest_collection_modifyitems(items):
    seen = Counter()
    for item in items:
        turns = item.get_closest_marker("by_turns")
        if turns is not None:
            if seen[item.parent, item.originalname] % turns.args[0]:
                item.add_marker(pytest.mark.exhaustive)
            seen[item.parent, item.originalname] += 1
        if item.get_closest_marker("exhaustive") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(EXHAUSTIVE_S))
