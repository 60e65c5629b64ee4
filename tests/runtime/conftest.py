"""Settings of the tests of runs."""

import pytest

from hertzwerk.runtime.integrate.loop import compiled


@pytest.fixture(autouse=True)
def little_optimised(monkeypatch):
    """Compile in a third of the time: what -O1 makes is compared in integrate/test_engine.py, what -O3 makes in hard_cases/."""
    monkeypatch.setattr(compiled, "FLAGS", (*compiled.FLAGS, "-O0"))  # the last one counts
