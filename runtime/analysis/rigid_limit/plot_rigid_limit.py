"""Picture of a rigid limit: gaps beside those of compliant runs, energy, convergence of impacts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, legend
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.analysis.rigid_limit.rigid_limit import RigidLimit

POINTS = 2000  # of a curve


def figure(limit: RigidLimit) -> Figure:
    """Draw the gap of each pair, the energy and, with stiffer runs, how their impacts converge."""
    pairs, convergence = limit.model.pairs, any(len(each.apart) > 1 for each in limit.stiffer)
    panels = len(pairs) + 1 + convergence
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        page = Figure(figsize=(9, 1.0 + 2.1 * panels), layout="constrained")
        axes = page.subplots(panels, 1, squeeze=False)[:, 0]
        times = np.linspace(0, float(limit.t[-1]), POINTS)
        time = scale_of("s", times)
        for j, axis in enumerate(axes[: len(pairs)]):
            _gap(axis, limit, j, times)
            axis.set_xlabel(f"time [{time.unit}]")
        energy = scale_of("J", limit.energy)
        axes[len(pairs)].plot(time(limit.t), energy(limit.energy), color=VERMILLION)
        axes[len(pairs)].set_title(f"kinetic and potential energy [{energy.unit}]")
        axes[len(pairs)].set_xlabel(f"time [{time.unit}]")
        if convergence:
            _convergence(axes[-1], limit)
        heading(page, f"{limit.model.name}: rigid limit")
    return page


def _gap(axis: Axes, limit: RigidLimit, j: int, times: np.ndarray) -> None:
    """Draw the gap of a pair in the rigid limit over those of the compliant runs."""
    pair, rigid = limit.model.pairs[j], limit.gaps(times)[:, j]
    time, gap = scale_of("s", times), scale_of("m", rigid)
    for colour, each in zip(CYCLE, limit.stiffer, strict=False):
        shown = times[times <= each.run.t[-1]]
        axis.plot(
            time(shown),
            gap(each.run.at(shown)[f"{pair}.gap"]),
            color=colour,
            label=f"{limit.stiffness} × {each.factor:g}",
        )
    axis.plot(time(times), gap(rigid), color="black", linestyle="--" if limit.stiffer else "-", label="rigid")
    axis.set_title(plain(f"{pair}: gap [{gap.unit}]"))
    axis.axhline(0, color=GREY, linewidth=0.8)
    if limit.stiffer:
        legend(axis)


def _convergence(axis: Axes, limit: RigidLimit) -> None:
    """Draw the difference of onsets over the factor of the stiffness, of the impacts that all runs have."""
    common = min(len(each.apart) for each in limit.stiffer if len(each.apart) > 1)
    factors = [each.factor for each in limit.stiffer if len(each.apart) >= common]
    for i in range(1, min(common, len(CYCLE) + 1)):
        apart = [abs(each.apart[i]) for each in limit.stiffer if len(each.apart) >= common]
        axis.loglog(factors, apart, "o-", color=CYCLE[i - 1], label=f"impact {i + 1}")
    axis.set_title("onset of impacts less that of the rigid ones [s]")
    axis.set_xlabel(f"{limit.stiffness}, times its value")
    legend(axis)
    axis.set_xticks(factors, [f"{factor:g}" for factor in factors], minor=False)
    axis.tick_params(axis="x", which="minor", labelbottom=False)
    axis.margins(y=0.15)
