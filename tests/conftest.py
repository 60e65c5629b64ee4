"""Settings of all tests."""

import contextlib
import fcntl
import gc
import pickle
import signal
from pathlib import Path

import pytest
from hypothesis import settings
from turns import take_turns

settings.register_profile("hertzwerk", deadline=None, max_examples=30)  # a deadline would measure the machine's load
settings.load_profile("hertzwerk")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell leaves it to what it runs in the background
    signal.signal(signal.SIGINT, signal.default_int_handler)

EXHAUSTIVE_S = 3600
MODELS = 16  # some MB each
HERE = Path(__file__).parent
LAST = "test_a_type_checker_sees_what_the_names_are"  # by then mypy, which .ci/run has beside, has read the package

gc.disable()  # modules stay: to look for garbage among them, while they are read and ever after, takes 7 % of the time


def pytest_collection_finish():
    gc.freeze()
    gc.set_threshold(10_000, 10, 10)
    gc.enable()


class Models(dict):
    """Models of built-in scenes by name, with the functions built for them, and the names that were loaded."""

    def __init__(self, load):
        self.load, self.loaded = load, set()

    def __call__(self, name):
        self.loaded.add(name)
        return self[name]

    def __missing__(self, name):
        if len(self) == MODELS:
            del self[next(iter(self))]
        return self.setdefault(name, self.load(name))


@pytest.fixture(autouse=True, scope="session")
def shared_models():
    from hertzwerk.runtime import loading

    loading._built_in = Models(loading._built_in.__wrapped__)
    return loading._built_in


@pytest.fixture(autouse=True)
def built_in_models(request, shared_models):
    """Share models of built-in scenes, but not with a test that plants faults, nor those that a test compiled."""
    from hertzwerk.runtime import loading
    from hertzwerk.runtime.engine.integration.loop import c_compilation

    class Program(c_compilation.Program):
        def __init__(self, *functions, **options):
            compiled.append(functions)
            super().__init__(*functions, **options)

    compiled, alone = [], "monkeypatch" in request.fixturenames
    shared_models.loaded.clear()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(c_compilation, "Program", Program)
        if alone:
            patch.setattr(loading, "_built_in", Models(shared_models.load))
        yield
    for name in shared_models.loaded if compiled else ():
        shared_models.pop(name, None)


@pytest.fixture
def own_folder(tmp_path):
    """Work in an empty folder; unlike `monkeypatch.chdir`, with the models that other tests built."""
    with contextlib.chdir(tmp_path):
        yield tmp_path


@pytest.fixture(scope="session")
def restitutions(tmp_path_factory, worker_id):
    """Restitution of all damping laws, as the study computes it, by the first process that asks."""
    from hertzwerk.runtime.engine.model.build import impact_trials
    from hertzwerk.runtime.studies.paper.study_restitution import returned

    folder = tmp_path_factory.getbasetemp()
    file = (folder if worker_id == "master" else folder.parent) / "restitutions"
    with file.open("a+b") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        if not file.stat().st_size:
            stream.write(pickle.dumps([returned(trial) for trial in impact_trials()]))
            stream.flush()
        stream.seek(0)
        return pickle.load(stream)


def pytest_collection_modifyitems(items):
    take_turns(items)
    for item in items:
        if item.get_closest_marker("exhaustive") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(EXHAUSTIVE_S))
    # the longest test is beside this file: last, it would leave a core idle
    items.sort(key=lambda item: (item.name == LAST, item.path.parent != HERE))
