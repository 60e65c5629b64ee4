"""Settings of all tests."""

import signal

import pytest
from hypothesis import settings

settings.register_profile("hertzwerk", deadline=None)  # a deadline would measure the machine's load
settings.load_profile("hertzwerk")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell leaves it to what it runs in the background
    signal.signal(signal.SIGINT, signal.default_int_handler)

EXHAUSTIVE_S = 3600


def pytest_collection_modifyitems(items):
    for item in items:
        if item.get_closest_marker("exhaustive") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(EXHAUSTIVE_S))
