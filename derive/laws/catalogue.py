"""Catalogue of all contact laws by name."""

from __future__ import annotations

from hertzwerk.derive.laws import damping, friction, line, logarithmic, lubrication, reconstruction, stiffness
from hertzwerk.derive.laws.law import Law

LAWS: dict[str, Law] = {
    law.name: law
    for module in (stiffness, logarithmic, line, reconstruction, damping, friction, lubrication)
    for law in vars(module).values()
    if isinstance(law, Law)
}
