"""Contact forces of many pairs: evaluated block by block, and only blocks in which a pair is in contact.

A conditional call costs about as much as one pair's force, so that a block of a few pairs is decided at once.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.step.classes import masked
from hertzwerk.runtime.integrate.step.layout import CONTACT
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model

BLOCK = 8  # pairs


@per_model
def contact_sum(model: Model) -> Any:
    """Build the function (t, q, u, z, mode, m, c) -> generalised force, dz, and per pair normal force and in_range.

    The first two are summed over the pairs in contact; of the others the force is 0 and in_range is 1. MX.
    """
    given = t, q, u, z, mode, m, c = model.symbols("t q u z mode m c", ca.MX)
    blocks = _blocks(model)
    results = []
    for pairs, touches in zip(blocks, _touches(blocks, mode), strict=True):
        results.append(_lazy(_block(model, pairs), [0.0, 0.0, 0.0, 1.0], touches, (t, q, u, z, mode[pairs], m, c)))
    *summed, forces, in_range = zip(*results, strict=True)
    totals = [_total(parts) for parts in summed]
    return ca.Function("contact_sum", given, [*totals, ca.vertcat(*forces), ca.vertcat(*in_range)])


@per_model
def force_rates(model: Model) -> Any:
    """Build the function (t, y, dy, mode, m, c) -> rates of the normal forces (k) along dy/dt; 0 without contact. MX."""
    t, y, dy, mode, m, c = given = _with_rates(model, ca.MX)
    blocks = _blocks(model)
    rates = [
        *(
            _lazy(_block_rates(model, pairs), [0.0], touches, (t, y, dy, mode[pairs], m, c))[0]
            for pairs, touches in zip(blocks, _touches(blocks, mode), strict=True)
        )
    ]
    return ca.Function("force_rates", given, [ca.vertcat(*rates)])


def _with_rates(model: Model, kind: Any) -> list[Any]:
    t, y, dy, mode, m, c = model.symbols("t y y mode m c", kind)
    return [t, y, dy, mode, m, c]


def _blocks(model: Model) -> list[list[int]]:
    return [list(range(first, min(first + BLOCK, model.k))) for first in range(0, model.k, BLOCK)]


def _touches(blocks: list[list[int]], mode: Any) -> list[Any]:
    """Return of each block how many of its pairs are in contact."""
    within = ca.DM.zeros(len(blocks), mode.numel())
    for i, pairs in enumerate(blocks):
        within[i, pairs] = 1
    return ca.vertsplit(ca.mtimes(ca.sparsify(within), mode == CONTACT))


def _lazy(function: Any, otherwise: list[float], condition: Any, given: tuple[Any, ...]) -> list[Any]:
    """Return the results of a function where a condition holds, else constants."""
    shapes = [function.sparsity_out(i) for i in range(function.n_out())]
    constants = [ca.MX(ca.DM(shape, x)) for shape, x in zip(shapes, otherwise, strict=True)]
    apart = ca.Function("apart", function.mx_in(), constants)
    found: list[Any] = ca.Function.if_else("block", function, apart).call([condition > 0, *given])
    return found


def _total(parts: tuple[Any, ...]) -> Any:
    """Return the sum of sparse columns as a dense one, by one operation."""
    rows = [row for part in parts for row in part.sparsity().row()]
    ones = ca.DM.triplet(rows, range(len(rows)), ca.DM.ones(len(rows)), parts[0].numel(), len(rows))
    return ca.densify(ca.mtimes(ones, ca.vertcat(*(part.nz[:] for part in parts))))


def _block(model: Model, pairs: list[int]) -> Any:
    t, q, u, z, m, c = model.symbols("t q u z m c")
    mode = ca.SX.sym("mode", len(pairs))
    f, dz = ca.SX(model.function("applied").numel_out(0), 1), ca.SX(model.nz, 1)
    forces, in_range = [], []
    for i, j in enumerate(pairs):
        active = mode[i] == CONTACT
        f_j, dz_j, normal, _, valid, *_ = model.function(f"contact_{model.pairs[j]}")(t, q, u, z, m, c)
        f += masked(active, ca.sparsify(f_j))
        dz += masked(active, ca.sparsify(dz_j))
        forces.append(masked(active, normal))
        in_range.append(masked(active, valid, 1))
    results = [f, dz, ca.densify(ca.vertcat(*forces)), ca.densify(ca.vertcat(*in_range))]
    return ca.Function("touching", [t, q, u, z, mode, m, c], ca.cse(results))


def _block_rates(model: Model, pairs: list[int]) -> Any:
    t, y, dy, _, m, c = given = _with_rates(model, ca.SX)
    q, u, z = model.parts(y)
    mode = given[3] = ca.SX.sym("mode", len(pairs))
    normals = [model.function(f"contact_{model.pairs[j]}")(t, q, u, z, m, c)[2] for j in pairs]
    active = ca.vertcat(*(masked(mode[i] == CONTACT, normal) for i, normal in enumerate(normals)))
    rates = ca.jtimes(active, ca.vertcat(t, y), ca.vertcat(1, dy))
    return ca.Function("touching_rates", given, ca.cse([ca.densify(rates)]))
