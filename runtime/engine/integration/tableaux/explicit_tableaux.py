"""Coefficients of explicit Runge-Kutta methods; order conditions are checked on construction."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import combinations_with_replacement
from math import prod
from typing import TypeAlias

import numpy as np

TOLERANCE = 2e-14  # of an order condition, relative to the sum of its absolute terms: published digits plus rounding

Tree: TypeAlias = tuple["Tree", ...]  # a root's subtrees, sorted; a single node is ()


@cache
def trees(nodes: int) -> tuple[Tree, ...]:
    """Return all rooted trees of a number of nodes, each once."""
    return tuple(_forests(nodes - 1, nodes - 1))


def _forests(nodes: int, largest: int) -> Iterator[Tree]:
    """Yield the multisets of trees with `nodes` nodes together, none with more than `largest`."""
    if nodes == 0:
        yield ()
        return
    for size in range(min(nodes, largest), 0, -1):
        for count in range(1, nodes // size + 1):
            for rest in _forests(nodes - count * size, size - 1):
                for chosen in combinations_with_replacement(trees(size), count):
                    yield (*chosen, *rest)


@cache
def _size(tree: Tree) -> int:
    return 1 + sum(map(_size, tree))


@cache
def _density(tree: Tree) -> int:
    """Return gamma(tree): the product of the node counts of the tree and all its subtrees."""
    return _size(tree) * prod(map(_density, tree))


@dataclass(frozen=True)
class ErrorEstimate:
    """Difference to an embedded solution of `order`: weights over the stages and the end derivative."""

    weights: tuple[float, ...]
    order: int


@dataclass(frozen=True)
class RungeKutta:
    """Explicit Runge-Kutta method of s stages.

    The derivative at the end of the step, needed for the events anyway, counts as stage s + 1.
    """

    name: str
    order: int
    A: tuple[tuple[float, ...], ...]
    b: tuple[float, ...]
    c: tuple[float, ...]
    errors: tuple[ErrorEstimate, ...]

    def __post_init__(self) -> None:
        s = len(self.b)
        shapes = [len(row) for row in self.A] == list(range(s)) and len(self.c) == s
        if not shapes or any(len(error.weights) != s + 1 for error in self.errors):
            raise ValueError(
                f"{self.name}: the rows of A must have 0, 1, ..., {s - 1} entries, c {s}, error weights {s + 1}"
            )
        A = np.zeros((s + 1, s + 1))
        for i, row in enumerate((*self.A, self.b)):
            A[i, : len(row)] = row
        require(f"{self.name}: row sums of A equal c", A.sum(1), np.array([*self.c, 1.0]), np.abs(A).sum(1) + 1)
        require_order(f"{self.name}: b", A, np.array([*self.b, 0.0]), self.order, solution=True)
        for error in self.errors:
            if not any(error.weights):
                raise ValueError(f"{self.name}: error weights are all zero")
            require_order(f"{self.name}: error weights", A, np.array(error.weights), error.order, solution=False)

    @property
    def stages(self) -> int:
        """Evaluations of the right-hand side per step."""
        return len(self.b)

    @property
    def error_order(self) -> int:
        """Power of the step in the error norm; two estimates combine to the method's own order (Hairer)."""
        return self.order if len(self.errors) > 1 else self.errors[0].order + 1


def require_order(
    claim: str, A: np.ndarray, weights: np.ndarray, order: int, *, solution: bool, several: np.ndarray | None = None
) -> None:
    """Raise unless the weights meet every condition up to the order.

    The conditions are 1/gamma for a solution, 0 for an error estimate.
    """
    known: dict[tuple[Tree, bool], np.ndarray] = {}  # matrix @ Phi(tree)

    def elementary(tree: Tree) -> np.ndarray:
        phi = np.ones(len(weights))
        branches = len(tree) > 1 and several is not None
        for branch in tree:
            if (branch, branches) not in known:
                known[branch, branches] = (several if branches else A) @ elementary(branch)
            phi = phi * known[branch, branches]
        return phi

    for nodes in range(1, order + 1):
        phi = np.array([elementary(tree) for tree in trees(nodes)])
        expected = np.array([1 / _density(tree) if solution else 0.0 for tree in trees(nodes)])
        require(
            f"{claim} meet the conditions of order {nodes}", phi @ weights, expected, np.abs(phi) @ np.abs(weights) + 1
        )


def require(claim: str, found: np.ndarray, expected: np.ndarray, magnitude: np.ndarray) -> None:
    """Raise unless found equals expected to rounding, relative to the magnitudes summed."""
    worst = float(np.max(np.abs(found - expected) / magnitude))
    if not worst <= TOLERANCE:
        raise ValueError(
            f"found a fault in a coefficient table, expected that {claim}: off by {worst:.2g}, allowed {TOLERANCE:.2g}"
        )


