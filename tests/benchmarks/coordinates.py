"""What a right-hand side costs as a mechanism grows, in joint and in absolute coordinates: operations, time, and how they grow."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from benchmarks.ratios import hot, medians, seconds

sys.path.insert(0, str(Path(__file__).parents[1] / "derive"))

BAR = 1.15  # issue 5: the exponent of the cost in absolute coordinates
CALLS = 100  # of a right-hand side, per measurement


def mechanisms() -> dict[str, tuple[tuple[int, ...], Callable[[int], Any]]]:
    """Name -> sizes, and the scene of a size."""
    from kane import chain

    from hertzwerk.derive.scenes.n_four_bar import n_four_bar

    return {
        "plane chain": ((5, 10, 20, 40), lambda n: chain(n, "Z").scene(ledger=False)),
        "spatial chain": ((5, 10, 20), lambda n: chain(n, "ZYX").scene(ledger=False)),
        "N-four-bar": ((2, 10, 40), lambda n: n_four_bar(n).without("energy_ledger")),
    }


def coordinates() -> Iterator[str]:
    """Cost of one right-hand side against N, in the virtual machine; the exponent is the slope of a fit over all N."""
    from hertzwerk.runtime import load

    for name, (sizes, scene) in mechanisms().items():
        for kind in ("tree", "absolute"):
            models = [load(scene(n).with_coordinates(kind)) for n in sizes]
            counts = [
                sum(dict(model.module.OPERATIONS)[part] for part in ("applied", "accelerations")) for model in models
            ]
            times = [time / CALLS for time in medians(*(hot(right_hand_side(model)) for model in models), repeats=5)]
            for what, costs, written in (("operations", counts, str), ("time", times, seconds)):
                exponent = float(np.polyfit(np.log(sizes), np.log(costs), 1)[0])
                verdict = "" if kind == "tree" else "kept" if exponent <= BAR else "MISSED"
                row = ", ".join(f"{n}: {written(cost)}" for n, cost in zip(sizes, costs, strict=True))
                yield f"  {name:<14} {kind:<9} {what:<11} exponent {exponent:5.2f}  {verdict:<6}  by N {row}"


def right_hand_side(model: Any) -> Callable[[], None]:
    """CALLS evaluations of the accelerations at the start, nothing converted in between."""
    t, q, u, c = ca.SX.sym("t"), ca.SX.sym("q", model.nq), ca.SX.sym("u", model.nu), ca.SX.sym("c", model.nc)
    force = model.function("applied")(t, q, u, c)
    function = ca.Function("right_hand_side", [t, q, u, c], [model.function("accelerations")(t, q, u, force, c)[0]])
    bound = model.bind()
    joints = [np.array(x).ravel() for x in model.function("start")(bound.p)]
    start = joints if model.joints is model else model.function("placed")(0.0, *joints, bound.c)
    buffer, evaluate = function.buffer()
    values = [np.zeros(1), *(np.array(x).ravel() for x in start), bound.c.copy(), np.zeros(model.nu)]
    for i, value in enumerate(values[:-1]):
        buffer.set_arg(i, memoryview(value))
    buffer.set_res(0, memoryview(values[-1]))

    def action(kept: object = (buffer, values)) -> None:
        for _ in range(CALLS):
            evaluate()

    return action
