"""Some entries of a vector, chosen at run time: their places, and sums at places."""

from __future__ import annotations

from typing import Any

import casadi as ca

BLOCK = 16  # entries added up by one product with a triangle


def places_of(wanted: Any, most: int) -> Any:
    """Return the places of the first `most` ones in a vector (MX); its length where there are fewer."""
    n = wanted.numel()
    rank = running_sum(wanted)
    return added(ca.MX(ca.DM([n] * most)), ca.if_else(wanted, rank, 0) - 1, ca.DM(range(n)) - n)


def added(vector: Any, places: Any, values: Any) -> Any:
    """Return a vector (MX) to which values were added at places, one after another.

    Places that it does not have are passed over.
    """
    x = ca.MX.sym("x", vector.numel())
    taken = x[places] if isinstance(places, list) else x.get_nz(False, places)
    return ca.jtimes(ca.vertcat(x, taken), x, ca.vertcat(vector, values), True)


def running_sum(x: Any) -> Any:
    """Return the sums of a vector (MX) up to each of its entries."""
    n = x.numel()
    if n <= BLOCK:
        return ca.mtimes(ca.DM(ca.Sparsity.lower(n), 1), x)
    blocks = -(-n // BLOCK)
    padded = ca.vertcat(x, ca.DM.zeros(blocks * BLOCK - n))
    within = ca.mtimes(ca.DM(ca.Sparsity.lower(BLOCK), 1), ca.reshape(padded, BLOCK, blocks))
    totals = within[-1, :].T
    before = running_sum(totals) - totals
    return ca.vec(within + ca.repmat(before.T, BLOCK, 1))[:n]
