"""Where the command `hertzwerk` begins: Ctrl-C ends it at once, at every moment, until there is something to keep."""

from __future__ import annotations

import signal


def start() -> None:
    """Run the command line.

    As long as nothing is computed that could be lost, SIGINT is the system's to deal with: a handler of Python's would have to wait for the end of
    a call of CasADi's, which builds functions for seconds, and what it raises there is dropped now and then. A SIGINT that is ignored stays so.
    """
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from hertzwerk.runtime.cli import main

    main()
