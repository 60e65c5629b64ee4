"""Times of the frames of a film, and how much slower than the motion it runs."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.system.arrays import Array

LONG = 8.0  # s: about the length of a film where none is asked for
BRISK = (2.0, 20.0)  # s: lengths of motions that are shown as fast as they are
MOST = 5000  # frames
FASTEST = {".gif": 50.0}  # frames a second that are shown as such


@dataclass(frozen=True)
class Clock:
    """Times (n,) [s] of the frames, frames a second, and how much slower the film is than the motion."""

    times: Array
    fps: float
    slow: float

    @classmethod
    def of(cls, begin: float, end: float, fps: object, slow: object, suffix: str, faults: list[Fault]) -> Clock | None:
        """Return the clock of a film; None with faults appended where it cannot be."""
        span, most = end - begin, FASTEST.get(suffix, 1000.0)
        before = len(faults)
        if not _is_number(fps) or not 0 < fps <= most:  # type: ignore[operator]
            faults.append(Fault("fps", repr(fps), f"frames a second, up to {most:g}"))
        if slow is not None and (not _is_number(slow) or not slow > 0):  # type: ignore[operator]
            faults.append(Fault("slow", repr(slow), "a positive number: seconds of film for a second of motion"))
        if span <= 0:
            faults.append(Fault("run", "a run without a step", "one that moved"))
        if len(faults) > before:
            return None
        rate, chosen = float(fps), _slow(span) if slow is None else float(slow)  # type: ignore[arg-type]
        count = max(2, round(span * chosen * rate))
        if count > MOST:
            remedy = f"slow={MOST / (span * rate):.2g} or less; or run for a shorter time"
            faults.append(Fault("fps, slow", f"{count:,} frames", f"at most {MOST:,}", remedy))
            return None
        return cls(np.linspace(begin, end, count), rate, chosen)

    def pace(self) -> str:
        """Describe how fast the film runs."""
        if self.slow == 1:
            return "Real time"
        return f"{self.slow:.4g} times slower" if self.slow > 1 else f"{1 / self.slow:.4g} times faster"

    def shown(self, k: int) -> str:
        """Return the time of a frame, with as many digits as distinguish it from the next."""
        scale = scale_of("s", self.times[-1])
        spacing = float(self.times[1] - self.times[0]) / scale.factor
        return f"t = {self.times[k] / scale.factor:.{max(0, math.ceil(-math.log10(spacing)) + 1)}f} {scale.unit}"


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _slow(span: float) -> float:
    """Return 1 for motions of a few seconds, else 1, 2, 5, 10, ... for a film of about 8 s."""
    if BRISK[0] <= span <= BRISK[1]:
        return 1.0
    wanted = LONG / span
    power = 10.0 ** math.floor(math.log10(wanted))
    return float(min((step * power for step in (1, 2, 5, 10)), key=lambda slow: abs(math.log(slow / wanted))))