@cache
def dopri5() -> RungeKutta:
    """Dormand and Prince 5(4), 6 stages: J. Comput. Appl. Math. 6 (1980) 19, table 2 (RK5(4)7M)."""
    b = (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84)
    b4 = (5179 / 57600, 0.0, 7571 / 16695, 393 / 640, -92097 / 339200, 187 / 2100, 1 / 40)
    return RungeKutta(
        name="dopri5",
        order=5,
        A=(
            (),
            (1 / 5,),
            (3 / 40, 9 / 40),
            (44 / 45, -56 / 15, 32 / 9),
            (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
            (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
        ),
        b=b,
        c=(0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0),
        errors=(ErrorEstimate(tuple(x - y for x, y in zip((*b, 0.0), b4, strict=True)), 4),),
    )


@cache
def dop853() -> RungeKutta:
    """Order 8, 12 stages, error estimates of order 5 and 3: DOP853.

    Hairer, Norsett, Wanner (1993), section II.10, digits of their program.
    """
    b = (
        5.42937341165687622380535766363e-2, 0.0, 0.0, 0.0, 0.0,
        4.45031289275240888144113950566, 1.89151789931450038304281599044, -5.8012039600105847814672114227,
        3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1, 2.01365400804030348374776537501e-1,
        4.47106157277725905176885569043e-2,
    )  # fmt: skip
    b3 = (
        0.244094488188976377952755905512,
        *[0.0] * 7,
        0.733846688281611857341361741547,
        0.0,
        0.0,
        0.220588235294117647058823529412e-1,
    )
    return RungeKutta(
        name="dop853",
        order=8,
        A=(
            (),
            (5.26001519587677318785587544488e-2,),
            (1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2),
            (2.95875854768068491816892993775e-2, 0.0, 8.87627564304205475450678981324e-2),
            (2.41365134159266685502369798665e-1, 0.0, -8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1),
            (3.7037037037037037037037037037e-2, 0.0, 0.0, 1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1),
            (3.7109375e-2, 0.0, 0.0, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -1.7578125e-2),
            (
                3.70920001185047927108779319836e-2, 0.0, 0.0, 1.70383925712239993810214054705e-1, 1.07262030446373284651809199168e-1,
                -1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3,
            ),
            (
                6.24110958716075717114429577812e-1, 0.0, 0.0, -3.36089262944694129406857109825, -8.68219346841726006818189891453e-1,
                2.75920996994467083049415600797e1, 2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1,
            ),
            (
                4.77662536438264365890433908527e-1, 0.0, 0.0, -2.48811461997166764192642586468, -5.90290826836842996371446475743e-1,
                2.12300514481811942347288949897e1, 1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
                -2.03312017085086261358222928593e-2,
            ),
            (
                -9.3714243008598732571704021658e-1, 0.0, 0.0, 5.18637242884406370830023853209, 1.09143734899672957818500254654,
                -8.14978701074692612513997267357, -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1,
                2.49360555267965238987089396762, -3.0467644718982195003823669022,
            ),
            (
                2.27331014751653820792359768449, 0.0, 0.0, -1.05344954667372501984066689879e1, -2.00087205822486249909675718444,
                -1.79589318631187989172765950534e1, 2.79488845294199600508499808837e1, -2.85899827713502369474065508674,
                -8.87285693353062954433549289258, 1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1,
            ),
        ),
        b=b,
        c=(
            0.0, 0.526001519587677318785587544488e-1, 0.789002279381515978178381316732e-1, 0.118350341907227396726757197510,
            0.281649658092772603273242802490, 0.333333333333333333333333333333, 0.25, 0.307692307692307692307692307692,
            0.651282051282051282051282051282, 0.6, 0.857142857142857142857142857142, 1.0,
        ),
        errors=(
            ErrorEstimate(
                (
                    0.1312004499419488073250102996e-1, 0.0, 0.0, 0.0, 0.0, -0.1225156446376204440720569753e1,
                    -0.4957589496572501915214079952, 0.1664377182454986536961530415e1, -0.3503288487499736816886487290,
                    0.3341791187130174790297318841, 0.8192320648511571246570742613e-1, -0.2235530786388629525884427845e-1, 0.0,
                ),
                5,
            ),
            ErrorEstimate((*(x - y for x, y in zip(b, b3, strict=True)), 0.0), 3),
        ),
    )  # fmt: skip
