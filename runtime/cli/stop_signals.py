"""Stop by a signal: from the first accepted step on, computing ends and results are written."""

from __future__ import annotations

import math
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    from hertzwerk.runtime.cli.terminal import Progress

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
AGAIN = 1.0  # s after which a signal counts as a second one, not as a repeated key stroke


class Stopping:
    """Context in which a signal only requests a stop once steps have been accepted.

    The first call reports that steps have been accepted. Calls pass the fraction done on to `progress`, and raise
    KeyboardInterrupt once a stop was requested. A later signal raises where it strikes.
    """

    def __init__(self, progress: Progress) -> None:
        self._progress, self._process = progress, os.getpid()
        self._before: dict[int, Any] = {}
        self._requested_at: float | None = None  # when [s]
        self._raises = False
        self._done, self._tries = math.inf, 0

    def __enter__(self) -> Self:
        if threading.current_thread() is threading.main_thread():
            before = {number: signal.getsignal(number) for number in SIGNALS}
            self._before = {number: handler for number, handler in before.items() if handler is not signal.SIG_IGN}
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for number, before in self._before.items():
            signal.signal(number, before)

    @property
    def requested(self) -> bool:
        """Return whether a stop was requested."""
        return self._requested_at is not None

    def __call__(self, fraction: float) -> None:
        """Take the fraction done of a run that has accepted steps."""
        if fraction < self._done:  # an accuracy is missed, and there are more runs to make than were foreseen
            self._tries += 1
            self._progress.stage("running" if self._tries == 1 else f"running, tolerance {self._tries}", fraction)
        self._done = fraction
        for number in self._before:
            if signal.getsignal(number) != self._on_signal:
                signal.signal(number, self._on_signal)
        if self.requested:
            raise KeyboardInterrupt
        self._progress(fraction)

    def stage(self, name: str) -> None:
        """Announce the stage that begins; a forked process has no terminal of its own."""
        if os.getpid() == self._process:
            self._progress.stage(name)

    @contextmanager
    def at_once(self) -> Iterator[None]:
        """Enter a context in which a signal raises KeyboardInterrupt at once, because nothing can be lost."""
        self._raises = True
        try:
            yield
        finally:
            self._raises = False

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        again = self._requested_at is not None and now - self._requested_at > AGAIN
        if self._requested_at is None:
            self._requested_at = now
            if (
                sys.stderr.isatty() and os.getpid() == self._process
            ):  # not by print: the signal may have come while it was printing
                os.write(2, b"\nstopping: the results so far are written; another signal discards them\n")
        if self._raises or again:
            raise KeyboardInterrupt
