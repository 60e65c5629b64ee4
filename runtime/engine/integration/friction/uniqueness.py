"""When friction forces that change their own limits and accelerations exist and are unique.

Unknown are n friction forces T, each in one direction, and K magnitudes N that loads depend on. Of two solutions, with
differences d = |T - T'| and e = |N - N'|: N are magnitudes of linear functions of both, so that e <= S d + P e. A friction
that slides has T = mu g N with known sign, so that d <= mu g e. Of one that may stick either T has changed by no more than
its limit, d <= mu g e, or complementarity gives (a - a')(T - T') <= 0 for its sliding acceleration a = W T + G N + b, so that
W_ii d_i <= sum_j |W_ij| d_j + |G_i| e. In each case x <= Q x for x = (d, e) and one matrix Q >= 0. Where I - Q has positive
pivots it is an M-matrix, the spectral radius of Q is below 1, and x = 0: there is one solution at most. The same bound makes
T -> the force between its limits nearest to T - a/W_ii, N -> its magnitude, a contraction: there is one.

For one joint under its own reaction this is mu |dN/dT| < 1, Painleve's condition, which is sharp. Painleve, C. R. Acad. Sci.
121 (1895) 112; Cottle, Pang, Stone, The Linear Complementarity Problem (1992), section 3.3; Ortega, Rheinboldt, Iterative
Solution of Nonlinear Equations in Several Variables (1970), section 13.1.

Where the limits are known, sum (a - a')(T - T') <= 0 over all frictions that may stick. With x^2 = (T - T') W (T - T'), what
loads change of it is at most g e x, and reactions change by e <= s x + P e, where g and s are the sizes of G and S in the
metric of W: so x = 0, and nothing moves otherwise, where 1 - g (I - P)^-1 s > 0. W may be singular then.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca


def bound(still: Any, W: Any, G: Any, limits: Any, S: Any, P: Any) -> Any:
    """Return the matrix Q (n + K, n + K) of the bound.

    still (n): 1 for frictions that may stick, 0 for those that slide or do not touch; W (n, n); G (n, K): changes of the
    sliding accelerations by the friction forces and by the magnitudes' other loads; limits (n, K): of the limits by the
    magnitudes; S (K, n), P (K, K): of the reactions.
    """
    n, total = W.shape[0], W.shape[0] + P.shape[0]
    matrix = ca.SX.zeros(total, total)
    for i in range(n):
        own = ca.if_else(W[i, i] > 0, W[i, i], 0)  # what it cannot move has no bound
        for j in range(n):
            if j != i:
                matrix[i, j] = ca.if_else(still[i], ca.fabs(W[i, j]) / own, 0)
        for k in range(P.shape[0]):
            matrix[i, n + k] = ca.if_else(
                still[i], ca.fmax(ca.fabs(limits[i, k]), ca.fabs(G[i, k]) / own), limits[i, k]
            )
    matrix[n:, :n], matrix[n:, n:] = S, P
    return matrix


def pivots(Q: Any) -> Any:
    """Return the pivots (n) of I - Q without exchanges: positive where Q contracts, else one is not."""
    n = Q.shape[0]
    a = ca.SX.eye(n) - Q
    a = [[a[i, j] for j in range(n)] for i in range(n)]
    for k in range(n):
        for i in range(k + 1, n):
            if not a[i][k].is_zero():
                share = a[i][k] / a[k][k]
                for j in range(k + 1, n):
                    a[i][j] -= share * a[k][j]
    return ca.vertcat(*(a[k][k] for k in range(n)))


def reach(solve: Callable[[Any, Any, Any], Any], W: Any, still: Any, columns: Any) -> Any:
    """Return the sizes (m) of columns (n, m) in the metric of W; solve: (W, still, right) -> forces."""
    squares = [ca.dot(column, solve(W, still, column)) for column in ca.horzsplit(columns)]
    return ca.vertcat(ca.SX(0, 1), *(ca.sqrt(ca.fmax(square, 0)) for square in squares))


def monotone(g: Any, s: Any, P: Any) -> Any:
    """Return the margin 1 - g (I - P)^-1 s, for sizes g and s (K); not positive where it proves nothing."""
    n = P.shape[0]
    diagonal = pivots(ca.vertcat(ca.horzcat(P, s), ca.horzcat(g.T, ca.SX(1, 1))))
    positive = ca.SX(1)
    for i in range(n):
        positive *= diagonal[i] > 0
    return ca.if_else(positive, diagonal[n], -1)
