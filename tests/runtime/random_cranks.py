"""Slider-cranks at random, over wide ranges: the same for every machine and every run."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from hertzwerk.derive import Parameter
from hertzwerk.derive.laws import coulomb, flores, hunt_crossley, power, smooth_coulomb
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime.loading import engine_model

SEED, COUNT = 20261122, 620
METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")
DAMPING = {"hunt_crossley": hunt_crossley, "flores": flores}
FRICTION = {
    "smooth_coulomb": lambda mu: smooth_coulomb(mu, Parameter("friction_speed", "m/s", 0.1)),
    "coulomb": lambda mu: coulomb(mu, mu),
}


@dataclass(frozen=True)
class Crank:
    """One of them, and what it is asked for."""

    damping: str
    friction: str
    method: str
    parameters: dict[str, float | str]
    asked: dict[str, float]


@cache
def model(damping: str, friction: str):
    restitution, coefficient = Parameter("restitution", "1", 0.9), Parameter("friction_coefficient", "1", 0.1)
    stiffness = Parameter("stiffness", "N/m^1.5", 1e10)
    effects = {effect.name: effect for effect in slider_crank.effects}
    effects["slider_pin"] = type(effects["slider_pin"])(
        "slider_pin", power(stiffness, 1.5), DAMPING[damping](restitution)
    )
    of = effects["slider_pin_friction"]
    effects["slider_pin_friction"] = type(of)(of.name, pair=of.pair, law=FRICTION[friction](coefficient))
    return engine_model(replace(slider_crank, effects=tuple(effects.values())))


def cranks(count: int = COUNT, seed: int = SEED) -> Iterator[Crank]:
    """Clearance 1 um to 5 mm, stiffness 1e5 to 1e12 N/m^1.5, restitution 0 to 1, friction 0 to 1, smooth or set-valued; two revolutions."""
    random = np.random.default_rng(seed)

    def spread(low: float, high: float) -> float:
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    for i in range(count):
        restitution = (0.0, 1.0)[i // 10 % 2] if i % 10 == 0 else float(random.uniform(0, 1))
        damping = "hunt_crossley" if restitution == 0 or random.random() < 0.5 else "flores"  # flores has none at 0
        friction = "coulomb" if random.random() < 0.3 else "smooth_coulomb"
        parameters = {
            "clearance": f"{spread(1e-3, 5)!r} mm", "stiffness": f"{spread(1e5, 1e12)!r} N/m^1.5", "restitution": restitution,
            "friction_coefficient": float(random.uniform(0, 1)),
        }  # fmt: skip
        if friction == "smooth_coulomb":
            parameters["friction_speed"] = f"{spread(1e-4, 1)!r} m/s"
        asked = {"tolerance": spread(1e-9, 1e-5)} if random.random() < 0.5 else {"accuracy": 1e-6}
        yield Crank(damping, friction, METHODS[i % 5], parameters, asked)
