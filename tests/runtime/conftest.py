"""Settings of the tests of runs."""

import pytest

from hertzwerk.runtime.integrate.loop import compiled


@pytest.fixture(autouse=True)
def little_optimised(monkeypatch):
    """Compile in half the time: what -O3 makes is compared in hard_cases/, of runs that are longer."""
    monkeypatch.setattr(compiled, "LARGE", 0)
