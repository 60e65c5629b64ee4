"""Entry point of the command `hertzwerk`: Ctrl-C ends it at once until there are results to keep."""

from __future__ import annotations

import gc
import signal
import sys

COLLECTED = 50_000  # new objects between two collections: a tenth of the time of imports is saved


def start() -> None:
    """Run the command line.

    As long as no results could be lost, SIGINT keeps its default action: a Python handler would have to wait for the
    end of a call of CasADi, which builds functions for seconds, and its exceptions are dropped there now and then. An
    ignored SIGINT stays ignored.
    """
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    gc.set_threshold(COLLECTED)
    try:
        from hertzwerk.runtime.cli import main
    except ModuleNotFoundError as error:
        if error.name != "click":
            raise
        sys.exit("error  the command hertzwerk needs click, which is not installed: pip install click")
    main()
