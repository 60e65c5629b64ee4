"""When and why `method="auto"` changed its method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.integrate.loop.choose import EXPLICIT, IMPLICIT, STIFF

if TYPE_CHECKING:
    from hertzwerk.runtime.solution.history import History


@dataclass(frozen=True)
class Choice:
    """From t [s] on the steps were "explicit" or "implicit", and why."""

    t: float
    method: str
    reason: str


class Choices:
    """What `method="auto"` chose: the first method and every change."""

    def __init__(self) -> None:
        self.made: list[Choice] = []

    def take(self, block: History, fresh: int) -> None:
        """The next accepted steps; see `Observer`."""
        method, stiffness, pressure = (block.part(part)[:, 0] for part in ("method", "stiffness", "pressure"))
        if not fresh:
            self.made.append(Choice(float(block.t[0]), "explicit", "a run begins so"))
        first = max(fresh, 1)
        for i in first + np.flatnonzero(method[first:] != method[first - 1 : -1]):
            if method[i] == EXPLICIT and pressure[i] > 0:
                reason = "a singular position is near, and the Jacobian before it says nothing of what is behind"
            elif method[i] == EXPLICIT:
                reason = f"step x fastest rate fell to {stiffness[i]:.2g}: explicit steps are as long, and cheaper"
            elif stiffness[i] > STIFF:
                reason = f"step x fastest rate = {stiffness[i]:.2g}: stability holds explicit steps down, not accuracy"
            else:
                reason = "step after step went over the layer in which friction turns: it sticks"
            self.made.append(Choice(float(block.t[i]), "implicit" if method[i] == IMPLICIT else "explicit", reason))
