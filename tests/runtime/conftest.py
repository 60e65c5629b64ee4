"""Settings of the tests of runs."""

from functools import partial

import pytest
from commands import called

from hertzwerk.runtime.engine.integration.loop import c_compilation
from hertzwerk.runtime.loading import engine_model


@pytest.fixture(autouse=True)
def little_optimised():
    """Compile in a third of the time: what -O1 makes is compared in engine/integration/step/test_engine.py, what -O3 makes in hard_cases/."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(c_compilation, "FLAGS", (*c_compilation.FLAGS, "-O0"))  # the last one counts
        yield


@pytest.fixture(scope="session")
def ball():
    """Model of the bouncing ball, whose functions are built once for all tests of a process."""
    return engine_model("bouncing_ball")


@pytest.fixture(scope="session")
def crank():
    """Model of the slider-crank, shared as `ball` is."""
    return engine_model("slider_crank")


@pytest.fixture
def hertzwerk(request, own_folder):
    """Call a command line in an empty folder and check its exit code; all those of a module begin with its COMMAND."""
    return partial(called, *getattr(request.module, "COMMAND", ()))
