"""Coefficients of L-stable methods; order conditions and stability are checked on construction."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, reduce
from math import prod
from operator import add

import numpy as np

from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import ErrorEstimate, require, require_order
from hertzwerk.runtime.system.lazy import cached_property

ITERATIONS = 3  # of Newton's method per stage: fixed, the graph has no loops that end early
FAR = 1e8  # |h lambda| that counts as infinite: there an L-stable method leaves about 1/FAR
AXIS = np.concatenate([np.linspace(0, 20, 400), np.geomspace(20, FAR, 100)])  # |h lambda| on the imaginary axis
POINTS = 3  # at most that a predictor extrapolates from
APART = 0.15  # their nodes at least
EXCESS = 1e-12  # of 1, allowed to |R| on the axis: rounding


@dataclass(frozen=True)
class Rosenbrock:
    """L-stable Rosenbrock method of s stages, in the form without products by the Jacobian J.

        (I - h gamma J) U_i = h gamma f(t + alpha_i h, y + sum_j a_ij U_j) + gamma sum_j c_ij U_j + gamma gamma_i h^2 df/dt
        y1 = y + sum_j m_j U_j,  error = sum_j errors_j U_j

    a, c: s rows, row i has i entries; m, alpha, gammas: s entries. Hairer, Wanner II, (7.25).
    """

    name: str
    order: int
    gamma: float
    a: tuple[tuple[float, ...], ...]
    c: tuple[tuple[float, ...], ...]
    m: tuple[float, ...]
    alpha: tuple[float, ...]
    gammas: tuple[float, ...]
    error: ErrorEstimate

    def __post_init__(self) -> None:
        s = len(self.m)
        triangle = list(range(s))
        rows = ([len(row) for row in self.a], [len(row) for row in self.c])
        if rows != (triangle, triangle) or {len(self.alpha), len(self.gammas), len(self.error.weights)} != {s}:
            raise ValueError(f"{self.name}: the rows of a and c must have 0, 1, ..., {s - 1} entries, the rest {s}")
        # U = Gamma k with Gamma^-1 = I/gamma - c: back to the conditions' own coefficients.
        gammas = np.linalg.inv(np.eye(s) / self.gamma - _square(self.c))
        alpha = _square(self.a) @ gammas
        beta = alpha + gammas
        size = np.abs(_square(self.a)) @ np.abs(gammas).sum(1) + 1
        require(f"{self.name}: row sums of alpha equal alpha_i", alpha.sum(1), np.array(self.alpha), size)
        require(f"{self.name}: row sums of Gamma equal gamma_i", gammas.sum(1), np.array(self.gammas), size)
        b = np.array(self.m) @ gammas
        require_order(f"{self.name}: m", beta, b, self.order, solution=True, several=alpha)
        _require_estimate(self.name, beta, np.array(self.error.weights) @ gammas, self.error.order, several=alpha)
        require_l_stable(self.name, beta, b)

    @property
    def stages(self) -> int:
        """Evaluations of the right-hand side per step.

        The first is known from the step before, one is made at the end.
        """
        return len(self.m)

    @property
    def error_order(self) -> int:
        """Power of the step in the error norm."""
        return self.error.order + 1


@dataclass(frozen=True)
class DiagonallyImplicit:
    """L-stable Runge-Kutta method with an explicit first stage and one diagonal entry gamma (ESDIRK).

    The last stage is the solution.
    """

    name: str
    order: int
    A: tuple[tuple[float, ...], ...]
    c: tuple[float, ...]
    error: ErrorEstimate

    def __post_init__(self) -> None:
        s = len(self.A)
        if [len(row) for row in self.A] != list(range(1, s + 1)) or {len(self.c), len(self.error.weights)} != {s}:
            raise ValueError(f"{self.name}: the rows of A must have 1, 2, ..., {s} entries, the rest {s}")
        A = _square(self.A)
        diagonal = np.array([0.0, *[self.gamma] * (s - 1)])
        require(f"{self.name}: diagonal of A is 0, gamma, ..., gamma", np.diag(A), diagonal, np.ones(s))
        require(f"{self.name}: row sums of A equal c", A.sum(1), np.array(self.c), np.abs(A).sum(1) + 1)
        require_order(f"{self.name}: b", A, A[-1], self.order, solution=True)
        _require_estimate(self.name, A, np.array(self.error.weights), self.error.order)
        require_l_stable(self.name, A, A[-1])

    @property
    def gamma(self) -> float:
        """Diagonal entry of the implicit stages."""
        return self.A[-1][-1]

    @property
    def stages(self) -> int:
        """Evaluations of the right-hand side per step, without the one at its end."""
        return ITERATIONS * (len(self.A) - 1)

    @property
    def error_order(self) -> int:
        """Power of the step in the error norm."""
        return self.error.order + 1

    @cached_property
    def predictors(self) -> tuple[tuple[float, ...], ...]:
        """Weights over the earlier stages' slopes that extrapolate each stage's slope.

        The extrapolation is through a few near nodes that are not close together.
        """
        rows: list[tuple[float, ...]] = []
        for i, node in enumerate(self.c):
            known: list[float] = []
            for other in sorted(self.c[:i], key=lambda other: abs(other - node)):
                if len(known) < POINTS and all(abs(other - chosen) > APART for chosen in known):
                    known.append(other)
            rows.append(tuple(_lagrange(known, x, node) if x in known else 0.0 for x in self.c[:i]))
        return tuple(rows)


def _lagrange(nodes: list[float], own: float, x: float) -> float:
    """Return the Lagrange polynomial of a node, which is 0 at the others, evaluated at x."""
    return prod((x - other) / (own - other) for other in nodes if other != own)


def require_l_stable(name: str, A: np.ndarray, b: np.ndarray) -> None:
    """Raise unless |R| <= 1 on the imaginary axis and R vanishes at infinity.

    R(z) = 1 + z b (I - z A)^-1 1.
    """
    one = np.ones(len(b))
    R = [1 + z * (b @ np.linalg.solve(np.eye(len(b)) - z * A, one)) for z in (1j * AXIS)]
    worst = max(map(abs, R))
    if not worst <= 1 + EXCESS:
        raise ValueError(f"{name}: found |R| = {worst:.15g} on the imaginary axis, expected at most 1: not A-stable")
    if not abs(R[-1]) <= 100 / FAR:
        raise ValueError(f"{name}: found |R| = {abs(R[-1]):.3g} at infinity, expected 0: not L-stable")


def _require_estimate(
    name: str, A: np.ndarray, weights: np.ndarray, order: int, several: np.ndarray | None = None
) -> None:
    if not np.any(weights):
        raise ValueError(f"{name}: error weights are all zero")
    require_order(f"{name}: error weights", A, weights, order, solution=False, several=several)


def _square(rows: tuple[tuple[float, ...], ...]) -> np.ndarray:
    matrix = np.zeros((len(rows), len(rows)))
    for i, row in enumerate(rows):
        matrix[i, : len(row)] = row
    return matrix


@cache
def rodas5p() -> Rosenbrock:
    """Rodas5P, order 5(4), 8 stages, stiffly accurate: Steinebach, BIT Numer. Math. 63 (2023) 27.

    Digits of OrdinaryDiffEq.jl.
    """
    a6 = (-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946)
    return Rosenbrock(
        name="rodas",
        order=5,
        gamma=0.21193756319429014,
        a=(
            (),
            (3.0,),
            (2.849394379747939, 0.45842242204463923),
            (-6.954028509809101, 2.489845061869568, -10.358996098473584),
            (2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641),
            a6,
            (*a6, 1.0),
            (*a6, 1.0, 1.0),
        ),
        c=(
            (),
            (-14.155112264123755,),
            (-17.97296035885952, -2.859693295451294),
            (147.12150275711716, -1.41221402718213, 71.68940251302358),
            (165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306),
            (24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471),
            (
                30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783,
                -19.097331116725623, -28.087943162872662,
            ),
            (
                37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047,
                -40.06618937091002, -54.66780262877968, -9.48861652309627,
            ),
        ),
        m=(*a6, 1.0, 1.0, 1.0),
        alpha=(0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1.0, 1.0, 1.0),
        gammas=(
            0.21193756319429014, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069,
            0.0, 0.0, 0.0,
        ),
        error=ErrorEstimate((*[0.0] * 7, 1.0), 4),
    )  # fmt: skip


@cache
def esdirk54() -> DiagonallyImplicit:
    """ESDIRK5(4)7L[2]SA2, order 5(4), 6 implicit stages, stage order 2.

    Kennedy, Carpenter (2019), digits of SUNDIALS ARKODE.
    """
    gamma = 23 / 125
    inner = (  # columns 2, 3, ... of rows 2, 3, ...; the first column follows from the row sums
        (),
        (gamma,),
        (791020047304 / 3561426431547, gamma),
        (-158159076358 / 11257294102345, -85517644447 / 5003708988389, gamma),
        (
            -1653327111580 / 4048416487981, 1514767744496 / 9099671765375,
            14283835447591 / 12247432691556, gamma,
        ),
        (
            -4540011970825 / 8418487046959, -1790937573418 / 7393406387169,
            10819093665085 / 7266595846747, 4109463131231 / 7386972500302, gamma,
        ),
        (
            -188593204321 / 4778616380481, 2809310203510 / 10304234040467, 1021729336898 / 2364210264653,
            870612361811 / 2470410392208, -1307970675534 / 8059683598661, gamma,
        ),
    )  # fmt: skip
    c = (
        *(0.0, 46 / 125, 7121331996143 / 11335814405378, 49 / 353),
        *(3706679970760 / 5295570149437, 347 / 382, 1.0),
    )
    embedded = (
        *(-582099335757 / 7214068459310, 615023338567 / 3362626566945, 3192122436311 / 6174152374399),
        *(6156034052041 / 14430468657929, -1011318518279 / 9693750372484, 1914490192573 / 13754262428401),
    )
    A = tuple((node - _sum(row), *row) for node, row in zip(c, inner, strict=True))
    difference = tuple(x - y for x, y in zip(A[-1], (1 - _sum(embedded), *embedded), strict=True))
    return DiagonallyImplicit(name="esdirk", order=5, A=A, c=c, error=ErrorEstimate(difference, 4))


def _sum(row: tuple[float, ...]) -> float:
    """Return a sum from left to right on every version: `sum` compensates from Python 3.12 on."""
    return reduce(add, row, 0.0)
