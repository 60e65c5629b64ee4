"""Spectra of a measured signal and a run's: log-spectral distance, coherence."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.system.arrays import Array

SEGMENTS = 8  # that a series is cut into at least, overlapping by half (Welch)
SHORTEST = 32  # samples of a segment
MOST_MISSING = 0.2  # part of the samples that may be interpolated
FLOOR = 1e-12  # of the largest density: smaller ones are rounding


@dataclass(frozen=True)
class Spectrum:
    """Power spectral densities over frequencies [1/s] of a band, each (n,), in the unit squared times s.

    distance     log-spectral distance [dB]: rms over the band of the ratio in dB
    coherence    magnitude-squared, mean over the band; None where the trajectories cannot be compared
    """

    frequencies: Array
    measured: Array
    run: Array
    distance: float
    coherence: float | None


@dataclass(frozen=True)
class Series:
    """Measured signal and a run's at equal spacing [s], missing samples interpolated in both alike."""

    spacing: float
    measured: Array
    run: Array


def series_of(times: Array, measured: Array, run: Array) -> Series | str:
    """Return both at equally spaced times, from samples at times (n,) [s]; else a reason."""
    spacing = float(np.median(np.diff(times)))
    count = round((times[-1] - times[0]) / spacing) + 1
    missing = 1 - len(times) / count
    if missing > MOST_MISSING:
        return f"{missing:.0%} of the samples are missing"
    even = times[0] + spacing * np.arange(count)
    return Series(spacing, np.interp(even, times, measured), np.interp(even, times, run))


def spectrum_of(series: Series, cut_off: float, *, coherent: bool, noise: float | None) -> Spectrum | str:
    """Compare spectra up to a cut-off [1/s] or half the sampling rate; else return a reason.

    noise: standard deviation of the measurement's, whose density is added to the run's.
    """
    from scipy import signal  # slow to import

    n = len(series.measured)
    length = 1 << int(math.log2(max(2 * n / (SEGMENTS + 1), 1)))
    if length < SHORTEST:
        return f"{n} samples are too few: {SEGMENTS} segments of {SHORTEST} need {(SEGMENTS + 1) * SHORTEST // 2}"
    how = {"fs": 1 / series.spacing, "nperseg": length}
    frequencies, measured = signal.welch(series.measured, **how)
    run = signal.welch(series.run, **how)[1] + (0.0 if noise is None else 2 * noise**2 * series.spacing)
    band = (frequencies > 0) & (frequencies <= cut_off)
    if np.count_nonzero(band) < 3:
        return f"the band up to {cut_off:.4g} Hz holds fewer than 3 of the frequencies, {frequencies[1]:.4g} Hz apart"
    floor = FLOOR * max(float(np.max(measured)), float(np.max(run)))
    ratio = 10 * np.log10((measured[band] + floor) / (run[band] + floor)) if floor > 0 else np.zeros(int(band.sum()))
    coherence = signal.coherence(series.measured, series.run, **how)[1][band] if coherent else None
    return Spectrum(
        frequencies[band],
        measured[band],
        run[band],
        math.sqrt(float(np.mean(ratio**2))),
        None if coherence is None else float(np.nanmean(coherence)) if np.any(np.isfinite(coherence)) else None,
    )
