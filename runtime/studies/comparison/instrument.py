"""Bandwidth of an instrument: a Butterworth low-pass, causal or without phase."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.system.arrays import Array

FORGOTTEN = 1e-3  # part of a start that the filter still remembers after `settling`
PER_PERIOD = 50  # samples of a run in a period of the cut-off frequency: cell means dim it by 0.07 % there
ORDERS = (1, 12)


@dataclass(frozen=True)
class Instrument:
    """Butterworth low-pass: cut-off frequency [1/s], order; forwards alone (causal) or both ways.

    Causal, as amplifiers and filters before a converter are, it is 3 dB down at the cut-off and delays. Forwards and
    backwards, as recorded data are often smoothed, it has no phase, twice the order, and is 6 dB down there.
    """

    cut_off: float
    order: int = 4
    zero_phase: bool = False

    @property
    def spacing(self) -> float:
        """Spacing [s] at which a run is sampled for this filter."""
        return 1 / (PER_PERIOD * self.cut_off)

    @property
    def settling(self) -> float:
        """Time [s] after which a start is forgotten, by the slowest pole."""
        return -math.log(FORGOTTEN) / (2 * math.pi * self.cut_off * math.sin(math.pi / (2 * self.order)))

    def filtered(self, values: Array, spacing: float) -> Array:
        """Return samples (n, signals) at a spacing [s] after the filter; before them they were as the first."""
        from scipy import signal  # slow to import

        sections = signal.butter(self.order, self.cut_off, fs=1 / spacing, output="sos")
        if self.zero_phase:
            return np.asarray(signal.sosfiltfilt(sections, values, axis=0))
        still = signal.sosfilt_zi(sections)[..., None] * values[:1]
        return np.asarray(signal.sosfilt(sections, values, axis=0, zi=still)[0])

    def __str__(self) -> str:
        size, unit = next((f, u) for f, u in ((1e6, "MHz"), (1e3, "kHz"), (1.0, "Hz")) if self.cut_off >= f or f == 1)
        ways = "forwards and backwards, 6 dB down" if self.zero_phase else "causal, 3 dB down"
        return f"Butterworth low-pass of order {self.order}, {ways} at {self.cut_off / size:.4g} {unit}"
