"""Ctrl-C heeded between two calls of CasADi, never inside one: its Python layer drops many of the exceptions that a signal's handler raises there."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

_waiting: list[Callable[[], None]] = []


def heed() -> None:
    """Heed a SIGINT that `deferred` put off, if there is one: for what takes long and is not told of it."""
    if _waiting and threading.current_thread() is threading.main_thread():
        _waiting[-1]()


@contextmanager
def deferred() -> Iterator[Callable[[], None]]:
    """SIGINT waits until the function that this gives is called, or it is left; then the handler of before has it.

    Nothing changes in another thread than the main one, nor where SIGINT has no handler of Python's: it ends the process, or is ignored.
    """
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        yield lambda: None
        return
    received: list[tuple[int, FrameType | None]] = []

    def wait(*arguments: object) -> None:
        received.append(arguments)  # type: ignore[arg-type]

    def heed() -> None:
        if received:
            first = received[0]
            received.clear()
            before(*first)

    signal.signal(signal.SIGINT, wait)
    _waiting.append(heed)
    try:
        yield heed
    finally:
        _waiting.remove(heed)
        if signal.getsignal(signal.SIGINT) is wait:  # whoever has put another in its place wants that
            signal.signal(signal.SIGINT, before)
    heed()


@contextmanager
def raised() -> Iterator[None]:
    """SIGINT raises KeyboardInterrupt where the process would die of it: what is waited for here, other processes, has to be ended as well."""
    main = threading.current_thread() is threading.main_thread()
    if not main or signal.getsignal(signal.SIGINT) is not signal.SIG_DFL:
        yield
        return
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
