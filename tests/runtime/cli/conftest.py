"""Settings of the tests of commands."""

from functools import partial

import pytest
from commands import called


@pytest.fixture
def hertzwerk(request, tmp_path, monkeypatch):
    """Call a command line in an empty folder and check its exit code; all those of a module begin with its COMMAND."""
    monkeypatch.chdir(tmp_path)
    return partial(called, *getattr(request.module, "COMMAND", ()))
