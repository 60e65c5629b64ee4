"""Changes of method by `method="auto"`, with times and reasons."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.integrate.loop.choose import EXPLICIT, IMPLICIT, STIFF

if TYPE_CHECKING:
    from hertzwerk.runtime.solution.history import History


@dataclass(frozen=True)
class Choice:
    """Start t [s] of "explicit" or "implicit" steps, and the reason."""

    t: float
    method: str
    reason: str


class Choices:
    """Observer of the choices of `method="auto"`: the first method and every change."""

    def __init__(self) -> None:
        self.made: list[Choice] = []

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        method, stiffness, pressure = (block.part(part)[:, 0] for part in ("method", "stiffness", "pressure"))
        if not fresh:
            self.made.append(Choice(float(block.t[0]), "explicit", "runs begin with explicit steps"))
        first = max(fresh, 1)
        for i in first + np.flatnonzero(method[first:] != method[first - 1 : -1]):
            if method[i] == EXPLICIT and pressure[i] > 0:
                reason = "a singular position is near, where the Jacobian does not predict the motion beyond"
            elif method[i] == EXPLICIT:
                reason = f"step x fastest rate fell to {stiffness[i]:.2g}: explicit steps are as long, and cheaper"
            elif stiffness[i] > STIFF:
                reason = f"step x fastest rate = {stiffness[i]:.2g}: stability holds explicit steps down, not accuracy"
            else:
                reason = "step after step crossed the layer in which friction reverses: the pair sticks"
            self.made.append(Choice(float(block.t[i]), "implicit" if method[i] == IMPLICIT else "explicit", reason))
