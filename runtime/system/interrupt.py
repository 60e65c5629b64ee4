"""Ctrl-C handled between calls of CasADi, never inside one.

CasADi's Python layer drops many of the exceptions that a signal handler raises there.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING or sys.version_info >= (3, 12):
    from signal import signal as handle
else:  # what that wraps: before Python 3.12 it takes as long as 30 steps to see that a function is no constant
    from _signal import signal as handle

_waiting: list[Callable[[], object]] = []


def poll() -> None:
    """Deliver a SIGINT held back by `defer_interrupts`; for long operations without access to it."""
    if _waiting and threading.current_thread() is threading.main_thread():
        _waiting[-1]()


@contextmanager
def polled(by: Callable[[], object]) -> Iterator[None]:
    """Have `poll` call a function, such as one that keeps to a limit of time."""
    _waiting.append(by)
    try:
        yield
    finally:
        _waiting.remove(by)


@contextmanager
def defer_interrupts() -> Iterator[Callable[[], None]]:
    """Defer SIGINT until the yielded function is called or the context is left.

    The previous handler then receives it. Nothing changes in a thread other than the main one, nor where SIGINT has
    no Python handler: it ends the process, or is ignored.
    """
    if threading.current_thread() is not threading.main_thread():
        yield lambda: None
        return
    received: list[tuple[int, FrameType | None]] = []

    def wait(*arguments: object) -> None:
        received.append(arguments)  # type: ignore[arg-type]

    before = handle(signal.SIGINT, wait)
    if not callable(before):
        handle(signal.SIGINT, before)
        yield lambda: None
        return
    handler = before

    def poll() -> None:
        if received:
            first = received[0]
            received.clear()
            handler(*first)

    _waiting.append(poll)
    try:
        yield poll
    finally:
        _waiting.remove(poll)
        last = handle(signal.SIGINT, before)
        if last is not wait:  # whoever has put another in its place wants that
            handle(signal.SIGINT, last)
    poll()


@contextmanager
def raise_interrupts() -> Iterator[None]:
    """Make SIGINT raise KeyboardInterrupt where it would kill the process, to end child processes too."""
    main = threading.current_thread() is threading.main_thread()
    if not main or signal.getsignal(signal.SIGINT) is not signal.SIG_DFL:
        yield
        return
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
