"""Energy balance of a run, from the tally that its loop keeps."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass

SMALL = 1e-6  # of the scene's energy scale: least energy that errors are relative to


@dataclass(frozen=True)
class Balance:
    """Energy balance of a run: energy - initial energy + dissipated - input should stay zero.

    It is measured by the energy that the run moves: the largest kinetic energy, energy dissipated or put in, or change of
    potential energy. The total energy is no measure, since the zero of the potential is arbitrary.

    error, moved, size    largest error, energy moved, and energy [J]; size is infinite where one was not finite
    scale    of the scene's energy [J]
    states   number of the states it was followed over
    """

    error: float
    moved: float
    size: float
    scale: float
    states: int

    @property
    def residual(self) -> float | None:
        """Return the largest error over the largest energy moved; None where something was not finite."""
        measure = max(self.moved, SMALL * self.scale)
        return self.error / measure if self.size < math.inf and measure > 0 else None

    @property
    def unclosed(self) -> float:
        """Return the largest error beyond rounding over the largest energy moved or the scene's energy scale.

        The larger of the two: a run's accuracy is relative to its scales, however little moves. 0 where something was
        not finite, which ends a run by itself.
        """
        measure = max(self.moved, self.scale)
        # of energies that are large because their zero is far, and of sums over states
        rounding = sys.float_info.epsilon * self.states * self.size
        return max(self.error - rounding, 0.0) / measure if rounding < math.inf and measure > 0 else 0.0
