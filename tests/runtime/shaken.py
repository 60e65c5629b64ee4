"""A block on a spring and a damper that an input pushes, and its exact motion."""

from functools import cache

import numpy as np
from scipy.linalg import expm

import hertzwerk.derive as hd
from hertzwerk.runtime.loading import engine_model

MASS, STIFFNESS, DAMPING = 2.0, 50.0, 0.7
PUSHED = """
from hertzwerk.derive import GROUND, Body, EnergyLedger, Input, JointForce, JointSpring, Mechanism, Parameter, Prismatic, Scales, Scene, X

block = Body("block", Parameter("mass", "kg", 2))
scene = Scene(
    Mechanism("pushed", (Prismatic("slide", GROUND, block, axis=X),)),
    (JointSpring("spring", "slide", Parameter("stiffness", "N/m", 50)), JointForce("motor", "slide", Input("push", "N")), EnergyLedger()),
    Scales(Parameter("size", "cm", 10), Parameter("pace", "m/s", 1)),
)
"""


@cache
def shaken(coordinates="tree"):
    """Model of the block."""
    block = hd.Body("block", hd.Parameter("mass", "kg", MASS), hd.Parameter("inertia", "kg m^2", 1))
    effects = (
        hd.JointSpring("spring", "slide", hd.Parameter("stiffness", "N/m", STIFFNESS)),
        hd.JointDamper("damper", "slide", hd.Parameter("damping", "N s/m", DAMPING)),
        hd.JointForce("motor", "slide", hd.Input("push", "N", "of the shaker")),
        hd.EnergyLedger(),
    )
    scales = hd.Scales(hd.Parameter("size", "cm", 10), hd.Parameter("pace", "m/s", 1), hd.Parameter("arm", "m", 1))
    mechanism = hd.Mechanism("shaker", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),))
    return engine_model(hd.Scene(mechanism, effects, scales, coordinates=coordinates))


def exact(times, values, *, held):
    """Travel and speed (n, 2) at the times of the samples, by the matrix exponential of block and input (Van Loan 1978)."""
    A = np.array([[0, 1, 0, 0], [-STIFFNESS / MASS, -DAMPING / MASS, 1 / MASS, 0], [0, 0, 0, 1], [0, 0, 0, 0]])
    states = [np.zeros(2)]
    for t0, t1, v0, v1 in zip(times, times[1:], values, values[1:], strict=False):
        slope = 0.0 if held else (v1 - v0) / (t1 - t0)
        states.append((expm(A * (t1 - t0)) @ [*states[-1], v0, slope])[:2])
    return np.array(states)
