"""The slider-crank without clearance, in closed form, and the gain from a journal's eccentricity to the slider.

Textbook kinematics (e.g. Shigley & Uicker, Theory of Machines and Mechanisms): crank angle phi = w t, rod angle theta
with r sin phi + l sin theta = 0, slider x = r cos phi + l cos theta. Units SI. Arrays in, arrays out.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike


def position(phi: ArrayLike, r: float, l: float) -> np.ndarray:
    """Slider position x [m]."""
    return r * np.cos(phi) + np.sqrt(l**2 - (r * np.sin(phi)) ** 2)


def velocity(phi: ArrayLike, w: float, r: float, l: float) -> np.ndarray:
    """x' [m/s]."""
    root = np.sqrt(l**2 - (r * np.sin(phi)) ** 2)
    return -r * w * np.sin(phi) * (1 + r * np.cos(phi) / root)


def acceleration(phi: ArrayLike, w: float, r: float, l: float) -> np.ndarray:
    """x'' [m/s^2]; -w^2 r (1 + r/l) and w^2 r (1 - r/l) at the dead centres."""
    root = np.sqrt(l**2 - (r * np.sin(phi)) ** 2)
    curve = r * np.cos(2 * phi) / root + (r * np.sin(phi)) ** 2 * r * np.cos(phi) ** 2 / root**3
    return -r * w**2 * (np.cos(phi) + curve)


def gain(r: float, l: float, eccentricity: float = 0.0) -> float:
    """Kinematic gain C: |x - x_ideal| <= C |e| at every crank angle, for any eccentricity up to `eccentricity`.

    With clearance the loop closes to r sin phi + l sin theta = e_y and x = r cos phi + l cos theta - e_x. At one phi,
    sin theta differs from the ideal one by e_y/l, and by the mean value theorem (d cos/d sin = -tan)

        x - x_ideal = -e_x - tan(theta_m) e_y,   at most |e| sqrt(1 + tan^2) = |e|/cos(theta_m),

    theta_m between the two rod angles, so |sin theta_m| <= (r + |e|)/l. For |e| -> 0 this is 1/sqrt(1 - (r/l)^2).
    """
    return 1 / float(np.sqrt(1 - ((r + eccentricity) / l) ** 2))
