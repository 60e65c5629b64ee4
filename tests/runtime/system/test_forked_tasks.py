"""Tasks side by side: every one is done once, by several processes, and one that ends takes nothing else with it."""

import multiprocessing
import os
import signal
import time
from functools import partial

import pytest

from hertzwerk.runtime.system import forked_tasks as module
from hertzwerk.runtime.system.forked_tasks import side_by_side

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="no processes to fork")


def slowly(number):
    time.sleep(0.02)
    return number, os.getpid()


@pytest.mark.parametrize("cores", [1, 2, 3])
def test_every_task_is_done_once(monkeypatch, cores):
    monkeypatch.setattr(module, "cores", lambda: cores)
    done = side_by_side([partial(slowly, number) for number in range(12)])
    assert {i: number for i, (number, _) in done.items()} == {i: i for i in range(12)}
    assert len({process for _, process in done.values()}) == cores


def test_a_process_that_ends_loses_its_tasks_alone(monkeypatch):
    monkeypatch.setattr(module, "cores", lambda: 2)
    here = os.getpid()

    def fatal(number):
        if os.getpid() != here:
            os.kill(os.getpid(), signal.SIGKILL)
        return slowly(number)

    done = side_by_side([partial(fatal, number) for number in range(6)])
    assert 0 < len(done) < 6
    assert all(number == i for i, (number, _) in done.items())


def refuse():
    here = os.getpid()

    def refused(number):
        if os.getpid() == here:
            raise ValueError("refused")
        return slowly(number)

    with pytest.raises(ValueError, match="refused"):
        side_by_side([partial(refused, number) for number in range(20)])
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def test_errors_of_tasks_are_raised_and_no_process_is_left(monkeypatch):
    """Tried in a process of its own: this one may have servers of `multiprocessing` as children, by another test."""
    monkeypatch.setattr(module, "cores", lambda: 2)
    own = multiprocessing.get_context("fork").Process(target=refuse)
    own.start()
    own.join()
    assert own.exitcode == 0


def test_the_first_task_is_done_here(monkeypatch):
    """Its stage is shown on the terminal, which other processes have not."""
    monkeypatch.setattr(module, "cores", lambda: 3)
    for _ in range(5):
        assert side_by_side([os.getpid] * 3)[0] == os.getpid()
    assert side_by_side([]) == {}
