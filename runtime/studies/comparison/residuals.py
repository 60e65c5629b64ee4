"""Residual of a measured signal against a run, and whether the stated noise explains it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.system.arrays import Array

LEVEL = 0.01  # chance with which noise alone is taken for a difference


@dataclass(frozen=True)
class Residual:
    """Measured less run, over the samples of a window.

    samples, end     their number, and the run time [s] of the last
    rms, mean, peak  of the residual (peak: largest size), in the signal's SI unit
    variation        standard deviation of the measured signal
    correlation      of measured and run; nan where one of them does not vary
    noise            standard deviation stated for the measurement; None where none is
    independent      samples that the residual is worth, by its autocorrelation
    least, largest   rms that noise alone stays below, and exceeds, with a chance of 1 % each; None without noise
    """

    samples: int
    end: float
    rms: float
    mean: float
    peak: float
    variation: float
    correlation: float
    noise: float | None = None
    independent: float = math.nan
    least: float | None = None
    largest: float | None = None

    @property
    def explained(self) -> bool | None:
        """Return whether noise alone explains the residual; None where none is stated."""
        return None if self.largest is None else self.rms <= self.largest

    @property
    def overstated(self) -> bool:
        """Return whether the residual is less than the stated noise would leave."""
        return self.least is not None and self.rms < self.least


def residual_of(times: Array, measured: Array, run: Array, noise: float | None) -> Residual:
    """Compare a measured signal (n,) with a run's at run times (n,) [s]; noise: its standard deviation."""
    residual = measured - run
    independent = _independent(residual)
    spreads = np.std(measured), np.std(run)
    product = float(np.mean((measured - np.mean(measured)) * (run - np.mean(run))))
    return Residual(
        samples=len(times),
        end=float(times[-1]),
        rms=math.sqrt(float(np.mean(residual**2))),
        mean=float(np.mean(residual)),
        peak=float(np.max(np.abs(residual))),
        variation=float(spreads[0]),
        correlation=product / float(spreads[0] * spreads[1]) if min(spreads) > 0 else math.nan,
        noise=noise,
        independent=independent,
        least=None if noise is None else noise * _ratio(independent, 1 - LEVEL),
        largest=None if noise is None else noise * _ratio(independent, LEVEL),
    )


def _independent(residual: Array) -> float:
    """Return the number of independent samples that determine the variance as well, by Bartlett's formula.

    n / (1 + 2 sum of squared autocorrelations).
    """
    known = autocorrelations(residual)
    return max(len(residual) / (1 + 2 * float(known @ known)), min(2.0, len(residual)))


def autocorrelations(residual: Array) -> Array:
    """Return the autocorrelations of a residual (n,) from lag 1 on.

    Up to the first that is within two standard errors of none.
    """
    n = len(residual)
    centred = residual - np.mean(residual)
    size = 1 << (2 * n - 1).bit_length()
    power = np.abs(np.fft.rfft(centred, size)) ** 2
    products = np.fft.irfft(power, size)[: n // 2]
    if not products.size or products[0] <= 0:
        return np.zeros(0)
    correlations = products[1:] / products[0]
    gone = np.flatnonzero(np.abs(correlations) < 2 / math.sqrt(n))
    leading: Array = correlations[: gone[0] if len(gone) else len(correlations)]
    return leading


def _ratio(independent: float, chance: float) -> float:
    """Return the rms over the standard deviation that noise exceeds with a chance (chi-squared)."""
    from scipy.special import chdtri  # slow to import

    return math.sqrt(float(chdtri(independent, chance)) / independent)
