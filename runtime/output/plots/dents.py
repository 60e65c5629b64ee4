"""Panel of the dents that the impacts of an elastic-plastic contact leave, their depth enlarged."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.output.plots.picture_samples import end_of
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.engine.solution.solution import EngineSolution

DRAWN, SHOWN, MARGIN = 6, 0.08, 1.4  # dents; deepest as shown and half of the width, over the widest


def dents_of(run: EngineSolution, pair: str) -> list[tuple[float, float]]:
    """Depth and half-width [m] of the dents of the first impacts, in their order; none of a saved run."""
    p, dents = run.engine.history.p, []
    if p is None or f"{pair}.dent" not in run:
        return []
    curvature = sum(1 / radius for radius in run.engine.model.radii(p).get(pair, ()))
    for impact in (each for each in run.impacts if each.contact == pair and curvature):
        rows = (run.t >= impact.t) & (run.t <= end_of(impact, run))
        depth = float(np.max(run[f"{pair}.dent"][rows], initial=0))
        if depth > 0:
            dents.append((depth, float(np.sqrt(np.max(run[f"{pair}.deepest"][rows]) / curvature))))
    return list(dict.fromkeys(dents))[:DRAWN]


def draw_dents(axis: Axes, dents: list[tuple[float, float]]) -> None:
    """Draw each dent as a cap, the first one heavy."""
    deepest, widest = (max(of) for of in zip(*dents, strict=True))
    scale = scale_of("m", widest)
    factor = float(f"{SHOWN * 2 * widest / deepest:.2g}")
    for i, (depth, half) in enumerate(dents):
        x = np.linspace(-half, half, 101)
        axis.plot(scale(x), -factor * depth * scale(1 - (x / half) ** 2), color=BLUE, alpha=1 - 0.8 * i / DRAWN)
    axis.axhline(0, color=GREY, linewidth=0.8, zorder=0)
    of_depth, room = scale_of("m", deepest), MARGIN * scale(widest)
    count = f"Dents of {len(dents)} impact{'s' * (len(dents) > 1)}"
    axis.set(
        aspect="equal", xlim=(-room, room), ylim=(-2 * SHOWN * room, SHOWN * room), yticks=[],
        title=f"{count}, depth enlarged {factor:g} times: the deepest {of_depth(deepest):.3g} {of_depth.unit}",
        xlabel=f"distance from the middle [{scale.unit}]; as caps as wide as √(R d) at the largest penetration d",
    )  # fmt: skip
