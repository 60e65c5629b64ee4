"""Gaps and contact forces of many pairs, by operations on vectors over those that are alike."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.alike.kinds import alike, over_items
from hertzwerk.runtime.integrate.step.classes import masked
from hertzwerk.runtime.integrate.step.layout import CONTACT
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model


@per_model
def of_pairs(model: Model, name: str) -> Any:
    """Return a function of the module with results for each pair, by operations on vectors (MX)."""
    return over_items(model.function(name))


@per_model
def stored_energies(model: Model) -> Any:
    """Return the function (t, q, u, c) -> elastic energies (k) [J] of the pairs (MX)."""
    given = model.symbols("t q u c")
    _, _, stored = model.function("energy")(*given)
    return over_items(ca.Function("stored", given, [stored]))


@per_model
def energies_of_bodies(model: Model) -> Any:
    """Return the function (t, q, u, c) -> kinetic and potential energy [J] without that of the pairs."""
    given = model.symbols("t q u c")
    return ca.Function("energies", given, model.function("energy").call(given)[:2])


@per_model
def contact_sum(model: Model) -> Any:
    """Build the function (t, y, mode, m, c) -> contact forces (MX).

    Results: generalised force and dz of all contacts; normal force and in_range (k). Without contact the force of a
    pair is 0 and in_range is 1. None where pairs are not alike.
    """
    t, y, mode, m, c = given = model.symbols("t y mode m c")
    q, u, z = model.parts(y)
    nf = model.function("applied").numel_out(0)
    items: list[Any] = []
    rows: list[list[int]] = []
    for j, pair in enumerate(model.pairs):
        active = mode[j] == CONTACT
        f, dz, normal, _, valid, *_ = model.function(f"contact_{pair}")(t, q, u, z, m, c)
        f, dz = ca.sparsify(f), ca.sparsify(dz)
        rows.append([*f.sparsity().row(), *(nf + row for row in dz.sparsity().row())])
        entries = ca.vertcat(ca.SX(0, 1), *f.nonzeros(), *dz.nonzeros(), normal)
        items.append(ca.vertcat(masked(active, entries), masked(active, valid, 1)))
    found = alike(given, items)
    if found is None:
        return None
    symbols = model.symbols("t y mode m c", ca.MX)
    known = found.known(ca.vertcat(*symbols))
    columns: list[Any] = [ca.MX(0, 1)]
    places: list[int] = []
    normals, valids = [], []
    for kind in found.kinds:
        *moved, normal, valid = kind.results(known)
        columns += moved
        places += [rows[item][i] for i in range(len(moved)) for item in kind.items]
        normals.append(normal)
        valids.append(valid)
    summing = ca.DM.triplet(places, range(len(places)), ca.DM.ones(len(places)), nf + model.nz, len(places))
    total = ca.densify(ca.mtimes(summing, ca.vertcat(*columns)))
    order = found.order
    results = [total[:nf], total[nf:], ca.vertcat(*normals)[order], ca.vertcat(*valids)[order]]
    return ca.Function("contact_sum", symbols, results)


@per_model
def force_rates(model: Model) -> Any:
    """Build the function (t, y, dy, mode, m, c) -> rates (k) of the normal forces along dy/dt (MX).

    0 without contact.
    """
    t, y, dy, mode, m, c = given = model.symbols("t y y mode m c")
    q, u, z = model.parts(y)
    normals = [model.function(f"contact_{pair}")(t, q, u, z, m, c)[2] for pair in model.pairs]
    active = ca.vertcat(*(masked(mode[j] == CONTACT, normal) for j, normal in enumerate(normals)))
    rates = ca.cse(ca.densify(ca.jtimes(active, ca.vertcat(t, y), ca.vertcat(1, dy))))
    return over_items(ca.Function("force_rates", given, [rates]))
