"""The benchmark bicycle: eigenvalues against Meijaard, Papadopoulos, Ruina, Schwab, Proc. R. Soc. A 463 (2007) 1955, table 2.

Whipple's model: knife-edge wheels that roll without slip. States lean and steer; the map over a time T of the exact derivatives of a run is exp(A T).
"""

import numpy as np
import pytest
import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    Direction,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Prismatic,
    Revolute,
    RimOnPlane,
    RollingWithoutSlip,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.runtime import load, simulate

PUBLISHED = {  # speed [m/s] -> castering, capsize, weave [1/s]
    5.0: (-14.07838969279822, -0.32286642900409, -0.77534188219585, 4.46486771378823),
}
STATES = ("lean", "steer", "lean_speed", "steer_speed")


def p(name: str, value: float, unit: str = "m") -> Parameter:
    return Parameter(name, unit, value)


def body(name: str, mass: float, inertia: tuple[float, float, float, float], **more) -> Body:
    """Inertias xx, yy, zz and xz, with z upwards."""
    xx, yy, zz, xz = (
        p(f"{name}_{k}", value, "kg m^2") for k, value in zip(("xx", "yy", "zz", "xz"), inertia, strict=True)
    )
    tensor = ((xx, 0, xz), (0, yy, 0), (xz, 0, zz)) if inertia[3] else (xx, yy, zz)
    return Body(name, p(f"{name}_mass", mass, "kg"), tensor, **more)


def bicycle() -> Scene:
    w, c, tilt, rear, front = (
        p("w", 1.02),
        p("trail", 0.08),
        p("steer_tilt", np.pi / 10, "rad"),
        p("r_rear", 0.3),
        p("r_front", 0.35),
    )
    cart, lifted, leaned = (Body(name, 0) for name in ("cart", "lifted", "leaned"))
    frame = body("frame", 85, (9.2, 11, 2.8, -2.4), centre=(p("x_frame", 0.3), 0, p("z_frame", 0.9)))
    fork = body("fork", 4, (0.05892, 0.06, 0.00708, 0.00756), centre=(p("x_fork", 0.9), 0, p("z_fork", 0.7)))
    one, two = body("one", 2, (0.0603, 0.12, 0.0603, 0)), body("two", 3, (0.1405, 0.28, 0.1405, 0))
    joints = (
        Planar("path", GROUND, cart, normal=Z),
        Prismatic("rise", cart, lifted, axis=Z),
        Revolute("lean", lifted, leaned, axis=X),
        Revolute("pitch", leaned.at(0, 0, rear), frame.at(0, 0, rear), axis=Y),
        Revolute("rear", frame.at(0, 0, rear), one, axis=Y),
        Revolute(
            "steer", frame.at(w + c, 0, 0), fork.at(w + c, 0, 0), axis=Direction((-sp.sin(tilt), 0, sp.cos(tilt)))
        ),
        Revolute("front", fork.at(w, 0, front), two, axis=Y),
    )
    ground = GROUND.at(0, 0, 0)
    pairs = (
        RimOnPlane("rear_tyre", one.at(0, 0, 0), Y, rear, ground, normal=Z),
        RimOnPlane("front_tyre", two.at(0, 0, 0), Y, front, ground, normal=Z),
    )
    effects = (
        Gravity("gravity", p("g", 9.81, "m/s^2"), direction=-Z),
        RollingWithoutSlip("rear_rolls", "rear_tyre"),
        RollingWithoutSlip("front_rolls", "front_tyre"),
        EnergyLedger(),
    )
    nowhere, ahead = p("nowhere", 0), p("ahead", 0, "rad")
    position = {"path.x": nowhere, "path.y": nowhere, "path.angle": ahead, "rear": ahead, "front": ahead}
    position |= {name: p(f"{name}_0", 0, "rad") for name in ("lean", "steer")}
    speed = {name: p(f"{name}_speed_0", 0, "rad/s") for name in ("lean", "steer")}
    speed["rear"] = p("v", 5, "m/s") / rear
    start = Start(position=position, speed=speed)
    return Scene(Mechanism("bicycle", joints, pairs), effects, Scales(rear, p("pace", 5, "m/s"), arm=rear), start)


def test_the_benchmark_bicycle_has_its_published_eigenvalues():
    model, duration = load(bicycle()), 0.2
    for speed, (castering, capsize, weave, frequency) in PUBLISHED.items():
        run = simulate(model, duration=duration, parameters={"v": f"{speed} m/s"}, tolerance=1e-11)
        assert run.outcome.finished, run
        by = run.sensitivities(*(f"{name}_0" for name in STATES))
        names = [f"{name.removesuffix('_speed')}.{'speed' if name.endswith('speed') else 'angle'}" for name in STATES]
        growth = np.array([[by[of, f"{name}_0"][-1] for name in STATES] for of in names])
        found = np.sort_complex(np.log(np.linalg.eigvals(growth).astype(complex)) / duration)
        expected = np.sort_complex(np.array([castering, capsize, weave + 1j * frequency, weave - 1j * frequency]))
        print(found)
        assert found == pytest.approx(expected, rel=1e-8)
