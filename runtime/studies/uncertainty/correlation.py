"""Correlated uncertainties: distributions of several quantities, joined by a Gaussian copula."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown, unknown
from hertzwerk.runtime.studies.uncertainty.distributions import Distribution
from hertzwerk.runtime.system.arrays import Array

NODES = 64  # of Gauss and Hermite in each of two directions
FARTHEST = 8.0  # normal score: beyond, its part of a distribution rounds to 1


@dataclass(frozen=True)
class Correlated:
    """Distributions by name, and their correlations: Correlated({...}, {"clearance, restitution": -0.8}).

    A correlation is that of the normal scores (a Gaussian copula): of normal quantities their own, of lognormal ones that of the
    logarithms. Pairs that are not named are independent but for others.
    """

    distributions: Mapping[str, Distribution | str]
    correlation: Mapping[str, float] = field(default_factory=dict)

    def record(self) -> dict[str, Any]:
        """Return its fields as plain data; `Correlated(**record)` restores it."""
        return {
            "distributions": {name: str(one) for name, one in self.distributions.items()},
            "correlation": dict(self.correlation),
        }


def read_correlation(names: Sequence[str], pairs: object, faults: list[Fault]) -> Array:
    """Return the correlation (d, d) of normal scores; bad input is appended to `faults`."""
    correlation = np.eye(len(names))
    if pairs is None:
        return correlation
    if not isinstance(pairs, Mapping):
        expected = 'numbers by two names, such as {"clearance, restitution": -0.8}'
        faults.append(Fault("correlation", shown(pairs), expected))
        return correlation
    before = len(faults)
    for pair, value in pairs.items():
        where = f"correlation[{pair!r}]"
        both = [name.strip() for name in pair.split(",")] if isinstance(pair, str) else []
        if len(both) != 2 or both[0] == both[1]:
            faults.append(Fault(where, shown(pair), 'two names, such as "clearance, restitution"'))
            continue
        faults += [unknown("uncertain quantity", name, names) for name in both if name not in names]
        if isinstance(value, bool) or not isinstance(value, int | float) or not -1 < value < 1:
            faults.append(Fault(where, shown(value), "a number between -1 and 1"))
        elif all(name in names for name in both):
            i, j = (list(names).index(name) for name in both)
            if correlation[i, j] not in (0.0, value):
                faults.append(Fault(where, f"{value:g}, and {correlation[i, j]:g} before", "each pair once"))
            correlation[i, j] = correlation[j, i] = value
    least = float(np.linalg.eigvalsh(correlation)[0])
    if len(faults) == before and least <= 1e-12:
        expected = "correlations that are possible together, a positive definite matrix"
        faults.append(Fault("correlation", f"a matrix with the eigenvalue {least:.3g}", expected))
    return correlation


def correlated_parts(points: Array, correlation: Array) -> Array:
    """Return parts (d, N) of distributions that are correlated, from independent ones in 0..1."""
    from scipy.special import ndtr, ndtri  # slow to import

    if np.array_equal(correlation, np.eye(len(points))):
        return points
    parts: Array = ndtr(np.linalg.cholesky(correlation) @ ndtri(points))
    return parts


def covariance(drawn: Sequence[Any], correlation: Array) -> Array:
    """Return the covariance (d, d) [SI] of SciPy's distributions, by Gauss and Hermite over scores."""
    from scipy.special import ndtr  # slow to import

    z, w = np.polynomial.hermite_e.hermegauss(NODES)
    z, w = np.clip(z, -FARTHEST, FARTHEST), w / np.sum(w)
    matrix = np.diag([float(one.var()) for one in drawn])
    for i, j in zip(*np.nonzero(np.triu(correlation, 1)), strict=True):
        rho = correlation[i, j]
        first, second = drawn[i].ppf(ndtr(z)) - drawn[i].mean(), rho * z[:, None] + np.sqrt(1 - rho**2) * z
        other = drawn[j].ppf(ndtr(np.clip(second, -FARTHEST, FARTHEST))) - drawn[j].mean()
        matrix[i, j] = matrix[j, i] = float(np.sum((w * first)[:, None] * w * other))
    return matrix
