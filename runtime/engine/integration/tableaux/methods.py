"""The integration methods by name.

Input, help, scenarios, studies, hard cases and pictures read this list.
A method of one's own is a function that returns its table, and one line here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta, dop853, dopri5
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import (
    DiagonallyImplicit,
    Rosenbrock,
    esdirk54,
    rodas5p,
)

Table: TypeAlias = RungeKutta | Rosenbrock | DiagonallyImplicit
Tables: TypeAlias = tuple[Callable[[], Table], ...]

EXPLICIT: dict[str, Tables] = {"dopri5": (dopri5,), "dop853": (dop853,)}  # of rising order
IMPLICIT: dict[str, Tables] = {"rodas": (rodas5p,), "esdirk": (esdirk54,)}
AUTOMATIC: dict[str, Tables] = {"auto": (dop853, esdirk54)}  # to choose from while a run goes on (`method_choice`)
# their dense output; they run in `sundials`
SUNDIALS: dict[str, Tables] = dict.fromkeys(("cvodes", "idas"), (esdirk54,))

IN_GRAPH = EXPLICIT | IMPLICIT | AUTOMATIC
METHODS = IN_GRAPH | SUNDIALS
