"""Settings of all tests."""

import fcntl
import pickle
import signal
from collections import defaultdict
from pathlib import Path
from zlib import crc32

import pytest
from hypothesis import settings

settings.register_profile("hertzwerk", deadline=None, max_examples=50)  # a deadline would measure the machine's load
settings.load_profile("hertzwerk")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell leaves it to what it runs in the background
    signal.signal(signal.SIGINT, signal.default_int_handler)

EXHAUSTIVE_S = 3600
HERE = Path(__file__).parent


@pytest.fixture(scope="session")
def restitutions(tmp_path_factory, worker_id):
    """The restitution study of all damping laws, computed by the first process that asks."""
    from hertzwerk.runtime.validate.restitution import study

    folder = tmp_path_factory.getbasetemp()
    file = (folder if worker_id == "master" else folder.parent) / "restitutions"
    with file.open("a+b") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        if not file.stat().st_size:
            stream.write(pickle.dumps(study()))
            stream.flush()
        stream.seek(0)
        return pickle.load(stream)


def pytest_collection_modifyitems(items):
    turns = defaultdict(list)
    for item in items:
        mark = item.get_closest_marker("by_turns")
        if mark is not None and not item.get_closest_marker("exhaustive"):
            turns[item.parent, item.originalname, mark.args[0]].append(item)
    for (_, name, n), alike in turns.items():
        first = crc32(name.encode()) % min(n, len(alike))  # tests of the same methods take different ones of them
        for i, item in enumerate(alike):
            if (i - first) % n:
                item.add_marker(pytest.mark.exhaustive)
    for item in items:
        if item.get_closest_marker("exhaustive") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(EXHAUSTIVE_S))
    items.sort(key=lambda item: item.path.parent != HERE)  # the longest test is there: last, it would leave a core idle
