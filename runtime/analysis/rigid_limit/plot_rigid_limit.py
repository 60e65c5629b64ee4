"""Picture of a rigid limit: gaps beside those of compliant runs, energy, convergence of impacts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.analysis.rigid_limit.rigid_run import ROUNDING
from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, legend
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.analysis.rigid_limit.rigid_limit import RigidLimit, StifferRun

POINTS = 2000  # of a curve
NEAR = 0.1  # of a pair's largest gap: it is drawn where it gets as near


def figure(limit: RigidLimit) -> Figure:
    """Draw the gaps of pairs that close, the energy and, with stiffer runs, how impacts converge."""
    times = np.linspace(0, float(limit.t[-1]), POINTS)
    gaps, curves = limit.gaps(times), _curves(limit)
    near = gaps.min(axis=0) < NEAR * gaps.max(axis=0)
    pairs = np.flatnonzero(near if near.any() else ~near).tolist()
    panels = len(pairs) + 1 + bool(curves)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        page = Figure(figsize=(9, 1.0 + 2.1 * panels), layout="constrained")
        axes = page.subplots(panels, 1, squeeze=False)[:, 0]
        time, energy = scale_of("s", times), scale_of("J", limit.energy)
        for j, axis in zip(pairs, axes, strict=False):
            _gap(axis, limit, j, times)
            axis.set_xlabel(f"time [{time.unit}]")
        axes[len(pairs)].plot(time(limit.t), energy(limit.energy), color=VERMILLION)
        axes[len(pairs)].set(title=f"kinetic and potential energy [{energy.unit}]", xlabel=f"time [{time.unit}]")
        if curves:
            _convergence(axes[-1], limit, curves)
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


def _curves(limit: RigidLimit) -> dict[int, list[StifferRun]]:
    """Return by impact the runs that have it at another time than the rigid one, at least two."""
    least, curves = ROUNDING * limit.t[-1], {}
    for i in range(len(limit.impulses)):
        runs = [each for each in limit.stiffer if len(each.apart) > i and abs(each.apart[i]) > least]
        if len(runs) > 1:
            curves[i] = runs
    return curves


def _convergence(axis: Axes, limit: RigidLimit, curves: dict[int, list[StifferRun]]) -> None:
    """Draw the difference of onsets over the factor of the stiffness, of the first impacts."""
    for colour, (i, runs) in zip(CYCLE, curves.items(), strict=False):
        apart = [abs(each.apart[i]) for each in runs]
        axis.loglog([each.factor for each in runs], apart, "o-", color=colour, label=f"impact {i + 1}")
    axis.set(title="onset of impacts less that of the rigid ones [s]", xlabel=f"{limit.stiffness}, times its value")
    legend(axis)
    factors = [each.factor for each in limit.stiffer]
    axis.set_xticks(factors, [f"{factor:g}" for factor in factors], minor=False)
    axis.tick_params(axis="x", which="minor", labelbottom=False)
    axis.margins(y=0.15)
