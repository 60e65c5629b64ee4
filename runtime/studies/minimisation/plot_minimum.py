"""Picture of a minimisation: the objective and the values of all its runs, one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import matplotlib.ticker
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, labelled, legend
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, ORANGE, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.minimisation.minimum import Minimum


def figure(minimum: Minimum) -> Figure:
    """Draw the objective of every run, the least marked, and below each quantity that was varied."""
    trials, unit = minimum.trials, minimum.unit
    names = {name: unit for name, (_, unit) in minimum.values.items()}
    numbers, feasible = np.arange(1, len(trials) + 1), np.array([trial.feasible for trial in trials], dtype=bool)
    objective = np.array([trial.objective for trial in trials])
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        page = Figure(figsize=(9, 3.2 + 2.2 * len(names)), layout="constrained")
        axes = page.subplots(1 + len(names), 1, sharex=True, squeeze=False, height_ratios=(1.5, *[1.0] * len(names)))[
            :, 0
        ]
        scale = scale_of(unit or "1", objective[np.isfinite(objective)])
        for there, colour, label in ((feasible, BLUE, "constraints kept"), (~feasible, ORANGE, "constraints not kept")):
            if np.any(there):
                axes[0].plot(numbers[there], scale(objective[there]), "o", color=colour, markersize=5, label=label)
        axes[0].axhline(float(scale(minimum.objective)), color=VERMILLION, linewidth=1.2, label="minimum")
        axes[0].set_title(labelled("objective", scale))
        if np.all(objective > 0) and np.ptp(np.log10(objective)) > 1:
            axes[0].set_yscale("log")
        legend(axes[0])
        for axis, (name, own) in zip(axes[1:], names.items(), strict=True):
            values = np.array([trial.values[name] for trial in trials])
            scale = scale_of(own or "1", values)
            axis.plot(numbers, scale(values), "-o", color=GREY, linewidth=0.9, markersize=4, markerfacecolor=BLUE)
            axis.set_title(plain(labelled(name, scale)))
        axes[-1].set_xlabel("run")
        axes[-1].xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
        heading(page, f"{minimum.scene}: {minimum.objective_text}")
    return page
