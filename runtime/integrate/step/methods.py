"""Integration methods by name, with their tableaux, and one step of any of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

from hertzwerk.runtime.integrate.step import explicit, implicit
from hertzwerk.runtime.integrate.step.redundant import reduced
from hertzwerk.runtime.integrate.tableaux.explicit_tableaux import RungeKutta, dop853, dopri5
from hertzwerk.runtime.integrate.tableaux.implicit_tableaux import DiagonallyImplicit, Rosenbrock, esdirk54, rodas5p

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.step.classes import Contacts
    from hertzwerk.runtime.model.model import Model

Table: TypeAlias = RungeKutta | Rosenbrock | DiagonallyImplicit
Take: TypeAlias = Callable[[Mapping[str, Any], Mapping[str, Any], Any], dict[str, Any]]

SUNDIALS = ("cvodes", "idas")  # run outside the graph (`sundials`); the table is that of their dense output
# One table, or an explicit and an implicit one to choose from while a run goes on (`choose`).
METHODS: dict[str, tuple[Callable[[], Table], ...]] = {
    "dopri5": (dopri5,),
    "dop853": (dop853,),
    "rodas": (rodas5p,),
    "esdirk": (esdirk54,),
    "auto": (dop853, esdirk54),
    **dict.fromkeys(SUNDIALS, (esdirk54,)),
}


def stepper(model: Model, table: Table, contacts: Contacts, seen: dict[str, Any] | None = None) -> Take:
    """Return (start, run, h) -> trial: one step of h [s] with the forces of these contacts.

    `seen` as in `explicit.stepped`.
    """
    right, within = explicit.flow(model, contacts), reduced(model)
    if isinstance(table, RungeKutta):
        return lambda start, run, h: explicit.stepped(table, right, start, within(start, run), h, seen)
    take = implicit.stepper(model, table, right, contacts)
    return lambda start, run, h: take(start, within(start, run), h, seen)
